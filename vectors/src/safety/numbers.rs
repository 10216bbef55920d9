//! Strange numbers in every numeric position of a command and a sensor frame.

use super::model::{Limits, Sensor, Trace, govern};
use super::{case, good, near};
use crate::case::{Case, File};
use crate::command::{Command, M, MPS, POSITION, VELOCITY, channel, velocity};
use crate::json::{Json, object};
use crate::trace::{any, name_of, num, nums, refused, steps, within};

pub(super) fn file() -> File {
    let mut cases = commands();
    cases.extend(positions());
    cases.extend(beside());
    cases.extend(speeds());
    cases.extend(fences());
    cases.extend(whole());
    cases.extend(ways());
    let about = "NaN, infinities, negative zero, subnormal and huge numbers in every numeric position of a command \
                 and a sensor frame.";
    File::new("safety", "numbers", about, cases)
}

const STRANGE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const ODD: [f64; 3] = [-0.0, 5e-324, -5e-324];

/// The vector with that component.
fn put(at: usize, value: f64) -> [f64; 3] {
    let mut data = [0.5, 0.25, 0.125];
    if let Some(component) = data.get_mut(at) {
        *component = value;
    }
    data
}

/// Components of the command's channels.
fn commands() -> Vec<Case> {
    let mut cases = Vec::new();
    let limits = [
        ("no-limit", Limits::NONE),
        // The good command is at it, so that scaling what needs none does not fail these cases.
        ("speed-limit", Limits::speed(1.0)),
        ("fence", Limits::fence(5.0)),
    ];
    for (with, limits) in limits {
        for value in STRANGE {
            for at in 0..3 {
                let steps = vec![govern(Command::moving(&put(at, value)), near()), govern(good().seq(8), near())];
                cases.push(
                    case(
                        format!("velocity/{at}/{}/{with}", name_of(value)),
                        &["NCP-SAFE-064"],
                        &Trace::new(limits, steps),
                    )
                    .title(format!(
                        "A velocity whose component {at} is {} is held, with {}.",
                        name_of(value),
                        with.replace('-', " ")
                    ))
                    .flags(&["non-finite-command"])
                    .because("The governor holds when any channel of tick 0 has a component that is not finite."),
                );
            }
            for (name, unit) in [("gripper", None), ("body_rates", Some("rad/s")), ("tow_velocity", Some(MPS))] {
                let command = Command::moving(&[0.5, 0.0, 0.0]).and(channel(name, &[0.5, value], unit));
                cases.push(
                    case(
                        format!("{}/{}/{with}", name.replace('_', "-"), name_of(value)),
                        &["NCP-SAFE-064"],
                        &Trace::new(limits, vec![govern(command, near()), govern(good().seq(8), near())]),
                    )
                    .title(format!(
                        "A command whose channel {name} holds {} is held, with {}.",
                        name_of(value),
                        with.replace('-', " ")
                    ))
                    .flags(&["non-finite-command"])
                    .because(
                        "The governor holds when any channel of tick 0 has a component that is not finite, \
                                  not only the velocity.",
                    ),
                );
            }
        }
        for value in ODD {
            for at in 0..3 {
                cases.push(
                    case(
                        format!("velocity/{at}/{}/{with}", name_of(value)),
                        &["NCP-SAFE-021"],
                        &Trace::new(limits, vec![govern(Command::moving(&put(at, value)), near())]),
                    )
                    .title(format!(
                        "A velocity whose component {at} is {} passes, with {}.",
                        name_of(value),
                        with.replace('-', " ")
                    ))
                    .flags(&["over-strict"])
                    .because("A negative zero and a subnormal number are finite; nothing closes on them."),
                );
            }
        }
        let command = Command::moving(&[0.5, 0.0, 0.0]).and(channel("thrust", &[1e308, -1e308, f64::MAX], Some("N")));
        cases.push(
            case(format!("other/huge/{with}"), &["NCP-SAFE-021"], &Trace::new(limits, vec![govern(command, near())]))
                .title(format!(
                    "A channel in another unit with huge finite numbers passes, with {}.",
                    with.replace('-', " ")
                ))
                .flags(&["over-strict"])
                .because("1e308 is finite, and no limit acts on that channel."),
        );
    }
    // Huge velocities against the fence.
    for value in [1e308, -1e308, f64::MAX, 1e200] {
        for at in 0..3 {
            let steps = vec![govern(Command::moving(&put(at, value)), near()), govern(good().seq(8), near())];
            cases.push(
                case(
                    format!("velocity/{at}/{}/fence", name_of(value)),
                    &["NCP-SAFE-051"],
                    &Trace::new(Limits::fence(5.0), steps),
                )
                .title(format!("A velocity whose component {at} is {value} leads out of the fence and is held."))
                .flags(&["overflowing-norm"])
                .because("The end of tick 0 lies outside the fence, or cannot be computed; nothing latches."),
            );
        }
    }
    cases
}

