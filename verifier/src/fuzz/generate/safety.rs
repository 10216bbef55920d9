//! Traces of the governor and of the loop, and the reflex controller.

use super::plant::{Clock, next_seq};
use super::{Draw, Tree, steps};
use crate::fuzz::tree::{int, list, map, num, nums, object, or_null, set, text};
use crate::json::Json;

/// Which features the commands of a trace have, and how often.
#[derive(Debug, Clone)]
pub(super) struct Shapes {
    /// The modes that occur.
    modes: Vec<&'static str>,
    /// How often there is a horizon, of a hundred, and how long it is at most.
    horizons: u64,
    longest: usize,
    /// How often the length of a tick is none.
    bad_dt: u64,
    /// How often there are other channels than the velocity, and how many.
    more: u64,
    channels: usize,
    /// How often the velocity is absent, of another width or unit.
    odd: u64,
    /// How often a number is not finite.
    strange: u64,
    /// How often the unit is left out.
    unitless: u64,
    /// How often all of a tick stands still, of a hundred.
    still: u64,
    /// How often a field that has a default is left out, of a hundred.
    absent: u64,
    /// How fast it goes, m/s, if that is not any number.
    speed: Option<f64>,
    frame_id: String,
    ttl: Vec<f64>,
    /// How often a mode goes on, of a hundred: long runs of one kind.
    runs: u64,
}

impl Shapes {
    pub(super) fn draw(draw: &mut Draw<'_>) -> Self {
        let modes: &[&'static str] = match draw.below(4) {
            0 => &["active"],
            1 => &["active", "active", "active", "hold", "init"],
            2 => &["active", "active", "hold", "init", "active", "active", "active", "estop"],
            _ => &["active", "active", "active", "hold"],
        };
        let longest = if draw.chance(3) { draw.size(16, 4096) } else { draw.size(1, 12) };
        Self {
            modes: modes.to_vec(),
            horizons: draw.one(&[0, 30, 100]),
            longest,
            bad_dt: draw.one(&[0, 0, 10]),
            more: draw.one(&[0, 0, 30]),
            channels: if longest < 16 && draw.chance(5) { draw.size(1, 80) } else { 2 },
            odd: draw.one(&[0, 0, 10]),
            strange: draw.one(&[0, 0, 0, 5]),
            unitless: draw.one(&[0, 0, 50]),
            still: draw.one(&[0, 0, 10, 60]),
            absent: draw.one(&[0, 0, 0, 12]),
            speed: if draw.chance(75) { Some(draw.one(&[0.5, 1.0, 2.0, 5.0, 10.0])) } else { None },
            frame_id: if draw.chance(30) { draw.string() } else { "world".to_owned() },
            ttl: (0..3).map(|_| ttl(draw)).collect(),
            runs: draw.one(&[0, 0, 80, 97]),
        }
    }

    /// The same where JSON frames are given, which have no word for a number that is not finite.
    fn velocity(&self, draw: &mut Draw<'_>) -> Vec<f64> {
        if draw.chance(self.still) {
            return vec![draw.one(&[0.0, 0.0, -0.0]); 3];
        }
        if let Some(speed) = self.speed
            && draw.chance(12)
        {
            return near(speed, draw);
        }
        if draw.chance(2) {
            return vec![huge(draw), huge(draw), 0.0];
        }
        let axis = draw.below(5);
        let mut data: Vec<f64> = (0..3)
            .map(|at| {
                if axis < 3 && axis != at {
                    return 0.0;
                }
                match self.speed {
                    Some(speed) => speed * draw.range(-16, 16) as f64 / 16.0,
                    None => draw.finite(),
                }
            })
            .collect();
        if draw.chance(self.strange) {
            let at = draw.below(3);
            data[at] = draw.strange();
        }
        if draw.chance(self.odd) {
            // More, too, by as many as one byte or two do not count.
            let width = draw.one(&[0, 1, 2, 2, 4, 6, 256, 259]);
            data.resize(if width < 3 || draw.chance(40) { width } else { 4 }, 0.0);
        }
        data
    }

