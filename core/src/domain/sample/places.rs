//! Where things are at a sample, for those who look at it.

use super::Sample;
use crate::geometry::Body;
use crate::real::Real;

impl<R: Real> Sample<'_, '_, R, R> {
    /// Where a point is; not a number if it belongs to an absent member of a group.
    pub(crate) fn position(&self, point: u8) -> [R; 3] {
        self.origin(point)
    }

    /// The direction of a point's x axis.
    pub(crate) fn direction(&self, point: u8) -> Option<[R; 3]> {
        self.heading(point).map(|(direction, _)| direction)
    }

    /// The body of a point where it stands; `None` if it has none.
    pub(crate) fn body_of(&self, point: u8) -> Option<Body<R>> {
        self.scene.domain.body_of(point)?;
        let standing = self.body(point)?;
        Some(Body {
            centre: standing.centre,
            ..standing.body
        })
    }
}
