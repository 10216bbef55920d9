//! The schemas and the decoder, two judges of one frame.

use std::sync::LazyLock;

use jsonschema::Validator;
use ncp_spec::wire::{DecodeProblem, Kind, Rule, decode};
use ncp_verifier::json::{Json, JsonFault};
use serde_json::Value;

use crate::frame::split;

/// By kind, in the order of [`Kind::ALL`].
static SCHEMAS: LazyLock<Vec<(Kind, Validator)>> = LazyLock::new(|| {
    let files = ncp_proto::schema::generate();
    Kind::ALL
        .into_iter()
        .map(|kind| {
            let wanted = format!("{kind}.schema.json");
            let (_, text) = files.iter().find(|(name, _)| *name == wanted).expect("a schema a kind");
            let schema: Value = serde_json::from_str(text).expect("a schema is JSON");
            (kind, jsonschema::draft202012::new(&schema).expect("a schema is one"))
        })
        .collect()
});

/// A frame that the decoder reads satisfies the schema of its kind; one that satisfies it and is
/// refused is so for what no schema can say.
///
/// It would find a field that one of the two takes for another type, an absent field that one
/// requires, and a limit that stands in one place only.
// [NCP-WIRE-020] [NCP-WIRE-021] [NCP-WIRE-022] [NCP-WIRE-026] [NCP-WIRE-027] [NCP-WIRE-031]
// [NCP-WIRE-035] [NCP-WIRE-040] [NCP-WIRE-042] [NCP-WIRE-044] [NCP-WIRE-050] [NCP-WIRE-101]
pub fn validate_vs_schema(input: &[u8]) {
    let (kind, frame) = split(input);
    let decoded = decode(kind, frame);
    let Ok(value) = serde_json::from_slice::<Value>(frame) else {
        assert!(decoded.is_err(), "what is no JSON is read");
        return;
    };
    let (_, schema) = SCHEMAS.iter().find(|(of, _)| *of == kind).expect("a schema a kind");
    match (schema.is_valid(&value), decoded) {
        (true, Ok(_)) | (false, Err(_)) => {}
        (false, Ok(_)) => panic!("the decoder reads what its schema refuses"),
        (true, Err(error)) => {
            assert!(beyond_schemas(error.problem()) || has_repeated_name(frame), "the schema lets through: {error}");
        }
    }
}

/// Whether an object has a name twice: a schema sees the last one only, and the decoder may stop at the first.
fn has_repeated_name(frame: &[u8]) -> bool {
    let fault = std::str::from_utf8(frame).map(|text| Json::parse(text).err());
    matches!(fault, Ok(Some(error)) if matches!(error.what, JsonFault::Duplicate(_)))
}

/// Whether a problem is one of `ncp_proto::schema::GAPS`.
fn beyond_schemas(problem: &DecodeProblem) -> bool {
    matches!(
        problem,
        DecodeProblem::Repeated
            | DecodeProblem::LoneSurrogate
            | DecodeProblem::IntegerSpelling
            | DecodeProblem::NumberTooLarge
            | DecodeProblem::TooLong { .. }
            | DecodeProblem::TooDeep
            | DecodeProblem::NotBase64
            | DecodeProblem::Rule(
                Rule::SessionId(ncp_spec::keys::SegmentProblem::TooLong(_))
                    | Rule::StimulusSession
                    | Rule::StimulusVersion
            )
    )
}
