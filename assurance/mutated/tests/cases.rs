//! Started by cargo, this program has a verifier judge a peer; started by that verifier, it is the peer.

#![forbid(unsafe_code)]

use std::io::{self, BufReader, BufWriter};
use std::process::{Command, ExitCode};

use ncp_peer_rust::hold;

/// Holds the path of a verifier that was built without the mutation.
const VERIFIER: &str = "NCP_VERIFIER";
/// Holds the patterns of the cases that are judged, with a blank between two; what stands after a `;` is judged
/// only when all that stands before it passes.
const CASES: &str = "NCP_CASES";
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

/// Whether this peer conforms: first by the cases that are likely to show the mutation, then by others.
fn judge() -> io::Result<bool> {
    let missing = |name| io::Error::other(format!("the environment has no {name}"));
    let verifier = std::env::var_os(VERIFIER).ok_or_else(|| missing(VERIFIER))?;
    let cases = std::env::var(CASES).map_err(|_| missing(CASES))?;
    let program = std::env::current_exe()?;
    let peer = format!("'{}' {PEER}", program.display());
    for patterns in cases.split(';') {
        let mut judged = Command::new(&verifier);
        // One silent or broken answer decides, so that the peer need not be started again.
        judged.args(["run", "--level", "strict", "--max-restarts", "0"]);
        judged.args(["--peer-cmd", &peer, "--json"]);
        judged.arg(program.with_extension("json"));
        for pattern in patterns.split_whitespace() {
            judged.args(["--filter", pattern]);
        }
        if !judged.status()?.success() {
            return Ok(false);
        }
    }
    Ok(true)
}
