//! Expands the templates of a vector file.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::Value;

/// The value with every template in it replaced by its string.
pub(crate) fn expanded(value: &Value) -> Value {
    match value {
        Value::Array(items) => items.iter().map(expanded).collect(),
        Value::Object(members) => match text(value) {
            Some(text) => Value::String(text),
            None => members.iter().map(|(name, value)| (name.clone(), expanded(value))).collect(),
        },
        scalar => scalar.clone(),
    }
}

/// The text that a value stands for, if it is a string or a template.
fn text(value: &Value) -> Option<String> {
    if let Value::String(text) = value {
        return Some(text.clone());
    }
    if let Some(repeated) = value.get("$repeat") {
        let times = usize::try_from(value["times"].as_u64().expect("a count")).unwrap();
        return Some(text(repeated).expect("a text to repeat").repeat(times));
    }
    if let Some(parts) = value.get("$concat") {
        return Some(parts.as_array().expect("parts").iter().map(|part| text(part).expect("a text")).collect());
    }
    let encoded = value.get("$base64")?;
    Some(STANDARD.encode(text(encoded).expect("a text to encode")))
}
