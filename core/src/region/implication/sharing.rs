//! Sums that several constraints have in common become terms of their own.
//!
//! Two distances between a hand and a thing depend on where both are in the world by the same
//! differences. So that boxes can be halved along these, and not along each of the many
//! numbers that they are made of, what sums have in common is added up first.

use super::linear::{Lines, Scratch, Sum};
use super::outward::{is_exact_product, point};
use super::tape::{MAX_NODES, Node, Place, Ranges, Tape};
use crate::error::Error;
use heapless::Vec;

/// Most sums that are compared with each other.
const MAX_SUMS: usize = 48;
/// How deep what sums have in common is made of what other sums have in common.
const DEEPEST: u32 = 3;

/// Where terms have gone.
pub(super) type Moved = Vec<Place, MAX_NODES>;

/// Writes a tape anew, with shared sums; `ends` are terms that are wanted.
pub(super) fn share(
    tape: &Tape,
    ranges: &Ranges,
    ends: impl Fn(Place) -> bool,
    shared: &mut Tape,
    moved: &mut Moved,
) -> Result<(), Error> {
    let mut sharing = Sharing {
        lines: Lines { tape, ranges },
        scratch: Scratch::new(),
        sums: Vec::new(),
    };
    for (place, _) in (0..).zip(&tape.nodes) {
        let is_used = ends(place) || tape.nodes.iter().any(|node| bends(*node, place));
        if is_used && sharing.sum(place).is_some() {
            // One that there is no room for shares nothing.
            let _ = sharing.sums.push(place);
        }
    }
    // The variables keep their places.
    shared.variables.clone_from(&tape.variables);
    for (place, node) in (0..).zip(&tape.nodes) {
        let sum = match sharing.sums.contains(&place) {
            true => sharing.sum(place),
            false => None,
        };
        let written = match sum {
            Some(sum) => {
                let written = sharing.write(&sum, place, DEEPEST, shared, moved)?;
                let uses = tape.nodes.iter().filter(|node| bends(**node, place));
                let is_new = matches!(
                    shared.nodes.last(),
                    Some(Node::Sum(..) | Node::Difference(..))
                );
                match uses.count() > 1 && sum.terms.len() > 1 && is_new {
                    true => shared.cut(written)?,
                    false => written,
                }
            }
            None => shared.push(node.with_operands(|operand| at(moved, operand)))?,
        };
        // There is a place for each node.
        let _ = moved.push(written);
        for (one, other) in &tape.equals {
            if *one.max(other) == place {
                // Without room, it is only known that both are equal.
                let _ = shared.equals.push((at(moved, *one), at(moved, *other)));
            }
        }
    }
    Ok(())
}

/// Where a term has gone.
pub(super) fn at(moved: &Moved, place: Place) -> Place {
    moved.get(usize::from(place)).copied().unwrap_or_default()
}

/// Whether a node takes another one and is no sum.
fn bends(node: Node, place: Place) -> bool {
    match node {
        Node::Number(_)
        | Node::Slack(_)
        | Node::Variable(_)
        | Node::Extreme(..)
        | Node::Cut(..)
        | Node::Sum(..)
        | Node::Difference(..) => false,
        Node::Square(a) | Node::Magnitude(a) | Node::Root(a) | Node::Sine(a) | Node::Cosine(a) => {
            a == place
        }
        Node::Product(a, b) | Node::ArcTangent(a, b) | Node::Least(a, b) | Node::Greatest(a, b) => {
            a == place || b == place
        }
    }
}

struct Sharing<'t> {
    lines: Lines<'t>,
    scratch: Scratch,
    /// The sums that constraints are made of.
    sums: Vec<Place, MAX_SUMS>,
}

impl Sharing<'_> {
    /// A term as a sum, if it is one of exact factors.
    fn sum(&mut self, place: Place) -> Option<Sum> {
        let node = self.lines.tape.nodes.get(usize::from(place))?;
        if !matches!(node, Node::Sum(..) | Node::Difference(..)) {
            return None;
        }
        let sum = self.lines.sum_of(place, &mut self.scratch)?;
        let is_exact = sum
            .terms
            .iter()
            .all(|(_, factor)| factor.low == factor.high);
        is_exact.then_some(sum)
    }

    /// Writes a sum: what it has in common with another one first, as a term that boxes are
    /// halved along.
    #[inline(never)]
    fn write(
        &mut self,
        sum: &Sum,
        place: Place,
        depth: u32,
        shared: &mut Tape,
        moved: &Moved,
    ) -> Result<Place, Error> {
        let mut total = None;
        let common = match depth {
            0 => None,
            _ => self.largest_common(sum, (depth == DEEPEST).then_some(place)),
        };
        if let Some((common, factor)) = &common {
            let inner = self.write(common, place, depth - 1, shared, moved)?;
            let inner = shared.cut(inner)?;
            total = Some(shared.add_scaled(None, *factor, inner)?);
        }
        let is_written = |term: Place| {
            let common = common.as_ref();
            common.is_some_and(|(common, _)| common.factor_of(term).is_some())
        };
        for (term, factor) in sum.terms.iter().filter(|(term, _)| !is_written(*term)) {
            total = Some(shared.add_scaled(total, factor.low, at(moved, *term))?);
        }
        shared.add_constant(total, sum.constant)
    }

    /// What a sum has in common with that other one with which it is most, and the factor
    /// that this has in the sum. It is less than all of it, unless the sum is one of those
    /// that constraints are made of.
    fn largest_common(&mut self, sum: &Sum, itself: Option<Place>) -> Option<(Sum, f64)> {
        let mut largest: Option<(Sum, f64)> = None;
        for index in 0..self.sums.len() {
            let other = self.sums.get(index).copied();
            let Some(other) = other.filter(|own| itself != Some(*own)) else {
                continue;
            };
            let Some((common, factor)) = self.sum(other).and_then(|other| in_common(sum, &other))
            else {
                continue;
            };
            let count = common.terms.len();
            let before = largest.as_ref().map_or(1, |(own, _)| own.terms.len());
            if count > before && (itself.is_some() || count < sum.terms.len()) {
                largest = Some((common, factor));
            }
        }
        largest
    }
}

/// What two sums have in common, up to a factor: the terms, of which the first one has the
/// factor one, and the factor of it all in the first sum.
fn in_common(sum: &Sum, other: &Sum) -> Option<(Sum, f64)> {
    let mut largest: Option<(Sum, f64)> = None;
    for (lead, factor) in &sum.terms {
        let Some(ratio) = other.factor_of(*lead).map(|own| own / factor.low) else {
            continue;
        };
        let mut common = Sum {
            terms: Vec::new(),
            constant: point(0.0),
        };
        for (term, own) in &sum.terms {
            let times = own.low / factor.low;
            let is_same = is_product(own.low, times, factor.low)
                && other
                    .factor_of(*term)
                    .is_some_and(|of_other| is_product(of_other, ratio, own.low));
            if is_same {
                common.terms.push((*term, point(times))).ok()?;
            }
        }
        let before = largest.as_ref().map_or(1, |(own, _)| own.terms.len());
        if common.terms.len() > before && common.factor_of(*lead) == Some(1.0) {
            largest = Some((common, factor.low));
        }
    }
    largest.filter(|(common, factor)| {
        // All that shares a sum has to begin with the same term.
        common.terms.first().map(|(_, own)| own.low) == Some(1.0) && *factor != 0.0
    })
}

/// Whether a number is exactly the product of two.
fn is_product(number: f64, a: f64, b: f64) -> bool {
    number == a * b && is_exact_product(a, b)
}
