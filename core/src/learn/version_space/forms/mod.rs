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
pub(super) use sample_set::{MAX_WORDS, SampleSet};
pub use search::{End, Failure};
pub(super) use step::StepView;
pub(super) use sums::SUM_LEVEL;
pub use sums::Sum;

use super::memory::{Capacity, Memory};
use super::tuning::Tuning;
use crate::domain::{
    Dependence, Dimension, Domain, MAX_PARAMETERS, Metric, Node, NodeId, PointSet, Quantity,
    Sample as Point, Scene, held,
};
use crate::error::Error;
use crate::geometry::Relation;
use crate::grammar::{Features, Kind, feature_id};
use crate::learn::{Problem, Query};
use crate::real::Real;
use crate::region::Theta;
use crate::table::{Blank, Table};
use core::cell::Cell;
use core::mem::take;
use exclusions::Exclusions;
use layout::{Layout, Places};
use left::Tier;
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

/// Where a sample comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// It was asked about for a reason.
    Chosen,
    /// It was drawn at random, from everything or from a region, or nobody asked.
    Drawn,
    /// As before, and it is put aside to judge a region that is wrong about some answers.
    Aside,
}

/// A sample whose label is decided: its instance, and where it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample(u32);

impl Sample {
    /// The bits of its origin.
    const ORIGIN: u32 = 3 << 30;

    fn new(instance: usize, origin: Origin) -> Sample {
        Sample((instance as u32 & !Sample::ORIGIN) | (origin as u32) << 30)
    }

    fn instance(self) -> usize {
        (self.0 & !Sample::ORIGIN) as usize
    }

    fn is(self, origin: Origin) -> bool {
        self.0 >> 30 == origin as u32
    }
}

impl Blank for Sample {
    const BLANK: Self = Sample(0);
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
                best: Default::default(),
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

    /// Whether there is room for the instances of a problem, and each makes a scene, but for
    /// the first ones, of which that is known.
    pub(super) fn check(&self, problem: &Problem<'_>, known: usize) -> Result<(), Error> {
        let needed = problem.count().checked_mul(self.values.rhs_count);
        if needed.is_none_or(|n| n > self.values.rhs.len()) {
            return Err(Error::CapacityExceeded("problem instances"));
        }
        (known..problem.count()).try_for_each(|index| {
            let points = PointSet::all(problem.domain());
            let mut scene = Scene::<R>::blank(problem.domain(), problem.instance(index)?, points);
            scene.place_points()
        })
    }

    /// Evaluates the right sides in all instances and lays out the forms. There are no
    /// samples.
    ///
    /// Right sides that do not vary, or vary as an earlier one does, would say
    /// nothing new: thresholds absorb the difference.
    pub(super) fn lay_out(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        self.rhs_features.clear();
        self.fill_rows(problem, &mut |values, row| {
            for (slot, value) in row.iter_mut().zip(values) {
                *slot = *value;
            }
        })?;
        for level in 0..LEVELS {
            for dimension in Dimension::ALL {
                let start = self.rhs_features.len();
                self.add_rhs(problem, level, dimension)?;
                let own = self.layout.rhs.get_mut(level);
                if let Some(slot) = own.and_then(|own| own.get_mut(dimension as usize)) {
                    *slot = Places::between(start, self.rhs_features.len());
                }
            }
        }
        self.add_scene(problem);
        let rhs = core::mem::replace(&mut self.rhs_features, Table::new(&mut [], ""));
        let filled = self.fill_rows(problem, &mut |values, row| {
            for (slot, feature) in row.iter_mut().zip(rhs.as_slice()) {
                let value = values.get(usize::from(*feature)).copied();
                *slot = value.unwrap_or(R::ZERO);
            }
        });
        self.rhs_features = rhs;
        self.used = self.layout.runs().map(|run| run.forms.len()).sum();
        for (level, length) in self.level_length.iter_mut().enumerate() {
            let own = self.layout.runs().filter(|run| run.level == level);
            let directed = 2 * own.map(|run| run.forms.len()).sum::<usize>();
            *length = (level + 1) as f64 + libm::log2(directed.max(1) as f64);
        }
        filled
    }

    /// Calls `fill` with the values of all features in each instance and its row.
    #[inline(never)]
    fn fill_rows(
        &mut self,
        problem: &Problem<'_>,
        fill: &mut dyn FnMut(&[R], &mut [R]),
    ) -> Result<(), Error> {
        let points = PointSet::all(problem.domain());
        let theta = [R::ZERO; MAX_PARAMETERS];
        let rows = self
            .values
            .rhs
            .chunks_exact_mut(self.values.rhs_count.max(1));
        for (index, row) in (0..problem.count()).zip(rows) {
            let mut scene = Scene::blank(problem.domain(), problem.instance(index)?, points);
            scene.place_points()?;
            // There are no samples yet, so their table is free.
            self.features.evaluate_into(&scene, &theta, self.values.lhs);
            fill(self.values.lhs, row);
        }
        Ok(())
    }

