//! The governor, rule by rule: chapter 7, with the boundary of each rule on both of its sides.

use ncp_spec::safety::{
    Decision, METRES, METRES_PER_SECOND, POSITION_CHANNEL, Reason, SafetyGovernor, VELOCITY_CHANNEL, kernel,
};
use ncp_spec::wire::{
    Capabilities, ChannelKind, ChannelMap, ChannelSpec, ChannelValue, CommandFrame, Mode, SafetyLimits, SensorFrame,
};

const NOW_S: f64 = 100.0;
const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const TINY: f64 = 5e-324;

fn no_limits() -> SafetyLimits {
    SafetyLimits::default()
}

fn fence(radius_m: f64) -> SafetyLimits {
    SafetyLimits { geofence_radius_m: Some(radius_m), ..no_limits() }
}

fn speed(max_mps: f64) -> SafetyLimits {
    SafetyLimits { max_speed_mps: Some(max_mps), ..no_limits() }
}

fn position(data: &[f64], unit: Option<&'static str>) -> SensorFrame {
    let mut frame = SensorFrame { seq: 1, ..SensorFrame::default() };
    let value = ChannelValue { data: data.to_vec(), unit: unit.map(Into::into) };
    frame.channels.insert(POSITION_CHANNEL, value);
    frame
}

fn at(place: [f64; 3]) -> SensorFrame {
    position(&place, Some(METRES))
}

fn velocity(data: &[f64], unit: Option<&'static str>) -> ChannelMap {
    let value = ChannelValue { data: data.to_vec(), unit: unit.map(Into::into) };
    ChannelMap::from_iter([(VELOCITY_CHANNEL, value)])
}

fn towards(velocity_mps: [f64; 3]) -> CommandFrame {
    CommandFrame { seq: 7, channels: velocity(&velocity_mps, Some(METRES_PER_SECOND)), ..CommandFrame::default() }
}

/// Tick 0 and a horizon, along x.
fn along(ticks_mps: &[f64], dt_ms: f64, ttl_ms: f64) -> CommandFrame {
    let tick = |x: &f64| velocity(&[*x, 0.0, 0.0], Some(METRES_PER_SECOND));
    CommandFrame {
        channels: tick(&ticks_mps[0]),
        horizon: ticks_mps[1..].iter().map(tick).collect(),
        horizon_dt_ms: Some(dt_ms),
        ttl_ms,
        ..CommandFrame::default()
    }
}

fn setpoint(channels: &ChannelMap) -> &[f64] {
    &channels[VELOCITY_CHANNEL].data
}

/// Governs with a sensor frame that has just arrived.
fn govern(governor: &mut SafetyGovernor, command: &mut CommandFrame, sensor: &SensorFrame) -> Decision {
    governor.govern(command, NOW_S, Some(sensor), Some(NOW_S))
}

/// What a new governor of these limits does.
fn once(limits: &SafetyLimits, mut command: CommandFrame, sensor: &SensorFrame) -> (Decision, CommandFrame) {
    let decision = govern(&mut SafetyGovernor::new(limits), &mut command, sensor);
    (decision, command)
}

fn spec(name: &'static str, kind: ChannelKind, unit: Option<&'static str>) -> ChannelSpec {
    ChannelSpec { name: name.into(), kind, unit: unit.map(Into::into), ..ChannelSpec::default() }
}

fn pose() -> ChannelSpec {
    spec(POSITION_CHANNEL, ChannelKind::Vec3, Some(METRES))
}

fn drive() -> ChannelSpec {
    spec(VELOCITY_CHANNEL, ChannelKind::Vec3, Some(METRES_PER_SECOND))
}

fn negotiated(limits: SafetyLimits, sensor: &[ChannelSpec], command: &[ChannelSpec]) -> SafetyGovernor {
    SafetyGovernor::from_capabilities(&Capabilities {
        sensor_channels: sensor.to_vec(),
        command_channels: command.to_vec(),
        safety: limits,
        ..Capabilities::default()
    })
}

/// The bits of every number of a command's channels, tick by tick.
fn bits(command: &CommandFrame) -> Vec<Vec<u64>> {
    std::iter::once(&command.channels)
        .chain(&command.horizon)
        .map(|tick| {
            let numbers = tick.values().flat_map(|channel| &channel.data);
            numbers.map(|x| x.to_bits()).collect()
        })
        .collect()
}

mod modes {
    use super::*;

    /// [NCP-SAFE-002]
    #[test]
    fn a_command_in_mode_init_or_hold_becomes_a_hold_frame() {
        for mode in [Mode::Init, Mode::Hold] {
            let idle = CommandFrame { mode, ..towards([1.0, 0.0, 0.0]) };
            let (decision, sent) = once(&no_limits(), idle, &at([0.0; 3]));
            assert_eq!(decision, Decision::Held(Reason::NotActive));
            assert_eq!(sent.mode, Mode::Hold);
            assert_eq!(setpoint(&sent.channels), [0.0; 3]);
        }
    }

    /// [NCP-SAFE-003] [NCP-SAFE-004] [NCP-SAFE-005] [NCP-SAFE-008]
    #[test]
    fn an_estop_command_latches_until_a_reset() {
        let mut governor = SafetyGovernor::new(&no_limits());
        let mut stop = CommandFrame { mode: Mode::Estop, ..towards([1.0, 0.0, 0.0]) };
        assert_eq!(govern(&mut governor, &mut stop, &at([0.0; 3])), Decision::Stopped(Reason::Estop));
        assert_eq!((stop.mode, setpoint(&stop.channels)), (Mode::Estop, &[0.0; 3][..]));
        for mode in [Mode::Active, Mode::Hold, Mode::Init, Mode::Active] {
            let mut next = CommandFrame { mode, ..towards([1.0, 0.0, 0.0]) };
            assert_eq!(govern(&mut governor, &mut next, &at([0.0; 3])), Decision::Stopped(Reason::Estop));
            assert_eq!((next.mode, setpoint(&next.channels)), (Mode::Estop, &[0.0; 3][..]));
        }
        assert!(governor.is_stopped());
        governor.reset();
        assert!(!governor.is_stopped());
        let mut next = towards([1.0, 0.0, 0.0]);
        assert_eq!(govern(&mut governor, &mut next, &at([0.0; 3])), Decision::Passed);
    }

    /// [NCP-SAFE-006] [NCP-SAFE-007]
    #[test]
    fn only_a_burst_on_the_link_latches_estop() {
        let mut governor = SafetyGovernor::new(&no_limits());
        governor.note_link(false);
        assert_eq!(govern(&mut governor, &mut towards([1.0, 0.0, 0.0]), &at([0.0; 3])), Decision::Passed);
        governor.note_link(true);
        // That the link recovers is no reset.
        governor.note_link(false);
        let stopped = govern(&mut governor, &mut towards([1.0, 0.0, 0.0]), &at([0.0; 3]));
        assert_eq!(stopped, Decision::Stopped(Reason::Estop));
    }

