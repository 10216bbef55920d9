//! The form of a vector file, and its strict reading.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::ErrorCode;
use ncp_text::catalogue::{Requirement, Role};
use serde::Deserialize;
use serde_json::value::RawValue;

use super::SuiteError;
use super::case::{By, Case, Expect, Need, Parts, Text};
use super::pattern::Shape;
use super::template::Template;
use crate::json::Json;
use crate::peer::Call;

/// The format that this program reads.
const FORMAT: u64 = 1;
/// The relations of an expectation.
const RELATIONS: [&str; 6] = ["json", "message", "encoding", "bytes", "columns", "pattern"];

/// A vector file, read.
#[derive(Debug)]
pub(super) struct VectorFile {
    pub(super) notes: BTreeMap<String, String>,
    pub(super) cases: Vec<Case>,
}

/// Reads the vector file `name`; `rules` are those of the text, by id.
pub(super) fn read(name: &str, text: &str, rules: &HashMap<&str, &Arc<Requirement>>) -> Result<VectorFile, SuiteError> {
    let wrong = |message: String| SuiteError::File { file: name.to_owned(), message };
    let raw: RawFile<'_> = serde_json::from_str(text).map_err(|error| wrong(error.to_string()))?;
    if raw.format != FORMAT {
        return Err(wrong(format!("its format is {}, and this program reads format {FORMAT}", raw.format)));
    }
    if raw.about.trim().is_empty() {
        return Err(wrong("its `about` is empty".to_owned()));
    }
    let prefix = format!("{}/{}", raw.area, raw.name);
    if name.strip_suffix(".json") != Some(&prefix) {
        return Err(wrong(format!("by its area and name it is {prefix}.json")));
    }
    let context = Context { file: name.into(), prefix: format!("{prefix}/"), rules, notes: &raw.notes };
    let cases = raw.cases.iter().enumerate().map(|(i, raw)| context.case(i, raw.get())).collect::<Result<_, _>>()?;
    Ok(VectorFile { cases, notes: raw.notes })
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFile<'a> {
    format: u64,
    area: String,
    name: String,
    about: String,
    #[serde(default)]
    notes: BTreeMap<String, String>,
    #[serde(borrow)]
    cases: Vec<&'a RawValue>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawCase<'a> {
    id: String,
    title: String,
    requirements: Vec<String>,
    flags: Vec<String>,
    roles: Vec<String>,
    needs: Option<Vec<String>>,
    call: String,
    #[serde(borrow)]
    args: &'a RawValue,
    #[serde(borrow)]
    expect: RawExpect<'a>,
    #[serde(default)]
    by: BTreeMap<String, String>,
    #[serde(default)]
    rests_on: Vec<String>,
    why: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawExpect<'a> {
    reject: Option<String>,
    accept: Option<bool>,
    relation: Option<String>,
    // A `null` value is a value, so it may not read as absent.
    #[serde(borrow, default, deserialize_with = "present")]
    value: Option<&'a RawValue>,
    #[serde(borrow)]
    text: Option<&'a RawValue>,
    ignore: Option<Vec<String>>,
    base64: Option<String>,
    #[serde(borrow)]
    columns: Option<&'a RawValue>,
    tolerance: Option<f64>,
    or_reject: Option<bool>,
}

fn present<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Option<&'de RawValue>, D::Error> {
    <&RawValue>::deserialize(deserializer).map(Some)
}

struct Context<'c> {
    file: Arc<str>,
    prefix: String,
    rules: &'c HashMap<&'c str, &'c Arc<Requirement>>,
    notes: &'c BTreeMap<String, String>,
}

