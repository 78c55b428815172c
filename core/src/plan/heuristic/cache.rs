//! Estimates that were computed already.

use super::Estimate;
use crate::task::AtomSet;

/// A place for one estimate.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cached<const N: usize = 2>(Option<(AtomSet<N>, Estimate)>);

/// Each abstract state has one place, which it shares with others; the last one
/// stays. Different sequences of operators often lead to one abstract state.
#[derive(Debug)]
pub(super) struct Cache<'m, const N: usize> {
    places: &'m mut [Cached<N>],
}

impl<'m, const N: usize> Cache<'m, N> {
    pub(super) fn new(places: &'m mut [Cached<N>]) -> Self {
        places.fill(Cached::default());
        Cache { places }
    }

    pub(super) fn get(&self, state: AtomSet<N>) -> Option<Estimate> {
        let Cached(held) = self.places.get(self.place(state))?;
        held.filter(|(key, _)| *key == state)
            .map(|(_, estimate)| estimate)
    }

    pub(super) fn put(&mut self, state: AtomSet<N>, estimate: Estimate) {
        let place = self.place(state);
        if let Some(cached) = self.places.get_mut(place) {
            *cached = Cached(Some((state, estimate)));
        }
    }

    /// The hash, scaled to the table.
    fn place(&self, state: AtomSet<N>) -> usize {
        let count = self.places.len() as u64 & 0xFFFF_FFFF;
        (u64::from(state.hash()).wrapping_mul(count) >> 32) as usize
    }
}
