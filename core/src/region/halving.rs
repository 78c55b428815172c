//! Where a constraint without a closed form holds along a line, by halving: where its range
//! over a part of the line does not decide, the part is cut in two.

use super::choices::Along;
use super::ground::range_truth;
use crate::domain::{Arithmetic, MAX_PARAMETERS, Node, Range, Sample};
use crate::grammar::{Constraint, Truth};
use crate::real::Real;
use heapless::Vec;

/// How often a line is halved at most: what is left undecided is a sixteen-millionth of it.
const MAX_HALVINGS: u32 = 24;
/// Parts of a line to look at, at most. A root takes two for each halving.
const MAX_PARTS: usize = 1024;

/// Visits the parts of a line between two ends from the first to the last, each with where it
/// begins and what is known of the constraint there. What is not decided is not known.
pub(super) fn halve<R: Real>(
    along: Along<'_, '_, R>,
    nodes: &[Node],
    constraint: &Constraint,
    [low, high]: [R; 2],
    visit: &mut dyn FnMut(R, Truth) -> Option<()>,
) -> Option<()> {
    let (mut index, mut halvings) = (0u32, 0u32);
    for part in 0.. {
        let size = (high - low) / R::from_f64(f64::from(1u32 << halvings));
        let at = |index: u32| low + size * R::from_f64(f64::from(index));
        let [from, to] = [at(index), at(index + 1)];
        let truth = truth_between(along, nodes, constraint, [from, to.min(high)]);
        if truth == Truth::UNKNOWN && halvings < MAX_HALVINGS && part < MAX_PARTS {
            (index, halvings) = (2 * index, halvings + 1);
            continue;
        }
        visit(from, truth)?;
        index += 1;
        while index & 1 == 0 && halvings > 0 {
            (index, halvings) = (index / 2, halvings - 1);
        }
        if halvings == 0 {
            break;
        }
    }
    Some(())
}

/// What is known of a constraint between two positions on a line.
#[inline(never)]
fn truth_between<R: Real>(
    along: Along<'_, '_, R>,
    nodes: &[Node],
    constraint: &Constraint,
    [low, high]: [R; 2],
) -> Truth {
    let part = Range { low, high };
    let mut theta: Vec<Range<R>, MAX_PARAMETERS> = Vec::new();
    for line in along.theta {
        // There is room: no action has more parameters.
        let _ = theta.push(part.scaled(line.slope).plus(Range::constant(line.at)));
    }
    let mut sample = Sample::blank(along.scene, &theta);
    sample.place_points();
    let gap = sample.difference(nodes, [constraint.lhs, constraint.rhs]);
    range_truth(constraint.comparison, gap)
}
