//! Counterexamples teach: what is learned is held against what is specified.

use super::Learner;
use crate::domain::Domain;
use crate::error::Error;
use crate::region::{Implication, ProofConfig, Region};

/// Whether the region that a learner has satisfies a specification, as
/// [`Region::implies`]. If not, the counterexample is what to try next: an instance and
/// parameters in which the region and the specification disagree.
///
/// So learning goes on as counterexample-guided synthesis does (Solar-Lezama et al. 2006):
/// the instance is appended to those of the [`Problem`](super::Problem), what comes of the
/// sample is [observed](Learner::observe), and the learner is challenged again. If it works
/// there after all, the specification asks for too much.
///
/// ```
/// use critreg::domain::Domain;
/// use critreg::learn::{Capacity, Config, Learner, Outcome, Problem, Query, VersionSpace, challenge};
/// use critreg::region::{ProofConfig, Region, Verdict};
/// critreg::room!(struct Room: f64, Capacity::new(1024, 64));
///
/// let domain = Domain::parse(
///     "object wall { x: length, y: length }
///      object door { x: length }
///      constant margin = 0.25: length
///      parameter reach in [0, 4]: length
///      point hand = world + (reach, 0)",
/// )?;
/// let works = |wall: &[f64], reach: f64| reach <= wall[0] - 0.25 && reach <= wall[2];
/// // In these two, the door is never in the way.
/// let mut instances = vec![2.0, 0.0, 4.0, 3.0, 0.0, 4.0];
/// let mut room = Room::new();
/// let config = Config { calls: 40, ..Config::default() };
/// let mut learner = VersionSpace::new(&domain, config, Room::CAPACITY, room.lend())?;
/// let problem = Problem::new(&domain, &instances, 2)?;
/// while !learner.is_finished() {
///     let query = learner.ask(&problem)?;
///     let inside = works(problem.instance(query.instance)?, query.theta[0]);
///     learner.tell(&problem, Outcome::from_feasible(inside))?;
/// }
///
/// let specification = Region::parse(&domain, "hand.x <= wall.x - margin and hand.x <= door.x")?;
/// let ranges = [[1.0, 4.0], [0.0, 0.0], [0.0, 4.0]];
/// let mut instance = [0.0; 3];
/// let mut challenges = 0;
/// loop {
///     let config = ProofConfig::default();
///     let answer = challenge(&learner, &domain, &specification, &ranges, config, &mut instance)?;
///     let Verdict::Refuted { theta } = answer.verdict else {
///         assert_eq!(answer.verdict, Verdict::Proven);
///         break;
///     };
///     challenges += 1;
///     instances.extend(instance);
///     let problem = Problem::new(&domain, &instances, 2 + challenges)?;
///     let query = Query { instance: 1 + challenges, theta };
///     let outcome = Outcome::from_feasible(works(&instance, theta[0]));
///     learner.observe(&problem, &query, outcome)?;
///     learner.conclude(&problem)?;
/// }
/// assert!((1..8).contains(&challenges));
/// # Ok::<(), critreg::Error>(())
/// ```
///
/// # Errors
/// [`Error::NoRegion`] if nothing is learned; those of [`Region::implies`].
pub fn challenge(
    learner: &(impl Learner + ?Sized),
    domain: &Domain<'_>,
    specification: &Region,
    ranges: &[[f64; 2]],
    config: ProofConfig,
    instance: &mut [f64],
) -> Result<Implication, Error> {
    let region = learner.region()?;
    region.implies(specification, domain, ranges, config, instance)
}
