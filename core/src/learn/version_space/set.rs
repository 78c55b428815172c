//! Sets of samples, a bit each.

use super::forms::Set;

pub(super) fn is_empty(set: &Set) -> bool {
    set.iter().all(|word| *word == 0)
}

pub(super) fn count(set: &Set) -> usize {
    set.iter().map(|word| word.count_ones() as usize).sum()
}

pub(super) fn remove(from: &mut Set, what: &Set) {
    for (word, other) in from.iter_mut().zip(what) {
        *word &= !other;
    }
}

pub(super) fn intersect(set: &mut Set, with: &Set) {
    for (word, other) in set.iter_mut().zip(with) {
        *word &= other;
    }
}

pub(super) fn unite(set: &mut Set, with: &Set) {
    for (word, other) in set.iter_mut().zip(with) {
        *word |= other;
    }
}

pub(super) fn insert(set: &mut Set, sample: usize) {
    if let Some(word) = set.get_mut(sample / 64) {
        *word |= 1 << (sample % 64);
    }
}

/// The members of a set, ascending.
pub(super) fn members(set: &Set) -> impl Iterator<Item = usize> + '_ {
    set.iter().enumerate().flat_map(|(index, word)| {
        let mut left = *word;
        core::iter::from_fn(move || {
            let next = left.trailing_zeros();
            left &= left.wrapping_sub(1);
            (next < u64::BITS).then_some(64 * index + next as usize)
        })
    })
}
