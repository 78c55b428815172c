//! The domain text: how a planner says what it knows.
//!
//! ```text
//! domain    = { statement } ;                                (* "#" starts a comment *)
//! statement = type | object | constant | parameter | shape | point ;
//! type      = "type" name attributes ;
//! object    = "object" name ( attributes | { "," name } ":" name ) ;
//! attributes= "{" [ name ":" dimension { "," name ":" dimension } ] "}" ;
//! dimension = "length" | "angle" | "area" | "flag" | "none" ;
//! constant  = "constant" path "=" expr ":" dimension ;
//! parameter = "parameter" name "in" "[" expr "," expr "]" [ ":" dimension ] ;
//! shape     = "shape" name "=" ( "circle" "(" expr ")"
//!                              | "rectangle" "(" expr "," expr ")" [ "centred" ] ) ;
//! point     = "point" path "=" frame [ "turned" turn ] [ "+" offset ] ;
//! frame     = "world" | path ;                               (* an object or an earlier point *)
//! turn      = factor | "(" expr "," expr "," expr ")" ;      (* yaw, or yaw, pitch, roll *)
//! offset    = "(" expr "," expr [ "," expr ] ")" ;
//! expr      = term { ( "+" | "-" ) term } ;
//! term      = factor { "*" factor } ;
//! factor    = number | "pi" | path | "-" factor | "(" expr ")" | call ;
//! call      = ( "dist" | "dist_x" | "dist_y" | "dist_z" | "angle" ) "(" path "," path ")"
//!           | "area" "(" name ")" ;
//! path      = name { "." name } ;
//! ```
//!
//! An object whose type has the attributes `x` and `y` (and `z`, `theta` or
//! `yaw`, `pitch`, `roll`) is a point as well. The corner of a `rectangle` is the
//! object's position unless it is `centred`; a shape adds the key points `left`,
//! `right`, `bottom`, `top` and, for rectangles, `centre` (thesis 4.2).
//! Offsets, turns and sizes are made of numbers, constants, attributes and
//! parameters; a point that depends on a parameter is a sample point.

use super::dimension::Dimension;
use super::expression::{Dependence, Node, NodeId, intern};
use super::schema::{Attribute, Base, Constant, Domain, Object, Parameter, Point, Shape, Type};
use crate::error::Error;
use crate::text::Lexer;
use heapless::Vec;

/// Checksum that tells domain texts and saved bytes apart.
pub(crate) const CHECKSUM: crc::Crc<u32> = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC);

const KEYWORDS: [&str; 19] = [
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
];

impl<'t> Domain<'t> {
    /// Reads a domain from its text; the grammar stands at the head of the
    /// [module](crate::domain).
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
    /// [`Error::Syntax`] with line and column, [`Error::CapacityExceeded`] if
    /// there are more things than the `MAX_` constants of this module allow.
    pub fn parse(text: &'t str) -> Result<Domain<'t>, Error> {
        let mut parser = DomainParser {
            domain: Domain {
                types: Vec::new(),
                attributes: Vec::new(),
                objects: Vec::new(),
                constants: Vec::new(),
                parameters: Vec::new(),
                points: Vec::new(),
                shapes: Vec::new(),
                nodes: Vec::new(),
                slots: 0,
                text,
                fingerprint: CHECKSUM.checksum(text.as_bytes()),
            },
            lexer: Lexer::new(text),
        };
        parser.statements()?;
        Ok(parser.domain)
    }
}

struct DomainParser<'t> {
    domain: Domain<'t>,
    lexer: Lexer<'t>,
}

