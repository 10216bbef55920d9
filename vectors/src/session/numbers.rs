//! The reference networks against their own closed solutions.

use super::{Open, case, observed_with, opened, record, run, step, stimulus};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::trace::nums;

pub(super) fn file() -> File {
    let mut cases = potentials();
    cases.extend(spikes());
    cases.extend(rates());
    cases.extend(stimuli());
    cases.extend(ports());
    let about = "The numbers of the reference networks: membrane potentials, spikes and rates by exact propagation.";
    File::new("session", "reference", about, cases)
}

const WHY: &str = "Section 4.4: exact propagation on the grid of `dt_ms`; a server without this network answers `open_session` with `ok` false.";

/// A leaky integrate-and-fire neuron, as section 4.4 writes it.
struct Lif {
    v: f64,
    resting: u32,
    propagator: f64,
    gain: f64,
    e_l: f64,
    v_th: f64,
    v_reset: f64,
    refractory: u32,
}

impl Lif {
    fn new(params: &[(&str, f64)], dt: f64) -> Self {
        let param = |name: &str, default: f64| {
            params
                .iter()
                .find(|(known, _)| *known == name)
                .map_or(default, |(_, value)| *value)
        };
        let tau = param("tau_m", 10.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a handful of steps"
        )]
        let refractory = (param("t_ref", 2.0) / dt).round() as u32;
        Self {
            v: param("E_L", -70.0),
            resting: 0,
            propagator: (-dt / tau).exp(),
            gain: tau / param("C_m", 250.0),
            e_l: param("E_L", -70.0),
            v_th: param("V_th", -55.0),
            v_reset: param("V_reset", -70.0),
            refractory,
        }
    }

    /// One step under a current; whether it spikes.
    fn step(&mut self, current: f64) -> bool {
        if self.resting > 0 {
            self.resting -= 1;
            self.v = self.v_reset;
            return false;
        }
        self.v = self.e_l
            + (self.v - self.e_l) * self.propagator
            + current * self.gain * (1.0 - self.propagator);
        let spikes = self.v >= self.v_th;
        if spikes {
            self.v = self.v_reset;
            self.resting = self.refractory;
        }
        spikes
    }
}

/// The observation of one neuron.
fn samples(times: &[f64], values: Option<&[f64]>) -> Json {
    let senders: Json = times.iter().map(|_| 1_u32).collect();
    object! { "times" => nums(times), "values" => nums(values.unwrap_or_default()), "senders" => senders }
}

/// A neuron run by the model: times and potentials at each step, and the times of its spikes.
fn simulate(
    params: &[(&str, f64)],
    dt: f64,
    steps: u32,
    current: f64,
) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let mut neuron = Lif::new(params, dt);
    let (mut times, mut values, mut spikes) = (Vec::new(), Vec::new(), Vec::new());
    for nth in 1..=steps {
        let time = f64::from(nth) * dt;
        if neuron.step(current) {
            spikes.push(time);
        }
        times.push(time);
        values.push(neuron.v);
    }
    (times, values, spikes)
}

type Params = Vec<(&'static str, f64)>;

fn networks() -> Vec<(&'static str, Params)> {
    vec![
        ("defaults", Vec::new()),
        ("driven-below", vec![("I_e", 300.0)]),
        ("driven", vec![("I_e", 500.0)]),
        ("driven-hard", vec![("I_e", 2000.0)]),
        ("inhibited", vec![("I_e", -200.0)]),
        ("slow", vec![("tau_m", 20.0), ("I_e", 250.0)]),
        ("small", vec![("C_m", 125.0), ("I_e", 250.0)]),
        ("no-rest", vec![("t_ref", 0.0), ("I_e", 600.0)]),
        ("long-rest", vec![("t_ref", 5.0), ("I_e", 600.0)]),
        // No whole number of steps, and never half of one.
        ("rest-rounded-up", vec![("t_ref", 0.8), ("I_e", 600.0)]),
        ("rest-rounded-down", vec![("t_ref", 1.2), ("I_e", 600.0)]),
        (
            "other-levels",
            vec![
                ("E_L", -65.0),
                ("V_th", -50.0),
                ("V_reset", -75.0),
                ("I_e", 450.0),
            ],
        ),
    ]
}

fn current(params: &[(&str, f64)]) -> f64 {
    params
        .iter()
        .find(|(name, _)| *name == "I_e")
        .map_or(0.0, |(_, value)| *value)
}

fn potentials() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, params) in networks() {
        for (dt, cadence, steps) in [(1.0, 1.0, 20_u32), (0.5, 1.0, 40), (0.25, 5.0, 80)] {
            let (times, values, _) = simulate(&params, dt, steps, current(&params));
            let sampled: Vec<(f64, f64)> = times
                .into_iter()
                .zip(values)
                .filter(|(time, _)| time % cadence == 0.0)
                .collect();
            let (times, values): (Vec<f64>, Vec<f64>) = sampled.into_iter().unzip();
            let open = Open {
                params: params.clone(),
                records: vec![record("v", "V_m", cadence)],
                dt,
                chunk: 20.0,
                ..Open::lif("a")
            };
            let rule = if cadence > dt {
                "NCP-SESS-053"
            } else {
                "NCP-SESS-050"
            };
            let rules: &[&'static str] = if rule == "NCP-SESS-053" {
                &["NCP-SESS-053", "NCP-SESS-050"]
            } else {
                &["NCP-SESS-050", "NCP-SESS-053"]
            };
            let observed =
                observed_with("a", 20.0, object! { "v" => samples(&times, Some(&values)) });
            cases.push(
                case(format!("potential/{name}/dt-{dt}"), rules, vec![(open.text(), opened("a")), (step("a", None, None), observed)])
                    .title(format!("The potential of a neuron ({name}) over 20 ms in steps of {dt} ms, sampled each {cadence} ms."))
                    .because(WHY),
            );
        }
    }
    cases
}

