//! The library as C and C++ programs meet it: installed and compiled as the README says, under valgrind, and
//! behind the adapter, whole and broken.
//!
//! They need cc, c++ and valgrind, and build in release: `cargo xtask test --only cpp`.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use ncp_spec::{CONTRACT_HASH, WIRE_VERSION};
use serde_json::Value;

const CRATE: &str = env!("CARGO_MANIFEST_DIR");
const NATIVE: [&str; 3] = ["-lpthread", "-ldl", "-lm"];

/// The folder of the checkout.
fn root() -> &'static Path {
    Path::new(CRATE).ancestors().nth(2).unwrap()
}

/// Cargo's target folder.
fn target() -> &'static Path {
    Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap()
}

/// What a command prints; it has to succeed.
fn run(command: &mut Command) -> String {
    let output = command.output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (said, cried) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{command:?}\n{said}{cried}");
    said
}

fn cargo(args: &[&str]) -> Command {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(args).current_dir(root()).env("CARGO_TARGET_DIR", target());
    cargo
}

/// The commands of the README under a heading.
fn commands(heading: &str) -> String {
    let readme = fs::read_to_string(Path::new(CRATE).join("README.md")).unwrap();
    let section = readme.split(&format!("## {heading}\n")).nth(1).unwrap();
    let section = section.split("\n## ").next().unwrap();
    let mut fenced = section.split("```sh\n").skip(1);
    let commands = fenced.next().unwrap().split("```").next().unwrap();
    assert!(fenced.next().is_none());
    commands.to_owned()
}

/// Runs the README's commands under a heading, in a folder.
fn as_the_readme_says(heading: &str, folder: &Path) -> String {
    let mut shell = Command::new("sh");
    shell
        .args(["-eu", "-c", &commands(heading)])
        .current_dir(folder)
        .env("NCP", root())
        .env("PREFIX", prefix())
        .env("CARGO_TARGET_DIR", target());
    run(&mut shell)
}

/// Where the library is installed, once for all tests, as the README says.
fn prefix() -> &'static Path {
    static PREFIX: OnceLock<PathBuf> = OnceLock::new();
    PREFIX.get_or_init(|| Path::new(env!("CARGO_TARGET_TMPDIR")).join("installed"))
}

fn install() {
    static ONCE: OnceLock<()> = OnceLock::new();
    ONCE.get_or_init(|| {
        let _ = fs::remove_dir_all(prefix());
        fs::create_dir_all(prefix()).unwrap();
        as_the_readme_says("Install", prefix());
        run(&mut cargo(&["build", "--release", "--quiet", "-p", "ncp-peer-cpp-adapter"]));
        // By the profile of the other checks, which have built it by then.
        run(&mut cargo(&["build", "--profile", "verify", "--quiet", "-p", "ncp-verifier"]));
    });
}

/// A compiler that takes every warning for an error, with the installed headers.
fn compiler(program: &str, standard: &str) -> Command {
    install();
    let mut compiler = Command::new(program);
    compiler
        .args([standard, "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-g"])
        .arg(format!("-DOWN_VERSION=\"{WIRE_VERSION}\""))
        .arg(format!("-DOWN_HASH=\"{CONTRACT_HASH}\""))
        .arg("-I")
        .arg(prefix().join("include"))
        .current_dir(CRATE);
    compiler
}

fn cc() -> Command {
    compiler("cc", "-std=c11")
}

fn cxx() -> Command {
    compiler("c++", "-std=c++17")
}

/// The program of a source file, with the static or the shared library.
fn compiled(mut compiler: Command, source: &str, shared: bool, folder: &Path) -> PathBuf {
    let program = folder.join(if shared { "shared" } else { "static" });
    let lib = prefix().join("lib");
    compiler.arg(source).arg("-o").arg(&program);
    if shared {
        let rpath = format!("-Wl,-rpath,{}", lib.display());
        compiler.arg("-L").arg(&lib).args(["-lncp", &rpath]);
    } else {
        compiler.arg(lib.join("libncp.a")).args(NATIVE);
    }
    run(&mut compiler);
    program
}

