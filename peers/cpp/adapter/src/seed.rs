//! What the seed's functions can express. A library that offers only those is asked nothing else: what would need a
//! guess is unsupported.

use std::collections::BTreeMap;

use ncp_adapter::CallError;
use ncp_adapter::args::parse;
use ncp_adapter::json::Raw;
use ncp_adapter::value::Double;
use serde_json::Value;

use crate::library::Library;

/// A kind that the seed knows.
///
/// # Errors
/// Unsupported for the error frame, which is none of the contract's messages.
pub(crate) fn kind(kind: &str) -> Result<&str, CallError> {
    if kind == "error" {
        return Err(CallError::Unsupported);
    }
    Ok(kind)
}

/// The frame of these fields, for a function that takes frames.
///
/// # Errors
/// Unsupported if the fields say what no frame says: a number that JSON lacks; or leave out what a program
/// has another default for than the wire.
pub(crate) fn frame(library: &Library, kind: &str, fields: Raw<'_>) -> Result<String, CallError> {
    let members = expressible(fields)?;
    // [NCP-WIRE-038] and the hash, which a program advertises and the wire does not suppose.
    let differs = match kind {
        "command_frame" => Some("mode"),
        "open_session" | "session_opened" => Some("contract_hash"),
        _ => None,
    };
    if differs.is_some_and(|name| !members.contains_key(name)) {
        return Err(CallError::Unsupported);
    }
    let mut frame = format!(r#"{{"kind":"{kind}""#);
    if !members.contains_key("ncp_version") {
        frame += &format!(r#","ncp_version":{}"#, Value::from(library.constant("version")?));
    }
    for (name, value) in members.iter().filter(|(name, _)| *name != "kind") {
        frame += &format!(",{}:{value}", Value::from(name.as_str()));
    }
    Ok(frame + "}")
}

/// The members of an object that holds only what JSON can say.
///
/// # Errors
/// Unsupported if a string in it may stand for a number that JSON lacks.
pub(crate) fn expressible(object: Raw<'_>) -> Result<BTreeMap<String, Raw<'_>>, CallError> {
    fn is_plain(value: &Value) -> bool {
        match value {
            Value::String(text) => Double::from_name(text).is_none(),
            Value::Array(items) => items.iter().all(is_plain),
            Value::Object(members) => members.values().all(is_plain),
            _ => true,
        }
    }

    if !is_plain(&parse(object)?) {
        return Err(CallError::Unsupported);
    }
    parse(object)
}

/// Whether the seed's functions can be given this codec. Nobody says in which form of JSON they read one, so
/// a library that refuses the plainest codec in the form of PROTOCOL.md is not asked for others.
pub(crate) fn codec(library: &Library, codec: Raw<'_>) -> Result<(), CallError> {
    const PLAINEST: &str = concat!(
        r#"{"encoders":[{"channel":"c","component":0,"population":"p","value_range":[-1.0,1.0],"#,
        r#""rate_range":[0.0,200.0]}],"decoders":[]}"#
    );

    let form = if codec.get() == r#""uav""# {
        codec.get()
    } else {
        expressible(codec)?;
        PLAINEST
    };
    let version = Value::from(library.constant("version")?);
    let sensor = format!(
        r#"{{"kind":"sensor_frame","ncp_version":{version},"seq":1,"t":0.0,"frame_id":"world","channels":{{{}}}}}"#,
        r#""c":{"data":[0.0],"unit":null}"#
    );
    match library.encode_rates(form, &sensor) {
        Ok(_) => Ok(()),
        Err(_) => Err(CallError::Unsupported),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;
    use ncp_adapter::json;

    fn raw(text: &str) -> Raw<'_> {
        json::read(text).unwrap()
    }

    #[test]
    fn fields_with_a_number_that_json_lacks_are_unsupported_at_any_depth() {
        for text in [r#"{"t":"NaN"}"#, r#"{"channels":{"c":{"data":[1.0,"-Infinity"]}}}"#, r#"{"a":[[{"b":"-0"}]]}"#] {
            let refused = expressible(raw(text)).unwrap_err();
            assert!(matches!(refused, CallError::Unsupported), "{text}");
        }
        let members = expressible(raw(r#"{"t":1e400,"frame_id":"world","NaN":1}"#));
        assert!(members.is_err(), "a number beyond a double is none that JSON readers share");
        assert_eq!(expressible(raw(r#"{"seq":1,"NaN":2}"#)).unwrap().len(), 2);
    }
}
