//! Clauses in words of the domain: what the region says, and what it costs to say it.

use super::bound::Bound;
use super::clause::Clause;
use super::forms::{Forms, tolerance};
use super::name::{Name, Named, Scaled, clearance, simplest};
use super::report::Evidence;
use crate::domain::{Dimension, Domain, Node, NodeId, Quantity, TermError, intern};
use crate::error::Error;
use crate::grammar::{Comparison, Inequality};
use crate::real::Real;
use crate::text::split_at_dot;
use heapless::{Vec, VecView};

/// Terms of one constraint.
const TERMS: usize = 40;

/// A constraint in words of the domain. It is large, and so is written where it lies.
#[derive(Default)]
pub(super) struct Description {
    /// The terms of the bounds.
    pub(super) nodes: Vec<Node, TERMS>,
    /// Its bounds, of which one must hold.
    pub(super) any_of: Vec<Inequality, 2>,
    /// What supports each bound.
    pub(super) evidence: Vec<Evidence, 2>,
}

impl Description {
    /// Describes a constraint of a step, counted from zero.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if it has more terms than there is room for.
    pub(super) fn describe<R: Real>(
        &mut self,
        domain: &Domain<'_>,
        forms: &Forms<'_, R>,
        clause: &Clause<R>,
        step: usize,
    ) -> Result<(), Error> {
        self.nodes.clear();
        self.any_of.clear();
        self.evidence.clear();
        for bound in clause.said() {
            let inequality = inequality(domain, forms, bound, &mut self.nodes)?;
            let own = |value: R| bound.form.outward(value).to_f64();
            // There is room for both bounds.
            let _ = self.any_of.push(inequality);
            let _ = self.evidence.push(Evidence {
                step: step as u32 + 1,
                feasible: own(bound.inner),
                infeasible: own(bound.outer),
                support: clause.support,
            });
        }
        Ok(())
    }
}

#[inline(never)]
fn inequality<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    bound: &Bound<R>,
    nodes: &mut VecView<Node>,
) -> Result<Inequality, Error> {
    let lhs = forms.write(&bound.form, nodes)?;
    let (value, named) = threshold(domain, forms, bound);
    let name = match named {
        Some(named) => Some(term(&named.name, nodes)?),
        None => None,
    };
    Ok(Inequality {
        lhs,
        comparison: if bound.form.upper() {
            Comparison::LessEqual
        } else {
            Comparison::GreaterEqual
        },
        bound: value,
        name,
    })
}

/// Whether the threshold of a bound may be zero: then it says no more than which of two
/// features is greater, or the sign of one.
fn is_sign<R: Real>(bound: &Bound<R>) -> bool {
    let rounding = tolerance(bound.inner);
    bound.inner <= rounding && rounding < bound.outer
}

/// The threshold of a bound: zero if that fits between its ends, a named one if only one
/// simplest name fits, else inside of the gap; and a name that fits.
fn threshold<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    bound: &Bound<R>,
) -> (f64, Option<Named>) {
    let outward = |value: R| bound.form.outward(value).to_f64();
    if is_sign(bound) {
        // The sum has no negative zero.
        return (outward(bound.inner.max(R::ZERO)) + 0.0, None);
    }
    match name(domain, forms, bound) {
        Some(mut named) if named.alone => {
            if !is_one_constant(&named) {
                let clearance = clearance_of(domain, forms, bound, &named);
                named.name = clearance.unwrap_or(named.name);
            }
            let exact = named.name.value;
            let fits = bound.form.outward(R::from_f64(exact)) >= bound.inner;
            (if fits { exact } else { outward(bound.inner) }, Some(named))
        }
        _ => (outward(bound.threshold(forms.tuning())), None),
    }
}

fn is_one_constant(named: &Named) -> bool {
    named.name.second.is_none() && named.name.first.factor == 1.0
}

/// The points between which the form of a bound measures, if that is all it does.
fn distance<R: Real>(forms: &Forms<'_, R>, bound: &Bound<R>) -> Option<[u8; 2]> {
    let left = forms.left_term(&bound.form);
    match forms.features().nodes().get(usize::from(left.0))? {
        Node::Quantity(Quantity::Distance(_, a, b))
        | Node::Extreme(_, Quantity::Distance(_, a, b)) => {
            forms.is_left_side(&bound.form).then_some([*a, *b])
        }
        _ => None,
    }
}

/// Another name of the same value that says a distance as a sum of sizes.
fn clearance_of<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    bound: &Bound<R>,
    named: &Named,
) -> Option<Name> {
    let points = distance(forms, bound)?;
    let left = forms.left_term(&bound.form);
    let dimension = measured(domain, forms, left);
    clearance(domain, dimension, named.name.value, |constant| {
        let owner = split_at_dot(constant.name).map(|(owner, _)| owner);
        let owners = points.iter().filter_map(|p| domain.object_of(*p));
        owners.into_iter().any(|object| Some(object) == owner)
    })
}

/// What a left side measures. A plain number is what that is compared with for which there is
/// no word.
fn measured<R: Real>(domain: &Domain<'_>, forms: &Forms<'_, R>, left: NodeId) -> Dimension {
    let dimension = domain.dimension(forms.features().nodes(), left);
    dimension.unwrap_or(Dimension::None)
}

/// The simplest name between the ends of a bound.
fn name<R: Real>(domain: &Domain<'_>, forms: &Forms<'_, R>, bound: &Bound<R>) -> Option<Named> {
    let (inner, outer) = (bound.inner, bound.outer);
    let left = forms.left_term(&bound.form);
    let dimension = measured(domain, forms, left);
    let rounding = tolerance(inner);
    (outer - inner).is_finite().then(|| {
        simplest(domain, dimension, |value| {
            let value = bound.form.outward(R::from_f64(value));
            inner - rounding <= value && value < outer - rounding
        })
    })?
}

/// What the names of a clause's thresholds cost, beyond [`Clause::length`], in bits: a name
/// makes it shorter, if the ends of the bound are so close that the name is no accident.
pub(super) fn naming_length<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    clause: &Clause<R>,
) -> f64 {
    let tuning = forms.tuning();
    let lengths = clause.bounds().map(|bound| {
        if is_sign(bound) {
            // There is no threshold to describe.
            return tuning.zero_threshold - forms.threshold_length();
        }
        let close = bound.range * R::from_f64(tuning.name_gap);
        let named = if bound.outer - bound.inner <= close {
            name(domain, forms, bound).filter(|named| named.alone)
        } else {
            None
        };
        let complexity = named.map_or(tuning.unnamed_complexity, |named| named.complexity as f64);
        let corner = if measures_from_corner(domain, forms, bound) {
            tuning.corner
        } else {
            0.0
        };
        corner + tuning.name_complexity * complexity
    });
    lengths.sum()
}

/// Whether its left side measures from where an object stands although the domain
/// declares key points of that object: those are there because they mean
/// something.
fn measures_from_corner<R: Real>(
    domain: &Domain<'_>,
    forms: &Forms<'_, R>,
    bound: &Bound<R>,
) -> bool {
    let left = forms.left_term(&bound.form);
    let left = forms.features().nodes().get(usize::from(left.0));
    let Some(Node::Quantity(Quantity::Distance(_, a, b))) = left else {
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

fn term(name: &Name, nodes: &mut VecView<Node>) -> Result<NodeId, TermError> {
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
        Ok::<_, TermError>(node)
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
