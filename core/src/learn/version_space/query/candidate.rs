//! Candidates for a query.

use super::Strategy;
use crate::domain::MAX_PARAMETERS;
use crate::learn::{Problem, Query};
use crate::random::{Generator, below, uniform, uniform_in};
use crate::real::Real;
use crate::region::Theta;
use rand_core::Rng;

/// Anywhere in the parameter space of some instance.
pub(super) fn anywhere(problem: &Problem<'_>, rng: &mut Generator, scales: u32) -> Query {
    let instance = below(rng, problem.count());
    Query {
        instance,
        theta: any_theta(problem, instance, rng, scales),
    }
}

/// Uniform in the parameter space. Where something is proposed, every other time close
/// to that, at any of so many scales: a region that is a hundredth of the space is found
/// there. What is proposed may lie beyond the space, if only by rounding; what is asked
/// never does.
#[inline(never)]
fn any_theta(problem: &Problem<'_>, instance: usize, rng: &mut Generator, scales: u32) -> Theta {
    let mut theta = [0.0; MAX_PARAMETERS];
    for (value, p) in theta.iter_mut().zip(problem.domain().parameters()) {
        *value = uniform_in(rng, p.low, p.high);
    }
    match problem.proposal(instance) {
        Some(proposal) if rng.next_u32() & 1 == 0 => {
            let mut close = between(proposal, &theta, any_scale(rng, scales));
            for (value, p) in close.iter_mut().zip(problem.domain().parameters()) {
                *value = Real::clamp(*value, p.low, p.high);
            }
            close
        }
        _ => theta,
    }
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
    /// Anywhere in the parameter space of an instance.
    pub(super) fn any_theta(&self, instance: usize, rng: &mut Generator) -> Theta {
        let scales = self.forms.tuning().proposal_scales;
        any_theta(self.problem, instance, rng, scales)
    }

    /// On the way between a feasible and an infeasible sample of the instance.
    #[inline(never)]
    pub(super) fn between_samples(&self, instance: usize, rng: &mut Generator) -> Theta {
        let start = below(rng, self.observations.len());
        let (before, after) = self
            .observations
            .split_at_checked(start)
            .unwrap_or_default();
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
            !asked.any(|o| o.instance as usize == *instance)
        })
    }
}
