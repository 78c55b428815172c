//! The features that the grammar makes of a domain (thesis 4.2), simple ones first.
//!
//! | complexity | features |
//! |---|---|
//! | 1 | attributes, constants, parameters, coordinates of key and sample points, the plain numbers 0.25, 0.5, 0.75, 1, 1.25 and 1.5 |
//! | 2 | distances in 1D, 2D and 3D, angle differences (angles at a point where nothing has a heading), areas; features of complexity 1 scaled by 0.25, 0.5, 0.75, 1.25, 1.5 |
//! | 3 | sums and differences of two features of complexity 1, those of constants first; scaled distances, angles and areas |
//! | 4 | sums and differences of a feature of complexity 1 and one of complexity 2 |
//!
//! Of a group of objects no single member is spoken of, but the least and the
//! greatest value over its members, as simple as the value itself. Members of groups
//! are not compared with each other. Over no members such a feature is infinite, and
//! what is made of two of them may be NaN: no comparison holds for that.
//!
//! Features that depend on the sample are *left* sides of hypotheses, the others
//! *right* sides. An action without parameters is sampled by its instances, so all
//! features are left sides. Scaled and summed left sides are left out: scaling a right side
//! says the same.

use super::hypotheses::feature_id;
use crate::domain::{
    Coordinate, Dimension, Domain, Extreme, Metric, Node, NodeId, Point, Relation, Sample, Scene,
};
use crate::error::Error;
use crate::real::Real;
use crate::table::Table;
use core::ops::Range;

/// The factors of scaled features (thesis 4.2).
pub const FACTORS: [f64; 5] = [0.25, 0.5, 0.75, 1.25, 1.5];
/// The most complex features that are made.
pub const MAX_COMPLEXITY: usize = 4;

const DIMENSIONS: usize = Dimension::ALL.len();

/// Features of one complexity and dimension, which stand together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Block {
    start: usize,
    kept: usize,
    /// How many the grammar has, also those that found no room.
    enumerated: u64,
}

impl Block {
    fn range(&self) -> Range<usize> {
        self.start..self.start + self.kept
    }
}

type Blocks = [[Block; DIMENSIONS]; MAX_COMPLEXITY];

/// The features of a domain in order of complexity, and their values at a sample.
#[derive(Debug)]
pub struct Features<'m, R> {
    nodes: Table<'m, Node>,
    values: &'m mut [R],
    lefts: Blocks,
    rights: Blocks,
}

impl<'m, R: Real> Features<'m, R> {
    /// Enumerates the features of a domain into borrowed tables of equal length,
    /// of which a quarter at most is used for left sides. What finds no room is
    /// counted.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there is not even room for the factors.
    pub fn enumerate(
        domain: &Domain<'_>,
        nodes: &'m mut [Node],
        values: &'m mut [R],
    ) -> Result<Self, Error> {
        Self::enumerate_up_to(domain, MAX_COMPLEXITY, nodes, values)
    }

    /// As [`Features::enumerate`], without features of a higher complexity.
    ///
    /// # Errors
    /// Those of [`Features::enumerate`].
    pub fn enumerate_up_to(
        domain: &Domain<'_>,
        complexity: usize,
        nodes: &'m mut [Node],
        values: &'m mut [R],
    ) -> Result<Self, Error> {
        let mut features = Features {
            nodes: Table::new(nodes, "features"),
            values,
            lefts: Blocks::default(),
            rights: Blocks::default(),
        };
        for factor in FACTORS {
            features.nodes.push(Node::Number(factor))?;
        }
        features.enumerate_lefts(domain);
        features.enumerate_rights(domain, complexity.min(MAX_COMPLEXITY));
        Ok(features)
    }

    /// How many features are kept.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The features as terms; the operands of one stand before it.
    pub fn nodes(&self) -> &[Node] {
        self.nodes.as_slice()
    }

    /// The values at the sample of the last evaluation, one per feature; infinite or
    /// NaN for some of those about a group without members in the instance.
    pub fn values(&self) -> &[R] {
        self.values.get(..self.nodes.len()).unwrap_or(&[])
    }

    /// The left sides of this complexity (from 1) and dimension, as a range of
    /// features.
    pub fn lefts(&self, complexity: usize, dimension: Dimension) -> Range<usize> {
        block_at(&self.lefts, complexity, dimension).range()
    }

    /// The right sides of this complexity (from 1) and dimension.
    pub fn rights(&self, complexity: usize, dimension: Dimension) -> Range<usize> {
        block_at(&self.rights, complexity, dimension).range()
    }

