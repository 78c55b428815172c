//! What planning takes with learned regions, in stick-button and in all environments:
//! `report -- <table|domains|an environment> [--seeds N]`.
//!
//! Public planning texts, beside what is recorded in a folder of them:
//! `report -- pddl <folder>`.
//!
//! How often the learners find the true region:
//! `report -- <what> [--seeds N] [--calls N] [--instances N]`.
//!
//! How often a union of so many pieces is found:
//! `report -- union --pieces <N or N..N> [--seeds N] [--first N]`.
//!
//! Whether a learner says why there is no exact region:
//! `report -- why [--seeds N] [--first N] [--only <part of a cause>]`.
//!
//! How many calls it takes, beside the bits that there are to find out:
//! `report -- queries [--seeds N] [--first N]`.
//!
//! What few calls teach: `report -- budget [--scenario <what>] [--seeds N] [--first N]`.
//!
//! How good the region is where the truth is none that the text can say, and what is said of
//! it: `report -- approximate [--seeds N] [--first N] [--wanted SHARE] [--only <part of a name>]`.
//!
//! What answers cost that come late, from several workers:
//! `report -- parallel [--seeds N] [--first N]`.
//!
//! What a log teaches, without a question:
//! `report -- passive [--seeds N] [--first N] [--log N] [--noise SHARE]`.
//!
//! What is proven of regions in all instances at once: `report -- proof`.
//!
//! How long a learner takes between two answers:
//! `report -- latency [--seeds N] [--first N] [--only <part of a name>]`.
//!
//! What more problem instances teach, with the same number of calls:
//! `report -- instances [--seeds N] [--first N] [--only <part of a name>]`.
//!
//! How much the numbers matter that decide what is learned:
//! `report -- sensitivity [--seeds N] [--first N] [--only <part of a name>]`.

use critreg_tests::report::{self, Run, Scenario, Statistics};
use std::process::ExitCode;
use std::str::FromStr;

const USAGE: &str = "usage: report <table|domains|an environment> [--seeds N]
       report pddl <folder>
       report proof
       report <pick|chain|angles|synthetic|noise|interval|union|state|groups> \
     [--seeds N] [--calls N] [--instances N] [--first N] [--list yes]
       report union --pieces <N or N..N> [--seeds N] [--first N]
       report why [--seeds N] [--first N] [--only <part of a cause>]
       report <queries|parallel|latency> [--seeds N] [--first N]
       report budget [--scenario <what>] [--seeds N] [--first N]
       report approximate [--seeds N] [--first N] [--wanted SHARE] [--only <part of a name>]
       report passive [--seeds N] [--first N] [--log N] [--noise SHARE]
       report <instances|latency|sensitivity> [--seeds N] [--first N] [--only <part of a name>]";

/// The words of the command line, and its options with their values.
struct Arguments {
    words: Vec<String>,
    options: Vec<(String, String)>,
}

impl Arguments {
    fn read(mut given: impl Iterator<Item = String>) -> Result<Arguments, String> {
        let (mut words, mut options) = (Vec::new(), Vec::new());
        while let Some(own) = given.next() {
            if own.starts_with("--") {
                let value = given.next().ok_or(format!("{own} needs a value"))?;
                options.push((own, value));
            } else {
                words.push(own);
            }
        }
        Ok(Arguments { words, options })
    }

    /// The next word.
    fn word(&mut self, what: &str) -> Result<String, String> {
        match self.words.is_empty() {
            true => Err(format!("{what} is missing")),
            false => Ok(self.words.remove(0)),
        }
    }

    /// The value of an option, if it is given.
    fn take<T: FromStr>(&mut self, option: &str) -> Result<Option<T>, String> {
        let place = self.options.iter().position(|(own, _)| own == option);
        let Some(place) = place else { return Ok(None) };
        let (_, value) = self.options.remove(place);
        let own = value.parse();
        own.map_or(Err(format!("{option} cannot be {value}")), |own| {
            Ok(Some(own))
        })
    }

    /// The seeds and the first of them.
    fn seeds(&mut self, default: usize) -> Result<(usize, u64), String> {
        let seeds = self.take("--seeds")?.unwrap_or(default);
        Ok((seeds, self.take("--first")?.unwrap_or(0)))
    }

    /// Nothing else is given.
    fn end(&self) -> Result<(), String> {
        let options = self.options.iter().map(|(own, _)| own);
        match self.words.iter().chain(options).next() {
            Some(own) => Err(format!("{own} is no part of this report")),
            None => Ok(()),
        }
    }
}

fn main() -> ExitCode {
    match Arguments::read(std::env::args().skip(1)).and_then(print) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}\n{USAGE}");
            ExitCode::FAILURE
        }
    }
}

