//! What is proven of regions, in all instances at once: the claims of `tests/smt`.

use critreg::domain::Domain;
use critreg::region::{ProofConfig, Region, Verdict};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// A region, one that is wrong by a little, and what both have to satisfy.
pub struct Claim {
    /// The name of its file.
    pub name: String,
    /// What its sections say, by their names.
    sections: HashMap<String, String>,
}

impl Claim {
    /// All claims, by name.
    ///
    /// # Panics
    /// If their folder cannot be read.
    pub fn all() -> Vec<Claim> {
        let files = std::fs::read_dir(root().join("tests/smt")).expect("the folder of claims");
        let mut paths: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
        paths.retain(|path| path.extension().is_some_and(|end| end == "txt"));
        paths.sort();
        paths.iter().map(|path| Claim::read(path)).collect()
    }

    fn read(path: &Path) -> Claim {
        let text = std::fs::read_to_string(path).expect("a claim");
        let mut sections: HashMap<String, String> = HashMap::new();
        let mut own = String::from("domain");
        for line in text.lines() {
            if let Some(name) = line.strip_prefix("== ") {
                own = name.to_string();
                continue;
            }
            let section = sections.entry(own.clone()).or_default();
            match line.strip_prefix("include ") {
                Some(path) => {
                    let included = std::fs::read_to_string(root().join(path));
                    section.push_str(&included.expect("what is included"));
                }
                None => section.push_str(line),
            }
            section.push('\n');
        }
        let name = path.file_stem().unwrap_or_default();
        Claim {
            name: name.to_string_lossy().into_owned(),
            sections,
        }
    }

    /// What is proven of the region that a section has, and how long it took.
    ///
    /// # Panics
    /// If a section is none that the library reads, or a counterexample is none.
    pub fn verdict(&self, section: &str) -> (Verdict, Duration) {
        let domain = Domain::parse(&self.sections["domain"]).expect(&self.name);
        let parse = |section: &str| {
            let read = Region::parse(&domain, &self.sections[section]);
            read.unwrap_or_else(|error| panic!("{} {section}: {error}", self.name))
        };
        let (region, specification) = (parse(section), parse("specification"));
        let ranges = self.ranges(&domain);
        let mut instance = vec![0.0; domain.instance_len()];
        let start = Instant::now();
        let config = ProofConfig {
            boxes: 10_000,
            ..ProofConfig::default()
        };
        let answer = region.implies(&specification, &domain, &ranges, config, &mut instance);
        let answer = answer.unwrap_or_else(|error| panic!("{}: {error}", self.name));
        let took = start.elapsed();
        if let Verdict::Refuted { theta } = answer.verdict {
            let theta = &theta[..domain.parameters().len()];
            let admits = |own: &Region| own.contains::<f64>(&domain, &instance, theta);
            assert_eq!(admits(&region), Ok(true));
            assert_eq!(admits(&specification), Ok(false));
        }
        (answer.verdict, took)
    }

    fn ranges(&self, domain: &Domain<'_>) -> Vec<[f64; 2]> {
        let known: HashMap<&str, [f64; 2]> = self.sections["ranges"]
            .lines()
            .filter_map(|line| {
                let [name, low, high] = line.split_whitespace().collect::<Vec<_>>()[..] else {
                    return None;
                };
                Some((name, [low, high].map(number)))
            })
            .collect();
        let slots = domain.slots();
        let range = |name: String| {
            *known
                .get(name.as_str())
                .unwrap_or_else(|| panic!("{}: no range of {name}", self.name))
        };
        slots
            .map(|(object, attribute)| range(format!("{}.{}", object.name, attribute.name)))
            .collect()
    }
}

/// A number, `pi`, or a number times that.
fn number(text: &str) -> f64 {
    let parts = text.split('*').map(|part| match part {
        "pi" => std::f64::consts::PI,
        "-pi" => -std::f64::consts::PI,
        _ => part.parse().expect("a number"),
    });
    parts.product()
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Prints what is proven of each claim, and of what is wrong by a little.
pub fn proof() {
    println!("| claim | region | time | wrong by 4% | time |\n|---|---|---|---|---|");
    for claim in Claim::all() {
        let cells = ["region", "wrong"].map(|section| {
            let (verdict, took) = claim.verdict(section);
            let word = match verdict {
                Verdict::Proven => "proven".to_string(),
                Verdict::Refuted { .. } => "counterexample".to_string(),
                Verdict::Undecided { open, .. } => format!("open: {:.2}%", 100.0 * open),
            };
            format!("{word} | {:.1} ms", 1e3 * took.as_secs_f64())
        });
        println!("| `{}` | {} | {} |", claim.name, cells[0], cells[1]);
    }
}
