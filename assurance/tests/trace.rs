//! `cargo assure trace` on small trees of its own: what passes, and what each fault is called.

#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use ncp_text::CHAPTERS;
use serde_json::{Value, json};
use tempfile::TempDir;

const TEXT: &str = "\
# 1. Test

- **[NCP-TEST-001]** A peer MUST do one thing. *(wire; all)*
- **[NCP-TEST-002]** A peer MUST do another thing. *(wire; all)*
- **[NCP-TEST-003]** A peer SHOULD do a third. *(wire; all)*
";
const CODE: &str = "\
//! Does things.

/// Does one. `[NCP-TEST-001]`
pub fn does_one() {}
";
const TESTS: &str = "\
proptest! {
    /// [NCP-TEST-002]
    #[test]
    fn it_does_another(x in 0..3) {}
}
";

/// A tree in which everything is shown: rule 1 by a vector file, rule 2 by a property.
struct Tree(TempDir);

impl Tree {
    fn new() -> Self {
        let tree = Self(TempDir::new().unwrap());
        for chapter in CHAPTERS {
            tree.write(&format!("spec/text/{}", chapter.file), "# Nothing\n");
        }
        tree.write(&format!("spec/text/{}", CHAPTERS[1].file), TEXT);
        tree.write("spec/src/wire/one.rs", CODE);
        tree.write("spec/tests/other.rs", TESTS);
        tree.write("spec/kernel/src/lib.rs", "");
        tree.write("proto/src/lib.rs", "");
        tree.write("proto/tests/none.rs", "");
        tree.write("peers/zenoh/tests/none.rs", "");
        tree.write("peers/typescript/src/one.ts", "// [NCP-TEST-001]\n");
        tree.write("peers/python-pure/ncp_pure/one.py", "# [NCP-TEST-001]\n");
        tree.write("defects/peer/wire.toml", &mutant("NCP-TEST-001"));
        tree.write("vectors/corpus/wire/one.json", &vectors(&["NCP-TEST-001"]));
        tree.write("vectors/MANIFEST.sha256", "00  corpus/wire/one.json\n");
        let mut exclusions = "# Rules.\n".to_owned();
        for number in 1..=35 {
            write!(exclusions, "\n[findings.L{number:02}]\nrules = []\nwhy = \"Nothing in this tree is audited.\"\n")
                .unwrap();
        }
        tree.write("spec/exclusions.toml", &exclusions);
        tree
    }

    /// A tree that was traced, so that its evidence is accepted.
    fn accepted() -> Self {
        let tree = Self::new();
        let (exit, out) = tree.trace(&[]);
        assert_eq!(exit, 0, "{out}");
        tree
    }

    fn root(&self) -> &Path {
        self.0.path()
    }

