//! What can be said of the controllers, for learning when they work.

use super::{Cover, CoverRegrasp, RegionalBumpyCover};
use crate::skill::{Describe, Description};

const PICK: &str = include_str!("skills/pick.txt");

static COVER: [Description; 4] = [
    Description::alone(Cover::PICK, PICK),
    Description::alone(Cover::PLACE, include_str!("skills/place_in_reach.txt")),
    Description::chained(
        Cover::PICK,
        Cover::PLACE,
        include_str!("skills/pick_place_in_reach.txt"),
    ),
    Description::chained(
        Cover::PLACE,
        Cover::PLACE,
        include_str!("skills/place_place.txt"),
    ),
];

/// Putting a block on the table is left to the original sampler, which puts it down where
/// it is.
static COVER_REGRASP: [Description; 3] = [
    Description::alone(CoverRegrasp::PICK, PICK),
    Description::alone(
        CoverRegrasp::PLACE,
        include_str!("skills/place_far_or_central.txt"),
    ),
    Description::chained(
        CoverRegrasp::PICK,
        CoverRegrasp::PLACE,
        include_str!("skills/pick_place_far_or_central.txt"),
    ),
];

/// Picking from a target is left to the original sampler, which draws just what works.
static REGIONAL_BUMPY_COVER: [Description; 4] = [
    Description::alone(RegionalBumpyCover::PICK_FROM_SMOOTH, PICK),
    Description::alone(
        RegionalBumpyCover::PICK_FROM_BUMPY,
        include_str!("skills/pick_from_bumpy.txt"),
    ),
    Description::alone(
        RegionalBumpyCover::PLACE_ON_TARGET,
        include_str!("skills/place_on_target.txt"),
    ),
    Description::alone(
        RegionalBumpyCover::PLACE_ON_BUMPY,
        include_str!("skills/place_on_bumpy.txt"),
    ),
];

impl Describe for Cover {
    const DESCRIPTIONS: &'static [Description] = &COVER;
}

impl Describe for CoverRegrasp {
    const DESCRIPTIONS: &'static [Description] = &COVER_REGRASP;
}

impl Describe for RegionalBumpyCover {
    const DESCRIPTIONS: &'static [Description] = &REGIONAL_BUMPY_COVER;
}
