//! Statements that declare points.

use super::parser::DomainParser;
use crate::domain::{Base, Dependence, Dimension, Member, Node, NodeId, Point};
use crate::text::{Failed, Place, Token, split_at_dot};

impl<'t> DomainParser<'_, 't> {
    #[inline(never)]
    pub(super) fn point_statement(&mut self) -> Result<(), Failed> {
        let name = self.new_name("expected the name of the point", true)?;
        let (owner, part) = split_at_dot(name).unwrap_or((name, ""));
        self.lexer
            .expect("=", "expected `=` and what the point is placed in")?;
        let frame = self.lexer.place();
        let base = self.frame()?;
        self.own = self.member(base).map(|first| first.group);
        let turn = if self.lexer.accept("turned") {
            self.turn()?
        } else {
            [None; 3]
        };
        if turn != [None; 3] && self.lexer.token() == Token::Symbol("*") {
            return Err(self
                .lexer
                .fail("a product behind `turned` stands in brackets: turned (2*a)"));
        }
        let offset = if self.lexer.accept("+") {
            self.offset()?
        } else {
            [None; 3]
        };
        if self.own.take().is_some() && self.is_sampled(base, turn, offset) {
            return Err(self.lexer.fail_at(
                frame,
                "a point that moves with a parameter cannot be placed in a group",
            ));
        }
        self.point(owner, part, base, turn, offset)
    }

    fn frame(&mut self) -> Result<Base, Failed> {
        if self.lexer.accept("world") {
            return Ok(Base::World);
        }
        let at = self.lexer.place();
        let name = self
            .lexer
            .expect_name("expected `world`, an object or an earlier point")?;
        let point = self.domain.find_point(name).map(Base::Point);
        point.ok_or_else(|| {
            self.lexer.fail_at(
                at,
                "no object with x and y and no earlier point has this name",
            )
        })
    }

    fn turn(&mut self) -> Result<[Option<NodeId>; 3], Failed> {
        if self.lexer.accept("(") {
            let yaw = self.component(Dimension::Angle)?;
            let (mut pitch, mut roll) = (None, None);
            if self.lexer.accept(",") {
                pitch = self.component(Dimension::Angle)?;
                self.lexer.expect(",", "expected `,` and the roll")?;
                roll = self.component(Dimension::Angle)?;
            }
            self.lexer.expect(")", "expected `)`")?;
            return Ok([yaw, pitch, roll]);
        }
        let at = self.lexer.place();
        let id = self.terms(true)?;
        let yaw = self.checked_component(at, id, Dimension::Angle)?;
        Ok([yaw, None, None])
    }

    fn offset(&mut self) -> Result<[Option<NodeId>; 3], Failed> {
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

    /// Reads a component of a turn or an offset; `None` for a plain zero.
    fn component(&mut self, dimension: Dimension) -> Result<Option<NodeId>, Failed> {
        let at = self.lexer.place();
        let id = self.expression()?;
        self.checked_component(at, id, dimension)
    }

    /// Checks what a component measures, and computes it if it is constant: a scene would
    /// do so for every instance.
    fn checked_component(
        &mut self,
        at: Place,
        id: NodeId,
        dimension: Dimension,
    ) -> Result<Option<NodeId>, Failed> {
        let nodes = &self.domain.nodes;
        match self.domain.dimension(nodes, id) {
            None => {}
            Some(found) if found == dimension => {}
            // A plain ratio cannot place anything: it must scale a length.
            Some(_) => {
                return Err(self
                    .lexer
                    .fail_at(at, "an offset must be a length and a turn an angle"));
            }
        }
        match self.domain.constant_value(nodes, id) {
            None => Ok(Some(id)),
            Some(0.0) => Ok(None),
            Some(value) => self.intern(Node::Number(value)).map(Some),
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
    ) -> Result<(), Failed> {
        let taken = |p: &Point<'_>| p.owner == owner && p.part == part;
        if self.domain.points.iter().any(taken) {
            return Err(self.lexer.fail("this point is declared already"));
        }
        let first = self.member(base);
        let count = first.map_or(1, |m| self.domain.members(m.group).len());
        let sampled = self.is_sampled(base, turn, offset);
        for index in (0u8..).take(count) {
            let point = Point {
                owner,
                part,
                base: match base {
                    Base::World => Base::World,
                    Base::Object(object) => Base::Object(object.saturating_add(index)),
                    Base::Point(point) => Base::Point(point.saturating_add(index)),
                },
                turn: self.of_member(turn, index)?,
                offset: self.of_member(offset, index)?,
                sampled,
                member: first.map(|m| Member { index, ..m }),
            };
            let pushed = self.domain.points.push(point);
            pushed.map_err(|_| self.lexer.full("points of a domain"))?;
        }
        Ok(())
    }

    /// The group that a point belongs to.
    pub(super) fn member_of_point(&self, point: u8) -> Option<Member> {
        self.member(Base::Point(point))
    }

    /// The group that a frame belongs to.
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

    /// Turns the components of a point of the first member into those of another member.
    pub(super) fn of_member(
        &mut self,
        mut components: [Option<NodeId>; 3],
        index: u8,
    ) -> Result<[Option<NodeId>; 3], Failed> {
        for id in components.iter_mut().flatten() {
            let moved = self.domain.term_of_member(*id, index);
            *id = moved.map_err(|full| self.lexer.note(full.into()))?;
        }
        Ok(components)
    }
}
