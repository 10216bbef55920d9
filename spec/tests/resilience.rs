//! The plant's side, rule by rule: chapter 8, with the boundary of each rule on both of its sides.

use ncp_spec::resilience::{
    ActionBuffer, CommandWatchdog, LinkMonitor, LinkReport, Received, is_estop, max_horizon_len,
};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, MAX_ITEMS, Mode};

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const TINY: f64 = 5e-324;

fn tick(x: f64) -> ChannelMap {
    ChannelMap::from_iter([("velocity_setpoint", ChannelValue::new([x, 0.0, 0.0], "m/s"))])
}

/// A command whose only tick is marked by its seq.
fn command(seq: i64, mode: Mode, ttl_ms: f64) -> CommandFrame {
    CommandFrame { seq, mode, ttl_ms, channels: tick(seq as f64), ..CommandFrame::default() }
}

fn active(seq: i64) -> CommandFrame {
    command(seq, Mode::Active, 200.0)
}

/// A command whose ticks are marked 0, 1, 2, …
fn replayed(steps: usize, dt_ms: Option<f64>, ttl_ms: f64) -> CommandFrame {
    CommandFrame {
        channels: tick(0.0),
        horizon: (1..=steps).map(|step| tick(step as f64)).collect(),
        horizon_dt_ms: dt_ms,
        ..command(1, Mode::Active, ttl_ms)
    }
}

/// The mark of what the plant actuates.
fn mark(buffer: &mut ActionBuffer, now_s: f64) -> Option<f64> {
    buffer.active(now_s).map(|channels| channels["velocity_setpoint"].data[0])
}

fn buffer_with(command: CommandFrame, received_s: f64) -> ActionBuffer {
    let mut buffer = ActionBuffer::new();
    buffer.on_command(command, received_s);
    buffer
}

mod deadline {
    use super::*;

    /// Whether a watchdog holds at `now_s` that took one command at `received_s`.
    fn holds(received_s: f64, ttl_ms: f64, now_s: f64) -> bool {
        let mut watchdog = CommandWatchdog::new();
        watchdog.on_command(received_s, ttl_ms, 1);
        watchdog.should_hold(now_s)
    }

    /// [NCP-RES-001] [NCP-RES-002] [NCP-RES-003]
    #[test]
    fn a_command_exactly_as_old_as_its_ttl_is_followed_and_one_ulp_older_is_not() {
        // All of these are exact in doubles: the age in ms is the ttl to the bit.
        for (received_s, ttl_ms, now_s) in [(10.0, 250.0, 10.25), (0.0, 500.0, 0.5), (-1.0, 1_000.0, 0.0)] {
            assert!(!holds(received_s, ttl_ms, now_s));
            assert!(holds(received_s, ttl_ms.next_down(), now_s));
        }
        assert!(holds(10.0, 250.0, 10.25_f64.next_up()));
        assert!(holds(10.0_f64.next_down(), 250.0, 10.25));
        assert!(!holds(10.0, 250.0, 10.0), "an age of 0 is within any ttl");
    }

    /// [NCP-RES-004] L02
    #[test]
    fn no_ttl_lasts_longer_than_sixty_seconds() {
        for ttl_ms in [60_000.0, 60_000.0_f64.next_up(), 1e9, f64::MAX] {
            assert!(!holds(0.0, ttl_ms, 60.0), "{ttl_ms}");
            assert!(holds(0.0, ttl_ms, 60.0_f64.next_up()), "{ttl_ms}");
        }
        assert!(holds(0.0, 60_000.0_f64.next_down(), 60.0));
        // What the wire said is not changed by what is enforced.
        let mut buffer = buffer_with(command(1, Mode::Active, 1e9), 0.0);
        assert_eq!(mark(&mut buffer, 60.0), Some(1.0));
        assert_eq!(mark(&mut buffer, 60.001), None);
    }

    /// [NCP-RES-005] L12 L13
    #[test]
    fn a_ttl_that_is_no_time_holds_at_once() {
        for ttl_ms in [0.0, -0.0, -TINY, -200.0, f64::MIN, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(holds(10.0, ttl_ms, 10.0), "{ttl_ms}");
            assert_eq!(mark(&mut buffer_with(command(1, Mode::Active, ttl_ms), 0.0), 0.0), None, "{ttl_ms}");
        }
        assert!(!holds(10.0, TINY, 10.0));
        assert!(holds(10.0, TINY, 10.0_f64.next_up()));
    }

