//! The schemas against the golden corpus: each vector file satisfies its schema, and each frame in
//! it is judged by the schema of its kind as the case expects, but for what no schema can say.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

use base64::{Engine as _, engine::general_purpose::STANDARD};
use jsonschema::Validator;
use ncp_proto::schema::{gap, generate};
use serde_json::Value;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// A frame beyond this is left to decoders: its cases are about its bytes, which a schema does not
/// see.
const MOST_BYTES: usize = 2 << 20;

#[test]
fn every_vector_file_satisfies_its_schema() {
    let schema = fs::read_to_string(Path::new(ROOT).join("schemas/vector-file.schema.json")).unwrap();
    let validator = validator(&schema);
    let mut wrong = String::new();
    let files = vector_files();
    assert!(files.len() >= 5, "{} vector files", files.len());
    for (path, file) in files {
        for error in validator.iter_errors(&file).take(5) {
            wrong += &format!("{}, at {}: {}\n", path.display(), error.instance_path(), brief(&error.to_string()));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn the_schema_of_its_kind_judges_every_frame_of_the_corpus_as_the_case_expects() {
    let schemas: BTreeMap<_, _> =
        generate().into_iter().map(|(name, text)| (name.replace(".schema.json", ""), validator(&text))).collect();
    let mut judged = [0, 0];
    let mut wrong = String::new();
    for (_, file) in vector_files() {
        for case in file["cases"].as_array().unwrap().iter().filter(|case| case["call"] == "decode") {
            let Some(frame) = frame(&case["args"]) else {
                continue;
            };
            let schema = &schemas[case["args"]["kind"].as_str().unwrap()];
            // What is no JSON text never reaches a schema, and so is rejected before.
            let valid = serde_json::from_slice::<Value>(&frame).is_ok_and(|frame| schema.is_valid(&frame));
            let rejected = case["expect"].get("reject").is_some();
            let requirements = case["requirements"].as_array().unwrap();
            let beyond = requirements.iter().any(|id| gap(id.as_str().unwrap()).is_some());
            // The schemas are those of frames for which no strict profile is agreed upon.
            let strict = case["args"]["strict"] == true;
            if rejected && (beyond || strict) {
                continue;
            }
            // A case that leaves a refusal open says nothing against one.
            if !valid && case["expect"]["or_reject"] == true {
                continue;
            }
            judged[usize::from(valid)] += 1;
            if valid == rejected {
                wrong += &format!(
                    "{}: valid {valid}, rejected {rejected}\n  {}\n",
                    case["id"],
                    brief(&String::from_utf8_lossy(&frame))
                );
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(judged.iter().all(|count| *count >= 150), "[invalid, valid] frames: {judged:?}");
}

fn vector_files() -> Vec<(PathBuf, Value)> {
    let areas = fs::read_dir(Path::new(ROOT).join("vectors/corpus")).unwrap().map(|entry| entry.unwrap().path());
    let files = areas.filter(|path| path.is_dir()).flat_map(|area| fs::read_dir(area).unwrap());
    let paths = files
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"));
    paths
        .map(|path| {
            (
                path.clone(),
                serde_json::from_slice(&fs::read(&path).unwrap())
                    .unwrap_or_else(|error| panic!("{}: {error}", path.display())),
            )
        })
        .collect()
}

#[test]
fn a_template_stands_for_the_text_that_the_runner_makes_of_it() {
    let template = serde_json::json!({"$concat": [
        {"$repeat": "ab", "times": 2},
        {"$count": ["<", ">"], "times": 3},
        {"$base64": "any"},
    ]});
    assert_eq!(expand(&template).unwrap(), "abab<0><1><2>YW55");
}

/// The bytes of a decode call, unless there are too many.
fn frame(args: &Value) -> Option<Vec<u8>> {
    if let Some(text) = args.get("text") {
        return expand(text).map(String::into_bytes);
    }
    Some(STANDARD.decode(expand(&args["base64"])?).unwrap())
}

/// A text or template, unless it is too long.
fn expand(text: &Value) -> Option<String> {
    let expanded = if let Some(text) = text.as_str() {
        text.to_owned()
    } else if let Some(part) = text.get("$repeat") {
        let (part, times) = (part.as_str().unwrap(), usize::try_from(text["times"].as_u64().unwrap()).unwrap());
        if part.len().checked_mul(times)? > MOST_BYTES {
            return None;
        }
        part.repeat(times)
    } else if let Some(around) = text.get("$count") {
        let [before, after] = [0, 1].map(|place| around[place].as_str().unwrap());
        let times = usize::try_from(text["times"].as_u64().unwrap()).unwrap();
        if (before.len() + after.len() + 20).checked_mul(times)? > MOST_BYTES {
            return None;
        }
        (0..times).map(|nth| format!("{before}{nth}{after}")).collect()
    } else if let Some(parts) = text.get("$concat") {
        parts.as_array().unwrap().iter().map(expand).collect::<Option<String>>()?
    } else {
        STANDARD.encode(expand(&text["$base64"])?)
    };
    Some(expanded).filter(|text| text.len() <= MOST_BYTES)
}

fn validator(schema: &str) -> Validator {
    jsonschema::draft202012::new(&serde_json::from_str(schema).unwrap()).unwrap()
}

fn brief(text: &str) -> String {
    text.chars().take(400).collect()
}
