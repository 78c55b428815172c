//! Comparing instances by their features, before there are samples.
//!
//! The tables of samples are free then: the features of the instance that is looked at stand
//! where left sides will, what they range over where S of the forms will, and those of the
//! instances that are kept where right sides will.

use super::{Forms, Interval};
use crate::domain::{Domain, MAX_PARAMETERS, PointSet, Scene};
use crate::error::Error;
use crate::real::Real;
use crate::table::Blank;

impl<R: Real> Forms<'_, R> {
    /// Evaluates the features of an instance, with parameters in the middle of their ranges.
    ///
    /// # Errors
    /// Those of [`Domain::check_instance`] and [`Scene::new`].
    #[inline(never)]
    pub(in super::super) fn look_at(
        &mut self,
        domain: &Domain<'_>,
        instance: &[f64],
    ) -> Result<(), Error> {
        domain.check_instance(instance)?;
        let mut theta = [R::ZERO; MAX_PARAMETERS];
        for (value, own) in theta.iter_mut().zip(domain.parameters()) {
            *value = R::from_f64(0.5 * own.low + 0.5 * own.high);
        }
        let mut scene = Scene::blank(domain, instance, PointSet::all(domain));
        scene.place_points()?;
        self.features.evaluate_into(&scene, &theta, self.values.lhs);
        Ok(())
    }

    /// Extends what the features range over to the instance that is looked at.
    pub(in super::super) fn note_ranges(&mut self) {
        for (range, value) in self.intervals.iter_mut().zip(&*self.values.lhs) {
            // The first one lies outside on both sides.
            range.include(*value);
            range.include(*value);
        }
    }

    /// How far the instance that is looked at is from the nearest of the first so many that are
    /// kept, feature by feature.
    pub(in super::super) fn distance_to_kept(&self, count: usize) -> R {
        let rows = || {
            let rows = self.values.rhs.chunks_exact(self.values.rhs_count.max(1));
            rows.take(count)
        };
        let features = self.values.lhs.iter().zip(&*self.intervals).enumerate();
        let apart = features.map(|(feature, (value, range))| {
            let width = range.high - range.low;
            let others = rows().filter_map(|row| row.get(feature));
            let nearest = others.fold(R::INFINITY, |least, other| {
                least.min((*value - *other).abs())
            });
            let share = nearest / width;
            match share.is_finite() {
                true => share,
                false => R::ZERO,
            }
        });
        apart
            .take(self.features.len())
            .fold(R::ZERO, |sum, own| sum + own)
    }

    /// Keeps the features of the instance that is looked at.
    pub(in super::super) fn keep_row(&mut self, place: usize) {
        let rows = self
            .values
            .rhs
            .chunks_exact_mut(self.values.rhs_count.max(1));
        let row = rows.into_iter().nth(place).unwrap_or(&mut []);
        for (slot, value) in row.iter_mut().zip(&*self.values.lhs) {
            *slot = *value;
        }
    }

    /// Leaves the tables as they were.
    pub(in super::super) fn end_comparing(&mut self) {
        self.intervals.fill(Interval::BLANK);
    }
}
