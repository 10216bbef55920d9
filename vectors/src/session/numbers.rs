//! The reference networks against their own closed solutions.

use super::{Open, error, not_opened, observation, observed, opened, record, recorded, reference, run, step, stimulus};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::trace::{any, nums, within};

pub(super) fn file() -> File {
    let mut cases = potentials();
    cases.extend(thresholds());
    cases.extend(spikes());
    cases.extend(rests());
    cases.extend(rates());
    cases.extend(stimuli());
    cases.extend(lasting());
    cases.extend(reach());
    cases.extend(neurons_by_bits());
    cases.extend(shared_names());
    cases.extend(units());
    cases.extend(ports());
    cases.extend(many_ports());
    cases.extend(cadences());
    cases.extend(refusals());
    cases.extend(durations());
    cases.extend(orders());
    cases.extend(orders_of_ports());
    cases.extend(sums());
    cases.extend(far());
    cases.extend(near());
    cases.extend(slow());
    cases.extend(alike());
    cases.extend(reopened());
    cases.extend(beyond_32_bits());
    cases.extend(much_at_once());
    cases.extend(no_neurons());
    cases.extend(empty_names());
    cases.extend(many_named());
    cases.extend(failures_behind_many_steps());
    cases.extend(failures_at_rest());
    cases.extend(large_together());
    cases.extend(exact_times());
    cases.extend(own_ports());
    cases.extend(announced());
    cases.extend(rounded_rests());
    cases.extend(of_no_step());
    cases.extend(own_neurons());
    cases.extend(tiny());
    cases.extend(short_steps());
    cases.extend(opened_otherwise());
    cases.extend(room());
    let about = "The numbers of the reference networks: membrane potentials, spikes and rates by exact propagation.";
    File::new("session", "reference", about, cases)
}

const WHY: &str =
    "Section 4.4: exact propagation on the grid of `dt_ms`; asked of servers that claim the reference networks.";

/// A leaky integrate-and-fire neuron, as section 4.4 writes it.
pub(super) struct Lif {
    pub(super) v: f64,
    resting: u32,
    propagator: f64,
    gain: f64,
    e_l: f64,
    v_th: f64,
    v_reset: f64,
    refractory: u32,
}

impl Lif {
    pub(super) fn new(params: &[(&str, f64)], dt: f64) -> Self {
        let param = |name: &str, default: f64| {
            params.iter().find(|(known, _)| *known == name).map_or(default, |(_, value)| *value)
        };
        let tau = param("tau_m", 10.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a handful of steps")]
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
    pub(super) fn step(&mut self, current: f64) -> bool {
        if self.resting > 0 {
            self.resting -= 1;
            self.v = self.v_reset;
            return false;
        }
        self.v = self.e_l + (self.v - self.e_l) * self.propagator + current * self.gain * (1.0 - self.propagator);
        let spikes = self.v >= self.v_th;
        if spikes {
            self.v = self.v_reset;
            self.resting = self.refractory;
        }
        spikes
    }
}

/// The observation of one neuron, but for its id.
fn samples(times: &[f64], values: Option<&[f64]>) -> Json {
    object! { "times" => nums(times), "values" => nums(values.unwrap_or_default()) }
}

/// How often, and from whom.
fn sent(times: &[f64], senders: &[u32]) -> Json {
    object! { "times" => nums(times), "senders" => senders.iter().copied().collect::<Json>() }
}

/// A neuron run by the model: times and potentials at each step, and the times of its spikes.
pub(super) fn simulate(params: &[(&str, f64)], dt: f64, steps: u32, current: f64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
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
        ("rest-just-rounded-up", vec![("t_ref", 3.55), ("I_e", 600.0)]),
        ("rest-just-rounded-down", vec![("t_ref", 3.45), ("I_e", 600.0)]),
        ("reset-to-threshold", vec![("V_reset", -55.0), ("I_e", 600.0)]),
        ("reset-above-threshold", vec![("V_reset", -40.0), ("I_e", 600.0)]),
        ("other-levels", vec![("E_L", -65.0), ("V_th", -50.0), ("V_reset", -75.0), ("I_e", 450.0)]),
    ]
}

fn current(params: &[(&str, f64)]) -> f64 {
    params.iter().find(|(name, _)| *name == "I_e").map_or(0.0, |(_, value)| *value)
}

fn potentials() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, params) in networks() {
        for (dt, steps) in [(1.0, 20_u32), (0.5, 40), (0.25, 80)] {
            let (times, values, _) = simulate(&params, dt, steps, current(&params));
            let open = Open { params: params.clone(), records: vec![record("v", "V_m", dt)], dt, ..Open::lif("a") };
            let observed = recorded("a", object! { "v" => samples(&times, Some(&values)) });
            cases.push(
                reference(
                    format!("potential/{name}/dt-{dt}"),
                    &["NCP-SESS-050"],
                    vec![(open.text(), opened("a")), (step("a", Some(20.0), None), observed)],
                )
                .title(format!("The potential of a neuron ({name}) over 20 ms in steps of {dt} ms."))
                .because(WHY),
            );
        }
    }
    cases
}

/// A potential that reaches the threshold exactly: with numbers for which no order of the operations rounds.
fn thresholds() -> Vec<Case> {
    // At rest on the threshold; and driven to it in a single step that forgets the one before.
    let at_rest = vec![("E_L", 0.0), ("V_th", 0.0), ("V_reset", -10.0)];
    let tau = 1.0 / 1024.0;
    let driven =
        vec![("tau_m", tau), ("C_m", 1.0), ("I_e", 15.0 * 1024.0), ("E_L", 0.0), ("V_th", 15.0), ("V_reset", -10.0)];
    let mut cases = Vec::new();
    for (name, params) in [("at-rest", at_rest), ("driven", driven)] {
        let (times, values, spikes) = simulate(&params, 1.0, 10, current(&params));
        for (what, observable, expected) in
            [("spikes", "spikes", samples(&spikes, None)), ("potential", "V_m", samples(&times, Some(&values)))]
        {
            let open = Open { params: params.clone(), records: vec![record("out", observable, 1.0)], ..Open::lif("a") };
            cases.push(
                reference(
                    format!("threshold/{name}/{what}"),
                    &["NCP-SESS-050"],
                    vec![
                        (open.text(), opened("a")),
                        (step("a", Some(10.0), None), recorded("a", object! { "out" => expected })),
                    ],
                )
                .title(format!(
                    "A neuron whose potential is exactly the threshold ({}) spikes ({what}).",
                    name.replace('-', " ")
                ))
                .because("A neuron spikes when V \u{2265} V_th."),
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
            let open = Open { params: params.clone(), records: vec![record("s", "spikes", 1.0)], dt, ..Open::lif("a") };
            let observed = recorded("a", object! { "s" => samples(&spikes, None) });
            cases.push(
                reference(
                    format!("spikes/{name}/dt-{dt}"),
                    &["NCP-SESS-050"],
                    vec![(open.text(), opened("a")), (step("a", Some(60.0), None), observed)],
                )
                .title(format!("A neuron ({name}) spikes {} times in 60 ms in steps of {dt} ms.", spikes.len()))
                .because(WHY),
            );
        }
    }
    cases
}

/// Requests that begin while a neuron rests.
fn rests() -> Vec<Case> {
    let params = vec![("t_ref", 5.0), ("I_e", 600.0)];
    let one = |length: u32| {
        let (_, _, spikes) = simulate(&params, 1.0, 60, 600.0);
        let open = Open { params: params.clone(), records: vec![record("s", "spikes", 1.0)], ..Open::lif("a") };
        let mut trace = vec![(open.text(), opened("a"))];
        for nth in 0..60 / length {
            let (from, to) = (f64::from(nth * length), f64::from((nth + 1) * length));
            let within: Vec<f64> = spikes.iter().copied().filter(|time| *time > from && *time <= to).collect();
            trace.push((step("a", Some(to - from), None), recorded("a", object! { "s" => samples(&within, None) })));
        }
        reference(format!("spikes/rests/requests-of-{length}-ms"), &["NCP-SESS-050"], trace)
            .title(format!("A neuron rests for 5 ms after a spike, whatever requests of {length} ms begin meanwhile."))
            .because(WHY)
    };
    // Rests of more steps than a byte, twelve bits or sixteen count.
    let long = |rest: f64, duration: f64| {
        let params = vec![("t_ref", rest), ("I_e", 600.0)];
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number of steps")]
        let (_, _, spikes) = simulate(&params, 0.125, (duration * 8.0) as u32, 600.0);
        let open = Open { params, dt: 0.125, records: vec![record("s", "spikes", 1.0)], ..Open::lif("a") };
        let trace = vec![
            (open.text(), opened("a")),
            (step("a", Some(duration), None), recorded("a", object! { "s" => samples(&spikes, None) })),
        ];
        reference(format!("spikes/rests/of-{rest}-ms"), &["NCP-SESS-050"], trace)
            .title(format!("A neuron rests for {rest} ms after a spike, in steps of 0.125 ms."))
            .because(WHY)
    };
    let longer = [(40.0, 100.0), (600.0, 1_300.0), (8_500.0, 9_000.0)].map(|(rest, run)| long(rest, run));
    [1, 2, 3].map(one).into_iter().chain(longer).collect()
}

fn rates() -> Vec<Case> {
    let mut cases = Vec::new();
    let free = Vec::new;
    let table: [(&str, Params, f64); 10] = [
        ("0", free(), 0.0),
        ("40", free(), 40.0),
        ("minus-15", free(), -15.0),
        ("200", free(), 200.0),
        ("1000000", free(), 1e6),
        ("mu", vec![("mu", 25.0)], 0.0),
        ("mu-negative", vec![("mu", -10.0)], 0.0),
        ("mu-and-input", vec![("mu", 25.0)], 40.0),
        ("mu-against-input", vec![("mu", 30.0)], -30.0),
        ("tau", vec![("tau", 20.0), ("mu", 5.0)], 40.0),
    ];
    for (name, params, input) in table {
        for dt in [1.0, 0.5] {
            let param = |wanted: &str, default: f64| {
                let given = params.iter().find(|(name, _)| *name == wanted);
                given.map_or(default, |(_, value)| *value)
            };
            let (mut r, mut time) = (0.0, 0.0);
            let propagator = (-dt / param("tau", 10.0)).exp();
            let (mut times, mut values) = (Vec::new(), Vec::new());
            while time < 20.0 {
                r = r * propagator + (param("mu", 0.0) + input) * (1.0 - propagator);
                time += dt;
                times.push(time);
                values.push(r);
            }
            let open = Open {
                params: params.clone(),
                records: vec![record("r", "rate", dt)],
                stimuli: vec![stimulus("in", "rate_inject")],
                dt,
                ..Open::rate("a")
            };
            let observed = recorded("a", object! { "r" => samples(&times, Some(&values)) });
            // Without an input, none is sent: then the case is about the law alone.
            let drive = (input != 0.0).then_some(("in", input));
            cases.push(
                reference(
                    format!("rate/{name}/dt-{dt}"),
                    &["NCP-SESS-051"],
                    vec![(open.text(), opened("a")), (step("a", Some(20.0), drive), observed)],
                )
                .title(format!("A rate neuron ({name}) under the input {input} in steps of {dt} ms."))
                .because(WHY),
            );
        }
    }
    // So long that it is next to its limit.
    for dt in [0.125, 1.0] {
        let open = Open { params: vec![("mu", 5.0)], records: vec![record("r", "rate", 100.0)], dt, ..Open::rate("a") };
        let times = [100.0, 200.0, 300.0];
        let values = times.map(|time: f64| -5.0 * (-time / 10.0).exp_m1());
        let observed = recorded("a", object! { "r" => samples(&times, Some(&values)) });
        let trace = vec![(open.text(), opened("a")), (step("a", Some(300.0), None), observed)];
        cases.push(
            reference(format!("rate/settles/dt-{dt}"), &["NCP-SESS-051"], trace)
                .title(format!("A rate neuron comes to its limit in steps of {dt} ms, and stops nowhere short of it."))
                .because(WHY),
        );
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
                let observed = recorded("a", object! { "v" => samples(&times, Some(&potentials)) });
                trace.push((step("a", Some(chunk), value.map(|value| ("in", value))), observed));
            }
            cases.push(
                reference(format!("stimulus/{name}/chunk-{chunk}"), &["NCP-SESS-054", "NCP-SESS-050"], trace)
                    .title(format!(
                        "A current that {} acts from the first step of its request in steps of {chunk} ms.",
                        if name == "none" { "never comes".to_owned() } else { name.replace('-', " ") }
                    ))
                    .because(WHY),
            );
        }
    }
    // A request of a quarter of a step runs none, and its value stays.
    let open =
        Open { records: vec![record("v", "V_m", 1.0)], stimuli: vec![stimulus("in", "current_pA")], ..Open::lif("a") };
    let (times, values, _) = simulate(&[], 1.0, 5, 300.0);
    let trace = vec![
        (open.text(), opened("a")),
        (step("a", Some(0.25), Some(("in", 300.0))), observed("a", 0.0)),
        (step("a", Some(5.0), None), recorded("a", object! { "v" => samples(&times, Some(&values)) })),
    ];
    cases.push(
        reference("stimulus/of-no-step".to_owned(), &["NCP-SESS-054", "NCP-SESS-058"], trace)
            .title("A current that comes with a request of no step acts from the next step.")
            .because(WHY),
    );
    // Values that add up as before, and drive other neurons.
    for (name, second) in [("swapped", [-100.0, 300.0]), ("turned", [100.0, 100.0]), ("to-nothing", [200.0, 0.0])] {
        let ids = |id: u32| std::iter::once(id).collect::<Json>();
        let drive = |port: &str, id| stimulus(port, "current_pA").with("ids", ids(id));
        let record = |port: &str, id| record(port, "V_m", 1.0).with("ids", ids(id));
        let open = Open {
            size: 2,
            records: vec![record("v", 1), record("w", 2)],
            stimuli: vec![drive("x", 1), drive("y", 2)],
            ..Open::lif("a")
        };
        let mut neurons = [Lif::new(&[], 1.0), Lif::new(&[], 1.0)];
        let mut trace = vec![(open.text(), opened("a"))];
        for (time, currents) in (1_u32..).zip([[300.0, -100.0], second]) {
            let mut potential = |nth: usize| {
                neurons[nth].step(currents[nth]);
                samples(&[f64::from(time)], Some(&[neurons[nth].v]))
            };
            let records = object! { "v" => potential(0), "w" => potential(1).without("senders") };
            trace.push((driven_step("a", 1.0, &[("x", currents[0]), ("y", currents[1])]), recorded("a", records)));
        }
        cases.push(
            reference(format!("stimulus/of-one-sum/{name}"), &["NCP-SESS-054", "NCP-SESS-050"], trace)
                .title(format!("Two ports whose values are {} drive their own neurons.", name.replace('-', " ")))
                .because(
                    "The last value of each port drives the neurons of its target, whatever all of them add up to.",
                ),
        );
    }
    // A stimulus frame that names no port changes none.
    for (name, empty) in [
        ("empty", object! {}),
        ("without-values", object! { "values" => object! {} }),
        ("of-another-port", object! { "values" => object! { "other" => object! { "data" => nums(&[0.0]) } } }),
    ] {
        let mut neuron = Lif::new(&[], 1.0);
        let open = Open {
            records: vec![record("v", "V_m", 1.0)],
            stimuli: vec![stimulus("in", "current_pA"), stimulus("other", "current_pA")],
            ..Open::lif("a")
        };
        let mut trace = vec![(open.text(), opened("a"))];
        for chunk in 0..4 {
            let (mut times, mut potentials) = (Vec::new(), Vec::new());
            for nth in 1..=5 {
                neuron.step(300.0);
                times.push(f64::from(5 * chunk + nth));
                potentials.push(neuron.v);
            }
            let request = match chunk {
                0 => step("a", Some(5.0), Some(("in", 300.0))),
                1 => Json::read(&run("a", 5.0)).with("stimulus", empty.clone()).text(),
                2 => step("a", Some(5.0), None),
                _ => Json::read(&step("a", Some(5.0), None)).with("stimulus", empty.clone()).text(),
            };
            trace.push((request, recorded("a", object! { "v" => samples(&times, Some(&potentials)) })));
        }
        cases.push(
            reference(format!("stimulus/stays/{name}"), &["NCP-SESS-054"], trace)
                .title(format!("A current stays under a stimulus frame that is {}.", name.replace('-', " ")))
                .because("A stimulus stays until another value for its port comes."),
        );
    }
    // Networks whose parameters have the same values under other names are others.
    let named = |id, name| Open {
        params: vec![(name, 20.0)],
        records: vec![record("v", "V_m", 10.0)],
        stimuli: vec![stimulus("in", "current_pA")],
        ..Open::lif(id)
    };
    let last = |name| {
        let (times, values, _) = simulate(&[(name, 20.0)], 1.0, 10, 300.0);
        let last = |all: &[f64]| all.last().copied().unwrap_or_default();
        object! { "v" => samples(&[last(&times)], Some(&[last(&values)])) }
    };
    let trace = vec![
        (named("a", "tau_m").text(), opened("a")),
        (named("b", "t_ref").text(), opened("b")),
        (step("a", None, Some(("in", 300.0))), recorded("a", last("tau_m"))),
        (step("b", None, Some(("in", 300.0))), recorded("b", last("t_ref"))),
    ];
    cases.push(
        reference("params/apart".to_owned(), &["NCP-SESS-035", "NCP-SESS-050"], trace)
            .title("A parameter of one session is not that of another with the same value.")
            .because(WHY),
    );
    cases.extend(swapped());
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
        (step("a", None, Some(("in", 200.0))), recorded("a", after(200.0))),
        (step("b", None, None), recorded("b", after(0.0))),
    ];
    cases.push(
        reference("stimulus/apart".to_owned(), &["NCP-SESS-035", "NCP-SESS-054"], trace)
            .title("A current into one session does not reach another.")
            .because("What is done to one session changes no other."),
    );
    cases
}

