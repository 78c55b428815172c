//! LM-cut (Helmert and Domshlak 2009).

use super::relaxation::{Fact, Reached, Relaxation, adds_of};
use crate::task::AtomSet;

impl<const N: usize> Relaxation<'_, N> {
    /// LM-cut. As long as the goal costs something, there is a cut: a set of
    /// operators of each of which every plan has one. It counts what the cheapest of
    /// them costs, by which all of them are cheaper from then on. `None` if the goal
    /// cannot be reached.
    pub(super) fn landmark_cut(&mut self, state: AtomSet<N>) -> Option<u32> {
        self.reset_costs();
        let mut cuts = 0u32;
        // Each cut takes all of the cost of at least one operator.
        for _ in 0..=self.task.operators.len() {
            let goal = self.explore(state)?;
            if goal.cost == 0 {
                break;
            }
            let zone = self.goal_zone(&goal);
            cuts = cuts.saturating_add(self.cut(state, zone));
        }
        Some(cuts)
    }

    /// The atoms from which the goal is for free, when each operator is thought to
    /// need its supporter only.
    fn goal_zone(&self, goal: &Reached) -> AtomSet<N> {
        let mut zone = AtomSet::single(u32::from(goal.supporter));
        let mut now = zone;
        while let Some(place) = now.pop_first() {
            for operator in self.adding.of(place as Fact) {
                let progress = self.progress.get(usize::from(*operator));
                let free = progress.filter(|progress| progress.cost == 0);
                if let Some(supporter) = free.and_then(|progress| progress.supporter()) {
                    let new = AtomSet::single(u32::from(supporter)).difference(zone);
                    zone = zone.union(new);
                    now = now.union(new);
                }
            }
        }
        zone
    }

    /// Makes the operators cheaper that lead into the zone, from what can be reached
    /// without entering it, by the cost of the cheapest. Returns that.
    fn cut(&mut self, state: AtomSet<N>, zone: AtomSet<N>) -> u32 {
        let mut least = if self.weighted { u32::MAX } else { 1 };
        let mut reached = state;
        let mut now = state;
        let mut fact = Self::START;
        loop {
            for place in self.needing.of(fact) {
                let Some(progress) = self.progress.get_mut(usize::from(*place)) else {
                    continue;
                };
                if progress.supporter() != Some(fact) {
                    continue;
                }
                let effects = adds_of(self.task.operators, *place);
                if !effects.intersection(zone).is_empty() {
                    if self.weighted {
                        progress.is_cut = true;
                        least = least.min(progress.cost);
                    } else {
                        progress.cost = 0;
                    }
                }
                let new = effects.difference(zone).difference(reached);
                reached = reached.union(new);
                now = now.union(new);
            }
            match now.pop_first() {
                Some(place) => fact = place as Fact,
                None => break,
            }
        }
        if self.weighted {
            for progress in self.progress.iter_mut().filter(|p| p.is_cut) {
                progress.is_cut = false;
                progress.cost = progress.cost.saturating_sub(least);
            }
        }
        least
    }
}