    /// [NCP-RES-006]
    #[test]
    fn a_plant_holds_before_the_first_command() {
        assert!(CommandWatchdog::new().should_hold(0.0));
        assert!(CommandWatchdog::default().should_hold(-1e9));
        assert_eq!(ActionBuffer::new().active(0.0), None);
    }

    /// [NCP-RES-007]
    #[test]
    fn a_clock_that_reads_no_number_holds() {
        for bad in NOT_FINITE {
            assert!(holds(10.0, 200.0, bad), "now {bad}");
            assert!(holds(bad, 200.0, 10.0), "received {bad}");
            assert!(holds(bad, 200.0, bad), "both {bad}");
        }
        assert!(holds(f64::MIN, f64::MAX, f64::MAX), "an age beyond every double");
    }

    /// [NCP-RES-008] L14
    #[test]
    fn a_clock_that_stepped_back_holds() {
        assert!(holds(10.0, 200.0, 10.0_f64.next_down()));
        assert!(holds(1e9, 60_000.0, -1e9));
        assert!(!holds(0.0, 200.0, -0.0), "−0 is not less than 0");
    }

    /// [NCP-RES-009]
    #[test]
    fn only_a_command_that_advances_refreshes_the_deadline() {
        let mut watchdog = CommandWatchdog::new();
        assert!(watchdog.on_command(0.0, 200.0, 5));
        for stale in [5, 4, 0, -1, i64::MIN] {
            assert!(!watchdog.on_command(0.15, 60_000.0, stale), "{stale}");
        }
        assert!(!watchdog.should_hold(0.2));
        assert!(watchdog.should_hold(0.25));
        assert!(watchdog.on_command(0.25, 200.0, 6));
        assert!(!watchdog.should_hold(0.25));
        assert_eq!(watchdog.last_seq(), Some(6));
    }

    /// [NCP-RES-009] L08 L09: at the ends of the integers nothing wraps.
    #[test]
    fn seqs_are_compared_without_an_overflow() {
        let mut watchdog = CommandWatchdog::new();
        for (seq, advances) in
            [(i64::MIN, true), (i64::MIN, false), (-1, true), (0, true), (i64::MAX, true), (i64::MIN, false)]
        {
            assert_eq!(watchdog.on_command(0.0, 200.0, seq), advances, "{seq}");
        }
    }

    /// [NCP-RES-009] A command whose ttl is no time advances for all that: it was the sender's last word.
    #[test]
    fn a_command_that_cannot_be_followed_supersedes_the_one_before() {
        let mut buffer = buffer_with(active(1), 0.0);
        assert_eq!(buffer.on_command(command(2, Mode::Active, f64::NAN), 0.01), Received::Accepted);
        assert_eq!(mark(&mut buffer, 0.01), None);
        assert_eq!(buffer.on_command(active(2), 0.02), Received::Dropped);
        assert_eq!(mark(&mut buffer, 0.02), None);
    }

    /// [NCP-RES-010]
    #[test]
    fn a_hold_persists_when_the_clock_reads_an_earlier_time_again() {
        let mut watchdog = CommandWatchdog::new();
        for (seq, cause) in [(1, 11.0), (2, 9.0), (3, f64::NAN)] {
            watchdog.on_command(10.0, 200.0, seq);
            assert!(!watchdog.should_hold(10.1));
            assert!(watchdog.should_hold(cause), "{cause}");
            assert!(watchdog.should_hold(10.1), "{cause}");
            assert!(!watchdog.on_command(10.1, 200.0, seq), "a duplicate revives nothing");
            assert!(watchdog.should_hold(10.1), "{cause}");
        }
    }

