//! `cargo assure deep`: chooses the deep set from what the generators of the search draw.
//!
//! The generators draw candidates by a seed, so many a call, beside those that the set has already. Peers with the
//! planted defects that hide, and with those that one case of the corpus catches, are asked them; of those on which a
//! defect shows, two are taken for each. Around these goes a base that is chosen for what it reaches, and not for any
//! defect: pairs of features, sizes, classes of numbers and where they stand. What is expected comes from the
//! specification; the two implementations that are written from the text, and the models, have to agree, or a candidate
//! is not taken and is told.

mod kept;

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use ncp_defects::Defect;
use ncp_verifier::fuzz::deep::{Candidate, Deep, Made, Peer, Rules, file};
use ncp_verifier::peer::{Call, Connection, Launch, Manifest, handshake};
use ncp_verifier::run::{self, Deaf, Outcome, Settings};
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::{Case, Suite};
use sha2::{Digest as _, Sha256};
use xtask::project::Project;

use crate::Error;
use crate::console::{self, counted};
use crate::lock::Lock;
use crate::mutants::{MutantsError, command};

#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct DeepArgs {
    /// What everything that is drawn begins with
    #[arg(long, value_name = "N", default_value_t = 15)]
    seed: u64,
    /// Choose from the cases of this folder as well, besides those that are in the set; may be given again
    #[arg(long, value_name = "DIR")]
    from: Vec<PathBuf>,
    /// Leave the cases that are in the set, and choose from what is drawn
    #[arg(long)]
    afresh: bool,
    /// Keep the cases that are in the set, and only these: they take the wire version and the contract hash of the
    /// text, and expect what the specification answers now. A minute
    #[arg(long, conflicts_with_all = ["seed", "from", "afresh", "draws", "calls", "program"])]
    keep: bool,
    /// Draw so many hundredths of the usual number of candidates
    #[arg(long, value_name = "N", default_value_t = 100)]
    draws: u64,
    /// Choose anew for this call only, and leave the files of the others; may be given again
    #[arg(long = "call", value_name = "CALL", value_parser = call_of)]
    calls: Vec<Call>,
    /// The program that holds the defects of both tables, started with `--defect NAME`, instead of building it
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
    /// Where to write the files
    #[arg(long, value_name = "DIR", default_value = FOLDER)]
    out: PathBuf,
}

const HELP: &str = "\
Writes vectors/deep and its manifest, and says what no candidate shows and on which candidates the sources disagree.
What is in the set is a candidate, too, with what the specification expects now. Takes about half an hour.

Examples:
  cargo assure deep --seed 17
  cargo assure deep --seed 18 --afresh --out /tmp/deep
  cargo assure deep --draws 0 --from /tmp/deep
  cargo assure deep --keep";

impl DeepArgs {
    fn is_meant(&self, call: Call) -> bool {
        call != Call::Describe && (self.calls.is_empty() || self.calls.contains(&call))
    }
}

fn call_of(name: &str) -> Result<Call, String> {
    Call::ALL.iter().copied().find(|call| call.as_str() == name).ok_or_else(|| "no call of the protocol".to_owned())
}

/// Where the deep set is, from the root of the project.
const FOLDER: &str = "vectors/deep";
/// The table of the defects that hide.
const HARD: &str = "defects/deep";
/// Found by a dictionary only.
const DOORS: &str = "doors.toml";
/// Where candidates are judged.
const WORK: &str = ".tools/deep";
/// The second sources.
const SOURCES: [&str; 2] = ["peers/typescript", "peers/python-pure"];
/// What is added to a number that is taken.
const FURTHER: u64 = 1_000_000_000;
/// How many candidates of a call are drawn at a time.
const BATCH: u64 = 256;
/// How many candidates each defect is to fall by, how many are kept to choose from, and on how many it is tried.
const WANTED: usize = 2;
const ENOUGH: usize = 8;
/// How often something is to be reached in the base, and how many more are kept to choose from.
const SPARE: usize = 3;
/// How many bytes a request may have.
const LARGE: usize = 400_000;

/// A candidate that may be taken.
struct Kept {
    candidate: Candidate,
    /// The defects that show on it, by their place.
    shows: BTreeSet<usize>,
    made: Made,
}

type Pool = BTreeMap<(Call, u64), Kept>;

