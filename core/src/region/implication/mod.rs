//! Whether a region satisfies a specification, in all instances at once.
//!
//! A specification is a region, too: what must hold of whatever the region admits, as "the
//! hand stays in its zone and clear of every obstacle". The answer is a proof in real
//! arithmetic, a counterexample, or how much is open.
//!
//! | file | content |
//! |---|---|
//! | `mod.rs` | the question, and one obligation after the other |
//! | `search.rs` | branch and bound over boxes of instances and parameters |
//! | `proof.rs` | hypotheses and what has to follow, and a look at one box |
//! | `tape.rs` | both formulas as a list of terms, with ranges |
//! | `outward.rs` | ranges that are rounded outward |
//! | `contraction.rs` | narrowing a box by the hypotheses |
//! | `linear.rs` | what follows line by line, whatever the terms are |
//! | `smt2.rs` | the same questions for other provers |
//! | `sharing.rs` | sums that constraints have in common, to halve boxes along |
//! | `sensitivity.rs` | along which variable a box is halved |

mod contraction;
mod linear;
mod outward;
mod proof;
mod search;
mod sensitivity;
mod sharing;
mod smt2;
mod tape;

pub use search::Limit;

use super::lifted::Region;
use super::obligations::Obligation;
use super::parameters::Theta;
use crate::domain::Domain;
use crate::error::Error;
use proof::Proof;

/// How much a proof may cost, and how exact it has to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProofConfig {
    /// How many boxes are examined at most, for each obligation. 10 000 take between 0.1 s
    /// and 1 s.
    pub boxes: u32,
    /// By how much a constraint of the specification may be missed, in its own unit. It has
    /// to be above what constants are rounded by (0.1 + 0.2 is not 0.3), and the larger it is
    /// the sooner is decided what only just holds.
    pub tolerance: f64,
}

impl Default for ProofConfig {
    fn default() -> Self {
        ProofConfig {
            boxes: 20_000,
            tolerance: 1e-6,
        }
    }
}

/// Whether a region implies a specification.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// It does, for all instances in the ranges and all parameters.
    Proven,
    /// It does not: in the instance that was written, these parameters are in the region
    /// and not in the specification.
    Refuted {
        /// The parameters.
        theta: Theta,
    },
    /// Neither was found.
    Undecided {
        /// The share of the volume that is open, of the obligation that has most: of all
        /// instances in the ranges and all parameters.
        open: f64,
        /// What was in the way.
        limit: Limit,
    },
}

/// The answer of [`Region::implies`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Implication {
    /// Proven, refuted or undecided.
    pub verdict: Verdict,
    /// If it is not proven: the place of the statement that is not, among those that the
    /// specification joins by `and`.
    pub statement: usize,
    /// How many boxes were examined, of all obligations together.
    pub boxes: u32,
}

