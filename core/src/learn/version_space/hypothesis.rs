//! Hypotheses: few simple clauses that together exclude every infeasible sample.
//!
//! Fewest is set cover, for which the greedy choice is the best known (Chvatal
//! 1979; Haussler 1988 for conjunctions, and Marchand and Shawe-Taylor's set
//! covering machine). Which of several hypotheses is best is a matter of length:
//! that of its clauses and of what strays from them, in bits (minimum
//! description length, Rissanen 1978).

use super::bound::Bound;
use super::clause::Clause;
use super::disjunction::{best_windows, better_disjunction};
use super::forms::{Forms, SampleSet, StepView, tolerance};
use super::greedy::{Randomisation, best_form};
use crate::random::Generator;
use crate::real::Real;
use crate::table::{Blank, move_last, take_out};
use heapless::Vec;
use rand_core::Rng;

/// Most clauses for one step.
pub(super) const MAX_CLAUSES: usize = 6;

/// Which infeasible samples the clauses exclude together, whichever thresholds are true.
pub(super) struct Overlap {
    /// At least one clause does.
    once: SampleSet,
    /// More than one does.
    pub(super) twice: SampleSet,
    /// None does.
    pub(super) open: SampleSet,
}

/// A conjunction of clauses about one step.
#[derive(Clone, Debug)]
pub struct Hypothesis<R> {
    pub(super) clauses: Vec<Clause<R>, MAX_CLAUSES>,
    /// Whether it excludes all infeasible samples, and, but for strays, no feasible one.
    pub(super) consistent: bool,
    /// Whether it is so short that it may be as true as the best one: others have no vote.
    pub(super) rival: bool,
}

impl<R> Blank for Hypothesis<R> {
    /// It admits everything.
    const BLANK: Self = Hypothesis {
        clauses: Vec::new(),
        consistent: true,
        rival: true,
    };
}

impl<R: Real> Hypothesis<R> {
    /// Makes it admit everything.
    pub(super) fn clear(&mut self) {
        self.clauses.clear();
        (self.consistent, self.rival) = (true, true);
    }

