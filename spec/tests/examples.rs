//! The examples do what they say: they are run here as they are, and their logs are kept.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests may")]

use std::fs;

use serde_json::Value;

#[path = "../examples/session.rs"]
#[allow(dead_code, reason = "the example's `main` is not called here")]
mod session;
#[path = "../examples/uav_flight.rs"]
#[allow(dead_code, reason = "the example's `main` is not called here")]
mod uav_flight;

use uav_flight::sim::{Flight, MAX_SPEED_MPS, RADIUS_M, Sample, State};

fn fly() -> Flight {
    uav_flight::fly().unwrap()
}

fn norm([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// The samples of a scene, counted from 1.
fn scene(flight: &Flight, number: usize) -> impl Iterator<Item = &Sample> {
    let begin = flight.scenes[number - 1].0;
    let end = flight.scenes.get(number).map_or(f64::MAX, |(next, _)| *next);
    flight.samples.iter().filter(move |sample| (begin..end).contains(&sample.t))
}

/// The states of a scene, each once for as long as it lasts.
fn states(flight: &Flight, number: usize) -> Vec<&'static str> {
    let mut states: Vec<_> = scene(flight, number).map(|sample| sample.state.name()).collect();
    states.dedup();
    states
}

fn is_moving(state: State) -> bool {
    matches!(state, State::Active | State::Limited | State::Replay)
}

#[test]
fn the_log_of_the_flight_is_the_same_each_time() {
    insta::assert_snapshot!("uav_flight", fly().log);
}

#[test]
fn the_log_of_the_session_is_the_same_each_time() {
    let mut out = Vec::new();
    session::run(&mut out).unwrap();
    insta::assert_snapshot!("session", String::from_utf8(out).unwrap());
}

/// [NCP-SAFE-001] [NCP-SAFE-054] [NCP-SAFE-060] The invariants, over the whole flight.
#[test]
fn the_body_moves_only_as_it_may() {
    let flight = fly();
    for sample in &flight.samples {
        let Sample { t, position, followed_mps, state } = sample;
        assert!(*followed_mps <= MAX_SPEED_MPS, "{followed_mps} m/s at {t} s");
        assert_eq!(*followed_mps > 0.0, is_moving(*state), "{state:?} at {t} s");
        if is_moving(*state) {
            assert!(norm(*position) <= RADIUS_M, "{position:?} at {t} s");
        }
    }
    let farthest = flight.samples.iter().map(|sample| norm(sample.position)).fold(0.0, f64::max);
    assert!(farthest > RADIUS_M, "only the gust takes it out");
}

#[test]
fn each_scene_goes_through_its_gate_and_no_other() {
    let flight = fly();
    assert_eq!(states(&flight, 1), ["hold", "active"]);
    assert_eq!(states(&flight, 2), ["active", "limited", "active"]);
    assert_eq!(states(&flight, 3), ["active", "hold", "estop", "carried", "estop", "hold", "active"]);
    assert_eq!(states(&flight, 4), ["active", "hold", "active"]);
    assert_eq!(states(&flight, 5), ["active", "hold", "active"]);
    assert_eq!(states(&flight, 6), ["active", "replay", "hold", "active"]);
    assert_eq!(flight.scenes.len(), 6);
}

/// [NCP-SAFE-033] [NCP-RES-002] [NCP-RES-029] How long the body goes on in the dark: until the
/// sensor's timeout of 250 ms, the ttl of 400 ms, the horizon's end after 2.2 s; and a tick more.
#[test]
fn the_body_goes_on_no_longer_than_each_gate_allows() {
    let flight = fly();
    for (number, allowed_s) in [(4, 0.250), (5, 0.400)] {
        let begin = flight.scenes[number - 1].0;
        let held = scene(&flight, number).find(|sample| sample.state == State::Hold).unwrap();
        let went_on = held.t - begin;
        assert!((allowed_s - 0.05..=allowed_s + 0.15).contains(&went_on), "scene {number}: {went_on} s");
    }
    let replay: Vec<_> = scene(&flight, 6).filter(|sample| sample.state == State::Replay).collect();
    let replayed = replay.last().unwrap().t - replay[0].t;
    assert!((1.9..=2.0).contains(&replayed), "{replayed} s");
}

#[test]
fn the_files_hold_the_flight() {
    let folder = tempfile::tempdir().unwrap();
    let out_dir = folder.path().join("deep/er");
    let mut out = Vec::new();
    let args = ["--out".to_owned(), out_dir.display().to_string()];
    uav_flight::run(args, &mut out).unwrap();
    let flight = fly();

    let printed = String::from_utf8(out).unwrap();
    let files = printed.strip_prefix(&flight.log).unwrap();
    assert_eq!(files.lines().count(), 2, "{files}");

    let rows = fs::read_to_string(out_dir.join("trajectory.jsonl")).unwrap();
    assert_eq!(rows.lines().count(), flight.samples.len());
    for (row, sample) in rows.lines().zip(&flight.samples) {
        let row: Value = serde_json::from_str(row).unwrap();
        assert_eq!(row["t"].as_f64(), Some(sample.t));
        assert_eq!(row["state"], sample.state.name());
        for (axis, x) in sample.position.iter().enumerate() {
            assert!((row["position_m"][axis].as_f64().unwrap() - x).abs() <= 1e-6);
        }
    }

    let plot = fs::read_to_string(out_dir.join("flight.svg")).unwrap();
    assert!(plot.starts_with("<svg ") && plot.ends_with("</svg>\n"));
    for shown in ["fence, 10 m", ">start<", ">A<", ">home<", "→ C", "replay of a horizon", "ESTOP"] {
        assert!(plot.contains(shown), "{shown}");
    }
    assert!(!plot.contains("NaN") && !plot.contains("inf"));
    // Each run of one state is drawn three times: on the map, and in both charts.
    let runs = flight.samples.chunk_by(|a, b| a.state == b.state).count();
    assert_eq!(plot.matches("<polyline").count(), 3 * runs);
    // Every element is closed where it begins, but for text and the document itself.
    for line in plot.lines() {
        let is_text = (line.starts_with("<text") && line.ends_with("</text>")) || line.starts_with("<title>");
        let is_document = line.starts_with("<svg") || line == "</svg>";
        assert!(is_text || is_document || line.ends_with("/>"), "{line}");
    }
}

#[test]
fn the_flight_says_how_it_is_called_when_it_does_not_understand() {
    let call = |args: &[&str]| {
        let mut out = Vec::new();
        let done = uav_flight::run(args.iter().map(|arg| (*arg).to_owned()), &mut out);
        (done.is_ok(), String::from_utf8(out).unwrap())
    };
    assert_eq!(call(&["--help"]), (true, "usage: uav_flight [--out DIR]\n".to_owned()));
    for wrong in [&["--out"][..], &["--in", "x"], &["x"]] {
        assert_eq!(call(wrong), (false, String::new()), "{wrong:?}");
    }
}
