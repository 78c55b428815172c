//! Selecting the best hypotheses bit by bit, so that no answer waits long for it.
//!
//! A selection is a row of small units: a member of the committee is replaced, a candidate is
//! made or one of its clauses replaced, sums of one left side are looked for. Between two
//! answers so many are done as [`Tuning::work`] allows, counted in looks at forms and never in
//! time; so what is known follows from the answers alone. What is asked meanwhile is asked by
//! the best hypotheses so far, and each that is better takes their place at once. Only what
//! explains nothing late in a run, and is to be judged yet, is selected without a break.
//!
//! [`Tuning::work`]: super::Tuning::work

use super::describe;
use super::forms::{Effort, StepView};
use super::greedy::Randomisation;
use super::hypothesis::Hypothesis;
use super::improve::{Improving, Objective};
use super::selection::{MANY, entropy};
use super::{Step, VersionSpace};
use crate::domain::Domain;
use crate::real::Real;

/// How far a search for sums goes after each round of candidates but the last one.
const EFFORTS: [Effort; 2] = [Effort::Simple, Effort::Thorough];

/// A selection that is under way.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Work {
    stage: Stage,
    /// The step of a sequence of actions that is looked at.
    step: usize,
    /// Where it stands there: a candidate, or a side of a left side.
    place: usize,
    /// What is done with the draft.
    draft: Drafting,
    /// Whether a search for sums had a reason.
    found: bool,
    /// Whether a best hypothesis was exchanged since the region was written.
    moved: bool,
    /// Whether it is the one before the last phase, and whether that begins with it.
    last: bool,
    due: bool,
    /// How many samples there were when it began, and when it went on.
    pub(super) begun: usize,
    seen: usize,
    /// Between how many answers it went on.
    pub(super) slices: u32,
}

/// What is done next. A round of candidates is counted from zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Stage {
    #[default]
    Done,
    /// Members of the committee are replaced that do not agree with all answers.
    Repair(usize),
    /// Candidates are improved, and compared with the best hypothesis.
    Compare(usize),
    /// Sums are looked for.
    Sums(usize),
    /// The region is written.
    Conclude,
}

/// How far a draft is.
#[derive(Clone, Copy, Debug, Default)]
enum Drafting {
    /// There is none.
    #[default]
    None,
    /// A disjunction is looked for behind its first clauses, place by place.
    Disjunction {
        simple: usize,
        place: usize,
        worth: f64,
    },
    /// It is improved.
    Improved(Improving),
}