    /// Makes it the same as another, where it lies.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.clauses.clear();
        // There is room: both have the same capacity.
        let _ = self.clauses.extend_from_slice(&other.clauses);
        self.consistent = other.consistent;
    }

    /// Makes it exclude every infeasible sample, by greedy choice of bounds.
    pub(super) fn cover(
        &mut self,
        view: &StepView<'_, '_, R>,
        randomisation: Randomisation,
        slack: f64,
        rng: &mut Generator,
    ) {
        self.clear();
        self.extend(view, randomisation, slack, rng);
    }

    /// Begins as [`Hypothesis::cover`], and leaves the first `simple` clauses, behind which a
    /// disjunction is to come.
    #[inline(never)]
    pub(super) fn begin_disjunction(
        &mut self,
        view: &StepView<'_, '_, R>,
        simple: usize,
        rng: &mut Generator,
    ) {
        self.cover(view, Randomisation::GREEDY, 0.0, rng);
        self.clauses.truncate(simple);
    }

    /// Looks for a better disjunction behind the first `simple` clauses; what is there is worth
    /// so much. Where to look is counted, see [`better_disjunction`]. `false` if there is nothing
    /// more to look at: then bounds follow.
    #[inline(never)]
    pub(super) fn try_disjunction(
        &mut self,
        view: &StepView<'_, '_, R>,
        (simple, place): (usize, usize),
        worth: &mut f64,
        rng: &mut Generator,
    ) -> bool {
        let known = match self.clauses.len() > simple {
            true => self.clauses.pop(),
            false => None,
        };
        let open = self.overlap(view).open;
        let better = better_disjunction(view, &open, place, known.map(|known| (*worth, known)));
        let (found, goes_on) = match better {
            Some(found) => (found, true),
            None => (known.map(|known| (*worth, known)), false),
        };
        if let Some((more, disjunction)) = found {
            *worth = more;
            let _ = self.clauses.push(disjunction);
        }
        if !goes_on {
            self.extend(view, Randomisation::GREEDY, 0.0, rng);
        }
        goes_on
    }

    /// How many of its clauses are disjunctions.
    pub(super) fn disjunctions(&self) -> usize {
        self.clauses.iter().filter(|own| own.or.is_some()).count()
    }

    /// Takes away what follows the first `simple` clauses and a disjunction if that does not
    /// exclude everything: another disjunction is to come there.
    pub(super) fn takes_another_disjunction(&mut self, simple: usize) -> bool {
        let found = self.clauses.get(simple).is_some_and(|own| own.or.is_some());
        let another = found && !self.consistent && simple + 2 < MAX_CLAUSES;
        if another {
            self.clauses.truncate(simple + 1);
        }
        another
    }

    /// As [`Hypothesis::cover`], behind the windows of a single form.
    #[inline(never)]
    pub(super) fn cover_with_windows(&mut self, view: &StepView<'_, '_, R>, rng: &mut Generator) {
        self.clear();
        self.clauses = best_windows(view, &view.infeasible);
        self.extend(view, Randomisation::GREEDY, 0.0, rng);
    }

    /// Adds bounds until everything is excluded, as far as there is room for clauses.
    #[inline(never)]
    fn extend(
        &mut self,
        view: &StepView<'_, '_, R>,
        randomisation: Randomisation,
        slack: f64,
        rng: &mut Generator,
    ) {
        let mut open = self.overlap(view).open;
        while !open.is_empty() && !self.clauses.is_full() {
            let Some(form) = best_form(view, &open, randomisation, rng.next_u32()) else {
                break;
            };
            let clause = Clause::new(Bound::inside(view, form));
            open.subtract(&clause.excluded(view));
            let _ = self.clauses.push(clause);
        }
        self.drop_redundant(view);
        self.refit(view, slack);
    }

    fn drop_redundant(&mut self, view: &StepView<'_, '_, R>) {
        let all = self.overlap(view).once;
        for index in (0..self.clauses.len()).rev() {
            let Some(clause) = take_out(&mut self.clauses, index) else {
                continue;
            };
            if self.overlap(view).once != all && self.clauses.push(clause).is_ok() {
                move_last(&mut self.clauses, index);
            }
        }
    }

    /// What one clause excludes at least, and what more than one does.
    pub(super) fn overlap(&self, view: &StepView<'_, '_, R>) -> Overlap {
        let (mut once, mut twice) = (SampleSet::EMPTY, SampleSet::EMPTY);
        for clause in &self.clauses {
            let both = once.unite(&clause.excluded(view));
            twice.unite(&both);
        }
        let mut open = view.infeasible;
        open.subtract(&once);
        Overlap { once, twice, open }
    }

    /// The bound clause that comes nearest to excluding a sample, by its place.
    pub(super) fn nearest(&self, view: &StepView<'_, '_, R>, sample: usize) -> Option<usize> {
        let all = self.clauses.iter().enumerate();
        let depths = all
            .filter(|(_, clause)| clause.or.is_none())
            .map(|(index, clause)| {
                let bound = &clause.bound;
                let value = view.value(&bound.form, sample);
                ((value - bound.inner) / bound.range, index)
            });
        let finite = depths.filter(|(depth, _)| depth.is_finite());
        let best = finite.reduce(|best, next| if next.0 > best.0 { next } else { best });
        best.map(|(_, index)| index)
    }

    /// Brings the bounds up to date and finds out whether it is still consistent. The
    /// outer end of a bound is at the first infeasible sample that no other clause
    /// excludes.
    #[inline(never)]
    pub(super) fn refit(&mut self, view: &StepView<'_, '_, R>, slack: f64) {
        for clause in &mut self.clauses {
            clause.generalise(view);
        }
        let overlap = self.overlap(view);
        self.consistent = true;
        // What none excludes belongs to the nearest, found before any bound is moved.
        let mut nearest = [SampleSet::EMPTY; MAX_CLAUSES];
        for sample in overlap.open.iter() {
            let index = self.nearest(view, sample);
            match index.and_then(|index| nearest.get_mut(index)) {
                Some(own) => own.insert(sample),
                None => self.consistent = false,
            }
        }
        for (clause, own) in self.clauses.iter_mut().zip(&mut nearest) {
            let mut alone = clause.excluded(view);
            clause.support = alone.len() as u32;
            alone.subtract(&overlap.twice);
            own.unite(&alone);
            self.consistent &= clause.fit(view, own, [slack, f64::INFINITY]);
        }
        for sample in overlap.twice.iter() {
            self.assign(view, sample);
        }
    }

    /// Counts a sample more that its clauses exclude, at which its forms have these values.
    pub(super) fn count(&mut self, value: impl Fn(&Bound<R>) -> R) {
        let beyond = |own: &Bound<R>| {
            let value = value(own);
            value > own.inner + tolerance(value)
        };
        for clause in &mut self.clauses {
            let excluded = clause.bounds().all(beyond);
            clause.support += u32::from(excluded);
        }
    }

    /// Makes sure that one clause excludes a sample for every threshold between
    /// its bounds: that for which it lies farthest out.
    fn assign(&mut self, view: &StepView<'_, '_, R>, sample: usize) {
        let mut farthest: Option<(R, &mut Clause<R>)> = None;
        for clause in &mut self.clauses {
            let mut depth = R::INFINITY;
            let mut outside = true;
            for bound in clause.bounds() {
                let value = view.value(&bound.form, sample);
                outside &= value >= bound.outer;
                depth = depth.min((value - bound.inner) / bound.range);
            }
            if outside {
                return;
            }
            if farthest.as_ref().is_none_or(|(most, _)| depth > *most) {
                farthest = Some((depth, clause));
            }
        }
        let Some((_, clause)) = farthest else { return };
        for bound in clause.bounds_mut() {
            bound.outer = bound.outer.min(view.value(&bound.form, sample));
        }
    }

    /// The length of its description in bits, without names for its thresholds.
    pub(super) fn length(&self, forms: &Forms<'_, R>) -> f64 {
        let lengths = self.clauses.iter().enumerate().map(|(index, clause)| {
            let before = self.clauses.get(..index).unwrap_or(&[]);
            clause.length(forms, [before, &[]])
        });
        lengths.sum()
    }

    /// Whether it admits a sample.
    pub(super) fn admits(&self, view: &StepView<'_, '_, R>, sample: usize) -> bool {
        let tuning = view.forms.tuning();
        let holds = |bound: &Bound<R>| view.value(&bound.form, sample) <= bound.threshold(tuning);
        let mut clauses = self.clauses.iter();
        clauses.all(|clause| clause.bounds().any(holds))
    }

    /// The samples that it is wrong about.
    pub(super) fn wrong(&self, view: &StepView<'_, '_, R>) -> impl Iterator<Item = usize> {
        let admits = move |sample: &usize| self.admits(view, *sample);
        let admitted = view.infeasible.iter().filter(admits);
        let missed = view.feasible.iter().filter(move |sample| !admits(sample));
        admitted.chain(missed)
    }

    /// Whether it speaks of a form, by its place among the forms.
    pub(super) fn uses(&self, form: u32) -> bool {
        let mut bounds = self.clauses.iter().flat_map(Clause::bounds);
        bounds.any(|bound| bound.form.index() == form)
    }

    /// Whether samples stray from its bounds.
    pub(super) fn is_strained(&self) -> bool {
        let mut bounds = self.clauses.iter().flat_map(Clause::bounds);
        bounds.any(|bound| bound.strain > R::ZERO)
    }

    /// The width of all gaps together.
    pub(super) fn looseness(&self) -> R {
        let bounds = self.clauses.iter().flat_map(Clause::bounds);
        bounds.fold(R::ZERO, |sum, bound| sum + (bound.outer - bound.inner))
    }
}
