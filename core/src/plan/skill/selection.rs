//! Which settings a skill is tried in.

use super::Skill;
use super::settings::Candidate;
use super::training::TrainingMemory;
use crate::domain::{Node, PointSet, Scene};
use crate::error::Error;
use crate::grammar::Features;

/// The most complex features that count.
const COMPLEXITY: usize = 2;

/// Chooses among candidates: each time the one that extends most what the chosen ones
/// range over, summed over the features of the grammar, each in units of what all
/// candidates range over.
///
/// A rare relation, such as an obstacle beside the target, is then among a dozen
/// settings. At random it would hardly be, and what is never tried is never learned.
pub(super) struct Selection {
    /// How many candidates there are. The chosen ones stand first.
    count: usize,
    chosen: usize,
    /// Whether to choose; otherwise they come in their order.
    spread: bool,
}

/// What a feature ranges over.
#[derive(Clone, Copy)]
struct Extent {
    low: f64,
    high: f64,
}

const NOTHING: Extent = Extent {
    low: f64::INFINITY,
    high: f64::NEG_INFINITY,
};

impl Extent {
    fn with(self, value: f64) -> Extent {
        if !value.is_finite() {
            return self;
        }
        Extent {
            low: self.low.min(value),
            high: self.high.max(value),
        }
    }

    fn size(self) -> f64 {
        (self.high - self.low).max(0.0)
    }
}

/// Features of the candidates. Of each there are four numbers: the lowest and highest value
/// of all candidates, and of the chosen ones.
struct Spread<'s> {
    features: Features<'s, f64>,
    skill: &'s Skill,
    instances: &'s [f64],
    proposals: &'s [crate::region::Theta],
    extents: &'s mut [f64],
}

impl Selection {
    pub(super) fn new(count: usize, spread: bool) -> Self {
        Selection {
            count,
            chosen: 0,
            spread,
        }
    }

    /// The next one; `None` if there are no more.
    pub(super) fn next(
        &mut self,
        skill: &Skill,
        memory: &mut TrainingMemory<'_>,
    ) -> Result<Option<Candidate>, Error> {
        if self.spread && self.chosen < self.count {
            let mut spread = Spread::new(skill, memory)?;
            if self.chosen == 0 {
                spread.survey(self.count)?;
            }
            let best = spread.best(self.chosen..self.count)?;
            spread.choose(best)?;
            self.swap(best, skill.binding.len(), memory);
        }
        let candidate = memory.candidates.get(self.chosen).copied();
        let candidate = candidate.filter(|_| self.chosen < self.count);
        self.chosen += 1;
        Ok(candidate)
    }

    /// Puts a candidate behind the chosen ones.
    fn swap(&self, index: usize, length: usize, memory: &mut TrainingMemory<'_>) {
        if index == self.chosen {
            return;
        }
        // Both places are below the count, for which there is room in all tables.
        swap(memory.candidates, self.chosen, index);
        swap(memory.proposals, self.chosen, index);
        for number in 0..length {
            let [a, b] = [self.chosen, index].map(|place| place * length + number);
            swap(memory.instances, a, b);
        }
    }
}

fn swap<T: Copy>(table: &mut [T], a: usize, b: usize) {
    let (Some(first), Some(second)) = (table.get(a).copied(), table.get(b).copied()) else {
        return;
    };
    for (place, value) in [(a, second), (b, first)] {
        if let Some(slot) = table.get_mut(place) {
            *slot = value;
        }
    }
}

impl<'s> Spread<'s> {
    fn new(skill: &'s Skill, memory: &'s mut TrainingMemory<'_>) -> Result<Self, Error> {
        let learner = &mut memory.learner;
        let (nodes, values) = (&mut *learner.features, &mut *learner.values);
        let features = Features::enumerate_up_to(&skill.domain, COMPLEXITY, nodes, values)?;
        let extents = learner.instances.get_mut(..4 * features.len());
        Ok(Spread {
            features,
            skill,
            instances: memory.instances,
            proposals: memory.proposals,
            extents: extents.ok_or(Error::CapacityExceeded("numbers of training instances"))?,
        })
    }

    /// Evaluates the features of a candidate.
    fn evaluate(&mut self, candidate: usize) -> Result<(), Error> {
        const NONE: Error = Error::InvalidArgument("there is no such candidate");
        let length = self.skill.binding.len();
        let instance = self
            .instances
            .get(candidate * length..(candidate + 1) * length);
        let domain = &self.skill.domain;
        let scene = Scene::<f64>::new(domain, instance.ok_or(NONE)?, PointSet::all(domain))?;
        self.features
            .evaluate(&scene, self.proposals.get(candidate).ok_or(NONE)?);
        Ok(())
    }

    /// What all candidates range over; none is chosen.
    fn survey(&mut self, count: usize) -> Result<(), Error> {
        for row in self.extents.chunks_exact_mut(4) {
            set_extents(row, [NOTHING; 2]);
        }
        for candidate in 0..count {
            self.evaluate(candidate)?;
            self.widen(|[all, chosen], value| [all.with(value), chosen]);
        }
        Ok(())
    }

    fn choose(&mut self, candidate: usize) -> Result<(), Error> {
        self.evaluate(candidate)?;
        self.widen(|[all, chosen], value| [all, chosen.with(value)]);
        Ok(())
    }

    fn widen(&mut self, wider: impl Fn([Extent; 2], f64) -> [Extent; 2]) {
        let rows = self.extents.chunks_exact_mut(4);
        for (row, value) in rows.zip(self.features.values()) {
            set_extents(row, wider(extents(row), *value));
        }
    }

    /// The candidate that extends most what the chosen ones range over.
    fn best(&mut self, candidates: core::ops::Range<usize>) -> Result<usize, Error> {
        let mut best = (candidates.start, 0.0);
        for candidate in candidates {
            self.evaluate(candidate)?;
            let gain = self.gain();
            if gain > best.1 {
                best = (candidate, gain);
            }
        }
        Ok(best.0)
    }

    /// By how much the candidate that was evaluated extends the chosen ones.
    fn gain(&self) -> f64 {
        let terms = self.features.nodes().iter().zip(self.features.values());
        let gains = terms
            .zip(self.extents.chunks_exact(4))
            .map(|((node, value), row)| {
                let ([all, chosen], true) = (extents(row), says_something(node)) else {
                    return 0.0;
                };
                let gain = (chosen.with(*value).size() - chosen.size()) / all.size();
                if gain.is_finite() { gain } else { 0.0 }
            });
        gains.sum()
    }
}

/// What all candidates and what the chosen ones range over.
fn extents(row: &[f64]) -> [Extent; 2] {
    let at = |place: usize| row.get(place).copied().unwrap_or(f64::NAN);
    [0, 2].map(|first| Extent {
        low: at(first),
        high: at(first + 1),
    })
}

fn set_extents(row: &mut [f64], [all, chosen]: [Extent; 2]) {
    let numbers = [all.low, all.high, chosen.low, chosen.high];
    for (place, number) in row.iter_mut().zip(numbers) {
        *place = number;
    }
}

/// Whether a feature is more than a multiple of another one, or a constant.
fn says_something(node: &Node) -> bool {
    !matches!(
        node,
        Node::Number(_) | Node::Constant(_) | Node::Product(..)
    )
}
