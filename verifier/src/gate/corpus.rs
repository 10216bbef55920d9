//! The frozen cases: what a case sends, what it expects, whom it binds and by which rules stays as it went out.
//!
//! Cases may be added, and words may be mended: a title, a reason, a flag, and what leads to the rule that is charged.
//! A new wire may change and remove cases.

use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, io};

use serde::Deserialize;
use serde_json::{Map, Value};

use super::rows::{Found, Unrun};
use super::{CORPUS, Finding, Gate, IDENTITY};

/// The members of a case that are frozen, in the order in which they are told.
const FROZEN: [&str; 6] = ["call", "args", "expect", "requirements", "roles", "needs"];

/// Holds the cases of the tree against those that went out before.
pub(super) fn check(gate: &Gate<'_>) -> Result<Found, Unrun> {
    let Some(before) = &gate.base.corpus else {
        let base = gate.base.told();
        return Err(Unrun::Missing(format!("{} {} holds no cases", base.kind.as_str(), base.name)));
    };
    let read = |folder: &Path, shown: &str| {
        read(folder).map_err(|(file, problem)| Unrun::broken(Finding::at(&format!("{shown}/{file}"), None, problem)))
    };
    let (was, is) = (read(before, CORPUS)?, read(&gate.path(CORPUS), CORPUS)?);
    let compared = compare(&was, &is);
    let chapter = gate.read(IDENTITY)?;
    let wire = chapter.split("The wire version of this text is `").nth(1).and_then(|rest| rest.split('`').next());
    let is_new_wire = wire.is_some_and(|wire| gate.base.is_of_another_wire(wire));
    let said = format!("{}{}", compared.told(), if is_new_wire { ", under a new wire version" } else { "" });
    let findings = if is_new_wire { Vec::new() } else { compared.findings };
    Ok(Found { said, findings })
}

/// A case, as far as it is frozen, by the file that holds it.
struct Frozen {
    file: String,
    members: Map<String, Value>,
}

type Cases = BTreeMap<String, Frozen>;

#[derive(Deserialize)]
struct File {
    cases: Vec<Map<String, Value>>,
}

/// The cases of a folder, by their ids; else the file that is wrong, and what is.
fn read(folder: &Path) -> Result<Cases, (String, String)> {
    let mut cases = Cases::new();
    let failed =
        |file: &Path, problem: String| (file.strip_prefix(folder).unwrap_or(file).display().to_string(), problem);
    for area in entries(folder).map_err(|error| failed(folder, error.to_string()))? {
        if !area.is_dir() {
            continue;
        }
        for file in entries(&area).map_err(|error| failed(&area, error.to_string()))? {
            if file.extension().is_none_or(|extension| extension != "json") {
                continue;
            }
            let text = fs::read_to_string(&file).map_err(|error| failed(&file, error.to_string()))?;
            let read: File = serde_json::from_str(&text).map_err(|error| failed(&file, error.to_string()))?;
            let shown = file.strip_prefix(folder).unwrap_or(&file).to_string_lossy().replace('\\', "/");
            for mut members in read.cases {
                let id = members.get("id").and_then(Value::as_str).unwrap_or_default().to_owned();
                members.retain(|name, _| FROZEN.contains(&name.as_str()));
                cases.insert(id, Frozen { file: shown.clone(), members });
            }
        }
    }
    Ok(cases)
}

fn entries(folder: &Path) -> io::Result<Vec<std::path::PathBuf>> {
    let mut paths = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    paths.sort();
    Ok(paths)
}

/// How two corpora differ.
struct Compared {
    same: usize,
    added: usize,
    changed: usize,
    removed: usize,
    findings: Vec<Finding>,
}

impl Compared {
    fn told(&self) -> String {
        let counts = [(self.same, "as before"), (self.added, "added"), (self.changed, "changed")];
        let counts = counts.into_iter().chain([(self.removed, "removed")]).enumerate();
        let counts = counts.filter(|(at, (count, _))| *at == 0 || *count > 0);
        let counts: Vec<_> = counts.map(|(_, (count, what))| format!("{count} {what}")).collect();
        format!("cases: {}", counts.join(", "))
    }
}