fn under_valgrind(program: &Path) -> String {
    let mut valgrind = Command::new("valgrind");
    valgrind
        .args(["--quiet", "--leak-check=full", "--error-exitcode=9"])
        .args(["--errors-for-leak-kinds=definite,indirect,possible"])
        .arg(program);
    run(&mut valgrind)
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn the_commands_of_the_readme_install_compile_and_run_the_examples() {
    install();
    let folder = tempfile::tempdir().unwrap();
    let said = as_the_readme_says("Compile and run", folder.path());
    for part in [
        "x=1    asked 9 m/s: {\"velocity_setpoint\":{\"data\":[1.4",
        "x=4.9  asked 1 m/s: holds",
        "x=0    asked 1 m/s: stopped",
        "a second later: holds",
        "a torn ESTOP stops all the same",
        "104 bytes, 2 columns, the last spike at 9 ms",
    ] {
        assert!(said.contains(part), "{part}\n{said}");
    }
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn the_examples_say_the_same_with_either_library_and_leak_nothing() {
    for (source, compiler) in [("examples/flight.c", cc as fn() -> Command), ("examples/flight.cpp", cxx)] {
        let folder = tempfile::tempdir().unwrap();
        let [shared, fixed] =
            [true, false].map(|shared| under_valgrind(&compiled(compiler(), source, shared, folder.path())));
        assert_eq!(shared, fixed, "{source}");
    }
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn every_function_of_the_header_does_what_it_says_without_a_leak_or_an_invalid_read() {
    for shared in [true, false] {
        let folder = tempfile::tempdir().unwrap();
        let program = compiled(cc(), "tests/abi.c", shared, folder.path());
        assert_eq!(under_valgrind(&program), "0 failures\n");
    }
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn the_cpp_objects_have_one_owner_and_throw_without_a_leak_or_an_invalid_read() {
    let folder = tempfile::tempdir().unwrap();
    let program = compiled(cxx(), "tests/raii.cpp", true, folder.path());
    assert_eq!(under_valgrind(&program), "0 failures\n");
}

/// The names of the header's functions.
fn declared() -> BTreeSet<String> {
    let header = fs::read_to_string(Path::new(CRATE).join("include/ncp.h")).unwrap();
    let code = header.lines().filter(|line| !line.trim_start().starts_with("//"));
    let calls = code.filter_map(|line| line.split_once('('));
    let names = calls.map(|(before, _)| before.rsplit([' ', '*']).next().unwrap_or_default());
    names.filter(|name| name.starts_with("ncp_")).map(str::to_owned).collect()
}

#[test]
fn the_test_in_c_calls_every_function_of_the_header() {
    let test = fs::read_to_string(Path::new(CRATE).join("tests/abi.c")).unwrap();
    let declared = declared();
    assert!(declared.len() > 60, "{declared:?}");
    let uncalled: Vec<_> = declared.iter().filter(|name| !test.contains(&format!("{name}("))).collect();
    assert_eq!(uncalled, [""; 0]);
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn both_libraries_export_every_function_of_the_header() {
    install();
    for (file, only) in [("libncp.so", "-D"), ("libncp.a", "-g")] {
        let mut nm = Command::new("nm");
        nm.args([only, "--defined-only"]).arg(prefix().join("lib").join(file));
        let listed = run(&mut nm);
        let exported: BTreeSet<String> = listed
            .lines()
            .filter_map(|line| line.rsplit(' ').next())
            .filter(|name| name.starts_with("ncp_"))
            .map(str::to_owned)
            .collect();
        assert_eq!(exported, declared(), "{file}");
    }
}

/// The cases of chapter 7.
const SAFETY: &[&str] = &["--filter", "safety/"];

/// What the suite says of a library behind the adapter.
fn verified(library: &Path, filter: &[&str]) -> Value {
    let release = target().join("release");
    let result = library.with_extension("json");
    let adapter = release.join("ncp-peer-cpp-adapter");
    let peer = format!("'{}' --library '{}'", adapter.display(), library.display());
    let mut verify = Command::new(target().join("verify/ncp-verify"));
    verify
        .args(["run", "--level", "safety"])
        .args(filter)
        .args(["--peer-cmd", &peer, "--json"])
        .arg(&result)
        .current_dir(root());
    let output = verify.output().unwrap();
    let text = fs::read(&result);
    let text = text.unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)));
    serde_json::from_slice(&text).unwrap()
}

/// The cases of a result with this outcome.
fn cases<'a>(result: &'a Value, outcome: &str) -> Vec<&'a Value> {
    let cases = result["peers"][0]["cases"].as_array().unwrap();
    cases.iter().filter(|case| case["outcome"] == outcome).collect()
}

