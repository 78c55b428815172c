//! The features without arithmetic: attributes, coordinates, and relations between
//! points.
//!
//! Each function calls `visit` instead of returning an iterator: nested iterators of
//! this kind take a kilobyte of stack, loops next to nothing.

use crate::domain::{Coordinate, Dimension, Domain, Extreme, Metric, Node, Point, Quantity};

/// A function that takes one feature after the other.
pub(super) type Visit<'v> = &'v mut dyn FnMut(Node);

/// Visits what the grammar makes of a quantity: the quantity itself, or, if it is about
/// the first member of a group, its extremes over the members.
fn say(domain: &Domain<'_>, quantity: Quantity, visit: Visit<'_>) {
    let members = domain.members_in(quantity);
    let mut members = members.iter().flatten();
    match (members.next(), members.next()) {
        (None, _) => visit(Node::Quantity(quantity)),
        (Some(member), None) if member.index == 0 => {
            for extreme in Extreme::ALL {
                visit(Node::Extreme(extreme, quantity));
            }
        }
        _ => {}
    }
}

/// The attributes of objects.
pub(super) fn attributes(domain: &Domain<'_>, dimension: Dimension, visit: Visit<'_>) {
    for (index, (_, attribute)) in (0u8..).zip(domain.slots()) {
        if attribute.dimension == dimension {
            say(domain, Quantity::Attribute(index), visit);
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
                say(domain, Quantity::Coordinate(*axis, index), visit);
            }
        }
    }
}

/// Angles at a vertex between the directions to two other points, of the sample or not.
/// Where nothing has a heading, there are no other angles. Key points are left out,
/// because they lie in the directions of their objects.
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
                    say(domain, Quantity::VertexAngle(a, vertex, b), visit);
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
        // On a line all distances are the same.
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
                say(domain, Quantity::Distance(*metric, a, b), visit);
            }
            if angles && first.has_heading() && second.has_heading() {
                say(domain, Quantity::Angle(a, b), visit);
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

/// The sample point first, as a person would say it.
fn ordered((a, first): (u8, &Point<'_>), (b, second): (u8, &Point<'_>)) -> (u8, u8) {
    if second.sampled && !first.sampled {
        (b, a)
    } else {
        (a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::NodeId;
    use crate::text::Lexer;
    use heapless::Vec as Nodes;
    use std::format;
    use std::string::{String, ToString};
    use std::vec::Vec;

    /// With headings and without, a group, a shape, and a parameter.
    const DOMAINS: [&str; 2] = [
        "object a { x: length, y: length, z: length, theta: angle }
         object b { x: length, y: length, z: length, theta: angle } shape b = circle(1)
         object c[2] { x: length, y: length, z: length, theta: angle }
         parameter p in [0, 1]: length point q = a turned 1 + (p, 0)",
        "object a { x: length, y: length } object c[2] { x: length, y: length }
         parameter p in [0, 1]: length point q = world + (p, 0)",
    ];

    /// What there is to say, with its dimension.
    fn said(domain: &Domain<'_>) -> Vec<(Dimension, Node)> {
        let mut said = Vec::new();
        for dimension in Dimension::ALL {
            attributes(domain, dimension, &mut |term| said.push((dimension, term)));
            for sampled in [false, true] {
                let mut say = |term| said.push((dimension, term));
                coordinates(domain, dimension, sampled, &mut say);
                relations(domain, dimension, sampled, &mut say);
            }
        }
        said
    }

    fn written(domain: &Domain<'_>, term: Node) -> String {
        let mut text = String::new();
        domain
            .write_expression(&mut text, &[term], NodeId(0))
            .unwrap();
        text
    }

    #[test]
    fn what_is_said_has_a_text_and_a_dimension() {
        for domain in DOMAINS {
            let domain = Domain::parse(domain).unwrap();
            let said = said(&domain);
            assert!(said.len() > 30, "{}", said.len());
            for (dimension, term) in said {
                let text = written(&domain, term);
                let mut nodes: Nodes<Node, 1> = Nodes::new();
                let id = domain.parse_expression(&mut Lexer::new(&text), &mut nodes);
                assert_eq!(nodes.as_slice(), [term], "{text}");
                assert_eq!(
                    domain.dimension(&nodes, id.unwrap()),
                    Some(dimension),
                    "{text}"
                );
            }
        }
    }

    #[test]
    fn every_function_of_the_texts_is_said() {
        let error = Domain::parse("constant c = nothing(1): none")
            .unwrap_err()
            .to_string();
        let (_, functions) = error.split_once("there are ").unwrap();
        let texts: Vec<_> = DOMAINS
            .into_iter()
            .flat_map(|domain| {
                let domain = Domain::parse(domain).unwrap();
                let texts = said(&domain)
                    .into_iter()
                    .map(|(_, term)| written(&domain, term));
                texts.collect::<Vec<_>>()
            })
            .collect();
        for function in functions.split(", ") {
            let call = format!("{function}(");
            assert!(
                texts.iter().any(|text| text.starts_with(&call)),
                "{function}"
            );
        }
    }
}
