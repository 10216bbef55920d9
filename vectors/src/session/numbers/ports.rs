//! What the ports of a reference network give: which neurons, at which times, in which order and unit.

use super::neurons::next_rate;
use super::{driven_step, recorded_at, samples, sent, simulate};
use crate::case::Case;
use crate::json::{Json, object};
use crate::session::{Open, close, observed, opened, record, recorded, reference, run, step, stimulus};
use crate::trace::{anything, nums};

/// A port that is recorded and one that is a stimulus, under one name, and names of something else.
pub(super) fn shared_names() -> Vec<Case> {
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
pub(super) fn units() -> Vec<Case> {
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
pub(super) fn many_ports() -> Vec<Case> {
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

/// Many ports that are given their values one by one, each in a request of its own, in which the others keep theirs.
pub(super) fn many_by_turns() -> [Case; 2] {
    [70, 260].map(|count: u16| {
        let name = |nth: u16| format!("p{nth}");
        let open = Open {
            params: vec![("mu", 0.0)],
            records: vec![record("out", "rate", 1.0)],
            stimuli: (1..=count).map(|nth| stimulus(&name(nth), "rate_inject")).collect(),
            ..Open::rate("a")
        };
        let (mut rate, mut input) = (0.0, 0.0);
        let mut trace = vec![(open.text(), opened("a"))];
        for nth in 1..=count {
            input += f64::from(nth);
            next_rate(&mut rate, (-0.1_f64).exp(), input);
            let last = || object! { "out" => samples(&[f64::from(nth)], Some(&[rate])) };
            let reply = if nth == count { recorded("a", last()) } else { anything() };
            trace.push((step("a", Some(1.0), Some((&name(nth), f64::from(nth)))), reply));
        }
        reference(format!("port/many/{count}-by-turns"), &["NCP-SESS-054", "NCP-SESS-055"], trace)
            .title(format!("Each of {count} ports keeps the value that it was given while the others get theirs."))
            .because("A stimulus stays until another value for its port comes.")
    })
}

/// Many ports that are sampled at two cadences, so that each differs from those that a word of bits takes it for.
pub(super) fn many_cadences() -> Vec<Case> {
    let name = |nth: usize| format!("p{nth}");
    // By the bits of its number and how many there are: 0 and 64, 1 and 257 differ, and so do neighbours.
    let is_slow = |nth: usize| nth.count_ones() % 2 == 1;
    let times = |nth: usize| if is_slow(nth) { nums(&[2.0]) } else { nums(&[1.0, 2.0]) };
    let case = |count: usize| {
        let records = (0..count).map(|nth| record(&name(nth), "V_m", if is_slow(nth) { 2.0 } else { 1.0 })).collect();
        let observed = (0..count).map(|nth| (name(nth), object! { "times" => times(nth) })).collect();
        let open = Open { records, ..Open::lif("a") };
        let trace =
            vec![(open.text(), opened("a")), (step("a", Some(2.0), None), recorded("a", Json::Object(observed)))];
        reference(format!("cadence/of-{count}-ports"), &["NCP-SESS-053"], trace)
            .title(format!("Each of {count} ports is sampled at its own cadence, at every step or at every second."))
            .because("The backend samples a port at the end of every step that is a multiple of its own cadence.")
    };
    [70, 300].map(case).into()
}

/// Which ports come back.
pub(super) fn ports() -> Vec<Case> {
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

/// In which order samples come: by their times, and those of one time as the port names its neurons.
pub(super) fn orders() -> Vec<Case> {
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
    // Of the neurons that the port names only some spike: those that are driven.
    let downwards: Vec<u32> = (1..=300).rev().collect();
    for (named, driven_ones) in [
        (&[4_u32, 2, 1][..], &[1_u32, 4][..]),
        (&[3, 1, 4, 2], &[1, 2, 3]),
        (&[4, 1, 3, 2], &[4, 3]),
        (&downwards, &[7, 200, 201]),
    ] {
        let drive = object! { "port" => "in", "target" => "pop", "kind" => "current_pA",
        "ids" => driven_ones.iter().copied().collect::<Json>() };
        let size = named.iter().copied().max().unwrap_or(1);
        let open = Open { size, records: vec![of("spikes", named)], stimuli: vec![drive], ..Open::lif("a") };
        let spiking: Vec<u32> = named.iter().copied().filter(|id| driven_ones.contains(id)).collect();
        let name = |ids: &[u32]| match ids {
            [first, .., last] if ids.len() > 9 => format!("{first}-to-{last}"),
            ids => ids.iter().map(ToString::to_string).collect::<Vec<_>>().join("-"),
        };
        add(
            format!("spikes-of-some/{}-of-{}", name(&spiking), name(named)),
            "as the port names those that spike",
            open,
            step("a", Some(40.0), Some(("in", 500.0))),
            beats.iter().flat_map(|time| spiking.iter().map(|_| *time)).collect(),
            beats.iter().flat_map(|_| spiking.iter().copied()).collect(),
        );
    }
    cases
}

/// Ids that are no range, though their first step and their last id would fit one.
pub(super) fn nearly_ranges() -> Vec<Case> {
    let lists: [&[u32]; 6] =
        [&[1, 3, 4, 7], &[2, 4, 5, 8], &[9, 7, 6, 3], &[1, 4, 5, 7, 13], &[1, 2, 4, 3, 5], &[3, 4, 6, 5, 7, 8]];
    let of = |ids: &[u32]| {
        const SIZE: u32 = 13;
        let named = ids.iter().copied().collect::<Json>();
        let open = Open {
            size: SIZE,
            records: vec![record("v", "V_m", 1.0).with("ids", named.clone()), record("w", "V_m", 1.0)],
            stimuli: vec![stimulus("in", "current_pA").with("ids", named)],
            ..Open::lif("a")
        };
        let [rest, driven] = [0.0, 300.0].map(|current| simulate(&[], 1.0, 1, current).1[0]);
        let all: Vec<u32> = (1..=SIZE).collect();
        let potentials = |of: &[u32]| {
            let values: Vec<f64> = of.iter().map(|id| if ids.contains(id) { driven } else { rest }).collect();
            sent(&vec![1.0; of.len()], of).with("values", nums(&values))
        };
        let records = object! { "v" => potentials(ids), "w" => potentials(&all) };
        let trace =
            vec![(open.text(), opened("a")), (step("a", Some(1.0), Some(("in", 300.0))), recorded("a", records))];
        let name = ids.iter().map(ToString::to_string).collect::<Vec<_>>().join("-");
        reference(format!("id/nearly-a-range/{name}"), &["NCP-SESS-052", "NCP-SESS-055", "NCP-SESS-059"], trace)
            .title(format!("A port that names the neurons {name} reads and drives these and no others."))
            .because("The ids of a port are its neurons, each of them, in their order.")
    };
    lists.map(of).into()
}

/// Two ports that name the same neurons, each in an order of its own.
pub(super) fn orders_of_ports() -> Vec<Case> {
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
pub(super) fn cadences() -> Vec<Case> {
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
    for (dt, cadence, rounded) in [
        (1.0, 0.5, 1.0),
        (1.0, 2.5, 3.0),
        (1.0, 4.5, 5.0),
        (2.0, 5.0, 6.0),
        (0.5, 0.25, 0.5),
        (0.1, 0.15, 0.1),
        (0.1, 0.35, 0.3),
    ] {
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

/// What a server bears in a request, over and over: it is bounded by the request, and not by the session.
pub(super) fn many_samples() -> Case {
    let records = vec![record("s", "spikes", 1.0)];
    let open = Open { records, size: 100_000, ..Open::lif("a") };
    let mut trace = vec![(open.text(), opened("a"))];
    trace.extend((1..=12).map(|step| (run("a", 1.0), observed("a", f64::from(step)))));
    reference("far/samples/of-many-requests".to_owned(), &["NCP-SESS-027"], trace)
        .title("Twelve requests that may give 100,000 spikes each are answered, one after the other.")
        .because("A server bears a million samples in each request.")
}

/// Ports that are sampled rarely, in sessions that run for long.
pub(super) fn far_samples() -> Vec<Case> {
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
    // Samples so many that the times of a sum which goes on and on leave the grid.
    for (name, every, dt) in [("three-tenths", 3, 0.1), ("seven-tenths", 7, 0.1), ("thirds-of-2.1", 3, 0.7)] {
        const MANY: u32 = 60_000;
        let open = Open { records: ports("rate", every, dt), dt, ..Open::rate("a") };
        let mut trace = vec![(open.text(), opened("a"))];
        for steps in [MANY, 2 * MANY] {
            trace.push((run("a", f64::from(MANY) * dt), observed("a", f64::from(steps) * dt)));
        }
        let times = multiples(every, 2 * MANY, 2 * MANY + 10, dt);
        trace.push((run("a", 10.0 * dt), recorded("a", at("out", &times))));
        cases.push(
            reference(format!("far/cadence/often/{name}"), &["NCP-SESS-053"], trace)
                .title(format!(
                    "A port of a cadence of {every} steps of {dt} ms is sampled at its multiples behind 120,000 steps."
                ))
                .because(why),
        );
    }
    // Three ports, whose cadences come together once in sixty steps.
    let cadences = [("a", 4_u32), ("b", 3), ("c", 5)];
    let records = cadences.map(|(port, every)| record(port, "V_m", f64::from(every)));
    let open = Open { records: records.to_vec(), ..Open::lif("a") };
    let all =
        cadences.map(|(port, every)| (port.to_owned(), object! { "times" => nums(&multiples(every, 0, 70, 1.0)) }));
    cases.push(
        reference(
            "far/cadence/three-ports".to_owned(),
            &["NCP-SESS-053"],
            vec![(open.text(), opened("a")), (run("a", 70.0), recorded("a", Json::Object(all.to_vec())))],
        )
        .title("Three ports are sampled each by its own cadence over 70 steps.")
        .because(why),
    );
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

/// Cadences of more steps than 32 bits count.
pub(super) fn beyond_32_bits() -> Vec<Case> {
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

/// Populations of no neuron, and sessions without neurons.
pub(super) fn no_neurons() -> Vec<Case> {
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
pub(super) fn empty_names() -> Vec<Case> {
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
pub(super) fn many_named() -> Vec<Case> {
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

/// Names that are equal once they are joined with what stands beside them: of a population with the id of a neuron, of
/// a population with a port, of a session with a port.
pub(super) fn joined_names() -> Vec<Case> {
    let ids = |of: u32| std::iter::once(of).collect::<Json>();
    let of = |of: Json, target: &str| of.with("target", target.into());
    let sized = |open: Open, sizes: Json| open.json().edit(&["network", "population_sizes"], |_| sizes).text();
    // A current that makes a neuron spike in its first step.
    let strong = 10_000.0;
    let neuron = |driven: &str, id: u32| {
        let open = Open {
            records: [("s", "e", "spikes"), ("s1", "e1", "spikes")]
                .map(|(port, target, observable)| of(record(port, observable, 1.0), target))
                .into(),
            stimuli: vec![of(stimulus("in", "current_pA"), driven).with("ids", ids(id))],
            ..Open::lif("a")
        };
        let spikes = |target: &str| if target == driven { sent(&[1.0], &[id]) } else { sent(&[], &[]) };
        let records = object! { "s" => spikes("e"), "s1" => spikes("e1") };
        let trace = vec![
            (sized(open, object! { "e" => 11_u32, "e1" => 1_u32 }), opened("a")),
            (step("a", Some(1.0), Some(("in", strong))), recorded("a", records)),
        ];
        reference(format!("joined-names/{driven}-{id}"), &["NCP-SESS-052", "NCP-SESS-050"], trace)
            .title(format!("Neuron {id} of the population `{driven}` spikes, and none of another population."))
            .because("A neuron's id is its position within its population: 11 of `e` is not 1 of `e1`.")
    };
    let after = |current: f64| object! { "values" => nums(&[simulate(&[], 1.0, 1, current).1[0]]) };
    let open = Open {
        records: vec![of(record("qr", "V_m", 1.0), "p"), of(record("r", "V_m", 1.0), "pq")],
        stimuli: vec![of(stimulus("qr", "current_pA"), "p"), of(stimulus("r", "current_pA"), "pq")],
        ..Open::lif("a")
    };
    let port = reference(
        "joined-names/populations-and-ports".to_owned(),
        &["NCP-SESS-055", "NCP-SESS-038"],
        vec![
            (sized(open, object! { "p" => 1_u32, "pq" => 1_u32 }), opened("a")),
            (
                driven_step("a", 1.0, &[("qr", 300.0), ("r", 100.0)]),
                recorded("a", object! { "qr" => after(300.0), "r" => after(100.0) }),
            ),
        ],
    )
    .title("The port `qr` of the population `p` and the port `r` of the population `pq` are two.")
    .because("A port has the name that it was given, whatever the name of its target.");
    let session = |id: &str, port: &str| {
        let records = vec![record(port, "V_m", 1.0)];
        Open { records, stimuli: vec![stimulus(port, "current_pA")], ..Open::lif(id) }.text()
    };
    let shows = |port: &str, current: f64| Json::Object(vec![(port.to_owned(), after(current))]);
    let sessions = reference(
        "joined-names/sessions-and-ports".to_owned(),
        &["NCP-SESS-035", "NCP-SESS-038"],
        vec![
            (session("a", "bc"), opened("a")),
            (session("ab", "c"), opened("ab")),
            (step("a", Some(1.0), Some(("bc", 300.0))), recorded("a", shows("bc", 300.0))),
            (step("ab", Some(1.0), Some(("c", 100.0))), recorded("ab", shows("c", 100.0))),
        ],
    )
    .title("The port `bc` of the session `a` and the port `c` of the session `ab` are two.")
    .because("Sessions are kept apart, and so are their ports.");
    vec![neuron("e", 11), neuron("e1", 1), port, sessions]
}

/// Sessions of one network that record and are driven by other ports.
pub(super) fn own_ports() -> Vec<Case> {
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
                (close("a"), crate::trace::anything()),
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

/// Requests that come to no step: each port comes back, and has no sample.
pub(super) fn of_no_step() -> Vec<Case> {
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
    // What two such requests give to two ports acts together in the next step.
    let open = Open {
        records: vec![record("v", "V_m", 1.0)],
        stimuli: vec![stimulus("i", "current_pA"), stimulus("k", "current_pA")],
        ..Open::lif("a")
    };
    let after = simulate(&[], 1.0, 1, 350.0).1;
    let none = || object! { "v" => object! { "times" => nums(&[]) } };
    let trace = vec![
        (open.text(), opened("a")),
        (step("a", Some(0.25), Some(("i", 250.0))), recorded_at("a", 0.0, none())),
        (step("a", Some(0.25), Some(("k", 100.0))), recorded_at("a", 0.0, none())),
        (step("a", Some(1.0), None), recorded_at("a", 1.0, object! { "v" => samples(&[1.0], Some(&after)) })),
    ];
    cases.push(
        reference("no-step/of-two-ports".to_owned(), &["NCP-SESS-054", "NCP-SESS-058"], trace)
            .title("What two requests of no step give to two ports acts in the next step.")
            .because("The stimulus of a request that comes to no step acts from the next step on, and stays."),
    );
    cases
}

/// Ports of one population that name other neurons, as many of them: each has the samples of its own.
pub(super) fn own_neurons() -> Vec<Case> {
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
