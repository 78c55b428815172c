//! The greedy choice of the next form of an explanation.

use super::chosen::first_of;
use super::forms::{Forms, Set, Side};
use super::set::intersect;
use crate::real::Real;

/// By how much the count of a form is reduced in a greedy choice, by the level of
/// its right side.
const REDUCTION: [f64; 4] = [0.0, 0.1, 0.15, 0.2];

/// What an explanation is made with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Taste {
    /// How much chance blurs the counts.
    pub(super) whim: f64,
    /// How much the price of a form counts.
    pub(super) plainness: f64,
}

impl Taste {
    /// The best explanation is made with this.
    pub(super) const SOBER: Taste = Taste {
        whim: 0.0,
        plainness: 1.0,
    };

    /// The taste of a member of the committee: some like it plain, so that chance
    /// chooses among the few simple forms and not among the many others.
    pub(super) fn of_member(member: usize) -> Taste {
        Taste {
            whim: 0.3,
            plainness: if member.is_multiple_of(2) { 1.0 } else { 4.0 },
        }
    }

    /// By which share a count is reduced for a right side.
    pub(super) fn reduction(&self, level: u8) -> f64 {
        let own = REDUCTION.get(usize::from(level)).copied();
        self.plainness * own.unwrap_or(0.0)
    }
}

/// The form that excludes most of `left`, with a preference for simple ones; among
/// equals the one whose bounds are closest, as it fits the boundary best.
pub(super) fn best_side<R: Real>(
    forms: &Forms<'_, R>,
    left: &Set,
    step: usize,
    taste: Taste,
    salt: u32,
) -> Option<Side> {
    let mut best: Option<Side> = None;
    let (mut most, mut closest) = (0.0, R::INFINITY);
    forms.for_each_count(step, left, &mut |side, count| {
        let mut score = f64::from(count) * (1.0 - taste.reduction(side.level));
        if taste.whim > 0.0 {
            score *= 1.0 + taste.whim * scatter(salt, &side);
        }
        if score < most {
            return;
        }
        let mut own = forms.excluded(&side, step);
        intersect(&mut own, left);
        let gap = first_of(forms, &side, &own) - forms.last_feasible(&side, step);
        if score > most || gap < closest {
            (best, most, closest) = (Some(side), score, gap);
        }
    });
    best
}

/// A number in `[0, 1)` that depends on a form and a salt only (a finaliser of
/// MurmurHash3).
fn scatter(salt: u32, side: &Side) -> f64 {
    let mut x = salt ^ (2 * side.form + u32::from(side.upper)).wrapping_mul(0x9E37_79B9);
    x = (x ^ (x >> 16)).wrapping_mul(0x85EB_CA6B);
    x = (x ^ (x >> 13)).wrapping_mul(0xC2B2_AE35);
    f64::from(x ^ (x >> 16)) / 4_294_967_296.0
}
