//! What was flown: a log of the commander, the trajectory of the quad, and a plot of both.

use std::fs::{self, File};
use std::io::{BufWriter, Write as _};
use std::path::Path;

use ncp_spec::wire::Mode;
use plotters::coord::Shift;
use plotters::prelude::*;

use super::brain::Ticked;
use super::quad::Place;
use super::story::Story;
use crate::LiveError;
use crate::soak::plot::{failed, lines};

/// How near to its last goal a flight has to end, in m.
const NEAR_M: f64 = 0.6;

/// A flight that is over.
pub(super) struct Flight {
    pub(super) ticks: Vec<Ticked>,
    pub(super) places: Vec<Place>,
    /// What the link made of the frames.
    pub(super) faults: u64,
    /// Where it was to be in the end, in m.
    pub(super) goal: [f64; 3],
}

impl Flight {
    /// How far from its goal it ended, in m.
    fn missed_m(&self) -> f64 {
        let Some(last) = self.places.last() else { return f64::INFINITY };
        last.position.iter().zip(self.goal).map(|(at, goal)| (at - goal).powi(2)).sum::<f64>().sqrt()
    }

    /// Whether it ended where it was to be.
    pub(super) fn arrived(&self) -> bool {
        self.missed_m() < NEAR_M
    }

    /// The flight in a few lines.
    pub(super) fn summary(&self) -> String {
        let of = |mode| self.ticks.iter().filter(|tick| tick.mode == mode).count();
        let spikes: u64 = self.ticks.iter().map(|tick| tick.spikes).sum();
        let mut thought: Vec<f64> = self.ticks.iter().map(|tick| tick.thought_ms).collect();
        thought.sort_by(f64::total_cmp);
        let at = |share: f64| -> f64 {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
            let index = (share * thought.len() as f64) as usize;
            thought.get(index.min(thought.len().saturating_sub(1))).copied().unwrap_or(f64::NAN)
        };
        let arrived = if self.arrived() { "arrived" } else { "did not arrive" };
        format!(
            "{} commands: {} active, {} hold, {} estop; {spikes} spikes; \
             a step of the network and the way there and back: {:.1} ms (median), {:.1} ms (99 %)\n\
             {} faults of the link; the quad {arrived}: {:.2} m from its goal",
            self.ticks.len(),
            of(Mode::Active),
            of(Mode::Hold),
            of(Mode::Estop),
            at(0.5),
            at(0.99),
            self.faults,
            self.missed_m(),
        )
    }

