//! The NEST service, as a process of its own.

use std::io::{BufRead as _, BufReader};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::LiveError;

/// A running service; it ends when it is dropped.
pub(crate) struct Simulator {
    /// Where it answers lines.
    pub(crate) address: SocketAddr,
    process: Child,
}

/// How long it may take to open a session, and then a client of the gateway waits for a reply.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// How long it may take to end its sessions.
const ENDS: Duration = Duration::from_secs(10);

impl Simulator {
    /// Starts it with a Python that has NEST, or installs one for it.
    ///
    /// # Errors
    /// NEST cannot be installed, or the service does not say where it listens.
    pub(crate) fn start(python: Option<&Path>) -> Result<Self, LiveError> {
        let python = match python {
            Some(python) => python.to_owned(),
            None => installed()?,
        };
        let mut process = Command::new(&python)
            .args(["-m", "ncp_nest", "--listen", "127.0.0.1:0"])
            .env("PYNEST_QUIET", "1")
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|error| LiveError::Nest(format!("{}: {error}", python.display())))?;
        let mut line = String::new();
        if let Some(stdout) = process.stdout.take() {
            BufReader::new(stdout).read_line(&mut line)?;
        }
        match line.trim().strip_prefix("listening on ").and_then(|address| address.parse().ok()) {
            Some(address) => Ok(Self { address, process }),
            None => {
                // It has ended, or is no such service.
                let _ = (process.kill(), process.wait());
                Err(LiveError::Nest(format!("{} -m ncp_nest does not say where it listens", python.display())))
            }
        }
    }
}

impl Drop for Simulator {
    fn drop(&mut self) {
        // Asked to end, it ends the processes of its sessions.
        let _ = Command::new("kill").args(["-TERM", &self.process.id().to_string()]).status();
        let began = Instant::now();
        while began.elapsed() < ENDS {
            if matches!(self.process.try_wait(), Ok(Some(_))) {
                return;
            }
            thread::sleep(Duration::from_millis(20));
        }
        let _ = (self.process.kill(), self.process.wait());
    }
}

/// The Python of the repository that has NEST; a first run installs it.
fn installed() -> Result<PathBuf, LiveError> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let build = root.join("peers/nest/build.py");
    let status = Command::new("python3").arg(&build).status();
    match status {
        Ok(status) if status.success() => Ok(root.join(".tools/nest-venv/bin/python")),
        Ok(status) => Err(LiveError::Nest(format!("python3 {}: {status}", build.display()))),
        Err(error) => Err(LiveError::Nest(format!("python3: {error}"))),
    }
}
