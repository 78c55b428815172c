//! Groups: "for all objects of a type", with any number of them in an instance.
//!
//! `object obstacle[6]: block` declares a group of up to six members. Each member is an
//! object like any other, but all have one name, so a text cannot speak of a single one.
//! It speaks of the least or the greatest value over the members that are there. "The
//! nearest obstacle is at least 0.2 away" then holds for all of them, however many there
//! are, and so one region serves every instance.

use super::declarations::{Member, Object};
use super::node::{Node, NodeId, Quantity, TermError, intern, node_at};
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

    /// The members that a quantity is about: none, one, or those of several points.
    pub(crate) fn members_in(&self, quantity: Quantity) -> [Option<Member>; 3] {
        match quantity.slot() {
            Some(slot) => [self.owner(slot).and_then(|o| o.member), None, None],
            None => quantity.points().map(|point| self.point_member(point?)),
        }
    }

    fn point_member(&self, point: u8) -> Option<Member> {
        self.points.get(usize::from(point))?.member
    }

    /// Each member of the group that a quantity is about, with the quantity of that member.
    pub(crate) fn of_members(
        &self,
        quantity: Quantity,
    ) -> impl Iterator<Item = (&Object<'t>, Quantity)> {
        let group = self.members_in(quantity).into_iter().flatten().next();
        let members = group.map_or(&[][..], |first| self.members(first.group));
        let quantities = (0u8..).map(move |index| self.of_member(quantity, index));
        members.iter().zip(quantities)
    }

    /// Turns a quantity of the first member of a group into that of another member.
    pub(crate) fn of_member(&self, quantity: Quantity, index: u8) -> Quantity {
        let quantity = match quantity {
            Quantity::Gap(share, a, b, slot) => {
                Quantity::Gap(share, a, b, self.slot_of_member(slot, index))
            }
            other => other,
        };
        match quantity.slot() {
            Some(slot) => Quantity::Attribute(self.slot_of_member(slot, index)),
            None => quantity.with_points(quantity.points().map(|point| {
                let point = point.unwrap_or_default();
                match self.point_member(point) {
                    Some(_) => point.saturating_add(index),
                    None => point,
                }
            })),
        }
    }

    /// Turns a term about the first member of a group into one about another member, and
    /// adds it to the terms of the domain.
    pub(super) fn term_of_member(&mut self, id: NodeId, index: u8) -> Result<NodeId, TermError> {
        let node = node_at(&self.nodes, id)?;
        let term = match (node.operands(), node.quantity()) {
            (Some((a, b, make)), _) => make(
                self.term_of_member(a, index)?,
                self.term_of_member(b, index)?,
            ),
            (None, Some(quantity)) => Node::Quantity(self.of_member(quantity, index)),
            (None, None) => node,
        };
        intern(&mut self.nodes, term)
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
