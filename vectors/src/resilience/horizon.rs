//! Replaying a horizon, and how long one may be.

use std::collections::BTreeSet;

use ncp_text::WIRE_VERSION;

use super::model::Event;
use super::{buffer_case as case, buffer_row};
use crate::case::{Case, File, Role};
use crate::command::{Channel, Command, active, channel, channels_json, velocity};
use crate::json::{Json, object};
use crate::scenario::{ScenarioError, Scenarios, source};
use crate::template::Text;
use crate::trace::{any, exactly, int, name_of, no_result, num, nums, steps, within};

pub(super) fn replay() -> Result<File, ScenarioError> {
    let mut cases = ticks();
    cases.extend(hairs());
    cases.extend(lengths_of_a_tick());
    cases.extend(lengths_of_a_tick_before());
    cases.extend(Scenarios::read(source!("resilience/horizon"))?.rest(buffer_row)?);
    cases.push(long_replay());
    cases.push(long_replay_of_thirds());
    cases.push(longest_replay());
    cases.push(counted());
    cases.push(replay_in_blocks());
    cases.extend(channels_of_a_tick());
    let about = "The replay of a horizon: its ticks, its end, the end of the ttl, and ticks without a length.";
    Ok(File::new("resilience", "horizon", about, cases))
}

/// The tick at many ages, around each boundary that doubles hold exactly.
fn ticks() -> Vec<Case> {
    let mut cases = Vec::new();
    for (dt, step) in [(125.0, 0.125), (62.5, 0.0625), (250.0, 0.25), (1000.0, 1.0)] {
        for count in [1_u32, 3, 5] {
            let values: Vec<f64> = (1..=count).map(|at| f64::from(at) * 10.0).collect();
            for quarter in 0..=4 * (count + 2) {
                // The start of each tick, just before it, and its middle; nothing in between.
                if quarter % 4 == 1 {
                    continue;
                }
                let (name, age) = match quarter % 4 {
                    3 => ("just-before", step * (f64::from(quarter / 4 + 1) - 1.0 / 1024.0)),
                    2 => ("middle", step * f64::from(quarter) / 4.0),
                    _ => ("start", step * f64::from(quarter / 4)),
                };
                if count != 3 && name != "start" || dt > 125.0 && name == "middle" {
                    continue;
                }
                let tick = quarter / 4;
                let command = active(1).ttl(60_000.0).along_x(dt, &values);
                let rule = if tick > count { "NCP-RES-029" } else { "NCP-RES-028" };
                cases.push(
                    case(
                        format!("tick/{dt}-ms/{count}-steps/tick-{tick}/{name}"),
                        &[rule, "NCP-RES-025"],
                        &[Event::Command(command, 4.0), Event::Ask(4.0 + age)],
                    )
                    .title(format!(
                        "Of a horizon of {count} steps of {dt} ms, the plant follows tick {tick} \
                                        after {} ms, or none behind its end.",
                        age * 1000.0
                    ))
                    .flags(&["wrong-tick"])
                    .because(
                        "`active` is tick \u{230a}(now \u{2212} received) / dt\u{230b}: tick 0 is \
                                  `channels`, tick k is `horizon[k\u{2212}1]`, and none past the end.",
                    ),
                );
            }
        }
    }
    cases
}

/// Ages next to the start of a tick, and further from it than doubles round.
fn hairs() -> Vec<Case> {
    let mut cases = Vec::new();
    for dt in [10.0, 125.0] {
        for tick in [1_u32, 3] {
            for power in [-33, -36] {
                let (start, hair) = (f64::from(tick) * dt / 1000.0, 2.0_f64.powi(power));
                for (name, age, follows) in
                    [("before", start * (1.0 - hair), tick - 1), ("behind", start * (1.0 + hair), tick)]
                {
                    // Of the nearest, one length of a tick is enough.
                    if power < -33 && dt > 10.0 {
                        continue;
                    }
                    let rule = if follows > 2 { "NCP-RES-029" } else { "NCP-RES-028" };
                    let command = active(1).ttl(60_000.0).along_x(dt, &[10.0, 20.0]);
                    cases.push(
                        case(
                            format!("hair/{dt}-ms/{name}-tick-{tick}-by-2-to-{power}").replace("--", "-minus-"),
                            &[rule, "NCP-RES-025"],
                            &[Event::Command(command, 0.0), Event::Ask(age)],
                        )
                        .title(format!(
                            "Of a horizon of 2 steps of {dt} ms, the plant follows tick {follows} after {age} s, or \
                             none behind its end."
                        ))
                        .flags(&["wrong-tick"])
                        .because(
                            "`active` is tick \u{230a}(now \u{2212} received) / dt\u{230b}, and a quotient that is \
                             nearly a whole number is none.",
                        ),
                    );
                }
            }
        }
    }
    cases
}

