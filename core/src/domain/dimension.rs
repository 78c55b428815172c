//! Dimensions: only quantities of one kind are compared.

/// What a number measures. Only quantities of one dimension are added or
/// compared, which alone removes most nonsense hypotheses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Dimension {
    /// Whatever there is no other word for: a plain ratio, such as a position along an object
    /// in `[0, 1]`, a mass, a speed, a force, a volume.
    None,
    /// True above 0.5, false otherwise.
    Flag,
    /// A length; one unit for the whole domain.
    Length,
    /// An angle in radians, so that times a length it is a length; differences are taken on
    /// the circle.
    Angle,
    /// A product of two lengths.
    Area,
}

impl Dimension {
    /// Every dimension, in the order of the enumeration.
    pub const ALL: [Dimension; 5] = [
        Dimension::None,
        Dimension::Flag,
        Dimension::Length,
        Dimension::Angle,
        Dimension::Area,
    ];

    /// The word for it in the domain text.
    pub const fn name(self) -> &'static str {
        match self {
            Dimension::None => "none",
            Dimension::Flag => "flag",
            Dimension::Length => "length",
            Dimension::Angle => "angle",
            Dimension::Area => "area",
        }
    }

    /// The dimension with this word.
    pub fn from_name(name: &str) -> Option<Dimension> {
        Dimension::ALL.into_iter().find(|d| d.name() == name)
    }
}
