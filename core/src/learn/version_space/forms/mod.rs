//! Forms and their version spaces.
//!
//! A form is a difference `left - right` of a feature that depends on the sample
//! and one that depends on the instance only, or nothing. Its version space is an
//! interval: S, all values at feasible samples. An infeasible sample is a bit per
//! form and direction: whether its value lies outside of S, on that side. Of the first
//! forms both are kept up to date, of the others computed when needed, to save memory.
//!
//! Right sides are evaluated once per instance, left sides once per sample; what
//! is done per form is one subtraction and two comparisons, in long runs over
//! neighbouring right sides.

mod known;
mod layout;
mod scan;
mod update;

pub use known::Span;
pub(in crate::learn::version_space) use layout::Side;

use crate::domain::{
    Dependence, Dimension, Domain, MAX_PARAMETERS, Node, NodeId, PointSet, Sample as Point, Scene,
};
use crate::error::Error;
use crate::grammar::{FACTORS, Features, feature_id};
use crate::learn::{Problem, Query};
use crate::real::Real;
use crate::region::Theta;
use crate::table::Table;
use known::Known;
use layout::{Block, Layout};

/// Most left sides.
pub(in crate::learn::version_space) const MAX_LEFTS: usize = 64;
/// Most words of a set of samples.
pub(in crate::learn::version_space) const MAX_WORDS: usize =
    match cfg!(feature = "many_observations") {
        true => 32,
        false => 4,
    };
/// Kinds of right sides, simple ones first: nothing, attributes and coordinates,
/// distances and angles, scaled ones.
pub(in crate::learn::version_space) const LEVELS: usize = 4;
const DIMENSIONS: usize = Dimension::ALL.len();
/// The most complex features that forms are made of.
const COMPLEXITY: usize = 2;
/// What it takes to say that a form is one named before, in bits.
const AGAIN: f64 = 3.0;
/// The column of "nothing".
const NOTHING: u16 = u16::MAX;

/// A set of samples, a bit each.
pub(in crate::learn::version_space) type Set = [u64; MAX_WORDS];

/// How much two equal values may differ by rounding.
#[inline(always)]
pub(in crate::learn::version_space) fn tolerance<R: Real>(value: R) -> R {
    R::from_f64(64.0) * R::EPSILON * (R::from_f64(16.0) + value.abs())
}

/// A sample whose answer is decided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sample {
    instance: u32,
}

/// The forms of a domain, what the feasible samples say about each and which
/// infeasible samples each excludes.
#[derive(Debug)]
pub(in crate::learn::version_space) struct Forms<'m, R> {
    features: Features<'m, R>,
    layout: Layout,
    used: usize,
    /// Of how many forms, the first ones, `spans` and `bits` tell.
    tracked: usize,
    /// Room for left sides, and how many there are.
    left_room: usize,
    left_count: usize,
    columns: Table<'m, u16>,
    /// Right sides, one row per instance.
    instances: &'m mut [R],
    spans: &'m mut [Span<R>],
    bits: &'m mut [u64],
    /// Left sides, one row per sample.
    rows: &'m mut [R],
    samples: Table<'m, Sample>,
    /// For each step, the samples at which it worked, and those at which it failed.
    sets: &'m mut [u64],
    width: usize,
    /// What it takes to name a form of each level and a direction.
    bits_of_level: [f64; LEVELS],
}

/// Tables that forms live in.
pub(in crate::learn::version_space) struct Storage<'m, R> {
    pub(in crate::learn::version_space) features: &'m mut [Node],
    pub(in crate::learn::version_space) columns: &'m mut [u16],
    pub(in crate::learn::version_space) instances: &'m mut [R],
    pub(in crate::learn::version_space) spans: &'m mut [Span<R>],
    pub(in crate::learn::version_space) bits: &'m mut [u64],
    pub(in crate::learn::version_space) rows: &'m mut [R],
    pub(in crate::learn::version_space) sets: &'m mut [u64],
    pub(in crate::learn::version_space) samples: &'m mut [Sample],
    pub(in crate::learn::version_space) forms: usize,
    pub(in crate::learn::version_space) tracked: usize,
    pub(in crate::learn::version_space) lefts: usize,
}

