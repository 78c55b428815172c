//! What can be said of the controllers, for learning when they work.

use super::{Coffee, PICK_JUG, TWIST_JUG};
use crate::skill::{Describe, Description};

static DESCRIPTIONS: [Description; 2] = [
    Description::alone(PICK_JUG, include_str!("skills/pick.txt")),
    Description::chained(
        TWIST_JUG,
        PICK_JUG,
        include_str!("skills/twist_to_pick.txt"),
    ),
];

impl Describe for Coffee {
    const DESCRIPTIONS: &'static [Description] = &DESCRIPTIONS;
}
