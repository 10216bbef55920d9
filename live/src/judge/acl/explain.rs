//! Which rule of the access file lets a cell of the matrix through, or stops it, and on which flow.
//!
//! A message passes the router twice, in from its sender and out to its receiver, and each time the rules of that peer
//! decide: what a rule of it denies is denied, then what one allows is allowed, and else the default holds. A rule is
//! about a key when one of its expressions includes it.

use std::fmt;

use ncp_zenoh::BusError;
use serde::Deserialize;
use thiserror::Error;
use zenoh::Config;
use zenoh::key_expr::keyexpr;

use super::cell::{Act, Cell};
use crate::LiveError;

/// Why access rules cannot be explained.
#[derive(Debug, Error)]
pub(crate) enum RulesError {
    /// They are no access rules of Zenoh's.
    #[error("the access rules: {0}")]
    Rules(BusError),
    /// There is no such cell.
    #[error(
        "there is no cell {0:?}; it is who/act/plane, such as robot/puts/action or observer/asks/control, or `all`"
    )]
    Cell(String),
}

/// Zenoh's `access_control`.
#[derive(Debug, Deserialize)]
struct Rules {
    enabled: bool,
    default_permission: Permission,
    rules: Option<Vec<Rule>>,
    subjects: Option<Vec<Subject>>,
    policies: Option<Vec<Policy>>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Permission {
    Allow,
    Deny,
}

#[derive(Debug, Deserialize)]
struct Rule {
    id: String,
    permission: Permission,
    flows: Option<Vec<Flow>>,
    messages: Vec<String>,
    key_exprs: Vec<String>,
}

#[derive(Debug, Deserialize)]
struct Subject {
    id: String,
    cert_common_names: Option<Vec<String>>,
}

#[derive(Debug, Deserialize)]
struct Policy {
    rules: Vec<String>,
    subjects: Vec<String>,
}

/// A direction, as the router sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Flow {
    Ingress,
    Egress,
}

/// A message at the router: whose rules decide on it, in which direction, and what it is.
#[derive(Debug, Clone, Copy)]
struct Passage<'a> {
    whose: &'a str,
    flow: Flow,
    message: &'static str,
}

/// What the rules make of it.
#[derive(Debug, PartialEq, Eq)]
struct Decided {
    is_allowed: bool,
    by: By,
}

#[derive(Debug, PartialEq, Eq)]
enum By {
    /// A rule, by its id.
    Rule(String),
    /// No rule of the peer is about it, so the default decides.
    Default,
    /// No subject is this peer, so the default decides.
    Stranger,
    /// The rules are switched off.
    Off,
}

/// Explains one cell, or all; whether each is as the text has it.
///
/// # Errors
/// The rules are none, or there is no such cell.
pub(super) fn show(rules: &str, which: &str) -> Result<bool, LiveError> {
    let rules = Rules::parse(rules)?;
    let cells: Vec<Cell> = Cell::all().into_iter().filter(|cell| which == "all" || cell.to_string() == which).collect();
    if cells.is_empty() {
        return Err(RulesError::Cell(which.to_owned()).into());
    }
    let mut is_right = true;
    for cell in cells {
        let decided = rules.explain(&cell);
        let passes = decided.iter().all(|(_, decided)| decided.is_allowed);
        let wrong = match (passes, cell.may()) {
            (true, false) => "  WRONG: the text denies it",
            (false, true) => "  WRONG: the text allows it",
            _ => "",
        };
        is_right &= wrong.is_empty();
        println!("{cell}: {}{wrong}", if passes { "let through" } else { "stopped" });
        for (Passage { whose, flow, message }, Decided { is_allowed, by }) in decided {
            let verb = if is_allowed { "allowed" } else { "DENIED" };
            println!("  {flow:8} {message:18} {} {whose:10} {verb:8} by {by}", flow.preposition());
        }
    }
    Ok(is_right)
}

