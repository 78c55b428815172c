//! Forms and their version spaces.
//!
//! A form is the difference `lhs - rhs` of a feature that depends on the sample and one
//! that depends on the instance only, or nothing. Its version space is an interval: S, all
//! values at feasible samples. An infeasible sample is a bit per form and direction:
//! whether its value lies outside of S, on that side. Of the first forms both are kept up
//! to date, of the others computed when needed, to save memory.
//!
//! Right sides are evaluated once per instance, left sides once per sample; what
//! is done per form is one subtraction and two comparisons, in long runs over
//! neighbouring right sides.

mod columns;
mod compare;
mod exclusions;
mod interval;
mod layout;
mod left;
mod length;
mod offers;
mod right;
mod sample;
mod sample_set;
mod scan;
mod search;
mod step;
mod sums;
mod update;
mod values;

pub(super) use columns::Effort;
pub use interval::Interval;
pub(super) use layout::DirectedForm;
pub use left::{Left, LeftOut};
pub(super) use sample::Origin;
pub use sample::Sample;
pub(super) use sample_set::{MAX_WORDS, SampleSet};
pub use search::{End, Failure};
pub(super) use step::StepView;
pub(super) use sums::SUM_LEVEL;
pub use sums::Sum;

use super::memory::{Capacity, Memory};
use super::tuning::Tuning;
use crate::domain::{Dimension, Domain, NodeId, PointSet, Sample as Point, Scene, held};
use crate::error::Error;
use crate::grammar::Features;
use crate::learn::{Problem, Query};
use crate::real::Real;
use crate::region::Theta;
use crate::table::{Blank, Table};
use core::cell::Cell;
use core::mem::take;
use exclusions::Exclusions;
use layout::Layout;
use offers::BestSums;
use sums::Sums;
use values::{Column, Values};

/// Most left sides, half of them derived ones.
pub(super) const MAX_LHS: usize = u128::BITS as usize;
/// Levels of right sides, simple ones first: nothing, attributes and coordinates,
/// distances and angles, scaled ones.
const LEVELS: usize = 4;
const DIMENSIONS: usize = Dimension::ALL.len();
/// The most complex features that forms are made of.
const COMPLEXITY: usize = 2;
/// The feature of the right side "nothing".
const NOTHING: u16 = u16::MAX;

/// How much two equal values may differ by rounding.
#[inline(always)]
pub(super) fn tolerance<R: Real>(value: R) -> R {
    R::from_f64(64.0) * R::EPSILON * (R::from_f64(16.0) + value.abs())
}

/// The forms of a domain, what the feasible samples say about each and which
/// infeasible samples each excludes.
#[derive(Debug)]
pub(super) struct Forms<'m, R> {
    tuning: &'static Tuning,
    features: Features<'m, R>,
    layout: Layout,
    used: usize,
    /// Of how many forms, the first ones, `intervals` and `exclusions` tell.
    tracked: usize,
    /// Room for left sides.
    lhs_room: usize,
    /// Whether the domain has bodies.
    has_bodies: bool,
    /// The left sides.
    lefts: Table<'m, Left>,
    /// Which features the right sides are.
    rhs_features: Table<'m, u16>,
    sums: Sums<'m, R>,
    /// For the search for sums.
    ends: &'m mut [End<R>],
    failures: &'m mut [Failure<R>],
    values: Values<'m, R>,
    intervals: &'m mut [Interval<R>],
    exclusions: Exclusions<'m>,
    /// For each step, the samples at which it worked, and those at which it failed.
    sample_sets: &'m mut [u64],
    /// What it takes to name a form of each level and a direction, in bits.
    level_length: [f64; LEVELS],
    /// What it takes to name a threshold, in bits: asked for very often.
    threshold_length: f64,
    /// How much work was done since the last answer, in looks at a form.
    work: Cell<u32>,
}

