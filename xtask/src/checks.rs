//! What `cargo xtask test` checks: in each lane, what fails fastest first.

use std::env;
use std::fmt::Display;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::generate;
use crate::package;
use crate::project::Project;
use crate::setup;
use crate::site;
use crate::tally::Tally;
use crate::work::{Failure, Work};

/// One named check.
pub(crate) struct Check {
    pub(crate) name: &'static str,
    /// What it checks, for `--list`.
    pub(crate) about: &'static str,
    pub(crate) lane: Lane,
    /// Whether it runs here without being asked for.
    pub(crate) runs: fn(&Project) -> bool,
    /// Checks it, and counts its tests.
    pub(crate) run: fn(&mut Work<'_>) -> Result<Tally, Failure>,
}

/// The checks of one lane run one after the other, beside those of the other lane. A lane that has ended takes from the
/// end of the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Lane {
    /// What cargo builds without optimisation, and what needs no build.
    Crates,
    /// The other languages, and what cargo builds with optimisation.
    Peers,
}

/// All checks, in the order in which they begin.
pub(crate) const CHECKS: &[Check] = &[
    Check {
        name: "format",
        about: "the Rust code is formatted (rustfmt), and no line is too long for it",
        lane: Lane::Crates,
        runs: always,
        run: format,
    },
    Check {
        name: "contract",
        about: "proto and projection break nothing of the frozen contract (our own check)",
        lane: Lane::Crates,
        runs: always,
        run: |_| nothing_wrong(&ncp_proto::compat::check_current(), ""),
    },
    Check {
        name: "generated",
        about: "schemas, vectors with their manifest, and the C header are what would be generated",
        lane: Lane::Crates,
        runs: always,
        run: |work| {
            let stale = generate::check(work.project, "").map_err(|error| Failure::of_one(error.to_string()))?;
            nothing_wrong(&stale, "\nif this is meant: cargo xtask generate")
        },
    },
    Check {
        name: "clippy",
        about: "the Rust code is free of warnings (clippy, all targets)",
        lane: Lane::Crates,
        runs: always,
        run: |work| {
            let targets = ["clippy", "--workspace", "--all-targets", "--quiet", "--keep-going"];
            work.program(work.project.cargo(&[&targets[..], &["--", "-D", "warnings"]].concat()))
        },
    },
    Check {
        name: "doc",
        about: "the documentation builds without a warning (rustdoc)",
        lane: Lane::Crates,
        runs: always,
        run: |work| {
            let mut cargo = work.project.cargo(&["doc", "--workspace", "--no-deps", "--quiet", "--keep-going"]);
            cargo.env("RUSTDOCFLAGS", "-D warnings");
            work.program(cargo)
        },
    },
    Check {
        name: "rust",
        about: "all tests of all crates but those of cpp and fuzz-corpus",
        lane: Lane::Crates,
        runs: always,
        run: |work| rust_tests(work, &[]),
    },
    Check {
        name: "fuzz-corpus",
        about: "every committed input of every fuzz target passes, and so does every seed",
        lane: Lane::Crates,
        runs: always,
        run: |work| rust_tests(work, &[]),
    },
    Check {
        name: "doctests",
        about: "the examples in the documentation of all crates",
        lane: Lane::Crates,
        runs: always,
        run: |work| work.program(work.project.cargo(&["test", "--workspace", "--doc", "--quiet", "--no-fail-fast"])),
    },
    Check {
        name: "buf-lint",
        about: "the proto follows buf's rules",
        lane: Lane::Peers,
        runs: always,
        run: |work| {
            let buf = work.set_up(setup::buf)?;
            work.program(work.project.program(buf, &["lint"], "proto"))
        },
    },
    Check {
        name: "buf-breaking",
        about: "the proto breaks nothing of the frozen image (buf: FILE and WIRE_JSON)",
        lane: Lane::Peers,
        runs: always,
        run: |work| {
            let buf = work.set_up(setup::buf)?;
            let against = ["breaking", "--against", "baseline/ncp-0.5.binpb"];
            work.program(work.project.program(buf, &against, "proto"))
        },
    },
    Check {
        name: "deny",
        about: "the dependencies: licences, sources, bans (cargo-deny; without --only, where it is installed)",
        lane: Lane::Peers,
        runs: setup::has_deny,
        run: |work| {
            let deny = work.set_up(setup::deny)?;
            work.program(work.project.program(deny, &["deny", "check", "bans", "licenses", "sources"], ""))
        },
    },
    Check {
        name: "python-pure",
        about: "the own tests of the peer in pure Python (unittest)",
        lane: Lane::Peers,
        runs: always,
        run: |work| python_tests(work, Path::new("python3"), "peers/python-pure", &[]),
    },
    Check {
        name: "typescript",
        about: "the TypeScript peer's own tests: library, client, generated types, packed package",
        lane: Lane::Peers,
        runs: always,
        run: |work| {
            work.set_up(setup::typescript)?;
            node_tests(work, "peers/typescript", &["test", "--silent"])
        },
    },
    Check {
        name: "browser",
        about: "the TypeScript package, imported by a page in a headless Chromium, runs a session",
        lane: Lane::Peers,
        runs: always,
        run: |work| {
            work.set_up(setup::browser)?;
            node_tests(work, "peers/typescript", &["run", "test:browser", "--silent"])
        },
    },
    Check {
        name: "python",
        about: "the Python peer's own tests: API, numpy, hostile input, stubs, wheel, adapter",
        lane: Lane::Peers,
        runs: always,
        run: |work| {
            let python = work.set_up(setup::python)?;
            python_tests(work, &python, "peers/python", &["-s", "tests"])
        },
    },
    Check {
        name: "conformance",
        about: "every bundled peer conforms at the level that it claims (cargo verify)",
        lane: Lane::Peers,
        runs: always,
        run: conformance,
    },
    Check {
        name: "plugins",
        about: "the plugin of pytest and the tests of node:test say of a peer what ncp-verify says",
        lane: Lane::Peers,
        runs: always,
        run: plugins,
    },
    Check {
        name: "deep",
        about: "the specification and both implementations from the text keep the deep set (ncp-verify run --deep)",
        lane: Lane::Peers,
        runs: always,
        run: deep,
    },
    Check {
        name: "status",
        about: "what is made in minutes is about the sources as they are (cargo assure status; nightly: all)",
        lane: Lane::Peers,
        runs: always,
        run: |work| work.program(work.project.cargo(&[ASSURE, &["status", "--quick"]].concat())),
    },
    Check {
        name: "prove",
        about: "the quick half of the proofs says what the locks say (cargo assure prove --fast; nightly: all)",
        lane: Lane::Peers,
        runs: always,
        run: |work| work.program(work.project.cargo(&[ASSURE, &["prove", "--fast"]].concat())),
    },
    Check {
        name: "trace",
        about: "every binding rule is shown, and all evidence cites rules (cargo assure trace)",
        lane: Lane::Peers,
        runs: always,
        run: |work| work.program(work.project.cargo(&[ASSURE, &["trace", "--check"]].concat())),
    },
    Check {
        name: "site",
        about: "the site: its links, its contents against the sources, and its pages in a headless Chromium",
        lane: Lane::Peers,
        runs: always,
        run: |work| {
            work.set_up(setup::site_tests)?;
            work.program(site::matrix(work.project))?;
            node_tests(work, "site", &["test", "--silent"])
        },
    },
    Check {
        name: "mutants",
        about: "a case of its rule notices every mutant (cargo assure mutants --quick; nightly: all cases)",
        lane: Lane::Peers,
        runs: always,
        run: mutants,
    },
    Check {
        name: "cpp",
        about: "C and C++: installed, compiled, under valgrind; a broken build is named",
        lane: Lane::Peers,
        runs: always,
        run: |work| {
            work.set_up(setup::cpp)?;
            rust_tests(work, &["--run-ignored", "all"])
        },
    },
    Check {
        name: "buf-evidence",
        about: "buf sees of each planted change what proto/README.md says that it sees",
        lane: Lane::Peers,
        runs: always,
        run: |work| {
            work.set_up(setup::buf)?;
            rust_tests(work, &["--run-ignored", "only"])
        },
    },
    Check {
        name: "gate",
        about: "the gate of a release fails by the right row for each prepared breakage (only when asked for; nightly)",
        lane: Lane::Peers,
        runs: |_| false,
        run: |work| {
            work.set_up(setup::buf)?;
            rust_tests(work, &["--run-ignored", "only"])
        },
    },
    Check {
        name: "packages",
        about: "wheel, npm and archive work where there is no project and no Rust (only when asked for; nightly)",
        lane: Lane::Peers,
        runs: |_| false,
        run: |work| {
            work.set_up(setup::pytest)?;
            package::make(work.project, &[], work.say).map_err(|error| Failure::of_one(error.to_string()))?;
            // A machine that makes packages need not build the other crates.
            rust_tests_of(work, &["-p", "xtask"], &["--run-ignored", "only"])
        },
    },
];

