//! What is written, as a string.

use critreg::domain::Domain;
use critreg::region::Region;

/// A region as text.
///
/// # Panics
/// If the region is of another domain.
pub fn of_region(domain: &Domain<'_>, region: &Region) -> String {
    let mut text = String::new();
    let written = region.write(domain, &mut text);
    written.expect("the region is of this domain, and a string has room");
    text
}
