//! A region in one problem instance.

use super::interval::{Interval, IntervalSet};
use super::lifted::Region;
use super::parameters::{ParameterSet, Theta, Vector};
use super::slice::slice;
use crate::domain::{Arithmetic, Domain, MAX_PARAMETERS, Parameter, Range, Sample, Scene};
use crate::error::Error;
use crate::grammar::{Comparison, Truth};
use crate::real::Real;

/// The set of parameters that a region admits in one instance.
#[derive(Clone, Debug)]
pub struct Grounded<'a, R> {
    region: &'a Region,
    domain: &'a Domain<'a>,
    scene: Scene<'a, R>,
    /// The admitted values of the parameter, if there is exactly one.
    set: IntervalSet<R>,
}

impl Region {
    /// The region in a problem instance: one number per attribute.
    ///
    /// ```
    /// use critreg::{domain::Domain, region::Region};
    /// let domain = Domain::parse(
    ///     "object wall { x: length, y: length }
    ///      parameter reach in [0, 4]: length
    ///      point hand = world + (reach, 0)",
    /// )?;
    /// let region = Region::parse(&domain, "dist(hand, wall) >= 1 and reach <= wall.x")?;
    /// let grounded = region.ground::<f64>(&domain, &[3.0, 0.0])?;
    /// let [admitted] = grounded.intervals()?.intervals() else { panic!() };
    /// assert_eq!([admitted.low, admitted.high], [0.0, 2.0]);
    /// assert!(grounded.contains(&[1.5])? && !grounded.contains(&[2.5])?);
    /// # Ok::<(), critreg::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Mismatch`] for another domain than the region was made for, and
    /// those of [`Domain::check_instance`].
    pub fn ground<'a, R: Real>(
        &'a self,
        domain: &'a Domain<'a>,
        instance: &'a [f64],
    ) -> Result<Grounded<'a, R>, Error> {
        Grounded::new(self, domain, instance)
    }

    /// Whether an action with these parameters is expected to work.
    ///
    /// # Errors
    /// Those of [`Region::ground`] and [`Grounded::contains`].
    pub fn contains<R: Real>(
        &self,
        domain: &Domain<'_>,
        instance: &[f64],
        theta: &[f64],
    ) -> Result<bool, Error> {
        let mut grounded = Grounded::<R>::blank(self, domain, instance);
        grounded.compute()?;
        grounded.contains(theta)
    }
}

impl<'a, R: Real> Grounded<'a, R> {
    pub(super) fn new(
        region: &'a Region,
        domain: &'a Domain<'a>,
        instance: &'a [f64],
    ) -> Result<Self, Error> {
        let mut grounded = Self::blank(region, domain, instance);
        grounded.compute()?;
        Ok(grounded)
    }

    /// As [`Grounded::new`], still without points and intervals: [`Grounded::compute`]
    /// adds them in place.
    pub(super) fn blank(region: &'a Region, domain: &'a Domain<'a>, instance: &'a [f64]) -> Self {
        Grounded {
            region,
            domain,
            scene: Scene::blank(domain, instance, region.points),
            set: IntervalSet::default(),
        }
    }

    pub(super) fn compute(&mut self) -> Result<(), Error> {
        self.region.check_domain(self.domain)?;
        self.scene.place_points()?;
        let [parameter] = self.parameters() else {
            return Ok(());
        };
        let ends = [parameter.low, parameter.high].map(R::from_f64);
        let line: [&[R]; 2] = [&[R::ZERO], &[R::ONE]];
        slice(
            &self.region.formula,
            &self.scene,
            line,
            ends,
            true,
            &mut self.set,
        );
        Ok(())
    }