    /// How many left sides the grammar has, with those that found no room.
    pub fn enumerated_lefts(&self, complexity: usize, dimension: Dimension) -> u64 {
        block_at(&self.lefts, complexity, dimension).enumerated
    }

    /// How many right sides the grammar has, with those that found no room.
    pub fn enumerated_rights(&self, complexity: usize, dimension: Dimension) -> u64 {
        block_at(&self.rights, complexity, dimension).enumerated
    }

    /// Computes every feature at a sample, each once.
    pub fn evaluate(&mut self, scene: &Scene<'_, R>, theta: &[R]) {
        evaluate(self.nodes.as_slice(), scene, theta, self.values);
    }

    /// As [`Features::evaluate`], into a table of the caller's.
    pub(crate) fn evaluate_into(&self, scene: &Scene<'_, R>, theta: &[R], values: &mut [R]) {
        evaluate(self.nodes.as_slice(), scene, theta, values);
    }

    fn enumerate_lefts(&mut self, domain: &Domain<'_>) {
        let room = self.nodes.capacity() / 4;
        let sampled = !domain.parameters().is_empty();
        for dimension in Dimension::ALL {
            let parameters = (0u8..).zip(domain.parameters());
            let own = parameters.filter(|(_, p)| p.dimension == dimension);
            let nodes = own.map(|(i, _)| Node::Parameter(i));
            let state = attributes(domain, dimension).filter(|_| !sampled);
            let nodes = nodes.chain(state);
            let nodes = nodes.chain(coordinates(domain, dimension, sampled));
            let block = self.append(nodes, room);
            set_block(&mut self.lefts, 1, dimension, block);
        }
        for dimension in Dimension::ALL {
            let block = self.append(relations(domain, dimension, sampled), room);
            set_block(&mut self.lefts, 2, dimension, block);
        }
    }

    fn enumerate_rights(&mut self, domain: &Domain<'_>, most: usize) {
        for complexity in 1..=most {
            for dimension in Dimension::ALL {
                let wanted = (1..=2).any(|c| !self.lefts(c, dimension).is_empty());
                if !wanted {
                    continue;
                }
                let block = match complexity {
                    1 => self.leaves(domain, dimension),
                    2 => self.relations_and_scaled(domain, dimension),
                    3 => self.pairs_and_scaled_relations(domain, dimension),
                    _ => self.mixed_pairs(domain, dimension),
                };
                set_block(&mut self.rights, complexity, dimension, block);
            }
        }
    }

    fn leaves(&mut self, domain: &Domain<'_>, dimension: Dimension) -> Block {
        let numbers = FACTORS.into_iter().chain([1.0]);
        let plain = dimension == Dimension::None;
        let numbers = numbers.filter(|_| plain).map(Node::Number);
        let constants = (0u8..).zip(domain.constants());
        let constants = constants.filter(|(_, c)| c.dimension == dimension);
        let nodes = constants
            .map(|(i, _)| Node::Constant(i))
            .chain(attributes(domain, dimension))
            .chain(coordinates(domain, dimension, false))
            .chain(numbers);
        self.append(nodes, usize::MAX)
    }

    fn relations_and_scaled(&mut self, domain: &Domain<'_>, dimension: Dimension) -> Block {
        let mut block = self.append(relations(domain, dimension, false), usize::MAX);
        self.scale(&mut block, self.rights(1, dimension));
        let leaves = proper(block_at(&self.rights, 1, dimension), dimension);
        block.enumerated += FACTORS.len() as u64 * leaves;
        block
    }

    fn pairs_and_scaled_relations(&mut self, domain: &Domain<'_>, dimension: Dimension) -> Block {
        let mut block = Block {
            start: self.nodes.len(),
            ..Block::default()
        };
        let leaves = self.rights(1, dimension);
        for b in leaves.clone() {
            for a in leaves.start..b {
                self.combine(&mut block, a, b, Node::Sum);
                self.combine(&mut block, a, b, Node::Difference);
                self.combine(&mut block, b, a, Node::Difference);
            }
        }
        let relations = relations(domain, dimension, false).count();
        let first = self.rights(2, dimension).start;
        let kept = self.rights(2, dimension).len().min(relations);
        self.scale(&mut block, first..first + kept);
        let leaves = proper(block_at(&self.rights, 1, dimension), dimension);
        let pairs = leaves * leaves.saturating_sub(1) / 2;
        block.enumerated = FACTORS.len() as u64 * relations as u64 + 3 * pairs;
        block
    }

