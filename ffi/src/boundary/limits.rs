//! The numbers of the header: how much there is at most, and what the macros reckon with
//! that size static arrays. The layouts assert that they are enough.

use critreg_core::domain::MAX_PARAMETERS;
use critreg_core::grammar::MAX_CONSTRAINTS;
use critreg_core::learn::Trial;
use critreg_core::region::MAX_INTERVALS;

/// Longest domain text in bytes, with its NUL.
pub const CRITREG_DOMAIN_TEXT_MAX: usize = 2048;

/// Bytes of a learner that do not depend on its capacity, on a machine with
/// pointers of 32 bits; for CRITREG_LEARNER_WORDS.
pub const CRITREG_LEARNER_FIXED_BYTES: usize = 23_600;

/// Bytes of a region, on a machine with pointers of 32 bits; for
/// CRITREG_REGION_WORDS.
pub const CRITREG_REGION_FIXED_BYTES: usize = 12_544;

/// Pointers in a handle, which take more room on a machine with longer ones; for
/// CRITREG_LEARNER_WORDS and CRITREG_REGION_WORDS.
pub const CRITREG_HANDLE_POINTERS: usize = 656;

/// Bytes of a sample that was told, apart from its left sides; for
/// CRITREG_LEARNER_WORDS.
pub const CRITREG_OBSERVATION_BYTES: usize = 76;

/// Bytes of a question that can be open, of which CRITREG_LEARNER_WORDS has
/// CRITREG_DEFAULT_QUESTIONS.
pub const CRITREG_QUESTION_BYTES: usize = 88;

/// Bytes of a feature, apart from its values in the instances; for
/// CRITREG_LEARNER_WORDS.
pub const CRITREG_FEATURE_BYTES: usize = 26;

/// Bytes of a form and step; for CRITREG_LEARNER_WORDS.
pub const CRITREG_SPAN_BYTES: usize = 16;

/// Bytes of a form with a sum, apart from its values in the instances; for
/// CRITREG_LEARNER_WORDS.
pub const CRITREG_SUM_BYTES: usize = 24;

/// Bytes of an instance, apart from values; for CRITREG_LEARNER_WORDS.
pub const CRITREG_INSTANCE_BYTES: usize = 16;

/// Bytes of a step; for CRITREG_LEARNER_WORDS.
pub const CRITREG_STEP_BYTES: usize = 5_888;

/// Bytes of a planner that do not depend on its capacity, apart from pointers; for
/// CRITREG_PLANNER_WORDS.
pub const CRITREG_PLANNER_FIXED_BYTES: usize = 31_648;

/// Pointers of a planner that do not depend on its capacity; for
/// CRITREG_PLANNER_WORDS.
pub const CRITREG_PLANNER_POINTERS: usize = 3_168;

/// Bytes of a planner for every word of sets beyond two; for CRITREG_PLANNER_WORDS_OF.
pub const CRITREG_PLANNER_WORD_BYTES: usize = 1_320;

/// Bytes of a ground operator; for CRITREG_PLANNER_WORDS.
pub const CRITREG_OPERATOR_BYTES: usize = 96;

/// Bytes of a node of the search; for CRITREG_PLANNER_WORDS.
pub const CRITREG_NODE_BYTES: usize = 46;

/// Bytes of an atom or number of :init; for CRITREG_PLANNER_WORDS.
pub const CRITREG_FACT_BYTES: usize = 20;

/// Bytes of a step of the longest plan, apart from its state and pointers; for
/// CRITREG_PLANNER_WORDS.
pub const CRITREG_PLAN_STEP_BYTES: usize = 136;

/// Pointers of a step of the longest plan; for CRITREG_PLANNER_WORDS.
pub const CRITREG_PLAN_STEP_POINTERS: usize = 13;

/// Bytes that are enough for the words of critreg_planner_reason_text(), with their NUL.
pub const CRITREG_REASON_MAX: usize = 1024;

/// Most parameters of an action: an array for theta of this length fits every
/// domain.
pub const CRITREG_MAX_PARAMETERS: usize = 6;

/// Most constraints of a region.
pub const CRITREG_MAX_CONSTRAINTS: usize = 32;

/// Most intervals that critreg_region_intervals() can find.
pub const CRITREG_MAX_INTERVALS: usize = 33;

const _: () = assert!(CRITREG_MAX_PARAMETERS == MAX_PARAMETERS);
const _: () = assert!(CRITREG_QUESTION_BYTES >= size_of::<Trial>());
const _: () = assert!(CRITREG_MAX_CONSTRAINTS == MAX_CONSTRAINTS);
const _: () = assert!(CRITREG_MAX_INTERVALS == MAX_INTERVALS);
