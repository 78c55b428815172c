//! Right sides that are sums: which there are, and what it takes to name them.

use super::left::{Left, Tier};
use super::sums::{TERMS, Term};
use super::{Forms, NOTHING};
use crate::domain::{Dimension, Domain, Node, NodeId, Quantity};
use crate::grammar::Kind;
use crate::real::Real;
use heapless::Vec;

/// Most columns that terms are made of.
const MAX_COLUMNS: usize = 24;
/// Most places that a right side begins with.
const MAX_BASES: usize = 12;
/// Into how many parts the right sides of a left side are divided: for each column those with
/// it alone, then those where another one follows it.
pub(super) const PARTS: usize = 2 * MAX_COLUMNS;

/// Most sizes in a right side.
const SIZES: usize = 3;
/// Sums of three are only looked for among so many attributes at most.
const MOST_OF_THREE: usize = 8;

/// How far the search goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in super::super) enum Effort {
    /// Two terms with simple factors.
    Simple,
    /// Two terms with all factors of the grammar, one with any factor in hundredths, or three
    /// with simple ones.
    Thorough,
}

/// A factor in hundredths, and what it takes to name it, in bits.
const FACTORS: [(i16, f32); 7] = [
    (100, 1.0),
    (50, 2.0),
    (200, 3.5),
    (25, 4.0),
    (75, 4.0),
    (150, 4.0),
    (125, 4.5),
];
/// How many of them are simple.
const SIMPLE: usize = 2;
/// The same for any other factor: a multiple of one twentieth, or of one hundredth.
const TWENTIETHS: f32 = 7.5;
const HUNDREDTHS: f32 = 9.6;
/// The greatest factor, in hundredths.
const MOST: i16 = 200;

/// The fewest bits that a term takes: one column with a factor of one.
const SHORTEST_TERM: f32 = 3.0;

/// A right side that terms are made of.
#[derive(Clone, Copy, Debug)]
struct Column {
    place: u16,
    kind: Kind,
    /// Whether it is a distance or the like, and not an attribute.
    relation: bool,
    /// What a place belongs to.
    owner: Option<Owner>,
}

/// What a coordinate belongs to: an object, by its first number in an instance, or a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Owner {
    Object(u8),
    Point(u8),
}

/// The columns of a problem by what they are.
pub(super) struct Columns {
    sizes: Vec<Column, MAX_COLUMNS>,
    places: Vec<Column, MAX_BASES>,
}

/// Looks at right sides, each with its length in bits.
pub(super) trait Visit {
    /// How long one may be to be looked at.
    fn longest(&self) -> f32;
    fn visit(&mut self, terms: [Term; TERMS], length: f32);
}

impl<R: Real> Forms<'_, R> {
    /// The columns that right sides are made of, attributes first.
    pub(super) fn columns(&self, domain: &Domain<'_>) -> Columns {
        let (mut sizes, mut places) = (Vec::new(), Vec::new());
        let features = self.rhs_features.as_slice();
        let nodes = self.features.nodes();
        for relation in [false, true] {
            for (place, feature) in (0u16..).zip(features) {
                let node = nodes.get(usize::from(*feature));
                let Some(node) = node.filter(|_| *feature != NOTHING) else {
                    continue;
                };
                let column = Column {
                    place,
                    kind: Kind::of(domain, nodes, NodeId(*feature)),
                    relation,
                    owner: owner(domain, node),
                };
                if matches!(node, Node::Product(..)) || is_relation(node) != relation {
                    continue;
                }
                // What finds no room is a distance, or one of very many attributes.
                let _ = match column.kind {
                    Kind::Place(_) => places.push(column).is_ok(),
                    Kind::Size(_) => sizes.push(column).is_ok(),
                    Kind::Diagonal(_) | Kind::Free | Kind::Heading | Kind::Other => true,
                };
            }
        }
        Columns { sizes, places }
    }
}

/// Whether a feature is a distance, an angle or the like, and not an attribute.
fn is_relation(node: &Node) -> bool {
    !matches!(
        node,
        Node::Quantity(Quantity::Attribute(_) | Quantity::Coordinate(..))
            | Node::Extreme(_, Quantity::Attribute(_))
    )
}

/// What a coordinate belongs to; `None` for anything else.
fn owner(domain: &Domain<'_>, node: &Node) -> Option<Owner> {
    match *node {
        Node::Quantity(Quantity::Attribute(slot)) => {
            let (object, _) = domain.slot(slot)?;
            Some(Owner::Object(object.first_slot))
        }
        Node::Quantity(Quantity::Coordinate(_, point)) => Some(Owner::Point(point)),
        _ => None,
    }
}

