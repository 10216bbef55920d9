//! Requests that fail within the simulator: what they cost, and that everything is then as it was before them.

use super::life::steps;
use super::numbers::driven_step;
use super::{Open, case, close, closed, error, observed, opened, record, recorded, run, step as step_of, stimulus};
use crate::case::Case;
use crate::json::{Json, object};
use crate::trace::{nums, text_of};

pub(super) fn cases() -> Vec<Case> {
    let mut cases = failures();
    cases.push(failure_of_many_steps());
    cases.extend(failures_of_one());
    cases.extend(failures_behind_no_step());
    cases.extend(failures_by_road());
    cases.push(failures_of_two());
    cases.extend(failures_beside_a_current());
    cases.extend(failures_without_number());
    cases
}

/// Numbers that leave the doubles within the simulator, so that no frame can hold what it gives.
fn failures() -> Vec<Case> {
    let driven = |open: Open, observable: &str, kind: &str| Open {
        records: vec![record("out", observable, 1.0)],
        stimuli: vec![stimulus("in", kind)],
        ..open
    };
    let rate = driven(Open { params: vec![("mu", 1.7e308)], ..Open::rate("a") }, "rate", "rate_inject");
    let membrane = driven(Open { params: vec![("C_m", 1.0)], ..Open::lif("a") }, "V_m", "current_pA");
    // Beyond the doubles in whatever order it is computed, and above every threshold.
    let spiking = driven(Open { params: vec![("C_m", 1e-3)], ..Open::lif("a") }, "V_m", "current_pA");
    // With the second input, either network stays where it began.
    let table = [
        ("rate", rate, 1.7e308, -1.7e308, 0.0),
        ("membrane", membrane, -1.7e308, 0.0, -70.0),
        ("spiking-membrane", spiking, 1.7e308, 0.0, -70.0),
    ];
    let mut cases = Vec::new();
    for (what, a, too_much, rest, state) in table {
        let open = || (a.text(), opened("a"));
        let by = |time: f64, value: f64| step_of("a", Some(time), Some(("in", value)));
        let fails = || (by(10.0, too_much), error());
        let after = |from: u32, to: u32| {
            let times: Vec<f64> = (from + 1..=to).map(f64::from).collect();
            let values = vec![state; times.len()];
            recorded("a", object! { "out" => object! { "times" => nums(&times), "values" => nums(&values) } })
        };
        let mut push = |name: &str, rules: &[&'static str], title: String, trace, why: &str| {
            cases.push(
                super::reference(format!("fails/{what}{name}"), rules, trace)
                    .title(title)
                    .flags(&["session-lifecycle", "non-finite-numbers"])
                    .because(why),
            );
        };
        push(
            "",
            &["NCP-SESS-037"],
            format!("A step whose {what} leaves the doubles is an error, and costs no other session."),
            vec![open(), (Open::lif("b").text(), opened("b")), fails(), steps("b", 10.0)],
            "A request that fails within the simulator costs that request only, and is answered with an error \
             frame; no frame can hold an infinity.",
        );
        push(
            "/goes-on",
            &["NCP-SESS-037", "NCP-SESS-057"],
            format!("After a step whose {what} leaves the doubles, the session goes on from where it was."),
            vec![open(), fails(), (by(5.0, rest), after(0, 5))],
            "A request that fails costs that request only: network and time are as they were before it.",
        );
        push(
            "/goes-on-later",
            &["NCP-SESS-037", "NCP-SESS-057"],
            format!("A step whose {what} leaves the doubles undoes nothing of the steps before it."),
            vec![open(), (by(3.0, rest), after(0, 3)), fails(), fails(), (by(5.0, rest), after(3, 8))],
            "A request that fails costs that request only: network and time are as they were before it.",
        );
        push(
            "/takes-no-time",
            &["NCP-SESS-057", "NCP-SESS-033"],
            format!("A step whose {what} leaves the doubles takes no simulation time."),
            vec![open(), fails(), (by(5.0, rest), observed("a", 5.0))],
            "A request that fails leaves the time of the session as it was.",
        );
        // So long that the samples of all of them are more than a server bears in one.
        let long = |steps: f64| (by(steps, too_much), error());
        let most = [300_000.0, 300_000.0, 300_000.0, 99_998.0].map(long);
        push(
            "/of-many-samples",
            &["NCP-SESS-037"],
            format!("After four long steps whose {what} leaves the doubles, the session goes on from where it was."),
            [open()].into_iter().chain(most).chain([(by(5.0, rest), after(0, 5))]).collect(),
            "A request that fails costs that request only: what it took is free again.",
        );
        if what == "rate" {
            // As many neurons times steps as a server bears, again and again.
            let large = Open { size: 1_000, records: vec![record("out", "rate", 1_000.0)], ..a.clone() };
            let fails = (by(20_000.0, too_much), error());
            let opens = [(large.text(), opened("a"))].into_iter();
            push(
                "/of-many-neuron-steps",
                &["NCP-SESS-037"],
                "After 16 steps of 20 million neuron steps that fail, the session goes on from where it was."
                    .to_owned(),
                opens.chain(std::iter::repeat_n(fails, 16)).chain([(by(5.0, rest), observed("a", 5.0))]).collect(),
                "A request that fails costs that request only: what it took is free again.",
            );
        }
        let mut trace = vec![open()];
        for nth in 0..4 {
            trace.extend(std::iter::repeat_with(fails).take(6));
            trace.push((by(5.0, rest), after(5 * nth, 5 * nth + 5)));
        }
        push(
            "/often",
            &["NCP-SESS-037"],
            format!("After 24 steps whose {what} leaves the doubles, and others between them, the session goes on."),
            trace,
            "A request that fails costs that request only, however many of them do.",
        );
    }
    cases
}