    /// [NCP-SAFE-008] The reset is no amnesty: what stopped it may stop it again.
    #[test]
    fn a_reset_outside_the_fence_lasts_until_the_next_command() {
        let mut governor = SafetyGovernor::new(&fence(5.0));
        for _ in 0..3 {
            let decision = govern(&mut governor, &mut towards([-1.0, 0.0, 0.0]), &at([6.0, 0.0, 0.0]));
            assert_eq!(decision, Decision::Stopped(Reason::OutsideFence));
            governor.reset();
        }
    }
}

mod limits {
    use super::*;

    /// [NCP-SAFE-010] [NCP-SAFE-011]
    #[test]
    fn limits_act_on_the_channels_of_their_names_whatever_comes_first() {
        let first = spec("a_first", ChannelKind::Vec3, Some(METRES));
        let fast = spec("a_fast", ChannelKind::Vec3, Some("rad/s"));
        let limits = SafetyLimits { max_speed_mps: Some(1.0), ..fence(5.0) };
        let mut governor = negotiated(limits, &[first, pose()], &[fast, drive()]);
        let mut sensor = at([1.0, 0.0, 0.0]);
        sensor.channels.insert("a_first", ChannelValue::new([90.0, 0.0, 0.0], METRES));
        let mut command = towards([3.0, 0.0, 0.0]);
        command.channels.insert("a_fast", ChannelValue::new([9.0, 9.0, 9.0], "rad/s"));
        assert_eq!(govern(&mut governor, &mut command, &sensor), Decision::Limited);
        assert!(setpoint(&command.channels)[0] <= 1.0);
        assert_eq!(command.channels["a_fast"].data, [9.0; 3]);

        sensor.channels.insert("a_first", ChannelValue::new([0.0; 3], METRES));
        sensor.channels.insert(POSITION_CHANNEL, ChannelValue::new([90.0, 0.0, 0.0], METRES));
        let breach = govern(&mut governor, &mut command, &sensor);
        assert_eq!(breach, Decision::Stopped(Reason::OutsideFence));
    }

    /// [NCP-SAFE-012] L13 L15: 0 stays "disabled".
    #[test]
    fn a_limit_that_is_absent_or_zero_is_disabled() {
        for limit in [None, Some(0.0), Some(-0.0)] {
            let limits = SafetyLimits { max_speed_mps: limit, geofence_radius_m: limit, ..no_limits() };
            let (decision, sent) = once(&limits, towards([900.0, 0.0, 0.0]), &at([1e9, 0.0, 0.0]));
            assert_eq!(decision, Decision::Passed, "{limit:?}");
            assert_eq!(setpoint(&sent.channels), [900.0, 0.0, 0.0]);
        }
    }

    /// [NCP-SAFE-013] [NCP-SAFE-017] L13 L15
    #[test]
    fn a_limit_that_is_negative_or_no_number_lets_nothing_move() {
        for bad in [-1.0, -TINY, f64::MIN, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for limits in [fence(bad), speed(bad)] {
                let (decision, sent) = once(&limits, towards([0.0; 3]), &at([0.0; 3]));
                assert_eq!(decision, Decision::Held(Reason::ConfigFault), "{limits:?}");
                assert_eq!(sent.mode, Mode::Hold);
            }
        }
    }

    /// [NCP-SAFE-012] The least positive double is a limit like any other.
    #[test]
    fn the_least_positive_limit_is_enforced() {
        let (_, sent) = once(&speed(TINY), towards([1.0, 0.0, 0.0]), &at([0.0; 3]));
        assert!(kernel::norm(setpoint(&sent.channels)).le(TINY));
        let (breach, _) = once(&fence(TINY), towards([0.0; 3]), &at([1.0, 0.0, 0.0]));
        assert_eq!(breach, Decision::Stopped(Reason::OutsideFence));
    }

    /// [NCP-SAFE-014] [NCP-SAFE-015] [NCP-SAFE-016] L10 L11
    #[test]
    fn a_limit_whose_channel_is_not_declared_as_it_needs_lets_nothing_move() {
        let sized = |spec: ChannelSpec, size| ChannelSpec { size: Some(size), ..spec };
        let wrong = |name: &'static str, unit: &'static str| {
            [
                vec![],
                vec![spec("another", ChannelKind::Vec3, Some(unit))],
                vec![spec(name, ChannelKind::Vec3, None)],
                vec![spec(name, ChannelKind::Vec3, Some("ft"))],
                vec![spec(name, ChannelKind::Vec3, Some(""))],
                vec![spec(name, ChannelKind::Scalar, Some(unit))],
                vec![spec(name, ChannelKind::Array, Some(unit))],
                vec![sized(spec(name, ChannelKind::Array, Some(unit)), 4)],
                vec![sized(spec(name, ChannelKind::Vec3, Some(unit)), 2)],
                // Declared twice, and once in another unit: which one a frame means is anyone's guess.
                vec![spec(name, ChannelKind::Vec3, Some(unit)), spec(name, ChannelKind::Vec3, Some("ft"))],
            ]
        };
        for sensor in wrong(POSITION_CHANNEL, METRES) {
            assert!(negotiated(fence(5.0), &sensor, &[drive()]).has_config_fault(), "{sensor:?}");
            // What no limit needs may be declared as one likes.
            assert!(!negotiated(speed(5.0), &sensor, &[drive()]).has_config_fault(), "{sensor:?}");
        }
        for command in wrong(VELOCITY_CHANNEL, METRES_PER_SECOND) {
            assert!(negotiated(speed(5.0), &[pose()], &command).has_config_fault(), "{command:?}");
            assert!(!negotiated(fence(5.0), &[pose()], &command).has_config_fault(), "{command:?}");
        }
        for array in [pose(), sized(pose(), 3), sized(spec(POSITION_CHANNEL, ChannelKind::Array, Some(METRES)), 3)] {
            assert!(!negotiated(fence(5.0), std::slice::from_ref(&array), &[drive()]).has_config_fault(), "{array:?}");
        }
    }

    /// [NCP-SAFE-009] [NCP-SAFE-017] [NCP-SAFE-018]
    #[test]
    fn a_config_fault_ends_neither_by_a_reset_nor_by_good_commands() {
        let mut governor = SafetyGovernor::new(&speed(f64::NAN));
        for round in 0..3 {
            let held = govern(&mut governor, &mut towards([0.0; 3]), &at([0.0; 3]));
            assert_eq!(held, Decision::Held(Reason::ConfigFault), "round {round}");
            governor.note_link(true);
            let stopped = govern(&mut governor, &mut towards([0.0; 3]), &at([0.0; 3]));
            assert_eq!(stopped, Decision::Stopped(Reason::Estop), "round {round}");
            governor.reset();
            assert!(governor.has_config_fault());
        }
    }

    /// [NCP-SAFE-019]
    #[test]
    fn the_tilt_limit_changes_nothing() {
        for tilt in [None, Some(0.0), Some(TINY), Some(-1.0), Some(f64::NAN), Some(f64::INFINITY)] {
            let limits = SafetyLimits { max_tilt_rad: tilt, max_speed_mps: Some(2.0), ..fence(5.0) };
            let (decision, sent) = once(&limits, towards([1.0, 0.0, 0.0]), &at([0.0; 3]));
            assert_eq!((decision, sent), (Decision::Passed, towards([1.0, 0.0, 0.0])), "{tilt:?}");
        }
    }
}

