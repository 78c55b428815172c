//! Narrowing a box to what may satisfy hypotheses (HC4, Benhamou et al. 1999): the ranges of
//! terms follow from those of their operands, and the other way round.

use super::outward::{self, common, range};
use super::tape::{Node, Place, Ranges, Tape, range_of};
use crate::domain::Range;

/// No sample of a box satisfies all hypotheses.
pub(super) struct Empty;

/// Narrows the range of a node.
pub(super) fn narrow(ranges: &mut Ranges, place: Place, to: Range<f64>) -> Result<(), Empty> {
    if let Some(own) = ranges.get_mut(usize::from(place)) {
        *own = common(*own, to).ok_or(Empty)?;
    }
    Ok(())
}

/// Narrows the ranges of operands to what explains those of the terms, from the last to the
/// first.
pub(super) fn narrow_operands(tape: &Tape, ranges: &mut Ranges) -> Result<(), Empty> {
    for (place, node) in tape.nodes.iter().enumerate().rev() {
        let Some(own) = ranges.get(place).copied() else {
            continue;
        };
        let of = |place: Place| range_of(ranges, place);
        match *node {
            Node::Number(_) | Node::Slack(_) | Node::Variable(_) | Node::Extreme(..) => {}
            Node::Cut(_, a) => narrow(ranges, a, own)?,
            // Where they turn is left to halving.
            Node::Sine(_) | Node::Cosine(_) | Node::ArcTangent(..) => {}
            Node::Sum(a, b) => {
                let (for_a, for_b) = (outward::minus(own, of(b)), outward::minus(own, of(a)));
                narrow(ranges, a, for_a)?;
                narrow(ranges, b, for_b)?;
            }
            Node::Difference(a, b) => {
                let (for_a, for_b) = (outward::plus(own, of(b)), outward::minus(of(a), own));
                narrow(ranges, a, for_a)?;
                narrow(ranges, b, for_b)?;
            }
            Node::Product(a, b) => {
                let (for_a, for_b) = (outward::quotient(own, of(b)), outward::quotient(own, of(a)));
                narrow(ranges, a, for_a)?;
                narrow(ranges, b, for_b)?;
            }
            Node::Square(a) => {
                let to = from_magnitude(of(a), outward::root(own));
                narrow(ranges, a, to)?;
            }
            Node::Magnitude(a) => {
                let to = from_magnitude(of(a), own);
                narrow(ranges, a, to)?;
            }
            Node::Root(a) => narrow(ranges, a, outward::square(own))?,
            Node::Least(a, b) => {
                let (for_a, for_b) = (chosen_least(own, of(b)), chosen_least(own, of(a)));
                narrow(ranges, a, for_a)?;
                narrow(ranges, b, for_b)?;
            }
            Node::Greatest(a, b) => {
                let [own, a_range, b_range] = [own, of(a), of(b)].map(outward::negative);
                let (for_a, for_b) = (chosen_least(own, b_range), chosen_least(own, a_range));
                narrow(ranges, a, outward::negative(for_a))?;
                narrow(ranges, b, outward::negative(for_b))?;
            }
        }
    }
    Ok(())
}

/// What is known of a number by its magnitude.
fn from_magnitude(own: Range<f64>, magnitude: Range<f64>) -> Range<f64> {
    if own.low > -magnitude.low {
        range(magnitude.low, magnitude.high)
    } else if own.high < magnitude.low {
        range(-magnitude.high, -magnitude.low)
    } else {
        range(-magnitude.high, magnitude.high)
    }
}

/// What is known of a number by the least of it and another one.
fn chosen_least(least: Range<f64>, other: Range<f64>) -> Range<f64> {
    let is_own = other.low > least.high;
    range(least.low, if is_own { least.high } else { f64::INFINITY })
}
