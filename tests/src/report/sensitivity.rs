//! How much the numbers matter that decide what is learned: each of them is halved and
//! doubled, and the regions that are exact then are counted.

use super::judge::Truth;
use super::runs::{for_seeds, is_exact, with_seed};
use super::scenario::{Scenario, chain, noise, pick};
use super::shapes::{groups, interval, union};
use super::synthetic;
use critreg::learn::Config;
use critreg::learn::version_space::Tuning;

/// Prints, tab-separated, how many of so many seeds are exact in each scenario: with the
/// numbers as they were chosen, and with each of them halved and doubled. Those whose name
/// does not contain `only` are left out.
pub fn print(seeds: usize, first: u64, only: &str) {
    let scenarios = [
        pick(),
        chain(),
        interval(),
        union(),
        groups(),
        synthetic(0),
        noise(),
    ];
    let variants = variants(only);
    let counts: Vec<Vec<Vec<bool>>> = for_seeds(seeds, 1, |index| {
        let seed = first + index as u64;
        let exact = |scenario: &Scenario| exact_with(&variants, scenario, seed);
        scenarios.iter().map(exact).collect()
    });
    let names: Vec<&str> = scenarios.iter().map(|s| s.name).collect();
    println!(
        "number\tfactor\t{}\tall of {}",
        names.join("\t"),
        seeds * names.len()
    );
    for (place, variant) in variants.iter().enumerate() {
        let of_scenario = |s: usize| counts.iter().filter(|seed| seed[s][place]).count();
        let own: Vec<usize> = (0..scenarios.len()).map(of_scenario).collect();
        let texts: Vec<String> = own.iter().map(usize::to_string).collect();
        let all: usize = own.iter().sum();
        let Variant { name, factor, .. } = variant;
        println!("{name}\t{factor}\t{}\t{all}", texts.join("\t"));
    }
}

/// Numbers of which at most one is not as it was chosen.
struct Variant {
    name: &'static str,
    factor: f64,
    tuning: &'static Tuning,
}

fn variants(only: &str) -> Vec<Variant> {
    let mut all = vec![Variant {
        name: "as chosen",
        factor: 1.0,
        tuning: &Tuning::CHOSEN,
    }];
    for name in Tuning::NAMES.iter().filter(|name| name.contains(only)) {
        for factor in [0.5, 2.0] {
            let tuning = Tuning::CHOSEN.scaled(name, factor).expect("its name");
            all.push(Variant {
                name,
                factor,
                // A configuration borrows its numbers for good; there are few.
                tuning: Box::leak(Box::new(tuning)),
            });
        }
    }
    all
}

fn exact_with(variants: &[Variant], scenario: &Scenario, seed: u64) -> Vec<bool> {
    with_seed(scenario, seed, |scenario| {
        let truth = Truth::new(scenario, seed);
        let exact = |variant: &Variant| {
            let config = Config {
                tuning: variant.tuning,
                ..scenario.config(seed)
            };
            is_exact(scenario, &truth, seed, config)
        };
        variants.iter().map(exact).collect()
    })
}
