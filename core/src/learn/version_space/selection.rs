//! Model selection: repairing hypotheses, and selecting the shortest.

use super::clause::Clause;
use super::committee::Committee;
use super::describe::{self, Description};
use super::forms::{Forms, StepView};
use super::greedy::Randomisation;
use super::hypothesis::Hypothesis;
use super::improve::Objective;
use super::{Certificate, Evidence, Step, VersionSpace};
use crate::domain::Domain;
use crate::error::Error;
use crate::real::Real;
use crate::table::{Blank, Table};

/// Up to so many samples flatter a region that is chosen by them as [`Tuning::optimism`] says.
///
/// [`Tuning::optimism`]: super::Tuning::optimism
const FLATTERED: f64 = 128.0;

/// With more samples fewer hypotheses compete: each takes longer, and there is less choice.
pub(super) const MANY: usize = 256;

/// When the best hypotheses were selected last.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Selection {
    /// Whether they still hold.
    pub(super) current: bool,
    /// How long they were, in bits.
    length: f64,
    /// How many samples there were.
    samples: usize,
    /// Between how many answers it was done.
    pub(super) slices: u32,
    /// Whether the last phase can begin with them.
    pub(super) last: bool,
}

impl Selection {
    /// Whether the best hypotheses still hold, and were selected by so many samples.
    pub(super) fn is_of(&self, samples: usize) -> bool {
        self.current && self.samples == samples
    }
}

