//! Makes inputs from others.

use critreg::random::{Generator, uniform};
use rand_core::Rng;

/// Words of the languages that are read, numbers at which something may change, and bytes.
const WORDS: [&str; 48] = [
    "and",
    "or",
    "not",
    "true",
    "min",
    "max",
    "dist",
    "angle",
    "clear",
    "inside",
    "over",
    "off",
    "line",
    "sweep",
    "turned",
    "centred",
    "rounded",
    "world",
    "object",
    "parameter",
    "constant",
    "point",
    "shape",
    "circle",
    "rectangle",
    "(",
    ")",
    "<=",
    ">=",
    "[6]",
    "0",
    "1e308",
    "1e-308",
    "4294967296",
    "0.5",
    "-1",
    "(:action",
    "(forall (?x)",
    "(exists (?x)",
    "(when",
    "(imply",
    "(and",
    "(or",
    "(not",
    "(=",
    "?x",
    ":parameters",
    "#",
];

/// Changes inputs at random.
pub(crate) struct Mutator {
    rng: Generator,
}

impl Mutator {
    pub(crate) fn new(rng: Generator) -> Self {
        Mutator { rng }
    }

    fn below(&mut self, count: usize) -> usize {
        ((uniform(&mut self.rng) * count as f64) as usize).min(count.saturating_sub(1))
    }

    /// A place in an input, and one a little behind it.
    fn span(&mut self, length: usize) -> (usize, usize) {
        let start = self.below(length + 1);
        let longest = (length - start).min(if self.below(4) == 0 { 200 } else { 12 });
        (start, start + self.below(longest + 1))
    }

    /// One of these inputs, changed a few times.
    pub(crate) fn mutated(&mut self, inputs: &[Vec<u8>]) -> Vec<u8> {
        let mut input = inputs[self.below(inputs.len())].clone();
        for _ in 0..=self.below(6) {
            let (start, end) = self.span(input.len());
            let replacement = match self.below(7) {
                0 => vec![],
                1 => vec![self.rng.next_u32() as u8],
                2 => WORDS[self.below(WORDS.len())].as_bytes().to_vec(),
                3 => input[start..end].repeat(1 + self.below(12)),
                4 => {
                    let other = &inputs[self.below(inputs.len())];
                    let (from, to) = self.span(other.len());
                    other[from..to].to_vec()
                }
                5 => format!(" {} ", WORDS[self.below(WORDS.len())]).into_bytes(),
                _ => {
                    let mut own = input[start..end].to_vec();
                    if let Some(byte) = own.first_mut() {
                        *byte ^= 1 << self.below(8);
                    }
                    own
                }
            };
            input.splice(start..end, replacement);
            input.truncate(6000);
        }
        input
    }
}