impl Context<'_> {
    fn case(&self, index: usize, text: &str) -> Result<Case, SuiteError> {
        self.parts(text).map(Case::new).map_err(|message| SuiteError::Case {
            file: self.file.to_string(),
            id: id_of(text).unwrap_or_else(|| format!("number {}", index + 1)),
            message,
        })
    }

    fn parts(&self, text: &str) -> Result<Parts, String> {
        let raw: RawCase<'_> = serde_json::from_str(text).map_err(|error| {
            // Lines would count from the case's own first line.
            let message = error.to_string();
            message.split(" at line ").next().unwrap_or(&message).to_owned()
        })?;
        self.check_id(&raw.id)?;
        for (what, words) in [("title", &raw.title), ("why", &raw.why)] {
            if words.trim().is_empty() {
                return Err(format!("its `{what}` is empty"));
            }
        }
        let rule = |id: &String| {
            self.rules.get(id.as_str()).map(|rule| Arc::clone(rule)).ok_or_else(|| format!("the text has no rule {id}"))
        };
        let requirements: Vec<_> = raw.requirements.iter().map(rule).collect::<Result<_, _>>()?;
        if requirements.is_empty() {
            return Err("it cites no rule".to_owned());
        }
        if let Some(flag) = raw.flags.iter().find(|flag| !self.notes.contains_key(*flag)) {
            return Err(format!("the file's `notes` do not explain the flag `{flag}`"));
        }
        let role = |name: &String| Role::parse(name).ok_or_else(|| format!("`{name}` is not a role"));
        let roles: Vec<_> = raw.roles.iter().map(role).collect::<Result<_, _>>()?;
        if roles.is_empty() {
            return Err("it names no role".to_owned());
        }
        if let Some(role) = roles.iter().find(|role| !requirements.iter().any(|rule| rule.binds(**role))) {
            return Err(format!("it is for the role {role}, which none of its rules binds"));
        }
        let need = |name: &String| Need::parse(name).ok_or_else(|| format!("`{name}` is nothing that a case may need"));
        let needs: Vec<_> = raw.needs.iter().flatten().map(need).collect::<Result<_, _>>()?;
        if raw.needs.is_some() && needs.is_empty() {
            return Err("its `needs` are empty".to_owned());
        }
        let call = Call::parse(&raw.call).ok_or_else(|| format!("`{}` is not a call", raw.call))?;
        let args = Template::new(raw.args.get()).map_err(|error| format!("its args: {error}"))?;
        if !raw.args.get().starts_with('{') || args.is_text() {
            return Err("its args are not an object".to_owned());
        }
        let mut by = By::default();
        for (place, id) in &raw.by {
            let rule = rule(id)?;
            match place.as_str() {
                "crash" => by.crash = Some(rule),
                "refusal" => by.refusal = Some(rule),
                "order" => by.order = Some(rule),
                "extra" => by.extra = Some(rule),
                "within" => by.within = Some(rule),
                place if place.starts_with('/') => by.places.push((place.to_owned(), rule)),
                place => {
                    return Err(format!(
                        "its `by` names {place}: not a JSON pointer, nor one of crash, refusal, order, extra, within"
                    ));
                }
            }
        }
        Ok(Parts {
            expect: expect(raw.expect)?,
            by,
            rests_on: raw.rests_on,
            id: raw.id,
            title: raw.title,
            requirements,
            flags: raw.flags,
            roles,
            needs,
            call,
            args,
            why: raw.why,
            file: Arc::clone(&self.file),
        })
    }

    fn check_id(&self, id: &str) -> Result<(), String> {
        let fits = id.strip_prefix(&self.prefix).is_some_and(|rest| !rest.is_empty());
        let spelled = id.bytes().all(|b| matches!(b, b'a'..=b'z' | b'0'..=b'9' | b'_' | b'/' | b'.' | b'-'));
        if fits && spelled {
            return Ok(());
        }
        Err(format!("its id is not `{}` and more of a-z, 0-9 and `_/.-`", self.prefix))
    }
}