impl<'m, R: Real> Forms<'m, R> {
    /// Forms of no domain yet, for [`Forms::enumerate`].
    pub(in crate::learn::version_space) fn new(storage: Storage<'m, R>) -> Self {
        storage.spans.fill(Span::default());
        storage.sets.fill(0);
        Forms {
            width: storage.columns.len(),
            features: Features::empty(storage.features, &mut []),
            layout: Layout {
                capacity: storage.forms,
                ..Layout::default()
            },
            used: 0,
            tracked: storage.tracked,
            left_room: storage.lefts,
            left_count: 0,
            columns: Table::new(storage.columns, "right sides of forms"),
            instances: storage.instances,
            spans: storage.spans,
            bits: storage.bits,
            rows: storage.rows,
            samples: Table::new(storage.samples, "samples"),
            sets: storage.sets,
            bits_of_level: [0.0; LEVELS],
        }
    }

    /// Finds the features of a domain, and the left sides among them.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is no room for any.
    pub(in crate::learn::version_space) fn enumerate(
        &mut self,
        domain: &Domain<'_>,
    ) -> Result<(), Error> {
        self.features.fill(domain, COMPLEXITY)?;
        for (blocks, dimension) in self.layout.lefts.iter_mut().zip(Dimension::ALL) {
            for (block, complexity) in blocks.iter_mut().zip(1..) {
                let range = self.features.lefts(complexity, dimension);
                // Left sides are the first features behind the factors.
                let start = range.start.saturating_sub(FACTORS.len());
                let len = range.len().min(self.left_room.saturating_sub(start));
                *block = Block::between(start, start + len);
                self.left_count += len;
                let all = self.features.enumerated_lefts(complexity, dimension);
                if let Some(lost) = self.layout.lefts_left_out.get_mut(dimension as usize) {
                    *lost += u32::try_from(all).unwrap_or(u32::MAX) - len as u32;
                }
            }
        }
        Ok(())
    }