    fn write(&self, file: &str, text: &str) {
        let path = self.root().join(file);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    fn read(&self, file: &str) -> String {
        std::fs::read_to_string(self.root().join(file)).unwrap()
    }

    fn replace(&self, file: &str, from: &str, to: &str) {
        let text = self.read(file);
        assert!(text.contains(from), "{file} lacks {from}");
        self.write(file, &text.replace(from, to));
    }

    fn trace(&self, args: &[&str]) -> (i32, String) {
        let output = Command::new(env!("CARGO_BIN_EXE_ncp-assurance"))
            .args(["trace", "--root"])
            .arg(self.root())
            .args(args)
            .env("COLUMNS", "160")
            .output()
            .unwrap();
        let printed = [output.stdout, output.stderr].concat();
        let printed = String::from_utf8(printed).unwrap();
        (output.status.code().unwrap(), printed.split_whitespace().collect::<Vec<_>>().join(" "))
    }

    /// Traces, and expects exit code 1 with these words.
    fn fails_with(&self, words: &[&str]) {
        let (exit, out) = self.trace(&[]);
        assert_eq!(exit, 1, "{out}");
        for word in words {
            assert!(out.contains(word), "{word:?} is not in: {out}");
        }
    }
}

fn vectors(rules: &[&str]) -> String {
    let case = json!({"id": "wire/one/a", "requirements": rules, "flags": []});
    json!({ "cases": [case] }).to_string()
}

fn mutant(rule: &str) -> String {
    format!(
        "# A table.\n\n[[defect]]\nname = \"one-left-out\"\nabout = \"It does nothing.\"\nrules = [\"{rule}\"]\n\
         edit = [{{ file = \"a.rs\", code = \"a\", with = \"b\" }}]\n"
    )
}

#[test]
fn the_matrix_alone_is_written_with_the_line_of_each_place_whatever_is_wrong() {
    let tree = Tree::new();
    tree.write("spec/src/wire/one.rs", "/// [NCP-TEST-009]\npub fn does_one() {}\n");
    let file = tree.root().join("site/matrix.json");
    let (exit, out) = tree.trace(&["--matrix", file.to_str().unwrap()]);
    assert_eq!((exit, out.as_str()), (0, ""));
    let matrix: Value = serde_json::from_str(&tree.read("site/matrix.json")).unwrap();
    assert_eq!(matrix["faults"].as_array().unwrap().len(), 1, "{}", matrix["faults"]);
    assert_eq!(matrix["wire_version"], ncp_text::WIRE_VERSION);
    let rule = &matrix["rules"][1];
    assert_eq!((&rule["id"], &rule["line"]), (&json!("NCP-TEST-002"), &json!(4)));
    let property = json!(
        {"kind": "properties", "place": "spec/tests/other.rs it_does_another", "line": 4, "count": 1}
    );
    assert_eq!(rule["evidence"], json!([property]));
    assert!(!tree.root().join("reports").exists());
}

#[test]
fn a_tree_in_which_everything_is_shown_passes_and_leaves_its_reports() {
    let tree = Tree::new();
    let (exit, out) = tree.trace(&[]);
    assert_eq!(exit, 0, "{out}");
    assert!(out.contains("3 rules, 2 of them binding: 2 shown, 0 excluded with a reason"), "{out}");
    let page = tree.read("reports/full/traceability.md");
    assert!(page.contains("NCP-TEST-001") && page.contains("[one.json](../../vectors/corpus/wire/one.json) 1"));
    let report: Value = serde_json::from_str(&tree.read("reports/full/traceability.json")).unwrap();
    let evidence = &report["rules"][1]["evidence"];
    let property = json!({"kind": "properties", "place": "spec/tests/other.rs it_does_another", "line": 4, "count": 1});
    assert_eq!(evidence, &json!([property]));
    assert!(tree.read("reports/lock/trace.toml").contains("vectors/corpus/wire/one.json"));
    assert_eq!(tree.trace(&["--check"]).0, 0);
}

#[test]
fn a_fuzz_target_shows_what_the_function_of_its_name_cites() {
    let tree = Tree::new();
    tree.write("fuzz/fuzz_targets/things.rs", "fuzz_target!(things);\n");
    tree.write("fuzz/bodies/src/all.rs", "// [NCP-TEST-003]\npub fn things(input: &[u8]) {}\n");
    let (exit, out) = tree.trace(&[]);
    assert_eq!(exit, 0, "{out}");
    let report: Value = serde_json::from_str(&tree.read("reports/full/traceability.json")).unwrap();
    assert_eq!(
        report["rules"][2]["evidence"],
        json!([{"kind": "fuzz", "place": "fuzz/bodies/src/all.rs things", "line": 2, "count": 1}])
    );
    tree.replace("fuzz/bodies/src/all.rs", "NCP-TEST-003", "NCP-TEST-099");
    tree.fails_with(&["NCP-TEST-099 is not in the text", "all.rs:2 things"]);
}

#[test]
fn a_fuzz_target_that_cites_no_rule_or_checks_nothing_is_an_orphan() {
    let tree = Tree::new();
    tree.write("fuzz/fuzz_targets/silent.rs", "fuzz_target!(silent);\n");
    tree.write("fuzz/fuzz_targets/empty.rs", "fuzz_target!(empty);\n");
    tree.write("fuzz/bodies/src/all.rs", "pub fn silent(input: &[u8]) {}\n");
    tree.fails_with(&["the fuzz target silent cites no rule", "the fuzz target empty cites no rule"]);
}

#[test]
fn a_vector_file_that_is_gone_is_named_with_the_rules_that_it_showed() {
    let tree = Tree::accepted();
    std::fs::remove_file(tree.root().join("vectors/corpus/wire/one.json")).unwrap();
    tree.fails_with(&[
        "vectors/corpus/wire/one.json is in the manifest and is gone; orphaned is its evidence for NCP-TEST-001",
        "NCP-TEST-001 has lost vectors/corpus/wire/one.json",
        "NCP-TEST-001 is binding, and nothing shows it: A peer MUST do one thing.",
    ]);
}

#[test]
fn an_id_that_is_renamed_in_the_text_orphans_what_cites_it() {
    let tree = Tree::accepted();
    let chapter = format!("spec/text/{}", CHAPTERS[1].file);
    tree.replace(&chapter, "NCP-TEST-001", "NCP-TEST-009");
    tree.fails_with(&[
        "NCP-TEST-001 is not in the text; orphaned are peers/python-pure/ncp_pure/one.py:1, \
         peers/typescript/src/one.ts:1, \
         spec/src/wire/one.rs:4 does_one, vectors/corpus/wire/one.json (1 case)",
        "NCP-TEST-001 is gone from the text; orphaned is vectors/corpus/wire/one.json",
        "NCP-TEST-009 is binding, and nothing shows it",
    ]);
}

#[test]
fn a_sentence_that_changes_has_to_be_accepted_again() {
    let tree = Tree::accepted();
    let chapter = format!("spec/text/{}", CHAPTERS[1].file);
    tree.replace(&chapter, "do another thing", "leave another thing");
    tree.fails_with(&[
        "the sentence of NCP-TEST-002 changed",
        "spec/tests/other.rs it_does_another",
        "cargo assure trace --accept",
    ]);
    let (exit, out) = tree.trace(&["--accept"]);
    assert_eq!(exit, 0, "{out}");
    assert_eq!(tree.trace(&["--check"]).0, 0);
}

#[test]
fn evidence_that_is_gone_is_missed_although_other_evidence_is_left() {
    let tree = Tree::new();
    tree.write("spec/tests/more.rs", &TESTS.replace("it_does_another", "and_again"));
    assert_eq!(tree.trace(&[]).0, 0);
    tree.write("spec/tests/more.rs", "");
    tree.fails_with(&["NCP-TEST-002 has lost spec/tests/more.rs and_again"]);
}

#[test]
fn what_cites_no_rule_is_an_orphan() {
    for (file, text, fault) in [
        (
            "spec/src/wire/two.rs",
            "pub fn does_two() {}\n",
            "the public function spec/src/wire/two.rs:1 does_two cites no rule",
        ),
        (
            "spec/tests/two.rs",
            "proptest! {\n    #[test]\n    fn it_holds(x in 0..3) {}\n}\n",
            "the property spec/tests/two.rs:3 it_holds cites no rule",
        ),
        ("vectors/corpus/wire/two.json", &vectors(&[]), "the case wire/one/a cites no rule"),
    ] {
        let tree = Tree::accepted();
        tree.write(file, text);
        tree.fails_with(&[fault]);
    }
}

#[test]
fn code_alone_shows_nothing_and_an_exclusion_says_why() {
    let tree = Tree::accepted();
    let chapter = format!("spec/text/{}", CHAPTERS[1].file);
    let rule = "- **[NCP-TEST-004]** A peer MUST do a fourth. *(wire; all)*\n";
    tree.write(&chapter, &format!("{TEXT}{rule}"));
    tree.write("spec/src/wire/four.rs", "/// [NCP-TEST-004]\npub fn four() {}\n");
    tree.fails_with(&["NCP-TEST-004 is binding, and nothing shows it"]);

    let reason = "[rules.NCP-TEST-004]\nwithout = [\"evidence\"]\nwhy = \"No call can show it.\"\n";
    tree.replace("spec/exclusions.toml", "# Rules.\n", reason);
    let (exit, out) = tree.trace(&[]);
    assert_eq!(exit, 0, "{out}");
    assert!(tree.read("reports/traceability.md").contains("No call can show it."));

    tree.replace("spec/exclusions.toml", "NCP-TEST-004", "NCP-TEST-001");
    tree.fails_with(&["spec/exclusions.toml names NCP-TEST-001, which is shown", "NCP-TEST-004 is binding"]);
}

#[test]
fn a_mutant_is_counted_for_its_rule_and_shows_nothing_by_itself() {
    let tree = Tree::accepted();
    let report: Value = serde_json::from_str(&tree.read("reports/full/traceability.json")).unwrap();
    let place = "defects/peer/wire.toml one-left-out";
    let evidence = report["rules"][0]["evidence"].as_array().unwrap();
    assert!(evidence.contains(&json!({"kind": "mutants", "place": place, "line": 4, "count": 1})));
    let page = tree.read("reports/full/traceability.md");
    assert!(page.contains("[one-left-out](../../defects/peer/wire.toml)"), "{page}");
    assert!(!tree.read("reports/lock/trace.toml").contains("defects/peer"));

    // Rule 2 has a mutant now, and no property any more.
    tree.write("defects/peer/wire.toml", &mutant("NCP-TEST-002"));
    tree.write("spec/tests/other.rs", "");
    tree.fails_with(&["NCP-TEST-002 is binding, and nothing shows it"]);
}

#[test]
fn a_mutant_of_a_rule_that_the_text_does_not_have_is_a_fault() {
    let tree = Tree::accepted();
    tree.write("defects/peer/wire.toml", &mutant("NCP-TEST-404"));
    tree.fails_with(&["NCP-TEST-404 is not in the text; orphaned are defects/peer/wire.toml:4 one-left-out"]);
    tree.write("defects/peer/wire.toml", "[[defect]]\n");
    let (exit, out) = tree.trace(&[]);
    assert_eq!(exit, 4, "{out}");
    assert!(out.contains("defects/peer/wire.toml"), "{out}");
}

#[test]
fn a_stale_report_fails_the_check_and_is_left_alone() {
    let tree = Tree::accepted();
    tree.write("reports/traceability.md", "old\n");
    let (exit, out) = tree.trace(&["--check"]);
    assert_eq!(exit, 1);
    assert!(out.contains("reports/traceability.md is stale"), "{out}");
    assert_eq!(tree.read("reports/traceability.md"), "old\n");
}

#[test]
fn a_tree_that_is_none_is_said() {
    let folder = TempDir::new().unwrap();
    let tree = Tree(folder);
    let (exit, out) = tree.trace(&[]);
    assert_eq!(exit, 4, "{out}");
    assert!(out.contains("spec/text"), "{out}");
}

#[test]
fn a_live_scenario_shows_the_rules_that_it_found_kept_and_one_that_judges_none_is_an_orphan() {
    let tree = Tree::new();
    let scenario = "[[scenario]]\nname = \"qos/planes\"\nrules = [\"NCP-TEST-003\"]\n";
    let found = |verdict: &str| format!("[fates]\n\"qos/planes NCP-TEST-003\" = {verdict:?}\n");
    let evidence = || {
        let (exit, out) = tree.trace(&[]);
        assert_eq!(exit, 0, "{out}");
        let report: Value = serde_json::from_str(&tree.read("reports/full/traceability.json")).unwrap();
        report["rules"][2]["evidence"].clone()
    };
    tree.write("live/scenarios.toml", scenario);
    assert_eq!(evidence(), json!([]), "it was never run");
    tree.write("reports/lock/live.toml", &found("inconclusive"));
    assert_eq!(evidence(), json!([]));
    tree.write("reports/lock/live.toml", &found("passed"));
    let live = json!({"kind": "live", "place": "live/scenarios.toml qos/planes", "line": 2, "count": 1});
    assert_eq!(evidence(), json!([live]));

    tree.write("live/scenarios.toml", &scenario.replace("NCP-TEST-003", "NCP-TEST-099"));
    tree.fails_with(&["NCP-TEST-099 is not in the text", "live/scenarios.toml:2 qos/planes"]);
    tree.write("live/scenarios.toml", "[[scenario]]\nname = \"qos/planes\"\nrules = []\n");
    tree.fails_with(&["the live scenario qos/planes cites no rule"]);
}

#[test]
fn what_is_proved_shows_its_rules_and_what_is_only_tried_does_not() {
    let lock = |verdict: &str| {
        let sources = "[sources]\n[counts]\n";
        format!(
            "{sources}[fates]\n\"symbolic clamp/bound\" = \"{verdict}\"\n[rules]\n\
             \"clamp/bound\" = [\"NCP-TEST-004\"]\n"
        )
    };
    let tree = Tree::accepted();
    let chapter = format!("spec/text/{}", CHAPTERS[1].file);
    let rule = "- **[NCP-TEST-004]** A peer MUST do a fourth. *(wire; all)*\n";
    tree.write(&chapter, &format!("{TEXT}{rule}"));
    tree.write("reports/lock/proofs-kernel.toml", &lock("tried"));
    tree.fails_with(&["NCP-TEST-004 is binding, and nothing shows it"]);
    tree.write("reports/lock/proofs-kernel.toml", &lock("proved for the listed values"));
    let (exit, out) = tree.trace(&[]);
    assert_eq!(exit, 0, "{out}");
    let page = tree.read("reports/full/traceability.md");
    assert!(page.contains("[clamp/bound](../../reports/proofs.md)"), "{page}");
}