impl Columns {
    /// Visits the right sides of a left side that are in a part.
    pub(super) fn for_each_right(
        &self,
        left: &Left,
        effort: Effort,
        part: usize,
        visit: &mut dyn Visit,
    ) {
        if part > 0 && part % MAX_COLUMNS >= self.sizes.len() {
            return;
        }
        let sizes = self.sizes_of(left.kind);
        self.for_each_base(left.kind, &mut |base, length| {
            // Without terms, or with a place alone, plain left sides are forms already.
            if part == 0 && (left.tier != Tier::Plain || base[1].is_some()) {
                visit.visit(begin(base, [Term::NONE; SIZES]), length);
            }
            match (&sizes, part.checked_sub(MAX_COLUMNS)) {
                (Some(sizes), None) => sizes.add_one(effort, part, base, length, visit),
                (Some(sizes), Some(first)) if !base[1].is_some() => {
                    sizes.add_two((left.tier, effort), first, base[0], length, visit);
                    if left.tier == Tier::Plain && effort == Effort::Thorough {
                        sizes.add_three(first, base[0], length, visit);
                    }
                }
                _ => {}
            }
        });
    }

    /// Visits what a right side begins with: nothing, or a place on the same axis; for a
    /// diagonal, the same diagonal of one object.
    fn for_each_base(&self, kind: Kind, visit: &mut dyn FnMut([Term; 2], f32)) {
        let one = |column: &Column, hundredths| Term {
            column: column.place,
            hundredths,
        };
        visit([Term::NONE; 2], 0.0);
        let length = 1.0 + libm::log2f(1.0 + self.places.len() as f32);
        match kind {
            Kind::Place(_) | Kind::Free => {
                for place in &self.places {
                    if kind == Kind::Free || place.kind == kind {
                        visit([one(place, 100), Term::NONE], length);
                    }
                }
            }
            Kind::Diagonal(plus) => {
                let along = |axis| {
                    self.places
                        .iter()
                        .filter(move |p| p.kind == Kind::Place(axis))
                };
                let second = if plus { 100 } else { -100 };
                for x in along(0) {
                    for y in along(1).filter(|y| y.owner == x.owner) {
                        visit([one(x, 100), one(y, second)], length);
                    }
                }
            }
            Kind::Heading | Kind::Size(_) | Kind::Other => {}
        }
    }

    /// The sizes that a left side is compared with; `None` if it is compared with a threshold
    /// alone.
    fn sizes_of(&self, kind: Kind) -> Option<Sizes<'_>> {
        let dimension = match kind {
            Kind::Size(dimension) => dimension,
            Kind::Place(_) | Kind::Diagonal(_) | Kind::Free => Dimension::Length,
            Kind::Heading | Kind::Other => return None,
        };
        let own = |column: &&Column| column.kind == Kind::Size(dimension);
        let all = self.sizes.iter().filter(own);
        let relations = all.clone().filter(|column| column.relation).count();
        let attributes = all.count() - relations;
        let name = |count: usize| 2.0 + libm::log2f(count as f32);
        Some(Sizes {
            columns: &self.sizes,
            dimension,
            relation: name(2 * relations),
            attribute: name(attributes),
        })
    }
}

/// By what a term may be multiplied.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Factors {
    /// One and a half.
    Simple,
    /// Those of the grammar.
    Grammar,
    /// Any number of hundredths.
    Any,
}

/// Which sums of sizes are visited: what they begin with, with which factors, of how many sizes,
/// and which column goes with one before it.
struct Walk<'w> {
    base: Term,
    factors: Factors,
    sizes: usize,
    goes_with: &'w dyn Fn(usize, usize) -> bool,
}

/// The sizes of one dimension.
struct Sizes<'c> {
    columns: &'c [Column],
    dimension: Dimension,
    /// What it takes to name an attribute, in bits, and what a relation.
    attribute: f32,
    relation: f32,
}

