//! Which sample to ask about next.
//!
//! Query by committee (Seung, Opper and Sompolinsky 1992): candidates are drawn,
//! and the one that splits the votes of several explanations most evenly is asked.
//! Where all agree, the widest gap between the bounds of a constraint is halved.
//! Where all gaps are narrow, the constraints are put to the test in another
//! instance, just inside or just outside of their bounds: a constraint that fits
//! the instances by chance does not survive that.
//!
//! A scene is large. What makes one is never inlined, so that one at a time is on the
//! stack, nor what is done beside it; the values of the left sides are in lent memory.
//! A query is written where it will be asked from, and a function tells whether it found
//! one: a way of eight returned queries would take as much stack as a scene.

use super::bound::Bound;
use super::chosen::Chosen;
use super::cover::{Cover, MEMBERS};
use super::forms::Forms;
use crate::domain::{MAX_PARAMETERS, PointSet, Scene};
use crate::error::Error;
use crate::learn::{Observation, Problem, Query};
use crate::random::{Generator, below, uniform, uniform_in};
use crate::real::Real;
use crate::region::Theta;
use rand_core::Rng;

/// Instances that candidates are drawn in, and candidates in each.
const GROUPS: usize = 12;
const EACH: usize = 8;

/// How often the distance to a proposal is halved.
const SCALES: usize = 12;

/// Tries to find a sample at a certain value of a form.
const TRIES: usize = 32;
/// How often the way to it is halved.
const HALVINGS: usize = 24;
/// A gap is narrow below this share of what a form ranges over.
const NARROW: f64 = 0.002;

/// What is known when a question is chosen.
pub(super) struct Choice<'c, 'm, R> {
    pub(super) forms: &'c Forms<'m, R>,
    /// Explanations, those of one step together.
    pub(super) covers: &'c [Cover<R>],
    pub(super) observations: &'c [Observation],
}

/// Anywhere in the parameter space of some instance.
pub(super) fn anywhere(problem: &Problem<'_>, rng: &mut Generator) -> Query {
    let instance = below(rng, problem.count());
    Query {
        instance,
        theta: any_theta(problem, instance, rng),
    }
}

