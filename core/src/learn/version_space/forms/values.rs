//! The values of forms at samples: a matrix of right sides in instances, and one of left
//! sides at samples.

use super::{DirectedForm, Origin, Sample, SampleSet};
use crate::real::Real;
use crate::table::Table;
use core::ops::Range;

/// What the value of a form at a sample follows from.
#[derive(Debug)]
pub(super) struct Values<'m, R> {
    /// Right sides, a row for each instance.
    pub(super) rhs: &'m mut [R],
    pub(super) rhs_count: usize,
    /// Left sides, a row for each sample.
    pub(super) lhs: &'m mut [R],
    pub(super) lhs_count: usize,
    pub(super) samples: Table<'m, Sample>,
}

impl<R: Real> Values<'_, R> {
    /// Appends a sample with its left sides.
    pub(super) fn push(&mut self, instance: usize, origin: Origin, lhs: &[R]) {
        let rows = self.lhs.chunks_exact_mut(self.lhs_count.max(1));
        let row = rows.into_iter().nth(self.samples.len());
        for (slot, value) in row.unwrap_or(&mut []).iter_mut().zip(lhs) {
            *slot = *value;
        }
        // There is room: as much as for observations, of which each decides one at most.
        let _ = self.samples.push(Sample::new(instance, origin));
    }

    /// The right sides in an instance.
    pub(super) fn rhs_in(&self, instance: usize) -> &[R] {
        let row = self.rhs.chunks_exact(self.rhs_count.max(1)).nth(instance);
        row.unwrap_or(&[])
    }

    #[inline(always)]
    pub(super) fn instance_of(&self, sample: usize) -> usize {
        let sample = self.samples.as_slice().get(sample);
        sample.map_or(0, |s| s.instance())
    }

    #[inline(always)]
    pub(super) fn lhs_at(&self, lhs: usize, sample: usize) -> Option<R> {
        self.lhs.get(sample * self.lhs_count + lhs).copied()
    }

    /// The value of a form at a sample.
    #[inline(always)]
    pub(super) fn at(&self, lhs: usize, rhs: usize, sample: usize) -> R {
        let place = self.instance_of(sample) * self.rhs_count + rhs;
        match (self.lhs_at(lhs, sample), self.rhs.get(place)) {
            (Some(lhs), Some(rhs)) => lhs - *rhs,
            _ => R::NAN,
        }
    }

    /// The values of forms with one left side and neighbouring right sides at a sample.
    #[inline(always)]
    pub(super) fn of_run(
        &self,
        lhs: usize,
        rhs: &Range<usize>,
        sample: usize,
    ) -> impl Iterator<Item = R> {
        let lhs = self.lhs_at(lhs, sample).unwrap_or(R::NAN);
        let rhs = self.rhs_in(self.instance_of(sample)).get(rhs.clone());
        rhs.unwrap_or(&[]).iter().map(move |rhs| lhs - *rhs)
    }
}

/// The values of one form at the samples from one direction, larger further out. What all of
/// them have in common was looked up once.
#[derive(Clone, Copy)]
pub(in super::super) struct Column<'v, R> {
    pub(super) upper: bool,
    pub(super) samples: &'v [Sample],
    /// Its left sides: the first, and so on in steps.
    pub(super) lhs: &'v [R],
    pub(super) lhs_step: usize,
    /// Its right sides likewise.
    pub(super) rhs: &'v [R],
    pub(super) rhs_step: usize,
}

impl<'v, R: Real> Column<'v, R> {
    /// The values of a form with a feature on the right, or nothing.
    #[inline(always)]
    pub(super) fn of(values: &'v Values<'_, R>, form: &DirectedForm) -> Self {
        Column {
            upper: form.upper(),
            samples: values.samples.as_slice(),
            lhs: values.lhs.get(usize::from(form.lhs)..).unwrap_or(&[]),
            lhs_step: values.lhs_count,
            rhs: values.rhs.get(usize::from(form.rhs)..).unwrap_or(&[]),
            rhs_step: values.rhs_count,
        }
    }

    /// The value at a sample.
    #[inline(always)]
    pub(in super::super) fn at(&self, sample: usize) -> R {
        let instance = self.samples.get(sample).map_or(0, |own| own.instance());
        let lhs = self.lhs.get(sample * self.lhs_step);
        let value = match (lhs, self.rhs.get(instance * self.rhs_step)) {
            (Some(lhs), Some(rhs)) => *lhs - *rhs,
            _ => R::NAN,
        };
        if self.upper { value } else { -value }
    }

    /// The values at the samples of a set, in their order.
    #[inline(always)]
    pub(in super::super) fn of_all(&self, set: &SampleSet) -> impl Iterator<Item = R> {
        set.iter().map(|sample| self.at(sample))
    }
}
