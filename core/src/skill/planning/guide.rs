//! The region guide.

use super::expectation::Expectation;
use super::foresight::{Foresight, Reach};
use super::knowledge::{Knowledge, reason};
use crate::error::Error;
use crate::plan::{Advice, Guide, Skeleton};
use crate::random::generator;
use crate::skill::changes::Changes;
use crate::skill::setting::{Said, Setting};
use crate::skill::skills::{Known, Skills};
use crate::table::gather;
use crate::task::{GroundAtom, State};
use heapless::Vec;

/// Atoms that ended without being said to, of which is known at once.
const MAX_ENDED: usize = 16;

/// A region guide: it keeps the search of a bilevel planner from sequences of operators
/// that cannot work, for all that was learned (sequential feasibility, thesis 7.2).
///
/// It judges a sequence whose last operator does not work, or with no parameters of some
/// step before, in the state that is expected there: the initial one, with what the steps
/// before are known to change. It does so only as far as regions read nothing that cannot
/// be told.
///
/// The reason that it gives is the place of the ground operator that cannot work;
/// [`RegionGuide::explain`] has the text.
#[derive(Debug)]
pub struct RegionGuide<'a, E> {
    pub(super) knowledge: Knowledge<'a, E>,
    changes: &'a [Changes],
    pub(super) initial: &'a State,
    /// Whether to prune what cannot work, and not only to postpone it.
    pub prune: bool,
    /// How many draws of the parameters on the way a sequence is given to come to its end in
    /// what is expected; 0, the default: it is judged only by what holds whatever they are.
    pub lookahead: u32,
}

impl<'a, E: Setting> RegionGuide<'a, E> {
    /// The guide by what is known of an environment, for a task with this initial state.
    pub fn new(environment: &'a E, skills: &'a Skills<'_>, initial: &'a State) -> Self {
        RegionGuide::from_known(environment, skills.known(), initial)
    }

    pub(in crate::skill) fn from_known(
        environment: &'a E,
        (library, changes): Known<'a>,
        initial: &'a State,
    ) -> Self {
        RegionGuide {
            knowledge: Knowledge {
                environment,
                library,
            },
            changes,
            initial,
            prune: false,
            lookahead: 0,
        }
    }

    /// The state that is expected after these steps, whatever their parameters.
    fn expected<const N: usize>(&self, before: Skeleton<'_, N>) -> Expectation {
        let mut now = Expectation::of(self.initial);
        for ground in before.iter() {
            match self.knowledge.controller(ground) {
                Some(own) => now.change(self.changes, &own, false),
                None => now.forget(),
            }
        }
        now
    }

    /// Whether the last operator of a sequence needs an atom that one before it is known to
    /// end, although it does not say so.
    fn misses_atom<const N: usize>(&self, prefix: Skeleton<'_, N>) -> bool {
        let mut ended: Vec<GroundAtom, MAX_ENDED> = Vec::new();
        let mut misses = false;
        for ground in prefix.iter() {
            let own = self.knowledge.controller(ground);
            let changes = own.map(|own| Changes::of(self.changes, own.id));
            let mut now: Vec<GroundAtom, MAX_ENDED> = Vec::new();
            let mut added: Vec<GroundAtom, MAX_ENDED> = Vec::new();
            misses = false;
            let (environment, objects) = (self.knowledge.environment, ground.objects);
            environment.visit_atoms(ground.operator, objects.as_slice(), &mut |said, atom| {
                misses |= said != Said::Added && ended.contains(&atom);
                let ends = said == Said::Stays
                    && changes.is_some_and(|changes| changes.ends(atom.predicate));
                // What finds no room is not known.
                if said == Said::Added {
                    let _ = added.push(atom);
                } else if ends {
                    let _ = now.push(atom);
                }
            });
            let all = now.iter().chain(&ended);
            ended = gather(all.filter(|atom| !added.contains(atom)).copied());
        }
        misses
    }

    /// Whether the last operator of a sequence cannot work.
    fn is_blocked<const N: usize>(&self, prefix: Skeleton<'_, N>) -> Result<bool, Error> {
        if self.misses_atom(prefix) {
            return Ok(true);
        }
        for step in (0..prefix.len()).filter(|step| self.is_known(prefix, *step)) {
            let now = self.expected(prefix.until(step));
            let steps = prefix.from(step);
            let joint = self
                .knowledge
                .joint_region(steps, &now.state, |skill, context| {
                    now.tells_region(skill, context)
                });
            if joint.is_proven_empty()? {
                return Ok(true);
            }
        }
        self.is_out_of_reach(prefix)
    }

    /// Whether a sequence does not come to its end with any of some draws, of those that
    /// the look-ahead allows.
    fn is_out_of_reach<const N: usize>(&self, prefix: Skeleton<'_, N>) -> Result<bool, Error> {
        let foresight = Foresight {
            knowledge: &self.knowledge,
            changes: self.changes,
        };
        let mut rng = generator(prefix.len() as u64);
        for _ in 0..self.lookahead {
            match foresight.follow(prefix, Expectation::of(self.initial), &mut rng)? {
                Reach::End(_) => return Ok(false),
                Reach::Step(_) => {}
                Reach::Never(_) => return Ok(true),
            }
        }
        Ok(self.lookahead > 0)
    }

    /// Whether something is known of a step and the last one of a sequence, or of that
    /// one alone.
    fn is_known<const N: usize>(&self, prefix: Skeleton<'_, N>, step: usize) -> bool {
        let controller = |ground| self.knowledge.controller(ground);
        let Some(own) = prefix.get(step).and_then(controller) else {
            return false;
        };
        let last = prefix.from(step + 1).iter().next_back();
        let last = last.and_then(controller).map(|last| last.id);
        self.knowledge.has_region(own.id, last)
    }
}

impl<E: Setting, const N: usize> Guide<N> for RegionGuide<'_, E> {
    fn judge(&mut self, prefix: Skeleton<'_, N>) -> Advice {
        // What cannot be evaluated is no reason to drop anything.
        if !self.is_blocked(prefix).unwrap_or(false) {
            return Advice::Keep;
        }
        let reason = reason(prefix, prefix.len().saturating_sub(1));
        if self.prune {
            Advice::Prune(reason)
        } else {
            Advice::Postpone(reason)
        }
    }
}