/// The names of all checks.
pub(crate) fn names() -> Vec<&'static str> {
    CHECKS.iter().map(|check| check.name).collect()
}

fn always(_: &Project) -> bool {
    true
}

/// How cargo runs the maintainers' command, built as `cargo verify` is.
const ASSURE: &[&str] = &["run", "--quiet", "--profile", "verify", "-p", "ncp-assurance", "--"];

/// How cargo runs the verifier.
const VERIFY: &[&str] = &["run", "--quiet", "--profile", "verify", "-p", "ncp-verifier", "--"];

/// Rust code is as rustfmt would have it; it leaves alone a statement with a literal that does not fit.
fn format(work: &mut Work<'_>) -> Result<Tally, Failure> {
    let formatted = work.program(work.project.cargo(&["fmt", "--all", "--check", "--", "--color", "never"]));
    let listed = work.project.program("git", &["ls-files", "*.rs"], "").output();
    let listed = listed.map_err(|error| Failure::of_one(format!("git ls-files: {error}")))?;
    if !listed.status.success() {
        return Err(Failure::of_one("git ls-files: this is no repository of git".to_owned()));
    }
    let mut overlong = Vec::new();
    for file in String::from_utf8_lossy(&listed.stdout).lines() {
        // A file that is deleted and not yet committed is listed, too.
        let Ok(text) = fs::read_to_string(work.project.path(file)) else { continue };
        overlong.extend(lines_over(COLUMNS, &text).map(|(line, columns)| format!("{file}:{line}: {columns} columns")));
    }
    let remedy = format!("\nrustfmt gives up on a line of more than {COLUMNS} columns: wrap it by hand");
    match (formatted, nothing_wrong(&overlong, &remedy)) {
        (Ok(_), wrapped) => wrapped,
        (formatted, Ok(_)) => formatted,
        (Err(Failure { tally, text }), Err(wrapped)) => {
            Err(Failure { tally, text: format!("{text}\n{}", wrapped.text) })
        }
    }
}

