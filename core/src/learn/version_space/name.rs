//! Names of thresholds: constant expressions of the grammar.

use crate::domain::{Constant, Dimension, Domain};
use crate::grammar::{FACTORS, MAX_COMPLEXITY};

/// A sum of at most two scaled constants, simple ones first: `c`, `f * c`,
/// `-c`, `c + d` and `c - d`, `c + f * d` and `c - f * d` and `f * d - c`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Name {
    pub(super) value: f64,
    pub(super) first: Scaled,
    /// The second constant, and whether it is taken off.
    pub(super) second: Option<(Scaled, bool)>,
}

/// A constant, by its index, and a factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scaled {
    pub(super) factor: f64,
    pub(super) constant: u8,
}

/// Calls `visit` with all names of one complexity, from 1 to 4.
fn for_each(
    domain: &Domain<'_>,
    dimension: Dimension,
    complexity: usize,
    visit: &mut impl FnMut(Name),
) {
    let own = |(_, c): &(u8, &Constant<'_>)| c.dimension == dimension;
    let constants = || (0u8..).zip(domain.constants()).filter(own);
    let one = |index: u8, factor: f64| Scaled {
        factor,
        constant: index,
    };
    let factors = || {
        let scaled = complexity == 2 || complexity == 4;
        let plain = (!scaled).then_some(1.0).into_iter();
        plain.chain(FACTORS.into_iter().filter(move |_| scaled))
    };
    for (i, a) in constants() {
        if complexity <= 2 {
            for factor in factors() {
                visit(Name {
                    value: factor * a.value,
                    first: one(i, factor),
                    second: None,
                });
            }
            continue;
        }
        if complexity == 3 {
            visit(Name {
                value: -a.value,
                first: one(i, -1.0),
                second: None,
            });
        }
        for (j, b) in constants() {
            let twice = complexity == 3 && j <= i;
            for factor in factors().filter(|_| i != j) {
                let (plain, scaled) = (one(i, 1.0), one(j, factor));
                let (x, y) = (a.value, factor * b.value);
                let pairs = [
                    (x + y, plain, scaled, false),
                    (x - y, plain, scaled, true),
                    (y - x, scaled, plain, true),
                ];
                let pairs = pairs.into_iter().filter(|_| !twice);
                pairs.for_each(|(value, first, second, off)| {
                    visit(Name {
                        value,
                        first,
                        second: Some((second, off)),
                    });
                });
            }
        }
    }
}

/// A name that fits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Named {
    pub(super) name: Name,
    /// From 1.
    pub(super) complexity: usize,
    /// Whether no other value of its complexity fits.
    pub(super) alone: bool,
}

/// The simplest name that fits.
pub(super) fn simplest(
    domain: &Domain<'_>,
    dimension: Dimension,
    fits: impl Fn(f64) -> bool,
) -> Option<Named> {
    (1..=MAX_COMPLEXITY).find_map(|complexity| {
        let mut found: Option<Named> = None;
        for_each(domain, dimension, complexity, &mut |name| {
            if !fits(name.value) {
                return;
            }
            match &mut found {
                None => {
                    found = Some(Named {
                        name,
                        complexity,
                        alone: true,
                    });
                }
                Some(first) => {
                    first.alone &= is_same(name.value, first.name.value);
                }
            }
        });
        found
    })
}

/// The most physical sum of sizes with this value: things that keep clear of each
/// other keep between them whole or half sizes, and one of them is `own`.
pub(super) fn clearance(
    domain: &Domain<'_>,
    dimension: Dimension,
    value: f64,
    own: impl Fn(&Constant<'_>) -> bool,
) -> Option<Name> {
    let strangeness = |s: &Scaled| usize::from(s.factor != 1.0 && s.factor != 0.5);
    let is_own = |s: &Scaled| {
        domain
            .constants()
            .get(usize::from(s.constant))
            .is_some_and(&own)
    };
    let mut found: Option<(usize, Name)> = None;
    for complexity in 3..=MAX_COMPLEXITY {
        for_each(domain, dimension, complexity, &mut |name| {
            let Some((second, false)) = name.second else {
                return;
            };
            let parts = [name.first, second];
            let strange = parts.iter().map(strangeness).sum::<usize>();
            let strange = strange + usize::from(!parts.iter().any(is_own));
            let better = found.as_ref().is_none_or(|(least, _)| strange < *least);
            if is_same(name.value, value) && better {
                found = Some((strange, name));
            }
        });
    }
    found.map(|(_, name)| name)
}

fn is_same(a: f64, b: f64) -> bool {
    (-1e-9..=1e-9).contains(&(a - b))
}
