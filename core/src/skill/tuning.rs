//! Numbers that decide what is learned of skills and how it is used, each of them chosen
//! by trial.

/// Candidates to choose from, for each situation that is wanted.
pub(super) const CANDIDATES: usize = 4;

/// In features: the most complex ones that tell how much situations differ.
pub(super) const COMPLEXITY: usize = 2;

/// How often situations are looked for in the same tasks: again with other parameters on
/// the way, as long as there are not enough.
pub(super) const ROUNDS: u64 = 4;

/// Tries of a chain of operators, with other draws of the parameters that are free, before
/// its answer is that it does not work.
pub(super) const TRIES: u32 = 2;

/// Runs of a controller after which an attribute that always had one value afterwards is
/// expected to have it again.
pub(super) const CONSTANT_RUNS: u32 = 3;

/// The share of an interval that the first draw of a step leaves out at both ends.
pub(super) const MARGIN: f64 = 0.1;

/// Draws of a step from regions. If none of them works, it is not the parameters that are
/// wrong.
pub(super) const REGION_DRAWS: u32 = 3;