    fn tick(&self, draw: &mut Draw<'_>) -> Tree {
        let mut channels = Vec::new();
        if !draw.chance(self.odd / 2) {
            let unit = if draw.chance(self.unitless) {
                Json::Null
            } else if draw.chance(self.odd) {
                text(if draw.chance(50) { draw.nearly("m/s") } else { draw.pick(&["m", "km/h", ""]).to_owned() })
            } else {
                text("m/s")
            };
            channels.push(("velocity_setpoint".to_owned(), sample(&self.velocity(draw), unit)));
        }
        if draw.chance(self.more) {
            let count = draw.size(1, self.channels);
            for nth in 0..draw.afford(count) {
                let name = match draw.below(8) {
                    6 => draw.one(&["tow2", "grip_max", "velocity_setpoint_max", "vel", "velocity"]).to_owned(),
                    7 => draw.nearly("velocity_setpoint").replace('$', "S"),
                    0 => "Velocity_setpoint".to_owned(),
                    1 => "velocity_setpoint2".to_owned(),
                    2 => "tow".to_owned(),
                    3 => draw.name().replace('$', "S"),
                    _ => format!("c{nth}"),
                };
                let unit = draw.one(&[Some("m/s"), Some("m/s"), Some("rad"), None]);
                let width = if draw.chance(6) { draw.size(1, 300) } else { draw.one(&[0, 1, 2, 3, 4, 3, 3, 17]) };
                let mut data: Vec<f64> =
                    (0..width).map(|_| if draw.chance(60) { draw.plain() } else { draw.finite() }).collect();
                match self.speed {
                    Some(speed) if width == 3 && draw.chance(12) => data = near(speed, draw),
                    // About as fast as the limit, whatever that is.
                    Some(speed) if draw.chance(20) => {
                        data.fill_with(|| speed * draw.range(-24, 24) as f64 / 16.0);
                    }
                    // Of which the squares leave the doubles, or the norm.
                    _ if draw.chance(6) => data.fill_with(|| huge(draw)),
                    _ => {}
                }
                if width > 0 && draw.chance(2 * self.strange) {
                    let at = draw.below(width);
                    data[at] = draw.strange();
                }
                channels.push((name, sample(&data, or_null(unit.map(text)))));
            }
        }
        map(channels)
    }
}

/// A velocity just above a limit, or just below it: by any tolerance that somebody may think of.
fn near(speed: f64, draw: &mut Draw<'_>) -> Vec<f64> {
    let length = speed * (1.0 + draw.little());
    let length = draw.one(&[length, length, speed.next_up(), speed.next_down(), speed]);
    let of = |x: f64, y: f64, z: f64| vec![x * length, y * length, z * length];
    match draw.below(5) {
        0 => of(1.0, 0.0, 0.0),
        1 => of(0.0, -1.0, 0.0),
        2 => of(0.0, 0.0, 1.0),
        3 => of(0.6, 0.0, -0.8),
        _ => of(2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0),
    }
}

/// A number of which the square, or the sum with another such, leaves the doubles.
fn huge(draw: &mut Draw<'_>) -> f64 {
    draw.one(&[1e200, 1e308, -1e308, 1.5e308, f64::MAX, f64::MIN])
}

fn sample(data: &[f64], unit: Tree) -> Tree {
    object([("data", nums(data)), ("unit", unit)])
}

fn ttl(draw: &mut Draw<'_>) -> f64 {
    match draw.below(8) {
        0 => draw.positive(),
        1 => draw.one(&[0.0, -1.0, 60_000.0, 60_001.0, 120_000.0, 5e-324]),
        _ => draw.one(&[50.0, 100.0, 125.0, 200.0, 250.0, 500.0, 1000.0, 2000.0]),
    }
}