/// Uniform in the parameter space. Where something is proposed, every other time close
/// to that, at any scale: a region that is a hundredth of the space is found there. What
/// is proposed may lie beyond the space, if only by rounding; what is asked never does.
#[inline(never)]
fn any_theta(problem: &Problem<'_>, instance: usize, rng: &mut Generator) -> Theta {
    let mut theta = [0.0; MAX_PARAMETERS];
    for (value, p) in theta.iter_mut().zip(problem.domain().parameters()) {
        *value = uniform_in(rng, p.low, p.high);
    }
    match problem.proposal(instance) {
        Some(proposal) if rng.next_u32() & 1 == 0 => {
            let mut close = between(proposal, &theta, any_scale(rng));
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
fn any_scale(rng: &mut Generator) -> f64 {
    let halvings = below(rng, SCALES);
    let scale = uniform_in(rng, 0.5, 1.0);
    (0..halvings).fold(scale, |scale, _| 0.5 * scale)
}

fn between(a: &Theta, b: &Theta, share: f64) -> Theta {
    let mut theta = *a;
    for (value, b) in theta.iter_mut().zip(b) {
        *value += (*b - *value) * share;
    }
    theta
}

/// Whether a constraint admits a sample, at which its forms have these values, for all
/// thresholds between its ends.
fn admits<R: Real>(chosen: &Chosen<R>, value: impl Fn(&Bound<R>) -> R) -> bool {
    chosen.bounds().any(|bound| value(bound) <= bound.inner)
}

impl<R: Real> Choice<'_, '_, R> {
    /// The best candidate, if there is a reason to ask one.
    #[inline(never)]
    pub(super) fn best(
        &self,
        problem: &Problem<'_>,
        lefts: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        Ok(self.most_divided(problem, lefts, rng, query)?
            || self.halve(problem, rng, query)?
            || self.test(problem, rng, query)?)
    }

    /// The candidate that splits the votes most evenly, of those that are not settled.
    #[inline(never)]
    fn most_divided(
        &self,
        problem: &Problem<'_>,
        lefts: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let points = PointSet::all(problem.domain());
        let mut most = 0;
        for _ in 0..GROUPS {
            let instance = below(rng, problem.count());
            let mut scene = Scene::blank(problem.domain(), problem.instance(instance)?, points);
            scene.settle()?;
            for candidate in 0..EACH {
                let theta = if candidate % 2 == 0 {
                    any_theta(problem, instance, rng)
                } else {
                    self.between_samples(problem, instance, rng)
                };
                self.forms.evaluate(&scene, &theta, lefts);
                let (votes, against) = self.votes(instance, lefts);
                if votes * against > most && !self.is_settled(instance, lefts) {
                    most = votes * against;
                    *query = Query { instance, theta };
                }
            }
        }
        Ok(most > 0)
    }

    /// A sample in the middle of the widest gap, if one is wide.
    #[inline(never)]
    fn halve(
        &self,
        problem: &Problem<'_>,
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        match self.widest_gap() {
            Some((share, chosen, bound)) if share > NARROW => {
                let middle = bound.inner + (bound.outer - bound.inner) * R::from_f64(0.5);
                self.at_value(problem, (chosen, bound), middle, &|_| false, rng, query)
            }
            _ => Ok(false),
        }
    }

    /// Some instance that was not asked about.
    pub(super) fn unasked(&self, problem: &Problem<'_>, rng: &mut Generator) -> Option<usize> {
        self.all_unasked(problem, rng).next()
    }

    /// The instances that were not asked about, from a random one on.
    fn all_unasked(
        &self,
        problem: &Problem<'_>,
        rng: &mut Generator,
    ) -> impl Iterator<Item = usize> {
        let count = problem.count();
        let first = below(rng, count);
        let all = (first..count).chain(0..first);
        all.filter(|instance| {
            let mut asked = self.observations.iter();
            !asked.any(|o| o.instance as usize == *instance)
        })
    }

    /// Of the instances that were not asked about, the one that splits the votes most
    /// evenly, then one between the ends of most bounds.
    #[inline(never)]
    pub(super) fn best_unasked(
        &self,
        problem: &Problem<'_>,
        lefts: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let theta = [0.0; MAX_PARAMETERS];
        let mut best: Option<(usize, usize)> = None;
        for instance in self.all_unasked(problem, rng) {
            let own = Query { instance, theta };
            self.forms.evaluate_query(problem, &own, lefts)?;
            let (votes, against) = self.votes(instance, lefts);
            let open = self.best_bounds().filter(|(_, bound)| {
                let value = self.forms.value(&bound.side, instance, lefts);
                bound.inner < value && value < bound.outer
            });
            let score = (votes * against, open.count());
            if best.is_none_or(|most| score > most) {
                (best, *query) = (Some(score), own);
            }
        }
        Ok(best.is_some())
    }

    /// Whether a sample lies where a bound of the best explanation is known as well
    /// as needed. Others put it slightly elsewhere; that is not worth a question.
    #[inline(never)]
    fn is_settled(&self, instance: usize, lefts: &[R]) -> bool {
        self.best_bounds().any(|(_, bound)| {
            let margin = bound.range * R::from_f64(NARROW);
            let value = self.forms.value(&bound.side, instance, lefts);
            bound.outer - bound.inner <= margin
                && value >= bound.inner - margin
                && value <= bound.outer + margin
        })
    }

    /// The best explanations.
    fn best_chosen(&self) -> impl Iterator<Item = &Chosen<R>> {
        self.covers
            .iter()
            .step_by(MEMBERS)
            .flat_map(|cover| &cover.chosen)
    }

    /// The bounds of the best explanations, each with its constraint.
    fn best_bounds(&self) -> impl Iterator<Item = (&Chosen<R>, &Bound<R>)> {
        let bounds = |chosen| Chosen::bounds(chosen).map(move |bound| (chosen, bound));
        self.best_chosen().flat_map(bounds)
    }

    /// The bound with the widest gap, relative to its range, and its constraint.
    fn widest_gap(&self) -> Option<(f64, &Chosen<R>, &Bound<R>)> {
        let share = |b: &Bound<R>| ((b.outer - b.inner) / b.range).to_f64();
        let shares = self.best_bounds().map(|(c, b)| (share(b), c, b));
        let finite = shares.filter(|(share, ..)| share.is_finite());
        finite.reduce(|widest, next| if next.0 > widest.0 { next } else { widest })
    }

    /// A sample just inside or just outside of one constraint, where none of the
    /// instance is yet.
    #[inline(never)]
    fn test(
        &self,
        problem: &Problem<'_>,
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let count = self.best_bounds().count();
        let Some((chosen, bound)) = self.best_bounds().nth(below(rng, count)) else {
            return Ok(false);
        };
        let margin = bound.range * R::from_f64(NARROW);
        let off = margin * R::from_f64(0.5 * uniform(rng));
        let inside = rng.next_u32() & 1 == 0;
        let (value, ends) = if inside {
            let least = bound.inner - margin * R::from_f64(0.5);
            (bound.inner - off, [least, bound.inner])
        } else {
            let most = bound.outer + margin * R::from_f64(0.5);
            (bound.outer + off, [bound.outer, most])
        };
        let [low, high] = ends;
        let tested = |instance: usize| {
            let near = |sample: &usize| {
                let value = self.forms.value_at(&bound.side, *sample);
                self.forms.instance_of(*sample) == instance && low <= value && value <= high
            };
            (0..self.forms.samples()).any(|sample| near(&sample))
        };
        self.at_value(problem, (chosen, bound), value, &tested, rng, query)
    }

    /// What nobody suspects is found far from all samples. Every other time only
    /// candidates count that the best explanation admits, because a gap in it does most
    /// harm, or that one of several constraints refuses, because there a second piece
    /// of a union would be.
    #[inline(never)]
    pub(super) fn farthest(
        &self,
        problem: &Problem<'_>,
        lefts: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let mut odd = || rng.next_u32() & 1 == 1;
        let wanted = if !odd() {
            None
        } else if self.best_chosen().nth(1).is_some() && !odd() {
            Some(1)
        } else {
            Some(0)
        };
        self.farthest_refused_by(problem, wanted, lefts, rng, query)
    }

    /// Of some candidates that are refused by so many constraints of the best
    /// explanation, or by any number, the one farthest from all samples of its instance.
    #[inline(never)]
    fn farthest_refused_by(
        &self,
        problem: &Problem<'_>,
        wanted: Option<usize>,
        lefts: &mut [R],
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let points = PointSet::all(problem.domain());
        let mut most: Option<f64> = None;
        for _ in 0..GROUPS {
            let instance = below(rng, problem.count());
            let mut scene = Scene::blank(problem.domain(), problem.instance(instance)?, points);
            scene.settle()?;
            for _ in 0..EACH {
                let theta = any_theta(problem, instance, rng);
                self.forms.evaluate(&scene, &theta, lefts);
                if wanted.is_some_and(|wanted| self.refusing(instance, lefts) != wanted) {
                    continue;
                }
                let own = Query { instance, theta };
                let distance = self.distance(problem, &own);
                if most.is_none_or(|most| distance > most) {
                    (most, *query) = (Some(distance), own);
                }
            }
        }
        Ok(most.is_some())
    }

    /// How many constraints of the best explanation refuse a sample.
    #[inline(never)]
    fn refusing(&self, instance: usize, lefts: &[R]) -> usize {
        let value = |bound: &Bound<R>| self.forms.value(&bound.side, instance, lefts);
        let refusing = self.best_chosen().filter(|c| !admits(c, value));
        refusing.count()
    }

    /// The squared distance to the nearest sample of the instance, in units of the
    /// ranges of the parameters.
    #[inline(never)]
    fn distance(&self, problem: &Problem<'_>, query: &Query) -> f64 {
        let own = self.observations.iter();
        let own = own.filter(|o| o.instance as usize == query.instance);
        let apart = own.map(|o| {
            let pairs = o
                .theta
                .iter()
                .zip(&query.theta)
                .zip(problem.domain().parameters());
            let squares = pairs.map(|((a, b), p)| {
                let share = (a - b) / (p.high - p.low);
                share * share
            });
            squares.filter(|s| s.is_finite()).sum::<f64>()
        });
        apart.fold(f64::INFINITY, f64::min)
    }

    /// A sample in some instance at which the form of a bound has a certain value,
    /// and for which nothing else decides.
    #[inline(never)]
    fn at_value(
        &self,
        problem: &Problem<'_>,
        (chosen, bound): (&Chosen<R>, &Bound<R>),
        value: R,
        skip: &dyn Fn(usize) -> bool,
        rng: &mut Generator,
        query: &mut Query,
    ) -> Result<bool, Error> {
        let points = PointSet::all(problem.domain());
        for _ in 0..TRIES {
            let instance = below(rng, problem.count());
            if skip(instance) {
                continue;
            }
            let mut scene = Scene::blank(problem.domain(), problem.instance(instance)?, points);
            scene.settle()?;
            let beyond =
                |theta: &Theta| self.forms.value_in(&scene, theta, &bound.side, instance) > value;
            let mut inside = any_theta(problem, instance, rng);
            let mut outside = any_theta(problem, instance, rng);
            match (beyond(&inside), beyond(&outside)) {
                (true, false) => core::mem::swap(&mut inside, &mut outside),
                (false, true) => {}
                _ => continue,
            }
            for _ in 0..HALVINGS {
                let middle = between(&inside, &outside, 0.5);
                let end = if beyond(&middle) {
                    &mut outside
                } else {
                    &mut inside
                };
                *end = middle;
            }
            let theta = inside;
            let value =
                |other: &Bound<R>| self.forms.value_in(&scene, &theta, &other.side, instance);
            if self.decides((chosen, bound), &value) {
                *query = Query { instance, theta };
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether a bound alone decides about a sample, at which forms have these values.
    #[inline(never)]
    fn decides(
        &self,
        (chosen, bound): (&Chosen<R>, &Bound<R>),
        value: &dyn Fn(&Bound<R>) -> R,
    ) -> bool {
        let mut rivals = chosen.bounds().filter(|other| *other != bound);
        let mut others = self.best_chosen().filter(|other| *other != chosen);
        rivals.all(|other| value(other) >= other.outer) && others.all(|other| admits(other, value))
    }

    /// On the way between a feasible and an infeasible sample of the instance.
    #[inline(never)]
    fn between_samples(
        &self,
        problem: &Problem<'_>,
        instance: usize,
        rng: &mut Generator,
    ) -> Theta {
        let start = below(rng, self.observations.len());
        let (before, after) = self
            .observations
            .split_at_checked(start)
            .unwrap_or_default();
        let find = |feasible: bool| {
            let own = |o: &&Observation| {
                o.instance as usize == instance && o.outcome.label() == Some(feasible)
            };
            after.iter().chain(before).find(own)
        };
        let mut theta = any_theta(problem, instance, rng);
        if let (Some(a), Some(b)) = (find(true), find(false)) {
            theta = between(&a.theta, &b.theta, uniform(rng));
        }
        theta
    }

    /// How many members of the committee expect the sample to work, and how many do
    /// not. The best explanations vote only if they agree with every answer.
    #[inline(never)]
    fn votes(&self, instance: usize, lefts: &[R]) -> (usize, usize) {
        let half = R::from_f64(0.5);
        let agrees = |cover: &Cover<R>| {
            let value = |bound: &Bound<R>| self.forms.value(&bound.side, instance, lefts);
            let holds = |bound: &Bound<R>| bound.position(value(bound)) < half;
            cover.chosen.iter().all(|chosen| chosen.bounds().any(holds))
        };
        let strained = self.best_bounds().any(|(_, bound)| bound.strain > R::ZERO);
        let voters = usize::from(strained)..MEMBERS;
        let in_favour = |member: &usize| {
            let mut own = self.covers.iter().skip(*member).step_by(MEMBERS);
            own.all(agrees)
        };
        let all = voters.len();
        let votes = voters.filter(in_favour).count();
        (votes, all - votes)
    }
}
