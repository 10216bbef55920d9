//! `cargo assure dictionary`: makes the fault dictionary of the verifier, and measures what its diagnosis is worth.
//!
//! Every planted defect is run alone against the whole suite: that is the dictionary. Then pairs and triples of them are
//! woven into one peer, drawn at random, and the diagnosis has to name them; and every single defect is diagnosed with
//! its own entry left out, when it has to come out as unexplained. What was seen is kept in `.tools/dictionary`, so that
//! a change of the diagnosis alone is measured without running anything again.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::IsTerminal as _;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use clap::Args;
use ncp_defects::Defect;
use ncp_verifier::dictionary::{CaseKey, Dictionary, Entry, Explanation, Observed, Symptom};
use ncp_verifier::report::Progress;
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::{Case, Suite};
use xtask::project::Project;

use crate::artefact::Artefact;
use crate::mutants::{Hunt, MutantsError, command, trial};
use crate::{Error, console, reports};

#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct DictionaryArgs {
    /// How many random pairs and triples are woven together
    #[arg(long, value_name = "N", default_value_t = 1000)]
    together: usize,
    /// What they are drawn by
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// How many peers run side by side
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: u16,
    /// Take the program that holds the defects as it is, instead of building it
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
}

const HELP: &str = "\
Writes verifier/dictionary.json, reports/diagnosis.md and reports/lock/dictionary.toml.
Ends with 1 if a planted defect shows nowhere.

Examples:
  cargo assure dictionary
  cargo assure dictionary --together 100 --seed 7";

/// The artefact that this command makes.
const ARTEFACT: &str = "dictionary";
const MADE: &str = "verifier/dictionary.json";
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
    let hunt = Hunt { program: &program, suite: &suite, jobs: usize::from(args.jobs), limit: LIMIT, stop: &stop };
    let (all, small): (Vec<&Case>, Vec<&Case>) =
        (suite.cases().iter().collect(), suite.cases().iter().filter(|case| !case.is_large()).collect());

    let store = Store { folder: project.path(".tools/dictionary"), sources: sources.clone() };
    let alone: Vec<Vec<usize>> = (0..defects.len()).map(|place| vec![place]).collect();
    let singles = store.observed("alone", &hunt, &defects, &alone, &all)?;
    let dictionary = made(&defects, &singles);
    let sets = drawn(defects.len(), args.together, args.seed);
    let name = format!("together-{}-{}", args.together, args.seed);
    let together = store.observed(&name, &hunt, &defects, &sets, &small)?;

    let measured = Measured::of(&dictionary, &singles, &sets, &together);
    let text = dictionary.write()?;
    let path = root.join(MADE);
    fs::write(&path, text).map_err(|source| Error::File { path, source })?;
    for (planted, named) in measured.wrong_alone.iter().chain(&measured.wrong_left_out).chain(&measured.wrong_together) {
        eprintln!("{planted}\n    {named}");
    }
    print!("{}", measured.summary());
    Ok(dictionary.entries.iter().all(|entry| !entry.symptoms.is_empty()))
}

