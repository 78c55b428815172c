//! Which abstract states were extended already.

/// For each abstract state the first of the nodes that have it and were extended, in a
/// table of hashes that is lent. Where it has no place left, or none at all, states are not
/// recognised.
#[derive(Debug)]
pub(super) struct Visited<'m> {
    /// Numbers of nodes, from one; zero is free.
    places: &'m mut [u32],
}

/// What is known of a state.
pub(super) enum Visit<'v> {
    /// Here it would be noted.
    New(&'v mut u32),
    /// This node was the first.
    Known(&'v mut u32),
    /// There is no place.
    Full,
}

impl<'m> Visited<'m> {
    /// A table that is to be cleared before it is used.
    pub(super) fn new(places: &'m mut [u32]) -> Self {
        Visited { places }
    }

    pub(super) fn clear(&mut self) {
        self.places.fill(0);
    }

    /// Looks a state up by its hash; `same` says whether a node has it.
    pub(super) fn find(&mut self, hash: u32, same: impl Fn(u32) -> bool) -> Visit<'_> {
        // More than this many others in one place are rare, unless the table is full.
        const PROBES: usize = 64;
        let count = self.places.len();
        // The hash is scaled to the table.
        let first = (u64::from(hash).wrapping_mul(count as u64) >> 32) as usize;
        let around = (first..count).chain(0..first).take(PROBES);
        let found = around.into_iter().find(|place| {
            let number = self.places.get(*place).copied().unwrap_or(0);
            number == 0 || same(number - 1)
        });
        match found.and_then(|place| self.places.get_mut(place)) {
            Some(place) if *place == 0 => Visit::New(place),
            Some(place) => Visit::Known(place),
            None => Visit::Full,
        }
    }
}
