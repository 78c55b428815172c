//! Statements that declare bodies: `shape name = solid`, `shape name = part + part` and
//! `shape name = none`.

use super::parser::DomainParser;
use crate::domain::{Base, Body, Compound, Dependence, Dimension, Node, NodeId, Shape, Solid};
use crate::text::{Failed, Place, Token};
use heapless::Vec;

const KINDS: &str =
    "expected a shape: circle, rectangle, box, capsule or segment, with sizes in brackets";
const NO_PART: &str =
    "this is no kind of shape with its sizes in brackets, and no name of something with a shape";

/// Where a solid starts, has its middle and ends along an axis of its frame.
#[derive(Clone, Copy)]
struct Extent {
    low: Option<NodeId>,
    middle: Option<NodeId>,
    high: Option<NodeId>,
}

impl<'t> DomainParser<'_, 't> {
    #[inline(never)]
    pub(super) fn shape_statement(&mut self) -> Result<(), Failed> {
        let at = self.lexer.place();
        let name = self
            .lexer
            .expect_name("expected the name of an object or a point")?;
        self.lexer.expect("=", "expected `=` and a shape")?;
        let first = self.lexer.place();
        let word = self.lexer.expect_name(KINDS)?;
        let is_solid = self.lexer.token() == Token::Symbol("(");
        if !is_solid && word != "none" {
            return self.compound((name, at), (word, first));
        }
        let point = self.shapeless(name, at)?;
        if !is_solid {
            self.hide(point);
            return Ok(());
        }
        self.own = self.member_of_point(point).map(|member| member.group);
        let solid = self.solid(word, first)?;
        self.own = None;
        let outlined = self.key_shape(name, &solid)?;
        if cfg!(feature = "bodies") {
            return self.bodies(point, solid);
        }
        match outlined {
            true => Ok(()),
            false => Err(self.lexer.fail_at(
                at,
                "this library was built without bodies: only objects have shapes, circles and \
                 rectangles of constant sizes",
            )),
        }
    }

    /// The point of this name, which has no shape yet.
    fn shapeless(&mut self, name: &str, at: Place) -> Result<u8, Failed> {
        let Some(point) = self.domain.find_point(name) else {
            let what = match self.domain.find_object(name) {
                Some(_) => "an object with a shape needs the attributes x and y",
                None => "no object and no earlier point has this name",
            };
            return Err(self.lexer.fail_at(at, what));
        };
        if self.domain.body_of(point).is_some() || self.domain.hidden.has(point) {
            return Err(self.lexer.fail_at(at, "this name has a shape already"));
        }
        Ok(point)
    }

    /// Keeps the relations of a point, or of each member of its group, from being enumerated.
    fn hide(&mut self, point: u8) {
        for index in (0u8..).take(self.count_of(point)) {
            self.domain.hidden.insert(point.saturating_add(index));
        }
    }

    /// How many points share the name of a point: those of every member.
    pub(super) fn count_of(&self, point: u8) -> usize {
        let member = self.member_of_point(point);
        member.map_or(1, |m| self.domain.members(m.group).len())
    }

    /// Reads the parts of a compound behind the first one.
    fn compound(
        &mut self,
        (name, at): (&'t str, Place),
        (first, first_at): (&'t str, Place),
    ) -> Result<(), Failed> {
        let mut parts = Vec::new();
        let mut part = (first, first_at);
        loop {
            let point = self.part(part)?;
            let pushed = parts.push(point);
            pushed.map_err(|_| self.lexer.full("parts of a compound"))?;
            if !self.lexer.accept("+") {
                break;
            }
            let place = self.lexer.place();
            part = (
                self.lexer.expect_name("expected the name of a part")?,
                place,
            );
        }
        self.check_new(name, at, false)?;
        let pushed = self.domain.compounds.push(Compound { name, parts });
        pushed.map_err(|_| self.lexer.full("compounds of a domain"))
    }

    /// The point of a part, which is a single body.
    fn part(&mut self, (name, at): (&str, Place)) -> Result<u8, Failed> {
        let point = self.domain.find_point(name);
        let Some(point) = point.filter(|point| self.domain.body_of(*point).is_some()) else {
            return Err(self.lexer.fail_at(at, NO_PART));
        };
        match self.member_of_point(point) {
            Some(_) => Err(self
                .lexer
                .fail_at(at, "a part is a single body, not a group")),
            None => Ok(point),
        }
    }

    /// Reads a solid of some kind, behind the word for it.
    fn solid(&mut self, word: &str, at: Place) -> Result<Solid, Failed> {
        let mut solid = Solid::default();
        match word {
            "circle" => {
                let [radius, ..] = self.sizes(1)?;
                solid.radius = radius;
                solid.centred = true;
            }
            "rectangle" => [solid.sizes[0], solid.sizes[1], _] = self.sizes(2)?,
            "box" => solid.sizes = self.sizes(3)?,
            "capsule" => [solid.sizes[0], solid.radius, _] = self.sizes(2)?,
            "segment" => [solid.sizes[0], ..] = self.sizes(1)?,
            _ => return Err(self.lexer.fail_at(at, KINDS)),
        }
        if self.lexer.accept("rounded") {
            let at = self.lexer.place();
            if solid.radius.is_some() {
                return Err(self
                    .lexer
                    .fail_at(at, "a circle and a capsule are round already"));
            }
            let radius = self.terms(true)?;
            solid.radius = Some(self.size_at(at, radius)?);
        }
        solid.centred |= self.lexer.accept("centred");
        Ok(solid)
    }

    /// Reads `( expr, ... )`, one to three sizes of a solid.
    fn sizes(&mut self, count: usize) -> Result<[Option<NodeId>; 3], Failed> {
        let mut sizes = [None; 3];
        let mut separator = "(";
        for size in sizes.iter_mut().take(count) {
            self.lexer
                .expect(separator, "expected the sizes of the shape in brackets")?;
            separator = ",";
            let at = self.lexer.place();
            let term = self.expression()?;
            *size = Some(self.size_at(at, term)?);
        }
        self.lexer
            .expect(")", "expected `)` behind the sizes of the shape")?;
        Ok(sizes)
    }

    /// A size is a length.
    fn size_at(&mut self, at: Place, size: NodeId) -> Result<NodeId, Failed> {
        match self.domain.dimension(&self.domain.nodes, size) {
            None | Some(Dimension::Length) => Ok(size),
            Some(_) => Err(self.lexer.fail_at(at, "a size is a length")),
        }
    }

    /// Keeps a solid of a point, or one of each member of its group.
    fn bodies(&mut self, point: u8, solid: Solid) -> Result<(), Failed> {
        for index in (0u8..).take(self.count_of(point)) {
            let body = Body {
                point: point.saturating_add(index),
                solid: Solid {
                    sizes: self.of_member(solid.sizes, index)?,
                    radius: self.of_member([solid.radius, None, None], index)?[0],
                    centred: solid.centred,
                },
            };
            let pushed = self.domain.bodies.push(body);
            pushed.map_err(|_| {
                self.lexer
                    .full("bodies of a domain, those of every member counted")
            })?;
        }
        Ok(())
    }

    /// Gives an object with a circle or a rectangle of constant sizes its key points and
    /// its area (thesis 4.2). Tells whether it is one.
    fn key_shape(&mut self, name: &'t str, solid: &Solid) -> Result<bool, Failed> {
        let Some(object) = self.domain.find_object(name) else {
            return Ok(false);
        };
        let known =
            |id: &NodeId| self.domain.dependence(&self.domain.nodes, *id) == Dependence::Constant;
        let (shape, extents) = match (solid.sizes, solid.radius) {
            ([None, None, None], Some(radius)) if known(&radius) => {
                let extent = self.centred(radius)?;
                (Shape::Circle { radius }, [extent, extent])
            }
            ([Some(width), Some(height), None], None) if known(&width) && known(&height) => {
                let halves = [self.half(width)?, self.half(height)?];
                let extents = if solid.centred {
                    let [width, height] = halves;
                    [self.centred(width)?, self.centred(height)?]
                } else {
                    let [half_width, half_height] = halves;
                    [(width, half_width), (height, half_height)].map(|(whole, half)| Extent {
                        low: None,
                        middle: Some(half),
                        high: Some(whole),
                    })
                };
                (Shape::Rectangle { width, height }, extents)
            }
            _ => return Ok(false),
        };
        self.key_points(name, object, extents)?;
        self.domain
            .shapes
            .push((object, shape))
            .map_err(|_| self.lexer.full("shapes of a domain"))?;
        Ok(true)
    }

    /// The points in the middle of the sides of a shape, and its centre where
    /// that is not the object's position.
    fn key_points(&mut self, name: &'t str, object: u8, [x, y]: [Extent; 2]) -> Result<(), Failed> {
        let sides = [
            ("left", x.low, y.middle),
            ("right", x.high, y.middle),
            ("bottom", x.middle, y.low),
            ("top", x.middle, y.high),
            ("centre", x.middle, y.middle),
        ];
        let count = if x.middle.is_some() { 5 } else { 4 };
        for (part, x, y) in sides.into_iter().take(count) {
            let offset = [x, y, None];
            self.point(name, part, Base::Object(object), [None; 3], offset)?;
        }
        Ok(())
    }

    fn half(&mut self, size: NodeId) -> Result<NodeId, Failed> {
        self.scaled(0.5, size)
    }

    fn centred(&mut self, half: NodeId) -> Result<Extent, Failed> {
        Ok(Extent {
            low: Some(self.scaled(-1.0, half)?),
            middle: None,
            high: Some(half),
        })
    }

    fn scaled(&mut self, factor: f64, size: NodeId) -> Result<NodeId, Failed> {
        let whole = self.domain.constant_value(&self.domain.nodes, size);
        self.intern(Node::Number(factor * whole.unwrap_or(0.0)))
    }
}
