//! Shapes and words as the text of an SVG picture.

use std::fmt::Write;

/// A place in a picture: to the right and down, in pixels.
pub(super) type Point = [f64; 2];

/// Strings grow, so writing to one does not fail.
const GROWS: &str = "strings grow";

/// How everything looks, by class. The background is white for readers in the dark, too.
const STYLE: &str = "\
text{font:13px sans-serif;fill:#222}
.title{font-weight:bold}
.small{font-size:11px}
.code{font:10px monospace}
.middle{text-anchor:middle}
.end{text-anchor:end}
.background{fill:#fff}
.table{fill:none;stroke:#555}
.zone{fill:#e8eef7}
.feasible{fill:#1a9641}
.partly{fill:#b8e0b0}
.infeasible{fill:#e58a86}
.robot{fill:#4575b4;stroke:#222}
.button{fill:#ffd42a;stroke:#222}
.holder{fill:#8c6d46;stroke:#222}
.stick{fill:#222}
.tip{fill:#d600a8}
.axis{fill:none;stroke:#555}
.grid{fill:none;stroke:#ddd}
.original{fill:none;stroke:#d55e00;stroke-width:1.5}
.learned{fill:none;stroke:#0072b2;stroke-width:1.5}
.original-mark{fill:#d55e00}
.learned-mark{fill:#0072b2}
";

/// A picture that is being drawn. All numbers have two decimals, so that it is the same
/// text everywhere.
pub(super) struct Svg {
    text: String,
}

impl Svg {
    /// A white picture of this size. The title is for those who cannot see it.
    pub(super) fn new([width, height]: Point, title: &str) -> Svg {
        let mut svg = Svg {
            text: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" \
                 width=\"{width:.0}\" height=\"{height:.0}\" \
                 viewBox=\"0 0 {width:.0} {height:.0}\">\n\
                 <title>{}</title>\n<style>\n{STYLE}</style>\n",
                escaped(title)
            ),
        };
        svg.rectangle([0.0, 0.0], [width, height], "background");
        svg
    }

    /// A rectangle from its upper left corner.
    pub(super) fn rectangle(&mut self, [x, y]: Point, [width, height]: Point, class: &str) {
        writeln!(
            self.text,
            "<rect class=\"{class}\" x=\"{x:.2}\" y=\"{y:.2}\" \
             width=\"{width:.2}\" height=\"{height:.2}\"/>"
        )
        .expect(GROWS);
    }

    /// A circle.
    pub(super) fn circle(&mut self, [x, y]: Point, radius: f64, class: &str) {
        writeln!(
            self.text,
            "<circle class=\"{class}\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\"/>"
        )
        .expect(GROWS);
    }

    /// A closed line through these points.
    pub(super) fn polygon(&mut self, points: &[Point], class: &str) {
        self.through("polygon", points, class);
    }

    /// An open line through these points.
    pub(super) fn line(&mut self, points: &[Point], class: &str) {
        self.through("polyline", points, class);
    }

    fn through(&mut self, element: &str, points: &[Point], class: &str) {
        let points: Vec<_> = points
            .iter()
            .map(|[x, y]| format!("{x:.2},{y:.2}"))
            .collect();
        let points = points.join(" ");
        writeln!(
            self.text,
            "<{element} class=\"{class}\" points=\"{points}\"/>"
        )
        .expect(GROWS);
    }

    /// Words, of which the class says whether they start, end or have their middle at
    /// this point of the base line.
    pub(super) fn words(&mut self, [x, y]: Point, words: &str, class: &str) {
        let words = escaped(words);
        writeln!(
            self.text,
            "<text class=\"{class}\" x=\"{x:.2}\" y=\"{y:.2}\">{words}</text>"
        )
        .expect(GROWS);
    }

    /// The text of the picture.
    pub(super) fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }
}

fn escaped(words: &str) -> String {
    let words = words.replace('&', "&amp;").replace('<', "&lt;");
    words.replace('>', "&gt;")
}