/// Components of the measured position.
fn positions() -> Vec<Case> {
    let mut cases = Vec::new();
    let still = || Command::moving(&[0.0; 3]);
    for at in 0..3 {
        for value in STRANGE {
            let steps = vec![govern(still(), Sensor::at(&put(at, value))), govern(still().seq(8), near())];
            cases.push(
                case(
                    format!("position/{at}/{}", name_of(value)),
                    &["NCP-SAFE-044", "NCP-SAFE-005"],
                    &Trace::new(Limits::fence(5.0), steps),
                )
                .title(format!("A position whose component {at} is {} latches ESTOP.", name_of(value)))
                .flags(&["non-finite-position"])
                .because("The governor latches ESTOP when a component of the position is not finite."),
            );
        }
        for value in [1e308, -1e308, f64::MAX, 1e200, -1e160] {
            let steps = vec![govern(still(), Sensor::at(&put(at, value))), govern(still().seq(8), near())];
            cases.push(
                case(
                    format!("position/{at}/{}", name_of(value)),
                    &["NCP-SAFE-043", "NCP-SAFE-044", "NCP-SAFE-005"],
                    &Trace::new(Limits::fence(5.0), steps),
                )
                .title(format!("A position whose component {at} is {value} latches ESTOP."))
                .flags(&["overflowing-norm"])
                .because("Its norm is more than the radius, or overflows: both latch."),
            );
        }
        for value in ODD {
            cases.push(
                case(
                    format!("position/{at}/{}", name_of(value)),
                    &["NCP-SAFE-045"],
                    &Trace::new(Limits::fence(5.0), vec![govern(still(), Sensor::at(&put(at, value)))]),
                )
                .title(format!("A position whose component {at} is {} is inside.", name_of(value)))
                .flags(&["over-strict"])
                .because("The norm is not more than the radius."),
            );
        }
    }
    // Without a fence the position does not matter.
    for value in [1e308, -1e308, 5e-324] {
        cases.push(
            case(
                format!("position/no-fence/{}", name_of(value)),
                &["NCP-SAFE-012"],
                &Trace::new(Limits::NONE, vec![govern(good(), Sensor::at(&put(0, value)))]),
            )
            .title(format!("Without a fence, a position of {value} closes nothing."))
            .flags(&["over-strict"])
            .because("A limit that is absent is disabled."),
        );
    }
    // Only the position latches.
    let mut channels = vec![channel("imu_accel", &[1e308, -1e308, 0.0], Some("m/s2"))];
    channels.push(channel(POSITION, &[1.0, 2.0, 2.0], Some(M)));
    cases.push(
        case(
            "position/other-channel/huge",
            &["NCP-SAFE-010"],
            &Trace::new(Limits::fence(5.0), vec![govern(good(), Sensor::of(channels))]),
        )
        .title("Huge numbers in another sensor channel latch nothing.")
        .flags(&["first-channel"])
        .because("The geofence acts on `pose_position`."),
    );
    cases
}

