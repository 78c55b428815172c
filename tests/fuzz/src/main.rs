//! Random inputs for everything that the library reads, and what must hold of it: no panic,
//! no call that takes longer than a bound, and the invariants of each target.
//!
//! ```text
//! cargo run --release -p critreg-fuzz -- [--seconds 60] [--seed 1] [target...]
//! cargo run --release -p critreg-fuzz -- --input <file> <target>
//! ```
//!
//! Inputs are mutated from a corpus, and kept where they did something that none did before;
//! which a target tells by a number. It needs no instrumentation, so it runs on the stable
//! compiler. A target is a function of bytes, so that libFuzzer can call it as well.

mod mutate;
mod targets;

use critreg::random::generator;
use mutate::Mutator;
use std::collections::HashSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use std::{env, fs, process};
use targets::{TARGETS, Target};

/// Most inputs of a target that are kept.
const MOST_KEPT: usize = 4000;

/// Why a run of a target ended.
struct Finding {
    input: Vec<u8>,
    what: String,
}

/// How often a target was run, and how many inputs did something new.
struct Summary {
    executions: u64,
    kept: usize,
    slowest: Duration,
}

/// Calls a target once.
fn execute(target: &Target, input: &[u8]) -> Result<(u64, Duration), Finding> {
    let start = Instant::now();
    let ended = catch_unwind(AssertUnwindSafe(|| (target.run)(input)));
    let took = start.elapsed();
    let finding = |what: String| Finding {
        input: input.to_vec(),
        what,
    };
    match ended {
        Err(panic) => Err(finding(match panic.downcast_ref::<String>() {
            Some(words) => words.clone(),
            None => format!("{:?}", panic.downcast_ref::<&str>()),
        })),
        Ok(_) if took > target.bound => Err(finding(format!("it took {took:?}"))),
        Ok(signature) => Ok((signature, took)),
    }
}

/// Runs a target until `goes_on` says no.
fn fuzz(
    target: &Target,
    seed: u64,
    mut goes_on: impl FnMut(u64) -> bool,
) -> Result<Summary, Finding> {
    let mut mutator = Mutator::new(generator(seed));
    let mut kept = (target.corpus)();
    let mut seen = HashSet::new();
    let mut summary = Summary {
        executions: 0,
        kept: 0,
        slowest: Duration::ZERO,
    };
    for input in kept.clone() {
        seen.insert(execute(target, &input)?.0);
    }
    while goes_on(summary.executions) {
        let input = mutator.mutated(&kept);
        let (signature, took) = execute(target, &input)?;
        summary.executions += 1;
        summary.slowest = summary.slowest.max(took);
        if kept.len() < MOST_KEPT && seen.insert(signature) {
            kept.push(input);
            summary.kept += 1;
        }
    }
    Ok(summary)
}

/// Tells of a finding and keeps its input in the target directory.
fn keep(target: &Target, finding: &Finding) {
    let directory = PathBuf::from("target/fuzz");
    let file = directory.join(format!(
        "{}-{:016x}",
        target.name,
        targets::hash(&finding.input)
    ));
    let written = fs::create_dir_all(&directory).and_then(|()| fs::write(&file, &finding.input));
    eprintln!(
        "{}: {}\n  {} ({written:?})",
        target.name,
        finding.what,
        file.display()
    );
}

fn main() {
    let (mut seconds, mut seed, mut input, mut names) = (60, 1, None, Vec::new());
    let mut arguments = env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().expect("a value behind the option");
        match argument.as_str() {
            "--seconds" => seconds = value().parse().expect("seconds"),
            "--seed" => seed = value().parse().expect("a seed"),
            "--input" => input = Some(value()),
            _ => names.push(argument),
        }
    }
    let wanted = |target: &&Target| names.is_empty() || names.iter().any(|n| n == target.name);
    let mut failed = false;
    for target in TARGETS.iter().filter(wanted) {
        if let Some(file) = &input {
            let bytes = fs::read(file).expect("a file that can be read");
            (target.run)(&bytes);
            continue;
        }
        let start = Instant::now();
        match fuzz(target, seed, |_| {
            start.elapsed() < Duration::from_secs(seconds)
        }) {
            Ok(Summary {
                executions,
                kept,
                slowest,
            }) => println!(
                "{:<14} {executions:>9} executions, {kept:>5} kept, slowest {slowest:.1?}",
                target.name
            ),
            Err(finding) => {
                keep(target, &finding);
                failed = true;
            }
        }
    }
    process::exit(i32::from(failed));
}

#[cfg(test)]
mod tests {
    use super::{Finding, TARGETS, fuzz};

    /// A second of each target or so; the command runs them for longer.
    #[test]
    fn no_target_finds_anything() {
        for target in TARGETS {
            let summary = fuzz(target, 7, |executions| executions < 300);
            let Ok(summary) = summary.map_err(|Finding { input, what }| {
                panic!(
                    "{}: {what}: {:?}",
                    target.name,
                    String::from_utf8_lossy(&input)
                )
            });
            assert!(summary.kept > 0, "{} is blind", target.name);
        }
    }
}
