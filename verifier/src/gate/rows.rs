//! The one table of rows: what each asks of a tree, by what, and what to do when it fails.

use serde_json::Value;

use super::against::ImageError;
use super::tools::{Ended, ToolError};
use super::{Finding, Gate, IDENTITY, PROTO, corpus, identity, peers};

/// A row of the gate.
#[derive(Debug)]
pub struct Row {
    /// Its name, as the command line has it.
    pub name: &'static str,
    /// What it asks, as a sentence that holds of a good tree.
    pub about: &'static str,
    /// What asks the same alone.
    pub command: &'static str,
    /// What to do when it fails.
    pub remedy: &'static str,
    /// What to do to have it run.
    pub to_run: &'static str,
    /// Where its findings are shown that are nowhere in particular.
    pub place: &'static str,
    /// The files of the project that it needs.
    pub(super) needs: &'static [&'static str],
    /// Asks.
    pub(super) run: fn(&Gate<'_>) -> Result<Found, Unrun>,
}

/// What a row found.
#[derive(Debug, Default)]
pub(super) struct Found {
    /// What there is to say in a line; empty: what is wrong says it.
    pub(super) said: String,
    /// What is wrong.
    pub(super) findings: Vec<Finding>,
}

/// Why a row says nothing of the tree.
#[derive(Debug)]
pub(super) enum Unrun {
    /// Something that it needs is not there.
    Missing(String),
    /// Something that it needs is there, and broken: that is wrong with the tree.
    Broken(Box<Finding>),
    /// Everything is to end.
    Interrupted,
}

/// Every row, in the order in which they are asked: what fails fastest first.
pub const ROWS: &[Row] = &[
    Row {
        name: "identity",
        about: "the contract hash is that of the proto, and wire version and hash move together",
        command: "cargo test -p ncp-proto --test contract",
        remedy: "take the change of the contract back, or give it a wire version and a hash of its own: \
                 CONTRIBUTING.md, \"A wire version\"",
        to_run: HELD,
        place: IDENTITY,
        needs: &[PROTO, IDENTITY],
        run: identity::check,
    },
    Row {
        name: "corpus",
        about: "no case was changed or removed under the same wire version",
        command: "git diff --stat TAG -- vectors/corpus",
        remedy: "restore the case and add another beside it, or give the wire a version of its own",
        to_run: "hold the tree against a tag, a commit or a folder that has vectors/corpus (--against)",
        place: "vectors/MANIFEST.sha256",
        needs: &["vectors/corpus"],
        run: corpus::check,
    },
    Row {
        name: "buf-lint",
        about: "the proto follows buf's rules",
        command: "cargo xtask test --only buf-lint",
        remedy: "mend what buf names, or add an exception with its reason to proto/buf.yaml",
        to_run: INSTALL_BUF,
        place: PROTO,
        needs: &[PROTO, "proto/buf.yaml"],
        run: |gate| buf(gate, &["lint"]),
    },
    Row {
        name: "buf-breaking",
        about: "the proto breaks nothing that went out (buf)",
        command: "cargo xtask test --only buf-breaking",
        remedy: "keep what peers in the field speak, and add beside it: proto/README.md, \"To change the contract\"",
        to_run: INSTALL_BUF,
        place: PROTO,
        needs: &[PROTO, "proto/buf.yaml"],
        run: |gate| {
            let image = gate.base.as_image(gate.tools).map_err(of_image)?.display().to_string();
            buf(gate, &["breaking", "--against", &image])
        },
    },
    Row {
        name: "contract",
        about: "proto and projection break nothing that went out: strings, defaults, keys, names (our own check)",
        command: "cargo xtask contract",
        remedy: "keep what peers in the field speak, and add beside it: proto/README.md, \"What buf does not see\"",
        to_run: "have buf and cargo, and beside an image its projection, as in proto/baseline",
        place: PROTO,
        needs: &["xtask/Cargo.toml", "proto/Cargo.toml"],
        run: contract,
    },
    Row {
        name: "generated",
        about: "schemas, cases with their manifest, and the C header are what would be generated",
        command: "cargo xtask generate --check",
        remedy: "cargo xtask generate, read the diff, and commit it",
        to_run: NEEDS_CARGO,
        place: "proto/projection.json",
        needs: &["xtask/Cargo.toml"],
        run: generated,
    },
    Row {
        name: "trace",
        about: "every binding rule is shown, and all evidence cites rules",
        command: "cargo assure trace --check",
        remedy: "show the rule by a case, a test or a property; after that: cargo assure trace, and --accept where \
                 what is named is meant",
        to_run: NEEDS_CARGO,
        place: "reports/lock/trace.toml",
        needs: &["assurance/Cargo.toml"],
        run: trace,
    },
    Row {
        name: "proofs",
        about: "the proofs are about the sources as they are",
        command: "cargo assure status",
        remedy: "cargo assure refresh makes anew what is stale, and nothing else",
        to_run: NEEDS_CARGO,
        place: "reports/proofs.md",
        needs: &["assurance/Cargo.toml", "reports/lock"],
        run: proofs,
    },
    Row {
        name: "peers",
        about: "every bundled peer does what it says: nothing fails but its expected failures, and those fail",
        command: "cargo verify",
        remedy: "mend the peer, or its peer.toml: list a failure that is known, with its reason, and take out what \
                 passes",
        to_run: "install what the peer needs, and run the gate by cargo verify gate",
        place: "peers/README.md",
        needs: &["peers", "vectors/corpus"],
        run: peers::check,
    },
];

