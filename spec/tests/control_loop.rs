//! The reflex controller and the control loop, rule by rule: chapter 10.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests may")]

use std::sync::{Arc, Mutex};

use ncp_spec::control::{
    ControlLoop, Controller, LoopConfig, LoopError, ReflexConfig, ReflexController, ReflexError, Tick,
};
use ncp_spec::resilience::LinkMonitor;
use ncp_spec::safety::{Decision, Reason, SafetyGovernor};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Mode, SafetyLimits, SensorFrame};

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const TINY: f64 = 5e-324;

fn sensor(seq: i64, t: f64) -> SensorFrame {
    SensorFrame { seq, t, ..at(&[1.0, 0.0, 0.0]) }
}

fn at(position: &[f64]) -> SensorFrame {
    let mut frame = SensorFrame::default();
    frame.channels.insert("pose_position", ChannelValue::new(position, "m"));
    frame
}

fn moving(position: &[f64], velocity: &[f64]) -> SensorFrame {
    let mut frame = at(position);
    frame.channels.insert("pose_velocity", ChannelValue::new(velocity, "m/s"));
    frame
}

fn setpoint(command: &CommandFrame) -> &[f64] {
    &command.channels["velocity_setpoint"].data
}

mod reflex {
    use super::*;

    fn reflex(config: ReflexConfig) -> ReflexController {
        ReflexController::new(config).unwrap()
    }

    fn step(config: ReflexConfig, sensor: &SensorFrame) -> CommandFrame {
        reflex(config).step(0.0, Some(sensor))
    }

    /// [NCP-CTRL-001]
    #[test]
    fn it_commands_each_axis_by_its_error_and_its_velocity() {
        let config = ReflexConfig { target_m: [1.0, -1.0, 0.0], kp: 0.5, kd: 0.25, max_speed_mps: 9.0 };
        let command = step(config, &moving(&[3.0, -1.0, 2.0], &[1.0, -2.0, 0.0]));
        assert_eq!(command.mode, Mode::Active);
        // −0.5·2 − 0.25·1, −0.5·0 + 0.25·2, −0.5·2
        assert_eq!(setpoint(&command), [-1.25, 0.5, -1.0]);
    }

    /// [NCP-CTRL-001] Each axis by itself: the vector's norm is the governor's business.
    #[test]
    fn each_axis_is_clamped_by_itself() {
        let command = step(ReflexConfig::default(), &at(&[-100.0, 100.0, 1.5]));
        assert_eq!(setpoint(&command), [1.5, -1.5, -1.5]);
        let command = step(ReflexConfig { max_speed_mps: 0.0, ..ReflexConfig::default() }, &at(&[5.0; 3]));
        assert!(setpoint(&command).iter().all(|&u| u == 0.0));
    }

