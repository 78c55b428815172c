//! Model selection: repairing hypotheses, and selecting the shortest.

use super::committee::Committee;
use super::describe::{self, Description};
use super::forms::{Effort, Forms, StepView};
use super::greedy::Randomisation;
use super::hypothesis::Hypothesis;
use super::improve::Objective;
use super::{Certificate, Evidence, VersionSpace};
use crate::domain::Domain;
use crate::error::Error;
use crate::random::Generator;
use crate::real::Real;
use crate::table::{Blank, Table};

/// When the best hypotheses were selected last.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Selection {
    /// Whether they still hold.
    pub(super) current: bool,
    /// How long they were, in bits.
    length: f64,
    /// How many samples there were.
    samples: usize,
}

impl<R: Real> VersionSpace<'_, R> {
    /// Replaces the members of the committee that are no longer consistent, except for the
    /// best ones. They must agree with every answer: they are there to doubt, and one that
    /// could bend to an answer would ask for it again.
    #[inline(never)]
    pub(super) fn repair(&mut self) {
        let tuning = self.config.tuning;
        for (step, (best, others)) in self.committee.steps_mut() {
            let view = StepView::new(&self.forms, step);
            let most = best.length(&self.forms) + tuning.rival;
            for (member, hypothesis) in others.iter_mut().enumerate() {
                hypothesis.refit(&view, 0.0);
                if !hypothesis.consistent {
                    let randomisation = Randomisation::of_member(member + 1, tuning);
                    hypothesis.cover(&view, randomisation, 0.0, &mut self.rng);
                }
                hypothesis.rival = hypothesis.length(&self.forms) <= most;
            }
        }
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

    /// Whether the best hypotheses became so long that there may be shorter ones.
    pub(super) fn is_doubtful(&self) -> bool {
        let tuning = self.config.tuning;
        let new = self.forms.samples() - self.selection.samples;
        let longer = self.committee.length(&self.forms) > self.selection.length + tuning.growth;
        longer && new > self.selection.samples / (tuning.patience as usize).max(1)
    }

    /// Whether the best hypotheses are so much shorter than the answers that they
    /// are no accident: answers by chance have no short explanation, except for one
    /// of 2^[`significance`](super::Tuning::significance) (minimum description length,
    /// Rissanen 1978).
    pub(super) fn is_significant(&self) -> bool {
        let steps = 0..self.capacity.steps;
        let answers = steps.map(|step| {
            let view = StepView::new(&self.forms, step);
            let feasible = view.feasible.len() as f64;
            let infeasible = view.infeasible.len() as f64;
            let length = |own: f64| own * libm::log2((feasible + infeasible) / own.max(1.0));
            length(feasible) + length(infeasible)
        });
        let significance = self.config.tuning.significance;
        answers.sum::<f64>() >= self.committee.length(&self.forms) + significance
    }

    /// Selects the best hypotheses anew and makes the region of them.
    #[inline(never)]
    pub(super) fn reselect(&mut self, domain: &Domain<'_>) {
        self.select(domain);
        let tuning = self.config.tuning;
        for (effort, short) in [
            (Effort::Simple, tuning.short),
            (Effort::Thorough, tuning.short_sums),
        ] {
            if self.find_sums(domain, effort, short) {
                self.select(domain);
            }
        }
        self.selection = Selection {
            current: true,
            length: self.committee.length(&self.forms),
            samples: self.forms.samples(),
        };
        self.rebuild_region(domain);
    }

    /// Repairs the committee and puts the shortest hypotheses first.
    #[inline(never)]
    fn select(&mut self, domain: &Domain<'_>) {
        self.repair();
        let (forms, committee) = (&self.forms, &mut self.committee);
        select(domain, forms, committee, self.config.slack, &mut self.rng);
    }

    /// Looks for sums for each step of which the best hypothesis is not short enough, in bits,
    /// or samples stray from it.
    /// Tells whether there is such a step.
    #[inline(never)]
    fn find_sums(&mut self, domain: &Domain<'_>, effort: Effort, short: f64) -> bool {
        if self.capacity.sums() == 0 {
            return false;
        }
        let committee = &self.committee;
        let mut found = false;
        for (step, best) in committee.best().enumerate() {
            let agrees = best.consistent && !best.is_strained();
            if agrees && best.length(&self.forms) <= short {
                continue;
            }
            found = true;
            let used = |form| committee.uses(form);
            self.forms.find_sums(domain, step, effort, &used);
        }
        found
    }

    /// Counts again how many samples support each constraint of the region.
    pub(super) fn count_support(&mut self, domain: &Domain<'_>) {
        if self.report.constraints_left_out > 0 {
            return self.rebuild_region(domain);
        }
        let counts = self
            .committee
            .best_bounds()
            .map(|(clause, _)| clause.support);
        for (evidence, count) in self.evidence.as_mut_slice().iter_mut().zip(counts) {
            evidence.support = count;
        }
    }

    /// Writes the region of the best hypotheses, unless it is there already, and what
    /// supports its constraints. One that finds no room is left out and counted.
    #[inline(never)]
    pub(super) fn rebuild_region(&mut self, domain: &Domain<'_>) {
        self.report.strays = 0;
        for (step, best) in self.committee.best().enumerate() {
            self.report.strays += best.strays(&StepView::new(&self.forms, step));
        }
        if !self.is_written(domain) {
            self.report.certificate = Certificate::default();
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
        for (step, clause) in self.committee.best_clauses() {
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
        self.region.rewrite(domain, |formula| {
            for (step, clause) in self.committee.best_clauses() {
                let described = new.describe(domain, &self.forms, clause, step);
                let added = described
                    .and_then(|()| formula.and(&new.nodes, &new.any_of))
                    .and_then(|()| note(&mut self.evidence, &new.evidence));
                self.report.constraints_left_out += usize::from(added.is_err());
            }
        });
    }
}

fn note(evidence: &mut Table<'_, Evidence>, own: &[Evidence]) -> Result<(), Error> {
    own.iter().try_for_each(|own| evidence.push(*own))
}

/// Puts the shortest of several improved hypotheses in the place of the best of
/// each step.
#[inline(never)]
fn select<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    committee: &mut Committee<'_, R>,
    slack: f64,
    rng: &mut Generator,
) {
    let tuning = forms.tuning();
    let (candidates, disjunctions) = (tuning.candidates as usize, tuning.disjunctions as usize);
    let naming = |clause: &_| describe::naming_length(domain, forms, clause);
    let objective = Objective {
        slack,
        naming: &naming,
    };
    let mut other = Hypothesis::BLANK;
    for (step, (best, others)) in committee.steps_mut() {
        let view = StepView::new(forms, step);
        let mut least = rate(best, &view, &objective);
        for candidate in 0..candidates + disjunctions {
            let (inconsistent, length, _) = least;
            match (others.get(candidate), candidate.checked_sub(candidates)) {
                (Some(known), _) => other.copy_from(known),
                (None, None) => {
                    let randomisation = Randomisation::of_member(candidate, tuning);
                    other.cover(&view, randomisation, 0.0, rng);
                }
                (None, Some(simple)) if inconsistent || length > tuning.disjunctions_beyond => {
                    other.cover_with_disjunction(&view, simple, rng);
                }
                _ => break,
            }
            if other.consistent {
                let rating = rate(&mut other, &view, &objective);
                if rating < least {
                    best.copy_from(&other);
                    least = rating;
                }
            }
        }
    }
}

/// Improves a hypothesis, and tells how good it is: the least is best.
fn rate<R: Real>(
    hypothesis: &mut Hypothesis<R>,
    view: &StepView<'_, '_, R>,
    objective: &Objective<'_, R>,
) -> (bool, f64, f64) {
    hypothesis.improve(view, objective);
    let length = objective.length(hypothesis, view);
    (
        !hypothesis.consistent,
        length,
        hypothesis.looseness().to_f64(),
    )
}
