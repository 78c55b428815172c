//! Bodies as they stand in a sample, and what quantities say of them.

use super::body_pair::BodyPair;
use super::sight::Sight;
use super::{Sample, chord};
use crate::domain::algebra::{Algebra, Arithmetic, Measure};
use crate::domain::declarations::Solid;
use crate::domain::node::{Beam, Extreme, Node, NodeId, Quantity};
use crate::geometry::{Body, Relation};
use crate::real::Real;

/// A body where it stands in a sample.
pub(super) struct Standing<R, A> {
    /// About its centre.
    pub(super) body: Body<R>,
    pub(super) centre: [A; 3],
    /// By how much its sizes may be others.
    slack: R,
    /// By how much it may be turned further, as an angle.
    turn: R,
}

/// The bodies of a quantity, and what varies: vectors between them.
pub(super) enum Bodies<R, A> {
    /// Two bodies, and how far the first one's centre is from the second one's.
    Pair(BodyPair<R>, [A; 3]),
    /// A line and a body, and how far the ends are from the body's centre.
    Sight(Sight<R>, [[A; 3]; 2]),
}

impl<R: Real, A: Algebra<R>> Bodies<R, A> {
    /// Whether one of them is not there: a size of it is below zero.
    pub(super) fn are_absent(&self) -> bool {
        match self {
            Bodies::Pair(pair, _) => pair.is_absent(),
            Bodies::Sight(sight, _) => sight.is_absent(),
        }
    }

    fn measure(&self, slack: R) -> A::Measure {
        match self {
            Bodies::Pair(pair, difference) => {
                A::length_of([*difference], slack, |[difference]| pair.value(difference))
            }
            Bodies::Sight(sight, ends) => A::length_of(*ends, slack, |ends| sight.value(ends)),
        }
    }
}

impl<R: Real, A: Algebra<R>> Sample<'_, '_, R, A> {
    /// The value of a quantity of bodies; not a number if they are absent.
    pub(super) fn between_bodies(&self, quantity: Quantity) -> A::Measure {
        let least = self.least_of_parts(quantity);
        least.unwrap_or_else(|| A::Measure::constant(R::NAN))
    }

    /// The value of a quantity for one member; `None` if it is about a body that is absent.
    pub(super) fn of_member(&self, own: Quantity) -> Option<A::Measure> {
        match own {
            Quantity::Relation(..) | Quantity::Sight(..) => self.least_of_parts(own),
            _ => Some(self.leaf(Node::Quantity(own))),
        }
    }

    /// The least value over the parts of compounds, or that of two bodies. Absent ones are
    /// passed over; `None` if no others are there.
    #[inline(never)]
    fn least_of_parts(&self, quantity: Quantity) -> Option<A::Measure> {
        let mut least: Option<A::Measure> = None;
        self.scene.domain.each_part(quantity, &mut |part| {
            let value = match self.bodies(part) {
                Some((bodies, _)) if bodies.are_absent() => return,
                Some((bodies, slack)) => bodies.measure(slack),
                None => A::Measure::unknown(),
            };
            least = Some(match least {
                Some(least) => least.extreme(Extreme::Least, value),
                None => value,
            });
        });
        least
    }

    /// The bodies that a quantity is about, and by how much what is not known of how they are
    /// turned and how large they are can change it; `None` if nothing is known of one, or the
    /// quantity is about points.
    pub(super) fn bodies(&self, quantity: Quantity) -> Option<(Bodies<R, A>, R)> {
        // No text has such a quantity then, and what computes it is left out.
        if !cfg!(feature = "bodies") {
            return None;
        }
        match quantity {
            Quantity::Relation(relation, a, b) => self.pair(relation, [a, b]),
            Quantity::Sight(beam, a, b, body) => self.sight(beam, [a, b], body),
            Quantity::Attribute(_)
            | Quantity::Coordinate(..)
            | Quantity::Distance(..)
            | Quantity::Gap(..)
            | Quantity::Angle(..)
            | Quantity::FoldedAngle(..)
            | Quantity::Off(..)
            | Quantity::VertexAngle(..) => None,
        }
    }

