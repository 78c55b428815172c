//! What a region admits along a line of parameters, exactly.

use super::choices::{Along, Choices};
use super::halving::halve;
use super::interval::{Builder, IntervalSet};
use crate::domain::{Curve, Line, MAX_PARAMETERS, Node, Sample, Scene};
use crate::grammar::{Comparison, Constraint, Formula, MAX_CONSTRAINTS, Truth};
use crate::real::Real;
use heapless::Vec;

/// Most roots of all constraints of a region: two per constraint. A constraint about a
/// group can have two for each member; one whose roots find no room counts as one without a
/// closed form.
const MAX_BREAKS: usize = 2 * MAX_CONSTRAINTS;

/// Sets `set` to the admitted positions `t` between two ends on the line
/// `origin + t * direction`.
///
/// The line is cut at the roots of the constraints. Between two neighbouring roots nothing
/// changes. At a root its constraint holds if it admits equality. Where a constraint has
/// no closed form, the set is too large: by little if the line is to be halved there.
pub(super) fn slice<R: Real>(
    formula: &Formula,
    scene: &Scene<'_, R>,
    [origin, direction]: [&[R]; 2],
    ends: [R; 2],
    halves: bool,
    set: &mut IntervalSet<R>,
) {
    let mut theta: Vec<Line<R>, MAX_PARAMETERS> = Vec::new();
    for (at, slope) in origin.iter().zip(direction) {
        let (at, slope) = (*at, *slope);
        // There is room: no action has more parameters.
        let _ = theta.push(Line { at, slope });
    }
    let mut sample = Sample::blank(scene, &theta);
    sample.place_points();
    let along = Along {
        scene,
        theta: &theta,
        sample: &sample,
    };
    cut(formula, along, ends, halves, set);
}

/// Cuts a line at the roots of a formula's constraints. Not inlined, so that its breaks
/// are not on the stack while points are placed.
#[inline(never)]
fn cut<R: Real>(
    formula: &Formula,
    along: Along<'_, '_, R>,
    ends: [R; 2],
    halves: bool,
    set: &mut IntervalSet<R>,
) {
    let nodes = formula.nodes();
    let mut cut = Cut::new(ends);
    for (owner, constraint) in (0u8..).zip(formula.constraints()) {
        let sides = [constraint.lhs, constraint.rhs];
        let curve = along.sample.difference(nodes, sides);
        let added = match curve.is_finite() {
            true => cut.add(owner, &curve, constraint.comparison),
            false => cut.add_without_curve(owner, along, nodes, constraint),
        };
        if added.is_some() {
            continue;
        }
        cut.forget(owner);
        if halves && cut.add_halves(owner, along, nodes, constraint).is_some() {
            continue;
        }
        cut.forget(owner);
        cut.begin(owner, Truth::UNKNOWN);
    }
    cut.write(formula, set);
}

/// The constraint that a root belongs to, and what is known of that constraint after it: four
/// times the index of the constraint, plus a bit each if it may hold and if it may fail. Roots
/// are this small because many may be on the stack.
#[derive(Clone, Copy)]
struct Root(u8);

impl Root {
    fn new(owner: u8, then: Truth) -> Root {
        Root(owner << 2 | u8::from(then.may_fail) << 1 | u8::from(then.may_hold))
    }

    /// Index of the constraint.
    fn owner(self) -> u8 {
        self.0 >> 2
    }

    /// The bit of the constraint where it may hold after the root, and where it may fail.
    fn then(self) -> Masks {
        let own = |known: u8| if known == 0 { 0 } else { bit(self.owner()) };
        Masks {
            hold: own(self.0 & 1),
            fail: own(self.0 & 2),
        }
    }
}

/// Which constraints may hold and which may fail, a bit each.
#[derive(Clone, Copy, Default)]
struct Masks {
    hold: u32,
    fail: u32,
}

impl Masks {
    /// The same, but the constraints `which` hold or fail as `then` says.
    fn with(self, which: u32, then: Masks) -> Masks {
        Masks {
            hold: (self.hold & !which) | (which & then.hold),
            fail: (self.fail & !which) | (which & then.fail),
        }
    }
}

