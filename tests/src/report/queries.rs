//! How many calls it takes until the region is exact, beside the bits that there are to find out.
//!
//! The bits are the entropy of a prior over the regions that the test can tell apart. It is
//! uniform, over the shape that the truth has: each of its comparisons may be any form, from
//! either side, whose right side is not more complex than that of the truth, and may have any
//! threshold that the form takes in the test instances. The test tells two thresholds apart if
//! the region with one of them is exact and with the other is not, so a comparison is worth
//!
//! `log2(2 * forms) + log2(range of the form / range of thresholds at which it is exact)`
//!
//! bits, the other comparisons being right. That the shape is known makes it less than it is;
//! that some forms are all but equal, and that comparisons have no order, makes it more. An
//! answer tells at most one bit, or log2(3) where it says which of two actions failed.

use super::judge::Truth;
use super::runs::{draw_theta, for_seeds, run_default, with_seed};
use super::scenario::{Scenario, chain, pick};
use super::shapes::{groups, interval, union};
use super::statistics::Run;
use super::synthetic::synthetic;
use critreg::domain::{Dependence, Dimension, Domain, Node, NodeId};
use critreg::grammar::Features;
use critreg::random::generator;
use critreg::region::Region;
use critreg::table::Blank;

/// What is true of a pick, which a simulator judges.
const PICK: &str = "grasp.y <= 2.9 and dist_y(grasp, holder.centre) >= 0.25";
/// What is true of a pick before a press.
const CHAIN: &str = "grasp.y <= 2.9 and dist_y(grasp, holder.centre) >= 0.25 \
    and dist_y(grasp, stick.tip) >= button.y - 2.9";
/// Room for the features of a domain.
const FEATURES: usize = 16_384;
/// Samples that tell what a form ranges over.
const SAMPLES: usize = 4000;
/// Halvings of an interval of thresholds.
const HALVINGS: usize = 18;
/// Test instances in which regions with other thresholds are judged.
const TASKS: usize = 50;
/// No threshold is as large as this.
const FAR: f64 = 64.0;

/// The bits of a truth.
#[derive(Clone, Copy)]
struct Bits {
    comparisons: usize,
    forms: f64,
    thresholds: f64,
}

/// Prints for some scenarios how many bits there are, and how many calls it takes.
pub fn print(seeds: usize, first: u64) {
    println!("report: queries\nseeds: {seeds}\n");
    println!(
        "| scenario | comparisons | bits of forms | of thresholds | together \
         | calls until exact, median | 95% | calls per bit |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for scenario in [pick(), chain(), synthetic(0), union(), groups(), interval()] {
        let all = for_seeds(seeds, usize::MAX, |index| {
            let seed = first + index as u64;
            with_seed(&scenario, seed, |scenario| {
                let truth = Truth::new(scenario, seed);
                (
                    bits(scenario, &truth, seed),
                    run_default(scenario, &truth, seed),
                )
            })
        });
        eprintln!("{}", scenario.name);
        print_row(scenario.name, &all);
    }
}

fn print_row(name: &str, all: &[(Bits, Run)]) {
    let mean = |of: fn(&Bits) -> f64| {
        let sum: f64 = all.iter().map(|(bits, _)| of(bits)).sum();
        sum / all.len() as f64
    };
    let comparisons = mean(|bits| bits.comparisons as f64);
    let (forms, thresholds) = (mean(|bits| bits.forms), mean(|bits| bits.thresholds));
    let mut calls: Vec<u32> = all
        .iter()
        .filter_map(|(_, run)| run.calls_to_exact)
        .collect();
    calls.sort_unstable();
    let at = |share: f64| calls.get((share * all.len() as f64) as usize);
    let shown = |calls: Option<&u32>| calls.map_or(String::from("never"), u32::to_string);
    let together = forms + thresholds;
    let each = at(0.5).map_or(String::from("-"), |calls| {
        format!("{:.2}", f64::from(*calls) / together)
    });
    println!(
        "| {name} | {comparisons:.1} | {forms:.1} | {thresholds:.1} | {together:.1} \
         | {} | {} | {each} |",
        shown(at(0.5)),
        shown(at(0.95))
    );
}

fn bits(scenario: &Scenario, truth: &Truth, seed: u64) -> Bits {
    let domain = &scenario.domain;
    let text = match scenario.name {
        "pick" => PICK,
        "chain" => CHAIN,
        _ => scenario.truth.as_deref().expect("a region judges"),
    };
    let statement = Statement::new(text);
    let parsed = |text: &str| Region::parse(domain, text).expect("a valid formula");
    let exact = |place: usize, threshold: f64| {
        let region = parsed(&statement.with(place, threshold));
        truth.score(domain, &region, TASKS).is_exact()
    };
    let samples = Samples::new(scenario, seed);
    let (mut forms, mut thresholds) = (0.0, 0.0);
    for (place, comparison) in statement.comparisons.iter().enumerate() {
        assert!(exact(place, 0.0), "the truth is exact: {text}");
        let above = halve(0.0, FAR, |threshold| exact(place, threshold));
        let below = halve(0.0, -FAR, |threshold| exact(place, threshold));
        let share = |threshold: f64| samples.share(domain, &parsed(&comparison.at(threshold)));
        let (least, most) = (share(-FAR), share(FAR));
        let low = halve(-FAR, FAR, |threshold| share(threshold) == least);
        let high = halve(FAR, -FAR, |threshold| share(threshold) == most);
        // The other end of an interval needs no name.
        let before = &statement.comparisons[..place];
        if before.iter().all(|other| other.left != comparison.left) {
            forms += (2.0 * count_forms(domain, comparison.compares) as f64).log2();
        }
        thresholds += ((high - low) / (above - below)).log2().max(0.0);
    }
    Bits {
        comparisons: statement.comparisons.len(),
        forms,
        thresholds,
    }
}