/// `ttl_ms`, `t` and the clock.
fn beside() -> Vec<Case> {
    let mut cases = Vec::new();
    // A plant does nothing with such a ttl; a governor may pass it or hold.
    for ttl in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, -1.0, 5e-324, 1e308] {
        for (with, limits) in [("no-limit", Limits::NONE), ("fence", Limits::fence(5.0))] {
            let command = Command::of(vec![velocity(&[0.0625, 0.0, 0.0])]).ttl(ttl);
            let trace = Trace::new(limits, vec![govern(command, Sensor::at(&[0.0; 3]))]);
            let frame = |mode: &str, x: f64| {
                object! { "frame" => object! { "mode" => mode,
                "seq" => crate::trace::int(7),
                    "channels" => object! { VELOCITY => object! { "data" => nums(&[x, 0.0, 0.0]) } } } }
            };
            let allowed: Vec<Json> = vec![frame("active", 0.0625), frame("hold", 0.0), refused()];
            let usable = ttl == 5e-324 || ttl == 1e308;
            let case = case(format!("ttl/{}/{with}", name_of(ttl)), &["NCP-SAFE-021"], &trace)
                .title(format!(
                    "A command with a ttl of {} is answered, with {}.",
                    name_of(ttl),
                    with.replace('-', " ")
                ))
                .flags(&["L12"]);
            cases.push(if usable {
                case.because("No gate closes on a ttl that is finite and positive, and the projection ends at 60 s.")
            } else {
                case.shows(steps(vec![any(allowed)])).because(
                    "No gate closes on such a ttl, and the plant does not act on it: what comes back is \
                              the command or a HOLD.",
                )
            });
        }
    }
    for t in [-0.0, 5e-324, 1e308, -1e308] {
        let mut command = good();
        command.t = t;
        cases.push(
            case(
                format!("t/{}", name_of(t)),
                &["NCP-SAFE-021"],
                &Trace::new(Limits::both(2.0, 5.0), vec![govern(command, near())]),
            )
            .title(format!("A command of the time {} passes.", name_of(t)))
            .flags(&["L25"])
            .because("`t` is the sender's and is compared with nothing."),
        );
    }
    for (name, now, last) in [("subnormal", 5e-324, 0.0), ("huge", 1e308, 1e308), ("minus-zero", 0.0, -0.0)] {
        let step = super::model::Step::Govern { command: good(), now, sensor: Some(near()), last: Some(last) };
        cases.push(
            case(format!("clock/{name}"), &["NCP-SAFE-034"], &Trace::new(Limits::NONE, vec![step]))
                .title(format!("A clock that reads {now} s, {} s after the sensor, is a clock.", now - last))
                .because("Both are finite, now is not less than last, and the age is not more than the timeout."),
        );
    }
    let step = super::model::Step::Govern { command: good(), now: 1e308, sensor: Some(near()), last: Some(0.0) };
    cases.push(
        case("clock/overflow", &["NCP-SAFE-033"], &Trace::new(Limits::NONE, vec![step]))
            .title("A sensor 1e308 s old is stale, though its age in milliseconds overflows.")
            .because("The age is more than the timeout."),
    );
    cases
}

/// 2^e times a small number, which is exact: in two steps, since not every power is a double.
fn size(x: f64, exponent: i32) -> f64 {
    x * 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2)
}

/// A frame of that velocity in every tick that is listed.
fn moving(ticks: &[Json]) -> Json {
    let channels = |data: &Json| object! { VELOCITY => object! { "data" => data.clone() } };
    let (first, rest) = ticks.split_first().map_or((&Json::Null, ticks), |(first, rest)| (first, rest));
    let horizon: Json = rest.iter().map(channels).collect();
    let frame = object! { "mode" => "active", "channels" => channels(first) };
    object! { "frame" => if rest.is_empty() { frame } else { frame.and("horizon", horizon) } }
}

