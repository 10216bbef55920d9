//! Access rules: who may do what, judged where it arrives, since a denied put returns success to its sender.

use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use ncp_zenoh::{Bus, BusError, Intake, Link};
use rcgen::{BasicConstraints, CertificateParams, DnType, IsCa, Issuer, KeyPair};
use serde_json::{Value, json};
use zenoh::query::{ConsolidationMode, QueryTarget};
use zenoh::{Config, Wait};

use super::PATIENCE;
use crate::LiveError;
use crate::actors::Planted;
use crate::target::free_endpoint;
use crate::verdict::Rulings;

/// The rules of a deployment, as they are handed out.
const RULES: &str = include_str!("../../../peers/zenoh/deploy/access.json");

/// How long what is denied is waited for, after what is allowed has arrived.
const AFTER: Duration = Duration::from_millis(150);

/// Who comes to the router: those whom its rules know, one of the same authority whom they do not, one of another
/// authority, and one without a certificate.
const IDENTITIES: [&str; 6] = ["commander", "robot", "observer", "stranger", "foreigner", "nobody"];

/// Those whom the rules know.
const KNOWN: [&str; 3] = ["commander", "robot", "observer"];

/// A plane, with who may put on it and who may read it; the first of each is whom the judge sends beside the others.
struct Cell {
    plane: &'static str,
    key: &'static str,
    puts: &'static [&'static str],
    reads: &'static [&'static str],
}

const PLANES: [Cell; 3] = [
    Cell {
        plane: "perception",
        key: "ncp/session/s/sensor/front",
        puts: &["robot"],
        reads: &["commander", "observer"],
    },
    Cell { plane: "action", key: "ncp/session/s/command", puts: &["commander"], reads: &["robot", "observer"] },
    Cell { plane: "observation", key: "ncp/session/s/observation", puts: &["commander"], reads: &["observer"] },
];