    /// Evaluates the right sides in all instances and lays out the forms.
    ///
    /// Right sides that do not vary, or vary as an earlier one does, would say
    /// nothing new: thresholds absorb the difference.
    pub(in crate::learn::version_space) fn settle(
        &mut self,
        problem: &Problem<'_>,
    ) -> Result<(), Error> {
        let count = problem.count();
        let needed = count.checked_mul(self.width);
        if needed.is_none_or(|n| n > self.instances.len()) {
            return Err(Error::CapacityExceeded("problem instances"));
        }
        self.columns.clear();
        self.fill_rows(problem, &mut |values, row| {
            for (slot, value) in row.iter_mut().zip(values) {
                *slot = *value;
            }
        })?;
        for level in 0..LEVELS {
            for dimension in Dimension::ALL {
                let start = self.columns.len();
                self.add_columns(problem, level, dimension)?;
                let own = self.layout.columns.get_mut(level);
                if let Some(slot) = own.and_then(|own| own.get_mut(dimension as usize)) {
                    *slot = Block::between(start, self.columns.len());
                }
            }
        }
        let columns = core::mem::replace(&mut self.columns, Table::new(&mut [], ""));
        let filled = self.fill_rows(problem, &mut |values, row| {
            for (slot, column) in row.iter_mut().zip(columns.as_slice()) {
                let value = values.get(usize::from(*column)).copied();
                *slot = value.unwrap_or(R::ZERO);
            }
        });
        self.columns = columns;
        self.used = self.layout.runs().map(|run| run.forms.len()).sum();
        for (level, bits) in self.bits_of_level.iter_mut().enumerate() {
            let own = self.layout.runs().filter(|run| run.level == level);
            let sides = 2 * own.map(|run| run.forms.len()).sum::<usize>();
            *bits = (level + 1) as f64 + libm::log2(sides.max(1) as f64);
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
        let rows = self.instances.chunks_exact_mut(self.width.max(1));
        for (index, row) in (0..problem.count()).zip(rows) {
            let mut scene = Scene::blank(problem.domain(), problem.instance(index)?, points);
            scene.settle()?;
            // There are no samples yet, so their table is free.
            self.features.evaluate_into(&scene, &theta, self.rows);
            fill(self.rows, row);
        }
        Ok(())
    }

    fn add_columns(
        &mut self,
        problem: &Problem<'_>,
        level: usize,
        dimension: Dimension,
    ) -> Result<(), Error> {
        let complexity = match level {
            0 if self.layout.has_left(dimension) => return self.columns.push(NOTHING),
            0 => return Ok(()),
            1 => 1,
            _ => 2,
        };
        for feature in self.features.rights(complexity, dimension) {
            let nodes = self.features.nodes();
            let scaled = matches!(nodes.get(feature), Some(Node::Product(..)));
            let id = feature_id(feature);
            let varies = problem.domain().dependence(nodes, id) == Dependence::Instance;
            if varies && scaled == (level == 3) && self.is_new(problem.count(), feature) {
                self.columns.push(id.0)?;
            }
        }
        Ok(())
    }

    /// Whether a right side differs from nothing and from the earlier ones by more
    /// than a constant.
    fn is_new(&self, count: usize, feature: usize) -> bool {
        let rows = || self.instances.chunks_exact(self.width.max(1)).take(count);
        let value = |row: &[R], feature: usize| row.get(feature).copied().unwrap_or(R::ZERO);
        let same = |other: usize| {
            let mut differences = rows().map(|row| value(row, feature) - value(row, other));
            let first = differences.next().unwrap_or(R::ZERO);
            differences.all(|d| (d - first).abs() <= tolerance(first))
        };
        // "Nothing" has no value in a row, which counts as zero.
        let mut columns = self.columns.as_slice().iter();
        rows().all(|row| value(row, feature).is_finite())
            && !columns.any(|column| same(usize::from(*column)))
    }

    pub(in crate::learn::version_space) fn len(&self) -> usize {
        self.used
    }

    pub(in crate::learn::version_space) fn left_out(&self) -> usize {
        self.layout.wanted() - self.used
    }

    pub(in crate::learn::version_space) fn features(&self) -> &Features<'m, R> {
        &self.features
    }

    /// The feature on the left, and on the right if there is one.
    pub(in crate::learn::version_space) fn terms(&self, side: &Side) -> (NodeId, Option<NodeId>) {
        let column = self
            .columns
            .as_slice()
            .get(usize::from(side.column))
            .copied();
        (
            feature_id(usize::from(side.left) + FACTORS.len()),
            column.filter(|c| *c != NOTHING).map(NodeId),
        )
    }

    /// Evaluates the left sides at a sample.
    #[inline(never)]
    pub(in crate::learn::version_space) fn evaluate(
        &self,
        scene: &Scene<'_, R>,
        theta: &Theta,
        lefts: &mut [R],
    ) {
        let theta = theta.map(R::from_f64);
        let mut sample: Point<'_, '_, R, R> = Point::blank(scene, &theta);
        sample.settle();
        let nodes = self.features.nodes().iter().skip(FACTORS.len());
        for (value, node) in lefts.iter_mut().zip(nodes).take(self.left_count) {
            *value = sample.node(*node, |_| R::ZERO);
        }
    }

    /// The value of one form at a sample from one direction, as [`Forms::value`].
    #[inline(never)]
    pub(in crate::learn::version_space) fn value_in(
        &self,
        scene: &Scene<'_, R>,
        theta: &Theta,
        side: &Side,
        instance: usize,
    ) -> R {
        let theta = theta.map(R::from_f64);
        let mut sample: Point<'_, '_, R, R> = Point::blank(scene, &theta);
        sample.settle();
        let node = self.features.nodes().iter().skip(FACTORS.len());
        let node = node.copied().nth(usize::from(side.left));
        let left = node.map_or(R::NAN, |node| sample.node(node, |_| R::ZERO));
        self.with_left(side, instance, left)
    }

