//! Keeping the explanations up to date, and electing the best.

use super::chosen::Chosen;
use super::cover::{Cover, MEMBERS};
use super::explain;
use super::forms::Forms;
use super::greedy::Taste;
use super::set::count;
use super::{CANDIDATES, Certificate, VersionSpace};
use crate::domain::Domain;
use crate::real::Real;

/// By how many bits the answers must be longer than their explanation: one of
/// 2^SIGNIFICANCE times that answers by chance seem to be explained.
const SIGNIFICANCE: f64 = 10.0;
/// By how many bits the best explanations may grow before they are doubted.
const GROWTH: f64 = 3.0;
/// Explanations with a constraint of two bounds compete where the others are longer
/// than this, in bits; and how many of them.
const SIMPLE: f64 = 50.0;
const CLAUSES: usize = 3;
/// An election needs one new sample for so many old ones: where nothing explains the
/// answers for long, elections would follow each other.
const PATIENCE: usize = 8;

impl<R: Real> VersionSpace<'_, R> {
    /// Replaces the explanations that no longer hold, except for the best ones. These
    /// must agree with every answer: they are there to doubt, and one that could
    /// bend to an answer would ask for it again.
    #[inline(never)]
    pub(super) fn mend(&mut self) {
        for (step, covers) in self.covers.chunks_mut(MEMBERS).enumerate() {
            for (member, cover) in covers.iter_mut().enumerate().skip(1) {
                cover.measure(&self.forms, step, 0.0);
                if !cover.complete {
                    let taste = Taste::of_member(member);
                    cover.choose(&self.forms, step, taste, 0.0, &mut self.rng);
                }
            }
        }
    }

    /// Brings the best explanation of each step up to date, the shortest of all
    /// that are known. Tells whether one of their bounds moved.
    #[inline(never)]
    pub(super) fn mend_best(&mut self) -> bool {
        let slack = self.config.slack;
        let (mut before, mut moved) = (Cover::default(), false);
        for (step, covers) in self.covers.chunks_mut(MEMBERS).enumerate() {
            let Some((best, others)) = covers.split_first_mut() else {
                continue;
            };
            before.copy_from(best);
            best.measure(&self.forms, step, slack);
            if best.complete {
                let pairs = best.chosen.iter().zip(&before.chosen);
                moved |= pairs.into_iter().any(|(new, old)| new.is_elsewhere(old));
                continue;
            }
            (self.elected, moved) = (false, true);
            best.choose(&self.forms, step, Taste::SOBER, slack, &mut self.rng);
            for other in others {
                other.measure(&self.forms, step, 0.0);
                let shorter = other.bits(&self.forms) < best.bits(&self.forms);
                if other.complete && (shorter || !best.complete) {
                    core::mem::swap(best, other);
                }
            }
        }
        moved
    }

    /// Counts again how many samples support each constraint of the region.
    pub(super) fn count_support(&mut self, domain: &Domain<'_>) {
        if self.report.constraints_left_out > 0 {
            return self.rebuild_region(domain);
        }
        let best = self.covers.iter().step_by(MEMBERS).flat_map(|c| &c.chosen);
        let counts = best.flat_map(|chosen| chosen.bounds().map(|_| chosen.support));
        for (evidence, count) in self.support.as_mut_slice().iter_mut().zip(counts) {
            evidence.support = count;
        }
    }

    /// Whether the best explanations became so long that there may be shorter ones.
    pub(super) fn is_doubtful(&self) -> bool {
        let new = self.forms.samples() - self.electors;
        self.bits() > self.standing + GROWTH && new > self.electors / PATIENCE
    }

    /// The length of the best explanations in bits.
    fn bits(&self) -> f64 {
        let best = self.covers.iter().step_by(MEMBERS);
        best.map(|cover| cover.bits(&self.forms)).sum()
    }

    /// Whether the best explanations are so much shorter than the answers that they
    /// are no accident: answers by chance have no short explanation, except for one
    /// of 2^[`SIGNIFICANCE`] (minimum description length, Rissanen 1978).
    pub(super) fn is_significant(&self) -> bool {
        let steps = 0..self.capacity.steps;
        let answers = steps.map(|step| {
            let feasible = count(&self.forms.feasible(step)) as f64;
            let infeasible = count(&self.forms.infeasible(step)) as f64;
            let bits = |own: f64| own * libm::log2((feasible + infeasible) / own.max(1.0));
            bits(feasible) + bits(infeasible)
        });
        answers.sum::<f64>() >= self.bits() + SIGNIFICANCE
    }

    /// Looks for still better explanations and makes the region of them.
    #[inline(never)]
    pub(super) fn elect(&mut self, domain: &Domain<'_>) {
        self.mend();
        self.compete(domain);
        (self.elected, self.standing) = (true, self.bits());
        self.electors = self.forms.samples();
        self.rebuild_region(domain);
    }

    /// Puts the shortest of several refined explanations in the place of the best of
    /// each step.
    #[inline(never)]
    fn compete(&mut self, domain: &Domain<'_>) {
        let (forms, slack) = (&self.forms, self.config.slack);
        let details = |chosen: &_| explain::details(domain, forms, chosen);
        let mut other = Cover::default();
        for (step, covers) in self.covers.chunks_mut(MEMBERS).enumerate() {
            let Some((best, others)) = covers.split_first_mut() else {
                continue;
            };
            let mut standing = rate(best, forms, step, slack, &details);
            for member in 0..CANDIDATES + CLAUSES {
                let (incomplete, bits, _) = standing;
                match (others.get(member), member.checked_sub(CANDIDATES)) {
                    (Some(known), _) => other.copy_from(known),
                    (None, None) => {
                        let taste = Taste::of_member(member);
                        other.choose(forms, step, taste, 0.0, &mut self.rng);
                    }
                    (None, Some(simple)) if incomplete || bits > SIMPLE => {
                        other.choose_with_clause(forms, step, simple, &mut self.rng);
                    }
                    _ => break,
                }
                if other.complete {
                    let rating = rate(&mut other, forms, step, slack, &details);
                    if rating < standing {
                        best.copy_from(&other);
                        standing = rating;
                    }
                }
            }
        }
    }

    /// Writes the region of the best explanations, unless it is there already, and what
    /// supports its constraints. One that finds no room is left out and counted.
    #[inline(never)]
    pub(super) fn rebuild_region(&mut self, domain: &Domain<'_>) {
        let (forms, support) = (&self.forms, &mut self.support);
        let best = || self.covers.iter().step_by(MEMBERS).enumerate();
        let clauses =
            || best().flat_map(|(step, cover)| cover.chosen.iter().map(move |c| (step, c)));
        let describe = |(step, chosen): (usize, &_)| explain::describe(domain, forms, chosen, step);
        self.report.strays = best().map(|(step, cover)| cover.strays(forms, step)).sum();
        support.clear();
        let mut old = self.region.formula().comparison();
        let same = clauses().map(describe).all(|described| {
            described.is_ok_and(|new| {
                let noted = new.evidence.iter().try_for_each(|own| support.push(*own));
                noted.is_ok() && old.next_is(&new.nodes, &new.any_of)
            })
        });
        if same && old.is_at_end() {
            return;
        }
        self.report.certificate = Certificate::default();
        self.report.constraints_left_out = 0;
        support.clear();
        let left_out = &mut self.report.constraints_left_out;
        self.region.rewrite(domain, |formula| {
            for described in clauses().map(describe) {
                let added = described.and_then(|new| {
                    formula.and(&new.nodes, &new.any_of)?;
                    new.evidence.iter().try_for_each(|own| support.push(*own))
                });
                *left_out += usize::from(added.is_err());
            }
        });
    }
}

/// Refines an explanation, and tells how good it is: the least is best.
fn rate<R: Real>(
    cover: &mut Cover<R>,
    forms: &Forms<'_, R>,
    step: usize,
    slack: f64,
    details: &dyn Fn(&Chosen<R>) -> f64,
) -> (bool, f64, f64) {
    cover.refine(forms, step, slack, details);
    let details: f64 = cover.chosen.iter().map(details).sum();
    let bits = cover.bits(forms) + details;
    (!cover.complete, bits, cover.looseness().to_f64())
}
