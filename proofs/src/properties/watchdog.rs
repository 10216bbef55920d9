//! The watchdog: how long a command is worth anything, and which command counts.

use super::words::{alive, enforced};
use crate::kernel::{Kernel, WatchdogState};
use crate::prover::Prover;

/// A command is alive exactly while all is finite, the ttl is positive, the clock has not gone back, and
/// its age is not above min(ttl, 60 s).
pub fn deadline<K: Kernel, P: Prover>(p: &mut P) {
    let (now, received, ttl) = (p.scalar("now"), p.scalar("received"), p.scalar("ttl"));
    let answer = K::within_deadline(now, received, ttl);
    let says = alive(p, now, received, ttl);
    p.exactly("alive exactly by the liveness rule", answer, says);
    let answer = K::is_fresh(now, received, ttl);
    let says = super::words::fresh(p, now, received, ttl);
    p.exactly("a sensor frame is fresh exactly by its age", answer, says);
}

/// The enforced ttl is min(ttl, 60 s), and none for what is no time.
pub fn ttl<K: Kernel, P: Prover>(p: &mut P) {
    let ttl = p.scalar("ttl");
    let answer = K::enforced_ttl_ms(ttl);
    let zero = p.number(0.0);
    let (finite, positive) = (p.finite(ttl), p.lt(zero, ttl));
    let says = p.and(finite, positive);
    p.exactly("none for what is no time", answer.is_some(), says);
    if let Some(answer) = answer {
        let most = p.number(60_000.0);
        let (below_ttl, below_most) = (p.le(answer, ttl), p.le(answer, most));
        let both = p.and(below_ttl, below_most);
        p.check("at most the ttl and 60 s", both);
        let says = enforced(p, ttl);
        let same = p.same(answer, says);
        p.check("exactly the least of both", same);
    }
}

/// A command advances exactly when its seq is above the last; a HOLD takes effect exactly when it is not
/// below it, or is 0.
pub fn order<K: Kernel, P: Prover>(p: &mut P) {
    let last = p.boolean("has_last").then(|| p.seq("last"));
    let seq = p.seq("seq");
    let answer = K::advances(last, seq);
    let says = super::words::advances(p, last, seq);
    p.exactly("advances", answer, says);
    let answer = K::hold_takes_effect(last, seq);
    let says = super::words::hold_takes_effect(p, last, seq);
    p.exactly("a HOLD takes effect", answer, says);
}

/// Any state of a watchdog at all, also one that it cannot reach.
pub(super) fn any_state<P: Prover>(p: &mut P) -> WatchdogState<P::S, P::Q> {
    WatchdogState {
        last_seq: p.boolean("has_last").then(|| p.seq("last")),
        deadline: p.boolean("has_deadline").then(|| (p.scalar("received"), p.scalar("ttl"))),
    }
}

/// The state in which nothing has happened yet. `[NCP-RES-006]`
pub(super) const fn empty<S, Q>() -> WatchdogState<S, Q> {
    WatchdogState { last_seq: None, deadline: None }
}

/// One event on a watchdog in any state: the answer and the whole state after it are those of the model. With the
/// first state, this is an induction over sequences of any length.
pub fn step<K: Kernel, P: Prover>(p: &mut P) {
    for start in [K::watchdog::<P::S, P::Q>(), K::watchdog_default()] {
        let is_empty = super::words::same_watchdog(p, K::watchdog_state(&start), empty());
        p.check("a new watchdog holds", is_empty);
    }
    let before = any_state(p);
    let WatchdogState { mut last_seq, mut deadline } = before;
    let mut watchdog = K::watchdog_in(before);
    match p.choice("event", 5) {
        0 => {
            let (now, ttl, seq) = (p.scalar("now"), p.scalar("new_ttl"), p.seq("seq"));
            let answer = K::watchdog_command(&mut watchdog, now, ttl, seq);
            let says = super::words::advances(p, last_seq, seq);
            p.exactly("only an advancing command refreshes", answer, says);
            if answer {
                (last_seq, deadline) = (Some(seq), Some((now, ttl)));
            }
        }
        1 => {
            let seq = p.seq("seq");
            let answer = K::watchdog_on_hold(&mut watchdog, seq);
            let says = super::words::hold_takes_effect(p, last_seq, seq);
            p.exactly("a HOLD is never ignored", answer, says);
            if answer {
                deadline = None;
                last_seq = after_hold(p, K::watchdog_state(&watchdog).last_seq, last_seq, seq);
            }
        }
        2 => {
            let now = p.scalar("now");
            let answer = K::watchdog_should_hold(&mut watchdog, now);
            let says = match deadline {
                Some((received, ttl)) => alive(p, now, received, ttl),
                None => p.truth(false),
            };
            p.exactly("moves exactly while alive", !answer, says);
            if answer {
                deadline = None;
            }
        }
        3 => {
            K::watchdog_hold(&mut watchdog);
            deadline = None;
        }
        _ => {
            K::watchdog_reset(&mut watchdog);
            (last_seq, deadline) = (None, None);
        }
    }
    same_state::<K, P>(p, &watchdog, WatchdogState { last_seq, deadline });
    if deadline.is_none() {
        let later = p.scalar("later");
        let holds = K::watchdog_should_hold(&mut watchdog, later);
        let holds = p.truth(holds);
        p.check("a hold persists, and a reset revives nothing", holds);
    }
}

