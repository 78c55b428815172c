//! Pictures of what is learned and of what it saves, as SVG.

mod plot;
pub mod regions;
pub mod samples;
mod scene;
mod svg;

use regions::Regions;

/// All pictures: the name of the file, and its text.
pub fn pictures() -> [(&'static str, String); 2] {
    [
        ("scene.svg", scene::scene(&Regions::learn())),
        ("samples.svg", plot::plot(&samples::measure())),
    ]
}
