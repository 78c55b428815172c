//! The joint region of later steps: what is good for a step and for those after it.

use crate::error::Error;
use crate::region::{Intersection, Part, Region, Theta};
use crate::skill::skills::Skill;
use crate::table::gather;
use crate::task::MAX_STATE_VALUES;
use heapless::Vec;
use rand_core::Rng;

/// Regions that are intersected at most: later steps beyond do not narrow a draw.
const MAX_REGIONS: usize = 16;
/// Numbers that their instances have at most, together.
const MAX_NUMBERS: usize = 4 * MAX_STATE_VALUES;

/// The regions of a step, and those on its parameters of the steps that come later, each
/// with the instance that it is grounded in (sequential feasibility, thesis 7.2): what
/// they have in common is good for all of these steps.
#[derive(Default)]
pub(super) struct JointRegion<'s> {
    /// The instances, one behind the other.
    numbers: Vec<f64, MAX_NUMBERS>,
    regions: Vec<StepRegion<'s>, MAX_REGIONS>,
}

/// One of the regions.
pub(super) struct StepRegion<'s> {
    /// The skill that it is of.
    pub(super) skill: &'s Skill,
    /// Where the numbers of its instance end.
    end: usize,
    /// The later step that it makes possible; zero if it is of the first step alone.
    pub(super) step: usize,
}

impl<'s> JointRegion<'s> {
    /// Adds a region in the instance that `fill` makes, unless it is there.
    pub(super) fn add(
        &mut self,
        skill: &'s Skill,
        step: usize,
        fill: impl FnOnce(&mut [f64]) -> Result<(), Error>,
    ) {
        let start = self.numbers.len();
        let end = start + skill.binding().len();
        let kept = self.numbers.resize_default(end).is_ok()
            && self
                .numbers
                .get_mut(start..)
                .is_some_and(|own| fill(own).is_ok())
            && !self.has(skill, start)
            && self.regions.push(StepRegion { skill, end, step }).is_ok();
        if !kept {
            self.numbers.truncate(start);
        }
    }

    /// Whether a region is there in the instance of the last numbers.
    fn has(&self, skill: &Skill, start: usize) -> bool {
        let new = self.numbers.get(start..).unwrap_or_default();
        self.parts().zip(&self.regions).any(|(part, other)| {
            let mut pairs = part.instance.iter().zip(new);
            core::ptr::eq(other.skill, skill) && pairs.all(|(a, b)| a.to_bits() == b.to_bits())
        })
    }

    /// The regions.
    pub(super) fn regions(&self) -> &[StepRegion<'s>] {
        &self.regions
    }

    /// The regions with their instances.
    pub(super) fn parts(&self) -> impl Iterator<Item = Part<'_>> + Clone {
        let starts = core::iter::once(0).chain(self.regions.iter().map(|region| region.end));
        let regions = self.regions.iter().zip(starts);
        regions.filter_map(|(StepRegion { skill, end, .. }, start)| {
            Some(Part {
                region: skill.region()?,
                domain: skill.domain(),
                instance: self.numbers.get(start..*end)?,
            })
        })
    }

    /// How many parameters the regions are about.
    pub(super) fn parameters(&self) -> usize {
        let skills = self.regions.iter().map(|region| region.skill);
        let counts = skills.map(|skill| skill.domain().parameters().len());
        counts.max().unwrap_or(0)
    }

    /// Whether it is proven that the regions have nothing in common.
    pub(super) fn is_proven_empty(&self) -> Result<bool, Error> {
        are_apart(self.parts())
    }

    /// The first step with which it is proven that the regions have nothing in common;
    /// the last one if that is not proven.
    pub(super) fn blocking_step(&self) -> Result<usize, Error> {
        let mut step = 0;
        for (count, region) in (1..).zip(&self.regions) {
            step = region.step;
            if are_apart(self.parts().take(count))? {
                break;
            }
        }
        Ok(step)
    }

    /// How far the state is within the regions that speak of it alone, at the nearest bound;
    /// infinitely, if there are none.
    pub(super) fn robustness(&self) -> Result<f64, Error> {
        let (states, _) = split(self.parts());
        let mut least = f64::INFINITY;
        for own in &states {
            let robustness = own.region.robustness(own.domain, own.instance, &[])?;
            least = least.min(robustness);
        }
        Ok(least)
    }

    /// Draws parameters that all regions admit; see [`Intersection::sample_inside`].
    pub(super) fn sample<R: Rng>(&self, margin: f64, rng: &mut R) -> Result<Theta, Error> {
        let (states, parts) = split(self.parts());
        if any_is_empty(&states)? {
            return Err(Error::EmptyRegion);
        }
        if parts.is_empty() {
            return Ok(Theta::default());
        }
        Intersection::<f64>::new(&parts)?.sample_inside(margin, rng)
    }

    /// Whether the regions have something in common without a conjunct of one of them,
    /// by its place.
    pub(super) fn meet_without(&self, place: usize, conjunct: usize) -> Result<bool, Error> {
        let Some((domain, region)) = self.parts().nth(place).map(|p| (p.domain, p.region)) else {
            return Ok(false);
        };
        let formula = region.formula().select(|own| own.index != conjunct)?;
        let weaker = Region::new(domain, formula);
        let parts = self.parts().enumerate().map(|(index, part)| Part {
            region: if index == place { &weaker } else { part.region },
            ..part
        });
        Ok(!are_apart(parts)?)
    }
}

type Parts<'p> = Vec<Part<'p>, MAX_REGIONS>;

/// Regions of states, which hold or do not, and those of parameters.
fn split<'p>(parts: impl Iterator<Item = Part<'p>> + Clone) -> (Parts<'p>, Parts<'p>) {
    let is_state = |part: &Part<'_>| part.domain.parameters().is_empty();
    let states = parts.clone().filter(is_state);
    let others = parts.filter(|part| !is_state(part));
    (gather(states), gather(others))
}

fn any_is_empty(states: &[Part<'_>]) -> Result<bool, Error> {
    for state in states {
        let alone = core::slice::from_ref(state);
        if Intersection::<f64>::new(alone)?.is_proven_empty()? {
            return Ok(true);
        }
    }
    Ok(false)
}

fn are_apart<'p>(parts: impl Iterator<Item = Part<'p>> + Clone) -> Result<bool, Error> {
    let (states, parts) = split(parts);
    if any_is_empty(&states)? {
        return Ok(true);
    }
    if parts.is_empty() {
        return Ok(false);
    }
    Intersection::<f64>::new(&parts)?.is_proven_empty()
}