/// How far one can go from a place where something holds towards one where it does not.
fn halve(mut holds: f64, mut fails: f64, is: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (holds + fails);
        match is(middle) {
            true => holds = middle,
            false => fails = middle,
        }
    }
    holds
}

/// Forms whose right side is nothing; or, if `compares`, also one that varies with the instance.
fn count_forms(domain: &Domain<'_>, compares: bool) -> usize {
    let mut nodes = vec![Node::BLANK; FEATURES];
    let mut values = vec![0.0; FEATURES];
    let features = Features::enumerate_up_to(domain, 1, &mut nodes, &mut values);
    let features = features.expect("room for them");
    let of_dimension = |dimension: &Dimension| {
        let left = features.enumerated_lhs(1, *dimension) + features.enumerated_lhs(2, *dimension);
        let varies = |feature: &usize| {
            let id = NodeId(*feature as u16);
            domain.dependence(features.nodes(), id) == Dependence::Instance
        };
        let right = features.rhs(1, *dimension).filter(varies).count();
        left as usize * (1 + if compares { right } else { 0 })
    };
    Dimension::ALL.iter().map(of_dimension).sum()
}

/// Uniform parameters, each in a test instance of its own.
struct Samples(Vec<(Vec<f64>, Vec<f64>)>);

impl Samples {
    fn new(scenario: &Scenario, seed: u64) -> Samples {
        let mut rng = generator(seed ^ 0x5A4D);
        let used = scenario.domain.parameters().len();
        let instances = scenario.draw(seed ^ 0x7E57_0000_0000, SAMPLES);
        let each = instances.chunks_exact(scenario.domain.instance_len());
        let sample = each.map(|instance| {
            let theta = draw_theta(&scenario.domain, &mut rng);
            (instance.to_vec(), theta[..used].to_vec())
        });
        Samples(sample.collect())
    }

    /// How many of them a region admits.
    fn share(&self, domain: &Domain<'_>, region: &Region) -> usize {
        let admits = |(instance, theta): &&(Vec<f64>, Vec<f64>)| {
            let inside = region.contains::<f64>(domain, instance, theta);
            inside.expect("a valid sample")
        };
        self.0.iter().filter(admits).count()
    }
}

/// A formula, taken apart.
struct Statement {
    comparisons: Vec<Comparison>,
    /// What stands before each comparison, and behind the last.
    between: Vec<String>,
}

/// A comparison, as a difference that is compared with a threshold.
struct Comparison {
    left: String,
    difference: String,
    sign: &'static str,
    /// Whether its right side varies with the instance.
    compares: bool,
}

impl Comparison {
    fn new(text: &str) -> Comparison {
        let signs = ["<=", ">="].into_iter();
        let mut cut = signs.filter_map(|sign| Some((sign, text.split_once(sign)?)));
        let (sign, (left, right)) = cut.next().expect("a comparison");
        let words = right.split(|c: char| !c.is_alphanumeric() && c != '.');
        let mut places = words.filter(|word| word.ends_with(".x") || word.ends_with(".y"));
        Comparison {
            left: left.trim().into(),
            difference: format!("{} - ({})", left.trim(), right.trim()),
            sign,
            compares: left.contains(" - ") || places.next().is_some(),
        }
    }

    /// It with another threshold than zero.
    fn at(&self, threshold: f64) -> String {
        // The more is admitted the larger the threshold is.
        let own = if self.sign == "<=" {
            threshold
        } else {
            -threshold
        };
        format!("{} {} {own:.9}", self.difference, self.sign)
    }
}

impl Statement {
    fn new(text: &str) -> Statement {
        let (mut comparisons, mut between) = (Vec::new(), vec![String::new()]);
        let mut add = |own: &str, word: &str| {
            let (before, comparison, behind) = bare(own);
            between.last_mut().expect("one").push_str(before);
            comparisons.push(Comparison::new(comparison));
            between.push(format!("{behind}{word}"));
        };
        let mut rest = text;
        loop {
            let cuts = [" and ", " or "].into_iter();
            let cuts = cuts.filter_map(|word| Some((rest.find(word)?, word)));
            let Some((place, word)) = cuts.min() else {
                break;
            };
            add(&rest[..place], word);
            rest = &rest[place + word.len()..];
        }
        add(rest, "");
        Statement {
            comparisons,
            between,
        }
    }

    /// It with another threshold of one comparison.
    fn with(&self, place: usize, threshold: f64) -> String {
        let mut text = String::new();
        for (index, (before, own)) in self.between.iter().zip(&self.comparisons).enumerate() {
            text += before;
            text += &own.at(if index == place { threshold } else { 0.0 });
        }
        text + self.between.last().map_or("", String::as_str)
    }
}

/// A comparison without the brackets around several, and what is left of those.
fn bare(text: &str) -> (&str, &str, &str) {
    let count = |text: &str, own: char| text.matches(own).count();
    let more = count(text, '(') > count(text, ')');
    let fewer = count(text, '(') < count(text, ')');
    match (more, fewer) {
        (true, _) => (&text[..1], &text[1..], ""),
        (_, true) => ("", &text[..text.len() - 1], &text[text.len() - 1..]),
        _ => ("", text, ""),
    }
}
