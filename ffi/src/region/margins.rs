//! The constraints of a region as functions, for optimisers.

use crate::boundary::handle;
use crate::boundary::pointer::{self, OutputArray};
use crate::boundary::precision::in_precision;
use crate::boundary::status::critreg_status;
use crate::region::handle::critreg_region;
use critreg_core::domain::MAX_PARAMETERS;
use critreg_core::grammar::MAX_CONSTRAINTS;

/// How far each constraint of a region is from its bound, with gradients: what an optimiser
/// calls g(x) <= 0.
///
/// A value is at most 0 where the constraint holds, and below 0 where it says < or >. The
/// constraints are in the order of the text, critreg_region_constraint_count() of them. Of
/// a region that joins them by "and" they are all there is to know; of another one they
/// are its constraints without "or" and "not".
///
/// Parameters may be outside of their ranges in the domain text, which are bounds of the
/// optimiser's variables. A constraint over no member of a group has
/// the value minus infinity, one about a body that is absent plus infinity; their gradients
/// are 0. At a kink, such as that of a distance along an axis where it is 0, the derivative
/// is the one for a growing parameter.
///
/// ```c
/// double g[CRITREG_MAX_CONSTRAINTS];
/// double by_theta[CRITREG_MAX_CONSTRAINTS * CRITREG_MAX_PARAMETERS];
/// critreg_region_margins(region, instance, theta, g, by_theta);
/// ```
///
/// @param region The region.
/// @param instance The instance: one number per attribute.
/// @param theta The parameters: one number each; NULL if there are none.
/// @param values Receives one number per constraint; NULL if there are none.
/// @param gradients NULL, or receives for each constraint its derivative by each parameter:
/// those of the first constraint, those of the second one, and so on.
/// @return CRITREG_NOT_FINITE for a number of the instance or of theta;
/// CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_region_margins(
    region: *const critreg_region,
    instance: *const f64,
    theta: *const f64,
    values: *mut f64,
    gradients: *mut f64,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        handle::read(region, |handle| {
            let constraints = handle.region.formula().constraints().len();
            let parameters = handle.domain.parameters().len();
            let entries = match gradients.is_null() {
                true => 0,
                false => constraints * parameters,
            };
            let values = OutputArray::new(values, constraints, "values")?;
            let gradients = OutputArray::new(gradients, entries, "gradients")?;
            let theta = pointer::slice(theta, parameters, "theta")?;
            let instance = handle.instance(instance)?;
            let mut found = [0.0; MAX_CONSTRAINTS];
            let mut by_theta = [0.0; MAX_CONSTRAINTS * MAX_PARAMETERS];
            // There is room: no region has more constraints, no action more parameters.
            let found = found.get_mut(..constraints).unwrap_or_default();
            let by_theta = by_theta.get_mut(..entries).unwrap_or_default();
            in_precision!(handle.precision, R => handle.region.margins::<R>(
                handle.domain, instance, theta, found, by_theta,
            )?);
            values.write(found);
            gradients.write(by_theta);
            Ok(())
        })
    }
}