mod order {
    use super::*;

    /// [NCP-SAFE-020] All 192 sets of gates that close at once: the first of them decides.
    #[test]
    fn of_all_gates_that_close_the_first_decides() {
        let closes = |set: u32, gate: u32| set & (1 << gate) != 0;
        for set in 0..128_u32 {
            for outside in [false, true] {
                let limits =
                    SafetyLimits { max_speed_mps: Some(if closes(set, 1) { -1.0 } else { 5.0 }), ..fence(10.0) };
                let mut governor = SafetyGovernor::new(&limits);
                governor.note_link(closes(set, 0));
                let last_s = if closes(set, 2) { NOW_S - 1.0 } else { NOW_S };
                let sensor = match (closes(set, 3), outside) {
                    (false, _) => at([9.5, 0.0, 0.0]),
                    (true, false) => SensorFrame::default(),
                    (true, true) => at([10.5, 0.0, 0.0]),
                };
                let leaves = if closes(set, 6) { 5.0 } else { -5.0 };
                let mut command = towards([leaves, 0.0, 0.0]);
                if closes(set, 4) {
                    command.mode = Mode::Hold;
                }
                if closes(set, 5) {
                    command.channels.insert("gripper", ChannelValue::without_unit([f64::NAN]));
                }
                let expected = match set.trailing_zeros() {
                    0 => Decision::Stopped(Reason::Estop),
                    1 => Decision::Held(Reason::ConfigFault),
                    2 => Decision::Held(Reason::StaleSensor),
                    3 if outside => Decision::Stopped(Reason::OutsideFence),
                    3 => Decision::Held(Reason::NoPosition),
                    4 => Decision::Held(Reason::NotActive),
                    5 => Decision::Held(Reason::NotFinite),
                    6 => Decision::Held(Reason::LeavesFence),
                    _ => Decision::Passed,
                };
                let decision = governor.govern(&mut command, NOW_S, Some(&sensor), Some(last_s));
                assert_eq!(decision, expected, "gates {set:07b}, outside {outside}");
                assert_eq!(governor.is_stopped(), matches!(expected, Decision::Stopped(_)));
                let mode = match expected {
                    Decision::Stopped(_) => Mode::Estop,
                    Decision::Held(_) => Mode::Hold,
                    Decision::Passed | Decision::Limited => Mode::Active,
                };
                assert_eq!(command.mode, mode);
            }
        }
    }

    /// [NCP-SAFE-003] [NCP-SAFE-020]
    #[test]
    fn an_estop_command_stops_whatever_else_would_only_hold() {
        let limits = SafetyLimits { max_speed_mps: Some(f64::NAN), ..fence(10.0) };
        let mut governor = SafetyGovernor::new(&limits);
        let mut stop = CommandFrame { mode: Mode::Estop, ..towards([f64::NAN, 0.0, 0.0]) };
        let decision = governor.govern(&mut stop, f64::NAN, None, None);
        assert_eq!(decision, Decision::Stopped(Reason::Estop));
    }

    /// [NCP-SAFE-021]
    #[test]
    fn a_command_that_no_gate_closes_on_passes_bit_by_bit() {
        let mut command = along(&[0.1, -0.0, TINY], 100.0, 250.0);
        command.t = -0.0;
        command.channels.insert("gripper", ChannelValue::without_unit([-0.0, f64::MAX, -TINY]));
        command.channels.insert("empty", ChannelValue::without_unit([]));
        let limits = SafetyLimits { max_speed_mps: Some(1.0), ..fence(10.0) };
        let (decision, sent) = once(&limits, command.clone(), &at([-0.0, TINY, 0.0]));
        assert_eq!(decision, Decision::Passed);
        assert_eq!(bits(&sent), bits(&command));
        assert_eq!(sent, command);
        assert_eq!(sent.t.to_bits(), (-0.0_f64).to_bits());
    }

    /// [NCP-SAFE-022]
    #[test]
    fn a_hold_ends_with_the_first_command_that_passes() {
        let mut governor = SafetyGovernor::new(&fence(10.0));
        let home = at([0.0; 3]);
        for _ in 0..2 {
            let stale = governor.govern(&mut towards([1.0, 0.0, 0.0]), NOW_S, Some(&home), None);
            assert_eq!(stale, Decision::Held(Reason::StaleSensor));
            let blind = govern(&mut governor, &mut towards([1.0, 0.0, 0.0]), &SensorFrame::default());
            assert_eq!(blind, Decision::Held(Reason::NoPosition));
            let broken = govern(&mut governor, &mut towards([f64::NAN, 0.0, 0.0]), &home);
            assert_eq!(broken, Decision::Held(Reason::NotFinite));
            assert_eq!(govern(&mut governor, &mut towards([1.0, 0.0, 0.0]), &home), Decision::Passed);
        }
    }
}

mod sensor_age {
    use super::*;

    fn decide(timeout_ms: f64, now_s: f64, last_s: Option<f64>) -> Decision {
        let limits = SafetyLimits { command_timeout_ms: timeout_ms, ..no_limits() };
        let sensor = at([0.0; 3]);
        SafetyGovernor::new(&limits).govern(&mut towards([1.0, 0.0, 0.0]), now_s, Some(&sensor), last_s)
    }

    const STALE: Decision = Decision::Held(Reason::StaleSensor);

    /// [NCP-SAFE-033] [NCP-SAFE-034]
    #[test]
    fn a_sensor_exactly_as_old_as_the_timeout_is_fresh_and_one_ulp_more_is_stale() {
        // All of these are exact in doubles: the age in ms is the timeout to the bit.
        for (timeout_ms, now_s, last_s) in [(500.0, 10.5, 10.0), (250.0, 0.25, 0.0), (1_000.0, 0.0, -1.0)] {
            assert_eq!(decide(timeout_ms, now_s, Some(last_s)), Decision::Passed);
            assert_eq!(decide(timeout_ms.next_down(), now_s, Some(last_s)), STALE);
        }
        assert_eq!(decide(500.0, 10.5_f64.next_up(), Some(10.0)), STALE);
        assert_eq!(decide(500.0, 10.5, Some(10.0_f64.next_down())), STALE);
        assert_eq!(decide(500.0, 10.5, Some(10.0_f64.next_up())), Decision::Passed);
    }

    /// [NCP-SAFE-035] L14
    #[test]
    fn a_clock_that_stepped_back_makes_the_sensor_stale() {
        assert_eq!(decide(500.0, 10.0_f64.next_down(), Some(10.0)), STALE);
        assert_eq!(decide(500.0, -1e9, Some(1e9)), STALE);
        assert_eq!(decide(500.0, 10.0, Some(10.0)), Decision::Passed);
        assert_eq!(decide(500.0, -0.0, Some(0.0)), Decision::Passed, "−0 is not less than 0");
    }

    /// [NCP-SAFE-030]
    #[test]
    fn without_a_sensor_time_it_holds() {
        assert_eq!(decide(500.0, 10.0, None), STALE);
    }

