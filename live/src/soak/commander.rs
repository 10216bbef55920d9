//! What a commander may send, by the sensor frames that reached it; judged from outside. Times are seconds since the
//! link came up.

use std::collections::VecDeque;

use ncp_spec::wire::{CommandFrame, Frame, Mode, SensorFrame};

use super::body::Seen;

/// How many sensor frames are remembered.
const REMEMBERED: usize = 4_096;

/// So many frames in a row that are missing are a burst to every monitor with the text's defaults.
const BURST: i64 = 20;

/// After how much silence of its sensor the commander holds, in s.
const STALE_S: f64 = 0.3;

/// What is known of a commander.
#[derive(Debug, Default)]
pub(super) struct Commander {
    stamps: VecDeque<i64>,
    newest: Option<(f64, i64)>,
    last: Option<(f64, i64, f64)>,
    burst_s: Option<f64>,
}

impl Commander {
    /// A sensor frame went on to it, as it was.
    pub(super) fn told(&mut self, at_s: f64, frame: &[u8]) {
        let Ok(frame) = SensorFrame::decode(frame) else { return };
        if self.stamps.len() == REMEMBERED {
            self.stamps.pop_front();
        }
        self.stamps.push_back(frame.seq);
        match self.newest {
            Some((_, newest)) if frame.seq <= newest => return,
            Some((_, newest)) if frame.seq > newest + BURST => {
                self.burst_s.get_or_insert(at_s);
            }
            _ => {}
        }
        self.newest = Some((at_s, frame.seq));
    }

    /// A supervisor has reset it: what it does of a burst that is not over yet, is left open.
    pub(super) fn reset(&mut self) {
        self.burst_s = None;
    }

    /// It sent a command. What deviates by less than `slack_s` says nothing.
    pub(super) fn sent(&mut self, at_s: f64, frame: &[u8], slack_s: f64) -> Vec<Seen> {
        let Ok(CommandFrame { seq, t, mode, .. }) = CommandFrame::decode(frame) else { return Vec::new() };
        let mut seen = Vec::new();
        if let Some((before_s, before, before_t)) = self.last {
            seen.push(Seen::new("NCP-CTRL-020", t >= before_t, || format!("at {at_s:.3} s t goes back to {t}")));
            let why = || format!("at {at_s:.3} s a command of sensor frame {seq} comes after one of {before}");
            seen.push(Seen::new("NCP-CTRL-011", seq >= before, why));
            let why = || format!("no command for {:.1} s, until {at_s:.3} s", at_s - before_s);
            seen.push(Seen::new("NCP-TRANS-009", at_s - before_s <= 1.0 + slack_s, why));
        }
        self.last = Some((at_s, seq, t));
        if seq != 0 {
            let is_so = self.stamps.contains(&seq);
            let why = || format!("at {at_s:.3} s a command has the seq {seq} of no sensor frame that arrived");
            seen.push(Seen::new("NCP-PLANE-006", is_so, why));
        }
        if let Some((told_s, _)) = self.newest.filter(|(told_s, _)| at_s - told_s > STALE_S + slack_s) {
            let why = || format!("an active command at {at_s:.3} s, and the newest sensor frame came at {told_s:.3} s");
            seen.push(Seen::new("NCP-SAFE-033", mode != Mode::Active, why));
        }
        if let Some(burst_s) = self.burst_s.filter(|burst_s| at_s - burst_s > slack_s) {
            let why = || format!("at {at_s:.3} s a command in mode {mode:?}, and a burst was seen at {burst_s:.3} s");
            seen.push(Seen::new("NCP-SAFE-006", mode == Mode::Estop, why));
        }
        seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sensor(seq: i64) -> String {
        SensorFrame { seq, ..SensorFrame::default() }.encode().unwrap()
    }

    fn command(seq: i64, mode: Mode) -> String {
        CommandFrame { seq, mode, ..CommandFrame::default() }.encode().unwrap()
    }

    fn broken(commander: &mut Commander, at_s: f64, seq: i64, mode: Mode) -> Vec<&'static str> {
        let seen = commander.sent(at_s, command(seq, mode).as_bytes(), 0.1);
        seen.into_iter().filter(|seen| !seen.is_so).map(|seen| seen.rule).collect()
    }

    #[test]
    fn a_command_has_the_stamp_of_a_frame_that_arrived_and_never_an_older_one() {
        let mut commander = Commander::default();
        for seq in [3, 4, 6] {
            commander.told(1.0, sensor(seq).as_bytes());
        }
        assert_eq!(broken(&mut commander, 1.0, 4, Mode::Active), [""; 0]);
        assert_eq!(broken(&mut commander, 1.02, 5, Mode::Active), ["NCP-PLANE-006"]);
        assert_eq!(broken(&mut commander, 1.04, 3, Mode::Active), ["NCP-CTRL-011"]);
    }

    #[test]
    fn a_stale_sensor_and_a_burst_stop_the_commands() {
        let mut commander = Commander::default();
        commander.told(1.0, sensor(1).as_bytes());
        assert_eq!(broken(&mut commander, 1.5, 1, Mode::Active), ["NCP-SAFE-033"]);
        assert_eq!(broken(&mut commander, 1.6, 1, Mode::Hold), [""; 0]);
        commander.told(1.6, sensor(60).as_bytes());
        assert_eq!(broken(&mut commander, 1.65, 60, Mode::Active), [""; 0]);
        assert_eq!(broken(&mut commander, 1.75, 60, Mode::Hold), ["NCP-SAFE-006"]);
        assert_eq!(broken(&mut commander, 1.76, 60, Mode::Estop), [""; 0]);
        commander.reset();
        assert_eq!(broken(&mut commander, 1.8, 60, Mode::Active), [""; 0]);
    }
}
