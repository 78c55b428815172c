//! The features without arithmetic: attributes, coordinates, and relations between
//! points.
//!
//! Each function calls `visit` instead of returning an iterator: nested iterators of
//! this kind take a kilobyte of stack, loops next to nothing.

use crate::domain::{Beam, Coordinate, Dimension, Domain, Extreme, Metric, Node, Point, Quantity};
use crate::geometry::{Axis, Relation};

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

/// As [`say`], without the greatest value: what is clear of one member of a group need not
/// be clear of the others.
fn say_least(domain: &Domain<'_>, quantity: Quantity, visit: Visit<'_>) {
    say(domain, quantity, &mut |term| match term {
        Node::Extreme(Extreme::Greatest, _) => {}
        term => visit(term),
    });
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

/// The angles of headings, of the sample or not, where things look the same after half a
/// turn, a third, a quarter or a sixth of one.
#[allow(dead_code)]
pub(super) fn folded_angles(domain: &Domain<'_>, sampled: bool, visit: Visit<'_>) {
    for symmetry in [2, 3, 4, 6] {
        for (a, first) in (0u8..).zip(domain.points()) {
            for (b, second) in (0u8..a).zip(domain.points()) {
                let turned = first.has_heading() && second.has_heading();
                if turned && (first.sampled || second.sampled) == sampled {
                    let (a, b) = ordered((a, first), (b, second));
                    say(domain, Quantity::FoldedAngle(symmetry, a, b), visit);
                }
            }
        }
    }
}

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// Whether a point has a body with corners.
fn has_corners(domain: &Domain<'_>, point: u8) -> bool {
    let body = domain.body_of(point);
    body.is_some_and(|body| body.solid.sizes.iter().flatten().nth(1).is_some())
}

/// What stands somewhere: objects, and points that move or have a body. Other points only
/// lie on them.
fn things<'d>(domain: &'d Domain<'_>) -> impl Iterator<Item = (u8, &'d Point<'d>)> {
    let points = (0u8..).zip(domain.points());
    points.filter(|(index, point)| {
        point.sampled || point.is_object() || domain.body_of(*index).is_some()
    })
}

/// By how much things are off the direction of others, where one of the two moves.
fn offs(domain: &Domain<'_>, visit: Visit<'_>) {
    for (b, second) in things(domain).filter(|(b, _)| domain.is_turned(*b)) {
        for (a, first) in things(domain) {
            if first.owner != second.owner && (first.sampled || second.sampled) {
                say(domain, Quantity::Off(a, b), visit);
            }
        }
    }
}

/// Relations between bodies, of the sample or not: between any two things that stand
/// somewhere, of which one at least has an extent.
fn body_relations(domain: &Domain<'_>, relations: &[Relation], sampled: bool, visit: Visit<'_>) {
    for relation in relations {
        for (a, first) in things(domain) {
            for (b, second) in things(domain) {
                let ordered = match relation {
                    // The same both ways round: what moves first, as a person would say it.
                    Relation::Clear if first.sampled == second.sampled => a > b,
                    Relation::Clear => first.sampled,
                    // Only what has an extent can hold something.
                    Relation::Inside | Relation::InsideAlong(_) | Relation::Over => {
                        domain.body_of(b).is_some()
                    }
                    Relation::Corner => has_corners(domain, a),
                    Relation::Coordinate(_) | Relation::Magnitude(_) => second.has_heading(),
                };
                let sized = domain.body_of(a).is_some() || domain.body_of(b).is_some();
                let moves = first.sampled || second.sampled;
                if a != b && ordered && sized && moves == sampled {
                    let quantity = Quantity::Relation(*relation, a, b);
                    say_least(domain, quantity, visit);
                }
            }
        }
    }
}

/// Lines of sight and straight motions: from a point that moves to one that stands, past a
/// third thing that stands. What one of the ends is placed in is left out, because the end
/// moves with it or is a part of it.
fn sights(domain: &Domain<'_>, visit: Visit<'_>) {
    for (a, start) in (0u8..).zip(domain.points()).filter(|(_, p)| p.sampled) {
        for (b, end) in (0u8..).zip(domain.points()) {
            // Key points and members of groups would be too many ends.
            let is_single = end.part.is_empty() && end.member.is_none();
            if is_single && !end.sampled && end.owner != start.owner {
                sights_between(domain, [a, b], visit);
            }
        }
    }
}

