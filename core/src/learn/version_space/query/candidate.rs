//! Candidates for a query.

use super::Strategy;
use crate::domain::MAX_PARAMETERS;
use crate::learn::question::Trial;
use crate::learn::{Observation, Problem, Query};
use crate::random::{Generator, below, uniform, uniform_in};
use crate::real::Real;
use crate::region::Theta;
use rand_core::Rng;

/// Uniform in the parameter space.
fn anything(problem: &Problem<'_>, rng: &mut Generator) -> Theta {
    let mut theta = [0.0; MAX_PARAMETERS];
    for (value, p) in theta.iter_mut().zip(problem.domain().parameters()) {
        *value = uniform_in(rng, p.low, p.high);
    }
    theta
}

/// A share of the way from what is known or proposed to somewhere in the parameter space, at
/// any of so many scales. What is proposed may lie beyond the space, if only by rounding;
/// what is asked never does.
fn close_to(problem: &Problem<'_>, centre: &Theta, rng: &mut Generator, scales: u32) -> Theta {
    let theta = anything(problem, rng);
    let mut close = between(centre, &theta, any_scale(rng, scales));
    for (value, p) in close.iter_mut().zip(problem.domain().parameters()) {
        *value = Real::clamp(*value, p.low, p.high);
    }
    close
}

/// A share of any order of magnitude: uniform within a power of two, each of which is
/// equally likely.
fn any_scale(rng: &mut Generator, scales: u32) -> f64 {
    let halvings = below(rng, scales as usize);
    let scale = uniform_in(rng, 0.5, 1.0);
    (0..halvings).fold(scale, |scale, _| 0.5 * scale)
}

/// A share of the way from `a` to `b`.
pub(super) fn between(a: &Theta, b: &Theta, share: f64) -> Theta {
    let mut theta = *a;
    for (value, b) in theta.iter_mut().zip(b) {
        *value += (*b - *value) * share;
    }
    theta
}

impl<R: Real> Strategy<'_, '_, R> {
    /// The samples of the questions that are open.
    pub(super) fn open(&self) -> impl Iterator<Item = &Query> {
        let open = self.open.iter().filter(|trial| trial.is_open());
        open.map(Trial::query)
    }

    /// Anywhere in the parameter space of some instance.
    pub(super) fn anywhere(&self, rng: &mut Generator) -> Query {
        let instance = below(rng, self.problem.count());
        Query {
            instance,
            theta: self.any_theta(instance, rng),
        }
    }

    /// Anywhere in the parameter space of an instance. Where somebody told that something
    /// works there, or proposes something, every other time close to that: a region that is
    /// a hundredth of the space, or much less, is found there.
    #[inline(never)]
    pub(super) fn any_theta(&self, instance: usize, rng: &mut Generator) -> Theta {
        let tuning = self.forms.tuning();
        let told = self.told_to_work(instance, rng);
        let known = told.map(|theta| (theta, tuning.observed_scales));
        let proposed = || Some((self.problem.proposal(instance)?, tuning.proposal_scales));
        match known.or_else(proposed) {
            Some((centre, scales)) if rng.next_u32() & 1 == 0 => {
                close_to(self.problem, centre, rng, scales)
            }
            _ => anything(self.problem, rng),
        }
    }

    /// What is known to work in an instance although nobody asked, one of that by chance.
    fn told_to_work(&self, instance: usize, rng: &mut Generator) -> Option<&Theta> {
        if !self.observed {
            return None;
        }
        let works = |o: &&Observation| {
            !o.asked() && o.instance as usize == instance && o.outcome.is_feasible()
        };
        let (before, after) = self.split_at_random(rng);
        let told = after.iter().chain(before).find(works);
        told.map(|o| &o.theta)
    }

    /// The observations before a random one, and those from it on.
    fn split_at_random(&self, rng: &mut Generator) -> (&[Observation], &[Observation]) {
        let start = below(rng, self.observations.len());
        let split = self.observations.split_at_checked(start);
        split.unwrap_or_default()
    }

    /// On the way between a feasible and an infeasible sample of the instance.
    #[inline(never)]
    pub(super) fn between_samples(&self, instance: usize, rng: &mut Generator) -> Theta {
        let (before, after) = self.split_at_random(rng);
        let find = |feasible: bool| {
            let mut all = after.iter().chain(before);
            all.find(|o| o.instance as usize == instance && o.outcome.label() == Some(feasible))
        };
        let mut theta = self.any_theta(instance, rng);
        if let (Some(a), Some(b)) = (find(true), find(false)) {
            theta = between(&a.theta, &b.theta, uniform(rng));
        }
        theta
    }

    /// The instances that were not asked about, from a random one on.
    pub(super) fn unasked(&self, rng: &mut Generator) -> impl Iterator<Item = usize> {
        let count = self.problem.count();
        let first = below(rng, count);
        let all = (first..count).chain(0..first);
        all.filter(|instance| {
            let mut asked = self.observations.iter();
            let mut open = self.open().map(|query| query.instance);
            !asked.any(|o| o.instance as usize == *instance) && !open.any(|own| own == *instance)
        })
    }
}
