//! A world of symbols, in which operators do what they say.

use critreg::Error;
use critreg::plan::{Draw, Drawn, Sampler, World};
use critreg::task::{AtomSet, GroundOperator, Parameters};
use rand_core::Rng;

/// A world whose states are abstract ones, and its sampler. Operators have so many
/// parameters, which change nothing.
pub struct Symbols {
    /// How many.
    pub parameters: usize,
}

impl<const N: usize> World<N> for Symbols {
    type State = AtomSet<N>;
    type Error = Error;

    fn parameters(&self, _: &GroundOperator<N>) -> Result<usize, Error> {
        Ok(self.parameters)
    }

    fn holds(&mut self, atom: u32, state: &AtomSet<N>) -> Result<bool, Error> {
        Ok(state.contains(atom))
    }

    fn execute(
        &mut self,
        operator: &GroundOperator<N>,
        _: &[f64],
        before: &AtomSet<N>,
        after: &mut AtomSet<N>,
    ) -> Result<u32, Error> {
        *after = operator.apply(*before);
        Ok(u32::from(operator.is_applicable(*before)))
    }
}

impl<const N: usize> Sampler<Symbols, N> for Symbols {
    fn sample<R: Rng>(&mut self, _: &Draw<'_, AtomSet<N>, N>, _: &mut R) -> Result<Drawn, Error> {
        let zeros = std::iter::repeat_n(0.0, self.parameters);
        Ok(Drawn::Parameters(zeros.collect::<Parameters>()))
    }
}
