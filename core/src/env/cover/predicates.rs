//! The predicates that several of the environments have. What they mean stands where their
//! places are told: in [`Family`](super::Family), and for `Clear` in the environments.

use super::world::{Block, Target, blocks};
use super::{BLOCK_TYPE, TARGET_TYPE};
use crate::task::{ObjectId, Predicate, State};

pub(super) const fn clear<E>() -> Predicate<E> {
    Predicate {
        name: "Clear",
        arguments: &[TARGET_TYPE],
        classifier: |_, state, objects| is_clear(state, objects).unwrap_or(false),
    }
}

pub(super) const fn covers<E>() -> Predicate<E> {
    Predicate {
        name: "Covers",
        arguments: &[BLOCK_TYPE, TARGET_TYPE],
        classifier: |_, state, objects| is_covered(state, objects).unwrap_or(false),
    }
}

pub(super) const fn hand_empty<E>() -> Predicate<E> {
    Predicate {
        name: "HandEmpty",
        arguments: &[],
        classifier: |_, state, _| !blocks(state).any(|block| block.is_held()),
    }
}

pub(super) const fn holding<E>() -> Predicate<E> {
    Predicate {
        name: "Holding",
        arguments: &[BLOCK_TYPE],
        classifier: |_, state, objects| block(state, objects).is_some_and(|b| b.is_held()),
    }
}

pub(super) const fn is_block<E>() -> Predicate<E> {
    Predicate {
        name: "IsBlock",
        arguments: &[BLOCK_TYPE],
        classifier: |_, _, _| true,
    }
}

pub(super) const fn is_target<E>() -> Predicate<E> {
    Predicate {
        name: "IsTarget",
        arguments: &[TARGET_TYPE],
        classifier: |_, _, _| true,
    }
}

/// The block that a predicate is about.
pub(super) fn block(state: &State, objects: &[ObjectId]) -> Option<Block> {
    Block::read(state, *objects.first()?)
}

fn is_clear(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let target = Target::read(state, *objects.first()?)?;
    Some(!blocks(state).any(|block| block.covers(&target)))
}

fn is_covered(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let [block, target] = objects else {
        return None;
    };
    let target = Target::read(state, *target)?;
    Some(Block::read(state, *block)?.covers(&target))
}