/// The dictionary of what was seen of each defect alone.
fn made(defects: &[Defect], singles: &[Observed]) -> Dictionary {
    let entry = |(defect, observed): (&Defect, &Observed)| Entry {
        name: defect.name.clone(),
        words: defect.about.clone(),
        rules: defect.rules.clone(),
        symptoms: observed.symptoms(),
    };
    Dictionary { entries: defects.iter().zip(singles).map(entry).collect() }
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

/// What was seen before of the same sources.
struct Store {
    folder: PathBuf,
    sources: BTreeMap<String, String>,
}

/// As it stands in the store: the sources, and for each peer its cases.
type Stored = (BTreeMap<String, String>, Vec<BTreeMap<u32, Option<u16>>>);

impl Store {
    /// What is seen of the peers with these sets of defects.
    fn observed(
        &self,
        name: &str,
        hunt: &Hunt<'_>,
        defects: &[Defect],
        sets: &[Vec<usize>],
        cases: &[&Case],
    ) -> Result<Vec<Observed>, Error> {
        let path = self.folder.join(format!("{name}.json"));
        let stored = fs::read_to_string(&path).ok().and_then(|text| serde_json::from_str::<Stored>(&text).ok());
        if let Some((sources, peers)) = stored
            && sources == self.sources
            && peers.len() == sets.len()
        {
            return Ok(peers.into_iter().map(unpacked).collect());
        }
        let observed = observe(name, hunt, defects, sets, cases)?;
        let peers: Vec<_> = observed.iter().map(packed).collect();
        let text = serde_json::to_string(&(&self.sources, &peers)).map_err(ncp_verifier::dictionary::DictionaryError::from)?;
        let kept = fs::create_dir_all(&self.folder).and_then(|()| fs::write(&path, text));
        kept.map_err(|source| Error::File { path, source })?;
        Ok(observed)
    }
}

fn packed(observed: &Observed) -> BTreeMap<u32, Option<u16>> {
    observed.cases.iter().map(|(case, symptom)| (case.0, symptom.map(|symptom| symptom.0))).collect()
}

fn unpacked(cases: BTreeMap<u32, Option<u16>>) -> Observed {
    Observed { cases: cases.into_iter().map(|(case, symptom)| (CaseKey(case), symptom.map(Symptom))).collect() }
}

/// Runs the suite against a peer with each of these sets of defects.
fn observe(
    name: &str,
    hunt: &Hunt<'_>,
    defects: &[Defect],
    sets: &[Vec<usize>],
    cases: &[&Case],
) -> Result<Vec<Observed>, Error> {
    let said = Progress::spinner(format!("{}: 0 of {}", name, sets.len()), std::io::stderr().is_terminal());
    let next = AtomicUsize::new(0);
    let seen: Mutex<Vec<(usize, Result<Observed, MutantsError>)>> = Mutex::default();
    thread::scope(|scope| {
        for _ in 0..hunt.jobs.max(1) {
            scope.spawn(|| {
                while !hunt.stop.is_set() {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    let Some(set) = sets.get(number) else {
                        break;
                    };
                    let names: Vec<String> =
                        set.iter().filter_map(|place| defects.get(*place)).map(|defect| defect.name.clone()).collect();
                    let observed = trial::observe(hunt, &names, cases);
                    if number % 50 == 49 {
                        said.say(&format!("{name}: {} of {}", number + 1, sets.len()));
                    }
                    seen.lock().unwrap_or_else(PoisonError::into_inner).push((number, observed));
                }
            });
        }
    });
    said.done();
    if hunt.stop.is_set() {
        return Err(MutantsError::Interrupted.into());
    }
    let mut seen = seen.into_inner().unwrap_or_else(PoisonError::into_inner);
    seen.sort_by_key(|(number, _)| *number);
    Ok(seen.into_iter().map(|(_, observed)| observed).collect::<Result<_, _>>()?)
}

/// What the diagnosis is worth.
#[derive(Debug, Default)]
struct Measured {
    /// Of defects alone: how many there are, and of how many exactly the planted one is named.
    singles: (usize, usize),
    /// Those of which something else is named, and what.
    wrong_alone: Vec<(String, String)>,
    /// Of defects with their own entry left out: those with which another is named, and which.
    wrong_left_out: Vec<(String, String)>,
    /// How many pairs and triples, and how many of them are named exactly.
    sets: (usize, usize),
    /// How many defects are planted in them, how many of these are named, and how many are named in all.
    planted: usize,
    found: usize,
    right: usize,
    named: usize,
    /// How many of those that are not named show in no case of their own: whatever fails with them fails so without.
    hidden: usize,
    /// What went wrong: the planted, and the named.
    wrong_together: Vec<(String, String)>,
}

impl Measured {
    fn of(dictionary: &Dictionary, singles: &[Observed], sets: &[Vec<usize>], together: &[Observed]) -> Self {
        let name = |place: &usize| dictionary.entries.get(*place).map_or("", |entry| entry.name.as_str());
        let mut measured = Self { singles: (singles.len(), 0), sets: (sets.len(), 0), ..Self::default() };
        for (place, observed) in singles.iter().enumerate() {
            let named = dictionary.explain(observed);
            match &named.defects[..] {
                [only] if only.entries.contains(&place) && named.unexplained.is_empty() => measured.singles.1 += 1,
                _ => measured.wrong_alone.push((name(&place).to_owned(), in_words(dictionary, &named))),
            }
            let without = dictionary.explain_without(observed, Some(place));
            if !without.defects.is_empty() {
                measured.wrong_left_out.push((name(&place).to_owned(), in_words(dictionary, &without)));
            }
        }
        for (set, observed) in sets.iter().zip(together) {
            let named = dictionary.explain(observed);
            let is_named = |place: &&usize| named.defects.iter().any(|defect| defect.entries.contains(place));
            let found = set.iter().filter(is_named).count();
            let right = named.defects.iter().filter(|defect| defect.entries.iter().any(|entry| set.contains(entry))).count();
            measured.planted += set.len();
            measured.found += found;
            measured.named += named.defects.len();
            measured.right += right;
            let shows = |place: &&usize| {
                let others = set.iter().filter(|other| other != place).filter_map(|other| dictionary.entries.get(*other));
                let others: Vec<_> = others.collect();
                dictionary.entries.get(**place).is_some_and(|own| {
                    own.symptoms.iter().any(|(case, symptom)| {
                        observed.cases.get(case) == Some(&Some(*symptom))
                            && !others.iter().any(|other| other.symptoms.get(case) == Some(symptom))
                    })
                })
            };
            measured.hidden += set.iter().filter(|place| !is_named(place) && !shows(place)).count();
            if found == set.len() && right == named.defects.len() {
                measured.sets.1 += 1;
            } else {
                let planted = set.iter().map(name).collect::<Vec<_>>().join(" + ");
                measured.wrong_together.push((planted, in_words(dictionary, &named)));
            }
        }
        measured
    }

    fn recall(&self) -> String {
        percent(self.found, self.planted)
    }

    fn precision(&self) -> String {
        percent(self.right, self.named)
    }

    fn summary(&self) -> String {
        format!(
            "alone: {} of {} named exactly; left out: {} of {} come out as unexplained\n\
             together: {} of {} sets named exactly; recall {} ({} of {}, {} of the rest hidden), precision {} ({} of {})\n",
            self.singles.1,
            self.singles.0,
            self.singles.0 - self.wrong_left_out.len(),
            self.singles.0,
            self.sets.1,
            self.sets.0,
            self.recall(),
            self.found,
            self.planted,
            self.hidden,
            self.precision(),
            self.right,
            self.named,
        )
    }
}

/// The names that an explanation gives; of defects that no case tells apart, all.
fn in_words(dictionary: &Dictionary, explanation: &Explanation) -> String {
    let name = |place: &usize| dictionary.entries.get(*place).map_or("", |entry| entry.name.as_str());
    let named: Vec<String> = explanation
        .defects
        .iter()
        .map(|defect| {
            let names = defect.entries.iter().map(name).collect::<Vec<_>>().join(" or ");
            format!("{names} ({} alike, {} otherwise, {} missed)", defect.alike.len(), defect.otherwise.len(), defect.missed)
        })
        .collect();
    let left = match explanation.unexplained.len() {
        0 => String::new(),
        count => format!("{count} unexplained"),
    };
    named.into_iter().chain((!left.is_empty()).then_some(left)).collect::<Vec<_>>().join("; ")
}

fn percent(part: usize, whole: usize) -> String {
    match whole {
        0 => "none".to_owned(),
        whole => format!("{:.1} %", part as f64 * 100.0 / whole as f64),
    }
}
