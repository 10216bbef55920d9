//! The gate on breakages that are prepared, each made in a copy of the tree and undone again; and on trees that lack
//! what it needs.

#![cfg(unix)]
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail that way")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use ncp_verifier::gate::{GateReport, ROWS, RowState, Verdict};
use serde::Deserialize;
use serde_json::Value;

/// A change of the tree, and what the gate says of it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Breakage {
    name: String,
    #[serde(default)]
    edits: Vec<Edit>,
    #[serde(default)]
    generate: bool,
    #[serde(default = "quick_rows")]
    rows: Vec<String>,
    #[serde(default)]
    fails: BTreeMap<String, String>,
    #[serde(default)]
    unrun: BTreeMap<String, String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Edit {
    file: String,
    replace: String,
    with: String,
}

#[derive(Deserialize)]
struct Breakages {
    breakage: Vec<Breakage>,
}

/// The prepared ones, with the wire version and the contract hash as they stand.
fn breakages() -> Vec<Breakage> {
    let (major, minor) = WIRE_VERSION.split_once('.').unwrap();
    let newer = format!("{major}.{}", minor.parse::<u32>().unwrap() + 1);
    let text = fs::read_to_string("tests/data/breakages.toml").unwrap();
    let text = text.replace("{wire}", WIRE_VERSION).replace("{newer}", &newer).replace("{contract}", CONTRACT_HASH);
    toml::from_str::<Breakages>(&text).unwrap().breakage
}

fn quick_rows() -> Vec<String> {
    ["identity", "corpus", "buf-lint", "buf-breaking", "contract", "generated"].map(str::to_owned).to_vec()
}