fn expect(raw: RawExpect<'_>) -> Result<Expect, String> {
    let template = |raw: &RawValue| Template::new(raw.get()).map_err(|error| format!("its expectation: {error}"));
    let text = |raw: &RawValue| {
        let template = template(raw)?;
        if !template.is_text() {
            return Err("its expected `text` is not a string".to_owned());
        }
        let text = Text::new(template);
        match Json::parse(&text.get()) {
            Ok(Json::Object(_)) => Ok(text),
            Ok(_) => Err("its expected `text` is not an object".to_owned()),
            Err(error) => Err(format!("its expected `text` is not JSON: {error}")),
        }
    };
    match raw {
        RawExpect {
            relation: Some(relation),
            value: Some(value),
            tolerance,
            or_reject,
            accept: None,
            reject: None,
            text: None,
            ignore: None,
            base64: None,
            columns: None,
        } if relation == "pattern" => pattern(value, tolerance, or_reject),
        RawExpect {
            reject: Some(code),
            accept: None,
            relation: None,
            value: None,
            text: None,
            ignore: None,
            base64: None,
            columns: None,
            tolerance: None,
            or_reject: None,
        } => match ErrorCode::parse(&code) {
            Some(ErrorCode::Invalid | ErrorCode::Internal) => Err(format!("`{code}` says nothing about the case")),
            Some(code) => Ok(Expect::Reject(code)),
            None => Err(format!("`{code}` is not an error code")),
        },
        RawExpect {
            accept: Some(true),
            reject: None,
            relation: None,
            value: None,
            text: None,
            ignore: None,
            base64: None,
            columns: None,
            tolerance: None,
            or_reject: None,
        } => Ok(Expect::Accept),
        RawExpect {
            relation: Some(relation),
            accept: None,
            reject: None,
            value,
            text: expected,
            ignore,
            base64,
            columns,
            tolerance: None,
            or_reject,
        } if or_reject.is_none() || relation == "message" => {
            match (relation.as_str(), value, expected, ignore, base64, columns) {
                ("json", Some(value), None, None, None, None) => Ok(Expect::Json(template(value)?.keep())),
                ("message", None, Some(expected), ignore, None, None) => Ok(Expect::Message {
                    text: text(expected)?,
                    ignore: ignore.unwrap_or_default(),
                    or_reject: is_set(or_reject)?,
                }),
                ("encoding", None, Some(expected), None, None, None) => Ok(Expect::Encoding(text(expected)?)),
                ("bytes", None, None, None, Some(bytes), None) => STANDARD
                    .decode(&bytes)
                    .map(Expect::Bytes)
                    .map_err(|error| format!("its expected bytes are not base64: {error}")),
                ("columns", None, None, None, None, Some(columns)) if columns.get().starts_with('[') => {
                    Ok(Expect::Columns(template(columns)?.keep()))
                }
                _ => Err(misfit(&relation)),
            }
        }
        RawExpect { relation: Some(relation), accept: None, reject: None, .. } => Err(misfit(&relation)),
        _ => Err("its expectation is not one of `reject`, `accept: true` and `relation`".to_owned()),
    }
}

fn pattern(value: &RawValue, tolerance: Option<f64>, or_reject: Option<bool>) -> Result<Expect, String> {
    let tolerance = tolerance.unwrap_or(0.0);
    if !(tolerance.is_finite() && tolerance >= 0.0) {
        return Err("its `tolerance` is negative".to_owned());
    }
    let or_reject = is_set(or_reject)?;
    let shape = Shape::parse(value.get()).map_err(|error| format!("its expectation: {error}"))?;
    Ok(Expect::Pattern { shape, tolerance, or_reject })
}

/// Whether `or_reject` is there; `false` is what leaving it out says.
fn is_set(or_reject: Option<bool>) -> Result<bool, String> {
    match or_reject {
        Some(false) => Err("its `or_reject` is not true".to_owned()),
        or_reject => Ok(or_reject.is_some()),
    }
}

/// What is wrong with an expectation whose members do not fit its relation.
fn misfit(relation: &str) -> String {
    if RELATIONS.contains(&relation) {
        format!("its expectation has not what the relation `{relation}` needs, or has more")
    } else {
        format!("`{relation}` is not a relation: {}", RELATIONS.join(", "))
    }
}