/// Networks whose parameters have swapped their values are others: side by side, and one behind the other.
fn swapped() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, [one, two], [x, y]) in [
        ("leak-and-reset", ["E_L", "V_reset"], [-70.0, -64.0]),
        ("capacity-and-time-constant", ["C_m", "tau_m"], [40.0, 20.0]),
        ("time-constant-and-refractory-time", ["tau_m", "t_ref"], [5.0, 8.0]),
    ] {
        let (p, q) = ([(one, x), (two, y)], [(one, y), (two, x)]);
        let open = |id: &str, params: [(&'static str, f64); 2]| Open {
            params: params.to_vec(),
            records: vec![record("v", "V_m", 10.0)],
            stimuli: vec![stimulus("in", "current_pA")],
            ..Open::lif(id)
        };
        let after = |params: [(&'static str, f64); 2]| {
            let (times, values, _) = simulate(&params, 1.0, 10, 30.0);
            let last = |all: &[f64]| all.last().copied().unwrap_or_default();
            object! { "v" => samples(&[last(&times)], Some(&[last(&values)])) }
        };
        let opens = |id: &str, params| (open(id, params).text(), opened(id));
        let steps = |id: &str, params| (step(id, None, Some(("in", 30.0))), recorded(id, after(params)));
        for (how, words, trace) in [
            ("apart", "in two sessions", vec![opens("a", p), opens("b", q), steps("b", q), steps("a", p)]),
            (
                "anew",
                "in a session that is opened anew",
                vec![
                    opens("a", p),
                    steps("a", p),
                    (super::close("a"), crate::trace::anything()),
                    opens("a", q),
                    steps("a", q),
                ],
            ),
        ] {
            cases.push(
                reference(format!("params/swapped/{name}/{how}"), &["NCP-SESS-050", "NCP-SESS-035"], trace)
                    .title(format!("The values of `{one}` and `{two}` are their own {words}."))
                    .because(
                        "A parameter is known by its name: networks with the same values under other names are others.",
                    ),
            );
        }
    }
    cases
}

/// A session that is opened just as one was that has ended: it begins as that one did, and not as that one ended.
fn reopened() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, words, current) in [("driven", "driven", 30.0), ("spiking", "made to spike", 4000.0)] {
        let opens = |id: &str| {
            let open = Open {
                records: vec![record("v", "V_m", 1.0)],
                stimuli: vec![stimulus("in", "current_pA"), stimulus("more", "current_pA")],
                ..Open::lif(id)
            };
            (open.text(), opened(id))
        };
        let after = |steps: u32, driven: f64| {
            let (times, values, _) = simulate(&[], 1.0, steps, driven);
            object! { "v" => samples(&times, Some(&values)) }
        };
        let driven = |id: &str| (step(id, Some(7.0), Some(("in", current))), recorded(id, after(7, current)));
        let at_rest = |id: &str| (step(id, Some(10.0), None), recorded(id, after(10, 0.0)));
        let closes = |id: &str| (super::close(id), crate::trace::anything());
        let by_other_port = |id: &str| (step(id, Some(6.0), Some(("more", 90.0))), recorded(id, after(6, 90.0)));
        for (id, which) in [("a", "with its id"), ("b", "with another id")] {
            let trace = vec![opens("a"), driven("a"), closes("a"), opens(id), by_other_port(id)];
            let path = format!("reopened/{name}/by-other-port/{}", if id == "a" { "same-id" } else { "other-id" });
            cases.push(
                reference(path, &["NCP-SESS-035", "NCP-SESS-050"], trace)
                    .title(format!(
                        "A session that is opened {which} just as one that was {words} and closed is driven by its \
                         own port alone."
                    ))
                    .because("What another session was given at a port acts in that session and in no other."),
            );
        }
        for (how, which, trace) in [
            ("same-id", "with its id", vec![opens("a"), driven("a"), closes("a"), opens("a"), at_rest("a")]),
            ("other-id", "with another id", vec![opens("a"), driven("a"), closes("a"), opens("b"), at_rest("b")]),
            (
                "two-of-them",
                "and another, at the same time,",
                vec![
                    opens("a"),
                    opens("b"),
                    driven("a"),
                    closes("a"),
                    at_rest("b"),
                    closes("b"),
                    opens("a"),
                    at_rest("a"),
                ],
            ),
        ] {
            cases.push(
                reference(format!("reopened/{name}/{how}"), &["NCP-SESS-035", "NCP-SESS-050"], trace)
                    .title(format!(
                        "A session that is opened {which} just as one that was {words} and closed begins at rest."
                    ))
                    .because(
                        "What was done to a session, its stimuli among it, changes no other, not the next either.",
                    ),
            );
        }
    }
    cases
}

/// Which neurons a stimulus reaches: two of a population of three, or one population of two.
fn reach() -> Vec<Case> {
    let after = |current: f64| simulate(&[], 1.0, 5, current).1.last().copied().unwrap_or_default();
    let drive = |target: &str, ids: &[u32]| {
        object! { "port" => "in", "target" => target, "kind" => "current_pA",
        "ids" => ids.iter().copied().collect::<Json>() }
    };
    let of =
        |target: &str, port: &str| record(port, "V_m", 5.0).with("target", target.into()).with("port", port.into());
    #[expect(clippy::type_complexity, reason = "a table is read by its rows")]
    let table: [(&str, &str, &str, &[u32], [bool; 3], u32, bool); 8] = [
        ("all", "all of its population", "pop", &[], [true; 3], 1, false),
        ("other", "no neuron of another population", "other", &[], [false; 3], 1, true),
        ("all-of-one-size", "no neuron of another population of its size", "pop", &[], [true; 3], 3, false),
        ("other-of-one-size", "no neuron of another population of its size", "other", &[], [false; 3], 3, true),
        ("first", "the neuron that it names", "pop", &[1], [true, false, false], 1, false),
        ("last", "the neuron that it names", "pop", &[3], [false, false, true], 1, false),
        ("two", "the neurons that it names", "pop", &[1, 3], [true, false, true], 1, false),
        ("other-id", "the neuron that it names, in its population", "other", &[1], [false; 3], 1, true),
    ];
    table
        .into_iter()
        .map(|(name, words, target, ids, pop, size, other)| {
            let open = Open {
                size: 3,
                other: Some(size),
                records: vec![of("pop", "v"), of("other", "w")],
                stimuli: vec![drive(target, ids)],
                ..Open::lif("a")
            };
            let driven = |is: bool| after(if is { 300.0 } else { 0.0 });
            let v = nums(&pop.map(driven));
            let w = nums(&vec![driven(other); size as usize]);
            let records = object! { "v" => object! { "values" => v }, "w" => object! { "values" => w } };
            reference(
                format!("reach/{name}"),
                &["NCP-SESS-055"],
                vec![(open.text(), opened("a")), (step("a", Some(5.0), Some(("in", 300.0))), recorded("a", records))],
            )
            .title(format!("A stimulus reaches {words} ({name})."))
            .because(
                "A stimulus reaches the neurons of its target that its `ids` name, all of them when it names \
                      none, and no others.",
            )
        })
        .collect()
}

/// A stimulus stays however many requests come without one, and however long they run.
fn lasting() -> Vec<Case> {
    let driven = |ports: &[&str]| Open {
        records: vec![record("v", "V_m", 1.0)],
        stimuli: ports.iter().map(|port| stimulus(port, "current_pA")).collect(),
        ..Open::lif("a")
    };
    let mut cases = Vec::new();
    let mut add = |name: &str, words: &str, trace| {
        cases.push(
            reference(format!("stimulus/{name}"), &["NCP-SESS-054", "NCP-SESS-050"], trace)
                .title(format!("A current stays {words}."))
                .because(
                    "A stimulus acts from the first step of its request, and stays until another value for its port \
                     comes.",
                ),
        );
    };
    // One request a step; of most only the last potential is asked, and of none when it is written down.
    let steps =
        |open: Open, count: u32, value: &dyn Fn(u32) -> Option<(&'static str, f64)>, current: &dyn Fn(u32) -> f64| {
            let mut neuron = Lif::new(&[], 1.0);
            let mut trace = vec![(open.text(), opened("a"))];
            for nth in 1..=count {
                neuron.step(current(nth));
                let observed = recorded("a", object! { "v" => samples(&[f64::from(nth)], Some(&[neuron.v])) });
                let request = step("a", Some(1.0), value(nth));
                trace.push((request, if nth % 8 == 0 || nth == count { observed } else { observation("a") }));
            }
            trace
        };
    add(
        "over-requests/of-nothing",
        "over sixty requests that bring none",
        steps(driven(&["in"]), 60, &|nth| (nth == 1).then_some(("in", 300.0)), &|_| 300.0),
    );
    add("over-requests/for-long", "over a thousand requests that bring none", {
        const MANY: u16 = 1_000;
        let mut neuron = Lif::new(&[], 1.0);
        for _ in 0..MANY {
            neuron.step(300.0);
        }
        let last = recorded("a", object! { "v" => samples(&[f64::from(MANY)], Some(&[neuron.v])) });
        let without = || step("a", Some(1.0), None);
        let mut trace = vec![(driven(&["in"]).text(), opened("a"))];
        trace.push((step("a", Some(1.0), Some(("in", 300.0))), observation("a")));
        trace.extend(std::iter::repeat_n((without(), observation("a")), usize::from(MANY) - 2));
        trace.push((without(), last));
        trace
    });
    add(
        "over-requests/of-another-port",
        "over twenty-four requests that drive another port of the same neuron",
        steps(
            driven(&["in", "more"]),
            25,
            &|nth| Some(if nth == 1 { ("in", 200.0) } else { ("more", f64::from(nth)) }),
            &|nth| if nth == 1 { 200.0 } else { 200.0 + f64::from(nth) },
        ),
    );
    add("over-requests/of-no-step", "over twenty-four requests of no step", {
        let mut trace = vec![(driven(&["in"]).text(), opened("a"))];
        trace.push((step("a", Some(0.25), Some(("in", 300.0))), observation("a")));
        trace.extend((0..24).map(|_| (step("a", Some(0.25), None), observation("a"))));
        let (times, values, _) = simulate(&[], 1.0, 3, 300.0);
        let observed = recorded("a", object! { "v" => samples(&times, Some(&values)) });
        trace.push((step("a", Some(3.0), None), observed));
        trace
    });
    add("over-requests/of-a-run", "behind the run that brought it", {
        let brought = step("a", Some(5.0), Some(("in", 300.0)));
        let brought = brought.replace("step_request", "run_request").replace("advance_ms", "duration_ms");
        let (times, values, _) = simulate(&[], 1.0, 15, 300.0);
        let five = |from: usize| {
            recorded("a", object! { "v" => samples(&times[from..from + 5], Some(&values[from..from + 5])) })
        };
        vec![
            (driven(&["in"]).text(), opened("a")),
            (brought, five(0)),
            (step("a", Some(5.0), None), five(5)),
            (run("a", 5.0), five(10)),
        ]
    });
    // Long runs, of which a neuron that never spikes is at rest at the end.
    let long = Open { records: vec![record("v", "V_m", 500.0)], ..driven(&["in"]) };
    let (times, values, _) = simulate(&[], 1.0, 3000, 300.0);
    let at = |all: &[f64], from: usize| [all[from + 499], all[from + 999], all[from + 1499]];
    let observed = |from| recorded("a", object! { "v" => samples(&at(&times, from), Some(&at(&values, from))) });
    add(
        "over-time/3000-ms",
        "over three seconds of simulation time",
        vec![
            (long.text(), opened("a")),
            (step("a", Some(1500.0), Some(("in", 300.0))), observed(0)),
            (run("a", 1500.0), observed(1500)),
        ],
    );
    cases
}

/// Neurons whose ids have more bits than 8, 9, 10 and 12, and those that share the lower ones.
fn neurons_by_bits() -> Vec<Case> {
    let after = |current: f64| simulate(&[], 1.0, 5, current).1.last().copied().unwrap_or_default();
    let list = |ids: &[u32]| ids.iter().copied().collect::<Json>();
    let mut cases = Vec::new();
    for bits in [8_u32, 9, 10, 12, 16] {
        let whole = 1_u32 << bits;
        let ids = [1, 2, whole, whole + 1, whole + 2];
        let record = record("v", "V_m", 5.0).with("ids", list(&ids));
        for (name, driven) in
            [("beyond", vec![whole + 1]), ("before", vec![1]), ("at", vec![whole]), ("both", vec![2, whole + 2])]
        {
            let drive = stimulus("in", "current_pA").with("ids", list(&driven));
            let open = Open { size: whole + 2, records: vec![record.clone()], stimuli: vec![drive], ..Open::lif("a") };
            let values = ids.map(|id| after(if driven.contains(&id) { 300.0 } else { 0.0 }));
            let v = object! { "values" => nums(&values), "senders" => list(&ids) };
            let trace = vec![
                (open.text(), opened("a")),
                (step("a", Some(5.0), Some(("in", 300.0))), recorded("a", object! { "v" => v })),
            ];
            let names = driven.iter().map(ToString::to_string).collect::<Vec<_>>().join(" and ");
            cases.push(
                reference(format!("reach/{name}-2-to-{bits}"), &["NCP-SESS-055", "NCP-SESS-052"], trace)
                    .title(format!("Of {} neurons a stimulus reaches number {names} and no other.", whole + 2))
                    .because(
                        "A stimulus reaches each of the neurons that its `ids` name, and no others; an id is the \
                         position within the population, from 1.",
                    ),
            );
        }
        // A stimulus without ids reaches each.
        let open = Open {
            size: whole + 2,
            records: vec![record.clone()],
            stimuli: vec![stimulus("in", "current_pA")],
            ..Open::lif("a")
        };
        let v = object! { "values" => nums(&ids.map(|_| after(300.0))), "senders" => list(&ids) };
        let trace = vec![
            (open.text(), opened("a")),
            (step("a", Some(5.0), Some(("in", 300.0))), recorded("a", object! { "v" => v })),
        ];
        cases.push(
            reference(format!("reach/every-of-2-to-{bits}"), &["NCP-SESS-055", "NCP-SESS-052"], trace)
                .title(format!("A stimulus without ids reaches the last of {} neurons as the first.", whole + 2))
                .because("A stimulus without `ids` reaches every neuron of its target."),
        );
        // Who sent a spike, of two that are driven and lie so far apart.
        let drive = stimulus("in", "current_pA").with("ids", list(&[2, whole + 1]));
        let open = Open {
            size: whole + 2,
            records: vec![self::record("s", "spikes", 1.0)],
            stimuli: vec![drive],
            ..Open::lif("a")
        };
        let (_, _, spikes) = simulate(&[], 1.0, 15, 900.0);
        let times: Vec<f64> = spikes.iter().flat_map(|time| [*time, *time]).collect();
        let senders: Vec<u32> = spikes.iter().flat_map(|_| [2, whole + 1]).collect();
        let trace = vec![
            (open.text(), opened("a")),
            (step("a", Some(15.0), Some(("in", 900.0))), recorded("a", object! { "s" => sent(&times, &senders) })),
        ];
        cases.push(
            reference(format!("id/spikes-beyond-2-to-{bits}"), &["NCP-SESS-052", "NCP-SESS-055"], trace)
                .by("/replies/*/records/*/times", "NCP-SESS-059")
                .title(format!("Of {} neurons the spikes of number 2 and {} come by their ids.", whole + 2, whole + 1))
                .because("A neuron's id is its position within its population, from 1."),
        );
    }
    cases
}

