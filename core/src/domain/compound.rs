//! Compounds: several bodies under one name, as the fingers and the palm of a gripper.
//!
//! A compound is its parts, as a group is its members: what is said of it is the least value
//! over the parts, of which absent ones are passed over. So "clear of the gripper" holds of
//! each finger. It has no place of its own, and so no distance and no heading.

use super::declarations::Compound;
use super::node::{Node, Quantity};
use super::schema::{Domain, MAX_POINTS};
use crate::geometry::Relation;

/// The number of the first compound, among those of the points and compounds.
pub(super) const FIRST_COMPOUND: u8 = MAX_POINTS as u8;

impl<'t> Domain<'t> {
    /// The compounds in order of declaration.
    pub fn compounds(&self) -> &[Compound<'t>] {
        &self.compounds
    }

    /// The compound that stands for a point in a quantity.
    pub fn compound(&self, number: u8) -> Option<&Compound<'t>> {
        let index = number.checked_sub(FIRST_COMPOUND)?;
        self.compounds.get(usize::from(index))
    }

    /// The number of the compound with this name: it stands for a point in a quantity.
    pub fn find_compound(&self, name: &str) -> Option<u8> {
        let index = self.compounds.iter().position(|c| c.name == name)?;
        u8::try_from(index).ok()?.checked_add(FIRST_COMPOUND)
    }

    /// The numbers of all compounds.
    pub(crate) fn compound_numbers(&self) -> impl Iterator<Item = u8> {
        (FIRST_COMPOUND..)
            .zip(&self.compounds)
            .map(|(number, _)| number)
    }

    /// The parts of a compound, or the point itself.
    pub(crate) fn parts(&self, number: u8) -> impl Iterator<Item = u8> {
        let compound = self.compound(number);
        let itself = compound.is_none().then_some(number);
        let parts = compound.into_iter().flat_map(|compound| &compound.parts);
        parts.copied().chain(itself)
    }

    /// Whether a point, or a part of a compound, moves with a parameter.
    pub(crate) fn moves(&self, number: u8) -> bool {
        let mut points = self
            .parts(number)
            .map(|part| self.points.get(usize::from(part)));
        points.any(|point| point.is_some_and(|point| point.sampled))
    }

    /// Visits what a quantity of compounds is the least of: the quantity of each part, or of
    /// each two. Any other quantity is visited itself.
    pub(super) fn each_part(&self, quantity: Quantity, visit: &mut dyn FnMut(Quantity)) {
        let [a, b, c] = quantity.points().map(Option::unwrap_or_default);
        for a in self.parts(a) {
            for b in self.parts(b) {
                for c in self.parts(c) {
                    visit(quantity.with_points([a, b, c]));
                }
            }
        }
    }

    /// Visits the quantities that a term needs: those of all members and all parts that it is
    /// about.
    pub(super) fn quantities(&self, term: Node, visit: &mut dyn FnMut(Quantity)) {
        match term {
            Node::Quantity(quantity) => self.each_part(quantity, visit),
            Node::Extreme(_, quantity) => {
                for (_, own) in self.of_members(quantity) {
                    self.each_part(own, visit);
                }
            }
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Area(_)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..)
            | Node::Quotient(..) => {}
        }
    }
}

impl Relation {
    /// Whether this can be said of a compound, as the first body and as the second one: of
    /// rooms and clearances the least one counts.
    pub(crate) fn takes_compounds(self) -> [bool; 2] {
        match self {
            Relation::Clear => [true, true],
            Relation::Inside | Relation::InsideAlong(_) | Relation::Over | Relation::Corner => {
                [true, false]
            }
            Relation::Coordinate(_) | Relation::Magnitude(_) => [false, false],
        }
    }
}
