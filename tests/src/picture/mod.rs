//! Pictures of what is learned and of what it saves, as SVG.

mod action;
mod plot;
pub mod regions;
pub mod samples;
mod scene;
mod style;

use regions::Regions;

/// All pictures: the name of the file, and its text.
///
/// # Panics
/// If the action of the page cannot be drawn.
pub fn pictures() -> [(&'static str, String); 3] {
    let pictures = [
        ("scene.svg", scene::scene(&Regions::learn())),
        ("samples.svg", plot::plot(&samples::measure())),
        ("reach.svg", action::action()),
    ];
    pictures.map(|(name, text)| (name, text.expect("strings grow")))
}