/// Velocities and limits whose squares, products or quotients leave the doubles.
fn speeds() -> Vec<Case> {
    let mut cases = Vec::new();
    let passes: [(&str, f64, [f64; 3]); 18] = [
        ("huge", 1e170, [1e160, 0.0, 0.0]),
        ("huge-on-three-axes", 1e170, [1e160, -1e160, 1e160]),
        ("far-below-a-huge-limit", 1e170, [0.5, 0.25, 0.125]),
        ("tiny", 1e-165, [0.0, 1e-170, 0.0]),
        ("tiny-on-three-axes", 1e-165, [1e-170, 1e-170, -1e-170]),
        ("at-a-huge-limit", size(5.0, 600), [size(3.0, 600), size(-4.0, 600), 0.0]),
        ("at-a-tiny-limit", size(5.0, -600), [0.0, size(4.0, -600), size(3.0, -600)]),
        ("at-a-subnormal-limit", size(5.0, -1074), [size(3.0, -1074), 0.0, size(-4.0, -1074)]),
        ("at-the-largest-limit", f64::MAX, [0.0, f64::MAX, 0.0]),
        ("below-the-largest-limit", f64::MAX, [1e308, 0.0, -1e308]),
        ("at-the-least-limit", 5e-324, [0.0, 0.0, -5e-324]),
        ("subnormal", 1e-160, [5e-324, -5e-324, 5e-324]),
        // The squares of these are subnormal, and have few digits.
        ("few-digits/e-162", 5.501_375_460_7e-162, [2.89e-162, 1.83e-162, 4.17e-162]),
        ("few-digits/e-161", 2.613_777_326_622e-161, [1.47e-161, 1.21e-161, 1.79e-161]),
        ("few-digits/e-160", 3.364_007_322_531e-160, [2.6e-160, 1.39e-160, 1.62e-160]),
        ("few-digits/e-159", 3.797_749_409_442e-159, [2.73e-159, 2.1e-159, 1.6e-159]),
        ("of-very-different-size", 2e170, [1e170, 1e-170, -1.0]),
        ("next-to-nothing-beside-the-limit", 1e-150, [9e-151, 1e-170, 5e-324]),
    ];
    for (name, limit, velocity) in passes {
        let trace = Trace::new(Limits::speed(limit), vec![govern(Command::moving(&velocity), near())]);
        cases.push(
            case(format!("range/speed/{name}"), &["NCP-SAFE-062"], &trace)
                .shows_exactly(steps(vec![moving(&[nums(&velocity)])]))
                .title(format!(
                    "A velocity of ({:?}, {:?}, {:?}) m/s is not above a limit of {limit:?} m/s.",
                    velocity[0], velocity[1], velocity[2]
                ))
                .flags(&["overflowing-norm"])
                .because("A velocity whose norm is not above the limit is unchanged, whatever becomes of its squares."),
        );
    }
    let third = (1.0_f64 / 3.0).sqrt();
    let scaled: [(&str, f64, [f64; 3], [f64; 3]); 20] = [
        ("tiny", 1e-170, [1e-165, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ("tiny-on-three-axes", 1e-170, [1e-165, 1e-165, 1e-165], [third; 3]),
        ("tiny-on-two-axes", 1e-165, [0.0, -3e-160, 4e-160], [0.0, -0.6, 0.8]),
        ("tiny-just-above", size(5.0, -600) * (1.0 - 1e-9), [0.0, size(3.0, -600), size(4.0, -600)], [0.0, 0.6, 0.8]),
        (
            "few-digits/e-162",
            3.979_005_167_1e-162,
            [2.38e-162, 1.85e-162, 2.72e-162],
            [0.586_176_670_307_218_2, 0.455_641_529_440_484_75, 0.669_916_194_636_820_8],
        ),
        (
            "few-digits/e-161",
            4.690_564_656_884e-161,
            [2.85e-161, 2.66e-161, 2.61e-161],
            [0.607_481_232_737_765_3, 0.566_982_483_888_581, 0.556_324_918_401_953_4],
        ),
        (
            "few-digits/e-160",
            3.664_934_688_757e-160,
            [1.95e-160, 1.18e-160, 2.87e-160],
            [0.532_068_444_761_673_9, 0.321_969_622_983_987_35, 0.783_095_608_444_104_8],
        ),
        (
            "few-digits/e-159",
            4.488_830_492_903e-159,
            [2.82e-159, 2.14e-159, 2.76e-159],
            [0.628_225_981_813_860_9, 0.476_738_865_631_795_2, 0.614_859_471_562_502_2],
        ),
        ("beside-the-subnormal", 1e-300, [3e-299, 0.0, 4e-299], [0.6, 0.0, 0.8]),
        ("to-a-tiny-limit", 1e-170, [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]),
        ("quotient-vanishes", 1e-170, [0.0, 0.0, -1e200], [0.0, 0.0, -1.0]),
        ("quotient-vanishes-on-two-axes", 1e-300, [3e300, -4e300, 0.0], [0.6, -0.8, 0.0]),
        ("quotient-is-subnormal", 1e-160, [3e149, 4e149, 0.0], [0.6, 0.8, 0.0]),
        ("huge", 1e170, [1e175, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ("huge-on-three-axes", 1e170, [1e160, 1e175, 1e175], [0.0, 0.5_f64.sqrt(), 0.5_f64.sqrt()]),
        ("huge-just-above", size(5.0, 600) * (1.0 - 1e-9), [size(3.0, 600), size(4.0, 600), 0.0], [0.6, 0.8, 0.0]),
        ("to-one", 1.0, [1e200, 1e190, 0.0], [1.0, 1e-10, 0.0]),
        ("of-very-different-size", 1e-170, [1e160, 1e150, 1.0], [1.0, 1e-10, 0.0]),
        ("largest", 1e300, [0.0, f64::MAX, 0.0], [0.0, 1.0, 0.0]),
        ("of-widely-different-size", 1e-3, [1e-200, 1e3, 5e-324], [0.0, 1.0, 0.0]),
    ];
    for (name, limit, velocity, direction) in scaled {
        let trace = Trace::new(Limits::speed(limit), vec![govern(Command::moving(&velocity), near())]);
        cases.push(
            case(format!("range/scaled/{name}"), &["NCP-SAFE-060", "NCP-SAFE-061"], &trace)
                .shows_exactly(steps(vec![moving(&[about(limit, direction)])]))
                .title(format!(
                    "A velocity of ({:?}, {:?}, {:?}) m/s is scaled to a limit of {limit:?} m/s.",
                    velocity[0], velocity[1], velocity[2]
                ))
                .flags(&["overflowing-norm"])
                .because("A velocity whose norm is above the limit is scaled to it, and keeps its direction."),
        );
    }
    cases.extend(kept());
    cases.extend(other_channels());
    cases.push(of_many_components());
    // A horizon, each of whose steps is above, below or at the limit.
    for (name, limit, one, other) in
        [("tiny", 1e-170, 1e-165, 1e-175), ("huge", 1e170, 1e175, 1e165), ("to-a-tiny-limit", 1e-170, 1e165, 1e-180)]
    {
        let command = Command::moving(&[other, 0.0, 0.0]).then(50.0, &[[one, one, one], [0.0, other, 0.0]]);
        let ticks = [nums(&[other, 0.0, 0.0]), about(limit, [third; 3]), nums(&[0.0, other, 0.0])];
        let trace = Trace::new(Limits::speed(limit), vec![govern(command, near())]);
        cases.push(
            case(format!("range/horizon/{name}"), &["NCP-SAFE-066", "NCP-SAFE-060"], &trace)
                .shows_exactly(steps(vec![moving(&ticks)]))
                .title(format!(
                    "In a horizon, what is above a limit of {limit:?} m/s is scaled to it, and nothing else."
                ))
                .flags(&["overflowing-norm", "unclamped-horizon"])
                .because("The governor applies the speed limit to every step of the horizon."),
        );
    }
    // Between the least double and nothing there is no other.
    let trace = Trace::new(Limits::speed(5e-324), vec![govern(Command::moving(&[0.0, 1.0, 0.0]), near())]);
    cases.push(
        case("range/scaled/to-the-least-limit", &["NCP-SAFE-060"], &trace)
            .shows_exactly(steps(vec![moving(&[Json::Array(vec![num(0.0), within(0.0, 5e-324), num(0.0)])])]))
            .title("A velocity of 1 m/s is scaled to a limit of the least double, or to nothing.")
            .flags(&["overflowing-norm"])
            .because("Its norm is not above the limit then."),
    );
    cases
}

/// Components of very different size: each keeps its part of the direction, however small that is.
fn kept() -> Vec<Case> {
    let half = 0.5_f64.sqrt();
    let table: [(&str, f64, [f64; 3], [f64; 3]); 8] = [
        ("small-beside-huge", 1e170, [1e160, 1e175, 1e175], [half * 1e155, half * 1e170, half * 1e170]),
        ("small-to-one", 1.0, [1e200, -1e190, 0.0], [1.0, -1e-10, 0.0]),
        ("tiny-beside-usual", 1e-3, [1e-200, 1e3, 0.0], [1e-206, 1e-3, 0.0]),
        ("three-sizes", 2.0, [1e250, 1e150, -1e50], [2.0, 2e-100, -2e-200]),
        ("small-beside-tiny", 1e-170, [0.0, 1e-165, 1e-250], [0.0, 1e-170, 1e-255]),
        ("below-what-is-asked", 1e-170, [1e160, 1e-10, 0.0], [1e-170, 0.0, 0.0]),
        ("small-beside-the-largest", 4.5e286, [1e-149, 9e307, 0.0], [5e-171, 4.5e286, 0.0]),
        ("small-under-a-limit-near-the-largest", 9e307, [0.0, 1e-149, 1e308], [0.0, 9e-150, 9e307]),
    ];
    let near = |x: f64| {
        let off = (x.abs() * 1e-9).max(1e-300);
        within(x - off, x + off)
    };
    let one = |(name, limit, velocity, scaled): (&str, f64, [f64; 3], [f64; 3])| {
        let trace = Trace::new(Limits::speed(limit), vec![govern(Command::moving(&velocity), super::near())]);
        case(format!("range/kept/{name}"), &["NCP-SAFE-061"], &trace)
            .shows_exactly(steps(vec![moving(&[scaled.map(near).into_iter().collect()])]))
            .title(format!(
                "Of a velocity of ({:?}, {:?}, {:?}) m/s under a limit of {limit:?} m/s, the small component keeps its \
                 part.",
                velocity[0], velocity[1], velocity[2]
            ))
            .flags(&["overflowing-norm"])
            .because("Each component is the one that came times the limit over the norm, to one part in 10^9.")
    };
    table.into_iter().map(one).collect()
}

/// Channels in m/s beside the velocity, of any width.
fn other_channels() -> Vec<Case> {
    // A limit, a component well above it and one well below, whose squares leave the doubles.
    let table = [("tiny", 1e-170, 1e-165, 1e-175), ("huge", 1e170, 1e175, 1e160), ("plain", 2.0, 1e170, 1e-170)];
    let mut cases = Vec::new();
    for (name, limit, above, below) in table {
        for width in [1_usize, 2, 4, 7] {
            let of = |length: f64| {
                let mut data = vec![0.0; width];
                data[width - 1] = length;
                data
            };
            let ticks = || {
                vec![
                    velocity(&[0.0; 3]),
                    channel("slow", &of(-below), Some(MPS)),
                    channel("fast", &of(above), Some(MPS)),
                ]
            };
            let mut command = Command::of(ticks()).then(50.0, &[[0.0; 3]]);
            command.horizon = vec![ticks()];
            let scaled = || {
                let mut data: Vec<Json> = vec![within(-limit * 1e-9, limit * 1e-9); width];
                data[width - 1] = within(limit * (1.0 - 1e-9), limit * (1.0 + 1e-12));
                object! {
                    "slow" => object! { "data" => nums(&of(-below)) },
                    "fast" => object! { "data" => Json::Array(data) },
                }
            };
            let frame =
                object! { "mode" => "active", "channels" => scaled(), "horizon" => Json::Array(vec![scaled()]) };
            let trace = Trace::new(Limits::speed(limit), vec![govern(command, near())]);
            cases.push(
                case(format!("range/other/{name}/{width}-wide"), &["NCP-SAFE-065", "NCP-SAFE-060"], &trace)
                    .shows_exactly(steps(vec![object! { "frame" => frame }]))
                    .title(format!(
                        "Of two channels of {width} components in m/s, the one above a limit of {limit:?} m/s is \
                         scaled to it, and the other is unchanged."
                    ))
                    .flags(&["overflowing-norm"])
                    .because("Every channel in m/s is limited by its norm, whatever its width and its squares."),
            );
        }
    }
    cases
}

/// Components of so long a vector in that direction, but for the roundings that the text allows.
fn about(limit: f64, direction: [f64; 3]) -> Json {
    let component = |part: f64| {
        let (least, most) = (limit * part.abs() * (1.0 - 1e-9), limit * part.abs() * (1.0 + 1e-12));
        match part {
            // Of what is next to nothing beside the others, doubles may lose all.
            0.0 => within(-limit * 1e-9, limit * 1e-9),
            ..0.0 => within(-most, -least),
            _ => within(least, most),
        }
    };
    Json::Array(direction.into_iter().map(component).collect())
}

/// A great component and so many small ones that they count together, though each is lost beside the great one.
fn of_many_components() -> Case {
    // As many as a frame has room for once they are scaled.
    const MANY: usize = 40_000;
    let (small, limit) = (1.04e-8, 0.5);
    // The norm is the root of 1 + MANY * small^2, which is nearly 1 and a half of that.
    let norm = 1.0 + MANY as f64 * small * small / 2.0;
    let data = [vec![1.0], vec![small; MANY]].concat();
    let command = Command::of(vec![velocity(&[0.1, 0.0, 0.0]), channel("wheels", &data, Some(MPS))]);
    let trace = Trace::new(Limits::speed(limit), vec![govern(command, near())]);
    let about = |part: f64| within(part * limit / norm * (1.0 - 1e-9), part * limit / norm * (1.0 + 1e-12));
    let scaled = [vec![about(1.0)], vec![about(small); MANY]].concat();
    let wheels = object! { "data" => Json::Array(scaled) };
    let frame = object! { "mode" => "active", "channels" => object! { "wheels" => wheels } };
    case("range/scaled/of-many-components", &["NCP-SAFE-060", "NCP-SAFE-065"], &trace)
        .shows_exactly(steps(vec![object! { "frame" => frame }]))
        .title("A channel of 40,001 components is scaled by all of them.")
        .flags(&["overflowing-norm"])
        .because("The norm is that of all components, and what is sent is not above the limit by more than a rounding.")
}

/// Fences and positions whose squares leave the doubles.
fn fences() -> Vec<Case> {
    let still = || Command::moving(&[0.0; 3]);
    let table: [(&str, f64, [f64; 3], bool); 20] = [
        ("huge", 1e170, [1e160, 0.0, 0.0], true),
        ("huge-on-three-axes", 1e170, [1e160, -1e160, 1e160], true),
        ("on-a-huge-fence", size(5.0, 600), [size(3.0, 600), 0.0, size(-4.0, 600)], true),
        ("on-a-tiny-fence", size(5.0, -600), [0.0, size(3.0, -600), size(4.0, -600)], true),
        ("on-a-subnormal-fence", size(5.0, -1074), [size(3.0, -1074), size(4.0, -1074), 0.0], true),
        ("on-the-largest-fence", f64::MAX, [0.0, 0.0, -f64::MAX], true),
        ("below-the-largest", f64::MAX, [1e308, 1e308, 0.0], true),
        ("on-the-least-fence", 5e-324, [-5e-324, 0.0, 0.0], true),
        ("tiny", 1e-165, [1e-170, 1e-170, 1e-170], true),
        ("of-very-different-size", 2e170, [1e170, 1e-170, 1.0], true),
        ("above-a-tiny-fence", 1e-170, [1e-165, 0.0, 0.0], false),
        ("above-a-tiny-fence-on-three-axes", 1e-170, [1e-165, 1e-165, -1e-165], false),
        ("each-component-within-a-tiny-fence", 1e-170, [7e-171, 7e-171, 7e-171], false),
        ("above-a-huge-fence", 1e170, [0.0, 2e170, 0.0], false),
        ("each-component-within-a-huge-fence", 1e170, [7e169, -7e169, 7e169], false),
        ("above-the-least-fence", 5e-324, [0.0, 0.0, 1e-323], false),
        ("each-component-on-the-least-fence", 5e-324, [5e-324, 5e-324, 0.0], false),
        ("each-component-within-a-subnormal-fence", 1.5e-323, [1.5e-323, -5e-324, 5e-324], false),
        ("beyond-the-largest-double", f64::MAX, [1.5e308, 1.5e308, 0.0], false),
        ("next-above-a-tiny-fence", size(5.0, -600).next_down(), [size(3.0, -600), size(4.0, -600), 0.0], false),
    ];
    let mut cases = Vec::new();
    for (name, radius, place, is_inside) in table {
        let (rule, which, why) = if is_inside {
            ("NCP-SAFE-045", "inside", "Its norm is not more than the radius, whatever becomes of its squares.")
        } else {
            ("NCP-SAFE-043", "outside", "Its norm is more than the radius, whatever becomes of its squares.")
        };
        let steps = vec![govern(still(), Sensor::at(&place)), govern(still().seq(8), Sensor::at(&[0.0; 3]))];
        cases.push(
            case(format!("range/fence/{name}"), &[rule], &Trace::new(Limits::fence(radius), steps))
                .title(format!(
                    "A position of ({:?}, {:?}, {:?}) is {which} a fence of {radius:?} m.",
                    place[0], place[1], place[2]
                ))
                .flags(&["overflowing-norm"])
                .because(why),
        );
    }
    cases
}

/// Whole numbers of metres whose norm is one, so that it is exact where nothing is divided.
const WHOLE: [(f64, [[f64; 3]; 8]); 6] = [
    (
        13.0,
        [
            [5.0, 12.0, 0.0],
            [0.0, -5.0, 12.0],
            [12.0, 0.0, 5.0],
            [3.0, 4.0, 12.0],
            [-4.0, 12.0, 3.0],
            [12.0, 3.0, -4.0],
            [0.0, 13.0, 0.0],
            [4.0, 3.0, 12.0],
        ],
    ),
    (
        15.0,
        [
            [2.0, 10.0, 11.0],
            [10.0, 11.0, 2.0],
            [-11.0, 2.0, 10.0],
            [2.0, 5.0, 14.0],
            [14.0, -5.0, 2.0],
            [5.0, 10.0, 10.0],
            [9.0, 12.0, 0.0],
            [0.0, 9.0, 12.0],
        ],
    ),
    (
        65.0,
        [
            [16.0, 63.0, 0.0],
            [0.0, 33.0, 56.0],
            [39.0, 0.0, 52.0],
            [60.0, 25.0, 0.0],
            [15.0, 36.0, 52.0],
            [20.0, -48.0, 39.0],
            [36.0, 52.0, 15.0],
            [25.0, 36.0, 48.0],
        ],
    ),
    // Where the largest component is divided by, or the limit, or its inverse multiplied with, some come out above it.
    (
        27.0,
        [
            [2.0, -7.0, 26.0],
            [7.0, 26.0, 2.0],
            [26.0, 2.0, 7.0],
            [14.0, 2.0, -23.0],
            [-23.0, 14.0, 2.0],
            [10.0, 10.0, 23.0],
            [23.0, -10.0, 10.0],
            [10.0, 23.0, 10.0],
        ],
    ),
    (
        93.0,
        [
            [32.0, 85.0, 20.0],
            [64.0, -8.0, 67.0],
            [85.0, 32.0, 20.0],
            [20.0, 85.0, 32.0],
            [-67.0, 8.0, 64.0],
            [85.0, 20.0, 32.0],
            [32.0, 20.0, -85.0],
            [8.0, 64.0, 67.0],
        ],
    ),
    (
        99.0,
        [
            [74.0, 65.0, 10.0],
            [65.0, 74.0, -10.0],
            [1.0, 98.0, 14.0],
            [26.0, 10.0, 95.0],
            [-14.0, 1.0, 98.0],
            [10.0, 26.0, 95.0],
            [98.0, -1.0, 14.0],
            [14.0, 97.0, 14.0],
        ],
    ),
];

/// Positions exactly on a fence, velocities of exactly the limit, and ways that end exactly on the fence.
fn whole() -> Vec<Case> {
    const WHY: &str = "What is not more than the limit passes, and these norms are exactly it.";
    let of = |(radius, vectors): &(f64, [[f64; 3]; 8])| {
        let on_it = vectors.iter().map(|at| govern(Command::moving(&[0.0; 3]), Sensor::at(at))).collect();
        let as_fast = vectors.iter().map(|v| govern(Command::moving(v), near())).collect();
        let to_it = vectors.iter().map(|v| govern(Command::moving(v).ttl(1000.0), Sensor::at(&[0.0; 3]))).collect();
        let passes = steps(vectors.iter().map(|v| moving(&[nums(v)])).collect());
        [
            case(format!("whole/fence/{radius}"), &["NCP-SAFE-045"], &Trace::new(Limits::fence(*radius), on_it))
                .title(format!("Positions exactly {radius} m from the origin are inside a fence of {radius} m."))
                .flags(&["off-by-a-boundary"])
                .because(WHY),
            case(format!("whole/speed/{radius}"), &["NCP-SAFE-062"], &Trace::new(Limits::speed(*radius), as_fast))
                .shows_exactly(passes)
                .title(format!("Velocities of exactly {radius} m/s pass a limit of {radius} m/s to the last digit."))
                .flags(&["off-by-a-boundary"])
                .because(WHY),
            case(format!("whole/way/{radius}"), &["NCP-SAFE-021"], &Trace::new(Limits::fence(*radius), to_it))
                .title(format!("Commands that lead to exactly {radius} m from the origin pass a fence of {radius} m."))
                .flags(&["off-by-a-boundary"])
                .because(WHY),
        ]
    };
    WHOLE.iter().flat_map(of).collect()
}

/// Ways that end where squares leave the doubles.
fn ways() -> Vec<Case> {
    let mut cases = Vec::new();
    let second = |command: Command| command.ttl(1000.0);
    let along = |x: f64| [x, 0.0, 0.0];
    let table: [(&str, f64, Command, &str, &str); 8] = [
        ("tiny/ends-inside", 1e-170, second(Command::moving(&along(1e-171))), "NCP-SAFE-021", "passes"),
        ("tiny/ends-outside", 1e-170, second(Command::moving(&along(1e-165))), "NCP-SAFE-051", "is held"),
        ("huge/ends-inside", 1e170, second(Command::moving(&[1e160, -1e160, 1e160])), "NCP-SAFE-021", "passes"),
        ("huge/ends-outside", 1e170, second(Command::moving(&along(1e171))), "NCP-SAFE-051", "is held"),
        ("tiny/step-leaves", 1e-170, tick(1e-171, &[1e-171, 1e-165]), "NCP-SAFE-050", "is truncated"),
        ("huge/step-leaves", 1e170, tick(1e160, &[1e160, 1e175]), "NCP-SAFE-050", "is truncated"),
        ("tiny/first-step-leaves", 1e-170, tick(1e-171, &[1e-160]), "NCP-SAFE-053", "is cut to tick 0"),
        ("huge/returns", 1e170, tick(8e169, &[-8e169, -8e169, 8e169]), "NCP-SAFE-021", "passes"),
    ];
    for (name, radius, command, rule, what) in table {
        let trace = Trace::new(Limits::fence(radius), vec![govern(command, Sensor::at(&[0.0; 3]))]);
        cases.push(
            case(format!("range/way/{name}"), &[rule], &trace)
                .title(format!("In a fence of {radius:?} m, a command {what} ({}).", name.replace(['/', '-'], " ")))
                .flags(&["overflowing-norm"])
                .because("The governor projects the commanded velocities, whatever becomes of the squares of an end."),
        );
    }
    cases
}

/// A command of ticks of 250 ms along x, within a ttl of a second.
fn tick(first: f64, steps: &[f64]) -> Command {
    let steps: Vec<[f64; 3]> = steps.iter().map(|x| [*x, 0.0, 0.0]).collect();
    Command::moving(&[first, 0.0, 0.0]).then(250.0, &steps).ttl(1000.0)
}
