//! What a conjunction of bounds over one sample cannot say.

use super::scenario::Scenario;
use critreg::domain::Domain;
use critreg::random::{Generator, below, uniform_in};
use critreg::region::Region;

const TABLE: &str = "
    type place { x: length, y: length }
    object cup, lamp: place
    constant margin = 0.25: length
    constant reach = 1.5: length
    constant table.width = 4.0: length
    parameter px in [0, table.width]: length
    parameter py in [0, table.width]: length
    point hand = world + (px, py)
";

const STATES: &str = "
    type place { x: length, y: length }
    object cup, lamp: place
    object robot { x: length, y: length }
    constant margin = 0.25: length
    constant reach = 1.5: length
    constant table.width = 4.0: length
";

const OBSTACLES: &str = "
    object goal { x: length, y: length }
    object obstacle[6] { x: length, y: length }
    constant margin = 0.25: length
    constant reach = 1.5: length
    constant table.width = 4.0: length
    parameter px in [0, table.width]: length
    parameter py in [0, table.width]: length
    point hand = world + (px, py)
";

fn places(count: usize) -> impl Fn(&mut Generator) -> Vec<f64> {
    move |rng| (0..2 * count).map(|_| uniform_in(rng, 0.5, 3.5)).collect()
}

fn scenario(
    name: &'static str,
    text: &'static str,
    truth: &str,
    calls: u32,
    draw: impl Fn(&mut Generator) -> Vec<f64> + Sync + 'static,
) -> Scenario {
    let domain = Domain::parse(text).expect("the text is valid");
    let region = Region::parse(&domain, truth).expect("a valid formula");
    Scenario {
        name,
        ..Scenario::of_region(domain, region, truth.into(), calls, draw)
    }
}

/// An interval of values in which nothing works, with nothing in its middle.
pub fn interval() -> Scenario {
    let truth = "(px - cup.x <= -0.25 or px - cup.x >= 1.5) and dist(hand, lamp) <= 1.5";
    scenario("interval", TABLE, truth, 200, places(2))
}

/// Two pieces: left of one thing, or above another.
pub fn union() -> Scenario {
    let truth = "px <= cup.x - 0.25 or py >= lamp.y + 0.25";
    scenario("union", TABLE, truth, 200, places(2))
}

/// An action without parameters, which works in some states only.
pub fn state() -> Scenario {
    let truth = "dist(robot, cup) <= 1.5 and lamp.y >= 1";
    let scenario = scenario("state", STATES, truth, 200, places(3));
    Scenario {
        instances: 400,
        ..scenario
    }
}

/// Clear of all obstacles, of which there are zero to six.
pub fn groups() -> Scenario {
    let truth = "min(dist(hand, obstacle)) >= 0.75 and px <= goal.x + 0.25";
    scenario("groups", OBSTACLES, truth, 200, |rng| {
        let present = below(rng, 7);
        let own = |index: usize, rng: &mut Generator| match index <= present {
            true => uniform_in(rng, 0.5, 3.5),
            false => f64::NAN,
        };
        (0..14).map(|slot| own(slot / 2, rng)).collect()
    })
}
