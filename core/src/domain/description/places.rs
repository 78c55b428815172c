//! Statements that place things: shapes and points.

use super::DomainParser;
use crate::domain::{Base, Dependence, Dimension, Node, NodeId, Point, Shape, intern};
use crate::error::Error;
use crate::text::Lexer;

/// Where a shape starts, has its middle and ends along an axis of its object.
#[derive(Clone, Copy)]
struct Extent {
    low: Option<NodeId>,
    middle: Option<NodeId>,
    high: Option<NodeId>,
}

impl<'t> DomainParser<'t> {
    pub(super) fn shape_statement(&mut self) -> Result<(), Error> {
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
        let whole = self.domain.constant_value(&self.domain.nodes, size);
        intern(
            &mut self.domain.nodes,
            Node::Number(factor * whole.unwrap_or(0.0)),
        )
    }

    pub(super) fn point_statement(&mut self) -> Result<(), Error> {
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

    /// Checks what a component measures, and folds one that is constant: a scene
    /// evaluates it for every instance.
    fn checked_component(
        &mut self,
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
        match self.domain.constant_value(nodes, id) {
            None => Ok(Some(id)),
            Some(0.0) => Ok(None),
            Some(value) => intern(&mut self.domain.nodes, Node::Number(value)).map(Some),
        }
    }

    pub(super) fn point(
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
}