    /// Evaluates the left sides at a sample of a problem. A scene is large: it has left
    /// the stack when this returns.
    ///
    /// # Errors
    /// Those of [`Problem::instance`] and [`Scene::new`].
    #[inline(never)]
    pub(in crate::learn::version_space) fn evaluate_query(
        &self,
        problem: &Problem<'_>,
        query: &Query,
        lefts: &mut [R],
    ) -> Result<(), Error> {
        let instance = problem.instance(query.instance)?;
        let points = PointSet::all(problem.domain());
        let mut scene = Scene::blank(problem.domain(), instance, points);
        scene.settle()?;
        self.evaluate(&scene, &query.theta, lefts);
        Ok(())
    }

    fn instance(&self, instance: usize) -> &[R] {
        self.instances
            .chunks_exact(self.width.max(1))
            .nth(instance)
            .unwrap_or(&[])
    }

    /// The value of a form from one direction: larger is further out.
    pub(in crate::learn::version_space) fn value(
        &self,
        side: &Side,
        instance: usize,
        lefts: &[R],
    ) -> R {
        let left = lefts.get(usize::from(side.left)).copied().unwrap_or(R::NAN);
        self.with_left(side, instance, left)
    }

    fn with_left(&self, side: &Side, instance: usize, left: R) -> R {
        let right = self
            .instance(instance)
            .get(usize::from(side.column))
            .copied();
        side.outward(left - right.unwrap_or(R::NAN))
    }

    /// The infeasible samples of a step.
    pub(in crate::learn::version_space) fn infeasible(&self, step: usize) -> Set {
        self.set(step, false)
    }

    /// The feasible samples of a step.
    pub(in crate::learn::version_space) fn feasible(&self, step: usize) -> Set {
        self.set(step, true)
    }

    fn set(&self, step: usize, feasible: bool) -> Set {
        let mut set = [0; MAX_WORDS];
        let (start, len) = self.place_of_set(step, feasible);
        let own = self.sets.get(start..start + len).unwrap_or(&[]);
        for (word, own) in set.iter_mut().zip(own) {
            *word = *own;
        }
        set
    }

    /// Where a set starts in the table, and how long it is.
    fn place_of_set(&self, step: usize, feasible: bool) -> (usize, usize) {
        let len = self.samples.capacity().div_ceil(64);
        ((2 * step + usize::from(!feasible)) * len, len)
    }

    /// Puts a sample into a set.
    fn enter(&mut self, step: usize, feasible: bool, sample: usize) {
        let (start, _) = self.place_of_set(step, feasible);
        if let Some(word) = self.sets.get_mut(start + sample / 64) {
            *word |= 1 << (sample % 64);
        }
    }

    /// The length of a bound's description in bits: which form, unless it is named
    /// already, which direction, and which threshold of those that the samples tell
    /// apart.
    pub(in crate::learn::version_space) fn bits(&self, side: &Side, named: bool) -> f64 {
        let form = self.bits_of_level.get(usize::from(side.level));
        let form = form.copied().filter(|_| !named).unwrap_or(AGAIN);
        form + self.bits_of_threshold()
    }

    /// The length of a threshold's description, among those that the samples tell apart.
    pub(in crate::learn::version_space) fn bits_of_threshold(&self) -> f64 {
        libm::log2((self.samples() + 1) as f64)
    }

    /// The value of a form at a sample.
    pub(in crate::learn::version_space) fn value_at(&self, side: &Side, sample: usize) -> R {
        let value = self
            .known()
            .value(side.left.into(), side.column.into(), sample);
        side.outward(value)
    }

    /// How many samples there are.
    pub(in crate::learn::version_space) fn samples(&self) -> usize {
        self.samples.len()
    }

    /// The instance of a sample.
    pub(in crate::learn::version_space) fn instance_of(&self, sample: usize) -> usize {
        let sample = self.samples.as_slice().get(sample);
        sample.map_or(0, |s| s.instance as usize)
    }

    /// How many words a set of samples has in use.
    fn words(&self) -> usize {
        self.samples.len().div_ceil(64)
    }

    fn known(&self) -> Known<'_, R> {
        Known {
            instances: self.instances,
            width: self.width,
            rows: self.rows,
            left_count: self.left_count,
            samples: self.samples.as_slice(),
        }
    }
}