/// Every part of a long horizon is replayed in its time.
fn long_replay() -> Case {
    let values: Vec<f64> = (1..=300).map(f64::from).collect();
    let mut events = vec![Event::Command(active(1).ttl(60_000.0).along_x(125.0, &values), 4.0)];
    let ticks = [0, 8, 9, 17, 64, 65, 66, 255, 256, 257, 299, 300, 301, 302];
    events.extend(ticks.map(|tick| Event::Ask(4.0 + 0.125 * f64::from(tick))));
    case("long/300-steps", &["NCP-RES-028", "NCP-RES-029"], &events)
        .title("Of a horizon of 300 steps the plant follows each in its time, and none behind the end.")
        .flags(&["wrong-tick"])
        .because("`active` is tick \u{230a}(now \u{2212} received) / dt\u{230b}, and none past the end of the horizon.")
}

/// Ticks of a third of 100 ms, of which each late one begins a little off where the length is kept in whole
/// microseconds.
fn long_replay_of_thirds() -> Case {
    let values: Vec<f64> = (1..=300).map(f64::from).collect();
    let mut events = vec![Event::Command(active(1).ttl(60_000.0).along_x(100.0 / 3.0, &values), 0.0)];
    // Half a tenth of a millisecond before the tick and behind it.
    events.extend([150.0, 240.0, 300.0].iter().flat_map(|tick| [-5e-5, 5e-5].map(|by| Event::Ask(tick / 30.0 + by))));
    case("long/300-thirds", &["NCP-RES-028"], &events)
        .title("Of a horizon of 300 steps of 100/3 ms each begins in its time.")
        .flags(&["wrong-tick"])
        .because("`active` is tick \u{230a}(now \u{2212} received) / dt\u{230b}, of the length that the command says.")
}

