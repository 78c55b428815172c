//! Samples per task as a plot.

use super::samples::{Measured, Series};
use super::style::STYLE;
use critreg::Error;
use critreg::picture::{Place, Svg};

/// The size of the picture.
const SIZE: Place = [820.0, 420.0];
/// Where the plot begins and ends.
const LEFT: f64 = 60.0;
const RIGHT: f64 = SIZE[0] - 20.0;
const TOP: f64 = 30.0;
const BOTTOM: f64 = SIZE[1] - 50.0;
/// Powers of ten on the axis of samples.
const DECADES: u32 = 3;

/// The plot: tasks in order of their samples, and the samples of each.
pub(super) fn plot(measured: &Measured) -> Result<String, Error> {
    const TITLE: &str = "Samples that the planner draws for each task, with the original samplers \
                         and with learned regions";
    let mut text = String::new();
    let mut svg = Svg::begin(&mut text, SIZE, |out| out.write_str(TITLE), STYLE)?;
    let tasks = measured.original.samples.len();
    axes(&mut svg, tasks)?;
    legend(&mut svg, measured)?;
    for (series, mark) in lines(measured) {
        let points: Vec<Place> = (1..)
            .zip(&series.samples)
            .map(|(task, samples)| [across(task, tasks), up(*samples)])
            .collect();
        line(&mut svg, &points, series.class, mark)?;
    }
    svg.end()?;
    Ok(text)
}

/// The lines, with the radius of their marks. Those of the first one are seen behind
/// those of the second.
fn lines(measured: &Measured) -> [(&Series, f64); 2] {
    [(&measured.original, 4.5), (&measured.learned, 2.8)]
}

fn legend(svg: &mut Svg<'_>, measured: &Measured) -> Result<(), Error> {
    let size = [RIGHT - LEFT - 20.0, 66.0];
    svg.rectangle([LEFT + 10.0, TOP + 6.0], size, "background")?;
    let mut y = TOP + 20.0;
    for (series, mark) in lines(measured) {
        let points = [LEFT + 14.0, LEFT + 29.0, LEFT + 44.0].map(|x| [x, y]);
        line(svg, &points, series.class, mark)?;
        svg.words([LEFT + 54.0, y + 4.0], &series.words(), "")?;
        y += 20.0;
    }
    let words = format!("learned once, by running {} controllers", measured.learning);
    svg.words([LEFT + 54.0, y + 4.0], &words, "")
}

/// A line with a mark at each point.
fn line(svg: &mut Svg<'_>, points: &[Place], class: &str, mark: f64) -> Result<(), Error> {
    svg.line(points, class)?;
    for point in points {
        svg.circle(*point, mark, &format!("{class}-mark"))?;
    }
    Ok(())
}

fn axes(svg: &mut Svg<'_>, tasks: usize) -> Result<(), Error> {
    for decade in 0..=DECADES {
        let unit = 10u32.pow(decade);
        let y = up(unit);
        svg.words([LEFT - 8.0, y + 4.0], &unit.to_string(), "end")?;
        let finer = if decade < DECADES { 1..10 } else { 1..2 };
        for step in finer {
            let y = up(step * unit);
            svg.line(&[[LEFT, y], [RIGHT, y]], "grid")?;
        }
    }
    for task in (0..=tasks).step_by(10).map(|task| task.max(1)) {
        let x = across(task, tasks);
        svg.line(&[[x, BOTTOM], [x, BOTTOM + 5.0]], "axis")?;
        svg.words([x, BOTTOM + 19.0], &task.to_string(), "middle")?;
    }
    svg.line(&[[LEFT, TOP], [LEFT, BOTTOM], [RIGHT, BOTTOM]], "axis")?;
    svg.words([LEFT - 40.0, TOP - 12.0], "samples", "title")?;
    let middle = (LEFT + RIGHT) / 2.0;
    let words = "tasks with one button, each line in order of its samples";
    svg.words([middle, BOTTOM + 39.0], words, "middle")
}

/// Where a task is, from one on.
fn across(task: usize, tasks: usize) -> f64 {
    let share = (task as f64 - 0.5) / tasks as f64;
    LEFT + share * (RIGHT - LEFT)
}

/// Where a number of samples is, at least one.
fn up(samples: u32) -> f64 {
    let share = f64::from(samples).log10() / f64::from(DECADES);
    BOTTOM - share * (BOTTOM - TOP)
}
