//! The words of expressions. The parser, the writer, the reserved names and the error for
//! an unknown function all use these lists, and so agree.

use crate::domain::{Beam, Coordinate, Extreme, Metric, Quantity};
use crate::geometry::{Axis, Relation};

/// What a name before brackets means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Function {
    /// A quantity of two points, of three, or one of each. The points in the list of
    /// functions are 0, 1 and 2.
    OfPoints(Option<Quantity>, Option<Quantity>),
    /// The area of an object's shape.
    Area,
    /// The extreme of a quantity over the members of a group.
    Extreme(Extreme),
}

/// The functions by name; a macro, so that the error has the names from the same list.
macro_rules! functions {
    ($first:literal: $first_function:expr, $($name:literal: $function:expr,)*) => {
        const FUNCTIONS: &[(&str, Function)] = &[
            ($first, $first_function),
            $(($name, $function),)*
        ];

        /// The error for any other name.
        pub(super) const UNKNOWN_FUNCTION: &str =
            concat!("unknown function; there are ", $first, $(", ", $name,)*);
    };
}

functions! {
    "dist": Function::OfPoints(Some(Quantity::Distance(Metric::Straight, 0, 1)), None),
    "dist_x": Function::OfPoints(Some(Quantity::Distance(Metric::X, 0, 1)), None),
    "dist_y": Function::OfPoints(Some(Quantity::Distance(Metric::Y, 0, 1)), None),
    "dist_z": Function::OfPoints(Some(Quantity::Distance(Metric::Z, 0, 1)), None),
    "angle": Function::OfPoints(
        Some(Quantity::Angle(0, 1)),
        Some(Quantity::VertexAngle(0, 1, 2)),
    ),
    "off": Function::OfPoints(Some(Quantity::Off(0, 1)), None),
    "clear": related(Relation::Clear),
    "inside": related(Relation::Inside),
    "inside_x": related(Relation::InsideAlong(Axis::X)),
    "inside_y": related(Relation::InsideAlong(Axis::Y)),
    "inside_z": related(Relation::InsideAlong(Axis::Z)),
    "over": related(Relation::Over),
    "corner": related(Relation::Corner),
    "x_in": related(Relation::Coordinate(Axis::X)),
    "y_in": related(Relation::Coordinate(Axis::Y)),
    "z_in": related(Relation::Coordinate(Axis::Z)),
    "abs_x_in": related(Relation::Magnitude(Axis::X)),
    "abs_y_in": related(Relation::Magnitude(Axis::Y)),
    "abs_z_in": related(Relation::Magnitude(Axis::Z)),
    "area": Function::Area,
    "min": Function::Extreme(Extreme::Least),
    "max": Function::Extreme(Extreme::Greatest),
}

/// What may also be said of a line in place of the first body.
pub(super) const CLEAR: Quantity = Quantity::Relation(Relation::Clear, 0, 1);

/// A relation of the first body to the second one.
const fn related(relation: Relation) -> Function {
    Function::OfPoints(Some(Quantity::Relation(relation, 0, 1)), None)
}

/// What a straight line between two points may be, as the first thing that is clear of
/// another one.
const BEAMS: &[(&str, Beam)] = &[("line", Beam::Line), ("sweep", Beam::Sweep)];

/// What a name behind a point and a dot means.
const COORDINATES: &[(&str, Coordinate)] = &[
    ("x", Coordinate::X),
    ("y", Coordinate::Y),
    ("z", Coordinate::Z),
    ("theta", Coordinate::Theta),
];

/// The word before the number of ways in which a thing can be turned and look the same.
pub(super) const SYMMETRY: &str = "symmetry";

/// The number pi.
pub(super) const PI: &str = "pi";

/// Whether a name means something in every expression, whatever a domain declares.
pub(in crate::domain) fn is_reserved(name: &str) -> bool {
    [PI, SYMMETRY].contains(&name) || function(name).is_some() || beam(name).is_some()
}

/// The function of this name.
pub(super) fn function(name: &str) -> Option<Function> {
    meaning(FUNCTIONS, name).filter(|function| {
        let between_bodies = matches!(
            function,
            Function::OfPoints(Some(Quantity::Relation(..)), _)
        );
        cfg!(feature = "bodies") || !between_bodies
    })
}

/// The extreme of this name.
pub(super) fn extreme(name: &str) -> Option<Extreme> {
    match function(name)? {
        Function::Extreme(extreme) => Some(extreme),
        Function::OfPoints(..) | Function::Area => None,
    }
}

/// The line of this name.
pub(super) fn beam(name: &str) -> Option<Beam> {
    meaning(BEAMS, name)
}

/// The coordinate of this name.
pub(super) fn coordinate(name: &str) -> Option<Coordinate> {
    meaning(COORDINATES, name)
}

fn meaning<T: Copy>(words: &[(&str, T)], name: &str) -> Option<T> {
    let mut words = words.iter();
    words
        .find(|(own, _)| *own == name)
        .map(|(_, meaning)| *meaning)
}

/// The name of the function that makes this quantity of points.
pub(super) fn name_of_quantity(quantity: Quantity) -> Option<&'static str> {
    let example = match quantity.with_points([0, 1, 2]) {
        Quantity::Sight(..) => CLEAR,
        Quantity::FoldedAngle(_, a, b) => Quantity::Angle(a, b),
        example => example,
    };
    name(FUNCTIONS, |function| match *function {
        Function::OfPoints(two, three) => [two, three].contains(&Some(example)),
        Function::Area | Function::Extreme(_) => false,
    })
}

