//! Sets of parameters, and what drawing from them needs.

use super::interval::IntervalSet;
use crate::domain::{MAX_PARAMETERS, Parameter};
use crate::error::Error;
use crate::real::Real;

/// Values of the parameters of an action, in order of declaration. Entries
/// behind the last parameter are zero.
pub type Theta = [f64; MAX_PARAMETERS];

/// A vector in the space of parameters.
pub(super) type Vector<R> = [R; MAX_PARAMETERS];

/// What a region admits in an instance, or several regions together.
pub(super) trait ParameterSet<R: Real> {
    /// The parameters of the action, with their ranges.
    fn parameters(&self) -> &[Parameter<'_>];

    /// How many parameters the action has.
    fn count(&self) -> usize;

    /// A bit for each parameter that membership depends on.
    fn relevant(&self) -> u32;

    /// The corners of a box that holds the set.
    fn bounds(&self) -> (Vector<R>, Vector<R>);

    /// Whether parameters inside the box belong to the set.
    fn admits(&self, theta: &Vector<R>) -> Result<bool, Error>;

    /// The set itself if the action has one parameter, else nothing.
    fn set(&self) -> &IntervalSet<R>;

    /// Sets `set` to the admitted positions between two ends on the line
    /// `origin + t * direction`.
    fn slice(
        &self,
        line: [&Vector<R>; 2],
        ends: [R; 2],
        set: &mut IntervalSet<R>,
    ) -> Result<(), Error>;

    /// Whether it is proven that no parameters in a box are admitted.
    fn excludes(&self, low: &Vector<R>, high: &Vector<R>) -> Result<bool, Error>;
}

/// The vector of the only parameter.
pub(super) fn single<R: Real>(value: R) -> Vector<R> {
    let mut vector = [R::ZERO; MAX_PARAMETERS];
    let [first, ..] = &mut vector;
    *first = value;
    vector
}
