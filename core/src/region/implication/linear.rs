//! Sums of terms: what two constraints have in common cancels.
//!
//! A box in which a region may hold and a specification may fail is settled at once if the
//! one follows from the other line by line: `s <= l1 * g1 + l2 * g2 + ...` with factors of at
//! least zero, where every `g <= 0` (Farkas 1902). So `x <= 2.9` implies `x <= 3` whatever x is
//! made of, and a distance is at least that along an axis.

use super::outward::{self, point};
use super::tape::{MAX_NODES, Node, Place, Ranges, Tape, range_of};
use crate::domain::Range;
use heapless::Vec;

/// Most terms of a sum; one with more is left as it is.
const MAX_TERMS: usize = 32;

/// How many hypotheses are added to one sum.
const ROUNDS: usize = 3;

/// Factors times terms.
#[derive(Clone, Debug)]
pub(super) struct Sum {
    pub(super) terms: Vec<(Place, Range<f64>), MAX_TERMS>,
    pub(super) constant: Range<f64>,
}

impl Sum {
    /// The factor of a term; the lower end of what is known of it.
    pub(super) fn factor_of(&self, term: Place) -> Option<f64> {
        let found = self.terms.iter().find(|(own, _)| *own == term);
        found.map(|(_, factor)| factor.low)
    }
}

/// The factors of all nodes, while a sum is taken apart.
pub(super) struct Scratch(Vec<Range<f64>, MAX_NODES>);

impl Scratch {
    pub(super) const fn new() -> Self {
        Scratch(Vec::new())
    }

    fn clear(&mut self, length: usize) {
        self.0.clear();
        // No longer than the tape, which is as long at most.
        let _ = self.0.resize(length, point(0.0));
    }

    fn add(&mut self, place: Place, factor: Range<f64>) {
        if let Some(own) = self.0.get_mut(usize::from(place)) {
            *own = outward::plus(*own, factor);
        }
    }
}

/// What a proof line by line is about.
#[derive(Clone, Copy)]
pub(super) struct Lines<'t> {
    pub(super) tape: &'t Tape,
    pub(super) ranges: &'t Ranges,
}

