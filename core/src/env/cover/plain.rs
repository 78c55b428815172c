//! Cover: the hand reaches blocks and the centres of targets.

use super::controllers::{controller, parameters, sample_pick, sample_place};
use super::world::{Block, Rules, Target, around, blocks, targets};
use super::{Action, BLOCK_TYPE, TARGET_TYPE, TYPES, predicates};
use crate::task::{
    Controller, ControllerId, Environment, Failure, LiftedAtom, ObjectId, ObjectType, Operator,
    OperatorId, Parameters, Predicate, PredicateId, State,
};
use rand_core::Rng;

/// The environment `cover`. See the [module](super).
///
/// Nothing says whether a target is free: to put a block over a target where another
/// one lies, or which the other one needs, is a plan that cannot be refined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cover;

impl Cover {
    /// `Covers(block, target)`: the block lies over all of the target.
    pub const COVERS: PredicateId = PredicateId(0);
    /// `HandEmpty()`: no block is held.
    pub const HAND_EMPTY: PredicateId = PredicateId(1);
    /// `Holding(block)`: the block is held.
    pub const HOLDING: PredicateId = PredicateId(2);
    /// `IsBlock(block)`: always.
    pub const IS_BLOCK: PredicateId = PredicateId(3);
    /// `IsTarget(target)`: always.
    pub const IS_TARGET: PredicateId = PredicateId(4);

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

static PREDICATES: [Predicate<Cover>; 5] = [
    predicates::covers(),
    predicates::hand_empty(),
    predicates::holding(),
    predicates::is_block(),
    predicates::is_target(),
];

static CONTROLLERS: [Controller<Cover>; 2] = [
    controller("Pick", &[BLOCK_TYPE]),
    controller("Place", &[BLOCK_TYPE, TARGET_TYPE]),
];

const IS_BLOCK: LiftedAtom<'static> = LiftedAtom::new(Cover::IS_BLOCK, &[0]);
const IS_HELD: LiftedAtom<'static> = LiftedAtom::new(Cover::HOLDING, &[0]);
const HAND_IS_EMPTY: LiftedAtom<'static> = LiftedAtom::new(Cover::HAND_EMPTY, &[]);

static OPERATORS: [Operator<'static>; 2] = [
    Operator {
        name: "Pick",
        parameters: &[BLOCK_TYPE],
        preconditions: &[IS_BLOCK, HAND_IS_EMPTY],
        add_effects: &[IS_HELD],
        delete_effects: &[HAND_IS_EMPTY],
        controller: Cover::PICK,
        controller_arguments: &[0],
    },
    Operator {
        name: "Place",
        parameters: &[BLOCK_TYPE, TARGET_TYPE],
        preconditions: &[IS_BLOCK, LiftedAtom::new(Cover::IS_TARGET, &[1]), IS_HELD],
        add_effects: &[HAND_IS_EMPTY, LiftedAtom::new(Cover::COVERS, &[0, 1])],
        delete_effects: &[IS_HELD],
        controller: Cover::PLACE,
        controller_arguments: &[0, 1],
    },
];

impl Environment for Cover {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES;
    const PREDICATES: &'static [Predicate<Self>] = &PREDICATES;
    const CONTROLLERS: &'static [Controller<Self>] = &CONTROLLERS;
    const OPERATORS: &'static [Operator<'static>] = &OPERATORS;

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
        let block = || Block::read(state, *objects.first()?);
        let target = || Target::read(state, *objects.get(1)?);
        let operator = OPERATORS.get(usize::from(operator.0));
        parameters(operator.and_then(|operator| match operator.controller {
            Self::PICK => Some(sample_pick(&block()?, rng)),
            Self::PLACE => Some(sample_place(&target()?, rng)),
            _ => None,
        }))
    }
}