/// It compiles the project in a folder of its own: `cargo xtask test --only gate`. `NCP_GATE_ONLY` names a breakage.
#[test]
#[ignore = "compiles a copy of the project many times"]
fn the_gate_fails_by_the_right_row_for_each_prepared_breakage_and_for_no_other() {
    let breakages = breakages();
    let broken = breakages.iter().filter(|breakage| !breakage.fails.is_empty()).count();
    assert!(broken >= 15, "{broken} breakages");
    let failing: BTreeSet<&str> =
        breakages.iter().flat_map(|breakage| breakage.fails.keys().map(|row| &**row)).collect();
    assert_eq!(failing, ROWS.iter().map(|row| row.name).collect(), "every row has a breakage");

    let only = std::env::var("NCP_GATE_ONLY").unwrap_or_default();
    let copy = Copy::of_the_tree();
    let mut wrong = Vec::new();
    for breakage in breakages.iter().filter(|breakage| breakage.name.contains(&only)) {
        copy.make(breakage);
        let clock = std::time::Instant::now();
        let report = copy.gate(&breakage.rows);
        let faults = faults(breakage, &report);
        eprintln!("{:5.1} s  {}: {}", clock.elapsed().as_secs_f64(), breakage.name, report.verdict.as_str());
        faults.iter().for_each(|fault| eprintln!("         {fault}"));
        wrong.extend(faults.into_iter().map(|fault| format!("{}: {fault}", breakage.name)));
        copy.restore();
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What the gate says otherwise than it has to.
fn faults(breakage: &Breakage, report: &GateReport) -> Vec<String> {
    let mut faults = Vec::new();
    for row in report.rows.iter().filter(|row| breakage.rows.contains(&row.name)) {
        let texts = || {
            let of = |finding: &ncp_verifier::gate::Finding| {
                let (place, rule) = (finding.place().unwrap_or_default(), finding.rule.clone().unwrap_or_default());
                format!("{place}: {} [{rule}]", finding.text)
            };
            row.findings.iter().map(of).collect::<Vec<_>>().join("\n")
        };
        let (state, says, said) = match (breakage.fails.get(&row.name), breakage.unrun.get(&row.name)) {
            (Some(says), _) => (RowState::Failed, says.as_str(), texts()),
            (_, Some(says)) => (RowState::NotRun, says.as_str(), row.said.clone()),
            _ => (RowState::Passed, "", texts()),
        };
        if row.state != state {
            faults.push(format!(
                "{} {} instead of {}: {} {said}",
                row.name,
                row.state.as_str(),
                state.as_str(),
                row.said
            ));
        } else if !said.contains(says) {
            faults.push(format!("{} does not say {says:?}: {said}", row.name));
        }
        if row.remedy.is_some() == (state == RowState::Passed) {
            faults.push(format!("{} says what to do: {:?}", row.name, row.remedy));
        }
    }
    let is_open = breakage.fails.is_empty() && breakage.unrun.is_empty();
    if report.verdict != if is_open { Verdict::Open } else { Verdict::Shut } {
        faults.push(format!("the gate is {}", report.verdict.as_str()));
    }
    faults
}

/// A copy of the tree as it stands, under git of its own, with one bundled peer.
struct Copy {
    root: PathBuf,
    target: PathBuf,
    /// The program, apart from the one that somebody may build meanwhile.
    program: PathBuf,
}

impl Copy {
    /// Makes the copy, or brings it up to date; what did not change is left alone, so that cargo does, too.
    fn of_the_tree() -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("gate");
        let target = std::env::var_os("NCP_GATE_TARGET").map_or_else(|| folder.join("target"), PathBuf::from);
        let copy = Self { root: folder.join("tree"), target, program: folder.join("ncp-verify") };
        fs::create_dir_all(&copy.root).unwrap();
        fs::copy(env!("CARGO_BIN_EXE_ncp-verify"), &copy.program).unwrap();
        if copy.root.join(".git").exists() {
            copy.restore();
        } else {
            copy.git(&["init", "--quiet"]);
        }
        let own = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let list = ["ls-files", "--cached", "--others", "--exclude-standard"];
        let listed = success(Command::new("git").args(list).current_dir(own));
        let is_left_out = |file: &str| file.ends_with("/peer.toml") && file != "peers/python-pure/peer.toml";
        let files: BTreeSet<&str> =
            listed.lines().filter(|file| own.join(file).is_file() && !is_left_out(file)).collect();
        for file in copy.git(&["ls-files"]).lines().filter(|file| !files.contains(file)) {
            fs::remove_file(copy.root.join(file)).unwrap();
        }
        for file in files {
            let (from, to) = (own.join(file), copy.root.join(file));
            if fs::read(&to).ok() != Some(fs::read(&from).unwrap()) {
                fs::create_dir_all(to.parent().unwrap()).unwrap();
                fs::copy(from, to).unwrap();
            }
        }
        copy.git(&["add", "--all"]);
        copy.git(&["commit", "--quiet", "--allow-empty", "-m", "The tree as it went out"]);
        copy.git(&["tag", "--force", "v0"]);
        copy
    }

    /// Makes a breakage.
    fn make(&self, breakage: &Breakage) {
        for Edit { file, replace, with } in &breakage.edits {
            let path = self.root.join(file);
            let text = fs::read_to_string(&path).unwrap();
            let proto = fs::read_to_string(self.root.join("proto/ncp.proto")).unwrap();
            let with = with.replace("{hash}", &ncp_spec::contract::hash_of(&proto));
            let edited = if replace.is_empty() { text + &with } else { text.replacen(replace, &with, 1) };
            assert!(edited.contains(&with), "{}: {file} has no {replace}", breakage.name);
            fs::write(path, edited).unwrap();
        }
        if breakage.generate {
            success(self.cargo().args(["xtask", "generate"]));
        }
    }

    /// Asks rows of the gate. The maintainers' command is built without optimisation: it is used once a breakage.
    fn gate(&self, rows: &[String]) -> GateReport {
        let result = self.target.join("gate.json");
        fs::create_dir_all(&self.target).unwrap();
        fs::remove_file(&result).ok();
        let mut gate = self.cargo_env(Command::new(&self.program));
        gate.args(["gate", "--against", "v0", "--json"]).arg(&result);
        gate.args(rows.iter().flat_map(|row| ["--only", row]));
        let output = gate.output().unwrap();
        let text = fs::read_to_string(&result).unwrap_or_else(|_| panic!("{output:?}"));
        assert_eq!(schema_faults(&text), Vec::<String>::new());
        let report: GateReport = serde_json::from_str(&text).unwrap();
        assert_eq!(output.status.code(), Some(i32::from(report.exit().code())));
        report
    }

    fn restore(&self) {
        self.git(&["reset", "--hard", "--quiet"]);
        self.git(&["clean", "-d", "--force", "--quiet"]);
    }

    fn cargo(&self) -> Command {
        self.cargo_env(Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())))
    }

    fn cargo_env(&self, mut command: Command) -> Command {
        let own = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let buf = std::env::var_os("NCP_BUF").map_or_else(|| own.join(".tools/venv/bin/buf"), PathBuf::from);
        command
            .current_dir(&self.root)
            .stdin(Stdio::null())
            .env("CARGO_TARGET_DIR", &self.target)
            .env("CARGO_ALIAS_ASSURE", "run --quiet -p ncp-assurance --")
            .env("NCP_BUF", buf);
        command
    }

    fn git(&self, args: &[&str]) -> String {
        let own = ["-c", "user.name=gate", "-c", "user.email=gate@example.invalid", "-c", "commit.gpgsign=false"];
        success(Command::new("git").args(own).args(args).current_dir(&self.root))
    }
}

