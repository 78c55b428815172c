//! Reads the domain text; its grammar stands at the head of the parent module.

mod objects;
mod places;

use super::dimension::Dimension;
use super::expression::{Node, NodeId, copy, intern};
use super::schema::{Attribute, Constant, Domain, Parameter, Type};
use crate::error::Error;
use crate::text::{Failed, Lexer, Token, split_at_dot};
use crc::{CRC_32_ISO_HDLC, Crc};
use heapless::Vec;

/// Checksum that tells domain texts, instances and saved bytes apart. Instances are
/// checked in every call from C, so it has a table: a kilobyte of flash for a seventh of
/// what an answer takes on a microcontroller.
pub(crate) const CHECKSUM: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);

const KEYWORDS: [&str; 22] = [
    "type",
    "object",
    "constant",
    "parameter",
    "shape",
    "point",
    "in",
    "turned",
    "world",
    "and",
    "or",
    "not",
    "true",
    "pi",
    "dist",
    "dist_x",
    "dist_y",
    "dist_z",
    "angle",
    "area",
    "min",
    "max",
];

impl<'t> Domain<'t> {
    /// Reads a domain from its text; the grammar stands at the head of the
    /// [module](crate::domain#the-domain-text).
    ///
    /// ```
    /// use critreg::domain::Domain;
    /// let domain = Domain::parse(
    ///     "object stick { x: length, y: length, theta: angle }
    ///      constant stick.width = 3.0: length
    ///      parameter mu in [0, 1]
    ///      point grasp = stick + (mu * stick.width, 0)",
    /// )?;
    /// assert_eq!(domain.instance_len(), 3);
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

    /// A domain in which there is nothing.
    pub const fn empty() -> Domain<'t> {
        Domain {
            types: Vec::new(),
            attributes: Vec::new(),
            objects: Vec::new(),
            groups: Vec::new(),
            constants: Vec::new(),
            parameters: Vec::new(),
            points: Vec::new(),
            shapes: Vec::new(),
            nodes: Vec::new(),
            slots: 0,
            text: "",
            fingerprint: 0,
        }
    }

    /// As [`Domain::parse`], into an empty domain where it lies: domains are large, and
    /// small machines have no stack for a second one.
    ///
    /// # Errors
    /// Those of [`Domain::parse`], and [`Error::OutOfSequence`] for a domain that is not
    /// empty. After an error the domain is of no use.
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

/// Most terms of one expression for an offset, turn, size or value.
const MAX_TERMS: usize = 32;

struct DomainParser<'d, 't> {
    domain: &'d mut Domain<'t>,
    lexer: Lexer<'t>,
    /// The group whose members get the point that is being read.
    own: Option<u8>,
}

