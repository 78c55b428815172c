//! Estimates that were computed already.

use super::Estimate;
use crate::task::AtomSet;

/// A place for one estimate.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cached(Option<(AtomSet, Estimate)>);

/// Each abstract state has one place, which it shares with others; the last one
/// stays. Different sequences of operators often lead to one abstract state.
#[derive(Debug)]
pub(super) struct Cache<'m> {
    places: &'m mut [Cached],
}

impl<'m> Cache<'m> {
    pub(super) fn new(places: &'m mut [Cached]) -> Self {
        places.fill(Cached::default());
        Cache { places }
    }

    pub(super) fn get(&self, state: AtomSet) -> Option<Estimate> {
        let Cached(held) = self.places.get(self.place(state))?;
        held.filter(|(key, _)| *key == state)
            .map(|(_, estimate)| estimate)
    }

    pub(super) fn put(&mut self, state: AtomSet, estimate: Estimate) {
        let place = self.place(state);
        if let Some(cached) = self.places.get_mut(place) {
            *cached = Cached(Some((state, estimate)));
        }
    }

    /// Multiplicative hashing (Knuth), its upper half scaled to the table.
    fn place(&self, state: AtomSet) -> usize {
        const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;
        let (low, high) = (state.bits() as u64, (state.bits() >> 64) as u64);
        let mixed = (low ^ high.wrapping_mul(GOLDEN)).wrapping_mul(GOLDEN) >> 32;
        let count = self.places.len() as u64 & 0xFFFF_FFFF;
        (mixed.wrapping_mul(count) >> 32) as usize
    }
}
