//! What is seen of peers with planted defects: by running them, or from the store of what was seen before.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::IsTerminal as _;
use std::path::PathBuf;

use ncp_verifier::dictionary::{CaseKey, DictionaryError, Observed, Seen, Symptom};
use ncp_verifier::report::Progress;
use ncp_verifier::suite::Case;
use serde::{Deserialize, Serialize};

use crate::Error;
use crate::mutants::{self, Hunt, MutantsError};

/// How many peers are run between two words on how far it is.
const SAID_EVERY: usize = 25;

/// Where it is kept what was seen, in a folder that git ignores.
pub(super) struct Store {
    pub(super) folder: PathBuf,
    /// The digests of that of which it was seen; with others, it is seen anew.
    pub(super) sources: BTreeMap<String, String>,
}

/// As it is kept.
#[derive(Serialize, Deserialize)]
struct Kept {
    sources: BTreeMap<String, String>,
    /// The defects of each peer, its failing cases with their symptoms, and the cases that were not judged.
    peers: Vec<Peer>,
}

type Peer = (Vec<String>, BTreeMap<u32, (u8, u8, u16)>, BTreeSet<u32>);

impl Store {
    /// What is seen of the peers with these defects, each asked all these cases.
    pub(super) fn observed(
        &self,
        name: &str,
        hunt: &Hunt<'_>,
        peers: &[Vec<String>],
        cases: &[&Case],
    ) -> Result<Vec<Observed>, Error> {
        let path = self.folder.join(format!("{name}.json"));
        let cases_and_describe: Vec<&Case> = hunt.suite.with_describe().take(1).chain(cases.iter().copied()).collect();
        let kept = fs::read_to_string(&path).ok().and_then(|text| serde_json::from_str::<Kept>(&text).ok());
        if let Some(kept) = kept
            && kept.sources == self.sources
            && kept.peers.iter().map(|(defects, ..)| defects).eq(peers)
        {
            return Ok(kept.peers.iter().map(|peer| unpacked(peer, &cases_and_describe)).collect());
        }
        let observed = observe(name, hunt, peers, cases)?;
        let peers =
            peers.iter().zip(&observed).map(|(defects, seen)| packed(defects, seen, &cases_and_describe)).collect();
        let text =
            serde_json::to_string(&Kept { sources: self.sources.clone(), peers }).map_err(DictionaryError::from)?;
        let kept = fs::create_dir_all(&self.folder).and_then(|()| fs::write(&path, text));
        kept.map_err(|source| Error::File { path, source })?;
        Ok(observed)
    }
}

fn packed(defects: &[String], observed: &Observed, cases: &[&Case]) -> Peer {
    let numbers = |Symptom { step, place, value }| (step, place, value);
    let failing = observed.symptoms().into_iter().map(|(key, symptom)| (key.0, numbers(symptom))).collect();
    let unjudged = cases.iter().map(|case| CaseKey::of(&case.id)).filter(|key| !observed.cases.contains_key(key));
    (defects.to_vec(), failing, unjudged.map(|key| key.0).collect())
}

fn unpacked((_, failing, unjudged): &Peer, cases: &[&Case]) -> Observed {
    let seen = |case: &&Case| {
        let key = CaseKey::of(&case.id);
        let symptom = failing.get(&key.0).map(|&(step, place, value)| Symptom { step, place, value });
        (!unjudged.contains(&key.0)).then(|| (key, Seen::new(case, symptom)))
    };
    Observed { cases: cases.iter().filter_map(seen).collect() }
}

/// Runs the cases against a peer with each of these sets of defects.
fn observe(name: &str, hunt: &Hunt<'_>, peers: &[Vec<String>], cases: &[&Case]) -> Result<Vec<Observed>, Error> {
    let said = Progress::spinner(format!("{name}: {} peers", peers.len()), std::io::stderr().is_terminal());
    let seen = mutants::observe(hunt, peers, cases, &|number| {
        if number.is_multiple_of(SAID_EVERY) {
            said.say(&format!("{name}: {number} of {}", peers.len()));
        }
    });
    said.done();
    Ok(seen?.into_iter().collect::<Result<_, MutantsError>>()?)
}
