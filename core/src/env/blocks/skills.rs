//! What can be said of the controllers, for learning when they work.

use super::{Blocks, PUT_ON_TABLE};
use crate::skill::{Describe, Description};

static DESCRIPTIONS: [Description; 1] = [Description::alone(
    PUT_ON_TABLE,
    include_str!("skills/put_on_table.txt"),
)];

impl Describe for Blocks {
    const DESCRIPTIONS: &'static [Description] = &DESCRIPTIONS;
}
