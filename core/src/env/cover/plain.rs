//! Cover: the hand reaches blocks and the centres of targets.

use super::controllers::{controller, parameters, sample_pick, sample_place};
use super::world::{Block, Rules, Target, around, blocks, targets};
use super::{Action, BLOCK_TYPE, Family, TARGET_TYPE, TYPES, predicates};
use crate::task::{
    Controller, ControllerId, Environment, Failure, ObjectId, ObjectType, Operator, OperatorId,
    Parameters, Predicate, PredicateId, State,
};
use rand_core::Rng;

/// The environment `cover`. See the [module](super).
///
/// Nothing says whether a target is free: to put a block over a target where another
/// one lies, or which the other one needs, is a plan that cannot be refined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cover;

impl Cover {
    /// `Pick(block; p)`: picks the block by a click at `p`.
    pub const PICK: ControllerId = ControllerId(0);
    /// `Place(block, target; p)`: puts the block over the target by a click at `p`.
    pub const PLACE: ControllerId = ControllerId(1);
}

static RULES: Rules = Rules {
    reaches: |state, p| {
        let on_block = |block: Block| block.extent().contains(&p);
        let on_target = |target: Target| around(target.pose, target.width / 10.0).contains(&p);
        blocks(state).any(on_block) || targets(state).any(on_target)
    },
    supports: |state, p| targets(state).any(|target| target.extent().contains(&p)),
};

impl Family for Cover {
    const COVERS: PredicateId = PredicateId(0);
    const HAND_EMPTY: PredicateId = PredicateId(1);
    const HOLDING: PredicateId = PredicateId(2);
    const IS_BLOCK: PredicateId = PredicateId(3);
    const IS_TARGET: PredicateId = PredicateId(4);
}

impl Environment for Cover {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &[
        predicates::covers(),
        predicates::hand_empty(),
        predicates::holding(),
        predicates::is_block(),
        predicates::is_target(),
    ];
    const CONTROLLERS: &'static [Controller<Self>] = &[
        controller("Pick", &[BLOCK_TYPE]),
        controller("Place", &[BLOCK_TYPE, TARGET_TYPE]),
    ];
    const OPERATORS: &'static [Operator<'static>] = &[
        Self::PICK_BLOCK,
        Operator {
            name: "Place",
            parameters: &[BLOCK_TYPE, TARGET_TYPE],
            preconditions: &[Self::A_BLOCK, Self::A_TARGET, Self::HELD],
            add_effects: &[Self::NOTHING_HELD, Self::COVERED],
            delete_effects: &[Self::HELD],
            controller: Self::PLACE,
            controller_arguments: &[0, 1],
        },
    ];

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        RULES.click(state, f64::from(action))
    }

    /// Picks a block anywhere; clicks within the fifth about the centre of a target.
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
            _ => None,
        };
        parameters::<Self>(operator, state, objects, draw)
    }
}
