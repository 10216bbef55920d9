//! The invariants of the safety chapters, over random traces.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use ncp_spec::control::{ControlLoop, Controller, LoopConfig, ReflexConfig, ReflexController};
use ncp_spec::resilience::{ActionBuffer, CommandWatchdog, LinkMonitor, is_estop, max_horizon_len};
use ncp_spec::safety::{Decision, POSITION_CHANNEL, SafetyGovernor, VELOCITY_CHANNEL, kernel};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Mode, SafetyLimits, SensorFrame};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

/// Every class of double: usual sizes most of the time, then the edges.
fn any_double() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -100.0..100.0_f64,
        1 => any::<f64>(),
        1 => prop::sample::select(vec![
            0.0, -0.0, 1.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN,
            f64::MIN_POSITIVE, 5e-324, -5e-324, 1e-170, 1e-165, 1e-160, 1e160, 1e165, 1e170, 60_000.0, 60_000.000_1,
        ]),
    ]
}

fn mode() -> impl Strategy<Value = Mode> {
    prop_oneof![5 => Just(Mode::Active), 1 => Just(Mode::Hold), 1 => Just(Mode::Init)]
}

fn velocity() -> impl Strategy<Value = ChannelValue> {
    (prop::collection::vec(any_double(), 3), prop::option::weighted(0.7, Just("m/s")))
        .prop_map(|(data, unit)| ChannelValue { data, unit: unit.map(Into::into) })
}

fn tick() -> impl Strategy<Value = ChannelMap> {
    prop::option::weighted(0.95, velocity()).prop_map(|velocity| {
        let mut channels = ChannelMap::new();
        if let Some(velocity) = velocity {
            channels.insert(VELOCITY_CHANNEL, velocity);
        }
        channels
    })
}

prop_compose! {
    fn command()(
        mode in mode(),
        seq in -2..20_i64,
        ttl_ms in prop_oneof![3 => 1.0..2_000.0_f64, 1 => any_double()],
        channels in tick(),
        horizon in prop::collection::vec(tick(), 0..6),
        horizon_dt_ms in prop::option::weighted(0.9, prop_oneof![5 => 1.0..500.0_f64, 1 => any_double()]),
    ) -> CommandFrame {
        CommandFrame { mode, seq, ttl_ms, channels, horizon, horizon_dt_ms, ..CommandFrame::default() }
    }
}

fn at(position: [f64; 3]) -> SensorFrame {
    let mut frame = SensorFrame { seq: 1, ..SensorFrame::default() };
    frame.channels.insert(POSITION_CHANNEL, ChannelValue::new(position, "m"));
    frame
}

fn fenced(radius_m: f64, max_speed_mps: Option<f64>) -> SafetyLimits {
    SafetyLimits { geofence_radius_m: Some(radius_m), max_speed_mps, ..SafetyLimits::default() }
}