    fn mixed_pairs(&mut self, domain: &Domain<'_>, dimension: Dimension) -> Block {
        let mut block = Block {
            start: self.nodes.len(),
            ..Block::default()
        };
        for b in self.rights(2, dimension) {
            for a in self.rights(1, dimension) {
                if self.is_scaled_from(b, a) {
                    continue;
                }
                self.combine(&mut block, a, b, Node::Sum);
                self.combine(&mut block, a, b, Node::Difference);
                self.combine(&mut block, b, a, Node::Difference);
            }
        }
        let leaves = proper(block_at(&self.rights, 1, dimension), dimension);
        let relations = relations(domain, dimension, false).count() as u64;
        let scaled = FACTORS.len() as u64 * leaves.saturating_sub(1);
        block.enumerated = 3 * leaves * (relations + scaled);
        block
    }

    /// Appends what fits and counts all.
    fn append(&mut self, nodes: impl Iterator<Item = Node>, room: usize) -> Block {
        let mut block = Block {
            start: self.nodes.len(),
            ..Block::default()
        };
        for node in nodes {
            block.enumerated += 1;
            if self.nodes.len() < room && self.nodes.push(node).is_ok() {
                block.kept += 1;
            }
        }
        block
    }

    /// Appends the features of a range, scaled by each factor; numbers are not.
    fn scale(&mut self, block: &mut Block, range: Range<usize>) {
        for index in range {
            // The factors are the first features of the table.
            for factor in 0..FACTORS.len() {
                if !self.is_number(index) {
                    self.push(block, Node::Product(feature_id(factor), feature_id(index)));
                }
            }
        }
    }

    fn combine(&mut self, block: &mut Block, a: usize, b: usize, make: fn(NodeId, NodeId) -> Node) {
        if !self.is_number(a) && !self.is_number(b) {
            self.push(block, make(feature_id(a), feature_id(b)));
        }
    }

    fn push(&mut self, block: &mut Block, node: Node) {
        if self.nodes.push(node).is_ok() {
            block.kept += 1;
        }
    }

    fn is_number(&self, index: usize) -> bool {
        matches!(self.nodes().get(index), Some(Node::Number(_)))
    }

    fn is_scaled_from(&self, scaled: usize, leaf: usize) -> bool {
        matches!(self.nodes().get(scaled), Some(Node::Product(_, of)) if *of == feature_id(leaf))
    }
}

fn evaluate<R: Real>(nodes: &[Node], scene: &Scene<'_, R>, theta: &[R], values: &mut [R]) {
    let sample: Sample<'_, '_, R, R> = scene.sample(theta);
    for (index, node) in nodes.iter().enumerate() {
        let known = &*values;
        let operand = |id: NodeId| known.get(usize::from(id.0)).copied().unwrap_or(R::ZERO);
        let value = sample.node(*node, operand);
        if let Some(slot) = values.get_mut(index) {
            *slot = value;
        }
    }
}

fn block_at(blocks: &Blocks, complexity: usize, dimension: Dimension) -> Block {
    let row = complexity.checked_sub(1).and_then(|c| blocks.get(c));
    let block = row.and_then(|row| row.get(dimension as usize));
    block.copied().unwrap_or_default()
}

fn set_block(blocks: &mut Blocks, complexity: usize, dimension: Dimension, block: Block) {
    let row = complexity.checked_sub(1).and_then(|c| blocks.get_mut(c));
    if let Some(slot) = row.and_then(|row| row.get_mut(dimension as usize)) {
        *slot = block;
    }
}

/// How many features of a block of complexity 1 are no plain numbers.
fn proper(block: Block, dimension: Dimension) -> u64 {
    let numbers = match dimension {
        Dimension::None => FACTORS.len() as u64 + 1,
        _ => 0,
    };
    block.enumerated.saturating_sub(numbers)
}

/// How the grammar says a term: as it is, or, if it is about a group, as the extremes
/// over it. The first member stands for all.
fn said(domain: &Domain<'_>, term: Node) -> impl Iterator<Item = Node> + use<> {
    let members = domain.members_in(term);
    let mut members = members.iter().flatten();
    let (plain, quantified) = match (members.next(), members.next()) {
        (None, _) => (Some(term), None),
        (Some(member), None) if member.index == 0 => (None, Relation::of(term)),
        _ => (None, None),
    };
    let extremes = quantified
        .into_iter()
        .flat_map(|relation| Extreme::ALL.map(|extreme| Node::Extreme(extreme, relation)));
    plain.into_iter().chain(extremes)
}

