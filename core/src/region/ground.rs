//! A region in one problem instance.

use super::interval::{IntervalSet, MAX_BREAKS};
use super::{Region, Theta};
use crate::domain::{Arithmetic, Curve, Domain, Line, MAX_PARAMETERS, Parameter, Range, Scene};
use crate::error::Error;
use crate::grammar::{Comparison, Constraint, MAX_CONSTRAINTS, Truth};
use crate::real::Real;
use heapless::Vec;

/// The set of parameters that a region admits in one instance.
#[derive(Clone, Debug)]
pub struct Grounded<'a, R> {
    region: &'a Region,
    domain: &'a Domain<'a>,
    scene: Scene<'a, R>,
}

/// A vector in the space of parameters.
pub(super) type Vector<R> = [R; MAX_PARAMETERS];

impl<'a, R: Real> Grounded<'a, R> {
    pub(super) fn new(
        region: &'a Region,
        domain: &'a Domain<'a>,
        instance: &'a [f64],
    ) -> Result<Self, Error> {
        Ok(Grounded {
            region,
            domain,
            scene: Scene::new(domain, instance, region.points)?,
        })
    }

    /// The parameters of the action.
    pub(super) fn parameters(&self) -> &'a [Parameter<'a>] {
        self.domain.parameters()
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

    /// As [`Grounded::contains`], for checked parameters inside their ranges.
    pub(super) fn admits(&self, theta: &Vector<R>) -> Result<bool, Error> {
        let sample = self.scene.sample::<R>(theta)?;
        let nodes = self.region.formula.nodes();
        Ok(self.region.formula.holds(|c| {
            let left = sample.measure(nodes, c.left);
            c.comparison.holds(&left, &sample.measure(nodes, c.right))
        }))
    }

    /// The admitted values of the action's only parameter, exactly.
    ///
    /// Where a constraint has no closed form (a turn by the parameter, a sum of
    /// two distances) the set is too large rather than too small.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] unless the action has one parameter.
    pub fn intervals(&self) -> Result<IntervalSet<R>, Error> {
        let [parameter] = self.parameters() else {
            return Err(Error::InvalidArgument(
                "intervals exist for an action with one parameter",
            ));
        };
        let mut direction = [R::ZERO; MAX_PARAMETERS];
        let [first, ..] = &mut direction;
        *first = R::ONE;
        let ends = [parameter.low, parameter.high].map(R::from_f64);
        self.slice(&[R::ZERO; MAX_PARAMETERS], &direction, ends)
    }

    /// The admitted positions `t` between two ends on the line
    /// `origin + t * direction`.
    pub(super) fn slice(
        &self,
        origin: &Vector<R>,
        direction: &Vector<R>,
        [low, high]: [R; 2],
    ) -> Result<IntervalSet<R>, Error> {
        let mut theta = [Line::constant(R::ZERO); MAX_PARAMETERS];
        for ((line, at), slope) in theta.iter_mut().zip(origin).zip(direction) {
            *line = Line {
                at: *at,
                slope: *slope,
            };
        }
        let sample = self.scene.sample::<Line<R>>(&theta)?;
        let formula = &self.region.formula;
        let mut curves: Vec<Curve<R>, MAX_CONSTRAINTS> = Vec::new();
        let mut breaks: Vec<R, MAX_BREAKS> = Vec::new();
        insert(&mut breaks, low)?;
        insert(&mut breaks, high)?;
        for constraint in formula.constraints() {
            let left = sample.measure(formula.nodes(), constraint.left);
            let curve = left.minus(sample.measure(formula.nodes(), constraint.right));
            for root in roots(&curve).into_iter().flatten() {
                if low < root && root < high {
                    insert(&mut breaks, root)?;
                }
            }
            curves
                .push(curve)
                .map_err(|_| Error::CapacityExceeded("constraints of a region"))?;
        }
        let truth = |t: R, near_zero: bool| {
            let mut curves = curves.iter();
            let known = |c: &Constraint| {
                let curve = curves.next();
                curve.map_or(Truth::from(false), |f| sign(f, c.comparison, t, near_zero))
            };
            formula.truth(known).may_hold
        };
        let half = R::from_f64(0.5);
        IntervalSet::from_breaks(
            &breaks,
            |at| truth(at, true),
            |a, b| truth(a + (b - a) * half, false),
        )
    }

    /// Whether it is proven that no parameters in a box are admitted.
    pub(super) fn excludes(&self, low: &Vector<R>, high: &Vector<R>) -> Result<bool, Error> {
        let mut theta = [Range::constant(R::ZERO); MAX_PARAMETERS];
        for ((range, low), high) in theta.iter_mut().zip(low).zip(high) {
            *range = Range {
                low: *low,
                high: *high,
            };
        }
        let sample = self.scene.sample::<Range<R>>(&theta)?;
        let nodes = self.region.formula.nodes();
        let truth = self.region.formula.truth(|c| {
            let left = sample.measure(nodes, c.left);
            let gap = left.minus(sample.measure(nodes, c.right));
            range_truth(c.comparison, gap)
        });
        Ok(!truth.may_hold)
    }

    /// The corners of the box of all parameters.
    pub(super) fn bounds(&self) -> (Vector<R>, Vector<R>) {
        let (mut low, mut high) = ([R::ZERO; MAX_PARAMETERS], [R::ZERO; MAX_PARAMETERS]);
        for ((low, high), p) in low.iter_mut().zip(&mut high).zip(self.parameters()) {
            *low = R::from_f64(p.low);
            *high = R::from_f64(p.high);
        }
        (low, high)
    }
}

