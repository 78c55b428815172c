//! Pictures show what is true.

use critreg::Error;
use critreg::domain::Domain;
use critreg::picture::{Picture, Tried, write_fixed};
use critreg::random::{generator, uniform_in};
use critreg::real::Real;
use critreg::region::Region;

const PICK: &str = "
    object stick { x: length, y: length, theta: angle }
    object post[2] { x: length, y: length, radius: length }
    parameter mu in [-1, 3]: length
    point grasp = stick + (mu, 0)
    shape post = circle(post.radius)
    shape grasp = capsule(0.2, 0.1) centred";
const PICK_REGION: &str = "min(clear(grasp, post)) >= 0 and grasp.y < 2";
const PICK_INSTANCE: [f64; 9] = [0.5, 0.25, 0.75, 1.5, 1.0, 0.2, f64::NAN, f64::NAN, f64::NAN];

const REACH: &str = "
    object cup { x: length, y: length }
    parameter bx in [-1, 1]: length
    parameter by in [0, 4]: length
    parameter yaw in [-1, 1]: angle
    point base = world + (bx, by)
    point hand = base turned yaw + (0.5, 0)";

fn nothing(_: &mut dyn FnMut(&[f64], bool)) {}

fn draw<R: Real>(
    domain: &Domain<'_>,
    instance: &[f64],
    region: Option<&Region>,
    tried: &Tried<'_>,
) -> Result<String, Error> {
    let mut svg = String::new();
    let picture = Picture {
        domain,
        instance,
        region,
        tried,
    };
    picture.write_svg::<R>(&mut svg)?;
    Ok(svg)
}

/// The values of an attribute in the elements of a class.
fn values(svg: &str, element: &str, class: &str, attribute: &str) -> Vec<String> {
    let begin = format!("<{element} class=\"{class}\"");
    let begin_of_value = format!(" {attribute}=\"");
    let lines = svg.lines().filter(|line| line.starts_with(&begin));
    lines
        .map(|line| {
            let (_, rest) = line.split_once(&begin_of_value).unwrap();
            rest.split('"').next().unwrap().to_string()
        })
        .collect()
}

fn numbers(text: &str) -> Vec<f64> {
    let separate = |letter: char| !(letter.is_ascii_digit() || letter == '.' || letter == '-');
    let numbers = text.split(separate).filter(|number| !number.is_empty());
    numbers.map(|number| number.parse().unwrap()).collect()
}

