//! What is learned about: a domain and its problem instances.

use crate::domain::Domain;
use crate::error::Error;
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
        let mut digest = CHECKSUM.digest();
        digest.update(&domain.fingerprint().to_le_bytes());
        for value in instances {
            digest.update(&value.to_bits().to_le_bytes());
        }
        Ok(Problem {
            domain,
            instances,
            count,
            proposals: &[],
            fingerprint: digest.finalize(),
        })
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
        let mut digest = CHECKSUM.digest();
        digest.update(&self.fingerprint.to_le_bytes());
        let own = self.domain.parameters().len();
        for proposal in proposals {
            let values = proposal.get(..own).unwrap_or_default();
            self.domain.check_parameters(values)?;
            for value in values {
                digest.update(&value.to_bits().to_le_bytes());
            }
        }
        Ok(Problem {
            proposals,
            fingerprint: digest.finalize(),
            ..self
        })
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

    /// A checksum of the domain text and all instances.
    pub fn fingerprint(&self) -> u32 {
        self.fingerprint
    }

    /// Checks that a learner that began with the problem of a fingerprint goes on
    /// with the same.
    pub(super) fn check_begun(&self, begun: Option<u32>) -> Result<(), Error> {
        if begun == Some(self.fingerprint) {
            Ok(())
        } else {
            Err(Error::Mismatch(
                "the domain or the instances changed while learning",
            ))
        }
    }
}
