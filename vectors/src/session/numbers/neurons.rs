//! What a neuron of the reference networks does: its potential, its spikes, its rests and its rate.

use super::{Params, WHY, driven_step, samples, sent, simulate, small_samples};
use crate::case::Case;
use crate::json::{Json, object};
use crate::session::{Open, observation, opened, record, recorded, reference, run, step, stimulus};

pub(super) fn networks() -> Vec<(&'static str, Params)> {
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
        // At its first step, though its current leads below the threshold.
        ("leak-above-threshold", vec![("E_L", -50.0), ("I_e", -500.0)]),
        ("leak-and-reset-above-threshold", vec![("E_L", -50.0), ("V_reset", -50.0), ("I_e", -500.0)]),
        ("other-levels", vec![("E_L", -65.0), ("V_th", -50.0), ("V_reset", -75.0), ("I_e", 450.0)]),
    ]
}

pub(super) fn current(params: &[(&str, f64)]) -> f64 {
    params.iter().find(|(name, _)| *name == "I_e").map_or(0.0, |(_, value)| *value)
}

pub(super) fn potentials() -> Vec<Case> {
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
pub(super) fn thresholds() -> Vec<Case> {
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

pub(super) fn spikes() -> Vec<Case> {
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

/// Two populations whose neurons have the same ids, of which one spikes.
pub(super) fn spikes_apart() -> Vec<Case> {
    let ports = |first: &str, second: &str| {
        let of = |port: &str, target: &str| record(port, "spikes", 1.0).with("target", target.into());
        vec![of("s", first), of("w", second)]
    };
    let (_, _, spikes) = simulate(&[], 1.0, 20, 1000.0);
    let twice: Vec<f64> = spikes.iter().flat_map(|time| [*time, *time]).collect();
    let senders: Vec<u32> = spikes.iter().flat_map(|_| [1, 2]).collect();
    let one = |driven: &str, first: &str, second: &str| {
        let open = Open {
            size: 2,
            other: Some(2),
            records: ports(first, second),
            stimuli: vec![stimulus("in", "current_pA").with("target", driven.into())],
            ..Open::lif("a")
        };
        let of = |target: &str| if target == driven { sent(&twice, &senders) } else { sent(&[], &[]) };
        let records = object! { "s" => of(first), "w" => of(second) };
        let trace =
            vec![(open.text(), opened("a")), (step("a", Some(20.0), Some(("in", 1000.0))), recorded("a", records))];
        reference(format!("spikes/apart/{driven}-of-{first}-{second}"), &["NCP-SESS-052", "NCP-SESS-050"], trace)
            .title(format!("Ports of `{first}` and `{second}` have the spikes of their own, where `{driven}` spikes."))
            .because("A port observes the neurons of its own target, whatever ids those of others have.")
    };
    [("pop", "pop", "other"), ("pop", "other", "pop"), ("other", "pop", "other"), ("other", "other", "pop")]
        .map(|(driven, first, second)| one(driven, first, second))
        .into()
}

/// Requests that begin while a neuron rests.
pub(super) fn rests() -> Vec<Case> {
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

pub(super) fn rates() -> Vec<Case> {
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

/// Spikes that come late, and neurons that rest for long.
pub(super) fn far_spikes() -> Vec<Case> {
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

/// Rests of so few steps that spikes come often, late in a session of long steps.
pub(super) fn late_rests() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, dt) in [("hours", 12_345.67), ("weeks", 1e9 / 7.0)] {
        let params = vec![("t_ref", 3.0 * dt), ("I_e", 5_000.0)];
        let (_, _, spikes) = simulate(&params, dt, 300, 5_000.0);
        let open = Open { params, dt, records: vec![record("s", "spikes", dt)], ..Open::lif("a") };
        let request = run("a", 300.0 * dt);
        let expected = recorded("a", object! { "s" => samples(&spikes, None) });
        cases.push(
            reference(
                format!("far/rests/{name}"),
                &["NCP-SESS-050"],
                vec![(open.text(), opened("a")), (request, expected)],
            )
            .title(format!(
                "A neuron that rests for three steps of {dt} ms spikes at every fourth, also late ({name})."
            ))
            .because(WHY),
        );
    }
    cases
}

/// A neuron that rests at the potential of another, which does not, under the same current.
pub(super) fn rests_beside() -> Case {
    let ids = |id: u32| std::iter::once(id).collect::<Json>();
    let drive = |port: &str, id| stimulus(port, "current_pA").with("ids", ids(id));
    let open = Open {
        size: 2,
        records: vec![record("s", "spikes", 1.0)],
        stimuli: vec![drive("x", 1), drive("y", 2)],
        ..Open::lif("a")
    };
    let spike = |time: f64, sender: u32| recorded("a", object! { "s" => sent(&[time], &[sender]) });
    let none = recorded("a", object! { "s" => samples(&[], None) });
    let both = |much: f64| driven_step("a", 1.0, &[("x", much), ("y", much)]);
    // The first spikes and is put back to where the second rests; then both have the same current, and none.
    let trace = vec![
        (open.text(), opened("a")),
        (driven_step("a", 1.0, &[("x", 1e5), ("y", 0.0)]), spike(1.0, 1)),
        (both(1e5), spike(2.0, 2)),
        (both(0.0), none),
        (both(1e5), spike(4.0, 1)),
        (both(1e5), spike(5.0, 2)),
    ];
    reference("rest/beside-another".to_owned(), &["NCP-SESS-050", "NCP-SESS-054"], trace)
        .title("Of two neurons of one potential under one current the one that rests does not spike.")
        .because("A neuron that spiked is refractory for round(t_ref / dt) steps; another of its population is not.")
}

/// Spikes of thousands of neurons in one request, at each of its steps.
pub(super) fn many_spikes() -> Case {
    let (size, steps) = (10_000_u32, 7);
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

/// Steps so small beside the time constant that 1 − P, as a difference of doubles, has lost its digits.
pub(super) fn slow() -> Vec<Case> {
    const WHY: &str = "The formulas are those of real numbers, and hold to a relative error of 1e-9: 1 \u{2212} P has \
                       its nine digits where the step is small beside the time constant, too.";
    // With constant input, all steps together are one: what a network comes to from 0 has a closed form.
    let rise = |steps: u32, ratio: f64| -(-f64::from(steps) * ratio).exp_m1();
    let mut cases = Vec::new();
    for (name, dt, tau) in [
        ("2.4e-8", 0.5, 2.1e7),
        ("1.6e-8", 1.0, 6.3e7),
        ("8e-9", 1.0, 1.25e8),
        ("1e-8", 1.0, 1e8),
        ("1e-9", 1.0, 1e9),
        ("1e-10", 0.125, 1.25e9),
        ("1e-12", 1.0, 1e12),
        ("1e-18", 1.0, 1e18),
    ] {
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
pub(super) fn near() -> Vec<Case> {
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

/// One step of a rate neuron under its input.
pub(super) fn next_rate(r: &mut f64, propagator: f64, input: f64) -> f64 {
    *r = *r * propagator + input * (1.0 - propagator);
    *r
}

/// Rests of half a step and of nearly so much.
pub(super) fn rounded_rests() -> Vec<Case> {
    let table = [
        ("next-below-half", 0.5_f64.next_down(), 1.0),
        ("half", 0.5, 1.0),
        ("next-below-half-of-a-quarter", 0.125_f64.next_down(), 0.25),
        // Quotients by 0.1 that are less than the products by its inverse, 10.
        ("next-below-two-tenths", 0.15, 0.1),
        ("next-below-four-tenths", 0.35, 0.1),
        ("half-of-tenths", 0.25, 0.1),
    ];
    table
        .into_iter()
        .map(|(name, rest, dt)| {
            // So strong that one step, or a few, make it spike.
            let current = if dt < 0.25 { 40_000.0 } else { 2000.0 };
            let params = vec![("t_ref", rest), ("I_e", current)];
            let (_, _, spikes) = simulate(&params, dt, 20, current);
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

/// Numbers next to 0: the error is relative to them.
pub(super) fn tiny() -> Vec<Case> {
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
    cases.extend(falls_in_one_step());
    cases
}

/// A step that is long beside every time constant: what it leaves of a value is small, and not 0.
fn falls_in_one_step() -> Vec<Case> {
    const DT: f64 = 400.0;
    let rest = vec![("E_L", 0.0), ("V_reset", 0.0), ("V_th", 1.0), ("C_m", 10.0)];
    let of = |observable| vec![record("out", observable, DT)];
    let lif = Open { params: rest, records: of("V_m"), stimuli: vec![stimulus("in", "current_pA")], ..Open::lif("a") };
    let rate = Open { records: of("rate"), stimuli: vec![stimulus("in", "rate_inject")], ..Open::rate("a") };
    let one = |network: &str, rule, open: Open| {
        let open = Open { dt: DT, ..open };
        let p = (-DT / 10.0).exp();
        let first = 0.5 * (1.0 - p);
        let shows = |time: f64, value| recorded("a", object! { "out" => small_samples(&[time], &[value]) });
        let trace = vec![
            (open.text(), opened("a")),
            (step("a", Some(DT), Some(("in", 0.5))), shows(DT, first)),
            (step("a", Some(DT), Some(("in", 0.0))), shows(2.0 * DT, first * p)),
        ];
        reference(format!("tiny/one-step/{network}"), &[rule], trace)
            .title(format!("A neuron ({network}) falls towards 0 in one step of {DT} ms, and is not 0."))
            .because("The error of rules 50 and 51 is relative to the value, and nothing cancels here.")
    };
    vec![one("lif", "NCP-SESS-050", lif), one("rate", "NCP-SESS-051", rate)]
}