impl<R: Real> VersionSpace<'_, R> {
    /// Whether there are so many more samples than at the last selection that there may be
    /// a better one, where nobody asks.
    pub(super) fn has_grown(&self) -> bool {
        let growth = self.config.tuning.observed_growth;
        let samples = self.forms.samples() as f64;
        // A region that is wrong about some answers is not refuted by a few more.
        let often = match self.approximating {
            true => growth * growth,
            false => growth,
        };
        samples >= often * self.selection.samples as f64 && samples >= growth * growth
    }

    /// Selects the best hypotheses after an answer was told, and remembers that.
    pub(super) fn select_again(&mut self, domain: &Domain<'_>) {
        self.reseed(Step::Conclude);
        self.since.concluded = true;
        self.reselect(domain);
    }

    /// Replaces the members of the committee that are no longer consistent, except for the
    /// best ones, until so much was done since the last answer; those that are left have no
    /// vote. They must agree with every answer: they are there to doubt, and one that
    /// could bend to an answer would ask for it again. Tells whether none is left.
    #[inline(never)]
    pub(super) fn repair(&mut self, most: u32) -> bool {
        let tuning = self.config.tuning;
        let mut all = true;
        for (step, (best, others)) in self.committee.steps_mut() {
            let view = StepView::new(&self.forms, step);
            let longest = best.length(&self.forms) + tuning.rival;
            for (member, hypothesis) in others.iter_mut().enumerate() {
                hypothesis.refit(&view, 0.0);
                if !hypothesis.consistent && self.forms.work() < most {
                    let randomisation = Randomisation::of_member(member + 1, tuning);
                    hypothesis.cover(&view, randomisation, 0.0, &mut self.rng);
                } else if !hypothesis.consistent {
                    (all, hypothesis.rival) = (false, false);
                    continue;
                }
                // Not all sums that it takes may be known, or there are too many clauses.
                let short = hypothesis.length(&self.forms) <= longest;
                hypothesis.rival = hypothesis.consistent && short;
            }
        }
        all
    }

    /// Brings the best hypothesis of each step up to date, the shortest of all
    /// that are known. Tells whether one of their bounds moved.
    #[inline(never)]
    pub(super) fn repair_best(&mut self) -> bool {
        let slack = self.config.slack;
        let (mut before, mut moved) = (Hypothesis::BLANK, false);
        for (step, (best, others)) in self.committee.steps_mut() {
            let view = StepView::new(&self.forms, step);
            before.copy_from(best);
            best.refit(&view, slack);
            if best.consistent {
                let pairs = best.clauses.iter().zip(&before.clauses);
                moved |= pairs.into_iter().any(|(new, old)| new.is_elsewhere(old));
                continue;
            }
            (self.selection.current, moved) = (false, true);
            self.selection.last = false;
            best.cover(&view, Randomisation::GREEDY, slack, &mut self.rng);
            for other in others {
                other.refit(&view, 0.0);
                let shorter = other.length(&self.forms) < best.length(&self.forms);
                if other.consistent && (shorter || !best.consistent) {
                    core::mem::swap(best, other);
                }
            }
        }
        moved
    }

    /// Whether the best hypotheses became so long that there may be shorter ones. Where late in a
    /// run nothing explains the answers, that is looked for in larger steps.
    pub(super) fn is_doubtful(&self) -> bool {
        let tuning = self.config.tuning;
        let new = self.forms.samples() - self.selection.samples;
        let longer = self.committee.length(&self.forms) > self.selection.length + tuning.growth;
        let patient = new > self.selection.samples / (tuning.patience as usize).max(1);
        longer && patient && !self.is_late_and_unexplained()
    }

    /// Whether a region that explains most answers is looked for now, or again.
    pub(super) fn is_time_to_approximate(&self) -> bool {
        let enough = (1.0 + self.config.tuning.batch) * self.selection.samples as f64;
        self.forms.samples() as f64 > enough && self.is_late_and_unexplained()
    }

    /// Whether what explains most answers is good enough by now, because nothing explains all.
    pub(super) fn is_late_and_unexplained(&self) -> bool {
        let told = self.observations.len() as f64;
        let late = told >= self.config.tuning.give_up * f64::from(self.config.calls);
        late && (self.approximating || !self.is_explained())
    }

    /// Whether the best hypotheses are so much shorter than the answers that they
    /// are no accident: answers by chance have no short explanation, except for one
    /// of 2^[`significance`](super::Tuning::significance) (minimum description length,
    /// Rissanen 1978).
    pub(super) fn is_significant(&self) -> bool {
        self.significance() >= 0.0
    }

    /// By how many bits the best hypotheses are shorter than they must be for that.
    pub(super) fn significance(&self) -> f64 {
        let own = self.committee.length(&self.forms) + self.config.tuning.significance;
        self.entropy() - own
    }

    /// How many bits there are in the answers.
    pub(super) fn entropy(&self) -> f64 {
        let steps = 0..self.capacity.steps;
        let answers = steps.map(|step| entropy(&StepView::new(&self.forms, step)));
        answers.sum::<f64>()
    }

    /// Selects with little effort, while observations come in: the best hypotheses are repaired
    /// and improved, but nothing else is looked for.
    #[inline(never)]
    pub(super) fn reselect_quickly(&mut self, domain: &Domain<'_>) {
        self.repair_best();
        improve_best(domain, &self.forms, &mut self.committee, self.config.slack);
        self.finish_selection(domain, false);
    }

    /// Notes when the best hypotheses were selected, thoroughly or not, and writes the region.
    pub(super) fn finish_selection(&mut self, domain: &Domain<'_>, thorough: bool) {
        self.selection = Selection {
            // Answers that came meanwhile may say otherwise.
            current: thorough && self.selection.current,
            length: self.committee.length(&self.forms),
            samples: match thorough {
                true => self.work.begun,
                false => self.forms.samples(),
            },
            slices: match thorough {
                true => self.work.slices,
                false => self.selection.slices,
            },
            ..self.selection
        };
        self.approximate(thorough);
        self.rebuild_region(domain);
        self.judge_by_log();
    }

    /// Whether so much was told that what does not agree with it is not worth a longer search:
    /// some of it is wrong.
    pub(super) fn is_hopeless(&self) -> bool {
        let many = self.report.observed > 0 && self.forms.samples() > MANY;
        many && !self.committee.is_consistent()
    }

    /// Looks for a region that explains most answers, if it is time for that and there is
    /// none that explains all in few words.
    #[inline(never)]
    fn approximate(&mut self, thorough: bool) {
        let tuning = self.config.tuning;
        let told = self.observations.len() as f64;
        let early = told < tuning.give_up * f64::from(self.config.calls);
        let length = self.committee.length(&self.forms);
        let explained = self.is_explained();
        self.approximating = false;
        // A long explanation, or that of a log, is compared with one that takes some answers for
        // wrong ones, late.
        let long = length > tuning.long || (thorough && self.report.observed > 0);
        let doubtful = long && self.calls_left() <= self.judge_from();
        if early || self.unasked.is_some() || !self.influence || (explained && !doubtful) {
            return;
        }
        let wanted = self.wanted_of_chosen();
        let aside = self.forms.aside();
        let mut robust = 0.0;
        for (step, own) in self.approximations.iter_mut().enumerate() {
            let view = || StepView::new(&self.forms, step);
            own.approximate(&view().without(&aside), wanted);
            robust += own.robust_length(&view());
        }
        // As for an exact one, it is no accident only if it is shorter than the answers.
        let significant = robust + tuning.significance <= self.entropy();
        self.approximating = significant && (!explained || robust < length);
    }

    /// Which share of the samples that a region is chosen by must work there. The more there
    /// are of them, the less they flatter it.
    fn wanted_of_chosen(&self) -> f64 {
        let flattered = (FLATTERED / self.forms.samples().max(1) as f64).min(1.0);
        let wanted = self.config.precision_wanted;
        match self.certifying {
            true => self.wanted,
            false => wanted + flattered * (self.wanted - wanted),
        }
    }

    /// Judges the region by what was put aside of a log, if it is wrong about some answers:
    /// nobody chose that by the region, nor the region by that.
    #[inline(never)]
    fn judge_by_log(&mut self) {
        let aside = self.forms.aside();
        if !self.approximating || aside.is_empty() {
            return;
        }
        let last = StepView::new(&self.forms, self.capacity.steps - 1);
        let (mut draws, mut worked, mut found) = (0, 0, 0);
        for sample in aside.iter() {
            let feasible = last.feasible.contains(sample);
            let inside = self.shown().all(|own| own.admits(&last, sample));
            draws += u32::from(inside);
            worked += u32::from(inside && feasible);
            found += u32::from(feasible);
        }
        if draws > self.report.certificate.draws {
            self.report.certificate = Certificate::new(draws, worked, self.config.confidence);
            (self.report.found, self.report.inside) = (found, worked);
        }
    }

    /// How many samples the hypotheses of all steps are wrong about.
    pub(super) fn count_wrong<'h>(
        &self,
        hypotheses: impl Iterator<Item = &'h Hypothesis<R>>,
    ) -> usize
    where
        R: 'h,
    {
        let wrong = hypotheses.enumerate().map(|(step, own)| {
            let view = StepView::new(&self.forms, step);
            own.wrong(&view).count()
        });
        wrong.sum()
    }

    /// The hypothesis of each step that makes the region.
    pub(super) fn shown(&self) -> impl Iterator<Item = &Hypothesis<R>> {
        shown(&self.committee, self.approximations, self.approximating)
    }

    /// The clauses that make the region, each with its step.
    pub(super) fn shown_clauses(&self) -> impl Iterator<Item = (usize, &Clause<R>)> {
        with_steps(self.shown())
    }

    /// Counts again how many samples support each constraint of the region.
    pub(super) fn count_support(&mut self, domain: &Domain<'_>) {
        if self.report.constraints_left_out > 0 {
            return self.rebuild_region(domain);
        }
        let shown = shown(&self.committee, self.approximations, self.approximating);
        let counts = with_steps(shown).flat_map(|(_, own)| own.said().map(|_| own.support));
        for (evidence, count) in self.evidence.as_mut_slice().iter_mut().zip(counts) {
            evidence.support = count;
        }
    }

    /// Writes the region of the best hypotheses, unless it is there already, and what
    /// supports its constraints. One that finds no room is left out and counted.
    #[inline(never)]
    pub(super) fn rebuild_region(&mut self, domain: &Domain<'_>) {
        self.report.strays = self.count_wrong(self.shown());
        if !self.is_written(domain) {
            self.report.certificate = Certificate::default();
            (self.report.found, self.report.inside) = (0, 0);
            self.outdate_draws();
            self.write_region(domain);
        }
    }

    /// Whether the region is that of the best hypotheses. Notes what supports its
    /// constraints.
    #[inline(never)]
    fn is_written(&mut self, domain: &Domain<'_>) -> bool {
        let mut new = Description::default();
        let mut old = self.region.formula().comparison();
        self.evidence.clear();
        let shown = shown(&self.committee, self.approximations, self.approximating);
        for (step, clause) in with_steps(shown) {
            let described = new.describe(domain, &self.forms, clause, step);
            let noted = described.and_then(|()| note(&mut self.evidence, &new.evidence));
            if noted.is_err() || !old.next_is(&new.nodes, &new.any_of) {
                return false;
            }
        }
        old.is_at_end()
    }

    #[inline(never)]
    fn write_region(&mut self, domain: &Domain<'_>) {
        let mut new = Description::default();
        self.report.constraints_left_out = 0;
        self.evidence.clear();
        let shown = shown(&self.committee, self.approximations, self.approximating);
        self.region.rewrite(domain, |formula| {
            for (step, clause) in with_steps(shown) {
                let described = new.describe(domain, &self.forms, clause, step);
                let added = described
                    .and_then(|()| formula.and(&new.nodes, &new.any_of))
                    .and_then(|()| note(&mut self.evidence, &new.evidence));
                self.report.constraints_left_out += usize::from(added.is_err());
            }
        });
    }
}