/// The parameters as the caller knows them.
pub(super) fn to_theta<R: Real>(theta: &Vector<R>) -> Theta {
    theta.map(R::to_f64)
}

/// Sorted insertion; equal breaks are kept once.
fn insert<R: Real>(breaks: &mut Vec<R, MAX_BREAKS>, at: R) -> Result<(), Error> {
    let mut carried = at;
    for slot in breaks.iter_mut() {
        if carried == *slot {
            return Ok(());
        }
        if carried < *slot {
            core::mem::swap(slot, &mut carried);
        }
    }
    breaks
        .push(carried)
        .map_err(|_| Error::CapacityExceeded("intervals of a region"))
}

/// Whether `curve(t) comparison 0`. At a break a value that is zero but for
/// rounding counts as zero.
fn sign<R: Real>(curve: &Curve<R>, comparison: Comparison, t: R, near_zero: bool) -> Truth {
    if !curve.is_known() {
        return Truth {
            may_hold: true,
            may_fail: true,
        };
    }
    let mut value = curve.value(t);
    if near_zero {
        let size = curve.line.at.abs() + (curve.line.slope * t).abs();
        let tolerance = R::EPSILON * R::from_f64(16.0) * (R::ONE + size);
        if value.abs() <= tolerance {
            value = R::ZERO;
        }
    }
    comparison.holds(&value, &R::ZERO).into()
}

/// Whether `gap comparison 0` over a range, leaving room for rounding.
fn range_truth<R: Real>(comparison: Comparison, gap: Range<R>) -> Truth {
    let slack = R::EPSILON * R::from_f64(64.0);
    let low = gap.low - slack * (R::ONE + gap.low.abs());
    let high = gap.high + slack * (R::ONE + gap.high.abs());
    if comparison.is_upper() {
        Truth {
            may_hold: !(low > R::ZERO),
            may_fail: !(high < R::ZERO),
        }
    } else {
        Truth {
            may_hold: !(high < R::ZERO),
            may_fail: !(low > R::ZERO),
        }
    }
}

/// Where a curve may be zero: `line(t) = -factor * |vector(t)|`. A root of the
/// squared equation that is none of the curve does no harm, it only splits an
/// interval that is joined again.
fn roots<R: Real>(curve: &Curve<R>) -> [Option<R>; 2] {
    if !curve.is_known() {
        return [None, None];
    }
    let Line { at: a, slope: b } = curve.line;
    if curve.factor == R::ZERO {
        return [linear_root(a, b), None];
    }
    let factor = curve.factor;
    let zero = |v: &Line<R>| v.at == R::ZERO && v.slope == R::ZERO;
    let [x, y, z] = curve.vector;
    let single = match (zero(&x), zero(&y), zero(&z)) {
        (_, true, true) => Some(x),
        (true, _, true) => Some(y),
        (true, true, _) => Some(z),
        _ => None,
    };
    if let Some(v) = single {
        let (at, slope) = (factor * v.at, factor * v.slope);
        return [
            linear_root(a + at, b + slope),
            linear_root(a - at, b - slope),
        ];
    }
    let square = |f: fn(&Line<R>) -> R, g: fn(&Line<R>) -> R| {
        let products = curve.vector.iter().map(|v| f(v) * g(v));
        factor * factor * products.fold(R::ZERO, |sum, p| sum + p)
    };
    quadratic_roots(
        square(|v| v.slope, |v| v.slope) - b * b,
        square(|v| v.at, |v| v.slope) - a * b,
        square(|v| v.at, |v| v.at) - a * a,
    )
}

/// The root of `at + slope * t`.
fn linear_root<R: Real>(at: R, slope: R) -> Option<R> {
    Some(-at / slope).filter(|t| t.is_finite())
}

/// The roots of `a t^2 + 2 b t + c`, without cancellation.
fn quadratic_roots<R: Real>(a: R, b: R, c: R) -> [Option<R>; 2] {
    let discriminant = b * b - a * c;
    if discriminant < R::ZERO {
        return [None, None];
    }
    let root = discriminant.sqrt();
    let q = if b < R::ZERO { root - b } else { -(b + root) };
    [q / a, c / q].map(|t| Some(t).filter(|t| t.is_finite()))
}
