//! The handshake: wire version and contract hash.
//!
//! One side is the specification, the other is a peer of any version. Requests and replies may be lost,
//! repeated and reordered, and each side may start anew as another version. What is compatible is
//! written down here from the table of chapter 2.1, and not computed.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use ncp_spec::contract::{ContractStatus, negotiate};
use ncp_spec::reply::check_reply;
use ncp_spec::session::{ReferenceBackend, SessionService};
use ncp_spec::wire::{Message, decode_any};
use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use serde_json::{Value, json};
use stateright::{Model, Property};

use crate::explore::{Claim, Protocol, Replay, Variant, case, pattern};
use crate::signs::{Signs, always, sometimes};

/// Versions, the text's own first, and whether the text calls them compatible with that.
static VERSIONS: LazyLock<[(String, bool); 7]> = LazyLock::new(|| {
    let (major, minor) = WIRE_VERSION.split_once('.').unwrap_or((WIRE_VERSION, "0"));
    [
        (WIRE_VERSION.to_owned(), true),
        (format!("0{major}.0{minor}"), true),
        (format!("{major}.4"), false),
        (format!("{WIRE_VERSION}0"), false),
        (format!("1.{minor}"), false),
        (format!("{WIRE_VERSION}.0"), false),
        (String::new(), false),
    ]
});
const HASHES: [Option<&str>; 3] = [Some(CONTRACT_HASH), Some("0000000000000000"), None];

/// An `open_session` of a client: its version and its hash.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Hello {
    version: usize,
    hash: usize,
}

/// A reply on its way: to which request, by a server of which version, and whether it said yes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Answer {
    to: Hello,
    version: usize,
    ok: bool,
}

/// What happens next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Event {
    /// A client of some version and hash starts and asks.
    Ask(Hello),
    /// A request arrives.
    Arrive(Hello),
    /// A reply arrives.
    Reply(Answer),
    /// The server starts anew, as another version.
    Restart(usize),
}

/// A client, a server and what is between them.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct State {
    client: Option<Hello>,
    /// Whether the client takes its session for open.
    opened: bool,
    asks: u8,
    server: usize,
    restarts: u8,
    /// Whose session is open at the server.
    serves: Option<Hello>,
    requests: BTreeSet<Hello>,
    replies: BTreeSet<Answer>,
    last: Signs,
}

mod sign {
    pub(super) const INCOMPATIBLE_SERVED: u16 = 1;
    pub(super) const INCOMPATIBLE_TAKEN: u16 = 1 << 1;
    pub(super) const HASH_REFUSED: u16 = 1 << 2;
    pub(super) const STATUS: u16 = 1 << 3;
    pub(super) const NO_REASON: u16 = 1 << 4;
    pub(super) const OPENED: u16 = 1 << 5;
    pub(super) const REFUSED: u16 = 1 << 6;
    pub(super) const OTHER_HASH: u16 = 1 << 7;
    pub(super) const FOREIGN_REPLY: u16 = 1 << 8;
    pub(super) const LATE_REPLY: u16 = 1 << 9;
    pub(super) const AGAIN: u16 = 1 << 10;
}
use sign::*;

/// What is broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Defect {
    NoGuard,
    Prefix,
    MinorOnly,
    MalformedPasses,
    HashRefuses,
    HashOverrules,
    ClientLooksAway,
    SilentRefusal,
}

/// The model, over the real guards or over broken ones.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Handshake {
    defect: Option<Defect>,
    asks: u8,
    restarts: u8,
}

impl Handshake {
    /// What a server answers that has no session open.
    fn serve(&self, hello: Hello) -> String {
        let version = &*VERSIONS[hello.version].0;
        let own_hash = hello.hash == 0;
        let minor = WIRE_VERSION.trim_start_matches(|c| c != '.');
        let seen = match self.defect {
            Some(Defect::NoGuard) => WIRE_VERSION,
            Some(Defect::Prefix) if version.starts_with(WIRE_VERSION) => WIRE_VERSION,
            Some(Defect::MinorOnly) if version.ends_with(minor) => WIRE_VERSION,
            Some(Defect::MalformedPasses) if version.is_empty() => WIRE_VERSION,
            Some(Defect::HashOverrules) if own_hash => WIRE_VERSION,
            Some(Defect::HashRefuses) if hello.hash == 1 => &VERSIONS[2].0,
            _ => version,
        };
        let reply = SessionService::new(ReferenceBackend).serve(request(hello, seen).as_bytes());
        if self.defect == Some(Defect::SilentRefusal) { reply.replace("\"ok\":false", "\"ok\":true") } else { reply }
    }

