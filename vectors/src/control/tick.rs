//! The control loop, tick by tick.

use super::{DEFAULT, Gains, channels_at, law, velocity};
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::scenario::{self, Row, ScenarioError, Scenarios, source};
use crate::trace::{any, int, name_of, no_result, num, steps, within};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut cases = newest();
    cases.extend(laws());
    cases.extend(undamped());
    cases.extend(standing());
    cases.extend(Scenarios::read(source!("control/loop"))?.rest(row_case)?);
    cases.extend(super::endures::cases());
    cases.extend(ttls());
    cases.extend(many_ticks());
    cases.extend(links());
    cases.extend(modes());
    cases.extend(safety());
    cases.extend(counters());
    cases.extend(periods());
    let about = "The control loop: which sensor frame a tick uses, what it sends, and what it says about it.";
    Ok(File::new("control", "loop", about, cases))
}

/// A step of a trace with what it shows.
pub(super) type Step = (Json, Json);

/// A frame of that seq at x = seq/16, whose time runs with its seq.
#[expect(clippy::cast_precision_loss, reason = "small seqs")]
fn arrives(seq: i64, now: f64) -> Step {
    arrives_at(seq, seq as f64 / 8.0, &[seq as f64 / 16.0, 0.0, 0.0], now)
}

pub(super) fn arrives_at(seq: i64, t: f64, position: &[f64], now: f64) -> Step {
    frame(seq, t, channels_at(position, Some(&[0.0; 3])), now)
}

pub(super) fn frame(seq: i64, t: f64, channels: Json, now: f64) -> Step {
    let sensor = object! { "seq" => int(seq), "t" => num(t), "channels" => channels };
    (object! { "op" => "sensor", "sensor" => sensor, "now_s" => num(now) }, no_result())
}

/// A tick of which only the command is looked at.
fn commands(now: f64, command: Json) -> Step {
    (object! { "op" => "tick", "now_s" => num(now) }, object! { "command" => command })
}

/// A tick of which only the status is looked at.
fn says(now: f64, status: Json) -> Step {
    (object! { "op" => "tick", "now_s" => num(now) }, object! { "status" => status })
}

/// The command that follows from the frame of that seq, which its position tells from all others.
#[expect(clippy::cast_precision_loss, reason = "small seqs")]
fn moves(seq: i64, now: f64) -> Step {
    moves_by(&[-(seq as f64) / 16.0, 0.0, 0.0], now)
}

pub(super) fn moves_by(data: &[f64], now: f64) -> Step {
    commands(now, object! { "mode" => "active", "channels" => velocity(data) })
}

/// The governor's HOLD.
pub(super) fn holds(now: f64) -> Step {
    commands(now, object! { "mode" => "hold", "channels" => velocity(&[0.0; 3]), "horizon" => Json::Array(Vec::new()) })
}

/// The governor's ESTOP.
pub(super) fn stops(now: f64) -> Step {
    commands(
        now,
        object! { "mode" => "estop", "channels" => velocity(&[0.0; 3]), "horizon" => Json::Array(Vec::new()) },
    )
}

/// A HOLD of the controller.
pub(super) fn waits(now: f64) -> Step {
    commands(now, object! { "mode" => "hold", "channels" => velocity(&[0.0; 3]) })
}

pub(super) fn reset() -> Step {
    (object! { "op" => "reset" }, no_result())
}