const HELD: &str = "hold the tree against what has a contract (--against)";
const INSTALL_BUF: &str = "cargo xtask test --only buf-lint installs buf into .tools, and NCP_BUF names another one";
const NEEDS_CARGO: &str = "put cargo on PATH";

impl Found {
    /// Says what is wrong instead, if anything is.
    pub(super) fn only_if_good(mut self) -> Self {
        if !self.findings.is_empty() {
            self.said.clear();
        }
        self
    }
}

impl Unrun {
    pub(super) fn broken(finding: Finding) -> Self {
        Self::Broken(Box::new(finding))
    }
}

impl From<ToolError> for Unrun {
    fn from(error: ToolError) -> Self {
        match error {
            ToolError::Interrupted => Self::Interrupted,
            missing => Self::Missing(missing.to_string()),
        }
    }
}

fn of_image(error: ImageError) -> Unrun {
    match error {
        ImageError::Tool(error) => error.into(),
        ImageError::Build(output) => Unrun::broken(Finding::new(output)),
        ImageError::None => Unrun::Missing("there is no proto to hold this one against".to_owned()),
    }
}

/// Runs a command of buf, which prints a line of JSON a finding.
fn buf(gate: &Gate<'_>, args: &[&str]) -> Result<Found, Unrun> {
    let command = gate.tools.buf(&[args, &["--error-format", "json"]].concat(), "proto");
    let ended = gate.tools.run(command, &format!("buf-{}", args[0]))?;
    let findings: Vec<Finding> = ended.stdout.lines().filter_map(annotation).collect();
    match (ended.code, findings.is_empty()) {
        (Some(0), true) => Ok(Found { said: "nothing found".to_owned(), findings }),
        (_, false) => Ok(Found { said: String::new(), findings }),
        _ => Err(broken(&ended)),
    }
}

/// A finding of buf.
fn annotation(line: &str) -> Option<Finding> {
    let value: Value = serde_json::from_str(line).ok()?;
    let text = |name: &str| value.get(name).and_then(Value::as_str);
    let line = value.get("start_line").and_then(Value::as_u64).and_then(|line| u32::try_from(line).ok());
    let file = text("path").map_or_else(|| PROTO.to_owned(), |path| format!("proto/{path}"));
    Some(Finding::at(&file, line, text("message")?).by(text("type").unwrap_or("buf")))
}

/// The check of the project that sees what buf does not.
fn contract(gate: &Gate<'_>) -> Result<Found, Unrun> {
    let base = gate.base.told();
    let Some(projection) = &gate.base.projection else {
        return Err(Unrun::Missing(format!("{} {} has no projection beside it", base.kind.as_str(), base.name)));
    };
    let image = gate.base.as_image(gate.tools).map_err(of_image)?;
    let (image, projection) = (image.display().to_string(), projection.display().to_string());
    let args = ["xtask", "contract", "--json", "--against", &image, "--projection", &projection];
    let ended = gate.tools.run(gate.tools.cargo(&args), "contract")?;
    let violations: Vec<Value> = serde_json::from_str(&ended.stdout).map_err(|_| broken(&ended))?;
    let findings: Vec<Finding> = violations.iter().filter_map(violation).collect();
    match (ended.code, findings.len()) {
        (Some(0), 0) => Ok(Found { said: "nothing found".to_owned(), findings }),
        (Some(1), 1..) => Ok(Found { said: String::new(), findings }),
        _ => Err(broken(&ended)),
    }
}

