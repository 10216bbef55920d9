//! What `cargo xtask test` checks, what fails fastest first.

use std::fmt::Display;
use std::fs;

use serde_json::Value;

use crate::count::{self, Count};
use crate::generate;
use xtask::setup;
use crate::test::{Failure, Work};

/// One named check.
pub(crate) struct Check {
    pub(crate) name: &'static str,
    /// What it checks, for `--list`.
    pub(crate) about: &'static str,
    /// Checks it, and gives the number of tests that passed.
    pub(crate) run: fn(&mut Work<'_>) -> Result<Count, Failure>,
}

/// All checks, in order.
pub(crate) const CHECKS: &[Check] = &[
    Check {
        name: "format",
        about: "the Rust code is formatted (rustfmt)",
        run: |work| {
            let cargo = work.project.cargo(&["fmt", "--all", "--check", "--", "--color", "never"]);
            work.program(cargo)
        },
    },
    Check {
        name: "contract",
        about: "proto and projection break nothing of the frozen 0.5 (our own check)",
        run: |_| nothing_wrong(&ncp_proto::compat::check_current(), ""),
    },
    Check { name: "schemas", about: "schemas/ holds what the contract generates", run: |work| fresh(work, "schemas/") },
    Check {
        name: "vectors",
        about: "vectors/ and its manifest hold what the generator generates",
        run: |work| fresh(work, "vectors/"),
    },
    Check {
        name: "buf-lint",
        about: "the proto follows buf's rules",
        run: |work| {
            let buf = work.set_up(setup::buf)?;
            work.program(work.project.program(buf, &["lint"], "proto"))
        },
    },
    Check {
        name: "buf-breaking",
        about: "the proto breaks nothing of the frozen 0.5 image (buf: FILE and WIRE_JSON)",
        run: |work| {
            let buf = work.set_up(setup::buf)?;
            let against = ["breaking", "--against", "baseline/ncp-0.5.binpb"];
            work.program(work.project.program(buf, &against, "proto"))
        },
    },
    Check {
        name: "clippy",
        about: "the Rust code is free of warnings (clippy, all targets)",
        run: |work| {
            let targets = ["clippy", "--workspace", "--all-targets", "--quiet", "--keep-going"];
            work.program(work.project.cargo(&[&targets[..], &["--", "-D", "warnings"]].concat()))
        },
    },
    Check {
        name: "typescript",
        about: "the TypeScript peer's own tests: library, client, generated types, packed package",
        run: |work| {
            work.set_up(setup::typescript)?;
            node_tests(work, &["test", "--silent"])
        },
    },
    Check {
        name: "browser",
        about: "the TypeScript package, imported by a page in a headless Chromium, runs a session",
        run: |work| {
            work.set_up(setup::browser)?;
            node_tests(work, &["run", "test:browser", "--silent"])
        },
    },
    Check {
        name: "python-pure",
        about: "the own tests of the peer in pure Python (unittest)",
        run: |work| {
            let discover = ["-m", "unittest", "discover"];
            let python = work.project.program("python3", &discover, "peers/python-pure");
            work.tests(python, count::unittest)
        },
    },
    Check {
        name: "cpp",
        about: "C and C++: the header is fresh; installed, compiled, under valgrind; a broken build is named",
        run: cpp,
    },
    Check {
        name: "python",
        about: "the Python peer's own tests: API, numpy, hostile input, stubs, wheel, adapter",
        run: |work| {
            let python = work.set_up(setup::python)?;
            let tests = ["-m", "unittest", "discover", "-s", "tests"];
            work.tests(work.project.program(python, &tests, "peers/python"), count::unittest)
        },
    },
    Check {
        name: "rust",
        about: "all tests of all crates but fuzz, and those in their documentation",
        run: |work| {
            let all = ["test", "--workspace", "--exclude", FUZZ, "--no-fail-fast", "--quiet"];
            work.tests(work.project.cargo(&all), count::cargo)
        },
    },
    Check {
        name: "fuzz-corpus",
        about: "every committed input of every fuzz target passes, and so does every seed",
        run: |work| {
            let replay = ["test", "--no-fail-fast", "--quiet", "-p", FUZZ];
            work.tests(work.project.cargo(&replay), count::cargo)
        },
    },
    Check {
        name: "buf-evidence",
        about: "buf sees of each planted change what proto/README.md says that it sees",
        run: |work| {
            let buf = work.set_up(setup::buf)?;
            let only = ["test", "--quiet", "-p", "ncp-proto", "--test", "buf", "--", "--ignored"];
            let mut cargo = work.project.cargo(&only);
            cargo.env("NCP_BUF", buf);
            work.tests(cargo, count::cargo)
        },
    },
    Check {
        name: "trace",
        about: "every binding rule is shown, and all evidence cites rules (cargo assure trace)",
        run: |work| {
            let trace = [ASSURE, &["trace", "--check"]].concat();
            work.program(work.project.cargo(&trace))
        },
    },
    Check {
        name: "conformance",
        about: "every bundled peer conforms at the level that it claims (ncp-verify, release)",
        run: conformance,
    },
    Check {
        name: "mutants",
        about: "the suite notices every mutant, and names the rule that it breaks (cargo assure mutants)",
        run: |work| {
            let hunt = [ASSURE, &["mutants"]].concat();
            work.tests(work.project.cargo(&hunt), count::mutants)
        },
    },
];

/// The crate with what the fuzz targets check.
const FUZZ: &str = "ncp-fuzz-bodies";

/// How cargo runs the maintainers' command.
const ASSURE: &[&str] = &["run", "--quiet", "--release", "-p", "ncp-assurance", "--"];

/// How cargo runs the verifier.
const VERIFY: &[&str] = &["run", "--quiet", "--release", "-p", "ncp-verifier", "--"];

/// The generated files of a folder are what would be generated.
fn fresh(work: &Work<'_>, folder: &str) -> Result<Count, Failure> {
    let stale = generate::check(work.project, folder).map_err(|error| Failure::of_one(error.to_string()))?;
    nothing_wrong(&stale, "\nif this is meant: cargo xtask generate")
}

/// Has npm run tests of the TypeScript peer.
fn node_tests(work: &mut Work<'_>, npm: &[&str]) -> Result<Count, Failure> {
    let mut npm = work.project.program(setup::NPM, npm, "peers/typescript");
    // This reporter repeats at the end what failed.
    npm.env("NODE_OPTIONS", "--test-reporter=spec");
    work.tests(npm, count::node)
}

fn cpp(work: &mut Work<'_>) -> Result<Count, Failure> {
    work.set_up(setup::cpp)?;
    let mut count = fresh(work, "peers/cpp/include/ncp.h")?;
    let test = ["test", "--quiet", "-p", "ncp-peer-cpp", "--no-fail-fast"];
    let all = [&test[..], &["--", "--include-ignored"]].concat();
    count += work.tests(work.project.cargo(&all), count::cargo)?;
    Ok(count)
}

fn conformance(work: &mut Work<'_>) -> Result<Count, Failure> {
    const RESULT: &str = ".tools/logs/conformance.json";
    let cargo = work.project.cargo(&[VERIFY, &["--json", RESULT]].concat());
    let count = work.program(cargo)?;

    // For the verifier a peer without its toolchain is skipped, which is no failure. Here it
    // is one: every bundled peer has to be shown to conform.
    let unreadable = |error: &dyn Display| Failure::of_one(format!("{RESULT}: {error}"));
    let text = fs::read(work.project.path(RESULT)).map_err(|error| unreadable(&error))?;
    let result: Value = serde_json::from_slice(&text).map_err(|error| unreadable(&error))?;
    let unchecked = unchecked_peers(&result).ok_or_else(|| unreadable(&"no list of peers"))?;
    nothing_wrong(&unchecked, "").map(|_| count)
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
fn nothing_wrong<T: Display>(wrong: &[T], remedy: &str) -> Result<Count, Failure> {
    if wrong.is_empty() {
        return Ok(Count::one(true));
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
}
