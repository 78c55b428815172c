//! Public planning texts: which are read, which are solved, and what plans cost, beside
//! what is recorded.

use crate::plan::symbols::Symbols;
use critreg::Error;
use critreg::pddl::{Domain, Fact, Grounding, Problem};
use critreg::plan::{
    AbstractTask, Cached, Conclusion, Config, HeuristicMemory, Memory, Planner, Progress,
    SearchMemory, SearchNode, Step, Unguided, Waiting, links,
};
use critreg::random::generator;
use critreg::task::AtomSet;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// Nodes of the search.
const NODES: usize = 1_500_000;
/// Ground operators.
const OPERATORS: usize = 65_535;
/// Atoms and numbers of `:init`.
const FACTS: usize = 8192;
/// Links between atoms and operators, which are numbered with 16 bits.
const LINKS: usize = 65_535;

/// What became of a pair of texts.
struct Outcome {
    /// How planning ended, or why there was none.
    status: String,
    read: bool,
    length: Option<usize>,
    cost: Option<u32>,
    atoms: usize,
    operators: usize,
    nodes: u32,
}

impl Outcome {
    fn refused(why: &str) -> Outcome {
        Outcome {
            status: why.to_string(),
            read: false,
            length: None,
            cost: None,
            atoms: 0,
            operators: 0,
            nodes: 0,
        }
    }
}

/// What is recorded of a pair: its obstacle, the answer, and length and cost of a plan.
struct Recorded {
    name: String,
    obstacle: String,
    answer: String,
    length: Option<usize>,
    cost: Option<u32>,
}

/// Prints a line for each pair of texts that `expected.tsv` in a folder names, and a
/// summary; says on the other channel which one it is at.
///
/// # Errors
/// If a file cannot be read.
pub fn pddl(folder: &Path) -> std::io::Result<()> {
    println!(
        "name\tobstacle\tstatus\tlength\trecorded_length\tcost\trecorded_cost\tatoms\t\
         operators\tnodes\tms"
    );
    let mut counts: BTreeMap<&str, u32> = BTreeMap::new();
    let all = recorded(folder)?;
    for recorded in &all {
        eprint!("{} ... ", recorded.name);
        let text = |part: &str| {
            let file = folder.join(format!("{}_{part}.pddl", recorded.name));
            std::fs::read(file).map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
        };
        let (domain, problem) = (text("domain")?, text("problem")?);
        let start = Instant::now();
        let outcome = solve(&domain, &problem);
        let ms = start.elapsed().as_millis();
        eprintln!("{} after {ms} ms", outcome.status);
        print(recorded, &outcome, ms);
        for what in judge(recorded, &outcome) {
            *counts.entry(what).or_default() += 1;
        }
    }
    println!("# {} pairs", all.len());
    for (what, count) in counts {
        println!("# {count} {what}");
    }
    Ok(())
}

fn recorded(folder: &Path) -> std::io::Result<Vec<Recorded>> {
    let table = std::fs::read_to_string(folder.join("expected.tsv"))?;
    let lines = table.lines().skip(1).map(|line| {
        let mut fields = line.split('\t').map(str::to_string);
        let mut next = || fields.next().unwrap_or_default();
        Recorded {
            name: next(),
            obstacle: next(),
            answer: next(),
            length: next().parse().ok(),
            cost: next().parse().ok(),
        }
    });
    Ok(lines.collect())
}

fn print(recorded: &Recorded, outcome: &Outcome, ms: u128) {
    let number = |n: Option<u64>| n.map_or("-".to_string(), |n| n.to_string());
    println!(
        "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{ms}",
        recorded.name,
        recorded.obstacle,
        outcome.status,
        number(outcome.length.map(|n| n as u64)),
        number(recorded.length.map(|n| n as u64)),
        number(outcome.cost.map(u64::from)),
        number(recorded.cost.map(u64::from)),
        outcome.atoms,
        outcome.operators,
        outcome.nodes,
    );
}

