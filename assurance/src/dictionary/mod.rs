//! `cargo assure dictionary`: makes the fault dictionary of the verifier, and measures what a diagnosis by it is worth.
//!
//! Every planted defect is run alone against the whole suite: that is the dictionary. Then pairs and triples of them,
//! drawn at random, are woven into one peer, and the diagnosis has to name them; and every single defect is diagnosed
//! with its own entry left out, when it has to come out as unexplained. What was seen is kept in `.tools/dictionary`,
//! so that a change of the diagnosis alone is measured without running anything again.
//!
//! Cases with requests above 64 KiB take longer than all others together. They are run only for a defect that no other
//! case shows.
//!
//! - `seen`: what is seen of peers with planted defects.
//! - `measured`: what the diagnosis makes of it.

mod measured;
mod seen;

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use ncp_defects::Defect;
use ncp_verifier::dictionary::{Dictionary, Entry, Observed};
use ncp_verifier::suite::{Case, Suite};
use xtask::project::Project;

use crate::artefact::Artefact;
use crate::mutants::{Asks, Hunt, MutantsError, command};
use crate::{Error, console, reports};
use measured::Measured;
use seen::Store;

#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct DictionaryArgs {
    /// How many random pairs and triples are woven together; writes no reports unless it is the default
    #[arg(long, value_name = "N", default_value_t = TOGETHER)]
    together: usize,
    /// How many peers run side by side
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: u16,
    /// The program that holds the defects, started with `--defect NAME`, instead of building it
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
}

const HELP: &str = "\
Writes verifier/dictionary.json, reports/dictionary.md and reports/lock/dictionary.toml.
Ends with 1 if a planted defect shows nowhere.

Examples:
  cargo assure dictionary
  cargo assure dictionary --together 100";

/// The artefact that this command makes.
const ARTEFACT: &str = "dictionary";
const MADE: &str = "verifier/dictionary.json";
/// The source that decides nothing of what is seen.
const DIAGNOSIS: &str = "verifier/src/dictionary/explain.rs";
/// Where it is kept what was seen.
const STORE: &str = ".tools/dictionary";
/// How many pairs and triples are drawn, and by what.
const TOGETHER: usize = 1000;
const SEED: u64 = 1;
/// How long one peer may take for the suite.
const LIMIT: Duration = Duration::from_secs(300);

/// Makes and measures the dictionary; `false` if a defect shows nowhere.
pub(crate) fn dictionary(project: &Project, args: &DictionaryArgs) -> Result<bool, Error> {
    let stop = console::stop().map_err(Error::Signals)?;
    let suite = Suite::embedded()?;
    let root = project.path("");
    let sources = Artefact::named(ARTEFACT).map(|own| own.digests(&root)).transpose();
    let sources = sources.map_err(|source| Error::File { path: root.clone(), source })?.unwrap_or_default();
    let defects = ncp_defects::read(&root.join(command::TABLES)).map_err(MutantsError::from)?;
    let program = match &args.program {
        Some(program) => std::path::absolute(program).unwrap_or_else(|_| program.clone()),
        None => command::build(project, &defects, &stop)?,
    };
    let jobs = usize::from(args.jobs);
    let hunt = Hunt { program: &program, suite: &suite, asks: Asks::All, jobs, limit: LIMIT, stop: &stop };
    let (large, small): (Vec<&Case>, Vec<&Case>) = suite.cases().iter().partition(|case| case.is_large());

    // What the diagnosis makes of what is seen changes nothing of it.
    let seen_of = sources.iter().filter(|(source, _)| *source != DIAGNOSIS);
    let seen_of = seen_of.map(|(source, digest)| (source.clone(), digest.clone())).collect();
    let eyes = Eyes { store: Store { folder: project.path(STORE), sources: seen_of }, hunt: &hunt, defects: &defects };
    let alone: Vec<Vec<usize>> = (0..defects.len()).map(|place| vec![place]).collect();
    let mut singles = eyes.observed("alone", &alone, &small)?;
    let shows: Vec<bool> = singles.iter().map(|single| !single.symptoms().is_empty()).collect();
    let is_shown = |set: &[usize]| set.iter().all(|place| shows.get(*place).is_some_and(|shows| *shows));
    eyes.add_large("alone-large", &alone, &mut singles, &large, is_shown)?;
    let sets = drawn(defects.len(), args.together, SEED);
    let mut together = eyes.observed(&format!("together-{}", args.together), &sets, &small)?;
    eyes.add_large(&format!("together-{}-large", args.together), &sets, &mut together, &large, is_shown)?;

    let dictionary = made(&suite, &defects, &singles);
    let measured = Measured::of(&dictionary, &singles, &sets, &together);
    if args.together == TOGETHER {
        let path = root.join(MADE);
        fs::write(&path, dictionary.write()?).map_err(|source| Error::File { path, source })?;
        reports::page(&root.join(reports::PAGES), ARTEFACT, &measured.page())?;
        if args.program.is_none() {
            measured.lock(sources).write(&root, ARTEFACT)?;
        }
    }
    print!("{}", measured.summary());
    Ok(dictionary.entries.iter().all(|entry| !entry.symptoms.is_empty()))
}

/// What sees peers with defects.
struct Eyes<'e> {
    store: Store,
    hunt: &'e Hunt<'e>,
    defects: &'e [Defect],
}

impl Eyes<'_> {
    /// What is seen of the peers with these sets of defects.
    fn observed(&self, name: &str, sets: &[Vec<usize>], cases: &[&Case]) -> Result<Vec<Observed>, Error> {
        let name_of = |place: &usize| self.defects.get(*place).map(|defect| defect.name.clone());
        let peers: Vec<Vec<String>> = sets.iter().map(|set| set.iter().filter_map(name_of).collect()).collect();
        self.store.observed(name, self.hunt, &peers, cases)
    }

    /// Adds what large cases show of those sets of which the others do not show all: they take longer than these.
    fn add_large(
        &self,
        name: &str,
        sets: &[Vec<usize>],
        seen: &mut [Observed],
        large: &[&Case],
        is_shown: impl Fn(&[usize]) -> bool,
    ) -> Result<(), Error> {
        let (places, hidden): (Vec<usize>, Vec<Vec<usize>>) =
            sets.iter().cloned().enumerate().filter(|(_, set)| !is_shown(set)).unzip();
        for (place, more) in places.into_iter().zip(self.observed(name, &hidden, large)?) {
            if let Some(seen) = seen.get_mut(place) {
                seen.cases.extend(more.cases);
            }
        }
        Ok(())
    }
}

/// The dictionary of what was seen of each defect alone.
fn made(suite: &Suite, defects: &[Defect], singles: &[Observed]) -> Dictionary {
    let entry = |(defect, observed): (&Defect, &Observed)| Entry {
        name: defect.name.clone(),
        words: defect.about.clone(),
        rules: defect.rules.clone(),
        symptoms: observed.symptoms(),
    };
    Dictionary { corpus: suite.digest().to_owned(), entries: defects.iter().zip(singles).map(entry).collect() }
}

/// As many random pairs and triples of so many defects, in turn.
fn drawn(defects: usize, count: usize, seed: u64) -> Vec<Vec<usize>> {
    let mut state = seed;
    // SplitMix64: the same sets on every machine.
    let mut next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    };
    let set = |number: usize| {
        let mut set = BTreeSet::new();
        while set.len() < (2 + number % 2).min(defects) {
            set.insert(usize::try_from(next() % defects.max(1) as u64).unwrap_or_default());
        }
        set.into_iter().collect()
    };
    (0..count).map(set).collect()
}