fn sights_between(domain: &Domain<'_>, [a, b]: [u8; 2], visit: Visit<'_>) {
    let object = |point| domain.object_of(point);
    let of_an_end = |body| {
        let mut ends = [a, b].into_iter();
        ends.any(|end| body == end || object(body).is_some() && object(body) == object(end))
    };
    // What drives there takes the place of a thing, or of a circle like itself.
    let is_object = domain
        .points()
        .get(usize::from(b))
        .is_some_and(Point::is_object);
    let drives = domain.is_round(a) && (is_object || domain.is_round(b));
    for beam in [Beam::Line, Beam::Sweep] {
        for (body, third) in (0u8..).zip(domain.points()) {
            let stands = !third.sampled && domain.body_of(body).is_some();
            if stands && !of_an_end(body) && (beam == Beam::Line || drives) {
                say_least(domain, Quantity::Sight(beam, a, b, body), visit);
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
    let bodies = dimension == Dimension::Length && !domain.bodies().is_empty();
    if bodies {
        const WHOLE: [Relation; 3] = [Relation::Clear, Relation::Inside, Relation::Over];
        body_relations(domain, &WHOLE, sampled, visit);
    }
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
    if bodies {
        if sampled {
            sights(domain, visit);
        }
        body_relations(domain, &[Relation::Corner], sampled, visit);
        let axes = AXES.get(..domain.axes()).unwrap_or(&AXES);
        for along in [
            Relation::InsideAlong,
            Relation::Magnitude,
            Relation::Coordinate,
        ] {
            for axis in axes {
                body_relations(domain, &[along(*axis)], sampled, visit);
            }
        }
    }
    if angles {
        vertex_angles(domain, sampled, visit);
        if sampled && !domain.bodies().is_empty() {
            offs(domain, visit);
        }
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
         shape a = rectangle(1, 2) centred
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

    /// What is said of a domain that begins with one of some words.
    fn said_with(domain: &str, words: &[&str]) -> Vec<String> {
        let domain = Domain::parse(domain).unwrap();
        let said = said(&domain).into_iter();
        let texts = said.map(|(_, term)| written(&domain, term));
        texts
            .filter(|text| words.iter().any(|word| text.starts_with(word)))
            .collect()
    }

    #[test]
    fn sights_are_from_what_moves_to_what_stands_past_a_third_thing() {
        let domain = "object tray { x: length, y: length } shape tray = rectangle(3, 2)
            object post[2] { x: length, y: length } shape post = circle(0.1)
            object cart { x: length, y: length } shape cart = circle(1)
            point spot = tray + (1, 1)
            parameter p in [0, 1]: length
            point hand = world + (p, 0) shape hand = circle(0.5)
            point tip = cart + (p, 1) shape tip = rectangle(0.5, 1)";
        assert_eq!(
            said_with(
                domain,
                &[
                    "clear(line",
                    "clear(sweep",
                    "min(clear(line",
                    "min(clear(sweep"
                ]
            ),
            [
                "min(clear(line(hand, tray), post))",
                "clear(line(hand, tray), cart)",
                "min(clear(sweep(hand, tray), post))",
                "clear(sweep(hand, tray), cart)",
                "clear(line(hand, cart), tray)",
                "min(clear(line(hand, cart), post))",
                "clear(sweep(hand, cart), tray)",
                "min(clear(sweep(hand, cart), post))",
                // The spot is on the tray, and no circle.
                "min(clear(line(hand, spot), post))",
                "clear(line(hand, spot), cart)",
                // The tip goes with the cart.
                "min(clear(line(tip, tray), post))",
                "clear(line(tip, cart), tray)",
                "min(clear(line(tip, cart), post))",
                "min(clear(line(tip, spot), post))",
            ]
        );
        let without = domain.replace("shape", "#");
        assert_eq!(said_with(&without, &["clear", "min(clear"]), [""; 0]);
    }

    #[test]
    fn what_is_off_a_direction_moves_or_is_off_what_moves() {
        let domain = "object eye { x: length, y: length, theta: angle } shape eye = circle(1)
            object mark[2] { x: length, y: length } object sign { x: length, y: length }
            parameter p in [0, 1]: length
            point hand = world + (p, 0) point cam = eye + (p, 0) point cam.lens = cam + (1, 0)";
        assert_eq!(
            said_with(domain, &["off", "min(off", "max(off"]),
            [
                "off(hand, eye)",
                "off(cam, eye)",
                "off(cam.lens, eye)",
                "off(eye, cam)",
                "min(off(mark, cam))",
                "max(off(mark, cam))",
                "off(sign, cam)",
                "off(hand, cam)",
                "off(eye, cam.lens)",
                "min(off(mark, cam.lens))",
                "max(off(mark, cam.lens))",
                "off(sign, cam.lens)",
                "off(hand, cam.lens)",
            ]
        );
        let without = domain.replace("shape", "#");
        assert_eq!(said_with(&without, &["off", "min(off"]), [""; 0]);
    }

    #[test]
    fn folded_angles_are_of_each_pair_of_headings() {
        let domain = "object bar { x: length, y: length, theta: angle }
            object nut[2] { x: length, y: length, theta: angle }
            parameter p in [0, 1]: angle
            point hand = world turned p point tip = hand + (1, 0)";
        let domain = Domain::parse(domain).unwrap();
        let said = |sampled: bool| {
            let mut said = Vec::new();
            folded_angles(&domain, sampled, &mut |term| {
                said.push(written(&domain, term));
            });
            said
        };
        let of_nut = |symmetry| ["min", "max"].map(|extreme| format!("{extreme}({symmetry})"));
        let mut expected: Vec<_> = Vec::new();
        for symmetry in ["pi", "symmetry 3", "0.5*pi", "symmetry 6"] {
            expected.push(format!("angle(hand, bar, {symmetry})"));
            expected.extend(of_nut(format!("angle(hand, nut, {symmetry})")));
        }
        assert_eq!(said(true), expected);
        let standing = said(false);
        assert_eq!(standing.len(), 2 * 4);
        assert_eq!(standing.first().unwrap(), "min(angle(nut, bar, pi))");
        assert_eq!(standing.last().unwrap(), "max(angle(nut, bar, symmetry 6))");
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