    /// Writes `log.jsonl`, `trajectory.csv` and `flight.svg`.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(super) fn write(&self, out: &Path, story: &Story) -> Result<(), LiveError> {
        let mut log = BufWriter::new(File::create(out.join("log.jsonl"))?);
        for Ticked { at_s, seq, mode, decision, velocity, spikes, thought_ms } in &self.ticks {
            let line = serde_json::json!({
                "at_s": at_s, "seq": seq, "mode": mode.as_str(), "decision": format!("{decision:?}"),
                "velocity_mps": velocity, "spikes": spikes, "thought_ms": thought_ms,
            });
            writeln!(log, "{line}")?;
        }
        log.flush()?;
        let mut csv = String::from("at_s,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,obeys,is_stopped\n");
        for Place { at_s, position: [x, y, z], velocity: [vx, vy, vz], obeys, is_stopped } in &self.places {
            csv += &format!("{at_s:.3},{x:.4},{y:.4},{z:.4},{vx:.4},{vy:.4},{vz:.4},{obeys},{is_stopped}\n");
        }
        fs::write(out.join("trajectory.csv"), csv)?;
        self.draw(&out.join("flight.svg"), story).map_err(LiveError::Plot)
    }

    fn draw(&self, path: &Path, story: &Story) -> Result<(), String> {
        let area = SVGBackend::new(path, (1_000, 1_100)).into_drawing_area();
        area.fill(&WHITE).map_err(failed)?;
        let (seen_from_above, over_time) = area.split_vertically(420);
        self.seen_from_above(&seen_from_above, story)?;
        let panels = over_time.split_evenly((3, 1));
        let [places, speeds, modes] = &*panels else { return Ok(()) };
        let axis = |name: &str, axis: usize| {
            (name.to_owned(), self.places.iter().map(|place| (place.at_s, place.position[axis])).collect())
        };
        lines(places, "where the quad is, in m", story.time_s, &[axis("x", 0), axis("y", 1), axis("z", 2)])?;
        let speed = |velocity: &[f64]| velocity.iter().map(|part| part * part).sum::<f64>().sqrt();
        let flown = self.places.iter().map(|place| (place.at_s, speed(&place.velocity))).collect();
        let asked = self.ticks.iter().map(|tick| (tick.at_s, speed(&tick.velocity))).collect();
        let both = [("flown".to_owned(), flown), ("commanded".to_owned(), asked)];
        lines(speeds, "how fast, in m/s", story.time_s, &both)?;
        self.modes(modes, story)?;
        area.present().map_err(failed)
    }

    fn seen_from_above(&self, area: &DrawingArea<SVGBackend<'_>, Shift>, story: &Story) -> Result<(), String> {
        let mut chart = ChartBuilder::on(area)
            .caption("from above, in m; green: obeys, grey: holds, red: stopped; rings: waypoints", ("sans-serif", 15))
            .margin(8)
            .x_label_area_size(22)
            .y_label_area_size(50)
            .build_cartesian_2d(-4.5..8.5, -1.0..5.0)
            .map_err(failed)?;
        chart.configure_mesh().light_line_style(WHITE).draw().map_err(failed)?;
        let dots = self.places.iter().step_by(4).map(|place| {
            let colour = if place.is_stopped {
                RED
            } else if place.obeys {
                GREEN
            } else {
                BLACK
            };
            Circle::new((place.position[0], place.position[1]), 2, colour.mix(0.6).filled())
        });
        chart.draw_series(dots).map_err(failed)?;
        let rings = story.waypoints.iter().map(|[x, y, _]| Circle::new((*x, *y), 8, BLUE.stroke_width(2)));
        chart.draw_series(rings).map_err(failed)?;
        Ok(())
    }

    /// What the commander sent, whether the quad obeyed, and what happened when.
    fn modes(&self, area: &DrawingArea<SVGBackend<'_>, Shift>, story: &Story) -> Result<(), String> {
        const CAPTION: &str = "commands (green: active, grey: hold, red: estop), the quad likewise, and what happened; \
                               time in s";
        let mut chart = ChartBuilder::on(area)
            .caption(CAPTION, ("sans-serif", 15))
            .margin(8)
            .x_label_area_size(22)
            .y_label_area_size(50)
            .build_cartesian_2d(0.0..story.time_s, 0.0..3.0)
            .map_err(failed)?;
        chart.configure_mesh().disable_mesh().y_labels(0).draw().map_err(failed)?;
        let sent = self.ticks.windows(2).map(|pair| {
            let colour = match pair[0].mode {
                Mode::Active => GREEN,
                Mode::Estop => RED,
                Mode::Hold | Mode::Init => BLACK,
            };
            (pair[0].at_s, pair[1].at_s, 2.0, colour)
        });
        let obeyed = self.places.windows(2).map(|pair| {
            let colour = if pair[0].is_stopped {
                RED
            } else if pair[0].obeys {
                GREEN
            } else {
                BLACK
            };
            (pair[0].at_s, pair[1].at_s, 1.0, colour)
        });
        let bands = joined(sent).into_iter().chain(joined(obeyed));
        let bands = bands.map(|(from_s, to_s, low, colour)| {
            Rectangle::new([(from_s, low + 0.1), (to_s, low + 0.9)], colour.mix(0.5).filled())
        });
        chart.draw_series(bands).map_err(failed)?;
        let names = story.events.iter();
        let names = names.map(|event| Text::new(event.name.as_str(), (event.from_s, 0.6), ("sans-serif", 13)));
        chart.draw_series(names).map_err(failed)?;
        let spans = story.events.iter();
        let spans = spans.map(|event| Rectangle::new([(event.from_s, 0.1), (event.to_s, 0.3)], BLACK.filled()));
        chart.draw_series(spans).map_err(failed)?;
        Ok(())
    }
}

type Band = (f64, f64, f64, RGBColor);

/// Bands that follow one another in one colour, as one.
fn joined(bands: impl Iterator<Item = Band>) -> Vec<Band> {
    let mut runs: Vec<Band> = Vec::new();
    for band in bands {
        match runs.last_mut() {
            Some(last) if last.3 == band.3 => last.1 = band.1,
            _ => runs.push(band),
        }
    }
    runs
}
