//! What is placed turns: draws are inside, and what does not fit is proven not to.

use super::plane::{Rectangle, least};
use super::table::{FREE, PLACED, SLIDING_AND_TURNING, Table, domain_text};
use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{Generator, generator, uniform_in};
use critreg::region::Region;
use std::f64::consts::PI;

/// A table with a tray that holds what is placed with room to spare, or is too small for it.
fn table_with_tray(rng: &mut Generator, scale: [f64; 2], moving: &str) -> (Table, Vec<f64>) {
    let mut table = Table::draw(rng, false);
    // Each size of the tray is a multiple of the longest or the shortest size placed.
    let [long, short] = PLACED;
    let [low, high] = scale;
    let placed = if low > 1.0 { long } else { short };
    table.tray.half = [0, 1].map(|_| uniform_in(rng, low, high) * placed / 2.0);
    if moving != FREE {
        // What slides along the rail must get there.
        let near = uniform_in(rng, -0.5, 0.5);
        table.tray.centre = table.on_rail(near);
    }
    let numbers = table.numbers();
    (table, numbers)
}

/// What is placed by some parameters.
fn placed_at(table: &Table, theta: &[f64]) -> Rectangle {
    match *theta {
        [x, y, yaw] => Rectangle::new([x, y], yaw, PLACED),
        // The hand is turned as the rail is.
        [p, yaw] => Rectangle::new(table.on_rail(p), table.rail.1 + yaw, PLACED),
        _ => panic!("two or three parameters"),
    }
}

fn room_in_tray(table: &Table, theta: &[f64]) -> f64 {
    let corners = placed_at(table, theta).corners().into_iter();
    least(corners.flat_map(|corner| table.tray.room(corner)))
}

const TURNING: [&str; 2] = [SLIDING_AND_TURNING, FREE];

#[test]
fn draws_of_what_turns_are_inside() {
    for moving in TURNING {
        let domain_text = domain_text(moving);
        let domain = Domain::parse(&domain_text).unwrap();
        let region = Region::parse(&domain, "inside(place, tray) >= 0").unwrap();
        let count = domain.parameters().len();
        let mut rng = generator(5);
        for _ in 0..40 {
            let (table, numbers) = table_with_tray(&mut rng, [1.3, 2.5], moving);
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            assert_eq!(grounded.is_proven_empty(), Ok(false));
            for _ in 0..5 {
                let theta = grounded.sample(&mut rng).expect("there is room");
                let room = room_in_tray(&table, &theta[..count]);
                assert!(room >= -1e-9, "{room} at {theta:?}: {table:?}");
            }
        }
    }
}

#[test]
fn what_does_not_fit_is_proven_not_to() {
    for moving in TURNING {
        let domain_text = domain_text(moving);
        let domain = Domain::parse(&domain_text).unwrap();
        let region = Region::parse(&domain, "inside(place, tray) >= 0").unwrap();
        let mut rng = generator(6);
        let mut proven = 0;
        for _ in 0..20 {
            let (_, numbers) = table_with_tray(&mut rng, [0.5, 0.9], moving);
            let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
            let drawn = grounded.sample(&mut rng);
            let empty = drawn == Err(Error::EmptyRegion);
            assert!(empty || drawn == Err(Error::NoSample), "{drawn:?}");
            proven += usize::from(empty || grounded.is_proven_empty() == Ok(true));
        }
        let count = domain.parameters().len();
        assert!(proven >= 18, "{proven} of 20 with {count} parameters");
    }
}

#[test]
fn nothing_that_can_be_met_is_called_empty() {
    const TEXTS: [&str; 4] = [
        "inside(place, tray) >= 0",
        "inside(place, tray) >= 0 and min(clear(place, can)) >= 0.01",
        "inside_x(place, tray) >= 0.02 and corner(place, mat) >= 0",
        "over(place, tray) >= 0.1 and clear(place, mat) >= 0",
    ];
    for moving in TURNING {
        let domain_text = domain_text(moving);
        let domain = Domain::parse(&domain_text).unwrap();
        let count = domain.parameters().len();
        let mut rng = generator(7);
        let mut called_empty = 0;
        for text in TEXTS {
            let region = Region::parse(&domain, text).unwrap();
            for _ in 0..20 {
                // About as large as what is placed.
                let (table, numbers) = table_with_tray(&mut rng, [1.0001, 1.3], moving);
                let mut numbers = numbers;
                numbers[4] = uniform_in(&mut rng, 0.15, 0.3);
                let grounded = region.ground::<f64>(&domain, &numbers).unwrap();
                let drawn = grounded.sample(&mut rng);
                if let Ok(theta) = drawn {
                    assert!(grounded.contains(&theta[..count]).unwrap());
                }
                if drawn != Err(Error::EmptyRegion) && grounded.is_proven_empty() != Ok(true) {
                    continue;
                }
                called_empty += 1;
                for sample in 0..2000 {
                    let mut theta: Vec<f64> = (0..count)
                        .map(|_| uniform_in(&mut rng, -1.0, 1.0))
                        .collect();
                    theta[count - 1] *= 3.5;
                    // Half of them close to where the region is, if it is anywhere.
                    if sample % 2 == 0 {
                        let base = if count == 2 { table.rail.1 } else { 0.0 };
                        let yaw = table.tray.turn - base + 0.02 * theta[count - 1];
                        theta[count - 1] = (yaw + PI).rem_euclid(2.0 * PI) - PI;
                        if let [x, y, _] = &mut theta[..] {
                            *x = table.tray.centre[0] + 0.1 * *x;
                            *y = table.tray.centre[1] + 0.1 * *y;
                        }
                    }
                    let contained = grounded.contains(&theta).unwrap();
                    assert!(!contained, "{text} at {theta:?}: {numbers:?}");
                }
            }
        }
        assert!(
            called_empty >= 10,
            "{called_empty} of 80 with {count} parameters"
        );
    }
}