/// The hypothesis of each step that makes the region.
fn shown<'h, R: Real>(
    committee: &'h Committee<'_, R>,
    approximations: &'h [Hypothesis<R>],
    approximating: bool,
) -> impl Iterator<Item = &'h Hypothesis<R>> {
    let best = committee.best().take_while(move |_| !approximating);
    best.chain(approximations.iter().take_while(move |_| approximating))
}

/// The clauses of the hypotheses of each step that say something.
fn with_steps<'h, R: Real>(
    hypotheses: impl Iterator<Item = &'h Hypothesis<R>>,
) -> impl Iterator<Item = (usize, &'h Clause<R>)> {
    let steps = hypotheses.enumerate();
    let clauses = steps.flat_map(|(step, own)| own.clauses.iter().map(move |own| (step, own)));
    clauses.filter(|(_, clause)| clause.said().next().is_some())
}

fn note(evidence: &mut Table<'_, Evidence>, own: &[Evidence]) -> Result<(), Error> {
    own.iter().try_for_each(|own| evidence.push(*own))
}

/// How many bits there are in the answers about a step.
pub(super) fn entropy<R: Real>(view: &StepView<'_, '_, R>) -> f64 {
    let feasible = view.feasible.len() as f64;
    let infeasible = view.infeasible.len() as f64;
    let length = |own: f64| own * libm::log2((feasible + infeasible) / own.max(1.0));
    length(feasible) + length(infeasible)
}