impl Lines<'_> {
    /// A term as a sum of terms that are no sums.
    pub(super) fn sum_of(self, place: Place, scratch: &mut Scratch) -> Option<Sum> {
        scratch.clear(self.tape.nodes.len());
        scratch.add(place, point(1.0));
        self.take_apart(point(0.0), scratch)
    }

    /// Takes sums apart, from the last node to the first.
    fn take_apart(self, mut constant: Range<f64>, scratch: &mut Scratch) -> Option<Sum> {
        let mut terms = Vec::new();
        for (index, node) in self.tape.nodes.iter().enumerate().rev() {
            let factor = scratch.0.get(index).copied()?;
            if factor == point(0.0) {
                continue;
            }
            let place = Place::try_from(index).ok()?;
            match *node {
                Node::Number(number) => {
                    constant = outward::plus(constant, outward::times(factor, point(number)));
                }
                Node::Sum(a, b) => {
                    scratch.add(a, factor);
                    scratch.add(b, factor);
                }
                Node::Difference(a, b) => {
                    scratch.add(a, factor);
                    scratch.add(b, outward::negative(factor));
                }
                Node::Product(a, b) if self.is_known(a) => {
                    scratch.add(b, outward::times(factor, range_of(self.ranges, a)));
                }
                Node::Product(a, b) if self.is_known(b) => {
                    scratch.add(a, outward::times(factor, range_of(self.ranges, b)));
                }
                Node::Magnitude(a) if range_of(self.ranges, a).low >= 0.0 => {
                    scratch.add(a, factor);
                }
                Node::Magnitude(a) if range_of(self.ranges, a).high <= 0.0 => {
                    scratch.add(a, outward::negative(factor));
                }
                _ => terms.push((place, factor)).ok()?,
            }
        }
        Some(Sum { terms, constant })
    }

    fn is_known(self, place: Place) -> bool {
        let own = range_of(self.ranges, place);
        own.low == own.high
    }

    /// Not below any value of a sum.
    fn most(self, sum: &Sum) -> f64 {
        let terms = sum
            .terms
            .iter()
            .fold(sum.constant, |most, (place, factor)| {
                let own = outward::times(*factor, range_of(self.ranges, *place));
                outward::plus(most, own)
            });
        terms.high
    }

    /// Whether a sum is at most a bound wherever all of the hypotheses `g <= 0` hold.
    pub(super) fn follows(
        self,
        mut sum: Sum,
        bound: f64,
        hypotheses: &[Place],
        scratch: &mut Scratch,
    ) -> bool {
        let mut most = self.relax(&mut sum, scratch);
        for _ in 0..ROUNDS {
            if most <= bound {
                return true;
            }
            let mut best: Option<Sum> = None;
            for hypothesis in hypotheses {
                let Some(own) = self.sum_of(*hypothesis, scratch) else {
                    continue;
                };
                let shared = own.terms.iter().filter_map(|(place, factor)| {
                    let of_sum = sum.terms.iter().find(|(other, _)| other == place)?;
                    Some(of_sum.1.low / factor.low)
                });
                for times in shared.chain([1.0]).filter(|times| *times > 0.0) {
                    let Some(mut less) = minus(&sum, times, &own) else {
                        continue;
                    };
                    let own = self.relax(&mut less, scratch);
                    if own < most {
                        most = own;
                        best = Some(less);
                    }
                }
            }
            match best {
                Some(best) => sum = best,
                None => return false,
            }
        }
        most <= bound
    }

    /// Replaces terms by what they are never above of, where that is known to be less; how
    /// much the sum then is at most.
    fn relax(self, sum: &mut Sum, scratch: &mut Scratch) -> f64 {
        let mut most = self.most(sum);
        for index in 0..sum.terms.len() {
            let Some((place, factor)) = sum.terms.get(index).copied() else {
                break;
            };
            let mut better: Option<Sum> = None;
            self.each_bound(place, factor, &mut |other, times| {
                if let Some(own) = self.replaced(sum, index, (other, times), scratch) {
                    let own_most = self.most(&own);
                    if own_most < most {
                        most = own_most;
                        better = Some(own);
                    }
                }
            });
            if let Some(better) = better {
                *sum = better;
                // Its terms are others; what is left to be replaced is little.
                break;
            }
        }
        most
    }

    /// A sum with another term in the place of one.
    fn replaced(
        self,
        sum: &Sum,
        index: usize,
        (other, times): (Place, Range<f64>),
        scratch: &mut Scratch,
    ) -> Option<Sum> {
        scratch.clear(self.tape.nodes.len());
        for (own, (place, factor)) in sum.terms.iter().enumerate() {
            if own != index {
                scratch.add(*place, *factor);
            }
        }
        scratch.add(other, times);
        self.take_apart(sum.constant, scratch)
    }

    /// Visits what a factor times a term is never above of: a factor and a term.
    fn each_bound(
        self,
        place: Place,
        factor: Range<f64>,
        visit: &mut dyn FnMut(Place, Range<f64>),
    ) {
        let is_below = factor.high < 0.0;
        match self.tape.nodes.get(usize::from(place)).copied() {
            // A length is at least each of its coordinates.
            Some(Node::Root(square)) if is_below => {
                self.each_square(square, &mut |own| {
                    let length = self.magnitude_of(own);
                    visit(length.unwrap_or(own), factor);
                    visit(own, outward::negative(factor));
                });
            }
            Some(Node::Magnitude(a)) if is_below => {
                visit(a, factor);
                visit(a, outward::negative(factor));
            }
            Some(Node::Greatest(a, b)) if is_below => {
                visit(a, factor);
                visit(b, factor);
            }
            Some(Node::Least(a, b)) if factor.low > 0.0 => {
                visit(a, factor);
                visit(b, factor);
            }
            _ => {}
        }
    }

    /// Visits the terms whose squares a term is the sum of.
    fn each_square(self, mut place: Place, visit: &mut dyn FnMut(Place)) {
        // Sums of three squares at most.
        for _ in 0..3 {
            match self.tape.nodes.get(usize::from(place)).copied() {
                Some(Node::Square(own)) => return visit(own),
                Some(Node::Sum(a, b)) => {
                    let of = |place: Place| self.tape.nodes.get(usize::from(place)).copied();
                    let (rest, own) = match (of(a), of(b)) {
                        (Some(Node::Square(own)), _) => (b, own),
                        (_, Some(Node::Square(own))) => (a, own),
                        _ => return,
                    };
                    visit(own);
                    place = rest;
                }
                _ => return,
            }
        }
    }

    /// The magnitude of a term, if it is on the tape.
    fn magnitude_of(self, place: Place) -> Option<Place> {
        let wanted = Node::Magnitude(place);
        let found = self.tape.nodes.iter().position(|node| *node == wanted)?;
        Place::try_from(found).ok()
    }
}

/// A sum minus another one, so many times; `None` if it has too many terms.
fn minus(sum: &Sum, times: f64, other: &Sum) -> Option<Sum> {
    let times = point(-times);
    let mut less = sum.clone();
    less.constant = outward::plus(less.constant, outward::times(times, other.constant));
    for (place, factor) in &other.terms {
        let factor = outward::times(times, *factor);
        match less.terms.iter_mut().find(|(own, _)| own == place) {
            Some((_, own)) => *own = outward::plus(*own, factor),
            None => less.terms.push((*place, factor)).ok()?,
        }
    }
    Some(less)
}