/// Chooses the deep set; `false` if a defect shows on no candidate, or sources disagree.
pub(crate) fn deep(project: &Project, args: &DeepArgs) -> Result<bool, Error> {
    let stop = console::stop().map_err(Error::Signals)?;
    if args.keep {
        return kept::keep(project, &args.out, &stop);
    }
    let suite = Suite::embedded()?;
    let root = project.path("");
    let hard = hard(&root)?;
    let usual = ncp_defects::read(&root.join(command::TABLES)).map_err(MutantsError::from)?;
    let all: Vec<Defect> = hard.iter().chain(&usual).cloned().collect();
    let program = match &args.program {
        Some(program) => std::path::absolute(program).unwrap_or_else(|_| program.clone()),
        None => command::build(project, &all, &stop)?,
    };
    let mut targets = few(&root, &usual)?;
    targets.extend(hard);

    let wanted: Vec<Call> = Call::ALL.iter().copied().filter(|call| args.is_meant(*call)).collect();
    targets.retain(|defect| calls(defect).iter().any(|call| wanted.contains(call)));
    let deep = Deep::new(&suite, args.seed)?;
    let there = there(&deep, args)?;
    let source = Source { deep: &deep, suite: &suite, there, draws: args.draws };
    let pool = draw(&source, &targets, &program, &wanted, &stop)?;
    let (pool, disputes) = agreed(project, &deep, pool, &stop)?;
    let chosen = fitting(choose(&pool, &targets), &pool);
    let folder = root.join(&args.out);
    write(&folder, &pool, &chosen, &wanted)?;
    if args.out == Path::new(FOLDER) {
        kept::note(&root)?;
    }

    let mut missing = 0;
    for (place, defect) in targets.iter().enumerate() {
        let shows = |key: &&(Call, u64)| pool.get(key).is_some_and(|kept| kept.shows.contains(&place));
        let count = chosen.iter().filter(shows).count();
        if count < WANTED {
            missing += 1;
            println!("{}: shows on {count} that are taken. {}", defect.name, defect.about);
        }
    }
    for dispute in &disputes {
        println!("{dispute}");
    }
    println!(
        "{} of {} candidates; {} show on fewer than two; {}",
        chosen.len(),
        pool.len(),
        counted(missing, "defect"),
        counted(disputes.len(), "dispute")
    );
    Ok(missing == 0 && disputes.is_empty())
}

/// The defects that hide, but for those that only a dictionary finds.
fn hard(root: &Path) -> Result<Vec<Defect>, Error> {
    let folder = root.join(HARD);
    let failed = |source| Error::File { path: folder.clone(), source };
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(&folder).map_err(failed)? {
        files.push(entry.map_err(failed)?.path());
    }
    files.sort();
    let is_table = |path: &PathBuf| path.extension().is_some_and(|e| e == "toml") && !path.ends_with(DOORS);
    let mut defects = Vec::new();
    for file in files.iter().filter(|path| is_table(path)) {
        defects.extend(ncp_defects::read(file).map_err(MutantsError::from)?);
    }
    Ok(defects)
}

/// The usual defects that one case of the corpus catches, by what was found last.
fn few(root: &Path, usual: &[Defect]) -> Result<Vec<Defect>, Error> {
    let lock = Lock::read(root, "mutants")?.unwrap_or_default();
    let by_one = |defect: &&Defect| lock.fates.get(&defect.name).is_none_or(|fate| fate.contains(", 1 failing"));
    Ok(usual.iter().filter(by_one).cloned().collect())
}

/// The calls on which a defect of these rules can show.
fn calls(defect: &Defect) -> &'static [Call] {
    let area = defect.rules.first().and_then(|rule| rule.split('-').nth(1)).unwrap_or_default();
    match area {
        "SAFE" => &[Call::GovernorRun, Call::LoopRun],
        "RES" => &[Call::BufferRun, Call::WatchdogRun, Call::LinkRun, Call::HorizonMaxLen, Call::Decode],
        "CTRL" => &[Call::LoopRun, Call::ReflexStep],
        "CODEC" => &[Call::CodecEncode, Call::CodecDecode],
        "SESS" => &[Call::SessionRun, Call::ReplyCheck],
        "KEY" => &[Call::KeyBuild, Call::KeyMatch, Call::Decode],
        "VER" => &[Call::VersionCheck, Call::ContractStatus, Call::ContractVerify, Call::Negotiate],
        "BULK" | "OBS" => &[Call::BulkDecode, Call::BulkEncode, Call::ObservationPack, Call::ObservationUnpack],
        "PLANE" => &[Call::PlaneQos, Call::LoopRun],
        "STRICT" => &[Call::Decode, Call::ReplyCheck, Call::BufferRun, Call::SessionRun, Call::KeyBuild],
        _ => &[Call::Decode, Call::Encode, Call::ReplyCheck, Call::BufferRun, Call::SessionRun],
    }
}

