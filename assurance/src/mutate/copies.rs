//! The changed kernels as modules of `ncp-proofs`: which of them compile, and what holds against them.
//!
//! A copy is the folder of the decisions with the one change, as it is: it names the kernel's words by the name of
//! their crate. `ncp-proofs` includes the table of the copies, which the environment names.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde::{Deserialize, Serialize};
use serde_json::Value;
use xtask::project::Project;

use super::{MutateError, cargo};

/// What the kernel decides, a file each.
pub(super) const DECISIONS: &str = "spec/kernel/src/decisions";
/// The numbers on which production runs it.
pub(super) const SCALAR: &str = "spec/kernel/src/scalar.rs";
const PLACE: &str = ".tools/mutants";
/// Names the table for `ncp-proofs`.
const TABLE: &str = "NCP_MUTANTS";
/// More rounds of the compiler than its phases need.
const ROUNDS: usize = 20;

/// A change of the kernel, of which a copy is made.
pub(super) trait Changed {
    /// The name of the copy: `m_` and five digits.
    fn id(&self) -> &str;

    /// What a file of the kernel is with the change; nothing where it is as it was.
    fn change(&self, file: &str, text: &str) -> Option<String>;

    /// Whether it is a change of the numbers, and not of the decisions.
    fn is_of_numbers(&self) -> bool;
}

/// The changes that the compiler accepts, and what it says first of each of the others.
pub(super) type Compiled<C> = (Vec<C>, BTreeMap<String, String>);

/// The copies of the kernel, in a folder of their own.
pub(super) struct Copies<'p> {
    project: &'p Project,
    /// The kernel's files, by their names from the root.
    sources: &'p BTreeMap<String, String>,
    place: PathBuf,
}

/// How a changed kernel is held against the properties.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ask {
    /// On samples and on enumerated values: the quick engines.
    Numbers,
    /// For all doubles, by the solvers.
    Solvers,
}

/// What `ncp-mutants` says of a changed kernel.
#[derive(Debug, Clone, Deserialize)]
pub(super) struct Answer {
    pub(super) id: String,
    /// In a sentence.
    pub(super) said: String,
    #[serde(flatten)]
    pub(super) refuted: Option<Refuted>,
}

/// What refutes a changed kernel.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Refuted {
    pub(super) property: String,
    pub(super) engine: String,
    pub(super) counterexample: Counterexample,
}

/// Inputs on which a changed kernel breaks a property.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Counterexample {
    /// The check that fails.
    pub(super) check: String,
    /// By name; what JSON has no number for is spelled.
    pub(super) inputs: Vec<(String, Value)>,
    /// How the kernel differs from the text.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) compared: Option<String>,
    /// The same as a case of a vector, or why there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    vector: Option<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    no_vector: Option<String>,
}

impl<'p> Copies<'p> {
    /// No copies yet; those of an earlier run are removed.
    ///
    /// # Errors
    /// They cannot be removed.
    pub(super) fn new(project: &'p Project, sources: &'p BTreeMap<String, String>) -> Result<Self, MutateError> {
        let place = project.path(PLACE);
        if place.exists() {
            fs::remove_dir_all(&place).map_err(|source| MutateError::File { path: place.clone(), source })?;
        }
        Ok(Self { project, sources, place })
    }

    /// The project whose kernel is changed.
    pub(super) fn project(&self) -> &Project {
        self.project
    }

    /// Those of some mutants that the compiler accepts. It stops at the errors of one phase, and is asked again
    /// without them.
    ///
    /// # Errors
    /// A file, or an error of the compiler that is in no mutant.
    pub(super) fn that_compile<C: Changed>(&self, mut mutants: Vec<C>) -> Result<Compiled<C>, MutateError> {
        const CHECK: [&str; 8] =
            ["check", "--quiet", "-p", "ncp-proofs", "--lib", "--features", "mutants", "--message-format=json"];
        for mutant in &mutants {
            self.write(mutant)?;
        }
        let mut refused = BTreeMap::new();
        for _ in 0..ROUNDS {
            let output = self.cargo(&mutants, Ask::Numbers, &CHECK)?.output();
            let output = output.map_err(|source| MutateError::Start { program: "cargo", source })?;
            if output.status.success() {
                return Ok((mutants, refused));
            }
            let lines = cargo::lines(&output.stdout);
            let before = mutants.len();
            for error in cargo::errors(&lines) {
                for id in error.files().filter_map(id_in) {
                    refused.entry(id.to_owned()).or_insert_with(|| error.said().to_owned());
                }
            }
            mutants.retain(|mutant| !refused.contains_key(mutant.id()));
            if mutants.len() == before {
                let shown = cargo::errors(&lines).find_map(|error| error.rendered.clone());
                let said = shown.unwrap_or_else(|| String::from_utf8_lossy(&output.stderr).into_owned());
                return Err(MutateError::NoCopy { said });
            }
        }
        Err(MutateError::ErrorsWithoutEnd)
    }

