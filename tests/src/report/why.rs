//! Whether a learner says why there is no exact region: each cause is provoked, in several
//! domains, and its code expected on every seed.
//!
//! What of the grammar finds no room is no code, but is said beside it. How many instances have
//! no sample that works is not counted by the library, so there is nothing to provoke.

use super::runs::{Answers, draw_theta, for_seeds};
use super::scenario::Scenario;
use crate::room::VersionSpaceRoom;
use crate::text;
use critreg::domain::Domain;
use critreg::learn::version_space::{Config, Quality, Why};
use critreg::learn::{Learner, Outcome, Problem, Query, VersionSpace};
use critreg::random::{Generator, below, generator, uniform_in};
use critreg::region::Region;
use std::collections::BTreeMap;

const INSTANCES: usize = 16;
const CALLS: u32 = 100;

/// A hand in front of a wall.
const WALL: &str = "
    object wall { x: length, y: length }
    constant margin = 0.25: length
    parameter reach in [0, 4]: length
    point hand = world + (reach, 0)
";
/// A hand over a table with two things.
const TABLE: &str = "
    object cup { x: length, y: length }
    object lamp { x: length, y: length }
    constant margin = 0.25: length
    constant reach = 1.5: length
    parameter px in [0, 4]: length
    parameter py in [0, 4]: length
    point hand = world + (px, py)
";
/// A hand that takes a bar anywhere along it, beside up to two cans.
const BAR: &str = "
    object bar { x: length, y: length, theta: angle, length: length, width: length }
    object can[2] { x: length, y: length, radius: length }
    constant finger.width = 0.02: length
    parameter s in [-0.2, 0.2]: length
    point grip = bar + (s, 0)
    shape bar = rectangle(bar.length, bar.width) centred
    shape can = circle(can.radius)
    shape grip = circle(finger.width)
";
/// An item that is put on a board, at any heading.
const BOARD: &str = "
    object board { x: length, y: length, theta: angle, width: length, depth: length }
    object item { width: length, depth: length }
    parameter px in [-0.4, 0.4]: length
    parameter py in [-0.4, 0.4]: length
    parameter yaw in [-pi, pi]: angle
    point spot = world + (px, py)
    point place = spot turned yaw
    shape board = rectangle(board.width, board.depth) centred
    shape place = rectangle(item.width, item.depth) centred
";

/// Domains, each with what is true in it and a number of an instance that decides alone where
/// parameters do not matter.
const DOMAINS: [Setting; 4] = [
    Setting {
        name: "wall",
        text: WALL,
        truth: "reach - wall.x <= -0.25",
        decides: (0, 2.25),
        draw: |rng| vec![uniform_in(rng, 1.0, 3.5), uniform_in(rng, -1.0, 1.0)],
    },
    Setting {
        name: "table",
        text: TABLE,
        truth: "dist(hand, lamp) <= 1.5 and px - cup.x <= 0.25",
        decides: (2, 2.0),
        draw: |rng| (0..4).map(|_| uniform_in(rng, 0.5, 3.5)).collect(),
    },
    Setting {
        name: "bar",
        text: BAR,
        truth: "inside(grip, bar) >= 0 and min(clear(grip, can)) >= 0",
        decides: (3, 0.3),
        draw: |rng| {
            let mut own = vec![0.0, 0.0, uniform_in(rng, -3.1, 3.1)];
            own.extend([uniform_in(rng, 0.2, 0.4), uniform_in(rng, 0.05, 0.08)]);
            for _ in 0..2 {
                own.extend([uniform_in(rng, -0.2, 0.2), uniform_in(rng, -0.2, 0.2)]);
                own.push(uniform_in(rng, 0.02, 0.05));
            }
            own
        },
    },
    Setting {
        name: "board",
        text: BOARD,
        truth: "inside(place, board) >= 0",
        decides: (3, 0.6),
        draw: |rng| {
            let mut own = vec![uniform_in(rng, -0.1, 0.1), uniform_in(rng, -0.1, 0.1)];
            own.extend([uniform_in(rng, -3.1, 3.1), uniform_in(rng, 0.5, 0.7)]);
            own.extend([uniform_in(rng, 0.4, 0.6), uniform_in(rng, 0.1, 0.2)]);
            own.push(uniform_in(rng, 0.05, 0.15));
            own
        },
    },
];

struct Setting {
    name: &'static str,
    text: &'static str,
    truth: &'static str,
    decides: (usize, f64),
    draw: fn(&mut Generator) -> Vec<f64>,
}

/// What decides whether a sample works.
#[derive(Clone, Copy)]
enum Works {
    Never,
    Always,
    /// A number of the instance, whatever the parameters are.
    InSome,
    /// What the text can say.
    Sayable,
    /// Squares of a board that is shifted with the instance.
    Squares,
    /// The digits of the sample: always the same there, and without a reason.
    Chance,
    /// What the text can say, but for one of eight places, by its digits.
    Holes,
}