/// A port that is recorded and one that is a stimulus, under one name, and names of something else.
fn shared_names() -> Vec<Case> {
    let after = |current: f64| simulate(&[], 1.0, 5, current).1.last().copied().unwrap_or_default();
    let value = |current: f64| object! { "values" => nums(&[after(current)]) };
    let v = |port: &str| record(port, "V_m", 5.0);
    let i = |port: &str| stimulus(port, "current_pA");
    let of = |target: Json, population: &str| target.with("target", population.into());
    let lif = |records: Vec<Json>, stimuli: Vec<Json>| Open { records, stimuli, ..Open::lif("a") };
    let named = |name: &str| lif(vec![v(name)], vec![i(name)]);
    let crossed = Open { other: Some(1), ..lif(vec![of(v("x"), "other"), v("y")], vec![i("x"), of(i("y"), "other")]) };
    let one = |name: &str| Json::Object(vec![(name.to_owned(), value(300.0))]);
    let table: Vec<(&str, &str, Open, &str, Json)> = vec![
        ("of-both", "that is recorded under the same name", named("soma"), "soma", one("soma")),
        ("of-the-population", "that has the name of its population", named("pop"), "pop", one("pop")),
        ("of-the-session", "that has the name of its session", named("a"), "a", one("a")),
        ("of-the-observable", "that has the name of an observable", named("V_m"), "V_m", one("V_m")),
        ("of-a-prototype", "whose name is `__proto__`", named("__proto__"), "__proto__", one("__proto__")),
        (
            "of-two",
            "of two that are both recorded under their names",
            lif(vec![v("x"), v("y")], vec![i("y"), i("x")]),
            "x",
            object! { "x" => value(300.0), "y" => value(300.0) },
        ),
        (
            "of-another-population",
            "under whose name another population is recorded",
            crossed,
            "x",
            object! { "x" => value(0.0), "y" => value(300.0) },
        ),
    ];
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(name, words, open, port, records)| {
            let trace =
                vec![(open.text(), opened("a")), (step("a", Some(5.0), Some((port, 300.0))), recorded("a", records))];
            reference(format!("stimulus/name-{name}"), &["NCP-SESS-054", "NCP-SESS-055"], trace)
                .title(format!("A stimulus reaches a port {words}."))
                .because("A port that is recorded and one that is a stimulus may share a name.")
        })
        .collect();
    // The same of rate neurons, whose input is another.
    let open = Open {
        records: vec![record("x", "rate", 1.0)],
        stimuli: vec![stimulus("x", "rate_inject")],
        ..Open::rate("a")
    };
    let r = 40.0 * (1.0 - (-0.1_f64).exp());
    let records = object! { "x" => samples(&[1.0], Some(&[r])) };
    let trace = vec![(open.text(), opened("a")), (step("a", Some(1.0), Some(("x", 40.0))), recorded("a", records))];
    cases.push(
        reference("stimulus/name-of-both/rate".to_owned(), &["NCP-SESS-054", "NCP-SESS-051"], trace)
            .title("An input reaches a rate neuron that is recorded under the same name.")
            .because("A port that is recorded and one that is a stimulus may share a name."),
    );
    cases
}

/// In which unit observations are.
fn units() -> Vec<Case> {
    let lif = Open { records: vec![record("v", "V_m", 1.0)], ..Open::lif("a") };
    let rate = Open { records: vec![record("r", "rate", 1.0)], ..Open::rate("a") };
    [
        ("potential", "in mV", lif, object! { "v" => object! { "unit" => "mV" } }),
        ("rate", "in Hz", rate, object! { "r" => object! { "unit" => "Hz" } }),
    ]
    .into_iter()
    .map(|(name, words, open, records)| {
        reference(
            format!("unit/{name}"),
            &["NCP-SESS-056"],
            vec![(open.text(), opened("a")), (step("a", Some(5.0), None), recorded("a", records))],
        )
        .title(format!("An observation ({name}) is {words}."))
        .because("An observation carries the unit of its observable, `V_m` in `mV` and `rate` in `Hz`.")
    })
    .collect()
}

/// More ports than a small table holds.
fn many_ports() -> Vec<Case> {
    let mut cases = Vec::new();
    for count in [20_usize, 70, 300] {
        let name = |nth: usize| format!("p{nth}");
        let records: Vec<Json> = (1..=count).map(|nth| record(&name(nth), "V_m", 1.0)).collect();
        let potential = simulate(&[], 1.0, 1, 300.0).1;
        let observed = |nth: usize| (name(nth), object! { "values" => nums(&potential) });
        let open = Open { records, stimuli: vec![stimulus("in", "current_pA")], ..Open::lif("a") };
        let all = crate::trace::exactly(Json::Object((1..=count).map(observed).collect()));
        let trace = vec![(open.text(), opened("a")), (step("a", Some(1.0), Some(("in", 300.0))), recorded("a", all))];
        cases.push(
            reference(format!("port/many/{count}-recorded"), &["NCP-SESS-038"], trace)
                .title(format!("A session returns each of the {count} ports that it records."))
                .because("A server returns an observation for each port that the session records."),
        );
        let share = 4.0;
        let stimuli: Vec<Json> = (1..=count).map(|nth| stimulus(&name(nth), "current_pA")).collect();
        let open = Open { records: vec![record("out", "V_m", 1.0)], stimuli, ..Open::lif("a") };
        #[expect(clippy::cast_precision_loss, reason = "some hundreds")]
        let potential = simulate(&[], 1.0, 1, share * count as f64).1;
        let given: Vec<String> = (1..=count).map(name).collect();
        let given: Vec<(&str, f64)> = given.iter().map(|name| (name.as_str(), share)).collect();
        let records = object! { "out" => samples(&[1.0], Some(&potential)) };
        let trace = vec![(open.text(), opened("a")), (driven_step("a", 1.0, &given), recorded("a", records))];
        cases.push(
            reference(format!("port/many/{count}-driven"), &["NCP-SESS-055", "NCP-SESS-054"], trace)
                .title(format!("What {count} ports give a neuron adds up."))
                .because(
                    "A stimulus reaches each of the neurons of its target; a neuron is given the sum of all ports.",
                ),
        );
    }
    cases
}

/// Which ports come back.
fn ports() -> Vec<Case> {
    use crate::trace::exactly;
    let driven = |records: Vec<Json>| Open { params: vec![("I_e", 500.0)], records, ..Open::lif("a") };
    // What is in the observations is the affair of other cases.
    let some = Json::object;
    let mut cases = Vec::new();
    for (name, records, expected) in [
        ("none", Vec::new(), Json::object()),
        ("one", vec![record("v", "V_m", 1.0)], object! { "v" => some() }),
        ("two", vec![record("v", "V_m", 1.0), record("s", "spikes", 1.0)], object! { "v" => some(), "s" => some() }),
        (
            "two-of-one-kind",
            vec![record("v", "V_m", 1.0), record("w", "V_m", 1.0)],
            object! { "v" => some(), "w" => some() },
        ),
        ("odd-name", vec![record("the port/1", "V_m", 1.0)], object! { "the port/1" => some() }),
    ] {
        cases.push(
            reference(
                format!("port/{name}"),
                &["NCP-SESS-038"],
                vec![(driven(records).text(), opened("a")), (step("a", None, None), recorded("a", exactly(expected)))],
            )
            .title(format!("A session returns the ports that it records and no other ({name})."))
            .because(
                "A server returns, in `records`, an observation for each port that the session records, \
                          and for no other.",
            ),
        );
    }
    // One neuron of three, by its id; and all three.
    let times = [1.0, 2.0, 3.0];
    for ids in [&[1_u32][..], &[2], &[3], &[1, 3], &[]] {
        let target = record("v", "V_m", 1.0).with("ids", ids.iter().copied().collect());
        let open = Open { size: 3, ..driven(vec![target]) };
        let named = if ids.is_empty() { &[1, 2, 3] } else { ids };
        let senders: Vec<u32> = times.iter().flat_map(|_| named.iter().copied()).collect();
        let at: Vec<f64> = times.iter().flat_map(|time| named.iter().map(|_| *time)).collect();
        let name = if ids.is_empty() {
            "all".to_owned()
        } else {
            named.iter().map(ToString::to_string).collect::<Vec<_>>().join("-and-")
        };
        let case = reference(
            format!("id/{name}-of-3"),
            &["NCP-SESS-052"],
            vec![
                (open.text(), opened("a")),
                (step("a", Some(3.0), None), recorded("a", object! { "v" => sent(&at, &senders) })),
            ],
        )
        .title(format!(
            "Of three neurons, {} by id.",
            if ids.len() == 1 {
                format!("number {name} is recorded")
            } else {
                format!("{} are recorded", name.replace('-', " "))
            }
        ))
        .because("A neuron's id is its position within its population, from 1.");
        // Who sent a sample is another question than which comes first.
        cases.push(if named.len() > 1 { case.by("/replies/*/records/*/times", "NCP-SESS-059") } else { case });
    }
    let of_spikes = Open { size: 2, ..driven(vec![record("s", "spikes", 1.0)]) };
    let (_, _, spikes) = simulate(&[("I_e", 500.0)], 1.0, 40, 500.0);
    let twice: Vec<f64> = spikes.iter().flat_map(|time| [*time, *time]).collect();
    let senders: Vec<u32> = spikes.iter().flat_map(|_| [1, 2]).collect();
    cases.push(
        reference(
            "id/spikes-of-2".to_owned(),
            &["NCP-SESS-052"],
            vec![
                (of_spikes.text(), opened("a")),
                (step("a", Some(40.0), None), recorded("a", object! { "s" => sent(&twice, &senders) })),
            ],
        )
        .by("/replies/*/records/*/times", "NCP-SESS-059")
        .title("The spikes of two neurons come by their ids.")
        .because("A neuron's id is its position within its population, from 1."),
    );
    cases
}

/// What the networks should not be opened with. A session that could be opened takes its place.
fn refusals() -> Vec<Case> {
    let v = || record("v", "V_m", 1.0);
    let drive = || stimulus("in", "current_pA");
    let lif = || Open::lif("a");
    let with = |target: Json| Open { records: vec![target], ..lif() };
    let driven = |target: Json| Open { stimuli: vec![target], ..lif() };
    let ids = |of: &[u32]| of.iter().copied().collect::<Json>();
    let table = [
        ("step-of-0", "a step of 0 ms", Open { dt: 0.0, ..lif() }),
        ("step-below-0", "a step of -1 ms", Open { dt: -1.0, ..lif() }),
        ("cadence-of-0", "a cadence of 0 ms", with(record("v", "V_m", 0.0))),
        ("cadence-below-0", "a cadence of -1 ms", with(record("v", "V_m", -1.0))),
        ("recorded-twice", "two recorded ports of one name", Open { records: vec![v(), v()], ..lif() }),
        ("driven-twice", "two stimuli of one port", Open { stimuli: vec![drive(), drive()], ..lif() }),
        ("record-of-none", "a record of a population that is not there", with(v().with("target", "none".into()))),
        (
            "stimulus-of-none",
            "a stimulus of a population that is not there",
            driven(drive().with("target", "none".into())),
        ),
        ("record-of-neuron-0", "a record of neuron 0", with(v().with("ids", ids(&[0])))),
        ("record-of-neuron-2", "a record of the second neuron of one", with(v().with("ids", ids(&[1, 2])))),
        ("stimulus-of-neuron-2", "a stimulus of the second neuron of one", driven(drive().with("ids", ids(&[2])))),
        ("record-of-rate", "a record of the rate of spiking neurons", with(record("v", "rate", 1.0))),
        ("stimulus-of-rate", "an input to rate neurons for spiking ones", driven(stimulus("in", "rate_inject"))),
        (
            "potential-of-rate",
            "a record of the potential of rate neurons",
            Open { records: vec![v()], ..Open::rate("a") },
        ),
        (
            "potential-of-rate-by-default",
            "a record of rate neurons without an observable",
            Open { records: vec![v().without("observable")], ..Open::rate("a") },
        ),
    ];
    table
        .into_iter()
        .map(|(name, words, open)| {
            let trace = vec![
                (open.text(), any(vec![not_opened("a"), error()])),
                (step("a", Some(1.0), None), error()),
                (lif().text(), opened("a")),
            ];
            reference(format!("refused/{name}"), &["NCP-SESS-060"], trace)
                .title(format!("A session of {words} should not be opened."))
                .because("The backend should refuse to open a session that the network cannot be made of.")
        })
        .collect()
}

/// The request for a time.
type Request = fn(f64) -> String;

/// How many steps a time is, and that no request makes up for what another was rounded by.
fn durations() -> Vec<Case> {
    // The length of a step, the time that each of three requests asks for, and how many steps that is.
    let table: [(&str, f64, f64, u32); 12] = [
        ("half-of-an-even-number", 0.25, 0.625, 3),
        ("half-of-an-odd-number", 0.25, 0.375, 2),
        ("half-of-one", 0.25, 0.125, 1),
        ("more-than-half", 0.25, 0.45, 2),
        ("less-than-half", 0.25, 0.55, 2),
        ("less-than-half-of-one", 0.25, 0.1, 0),
        ("next-below-half-of-one", 1.0, 0.5_f64.next_down(), 0),
        ("tenths-down", 0.1, 0.24, 2),
        ("tenths-half", 0.1, 0.25, 3),
        ("tenths-whole", 0.1, 0.3, 3),
        ("tenths-next-to-half", 0.1, 0.15, 1),
        ("nothing", 1.0, 0.0, 0),
    ];
    let mut cases = Vec::new();
    for (name, dt, x, steps) in table {
        let open = |chunk| Open { dt, chunk, ..Open::lif("a") };
        let ways: [(&str, f64, Request); 3] = [
            ("step", 1.0, |x| step("a", Some(x), None)),
            ("run", 1.0, |x| run("a", x)),
            ("chunk", x, |_| step("a", None, None)),
        ];
        for (way, chunk, request) in ways {
            let mut trace = vec![(open(chunk).text(), opened("a"))];
            let reply = |nth: u32| {
                let observed = observed("a", f64::from(nth * steps) * dt);
                // Whether a step of 0 ms is refused is a server's own affair.
                if x == 0.0 { any(vec![observed, error()]) } else { observed }
            };
            trace.extend((1..=3).map(|nth| (request(x), reply(nth))));
            cases.push(
                reference(format!("duration/{name}/{way}"), &["NCP-SESS-058", "NCP-SESS-033"], trace)
                    .title(format!(
                        "With steps of {dt} ms, each of three times {x} ms ({way}) is {steps} steps ({}).",
                        name.replace('-', " ")
                    ))
                    .because(
                        "A time of x ms is round(x / dt) steps, the greater of two whole numbers that are equally \
                         near, and the time is the number of all steps times dt.",
                    ),
            );
        }
    }
    cases
}

