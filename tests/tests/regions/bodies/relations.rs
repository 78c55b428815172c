//! Relations read back, are those of plane geometry, and have exact intervals.

use super::check::{check_draws, check_intervals};
use super::plane::{Rectangle, least};
use super::table::{FREE, PLACED, RELATIONS, SLIDING, TABLE, Table, domain_text};
use critreg::domain::Domain;
use critreg::random::{generator, uniform_in};
use critreg::region::Region;
use critreg_tests::text;
use std::f64::consts::{FRAC_PI_2, PI};

#[test]
fn relations_read_back_as_they_are_written() {
    let domain_text = domain_text(FREE);
    let domain = Domain::parse(&domain_text).unwrap();
    for (relation, _) in RELATIONS {
        for text in [
            format!("{relation} >= 0"),
            format!("{relation} < 0.125 and yaw <= 1"),
        ] {
            let region = Region::parse(&domain, &text).expect(&text);
            assert_eq!(text::of_region(&domain, &region), text);
        }
    }
}

#[test]
fn membership_is_that_of_plane_geometry() {
    let domain_text = domain_text(FREE);
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(1);
    for (relation, value) in RELATIONS {
        let bounds = [0.0, 0.05];
        let regions = bounds.map(|k| Region::parse(&domain, &format!("{relation} >= {k}")));
        let mut admitted = [0; 2];
        for instance in 0..240 {
            let is_aligned = instance % 2 == 0;
            let table = Table::draw(&mut rng, is_aligned);
            let numbers = table.numbers();
            let grounded = regions.each_ref().map(|region| {
                let region = region.as_ref().unwrap();
                region.ground::<f64>(&domain, &numbers).unwrap()
            });
            for sample in 0..20 {
                let yaw = match is_aligned && sample % 2 == 0 {
                    true => f64::from(sample / 2 % 4 - 2) * FRAC_PI_2,
                    false => uniform_in(&mut rng, -3.5, 3.5),
                };
                let centre = [0, 1].map(|_| uniform_in(&mut rng, -1.0, 1.0));
                let found = value(&Rectangle::new(centre, yaw, PLACED), &table);
                for ((grounded, bound), count) in grounded.iter().zip(bounds).zip(&mut admitted) {
                    // There rounding decides.
                    if (found - bound).abs() < 1e-9 {
                        continue;
                    }
                    let contained = grounded.contains(&[centre[0], centre[1], yaw]).unwrap();
                    let what = format!("{relation} >= {bound} at {centre:?}, {yaw}: {table:?}");
                    assert_eq!(contained, found >= bound, "{what} is {found}");
                    *count += usize::from(contained);
                }
            }
        }
        assert!(admitted.iter().all(|count| *count > 50), "{relation}");
    }
}

