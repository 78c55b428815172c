//! Samples whose label is decided.

use crate::table::Blank;

/// Where a sample comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Origin {
    /// It was asked about for a reason.
    Chosen,
    /// It was drawn at random, from everything or from a region, or nobody asked.
    Drawn,
    /// As before, and it is put aside to judge a region that is wrong about some answers.
    Aside,
}

/// A sample whose label is decided: its instance, and where it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample(u32);

impl Sample {
    /// The bits of its origin.
    const ORIGIN: u32 = 3 << 30;

    pub(super) fn new(instance: usize, origin: Origin) -> Sample {
        Sample((instance as u32 & !Sample::ORIGIN) | (origin as u32) << 30)
    }

    pub(super) fn instance(self) -> usize {
        (self.0 & !Sample::ORIGIN) as usize
    }

    pub(super) fn is(self, origin: Origin) -> bool {
        self.0 >> 30 == origin as u32
    }
}

impl Blank for Sample {
    const BLANK: Self = Sample(0);
}