    /// Builds some mutants, and holds each against all properties; the answers, one each.
    ///
    /// # Errors
    /// A file, or a program that fails.
    pub(super) fn hold(&self, mutants: &[impl Changed], ask: Ask) -> Result<Vec<Answer>, MutateError> {
        const RUN: [&str; 8] = ["run", "--quiet", "-p", "ncp-proofs", "--features", "mutants", "--bin", "ncp-mutants"];
        let mut command = self.cargo(mutants, ask, &RUN)?;
        if ask == Ask::Solvers {
            command.args(["--", "--symbolic"]);
        }
        let failed = |source| MutateError::Start { program: "ncp-mutants", source };
        let mut child = command.stdout(Stdio::piped()).spawn().map_err(failed)?;
        let mut answers = Vec::new();
        if let Some(output) = child.stdout.take() {
            for line in BufReader::new(output).lines() {
                let line = line.map_err(failed)?;
                if let Ok(answer) = serde_json::from_str::<Answer>(&line) {
                    println!("{} {}", answer.id, answer.said);
                    answers.push(answer);
                }
            }
        }
        let status = child.wait().map_err(failed)?;
        if status.success() { Ok(answers) } else { Err(MutateError::Failed { status: status.to_string() }) }
    }

    /// cargo, with the table of these mutants.
    fn cargo(&self, mutants: &[impl Changed], ask: Ask, args: &[&str]) -> Result<Command, MutateError> {
        let table = self.place.join("mutants.rs");
        save(&table, &self.table(mutants, ask))?;
        let mut command = self.project.cargo(args);
        command.args(["--profile", "changed"]).env(TABLE, table);
        Ok(command)
    }

    /// The table that `ncp-proofs` includes.
    fn table(&self, mutants: &[impl Changed], ask: Ask) -> String {
        let harness = match ask {
            Ask::Numbers => "native_harness",
            Ask::Solvers => "harness",
        };
        let (mut modules, mut ids, mut arms) = (String::new(), String::new(), String::new());
        for mutant in mutants {
            let id = mutant.id();
            let path = self.place.join(id).join("glue.rs");
            let _ = writeln!(modules, "#[path = {path:?}]\npub mod {id};");
            let _ = writeln!(ids, "({id:?}, {}),", mutant.is_of_numbers());
            let _ = writeln!(arms, "{id:?} => crate::harness::{harness}::<{id}::Mutant>(property),");
        }
        format!(
            "{modules}/// The changed kernels: the name of each, and whether it is a change of the numbers.\n\
             pub const MUTANTS: &[(&str, bool)] = &[\n{ids}];\n\
             /// The harness of a property on a changed kernel.\n#[must_use]\n\
             pub fn harness(id: &str, property: &str) -> Option<crate::harness::Harness> {{\n\
             match id {{\n{arms}_ => None,\n}}\n}}\n"
        )
    }

    /// Writes the copy of a mutant: the decisions, or the numbers, with its change.
    fn write(&self, mutant: &impl Changed) -> Result<(), MutateError> {
        let folder = self.place.join(mutant.id());
        let is_number = mutant.is_of_numbers();
        let wanted = |file: &str| if is_number { file == SCALAR } else { file.starts_with(DECISIONS) };
        for (file, text) in self.sources.iter().filter(|(file, _)| wanted(file)) {
            let mut text = mutant.change(file, text).unwrap_or_else(|| text.clone());
            if is_number {
                // The feature is the kernel's, and its doubles are what is changed.
                text = text.replace("#[cfg(feature = \"std\")]\n", "");
            }
            save(&folder.join(file_name(file)), &text)?;
        }
        let path = folder.join(if is_number { "scalar.rs" } else { "mod.rs" });
        let kernel = if is_number { "[ncp_kernel] [self::changed]" } else { "[self::changed] [ncp_kernel]" };
        let glue = format!(
            "use ncp_kernel::{{Channel, Decision, Limit, Mode, Plan, Reason, Received, Scalar, Seq}};\n\
             #[path = {path:?}]\nmod changed;\n\
             crate::kernel::kernel! {{ /// A changed kernel.\nMutant = {kernel} }}\n"
        );
        save(&folder.join("glue.rs"), &glue)
    }
}

/// The last part of a path from the root.
pub(super) fn file_name(file: &str) -> &str {
    file.rsplit_once('/').map_or(file, |(_, name)| name)
}

/// The id of the mutant in whose folder a file is.
fn id_in(file: &str) -> Option<&str> {
    let is_id = |part: &&str| {
        let digits = part.strip_prefix("m_");
        digits.is_some_and(|digits| digits.len() == 5 && digits.bytes().all(|b| b.is_ascii_digit()))
    };
    file.split(['/', '\\']).rev().find(is_id)
}

fn save(path: &Path, text: &str) -> Result<(), MutateError> {
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    folder.and_then(|()| fs::write(path, text)).map_err(|source| MutateError::File { path: path.to_owned(), source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mutant_of_a_file_is_that_of_its_folder() {
        assert_eq!(id_in("/x/.tools/mutants/m_00017/speed.rs"), Some("m_00017"));
        assert_eq!(id_in("C:\\x\\m_00018\\glue.rs"), Some("m_00018"));
        assert_eq!(id_in("/x/m_1/kernel.rs"), None);
    }

    #[test]
    fn an_answer_is_read_with_what_refutes_it_and_without() {
        let open: Answer = serde_json::from_str(r#"{"id":"m_00001","said":"no numbers refute it"}"#).unwrap();
        assert!(open.refuted.is_none());
        let refuted = r#"{"id":"m_00002","said":"refuted by clamp/bound, symbolic","property":"clamp/bound",
            "engine":"symbolic","counterexample":{"check":"in","inputs":[["x",1.5],["y","NaN"]],"no_vector":"why"}}"#;
        let refuted = serde_json::from_str::<Answer>(refuted).unwrap().refuted.unwrap();
        assert_eq!(refuted.property, "clamp/bound");
        assert_eq!(refuted.counterexample.inputs[0], ("x".to_owned(), Value::from(1.5)));
        assert_eq!(refuted.counterexample.no_vector.as_deref(), Some("why"));
    }
}
