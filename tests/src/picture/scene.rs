//! The table from above, with the part of the stick where a grasp works (thesis Fig.
//! 6.1, 6.2 and 7.1).

use super::regions::{Learned, Panel, Regions};
use super::style::STYLE;
use critreg::Error;
use critreg::env::stick_button::{
    BUTTON_RADIUS, HOLDER_HEIGHT, HOLDER_WIDTH, ROBOT_RADIUS, STICK_HEIGHT, STICK_WIDTH,
    TABLE_HEIGHT, TABLE_WIDTH, TIP_WIDTH, World, ZONE_HEIGHT,
};
use critreg::geometry::Rectangle;
use critreg::picture::{Place, Svg};

/// Pixels per unit of length.
const SCALE: f64 = 46.0;
/// Pixels around the tables.
const SPACE: f64 = 20.0;
/// Pixels above a table, for its title.
const HEAD: f64 = 28.0;
/// The size of a table with its title and the space behind, in pixels.
const CELL: Place = [
    TABLE_WIDTH * SCALE + SPACE,
    TABLE_HEIGHT * SCALE + HEAD + SPACE,
];
/// Half the width of the bands that tell the parts of the stick, which itself is too thin
/// for colours.
const BAND: f64 = 0.12;

/// The picture: three tasks, and what the colours mean.
pub(super) fn scene(regions: &Regions) -> Result<String, Error> {
    const TITLE: &str = "Three tasks of the stick-button environment; the part of the stick where \
                         the learned regions say that a grasp works is green";
    let mut text = String::new();
    let size = [2.0 * CELL[0] + SPACE, 2.0 * CELL[1]];
    let mut svg = Svg::begin(&mut text, size, |out| out.write_str(TITLE), STYLE)?;
    let [right, below] = [SPACE + CELL[0], CELL[1]];
    let corners = [[SPACE, 0.0], [right, 0.0], [SPACE, below]];
    for (panel, [x, y]) in regions.panels().iter().zip(corners) {
        svg.words([x, y + HEAD - 8.0], panel.title, "title")?;
        let corner = [x, y + HEAD];
        Table { corner }.draw(&mut svg, panel)?;
    }
    legend(&mut svg, [right, below + HEAD], regions)?;
    svg.end()?;
    Ok(text)
}

/// A table of the picture.
struct Table {
    /// Its upper left corner.
    corner: Place,
}

impl Table {
    /// Where a point of the table is in the picture.
    fn place(&self, [x, y]: [f64; 2]) -> Place {
        let [left, top] = self.corner;
        [left + x * SCALE, top + (TABLE_HEIGHT - y) * SCALE]
    }

    fn draw(&self, svg: &mut Svg<'_>, panel: &Panel<'_>) -> Result<(), Error> {
        let size = |height| [TABLE_WIDTH * SCALE, height * SCALE];
        svg.rectangle(self.place([0.0, ZONE_HEIGHT]), size(ZONE_HEIGHT), "zone")?;
        svg.rectangle(self.corner, size(TABLE_HEIGHT), "table")?;
        let world = World::of(&panel.state).expect("a state of the environment");
        let [x, y, theta, _] = *world.stick;
        let stick = Rectangle::new([x, y], [STICK_WIDTH, STICK_HEIGHT], theta);
        self.band(svg, &stick, [0.0, 1.0], "infeasible")?;
        for (intervals, class) in [(&panel.pick, "partly"), (&panel.feasible, "feasible")] {
            for interval in intervals {
                self.band(svg, &stick, *interval, class)?;
            }
        }
        let [x, y, theta] = *world.holder;
        let holder = Rectangle::new([x, y], [HOLDER_WIDTH, HOLDER_HEIGHT], theta);
        self.rectangle(svg, &holder, "holder")?;
        self.rectangle(svg, &stick, "stick")?;
        let tip = part(&stick, [1.0 - TIP_WIDTH / STICK_WIDTH, 1.0], 0.0);
        self.rectangle(svg, &tip, "tip")?;
        for [x, y, _] in world.buttons {
            svg.circle(self.place([*x, *y]), BUTTON_RADIUS * SCALE, "button")?;
        }
        let [x, y, _] = *world.robot;
        svg.circle(self.place([x, y]), ROBOT_RADIUS * SCALE, "robot")?;
        for mu in panel.feasible.iter().flatten() {
            self.label(svg, &stick, *mu)?;
        }
        Ok(())
    }

    fn rectangle(
        &self,
        svg: &mut Svg<'_>,
        rectangle: &Rectangle<f64>,
        class: &str,
    ) -> Result<(), Error> {
        let corners = rectangle.vertices().map(|corner| self.place(corner));
        svg.polygon(&corners, class)
    }

    fn band(
        &self,
        svg: &mut Svg<'_>,
        stick: &Rectangle<f64>,
        from_to: [f64; 2],
        class: &str,
    ) -> Result<(), Error> {
        self.rectangle(svg, &part(stick, from_to, BAND), class)
    }

    /// The number of a place along the stick, beside it.
    fn label(&self, svg: &mut Svg<'_>, stick: &Rectangle<f64>, mu: f64) -> Result<(), Error> {
        let beside = [mu * STICK_WIDTH, -BAND - 0.08];
        let [x, y] = self.place(stick.frame.apply(beside));
        svg.words([x, y + 4.0], &format!("{mu:.2}"), "small")
    }
}

/// The stick from one share of its width to another, wider on both sides.
fn part(stick: &Rectangle<f64>, [from, to]: [f64; 2], wider: f64) -> Rectangle<f64> {
    Rectangle {
        frame: stick.frame.shifted([from * STICK_WIDTH, -wider]),
        width: (to - from) * STICK_WIDTH,
        height: STICK_HEIGHT + 2.0 * wider,
    }
}

fn legend(svg: &mut Svg<'_>, [x, mut y]: Place, regions: &Regions) -> Result<(), Error> {
    const LINE: f64 = 19.0;
    let bands = [
        ("feasible", "the learned region: grasps that work"),
        ("partly", "the pick works, but not the press after it"),
        ("infeasible", "grasps that fail"),
        ("zone", "where the robot may be"),
        ("holder", "holder"),
        ("stick", "stick"),
        ("tip", "its tip"),
    ];
    for (class, words) in bands {
        svg.rectangle([x, y], [18.0, 11.0], class)?;
        svg.words([x + 28.0, y + 10.0], words, "")?;
        y += LINE;
    }
    for class in ["robot", "button"] {
        svg.circle([x + 9.0, y + 6.0], ROBOT_RADIUS * SCALE, class)?;
        svg.words([x + 28.0, y + 10.0], class, "")?;
        y += LINE;
    }
    let learned: [(&str, &Learned); 2] = [
        ("Pick", &regions.pick),
        ("Pick, then press", &regions.chain),
    ];
    for (name, learned) in learned {
        y += 22.0;
        let title = format!(
            "{name}: learned from {} tries in {} tasks",
            learned.tries(),
            learned.tasks()
        );
        svg.words([x, y], &title, "")?;
        for constraint in learned.constraints() {
            y += 15.0;
            svg.words([x, y], &constraint, "code")?;
        }
    }
    Ok(())
}
