//! What of the grammar finds no room is counted, and the first of it is named.

use critreg::domain::{Domain, NodeId};
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{Learner, Problem};
use critreg_tests::room::VersionSpaceRoom;

const DOMAIN: &str = "
    object a { x: length, y: length } shape a = circle(1)
    object b { x: length, y: length } shape b = circle(1)
    object c { x: length, y: length } shape c = circle(1)
    parameter p in [0, 1]: length
    point hand = world + (p, 0)
";

/// How many left sides a learner with room for so many forms leaves out, and the first.
fn left_out(forms: usize) -> Option<(u32, String)> {
    let domain = Domain::parse(DOMAIN).unwrap();
    let mut room = VersionSpaceRoom::<f64>::new(Capacity::new(forms, 64));
    let learner = room.learner(&domain, Config::default()).unwrap();
    let left_out = learner.left_out(&domain)?;
    let mut text = String::new();
    domain
        .write_expression(&mut text, &[left_out.first.unwrap()], NodeId(0))
        .unwrap();
    Some((left_out.count, text))
}

#[test]
fn where_there_is_room_nothing_is_left_out() {
    let domain = Domain::parse("object a { x: length } parameter p in [0, 1]: length").unwrap();
    let mut room = VersionSpaceRoom::<f64>::new(Capacity::new(64, 16));
    let learner = room.learner(&domain, Config::default()).unwrap();
    assert_eq!(learner.left_out(&domain), None);
}

#[test]
fn relations_of_bodies_stay_and_key_points_go() {
    // 16 left sides have room for coordinates and for most of what is said of whole bodies.
    let (few, first) = left_out(16).unwrap();
    assert!(few > 40, "{few}");
    assert_eq!(first, "over(hand, c)");
    let (fewer, first) = left_out(4096).unwrap();
    assert!(fewer < few);
    // What is left out then are distances to corners.
    assert!(first.contains('.'), "{first}");
}

#[test]
fn right_sides_without_room_are_left_out_too() {
    let domain = Domain::parse(
        "object wall { x: length, y: length }
         parameter reach in [0, 4]: length
         point hand = world + (reach, 0)",
    )
    .unwrap();
    let problem = Problem::new(&domain, &[1.0, 0.0, 2.0, 1.0], 2).unwrap();
    for (forms, lost) in [(4, true), (4096, false)] {
        let mut room = VersionSpaceRoom::<f64>::new(Capacity::new(forms, 64));
        let mut learner = room.learner(&domain, Config::default()).unwrap();
        // All left sides have room; which right sides there are, the instances tell.
        assert_eq!(learner.left_out(&domain), None);
        learner.ask(&problem).unwrap();
        let left_out = learner.left_out(&domain);
        assert_eq!(left_out.is_some(), lost, "{left_out:?}");
        let counted = left_out.map_or(0, |own| own.count as usize);
        assert_eq!(counted, learner.report().forms_left_out);
    }
}
