//! The tables of a learner are listed once, by a macro that shows the list to another one:
//! what a table holds, its name, the type of an entry, and the method of the learner's
//! `Capacity` that tells how many entries it has. From that list come
//! the `Memory` of the learner, its types that own it, and the layout of the C interface.

/// Declares the `Memory` of a learner.
macro_rules! memory {
    ([] $($(#[$doc:meta])* $name:ident: $entry:ty, $count:ident;)*) => {
        /// The tables of a learner, lent by the caller. Each must have at least the
        /// length that [`Capacity`] tells; what is longer is not used.
        #[derive(Debug)]
        pub struct Memory<'m, R> {
            $(
                $(#[$doc])*
                #[doc = concat!(" Of length [`Capacity::", stringify!($count), "`].")]
                pub $name: &'m mut [$entry],
            )*
        }

        impl<R> Memory<'_, R> {
            /// The same memory, lent for a shorter time.
            pub fn reborrow(&mut self) -> Memory<'_, R> {
                Memory { $($name: self.$name,)* }
            }

            /// As much of each table as a capacity needs.
            pub(super) fn cut(self, capacity: Capacity) -> Result<Self, $crate::Error> {
                use $crate::table::cut;
                Ok(Memory { $($name: cut(self.$name, capacity.$count())?,)* })
            }
        }
    };
}

/// Declares a type that owns the memory of a [`VersionSpace`](crate::learn::VersionSpace)
/// with numbers of some type and a certain [`Capacity`](crate::learn::Capacity), as arrays: on
/// the stack, in a static, in a box.
///
/// ```
/// use critreg::learn::{Capacity, Config, VersionSpace};
///
/// critreg::room!(pub struct Room: f64, Capacity::new(1024, 128));
///
/// # let domain = critreg::domain::Domain::parse("parameter x in [0, 1]")?;
/// let mut room = Room::new();
/// let learner = VersionSpace::new(&domain, Config::default(), Room::CAPACITY, room.lend())?;
/// # Ok::<(), critreg::Error>(())
/// ```
#[macro_export]
macro_rules! room {
    ($(#[$meta:meta])* $visible:vis struct $name:ident: $real:ty, $capacity:expr) => {
        $crate::version_space_tables! {
            [$crate::__room] $real, {$(#[$meta])*} $visible $name {$real} {$capacity}
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __room {
    (
        [{$(#[$meta:meta])*} $visible:vis $name:ident {$real:ty} {$capacity:expr}]
        $($(#[$doc:meta])* $table:ident: $entry:ty, $count:ident;)*
    ) => {
        $(#[$meta])*
        $visible struct $name {
            $($table: [$entry; $name::CAPACITY.$count()],)*
        }

        impl $name {
            /// What there is room for.
            $visible const CAPACITY: $crate::learn::Capacity = $capacity;

            /// Room in which nothing is kept yet.
            $visible const fn new() -> Self {
                $name {
                    $($table: [
                        const { <$entry as $crate::table::Blank>::BLANK };
                        $name::CAPACITY.$count()
                    ],)*
                }
            }

            /// The tables, lent to one learner.
            $visible fn lend(&mut self) -> $crate::learn::Memory<'_, $real> {
                $crate::learn::Memory { $($table: &mut self.$table,)* }
            }
        }
    };
}

pub(super) use memory;