/// The fields of a command.
pub(super) fn command(shapes: &mut Shapes, seq: i64, draw: &mut Draw<'_>) -> Tree {
    let mode = draw.one(&shapes.modes);
    if let Some(at) = shapes.modes.iter().position(|known| *known == mode) {
        // The one that goes on stands first.
        if !draw.chance(shapes.runs) {
            shapes.modes.swap(0, at);
        }
    }
    let mode = if shapes.runs > 0 { shapes.modes[0] } else { mode };
    let ttl = draw.one(&shapes.ttl);
    let t = if draw.chance(10) { draw.finite() } else { seq as f64 / 8.0 };
    let mut command = object([
        ("seq", int(seq)),
        ("t", num(t)),
        ("frame_id", text(shapes.frame_id.clone())),
        ("mode", text(mode)),
        ("ttl_ms", num(ttl)),
        ("channels", shapes.tick(draw)),
    ]);
    if let Json::Object(members) = &mut command {
        members.retain(|(name, _)| name == "channels" || !draw.chance(shapes.absent));
    }
    if draw.chance(shapes.horizons) {
        let count = draw.size(1, shapes.longest);
        let count = draw.afford(count).max(1);
        // Long horizons of few different steps are quick to draw.
        let mut kinds: Vec<Tree> = Vec::new();
        for _ in 0..count.min(6) {
            let kind = match (kinds.last(), command.get("channels")) {
                (Some(before), _) | (None, Some(before)) if draw.chance(25) => nearly_the_same(before, draw),
                _ => shapes.tick(draw),
            };
            kinds.push(kind);
        }
        let in_order = draw.chance(50);
        let nth = |nth: usize, draw: &mut Draw<'_>| if in_order { nth % kinds.len() } else { draw.below(kinds.len()) };
        let horizon = (0..count).map(|step| kinds[nth(step, draw)].clone()).collect();
        set(&mut command, "horizon", list(horizon));
        let dt = if draw.chance(shapes.bad_dt) {
            draw.one(&[0.0, -1.0, -0.0, f64::NAN, f64::INFINITY])
        } else {
            draw.one(&[10.0, 12.5, 25.0, 50.0, 62.5, 100.0, ttl.abs().clamp(1e-3, 1e6) / count as f64, 1000.0])
        };
        if !draw.chance(shapes.bad_dt) {
            set(&mut command, "horizon_dt_ms", num(dt));
        }
    } else if draw.chance(shapes.bad_dt) {
        // A length of ticks without ticks.
        set(&mut command, "horizon_dt_ms", num(draw.one(&[10.0, 50.0, 100.0])));
    }
    command
}

/// The same channels, but for a unit, a number or a channel: what differs in no more may be taken for the same.
fn nearly_the_same(channels: &Tree, draw: &mut Draw<'_>) -> Tree {
    let mut channels = channels.clone();
    let Json::Object(members) = &mut channels else { return channels };
    if members.is_empty() {
        return channels;
    }
    let at = draw.below(members.len());
    match draw.below(4) {
        0 => drop(members.remove(at)),
        1 => set(&mut members[at].1, "unit", or_null(draw.one(&[Some("m/s"), Some("rad"), None]).map(text))),
        2 => {
            let data = crate::fuzz::tree::items(members[at].1.get("data"));
            let stopped = nums(&vec![0.0; data.len()]);
            set(&mut members[at].1, "data", stopped);
        }
        _ => {
            let mut data = crate::fuzz::tree::items(members[at].1.get("data")).to_vec();
            if !data.is_empty() {
                let place = draw.below(data.len());
                data[place] = num(draw.plain());
            }
            set(&mut members[at].1, "data", list(data));
        }
    }
    channels
}

/// The limits of a governor.
struct Limits {
    speed: Option<f64>,
    fence: Option<f64>,
    timeout: f64,
    tilt: Option<f64>,
}

impl Limits {
    fn draw(draw: &mut Draw<'_>) -> Self {
        let limit = |draw: &mut Draw<'_>| match draw.below(8) {
            0 | 1 => None,
            2 => Some(draw.one(&[0.0, -0.0])),
            3 => Some(draw.positive()),
            4 if draw.chance(40) => Some(draw.one(&[-1.0, -5e-324, f64::NAN, f64::INFINITY, f64::NEG_INFINITY])),
            _ => Some(draw.one(&[0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 100.0])),
        };
        let (speed, fence) = (limit(draw), limit(draw));
        speed.map(|speed| draw.note(speed));
        fence.map(|fence| draw.note(fence));
        let timeout = match draw.below(10) {
            0 => draw.finite(),
            1 => draw.one(&[0.0, -1.0, 5e-324, 1e9]),
            _ => draw.one(&[250.0, 500.0, 1000.0, 62.5]),
        };
        let tilt = draw.one(&[None, None, Some(0.5), Some(0.0)]);
        Self { speed, fence, timeout, tilt }
    }

    fn tree(&self) -> Tree {
        object([
            ("max_speed_mps", or_null(self.speed.map(num))),
            ("max_tilt_rad", or_null(self.tilt.map(num))),
            ("geofence_radius_m", or_null(self.fence.map(num))),
            ("command_timeout_ms", num(self.timeout)),
        ])
    }
}

