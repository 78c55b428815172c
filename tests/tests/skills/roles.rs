//! Who fills the roles of a domain text, and what controllers are seen to change.

use critreg::Error;
use critreg::domain::{Attribute, Dimension, Domain};
use critreg::skill::{Changes, Context, Describe, Description, RoleBinding};
use critreg::task::{
    Controller, Environment, Failure, Naming, ObjectId, ObjectType, Operator, Predicate,
    PredicateId, State, TypeId,
};

/// A world in which nothing happens.
struct Still;

impl Environment for Still {
    type Action = ();

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &[Predicate {
        name: "Odd",
        arguments: &[BLOCK],
        classifier: |_, state, objects| state.get(objects[0]).is_some_and(|[w, _]| w % 2.0 == 1.0),
    }];
    const CONTROLLERS: &'static [Controller<Self>] = &[];
    const OPERATORS: &'static [Operator<'static>] = &[];

    fn simulate(&self, _: &mut State, (): ()) -> Result<(), Failure> {
        Ok(())
    }
}

impl Describe for Still {
    const DESCRIPTIONS: &'static [Description] = &[];
}

fn context<'s>(state: &'s State, own: &'s [ObjectId], later: &'s [ObjectId]) -> Context<'s, Still> {
    Context {
        environment: &Still,
        state,
        objects: own,
        later_objects: later,
        members: &[],
    }
}

const X: Attribute<'static> = Attribute::new("x", Dimension::Length);
const W: Attribute<'static> = Attribute::new("w", Dimension::Length);
const TYPES: [ObjectType; 4] = [
    ObjectType {
        name: "hand",
        attributes: &[X],
        naming: Naming::Single("hand"),
    },
    ObjectType {
        name: "block",
        attributes: &[W, X],
        naming: Naming::Numbered("block"),
    },
    ObjectType {
        name: "table",
        attributes: &[X],
        naming: Naming::Single("table"),
    },
    ObjectType {
        name: "peg",
        attributes: &[X, W],
        naming: Naming::Numbered("peg"),
    },
];
const HAND: TypeId = TypeId(0);
const BLOCK: TypeId = TypeId(1);
const TABLE: TypeId = TypeId(2);
const PEG: TypeId = TypeId(3);

/// A state of one hand, so many blocks and pegs, and a table. Numbers tell the objects.
fn blocks(blocks: u8, pegs: u8) -> State {
    let mut state = State::new();
    state.add(&TYPES, HAND, &[1.0]).unwrap();
    for block in 0..blocks {
        let number = f64::from(block);
        state
            .add(&TYPES, BLOCK, &[10.0 + number, 20.0 + number])
            .unwrap();
    }
    for peg in 0..pegs {
        let number = f64::from(peg);
        state
            .add(&TYPES, PEG, &[30.0 + number, 40.0 + number])
            .unwrap();
    }
    state.add(&TYPES, TABLE, &[50.0]).unwrap();
    state
}

#[test]
fn roles_are_filled_by_their_names() {
    let x = "{ x: length }";
    let domain = format!(
        "object block2 {x} object later_block {x} object block {{ x: length, w: length }}
         object hand {x} object table {x} object peg[3] {x} object later_block2 {x}"
    );
    let domain = Domain::parse(&domain).unwrap();
    let own = [HAND, BLOCK, BLOCK];
    let later = [BLOCK, BLOCK, HAND];
    let binding = RoleBinding::new(&domain, &TYPES, &own, &later).unwrap();
    assert_eq!(binding.len(), domain.instance_len());
    let mut out = vec![0.0; binding.len()];
    let objects = |ids: [u8; 3]| ids.map(ObjectId);
    let state = blocks(4, 2);
    let (own, later) = (objects([0, 2, 4]), objects([3, 1, 0]));
    let context = context(&state, &own, &later);
    binding.instance(&context, &mut out).unwrap();
    let expected = [
        23.0,
        22.0,
        21.0,
        11.0,
        1.0,
        50.0,
        30.0,
        31.0,
        f64::NAN,
        20.0,
    ];
    let bits = |numbers: &[f64]| numbers.iter().map(|n| n.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&out), bits(&expected));
}