impl<R: Real> VersionSpace<'_, R> {
    /// Whether a selection is under way.
    pub(super) fn is_selecting(&self) -> bool {
        self.work.stage != Stage::Done
    }

    /// Begins to select the best hypotheses anew, before the last phase or in between.
    #[inline(never)]
    pub(super) fn begin_selection(&mut self, last: bool) {
        if self.report.observed > 0 {
            // What was told may not have been looked at.
            self.repair_best();
        }
        let samples = self.forms.samples();
        (self.selection.current, self.selection.last) = (true, false);
        self.work = Work {
            stage: Stage::Repair(0),
            last,
            begun: samples,
            seen: samples,
            ..Work::default()
        };
    }

    /// Begins the selection that is under way again.
    pub(super) fn restart_selection(&mut self) {
        let Work { last, due, .. } = self.work;
        self.begin_selection(last);
        self.work.due = due;
    }

    /// The last phase begins with the selection that is under way, or with one that begins now.
    pub(super) fn select_for_last(&mut self) {
        if !self.is_selecting() {
            self.begin_selection(true);
        }
        (self.work.last, self.work.due) = (true, true);
    }

    /// What is nearly right is chosen anew, because it was refuted; what explains all answers was
    /// looked for before.
    pub(super) fn approximate_again(&mut self) {
        self.begin_selection(true);
        (self.work.stage, self.work.due) = (Stage::Conclude, true);
    }

    /// Selects the best hypotheses anew and makes the region of them, at once.
    #[inline(never)]
    pub(super) fn reselect(&mut self, domain: &Domain<'_>) {
        self.begin_selection(false);
        self.go_on(domain, u32::MAX);
    }

    /// Begins to select after an answer was told, because there is nothing left to ask, and
    /// remembers that. Tells whether it came to its end.
    pub(super) fn queue_selection(&mut self, domain: &Domain<'_>) -> bool {
        self.reseed(Step::Conclude);
        self.since.queued = true;
        self.begin_selection(false);
        self.go_on(domain, self.config.tuning.work);
        !self.is_selecting()
    }

    /// Goes on with the selection until so much was done since the last answer, or all; some of
    /// it in any case.
    #[inline(never)]
    pub(super) fn go_on(&mut self, domain: &Domain<'_>, most: u32) {
        self.work.slices += 1;
        if self.work.seen != self.forms.samples() {
            self.look_again();
        }
        while self.is_selecting() {
            self.do_unit(domain, most);
            if self.forms.work() >= most {
                break;
            }
        }
        if core::mem::take(&mut self.work.moved) && self.is_selecting() {
            self.rebuild_region(domain);
        }
    }

    /// Brings what is under way up to date with answers that came meanwhile.
    fn look_again(&mut self) {
        self.work.seen = self.forms.samples();
        let Work { step, place, .. } = self.work;
        match self.work.stage {
            Stage::Compare(_) if matches!(self.work.draft, Drafting::Improved(_)) => {
                let view = StepView::new(&self.forms, step);
                self.draft.refit(&view, self.config.slack);
            }
            Stage::Sums(_) if place > 0 => {
                self.begin_search(step, false);
            }
            _ => {}
        }
    }

    fn do_unit(&mut self, domain: &Domain<'_>, most: u32) {
        match self.work.stage {
            Stage::Done => {}
            Stage::Repair(round) => {
                if self.repair(most) {
                    self.enter(Stage::Compare(round));
                }
            }
            Stage::Compare(round) => self.compare(domain, round),
            Stage::Sums(round) => self.search_sums(domain, round, most),
            Stage::Conclude => self.conclude_selection(domain),
        }
    }

    fn enter(&mut self, stage: Stage) {
        (self.work.stage, self.work.step, self.work.place) = (stage, 0, 0);
        self.work.found = false;
    }

    /// What comes after a round of candidates.
    fn after(&self, round: usize) -> Stage {
        let searches = round < EFFORTS.len() && self.capacity.sums() > 0;
        match searches && !self.is_hopeless() {
            true => Stage::Sums(round),
            false => Stage::Conclude,
        }
    }

    fn conclude_selection(&mut self, domain: &Domain<'_>) {
        self.work.stage = Stage::Done;
        self.certifying |= self.work.due;
        self.selection.last = self.work.last && !self.work.due;
        self.finish_selection(domain, true);
    }

    /// One candidate a bit further: made, improved by a clause, or compared.
    #[inline(never)]
    fn compare(&mut self, domain: &Domain<'_>, round: usize) {
        let Work { step, place, .. } = self.work;
        let slack = self.config.slack;
        let forms = &self.forms;
        let naming = |clause: &_| describe::naming_length(domain, forms, clause);
        let objective = Objective {
            slack,
            naming: &naming,
        };
        let Some((_, (best, others))) = self.committee.steps_mut().nth(step) else {
            return self.enter(self.after(round));
        };
        let view = StepView::new(forms, step);
        match &mut self.work.draft {
            Drafting::Improved(improving) => {
                if improving.advance(self.draft, &view, &objective) {
                    self.work.moved |= take_better(best, self.draft, &view, &objective, place);
                    (self.work.draft, self.work.place) = (Drafting::None, place + 1);
                }
            }
            Drafting::Disjunction {
                simple,
                place,
                worth,
            } => {
                let (own, rng) = ((*simple, *place), &mut self.rng);
                *place += 1;
                if self.draft.try_disjunction(&view, own, worth, rng) {
                    return;
                }
                if self.draft.takes_another_disjunction(*simple) {
                    (*simple, *place, *worth) = (*simple + 1, 0, 0.0);
                } else {
                    self.improve_draft();
                }
            }
            Drafting::None => {
                let made = make_draft(self.draft, (best, others), &view, &objective, place);
                let made = match made {
                    Draft::Made => true,
                    Draft::Random(randomisation) => {
                        self.draft.cover(&view, randomisation, 0.0, &mut self.rng);
                        true
                    }
                    Draft::Disjunction(simple) => {
                        self.draft.begin_disjunction(&view, simple, &mut self.rng);
                        self.work.draft = Drafting::Disjunction {
                            simple: self.draft.clauses.len(),
                            place: 0,
                            worth: 0.0,
                        };
                        return;
                    }
                    Draft::Windows => {
                        self.draft.cover_with_windows(&view, &mut self.rng);
                        true
                    }
                    Draft::None => false,
                };
                match made {
                    true => self.improve_draft(),
                    false => (self.work.step, self.work.place) = (step + 1, 0),
                }
            }
        }
    }

    /// The draft covers what it can: it is improved next, or given up.
    fn improve_draft(&mut self) {
        if self.work.place == 0 || self.draft.consistent {
            self.work.draft = Drafting::Improved(Improving::default());
        } else {
            (self.work.draft, self.work.place) = (Drafting::None, self.work.place + 1);
        }
    }

    /// Looks for sums of some more left sides; with effort, for each step of which the best
    /// hypothesis is long or samples stray from it.
    #[inline(never)]
    fn search_sums(&mut self, domain: &Domain<'_>, round: usize, most: u32) {
        let Work { step, place, .. } = self.work;
        let effort = EFFORTS.get(round).copied().unwrap_or(Effort::Thorough);
        if place > 0 {
            let next = self.forms.search(domain, (step, effort), place - 1, most);
            (self.work.step, self.work.place) = match next {
                Some(next) => (step, next + 1),
                None => (step + 1, 0),
            };
            return;
        }
        let Some(best) = self.committee.best_of(step) else {
            let stage = match self.work.found {
                true => Stage::Repair(round + 1),
                false => Stage::Conclude,
            };
            return self.enter(stage);
        };
        let agrees = best.consistent && !best.is_strained();
        let short = best.length(&self.forms) <= self.config.tuning.short_sums;
        if effort == Effort::Thorough && agrees && short {
            self.work.step += 1;
            return;
        }
        self.work.found = true;
        match self.begin_search(step, true) {
            true => self.work.place = 1,
            false => self.work.step += 1,
        }
    }

    /// Begins a search for sums, or brings it up to date; `false` if there is nothing to
    /// exclude.
    fn begin_search(&mut self, step: usize, anew: bool) -> bool {
        let (committee, approximations) = (&self.committee, &*self.approximations);
        let used = |form| committee.uses(form) || approximations.iter().any(|own| own.uses(form));
        self.forms.begin_search(step, anew, &used)
    }
}