fn compare(was: &Cases, is: &Cases) -> Compared {
    let mut compared = Compared { same: 0, added: 0, changed: 0, removed: 0, findings: Vec::new() };
    for (id, before) in was {
        let file = format!("{CORPUS}/{}", before.file);
        let Some(now) = is.get(id) else {
            compared.removed += 1;
            compared.findings.push(Finding::at(&file, None, format!("{id} was removed")).by("case-removed"));
            continue;
        };
        // Numbers are held to their spelling: 5 and 5.0 are two things.
        let spelled = |case: &Frozen, member: &str| case.members.get(member).map(Value::to_string);
        let differs = |member: &&str| spelled(before, member) != spelled(now, member);
        let differing: Vec<&str> = FROZEN.into_iter().filter(differs).collect();
        match differing.first() {
            None => compared.same += 1,
            Some(first) => {
                compared.changed += 1;
                let shown = |case| brief(&spelled(case, first).unwrap_or_else(|| "nothing".to_owned()));
                let text =
                    format!("{id} has another {}: was {}, is {}", differing.join(", "), shown(before), shown(now));
                let file = format!("{CORPUS}/{}", now.file);
                compared.findings.push(Finding::at(&file, None, text).by("case-changed"));
            }
        }
    }
    compared.added = is.keys().filter(|id| !was.contains_key(*id)).count();
    compared
}

/// As much of a value as a line can hold.
fn brief(value: &str) -> String {
    const MOST: usize = 120;
    let head: String = value.chars().take(MOST).collect();
    if head.len() < value.len() { format!("{head}…") } else { head }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn cases(cases: &[(&str, Value)]) -> Cases {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("wire")).unwrap();
        let with_id = |(id, case): &(&str, Value)| {
            let mut case = case.clone();
            case["id"] = json!(id);
            case
        };
        let file = json!({"cases": cases.iter().map(with_id).collect::<Vec<_>>()});
        fs::write(folder.path().join("wire/a.json"), file.to_string()).unwrap();
        read(folder.path()).unwrap()
    }

    fn one() -> Value {
        json!({"title": "It is so.", "call": "decode", "args": {"n": 5}, "expect": {"accept": true}, "flags": ["a"]})
    }

    #[test]
    fn a_case_that_is_added_and_words_that_are_mended_leave_a_corpus_frozen() {
        let mut mended = one();
        mended["title"] = json!("It is thus.");
        mended["flags"] = json!(["b"]);
        let compared = compare(&cases(&[("wire/a", one())]), &cases(&[("wire/a", mended), ("wire/b", one())]));
        assert_eq!(compared.findings, []);
        assert_eq!(compared.told(), "cases: 1 as before, 1 added");
    }

    #[test]
    fn a_case_that_is_changed_or_removed_is_named_with_what_changed() {
        let mut other = one();
        other["args"] = json!({"n": 5.0});
        other["roles"] = json!(["body"]);
        let compared = compare(&cases(&[("wire/a", one()), ("wire/b", one())]), &cases(&[("wire/a", other)]));
        let told: Vec<&str> = compared.findings.iter().map(|finding| finding.text.as_str()).collect();
        assert_eq!(told, [r#"wire/a has another args, roles: was {"n":5}, is {"n":5.0}"#, "wire/b was removed"]);
        assert_eq!(compared.told(), "cases: 0 as before, 1 changed, 1 removed");
        assert_eq!(compared.findings[0].place().as_deref(), Some("vectors/corpus/wire/a.json"));
    }

    #[test]
    fn a_file_of_another_form_is_named() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("wire")).unwrap();
        fs::write(folder.path().join("wire/a.json"), "[]").unwrap();
        assert_eq!(read(folder.path()).err().unwrap().0, "wire/a.json");
    }
}
