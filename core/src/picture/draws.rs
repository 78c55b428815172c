//! The parameters whose places are shown.

use super::Picture;
use crate::domain::MAX_PARAMETERS;
use crate::error::Error;
use crate::random::generator;
use crate::real::Real;
use crate::region::{Grounded, Theta};

/// How many values of a single parameter are shown.
const VALUES: u32 = 121;
/// How many of several parameters, spread evenly over all that can be chosen.
const SPREAD: u32 = 400;
/// How many more from the region, which may be a small part of that.
const FROM_REGION: u32 = 150;
/// Of so many one also shows how bodies stand.
const SPARSE: u32 = 75;

/// What is expected of an action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Expected {
    /// There is no region to tell.
    Unknown,
    Works,
    Fails,
}

impl Expected {
    /// The class that it is drawn in.
    pub(super) fn class(self) -> &'static str {
        match self {
            Expected::Unknown => "unknown",
            Expected::Works => "works",
            Expected::Fails => "fails",
        }
    }
}

/// Parameters that are shown.
#[derive(Clone, Copy)]
pub(super) struct Draw {
    pub(super) theta: Theta,
    /// Whether bodies are shown where they stand with these.
    pub(super) with_bodies: bool,
}

/// What is shown of an action: parameters that are the same whenever they are asked for.
pub(super) struct Draws<'d, 'p, R> {
    pub(super) picture: &'d Picture<'p>,
    pub(super) grounded: Option<&'d Grounded<'p, R>>,
}

impl<R: Real> Draws<'_, '_, R> {
    /// What is expected of an action with these parameters.
    pub(super) fn expected(&self, theta: &Theta) -> Result<Expected, Error> {
        let count = self.picture.domain.parameters().len();
        let theta = theta.get(..count).unwrap_or_default();
        Ok(match self.grounded {
            None => Expected::Unknown,
            Some(grounded) if grounded.contains(theta)? => Expected::Works,
            Some(_) => Expected::Fails,
        })
    }

    /// What may be expected, in the order in which it is drawn.
    pub(super) fn expectations(&self) -> &'static [Expected] {
        match self.grounded {
            Some(_) => &[Expected::Fails, Expected::Works],
            None => &[Expected::Unknown],
        }
    }

    /// Visits the parameters that are shown of which this is expected.
    pub(super) fn each_of(
        &self,
        wanted: Expected,
        visit: &mut dyn FnMut(&Draw) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let count = self.picture.domain.parameters().len();
        let (values, sparse) = match count {
            0 => (1, 1),
            1 => (VALUES, 15),
            _ => (SPREAD, SPARSE),
        };
        for number in 0..values {
            let theta = match count {
                0 | 1 => self.between(|_| f64::from(number) / f64::from(VALUES - 1)),
                _ => self.between(|place| scattered(count, place, number)),
            };
            if self.expected(&theta)? == wanted {
                let with_bodies = number % sparse == 0;
                visit(&Draw { theta, with_bodies })?;
            }
        }
        match wanted {
            Expected::Works if count > 1 => self.each_from_region(visit),
            _ => Ok(()),
        }
    }

    fn each_from_region(
        &self,
        visit: &mut dyn FnMut(&Draw) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let Some(grounded) = self.grounded else {
            return Ok(());
        };
        let mut rng = generator(1);
        for number in 0..FROM_REGION {
            let theta = match grounded.sample(&mut rng) {
                Ok(theta) => theta,
                Err(Error::EmptyRegion | Error::NoSample) => break,
                Err(error) => return Err(error),
            };
            visit(&Draw {
                theta,
                with_bodies: number % (SPARSE / 2) == 0,
            })?;
        }
        Ok(())
    }

    /// Parameters at a share of the range of each.
    fn between(&self, share: impl Fn(usize) -> f64) -> Theta {
        let mut theta = [0.0; MAX_PARAMETERS];
        let parameters = self.picture.domain.parameters().iter().enumerate();
        for (value, (place, parameter)) in theta.iter_mut().zip(parameters) {
            *value = parameter.low.towards(parameter.high, share(place));
        }
        theta
    }
}

/// The share of a range that a number of an even spread has along an axis: the additive
/// recurrence R_d of Roberts (2018), whose steps are powers of a generalised golden ratio.
fn scattered(dimensions: usize, axis: usize, number: u32) -> f64 {
    // The positive roots of x^(d + 1) = x + 1, for two to six dimensions.
    const RATIOS: [f64; 5] = [
        1.324_717_957_244_746,
        1.220_744_084_605_759_5,
        1.167_303_978_261_418_7,
        1.134_724_138_401_519_5,
        1.112_775_684_278_705_5,
    ];
    let ratio = dimensions.checked_sub(2).and_then(|own| RATIOS.get(own));
    let ratio = ratio.copied().unwrap_or(1.618_033_988_749_895);
    let step = (0..=axis).fold(1.0, |step, _| step / ratio);
    let value = 0.5 + step * f64::from(number);
    value - Real::floor(value)
}
