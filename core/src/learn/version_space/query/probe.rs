//! Just inside or just outside of a bound, in another instance.

use super::Strategy;
use crate::error::Error;
use crate::learn::Query;
use crate::random::{Generator, below, uniform};
use crate::real::Real;
use rand_core::Rng;

impl<R: Real> Strategy<'_, '_, R> {
    /// A sample just inside or just outside of one bound, where none of the
    /// instance is yet.
    #[inline(never)]
    pub(super) fn probe(&self, rng: &mut Generator, query: &mut Query) -> Result<bool, Error> {
        let tuning = self.forms.tuning();
        let count = self.committee.best_bounds().count();
        let Some((clause, bound, width)) = self.bounds().nth(below(rng, count)) else {
            return Ok(false);
        };
        let margin = width * R::from_f64(tuning.narrow);
        let off = margin * R::from_f64(tuning.probe * uniform(rng));
        let farthest = margin * R::from_f64(tuning.probe);
        let inside = rng.next_u32() & 1 == 0;
        let (value, [low, high]) = if inside {
            (bound.inner - off, [bound.inner - farthest, bound.inner])
        } else {
            (bound.outer + off, [bound.outer, bound.outer + farthest])
        };
        let probed = |instance: usize| {
            let near = |sample: &usize| {
                let value = self.forms.value_at(&bound.form, *sample);
                self.forms.instance_of(*sample) == instance && low <= value && value <= high
            };
            let open = self.open().any(|query| query.instance == instance);
            open || (0..self.forms.samples()).any(|sample| near(&sample))
        };
        self.at_value((clause, bound), value, &probed, rng, query)
    }
}
