//! Left sides of forms.

use super::{DIMENSIONS, Forms};
use crate::domain::{Dependence, Dimension, Domain, Node, NodeId};
use crate::error::Error;
use crate::grammar::{Kind, feature_id};
use crate::real::Real;
use crate::table::Blank;

/// How a left side came to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tier {
    /// It is a feature of the grammar.
    Plain,
    /// It depends on the instance only: a condition on the scene.
    Scene,
    /// It is derived from features.
    Derived,
}

/// What of the grammar found no room: left sides of forms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftOut {
    /// How many there are.
    pub count: u32,
    /// The first of them, if it is a term without operands.
    pub first: Option<Node>,
}

/// A left side of forms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Left {
    pub(super) feature: u16,
    pub(super) kind: Kind,
    pub(super) tier: Tier,
}

impl Blank for Left {
    const BLANK: Self = Left {
        feature: 0,
        kind: Kind::Other,
        tier: Tier::Plain,
    };
}

impl<R: Real> Forms<'_, R> {
    /// Takes the left sides of the grammar, those of a dimension and complexity together.
    pub(super) fn add_plain_lefts(&mut self, domain: &Domain<'_>) -> Result<(), Error> {
        let room = self.lhs_room;
        for index in 0..DIMENSIONS * 2 {
            let Some(dimension) = Dimension::ALL.get(index % DIMENSIONS) else {
                continue;
            };
            let complexity = index / DIMENSIONS;
            let range = self.features.lhs(complexity + 1, *dimension);
            // Left sides stand together.
            let start = range.start.saturating_sub(self.features.first_lhs());
            let len = range.len().min(room.saturating_sub(start));
            for feature in range.take(len) {
                self.add_left(domain, feature_id(feature), Tier::Plain)?;
            }
            let all = self.features.enumerated_lhs(complexity + 1, *dimension);
            let lost = u32::try_from(all).unwrap_or(u32::MAX) - len as u32;
            self.layout
                .set_lhs(complexity, *dimension, start..start + len, lost);
        }
        Ok(())
    }

    /// How many left sides of the grammar found no room, and the first of them.
    pub(in super::super) fn lefts_left_out(&self, domain: &Domain<'_>) -> Option<LeftOut> {
        let (mut count, mut first) = (0, None);
        for complexity in 0..2 {
            for dimension in Dimension::ALL {
                let kept = self.layout.lhs_count(complexity, dimension);
                let all = self.features.enumerated_lhs(complexity + 1, dimension);
                let lost = u32::try_from(all).unwrap_or(u32::MAX) - kept as u32;
                if lost > 0 && first.is_none() {
                    let features = &self.features;
                    first = features.lhs_behind(domain, complexity + 1, dimension, kept);
                }
                count += lost;
            }
        }
        let first = first.filter(|node| node.operands().is_none());
        (count > 0).then_some(LeftOut { count, first })
    }

    /// Takes those that are derived, as far as there is room for them.
    pub(super) fn add_derived_lefts(&mut self, domain: &Domain<'_>) {
        if self.sums.capacity() == 0 {
            return;
        }
        let mut ids: heapless::Vec<NodeId, { super::MAX_LHS }> = heapless::Vec::new();
        self.features.derive(domain, &mut |id| {
            let _ = ids.push(id);
        });
        for id in ids {
            let tier = match domain.dependence(self.features.nodes(), id) {
                Dependence::Sample => Tier::Derived,
                Dependence::Constant | Dependence::Instance => Tier::Scene,
            };
            // One without room is left out.
            let _ = self.add_left(domain, id, tier);
        }
    }

    fn add_left(&mut self, domain: &Domain<'_>, id: NodeId, tier: Tier) -> Result<(), Error> {
        self.lefts.push(Left {
            feature: id.0,
            kind: Kind::of(domain, self.features.nodes(), id),
            tier,
        })
    }

    /// The left side of a form, by its place.
    pub(super) fn left(&self, lhs: usize) -> Option<&Left> {
        self.lefts.as_slice().get(lhs)
    }
}
