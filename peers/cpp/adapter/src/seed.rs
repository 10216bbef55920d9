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

/// A codec in the form of JSON that every published build reads. What the protocol leaves out is left out, so that
/// the build's own defaults are on trial.
///
/// # Errors
/// Unsupported for a number that JSON lacks.
pub(crate) fn codec(codec: Raw<'_>) -> Result<String, CallError> {
    #[derive(serde::Deserialize)]
    struct Codec<'a> {
        #[serde(borrow, default)]
        encoders: Vec<Mapping<'a>>,
        #[serde(borrow, default)]
        decoders: Vec<Mapping<'a>>,
    }

    #[derive(serde::Deserialize)]
    struct Mapping<'a> {
        #[serde(borrow)]
        channel: Raw<'a>,
        component: Option<Raw<'a>>,
        population: Raw<'a>,
        value_range: Option<Raw<'a>>,
        rate_range: Option<Raw<'a>>,
        unit: Option<Raw<'a>>,
    }

    fn side(mappings: &[Mapping<'_>], channel: &str) -> String {
        let shown = mappings.iter().map(|mapping| {
            let mut members = vec![(channel, mapping.channel), ("population", mapping.population)];
            let optional = [
                ("component", mapping.component),
                ("value_range", mapping.value_range),
                ("rate_range_hz", mapping.rate_range),
                ("unit", mapping.unit),
            ];
            members.extend(optional.into_iter().filter_map(|(name, value)| Some((name, value?))));
            let members: Vec<String> = members.iter().map(|(name, value)| format!("\"{name}\":{value}")).collect();
            format!("{{{}}}", members.join(","))
        });
        format!("[{}]", shown.collect::<Vec<_>>().join(","))
    }

    if codec.get() == r#""uav""# {
        return Ok(uav());
    }
    expressible(codec)?;
    let Codec { encoders, decoders } = parse(codec)?;
    Ok(published(&side(&encoders, "channel"), &side(&decoders, "command_channel")))
}

fn published(encoder: &str, decoder: &str) -> String {
    format!(r#"{{"codec_id":"ncp.codec.rate.v0","encoder":{encoder},"decoder":{decoder}}}"#)
}

/// The default UAV codec, as chapter 9 of the text has it.
fn uav() -> String {
    let side = |mapping: fn((usize, char)) -> String| {
        format!("[{}]", "xyz".chars().enumerate().map(mapping).collect::<Vec<_>>().join(","))
    };
    const RANGE: &str = r#""unit":"m/s","value_range":[-1.5,1.5]"#;
    let encoder = side(|(component, axis)| {
        format!(
            r#"{{"channel":"pose_error","component":{component},"population":"err_{axis}","value_range":[-2.0,2.0]}}"#
        )
    });
    let decoder = side(|(component, axis)| {
        format!(
            r#"{{"population":"vel_{axis}","command_channel":"velocity_setpoint","component":{component},{RANGE}}}"#
        )
    });
    published(&encoder, &decoder)
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

    #[test]
    fn a_codec_goes_in_the_form_that_every_published_build_reads() {
        let own = r#"{"encoders":[{"channel":"c","component":1,"population":"p","rate_range":[0.5,9]}],
            "decoders":[{"channel":"d","component":0,"population":"q","value_range":[1,2],"unit":"m/s"}]}"#;
        let expected = concat!(
            r#"{"codec_id":"ncp.codec.rate.v0","#,
            r#""encoder":[{"channel":"c","population":"p","component":1,"rate_range_hz":[0.5,9]}],"#,
            r#""decoder":[{"command_channel":"d","population":"q","component":0,"value_range":[1,2],"unit":"m/s"}]}"#,
        );
        assert_eq!(codec(raw(own)).unwrap(), expected);
        let uav: Value = json::read(&codec(raw(r#""uav""#)).unwrap()).unwrap();
        assert_eq!((&uav["encoder"][2]["population"], &uav["decoder"][1]["component"]), (&"err_z".into(), &1.into()));
        let infinite = r#"{"encoders":[{"channel":"c","component":1,"population":"p","rate_range":[0,"Infinity"]}],
            "decoders":[]}"#;
        assert!(matches!(codec(raw(infinite)), Err(CallError::Unsupported)));
    }
}
