//! Left sides that are products and quotients, as laws of physics are: a torque, a stopping
//! distance. Which one holds need not be known, nor what its numbers measure.

use super::derived::{VisitId, sizes};
use super::features::Features;
use super::leaves::shown;
use crate::domain::{Dimension, Domain, Metric, Node, NodeId, Quantity};
use crate::real::Real;
use heapless::Vec;

/// Most numbers of a scene, and most numbers of a sample, that laws are made of.
const MAX_FACTORS: usize = 6;

/// By what a number of a sample is multiplied or divided.
#[derive(Clone, Copy)]
enum Load {
    /// A number of the scene: a mass.
    Single,
    /// The product of two.
    Product,
    /// One divided by another.
    Ratio,
}

/// A law about a number of a sample.
struct Law {
    /// Whether it is about its square.
    squared: bool,
    make: fn(NodeId, NodeId) -> Node,
    load: Load,
}

/// Makes a term of two operands.
const fn law(squared: bool, make: fn(NodeId, NodeId) -> Node, load: Load) -> Law {
    Law {
        squared,
        make,
        load,
    }
}

/// Those that are enumerated, the more frequent ones first.
const LAWS: [Law; 8] = [
    law(false, Node::Product, Load::Single),
    law(false, Node::Product, Load::Product),
    law(true, Node::Quotient, Load::Single),
    law(true, Node::Quotient, Load::Product),
    law(false, Node::Quotient, Load::Single),
    law(true, Node::Product, Load::Single),
    law(false, Node::Product, Load::Ratio),
    law(false, Node::Quotient, Load::Product),
];

impl<R: Real> Features<'_, R> {
    /// Appends laws about distances and parameters, where something in the scene has a number
    /// that is no length: without, sums of scaled lengths say the same.
    pub(super) fn derive_laws(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        let loads = self.loads(domain);
        if loads.is_empty() {
            return;
        }
        let bases = self.bases(domain);
        for law in &LAWS {
            for base in &bases {
                self.derive_law(law, *base, &loads, visit);
            }
        }
    }

    /// The numbers of a scene that laws are made of, plain ones first.
    fn loads(&mut self, domain: &Domain<'_>) -> Vec<NodeId, MAX_FACTORS> {
        let mut loads = Vec::new();
        for wanted in [Dimension::None, Dimension::Length] {
            for (slot, _) in sizes(domain).filter(|(_, own)| *own == wanted) {
                let node = Node::Quantity(Quantity::Attribute(slot));
                if let Some(id) = self.operand(node) {
                    // One of very many.
                    let _ = loads.push(id);
                }
            }
            if loads.is_empty() {
                break;
            }
        }
        loads
    }

    /// The numbers of a sample that laws are about: distances, and parameters.
    fn bases(&mut self, domain: &Domain<'_>) -> Vec<NodeId, MAX_FACTORS> {
        let mut bases = Vec::new();
        let mut offer = |node| {
            if let Some(id) = self.operand(node) {
                let _ = bases.push(id);
            }
        };
        for (b, _) in shown(domain).filter(|(_, p)| p.is_object() && p.member.is_none()) {
            for (a, _) in shown(domain).filter(|(_, p)| p.sampled && p.member.is_none()) {
                let distance = Quantity::Distance(Metric::Straight, a, b);
                offer(Node::Quantity(distance));
            }
        }
        for (index, parameter) in (0u8..).zip(domain.parameters()) {
            if parameter.dimension != Dimension::Angle {
                offer(Node::Parameter(index));
            }
        }
        bases
    }

    /// Appends a law about a number with all numbers of the scene.
    fn derive_law(&mut self, law: &Law, base: NodeId, loads: &[NodeId], visit: VisitId<'_>) {
        let about = match law.squared {
            true => self.operand(Node::Product(base, base)),
            false => Some(base),
        };
        let Some(about) = about else { return };
        for (index, a) in loads.iter().enumerate() {
            let (make, others): (fn(NodeId, NodeId) -> Node, _) = match law.load {
                Load::Single => {
                    self.offer((law.make)(about, *a), visit);
                    continue;
                }
                Load::Product => (Node::Product, loads.get(index + 1..).unwrap_or_default()),
                Load::Ratio => (Node::Quotient, loads),
            };
            for b in others.iter().filter(|b| *b != a) {
                if let Some(load) = self.operand(make(*a, *b)) {
                    self.offer((law.make)(about, load), visit);
                }
            }
        }
    }
}
