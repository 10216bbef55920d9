//! The tie of the theorem, held against changed kernels: each is put into a copy of the tree, run on terms there, and
//! Coq is asked whether what differs is still the model.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use serde::Serialize;
use toml::{Table, Value};
use xtask::project::Project;

use super::super::MutateError;
use super::Kernel;

/// The copy, from the root of the project.
const PLACE: &str = ".tools/hostile-tie";
/// What is copied: the kernel, and what ties it.
const PARTS: [&str; 2] = ["spec/kernel", "proofs/theorem"];
/// Where the scripts leave what Coq compiles, within the target folder.
const COQ: &str = "theorem";
/// How long the export of one kernel, and Coq's word on it, may each take. A kernel that comes to no end on terms never
/// leaves an export.
const LIMIT: Duration = Duration::from_secs(600);
/// How often a program is looked at.
const LOOK: Duration = Duration::from_millis(50);
/// What begins a function or a state in the export.
const ITEM: &str = "\n\n(* ";

/// What the tie says of a changed kernel.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "tie", content = "said")]
pub(super) enum Tied {
    /// It is the model: a change of its numbers, or none of its behaviour.
    Accepted,
    /// Coq does not prove that it is the model: the first function or state of which it does not.
    Refused(String),
    /// The source does what the export cannot say.
    NotExported(String),
    /// It does not compile where it is taken apart member by member.
    NotBuilt(String),
    /// The export, or Coq, comes to no end in time.
    Late,
}

/// The copy of the tree, in which the kernel without a change is the model.
pub(super) struct Tie<'p> {
    project: &'p Project,
    place: PathBuf,
    /// The export of the kernel as it is: its items.
    sound: BTreeSet<String>,
}

impl<'p> Tie<'p> {
    /// Copies the tree, and holds the kernel as it is.
    ///
    /// # Errors
    /// A file, or the kernel without a change is refused: what says no to every copy says nothing of a change.
    pub(super) fn new(project: &'p Project) -> Result<Self, MutateError> {
        let tie = Self { project, place: project.path(PLACE), sound: BTreeSet::new() };
        if tie.place.exists() {
            fs::remove_dir_all(&tie.place).map_err(|source| tie.failed(&tie.place, source))?;
        }
        for part in PARTS {
            tie.copy(&project.path(part), &tie.place.join(part))?;
        }
        tie.save("Cargo.lock", &tie.read(&project.path("Cargo.lock"))?)?;
        tie.save("Cargo.toml", &tie.manifest()?)?;
        let output = tie.run(Command::new("bash").arg(tie.place.join("proofs/theorem/check.sh")).arg("--tie"))?;
        if !output.status.success() {
            return Err(MutateError::NoTie { said: String::from_utf8_lossy(&output.stderr).into_owned() });
        }
        print!("the theorem: {}", String::from_utf8_lossy(&output.stdout));
        let sound = items(&tie.read(&tie.coq().join("Exported.v"))?).map(str::to_owned).collect();
        Ok(Self { sound, ..tie })
    }

    /// What it says of each kernel.
    ///
    /// # Errors
    /// A file, or a program that cannot be started.
    pub(super) fn hold(&self, kernels: &[Kernel]) -> Result<BTreeMap<String, Tied>, MutateError> {
        let mut ties = BTreeMap::new();
        for kernel in kernels {
            for (file, text) in &kernel.texts {
                self.save(file, text)?;
            }
            let tied = self.one()?;
            println!("{}: {tied}", kernel.defect.name);
            ties.insert(kernel.id.clone(), tied);
            for file in kernel.texts.keys() {
                self.save(file, &self.read(&self.project.path(file))?)?;
            }
        }
        Ok(ties)
    }

    /// What it says of the kernel that stands in the copy.
    fn one(&self) -> Result<Tied, MutateError> {
        let export = self.coq().join("Changed.v");
        let manifest = self.place.join("Cargo.toml");
        // The release build takes longer than all that it then does.
        let words = ["build", "--quiet", "--profile", "changed", "-p", "ncp-theorem", "--manifest-path"];
        let output = self.run(self.project.cargo(&words).arg(manifest))?;
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        if !output.status.success() {
            let error = said.lines().find(|line| line.starts_with("error"));
            return Ok(Tied::NotBuilt(error.unwrap_or_default().to_owned()));
        }
        let program = self.place.join("target/changed").join(format!("ncp-theorem{}", std::env::consts::EXE_SUFFIX));
        let Some((is_exported, said)) = self.limited(Command::new(program).arg(&export))? else {
            return Ok(Tied::Late);
        };
        if !is_exported {
            return Ok(Tied::NotExported(said.lines().last().unwrap_or_default().to_owned()));
        }
        let text = self.read(&export)?;
        let mut others: Vec<&str> = items(&text).filter(|item| !self.sound.contains(*item)).collect();
        if others.is_empty() {
            return Ok(Tied::Accepted);
        }
        // What is short is soon refused.
        others.sort_by_key(|item| item.len());
        let head = text.split_once(ITEM).map_or("", |(head, _)| head);
        let script = format!("{head}{ITEM}{}\n\nEnd Exported.\n", others.join(ITEM));
        fs::write(&export, &script).map_err(|source| self.failed(&export, source))?;
        let mut coq = Command::new("coqc");
        let coq = coq.args(["-q", "-Q", ".", "NCP", "Changed.v"]);
        let Some((is_the_model, said)) = self.limited(coq)? else { return Ok(Tied::Late) };
        if is_the_model {
            return Ok(Tied::Accepted);
        }
        let line = said.lines().find_map(|line| line.split_once(", line ")?.1.split(',').next()?.parse().ok());
        let before = script.lines().take(line.unwrap_or(usize::MAX));
        let lemmas = before.filter_map(|line| line.strip_prefix("Lemma ")?.split(' ').next());
        Ok(Tied::Refused(lemmas.last().unwrap_or("no lemma").to_owned()))
    }