/// The rules that those cases cite.
fn rules(cases: &[&Value]) -> BTreeSet<String> {
    let cited = cases.iter().flat_map(|case| case["rules"].as_array().unwrap());
    cited.map(|rule| rule.as_str().unwrap().to_owned()).collect()
}

/// A shared library of these sources and arguments.
fn library(folder: &Path, name: &str, args: &[&str], archive: bool) -> PathBuf {
    let library = folder.join(name);
    let lib = prefix().join("lib");
    let mut compiler = cc();
    compiler.args(["-shared", "-fPIC"]).args(args);
    if archive {
        compiler
            .arg("-Wl,--whole-archive")
            .arg(lib.join("libncp.a"))
            .args(["-Wl,--no-whole-archive", "-Wl,--version-script=tests/seed.map"]);
    } else {
        let rpath = format!("-Wl,-rpath,{}", lib.display());
        compiler.arg("-L").arg(&lib).args(["-Wl,--no-as-needed", "-lncp", &rpath]);
    }
    run(compiler.args(NATIVE).arg("-o").arg(&library));
    library
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn a_library_whose_governor_never_latches_is_told_the_rule_that_it_breaks() {
    let folder = tempfile::tempdir().unwrap();
    let broken = library(folder.path(), "libbroken.so", &["tests/broken_govern.c"], false);
    let result = verified(&broken, SAFETY);
    let failed = cases(&result, "fail");
    assert!(rules(&failed).contains("NCP-SAFE-005"), "{:?}", rules(&failed));
    assert!(cases(&result, "pass").len() > failed.len());

    let whole = library(folder.path(), "libwhole.so", &[], false);
    let result = verified(&whole, SAFETY);
    assert_eq!(cases(&result, "fail"), [&Value::Null; 0]);
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn a_library_with_the_seeds_functions_alone_fails_no_case() {
    let folder = tempfile::tempdir().unwrap();
    let seed = library(folder.path(), "libseed.so", &[], true);
    let result = verified(&seed, &[]);
    assert!(cases(&result, "pass").len() > 2_000);
    let others: BTreeSet<&str> =
        result["peers"][0]["cases"].as_array().unwrap().iter().map(|case| case["outcome"].as_str().unwrap()).collect();
    assert_eq!(others, BTreeSet::from(["pass", "unsupported"]));
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn a_seed_library_that_reads_a_codec_in_the_published_form_alone_fails_no_case() {
    let folder = tempfile::tempdir().unwrap();
    let args = ["tests/seed_published_codec.c", "-Wl,--allow-multiple-definition"];
    let published = library(folder.path(), "libseed_published.so", &args, true);
    let result = verified(&published, &["--filter", "codec/"]);
    let passed = cases(&result, "pass").len();
    let lacking = cases(&result, "unsupported").len();
    let all = result["peers"][0]["cases"].as_array().unwrap().len();
    assert_eq!((passed + lacking, passed > 200), (all, true), "{passed} passing and {lacking} lacking of {all}");
}

#[test]
#[ignore = "needs cc, c++ and valgrind: cargo xtask test --only cpp"]
fn a_seed_library_whose_govern_knows_no_limit_is_told_the_rule_that_it_breaks() {
    let folder = tempfile::tempdir().unwrap();
    let args = ["tests/seed_broken_govern.c", "-Wl,--allow-multiple-definition"];
    let broken = library(folder.path(), "libseed_broken.so", &args, true);
    let failed = rules(&cases(&verified(&broken, SAFETY), "fail"));
    assert!(failed.iter().any(|rule| rule.starts_with("NCP-SAFE-06")), "{failed:?}");
}
