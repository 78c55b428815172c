//! Which sums of a left side are worth keeping.

use super::columns::Visit;
use super::left::Left;
use super::sums::{Sum, TERMS, Term};
use super::{Forms, Tuning};
use crate::real::Real;
use crate::table::move_last;
use heapless::Vec;

/// How many looks at forms that are tracked take as long as one at the right side of a sum in
/// an instance, and at what fails there.
const RIGHT_SIDE: usize = 3;

/// Sums that are kept of each left side and direction for what they are worth.
const OF_EACH: usize = 6;

/// The best sums of a left side from one direction.
#[derive(Debug, Default)]
pub(super) struct BestSums {
    /// Those that exclude most for their length, the best one first.
    worthy: Vec<Sum, OF_EACH>,
    /// The one that saves most. Where most of what fails lies far out, many a short one excludes
    /// nearly as much as the right one, for half of its length.
    saving: Option<Sum>,
}

impl BestSums {
    pub(super) fn clear(&mut self) {
        self.worthy.clear();
        self.saving = None;
    }

    /// From the best one on, each once.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Sum> {
        let same = |a: Option<&Sum>, b: &Sum| a.is_some_and(|a| a.is_same(b));
        let (first, saving) = (self.worthy.first(), self.saving.as_ref());
        let second = saving.filter(|own| !same(first, own));
        let others = self.worthy.iter().skip(1);
        let others = others.filter(move |own| !same(saving, own));
        first.into_iter().chain(second).chain(others)
    }

    /// How long a sum may be to become one of them, if it can exclude so many at most.
    fn longest(&self, most: f32, tuning: &Tuning) -> f32 {
        let worthy = match self.worthy.last().filter(|_| self.worthy.is_full()) {
            Some(least) => most / least.worth,
            None => return f32::INFINITY,
        };
        let saved = self.saving.map_or(0.0, |own| saved(&own, tuning));
        worthy.max(price(tuning) * most - saved)
    }

    fn offer(&mut self, new: Sum, tuning: &Tuning) {
        let least = self.saving.map(|own| saved(&own, tuning));
        if least.is_none_or(|least| saved(&new, tuning) > least) {
            self.saving = Some(new);
        }
        let place = self.worthy.iter().position(|own| new.worth > own.worth);
        let place = place.unwrap_or(self.worthy.len());
        if self.worthy.is_full() {
            if place == self.worthy.len() {
                return;
            }
            self.worthy.pop();
        }
        if self.worthy.push(new).is_ok() {
            move_last(&mut self.worthy, place);
        }
    }
}

/// What it costs not to exclude an infeasible sample, in bits.
fn price(tuning: &Tuning) -> f32 {
    tuning.wrong as f32
}

/// By how many bits a sum makes the answers shorter.
fn saved(sum: &Sum, tuning: &Tuning) -> f32 {
    sum.length * (price(tuning) * sum.worth - 1.0)
}

/// Offers the sums of a left side from one direction, at which the ends and failures look.
pub(super) struct Offers<'f, 'm, R> {
    forms: &'f Forms<'m, R>,
    lhs: u8,
    upper: bool,
    /// What it takes to name the left side and the direction, in bits.
    base: f32,
    /// How many infeasible samples can be excluded at most.
    most: f32,
    /// How long a sum may be to be among the best.
    longest: f32,
    pub(super) best: BestSums,
}

impl<'f, 'm, R: Real> Offers<'f, 'm, R> {
    pub(super) fn new(
        forms: &'f Forms<'m, R>,
        left: &Left,
        (lhs, upper): (usize, bool),
        best: BestSums,
    ) -> Self {
        let most = forms.most_excluded() as f32;
        Offers {
            forms,
            lhs: lhs as u8,
            upper,
            base: forms.left_length(lhs, left, upper),
            most,
            longest: best.longest(most, forms.tuning),
            best,
        }
    }

    /// Whether nothing fails beyond what works: then there is nothing to look for.
    pub(super) fn is_void(&self) -> bool {
        self.most <= 0.0
    }
}

impl<R: Real> Visit for Offers<'_, '_, R> {
    fn longest(&self) -> f32 {
        self.longest - self.base
    }

    fn visit(&mut self, terms: [Term; TERMS], length: f32) {
        let length = self.base + length;
        if length >= self.longest {
            return;
        }
        self.forms.add_work(RIGHT_SIDE * self.forms.ends.len());
        let count = self.forms.count_excluded(&terms, self.upper);
        if count > 0 {
            let sum = Sum {
                terms,
                worth: count as f32 / length,
                ..Sum::alone(self.lhs, length)
            };
            self.best.offer(sum, self.forms.tuning);
            self.longest = self.best.longest(self.most, self.forms.tuning);
        }
    }
}