/// In which order samples come: by their times, and those of one time as the port names its neurons.
fn orders() -> Vec<Case> {
    let of = |observable: &str, ids: &[u32]| {
        record("out", observable, 1.0).with("ids", ids.iter().copied().collect::<Json>())
    };
    let driven = |target: Json| Open { size: 3, params: vec![("I_e", 500.0)], records: vec![target], ..Open::lif("a") };
    let (_, _, beats) = simulate(&[("I_e", 500.0)], 1.0, 40, 500.0);
    let mut cases = Vec::new();
    let mut add = |name: String, words: &str, open: Open, request: String, times: Vec<f64>, senders: Vec<u32>| {
        let records = object! { "out" => sent(&times, &senders) };
        cases.push(
            reference(
                format!("order/{name}"),
                &["NCP-SESS-059"],
                vec![(open.text(), opened("a")), (request, recorded("a", records))],
            )
            .title(format!("Samples come in the order of their times, and at one time {words} ({name})."))
            .because(
                "The samples of an observation are in the order of their times, and those of one time in the order \
                 of the port's `ids`, or by id when it names none.",
            ),
        );
    };
    for ids in [&[3_u32, 1][..], &[2, 3, 1], &[]] {
        let named: &[u32] = if ids.is_empty() { &[1, 2, 3] } else { ids };
        let words = if ids.is_empty() { "by id" } else { "as the port names its neurons" };
        let name = named.iter().map(ToString::to_string).collect::<Vec<_>>().join("-");
        let name = if ids.is_empty() { "by-id".to_owned() } else { name };
        for (what, observable, at, advance) in
            [("potential", "V_m", &[1.0, 2.0, 3.0][..], 3.0), ("spikes", "spikes", &beats[..], 40.0)]
        {
            let times = at.iter().flat_map(|time| named.iter().map(|_| *time)).collect();
            let senders = at.iter().flat_map(|_| named.iter().copied()).collect();
            let request = step("a", Some(advance), None);
            add(format!("{what}/{name}"), words, driven(of(observable, ids)), request, times, senders);
        }
    }
    // More than one looks through for each sample.
    let many: Vec<u32> = (1..=70).rev().collect();
    for (what, observable, time) in [("potential", "V_m", Some(1.0)), ("spikes", "spikes", beats.first().copied())] {
        let Some(time) = time else { continue };
        let open = Open { size: 70, ..driven(of(observable, &many)) };
        let words = "as the port names its neurons";
        add(format!("{what}/70-to-1"), words, open, step("a", Some(time), None), vec![time; 70], many.clone());
    }
    // By id, as a number: the tenth comes behind the second.
    let all: Vec<u32> = (1..=12).collect();
    for (what, observable, at, advance) in
        [("potential", "V_m", &[1.0, 2.0][..], 2.0), ("spikes", "spikes", &beats[..], 40.0)]
    {
        let times = at.iter().flat_map(|time| all.iter().map(|_| *time)).collect();
        let senders = at.iter().flat_map(|_| all.iter().copied()).collect();
        let open = Open { size: 12, ..driven(of(observable, &[])) };
        add(format!("{what}/by-id-of-12"), "by id", open, step("a", Some(advance), None), times, senders);
    }
    // Neurons that spike at times of their own: the second is driven harder.
    let (_, _, fast) = simulate(&[("I_e", 900.0)], 1.0, 40, 900.0);
    for ids in [[1_u32, 2], [2, 1]] {
        let mut all: Vec<(f64, usize, u32)> = Vec::new();
        for (place, id) in ids.into_iter().enumerate() {
            all.extend(if id == 2 { &fast } else { &beats }.iter().map(|time| (*time, place, id)));
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let drive = object! { "port" => "in", "target" => "pop", "kind" => "current_pA",
        "ids" => std::iter::once(2_u32).collect::<Json>() };
        let open = Open { stimuli: vec![drive], ..driven(of("spikes", &ids)) };
        add(
            format!("spikes-apart/{}-{}", ids[0], ids[1]),
            "as the port names its neurons",
            open,
            step("a", Some(40.0), Some(("in", 400.0))),
            all.iter().map(|(time, ..)| *time).collect(),
            all.iter().map(|(.., id)| *id).collect(),
        );
    }
    cases
}

/// Two ports that name the same neurons, each in an order of its own.
fn orders_of_ports() -> Vec<Case> {
    let named = |port: &str, ids: &[u32]| record(port, "V_m", 1.0).with("ids", ids.iter().copied().collect::<Json>());
    let orders =
        [("apart", [1_u32, 2, 3], [3_u32, 1, 2]), ("turned", [3, 2, 1], [1, 2, 3]), ("ends", [1, 2, 3], [1, 3, 2])];
    let of = |(name, first, second): (&str, [u32; 3], [u32; 3])| {
        let times = [1.0, 1.0, 1.0, 2.0, 2.0, 2.0];
        let open = Open { size: 3, records: vec![named("a", &first), named("b", &second)], ..Open::lif("a") };
        let records = object! { "a" => sent(&times, &[first, first].concat()),
        "b" => sent(&times, &[second, second].concat()) };
        let trace = vec![(open.text(), opened("a")), (step("a", Some(2.0), None), recorded("a", records))];
        reference(format!("order/of-each-port/{name}"), &["NCP-SESS-059"], trace)
            .title(format!("Each of two ports names the same three neurons in an order of its own ({name})."))
            .because("The samples of one time are in the order of the port's `ids`.")
    };
    orders.map(of).into()
}

/// When a port is sampled, whatever the samples are.
fn cadences() -> Vec<Case> {
    let at = |times: &[f64]| recorded("a", object! { "v" => object! { "times" => nums(times) } });
    let multiples = |cadence: f64, from: f64, to: f64| -> Vec<f64> {
        (1_u32..)
            .map(|nth| f64::from(nth) * cadence)
            .skip_while(|time| *time <= from)
            .take_while(|time| *time <= to)
            .collect()
    };
    let open = |dt: f64, cadence: f64| {
        let open = Open { records: vec![record("v", "V_m", cadence)], dt, ..Open::lif("a") };
        (open.text(), opened("a"))
    };
    let mut cases = Vec::new();
    // Half-way between two numbers of steps, which doubles hold: the greater one.
    for (dt, cadence, rounded) in [(1.0, 0.5, 1.0), (1.0, 2.5, 3.0), (1.0, 4.5, 5.0), (2.0, 5.0, 6.0), (0.5, 0.25, 0.5)]
    {
        cases.push(
            reference(
                format!("cadence/half/{cadence}-by-{dt}"),
                &["NCP-SESS-053"],
                vec![open(dt, cadence), (step("a", Some(20.0), None), at(&multiples(rounded, 0.0, 20.0)))],
            )
            .title(format!("In steps of {dt} ms a port of a cadence of {cadence} ms is sampled every {rounded} ms."))
            .because("*round* gives the greater of two whole numbers that are equally near."),
        );
    }
    for (dt, cadence) in [(1.0, 1.0), (1.0, 2.0), (0.5, 1.0), (0.25, 5.0), (1.0, 5.0), (1.0, 7.0)] {
        cases.push(
            reference(
                format!("cadence/{cadence}-by-{dt}"),
                &["NCP-SESS-053"],
                vec![open(dt, cadence), (step("a", Some(20.0), None), at(&multiples(cadence, 0.0, 20.0)))],
            )
            .title(format!("A port of a cadence of {cadence} ms is sampled at its multiples, in steps of {dt} ms."))
            .because(
                "The backend samples a port at every multiple of its `cadence_ms`, from the first after the \
                      session opened.",
            ),
        );
    }
    for (cadence, advance) in [(2.0, 3.0), (5.0, 4.0)] {
        let mut trace = vec![open(1.0, cadence)];
        trace.extend((0..4_u32).map(|nth| {
            let from = f64::from(nth) * advance;
            (step("a", Some(advance), None), at(&multiples(cadence, from, from + advance)))
        }));
        let name = if cadence == 2.0 { "over-requests".to_owned() } else { format!("over-requests-of-{advance}") };
        cases.push(
            reference(format!("cadence/{name}"), &["NCP-SESS-053"], trace)
                .title("A port is sampled at multiples of its cadence since the session opened, not since the request.")
                .because(
                    "The backend samples a port at every multiple of its `cadence_ms`, from the first after \
                          the session opened.",
                ),
        );
    }
    cases
}

/// What all ports give a neuron, and its own current: they add up, and none stands for another.
fn sums() -> Vec<Case> {
    // What the neuron has of its own, and what two ports give it in each of two requests.
    type Inputs = [[Option<f64>; 2]; 2];
    let table: [(&str, f64, Inputs); 10] = [
        ("bias-and-current", 100.0, [[Some(50.0), None], [None, None]]),
        ("bias-and-a-late-current", 100.0, [[None, None], [Some(50.0), None]]),
        ("bias-against-current", 300.0, [[Some(-300.0), None], [None, None]]),
        ("bias-and-nothing", 300.0, [[Some(0.0), None], [None, None]]),
        ("bias-behind-a-current", 200.0, [[Some(150.0), None], [Some(0.0), None]]),
        ("bias-below-current", -200.0, [[Some(700.0), None], [None, None]]),
        ("two-currents", 0.0, [[Some(100.0), Some(50.0)], [None, None]]),
        ("two-currents-and-bias", 25.0, [[Some(100.0), Some(50.0)], [None, Some(-60.0)]]),
        ("two-currents-in-turn", 25.0, [[Some(100.0), None], [None, Some(50.0)]]),
        ("a-huge-current-that-ends", 0.0, [[Some(1e17), Some(250.0)], [Some(0.0), None]]),
    ];
    let both = |kind: &str| vec![stimulus("in", kind), stimulus("also", kind)];
    let mut cases = Vec::new();
    for (name, own, inputs) in table {
        let lif = Open {
            params: vec![("I_e", own)],
            records: vec![record("out", "V_m", 4.0)],
            stimuli: both("current_pA"),
            ..Open::lif("a")
        };
        let rate = Open {
            params: vec![("mu", own)],
            records: vec![record("out", "rate", 4.0)],
            stimuli: both("rate_inject"),
            ..Open::rate("a")
        };
        for (network, rule, open) in [("lif", "NCP-SESS-050", lif), ("rate", "NCP-SESS-051", rate)] {
            if network == "rate" && !name.starts_with("two") && name != "bias-against-current" {
                continue;
            }
            let (mut neuron, mut r, mut time, mut now) = (Lif::new(&[], 1.0), 0.0, 0.0, [0.0; 2]);
            let propagator = (-1.0_f64 / 10.0).exp();
            let mut trace = vec![(open.text(), opened("a"))];
            for values in inputs {
                for (now, value) in now.iter_mut().zip(values) {
                    *now = value.unwrap_or(*now);
                }
                let all = own + now[0] + now[1];
                let (mut times, mut samples_of) = (Vec::new(), Vec::new());
                for nth in 1..=8 {
                    neuron.step(all);
                    r = r * propagator + all * (1.0 - propagator);
                    time += 1.0;
                    if nth % 4 == 0 {
                        times.push(time);
                        samples_of.push(if network == "lif" { neuron.v } else { r });
                    }
                }
                let given: Vec<(&str, f64)> =
                    ["in", "also"].into_iter().zip(values).filter_map(|(port, value)| Some((port, value?))).collect();
                let records = object! { "out" => samples(&times, Some(&samples_of)) };
                trace.push((driven_step("a", 8.0, &given), recorded("a", records)));
            }
            let rules = match name {
                // The value that ends leaves nothing of itself behind.
                "a-huge-current-that-ends" => vec!["NCP-SESS-054", rule],
                _ if name.contains("late") || name.contains("turn") => vec![rule, "NCP-SESS-054"],
                _ => vec![rule],
            };
            cases.push(
                reference(format!("sum/{name}/{network}"), &rules, trace)
                    .title(format!(
                        "What a neuron has of its own and what its ports give it add up ({}, {network}).",
                        name.replace('-', " ")
                    ))
                    .because(WHY),
            );
        }
    }
    cases
}

/// A step with values for several ports.
pub(super) fn driven_step(id: &str, advance: f64, values: &[(&str, f64)]) -> String {
    let request = Json::read(&step(id, Some(advance), None));
    if values.is_empty() {
        return request.text();
    }
    let value = |(port, value): &(&str, f64)| ((*port).to_owned(), object! { "data" => nums(&[*value]) });
    let values = Json::Object(values.iter().map(value).collect());
    request.with("stimulus", object! { "values" => values }).text()
}

/// Steps and neurons beyond the ends of small integers.
fn far() -> Vec<Case> {
    let mut cases = far_times();
    cases.push(many_samples());
    cases.extend(far_samples());
    cases.extend(far_spikes());
    cases.push(many_spikes());
    cases.extend(far_neurons());
    cases
}

/// The time of sessions that run for long, in one request and in many.
fn far_times() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, dt, parts) in [
        ("66000", 1.0, &[66_000.0][..]),
        ("140000", 1.0, &[140_000.0]),
        ("over-requests", 1.0, &[30_000.0, 30_000.0, 30_000.0, 50_000.0, 7.0]),
        ("behind-many", 1.0, &[70_000.0, 1.0, 2.0]),
        ("forty-quarters", 0.25, &[0.25; 40]),
    ] {
        let open = Open { dt, ..Open::lif("a") };
        let mut trace = vec![(open.text(), opened("a"))];
        let mut time = 0.0;
        for part in parts {
            time += part;
            trace.push((run("a", *part), observed("a", time)));
        }
        cases.push(
            reference(format!("far/time/{name}"), &["NCP-SESS-058", "NCP-SESS-033"], trace)
                .title(format!("A session that has run for {time} ms, in {} requests, says so.", parts.len()))
                .because("The time of a session is the number of all steps since it opened, times dt."),
        );
    }
    cases
}

/// What a server bears in a request, over and over: it is bounded by the request, and not by the session.
fn many_samples() -> Case {
    let records = vec![record("s", "spikes", 1.0)];
    let open = Open { records, size: 100_000, ..Open::lif("a") };
    let mut trace = vec![(open.text(), opened("a"))];
    trace.extend((1..=12).map(|step| (run("a", 1.0), observed("a", f64::from(step)))));
    reference("far/samples/of-many-requests".to_owned(), &["NCP-SESS-027"], trace)
        .title("Twelve requests that may give 100,000 spikes each are answered, one after the other.")
        .because("A server bears a million samples in each request.")
}

