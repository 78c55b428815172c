//! Advice to the search.

use super::skeleton::Skeleton;

/// Why something was advised against or has no parameters. Whoever gives advice
/// owns the numbers and knows their text; the planner counts them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ReasonId(pub u16);

/// What to do with a prefix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Advice {
    /// Go on with it.
    Keep,
    /// Leave it out, with everything that begins with it, until
    /// [`Config::patience`](super::Config::patience) ends. The right advice from
    /// knowledge that may be wrong.
    Postpone(ReasonId),
    /// Drop it, with everything that begins with it. For knowledge that is
    /// certain: a plan may be lost.
    Prune(ReasonId),
}

/// Judges sequences of operators before anything is sampled for them.
pub trait Guide<const N: usize = 2> {
    /// What to do with a sequence of operators. It is asked when the search comes
    /// to it, to extend it or, if it reaches the goal, to refine it: most sequences
    /// that are created never come that far, and need no advice. All shorter
    /// prefixes were kept.
    fn judge(&mut self, prefix: Skeleton<'_, N>) -> Advice;
}

/// Keeps everything.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unguided;

impl<const N: usize> Guide<N> for Unguided {
    fn judge(&mut self, _: Skeleton<'_, N>) -> Advice {
        Advice::Keep
    }
}
