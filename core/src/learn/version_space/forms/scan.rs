//! What is known of forms: read where it is tracked, computed from the samples where it
//! is not. Both ways say the same, as S only widens.

use super::layout::Run;
use super::{Forms, Set, Side, Span, known::excludes};
use crate::learn::version_space::set::{insert, members};
use crate::real::Real;

/// Forms whose version spaces are computed together.
const BLOCK: usize = 16;

impl<R: Real> Forms<'_, R> {
    /// Calls `visit` with every form up to a level, from both directions.
    pub(in crate::learn::version_space) fn for_each_side(
        &self,
        level: u8,
        mut visit: impl FnMut(Side),
    ) {
        for run in self.layout.runs() {
            if run.level > usize::from(level) {
                continue;
            }
            for (form, column) in run.forms.clone().zip(run.columns.clone()) {
                visit(run.side(form, column, true));
                visit(run.side(form, column, false));
            }
        }
    }

    /// Calls `visit` with every form of the same left side, from the same direction.
    pub(in crate::learn::version_space) fn for_each_right(
        &self,
        side: &Side,
        mut visit: impl FnMut(Side),
    ) {
        let runs = self.layout.runs();
        for run in runs.filter(|run| run.left == usize::from(side.left)) {
            for (form, column) in run.forms.clone().zip(run.columns.clone()) {
                visit(run.side(form, column, side.upper));
            }
        }
    }

    /// Calls `visit` with every form from both directions and the number of
    /// infeasible samples of `wanted`, all of one step, that it excludes, unless it is
    /// zero.
    pub(in crate::learn::version_space) fn for_each_count(
        &self,
        step: usize,
        wanted: &Set,
        visit: &mut dyn FnMut(Side, u32),
    ) {
        for upper in [true, false] {
            for run in self.layout.runs() {
                let (tracked, other) = run.split(self.tracked);
                self.look_up_counts(&tracked, upper, wanted, visit);
                self.compute_counts(&other, upper, step, wanted, visit);
            }
        }
    }

    /// [`Forms::for_each_count`] for forms whose exclusions are tracked.
    #[inline(always)]
    fn look_up_counts(
        &self,
        run: &Run,
        upper: bool,
        wanted: &Set,
        visit: &mut dyn FnMut(Side, u32),
    ) {
        let words = self.words();
        let planes = self.bits.get(usize::from(upper) * self.tracked..);
        let planes = planes.unwrap_or(&[]);
        for (form, column) in run.forms.clone().zip(run.columns.clone()) {
            let own = planes.iter().skip(form).step_by((2 * self.tracked).max(1));
            let own = own.zip(wanted).take(words);
            let count = own.map(|(word, wanted)| (word & wanted).count_ones()).sum();
            if count > 0 {
                visit(run.side(form, column, upper), count);
            }
        }
    }

    /// [`Forms::for_each_count`] for forms of which nothing is tracked.
    fn compute_counts(
        &self,
        run: &Run,
        upper: bool,
        step: usize,
        wanted: &Set,
        visit: &mut dyn FnMut(Side, u32),
    ) {
        let known = self.known();
        let feasible = self.feasible(step);
        let mut sides = run.forms.clone().zip(run.columns.clone());
        for start in run.columns.clone().step_by(BLOCK) {
            let columns = start..run.columns.end.min(start + BLOCK);
            let mut ends = [if upper { -R::INFINITY } else { R::INFINITY }; BLOCK];
            for sample in members(&feasible) {
                for (end, value) in ends
                    .iter_mut()
                    .zip(known.values(run.left, &columns, sample))
                {
                    *end = if upper {
                        end.max(value)
                    } else {
                        end.min(value)
                    };
                }
            }
            let mut counts = [0; BLOCK];
            for sample in members(wanted) {
                let values = known.values(run.left, &columns, sample);
                for ((count, end), value) in counts.iter_mut().zip(&ends).zip(values) {
                    *count += u32::from(excludes(*end, value, upper));
                }
            }
            for (count, (form, column)) in
                counts.into_iter().zip(sides.by_ref().take(columns.len()))
            {
                if count > 0 {
                    visit(run.side(form, column, upper), count);
                }
            }
        }
    }

    /// The end of S: the value farthest out at a feasible sample of a step.
    pub(in crate::learn::version_space) fn last_feasible(&self, side: &Side, step: usize) -> R {
        let form = side.form as usize;
        if form >= self.tracked {
            let feasible = self.feasible(step);
            let values = members(&feasible).map(|sample| self.value_at(side, sample));
            return values.fold(-R::INFINITY, R::max);
        }
        let own = self.spans.get(step * self.tracked + form);
        let span = own.copied().unwrap_or_else(Span::default);
        if side.upper { span.high } else { -span.low }
    }

    /// The infeasible samples of a step that a form excludes.
    pub(in crate::learn::version_space) fn excluded(&self, side: &Side, step: usize) -> Set {
        let mut set = self.infeasible(step);
        let form = side.form as usize;
        if form >= self.tracked {
            let end = side.outward(self.last_feasible(side, step));
            let all = core::mem::take(&mut set);
            for sample in members(&all) {
                let value = side.outward(self.value_at(side, sample));
                if excludes(end, value, side.upper) {
                    insert(&mut set, sample);
                }
            }
            return set;
        }
        let planes = self
            .bits
            .get(usize::from(side.upper) * self.tracked + form..);
        let words = planes
            .unwrap_or(&[])
            .iter()
            .step_by((2 * self.tracked).max(1));
        for (slot, word) in set.iter_mut().zip(words).take(self.words()) {
            *slot &= word;
        }
        set
    }
}
