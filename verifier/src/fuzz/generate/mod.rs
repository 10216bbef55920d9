//! What is asked: inputs drawn from the text's own tables and models.
//!
//! Every trace has a *swarm* of its own: which features it has at all, and how often. So features that are rare
//! together when each is drawn by itself are common together in some traces.
//!
//! - `frames`: `decode`, `encode` and `reply.check`, from the tables of messages.
//! - `corrupt`: valid text made invalid, with its grammar in mind.
//! - `plain`: versions, hashes, keys, planes, the longest horizon.
//! - `bulk`: blocks and observations.
//! - `plant`: the watchdog, the buffer, the link monitor.
//! - `safety`: the governor, the reflex controller, the loop.
//! - `codec`: the rate codec.
//! - `session`: the requests to a server.
//! - `mutate`: an input that was kept, changed.
//! - `vary`: a case of the corpus, made longer, larger, nearly ambiguous, or one with another.

mod bulk;
mod codec;
mod corrupt;
mod frames;
mod mutate;
mod plain;
mod plant;
mod safety;
mod session;
mod vary;

use super::draw::Draw;
use super::tree::Tree;
use crate::json::Json;
use crate::peer::Call;

pub(crate) use mutate::mutate;
pub(in crate::fuzz) use plain::canonical;
pub(crate) use vary::Seeds;

/// One question to a peer.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// The call.
    pub call: Call,
    /// Its arguments.
    pub args: Tree,
}

impl Input {
    /// The request after its id: `"call":…,"args":…}`.
    #[must_use]
    pub fn body(&self) -> String {
        body(self.call, &self.args.to_string())
    }
}

/// The request after its id, of arguments that are written already.
pub(crate) fn body(call: Call, args: &str) -> String {
    format!("\"call\":\"{}\",\"args\":{args}}}", call.as_str())
}

/// What a peer may be asked.
#[derive(Debug, Clone)]
pub(crate) struct Menu {
    /// Calls, each as often as it is to be drawn.
    pub(crate) calls: Vec<(Call, usize)>,
    /// Whether the strict profile may be asked for.
    pub(crate) strict: bool,
    /// The kinds that the peer's roles read, and those that they write.
    pub(crate) reads: Vec<&'static str>,
    pub(crate) writes: Vec<&'static str>,
    /// The keys that its roles build, and the planes on which they publish.
    pub(crate) keys: Vec<&'static str>,
    pub(crate) planes: Vec<&'static str>,
}

impl Menu {
    /// Whether these arguments of a call are what its peer may be asked.
    pub(crate) fn has(&self, call: Call, args: &Tree) -> bool {
        let of = |name: &str| crate::fuzz::tree::string(args, name).unwrap_or_default();
        let fits = match call {
            Call::Decode => self.reads.contains(&of("kind")),
            Call::Encode => self.writes.contains(&of("kind")),
            Call::KeyBuild => {
                let key = of("key");
                let lacks = |name: &str| args.get(name).is_none_or(|value| matches!(value, Json::Null));
                self.keys.contains(&key)
                    && lacks("session") == matches!(key, "rpc" | "fleet_glob")
                    && (lacks("name") || matches!(key, "sensor" | "command"))
            }
            Call::PlaneQos => self.planes.contains(&of("plane")),
            Call::CodecEncode | Call::CodecDecode => codec::is_said_by_all(args),
            Call::SessionRun => session::is_bearable(args),
            _ => true,
        };
        // How strictly two versions are compared is asked of every peer.
        let is_of_strict =
            call != Call::VersionCheck && ["strict", "verb", "verbs"].iter().any(|name| args.get(name).is_some());
        fits && (self.strict || !is_of_strict) && has_usual_numbers(args)
    }
}

/// Whether each number of a request, those within its texts aside, has no more digits than any JSON library reads:
/// PROTOCOL.md has no longer ones, and what a library makes of them is no answer of the peer.
fn has_usual_numbers(args: &Tree) -> bool {
    match args {
        Json::Number(spelling) => spelling.len() <= 1200,
        Json::Array(items) => items.iter().all(has_usual_numbers),
        Json::Object(members) => members.iter().all(|(_, value)| has_usual_numbers(value)),
        _ => true,
    }
}

