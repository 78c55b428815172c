//! What is known of the controllers of an environment.

use super::changes::Changes;
use super::description::{Describe, Description};
use super::effects::Effects;
use super::role_binding::RoleBinding;
use super::setting::{Setting, Signature};
use crate::domain::Domain;
use crate::error::Error;
use crate::region::Region;
use crate::task::{ControllerId, MAX_ARGUMENTS, MAX_STATE_VALUES, ObjectId, ObjectType};
use heapless::Vec;

/// What is known of a described controller, or of two.
#[derive(Clone, Debug)]
pub struct Skill {
    description: Description,
    domain: Domain<'static>,
    binding: RoleBinding,
    /// Places of the objects of the two controllers that must be the same objects.
    shared: Vec<(usize, usize), MAX_ARGUMENTS>,
    region: Option<Region>,
    /// A bit for each number of an instance that the region reads.
    reads: u64,
    effects: Effects,
}

const _: () = assert!(MAX_STATE_VALUES <= 64, "there is a bit per number");

impl Skill {
    /// Nothing known yet of what is described, of controllers like these; the types are those
    /// of the objects of a state.
    ///
    /// # Errors
    /// [`Error::Mismatch`] if the text has more parameters than the controller; those of
    /// [`Domain::parse`] and of [`RoleBinding::new`].
    pub fn new(
        description: &Description,
        types: &[ObjectType],
        controller: Signature,
        later: Option<Signature>,
    ) -> Result<Self, Error> {
        let domain = Domain::parse(description.text)?;
        if domain.parameters().len() > controller.parameters {
            return Err(Error::Mismatch(
                "a text has more parameters than its controller",
            ));
        }
        let later = later.map_or(&[][..], |later| later.arguments);
        Ok(Skill {
            description: *description,
            binding: RoleBinding::new(&domain, types, controller.arguments, later)?,
            domain,
            shared: Vec::new(),
            region: None,
            reads: 0,
            effects: Effects::default(),
        })
    }

    /// As [`Skill::new`], of two controllers of which objects whose roles have the same name
    /// are the same, as in the text that [`write_pair`](super::write_pair) writes. Of others
    /// nothing is said.
    ///
    /// # Errors
    /// Those of [`Skill::new`].
    pub fn of_same_objects(
        description: &Description,
        types: &[ObjectType],
        controller: Signature,
        later: Option<Signature>,
    ) -> Result<Self, Error> {
        let mut skill = Skill::new(description, types, controller, later)?;
        if let Some(later) = later {
            let (own, later) = (controller.arguments, later.arguments);
            skill.shared = RoleBinding::shared(&skill.domain, types, own, later);
        }
        Ok(skill)
    }

    /// Whether it says something of controllers with these objects.
    pub(super) fn is_about(&self, objects: &[ObjectId], later_objects: &[ObjectId]) -> bool {
        let mut shared = self.shared.iter();
        shared.all(|(own, later)| objects.get(*own) == later_objects.get(*later))
    }

    /// What it is about.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// The domain of the region.
    pub fn domain(&self) -> &Domain<'static> {
        &self.domain
    }

    /// How its instances are made.
    pub fn binding(&self) -> &RoleBinding {
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

    /// Where the controller leaves its objects, as far as was seen.
    pub fn effects(&self) -> &Effects {
        &self.effects
    }

    /// Takes this for what was seen.
    pub fn set_effects(&mut self, effects: Effects) {
        self.effects = effects;
    }

    /// Whether it is about parameters, and not about states only.
    pub(super) fn has_parameters(&self) -> bool {
        !self.domain.parameters().is_empty()
    }

    /// The numbers of an instance that the region reads.
    pub(super) fn reads(&self) -> impl Iterator<Item = usize> {
        let reads = self.reads;
        (0..self.binding.len()).filter(move |slot| reads >> slot & 1 == 1)
    }
}

