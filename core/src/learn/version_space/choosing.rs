//! Instances of a source: of thousands those that differ, as many as there is room for.

use super::VersionSpace;
use crate::domain::Domain;
use crate::error::Error;
use crate::real::Real;
use core::ops::Range;

impl<R: Real> VersionSpace<'_, R> {
    /// Chooses instances of a source that makes any of `count` by its number: writes them one
    /// behind the other into `chosen`, as many as find room there, and returns how many. With
    /// them a [`Problem`](crate::learn::Problem) is made as with any others. So memory is needed
    /// for those only that are learned from; the others are made, looked at and forgotten.
    ///
    /// The source is divided into as many parts as there is room for instances. Of each part the
    /// one is taken that differs most from those before: in every feature of the grammar it is
    /// as far as the nearest of them, in units of what all instances range over, and these
    /// distances are summed (a single pass of a farthest-first traversal, Gonzalez 1985). What
    /// stands out is then among few instances, and conditions that hold by chance in alike ones
    /// are told from those that matter.
    ///
    /// `make` writes the instance with a number, always the same one; it is called up to three
    /// times for each. The same source makes the same choice.
    ///
    /// # Errors
    /// [`Error::OutOfSequence`] after something was asked or told;
    /// [`Error::InvalidArgument`] if there is no instance or no room for one;
    /// [`Error::NotFinite`] and others for an instance that is none; those of `make`.
    pub fn choose_instances<E: From<Error>>(
        &mut self,
        domain: &Domain<'_>,
        count: usize,
        mut make: impl FnMut(usize, &mut [f64]) -> Result<(), E>,
        chosen: &mut [f64],
    ) -> Result<usize, E> {
        if self.problem.is_some() {
            const LATE: Error =
                Error::OutOfSequence("choose instances before anything is asked or told");
            return Err(LATE.into());
        }
        let length = domain.instance_len();
        let room = chosen.len().checked_div(length).unwrap_or(1);
        let wanted = room.min(count).min(self.capacity.instances);
        if wanted == 0 {
            const NONE: Error =
                Error::InvalidArgument("a source needs an instance and room for it");
            return Err(NONE.into());
        }
        let surveyed = self.survey(domain, count, &mut make, chosen);
        let done = surveyed.and_then(|()| {
            for place in 0..wanted {
                let part = place * count / wanted..(place + 1) * count / wanted;
                self.choose_of(domain, place, part, &mut make, chosen)?;
            }
            Ok(wanted)
        });
        self.forms.end_comparing();
        done
    }

    /// Notes what the features range over.
    fn survey<E: From<Error>>(
        &mut self,
        domain: &Domain<'_>,
        count: usize,
        make: &mut impl FnMut(usize, &mut [f64]) -> Result<(), E>,
        room: &mut [f64],
    ) -> Result<(), E> {
        let own = room.get_mut(..domain.instance_len()).unwrap_or(&mut []);
        for number in 0..count {
            make(number, own)?;
            self.forms.look_at(domain, own)?;
            self.forms.note_ranges();
        }
        Ok(())
    }

    /// Chooses the instance for a place from a part of the source.
    fn choose_of<E: From<Error>>(
        &mut self,
        domain: &Domain<'_>,
        place: usize,
        part: Range<usize>,
        make: &mut impl FnMut(usize, &mut [f64]) -> Result<(), E>,
        chosen: &mut [f64],
    ) -> Result<(), E> {
        let length = domain.instance_len();
        let own = chosen.get_mut(place * length..(place + 1) * length);
        let own = own.unwrap_or(&mut []);
        let (mut best, mut most) = (part.start, None);
        for number in part {
            make(number, own)?;
            self.forms.look_at(domain, own)?;
            let apart = self.forms.distance_to_kept(place);
            if most.is_none_or(|most| apart > most) {
                (best, most) = (number, Some(apart));
            }
        }
        make(best, own)?;
        self.forms.look_at(domain, own)?;
        self.forms.keep_row(place);
        Ok(())
    }
}