/// Ports that are sampled rarely, in sessions that run for long.
fn far_samples() -> Vec<Case> {
    let at = |port: &str, times: &[f64]| object! { port => object! { "times" => nums(times) } };
    let multiples = |every: u32, from: u32, to: u32, dt: f64| -> Vec<f64> {
        (from + 1..=to).filter(|step| step % every == 0).map(|step| f64::from(step) * dt).collect()
    };
    let why = "The backend samples a port at the end of every step whose number since the session opened is a \
               multiple of its cadence, however many steps that is.";
    let mut cases = Vec::new();
    // Cadences in steps, and how many steps a single request runs.
    let table: [(u32, u32); 12] = [
        (100, 1_000),
        (255, 1_100),
        (256, 1_100),
        (257, 1_100),
        (1_000, 10_500),
        (10_000, 45_000),
        (30_000, 66_000),
        (40_000, 90_000),
        (65_535, 131_100),
        (65_536, 131_100),
        (65_537, 131_100),
        (100_000, 210_000),
    ];
    let ports = |observable: &str, every: u32, dt: f64| vec![record("out", observable, f64::from(every) * dt)];
    for (every, steps) in table {
        let open = Open { records: ports("V_m", every, 1.0), ..Open::lif("a") };
        let times = multiples(every, 0, steps, 1.0);
        cases.push(
            reference(
                format!("far/cadence/{every}-of-{steps}"),
                &["NCP-SESS-053"],
                vec![(open.text(), opened("a")), (run("a", f64::from(steps)), recorded("a", at("out", &times)))],
            )
            .title(format!("A port of a cadence of {every} steps is sampled {} times in {steps} steps.", times.len()))
            .because(why),
        );
    }
    for (name, observable, every, dt) in
        [("rate", "rate", 30_000, 1.0), ("quarter-steps", "V_m", 28_000, 0.25), ("tenth-steps", "V_m", 30_000, 0.1)]
    {
        let ground = if observable == "rate" { Open::rate("a") } else { Open::lif("a") };
        let open = Open { records: ports(observable, every, dt), dt, ..ground };
        // Over three requests.
        let mut trace = vec![(open.text(), opened("a"))];
        for (from, to) in [(0, 25_000), (25_000, 61_000), (61_000, 95_000)] {
            let times = multiples(every, from, to, dt);
            trace.push((run("a", f64::from(to - from) * dt), recorded("a", at("out", &times))));
        }
        cases.push(
            reference(format!("far/cadence/over-requests/{name}"), &["NCP-SESS-053"], trace)
                .title(format!(
                    "A port of a cadence of {every} steps is sampled at its multiples over 95,000 steps of three \
                     requests ({}).",
                    name.replace('-', " ")
                ))
                .because(why),
        );
    }
    // Two ports, each by its own cadence.
    let records = vec![record("often", "V_m", 21_000.0), record("rarely", "V_m", 65_537.0)];
    let open = Open { records, ..Open::lif("a") };
    let both = object! {
        "often" => object! { "times" => nums(&multiples(21_000, 0, 70_000, 1.0)) },
        "rarely" => object! { "times" => nums(&multiples(65_537, 0, 70_000, 1.0)) },
    };
    cases.push(
        reference(
            "far/cadence/two-ports".to_owned(),
            &["NCP-SESS-053"],
            vec![(open.text(), opened("a")), (run("a", 70_000.0), recorded("a", both))],
        )
        .title("Two ports are sampled each by its own cadence over 70,000 steps.")
        .because(why),
    );
    for (name, dt) in [("whole", 1.0), ("eighths", 0.125)] {
        let open = Open { dt, ..Open::lif("a") };
        let mut trace = vec![(open.text(), opened("a"))];
        let mut steps = 0.0;
        for more in [32_767.0, 1.0, 1.0, 32_766.0, 1.0, 1.0, 65_535.0, 2.0] {
            steps += more;
            trace.push((run("a", more * dt), observed("a", steps * dt)));
        }
        cases.push(
            reference(format!("far/time/{name}"), &["NCP-SESS-058", "NCP-SESS-033"], trace)
                .title(format!(
                    "The time is the number of all steps times dt, also beyond 2^15, 2^16 and 2^17 ({name})."
                ))
                .because("The backend reports the number of all steps since the session opened, times dt."),
        );
    }
    cases
}

/// Spikes that come late, and neurons that rest for long.
fn far_spikes() -> Vec<Case> {
    let mut cases = Vec::new();
    let open = Open {
        records: vec![record("s", "spikes", 1.0)],
        stimuli: vec![stimulus("in", "current_pA")],
        ..Open::lif("a")
    };
    for quiet in [255_u32, 32_760, 65_530, 131_065] {
        let (_, _, spikes) = simulate(&[], 1.0, 40, 900.0);
        let times: Vec<f64> = spikes.iter().map(|time| f64::from(quiet) + time).collect();
        let trace = vec![
            (open.text(), opened("a")),
            (run("a", f64::from(quiet)), recorded("a", object! { "s" => samples(&[], None) })),
            (step("a", Some(40.0), Some(("in", 900.0))), recorded("a", object! { "s" => samples(&times, None) })),
        ];
        cases.push(
            reference(format!("far/spikes/behind-{quiet}"), &["NCP-SESS-050", "NCP-SESS-033"], trace)
                .title(format!("A neuron that is driven after {quiet} quiet steps spikes at times from there on."))
                .because(WHY),
        );
    }
    for (name, rest, steps) in [
        ("255", 255.0, 600_u32),
        ("256", 256.0, 600),
        ("257", 257.0, 600),
        ("1000", 1000.0, 2_100),
        ("70000", 70_000.0, 71_000),
        ("2-to-31", 2_147_483_648.0, 20),
        ("2-to-32-and-2", 4_294_967_298.0, 20),
        ("1e300", 1e300, 20),
    ] {
        let params = vec![("t_ref", rest), ("I_e", 2000.0)];
        let (_, _, spikes) = simulate(&params, 1.0, steps, 2000.0);
        let open = Open { params, records: vec![record("s", "spikes", 1.0)], ..Open::lif("a") };
        let expected = recorded("a", object! { "s" => samples(&spikes, None) });
        cases.push(
            reference(
                format!("far/rest/{name}"),
                &["NCP-SESS-050"],
                vec![(open.text(), opened("a")), (run("a", f64::from(steps)), expected)],
            )
            .title(format!(
                "A neuron that rests for {rest:?} ms of 1 ms steps spikes {} times in {steps}.",
                spikes.len()
            ))
            .because(WHY),
        );
    }
    cases
}

/// Spikes of thousands of neurons in one request, at each of its steps.
fn many_spikes() -> Case {
    let (size, steps) = (10_000_u32, 3);
    let params = vec![("t_ref", 0.0), ("I_e", 50_000.0)];
    let (_, _, spikes) = simulate(&params, 1.0, steps, 50_000.0);
    let open = Open { size, params, records: vec![record("s", "spikes", 1.0)], ..Open::lif("a") };
    let times: Vec<f64> = spikes.iter().flat_map(|time| std::iter::repeat_n(*time, size as usize)).collect();
    let records = object! { "s" => samples(&times, None) };
    let trace = vec![(open.text(), opened("a")), (run("a", f64::from(steps)), recorded("a", records))];
    reference(format!("far/spikes/{}-of-{size}", times.len()), &["NCP-SESS-050", "NCP-SESS-038"], trace)
        .title(format!("All {} spikes of {size} neurons in {steps} steps of one request are recorded.", times.len()))
        .because("A spike is recorded when it occurs; a server bears a million samples in each request.")
}

/// Neurons whose ids do not fit a small integer: none stands for another.
fn far_neurons() -> Vec<Case> {
    let mut cases = Vec::new();
    let ids = |of: &[u32]| of.iter().copied().collect::<Json>();
    let (_, driven, _) = simulate(&[], 1.0, 3, 300.0);
    let driven = driven.last().copied().unwrap_or_default();
    for (size, driven_id) in [(300_u32, 257_u32), (300, 300), (1_100, 1_025), (66_000, 65_537), (66_000, 66_000)] {
        // What the id is in 8 and in 16 bits, if it is an id at all.
        let others = [driven_id % 256, driven_id % 65_536, driven_id - 1, 1];
        let mut recorded_ids = vec![driven_id];
        for other in others {
            if other > 0 && !recorded_ids.contains(&other) {
                recorded_ids.push(other);
            }
        }
        let open = Open {
            size,
            records: vec![record("v", "V_m", 3.0).with("ids", ids(&recorded_ids))],
            stimuli: vec![stimulus("in", "current_pA").with("ids", ids(&[driven_id]))],
            ..Open::lif("a")
        };
        let values: Vec<f64> = recorded_ids.iter().map(|id| if *id == driven_id { driven } else { -70.0 }).collect();
        let records = object! { "v" => object! { "senders" => ids(&recorded_ids), "values" => nums(&values) } };
        let trace =
            vec![(open.text(), opened("a")), (step("a", Some(3.0), Some(("in", 300.0))), recorded("a", records))];
        cases.push(
            reference(format!("far/neuron/{driven_id}-of-{size}"), &["NCP-SESS-055", "NCP-SESS-052"], trace)
                .title(format!("Of {size} neurons number {driven_id} is driven, and no other."))
                .because(
                    "A neuron's id is its position within its population, and a stimulus reaches those that its \
                     `ids` name and no others.",
                ),
        );
    }
    cases
}

/// Steps so small beside the time constant that 1 − P, as a difference of doubles, has lost its digits.
fn slow() -> Vec<Case> {
    const WHY: &str = "The formulas are those of real numbers, and hold to a relative error of 1e-9: 1 \u{2212} P has \
                       its nine digits where the step is small beside the time constant, too.";
    // With constant input, all steps together are one: what a network comes to from 0 has a closed form.
    let rise = |steps: u32, ratio: f64| -(-f64::from(steps) * ratio).exp_m1();
    let mut cases = Vec::new();
    for (name, dt, tau) in
        [("1e-8", 1.0, 1e8), ("1e-9", 1.0, 1e9), ("1e-10", 0.125, 1.25e9), ("1e-12", 1.0, 1e12), ("1e-18", 1.0, 1e18)]
    {
        for steps in [1_u32, 10] {
            let advance = f64::from(steps) * dt;
            let lif = Open {
                params: vec![
                    ("tau_m", tau),
                    ("C_m", tau),
                    ("E_L", 0.0),
                    ("V_reset", 0.0),
                    ("V_th", 1e300),
                    ("I_e", 3e18),
                ],
                records: vec![record("out", "V_m", advance)],
                dt,
                ..Open::lif("a")
            };
            let rate = Open {
                params: vec![("tau", tau), ("mu", 3e18)],
                records: vec![record("out", "rate", advance)],
                dt,
                ..Open::rate("a")
            };
            for (network, rule, open) in [("lif", "NCP-SESS-050", lif), ("rate", "NCP-SESS-051", rate)] {
                let value = 3e18 * rise(steps, dt / tau);
                let records = object! { "out" => samples(&[advance], Some(&[value])) };
                let trace = vec![(open.text(), opened("a")), (step("a", Some(advance), None), recorded("a", records))];
                cases.push(
                    reference(format!("slow/{name}-by-{steps}/{network}"), &[rule], trace)
                        .title(format!(
                            "A neuron ({network}) whose time constant is {tau:e} ms is integrated by {steps} steps of \
                             {dt} ms."
                        ))
                        .because(WHY),
                );
            }
        }
    }
    cases
}

