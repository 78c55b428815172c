//! The tables of learners, owned, for host programs that choose the capacity as they run.

use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::{Config, VersionSpace, algorithm1, version_space};
use critreg::real::Real;
use critreg::table::Blank;

/// Declares a type that owns the tables that a learner's macro lists.
macro_rules! room {
    (
        [{$(#[$meta:meta])*} $name:ident $learner:ident]
        $($(#[$doc:meta])* $table:ident: $entry:ty, $count:ident;)*
    ) => {
        $(#[$meta])*
        pub struct $name<R = f64> {
            /// What there is room for.
            pub capacity: $learner::Capacity,
            $($table: Vec<$entry>,)*
        }

        impl<R: Real> $name<R> {
            /// Room of this capacity.
            pub fn of(capacity: $learner::Capacity) -> Self {
                $name {
                    capacity,
                    $($table: {
                        let blank = || <$entry as Blank>::BLANK;
                        std::iter::repeat_with(blank).take(capacity.$count()).collect()
                    },)*
                }
            }

            /// The tables, lent to one learner.
            pub fn lend(&mut self) -> $learner::Memory<'_, R> {
                $learner::Memory { $($table: &mut self.$table,)* }
            }
        }
    };
}

critreg::version_space_tables! {
    [room] R, {
        /// Memory for a version space learner of some capacity.
    } VersionSpaceRoom version_space
}

critreg::algorithm1_tables! {
    [room] R, {
        /// Memory for Algorithm 1 of some capacity.
    } Algorithm1Room algorithm1
}

impl<R: Real> VersionSpaceRoom<R> {
    /// Room of this capacity.
    pub fn new(capacity: version_space::Capacity) -> Self {
        VersionSpaceRoom::of(capacity)
    }

    /// A learner in this room.
    ///
    /// # Errors
    /// Those of [`VersionSpace::new`].
    pub fn learner(
        &mut self,
        domain: &Domain<'_>,
        config: Config,
    ) -> Result<VersionSpace<'_, R>, Error> {
        VersionSpace::new(domain, config, self.capacity, self.lend())
    }
}

impl Algorithm1Room {
    /// Room for so many hypotheses and observations.
    pub fn new(hypotheses: usize, observations: usize) -> Algorithm1Room {
        Algorithm1Room::of(algorithm1::Capacity {
            hypotheses,
            observations,
        })
    }
}
