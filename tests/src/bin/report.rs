//! What planning takes with learned regions, in stick-button and in all environments:
//! `report -- <table|domains|an environment> [--seeds N]`.
//!
//! Public planning texts, beside what is recorded in a folder of them:
//! `report -- pddl <folder>`.
//!
//! How often the learners find the true region:
//! `report -- <what> [--seeds N] [--calls N] [--instances N]`.
//!
//! What answers cost that come late, from several workers:
//! `report -- parallel [--seeds N] [--first N]`.
//!
//! What a log teaches, without a question:
//! `report -- passive [--seeds N] [--first N] [--log N] [--noise SHARE]`.
//!
//! What is proven of regions in all instances at once: `report -- proof`.
//!
//! How long a learner takes between two answers: `report -- latency [--seeds N] [--first N] [--only <part of a name>]`.
//!
//! What more problem instances teach, with the same number of calls:
//! `report -- instances [--seeds N] [--first N] [--only <part of a name>]`.
//!
//! How much the numbers matter that decide what is learned:
//! `report -- sensitivity [--seeds N] [--first N] [--only <part of a name>]`.

use critreg_tests::report::{self, Run, Scenario, Statistics};
use std::process::ExitCode;

const USAGE: &str = "usage: report <table|domains|an environment> [--seeds N]\n       report pddl <folder>\n       report proof\n       report \
     <pick|chain|angles|synthetic|noise|interval|union|state|groups> \
     [--seeds N] [--calls N] [--instances N] [--first N] [--list yes]\n       report \
     parallel [--seeds N] [--first N]\n       report \
     passive [--seeds N] [--first N] [--log N] [--noise SHARE]\n       report \
     <instances|latency|sensitivity> [--seeds N] [--first N] [--only <part of a name>]";

struct Options {
    scenario: Scenario,
    seeds: usize,
    first: u64,
    list: bool,
}

fn main() -> ExitCode {
    if let Some(seeds) = seeds_of("table", 10) {
        report::table(seeds);
        return ExitCode::SUCCESS;
    }
    if let Some(seeds) = seeds_of("domains", 3) {
        report::domains(&report::DOMAINS, seeds);
        return ExitCode::SUCCESS;
    }
    if seeds_of("proof", 0).is_some() {
        report::proof();
        return ExitCode::SUCCESS;
    }
    for name in report::DOMAINS {
        if let Some(seeds) = seeds_of(name, 3) {
            report::domains(&[name], seeds);
            return ExitCode::SUCCESS;
        }
    }
    if let Some(folder) = folder_of("pddl") {
        return match report::pddl(folder.as_ref()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("{folder}: {error}");
                ExitCode::FAILURE
            }
        };
    }
    let done = seeded().or_else(|| options().as_ref().map(print));
    match done {
        Some(()) => ExitCode::SUCCESS,
        None => {
            eprintln!("{USAGE}");
            ExitCode::FAILURE
        }
    }
}

/// Prints a report that takes seeds and the first of them, if it is asked for.
fn seeded() -> Option<()> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next()?;
    let (mut seeds, mut first, mut only) = (20, 0, String::new());
    let (mut log, mut noise) = (1000, 0.0);
    while let Some(flag) = arguments.next() {
        let value = arguments.next()?;
        match flag.as_str() {
            "--seeds" => seeds = value.parse().ok()?,
            "--first" => first = value.parse().ok()?,
            "--only" => only = value,
            "--log" => log = value.parse().ok()?,
            "--noise" => noise = value.parse().ok()?,
            _ => return None,
        }
    }
    match name.as_str() {
        "sensitivity" => report::sensitivity(seeds, first, &only),
        "parallel" => report::parallel(seeds, first),
        "latency" => report::latency(seeds, first, &only),
        "instances" => report::instances(seeds, first, &only),
        "passive" => report::passive(seeds, first, log, noise),
        _ => return None,
    }
    Some(())
}

/// The folder that a report is about, if it is asked for.
fn folder_of(name: &str) -> Option<String> {
    let mut arguments = std::env::args().skip(1);
    arguments.next().filter(|own| own == name)?;
    arguments.next()
}

/// The seeds of a report about planning, if it is asked for.
fn seeds_of(name: &str, default: u64) -> Option<u64> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        [own] if own == name => Some(default),
        [own, "--seeds", seeds] if own == name => seeds.parse().ok(),
        _ => None,
    }
}

fn options() -> Option<Options> {
    let mut arguments = std::env::args().skip(1);
    let scenario = match arguments.next()?.as_str() {
        "pick" => report::pick(),
        "chain" => report::chain(),
        "angles" => report::angles(),
        "noise" => report::noise(),
        "synthetic" => report::synthetic(0),
        "interval" => report::interval(),
        "union" => report::union(),
        "state" => report::state(),
        "groups" => report::groups(),
        _ => return None,
    };
    let mut options = Options {
        scenario,
        seeds: 200,
        first: 0,
        list: false,
    };
    while let Some(flag) = arguments.next() {
        let value = arguments.next()?;
        match flag.as_str() {
            "--seeds" => options.seeds = value.parse().ok()?,
            "--calls" => options.scenario.calls = value.parse().ok()?,
            "--instances" => options.scenario.instances = value.parse().ok()?,
            "--first" => options.first = value.parse().ok()?,
            "--list" => options.list = value == "yes",
            _ => return None,
        }
    }
    Some(options)
}

fn print(options: &Options) {
    let Options {
        scenario, first, ..
    } = options;
    let all = report::for_seeds(options.seeds, 100, |index| {
        report::run_seed(scenario, first + index as u64)
    });
    for (place, learner) in report::LEARNERS.into_iter().enumerate() {
        let runs: Vec<Run> = all.iter().map(|runs| runs[place].clone()).collect();
        if options.list {
            for (index, run) in runs.iter().enumerate().filter(|(_, r)| !r.score.is_exact()) {
                let seed = first + index as u64;
                eprintln!("{learner} {seed} {run:?}");
                if scenario.name == "synthetic" {
                    eprintln!("truth {seed} {:?}", report::synthetic(seed).truth);
                }
            }
        }
        println!("report: {}", scenario.name);
        let statistics = Statistics {
            learner,
            instances: scenario.instances,
            calls: scenario.calls,
            runs: &runs,
        };
        statistics.print();
    }
}