/// How many candidates of a call are drawn for the base, and how many at most for the defects that are open.
fn numbers(call: Call) -> (u64, u64) {
    match call {
        Call::GovernorRun => (3200, 12_000),
        Call::Decode => (5000, 40_000),
        Call::Encode => (2400, 8000),
        Call::BufferRun => (2400, 8000),
        Call::SessionRun => (2000, 6000),
        Call::KeyMatch | Call::CodecEncode | Call::CodecDecode => (3200, 20_000),
        Call::KeyBuild => (2000, 15_000),
        Call::BulkDecode => (1500, 8000),
        Call::BulkEncode => (1250, 4000),
        Call::ReplyCheck => (1600, 20_000),
        Call::VersionCheck | Call::HorizonMaxLen => (1600, 20_000),
        Call::WatchdogRun | Call::LinkRun | Call::LoopRun => (1800, 6000),
        _ => (1000, 2000),
    }
}

/// How many bytes and cases of a call the base has at most: what has a state takes the most room.
fn base(call: Call) -> (usize, usize) {
    match call {
        Call::GovernorRun => (2_600_000, 700),
        Call::BufferRun => (2_200_000, 600),
        Call::SessionRun => (2_200_000, 500),
        Call::LoopRun => (1_200_000, 300),
        Call::WatchdogRun | Call::LinkRun => (900_000, 300),
        Call::Decode => (1_400_000, 1200),
        Call::Encode | Call::ReplyCheck => (800_000, 600),
        Call::CodecEncode | Call::CodecDecode | Call::BulkDecode | Call::BulkEncode => (500_000, 250),
        Call::KeyBuild | Call::KeyMatch | Call::VersionCheck => (120_000, 300),
        _ => (200_000, 150),
    }
}

/// Where candidates come from.
struct Source<'s> {
    deep: &'s Deep<'s>,
    suite: &'s Suite,
    /// What is in the set, or in another.
    there: BTreeMap<Call, Vec<Candidate>>,
    /// Hundredths of the usual number of draws.
    draws: u64,
}

/// The cases that are there, as candidates: those of the set, unless they are to be left, and of other folders.
fn there(deep: &Deep<'_>, args: &DeepArgs) -> Result<BTreeMap<Call, Vec<Candidate>>, Error> {
    let mut there: BTreeMap<Call, Vec<Candidate>> = BTreeMap::new();
    let mut taken: BTreeSet<(Call, u64)> = BTreeSet::new();
    let mut add = |case: &Case| {
        if let Some(mut candidate) = deep.kept(case) {
            while !taken.insert((case.call, candidate.number)) {
                candidate.number += FURTHER;
            }
            there.entry(case.call).or_default().push(candidate);
        }
    };
    if !args.afresh {
        Suite::deep()?.cases().iter().for_each(&mut add);
    }
    for folder in &args.from {
        Suite::load(folder)?.cases().iter().for_each(&mut add);
    }
    Ok(there)
}

/// A candidate with the case that it makes, and the defects that show on it.
fn kept<'s>(deep: &Deep<'s>, rules: &mut Rules<'s>, candidate: Candidate, shows: BTreeSet<usize>) -> Option<Kept> {
    let second = ncp_vectors::second(candidate.call().as_str(), &candidate.arguments());
    let steps = second.as_ref().map(|second| second.rules.as_slice());
    let made = deep.case(rules, &candidate, steps)?;
    Some(Kept { candidate, shows, made })
}

