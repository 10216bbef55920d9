//! The access rules of a deployment as they are handed out, and what goes wrong in such rules.

use serde_json::{Value, json};

use crate::LiveError;
use crate::actors::Planted;

/// The rules.
pub(super) const RULES: &str = include_str!("../../../../peers/zenoh/deploy/access.json");

/// The rules, with the defect that is planted in them.
pub(super) fn rules(planted: &Planted) -> Result<Value, LiveError> {
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
