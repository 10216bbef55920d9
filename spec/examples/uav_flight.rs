//! A simulated UAV flies to a target and then through every safety gate.
//!
//! ```text
//! cargo run -p ncp-spec --example uav_flight -- [--out DIR]
//! ```
//!
//! Everything between the two ends is real: the body's sensor frames and the commander's commands
//! travel as wire bytes over a local bus, the commander is a control loop with a governor, and the
//! body follows what its action buffer says. Only the body itself and the clock are simulated, and no
//! random number is drawn, so that two flights are the same to the bit.
//!
//! It prints one line an event, and writes `trajectory.jsonl` (a sample every 50 ms) and `flight.svg`
//! into DIR (`target/uav_flight` when it is not given).

use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;

use sim::{Flight, Orders, State};

#[path = "uav_flight/plot.rs"]
mod plot;
#[path = "uav_flight/sim.rs"]
pub(crate) mod sim;

const USAGE: &str = "usage: uav_flight [--out DIR]";

fn main() -> Result<(), Box<dyn Error>> {
    run(std::env::args().skip(1), &mut io::stdout().lock())
}

/// Flies, prints the log and writes the files.
pub(crate) fn run(args: impl IntoIterator<Item = String>, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let mut args = args.into_iter();
    let mut folder = PathBuf::from("target/uav_flight");
    while let Some(arg) = args.next() {
        match (arg.as_str(), args.next()) {
            ("--out", Some(dir)) => folder = dir.into(),
            ("-h" | "--help", _) => return Ok(writeln!(out, "{USAGE}")?),
            _ => return Err(USAGE.into()),
        }
    }
    let flight = fly()?;
    let (trajectory, picture) = (folder.join("trajectory.jsonl"), folder.join("flight.svg"));
    // The files first: whoever reads the log may stop early.
    fs::create_dir_all(&folder)?;
    fs::write(&trajectory, flight.trajectory())?;
    fs::write(&picture, plot::svg(&flight))?;
    out.write_all(flight.log.as_bytes())?;
    for file in [trajectory, picture] {
        writeln!(out, "wrote {}", file.display())?;
    }
    Ok(())
}

const START: [f64; 3] = [-7.0, -4.0, 1.0];
const A: [f64; 3] = [3.0, 6.5, 3.0];
const B: [f64; 3] = [6.5, 0.5, 1.0];
/// Outside the fence.
const C: [f64; 3] = [13.0, -2.0, 1.0];
const D: [f64; 3] = [0.5, -8.0, 2.0];
const HOME: [f64; 3] = [-5.0, 2.5, 2.0];

/// The whole flight: to a target, and then through one gate after the other.
pub(crate) fn fly() -> Result<Flight, Box<dyn Error>> {
    let cruise = |target| Orders::new(target, 1.0);
    let mut flight = Flight::new(START)?;

    flight.scene("the flight", "to A, at no more than 1 m/s an axis");
    flight.order("A", cruise(A)?);
    flight.until_near(A)?;

    flight.scene("the speed clamp", "to B, as fast as 4 m/s an axis");
    flight.order("B", Orders::new(B, 4.0)?);
    flight.until_near(B)?;

    flight.scene("the geofence", "to C, which lies outside");
    flight.order("C", cruise(C)?);
    flight.until("it is held at the fence", |f| f.state() == State::Hold)?;
    flight.wait(1.0)?;
    flight.gust("a gust of 1.5 m/s along x", [1.5, 0.0, 0.0]);
    flight.until("it is stopped", |f| f.state() == State::Estop)?;
    flight.wait(0.4)?;
    flight.gust("the gust is over", [0.0; 3]);
    flight.order("D", cruise(D)?);
    flight.wait(0.5)?;
    flight.carry([7.0, -4.5, 1.0])?;
    flight.reset_governor();
    flight.wait(0.53)?;
    flight.reset_body();
    flight.wait(1.5)?;

    flight.scene("the stale sensor", "its driver freezes for 0.8 s");
    flight.sensor(false);
    flight.wait(0.8)?;
    flight.sensor(true);
    flight.wait(2.0)?;

    flight.scene("the ttl", "commands are lost for 1 s");
    flight.link(false);
    flight.wait(1.0)?;
    flight.link(true);
    flight.until_near(D)?;

    flight.scene("the horizon", "home, with 10 ticks of 200 ms ahead");
    flight.order("home", cruise(HOME)?.with_horizon());
    flight.wait(6.0)?;
    flight.link(false);
    flight.wait(3.0)?;
    flight.link(true);
    flight.until_near(HOME)?;
    flight.land();
    Ok(flight)
}

/// A position for people, in columns.
pub(crate) fn shown([x, y, z]: [f64; 3]) -> String {
    format!("{:>6.2} {:>6.2} {:>6.2}", rounded(x), rounded(y), rounded(z))
}

/// A position for people, in a sentence.
pub(crate) fn place([x, y, z]: [f64; 3]) -> String {
    format!("({}, {}, {})", rounded(x), rounded(y), rounded(z))
}

/// To centimetres. Adding 0 makes a −0 a 0, also one that rounding left behind.
fn rounded(x: f64) -> f64 {
    (x * 100.0).round() / 100.0 + 0.0
}
