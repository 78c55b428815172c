//! Unions of several pieces: how often they are found with so many calls for each constraint.

use super::judge::Truth;
use super::runs::{for_seeds, run_default};
use super::scenario::Scenario;
use super::statistics::Run;
use critreg::learn::version_space::Quality;
use critreg::random::uniform_in;
use std::f64::consts::{PI, TAU};
use std::ops::RangeInclusive;

/// Calls for each constraint of each piece.
const CALLS: usize = 40;
const INSTANCES: usize = 16;

/// Prints for unions of so many pieces, of three kinds, how good what is learned is.
pub fn print(pieces: RangeInclusive<usize>, seeds: usize, first: u64) {
    println!("report: union of pieces\nseeds: {seeds}\n");
    println!(
        "| pieces | of | calls | exact | called exact, and is not | mean P | mean R | no region | calls to exact |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for count in pieces {
        for scenario in [bins(count), faces(count), steps(count)] {
            let runs = for_seeds(seeds, usize::MAX, |index| {
                let seed = first + index as u64;
                run_default(&scenario, &Truth::new(&scenario, seed), seed)
            });
            eprintln!("{count} pieces, {}", scenario.name);
            print_row(count, &scenario, &runs);
        }
    }
}

fn print_row(count: usize, scenario: &Scenario, runs: &[Run]) {
    let exact = runs.iter().filter(|run| run.score.is_exact()).count();
    let called = runs.iter().filter(|run| run.quality == Quality::Exact);
    let overrated = called.filter(|run| !run.score.is_exact()).count();
    let found: Vec<&Run> = runs.iter().filter(|run| run.region.is_some()).collect();
    let mean = |of: fn(&Run) -> f64| {
        let sum: f64 = found.iter().map(|run| of(run)).sum();
        match found.is_empty() {
            true => String::from("-"),
            false => format!("{:.3}", sum / found.len() as f64),
        }
    };
    let (p, r) = (
        mean(|run| run.score.precision),
        mean(|run| run.score.recall),
    );
    let mut calls: Vec<u32> = runs.iter().filter_map(|run| run.calls_to_exact).collect();
    calls.sort_unstable();
    let median = calls.get(runs.len() / 2);
    let median = median.map_or(String::from("never"), u32::to_string);
    let (name, budget, without) = (scenario.name, scenario.calls, runs.len() - found.len());
    println!(
        "| {count} | {name} | {budget} | {exact}/{} | {overrated} | {p} | {r} | {without} | {median} |",
        runs.len()
    );
}

/// So many calls for a union with so many constraints.
fn size(constraints: usize) -> (usize, u32) {
    (INSTANCES, (CALLS * constraints) as u32)
}

/// An object is dropped into one of so many bins, each with a name and a place of its own.
fn bins(count: usize) -> Scenario {
    let mut text = String::from("constant bin.radius = 0.5: length\n");
    for index in 0..count {
        text += &format!("object bin{index} {{ x: length, y: length }}\n");
    }
    text += "parameter px in [0, 3]: length\nparameter py in [0, 3]: length\n";
    text += "point hand = world + (px, py)\n";
    Scenario::of_judge(
        "bins",
        text.leak(),
        size(count),
        move |rng| (0..2 * count).map(|_| uniform_in(rng, 0.3, 2.7)).collect(),
        |bins, hand| {
            let mut bins = bins.chunks_exact(2);
            bins.any(|bin| (hand[0] - bin[0]).hypot(hand[1] - bin[1]) <= 0.5)
        },
    )
}

/// A hand takes a nut by one of so many faces.
fn faces(count: usize) -> Scenario {
    let text = format!(
        "object nut {{ x: length, y: length, theta: angle }}
         object hand {{ x: length, y: length, theta: angle }}
         constant face = {}: angle
         parameter phi in [-pi, pi]: angle
         point jaw = hand turned phi + (0.05, 0)",
        TAU / count as f64
    );
    Scenario::of_judge(
        "faces",
        text.leak(),
        size(count),
        |rng| {
            let mut place = || {
                let x = uniform_in(rng, -0.5, 0.5);
                [x, uniform_in(rng, -0.5, 0.5), uniform_in(rng, -PI, PI)]
            };
            [place(), place()].concat()
        },
        move |i, theta| {
            let turn = TAU / count as f64;
            let off = (i[5] + theta[0] - i[2]).rem_euclid(turn);
            off.min(turn - off) <= 0.2
        },
    )
}

/// A box is put on one of so many boards of a shelf, which stand one above the other: not lower
/// than the board, and not so high that it drops.
fn steps(count: usize) -> Scenario {
    let text = "object shelf { x: length, z: length }
         constant pitch = 0.5: length
         constant drop = 0.2: length
         parameter px in [-1, 1]: length
         parameter pz in [0, 4]: length
         point hand = world + (px, pz)";
    Scenario::of_judge(
        "steps",
        text,
        size(2 * count),
        |rng| vec![uniform_in(rng, -0.5, 0.5), uniform_in(rng, 0.0, 1.0)],
        move |i, theta| {
            let above = theta[1] - i[1];
            (0..count).any(|step| (0.0..=0.2).contains(&(above - 0.5 * step as f64)))
        },
    )
}