/// Starts a router with a throw-away authority, mutual TLS and the rules, and goes through the matrix.
pub(super) fn matrix(planted: &Planted, rulings: &mut Rulings) -> Result<(), LiveError> {
    let folder = tempfile::tempdir()?;
    let folder = folder.path();
    certificates(folder)?;
    let endpoint = free_endpoint("tls")?;
    let mut config = Link::Router(endpoint.clone()).config()?;
    let tls = tls(folder, "router", "listen");
    config.insert_json5("transport/link/tls", &tls).map_err(BusError::from)?;
    config.insert_json5("access_control", &rules(planted)?.to_string()).map_err(BusError::from)?;
    let _router = Bus::with_config(config, None)?;

    let connect =
        |who: &str| -> Result<Bus, LiveError> { Ok(Bus::with_config(client(&endpoint, folder, who)?, None)?) };
    let mut known = Vec::new();
    for who in IDENTITIES {
        match connect(who) {
            Ok(bus) => known.push((who, bus)),
            // Who is not let in puts nothing and reads nothing; whom the rules know has to be let in.
            Err(error) => {
                let rule = if KNOWN.contains(&who) { "NCP-SEC-004" } else { "NCP-SEC-002" };
                rulings.observe(rule, !KNOWN.contains(&who), || format!("{who} is not let in: {error}"));
            }
        }
    }
    // What goes from a session to itself passes by no router: the other end is always a session of its own.
    let mut others = Vec::new();
    for who in KNOWN {
        match connect(who) {
            Ok(bus) => others.push((who, bus)),
            Err(_) => return Ok(()),
        }
    }
    let bus = |who: &str| others.iter().find(|(known, _)| *known == who).map(|(_, bus)| bus);
    for cell in &PLANES {
        let (Some(source), Some(sink)) = (bus(cell.puts[0]), bus(cell.reads[0])) else { continue };
        for (who, own) in &known {
            let arrived = puts(own, source, sink, cell.key)?;
            rule(
                rulings,
                who,
                cell.puts.contains(who),
                arrived,
                &format!("put on the {} plane", cell.plane),
                Act::Puts,
            );
            if cell.plane == "action" {
                let is_so = arrived.is_none_or(|arrived| !arrived || *who == "commander");
                rulings.observe("NCP-SEC-003", is_so, || format!("{who} can put on the action plane"));
            }
            let arrived = reads(own, source, sink, cell.key)?;
            rule(
                rulings,
                who,
                cell.reads.contains(who),
                arrived,
                &format!("read the {} plane", cell.plane),
                Act::Reads,
            );
        }
    }
    let (Some(server), Some(asker)) = (bus("commander"), bus("robot")) else { return Ok(()) };
    for (who, own) in &known {
        let answers = answered(own, asker, who)?;
        rule(rulings, who, *who == "commander", Some(answers), "answer control RPC", Act::Puts);
        let asks = answered(server, own, "commander")?;
        let may = KNOWN.contains(who);
        rule(rulings, who, may, Some(asks), "ask control RPC", Act::Reads);
    }
    Ok(())
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Act {
    Puts,
    Reads,
}

/// What a cell of the matrix says of the rules; `arrived` is none when not even what is allowed arrives.
fn rule(rulings: &mut Rulings, who: &str, may: bool, arrived: Option<bool>, what: &str, act: Act) {
    let Some(arrived) = arrived else {
        return rulings.fail("NCP-SEC-004", format!("nobody can {what}, or nobody gets it"));
    };
    if may {
        rulings.observe("NCP-SEC-004", arrived, || format!("{who} cannot {what}"));
    } else {
        // What no rule lets through is for the default to deny.
        rulings.observe("NCP-SEC-002", !arrived, || format!("{who} can {what}"));
    }
    if who == "observer" && (may || act == Act::Puts) {
        let can = if arrived { "can" } else { "cannot" };
        rulings.observe("NCP-SEC-005", arrived == may, || format!("an observer {can} {what}"));
    }
}

/// Whether what somebody puts arrives at a legitimate reader; none if not even what its legitimate source puts does.
fn puts(own: &Bus, source: &Bus, sink: &Bus, key: &str) -> Result<Option<bool>, LiveError> {
    let intake: Intake<()> = Intake::subscribe(sink, key.to_owned(), 4_096)?;
    let mut has_arrived = false;
    let arrives = exchange(source, key, || {
        put(own, key, "tried")?;
        let mut allowed = false;
        while let Some(arrival) = intake.next() {
            has_arrived |= &*arrival.payload.to_bytes() == b"tried";
            allowed |= &*arrival.payload.to_bytes() == b"allowed";
        }
        Ok(allowed)
    })?;
    thread::sleep(AFTER);
    while let Some(arrival) = intake.next() {
        has_arrived |= &*arrival.payload.to_bytes() == b"tried";
    }
    Ok(arrives.then_some(has_arrived))
}

/// Whether somebody reads what its legitimate source puts; none if not even a legitimate reader does.
fn reads(own: &Bus, source: &Bus, sink: &Bus, key: &str) -> Result<Option<bool>, LiveError> {
    let tries: Intake<()> = Intake::subscribe(own, key.to_owned(), 4_096)?;
    let intake: Intake<()> = Intake::subscribe(sink, key.to_owned(), 4_096)?;
    // A subscription takes its time to be known.
    thread::sleep(AFTER);
    let arrives = exchange(source, key, || Ok(intake.next().is_some()))?;
    thread::sleep(AFTER);
    Ok(arrives.then_some(tries.next().is_some()))
}

/// Lets a legitimate source put until what is allowed has arrived, or patience is at its end.
fn exchange(
    source: &Bus,
    key: &str,
    mut has_arrived: impl FnMut() -> Result<bool, LiveError>,
) -> Result<bool, LiveError> {
    let began = Instant::now();
    while began.elapsed() < PATIENCE / 2 {
        put(source, key, "allowed")?;
        thread::sleep(Duration::from_millis(10));
        if has_arrived()? {
            return Ok(true);
        }
    }
    Ok(false)
}

fn put(bus: &Bus, key: &str, what: &'static str) -> Result<(), LiveError> {
    Ok(bus.session().put(key, what).wait().map_err(BusError::from)?)
}

/// Whether a reply of one comes to another who asks everybody.
fn answered(server: &Bus, asker: &Bus, who: &str) -> Result<bool, LiveError> {
    const KEY: &str = "ncp/rpc";
    let name = who.to_owned();
    let asked = Arc::new(Mutex::new(0_u32));
    let count = Arc::clone(&asked);
    let queryable = server.session().declare_queryable(KEY).callback(move |query| {
        *count.lock().unwrap_or_else(PoisonError::into_inner) += 1;
        // Whether it comes through is what is judged.
        let _ = query.reply(KEY, name.clone()).wait();
    });
    let _queryable = queryable.wait().map_err(BusError::from)?;
    let began = Instant::now();
    // A queryable takes its time to be known; one that is denied never is.
    while began.elapsed() < Duration::from_millis(600) {
        let query = asker.session().get(KEY).target(QueryTarget::All).consolidation(ConsolidationMode::None);
        let replies = query.timeout(Duration::from_millis(200)).wait().map_err(BusError::from)?;
        if replies
            .into_iter()
            .any(|reply| reply.result().is_ok_and(|reply| reply.payload().to_bytes() == who.as_bytes()))
        {
            return Ok(true);
        }
        thread::sleep(Duration::from_millis(50));
    }
    Ok(false)
}

/// The rules, with the defect that is planted in them.
fn rules(planted: &Planted) -> Result<Value, LiveError> {
    let mut rules: Value = serde_json::from_str(RULES)?;
    let policy = |rules: &mut Value, of: usize, change: &dyn Fn(&mut Vec<Value>)| {
        if let Some(list) = rules.pointer_mut(&format!("/policies/{of}/rules")).and_then(Value::as_array_mut) {
            change(list);
        }
    };
    let [commander, robot, observer] = [0, 1, 2];
    let without = |name: &'static str| move |list: &mut Vec<Value>| list.retain(|rule| rule != name);
    let with = |name: &'static str| move |list: &mut Vec<Value>| list.push(json!(name));
    if planted.is("acl-allows-by-default") {
        rules["default_permission"] = json!("allow");
    }
    if planted.is("acl-knows-everybody") {
        rules["subjects"][robot] = json!({ "id": "robot" });
    }
    if planted.is("acl-robot-commands") {
        policy(&mut rules, robot, &with("puts commands and observations"));
    }
    if planted.is("acl-observer-senses") {
        policy(&mut rules, observer, &with("puts sensors"));
    }
    if planted.is("acl-observer-blind") {
        policy(&mut rules, observer, &without("gets observations"));
    }
    if planted.is("acl-no-delivery") {
        policy(&mut rules, commander, &without("gets sensors"));
    }
    if planted.is("acl-server-not-asked") {
        policy(&mut rules, commander, &without("is asked"));
    }
    if planted.is("acl-server-silent") {
        policy(&mut rules, commander, &without("answers"));
    }
    Ok(rules)
}

/// A certificate for each, of a throw-away authority; that of the foreigner is of another, which nobody trusts.
fn certificates(folder: &Path) -> Result<(), LiveError> {
    let authority = |name: &str| -> Result<(Issuer<'static, KeyPair>, String), rcgen::Error> {
        let mut params = CertificateParams::new(Vec::<String>::new())?;
        params.is_ca = IsCa::Ca(BasicConstraints::Unconstrained);
        params.distinguished_name.push(DnType::CommonName, name);
        let key = KeyPair::generate()?;
        let pem = params.self_signed(&key)?.pem();
        Ok((Issuer::new(params, key), pem))
    };
    let (own, pem) = authority("throw-away authority")?;
    let (other, _) = authority("another authority")?;
    fs::write(folder.join("authority.pem"), pem)?;
    for name in ["router", "commander", "robot", "observer", "stranger", "foreigner"] {
        let mut params = CertificateParams::new(["localhost", "127.0.0.1"].map(str::to_owned))?;
        // A foreigner says that he is the commander.
        params.distinguished_name.push(DnType::CommonName, if name == "foreigner" { "commander" } else { name });
        let key = KeyPair::generate()?;
        let issuer = if name == "foreigner" { &other } else { &own };
        fs::write(folder.join(format!("{name}.pem")), params.signed_by(&key, issuer)?.pem())?;
        fs::write(folder.join(format!("{name}.key")), key.serialize_pem())?;
    }
    Ok(())
}

/// Zenoh's configuration of one who connects.
fn client(endpoint: &str, folder: &Path, who: &str) -> Result<Config, LiveError> {
    let mut config = Link::Connect(endpoint.to_owned()).config()?;
    config.insert_json5("transport/link/tls", &tls(folder, who, "connect")).map_err(BusError::from)?;
    config.insert_json5("connect/timeout_ms", "3000").map_err(BusError::from)?;
    Ok(config)
}

fn tls(folder: &Path, who: &str, side: &str) -> String {
    let file = |name: String| folder.join(name).to_string_lossy().into_owned();
    let mut tls = json!({ "root_ca_certificate": file("authority.pem".to_owned()) });
    if who != "nobody" {
        tls["enable_mtls"] = json!(true);
        tls[format!("{side}_certificate")] = json!(file(format!("{who}.pem")));
        tls[format!("{side}_private_key")] = json!(file(format!("{who}.key")));
    }
    tls.to_string()
}
