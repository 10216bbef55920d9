//! Whoever stands between clients and a simulation service on a line. The judge is both: what it asks, and what reaches
//! the service, it sees itself.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use ncp_gateway::service::{Does, LineService};
use ncp_spec::wire::{Frame, Message, ObservationFrame, decode_any};
use ncp_zenoh::{Bus, BusError, ControlClient};
use serde_json::Value;

use super::server::{has_server, session, step};
use super::{PATIENCE, Parts, shown, until};
use crate::LiveError;
use crate::target::Target;
use crate::verdict::{Measured, Rulings};

/// A request arrives as one line, however it was spread.
pub(super) fn one_line(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let Some(service) = service(target, rulings, |line| Does::Reply(observation(&session_in(line), 1.0))) else {
        return Ok(());
    };
    if !has_server(bus, rulings)? {
        return Ok(());
    }
    let client = ControlClient::new(bus, target.gateway.query)?;
    let id = session(target, "a");
    let plain = step(&id, 1.0).encode().map_err(BusError::from)?;
    let spread = [plain.clone(), plain.replace(',', ",\n"), plain.replace(':', " :\r\n\t"), format!("\n{plain}\n\n")];
    for request in spread {
        let before = service.lines().len();
        // What comes back is not the matter here.
        let _ = client.ask_bytes(request.as_bytes());
        // A second line may still be on its way.
        thread::sleep(Duration::from_millis(50));
        let lines: Vec<String> = service.lines().into_iter().skip(before).map(|(_, line)| line).collect();
        let asked: Value = serde_json::from_str(&plain)?;
        let is_same = |line: &String| serde_json::from_str::<Value>(line).is_ok_and(|line| line == asked);
        rulings.observe("NCP-TRANS-004", lines.len() == 1 && is_same(&lines[0]), || {
            format!("{} reached the service as {} lines: {lines:?}", shown(request.as_bytes()), lines.len())
        });
        for line in lines {
            let is_document = serde_json::from_str::<Value>(&line).is_ok();
            rulings.observe("NCP-TRANS-003", is_document, || format!("a line is {:?}", shown(line.as_bytes())));
        }
    }
    Ok(())
}

/// A reply that is not whole, or no JSON, is an error frame.
pub(super) fn broken_reply(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let ids = ["half", "no-line-feed", "nothing", "junk"].map(|name| session(target, name));
    let of_script = ids.clone();
    let service = service(target, rulings, move |line| {
        let id = session_in(line);
        let whole = observation(&id, 1.0);
        match of_script.iter().position(|known| *known == id) {
            Some(0) => Does::Cut(whole[..whole.len() / 2].to_owned()),
            Some(1) => Does::Cut(whole),
            Some(2) => Does::Cut(String::new()),
            Some(3) => Does::Reply("Traceback (most recent call last):".to_owned()),
            _ => Does::Reply(whole),
        }
    });
    if service.is_none() || !has_server(bus, rulings)? {
        return Ok(());
    }
    for id in ids {
        is_error(bus, target, &id, "NCP-TRANS-005", rulings)?;
    }
    is_observation(bus, target, "b", "NCP-SESS-027", rulings)
}

