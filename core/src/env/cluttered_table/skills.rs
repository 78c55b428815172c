//! What can be said of the controllers, for learning when they work.

use super::{ClutteredTable, ClutteredTablePlace, DUMP, GRASP, PLACE, UNTRASHED};
use crate::skill::{Describe, Description};

/// The end of an approach is left to the original sampler, which takes the can's centre.
const GRASPING: Description =
    Description::alone(GRASP, include_str!("skills/grasp.txt")).with_members(&[UNTRASHED]);

static WITH_DUMP: [Description; 2] = [
    GRASPING,
    Description::alone(DUMP, include_str!("skills/dump.txt")),
];

static WITH_PLACE: [Description; 2] = [
    GRASPING,
    Description::alone(PLACE, include_str!("skills/place.txt")).with_members(&[UNTRASHED]),
];

impl Describe for ClutteredTable {
    const DESCRIPTIONS: &'static [Description] = &WITH_DUMP;
}

impl Describe for ClutteredTablePlace {
    const DESCRIPTIONS: &'static [Description] = &WITH_PLACE;
}
