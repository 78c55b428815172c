//! Which points say where something is: several may be at one place, and one that only turns
//! with a parameter stays where it is.

use super::declarations::Base;
use super::node::NodeId;
use super::point_set::Bits;
use super::schema::Domain;

impl Domain<'_> {
    /// Whether a point is one that says where something is. Of those at one place these are the
    /// objects and bodies, or else the first: of `spot` and `place = spot turned yaw` where
    /// `place` has a shape, it is `place`. The others may say where something points.
    pub(crate) fn names_place(&self, point: u8) -> bool {
        !self.repeating.has(point)
    }

    /// Whether the place of a point, and not its direction alone, moves with a parameter.
    pub(crate) fn is_displaced(&self, point: u8) -> bool {
        self.displaced.has(point)
    }

    /// Whether two points are at one place for all parameters.
    pub(crate) fn coincide(&self, a: u8, b: u8) -> bool {
        self.place(a) == self.place(b)
    }

    /// What the last frame is that a point is at the origin of.
    fn place(&self, point: u8) -> Base {
        let mut place = Base::Point(point);
        while let Base::Point(index) = place
            && let Some(own) = self.points.get(usize::from(index))
            && own.offset == [None; 3]
        {
            place = own.base;
        }
        place
    }

    /// Notes, once all points and bodies are known, which name a place and which are displaced.
    pub(super) fn settle_places(&mut self) {
        let (mut displaced, mut turning) = (Bits::NONE, Bits::NONE);
        for (index, point) in (0u8..).zip(&self.points) {
            let (base_moves, base_turns) = match point.base {
                Base::Point(base) => (displaced.has(base), turning.has(base)),
                Base::World | Base::Object(_) => (false, false),
            };
            let depends = |terms: [Option<NodeId>; 3]| {
                let mut terms = terms.into_iter().flatten();
                terms.any(|term| self.parameters_of(&self.nodes, term) != 0)
            };
            let turns = base_turns || depends(point.turn);
            let swings = turns && point.offset != [None; 3];
            if turns {
                turning.insert(index);
            }
            if base_moves || swings || depends(point.offset) {
                displaced.insert(index);
            }
        }
        self.displaced = displaced;
        let mut repeating = Bits::NONE;
        for (index, _) in (0u8..).zip(&self.points) {
            if self.is_repeating(index) {
                repeating.insert(index);
            }
        }
        self.repeating = repeating;
    }

    /// Whether another point says where a point is.
    fn is_repeating(&self, point: u8) -> bool {
        let is_thing = |index: u8| {
            let own = self.points.get(usize::from(index));
            own.is_some_and(|own| own.is_object()) || self.body_of(index).is_some()
        };
        let mut others = (0u8..).zip(&self.points).map(|(index, _)| index);
        !is_thing(point)
            && others.any(|other| {
                other != point
                    && self.coincide(other, point)
                    && !self.is_hidden(other)
                    && (other < point || is_thing(other))
            })
    }
}
