//! What drives the neurons of the reference networks: which value acts from when on, on which of them.

use super::{Lif, WHY, driven_step, samples, sent, simulate};
use crate::case::Case;
use crate::json::{Json, object};
use crate::session::{Open, observation, observed, opened, record, recorded, reference, run, step, stimulus};
use crate::trace::nums;

/// A stimulus acts from the first step of its request, and stays.
pub(super) fn stimuli() -> Vec<Case> {
    let mut cases = currents();
    cases.push(current_of_no_step());
    cases.extend(currents_behind_no_step());
    cases.extend(of_one_sum());
    cases.push(of_one_sum_at_rest());
    cases.extend(frames_of_no_port());
    cases
}

/// One neuron under a current that a few requests set, one after the other.
fn currents() -> Vec<Case> {
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
    cases
}

/// Neurons that different currents set apart, and that then get one and the same: each goes on from where it is.
pub(super) fn apart_then_alike() -> [Case; 3] {
    [3, 70, 300].map(|size: u32| {
        let ids = |ids: &[u32]| ids.iter().copied().collect::<Json>();
        let open = Open {
            size,
            records: vec![record("v", "V_m", 5.0).with("ids", ids(&[1, 2, size]))],
            stimuli: [("first", 1), ("last", size)]
                .map(|(port, id)| stimulus(port, "current_pA").with("ids", ids(&[id])))
                .into(),
            ..Open::lif("a")
        };
        let mut neurons = [Lif::new(&[], 1.0), Lif::new(&[], 1.0), Lif::new(&[], 1.0)];
        let mut trace = vec![(open.text(), opened("a"))];
        for (chunk, [first, last]) in (1..).zip([[300.0, -100.0], [0.0, 0.0], [0.0, 200.0], [200.0, 200.0], [0.0, 0.0]])
        {
            for _ in 0..5 {
                neurons.iter_mut().zip([first, 0.0, last]).for_each(|(neuron, current)| _ = neuron.step(current));
            }
            let times = [5.0 * f64::from(chunk); 3];
            let potentials: Vec<f64> = neurons.iter().map(|neuron| neuron.v).collect();
            let observed = recorded("a", object! { "v" => samples(&times, Some(&potentials)) });
            trace.push((driven_step("a", 5.0, &[("first", first), ("last", last)]), observed));
        }
        reference(format!("stimulus/apart-then-alike/of-{size}"), &["NCP-SESS-050", "NCP-SESS-055"], trace)
            .title(format!("Of {size} neurons that currents set apart, each goes on from where it is."))
            .because(WHY)
    })
}

/// A request of a quarter of a step runs none, and its value stays.
fn current_of_no_step() -> Case {
    let open =
        Open { records: vec![record("v", "V_m", 1.0)], stimuli: vec![stimulus("in", "current_pA")], ..Open::lif("a") };
    let (times, values, _) = simulate(&[], 1.0, 5, 300.0);
    let trace = vec![
        (open.text(), opened("a")),
        (step("a", Some(0.25), Some(("in", 300.0))), observed("a", 0.0)),
        (step("a", Some(5.0), None), recorded("a", object! { "v" => samples(&times, Some(&values)) })),
    ];
    reference("stimulus/of-no-step".to_owned(), &["NCP-SESS-054", "NCP-SESS-058"], trace)
        .title("A current that comes with a request of no step acts from the next step.")
        .because(WHY)
}

/// Currents that come with a request of no step, before others for the same port and for another.
fn currents_behind_no_step() -> [Case; 2] {
    let open = || Open {
        records: vec![record("v", "V_m", 1.0)],
        stimuli: vec![stimulus("in", "current_pA"), stimulus("more", "current_pA")],
        ..Open::lif("a")
    };
    let case = |(name, port, current, words): (&str, &str, f64, &str)| {
        let (times, values, _) = simulate(&[], 1.0, 5, current);
        let trace = vec![
            (open().text(), opened("a")),
            (step("a", Some(0.25), Some(("in", 300.0))), observed("a", 0.0)),
            (
                step("a", Some(5.0), Some((port, 100.0))),
                recorded("a", object! { "v" => samples(&times, Some(&values)) }),
            ),
        ];
        reference(format!("stimulus/behind-no-step/{name}"), &["NCP-SESS-054", "NCP-SESS-036"], trace)
            .title(format!("A current that comes behind one with a request of no step {words}."))
            .because(WHY)
    };
    [("same-port", "in", 100.0, "takes its place"), ("another-port", "more", 400.0, "for another port acts beside it")]
        .map(case)
}

/// Two neurons, each with a port that drives it and one that records it so often.
fn two_neurons(cadence_ms: f64) -> Open {
    let ids = |id: u32| std::iter::once(id).collect::<Json>();
    let drive = |port: &str, id| stimulus(port, "current_pA").with("ids", ids(id));
    let record = |port: &str, id| record(port, "V_m", cadence_ms).with("ids", ids(id));
    Open {
        size: 2,
        records: vec![record("v", 1), record("w", 2)],
        stimuli: vec![drive("x", 1), drive("y", 2)],
        ..Open::lif("a")
    }
}

