//! The features that the grammar makes of a domain, enumerated into a table.

use super::block::{Block, Blocks, block_at, set_block};
use super::leaves::{Visit, attributes, coordinates, relations};
use crate::domain::{Dependence, Dimension, Domain, MAX_FEATURES, Node, NodeId, Sample, Scene};
use crate::error::Error;
use crate::real::Real;
use crate::table::{Table, gather};
use core::ops::Range;
use heapless::Vec;

/// The factors of scaled features (thesis 4.2).
pub const FACTORS: [f64; 5] = [0.25, 0.5, 0.75, 1.25, 1.5];
/// The most complex features that are made.
pub const MAX_COMPLEXITY: usize = 4;

/// The term of a feature.
pub(crate) fn feature_id(index: usize) -> NodeId {
    NodeId(u16::try_from(index).unwrap_or(u16::MAX))
}

/// The features that the grammar makes of a domain (thesis 4.2), simple ones first, and
/// their values at a sample.
///
/// | complexity | features |
/// |---|---|
/// | 1 | attributes, constants, parameters, coordinates of key and sample points, the plain numbers 0.25, 0.5, 0.75, 1, 1.25 and 1.5 |
/// | 2 | distances in 1D, 2D and 3D, angle differences (angles at a point where nothing has a heading), areas; features of complexity 1 scaled by 0.25, 0.5, 0.75, 1.25, 1.5 |
/// | 3 | sums and differences of two features of complexity 1, those of constants first; scaled distances, angles and areas |
/// | 4 | sums and differences of a feature of complexity 1 and one of complexity 2 |
///
/// Features that depend on the sample are *left* sides of hypotheses (`lhs`), the others
/// *right* sides (`rhs`). An action without parameters is sampled by its instances, so all
/// features are left sides. Left sides are neither scaled nor summed: to scale a right
/// side says the same.
///
/// Of a group of objects the grammar has the least and the greatest value over the
/// members, as simple as the value itself, and never that of a single member. Members of
/// groups are not compared with each other. Over no members such a feature is infinite,
/// and what is made of two of them may be NaN: no comparison holds for that.
///
/// ```
/// use critreg::domain::{Dimension, Domain, Node, NodeId};
/// use critreg::grammar::Features;
/// let domain = Domain::parse(
///     "object wall { x: length, y: length }
///      constant margin = 0.25: length
///      parameter reach in [0, 4]: length
///      point hand = world + (reach, 0)",
/// )?;
/// let (mut nodes, mut values) = ([Node::Number(0.0); 200], [0.0; 200]);
/// let features = Features::enumerate(&domain, &mut nodes, &mut values)?;
/// let texts = |features: &Features<f64>, range: std::ops::Range<usize>| {
///     let write = |index: usize| {
///         let mut text = String::new();
///         let id = NodeId(index as u16);
///         domain.write_expression(&mut text, features.nodes(), id).map(|()| text)
///     };
///     range.map(write).collect::<Result<Vec<_>, _>>().unwrap()
/// };
/// let lhs = |complexity| texts(&features, features.lhs(complexity, Dimension::Length));
/// assert_eq!(lhs(1), ["reach", "hand.x", "hand.y"]);
/// assert_eq!(lhs(2), ["dist_x(hand, wall)", "dist_y(hand, wall)", "dist(hand, wall)"]);
/// let rhs = |complexity| texts(&features, features.rhs(complexity, Dimension::Length));
/// assert_eq!(rhs(1), ["margin", "wall.x", "wall.y"]);
/// assert_eq!(rhs(2)[..3], ["0.25*margin", "0.5*margin", "0.75*margin"]);
/// assert_eq!(rhs(3)[..3], ["margin + wall.x", "margin - wall.x", "wall.x - margin"]);
/// # Ok::<(), critreg::Error>(())
/// ```
#[derive(Debug)]
pub struct Features<'m, R> {
    nodes: Table<'m, Node>,
    values: &'m mut [R],
    lhs: Blocks<2>,
    rhs: Blocks<MAX_COMPLEXITY>,
    /// How many of the features may be those of the grammar; the others are derived ones.
    room: usize,
    /// The features that the text declares.
    declared: Vec<Declared, MAX_FEATURES>,
    /// Where the left sides begin.
    first_lhs: usize,
}