    /// [NCP-CTRL-002]
    #[test]
    fn its_defaults_are_those_of_the_text() {
        let ReflexConfig { target_m, kp, kd, max_speed_mps } = ReflexConfig::default();
        assert_eq!((target_m, kp, kd, max_speed_mps), ([0.0; 3], 1.0, 0.3, 1.5));
        let command = step(ReflexConfig::default(), &moving(&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0]));
        assert_eq!(
            command.channels,
            ChannelMap::from_iter([("velocity_setpoint", ChannelValue::new([-1.0, -0.3, 0.0], "m/s"))])
        );
    }

    /// [NCP-CTRL-003] L03 L11
    #[test]
    fn without_a_usable_position_it_holds() {
        let mut reflex = reflex(ReflexConfig { target_m: [9.0; 3], ..ReflexConfig::default() });
        let mut blind = vec![None, Some(SensorFrame::default())];
        for position in [&[][..], &[1.0], &[1.0; 2], &[1.0; 4]] {
            blind.push(Some(at(position)));
        }
        for bad in NOT_FINITE {
            blind.extend([[bad, 0.0, 0.0], [0.0, bad, 0.0], [0.0, 0.0, bad]].map(|p| Some(at(&p))));
        }
        for sensor in blind {
            let command = reflex.step(0.0, sensor.as_ref());
            assert_eq!(command.mode, Mode::Hold, "{sensor:?}");
            assert_eq!(
                command.channels,
                ChannelMap::from_iter([("velocity_setpoint", ChannelValue::new([0.0; 3], "m/s"))])
            );
        }
        assert_eq!(reflex.step(0.0, Some(&at(&[1.0; 3]))).mode, Mode::Active, "a hold is not latched");
    }

    /// [NCP-CTRL-004]
    #[test]
    fn without_a_usable_velocity_it_damps_nothing() {
        for velocity in [&[][..], &[9.0], &[9.0; 2], &[9.0; 4], &[f64::NAN, 0.0, 0.0], &[f64::INFINITY; 3]] {
            let command = step(ReflexConfig::default(), &moving(&[1.0, 0.0, 0.0], velocity));
            assert_eq!((command.mode, setpoint(&command)), (Mode::Active, &[-1.0, 0.0, 0.0][..]), "{velocity:?}");
        }
    }

    /// [NCP-CTRL-005] L13
    #[test]
    fn gains_a_speed_or_a_target_that_are_no_use_are_refused() {
        let with = |change: &dyn Fn(&mut ReflexConfig)| {
            let mut config = ReflexConfig::default();
            change(&mut config);
            ReflexController::new(config).err()
        };
        for bad in [-1.0, -TINY, f64::MIN, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(with(&|c| c.kp = bad), Some(ReflexError::Gain { name: "kp", .. })), "{bad}");
            assert!(matches!(with(&|c| c.kd = bad), Some(ReflexError::Gain { name: "kd", .. })), "{bad}");
            assert!(matches!(with(&|c| c.max_speed_mps = bad), Some(ReflexError::MaxSpeed { .. })), "{bad}");
        }
        for bad in NOT_FINITE {
            for axis in 0..3 {
                assert_eq!(with(&|c| c.target_m[axis] = bad), Some(ReflexError::Target), "{bad}");
            }
        }
        for fine in [0.0, -0.0, TINY, f64::MAX] {
            assert_eq!(with(&|c| (c.kp, c.kd, c.max_speed_mps) = (fine, fine, fine)), None, "{fine}");
        }
    }

    /// [NCP-CTRL-001] What overflows on both sides has no value: it is not the bound, but a HOLD.
    #[test]
    fn an_error_that_cannot_be_computed_moves_nothing() {
        let far = ReflexConfig { target_m: [f64::MIN, 0.0, 0.0], ..ReflexConfig::default() };
        // The error alone overflows to −∞, which is a direction.
        let command = step(far, &at(&[f64::MAX, 0.0, 0.0]));
        assert_eq!((command.mode, setpoint(&command)[0]), (Mode::Active, -1.5));
        // A gain of 0 times that is nothing at all, and so is one ∞ against another.
        let command = step(ReflexConfig { kp: 0.0, ..far }, &at(&[f64::MAX, 1.0, 1.0]));
        assert_eq!((command.mode, setpoint(&command)), (Mode::Hold, &[0.0; 3][..]));
        let stiff = ReflexConfig { kd: f64::MAX, ..far };
        let command = step(stiff, &moving(&[f64::MAX, 1.0, 1.0], &[f64::MIN, 0.0, 0.0]));
        assert_eq!((command.mode, setpoint(&command)), (Mode::Hold, &[0.0; 3][..]));
    }
}

/// Hands the loop what it is told to, and remembers which sensor frame it was shown.
#[derive(Clone, Default)]
struct Scripted {
    next: Arc<Mutex<CommandFrame>>,
    shown: Arc<Mutex<Option<SensorFrame>>>,
}

impl Controller for Scripted {
    fn step(&mut self, _: f64, sensor: Option<&SensorFrame>) -> CommandFrame {
        *self.shown.lock().unwrap() = sensor.cloned();
        self.next.lock().unwrap().clone()
    }
}