fn spikes() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, params) in networks() {
        for (dt, steps) in [(1.0, 60_u32), (0.5, 120), (0.125, 480)] {
            let (_, _, spikes) = simulate(&params, dt, steps, current(&params));
            let open = Open {
                params: params.clone(),
                records: vec![record("s", "spikes", 1.0)],
                dt,
                ..Open::lif("a")
            };
            let observed = observed_with("a", 60.0, object! { "s" => samples(&spikes, None) });
            cases.push(
                case(
                    format!("spikes/{name}/dt-{dt}"),
                    &["NCP-SESS-050", "NCP-SESS-052"],
                    vec![(open.text(), opened("a")), (run("a", 60.0), observed)],
                )
                .title(format!(
                    "A neuron ({name}) spikes {} times in 60 ms in steps of {dt} ms.",
                    spikes.len()
                ))
                .because(WHY),
            );
        }
    }
    cases
}

fn rates() -> Vec<Case> {
    let mut cases = Vec::new();
    for input in [0.0, 40.0, -15.0, 200.0, 1e6] {
        for dt in [1.0, 0.5] {
            let (mut r, mut time) = (0.0, 0.0);
            let propagator = (-dt / 10.0_f64).exp();
            let (mut times, mut values) = (Vec::new(), Vec::new());
            while time < 20.0 {
                r = r * propagator + input * (1.0 - propagator);
                time += dt;
                if time % 1.0 == 0.0 {
                    times.push(time);
                    values.push(r);
                }
            }
            let open = Open {
                records: vec![record("r", "rate", 1.0)],
                stimuli: vec![stimulus("in", "rate_inject")],
                dt,
                chunk: 20.0,
                ..Open::rate("a")
            };
            let observed =
                observed_with("a", 20.0, object! { "r" => samples(&times, Some(&values)) });
            cases.push(
                case(
                    format!("rate/{input}/dt-{dt}").replace("/-", "/minus-"),
                    &["NCP-SESS-051", "NCP-SESS-054"],
                    vec![
                        (open.text(), opened("a")),
                        (step("a", None, Some(("in", input))), observed),
                    ],
                )
                .title(format!(
                    "A rate neuron under the input {input} in steps of {dt} ms."
                ))
                .because(WHY),
            );
        }
    }
    cases
}

/// A stimulus acts from the first step of its request, and stays.
fn stimuli() -> Vec<Case> {
    let table: [(&str, [Option<f64>; 4]); 7] = [
        ("stays", [Some(300.0), None, None, None]),
        ("comes-late", [None, Some(300.0), None, None]),
        ("changes", [Some(300.0), Some(100.0), None, Some(-50.0)]),
        ("ends", [Some(300.0), Some(0.0), None, None]),
        ("spikes", [Some(900.0), None, Some(0.0), Some(900.0)]),
        ("negative", [Some(-300.0), None, Some(300.0), None]),
        ("none", [None, None, None, None]),
    ];
    let mut cases = Vec::new();
    for (name, values) in table {
        for chunk in [1.0, 5.0] {
            let mut neuron = Lif::new(&[], 1.0);
            let (mut time, mut current) = (0.0, 0.0);
            let open = Open {
                records: vec![record("v", "V_m", 1.0)],
                stimuli: vec![stimulus("in", "current_pA")],
                chunk,
                ..Open::lif("a")
            };
            let mut trace = vec![(open.text(), opened("a"))];
            for value in values {
                current = value.unwrap_or(current);
                let (mut times, mut potentials) = (Vec::new(), Vec::new());
                let end = time + chunk;
                while time < end {
                    neuron.step(current);
                    time += 1.0;
                    times.push(time);
                    potentials.push(neuron.v);
                }
                let observed = observed_with(
                    "a",
                    time,
                    object! { "v" => samples(&times, Some(&potentials)) },
                );
                trace.push((step("a", None, value.map(|value| ("in", value))), observed));
            }
            cases.push(
                case(format!("stimulus/{name}/chunk-{chunk}"), &["NCP-SESS-054", "NCP-SESS-031", "NCP-SESS-050"], trace)
                    .title(format!("A current that {} acts from the first step of its request in chunks of {chunk} ms.", if name == "none" { "never comes".to_owned() } else { name.replace('-', " ") }))
                    .because(WHY),
            );
        }
    }
    // Each session has its own input.
    let open = |id| Open {
        records: vec![record("v", "V_m", 10.0)],
        stimuli: vec![stimulus("in", "current_pA")],
        ..Open::lif(id)
    };
    let after = |current: f64| {
        let (times, values, _) = simulate(&[], 1.0, 10, current);
        let last = |all: &[f64]| all.last().copied().unwrap_or_default();
        object! { "v" => samples(&[last(&times)], Some(&[last(&values)])) }
    };
    let trace = vec![
        (open("a").text(), opened("a")),
        (open("b").text(), opened("b")),
        (
            step("a", None, Some(("in", 200.0))),
            observed_with("a", 10.0, after(200.0)),
        ),
        (step("b", None, None), observed_with("b", 10.0, after(0.0))),
    ];
    cases.push(
        case(
            "stimulus/apart".to_owned(),
            &["NCP-SESS-035", "NCP-SESS-054"],
            trace,
        )
        .title("A current into one session does not reach another.")
        .because("What is done to one session changes no other."),
    );
    cases
}