impl<'t> DomainParser<'t> {
    fn statements(&mut self) -> Result<(), Error> {
        while self.lexer.token() != crate::text::Token::End {
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
                return Err(self.lexer.error(
                    "expected a statement: type, object, constant, parameter, shape or point",
                ));
            }
        }
        Ok(())
    }

    fn type_statement(&mut self) -> Result<(), Error> {
        let at = self.lexer.clone();
        let name = self.lexer.expect_name("expected the name of the type")?;
        if name.contains('.') || KEYWORDS.contains(&name) {
            return Err(at.error("a type has a plain name that is no word of the language"));
        }
        if self.domain.types.iter().any(|t| t.name == name) {
            return Err(at.error("this type is declared already"));
        }
        self.attributes(name).map(|_| ())
    }

    /// `{ x: length, ... }`: declares a type with these attributes.
    fn attributes(&mut self, name: &'t str) -> Result<u8, Error> {
        const FULL: Error = Error::CapacityExceeded("attributes of a domain");
        self.lexer.expect("{", "expected `{` and the attributes")?;
        let first = self.domain.attributes.len();
        while !self.lexer.accept("}") {
            let at = self.lexer.clone();
            let attribute = self
                .lexer
                .expect_name("expected the name of an attribute or `}`")?;
            let own = self.domain.attributes.iter().skip(first);
            if attribute.contains('.') || own.clone().any(|a| a.name == attribute) {
                return Err(at.error("attributes have plain names, each once"));
            }
            self.lexer.expect(":", "expected `:` and a dimension")?;
            let dimension = self.dimension()?;
            let attribute = Attribute {
                name: attribute,
                dimension,
            };
            self.domain.attributes.push(attribute).map_err(|_| FULL)?;
            if !self.lexer.accept(",") {
                self.lexer.expect("}", "expected `,` or `}`")?;
                break;
            }
        }
        let kind = Type {
            name,
            first: small(first)?,
            count: small(self.domain.attributes.len() - first)?,
        };
        let index = small(self.domain.types.len())?;
        self.domain
            .types
            .push(kind)
            .map_err(|_| Error::CapacityExceeded("types of a domain"))?;
        Ok(index)
    }

    fn object_statement(&mut self) -> Result<(), Error> {
        let mut names: Vec<&'t str, { super::schema::MAX_OBJECTS }> = Vec::new();
        loop {
            let name = self.new_name("expected the name of the object", false)?;
            if names.contains(&name) {
                return Err(self.lexer.error("this object was just declared"));
            }
            names
                .push(name)
                .map_err(|_| Error::CapacityExceeded("objects of a domain"))?;
            if !self.lexer.accept(",") {
                break;
            }
        }
        let type_index = if self.lexer.accept(":") {
            let at = self.lexer.clone();
            let kind = self.lexer.expect_name("expected the name of a type")?;
            let found = self.domain.types.iter().position(|t| t.name == kind);
            small(found.ok_or_else(|| at.error("unknown type"))?)?
        } else {
            match names.as_slice() {
                [name] => self.attributes(name)?,
                _ => {
                    return Err(self
                        .lexer
                        .error("expected `:` and the type of these objects"));
                }
            }
        };
        names
            .iter()
            .try_for_each(|name| self.object(name, type_index))
    }

    fn object(&mut self, name: &'t str, type_index: u8) -> Result<(), Error> {
        let count = self.domain.attributes_of(type_index).len();
        let index = small(self.domain.objects.len())?;
        let object = Object {
            name,
            type_index,
            first_slot: self.domain.slots,
        };
        self.domain.slots = small(usize::from(self.domain.slots) + count)?;
        self.domain
            .objects
            .push(object)
            .map_err(|_| Error::CapacityExceeded("objects of a domain"))?;
        if let [Some(_), Some(_), _] = self.domain.pose_slots(index).position {
            self.point(name, "", Base::Object(index), [None; 3], [None; 3])?;
        }
        Ok(())
    }

    fn constant_statement(&mut self) -> Result<(), Error> {
        let name = self.new_name("expected the name of the constant", true)?;
        self.lexer.expect("=", "expected `=` and a value")?;
        let at = self.lexer.clone();
        let value = self.number()?;
        self.lexer
            .expect(":", "expected `:` and a dimension, as in `= 3.0: length`")?;
        let dimension = self.dimension()?;
        if let Some(measured) = value.1
            && measured != dimension
        {
            return Err(at.error("the value has another dimension than the constant"));
        }
        let constant = Constant {
            name,
            dimension,
            value: value.0,
        };
        self.domain
            .constants
            .push(constant)
            .map_err(|_| Error::CapacityExceeded("constants of a domain"))
    }

    fn parameter_statement(&mut self) -> Result<(), Error> {
        let name = self.new_name("expected the name of the parameter", false)?;
        self.lexer
            .expect("in", "expected `in` and a range, as in `in [0, 1]`")?;
        self.lexer
            .expect("[", "expected `[` and the smallest value")?;
        let (low, low_dimension) = self.number()?;
        self.lexer
            .expect(",", "expected `,` and the largest value")?;
        let at = self.lexer.clone();
        let (high, high_dimension) = self.number()?;
        if low >= high {
            return Err(at.error("the largest value must be above the smallest"));
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
            return Err(at.error("the range has another dimension than the parameter"));
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
            .map_err(|_| Error::CapacityExceeded("parameters of an action"))
    }

    fn shape_statement(&mut self) -> Result<(), Error> {
        let at = self.lexer.clone();
        let name = self.lexer.expect_name("expected the name of an object")?;
        let object = self
            .domain
            .find_object(name)
            .ok_or_else(|| at.error("unknown object"))?;
        if self.domain.find_point(name).is_none() {
            return Err(at.error("an object with a shape needs the attributes x and y"));
        }
        if self.domain.find_shape(name).is_some() {
            return Err(at.error("this object has a shape already"));
        }
        self.lexer.expect("=", "expected `=` and a shape")?;
        let (shape, extents) = if self.lexer.accept("circle") {
            let [radius] = self.sizes()?;
            let extent = self.centred(radius)?;
            (Shape::Circle { radius }, [extent, extent])
        } else {
            self.lexer
                .expect("rectangle", "expected `circle` or `rectangle`")?;
            let [width, height] = self.sizes()?;
            let (half_width, half_height) = (self.half(width)?, self.half(height)?);
            let extents = if self.lexer.accept("centred") {
                [self.centred(half_width)?, self.centred(half_height)?]
            } else {
                [(width, half_width), (height, half_height)].map(|(whole, half)| Extent {
                    low: None,
                    middle: Some(half),
                    high: Some(whole),
                })
            };
            (Shape::Rectangle { width, height }, extents)
        };
        self.key_points(name, object, extents)?;
        self.domain
            .shapes
            .push((object, shape))
            .map_err(|_| Error::CapacityExceeded("shapes of a domain"))
    }

    /// The points in the middle of the sides of a shape, and its centre where
    /// that is not the object's position.
    fn key_points(&mut self, name: &'t str, object: u8, [x, y]: [Extent; 2]) -> Result<(), Error> {
        let base = Base::Object(object);
        let mut add = |part, x, y| self.point(name, part, base, [None; 3], [x, y, None]);
        add("left", x.low, y.middle)?;
        add("right", x.high, y.middle)?;
        add("bottom", x.middle, y.low)?;
        add("top", x.middle, y.high)?;
        if x.middle.is_some() {
            add("centre", x.middle, y.middle)?;
        }
        Ok(())
    }

    /// `( expr, ... )`: the sizes of a shape.
    fn sizes<const N: usize>(&mut self) -> Result<[NodeId; N], Error> {
        let mut sizes = [NodeId::default(); N];
        let mut separator = "(";
        for size in &mut sizes {
            self.lexer
                .expect(separator, "expected the sizes of the shape in brackets")?;
            separator = ",";
            let at = self.lexer.clone();
            *size = self.expression()?;
            let nodes = &self.domain.nodes;
            let fits = matches!(
                self.domain.dimension(nodes, *size),
                None | Some(Dimension::Length)
            ) && self.domain.dependence(nodes, *size) == Dependence::Constant;
            if !fits {
                return Err(at.error("a size is a length made of numbers and constants"));
            }
        }
        self.lexer
            .expect(")", "expected `)` behind the sizes of the shape")?;
        Ok(sizes)
    }

    fn half(&mut self, size: NodeId) -> Result<NodeId, Error> {
        self.scaled(0.5, size)
    }

    fn centred(&mut self, half: NodeId) -> Result<Extent, Error> {
        Ok(Extent {
            low: Some(self.scaled(-1.0, half)?),
            middle: None,
            high: Some(half),
        })
    }

    fn scaled(&mut self, factor: f64, size: NodeId) -> Result<NodeId, Error> {
        let factor = intern(&mut self.domain.nodes, Node::Number(factor))?;
        intern(&mut self.domain.nodes, Node::Product(factor, size))
    }

    fn point_statement(&mut self) -> Result<(), Error> {
        let name = self.new_name("expected the name of the point", true)?;
        let (owner, part) = name.split_once('.').unwrap_or((name, ""));
        self.lexer
            .expect("=", "expected `=` and what the point is placed in")?;
        let base = self.frame()?;
        let turn = if self.lexer.accept("turned") {
            self.turn()?
        } else {
            [None; 3]
        };
        let offset = if self.lexer.accept("+") {
            self.offset()?
        } else {
            [None; 3]
        };
        self.point(owner, part, base, turn, offset)
    }

    fn frame(&mut self) -> Result<Base, Error> {
        if self.lexer.accept("world") {
            return Ok(Base::World);
        }
        let at = self.lexer.clone();
        let name = self
            .lexer
            .expect_name("expected `world`, an object or an earlier point")?;
        let point = self.domain.find_point(name).map(Base::Point);
        point.ok_or_else(|| at.error("no object with x and y and no earlier point has this name"))
    }

    fn turn(&mut self) -> Result<[Option<NodeId>; 3], Error> {
        let bracket = self.lexer.clone();
        if self.lexer.accept("(") {
            let yaw = self.component(Dimension::Angle)?;
            if self.lexer.accept(",") {
                let pitch = self.component(Dimension::Angle)?;
                self.lexer.expect(",", "expected `,` and the roll")?;
                let roll = self.component(Dimension::Angle)?;
                self.lexer.expect(")", "expected `)`")?;
                return Ok([yaw, pitch, roll]);
            }
            self.lexer = bracket;
        }
        let yaw = self.factor(Dimension::Angle)?;
        Ok([yaw, None, None])
    }

    fn offset(&mut self) -> Result<[Option<NodeId>; 3], Error> {
        self.lexer
            .expect("(", "expected `(` and the offset along each axis")?;
        let x = self.component(Dimension::Length)?;
        self.lexer
            .expect(",", "expected `,` and the offset along the y axis")?;
        let y = self.component(Dimension::Length)?;
        let z = if self.lexer.accept(",") {
            self.component(Dimension::Length)?
        } else {
            None
        };
        self.lexer.expect(")", "expected `)`")?;
        Ok([x, y, z])
    }

    /// A component of a turn or an offset; `None` for a plain zero.
    fn component(&mut self, dimension: Dimension) -> Result<Option<NodeId>, Error> {
        let at = self.lexer.clone();
        let id = self.expression()?;
        self.checked_component(&at, id, dimension)
    }

    fn factor(&mut self, dimension: Dimension) -> Result<Option<NodeId>, Error> {
        let at = self.lexer.clone();
        let mut nodes = self.domain.nodes.clone();
        let id = self.domain.parse_factor(&mut self.lexer, &mut nodes)?;
        self.domain.nodes = nodes;
        self.checked_component(&at, id, dimension)
    }

    fn checked_component(
        &self,
        at: &Lexer<'t>,
        id: NodeId,
        dimension: Dimension,
    ) -> Result<Option<NodeId>, Error> {
        let nodes = &self.domain.nodes;
        match self.domain.dimension(nodes, id) {
            None => {}
            Some(found) if found == dimension => {}
            // A plain ratio cannot place anything: it must scale a length.
            Some(_) => return Err(at.error("an offset must be a length and a turn an angle")),
        }
        let zero = nodes.get(usize::from(id.0)) == Some(&Node::Number(0.0));
        Ok((!zero).then_some(id))
    }

    fn point(
        &mut self,
        owner: &'t str,
        part: &'t str,
        base: Base,
        turn: [Option<NodeId>; 3],
        offset: [Option<NodeId>; 3],
    ) -> Result<(), Error> {
        let taken = |p: &Point<'_>| p.owner == owner && p.part == part;
        if self.domain.points.iter().any(taken) {
            return Err(self.lexer.error("this point is declared already"));
        }
        let moved = turn
            .iter()
            .chain(&offset)
            .flatten()
            .any(|id| self.domain.dependence(&self.domain.nodes, *id) == Dependence::Sample);
        let sampled_base = match base {
            Base::Point(p) => self
                .domain
                .points
                .get(usize::from(p))
                .is_some_and(|p| p.sampled),
            Base::World | Base::Object(_) => false,
        };
        let point = Point {
            owner,
            part,
            base,
            turn,
            offset,
            sampled: moved || sampled_base,
        };
        self.domain
            .points
            .push(point)
            .map_err(|_| Error::CapacityExceeded("points of a domain"))
    }

    fn dimension(&mut self) -> Result<Dimension, Error> {
        const WHAT: &str = "expected a dimension: length, angle, area, flag or none";
        let at = self.lexer.clone();
        let word = self.lexer.expect_name(WHAT)?;
        Dimension::from_name(word).ok_or_else(|| at.error(WHAT))
    }

    /// An expression over what is declared so far, without points.
    fn expression(&mut self) -> Result<NodeId, Error> {
        let at = self.lexer.clone();
        let mut nodes = self.domain.nodes.clone();
        let id = self.domain.parse_expression(&mut self.lexer, &mut nodes)?;
        let placed = |n: &Node| {
            matches!(
                n,
                Node::Coordinate(..) | Node::Distance(..) | Node::Angle(..) | Node::Area(_)
            )
        };
        if nodes.iter().any(placed) {
            return Err(at.error("offsets, sizes and values cannot refer to points or areas"));
        }
        self.domain.nodes = nodes;
        Ok(id)
    }

    /// The value of an expression over constants, and what it measures.
    fn number(&mut self) -> Result<(f64, Option<Dimension>), Error> {
        let at = self.lexer.clone();
        let kept = self.domain.nodes.len();
        let id = self.expression()?;
        let dimension = self.domain.dimension(&self.domain.nodes, id);
        let value = self.domain.constant_value(&self.domain.nodes, id);
        self.domain.nodes.truncate(kept);
        match value {
            Some(value) if value.is_finite() => Ok((value, dimension)),
            Some(_) => Err(at.error("the value is too large")),
            None => Err(at.error("the value must be made of numbers and constants")),
        }
    }

    /// A name that is not used yet for anything an expression could mean.
    fn new_name(&mut self, what: &'static str, dotted: bool) -> Result<&'t str, Error> {
        let at = self.lexer.clone();
        let name = self.lexer.expect_name(what)?;
        if KEYWORDS.contains(&name) {
            return Err(at.error("this is a word of the language"));
        }
        let plain_parts = name.split('.').all(|part| !part.is_empty());
        if !plain_parts || (!dotted && name.contains('.')) {
            return Err(at.error("a dot is not allowed here in a name"));
        }
        let domain = &self.domain;
        let taken = domain.find_object(name).is_some()
            || domain.find_point(name).is_some()
            || domain.find_constant(name).is_some()
            || domain.find_parameter(name).is_some()
            || domain.find_slot(name).is_some();
        if taken {
            return Err(at.error("this name is declared already"));
        }
        Ok(name)
    }
}

/// Where a shape starts, has its middle and ends along an axis of its object.
#[derive(Clone, Copy)]
struct Extent {
    low: Option<NodeId>,
    middle: Option<NodeId>,
    high: Option<NodeId>,
}

fn small(index: usize) -> Result<u8, Error> {
    u8::try_from(index).map_err(|_| Error::CapacityExceeded("numbers of an instance"))
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
            ("banana", 1, 1),
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
