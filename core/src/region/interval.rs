//! Exact sets of numbers: sorted, disjoint intervals.

use crate::grammar::MAX_CONSTRAINTS;
use crate::real::Real;
use heapless::Vec;

/// Most intervals of a set. Intervals end at roots and at the ends of the line, and a
/// constraint has two roots on average. A constraint about a group can have more, and an
/// interval may begin where another one ends; where the room does not suffice, the last
/// intervals are made one, and the set is too large.
pub const MAX_INTERVALS: usize = MAX_CONSTRAINTS + 1;

/// All numbers between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<R> {
    /// Lower end.
    pub low: R,
    /// Upper end, not below the lower.
    pub high: R,
    /// Whether the lower end belongs to it.
    pub low_closed: bool,
    /// Whether the upper end belongs to it.
    pub high_closed: bool,
}

impl<R: Real> Interval<R> {
    /// Its length.
    pub fn length(&self) -> R {
        self.high - self.low
    }

    /// Whether `value` belongs to it.
    pub fn contains(&self, value: R) -> bool {
        let above = value > self.low || (self.low_closed && value == self.low);
        let below = value < self.high || (self.high_closed && value == self.high);
        above && below
    }

    /// The numbers that belong to both, if there are any.
    pub fn intersection(&self, other: &Interval<R>) -> Option<Interval<R>> {
        let starts_later = self.low > other.low || (self.low == other.low && !self.low_closed);
        let later = if starts_later { self } else { other };
        let ending = if self.ends_before(other) { self } else { other };
        let shared = Interval {
            low: later.low,
            high: ending.high,
            low_closed: later.low_closed,
            high_closed: ending.high_closed,
        };
        let point = shared.low_closed && shared.high_closed;
        let some = shared.low < shared.high || (shared.low == shared.high && point);
        some.then_some(shared)
    }

    /// Whether the other interval has numbers above all numbers of this one, or both end
    /// alike.
    fn ends_before(&self, other: &Interval<R>) -> bool {
        let alike = self.high_closed == other.high_closed || other.high_closed;
        self.high < other.high || (self.high == other.high && alike)
    }
}

/// A set of numbers as sorted intervals that do not touch.
#[derive(Clone, Debug, PartialEq)]
pub struct IntervalSet<R> {
    intervals: Vec<Interval<R>, MAX_INTERVALS>,
    exact: bool,
}

impl<R: Real> Default for IntervalSet<R> {
    fn default() -> Self {
        IntervalSet {
            intervals: Vec::new(),
            exact: true,
        }
    }
}

impl<R: Real> IntervalSet<R> {
    /// The intervals, from low to high.
    pub fn intervals(&self) -> &[Interval<R>] {
        &self.intervals
    }

    /// Whether it is the exact set, and not too large because a constraint has no
    /// closed form.
    pub fn is_exact(&self) -> bool {
        self.exact
    }

    /// Whether no number belongs to it.
    pub fn is_empty(&self) -> bool {
        self.intervals.is_empty()
    }

    /// Whether `value` belongs to it.
    pub fn contains(&self, value: R) -> bool {
        self.intervals.iter().any(|i| i.contains(value))
    }

    /// The sum of the lengths.
    pub fn length(&self) -> R {
        let lengths = self.intervals.iter().map(Interval::length);
        lengths.fold(R::ZERO, |sum, length| sum + length)
    }

    /// The longest interval.
    pub fn widest(&self) -> Option<&Interval<R>> {
        let mut intervals = self.intervals.iter();
        let first = intervals.next()?;
        Some(intervals.fold(
            first,
            |best, i| {
                if i.length() > best.length() { i } else { best }
            },
        ))
    }

    /// The number below which a share of `share` in `[0, 1)` of the set's length
    /// lies, so that a uniform share gives a uniform number. A set without length
    /// gives its first point.
    pub fn quantile(&self, share: R) -> Option<R> {
        self.quantile_inside(share, R::ZERO)
    }

    /// As [`IntervalSet::quantile`], with the share `margin` of every interval left
    /// out at both of its ends.
    pub fn quantile_inside(&self, share: R, margin: R) -> Option<R> {
        // A set may be longer than any number is large; an eighth of it is not.
        let scale = match self.length().is_finite() {
            true => R::ONE,
            false => R::from_f64(0.125),
        };
        let scaled = |interval: &Interval<R>| (interval.high * scale) - (interval.low * scale);
        let lengths = self.intervals.iter().map(scaled);
        let length = lengths.fold(R::ZERO, |sum, length| sum + length);
        let mut left = share * length;
        let last = self.intervals.last()?;
        for interval in &self.intervals {
            let own = scaled(interval);
            if left < own {
                let inner = R::ONE - margin - margin;
                return Some((interval.low * scale + margin * own + inner * left) / scale);
            }
            left -= own;
        }
        // Rounding may leave a rest; a set of points has no length at all.
        let first = self.intervals.first()?;
        Some(if length > R::ZERO {
            last.high
        } else {
            first.low
        })
    }

    /// The numbers that belong to both sets.
    pub fn intersection(&self, other: &IntervalSet<R>) -> IntervalSet<R> {
        let mut both = IntervalSet {
            intervals: Vec::new(),
            exact: self.exact && other.exact,
        };
        let (mut own, mut others) = (self.intervals.iter(), other.intervals.iter());
        let (mut a, mut b) = (own.next(), others.next());
        while let (Some(first), Some(second)) = (a, b) {
            if let Some(shared) = first.intersection(second) {
                both.push(shared);
            }
            // The interval that ends first meets no later one of the other set.
            if first.ends_before(second) {
                a = own.next();
            } else {
                b = others.next();
            }
        }
        both
    }

    /// Removes all intervals.
    fn reset(&mut self, exact: bool) {
        self.intervals.clear();
        self.exact = exact;
    }

    /// Appends an interval, or makes the last one reach to its end.
    fn push(&mut self, interval: Interval<R>) {
        if let Err(interval) = self.intervals.push(interval) {
            self.exact = false;
            if let Some(last) = self.intervals.last_mut() {
                (last.high, last.high_closed) = (interval.high, interval.high_closed);
            }
        }
    }
}

/// Builds a set from breaks that ascend, between which membership is constant.
pub(super) struct Builder<'s, R> {
    set: &'s mut IntervalSet<R>,
    /// Where the interval that is not yet finished starts, and whether that end
    /// belongs to it.
    open: Option<(R, bool)>,
}

impl<'s, R: Real> Builder<'s, R> {
    pub(super) fn new(set: &'s mut IntervalSet<R>, exact: bool) -> Self {
        set.reset(exact);
        Builder { set, open: None }
    }

    /// The next break: whether it belongs to the set, and what follows it.
    pub(super) fn step(&mut self, at: R, here: bool, after: bool) {
        match (self.open, here, after) {
            (None, _, true) => self.open = Some((at, here)),
            (None, true, false) => self.close((at, true), (at, true)),
            (None, false, false) | (Some(_), true, true) => {}
            (Some(low), _, _) => {
                self.close(low, (at, here));
                self.open = after.then_some((at, here));
            }
        }
    }

    /// Finishes an interval with these ends; each with whether it belongs to it.
    fn close(&mut self, low: (R, bool), high: (R, bool)) {
        self.set.push(Interval {
            low: low.0,
            high: high.0,
            low_closed: low.1,
            high_closed: high.1,
        });
    }
}
