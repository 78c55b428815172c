//! Cover with regrasping: the hand reaches what is far from targets, and the middle of
//! them.

use super::controllers::{controller, parameters, sample_pick, sample_place};
use super::world::{Block, Rules, Target, targets};
use super::{Action, BLOCK_TYPE, Family, TARGET_TYPE, TYPES, predicates};
use crate::task::{
    Controller, ControllerId, Environment, Failure, LiftedAtom, ObjectId, ObjectType, Operator,
    OperatorId, Parameters, Predicate, PredicateId, State,
};
use rand_core::Rng;

/// The environment `cover_regrasp`. See the [module](super).
///
/// In many tasks a block is held at its end in the beginning. Most of these it must
/// put down and grasp again, or put over the target from outside of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CoverRegrasp;

impl CoverRegrasp {
    /// `Clear(target)`: no block covers the target.
    pub const CLEAR: PredicateId = PredicateId(0);

    /// `Pick(block; p)`: picks the block by a click at `p`.
    pub const PICK: ControllerId = ControllerId(0);
    /// `Place(block, target; p)`: puts the block over the target by a click at `p`.
    pub const PLACE: ControllerId = ControllerId(1);
    /// `PlaceOnTable(block; p)`: puts the block anywhere by a click at `p`.
    pub const PLACE_ON_TABLE: ControllerId = ControllerId(2);
}

/// The hand reaches a point that is at least the width of every target away from its
/// ends, or within the middle third of one. As the targets of all tasks lie far apart,
/// this is the union of intervals that the framework walks over from left to right.
static RULES: Rules = Rules {
    reaches: |state, p| {
        let fits = |target: Target| {
            let (left, right) = target.extent().into_inner();
            let third = target.width / 3.0;
            let is_far = p <= left - target.width || right + target.width <= p;
            is_far || (left + third..=right - third).contains(&p)
        };
        (0.0..=1.0).contains(&p) && targets(state).all(fits)
    },
    supports: |_, _| true,
};

const IS_CLEAR: LiftedAtom<'static> = LiftedAtom::new(CoverRegrasp::CLEAR, &[1]);

impl Family for CoverRegrasp {
    const COVERS: PredicateId = PredicateId(1);
    const HAND_EMPTY: PredicateId = PredicateId(2);
    const HOLDING: PredicateId = PredicateId(3);
    const IS_BLOCK: PredicateId = PredicateId(4);
    const IS_TARGET: PredicateId = PredicateId(5);
}

impl Environment for CoverRegrasp {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &[
        predicates::clear(),
        predicates::covers(),
        predicates::hand_empty(),
        predicates::holding(),
        predicates::is_block(),
        predicates::is_target(),
    ];
    const CONTROLLERS: &'static [Controller<Self>] = &[
        controller("Pick", &[BLOCK_TYPE]),
        controller("Place", &[BLOCK_TYPE, TARGET_TYPE]),
        controller("PlaceOnTable", &[BLOCK_TYPE]),
    ];
    const OPERATORS: &'static [Operator<'static>] = &[
        Self::PICK_BLOCK,
        Operator {
            name: "Place",
            parameters: &[BLOCK_TYPE, TARGET_TYPE],
            preconditions: &[Self::A_BLOCK, Self::A_TARGET, Self::HELD, IS_CLEAR],
            add_effects: &[Self::NOTHING_HELD, Self::COVERED],
            delete_effects: &[Self::HELD, IS_CLEAR],
            controller: Self::PLACE,
            controller_arguments: &[0, 1],
        },
        Operator {
            name: "PlaceOnTable",
            parameters: &[BLOCK_TYPE],
            preconditions: &[Self::A_BLOCK, Self::HELD],
            add_effects: &[Self::NOTHING_HELD],
            delete_effects: &[Self::HELD],
            controller: Self::PLACE_ON_TABLE,
            controller_arguments: &[0],
        },
    ];

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        RULES.click(state, f64::from(action))
    }

    /// Picks a block anywhere; clicks within the fifth about the centre of a target,
    /// although the hand reaches more; and puts a block on the table where the hand
    /// was when it was picked, so that it does not move.
    fn sample<G: Rng>(
        &self,
        operator: OperatorId,
        state: &State,
        objects: &[ObjectId],
        rng: &mut G,
    ) -> Parameters {
        let draw = |controller, block: Block, target: Option<Target>| match controller {
            Self::PICK => Some(sample_pick(&block, rng)),
            Self::PLACE => Some(sample_place(&target?, rng)),
            Self::PLACE_ON_TABLE => Some(block.pose + block.grasp),
            _ => None,
        };
        parameters::<Self>(operator, state, objects, draw)
    }
}