    /// [NCP-SAFE-031]
    #[test]
    fn a_clock_that_reads_no_number_makes_the_sensor_stale() {
        for bad in NOT_FINITE {
            assert_eq!(decide(500.0, bad, Some(10.0)), STALE, "now {bad}");
            assert_eq!(decide(500.0, 10.0, Some(bad)), STALE, "last {bad}");
            assert_eq!(decide(500.0, bad, Some(bad)), STALE, "both {bad}");
        }
        // An age beyond every double is one, too.
        assert_eq!(decide(f64::MAX, f64::MAX, Some(f64::MIN)), STALE);
    }

    /// [NCP-SAFE-032] L13
    #[test]
    fn a_timeout_that_is_no_time_lets_nothing_move() {
        for bad in [0.0, -0.0, -TINY, -500.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(decide(bad, 10.0, Some(10.0)), STALE, "{bad}");
        }
        assert_eq!(decide(TINY, 10.0, Some(10.0)), Decision::Passed, "an age of 0 is within any");
        assert_eq!(decide(f64::MAX, 10.0, Some(-1e9)), Decision::Passed);
    }
}

mod geofence {
    use super::*;

    /// [NCP-SAFE-043] [NCP-SAFE-045]
    #[test]
    fn a_position_exactly_on_the_fence_is_inside_and_one_ulp_beyond_is_an_estop() {
        // Triples whose norms are exact in doubles.
        for (place, radius) in [([3.0, 4.0, 0.0], 5.0), ([1.0, -2.0, 2.0], 3.0), ([0.0, 0.0, -7.5], 7.5)] {
            let (on, _) = once(&fence(radius), towards([0.0; 3]), &at(place));
            assert_eq!(on, Decision::Passed, "{place:?}");
            let (beyond, sent) = once(&fence(radius.next_down()), towards([0.0; 3]), &at(place));
            assert_eq!(beyond, Decision::Stopped(Reason::OutsideFence), "{place:?}");
            assert_eq!(sent.mode, Mode::Estop);
        }
        let (beyond, _) = once(&fence(5.0), towards([0.0; 3]), &at([5.0_f64.next_up(), 0.0, 0.0]));
        assert_eq!(beyond, Decision::Stopped(Reason::OutsideFence));
    }

    /// [NCP-SAFE-043] L28: a sphere, not a cylinder and not a box.
    #[test]
    fn the_fence_is_a_sphere() {
        for outside in [[0.0, 0.0, 5.1], [3.0, 3.0, 3.0], [4.9, 4.9, 0.0], [0.0, 0.0, -5.1]] {
            let (decision, _) = once(&fence(5.0), towards([0.0; 3]), &at(outside));
            assert_eq!(decision, Decision::Stopped(Reason::OutsideFence), "{outside:?}");
        }
    }

    /// [NCP-SAFE-043] [NCP-SAFE-005]
    #[test]
    fn a_breach_latches_also_when_the_plant_comes_back() {
        let mut governor = SafetyGovernor::new(&fence(5.0));
        govern(&mut governor, &mut towards([0.0; 3]), &at([6.0, 0.0, 0.0]));
        let back = govern(&mut governor, &mut towards([0.0; 3]), &at([0.0; 3]));
        assert_eq!(back, Decision::Stopped(Reason::Estop));
    }

    /// [NCP-SAFE-040] L03 L11
    #[test]
    fn a_position_that_is_missing_or_not_3_wide_holds_and_is_never_the_origin() {
        let mut governor = SafetyGovernor::new(&fence(5.0));
        for data in [&[][..], &[0.0], &[0.0; 2], &[0.0; 4], &[f64::NAN], &[9.0; 4]] {
            let held = govern(&mut governor, &mut towards([0.0; 3]), &position(data, Some(METRES)));
            assert_eq!(held, Decision::Held(Reason::NoPosition), "{data:?}");
        }
        let held = govern(&mut governor, &mut towards([0.0; 3]), &SensorFrame::default());
        assert_eq!(held, Decision::Held(Reason::NoPosition));
        let held = governor.govern(&mut towards([0.0; 3]), NOW_S, None, Some(NOW_S));
        assert_eq!(held, Decision::Held(Reason::NoPosition));
        assert!(!governor.is_stopped());
    }

    /// [NCP-SAFE-041] [NCP-SAFE-042]
    #[test]
    fn a_position_in_another_unit_holds_and_one_without_a_unit_is_in_metres() {
        for unit in ["ft", "cm", "mm", "M", "m ", "", "m/s"] {
            let (decision, _) = once(&fence(5.0), towards([0.0; 3]), &position(&[9.0, 0.0, 0.0], Some(unit)));
            assert_eq!(decision, Decision::Held(Reason::NoPosition), "{unit:?}");
        }
        let (inside, _) = once(&fence(5.0), towards([0.0; 3]), &position(&[5.0, 0.0, 0.0], None));
        assert_eq!(inside, Decision::Passed);
        let (outside, _) = once(&fence(5.0), towards([0.0; 3]), &position(&[6.0, 0.0, 0.0], None));
        assert_eq!(outside, Decision::Stopped(Reason::OutsideFence));
    }

    /// [NCP-SAFE-044]
    #[test]
    fn a_position_whose_distance_cannot_be_computed_is_an_estop() {
        for axis in 0..3 {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut place = [0.0; 3];
                place[axis] = bad;
                let (decision, _) = once(&fence(f64::MAX), towards([0.0; 3]), &at(place));
                assert_eq!(decision, Decision::Stopped(Reason::OutsideFence), "{place:?}");
            }
        }
        let (decision, _) = once(&fence(f64::MAX), towards([0.0; 3]), &at([f64::MAX, f64::MAX, 0.0]));
        assert_eq!(decision, Decision::Stopped(Reason::OutsideFence));
    }

    /// [NCP-SAFE-043] [NCP-SAFE-045] Where the squares of the components leave the doubles, too.
    #[test]
    fn a_fence_of_any_size_is_where_it_is() {
        for exponent in [-1074, -1022, -600, -451, -449, 0, 499, 501, 600, 1020] {
            // In two steps, since not every power is a double.
            let size = |x: f64| x * 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
            let place = at([size(2.0), size(-3.0), size(6.0)]);
            assert_eq!(once(&fence(size(7.0)), towards([0.0; 3]), &place).0, Decision::Passed, "{exponent}");
            let (decision, _) = once(&fence(size(7.0).next_down()), towards([0.0; 3]), &place);
            assert_eq!(decision, Decision::Stopped(Reason::OutsideFence), "{exponent}");
        }
    }

    #[test]
    fn without_a_fence_no_position_is_needed() {
        for sensor in [SensorFrame::default(), at([f64::NAN; 3]), at([1e300; 3])] {
            assert_eq!(once(&no_limits(), towards([1.0, 0.0, 0.0]), &sensor).0, Decision::Passed);
        }
    }
}

mod projection {
    use super::*;

    const HOME: [f64; 3] = [0.0; 3];