    /// Whether the region admits these parameters; one number each.
    ///
    /// # Errors
    /// Those of [`Domain::check_parameters`].
    pub fn contains(&self, theta: &[f64]) -> Result<bool, Error> {
        self.domain.check_parameters(theta)?;
        let inside = |(value, p): (&f64, &Parameter<'_>)| p.low <= *value && *value <= p.high;
        if !theta.iter().zip(self.parameters()).all(inside) {
            return Ok(false);
        }
        let mut values = [R::ZERO; MAX_PARAMETERS];
        for (value, given) in values.iter_mut().zip(theta) {
            *value = R::from_f64(*given);
        }
        self.admits(&values)
    }

    /// The admitted values of the action's only parameter, exactly.
    ///
    /// Where a constraint has no closed form (a turn by the parameter, a sum of two
    /// distances, a square) the set is too large rather than too small: by a millionth of the
    /// parameter's range at each end, unless it has very many.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] unless the action has one parameter.
    pub fn intervals(&self) -> Result<&IntervalSet<R>, Error> {
        match self.parameters() {
            [_] => Ok(&self.set),
            _ => Err(Error::InvalidArgument(
                "intervals exist for an action with one parameter",
            )),
        }
    }

    /// The admitted values of one parameter while the others stay as they are in `theta`;
    /// what that has of the parameter itself does not count.
    ///
    /// As with [`Grounded::intervals`], the set may be too large where it is not exact.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] unless the action has such a parameter.
    pub fn intervals_along(
        &self,
        parameter: usize,
        theta: &Theta,
    ) -> Result<IntervalSet<R>, Error> {
        let Some(own) = self.parameters().get(parameter) else {
            return Err(Error::InvalidArgument("the action has no such parameter"));
        };
        let mut origin = theta.map(R::from_f64);
        let mut direction = [R::ZERO; MAX_PARAMETERS];
        if let (Some(at), Some(slope)) = (origin.get_mut(parameter), direction.get_mut(parameter)) {
            (*at, *slope) = (R::ZERO, R::ONE);
        }
        let ends = [own.low, own.high].map(R::from_f64);
        let mut set = IntervalSet::default();
        self.slice([&origin, &direction], ends, &mut set)?;
        Ok(set)
    }

    /// The domain that it speaks of.
    pub fn domain(&self) -> &'a Domain<'a> {
        self.domain
    }
}

impl<R: Real> Grounded<'_, R> {
    /// The intervals of the only parameter, if membership in them is all there is to know.
    pub(super) fn exact_set(&self) -> Option<&[Interval<R>]> {
        let decides = self.parameters().len() == 1 && self.set.is_exact();
        decides.then(|| self.set.intervals())
    }
}

impl<R: Real> ParameterSet<R> for Grounded<'_, R> {
    fn parameters(&self) -> &[Parameter<'_>] {
        self.domain.parameters()
    }

    fn count(&self) -> usize {
        self.parameters().len()
    }

    fn relevant(&self) -> u32 {
        self.region.relevant
    }

    fn bounds(&self) -> (Vector<R>, Vector<R>) {
        let (mut low, mut high) = ([R::ZERO; MAX_PARAMETERS], [R::ZERO; MAX_PARAMETERS]);
        for ((low, high), p) in low.iter_mut().zip(&mut high).zip(self.parameters()) {
            *low = R::from_f64(p.low);
            *high = R::from_f64(p.high);
        }
        (low, high)
    }

    fn admits(&self, theta: &Vector<R>) -> Result<bool, Error> {
        let [first, ..] = theta;
        if self.parameters().len() == 1 && self.set.is_exact() {
            return Ok(self.set.contains(*first));
        }
        let mut sample = Sample::blank(&self.scene, theta);
        sample.place_points();
        let nodes = self.region.formula.nodes();
        Ok(self.region.formula.holds(|c| {
            let lhs = sample.measure(nodes, c.lhs);
            c.comparison.holds(&lhs, &sample.measure(nodes, c.rhs))
        }))
    }

    fn set(&self) -> &IntervalSet<R> {
        &self.set
    }

    fn slice(
        &self,
        line: [&Vector<R>; 2],
        ends: [R; 2],
        set: &mut IntervalSet<R>,
    ) -> Result<(), Error> {
        let line = line.map(Vector::as_slice);
        slice(&self.region.formula, &self.scene, line, ends, false, set);
        Ok(())
    }

    fn excludes(&self, low: &Vector<R>, high: &Vector<R>) -> Result<bool, Error> {
        let mut theta = [Range::constant(R::ZERO); MAX_PARAMETERS];
        for ((range, low), high) in theta.iter_mut().zip(low).zip(high) {
            *range = Range {
                low: *low,
                high: *high,
            };
        }
        let mut sample = Sample::blank(&self.scene, &theta);
        sample.place_points();
        let nodes = self.region.formula.nodes();
        let truth = self
            .region
            .formula
            .truth(|c| range_truth(c.comparison, sample.difference(nodes, [c.lhs, c.rhs])));
        Ok(!truth.may_hold)
    }
}

/// Whether `difference comparison 0` holds over a range, allowing for rounding.
pub(super) fn range_truth<R: Real>(comparison: Comparison, gap: Range<R>) -> Truth {
    let slack = R::EPSILON * R::from_f64(64.0);
    let above = gap.low * (R::ONE - slack) > slack;
    let below = gap.high * (R::ONE - slack) < -slack;
    let (fails, holds) = if comparison.is_upper() {
        (above, below)
    } else {
        (below, above)
    };
    Truth {
        may_hold: !fails,
        may_fail: !holds,
    }
}