/// Which ports come back.
fn ports() -> Vec<Case> {
    use crate::trace::exactly;
    let (times, values, _) = simulate(&[("I_e", 500.0)], 1.0, 10, 500.0);
    let (_, _, spikes) = simulate(&[("I_e", 500.0)], 1.0, 40, 500.0);
    let driven = |records: Vec<Json>| Open {
        params: vec![("I_e", 500.0)],
        records,
        ..Open::lif("a")
    };
    let v = || samples(&times, Some(&values));
    let first_spikes: Vec<f64> = spikes
        .iter()
        .copied()
        .filter(|time| *time <= 10.0)
        .collect();
    let s = || samples(&first_spikes, None);
    let mut cases = Vec::new();
    for (name, records, expected) in [
        ("none", Vec::new(), Json::object()),
        ("one", vec![record("v", "V_m", 1.0)], object! { "v" => v() }),
        (
            "two",
            vec![record("v", "V_m", 1.0), record("s", "spikes", 1.0)],
            object! { "v" => v(), "s" => s() },
        ),
        (
            "two-of-one-kind",
            vec![record("v", "V_m", 1.0), record("w", "V_m", 1.0)],
            object! { "v" => v(), "w" => v() },
        ),
        (
            "odd-name",
            vec![record("the port/1", "V_m", 1.0)],
            object! { "the port/1" => v() },
        ),
    ] {
        cases.push(
            case(format!("port/{name}"), &["NCP-SESS-038"], vec![(driven(records).text(), opened("a")), (step("a", None, None), observed_with("a", 10.0, exactly(expected)))])
                .title(format!("A session returns the ports that it records and no other ({name})."))
                .because("A server returns, in `records`, an observation for each port that the session records, and for no other."),
        );
    }
    // One neuron of three, by its id.
    for id in 1..=3_u32 {
        let target = record("v", "V_m", 1.0).with("ids", Json::Array(vec![id.into()]));
        let open = Open {
            size: 3,
            ..driven(vec![target])
        };
        let senders: Json = times.iter().map(|_| id).collect();
        let observed = observed_with("a", 10.0, object! { "v" => v().with("senders", senders) });
        cases.push(
            case(
                format!("id/{id}-of-3"),
                &["NCP-SESS-052"],
                vec![
                    (open.text(), opened("a")),
                    (step("a", None, None), observed),
                ],
            )
            .title(format!("Neuron {id} of three is recorded by its id."))
            .because("A neuron's id is its position within its population, from 1."),
        );
    }
    // Samples go on over requests.
    let halves = driven(vec![record("v", "V_m", 2.0)]);
    let (all_times, all_values, _) = simulate(&[("I_e", 500.0)], 1.0, 9, 500.0);
    let part = |from: f64, to: f64| {
        let chosen: Vec<(f64, f64)> = all_times
            .iter()
            .copied()
            .zip(all_values.iter().copied())
            .filter(|(time, _)| *time > from && *time <= to && time % 2.0 == 0.0)
            .collect();
        let (times, values): (Vec<f64>, Vec<f64>) = chosen.into_iter().unzip();
        observed_with("a", to, object! { "v" => samples(&times, Some(&values)) })
    };
    cases.push(
        case(
            "cadence/over-requests".to_owned(),
            &["NCP-SESS-053"],
            vec![(halves.text(), opened("a")), (step("a", Some(3.0), None), part(0.0, 3.0)), (step("a", Some(3.0), None), part(3.0, 6.0)), (step("a", Some(3.0), None), part(6.0, 9.0))],
        )
        .title("A port is sampled at multiples of its cadence since the session opened, not since the request.")
        .because("The backend samples a port at every multiple of its `cadence_ms`, from the first after the session opened."),
    );
    cases
}
