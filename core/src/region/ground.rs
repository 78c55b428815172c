//! A region in one problem instance.

use super::interval::{Builder, IntervalSet, MAX_BREAKS};
use super::{Region, Theta};
use crate::domain::{Arithmetic, Curve, Domain, Line, MAX_PARAMETERS, Parameter, Range, Scene};
use crate::error::Error;
use crate::grammar::{Comparison, MAX_CONSTRAINTS, Truth};
use crate::real::Real;
use heapless::Vec;

/// The set of parameters that a region admits in one instance.
#[derive(Clone, Debug)]
pub struct Grounded<'a, R> {
    region: &'a Region,
    domain: &'a Domain<'a>,
    scene: Scene<'a, R, MAX_REGION_POINTS>,
    /// What is admitted of the only parameter, if there is only one.
    set: IntervalSet<R>,
}

/// Most points that the constraints of a region refer to, with the points these
/// are placed in.
pub const MAX_REGION_POINTS: usize = 12;

/// A vector in the space of parameters.
pub(super) type Vector<R> = [R; MAX_PARAMETERS];

impl<'a, R: Real> Grounded<'a, R> {
    pub(super) fn new(
        region: &'a Region,
        domain: &'a Domain<'a>,
        instance: &'a [f64],
    ) -> Result<Self, Error> {
        let mut grounded = Self::blank(region, domain, instance);
        grounded.settle()?;
        Ok(grounded)
    }

    /// As [`Grounded::new`], to be completed in place by [`Grounded::settle`].
    pub(super) fn blank(region: &'a Region, domain: &'a Domain<'a>, instance: &'a [f64]) -> Self {
        Grounded {
            region,
            domain,
            scene: Scene::without_points(domain, instance),
            set: IntervalSet::default(),
        }
    }

    pub(super) fn settle(&mut self) -> Result<(), Error> {
        if self.domain.fingerprint() != self.region.fingerprint {
            return Err(Error::Mismatch("the region belongs to another domain text"));
        }
        self.scene.add(self.region.points)?;
        let [parameter] = self.parameters() else {
            return Ok(());
        };
        let ends = [parameter.low, parameter.high].map(R::from_f64);
        let (origin, direction) = (single(R::ZERO), single(R::ONE));
        slice(
            self.region,
            &self.scene,
            [&origin, &direction],
            ends,
            &mut self.set,
        )
    }

