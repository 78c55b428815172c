//! Instances: a number for each attribute of each object, in order of declaration.

use super::declarations::{Attribute, Object};
use super::schema::Domain;
use crate::error::Error;
use crate::real::Real;

/// What is wrong with an instance that a precision does not hold.
pub(crate) const TOO_LARGE: &str = "a number of an instance is larger than any of this precision";

impl<'t> Domain<'t> {
    /// How many numbers a problem instance has: every attribute of every object,
    /// in order of declaration.
    pub fn instance_len(&self) -> usize {
        usize::from(self.slots)
    }

    /// Every attribute of every object in the order of an instance.
    pub fn slots(&self) -> impl Iterator<Item = (&Object<'t>, &Attribute<'t>)> {
        (0..self.slots).filter_map(|slot| self.slot(slot))
    }

    /// The attribute at a place in an instance, with its object.
    pub(crate) fn slot(&self, slot: u8) -> Option<(&Object<'t>, &Attribute<'t>)> {
        let object = self.owner(slot)?;
        let own = self.attributes_of(object.type_index);
        let attribute = own.get(usize::from(slot - object.first_slot))?;
        Some((object, attribute))
    }

    /// Whether an attribute, by its place in an instance, is a coordinate or an angle that
    /// places its object.
    pub(crate) fn places(&self, slot: u8) -> bool {
        self.axis_of(slot).is_some() || self.turns(slot)
    }

    /// Along which axis an attribute places its object.
    pub(crate) fn axis_of(&self, slot: u8) -> Option<u8> {
        let object = self.owner(slot)?;
        let mut axes = (0u8..).zip(object.pose.position);
        axes.find(|(_, own)| *own == Some(slot))
            .map(|(axis, _)| axis)
    }

    /// Whether an attribute is an angle that turns its object.
    fn turns(&self, slot: u8) -> bool {
        let object = self.owner(slot);
        object.is_some_and(|object| object.pose.angles.contains(&Some(slot)))
    }

    /// Checks that `instance` has one finite number per attribute; or NaN for all
    /// attributes of a member of a group, which then is absent.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for a wrong length, [`Error::NotFinite`].
    pub fn check_instance(&self, instance: &[f64]) -> Result<(), Error> {
        if instance.len() != self.instance_len() {
            return Err(Error::InvalidArgument(
                "an instance needs one number per attribute of every object",
            ));
        }
        let finite = all_finite(instance, "a number of an instance");
        if finite.is_ok() || self.groups.is_empty() {
            return finite;
        }
        self.objects
            .iter()
            .try_for_each(|object| self.check_object(object, instance))
    }

    fn check_object(&self, object: &Object<'_>, instance: &[f64]) -> Result<(), Error> {
        let first = usize::from(object.first_slot);
        let count = self.attributes_of(object.type_index).len();
        let own = instance.get(first..first + count).unwrap_or(&[]);
        if object.member.is_some() && own.iter().all(|number| number.is_nan()) {
            return Ok(());
        }
        all_finite(
            own,
            "a number of an instance that belongs to no absent member of a group",
        )
    }

    /// The place of the first number of an instance that is NaN or infinite, and not because a
    /// member of a group is absent.
    pub fn first_not_finite(&self, instance: &[f64]) -> Option<usize> {
        let wrong = self
            .objects
            .iter()
            .find(|object| self.check_object(object, instance).is_err());
        let first = usize::from(wrong?.first_slot);
        let own = instance.get(first..)?;
        Some(first + own.iter().position(|number| !number.is_finite())?)
    }

    /// Checks that `theta` has one finite number per parameter.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for a wrong length, [`Error::NotFinite`].
    pub fn check_parameters(&self, theta: &[f64]) -> Result<(), Error> {
        if theta.len() != self.parameters.len() {
            return Err(Error::InvalidArgument(
                "the action needs one number per parameter",
            ));
        }
        all_finite(theta, "a parameter")
    }

    /// Checks that the constants and the ranges of the parameters are numbers of the type
    /// that is computed with.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn check_precision<R: Real>(&self) -> Result<(), Error> {
        let constants = self.constants.iter().map(|constant| constant.value);
        let ends = self.parameters.iter().flat_map(|p| [p.low, p.high]);
        held::<R>(
            constants.chain(ends),
            "a constant or a range is larger than any number of this precision",
        )
    }

    /// The object to which a number of an instance belongs.
    pub(super) fn owner(&self, slot: u8) -> Option<&Object<'t>> {
        self.objects.iter().rfind(|o| o.first_slot <= slot)
    }
}

impl Object<'_> {
    /// Whether an instance has this object: a member of a group that is absent has NaN
    /// for each of its numbers.
    pub(super) fn is_present(&self, instance: &[f64]) -> bool {
        let first = instance.get(usize::from(self.first_slot));
        self.member.is_none() || first.is_some_and(|number| !number.is_nan())
    }
}

/// Checks that a type has numbers near these values, or near those of them that are any.
pub(crate) fn held<R: Real>(
    mut values: impl Iterator<Item = f64>,
    what: &'static str,
) -> Result<(), Error> {
    match values.all(R::holds) {
        true => Ok(()),
        false => Err(Error::NotFinite(what)),
    }
}

fn all_finite(numbers: &[f64], what: &'static str) -> Result<(), Error> {
    if numbers.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(Error::NotFinite(what))
    }
}