    /// Whether the client takes a reply for an open session.
    fn takes(&self, hello: Hello, reply: &str) -> bool {
        // A foreign client has a guard of its own, of which nothing is assumed.
        if !VERSIONS[hello.version].1 || self.defect == Some(Defect::ClientLooksAway) {
            return matches!(decode_any(reply.as_bytes()), Ok(Message::SessionOpened(m)) if m.ok);
        }
        let request = decode_any(request(hello, &VERSIONS[hello.version].0).as_bytes());
        request.is_ok_and(|request| check_reply(&request, reply.as_bytes()).is_ok())
    }
}

impl Model for Handshake {
    type State = State;
    type Action = Event;

    fn init_states(&self) -> Vec<State> {
        vec![State {
            client: None,
            opened: false,
            asks: 0,
            server: 0,
            restarts: 0,
            serves: None,
            requests: BTreeSet::new(),
            replies: BTreeSet::new(),
            last: Signs::default(),
        }]
    }

    fn actions(&self, state: &State, actions: &mut Vec<Event>) {
        if state.asks < self.asks {
            for version in 0..VERSIONS.len() {
                actions.extend((0..HASHES.len()).map(|hash| Event::Ask(Hello { version, hash })));
            }
        }
        if state.restarts < self.restarts {
            actions.extend((0..VERSIONS.len()).map(Event::Restart));
        }
        actions.extend(state.requests.iter().copied().map(Event::Arrive));
        actions.extend(state.replies.iter().copied().map(Event::Reply));
    }

    fn next_state(&self, before: &State, event: Event) -> Option<State> {
        let mut state = before.clone();
        state.last = Signs::default();
        match event {
            Event::Ask(hello) => {
                state.client = Some(hello);
                state.opened = false;
                state.asks += 1;
                state.requests.insert(hello);
            }
            Event::Restart(version) => {
                state.server = version;
                state.restarts += 1;
                state.serves = None;
            }
            Event::Arrive(hello) => self.arrive(&mut state, hello),
            Event::Reply(answer) => self.reply(&mut state, answer),
        }
        Some(state)
    }

    fn properties(&self) -> Vec<Property<Self>> {
        vec![
            always!("server guards", INCOMPATIBLE_SERVED),
            always!("client guards", INCOMPATIBLE_TAKEN),
            always!("hash never refuses", HASH_REFUSED),
            always!("status", STATUS),
            always!("refusal is said", NO_REASON),
            Property::always("no session between incompatible versions", |_: &Self, s: &State| {
                let both = s.client.filter(|_| s.opened && s.serves == s.client);
                both.is_none_or(|hello| {
                    // One of the two is the specification; the other may be any.
                    VERSIONS[hello.version].1 == VERSIONS[s.server].1 || !VERSIONS[s.server].1
                })
            }),
            sometimes!("a session opens", OPENED),
            sometimes!("a version is refused", REFUSED),
            sometimes!("a session opens with another hash", OTHER_HASH),
            sometimes!("a reply of a foreign server is refused", FOREIGN_REPLY),
            sometimes!("a reply comes to a client that asked anew", LATE_REPLY),
            sometimes!("a request arrives again", AGAIN),
        ]
    }
}

