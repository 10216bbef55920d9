//! Modes, seqs, holds, resets and malformed frames at the action buffer.

use super::model::{Event, buffer};
use super::{buffer_row as row_case, go};
use crate::case::{Case, File, Role};
use crate::command::active;
use crate::json::{Json, object};
use crate::patch::patched;
use crate::scenario::{Fault, Row, ScenarioError, Scenarios, source};
use crate::trace::{any, exactly, int, name_of, no_result, num, nums, steps};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("resilience/buffer"))?;
    let mut cases = Vec::new();
    for group in [
        "mode",
        "mode-none",
        "mode-other",
        "mode-alone",
        "hold-often",
        "mode/unknown",
        "mode/not-estop",
        "mode-absent",
        "hold",
        "hold-restart",
        "hold-without-a-clock",
        "drop",
        "fallen",
        "replace",
        "trace",
        "reset",
    ] {
        cases.extend(text.cases(group, row_case)?);
    }
    cases.extend(deadlines());
    cases.extend(cycles());
    for group in [
        "replace-ttl",
        "clock",
        "clock-back",
        "clock-back-and-on",
        "asked-often",
        "clock-far",
        "begun-anew",
        "senders-clock",
    ] {
        cases.extend(text.cases(group, row_case)?);
    }
    for row in text.rows("malformed")? {
        cases.extend(malformed(&row)?);
    }
    cases.extend(text.cases("unlisted", unlisted)?);
    cases.extend(text.cases("left-behind", left_behind)?);
    cases.extend(half_read());
    cases.extend(text.cases("clock-of-the-dropped", row_case)?);
    cases.extend(text.cases("channels", channels)?);
    cases.extend(text.cases("signs-of-zero", |row| Ok(channels(row)?.with_signs()))?);
    cases.extend(text.cases("channels-in-turn", channels_in_turn)?);
    cases.extend(text.cases("asked", row_case)?);
    cases.extend(text.cases("waits", row_case)?);
    cases.extend(text.cases("behind-many", row_case)?);
    cases.extend(text.cases("resets", row_case)?);
    // Nothing but what does not advance tells these from a plant that was left alone.
    cases.extend(text.cases("stream", |row| Ok(row_case(row)?.about_from(0)))?);
    text.end()?;
    cases.extend(long_streams());
    cases.extend(far_deadlines());
    cases.extend(older_holds());
    let about = "The action buffer: which command a plant follows, and when it follows none.";
    Ok(File::new("resilience", "buffer", about, cases))
}

fn deadlines() -> Vec<Case> {
    let mut cases = Vec::new();
    for (ttl, ages) in [
        (0.0, [0.0, 0.125]),
        (-1.0, [0.0, 0.125]),
        (-1e308, [0.0, 60.0]),
        (5e-324, [0.0, 0.001]),
        (62.5, [0.0625, 0.125]),
        (250.0, [0.25, 0.251]),
        (60_000.0, [60.0, 60.5]),
        (60_001.0, [60.0, 60.5]),
        (3.6e6, [60.0, 60.5]),
        (1e308, [60.0, 61.0]),
    ] {
        for age in ages {
            let rule = if ttl <= 0.0 {
                "NCP-RES-005"
            } else if ttl > 60_000.0 {
                "NCP-RES-004"
            } else if age * 1000.0 < ttl {
                "NCP-RES-013"
            } else if age * 1000.0 == ttl {
                "NCP-RES-003"
            } else {
                "NCP-RES-002"
            };
            let events = [Event::Command(active(1).ttl(ttl), 4.0), Event::Ask(4.0 + age)];
            cases.push(
                super::buffer_case(
                    format!("deadline/ttl-{}/after-{age}-s", name_of(ttl)),
                    &[rule, "NCP-RES-025"],
                    &events,
                )
                .title(format!(
                    "The buffer keeps a command of {ttl} ms for the enforced ttl, and is asked after {age} s."
                ))
                .flags(if ttl > 60_000.0 { &["L02"] } else { &["off-by-a-boundary"] })
                .because("`active` is none whenever the deadline rules of 8.1 hold the plant."),
            );
        }
    }
    cases
}

