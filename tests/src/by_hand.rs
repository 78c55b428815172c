//! What is said of groups of objects, computed by going through their members.

use critreg::domain::Extreme;
use critreg::grammar::Comparison;

/// Sticks, obstacles and buttons, of which an instance has any number.
pub const TEXT: &str = "
    object stick { x: length, y: length, theta: angle }
    type block { x: length, y: length, theta: angle, w: length }
    object obstacle[6]: block
    object button[3] { x: length, y: length }
    constant reach = 3: length
    parameter mu in [0, 1]
    point grasp = stick + (mu * reach, 0.1)
    point obstacle.tip = obstacle turned 0.5 + (2 * obstacle.w, 0.1)
    shape button = circle(0.25)
";

/// Every number of a member that an instance does not have.
pub const ABSENT: f64 = f64::NAN;

/// An instance, as a person sees it.
#[derive(Clone, Debug)]
pub struct World {
    /// x, y and theta.
    pub stick: [f64; 3],
    /// x, y, theta and w of those that are there.
    pub obstacles: [Option<[f64; 4]>; 6],
    /// x and y of those that are there.
    pub buttons: [Option<[f64; 2]>; 3],
}

impl World {
    /// The numbers of the instance.
    pub fn instance(&self) -> Vec<f64> {
        let obstacles = self.obstacles.iter().flat_map(|o| o.unwrap_or([ABSENT; 4]));
        let buttons = self.buttons.iter().flat_map(|b| b.unwrap_or([ABSENT; 2]));
        self.stick
            .into_iter()
            .chain(obstacles)
            .chain(buttons)
            .collect()
    }

    fn grasp(&self, mu: f64) -> [f64; 2] {
        let [x, y, theta] = self.stick;
        shifted([x, y], theta, [3.0 * mu, 0.1])
    }
}

fn shifted([x, y]: [f64; 2], theta: f64, [dx, dy]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = theta.sin_cos();
    [x + cos * dx - sin * dy, y + sin * dx + cos * dy]
}

/// What is said of each member, as text and by hand.
pub type Said = (&'static str, fn(&World, f64) -> Vec<f64>);

/// A value of each obstacle that is there.
pub fn obstacles(world: &World, value: impl Fn([f64; 4]) -> f64) -> Vec<f64> {
    world
        .obstacles
        .iter()
        .flatten()
        .map(|o| value(*o))
        .collect()
}

/// A value of each button that is there.
pub fn buttons(world: &World, value: impl Fn([f64; 2]) -> f64) -> Vec<f64> {
    world.buttons.iter().flatten().map(|b| value(*b)).collect()
}

fn tip([x, y, theta, w]: [f64; 4]) -> [f64; 2] {
    shifted([x, y], theta + 0.5, [2.0 * w, 0.1])
}

/// How far apart two points are.
pub fn distance([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    (ax - bx).hypot(ay - by)
}

/// Lengths that the instance settles.
pub const SETTLED: [Said; 7] = [
    ("obstacle.x", |w, _| obstacles(w, |[x, ..]| x)),
    ("obstacle.w", |w, _| obstacles(w, |[.., w]| w)),
    ("obstacle.tip.y", |w, _| obstacles(w, |o| tip(o)[1])),
    ("button.y", |w, _| buttons(w, |[_, y]| y)),
    ("button.top.y", |w, _| buttons(w, |[_, y]| y + 0.25)),
    ("dist(stick, button)", |w, _| {
        buttons(w, |b| distance([w.stick[0], w.stick[1]], b))
    }),
    // Both points are of the same member.
    ("dist_x(obstacle, obstacle.tip)", |w, _| {
        obstacles(w, |o| (o[0] - tip(o)[0]).abs())
    }),
];

/// Lengths that the parameter moves.
pub const MOVED: [Said; 5] = [
    ("dist(grasp, obstacle)", |w, mu| {
        obstacles(w, |[x, y, ..]| distance([x, y], w.grasp(mu)))
    }),
    ("dist(obstacle.tip, grasp)", |w, mu| {
        obstacles(w, |o| distance(tip(o), w.grasp(mu)))
    }),
    ("dist_x(grasp, obstacle.tip)", |w, mu| {
        obstacles(w, |o| (tip(o)[0] - w.grasp(mu)[0]).abs())
    }),
    ("dist_y(grasp, button)", |w, mu| {
        buttons(w, |[_, y]| (y - w.grasp(mu)[1]).abs())
    }),
    ("dist(grasp, button.left)", |w, mu| {
        buttons(w, |[x, y]| distance([x - 0.25, y], w.grasp(mu)))
    }),
];

/// A length.
#[derive(Clone, Debug)]
pub enum Length {
    /// A literal.
    Number(f64),
    /// `stick.y`
    StickY,
    /// `grasp.y`
    GraspY,
    /// `min(...)` or `max(...)`
    Over(Extreme, Said),
    /// `k*(a)`
    Scaled(f64, Box<Length>),
    /// `a + b`
    Sum(Box<Length>, Box<Length>),
    /// `a - (b)`
    Difference(Box<Length>, Box<Length>),
}

impl Length {
    /// Its text.
    pub fn text(&self) -> String {
        match self {
            Length::Number(value) => value.to_string(),
            Length::StickY => String::from("stick.y"),
            Length::GraspY => String::from("grasp.y"),
            Length::Over(Extreme::Least, (text, _)) => format!("min({text})"),
            Length::Over(Extreme::Greatest, (text, _)) => format!("max({text})"),
            Length::Scaled(factor, of) => format!("{factor}*({})", of.text()),
            Length::Sum(a, b) => format!("{} + {}", a.text(), b.text()),
            Length::Difference(a, b) => format!("{} - ({})", a.text(), b.text()),
        }
    }

    /// Its value, by going through the members.
    pub fn value(&self, world: &World, mu: f64) -> f64 {
        match self {
            Length::Number(value) => *value,
            Length::StickY => world.stick[1],
            Length::GraspY => world.grasp(mu)[1],
            Length::Over(Extreme::Least, (_, values)) => {
                values(world, mu).into_iter().fold(f64::INFINITY, f64::min)
            }
            Length::Over(Extreme::Greatest, (_, values)) => {
                let values = values(world, mu).into_iter();
                values.fold(f64::NEG_INFINITY, f64::max)
            }
            Length::Scaled(factor, of) => factor * of.value(world, mu),
            Length::Sum(a, b) => a.value(world, mu) + b.value(world, mu),
            Length::Difference(a, b) => a.value(world, mu) - b.value(world, mu),
        }
    }
}

/// Two lengths that are compared.
#[derive(Clone, Debug)]
pub struct Constraint(pub Length, pub Comparison, pub Length);

impl Constraint {
    /// Its text.
    pub fn text(&self) -> String {
        let Constraint(left, comparison, right) = self;
        format!("{} {} {}", left.text(), comparison.symbol(), right.text())
    }

    /// Whether it holds.
    pub fn holds(&self, world: &World, mu: f64) -> bool {
        let Constraint(left, comparison, right) = self;
        comparison.holds(&left.value(world, mu), &right.value(world, mu))
    }

    /// Whether the sides are equal but for rounding, which then decides; they can be
    /// along a whole line, as in `grasp.y - dist_y(grasp, button) < button.y`.
    pub fn is_close(&self, world: &World, mu: f64) -> bool {
        let Constraint(left, _, right) = self;
        (left.value(world, mu) - right.value(world, mu)).abs() < 1e-9
    }
}