/// Each step of the longest horizon says its own number: the plant is asked for many of them.
fn counted() -> Case {
    let frame = Text::concat([
        Text::from(concat!(
            r#"{"kind":"command_frame","seq":1,"mode":"active","ttl_ms":60000.0,"horizon_dt_ms":1.0,"#,
            r#""channels":{},"horizon":["#
        )),
        // Tick k is `horizon[k - 1]`, and says k - 1.
        Text::count(r#"{"velocity_setpoint":{"data":["#, r#".0,0.0,0.0],"unit":"m/s"}},"#, 4095),
        Text::from(r#"{"velocity_setpoint":{"data":[4095.0,0.0,0.0],"unit":"m/s"}}]}"#),
    ]);
    let near = [1000, 1500, 2000, 2500, 3000, 3500, 4000].into_iter().chain((0..=12).map(|power| 1 << power));
    let asked: BTreeSet<u32> = (1..=85)
        .map(|nth| nth * 48)
        .chain(near.flat_map(|tick| [tick - 1, tick, tick + 1]))
        .filter(|tick| (1..=4096).contains(tick))
        .collect();
    let ask = |tick: &u32| object! { "op" => "active", "now_s" => num((f64::from(*tick) + 0.5) / 1000.0) };
    let shown = |tick: &u32| {
        let data = nums(&[f64::from(tick - 1), 0.0, 0.0]);
        object! { "channels" => object! { "velocity_setpoint" => object! { "data" => data, "unit" => "m/s" } } }
    };
    let command = object! { "op" => "command", "text" => frame.json(), "now_s" => num(0.0) };
    Case::new("long/4096-steps-in-turn", &["NCP-RES-028", "NCP-RES-029"], &[Role::Body])
        .call(
            "buffer.run",
            object! { "steps" => std::iter::once(command).chain(asked.iter().map(ask)).collect::<Json>() },
        )
        .shows(steps(std::iter::once(no_result()).chain(asked.iter().map(shown)).collect()))
        .title(format!("Of a horizon of 4,096 steps, the plant follows each of {} in its time.", asked.len()))
        .flags(&["wrong-tick"])
        .because("`active` is tick \u{230a}(now \u{2212} received) / dt\u{230b}, however many steps there are.")
}

/// The last step of the longest horizon is replayed until its tick is over.
fn longest_replay() -> Case {
    let tick = |x: u32| format!(r#"{{"velocity_setpoint":{{"data":[{x}.0,0.0,0.0],"unit":"m/s"}}}}"#);
    let frame = Text::concat([
        Text::from(format!(
            r#"{{"ncp_version":"{WIRE_VERSION}","kind":"command_frame","seq":1,"mode":"active","ttl_ms":60000.0,"#
        )),
        Text::from(format!(r#""horizon_dt_ms":1.0,"channels":{},"horizon":["#, tick(1))),
        Text::repeat(format!("{},", tick(2)), 4095),
        Text::from(format!("{}]}}", tick(3))),
    ]);
    let ask = |at_ms: f64| object! { "op" => "active", "now_s" => num(at_ms / 1000.0) };
    let moves = |x: f64| {
        object! { "channels" => object! {
        "velocity_setpoint" => object! { "data" => nums(&[x, 0.0, 0.0]), "unit" => "m/s" } } }
    };
    let holds = || object! { "channels" => Json::Null };
    // Received at 0, so that no difference of clocks rounds.
    let asked =
        [(0.5, moves(1.0)), (4095.5, moves(2.0)), (4096.25, moves(3.0)), (4096.75, moves(3.0)), (4097.5, holds())];
    let command = object! { "op" => "command", "text" => frame.json(), "now_s" => num(0.0) };
    let events = std::iter::once(command).chain(asked.iter().map(|(at_ms, _)| ask(*at_ms))).collect();
    let shown = std::iter::once(no_result()).chain(asked.iter().map(|(_, shown)| shown.clone())).collect();
    Case::new("long/4096-steps", &["NCP-RES-028", "NCP-RES-029"], &[Role::Body])
        .call("buffer.run", object! { "steps" => Json::Array(events) })
        .shows(steps(shown))
        .title("Of a horizon of 4,096 steps, the longest, the plant follows the last until its tick is over.")
        .flags(&["wrong-tick"])
        .because("`active` is tick \u{230a}(now \u{2212} received) / dt\u{230b}, and none past the end of the horizon.")
}

/// Early steps of the longest horizon, behind which many others stand: who keeps them in less room overwrites them.
fn replay_in_blocks() -> Case {
    let tick = |x: usize| format!(r#"{{"velocity_setpoint":{{"data":[{x}.0,0.0,0.0],"unit":"m/s"}}}}"#);
    // Up to which step each block reaches, and a moment within it, ms.
    const BLOCKS: [(usize, f64); 8] = [
        (40, 3.5),
        (100, 60.5),
        (200, 150.5),
        (400, 300.5),
        (900, 700.5),
        (1_800, 1_500.5),
        (3_500, 3_000.5),
        (4_096, 4_000.5),
    ];
    let mut frame = vec![
        format!(r#"{{"ncp_version":"{WIRE_VERSION}","kind":"command_frame","seq":1,"mode":"active","ttl_ms":60000.0,"#)
            .into(),
        format!(r#""horizon_dt_ms":1.0,"channels":{},"horizon":["#, tick(1)).into(),
    ];
    let mut last = 0;
    for (nth, (until, _)) in BLOCKS.iter().enumerate() {
        let is_last = nth + 1 == BLOCKS.len();
        frame.push(Text::repeat(format!("{},", tick(nth + 2)), until - last - usize::from(is_last)));
        last = *until;
    }
    frame.push(format!("{}]}}", tick(BLOCKS.len() + 1)).into());
    let command = object! { "op" => "command", "text" => Text::concat(frame).json(), "now_s" => num(0.0) };
    let asked = BLOCKS.iter().map(|(_, ms)| object! { "op" => "active", "now_s" => num(ms / 1000.0) });
    let moves = |x: u32| {
        object! { "channels" => object! {
        "velocity_setpoint" => object! { "data" => nums(&[f64::from(x), 0.0, 0.0]), "unit" => "m/s" } } }
    };
    let shown = (2..).take(BLOCKS.len()).map(moves);
    Case::new("long/4096-steps-in-blocks", &["NCP-RES-028"], &[Role::Body])
        .call("buffer.run", object! { "steps" => std::iter::once(command).chain(asked).collect::<Json>() })
        .shows(steps(std::iter::once(no_result()).chain(shown).collect()))
        .title("Of a horizon of 4,096 steps the plant follows each in its time, the early ones as well.")
        .flags(&["wrong-tick"])
        .because("`active` is tick \u{230a}(now \u{2212} received) / dt\u{230b}, whatever stands behind it.")
}

/// A horizon without a usable tick, behind a command that had one: nothing of the former command is left.
fn lengths_of_a_tick_before() -> Vec<Case> {
    [("absent", None), ("zero", Some(0.0)), ("minus-one", Some(-1.0))]
        .into_iter()
        .map(|(name, dt)| {
            let before = active(1).along_x(50.0, &[10.0, 20.0, 30.0]).ttl(1000.0);
            let command = Command { dt, ..active(2).along_x(50.0, &[11.0, 22.0, 33.0]).ttl(1000.0) };
            let asks = [4.25, 4.3125, 4.375, 4.4375].map(Event::Ask);
            let events: Vec<Event> = [Event::Command(before, 4.0), Event::Ask(4.0625), Event::Command(command, 4.25)]
                .into_iter()
                .chain(asks)
                .collect();
            case(format!("no-length/{name}/behind-a-length"), &["NCP-RES-027"], &events)
                .title(format!(
                    "With a tick of length {name}, behind a command whose ticks had a length, nothing of the horizon \
                     is replayed."
                ))
                .flags(&["wrong-tick"])
                .because("What a command does not say, no command before it says for it.")
        })
        .collect()
}

/// Ticks that have other channels than tick 0: each is what it says, and nothing of another.
fn channels_of_a_tick() -> Vec<Case> {
    let (v, grip, tow) = (
        |x: f64| velocity(&[x, 0.0, 0.0]),
        |x: f64| channel("grip", &[x], None),
        |x: f64| channel("tow", &[x, -x], Some("N")),
    );
    let table = [
        ("fewer", "channels that later ticks leave out", vec![v(1.0), grip(0.5)], vec![vec![v(2.0)], vec![grip(0.25)]]),
        (
            "more",
            "channels that only later ticks have",
            vec![v(1.0)],
            vec![vec![v(2.0), grip(0.5)], vec![tow(3.0), v(3.0)]],
        ),
        ("others", "other channels in each tick", vec![v(1.0)], vec![vec![grip(0.5)], vec![tow(3.0)]]),
        ("none", "a tick without channels", vec![v(1.0), grip(0.5)], vec![vec![], vec![v(3.0)]]),
        (
            "units",
            "a tick that leaves a unit out",
            vec![tow(1.0)],
            vec![vec![channel("tow", &[2.0, -2.0], None)], vec![channel("tow", &[3.0], Some("kN"))]],
        ),
    ];
    // What another command has in the same ticks: more channels, other units, more components.
    let wide = || vec![v(9.0), grip(9.0), channel("tow", &[9.0, 8.0, 7.0], Some("kN")), channel("arm", &[9.0], None)];
    let another = |seq: i64| Command {
        channels: wide(),
        horizon: vec![wide(), wide(), wide()],
        dt: Some(125.0),
        ..active(seq).ttl(1000.0)
    };
    let ways = [
        ("", "", None, None),
        ("/behind-another", " behind one of other channels", Some(1), None),
        ("/before-a-stale-one", " before an older one of other channels", None, Some(1)),
    ];
    let case_of = |(name, words, now, horizon): &(&str, &str, Vec<Channel>, Vec<Vec<Channel>>), way| {
        let (path, how, before, behind): (&str, &str, Option<i64>, Option<i64>) = way;
        // To the channel: one more would move the plant.
        let of_tick = |tick: &Vec<Channel>| object! { "channels" => exactly(channels_json(tick)) };
        let seq = if path.is_empty() { 1 } else { 2 };
        let command =
            Command { channels: now.clone(), horizon: horizon.clone(), dt: Some(125.0), ..active(seq).ttl(1000.0) };
        let commands = [before.map(another), Some(command), behind.map(another)].into_iter().flatten();
        let mut events: Vec<Event> = commands.map(|command| Event::Command(command, 2.0)).collect();
        let mut shown = vec![no_result(); events.len()];
        events.extend([2.0, 2.125, 2.25].map(Event::Ask));
        shown.extend(std::iter::once(now).chain(horizon).map(of_tick));
        case(format!("channels/{name}{path}"), &["NCP-RES-028"], &events)
            .shows(steps(shown))
            .title(format!("A plant replays a horizon with {words}{how}."))
            .flags(&["wrong-tick"])
            .because("`active` is the channels of the tick whose time it is, and takes none from another tick.")
    };
    ways.into_iter().flat_map(|way| table.iter().map(move |row| case_of(row, way))).collect()
}

fn lengths_of_a_tick() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, dt) in [
        ("absent", None),
        ("zero", Some(0.0)),
        ("minus-zero", Some(-0.0)),
        ("minus-one", Some(-1.0)),
        ("minus-huge", Some(-1e308)),
        ("minus-subnormal", Some(-5e-324)),
    ] {
        for age in [0.0, 0.125, 0.25, 0.3125] {
            let command = Command { dt, ..active(1).along_x(0.0, &[10.0, 20.0]) };
            cases.push(
                case(
                    format!("no-length/{name}/after-{age}-s"),
                    if age > 0.25 { &["NCP-RES-002", "NCP-RES-027"] } else { &["NCP-RES-027", "NCP-RES-002"] },
                    &[Event::Command(command, 4.0), Event::Ask(4.0 + age)],
                )
                .title(format!(
                    "With a tick of length {name}, the plant follows tick 0 until the ttl ends, or \
                                    holds; asked after {age} s."
                ))
                .flags(&["wrong-tick"])
                .because(
                    "With a horizon whose `horizon_dt_ms` is absent, not finite or not positive, `active` \
                              is the channels of tick 0, or none: neither moves the plant \
                         more, and nothing of the horizon is replayed.",
                ),
            );
        }
    }
    for (name, dt, age) in [
        ("huge", 1e308, 0.25),
        ("longer-than-the-ttl", 1000.0, 0.25),
        ("tiny-at-once", 1e-300, 0.0),
        ("tiny-later", 1e-300, 0.25),
    ] {
        let command = active(1).along_x(dt, &[10.0, 20.0]);
        cases.push(
            case(
                format!("odd-length/{name}"),
                &["NCP-RES-028", "NCP-RES-029"],
                &[Event::Command(command, 4.0), Event::Ask(4.0 + age)],
            )
            .title(format!("A tick of {dt} ms is a tick ({}).", name.replace('-', " ")))
            .flags(&["overflowing-tick"])
            .because(
                "The tick is \u{230a}(now \u{2212} received) / dt\u{230b}, also where that is beyond every integer.",
            ),
        );
    }
    // Without a horizon the length does not matter.
    for dt in [0.0, 10.0, 62.5, -1.0, 1e308] {
        for age in [0.125, 0.25] {
            cases.push(
                case(
                    format!("no-horizon/dt-{}/after-{age}-s", name_of(dt)),
                    &["NCP-RES-026"],
                    &[Event::Command(active(1).along_x(dt, &[]), 4.0), Event::Ask(4.0 + age)],
                )
                .title(format!(
                    "Without a horizon, a tick of {dt} ms changes nothing: the plant follows tick 0 after {age} s."
                ))
                .flags(&["wrong-tick"])
                .because("Without a horizon, `active` is the channels of tick 0."),
            );
        }
    }
    cases
}

/// `max_horizon_len`.
pub(super) fn lengths() -> File {
    let mut cases = Vec::new();
    let of = |path: String, rules: &[&'static str], ttl: f64, dt: f64| {
        Case::new(path, rules, &[Role::Commander, Role::Body])
            .call("horizon.max_len", object! { "ttl_ms" => num(ttl), "dt_ms" => num(dt) })
    };
    let exact: [(f64, f64, i64); 32] = [
        (1000.0, 100.0, 10),
        (1000.0, 250.0, 4),
        (999.0, 100.0, 9),
        (1001.0, 100.0, 10),
        (200.0, 50.0, 4),
        (199.0, 50.0, 3),
        (250.0, 62.5, 4),
        (100.0, 100.0, 1),
        (99.0, 100.0, 0),
        (1.0, 1000.0, 0),
        (200.0, 20.0, 10),
        (60_000.0, 1000.0, 60),
        (60_000.0, 59_000.0, 1),
        // A plant enforces a minute of the ttl, and no tick is shorter for it.
        (60_000.0, 60_001.0, 0),
        (60_000.0, 120_000.0, 0),
        (90_000.0, 100_000.0, 0),
        (0.5, 0.125, 4),
        (7.0, 2.0, 3),
        (7.5, 2.5, 3),
        (4096.0, 1.0, 4096),
        (4095.0, 1.0, 4095),
        (1000.0, 0.25, 4000),
        (5e-324, 1.0, 0),
        (1.0, 1e308, 0),
        (1e-300, 1e-300, 1),
        // Below a whole number by less than a single shows.
        (1000.0_f64.next_down(), 100.0, 9),
        (999.999_999, 100.0, 9),
        (4_095.999_999_9, 1.0, 4095),
        (59_999.999_9, 1000.0, 59),
        // What adds dt up, again and again, comes to another sum.
        (400.000_000_000_004, 0.1, 4000),
        (199.999_999_999_994, 0.1, 1999),
        (1_400.000_000_000_014, 0.7, 2000),
    ];
    for (ttl, dt, len) in exact {
        cases.push(
            of(format!("len/{}-by-{}", name_of(ttl), name_of(dt)), &["NCP-RES-033"], ttl, dt)
                .shows(object! { "len" => int(len) })
                .title(format!("A ttl of {ttl} ms has room for {len} ticks of {dt} ms."))
                .because("`max_horizon_len` is \u{230a}ttl / dt\u{230b}."),
        );
    }
    // Beyond what a frame may have, the cap is advice; beyond a minute, the enforced ttl may count.
    for (ttl, dt, full) in [(60_000.0, 1.0, 60_000.0), (4097.0, 1.0, 4097.0), (60_000.0, 0.5, 120_000.0)] {
        cases.push(
            of(format!("long/{}-by-{}", name_of(ttl), name_of(dt)), &["NCP-RES-033"], ttl, dt)
                .shows(object! { "len" => any(vec![num(4096.0), num(full)]) })
                .title(format!("A ttl of {ttl} ms and ticks of {dt} ms give 4,096, or all of them."))
                .flags(&["L27"])
                .because("`max_horizon_len` is \u{230a}ttl / dt\u{230b}, and should be capped at 4,096."),
        );
        cases.push(
            of(format!("cap/{}-by-{}", name_of(ttl), name_of(dt)), &["NCP-RES-034"], ttl, dt)
                .shows(object! { "len" => int(4096) })
                .title(format!("A ttl of {ttl} ms and ticks of {dt} ms should give no more than 4,096."))
                .flags(&["L27"])
                .because("`max_horizon_len` should be capped at 4,096, the most items that a frame may have."),
        );
    }
    for (ttl, dt, name) in [
        (1e308, 1.0, "huge-ttl"),
        (f64::MAX, 5e-324, "overflowing-quotient"),
        (1.0, 5e-324, "subnormal-tick"),
        (1e308, 1e-308, "huge-by-tiny"),
    ] {
        cases.push(
            of(format!("saturated/{name}"), &["NCP-RES-033"], ttl, dt)
                .shows(object! { "len" => within(4096.0, f64::MAX) })
                .title(format!("A ttl of {ttl} ms and ticks of {dt} ms give 4,096 or more, and no error."))
                .flags(&["L27", "overflowing-tick"])
                .because(
                    "\u{230a}ttl / dt\u{230b} is beyond every integer here, so that only its cap or its \
                          saturation can be answered.",
                ),
        );
        cases.push(
            of(format!("saturated-cap/{name}"), &["NCP-RES-034"], ttl, dt)
                .shows(object! { "len" => int(4096) })
                .title(format!("A ttl of {ttl} ms and ticks of {dt} ms should give 4,096."))
                .flags(&["L27"])
                .because("`max_horizon_len` should be capped at 4,096."),
        );
    }
    for ttl in [120_000.0, 90_000.0] {
        cases.push(
            of(format!("beyond-a-minute/{ttl}"), &["NCP-RES-033"], ttl, 1000.0)
                .shows(object! { "len" => any(vec![num(ttl / 1000.0), num(60.0)]) })
                .title(format!(
                    "A ttl of {ttl} ms has room for {} ticks of a second, or for the 60 of the enforced ttl.",
                    ttl / 1000.0
                ))
                .because("`max_horizon_len` is \u{230a}ttl / dt\u{230b}; a plant enforces 60 s of the ttl."),
        );
    }
    let bad = [0.0, -0.0, -1.0, -5e-324, -1e308, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for value in bad {
        for (which, ttl, dt) in [("ttl", value, 50.0), ("dt", 200.0, value), ("both", value, value)] {
            cases.push(
                of(format!("none/{which}/{}", name_of(value)), &["NCP-RES-033"], ttl, dt)
                    .shows(object! { "len" => int(0) })
                    .title(format!("There is no room for ticks when {which} is {}.", name_of(value)))
                    .flags(&["L27"])
                    .because("`max_horizon_len` is 0 when either is not finite or not positive."),
            );
        }
    }
    let about = "How many ticks a horizon may have.";
    File::new("resilience", "horizon_length", about, cases)
}