/// A step that fails in its first step, of nearly as many as a server bears, and one behind it.
fn failure_of_many_steps() -> Case {
    let stimuli = vec![stimulus("in", "rate_inject")];
    let open = Open { params: vec![("mu", 1.7e308)], stimuli, records: Vec::new(), ..Open::rate("a") };
    let by = |time: f64, value: f64| step_of("a", Some(time), Some(("in", value)));
    let trace = vec![
        (open.text(), opened("a")),
        (by(19_999_990.0, 1.7e308), error()),
        (by(20.0, -1.7e308), observed("a", 20.0)),
    ];
    super::reference("fails/rate/of-many-steps".to_owned(), &["NCP-SESS-037"], trace)
        .title("After a step of 19,999,990 ms whose rate leaves the doubles, the session goes on.")
        .flags(&["session-lifecycle", "non-finite-numbers"])
        .because("A request that fails costs that request only: what it took is free again.")
}

/// Numbers of one of two populations that leave the doubles, at its first step or after some: the other is put back as
/// well, and so are another session and its time.
fn failures_of_one() -> Vec<Case> {
    let drive = |port: &str, kind: &str, target: &str| stimulus(port, kind).with("target", target.into());
    let kinds = [("rate", "rate", "rate_inject"), ("membrane", "V_m", "current_pA")];
    let mut cases = Vec::new();
    for (what, observable, kind) in kinds {
        for (failing, other) in [("pop", "other"), ("other", "pop")] {
            // Two inputs whose sum is none, in whatever order it is computed, and one to the population that is asked.
            let two = [drive("y", kind, failing), drive("z", kind, failing), drive("x", kind, other)];
            let network = |id: &str| if what == "rate" { Open::rate(id) } else { Open::lif(id) };
            let open = |id: &str| Open {
                other: Some(1),
                records: vec![record("out", observable, 1.0).with("target", other.into())],
                stimuli: two.to_vec(),
                ..network(id)
            };
            let by = |id: &str, time: f64, x: f64, much: f64| {
                let value = |value: f64| object! { "data" => nums(&[value]) };
                let values = object! { "x" => value(x), "y" => value(much), "z" => value(much) };
                let request = Json::read(&step_of(id, Some(time), None));
                request.with("stimulus", object! { "values" => values }).text()
            };
            // What the population that is asked does, of which no step of a request that failed is left.
            let mut runs = driven_from_rest(what);
            let before = recorded("a", runs(0, 3, 40.0));
            let after = recorded("a", runs(3, 5, 20.0));
            let trace = vec![
                (open("a").text(), opened("a")),
                (by("a", 3.0, 40.0, 1.0), before),
                (by("a", 4.0, 200.0, 1.7e308), error()),
                (by("a", 2.0, 20.0, 1.0), after),
            ];
            cases.push(
                super::reference(format!("fails/{what}-of-{failing}/other"), &["NCP-SESS-057", "NCP-SESS-037"], trace)
                    .title(format!(
                        "After a step in which the {what} of the population `{failing}` leaves the doubles, `{other}` \
                         goes on from where it was."
                    ))
                    .flags(&["session-lifecycle", "non-finite-numbers"])
                    .because("A request that fails leaves the network as it was before it, all of it."),
            );
        }
    }
    cases.extend(late_failures());
    cases
}