    /// [NCP-SAFE-051] Without a horizon tick 0 is followed for all of the ttl.
    #[test]
    fn a_command_may_lead_exactly_onto_the_fence_and_not_beyond() {
        let onto = CommandFrame { ttl_ms: 1_000.0, ..towards([3.0, 4.0, 0.0]) };
        assert_eq!(once(&fence(5.0), onto.clone(), &at(HOME)), (Decision::Passed, onto.clone()));
        let longer = CommandFrame { ttl_ms: 1_001.0, ..onto.clone() };
        let (decision, sent) = once(&fence(5.0), longer, &at(HOME));
        assert_eq!((decision, sent.mode), (Decision::Held(Reason::LeavesFence), Mode::Hold));
        let (decision, _) = once(&fence(5.0), onto, &at([0.001, 0.0, 0.0]));
        assert_eq!(decision, Decision::Held(Reason::LeavesFence));
    }

    /// [NCP-SAFE-051] On the fence, only the way in is open.
    #[test]
    fn on_the_fence_only_the_way_in_is_open() {
        let edge = at([5.0, 0.0, 0.0]);
        assert_eq!(once(&fence(5.0), towards([-1.0, 0.0, 0.0]), &edge).0, Decision::Passed);
        assert_eq!(once(&fence(5.0), towards([0.0; 3]), &edge).0, Decision::Passed);
        for out in [[1.0, 0.0, 0.0], [0.0, 0.1, 0.0], [-0.001, 1.0, 0.0]] {
            assert_eq!(once(&fence(5.0), towards(out), &edge).0, Decision::Held(Reason::LeavesFence), "{out:?}");
        }
    }

    /// [NCP-SAFE-051] L02: the projection takes the ttl that the plant enforces, and the wire keeps its own.
    #[test]
    fn the_projection_looks_sixty_seconds_ahead_at_most() {
        let eternal = CommandFrame { ttl_ms: 1e9, ..towards([1.0, 0.0, 0.0]) };
        let (decision, sent) = once(&fence(60.0), eternal.clone(), &at(HOME));
        assert_eq!((decision, sent.ttl_ms), (Decision::Passed, 1e9));
        assert_eq!(once(&fence(59.9), eternal, &at(HOME)).0, Decision::Held(Reason::LeavesFence));
    }

    /// [NCP-SAFE-051] The way back of an overflow is no way.
    #[test]
    fn a_projection_that_overflows_leaves_the_fence() {
        for x in [1e307, f64::MAX, f64::MIN] {
            let wild = CommandFrame { ttl_ms: 60_000.0, ..towards([x, 0.0, 0.0]) };
            assert_eq!(once(&fence(f64::MAX), wild, &at(HOME)).0, Decision::Held(Reason::LeavesFence), "{x}");
        }
    }

    /// [NCP-SAFE-050] Tick 0 and two steps end at 1, 2 and 3 m; the third would end at 4.
    #[test]
    fn a_horizon_is_truncated_before_the_step_that_ends_outside() {
        let (decision, sent) = once(&fence(3.0), along(&[1.0; 4], 1_000.0, 9_000.0), &at(HOME));
        assert_eq!((decision, sent.horizon.len()), (Decision::Limited, 2));
        assert_eq!(sent.horizon_dt_ms, Some(1_000.0));
        let (decision, sent) = once(&fence(4.0), along(&[1.0; 4], 1_000.0, 9_000.0), &at(HOME));
        assert_eq!((decision, sent.horizon.len()), (Decision::Passed, 3));
        let (_, sent) = once(&fence(2.999), along(&[1.0; 4], 1_000.0, 9_000.0), &at(HOME));
        assert_eq!(sent.horizon.len(), 1);
    }

    /// [NCP-SAFE-050] What comes after the step that leaves cannot bring it back.
    #[test]
    fn a_step_that_leaves_ends_the_horizon_though_the_next_returns() {
        let (_, sent) = once(&fence(2.0), along(&[1.0, 1.0, 1.0, -1.0], 1_000.0, 9_000.0), &at(HOME));
        assert_eq!(sent.horizon.len(), 1);
    }

    /// [NCP-SAFE-051] With a horizon tick 0 is followed for one tick only.
    #[test]
    fn with_a_horizon_tick_0_is_followed_for_its_own_length() {
        let dart = along(&[5.0, -5.0], 100.0, 1_000.0);
        assert_eq!(once(&fence(0.5), dart.clone(), &at(HOME)).0, Decision::Passed);
        assert_eq!(once(&fence(0.499), dart, &at(HOME)).0, Decision::Held(Reason::LeavesFence));
        let alone = along(&[5.0], 100.0, 1_000.0);
        assert_eq!(once(&fence(0.5), alone, &at(HOME)).0, Decision::Held(Reason::LeavesFence));
    }

    /// [NCP-SAFE-053] The rule that is easily forgotten.
    #[test]
    fn a_horizon_truncated_to_nothing_leaves_tick_0_to_be_followed_until_the_ttl_ends() {
        // Tick 0 ends at 0.5 m, the step at 5.5 m; alone, tick 0 ends at ttl · 1 m/s.
        let (decision, sent) = once(&fence(1.0), along(&[1.0, 10.0], 500.0, 1_000.0), &at(HOME));
        assert_eq!((decision, sent.horizon.len()), (Decision::Limited, 0));
        let (decision, _) = once(&fence(1.0), along(&[1.0, 10.0], 500.0, 1_001.0), &at(HOME));
        assert_eq!(decision, Decision::Held(Reason::LeavesFence));
    }

    /// [NCP-SAFE-053] [NCP-SAFE-067] The same, where the speed limit's gate emptied the horizon.
    #[test]
    fn a_horizon_emptied_by_a_broken_step_is_projected_without_one() {
        let mut command = along(&[1.0, 1.0], 500.0, 2_000.0);
        command.horizon[0].get_mut(VELOCITY_CHANNEL).unwrap().data[1] = f64::NAN;
        assert_eq!(once(&fence(1.0), command.clone(), &at(HOME)).0, Decision::Held(Reason::LeavesFence));
        let (decision, sent) = once(&fence(2.0), command, &at(HOME));
        assert_eq!((decision, sent.horizon.len()), (Decision::Limited, 0));
    }

    /// [NCP-SAFE-050] Of a tick counts what lies before the end of the ttl.
    #[test]
    fn a_tick_is_followed_only_as_long_as_the_ttl_lasts() {
        // 500 ms of the second tick are left: 1 m.
        assert_eq!(once(&fence(1.0), along(&[0.0, 2.0], 1_000.0, 1_500.0), &at(HOME)).0, Decision::Passed);
        let (_, sent) = once(&fence(1.0), along(&[0.0, 2.0], 1_000.0, 1_501.0), &at(HOME));
        assert!(sent.horizon.is_empty());
        // Nothing is left of any tick after the first.
        for ttl_ms in [500.0, 1_000.0] {
            let wild = along(&[1.0, 900.0, -900.0], 1_000.0, ttl_ms);
            assert_eq!(once(&fence(1.0), wild.clone(), &at(HOME)), (Decision::Passed, wild));
        }
    }

