//! What holds one by one, together: the limits after everything that happens, every gate with a horizon, and much of
//! everything.

use super::model::{Limits, Sensor, Step, Trace, govern};
use super::{case, near, row_case};
use crate::case::{Case, File};
use crate::command::{Channel, Command, MPS, VELOCITY, channel, velocity};
use crate::json::{Json, object};
use crate::scenario::{ScenarioError, Scenarios, source};
use crate::trace::{any, beginning, int, nums, refused, steps};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut cases = Scenarios::read(source!("safety/together"))?.rest(row_case)?;
    cases.extend(at_the_limit());
    cases.extend(kept_fields());
    cases.extend(many_channels());
    cases.extend(wide_speeds());
    cases.extend(widest());
    cases.extend(most_channels());
    cases.extend(long_horizons());
    let about = "Gates and limits together: what a governor keeps, long horizons, many channels and components.";
    Ok(File::new("safety", "together", about, cases))
}

const LATE: &str = "A limit acts on every channel, every component and every step, the last as the first.";

fn one(path: &str, rules: &[&'static str], limits: Limits, steps: Vec<Step>) -> Case {
    case(path, rules, &Trace::new(limits, steps)).flags(&["long-horizon"]).because(LATE)
}

/// Velocities of exactly the limit, bit for bit.
fn at_the_limit() -> Vec<Case> {
    let exact = |(name, v): (&str, [f64; 3])| {
        let trace = Trace::new(Limits::speed(5.0), vec![govern(Command::moving(&v), near())]);
        let channels = object! { VELOCITY => object! { "data" => nums(&v) } };
        case(format!("exactly/{name}"), &["NCP-SAFE-062"], &trace)
            .shows_exactly(steps(vec![object! { "frame" => object! { "mode" => "active", "channels" => channels } }]))
            .title(format!("({}, {}, {}) m/s passes a limit of 5 m/s to the last digit.", v[0], v[1], v[2]))
            .flags(&["off-by-a-boundary"])
            .because("The governor leaves a velocity unchanged whose norm is not above the limit.")
    };
    [("three-four", [3.0, 4.0, 0.0]), ("four-three", [0.0, -4.0, 3.0]), ("x", [5.0, 0.0, 0.0])].map(exact).into()
}

/// Every field of a command that passes, under each limit and with a horizon or without.
fn kept_fields() -> Vec<Case> {
    let limits = [
        ("no-limit", Limits::NONE),
        ("speed", Limits::speed(2.0)),
        ("fence", Limits::fence(5.0)),
        ("both", Limits { speed: Some(2.0), ..Limits::fence(5.0) }),
    ];
    let ways: [(&str, &str, &[[f64; 3]]); 2] =
        [("alone", "without a horizon", &[]), ("horizon", "with a horizon", &[[0.5, 0.0, 0.0], [0.0, 0.25, 0.0]])];
    let mut cases = Vec::new();
    for (with, limits) in limits {
        for (name, words, ways) in ways {
            let mut steps = Vec::new();
            for (frame_id, seq, t, ttl) in
                [("front", 7, -2.25, 333.5), ("", 0, 0.0, 125.0), ("map/odom \u{e9}", -5, 1e9, 62.5)]
            {
                let command = Command { frame_id, t, ..Command::moving(&[0.25, -0.5, 0.0]).seq(seq).ttl(ttl) };
                steps.push(govern(if ways.is_empty() { command } else { command.then(12.5, ways) }, near()));
            }
            cases.push(
                case(format!("fields/{with}/{name}"), &["NCP-SAFE-021"], &Trace::new(limits, steps))
                    .title(format!("A command {words} that passes under {} keeps every field.", with.replace('-', " ")))
                    .flags(&["over-strict"])
                    .because("A command at which no gate closes passes as it is, but for what a limit changes."),
            );
        }
    }
    cases
}

fn many_channels() -> Vec<Case> {
    let fast = |name: String| channel(&name, &[6.0, 8.0, 0.0], Some(MPS));
    let channels = |last: Channel| -> Vec<Channel> {
        ('a'..='t').map(|name| fast(name.to_string())).chain([velocity(&[6.0, 8.0, 0.0]), last]).collect()
    };
    let wide = |last: f64| {
        let mut data = [0.0; 20];
        data[19] = last;
        channel("wide", &data, Some(MPS))
    };
    let of = |name: &str, rules: &[&'static str], limits: Limits, channels: Vec<Channel>| {
        one(&format!("channels/{name}"), rules, limits, vec![govern(Command::of(channels), near())])
    };
    let still = || velocity(&[1.0, 0.0, 0.0]);
    let plain = |last: Channel| vec![still(), last];
    let behind = |count: usize, last: Vec<Channel>| -> Vec<Channel> {
        (0..count).map(|nth| channel(&format!("a{nth:03}"), &[1.0], None)).chain(last).collect()
    };
    vec![
        of("twenty-two", &["NCP-SAFE-065", "NCP-SAFE-060"], Limits::speed(2.0), channels(fast("z".to_owned())))
            .title("Of 22 channels in m/s each is limited."),
        of("last-not-finite", &["NCP-SAFE-064"], Limits::speed(20.0), channels(channel("z", &[f64::NAN], None)))
            .title("A component that is not finite in the last of 22 channels holds."),
        of("wide", &["NCP-SAFE-065", "NCP-SAFE-060"], Limits::speed(2.0), plain(wide(10.0)))
            .title("A channel of twenty components is limited by its last."),
        of("wide-not-finite", &["NCP-SAFE-064"], Limits::NONE, plain(wide(f64::INFINITY)))
            .title("The last of twenty components holds where it is not finite."),
        of(
            "behind-forty",
            &["NCP-SAFE-065", "NCP-SAFE-060"],
            Limits::speed(2.0),
            behind(40, vec![still(), fast("z".to_owned())]),
        )
        .title("Behind 40 other channels one in m/s is limited."),
        of(
            "behind-forty-not-finite",
            &["NCP-SAFE-064"],
            Limits::speed(2.0),
            behind(40, vec![still(), channel("z", &[f64::NAN], None)]),
        )
        .title("Behind 40 other channels a component that is not finite holds."),
        of(
            "velocity-behind-forty",
            &["NCP-SAFE-011", "NCP-SAFE-060"],
            Limits::speed(2.0),
            behind(40, vec![velocity(&[6.0, 8.0, 0.0])]),
        )
        .title("Behind 40 other channels the velocity is limited."),
        of(
            "velocity-behind-three-hundred",
            &["NCP-SAFE-011", "NCP-SAFE-052"],
            Limits::fence(5.0),
            behind(300, vec![still()]),
        )
        .title("Behind 300 other channels the velocity is found, and projected."),
        of("velocity-259-wide", &["NCP-SAFE-063"], Limits::speed(2.0), vec![velocity(&[0.0; 259])])
            .title("A velocity of 259 components, which are 3 in eight bits, is held."),
    ]
}

/// Channels of more components than a vector has, of which each is far below the limit, and their norm is not.
fn wide_speeds() -> Vec<Case> {
    let one_of = |width: usize, x: f64| {
        let command = Command::of(vec![velocity(&[1.0, 0.0, 0.0]), channel("motors", &vec![x; width], Some("m/s"))]);
        one(&format!("wide/{width}"), &["NCP-SAFE-065"], Limits::speed(5.0), vec![govern(command, near())])
            .title(format!("The norm of a channel of {width} components of {x} m/s each is above 5 m/s."))
            .flags(&["first-channel"])
            .because("A channel in `m/s` has one norm, that of all its values.")
    };
    let widths = [(4, 2.75), (5, 2.5), (16, 1.375), (64, 0.75), (300, 0.375), (1025, 0.1875), (4097, 0.093_75)];
    widths.map(|(width, x)| one_of(width, x)).into()
}

/// Components behind a thousand others, and behind as many as 16 bits count.
fn widest() -> Vec<Case> {
    let still = || velocity(&[1.0, 0.0, 0.0]);
    let ends_with = |width: usize, x: f64, last: f64, unit: Option<&str>| {
        let mut data = vec![x; width];
        if let Some(end) = data.last_mut() {
            *end = last;
        }
        channel("motors", &data, unit)
    };
    // In a step that is not the last.
    let in_step = |channel: Channel| {
        let mut command = Command::moving(&[1.0, 0.0, 0.0]).then(50.0, &[[1.0, 0.0, 0.0]; 3]);
        if let Some(step) = command.horizon.get_mut(1) {
            step.push(channel);
        }
        command
    };
    let mut cases = Vec::new();
    for (width, words) in [(1_025, "1,025"), (4_097, "4,097"), (65_537, "65,537")] {
        let strange = || ends_with(width, 0.5, f64::NAN, None);
        let trace = vec![
            govern(Command::of(vec![still(), strange()]), near()),
            govern(Command::of(vec![still(), ends_with(width, 0.5, 0.25, None)]).seq(8), near()),
        ];
        let modes = |first: Vec<Json>| {
            let passes = object! { "frame" => object! { "mode" => "active", "seq" => int(8) } };
            steps(vec![any(first), passes])
        };
        let holds = || object! { "frame" => object! { "mode" => "hold" } };
        cases.push(
            one(&format!("widest/not-finite/{width}"), &["NCP-SAFE-064"], Limits::NONE, trace)
                .shows(modes(vec![holds(), refused()]))
                .by("/steps/1", "NCP-SAFE-022")
                .title(format!(
                    "A channel of {words} components whose last is not finite is held, and the next passes."
                )),
        );
        // The other roads, once beyond ten bits.
        if width != 1_025 {
            continue;
        }
        cases.push(
            one(
                &format!("widest/step-not-finite/{width}"),
                &["NCP-SAFE-067"],
                Limits::NONE,
                vec![govern(in_step(strange()), near())],
            )
            .title(format!(
                "A horizon is truncated before a step with a channel of {words} components whose last is not finite, \
                 or the command is held."
            )),
        );
        for (name, rules, words, command) in [
            (
                "limited",
                ["NCP-SAFE-065", "NCP-SAFE-060"],
                "A channel",
                Command::of(vec![still(), ends_with(width, 0.0, 9.0, Some(MPS))]),
            ),
            (
                "step-limited",
                ["NCP-SAFE-066", "NCP-SAFE-065"],
                "The channel of a step",
                in_step(ends_with(width, 0.0, 9.0, Some(MPS))),
            ),
        ] {
            cases.push(
                one(&format!("widest/{name}/{width}"), &rules, Limits::speed(2.0), vec![govern(command, near())])
                    .title(format!("{words} of {width} components in m/s is limited by its last.")),
            );
        }
    }
    cases
}

/// The last of so many channels that a table of fixed size has no room for it. Only that one is looked at.
fn most_channels() -> Vec<Case> {
    let behind = |count: usize, last: Channel| -> Vec<Channel> {
        let others = (0..count).map(|nth| channel(&format!("a{nth:03}"), &[1.0], None));
        others.chain([velocity(&[1.0, 0.0, 0.0]), last]).collect()
    };
    let fast = || channel("z", &[6.0, 8.0, 0.0], Some(MPS));
    let strange = || channel("z", &[f64::NAN], None);
    let limited = || object! { "z" => object! { "data" => nums(&[1.2, 1.6, 0.0]) } };
    let step = |last: Channel| {
        let mut command = Command::moving(&[1.0, 0.0, 0.0]).then(50.0, &[[1.0, 0.0, 0.0]]);
        command.horizon.push(behind(129, last));
        command
    };
    let frame = |frame: Json| object! { "frame" => frame };
    let of = |name: &str, rules: &[&'static str], command: Command, answers: Vec<Json>, title: &str| {
        one(&format!("most-channels/{name}"), rules, Limits::speed(2.0), vec![govern(command, near())])
            .shows(steps(vec![any(answers)]))
            .title(title)
    };
    vec![
        of(
            "limited",
            &["NCP-SAFE-065", "NCP-SAFE-060"],
            Command::of(behind(519, fast())),
            vec![frame(object! { "mode" => "active", "channels" => limited() })],
            "Behind 520 other channels one in m/s is limited.",
        ),
        of(
            "not-finite",
            &["NCP-SAFE-064"],
            Command::of(behind(129, strange())),
            vec![frame(object! { "mode" => "hold" }), refused()],
            "Behind 130 other channels a component that is not finite holds.",
        ),
        of(
            "not-finite-behind-270",
            &["NCP-SAFE-064"],
            Command::of(behind(269, strange())),
            vec![frame(object! { "mode" => "hold" }), refused()],
            "Behind 270 other channels a component that is not finite holds.",
        ),
        of(
            "step-limited",
            &["NCP-SAFE-066", "NCP-SAFE-065"],
            step(fast()),
            vec![frame(object! { "mode" => "active",
            "horizon" => Json::Array(vec![Json::object(), object! { "z" => object! {
            "data" => nums(&[1.2, 1.6, 0.0]) } }]) })],
            "Behind 130 other channels of a step one in m/s is limited.",
        ),
    ]
}

/// Horizons of 20 to 300 steps: beyond what is counted in four, six and eight bits.
fn long_horizons() -> Vec<Case> {
    const FAST: [f64; 3] = [3.0, 4.0, 0.0];
    const STILL: [f64; 3] = [0.0; 3];
    let of = |name: &str, rules: &[&'static str], limits: Limits, command: Command, at: f64| {
        let path = format!("horizon/{name}");
        one(&path, rules, limits, vec![govern(command.ttl(60_000.0), Sensor::at(&[at, 0.0, 0.0]))])
    };
    let along = |first: f64, parts: &[(usize, [f64; 3])]| {
        let ticks = parts.iter().flat_map(|(times, v)| std::iter::repeat_n(*v, *times));
        Command::moving(&[first, 0.0, 0.0]).then(1.0, &ticks.collect::<Vec<_>>())
    };
    let changed = |mut command: Command, step: usize, channels: Vec<Channel>| {
        if let Some(tick) = command.horizon.get_mut(step - 1) {
            *tick = channels;
        }
        command
    };
    let (x, no_velocity) = (|x: f64| [x, 0.0, 0.0], vec![channel("gripper", &[1.0], None)]);
    vec![
        of("limited", &["NCP-SAFE-066"], Limits::speed(2.0), along(1.0, &[(32, x(1.0)), (268, FAST)]), 0.0)
            .title("Of 300 steps each that is too fast is limited, from the 33rd to the last."),
        of(
            "not-finite",
            &["NCP-SAFE-067"],
            Limits::speed(2.0),
            changed(along(1.0, &[(40, x(1.0))]), 36, vec![velocity(&x(f64::NAN))]),
            0.0,
        )
        .title("A horizon is truncated before its 36th step, which is not finite, or the command is held."),
        of(
            "no-velocity",
            &["NCP-SAFE-055"],
            Limits::fence(5.0),
            changed(along(0.0, &[(20, STILL)]), 18, no_velocity),
            4.0,
        )
        .title("Within a fence a horizon goes no further than its 18th step, which has no velocity."),
        of(
            "projected",
            &["NCP-SAFE-050", "NCP-SAFE-054"],
            Limits::fence(5.0),
            along(0.0, &[(255, STILL), (45, x(125.0))]),
            4.0625,
        )
        .title("A horizon that leaves the fence with its 263rd step is truncated before that."),
        of(
            "kept",
            &["NCP-SAFE-053", "NCP-SAFE-054"],
            Limits::fence(5.0),
            along(20.0, &[(256, STILL), (9, x(1e6))]),
            4.0,
        )
        .title("A horizon of which 256 steps are kept is no horizon without steps, whose tick 0 would leave."),
    ]
}

/// Horizons of 4,096 steps, of which only the last is judged, so that the cases stay small.
pub(super) fn longest() -> File {
    const STEPS: usize = 4096;
    let of = |name: &str, rules: &[&'static str], limits: Limits, last: [f64; 3], expected: Json| {
        let mut command = Command::moving(&[0.0; 3]).ttl(60_000.0).then(1.0, &[last]);
        let last = command.horizon.pop();
        // Without a unit, in the negotiated one.
        let still = vec![channel(VELOCITY, &[0.0; 3], None)];
        command.horizon.extend(std::iter::repeat_n(still, STEPS - 1).chain(last));
        let trace = Trace::new(limits, vec![govern(command, Sensor::at(&[4.0, 0.0, 0.0]))]);
        let frame = object! { "mode" => "active", "horizon" => expected };
        case(name, rules, &trace)
            .shows(steps(vec![object! { "frame" => frame }]))
            .flags(&["long-horizon"])
            .because(LATE)
    };
    // Any step, in as few bytes as can say it.
    let before = || std::iter::repeat_n(Json::object(), STEPS - 1);
    let limited = object! { VELOCITY => object! { "data" => nums(&[1.2, 1.6, 0.0]) } };
    let all = before().chain([limited]).collect();
    let mut cases = vec![
        of("limited", &["NCP-SAFE-066"], Limits::speed(2.0), [3.0, 4.0, 0.0], all)
            .title("The last step of the longest horizon is limited."),
        of(
            "projected",
            &["NCP-SAFE-050", "NCP-SAFE-054"],
            Limits::fence(5.0),
            [1e6, 0.0, 0.0],
            any(vec![beginning(before().collect()), Json::Array(Vec::new())]),
        )
        .title("The last step of the longest horizon is not sent where it leaves the fence."),
    ];
    // Steps that need no velocity, since nothing is limited.
    let mut whole = Command::moving(&[1.0, 0.0, 0.0]).ttl(60_000.0).then(1.0, &[[0.5, 0.0, 0.0]]);
    let last = whole.horizon.pop();
    whole.horizon.extend(std::iter::repeat_n(Vec::new(), STEPS - 1).chain(last));
    let half = object! { VELOCITY => object! { "data" => nums(&[0.5, 0.0, 0.0]) } };
    let passed = object! { "mode" => "active", "horizon" => before().chain([half]).collect::<Json>() };
    let trace = Trace::new(Limits::NONE, vec![govern(whole, Sensor::at(&[4.0, 0.0, 0.0]))]);
    cases.push(
        case("passed", &["NCP-SAFE-021"], &trace)
            .shows(steps(vec![object! { "frame" => passed }]))
            .flags(&["long-horizon"])
            .title("The longest horizon passes to its last step where no limit is enabled.")
            .because(LATE),
    );
    // A component that is not finite, in a velocity and in another channel, under each limit.
    let beside = || vec![velocity(&[0.0; 3]), channel("gripper", &[f64::NAN], None)];
    for (name, limits, last) in [
        ("velocity/no-limit", Limits::NONE, vec![velocity(&[0.0, f64::NAN, 0.0])]),
        ("velocity/speed-limit", Limits::speed(2.0), vec![velocity(&[0.0, f64::INFINITY, 0.0])]),
        ("other/no-limit", Limits::NONE, beside()),
    ] {
        let mut command = Command::moving(&[0.0; 3]).ttl(60_000.0).then(1.0, &[[0.0; 3]; STEPS - 1]);
        command.horizon.push(last);
        let trace = Trace::new(limits, vec![govern(command, Sensor::at(&[4.0, 0.0, 0.0]))]);
        let sent = object! { "frame" => object! { "mode" => "active", "horizon" => before().collect::<Json>() } };
        let held = object! { "frame" => object! { "mode" => "hold" } };
        cases.push(
            case(format!("not-finite/{name}"), &["NCP-SAFE-067"], &trace)
                .shows(steps(vec![any(vec![sent, held, refused()])]))
                .flags(&["long-horizon", "non-finite-command"])
                .title(format!(
                    "The last step of the longest horizon is not sent with a component that is not finite ({}).",
                    name.replace('-', " ").replace('/', ", ")
                ))
                .because(LATE),
        );
    }
    let about = "The longest horizon that a frame may have, of which the last step is judged.";
    File::new("safety", "longest", about, cases)
}