/// The rules as Zenoh reads them, alone, as JSON.
///
/// # Errors
/// Zenoh does not read them.
pub(super) fn normal(text: &str) -> Result<String, LiveError> {
    let of_zenoh = |error: zenoh::Error| RulesError::Rules(error.into());
    let mut config = Config::default();
    if config.insert_json5("access_control", text).is_err() {
        config = Config::from_json5(text).map_err(of_zenoh)?;
    }
    let found = config.get_json("access_control");
    Ok(found.map_err(|error| of_zenoh(error.to_string().into()))?)
}

impl Rules {
    fn parse(text: &str) -> Result<Self, LiveError> {
        Ok(serde_json::from_str(&normal(text)?)?)
    }

    /// The messages of a cell in their order, and what is made of each, up to the first that is denied.
    fn explain<'a>(&self, cell: &Cell<'a>) -> Vec<(Passage<'a>, Decided)> {
        let mut decided = Vec::new();
        for passage in passages(cell) {
            let one = self.decide(passage, cell.plane.key);
            let is_allowed = one.is_allowed;
            decided.push((passage, one));
            if !is_allowed {
                break;
            }
        }
        decided
    }

    fn decide(&self, Passage { whose, flow, message }: Passage<'_>, key: &str) -> Decided {
        if !self.enabled {
            return Decided { is_allowed: true, by: By::Off };
        }
        let default = self.default_permission == Permission::Allow;
        let (rules, subjects) =
            (self.rules.as_deref().unwrap_or_default(), self.subjects.as_deref().unwrap_or_default());
        // A subject without names is everybody.
        let is_meant = |subject: &&Subject| {
            subject.cert_common_names.as_ref().is_none_or(|names| names.iter().any(|n| n == whose))
        };
        let mut decided = Decided { is_allowed: default, by: By::Stranger };
        for subject in subjects.iter().filter(is_meant) {
            let policies = self.policies.as_deref().unwrap_or_default().iter();
            let of_subject = policies.filter(|policy| policy.subjects.contains(&subject.id));
            let ids: Vec<&String> = of_subject.flat_map(|policy| &policy.rules).collect();
            let about = |permission| {
                rules.iter().find(|rule| {
                    rule.permission == permission && ids.contains(&&rule.id) && rule.is_about(flow, message, key)
                })
            };
            decided = match (about(Permission::Deny), about(Permission::Allow)) {
                (Some(rule), _) => Decided { is_allowed: false, by: By::Rule(rule.id.clone()) },
                (None, Some(rule)) => Decided { is_allowed: true, by: By::Rule(rule.id.clone()) },
                (None, None) => Decided { is_allowed: default, by: By::Default },
            };
            if decided.is_allowed {
                break;
            }
        }
        decided
    }
}

impl Rule {
    fn is_about(&self, flow: Flow, message: &str, key: &str) -> bool {
        let includes = |pattern: &String| match (keyexpr::new(pattern.as_str()), keyexpr::new(key)) {
            (Ok(pattern), Ok(key)) => pattern.includes(key),
            _ => false,
        };
        self.flows.as_ref().is_none_or(|flows| flows.contains(&flow))
            && self.messages.iter().any(|known| known == message)
            && self.key_exprs.iter().any(includes)
    }
}

/// What passes the router for a cell, in its order. The other end is who legitimately is there.
fn passages<'a>(cell: &Cell<'a>) -> Vec<Passage<'a>> {
    let (into, out) = (Flow::Ingress, Flow::Egress);
    let (own, source, sink) = (cell.who, cell.plane.source(), cell.plane.sink());
    let published =
        |from: &'a str, to: &'a str| vec![(to, into, "declare_subscriber"), (from, into, "put"), (to, out, "put")];
    let asked = |from: &'a str, to: &'a str| {
        vec![
            (to, into, "declare_queryable"),
            (from, into, "query"),
            (to, out, "query"),
            (to, into, "reply"),
            (from, out, "reply"),
        ]
    };
    let passages = match cell.act {
        Act::Puts => published(own, sink),
        Act::Reads => published(source, own),
        Act::Answers => asked("robot", own),
        Act::Asks => asked(own, source),
    };
    passages.into_iter().map(|(whose, flow, message)| Passage { whose, flow, message }).collect()
}

impl Flow {
    const fn preposition(self) -> &'static str {
        match self {
            Self::Ingress => "from",
            Self::Egress => "to  ",
        }
    }
}