/// How often a call is drawn, of the sum of all: what a peer answers in a tenth of a millisecond much oftener than a
/// trace that takes a hundred times as long. So it is mostly the traces that take the time, and the rest is searched
/// well at little cost.
pub(crate) const fn weight(call: Call) -> usize {
    match call {
        Call::Describe => 0,
        Call::PlaneQos => 1,
        Call::LoopRun | Call::ObservationPack => 8,
        Call::BulkEncode | Call::SessionRun => 10,
        Call::LinkRun => 12,
        Call::BulkDecode | Call::BufferRun => 16,
        Call::ContractStatus | Call::ContractVerify => 20,
        Call::CodecEncode | Call::CodecDecode | Call::ReflexStep | Call::GovernorRun => 20,
        Call::ReplyCheck | Call::WatchdogRun => 24,
        Call::Encode | Call::ObservationUnpack | Call::Negotiate => 40,
        Call::HorizonMaxLen => 60,
        Call::Decode => 100,
        Call::VersionCheck => 150,
        Call::KeyBuild | Call::KeyMatch => 200,
    }
}

/// One of the calls of the menu, by their weights; none if it has none.
pub(crate) fn call(menu: &Menu, draw: &mut Draw<'_>) -> Option<Call> {
    let total: usize = menu.calls.iter().map(|(_, weight)| weight).sum();
    let mut left = draw.below(total);
    menu.calls.iter().find_map(|(call, weight)| {
        if left < *weight {
            return Some(*call);
        }
        left -= weight;
        None
    })
}

/// Arguments for a call.
pub(crate) fn args(call: Call, menu: &Menu, draw: &mut Draw<'_>) -> Option<Tree> {
    Some(match call {
        Call::Describe => return None,
        Call::Decode => frames::decode(menu, draw)?,
        Call::Encode => frames::encode(menu, draw)?,
        Call::ReplyCheck => frames::reply(menu, draw),
        Call::VersionCheck => plain::version(draw),
        Call::ContractStatus | Call::ContractVerify => plain::contract(draw),
        Call::Negotiate => plain::negotiate(draw),
        Call::KeyBuild => plain::key_build(menu, draw)?,
        Call::KeyMatch => plain::key_match(draw),
        Call::PlaneQos => plain::plane(menu, draw)?,
        Call::HorizonMaxLen => plain::horizon(draw),
        Call::BulkDecode => bulk::decode(draw),
        Call::BulkEncode => bulk::encode(draw),
        Call::ObservationPack => bulk::pack(draw),
        Call::ObservationUnpack => bulk::unpack(draw),
        Call::WatchdogRun => plant::watchdog(draw),
        Call::BufferRun => plant::buffer(menu, draw),
        Call::LinkRun => plant::link(draw),
        Call::GovernorRun => safety::governor(draw),
        Call::ReflexStep => safety::reflex(draw),
        Call::LoopRun => safety::control_loop(draw),
        Call::CodecEncode => codec::encode(draw),
        Call::CodecDecode => codec::decode(draw),
        Call::SessionRun => session::run(menu, draw),
    })
}

/// The kind of the reply that answers a request of a kind.
pub(crate) fn answer_to(request: &str) -> Option<&'static str> {
    frames::PAIRS.iter().find(|(known, _)| *known == request).map(|(_, reply)| *reply)
}

