//! The flight as one SVG: the path from above, and distance, speed and state over time.

use std::fmt::Write as _;

use super::sim::{Flight, MAX_SPEED_MPS, Mark, RADIUS_M, Sample, State};

const WIDTH: f64 = 1180.0;
const HEIGHT: f64 = 720.0;

/// From the world's metres to the plot of the path; y points up.
const CENTRE: (f64, f64) = (320.0, 350.0);
const PX_A_METRE: f64 = 25.0;
/// Half of the world that is seen, in m.
const SEEN_M: f64 = 11.0;

/// The charts over time.
const LEFT: f64 = 690.0;
const RIGHT: f64 = 1150.0;

const INK: &str = "#1f2937";
const SOFT: &str = "#6b7280";
const GRID: &str = "#e5e7eb";
const FENCE: &str = "#b91c1c";

/// Draws the flight.
pub(crate) fn svg(flight: &Flight) -> String {
    let mut plot = Plot(String::new());
    plot.header();
    plot.map(flight);
    plot.legend();
    plot.charts(flight);
    plot.0.push_str("</svg>\n");
    plot.0
}

const fn colour(state: State) -> &'static str {
    match state {
        State::Active => "#2563eb",
        State::Limited => "#ea8a0c",
        State::Replay => "#8b3fd1",
        State::Hold => "#94a3b8",
        State::Estop => "#dc2626",
        State::Carried => "#15803d",
    }
}

const fn meaning(state: State) -> &'static str {
    match state {
        State::Active => "active: passed as it was",
        State::Limited => "active: limited",
        State::Replay => "replay of a horizon",
        State::Hold => "hold",
        State::Estop => "ESTOP",
        State::Carried => "carried by hand",
    }
}

/// Samples of one state, and the first of the next, so that the line has no gaps.
fn runs(samples: &[Sample]) -> impl Iterator<Item = (State, &[Sample])> {
    let mut begin = 0;
    samples.chunk_by(|a, b| a.state == b.state).filter_map(move |run| {
        let end = begin + run.len();
        let with_next = samples.get(begin..(end + 1).min(samples.len()));
        begin = end;
        Some((run.first()?.state, with_next?))
    })
}

fn on_map(position: [f64; 3]) -> (f64, f64) {
    let [x, y, _] = position;
    (CENTRE.0 + x * PX_A_METRE, CENTRE.1 - y * PX_A_METRE)
}

struct Plot(String);

impl Plot {
    fn line(&mut self, text: std::fmt::Arguments<'_>) {
        let _ = writeln!(self.0, "{text}");
    }

