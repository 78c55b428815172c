//! Numeric bounds on left sides, and dominance between them.

use crate::domain::NodeId;
use crate::grammar::{Comparison, Features, Hypotheses, Run, bit, feature_id};
use crate::real::Real;
use crate::table::Blank;

/// The tightest numeric bound on a left side from one direction, and the
/// hypothesis it came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bound<R> {
    pub(super) value: R,
    pub(super) comparison: Comparison,
    /// Its right side among the features.
    pub(super) rhs: NodeId,
}

/// The bounds on a left side: `[from above, from below]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds<R> {
    recorded: [Option<Bound<R>>; 2],
    candidate: [Option<Bound<R>>; 2],
}

impl<R> Blank for Bounds<R> {
    const BLANK: Self = Bounds {
        recorded: [None, None],
        candidate: [None, None],
    };
}

impl<R: Real> Bound<R> {
    /// Dominance (Eq. 4.12) between bounds from one direction.
    fn dominates(&self, other: &Bound<R>) -> bool {
        let tighter = if self.comparison.is_upper() {
            self.value < other.value
        } else {
            self.value > other.value
        };
        let stricter = !self.comparison.admits_equal() && other.comparison.admits_equal();
        tighter || (self.value == other.value && stricter)
    }

    fn is_from(&self, other: &Bound<R>) -> bool {
        self.rhs == other.rhs && self.comparison == other.comparison
    }
}

fn direction(comparison: Comparison) -> usize {
    usize::from(!comparison.is_upper())
}

/// The bounds of every left side, by its index among the features.
#[derive(Debug)]
pub(super) struct BoundTable<'m, R> {
    lhs: &'m mut [Bounds<R>],
}

impl<'m, R: Real> BoundTable<'m, R> {
    /// An empty table in borrowed memory.
    pub(super) fn new(lhs: &'m mut [Bounds<R>]) -> Self {
        BoundTable { lhs }
    }

    /// Forgets all bounds.
    pub(super) fn clear(&mut self) {
        self.lhs.fill(Bounds::BLANK);
    }

    /// The bounds, simple left sides first; but for those that a value made which was too
    /// large for a number.
    pub(super) fn iter(&self) -> impl Iterator<Item = (NodeId, Bound<R>)> + '_ {
        let lhs = self.lhs.iter().enumerate();
        lhs.flat_map(|(lhs, bounds)| {
            let recorded = bounds.recorded.into_iter().flatten();
            let finite = recorded.filter(|bound| bound.value.is_finite());
            finite.map(move |bound| (feature_id(lhs), bound))
        })
    }

    /// Brings the bounds up to date with the hypotheses that are left.
    pub(super) fn tighten(
        &mut self,
        hypotheses: &mut Hypotheses<'_>,
        features: &Features<'_, R>,
        feasible: bool,
    ) {
        for bounds in self.lhs.iter_mut() {
            bounds.candidate = [None, None];
        }
        let values = features.values();
        let bounds = &mut *self.lhs;
        hypotheses.for_each_run(features, |run, pairs| {
            for_each_bound(run, pairs, values, |bound, _| {
                let side = side_of(bounds, run.lhs, bound.comparison, |b| &mut b.candidate);
                if let Some(best) = side
                    && best.as_ref().is_none_or(|best| bound.dominates(best))
                {
                    *best = Some(bound);
                }
            });
        });
        for bounds in self.lhs.iter_mut() {
            let sides = bounds.recorded.iter_mut().zip(bounds.candidate);
            for (recorded, candidate) in sides {
                *recorded = match (candidate, *recorded) {
                    (Some(new), Some(old)) if old.is_from(&new) && !new.dominates(&old) => {
                        Some(old)
                    }
                    (Some(new), _) if feasible => Some(new),
                    (Some(_), old) => old,
                    (None, _) => None,
                };
            }
        }
        if feasible {
            self.remove_dominated(hypotheses, features);
        }
    }

    fn remove_dominated(&mut self, hypotheses: &mut Hypotheses<'_>, features: &Features<'_, R>) {
        let values = features.values();
        let bounds = &mut *self.lhs;
        hypotheses.for_each_run(features, |run, pairs| {
            for_each_bound(run, pairs, values, |bound, pair| {
                let side = side_of(bounds, run.lhs, bound.comparison, |b| &mut b.recorded);
                let best = side.and_then(|best| *best);
                if !best.is_some_and(|best| best.is_from(&bound)) {
                    *pair &= !bit(bound.comparison);
                }
            });
        });
    }
}

/// Calls `visit` with every hypothesis of a run as the bound it sets at the
/// present values, and its pair.
fn for_each_bound<R: Real>(
    run: &Run,
    pairs: &mut [u8],
    values: &[R],
    mut visit: impl FnMut(Bound<R>, &mut u8),
) {
    let rhs = run.rhs.clone().zip(values.iter().skip(run.rhs.start));
    for ((rhs, value), pair) in rhs.zip(pairs) {
        if *pair == 0 {
            continue;
        }
        for comparison in Comparison::ALL {
            if *pair & bit(comparison) != 0 {
                let bound = Bound {
                    value: *value,
                    comparison,
                    rhs: feature_id(rhs),
                };
                visit(bound, pair);
            }
        }
    }
}

fn side_of<R>(
    bounds: &mut [Bounds<R>],
    lhs: usize,
    comparison: Comparison,
    sides: fn(&mut Bounds<R>) -> &mut [Option<Bound<R>>; 2],
) -> Option<&mut Option<Bound<R>>> {
    sides(bounds.get_mut(lhs)?).get_mut(direction(comparison))
}