impl Region {
    /// Whether all that this region admits satisfies a specification, which is a region of
    /// the same domain: in every instance whose numbers are in `ranges`, a lower and an
    /// upper end for each.
    ///
    /// Each statement of the specification is proven by itself; one about all members of a
    /// group is proven for each. Members may be there or not; one whose ends are NaN never
    /// is. A counterexample is written to `instance`, with only those members that it is
    /// about where that is one.
    ///
    /// ```
    /// use critreg::{domain::Domain, region::{Limit, ProofConfig, Region, Verdict}};
    /// let domain = Domain::parse(
    ///     "object wall { x: length, y: length }
    ///      constant radius = 0.1: length
    ///      parameter reach in [0, 4]: length
    ///      point hand = world + (reach, 0)",
    /// )?;
    /// let region = Region::parse(&domain, "dist(hand, wall) >= 0.3 and reach <= wall.x")?;
    /// let clear = Region::parse(&domain, "hand.x + radius <= wall.x")?;
    /// let ranges = [[0.0, 4.0], [-0.2, 0.2]];
    /// let mut instance = [0.0; 2];
    /// let config = ProofConfig::default();
    /// let answer = region.implies(&clear, &domain, &ranges, config, &mut instance)?;
    /// assert_eq!(answer.verdict, Verdict::Proven);
    /// // With walls that are farther off the line, the hand is clear of them anywhere.
    /// let wide = [[0.0, 4.0], [-0.5, 0.5]];
    /// let answer = region.implies(&clear, &domain, &wide, config, &mut instance)?;
    /// let Verdict::Refuted { theta: [reach, ..] } = answer.verdict else { panic!() };
    /// assert!(region.contains::<f64>(&domain, &instance, &[reach])?);
    /// assert!(reach + 0.1 > instance[0]);
    /// # Ok::<(), critreg::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Mismatch`] for regions of another domain; [`Error::InvalidArgument`] for
    /// another number of ranges, one that is none, and for a specification about what
    /// cannot be proven; [`Error::CapacityExceeded`] for more terms than there is room for.
    pub fn implies(
        &self,
        specification: &Region,
        domain: &Domain<'_>,
        ranges: &[[f64; 2]],
        config: ProofConfig,
        instance: &mut [f64],
    ) -> Result<Implication, Error> {
        check([self, specification], domain, ranges, config)?;
        if instance.len() != domain.instance_len() {
            return Err(Error::InvalidArgument(
                "a counterexample needs room for one number per attribute of every object",
            ));
        }
        let mut answer = Implication {
            verdict: Verdict::Proven,
            statement: 0,
            boxes: 0,
        };
        let mut number = 0;
        while let Some(obligation) = Obligation::find(specification.formula(), domain, number)? {
            number += 1;
            let regions = [self, specification];
            let mut proof = Proof::new(
                regions,
                domain,
                (ranges, config.tolerance),
                &obligation,
                instance,
            );
            proof.write()?;
            let Some(mut corners) = proof.corners() else {
                continue;
            };
            proof.share(&mut corners)?;
            let outcome = search::search(&mut proof, &corners, config.boxes)?;
            answer.boxes = answer.boxes.saturating_add(outcome.boxes);
            if outcome.is_refuted {
                answer.statement = obligation.clause;
                answer.verdict = Verdict::Refuted { theta: proof.theta };
                return Ok(answer);
            }
            if let Some(limit) = outcome.limit {
                let open = outcome.open;
                let before = match answer.verdict {
                    Verdict::Undecided { open, .. } => open,
                    Verdict::Proven | Verdict::Refuted { .. } => 0.0,
                };
                if open >= before {
                    answer.statement = obligation.clause;
                    answer.verdict = Verdict::Undecided { open, limit };
                }
            }
        }
        Ok(answer)
    }
}

/// Checks what a proof is asked for.
fn check(
    regions: [&Region; 2],
    domain: &Domain<'_>,
    ranges: &[[f64; 2]],
    config: ProofConfig,
) -> Result<(), Error> {
    for region in regions {
        region.check_domain(domain)?;
    }
    if !(config.tolerance > 0.0 && config.tolerance.is_finite()) {
        return Err(Error::InvalidArgument(
            "the tolerance of a proof is above zero",
        ));
    }
    check_ranges(domain, ranges)
}

/// Checks that there is a range for each number of an instance, and none for those of a
/// member that is never there.
fn check_ranges(domain: &Domain<'_>, ranges: &[[f64; 2]]) -> Result<(), Error> {
    if ranges.len() != domain.instance_len() {
        return Err(Error::InvalidArgument(
            "a proof needs a lower and an upper end for each number of an instance",
        ));
    }
    for (slot, [low, high]) in (0u8..).zip(ranges) {
        let member = domain.slot(slot).and_then(|(object, _)| object.member);
        if member.is_some() && low.is_nan() && high.is_nan() {
            continue;
        }
        if !(low.is_finite() && high.is_finite()) {
            return Err(Error::NotFinite("an end of a range of an instance"));
        }
        if low > high {
            return Err(Error::InvalidArgument(
                "a range of an instance ends before it begins",
            ));
        }
    }
    Ok(())
}