    fn header(&mut self) {
        self.line(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" \
             font-family=\"'DejaVu Sans', Verdana, Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"{INK}\">"
        ));
        self.line(format_args!(r#"<title>A UAV flies to a target and through every safety gate</title>"#));
        self.line(format_args!(r##"<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>"##));
    }

    fn text(&mut self, (x, y): (f64, f64), anchor: &str, style: &str, text: &str) {
        self.line(format_args!(r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" {style}>{text}</text>"#));
    }

    fn rule(&mut self, from: (f64, f64), to: (f64, f64), colour: &str, style: &str) {
        self.line(format_args!(
            r#"<line x1="{:.1}" y1="{:.1}" x2="{:.1}" y2="{:.1}" stroke="{colour}" {style}/>"#,
            from.0, from.1, to.0, to.1
        ));
    }

    fn path(&mut self, points: impl Iterator<Item = (f64, f64)>, colour: &str, style: &str) {
        let _ = write!(self.0, r#"<polyline points=""#);
        for (at, (x, y)) in points.enumerate() {
            let gap = if at == 0 { "" } else { " " };
            let _ = write!(self.0, "{gap}{x:.1},{y:.1}");
        }
        self.line(format_args!(
            r#"" fill="none" stroke="{colour}" stroke-linejoin="round" stroke-linecap="round" {style}/>"#
        ));
    }

    fn map(&mut self, flight: &Flight) {
        let edge = SEEN_M * PX_A_METRE;
        self.text((CENTRE.0 - edge, 34.0), "start", r#"font-size="17" font-weight="bold""#, "The path, from above");
        for metres in (-10..=10).step_by(5) {
            let at = f64::from(metres) * PX_A_METRE;
            let soft = format!(r#"fill="{SOFT}" font-size="11""#);
            self.rule((CENTRE.0 + at, CENTRE.1 - edge), (CENTRE.0 + at, CENTRE.1 + edge), GRID, "");
            self.rule((CENTRE.0 - edge, CENTRE.1 + at), (CENTRE.0 + edge, CENTRE.1 + at), GRID, "");
            let label = format!("{metres}").replace('-', "−");
            self.text((CENTRE.0 + at, CENTRE.1 + edge + 15.0), "middle", &soft, &label);
            let label = format!("{}", -metres).replace('-', "−");
            self.text((CENTRE.0 - edge - 6.0, CENTRE.1 + at + 4.0), "end", &soft, &label);
        }
        let soft = format!(r#"fill="{SOFT}""#);
        let corner = (CENTRE.0 + edge + 8.0, CENTRE.1 + edge + 4.0);
        self.text(corner, "start", &soft, "x, m");
        let corner = (CENTRE.0 - edge, CENTRE.1 - edge - 8.0);
        self.text(corner, "start", &soft, "y, m");
        let radius = RADIUS_M * PX_A_METRE;
        self.line(format_args!(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{radius}\" fill=\"{FENCE}\" fill-opacity=\"0.035\" \
             stroke=\"{FENCE}\" stroke-width=\"1.6\" stroke-dasharray=\"7 5\"/>",
            CENTRE.0, CENTRE.1
        ));
        let label = format!("fence, {RADIUS_M} m");
        self.text(on_map([-7.2, -7.6, 0.0]), "end", &format!(r#"fill="{FENCE}""#), &label);

        for (state, run) in runs(&flight.samples) {
            let style = match state {
                State::Carried => r#"stroke-width="2.4" stroke-dasharray="2 6""#,
                State::Estop => r#"stroke-width="5""#,
                _ => r#"stroke-width="2.8""#,
            };
            self.path(run.iter().map(|sample| on_map(sample.position)), colour(state), style);
        }
        // Where it stood for a while, and in which scene first.
        let mut numbered = 0;
        for (state, run) in runs(&flight.samples) {
            let (Some(first), Some(last)) = (run.first(), run.last()) else {
                continue;
            };
            let stood = last.t - first.t >= 0.2;
            if stood && matches!(state, State::Hold | State::Estop) {
                let (x, y) = on_map(first.position);
                self.line(format_args!(
                    r##"<circle cx="{x:.1}" cy="{y:.1}" r="4.5" fill="{}" stroke="#ffffff" stroke-width="1.5"/>"##,
                    colour(state)
                ));
                let scene = flight.scenes.iter().filter(|(begin_s, _)| *begin_s <= first.t).count();
                if scene > numbered {
                    numbered = scene;
                    let style = format!(r#"fill="{SOFT}" font-size="11" font-weight="bold""#);
                    self.text((x - 7.0, y - 8.0), "end", &style, &format!("{scene}"));
                }
            }
        }
        for mark in &flight.marks {
            self.mark(mark);
        }
    }

    fn mark(&mut self, Mark { name, position }: &Mark) {
        let (x, y) = on_map(*position);
        let edge = CENTRE.0 + SEEN_M * PX_A_METRE;
        let bold = r#"font-size="14" font-weight="bold""#;
        if *name == "start" {
            self.line(format_args!(
                r##"<circle cx="{x:.1}" cy="{y:.1}" r="6" fill="#ffffff" stroke="{INK}" stroke-width="2.4"/>"##
            ));
            self.text((x, y + 23.0), "middle", bold, name);
        } else if x > edge {
            // A target that is not on the map.
            let label = format!("→ {name}");
            self.text((edge + 8.0, y + 5.0), "start", bold, &label);
        } else {
            for (dx, dy) in [(6.0, 6.0), (6.0, -6.0)] {
                self.rule((x - dx, y - dy), (x + dx, y + dy), INK, r#"stroke-width="2.4" stroke-linecap="round""#);
            }
            self.text((x, y - 13.0), "middle", bold, name);
        }
    }

    fn legend(&mut self) {
        for (at, state) in State::ALL.into_iter().enumerate() {
            let (column, row) = ((at % 3) as f64, (at / 3) as f64);
            let x = CENTRE.0 - SEEN_M * PX_A_METRE + column * 195.0;
            let y = CENTRE.1 + SEEN_M * PX_A_METRE + 42.0 + row * 20.0;
            let dash = if state == State::Carried { r#"stroke-dasharray="2 6""# } else { "" };
            let style = format!(r#"stroke-width="4" stroke-linecap="round" {dash}"#);
            self.rule((x + 2.0, y - 4.0), (x + 24.0, y - 4.0), colour(state), &style);
            self.text((x + 34.0, y), "start", "", meaning(state));
        }
    }

    fn charts(&mut self, flight: &Flight) {
        let end_s = flight.samples.last().map_or(1.0, |sample| sample.t);
        let x_of = |t: f64| LEFT + t / end_s * (RIGHT - LEFT);
        let soft = format!(r#"fill="{SOFT}" font-size="11""#);

        let distance = Chart { top: 70.0, bottom: 290.0, most: 12.0, every: 2.0 };
        let speed = Chart { top: 350.0, bottom: 520.0, most: 2.5, every: 0.5 };
        self.text((LEFT, 34.0), "start", r#"font-size="17" font-weight="bold""#, "The gates, over time");
        self.axis(&distance, "distance from the origin, m");
        self.axis(&speed, "speed that the body follows, m/s");

        // The scenes, through both charts.
        let (strip_top, strip_bottom) = (566.0, 590.0);
        for (at, (begin_s, name)) in flight.scenes.iter().enumerate() {
            let x = x_of(*begin_s);
            if at > 0 {
                let dash = r#"stroke-dasharray="2 4""#;
                self.rule((x, distance.top), (x, strip_bottom), SOFT, dash);
            }
            let number = format!("{}", at + 1);
            self.text((x + 4.0, distance.top - 4.0), "start", &soft, &number);
            let (column, row) = ((at % 3) as f64, (at / 3) as f64);
            let place = (LEFT + column * 165.0, strip_bottom + 47.0 + row * 20.0);
            self.text(place, "start", "", &format!("{}  {name}", at + 1));
        }
        for (chart, value, of) in [
            (&distance, RADIUS_M, (|s: &Sample| norm(s.position)) as fn(&Sample) -> f64),
            (&speed, MAX_SPEED_MPS, |s: &Sample| s.followed_mps),
        ] {
            let y = chart.y_of(value);
            self.rule((LEFT, y), (RIGHT, y), FENCE, r#"stroke-width="1.4" stroke-dasharray="7 5""#);
            for (state, run) in runs(&flight.samples) {
                let points = run.iter().map(|sample| (x_of(sample.t), chart.y_of(of(sample))));
                self.path(points, colour(state), r#"stroke-width="2""#);
            }
        }
        let red = format!(r#"fill="{FENCE}" font-size="11""#);
        self.text((RIGHT, distance.y_of(RADIUS_M) - 5.0), "end", &red, "fence");
        self.text((RIGHT, speed.y_of(MAX_SPEED_MPS) - 5.0), "end", &red, "limit");

        self.text((LEFT, strip_top - 8.0), "start", "", "what the body does");
        for (state, run) in runs(&flight.samples) {
            let (Some(first), Some(last)) = (run.first(), run.last()) else {
                continue;
            };
            let (from, to) = (x_of(first.t), x_of(last.t));
            self.line(format_args!(
                r#"<rect x="{from:.1}" y="{strip_top}" width="{:.1}" height="{}" fill="{}"/>"#,
                to - from,
                strip_bottom - strip_top,
                colour(state)
            ));
        }
        let mut t = 0.0;
        while t <= end_s {
            let label = format!("{t:.0}");
            self.text((x_of(t), strip_bottom + 15.0), "middle", &soft, &label);
            t += 10.0;
        }
        self.text((RIGHT + 10.0, strip_bottom + 15.0), "start", &soft, "s");
    }

    fn axis(&mut self, chart: &Chart, name: &str) {
        let soft = format!(r#"fill="{SOFT}" font-size="11""#);
        self.text((LEFT, chart.top - 18.0), "start", "", name);
        let mut value = 0.0;
        while value <= chart.most {
            let y = chart.y_of(value);
            self.rule((LEFT, y), (RIGHT, y), GRID, "");
            let label = if chart.every < 1.0 { format!("{value:.1}") } else { format!("{value:.0}") };
            self.text((LEFT - 8.0, y + 4.0), "end", &soft, &label);
            value += chart.every;
        }
    }
}

struct Chart {
    top: f64,
    bottom: f64,
    /// The largest value that it shows.
    most: f64,
    /// From one line of the grid to the next.
    every: f64,
}

impl Chart {
    fn y_of(&self, value: f64) -> f64 {
        self.bottom - value / self.most * (self.bottom - self.top)
    }
}

fn norm([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
