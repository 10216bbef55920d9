//! What a plant may do, by the commands that reached it: the liveness rule of chapter 8.1 and the rules around it,
//! judged from outside.
//!
//! It is written from the text, and shares nothing with the buffer of `ncp-spec` but how a frame is decoded. Times are
//! seconds since the link came up.

use ncp_spec::resilience::is_estop;
use ncp_spec::wire::{CommandFrame, Frame, Mode};
use serde_json::Value;

use crate::relay::decision::Damage;
use crate::target::Mapping;

/// The most that a ttl is worth, in ms. `[NCP-RES-004]`
const MOST_TTL_MS: f64 = 60_000.0;

/// How long a damaged command could move a plant that took it: the ttl of the loop's commands, in s.
const DAMAGED_S: f64 = 0.2;

/// An observation on a rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Seen {
    /// The rule.
    pub(super) rule: &'static str,
    /// Whether it is as the rule asks.
    pub(super) is_so: bool,
    /// What was seen, if it is not.
    pub(super) why: String,
}

/// What is known of a plant.
#[derive(Debug)]
pub(super) struct Body {
    mapping: Mapping,
    last_seq: Option<i64>,
    /// Until when what it was told last moves it, and by which rule no longer.
    until_s: f64,
    then: &'static str,
    latched: Option<Latch>,
    /// It may have latched, on bytes that are no JSON object.
    may_be_latched_s: Option<f64>,
    damaged: Option<(f64, &'static str)>,
    stale: Option<(f64, f64, &'static str)>,
    last_moved_s: f64,
    since_s: f64,
}

#[derive(Debug, Clone, Copy)]
struct Latch {
    since_s: f64,
    rule: &'static str,
    /// Whether the plant has been still since.
    has_held: bool,
}

impl Body {
    /// A plant that was told nothing yet.
    pub(super) fn new(mapping: Mapping) -> Self {
        Self {
            mapping,
            last_seq: None,
            until_s: f64::NEG_INFINITY,
            then: "NCP-RES-006",
            latched: None,
            may_be_latched_s: None,
            damaged: None,
            stale: None,
            last_moved_s: 0.0,
            since_s: 0.0,
        }
    }

    /// A frame reached the plant's side of the link.
    pub(super) fn told(&mut self, at_s: f64, frame: &[u8], damage: Option<Damage>) {
        if self.latched.is_some() {
            return;
        }
        match CommandFrame::decode(frame) {
            Ok(command) if command.mode == Mode::Estop => self.latch(at_s, "NCP-RES-021"),
            Ok(command) if command.mode == Mode::Active => self.active(at_s, &command),
            Ok(command) => self.hold(at_s, &command),
            Err(_) if is_stop(frame) => self.latch(at_s, "NCP-RES-022"),
            Err(_) if is_estop(frame) => self.may_be_latched_s = self.may_be_latched_s.or(Some(at_s)),
            Err(_) => self.damaged = damage.map(|damage| (at_s, rule_of(damage))),
        }
    }

    /// A supervisor has reset it.
    pub(super) fn reset(&mut self, at_s: f64) {
        let last_moved_s = self.last_moved_s;
        *self = Self { then: "NCP-RES-031", last_moved_s, since_s: at_s, ..Self::new(self.mapping.clone()) };
    }

    /// The plant says whether it moves. What deviates by less than `slack_s` says nothing.
    pub(super) fn is_seen(&mut self, at_s: f64, moves: bool, slack_s: f64) -> Option<Seen> {
        if moves {
            self.last_moved_s = at_s;
        }
        if at_s <= self.until_s + slack_s || at_s <= self.since_s + slack_s {
            return (moves && at_s <= self.until_s).then(|| Seen::good("NCP-RES-026"));
        }
        let rule = match &mut self.latched {
            Some(latch) if at_s <= latch.since_s + slack_s => return None,
            Some(latch) if latch.has_held => "NCP-RES-025",
            Some(latch) => {
                latch.has_held = !moves;
                latch.rule
            }
            None => self.told_since(at_s, slack_s).unwrap_or(self.then),
        };
        let because = format!("at {at_s:.3} s the plant moves, and it was last allowed to at {:.3} s", self.until_s);
        Some(Seen { rule, is_so: !moves, why: if moves { because } else { String::new() } })
    }

    /// Since when it is, or may be, latched.
    pub(super) fn latched_s(&self) -> Option<f64> {
        self.latched.map(|latch| latch.since_s).or(self.may_be_latched_s)
    }

    /// When it moved last.
    pub(super) const fn last_moved_s(&self) -> f64 {
        self.last_moved_s
    }

    /// What came lately that must not move it: the rule that says so.
    fn told_since(&self, at_s: f64, slack_s: f64) -> Option<&'static str> {
        let of_damaged = self.damaged.filter(|(told_s, _)| at_s <= told_s + DAMAGED_S + slack_s).map(|(_, rule)| rule);
        let of_stale = self.stale.filter(|(told_s, ttl_s, _)| at_s <= told_s + ttl_s + slack_s).map(|(.., rule)| rule);
        of_damaged.or(of_stale)
    }

    fn latch(&mut self, at_s: f64, rule: &'static str) {
        self.latched = Some(Latch { since_s: at_s, rule, has_held: false });
        self.until_s = self.until_s.min(at_s);
    }

    fn active(&mut self, at_s: f64, command: &CommandFrame) {
        let ttl_s = command.ttl_ms.min(MOST_TTL_MS) / 1e3;
        if let Some(last) = self.last_seq.filter(|last| command.seq <= *last) {
            let rule = if command.seq == last { "NCP-RES-009" } else { "NCP-RES-020" };
            self.stale = Some((at_s, ttl_s, rule));
            return;
        }
        self.last_seq = Some(command.seq);
        let setpoint = command.channels.get(&self.mapping.command);
        let moves = setpoint.is_some_and(|channel| channel.data.iter().any(|value| value.abs() > self.mapping.still));
        let until_s = self.until_s.min(at_s);
        (self.until_s, self.then) = match (ttl_s > 0.0, moves) {
            (true, true) => (at_s + ttl_s, "NCP-RES-002"),
            (true, false) => (until_s, "NCP-RES-026"),
            (false, _) => (until_s, "NCP-RES-005"),
        };
    }

    /// One that is older may be dropped or obeyed, so it says nothing.
    fn hold(&mut self, at_s: f64, command: &CommandFrame) {
        if command.seq == 0 || self.last_seq.is_none_or(|last| command.seq >= last) {
            if command.seq != 0 {
                self.last_seq = self.last_seq.max(Some(command.seq));
            }
            (self.until_s, self.then) = (self.until_s.min(at_s), "NCP-RES-023");
        }
    }
}

impl Seen {
    /// As the rule asks.
    pub(super) const fn good(rule: &'static str) -> Self {
        Self { rule, is_so: true, why: String::new() }
    }