impl Handshake {
    fn arrive(&self, state: &mut State, hello: Hello) {
        let last = &mut state.last;
        let (ref version, compatible) = VERSIONS[hello.version];
        if !VERSIONS[state.server].1 {
            // A foreign server may say yes to anything.
            let answer = Answer { to: hello, version: state.server, ok: true };
            state.replies.insert(answer);
            state.serves = Some(hello);
            return;
        }
        if state.serves.is_some() {
            // A session that is open already is the matter of the model of sessions.
            last.tell(state.serves == Some(hello), AGAIN);
            return;
        }
        let reply = self.serve(hello);
        let Ok(Message::SessionOpened(opened)) = decode_any(reply.as_bytes()) else {
            last.tell(true, NO_REASON);
            return;
        };
        last.tell(opened.ok && !compatible, INCOMPATIBLE_SERVED);
        last.tell(!opened.ok && compatible, HASH_REFUSED);
        last.tell(!opened.ok && opened.error.is_none(), NO_REASON);
        last.tell(!opened.ok, REFUSED);
        last.tell(opened.ok && hello.hash == 1, OTHER_HASH);
        let wanted = [ContractStatus::Match, ContractStatus::Mismatch, ContractStatus::NotAdvertised];
        let status = negotiate(version, HASHES[hello.hash]).ok();
        last.tell(status != compatible.then_some(wanted[hello.hash]), STATUS);
        if opened.ok {
            state.serves = Some(hello);
        }
        let answer = Answer { to: hello, version: state.server, ok: opened.ok };
        state.replies.insert(answer);
    }

    fn reply(&self, state: &mut State, answer: Answer) {
        let last = &mut state.last;
        // A reply belongs to its query: to one that the client gave up it does not come.
        if state.client != Some(answer.to) {
            last.tell(true, LATE_REPLY);
            return;
        }
        let taken = self.takes(answer.to, &text(answer));
        let is_ours = VERSIONS[answer.to.version].1;
        let is_compatible = VERSIONS[answer.version].1;
        last.tell(taken && is_ours && !is_compatible, INCOMPATIBLE_TAKEN);
        last.tell(taken && !answer.ok, INCOMPATIBLE_TAKEN);
        last.tell(!taken && is_ours && !is_compatible, FOREIGN_REPLY);
        last.tell(taken && is_ours && is_compatible, OPENED);
        state.opened |= taken;
    }
}

/// The protocol of the handshake.
pub(crate) enum Versions {}

impl Protocol for Versions {
    type Defect = Defect;
    type Model = Handshake;