/// What was negotiated, or nothing.
fn capabilities(draw: &mut Draw<'_>) -> Tree {
    if draw.chance(60) {
        return Json::Null;
    }
    let spec = |name: &str, kind: &str, unit: Option<&str>, size: Option<i64>| {
        let mut spec = object([("name", text(name)), ("kind", text(kind)), ("unit", or_null(unit.map(text)))]);
        if let Some(size) = size {
            set(&mut spec, "size", int(size));
        }
        spec
    };
    if draw.chance(5) {
        return object([("sensor_channels", list(Vec::new())), ("command_channels", list(Vec::new()))]);
    }
    let canonical = |name: &str, unit: &str, draw: &mut Draw<'_>| match draw.below(14) {
        12 => {
            let name = draw.nearly(name);
            vec![spec(&name, "vec3", Some(unit), None)]
        }
        // Several times, of several units and sizes.
        13 => (0..1 + draw.below(4))
            .map(|_| {
                let size = draw.one(&[None, None, Some(3), Some(4)]);
                spec(name, "vec3", draw.one(&[Some(unit), Some(unit), None, Some("cm")]), size)
            })
            .collect(),
        0 => Vec::new(),
        1 => vec![spec(name, "vec3", None, None)],
        2 => vec![spec(name, "vec3", Some(draw.pick(&["km/h", "cm", "", "M"])), None)],
        3 => vec![spec(name, "array", Some(unit), Some(3))],
        // Twice: each declaration counts.
        4 => vec![spec(name, "vec3", Some(unit), None), spec(name, "vec3", None, None)],
        5 => vec![spec(name, "vec3", Some(unit), None), spec(name, "vec3", Some(unit), None)],
        _ => vec![spec(name, "vec3", Some(unit), None)],
    };
    let mut sensors = canonical("pose_position", "m", draw);
    let mut commands = canonical("velocity_setpoint", "m/s", draw);
    for nth in 0..if draw.chance(10) { draw.size(1, 40) } else { draw.below(4) } {
        let (kind, unit) = draw.one(&[("scalar", Some("N")), ("vec3", Some("m/s")), ("scalar", None), ("quat", None)]);
        let name = draw.one(&["tow", "grip", "c0", "c1", "velocity", "velocity_setpoint_max"]);
        let name = if nth > 3 { format!("c{nth}") } else { name.to_owned() };
        let other = spec(&name, kind, unit, None);
        if draw.chance(30) { commands.insert(0, other) } else { commands.push(other) }
    }
    if draw.chance(30) {
        sensors.insert(0, spec("imu", "vec3", Some("m"), None));
    }
    // A name of one list in the other: it says nothing there.
    if draw.chance(15) {
        sensors.push(spec("velocity_setpoint", "vec3", draw.one(&[Some("m/s"), Some("km/h"), None]), None));
    }
    if draw.chance(15) {
        commands.push(spec("pose_position", "vec3", draw.one(&[Some("m"), Some("cm"), None]), None));
    }
    object([("sensor_channels", list(sensors)), ("command_channels", list(commands))])
}

/// The radius of a fence that can be kept, m; some radius where there is none.
fn radius(fence: Option<f64>) -> f64 {
    fence.filter(|fence| fence.is_finite() && *fence > 0.0).unwrap_or(5.0)
}

