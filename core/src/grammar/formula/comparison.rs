//! How the two sides of a constraint are compared.

/// The four inequality symbols of the grammar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>=`
    GreaterEqual,
    /// `>`
    Greater,
}

impl Comparison {
    /// All of them, in the order in which hypotheses are enumerated.
    pub const ALL: [Comparison; 4] = [
        Comparison::Less,
        Comparison::LessEqual,
        Comparison::GreaterEqual,
        Comparison::Greater,
    ];

    /// Its symbol.
    pub const fn symbol(self) -> &'static str {
        match self {
            Comparison::Less => "<",
            Comparison::LessEqual => "<=",
            Comparison::GreaterEqual => ">=",
            Comparison::Greater => ">",
        }
    }

    /// The same of the two sides swapped.
    pub const fn mirrored(self) -> Comparison {
        match self {
            Comparison::Less => Comparison::Greater,
            Comparison::LessEqual => Comparison::GreaterEqual,
            Comparison::GreaterEqual => Comparison::LessEqual,
            Comparison::Greater => Comparison::Less,
        }
    }

    /// Whether it bounds its left side from above.
    pub const fn is_upper(self) -> bool {
        matches!(self, Comparison::Less | Comparison::LessEqual)
    }

    /// Whether equality satisfies it.
    pub const fn admits_equal(self) -> bool {
        matches!(self, Comparison::LessEqual | Comparison::GreaterEqual)
    }

    /// Whether `left self right` holds; false for NaN.
    pub fn holds<T: PartialOrd>(self, left: &T, right: &T) -> bool {
        match self {
            Comparison::Less => left < right,
            Comparison::LessEqual => left <= right,
            Comparison::GreaterEqual => left >= right,
            Comparison::Greater => left > right,
        }
    }
}