    /// As the rule asks, or not, for a reason that is made only then.
    pub(super) fn new(rule: &'static str, is_so: bool, why: impl FnOnce() -> String) -> Self {
        Self { rule, is_so, why: if is_so { String::new() } else { why() } }
    }
}

/// Whether the bytes are what rule 22 speaks of: a JSON object, of kind `command_frame`, in mode `estop`.
fn is_stop(frame: &[u8]) -> bool {
    let Ok(Value::Object(members)) = serde_json::from_slice(frame) else { return false };
    let is = |name: &str, value: &str| members.get(name).and_then(Value::as_str) == Some(value);
    is("kind", "command_frame") && is("mode", "estop")
}

/// The rule by which a frame with such damage is rejected.
const fn rule_of(damage: Damage) -> &'static str {
    match damage {
        Damage::Short => "NCP-WIRE-002",
        Damage::Byte => "NCP-WIRE-001",
        Damage::Tail => "NCP-WIRE-004",
        Damage::Twice => "NCP-WIRE-007",
    }
}

#[cfg(test)]
mod tests {
    use ncp_spec::wire::{ChannelMap, ChannelValue};

    use super::*;

    const SLACK_S: f64 = 0.05;

    fn command(seq: i64, mode: Mode) -> String {
        let channels = ChannelMap::from_iter([("velocity_setpoint", ChannelValue::new([0.5, 0.0, 0.0], "m/s"))]);
        CommandFrame { seq, mode, ttl_ms: 200.0, channels, ..CommandFrame::default() }.encode().unwrap()
    }