/// How many steps a trace has: mostly a few dozen, often hundreds, rarely up to `most`.
fn steps(draw: &mut Draw<'_>, most: usize) -> usize {
    if let Some(length) = draw.length() {
        return length;
    }
    match draw.below(1000) {
        0 => draw.size(300, most),
        1..=40 => draw.size(40, 400.min(most)),
        _ => draw.size(2, 40),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;
    use crate::fuzz::menu;
    use crate::fuzz::tree::{list, literal, text};
    use ncp_peer_rust::Answer;
    use ncp_text::catalogue::{Level, Role};

    pub(crate) fn whole_menu() -> Menu {
        menu(&Role::ALL, Level::Strict, true, &[])
    }

    #[test]
    fn what_only_the_strict_profile_has_is_on_no_other_menu() {
        let object = |name| crate::fuzz::tree::object([("key", text("rpc")), (name, text("step_request"))]);
        let (strict, other) = (whole_menu(), Menu { strict: false, ..whole_menu() });
        for name in ["strict", "verb", "verbs"] {
            assert!(strict.has(Call::KeyBuild, &object(name)) && !other.has(Call::KeyBuild, &object(name)), "{name}");
        }
        assert!(other.has(Call::KeyBuild, &object("realm")));
        assert!(other.has(Call::VersionCheck, &object("strict")));
    }

    #[test]
    fn only_texts_have_numbers_of_thousands_of_digits() {
        let (menu, digits) = (whole_menu(), "1".repeat(5000));
        let written = |value: Tree| crate::fuzz::tree::object([("kind", text("error")), ("fields", value)]);
        assert!(!menu.has(Call::Encode, &written(list(vec![literal(digits.clone())]))));
        assert!(menu.has(Call::Encode, &written(text(digits))));
    }

    #[test]
    fn a_key_is_asked_for_with_what_it_is_made_of() {
        let object = |key, part| crate::fuzz::tree::object([("key", text(key)), (part, text("a"))]);
        let menu = whole_menu();
        for (key, part, is_asked) in [
            ("rpc", "realm", true),
            ("rpc", "session", false),
            ("fleet_glob", "session", false),
            ("observation", "session", true),
            ("observation", "realm", false),
            ("observation", "name", false),
            ("sensor", "name", false),
        ] {
            assert_eq!(menu.has(Call::KeyBuild, &object(key, part)), is_asked, "{key} {part}");
        }
        let mut named = object("sensor", "name");
        crate::fuzz::tree::set(&mut named, "session", text("a"));
        assert!(menu.has(Call::KeyBuild, &named));
    }

    #[test]
    fn each_call_is_drawn_as_often_as_its_weight_says() {
        let (menu, harvest) = (whole_menu(), Harvest::default());
        let total: usize = menu.calls.iter().map(|(_, weight)| weight).sum();
        let inputs = 200 * total;
        let mut drawn = std::collections::BTreeMap::new();
        for number in 0..inputs {
            *drawn.entry(call(&menu, &mut Draw::new(9, number as u64, &harvest)).unwrap()).or_insert(0) += 1;
        }
        for (call, weight) in &menu.calls {
            assert!(*weight > 0, "{call:?} is never drawn");
            let (times, expected) = (drawn.get(call).copied().unwrap_or(0), 200 * weight);
            assert!((expected / 2..expected * 2).contains(&times), "{call:?}: {times} instead of {expected}");
        }
        assert_eq!(weight(Call::Describe), 0);
    }

    #[test]
    fn every_generator_draws_what_the_protocol_allows_and_the_same_for_a_seed() {
        let (menu, harvest) = (whole_menu(), Harvest::default());
        for call in Call::ALL.iter().filter(|call| **call != Call::Describe) {
            let mut results = 0;
            for number in 0..150 {
                let one = args(*call, &menu, &mut Draw::new(5, number, &harvest)).unwrap();
                let same = args(*call, &menu, &mut Draw::new(5, number, &harvest)).unwrap();
                assert_eq!(one, same, "{call:?} {number}");
                match ncp_peer_rust::ask(call.as_str(), &one.to_string()) {
                    Answer::Result(_) => results += 1,
                    Answer::Error { code, message } => {
                        assert_ne!(code, "internal", "{call:?} {number}: {message}\n{one}");
                    }
                    Answer::Unsupported => panic!("{call:?}"),
                }
            }
            // Most of what is drawn is to get beyond the first check.
            assert!(results >= 15, "{call:?}: {results} of 150 have a result");
        }
    }
}
