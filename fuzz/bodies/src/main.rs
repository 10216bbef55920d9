//! `ncp-fuzz`: replays inputs without a fuzzer, shows them, and makes the seeds.

#![allow(clippy::print_stdout, reason = "a program prints")]

use std::fs;
use std::io;
use std::path::Path;
use std::process::ExitCode;

use serde_json::{Value, json};

use ncp_fuzz_bodies::{TARGETS, Target, seeds, target};

include!("../allocator.rs");

const USAGE: &str = "\
Usage: ncp-fuzz list [--json]           the targets, and what each would find
       ncp-fuzz replay <target> <file>… check inputs, such as a crash; panics when one is wrong
       ncp-fuzz show <target> <file>    an input as a person reads it
       ncp-fuzz seed <folder>           write the seeds that vectors/ gives, in all/<target>,
                                        and those that stay, in rules/<target>
";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    match run(&args) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => {
            eprint!("{USAGE}");
            ExitCode::from(2)
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Carries out a command line; `false` is one that means nothing.
fn run(args: &[&str]) -> io::Result<bool> {
    match args {
        ["list"] => {
            for Target { name, finds, .. } in TARGETS {
                println!("{name:20} {finds}");
            }
        }
        ["list", "--json"] => {
            let targets = TARGETS.iter().map(|target| json!({"name": target.name, "finds": target.finds}));
            println!("{}", Value::from_iter(targets));
        }
        ["replay", name, files @ ..] if let Some(target) = target(name) => {
            for file in files {
                (target.run)(&fs::read(file)?);
                println!("{file}: nothing is wrong");
            }
        }
        ["show", name, file] if let Some(target) = target(name) => {
            println!("{}", (target.show)(&fs::read(file)?));
        }
        ["seed", folder] => {
            let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
            for (which, seeds) in [("all", seeds::seeds(root)?), ("rules", seeds::essential(root)?)] {
                for (name, inputs) in seeds {
                    let folder = Path::new(folder).join(which).join(name);
                    fs::create_dir_all(&folder)?;
                    for (nth, input) in inputs.iter().enumerate() {
                        fs::write(folder.join(format!("{which}-{nth:04}")), input)?;
                    }
                    println!("{which:6} {name:20} {} seeds", inputs.len());
                }
            }
            fs::write(root.join("fuzz/dict/frame.dict"), seeds::dictionary())?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}