/// Draws candidates of every call, asks them of the peers with the defects, and keeps those that show something new.
fn draw(source: &Source<'_>, targets: &[Defect], program: &Path, wanted: &[Call], stop: &Stop) -> Result<Pool, Error> {
    let (deep, draws) = (source.deep, source.draws);
    let launch = |name: &str| {
        Launch::new(vec![program.to_string_lossy().into_owned(), "--defect".to_owned(), name.to_owned()], ".")
    };
    let mut pool = Pool::new();
    let mut rules = Rules::new(source.suite);
    let mut found: Vec<usize> = vec![0; targets.len()];
    let launches: Vec<Launch> = targets.iter().map(|defect| launch(&defect.name)).collect();
    for call in wanted.iter().copied() {
        let start = Instant::now();
        let (base, most) = numbers(call);
        let (base, most) = (base * draws / 100, most * draws / 100);
        let mut peers: Vec<(usize, Peer<'_>)> = Vec::new();
        for (place, _) in targets.iter().enumerate().filter(|(_, defect)| calls(defect).contains(&call)) {
            if found[place] < ENOUGH {
                peers.push((place, Peer::new(&launches[place], stop)));
            }
        }
        let mut seen: HashMap<u64, usize> = HashMap::new();
        let batch = usize::try_from(BATCH).unwrap_or(1);
        let old = source.there.get(&call).map_or(&[][..], Vec::as_slice).chunks(batch).map(Batch::Kept);
        for batch in old.chain((0..most).step_by(batch).map(Batch::Drawn)) {
            // Whether it may be taken for what it reaches, and not for a defect alone.
            let is_of_base = matches!(batch, Batch::Kept(_)) || matches!(batch, Batch::Drawn(from) if from < base);
            if peers.is_empty() && !is_of_base {
                break;
            }
            if stop.is_set() {
                return Err(MutantsError::Interrupted.into());
            }
            let drawn: Vec<Candidate> = match batch {
                Batch::Kept(kept) => kept.to_vec(),
                Batch::Drawn(from) => {
                    (from..(from + BATCH).min(most)).filter_map(|number| deep.candidate(call, number, LARGE)).collect()
                }
            };
            let mut shows: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); drawn.len()];
            for (place, peer) in &mut peers {
                for nth in deep.differing(peer, &drawn)? {
                    shows[nth].insert(*place);
                    found[*place] += 1;
                }
            }
            peers.retain(|(place, _)| found[*place] < ENOUGH);
            for (candidate, shows) in drawn.into_iter().zip(shows) {
                let is_new = is_of_base && candidate.keys.iter().any(|key| seen.get(key).copied().unwrap_or(0) < SPARE);
                if shows.is_empty() && !(is_new && candidate.bytes <= LARGE / 8) {
                    continue;
                }
                let Some(kept) = kept(deep, &mut rules, candidate, shows) else { continue };
                for key in &kept.candidate.keys {
                    *seen.entry(*key).or_default() += 1;
                }
                pool.insert((call, kept.candidate.number), kept);
            }
        }
        let hidden = peers.iter().filter(|(place, _)| found[*place] == 0).count();
        println!(
            "{}: {} kept, {hidden} of its defects not seen, {:.0} s",
            call.as_str(),
            pool.keys().filter(|(of, _)| *of == call).count(),
            start.elapsed().as_secs_f64()
        );
    }
    Ok(pool)
}

/// Candidates that are asked together.
enum Batch<'k> {
    Kept(&'k [Candidate]),
    /// From which number on.
    Drawn(u64),
}