    /// [NCP-SAFE-050] [NCP-SAFE-060] The clamped velocity is what the plant follows.
    #[test]
    fn the_clamped_velocity_is_projected_and_not_the_wished_one() {
        let limits = SafetyLimits { max_speed_mps: Some(1.0), ..fence(1.0) };
        let hasty = CommandFrame { ttl_ms: 1_000.0, ..towards([100.0, 0.0, 0.0]) };
        assert_eq!(once(&limits, hasty, &at(HOME)).0, Decision::Limited);
        let (decision, sent) = once(&limits, along(&[100.0, 100.0, 100.0], 400.0, 9_000.0), &at(HOME));
        assert_eq!((decision, sent.horizon.len()), (Decision::Limited, 1));
    }

    /// [NCP-SAFE-052]
    #[test]
    fn with_a_fence_a_command_without_a_usable_velocity_holds() {
        for (data, unit) in [
            (&[][..], Some("m/s")),
            (&[0.0], Some("m/s")),
            (&[0.0; 2], Some("m/s")),
            (&[0.0; 4], Some("m/s")),
            (&[0.0; 3], Some("km/h")),
            (&[0.0; 3], Some("m")),
            (&[0.0; 3], Some("")),
            (&[f64::NAN, 0.0, 0.0], Some("m/s")),
        ] {
            let command = CommandFrame { channels: velocity(data, unit), ..CommandFrame::default() };
            let (decision, sent) = once(&fence(5.0), command, &at(HOME));
            assert!(matches!(decision, Decision::Held(Reason::NoVelocity | Reason::NotFinite)), "{data:?} {unit:?}");
            assert_eq!(sent.mode, Mode::Hold);
        }
        let (decision, _) = once(&fence(5.0), CommandFrame::default(), &at(HOME));
        assert_eq!(decision, Decision::Held(Reason::NoVelocity));
        // A step of the horizon without one cannot be projected, nor anything after it.
        let mut command = along(&[0.0, 0.0, 0.0], 100.0, 1_000.0);
        command.horizon[1].clear();
        let (decision, sent) = once(&fence(5.0), command, &at(HOME));
        assert_eq!((decision, sent.horizon.len()), (Decision::Limited, 1));
    }

    /// [NCP-SAFE-042] [NCP-SAFE-052] Without a unit the velocity is in the negotiated one.
    #[test]
    fn a_velocity_without_a_unit_is_in_the_negotiated_one() {
        let bare = CommandFrame { channels: velocity(&[1.0, 0.0, 0.0], None), ..CommandFrame::default() };
        let knots = spec(VELOCITY_CHANNEL, ChannelKind::Vec3, Some("kn"));
        for (declared, expected) in [(drive(), Decision::Passed), (knots, Decision::Held(Reason::NoVelocity))] {
            let mut governor = negotiated(fence(5.0), &[pose()], std::slice::from_ref(&declared));
            let decision = govern(&mut governor, &mut bare.clone(), &at(HOME));
            assert_eq!(decision, expected, "{declared:?}");
            // The frame's own word counts for more.
            let decision = govern(&mut governor, &mut towards([1.0, 0.0, 0.0]), &at(HOME));
            assert_eq!(decision, Decision::Passed, "{declared:?}");
        }
        assert_eq!(once(&fence(5.0), bare, &at(HOME)).0, Decision::Passed, "the canonical channel");
    }

    /// [NCP-SAFE-042] Of a channel that is declared twice the first declaration says the unit.
    #[test]
    fn a_channel_that_is_declared_twice_has_the_unit_of_the_first_declaration() {
        let bare = CommandFrame { channels: velocity(&[1.0, 0.0, 0.0], None), ..CommandFrame::default() };
        let knots = || spec(VELOCITY_CHANNEL, ChannelKind::Vec3, Some("kn"));
        for (declared, expected) in
            [([drive(), knots()], Decision::Passed), ([knots(), drive()], Decision::Held(Reason::NoVelocity))]
        {
            let mut governor = negotiated(fence(5.0), &[pose()], &declared);
            assert_eq!(govern(&mut governor, &mut bare.clone(), &at(HOME)), expected, "{declared:?}");
        }
    }
}

mod speed_limit {
    use super::*;

    fn limited(max_mps: f64, command: CommandFrame) -> (Decision, CommandFrame) {
        once(&speed(max_mps), command, &SensorFrame::default())
    }

    /// [NCP-SAFE-060] [NCP-SAFE-061]
    #[test]
    fn a_velocity_above_the_limit_is_scaled_to_it_and_keeps_its_direction() {
        let (decision, sent) = limited(2.5, towards([3.0, -4.0, 0.0]));
        assert_eq!(decision, Decision::Limited);
        let scaled = setpoint(&sent.channels);
        assert!(kernel::norm(scaled).le(2.5));
        for (got, want) in scaled.iter().zip([1.5, -2.0, 0.0]) {
            assert!((got - want).abs() <= 1e-12, "{got} is not {want}");
        }
    }

    /// [NCP-SAFE-062]
    #[test]
    fn a_velocity_exactly_at_the_limit_is_left_alone_to_the_bit() {
        for (at_limit, max) in [([3.0, -4.0, -0.0], 5.0), ([0.1, 0.0, 0.0], 0.1), ([TINY, 0.0, 0.0], TINY)] {
            let (decision, sent) = limited(max, towards(at_limit));
            assert_eq!(decision, Decision::Passed);
            assert_eq!(bits(&sent), bits(&towards(at_limit)));
        }
        let (decision, sent) = limited(5.0_f64.next_down(), towards([3.0, 4.0, 0.0]));
        assert_eq!(decision, Decision::Limited);
        assert!(kernel::norm(setpoint(&sent.channels)).le(5.0_f64.next_down()));
    }

    /// [NCP-SAFE-060] [NCP-SAFE-061] A norm that overflows a double is above every limit.
    #[test]
    fn a_velocity_whose_norm_overflows_is_scaled_like_any_other() {
        for huge in [1e155, 1e200, f64::MAX] {
            let (decision, sent) = limited(3.0, towards([huge, -huge, huge]));
            assert_eq!(decision, Decision::Limited);
            let scaled = setpoint(&sent.channels);
            assert!(kernel::norm(scaled).le(3.0));
            for (got, want) in scaled.iter().zip([1.0, -1.0, 1.0]) {
                assert!((got - want * 3.0_f64.sqrt()).abs() <= 1e-12, "{huge}: {scaled:?}");
            }
        }
    }

    /// [NCP-SAFE-060] [NCP-SAFE-061] Half an ulp for each component and a few for the rest is taken off, and no more:
    /// along one axis at powers of two no other step rounds.
    #[test]
    fn a_velocity_is_scaled_no_further_below_the_limit_than_roundings_need() {
        let half_ulp = f64::EPSILON / 2.0;
        for (width, most) in [(1_u32, 16.0), (3, 16.0), (16, 32.0), (64, 96.0)] {
            let mut fast = vec![0.0; width as usize];
            fast[0] = 2.0;
            assert!(kernel::clamp(&mut fast, 1.0));
            assert!(fast[0] <= 1.0 - f64::from(width) * half_ulp, "{width} wide");
            assert!(fast[0] >= 1.0 - most * half_ulp, "{width} wide");
        }
    }

