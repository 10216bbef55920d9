//! Whoever answers control RPC.

use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use ncp_spec::WIRE_VERSION;
use ncp_spec::plane::Plane;
use ncp_spec::wire::{
    CloseSession, Message, NetworkRef, ObservationFrame, OpenSession, RunRequest, SimConfig, SortedMap, StepRequest,
    decode_any,
};
use ncp_zenoh::{Bus, BusError, ControlClient, SeenQos};
use serde_json::{Map, Value};
use zenoh::Wait;
use zenoh::query::{ConsolidationMode, QueryTarget, Reply};

use super::road::{AskError, Asker};
use super::{PATIENCE, shown, traffic, until};
use crate::LiveError;
use crate::scenario::{Scenario, Step};
use crate::target::Target;
use crate::verdict::{Measured, Rulings};

/// Judges a server on the road that leads to it.
pub(super) fn judge(scenario: &Scenario, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let Some(asker) = asker(target, PATIENCE, rulings)? else { return Ok(()) };
    match scenario.name.as_str() {
        "server/order" => order(&asker, target, rulings),
        "server/side-by-side" => side_by_side(target, rulings),
        "server/alone" => alone(&asker, rulings),
        _ => steps(&asker, target, &scenario.steps, rulings),
    }
}

/// Carries out the steps of a scenario, in their order. What a road has no form for is not asked on it.
fn steps(asker: &Asker, target: &Target, steps: &[Step], rulings: &mut Rulings) -> Result<(), LiveError> {
    let ids = |text: &str| {
        let (a, b) = (session(target, "a"), session(target, "b"));
        let text = text.replace("{a}", &a).replace("{b}", &b);
        text.replace("{network}", &target.network).replace("{wire}", WIRE_VERSION)
    };
    let mut unsayable = Vec::new();
    for step in steps {
        let Step::Ask { ask, reply, rule } = step else { continue };
        let ask = ids(ask);
        match asker.ask_bytes(ask.as_bytes()) {
            Ok(found) => {
                let members: Value = serde_json::from_slice(&found).unwrap_or_default();
                let fits = |expected: &Map<String, Value>| {
                    expected.iter().all(|(name, value)| members.get(name).is_some_and(|found| same(found, value, &ids)))
                };
                let is_so = decode_any(&found).is_ok() && reply.iter().any(fits);
                rulings.observe(rule, is_so, || {
                    let expected: Vec<String> =
                        reply.iter().map(|one| Value::Object(one.clone()).to_string()).collect();
                    format!(
                        "{} was answered with {}, not with {}",
                        shown(ask.as_bytes()),
                        shown(&found),
                        expected.join(" or ")
                    )
                });
            }
            Err(AskError::NoReply(longest)) => {
                rulings.fail(rule, format!("{} was not answered within {longest:?}", shown(ask.as_bytes())));
            }
            Err(AskError::Failed(why)) => {
                rulings.fail(rule, format!("{} was answered with no frame: {why}", shown(ask.as_bytes())));
            }
            Err(AskError::Unsayable) => unsayable.push(rule.as_str()),
            Err(error) => return Err(error.into()),
        }
    }
    rulings.leave_out_unseen(&unsayable);
    Ok(())
}

/// What a server publishes while a session is stepped.
pub(super) fn watch(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    if !has_server(bus, rulings)? {
        return Ok(());
    }
    let client = ControlClient::new(bus, PATIENCE)?;
    let id = session(target, "a");
    client.ask(&open(target, &id, None))?;
    let samples = thread::scope(|scope| {
        let tap = scope.spawn(|| traffic::tap(bus, Duration::from_millis(800)));
        // The tap is there before the first of them is published, or misses that one alone.
        thread::sleep(Duration::from_millis(200));
        for _ in 0..10 {
            // What is not answered as it should be, other scenarios say.
            let _ = client.ask(&step(&id, 1.0));
        }
        tap.join().unwrap_or_else(|_| Ok(Vec::new()))
    })?;
    let _ = client.ask(&close(&id));
    traffic::judge(&samples, &target.realm, rulings);
    Ok(())
}

/// The quality of service of a client's requests, as a server sees it. Zenoh gives a reply that of its query, whatever
/// a server asks for, so a server has none of its own to judge.
pub(super) fn request_qos(bus: &Bus, rulings: &mut Rulings) -> Result<(), LiveError> {
    let seen: Arc<Mutex<Vec<SeenQos>>> = Arc::default();
    let into = Arc::clone(&seen);
    let key = bus.keys().rpc().map_err(BusError::from)?;
    let queryable = bus.session().declare_queryable(key).callback(move |query| {
        into.lock().unwrap_or_else(PoisonError::into_inner).push(SeenQos::from(&query));
        let reply = r#"{"kind":"error","error":"this is a judge"}"#;
        // A client that has gone needs none.
        let _ = query.reply(query.key_expr(), reply).wait();
    });
    let _queryable = queryable.wait().map_err(BusError::from)?;
    let seen = || seen.lock().unwrap_or_else(PoisonError::into_inner).clone();
    until(PATIENCE, || Ok(seen().len() >= 3))?;
    for qos in seen() {
        for rule in ["NCP-PLANE-001", "NCP-TRANS-002"] {
            let is_so = qos == SeenQos::from(Plane::Control.qos());
            rulings.observe(rule, is_so, || format!("a request carries {qos}"));
        }
    }
    Ok(())
}

