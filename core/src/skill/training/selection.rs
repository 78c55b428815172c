//! Which situations a skill is tried in: those that differ.

use super::memory::TrainingMemory;
use super::situation::Candidate;
use crate::domain::{Node, PointSet, Scene};
use crate::error::Error;
use crate::grammar::Features;
use crate::real::Real;
use crate::region::Theta;
use crate::skill::skills::Skill;
use crate::skill::tuning::COMPLEXITY;
use crate::table::swap_rows;

/// Moves those candidates to the front, `wanted` of `count`, that differ most: each time
/// the one that does so most from those before it (farthest-first traversal, Gonzalez
/// 1985). In every feature of the grammar it is as far as the nearest of them, in units of
/// what all instances range over, and these distances are summed.
///
/// A rare relation that stands out, such as an obstacle closer to the target than any
/// other, is then among a dozen situations. At random it would hardly be, and what is never
/// tried is never learned. What lies within the usual range of every feature is not
/// chosen more often than at random.
///
/// # Errors
/// [`Error::CapacityExceeded`] if the features of so many instances find no room in the
/// memory of the learner.
pub(super) fn select_differing(
    skill: &Skill,
    memory: &mut TrainingMemory<'_>,
    count: usize,
    wanted: usize,
) -> Result<(), Error> {
    let mut selection = Selection::new(skill, memory, wanted)?;
    selection.survey(count)?;
    for chosen in 0..wanted.min(count) {
        let best = selection.best(chosen, count)?;
        selection.keep(best, chosen)?;
        selection.swap(chosen, best);
    }
    Ok(())
}

/// Candidates with the features of their instances, and what is remembered of them.
struct Selection<'s> {
    skill: &'s Skill,
    candidates: &'s mut [Candidate],
    proposals: &'s mut [Theta],
    instances: &'s mut [f64],
    features: Features<'s, f64>,
    /// The lowest value of each feature over all instances, the highest one, and then
    /// the values of each chosen instance.
    rows: &'s mut [f64],
}

impl<'s> Selection<'s> {
    fn new(
        skill: &'s Skill,
        memory: &'s mut TrainingMemory<'_>,
        wanted: usize,
    ) -> Result<Self, Error> {
        const FULL: Error = Error::CapacityExceeded("features of training instances");
        let learner = &mut memory.learner;
        let (nodes, values) = (&mut *learner.features, &mut *learner.lhs_values);
        let features = Features::enumerate_up_to(skill.domain(), COMPLEXITY, nodes, values)?;
        let rows = learner.rhs_values.get_mut(..(wanted + 2) * features.len());
        Ok(Selection {
            skill,
            candidates: memory.candidates,
            proposals: memory.proposals,
            instances: memory.instances,
            features,
            rows: rows.ok_or(FULL)?,
        })
    }

    /// Swaps two candidates, with their instances and proposals.
    fn swap(&mut self, first: usize, second: usize) {
        swap_rows(self.candidates, 1, first, second);
        swap_rows(self.proposals, 1, first, second);
        swap_rows(self.instances, self.skill.binding().len(), first, second);
    }

    /// Computes the features of an instance.
    fn evaluate(&mut self, index: usize) -> Result<(), Error> {
        const NONE: Error = Error::InvalidArgument("there is no such instance");
        let length = self.skill.binding().len();
        let instance = self.instances.get(index * length..(index + 1) * length);
        let (domain, theta) = (self.skill.domain(), self.proposals.get(index).ok_or(NONE)?);
        let scene = Scene::<f64>::new(domain, instance.ok_or(NONE)?, PointSet::all(domain))?;
        self.features.evaluate(&scene, theta);
        Ok(())
    }

    /// Notes what the features range over.
    fn survey(&mut self, count: usize) -> Result<(), Error> {
        let features = self.features.len();
        for index in 0..count {
            self.evaluate(index)?;
            let Some((lows, highs)) = self.rows.split_at_mut_checked(features) else {
                break;
            };
            let extents = lows.iter_mut().zip(highs);
            for (value, (low, high)) in self.features.values().iter().zip(extents) {
                let first = index == 0;
                *low = if first { *value } else { low.min(*value) };
                *high = if first { *value } else { high.max(*value) };
            }
        }
        Ok(())
    }

    /// Remembers the features of a chosen instance.
    fn keep(&mut self, index: usize, chosen: usize) -> Result<(), Error> {
        self.evaluate(index)?;
        let features = self.features.len();
        let row = self.rows.iter_mut().skip((chosen + 2) * features);
        for (slot, value) in row.zip(self.features.values()) {
            *slot = *value;
        }
        Ok(())
    }

    /// The instance that differs most from the chosen ones; the first of equals.
    fn best(&mut self, chosen: usize, count: usize) -> Result<usize, Error> {
        let mut best = (chosen, 0.0);
        for index in chosen..count {
            self.evaluate(index)?;
            let difference = self.difference(chosen);
            if difference > best.1 {
                best = (index, difference);
            }
        }
        Ok(best.0)
    }

    /// How much the instance that was evaluated differs from the chosen ones.
    fn difference(&self, chosen: usize) -> f64 {
        let features = self.features.len();
        let mut rows = self.rows.chunks_exact(features.max(1));
        let (lows, highs) = (rows.next().unwrap_or(&[]), rows.next().unwrap_or(&[]));
        let extents = lows.iter().zip(highs);
        let terms = self.features.nodes().iter().zip(self.features.values());
        let differences = terms
            .zip(extents)
            .enumerate()
            .map(|(place, (term, (low, high)))| {
                let (node, value) = term;
                let others = rows.clone().take(chosen).filter_map(|row| row.get(place));
                let nearest = others.map(|other| Real::abs(value - other));
                let nearest = nearest.fold(f64::INFINITY, f64::min) / (high - low);
                if says_something(node) && nearest.is_finite() {
                    nearest
                } else {
                    0.0
                }
            });
        differences.sum()
    }
}

/// Whether a feature is more than a multiple of another one, or a constant.
fn says_something(node: &Node) -> bool {
    !matches!(
        node,
        Node::Number(_) | Node::Constant(_) | Node::Product(..) | Node::Quotient(..)
    )
}