impl Sizes<'_> {
    /// Visits what begins like this and goes on with a column.
    fn add_one(
        &self,
        effort: Effort,
        column: usize,
        [base, second]: [Term; 2],
        length: f32,
        visit: &mut dyn Visit,
    ) {
        let factors = match effort {
            Effort::Simple => Factors::Grammar,
            Effort::Thorough => Factors::Any,
        };
        self.for_each_term(factors, column, &mut |term, cost| {
            if length + cost < visit.longest() {
                let sizes = [term, Term::NONE, Term::NONE];
                visit.visit(begin([base, second], sizes), length + cost);
            }
        });
    }

    /// Visits what begins like this and goes on with a column and one behind it.
    fn add_two(
        &self,
        (tier, effort): (Tier, Effort),
        column: usize,
        base: Term,
        length: f32,
        visit: &mut dyn Visit,
    ) {
        let factors = match (tier, effort) {
            (Tier::Plain, Effort::Simple) | (Tier::Derived | Tier::Scene, Effort::Thorough) => {
                Factors::Simple
            }
            (Tier::Plain, Effort::Thorough) => Factors::Grammar,
            (Tier::Scene | Tier::Derived, Effort::Simple) => return,
        };
        // Sums of two distances say little.
        let goes_with = |a: usize, b: usize| !(self.is_relation(a) && self.is_relation(b));
        let walk = Walk {
            base,
            factors,
            sizes: 2,
            goes_with: &goes_with,
        };
        self.add_sizes(&walk, ([Term::NONE; SIZES], 0), column, length, visit);
    }

    /// Visits what begins like this and goes on with an attribute and two behind it, if there
    /// are not many.
    fn add_three(&self, column: usize, base: Term, length: f32, visit: &mut dyn Visit) {
        let own = |column: &&Column| column.kind == Kind::Size(self.dimension) && !column.relation;
        let attributes = self.columns.iter().filter(own).count();
        if attributes > MOST_OF_THREE || self.is_relation(column) {
            return;
        }
        let goes_with = |_: usize, other: usize| !self.is_relation(other);
        let walk = Walk {
            base,
            factors: Factors::Simple,
            sizes: SIZES,
            goes_with: &goes_with,
        };
        self.add_sizes(&walk, ([Term::NONE; SIZES], 0), column, length, visit);
    }

    fn is_relation(&self, place: usize) -> bool {
        self.columns
            .get(place)
            .is_some_and(|column| column.relation)
    }

    /// Visits what goes on with a column, behind so many sizes, until there are as many as wanted.
    fn add_sizes(
        &self,
        walk: &Walk<'_>,
        (known, count): ([Term; SIZES], usize),
        column: usize,
        length: f32,
        visit: &mut dyn Visit,
    ) {
        let missing = walk.sizes - count - 1;
        self.for_each_term(walk.factors, column, &mut |term, cost| {
            let length = length + cost;
            if length + SHORTEST_TERM * missing as f32 >= visit.longest() {
                return;
            }
            let mut sizes = known;
            if let Some(slot) = sizes.get_mut(count) {
                *slot = term;
            }
            if missing == 0 {
                return visit.visit(begin([walk.base, Term::NONE], sizes), length);
            }
            for other in column + 1..self.columns.len() {
                if (walk.goes_with)(column, other) {
                    self.add_sizes(walk, (sizes, count + 1), other, length, visit);
                }
            }
        });
    }

    /// Visits the terms of a column with some factors, each with its length.
    fn for_each_term(&self, factors: Factors, column: usize, visit: &mut dyn FnMut(Term, f32)) {
        let column = self.columns.get(column);
        let Some(column) = column.filter(|c| c.kind == Kind::Size(self.dimension)) else {
            return;
        };
        let name = match column.relation {
            true => self.relation,
            false => self.attribute,
        };
        let mut term = |hundredths: i16, bits: f32| {
            for hundredths in [hundredths, -hundredths] {
                let term = Term {
                    column: column.place,
                    hundredths,
                };
                visit(term, name + bits);
            }
        };
        let simple = match factors {
            Factors::Simple => SIMPLE,
            Factors::Grammar | Factors::Any => FACTORS.len(),
        };
        for (hundredths, bits) in FACTORS.iter().take(simple) {
            term(*hundredths, *bits);
        }
        // Of a size any share may count, of a distance hardly.
        let any = factors == Factors::Any && !column.relation;
        let fine = (1..=MOST).filter(|h| !FACTORS.iter().any(|(f, _)| f == h));
        for hundredths in fine.filter(|_| any) {
            let bits = match hundredths % 5 {
                0 => TWENTIETHS,
                _ => HUNDREDTHS,
            };
            term(hundredths, bits);
        }
    }
}

/// A right side: what it begins with, then sizes.
fn begin(base: [Term; 2], sizes: [Term; SIZES]) -> [Term; TERMS] {
    let mut all = [Term::NONE; TERMS];
    let terms = base.into_iter().chain(sizes).filter(Term::is_some);
    // There is room: two places are followed by one size.
    for (slot, term) in all.iter_mut().zip(terms) {
        *slot = term;
    }
    all
}
