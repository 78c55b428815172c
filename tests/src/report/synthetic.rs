//! Random conjunctions of relational constraints over random instances.

use super::scenario::Scenario;
use critreg::domain::Domain;
use critreg::random::{Generator, below, generator, uniform, uniform_in};
use critreg::region::Region;

const OBJECTS: [&str; 3] = ["cup", "lamp", "shelf"];
/// Answers per constraint.
const CALLS: u32 = 100;
/// Samples that tell whether a conjunction is worth learning.
const TRIALS: usize = 2000;
/// The least share that works, and the least share that each constraint takes away.
const LEAST: f64 = 0.05;

/// One to four constraints over one to four parameters, all of which matter.
pub fn synthetic(seed: u64) -> Scenario {
    let mut rng = generator(seed ^ 0x5E1F);
    let parameters = 1 + below(&mut rng, 4);
    let domain = Domain::parse(text(parameters).leak()).expect("the text is valid");
    loop {
        let count = 1 + below(&mut rng, 4);
        let constraints: Vec<String> = (0..count)
            .map(|_| constraint(parameters, &mut rng))
            .collect();
        if matters(&domain, &constraints, &mut rng) {
            let truth = constraints.join(" and ");
            let region = Region::parse(&domain, &truth).expect("a valid formula");
            let calls = CALLS * count as u32;
            return Scenario::of_region(domain, region, truth, calls, draw);
        }
    }
}

fn text(parameters: usize) -> String {
    let mut text = String::from("type place { x: length, y: length }\n");
    for object in OBJECTS {
        text += &format!("object {object}: place\n");
    }
    text += "constant margin = 0.25: length\nconstant reach = 1.5: length\n";
    text += "constant room.width = 4.0: length\n";
    for index in 0..parameters {
        text += &format!("parameter p{index} in [0, room.width]: length\n");
    }
    let at = |index: usize| match index < parameters {
        true => format!("p{index}"),
        false => String::from("reach"),
    };
    text += &format!("point hand = world + ({}, {})\n", at(0), at(1));
    if parameters > 2 {
        text += &format!("point foot = world + ({}, {})\n", at(2), at(3));
    }
    text
}

fn draw(rng: &mut Generator) -> Vec<f64> {
    let mut place = || uniform_in(rng, 0.5, 3.5);
    (0..2 * OBJECTS.len()).map(|_| place()).collect()
}

fn constraint(parameters: usize, rng: &mut Generator) -> String {
    let points: &[&str] = if parameters > 2 {
        &["hand", "foot"]
    } else {
        &["hand"]
    };
    let mut any = |list: &[&'static str]| list[below(rng, list.len())];
    let (point, object) = (any(points), any(&OBJECTS));
    // Only coordinates that a parameter moves: x and y of the hand, then the foot.
    let place = if point == "foot" { 3 } else { 1 };
    let axis = if place < parameters {
        any(&["x", "y"])
    } else {
        "x"
    };
    let side = any(&["<=", ">="]);
    let length = any(&[
        "margin",
        "reach",
        "0.5*reach",
        "reach - margin",
        "0.25*room.width",
    ]);
    let sign = any(&["+", "-"]);
    match any(&["distance", "axis", "place", "wall"]) {
        "distance" => format!("dist({point}, {object}) {side} {length}"),
        "axis" => format!("dist_{axis}({point}, {object}) {side} {length}"),
        "place" => format!("{point}.{axis} {side} {object}.{axis} {sign} {length}"),
        _ => format!("{point}.{axis} {side} 0.5*room.width {sign} {length}"),
    }
}

fn matters(domain: &Domain<'_>, constraints: &[String], rng: &mut Generator) -> bool {
    let parse = |text: &String| Region::parse(domain, text).expect("a valid formula");
    let regions: Vec<Region> = constraints.iter().map(parse).collect();
    let mut works = 0;
    let mut alone = vec![0; regions.len()];
    for _ in 0..TRIALS {
        let instance = draw(rng);
        let theta: Vec<f64> = domain
            .parameters()
            .iter()
            .map(|p| p.high * uniform(rng))
            .collect();
        let inside = |r: &Region| r.contains::<f64>(domain, &instance, &theta).expect("valid");
        let failed: Vec<usize> = (0..regions.len())
            .filter(|i| !inside(&regions[*i]))
            .collect();
        match failed[..] {
            [] => works += 1,
            [only] => alone[only] += 1,
            _ => {}
        }
    }
    let enough = |count: &usize| *count as f64 >= LEAST * TRIALS as f64;
    enough(&works) && alone.iter().all(enough)
}