/// In space: a stack on a table with a yaw, and a ball.
#[test]
fn relations_in_space_know_heights() {
    let text = "
        object crate { x: length, y: length, z: length, theta: angle, width: length }
        shape crate = box(crate.width, 0.4, 0.3) centred
        parameter px in [-1, 1]: length
        parameter py in [-1, 1]: length
        parameter pz in [-1, 1]: length
        point ball = world + (px, py, pz)
        shape ball = circle(0.05)
    ";
    let domain = Domain::parse(text).unwrap();
    let mut rng = generator(2);
    type InSpace = (&'static str, fn(&Rectangle, [f64; 3], f64) -> f64);
    let relations: [InSpace; 8] = [
        ("clear(ball, crate)", |outline, [x, y, _], up| {
            let [a, b] = outline.room([x, y]).map(|room| room.min(0.0));
            match a.hypot(b).hypot((0.15 - up.abs()).min(0.0)) {
                0.0 => -1.0,
                far => far - 0.05,
            }
        }),
        ("inside(ball, crate)", |outline, [x, y, _], up| {
            least(outline.room([x, y])).min(0.15 - up.abs()) - 0.05
        }),
        ("inside_x(ball, crate)", |outline, [x, y, _], _| {
            outline.room([x, y])[0] - 0.05
        }),
        ("inside_z(ball, crate)", |_, _, up| 0.1 - up.abs()),
        ("over(ball, crate)", |outline, [x, y, _], _| {
            least(outline.room([x, y]))
        }),
        ("y_in(ball, crate)", |outline, [x, y, _], _| {
            outline.own([x, y])[1]
        }),
        ("z_in(ball, crate)", |_, _, up| up),
        ("abs_z_in(ball, crate)", |_, _, up| up.abs()),
    ];
    for (relation, value) in relations {
        let text = format!("{relation} >= 0.0625");
        let region = Region::parse(&domain, &text).unwrap();
        assert_eq!(text::of_region(&domain, &region), text);
        for instance in 0..200 {
            let [x, y, z] = [0; 3].map(|_| uniform_in(&mut rng, -0.5, 0.5));
            let turn = if instance % 2 == 0 {
                0.0
            } else {
                uniform_in(&mut rng, -PI, PI)
            };
            let width = uniform_in(&mut rng, 0.3, 1.0);
            let outline = Rectangle::new([x, y], turn, [width, 0.4]);
            let numbers = [x, y, z, turn, width];
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            for _ in 0..20 {
                let ball = [x, y, z].map(|middle| middle + uniform_in(&mut rng, -0.4, 0.4));
                let ball = ball.map(|at| at.clamp(-1.0, 1.0));
                let found = value(&outline, ball, ball[2] - z);
                if (found - 0.0625).abs() > 1e-9 {
                    let contained = grounded.contains(&ball).unwrap();
                    assert_eq!(
                        contained,
                        found >= 0.0625,
                        "{relation} {ball:?} {numbers:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn intervals_of_relations_are_exact() {
    let domain_text = domain_text(SLIDING);
    let domain = Domain::parse(&domain_text).unwrap();
    let mut rng = generator(4);
    for (relation, value) in RELATIONS {
        let texts = [
            format!("{relation} >= 0"),
            format!("{relation} >= 0.05"),
            format!("{relation} < 0.05"),
        ];
        let regions = texts.each_ref().map(|text| Region::parse(&domain, text));
        for instance in 0..40 {
            let table = Table::draw(&mut rng, instance % 2 == 0);
            let numbers = table.numbers();
            for ((region, text), index) in regions.iter().zip(&texts).zip(0..) {
                let region = region.as_ref().unwrap();
                let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
                let bound = if index == 0 { 0.0 } else { 0.05 };
                let expected = |p: f64| {
                    let turn = table.rail.1 + FRAC_PI_2;
                    let placed = Rectangle::new(table.on_rail(p), turn, PLACED);
                    Some((value(&placed, &table) >= bound) != (index == 2))
                };
                let what = || format!("{text}: {table:?}");
                check_intervals(&grounded, 1000, &what, &expected);
                check_draws(&grounded, text, &mut rng);
            }
        }
    }
}

/// A gripper that opens: its own size is a parameter.
#[test]
fn a_size_may_depend_on_a_parameter() {
    let text = format!(
        "{TABLE}
        parameter px in [-1, 1]: length
        parameter py in [-1, 1]: length
        parameter opening in [0.02, 0.6]: length
        point hand = world + (px, py)
        shape hand = rectangle(opening, 0.02) centred"
    );
    let domain = Domain::parse(&text).unwrap();
    let mut rng = generator(10);
    for (relation, value) in RELATIONS {
        // Others take the hand for a point.
        if !relation.contains("place") {
            continue;
        }
        let relation = relation.replace("place", "hand");
        let region = Region::parse(&domain, &format!("{relation} >= 0.01")).unwrap();
        for instance in 0..100 {
            let table = Table::draw(&mut rng, instance % 2 == 0);
            let numbers = table.numbers();
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            for _ in 0..20 {
                let [x, y] = [0, 1].map(|_| uniform_in(&mut rng, -1.0, 1.0));
                let opening = uniform_in(&mut rng, 0.02, 0.6);
                let hand = Rectangle::new([x, y], 0.0, [opening, 0.02]);
                let found = value(&hand, &table);
                if (found - 0.01).abs() > 1e-9 {
                    let contained = grounded.contains(&[x, y, opening]).unwrap();
                    let what = format!("{relation} at {hand:?}: {table:?}");
                    assert_eq!(contained, found >= 0.01, "{what}");
                }
            }
            if let Ok(theta) = grounded.sample(&mut rng) {
                let [x, y, opening, ..] = theta;
                let hand = Rectangle::new([x, y], 0.0, [opening, 0.02]);
                let found = value(&hand, &table);
                assert!(found >= 0.01 - 1e-9, "{relation} at {hand:?}: {table:?}");
            }
        }
    }
}