impl<'m, R: Real> Forms<'m, R> {
    /// Forms of no domain yet, for [`Forms::enumerate`], in the tables that are theirs.
    pub(super) fn new(
        tuning: &'static Tuning,
        capacity: Capacity,
        memory: &mut Memory<'m, R>,
    ) -> Self {
        let intervals = take(&mut memory.intervals);
        let sample_sets = take(&mut memory.sample_sets);
        intervals.fill(Interval::BLANK);
        sample_sets.fill(0);
        let sums = take(&mut memory.sums);
        sums.fill(Sum::BLANK);
        let exclusions = Exclusions::new(take(&mut memory.exclusions), capacity.tracked());
        Forms {
            tuning,
            features: Features::empty(take(&mut memory.features), &mut []),
            layout: Layout {
                capacity: capacity.forms,
                ..Layout::default()
            },
            used: 0,
            tracked: capacity.tracked(),
            lhs_room: capacity.plain(),
            lefts: Table::new(take(&mut memory.lefts), "left sides of forms"),
            sums: Sums {
                slots: sums,
                values: take(&mut memory.sum_values),
                instances: capacity.instances,
                first: capacity.forms,
                best: BestSums::default(),
            },
            ends: take(&mut memory.ends),
            failures: take(&mut memory.failures),
            has_bodies: false,
            values: Values {
                rhs: take(&mut memory.rhs_values),
                rhs_count: memory.rhs_features.len(),
                lhs: take(&mut memory.lhs_values),
                lhs_count: 0,
                samples: Table::new(take(&mut memory.samples), "samples"),
            },
            rhs_features: Table::new(take(&mut memory.rhs_features), "right sides of forms"),
            intervals,
            exclusions,
            sample_sets,
            level_length: [0.0; LEVELS],
            threshold_length: 0.0,
            work: Cell::new(0),
        }
    }

    /// Finds the features of a domain, and the left sides among them.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is no room for any.
    pub(super) fn enumerate(&mut self, domain: &Domain<'_>) -> Result<(), Error> {
        domain.check_precision::<R>()?;
        let derived = 2 * (self.lefts.capacity() - self.lhs_room);
        self.features.fill(domain, COMPLEXITY, derived)?;
        self.has_bodies = !domain.bodies().is_empty();
        self.add_plain_lefts(domain)?;
        self.add_derived_lefts(domain);
        self.values.lhs_count = self.lefts.len();
        Ok(())
    }

    /// Forgets all samples.
    pub(super) fn forget(&mut self) {
        self.intervals.fill(Interval::BLANK);
        self.sample_sets.fill(0);
        self.sums.slots.fill(Sum::BLANK);
        self.values.samples.clear();
        self.threshold_length = 0.0;
    }

    pub(super) fn len(&self) -> usize {
        self.used
    }

    pub(super) fn left_out(&self) -> usize {
        self.layout.wanted() - self.used
    }

