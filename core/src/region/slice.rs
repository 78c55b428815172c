//! What a region admits along a line of parameters, exactly.

use super::gaps::{Along, Gaps};
use super::interval::{Builder, IntervalSet, MAX_BREAKS};
use super::parameters::Vector;
use super::{MAX_REGION_POINTS, Region};
use crate::domain::{Arithmetic, Curve, Line, MAX_PARAMETERS, Scene};
use crate::error::Error;
use crate::grammar::{Comparison, MAX_CONSTRAINTS};
use crate::real::Real;
use heapless::Vec;

/// Sets `set` to the admitted positions `t` between two ends on the line
/// `origin + t * direction`.
///
/// The line is cut at the roots of the constraints; between two neighbouring
/// ones nothing changes. At a root its own constraint holds if it admits
/// equality. Where a constraint has no closed form the set is too large.
pub(super) fn slice<R: Real>(
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
        let bit = 1u32.checked_shl(index as u32).unwrap_or(0);
        let left = sample.measure(formula.nodes(), constraint.left);
        let curve = left.minus(sample.measure(formula.nodes(), constraint.right));
        if curve.is_finite() {
            cut.add(bit, &curve, constraint.comparison)?;
        } else {
            let along = Along {
                scene,
                theta: &theta,
                sample: &sample,
            };
            match Gaps::new(along, formula.nodes(), constraint) {
                Some(gaps) => cut.add_extremes(bit, &gaps)?,
                None => cut.add_unknown(bit),
            }
        }
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

    /// The ends of the line.
    fn ends(&self) -> (R, R) {
        let at = |end: Option<&Break<R>>| end.map_or(R::ZERO, |b| b.at);
        (at(self.breaks.first()), at(self.breaks.last()))
    }

    /// Cuts at the roots of a constraint, and evaluates it once between them.
    fn add(&mut self, bit: u32, curve: &Curve<R>, comparison: Comparison) -> Result<(), Error> {
        if comparison.admits_equal() {
            self.admit_equal |= bit;
        }
        let (low, high) = self.ends();
        let holds_between = |a: R, b: R| {
            let value = curve.value(middle(a, b));
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
            // One root that was found twice: nothing lies between.
            (a, b) if a == b => [a, None],
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

    /// As [`Cut::add`] for a constraint with extremes: it is cut at the roots of all
    /// choices of members at which its sides are equal.
    fn add_extremes(&mut self, bit: u32, gaps: &Gaps<'_, '_, R>) -> Result<(), Error> {
        if gaps.comparison().admits_equal() {
            self.admit_equal |= bit;
        }
        let (low, mut end) = self.ends();
        for curve in gaps.curves() {
            let inside = |t: &R| low <= *t && *t <= end && curve.is_near_zero(*t);
            let equal = |t: &R| inside(t) && gaps.is_near_zero(*t);
            for at in roots(&curve).into_iter().flatten().filter(equal) {
                self.insert(Break {
                    at,
                    owners: bit,
                    then_hold: 0,
                })?;
            }
        }
        let holds_between = |a: R, b: R| gaps.holds(middle(a, b));
        for own in self.breaks.iter_mut().rev() {
            if own.owners & bit != 0 {
                own.then_hold |= if holds_between(own.at, end) { bit } else { 0 };
                end = own.at;
            }
        }
        let holding = if holds_between(low, end) { bit } else { 0 };
        self.first = self.first.with(bit, holding);
        Ok(())
    }

    /// Nothing is known of a constraint without closed form.
    fn add_unknown(&mut self, bit: u32) {
        self.first.hold |= bit;
        self.first.fail |= bit;
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

fn middle<R: Real>(a: R, b: R) -> R {
    a + (b - a) * R::from_f64(0.5)
}

/// Where a curve may be zero: `line(t) = -factor * |vector(t)|`. A root of the
/// squared equation need not be one of the curve.
fn roots<R: Real>(curve: &Curve<R>) -> [Option<R>; 2] {
    let Some(curve) = curve.without_angle() else {
        return [None, None];
    };
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