    /// [NCP-SAFE-060] Whatever the limit, to the least and the largest.
    #[test]
    fn no_limit_is_too_small_or_too_large_to_hold() {
        for max in [TINY, 1e-300, 1e-170, 1e-160, 1e-3, 1e160, 1e170, f64::MAX] {
            for x in [TINY, 1e-165, 1e-160, 1.0, 1e160, 1e165, f64::MAX] {
                let (_, sent) = limited(max, towards([x, -x, x]));
                let sent = setpoint(&sent.channels);
                assert!(kernel::norm(sent).le(max), "{x} at most {max}: {sent:?}");
                let is_above = x * 3.0_f64.sqrt() > max;
                if !is_above {
                    assert_eq!(sent, [x, -x, x]); // [NCP-SAFE-062]
                } else if max > f64::MIN_POSITIVE {
                    // [NCP-SAFE-061] Where squares and quotients leave the doubles, too.
                    let each = max / 3.0_f64.sqrt();
                    let is_near = |(got, sign): (&f64, f64)| (got * sign / each - 1.0).abs() <= 1e-12;
                    assert!(sent.iter().zip([1.0, -1.0, 1.0]).all(is_near), "{x} at most {max}: {sent:?}");
                }
            }
        }
    }

    /// [NCP-SAFE-060] [NCP-SAFE-062] Of a subnormal norm, which no double rounds.
    #[test]
    fn a_velocity_along_two_axes_is_above_a_limit_that_each_of_them_obeys() {
        let (decision, sent) = limited(TINY, towards([TINY, TINY, 0.0]));
        assert_eq!(decision, Decision::Limited);
        assert!(kernel::norm(setpoint(&sent.channels)).le(TINY));
    }

    /// [NCP-SAFE-063] L11
    #[test]
    fn with_a_speed_limit_a_command_without_a_usable_velocity_holds() {
        for (data, unit) in [
            (&[][..], Some("m/s")),
            (&[0.0; 2], Some("m/s")),
            (&[0.0; 4], Some("m/s")),
            (&[0.0; 3], Some("km/h")),
            (&[0.0; 3], Some("")),
        ] {
            let command = CommandFrame { channels: velocity(data, unit), ..CommandFrame::default() };
            let (decision, _) = limited(1.0, command.clone());
            assert_eq!(decision, Decision::Held(Reason::NoVelocity), "{data:?} {unit:?}");
            let (free, _) = once(&no_limits(), command, &SensorFrame::default());
            assert_eq!(free, Decision::Passed, "no limit needs a velocity");
        }
        assert_eq!(limited(1.0, CommandFrame::default()).0, Decision::Held(Reason::NoVelocity));
        let bare = CommandFrame { channels: velocity(&[9.0, 0.0, 0.0], None), ..CommandFrame::default() };
        assert_eq!(limited(1.0, bare).0, Decision::Limited, "it is in the negotiated m/s");
    }

    /// [NCP-SAFE-064]
    #[test]
    fn a_channel_of_tick_0_that_is_not_finite_holds_also_without_limits() {
        for bad in NOT_FINITE {
            for at in 0..3 {
                let mut broken = [0.0; 3];
                broken[at] = bad;
                let mut gripping = towards([0.0; 3]);
                gripping.channels.insert("gripper", ChannelValue::without_unit(broken));
                for command in [towards(broken), gripping] {
                    for limits in [no_limits(), speed(1.0), fence(5.0)] {
                        let (decision, sent) = once(&limits, command.clone(), &super::at([0.0; 3]));
                        assert_eq!(decision, Decision::Held(Reason::NotFinite), "{bad} at {at}");
                        assert!(sent.channels.values().all(|channel| channel.data == [0.0; 3]));
                    }
                }
            }
        }
    }

    /// [NCP-SAFE-065] Also of other widths, and in m/s by negotiation.
    #[test]
    fn every_channel_in_metres_a_second_obeys_the_limit() {
        let winch = spec("winch", ChannelKind::Scalar, Some(METRES_PER_SECOND));
        let mut governor = negotiated(speed(1.0), &[], &[winch, drive()]);
        let mut command = towards([0.5, 0.0, 0.0]);
        command.channels.extend([
            ("wheels", ChannelValue::new([1.0; 4], METRES_PER_SECOND)),
            ("winch", ChannelValue::without_unit([-7.0])),
            ("spin", ChannelValue::new([50.0; 3], "rad/s")),
            ("bare", ChannelValue::without_unit([50.0; 3])),
        ]);
        let decision = govern(&mut governor, &mut command, &SensorFrame::default());
        assert_eq!(decision, Decision::Limited);
        assert_eq!(setpoint(&command.channels), [0.5, 0.0, 0.0]);
        let wheels = &command.channels["wheels"].data;
        assert!(kernel::norm(wheels).le(1.0) && wheels.iter().all(|x| (x - 0.5).abs() < 1e-12));
        let winch = command.channels["winch"].data[0];
        assert!((-1.0..-1.0 + 1e-12).contains(&winch), "{winch}");
        assert_eq!(command.channels["spin"].data, [50.0; 3]);
        assert_eq!(command.channels["bare"].data, [50.0; 3]);
    }

    /// [NCP-SAFE-061] [NCP-SAFE-065] The roundings of a long norm do not cost the direction.
    #[test]
    fn a_channel_of_many_components_is_scaled_and_not_zeroed() {
        for width in (4..4_096).step_by(31) {
            let many: Vec<f64> = (0..width).map(|i| 0.1 + (i * i % 97) as f64).collect();
            let mut command = towards([0.0; 3]);
            command.channels.insert("many", ChannelValue::new(many.clone(), METRES_PER_SECOND));
            let (_, sent) = limited(0.7, command);
            let scaled = &sent.channels["many"].data;
            assert!(kernel::norm(scaled).le(0.7));
            assert!(!kernel::norm(scaled).le(0.7 * (1.0 - 1e-11)), "width {width}");
            let factor = scaled[0] / many[0];
            let is_kept = |(s, m): (&f64, &f64)| (s / m / factor - 1.0).abs() < 1e-12;
            assert!(scaled.iter().zip(&many).all(is_kept), "width {width}");
        }
    }

    /// [NCP-SAFE-066]
    #[test]
    fn every_step_of_the_horizon_obeys_the_limit() {
        let (decision, sent) = limited(2.0, along(&[1.0, 9.0, 2.0, -9.0], 100.0, 400.0));
        assert_eq!(decision, Decision::Limited);
        let along_x: Vec<f64> = sent.horizon.iter().map(|step| setpoint(step)[0]).collect();
        assert_eq!(along_x.len(), 3);
        assert!((along_x[0] - 2.0).abs() < 1e-12 && along_x[0] <= 2.0);
        assert_eq!(along_x[1], 2.0);
        assert!((along_x[2] + 2.0).abs() < 1e-12 && along_x[2] >= -2.0);
        assert_eq!(setpoint(&sent.channels)[0], 1.0);
    }