/// Improves the best hypothesis of each step.
#[inline(never)]
fn improve_best<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    committee: &mut Committee<'_, R>,
    slack: f64,
) {
    let naming = |clause: &_| describe::naming_length(domain, forms, clause);
    let objective = Objective {
        slack,
        naming: &naming,
    };
    for (step, (best, _)) in committee.steps_mut() {
        best.improve(&StepView::new(forms, step), &objective);
    }
}

#[cfg(test)]
mod tests {
    use super::super::bound::Bound;
    use super::super::forms::DirectedForm;
    use super::*;
    use crate::table::Blank;

    #[test]
    fn a_clause_that_admits_everything_is_no_part_of_a_region() {
        let bound = |inner| Bound::new(DirectedForm::default(), inner, f64::INFINITY, 1.0);
        let mut hypothesis = Hypothesis::BLANK;
        for [inner, or] in [[f64::INFINITY; 2], [1.0, f64::INFINITY], [1.0, 2.0]] {
            let clause = Clause::any_of(bound(inner), bound(or));
            hypothesis.clauses.push(clause).unwrap();
        }
        let mut shown = with_steps(core::iter::once(&hypothesis));
        assert_eq!(shown.next(), Some((0, &hypothesis.clauses[2])));
        assert_eq!(shown.next(), None);
    }
}
