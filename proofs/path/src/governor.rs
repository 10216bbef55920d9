//! The governor around its gates: which channels and units it binds, what it shows of a horizon, what a closed gate
//! makes of a command.

use ncp_spec::safety::{Decision, Reason};
use ncp_spec::wire::{
    Capabilities, ChannelKind, ChannelMap, ChannelSpec, ChannelValue, CommandFrame, Mode, SafetyLimits, SensorFrame,
    Text,
};

use crate::engine::{Case, Harness, every};
use crate::subject::Governor;

/// The harness of a claim.
#[must_use]
pub fn run<G: Governor>(id: &str) -> Option<Harness> {
    match id {
        "governor/quiet" => Some(|scope| every(scope, quiet::<G>)),
        "governor/closed-gates" => Some(|scope| every(scope, closed_gates::<G>)),
        "governor/binding" => Some(|scope| every(scope, binding::<G>)),
        "governor/position" => Some(|scope| every(scope, position::<G>)),
        "governor/units" => Some(|scope| every(scope, units::<G>)),
        "governor/index" => Some(|scope| every(scope, index::<G>)),
        "governor/cut" => Some(|scope| every(scope, cut::<G>)),
        "governor/order" => Some(|scope| every(scope, order::<G>)),
        _ => None,
    }
}

const VELOCITY: &str = "velocity_setpoint";
const POSITION: &str = "pose_position";
/// The most steps that a frame has.
const STEPS: usize = 4_096;
const NOW: f64 = 8.0;

/// Commands of every shape, by governors of every negotiation, held and stopped: the frame is that of 7.7.
fn quiet<G: Governor>(c: &mut Case) {
    const NAMES: [&str; 3] = [VELOCITY, "a", "z"];
    const UNITS: [Option<&str>; 3] = [None, Some("m/s"), Some("V")];
    let most = c.bound(1, 2);
    let known: Vec<ChannelSpec> = (0..c.below("channels negotiated", most + 1))
        .map(|_| {
            let name: &'static str = c.pick::<&str>("name", &NAMES);
            spec(name, ChannelKind::Vec3, None, *c.pick("unit", &UNITS))
        })
        .collect();
    let mut governor = G::negotiated(&SafetyLimits::default(), &[], &known);
    let of = |c: &mut Case, name: &'static str| {
        const DATA: [&[f64]; 4] = [&[], &[f64::NAN], &[1.0, -0.0, f64::INFINITY], &[1.0, 2.0, 3.0, -4.0]];
        let has = c.either(name);
        has.then(|| {
            let data: &[f64] = c.pick::<&[f64]>("data", &DATA);
            (name, channel(data, *c.pick("unit", &UNITS)))
        })
    };
    let channels: ChannelMap = [VELOCITY, "a"].into_iter().filter_map(|name| of(c, name)).collect();
    let (t, seq, ttl_ms, frame_id) =
        *c.pick("stamps", &[(1.5, 7, 200.0, "world"), (f64::NAN, i64::MIN, -0.0, "map"), (-0.0, 0, f64::MAX, "")]);
    let steps = if c.either("horizon") { vec![channels.clone(), ChannelMap::new()] } else { Vec::new() };
    let mode = *c.pick("mode", &[Mode::Hold, Mode::Active, Mode::Estop]);
    let mut command = CommandFrame {
        seq,
        t,
        frame_id: Text::Borrowed(frame_id),
        mode,
        ttl_ms,
        channels,
        horizon_dt_ms: (!steps.is_empty()).then_some(20.0),
        horizon: steps,
        ..CommandFrame::default()
    };
    let before = command.clone();
    // Without a sensor every command that is no ESTOP holds.
    let decision = governor.govern(&mut command, NOW, None, None);
    c.check("held or stopped", matches!(decision, Decision::Held(_) | Decision::Stopped(_)));
    is_quiet(c, &before, &command, &known, decision);
}

