//! What the predicates and operators of all environments of the family have in common.

use super::{Action, BLOCK_TYPE};
use crate::task::{ControllerId, Environment, LiftedAtom, Operator, PredicateId};

/// An environment of the family: it says where the predicates are that all have.
///
/// Parameter 0 of every operator is a block, parameter 1 a target, if there is one.
pub trait Family: Environment<Action = Action> {
    /// `Covers(block, target)`: the block lies over all of the target.
    const COVERS: PredicateId;
    /// `HandEmpty()`: no block is held.
    const HAND_EMPTY: PredicateId;
    /// `Holding(block)`: the block is held.
    const HOLDING: PredicateId;
    /// `IsBlock(block)`: always.
    const IS_BLOCK: PredicateId;
    /// `IsTarget(target)`: always.
    const IS_TARGET: PredicateId;

    /// That the block lies over the target.
    const COVERED: LiftedAtom<'static> = LiftedAtom::new(Self::COVERS, &[0, 1]);
    /// That no block is held.
    const NOTHING_HELD: LiftedAtom<'static> = LiftedAtom::new(Self::HAND_EMPTY, &[]);
    /// That the block is held.
    const HELD: LiftedAtom<'static> = LiftedAtom::new(Self::HOLDING, &[0]);
    /// That the block is one.
    const A_BLOCK: LiftedAtom<'static> = LiftedAtom::new(Self::IS_BLOCK, &[0]);
    /// That the target is one.
    const A_TARGET: LiftedAtom<'static> = LiftedAtom::new(Self::IS_TARGET, &[1]);

    /// The operator `Pick(block)` of those that have it; its controller is their first.
    const PICK_BLOCK: Operator<'static> = Operator {
        name: "Pick",
        parameters: &[BLOCK_TYPE],
        preconditions: &[Self::A_BLOCK, Self::NOTHING_HELD],
        add_effects: &[Self::HELD],
        delete_effects: &[Self::NOTHING_HELD],
        controller: ControllerId(0),
        controller_arguments: &[0],
    };
}
