//! The committee: hypotheses of each step that are consistent with the answers, or were.

use super::bound::Bound;
use super::clause::Clause;
use super::forms::Forms;
use super::hypothesis::Hypothesis;
use crate::real::Real;

/// Hypotheses of one step.
pub(super) const MEMBERS: usize = 8;

/// For each step the best hypothesis that is known and others, chosen with some chance, to
/// doubt it. The members of one place in all steps vote together, about the sequence.
#[derive(Debug)]
pub(super) struct Committee<'m, R> {
    /// [`MEMBERS`] for each step, the best one first.
    hypotheses: &'m mut [Hypothesis<R>],
}

/// Which members expect a sample to work, and which do not; a bit for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Votes {
    in_favour: u8,
    against: u8,
}

/// The committee as the answers to the open questions will divide it: members that expect the
/// same of all of them survive together. A question is worth as much as it divides what any of
/// the answers leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branches([u8; MEMBERS]);

impl Branches {
    /// No question is open.
    pub(super) const ONE: Branches = Branches([u8::MAX, 0, 0, 0, 0, 0, 0, 0]);

    /// Divides each by what its members expect of one more question.
    pub(super) fn split(&mut self, votes: Votes) {
        let mut new = [0; MEMBERS];
        let sides = [votes.in_favour, votes.against];
        let parts = self.0.iter().flat_map(|own| sides.map(|side| own & side));
        // There are no more than members.
        for (slot, part) in new.iter_mut().zip(parts.filter(|part| *part != 0)) {
            *slot = part;
        }
        self.0 = new;
    }

    /// How evenly votes split the members of each: zero if all agree.
    pub(super) fn disagreement(&self, votes: Votes) -> u32 {
        let own = |branch: &u8| {
            (branch & votes.in_favour).count_ones() * (branch & votes.against).count_ones()
        };
        self.0.iter().map(own).sum()
    }
}

impl<'m, R: Real> Committee<'m, R> {
    /// A committee of hypotheses that admit everything.
    pub(super) fn new(hypotheses: &'m mut [Hypothesis<R>]) -> Self {
        let mut committee = Committee { hypotheses };
        committee.clear();
        committee
    }

    /// Makes all admit everything.
    pub(super) fn clear(&mut self) {
        self.hypotheses.iter_mut().for_each(Hypothesis::clear);
    }

    /// The best hypothesis of each step.
    pub(super) fn best(&self) -> impl Iterator<Item = &Hypothesis<R>> {
        self.hypotheses.iter().step_by(MEMBERS)
    }

    /// That of one step.
    pub(super) fn best_of(&self, step: usize) -> Option<&Hypothesis<R>> {
        self.hypotheses.get(step * MEMBERS)
    }

    /// The clauses of the best hypotheses, each with its step.
    pub(super) fn best_clauses(&self) -> impl Iterator<Item = (usize, &Clause<R>)> {
        let all = self.best().enumerate();
        all.flat_map(|(step, best)| best.clauses.iter().map(move |clause| (step, clause)))
    }

    /// The bounds of the best hypotheses, each with its clause.
    pub(super) fn best_bounds(&self) -> impl Iterator<Item = (&Clause<R>, &Bound<R>)> {
        self.best_clauses()
            .flat_map(|(_, clause)| clause.bounds().map(move |bound| (clause, bound)))
    }

    /// For each step the best hypothesis and the others, to change.
    pub(super) fn steps_mut(
        &mut self,
    ) -> impl Iterator<Item = (usize, (&mut Hypothesis<R>, &mut [Hypothesis<R>]))> {
        let steps = self.hypotheses.chunks_mut(MEMBERS);
        let split = steps.map(<[_]>::split_first_mut);
        split.flatten().enumerate()
    }

    /// A bit for each left side that some hypothesis speaks of.
    pub(super) fn lefts(&self) -> u128 {
        let clauses = self.hypotheses.iter().flat_map(|own| &own.clauses);
        let bounds = clauses.flat_map(Clause::bounds);
        bounds.fold(0, |all, bound| all | 1 << (bound.form.lhs % 128))
    }

    /// Whether a hypothesis speaks of a form, by its place among the forms.
    pub(super) fn uses(&self, form: u32) -> bool {
        self.hypotheses.iter().any(|own| own.uses(form))
    }

    /// Whether the best hypotheses are consistent with all answers.
    pub(super) fn is_consistent(&self) -> bool {
        self.best().all(|best| best.consistent)
    }

    /// Whether samples stray from the best hypotheses.
    pub(super) fn is_strained(&self) -> bool {
        self.best().any(Hypothesis::is_strained)
    }

    /// The length of the best hypotheses in bits.
    pub(super) fn length(&self, forms: &Forms<'_, R>) -> f64 {
        self.best().map(|best| best.length(forms)).sum()
    }

    /// How the members vote on a sample at which forms have these values. The best
    /// hypotheses vote only if they agree with every answer: one that can bend to an answer
    /// would ask for it again. The others vote only if they are rivals of the best.
    pub(super) fn vote(&self, value: impl Fn(&Bound<R>) -> R) -> Votes {
        let half = R::from_f64(0.5);
        let holds = |bound: &Bound<R>| bound.position(value(bound)) < half;
        let agrees = |hypothesis: &Hypothesis<R>| {
            let mut clauses = hypothesis.clauses.iter();
            clauses.all(|clause| clause.bounds().any(holds))
        };
        let strained = self.best_bounds().any(|(_, bound)| bound.strain > R::ZERO);
        let (mut in_favour, mut against) = (0, 0);
        for member in usize::from(strained)..MEMBERS {
            let own = || self.hypotheses.iter().skip(member).step_by(MEMBERS);
            if member > 0 && !own().all(|hypothesis| hypothesis.rival) {
                continue;
            }
            if own().all(agrees) {
                in_favour |= 1 << member;
            } else {
                against |= 1 << member;
            }
        }
        Votes { in_favour, against }
    }
}
