//! What a domain has to say without arithmetic: attributes, coordinates and relations
//! of one dimension.
//!
//! Each function calls `visit` instead of returning an iterator: nested iterators of
//! this kind take a kilobyte of stack, loops next to nothing.

use crate::domain::{Coordinate, Dimension, Domain, Extreme, Metric, Node, Point, Relation};

/// Takes one term after the other.
pub(super) type Visit<'v> = &'v mut dyn FnMut(Node);

/// Says a term as the grammar does: as it is, or, if it is about a group, as the
/// extremes over it. The first member stands for all.
fn say(domain: &Domain<'_>, term: Node, visit: Visit<'_>) {
    let members = domain.members_in(term);
    let mut members = members.iter().flatten();
    match (members.next(), members.next()) {
        (None, _) => visit(term),
        (Some(member), None) if member.index == 0 => {
            if let Some(relation) = Relation::of(term) {
                for extreme in Extreme::ALL {
                    visit(Node::Extreme(extreme, relation));
                }
            }
        }
        _ => {}
    }
}

/// The attributes of objects.
pub(super) fn attributes(domain: &Domain<'_>, dimension: Dimension, visit: Visit<'_>) {
    for (index, (_, attribute)) in (0u8..).zip(domain.slots()) {
        if attribute.dimension == dimension {
            say(domain, Node::Attribute(index), visit);
        }
    }
}

/// The coordinates of sample points, or of key points. Those of an object are
/// its attributes.
pub(super) fn coordinates(
    domain: &Domain<'_>,
    dimension: Dimension,
    sampled: bool,
    visit: Visit<'_>,
) {
    let axes: &[Coordinate] = match (dimension, domain.axes()) {
        (Dimension::Length, 1) => &[Coordinate::X],
        (Dimension::Length, 2) => &[Coordinate::X, Coordinate::Y],
        (Dimension::Length, _) => &[Coordinate::X, Coordinate::Y, Coordinate::Z],
        (Dimension::Angle, _) => &[Coordinate::Theta],
        _ => &[],
    };
    for (index, point) in (0u8..).zip(domain.points()) {
        if point.sampled != sampled || point.is_object() {
            continue;
        }
        for axis in axes {
            if *axis != Coordinate::Theta || point.turn != [None; 3] {
                say(domain, Node::Coordinate(*axis, index), visit);
            }
        }
    }
}

/// Angles at a vertex between the directions to two other points, of the sample or not:
/// where nothing has a heading, they are the angles that there are. Key points are left
/// out, because they lie in the directions of their objects.
fn vertex_angles(domain: &Domain<'_>, sampled: bool, visit: Visit<'_>) {
    if domain.has_headings() {
        return;
    }
    let all = (0u8..).zip(domain.points());
    let points = all.filter(|(_, p)| p.is_object() || p.sampled);
    for (vertex, at) in points.clone() {
        for (a, first) in points.clone().filter(|(a, _)| *a != vertex) {
            let others = points.clone().take_while(|(b, _)| *b < a);
            for (b, second) in others.filter(|(b, _)| *b != vertex) {
                if (at.sampled || first.sampled || second.sampled) == sampled {
                    say(domain, Node::VertexAngle(a, vertex, b), visit);
                }
            }
        }
    }
}

/// Distances, angle differences and areas, of the sample or not.
pub(super) fn relations(
    domain: &Domain<'_>,
    dimension: Dimension,
    sampled: bool,
    visit: Visit<'_>,
) {
    let metrics: &[Metric] = match (dimension, domain.axes()) {
        // On a line there is one way to measure.
        (Dimension::Length, 1) => &[Metric::Straight],
        (Dimension::Length, 2) => &[Metric::X, Metric::Y, Metric::Straight],
        (Dimension::Length, _) => &[Metric::X, Metric::Y, Metric::Z, Metric::Straight],
        _ => &[],
    };
    let angles = dimension == Dimension::Angle;
    for (a, first) in (0u8..).zip(domain.points()) {
        for (b, second) in (0u8..a).zip(domain.points()) {
            if (first.sampled || second.sampled) != sampled {
                continue;
            }
            let (a, b) = ordered((a, first), (b, second));
            for metric in metrics {
                say(domain, Node::Distance(*metric, a, b), visit);
            }
            if angles && first.has_heading() && second.has_heading() {
                say(domain, Node::Angle(a, b), visit);
            }
        }
    }
    if angles {
        vertex_angles(domain, sampled, visit);
    }
    if dimension == Dimension::Area && !sampled {
        for (shape, _) in (0u8..).zip(domain.shapes()) {
            visit(Node::Area(shape));
        }
    }
}

/// The sample point first, as one would say it.
fn ordered((a, first): (u8, &Point<'_>), (b, second): (u8, &Point<'_>)) -> (u8, u8) {
    if second.sampled && !first.sampled {
        (b, a)
    } else {
        (a, b)
    }
}