/// What is known of the controllers of an environment: a region for each description that
/// was learned, and what each controller changes.
///
/// It is only a store. A [`Trainer`](super::Trainer) fills it;
/// [`RegionSampler`](super::RegionSampler) and [`RegionGuide`](super::RegionGuide) plan
/// with it.
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
    /// [`Error::CapacityExceeded`] if there is no room; [`Error::Mismatch`] if a controller
    /// is not of this environment, or has fewer parameters than a text about it; those of
    /// [`Domain::parse`] and of [`RoleBinding::new`].
    pub fn new<E: Describe>(
        environment: &E,
        skills: &'m mut [Option<Skill>],
        changes: &'m mut [Changes],
    ) -> Result<Self, Error> {
        let skills = skills.get_mut(..E::DESCRIPTIONS.len());
        let skills = skills.ok_or(Error::CapacityExceeded("skills"))?;
        let changes = changes.get_mut(..E::CONTROLLERS.len());
        let changes = changes.ok_or(Error::CapacityExceeded("changes of controllers"))?;
        changes.fill(Changes::default());
        for (skill, description) in skills.iter_mut().zip(E::DESCRIPTIONS) {
            let controller = environment.signature(description.controller)?;
            let later = description.later.map(|id| environment.signature(id));
            let later = later.transpose()?;
            *skill = Some(Skill::new(description, E::TYPES, controller, later)?);
        }
        Ok(Skills { skills, changes })
    }

    /// What is known already, in places that were filled one by one.
    pub fn resume(skills: &'m mut [Option<Skill>], changes: &'m mut [Changes]) -> Self {
        Skills { skills, changes }
    }

    /// All of them, in the order of the descriptions.
    pub fn iter(&self) -> impl Iterator<Item = &Skill> {
        self.library().iter()
    }

    /// One of them, by its place.
    pub fn get(&self, index: usize) -> Option<&Skill> {
        self.library().get(index)
    }

    /// One of them, by its place, to change.
    pub fn get_mut(&mut self, index: usize) -> Option<&mut Skill> {
        self.skills.get_mut(index)?.as_mut()
    }

    /// What is known of a controller, or of it and a later one.
    pub fn about(
        &self,
        controller: ControllerId,
        later: Option<ControllerId>,
    ) -> impl Iterator<Item = &Skill> {
        self.library().about(controller, later)
    }

    /// What a controller changes, as far as was seen.
    pub fn changes(&self, controller: ControllerId) -> Changes {
        Changes::of(self.changes, controller)
    }

    /// What each controller changes.
    pub fn all_changes(&self) -> &[Changes] {
        self.changes
    }

    /// Likewise, to go on from other observations.
    pub fn all_changes_mut(&mut self) -> &mut [Changes] {
        self.changes
    }

    /// The skills, to look up.
    pub(super) fn library(&self) -> Library<'_> {
        Library(self.skills)
    }

    /// The skills, to look up, and what each controller changes.
    pub(super) fn known(&self) -> Known<'_> {
        (Library(self.skills), self.changes)
    }

    /// Likewise, to note more of what controllers change.
    pub(super) fn known_mut(&mut self) -> (Library<'_>, &mut [Changes]) {
        (Library(self.skills), self.changes)
    }
}

/// All that is known so far: the skills, and what each controller changes.
pub(super) type Known<'a> = (Library<'a>, &'a [Changes]);

/// The skills, to look up, while what controllers change is being noted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Library<'a>(&'a [Option<Skill>]);

impl<'a> Library<'a> {
    /// See [`Skills::iter`].
    pub(super) fn iter(self) -> impl Iterator<Item = &'a Skill> {
        self.0.iter().flatten()
    }

    /// See [`Skills::get`].
    pub(super) fn get(self, index: usize) -> Option<&'a Skill> {
        self.0.get(index)?.as_ref()
    }

    /// See [`Skills::about`].
    pub(super) fn about(
        self,
        controller: ControllerId,
        later: Option<ControllerId>,
    ) -> impl Iterator<Item = &'a Skill> {
        let is_it = move |d: &Description| d.controller == controller && d.later == later;
        self.iter().filter(move |skill| is_it(&skill.description))
    }
}
