//! Where an action leaves its objects, in terms of its text.

use super::tuning::{AGREEING, EFFECT_RUNS, EFFECT_TOLERANCE};
use crate::domain::{Coordinate, Domain, Node, PointSet, Quantity, Scene};
use crate::error::Error;
use crate::real::Real;
use crate::table::gather;
use crate::wire::{Reader, Writer};
use heapless::Vec;

/// Terms of a text that are looked at: those beyond explain nothing.
const MAX_TERMS: usize = 48;
/// Numbers of an instance that are looked at.
const MAX_VALUES: usize = 24;
/// Runs that are kept.
const MAX_RUNS: usize = 12;

/// Numbers that a text speaks of, before the controller runs and with its parameters: these,
/// the coordinates of its points, the attributes of its objects.
pub(super) type Terms = Vec<f64, MAX_TERMS>;

/// The terms of a text in an instance. Groups have none.
///
/// # Errors
/// Those of [`Scene::new`].
pub(super) fn terms(domain: &Domain<'_>, instance: &[f64], theta: &[f64]) -> Result<Terms, Error> {
    let scene = Scene::<f64>::new(domain, instance, PointSet::all(domain))?;
    let theta = theta.get(..domain.parameters().len());
    let theta = theta.ok_or(Error::InvalidArgument("parameters are missing"))?;
    let sample = scene.sample(theta);
    let mut terms = Terms::new();
    let mut add = |value: f64| terms.push(value).is_ok();
    let mut room = theta.iter().all(|value| add(*value));
    let axes = [Coordinate::X, Coordinate::Y, Coordinate::Z];
    for (place, point) in (0..).zip(domain.points()) {
        let oriented = domain.is_oriented(place).then_some(Coordinate::Theta);
        let own = axes.into_iter().take(domain.axes()).chain(oriented);
        for coordinate in own.filter(|_| point.member.is_none()) {
            let node = Node::Quantity(Quantity::Coordinate(coordinate, place));
            room = room && add(sample.node(node, |_| f64::NAN));
        }
    }
    for (value, single) in instance.iter().zip(singles(domain)) {
        room = room && (!single || add(*value));
    }
    Ok(terms)
}

/// For each number of an instance, whether it is of a single object.
pub(super) fn singles(domain: &Domain<'_>) -> impl Iterator<Item = bool> {
    domain.slots().map(|(object, _)| object.member.is_none())
}

/// A number of an instance afterwards: a term and a constant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Effect {
    slot: u8,
    term: u8,
    offset: f64,
}

/// Where a controller leaves the objects of its text: attributes that are afterwards, whatever
/// the state and the parameters, a term of the text and a constant more. A robot that drives to
/// a point is there afterwards.
///
/// It is seen and not declared, as [`Changes`](super::Changes) is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Effects(Vec<Effect, MAX_VALUES>);

impl Effects {
    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The numbers of an instance that are known afterwards, by their places.
    pub(super) fn after(&self, terms: &Terms) -> impl Iterator<Item = (usize, f64)> {
        self.0.iter().filter_map(|own| {
            let term = terms.get(usize::from(own.term))?;
            Some((own.slot.into(), term + own.offset))
        })
    }

    /// Writes what is known.
    pub(super) fn write(&self, writer: &mut Writer<'_>) {
        writer.u16(self.0.len() as u16);
        for own in &self.0 {
            writer.u16(own.slot.into());
            writer.u16(own.term.into());
            writer.f64(own.offset);
        }
    }

    /// Reads what [`Effects::write`] wrote.
    pub(super) fn read(reader: &mut Reader<'_>) -> Result<Effects, Error> {
        const MORE: Error = Error::Corrupt("a saved skill has more effects than there are");
        let mut effects = Effects::default();
        for _ in 0..reader.u16()? {
            let mut number = || u8::try_from(reader.u16()?).map_err(|_| MORE);
            let own = Effect {
                slot: number()?,
                term: number()?,
                offset: reader.f64()?,
            };
            effects.0.push(own).map_err(|_| MORE)?;
        }
        Ok(effects)
    }
}

/// Runs of a controller: the terms before, and the numbers of the instance afterwards.
#[derive(Debug, Default)]
pub(super) struct Runs {
    all: Vec<(Terms, Vec<f64, MAX_VALUES>), MAX_RUNS>,
}

impl Runs {
    /// Notes a run, as long as there is room.
    pub(super) fn note(&mut self, terms: Terms, after: &[f64]) {
        // What finds no room is not needed.
        let _ = self.all.push((terms, gather(after.iter().copied())));
    }

    /// What explains the runs, of the numbers of single objects: one term each, if there is
    /// any with which nearly all runs agree.
    pub(super) fn effects(&self, domain: &Domain<'_>) -> Effects {
        let own = (0..MAX_VALUES).zip(singles(domain));
        let own = own.filter(|(_, single)| *single);
        let effects = own.filter_map(|(slot, _)| {
            let (term, offset) = self.explain(slot)?;
            Some(Effect {
                slot: slot as u8,
                term: term as u8,
                offset,
            })
        });
        Effects(gather(effects))
    }

    /// The term that most runs agree with about a value, and how much more the value is; of
    /// equals the first one without a difference, or the first.
    fn explain(&self, value: usize) -> Option<(usize, f64)> {
        let enough = (AGREEING * self.all.len() as f64) as usize;
        let mut best = None;
        let mut most = (enough.max(EFFECT_RUNS - 1), false);
        for term in 0..MAX_TERMS {
            for run in 0..self.all.len() {
                let Some(offset) = self.difference(run, value, term) else {
                    continue;
                };
                let is_near = |other: f64, scale: f64| Real::abs(other) <= EFFECT_TOLERANCE * scale;
                let scale = 1.0 + Real::abs(offset);
                let same = (0..self.all.len()).filter(|other| {
                    let own = self.difference(*other, value, term);
                    own.is_some_and(|own| is_near(own - offset, scale))
                });
                let offset = if is_near(offset, 1.0) { 0.0 } else { offset };
                let quality = (same.count(), offset == 0.0);
                if quality > most {
                    (most, best) = (quality, Some((term, offset)));
                }
            }
        }
        best
    }

    /// How much more than a term a value was in a run.
    fn difference(&self, run: usize, value: usize, term: usize) -> Option<f64> {
        let (terms, values) = self.all.get(run)?;
        Some(values.get(value)? - terms.get(term)?).filter(|own| own.is_finite())
    }
}
