//! What sums, products and quotients measure, where there is a word for it.

use crate::domain::Dimension;

/// What an expression measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unit {
    /// Whatever is wanted: it is a literal.
    Any,
    /// There is no word for it, as for a volume: it fits everything, and what is made of it
    /// has no word either.
    Wordless,
    /// What a word says.
    Of(Dimension),
}

impl Unit {
    /// The word, if there is one.
    pub(super) fn dimension(self) -> Option<Dimension> {
        match self {
            Unit::Of(dimension) => Some(dimension),
            Unit::Any | Unit::Wordless => None,
        }
    }

    /// Of a sum or a difference.
    pub(super) fn plus(self, other: Unit) -> Unit {
        match (self, other) {
            (Unit::Of(_), _) | (Unit::Wordless, Unit::Any) => self,
            (Unit::Any | Unit::Wordless, _) => other,
        }
    }

    /// Of a product. Literals scale, and plain numbers and flags do.
    pub(super) fn times(self, other: Unit) -> Unit {
        let (a, b) = match (self, other) {
            (Unit::Any, unit) | (unit, Unit::Any) => return unit,
            (Unit::Wordless, _) | (_, Unit::Wordless) => return Unit::Wordless,
            (Unit::Of(a), Unit::Of(b)) => (counted(a), counted(b)),
        };
        match (a, b) {
            (Dimension::None, own) | (own, Dimension::None) => Unit::Of(own),
            (Dimension::Length, Dimension::Length) => Unit::Of(Dimension::Area),
            // An arc, and a sector of a circle: angles are in radians.
            (Dimension::Angle, own @ (Dimension::Length | Dimension::Area))
            | (own @ (Dimension::Length | Dimension::Area), Dimension::Angle) => Unit::Of(own),
            _ => Unit::Wordless,
        }
    }

    /// Of a quotient.
    pub(super) fn over(self, other: Unit) -> Unit {
        let (own, other) = match (self, other) {
            (unit, Unit::Any) => return unit,
            (Unit::Any, Unit::Of(Dimension::None | Dimension::Flag)) => return Unit::Any,
            (Unit::Of(a), Unit::Of(b)) => (counted(a), counted(b)),
            (Unit::Wordless, _) | (Unit::Any | Unit::Of(_), _) => return Unit::Wordless,
        };
        match (own, other) {
            (own, Dimension::None) => Unit::Of(own),
            (Dimension::Area, Dimension::Length) => Unit::Of(Dimension::Length),
            (own, other) if own == other => Unit::Of(Dimension::None),
            _ => Unit::Wordless,
        }
    }
}

/// A flag counts as one or zero in a product.
fn counted(dimension: Dimension) -> Dimension {
    match dimension {
        Dimension::Flag => Dimension::None,
        Dimension::None | Dimension::Length | Dimension::Angle | Dimension::Area => dimension,
    }
}

#[cfg(test)]
mod tests {
    use crate::domain::{Dimension, Domain, Node};
    use crate::error::Error;
    use crate::text::Lexer;
    use heapless::Vec;
    use std::format;

    const DOMAIN: &str = "object part {
            wide: length, base: area, full: flag, stiffness: none, breaks: angle }
        parameter turn in [0, 25]: angle
        parameter level in [0, 1]: length
        feature volume = part.base*level
        feature slide = part.stiffness*part.stiffness/part.breaks: length";

    fn dimension(text: &str) -> Option<Dimension> {
        let domain = Domain::parse(DOMAIN).unwrap();
        let mut nodes: Vec<Node, 16> = Vec::new();
        let id = domain
            .parse_expression(&mut Lexer::new(text), &mut nodes)
            .expect(text);
        domain.dimension(&nodes, id)
    }

    #[test]
    fn products_and_quotients_measure_what_there_is_a_word_for() {
        use Dimension::{Angle, Area, Flag, Length, None as Plain};
        for (text, measured) in [
            ("2*part.wide", Some(Length)),
            ("part.wide*level", Some(Area)),
            ("turn*part.wide", Some(Length)),
            ("part.wide*turn", Some(Length)),
            ("0.5*part.wide*part.wide*turn", Some(Area)),
            ("part.full*level", Some(Length)),
            ("part.full*part.stiffness", Some(Plain)),
            ("part.full*part.full", Some(Plain)),
            ("0.5*part.full", Some(Flag)),
            ("turn*part.stiffness", Some(Angle)),
            ("part.stiffness/part.full", Some(Plain)),
            ("part.base/level", Some(Length)),
            ("part.wide/level", Some(Plain)),
            ("slide", Some(Length)),
            // There is no word for these.
            ("level*level*level", None),
            ("part.base*level", None),
            ("turn*part.breaks", None),
            ("turn/level", None),
            ("1/level", None),
            // Nor for what is made of them.
            ("level*level*level*level", None),
            ("volume*part.stiffness", None),
            ("volume/level", None),
            ("1/level*level", None),
            ("2 + volume", None),
            // But what they are added to has one.
            ("volume + level", Some(Length)),
            ("level - volume", Some(Length)),
        ] {
            assert_eq!(dimension(text), measured, "{text}");
        }
    }

    #[test]
    fn what_has_no_word_fits_every_number_and_what_has_one_does_not() {
        let domain = Domain::parse(DOMAIN).unwrap();
        let read = |text: &str| crate::grammar::Formula::parse(&domain, text);
        for right in [
            "1",
            "part.wide",
            "part.base",
            "part.stiffness",
            "part.breaks",
        ] {
            let text = format!("level*part.base <= {right}");
            assert!(read(&text).is_ok(), "{text}");
        }
        assert!(read("turn*part.wide - level >= 0").is_ok());
        for text in ["turn*part.wide <= turn", "part.full*level <= part.full"] {
            assert!(matches!(read(text), Err(Error::Syntax(_))), "{text}");
        }
    }
}
