//! Left sides that are made of others: what no relation between two points says.

use super::body_leaves::offs;
use super::features::{Features, feature_id};
use super::leaves::{folded_angles, moving, places, shown, vertex_angles};
use crate::domain::{
    Coordinate, Dimension, Domain, Extreme, Metric, Node, NodeId, Point, Quantity, Share,
};
use crate::geometry::{Axis, Relation};
use crate::real::Real;

/// A function that takes the id of one left side after the other.
pub(crate) type VisitId<'v> = &'v mut dyn FnMut(NodeId);

impl<R: Real> Features<'_, R> {
    /// Appends left sides that are derived from those of the grammar, as far as there is
    /// room, and visits each:
    ///
    /// | left side | says |
    /// |---|---|
    /// | `x_in(hand, tray)`, `abs_x_in(hand, tray)` | where something is in the frame of what has a heading |
    /// | `angle(finger, nut, 0.5*pi)` | an angle of what looks the same from several sides |
    /// | `off(cup, nozzle)`, `angle(cup, hand, base)` | by how much something is off a direction |
    /// | `hand.x + hand.y`, `hand.x - hand.y` | on which side of a diagonal |
    /// | `min(dist(hand, post) - 0.5*post.width)` | clear of members of different sizes |
    /// | `mu * stick.length`, `turn*drum.radius` | a share of a size, an arc |
    /// | `part.width` | a condition on the scene alone |
    /// | `dist_x(foot, pad)/dist_y(foot, pad)` | how steep it is from one thing to another |
    /// | `dist(hand, base)*load.mass`, `v*v/(ground.mu*goal.far)` | a law: products and quotients of up to four numbers |
    pub(crate) fn derive(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        if domain.parameters().is_empty() || domain.compares() {
            return;
        }
        self.derive_in_frames(domain, visit);
        self.derive_angles(domain, visit);
        self.derive_gaps(domain, visit);
        self.derive_diagonals(domain, visit);
        self.derive_shares(domain, visit);
        self.derive_scene(domain, visit);
        self.derive_slopes(domain, visit);
        self.derive_laws(domain, visit);
    }

    /// Appends a left side, unless it is there already.
    pub(super) fn offer(&mut self, node: Node, visit: VisitId<'_>) {
        if self.find(node).is_none()
            && let Some(id) = self.operand(node)
        {
            visit(id);
        }
    }

    /// Angles of what looks the same from several sides, off a direction, and at a point.
    fn derive_angles(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        let mut offer = |node| self.offer(node, visit);
        folded_angles(domain, true, &mut offer);
        if domain.has_headings() {
            if domain.bodies().is_empty() && cfg!(feature = "bodies") {
                offs(domain, &mut offer);
            }
            vertex_angles(domain, true, &mut offer);
        }
    }

    /// Coordinates in the frame of what has a heading. Those of bodies are there already.
    fn derive_in_frames(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        if cfg!(not(feature = "bodies")) {
            return;
        }
        let axes = [Axis::X, Axis::Y, Axis::Z];
        let axes = axes.get(..domain.axes()).unwrap_or(&axes);
        for (a, first) in places(domain).filter(is_single) {
            for (b, second) in shown(domain).filter(is_single) {
                if domain.coincide(a, b)
                    || !second.has_heading()
                    || !domain.is_oriented(b)
                    || first.sampled == second.sampled
                {
                    continue;
                }
                for relation in [Relation::Magnitude, Relation::Coordinate] {
                    for axis in axes {
                        let quantity = Quantity::Relation(relation(*axis), a, b);
                        self.offer(Node::Quantity(quantity), visit);
                    }
                }
            }
        }
    }

    /// Distances from the members of groups, minus a share of a size that each has.
    fn derive_gaps(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        for (a, _) in moving(domain).filter(is_single) {
            for (b, point) in places(domain).filter(|(_, p)| p.is_object() && !p.sampled) {
                let first = point.member.filter(|member| member.index == 0);
                let sizes = (0u8..).zip(domain.slots()).filter(|(slot, (object, own))| {
                    object.member == first
                        && own.dimension == Dimension::Length
                        && !domain.places(*slot)
                });
                for (slot, _) in sizes.filter(|_| first.is_some()) {
                    for share in Share::ALL {
                        let gap = Quantity::Gap(share, a, b, slot);
                        self.offer(Node::Extreme(Extreme::Least, gap), visit);
                    }
                }
            }
        }
    }

    /// Sums and differences of the coordinates of what moves, or, if no point does, of
    /// parameters.
    fn derive_diagonals(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        let mut moving = false;
        for (index, point) in (0u8..).zip(domain.points()) {
            let moves = domain.is_displaced(index) && domain.names_place(index);
            if !moves || point.member.is_some() || domain.axes() < 2 {
                continue;
            }
            moving = true;
            let along = |axis| Node::Quantity(Quantity::Coordinate(axis, index));
            self.offer_pair([along(Coordinate::X), along(Coordinate::Y)], visit);
        }
        if moving {
            return;
        }
        for (b, second) in (0u8..).zip(domain.parameters()) {
            let before = domain.parameters().get(..usize::from(b)).unwrap_or(&[]);
            for (a, first) in (0u8..).zip(before) {
                if first.dimension == second.dimension {
                    self.offer_pair([Node::Parameter(a), Node::Parameter(b)], visit);
                }
            }
        }
    }

    fn offer_pair(&mut self, [a, b]: [Node; 2], visit: VisitId<'_>) {
        if let (Some(a), Some(b)) = (self.operand(a), self.operand(b)) {
            self.offer(Node::Sum(a, b), visit);
            self.offer(Node::Difference(a, b), visit);
        }
    }

    /// Parameters times sizes, and arcs: angles that turn no point times lengths.
    fn derive_shares(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        for (p, parameter) in (0u8..).zip(domain.parameters()) {
            for (slot, dimension) in sizes(domain) {
                let pair = [parameter.dimension, dimension];
                let arc = pair == [Dimension::Angle, Dimension::Length] && !domain.turns_points(p);
                let share = pair.contains(&Dimension::None) && dimension != Dimension::Flag;
                let node = Node::Quantity(Quantity::Attribute(slot));
                if !share && !arc {
                    continue;
                }
                if let (Some(a), Some(b)) = (self.operand(Node::Parameter(p)), self.operand(node)) {
                    self.offer(Node::Product(a, b), visit);
                }
            }
        }
    }

    /// Attributes, as conditions on the scene alone.
    fn derive_scene(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        for (slot, _) in sizes(domain) {
            let node = Node::Quantity(Quantity::Attribute(slot));
            // It may be there as a right side.
            if let Some(id) = self.operand(node) {
                visit(id);
            }
        }
    }

    /// How steep it is from what stands to what moves.
    fn derive_slopes(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        if domain.axes() < 2 {
            return;
        }
        for (a, _) in moving(domain).filter(is_single) {
            let stands = places(domain).filter(is_single);
            for (b, _) in stands.filter(|(_, point)| point.is_object()) {
                let along = |metric| Node::Quantity(Quantity::Distance(metric, a, b));
                let operands = [Metric::X, Metric::Y].map(|metric| self.operand(along(metric)));
                if let [Some(x), Some(y)] = operands {
                    self.offer(Node::Quotient(x, y), visit);
                }
            }
        }
    }

    /// The id of a term, which is appended if it is not there; `None` without room.
    pub(super) fn operand(&mut self, node: Node) -> Option<NodeId> {
        self.find(node).or_else(|| self.append_node(node))
    }

    fn find(&self, node: Node) -> Option<NodeId> {
        let place = self.nodes().iter().position(|own| *own == node);
        place.map(feature_id)
    }
}

/// Whether a point is no member of a group.
fn is_single((_, point): &(u8, &Point<'_>)) -> bool {
    point.member.is_none()
}

/// The attributes that do not place an object, except those of groups.
pub(super) fn sizes<'d>(domain: &'d Domain<'_>) -> impl Iterator<Item = (u8, Dimension)> + 'd {
    let slots = (0u8..).zip(domain.slots());
    let own = slots.filter(|(slot, (object, _))| object.member.is_none() && !domain.places(*slot));
    own.map(|(slot, (_, attribute))| (slot, attribute.dimension))
}
