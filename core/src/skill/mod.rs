//! Skills: what is known of the controllers of an environment, as regions.
//!
//! An environment says in a domain text what can be said of a controller, or of two
//! that run one after the other ([`Describe`]). The objects of the text are *roles*,
//! which a state and ground operators fill ([`Binding`]). From training tasks
//! [`Skills::learn`] learns regions (the thesis's RegionLearningApproach, 5.2, and its
//! sequential feasibility, 7.2):
//!
//! | text | of a controller alone | with a later one |
//! |---|---|---|
//! | with parameters | with which parameters it works | with which the later one works, too |
//! | without | in which states it works | in which states the two can work |
//!
//! The later controller may have parameters of its own and need others in between (pick,
//! put, pick): what is learned is whether there are any with which it works.
//!
//! [`Informed`] plans with them: as a sampler it draws from the region of a step and
//! those of all later steps at once, as a guide it postpones what cannot work.

mod binding;
mod changes;
mod informed;
mod scope;
mod selection;
mod settings;
mod tail;
mod training;
mod trial;
mod why;

pub use binding::Binding;
pub use changes::Changes;
pub use informed::Informed;
pub use scope::Scope;
pub use settings::{Candidate, MAX_CHAIN, Setting};
pub use training::{Learned, Training, TrainingMemory};

use crate::domain::Domain;
use crate::error::Error;
use crate::region::Region;
use crate::task::{ControllerId, Environment, MAX_STATE_VALUES, PredicateId};

/// What can be said of a controller, or of two that run one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Description {
    /// The controller. The parameters of the text are its first ones, the same in all
    /// texts that have any; the others are left to the original sampler.
    pub own: ControllerId,
    /// A controller that runs later.
    pub later: Option<ControllerId>,
    /// Predicates of one object that hold of every member of a group: objects of which
    /// one does not hold do not count.
    pub among: &'static [PredicateId],
    /// The domain text; its objects are roles: see [`Binding`].
    pub text: &'static str,
}

/// An environment that says what can be said of its controllers.
pub trait Describe: Environment {
    /// The descriptions; those of single controllers first, in the order in which they
    /// are learned.
    fn descriptions(&self) -> &'static [Description];
}

/// What is known of a described controller, or of two.
#[derive(Clone, Debug)]
pub struct Skill {
    description: Description,
    domain: Domain<'static>,
    binding: Binding,
    region: Option<Region>,
    /// A bit for each number of an instance that the region reads.
    reads: u64,
}

const _: () = assert!(MAX_STATE_VALUES <= 64, "there is a bit per number");

impl Skill {
    /// What it is about.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// The domain of the region.
    pub fn domain(&self) -> &Domain<'static> {
        &self.domain
    }

    /// How its instances are made.
    pub fn binding(&self) -> &Binding {
        &self.binding
    }

    /// The region. `None` if none was learned, which is an honest outcome: then nothing
    /// is known.
    pub fn region(&self) -> Option<&Region> {
        self.region.as_ref()
    }

    /// Takes this region for what is known, or that nothing is.
    pub fn set_region(&mut self, region: Option<Region>) {
        let reads = |region: &Region| {
            let slots = (0..).take(self.binding.len());
            let read = slots.filter(|slot| region.reads(&self.domain, *slot));
            read.fold(0, |bits, slot| bits | 1u64.wrapping_shl(u32::from(slot)))
        };
        self.reads = region.as_ref().map_or(0, reads);
        self.region = region;
    }
}

/// What is known of the controllers of an environment.
#[derive(Debug)]
pub struct Skills<'m> {
    skills: &'m mut [Option<Skill>],
    changes: &'m mut [Changes],
}

impl<'m> Skills<'m> {
    /// Nothing known yet of what an environment describes. `skills` has a place for
    /// each description, `changes` for each controller.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is no room, those of [`Domain::parse`] and
    /// of [`Binding::new`].
    pub fn new<E: Describe>(
        environment: &E,
        skills: &'m mut [Option<Skill>],
        changes: &'m mut [Changes],
    ) -> Result<Self, Error> {
        let (descriptions, controllers) = (environment.descriptions(), E::CONTROLLERS);
        let skills = skills.get_mut(..descriptions.len());
        let skills = skills.ok_or(Error::CapacityExceeded("skills"))?;
        let changes = changes.get_mut(..controllers.len());
        let changes = changes.ok_or(Error::CapacityExceeded("changes of controllers"))?;
        changes.fill(Changes::default());
        for (skill, description) in skills.iter_mut().zip(descriptions) {
            let domain = Domain::parse(description.text)?;
            let own = environment.controller(description.own)?;
            if domain.parameters().len() > own.parameters.len() {
                return Err(Error::Mismatch(
                    "a text has more parameters than its controller",
                ));
            }
            let later = description
                .later
                .map(|id| environment.controller(id))
                .transpose()?;
            let later = later.map_or(&[][..], |later| later.arguments);
            *skill = Some(Skill {
                description: *description,
                binding: Binding::new(&domain, E::TYPES, own.arguments, later)?,
                domain,
                region: None,
                reads: 0,
            });
        }
        Ok(Skills { skills, changes })
    }

    /// All of them, in the order of the descriptions.
    pub fn iter(&self) -> impl Iterator<Item = &Skill> {
        self.skills.iter().flatten()
    }

    /// One of them, by its place.
    pub fn get(&self, index: usize) -> Option<&Skill> {
        self.skills.get(index)?.as_ref()
    }

    /// One of them, by its place, to change.
    pub fn get_mut(&mut self, index: usize) -> Option<&mut Skill> {
        self.skills.get_mut(index)?.as_mut()
    }

    /// What is known of a controller, or of it and a later one.
    pub fn about(
        &self,
        own: ControllerId,
        later: Option<ControllerId>,
    ) -> impl Iterator<Item = &Skill> {
        let is_it = move |about: &Description| about.own == own && about.later == later;
        self.iter().filter(move |skill| is_it(&skill.description))
    }

    /// What a controller changes, as far as was seen.
    pub fn changes(&self, ControllerId(id): ControllerId) -> Changes {
        let changes = self.changes.get(usize::from(id));
        changes.copied().unwrap_or_default()
    }

    fn changes_mut(&mut self, ControllerId(id): ControllerId) -> Option<&mut Changes> {
        self.changes.get_mut(usize::from(id))
    }
}
