//! One obligation: hypotheses, what has to follow from them, and a look at one box.

use super::contraction::{Empty, narrow, narrow_operands};
use super::linear::{Lines, Scratch};
use super::outward::{EVERYTHING, point, range};
use super::sensitivity::most_sensitive;
use super::sharing::{Moved, at, share};
use super::tape::{Corners, MAX_SIZES, Place, Ranges, Tape, range_of};
use crate::domain::{Domain, MAX_PARAMETERS};
use crate::error::Error;
use crate::grammar::{Formula, MAX_CONSTRAINTS};
use crate::region::lifted::Region;
use crate::region::obligations::{Members, Obligation};
use crate::region::program::{Operand, Places, Program, Value};
use heapless::Vec;

/// How often a box is narrowed before it is halved.
const NARROWINGS: usize = 3;

/// In which share of the boxes a counterexample is looked for.
const DIVE_EVERY: u32 = 8;

/// The error of a body that may have no size.
pub(super) const NO_SIZE: Error = Error::InvalidArgument(
    "a size of a body is zero or less in these ranges, where it is another body or none",
);

/// What there is in a box.
pub(super) enum Found {
    /// No counterexample.
    Nothing,
    /// One, which the proof has noted.
    Counterexample,
    /// Perhaps one; the variable to halve the box along, if it can be.
    Open(Option<usize>),
}

/// Terms that are at most zero where the constraints of a formula hold; none where a
/// constraint cannot be written as a term.
pub(super) type Margins = Vec<Option<Place>, MAX_CONSTRAINTS>;

/// A proof that a region satisfies one statement, or a search for where it does not.
pub(super) struct Proof<'p> {
    pub(super) region: &'p Region,
    pub(super) specification: &'p Region,
    pub(super) domain: &'p Domain<'p>,
    pub(super) given: &'p [[f64; 2]],
    pub(super) obligation: &'p Obligation,
    /// By how much the statement may be missed.
    pub(super) tolerance: f64,
    pub(super) tape: Tape,
    pub(super) of_region: Margins,
    pub(super) of_statement: Margins,
    /// Behind the last term of the statement.
    pub(super) statement_end: Place,
    /// A bit for each constraint of the region that is read of one member of a group.
    pub(super) in_part: u32,
    /// At most zero, for each constraint of the region that must hold or fail.
    pub(super) hypotheses: Vec<Place, MAX_CONSTRAINTS>,
    /// Zero, whatever the variables are.
    pub(super) identities: Vec<Place, MAX_SIZES>,
    /// Above the tolerance, where the statement does not hold.
    pub(super) targets: Vec<Place, MAX_CONSTRAINTS>,
    ranges: Ranges,
    examined: u32,
    scratch: Scratch,
    /// Where the counterexample is written: an instance.
    pub(super) instance: &'p mut [f64],
    pub(super) theta: [f64; MAX_PARAMETERS],
}

