//! One bound of a form: where it lies between the samples it tells apart, and how
//! far single instances stray from it.
//!
//! An action may work a little beyond a boundary in one instance and fail a little
//! before it in another, for example because it moves in steps: every instance has
//! its own boundary, close to that of the constraint. So not the samples on the
//! wrong side count, of which there are as many as were asked there, but the
//! instances and how far they stray.

use super::forms::{Forms, Set, Side, tolerance};
use super::set::members;
use crate::real::Real;
use heapless::Vec;

/// What an instance that strays costs, in bits; what it costs more per range of the
/// form; and what each of its samples costs if it has no boundary of its own.
const STRAY: f64 = 0.7;
const STRAY_PER_RANGE: f64 = 280.0;
const STRAY_SAMPLE: f64 = 2.0;
/// Most instances that stray from one bound.
const MAX_STRAYS: usize = 16;
/// Where between its ends a bound is drawn.
const SHARE: f64 = 0.4;

/// A form with its bounds, outwards: feasible up to `inner`, infeasible from
/// `outer`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bound<R> {
    pub(super) side: Side,
    pub(super) inner: R,
    pub(super) outer: R,
    /// How far the form ranges over the samples.
    pub(super) range: R,
    /// What the samples on the wrong side cost, in bits.
    pub(super) strain: R,
}

/// An instance with samples on the wrong side.
struct Stray<R> {
    instance: usize,
    by: R,
    samples: u32,
}

impl<R: Real> Bound<R> {
    /// A form of which only S is known.
    pub(super) fn inside(forms: &Forms<'_, R>, side: Side, step: usize) -> Self {
        Bound {
            side,
            inner: forms.last_feasible(&side, step),
            outer: R::INFINITY,
            range: R::ZERO,
            strain: R::ZERO,
        }
    }

    /// The bound that has `inside` on the one side and `outside` on the other, with
    /// as little strain as possible. `None` if some instance would stray by more
    /// than `slack` of the form's range.
    pub(super) fn between(
        forms: &Forms<'_, R>,
        side: Side,
        inside: &Set,
        outside: &Set,
        range: R,
        slack: f64,
    ) -> Option<Self> {
        let value = |sample: usize| forms.value_at(&side, sample);
        let last = members(inside).map(value).fold(-R::INFINITY, R::max);
        let first = members(outside).map(value).fold(R::INFINITY, R::min);
        let mut bound = Bound {
            side,
            inner: last,
            outer: first,
            range,
            strain: R::ZERO,
        };
        if first > last + tolerance(last) {
            return Some(bound);
        }
        let zone = range * R::from_f64(slack);
        if last - first >= zone + zone {
            return None;
        }
        let mut best: Option<Self> = None;
        let ends = members(outside).map(value);
        for outer in ends.filter(|end| *end <= first + zone + zone) {
            let below = members(inside).map(value).filter(|v| *v < outer);
            bound.inner = below.fold(-R::INFINITY, R::max);
            bound.outer = outer;
            let open = bound.inner.is_finite() && outer - bound.inner > tolerance(last);
            if open && bound.measure_strain(forms, inside, outside, zone) {
                let better = best.is_none_or(|b| bound.strain < b.strain);
                best = if better { Some(bound) } else { best };
            }
        }
        best
    }

    /// `false` if some instance strays too far.
    fn measure_strain(
        &mut self,
        forms: &Forms<'_, R>,
        inside: &Set,
        outside: &Set,
        zone: R,
    ) -> bool {
        let mut strays: Vec<Stray<R>, MAX_STRAYS> = Vec::new();
        let at = self.middle();
        let mut note = |sample: usize, by: R| {
            if by <= R::ZERO {
                return true;
            }
            let instance = forms.instance_of(sample);
            if let Some(stray) = strays.iter_mut().find(|s| s.instance == instance) {
                stray.by = stray.by.max(by);
                stray.samples += 1;
                return by <= zone;
            }
            let stray = Stray {
                instance,
                by,
                samples: 1,
            };
            strays.push(stray).is_ok() && by <= zone
        };
        let value = |sample: usize| forms.value_at(&self.side, sample);
        let fits = members(inside).all(|sample| note(sample, value(sample) - at))
            && members(outside).all(|sample| note(sample, at - value(sample)));
        if !fits {
            return false;
        }
        let cost = |stray: &Stray<R>| {
            let own = |set| {
                let own = members(set).filter(|s| forms.instance_of(*s) == stray.instance);
                own.map(value)
            };
            let last = own(inside).fold(-R::INFINITY, R::max);
            let first = own(outside).fold(R::INFINITY, R::min);
            let mixed = if last < first { 0.0 } else { STRAY_SAMPLE };
            STRAY
                + STRAY_PER_RANGE * (stray.by / self.range).to_f64()
                + mixed * f64::from(stray.samples)
        };
        self.strain = R::from_f64(strays.iter().map(cost).sum());
        true
    }

    /// Where the bound is drawn.
    pub(super) fn middle(&self) -> R {
        let gap = self.outer - self.inner;
        if gap.is_finite() {
            self.inner + gap * R::from_f64(SHARE)
        } else {
            self.inner
        }
    }

    /// A position between the two ends: zero at the inner, one at the outer.
    pub(super) fn position(&self, value: R) -> R {
        if value <= self.inner {
            return R::ZERO;
        }
        if !self.outer.is_finite() {
            return R::ONE;
        }
        (value - self.inner) / (self.outer - self.inner)
    }
}