    const FAMILY: &'static str = "handshake";
    const CLAIMS: &'static [Claim] = &[
        Claim {
            name: "no session between incompatible versions",
            rules: &["NCP-VER-003", "NCP-VER-004", "NCP-SESS-003", "NCP-SESS-023", "NCP-SESS-024"],
            sentence: "A client and a server never both take a session for open while the specification is the \
                server and the client's version is not compatible with it.",
            formal: "always: client opened ∧ server serves it ∧ server is {version} ⟹ compatible(client)",
        },
        Claim {
            name: "server guards",
            rules: &["NCP-VER-003", "NCP-VER-004", "NCP-VER-006", "NCP-SESS-023", "NCP-SESS-024"],
            sentence: "A server opens no session for a version that is malformed or not compatible.",
            formal: "always: ok(open) ⟹ compatible(version)",
        },
        Claim {
            name: "client guards",
            rules: &["NCP-SESS-003", "NCP-SESS-004"],
            sentence: "A client takes no session for open whose server speaks an incompatible version, or said no.",
            formal: "always: taken(reply) ⟹ compatible(reply.version) ∧ reply.ok",
        },
        Claim {
            name: "hash never refuses",
            rules: &["NCP-VER-025", "NCP-SESS-025"],
            sentence: "No request of a compatible version is refused, whatever its contract hash.",
            formal: "always: compatible(version) ∧ session not open ⟹ ok(open)",
        },
        Claim {
            name: "status",
            rules: &["NCP-VER-022", "NCP-VER-023", "NCP-VER-024", "NCP-VER-030", "NCP-VER-031"],
            sentence: "Negotiation gives the status of the hash for a compatible version, and rejects any other \
                whatever the hash.",
            formal: "always: negotiate(version, hash) = status(hash) if compatible(version), else an error",
        },
        Claim {
            name: "refusal is said",
            rules: &["NCP-SESS-023"],
            sentence: "A refusal is a session_opened with ok false that says why.",
            formal: "always: ¬ok ⟹ error is given",
        },
    ];
    const BROKEN: &'static [Variant<Defect>] = &[
        (Defect::NoGuard, "no-guard", "The server looks at no version.", "server guards"),
        (Defect::Prefix, "prefix", "What begins with {version} counts as {version}.", "server guards"),
        (Defect::MinorOnly, "minor-only", "What ends in its minor counts as {version}.", "server guards"),
        (Defect::MalformedPasses, "malformed-passes", "An empty version counts as the own.", "server guards"),
        (
            Defect::HashOverrules,
            "hash-overrules",
            "The same contract hash makes any version compatible.",
            "no session between incompatible versions",
        ),
        (Defect::HashRefuses, "hash-refuses", "Another contract hash is refused.", "hash never refuses"),
        (
            Defect::ClientLooksAway,
            "client-looks-away",
            "The client does not look at the reply's version.",
            "client guards",
        ),
        (Defect::SilentRefusal, "silent-refusal", "A refusal says ok.", "server guards"),
    ];

    fn models(_: bool) -> Vec<Handshake> {
        vec![Handshake { defect: None, asks: 2, restarts: 1 }]
    }

    fn broken(defect: Defect) -> Handshake {
        Handshake { defect: Some(defect), asks: 1, restarts: 1 }
    }

    fn bounds(small: bool) -> String {
        let Handshake { asks, restarts, .. } = Self::models(small)[0];
        let versions = VERSIONS.iter().map(|(version, _)| &**version).filter(|version| !version.is_empty());
        let versions = versions.collect::<Vec<_>>().join(", ");
        format!(
            "clients of the versions {versions} and the empty one, with the own, another and no hash, {asks} of them \
             one after another; a server that begins as {WIRE_VERSION} and starts anew at most {restarts} times as \
             any of the versions; any number of deliveries"
        )
    }

    fn replay(defect: Defect, path: &[Event]) -> Replay {
        let run = |defect| {
            let model = Handshake { defect, asks: 0, restarts: 0 };
            let answer = |event: &Event| match *event {
                Event::Ask(_) | Event::Restart(_) => json!({}),
                Event::Arrive(hello) => json!({"reply": model.serve(hello)}),
                Event::Reply(answer) => json!({"taken": model.takes(answer.to, &text(answer))}),
            };
            path.iter().map(answer).collect::<Value>()
        };
        Replay::new(path, defect, run, |_| path.iter().rev().find_map(vector))
    }
}

fn request(hello: Hello, version: &str) -> String {
    let network = json!({"kind": "builtin", "ref": "ncp.reference.lif"});
    let mut request = json!({"kind": "open_session", "ncp_version": version, "session_id": "s", "network": network});
    if let Some(hash) = HASHES[hello.hash] {
        request["contract_hash"] = json!(hash);
    }
    request.to_string()
}

fn text(answer: Answer) -> String {
    let version = &VERSIONS[answer.version].0;
    let error = (!answer.ok).then_some("refused");
    json!({"kind": "session_opened", "ncp_version": version, "session_id": "s", "ok": answer.ok, "error": error})
        .to_string()
}

/// The last event of a path that a call shows.
fn vector(event: &Event) -> Option<Value> {
    match *event {
        Event::Arrive(hello) => {
            let ok = VERSIONS[hello.version].1;
            let reply = json!({"$json": {"kind": "session_opened", "session_id": "s", "ok": ok}});
            let requests = [request(hello, &VERSIONS[hello.version].0)];
            Some(case("server", "session.run", json!({"requests": requests}), pattern(json!({"replies": [reply]}))))
        }
        Event::Reply(answer) => {
            let request = request(answer.to, &VERSIONS[answer.to.version].0);
            let accept = VERSIONS[answer.version].1 && answer.ok;
            let expect = if accept { json!({"accept": true}) } else { json!({"reject": "reply"}) };
            let args = json!({"request": request, "reply": text(answer)});
            Some(case("commander", "reply.check", args, expect))
        }
        Event::Ask(_) | Event::Restart(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explore::{check, refute};

    #[test]
    fn the_handshake_keeps_its_claims() {
        for checked in check::<Versions>(true) {
            assert!(checked.is_proved(), "{checked:?}");
        }
    }

    #[test]
    fn every_broken_handshake_is_refuted() {
        for broken in refute::<Versions>() {
            assert!(broken.is_refuted(), "{broken:?}");
        }
    }
}
