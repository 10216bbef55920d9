//! Sessions of reference networks side by side and one behind the other, and those that are not opened.

use super::neurons::next_rate;
use super::{WHY, driven_step, recorded_at, samples, sent, simulate};
use crate::case::Case;
use crate::json::{Json, object};
use crate::names::{self, LONG_NAMES};
use crate::session::{
    Open, close, error, not_opened, observation, observed, opened, record, recorded, reference, replies, run, step,
    stimulus,
};
use crate::trace::{any, anything, exactly, nums};

/// Networks whose parameters have the same values under other names are others.
pub(super) fn same_values() -> Case {
    let opens = |id, name| (driven(id, &[(name, 20.0)]).text(), opened(id));
    let steps =
        |id, name| (step(id, None, Some(("in", 300.0))), recorded(id, behind_ten_steps(&[(name, 20.0)], 300.0)));
    let trace = vec![opens("a", "tau_m"), opens("b", "t_ref"), steps("a", "tau_m"), steps("b", "t_ref")];
    reference("params/apart".to_owned(), &["NCP-SESS-035", "NCP-SESS-050"], trace)
        .title("A parameter of one session is not that of another with the same value.")
        .because(WHY)
}

/// Each session has its own input.
pub(super) fn own_input() -> Case {
    let trace = vec![
        (driven("a", &[]).text(), opened("a")),
        (driven("b", &[]).text(), opened("b")),
        (step("a", None, Some(("in", 200.0))), recorded("a", behind_ten_steps(&[], 200.0))),
        (step("b", None, None), recorded("b", behind_ten_steps(&[], 0.0))),
    ];
    reference("stimulus/apart".to_owned(), &["NCP-SESS-035", "NCP-SESS-054"], trace)
        .title("A current into one session does not reach another.")
        .because("What is done to one session changes no other.")
}

