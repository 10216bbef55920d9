//! The Rust peer with one defect, chosen by name.
//!
//! `ncp-peer-mutants --mutant NAME` is the peer of `peers/rust`, but for the defect of that name; without `--mutant`
//! it is that peer. `ncp-peer-mutants --list` prints the table as JSON.
//!
//! The build script copies the sources of `ncp-spec` and `ncp-peer-rust` and puts a switch at every place that a
//! mutant changes, so that one build holds all of them.

#![forbid(unsafe_code)]

use std::env;
use std::io::{self, BufReader, BufWriter};
use std::process::ExitCode;

use serde::Serialize;

#[macro_use]
mod selection;

include!(concat!(env!("OUT_DIR"), "/table.rs"));
include!(concat!(env!("OUT_DIR"), "/modules.rs"));

/// As much as a pipe holds.
const BUFFER: usize = 64 << 10;

/// A defect.
#[derive(Debug, Serialize)]
struct Mutant {
    name: &'static str,
    about: &'static str,
    finding: &'static str,
    rules: &'static [&'static str],
}

fn main() -> ExitCode {
    let args: Vec<String> = env::args().skip(1).collect();
    let done = match args.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => converse(),
        ["--list"] => list(),
        ["--mutant", name] => match MUTANTS.iter().position(|mutant| mutant.name == name) {
            Some(number) => {
                selection::select(number);
                converse()
            }
            None => return usage(&format!("there is no mutant {name}; --list shows all")),
        },
        _ => return usage("usage: ncp-peer-mutants [--list | --mutant NAME]"),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("ncp-peer-mutants: the conversation broke off: {error}");
            ExitCode::FAILURE
        }
    }
}

fn converse() -> io::Result<()> {
    let input = BufReader::with_capacity(BUFFER, io::stdin().lock());
    let output = BufWriter::with_capacity(BUFFER, io::stdout().lock());
    ncp_peer_rust::hold(input, output)
}

fn list() -> io::Result<()> {
    serde_json::to_writer_pretty(io::stdout().lock(), MUTANTS)?;
    println!();
    Ok(())
}

fn usage(what: &str) -> ExitCode {
    eprintln!("ncp-peer-mutants: {what}");
    ExitCode::from(2)
}