impl Scripted {
    fn shows(&self) -> Option<(i64, f64)> {
        self.shown.lock().unwrap().as_ref().map(|frame| (frame.seq, frame.t))
    }
}

/// A loop of 50 ms whose controller does as it is told, behind a governor of `limits`.
fn scripted(limits: &SafetyLimits) -> (ControlLoop<Scripted>, Scripted) {
    let script = Scripted::default();
    let config = LoopConfig { period_ms: 50.0 };
    let looped = ControlLoop::new(config, script.clone(), SafetyGovernor::new(limits), LinkMonitor::default());
    (looped.unwrap(), script)
}

/// One tick of a new loop whose controller wishes for `command`, with a fresh sensor of seq 5.
fn tick_of(period_ms: f64, command: CommandFrame) -> Tick {
    let script = Scripted::default();
    *script.next.lock().unwrap() = command;
    let governor = SafetyGovernor::new(&SafetyLimits::default());
    let mut looped = ControlLoop::new(LoopConfig { period_ms }, script, governor, LinkMonitor::default()).unwrap();
    looped.on_sensor(sensor(5, 0.5), 1.0);
    looped.tick(1.0, 0.0)
}

mod ticks {
    use super::*;

    /// [NCP-CTRL-010] L13
    #[test]
    fn a_loop_without_a_period_does_not_start() {
        let start = |period_ms| {
            let governor = SafetyGovernor::new(&SafetyLimits::default());
            ControlLoop::new(LoopConfig { period_ms }, Scripted::default(), governor, LinkMonitor::default())
        };
        for bad in [0.0, -0.0, -1.0, -TINY, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(start(bad).err(), Some(LoopError::Period { .. })), "{bad}");
        }
        for fine in [TINY, 1.0, f64::MAX] {
            assert!(start(fine).is_ok(), "{fine}");
        }
    }

    /// [NCP-CTRL-011] [NCP-CTRL-012]
    #[test]
    fn the_newest_sensor_frame_is_kept_and_never_the_last_to_arrive() {
        let (mut looped, script) = scripted(&SafetyLimits::default());
        for (seq, t, is_newer) in [(5, 0.5, true), (4, 0.9, false), (5, 0.9, false), (7, 0.1, true), (6, 0.6, false)] {
            assert_eq!(looped.on_sensor(sensor(seq, t), 1.0), is_newer, "{seq}");
        }
        looped.tick(1.0, 0.0);
        assert_eq!(script.shows(), Some((7, 0.1)));
    }

    /// [NCP-CTRL-011]
    #[test]
    fn while_frames_are_not_stamped_the_newest_is_that_of_the_latest_t() {
        let (mut looped, script) = scripted(&SafetyLimits::default());
        for (t, is_newer) in [(0.5, true), (0.5, false), (0.4, false), (0.5_f64.next_up(), true), (f64::NAN, false)] {
            assert_eq!(looped.on_sensor(sensor(0, t), 1.0), is_newer, "{t}");
        }
        looped.tick(1.0, 0.0);
        assert_eq!(script.shows(), Some((0, 0.5_f64.next_up())));
    }

    /// [NCP-CTRL-012] A sensor that repeats itself, or plays back old frames, grows stale.
    #[test]
    fn frames_that_are_not_newer_do_not_keep_the_sensor_fresh() {
        let (mut looped, _) = scripted(&SafetyLimits::default());
        looped.on_sensor(sensor(5, 0.5), 1.0);
        for step in 1..=10 {
            let now_s = 1.0 + 0.05 * f64::from(step);
            looped.on_sensor(sensor(5, 0.5), now_s);
            looped.on_sensor(sensor(4, 0.9), now_s);
            assert_eq!(looped.tick(now_s, 0.0).decision, Decision::Passed);
        }
        let tick = looped.tick(1.5_f64.next_up(), 0.0);
        assert_eq!(tick.decision, Decision::Held(Reason::StaleSensor));
        looped.on_sensor(sensor(6, 0.6), 1.6);
        assert_eq!(looped.tick(1.6, 0.0).decision, Decision::Passed);
    }

    /// [NCP-CTRL-012] [NCP-SAFE-030]
    #[test]
    fn a_loop_without_a_sensor_holds() {
        let (mut looped, script) = scripted(&SafetyLimits::default());
        let Tick { command, decision, .. } = looped.tick(1.0, 0.0);
        assert_eq!((decision, command.mode), (Decision::Held(Reason::StaleSensor), Mode::Hold));
        assert_eq!((command.seq, script.shows()), (0, None));
    }

    /// [NCP-CTRL-013]
    /// [NCP-PLANE-006]
    #[test]
    fn a_command_echoes_the_seq_of_the_sensor_frame_that_the_tick_used() {
        let (mut looped, script) = scripted(&SafetyLimits::default());
        script.next.lock().unwrap().seq = 99;
        for seq in [-4, 3, 8] {
            looped.on_sensor(sensor(seq, 0.0), 1.0);
            assert_eq!(looped.tick(1.0, 0.0).command.seq, seq);
            assert_eq!(looped.tick(1.0, 0.0).command.seq, seq, "no newer one came");
        }
    }

    /// [NCP-CTRL-014]
    #[test]
    fn the_ttl_is_raised_to_two_periods_and_never_lowered() {
        let sent =
            |period_ms, ttl_ms| tick_of(period_ms, CommandFrame { ttl_ms, ..CommandFrame::default() }).command.ttl_ms;
        assert_eq!(sent(50.0, 100.0), 100.0);
        assert_eq!(sent(50.0, 100.0_f64.next_down()), 100.0);
        assert_eq!(sent(50.0, 100.0_f64.next_up()), 100.0_f64.next_up());
        assert_eq!(sent(50.0, 90_000.0), 90_000.0, "how long a plant enforces it is the plant's business");
        for short in [0.0, -0.0, -1.0, TINY, f64::MIN] {
            assert_eq!(sent(50.0, short), 100.0, "{short}");
        }
        assert_eq!(sent(50_000.0, 200.0), 100_000.0);
    }

    /// [NCP-CTRL-014] L12: a ttl that is no number is no time, and above all not a long one.
    #[test]
    fn a_ttl_that_is_no_number_becomes_the_shortest() {
        for bad in NOT_FINITE {
            let tick = tick_of(50.0, CommandFrame { ttl_ms: bad, ..CommandFrame::default() });
            assert_eq!(tick.command.ttl_ms, 100.0, "{bad}");
        }
    }

    /// [NCP-CTRL-014] [NCP-SAFE-051] The ttl that is sent is the ttl that was projected.
    #[test]
    fn the_ttl_is_raised_before_the_governor_looks_ahead() {
        let limits = SafetyLimits { geofence_radius_m: Some(2.0), ..SafetyLimits::default() };
        let (mut looped, script) = scripted(&limits);
        // 1 m of room. For the 10 ms that were wished for it would do, for 100 ms it does not.
        *script.next.lock().unwrap() = CommandFrame {
            ttl_ms: 10.0,
            channels: ChannelMap::from_iter([("velocity_setpoint", ChannelValue::new([11.0, 0.0, 0.0], "m/s"))]),
            ..CommandFrame::default()
        };
        looped.on_sensor(sensor(1, 0.0), 1.0);
        let tick = looped.tick(1.0, 0.0);
        assert_eq!(tick.decision, Decision::Held(Reason::LeavesFence));
        assert_eq!(tick.command.ttl_ms, 100.0);
    }

    /// [NCP-CTRL-015] Whatever the controller makes of it, what is sent can be read.
    #[test]
    fn what_a_controller_may_not_say_is_not_sent() {
        let value = |x: f64| ChannelMap::from_iter([("velocity_setpoint", ChannelValue::new([x; 3], "m/s"))]);
        let mut wishes = vec![CommandFrame {
            horizon: vec![value(1.0); 5_000],
            horizon_dt_ms: Some(1.0),
            ..CommandFrame::default()
        }];
        for bad in NOT_FINITE {
            wishes.extend([
                CommandFrame { t: bad, ..CommandFrame::default() },
                CommandFrame { ttl_ms: bad, ..CommandFrame::default() },
                CommandFrame { channels: value(bad), ..CommandFrame::default() },
                CommandFrame { horizon_dt_ms: Some(bad), ..CommandFrame::default() },
                CommandFrame {
                    horizon: vec![value(1.0), value(bad)],
                    horizon_dt_ms: Some(20.0),
                    ..CommandFrame::default()
                },
                CommandFrame { horizon: vec![value(1.0)], horizon_dt_ms: Some(bad), ..CommandFrame::default() },
            ]);
        }
        for period_ms in [TINY, 50.0, f64::MAX] {
            for wish in &wishes {
                let tick = tick_of(period_ms, wish.clone());
                let text = tick.command.encode().unwrap();
                assert_eq!(CommandFrame::decode(text.as_bytes()).unwrap(), tick.command);
                assert!(tick.status.encode().is_ok());
            }
        }
    }

    /// [NCP-CTRL-015] A clock that fails stops the plant, and not the telling of it.
    #[test]
    fn a_clock_that_reads_no_number_holds_and_is_not_sent() {
        let (mut looped, _) = scripted(&SafetyLimits::default());
        looped.on_sensor(sensor(1, 0.0), 1.0);
        assert_eq!(looped.tick(1.0, 0.0).decision, Decision::Passed);
        for bad in NOT_FINITE {
            let Tick { command, status, decision } = looped.tick(bad, 0.0);
            assert_eq!(decision, Decision::Held(Reason::StaleSensor));
            assert_eq!((command.t, status.t), (1.0, 1.0), "{bad}");
        }
    }

    /// [NCP-CTRL-016] [NCP-SAFE-006] [NCP-RES-053]
    #[test]
    fn a_burst_stops_the_very_tick_that_follows_it() {
        let (mut looped, _) = scripted(&SafetyLimits::default());
        looped.on_sensor(sensor(1, 0.0), 1.0);
        assert_eq!(looped.tick(1.0, 0.0).decision, Decision::Passed);
        looped.on_sensor(sensor(30, 0.0), 1.0);
        assert!(looped.link().burst());
        assert_eq!(looped.tick(1.0, 0.0).decision, Decision::Stopped(Reason::Estop));
        // The link recovers; the latch stays, until a supervisor opens it.
        for seq in 31..200 {
            looped.on_sensor(sensor(seq, 0.0), 1.0);
        }
        assert!(!looped.link().burst());
        assert_eq!(looped.tick(1.0, 0.0).decision, Decision::Stopped(Reason::Estop));
        looped.governor_mut().reset();
        assert_eq!(looped.tick(1.0, 0.0).decision, Decision::Passed);
    }

    /// [NCP-RES-053] A sensor that is faster than the loop loses nothing by it.
    #[test]
    fn frames_between_two_ticks_are_no_loss() {
        let (mut looped, _) = scripted(&SafetyLimits::default());
        for seq in 1..=1_000 {
            looped.on_sensor(sensor(seq, 0.0), 1.0);
            if seq % 100 == 0 {
                assert_eq!(looped.tick(1.0, 0.0).decision, Decision::Passed);
            }
        }
        let report = looped.link().report();
        assert_eq!((report.received, report.lost), (1_000, 0));
        // A late one and a duplicate are seen too, though neither is newer.
        looped.on_sensor(sensor(1_002, 0.0), 1.0);
        assert_eq!(looped.link().report().lost, 1);
        looped.on_sensor(sensor(1_001, 0.0), 1.0);
        looped.on_sensor(sensor(1_001, 0.0), 1.0);
        let report = looped.link().report();
        assert_eq!((report.received, report.lost), (1_002, 0));
    }

    /// [NCP-CTRL-017]
    #[test]
    fn each_tick_tells_its_count_its_mode_and_its_latency() {
        let (mut looped, script) = scripted(&SafetyLimits::default());
        looped.on_sensor(sensor(40, 0.0), 1.0);
        for (count, mode) in [(1, Mode::Active), (2, Mode::Hold), (3, Mode::Active), (4, Mode::Estop)] {
            script.next.lock().unwrap().mode = mode;
            let latency_ms = count as f64;
            let status = looped.tick(1.25, latency_ms).status;
            assert_eq!((status.seq, status.mode, status.t), (count, mode, 1.25));
            assert_eq!(status.loop_latency_ms, latency_ms);
        }
    }

    /// [NCP-CTRL-018]
    #[test]
    fn safety_is_not_ok_when_an_active_command_was_turned_into_a_hold_or_an_estop() {
        let (mut looped, _) = scripted(&SafetyLimits::default());
        assert!(!looped.tick(1.0, 0.0).status.safety_ok, "no sensor: a hold");
        looped.on_sensor(sensor(1, 0.0), 1.0);
        assert!(looped.tick(1.0, 0.0).status.safety_ok);
        looped.governor_mut().note_link(true);
        assert!(!looped.tick(1.0, 0.0).status.safety_ok, "latched");
    }

    /// [NCP-CTRL-019]
    #[test]
    fn only_a_tick_that_overran_its_period_is_noted() {
        let (mut looped, _) = scripted(&SafetyLimits::default());
        for (took_ms, noted) in
            [(0.0, false), (50.0, false), (50.0_f64.next_up(), true), (f64::INFINITY, true), (f64::NAN, false)]
        {
            let status = looped.tick(1.0, took_ms).status;
            assert_eq!(status.note.is_some(), noted, "{took_ms}");
            assert!(status.loop_latency_ms.is_finite());
        }
    }

    /// [NCP-CTRL-020] The loop hands its commands out one by one, and none is older than the last.
    #[test]
    fn commands_leave_in_the_order_of_their_sensor_frames() {
        let (mut looped, _) = scripted(&SafetyLimits::default());
        let mut sent = Vec::new();
        for (step, seq) in [3, 1, 2, 4, 6, 5, 8].into_iter().enumerate() {
            looped.on_sensor(sensor(seq, 0.0), 1.0);
            let command = looped.tick(1.0 + 0.01 * step as f64, 0.0).command;
            sent.push((command.seq, command.t));
        }
        assert!(sent.is_sorted());
        assert_eq!(sent.iter().map(|(seq, _)| *seq).collect::<Vec<_>>(), [3, 3, 3, 4, 6, 6, 8]);
    }

    /// [NCP-CTRL-011] L20: what arrives is kept as it is, not copied for each tick.
    #[test]
    fn a_controller_is_shown_the_very_frame_that_arrived() {
        struct Pointing(Arc<Mutex<Vec<usize>>>);
        impl Controller for Pointing {
            fn step(&mut self, _: f64, sensor: Option<&SensorFrame>) -> CommandFrame {
                let data = sensor.map(|frame| frame.channels["pose_position"].data.as_ptr().addr());
                self.0.lock().unwrap().extend(data);
                CommandFrame::default()
            }
        }
        let seen = Arc::new(Mutex::new(Vec::new()));
        let governor = SafetyGovernor::new(&SafetyLimits::default());
        let mut looped = ControlLoop::new(
            LoopConfig { period_ms: 50.0 },
            Pointing(Arc::clone(&seen)),
            governor,
            LinkMonitor::default(),
        )
        .unwrap();
        let frame = sensor(1, 0.0);
        let address = frame.channels["pose_position"].data.as_ptr().addr();
        looped.on_sensor(frame, 1.0);
        looped.tick(1.0, 0.0);
        looped.tick(1.0, 0.0);
        assert_eq!(*seen.lock().unwrap(), [address, address]);
    }
}