#[test]
fn what_is_green_of_one_parameter_is_in_the_region_and_nothing_else() {
    let domain = Domain::parse(PICK).unwrap();
    let region = Region::parse(&domain, PICK_REGION).unwrap();
    let svg = draw::<f64>(&domain, &PICK_INSTANCE, Some(&region), &nothing).unwrap();
    let read = |class, attribute| -> Vec<f64> {
        let values = values(&svg, "rect", class, attribute);
        values.iter().map(|value| value.parse().unwrap()).collect()
    };
    // The last one of a class is in the legend.
    let (band, width) = (read("fails", "x")[0], read("fails", "width")[0]);
    let green: Vec<_> = read("works", "x")
        .into_iter()
        .zip(read("works", "width"))
        .collect();
    let (_, green) = green.split_last().unwrap();
    assert_eq!(green.len(), 2, "the post cuts the stick in two");
    let mut seen = [0; 2];
    for step in 0..=400 {
        let mu = -1.0 + f64::from(step) / 100.0;
        let x = band + width * (mu + 1.0) / 4.0;
        let ends = green.iter().flat_map(|(from, size)| [*from, from + size]);
        if ends.clone().any(|end| (end - x).abs() < 0.1) {
            continue;
        }
        let is_green = green
            .iter()
            .any(|(from, size)| (*from..from + size).contains(&x));
        let inside = region
            .contains::<f64>(&domain, &PICK_INSTANCE, &[mu])
            .unwrap();
        assert_eq!(is_green, inside, "{mu}");
        seen[usize::from(inside)] += 1;
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}

#[test]
fn what_is_green_of_two_parameters_is_in_the_region_and_nothing_else() {
    const STRAIGHT: &str = "
        object cup { x: length, y: length }
        parameter bx in [-1, 1]: length
        parameter by in [0, 4]: length
        point base = world + (bx, by)";
    // Along a row there is no closed form.
    const TURNED: &str = "
        object cup { x: length, y: length }
        parameter yaw in [-1, 1]: angle
        parameter reach in [0, 4]: length
        point ray = world turned yaw
        point base = ray + (reach, 0)";
    for (domain, text, instance) in [
        (STRAIGHT, "dist(base, cup) >= 1 or bx > 0.5", [0.25, 2.0]),
        (TURNED, "dist(base, cup) <= 1.5", [2.0, 0.25]),
    ] {
        let domain = Domain::parse(domain).unwrap();
        let region = Region::parse(&domain, text).unwrap();
        let svg = draw::<f64>(&domain, &instance, Some(&region), &nothing).unwrap();
        let area = &values(&svg, "path", "works", "d")[0];
        let frame = values(&svg, "rect", "frame", "x").len() - 1;
        let [left, top, width, height] = ["x", "y", "width", "height"].map(|attribute| {
            values(&svg, "rect", "frame", attribute)[frame]
                .parse::<f64>()
                .unwrap()
        });
        let boxes: Vec<_> = area
            .split('Z')
            .map(numbers)
            .filter(|own| own.len() == 8)
            .collect();
        let mut rng = generator(5);
        let mut seen = [0; 2];
        for _ in 0..2000 {
            let theta = [
                uniform_in(&mut rng, -1.0, 1.0),
                uniform_in(&mut rng, 0.0, 4.0),
            ];
            let x = left + width * (theta[0] + 1.0) / 2.0;
            let y = top + height * (1.0 - theta[1] / 4.0);
            let holds = |step: [f64; 2]| {
                let theta = [theta[0] + step[0], theta[1] + step[1]];
                region.contains::<f64>(&domain, &instance, &theta).unwrap()
            };
            // A row is as high as two pixels, of which one is 1/150 or 2/150 here.
            let steps = [-0.03, 0.0, 0.03];
            let near = steps.iter().flat_map(|a| steps.iter().map(|b| [*a, *b]));
            let near: Vec<_> = near.map(holds).collect();
            let inside = holds([0.0; 2]);
            if near.iter().any(|own| *own != inside) {
                continue;
            }
            let is_green = boxes.iter().any(|own| {
                let (mut xs, mut ys) = ([own[0], own[2]], [own[1], own[5]]);
                xs.sort_by(f64::total_cmp);
                ys.sort_by(f64::total_cmp);
                xs[0] <= x && x <= xs[1] && ys[0] <= y && y <= ys[1]
            });
            assert_eq!(is_green, inside, "{text}: {theta:?}");
            seen[usize::from(inside)] += 1;
        }
        assert!(seen.iter().all(|count| *count > 200), "{text}: {seen:?}");
    }
}

#[test]
fn bodies_and_what_was_tried_are_where_they_are() {
    let domain = Domain::parse(PICK).unwrap();
    let tried = |mark: &mut dyn FnMut(&[f64], bool)| {
        mark(&[0.0], true);
        mark(&[3.0], false);
        mark(&[-1.0], true);
    };
    let svg = draw::<f64>(&domain, &PICK_INSTANCE, None, &tried).unwrap();
    // Where the stick and the post that is there lie tells the scale.
    let posts: Vec<f64> = ["cx", "cy", "r"]
        .iter()
        .map(|own| values(&svg, "circle", "body", own)[0].parse().unwrap())
        .collect();
    assert_eq!(
        values(&svg, "circle", "body", "r").len(),
        1,
        "the other is absent"
    );
    let scale = posts[2] / 0.2;
    let place = |x: f64, y: f64| [posts[0] + (x - 1.5) * scale, posts[1] - (y - 1.0) * scale];
    for (class, expected) in [("worked", vec![0.0, -1.0]), ("failed", vec![3.0])] {
        let marks = &values(&svg, "path", class, "d")[0];
        let begins = marks.split('M').skip(1);
        let begins = begins.map(|mark| mark.split(['h', 'l']).next().unwrap());
        let marks: Vec<_> = begins.map(numbers).collect();
        assert_eq!(marks.len(), expected.len());
        for (mark, mu) in marks.iter().zip(expected) {
            let [x, y] = place(0.5 + mu * 0.75_f64.cos(), 0.25 + mu * 0.75_f64.sin());
            // A cross begins above and left of its middle.
            let shift = if class == "failed" { 3.5 } else { 0.0 };
            assert!((mark[0] + shift - x).abs() < 0.1 && (mark[1] + shift - y).abs() < 0.1);
        }
    }
    // Nothing is expected without a region.
    assert!(svg.contains("class=\"unknown-body\"") && !svg.contains("class=\"works"));
}

#[test]
fn anything_can_be_drawn() {
    let cases = [
        ("parameter x in [0, 1]", "x < 0.5 and x > 0.25", vec![]),
        (
            "parameter x in [0, 1] parameter y in [-1e300, 1e300]",
            "x >= y",
            vec![],
        ),
        ("object lamp { on: flag }", "lamp.on >= 1", vec![1.0]),
        (
            "object a { x: length, y: length }",
            "a.x > 0 and a.x < 0",
            vec![1.0, 1.0],
        ),
        (REACH, "dist(hand, cup) <= 0.01", vec![0.1, 0.2]),
        (
            REACH,
            "dist(hand, cup) <= 0.01 and bx > 2",
            vec![1e200, 1e-200],
        ),
        (PICK, PICK_REGION, PICK_INSTANCE.to_vec()),
        (PICK, "true", vec![f64::MAX; 9]),
        (
            "object box { x: length, y: length, z: length, yaw: angle, pitch: angle }
             parameter a in [0, 1]: angle parameter b in [0, 1]: angle
             parameter c in [0, 1]: length parameter d in [0, 1]: length
             parameter e in [0, 1]: length
             point hand = box turned (a, b, 0.1) + (c, d, e)
             shape box = box(0.1, 0.2, 0.3) rounded 0.01 centred",
            "clear(hand, box) >= 0.1",
            vec![1.0, 2.0, 3.0, 0.5, 0.25],
        ),
    ];
    for (domain, region, instance) in cases {
        let domain = Domain::parse(domain).unwrap();
        let region = Region::parse(&domain, region).unwrap();
        for shown in [None, Some(&region)] {
            let svg = draw::<f64>(&domain, &instance, shown, &nothing).unwrap();
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
            assert!(svg.ends_with("</svg>\n"));
            let open = svg.matches("<text").count() + svg.matches("<tspan").count();
            assert_eq!(svg.matches("</t").count(), open + 1, "and the title");
            assert_eq!(
                svg,
                draw::<f64>(&domain, &instance, shown, &nothing).unwrap()
            );
        }
        let large = instance.iter().any(|number| number.abs() > 1e30);
        let single = draw::<f32>(&domain, &instance, Some(&region), &nothing);
        assert_eq!(single.is_err(), large);
    }
}

#[test]
fn long_regions_go_on_below_and_signs_are_escaped() {
    let domain = Domain::parse("parameter x in [0, 1]").unwrap();
    let text = ["x < 0.5 and x > 0.25"; 8].join(" and ");
    let region = Region::parse(&domain, &text).unwrap();
    let svg = draw::<f64>(&domain, &[], Some(&region), &nothing).unwrap();
    let shown = svg
        .lines()
        .find(|line| line.starts_with("<text class=\"code\""))
        .unwrap();
    let lines: Vec<_> = shown
        .split("<tspan")
        .skip(1)
        .map(|line| {
            let (_, words) = line.split_once('>').unwrap();
            words.split("</tspan>").next().unwrap().to_string()
        })
        .collect();
    assert_eq!(lines.len(), 2);
    let joined = lines.join(" ").replace("&lt;", "<").replace("&gt;", ">");
    assert_eq!(joined, text);
}

#[test]
fn what_does_not_fit_together_is_refused() {
    let (domain, other) = (Domain::parse(PICK).unwrap(), Domain::parse(REACH).unwrap());
    let region = Region::parse(&other, "true").unwrap();
    let wrong = draw::<f64>(&domain, &PICK_INSTANCE, Some(&region), &nothing);
    assert!(matches!(wrong, Err(Error::Mismatch(_))));
    let short = draw::<f64>(&domain, &PICK_INSTANCE[1..], None, &nothing);
    assert!(matches!(short, Err(Error::InvalidArgument(_))));
}

#[test]
fn decimals_are_rounded() {
    let cases = [
        (0.0, "0.00"),
        (-0.004, "0.00"),
        (-0.005_1, "-0.01"),
        (1.999, "2.00"),
        (12.345_67, "12.35"),
        (-3.1, "-3.10"),
        (f64::NAN, "0.00"),
    ];
    for (value, expected) in cases {
        let mut text = String::new();
        write_fixed(&mut text, value, 2).unwrap();
        assert_eq!(text, expected);
    }
    let mut text = String::new();
    write_fixed(&mut text, 2.5, 0).unwrap();
    assert_eq!(text, "3");
}