    /// [NCP-RES-020] [NCP-RES-023] A stamped HOLD advances the stream; one without a stamp comes from nowhere in it.
    #[test]
    fn a_hold_without_a_stamp_leaves_the_place_in_a_stream_of_negative_seqs() {
        let mut watchdog = CommandWatchdog::new();
        assert!(watchdog.on_command(0.0, 200.0, -5));
        assert!(watchdog.on_hold(0));
        assert!(watchdog.should_hold(0.0));
        assert!(watchdog.on_command(0.1, 200.0, -3));
        assert!(!watchdog.should_hold(0.1));
        assert!(watchdog.on_hold(-2));
        assert!(!watchdog.on_command(0.2, 200.0, -2));
    }

    /// [NCP-RES-011] [NCP-RES-012]
    #[test]
    fn a_reset_watchdog_holds_until_a_command_of_any_seq() {
        for next in [i64::MIN, -1, 0, 1, 9] {
            let mut watchdog = CommandWatchdog::new();
            watchdog.on_command(0.0, 200.0, 9);
            watchdog.reset();
            assert!(watchdog.should_hold(0.0));
            assert_eq!(watchdog.last_seq(), None);
            assert!(watchdog.on_command(0.0, 200.0, next), "{next}");
            assert!(!watchdog.should_hold(0.0));
        }
    }
}

mod buffer {
    use super::*;

    /// [NCP-RES-020] [NCP-RES-009]
    #[test]
    fn a_stale_a_duplicate_and_a_reordered_command_change_nothing() {
        let mut buffer = buffer_with(active(5), 0.0);
        for seq in [5, 4, 0, -1] {
            assert_eq!(buffer.on_command(active(seq), 0.1), Received::Dropped, "{seq}");
            assert_eq!(mark(&mut buffer, 0.1), Some(5.0));
        }
        assert_eq!(mark(&mut buffer, 0.25), None, "the deadline is that of seq 5");
        assert_eq!(buffer.on_command(active(7), 0.3), Received::Accepted);
        assert_eq!(buffer.on_command(active(6), 0.3), Received::Dropped);
        assert_eq!(mark(&mut buffer, 0.3), Some(7.0));
    }

    /// [NCP-RES-021] [NCP-RES-025]
    #[test]
    fn an_estop_latches_whatever_its_seq() {
        for seq in [i64::MIN, -1, 0, 4, 5, 6, i64::MAX] {
            let mut buffer = buffer_with(active(5), 0.0);
            assert_eq!(buffer.on_command(command(seq, Mode::Estop, f64::NAN), 0.1), Received::Stopped);
            assert!(buffer.is_stopped());
            assert_eq!(mark(&mut buffer, 0.1), None);
            for (mode, next) in [(Mode::Active, 8), (Mode::Hold, 9), (Mode::Init, 10), (Mode::Active, 11)] {
                buffer.on_command(command(next, mode, 200.0), 0.1);
                assert_eq!(mark(&mut buffer, 0.1), None, "{mode:?}");
            }
        }
    }

