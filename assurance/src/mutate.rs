//! Changes of the sources that nobody planted: who notices them.
//!
//! | module | what it does |
//! |---|---|
//! | `kernel` | changes one token of the kernel at a time, and holds each changed kernel against the properties |
//! | `spec` | has cargo-mutants change the specification, and holds each mutant against the cases and the tests |
//! | `cargo` | reads what cargo prints for programs |

mod cargo;
pub(crate) mod kernel;
pub(crate) mod spec;

use clap::Subcommand;
use xtask::project::Project;

use crate::Error;

#[derive(Debug, Subcommand)]
pub(crate) enum Mutate {
    /// Change one token of the kernel, so many times, and hold each changed one against the properties
    #[command(after_help = kernel::EXAMPLES)]
    Kernel(kernel::KernelArgs),
    /// Have cargo-mutants change the specification, and ask the golden cases and the tests who notices
    #[command(after_help = spec::EXAMPLES)]
    Spec(spec::SpecArgs),
}

/// # Errors
/// As the command has them; `false` if a change goes unnoticed and nothing says why it may.
pub(crate) fn run(project: &Project, command: &Mutate) -> Result<bool, Error> {
    match command {
        Mutate::Kernel(args) => Ok(kernel::run(project, args)?),
        Mutate::Spec(args) => Ok(spec::run(project, args)?),
    }
}