/// What a body senses: a position of some kind.
fn sensor(fence: Option<f64>, seq: i64, odd: u64, strange: u64, draw: &mut Draw<'_>) -> Tree {
    let radius = radius(fence);
    let mut position = match draw.below(12) {
        0 => vec![radius, 0.0, 0.0],
        1 => vec![0.0, -radius, 0.0],
        2 => vec![0.0, 0.0, radius.next_up()],
        3 => vec![radius.next_down(), 0.0, 0.0],
        4 => vec![radius * 0.6, radius * 0.8, 0.0],
        5 if draw.chance(30) => vec![radius, radius, 0.0],
        6 => vec![radius / 2.0, radius / 4.0, -radius / 8.0],
        8 if draw.chance(50) => vec![0.0, radius * (1.0 + draw.little()), 0.0],
        7 if draw.chance(30) => vec![draw.finite(), draw.finite(), draw.finite()],
        _ => (0..3).map(|_| radius * draw.range(-8, 8) as f64 / 16.0).collect(),
    };
    if draw.chance(strange) {
        let at = draw.below(3);
        position[at] = draw.strange();
    }
    let unit = if draw.chance(odd) { draw.one(&[None, Some("m"), Some("cm"), Some("")]) } else { Some("m") };
    if draw.chance(odd) {
        position.truncate(draw.below(3));
    }
    let mut channels = Vec::new();
    if !draw.chance(odd / 2) {
        channels.push(("pose_position".to_owned(), sample(&position, or_null(unit.map(text)))));
    } else if draw.chance(40) {
        channels.push((draw.nearly("pose_position"), sample(&position, or_null(unit.map(text)))));
    }
    if draw.chance(70) {
        let any = draw.chance(8);
        let velocity: Vec<f64> =
            (0..3).map(|_| if any { draw.finite() } else { draw.range(-16, 16) as f64 / 8.0 }).collect();
        channels.push(("pose_velocity".to_owned(), sample(&velocity, text("m/s"))));
    }
    if draw.chance(20) {
        channels.push(("imu".to_owned(), sample(&[draw.finite()], Json::Null)));
    }
    object([
        ("seq", int(seq)),
        ("t", num(if draw.chance(90) { seq as f64 / 8.0 } else { draw.finite() })),
        ("channels", map(channels)),
    ])
}

/// The arguments of `governor.run`.
pub(super) fn governor(draw: &mut Draw<'_>) -> Tree {
    let limits = Limits::draw(draw);
    let capabilities = capabilities(draw);
    let mut shapes = Shapes::draw(draw);
    if let Some(speed) = limits.speed.filter(|speed| *speed > 0.0 && speed.is_finite() && draw.chance(60)) {
        shapes.speed = Some(speed);
    }
    let count = steps(draw, 2000);
    let count = if shapes.longest > 64 { count.min((8192 / shapes.longest).clamp(3, 12)) } else { count };
    let (odd, strange) = (draw.one(&[0, 0, 10]), draw.one(&[0, 0, 0, 4]));
    let (links, bursts, resets) = (draw.one(&[0, 10, 30]), draw.one(&[0, 0, 20]), draw.one(&[0, 0, 2, 10]));
    let (no_sensor, same) = (draw.one(&[0, 0, 10]), draw.one(&[0, 0, 30]));
    let timeout = limits.timeout;
    let mut clock = Clock::draw(draw);
    let (mut last, mut sensed) = (draw.range(0, 9), clock.now);
    // How often a reset comes directly behind a step, and a good command behind that.
    let judged = draw.one(&[0, 0, 0, 40]);
    let mut then: Vec<Tree> = Vec::new();
    let mut before: Option<Tree> = None;
    let steps = (0..count).map(|_| {
        if let Some(next) = then.pop() {
            return next;
        }
        if draw.chance(links) {
            return object([("op", text("note_link")), ("burst", Json::Bool(draw.chance(bursts)))]);
        }
        if draw.chance(resets) {
            return object([("op", text("reset"))]);
        }
        last = next_seq(last, draw);
        if draw.chance(75) {
            sensed = clock.now;
        }
        // Silences of more than two time-outs may stop a governor, so they are few.
        let span = if draw.chance(90) { timeout.min(timeout * 0.5) } else { timeout };
        let now = clock.tick(sensed, span, draw);
        let sensor = (!draw.chance(no_sensor)).then(|| sensor(limits.fence, last, odd, strange, draw));
        let told = match draw.below(100) {
            _ if draw.chance(no_sensor) => Json::Null,
            0 | 1 if strange > 0 => num(draw.strange()),
            _ => num(sensed),
        };
        // The same question again has the same answer.
        if let Some(before) = before.clone().filter(|_| draw.chance(same)) {
            return before;
        }
        let step = object([
            ("op", text("govern")),
            ("command", command(&mut shapes, last, draw)),
            ("now_s", num(now)),
            ("sensor", or_null(sensor)),
            ("last_sensor_s", told),
        ]);
        before = Some(step.clone());
        if draw.chance(judged) {
            last = next_seq(last, draw);
            then = vec![good(&limits, last, clock.now), object([("op", text("reset"))])];
        }
        step
    });
    let steps = list(steps.collect());
    object([("limits", limits.tree()), ("capabilities", capabilities), ("steps", steps)])
}