    /// Appends the right sides of a level and dimension.
    fn add_rhs(
        &mut self,
        problem: &Problem<'_>,
        level: usize,
        dimension: Dimension,
    ) -> Result<(), Error> {
        let complexity = match level {
            0 if self.layout.has_lhs(dimension) => return self.rhs_features.push(NOTHING),
            0 => return Ok(()),
            1 => 1,
            _ => 2,
        };
        for feature in self.features.rhs(complexity, dimension) {
            let nodes = self.features.nodes();
            let scaled = matches!(nodes.get(feature), Some(Node::Product(..)));
            let id = feature_id(feature);
            let domain = problem.domain();
            let varies = domain.dependence(nodes, id) == Dependence::Instance
                && !Kind::is_share_of_place(domain, nodes, id);
            if varies && scaled == (level == 3) && self.is_new(problem.count(), feature) {
                self.rhs_features.push(id.0)?;
            }
        }
        Ok(())
    }

    /// Appends the attributes that are no right sides yet, for sums.
    fn add_scene(&mut self, problem: &Problem<'_>) {
        for place in 0..self.lefts.len() {
            let scene = self.left(place).filter(|left| left.tier == Tier::Scene);
            let Some(feature) = scene.map(|left| left.feature) else {
                continue;
            };
            if self.is_new(problem.count(), usize::from(feature)) {
                // One without room is no right side.
                let _ = self.rhs_features.push(feature);
            }
        }
    }

    /// Whether a right side differs from nothing and from the earlier ones by more
    /// than a constant.
    fn is_new(&self, count: usize, feature: usize) -> bool {
        let rows = || {
            let rows = self.values.rhs.chunks_exact(self.values.rhs_count.max(1));
            rows.take(count)
        };
        let value = |row: &[R], feature: usize| row.get(feature).copied().unwrap_or(R::ZERO);
        let same = |other: usize| {
            let mut differences = rows().map(|row| value(row, feature) - value(row, other));
            let first = differences.next().unwrap_or(R::ZERO);
            differences.all(|d| (d - first).abs() <= tolerance(first))
        };
        // "Nothing" has no value in a row, which counts as zero.
        let mut earlier = self.rhs_features.as_slice().iter();
        rows().all(|row| value(row, feature).is_finite())
            && !earlier.any(|other| same(usize::from(*other)))
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

    /// The length of a bound's description in bits: which form, unless it is named
    /// already, which direction, and which threshold of those that the samples tell
    /// apart.
    pub(super) fn bound_length(&self, form: &DirectedForm, named: bool) -> f64 {
        let level = self.level_length.get(usize::from(form.level));
        let length = match self.sum(form) {
            Some(sum) => Some(f64::from(sum.length)),
            None => level.map(|level| level + self.class_length(form)),
        };
        let length = length.filter(|_| !named);
        length.unwrap_or(self.tuning.form_again) + self.threshold_length()
    }

    /// What a form costs for what it measures, in bits.
    fn class_length(&self, form: &DirectedForm) -> f64 {
        let tuning = self.tuning;
        let lhs = self.left_term(form);
        let node = self.features.nodes().get(usize::from(lhs.0));
        let quantity = match node.filter(|_| self.has_bodies) {
            Some(Node::Quantity(quantity) | Node::Extreme(_, quantity)) => quantity,
            Some(Node::Parameter(_)) => return tuning.parameter_class,
            _ => return 0.0,
        };
        match quantity {
            Quantity::Relation(Relation::Coordinate(_), ..) => tuning.parameter_class,
            Quantity::Relation(
                Relation::InsideAlong(_) | Relation::Corner | Relation::Magnitude(_),
                ..,
            )
            | Quantity::Angle(..)
            | Quantity::FoldedAngle(..)
            | Quantity::Off(..)
            | Quantity::VertexAngle(..) => tuning.axis_class,
            Quantity::Relation(..) | Quantity::Attribute(_) => 0.0,
            Quantity::Distance(Metric::Straight, ..) | Quantity::Gap(..) | Quantity::Sight(..) => {
                tuning.distance_class
            }
            Quantity::Distance(..) | Quantity::Coordinate(..) => tuning.world_class,
        }
    }

    /// The length of a threshold's description, among those that the samples tell apart.
    pub(super) fn threshold_length(&self) -> f64 {
        self.threshold_length
    }

    /// How many samples there are.
    pub(super) fn samples(&self) -> usize {
        self.values.samples.len()
    }

    /// The instance of a sample.
    pub(super) fn instance_of(&self, sample: usize) -> usize {
        self.values.instance_of(sample)
    }

    /// Whether a sample was drawn at random.
    pub(super) fn is_drawn(&self, sample: usize) -> bool {
        let sample = self.values.samples.as_slice().get(sample);
        sample.is_some_and(|sample| !sample.is(Origin::Chosen))
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
