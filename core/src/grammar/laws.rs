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

/// How many of [`LAWS`] are products, the first ones.
const PRODUCTS: usize = 2;

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
    /// that is no length: without, sums of scaled lengths say the same. Where only a constant
    /// is none, parameters make areas and volumes.
    pub(super) fn derive_laws(&mut self, domain: &Domain<'_>, visit: VisitId<'_>) {
        let scene_is_plain = sizes(domain).any(|(_, own)| own == Dimension::None);
        let constants = domain.constants().iter().map(|own| own.dimension);
        let mut known = sizes(domain).map(|(_, own)| own).chain(constants);
        let laws = if scene_is_plain {
            &LAWS[..]
        } else if known.any(|own| matches!(own, Dimension::None | Dimension::Area)) {
            &LAWS[..PRODUCTS]
        } else {
            return;
        };
        let loads = self.loads(domain);
        let bases = self.bases(domain, scene_is_plain);
        for law in laws {
            for base in &bases {
                self.derive_law(law, *base, &loads, visit);
            }
        }
    }

    /// The numbers of a scene that laws are made of, plain ones first.
    fn loads(&mut self, domain: &Domain<'_>) -> Vec<NodeId, MAX_FACTORS> {
        let mut loads = Vec::new();
        for wanted in [Dimension::None, Dimension::Length, Dimension::Area] {
            for (slot, _) in sizes(domain).filter(|(_, own)| *own == wanted) {
                let node = Node::Quantity(Quantity::Attribute(slot));
                if let Some(id) = self.operand(node) {
                    // One of very many.
                    let _ = loads.push(id);
                }
            }
        }
        loads
    }

    /// The numbers of a sample that laws are about: distances, if wanted, and parameters.
    fn bases(&mut self, domain: &Domain<'_>, distances: bool) -> Vec<NodeId, MAX_FACTORS> {
        let mut bases = Vec::new();
        let mut offer = |node| {
            if let Some(id) = self.operand(node) {
                let _ = bases.push(id);
            }
        };
        let objects = shown(domain).filter(|(_, p)| p.is_object() && p.member.is_none());
        for (b, _) in objects.filter(|_| distances) {
            for (a, _) in shown(domain).filter(|(_, p)| p.sampled && p.member.is_none()) {
                let distance = Quantity::Distance(Metric::Straight, a, b);
                offer(Node::Quantity(distance));
            }
        }
        for (index, parameter) in (0u8..).zip(domain.parameters()) {
            if parameter.dimension != Dimension::Angle || !domain.turns_points(index) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::text::Lexer;
    use heapless::Vec as Nodes;
    use std::string::String;
    use std::vec::Vec;

    /// The left sides that are derived of a domain, as texts that are read as what they are.
    fn derived(domain: &str) -> Vec<String> {
        let domain = Domain::parse(domain).unwrap();
        let mut nodes = [Node::Number(0.0); 400];
        let mut features = Features::<f64>::empty(&mut nodes, &mut []);
        features.fill(&domain, 2, 256).unwrap();
        let mut found = Vec::new();
        features.derive(&domain, &mut |id| found.push(id));
        let text = |id: NodeId| {
            let mut text = String::new();
            domain
                .write_expression(&mut text, features.nodes(), id)
                .unwrap();
            let mut read: Nodes<Node, 16> = Nodes::new();
            let mut lexer = Lexer::new(&text);
            let own = domain.parse_expression(&mut lexer, &mut read).expect(&text);
            assert!(
                crate::domain::is_same(features.nodes(), id, &read, own),
                "{text}"
            );
            text
        };
        found.into_iter().map(text).collect()
    }

    fn has(domain: &str, wanted: &[&str]) {
        let derived = derived(domain);
        for text in wanted {
            assert!(
                derived.iter().any(|own| own == text),
                "{text}: {derived:#?}"
            );
        }
    }

    #[test]
    fn laws_are_said_whatever_their_factors_measure() {
        has(
            "object bin { width: length, depth: length, height: length }
             object bag { volume: none }
             parameter level in [0, 0.6]: length",
            &["level*(bin.width*bin.depth)", "level*level*bin.width"],
        );
        has(
            "object bin { base: area } object bag { volume: none }
             parameter level in [0, 0.6]: length",
            &["level*bin.base", "level*level/bin.base"],
        );
        has(
            "object spring { stiffness: none, breaks: angle } object lid { weight: none }
             parameter twist in [0, 3]: angle",
            &[
                "twist*(spring.stiffness/lid.weight)",
                "twist*twist*lid.weight",
            ],
        );
    }

    #[test]
    fn an_angle_that_turns_no_point_makes_arcs() {
        let drum = "object drum { radius: length } parameter turn in [0, 25]: angle";
        has(drum, &["turn*drum.radius"]);
        let turned = std::format!("{drum} point hand = world turned turn + (1, 0)");
        let derived = derived(&turned);
        assert!(
            !derived.iter().any(|own| own.contains("turn*")),
            "{derived:?}"
        );
    }

    #[test]
    fn without_plain_numbers_there_are_volumes_only_to_compare_with_one() {
        let bin = "object bin { width: length, depth: length }
            parameter level in [0, 0.6]: length";
        let law = "level*(bin.width*bin.depth)";
        assert!(!derived(bin).iter().any(|own| own == law));
        has(&std::format!("{bin} constant volume = 0.04: none"), &[law]);
        has(&std::format!("{bin} object lid {{ base: area }}"), &[law]);
    }
}