/// What a plant does behind many holds that ended, and behind many stops.
fn cycles() -> Vec<Case> {
    const MANY: u16 = 130;
    let one =
        |name: &str, rules: &[&'static str], words: &str, ages: &[f64], cycle: &dyn Fn(i64, f64) -> Vec<Event>| {
            let mut events: Vec<Event> = (1..=MANY).flat_map(|nth| cycle(i64::from(nth), f64::from(nth))).collect();
            let now = f64::from(MANY) + 1.0;
            events.push(go(i64::from(MANY) + 1, now));
            events.extend(ages.iter().map(|age| Event::Ask(now + age)));
            super::buffer_case(format!("waits/{name}-for-long"), rules, &events)
                .title(format!("Behind {MANY} {words}, the next command moves the plant for its ttl."))
                .flags(&["over-strict"])
                .because(
                    "A hold ends with the next command that advances, and ESTOP with a reset, however many there were.",
                )
        };
    vec![
        one(
            "recovers",
            &["NCP-RES-010", "NCP-RES-026"],
            "holds, each ended by a command",
            &[0.0, 0.25, 0.257_812_5],
            &|seq, now| vec![go(seq, now), Event::Ask(now + 0.5)],
        ),
        one("stops", &["NCP-RES-030", "NCP-RES-026"], "stops, each ended by a reset", &[0.0, 0.25], &|seq, now| {
            vec![Event::Command(active(seq).mode("estop"), now), Event::Reset]
        }),
    ]
}