/// Requests of one session, sent without waiting, are handled in their order: the time of each reply is what all before
/// have run.
fn order(asker: &Asker, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    const REQUESTS: u32 = 12;
    let id = session(target, "a");
    asker.ask(&open(target, &id, None))?;
    let requests = (1..=REQUESTS).map(|number| step(&id, f64::from(number)).encode());
    let requests: Vec<String> = requests.collect::<Result<_, _>>().map_err(BusError::from)?;
    let replies = match asker.ask_in_a_row(&requests) {
        Err(AskError::Unsayable) => {
            rulings.leave_out_unseen(&["NCP-SESS-027", "NCP-SESS-036"]);
            Vec::new()
        }
        replies => replies?,
    };
    let mut run_ms = 0.0;
    for (number, bytes) in (1..=REQUESTS).zip(replies) {
        run_ms += f64::from(number);
        match decode_any(&bytes) {
            Ok(Message::ObservationFrame(ObservationFrame { session_id, sim_time_ms, .. })) if session_id == id => {
                let is_so = (sim_time_ms - run_ms).abs() < 1e-6 * run_ms;
                rulings.observe("NCP-SESS-036", is_so, || {
                    format!(
                        "request {number} of {REQUESTS} was handled at {sim_time_ms} ms, and in order it is {run_ms} ms"
                    )
                });
                rulings.observe("NCP-SESS-027", true, String::new);
            }
            _ => rulings.fail("NCP-SESS-027", format!("request {number} of {REQUESTS} got {}", shown(&bytes))),
        }
    }
    let _ = asker.ask(&close(&id));
    Ok(())
}

/// While a session runs for long, the step of another is answered. The run is made long enough to tell first.
fn side_by_side(target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    const RULE: &str = "NCP-TRANS-007";
    const LONG_MS: f64 = 250.0;
    // A connection each, since one may answer in the order of its requests.
    let [long, short] = [(); 2].map(|()| Asker::connect(target, Duration::from_secs(30)));
    let (long, short) = (long?, short?);
    let (a, b) = (session(target, "a"), session(target, "b"));
    long.ask(&open(target, &a, Some(5_000)))?;
    if short.ask(&open(target, &b, None)).is_err() {
        rulings.unclear(RULE, "the server has room for one session [NCP-SESS-041]");
        let _ = long.ask(&close(&a));
        return Ok(());
    }
    let (duration_ms, took_ms) = long_run(|duration_ms| long.ask(&run(&a, duration_ms)).is_ok(), LONG_MS);
    let mut waited_ms = Vec::new();
    for _ in 0..3 {
        thread::scope(|scope| {
            let running = scope.spawn(|| long.ask(&run(&a, duration_ms)).is_ok());
            thread::sleep(Duration::from_millis(40));
            let began = Instant::now();
            let is_answered = short.ask(&step(&b, 1.0)).is_ok();
            let waited = began.elapsed().as_secs_f64() * 1e3;
            if running.join().unwrap_or_default() && is_answered {
                waited_ms.push(waited);
            }
        });
    }
    let waited = Measured::of(waited_ms, took_ms / 2.0);
    rulings.measured(RULE, waited);
    match waited.filter(|waited| waited.count == 3) {
        None => rulings.unclear(RULE, "a run, or a step beside it, was not answered as it should be"),
        _ if took_ms < LONG_MS => {
            rulings.unclear(RULE, format!("no run took {LONG_MS} ms: the longest took {took_ms:.0} ms"));
        }
        // One that did not wait shows that it need not; a machine that is slow once says nothing.
        Some(waited) => rulings.observe(RULE, waited.min_ms < took_ms / 2.0, || {
            format!("beside a run of {took_ms:.0} ms, the step of another session waited each time: {waited}")
        }),
    }
    let _ = (long.ask(&close(&a)), short.ask(&close(&b)));
    Ok(())
}

/// A run that takes so long, or the longest that is carried out: its time in the simulation, and on the clock, in ms.
fn long_run(mut carries_out: impl FnMut(f64) -> bool, long_ms: f64) -> (f64, f64) {
    let (mut duration_ms, mut took_ms) = (0.0, 0.0);
    let (mut next_ms, mut refused_ms) = (10.0_f64, 20_000.0_f64);
    for _ in 0..16 {
        let began = Instant::now();
        if carries_out(next_ms) {
            (duration_ms, took_ms) = (next_ms, began.elapsed().as_secs_f64() * 1e3);
        } else {
            refused_ms = next_ms;
        }
        if took_ms >= long_ms {
            break;
        }
        let factor = (1.5 * long_ms / took_ms.max(1.0)).clamp(1.5, 8.0);
        let wanted_ms = duration_ms.max(1.0) * factor;
        // A server may carry out no run that is longer than it likes: it is sought what it does.
        next_ms = if wanted_ms < refused_ms { wanted_ms } else { 0.5 * (duration_ms + refused_ms) }.round();
    }
    (duration_ms, took_ms)
}

