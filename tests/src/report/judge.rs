//! The simulator's verdict on a grid of parameters in fresh instances, and how a
//! region compares.

use super::scenario::Scenario;
use critreg::domain::Domain;
use critreg::random::{generator, uniform_in};
use critreg::region::{Region, Theta};

/// Test instances.
const TASKS: usize = 200;
/// Parameters tried in each.
const GRID: usize = 1001;

/// What works in fresh instances.
pub struct Truth {
    instances: Vec<f64>,
    grid: Vec<Theta>,
    feasible: Vec<bool>,
}

/// How well a region agrees with the truth.
#[derive(Clone, Copy, Debug, Default)]
pub struct Score {
    /// Share of the region that works.
    pub precision: f64,
    /// Share of what works that the region has.
    pub recall: f64,
}

impl Score {
    /// Whether the region counts as the true one.
    pub fn is_exact(&self) -> bool {
        self.precision >= 0.995 && self.recall >= 0.98
    }
}

impl Truth {
    /// Tries everything in the test instances of a seed.
    pub fn new(scenario: &Scenario, seed: u64) -> Truth {
        let instances = scenario.draw(seed ^ 0x7E57_0000_0000, TASKS);
        let grid = grid(&scenario.domain, seed);
        let each = instances.chunks_exact(scenario.domain.instance_len());
        let used = scenario.domain.parameters().len();
        let feasible = each
            .flat_map(|i| {
                grid.iter()
                    .map(move |t| scenario.judge(i, &t[..used]).is_feasible())
            })
            .collect();
        Truth {
            instances,
            grid,
            feasible,
        }
    }

    /// Compares a region in the first `tasks` instances.
    pub fn score(&self, domain: &Domain<'_>, region: &Region, tasks: usize) -> Score {
        let used = domain.parameters().len();
        let (mut both, mut claimed, mut true_ones) = (0usize, 0usize, 0usize);
        let each = self.instances.chunks_exact(domain.instance_len());
        let verdicts = self.feasible.chunks_exact(self.grid.len());
        for (instance, verdicts) in each.zip(verdicts).take(tasks) {
            let grounded = region.ground::<f64>(domain, instance).expect("own domain");
            for (theta, feasible) in self.grid.iter().zip(verdicts) {
                let inside = grounded.contains(&theta[..used]).expect("own grid");
                both += usize::from(inside && *feasible);
                claimed += usize::from(inside);
                true_ones += usize::from(*feasible);
            }
        }
        let share = |part: usize, whole: usize| part as f64 / whole.max(1) as f64;
        Score {
            precision: share(both, claimed),
            recall: share(both, true_ones),
        }
    }

    /// As [`Truth::score`], in all instances.
    pub fn full_score(&self, domain: &Domain<'_>, region: &Region) -> Score {
        self.score(domain, region, TASKS)
    }
}

/// One parameter: a regular grid. Several: uniform points.
fn grid(domain: &Domain<'_>, seed: u64) -> Vec<Theta> {
    let mut rng = generator(seed ^ 0x6E1D);
    let several = domain.parameters().len() > 1;
    let point = |index: usize| {
        let mut theta = Theta::default();
        for (value, p) in theta.iter_mut().zip(domain.parameters()) {
            let share = index as f64 / (GRID - 1) as f64;
            *value = p.low + (p.high - p.low) * share;
            if several {
                *value = uniform_in(&mut rng, p.low, p.high);
            }
        }
        theta
    };
    (0..GRID).map(point).collect()
}
