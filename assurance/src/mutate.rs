//! Changes of the sources that nobody planted: who notices them.
//!
//! - `kernel`: one token of the kernel at a time, held against the properties.
//! - `spec`: mutants of the specification by cargo-mutants, held against the golden cases and the tests.

mod kernel;
mod spec;

use clap::Subcommand;
use xtask::project::Project;

use crate::Error;

#[derive(Debug, Subcommand)]
pub(crate) enum Mutate {
    /// Change one token of the kernel, so many times, and hold each changed one against the properties
    Kernel {
        /// The options of proofs/README.md
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        options: Vec<String>,
    },
    /// Mutate the specification by cargo-mutants
    Spec {
        /// `--module NAME`, `--missed`, `--report`, `--check`
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        options: Vec<String>,
    },
}

pub(crate) fn run(project: &Project, command: &Mutate) -> Result<bool, Error> {
    let words = |options: &'_ [String]| options.to_vec();
    match command {
        Mutate::Kernel { options } => {
            let options = words(options);
            kernel::run(project, &options.iter().map(String::as_str).collect::<Vec<_>>())
        }
        Mutate::Spec { options } => {
            let options = words(options);
            spec::run(project, &options.iter().map(String::as_str).collect::<Vec<_>>())
        }
    }
}