    /// [NCP-RES-022]
    #[test]
    fn an_estop_is_recognised_in_a_frame_that_no_receiver_would_accept() {
        for frame in [
            r#"{"kind":"command_frame","mode":"estop"}"#,
            r#"{"mode":"estop","kind":"command_frame"}"#,
            r#" { "kind" : "command_frame" , "mode" : "estop" } "#,
            r#"{"kind":"command_frame","mode":"estop","seq":"seven"}"#,
            r#"{"kind":"command_frame","mode":"estop","seq":1e999}"#,
            r#"{"kind":"command_frame","mode":"estop","channels":{"v":{"data":[NaN]}}}"#,
            r#"{"kind":"command_frame","mode":"active","mode":"estop"}"#,
            r#"{"kind":"command_frame","mode":"estop","mode":"active"}"#,
            r#"{"kind":"command_frame","mode":null,"mode":"estop","mode":7}"#,
            r#"{"kind":"sensor_frame","kind":"command_frame","mode":"estop"}"#,
            r#"{"channels":{"mode":"active","x":[{"a":["]","}"]}]},"kind":"command_frame","mode":"estop"}"#,
            r#"{"\u006bind":"command\u005fframe","m\u006Fde":"\u0065stop"}"#,
            r#"{"note":"a \"quoted\" } mode","kind":"command_frame","mode":"estop"}"#,
            r#"{"kind":"command_frame","mode":"estop","ncp_version":"9.9"}"#,
        ] {
            assert!(is_estop(frame.as_bytes()), "{frame}");
            let mut buffer = buffer_with(active(5), 0.0);
            assert_eq!(buffer.on_frame(frame.as_bytes(), 0.1).ok(), Some(Received::Stopped), "{frame}");
            assert!(buffer.is_stopped() && mark(&mut buffer, 0.1).is_none(), "{frame}");
        }
        let mut not_utf8 = br#"{"frame_id":"?","kind":"command_frame","mode":"estop"}"#.to_vec();
        not_utf8[13] = 0xff;
        assert_eq!(ActionBuffer::new().on_frame(&not_utf8, 0.0).ok(), Some(Received::Stopped));
        let deep =
            format!(r#"{{"x":{}{},"kind":"command_frame","mode":"estop"}}"#, "[".repeat(9_999), "]".repeat(9_999));
        assert_eq!(ActionBuffer::new().on_frame(deep.as_bytes(), 0.0).ok(), Some(Received::Stopped));
        let long = format!(r#"{{"x":"{}","kind":"command_frame","mode":"estop"}}"#, "a".repeat(2 << 20));
        assert_eq!(ActionBuffer::new().on_frame(long.as_bytes(), 0.0).ok(), Some(Received::Stopped));
    }

    /// [NCP-RES-022] What only looks like one does not stop a plant.
    #[test]
    fn a_frame_that_merely_mentions_estop_is_not_one() {
        for frame in [
            "",
            "estop",
            "[]",
            r#"["kind","command_frame","mode","estop"]"#,
            r#"[{"kind":"command_frame","mode":"estop"}]"#,
            r#"{"kind":"sensor_frame","mode":"estop"}"#,
            r#"{"kind":"control_status","mode":"estop"}"#,
            r#"{"mode":"estop"}"#,
            r#"{"kind":"command_frame","mode":"ESTOP"}"#,
            r#"{"kind":"command_frame","mode":"estop "}"#,
            r#"{"kind":"command_frame","mode":["estop"]}"#,
            r#"{"kind":"command_frame","channels":{"mode":"estop"}}"#,
            r#"{"kind":"command_frame","x":{"kind":"command_frame","mode":"estop"}}"#,
            r#"{"kind":"command_frame","note":"\"mode\":\"estop\""}"#,
        ] {
            assert!(!is_estop(frame.as_bytes()), "{frame}");
            let mut buffer = buffer_with(active(5), 0.0);
            let _ = buffer.on_frame(frame.as_bytes(), 0.1);
            assert!(!buffer.is_stopped(), "{frame}");
        }
    }

    /// [NCP-RES-020] A frame that is broken costs nothing but itself.
    #[test]
    fn a_frame_that_cannot_be_decoded_leaves_the_plant_as_it_is() {
        let mut buffer = buffer_with(active(5), 0.0);
        assert!(buffer.on_frame(br#"{"kind":"command_frame","seq":6,"seq":6}"#, 0.1).is_err());
        assert_eq!(mark(&mut buffer, 0.1), Some(5.0));
        let next = active(6).encode().unwrap();
        assert_eq!(buffer.on_frame(next.as_bytes(), 0.1).unwrap(), Received::Accepted);
        assert_eq!(mark(&mut buffer, 0.1), Some(6.0));
    }

    /// [NCP-SAFE-001] [NCP-RES-023] [NCP-RES-025]
    #[test]
    fn a_hold_takes_effect_unless_its_seq_is_older() {
        for mode in [Mode::Hold, Mode::Init] {
            for (seq, held) in [(6, true), (5, true), (0, true), (4, false), (1, false), (-1, false)] {
                let mut buffer = buffer_with(active(5), 0.0);
                let became = if held { Received::Held } else { Received::Dropped };
                assert_eq!(buffer.on_command(command(seq, mode, 200.0), 0.1), became, "{mode:?} {seq}");
                assert_eq!(mark(&mut buffer, 0.1), (!held).then_some(5.0), "{mode:?} {seq}");
            }
        }
    }

    /// [NCP-RES-024] [NCP-RES-010] [NCP-RES-020]
    #[test]
    fn a_hold_refreshes_nothing_and_ends_with_the_next_command_that_advances() {
        let mut buffer = buffer_with(active(5), 0.0);
        buffer.on_command(command(8, Mode::Hold, 60_000.0), 0.1);
        assert_eq!(mark(&mut buffer, 0.1), None);
        assert_eq!(buffer.on_command(active(7), 0.1), Received::Dropped, "it was sent before the hold");
        assert_eq!(buffer.on_command(active(8), 0.1), Received::Dropped, "so was this, or with it");
        assert_eq!(mark(&mut buffer, 0.1), None);
        assert_eq!(buffer.on_command(active(9), 0.1), Received::Accepted);
        assert_eq!(mark(&mut buffer, 0.1), Some(9.0));

        // One that is dropped refreshes nothing either.
        buffer.on_command(command(3, Mode::Hold, 60_000.0), 0.2);
        assert_eq!(mark(&mut buffer, 0.31), None);
    }

    /// [NCP-SAFE-001] Off the wire, a mode that is unknown or absent is a HOLD.
    #[test]
    fn a_frame_whose_mode_is_unknown_or_absent_holds_the_plant() {
        for frame in [r#"{"kind":"command_frame","seq":6}"#, r#"{"kind":"command_frame","seq":6,"mode":"dance"}"#] {
            let mut buffer = buffer_with(active(5), 0.0);
            assert_eq!(buffer.on_frame(frame.as_bytes(), 0.1).unwrap(), Received::Held, "{frame}");
            assert_eq!(mark(&mut buffer, 0.1), None);
        }
    }

    /// [NCP-RES-030] [NCP-RES-031]
    #[test]
    fn a_reset_revives_nothing_and_lets_the_next_command_move_the_plant() {
        for stop in [Mode::Estop, Mode::Hold] {
            let mut buffer = buffer_with(active(5), 0.0);
            buffer.on_command(command(6, stop, 200.0), 0.01);
            // Accepted while stopped: that is not the new command either.
            buffer.on_command(active(7), 0.02);
            buffer.reset();
            assert!(!buffer.is_stopped());
            for now_s in [0.0, 0.02, 0.1] {
                assert_eq!(mark(&mut buffer, now_s), None);
            }
            assert_eq!(buffer.on_command(active(1), 0.1), Received::Accepted);
            assert_eq!(mark(&mut buffer, 0.1), Some(1.0));
        }
    }

    /// [NCP-RES-032]
    #[test]
    fn a_sender_whose_seq_begins_again_is_held_until_a_reset() {
        let mut buffer = buffer_with(active(1_000), 0.0);
        for seq in 1..=20 {
            assert_eq!(buffer.on_command(active(seq), 0.05 * seq as f64), Received::Dropped);
        }
        assert_eq!(mark(&mut buffer, 1.0), None);
        buffer.reset();
        assert_eq!(buffer.on_command(active(21), 1.05), Received::Accepted);
        assert_eq!(mark(&mut buffer, 1.05), Some(21.0));
    }
}

mod horizon {
    use super::*;

    /// [NCP-RES-026]
    #[test]
    fn without_a_horizon_tick_0_is_followed_until_the_ttl_ends() {
        for dt_ms in [None, Some(50.0), Some(f64::NAN)] {
            let mut buffer = buffer_with(replayed(0, dt_ms, 250.0), 10.0);
            assert_eq!(mark(&mut buffer, 10.0), Some(0.0));
            assert_eq!(mark(&mut buffer, 10.25), Some(0.0));
            assert_eq!(mark(&mut buffer, 10.26), None);
        }
    }

    /// [NCP-RES-027]
    #[test]
    fn a_horizon_without_a_tick_length_is_not_replayed() {
        for dt_ms in [None, Some(0.0), Some(-0.0), Some(-50.0), Some(f64::NAN), Some(f64::INFINITY)] {
            let mut buffer = buffer_with(replayed(3, dt_ms, 250.0), 0.0);
            assert_eq!(mark(&mut buffer, 0.0), Some(0.0), "{dt_ms:?}");
            assert_eq!(mark(&mut buffer, 0.25), Some(0.0), "{dt_ms:?}");
        }
    }

    /// [NCP-RES-028] [NCP-RES-029]
    #[test]
    fn a_tick_begins_exactly_at_its_boundary_and_the_last_one_ends_at_its_own() {
        // 125 ms and its multiples are exact in doubles, as seconds and as ms.
        let mut buffer = buffer_with(replayed(2, Some(125.0), 9_000.0), 4.0);
        for (now_s, tick) in [
            (4.0, Some(0.0)),
            (4.125_f64.next_down(), Some(0.0)),
            (4.125, Some(1.0)),
            (4.25_f64.next_down(), Some(1.0)),
            (4.25, Some(2.0)),
            (4.375_f64.next_down(), Some(2.0)),
            (4.375, None),
        ] {
            assert_eq!(mark(&mut buffer, now_s), tick, "{now_s}");
        }
    }

    /// [NCP-RES-029] [NCP-RES-010]
    #[test]
    fn a_horizon_that_was_played_to_its_end_is_not_played_again() {
        let mut buffer = buffer_with(replayed(2, Some(125.0), 9_000.0), 4.0);
        assert_eq!(mark(&mut buffer, 4.5), None);
        assert_eq!(mark(&mut buffer, 4.0), None);
        assert_eq!(mark(&mut buffer, 4.2), None);
    }

    /// [NCP-RES-025] [NCP-RES-002] The ttl ends a replay wherever it stands.
    #[test]
    fn a_replay_ends_with_the_ttl_in_the_middle_of_a_tick() {
        let mut buffer = buffer_with(replayed(9, Some(125.0), 312.5), 0.0);
        assert_eq!(mark(&mut buffer, 0.3125), Some(2.0));
        assert_eq!(mark(&mut buffer, 0.3125_f64.next_up()), None);
        let mut eternal = buffer_with(replayed(4_096, Some(1_000.0), 1e12), 0.0);
        assert_eq!(mark(&mut eternal, 60.0), Some(60.0));
        assert_eq!(mark(&mut eternal, 60.001), None);
    }

    /// [NCP-RES-028] [NCP-RES-029]
    #[test]
    fn ticks_of_any_length_find_their_setpoint() {
        let mut brief = buffer_with(replayed(2, Some(TINY), 200.0), 0.0);
        assert_eq!(mark(&mut brief, 0.0), Some(0.0), "0 of any tick has passed");
        assert_eq!(mark(&mut brief, 1e-300), None, "so many ticks have no setpoint");
        let mut long = buffer_with(replayed(2, Some(f64::MAX), 200.0), 0.0);
        assert_eq!(mark(&mut long, 0.2), Some(0.0));
    }

    /// [NCP-RES-020] [NCP-RES-028] A new command's ticks count from its own arrival.
    #[test]
    fn a_new_command_begins_its_own_horizon() {
        let mut buffer = buffer_with(replayed(3, Some(125.0), 9_000.0), 0.0);
        assert_eq!(mark(&mut buffer, 0.25), Some(2.0));
        let next = CommandFrame { seq: 2, ..replayed(3, Some(125.0), 9_000.0) };
        buffer.on_command(next, 0.25);
        assert_eq!(mark(&mut buffer, 0.25), Some(0.0));
        assert_eq!(mark(&mut buffer, 0.375), Some(1.0));
    }

    /// [NCP-RES-033] [NCP-RES-034] L27
    #[test]
    fn the_longest_horizon_is_the_ttl_in_whole_ticks() {
        for (ttl_ms, dt_ms, ticks) in [
            (200.0, 50.0, 4),
            (200.0_f64.next_down(), 50.0, 3),
            (49.9, 50.0, 0),
            (50.0, 50.0, 1),
            (200.0, TINY, MAX_ITEMS),
            (f64::MAX, 1.0, MAX_ITEMS),
            (4_095.0, 1.0, 4_095),
            (4_097.0, 1.0, MAX_ITEMS),
            (TINY, f64::MAX, 0),
        ] {
            assert_eq!(max_horizon_len(ttl_ms, dt_ms), ticks, "{ttl_ms} / {dt_ms}");
        }
        for bad in [0.0, -0.0, -1.0, -TINY, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(max_horizon_len(bad, 50.0), 0, "a ttl of {bad}");
            assert_eq!(max_horizon_len(200.0, bad), 0, "a tick of {bad}");
            assert_eq!(max_horizon_len(bad, bad), 0, "both {bad}");
        }
    }
}

mod link {
    use super::*;

    fn after(seqs: impl IntoIterator<Item = i64>) -> LinkMonitor {
        let mut monitor = LinkMonitor::default();
        for seq in seqs {
            monitor.on_frame(seq);
        }
        monitor
    }

    fn counts(monitor: &LinkMonitor) -> (i64, i64, i64) {
        let LinkReport { last_seq, received, lost, .. } = monitor.report();
        (last_seq, received, lost)
    }

    /// [NCP-RES-044]
    #[test]
    fn before_the_first_frame_nothing_is_known_and_nothing_lost() {
        let nothing = LinkReport { last_seq: -1, received: 0, lost: 0, loss_rate: 0.0, burst: false };
        assert_eq!(LinkMonitor::default().report(), nothing);
    }

    /// [NCP-RES-040] [NCP-RES-044]
    #[test]
    fn every_seq_of_a_gap_is_lost() {
        let monitor = after([100, 101, 105]);
        assert_eq!(counts(&monitor), (105, 3, 3));
        assert_eq!(monitor.report().loss_rate, 3.0 / 6.0);
        // What came before the first frame is none of its business.
        assert_eq!(counts(&after([100])), (100, 1, 0));
    }

    /// [NCP-RES-041] [NCP-RES-042] [NCP-RES-043]
    #[test]
    fn a_late_frame_is_taken_back_once_and_a_duplicate_changes_nothing() {
        let mut monitor = after([10, 14]);
        assert_eq!(counts(&monitor), (14, 2, 3));
        monitor.on_frame(12);
        assert_eq!(counts(&monitor), (14, 3, 2));
        for duplicate in [12, 14, 10, 9, i64::MIN] {
            let before = monitor.clone();
            monitor.on_frame(duplicate);
            assert_eq!(monitor.report(), before.report(), "{duplicate}");
        }
        monitor.on_frame(13);
        monitor.on_frame(11);
        assert_eq!(counts(&monitor), (14, 5, 0));
        assert_eq!(monitor.report().loss_rate, 0.0);
    }

    /// [NCP-RES-046] With the defaults a gap of 5 lifts S to 4.75, one of 6 to 5.7, of which the
    /// frame that ends the gap takes 0.05 off.
    #[test]
    fn a_burst_begins_above_the_threshold() {
        let gap = |missing: i64| after([0, missing + 1]).burst();
        assert!(!gap(5));
        assert!(gap(6));
        // In quarters every sum is exact.
        let mut exact = LinkMonitor::new(0.25, 3.0);
        exact.on_frame(0);
        exact.on_frame(5);
        assert!(!exact.burst(), "S is 2.75");
        exact.on_frame(7);
        assert!(exact.burst(), "S is 3.25");
        exact.on_frame(8);
        assert!(!exact.burst(), "S is 3, exactly the threshold");
    }

    /// [NCP-RES-046] A late frame is a delivery too.
    #[test]
    fn late_frames_bring_a_burst_to_its_end() {
        let mut monitor = LinkMonitor::new(0.25, 3.0);
        for seq in [0, 5, 7] {
            monitor.on_frame(seq);
        }
        assert!(monitor.burst());
        monitor.on_frame(3);
        assert!(!monitor.burst());
    }

    /// [NCP-RES-047] [NCP-RES-049] S is at most 10, and every delivery takes 0.05 off: within 101 good
    /// frames it is at the threshold, however long the outage was.
    #[test]
    fn a_healthy_link_ends_a_burst_in_bounded_time() {
        for outage in [100, 300, 1_000_000, i64::MAX / 2] {
            let mut monitor = after([0, outage]);
            let good = (1..).take_while(|step| {
                monitor.on_frame(outage + step);
                monitor.burst()
            });
            assert!((95..=101).contains(&good.count()), "after {outage}");
        }
    }

    /// [NCP-RES-047] With a threshold out of reach, a gap of any length lifts S by 256 updates.
    #[test]
    fn a_gap_makes_256_updates_at_most() {
        let lifted_above = |gap: i64, threshold: f64| {
            let mut monitor = LinkMonitor::new(0.0, threshold);
            monitor.on_frame(0);
            monitor.on_frame(gap + 1);
            monitor.burst()
        };
        assert!(lifted_above(256, 255.5));
        assert!(!lifted_above(255, 255.5));
        for gap in [257, 10_000, i64::MAX - 1] {
            assert!(lifted_above(gap, 255.5), "{gap}");
            assert!(!lifted_above(gap, 256.0), "{gap}");
        }
    }

    /// [NCP-RES-048]
    #[test]
    fn of_a_long_gap_the_newest_4096_seqs_are_remembered() {
        let mut monitor = after([0, 5_001]);
        assert_eq!(counts(&monitor), (5_001, 2, 5_000));
        for seq in 1..=5_000 {
            monitor.on_frame(seq);
        }
        assert_eq!(counts(&monitor), (5_001, 2 + 4_096, 5_000 - 4_096));
        // Two gaps share the room.
        let mut monitor = after([0, 4_001, 8_002]);
        for seq in 1..8_002 {
            monitor.on_frame(seq);
        }
        assert_eq!(counts(&monitor), (8_002, 3 + 4_096, 8_000 - 4_096));
    }

    /// [NCP-RES-045] [NCP-RES-050] L09
    #[test]
    fn a_gap_between_any_two_seqs_neither_overflows_nor_hides_the_burst() {
        for seqs in [[i64::MIN, i64::MAX], [-1, i64::MAX], [i64::MIN, 0], [i64::MIN, 1_000]] {
            let monitor = after(seqs);
            let report = monitor.report();
            assert!(report.burst, "{seqs:?}");
            assert!((0.999..=1.0).contains(&report.loss_rate), "{seqs:?}: {}", report.loss_rate);
            assert!(report.lost > 0 && report.received == 2, "{seqs:?}");
            assert_eq!(report.last_seq, seqs[1]);
        }
        assert_eq!(after([i64::MIN, i64::MAX]).report().lost, i64::MAX, "it saturates");
        assert_eq!(counts(&after([-2, -1, 0, 1])), (1, 4, 0), "a sign is no gap");
    }

    /// [NCP-RES-051] A reference of 1 would call no loss a burst; above 0.99 it is 0.99.
    #[test]
    fn a_reference_loss_is_brought_within_its_range() {
        // 256 losses lift S by 256 · (1 − ref).
        let lifted_above = |reference: f64, threshold: f64| {
            let mut monitor = LinkMonitor::new(reference, threshold);
            monitor.on_frame(0);
            monitor.on_frame(257);
            monitor.burst()
        };
        for high in [0.99, 1.0, 7.0, f64::MAX] {
            assert!(lifted_above(high, 1.5), "{high}: 2.56 less 0.99");
            assert!(!lifted_above(high, 1.6), "{high}");
        }
        for low in [0.0, -0.0, -TINY, -3.0, f64::MIN] {
            assert!(lifted_above(low, 255.9), "{low}");
        }
        for bad in NOT_FINITE {
            assert!(lifted_above(bad, 243.1), "{bad}: 256 · 0.95 − 0.05 is 243.15");
            assert!(!lifted_above(bad, 243.2), "{bad}");
        }
    }

    /// [NCP-RES-052]
    #[test]
    fn a_threshold_that_is_none_is_five() {
        for bad in [0.0, -0.0, -5.0, -TINY, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let burst = |missing: i64| {
                let mut monitor = LinkMonitor::new(0.05, bad);
                monitor.on_frame(0);
                monitor.on_frame(missing + 1);
                monitor.burst()
            };
            assert!(!burst(5) && burst(6), "{bad}");
        }
        let mut eager = LinkMonitor::new(0.05, TINY);
        eager.on_frame(0);
        assert!(!eager.burst(), "S is 0, not above any threshold");
        eager.on_frame(2);
        eager.on_frame(3);
        assert!(!eager.burst(), "S is at most twice the threshold, and a good frame takes that off");
    }
}
