//! The numbers that decide what is learned of skills and how it is used, in one place.
//!
//! They were chosen with `report -- domains` on learning seeds below 1000, which no published
//! figure uses. How flat each optimum is was measured with `report -- domains --seeds 10`,
//! whose seeds are others: 200 skills and 4800 plans. With the numbers as they are, 177
//! skills have a region, the means of precision and recall are 99.7 % and 99.6 %, and
//! planning begins anew, without advice, 3 times. Each number says what other values make
//! of that; differences of fewer than ten times are within chance.

/// Candidates to choose from, for each situation that is wanted. With 2, planning begins
/// anew 8 times; with 8, 5 times.
pub(super) const CANDIDATES: usize = 4;

/// The highest complexity of the features by which situations differ. With 1, planning
/// begins anew 5 times; with 3, 60 times, all in `cover_regrasp`.
pub(super) const COMPLEXITY: usize = 2;

/// How often situations are looked for in the same tasks: again with other parameters on
/// the way, as long as there are not enough. With 2 or 8 nothing differs; with 1, precision
/// and recall are 98.6 % and 98.4 %, and planning begins anew 57 times.
pub(super) const ROUNDS: u64 = 4;

/// The precision that a region wants that does not agree with all answers. It is advice: what is
/// drawn from it four times out of five works, where the original sampler may need a hundred
/// draws, and where it does not help, planning begins anew without it.
pub(super) const PRECISION_WANTED: f64 = 0.8;

/// Tries of a situation, with other draws of the parameters that are free, before its
/// answer is that it does not work. With 1, 176 skills have a region; with 4, 178.
pub(super) const TRIES: u32 = 2;

/// Runs of a controller after which an attribute that always had one value afterwards is
/// expected to have it again. With 2 or 6 nothing differs: most controllers run far more
/// often, and the others are not to be trusted.
pub(super) const CONSTANT_RUNS: u32 = 3;

/// Runs of a controller that have to agree about where it leaves an object.
pub(super) const EFFECT_RUNS: usize = 4;

/// The share of the runs that has to agree: a few end elsewhere, as the way was blocked.
pub(super) const AGREEING: f64 = 0.7;

/// How far runs that agree may be apart, as a share of one more than the value: simulators
/// compute in single precision, and drive in steps.
pub(super) const EFFECT_TOLERANCE: f64 = 1e-3;

/// The share of an interval that the first draw of a step leaves out at both ends. With
/// none, planning begins anew 8 times; with 0.05, 4 times; with 0.2, 8 times.
pub(super) const MARGIN: f64 = 0.1;

/// Draws of a step from regions. If none of them works, it is not the parameters that are
/// wrong. With 1, planning begins anew 11 times; with 6 it does so 3 times, but takes 13 %
/// more samples.
pub(super) const REGION_DRAWS: u32 = 3;

/// Draws with which the steps after a step can work, of which the one is taken that keeps
/// farthest from where they could not. In KinDER's StickButton2D it halves what is drawn in vain.
pub(super) const FORESEEN_DRAWS: u32 = 8;