impl<'t> DomainParser<'_, 't> {
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
            } else {
                return Err(self.lexer.fail(
                    "expected a statement: type, object, constant, parameter, shape or point",
                ));
            }
        }
        if self.domain.instance_len() == 0 && self.domain.parameters.is_empty() {
            return Err(self
                .lexer
                .fail("expected an object with an attribute, or a parameter"));
        }
        Ok(())
    }

    #[inline(never)]
    fn type_statement(&mut self) -> Result<(), Failed> {
        let at = self.lexer.place();
        let name = self.lexer.expect_name("expected the name of the type")?;
        if split_at_dot(name).is_some() || KEYWORDS.contains(&name) {
            return Err(self.lexer.fail_at(
                at,
                "a type has a plain name that is no word of the language",
            ));
        }
        if self.domain.types.iter().any(|t| t.name == name) {
            return Err(self.lexer.fail_at(at, "this type is declared already"));
        }
        self.attributes(name).map(|_| ())
    }

    /// `{ x: length, ... }`: declares a type with these attributes.
    fn attributes(&mut self, name: &'t str) -> Result<u8, Failed> {
        self.lexer.expect("{", "expected `{` and the attributes")?;
        let first = self.domain.attributes.len();
        while !self.lexer.accept("}") {
            let at = self.lexer.place();
            let attribute = self
                .lexer
                .expect_name("expected the name of an attribute or `}`")?;
            let own = self.domain.attributes.iter().skip(first);
            if split_at_dot(attribute).is_some() || own.clone().any(|a| a.name == attribute) {
                return Err(self
                    .lexer
                    .fail_at(at, "attributes have plain names, each once"));
            }
            self.lexer.expect(":", "expected `:` and a dimension")?;
            let dimension = self.dimension()?;
            let attribute = Attribute {
                name: attribute,
                dimension,
            };
            self.domain
                .attributes
                .push(attribute)
                .map_err(|_| self.lexer.full("attributes of a domain"))?;
            if !self.lexer.accept(",") {
                self.lexer.expect("}", "expected `,` or `}`")?;
                break;
            }
        }
        let kind = Type {
            name,
            first: self.small(first)?,
            count: self.small(self.domain.attributes.len() - first)?,
        };
        let index = self.small(self.domain.types.len())?;
        self.domain
            .types
            .push(kind)
            .map_err(|_| self.lexer.full("types of a domain"))?;
        Ok(index)
    }

    #[inline(never)]
    fn constant_statement(&mut self) -> Result<(), Failed> {
        let name = self.new_name("expected the name of the constant", true)?;
        self.lexer.expect("=", "expected `=` and a value")?;
        let at = self.lexer.place();
        let value = self.number()?;
        self.lexer
            .expect(":", "expected `:` and a dimension, as in `= 3.0: length`")?;
        let dimension = self.dimension()?;
        if let Some(measured) = value.1
            && measured != dimension
        {
            return Err(self
                .lexer
                .fail_at(at, "the value has another dimension than the constant"));
        }
        let constant = Constant {
            name,
            dimension,
            value: value.0,
        };
        self.domain
            .constants
            .push(constant)
            .map_err(|_| self.lexer.full("constants of a domain"))
    }

    #[inline(never)]
    fn parameter_statement(&mut self) -> Result<(), Failed> {
        let name = self.new_name("expected the name of the parameter", false)?;
        self.lexer
            .expect("in", "expected `in` and a range, as in `in [0, 1]`")?;
        self.lexer
            .expect("[", "expected `[` and the smallest value")?;
        let (low, low_dimension) = self.number()?;
        self.lexer
            .expect(",", "expected `,` and the largest value")?;
        let at = self.lexer.place();
        let (high, high_dimension) = self.number()?;
        if low >= high {
            return Err(self
                .lexer
                .fail_at(at, "the largest value must be above the smallest"));
        }
        self.lexer.expect("]", "expected `]`")?;
        let measured = low_dimension.or(high_dimension);
        let dimension = if self.lexer.accept(":") {
            self.dimension()?
        } else {
            measured.unwrap_or(Dimension::None)
        };
        if [low_dimension, high_dimension]
            .iter()
            .flatten()
            .any(|d| *d != dimension)
        {
            return Err(self
                .lexer
                .fail_at(at, "the range has another dimension than the parameter"));
        }
        let parameter = Parameter {
            name,
            dimension,
            low,
            high,
        };
        self.domain
            .parameters
            .push(parameter)
            .map_err(|_| self.lexer.full("parameters of an action"))
    }

    fn dimension(&mut self) -> Result<Dimension, Failed> {
        const WHAT: &str = "expected a dimension: length, angle, area, flag or none";
        let at = self.lexer.place();
        let word = self.lexer.expect_name(WHAT)?;
        Dimension::from_name(word).ok_or_else(|| self.lexer.fail_at(at, WHAT))
    }

    /// An expression over what is declared so far, without points.
    fn expression(&mut self) -> Result<NodeId, Failed> {
        self.terms(false)
    }

    /// An expression, or only one factor.
    fn terms(&mut self, factor: bool) -> Result<NodeId, Failed> {
        let at = self.lexer.place();
        let mut nodes: Vec<Node, MAX_TERMS> = Vec::new();
        let mut parser = self.domain.parser(&mut nodes, self.own);
        let id = if factor {
            parser.single(&mut self.lexer)?
        } else {
            parser.expression(&mut self.lexer)?
        };
        let simple = |n: &Node| {
            !matches!(
                n,
                Node::Coordinate(..)
                    | Node::Distance(..)
                    | Node::Angle(..)
                    | Node::VertexAngle(..)
                    | Node::Area(_)
                    | Node::Extreme(..)
            )
        };
        if !nodes.iter().all(simple) {
            return Err(self.lexer.fail_at(
                at,
                "offsets, sizes and values cannot refer to points, areas, min or max",
            ));
        }
        copy(&nodes, id, &mut self.domain.nodes).map_err(|full| self.lexer.note(full.into()))
    }

    /// Adds a term to those of the domain.
    fn intern(&mut self, node: Node) -> Result<NodeId, Failed> {
        intern(&mut self.domain.nodes, node).map_err(|full| self.lexer.note(full.into()))
    }

    /// The value of an expression over constants, and what it measures.
    fn number(&mut self) -> Result<(f64, Option<Dimension>), Failed> {
        let at = self.lexer.place();
        let kept = self.domain.nodes.len();
        let id = self.expression()?;
        let dimension = self.domain.dimension(&self.domain.nodes, id);
        let value = self.domain.constant_value(&self.domain.nodes, id);
        self.domain.nodes.truncate(kept);
        match value {
            Some(value) if value.is_finite() => Ok((value, dimension)),
            Some(_) => Err(self.lexer.fail_at(at, "the value is too large")),
            None => Err(self
                .lexer
                .fail_at(at, "the value must be made of numbers and constants")),
        }
    }

    /// A name that is not used yet for anything an expression could mean.
    fn new_name(&mut self, what: &'static str, dotted: bool) -> Result<&'t str, Failed> {
        let at = self.lexer.place();
        let name = self.lexer.expect_name(what)?;
        if KEYWORDS.contains(&name) {
            return Err(self.lexer.fail_at(at, "this is a word of the language"));
        }
        // It begins with no dot, or it would be no name.
        let next = name.bytes().skip(1).chain([b'.']);
        let empty_part = name.bytes().zip(next).any(|pair| pair == (b'.', b'.'));
        if empty_part || (!dotted && split_at_dot(name).is_some()) {
            return Err(self
                .lexer
                .fail_at(at, "a dot is not allowed here in a name"));
        }
        let domain = &self.domain;
        let taken = domain.find_object(name).is_some()
            || domain.find_point(name).is_some()
            || domain.find_constant(name).is_some()
            || domain.find_parameter(name).is_some()
            || domain.find_slot(name).is_some();
        if taken {
            return Err(self.lexer.fail_at(at, "this name is declared already"));
        }
        Ok(name)
    }

    fn small(&mut self, index: usize) -> Result<u8, Failed> {
        u8::try_from(index).map_err(|_| self.lexer.full("numbers of an instance"))
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