/// Section 7.7, sentence by sentence.
fn is_quiet(c: &mut Case, before: &CommandFrame, after: &CommandFrame, known: &[ChannelSpec], decision: Decision) {
    let mode = match decision {
        Decision::Held(_) => Mode::Hold,
        Decision::Stopped(_) => Mode::Estop,
        Decision::Passed | Decision::Limited => return,
    };
    c.check("in its mode", after.mode == mode);
    // [NCP-SAFE-070]
    let bits = |frame: &CommandFrame| (frame.t.to_bits(), frame.seq, frame.frame_id.clone(), frame.ttl_ms.to_bits());
    c.check("t, seq, frame_id and ttl_ms stay", bits(after) == bits(before));
    // [NCP-SAFE-074]
    c.check("no horizon", after.horizon.is_empty());
    // [NCP-SAFE-071]
    let is_named = |name: &str| before.channels.contains_key(name) || known.iter().any(|spec| spec.name == name);
    let mut all = before.channels.keys().chain(known.iter().map(|spec| &*spec.name));
    c.check("the union of channels", all.all(|name| after.channels.contains_key(name)));
    c.check("no other channel", after.channels.keys().all(is_named));
    for (name, channel) in after.channels.iter() {
        c.check("zeroed", channel.data.iter().all(|component| component.to_bits() == 0));
        match before.channels.get(name) {
            // [NCP-SAFE-072]
            Some(old) => {
                c.check("width and unit stay", old.data.len() == channel.data.len() && old.unit == channel.unit);
            }
            // [NCP-SAFE-073]
            None if name == VELOCITY => {
                let is_zero = channel.data.len() == 3 && channel.unit.as_deref() == Some("m/s");
                c.check("an absent velocity is three zeros in m/s", is_zero);
            }
            None => {
                let of = |spec: &ChannelSpec| spec.name == name && spec.unit == channel.unit;
                let has_unit = channel.unit.is_none() || known.iter().any(of);
                c.check("an absent channel is one zero", channel.data.len() == 1 && has_unit);
            }
        }
    }
}

/// Each gate closed, on commands of every shape: the frame is that of 7.7, and an open one leaves it alone.
fn closed_gates<G: Governor>(c: &mut Case) {
    const CAUSES: [(Reason, bool); 10] = [
        (Reason::Estop, true),
        (Reason::ConfigFault, false),
        (Reason::StaleSensor, false),
        (Reason::NoPosition, false),
        (Reason::OutsideFence, true),
        (Reason::NotActive, false),
        (Reason::NotFinite, false),
        (Reason::NoVelocity, false),
        (Reason::BadHorizon, false),
        (Reason::LeavesFence, false),
    ];
    let cause = *c.pick("cause", &[&[None], CAUSES.map(Some).as_slice()].concat());
    let reason = cause.map(|(reason, _)| reason);
    let is = |wanted: Reason| reason == Some(wanted);
    let known = [spec(VELOCITY, ChannelKind::Vec3, None, Some("m/s")), spec("z", ChannelKind::Scalar, None, None)];
    let sensors = [spec(POSITION, ChannelKind::Vec3, None, Some("m"))];
    let limits = SafetyLimits {
        max_speed_mps: Some(if is(Reason::ConfigFault) { -1.0 } else { 1.0 }),
        geofence_radius_m: Some(10.0),
        ..SafetyLimits::default()
    };
    let mut governor = G::negotiated(&limits, &sensors, &known);
    let latched = is(Reason::Estop) && c.either("latched before");
    if latched {
        governor.note_link(true);
    }
    let place = if is(Reason::OutsideFence) {
        11.0
    } else if is(Reason::LeavesFence) {
        9.5
    } else {
        1.0
    };
    let name = if is(Reason::NoPosition) { "elsewhere" } else { POSITION };
    let sensor = frame(name, channel(&[place, 0.0, 0.0], Some("m")));
    let stop = is(Reason::Estop) && !latched;
    let mode = if stop {
        Mode::Estop
    } else if is(Reason::NotActive) {
        Mode::Init
    } else {
        Mode::Active
    };
    let speed = if c.either("too fast") { 3.0 } else { 0.5 };
    let mut channels = ChannelMap::from_iter([(VELOCITY, channel(&[speed, 0.0, 0.0], Some("m/s")))]);
    if is(Reason::NoVelocity) {
        channels.clear();
    }
    if c.either("another channel") {
        channels.insert("a", channel(&[7.0, 8.0], Some("V")));
    }
    if is(Reason::NotFinite) {
        channels.insert("b", channel(&[f64::NAN], None));
    }
    let has_horizon = c.either("horizon") || is(Reason::BadHorizon);
    let dt_ms = if is(Reason::BadHorizon) { *c.pick("dt", &[None, Some(0.0), Some(f64::NAN)]) } else { Some(1_000.0) };
    let mut command = CommandFrame {
        seq: 5,
        t: 2.5,
        mode,
        ttl_ms: 2_000.0,
        horizon: if has_horizon { vec![channels.clone()] } else { Vec::new() },
        horizon_dt_ms: if has_horizon { dt_ms } else { None },
        channels,
        ..CommandFrame::default()
    };
    let before = command.clone();
    let last = if is(Reason::StaleSensor) { NOW - 0.75 } else { NOW - 0.25 };
    let decision = governor.govern(&mut command, NOW, Some(&sensor), Some(last));
    let says = match cause {
        Some((reason, true)) => Decision::Stopped(reason),
        Some((reason, false)) => Decision::Held(reason),
        None if speed > 1.0 => Decision::Limited,
        None => Decision::Passed,
    };
    c.check("the decision is the first closed gate's", decision == says);
    is_quiet(c, &before, &command, &known, decision);
    if decision == Decision::Passed {
        c.check("what passes is unchanged", command == before); // [NCP-SAFE-021]
    }
    if cause.is_none() {
        let horizon = (command.horizon.len(), command.horizon_dt_ms);
        let stays = command.mode == Mode::Active && horizon == (before.horizon.len(), before.horizon_dt_ms);
        c.check("what passes stays active, with its horizon", stays);
        c.check("another channel stays", command.channels.get("a") == before.channels.get("a"));
    }
}