    /// [NCP-SAFE-067]
    #[test]
    fn the_horizon_ends_before_a_step_that_cannot_be_clamped_or_is_not_finite() {
        let broken: [fn(&mut ChannelMap); 5] = [
            |step| step.get_mut(VELOCITY_CHANNEL).unwrap().data[2] = f64::NAN,
            |step| step.get_mut(VELOCITY_CHANNEL).unwrap().data.truncate(2),
            |step| step.get_mut(VELOCITY_CHANNEL).unwrap().unit = Some("km/h".into()),
            |step| drop(step.remove(VELOCITY_CHANNEL)),
            |step| drop(step.insert("gripper", ChannelValue::without_unit([f64::INFINITY]))),
        ];
        for (nth, breaks) in broken.into_iter().enumerate() {
            for at in 0..3 {
                let mut command = along(&[1.0; 4], 100.0, 400.0);
                breaks(&mut command.horizon[at]);
                let (decision, sent) = limited(2.0, command);
                assert_eq!((decision, sent.horizon.len()), (Decision::Limited, at), "breakage {nth}");
            }
        }
        // Without a limit there is nothing to clamp; what is not finite ends it for all that.
        let mut command = along(&[1.0; 4], 100.0, 400.0);
        command.horizon[2].get_mut(VELOCITY_CHANNEL).unwrap().data[0] = f64::INFINITY;
        command.horizon[0].clear();
        let (decision, sent) = once(&no_limits(), command, &SensorFrame::default());
        assert_eq!((decision, sent.horizon.len()), (Decision::Limited, 2));
    }

    /// [NCP-SAFE-068]
    #[test]
    fn a_horizon_without_a_tick_length_holds() {
        for dt_ms in [None, Some(0.0), Some(-0.0), Some(-50.0), Some(f64::NAN), Some(f64::INFINITY)] {
            let command = CommandFrame { horizon_dt_ms: dt_ms, ..along(&[1.0, 1.0], 50.0, 200.0) };
            let (decision, sent) = once(&no_limits(), command, &SensorFrame::default());
            assert_eq!(decision, Decision::Held(Reason::BadHorizon), "{dt_ms:?}");
            assert!(sent.horizon.is_empty());
            // Without a horizon it means nothing.
            let command = CommandFrame { horizon_dt_ms: dt_ms, ..towards([1.0, 0.0, 0.0]) };
            assert_eq!(once(&no_limits(), command, &SensorFrame::default()).0, Decision::Passed);
        }
        let brief = CommandFrame { horizon_dt_ms: Some(TINY), ..along(&[1.0, 1.0], 50.0, 200.0) };
        assert_eq!(once(&fence(5.0), brief, &at([0.0; 3])).0, Decision::Passed);
    }
}

mod quiet_frames {
    use super::*;

    /// A command with all that a HOLD or an ESTOP keeps or takes away.
    fn rich(mode: Mode) -> CommandFrame {
        let mut command = along(&[1.0, 2.0], 100.0, 333.0);
        (command.seq, command.t, command.mode) = (42, 12.5, mode);
        command.frame_id = "base_link".into();
        command.channels.extend([
            ("gripper", ChannelValue::without_unit([0.5, 0.25])),
            ("spin", ChannelValue::new([f64::NAN, f64::INFINITY, -0.0], "rad/s")),
            ("empty", ChannelValue::new([], "A")),
        ]);
        command
    }

    /// [NCP-SAFE-070] [NCP-SAFE-071] [NCP-SAFE-072] [NCP-SAFE-073] [NCP-SAFE-074]
    #[test]
    fn a_quiet_frame_keeps_its_stamps_and_zeroes_the_union_of_the_channels() {
        let negotiated_channels = [
            spec("lamp", ChannelKind::Array, Some("cd")),
            spec("spin", ChannelKind::Vec3, Some("deg/s")),
            spec("horn", ChannelKind::Scalar, None),
            drive(),
        ];
        for mode in [Mode::Hold, Mode::Estop] {
            let mut governor = negotiated(no_limits(), &[], &negotiated_channels);
            let mut command = rich(mode);
            govern(&mut governor, &mut command, &SensorFrame::default());
            let want = CommandFrame {
                seq: 42,
                t: 12.5,
                frame_id: "base_link".into(),
                ttl_ms: 333.0,
                mode,
                channels: ChannelMap::from_iter([
                    ("empty", ChannelValue::new([], "A")),
                    ("gripper", ChannelValue::without_unit([0.0, 0.0])),
                    ("horn", ChannelValue::without_unit([0.0])),
                    ("lamp", ChannelValue::new([0.0], "cd")),
                    ("spin", ChannelValue::new([0.0; 3], "rad/s")),
                    (VELOCITY_CHANNEL, ChannelValue::new([0.0; 3], METRES_PER_SECOND)),
                ]),
                ..CommandFrame::default()
            };
            assert_eq!(command, want);
            assert!(bits(&command).concat().iter().all(|&bits| bits == 0), "a zero is +0");
        }
    }

    /// [NCP-SAFE-073] [NCP-SAFE-071] Without Capabilities the channels are the canonical ones.
    #[test]
    fn a_velocity_that_the_command_lacks_becomes_three_zeros_in_metres_a_second() {
        let (_, sent) = once(&no_limits(), CommandFrame { mode: Mode::Hold, ..CommandFrame::default() }, &at([0.0; 3]));
        assert_eq!(sent.channels, velocity(&[0.0; 3], Some(METRES_PER_SECOND)));
        // Also when it was negotiated without a unit, where no limit needs one.
        let bare = spec(VELOCITY_CHANNEL, ChannelKind::Scalar, None);
        let mut governor = negotiated(no_limits(), &[], &[bare]);
        let mut idle = CommandFrame { mode: Mode::Hold, ..CommandFrame::default() };
        govern(&mut governor, &mut idle, &SensorFrame::default());
        assert_eq!(idle.channels, velocity(&[0.0; 3], Some(METRES_PER_SECOND)));
    }

    /// [NCP-SAFE-070] [NCP-SAFE-071] Whichever gate closes, also one that closes after the clamp.
    #[test]
    fn whichever_gate_closes_the_quiet_frame_is_the_same() {
        let limits = SafetyLimits { max_speed_mps: Some(2.0), ..fence(5.0) };
        let frame = |change: fn(&mut CommandFrame)| {
            let mut command = CommandFrame { t: 3.0, ..towards([90.0, 0.0, 0.0]) };
            change(&mut command);
            command
        };
        let quiet = CommandFrame { mode: Mode::Hold, ..frame(|c| c.channels = velocity(&[0.0; 3], Some("m/s"))) };
        let home = at([0.0; 3]);
        for (command, sensor, last_s) in [
            (frame(|_| {}), &home, NOW_S - 9.0),
            (frame(|_| {}), &SensorFrame::default(), NOW_S),
            (frame(|c| c.mode = Mode::Init), &home, NOW_S),
            (frame(|c| c.channels.get_mut(VELOCITY_CHANNEL).unwrap().data[1] = f64::NAN), &home, NOW_S),
            (frame(|c| c.horizon = vec![ChannelMap::new()]), &home, NOW_S),
            (frame(|_| {}), &at([4.9, 0.0, 0.0]), NOW_S),
        ] {
            let mut sent = command.clone();
            let decision = SafetyGovernor::new(&limits).govern(&mut sent, NOW_S, Some(sensor), Some(last_s));
            assert!(matches!(decision, Decision::Held(_)), "{decision:?}");
            assert_eq!(sent, quiet, "{decision:?}");
        }
    }
}