/// How much is told.
#[derive(Clone, Copy)]
enum Telling {
    /// Nothing; but a question was asked.
    Nothing,
    /// Answers until one instance has both kinds.
    Few,
    /// All answers that are asked for.
    All,
    /// Uniform samples, each twice, without a question.
    Twice,
}

/// A way to provoke a cause.
struct Cause {
    name: &'static str,
    works: Works,
    telling: Telling,
    /// Share of the answers that is flipped, and the share that the learner is told of.
    flipped: (f64, f64),
    /// How many answers may be asked for.
    calls: u32,
    /// Room for forms.
    forms: usize,
    right: fn(&Seen) -> bool,
}

const AS_SAID: Cause = Cause {
    name: "",
    works: Works::Sayable,
    telling: Telling::All,
    flipped: (0.0, 0.0),
    calls: CALLS,
    forms: 12_000,
    right: |_| false,
};

const CAUSES: [Cause; 13] = [
    Cause {
        name: "nothing told",
        telling: Telling::Nothing,
        right: |seen| seen.why == Why::NothingTold,
        ..AS_SAID
    },
    Cause {
        name: "none worked",
        works: Works::Never,
        right: |seen| seen.why == Why::NoneWorked && seen.region.is_none(),
        ..AS_SAID
    },
    Cause {
        name: "all worked",
        works: Works::Always,
        right: |seen| {
            let everything = seen.region.as_deref() == Some("true");
            seen.why == Why::AllWorked && seen.quality == Quality::Exact && everything
        },
        ..AS_SAID
    },
    Cause {
        name: "no influence",
        works: Works::InSome,
        right: |seen| seen.why == Why::NoInfluence,
        ..AS_SAID
    },
    Cause {
        name: "too few answers",
        telling: Telling::Few,
        right: |seen| matches!(seen.why, Why::TooFew { more: 1.. }),
        ..AS_SAID
    },
    Cause {
        name: "too few calls",
        calls: 10,
        right: |seen| match seen.mixed {
            true => matches!(seen.why, Why::TooFew { more: 1.. }),
            false => matches!(
                seen.why,
                Why::NoneWorked | Why::AllWorked | Why::NoInfluence
            ),
        },
        ..AS_SAID
    },
    Cause {
        name: "contradictions that are told",
        telling: Telling::Twice,
        flipped: (0.1, 0.0),
        right: |seen| matches!(seen.why, Why::Contradiction { .. }),
        ..AS_SAID
    },
    Cause {
        name: "contradictions where noise is declared",
        flipped: (0.3, 0.02),
        right: |seen| matches!(seen.why, Why::Contradiction { .. }),
        ..AS_SAID
    },
    Cause {
        name: "unexplained squares",
        works: Works::Squares,
        right: |seen| matches!(seen.why, Why::Unexplained { .. }),
        ..AS_SAID
    },
    Cause {
        name: "unexplained chance",
        works: Works::Chance,
        right: |seen| matches!(seen.why, Why::Unexplained { .. }),
        ..AS_SAID
    },
    Cause {
        name: "unexplained holes",
        works: Works::Holes,
        right: |seen| matches!(seen.why, Why::Unexplained { .. }),
        ..AS_SAID
    },
    Cause {
        name: "no room for relations",
        forms: 4,
        right: |seen| seen.left_out.is_some(),
        ..AS_SAID
    },
    Cause {
        name: "none of these",
        right: |seen| seen.why == Why::Explained && seen.left_out.is_none(),
        ..AS_SAID
    },
];

/// What a learner says in the end.
struct Seen {
    why: Why,
    quality: Quality,
    region: Option<String>,
    /// Whether samples worked and others failed in one instance.
    mixed: bool,
    /// How many relations found no room, and the first of them.
    left_out: Option<String>,
}

/// Prints for each cause and domain how many seeds get the right code, which other ones there
/// are, and what is said to the first seed.
pub fn print(seeds: usize, first: u64, only: &str) {
    println!("report: why\nseeds: {seeds}\n");
    println!("| cause | domain | right | other codes | what the first seed is told |");
    println!("|---|---|---|---|---|");
    for cause in CAUSES.iter().filter(|own| own.name.contains(only)) {
        for setting in &DOMAINS {
            let scenario = setting.scenario(cause);
            let seen = for_seeds(seeds, usize::MAX, |index| {
                cause.seen(&scenario, first + index as u64)
            });
            eprintln!("{}, {}", cause.name, setting.name);
            print_row(cause, setting, &seen);
        }
    }
}

fn print_row(cause: &Cause, setting: &Setting, seen: &[Seen]) {
    let mut others: BTreeMap<String, usize> = BTreeMap::new();
    for own in seen.iter().filter(|own| !(cause.right)(own)) {
        let code = format!("{:?}", own.why);
        let code = code.split(' ').next().unwrap_or_default();
        *others
            .entry(format!("{code} {:?}", own.quality))
            .or_default() += 1;
    }
    let right = seen.iter().filter(|own| (cause.right)(own)).count();
    let others: Vec<String> = others
        .iter()
        .map(|(code, n)| format!("{n} {code}"))
        .collect();
    let said = seen
        .first()
        .map_or(String::new(), |own| match &own.left_out {
            Some(left_out) => format!("{}; {left_out}", own.why),
            None => own.why.to_string(),
        });
    let (cause, domain, others) = (cause.name, setting.name, others.join(", "));
    println!(
        "| {cause} | {domain} | {right}/{} | {others} | {said} |",
        seen.len()
    );
}

