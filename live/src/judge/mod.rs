//! The judge: it sets a scenario up, looks at what goes over the network, and rules.
//!
//! | module | what it judges |
//! |---|---|
//! | [`traffic`] | samples that a tap sees, now or from a capture |
//! | [`server`] | who answers control RPC |
//! | [`road`] | over which network it is asked |
//! | [`body`] | who obeys commands |
//! | [`commander`] | who sends them |
//! | [`observer`] | who reads |
//! | [`gateway`] | who stands before a simulation service on a line |
//! | [`websocket`] | the same, over WebSocket |
//! | [`acl`] | the access rules of a router |

mod acl;
mod body;
mod commander;
mod gateway;
mod observer;
pub(crate) mod road;
mod server;
pub(crate) mod traffic;
mod websocket;

pub(crate) use acl::{Acl, RulesError, run as acl};

use std::thread;
use std::time::{Duration, Instant, SystemTime};

use ncp_text::Catalogue;

use road::Road;

use crate::LiveError;
use crate::actors::{self, Care, Planted};
use crate::scenario::{Role, Scenario};
use crate::soak;
use crate::target::{Noise, Target};
use crate::verdict::{Ruling, Rulings};

/// How long something may take that has no time of its own in the text, such as a first sample, or a reply.
pub(crate) const PATIENCE: Duration = Duration::from_secs(5);

/// How long a tap looks at traffic.
const LOOK: Duration = Duration::from_millis(1_500);

/// What plays the parts that a scenario needs.
#[derive(Debug, Clone)]
pub(crate) enum Parts {
    /// A deployment, which runs already.
    Deployed,
    /// The reference actors, with at most one defect.
    Actors(Planted),
}

/// Runs a scenario against a target.
///
/// # Errors
/// The target cannot be reached, or an actor cannot be started. What can be run and fails is a ruling.
pub(crate) fn judge(
    scenario: &Scenario,
    target: &Target,
    parts: &Parts,
    catalogue: &Catalogue,
) -> Result<Vec<Ruling>, LiveError> {
    let mut rulings = Rulings::new(&scenario.rules);
    let sentence = |rule: &str| catalogue.get(rule).map(|rule| rule.sentence.clone()).unwrap_or_default();
    if let Some(link) = &scenario.link {
        match parts {
            Parts::Actors(planted) => soak::over_link(link, planted, &mut rulings)?,
            Parts::Deployed => rulings.all_unclear("the link of a deployment is its own"),
        }
        return Ok(rulings.verdicts(&scenario.name, sentence));
    }
    if target.road != Road::Zenoh {
        // There may be no Zenoh at all.
        server::judge(scenario, target, &mut rulings)?;
        return Ok(rulings.verdicts(&scenario.name, sentence));
    }
    let mut running = Vec::new();
    let planted = match parts {
        Parts::Actors(planted) => planted,
        Parts::Deployed => &Planted::default(),
    };
    for role in &scenario.needs {
        // Of a deployment's gateway, the judge is the service.
        if matches!(parts, Parts::Actors(_)) || *role == Role::Simulator {
            running.push(actors::start(*role, target, planted, &Care::default())?);
        }
    }
    let bus = target.bus()?;
    let noise = Noise::new();
    match scenario.name.as_str() {
        "qos/planes" | "watch/loop" => {
            let samples = traffic::tap(&bus, LOOK)?;
            traffic::judge(&samples, &target.realm, &mut rulings);
        }
        "watch/server" => server::watch(&bus, target, &mut rulings)?,
        "qos/request" => server::request_qos(&bus, &mut rulings)?,
        "acl/matrix" => match parts {
            Parts::Actors(planted) => acl::matrix(planted, &mut rulings)?,
            Parts::Deployed => rulings.all_unclear("the certificates of a deployment are its own"),
        },
        "body/expiry" => body::expiry(&bus, target, &noise, &mut rulings)?,
        "commander/echo" => commander::echo(&bus, target, &mut rulings)?,
        "commander/flood" => commander::flood(&bus, target, &noise, &mut rulings)?,
        "commander/stale" => commander::stale(&bus, target, &mut rulings)?,
        "commander/fence" => commander::fence(&bus, target, &mut rulings)?,
        "observer/quiet" => observer::quiet(&bus, target, &mut rulings)?,
        "observer/join" => observer::join(&bus, target, &mut rulings)?,
        "observer/leaves" => {
            let ends = matches!(parts, Parts::Actors(_)).then(|| move || running.clear());
            observer::leaves(&bus, target, ends, &mut rulings)?;
        }
        "gateway/one-line" => gateway::one_line(&bus, target, &mut rulings)?,
        "gateway/broken-reply" => gateway::broken_reply(&bus, target, &mut rulings)?,
        "gateway/misfit" => gateway::misfit(&bus, target, &mut rulings)?,
        "gateway/side-by-side" => gateway::side_by_side(&bus, target, &mut rulings)?,
        "gateway/time-out" => gateway::time_out(&bus, target, &mut rulings)?,
        "gateway/late-reply" => gateway::late_reply(&bus, target, &mut rulings)?,
        "gateway/dead-service" => gateway::dead_service(&bus, target, &mut rulings)?,
        "gateway/ws-order" => websocket::order(&bus, target, &mut rulings)?,
        "gateway/ws-refusals" => websocket::refusals(&bus, target, &mut rulings)?,
        "gateway/config" => gateway::config(target, parts, &mut rulings)?,
        name if name.starts_with("server/") || name == "gateway/session" => {
            server::judge(scenario, target, &mut rulings)?;
        }
        _ => body::steps(&bus, target, &scenario.steps, &noise, &mut rulings)?,
    }
    Ok(rulings.verdicts(&scenario.name, sentence))
}

/// Asks until something is so, or patience is at its end; whether it became so.
fn until(longest: Duration, mut is_so: impl FnMut() -> Result<bool, LiveError>) -> Result<bool, LiveError> {
    let began = Instant::now();
    loop {
        if is_so()? {
            return Ok(true);
        }
        if began.elapsed() > longest {
            return Ok(false);
        }
        thread::sleep(Duration::from_millis(2));
    }
}

/// A stamp that is beyond all that a running system has seen: what it was sent before does not make it stale.
fn first_seq() -> i64 {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    i64::try_from(since.as_micros()).unwrap_or(1)
}

/// The beginning of what a peer sent, for people.
fn shown(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    let mut shown: String = text.chars().take(120).collect();
    if shown.len() < text.len() {
        shown.push('…');
    }
    shown
}
