//! Where things are, and how programs are started.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use thiserror::Error;

/// The checked-out project.
#[derive(Debug, Clone)]
pub struct Project {
    root: PathBuf,
}

impl Project {
    /// The project whose program cargo runs: the program's package is a folder at the top.
    ///
    /// # Errors
    /// The program was not started by cargo, which says where its package lies.
    pub fn find() -> Result<Self, NoProject> {
        let package = std::env::var_os("CARGO_MANIFEST_DIR").ok_or(NoProject)?;
        Ok(Self::at(Path::new(&package).parent().ok_or(NoProject)?))
    }

    /// The project in a folder.
    #[must_use]
    pub fn at(root: &Path) -> Self {
        Self { root: root.to_owned() }
    }

    /// A path within the project.
    #[must_use]
    pub fn path(&self, relative: &str) -> PathBuf {
        self.root.join(relative)
    }

    /// A program, to be started in a folder of the project without input and colours.
    pub fn program(&self, program: impl Into<OsString>, args: &[&str], folder: &str) -> Command {
        let mut command = Command::new(program.into());
        command
            .args(args)
            .current_dir(self.path(folder))
            .stdin(Stdio::null())
            .env("NO_COLOR", "1")
            .env("CARGO_TERM_COLOR", "never");
        command
    }

    /// The cargo that started this program.
    #[must_use]
    pub fn cargo(&self, args: &[&str]) -> Command {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        self.program(cargo, args, "")
    }
}

/// The program was not started by cargo, which alone says where the project lies.
#[derive(Debug, Error)]
#[error("not started by cargo: CARGO_MANIFEST_DIR is not set")]
pub struct NoProject;

/// A program and its arguments, as somebody would type them.
#[must_use]
pub fn shown(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let program = program.file_stem().unwrap_or(program.as_os_str());
    let words = std::iter::once(program).chain(command.get_args());
    words.map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ")
}