/// What the second sources agree on, and where they do not.
fn agreed(project: &Project, deep: &Deep<'_>, mut pool: Pool, stop: &Stop) -> Result<(Pool, Vec<String>), Error> {
    let root = project.path("");
    let work = project.path(WORK).join("candidates");
    // What may be taken at all is judged, and not what lies about.
    let all: Vec<(Call, u64)> = pool.keys().copied().collect();
    let _ = fs::remove_dir_all(&work);
    write(&work.join("deep"), &pool, &all, Call::ALL)?;
    let candidates = Suite::load(&work)?;
    let mut disputes: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for folder in SOURCES {
        let manifest = Manifest::load(&root.join(folder), &root, &root.join("target"))?;
        for step in &manifest.setup {
            step.run(stop).map_err(MutantsError::from)?;
        }
        let settings = Settings { max_restarts: None, ..Settings::default() };
        let mut connection = Connection::open(&manifest.launch).map_err(MutantsError::from)?;
        handshake(&mut connection, settings.start_timeout, stop).map_err(MutantsError::from)?;
        let cases: Vec<&Case> = candidates.cases().iter().collect();
        let start = Instant::now();
        let record = run::run(&manifest.launch, connection, &cases, &settings, &Deaf, stop);
        println!("{folder}: {} cases, {:.0} s", cases.len(), start.elapsed().as_secs_f64());
        for (case, run) in cases.iter().zip(record.cases) {
            if let Outcome::Pass | Outcome::Unsupported { .. } = run.outcome {
                continue;
            }
            let said = format!("{folder}: {}", in_short(&run.outcome));
            disputes.entry(case.id.clone()).or_default().push(said);
        }
    }
    for (key, kept) in &pool {
        let (call, args) = (key.0, kept.candidate.arguments());
        if let Some(second) = ncp_vectors::second(call.as_str(), &args)
            && let Some(pattern) = second.pattern
            && let Some(why) = deep.disagreement(&kept.candidate, &pattern)?
        {
            let id = kept.made.id().to_owned();
            disputes.entry(id).or_default().push(format!("the model: {why}"));
        }
    }
    pool.retain(|_, kept| !disputes.contains_key(kept.made.id()));
    let lines = disputes.into_iter().map(|(id, said)| format!("{id}: {}", said.join("; "))).collect();
    Ok((pool, lines))
}

fn in_short(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Fail(differences) => match differences.first.first() {
            Some(first) => {
                let of = |value: &Option<String>| {
                    value.as_deref().map_or("nothing", |v| v.get(..60).unwrap_or(v)).to_owned()
                };
                format!("at {} {} instead of {}", first.at, of(&first.got), of(&first.expected))
            }
            None => "differs".to_owned(),
        },
        other => format!("{:?}", other.kind()),
    }
}

/// The cases of the deep set.
fn choose(pool: &Pool, targets: &[Defect]) -> Vec<(Call, u64)> {
    let mut chosen: BTreeSet<(Call, u64)> = BTreeSet::new();
    let mut need: Vec<usize> = vec![WANTED; targets.len()];
    // Those on which most that are still open show, of the smallest first.
    loop {
        let worth = |kept: &Kept| kept.shows.iter().filter(|place| need.get(**place).is_some_and(|n| *n > 0)).count();
        let best =
            pool.iter().filter(|(key, kept)| !chosen.contains(*key) && worth(kept) > 0).max_by(|(_, a), (_, b)| {
                let of = |kept: &Kept| worth(kept) as f64 / (2000.0 + kept.candidate.bytes as f64);
                of(a).total_cmp(&of(b))
            });
        let Some((key, kept)) = best else { break };
        for place in &kept.shows {
            if let Some(need) = need.get_mut(*place) {
                *need = need.saturating_sub(1);
            }
        }
        chosen.insert(*key);
    }
    // Around these, what reaches most that is not reached yet.
    for call in Call::ALL.iter() {
        let mut seen: HashMap<u64, usize> = HashMap::new();
        let of_call: Vec<(&(Call, u64), &Kept)> = pool.iter().filter(|((of, _), _)| of == call).collect();
        for (_, kept) in of_call.iter().filter(|(key, _)| chosen.contains(*key)) {
            kept.candidate.keys.iter().for_each(|key| *seen.entry(*key).or_default() += 1);
        }
        let (mut bytes, mut cases) = (0, 0);
        let mut open: Vec<(f64, &(Call, u64), &Kept)> = of_call
            .into_iter()
            .filter(|(key, _)| !chosen.contains(*key))
            .map(|(key, kept)| (f64::INFINITY, key, kept))
            .collect();
        let worth = |kept: &Kept, seen: &HashMap<u64, usize>| {
            let new = |key: &&u64| !seen.contains_key(*key);
            kept.candidate.keys.iter().filter(new).count() as f64 / (600.0 + kept.candidate.bytes as f64)
        };
        let (most_bytes, most_cases) = base(*call);
        while bytes < most_bytes && cases < most_cases && !open.is_empty() {
            // What one is worth only falls: so it is reckoned anew only as long as it may be the best.
            open.sort_by(|a, b| b.0.total_cmp(&a.0));
            let mut best: Option<(f64, usize)> = None;
            for (place, (before, _, kept)) in open.iter_mut().enumerate() {
                if best.is_some_and(|(known, _)| *before <= known) {
                    break;
                }
                let now = worth(kept, &seen);
                *before = now;
                if best.is_none_or(|(known, _)| now > known) {
                    best = Some((now, place));
                }
            }
            let Some((now, place)) = best else { break };
            if now <= 0.0 {
                break;
            }
            let (_, key, kept) = open.swap_remove(place);
            kept.candidate.keys.iter().for_each(|key| *seen.entry(*key).or_default() += 1);
            bytes += kept.candidate.bytes;
            cases += 1;
            chosen.insert(*key);
        }
    }
    chosen.into_iter().collect()
}

