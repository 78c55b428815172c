//! Statements that place things: shapes and points.

use super::{DomainParser, MAX_TERMS};
use crate::domain::expression::node_at;
use crate::domain::{
    Base, Dependence, Dimension, Member, Node, NodeId, Point, Shape, copy, intern,
};
use crate::error::Error;
use crate::text::{Lexer, split_at_dot};
use heapless::Vec;

/// Where a shape starts, has its middle and ends along an axis of its object.
#[derive(Clone, Copy)]
struct Extent {
    low: Option<NodeId>,
    middle: Option<NodeId>,
    high: Option<NodeId>,
}

impl<'t> DomainParser<'_, 't> {
    #[inline(never)]
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

    #[inline(never)]
    pub(super) fn point_statement(&mut self) -> Result<(), Error> {
        let name = self.new_name("expected the name of the point", true)?;
        let (owner, part) = split_at_dot(name).unwrap_or((name, ""));
        self.lexer
            .expect("=", "expected `=` and what the point is placed in")?;
        let frame = self.lexer.clone();
        let base = self.frame()?;
        self.own = self.member(base).map(|first| first.group);
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
        if self.own.take().is_some() && self.is_sampled(base, turn, offset) {
            return Err(
                frame.error("a point that moves with a parameter cannot be placed in a group")
            );
        }
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
        let mut nodes: Vec<Node, MAX_TERMS> = Vec::new();
        let mut parser = self.domain.parser(&mut nodes, self.own);
        let id = parser.single(&mut self.lexer)?;
        let id = copy(&nodes, id, &mut self.domain.nodes)?;
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

    /// Declares a point, or one of each member of a group if the base is one of its
    /// first member.
    #[inline(never)]
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
        let first = self.member(base);
        let count = first.map_or(1, |m| self.domain.members(m.group).len());
        for index in (0u8..).take(count) {
            let point = Point {
                owner,
                part,
                base: match base {
                    Base::World => Base::World,
                    Base::Object(object) => Base::Object(object.saturating_add(index)),
                    Base::Point(point) => Base::Point(point.saturating_add(index)),
                },
                turn: self.components_of_member(turn, index)?,
                offset: self.components_of_member(offset, index)?,
                sampled: self.is_sampled(base, turn, offset),
                member: first.map(|m| Member { index, ..m }),
            };
            self.domain
                .points
                .push(point)
                .map_err(|_| Error::CapacityExceeded("points of a domain"))?;
        }
        Ok(())
    }

    /// To which group a frame belongs.
    fn member(&self, base: Base) -> Option<Member> {
        match base {
            Base::World => None,
            Base::Object(object) => self.domain.objects.get(usize::from(object))?.member,
            Base::Point(point) => self.domain.points.get(usize::from(point))?.member,
        }
    }

    /// Whether a point depends on a parameter.
    fn is_sampled(
        &self,
        base: Base,
        turn: [Option<NodeId>; 3],
        offset: [Option<NodeId>; 3],
    ) -> bool {
        let depends = |id| self.domain.dependence(&self.domain.nodes, id) == Dependence::Sample;
        let on_base = match base {
            Base::Point(p) => self.domain.points.get(usize::from(p)),
            Base::World | Base::Object(_) => None,
        };
        turn.into_iter().chain(offset).flatten().any(depends) || on_base.is_some_and(|p| p.sampled)
    }

    /// The components of a point of the first member, for another member.
    fn components_of_member(
        &mut self,
        [x, y, z]: [Option<NodeId>; 3],
        index: u8,
    ) -> Result<[Option<NodeId>; 3], Error> {
        let mut moved = |id: Option<NodeId>| id.map(|id| self.of_member(id, index)).transpose();
        Ok([moved(x)?, moved(y)?, moved(z)?])
    }

    fn of_member(&mut self, id: NodeId, index: u8) -> Result<NodeId, Error> {
        let term = match node_at(&self.domain.nodes, id)? {
            Node::Sum(a, b) => Node::Sum(self.of_member(a, index)?, self.of_member(b, index)?),
            Node::Difference(a, b) => {
                Node::Difference(self.of_member(a, index)?, self.of_member(b, index)?)
            }
            Node::Product(a, b) => {
                Node::Product(self.of_member(a, index)?, self.of_member(b, index)?)
            }
            leaf => self.domain.for_member(leaf, index),
        };
        intern(&mut self.domain.nodes, term)
    }
}
