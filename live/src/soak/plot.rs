//! A soak over time, as SVG.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

use super::report::Report;
use crate::LiveError;
use crate::relay::schedule::{PlaneName, Schedule};

/// A line of a panel: its name, and its points.
pub(crate) type Line = (String, Vec<(f64, f64)>);

/// Draws faults, motion, memory and handles.
///
/// # Errors
/// The file cannot be written.
pub(super) fn draw(path: &Path, report: &Report, schedule: &Schedule) -> Result<(), LiveError> {
    let area = SVGBackend::new(path, (1_000, 900)).into_drawing_area();
    let drawn = area.fill(&WHITE).map_err(failed).and_then(|()| {
        let panels = area.split_evenly((4, 1));
        let [faults, motion, memory, handles] = &*panels else { return Ok(()) };
        let time_s = report.time_s;
        lines(faults, "faults a second, by plane", time_s, &faults_a_second(report))?;
        bands(motion, report, schedule)?;
        let held = |what: fn(super::Held) -> u64| -> Vec<(f64, f64)> {
            let seconds = report.seconds.iter();
            seconds.filter_map(|second| Some((second.at_s, number(what(second.held?))))).collect()
        };
        let mib = held(|held| held.rss_kib).into_iter().map(|(at_s, kib)| (at_s, kib / 1_024.0)).collect();
        lines(memory, "resident memory, MiB", time_s, &[("memory".to_owned(), mib)])?;
        let both =
            [("handles".to_owned(), held(|held| held.handles)), ("threads".to_owned(), held(|held| held.threads))];
        lines(handles, "open handles and threads; time in s", time_s, &both)?;
        area.present().map_err(failed)
    });
    drawn.map_err(LiveError::Plot)
}

pub(crate) fn failed(error: impl std::error::Error) -> String {
    error.to_string()
}

fn faults_a_second(report: &Report) -> Vec<Line> {
    let total = |plane, second: &super::Second| second.faults.get(&plane).map_or(0, |of| of.values().sum());
    let line = |plane: PlaneName| {
        let pairs = report.seconds.windows(2).map(|pair| {
            let [before, after] = [&pair[0], &pair[1]];
            (after.at_s, number(total(plane, after).saturating_sub(total(plane, before))) / (after.at_s - before.at_s))
        });
        (plane.plane().as_str().to_owned(), pairs.collect())
    };
    PlaneName::ALL.map(line).to_vec()
}

/// Draws lines over time.
///
/// # Errors
/// They cannot be drawn.
pub(crate) fn lines(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    title: &str,
    time_s: f64,
    lines: &[Line],
) -> Result<(), String> {
    let lowest = lines.iter().flat_map(|(_, points)| points).map(|(_, y)| *y).fold(0.0, f64::min);
    let highest = lines.iter().flat_map(|(_, points)| points).map(|(_, y)| *y).fold(1.0, f64::max);
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 15))
        .margin(8)
        .x_label_area_size(22)
        .y_label_area_size(50)
        .build_cartesian_2d(0.0..time_s, lowest * 1.1..highest * 1.1)
        .map_err(failed)?;
    chart.configure_mesh().light_line_style(WHITE).draw().map_err(failed)?;
    for (number, (name, points)) in lines.iter().enumerate() {
        let colour = Palette99::pick(number).to_rgba();
        let drawn = chart.draw_series(LineSeries::new(points.iter().copied(), colour)).map_err(failed)?;
        drawn.label(name).legend(move |(x, y)| PathElement::new([(x, y), (x + 14, y)], colour));
    }
    let mut legend = chart.configure_series_labels();
    legend.position(SeriesLabelPosition::UpperRight).background_style(WHITE.mix(0.8)).draw().map_err(failed)
}

/// When the plant moved, when it was latched, and when which planes were cut.
fn bands(area: &DrawingArea<SVGBackend<'_>, Shift>, report: &Report, schedule: &Schedule) -> Result<(), String> {
    let mut chart = ChartBuilder::on(area)
        .caption(
            "moves (green), latched (red), cuts (grey) of control, perception, action, observation",
            ("sans-serif", 15),
        )
        .margin(8)
        .x_label_area_size(22)
        .y_label_area_size(50)
        .build_cartesian_2d(0.0..report.time_s, 0.0..6.0)
        .map_err(failed)?;
    chart.configure_mesh().disable_mesh().y_labels(0).draw().map_err(failed)?;
    let moved = runs(report, |second| second.moved);
    let moved = moved.into_iter().map(|(from_s, to_s)| Rectangle::new([(from_s, 5.1), (to_s, 5.9)], GREEN.filled()));
    let latched = runs(report, |second| second.latched);
    let latched = latched.into_iter().map(|(from_s, to_s)| Rectangle::new([(from_s, 4.1), (to_s, 4.9)], RED.filled()));
    let windows = schedule.windows(report.time_s);
    let of_cuts = windows.into_iter().flat_map(|(planes, from_s, to_s)| {
        let rows = [3.1, 2.1, 1.1, 0.1];
        let cut = PlaneName::ALL.into_iter().zip(rows).filter(move |(plane, _)| planes.contains(plane));
        cut.map(move |(_, low)| {
            Rectangle::new([(from_s, low), (to_s.min(report.time_s), low + 0.8)], BLACK.mix(0.5).filled())
        })
    });
    chart.draw_series(moved.chain(latched).chain(of_cuts)).map_err(failed)?;
    Ok(())
}

/// From when to when something was so, as few times as there are.
fn runs(report: &Report, is_so: fn(&super::Second) -> bool) -> Vec<(f64, f64)> {
    let mut runs: Vec<(f64, f64)> = Vec::new();
    let mut before_s = 0.0;
    for second in &report.seconds {
        if is_so(second) {
            match runs.last_mut() {
                Some((_, to_s)) if *to_s >= before_s => *to_s = second.at_s,
                _ => runs.push((before_s, second.at_s)),
            }
        }
        before_s = second.at_s;
    }
    runs
}

#[expect(clippy::cast_precision_loss, reason = "counts of a soak")]
fn number(count: u64) -> f64 {
    count as f64
}
