//! The region that an explanation stands for.

use super::config::Evidence;
use super::cover::{Chosen, Cover};
use super::forms::{Forms, tolerance};
use super::name::{Name, Named, Scaled, simplest};
use crate::domain::{Domain, Node, NodeId, copy, intern};
use crate::error::Error;
use crate::grammar::{Comparison, Formula, MAX_COMPLEXITY, MAX_CONSTRAINTS};
use crate::real::Real;
use heapless::{Vec, VecView};

/// Where in the gap between its bounds an unnamed threshold is put.
const SHARE: f64 = 0.4;
/// How close the bounds of a constraint must be for its name to count, as a share
/// of what the form ranges over.
const CLOSE: f64 = 0.01;
/// What a threshold costs, per complexity of its name.
const PRICE_OF_NAMES: f64 = 0.03;
/// What it costs to measure from an object that has key points.
const PRICE_OF_CORNERS: f64 = 0.04;
/// Terms of one constraint.
const TERMS: usize = 24;

/// What supports the constraints of a region, in their order.
pub(super) type Support = Vec<Evidence, MAX_CONSTRAINTS>;

/// Adds the constraints of an explanation of a step, counted from zero.
pub(super) fn add_constraints<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    cover: &Cover<R>,
    step: usize,
    formula: &mut Formula,
    support: &mut Support,
) -> Result<(), Error> {
    for chosen in &cover.chosen {
        let mut nodes: Vec<Node, TERMS> = Vec::new();
        let left = left_side(forms, chosen, &mut nodes)?;
        let (bound, named) = threshold(domain, forms, chosen);
        let name = match named {
            Some(named) => Some(term(&named.name, &mut nodes)?),
            None => None,
        };
        let comparison = if chosen.side.upper {
            Comparison::LessEqual
        } else {
            Comparison::GreaterEqual
        };
        formula.and(&nodes, left, comparison, bound, name)?;
        let own = |value: R| chosen.side.outward(value).to_f64();
        let _ = support.push(Evidence {
            step: step as u32 + 1,
            feasible: own(chosen.inner),
            infeasible: own(chosen.outer),
            support: chosen.support,
        });
    }
    Ok(())
}

fn left_side<R: Real>(
    forms: &Forms<'_, R>,
    chosen: &Chosen<R>,
    nodes: &mut VecView<Node>,
) -> Result<NodeId, Error> {
    let (left, right) = forms.terms(&chosen.side);
    let known = forms.features().nodes();
    let left = copy(known, left, nodes)?;
    match right {
        None => Ok(left),
        Some(right) => {
            let right = copy(known, right, nodes)?;
            intern(nodes, Node::Difference(left, right))
        }
    }
}

/// The threshold of a constraint: a named one if only one simplest name fits
/// between its bounds, else inside of the gap; and a name that fits.
fn threshold<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    chosen: &Chosen<R>,
) -> (f64, Option<Named>) {
    let (inner, outer) = (chosen.inner, chosen.outer);
    let gap = outer - inner;
    let within = if gap.is_finite() {
        inner + gap * R::from_f64(SHARE)
    } else {
        inner
    };
    let unnamed = chosen.side.outward(within).to_f64();
    match names(domain, forms, chosen) {
        Some(named) if named.alone => {
            let bound = chosen
                .side
                .outward(R::from_f64(named.name.value))
                .max(inner);
            (chosen.side.outward(bound).to_f64(), Some(named))
        }
        _ => (unnamed, None),
    }
}

/// The simplest name between the bounds of a constraint.
fn names<R: Real>(domain: &Domain<'_>, forms: &Forms<'_, R>, chosen: &Chosen<R>) -> Option<Named> {
    let (inner, outer) = (chosen.inner, chosen.outer);
    let (left, _) = forms.terms(&chosen.side);
    let dimension = domain.dimension(forms.features().nodes(), left)?;
    let rounding = tolerance(inner);
    (outer - inner).is_finite().then(|| {
        simplest(domain, dimension, |value| {
            let value = chosen.side.outward(R::from_f64(value));
            inner - rounding <= value && value < outer - rounding
        })
    })?
}

/// What a constraint costs: a name for its threshold makes it cheaper, if its
/// bounds are so close that the name is no accident.
pub(super) fn price<R: Real>(domain: &Domain<'_>, forms: &Forms<'_, R>, chosen: &Chosen<R>) -> f64 {
    let close = chosen.range * R::from_f64(CLOSE);
    let named = if chosen.outer - chosen.inner <= close {
        names(domain, forms, chosen).filter(|named| named.alone)
    } else {
        None
    };
    let unnamed = 3 + MAX_COMPLEXITY;
    let complexity = named.map_or(unnamed, |named| named.complexity);
    let corner = if speaks_of_corner(domain, forms, chosen) {
        PRICE_OF_CORNERS
    } else {
        0.0
    };
    chosen.price() + corner + PRICE_OF_NAMES * complexity as f64
}

/// Whether its left side measures from where an object stands although the domain
/// declares key points of that object: those are there because they mean
/// something.
fn speaks_of_corner<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    chosen: &Chosen<R>,
) -> bool {
    let (left, _) = forms.terms(&chosen.side);
    let Some(Node::Distance(_, a, b)) = forms.features().nodes().get(usize::from(left.0)) else {
        return false;
    };
    let points = domain.points();
    [a, b].into_iter().any(|index| {
        let own = points.get(usize::from(*index)).filter(|p| p.is_object());
        own.is_some_and(|own| {
            let mut others = points.iter().filter(|p| !p.is_object() && !p.sampled);
            others.any(|p| p.owner == own.owner)
        })
    })
}

fn term(name: &Name, nodes: &mut VecView<Node>) -> Result<NodeId, Error> {
    let mut scaled = |s: &Scaled| {
        let constant = intern(nodes, Node::Constant(s.constant))?;
        let size = Real::abs(s.factor);
        let mut node = constant;
        if size != 1.0 {
            let factor = intern(nodes, Node::Number(size))?;
            node = intern(nodes, Node::Product(factor, constant))?;
        }
        if s.factor < 0.0 {
            let zero = intern(nodes, Node::Number(0.0))?;
            node = intern(nodes, Node::Difference(zero, node))?;
        }
        Ok::<_, Error>(node)
    };
    let first = scaled(&name.first)?;
    match &name.second {
        None => Ok(first),
        Some((second, off)) => {
            let second = scaled(second)?;
            let node = if *off {
                Node::Difference(first, second)
            } else {
                Node::Sum(first, second)
            };
            intern(nodes, node)
        }
    }
}
