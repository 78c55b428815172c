//! The search for sums that explain much for their length.
//!
//! For each left side, direction and instance with feasible samples, the end of S of the
//! *left side alone* is all that is needed of these: that of the form is the greatest of
//! those ends minus the right side. So a form costs as much as there are instances and
//! infeasible samples, and nothing is stored for it.

use super::Forms;
use super::columns::{Columns, Effort, PARTS};
use super::interval::excludes;
use super::left::{Left, Tier};
use super::offers::{BestSums, Offers};
use super::sums::{RightSide, Sum, TERMS, Term};
use crate::domain::{Domain, Node, Quantity};
use crate::real::Real;
use crate::table::Blank;

/// One of so many slots at most holds an attribute of the scene alone.
const CASES: usize = 8;

/// What the samples of an instance say about a left side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End<R> {
    /// The value farthest out at a feasible sample.
    feasible: R,
    /// Its infeasible samples, by their places among all.
    first: u32,
    count: u32,
}

impl<R: Real> Blank for End<R> {
    const BLANK: Self = End {
        feasible: R::NEG_INFINITY,
        first: 0,
        count: 0,
    };
}

/// An infeasible sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Failure<R> {
    /// The left side there.
    value: R,
    sample: u32,
}

impl<R: Real> Blank for Failure<R> {
    const BLANK: Self = Failure {
        value: R::ZERO,
        sample: 0,
    };
}

