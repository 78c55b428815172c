//! Local search for a shorter hypothesis: clauses are replaced one by one, or left out.

use super::bound::Bound;
use super::clause::Clause;
use super::forms::{SampleSet, StepView};
use super::hypothesis::{Hypothesis, MAX_CLAUSES, Overlap};
use crate::real::Real;
use crate::table::{Blank, take_out};

/// By how many bits a hypothesis must be shorter to replace another: more than rounding.
const SHORTER: f64 = 1e-6;

/// What makes one hypothesis better than another.
pub(super) struct Objective<'o, R> {
    /// How far instances may stray, see [`Config::slack`](super::Config::slack).
    pub(super) slack: f64,
    /// The length of the names of a clause's thresholds, beyond [`Clause::length`], in bits.
    pub(super) naming: &'o dyn Fn(&Clause<R>) -> f64,
}

impl<R: Real> Objective<'_, R> {
    /// The length of a hypothesis with names for its thresholds, in bits.
    pub(super) fn length(&self, hypothesis: &Hypothesis<R>, view: &StepView<'_, '_, R>) -> f64 {
        let naming: f64 = hypothesis.clauses.iter().map(self.naming).sum();
        hypothesis.length(view.forms) + naming
    }

    /// How good a hypothesis is: the least is best.
    pub(super) fn rate(
        &self,
        hypothesis: &Hypothesis<R>,
        view: &StepView<'_, '_, R>,
    ) -> (bool, f64, f64) {
        (
            !hypothesis.consistent,
            self.length(hypothesis, view),
            hypothesis.looseness().to_f64(),
        )
    }
}

/// How far a hypothesis is improved: clause by clause, in rounds until nothing changes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Improving {
    round: u8,
    /// The next clause.
    index: u8,
    /// Whether one was replaced in this round.
    replaced: bool,
}

impl Improving {
    /// Replaces the next clause by a better one, if there is one, or ends a round. Tells
    /// whether all is done.
    pub(super) fn advance<R: Real>(
        &mut self,
        own: &mut Hypothesis<R>,
        view: &StepView<'_, '_, R>,
        objective: &Objective<'_, R>,
    ) -> bool {
        let index = usize::from(self.index);
        if index < own.clauses.len() {
            let better = own.better(view, index, objective);
            if let (Some(better), Some(slot)) = (better, own.clauses.get_mut(index)) {
                self.replaced = true;
                *slot = better;
            }
            self.index += 1;
            return false;
        }
        if self.replaced {
            own.refit(view, objective.slack);
        }
        let shortened = own.shorten(view, objective);
        let goes_on = self.replaced || shortened;
        *self = Improving {
            round: self.round + 1,
            ..Improving::default()
        };
        !goes_on || usize::from(self.round) >= MAX_CLAUSES
    }
}

impl<R: Real> Hypothesis<R> {
    /// Looks for a shorter one nearby: replaces clauses by better ones, and leaves out those
    /// that others nearly make superfluous.
    pub(super) fn improve(&mut self, view: &StepView<'_, '_, R>, objective: &Objective<'_, R>) {
        let mut improving = Improving::default();
        while !improving.advance(self, view, objective) {}
    }

    /// The best clause for the place of one, if that is not the best.
    #[inline(never)]
    fn better(
        &self,
        view: &StepView<'_, '_, R>,
        index: usize,
        objective: &Objective<'_, R>,
    ) -> Option<Clause<R>> {
        let forms = view.forms;
        let (before, rest) = self.clauses.split_at_checked(index)?;
        let (old, behind) = rest.split_first()?;
        let others = [before, behind];
        let alone = self.alone(view, (index, old), &self.overlap(view));
        let needed = (forms.tuning().replacement * alone.len() as f64) as u32;
        let naming = objective.naming;
        let mut best = *old;
        let mut least = old.length(forms, others) + naming(old) - SHORTER;
        view.for_each_count(&alone, &mut |form, count| {
            if count < needed {
                return;
            }
            view.note_length();
            let mut new = Clause::new(Bound::new(form, R::INFINITY, R::INFINITY, R::ZERO));
            let shortest = new.length(forms, others) - forms.threshold_length();
            if shortest >= least {
                return;
            }
            new.bound.inner = view.last_feasible(&form);
            // How far the form ranges only matters for samples on the wrong side, of which each
            // instance costs something.
            let most = least - shortest;
            if count as usize != alone.len() {
                if most <= forms.tuning().stray {
                    return;
                }
                new.bound.range = view.range(&form);
            }
            if new.fit(view, &alone, [objective.slack, most]) {
                let mut length = new.length(forms, others);
                if length - forms.threshold_length() < least {
                    new.bound.range = view.range(&form);
                    length += naming(&new);
                    if length < least {
                        (best, least) = (new, length);
                    }
                }
            }
        });
        old.for_each_neighbour(forms, |pair| {
            if let Some(new) = Clause::between(view, pair, &alone) {
                let length = new.length(forms, others) + naming(&new);
                if length < least {
                    (best, least) = (new, length);
                }
            }
        });
        (best != *old).then_some(best)
    }

    /// The infeasible samples that only this clause can exclude: those that only
    /// it does, and those that none does but that are nearest to it.
    fn alone(
        &self,
        view: &StepView<'_, '_, R>,
        (index, clause): (usize, &Clause<R>),
        overlap: &Overlap,
    ) -> SampleSet {
        let mut alone = clause.excluded(view);
        alone.subtract(&overlap.twice);
        for sample in overlap.open.iter() {
            if self.nearest(view, sample) == Some(index) {
                alone.insert(sample);
            }
        }
        alone
    }

    #[inline(never)]
    fn shorten(&mut self, view: &StepView<'_, '_, R>, objective: &Objective<'_, R>) -> bool {
        let mut other = Hypothesis::BLANK;
        let mut shortened = false;
        for index in (0..self.clauses.len()).rev() {
            other.copy_from(self);
            take_out(&mut other.clauses, index);
            other.refit(view, objective.slack);
            let shorter = objective.length(&other, view) < objective.length(self, view) - SHORTER;
            if other.consistent && shorter {
                self.copy_from(&other);
                shortened = true;
            }
        }
        shortened
    }
}