/// A reply to somebody else's request, or of another kind, is nobody's.
pub(super) fn misfit(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let ids = ["session", "kind"].map(|name| session(target, name));
    let of_script = ids.clone();
    let service = service(target, rulings, move |line| {
        let id = session_in(line);
        match of_script.iter().position(|known| *known == id) {
            Some(0) => Does::Reply(observation(&format!("{id}-not"), 1.0)),
            Some(1) => Does::Reply(format!(r#"{{"kind":"session_closed","session_id":"{id}"}}"#)),
            _ => Does::Reply(observation(&id, 1.0)),
        }
    });
    if service.is_none() || !has_server(bus, rulings)? {
        return Ok(());
    }
    for id in ids {
        is_error(bus, target, &id, "NCP-SESS-027", rulings)?;
    }
    is_observation(bus, target, "b", "NCP-SESS-027", rulings)
}

/// While the service is at one session, another is answered.
pub(super) fn side_by_side(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    const RULE: &str = "NCP-TRANS-007";
    let slow = session(target, "slow");
    let (of_script, holds) = (slow.clone(), Arc::new(AtomicBool::new(false)));
    let (held, longest) = (Arc::clone(&holds), target.gateway.query * 2 / 5);
    let is_at_it = Arc::new(AtomicBool::new(false));
    let at_it = Arc::clone(&is_at_it);
    let service = service(target, rulings, move |line| {
        let id = session_in(line);
        if id == of_script {
            at_it.store(true, Ordering::SeqCst);
            let began = Instant::now();
            while held.load(Ordering::SeqCst) && began.elapsed() < longest {
                thread::sleep(Duration::from_millis(1));
            }
            at_it.store(false, Ordering::SeqCst);
        }
        Does::Reply(observation(&id, 1.0))
    });
    let Some(service) = service else { return Ok(()) };
    if !has_server(bus, rulings)? {
        return Ok(());
    }
    let client = ControlClient::new(bus, target.gateway.query)?;
    let mut is_beside = false;
    for _ in 0..3 {
        holds.store(true, Ordering::SeqCst);
        let before = service.lines().len();
        is_beside |= thread::scope(|scope| -> Result<bool, LiveError> {
            let slow = scope.spawn(|| client.ask(&step(&slow, 1.0)).is_ok());
            let is_asked = until(longest, || Ok(service.lines().len() > before))?;
            let is_answered = is_asked && client.ask(&step(&session(target, "b"), 1.0)).is_ok();
            // The service itself knows whether it is still at the slow one: a busy client may hear late of its answer.
            let is_answered = is_answered && is_at_it.load(Ordering::SeqCst);
            holds.store(false, Ordering::SeqCst);
            // Whether it was answered in the end, other scenarios say.
            let _ = slow.join();
            Ok(is_answered)
        })?;
    }
    rulings.observe(RULE, is_beside, || {
        format!("for {longest:?} that the service was at one session, the step of another was not answered, each time")
    });
    Ok(())
}

/// Whoever waits for a service that does not answer is told so before he gives up.
pub(super) fn time_out(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    const RULE: &str = "NCP-TRANS-006";
    let service = service(target, rulings, |_| Does::Nothing);
    if service.is_none() || !has_server(bus, rulings)? {
        return Ok(());
    }
    let began = Instant::now();
    is_error(bus, target, &session(target, "a"), RULE, rulings)?;
    let waited_ms = began.elapsed().as_secs_f64() * 1e3;
    rulings.measured(RULE, Measured::of(vec![waited_ms], 0.0));
    Ok(())
}

/// A reply that comes when its request was given up is not that of the next.
pub(super) fn late_reply(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    const RULE: &str = "NCP-SESS-027";
    let late = session(target, "late");
    let (of_script, after) = (late.clone(), target.gateway.query);
    let service = service(target, rulings, move |line| match session_in(line) {
        id if id == of_script => Does::Late(after, observation(&id, 1.0)),
        id => Does::Reply(observation(&id, 1.0)),
    });
    if service.is_none() || !has_server(bus, rulings)? {
        return Ok(());
    }
    let client = ControlClient::new(bus, target.gateway.query)?;
    let began = Instant::now();
    // That it is given up, another scenario says.
    let _ = client.ask(&step(&late, 1.0));
    while began.elapsed() < 2 * after {
        is_observation(bus, target, "b", RULE, rulings)?;
        thread::sleep(Duration::from_millis(20));
    }
    Ok(())
}

/// A service that is not there costs an error frame, and is found when it comes.
pub(super) fn dead_service(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    // Whether the address is free, without a service on it.
    if service(target, rulings, |_| Does::Nothing).is_none() || !has_server(bus, rulings)? {
        return Ok(());
    }
    let client = ControlClient::new(bus, target.gateway.query)?;
    for time in ["first", "second"] {
        is_error(bus, target, &session(target, "a"), "NCP-SESS-020", rulings)?;
        let script = |line: &str| Does::Reply(observation(&session_in(line), 1.0));
        let Some(_service) = service(target, rulings, script) else { return Ok(()) };
        let asked = step(&session(target, "a"), 1.0);
        let is_found = until(PATIENCE, || Ok(client.ask(&asked).is_ok()))?;
        rulings.observe("NCP-SESS-027", is_found, || {
            format!("the service that came back for the {time} time was not found within {PATIENCE:?}")
        });
    }
    Ok(())
}

/// A program whose configuration is named and cannot be read does not start.
pub(super) fn config(target: &Target, parts: &Parts, rulings: &mut Rulings) -> Result<(), LiveError> {
    let program = match (parts, &target.gateway.program) {
        (Parts::Deployed, None) => {
            rulings.all_unclear("no --program says what to start");
            return Ok(());
        }
        (Parts::Deployed, Some(program)) => program.clone(),
        (Parts::Actors(_), _) => std::env::current_exe()?,
    };
    let folder = tempfile::tempdir()?;
    let malformed = folder.path().join("malformed.json5");
    fs::write(&malformed, "{mode: 'client', connect: {")?;
    for file in [folder.path().join("missing.json5"), malformed] {
        let mut command = Command::new(&program);
        if let Parts::Actors(planted) = parts {
            command.arg("gateway-program").args(planted.0.iter().flat_map(|name| ["--defect", name]));
        }
        let has_refused = refuses(command, &file, target)?;
        rulings.observe("NCP-TRANS-012", has_refused, || {
            format!("with NCP_ZENOH_CONFIG={}, it had not ended with a failure within {PATIENCE:?}", file.display())
        });
    }
    Ok(())
}

/// Whether a program that is started with a configuration ends with a failure; one that runs is ended.
fn refuses(mut command: Command, config: &Path, target: &Target) -> Result<bool, LiveError> {
    command.env("NCP_ZENOH_CONFIG", config).env("NCP_REALM", &target.realm);
    command.env("NCP_BRIDGE_ADDR", target.gateway.bridge.to_string());
    let mut program = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    let mut status = None;
    let has_ended = until(PATIENCE, || {
        status = program.try_wait()?;
        Ok(status.is_some())
    });
    // One that has ended cannot be killed.
    let _ = (program.kill(), program.wait());
    Ok(has_ended? && status.is_some_and(|status| !status.success()))
}

/// A service of the judge's own where the gateway looks for one.
pub(super) fn service(
    target: &Target,
    rulings: &mut Rulings,
    script: impl Fn(&str) -> Does + Send + Sync + 'static,
) -> Option<LineService> {
    let started = LineService::start(target.gateway.bridge, script);
    if let Err(error) = &started {
        let bridge = target.gateway.bridge;
        rulings.all_unclear(&format!("{bridge}: {error}; the service of the deployment has to be stopped"));
    }
    started.ok()
}

fn is_error(bus: &Bus, target: &Target, id: &str, rule: &str, rulings: &mut Rulings) -> Result<(), LiveError> {
    let client = ControlClient::new(bus, target.gateway.query)?;
    let request = step(id, 1.0).encode().map_err(BusError::from)?;
    match client.ask_bytes(request) {
        Ok(reply) => rulings.observe(rule, matches!(decode_any(&reply), Ok(Message::Error(_))), || {
            format!("the step of {id} was answered with {:?}, and no error frame", shown(&reply))
        }),
        Err(error @ (BusError::NoReply(_) | BusError::Failed(_))) => {
            rulings.fail(rule, format!("the step of {id}: {error}"));
        }
        Err(error) => return Err(error.into()),
    }
    Ok(())
}

fn is_observation(bus: &Bus, target: &Target, name: &str, rule: &str, rulings: &mut Rulings) -> Result<(), LiveError> {
    let client = ControlClient::new(bus, target.gateway.query)?;
    let id = session(target, name);
    let reply = client.ask_bytes(step(&id, 1.0).encode().map_err(BusError::from)?);
    let is_so = reply.as_ref().is_ok_and(|reply| is_observation_of(reply, &id));
    rulings.observe(rule, is_so, || match reply {
        Ok(reply) => format!("the step of {id} was answered with {:?}", shown(&reply)),
        Err(error) => format!("the step of {id}: {error}"),
    });
    Ok(())
}

pub(super) fn is_observation_of(reply: &[u8], id: &str) -> bool {
    matches!(decode_any(reply), Ok(Message::ObservationFrame(frame)) if frame.session_id == id)
}

pub(super) fn observation(id: &str, sim_time_ms: f64) -> String {
    let frame = ObservationFrame { session_id: id.to_owned().into(), sim_time_ms, ..ObservationFrame::default() };
    frame.encode().unwrap_or_default()
}

pub(super) fn session_in(line: &str) -> String {
    let line: Value = serde_json::from_str(line).unwrap_or_default();
    line["session_id"].as_str().unwrap_or("none").to_owned()
}

pub(super) fn number_in(line: &str, member: &str) -> f64 {
    let line: Value = serde_json::from_str(line).unwrap_or_default();
    line[member].as_f64().unwrap_or_default()
}
