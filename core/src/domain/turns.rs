//! Rotations in one list of numbers: most of them need only two.

use crate::error::Error;
use crate::geometry::Rotation;
use crate::real::Real;
use heapless::VecView;

/// How a point is turned: where its rotation stands in a list of numbers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Turn {
    /// Like the world.
    World,
    /// About the z axis: a cosine and a sine.
    Planar(u8),
    /// About any axis: nine numbers, by rows.
    Tilted(u8),
    /// Unknown: the rotation varies with the parameters, which only the algebra of
    /// numbers can follow.
    Unknown,
}

impl Turn {
    /// Keeps a rotation in a list.
    pub(super) fn keep<R: Real>(
        rotation: &Rotation<R>,
        list: &mut VecView<R>,
    ) -> Result<Turn, Error> {
        const FULL: Error = Error::CapacityExceeded("rotations of a region or domain");
        let at = u8::try_from(list.len()).map_err(|_| FULL)?;
        let (turn, numbers) = match rotation {
            Rotation::None => return Ok(Turn::World),
            Rotation::Planar(numbers) => (Turn::Planar(at), numbers.as_slice()),
            Rotation::Tilted(rows) => (Turn::Tilted(at), rows.as_flattened()),
        };
        for number in numbers {
            list.push(*number).map_err(|_| FULL)?;
        }
        Ok(turn)
    }

    /// The rotation in its list, if it is known.
    pub(super) fn rotation<R: Real>(self, list: &[R]) -> Option<Rotation<R>> {
        let from = |at: u8| list.get(usize::from(at)..);
        match self {
            Turn::World => Some(Rotation::None),
            Turn::Planar(at) => from(at)?.first_chunk().copied().map(Rotation::Planar),
            Turn::Tilted(at) => {
                let rows = from(at)?.as_chunks().0.first_chunk();
                rows.copied().map(Rotation::Tilted)
            }
            Turn::Unknown => None,
        }
    }
}