/// Without the largest cases of a call that has more bytes than it may, so that the set stays below 20 MB.
fn fitting(mut chosen: Vec<(Call, u64)>, pool: &Pool) -> Vec<(Call, u64)> {
    for call in Call::ALL {
        let of = chosen.iter().filter(|(other, _)| other == call);
        let sizes = of.map(|key| (*key, pool.get(key).map_or(0, |kept| kept.candidate.bytes))).collect();
        let too_large = largest_beyond(sizes, most(*call));
        chosen.retain(|key| !too_large.contains(key));
    }
    chosen
}

/// The fewest of the largest without which the others have no more bytes than these.
fn largest_beyond<K: Ord>(mut sizes: Vec<(K, usize)>, most: usize) -> BTreeSet<K> {
    sizes.sort_by_key(|(_, bytes)| std::cmp::Reverse(*bytes));
    let mut total: usize = sizes.iter().map(|(_, bytes)| bytes).sum();
    let is_beyond = |(_, bytes): &(K, usize)| {
        let beyond = total > most;
        total -= bytes;
        beyond
    };
    sizes.into_iter().take_while(is_beyond).map(|(key, _)| key).collect()
}

/// How many bytes the cases of a call have at most.
fn most(call: Call) -> usize {
    match call {
        Call::GovernorRun => 3_300_000,
        Call::BufferRun => 2_200_000,
        Call::SessionRun => 1_600_000,
        Call::LoopRun | Call::Decode => 1_100_000,
        Call::LinkRun => 900_000,
        Call::WatchdogRun => 800_000,
        Call::Encode => 750_000,
        _ => usize::MAX,
    }
}

/// Writes the files of these, and their manifest.
fn write(folder: &Path, pool: &Pool, chosen: &[(Call, u64)], calls: &[Call]) -> Result<(), Error> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| Error::File { path, source }
    };
    fs::create_dir_all(folder).map_err(failed(folder))?;
    let mut digests: BTreeMap<String, String> = BTreeMap::new();
    for call in Call::ALL {
        let name = format!("{}.json", call.as_str().replace('.', "-"));
        let path = folder.join(&name);
        let text = if calls.contains(call) {
            let of = chosen.iter().filter(|(other, _)| other == call).filter_map(|key| pool.get(key));
            let cases: Vec<Made> = of.map(|kept| kept.made.clone()).collect();
            (!cases.is_empty()).then(|| file(*call, &cases))
        } else {
            path.is_file().then(|| fs::read_to_string(&path)).transpose().map_err(failed(&path))?
        };
        match text {
            Some(text) => {
                fs::write(&path, &text).map_err(failed(&path))?;
                let digest: String = Sha256::digest(&text).iter().map(|byte| format!("{byte:02x}")).collect();
                digests.insert(name, digest);
            }
            None if path.is_file() => fs::remove_file(&path).map_err(failed(&path))?,
            None => {}
        }
    }
    let manifest: String = digests.iter().map(|(name, digest)| format!("{digest}  deep/{name}\n")).collect();
    let path = folder.join("MANIFEST.sha256");
    fs::write(&path, manifest).map_err(failed(&path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_leave_and_no_more_of_them_than_it_takes() {
        let beyond = |most| largest_beyond(vec![('a', 3), ('b', 9), ('c', 5)], most).into_iter().collect::<String>();
        assert_eq!([17, 16, 8, 7, 3, 2].map(beyond), ["", "b", "b", "bc", "bc", "abc"]);
    }
}
