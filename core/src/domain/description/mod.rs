//! Reads the domain text; its grammar stands at the head of the parent module.

mod bodies;
mod features;
mod numbers;
mod objects;
mod parser;
mod places;

use super::schema::Domain;
use crate::error::Error;
use crate::text::{Failed, Lexer, Token};
use crate::wire::CHECKSUM;
use parser::DomainParser;

impl<'t> Domain<'t> {
    /// Reads a domain from its text; the grammar stands at the head of the
    /// [module](crate::domain#the-domain-text).
    ///
    /// ```
    /// use critreg::domain::Domain;
    /// let text = "object stick { x: length, y: length, theta: angle }
    ///     constant stick.width = 3.0: length
    ///     parameter mu in [0, 1]
    ///     point grasp = stick + (mu * stick.width, 0)";
    /// let domain = Domain::parse(text)?;
    /// assert_eq!(domain.instance_len(), 3);
    /// // The stick, and a point on it that moves with the parameter.
    /// let sampled: Vec<bool> = domain.points().iter().map(|point| point.sampled).collect();
    /// assert_eq!(sampled, [false, true]);
    ///
    /// let error = Domain::parse("parameter mu in [1, 0]").unwrap_err();
    /// let message = "line 1, column 21: the largest value must be above the smallest";
    /// assert_eq!(error.to_string(), message);
    /// # Ok::<(), critreg::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, also if the text ends without an attribute
    /// of an object and without a parameter, because there is nothing to learn then;
    /// [`Error::CapacityExceeded`] if there are more things than the `MAX_` constants of
    /// this module allow.
    pub fn parse(text: &'t str) -> Result<Domain<'t>, Error> {
        let mut domain = Domain::empty();
        domain.read(text)?;
        Ok(domain)
    }

    /// As [`Domain::parse`], but reads into an empty domain, in place: domains are large,
    /// and small machines have no stack for a second one.
    ///
    /// # Errors
    /// Those of [`Domain::parse`], and [`Error::OutOfSequence`] for a domain that is not
    /// empty. After an error the domain cannot be used.
    pub fn read(&mut self, text: &'t str) -> Result<(), Error> {
        if !self.text.is_empty() {
            return Err(Error::OutOfSequence("the domain was read already"));
        }
        self.text = text;
        self.fingerprint = CHECKSUM.checksum(text.as_bytes());
        let mut parser = DomainParser {
            domain: self,
            lexer: Lexer::new(text),
            own: None,
        };
        let read = parser.statements();
        parser.lexer.outcome(read)
    }
}

impl DomainParser<'_, '_> {
    /// Each statement has a function that is never inlined: the stack holds one at a time.
    fn statements(&mut self) -> Result<(), Failed> {
        while self.lexer.token() != Token::End {
            if self.lexer.accept("type") {
                self.type_statement()?;
            } else if self.lexer.accept("object") {
                self.object_statement()?;
            } else if self.lexer.accept("constant") {
                self.constant_statement()?;
            } else if self.lexer.accept("parameter") {
                self.parameter_statement()?;
            } else if self.lexer.accept("shape") {
                self.shape_statement()?;
            } else if self.lexer.accept("point") {
                self.point_statement()?;
            } else if self.lexer.accept("feature") {
                self.feature_statement()?;
            } else if self.lexer.accept("compare") {
                self.compare_statement()?;
            } else if self.lexer.accept("relate") {
                self.relate_statement()?;
            } else {
                return Err(self.lexer.fail(
                    "expected a statement: type, object, constant, parameter, shape, point, \
                     feature, compare or relate",
                ));
            }
        }
        if self.domain.instance_len() == 0 && self.domain.parameters.is_empty() {
            return Err(self
                .lexer
                .fail("expected an object with an attribute, or a parameter"));
        }
        self.domain.settle_places();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_say_where() {
        let cases = [
            ("object a { x: lenght }", 1, 15),
            ("object a { x: length,\n x: length }", 2, 2),
            ("parameter mu in [1, 0]", 1, 21),
            ("point p = nowhere", 1, 11),
            (
                "object a { x: length, y: length }\npoint p = a + (x, 0)",
                2,
                16,
            ),
            ("constant c = 1 + : none", 1, 18),
            ("constant c = 1: none constant c = 2: none", 1, 31),
            ("parameter mu in [0, 1] point p = world + (mu, 0)", 1, 43),
            (
                "object a { x: length, y: length, theta: angle }\npoint p = a + (1, 0)\npoint q = world turned p.theta",
                3,
                24,
            ),
            ("banana", 1, 1),
            // Nothing to learn about.
            ("", 1, 1),
            ("# nothing\n", 2, 1),
            ("type block { x: length } constant c = 1: length", 1, 48),
            ("object a { }", 1, 13),
        ];
        for (text, line, column) in cases {
            let Err(Error::Syntax(at)) = Domain::parse(text) else {
                panic!("accepted: {text}")
            };
            assert_eq!((at.line, at.column), (line, column), "{text}: {}", at.what);
        }
    }

    #[test]
    fn habits_of_other_languages_get_a_hint() {
        let with = |line: &str| std::format!("object a {{ x: length, y: length }}\n{line}");
        let cases = [
            ("constant c = 2 ^ 2: none", "there are no powers"),
            ("// a comment", "a comment begins with #"),
            ("parameter x in [0, 1];", "end without `;`"),
            ("shape a = box(1, 2, 3) centered", "the word is `centred`"),
            ("point p = a turned 2*pi", "turned (2*a)"),
            ("constant c = 5 deg: angle", "write 5*pi/180"),
            ("parameter p in [-90°, 90°]: angle", "write 5*pi/180"),
        ];
        for (line, hint) in cases {
            let Err(Error::Syntax(at)) = Domain::parse(&with(line)) else {
                panic!("accepted: {line}")
            };
            assert!(
                at.what.contains(hint) && at.line == 2,
                "{line}: {}",
                at.what
            );
        }
        assert!(Domain::parse(&with("point p = a turned (2*pi)")).is_ok());
    }

    #[test]
    fn a_heading_is_an_angle_of_what_has_a_place() {
        let turns = |attributes: &str| {
            let text = std::format!("object a {{ {attributes} }} parameter p in [0, 1]: length");
            let domain = Domain::parse(&text).unwrap();
            let last = domain.instance_len() as u8 - 1;
            assert_eq!(domain.has_headings(), domain.places(last), "{attributes}");
            domain.places(last)
        };
        for name in ["theta", "yaw", "pitch", "roll"] {
            assert!(turns(&std::format!("x: length, y: length, {name}: angle")));
            assert!(!turns(&std::format!(
                "x: length, y: length, {name}: length"
            )));
            assert!(!turns(&std::format!("x: length, {name}: angle")));
            assert!(!turns(&std::format!("hold: length, {name}: length")));
        }
    }

    #[test]
    fn shapes_add_key_points() {
        let domain = Domain::parse(
            "object a { x: length, y: length } shape a = rectangle(2, 1)
             object b { x: length, y: length } shape b = circle(1)",
        )
        .unwrap();
        for name in [
            "a", "a.left", "a.right", "a.top", "a.bottom", "a.centre", "b.left",
        ] {
            assert!(domain.find_point(name).is_some(), "{name}");
        }
        assert!(domain.find_point("b.centre").is_none());
    }
}