    /// The manifest of the workspace, with these two members alone.
    fn manifest(&self) -> Result<String, MutateError> {
        let path = self.project.path("Cargo.toml");
        let wrong = |source| MutateError::Manifest { path: path.clone(), source: Box::new(source) };
        let mut manifest: Table = self.read(&path)?.parse().map_err(wrong)?;
        if let Some(workspace) = manifest.get_mut("workspace").and_then(Value::as_table_mut) {
            workspace.insert("members".to_owned(), PARTS.map(Value::from).to_vec().into());
        }
        Ok(manifest.to_string())
    }

    /// Where Coq works.
    fn coq(&self) -> PathBuf {
        self.place.join("target").join(COQ)
    }

    fn run(&self, command: &mut Command) -> Result<Output, MutateError> {
        let output = command.env("CARGO_TARGET_DIR", self.place.join("target")).output();
        output.map_err(|source| MutateError::Start { program: "cargo, bash or coqc", source })
    }

    /// Whether a program ends well, and what it says; nothing of one that takes longer than it may, and is stopped.
    fn limited(&self, command: &mut Command) -> Result<Option<(bool, String)>, MutateError> {
        let failed = |source| MutateError::Start { program: "ncp-theorem or coqc", source };
        let said = self.coq().join("said.txt");
        let file = fs::File::create(&said).map_err(|source| self.failed(&said, source))?;
        let child = command.current_dir(self.coq()).stdout(Stdio::null()).stderr(file).spawn();
        let (mut child, began) = (child.map_err(failed)?, Instant::now());
        loop {
            if let Some(status) = child.try_wait().map_err(failed)? {
                return Ok(Some((status.success(), self.read(&said)?)));
            }
            if began.elapsed() > LIMIT {
                child.kill().and_then(|()| child.wait()).map_err(failed)?;
                return Ok(None);
            }
            thread::sleep(LOOK);
        }
    }

    fn copy(&self, from: &Path, to: &Path) -> Result<(), MutateError> {
        let failed = |source| self.failed(from, source);
        fs::create_dir_all(to).map_err(failed)?;
        for entry in fs::read_dir(from).map_err(failed)? {
            let (path, name) = entry.map(|entry| (entry.path(), entry.file_name())).map_err(failed)?;
            if path.is_dir() {
                self.copy(&path, &to.join(name))?;
            } else {
                fs::copy(&path, to.join(name)).map_err(failed)?;
            }
        }
        Ok(())
    }

    fn read(&self, path: &Path) -> Result<String, MutateError> {
        fs::read_to_string(path).map_err(|source| self.failed(path, source))
    }

    fn save(&self, file: &str, text: &str) -> Result<(), MutateError> {
        let path = self.place.join(file);
        fs::write(&path, text).map_err(|source| self.failed(&path, source))
    }

    fn failed(&self, path: &Path, source: std::io::Error) -> MutateError {
        MutateError::File { path: path.to_owned(), source }
    }
}

/// The functions and states of an export, each with its lemma.
fn items(export: &str) -> impl Iterator<Item = &str> {
    export.split(ITEM).skip(1).map(|item| item.trim_end().trim_end_matches("End Exported.").trim_end())
}

impl std::fmt::Display for Tied {
    fn fmt(&self, form: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Accepted => write!(form, "ACCEPTED by the tie"),
            Self::Refused(lemma) => write!(form, "refused by {lemma}"),
            Self::NotExported(said) | Self::NotBuilt(said) => write!(form, "refused: {said}"),
            Self::Late => write!(form, "not decided in {} s", LIMIT.as_secs()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_items_of_an_export_stand_each_by_itself() {
        let export = "(** Head. *)\n\nSection Exported.\n\n(* 3 paths. *)\nDefinition a.\nLemma a. Qed.\n\n\
                      (* 1 paths. *)\nDefinition b.\nLemma b. Qed.\n\nEnd Exported.\n";
        let items: Vec<&str> = items(export).collect();
        assert_eq!(items, ["3 paths. *)\nDefinition a.\nLemma a. Qed.", "1 paths. *)\nDefinition b.\nLemma b. Qed."]);
    }
}
