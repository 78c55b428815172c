//! Right sides of forms, which say what no earlier one does.

use super::layout::Places;
use super::left::Tier;
use super::{Forms, LEVELS, NOTHING, tolerance};
use crate::domain::{Dependence, Dimension, MAX_PARAMETERS, Node, PointSet, Scene};
use crate::error::Error;
use crate::grammar::{Kind, feature_id};
use crate::learn::Problem;
use crate::real::Real;
use crate::table::Table;

impl<R: Real> Forms<'_, R> {
    /// Whether there is room for the instances of a problem, and each makes a scene, but for
    /// the first ones, of which that is known.
    pub(in super::super) fn check(&self, problem: &Problem<'_>, known: usize) -> Result<(), Error> {
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
    pub(in super::super) fn lay_out(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
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
}