    /// The numbers that decide which hypotheses of them are good.
    pub(super) fn tuning(&self) -> &'static Tuning {
        self.tuning
    }

    pub(super) fn features(&self) -> &Features<'m, R> {
        &self.features
    }

    /// The feature on the left.
    pub(super) fn left_term(&self, form: &DirectedForm) -> NodeId {
        let left = self.left(form.lhs.into());
        NodeId(left.map_or(NOTHING, |left| left.feature))
    }

    /// The feature on the right, if it is one.
    fn right_term(&self, form: &DirectedForm) -> Option<NodeId> {
        let right = self.rhs_features.as_slice().get(usize::from(form.rhs));
        let right = right.copied().filter(|feature| *feature != NOTHING);
        right.filter(|_| form.level != SUM_LEVEL).map(NodeId)
    }

    /// Whether there is nothing on the right.
    pub(super) fn is_left_side(&self, form: &DirectedForm) -> bool {
        match self.sum(form) {
            Some(sum) => !sum.terms.iter().any(sums::Term::is_some),
            None => self.right_term(form).is_none(),
        }
    }

    /// Evaluates left sides at a sample, those with a bit in `wanted`: the others are not
    /// looked at there.
    #[inline(never)]
    pub(super) fn evaluate(
        &self,
        scene: &Scene<'_, R>,
        theta: &Theta,
        wanted: u128,
        lhs: &mut [R],
    ) {
        let theta = theta.map(R::from_f64);
        let mut sample: Point<'_, '_, R, R> = Point::blank(scene, &theta);
        sample.place_points();
        let nodes = self.features.nodes();
        for (place, (value, left)) in lhs.iter_mut().zip(self.lefts.as_slice()).enumerate() {
            if wanted >> place & 1 == 1 {
                *value = sample.measure(nodes, NodeId(left.feature));
            }
        }
    }

    /// The value of one form at a sample from one direction, as [`Forms::value`].
    #[inline(never)]
    pub(super) fn value_in(
        &self,
        scene: &Scene<'_, R>,
        theta: &Theta,
        form: &DirectedForm,
        instance: usize,
    ) -> R {
        let theta = theta.map(R::from_f64);
        let mut sample: Point<'_, '_, R, R> = Point::blank(scene, &theta);
        sample.place_points();
        let lhs = sample.measure(self.features.nodes(), self.left_term(form));
        self.with_lhs(form, instance, lhs)
    }

    /// Evaluates the left sides at a sample of a problem. A scene is large: it has left
    /// the stack when this returns.
    ///
    /// # Errors
    /// Those of [`Problem::instance`] and [`Scene::new`].
    #[inline(never)]
    pub(super) fn evaluate_query(
        &self,
        problem: &Problem<'_>,
        query: &Query,
        lhs: &mut [R],
    ) -> Result<(), Error> {
        let instance = problem.instance(query.instance)?;
        held::<R>(
            query.theta.iter().copied(),
            "a parameter is larger than any number of this precision",
        )?;
        let points = PointSet::all(problem.domain());
        let mut scene = Scene::blank(problem.domain(), instance, points);
        scene.place_points()?;
        self.evaluate(&scene, &query.theta, u128::MAX, lhs);
        Ok(())
    }

    /// The value of a form from one direction, larger further out, where the left sides
    /// are those in `lhs`.
    pub(super) fn value(&self, form: &DirectedForm, instance: usize, lhs: &[R]) -> R {
        let lhs = lhs.get(usize::from(form.lhs)).copied().unwrap_or(R::NAN);
        self.with_lhs(form, instance, lhs)
    }

    fn with_lhs(&self, form: &DirectedForm, instance: usize, lhs: R) -> R {
        let place = usize::from(form.rhs);
        let rhs = match form.level {
            SUM_LEVEL => self.sums.value(place, instance),
            _ => self.values.rhs_in(instance).get(place).copied(),
        };
        form.outward(lhs - rhs.unwrap_or(R::NAN))
    }

    /// The value of a form from one direction at a sample that was taken in.
    pub(super) fn value_at(&self, form: &DirectedForm, sample: usize) -> R {
        self.column(form).at(sample)
    }

    /// The values of a form from one direction at the samples.
    #[inline(always)]
    pub(super) fn column(&self, form: &DirectedForm) -> Column<'_, R> {
        let column = Column::of(&self.values, form);
        if form.level != SUM_LEVEL {
            return column;
        }
        Column {
            rhs: self.sums.in_slot(usize::from(form.rhs)),
            rhs_step: 1,
            ..column
        }
    }

    /// The feasible or the infeasible samples of a step.
    fn sample_set(&self, step: usize, feasible: bool) -> SampleSet {
        let (start, len) = self.place_of_set(step, feasible);
        SampleSet::of_words(self.sample_sets.get(start..start + len).unwrap_or(&[]))
    }

    /// Where a set starts in the table, and how long it is.
    fn place_of_set(&self, step: usize, feasible: bool) -> (usize, usize) {
        let len = self.values.samples.capacity().div_ceil(64);
        ((2 * step + usize::from(!feasible)) * len, len)
    }

    /// Puts a sample into a set.
    fn enter(&mut self, step: usize, feasible: bool, sample: usize) {
        let (start, _) = self.place_of_set(step, feasible);
        if let Some(word) = self.sample_sets.get_mut(start + sample / 64) {
            *word |= 1 << (sample % 64);
        }
    }

    /// How many samples there are.
    pub(super) fn samples(&self) -> usize {
        self.values.samples.len()
    }

    /// The instance of a sample.
    pub(super) fn instance_of(&self, sample: usize) -> usize {
        self.values.instance_of(sample)
    }

    /// How much samples count for how good a region is: those that were not drawn at random, but
    /// lie near a boundary, less.
    pub(super) fn weigh(&self, samples: impl Iterator<Item = usize>) -> f64 {
        let all = self.values.samples.as_slice();
        let drawn = |sample: usize| all.get(sample).is_some_and(|own| !own.is(Origin::Chosen));
        let weights = samples.map(|sample| match drawn(sample) {
            true => 1.0,
            false => self.tuning.undrawn,
        });
        weights.sum()
    }

    /// The samples that are put aside.
    pub(super) fn aside(&self) -> SampleSet {
        let mut set = SampleSet::EMPTY;
        let samples = self.values.samples.as_slice().iter().enumerate();
        for (place, _) in samples.filter(|(_, sample)| sample.is(Origin::Aside)) {
            set.insert(place);
        }
        set
    }

    /// How many words a set of samples has in use.
    fn words(&self) -> usize {
        self.samples().div_ceil(64)
    }
}