/// A step whose command passes all gates, where the limits can be kept at all.
fn good(limits: &Limits, seq: i64, now: f64) -> Tree {
    let radius = radius(limits.fence);
    let sensor =
        object([("seq", int(seq)), ("t", num(seq as f64 / 8.0)), ("channels", position(&[radius / 2.0, 0.0, 0.0]))]);
    let velocity = sample(&[0.0, radius / 4096.0, 0.0], text("m/s"));
    let command = object([
        ("seq", int(seq)),
        ("t", num(seq as f64 / 8.0)),
        ("mode", text("active")),
        ("ttl_ms", num(100.0)),
        ("channels", map(vec![("velocity_setpoint".to_owned(), velocity)])),
    ]);
    object([
        ("op", text("govern")),
        ("command", command),
        ("now_s", num(now)),
        ("sensor", sensor),
        ("last_sensor_s", num(now)),
    ])
}

/// The channels of a sensor frame that has a position alone.
fn position(data: &[f64]) -> Tree {
    map(vec![("pose_position".to_owned(), sample(data, text("m")))])
}

fn gain(draw: &mut Draw<'_>) -> f64 {
    match draw.below(10) {
        0 => draw.double(),
        1 => draw.positive(),
        2 => draw.one(&[0.0, -0.0, 5e-324]),
        _ => draw.range(1, 64) as f64 / 16.0,
    }
}

fn config(draw: &mut Draw<'_>) -> Tree {
    let mut config = object([]);
    if draw.chance(40) {
        let target: Vec<f64> = (0..3).map(|_| if draw.chance(90) { draw.plain() } else { draw.double() }).collect();
        set(&mut config, "target", nums(&target));
    }
    for name in ["kp", "kd", "max_speed"] {
        if draw.chance(40) {
            set(&mut config, name, num(gain(draw)));
        }
    }
    config
}

/// The arguments of `reflex.step`.
pub(super) fn reflex(draw: &mut Draw<'_>) -> Tree {
    let config = config(draw);
    let seq = draw.integer();
    let (odd, strange) = (draw.one(&[0, 0, 30]), draw.one(&[0, 0, 10]));
    let sensor = (!draw.chance(5)).then(|| sensor(Some(draw.positive()), seq, odd, strange, draw));
    object([("config", config), ("sensor", or_null(sensor))])
}

