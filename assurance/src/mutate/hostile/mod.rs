//! Holds the kernels of the hostile auditor against means that share no harness, of which two have to notice each.
//!
//! - The properties: on samples, on enumerated values, and for all doubles by the solvers.
//! - The golden cases: the changed kernel behind the Rust peer, judged by the verifier.
//! - The tie of the theorem: what the changed source does on terms is not what Coq has as its model. It takes minutes
//!   for some kernels, and is asked only of those that one of the others lets pass; terms know nothing of numbers.

mod cases;
mod report;
mod tie;

use std::collections::BTreeMap;

use clap::Args;
use ncp_defects::{Defect, place};
use xtask::project::Project;
use xtask::setup;

use self::cases::Judged;
use self::report::{Fate, Held, Report};
use self::tie::Tie;
use super::MutateError;
use super::copies::{Ask, Changed, Copies, SCALAR};
use super::kernel::sources;

/// The table of the kernels.
const TABLE: &str = "defects/hostile.toml";

pub(super) const EXAMPLES: &str = "\
Examples:
  cargo assure mutate hostile                          all: what reports/hostile.md is made of
  cargo assure mutate hostile --tie                    the theorem's tie is asked of each, which takes hours
  cargo assure mutate hostile --only frame-reset-speed   one; no report
  cargo assure mutate hostile --table mine.toml        kernels of your own, in the form of defects/hostile.toml";

#[derive(Debug, Args)]
pub(crate) struct HostileArgs {
    /// Only this kernel; may be given again. Nothing is written into the tree
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,
    /// Another table of changed kernels, from the root of the project. Nothing is written into the tree
    #[arg(long, value_name = "FILE", default_value = TABLE)]
    table: String,
    /// Ask the theorem's tie of every kernel, also of those that properties and golden cases both notice
    #[arg(long)]
    tie: bool,
}

/// A kernel of the table.
#[derive(Clone)]
struct Kernel {
    id: String,
    defect: Defect,
    /// The files that it changes, and what stands in them then.
    texts: BTreeMap<String, String>,
}

impl Changed for Kernel {
    fn id(&self) -> &str {
        &self.id
    }

    fn change(&self, file: &str, _: &str) -> Option<String> {
        self.texts.get(file).cloned()
    }

    fn is_of_numbers(&self) -> bool {
        self.texts.keys().all(|file| file == SCALAR)
    }
}

/// Holds the kernels against all; `false` if fewer than two notice one.
///
/// # Errors
/// A table, a file, or a program that cannot be started.
pub(crate) fn run(project: &Project, args: &HostileArgs) -> Result<bool, MutateError> {
    let sources = sources(project)?;
    let kernels = kernels(project, args, &sources)?;
    println!("{} hostile kernels", kernels.len());

    let copies = Copies::new(project, &sources)?;
    let (good, refused) = copies.that_compile(kernels.clone())?;
    let mut fates = properties(&copies, &good)?;
    fates.extend(refused.into_iter().map(|(id, said)| (id, Fate::NotBuilt(said))));
    let mut judged = cases::hold(project, &kernels)?;

    let held = kernels.iter().map(|kernel| Held {
        properties: fates.remove(&kernel.id).unwrap_or_else(|| Fate::Open("not held against anything".to_owned())),
        cases: judged.remove(&kernel.id).unwrap_or(Judged::Passed),
        tie: None,
        name: kernel.defect.name.clone(),
        about: kernel.defect.about.clone(),
        is_of_numbers: kernel.is_of_numbers(),
    });
    let mut report = Report { kernels: held.collect() };
    let asked = kernels.iter().zip(&report.kernels).filter(|(_, held)| args.tie || held.asks_the_tie());
    let asked: Vec<Kernel> = asked.map(|(kernel, _)| kernel.clone()).collect();
    if !asked.is_empty() {
        println!("{} are left for the tie of the theorem", asked.len());
        let mut ties = Tie::new(project)?.hold(&asked)?;
        for (kernel, held) in kernels.iter().zip(&mut report.kernels) {
            held.tie = ties.remove(&kernel.id);
        }
    }
    report.kernels.iter().for_each(|held| println!("{held}"));
    println!("{}", report.summary());
    if args.only.is_empty() && args.table == TABLE {
        report.write(project)?;
    }
    Ok(report.problems().is_empty())
}

/// The kernels that are asked for.
fn kernels(
    project: &Project,
    args: &HostileArgs,
    sources: &BTreeMap<String, String>,
) -> Result<Vec<Kernel>, MutateError> {
    let defects = ncp_defects::read(&project.path(&args.table))?;
    if let Some(name) = args.only.iter().find(|name| defects.iter().all(|defect| defect.name != **name)) {
        return Err(MutateError::NoKernel { name: name.clone() });
    }
    let wanted = defects.into_iter().filter(|defect| args.only.is_empty() || args.only.contains(&defect.name));
    let kernel = |(nth, defect): (usize, Defect)| {
        let mut texts = BTreeMap::new();
        for (file, text) in sources {
            if defect.edit.iter().any(|edit| edit.file == *file) {
                texts.insert(file.clone(), place::plant(place::without_tests(text), file, &defect)?);
            }
        }
        Ok(Kernel { id: format!("m_{nth:05}"), defect, texts })
    };
    wanted.enumerate().map(kernel).collect()
}

/// What the properties say of each that compiles.
fn properties(copies: &Copies<'_>, kernels: &[Kernel]) -> Result<BTreeMap<String, Fate>, MutateError> {
    let ask = |kernels: &[&Kernel], ask| -> Result<BTreeMap<String, Fate>, MutateError> {
        let answers = copies.hold(kernels, ask)?.into_iter();
        Ok(answers
            .map(|answer| (answer.id, answer.refuted.map_or(Fate::Open(answer.said), |by| Fate::Refuted(by.into()))))
            .collect())
    };
    let all: Vec<&Kernel> = kernels.iter().collect();
    if all.is_empty() {
        return Ok(BTreeMap::new());
    }
    let mut fates = ask(&all, Ask::Numbers)?;
    let is_open = |kernel: &&Kernel| !matches!(fates.get(&kernel.id), Some(Fate::Refuted(_)));
    let open: Vec<&Kernel> = kernels.iter().filter(is_open).collect();
    if !open.is_empty() {
        println!("{} are left for the symbolic engine", open.len());
        setup::solvers(copies.project(), &mut |line| println!("{line}"))?;
        fates.extend(ask(&open, Ask::Solvers)?);
    }
    Ok(fates)
}

impl Changed for &Kernel {
    fn id(&self) -> &str {
        (*self).id()
    }

    fn change(&self, file: &str, text: &str) -> Option<String> {
        (*self).change(file, text)
    }

    fn is_of_numbers(&self) -> bool {
        (*self).is_of_numbers()
    }
}