    /// The parameters of the action.
    pub(super) fn parameters(&self) -> &'a [Parameter<'a>] {
        self.domain.parameters()
    }

    /// A bit for each parameter that the region depends on.
    pub(super) fn relevant(&self) -> u32 {
        self.region.relevant
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
        let [first, ..] = theta;
        if self.parameters().len() == 1 && self.set.is_exact() {
            return Ok(self.set.contains(*first));
        }
        let sample = self.scene.sample::<R>(theta);
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
    pub fn intervals(&self) -> Result<&IntervalSet<R>, Error> {
        match self.parameters() {
            [_] => Ok(&self.set),
            _ => Err(Error::InvalidArgument(
                "intervals exist for an action with one parameter",
            )),
        }
    }

    /// Sets `set` to the admitted positions between two ends on the line
    /// `origin + t * direction`.
    pub(super) fn slice(
        &self,
        line: [&Vector<R>; 2],
        ends: [R; 2],
        set: &mut IntervalSet<R>,
    ) -> Result<(), Error> {
        slice(self.region, &self.scene, line, ends, set)
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
        let sample = self.scene.sample::<Range<R>>(&theta);
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

/// Sets `set` to the admitted positions `t` between two ends on the line
/// `origin + t * direction`.
///
/// The line is cut at the roots of the constraints; between two neighbouring
/// ones nothing changes. At a root its own constraint holds if it admits
/// equality.
fn slice<R: Real>(
    region: &Region,
    scene: &Scene<'_, R, MAX_REGION_POINTS>,
    [origin, direction]: [&Vector<R>; 2],
    [low, high]: [R; 2],
    set: &mut IntervalSet<R>,
) -> Result<(), Error> {
    let mut theta = [Line::constant(R::ZERO); MAX_PARAMETERS];
    for ((line, at), slope) in theta.iter_mut().zip(origin).zip(direction) {
        *line = Line {
            at: *at,
            slope: *slope,
        };
    }
    let sample = scene.sample::<Line<R>>(&theta);
    let formula = &region.formula;
    let mut cut = Cut::new(low, high)?;
    for (index, constraint) in formula.constraints().iter().enumerate() {
        let left = sample.measure(formula.nodes(), constraint.left);
        let curve = left.minus(sample.measure(formula.nodes(), constraint.right));
        cut.add(index, &curve, constraint.comparison)?;
    }
    let unknown = cut.first.hold & cut.first.fail;
    let mut builder = Builder::new(set, unknown == 0);
    // Most regions are conjunctions: all bits set is all there is to know.
    let all = formula.conjunction();
    let truth = |masks: Masks| match all {
        Some(all) => masks.hold == all,
        None => formula.truth_of_masks(masks.hold, masks.fail).may_hold,
    };
    let mut masks = cut.first;
    for own in &cut.breaks {
        let here = truth(masks.with(own.owners, cut.admit_equal));
        masks = masks.with(own.owners, own.then_hold);
        builder.step(own.at, here, own.at < high && truth(masks))?;
    }
    Ok(())
}

/// The vector of the only parameter.
pub(super) fn single<R: Real>(value: R) -> Vector<R> {
    let mut vector = [R::ZERO; MAX_PARAMETERS];
    let [first, ..] = &mut vector;
    *first = value;
    vector
}

/// The parameters as the caller knows them.
pub(super) fn to_theta<R: Real>(theta: &Vector<R>) -> Theta {
    theta.map(R::to_f64)
}

/// A root of constraints, or an end of the line.
#[derive(Clone, Copy)]
struct Break<R> {
    at: R,
    /// A bit for each constraint that has a root here.
    owners: u32,
    /// Those of them that hold behind it.
    then_hold: u32,
}

/// Which constraints may hold and which may fail, a bit each.
#[derive(Clone, Copy, Default)]
struct Masks {
    hold: u32,
    fail: u32,
}

impl Masks {
    /// Where `which` hold or fail as `holding` says.
    fn with(self, which: u32, holding: u32) -> Masks {
        Masks {
            hold: (self.hold & !which) | (which & holding),
            fail: (self.fail & !which) | (which & !holding),
        }
    }
}

const _: () = assert!(MAX_CONSTRAINTS <= 32, "masks have a bit per constraint");

/// A line cut at the roots of constraints.
struct Cut<R> {
    /// What holds before the first root.
    first: Masks,
    /// Constraints that hold where their two sides are equal.
    admit_equal: u32,
    /// The ends of the line and the roots between them, ascending.
    breaks: Vec<Break<R>, MAX_BREAKS>,
}

impl<R: Real> Cut<R> {
    fn new(low: R, high: R) -> Result<Self, Error> {
        let mut cut = Cut {
            first: Masks::default(),
            admit_equal: 0,
            breaks: Vec::new(),
        };
        for at in [low, high] {
            cut.insert(Break {
                at,
                owners: 0,
                then_hold: 0,
            })?;
        }
        Ok(cut)
    }

    /// Cuts at the roots of a constraint, and evaluates it once between them.
    fn add(&mut self, index: usize, curve: &Curve<R>, comparison: Comparison) -> Result<(), Error> {
        let bit = 1u32.checked_shl(index as u32).unwrap_or(0);
        if !curve.is_known() {
            self.first.hold |= bit;
            self.first.fail |= bit;
            return Ok(());
        }
        if comparison.admits_equal() {
            self.admit_equal |= bit;
        }
        let (Some(low), Some(high)) = (
            self.breaks.first().map(|b| b.at),
            self.breaks.last().map(|b| b.at),
        ) else {
            return Ok(());
        };
        let half = R::from_f64(0.5);
        let holds_between = |a: R, b: R| {
            let value = curve.value(a + (b - a) * half);
            if comparison.holds(&value, &R::ZERO) {
                bit
            } else {
                0
            }
        };
        let inside = |t: &R| low <= *t && *t <= high && curve.is_near_zero(*t);
        let [a, b] = roots(curve).map(|root| root.filter(inside));
        let ordered = match (a, b) {
            (Some(a), Some(b)) if b < a => [Some(b), Some(a)],
            (None, b) => [b, None],
            both => both.into(),
        };
        let [first, second] = ordered;
        self.first = self
            .first
            .with(bit, holds_between(low, first.unwrap_or(high)));
        let ends = [second.unwrap_or(high), high];
        for (root, end) in ordered.into_iter().zip(ends) {
            if let Some(at) = root {
                self.insert(Break {
                    at,
                    owners: bit,
                    then_hold: holds_between(at, end),
                })?;
            }
        }
        Ok(())
    }

    /// Sorted insertion; breaks at one place become one.
    fn insert(&mut self, new: Break<R>) -> Result<(), Error> {
        let mut carried = new;
        for slot in &mut self.breaks {
            if carried.at == slot.at {
                slot.owners |= carried.owners;
                slot.then_hold |= carried.then_hold;
                return Ok(());
            }
            if carried.at < slot.at {
                core::mem::swap(slot, &mut carried);
            }
        }
        self.breaks
            .push(carried)
            .map_err(|_| Error::CapacityExceeded("intervals of a region"))
    }
}

/// Whether `gap comparison 0` over a range, leaving room for rounding.
fn range_truth<R: Real>(comparison: Comparison, gap: Range<R>) -> Truth {
    let slack = R::EPSILON * R::from_f64(64.0);
    let above = gap.low - slack * (R::ONE + gap.low.abs()) > R::ZERO;
    let below = gap.high + slack * (R::ONE + gap.high.abs()) < R::ZERO;
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

/// Where a curve may be zero: `line(t) = -factor * |vector(t)|`. A root of the
/// squared equation need not be one of the curve.
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
