//! What both test programs need.

#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use serde_json::Value;

/// What is wrong with a result file by its schema.
pub(crate) fn schema_faults(result: &Value) -> Vec<String> {
    let text = std::fs::read_to_string("../schemas/result.schema.json").unwrap();
    let schema: Value = serde_json::from_str(&text).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    validator.iter_errors(result).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

/// Reads a result file, which has to be one by its schema.
pub(crate) fn read_result(text: &str) -> Value {
    let result = serde_json::from_str(text).unwrap();
    assert_eq!(schema_faults(&result), Vec::<String>::new());
    result
}
