//! What is learned about: a domain and its problem instances.

use crate::domain::{Domain, TOO_LARGE, held};
use crate::error::Error;
use crate::real::Real;
use crate::region::Theta;
use crate::wire::CHECKSUM;

/// A domain and the problem instances P in which samples are tried (thesis 4.3).
#[derive(Clone, Copy, Debug)]
pub struct Problem<'p> {
    domain: &'p Domain<'p>,
    instances: &'p [f64],
    count: usize,
    proposals: &'p [Theta],
    fingerprint: u32,
}

impl<'p> Problem<'p> {
    /// The problem of `count` instances that stand one behind the other in
    /// `instances`, each with [`Domain::instance_len`] numbers.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for a wrong length or no instance,
    /// [`Error::NotFinite`].
    pub fn new(domain: &'p Domain<'p>, instances: &'p [f64], count: usize) -> Result<Self, Error> {
        if count == 0 {
            return Err(Error::InvalidArgument("learning needs a problem instance"));
        }
        if domain.instance_len().checked_mul(count) != Some(instances.len()) {
            return Err(Error::InvalidArgument(
                "the instances need one number per attribute of every object",
            ));
        }
        instances
            .chunks_exact(domain.instance_len().max(1))
            .try_for_each(|instance| domain.check_instance(instance))?;
        let problem = Problem {
            domain,
            instances,
            count,
            proposals: &[],
            fingerprint: 0,
        };
        Ok(problem.sealed())
    }

    /// The same problem, with parameters for each instance that are worth a look: those
    /// that one would try who has not learned anything. Where few parameters work they
    /// are not found otherwise.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if there is not one for each instance, and those of
    /// [`Domain::check_parameters`].
    pub fn with_proposals(self, proposals: &'p [Theta]) -> Result<Self, Error> {
        if proposals.len() != self.count {
            return Err(Error::InvalidArgument(
                "there is one proposal for each instance",
            ));
        }
        let own = self.domain.parameters().len();
        for proposal in proposals {
            let values = proposal.get(..own).unwrap_or_default();
            self.domain.check_parameters(values)?;
        }
        let problem = Problem { proposals, ..self };
        Ok(problem.sealed())
    }

    /// What is worth a look in an instance, if that was said.
    pub fn proposal(&self, instance: usize) -> Option<&'p Theta> {
        self.proposals.get(instance)
    }

    /// The domain.
    pub fn domain(&self) -> &'p Domain<'p> {
        self.domain
    }

    /// How many instances there are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The numbers of an instance, one per attribute.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for an index that is none.
    pub fn instance(&self, index: usize) -> Result<&'p [f64], Error> {
        let length = self.domain.instance_len();
        let range = index
            .checked_mul(length)
            .filter(|_| index < self.count)
            .and_then(|start| self.instances.get(start..start.checked_add(length)?));
        range.ok_or(Error::InvalidArgument(
            "there is no instance with this index",
        ))
    }

    /// Checks that the numbers of all instances are some of the type that is computed with.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub(super) fn check_precision<R: Real>(&self) -> Result<(), Error> {
        held::<R>(self.instances.iter().copied(), TOO_LARGE)
    }

    /// A checksum of the domain text and all instances.
    pub fn fingerprint(&self) -> u32 {
        self.fingerprint
    }

    /// The same with its fingerprint.
    fn sealed(self) -> Self {
        let fingerprint = self.fingerprint_of(self.count);
        Problem {
            fingerprint,
            ..self
        }
    }

    /// The fingerprint that the problem of the first so many instances has.
    fn fingerprint_of(&self, count: usize) -> u32 {
        let mut digest = CHECKSUM.digest();
        digest.update(&self.domain.fingerprint().to_le_bytes());
        let numbers = self.domain.instance_len().saturating_mul(count);
        for value in self.instances.iter().take(numbers) {
            digest.update(&value.to_bits().to_le_bytes());
        }
        let own = self.domain.parameters().len();
        for proposal in self.proposals.iter().take(count) {
            for value in proposal.iter().take(own) {
                digest.update(&value.to_bits().to_le_bytes());
            }
        }
        digest.finalize()
    }

    /// What a learner remembers of the problem that it knows.
    pub(super) fn begun(&self) -> Begun {
        Begun {
            fingerprint: self.fingerprint,
            count: u32::try_from(self.count).unwrap_or(u32::MAX),
        }
    }

    /// Whether it is a problem that a learner knows, or that with more instances behind.
    pub(super) fn continues(&self, begun: Begun) -> bool {
        let count = begun.count as usize;
        match count == self.count {
            true => begun.fingerprint == self.fingerprint,
            false => count < self.count && begun.fingerprint == self.fingerprint_of(count),
        }
    }

    /// Checks that a learner that began with a problem goes on with the same.
    pub(super) fn check_begun(&self, begun: Option<Begun>) -> Result<(), Error> {
        match begun == Some(self.begun()) {
            true => Ok(()),
            false => Err(CHANGED),
        }
    }
}

/// What is wrong with a problem that a learner cannot go on with.
pub(super) const CHANGED: Error =
    Error::Mismatch("the domain or the instances changed while learning");

/// The problem that a learner knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Begun {
    pub(super) fingerprint: u32,
    /// How many instances it has.
    pub(super) count: u32,
}