/// What a population that began at rest records at its port `out` over some steps of one input, step by step.
fn driven_from_rest(what: &str) -> impl FnMut(u32, u32, f64) -> Json {
    let is_rate = what == "rate";
    let mut state = if is_rate { 0.0 } else { -70.0 };
    let p = (-0.1_f64).exp();
    move |from, to, x| {
        let times: Vec<f64> = (from + 1..=to).map(f64::from).collect();
        let step = |_: &f64| {
            state = match is_rate {
                true => state * p + x * (1.0 - p),
                false => -70.0 + (state + 70.0) * p + x * 10.0 / 250.0 * (1.0 - p),
            };
            state
        };
        let values: Vec<f64> = times.iter().map(step).collect();
        object! { "out" => object! { "times" => nums(&times), "values" => nums(&values) } }
    }
}

/// A value that came with no step stays in force, also behind a request of another port that fails.
fn failures_behind_no_step() -> Vec<Case> {
    let kinds = [("rate", "rate", "rate_inject"), ("membrane", "V_m", "current_pA")];
    let mut cases = Vec::new();
    for (what, observable, kind) in kinds {
        for (name, nothing, words) in [("of-0-ms", 0.0, "of 0 ms"), ("of-no-step", 0.25, "of a quarter of a step")] {
            let drive = |port: &str, target: &str| stimulus(port, kind).with("target", target.into());
            let open = Open {
                other: Some(1),
                records: vec![record("out", observable, 1.0)],
                stimuli: vec![drive("x", "pop"), drive("y", "other"), drive("z", "other")],
                ..if what == "rate" { Open::rate("a") } else { Open::lif("a") }
            };
            let by = |time: f64, given: &[(&str, f64)]| {
                let value = |(port, value): &(&str, f64)| ((*port).to_owned(), object! { "data" => nums(&[*value]) });
                let values = Json::Object(given.iter().map(value).collect());
                let request = Json::read(&step_of("a", Some(time), None));
                request.with("stimulus", object! { "values" => values }).text()
            };
            let mut runs = driven_from_rest(what);
            // Two inputs of the other population whose sum is beyond the doubles, and then none.
            let trace = vec![
                (open.text(), opened("a")),
                (by(3.0, &[("x", 40.0)]), recorded("a", runs(0, 3, 40.0))),
                (by(nothing, &[("x", 20.0)]), text_of(object! { "kind" => "observation_frame" })),
                (by(4.0, &[("y", 1.7e308), ("z", 1.7e308)]), error()),
                (by(2.0, &[("y", 0.0), ("z", 0.0)]), recorded("a", runs(3, 5, 20.0))),
            ];
            cases.push(
                super::reference(
                    format!("fails/{what}/behind-a-value/{name}"),
                    &["NCP-SESS-054", "NCP-SESS-057"],
                    trace,
                )
                .title(format!(
                    "A value that came with a step {words} is in force behind one whose {what} leaves the doubles."
                ))
                .flags(&["session-lifecycle", "non-finite-numbers"])
                .because(
                    "A stimulus acts from the next step on until the next value of its port, and a request that \
                     fails costs that request only.",
                ),
            );
        }
    }
    cases
}

/// A membrane that leaves the doubles only at a later step of its request, beside a population that does not.
fn late_failures() -> Vec<Case> {
    [1, 2, 3].into_iter().flat_map(late_failures_sampled).collect()
}