/// Sessions side by side that differ in one number alone, and in that by little.
fn near() -> Vec<Case> {
    // A small difference shows where all is proportional to what differs.
    let lif = [("E_L", 0.0), ("V_th", 1e9), ("I_e", 3.0), ("C_m", 5.0), ("tau_m", 2.0)];
    let resting = [("I_e", 150.0), ("E_L", 0.0), ("V_th", 2.0), ("V_reset", 1.0), ("t_ref", 2.0)];
    // A potential of exactly 15 in one step, as in `thresholds`.
    let exact = [("tau_m", 1.0 / 1024.0), ("C_m", 1.0), ("I_e", 15.0 * 1024.0), ("E_L", 0.0), ("V_reset", -10.0)];
    let rate = [("mu", 3.0), ("tau", 2.0)];
    let little = |x: f64| x * (1.0 + 4e-8);
    type Row<'a> = (&'static str, &'static str, &'a [(&'static str, f64)], f64, f64);
    let table: [Row<'_>; 12] = [
        ("current", "I_e", &lif, 3.0, little(3.0)),
        ("current-of-six-digits", "I_e", &lif, 123_456.0, 123_456.4),
        ("capacity", "C_m", &lif, 5.0, little(5.0)),
        ("time-constant", "tau_m", &lif, 2.0, little(2.0)),
        ("leak", "E_L", &lif, 1.0, little(1.0)),
        ("reset", "V_reset", &resting, 1.0, little(1.0)),
        ("threshold", "V_th", &exact, 15.0, 15.0_f64.next_up()),
        ("rest", "t_ref", &resting, 2.5, 2.5_f64.next_down()),
        ("mean-of-rate", "mu", &rate, 3.0, little(3.0)),
        ("mean-of-rate-of-six-digits", "mu", &rate, 123_456.0, 123_456.4),
        ("time-constant-of-rate", "tau", &rate, 2.0, little(2.0)),
        ("sign-of-current", "I_e", &lif, 3.0, -3.0),
    ];
    let mut cases = Vec::new();
    for (name, param, ground, one, other) in table {
        let of_rate = name.contains("of-rate");
        // Until it has spiked, rested and gone on.
        let steps: u32 = if name == "rest" { 12 } else { 6 };
        let open = |id: &str, value: f64| {
            let mut params: Params = ground.iter().copied().filter(|(known, _)| *known != param).collect();
            params.push((param, value));
            let observable = if of_rate { "rate" } else { "V_m" };
            let network = if of_rate { Open::rate(id) } else { Open::lif(id) };
            // The last sample alone, which all before it decide.
            Open { params, records: vec![record("out", observable, f64::from(steps))], ..network }
        };
        let values = |value: f64| -> Json {
            let params = open("a", value).params;
            let param = |wanted: &str| params.iter().find(|(known, _)| *known == wanted).map_or(0.0, |(_, x)| *x);
            let times: Vec<f64> = (1..=steps).map(f64::from).collect();
            let values: Vec<f64> = if of_rate {
                let propagator = (-1.0 / param("tau")).exp();
                let next = |r: &mut f64, _: &f64| {
                    *r = *r * propagator + param("mu") * (1.0 - propagator);
                    Some(*r)
                };
                times.iter().scan(0.0, next).collect()
            } else {
                simulate(&params, 1.0, steps, param("I_e")).1
            };
            let last = |all: &[f64]| all.last().copied().unwrap_or_default();
            object! { "out" => samples(&[last(&times)], Some(&[last(&values)])) }
        };
        let trace = |first: f64, second: f64| {
            vec![
                (open("a", first).text(), opened("a")),
                (open("b", second).text(), opened("b")),
                (step("a", Some(f64::from(steps)), None), recorded("a", values(first))),
                (step("b", Some(f64::from(steps)), None), recorded("b", values(second))),
            ]
        };
        let rule = if of_rate { "NCP-SESS-051" } else { "NCP-SESS-050" };
        for (order, first, second) in [("in-order", one, other), ("reversed", other, one)] {
            if order == "reversed" && !matches!(name, "current" | "threshold") {
                continue;
            }
            cases.push(
                reference(format!("near/{name}/{order}"), &[rule, "NCP-SESS-035"], trace(first, second))
                    .title(format!(
                        "Two sessions whose `{param}` is {first:?} and {second:?} are integrated each by its own ({}).",
                        name.replace('-', " ")
                    ))
                    .because(
                        "What is done to one session changes no other, and each is integrated by its own numbers, \
                         however little they differ.",
                    ),
            );
        }
    }
    // The same by the length of a step, and by the size of the population.
    for (name, one, other) in [("step", 1.0, little(1.0)), ("short-step", 0.001, little(0.001))] {
        let open = |id: &str, dt: f64| Open {
            params: vec![("E_L", 0.0), ("V_th", 1e9), ("I_e", 30_000.0)],
            records: vec![record("out", "V_m", dt)],
            dt,
            chunk: 4.0 * dt,
            ..Open::lif(id)
        };
        let values = |dt: f64| {
            let params = open("a", dt).params;
            let (times, values, _) = simulate(&params, dt, 4, 30_000.0);
            object! { "out" => samples(&times, Some(&values)) }
        };
        let trace = vec![
            (open("a", one).text(), opened("a")),
            (open("b", other).text(), opened("b")),
            (step("a", None, None), recorded("a", values(one))),
            (step("b", None, None), recorded("b", values(other))),
        ];
        cases.push(
            reference(format!("near/{name}"), &["NCP-SESS-050", "NCP-SESS-035"], trace)
                .title(format!(
                    "Two sessions whose steps are {one:?} and {other:?} ms long are integrated each by its own."
                ))
                .because("What is done to one session changes no other."),
        );
    }
    let sized = |id: &str, size: u32| Open { size, records: vec![record("out", "V_m", 1.0)], ..Open::lif(id) };
    let of = |size: u32| {
        let senders: Vec<u32> = (1..=size).collect();
        object! { "out" => sent(&vec![1.0; senders.len()], &senders) }
    };
    let mut trace = Vec::new();
    for (id, size) in [("a", 1), ("b", 3), ("c", 2)] {
        trace.push((sized(id, size).text(), opened(id)));
    }
    for (id, size) in [("a", 1), ("b", 3), ("c", 2)] {
        trace.push((step(id, Some(1.0), None), recorded(id, of(size))));
    }
    cases.push(
        reference("near/size".to_owned(), &["NCP-SESS-035", "NCP-SESS-052"], trace)
            .title("Three sessions that differ in the size of their population alone have each its own neurons.")
            .because("What is done to one session changes no other."),
    );
    cases
}

/// Names that are the same when they are written together, or that look alike: each is itself.
fn alike() -> Vec<Case> {
    let ids = |of: &[u32]| of.iter().copied().collect::<Json>();
    let after = |current: f64| simulate(&[], 1.0, 5, current).1.last().copied().unwrap_or_default();
    let mut cases = Vec::new();
    // A session and its port.
    let long = |last: &str, bytes: usize| "n".repeat(bytes - 1) + last;
    let (one, other) = (long("1", 256), long("2", 256));
    let (in_one, in_other) = (long("1", 300), long("2", 300));
    let table: [(&str, [(&str, &str); 2]); 6] = [
        ("long-sessions", [(&one, "in"), (&other, "in")]),
        ("long-ports", [("s", &in_one), ("t", &in_other)]),
        ("session-and-port", [("s1", "1in"), ("s", "11in")]),
        ("port-and-session", [("1s", "in1"), ("s", "in11")]),
        ("session-and-port-by-a-hyphen", [("s-a", "in"), ("s", "a-in")]),
        ("session-and-port-by-a-dot", [("s.a", "in"), ("s", "a.in")]),
    ];
    for (name, pairs) in table {
        let mut trace = Vec::new();
        for (session, port) in pairs {
            let stimuli = vec![stimulus(port, "current_pA")];
            let open = Open { records: vec![record("v", "V_m", 5.0)], stimuli, ..Open::lif(session) };
            trace.push((open.text(), opened(session)));
        }
        let value = |current: f64| object! { "v" => samples(&[5.0], Some(&[after(current)])) };
        let [(driven, port), (other, _)] = pairs;
        trace.push((step(driven, Some(5.0), Some((port, 300.0))), recorded(driven, value(300.0))));
        trace.push((step(other, Some(5.0), None), recorded(other, value(0.0))));
        cases.push(
            reference(format!("alike/{name}"), &["NCP-SESS-035", "NCP-SESS-054"], trace)
                .title(if name.starts_with("long") {
                    format!(
                        "A current into one of two {} that begin alike does not reach the other.",
                        name.replace('-', " ")
                    )
                } else {
                    format!(
                        "A current into the port `{port}` of the session `{driven}` does not reach `{other}` ({}).",
                        name.replace('-', " ")
                    )
                })
                .because("What is done to one session changes no other, whatever they and their ports are called."),
        );
    }
    // A population and its neuron, and populations and ports whose names are alike.
    let of = |port: &str, target: &str, id: u32| {
        record(port, "V_m", 5.0).with("target", target.into()).with("ids", ids(&[id]))
    };
    type Row<'a> = (&'static str, &'static [(&'static str, u32)], [(&'static str, u32); 2], &'a str);
    let table: [Row<'_>; 6] = [
        ("population-and-neuron", &[("a", 11), ("a1", 1)], [("a1", 1), ("a", 11)], "NCP-SESS-055"),
        ("neuron-and-population", &[("a", 11), ("1a", 1)], [("1a", 1), ("a", 11)], "NCP-SESS-055"),
        ("cases", &[("pop", 1), ("Pop", 1)], [("Pop", 1), ("pop", 1)], "NCP-SESS-055"),
        ("space", &[("pop", 1), ("pop ", 1)], [("pop ", 1), ("pop", 1)], "NCP-SESS-055"),
        ("composed", &[("\u{e9}", 1), ("e\u{301}", 1)], [("e\u{301}", 1), ("\u{e9}", 1)], "NCP-SESS-055"),
        (
            "beginning",
            &[("population_1", 1), ("population_12", 1)],
            [("population_12", 1), ("population_1", 1)],
            "NCP-SESS-055",
        ),
    ];
    for (name, sizes, [driven, other], rule) in table {
        let sizes: Json = Json::Object(sizes.iter().map(|(name, size)| ((*name).to_owned(), (*size).into())).collect());
        let open = Open {
            records: vec![of("v", driven.0, driven.1), of("w", other.0, other.1)],
            stimuli: vec![
                stimulus("in", "current_pA").with("target", driven.0.into()).with("ids", ids(&[driven.1])),
                stimulus("IN", "current_pA").with("target", other.0.into()).with("ids", ids(&[other.1])),
            ],
            ..Open::lif("a")
        };
        let text = open.json().edit(&["network", "population_sizes"], |_| sizes).text();
        let records = object! {
            "v" => object! { "values" => nums(&[after(300.0)]) },
            "w" => object! { "values" => nums(&[after(0.0)]) },
        };
        let trace = vec![(text, opened("a")), (step("a", Some(5.0), Some(("in", 300.0))), recorded("a", records))];
        cases.push(
            reference(format!("alike/{name}"), &[rule], trace)
                .title(format!(
                    "A current into neuron {} of `{}` does not reach neuron {} of `{}`.",
                    driven.1, driven.0, other.1, other.0
                ))
                .because(
                    "A stimulus reaches the neurons of its target that its `ids` name, and no others, whatever they \
                     are called.",
                ),
        );
    }
    cases
}

/// Cadences of more steps than 32 bits count.
fn beyond_32_bits() -> Vec<Case> {
    [("2-to-32-and-2", 4_294_967_298.0), ("1e300", 1e300)]
        .into_iter()
        .map(|(name, steps)| {
            let open = Open { records: vec![record("v", "V_m", steps)], ..Open::lif("a") };
            let expected = recorded("a", object! { "v" => samples(&[], None) });
            reference(
                format!("far/cadence/{name}"),
                &["NCP-SESS-053"],
                vec![(open.text(), opened("a")), (step("a", Some(20.0), None), expected)],
            )
            .title(format!("A port of a cadence of {} steps is not sampled in 20.", name.replace('-', " ")))
            .because("A port is sampled at the end of every step whose number is a multiple of its cadence.")
        })
        .collect()
}

/// An observation of the session at a time, with these records.
fn recorded_at(id: &str, time: f64, records: Json) -> Json {
    observed(id, time).edit(&["$json"], |reply| reply.with("records", records))
}

/// What a server bears in one request, and what it may refuse.
fn much_at_once() -> Vec<Case> {
    let mut cases = Vec::new();
    // Few samples, although many ports might have had one at each of many steps.
    let names: Vec<String> = (0..10).map(|nth| format!("p{nth}")).collect();
    let (size, steps, every) = (10_u32, 12_000_u32, 4_000_u32);
    let records = names.iter().map(|name| record(name, "V_m", f64::from(every))).collect();
    let open = Open { size, records, ..Open::lif("a") };
    let times: Vec<f64> =
        (1..=steps / every).flat_map(|nth| std::iter::repeat_n(f64::from(nth * every), size as usize)).collect();
    let records = object! { "p9" => object! { "times" => nums(&times) } };
    let trace =
        vec![(open.text(), opened("a")), (run("a", f64::from(steps)), recorded_at("a", f64::from(steps), records))];
    cases.push(
        reference("far/samples/of-rare-ports".to_owned(), &["NCP-SESS-027", "NCP-SESS-053"], trace)
            .by("/replies/1/records", "NCP-SESS-053")
            .title(format!(
                "A run of {steps} steps in which ten ports of {size} neurons are sampled every {every} steps is \
                 answered."
            ))
            .because("A server bears a million samples in each request, and a sample is one by the cadence."),
    );
    // Many steps of many neurons, and a port of spikes that counts as one that samples at each of them.
    let quiet = vec![record("s", "spikes", 1.0)];
    let table: [(&str, u32, u32, Vec<Json>, &str); 3] = [
        ("neuron-steps/of-100000", 100_000, 11, Vec::new(), "20,000,000 neurons times steps"),
        ("neuron-steps/of-1000", 1_000, 1_100, Vec::new(), "20,000,000 neurons times steps"),
        ("samples/of-quiet-neurons", 100, 9_900, quiet, "1,000,000 samples, of spikes one a neuron and step,"),
    ];
    for (name, size, steps, records, what) in table {
        let open = Open { size, records, ..Open::lif("a") };
        let time = f64::from(steps);
        let trace = vec![(open.text(), opened("a")), (run("a", time), observed("a", time))];
        cases.push(
            reference(format!("far/{name}"), &["NCP-SESS-027", "NCP-SESS-033"], trace)
                .title(format!("A run of {steps} steps of {size} neurons is answered ({}).", name.replace('/', ", ")))
                .because(format!("A server bears up to {what} in each request.")),
        );
    }
    // A reply of more than 1 MiB, which is what an observation may have.
    let open =
        Open { size: 10_000, params: vec![("I_e", 123.4)], records: vec![record("v", "V_m", 1.0)], ..Open::lif("a") };
    let times: Vec<f64> = (1..=6).flat_map(|nth| std::iter::repeat_n(f64::from(nth), 10_000)).collect();
    let trace = vec![
        (open.text(), opened("a")),
        (step("a", Some(6.0), None), recorded_at("a", 6.0, object! { "v" => object! { "times" => nums(&times) } })),
        (step("a", Some(1.0), None), observed("a", 7.0)),
    ];
    cases.push(
        reference("far/samples/of-more-than-1-mib".to_owned(), &["NCP-SESS-027", "NCP-SESS-053"], trace)
            .by("/replies/1/records", "NCP-SESS-053")
            .title("A step of 60,000 samples, whose reply is longer than 1 MiB, is answered with all of them.")
            .because("A server bears a million samples in each request, and an `observation_frame` has up to 64 MiB."),
    );
    // More than a server has to bear.
    let records = names.iter().map(|name| record(name, "V_m", 1.0)).collect();
    let open = Open { size: 100, records, ..Open::lif("a") };
    let of = |first: Json, time: f64| {
        vec![
            (open.text(), opened("a")),
            (step("a", Some(1_100.0), None), first),
            (step("a", Some(1.0), None), observed("a", time)),
        ]
    };
    let answers = |trace: Vec<(String, Json)>| super::replies(trace.into_iter().map(|(_, reply)| reply).collect());
    let (refused, served) = (of(error(), 1.0), of(observed("a", 1_100.0), 1_101.0));
    let expected = any(vec![answers(refused.clone()), answers(served)]);
    let mut case =
        reference("far/samples/too-many".to_owned(), &["NCP-SESS-037", "NCP-SESS-033"], refused).shows(expected);
    case.by.remove("/replies/*/sim_time_ms");
    cases.push(
        case.title("A step of more samples than a server has to bear is answered, or costs that request only.")
            .because("A server may refuse what is larger, with an error frame that leaves the session as it was."),
    );
    cases
}

/// Populations of no neuron, and sessions without neurons.
fn no_neurons() -> Vec<Case> {
    const WHY: &str = "A population of 0 neurons is one; only a negative size is left open.";
    let of = |open: Open, observable: &str, kind: &str, first: f64| {
        let target = |of: Json| of.with("target", "other".into());
        let open = Open {
            other: Some(0),
            records: vec![record("v", observable, 1.0), target(record("w", observable, 1.0))],
            stimuli: vec![target(stimulus("in", kind))],
            ..open
        };
        let none = || object! { "times" => nums(&[]), "values" => nums(&[]), "senders" => nums(&[]) };
        let records = object! { "v" => samples(&[1.0], Some(&[first])), "w" => none() };
        vec![(open.text(), opened("a")), (step("a", Some(1.0), Some(("in", 300.0))), recorded("a", records))]
    };
    let empty = |sizes: Json| {
        let open = Open::lif("a").json().edit(&["network", "population_sizes"], |_| sizes);
        vec![
            (open.text(), opened("a")),
            (step("a", None, None), observed("a", 10.0)),
            (run("a", 5.0), observed("a", 15.0)),
        ]
    };
    #[expect(clippy::type_complexity, reason = "a table is read by its rows")]
    let table: [(&str, &str, Vec<(String, Json)>, &'static str); 4] = [
        ("beside/lif", "one neuron and one", of(Open::lif("a"), "V_m", "current_pA", -70.0), "NCP-SESS-050"),
        ("beside/rate", "one rate neuron and one", of(Open::rate("a"), "rate", "rate_inject", 0.0), "NCP-SESS-051"),
        ("alone", "one population", empty(object! { "pop" => 0_u32 }), "NCP-SESS-050"),
        ("no-population", "no population", empty(Json::object()), "NCP-SESS-050"),
    ];
    table
        .into_iter()
        .map(|(name, words, trace, rule)| {
            let title = if name == "no-population" { String::new() } else { " without neurons".to_owned() };
            reference(format!("no-neurons/{name}"), &[rule, "NCP-SESS-033"], trace)
                .title(format!("A session of {words}{title} is opened, and runs."))
                .because(WHY)
        })
        .collect()
}

/// Ports and populations whose name is the empty string, as it is where none is given.
fn empty_names() -> Vec<Case> {
    let after = simulate(&[], 1.0, 1, 300.0).1;
    let v = || record("v", "V_m", 1.0);
    let i = || stimulus("in", "current_pA");
    let mut cases = Vec::new();
    let mut add = |name: &str, rule: &'static str, title: &str, open: Open, drives: &str, comes_as: &str| {
        // Of two populations, one has no name.
        let sizes = object! { "" => 1_u32, "pop" => 1_u32 };
        let open = open.json().edit(&["network", "population_sizes"], |_| sizes);
        let records = Json::Object(vec![(comes_as.to_owned(), object! { "values" => nums(&after) })]);
        let request = step("a", Some(1.0), Some((drives, 300.0)));
        let trace = vec![(open.text(), opened("a")), (request, recorded("a", crate::trace::exactly(records)))];
        cases.push(
            reference(format!("empty-name/{name}"), &[rule], trace)
                .title(title)
                .because("The empty string is a name as every other, and the default of `port` and `target`."),
        );
    };
    let recorded_only = Open { records: vec![v().without("port")], stimuli: vec![i()], ..Open::lif("a") };
    add("recorded", "NCP-SESS-038", "A port that is recorded without a name comes back.", recorded_only, "in", "");
    let driven = Open { records: vec![v()], stimuli: vec![i().with("port", "".into())], ..Open::lif("a") };
    add("driven", "NCP-SESS-054", "A stimulus reaches the port of the empty name.", driven, "", "v");
    let of = Open { records: vec![v().without("target")], stimuli: vec![i().without("target")], ..Open::lif("a") };
    add("population", "NCP-SESS-055", "The population of the empty name is driven and recorded.", of, "in", "v");
    cases
}

/// Ports that name many neurons, and a network of many populations.
fn many_named() -> Vec<Case> {
    let ids = |of: &[u32]| of.iter().copied().collect::<Json>();
    let driven = simulate(&[], 1.0, 1, 300.0).1[0];
    let mut cases = Vec::new();
    let mut fallen: Vec<u32> = (1..=300).rev().collect();
    let open = Open { size: 400, records: vec![record("v", "V_m", 1.0).with("ids", ids(&fallen))], ..Open::lif("a") };
    let records = object! { "v" => sent(&vec![1.0; fallen.len()], &fallen) };
    let trace = vec![(open.text(), opened("a")), (step("a", Some(1.0), None), recorded("a", records))];
    cases.push(
        reference("id/300-of-400".to_owned(), &["NCP-SESS-052", "NCP-SESS-059"], trace)
            .by("/replies/1/records/v/times", "NCP-SESS-059")
            .title("Of 400 neurons the 300 are recorded that the port names, in its order.")
            .because("A neuron's id is its position within its population; a list of numbers has no limit of its own."),
    );
    fallen.truncate(270);
    let open = Open {
        size: 400,
        records: vec![record("v", "V_m", 1.0)],
        stimuli: vec![stimulus("in", "current_pA").with("ids", ids(&fallen))],
        ..Open::lif("a")
    };
    let values: Vec<f64> = (1..=400).map(|id| if fallen.contains(&id) { driven } else { -70.0 }).collect();
    let records = object! { "v" => object! { "values" => nums(&values) } };
    let trace = vec![(open.text(), opened("a")), (step("a", Some(1.0), Some(("in", 300.0))), recorded("a", records))];
    cases.push(
        reference("reach/270-of-400".to_owned(), &["NCP-SESS-055"], trace)
            .title("Of 400 neurons a stimulus reaches the 270 that it names, and no others.")
            .because("A stimulus reaches each of the neurons of its target that its `ids` name."),
    );
    // More than a map may have entries, and than 12 bits count.
    let many: Vec<u32> = (1..=4_097).rev().collect();
    let open = Open { size: 4_100, records: vec![record("v", "V_m", 1.0).with("ids", ids(&many))], ..Open::lif("a") };
    let of_all = |value: f64| nums(&vec![value; many.len()]);
    let records = object! { "v" => object! { "times" => of_all(1.0), "values" => of_all(-70.0) } };
    let trace = vec![(open.text(), opened("a")), (step("a", Some(1.0), None), recorded("a", records))];
    cases.push(
        reference("id/4097-of-4100".to_owned(), &["NCP-SESS-050", "NCP-WIRE-069"], trace)
            .title("Of 4,100 neurons the 4,097 are recorded that the port names.")
            .because("A receiver limits the items of a numeric array by the bytes of the frame alone."),
    );
    // Populations that one byte counts to the same number.
    let sizes = (0..300).map(|nth| (format!("p{nth}"), 1_u32.into())).collect();
    let of = |of: Json, nth: u32| of.with("target", format!("p{nth}").into());
    let open = Open {
        records: vec![
            of(record("x", "V_m", 1.0), 0),
            of(record("y", "V_m", 1.0), 256),
            of(record("z", "V_m", 1.0), 299),
        ],
        stimuli: vec![of(stimulus("in", "current_pA"), 256), of(stimulus("also", "current_pA"), 43)],
        ..Open::lif("a")
    };
    let text = open.json().edit(&["network", "population_sizes"], |_| Json::Object(sizes)).text();
    let value = |value: f64| object! { "values" => nums(&[value]) };
    let records = object! { "x" => value(-70.0), "y" => value(driven), "z" => value(-70.0) };
    let trace =
        vec![(text, opened("a")), (driven_step("a", 1.0, &[("in", 300.0), ("also", 200.0)]), recorded("a", records))];
    cases.push(
        reference("reach/population-257-of-300".to_owned(), &["NCP-SESS-055"], trace)
            .title("Of 300 populations a stimulus reaches the one that it names, and no other.")
            .because("A stimulus reaches the neurons of its target, the population of that name."),
    );
    cases
}

/// A membrane that leaves the doubles only behind many steps of its request.
fn failures_behind_many_steps() -> Vec<Case> {
    let mut cases = Vec::new();
    // By a falling exponential, the potential passes the largest double behind three tenths of the time constant.
    for (name, tau, advance) in [("300", 1e3, 400.0), ("75000", 2.5e5, 80_000.0)] {
        let current = -(f64::MAX - 1.6e308) / -(-0.3_f64).exp_m1() / tau;
        let open = Open {
            params: vec![("E_L", -1.6e308), ("V_reset", -1.6e308), ("V_th", 0.0), ("C_m", 1.0), ("tau_m", tau)],
            records: vec![record("v", "V_m", advance)],
            stimuli: vec![stimulus("in", "current_pA")],
            ..Open::lif("a")
        };
        let stays = recorded_at("a", advance, object! { "v" => samples(&[advance], Some(&[-1.6e308])) });
        let drives = |request: String| {
            let values = object! { "in" => object! { "data" => nums(&[current]) } };
            Json::read(&request).with("stimulus", object! { "values" => values }).text()
        };
        for (way, fails) in [("step", step("a", Some(advance), None)), ("run", run("a", advance))] {
            if (way == "step") != (name == "300") {
                continue;
            }
            let trace = vec![
                (open.text(), opened("a")),
                (drives(fails), error()),
                (step("a", Some(advance), Some(("in", 0.0))), stays.clone()),
            ];
            let mut case =
                reference(format!("fails/behind-{name}-steps/{way}"), &["NCP-SESS-057", "NCP-SESS-037"], trace);
            case.by.remove("/replies/*/sim_time_ms");
            cases.push(
                case.title(format!(
                    "After a {way} in which the potential leaves the doubles behind {name} steps, none of them is left."
                ))
                .flags(&["session-lifecycle", "non-finite-numbers"])
                .because("A request that fails leaves the network and the time of its session as they were before it."),
            );
        }
    }
    cases
}

/// Neurons that rest while a request fails, for what is asked of another population.
fn failures_at_rest() -> Vec<Case> {
    let mut cases = Vec::new();
    // How long the neuron has run before the request that fails: it rests from its first spike on.
    for (before, after) in [(4_u32, 9_u32), (6, 8)] {
        let params = vec![("t_ref", 5.0), ("C_m", 1.0), ("I_e", 8.0)];
        let (times, values, spikes) = simulate(&params, 1.0, before + after, 8.0);
        for (observable, what) in [("spikes", "spikes"), ("V_m", "potential")] {
            let of = |from: u32, to: u32| {
                let is_within = |time: f64| time > f64::from(from) && time <= f64::from(to);
                let within: Vec<f64> = spikes.iter().copied().filter(|time| is_within(*time)).collect();
                let (from, to) = (from as usize, to as usize);
                let out = match observable {
                    "spikes" => samples(&within, None),
                    _ => samples(&times[from..to], Some(&values[from..to])),
                };
                recorded("a", object! { "out" => out })
            };
            if (observable == "V_m") != (before == 6) {
                continue;
            }
            let open = Open {
                other: Some(1),
                params: params.clone(),
                records: vec![record("out", observable, 1.0)],
                stimuli: vec![stimulus("in", "current_pA").with("target", "other".into())],
                ..Open::lif("a")
            };
            let trace = vec![
                (open.text(), opened("a")),
                (step("a", Some(f64::from(before)), None), of(0, before)),
                // So much leaves the doubles in whatever order it is computed.
                (step("a", Some(300.0), Some(("in", -1.7e308))), error()),
                (step("a", Some(f64::from(after)), Some(("in", 0.0))), of(before, before + after)),
            ];
            cases.push(
                reference(format!("fails/at-rest/{what}-after-{before}"), &["NCP-SESS-057", "NCP-SESS-050"], trace)
                    .title(format!(
                        "A neuron that has run for {before} ms goes on with its rest after a request that failed \
                         ({what})."
                    ))
                    .flags(&["session-lifecycle", "non-finite-numbers"])
                    .because(
                        "A request that fails leaves the network as it was before it, and so what is left of a rest.",
                    ),
            );
        }
    }
    cases
}

/// Numbers near the end of the doubles, each of which is within: what their sum is, matters to none.
fn large_together() -> Vec<Case> {
    let p = (-10.0_f64).exp();
    let rates: Vec<f64> = (0..2).scan(0.0, |r, _| Some(next_rate(r, p, 1e308))).collect();
    let lif = vec![("E_L", -1.6e308), ("V_th", 0.0), ("V_reset", -1.6e308)];
    let rate = vec![("mu", 1e308), ("tau", 0.1)];
    let mut cases = Vec::new();
    for (name, words, size, other) in
        [("population", "three neurons of one population", 3, None), ("populations", "two populations", 1, Some(1))]
    {
        for (network, rule, observable, ground, params, values) in [
            ("lif", "NCP-SESS-050", "V_m", Open::lif("a"), &lif, vec![-1.6e308; 2]),
            ("rate", "NCP-SESS-051", "rate", Open::rate("a"), &rate, rates.clone()),
        ] {
            if network == "lif" && other.is_some() {
                continue;
            }
            let open =
                Open { size, other, params: params.clone(), records: vec![record("out", observable, 1.0)], ..ground };
            let all = |of: &[f64]| -> Vec<f64> {
                of.iter().flat_map(|value| std::iter::repeat_n(*value, size as usize)).collect()
            };
            let records = object! { "out" => samples(&all(&[1.0, 2.0]), Some(&all(&values))) };
            let trace = vec![(open.text(), opened("a")), (step("a", Some(2.0), None), recorded("a", records))];
            cases.push(
                reference(format!("large/{name}/{network}"), &[rule, "NCP-SESS-057"], trace)
                    .title(format!("The numbers of {words} may be so large that their sum is no double ({network})."))
                    .flags(&["reference-numbers", "non-finite-numbers"])
                    .because("The numbers of a network are V and r of its neurons, each by itself."),
            );
        }
    }
    // One of three neurons alone leaves the doubles.
    let open = Open {
        size: 3,
        params: vec![("mu", 40.0)],
        records: vec![record("out", "rate", 1.0)],
        stimuli: ["in", "also"]
            .map(|port| stimulus(port, "rate_inject").with("ids", std::iter::once(2_u32).collect()))
            .into(),
        ..Open::rate("a")
    };
    let p = (-0.1_f64).exp();
    let rates: Vec<f64> = (0..3).scan(0.0, |r, _| Some(next_rate(r, p, 40.0))).collect();
    let three = |of: &[f64]| -> Vec<f64> { of.iter().flat_map(|value| [*value; 3]).collect() };
    let of = |times: &[f64], values: &[f64]| {
        recorded("a", object! { "out" => samples(&three(times), Some(&three(values))) })
    };
    let trace = vec![
        (open.text(), opened("a")),
        (step("a", Some(2.0), None), of(&[1.0, 2.0], &rates[..2])),
        (driven_step("a", 40.0, &[("in", 1.7e308), ("also", 1.7e308)]), error()),
        (driven_step("a", 1.0, &[("in", 0.0), ("also", 0.0)]), of(&[3.0], &rates[2..])),
    ];
    cases.push(
        reference("large/one-of-three".to_owned(), &["NCP-SESS-057", "NCP-SESS-051"], trace)
            .title("A request in which one of three neurons leaves the doubles fails, and leaves all three as before.")
            .flags(&["session-lifecycle", "non-finite-numbers"])
            .because("A request in which a number leaves the doubles fails, and leaves the network as it was."),
    );
    cases
}

/// One step of a rate neuron under its input.
fn next_rate(r: &mut f64, propagator: f64, input: f64) -> f64 {
    *r = *r * propagator + input * (1.0 - propagator);
    *r
}

/// The time of a session to the last bit: it is one product.
fn exact_times() -> Vec<Case> {
    let table: [(&str, f64, &[u32]); 2] = [("tenths-one-by-one", 0.1, &[1; 6]), ("many-tenths", 0.1, &[200_000])];
    table
        .into_iter()
        .map(|(name, dt, requests)| {
            let mut trace = vec![(Open { dt, ..Open::lif("a") }.text(), opened("a"))];
            let mut steps = 0;
            for more in requests {
                steps += more;
                let time = f64::from(steps) * dt;
                let reply = observed("a", 0.0).edit(&["$json", "sim_time_ms"], |_| within(time, time));
                trace.push((run("a", f64::from(*more) * dt), reply));
            }
            reference(format!("duration/exact/{name}"), &["NCP-SESS-058"], trace)
                .title(format!(
                    "The time of a session is the number of its steps times {dt:?}, to the last bit ({}).",
                    name.replace('-', " ")
                ))
                .because("The time of rule 58 is one product, the double nearest to it, and no running sum.")
        })
        .collect()
}

/// Sessions of one network that record and are driven by other ports.
fn own_ports() -> Vec<Case> {
    let ids = |of: u32| std::iter::once(of).collect::<Json>();
    let open = |id: &str, port: &str, neuron: u32, cadence: f64| Open {
        size: 3,
        records: vec![record(port, "V_m", cadence).with("ids", ids(neuron))],
        ..Open::lif(id)
    };
    let of = |port: &str, times: &[f64], sender: u32| {
        let senders = vec![sender; times.len()];
        crate::trace::exactly(Json::Object(vec![(port.to_owned(), sent(times, &senders))]))
    };
    let (a, b) = (open("a", "v", 1, 1.0), open("b", "w", 3, 2.0));
    let a_anew = Open { id: "a".to_owned(), ..b.clone() };
    let step = |id: &str| step(id, Some(2.0), None);
    let from_a = || recorded("a", of("v", &[1.0, 2.0], 1));
    #[expect(clippy::type_complexity, reason = "a table is read by its rows")]
    let table: [(&str, &str, Vec<(String, Json)>); 2] = [
        (
            "apart",
            "side by side",
            vec![
                (a.text(), opened("a")),
                (b.text(), opened("b")),
                (step("b"), recorded("b", of("w", &[2.0], 3))),
                (step("a"), from_a()),
            ],
        ),
        (
            "anew",
            "one behind the other",
            vec![
                (a.text(), opened("a")),
                (step("a"), from_a()),
                (super::close("a"), crate::trace::anything()),
                (a_anew.text(), opened("a")),
                (step("a"), recorded("a", of("w", &[2.0], 3))),
            ],
        ),
    ];
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(name, words, trace)| {
            let mut case = reference(format!("ports/{name}"), &["NCP-SESS-035", "NCP-SESS-038"], trace);
            case.by.remove("/replies/*/records/*/senders");
            case.title(format!("Two sessions of one network {words} record each its own ports."))
                .because("What is done to one session changes no other; each returns the ports that it records.")
        })
        .collect();
    // The same of what drives them.
    let driven = |id: &str, neuron: u32| Open {
        size: 3,
        records: vec![record("v", "V_m", 1.0)],
        stimuli: vec![stimulus("in", "current_pA").with("ids", ids(neuron))],
        ..Open::lif(id)
    };
    let after = |current: f64| simulate(&[], 1.0, 1, current).1[0];
    let of = |values: [f64; 3]| object! { "v" => object! { "values" => nums(&values.map(after)) } };
    let steps = |id: &str, values: [f64; 3]| (self::step(id, Some(1.0), Some(("in", 300.0))), recorded(id, of(values)));
    let trace = vec![
        (driven("a", 1).text(), opened("a")),
        (driven("b", 3).text(), opened("b")),
        steps("b", [0.0, 0.0, 300.0]),
        steps("a", [300.0, 0.0, 0.0]),
    ];
    cases.push(
        reference("ports/driven".to_owned(), &["NCP-SESS-035", "NCP-SESS-055"], trace)
            .title("Two sessions of one network are driven each by its own port.")
            .because("What is done to one session changes no other."),
    );
    cases
}

