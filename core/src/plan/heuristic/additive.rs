//! h-add (Bonet and Geffner 2001).

use super::relaxation::{BITS, Relaxation};
use crate::task::AtomSet;

impl<const N: usize> Relaxation<'_, N> {
    /// h-add: as if the atoms of a set were reached one after the other, without
    /// any operator helping two of them. `None` if the goal cannot be reached.
    pub(super) fn additive(&self, state: AtomSet<N>) -> Option<u32> {
        let mut costs = [[None; BITS]; N];
        let costs = costs.as_flattened_mut();
        lower(costs, state, 0);
        // Costs fall only, to those of the cheapest way, which uses no operator
        // twice: so many rounds reach them, and usually few.
        for _ in 0..=self.task.operators.len() {
            let mut changed = false;
            for operator in self.task.operators {
                if let Some(before) = sum(costs, operator.preconditions) {
                    let cost = before.saturating_add(operator.cost);
                    changed |= lower(costs, operator.add_effects, cost);
                }
            }
            if !changed {
                break;
            }
        }
        sum(costs, self.task.goal)
    }
}

/// The cost of all atoms of a set together; `None` if one is not reached.
fn sum<const N: usize>(costs: &[Option<u32>], atoms: AtomSet<N>) -> Option<u32> {
    atoms.places().try_fold(0u32, |sum, place| {
        let cost = (*costs.get(place as usize)?)?;
        Some(sum.saturating_add(cost))
    })
}

/// Lowers the costs of these atoms to `cost`, and says whether any was higher.
fn lower<const N: usize>(costs: &mut [Option<u32>], atoms: AtomSet<N>, cost: u32) -> bool {
    let mut changed = false;
    for place in atoms.places() {
        if let Some(slot) = costs.get_mut(place as usize)
            && slot.is_none_or(|before| before > cost)
        {
            *slot = Some(cost);
            changed = true;
        }
    }
    changed
}
