//! Groups: "for all objects of a type", with any number of them in an instance.
//!
//! `object obstacle[6]: block` declares a group of up to six members. Each is an
//! object like any other; only they share one name, so that nothing can be said of
//! a single one. What is said is the least or the greatest over the members that
//! are there: "the nearest obstacle is at least 0.2 away" holds for all of them,
//! however many there are, and so one region serves every instance.

use super::declarations::{Member, Object};
use super::node::{Node, Relation};
use super::schema::Domain;

impl<'t> Domain<'t> {
    /// The members of a group; none for an index that is none.
    pub fn members(&self, group: u8) -> &[Object<'t>] {
        let group = self.groups.get(usize::from(group));
        let range = group.map(|g| {
            let first = usize::from(g.first_object);
            first..first + usize::from(g.count)
        });
        range.and_then(|r| self.objects.get(r)).unwrap_or(&[])
    }

    /// The members that a term is about, apart from those that an extreme is taken
    /// of: none, one, or those of several points.
    pub(crate) fn members_in(&self, term: Node) -> [Option<Member>; 3] {
        match term {
            Node::Attribute(slot) => [self.owner(slot).and_then(|o| o.member), None, None],
            other => other.points().map(|point| self.point_member(point?)),
        }
    }

    fn point_member(&self, point: u8) -> Option<Member> {
        self.points.get(usize::from(point))?.member
    }

    /// What a relation is for each member of its group, with that member.
    pub(crate) fn terms(&self, relation: Relation) -> impl Iterator<Item = (&Object<'t>, Node)> {
        let term = relation.term();
        let group = self.members_in(term).into_iter().flatten().next();
        let members = group.map_or(&[][..], |first| self.members(first.group));
        let terms = (0u8..).map(move |index| self.for_member(term, index));
        members.iter().zip(terms)
    }

    /// What a term about the first member of a group is for another member.
    pub(super) fn for_member(&self, term: Node, index: u8) -> Node {
        let point = |p: u8| match self.point_member(p) {
            Some(_) => p.saturating_add(index),
            None => p,
        };
        match term {
            Node::Attribute(slot) => Node::Attribute(self.slot_of_member(slot, index)),
            Node::Coordinate(coordinate, p) => Node::Coordinate(coordinate, point(p)),
            Node::Distance(metric, a, b) => Node::Distance(metric, point(a), point(b)),
            Node::Angle(a, b) => Node::Angle(point(a), point(b)),
            Node::VertexAngle(a, b, c) => Node::VertexAngle(point(a), point(b), point(c)),
            other => other,
        }
    }

    fn slot_of_member(&self, slot: u8, index: u8) -> u8 {
        let Some(first) = self.owner(slot).filter(|o| o.member.is_some()) else {
            return slot;
        };
        let stride = self.attributes_of(first.type_index).len();
        let moved = usize::from(slot) + stride * usize::from(index);
        u8::try_from(moved).unwrap_or(slot)
    }
}