fn success(command: &mut Command) -> String {
    let output = command.output().unwrap();
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// What is wrong with a result by its schema.
fn schema_faults(text: &str) -> Vec<String> {
    let schema: Value = serde_json::from_str(&fs::read_to_string("../schemas/gate.schema.json").unwrap()).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let result: Value = serde_json::from_str(text).unwrap();
    validator.iter_errors(&result).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

mod in_a_small_tree {
    use super::*;

    const PROTO: &str = "syntax = \"proto3\";\npackage ncp.v0;\nmessage M {\n  string kind = 1;\n}\n";
    const CASE: &str =
        r#"{"cases": [{"id": "wire/a", "call": "decode", "args": {"n": 1}, "expect": {"accept": true}}]}"#;

    /// A tree with a contract, a text and a case, and nothing that a command of the project needs.
    fn tree() -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        let hash = ncp_spec::contract::hash_of(PROTO);
        let chapter =
            format!("# 2\n\nThe wire version of this text is `0.5`.\n\nThe contract hash of this text is `{hash}`.\n");
        write(folder.path(), "proto/ncp.proto", PROTO);
        write(folder.path(), "proto/projection.json", &format!(r#"{{"wire": "0.5", "contract_hash": "{hash}"}}"#));
        write(folder.path(), "spec/text/02-version-and-identity.md", &chapter);
        write(folder.path(), "vectors/corpus/wire/a.json", CASE);
        write(folder.path(), "before/proto/ncp.proto", PROTO);
        write(folder.path(), "before/proto/projection.json", r#"{"wire": "0.5"}"#);
        write(folder.path(), "before/vectors/corpus/wire/a.json", CASE);
        folder
    }

    fn write(root: &Path, file: &str, text: &str) {
        let file = root.join(file);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }

    fn gate(root: &Path, columns: &str, args: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-verify"));
        command.current_dir(root).stdin(Stdio::null()).env("COLUMNS", columns).env("NCP_BUF", "/no/such/buf");
        command.args(["gate", "--against", "before"]).args(args).output().unwrap()
    }

    fn stdout(output: &Output) -> String {
        String::from_utf8(output.stdout.clone()).unwrap()
    }

    #[test]
    fn the_table_fits_a_terminal_and_says_of_each_row_what_to_do() {
        let folder = tree();
        write(folder.path(), "vectors/corpus/wire/a.json", &CASE.replace("true", "false"));
        for columns in ["80", "200"] {
            let output = gate(folder.path(), columns, &["--skip", "peers"]);
            assert_eq!(output.status.code(), Some(1));
            let text = stdout(&output);
            let widest = text.lines().map(|line| line.chars().count()).max().unwrap();
            assert!(widest <= columns.parse().unwrap(), "{text}");
            insta::assert_snapshot!(format!("gate_{columns}"), text);
        }
    }

    #[test]
    fn a_row_that_cannot_be_run_keeps_the_gate_shut_unless_it_may_be_missing() {
        let folder = tree();
        let rows = ["--only", "identity", "--only", "corpus", "--only", "buf-lint"];
        assert_eq!(gate(folder.path(), "80", &rows[..4]).status.code(), Some(0));
        let shut = gate(folder.path(), "80", &rows);
        assert_eq!(shut.status.code(), Some(1));
        assert!(stdout(&shut).contains("the gate is shut: 1 row was not run, 2 rows passed"), "{}", stdout(&shut));
        let open = gate(folder.path(), "80", &[&rows[..], &["--allow-missing", "buf-lint"]].concat());
        assert_eq!(open.status.code(), Some(0));
        assert!(stdout(&open).contains("the gate is open"), "{}", stdout(&open));
    }

    #[test]
    fn what_cannot_be_asked_is_a_usage_error() {
        let folder = tree();
        for args in [
            &["--only", "no-such-row"][..],
            &["--against", "no-such-ref"],
            &["--against", "vectors"],
            &["--report", "html=gate.html"],
        ] {
            assert_eq!(gate(folder.path(), "80", args).status.code(), Some(2), "{args:?}");
        }
        let elsewhere = tempfile::tempdir().unwrap();
        let output = gate(elsewhere.path(), "80", &[]);
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains("proto/ncp.proto"), "{output:?}");
    }

    #[test]
    fn every_format_is_of_one_result() {
        let folder = tree();
        write(folder.path(), "vectors/corpus/wire/a.json", &CASE.replace("true", "false"));
        let formats = ["junit", "md", "sarif", "json"].map(|format| format!("{format}=gate.{format}"));
        let mut args = vec!["--skip", "peers", "--allow-missing", "trace"];
        formats.iter().for_each(|format| args.extend(["--report", format]));
        gate(folder.path(), "80", &args);
        let read = |file: &str| fs::read_to_string(folder.path().join(file)).unwrap();
        let result = read("reports/run/gate.json");
        assert_eq!(result, read("gate.json"));
        assert_eq!(schema_faults(&result), Vec::<String>::new());
        let report: GateReport = serde_json::from_str(&result).unwrap();
        assert_eq!((report.verdict, report.rows.len()), (Verdict::Shut, ROWS.len()));
        let even = |text: &str| {
            let version = format!("\"{}\"", report.tool.version);
            let text = text.replace(&report.started, "STARTED").replace(&version, "\"VERSION\"");
            let text = text.replace(&format!("ncp-verify {}", report.tool.version), "ncp-verify VERSION");
            text.split(" time=\"").enumerate().fold(String::new(), |out, (at, part)| {
                let rest = if at == 0 { part } else { part.split_once('"').unwrap().1 };
                out + rest
            })
        };
        for format in ["junit", "md", "sarif"] {
            insta::assert_snapshot!(format!("gate_{format}"), even(&read(&format!("gate.{format}"))));
        }
        let schema = fs::read_to_string("tests/data/sarif-2.1.0.schema.json").unwrap();
        let schema: Value = serde_json::from_str(&schema.replace("-[a-zA-Z]{2}]?$", "-[a-zA-Z]{2}$")).unwrap();
        let validator = jsonschema::validator_for(&schema).unwrap();
        let sarif: Value = serde_json::from_str(&read("gate.sarif")).unwrap();
        let faults: Vec<_> = validator.iter_errors(&sarif).map(|error| error.to_string()).collect();
        assert_eq!(faults, Vec::<String>::new());
    }

    /// The script of the step with this name, or of an entry.
    fn script(file: &str, after: &str, key: &str) -> String {
        let text = fs::read_to_string(Path::new("..").join(file)).unwrap();
        let of_it = text.split(after).nth(1).unwrap();
        let (indent, run) = of_it.lines().find_map(|line| line.split_once(&format!("{key}: "))).unwrap();
        if !matches!(run, "|" | ">-") {
            return run.to_owned();
        }
        let block = of_it.split(&format!("{key}: {run}\n")).nth(1).unwrap();
        let deeper = " ".repeat(indent.len() + 1);
        let lines: Vec<&str> = block.lines().take_while(|line| line.starts_with(&deeper)).map(str::trim).collect();
        lines.join(if run == "|" { "\n" } else { " " })
    }

    #[test]
    fn action_workflow_hook_and_recipe_ask_the_gate_by_their_own_steps() {
        let folder = tree();
        let root = folder.path();
        let scripts = std::path::absolute("../.ci").unwrap();
        std::os::unix::fs::symlink(&scripts, root.join(".ci")).unwrap();
        let rows = "--only identity --only corpus";
        let sh = |script: &str, options: &str| {
            let mut sh = Command::new("sh");
            sh.current_dir(root).args(["-c", script]).stdin(Stdio::null()).env_remove("COLUMNS");
            sh.env("NCP_VERIFY", env!("CARGO_BIN_EXE_ncp-verify")).env("NCP_BUF", "/no/such/buf");
            sh.env("AGAINST", "before").env("OPTIONS", options).env("FOLDER", "gate").env("SCRIPT", ".ci/gate");
            sh.env("GITHUB_STEP_SUMMARY", root.join("summary")).env("GITHUB_OUTPUT", root.join("output"));
            sh.output().unwrap()
        };
        let read = |file: &str| fs::read_to_string(root.join(file)).unwrap();
        let action = script("action.yml", "- name: gate", "run");
        let workflow = script(".github/workflows/gate.yml", "- name: gate", "run");
        let hook = script(".pre-commit-hooks.yaml", "- id: ncp-gate\n", "entry");
        let hook =
            format!("{hook} --against before --skip buf-lint --skip buf-breaking --skip contract --skip generated");
        let push = script(".pre-commit-hooks.yaml", "- id: ncp-gate-push", "entry") + " --against before " + rows;
        for step in [&action, &workflow, &hook, &push] {
            let open = sh(step, rows);
            assert_eq!(open.status.code(), Some(0), "{step}: {open:?}");
            assert!(stdout(&open).contains("the gate is open: 2 rows passed"), "{step}: {open:?}");
        }
        assert_eq!(read("output"), "verdict=open\n");
        assert_eq!(read("summary").matches("## Gate: open").count(), 4);
        for format in ["json", "xml", "md", "sarif"] {
            assert!(!read(&format!("gate/gate.{format}")).is_empty(), "{format}");
        }
        write(root, "vectors/corpus/wire/a.json", &CASE.replace("true", "false"));
        for step in [&action, &workflow, &hook, &push] {
            assert_eq!(sh(step, rows).status.code(), Some(1), "{step}");
        }
        assert_eq!(read("output"), "verdict=open\nverdict=shut\n");

        // The recipe of the page, line by line.
        let page = fs::read_to_string("README.md").unwrap();
        let recipe = page.split("<!-- recipe -->").nth(1).unwrap().split("```").nth(1).unwrap();
        let recipe = recipe.trim_start_matches("sh\n").replace("cargo xtask test --only buf-lint", "true");
        let recipe = recipe.replace("cargo verify gate", &format!("\"$NCP_VERIFY\" gate --against before {rows}"));
        assert_eq!(sh(&recipe, "").status.code(), Some(1), "{recipe}");
        write(root, "vectors/corpus/wire/a.json", CASE);
        let open = sh(&recipe, "");
        assert_eq!(open.status.code(), Some(0), "{recipe}: {open:?}");
        assert!(read("gate.md").contains("## Gate: open"));
    }

    #[test]
    fn an_interrupted_gate_still_shows_its_table() {
        use std::os::unix::fs::PermissionsExt as _;
        let folder = tree();
        write(folder.path(), "proto/buf.yaml", "");
        write(folder.path(), "buf", "#!/bin/sh\ntouch started\nsleep 60\n");
        let buf = folder.path().join("buf");
        fs::set_permissions(&buf, fs::Permissions::from_mode(0o755)).unwrap();
        let clock = std::time::Instant::now();
        let mut gate = Command::new(env!("CARGO_BIN_EXE_ncp-verify"));
        gate.current_dir(folder.path()).env("NCP_BUF", buf).stdin(Stdio::null());
        let gate = gate.args(["gate", "--against", "before"]).stdout(Stdio::piped()).stderr(Stdio::null());
        let child = gate.spawn().unwrap();
        while !folder.path().join("proto/started").exists() {
            assert!(clock.elapsed().as_secs() < 60);
            std::thread::sleep(std::time::Duration::from_millis(20));
        }
        let clock = std::time::Instant::now();
        success(Command::new("kill").args(["-INT", &child.id().to_string()]));
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130));
        assert!(clock.elapsed().as_secs() < 30);
        let text = stdout(&output);
        assert!(text.contains("✓ passed") && text.contains("interrupted: the gate is shut"), "{text}");
        let report: GateReport =
            serde_json::from_str(&fs::read_to_string(folder.path().join("reports/run/gate.json")).unwrap()).unwrap();
        assert_eq!(report.verdict, Verdict::Interrupted);
        assert_eq!(report.count(RowState::Passed), 2);
    }
}