/// The same, with a sample every so many steps.
fn late_failures_sampled(every: u32) -> Vec<Case> {
    // From E_L the potential falls by 1e308 mV times 1 - P^n, which is too much at the third step.
    let params = vec![("E_L", -1.6e308), ("C_m", 1.0), ("tau_m", 10.0), ("V_th", 0.0)];
    let drive = |port: &str, target: &str| stimulus(port, "current_pA").with("target", target.into());
    let open = |id: &str| Open {
        other: Some(1),
        params: params.clone(),
        records: vec![
            record("out", "V_m", f64::from(every)),
            record("out-too", "V_m", f64::from(every)).with("target", "other".into()),
        ],
        stimuli: vec![drive("x", "pop"), drive("y", "other")],
        ..Open::lif(id)
    };
    let by = |id: &str, time: f64, x: f64, y: f64| {
        let value = |value: f64| object! { "data" => nums(&[value]) };
        let request = Json::read(&step_of(id, Some(time), None));
        request.with("stimulus", object! { "values" => object! { "x" => value(x), "y" => value(y) } }).text()
    };
    let run = |id: &str, from: u32, steps: u32, x: f64, y: f64, state: &mut [f64; 2]| {
        let mut values = [Vec::new(), Vec::new()];
        let mut times = Vec::new();
        for step in from + 1..=from + steps {
            *state = [fallen(state[0], x), fallen(state[1], y)];
            if step % every == 0 {
                times.push(f64::from(step));
                values[0].push(state[0]);
                values[1].push(state[1]);
            }
        }
        let of = |values: &[f64]| object! { "times" => nums(&times), "values" => nums(values) };
        (by(id, f64::from(steps), x, y), recorded(id, object! { "out" => of(&values[0]), "out-too" => of(&values[1]) }))
    };
    // So much falls too far at the third step of a request; so little rises, and never far.
    let (much, little) = (-1e307, 2e306);
    let table: [(&str, &str, f64, f64); 3] = [
        ("first", "the first population", much, little),
        ("second", "the second population", little, much),
        ("both", "both populations", much, much),
    ];
    let mut cases = Vec::new();
    for (name, words, x, y) in table {
        let (mut a, mut b) = ([-1.6e308; 2], [-1.6e308; 2]);
        let mut trace = vec![(open("a").text(), opened("a")), (open("b").text(), opened("b"))];
        trace.push(run("a", 0, 2, little, little, &mut a));
        trace.push(run("b", 0, 1, little, little, &mut b));
        trace.push((by("a", 10.0, x, y), error()));
        trace.push(run("a", 2, if every == 1 { 2 } else { 5 }, little, 0.0, &mut a));
        trace.push(run("b", 1, 2, 0.0, little, &mut b));
        let (path, rules, sampled): (_, &[&'static str], _) = match every {
            1 => (format!("fails/later/{name}"), &["NCP-SESS-057", "NCP-SESS-035"], String::new()),
            _ => (
                format!("fails/later/{name}/every-{every}"),
                &["NCP-SESS-057", "NCP-SESS-053", "NCP-SESS-035"],
                format!(" (a sample every {every} steps)"),
            ),
        };
        cases.push(
            super::reference(path, rules, trace)
                .title(format!(
                    "After a step in which {words} of a session leaves the doubles some way on, neither population has \
                     moved, and no other session{sampled}."
                ))
                .flags(&["session-lifecycle", "non-finite-numbers"])
                .because("A request that fails leaves the network and the time of its session as they were before it."),
        );
    }
    cases
}

/// The potential after a step of 1 ms under a current, where it rests at -1.6e308 mV, of 1 pF and 10 ms.
fn fallen(v: f64, current: f64) -> f64 {
    let p = (-0.1_f64).exp();
    -1.6e308 + (v + 1.6e308) * p + current * 10.0 * (1.0 - p)
}

/// A membrane that leaves the doubles by each kind of request, and under a current that it has already as well.
fn failures_by_road() -> Vec<Case> {
    // So much falls too far at the third step.
    let (much, little) = (-1e307, -1e306);
    let open = |own: f64| Open {
        params: vec![
            ("E_L", -1.6e308),
            ("V_reset", -1.6e308),
            ("C_m", 1.0),
            ("tau_m", 10.0),
            ("V_th", 0.0),
            ("I_e", own),
        ],
        records: vec![record("v", "V_m", 1.0)],
        stimuli: vec![stimulus("in", "current_pA")],
        ..Open::lif("a")
    };
    let roads = [
        ("chunk", "a step of the session's chunk", step_of("a", None, None)),
        ("step", "a step", step_of("a", Some(10.0), None)),
        ("run", "a run", run("a", 10.0)),
    ];
    // The neuron's own current, and what the requests bring before, in and behind the one that fails.
    let table: [(&str, &str, f64, [Option<f64>; 3]); 3] = [
        ("own", "the neuron's own current", much, [None; 3]),
        ("kept", "a current that a request before brought", 0.0, [Some(much), None, Some(0.0)]),
        ("brought", "the current that it brings", 0.0, [Some(little), Some(much), Some(0.0)]),
    ];
    let mut cases = Vec::new();
    for (way, words, fails) in roads {
        for (how, by, own, [before, within, behind]) in table {
            // The cases of a later step have one that brings it.
            if matches!((way, how), ("step", "brought" | "kept") | ("run", "own" | "kept")) {
                continue;
            }
            let driven = |request: &str, value: Option<f64>| match value {
                Some(value) => {
                    let values = object! { "in" => object! { "data" => nums(&[value]) } };
                    Json::read(request).with("stimulus", object! { "values" => values }).text()
                }
                None => request.to_owned(),
            };
            let one = step_of("a", Some(1.0), None);
            let mut v = -1.6e308;
            let mut steps = |time: f64, value: Option<f64>| {
                v = fallen(v, value.unwrap_or(own));
                let samples = object! { "times" => nums(&[time]), "values" => nums(&[v]) };
                (driven(&one, value), recorded("a", object! { "v" => samples }))
            };
            let trace = vec![
                (open(own).text(), opened("a")),
                steps(1.0, before),
                (driven(&fails, within), error()),
                steps(2.0, behind),
            ];
            cases.push(
                super::reference(format!("fails/by-{way}/{how}"), &["NCP-SESS-057", "NCP-SESS-037"], trace)
                    .title(format!(
                        "After {words} in which the potential leaves the doubles by {by}, the session goes on from \
                         where it was."
                    ))
                    .flags(&["session-lifecycle", "non-finite-numbers"])
                    .because("A request that fails leaves the network and the time of its session as they were."),
            );
        }
    }
    cases
}

/// A network whose numbers leave the doubles when two ports give it so much for 40 ms.
struct Overdriven {
    what: &'static str,
    observable: &'static str,
    kind: &'static str,
    ground: Open,
    much: f64,
    /// A value that does no harm.
    little: f64,
    /// Where it begins, and by how much the input is multiplied.
    rest: f64,
    gain: f64,
}

impl Overdriven {
    fn both() -> [Self; 2] {
        let membrane = Open { params: vec![("C_m", 1.0)], ..Open::lif("a") };
        let of = |what, [observable, kind]: [&'static str; 2], ground, [much, little, rest, gain]: [f64; 4]| Self {
            what,
            observable,
            kind,
            ground,
            much,
            little,
            rest,
            gain,
        };
        [
            of("rate", ["rate", "rate_inject"], Open::rate("a"), [1.7e308, 40.0, 0.0, 1.0]),
            of("membrane", ["V_m", "current_pA"], membrane, [-1.7e308, 0.5, -70.0, 10.0]),
        ]
    }

    /// A session of it, with an output and these inputs.
    fn open(&self, id: &str, stimuli: Vec<Json>) -> Open {
        let records = vec![record("out", self.observable, 1.0)];
        Open { id: id.to_owned(), records, stimuli, ..self.ground.clone() }
    }

    /// Where it is after each of so many steps of 1 ms under an input.
    fn after(&self, steps: usize, input: f64) -> Vec<f64> {
        let p = (-0.1_f64).exp();
        let next = |x: &mut f64, _| {
            *x = self.rest + (*x - self.rest) * p + input * self.gain * (1.0 - p);
            Some(*x)
        };
        (0..steps).scan(self.rest, next).collect()
    }
}

/// Two sessions of one network that both fail before anything else: they stay two.
fn failures_of_two() -> Case {
    let [of, _] = Overdriven::both();
    let what = of.what;
    let stimuli = || ["x", "y"].map(|port| stimulus(port, of.kind)).into();
    let open = |id: &str| (of.open(id, stimuli()).text(), opened(id));
    let fails = |id: &str| (driven_step(id, 40.0, &[("x", of.much), ("y", of.much)]), error());
    let steps = |id: &str, x: f64| {
        let out = object! { "times" => nums(&[1.0]), "values" => nums(&of.after(1, x)) };
        (driven_step(id, 1.0, &[("x", x), ("y", 0.0)]), recorded(id, object! { "out" => out }))
    };
    let trace = vec![open("a"), open("b"), fails("a"), fails("b"), steps("a", of.little), steps("b", 0.0)];
    super::reference(format!("fails/{what}/of-two-sessions"), &["NCP-SESS-035", "NCP-SESS-057"], trace)
        .title(format!("Two sessions whose {what} left the doubles go on each by itself."))
        .flags(&["session-lifecycle", "non-finite-numbers"])
        .because("What is done to one session changes no other; a request that fails leaves the network as it was.")
}

/// The values of ports to which a request that fails brings nothing.
fn failures_beside_a_current() -> Vec<Case> {
    let mut cases = Vec::new();
    for of in Overdriven::both() {
        let what = of.what;
        let (name, words, target) = match what {
            "rate" => ("same", "the same population", "pop"),
            _ => ("other", "another population", "other"),
        };
        let drive = |port: &str| stimulus(port, of.kind).with("target", target.into());
        let stimuli = vec![stimulus("in", of.kind), drive("x"), drive("y")];
        let open = Open { other: Some(1), ..of.open("a", stimuli) };
        let values = of.after(3, of.little);
        let steps = |request: String, from: usize, to: usize| {
            let times: Vec<f64> = (1_u32..).map(f64::from).skip(from).take(to - from).collect();
            let out = object! { "times" => nums(&times), "values" => nums(&values[from..to]) };
            (request, recorded("a", object! { "out" => out }))
        };
        let trace = vec![
            (open.text(), opened("a")),
            steps(driven_step("a", 1.0, &[("in", of.little)]), 0, 1),
            (driven_step("a", 40.0, &[("x", of.much), ("y", of.much)]), error()),
            steps(driven_step("a", 2.0, &[("x", 0.0), ("y", 0.0)]), 1, 3),
        ];
        let path = format!("fails/{what}/beside-a-stimulus/{name}");
        cases.push(
            super::reference(path, &["NCP-SESS-054", "NCP-SESS-057"], trace)
                .title(format!(
                    "A stimulus stays when a request fails that brings values for other ports, of {words} ({what})."
                ))
                .flags(&["session-lifecycle", "non-finite-numbers"])
                .because("A stimulus stays until another value for its port comes, which the one that fails lacks."),
        );
    }
    cases
}

/// Many requests that fail: none ends the session, and all of them together neither.
fn failures_without_number() -> Vec<Case> {
    const MANY: usize = 300;
    let too_much = Open { params: vec![("C_m", 1.0)], stimuli: vec![stimulus("in", "current_pA")], ..Open::lif("a") };
    let at_rest = || step_of("a", Some(1.0), Some(("in", 0.0)));
    let plain = || step_of("a", Some(1.0), None);
    type Row = (&'static str, &'static str, String, String, String);
    let table: [Row; 3] = [
        ("below-0", "steps of a time below 0", Open::lif("a").text(), step_of("a", Some(-1.0), None), plain()),
        ("nonsense", "texts that are no request", Open::lif("a").text(), "hello".to_owned(), plain()),
        (
            "overflow",
            "steps whose membrane leaves the doubles",
            too_much.text(),
            step_of("a", Some(10.0), Some(("in", -1.7e308))),
            at_rest(),
        ),
    ];
    let one = |(name, words, open, fails, then): Row| {
        let mut trace = vec![(open, opened("a")), (then.clone(), observed("a", 1.0))];
        trace.extend(std::iter::repeat_n((fails, error()), MANY));
        trace.extend([(then, observed("a", 2.0)), (close("a"), closed("a"))]);
        let (path, rules) = (format!("fails/many/{name}"), ["NCP-SESS-037", "NCP-SESS-027"]);
        match name {
            "overflow" => super::reference(path, &rules, trace),
            _ => case(path, &rules, trace),
        }
        .title(format!("A session goes on after {MANY} {words}, and is closed."))
        .flags(&["session-lifecycle"])
        .because("A request that fails costs that request only, however many fail.")
    };
    table.map(one).into()
}