/// Networks whose parameters have swapped their values are others: side by side, and one behind the other.
pub(super) fn swapped() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, [one, two], [x, y]) in [
        ("leak-and-reset", ["E_L", "V_reset"], [-70.0, -64.0]),
        ("capacity-and-time-constant", ["C_m", "tau_m"], [40.0, 20.0]),
        ("time-constant-and-refractory-time", ["tau_m", "t_ref"], [5.0, 8.0]),
    ] {
        let (p, q) = ([(one, x), (two, y)], [(one, y), (two, x)]);
        let opens = |id: &str, params: [_; 2]| (driven(id, &params).text(), opened(id));
        let steps = |id: &str, params: [_; 2]| {
            (step(id, None, Some(("in", 30.0))), recorded(id, behind_ten_steps(&params, 30.0)))
        };
        for (how, words, trace) in [
            ("apart", "in two sessions", vec![opens("a", p), opens("b", q), steps("b", q), steps("a", p)]),
            (
                "anew",
                "in a session that is opened anew",
                vec![opens("a", p), steps("a", p), (close("a"), anything()), opens("a", q), steps("a", q)],
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
pub(super) fn reopened() -> Vec<Case> {
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
        let closes = |id: &str| (close(id), anything());
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

/// What the networks should not be opened with. A session that could be opened takes its place.
pub(super) fn refusals() -> Vec<Case> {
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

/// Names that are the same when they are written together, or that look alike: each is itself.
pub(super) fn alike() -> Vec<Case> {
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
    type Row<'a> = (&'static str, &'a [(&'a str, u32)], [(&'a str, u32); 2], &'static str);
    let long = LONG_NAMES.map(|name| (name, 1));
    let table: [Row<'_>; 8] = [
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
        ("names-of-1024", &long, long, "NCP-SESS-055"),
        ("names-of-1024-turned", &long, [long[1], long[0]], "NCP-SESS-055"),
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
                .title(if driven.0.len() > 64 {
                    format!(
                        "A current into one of two populations whose long names begin alike does not reach the other \
                         ({}).",
                        name.replace('-', " ")
                    )
                } else {
                    format!(
                        "A current into neuron {} of `{}` does not reach neuron {} of `{}`.",
                        driven.1, driven.0, other.1, other.0
                    )
                })
                .because(
                    "A stimulus reaches the neurons of its target that its `ids` name, and no others, whatever they \
                     are called.",
                ),
        );
    }
    cases
}

/// Sessions of which one id is the beginning of the other, up to what may stand between the parts of a path.
pub(super) fn ids_within() -> Vec<Case> {
    let after = simulate(&[], 1.0, 5, 0.0).1.last().copied().unwrap_or_default();
    let case = |(name, between): (&str, &str)| {
        let (one, other) = ("uav", format!("uav{between}left"));
        let open = |id: &str, port: &str| {
            let open = Open { records: vec![record(port, "V_m", 5.0)], ..Open::lif(id) };
            (open.text(), opened(id))
        };
        let records = |port: &str| exactly(object! { port => samples(&[5.0], Some(&[after])) });
        let steps = |id: &str, port: &str| (step(id, Some(5.0), None), recorded(id, records(port)));
        let trace = vec![open(one, "v"), open(&other, "w"), steps(&other, "w"), steps(one, "v")];
        reference(format!("alike/ids-within/{name}"), &["NCP-SESS-038", "NCP-SESS-035"], trace)
            .title(format!("The observations of the session `{one}` have no port of the session `{other}`."))
            .because("An observation has the ports of its own session, whose id is its letters.")
    };
    [("dot", "."), ("hyphen", "-"), ("colon", ":"), ("underscore", "_"), ("comma", ","), ("bar", "|"), ("letters", "x")]
        .map(case)
        .into()
}

/// A stimulus port that has the name of a recorded one: each has the neurons that it names.
pub(super) fn one_name_both_ways() -> [Case; 2] {
    let ids = |of: &[u32]| of.iter().copied().collect::<Json>();
    let after = |current: f64| simulate(&[], 1.0, 5, current).1.last().copied().unwrap_or_default();
    [("driven", [2], [1, 3], [0.0, 0.0]), ("recorded", [1], [1, 2], [300.0, 0.0])].map(
        |(name, driven, recorded_ids, currents)| {
            let open = Open {
                size: 3,
                records: vec![record("x", "V_m", 5.0).with("ids", ids(&recorded_ids))],
                stimuli: vec![stimulus("x", "current_pA").with("ids", ids(&driven))],
                ..Open::lif("a")
            };
            let x = object! { "values" => nums(&currents.map(after)), "senders" => ids(&recorded_ids) };
            let trace = vec![
                (open.text(), opened("a")),
                (step("a", Some(5.0), Some(("x", 300.0))), recorded("a", object! { "x" => x })),
            ];
            reference(format!("alike/one-name/{name}"), &["NCP-SESS-055", "NCP-SESS-052"], trace)
                .title(format!(
                    "A current into neuron {} by a port that has the name of a recorded one, of neurons {} and {}, \
                     reaches no other.",
                    driven[0], recorded_ids[0], recorded_ids[1]
                ))
                .because("A port of a stimulus and one of a record have each the neurons that it names.")
        },
    )
}

/// Populations, and ports, of all names that are alike: each has a current of its own.
pub(super) fn of_all_names() -> [Case; 2] {
    let all: Vec<&str> = names::alike().map(|(name, _)| name).collect();
    let numbers = || 1_u32..=u32::try_from(all.len()).unwrap_or(0);
    let current = |nth: u32| f64::from(nth) * 4.0;
    let after = |nth: u32| simulate(&[], 1.0, 5, current(nth)).1.last().copied().unwrap_or_default();
    let ids = |id: u32| std::iter::once(id).collect::<Json>();
    let open = |sizes: Json, port_of: &dyn Fn(u32) -> String, target_of: &dyn Fn(u32) -> (String, u32)| {
        let at = |port: Json, nth: u32| {
            let (target, id) = target_of(nth);
            port.with("target", target.into()).with("ids", ids(id))
        };
        let open = Open {
            records: numbers().map(|nth| at(record(&port_of(nth), "V_m", 5.0), nth)).collect(),
            stimuli: numbers().map(|nth| at(stimulus(&port_of(nth), "current_pA"), nth)).collect(),
            ..Open::lif("a")
        };
        open.json().edit(&["network", "population_sizes"], |_| sizes).text()
    };
    let name = |nth: u32| all.get(nth as usize - 1).copied().unwrap_or_default().to_owned();
    let numbered = |nth: u32| format!("p{nth}");
    let of_one = all.iter().map(|name| ((*name).to_owned(), Json::from(1_u32))).collect();
    let populations = open(Json::Object(of_one), &numbered, &|nth| (name(nth), 1));
    let ports = open(object! { "pop" => u32::try_from(all.len()).unwrap_or(0) }, &name, &|nth| ("pop".to_owned(), nth));
    let driven = |port_of: &dyn Fn(u32) -> String| {
        let port_of: Vec<(String, f64)> = numbers().map(|nth| (port_of(nth), current(nth))).collect();
        let values: Vec<(&str, f64)> = port_of.iter().map(|(port, current)| (port.as_str(), *current)).collect();
        driven_step("a", 5.0, &values)
    };
    let observed = |port_of: &dyn Fn(u32) -> String| {
        let records = numbers().map(|nth| (port_of(nth), object! { "values" => nums(&[after(nth)]) }));
        recorded("a", Json::Object(records.collect()))
    };
    [
        ("populations", populations, driven(&numbered), observed(&numbered), "NCP-SESS-055"),
        ("ports", ports, driven(&name), observed(&name), "NCP-SESS-054"),
    ]
    .map(|(what, open, step, reply, rule)| {
        reference(format!("alike/{what}/all"), &[rule], vec![(open, opened("a")), (step, reply)])
            .title(format!("Each of {} {what} whose names are alike has a current of its own.", all.len()))
            .because(
                "A stimulus reaches the neurons of its target that its `ids` name, and no others, whatever they are \
                 called.",
            )
    })
}

/// What a server bears in one request, and what it may refuse.
pub(super) fn much_at_once() -> Vec<Case> {
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
    // Ports whose next sample is later than the request, which would be too many if each gave one.
    let (size, steps, every) = (100_000_u32, 9_u32, 10_u32);
    let records = (0..12).map(|nth| record(&format!("p{nth}"), "V_m", f64::from(every))).collect();
    let open = Open { size, records, ..Open::lif("a") };
    let trace = vec![(open.text(), opened("a")), (run("a", f64::from(steps)), observed("a", f64::from(steps)))];
    cases.push(
        reference("far/samples/of-ports-not-due".to_owned(), &["NCP-SESS-027", "NCP-SESS-053"], trace)
            .title(format!(
                "A run of {steps} steps in which twelve ports of {size} neurons have no sample is answered."
            ))
            .because("A server bears a million samples in each request, and a sample is one by the cadence."),
    );
    // A port of one neuron at every step, beside one of all that has no sample yet.
    let (size, steps) = (50_000_u32, 300_u32);
    let one = record("one", "V_m", 1.0).with("ids", std::iter::once(1).collect::<Json>());
    let open = Open { size, records: vec![one, record("all", "V_m", 1_000.0)], ..Open::lif("a") };
    let trace = vec![(open.text(), opened("a")), (run("a", f64::from(steps)), observed("a", f64::from(steps)))];
    cases.push(
        reference("far/samples/of-one-beside-many".to_owned(), &["NCP-SESS-027", "NCP-SESS-053"], trace)
            .title(format!("A run of {steps} steps in which one neuron of {size} is sampled at each is answered."))
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
    let answers = |trace: Vec<(String, Json)>| replies(trace.into_iter().map(|(_, reply)| reply).collect());
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

/// Neurons that rest while a request fails, for what is asked of another population.
pub(super) fn failures_at_rest() -> Vec<Case> {
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
pub(super) fn large_together() -> Vec<Case> {
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

/// Sessions of a mode and a length that say what the client is about to do.
pub(super) fn announced() -> Vec<Case> {
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

/// A session that is opened under the id of one that has ended, and otherwise than it.
pub(super) fn opened_otherwise() -> Vec<Case> {
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
            (close("a"), anything()),
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
pub(super) fn room() -> Vec<Case> {
    const WHY: &str = "A server bears up to 100,000 neurons in a session; what a session took is free when it ends.";
    let large = |id: &str| Open { size: 60_000, ..Open::lif(id) };
    let opens = |id: &str| (large(id).text(), opened(id));
    let runs = |id: &str| (step(id, Some(1.0), None), observed(id, 1.0));
    let closes = |id: &str| (close(id), anything());
    // The second has the id of the first.
    let one_by_one = ["a", "a", "b"].iter().flat_map(|id| [opens(id), runs(id), closes(id)]).collect();
    // Two ports of one name, for which it should be refused.
    let twice = Open { records: vec![record("v", "V_m", 1.0), record("v", "V_m", 1.0)], ..large("a") };
    let refused = || [(twice.text(), anything()), closes("a")];
    let behind_refused = [refused(), refused()].into_iter().flatten().chain([opens("a"), runs("a")]).collect();
    // Each is closed while a small one is open; a server that has room for one refuses that.
    let whole = |id: &str| Open { size: 100_000, ..Open::lif(id) };
    let round = || [(whole("a").text(), anything()), (Open::lif("b").text(), anything()), closes("a"), closes("b")];
    let mut in_turn = vec![(whole("a").text(), opened("a")), closes("a")];
    in_turn.extend(std::iter::repeat_with(round).take(12).flatten());
    in_turn.extend([(whole("c").text(), opened("c")), runs("c")]);
    [
        ("in-turn", "behind twelve others that each ended before a small one", in_turn),
        ("ended", "behind two others that have ended", one_by_one),
        ("refused", "behind two that were refused", behind_refused),
    ]
    .into_iter()
    .map(|(name, words, trace)| {
        reference(format!("far/room/{name}"), &["NCP-SESS-050", "NCP-SESS-028"], trace)
            .title(format!("A large session is opened {words}."))
            .because(WHY)
    })
    .collect()
}

/// A neuron that is driven at the port `in`, and whose potential is recorded every ten steps.
fn driven(id: &str, params: &[(&'static str, f64)]) -> Open {
    Open {
        params: params.to_vec(),
        records: vec![record("v", "V_m", 10.0)],
        stimuli: vec![stimulus("in", "current_pA")],
        ..Open::lif(id)
    }
}

/// What is recorded of it at the end of its first ten steps, under a current.
fn behind_ten_steps(params: &[(&str, f64)], current: f64) -> Json {
    let (times, values, _) = simulate(params, 1.0, 10, current);
    let last = |all: &[f64]| all.last().copied().unwrap_or_default();
    object! { "v" => samples(&[last(&times)], Some(&[last(&values)])) }
}
