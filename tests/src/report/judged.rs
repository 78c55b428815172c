//! How good the region of a skill is on tasks that it was not learned from.

use crate::plan::skills::TrainingRoom;
use critreg::learn::Outcome;
use critreg::random::{Generator, generator, uniform, uniform_in};
use critreg::region::Theta;
use critreg::skill::{Describe, Oracle, Skills};
use critreg::task::Task;
use std::fmt;

/// Situations to judge in, and parameters in each of them.
const SITUATIONS: usize = 40;
const DRAWS: usize = 25;

/// Counts of parameters: of those the region admits and of those that work, and of both.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Judged {
    admitted: u32,
    admitted_feasible: u32,
    feasible: u32,
    feasible_admitted: u32,
}

impl fmt::Display for Judged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let share = |a: u32, b: u32| 100.0 * f64::from(a) / f64::from(b.max(1));
        write!(
            f,
            "precision {:.1}% of {}, recall {:.1}% of {}",
            share(self.admitted_feasible, self.admitted),
            self.admitted,
            share(self.feasible_admitted, self.feasible),
            self.feasible
        )
    }
}

/// Judges the skill at an index: draws from its region, and parameters that work. Two
/// controllers are judged where the first one works.
pub(super) fn judge<E: Describe>(
    environment: &E,
    skills: &mut Skills<'_>,
    index: usize,
    tests: &[Task],
    room: &mut TrainingRoom,
) -> Judged {
    let mut judged = Judged::default();
    let Some(skill) = skills.get(index).cloned() else {
        return judged;
    };
    let (Some(region), domain) = (skill.region(), skill.domain()) else {
        return judged;
    };
    let mut trainer = room.trainer(environment, 0);
    let situations = trainer
        .situations(skills, index, tests, SITUATIONS)
        .expect("there is room");
    let parameters = domain.parameters().len();
    let mut oracle = Oracle::new(environment, skills);
    let mut rng = generator(index as u64);
    for situation in situations.iter().flatten() {
        let mut numbers = vec![0.0; skill.binding().len()];
        situation
            .instance(environment, &skill, &mut numbers)
            .expect("the situation is of the skill");
        let grounded = region.ground::<f64>(domain, &numbers).expect("a region");
        let proposal = situation.proposal(environment, &mut rng);
        let space: Vec<[f64; 2]> = domain
            .parameters()
            .iter()
            .map(|p| [p.low, p.high])
            .collect();
        for draw in 0..if parameters == 0 { 1 } else { DRAWS } {
            let mut works = |theta: &Theta| {
                let theta = (parameters > 0).then_some(&theta[..parameters]);
                let outcome = oracle.answer(situation, theta, &mut rng);
                match outcome.expect("an oracle does not fail") {
                    Outcome::Feasible => Some(true),
                    // Of a chain where already the first step fails nothing is said.
                    Outcome::FailedStep(1) if situation.steps.len() > 1 => None,
                    Outcome::FailedStep(_) => Some(false),
                    Outcome::Unknown => None,
                }
            };
            let mut chance = generator((draw as u64) << 8);
            if let Ok(theta) = grounded.sample(&mut chance)
                && let Some(works) = works(&theta)
            {
                judged.admitted += 1;
                judged.admitted_feasible += u32::from(works);
            }
            let theta = near(&proposal, &space, &mut chance);
            if works(&theta) == Some(true) {
                let inside = grounded.contains(&theta[..parameters]);
                judged.feasible += 1;
                judged.feasible_admitted += u32::from(inside.expect("parameters"));
            }
        }
    }
    judged
}

/// Parameters close to some, at any scale.
fn near(proposal: &Theta, space: &[[f64; 2]], rng: &mut Generator) -> Theta {
    let share = (-12.0 * uniform(rng)).exp2();
    let mut theta = *proposal;
    for (value, [low, high]) in theta.iter_mut().zip(space) {
        *value += (uniform_in(rng, *low, *high) - *value) * share;
    }
    theta
}
