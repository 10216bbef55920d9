//! The golden cases, held against changed kernels behind the Rust peer.

use std::collections::BTreeMap;
use std::time::Duration;

use ncp_defects::Defect;
use ncp_verifier::dictionary::CaseKey;
use ncp_verifier::suite::{Case, Suite};
use serde::Serialize;
use xtask::project::Project;

use super::super::MutateError;
use super::Kernel;
use crate::console;
use crate::mutants::{self, Asks, Hunt, MutantsError, command};

/// The areas whose cases reach what moves a plant.
const AREAS: [&str; 5] = ["safety/", "resilience/", "control/", "strict/", "session/"];
/// How long one kernel may take for them.
const LIMIT: Duration = Duration::from_secs(120);
/// How many run side by side.
const JOBS: usize = 2;

/// What the golden cases say of a changed kernel.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Judged {
    /// So many fail, this one first.
    Failed { cases: usize, first: String },
    /// They do not come to their end in time.
    Late,
    /// All pass.
    Passed,
}

/// What they say of each kernel, by its id.
///
/// # Errors
/// The kernels cannot be woven into one peer, or that does not start.
pub(super) fn hold(project: &Project, kernels: &[Kernel]) -> Result<BTreeMap<String, Judged>, MutateError> {
    let stop = console::stop().map_err(MutateError::Signals)?;
    let suite = Suite::embedded()?;
    let defects: Vec<Defect> = kernels.iter().map(|kernel| kernel.defect.clone()).collect();
    let program = command::build(project, &defects, &stop)?;
    let hunt = Hunt { program: &program, suite: &suite, asks: Asks::All, jobs: JOBS, limit: LIMIT, stop: &stop };
    let is_asked = |case: &&Case| AREAS.iter().any(|area| case.id.starts_with(area));
    // Those with large requests take longer than all others together: they are for the kernels that pass these.
    let (large, small): (Vec<&Case>, Vec<&Case>) =
        suite.cases().iter().filter(is_asked).partition(|case| case.is_large());
    let all: Vec<&Kernel> = kernels.iter().collect();
    let mut judged = judge(&hunt, &all, &small)?;
    let passed: Vec<&Kernel> =
        kernels.iter().filter(|kernel| judged.get(&kernel.id) == Some(&Judged::Passed)).collect();
    judged.extend(judge(&hunt, &passed, &large)?);
    Ok(judged)
}

/// What these cases say of each of these kernels.
fn judge(hunt: &Hunt<'_>, kernels: &[&Kernel], cases: &[&Case]) -> Result<BTreeMap<String, Judged>, MutateError> {
    // The kernel without a change comes first: a case that it fails says nothing of the others.
    let changed = kernels.iter().map(|kernel| vec![kernel.defect.name.clone()]);
    let peers: Vec<Vec<String>> = std::iter::once(Vec::new()).chain(changed).collect();
    let mut observed = mutants::observe(hunt, &peers, cases, &|_| ())?.into_iter();
    let sound = observed.next().transpose()?.map(|sound| sound.symptoms().len());
    if let Some(failing) = sound.filter(|failing| *failing > 0) {
        return Err(MutateError::UnsoundKernel { failing });
    }
    let judged = kernels.iter().zip(observed).map(|(kernel, observed)| {
        let judged = match observed {
            Err(MutantsError::Late { .. }) => Judged::Late,
            Err(error) => return Err(error.into()),
            Ok(observed) => {
                let symptoms = observed.symptoms();
                let first = cases.iter().find(|case| symptoms.contains_key(&CaseKey::of(&case.id)));
                let failed = |first: &&Case| Judged::Failed { cases: symptoms.len(), first: first.id.clone() };
                first.map_or(Judged::Passed, failed)
            }
        };
        Ok((kernel.id.clone(), judged))
    });
    judged.collect()
}