/// Limits of every kind over every list of up to two declared channels: a config fault exactly by 7.2.
fn binding<G: Governor>(c: &mut Case) {
    const LIMITS: [Option<f64>; 8] =
        [None, Some(0.0), Some(2.0), Some(5e-324), Some(-1.0), Some(-0.0), Some(f64::NAN), Some(f64::INFINITY)];
    let is_speed = c.either("the speed limit");
    let (name, unit) = if is_speed { (VELOCITY, "m/s") } else { (POSITION, "m") };
    let limit = *c.pick("limit", &LIMITS);
    let most = c.bound(1, 2);
    let sizes = [None, Some(3), Some(2), Some(4), Some(0), Some(-3)];
    let units = [Some(unit), None, Some("km/h"), Some("")];
    let kinds = [
        ChannelKind::Vec3,
        ChannelKind::Array,
        ChannelKind::Scalar,
        ChannelKind::Quat,
        ChannelKind::from_wire("tensor"),
    ];
    let declared: Vec<ChannelSpec> = (0..c.below("declared", most + 1))
        .map(|_| {
            let name = *c.pick("name", &[name, "other"]);
            spec(name, c.pick("kind", &kinds).clone(), *c.pick("size", &sizes), *c.pick("unit", &units))
        })
        .collect();
    // The other limit is enabled, and well bound or not bound at all.
    let is_other_bound = c.either("the other limit's channel is declared");
    let (other, other_unit) = if is_speed { (POSITION, "m") } else { (VELOCITY, "m/s") };
    let bound = [spec(other, ChannelKind::Vec3, None, Some(other_unit))];
    let others: &[ChannelSpec] = if is_other_bound { &bound } else { &[] };
    let mut limits = SafetyLimits { max_tilt_rad: Some(0.5), ..SafetyLimits::default() };
    (limits.max_speed_mps, limits.geofence_radius_m) = if is_speed { (limit, Some(9.0)) } else { (Some(9.0), limit) };
    let (sensors, commands) = if is_speed { (others, &*declared) } else { (&*declared, others) };
    let governor = G::negotiated(&limits, sensors, commands);

    // The table of 7.2, and NCP-SAFE-012 to 016.
    let is_enabled = limit.is_some_and(|limit| limit.is_finite() && limit > 0.0);
    let is_disabled = limit.is_none_or(|limit| limit == 0.0);
    let wide = |spec: &ChannelSpec| match spec.kind {
        ChannelKind::Vec3 => matches!(spec.size, None | Some(3)),
        ChannelKind::Array => spec.size == Some(3),
        _ => false,
    };
    let mut mine = declared.iter().filter(|spec| spec.name == name);
    let is_bound = mine.clone().next().is_some() && mine.all(|spec| spec.unit.as_deref() == Some(unit) && wide(spec));
    let is_good = is_disabled || (is_enabled && is_bound);
    c.check("a config fault exactly by 7.2", governor.has_config_fault() != (is_good && is_other_bound));
    c.check("nothing is latched at first", !governor.is_stopped());
    let capabilities = Capabilities {
        safety: limits,
        sensor_channels: sensors.to_vec(),
        command_channels: commands.to_vec(),
        ..Capabilities::default()
    };
    let whole = G::from_capabilities(&capabilities);
    c.check("the same of Capabilities", format!("{whole:?}") == format!("{governor:?}"));
    let known = commands.iter().map(|spec| (spec.name.clone(), spec.unit.clone()));
    c.check("the channels as they were declared", known.eq(governor.channels().iter().cloned()));
    let canonical = G::new(&SafetyLimits { max_speed_mps: limit, ..SafetyLimits::default() });
    c.check(
        "without Capabilities a fault by the limit alone",
        canonical.has_config_fault() != (is_enabled || is_disabled),
    );
    let is_canonical = canonical.channels() == [(Text::Borrowed(VELOCITY), Some(Text::Borrowed("m/s")))];
    c.check("without Capabilities the canonical channel", is_canonical);
}