/// Commands that do not advance, however many of them come.
fn long_streams() -> Vec<Case> {
    let table: [(&str, &[&'static str], &str, Vec<i64>); 4] = [
        ("rising", &["NCP-RES-032", "NCP-RES-020"], "a rising seq below the last", (1..=50).collect()),
        ("rising-long", &["NCP-RES-032", "NCP-RES-020"], "a rising seq below the last", (1..=140).collect()),
        ("same", &["NCP-RES-020", "NCP-RES-009"], "the last seq", vec![1000; 26]),
        ("unstamped", &["NCP-RES-020", "NCP-RES-009"], "no stamp", vec![0; 26]),
    ];
    let one = |(name, rules, words, seqs): (&str, &[&'static str], &str, Vec<i64>)| {
        let mut events = vec![go(1000, 1.0)];
        for (nth, seq) in (1_u32..).zip(&seqs) {
            let now = 1.0 + f64::from(nth) / 64.0;
            events.push(Event::Command(active(*seq).x(77.0), now));
            if nth % 8 == 0 {
                events.push(Event::Ask(now));
            }
        }
        let end = 1.0 + f64::from(u32::try_from(seqs.len()).unwrap_or_default()) / 64.0;
        events.extend([Event::Ask(end), Event::Reset, go(1, end + 0.125), Event::Ask(end + 0.125)]);
        super::buffer_case(format!("drop/many/{name}"), rules, &events)
            .title(format!(
                "{} commands of {words} are all dropped, and after a reset seq 1 moves the plant.",
                seqs.len()
            ))
            .flags(&["revived-command"])
            .because("The buffer drops a command that does not advance, and a sender that began again until a reset.")
    };
    table.into_iter().map(one).collect()
}

/// Ends of a ttl at which no double is, on clocks that have run for long: a deadline that is added up rounds past it.
fn far_deadlines() -> Vec<Case> {
    let one = |(whole, ttl): (f64, f64)| {
        let far = whole.log2();
        let (received, now) = (whole - 1.0, whole);
        let replays = active(2).ttl(60_000.0).along_x(ttl, &[21.0, 22.0]);
        let events = [Event::Command(active(1).ttl(ttl), received), Event::Ask(now)];
        let ticks = [Event::Command(replays, received), Event::Ask(now)];
        let held = super::buffer_case(format!("clock/far/past-the-ttl/2-to-{far}"), &["NCP-RES-002"], &events)
            .title(format!("At 2^{far} s a command of {ttl} ms is over one second after it came."))
            .because("The age is now \u{2212} received, and it is more than the ttl by more than doubles round it.");
        let next = super::buffer_case(format!("clock/far/past-the-tick/2-to-{far}"), &["NCP-RES-028"], &ticks)
            .title(format!("At 2^{far} s tick 1 of a horizon of {ttl} ms has begun one second after it came."))
            .because("`active` is tick \u{230a}(now \u{2212} received) / dt\u{230b}, whatever the clock began with.");
        [held, next].map(|case| case.flags(&["off-by-a-boundary"]))
    };
    super::FAR.into_iter().flat_map(|power| one(super::second_at(power))).collect()
}

/// A frame that is rejected as the first and as the second one.
fn malformed(row: &Row) -> Result<[Case; 2], ScenarioError> {
    let base = active(2).frame();
    let text = match row.cell("text")?.split_once(' ').unwrap_or((row.cell("text")?, "")) {
        ("raw", text) => text.to_owned(),
        ("cut", _) => base.text().trim_end_matches('}').to_owned(),
        ("twice", "") => base.text().repeat(2),
        ("twice", tail) => base.text() + tail,
        _ => patched(base, row.cell("text")?, row.place)?.text(),
    };
    let frame = |now| Event::Text { text: Json::string(&text), now, stops: false };
    let moving = |x: f64| {
        object! { "channels" => object! { "velocity_setpoint" => object! { "data" => nums(&[x,
        0.0, 0.0]) } } }
    };
    let still = || object! { "channels" => Json::Null };
    let case = |path: &str, rules: &[&'static str], events: &[Event], results: Vec<Json>| {
        let (args, _, decided) = buffer(events, false);
        let case = Case::new(format!("malformed/{}/{path}", row.name), rules, &[Role::Body]);
        case.call("buffer.run", args).shows(steps(results)).decided_by(&decided).flags(&["malformed-moves"])
    };
    let rule = row.rules.first().copied().ok_or(row.place.fault(Fault::Missing("rules")))?;
    let name = row.name.replace('-', " ");
    let first = [frame(1.0), Event::Ask(1.0), go(3, 1.125), Event::Ask(1.125)];
    let second = [go(1, 1.0), frame(1.125), Event::Ask(1.125), Event::Ask(1.3125), go(3, 1.375), Event::Ask(1.375)];
    let either = any(vec![moving(1.0), still()]);
    Ok([
        case("first", &[rule, "NCP-RES-006"], &first, vec![no_result(), still(), no_result(), moving(3.0)])
            .title(format!("A frame that is rejected ({name}) moves nothing, and the next one does."))
            .because(
                "To reject a frame is to refuse it as a whole without acting on any part of it, so that there is no \
                 command yet.",
            ),
        case(
            "second",
            &[rule, "NCP-RES-009"],
            &second,
            vec![no_result(), no_result(), either, still(), no_result(), moving(3.0)],
        )
        .title(format!("A frame that is rejected ({name}) prolongs nothing and latches nothing."))
        .because(
            "A rejected frame is not acted upon in any part: the deadline of the command before it stays, and the \
             next command moves.",
        ),
    ])
}

/// A HOLD that is older than the last accepted command, and behind it what does not advance: the plant goes on as it
/// chose, to drop the HOLD or to obey it, until the next command that advances.
fn older_holds() -> Vec<Case> {
    let case = |(name, mode, again): (&str, &str, i64)| {
        let events = [
            Event::Command(active(5).ttl(4000.0), 1.0),
            Event::Ask(1.0),
            Event::Command(active(3).mode(mode), 1.125),
            Event::Ask(1.125),
            Event::Command(active(again).ttl(4000.0), 1.25),
            Event::Ask(1.25),
            go(6, 1.375),
            Event::Ask(1.375),
        ];
        let (args, ..) = buffer(&events, false);
        let moving = |x: f64| {
            let velocity = object! { "data" => nums(&[x, 0.0, 0.0]) };
            object! { "channels" => object! { "velocity_setpoint" => velocity } }
        };
        let goes_on = |entry: Json| {
            let asked = [moving(5.0), entry.clone(), entry, moving(6.0)];
            steps(asked.into_iter().flat_map(|entry| [no_result(), entry]).collect())
        };
        let still = object! { "channels" => Json::Null };
        Case::new(format!("hold/older-and-on/{name}"), &["NCP-RES-010", "NCP-RES-020"], &[Role::Body])
            .call("buffer.run", args)
            .shows(any(vec![goes_on(moving(5.0)), goes_on(still)]))
            .by("/steps/1", "NCP-RES-026")
            .by("/steps/7", "NCP-RES-026")
            .title(format!(
                "Behind an older HOLD ({mode}), a command of the seq {again} that does not advance changes nothing."
            ))
            .flags(&["revived-command"])
            .because("A HOLD that is obeyed is a hold like every other, which only a command that advances ends.")
    };
    [("duplicate", "hold", 5), ("older", "hold", 4), ("duplicate-of-init", "init", 5)].map(case).into()
}

/// A command with an unlisted member in front of all others, behind one that it follows.
fn unlisted(row: &Row) -> Result<Case, ScenarioError> {
    let frame = active(6).frame().text();
    let text = format!("{{\"origin\":{},{}", row.cell("within")?, frame.strip_prefix('{').unwrap_or(&frame));
    let command = Event::Text { text: Json::string(text), now: 1.0625, stops: false };
    let (args, ..) = buffer(&[go(5, 1.0), Event::Ask(1.0), command, Event::Ask(1.125), Event::Ask(1.25)], false);
    let moving = |x: f64| {
        let velocity = object! { "data" => nums(&[x, 0.0, 0.0]), "unit" => "m/s" };
        object! { "channels" => exactly(object! { "velocity_setpoint" => velocity }) }
    };
    let replies = vec![no_result(), moving(5.0), no_result(), moving(6.0), moving(6.0)];
    Ok(row.case(&[Role::Body]).call("buffer.run", args).shows(steps(replies)))
}

/// A frame that is rejected, and then one that says only what it must.
fn left_behind(row: &Row) -> Result<Case, ScenarioError> {
    let frame = |frame: Json, now| Event::Text { text: Json::string(frame.text()), now, stops: false };
    let rejected = patched(active(2).frame(), row.cell("changes")?, row.place)?;
    let least = object! { "kind" => "command_frame", "seq" => 3, "mode" => "active",
    "channels" => object! { "velocity_setpoint" => Json::object() } };
    let events = [go(1, 1.0), frame(rejected, 1.0625), frame(least, 1.125), Event::Ask(1.125), Event::Ask(1.1875)];
    let (args, ..) = buffer(&events, false);
    let empty = || object! { "data" => Json::Array(Vec::new()), "unit" => Json::Null };
    let moves = || object! { "channels" => exactly(object! { "velocity_setpoint" => empty() }) };
    let replies = vec![no_result(), no_result(), no_result(), moves(), moves()];
    Ok(row.case(&[Role::Body]).call("buffer.run", args).shows(steps(replies)))
}

/// A newer command that is rejected for a member behind its channels and its horizon, while an older one is replayed.
fn half_read() -> Vec<Case> {
    let of = |seq: i64, x: f64| {
        let channels = |x: f64| object! { "velocity_setpoint" => object! { "data" => nums(&[x, 0.0, 0.0]) } };
        let frame = object! { "ncp_version" => ncp_text::WIRE_VERSION, "kind" => "command_frame", "seq" => int(seq),
        "mode" => "active", "ttl_ms" => num(1000.0) };
        let frame = frame.with("channels", channels(x));
        frame.with("horizon", Json::Array(vec![channels(x + 1.0), channels(x + 2.0)])).with("horizon_dt_ms", num(125.0))
    };
    let moves = |x: f64| {
        object! { "channels" => object! { "velocity_setpoint" => object! { "data" => nums(&[x, 0.0, 0.0]) } } }
    };
    let goes_on = |x: f64| any(vec![moves(x), object! { "channels" => Json::Null }]);
    let rejected = of(2, 50.0);
    let table = [
        ("time", "NCP-WIRE-020", rejected.clone().with("t", "x".into()).text(), "a time that is a string"),
        ("frame-id", "NCP-WIRE-021", rejected.clone().with("frame_id", Json::Null).text(), "a frame id of null"),
        ("repeated", "NCP-WIRE-007", rejected.clone().and("seq", Json::literal("2")).text(), "its `seq` twice"),
        ("cut", "NCP-WIRE-002", rejected.text().trim_end_matches('}').to_owned(), "no end"),
        ("version", "NCP-WIRE-020", rejected.with("ncp_version", Json::literal("0.5")).text(), "a version as a number"),
    ];
    let case = |(name, rule, text, words): (&str, &'static str, String, &str)| {
        let frame = |text: &str, now| Event::Text { text: Json::string(text), now, stops: false };
        let events = [
            frame(&of(1, 20.0).text(), 1.0),
            Event::Ask(1.0),
            frame(&text, 1.0625),
            Event::Ask(1.0625),
            Event::Ask(1.1875),
            Event::Ask(1.3125),
        ];
        let (args, ..) = buffer(&events, false);
        let replies = vec![no_result(), moves(20.0), no_result(), goes_on(20.0), goes_on(21.0), goes_on(22.0)];
        Case::new(format!("half-read/{name}"), &["NCP-RES-028", rule], &[Role::Body])
            .call("buffer.run", args)
            .shows(steps(replies))
            .title(format!("Of a newer command with {words} no step is replayed."))
            .flags(&["malformed-moves"])
            .because(
                "To reject a frame is to refuse it as a whole; whether the command before goes on is left open, and \
                 what it says is not.",
            )
    };
    table.map(case).into()
}

/// Commands of other channels, one after the other: of each nothing is left in the next.
fn channels_in_turn(row: &Row) -> Result<Case, ScenarioError> {
    let (mut events, mut replies) = (Vec::new(), Vec::new());
    for (seq, now, cell) in [(1, 1.0, "before"), (2, 1.0625, "then"), (3, 1.125, "before")] {
        let channels = Json::read(row.cell(cell)?);
        let frame = active(seq).frame().with("channels", channels.clone());
        events.extend([Event::Text { text: Json::string(frame.text()), now, stops: false }, Event::Ask(now)]);
        replies.extend([no_result(), object! { "channels" => exactly(channels) }]);
    }
    let (args, ..) = buffer(&events, false);
    Ok(row.case(&[Role::Body]).call("buffer.run", args).shows(steps(replies)))
}

fn channels(row: &Row) -> Result<Case, ScenarioError> {
    let written = row.cell("channels")?;
    let frame = active(1).frame().with("channels", Json::read(written));
    let (args, ..) =
        buffer(&[Event::Text { text: Json::string(frame.text()), now: 1.0, stops: false }, Event::Ask(1.125)], false);
    // In a call the negative zero is a word.
    let channels = Json::read(&written.replace("-0.0", "\"-0\""));
    Ok(row
        .case(&[Role::Body])
        .call("buffer.run", args)
        .shows(steps(vec![no_result(), object! { "channels" => exactly(channels) }])))
}