/// The bit of a constraint.
fn bit(owner: u8) -> u32 {
    1u32.wrapping_shl(u32::from(owner))
}

const _: () = assert!(MAX_CONSTRAINTS <= 32, "masks have a bit per constraint");

/// A line cut at the roots of constraints.
struct Cut<R> {
    ends: [R; 2],
    /// What holds before the first root.
    first: Masks,
    /// Constraints that hold where their two sides are equal.
    admit_equal: u32,
    /// Constraints of which somewhere it is not known whether they hold.
    unknown: u32,
    /// The positions of all roots between the ends, ascending.
    breaks: Vec<R, MAX_BREAKS>,
    /// The roots at these positions. Pairs of both would need more room.
    roots: Vec<Root, MAX_BREAKS>,
}

impl<R: Real> Cut<R> {
    fn new(ends: [R; 2]) -> Self {
        Cut {
            ends,
            first: Masks::default(),
            admit_equal: 0,
            unknown: 0,
            breaks: Vec::new(),
            roots: Vec::new(),
        }
    }

    /// Cuts at the roots of a constraint, and evaluates it once between them. `None` if there
    /// is no room for them.
    #[inline(never)]
    fn add(&mut self, owner: u8, curve: &Curve<R>, comparison: Comparison) -> Option<()> {
        let [low, high] = self.ends;
        let passes = |t: R| curve.is_near_zero(t) || curve.may_jump(t);
        let inside = |t: R| low <= t && t <= high && passes(t);
        let holds_between = |a: R, b: R| {
            let value = curve.value(middle(a, b));
            comparison.holds(&value, &R::ZERO)
        };
        let [a, b] = curve.roots();
        let [a, b] = if b < a { [b, a] } else { [a, b] };
        let is_root = inside(a);
        let mut end = high;
        // A root that was found twice counts once: nothing lies between.
        if inside(b) && !(is_root && a == b) {
            self.insert(owner, b, holds_between(b, end).into())?;
            end = b;
        }
        if is_root {
            self.insert(owner, a, holds_between(a, end).into())?;
            end = a;
        }
        self.at_roots(owner, comparison);
        self.begin(owner, holds_between(low, end).into());
        Some(())
    }

    /// Notes whether a constraint holds at its roots.
    fn at_roots(&mut self, owner: u8, comparison: Comparison) {
        if comparison.admits_equal() {
            self.admit_equal |= bit(owner);
        }
    }

    /// Notes what is known of a constraint before its first root.
    fn begin(&mut self, owner: u8, first: Truth) {
        let masks = Root::new(owner, first).then();
        self.first.hold |= masks.hold;
        self.first.fail |= masks.fail;
        self.unknown |= masks.hold & masks.fail;
    }

    /// As [`Cut::add`], for a constraint with extremes: cuts at those roots of all choices
    /// of members at which the sides of the constraint are equal.
    fn add_choices(&mut self, owner: u8, choices: &Choices<'_, '_, R>) -> Option<()> {
        let [low, mut end] = self.ends;
        for curve in choices.curves() {
            let equal = |t: R| curve.is_near_zero(t) && choices.is_near_zero(t);
            let passes = |t: &R| low <= *t && *t <= end && (equal(*t) || curve.may_jump(*t));
            for at in curve.roots().into_iter().filter(passes) {
                let mut known = self.breaks.iter().zip(&self.roots);
                if !known.any(|(place, root)| root.owner() == owner && *place == at) {
                    self.insert(owner, at, false.into())?;
                }
            }
        }
        let holds_between = |a: R, b: R| choices.holds(middle(a, b));
        let all = self.breaks.iter().zip(&mut self.roots).rev();
        for (at, root) in all.filter(|(_, root)| root.owner() == owner) {
            *root = Root::new(owner, holds_between(*at, end).into());
            end = *at;
        }
        self.at_roots(owner, choices.comparison());
        self.begin(owner, holds_between(low, end).into());
        Some(())
    }