/// The name of the area or of an extreme.
pub(super) fn name_of(function: Function) -> Option<&'static str> {
    name(FUNCTIONS, |own| *own == function)
}

/// The name of a line.
pub(super) fn name_of_beam(beam: Beam) -> Option<&'static str> {
    name(BEAMS, |own| *own == beam)
}

/// The name of a coordinate.
pub(super) fn name_of_coordinate(coordinate: Coordinate) -> Option<&'static str> {
    name(COORDINATES, |own| *own == coordinate)
}

fn name<T>(words: &[(&'static str, T)], is_it: impl Fn(&T) -> bool) -> Option<&'static str> {
    let mut words = words.iter();
    words.find(|(_, own)| is_it(own)).map(|(name, _)| *name)
}

impl Extreme {
    /// Its name in the texts.
    pub fn name(self) -> &'static str {
        name_of(Function::Extreme(self)).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::{Domain, Node};
    use crate::error::Error;
    use crate::text::Lexer;
    use heapless::Vec as Nodes;
    use std::collections::BTreeSet;
    use std::format;
    use std::string::{String, ToString};
    use std::vec::Vec;

    /// The points 0, 1 and 2, those of the shape 0, and a group whose `x` is number 12.
    const DOMAIN: &str = "type pose { x: length, y: length, z: length, theta: angle }
        object a, b, c: pose shape a = circle(1) object d[2]: pose";
    const POINTS: [&str; 3] = ["a", "b", "c"];

    /// Every function and coordinate in a text, with what it is.
    fn examples() -> Vec<(String, Node)> {
        let mut examples = Vec::new();
        for (name, function) in FUNCTIONS {
            match function {
                Function::OfPoints(two, three) => {
                    for quantity in [*two, *three].into_iter().flatten() {
                        let points = quantity.points().into_iter().flatten();
                        let points: Vec<_> = points.map(|p| POINTS[usize::from(p)]).collect();
                        let text = format!("{name}({})", points.join(", "));
                        examples.push((text, Node::Quantity(quantity)));
                    }
                }
                Function::Area => examples.push((format!("{name}(a)"), Node::Area(0))),
                Function::Extreme(extreme) => {
                    let term = Node::Extreme(*extreme, Quantity::Attribute(12));
                    examples.push((format!("{name}(d.x)"), term));
                }
            }
        }
        for (name, beam) in BEAMS {
            let quantity = Quantity::Sight(*beam, 0, 1, 2);
            examples.push((format!("clear({name}(a, b), c)"), Node::Quantity(quantity)));
        }
        for (name, coordinate) in COORDINATES {
            let quantity = Quantity::Coordinate(*coordinate, 3);
            examples.push((format!("a.left.{name}"), Node::Quantity(quantity)));
        }
        examples
    }

    #[test]
    fn each_is_read_and_written_as_what_it_is() {
        let domain = Domain::parse(DOMAIN).unwrap();
        let examples = examples();
        let words = FUNCTIONS.len() + BEAMS.len() + COORDINATES.len();
        // There are two functions called `angle`.
        assert_eq!(examples.len(), words + 1);
        for (text, term) in examples {
            let mut nodes: Nodes<Node, 1> = Nodes::new();
            let mut lexer = Lexer::new(&text);
            let id = domain.parse_expression(&mut lexer, &mut nodes).unwrap();
            assert_eq!(nodes.as_slice(), [term], "{text}");
            let mut written = String::new();
            domain.write_expression(&mut written, &nodes, id).unwrap();
            assert_eq!(written, text);
        }
    }

    #[test]
    fn no_declaration_has_the_name_of_a_word() {
        let functions = FUNCTIONS.iter().map(|(name, _)| *name);
        let lines = BEAMS.iter().map(|(name, _)| *name);
        for name in functions
            .chain(lines)
            .chain([SYMMETRY, PI, "relate", "centred"])
        {
            let text = format!("parameter {name} in [0, 1]");
            let error = Domain::parse(&text).unwrap_err().to_string();
            assert_eq!(error, "line 1, column 11: this is a word of the language");
            let text = format!("type {name} {{ }}");
            assert!(
                matches!(Domain::parse(&text), Err(Error::Syntax(_))),
                "{name}"
            );
        }
    }

    #[test]
    fn an_unknown_function_is_answered_with_those_that_there_are() {
        let error = Domain::parse("constant c = far(1): none").unwrap_err();
        let names: Vec<_> = FUNCTIONS.iter().map(|(name, _)| *name).collect();
        assert_eq!(
            error.to_string(),
            format!(
                "line 1, column 14: unknown function; there are {}",
                names.join(", ")
            )
        );
    }

    #[test]
    fn the_grammar_in_the_documentation_has_each_function() {
        let grammar = include_str!("../mod.rs").lines();
        let rules = grammar.skip_while(|line| !line.starts_with("//! extreme"));
        let rules: Vec<_> = rules
            .take_while(|line| !line.starts_with("//! path"))
            .collect();
        let rules = rules.join("\n");
        // Every second piece is quoted. Some of these are signs.
        let quoted = rules.split('"').skip(1).step_by(2);
        let is_known = |word: &&str| function(word).is_some() || beam(word).is_some();
        let documented: BTreeSet<_> = quoted.filter(is_known).collect();
        let functions = FUNCTIONS.iter().map(|(name, _)| *name);
        let names: BTreeSet<_> = functions
            .chain(BEAMS.iter().map(|(name, _)| *name))
            .collect();
        assert_eq!(documented, names);
    }
}