/// A feature that the text declares.
#[derive(Clone, Copy, Debug)]
struct Declared {
    /// Where it is in the table.
    id: NodeId,
    dimension: Dimension,
    sampled: bool,
}

impl<'m, R: Real> Features<'m, R> {
    /// Enumerates the features of a domain into borrowed tables of equal length, of which
    /// left sides take a quarter at most. Features that find no room are counted.
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
        let mut features = Features::empty(nodes, values);
        features.fill(domain, complexity, 0)?;
        Ok(features)
    }

    /// A table without features, for [`Features::fill`].
    pub(crate) fn empty(nodes: &'m mut [Node], values: &'m mut [R]) -> Self {
        // An id of a term counts no further.
        let room = nodes.len().min(usize::from(u16::MAX));
        Features {
            nodes: Table::new(nodes.get_mut(..room).unwrap_or_default(), "features"),
            values,
            lhs: Default::default(),
            rhs: Default::default(),
            room,
            declared: Vec::new(),
            first_lhs: 0,
        }
    }

    /// Enumerates the features of a domain up to a complexity, in place, and keeps room
    /// for so many derived ones.
    ///
    /// # Errors
    /// Those of [`Features::enumerate`].
    pub(crate) fn fill(
        &mut self,
        domain: &Domain<'_>,
        complexity: usize,
        derived: usize,
    ) -> Result<(), Error> {
        self.room = self.nodes.capacity().saturating_sub(derived);
        for factor in FACTORS {
            self.nodes.push(Node::Number(factor))?;
        }
        self.declare(domain);
        self.first_lhs = self.nodes.len();
        self.enumerate_lhs(domain);
        self.enumerate_rhs(domain, complexity.min(MAX_COMPLEXITY));
        Ok(())
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
    pub fn lhs(&self, complexity: usize, dimension: Dimension) -> Range<usize> {
        block_at(&self.lhs, complexity, dimension).range()
    }

    /// The right sides of this complexity (from 1) and dimension.
    pub fn rhs(&self, complexity: usize, dimension: Dimension) -> Range<usize> {
        block_at(&self.rhs, complexity, dimension).range()
    }

    /// How many left sides the grammar has, with those that found no room.
    pub fn enumerated_lhs(&self, complexity: usize, dimension: Dimension) -> u64 {
        block_at(&self.lhs, complexity, dimension).enumerated.into()
    }

    /// How many right sides the grammar has, with those that found no room.
    pub fn enumerated_rhs(&self, complexity: usize, dimension: Dimension) -> u64 {
        block_at(&self.rhs, complexity, dimension).enumerated.into()
    }

    /// Computes every feature at a sample, each once.
    pub fn evaluate(&mut self, scene: &Scene<'_, R>, theta: &[R]) {
        evaluate(self.nodes.as_slice(), scene, theta, self.values);
    }

    /// As [`Features::evaluate`], into a table of the caller's.
    pub(crate) fn evaluate_into(&self, scene: &Scene<'_, R>, theta: &[R], values: &mut [R]) {
        evaluate(self.nodes.as_slice(), scene, theta, values);
    }

    /// Where the left sides of the grammar begin: before them are the factors, and what the
    /// features of the text are made of.
    pub(crate) fn first_lhs(&self) -> usize {
        self.first_lhs
    }

    /// Takes the features that the text declares, and what they are made of.
    fn declare(&mut self, domain: &Domain<'_>) {
        for feature in domain.features() {
            let (nodes, term) = (domain.nodes(), feature.term);
            // What has no dimension is compared with plain numbers.
            let dimension = domain.dimension(nodes, term).unwrap_or(Dimension::None);
            let sampled = domain.dependence(nodes, term) == Dependence::Sample;
            if let Some(id) = self.copy_term(nodes, term) {
                let _ = self.declared.push(Declared {
                    id,
                    dimension,
                    sampled,
                });
            }
        }
    }

    /// Puts a term of a list into the table, with its operands; `None` if there is no room.
    fn copy_term(&mut self, nodes: &[Node], id: NodeId) -> Option<NodeId> {
        let node = *nodes.get(usize::from(id.0))?;
        let node = match node.operands() {
            Some((a, b, make)) => make(self.copy_term(nodes, a)?, self.copy_term(nodes, b)?),
            None => node,
        };
        self.operand(node)
    }

    /// The features that the text declares, of the sample or not.
    fn declared(&self, dimension: Dimension, sampled: bool) -> Vec<Node, MAX_FEATURES> {
        let declared = self.declared.iter();
        let own = declared.filter(|own| own.dimension == dimension && own.sampled == sampled);
        gather(own.filter_map(|own| self.nodes().get(usize::from(own.id.0)).copied()))
    }

    fn enumerate_lhs(&mut self, domain: &Domain<'_>) {
        let room = self.room / 4 + self.first_lhs - FACTORS.len();
        for complexity in 1..=2 {
            for dimension in Dimension::ALL {
                let declared = self.declared(dimension, !domain.parameters().is_empty());
                let block = self.append(room, |visit| {
                    each_lhs(domain, &declared, complexity, dimension, visit);
                });
                set_block(&mut self.lhs, complexity, dimension, block);
            }
        }
    }

    /// The first left side of a complexity and dimension behind so many others, kept or not.
    pub(crate) fn lhs_behind(
        &self,
        domain: &Domain<'_>,
        complexity: usize,
        dimension: Dimension,
        others: usize,
    ) -> Option<Node> {
        let declared = self.declared(dimension, !domain.parameters().is_empty());
        let (mut place, mut found) = (0, None);
        each_lhs(domain, &declared, complexity, dimension, &mut |node| {
            if place == others {
                found = Some(node);
            }
            place += 1;
        });
        found
    }

    fn enumerate_rhs(&mut self, domain: &Domain<'_>, most: usize) {
        for complexity in 1..=most {
            for dimension in Dimension::ALL {
                let wanted = (1..=2).any(|c| !self.lhs(c, dimension).is_empty());
                if !wanted {
                    continue;
                }
                let block = match complexity {
                    1 => self.leaves(domain, dimension),
                    2 => self.relations_and_scaled(domain, dimension),
                    3 => self.pairs_and_scaled_relations(domain, dimension),
                    _ => self.mixed_pairs(domain, dimension),
                };
                set_block(&mut self.rhs, complexity, dimension, block);
            }
        }
    }

    fn leaves(&mut self, domain: &Domain<'_>, dimension: Dimension) -> Block {
        let declared = self.declared(dimension, false);
        self.append(usize::MAX, |visit| {
            declared.iter().copied().for_each(&mut *visit);
            for (index, constant) in (0u8..).zip(domain.constants()) {
                if constant.dimension == dimension {
                    visit(Node::Constant(index));
                }
            }
            attributes(domain, dimension, visit);
            coordinates(domain, dimension, false, visit);
            if dimension == Dimension::None {
                for number in FACTORS.into_iter().chain([1.0]) {
                    visit(Node::Number(number));
                }
            }
        })
    }

    fn relations_and_scaled(&mut self, domain: &Domain<'_>, dimension: Dimension) -> Block {
        let mut block = self.append(usize::MAX, |visit| {
            relations(domain, dimension, false, visit);
        });
        self.scale(&mut block, self.rhs(1, dimension));
        let leaves = proper(block_at(&self.rhs, 1, dimension), dimension);
        block.enumerated += FACTORS.len() as u32 * leaves;
        block
    }

    fn pairs_and_scaled_relations(&mut self, domain: &Domain<'_>, dimension: Dimension) -> Block {
        let mut block = Block::behind(self.nodes.len());
        let leaves = self.rhs(1, dimension);
        for b in leaves.clone() {
            for a in leaves.start..b {
                self.combine(&mut block, a, b, Node::Sum);
                self.combine(&mut block, a, b, Node::Difference);
                self.combine(&mut block, b, a, Node::Difference);
            }
        }
        let relations = count_relations(domain, dimension);
        let first = self.rhs(2, dimension).start;
        let kept = self.rhs(2, dimension).len().min(relations as usize);
        self.scale(&mut block, first..first + kept);
        let leaves = proper(block_at(&self.rhs, 1, dimension), dimension);
        let pairs = leaves * leaves.saturating_sub(1) / 2;
        block.enumerated = FACTORS.len() as u32 * relations + 3 * pairs;
        block
    }

    fn mixed_pairs(&mut self, domain: &Domain<'_>, dimension: Dimension) -> Block {
        let mut block = Block::behind(self.nodes.len());
        for b in self.rhs(2, dimension) {
            for a in self.rhs(1, dimension) {
                if self.is_scaled_from(b, a) {
                    continue;
                }
                self.combine(&mut block, a, b, Node::Sum);
                self.combine(&mut block, a, b, Node::Difference);
                self.combine(&mut block, b, a, Node::Difference);
            }
        }
        let leaves = proper(block_at(&self.rhs, 1, dimension), dimension);
        let relations = count_relations(domain, dimension);
        let scaled = FACTORS.len() as u32 * leaves.saturating_sub(1);
        block.enumerated = 3 * leaves * (relations + scaled);
        block
    }

    /// Appends features while there are fewer than `room`, and counts all of them.
    fn append(&mut self, room: usize, each: impl FnOnce(Visit<'_>)) -> Block {
        let mut block = Block::behind(self.nodes.len());
        each(&mut |node| {
            block.enumerated += 1;
            if self.nodes.len() < room.min(self.room) && self.nodes.push(node).is_ok() {
                block.kept += 1;
            }
        });
        block
    }

    /// Appends a term behind the features of the grammar, if there is room.
    pub(super) fn append_node(&mut self, node: Node) -> Option<NodeId> {
        let id = feature_id(self.nodes.len());
        self.nodes.push(node).is_ok().then_some(id)
    }

    /// Appends the features of a range, scaled by each factor, except plain numbers.
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
        if self.nodes.len() < self.room && self.nodes.push(node).is_ok() {
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

#[inline(never)]
fn evaluate<R: Real>(nodes: &[Node], scene: &Scene<'_, R>, theta: &[R], values: &mut [R]) {
    let mut sample: Sample<'_, '_, R, R> = Sample::blank(scene, theta);
    sample.place_points();
    for (index, node) in nodes.iter().enumerate() {
        let known = &*values;
        let operand = |id: NodeId| known.get(usize::from(id.0)).copied().unwrap_or(R::ZERO);
        let value = sample.node(*node, operand);
        if let Some(slot) = values.get_mut(index) {
            *slot = value;
        }
    }
}

/// Visits the left sides of a complexity and dimension, of which some are declared.
fn each_lhs(
    domain: &Domain<'_>,
    declared: &[Node],
    complexity: usize,
    dimension: Dimension,
    visit: Visit<'_>,
) {
    let sampled = !domain.parameters().is_empty();
    if complexity == 1 {
        declared.iter().copied().for_each(&mut *visit);
    }
    if domain.compares() {
        return;
    }
    if complexity == 2 {
        return relations(domain, dimension, sampled, visit);
    }
    for (index, parameter) in (0u8..).zip(domain.parameters()) {
        if parameter.dimension == dimension {
            visit(Node::Parameter(index));
        }
    }
    if !sampled {
        attributes(domain, dimension, visit);
    }
    coordinates(domain, dimension, sampled, visit);
}

/// How many features of a block of complexity 1 are not plain numbers.
fn proper(block: Block, dimension: Dimension) -> u32 {
    let numbers = match dimension {
        Dimension::None => FACTORS.len() as u32 + 1,
        _ => 0,
    };
    block.enumerated.saturating_sub(numbers)
}

/// How many distances, angles or areas there are between things of an instance.
fn count_relations(domain: &Domain<'_>, dimension: Dimension) -> u32 {
    let mut count = 0;
    relations(domain, dimension, false, &mut |_| count += 1);
    count
}