impl<R: Real> Forms<'_, R> {
    /// Begins a search for sums that exclude many infeasible samples of a step, or brings it up
    /// to date; those that are `used` are kept in any case. `false` if there is nothing to
    /// exclude.
    #[inline(never)]
    pub(in super::super) fn begin_search(
        &mut self,
        step: usize,
        anew: bool,
        used: &dyn Fn(u32) -> bool,
    ) -> bool {
        let first = self.sums.first;
        for (slot, sum) in self.sums.slots.iter_mut().enumerate() {
            sum.used = used((first + slot) as u32);
            sum.kept &= sum.used || !anew;
        }
        self.keep_cases();
        !self.sums.slots.is_empty() && self.sort_failures(step)
    }

    /// Keeps attributes of the scene alone, in some of the slots. As long as something works in
    /// each instance nothing is excluded by them, but by what holds in one case of them only:
    /// beside another bound, of which one must hold.
    fn keep_cases(&mut self) {
        let room = self.sums.slots.len() / CASES;
        for lhs in 0..self.lefts.len() {
            let Some(left) = self.left(lhs).filter(|left| left.tier == Tier::Scene) else {
                continue;
            };
            let node = self.features.nodes().get(usize::from(left.feature));
            let Some(Node::Quantity(Quantity::Attribute(_))) = node else {
                continue;
            };
            let case = Sum {
                used: true,
                ..Sum::alone(lhs as u8, self.left_length(lhs, left, true))
            };
            let same = |own: &&mut Sum| own.kept && own.is_same(&case);
            if let Some(own) = self.sums.slots.iter_mut().find(same) {
                own.used = true;
                continue;
            }
            let mut slots = self.sums.slots.iter_mut().take(room);
            if let Some(own) = slots.find(|own| !own.used) {
                *own = case;
            }
        }
        self.evaluate_new_sums();
    }

    /// Looks for sums from a place on, until so much work was done, and keeps the best. A place
    /// is a part of the right sides of a left side from one direction; returns the next one.
    #[inline(never)]
    pub(in super::super) fn search(
        &mut self,
        domain: &Domain<'_>,
        (step, effort): (usize, Effort),
        from: usize,
        most: u32,
    ) -> Option<usize> {
        let columns = self.columns(domain);
        let (mut place, end) = (from, 2 * PARTS * self.lefts.len());
        while place < end && (place == from || self.work() < most) {
            place = self.search_side(&columns, (step, effort), place, most);
        }
        self.evaluate_new_sums();
        (place < end).then_some(place)
    }

    /// Goes on with one direction of a left side, and keeps the best sums at its end.
    fn search_side(
        &mut self,
        columns: &Columns,
        (step, effort): (usize, Effort),
        place: usize,
        most: u32,
    ) -> usize {
        let (side, first) = (place / PARTS, place % PARTS);
        let (lhs, upper) = (side / 2, side.is_multiple_of(2));
        let mut best = core::mem::take(&mut self.sums.best);
        if first == 0 {
            best.clear();
        }
        if let Some(left) = self.lefts.as_slice().get(lhs).copied()
            && self.view_left(step, lhs, upper)
        {
            let mut offers = Offers::new(self, &left, (lhs, upper), best);
            let parts = match offers.is_void() {
                true => 0..0,
                false => first..PARTS,
            };
            for part in parts {
                if part > first && self.work() >= most {
                    self.sums.best = offers.best;
                    return side * PARTS + part;
                }
                columns.for_each_right(&left, effort, part, &mut offers);
            }
            best = offers.best;
        }
        self.keep(&best);
        (side + 1) * PARTS
    }

    /// Sorts the infeasible samples of a step by instance; `false` if there are none.
    fn sort_failures(&mut self, step: usize) -> bool {
        let infeasible = self.sample_set(step, false);
        let mut next = 0;
        for (instance, end) in self.ends.iter_mut().enumerate() {
            let first = next;
            for sample in infeasible.iter() {
                if self.values.instance_of(sample) == instance
                    && let Some(failure) = self.failures.get_mut(next)
                {
                    failure.sample = sample as u32;
                    next += 1;
                }
            }
            (end.first, end.count) = (first as u32, (next - first) as u32);
        }
        next > 0
    }

    /// Looks at the samples from one side of a left side; `false` if it says nothing.
    fn view_left(&mut self, step: usize, lhs: usize, upper: bool) -> bool {
        let feasible = self.sample_set(step, true);
        let outward = |value: R| if upper { value } else { -value };
        for end in self.ends.iter_mut() {
            end.feasible = R::NEG_INFINITY;
        }
        let mut any = false;
        for sample in feasible.iter() {
            let value = outward(self.values.lhs_at(lhs, sample).unwrap_or(R::NAN));
            let instance = self.values.instance_of(sample);
            if let Some(end) = self.ends.get_mut(instance) {
                end.feasible = end.feasible.max(value);
                any = true;
            }
        }
        for failure in self.failures.iter_mut() {
            let value = self.values.lhs_at(lhs, failure.sample as usize);
            failure.value = outward(value.unwrap_or(R::NAN));
        }
        for end in self.ends.iter() {
            let first = end.first as usize;
            let own = self.failures.get_mut(first..first + end.count as usize);
            sort_outermost_first(own.unwrap_or(&mut []));
        }
        any
    }

    /// How many infeasible samples a right side can exclude at most: those that lie farther
    /// out than what works in their instance, whatever is subtracted there.
    pub(super) fn most_excluded(&self) -> usize {
        let own = |end: &End<R>| {
            let beyond = |failure: &&Failure<R>| failure.value > end.feasible;
            self.failures_of(end).iter().take_while(beyond).count()
        };
        self.ends.iter().map(own).sum()
    }

    /// The infeasible samples of an instance; what lies farther out stands before.
    #[inline(always)]
    fn failures_of(&self, end: &End<R>) -> &[Failure<R>] {
        let first = end.first as usize;
        let own = self.failures.get(first..first + end.count as usize);
        own.unwrap_or(&[])
    }

    /// What it takes to name a left side and a direction, in bits.
    pub(super) fn left_length(&self, lhs: usize, left: &Left, upper: bool) -> f32 {
        let tuning = self.tuning;
        let alike = self.lefts.as_slice().iter();
        let alike = alike.filter(|other| other.tier == left.tier).count();
        let tier = match left.tier {
            Tier::Plain => 0.0,
            Tier::Scene | Tier::Derived => tuning.derived,
        };
        let form = super::DirectedForm {
            lhs: lhs as u8,
            ..super::DirectedForm::new(0, upper)
        };
        let class = self.class_length(&form);
        (1.0 + libm::log2(2.0 * alike as f64) + tier + class) as f32
    }

    /// How many infeasible samples a form excludes.
    #[inline(always)]
    pub(super) fn count_excluded(&self, terms: &[Term; TERMS], upper: bool) -> u32 {
        let right_side = RightSide::of(terms, upper);
        let rows = self.values.rhs.chunks_exact(self.values.rhs_count.max(1));
        let instances = || self.ends.iter().zip(rows.clone());
        // How far out something works, and how far out something fails.
        let (mut last, mut reach) = (R::NEG_INFINITY, R::NEG_INFINITY);
        for (end, row) in instances() {
            let right = right_side.value(row);
            if end.feasible > R::NEG_INFINITY {
                last = last.max(end.feasible - right);
            }
            if let [outermost, ..] = self.failures_of(end) {
                reach = reach.max(outermost.value - right);
            }
        }
        if !excludes(last, reach, true) {
            return 0;
        }
        let mut count = 0;
        for (end, row) in instances().filter(|(end, _)| end.count > 0) {
            let right = right_side.value(row);
            let beyond = |failure: &&Failure<R>| excludes(last, failure.value - right, true);
            count += self.failures_of(end).iter().take_while(beyond).count() as u32;
        }
        count
    }

    /// Keeps sums in slots that are free or hold something worth less.
    fn keep(&mut self, best: &BestSums) {
        for (rank, sum) in best.iter().enumerate() {
            // The best one of each left side comes before the second of any.
            let sum = Sum {
                worth: sum.worth - 1e3 * rank as f32,
                ..*sum
            };
            let same = |own: &Sum| own.kept && own.is_same(&sum);
            if let Some(own) = self.sums.slots.iter_mut().find(|own| same(own)) {
                own.worth = own.worth.max(sum.worth);
                continue;
            }
            let free = self.sums.slots.iter_mut().filter(|own| !own.used);
            let worth = |own: &Sum| {
                if own.kept {
                    own.worth
                } else {
                    f32::NEG_INFINITY
                }
            };
            let worst = free.reduce(|a, b| if worth(b) < worth(a) { b } else { a });
            if let Some(own) = worst
                && worth(own) < sum.worth
            {
                *own = sum;
            }
        }
    }
}

/// Sorts the few samples of an instance by insertion; what is no number stands last.
fn sort_outermost_first<R: Real>(failures: &mut [Failure<R>]) {
    for end in 1..=failures.len() {
        let Some((mut last, others)) = failures.get_mut(..end).and_then(<[_]>::split_last_mut)
        else {
            continue;
        };
        for other in others.iter_mut().rev() {
            let no_number = other.value.partial_cmp(&other.value).is_none();
            if last.value.partial_cmp(&last.value).is_none()
                || !(no_number || last.value > other.value)
            {
                break;
            }
            core::mem::swap(other, last);
            last = other;
        }
    }
}