#[test]
fn a_later_object_fills_a_role_that_the_first_action_has_not() {
    let domain = Domain::parse("object peg { w: length } object block { x: length }").unwrap();
    let binding = RoleBinding::new(&domain, &TYPES, &[BLOCK], &[BLOCK, PEG]).unwrap();
    let (mut out, state) = ([0.0; 2], blocks(2, 2));
    let [first, second] = [1, 2].map(ObjectId);
    let (own, later) = ([second], [first, ObjectId(4)]);
    let context = context(&state, &own, &later);
    binding.instance(&context, &mut out).unwrap();
    assert_eq!(out, [41.0, 21.0]);
}

#[test]
fn what_is_no_role_is_refused() {
    let read = |text: &str| {
        let domain = Domain::parse(text).unwrap();
        RoleBinding::new(&domain, &TYPES, &[BLOCK], &[])
    };
    for text in [
        "object wall { x: length }",
        "object block { y: length }",
        "object block { x: angle }",
        "object block0 { x: length }",
    ] {
        assert!(matches!(read(text), Err(Error::Mismatch(_))), "{text}");
    }
    // One peg is the only one; two are too many, none too few.
    let binding = read("object peg { x: length }").unwrap();
    let filled = [0, 1, 2].map(|pegs| {
        let state = blocks(1, pegs);
        let own = [ObjectId(1)];
        let context = context(&state, &own, &[]);
        binding.instance(&context, &mut [0.0]).is_ok()
    });
    assert_eq!(filled, [false, true, false]);
}

#[test]
fn changes_are_those_that_were_seen() {
    let (before, hand) = (blocks(2, 1), ObjectId(0));
    let mut after = before.clone();
    after.attributes_mut(hand).unwrap()[0] = 5.0;
    after.attributes_mut(ObjectId(2)).unwrap()[1] = 5.0;
    after.attributes_mut(ObjectId(3)).unwrap()[0] = 5.0;
    let mut changes = Changes::default();
    let affected = |changes: &Changes, objects: &[ObjectId]| {
        let all = [
            (0, 0),
            (1, 0),
            (1, 1),
            (2, 0),
            (2, 1),
            (3, 0),
            (3, 1),
            (4, 0),
        ];
        all.map(|(object, attribute)| changes.affect(objects, &before, ObjectId(object), attribute))
    };
    assert_eq!(affected(&changes, &[hand]), [true; 8], "never seen");
    changes.observe(&[hand, ObjectId(2)], &before, &after);
    let (no, yes) = (false, true);
    // The hand, the second attribute of the own block, the first of all pegs.
    assert_eq!(
        affected(&changes, &[hand, ObjectId(2)]),
        [yes, no, no, no, yes, yes, no, no]
    );
    assert_eq!(
        affected(&changes, &[hand, ObjectId(1)]),
        [yes, no, yes, no, no, yes, no, no]
    );
}

#[test]
fn others_are_none_of_the_controllers() {
    let read = |text: &str| {
        let domain = Domain::parse(text).unwrap();
        RoleBinding::new(&domain, &TYPES, &[BLOCK], &[BLOCK]).unwrap()
    };
    let (own, later) = ([ObjectId(1)], [ObjectId(3)]);
    let single = read("object other_block { w: length }");
    let several = read("object other_block[3] { w: length }");
    let mut numbers = [0.0; 3];
    let state = blocks(3, 0);
    single
        .instance(&context(&state, &own, &later), &mut numbers[..1])
        .unwrap();
    assert_eq!(numbers[0], 11.0);
    let state = blocks(4, 0);
    let refused = single.instance(&context(&state, &own, &later), &mut numbers[..1]);
    assert!(matches!(refused, Err(Error::Mismatch(_))), "there are two");
    several
        .instance(&context(&state, &own, &later), &mut numbers)
        .unwrap();
    assert_eq!(numbers[..2], [11.0, 13.0]);
    assert!(numbers[2].is_nan());
}

#[test]
fn predicates_narrow_groups() {
    let domain = Domain::parse("object block[4] { w: length } object other_block[4] { w: length }");
    let binding = RoleBinding::new(&domain.unwrap(), &TYPES, &[BLOCK], &[]).unwrap();
    let state = blocks(4, 0);
    let among = [PredicateId(0)];
    let context = Context {
        members: &among,
        ..context(&state, &[ObjectId(2)], &[])
    };
    let mut numbers = [0.0; 8];
    binding.instance(&context, &mut numbers).unwrap();
    assert_eq!(numbers[..2], [11.0, 13.0]);
    // The object of the controller is odd itself.
    assert_eq!(numbers[4..5], [13.0]);
    assert!(numbers[2].is_nan() && numbers[5].is_nan());
}