impl<'p> Proof<'p> {
    pub(super) fn new(
        [region, specification]: [&'p Region; 2],
        domain: &'p Domain<'p>,
        (given, tolerance): (&'p [[f64; 2]], f64),
        obligation: &'p Obligation,
        instance: &'p mut [f64],
    ) -> Self {
        Proof {
            region,
            specification,
            domain,
            given,
            obligation,
            tolerance,
            tape: Tape::default(),
            of_region: Vec::new(),
            of_statement: Vec::new(),
            statement_end: 0,
            in_part: 0,
            hypotheses: Vec::new(),
            identities: Vec::new(),
            targets: Vec::new(),
            ranges: Vec::new(),
            examined: 0,
            scratch: Scratch::new(),
            instance,
            theta: [0.0; MAX_PARAMETERS],
        }
    }

    /// Notes the terms of both formulas.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for a statement that speaks of what no proof can be made
    /// about; [`Error::CapacityExceeded`].
    #[inline(never)]
    pub(super) fn write(&mut self) -> Result<(), Error> {
        let mut theta = [Value::ZERO; MAX_PARAMETERS];
        for (index, own) in (0u8..).zip(&mut theta) {
            own.value = Operand::Theta(index);
        }
        let mut places = Places::new(self.domain, &mut self.tape, theta, false);
        let statement = &self.obligation.formula;
        write_margins(
            self.obligation,
            statement,
            &mut places,
            &mut self.of_statement,
            true,
        )?;
        self.statement_end = Place::try_from(places.code.nodes.len()).unwrap_or(Place::MAX);
        let formula = self.region.formula();
        let own = &mut self.of_region;
        self.in_part = write_margins(self.obligation, formula, &mut places, own, false)?;
        let mut must = |place: Option<Place>, holds: bool| {
            let place = place?;
            if holds {
                return Some(place);
            }
            let negative = places
                .code
                .difference(Operand::Zero, Operand::Temp(place))
                .ok()?;
            places.code.place(negative).ok()
        };
        let (of_region, hypotheses) = (&self.of_region, &mut self.hypotheses);
        formula.each_literal(true, &mut |index, holds| {
            let own = of_region.get(usize::from(index)).copied().flatten();
            if let Some(place) = must(own, holds) {
                let _ = hypotheses.push(place);
            }
        })?;
        let (of_statement, targets) = (&self.of_statement, &mut self.targets);
        statement.each_literal(false, &mut |index, holds| {
            let own = of_statement.get(usize::from(index)).copied().flatten();
            if let Some(place) = must(own, !holds) {
                let _ = targets.push(place);
            }
        })?;
        self.identities.clone_from(&self.tape.identities);
        Ok(())
    }

    /// Writes the terms anew, with the sums that they have in common, over a box.
    #[inline(never)]
    pub(super) fn share(&mut self, corners: &mut Corners) -> Result<(), Error> {
        if self.tape.evaluate(corners, &mut self.ranges).is_err() {
            return Ok(());
        }
        if !self.tape.has_sizes(&self.ranges) {
            return Err(NO_SIZE);
        }
        let mut shared = Tape::default();
        let mut moved = Moved::new();
        let margins = self.of_region.iter().chain(&self.of_statement).flatten();
        let literals = self.hypotheses.iter().chain(&self.targets);
        let is_end = |place: Place| {
            margins
                .clone()
                .chain(literals.clone())
                .any(|own| *own == place)
        };
        share(&self.tape, &self.ranges, is_end, &mut shared, &mut moved)?;
        let margins = self
            .of_region
            .iter_mut()
            .chain(&mut self.of_statement)
            .flatten();
        let literals = self.hypotheses.iter_mut().chain(&mut self.targets);
        for place in margins.chain(literals).chain(&mut self.identities) {
            *place = at(&moved, *place);
        }
        self.tape = shared;
        for _ in 0..self.tape.cuts {
            // There is room for all of them.
            let _ = corners.push(EVERYTHING);
        }
        let Ok(()) = self.tape.evaluate(corners, &mut self.ranges) else {
            return Ok(());
        };
        self.read_corners(corners);
        Ok(())
    }

    /// The terms of all constraints.
    pub(super) fn margins(&self) -> impl Iterator<Item = Place> + '_ {
        let margins = self.of_region.iter().chain(&self.of_statement);
        margins.copied().flatten()
    }

    /// The box of all that is given; `None` if what the obligation is about is not there.
    pub(super) fn corners(&self) -> Option<Corners> {
        let mut corners = Corners::new();
        for variable in &self.tape.variables {
            let own = match *variable {
                Operand::Slot(slot) => {
                    let [low, high] = self.given.get(usize::from(slot)).copied()?;
                    range(low, high)
                }
                Operand::Theta(index) => {
                    let parameter = self.domain.parameters().get(usize::from(index))?;
                    range(parameter.low, parameter.high)
                }
                Operand::Zero | Operand::One | Operand::Temp(_) => EVERYTHING,
            };
            if own.low.is_nan() {
                return None;
            }
            corners.push(own).ok()?;
        }
        Some(corners)
    }

    /// Narrows a box to where a counterexample may be, and looks for one.
    ///
    /// # Errors
    /// Those of [`Region::contains`].
    pub(super) fn examine(&mut self, corners: &mut Corners) -> Result<Found, Error> {
        for _ in 0..NARROWINGS {
            if self.narrow(corners).is_err() {
                return Ok(Found::Nothing);
            }
        }
        if self.is_settled() {
            return Ok(Found::Nothing);
        }
        let terms = self.hypotheses.iter().chain(&self.targets).copied();
        let variable = most_sensitive(&self.tape, &self.ranges, corners, terms);
        self.examined = self.examined.wrapping_add(1);
        if self.examined % DIVE_EVERY == 1 && self.dive(corners.clone())? {
            return Ok(Found::Counterexample);
        }
        Ok(Found::Open(variable))
    }

    /// Fixes one variable after the other in a box, and looks whether the sample that is
    /// left is a counterexample.
    #[inline(never)]
    fn dive(&mut self, mut corners: Corners) -> Result<bool, Error> {
        for index in 0..self.tape.variables.len() {
            let Some(corner) = corners.get_mut(index) else {
                break;
            };
            *corner = point(corner.low + 0.5 * (corner.high - corner.low));
            if self.narrow(&mut corners).is_err() {
                return Ok(false);
            }
        }
        self.is_counterexample(&corners)
    }

    /// Narrows a box by what must hold and what must not.
    fn narrow(&mut self, corners: &mut Corners) -> Result<(), Empty> {
        self.tape.evaluate(corners, &mut self.ranges)?;
        for place in &self.hypotheses {
            narrow(&mut self.ranges, *place, range(-f64::INFINITY, 0.0))?;
        }
        for place in &self.identities {
            narrow(&mut self.ranges, *place, range(-f64::INFINITY, 0.0))?;
        }
        for place in &self.targets {
            narrow(
                &mut self.ranges,
                *place,
                range(self.tolerance, f64::INFINITY),
            )?;
        }
        narrow_operands(&self.tape, &mut self.ranges)?;
        self.read_corners(corners);
        Ok(())
    }

    /// Takes over the ranges of what a box has corners of.
    fn read_corners(&self, corners: &mut Corners) {
        for (node, own) in self.tape.nodes.iter().zip(&self.ranges) {
            if let Some(index) = self.tape.corner_of(*node)
                && let Some(corner) = corners.get_mut(index)
            {
                *corner = *own;
            }
        }
    }

    /// Whether it is proven that there is no counterexample within the ranges.
    fn is_settled(&mut self) -> bool {
        let bound = self.tolerance;
        let (mut may_hold, mut may_fail) = self.masks(&self.of_region, 0.0);
        // What is said of all members may fail of another one.
        may_fail |= self.in_part;
        if !self
            .region
            .formula()
            .truth_of_masks(may_hold, may_fail)
            .may_hold
        {
            return true;
        }
        (may_hold, may_fail) = self.masks(&self.of_statement, bound);
        let statement = &self.obligation.formula;
        if !statement.truth_of_masks(may_hold, may_fail).may_fail {
            return true;
        }
        let lines = Lines {
            tape: &self.tape,
            ranges: &self.ranges,
        };
        self.targets.iter().any(|target| {
            let sum = lines.sum_of(*target, &mut self.scratch);
            sum.is_some_and(|sum| lines.follows(sum, bound, &self.hypotheses, &mut self.scratch))
        })
    }

    /// A bit for each constraint that may hold and one for each that may fail, by more than
    /// a tolerance.
    fn masks(&self, margins: &Margins, tolerance: f64) -> (u32, u32) {
        let (mut may_hold, mut may_fail) = (0, 0);
        for (index, place) in margins.iter().enumerate() {
            let own = place.map_or(EVERYTHING, |place| range_of(&self.ranges, place));
            let (holds, fails) = match tolerance > 0.0 {
                true => (own.low < -tolerance, own.high > tolerance),
                false => (own.low <= 0.0, own.high >= 0.0),
            };
            may_hold |= u32::from(holds) << index;
            may_fail |= u32::from(fails) << index;
        }
        (may_hold, may_fail)
    }

    /// Which half of a box along a variable is the better place to look for a
    /// counterexample: the one in the middle of which less is missing.
    pub(super) fn prefers_upper(&mut self, corners: &Corners, variable: usize) -> bool {
        let mut score = |share: f64| {
            let mut half = corners.clone();
            if let Some(own) = half.get_mut(variable) {
                *own = point(own.low + share * (own.high - own.low));
            }
            self.score(&half)
        };
        score(0.25) < score(0.75)
    }

    /// How far the middle of a box is from the end of what the region says and of what the statement
    /// does not say; below zero, by how much it is beyond one of them.
    fn score(&mut self, at: &Corners) -> f64 {
        self.tape.evaluate_middle(at, &mut self.ranges);
        let of = |place: &Place| range_of(&self.ranges, *place);
        let inside = self.hypotheses.iter().map(|own| -of(own).low);
        let outside = self.targets.iter().map(|own| of(own).high - self.tolerance);
        inside.chain(outside).fold(f64::INFINITY, f64::min)
    }

    /// Whether a sample is in the region and not in the specification; then it is noted.
    fn is_counterexample(&mut self, at: &Corners) -> Result<bool, Error> {
        for others in [f64::NAN, 0.5] {
            self.note(at, others);
            let domain = self.domain;
            let count = domain.parameters().len();
            let theta = self.theta.get(..count).unwrap_or_default();
            if self.region.contains::<f64>(domain, self.instance, theta)?
                && !self
                    .specification
                    .contains::<f64>(domain, self.instance, theta)?
            {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Writes down a sample. Members of groups that it is not about are at a share of their
    /// ranges; not there, if that is no number.
    fn note(&mut self, at: &Corners, others: f64) {
        for (slot, own) in (0u8..).zip(self.instance.iter_mut()) {
            let [low, high] = self
                .given
                .get(usize::from(slot))
                .copied()
                .unwrap_or_default();
            let member = self.domain.slot(slot).and_then(|(object, _)| object.member);
            let share = match member.is_none() || member == self.obligation.member {
                true => 0.5,
                false => others,
            };
            *own = low + share * (high - low);
        }
        for (own, parameter) in self.theta.iter_mut().zip(self.domain.parameters()) {
            *own = 0.5 * parameter.low + 0.5 * parameter.high;
        }
        for (variable, own) in self.tape.variables.iter().zip(at) {
            let place = match *variable {
                Operand::Slot(slot) => self.instance.get_mut(usize::from(slot)),
                Operand::Theta(index) => self.theta.get_mut(usize::from(index)),
                Operand::Zero | Operand::One | Operand::Temp(_) => None,
            };
            if let Some(place) = place {
                *place = own.low;
            }
        }
    }
}

/// Writes how far the constraints of a formula are from their bounds, and returns a bit for
/// each that is read of one member.
fn write_margins(
    obligation: &Obligation,
    formula: &Formula,
    places: &mut Places<'_, &mut Tape>,
    margins: &mut Margins,
    is_needed: bool,
) -> Result<u32, Error> {
    let mut in_part = 0;
    let nodes = formula.nodes();
    for (index, constraint) in formula.constraints().iter().enumerate() {
        places.members = obligation.reading(places.domain, nodes, constraint);
        if let Members::One(_) = places.members {
            in_part |= 1 << index;
        }
        let margin = match places.margin(nodes, constraint) {
            Ok(margin) => Some(places.code.place(margin)?),
            // What is not said of a region makes it larger, and a proof harder, not wrong.
            Err(Error::InvalidArgument(_)) if !is_needed => None,
            Err(error) => return Err(error),
        };
        // A formula has no more constraints.
        let _ = margins.push(margin);
    }
    Ok(in_part)
}
