//! Which variable matters most: the one that moves the constraints most while it moves
//! through its range (the largest smear, Kearfott 1996).

use super::outward::magnitude;
use super::tape::{
    Corners, MAX_CUTS, MAX_NODES, MAX_VARIABLES, Node, Place, Ranges, Tape, range_of,
};
use heapless::Vec;

/// By how much a box can be halved along a variable still: a share of its size.
const FINEST: f64 = 1e-13;

/// By how much less counts what moves constraints by a term only that a box is halved along
/// itself: a box is halved along it where that term is small already.
const BEHIND: f64 = 0.002;

/// The variable that a box is best halved along; `None` if it is too small along all.
pub(super) fn most_sensitive(
    tape: &Tape,
    ranges: &Ranges,
    corners: &Corners,
    terms: impl Iterator<Item = Place>,
) -> Option<usize> {
    let slopes = slopes(tape, ranges, terms);
    let mut best = None;
    let mut most = -1.0;
    for (index, own) in corners.iter().enumerate() {
        let width = own.high - own.low;
        let is_fine = width <= FINEST * (1.0 + own.low.abs().max(own.high.abs()));
        let smear = slopes.get(index).copied().unwrap_or(0.0) * width;
        // Where nothing is known of how steep terms are, the widest one.
        let smear = if smear.is_finite() {
            smear
        } else {
            f64::MAX * 0.5
        };
        if !is_fine && smear > most {
            (best, most) = (Some(index), smear);
        }
    }
    best
}

/// How steep the terms are at most, along each variable: differentiated backwards.
fn slopes(
    tape: &Tape,
    ranges: &Ranges,
    terms: impl Iterator<Item = Place>,
) -> Vec<f64, { MAX_VARIABLES + MAX_CUTS }> {
    let mut slopes: Vec<f64, MAX_NODES> = Vec::new();
    let mut of_corners: Vec<f64, { MAX_VARIABLES + MAX_CUTS }> = Vec::new();
    // There is as much room as there is for nodes and variables.
    let _ = slopes.resize(tape.nodes.len(), 0.0);
    let _ = of_corners.resize(tape.variables.len() + usize::from(tape.cuts), 0.0);
    for place in terms {
        // So that wide constraints do not hide narrow ones.
        let own = range_of(ranges, place);
        let scale = own.high - own.low;
        if let Some(slope) = slopes.get_mut(usize::from(place))
            && scale > 0.0
        {
            *slope += if scale.is_finite() { 1.0 / scale } else { 1.0 };
        }
    }
    let size = |place: Place| magnitude(range_of(ranges, place)).high;
    for (place, node) in tape.nodes.iter().enumerate().rev() {
        let slope = slopes.get(place).copied().unwrap_or(0.0);
        if slope == 0.0 {
            continue;
        }
        if let Some(corner) = tape.corner_of(*node)
            && let Some(own) = of_corners.get_mut(corner)
        {
            *own = slope;
        }
        let mut add = |place: Place, factor: f64| {
            if let Some(own) = slopes.get_mut(usize::from(place)) {
                *own += slope * factor;
            }
        };
        match *node {
            Node::Number(_) | Node::Slack(_) | Node::Variable(_) | Node::Extreme(..) => {}
            Node::Sum(a, b) | Node::Difference(a, b) | Node::Least(a, b) | Node::Greatest(a, b) => {
                add(a, 1.0);
                add(b, 1.0);
            }
            Node::Product(a, b) => {
                add(a, size(b));
                add(b, size(a));
            }
            Node::Cut(_, a) => add(a, BEHIND),
            Node::Square(a) => add(a, 2.0 * size(a)),
            Node::Magnitude(a) | Node::Sine(a) | Node::Cosine(a) => add(a, 1.0),
            Node::Root(a) => {
                let least = range_of(ranges, a).low.max(0.0);
                let widest = range_of(ranges, a).high;
                // A secant, where the tangent would be upright.
                add(a, 1.0 / crate::real::Real::sqrt(least.max(0.01 * widest)));
            }
            Node::ArcTangent(y, x) => {
                let [nearest_y, nearest_x] =
                    [y, x].map(|place| magnitude(range_of(ranges, place)).low);
                let nearest = nearest_y.max(nearest_x).max(1e-3);
                add(y, 1.0 / nearest);
                add(x, 1.0 / nearest);
            }
        }
    }
    of_corners
}