/// What the summary counts.
fn judge(recorded: &Recorded, outcome: &Outcome) -> Vec<&'static str> {
    let mut words = vec![if outcome.read { "read" } else { "refused" }];
    let solved = outcome.length.is_some();
    if solved {
        words.push("solved");
        let equal = outcome.cost == recorded.cost;
        words.push(if equal {
            "of the recorded cost"
        } else {
            "of ANOTHER COST"
        });
    }
    if recorded.answer == "unsolvable" && outcome.read {
        let right = outcome.status == "Exhausted";
        words.push(if right {
            "rightly without plan"
        } else {
            "WITHOUT PROOF that there is no plan"
        });
    }
    words
}

/// Plans with sets of atoms that are as small as can be.
fn solve(domain: &str, problem: &str) -> Outcome {
    let domain = match Domain::parse(domain) {
        Ok(domain) => domain,
        Err(error) => return Outcome::refused(&format!("domain, {error}")),
    };
    let mut facts = vec![Fact::default(); FACTS];
    let problem = match Problem::parse(&domain, problem, &mut facts) {
        Ok(problem) => problem,
        Err(error) => return Outcome::refused(&format!("problem, {error}")),
    };
    let sizes = [solve_in::<2>, solve_in::<8>, solve_in::<16>];
    let mut outcome = Err(Error::NoSample);
    for solve in sizes {
        outcome = solve(&problem);
        if !matches!(
            outcome,
            Err(Error::CapacityExceeded("ground atoms of a task"))
        ) {
            break;
        }
    }
    outcome.unwrap_or_else(|error| Outcome::refused(&error.to_string()))
}

fn solve_in<const N: usize>(problem: &Problem<'_>) -> Result<Outcome, Error> {
    let mut grounding = Grounding::<N>::new(problem)?;
    let mut operators = vec![];
    grounding.operators(&mut |operator| {
        if operators.len() == OPERATORS {
            return Err(Error::CapacityExceeded("ground operators"));
        }
        operators.push(operator);
        Ok(())
    })?;
    if links(&operators) > LINKS {
        return Err(Error::CapacityExceeded("links of the heuristic"));
    }
    let task = AbstractTask {
        operators: &operators,
        initial: grounding.initial(),
        goal: grounding.goal(),
    };
    let (mut cache, mut nodes) = (Vec::new(), Vec::new());
    cache.resize(NODES / 4, Cached::default());
    nodes.resize(NODES, SearchNode::default());
    let mut steps: Vec<Step<AtomSet<N>, N>> = vec![Step::default(); 128];
    let memory = Memory {
        search: SearchMemory {
            heuristic: HeuristicMemory {
                operators: &mut vec![Progress::default(); operators.len()],
                links: &mut vec![0; links(&operators)],
                cache: &mut cache,
            },
            nodes: &mut nodes,
            open: &mut vec![Waiting::default(); NODES],
            visited: &mut vec![0; NODES],
        },
        steps: &mut steps,
        failures: &mut [0; 64],
        reasons: &mut [],
    };
    let mut planner = Planner {
        world: &mut Symbols { parameters: 0 },
        sampler: &mut Symbols { parameters: 0 },
        guide: &mut Unguided,
        config: Config {
            max_actions: 128,
            ..Config::default()
        },
    };
    let initial = grounding.initial();
    let planned = planner.plan(task, &initial, generator(1), || generator(1), memory)?;
    let solved = planned.conclusion == Conclusion::Solved;
    let costs = planned
        .steps
        .iter()
        .map(|step| operators[usize::from(step.operator)].cost);
    Ok(Outcome {
        status: format!("{:?}", planned.conclusion),
        read: true,
        length: solved.then_some(planned.steps.len()),
        cost: solved.then(|| costs.sum()),
        atoms: grounding.atoms().as_slice().len(),
        operators: operators.len(),
        nodes: planned.metrics.nodes_created,
    })
}
