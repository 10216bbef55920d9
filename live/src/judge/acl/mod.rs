//! Access rules: who may do what, judged where it arrives, since a denied put returns success to its sender.
//!
//! | module | what it holds |
//! |---|---|
//! | [`cell`] | the matrix: identity, act and plane |
//! | [`traffic`] | whether what a cell tries arrives |
//! | [`explain`] | which rule of the access file lets a cell through or stops it |
//! | [`credentials`] | certificates: throw-away ones, or a deployment's own |
//! | [`planted`] | the rules as they are handed out, and what goes wrong in such rules |

mod cell;
mod credentials;
mod explain;
mod planted;
mod traffic;

use std::path::PathBuf;

use clap::Args;
use ncp_text::Catalogue;
use ncp_zenoh::Bus;

use crate::actors::Planted;
use crate::target::free_endpoint;
use crate::verdict::Rulings;
use crate::{LiveError, finish};
use cell::{Act, Cell, IDENTITIES, KNOWN, PLANES, RPC};
use credentials::Credentials;
pub(crate) use explain::RulesError;

/// The scenario that goes through the matrix.
const SCENARIO: &str = "acl/matrix";

/// Which access rules are judged, or explained.
#[derive(Debug, Args)]
pub(crate) struct Acl {
    /// A router of a deployment, such as `tls/192.168.1.4:7447` [default: one of one's own, on loopback]
    #[arg(long, value_name = "ENDPOINT", requires_all = ["ca", "certs"])]
    connect: Option<String>,
    /// The certificate of the deployment's authority
    #[arg(long, value_name = "FILE", requires = "connect")]
    ca: Option<PathBuf>,
    /// Where {commander,robot,observer,stranger}.{pem,key} are
    #[arg(long, value_name = "DIR", requires = "connect")]
    certs: Option<PathBuf>,
    /// The access rules (JSON5), alone or within a configuration of Zenoh's [default: those of peers/zenoh/deploy]
    #[arg(long, value_name = "FILE")]
    rules: Option<PathBuf>,
    /// Say which rule lets a cell through or stops it, such as `robot/puts/action`, or `all` cells; nothing is started
    #[arg(long, value_name = "CELL", conflicts_with = "connect")]
    explain: Option<String>,
    /// Write every verdict as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Goes through the matrix, or explains it; whether nothing failed.
///
/// # Errors
/// The rules are none, a certificate is missing, or nobody listens.
pub(crate) fn run(acl: &Acl) -> Result<bool, LiveError> {
    let rules = match &acl.rules {
        Some(path) => std::fs::read_to_string(path)?,
        None => planted::RULES.to_owned(),
    };
    if let Some(which) = &acl.explain {
        return explain::show(&rules, which);
    }
    let scenarios = crate::scenario::scenarios()?;
    let of_matrix = scenarios.into_iter().find(|scenario| scenario.name == SCENARIO);
    let mut rulings = Rulings::new(&of_matrix.map(|scenario| scenario.rules).unwrap_or_default());
    let show = |cell: &Cell, arrived: Option<bool>| {
        let may = if cell.may() { "may" } else { "may not" };
        let does = match arrived {
            Some(true) => "does",
            Some(false) => "does not",
            None => "cannot be told, since nobody can",
        };
        let wrong = if arrived == Some(cell.may()) { "" } else { "  WRONG" };
        println!("{:34} {may:8} {does}{wrong}", cell.to_string());
    };
    match (&acl.connect, &acl.ca, &acl.certs) {
        (Some(endpoint), Some(ca), Some(certs)) => {
            let credentials = Credentials { authority: ca.clone(), folder: certs.clone() };
            if let Some(who) = KNOWN.iter().find(|who| !credentials.has(who)) {
                return Err(LiveError::Unknown(format!("{who}.pem")));
            }
            walk(endpoint, &credentials, &mut rulings, show)?;
        }
        _ => own(&explain::normal(&rules)?, &mut rulings, show)?,
    }
    let catalogue = Catalogue::load()?;
    let sentence = |rule: &str| catalogue.get(rule).map(|rule| rule.sentence.clone()).unwrap_or_default();
    println!();
    finish(&rulings.verdicts(SCENARIO, sentence), acl.json.as_deref())
}

/// Goes through the matrix with the rules as they are handed out, and a defect.
pub(super) fn matrix(planted: &Planted, rulings: &mut Rulings) -> Result<(), LiveError> {
    own(&planted::rules(planted)?.to_string(), rulings, |_, _| ())
}

/// Starts a router with a throw-away authority, mutual TLS and rules, and goes through the matrix.
fn own(rules: &str, rulings: &mut Rulings, show: impl FnMut(&Cell, Option<bool>)) -> Result<(), LiveError> {
    let folder = tempfile::tempdir()?;
    let credentials = Credentials::throw_away(folder.path())?;
    let endpoint = free_endpoint("tls")?;
    let _router = Bus::with_config(credentials.router(&endpoint, rules)?, None)?;
    walk(&endpoint, &credentials, rulings, show)
}

/// Goes through the matrix at a router, as everybody for whom there is a certificate.
fn walk(
    endpoint: &str,
    credentials: &Credentials,
    rulings: &mut Rulings,
    mut show: impl FnMut(&Cell, Option<bool>),
) -> Result<(), LiveError> {
    let connect =
        |who: &str| -> Result<Bus, LiveError> { Ok(Bus::with_config(credentials.client(endpoint, who)?, None)?) };
    let mut known = Vec::new();
    for who in IDENTITIES.into_iter().filter(|who| credentials.has(who)) {
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
    for plane in &PLANES {
        let (Some(source), Some(sink)) = (bus(plane.source()), bus(plane.sink())) else { continue };
        for &(who, ref own) in &known {
            for act in [Act::Puts, Act::Reads] {
                let arrived = match act {
                    Act::Puts => traffic::puts(own, source, sink, plane.key)?,
                    _ => traffic::reads(own, source, sink, plane.key)?,
                };
                tell(&Cell { who, act, plane }, arrived, rulings, &mut show);
            }
        }
    }
    let (Some(server), Some(asker)) = (bus(RPC.source()), bus("robot")) else { return Ok(()) };
    for &(who, ref own) in &known {
        let answers = traffic::answered(own, asker, who)?;
        tell(&Cell { who, act: Act::Answers, plane: &RPC }, Some(answers), rulings, &mut show);
        let asks = traffic::answered(server, own, "commander")?;
        tell(&Cell { who, act: Act::Asks, plane: &RPC }, Some(asks), rulings, &mut show);
    }
    Ok(())
}

/// What a cell of the matrix says of the rules; `arrived` is none when not even what is allowed arrives.
fn tell(cell: &Cell<'_>, arrived: Option<bool>, rulings: &mut Rulings, show: &mut impl FnMut(&Cell, Option<bool>)) {
    show(cell, arrived);
    let (Cell { who, act, plane }, may) = (cell, cell.may());
    let what = format!("{} {}", act.verb(), plane.what);
    let Some(arrived) = arrived else {
        return rulings.fail("NCP-SEC-004", format!("nobody can {what}, or nobody gets it"));
    };
    if may {
        rulings.observe("NCP-SEC-004", arrived, || format!("{who} cannot {what}"));
    } else {
        // What no rule lets through is for the default to deny.
        rulings.observe("NCP-SEC-002", !arrived, || format!("{who} can {what}"));
    }
    if *act == Act::Puts && plane.name == "action" {
        let is_so = !arrived || *who == "commander";
        rulings.observe("NCP-SEC-003", is_so, || format!("{who} can {what}"));
    }
    if *who == "observer" && (may || matches!(act, Act::Puts | Act::Answers)) {
        let can = if arrived { "can" } else { "cannot" };
        rulings.observe("NCP-SEC-005", arrived == may, || format!("an observer {can} {what}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_deployment(endpoint: &str, certs: &std::path::Path) -> Acl {
        let ca = Some(certs.join("authority.pem"));
        Acl {
            connect: Some(endpoint.to_owned()),
            ca,
            certs: Some(certs.to_owned()),
            rules: None,
            explain: None,
            json: None,
        }
    }

    #[test]
    fn a_router_of_somebody_else_is_judged_with_its_own_certificates() {
        let folder = tempfile::tempdir().unwrap();
        let credentials = Credentials::throw_away(folder.path()).unwrap();
        for (defect, is_right) in [(None, true), (Some("acl-robot-commands".to_owned()), false)] {
            let endpoint = free_endpoint("tls").unwrap();
            let rules = planted::rules(&Planted(defect)).unwrap().to_string();
            let _router = Bus::with_config(credentials.router(&endpoint, &rules).unwrap(), None).unwrap();
            assert_eq!(run(&of_deployment(&endpoint, folder.path())).unwrap(), is_right);
        }
    }

    #[test]
    fn a_certificate_that_is_missing_is_said() {
        let folder = tempfile::tempdir().unwrap();
        let missing = run(&of_deployment("tls/127.0.0.1:1", folder.path()));
        assert!(matches!(missing, Err(LiveError::Unknown(file)) if file == "commander.pem"));
    }
}