/// Positions of every width, unit and place: a hold, a stop, or a pass, by 7.5.
fn position<G: Governor>(c: &mut Case) {
    const PLACES: [f64; 8] = [0.0, 3.0, 4.0, 5.0, -5.0, 6.0, f64::NAN, f64::INFINITY];
    let limits = SafetyLimits { geofence_radius_m: Some(5.0), ..SafetyLimits::default() };
    let mut governor = if c.either("negotiated") {
        let sensors =
            [spec("first", ChannelKind::Vec3, None, Some("km")), spec(POSITION, ChannelKind::Vec3, None, Some("m"))];
        G::negotiated(&limits, &sensors, &[])
    } else {
        G::new(&limits)
    };
    let width = c.below("width", 6);
    let data: Vec<f64> = (0..width).map(|_| *c.pick("component", c.bound(&PLACES[2..7], &PLACES[..]))).collect();
    let unit = *c.pick("unit", &[None, Some("m"), Some("km"), Some("")]);
    let other = c.either("another position comes first").then(|| ("a", channel(&[99.0, 0.0, 0.0], Some("m"))));
    let mine = c.either("the frame has the channel").then(|| (POSITION, channel(&data, unit)));
    let is_there = mine.is_some();
    let has_sensor = c.either("there is a frame");
    let sensor = SensorFrame { channels: other.into_iter().chain(mine).collect(), ..SensorFrame::default() };
    let mut command = CommandFrame {
        channels: ChannelMap::from_iter([(VELOCITY, channel(&[0.0; 3], Some("m/s")))]),
        ..CommandFrame::default()
    };
    let decision = governor.govern(&mut command, NOW, has_sensor.then_some(&sensor), Some(NOW));
    // [NCP-SAFE-040] [NCP-SAFE-041] [NCP-SAFE-042]
    let is_usable = has_sensor && is_there && width == 3 && matches!(unit, None | Some("m"));
    // Of these numbers each square and each sum is exact, and 25 = 5². [NCP-SAFE-043] [NCP-SAFE-044] [NCP-SAFE-045]
    let is_inside = data.iter().all(|x| x.is_finite()) && data.iter().map(|x| x * x).sum::<f64>() <= 25.0;
    let says = match (is_usable, is_inside) {
        (false, _) => Decision::Held(Reason::NoPosition),
        (true, false) => Decision::Stopped(Reason::OutsideFence),
        (true, true) => Decision::Passed,
    };
    c.check("held, stopped or passed by the position", decision == says);
    c.check("latched exactly when stopped", governor.is_stopped() == matches!(says, Decision::Stopped(_)));
}

