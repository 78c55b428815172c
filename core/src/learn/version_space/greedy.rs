//! The greedy choice of the next bound of a hypothesis.

use super::forms::{DirectedForm, SUM_LEVEL, SampleSet, StepView};
use super::tuning::Tuning;
use crate::real::Real;

/// Levels of right sides, sums among them.
const LEVELS: usize = SUM_LEVEL as usize + 1;

/// By how much chance and complexity change what the greedy choice counts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Randomisation {
    /// How much chance blurs the counts, as a share.
    pub(super) noise: f64,
    /// How much the discount of complex forms counts.
    pub(super) complexity_weight: f64,
}

impl Randomisation {
    /// No chance: the plain greedy choice.
    pub(super) const GREEDY: Randomisation = Randomisation {
        noise: 0.0,
        complexity_weight: 1.0,
    };

    /// That of a member of the committee: every other one discounts complex forms more, so
    /// that chance chooses among the few simple forms and not among the many others.
    pub(super) fn of_member(member: usize, tuning: &Tuning) -> Randomisation {
        Randomisation {
            noise: tuning.committee_noise,
            complexity_weight: if member.is_multiple_of(2) {
                1.0
            } else {
                tuning.committee_plainness
            },
        }
    }

    /// By which share a count is discounted for the level of a right side: less than all of it,
    /// however much discounts count.
    pub(super) fn discount(&self, level: u8, tuning: &Tuning) -> f64 {
        let discount = match level {
            0 => 0.0,
            1 => tuning.discount_attribute,
            2 => tuning.discount_distance,
            SUM_LEVEL => tuning.discount_sum,
            _ => tuning.discount_scaled,
        };
        1.0 - libm::pow(1.0 - discount, self.complexity_weight)
    }
}

/// The form that excludes most of `open`, with a preference for simple ones; among
/// equals the one whose ends are closest, as it fits the boundary best.
pub(super) fn best_form<R: Real>(
    view: &StepView<'_, '_, R>,
    open: &SampleSet,
    randomisation: Randomisation,
    salt: u32,
) -> Option<DirectedForm> {
    let tuning = view.forms.tuning();
    let left: [f64; LEVELS] =
        core::array::from_fn(|level| 1.0 - randomisation.discount(level as u8, tuning));
    let mut best: Option<DirectedForm> = None;
    let (mut most, mut closest) = (0.0, R::INFINITY);
    view.for_each_count(open, &mut |form, count| {
        let left = left.get(usize::from(form.level)).copied();
        let mut score = f64::from(count) * left.unwrap_or(0.0);
        if randomisation.noise > 0.0 {
            score *= 1.0 + randomisation.noise * scatter(salt, &form);
        }
        if score < most {
            return;
        }
        let mut own = view.excluded(&form);
        own.intersect(open);
        let gap = view.first_of(&form, &own) - view.last_feasible(&form);
        if score > most || gap < closest {
            (best, most, closest) = (Some(form), score, gap);
        }
    });
    best
}

/// A number in `[0, 1)` that depends on a form and a salt only (a finaliser of
/// MurmurHash3).
fn scatter(salt: u32, form: &DirectedForm) -> f64 {
    let mut x = salt ^ form.side.wrapping_mul(0x9E37_79B9);
    x = (x ^ (x >> 16)).wrapping_mul(0x85EB_CA6B);
    x = (x ^ (x >> 13)).wrapping_mul(0xC2B2_AE35);
    f64::from(x ^ (x >> 16)) / 4_294_967_296.0
}