    fn body(told: &[(f64, i64, Mode)]) -> Body {
        let mut body = Body::new(Mapping::default());
        for (at_s, seq, mode) in told {
            body.told(*at_s, command(*seq, *mode).as_bytes(), None);
        }
        body
    }

    /// The rule that a motion breaks.
    fn broken(body: &mut Body, at_s: f64) -> Option<&'static str> {
        body.is_seen(at_s, true, SLACK_S).filter(|seen| !seen.is_so).map(|seen| seen.rule)
    }

    #[test]
    fn a_command_moves_the_plant_for_its_ttl_and_no_longer() {
        let told = [(1.0, 1, Mode::Active)];
        assert_eq!(body(&told).is_seen(1.1, true, SLACK_S), Some(Seen::good("NCP-RES-026")));
        assert_eq!(body(&told).is_seen(1.22, true, SLACK_S), None);
        assert_eq!(broken(&mut body(&told), 1.3), Some("NCP-RES-002"));
        assert_eq!(broken(&mut body(&[]), 1.0), Some("NCP-RES-006"));
    }

    #[test]
    fn what_does_not_advance_is_blamed_for_what_it_renews() {
        let duplicate = [(1.0, 5, Mode::Active), (1.25, 5, Mode::Active)];
        assert_eq!(broken(&mut body(&duplicate), 1.4), Some("NCP-RES-009"));
        let older = [(1.0, 5, Mode::Active), (1.25, 4, Mode::Active)];
        assert_eq!(broken(&mut body(&older), 1.4), Some("NCP-RES-020"));
        assert_eq!(broken(&mut body(&older), 3.0), Some("NCP-RES-002"));
    }

    #[test]
    fn a_hold_stops_at_once_and_an_older_one_says_nothing() {
        let held = [(1.0, 5, Mode::Active), (1.02, 5, Mode::Hold)];
        assert_eq!(broken(&mut body(&held), 1.1), Some("NCP-RES-023"));
        let older = [(1.0, 5, Mode::Active), (1.02, 4, Mode::Hold)];
        assert_eq!(broken(&mut body(&older), 1.1), None);
    }

    #[test]
    fn an_estop_latches_until_a_reset_whatever_comes() {
        let told = [(1.0, 5, Mode::Active), (1.02, 1, Mode::Estop), (1.1, 6, Mode::Active)];
        let mut ignores = body(&told);
        assert_eq!(broken(&mut ignores, 1.15), Some("NCP-RES-021"));
        let mut forgets = body(&told);
        assert_eq!(forgets.is_seen(1.1, false, SLACK_S), Some(Seen::good("NCP-RES-021")));
        assert_eq!(broken(&mut forgets, 1.15), Some("NCP-RES-025"));
        forgets.reset(2.0);
        assert_eq!(broken(&mut forgets, 2.1), Some("NCP-RES-031"));
        forgets.told(2.2, command(1, Mode::Active).as_bytes(), None);
        assert_eq!(broken(&mut forgets, 2.3), None);
    }

    #[test]
    fn an_estop_with_a_member_twice_latches_and_one_that_is_cut_off_may() {
        let stop = command(9, Mode::Estop);
        let twice = stop.replacen("{\"ncp_version\"", "{\"ncp_version\":\"\",\"ncp_version\"", 1);
        let mut told = body(&[(1.0, 5, Mode::Active)]);
        told.told(1.05, twice.as_bytes(), Some(Damage::Twice));
        assert_eq!(broken(&mut told, 1.15), Some("NCP-RES-022"));
        let mut cut = body(&[(1.0, 5, Mode::Active)]);
        cut.told(1.05, &stop.as_bytes()[..stop.len() - 1], Some(Damage::Short));
        assert_eq!(broken(&mut cut, 1.15), None);
        assert_eq!(cut.latched_s(), Some(1.05));
    }

    #[test]
    fn a_damaged_frame_is_blamed_for_what_it_moves() {
        let mut told = body(&[(1.0, 5, Mode::Active)]);
        told.told(1.3, &command(6, Mode::Active).as_bytes()[..40], Some(Damage::Short));
        assert_eq!(broken(&mut told, 1.4), Some("NCP-WIRE-002"));
    }
}