fn setpoint(channels: &ChannelMap) -> [f64; 3] {
    channels.get(VELOCITY_CHANNEL).and_then(|v| v.data.as_slice().try_into().ok()).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 4_000,
        max_global_rejects: 100_000,
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct(
            "tests/safety_properties.proptest-regressions",
        ))),
        ..ProptestConfig::default()
    })]

    /// [NCP-SAFE-050] [NCP-SAFE-051] [NCP-SAFE-052] [NCP-SAFE-053] [NCP-SAFE-054]
    #[test]
    fn a_plant_that_follows_a_governed_command_never_leaves_the_ball_before_it_holds(
        radius_m in 0.1..50.0_f64,
        max_speed in prop::option::of(0.1..20.0_f64),
        direction in prop::array::uniform3(-1.0..1.0_f64),
        share in 0.0..=1.0_f64,
        mut command in command(),
    ) {
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
        prop_assume!(length > 1e-3);
        let start = direction.map(|x| x / length * radius_m * share);
        let mut governor = SafetyGovernor::new(&fenced(radius_m, max_speed));
        let decision = governor.govern(&mut command, 10.0, Some(&at(start)), Some(10.0));
        prop_assume!(matches!(decision, Decision::Passed | Decision::Limited));

        // The plant, by its own small steps.
        let mut buffer = ActionBuffer::new();
        buffer.on_command(command.clone(), 0.0);
        let until_s = kernel::enforced_ttl_ms(command.ttl_ms).unwrap_or(0.0) / 1000.0;
        let dt_s = command.horizon_dt_ms.unwrap_or(1000.0) / 1000.0;
        // Steps that end on the tick boundaries, so that following is exact.
        let alone = command.horizon.is_empty();
        let mut place = start;
        for step in 0..=command.horizon.len() {
            let from_s = if alone { 0.0 } else { step as f64 * dt_s };
            if from_s >= until_s { break; }
            let to_s = if alone { until_s } else { (from_s + dt_s).min(until_s) };
            let middle_s = f64::midpoint(from_s, to_s);
            let Some(channels) = buffer.active(middle_s) else { break };
            let velocity = setpoint(channels);
            for part in 1..=8 {
                let elapsed_s = (to_s - from_s).max(0.0) * f64::from(part) / 8.0;
                let here = kernel::travel(&place, &velocity, elapsed_s);
                prop_assert!(
                    kernel::norm(&here).le(radius_m * (1.0 + 1e-9)),
                    "{here:?} is outside {radius_m} m at {} s", from_s + elapsed_s
                );
            }
            place = kernel::travel(&place, &velocity, (to_s - from_s).max(0.0));
            if alone { break; }
        }
    }

    /// [NCP-SAFE-060] [NCP-SAFE-061] [NCP-SAFE-062]
    #[test]
    fn a_clamped_vector_is_not_above_the_bound_and_keeps_its_direction(
        vector in prop::array::uniform3(any_double()),
        max in any_double(),
    ) {
        let mut clamped = vector;
        let usable = kernel::clamp(&mut clamped, max);
        prop_assert_eq!(usable, kernel::all_finite(&vector) && max.is_finite() && max > 0.0);
        if !usable { return Ok(()); }
        prop_assert!(kernel::norm(&clamped).le(max));
        if kernel::norm(&vector).le(max) {
            prop_assert_eq!(clamped, vector);
        } else if (1e-300..=f64::MAX).contains(&max) {
            prop_assert!(!kernel::norm(&clamped).le(max * (1.0 - 1e-12)));
            let largest = vector.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            for (a, b) in clamped.iter().zip(vector) {
                let want = b / largest;
                let got = a / clamped.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                prop_assert!((want - got).abs() <= 1e-12, "{want} became {got}");
            }
        }
    }

    /// [NCP-SAFE-002] [NCP-SAFE-020] [NCP-SAFE-060] [NCP-SAFE-064] [NCP-SAFE-066] [NCP-SAFE-067]
    #[test]
    fn whatever_passes_the_governor_is_active_finite_and_within_the_speed(
        mut command in command(),
        limits in (prop::option::of(any_double()), prop::option::of(any_double()), any_double()),
        position in prop::array::uniform3(any_double()),
        clocks in (any_double(), prop::option::of(any_double())),
    ) {
        let limits = SafetyLimits {
            max_speed_mps: limits.0,
            geofence_radius_m: limits.1,
            command_timeout_ms: limits.2,
            max_tilt_rad: None,
        };
        let was = command.mode;
        let mut governor = SafetyGovernor::new(&limits);
        let decision = governor.govern(&mut command, clocks.0, Some(&at(position)), clocks.1);
        match decision {
            Decision::Passed | Decision::Limited => {
                prop_assert_eq!(was, Mode::Active);
                prop_assert_eq!(command.mode, Mode::Active);
                let ticks = std::iter::once(&command.channels).chain(&command.horizon);
                for channels in ticks {
                    for channel in channels.values() {
                        prop_assert!(kernel::all_finite(&channel.data));
                    }
                    if let Some(max) = limits.max_speed_mps.filter(|&max| max > 0.0) {
                        prop_assert!(kernel::norm(&setpoint(channels)).le(max));
                    }
                }
            }
            Decision::Held(_) | Decision::Stopped(_) => {
                let mode = if matches!(decision, Decision::Held(_)) { Mode::Hold } else { Mode::Estop };
                prop_assert_eq!(command.mode, mode);
                prop_assert!(command.horizon.is_empty());
                prop_assert!(command.channels.contains_key(VELOCITY_CHANNEL));
                for channel in command.channels.values() {
                    prop_assert!(channel.data.iter().all(|&x| x == 0.0));
                }
            }
        }
        prop_assert_eq!(governor.is_stopped(), matches!(decision, Decision::Stopped(_)));
    }

    /// [NCP-RES-001] [NCP-RES-002] [NCP-RES-003] [NCP-RES-004] [NCP-RES-005] [NCP-RES-006]
    /// [NCP-RES-007] [NCP-RES-008] [NCP-RES-009] [NCP-RES-010]: the liveness rule, against its own
    /// words.
    #[test]
    fn the_watchdog_lets_a_plant_move_only_within_an_advancing_commands_ttl(
        events in prop::collection::vec(
            prop_oneof![
                (any_double(), any_double(), -3..6_i64).prop_map(|(now, ttl, seq)| (now, Some((ttl, seq)))),
                any_double().prop_map(|now| (now, None)),
                (0.0..2.0_f64).prop_map(|now| (now, None)),
                (0.0..1.0_f64, 1.0..3_000.0_f64, -3..6_i64).prop_map(|(now, ttl, seq)| (now, Some((ttl, seq)))),
            ],
            1..12,
        ),
    ) {
        let mut watchdog = CommandWatchdog::new();
        let mut accepted: Vec<(f64, f64, i64)> = Vec::new();
        let mut held = true;
        for (now, event) in events {
            match event {
                Some((ttl, seq)) => {
                    let advances = accepted.iter().all(|&(_, _, known)| seq > known);
                    prop_assert_eq!(watchdog.on_command(now, ttl, seq), advances);
                    if advances {
                        accepted.push((now, ttl, seq));
                        held = false;
                    }
                }
                None => {
                    let hold = watchdog.should_hold(now);
                    let may_move = accepted.last().is_some_and(|&(r, ttl, _)| {
                        r.is_finite() && now.is_finite() && ttl.is_finite() && r <= now
                            && (now - r) * 1000.0 <= ttl.min(60_000.0) && ttl > 0.0
                    });
                    held = held || !may_move;
                    prop_assert_eq!(hold, held);
                }
            }
        }
    }

    /// [NCP-SAFE-001] [NCP-RES-020] [NCP-RES-021] [NCP-RES-023] [NCP-RES-025] [NCP-RES-030] [NCP-RES-031]
    #[test]
    fn a_plant_moves_only_on_the_newest_active_command_and_never_while_stopped_or_held_or_reset(
        events in prop::collection::vec((0..5_u8, command(), 0.0..0.4_f64), 1..12),
    ) {
        let mut buffer = ActionBuffer::new();
        let (mut stopped, mut newest, mut may_move) = (false, None::<i64>, false);
        let mut now = 0.0;
        for (what, mut command, pause) in events {
            now += pause;
            match what {
                0 => {
                    buffer.reset();
                    (stopped, newest, may_move) = (false, None, false);
                }
                1 => {
                    command.mode = Mode::Estop;
                    buffer.on_command(command, now);
                    stopped = true;
                }
                _ => {
                    let (seq, mode) = (command.seq, command.mode);
                    buffer.on_command(command, now);
                    let advances = newest.is_none_or(|last| seq > last);
                    if mode == Mode::Active {
                        if advances { (newest, may_move) = (Some(seq), true); }
                    } else if advances || seq == 0 || newest == Some(seq) {
                        may_move = false;
                        if advances && seq != 0 { newest = Some(seq); }
                    }
                }
            }
            if buffer.active(now).is_some() {
                prop_assert!(may_move && !stopped);
            }
            prop_assert_eq!(buffer.is_stopped(), stopped);
        }
    }

    /// [NCP-RES-022]
    #[test]
    fn any_object_that_says_estop_is_one_whatever_else_it_says(
        other in "[ -~]{0,12}",
        number in any::<f64>(),
        order in any::<bool>(),
    ) {
        let other = serde_json::to_string(&other).unwrap();
        let (a, b) = (r#""kind":"command_frame""#, r#""mode":"estop""#);
        let (a, b) = if order { (a, b) } else { (b, a) };
        let frame = format!(r#"{{"seq":{number:e},{a},"x":[{other},{{}}],{b},"mode":{other},"t":null}}"#);
        prop_assert!(is_estop(frame.as_bytes()), "{}", frame);
        let mut buffer = ActionBuffer::new();
        let _ = buffer.on_frame(frame.as_bytes(), 0.0);
        prop_assert!(buffer.is_stopped());
    }

    /// [NCP-RES-022]
    #[test]
    fn no_bytes_make_the_estop_reader_fail(bytes in prop::collection::vec(any::<u8>(), 0..64)) {
        let _ = is_estop(&bytes);
    }

    /// [NCP-RES-040] [NCP-RES-041] [NCP-RES-042] [NCP-RES-043] [NCP-RES-044] [NCP-RES-045]
    #[test]
    fn the_loss_rate_is_exact_under_loss_duplication_and_reordering(
        fate in prop::collection::vec((0..4_u8, 0..8_usize), 1..300),
    ) {
        let mut arrivals: Vec<(usize, i64)> = Vec::new();
        for (seq, (fate, delay)) in fate.iter().enumerate() {
            let seq_no = i64::try_from(seq).unwrap();
            match fate {
                0 => {}
                1 => arrivals.extend([(seq, seq_no), (seq + delay, seq_no)]),
                _ => arrivals.push((seq + delay, seq_no)),
            }
        }
        arrivals.sort();
        prop_assume!(!arrivals.is_empty());
        let mut monitor = LinkMonitor::default();
        for (_, seq) in &arrivals {
            monitor.on_frame(*seq);
            let rate = monitor.report().loss_rate;
            prop_assert!((0.0..=1.0).contains(&rate));
        }
        let first = arrivals[0].1;
        let mut distinct: Vec<i64> = arrivals.iter().map(|(_, s)| *s).filter(|s| *s >= first).collect();
        distinct.sort_unstable();
        distinct.dedup();
        let expected = distinct.last().unwrap() - first + 1;
        let lost = expected - i64::try_from(distinct.len()).unwrap();
        let report = monitor.report();
        prop_assert_eq!(report.lost, lost);
        prop_assert_eq!(report.received, i64::try_from(distinct.len()).unwrap());
        prop_assert_eq!(report.loss_rate, lost as f64 / expected as f64);
    }

    /// [NCP-RES-049] [NCP-RES-050]
    #[test]
    fn a_healthy_link_clears_any_burst_in_bounded_time(
        seqs in prop::collection::vec(any::<i64>(), 1..20),
    ) {
        let mut monitor = LinkMonitor::default();
        for seq in seqs { monitor.on_frame(seq); }
        let last = monitor.report().last_seq;
        prop_assume!(last < i64::MAX - 300);
        for seq in 1..=201 { monitor.on_frame(last + seq); }
        prop_assert!(!monitor.report().burst);
    }

    /// [NCP-RES-033] [NCP-RES-034]
    #[test]
    fn a_horizon_of_the_longest_length_ends_within_the_ttl(ttl in any_double(), dt in any_double()) {
        let len = max_horizon_len(ttl, dt);
        prop_assert!(len <= 4_096);
        if len > 0 {
            prop_assert!(ttl > 0.0 && dt > 0.0 && (len as f64) * dt <= ttl * (1.0 + 1e-12));
        }
    }

    /// [NCP-CTRL-013] [NCP-CTRL-014] [NCP-CTRL-015]
    #[test]
    fn the_loop_never_sends_a_command_that_a_receiver_refuses(
        frames in prop::collection::vec(
            (0..50_i64, any_double(), prop::array::uniform3(any_double()), any_double(), any_double()),
            1..12,
        ),
        wish in command(),
        period_ms in 1.0..100.0_f64,
        max_speed in any_double(),
    ) {
        struct Wish(CommandFrame);
        impl Controller for Wish {
            fn step(&mut self, _: f64, _: Option<&SensorFrame>) -> CommandFrame { self.0.clone() }
        }
        let limits = fenced(20.0, Some(max_speed));
        let config = LoopConfig { period_ms };
        let mut wild = ControlLoop::new(
            config, Wish(wish), SafetyGovernor::new(&limits), LinkMonitor::default(),
        ).unwrap();
        let reflex = ReflexController::new(ReflexConfig::default()).unwrap();
        let mut tame = ControlLoop::new(
            config, reflex, SafetyGovernor::new(&limits), LinkMonitor::default(),
        ).unwrap();
        for (seq, t, position, now, took) in frames {
            let sensor = SensorFrame { seq, t, ..at(position) };
            wild.on_sensor(sensor.clone(), now);
            tame.on_sensor(sensor, now);
            for tick in [wild.tick(now, took), tame.tick(now, took)] {
                let text = tick.command.encode().unwrap();
                prop_assert_eq!(CommandFrame::decode(text.as_bytes()).unwrap(), tick.command.clone());
                prop_assert!(tick.status.encode().is_ok());
                prop_assert!(tick.command.ttl_ms >= 2.0 * period_ms);
                prop_assert_eq!(tick.command.mode, tick.status.mode);
            }
        }
    }
}