impl Setting {
    /// A learning problem in this domain.
    fn scenario(&self, cause: &Cause) -> Scenario {
        let domain = Domain::parse(self.text).expect("the text is valid");
        let region = Region::parse(&domain, self.truth).expect("a valid formula");
        let ranges: Vec<[f64; 2]> = domain
            .parameters()
            .iter()
            .map(|p| [p.low, p.high])
            .collect();
        let (works, (number, least)) = (cause.works, self.decides);
        let says = move |instance: &[f64], theta: &[f64]| {
            let inside = region.contains::<f64>(&domain, instance, theta);
            inside.expect("a valid sample")
        };
        let size = (INSTANCES, cause.calls);
        let scenario = Scenario::of_judge(
            self.name,
            self.text,
            size,
            self.draw,
            move |i, theta| match works {
                Works::Never => false,
                Works::Always => true,
                Works::InSome => i[number] >= least,
                Works::Sayable => says(i, theta),
                Works::Squares => in_square(i, theta, &ranges),
                Works::Chance => chance(theta, 2) == 0,
                Works::Holes => says(i, theta) && chance(theta, 8) != 0,
            },
        );
        Scenario {
            noise: cause.flipped.0,
            ..scenario
        }
    }
}

/// A number below some other one, always the same at a sample.
fn chance(theta: &[f64], below_this: usize) -> usize {
    below(&mut generator(theta[0].to_bits()), below_this)
}

/// Whether a sample is in a white square, of about five along each parameter.
fn in_square(instance: &[f64], theta: &[f64], ranges: &[[f64; 2]]) -> bool {
    let along = theta.iter().zip(ranges);
    let along = along.map(|(value, [low, high])| 5.0 * (value - low) / (high - low));
    let shift = 37.0 * instance.iter().sum::<f64>();
    let squares: f64 = along.map(|own| (own + shift).floor()).sum();
    squares.rem_euclid(2.0) < 1.0
}

impl Cause {
    /// What a learner with this seed says.
    fn seen(&self, scenario: &Scenario, seed: u64) -> Seen {
        let domain = &scenario.domain;
        let instances = scenario.draw(seed, INSTANCES);
        let problem = Problem::new(domain, &instances, INSTANCES).expect("valid instances");
        let mut capacity = scenario.capacity();
        capacity.forms = self.forms;
        let mut room = VersionSpaceRoom::<f64>::new(capacity);
        let config = Config {
            noise: self.flipped.1,
            ..scenario.config(seed)
        };
        let mut learner = room.learner(domain, config).expect("enough room");
        let known = self.tell(&mut learner, scenario, &problem, seed);
        let left_out = learner.left_out(domain);
        Seen {
            why: learner.why(),
            quality: learner.quality(),
            region: learner
                .region()
                .ok()
                .map(|own| text::of_region(domain, own)),
            mixed: known.contains(&[true; 2]),
            left_out: left_out.map(|own| format!("{} relations found no room", own.count)),
        }
    }

    /// Tells the learner what it is to be told. Returns for each instance whether something
    /// that was asked failed there, and whether something worked.
    fn tell(
        &self,
        learner: &mut VersionSpace<'_, f64>,
        scenario: &Scenario,
        problem: &Problem<'_>,
        seed: u64,
    ) -> [[bool; 2]; INSTANCES] {
        let mut answers = Answers::new(scenario, seed);
        let mut rng = generator(seed ^ 0x7E11);
        let mut known = [[false; 2]; INSTANCES];
        match self.telling {
            Telling::Nothing => {
                learner.ask(problem).expect("a question");
            }
            Telling::Few | Telling::All => {
                while !learner.is_finished() {
                    let query = learner.ask(problem).expect("a question");
                    let outcome = answers.to(problem, &query);
                    learner.tell(problem, outcome).expect("room");
                    let known = &mut known[query.instance];
                    known[usize::from(outcome.is_feasible())] = true;
                    if matches!(self.telling, Telling::Few) && *known == [true; 2] {
                        break;
                    }
                }
            }
            Telling::Twice => {
                for _ in 0..CALLS / 2 {
                    let query = Query {
                        instance: below(&mut rng, INSTANCES),
                        theta: draw_theta(problem.domain(), &mut rng),
                    };
                    for _ in 0..2 {
                        let outcome: Outcome = answers.to(problem, &query);
                        learner.observe(problem, &query, outcome).expect("room");
                    }
                }
                learner.conclude(problem).expect("it began");
            }
        }
        known
    }
}