    /// As [`Cut::add`], for a constraint that is not a single curve; `None` also if it has no
    /// closed form.
    #[inline(never)]
    fn add_without_curve(
        &mut self,
        owner: u8,
        along: Along<'_, '_, R>,
        nodes: &[Node],
        constraint: &Constraint,
    ) -> Option<()> {
        self.add_choices(owner, &Choices::new(along, nodes, constraint)?)
    }

    /// As [`Cut::add`], for a constraint that has no closed form: cuts between where it holds,
    /// where it fails, and where that is not known.
    #[inline(never)]
    fn add_halves(
        &mut self,
        owner: u8,
        along: Along<'_, '_, R>,
        nodes: &[Node],
        constraint: &Constraint,
    ) -> Option<()> {
        let mut known = None;
        halve(along, nodes, constraint, self.ends, &mut |at, truth| {
            let before = known.replace(truth);
            match before {
                None => self.begin(owner, truth),
                Some(before) if before == truth => {}
                Some(_) => self.insert(owner, at, truth)?,
            }
            Some(())
        })?;
        // What holds or fails on one side of a cut is not known there.
        self.admit_equal |= bit(owner);
        Some(())
    }

    /// Notes no roots of a constraint.
    fn forget(&mut self, owner: u8) {
        let own = bit(owner);
        self.first = self.first.with(own, Masks::default());
        self.unknown &= !own;
        let mut kept = 0;
        for index in 0..self.roots.len() {
            let (Some(at), Some(root)) = (
                self.breaks.get(index).copied(),
                self.roots.get(index).copied(),
            ) else {
                break;
            };
            if root.owner() == owner {
                continue;
            }
            if let (Some(to), Some(own)) = (self.breaks.get_mut(kept), self.roots.get_mut(kept)) {
                (*to, *own) = (at, root);
            }
            kept += 1;
        }
        self.breaks.truncate(kept);
        self.roots.truncate(kept);
    }

    /// Inserts a root, keeping the order; `None` if there is no room for it.
    fn insert(&mut self, owner: u8, at: R, then: Truth) -> Option<()> {
        if self.breaks.is_full() {
            return None;
        }
        let (mut at, mut root) = (at, Root::new(owner, then));
        self.unknown |= root.then().hold & root.then().fail;
        for (place, other) in self.breaks.iter_mut().zip(&mut self.roots) {
            if at < *place {
                core::mem::swap(place, &mut at);
                core::mem::swap(other, &mut root);
            }
        }
        self.breaks.push(at).ok()?;
        self.roots.push(root).ok()
    }

    /// Sets `set` to where a formula holds.
    #[inline(never)]
    fn write(&self, formula: &Formula, set: &mut IntervalSet<R>) {
        // Most regions are conjunctions: all bits set is all there is to know.
        let all = formula.conjunction();
        let truth = |masks: Masks| match all {
            Some(all) => masks.hold == all,
            None => formula.truth_of_masks(masks.hold, masks.fail).may_hold,
        };
        let mut masks = self.first;
        let mut builder = Builder::new(set, self.unknown == 0);
        let mut breaks = self.breaks.iter().zip(&self.roots);
        let mut next = breaks.next();
        let [mut at, high] = self.ends;
        loop {
            let (mut owners, mut then) = (0, Masks::default());
            while let Some((place, root)) = next
                && *place == at
            {
                owners |= bit(root.owner());
                then.hold |= root.then().hold;
                then.fail |= root.then().fail;
                next = breaks.next();
            }
            let equal = Masks {
                hold: self.admit_equal,
                fail: !self.admit_equal,
            };
            let here = truth(masks.with(owners, equal));
            masks = masks.with(owners, then);
            let goes_on = at < high;
            builder.step(at, here, goes_on && truth(masks));
            if !goes_on {
                return;
            }
            at = next.map_or(high, |(place, _)| *place);
        }
    }
}

fn middle<R: Real>(a: R, b: R) -> R {
    a.towards(b, R::from_f64(0.5))
}