pub(super) fn run(
    path: impl Into<String>,
    rules: &[&'static str],
    period: f64,
    limits: Json,
    trace: Vec<Step>,
) -> Case {
    run_with(path, rules, period, limits, Json::object(), trace)
}

fn run_with(
    path: impl Into<String>,
    rules: &[&'static str],
    period: f64,
    limits: Json,
    config: Json,
    trace: Vec<Step>,
) -> Case {
    let (args, results) = trace.into_iter().unzip::<_, _, Vec<_>, Vec<_>>();
    Case::new(path, rules, &[Role::Commander])
        .call(
            "loop.run",
            object! { "period_ms" => num(period), "limits" => limits, "config" => config,
            "steps" => Json::Array(args) },
        )
        .shows(steps(results))
}

const NEWEST: &str = "The loop keeps the newest sensor frame by `seq`, or by `t` while `seq` is 0, never the last \
                      to arrive; the command is made of that frame, and has its `seq`.";

fn newest() -> Vec<Case> {
    let mut cases = Vec::new();
    // Three frames in every order, with a tick after each.
    let orders = [[1, 2, 3], [1, 3, 2], [2, 1, 3], [2, 3, 1], [3, 1, 2], [3, 2, 1]];
    // Unstamped frames so close in time that a coarser clock takes them for one.
    for (name, early, late) in [
        ("within-a-millisecond", 1.0, 1.0 + 1.0 / 4096.0),
        ("within-a-microsecond", 1.0, 1.0 + 1.0 / 4_194_304.0),
        ("neighbours", 1.0, 1.0_f64.next_up()),
        ("smallest", 0.0, 5e-324),
        ("of-a-late-clock", 1_000_000.0, 1_000_000.0 + 1.0 / 4096.0),
        ("below-zero", -1.0, -1.0 + 1.0 / 4096.0),
    ] {
        let at = |t: f64, x: f64, now: f64| arrives_at(0, t, &[x, 0.0, 0.0], now);
        let rising = vec![at(early, 0.5, 1.0), at(late, 0.25, 1.0625), moves_by(&[-0.25, 0.0, 0.0], 1.0625)];
        let falling = vec![at(late, 0.25, 1.0), at(early, 0.5, 1.0625), moves_by(&[-0.25, 0.0, 0.0], 1.0625)];
        for (what, trace) in [("rising", rising), ("falling", falling)] {
            cases.push(
                run(format!("newest/close-in-time/{name}/{what}"), &["NCP-CTRL-011"], 50.0, Json::object(), trace)
                    .title(format!(
                        "Of two unstamped frames that are close in time, the newer is used ({}, {what}).",
                        name.replace('-', " ")
                    ))
                    .flags(&["last-to-arrive"])
                    .because(NEWEST),
            );
        }
    }
    for order in orders {
        let mut trace = Vec::new();
        let mut newest = 0;
        for (nth, seq) in (0_u32..).zip(order) {
            let now = 1.0 + f64::from(nth) / 16.0;
            newest = newest.max(seq);
            trace.extend([arrives(seq, now), moves(newest, now)]);
        }
        let name = order.map(|seq| seq.to_string()).join("-");
        cases.push(
            run(format!("newest/by-seq/{name}"), &["NCP-CTRL-011"], 50.0, Json::object(), trace)
                .title(format!("Frames in the order {name} are used newest first."))
                .flags(&["last-to-arrive"])
                .because(NEWEST),
        );
        // The same below 0, where a stamp is a stamp: the times say the opposite.
        let below = order.map(|seq| seq - 10);
        let mut trace = Vec::new();
        let mut newest = i64::MIN;
        for (nth, seq) in (0_u32..).zip(below) {
            let now = 1.0 + f64::from(nth) / 16.0;
            newest = newest.max(seq);
            trace.push(frame(seq, -(seq as f64), channels_at(&[seq as f64 / 16.0, 0.0, 0.0], Some(&[0.0; 3])), now));
            trace.push(moves(newest, now));
        }
        let name_below = below.map(|seq| seq.to_string().replace('-', "minus-")).join("-");
        cases.push(
            run(format!("newest/below-zero/{name_below}"), &["NCP-CTRL-011"], 50.0, Json::object(), trace)
                .title(format!(
                    "Frames of the seqs {} are used newest first.",
                    below.map(|seq| seq.to_string()).join(", ")
                ))
                .flags(&["last-to-arrive"])
                .because("In rule 11, 0 is no stamp, and every other seq is one."),
        );
        // The same by time, unstamped.
        let mut trace = Vec::new();
        let mut newest = 0_u32;
        for (nth, rank) in (0_u32..).zip(order) {
            let now = 1.0 + f64::from(nth) / 16.0;
            let rank = u32::try_from(rank).unwrap_or_default();
            newest = newest.max(rank);
            trace.push(arrives_at(0, f64::from(rank), &[f64::from(rank) / 16.0, 0.0, 0.0], now));
            trace.push(moves_by(&[-f64::from(newest) / 16.0, 0.0, 0.0], now));
        }
        cases.push(
            run(format!("newest/by-t/{name}"), &["NCP-CTRL-011"], 50.0, Json::object(), trace)
                .title(format!("Unstamped frames of the times {name} are used newest first."))
                .flags(&["last-to-arrive"])
                .because(NEWEST),
        );
    }
    cases
}

/// What the controller makes of a frame without a usable velocity behind one that had it: it damps nothing, or holds.
fn undamped() -> Vec<Case> {
    let still = |x: f64| velocity(&[-x, 0.0, 0.0]);
    let choice = |now: f64, x: f64| {
        let holds = object! { "mode" => "hold", "channels" => velocity(&[0.0; 3]) };
        commands(now, any(vec![object! { "mode" => "active", "channels" => still(x) }, holds]))
    };
    let unusable: [(&str, &str, Option<&[f64]>); 3] = [
        ("none", "no velocity", None),
        ("two-wide", "a velocity of two components", Some(&[0.5, 0.5])),
        ("empty", "an empty velocity", Some(&[])),
    ];
    let case = |(name, words, second): (&str, &str, Option<&[f64]>)| {
        let trace = vec![
            frame(1, 0.0, channels_at(&[0.5, 0.0, 0.0], Some(&[0.5, 0.25, -0.5])), 1.0),
            moves_by(&law(DEFAULT, [0.5, 0.0, 0.0], [0.5, 0.25, -0.5]), 1.0),
            frame(2, 0.0625, channels_at(&[0.25, 0.0, 0.0], second), 1.0625),
            choice(1.0625, 0.25),
        ];
        run_with(format!("law/undamped/{name}"), &["NCP-CTRL-004"], 50.0, Json::object(), DEFAULT.json(), trace)
            .title(format!("A frame with {words} is damped by no velocity of the frame before."))
            .flags(&["reflex-law"])
            .because("Without a usable `pose_velocity` the controller damps nothing or commands a HOLD.")
    };
    unusable.into_iter().map(case).collect()
}

/// A plant that stands, as far as the sensor tells, and whose velocity changes.
fn standing() -> Vec<Case> {
    let at = [0.5, -0.25, 0.125];
    let moving = [[0.5, 0.0, 0.0], [-0.5, 0.25, 0.0], [0.0, 0.0, -0.5], [-0.0, 0.0, 0.5], [0.25, 0.25, 0.25]];
    let case = |is_stamped: bool| {
        let tick = |(nth, velocity): (u32, [f64; 3])| {
            let (t, now) = (f64::from(nth), 1.0 + f64::from(nth) / 16.0);
            let seq = if is_stamped { i64::from(nth) + 1 } else { 0 };
            [frame(seq, t, channels_at(&at, Some(&velocity)), now), moves_by(&law(DEFAULT, at, velocity), now)]
        };
        let trace = (0_u32..).zip(moving).flat_map(tick).collect();
        let path = format!("law/standing/{}", if is_stamped { "stamped" } else { "unstamped" });
        run_with(path, &["NCP-CTRL-001"], 50.0, Json::object(), DEFAULT.json(), trace)
            .title(format!(
                "At one position each {} frame is damped by its own velocity.",
                if is_stamped { "stamped" } else { "unstamped" }
            ))
            .flags(&["reflex-law"])
            .because("The command follows from position and velocity of the frame that the tick used.")
    };
    [true, false].map(case).into()
}

/// What the controller makes of a frame behind another without a stamp: the velocity along x shows which frame it uses,
/// and another axis that it keeps no position of the one before.
fn laws() -> Vec<Case> {
    let configs = [
        ("defaults", DEFAULT),
        ("target", Gains { target: [0.25, -0.25, 0.5], ..DEFAULT }),
        ("stiff", Gains { kp: 4.0, kd: 0.125, max_speed: 10.0, ..DEFAULT }),
        ("damped", Gains { kp: 0.25, kd: 2.0, max_speed: 0.5, ..DEFAULT }),
    ];
    let places = [("y", [0.5, -0.125, -0.25]), ("z", [0.5, 0.25, 0.125]), ("y-and-z", [0.5, -0.125, 0.125])];
    let mut cases = Vec::new();
    for (name, gains) in configs {
        for (axes, position) in places {
            let frames = [([0.5, 0.25, -0.25], [0.125, 0.0625, 0.0]), (position, [-0.0625, 0.0625, 0.0])];
            let ticks = (0_u32..).zip(frames).flat_map(|(nth, (position, moving))| {
                let now = 1.0 + f64::from(nth) / 16.0;
                let arrives = frame(0, f64::from(nth), channels_at(&position, Some(&moving)), now);
                [arrives, moves_by(&law(gains, position, moving), now)]
            });
            let path = format!("law/unstamped/{axes}/{name}");
            let case = run_with(path, &["NCP-CTRL-001"], 50.0, Json::object(), gains.json(), ticks.collect());
            // What follows from the frame before is not made of the newest.
            let velocity = "/steps/3/command/channels/velocity_setpoint/data";
            let case = case.by("/steps/3/command", "NCP-CTRL-011");
            let case = case.by_own(format!("{velocity}/1")).by_own(format!("{velocity}/2"));
            cases.push(
                case.title(format!(
                    "The controller ({name}) takes the position along {} of a second unstamped frame from that frame.",
                    axes.replace('-', " ")
                ))
                .flags(&["reflex-law"])
                .because(
                    "The command is u = \u{2212}kp\u{b7}(p \u{2212} target) \u{2212} kd\u{b7}v of the frame that \
                     the tick used, and of none before it.",
                ),
            );
        }
    }
    cases
}

/// The steps of a row; `loop.txt` says how they are written.
fn trace(row: &Row) -> Result<Vec<Step>, ScenarioError> {
    let mut now = 0.0;
    let mut steps = Vec::new();
    for step in row.steps() {
        let (times, round) = step.repeated();
        let round = round.iter().map(|step| one_step(step, &mut now)).collect::<Result<Vec<_>, _>>()?;
        steps.extend(std::iter::repeat_n(round, times).flatten());
    }
    Ok(steps)
}

fn one_step(step: &scenario::Step, now: &mut f64) -> Result<Step, ScenarioError> {
    let place = step.place;
    let (mut t, mut at) = (None, None);
    for word in step.words() {
        match word.split_once('=') {
            Some(("t", value)) => t = Some(place.double(value)?),
            Some(("at", "-")) => at = Some(Json::object()),
            Some(("at", value)) => at = Some(channels_at(&place.doubles(value)?, Some(&[0.0; 3]))),
            _ => *now = word.strip_prefix('@').map_or(Ok(*now), |time| place.double(time))?,
        }
    }
    let seq = || place.integer(step.word(0, "seq")?);
    #[expect(clippy::cast_precision_loss, reason = "small seqs")]
    Ok(match step.verb() {
        "sensor" => {
            let x = seq()? as f64;
            let channels = at.unwrap_or_else(|| channels_at(&[x / 16.0, 0.0, 0.0], Some(&[0.0; 3])));
            frame(seq()?, t.unwrap_or(x / 8.0), channels, *now)
        }
        "moves" => moves(seq()?, *now),
        "moves-by" => moves_by(&place.doubles(step.word(0, "velocity")?)?, *now),
        "echoes" => commands(*now, object! { "seq" => int(seq()?) }),
        "holds-seq" => commands(*now, object! { "mode" => "hold", "seq" => int(seq()?) }),
        "pauses" => commands(*now, object! { "mode" => "hold" }),
        "waits" => waits(*now),
        "holds" => holds(*now),
        "stops" => stops(*now),
        "idles" => (object! { "op" => "tick", "now_s" => num(*now) }, no_result()),
        "reset" => reset(),
        verb => return Err(place.wants("step of a loop", verb)),
    })
}

fn row_case(row: &Row) -> Result<Case, ScenarioError> {
    let mut limits = Json::object();
    for word in row.cell("limits").unwrap_or_default().split_whitespace() {
        let (name, value) = word.split_once('=').unwrap_or_default();
        let name = match name {
            "fence" => "geofence_radius_m",
            "speed" => "max_speed_mps",
            "timeout" => "command_timeout_ms",
            _ => return Err(row.place.wants("limit", word)),
        };
        limits = limits.with(name, num(row.place.double(value)?));
    }
    let case = run(&row.path, &row.rules, 50.0, limits, trace(row)?);
    Ok(case.title(&row.title).flags(&row.flags).because(&row.why))
}

/// Periods in ms of which two are less, by an ulp, when they are computed in seconds.
const PERIODS_SHORT_IN_SECONDS: [f64; 4] = [125.125, 250.25, 500.1, 1001.0];

fn ttls() -> Vec<Case> {
    let mut cases = Vec::new();
    for period in [1.0, 20.0, 50.0, 100.0, 110.0, 120.7, 125.0, 150.0, 166.7, 250.0, 333.4, 500.0, 1000.0, 20_000.0] {
        let command = object! { "mode" => "active", "ttl_ms" => within(2.0 * period, f64::MAX) };
        cases.push(
            run(
                format!("ttl/period-{period}"),
                &["NCP-CTRL-014"],
                period,
                Json::object(),
                vec![arrives(8, 1.0), commands(1.0, command.clone()), commands(1.125, command)],
            )
            .title(format!("With a period of {period} ms a command lasts {} ms or more.", 2.0 * period))
            .flags(&["short-ttl"])
            .because("The loop raises `ttl_ms` to at least two periods."),
        );
    }
    // Two periods that come out less by way of seconds.
    for period in PERIODS_SHORT_IN_SECONDS {
        let command = object! { "mode" => "active", "ttl_ms" => within(2.0 * period, f64::MAX) };
        cases.push(
            run(
                format!("ttl/seconds/period-{period}"),
                &["NCP-CTRL-014"],
                period,
                Json::object(),
                vec![arrives(8, 1.0), commands(1.0, command)],
            )
            .title(format!("With a period of {period} ms a command lasts two periods or more, to the last digit."))
            .flags(&["short-ttl"])
            .because("The loop raises `ttl_ms` to at least two periods, and no unit takes some of it off."),
        );
    }
    // Two periods that end in no whole microsecond.
    for (name, hertz) in [("3-hertz", 3.0), ("6-hertz", 6.0)] {
        let period = 1000.0 / hertz;
        let lasts = |mode: &str| object! { "mode" => mode, "ttl_ms" => within(2.0 * period, f64::MAX) };
        for (what, words, rule, trace) in [
            ("active", "a command", "NCP-CTRL-015", vec![arrives(8, 1.0), commands(1.0, lasts("active"))]),
            ("waiting", "a HOLD without a frame", "NCP-CTRL-003", vec![commands(1.0, lasts("hold"))]),
        ] {
            cases.push(
                run(format!("ttl/fraction/{name}/{what}"), &["NCP-CTRL-014"], period, Json::object(), trace)
                    .by("/steps/*/command/mode", rule)
                    .title(format!("At {hertz} Hz {words} has a ttl of two periods or more, to the last digit."))
                    .flags(&["short-ttl"])
                    .because("The loop raises `ttl_ms` to at least two periods, and no rounding takes some of it off."),
            );
        }
    }
    // More than a plant enforces, which is no matter of the frame: of commands, HOLDs and ESTOPs.
    for (name, period, modes) in [
        ("a-quarter", 250.0, &["waiting", "burst"][..]),
        ("half-a-minute", 30_000.5, &["active"]),
        ("forty-seconds", 40_000.0, &["active", "waiting", "stale", "burst"]),
        ("a-thousand-seconds", 1e6, &["active"]),
        ("1e300", 1e300, &["active", "waiting"]),
    ] {
        let lasts = |mode: &str| object! { "mode" => mode, "ttl_ms" => within(2.0 * period, f64::MAX) };
        let lost = || arrives_at(400, 100.0, &[0.5, 0.0, 0.0], 1.0625);
        for (what, words, rule, trace) in [
            ("active", "a command", "NCP-CTRL-015", vec![arrives(8, 1.0), commands(1.0, lasts("active"))]),
            ("waiting", "a HOLD without a frame", "NCP-CTRL-003", vec![commands(1.0, lasts("hold"))]),
            ("stale", "a HOLD for its age", "NCP-SAFE-033", vec![arrives(8, 1.0), commands(2.0, lasts("hold"))]),
            (
                "burst",
                "an ESTOP",
                "NCP-CTRL-016",
                vec![arrives(8, 1.0), lost(), commands(1.0625, lasts("estop")), commands(1.125, lasts("estop"))],
            ),
        ] {
            if !modes.contains(&what) {
                continue;
            }
            cases.push(
                run(format!("ttl/long/{name}/{what}"), &["NCP-CTRL-014"], period, Json::object(), trace)
                    .by("/steps/*/command/mode", rule)
                    .title(format!("With a period of {period} ms {words} has a ttl of two periods or more."))
                    .flags(&["short-ttl"])
                    .because(
                        "The loop raises `ttl_ms` to at least two periods, whatever the mode; that a plant enforces a \
                         minute at most does not change the value on the wire.",
                    ),
            );
        }
    }
    // HOLDs of the controller for a frame without a usable position.
    let blind: [(&str, &str, Option<&[f64]>); 5] = [
        ("none", "no position", None),
        ("nan", "a position of NaN", Some(&[f64::NAN, 0.0, 0.0])),
        ("infinite", "an infinite position", Some(&[0.0, 0.0, f64::INFINITY])),
        ("two-wide", "a position of two components", Some(&[0.5, 0.5])),
        ("empty", "an empty position", Some(&[])),
    ];
    for (what, words, position) in blind {
        let period = 250.0;
        let command = object! { "mode" => "hold", "ttl_ms" => within(2.0 * period, f64::MAX) };
        let channels = position.map_or(Json::object(), |position| channels_at(position, None));
        let trace = vec![frame(8, 0.5, channels, 1.0), commands(1.0, command.clone()), commands(1.125, command)];
        cases.push(
            run(format!("ttl/blind/{what}"), &["NCP-CTRL-014"], period, Json::object(), trace)
                .by("/steps/*/command/mode", "NCP-CTRL-003")
                .title(format!("With a period of {period} ms the HOLD for {words} lasts {} ms or more.", 2.0 * period))
                .flags(&["short-ttl"])
                .because("The loop raises `ttl_ms` to at least two periods, whatever the controller commands."),
        );
    }
    // Raised is not set: no controller means its commands for so few milliseconds.
    for period in [0.125, 1.0] {
        let command = object! { "mode" => "active", "ttl_ms" => within(10.0, f64::MAX) };
        cases.push(
            run(
                format!("ttl/not-lowered/period-{period}"),
                &["NCP-CTRL-014"],
                period,
                Json::object(),
                vec![arrives(8, 1.0), commands(1.0, command)],
            )
            .title(format!("With a period of {period} ms a command keeps its own ttl, which is longer."))
            .flags(&["short-ttl"])
            .because("The loop raises `ttl_ms` to at least two periods; it never lowers it."),
        );
    }
    // Outward at 1.5 m/s from 4 m: the fence is 0.67 s away.
    let fence = || object! { "geofence_radius_m" => num(5.0) };
    let outward = || object! { "target" => crate::trace::nums(&[100.0, 0.0, 0.0]) };
    for (period, leaves) in
        [(50.0, false), (100.0, false), (250.0, false), (400.0, true), (500.0, true), (1000.0, true)]
    {
        let at = || arrives_at(1, 1.0, &[4.0, 0.0, 0.0], 1.0);
        let answer = if leaves { holds(1.0) } else { moves_by(&[1.5, 0.0, 0.0], 1.0) };
        let rules: &[&'static str] =
            if leaves { &["NCP-CTRL-014", "NCP-SAFE-051"] } else { &["NCP-SAFE-021", "NCP-CTRL-014"] };
        cases.push(
            run_with(format!("ttl/look-ahead/period-{period}"), rules, period, fence(), outward(), vec![at(), answer])
                .title(format!(
                    "With a period of {period} ms, the governor looks as far ahead as the ttl that is \
                                sent."
                ))
                .flags(&["short-look-ahead", "short-ttl"])
                .because(
                    "The loop raises the ttl to two periods before it governs: 1 m at 1.5 m/s are 667 ms, and \
                          a command's own ttl is 200 ms.",
                ),
        );
    }
    cases
}

/// What holds of the first ticks holds of those behind them.
fn many_ticks() -> Vec<Case> {
    let mut cases = Vec::new();
    for (period, ticks) in [(150.0, 40), (20_000.0, 20)] {
        let lasts = || object! { "ttl_ms" => within(2.0 * period, f64::MAX) };
        let tick = |seq: i64| {
            let now = 1.0 + f64::from(i32::try_from(seq).unwrap_or_default()) * period / 1000.0;
            [arrives(seq, now), commands(now, lasts())]
        };
        let trace = (1..=ticks).flat_map(tick).collect();
        cases.push(
            run(format!("ttl/many-ticks/period-{period}"), &["NCP-CTRL-014"], period, Json::object(), trace)
                .title(format!(
                    "With a period of {period} ms each of {ticks} commands lasts {} ms or more.",
                    2.0 * period
                ))
                .flags(&["short-ttl"])
                .because("The loop raises `ttl_ms` to at least two periods, at every tick."),
        );
    }
    let mut trace = vec![arrives(1, 1.0), moves(1, 1.0)];
    let held = || object! { "mode" => "hold" };
    trace.extend((0..100_u32).map(|nth| commands(1.5625 + f64::from(nth) / 256.0, held())));
    trace.extend([arrives(2, 2.0), moves(2, 2.0)]);
    cases.push(
        run("gate/stale-for-many-ticks", &["NCP-CTRL-015", "NCP-SAFE-033"], 50.0, Json::object(), trace)
            .title("A stale sensor holds at each of a hundred ticks.")
            .flags(&["stale-sensor"])
            .because("The governor holds while the sensor is stale, however long it has been so."),
    );
    cases
}

fn links() -> Vec<Case> {
    let mut cases = Vec::new();
    let gap = |seq: i64| vec![arrives(1, 1.0), moves(1, 1.0), arrives_at(seq, 100.0, &[0.5, 0.0, 0.0], 1.125)];
    let mut lossy = gap(30);
    lossy.extend([stops(1.125), stops(1.25)]);
    let mut again = lossy.clone();
    again.extend([
        reset(),
        arrives_at(31, 131.0, &[0.5, 0.0, 0.0], 1.3125),
        arrives_at(60, 160.0, &[0.5, 0.0, 0.0], 1.3125),
        stops(1.3125),
    ]);
    let mut few = gap(4);
    few.push(moves_by(&[-0.5, 0.0, 0.0], 1.125));
    let mut recovered = lossy.clone();
    recovered.extend((31..=140).map(|seq| {
        arrives_at(seq, 100.0 + f64::from(u32::try_from(seq).unwrap_or_default()), &[0.5, 0.0, 0.0], 1.375)
    }));
    recovered.push(stops(1.375));
    recovered.push(reset());
    recovered.push(arrives_at(141, 241.0, &[0.5, 0.0, 0.0], 1.375));
    recovered.push(moves_by(&[-0.5, 0.0, 0.0], 1.375));
    // So many frames before each tick, none of them lost.
    let fast = |a_tick: i64| -> Vec<Step> {
        let frame = |seq: i64, now: f64| {
            let t = f64::from(u32::try_from(seq).unwrap_or_default());
            arrives_at(seq, t, &[0.5, 0.0, 0.0], now)
        };
        (0..5_i64)
            .flat_map(|nth| {
                let now = 1.0 + f64::from(u32::try_from(nth).unwrap_or_default()) / 8.0;
                let frames = (1..=a_tick).map(move |at| frame(nth * a_tick + at, now));
                frames.chain([moves_by(&[-0.5, 0.0, 0.0], now)])
            })
            .collect()
    };
    let duplicated: Vec<Step> = (0..40).map(|_| arrives(1, 1.0)).chain([moves(1, 1.0)]).collect();
    let shuffled: Vec<Step> =
        [1, 4, 3, 2, 7, 6, 5].into_iter().map(|seq| arrives(seq, 1.0)).chain([moves(7, 1.0)]).collect();
    // The sum is 5.65 behind the gap, and 0.05 less with each frame behind that.
    let between = |last: i64| -> Vec<Step> {
        let frames = std::iter::once(8).chain(9..=last).map(|seq| arrives_at(seq, 0.0, &[0.5, 0.0, 0.0], 1.0625));
        [arrives(1, 1.0), moves(1, 1.0)].into_iter().chain(frames).collect()
    };
    let mut cleared = between(23);
    cleared.extend([moves_by(&[-0.5, 0.0, 0.0], 1.0625), moves_by(&[-0.5, 0.0, 0.0], 1.125)]);
    let mut lasting = between(12);
    lasting.push(stops(1.0625));
    // A frame of the first seq and a tick, frames of the others and a tick.
    let of_seqs = |first: i64, others: Vec<i64>, tick: fn(f64) -> Step| -> Vec<Step> {
        let at = |seq: i64, t: f64, now: f64| arrives_at(seq, t, &[0.5, 0.0, 0.0], now);
        let before = [at(first, -1.0, 1.0), moves_by(&[-0.5, 0.0, 0.0], 1.0)];
        let frames = (0_u32..).zip(others).map(|(nth, seq)| at(seq, f64::from(nth), 1.0625));
        before.into_iter().chain(frames).chain([tick(1.0625)]).collect()
    };
    let goes_on = |now: f64| moves_by(&[-0.5, 0.0, 0.0], now);
    let table: Vec<(&str, &[&'static str], &str, Vec<Step>)> = vec![
        (
            "cleared-between-ticks",
            &["NCP-SAFE-021", "NCP-CTRL-016"],
            "A burst that rose and cleared between two ticks stops nothing.",
            cleared,
        ),
        (
            "burst-between-ticks",
            &["NCP-CTRL-016", "NCP-SAFE-006"],
            "A burst that rose between two ticks and lasts stops the plant.",
            lasting,
        ),
        (
            "burst-below-zero",
            &["NCP-RES-053", "NCP-CTRL-016"],
            "A burst of losses among negative seqs stops the plant.",
            of_seqs(-100, vec![-60], stops),
        ),
        (
            "burst-across-zero",
            &["NCP-RES-053", "NCP-CTRL-016"],
            "A burst of losses from below 0 to above stops the plant.",
            of_seqs(-3, vec![9], stops),
        ),
        (
            "lowest-seqs",
            &["NCP-CTRL-011", "NCP-RES-053"],
            "Frames of the lowest seqs of the wire move the plant, and none is lost between them.",
            of_seqs(-9_007_199_254_740_991, vec![-9_007_199_254_740_990], goes_on),
        ),
        (
            "burst-from-zero",
            &["NCP-RES-053", "NCP-CTRL-016"],
            "A burst of losses behind a frame of seq 0 stops the plant.",
            of_seqs(0, vec![9], stops),
        ),
        (
            "burst-up-to-zero",
            &["NCP-RES-053", "NCP-CTRL-016"],
            "A burst of losses that ends at seq 0 stops the plant.",
            of_seqs(-9, vec![0], stops),
        ),
        (
            "burst-up-to-below-zero",
            &["NCP-RES-053", "NCP-CTRL-016"],
            "A burst of losses that ends at a seq of \u{2212}1 stops the plant.",
            of_seqs(-30, vec![-1], stops),
        ),
        (
            "few-losses-below-zero",
            &["NCP-RES-053", "NCP-SAFE-007"],
            "Two frames that are lost below 0 are no burst.",
            of_seqs(-9, vec![-6], goes_on),
        ),
        (
            "fast-sensor-across-zero",
            &["NCP-RES-053"],
            "A fast sensor loses nothing where its seq passes 0.",
            of_seqs(-5, (-4..=5).collect(), goes_on),
        ),
        ("burst", &["NCP-CTRL-016", "NCP-SAFE-006"], "A burst of losses stops the plant at the next tick.", lossy),
        ("burst-after-reset", &["NCP-CTRL-016"], "A burst after a reset leads back to ESTOP.", again),
        (
            "burst-clears",
            &["NCP-RES-049", "NCP-CTRL-016", "NCP-SAFE-008"],
            "After the burst and a reset the loop goes on.",
            recovered,
        ),
        ("few-losses", &["NCP-SAFE-007"], "Two lost frames are no burst.", few),
        ("fast-sensor", &["NCP-RES-053"], "A sensor faster than the loop is no loss.", fast(12)),
        ("fast-sensor-of-four", &["NCP-RES-053"], "A sensor four times as fast as the loop is no loss.", fast(4)),
        ("fast-sensor-of-two", &["NCP-RES-053"], "A sensor twice as fast as the loop is no loss.", fast(2)),
        ("fast-sensor-of-100", &["NCP-RES-053"], "A sensor a hundred times as fast as the loop is no loss.", fast(100)),
        ("fast-sensor-of-1100", &["NCP-RES-053"], "A sensor 1,100 times as fast as the loop is no loss.", fast(1100)),
        ("duplicates", &["NCP-RES-042", "NCP-RES-053"], "Duplicates are no loss.", duplicated),
        ("shuffled", &["NCP-RES-041", "NCP-RES-053"], "Frames out of order are no loss.", shuffled),
    ];
    cases.extend(table.into_iter().map(|(name, rules, title, trace)| {
        run(format!("link/{name}"), rules, 50.0, Json::object(), trace).title(title).flags(&["sampled-link"]).because(
            "The monitor sees every arriving frame, not those that a tick samples, and the loop tells the \
                      governor of a burst before it governs.",
        )
    }));
    cases
}

/// A name, what the governor does, the limits, what comes before the tick, and when it is.
type Happening = (&'static str, &'static str, Json, Vec<Step>, f64);

/// What happens to a loop in the cases about its status: the limits, and what comes before the tick.
fn happenings() -> Vec<Happening> {
    let fence = || object! { "geofence_radius_m" => num(5.0) };
    let out = || arrives_at(2, 0.25, &[3.0, 4.0, 1.0], 1.25);
    let lost = || arrives_at(30, 100.0, &[0.5, 0.0, 0.0], 1.25);
    let free = Json::object;
    let wrong = object! { "max_speed_mps" => num(-1.0) };
    // A tick has seen the frame when it came.
    let seen = || vec![arrives(7, 1.0), commands(1.0, Json::object())];
    vec![
        ("active", "passes", free(), vec![arrives(7, 1.0)], 1.0),
        ("held", "holds, as the sensor is stale", free(), seen(), 1.75),
        ("held-clock", "holds, as the clock went back", free(), seen(), 0.5),
        ("held-limits", "holds, as the limits are none", wrong, vec![arrives(7, 1.0)], 1.0),
        ("stopped", "stops, as the body is outside", fence(), vec![arrives(1, 1.0), out()], 1.25),
        ("stopped-by-burst", "stops, as frames were lost", free(), vec![arrives(1, 1.0), lost()], 1.25),
        (
            "stopped-still",
            "stops, as it is latched",
            fence(),
            vec![arrives(1, 1.0), out(), commands(1.25, Json::object()), arrives(3, 1.375)],
            1.375,
        ),
    ]
}

fn mode_of(happening: &str) -> &'static str {
    match happening {
        "active" => "active",
        held if held.starts_with("held") => "hold",
        _ => "estop",
    }
}

/// The mode of the status.
fn modes() -> Vec<Case> {
    let mut cases: Vec<Case> = happenings()
        .into_iter()
        .map(|(name, words, limits, mut trace, now)| {
            let mode = mode_of(name);
            trace.push(says(now, object! { "mode" => mode }));
            run(format!("status/mode/{name}"), &["NCP-CTRL-017"], 50.0, limits, trace)
                .title(format!("The status of a tick whose command the governor {words} says `{mode}`."))
                .because("The status carries the mode that was sent, and not the one that the controller wanted.")
        })
        .collect();
    cases.push(
        run(
            "status/mode/waiting",
            &["NCP-CTRL-017"],
            50.0,
            Json::object(),
            vec![says(1.0, object! { "mode" => "hold" })],
        )
        .title("The status of a tick without a sensor frame says `hold`.")
        .because("The status carries the mode that was sent."),
    );
    cases
}

/// Whether the status calls a tick safe.
fn safety() -> Vec<Case> {
    happenings()
        .into_iter()
        .map(|(name, words, limits, mut trace, now)| {
            let (rule, ok, is, why) = match mode_of(name) {
                "active" => (
                    "NCP-CTRL-018",
                    true,
                    " is",
                    "`safety_ok` is true when the governor passed an active command unchanged.",
                ),
                "hold" => (
                    "NCP-CTRL-021",
                    false,
                    ", should not be",
                    "`safety_ok` should be false when the governor turned an active command into a HOLD.",
                ),
                _ => (
                    "NCP-CTRL-018",
                    false,
                    ", is not",
                    "`safety_ok` is false when the governor turned an active command into an ESTOP.",
                ),
            };
            trace.push(says(now, object! { "safety_ok" => ok }));
            run(format!("status/safety/{name}"), &[rule], 50.0, limits, trace)
                .title(format!("The status of a tick whose active command the governor {words}{is} safe."))
                .because(why)
        })
        .collect()
}

/// The counter of the status, of which where it begins is the loop's affair.
fn counters() -> Vec<Case> {
    let mut cases = Vec::new();
    let table = [
        ("moving", "while the loop is moving", true, 4_u32),
        ("waiting", "while the loop is waiting", false, 4),
        ("long", "for 300 ticks", false, 300),
        ("longer", "for 1,100 ticks", false, 1_100),
        ("longest", "for 65,540 ticks", false, 65_540),
    ];
    for (name, words, with_sensor, ticks) in table {
        let from = |first: i64| {
            let mut trace = if with_sensor { vec![arrives(7, 1.0)] } else { Vec::new() };
            trace.extend((0..ticks).map(|nth| {
                let counted = object! { "seq" => int(first + i64::from(nth)) };
                if ticks <= 300 {
                    says(1.0 + f64::from(nth) / 16.0, counted)
                } else {
                    // Of so many, at one time, the first, the last and some between are looked at.
                    says(
                        1.0,
                        if nth % 550 == 0 && nth < 20_000 || nth % 32_768 == 0 || nth + 1 == ticks {
                            counted
                        } else {
                            Json::object()
                        },
                    )
                }
            }));
            trace
        };
        let case = run(format!("status/counter/{name}"), &["NCP-CTRL-017"], 50.0, Json::object(), from(0));
        let results = |first| steps(from(first).into_iter().map(|(_, result)| result).collect());
        cases.push(
            case.shows(any(vec![results(1), results(0)]))
                .title(format!("The status of each tick has a counter of its own, {words}."))
                .because(
                    "The loop sends a `ControlStatus` each tick with a counter of its own, which is not the \
                          sensor's seq.",
                ),
        );
    }
    cases
}

fn periods() -> Vec<Case> {
    let mut cases: Vec<Case> = [0.0, -0.0, -50.0, -5e-324, -1e308, f64::NAN, f64::INFINITY, f64::NEG_INFINITY]
        .into_iter()
        .map(|period| {
            run(
                format!("period/{}", name_of(period)),
                &["NCP-CTRL-010"],
                period,
                Json::object(),
                vec![arrives(1, 1.0), moves(1, 1.0)],
            )
            .rejects("value")
            .title(format!("A loop with a period of {} ms does not start.", name_of(period)))
            .because("The loop refuses to start without a finite, positive period.")
        })
        .collect();
    // Limits that hold every command are no reason to start.
    for (name, limits) in
        [("fault", object! { "max_speed_mps" => num(-1.0) }), ("fence", object! { "geofence_radius_m" => num(5.0) })]
    {
        for period in [0.0, -50.0, f64::NAN] {
            cases.push(
                run(
                    format!("period/{}/{name}", name_of(period)),
                    &["NCP-CTRL-010"],
                    period,
                    limits.clone(),
                    vec![arrives(1, 1.0), moves(1, 1.0)],
                )
                .rejects("value")
                .title(format!("A loop with a period of {} ms does not start, under limits ({name}).", name_of(period)))
                .because("The loop refuses to start without a finite, positive period, whatever its governor does."),
            );
        }
    }
    let refused = [("kp", f64::NAN), ("kd", -1.0), ("max_speed", f64::INFINITY)];
    cases.extend(refused.into_iter().map(|(name, value)| {
        run_with(
            format!("config/{}", name.replace('_', "-")),
            &["NCP-CTRL-005"],
            50.0,
            Json::object(),
            object! { name => num(value) },
            vec![arrives(1, 1.0), moves(1, 1.0)],
        )
        .rejects("value")
        .title(format!("A loop whose controller has a {name} of {} does not start.", name_of(value)))
        .because("A gain or a max_speed that is not finite or is negative is refused when the controller is built.")
    }));
    cases
}
