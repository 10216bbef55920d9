//! What `cargo xtask test` checks, what fails fastest first.

use std::process::Command;

use crate::count::{self, Count};
use crate::generate;
use crate::project::Project;
use crate::setup::{self, SetupError};

/// One named check.
pub(crate) struct Check {
    pub(crate) name: &'static str,
    /// What it checks, for `--list`.
    pub(crate) about: &'static str,
    pub(crate) work: Work,
}

/// How a check is carried out.
pub(crate) enum Work {
    /// Within this program; an error says what is wrong.
    Library(fn(&Project) -> Result<(), String>),
    /// By a program, which has to succeed.
    Program {
        /// Sets up what the program needs, saying what it installs, and gives the program.
        program: fn(&Project, &mut dyn FnMut(&str)) -> Result<Command, SetupError>,
        /// Counts the tests in what it prints; without it, it is one test.
        count: Option<fn(&str) -> Count>,
    },
}

/// All checks, in order.
pub(crate) const CHECKS: &[Check] = &[
    Check {
        name: "format",
        about: "the Rust code is formatted (rustfmt)",
        work: Work::Program {
            program: |project, _| {
                Ok(project.cargo(&["fmt", "--all", "--check", "--", "--color", "never"]))
            },
            count: None,
        },
    },
    Check {
        name: "contract",
        about: "proto and projection break nothing of the frozen 0.5 (our check)",
        work: Work::Library(contract),
    },
    Check {
        name: "schemas",
        about: "schemas/ is what the contract generates",
        work: Work::Library(|project| fresh(project, "schemas/")),
    },
    Check {
        name: "vectors",
        about: "vectors/ and its manifest are what the specification generates",
        work: Work::Library(|project| fresh(project, "vectors/")),
    },
    Check {
        name: "buf-lint",
        about: "the proto follows buf's rules",
        work: Work::Program {
            program: buf_lint,
            count: None,
        },
    },
    Check {
        name: "buf-breaking",
        about: "the proto breaks nothing of the frozen 0.5 image (buf: FILE, WIRE_JSON)",
        work: Work::Program {
            program: buf_breaking,
            count: None,
        },
    },
    Check {
        name: "clippy",
        about: "the Rust code is free of warnings (clippy, all targets)",
        work: Work::Program {
            program: |project, _| Ok(project.cargo(CLIPPY)),
            count: None,
        },
    },
    Check {
        name: "typescript",
        about: "the TypeScript peer's own tests",
        work: Work::Program {
            program: typescript,
            count: Some(count::node),
        },
    },
    Check {
        name: "rust",
        about: "all tests of all crates, and those in their documentation",
        work: Work::Program {
            program: |project, _| {
                Ok(project.cargo(&["test", "--workspace", "--no-fail-fast", "--quiet"]))
            },
            count: Some(count::cargo),
        },
    },
    Check {
        name: "buf-evidence",
        about: "buf sees of each planted change what proto/README.md says that it sees",
        work: Work::Program {
            program: buf_evidence,
            count: Some(count::cargo),
        },
    },
    Check {
        name: "conformance",
        about: "every bundled peer conforms at level wire (ncp-verify, release)",
        work: Work::Program {
            program: conformance,
            count: None,
        },
    },
];

const CLIPPY: &[&str] = &[
    "clippy",
    "--workspace",
    "--all-targets",
    "--quiet",
    "--",
    "-D",
    "warnings",
];

const BUF_EVIDENCE: &[&str] = &[
    "test",
    "--quiet",
    "-p",
    "ncp-proto",
    "--test",
    "buf",
    "--",
    "--ignored",
];

fn contract(_: &Project) -> Result<(), String> {
    let violations = ncp_proto::compat::check_current();
    if violations.is_empty() {
        Ok(())
    } else {
        Err(lines(&violations))
    }
}

fn fresh(project: &Project, folder: &str) -> Result<(), String> {
    let stale = generate::check(project, folder).map_err(|error| error.to_string())?;
    if stale.is_empty() {
        return Ok(());
    }
    Err(format!(
        "{}\nif this is meant: cargo xtask generate",
        lines(&stale)
    ))
}

fn buf_lint(project: &Project, say: &mut dyn FnMut(&str)) -> Result<Command, SetupError> {
    let buf = setup::buf(project, say)?;
    Ok(project.program(buf, &["lint"], "proto"))
}

fn buf_breaking(project: &Project, say: &mut dyn FnMut(&str)) -> Result<Command, SetupError> {
    let buf = setup::buf(project, say)?;
    let against = ["breaking", "--against", "baseline/ncp-0.5.binpb"];
    Ok(project.program(buf, &against, "proto"))
}

fn typescript(project: &Project, say: &mut dyn FnMut(&str)) -> Result<Command, SetupError> {
    setup::typescript(project, say)?;
    let mut npm = project.program(setup::NPM, &["test", "--silent"], "peers/typescript");
    // This reporter repeats at the end what failed.
    npm.env("NODE_OPTIONS", "--test-reporter=spec");
    Ok(npm)
}

fn buf_evidence(project: &Project, say: &mut dyn FnMut(&str)) -> Result<Command, SetupError> {
    let mut tests = project.cargo(BUF_EVIDENCE);
    tests.env("NCP_BUF", setup::buf(project, say)?);
    Ok(tests)
}

fn conformance(project: &Project, say: &mut dyn FnMut(&str)) -> Result<Command, SetupError> {
    setup::typescript(project, say)?;
    Ok(project.cargo(&[
        "run",
        "--quiet",
        "--release",
        "-p",
        "ncp-verifier",
        "--",
        "run",
    ]))
}

fn lines<T: std::fmt::Display>(items: &[T]) -> String {
    items
        .iter()
        .map(T::to_string)
        .collect::<Vec<_>>()
        .join("\n")
}