/// A command: when it was received, its ttl, its seq, and whether something has held the plant since.
type Command<S, Q> = (S, S, Q, bool);

/// The liveness rule over sequences of events: whenever the plant may move, an advancing command of the
/// sequence is alive, no event has held the plant since, and nothing was reset.
pub fn sequence<K: Kernel, P: Prover>(p: &mut P) {
    let mut watchdog = K::watchdog::<P::S, P::Q>();
    let length = p.length(6);
    // The commands since the last reset, and for each whether something has held the plant since.
    let mut commands: Vec<Command<P::S, P::Q>> = Vec::new();
    let mut seqs: Vec<P::Q> = Vec::new();
    for _ in 0..length {
        match p.choice("event", 4) {
            0 => {
                let (now, ttl, seq) = (p.scalar("now"), p.scalar("ttl"), p.seq("seq"));
                K::watchdog_command(&mut watchdog, now, ttl, seq);
                commands.push((now, ttl, seq, false));
                seqs.push(seq);
            }
            1 => {
                let now = p.scalar("now");
                let holds = K::watchdog_should_hold(&mut watchdog, now);
                if holds {
                    commands.iter_mut().for_each(|command| command.3 = true);
                    continue;
                }
                let mut reason = p.truth(false);
                for (nth, &(received, ttl, seq, held)) in commands.iter().enumerate() {
                    let mut good = alive(p, now, received, ttl);
                    for &earlier in seqs.iter().take(nth) {
                        let advances = p.seq_lt(earlier, seq);
                        good = p.and(good, advances);
                    }
                    // No later command took its place.
                    for &later in seqs.iter().skip(nth + 1) {
                        let advances = p.seq_lt(seq, later);
                        let stays = p.not(advances);
                        good = p.and(good, stays);
                    }
                    let free = p.truth(!held);
                    good = p.and(good, free);
                    reason = p.or(reason, good);
                }
                p.check("moves only by an advancing command that is alive", reason);
            }
            2 => {
                K::watchdog_hold(&mut watchdog);
                commands.iter_mut().for_each(|command| command.3 = true);
            }
            _ => {
                K::watchdog_reset(&mut watchdog);
                commands.clear();
                seqs.clear();
            }
        }
    }
}

/// The last seq after a HOLD that took effect: its own where it advances and is not 0.
pub(super) fn after_hold<P: Prover>(p: &mut P, now: Option<P::Q>, last: Option<P::Q>, seq: P::Q) -> Option<P::Q> {
    let (advances, zero) = (super::words::advances(p, last, seq), p.seq_zero(seq));
    let stamped = p.not(zero);
    let moved = p.and(advances, stamped);
    let says = match (now, last) {
        (None, None) => p.not(moved),
        (Some(now), None) => {
            let same = p.seq_same(now, seq);
            p.and(same, moved)
        }
        (None, Some(_)) => p.truth(false),
        (Some(now), Some(last)) => {
            let (new, old) = (p.seq_same(now, seq), p.seq_same(now, last));
            let (new, kept) = (p.and(moved, new), {
                let unmoved = p.not(moved);
                p.and(unmoved, old)
            });
            p.or(new, kept)
        }
    };
    p.check("a stamped HOLD advances the stream", says);
    now
}

fn same_state<K: Kernel, P: Prover>(p: &mut P, watchdog: &K::Watchdog<P::S, P::Q>, says: WatchdogState<P::S, P::Q>) {
    for state in [K::watchdog_state(watchdog), K::watchdog_says(watchdog)] {
        let same = super::words::same_watchdog(p, state, says);
        p.check("the state is the model's", same);
    }
}