impl fmt::Display for Flow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(if *self == Self::Ingress { "ingress" } else { "egress" })
    }
}

impl fmt::Display for By {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rule(id) => write!(f, "the rule {id:?}"),
            Self::Default => f.write_str("the default: no rule of this subject is about it"),
            Self::Stranger => f.write_str("the default: no subject has this name"),
            Self::Off => f.write_str("nobody: the rules are not enabled"),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::actors::Planted;
    use crate::judge::acl::{own, planted};
    use crate::verdict::Rulings;

    fn planted(defect: Option<&str>) -> String {
        planted::rules(&Planted(defect.map(str::to_owned))).unwrap().to_string()
    }

    fn cell(name: &str) -> Cell<'static> {
        Cell::all().into_iter().find(|cell| cell.to_string() == name).unwrap()
    }

    /// What decides on a cell: the last message that is looked at.
    fn decided(rules: &str, name: &str) -> (Flow, bool, By) {
        let (passage, decided) = Rules::parse(rules).unwrap().explain(&cell(name)).pop().unwrap();
        (passage.flow, decided.is_allowed, decided.by)
    }

    #[test]
    fn the_explanation_says_what_the_router_does_with_the_rules_and_with_a_defect_in_either_flow() {
        let defects = ["acl-no-delivery", "acl-robot-commands", "acl-server-silent", "acl-allows-by-default"];
        for defect in [None].into_iter().chain(defects.map(Some)) {
            let text = planted(defect);
            let rules = Rules::parse(&text).unwrap();
            let mut arrived = BTreeMap::new();
            own(&text, &mut Rulings::new(&[]), |cell, found| {
                arrived.insert(cell.to_string(), found);
            })
            .unwrap();
            for cell in Cell::all() {
                let passes = rules.explain(&cell).iter().all(|(_, decided)| decided.is_allowed);
                // Where not even what is allowed arrives, the router says nothing of the others.
                let Some(found) = arrived[&cell.to_string()] else { continue };
                assert_eq!(passes, found, "{defect:?}: {cell}");
            }
        }
    }

    #[test]
    fn the_rules_as_they_are_handed_out_are_as_the_text_has_them() {
        assert!(show(planted::RULES, "all").unwrap());
        assert!(!show(&planted(Some("acl-robot-commands")), "all").unwrap());
        assert!(show(planted::RULES, "robot/flies/action").is_err());
    }

    #[test]
    fn a_cell_names_the_rule_and_the_flow() {
        let rule = |id: &str| By::Rule(id.to_owned());
        let sound = planted(None);
        assert_eq!(decided(&sound, "robot/puts/perception"), (Flow::Egress, true, rule("gets sensors")));
        assert_eq!(decided(&sound, "robot/puts/action"), (Flow::Ingress, false, By::Default));
        assert_eq!(decided(&sound, "stranger/asks/control"), (Flow::Ingress, false, By::Stranger));
        let undelivered = planted(Some("acl-no-delivery"));
        assert_eq!(decided(&undelivered, "commander/reads/perception"), (Flow::Egress, false, By::Default));
    }

    #[test]
    fn rules_are_read_alone_or_within_a_configuration_and_what_are_none_is_refused() {
        let within = format!("{{ mode: \"router\", access_control: {} }}", planted::RULES);
        assert_eq!(normal(&within).unwrap(), normal(planted::RULES).unwrap());
        let unknown = planted::RULES.replace("\"query\"", "\"get\"");
        assert!(matches!(normal(&unknown), Err(LiveError::Rules(_))));
        assert!(normal("{").is_err());
    }

    #[test]
    fn a_rule_that_denies_goes_before_one_that_allows() {
        let mut rules = Rules::parse(planted::RULES).unwrap();
        for rule in rules.rules.iter_mut().flatten().filter(|rule| rule.id == "puts sensors") {
            rule.permission = Permission::Deny;
        }
        let (_, decided) = rules.explain(&cell("robot/puts/perception")).pop().unwrap();
        assert_eq!(decided, Decided { is_allowed: false, by: By::Rule("puts sensors".to_owned()) });
    }
}
