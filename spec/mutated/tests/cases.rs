//! Started by cargo, this program has a verifier judge a peer; started by that verifier, it is the peer.

#![forbid(unsafe_code)]

use std::io::{self, BufReader, BufWriter};
use std::process::{Command, ExitCode};

use ncp_peer_rust::hold;

/// Holds the path of a verifier that was built without the mutation.
const VERIFIER: &str = "NCP_VERIFIER";
/// Holds the patterns of the cases, with a blank between two, that are judged before all others.
const FIRST: &str = "NCP_FIRST";
/// By this argument the program is the peer.
const PEER: &str = "peer";

fn main() -> ExitCode {
    let result = if std::env::args().nth(1).as_deref() == Some(PEER) {
        let output = BufWriter::new(io::stdout().lock());
        hold(BufReader::new(io::stdin().lock()), output).map(|()| true)
    } else {
        judge()
    };
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Whether this peer conforms: first by the cases that are likely to show the mutation, then by all.
fn judge() -> io::Result<bool> {
    let verifier = std::env::var_os(VERIFIER)
        .ok_or_else(|| io::Error::other(format!("{VERIFIER} names no verifier")))?;
    let program = std::env::current_exe()?;
    // One silent or broken answer decides, so that the peer need not be started again.
    let peer = format!("'{}' {PEER}", program.display());
    let run = ["run", "--level", "strict", "--max-restarts", "0"];
    let mut judged = Command::new(verifier);
    judged.args(run).args(["--peer-cmd", &peer, "--json"]);
    judged.arg(program.with_extension("json"));

    let first = std::env::var(FIRST).unwrap_or_default();
    let patterns = first.split_whitespace();
    let mut some = Command::new(judged.get_program());
    some.args(judged.get_args());
    for pattern in patterns.clone() {
        some.args(["--filter", pattern]);
    }
    let is_right = patterns.count() == 0 || some.status()?.success();
    Ok(is_right && judged.status()?.success())
}