/// Everybody on the key is asked; one answers.
fn alone(asker: &Asker, rulings: &mut Rulings) -> Result<(), LiveError> {
    let Some(bus) = asker.bus() else {
        // An address is that of one server.
        rulings.leave_out_unseen(&["NCP-SESS-020"]);
        return Ok(());
    };
    // A second server may be slower to be known than the first.
    thread::sleep(Duration::from_millis(200));
    let replies = ask_all(bus, br#"{"kind":"step_request","session_id":"nobody"}"#, Duration::from_secs(1))?;
    let count = replies.iter().filter(|reply| reply.result().is_ok()).count();
    rulings
        .observe("NCP-SESS-020", count == 1, || format!("one request had {count} replies: {count} servers on the key"));
    Ok(())
}

/// Who asks the target, if somebody answers there.
fn asker(target: &Target, longest: Duration, rulings: &mut Rulings) -> Result<Option<Asker>, LiveError> {
    match Asker::connect(target, longest) {
        Err(AskError::Failed(why)) => {
            rulings.all_unclear(&why);
            Ok(None)
        }
        asker => {
            let asker = asker?;
            let is_there = asker.bus().map_or(Ok(true), |bus| has_server(bus, rulings))?;
            Ok(is_there.then_some(asker))
        }
    }
}

/// Waits for somebody to answer; whether anybody does.
pub(super) fn has_server(bus: &Bus, rulings: &mut Rulings) -> Result<bool, LiveError> {
    let is_there =
        until(PATIENCE, || Ok(!ask_all(bus, br#"{"kind":"sensor_frame"}"#, Duration::from_millis(500))?.is_empty()))?;
    if !is_there {
        rulings.all_unclear("nobody answers on the control key");
    }
    Ok(is_there)
}

/// All replies of all servers, until each has answered or the time is up.
fn ask_all(bus: &Bus, request: &[u8], longest: Duration) -> Result<Vec<Reply>, LiveError> {
    let SeenQos { congestion, priority, express } = Plane::Control.qos().into();
    let key = bus.keys().rpc().map_err(BusError::from)?;
    let query = bus.session().get(key).payload(request.to_vec()).target(QueryTarget::All);
    let query = query.consolidation(ConsolidationMode::None).timeout(longest);
    let replies = query.congestion_control(congestion).priority(priority).express(express).wait();
    let replies: Vec<Reply> = replies.map_err(BusError::from)?.into_iter().collect();
    // The end of the time is an error reply of Zenoh's own.
    let is_answer = |reply: &Reply| reply.result().err().is_none_or(|error| &*error.payload().to_bytes() != b"Timeout");
    Ok(replies.into_iter().filter(is_answer).collect())
}

/// Numbers are the same as numbers, `15` and `15.0` too; ids are filled in.
fn same(found: &Value, expected: &Value, ids: &impl Fn(&str) -> String) -> bool {
    match expected {
        Value::Number(expected) => found.as_f64().is_some_and(|found| Some(found) == expected.as_f64()),
        Value::String(expected) => found.as_str().is_some_and(|found| found == ids(expected)),
        expected => found == expected,
    }
}

pub(super) fn session(target: &Target, name: &str) -> String {
    format!("{}-{name}", target.session)
}

fn open(target: &Target, id: &str, neurons: Option<i64>) -> Message {
    let population_sizes = neurons.map_or_else(SortedMap::new, |neurons| SortedMap::from_iter([("pop", neurons)]));
    let network = NetworkRef { reference: target.network.clone().into(), population_sizes, ..NetworkRef::default() };
    let session_id = id.to_owned().into();
    OpenSession { session_id, network, sim: SimConfig::default(), ..OpenSession::default() }.into()
}

pub(super) fn step(id: &str, advance_ms: f64) -> Message {
    let session_id = id.to_owned().into();
    StepRequest { session_id, advance_ms: Some(advance_ms), ..StepRequest::default() }.into()
}

fn run(id: &str, duration_ms: f64) -> Message {
    RunRequest { session_id: id.to_owned().into(), duration_ms, ..RunRequest::default() }.into()
}

fn close(id: &str) -> Message {
    CloseSession { session_id: id.to_owned().into(), ..CloseSession::default() }.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_about_as_long_as_a_server_that_limits_it_carries_out() {
        let mut asked = Vec::new();
        let (duration_ms, _) = long_run(
            |duration_ms| {
                asked.push(duration_ms);
                duration_ms <= 4_000.0
            },
            1e9,
        );
        assert!((3_900.0..=4_000.0).contains(&duration_ms), "{duration_ms} of {asked:?}");
    }

    #[test]
    fn a_server_that_carries_out_no_run_has_none_that_is_long() {
        assert_eq!(long_run(|_| false, 1e9), (0.0, 0.0));
    }
}