/// What a draft begins as.
enum Draft {
    /// It is there.
    Made,
    /// A cover by chance.
    Random(Randomisation),
    /// One with a disjunction behind so many simple clauses.
    Disjunction(usize),
    /// The windows of a single form.
    Windows,
    /// There are no more.
    None,
}

/// The candidate in a place: the best hypothesis itself, what is known beside it, others by
/// chance, and where that is long, some with disjunctions.
fn make_draft<R: Real>(
    draft: &mut Hypothesis<R>,
    (best, others): (&Hypothesis<R>, &[Hypothesis<R>]),
    view: &StepView<'_, '_, R>,
    objective: &Objective<'_, R>,
    place: usize,
) -> Draft {
    let tuning = view.forms.tuning();
    let Some(candidate) = place.checked_sub(1) else {
        draft.copy_from(best);
        return Draft::Made;
    };
    let (candidates, disjunctions) = candidates(view);
    if candidate > candidates + disjunctions {
        return Draft::None;
    }
    if let Some(known) = others.get(candidate) {
        draft.copy_from(known);
        return Draft::Made;
    }
    let Some(simple) = candidate.checked_sub(candidates) else {
        return Draft::Random(Randomisation::of_member(candidate, tuning));
    };
    let long = || objective.length(best, view) > tuning.disjunctions_beyond;
    match !best.consistent || long() {
        false => Draft::None,
        true if simple < disjunctions => Draft::Disjunction(simple),
        true => Draft::Windows,
    }
}

/// How many candidates there are, and how many more with disjunctions.
fn candidates<R: Real>(view: &StepView<'_, '_, R>) -> (usize, usize) {
    let tuning = view.forms.tuning();
    let candidates = tuning.candidates as usize * MANY / view.forms.samples().max(MANY);
    (candidates, tuning.disjunctions as usize)
}

/// Puts a draft in the place of the best hypothesis if it is better.
fn take_better<R: Real>(
    best: &mut Hypothesis<R>,
    draft: &Hypothesis<R>,
    view: &StepView<'_, '_, R>,
    objective: &Objective<'_, R>,
    place: usize,
) -> bool {
    let better = match place {
        // It is the best hypothesis, improved.
        0 => draft.consistent || !best.consistent,
        _ => {
            let rating = objective.rate(draft, view);
            // With disjunctions enough anything can be explained.
            let few = draft.disjunctions() < 2 || rating.1 < entropy(view);
            few && rating < objective.rate(best, view)
        }
    };
    if better {
        best.copy_from(draft);
    }
    better
}
