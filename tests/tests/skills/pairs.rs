//! Pairs of controllers that need no text: it follows from the texts of the two, in which
//! roles of the same name are the same object.

use critreg::Error;
use critreg::domain::{Domain, MAX_OBJECTS};
use critreg::env::blocks::{BLOCK_TYPE, Blocks, PICK, PUT_ON_TABLE, ROBOT_TYPE};
use critreg::env::stick_button::{
    BUTTON_TYPE, PICK_STICK, ROBOT_TYPE as STICK_ROBOT, STICK_TYPE, StickButton,
};
use critreg::plan::{Advice, Guide, Skeleton};
use critreg::random::generator;
use critreg::region::Region;
use critreg::skill::{
    Changes, Describe, Description, Later, RegionGuide, Setting, Skill, Skills, write_pair,
};
use critreg::task::{Environment, GroundOperator, ObjectId};
use critreg_tests::plan::Grounding;

fn pair(first: &str, second: &str) -> Result<String, Error> {
    let (first, second) = (
        Domain::parse(first).unwrap(),
        Domain::parse(second).unwrap(),
    );
    let mut text = String::new();
    write_pair(&first, Later::Text(&second), &mut text)?;
    Domain::parse(&text).unwrap();
    Ok(text)
}

#[test]
fn what_moves_with_the_later_parameters_is_left_out() {
    let text = pair(
        "type box { x: length, y: length }  # a comment
         object box, other_box[2]: box
         constant size = 0.5 + 0.5: length
         parameter grip in [0, size]: length
         point tips = box + (grip, 0) # the fingers
         shape tips = circle(0.1)",
        "object box { width: length, x: length }
         object other_box[3] { x: length, y: length }
         constant size = 1.0: length
         constant gap = 0.25: length
         parameter along in [0, 1]
         point spot = world + (along * size, 0)
         point tips = world + (box.x, 0)
         point edge = spot + (gap, 0)
         shape spot = circle(0.1)
         shape other_box = rectangle(gap, 0.1) centred
         point rim = world + (box.width, 0)",
    );
    assert_eq!(
        text.unwrap(),
        "constant size = 1: length\n\
         constant gap = 0.25: length\n\
         object box { x: length, y: length, width: length }\n\
         object other_box[3] { x: length, y: length }\n\
         parameter grip in [0, 1]: length\n\
         point tips = box + (grip, 0)\n\
         shape tips = circle(0.1)\n\
         shape other_box = rectangle(gap, 0.1) centred\n\
         point rim = world + (box.width, 0)\n"
    );
}

#[test]
fn texts_that_contradict_each_other_are_refused() {
    let length = "object box { x: length } constant size = 1.0: length";
    for other in [
        "object box { x: length } constant size = 2.0: length",
        "object box { x: length } constant size = 1.0: none",
        "object box { x: angle }",
    ] {
        assert!(
            matches!(pair(length, other), Err(Error::Mismatch(_))),
            "{other}"
        );
    }
    let domain = Domain::parse(length).unwrap();
    let mut room = [0; 10];
    let mut out = critreg::text::TextBuffer::new(&mut room);
    // It counts on, so that one can ask how long the text is.
    write_pair(&domain, Later::Text(&domain), &mut out).unwrap();
    assert_eq!(out.as_str(), None);
    assert!(out.needed() > MAX_OBJECTS);
}

#[test]
fn a_later_controller_without_a_text_is_described_by_its_objects() {
    let pick = StickButton::DESCRIPTIONS[0];
    assert_eq!((pick.controller, pick.later), (PICK_STICK, None));
    let domain = Domain::parse(pick.text).unwrap();
    let mut text = String::new();
    let objects = [STICK_ROBOT, STICK_TYPE, BUTTON_TYPE, BUTTON_TYPE];
    write_pair(
        &domain,
        Later::Objects(StickButton::TYPES, &objects),
        &mut text,
    )
    .unwrap();
    assert!(text.contains("\nobject button { x: length, y: length, pressed: flag }\n"));
    assert!(text.contains("\nobject button2 { x: length, y: length, pressed: flag }\n"));
    let derived = Domain::parse(&text).unwrap();
    assert_eq!(derived.objects().len(), domain.objects().len() + 2);
    assert_eq!(derived.constants(), domain.constants());
    assert_eq!(derived.parameters(), domain.parameters());
}

/// A block that is put down is never picked again, says a region that is always empty: it says
/// so of the same block, and nothing of another one.
#[test]
fn nothing_is_said_of_other_objects() {
    let description = Description {
        controller: PUT_ON_TABLE,
        later: Some(PICK),
        members: &[],
        text: "object block { x: length } parameter u in [0, 1]",
    };
    let task = Blocks.task(3..=3, &mut generator(5)).unwrap();
    let grounding = Grounding::new(&Blocks, &task).unwrap();
    let own = Blocks.signature(PUT_ON_TABLE).unwrap();
    let later = Some(Blocks.signature(PICK).unwrap());
    let mut skill = Skill::of_same_objects(&description, Blocks::TYPES, own, later).unwrap();
    let mut loose = Skill::new(&description, Blocks::TYPES, own, later).unwrap();
    for skill in [&mut skill, &mut loose] {
        let never = Region::parse(skill.domain(), "u >= 2").unwrap();
        skill.set_region(Some(never));
    }
    let blocks: Vec<ObjectId> = task.initial.of_type(BLOCK_TYPE).collect();
    let robot = task.initial.of_type(ROBOT_TYPE).next().unwrap();
    let place = |name: &str, block: ObjectId| {
        let is_it = |ground: &GroundOperator| {
            let operator = Blocks.operator(ground).unwrap();
            operator.name == name && ground.objects.as_slice() == [block, robot]
        };
        grounding.operators.iter().position(is_it).unwrap() as u16
    };
    let judge = |skill: Skill, later: ObjectId| {
        let (mut skills, mut changes) = ([Some(skill)], [Changes::default(); 3]);
        let skills = Skills::resume(&mut skills, &mut changes);
        let mut guide = RegionGuide::new(&Blocks, &skills, &task.initial);
        let places = [
            place("PutOnTable", blocks[0]),
            place("PickFromTable", later),
        ];
        guide.judge(Skeleton::new(&grounding.operators, &places))
    };
    assert!(matches!(
        judge(skill.clone(), blocks[0]),
        Advice::Postpone(_)
    ));
    assert_eq!(judge(skill, blocks[1]), Advice::Keep);
    assert!(matches!(judge(loose, blocks[1]), Advice::Postpone(_)));
}
