//! How good a learned region is and why there is none, for C.

use crate::region::quality::{
    CRITREG_APPROXIMATE, CRITREG_EXACT, CRITREG_NO_QUALITY, CRITREG_PROVISIONAL,
};
use core::fmt;
use critreg_core::domain::{Domain, NodeId};
use critreg_core::learn::version_space::{LeftOut, Quality, Why};

/// There is an exact region.
pub const CRITREG_WHY_EXPLAINED: u32 = 0;
/// Nothing was told yet.
pub const CRITREG_WHY_NOTHING_TOLD: u32 = 1;
/// No sample worked. A smaller range of the parameters helps.
pub const CRITREG_WHY_NONE_WORKED: u32 = 2;
/// All samples worked: the region is everything.
pub const CRITREG_WHY_ALL_WORKED: u32 = 3;
/// In no instance did some samples work and others not.
pub const CRITREG_WHY_NO_INFLUENCE: u32 = 4;
/// There are too few answers for the smallest explanation.
pub const CRITREG_WHY_TOO_FEW: u32 = 5;
/// Answers at one and the same place contradict each other.
pub const CRITREG_WHY_CONTRADICTION: u32 = 6;
/// Nothing that the domain text can say explains some of the samples.
pub const CRITREG_WHY_UNEXPLAINED: u32 = 7;

/// Bytes that are enough for the words of critreg_learner_why(), with their NUL.
pub const CRITREG_WHY_MAX: usize = 384;

/// The longest name of something that found no room; a longer one is not told.
const MAX_NAME: usize = 96;

/// The number of a quality.
pub(crate) const fn number(quality: Quality) -> u32 {
    match quality {
        Quality::None => CRITREG_NO_QUALITY,
        Quality::Provisional => CRITREG_PROVISIONAL,
        Quality::Approximate => CRITREG_APPROXIMATE,
        Quality::Exact => CRITREG_EXACT,
    }
}

/// The code of a reason.
pub(crate) const fn code(why: &Why) -> u32 {
    match why {
        Why::Explained => CRITREG_WHY_EXPLAINED,
        Why::NothingTold => CRITREG_WHY_NOTHING_TOLD,
        Why::NoneWorked => CRITREG_WHY_NONE_WORKED,
        Why::AllWorked => CRITREG_WHY_ALL_WORKED,
        Why::NoInfluence => CRITREG_WHY_NO_INFLUENCE,
        Why::TooFew { .. } => CRITREG_WHY_TOO_FEW,
        Why::Contradiction { .. } => CRITREG_WHY_CONTRADICTION,
        Why::Unexplained { .. } => CRITREG_WHY_UNEXPLAINED,
    }
}

/// Why there is no region, or none that is exact, with what was not compared.
pub(crate) struct Words<'d, 't> {
    pub(crate) why: Why,
    pub(crate) left_out: Option<LeftOut>,
    pub(crate) domain: &'d Domain<'t>,
}

impl fmt::Display for Words<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.why.fmt(f)?;
        let missed = matches!(self.why, Why::TooFew { .. } | Why::Unexplained { .. });
        let Some(left_out) = self.left_out.filter(|_| missed) else {
            return Ok(());
        };
        let mut name: heapless::String<MAX_NAME> = heapless::String::new();
        let first = left_out.first.and_then(|first| {
            let written = self.domain.write_expression(&mut name, &[first], NodeId(0));
            written.ok()
        });
        let count = left_out.count;
        write!(
            f,
            " (of what could be compared, {count} things found no room"
        )?;
        if first.is_some() {
            write!(f, ", the first is {name}")?;
        }
        f.write_str(
            ": lend memory for more forms, or let the text say less by `shape X = none` for points \
             that others are placed in, relate or compare, or name a feature)",
        )
    }
}