/// The arguments of `loop.run`.
pub(super) fn control_loop(draw: &mut Draw<'_>) -> Tree {
    let limits = Limits::draw(draw);
    let config = if draw.chance(60) { object([]) } else { config(draw) };
    let period = match draw.below(10) {
        0 => draw.double(),
        // Of which half, twice and thousandth are rounded.
        1 | 2 => draw.range(8, 16_000) as f64 / draw.one(&[8.0, 10.0]),
        _ => draw.one(&[20.0, 50.0, 100.0, 125.0, 500.0, 1000.0]),
    };
    let count = steps(draw, 3000);
    let (ticks, resets) = (draw.one(&[30, 50, 70]), draw.one(&[0, 0, 3]));
    let stamped = draw.chance(80);
    let mut clock = Clock::draw(draw);
    // Seqs may be negative, too.
    let least = draw.one(&[1, 1, 1, -4]);
    let (mut seq, mut sensed) = (least, clock.now);
    let gaps = draw.one(&[0, 0, 5, 30]);
    let (odd, same) = (draw.one(&[0, 0, 10]), draw.one(&[0, 0, 20, 60]));
    // How far the times of frames are apart: an eighth of a second as a rule, or less than a coarse clock tells.
    let apart = draw.one(&[0.125, 0.125, 0.125, 1.0 / 4096.0, 1.0 / 4_194_304.0]);
    // How often a reset comes directly behind a frame, and a good frame and a tick behind that.
    let judged = draw.one(&[0, 0, 0, 20]);
    let mut then: Vec<Tree> = Vec::new();
    let mut before: Option<Tree> = None;
    let steps = (0..count).map(|_| {
        if let Some(next) = then.pop() {
            return next;
        }
        if draw.chance(resets) {
            return object([("op", text("reset"))]);
        }
        let span = if draw.chance(80) { limits.timeout * 0.5 } else { limits.timeout };
        let now = clock.tick(sensed, span, draw);
        if draw.chance(ticks) {
            return object([("op", text("tick")), ("now_s", num(now))]);
        }
        // The same frame again, later, which is no news.
        if let Some(before) = before.clone().filter(|_| draw.chance(same)) {
            return object([("op", text("sensor")), ("sensor", before), ("now_s", num(now))]);
        }
        sensed = now;
        seq = if draw.chance(gaps) { (seq + draw.range(-3, 40)).max(least) } else { seq + 1 };
        let mut sensor = sensor(limits.fence, seq, odd, 0, draw);
        if !stamped {
            set(&mut sensor, "seq", int(0));
            if apart < 0.125 {
                set(&mut sensor, "t", num(1.0 + seq as f64 * apart));
            }
        }
        // At the same place, and not as fast.
        if let (Some(before), Some(_)) = (&before, sensor.get("channels"))
            && draw.chance(same / 2)
        {
            let mut channels = before.get("channels").cloned().unwrap_or(Json::Null);
            let velocity: Vec<f64> = (0..3).map(|_| draw.range(-16, 16) as f64 / 8.0).collect();
            set(&mut channels, "pose_velocity", sample(&velocity, text("m/s")));
            set(&mut sensor, "channels", channels);
        }
        before = Some(sensor.clone());
        if draw.chance(judged) {
            let radius = radius(limits.fence);
            let mut inside = sensor.clone();
            seq = if stamped && draw.chance(50) { 1 } else { seq + 1 };
            set(&mut inside, "seq", int(if stamped { seq } else { 0 }));
            set(&mut inside, "channels", position(&[radius / 8.0, 0.0, 0.0]));
            let tick = object([("op", text("tick")), ("now_s", num(now))]);
            let frame = object([("op", text("sensor")), ("sensor", inside), ("now_s", num(now))]);
            then = vec![tick.clone(), frame, object([("op", text("reset"))])];
            if draw.chance(50) {
                then.push(tick);
            }
        }
        object([("op", text("sensor")), ("sensor", sensor), ("now_s", num(now))])
    });
    let steps = list(steps.collect());
    object([("period_ms", num(period)), ("limits", limits.tree()), ("config", config), ("steps", steps)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;

    #[test]
    fn steps_of_a_horizon_differ_in_a_unit_alone_and_a_command_leaves_out_what_has_a_default() {
        let harvest = Harvest::default();
        let (mut of_units, mut without_mode) = (0, 0);
        for number in 0..3000 {
            let mut draw = Draw::new(3, number, &harvest);
            let mut shapes = Shapes::draw(&mut draw);
            let command = command(&mut shapes, 1, &mut draw);
            without_mode += usize::from(command.get("mode").is_none());
            let steps = crate::fuzz::tree::items(command.get("horizon"));
            let unit = |step: &Tree| step.get("velocity_setpoint").and_then(|own| own.get("unit")).cloned();
            let data = |step: &Tree| step.get("velocity_setpoint").and_then(|own| own.get("data")).cloned();
            let differ = |two: &[Tree]| {
                data(&two[0]).is_some() && data(&two[0]) == data(&two[1]) && unit(&two[0]) != unit(&two[1])
            };
            of_units += usize::from(steps.windows(2).any(differ));
        }
        assert!(of_units > 20 && without_mode > 20, "{of_units} {without_mode}");
    }
}