/// The unit of each channel, its own or the negotiated one: what is in m/s is limited, and nothing else.
fn units<G: Governor>(c: &mut Case) {
    const UNITS: [Option<&str>; 4] = [None, Some("m/s"), Some("V"), Some("")];
    let limits = SafetyLimits { max_speed_mps: Some(1.0), ..SafetyLimits::default() };
    let negotiated = *c.pick("a is negotiated in", &[None, Some(None), Some(Some("m/s")), Some(Some("V"))]);
    let mut commands = vec![spec(VELOCITY, ChannelKind::Vec3, None, Some("m/s"))];
    if let Some(unit) = negotiated {
        let at = c.below("place", 2);
        commands.insert(at, spec("a", ChannelKind::Vec3, None, unit));
    }
    let mut governor = G::negotiated(&limits, &[], &commands);
    let mut command = CommandFrame::default();
    let has_velocity = c.either("a velocity");
    let (unit, width) = (*c.pick("its unit", &UNITS), c.below("its width", 5));
    if has_velocity {
        command.channels.insert(VELOCITY, channel(&[2.0, 0.0, 0.0, 0.0][..width], unit));
    }
    let a_unit = *c.pick("unit of a", &UNITS);
    command.channels.insert("a", channel(&[0.0, -4.0], a_unit));
    let in_step = c.either("a step");
    if in_step {
        (command.horizon, command.horizon_dt_ms) = (vec![command.channels.clone()], Some(10.0));
        // Tick 0 is good, whatever the step is.
        command.channels.insert(VELOCITY, channel(&[0.5, 0.0, 0.0], Some("m/s")));
    }
    let before = command.clone();
    let decision = governor.govern(&mut command, NOW, None, Some(NOW));
    // [NCP-SAFE-042] [NCP-SAFE-063] [NCP-SAFE-065] [NCP-SAFE-067]
    let is_usable = has_velocity && width == 3 && matches!(unit, None | Some("m/s"));
    let a_in_mps = a_unit.or(negotiated.flatten()) == Some("m/s");
    if in_step {
        c.check("a step without a usable velocity is cut off", command.horizon.len() == usize::from(is_usable));
    } else {
        let says = if is_usable { Decision::Limited } else { Decision::Held(Reason::NoVelocity) };
        c.check("held without a usable velocity", decision == says);
    }
    if in_step && !is_usable {
        return;
    }
    if is_usable {
        let tick = if in_step { command.horizon.first() } else { Some(&command.channels) };
        let data = |name| tick.and_then(|tick| tick.get(name)).map(|channel| channel.data.clone()).unwrap_or_default();
        c.check("the velocity is limited", close(&data(VELOCITY), &[1.0, 0.0, 0.0]));
        let says: &[f64] = if a_in_mps { &[0.0, -1.0] } else { &[0.0, -4.0] };
        c.check("another channel exactly when it is in m/s", close(&data("a"), says));
        let old = if in_step { before.horizon.first() } else { Some(&before.channels) };
        let units = |tick: Option<&ChannelMap>| {
            let known = tick.map(|tick| tick.values().map(|channel| channel.unit.clone()).collect::<Vec<_>>());
            known.unwrap_or_default()
        };
        // [NCP-SAFE-021] The negotiated unit may be written.
        let is_kept = |(old, new): (&Option<Text>, &Option<Text>)| old == new || old.is_none();
        c.check("units stay", units(old).iter().zip(units(tick).iter()).all(is_kept));
    }
}

/// Every index into a horizon of every length that a frame may have: tick k is `horizon[k − 1]`, and nothing else.
fn index<G: Governor>(c: &mut Case) {
    let governor = G::new(&SafetyLimits::default());
    let most = c.bound(40, STEPS + 1);
    let steps = c.below("steps", most + 1);
    #[expect(clippy::cast_precision_loss, reason = "they are small")]
    let mark = |tick: usize| tick as f64 + 2.0;
    let of = |tick: usize| ChannelMap::from_iter([(VELOCITY, channel(&[mark(tick), 0.0, 0.0], Some("m/s")))]);
    let mut command = CommandFrame { channels: of(0), ..CommandFrame::default() };
    command.horizon = (1..=steps).map(of).collect();
    let is_sound = |ticks: &mut dyn crate::subject::Ticks, tick: usize, says: f64| {
        let data = ticks.tick_mut(tick).and_then(|tick| tick.get_mut(VELOCITY)).map(|channel| &mut channel.data);
        data.is_some_and(|data| data.first().is_some_and(|first| (*first - says).abs() < 1e-9))
    };
    let (mut velocities, mut limits, mut beyond, mut others) = (true, true, true, true);
    governor.with_ticks(&mut command, |ticks| {
        beyond &= ticks.steps() == steps;
        for tick in 0..=steps {
            velocities &= ticks.velocity(tick) == Some([mark(tick), 0.0, 0.0]);
            limits &= ticks.limit(tick, 1.0) == Ok(true) && is_sound(ticks, tick, 1.0);
            // The tick as it was: at the end every tick has to be.
            if let Some(map) = ticks.tick_mut(tick) {
                *map = of(tick);
            }
        }
        for tick in [steps + 1, steps + 2, 2 * steps + 2, usize::MAX - 1, usize::MAX] {
            beyond &= ticks.velocity(tick).is_none() && ticks.limit(tick, 1.0).is_err();
        }
        for tick in 0..=steps {
            others &= is_sound(ticks, tick, mark(tick));
        }
    });
    c.check("the velocity of tick k is that of horizon[k − 1]", velocities);
    c.check("the limit of tick k changes horizon[k − 1]", limits);
    c.check("and no other tick", others);
    c.check("there is no tick beyond the horizon", beyond);
    c.check("and the horizon is as long as it was", command.horizon.len() == steps);
}

