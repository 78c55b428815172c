//! The actions of `ACTIONS.md`.

const PAGE: &str = include_str!("../../ACTIONS.md");

/// The domain text and the region that the page has below a heading.
///
/// # Panics
/// If it has none there.
pub fn section(heading: &str) -> [&'static str; 2] {
    let mut sections = PAGE.split("\n## ").skip(1);
    let found = sections.find_map(|section| section.strip_prefix(heading)?.strip_prefix('\n'));
    let section = found.unwrap_or_else(|| panic!("the page has no section {heading}"));
    // Every other piece is within a fence.
    let fences: Vec<_> = section.split("```\n").skip(1).step_by(2).collect();
    let fences = <[_; 2]>::try_from(fences);
    fences.unwrap_or_else(|found| panic!("{heading}: a text and a region, not {found:#?}"))
}
