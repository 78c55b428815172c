//! Forms whose right side is a sum of scaled features: `left - (a + 0.5 * b - c)`.
//!
//! There are too many of them to keep. Where the simple forms explain the answers at
//! length or not at all, a search (see [`search`](super::search)) goes through them
//! and keeps those that explain most for their length, in a small table. From then on they
//! are forms like all others.

use super::offers::BestSums;
use super::{DirectedForm, Forms, NOTHING, Values};
use crate::domain::{Node, NodeId, TermError, copy, intern};
use crate::real::Real;
use crate::table::Blank;
use heapless::VecView;

/// Most terms on the right: a place and three sizes.
pub(super) const TERMS: usize = 4;

/// A level of right sides behind all others.
pub(in super::super) const SUM_LEVEL: u8 = super::LEVELS as u8;

/// A right side, by its column among the values of right sides, times a factor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Term {
    pub(super) column: u16,
    /// The factor times one hundred; zero for no term.
    pub(super) hundredths: i16,
}

impl Term {
    pub(super) const NONE: Term = Term {
        column: NOTHING,
        hundredths: 0,
    };

    pub(super) fn is_some(&self) -> bool {
        self.hundredths != 0
    }

    pub(super) fn factor(self) -> f64 {
        f64::from(self.hundredths) / 100.0
    }
}

/// A form with a sum on the right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum {
    pub(super) terms: [Term; TERMS],
    /// What it takes to name it and a direction, in bits.
    pub(super) length: f32,
    /// How much it explained for its length when it was found.
    pub(super) worth: f32,
    pub(super) lhs: u8,
    /// Whether it is kept: whether there is something in this slot.
    pub(super) kept: bool,
    /// Whether a hypothesis speaks of what is in this slot.
    pub(super) used: bool,
    /// Whether it was not evaluated yet.
    pub(super) new: bool,
}

impl Sum {
    /// The left side alone.
    pub(super) fn alone(lhs: u8, length: f32) -> Sum {
        Sum {
            lhs,
            length,
            kept: true,
            new: true,
            ..Sum::BLANK
        }
    }

    /// Whether it says the same as another.
    pub(super) fn is_same(&self, other: &Sum) -> bool {
        self.lhs == other.lhs && self.terms == other.terms
    }
}

impl Blank for Sum {
    const BLANK: Self = Sum {
        terms: [Term::NONE; TERMS],
        length: 0.0,
        worth: 0.0,
        lhs: 0,
        kept: false,
        used: false,
        new: false,
    };
}

/// The sums that are kept, and their values.
#[derive(Debug)]
pub(super) struct Sums<'m, R> {
    pub(super) slots: &'m mut [Sum],
    /// For each slot, the right side in each instance.
    pub(super) values: &'m mut [R],
    pub(super) instances: usize,
    /// Forms of all slots stand behind so many others.
    pub(super) first: usize,
    /// The best ones of the side that is searched.
    pub(super) best: BestSums,
}

impl<R: Real> Sums<'_, R> {
    pub(super) fn capacity(&self) -> usize {
        self.slots.len()
    }

    /// The right side of a sum in an instance.
    #[inline(always)]
    pub(super) fn value(&self, slot: usize, instance: usize) -> Option<R> {
        self.values.get(slot * self.instances + instance).copied()
    }

    /// The right side of a sum in all instances.
    #[inline(always)]
    pub(super) fn in_slot(&self, slot: usize) -> &[R] {
        let start = slot * self.instances;
        self.values
            .get(start..start + self.instances)
            .unwrap_or(&[])
    }

    /// The sums that are kept, from one direction.
    pub(super) fn directed(&self, upper: bool) -> impl Iterator<Item = DirectedForm> {
        (0..self.slots.len()).filter_map(move |slot| self.form_in(slot, upper))
    }

    /// The form in a slot from one direction; if there is one.
    pub(super) fn form_in(&self, slot: usize, upper: bool) -> Option<DirectedForm> {
        let sum = self.slots.get(slot).filter(|sum| sum.kept)?;
        Some(DirectedForm {
            rhs: slot as u16,
            lhs: sum.lhs,
            level: SUM_LEVEL,
            ..DirectedForm::new(self.first + slot, upper)
        })
    }

    /// Whether what is in a slot was not evaluated yet.
    pub(super) fn is_new(&self, slot: usize) -> bool {
        self.slots.get(slot).is_some_and(|sum| sum.new)
    }

    /// Evaluates the right side of a slot in all instances.
    pub(super) fn evaluate(&mut self, slot: usize, values: &Values<'_, R>) {
        let Some(sum) = self.slots.get_mut(slot) else {
            return;
        };
        sum.new = false;
        let right_side = RightSide::of(&sum.terms, true);
        let own = self.values.chunks_exact_mut(self.instances.max(1));
        for (instance, value) in own.into_iter().nth(slot).into_iter().flatten().enumerate() {
            *value = right_side.value(values.rhs_in(instance));
        }
    }
}

/// A right side from one direction, with its factors at hand.
pub(super) struct RightSide<R> {
    terms: [(usize, R); TERMS],
}

impl<R: Real> RightSide<R> {
    pub(super) fn of(terms: &[Term; TERMS], upper: bool) -> Self {
        let sign = if upper { 1.0 } else { -1.0 };
        let terms = terms.map(|term| {
            let factor = R::from_f64(sign * term.factor());
            // No term is any column, and none of it.
            let column = if term.is_some() { term.column } else { 0 };
            (usize::from(column), factor)
        });
        RightSide { terms }
    }

    /// The value where those of all columns are in a row; they are finite.
    #[inline(always)]
    pub(super) fn value(&self, row: &[R]) -> R {
        let terms = self.terms.iter();
        terms.fold(R::ZERO, |sum, (column, factor)| {
            sum + row.get(*column).copied().unwrap_or(R::ZERO) * *factor
        })
    }
}

impl<R: Real> Forms<'_, R> {
    /// The sum that is the right side of a form, if it is one.
    pub(super) fn sum(&self, form: &DirectedForm) -> Option<&Sum> {
        let slot = (form.level == SUM_LEVEL).then_some(usize::from(form.rhs))?;
        self.sums.slots.get(slot)
    }

    /// Writes what a form compares with its threshold: its left side minus its right side.
    ///
    /// # Errors
    /// [`TermError`].
    pub(in super::super) fn write(
        &self,
        form: &DirectedForm,
        nodes: &mut VecView<Node>,
    ) -> Result<NodeId, TermError> {
        let known = self.features.nodes();
        let mut written = copy(known, self.left_term(form), nodes)?;
        let Some(sum) = self.sum(form) else {
            return match self.right_term(form) {
                None => Ok(written),
                Some(right) => {
                    let right = copy(known, right, nodes)?;
                    intern(nodes, Node::Difference(written, right))
                }
            };
        };
        for term in sum.terms.iter().filter(|term| term.is_some()) {
            let feature = self.rhs_features.as_slice().get(usize::from(term.column));
            let feature = NodeId(feature.copied().ok_or(TermError::Missing)?);
            let mut right = copy(known, feature, nodes)?;
            let factor = term.factor().abs();
            if factor != 1.0 {
                let factor = intern(nodes, Node::Number(factor))?;
                right = intern(nodes, Node::Product(factor, right))?;
            }
            let node = if term.hundredths > 0 {
                Node::Difference(written, right)
            } else {
                Node::Sum(written, right)
            };
            written = intern(nodes, node)?;
        }
        Ok(written)
    }
}
