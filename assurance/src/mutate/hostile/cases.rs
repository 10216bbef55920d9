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
use crate::mutants::{self, Hunt, MutantsError, command};

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
    let hunt = Hunt { program: &program, suite: &suite, jobs: JOBS, limit: LIMIT, stop: &stop };
    let is_asked = |case: &&Case| !case.is_large() && AREAS.iter().any(|area| case.id.starts_with(area));
    let cases: Vec<&Case> = suite.cases().iter().filter(is_asked).collect();
    let names = |kernels: &[Kernel]| kernels.iter().map(|kernel| vec![kernel.defect.name.clone()]).collect();
    // The kernel without a change comes first: a case that it fails says nothing of the others.
    let peers: Vec<Vec<String>> = [vec![Vec::new()], names(kernels)].concat();
    let mut observed = mutants::observe(&hunt, &peers, &cases, &|_| ())?.into_iter();
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