/// A horizon of few steps or of about as many as a frame has, cut to every length near both ends.
fn cut<G: Governor>(c: &mut Case) {
    let governor = G::new(&SafetyLimits::default());
    let most = c.bound(8, 64);
    let all: Vec<usize> = (0..=most).chain(c.bound(0..0, STEPS - 1..STEPS + 2)).collect();
    let steps = *c.pick("steps", &all);
    let of = |tick: usize| ChannelMap::from_iter([("a", channel(&[0.5; 2][..tick % 3], None))]);
    let mut command = CommandFrame { channels: of(0), ..CommandFrame::default() };
    command.horizon = (1..=steps).map(of).collect();
    let ends: Vec<usize> = (0..steps + 2).filter(|to| *to <= most || to + 2 >= steps).chain([usize::MAX]).collect();
    let to = *c.pick("cut to", &ends);
    governor.with_ticks(&mut command, |ticks| ticks.truncate(to));
    c.check("a cut is as long as it says", command.horizon.len() == steps.min(to));
    c.check("a cut keeps the first steps", command.horizon.iter().zip(1..).all(|(map, tick)| *map == of(tick)));
    c.check("a cut leaves tick 0", command.channels == of(0));
}

/// The channel that a limit acts on is found by its name, wherever it stands.
fn order<G: Governor>(c: &mut Case) {
    const OTHERS: [&str; 3] = ["a", "pose_position2", "zz"];
    let limits = SafetyLimits { max_speed_mps: Some(1.0), geofence_radius_m: Some(5.0), ..SafetyLimits::default() };
    let list = |c: &mut Case, name: &'static str, unit: &'static str, wrong: &'static str| {
        let mut list: Vec<_> = OTHERS
            .iter()
            .filter(|other| c.either(other))
            .map(|other| spec(other, ChannelKind::Vec3, None, Some(wrong)))
            .collect();
        let at = c.below("place", list.len() + 1);
        list.insert(at, spec(name, ChannelKind::Vec3, None, Some(unit)));
        list
    };
    let sensors = list(c, POSITION, "m", "km");
    let commands = list(c, VELOCITY, "m/s", "V");
    let mut governor = G::negotiated(&limits, &sensors, &commands);
    // [NCP-SAFE-010] [NCP-SAFE-011]
    c.check("bound by name", !governor.has_config_fault());
    let is_outside = c.either("outside");
    let mut sensor = SensorFrame::default();
    for spec in &sensors {
        let far = (spec.name == POSITION) == is_outside;
        let place = if far { 9.0 } else { 1.0 };
        sensor.channels.insert(spec.name.clone(), channel(&[place, 0.0, 0.0], None));
    }
    let mut command = CommandFrame::default();
    for spec in &commands {
        command.channels.insert(spec.name.clone(), channel(&[0.0, 2.0, 0.0], None));
    }
    let decision = governor.govern(&mut command, NOW, Some(&sensor), Some(NOW));
    let is_stop = decision == Decision::Stopped(Reason::OutsideFence);
    c.check("the fence acts on pose_position alone", is_stop == is_outside);
    if !is_outside {
        c.check("and the command passes, limited", decision == Decision::Limited);
        for (name, channel) in command.channels.iter() {
            let says = if name == VELOCITY { 1.0 } else { 2.0 };
            c.check("the limit acts on velocity_setpoint alone", close(&channel.data, &[0.0, says, 0.0]));
        }
    }
}

fn spec(name: &'static str, kind: ChannelKind, size: Option<i64>, unit: Option<&'static str>) -> ChannelSpec {
    ChannelSpec { name: Text::Borrowed(name), kind, size, unit: unit.map(Text::Borrowed), ..ChannelSpec::default() }
}

fn channel(data: &[f64], unit: Option<&'static str>) -> ChannelValue {
    ChannelValue { data: data.to_vec(), unit: unit.map(Text::Borrowed) }
}

fn frame(name: &'static str, channel: ChannelValue) -> SensorFrame {
    SensorFrame { channels: ChannelMap::from_iter([(name, channel)]), ..SensorFrame::default() }
}

/// The same numbers, but for a rounding. `[NCP-SAFE-060]`
fn close(data: &[f64], says: &[f64]) -> bool {
    data.len() == says.len() && data.iter().zip(says).all(|(x, y)| (x - y).abs() <= 1e-12)
}