/// What `rustfmt.toml` says.
const COLUMNS: usize = 120;

/// The lines that are longer, by their number, with their length.
fn lines_over(columns: usize, text: &str) -> impl Iterator<Item = (usize, usize)> {
    let numbered = text.lines().enumerate().map(|(index, line)| (index + 1, line.chars().count()));
    numbered.filter(move |(_, length)| *length > columns)
}

/// Runs the tests that `.config/nextest.toml` names by the profile of the check's name. All profiles share one build.
fn rust_tests(work: &mut Work<'_>, options: &[&str]) -> Result<Tally, Failure> {
    rust_tests_of(work, &["--workspace"], options)
}

fn rust_tests_of(work: &mut Work<'_>, crates: &[&str], options: &[&str]) -> Result<Tally, Failure> {
    let nextest = work.set_up(setup::nextest)?;
    let profile = work.name;
    let args = ["nextest", "run", "--cargo-quiet", "--profile", profile];
    let mut program = work.project.program(nextest, &[&args[..], crates, options].concat(), "");
    program.env("NCP_BUF", setup::buf_path(work.project));
    let report = work.project.path(&format!(".tools/nextest/{profile}/junit.xml"));
    work.tests(program, &report)
}

/// Runs the unittests of a folder.
fn python_tests(work: &mut Work<'_>, python: &Path, folder: &str, discover: &[&str]) -> Result<Tally, Failure> {
    let program = unittests(work, python, folder, discover);
    work.tests(program, &work.report())
}

/// The program that runs the unittests of a folder, and leaves the report.
fn unittests(work: &Work<'_>, python: &Path, folder: &str, discover: &[&str]) -> Command {
    let mut program = work.project.program(python, &[], folder);
    program.arg(work.project.path("xtask/unittest_junit.py")).arg(work.report()).args(discover);
    program
}

/// Has npm run the tests of a folder.
fn node_tests(work: &mut Work<'_>, folder: &str, npm: &[&str]) -> Result<Tally, Failure> {
    let program = npm_tests(work, folder, npm);
    work.tests(program, &work.report())
}

/// The program that has npm run the tests of a folder, and leaves the report.
fn npm_tests(work: &Work<'_>, folder: &str, npm: &[&str]) -> Command {
    let report = work.report();
    let mut npm = work.project.program(setup::NPM, npm, folder);
    // The reporter `spec` repeats at the end what failed.
    let reporters = format!(
        "--test-reporter=spec --test-reporter-destination=stdout \
         --test-reporter=junit --test-reporter-destination={}",
        report.display()
    );
    npm.env("NODE_OPTIONS", reporters);
    npm
}

