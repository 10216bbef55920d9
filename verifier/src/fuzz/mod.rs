//! The search: spec and peer in step, on inputs and whole traces that are drawn at random.
//!
//! A fixed corpus is a list of what somebody thought of. This looks between its entries: it draws an input, asks the
//! specification in this process and the peer over its protocol, and where they part, asks whether the text lets them.
//! A disagreement is shrunk to the smallest and becomes a case like those of the corpus.
//!
//! - `draw`: random choices, and the classes of numbers and sizes at which implementations go wrong.
//! - `tree`: JSON that is built and changed.
//! - [`harvest`]: strings and numbers from a peer's own sources.
//! - `sweep`: each of these in each place where one of its kind may stand.
//! - `generate`: inputs for every call.
//! - `oracle`: what the text asks of an answer, with every freedom that it leaves.
//! - [`deep`]: candidates for the deep set.
//! - `about`: the rules of a candidate.
//! - `asker`: one peer with requests in flight, and what becomes of each.
//! - `court`: judges a disagreement by the reader and the judge of the suite.
//! - `rules`: the rule that decides it.
//! - `shrink`: the smallest input that still shows it.
//! - [`coverage`]: what was reached.
//! - `search`: all of it together.
//! - [`report`]: what was found, for people and programs.

mod about;
mod asker;
mod court;
pub mod coverage;
pub mod deep;
mod draw;
mod generate;
pub mod harvest;
mod oracle;
pub mod report;
mod rules;
mod search;
mod shrink;
mod sweep;
mod tree;

pub use asker::Fault;
pub use court::CourtError;
pub use generate::Input;
pub use harvest::{Harvest, HarvestError};
pub use rules::Decided;
pub use search::{
    Extent, Finding, Found, FuzzError, Listener, Settings, Shrunk, Tested, contradictions, fuzz, in_process, save,
};

use ncp_text::catalogue::{Level, Role};

use crate::peer::Call;
use crate::suite::Pattern;
use generate::Menu;

/// The roles that answer a call, and the level from which on a peer has to.
pub(crate) fn concerns(call: Call) -> (&'static [Role], Level) {
    use Role::{Body, Commander, Observer, Server};
    match call {
        Call::Describe => (&[], Level::Wire),
        Call::Decode
        | Call::Encode
        | Call::VersionCheck
        | Call::ContractStatus
        | Call::ContractVerify
        | Call::Negotiate
        | Call::KeyBuild
        | Call::PlaneQos => (&Role::ALL, Level::Wire),
        Call::KeyMatch => (&[Observer], Level::Wire),
        Call::BulkDecode | Call::ObservationUnpack => (&[Commander, Observer], Level::Wire),
        Call::BulkEncode | Call::ObservationPack => (&[Server], Level::Wire),
        Call::ReplyCheck => (&[Commander], Level::Wire),
        Call::GovernorRun | Call::CodecEncode | Call::CodecDecode | Call::ReflexStep | Call::LoopRun => {
            (&[Commander], Level::Safety)
        }
        Call::WatchdogRun | Call::BufferRun => (&[Body], Level::Safety),
        Call::HorizonMaxLen | Call::LinkRun => (&[Commander, Body], Level::Safety),
        Call::SessionRun => (&[Server], Level::Safety),
    }
}

/// The kinds that a role reads.
fn reads(role: Role) -> &'static [&'static str] {
    match role {
        Role::Commander => &[
            "session_opened",
            "session_closed",
            "error",
            "observation_frame",
            "sensor_frame",
            "link_status",
            "capabilities",
        ],
        Role::Body => &["command_frame", "capabilities"],
        Role::Server => &["open_session", "step_request", "run_request", "close_session", "stimulus_frame"],
        Role::Observer => {
            &["observation_frame", "sensor_frame", "link_status", "command_frame", "control_status", "capabilities"]
        }
    }
}

/// The kinds that a role writes.
fn writes(role: Role) -> &'static [&'static str] {
    match role {
        Role::Commander => &[
            "command_frame",
            "control_status",
            "open_session",
            "step_request",
            "run_request",
            "close_session",
            "stimulus_frame",
            "capabilities",
        ],
        Role::Body => &["sensor_frame", "link_status", "capabilities"],
        Role::Server => &["session_opened", "observation_frame", "session_closed", "error"],
        Role::Observer => &[],
    }
}

/// The keys that a role builds.
fn keys(role: Role) -> &'static [&'static str] {
    match role {
        Role::Commander => &["rpc", "sensor", "command"],
        Role::Body => &["sensor", "command"],
        Role::Server => &["rpc", "observation"],
        Role::Observer => {
            &["sensor", "command", "observation", "sensor_glob", "command_glob", "session_glob", "fleet_glob"]
        }
    }
}

/// The planes on which a role publishes.
fn planes(role: Role) -> &'static [&'static str] {
    match role {
        Role::Commander => &["control", "perception", "action"],
        Role::Body => &["perception", "action"],
        Role::Server => &["control", "observation"],
        Role::Observer => &[],
    }
}

/// Whether a role is asked this of a call: it reads, writes or builds such a thing.
fn has(role: Role, call: Call, args: &tree::Tree) -> bool {
    let of = |name: &str| tree::string(args, name).unwrap_or_default();
    match call {
        Call::Decode => reads(role).contains(&of("kind")),
        Call::Encode => writes(role).contains(&of("kind")),
        Call::KeyBuild => keys(role).contains(&of("key")),
        Call::PlaneQos => planes(role).contains(&of("plane")),
        _ => true,
    }
}

/// What a peer of these roles may be asked at a level.
pub(crate) fn menu(roles: &[Role], level: Level, networks: bool, patterns: &[Pattern]) -> Menu {
    let of = |by: fn(Role) -> &'static [&'static str]| {
        let mut all: Vec<&'static str> = roles.iter().flat_map(|role| by(*role)).copied().collect();
        all.sort_unstable();
        all.dedup();
        all
    };
    let (reads, writes, keys, planes) = (of(reads), of(writes), of(keys), of(planes));
    let calls = Call::ALL.iter().copied().filter(|call| {
        let (answering, from) = concerns(*call);
        let has = match call {
            Call::Decode => !reads.is_empty(),
            Call::Encode => !writes.is_empty(),
            Call::KeyBuild => !keys.is_empty(),
            Call::PlaneQos => !planes.is_empty(),
            Call::SessionRun => networks,
            _ => true,
        };
        has && from <= level
            && answering.iter().any(|role| roles.contains(role))
            && (patterns.is_empty() || patterns.iter().any(|pattern| pattern.fits_text(call.as_str())))
    });
    let calls = calls.map(|call| (call, generate::weight(call))).collect();
    Menu { calls, strict: level >= Level::Strict, reads, writes, keys, planes }
}
