//! Plan skeletons.

use crate::task::GroundOperator;

/// Most operators in a plan skeleton.
pub const MAX_SKELETON: usize = 128;

/// A sequence of ground operators without their continuous parameters: a plan
/// skeleton, or a prefix of one.
#[derive(Clone, Copy, Debug)]
pub struct Skeleton<'s, const N: usize = 2> {
    operators: &'s [GroundOperator<N>],
    places: &'s [u16],
}

impl<'s, const N: usize> Skeleton<'s, N> {
    /// The operators of a task at these places.
    pub fn new(operators: &'s [GroundOperator<N>], places: &'s [u16]) -> Self {
        Skeleton { operators, places }
    }

    /// How many operators there are.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// The places of the operators among those of the task.
    pub fn places(&self) -> &'s [u16] {
        self.places
    }

    /// The operator of a step, from zero.
    pub fn get(&self, step: usize) -> Option<&'s GroundOperator<N>> {
        self.operators.get(usize::from(*self.places.get(step)?))
    }

    /// The operators in order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &'s GroundOperator<N>> + use<'s, N> {
        let operators = self.operators;
        let places = self.places.iter();
        places.filter_map(move |place| operators.get(usize::from(*place)))
    }

    /// The part before a step.
    #[must_use]
    pub fn until(&self, step: usize) -> Skeleton<'s, N> {
        Skeleton {
            operators: self.operators,
            places: self.places.get(..step).unwrap_or(self.places),
        }
    }

    /// The part from a step on; empty behind the last.
    #[must_use]
    pub fn from(&self, step: usize) -> Skeleton<'s, N> {
        Skeleton {
            operators: self.operators,
            places: self.places.get(step..).unwrap_or_default(),
        }
    }
}