/// Prints the report that is asked for.
fn print(mut given: Arguments) -> Result<(), String> {
    let name = given.word("the name of a report")?;
    match name.as_str() {
        "table" | "domains" => planning(&name, given),
        environment if report::DOMAINS.contains(&environment) => planning(&name, given),
        "proof" => {
            given.end()?;
            report::proof();
            Ok(())
        }
        "pddl" => {
            let folder = given.word("the folder")?;
            given.end()?;
            let printed = report::pddl(folder.as_ref());
            printed.map_err(|error| format!("{folder}: {error}"))
        }
        "union" => match given.take::<String>("--pieces")? {
            Some(pieces) => {
                let (seeds, first) = given.seeds(20)?;
                given.end()?;
                report::pieces(range(&pieces)?, seeds, first);
                Ok(())
            }
            None => learners(&name, given),
        },
        "approximate" | "budget" | "instances" | "latency" | "parallel" | "passive" | "queries"
        | "sensitivity" | "why" => learning(&name, given),
        _ => learners(&name, given),
    }
}

/// A number, or the numbers from one to another.
fn range(text: &str) -> Result<std::ops::RangeInclusive<usize>, String> {
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    match (first.parse(), last.parse()) {
        (Ok(first), Ok(last)) => Ok(first..=last),
        _ => Err(format!("--pieces cannot be {text}")),
    }
}

/// Reports about planning, whose tests are of so many seeds.
fn planning(name: &str, mut given: Arguments) -> Result<(), String> {
    let seeds: Option<u64> = given.take("--seeds")?;
    given.end()?;
    match name {
        "table" => report::table(seeds.unwrap_or(10)),
        "domains" => report::domains(&report::DOMAINS, seeds.unwrap_or(3)),
        name => {
            let own = report::DOMAINS.into_iter().filter(|own| *own == name);
            report::domains(&own.collect::<Vec<_>>(), seeds.unwrap_or(3));
        }
    }
    Ok(())
}

/// Reports about the default learner.
fn learning(name: &str, mut given: Arguments) -> Result<(), String> {
    let (seeds, first) = given.seeds(if name == "why" { 50 } else { 20 })?;
    let only: String = match name {
        "approximate" | "instances" | "latency" | "sensitivity" | "why" => {
            given.take("--only")?.unwrap_or_default()
        }
        _ => String::new(),
    };
    match name {
        "budget" => {
            let what: Option<String> = given.take("--scenario")?;
            given.end()?;
            let scenario = scenario(what.as_deref().unwrap_or("pick"))?;
            report::budget(&scenario, seeds, first);
        }
        "approximate" => {
            let wanted: Option<f64> = given.take("--wanted")?;
            given.end()?;
            report::approximate(seeds, first, wanted, &only);
        }
        "passive" => {
            let log = given.take("--log")?.unwrap_or(1000);
            let noise = given.take("--noise")?.unwrap_or(0.0);
            given.end()?;
            report::passive(seeds, first, log, noise);
        }
        name => {
            given.end()?;
            match name {
                "instances" => report::instances(seeds, first, &only),
                "latency" => report::latency(seeds, first, &only),
                "parallel" => report::parallel(seeds, first),
                "queries" => report::queries(seeds, first),
                "sensitivity" => report::sensitivity(seeds, first, &only),
                _ => report::why(seeds, first, &only),
            }
        }
    }
    Ok(())
}

/// A learning problem by its name.
fn scenario(name: &str) -> Result<Scenario, String> {
    Ok(match name {
        "pick" => report::pick(),
        "chain" => report::chain(),
        "angles" => report::angles(),
        "noise" => report::noise(),
        "synthetic" => report::synthetic(0),
        "interval" => report::interval(),
        "union" => report::union(),
        "state" => report::state(),
        "groups" => report::groups(),
        _ => return Err(format!("there is no report or scenario {name}")),
    })
}

/// How often each learner finds the true region.
fn learners(name: &str, mut given: Arguments) -> Result<(), String> {
    let mut scenario = scenario(name)?;
    let (seeds, first) = given.seeds(200)?;
    scenario.calls = given.take("--calls")?.unwrap_or(scenario.calls);
    scenario.instances = given.take("--instances")?.unwrap_or(scenario.instances);
    let list = given.take::<String>("--list")?.as_deref() == Some("yes");
    given.end()?;
    let all = report::for_seeds(seeds, 100, |index| {
        report::run_seed(&scenario, first + index as u64)
    });
    for (place, learner) in report::LEARNERS.into_iter().enumerate() {
        let runs: Vec<Run> = all.iter().map(|runs| runs[place].clone()).collect();
        if list {
            print_inexact(learner, &scenario, &runs, first);
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
    Ok(())
}

/// A line for each seed that is not exact.
fn print_inexact(learner: &str, scenario: &Scenario, runs: &[Run], first: u64) {
    for (index, run) in runs.iter().enumerate().filter(|(_, r)| !r.score.is_exact()) {
        let seed = first + index as u64;
        eprintln!("{learner} {seed} {run:?}");
        if scenario.name == "synthetic" {
            eprintln!("truth {seed} {:?}", report::synthetic(seed).truth);
        }
    }
}