/// The id of a case that may be faulty otherwise.
fn id_of(text: &str) -> Option<String> {
    Json::parse(text).ok()?.get("id")?.as_str().map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ncp_text::catalogue::Catalogue;

    const CASE: &str = r#"{"id":"wire/a/x","title":"T.","requirements":["NCP-WIRE-024"],"flags":["f"],"roles":["body"],
        "call":"decode","args":{"kind":"command_frame","text":"{}"},"expect":{"reject":"type"},"why":"W."}"#;

    fn read_case(case: &str) -> Result<VectorFile, SuiteError> {
        let catalogue = Catalogue::load().unwrap();
        let rules: Vec<_> = catalogue.iter().cloned().map(Arc::new).collect();
        let rules = rules.iter().map(|rule| (rule.id.as_str(), rule)).collect();
        let text =
            format!(r#"{{"format":1,"area":"wire","name":"a","about":"A.","notes":{{"f":"N."}},"cases":[{case}]}}"#);
        read("wire/a.json", &text, &rules)
    }

    fn fault(from: &str, to: &str) -> String {
        assert!(CASE.contains(from), "{from}");
        read_case(&CASE.replace(from, to)).unwrap_err().to_string()
    }

    fn expectation(expect: &str) -> Result<Expect, String> {
        read_case(&CASE.replace(r#"{"reject":"type"}"#, expect))
            .map(|mut file| file.cases.remove(0).expect)
            .map_err(|error| error.to_string())
    }

    #[test]
    fn a_case_becomes_the_request_that_is_sent() {
        let file = read_case(CASE).unwrap();
        assert_eq!(file.cases[0].body(), r#""call":"decode","args":{"kind":"command_frame","text":"{}"}}"#);
        assert_eq!(file.cases[0].call, Call::Decode);
        assert!(file.cases[0].needs.is_empty());
        let needing = CASE.replace(r#"["body"]"#, r#"["body"],"needs":["reference_networks"]"#);
        let file = read_case(&needing).unwrap();
        assert_eq!(file.cases[0].needs, [Need::ReferenceNetworks]);
    }

    #[test]
    fn a_faulty_case_is_named_with_what_is_wrong() {
        let of = "wire/a.json: the case wire/a/x: ";
        assert_eq!(
            fault("\"title\"", "\"titel\""),
            format!(
                "{of}unknown field `titel`, expected one of `id`, `title`, `requirements`, `flags`, \
                 `roles`, `needs`, `call`, `args`, `expect`, `by`, `rests_on`, `why`"
            )
        );
        assert_eq!(fault("NCP-WIRE-024", "NCP-WIRE-999"), format!("{of}the text has no rule NCP-WIRE-999"));
        assert_eq!(fault("[\"NCP-WIRE-024\"]", "[]"), format!("{of}it cites no rule"));
        assert_eq!(fault("[\"f\"]", "[\"g\"]"), format!("{of}the file's `notes` do not explain the flag `g`"));
        assert_eq!(fault("[\"body\"]", "[\"pilot\"]"), format!("{of}`pilot` is not a role"));
        assert_eq!(fault("[\"body\"]", "[]"), format!("{of}it names no role"));
        assert_eq!(
            fault("[\"body\"]", r#"["body"],"needs":["a_moon"]"#),
            format!("{of}`a_moon` is nothing that a case may need")
        );
        assert_eq!(fault("[\"body\"]", r#"["body"],"needs":[]"#), format!("{of}its `needs` are empty"));
        assert_eq!(
            fault("\"body\"", "\"server\""),
            format!("{of}it is for the role server, which none of its rules binds")
        );
        assert_eq!(fault("\"decode\"", "\"dekode\""), format!("{of}`dekode` is not a call"));
        assert_eq!(
            fault("{}\"}", "{}\",\"x\":{\"$repeat\":1}}"),
            format!(
                "{of}its args: `$repeat` is no template: one of `$repeat` with `times`, `$count` with `times`, \
                 `$concat`, `$base64`; in a list `$item` or `$items` with `times`, and perhaps `plus`"
            )
        );
        assert_eq!(fault("\"T.\"", "\" \""), format!("{of}its `title` is empty"));
        assert_eq!(
            fault("wire/a/x", "wire/b/x"),
            "wire/a.json: the case wire/b/x: its id is not `wire/a/` and more of a-z, 0-9 and `_/.-`"
        );
        assert!(fault("wire/a/x", "wire/a/X").contains("its id is not"));
    }

    #[test]
    fn a_file_under_another_name_or_format_is_refused() {
        let rules = HashMap::new();
        let text = r#"{"format":1,"area":"wire","name":"a","about":"A.","cases":[]}"#;
        assert!(read("wire/a.json", text, &rules).is_ok());
        let fault = |name, text: &str| read(name, text, &rules).unwrap_err().to_string();
        assert_eq!(fault("wire/b.json", text), "wire/b.json: by its area and name it is wire/a.json");
        assert!(fault("wire/a.json", &text.replace("1,", "2,")).contains("its format is 2"));
        assert!(fault("wire/a.json", &text.replace("about", "abaut")).contains("unknown field `abaut`"));
    }

    #[test]
    fn every_form_of_an_expectation_is_read() {
        assert!(matches!(expectation(r#"{"accept":true}"#), Ok(Expect::Accept)));
        assert!(matches!(expectation(r#"{"relation":"json","value":null}"#), Ok(Expect::Json(_))));
        assert!(matches!(
            expectation(r#"{"relation":"message","text":"{}","ignore":["/a"]}"#),
            Ok(Expect::Message { ignore, or_reject: false, .. }) if ignore == ["/a"]
        ));
        assert!(matches!(
            expectation(r#"{"relation":"message","text":"{}","or_reject":true}"#),
            Ok(Expect::Message { or_reject: true, .. })
        ));
        assert!(matches!(
            expectation(r#"{"relation":"encoding","text":{"$concat":["{","}"]}}"#),
            Ok(Expect::Encoding(_))
        ));
        assert!(matches!(expectation(r#"{"relation":"bytes","base64":"AQI="}"#), Ok(Expect::Bytes(b)) if b == [1, 2]));
        assert!(matches!(expectation(r#"{"relation":"columns","columns":[]}"#), Ok(Expect::Columns(_))));
        assert!(matches!(
            expectation(r#"{"relation":"pattern","value":{"steps":[{"$error":true}]}}"#),
            Ok(Expect::Pattern { tolerance: 0.0, or_reject: false, .. })
        ));
        assert!(matches!(
            expectation(r#"{"relation":"pattern","value":null,"tolerance":1e-9,"or_reject":true}"#),
            Ok(Expect::Pattern { tolerance: 1e-9, or_reject: true, .. })
        ));
    }

    #[test]
    fn a_faulty_expectation_is_refused() {
        for (expect, what) in [
            (r#"{}"#, "not one of `reject`, `accept: true` and `relation`"),
            (r#"{"accept":false}"#, "not one of"),
            (r#"{"accept":true,"reject":"type"}"#, "not one of"),
            (r#"{"reject":"tpye"}"#, "`tpye` is not an error code"),
            (r#"{"reject":"internal"}"#, "says nothing about the case"),
            (r#"{"relation":"equal","value":1}"#, "`equal` is not a relation"),
            (r#"{"relation":"json"}"#, "has not what the relation `json` needs"),
            (r#"{"relation":"json","value":1,"text":"{}"}"#, "or has more"),
            (r#"{"relation":"message","text":"[]"}"#, "is not an object"),
            (r#"{"relation":"message","text":"{\"a\":1,\"a\":2}"}"#, "stands twice"),
            (r#"{"relation":"message","text":7}"#, "is not a string"),
            (r#"{"relation":"bytes","base64":"%"}"#, "not base64"),
            (r#"{"relation":"columns","columns":{}}"#, "has not what the relation `columns` needs"),
            (r#"{"relation":"json","values":1}"#, "unknown field `values`"),
            (r#"{"relation":"json","value":1,"tolerance":1}"#, "has not what the relation `json` needs"),
            (r#"{"relation":"pattern","text":"{}"}"#, "has not what the relation `pattern` needs"),
            (r#"{"relation":"pattern","value":1,"text":"{}"}"#, "or has more"),
            (r#"{"relation":"pattern","value":1,"tolerance":-1}"#, "`tolerance` is negative"),
            (r#"{"relation":"pattern","value":1,"or_reject":false}"#, "`or_reject` is not true"),
            (
                r#"{"relation":"pattern","value":[{"$eror":true}]}"#,
                "wire/a/x: its expectation: `$eror` is no word of a pattern",
            ),
            (r#"{"relation":"pattern","value":{"$repeat":"x","times":2}}"#, "`$repeat` of a pattern stands alone"),
            (r#"{"reject":"type","or_reject":true}"#, "not one of"),
            (r#"{"relation":"message","text":"{}","or_reject":false}"#, "`or_reject` is not true"),
            (
                r#"{"relation":"encoding","text":"{}","or_reject":true}"#,
                "has not what the relation `encoding` needs, or has more",
            ),
        ] {
            let fault = expectation(expect).unwrap_err();
            assert!(fault.contains(what), "{expect}: {fault}");
        }
    }
}