fn violation(of: &Value) -> Option<Finding> {
    let text = |name: &str| of.get(name).and_then(Value::as_str);
    let (place, was, is) = (text("place")?, text("was")?, text("is")?);
    Some(Finding::at(PROTO, None, format!("{place}: was {was}, is {is}")).by(text("rule")?))
}

fn generated(gate: &Gate<'_>) -> Result<Found, Unrun> {
    let ended = gate.tools.run(gate.tools.cargo(&["xtask", "generate", "--check"]), "generated")?;
    let findings: Vec<Finding> = ended.stdout.lines().filter_map(stale).collect();
    match (ended.code, findings.is_empty()) {
        (Some(0), true) => {
            let last = ended.stdout.lines().last().unwrap_or_default().to_owned();
            Ok(Found { said: last, findings })
        }
        (Some(1), false) => Ok(Found { said: String::new(), findings }),
        _ => Err(broken(&ended)),
    }
}

/// A line such as `schemas/a.json:3: is not what would be generated`, of a file that is stale.
fn stale(line: &str) -> Option<Finding> {
    let (place, what) = line.split_once(": is ").filter(|_| !line.starts_with(' '))?;
    let (file, number) = match place.rsplit_once(':') {
        Some((file, number)) => (file, number.parse().ok()),
        None => (place, None),
    };
    Some(Finding::at(file, number, format!("is {what}")).by("stale"))
}

fn trace(gate: &Gate<'_>) -> Result<Found, Unrun> {
    let ended = gate.tools.run(gate.tools.cargo(&["assure", "trace", "--check"]), "trace")?;
    let faults = ended.stdout.lines().filter_map(|line| line.strip_prefix("✗ "));
    let findings: Vec<Finding> = faults.map(|fault| Finding::new(fault).by("trace")).collect();
    match (ended.code, findings.is_empty()) {
        (Some(0), true) => Ok(Found { said: ended.stdout.lines().next().unwrap_or_default().to_owned(), findings }),
        (Some(1), false) => Ok(Found { said: String::new(), findings }),
        _ => Err(broken(&ended)),
    }
}

fn proofs(gate: &Gate<'_>) -> Result<Found, Unrun> {
    let ended = gate.tools.run(gate.tools.cargo(&["assure", "status", "--json", "proofs"]), "proofs")?;
    let states: Vec<Value> = serde_json::from_str(&ended.stdout).map_err(|_| broken(&ended))?;
    let stale = states.iter().filter(|state| state.get("fresh").and_then(Value::as_bool) != Some(true));
    let findings: Vec<Finding> = stale
        .map(|state| {
            let text = |name: &str| state.get(name).and_then(Value::as_str).unwrap_or_default();
            let (name, command) = (text("name"), text("command"));
            let why = state.get("why").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
            let why: Vec<&str> = why.iter().filter_map(Value::as_str).collect();
            let file = if name == "proofs-page" { "reports/proofs.md" } else { &format!("reports/lock/{name}.toml") };
            Finding::at(file, None, format!("{name} is stale: {}: cargo {command}", why.join("; "))).by(name)
        })
        .collect();
    Ok(Found { said: format!("{} artefacts are fresh", states.len()), findings }.only_if_good())
}

/// A command that did not do what it is for, such as one that does not compile.
fn broken(ended: &Ended) -> Unrun {
    let no_such_command = ended.stderr.contains("no such command");
    if no_such_command { Unrun::Missing(ended.last_words()) } else { Unrun::broken(Finding::new(ended.last_words())) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_finding_of_buf_is_read_with_its_place() {
        let line = r#"{"path":"ncp.proto","start_line":7,"type":"FIELD_NO_DELETE","message":"It went."}"#;
        let finding = annotation(line).unwrap();
        assert_eq!(finding.place().as_deref(), Some("proto/ncp.proto:7"));
        assert_eq!((finding.text.as_str(), finding.rule.as_deref()), ("It went.", Some("FIELD_NO_DELETE")));
        assert_eq!(annotation("Failure: no such file"), None);
    }

    #[test]
    fn a_stale_file_is_read_with_its_line() {
        let finding = stale("schemas/a.json:3: is not what would be generated (case wire/b)").unwrap();
        assert_eq!(finding.place().as_deref(), Some("schemas/a.json:3"));
        assert_eq!(stale("schemas/a.json: is missing").unwrap().place().as_deref(), Some("schemas/a.json"));
        assert_eq!(stale("  is:        a: is b"), None);
        assert_eq!(stale("96 generated files, 0 stale"), None);
    }
}
