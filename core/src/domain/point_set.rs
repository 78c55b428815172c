//! Sets of points: those that a region or a learner needs.

use super::declarations::{Base, Point, PoseSlots};
use super::node::Node;
use super::schema::{Domain, MAX_POINTS};

/// A set of points of a domain, with all points that these are placed in. Points that
/// move with a parameter are kept apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PointSet {
    pub(super) fixed: Bits,
    pub(super) sampled: Bits,
}

impl PointSet {
    /// No points.
    pub(crate) const EMPTY: PointSet = PointSet {
        fixed: Bits::NONE,
        sampled: Bits::NONE,
    };

    /// All points of a domain.
    pub fn all(domain: &Domain<'_>) -> PointSet {
        (0u8..)
            .zip(domain.points())
            .fold(PointSet::default(), |set, (i, _)| set.with(domain, i))
    }

    /// The points that a list of nodes depends on; for a group, those of all members.
    pub fn of(domain: &Domain<'_>, nodes: &[Node]) -> PointSet {
        let mut set = PointSet::default();
        for node in nodes {
            domain.quantities(*node, &mut |quantity| {
                for point in quantity.points().iter().flatten() {
                    set = set.with(domain, *point);
                }
            });
        }
        set
    }

    /// A bit for each parameter that these points or a list of nodes depend on.
    pub(crate) fn parameters(self, domain: &Domain<'_>, nodes: &[Node]) -> u32 {
        let own = nodes
            .iter()
            .fold(0, |bits, node| bits | domain.parameters_of_leaf(*node));
        let points = self.fixed.iter().chain(self.sampled.iter());
        let points = points.filter_map(|p| domain.points().get(usize::from(p)));
        let placed = points.flat_map(|p| p.turn.into_iter().chain(p.offset).flatten());
        placed.fold(own, |bits, term| {
            bits | domain.parameters_of(domain.nodes(), term)
        })
    }

    /// Whether these points or a list of nodes depend on a number of an instance.
    pub(crate) fn reads(self, domain: &Domain<'_>, nodes: &[Node], slot: u8) -> bool {
        let places = |point: &Point<'_>| {
            let pose = match point.base {
                Base::Object(object) => *domain.pose_slots(object),
                Base::World | Base::Point(_) => PoseSlots::default(),
            };
            let mut pose = pose.position.into_iter().chain(pose.angles);
            let mut moved = point.turn.into_iter().chain(point.offset).flatten();
            pose.any(|own| own == Some(slot))
                || moved.any(|term| domain.reads(domain.nodes(), term, slot))
        };
        let points = self.fixed.iter().chain(self.sampled.iter());
        let mut points = points.filter_map(|p| domain.points().get(usize::from(p)));
        nodes.iter().any(|node| domain.is_about(*node, slot)) || points.any(places)
    }

    fn with(mut self, domain: &Domain<'_>, point: u8) -> PointSet {
        let mut next = Some(point);
        while let Some(index) = next.take() {
            let Some(point) = domain.points().get(usize::from(index)) else {
                break;
            };
            if point.sampled {
                self.sampled.insert(index);
            } else {
                self.fixed.insert(index);
            }
            if let Base::Point(base) = point.base {
                next = Some(base);
            }
        }
        self
    }
}

/// Indices of points: a bit each, in words that a microcontroller counts in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Bits([u32; 2]);

const _: () = assert!(MAX_POINTS <= 64, "there is a bit per point");

impl Bits {
    pub(super) const NONE: Bits = Bits([0; 2]);

    pub(super) fn insert(&mut self, point: u8) {
        if let Some(word) = self.0.get_mut(usize::from(point / 32)) {
            *word |= 1 << (point % 32);
        }
    }

    /// All of them, ascending.
    pub(super) fn iter(self) -> impl Iterator<Item = u8> {
        let [mut low, mut high] = self.0;
        core::iter::from_fn(move || {
            let (left, first) = if low != 0 {
                (&mut low, 0)
            } else if high != 0 {
                (&mut high, 32)
            } else {
                return None;
            };
            let next = left.trailing_zeros();
            *left &= left.wrapping_sub(1);
            Some((first + next) as u8)
        })
    }

    pub(super) fn has(self, point: u8) -> bool {
        let [low, high] = self.0;
        let word = match point {
            0..32 => low,
            32..64 => high,
            _ => 0,
        };
        word >> (point % 32) & 1 == 1
    }

    /// How many of them are below `point`.
    pub(super) fn rank(self, point: u8) -> usize {
        let [low, high] = self.0;
        let below = (1u32 << (point % 32)) - 1;
        let count = if point < 32 {
            (low & below).count_ones()
        } else {
            low.count_ones() + (high & below).count_ones()
        };
        count as usize
    }
}