/// Values that add up as before, and drive other neurons.
fn of_one_sum() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, second) in [("swapped", [-100.0, 300.0]), ("turned", [100.0, 100.0]), ("to-nothing", [200.0, 0.0])] {
        let mut neurons = [Lif::new(&[], 1.0), Lif::new(&[], 1.0)];
        let mut trace = vec![(two_neurons(1.0).text(), opened("a"))];
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
    cases
}

/// Neurons that have come to rest, and whose values then change places.
fn of_one_sum_at_rest() -> Case {
    const EVERY: u32 = 250;
    let mut neurons = [Lif::new(&[], 1.0), Lif::new(&[], 1.0)];
    let mut trace = vec![(two_neurons(f64::from(EVERY)).text(), opened("a"))];
    let mut time = 0;
    for (samples_each, currents) in [(4, [300.0, -100.0]), (2, [-100.0, 300.0]), (2, [100.0, 100.0])] {
        let (mut times, mut potentials) = (Vec::new(), [Vec::new(), Vec::new()]);
        for _ in 0..samples_each {
            time += EVERY;
            times.push(f64::from(time));
            for ((neuron, current), potentials) in neurons.iter_mut().zip(currents).zip(&mut potentials) {
                for _ in 0..EVERY {
                    neuron.step(current);
                }
                potentials.push(neuron.v);
            }
        }
        let [v, w] = potentials.map(|potentials| samples(&times, Some(&potentials)));
        let asked = driven_step("a", f64::from(samples_each * EVERY), &[("x", currents[0]), ("y", currents[1])]);
        trace.push((asked, recorded("a", object! { "v" => v, "w" => w.without("senders") })));
    }
    reference("stimulus/of-one-sum/at-rest".to_owned(), &["NCP-SESS-054", "NCP-SESS-050"], trace)
        .title("Two ports whose values are swapped drive their own neurons, also those that have come to rest.")
        .because("The last value of each port drives the neurons of its target, whatever all of them add up to.")
}

/// A stimulus frame that names no port changes none.
fn frames_of_no_port() -> Vec<Case> {
    let mut cases = Vec::new();
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
    cases
}

/// Which neurons a stimulus reaches: two of a population of three, or one population of two.
pub(super) fn reach() -> Vec<Case> {
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

/// Long lists of ids whose ends and length are those of a run, and which are none.
pub(super) fn nearly_runs() -> Vec<Case> {
    let after = |current: f64| simulate(&[], 1.0, 5, current).1.last().copied().unwrap_or_default();
    let list = |ids: &[u32]| ids.iter().copied().collect::<Json>();
    let case = |length: u32| {
        // The second of them lies beyond the last.
        let far = length + 10;
        let ids: Vec<u32> = (1..=length).map(|id| if id == 2 { far } else { id }).collect();
        let asked = [1, 2, 3, length, length + 1, far];
        let open = Open {
            size: far,
            records: vec![record("v", "V_m", 5.0).with("ids", list(&asked))],
            stimuli: vec![stimulus("in", "current_pA").with("ids", list(&ids))],
            ..Open::lif("a")
        };
        let values = asked.map(|id| after(if ids.contains(&id) { 300.0 } else { 0.0 }));
        let v = object! { "values" => nums(&values), "senders" => list(&asked) };
        let trace = vec![
            (open.text(), opened("a")),
            (step("a", Some(5.0), Some(("in", 300.0))), recorded("a", object! { "v" => v })),
        ];
        reference(format!("reach/nearly-a-run/{length}"), &["NCP-SESS-055", "NCP-SESS-052"], trace)
            .title(format!(
                "A stimulus of {length} ids from 1 to {length}, of which one is {far} and none is 2, reaches just \
                 those."
            ))
            .because("A stimulus reaches each of the neurons that its `ids` name, and no others.")
    };
    [3, 8, 40, 300].map(case).into()
}

/// A stimulus stays however many requests come without one, and however long they run.
pub(super) fn lasting() -> Vec<Case> {
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
        let values = object! { "in" => object! { "data" => nums(&[300.0]) } };
        let brought = Json::read(&run("a", 5.0)).with("stimulus", object! { "values" => values }).text();
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
    add("over-time/two-days", "over two days of simulation time", {
        const HALF: f64 = 43_200_000.0;
        let at_each_half = Open { records: vec![record("v", "V_m", HALF)], dt: 1_000.0, ..driven(&["in"]) };
        let (_, values, _) = simulate(&[], 1_000.0, 10, 300.0);
        // Within a step of a second a neuron is where its current leads.
        let observed = |halves: [f64; 2]| {
            let led = values.last().copied().unwrap_or_default();
            recorded("a", object! { "v" => samples(&halves.map(|nth| nth * HALF), Some(&[led; 2])) })
        };
        vec![
            (at_each_half.text(), opened("a")),
            (step("a", Some(2.0 * HALF), Some(("in", 300.0))), observed([1.0, 2.0])),
            (run("a", 2.0 * HALF), observed([3.0, 4.0])),
        ]
    });
    cases
}

/// Neurons whose ids have more bits than 8, 9, 10 and 12, and those that share the lower ones.
pub(super) fn neurons_by_bits() -> Vec<Case> {
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

/// What all ports give a neuron, and its own current: they add up, and none stands for another.
pub(super) fn sums() -> Vec<Case> {
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

/// Neurons whose ids do not fit a small integer: none stands for another.
pub(super) fn far_neurons() -> Vec<Case> {
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
