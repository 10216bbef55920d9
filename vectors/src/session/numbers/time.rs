//! The time of a reference network: how many steps a request is, and where the session stands behind them.

use super::{near_to, recorded_at, samples, small_samples};
use crate::case::Case;
use crate::json::{Json, object};
use crate::session::{Open, error, observed, opened, record, reference, run, step, stimulus};
use crate::trace::{any, nums, within};

/// The request for a time.
type Request = fn(f64) -> String;

/// How many steps a time is, and that no request makes up for what another was rounded by.
pub(super) fn durations() -> Vec<Case> {
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

/// The time of sessions that run for long, in one request and in many.
pub(super) fn far_times() -> Vec<Case> {
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

/// A membrane that leaves the doubles only behind many steps of its request.
pub(super) fn failures_behind_many_steps() -> Vec<Case> {
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

/// The time of a session to the last bit: it is one product.
pub(super) fn exact_times() -> Vec<Case> {
    let table: [(&str, f64, &[u32]); 3] = [
        ("tenths-one-by-one", 0.1, &[1; 6]),
        ("many-tenths", 0.1, &[200_000]),
        // Behind each of them, the product needs more than single precision.
        ("many-seven-tenths", 0.7, &[1_001, 20_002, 70_003, 1, 2_000_001]),
    ];
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

/// Steps that are far shorter than any time constant.
pub(super) fn short_steps() -> Vec<Case> {
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

/// Steps that are far longer than the time constant: what is left of a potential is little, and not nothing.
pub(super) fn long_steps() -> Vec<Case> {
    let mut cases = Vec::new();
    let dt = 100.0;
    for (name, tau) in [("by-100", 1.0), ("by-400", 0.25), ("by-640", 0.156_25)] {
        let params = |tau_name| vec![(tau_name, tau)];
        let cell = [("C_m", tau), ("E_L", 0.0), ("V_reset", 0.0), ("V_th", 1e305), ("t_ref", 0.0)];
        let lif = Open {
            params: [params("tau_m"), cell.to_vec()].concat(),
            records: vec![record("out", "V_m", dt)],
            stimuli: vec![stimulus("in", "current_pA")],
            ..Open::lif("a")
        };
        let rate = Open {
            params: params("tau"),
            records: vec![record("out", "rate", dt)],
            stimuli: vec![stimulus("in", "rate_inject")],
            ..Open::rate("a")
        };
        for (network, rule, open) in [("lif", "NCP-SESS-050", lif), ("rate", "NCP-SESS-051", rate)] {
            let open = Open { dt, chunk: dt, ..open };
            let after = |steps: f64, value: f64| {
                recorded_at("a", steps * dt, object! { "out" => small_samples(&[steps * dt], &[value]) })
            };
            let trace = vec![
                (open.text(), opened("a")),
                (step("a", None, Some(("in", 1e300))), after(1.0, 1e300)),
                (step("a", None, Some(("in", 0.0))), after(2.0, 1e300 * (-dt / tau).exp())),
            ];
            cases.push(
                reference(format!("long/{name}/{network}"), &[rule], trace)
                    .title(format!(
                        "A step of {dt} ms leaves of a state ({network}) with a time constant of {tau} ms what the \
                         formula says."
                    ))
                    .because(
                        "The factor of a step is exp(\u{2212}dt / tau), which is a double down to 10^\u{2212}308.",
                    ),
            );
        }
    }
    cases
}
