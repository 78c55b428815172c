//! h-add (Bonet and Geffner 2001).

use super::relaxation::Relaxation;
use crate::task::{AtomSet, MAX_ATOMS};

impl Relaxation<'_> {
    /// h-add: as if the atoms of a set were reached one after the other, without
    /// any operator helping two of them. `None` if the goal cannot be reached.
    pub(super) fn additive(&self, state: AtomSet) -> Option<u32> {
        let mut costs = [None; MAX_ATOMS];
        lower(&mut costs, state, 0);
        // Costs fall only, to those of the cheapest way, which uses no operator
        // twice: so many rounds reach them, and usually few.
        for _ in 0..=self.task.operators.len() {
            let mut changed = false;
            for operator in self.task.operators {
                if let Some(before) = sum(&costs, operator.preconditions) {
                    let cost = before.saturating_add(1);
                    changed |= lower(&mut costs, operator.add_effects, cost);
                }
            }
            if !changed {
                break;
            }
        }
        sum(&costs, self.task.goal)
    }
}

type Costs = [Option<u32>; MAX_ATOMS];

/// The cost of all atoms of a set together; `None` if one is not reached.
fn sum(costs: &Costs, atoms: AtomSet) -> Option<u32> {
    atoms.places().try_fold(0u32, |sum, place| {
        let cost = (*costs.get(place as usize)?)?;
        Some(sum.saturating_add(cost))
    })
}

/// Lowers the costs of these atoms to `cost`, and says whether any was higher.
fn lower(costs: &mut Costs, atoms: AtomSet, cost: u32) -> bool {
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
