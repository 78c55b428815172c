//! Constraints as functions that are at most zero where they hold, with their gradients.

use super::lifted::Region;
use crate::domain::{Domain, MAX_PARAMETERS, Scene};
use crate::error::Error;
use crate::grammar::{Constraint, MAX_CONSTRAINTS};
use crate::real::{Dual, Real};

impl Region {
    /// How far each constraint is from its bound, as optimisers want it: a value `g <= 0`
    /// where the constraint holds (below zero, if it says `<` or `>`), in order of the
    /// text, and its derivative by each parameter.
    ///
    /// Of a region that joins all of its constraints by `and`, these are all there is. Of
    /// another one they are the constraints without their `or` and `not`.
    ///
    /// `values` has one entry per constraint, and `gradients`, unless it is empty, one per
    /// constraint and parameter: those of the first constraint first. Parameters may be
    /// outside of their ranges. A constraint about no member of a group is infinitely far
    /// inside, one about an absent body infinitely far outside; their gradients are zero.
    /// At a kink, such as a distance of zero along an axis, the derivative is the one for
    /// a growing parameter.
    ///
    /// ```
    /// use critreg::{domain::Domain, region::Region};
    /// let domain = Domain::parse(
    ///     "object wall { x: length, y: length }
    ///      parameter reach in [0, 9]: length
    ///      point hand = world + (reach, 0)",
    /// )?;
    /// let region = Region::parse(&domain, "dist(hand, wall) >= 1 and reach <= wall.x")?;
    /// let (mut values, mut gradients) = ([0.0; 2], [0.0; 2]);
    /// region.margins::<f64>(&domain, &[8.0, 4.0], &[5.0], &mut values, &mut gradients)?;
    /// assert_eq!((values, gradients), ([-4.0, -3.0], [0.6, 1.0]));
    /// # Ok::<(), critreg::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Region::ground`] and [`Domain::check_parameters`];
    /// [`Error::InvalidArgument`] if an array has another length.
    pub fn margins<R: Real>(
        &self,
        domain: &Domain<'_>,
        instance: &[f64],
        theta: &[f64],
        values: &mut [f64],
        gradients: &mut [f64],
    ) -> Result<(), Error> {
        self.check_domain(domain)?;
        domain.check_parameters(theta)?;
        let count = self.formula.constraints().len();
        if values.len() != count {
            return Err(Error::InvalidArgument(
                "margins need room for one value per constraint",
            ));
        }
        let point = || {
            let mut point = [R::ZERO; MAX_PARAMETERS];
            for (own, given) in point.iter_mut().zip(theta) {
                *own = R::from_f64(*given);
            }
            point
        };
        self.write_margins(domain, instance, &point(), |index, margin: R| {
            if let Some(value) = values.get_mut(index) {
                *value = margin.to_f64();
            }
        })?;
        if gradients.is_empty() {
            return Ok(());
        }
        if gradients.len() != count * theta.len() {
            return Err(Error::InvalidArgument(
                "gradients need room for one number per constraint and parameter",
            ));
        }
        for parameter in 0..theta.len() {
            let mut point = point().map(Dual::constant);
            if let Some(own) = point.get_mut(parameter) {
                own.slope = R::ONE;
            }
            self.write_margins(domain, instance, &point, |index, margin: Dual<R>| {
                if let Some(entry) = gradients.get_mut(index * theta.len() + parameter) {
                    let known = margin.is_finite();
                    *entry = if known { margin.slope.to_f64() } else { 0.0 };
                }
            })?;
        }
        Ok(())
    }

    /// How far a sample is within the region, at its nearest bound; below zero, how far outside.
    /// Of constraints that `and` joins it is the least, of those that `or` joins the greatest
    /// (robustness of a formula, Fainekos and Pappas 2009), whatever they measure.
    ///
    /// # Errors
    /// Those of [`Region::margins`].
    pub(crate) fn robustness(
        &self,
        domain: &Domain<'_>,
        instance: &[f64],
        theta: &[f64],
    ) -> Result<f64, Error> {
        let mut values = [0.0; MAX_CONSTRAINTS];
        let count = self.formula.constraints().len();
        let values = values.get_mut(..count).unwrap_or_default();
        self.margins::<f64>(domain, instance, theta, values, &mut [])?;
        let within = |place: usize| values.get(place).map_or(f64::INFINITY, |margin| -margin);
        self.formula.robustness(within)
    }

    /// Computes the margin of each constraint, in whatever numbers.
    #[inline(never)]
    fn write_margins<R: Real>(
        &self,
        domain: &Domain<'_>,
        instance: &[f64],
        theta: &[R],
        mut write: impl FnMut(usize, R),
    ) -> Result<(), Error> {
        let scene = Scene::<R>::new(domain, instance, self.points)?;
        let sample = scene.sample::<R>(theta);
        let nodes = self.formula.nodes();
        for (index, constraint) in self.formula.constraints().iter().enumerate() {
            let sides = [constraint.lhs, constraint.rhs];
            write(
                index,
                oriented(constraint, sides.map(|id| sample.measure(nodes, id))),
            );
        }
        Ok(())
    }
}

/// The sides of a constraint as a difference that is at most zero where it holds.
fn oriented<R: Real>(constraint: &Constraint, [left, right]: [R; 2]) -> R {
    let margin = match constraint.comparison.is_upper() {
        true => left - right,
        false => right - left,
    };
    // Two extremes over nothing are equal, though their difference is not a number.
    if left == right {
        return R::ZERO;
    }
    // What is not a number satisfies no comparison.
    if margin.partial_cmp(&margin).is_none() {
        return R::INFINITY;
    }
    margin
}
