//! The features without arithmetic that are about bodies.

use super::leaves::{Visit, moving, places, say, say_least, shown};
use crate::domain::{Beam, Domain, Point, Quantity};
use crate::geometry::{Axis, Relation};

/// Relations between bodies as they are, of the sample or not.
pub(super) fn whole_bodies(domain: &Domain<'_>, sampled: bool, visit: Visit<'_>) {
    for relation in [Relation::Clear, Relation::Inside, Relation::Over] {
        relations_of_bodies(domain, relation, sampled, visit);
    }
}

/// What is less often meant: lines between bodies, their corners, and single axes.
pub(super) fn parts_of_bodies(domain: &Domain<'_>, sampled: bool, visit: Visit<'_>) {
    const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
    if sampled {
        sights(domain, visit);
    }
    relations_of_bodies(domain, Relation::Corner, sampled, visit);
    let axes = AXES.get(..domain.axes()).unwrap_or(&AXES);
    for along in [
        Relation::InsideAlong,
        Relation::Magnitude,
        Relation::Coordinate,
    ] {
        for axis in axes {
            relations_of_bodies(domain, along(*axis), sampled, visit);
        }
    }
}

/// By how much things are off the direction of others, where one of the two moves.
pub(super) fn offs(domain: &Domain<'_>, visit: Visit<'_>) {
    for (b, second) in things(domain).filter(|(b, _)| domain.is_oriented(*b)) {
        for (a, first) in things(domain).filter(|(a, _)| domain.names_place(*a)) {
            if first.owner != second.owner && (first.sampled || second.sampled) {
                say(domain, Quantity::Off(a, b), visit);
            }
        }
    }
}

/// What stands somewhere: objects, and points that move or have a body. Other points only
/// lie on them.
fn things<'d>(domain: &'d Domain<'_>) -> impl Iterator<Item = (u8, &'d Point<'d>)> {
    shown(domain).filter(|(index, point)| {
        point.sampled || point.is_object() || domain.body_of(*index).is_some()
    })
}

/// The numbers of compounds and things: a compound stands before its parts.
fn numbers(domain: &Domain<'_>) -> impl Iterator<Item = u8> {
    let things = things(domain).map(|(index, _)| index);
    let compounds = domain.compound_numbers();
    compounds
        .filter(|number| !domain.is_hidden(*number))
        .chain(things)
}

/// A relation between any two things that stand somewhere, of which one at least has an
/// extent, of the sample or not.
fn relations_of_bodies(domain: &Domain<'_>, relation: Relation, sampled: bool, visit: Visit<'_>) {
    for a in numbers(domain) {
        for b in numbers(domain) {
            let moves = domain.moves(a) || domain.moves(b);
            if moves == sampled && is_said_of(domain, relation, [a, b]) {
                say_least(domain, Quantity::Relation(relation, a, b), visit);
            }
        }
    }
}

fn is_said_of(domain: &Domain<'_>, relation: Relation, [a, b]: [u8; 2]) -> bool {
    let [of_first, of_second] = relation.takes_compounds();
    let is_single = |number| domain.compound(number).is_none();
    let ordered = match relation {
        // The same both ways round: what moves first, as a person would say it.
        Relation::Clear if domain.moves(a) == domain.moves(b) => a > b,
        Relation::Clear => domain.moves(a),
        // Only what has an extent can hold something.
        Relation::Inside | Relation::InsideAlong(_) | Relation::Over => has_extent(domain, b),
        Relation::Corner => domain.parts(a).any(|part| has_corners(domain, part)),
        Relation::Coordinate(_) | Relation::Magnitude(_) => {
            let second = domain.points().get(usize::from(b));
            second.is_some_and(Point::has_heading)
        }
    };
    ordered
        && says_where(domain, relation, [a, b])
        && (of_first || is_single(a))
        && (of_second || is_single(b))
        && (has_extent(domain, a) || has_extent(domain, b))
        && !are_of_one_body(domain, [a, b])
}

/// Whether a relation between two things is one of their places: of two at one place only what
/// depends on how they are turned is said.
fn says_where(domain: &Domain<'_>, relation: Relation, [a, b]: [u8; 2]) -> bool {
    match relation {
        Relation::Inside | Relation::InsideAlong(_) | Relation::Corner => {
            let bodies = has_extent(domain, a) && has_extent(domain, b);
            domain.names_place(a) && (bodies || !domain.coincide(a, b))
        }
        Relation::Clear | Relation::Over => {
            domain.names_place(a) && domain.names_place(b) && !domain.coincide(a, b)
        }
        Relation::Coordinate(_) | Relation::Magnitude(_) => {
            domain.names_place(a) && !domain.coincide(a, b)
        }
    }
}

fn has_extent(domain: &Domain<'_>, number: u8) -> bool {
    let mut parts = domain.parts(number);
    parts.any(|part| domain.body_of(part).is_some())
}

/// Whether a point has a body with corners.
fn has_corners(domain: &Domain<'_>, point: u8) -> bool {
    let body = domain.body_of(point);
    body.is_some_and(|body| body.solid.sizes.iter().flatten().nth(1).is_some())
}

/// Whether two things are one, or parts of one compound.
fn are_of_one_body(domain: &Domain<'_>, [a, b]: [u8; 2]) -> bool {
    let shares = |one, other| {
        let mut parts = domain.parts(one);
        parts.any(|part| domain.parts(other).any(|other| part == other))
    };
    let mut compounds = domain.compound_numbers();
    a == b || compounds.any(|compound| shares(compound, a) && shares(compound, b))
}

/// Lines of sight and straight motions: from a point that moves to one that stands, past a
/// third thing that stands. What one of the ends is placed in is left out, because the end
/// moves with it or is a part of it.
fn sights(domain: &Domain<'_>, visit: Visit<'_>) {
    for (a, start) in moving(domain) {
        for (b, end) in places(domain).filter(|(b, _)| !domain.is_displaced(*b)) {
            // Key points and members of groups would be too many ends.
            let is_single = end.part.is_empty() && end.member.is_none();
            if is_single && end.owner != start.owner {
                sights_between(domain, [a, b], end, visit);
            }
        }
    }
}

fn sights_between(domain: &Domain<'_>, [a, b]: [u8; 2], end: &Point<'_>, visit: Visit<'_>) {
    let of_an_end = |part: u8| {
        let object = domain.object_of(part);
        let same = |end| part == end || object.is_some() && object == domain.object_of(end);
        same(a) || same(b)
    };
    // What drives there takes the place of a thing, or of a circle like itself.
    let drives = domain.is_round(a) && (end.is_object() || domain.is_round(b));
    for beam in [Beam::Line, Beam::Sweep] {
        for body in numbers(domain) {
            let stands = !domain.moves(body) && has_extent(domain, body);
            let apart = !domain.parts(body).any(of_an_end);
            if stands && apart && (beam == Beam::Line || drives) {
                say_least(domain, Quantity::Sight(beam, a, b, body), visit);
            }
        }
    }
}