/// Sessions of a mode and a length that say what the client is about to do.
fn announced() -> Vec<Case> {
    let mut cases = Vec::new();
    for (network, rule, ground) in [("lif", "NCP-SESS-050", Open::lif("a")), ("rate", "NCP-SESS-051", Open::rate("a"))]
    {
        let open = Open { chunk: 5.0, ..ground }
            .json()
            .edit(&["sim"], |sim| sim.with("mode", "batch".into()).with("duration_ms", crate::trace::num(50.0)));
        let mut trace = vec![(open.text(), opened("a"))];
        trace.extend([5.0, 10.0, 15.0].map(|time| (step("a", None, None), observed("a", time))));
        cases.push(
            reference(format!("announced/batch/{network}"), &[rule, "NCP-SESS-031"], trace)
                .by("/replies/*/sim_time_ms", "NCP-SESS-031")
                .title(format!(
                    "A server that claims the reference networks opens them in the mode `batch`, too ({network})."
                ))
                .because("The `mode` and the `duration_ms` of a `SimConfig` change no answer."),
        );
    }
    cases
}

/// Rests of half a step and of nearly so much.
fn rounded_rests() -> Vec<Case> {
    let table = [
        ("next-below-half", 0.5_f64.next_down(), 1.0),
        ("half", 0.5, 1.0),
        ("next-below-half-of-a-quarter", 0.125_f64.next_down(), 0.25),
    ];
    table
        .into_iter()
        .map(|(name, rest, dt)| {
            let params = vec![("t_ref", rest), ("I_e", 2000.0)];
            let (_, _, spikes) = simulate(&params, dt, 20, 2000.0);
            let open = Open { params, records: vec![record("s", "spikes", 1.0)], dt, ..Open::lif("a") };
            let expected = recorded("a", object! { "s" => samples(&spikes, None) });
            reference(
                format!("spikes/rest-of-{name}"),
                &["NCP-SESS-050"],
                vec![(open.text(), opened("a")), (step("a", Some(20.0 * dt), None), expected)],
            )
            .title(format!(
                "A neuron whose `t_ref` is {rest:?} ms spikes {} times in 20 steps of {dt} ms.",
                spikes.len()
            ))
            .because("A time of x ms is round(x / dt) steps: the whole number nearest to it, the greater of two.")
        })
        .collect()
}

