//! The features without arithmetic: attributes, coordinates, and relations between
//! points.
//!
//! Each function calls `visit` instead of returning an iterator: nested iterators of
//! this kind take a kilobyte of stack, loops next to nothing.

use super::body_leaves::{offs, parts_of_bodies, whole_bodies};
use crate::domain::{Coordinate, Dimension, Domain, Extreme, Metric, Node, Point, Quantity};

/// A function that takes one feature after the other.
pub(super) type Visit<'v> = &'v mut dyn FnMut(Node);

/// Visits what the grammar makes of a quantity: the quantity itself, or, if it is about
/// the first member of a group, its extremes over the members.
pub(super) fn say(domain: &Domain<'_>, quantity: Quantity, visit: Visit<'_>) {
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
pub(super) fn say_least(domain: &Domain<'_>, quantity: Quantity, visit: Visit<'_>) {
    say(domain, quantity, &mut |term| match term {
        Node::Extreme(Extreme::Greatest, _) => {}
        term => visit(term),
    });
}

/// The points that relations are enumerated of.
pub(super) fn shown<'d>(
    domain: &'d Domain<'_>,
) -> impl Iterator<Item = (u8, &'d Point<'d>)> + Clone {
    let points = (0u8..).zip(domain.points());
    points.filter(|(index, _)| !domain.is_hidden(*index))
}

/// Those that say where something is.
pub(super) fn places<'d>(
    domain: &'d Domain<'_>,
) -> impl Iterator<Item = (u8, &'d Point<'d>)> + Clone {
    shown(domain).filter(|(index, _)| domain.names_place(*index))
}

/// Those of them whose places move with a parameter.
pub(super) fn moving<'d>(domain: &'d Domain<'_>) -> impl Iterator<Item = (u8, &'d Point<'d>)> {
    places(domain).filter(|(index, _)| domain.is_displaced(*index))
}

/// Whether what is measured between the places of some points is of the sample, or not; what
/// turns with a parameter and stays where it is has no place among the latter.
fn is_between(domain: &Domain<'_>, points: &[(u8, &Point<'_>)], sampled: bool) -> bool {
    match sampled {
        true => points.iter().any(|(index, _)| domain.is_displaced(*index)),
        false => points.iter().all(|(_, point)| !point.sampled),
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
        let is_place = domain.names_place(index) && domain.is_displaced(index) == sampled;
        for axis in axes {
            let says = match axis {
                Coordinate::Theta => point.turn != [None; 3],
                _ => is_place,
            };
            if says {
                say(domain, Quantity::Coordinate(*axis, index), visit);
            }
        }
    }
}

/// Angles at a vertex between the directions to two other points, of the sample or not.
/// Key points are left out, because they lie in the directions of their objects.
pub(super) fn vertex_angles(domain: &Domain<'_>, sampled: bool, visit: Visit<'_>) {
    let points = places(domain).filter(|(_, p)| p.is_object() || p.sampled);
    for (vertex, at) in points.clone() {
        for (a, first) in points.clone().filter(|(a, _)| *a != vertex) {
            let others = points.clone().take_while(|(b, _)| *b < a);
            for (b, second) in others.filter(|(b, _)| *b != vertex) {
                if is_between(domain, &[(vertex, at), (a, first), (b, second)], sampled) {
                    say(domain, Quantity::VertexAngle(a, vertex, b), visit);
                }
            }
        }
    }
}

/// The angles of headings, of the sample or not, where things look the same after half a
/// turn, a third, a quarter or a sixth of one.
pub(super) fn folded_angles(domain: &Domain<'_>, sampled: bool, visit: Visit<'_>) {
    for symmetry in [2, 3, 4, 6] {
        for (a, first) in shown(domain) {
            for (b, second) in shown(domain).take_while(|(b, _)| *b < a) {
                let turned = first.has_heading() && second.has_heading();
                if turned && (first.sampled || second.sampled) == sampled {
                    let (a, b) = ordered((a, first), (b, second));
                    say(domain, Quantity::FoldedAngle(symmetry, a, b), visit);
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
    let bodies = dimension == Dimension::Length && !domain.bodies().is_empty();
    let angles = dimension == Dimension::Angle;
    let pairs = |of_key_points: bool, visit: Visit<'_>| {
        for (a, first) in shown(domain) {
            for (b, second) in shown(domain).take_while(|(b, _)| *b < a) {
                let own = bodies && (first.is_key_point() || second.is_key_point());
                if own != of_key_points {
                    continue;
                }
                let apart = [a, b].iter().all(|point| domain.names_place(*point))
                    && !domain.coincide(a, b)
                    && is_between(domain, &[(a, first), (b, second)], sampled);
                let turned = angles && first.has_heading() && second.has_heading();
                let (a, b) = ordered((a, first), (b, second));
                for metric in metrics.iter().filter(|_| apart) {
                    say(domain, Quantity::Distance(*metric, a, b), visit);
                }
                if turned && (first.sampled || second.sampled) == sampled {
                    say(domain, Quantity::Angle(a, b), visit);
                }
            }
        }
    };
    // What bodies say, their key points seldom say better.
    if bodies {
        whole_bodies(domain, sampled, visit);
    }
    pairs(false, visit);
    if bodies {
        parts_of_bodies(domain, sampled, visit);
        pairs(true, visit);
    }
    if angles {
        // Where nothing has a heading, there are no other angles.
        if !domain.has_headings() {
            vertex_angles(domain, sampled, visit);
        }
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
    fn a_compound_stands_before_its_parts() {
        let domain = "object can[2] { x: length, y: length } shape can = circle(0.1)
            object bin { x: length, y: length } shape bin = rectangle(2, 2) centred
            parameter p in [0, 1]: length
            point grip = world + (p, 0) shape grip = none
            point left = grip + (0, 1) shape left = rectangle(1, 1) centred
            point right = grip + (0, -1) shape right = circle(1)
            shape gripper = left + right";
        assert_eq!(
            said_with(domain, &["clear", "min(clear", "inside(", "corner"]),
            [
                "min(clear(bin, can))",
                "min(clear(gripper, can))",
                "clear(gripper, bin)",
                "min(clear(left, can))",
                "clear(left, bin)",
                "min(clear(right, can))",
                "clear(right, bin)",
                "inside(gripper, bin)",
                "inside(bin, left)",
                "inside(bin, right)",
                "inside(left, bin)",
                "inside(right, bin)",
                "min(clear(line(left, bin), can))",
                "min(clear(line(right, bin), can))",
                "min(clear(sweep(right, bin), can))",
                "corner(gripper, bin)",
                "corner(bin, left)",
                "corner(bin, right)",
                "corner(left, bin)",
            ]
        );
        let of_grip = said_with(domain, &["dist(grip,", "off(grip"]);
        assert_eq!(of_grip, [""; 0]);
        assert_eq!(said_with(domain, &["grip.x", "dist(left, bin)"]).len(), 2);
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