/// The tests of both plugins, with the verifier of these sources.
fn plugins(work: &mut Work<'_>) -> Result<Tally, Failure> {
    let python = work.set_up(setup::pytest)?;
    work.program(work.project.cargo(&["build", "--quiet", "--profile", "verify", "-p", "ncp-verifier"]))?;
    let program = work.project.path("target/verify/ncp-verify").with_extension(env::consts::EXE_EXTENSION);
    let mut unittests = unittests(work, &python, "packages/pypi", &["-s", "tests"]);
    unittests.env("NCP_VERIFY", &program);
    let mut tally = work.tests(unittests, &work.report())?;
    let mut npm = npm_tests(work, "packages/npm", &["test", "--silent"]);
    npm.env("NCP_VERIFY", &program);
    let node = work.tests(npm, &work.report())?;
    tally.passed += node.passed;
    tally.failed += node.failed;
    tally.times.extend(node.times);
    Ok(tally)
}

fn conformance(work: &mut Work<'_>) -> Result<Tally, Failure> {
    judged(work, &[], ".tools/logs/conformance.json")
}

/// The sources of the deep set's expectations, and those that had to agree with them.
fn deep(work: &mut Work<'_>) -> Result<Tally, Failure> {
    let peers = ["--peer", "peers/rust", "--peer", "peers/typescript", "--peer", "peers/python-pure"];
    let run = [&["run", "--deep", "--filter", "deep/*"][..], &peers].concat();
    judged(work, &run, ".tools/logs/deep.json")
}

/// Has the verifier check peers, and leave its result in this file.
fn judged(work: &mut Work<'_>, args: &[&str], result_file: &str) -> Result<Tally, Failure> {
    let cargo = work.project.cargo(&[VERIFY, args, &["--json", result_file]].concat());
    let tally = work.program(cargo)?;

    // For the verifier a peer without its toolchain is skipped, which is no failure. Here it
    // is one: every bundled peer has to be shown to conform.
    let unreadable = |error: &dyn Display| Failure::of_one(format!("{result_file}: {error}"));
    let text = fs::read(work.project.path(result_file)).map_err(|error| unreadable(&error))?;
    let result: Value = serde_json::from_slice(&text).map_err(|error| unreadable(&error))?;
    let unchecked = unchecked_peers(&result).ok_or_else(|| unreadable(&"no list of peers"))?;
    nothing_wrong(&unchecked, "").map(|_| tally)
}

fn mutants(work: &mut Work<'_>) -> Result<Tally, Failure> {
    const TRIALS: &str = ".tools/logs/mutants.json";
    // What an earlier run left counts for nothing.
    fs::remove_file(work.project.path(TRIALS)).ok();
    let hunted = work.program(work.project.cargo(&[ASSURE, &["mutants", "--quick", "--json", TRIALS]].concat()));
    let text = fs::read_to_string(work.project.path(TRIALS));
    let totals = text.ok().and_then(|text| Some(serde_json::from_str::<Value>(&text).ok()?.get("totals")?.clone()));
    let Some(totals) = totals else { return hunted };
    let number = |fate: &str| totals[fate].as_u64().unwrap_or(0);
    let (passed, failed) = (number("killed"), number("misnamed") + number("survived") + number("unfinished"));
    let tally = Tally { passed, failed, times: Vec::new() };
    match hunted {
        Ok(_) => Ok(tally),
        Err(failure) if failed == 0 => Err(failure),
        Err(Failure { text, .. }) => Err(Failure { tally, text }),
    }
}

/// The peers that a result of `ncp-verify` does not judge, with the reason.
fn unchecked_peers(result: &Value) -> Option<Vec<String>> {
    let peers = result["peers"].as_array()?.iter();
    let unchecked = peers.filter(|peer| peer["state"] != "checked").map(|peer| {
        let text = |member: &str| peer[member].as_str().unwrap_or("unknown");
        format!("{} was not checked: {}", text("name"), text("reason"))
    });
    Some(unchecked.collect())
}

/// One passed test if there is nothing wrong; else one failed test that shows it.
fn nothing_wrong<T: Display>(wrong: &[T], remedy: &str) -> Result<Tally, Failure> {
    if wrong.is_empty() {
        return Ok(Tally::one(true));
    }
    let lines: Vec<String> = wrong.iter().map(T::to_string).collect();
    Err(Failure::of_one(lines.join("\n") + remedy))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_peer_that_was_not_checked_is_named_with_its_reason() {
        let result = json!({"peers": [
            {"name": "rust", "state": "checked", "reason": null},
            {"name": "typescript", "state": "skipped", "reason": "node is not on PATH"},
        ]});
        let unchecked = unchecked_peers(&result).unwrap();
        assert_eq!(unchecked, ["typescript was not checked: node is not on PATH"]);
        assert_eq!(unchecked_peers(&json!({})), None);
    }

    #[test]
    fn a_line_is_measured_in_columns_rather_than_bytes() {
        let text = format!("{}\n{}\n{}\n", "é".repeat(120), "x".repeat(121), "x".repeat(120));
        assert_eq!(lines_over(120, &text).collect::<Vec<_>>(), [(2, 121)]);
    }
}