/// Requests that come to no step: each port comes back, and has no sample.
fn of_no_step() -> Vec<Case> {
    let ways = [
        ("lif", "step", 10.0, step("a", Some(0.25), None), Open::lif("a")),
        ("rate", "chunk", 0.25, step("a", None, None), Open::rate("a")),
    ];
    let mut cases = Vec::new();
    for (network, way, chunk, request, ground) in ways {
        let of_lif = network == "lif";
        let (records, value) = match of_lif {
            true => (vec![record("v", "V_m", 1.0), record("s", "spikes", 1.0)], -70.0),
            false => (vec![record("v", "rate", 1.0)], 0.0),
        };
        let none = || object! { "times" => nums(&[]), "values" => nums(&[]), "senders" => nums(&[]) };
        let with = |v: Json| match of_lif {
            true => crate::trace::exactly(object! { "v" => v, "s" => none() }),
            false => crate::trace::exactly(object! { "v" => v }),
        };
        let open = Open { records, chunk, ..ground };
        let trace = vec![
            (open.text(), opened("a")),
            (request.clone(), recorded_at("a", 0.0, with(none()))),
            (step("a", Some(1.0), None), recorded_at("a", 1.0, with(samples(&[1.0], Some(&[value]))))),
            (request.clone(), recorded_at("a", 1.0, with(none()))),
        ];
        let case = reference(format!("no-step/{way}/{network}"), &["NCP-SESS-038", "NCP-SESS-058"], trace);
        let case = ["times", "values", "senders"]
            .into_iter()
            .fold(case, |case, member| case.by(format!("/replies/*/records/*/{member}"), "NCP-SESS-058"));
        cases.push(
            case.title(format!(
                "A {way} of a quarter of a step is answered with observations without samples ({network})."
            ))
            .because("A request that comes to no step is answered as every other, with observations of no samples."),
        );
    }
    cases
}

/// Ports of one population that name other neurons, as many of them: each has the samples of its own.
fn own_neurons() -> Vec<Case> {
    let ids = |of: &[u32]| of.iter().copied().collect::<Json>();
    let named: [(&str, &[u32]); 4] = [("v", &[1]), ("w", &[2]), ("x", &[1, 3]), ("y", &[3, 1])];
    let mut cases = Vec::new();
    for (observable, current, steps) in [("V_m", 300.0, 2_u32), ("spikes", 5_000.0, 4)] {
        // Neurons 2 and 3 are driven, and the third by two ports.
        let drive = |port: &str, of: &[u32]| stimulus(port, "current_pA").with("ids", ids(of));
        let open = Open {
            size: 3,
            records: named.iter().map(|(port, of)| record(port, observable, 1.0).with("ids", ids(of))).collect(),
            stimuli: vec![drive("in", &[2, 3]), drive("more", &[3])],
            ..Open::lif("a")
        };
        let inputs = [0.0, current, 2.0 * current];
        let runs = inputs.map(|input| simulate(&[], 1.0, steps, input));
        let observation = |of: &[u32]| {
            let (mut times, mut values, mut senders) = (Vec::new(), Vec::new(), Vec::new());
            for nth in 0..steps as usize {
                for id in of {
                    let at = *id as usize - 1;
                    let (time, potential) = (runs[at].0[nth], runs[at].1[nth]);
                    if observable == "spikes" && !runs[at].2.contains(&time) {
                        continue;
                    }
                    times.push(time);
                    senders.push(*id);
                    if observable == "V_m" {
                        values.push(potential);
                    }
                }
            }
            sent(&times, &senders).with("values", nums(&values))
        };
        let records = Json::Object(named.iter().map(|(port, of)| ((*port).to_owned(), observation(of))).collect());
        let request = driven_step("a", f64::from(steps), &[("in", current), ("more", current)]);
        let trace = vec![(open.text(), opened("a")), (request, recorded("a", records))];
        let what = if observable == "V_m" { "potential" } else { observable };
        let case = reference(format!("id/of-each-port/{what}"), &["NCP-SESS-052", "NCP-SESS-059"], trace);
        let case = if observable == "spikes" { case } else { case.by("/replies/*/records/*/times", "NCP-SESS-053") };
        cases.push(
            // The last port names what another does, in another order.
            case.by("/replies/1/records/y", "NCP-SESS-059")
                .rests_on("session/reference/reach/two")
                .title(format!("Each of four ports has the samples of the neurons that it names ({what})."))
                .because("A neuron's id is its position within its population; a port records those that it names."),
        );
    }
    cases
}

/// A number that is right to a relative error of 1e-9, also where it is next to 0.
fn near_to(value: f64) -> Json {
    let error = value.abs() * 1e-9;
    within(value - error, value + error)
}

/// The samples of one neuron whose times and values are told from 0 however small they are.
fn small_samples(times: &[f64], values: &[f64]) -> Json {
    let all = |of: &[f64]| of.iter().copied().map(near_to).collect::<Json>();
    object! { "times" => all(times), "values" => all(values) }
}

/// Numbers next to 0: the error is relative to them.
fn tiny() -> Vec<Case> {
    const WHY: &str = "The error of rules 50 and 51 is relative to the value, and nothing cancels here.";
    let p = (-0.1_f64).exp();
    let mut cases = Vec::new();
    let rest = [("E_L", 0.0), ("V_reset", 0.0), ("V_th", 1.0), ("C_m", 10.0)];
    // By what it has of its own, or by what a port gives it: then V and r follow one law.
    for (name, value, is_given) in [("1e-15", -1e-15, true), ("1e-40", 1e-40, false)] {
        let (how, own, given) = match is_given {
            true => ("that a port gives it", 0.0, Some(value)),
            false => ("of its own", value, None),
        };
        let lif = Open {
            params: rest.into_iter().chain([("I_e", own)]).collect(),
            records: vec![record("out", "V_m", 1.0)],
            stimuli: vec![stimulus("in", "current_pA")],
            ..Open::lif("a")
        };
        let rate = Open {
            params: vec![("mu", own)],
            records: vec![record("out", "rate", 1.0)],
            stimuli: vec![stimulus("in", "rate_inject")],
            ..Open::rate("a")
        };
        for (network, rule, open) in [("lif", "NCP-SESS-050", lif), ("rate", "NCP-SESS-051", rate)] {
            let values: Vec<f64> = (0..2).scan(0.0, |r, _| Some(next_rate(r, p, value))).collect();
            let records = object! { "out" => small_samples(&[1.0, 2.0], &values) };
            let request = step("a", Some(2.0), given.map(|value| ("in", value)));
            let trace = vec![(open.text(), opened("a")), (request, recorded("a", records))];
            cases.push(
                reference(format!("tiny/{name}/{network}"), &[rule], trace)
                    .title(format!("A neuron ({network}) is integrated under an input of {value:e} {how}."))
                    .because(WHY),
            );
        }
    }
    // From a step under an input it falls towards 0, and never is 0.
    for (network, rule, open) in [
        (
            "lif",
            "NCP-SESS-050",
            Open {
                params: rest.to_vec(),
                records: vec![record("out", "V_m", 300.0)],
                stimuli: vec![stimulus("in", "current_pA")],
                ..Open::lif("a")
            },
        ),
        (
            "rate",
            "NCP-SESS-051",
            Open {
                records: vec![record("out", "rate", 300.0)],
                stimuli: vec![stimulus("in", "rate_inject")],
                ..Open::rate("a")
            },
        ),
    ] {
        let first = 4.0 * (1.0 - p);
        let at = |step: f64| first * (-(step - 1.0) / 10.0).exp();
        let times = [300.0, 600.0, 900.0];
        let trace = vec![
            (open.text(), opened("a")),
            (step("a", Some(1.0), Some(("in", 4.0))), observation("a")),
            (
                step("a", Some(899.0), Some(("in", 0.0))),
                recorded("a", object! { "out" => small_samples(&times, &times.map(at)) }),
            ),
        ];
        cases.push(
            reference(format!("tiny/falling/{network}"), &[rule], trace)
                .title(format!("A neuron ({network}) falls towards 0 by the same factor in each of 900 steps."))
                .because(WHY),
        );
    }
    cases
}

/// Steps that are far shorter than any time constant.
fn short_steps() -> Vec<Case> {
    let mut cases = Vec::new();
    let dt = 1e-9;
    let lif = Open {
        params: vec![("C_m", 10.0), ("E_L", 0.0), ("V_reset", 0.0), ("V_th", 1e300), ("t_ref", 0.0), ("I_e", 3e18)],
        records: vec![record("out", "V_m", 5.0 * dt)],
        dt,
        chunk: 10.0 * dt,
        ..Open::lif("a")
    };
    let rate = Open {
        params: vec![("mu", 3e18)],
        records: vec![record("out", "rate", 5.0 * dt)],
        dt,
        chunk: 10.0 * dt,
        ..Open::rate("a")
    };
    for (network, rule, open) in [("lif", "NCP-SESS-050", lif), ("rate", "NCP-SESS-051", rate)] {
        let at = |steps: f64| 3e18 * -(-steps * (dt / 10.0)).exp_m1();
        let records = object! { "out" => small_samples(&[5.0 * dt, 10.0 * dt], &[at(5.0), at(10.0)]) };
        let reply = recorded_at("a", 0.0, records).edit(&["$json", "sim_time_ms"], |_| near_to(10.0 * dt));
        let trace = vec![(open.text(), opened("a")), (step("a", None, None), reply)];
        cases.push(
            reference(format!("short/{network}"), &[rule, "NCP-SESS-058"], trace)
                .title(format!("A session ({network}) of steps of 1e-9 ms is opened, and runs ten of them."))
                .because("A `dt_ms` that is positive is none to refuse, however short it is."),
        );
    }
    cases
}

/// A session that is opened under the id of one that has ended, and otherwise than it.
fn opened_otherwise() -> Vec<Case> {
    let lif = || Open { params: vec![("I_e", 300.0)], records: vec![record("v", "V_m", 1.0)], ..Open::lif("a") };
    let rate = || Open { params: vec![("mu", 40.0)], records: vec![record("v", "rate", 1.0)], ..Open::rate("a") };
    let records = |times: &[f64], values: &[f64], senders: &[u32]| {
        object! { "v" => sent(times, senders).with("values", nums(values)) }
    };
    let of_lif = |dt: f64, steps: u32| {
        let (times, values, _) = simulate(&[], dt, steps, 300.0);
        records(&times, &values, &vec![1; times.len()])
    };
    let (_, one, _) = simulate(&[], 1.0, 1, 300.0);
    let r = 40.0 * (1.0 - (-0.1_f64).exp());
    let half = Open { dt: 0.5, records: vec![record("v", "V_m", 0.5)], ..lif() };
    let steps = |ms: f64| step("a", Some(ms), None);
    type Row = (&'static str, &'static str, &'static str, Open, Open, String, Json);
    let table: Vec<Row> = vec![
        ("step", "steps", "NCP-SESS-058", lif(), half, steps(1.5), recorded_at("a", 1.5, of_lif(0.5, 3))),
        ("lif", "network", "NCP-SESS-050", rate(), lif(), steps(1.0), recorded_at("a", 1.0, of_lif(1.0, 1))),
        (
            "rate",
            "network",
            "NCP-SESS-051",
            lif(),
            rate(),
            steps(1.0),
            recorded_at("a", 1.0, records(&[1.0], &[r], &[1])),
        ),
        (
            "size",
            "size",
            "NCP-SESS-052",
            lif(),
            Open { size: 3, ..lif() },
            steps(1.0),
            recorded_at("a", 1.0, records(&[1.0; 3], &[one[0]; 3], &[1, 2, 3])),
        ),
        (
            "chunk",
            "chunk",
            "NCP-SESS-031",
            lif(),
            Open { chunk: 2.0, ..lif() },
            step("a", None, None),
            recorded_at("a", 2.0, of_lif(1.0, 2)),
        ),
    ];
    let case = |(name, words, rule, first, second, request, reply): Row| {
        let trace = vec![
            (first.text(), opened("a")),
            (step("a", Some(1.0), None), observation("a")),
            (super::close("a"), crate::trace::anything()),
            (second.text(), opened("a")),
            (request, reply),
        ];
        let mut case = reference(format!("reopened/otherwise/{name}"), &[rule, "NCP-SESS-035"], trace);
        case.by.retain(|place, _| place == "/replies/0");
        case.by("/replies/3", if name == "rate" { "NCP-SESS-051" } else { "NCP-SESS-050" })
            .title(format!("A session that is opened under the id of one of other {words} runs by its own ({name})."))
            .because("What was done to a session that has ended changes no other, nor what it was opened with.")
    };
    table.into_iter().map(case).collect()
}

/// What sessions that have ended, and openings that were refused, leave to others: all of the room.
fn room() -> Vec<Case> {
    const WHY: &str = "A server bears up to 100,000 neurons in a session; what a session took is free when it ends.";
    let large = |id: &str| Open { size: 60_000, ..Open::lif(id) };
    let opens = |id: &str| (large(id).text(), opened(id));
    let runs = |id: &str| (step(id, Some(1.0), None), observed(id, 1.0));
    let closes = |id: &str| (super::close(id), crate::trace::anything());
    // The second has the id of the first.
    let one_by_one = ["a", "a", "b"].iter().flat_map(|id| [opens(id), runs(id), closes(id)]).collect();
    // Two ports of one name, for which it should be refused.
    let twice = Open { records: vec![record("v", "V_m", 1.0), record("v", "V_m", 1.0)], ..large("a") };
    let refused = || [(twice.text(), crate::trace::anything()), closes("a")];
    let behind_refused = [refused(), refused()].into_iter().flatten().chain([opens("a"), runs("a")]).collect();
    [
        ("ended", "behind two others that have ended", one_by_one),
        ("refused", "behind two that were refused", behind_refused),
    ]
    .into_iter()
    .map(|(name, words, trace)| {
        reference(format!("far/room/{name}"), &["NCP-SESS-050", "NCP-SESS-028"], trace)
            .title(format!("A session of 60,000 neurons is opened {words}."))
            .because(WHY)
    })
    .collect()
}
