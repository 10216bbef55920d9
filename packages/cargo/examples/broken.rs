//! The executable specification with defects, for the tests of the harness. `NCP_DEFECT` says which, `NCP_EXPECTED`
//! names a list of expected failures, and `NCP_COMMAND` a program that is checked in its place, such as this one with
//! `speak`.

#![forbid(unsafe_code)]

use std::io::{self, BufRead as _, BufReader, Write as _};
use std::process::ExitCode;

use ncp_harness::{Conformance, Input, Output};

fn main() -> ExitCode {
    if std::env::args().nth(1).is_some_and(|arg| arg == "speak") {
        return if ncp_peer_rust::serve().is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE };
    }
    let told = |name: &str| std::env::var(name).ok();
    let defect = told("NCP_DEFECT").unwrap_or_default();
    let conformance = match told("NCP_COMMAND") {
        Some(command) => Conformance::command(command),
        None => Conformance::conversation(move |input, output| hold(&defect, input, output)),
    };
    let conformance = conformance.filter("version.check").filter("plane.qos");
    match told("NCP_EXPECTED") {
        Some(file) => conformance.expected(file).run(),
        None => conformance.run(),
    }
}

/// Answers each request as the specification does, but for the defect.
fn hold(defect: &str, input: Input, mut output: Output) -> io::Result<()> {
    for line in input.lines() {
        let line = line?;
        let of = |call: &str| line.contains(&format!("\"call\":\"{call}\""));
        let mut answer = Vec::new();
        ncp_peer_rust::hold(BufReader::new(format!("{line}\n").as_bytes()), &mut answer)?;
        match defect {
            "tells" => eprintln!("asked: {line}"),
            "says-yes" if of("version.check") => {
                let said = String::from_utf8_lossy(&answer).replace("\"compatible\":false", "\"compatible\":true");
                answer = said.into_bytes();
            }
            "breaks-off" if of("plane.qos") => return Err(io::ErrorKind::Other.into()),
            "lacks-planes" if of("plane.qos") => {
                let id: String =
                    line.chars().skip_while(|c| !c.is_ascii_digit()).take_while(char::is_ascii_digit).collect();
                answer = format!("{{\"id\":{id},\"unsupported\":true}}\n").into_bytes();
            }
            _ => {}
        }
        output.write_all(&answer)?;
        output.flush()?;
    }
    Ok(())
}