    fn pair(&self, relation: Relation, [a, b]: [u8; 2]) -> Option<(Bodies<R, A>, R)> {
        let (a, b) = (self.body(a)?, self.body(b)?);
        let difference = between(b.centre, a.centre);
        let mut slack = a.slack + b.slack + chord(a.turn) * R::norm(a.body.half_sizes);
        if b.turn > R::ZERO {
            // Seen from the second body, the corners of the first one turn about its centre.
            let apart = difference.map(|own| {
                let own = own.about();
                own.map_or(R::INFINITY, |(middle, unknown)| middle.abs() + unknown)
            });
            let reach = R::norm(a.body.half_sizes) + R::norm(b.body.half_sizes);
            slack += chord(b.turn) * (R::norm(apart) + reach);
        }
        let pair = BodyPair {
            relation,
            first: a.body,
            second: b.body,
            dimensions: self.scene.dimensions,
        };
        Some((Bodies::Pair(pair, difference), slack))
    }

    fn sight(&self, beam: Beam, [a, b]: [u8; 2], body: u8) -> Option<(Bodies<R, A>, R)> {
        let standing = self.body(body)?;
        let (radius, unknown) = match beam {
            Beam::Line => (R::ZERO, R::ZERO),
            Beam::Sweep => self.size(self.solid(a).radius)?,
        };
        let sight = Sight {
            radius,
            body: standing.body,
            dimensions: self.scene.dimensions,
        };
        let ends = [a, b].map(|end| between(standing.centre, self.origin(end)));
        // How far the body is from the line changes by no more than its corners move.
        let turned = chord(standing.turn) * R::norm(standing.body.half_sizes);
        Some((
            Bodies::Sight(sight, ends),
            standing.slack + unknown + turned,
        ))
    }

    fn solid(&self, point: u8) -> Solid {
        let body = self.scene.domain.body_of(point);
        body.map_or_else(Solid::default, |body| body.solid)
    }

    /// A size, and how far it may be from that.
    fn size(&self, id: Option<NodeId>) -> Option<(R, R)> {
        self.scene.offset_term::<A>(id, self.theta).about()
    }

    /// The body of a point about its centre, and where that is.
    pub(super) fn body(&self, point: u8) -> Option<Standing<R, A>> {
        let placed = self.base(point);
        let solid = self.solid(point);
        let half = R::from_f64(0.5);
        let [[a, b, c], [d, e, f], [g, h, i]] = self.rotation(&placed)?.rows();
        let axes = [[a, d, g], [b, e, h], [c, f, i]];
        let (radius, mut slack) = self.size(solid.radius)?;
        let mut centre = placed.origin;
        let mut halves = [R::ZERO; 3];
        for ((half_size, axis), id) in halves.iter_mut().zip(&axes).zip(solid.sizes) {
            let (size, unknown) = self.size(id)?;
            *half_size = size * half;
            slack += unknown * half;
            if !solid.centred && id.is_some() {
                for (own, entry) in centre.iter_mut().zip(axis) {
                    let step = A::constant(*half_size * *entry);
                    *own = own.plus(step.widened(unknown * half));
                }
            }
        }
        if placed.slack > R::ZERO && !solid.centred {
            let by = chord(placed.slack) * R::norm(halves);
            centre = centre.map(|own| own.widened(by));
        }
        Some(Standing {
            body: Body::new([R::ZERO; 3], axes, halves, radius),
            centre,
            slack,
            turn: placed.slack,
        })
    }
}

/// The vector from one point to another.
pub(super) fn between<R: Real, A: Arithmetic<R>>(
    [x, y, z]: [A; 3],
    [to_x, to_y, to_z]: [A; 3],
) -> [A; 3] {
    [to_x.minus(x), to_y.minus(y), to_z.minus(z)]
}