/// The attributes of objects.
fn attributes<'d>(domain: &'d Domain<'_>, dimension: Dimension) -> impl Iterator<Item = Node> + 'd {
    let slots = (0u8..).zip(domain.slots());
    let own = slots.filter(move |(_, (_, attribute))| attribute.dimension == dimension);
    own.flat_map(|(i, _)| said(domain, Node::Attribute(i)))
}

/// The coordinates of sample points, or of key points. Those of an object are
/// its attributes.
fn coordinates<'d>(
    domain: &'d Domain<'_>,
    dimension: Dimension,
    sampled: bool,
) -> impl Iterator<Item = Node> + 'd {
    let axes: &[Coordinate] = match (dimension, domain.axes()) {
        (Dimension::Length, 1) => &[Coordinate::X],
        (Dimension::Length, 2) => &[Coordinate::X, Coordinate::Y],
        (Dimension::Length, _) => &[Coordinate::X, Coordinate::Y, Coordinate::Z],
        (Dimension::Angle, _) => &[Coordinate::Theta],
        _ => &[],
    };
    let points = (0u8..).zip(domain.points());
    let own = points.filter(move |(_, p)| p.sampled == sampled && !p.is_object());
    own.flat_map(move |(index, point)| {
        let axes = axes.iter().copied();
        let turning = axes.filter(|axis| *axis != Coordinate::Theta || point.turn != [None; 3]);
        turning.flat_map(move |axis| said(domain, Node::Coordinate(axis, index)))
    })
}

/// Angles at a vertex between the directions to two other points, of the sample or not:
/// where nothing has a heading, they are the angles that there are. Key points are left
/// out, because they lie in the directions of their objects.
fn vertex_angles<'d>(domain: &'d Domain<'_>, sampled: bool) -> impl Iterator<Item = Node> + 'd {
    let headed = domain.has_headings();
    let all = (0u8..).zip(domain.points()).filter(move |_| !headed);
    let points = all.filter(|(_, p)| p.is_object() || p.sampled);
    let vertices = points.clone();
    vertices.flat_map(move |(vertex, at)| {
        let ends = points.clone().filter(move |(index, _)| *index != vertex);
        ends.clone().flat_map(move |(a, first)| {
            let others = ends.clone().take_while(move |(index, _)| *index < a);
            let wanted = move |second: &Point<'_>| {
                (at.sampled || first.sampled || second.sampled) == sampled
            };
            let others = others.filter(move |(_, second)| wanted(second));
            others.map(move |(b, _)| Node::VertexAngle(a, vertex, b))
        })
    })
}

/// Distances, angle differences and areas, of the sample or not.
fn relations<'d>(
    domain: &'d Domain<'_>,
    dimension: Dimension,
    sampled: bool,
) -> impl Iterator<Item = Node> + 'd {
    let metrics: &[Metric] = match (dimension, domain.axes()) {
        // On a line there is one way to measure.
        (Dimension::Length, 1) => &[Metric::Straight],
        (Dimension::Length, 2) => &[Metric::X, Metric::Y, Metric::Straight],
        (Dimension::Length, _) => &[Metric::X, Metric::Y, Metric::Z, Metric::Straight],
        _ => &[],
    };
    let angles = dimension == Dimension::Angle;
    let shapes = match dimension {
        Dimension::Area if !sampled => domain.shapes().len(),
        _ => 0,
    };
    let points = domain.points();
    let pairs = (0u8..).zip(points).flat_map(move |(a, first)| {
        let others = (0u8..).zip(points).take(usize::from(a));
        others.filter_map(move |(b, second)| {
            let wanted = (first.sampled || second.sampled) == sampled;
            wanted.then_some(((a, first), (b, second)))
        })
    });
    // The sample point first, as one would say it.
    let ordered = pairs.map(|((a, first), (b, second))| {
        if second.sampled && !first.sampled {
            ((b, second), (a, first))
        } else {
            ((a, first), (b, second))
        }
    });
    let nodes = ordered.flat_map(move |((a, first), (b, second))| {
        let distances = metrics.iter().map(move |m| Node::Distance(*m, a, b));
        let turned = angles && first.has_heading() && second.has_heading();
        distances.chain(turned.then_some(Node::Angle(a, b)))
    });
    let nodes = nodes.chain(vertex_angles(domain, sampled).filter(move |_| angles));
    let said = nodes.flat_map(|term| said(domain, term));
    said.chain((0u8..).take(shapes).map(Node::Area))
}
