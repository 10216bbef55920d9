//! `cargo xtask prove --mutate`: changes one token of the kernel at a time, and asks whether a proof notices.
//!
//! - `tokens`: which changes there are.
//!
//! Each change becomes a copy of the kernel within `ncp-proofs`. The compiler says which copies are programs; these
//! are held against all properties, by the quick engines first, and by the symbolic one if none of these refutes
//! them. A change that nobody refutes has to be explained in `proofs/equivalent.toml`, or is a gap of the proofs.

mod tokens;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::{Value, json};

use crate::Error;
use crate::digest;
use tokens::{Change, changes, variants};
use xtask::project::Project;

const KERNEL: &str = "spec/kernel/src/decisions";
const PLACE: &str = ".tools/mutants";
const EXPLAINED: &str = "proofs/equivalent.toml";
const REPORT: &str = "reports/mutations";
/// What the report is about, and what it depends on.
const SOURCES: [&str; 6] = [
    KERNEL,
    "proofs/src/properties",
    "proofs/src/engines",
    "proofs/src/bin/mutants.rs",
    EXPLAINED,
    "xtask/src/mutate_kernel",
];
/// Imports, and types without decisions.
const LEFT_ALONE: [&str; 2] = ["mod.rs", "vocabulary.rs"];
/// The words and numbers of the kernel are shared: a copy speaks the same ones.
const SHARED: [&str; 2] = ["scalar", "vocabulary"];
/// More rounds of the compiler than its phases need.
const ROUNDS: usize = 20;

/// What is wanted.
struct Options {
    /// How many changes that compile.
    count: usize,
    seed: u64,
    /// Whether the symbolic engine is asked of explained changes, too.
    asks_all: bool,
}

/// A change of one token of the kernel.
#[derive(Debug, Clone)]
struct Mutant {
    id: String,
    file: String,
    line: usize,
    /// The line, without the blanks around it.
    text: String,
    /// Where in that, in characters, from 1 on.
    column: usize,
    change: Change,
}

/// Why a change that nobody refutes is none of behaviour.
struct Explained {
    file: String,
    text: String,
    column: usize,
    from: String,
    to: String,
    reason: String,
}

/// What became of a mutant.
enum Fate {
    Refuted(Value),
    Explained(String),
    Open(String),
}

/// Changes tokens and holds the changed kernels against the properties; `false` if a change is neither refuted nor
/// explained, or an explanation is about a change that there is not.
///
/// # Errors
/// A file, or a program that cannot be started.
pub(crate) fn run(project: &Project, args: &[&str]) -> Result<bool, Error> {
    let options = options(args)?;
    let sources = sources(project)?;
    let all = mutants(&sources);
    let explained = explained(project)?;
    let stale = stale(&explained, &all);
    for line in &stale {
        println!("STALE: {line}");
    }

    let place = project.path(PLACE);
    if place.exists() {
        fs::remove_dir_all(&place).map_err(|source| file_error(&place, source))?;
    }
    let mut order = all.clone();
    shuffle(&mut order, options.seed);
    println!("{} changes of one token; {} are wanted that compile", all.len(), options.count);
    let mut chosen = Vec::new();
    let mut rest = order.into_iter();
    while chosen.len() < options.count {
        let missing = options.count - chosen.len();
        let some: Vec<Mutant> = rest.by_ref().take(missing * 3 + 50).collect();
        if some.is_empty() {
            break;
        }
        for mutant in &some {
            write_copy(&place, &sources, mutant)?;
        }
        let good = that_compile(project, &place, some)?;
        println!("{} of them compile", good.len());
        chosen.extend(good);
    }
    chosen.truncate(options.count);
    chosen.sort_by_key(|mutant| (mutant.file.clone(), mutant.change.clone()));

    let mut fates: BTreeMap<String, Fate> = BTreeMap::new();
    write_table(&place, &chosen, "native_harness")?;
    for answer in hold(project, &place, &[])? {
        note(&mut fates, &answer);
    }
    let reason = |mutant: &Mutant| explained.iter().find(|entry| entry.is_of(mutant));
    let open: Vec<Mutant> = chosen
        .iter()
        .filter(|mutant| !matches!(fates.get(&mutant.id), Some(Fate::Refuted(_))))
        .filter(|mutant| options.asks_all || reason(mutant).is_none())
        .cloned()
        .collect();
    if !open.is_empty() {
        println!("{} are left for the symbolic engine", open.len());
        write_table(&place, &open, "harness")?;
        for answer in hold(project, &place, &["--symbolic"])? {
            note(&mut fates, &answer);
        }
    }
    let mut entries = Vec::new();
    for mutant in &chosen {
        let fate = match (fates.remove(&mutant.id), reason(mutant)) {
            (Some(Fate::Refuted(found)), _) => Fate::Refuted(found),
            (_, Some(entry)) => Fate::Explained(entry.reason.clone()),
            (Some(fate), None) => fate,
            (None, None) => Fate::Open("not held against anything".to_owned()),
        };
        if let (Fate::Refuted(_), Some(entry)) = (&fate, reason(mutant)) {
            println!("WRONG: {EXPLAINED} calls it equivalent: {}", entry.reason);
        }
        println!("{}", shown(mutant, &fate));
        entries.push((mutant.clone(), fate));
    }
    let wrong =
        entries.iter().filter(|(mutant, fate)| matches!(fate, Fate::Refuted(_)) && reason(mutant).is_some()).count();
    let is_good = write_report(project, &options, all.len(), &entries)?;
    Ok(is_good && stale.is_empty() && wrong == 0)
}

/// What is wrong with the report: missing, about other sources, or with a change that nothing refutes.
pub(crate) fn problems(project: &Project) -> Vec<String> {
    let problem = |why: &str| vec![format!("{REPORT}.json: {why}; cargo xtask prove --mutate 220")];
    let path = project.path(&format!("{REPORT}.json"));
    let text = fs::read_to_string(&path).ok();
    let report: Option<Value> = text.and_then(|text| serde_json::from_str(&text).ok());
    match (report, digest_of(project)) {
        (None, _) => problem("it is missing, or no report"),
        (_, Err(error)) => problem(&error.to_string()),
        (Some(report), Ok(now)) if report["digest"] != now.as_str() => {
            problem("the kernel, its properties or the changes are others now")
        }
        (Some(report), Ok(_)) if report["open"] != 0 => problem("a change is not refuted"),
        _ => Vec::new(),
    }
}

fn digest_of(project: &Project) -> Result<String, Error> {
    let root = project.path("");
    digest::of_sources(&root, &SOURCES).map_err(|source| file_error(&root, source))
}

fn options(args: &[&str]) -> Result<Options, Error> {
    let mut options = Options { count: 0, seed: 1, asks_all: false };
    let wrong = || Error::Usage { what: "prove --mutate takes a number, and --seed another".to_owned() };
    let mut args = args.iter();
    while let Some(arg) = args.next() {
        let mut number = || args.next().and_then(|word| word.parse().ok()).ok_or_else(wrong);
        match *arg {
            "--mutate" => options.count = usize::try_from(number()?).unwrap_or(usize::MAX),
            "--seed" => options.seed = number()?,
            "--ask-all" => options.asks_all = true,
            _ => return Err(wrong()),
        }
    }
    Ok(options)
}

fn file_error(path: &Path, source: std::io::Error) -> Error {
    Error::File { path: path.to_owned(), source }
}

/// The kernel's files, by their names.
fn sources(project: &Project) -> Result<BTreeMap<String, String>, Error> {
    let folder = project.path(KERNEL);
    let failed = |source| file_error(&folder, source);
    let mut sources = BTreeMap::new();
    for entry in fs::read_dir(&folder).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let text = fs::read_to_string(entry.path()).map_err(failed)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        sources.insert(name, text.replace("\r\n", "\n"));
    }
    Ok(sources)
}

fn mutants(sources: &BTreeMap<String, String>) -> Vec<Mutant> {
    let words = sources.get("vocabulary.rs").map_or("", String::as_str);
    let variants = variants(words);
    let mut mutants = Vec::new();
    for (file, text) in sources {
        if LEFT_ALONE.contains(&&**file) {
            continue;
        }
        for change in changes(text, &variants) {
            let before = text.get(..change.start).unwrap_or_default();
            let begin = before.rfind('\n').map_or(0, |at| at + 1);
            let whole = text.get(begin..).and_then(|rest| rest.lines().next());
            let whole = whole.unwrap_or_default();
            let blanks = whole.len() - whole.trim_start().len();
            let left = text.get(begin + blanks..change.start).unwrap_or_default();
            mutants.push(Mutant {
                id: format!("m_{:05}", mutants.len()),
                file: file.clone(),
                line: before.matches('\n').count() + 1,
                text: whole.trim().to_owned(),
                column: left.chars().count() + 1,
                change,
            });
        }
    }
    mutants
}

/// The same order for the same seed: Fisher and Yates, by SplitMix64.
fn shuffle(mutants: &mut [Mutant], seed: u64) {
    let mut state = seed;
    for last in (1..mutants.len()).rev() {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        let other = usize::try_from(z % (last as u64 + 1)).unwrap_or_default();
        mutants.swap(last, other);
    }
}

impl Mutant {
    fn place(&self) -> String {
        format!("{KERNEL}/{}:{}:{}", self.file, self.line, self.column)
    }
}

impl Explained {
    fn is_of(&self, mutant: &Mutant) -> bool {
        self.file == mutant.file
            && self.text == mutant.text
            && self.column == mutant.column
            && self.from == mutant.change.from
            && self.to == mutant.change.to
    }
}

/// The explained changes: an array of tables `change`, each with file, text, column, from, to and reason.
fn explained(project: &Project) -> Result<Vec<Explained>, Error> {
    let path = project.path(EXPLAINED);
    let text = fs::read_to_string(&path).map_err(|source| file_error(&path, source))?;
    let bad = |why: &str| Error::Usage { what: format!("{EXPLAINED}: {why}") };
    let table: toml::Table = text.parse().map_err(|_| bad("no TOML"))?;
    let changes = table.get("change").and_then(toml::Value::as_array);
    let changes = changes.ok_or_else(|| bad("no array of changes"))?;
    let entry = |change: &toml::Value| {
        let word = |name: &str| Some(change.get(name)?.as_str()?.to_owned());
        Some(Explained {
            file: word("file")?,
            text: word("text")?,
            column: usize::try_from(change.get("column")?.as_integer()?).ok()?,
            from: word("from")?,
            to: word("to")?,
            reason: word("reason").filter(|reason| !reason.is_empty())?,
        })
    };
    let entries =
        changes.iter().map(|change| entry(change).ok_or_else(|| bad(&format!("a change lacks a part: {change}"))));
    entries.collect()
}

/// Explanations of what is no change of the kernel as it is.
fn stale(explained: &[Explained], mutants: &[Mutant]) -> Vec<String> {
    let is_stale = |entry: &&Explained| !mutants.iter().any(|mutant| entry.is_of(mutant));
    let lines = explained.iter().filter(is_stale).map(|entry| {
        let Explained { file, text, from, to, .. } = entry;
        format!("{EXPLAINED}: {file} has no change of {from:?} to {to:?} in {text:?}")
    });
    lines.collect()
}

/// A copy of the kernel with the change, as a module of `ncp-proofs`.
fn write_copy(place: &Path, sources: &BTreeMap<String, String>, mutant: &Mutant) -> Result<(), Error> {
    let folder = place.join(&mutant.id);
    let write = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).map_err(|source| file_error(&path, source))
    };
    fs::create_dir_all(&folder).map_err(|source| file_error(&folder, source))?;
    for (name, text) in sources {
        let mut text = text.clone();
        if *name == mutant.file {
            text = mutant.change.of(&text);
        }
        text = text.replace("crate::wire::", "ncp_spec::wire::");
        if name == "mod.rs" {
            for shared in SHARED {
                text = text.replace(&format!("mod {shared};\n"), "");
                let here = format!("pub use {shared}::");
                text = text.replace(&here, "pub use ncp_spec::safety::kernel::");
            }
        }
        write(name, &text)?;
    }
    let (numbers, module) = if mutant.file == "scalar.rs" {
        let path = folder.join("scalar.rs");
        ("self::numbers_changed", format!("#[path = {path:?}]\nmod numbers_changed;\n"))
    } else {
        ("ncp_spec::safety::kernel", String::new())
    };
    let path = folder.join("mod.rs");
    write(
        "glue.rs",
        &format!(
            "use ncp_spec::safety::kernel::{{Channel, Decision, Limit, Plan, Reason, Received, Scalar, Seq}};\n\
             use ncp_spec::wire::Mode;\n#[path = {path:?}]\nmod changed;\n{module}\
             crate::kernel::kernel! {{ /// A changed kernel.\nMutant = [self::changed] [{numbers}] }}\n"
        ),
    )
}

/// The table of the copies that `ncp-proofs` includes.
fn write_table(place: &Path, mutants: &[Mutant], harness: &str) -> Result<(), Error> {
    let (mut modules, mut ids, mut arms) = (String::new(), String::new(), String::new());
    for mutant in mutants {
        let Mutant { id, file, .. } = mutant;
        let path = place.join(id).join("glue.rs");
        let _ = writeln!(modules, "#[path = {path:?}]\npub mod {id};");
        let _ = writeln!(ids, "({id:?}, {file:?}),");
        let _ = writeln!(arms, "{id:?} => crate::properties::{harness}::<{id}::Mutant>(property),");
    }
    let text = format!(
        "{modules}/// The changed kernels: the name of each, and the file that is changed.\n\
         pub const MUTANTS: &[(&str, &str)] = &[\n{ids}];\n\
         /// The harness of a property on a changed kernel.\n#[must_use]\n\
         pub fn harness(id: &str, property: &str) -> Option<crate::properties::Harness> {{\n\
         match id {{\n{arms}_ => None,\n}}\n}}\n"
    );
    let path = place.join("mutants.rs");
    fs::write(&path, text).map_err(|source| file_error(&path, source))
}

fn cargo(project: &Project, place: &Path, args: &[&str]) -> Command {
    let mut command = project.cargo(args);
    command.env("NCP_MUTANTS", place.join("mutants.rs"));
    command
}

/// Those of them that the compiler accepts. It stops at the errors of one phase, and is asked again without them.
fn that_compile(project: &Project, place: &Path, mut mutants: Vec<Mutant>) -> Result<Vec<Mutant>, Error> {
    const CHECK: [&str; 9] =
        ["check", "--quiet", "--profile", "changed", "-p", "ncp-proofs", "--lib", "--features", "mutants"];
    for _ in 0..ROUNDS {
        write_table(place, &mutants, "native_harness")?;
        let mut command = cargo(project, place, &[&CHECK[..], &["--message-format", "json"]].concat());
        let output = command.output().map_err(|source| file_error(Path::new("cargo"), source))?;
        if output.status.success() {
            return Ok(mutants);
        }
        let bad: BTreeSet<String> = String::from_utf8_lossy(&output.stdout)
            .lines()
            .filter(|line| line.contains("\"level\":\"error\""))
            .flat_map(named)
            .collect();
        let before = mutants.len();
        mutants.retain(|mutant| !bad.contains(&mutant.id));
        if mutants.len() == before {
            let errors = String::from_utf8_lossy(&output.stdout);
            let shown = errors.lines().find(|line| line.contains("\"level\":\"error\""));
            return Err(Error::Mutants(shown.unwrap_or_default().to_owned()));
        }
    }
    Err(Error::Mutants("the compiler finds errors without end".to_owned()))
}

/// The mutants in which an error of the compiler is, by their folders. Its notes may name all others, too: traits that
/// have a method of that name, say.
fn named(message: &str) -> Vec<String> {
    let message: Value = serde_json::from_str(message).unwrap_or_default();
    let spans = message["message"]["spans"].as_array();
    let mut ids = Vec::new();
    for span in spans.into_iter().flatten() {
        let mut place = span;
        while place.is_object() && span["is_primary"] == true {
            ids.extend(folder(&place["file_name"]));
            place = &place["expansion"]["span"];
        }
    }
    ids
}

fn folder(file: &Value) -> Option<String> {
    let parts = file.as_str()?.split(['/', '\\']);
    let is_id = |part: &&str| {
        let digits = part.strip_prefix("m_");
        digits.is_some_and(|digits| digits.len() == 5 && digits.bytes().all(|b| b.is_ascii_digit()))
    };
    parts.rev().find(is_id).map(str::to_owned)
}

/// Builds the mutants of the table, and holds each against all properties; the answers, one each.
fn hold(project: &Project, place: &Path, options: &[&str]) -> Result<Vec<Value>, Error> {
    const RUN: [&str; 11] = [
        "run",
        "--quiet",
        "--profile",
        "changed",
        "-p",
        "ncp-proofs",
        "--features",
        "mutants",
        "--bin",
        "ncp-mutants",
        "--",
    ];
    let mut command = cargo(project, place, &[&RUN[..], options].concat());
    let failed = |source| file_error(Path::new("ncp-mutants"), source);
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(failed)?;
    let mut answers = Vec::new();
    if let Some(output) = child.stdout.take() {
        for line in BufReader::new(output).lines() {
            let line = line.map_err(failed)?;
            if let Ok(answer) = serde_json::from_str::<Value>(&line) {
                println!("{} {}", word(&answer["id"]), word(&answer["said"]));
                answers.push(answer);
            }
        }
    }
    if child.wait().map_err(failed)?.success() {
        Ok(answers)
    } else {
        Err(Error::Mutants("ncp-mutants failed".to_owned()))
    }
}

fn note(fates: &mut BTreeMap<String, Fate>, answer: &Value) {
    let fate = if answer["counterexample"].is_object() {
        Fate::Refuted(answer.clone())
    } else {
        Fate::Open(word(&answer["said"]))
    };
    fates.insert(word(&answer["id"]), fate);
}

fn word(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

/// The inputs of a counterexample, in one line.
fn inputs(found: &Value) -> String {
    let pairs = found["inputs"].as_array().into_iter().flatten();
    let pairs = pairs.map(|pair| {
        let value = pair[1].as_str().map_or_else(|| pair[1].to_string(), str::to_owned);
        format!("{} = {value}", word(&pair[0]))
    });
    pairs.collect::<Vec<_>>().join(", ")
}

fn shown(mutant: &Mutant, fate: &Fate) -> String {
    let Change { from, to, .. } = &mutant.change;
    let head = format!("{}: `{from}` → `{to}`", mutant.place());
    match fate {
        Fate::Refuted(answer) => {
            let found = &answer["counterexample"];
            let compared = match found["compared"].as_str() {
                Some(compared) => format!(" ({compared})"),
                None => String::new(),
            };
            let (property, engine) = (word(&answer["property"]), word(&answer["engine"]));
            let check = word(&found["check"]);
            format!("{head}: refuted by {property}, {engine}: {check}{compared}: {}", inputs(found))
        }
        Fate::Explained(reason) => format!("{head}: no change of behaviour: {reason}"),
        Fate::Open(why) => format!("{head}: NOT REFUTED ({why})\n    {}", mutant.text),
    }
}

/// Writes what became of the mutants; whether none is open.
fn write_report(project: &Project, options: &Options, all: usize, entries: &[(Mutant, Fate)]) -> Result<bool, Error> {
    let mut counts: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    for (mutant, fate) in entries {
        let of = counts.entry(&mutant.file).or_default();
        let nth = match fate {
            Fate::Refuted(_) => 0,
            Fate::Explained(_) => 1,
            Fate::Open(_) => 2,
        };
        if let Some(count) = of.get_mut(nth) {
            *count += 1;
        }
    }
    let mut total = [0; 3];
    for count in counts.values() {
        for (sum, count) in total.iter_mut().zip(count) {
            *sum += count;
        }
    }
    let mut text = format!(
        "# Changes of one token\n\n`cargo xtask prove --mutate {} --seed {}`: of {all} changes of one token of the kernel that the grammar of `xtask/src/mutate_kernel/tokens.rs` knows, {} that compile, held against every property. A refuted one has a concrete counterexample, which stands in the `.json` beside this. An equivalent one changes no behaviour; [why](../proofs/equivalent.toml) is said of each.\n\n| file | changes | refuted | equivalent | open |\n|---|---|---|---|---|\n",
        options.count,
        options.seed,
        entries.len()
    );
    let mut row = |name: &str, [refuted, equivalent, open]: [usize; 3]| {
        let sum = refuted + equivalent + open;
        let _ = writeln!(text, "| {name} | {sum} | {refuted} | {equivalent} | {open} |");
    };
    for (file, count) in &counts {
        row(file, *count);
    }
    row("all", total);
    let mut by: BTreeMap<(String, String), usize> = BTreeMap::new();
    for (_, fate) in entries {
        if let Fate::Refuted(answer) = fate {
            *by.entry((word(&answer["property"]), word(&answer["engine"]))).or_default() += 1;
        }
    }
    text += "\n| first refuted by | engine | changes |\n|---|---|---|\n";
    for ((property, engine), count) in by {
        let _ = writeln!(text, "| {property} | {engine} | {count} |");
    }
    for (mutant, fate) in entries {
        if matches!(fate, Fate::Open(_)) {
            let _ = write!(text, "\nOpen: {}\n", shown(mutant, fate));
        }
    }
    let list: Vec<Value> = entries
        .iter()
        .map(|(mutant, fate)| {
            let mut entry = json!({
                "file": mutant.file, "line": mutant.line, "column": mutant.column, "text": mutant.text,
                "from": mutant.change.from, "to": mutant.change.to,
            });
            match fate {
                Fate::Refuted(answer) => {
                    for name in ["property", "engine", "counterexample"] {
                        entry[name] = answer[name].clone();
                    }
                }
                Fate::Explained(reason) => entry["equivalent"] = json!(reason),
                Fate::Open(why) => entry["open"] = json!(why),
            }
            entry
        })
        .collect();
    let report = json!({
        "format": 1, "digest": digest_of(project)?, "count": options.count, "seed": options.seed, "changes": all,
        "refuted": total[0], "equivalent": total[1], "open": total[2], "mutants": list,
    });
    let write = |end: &str, text: &str| {
        let path: PathBuf = project.path(&format!("{REPORT}.{end}"));
        fs::write(&path, text).map_err(|source| file_error(&path, source))
    };
    write("md", &text)?;
    write("json", &format!("{report:#}\n"))?;
    println!(
        "{} changes: {} refuted, {} equivalent, {} NOT REFUTED; {REPORT}.md",
        entries.len(),
        total[0],
        total[1],
        total[2]
    );
    Ok(total[2] == 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_explanation_is_of_a_change_that_there_is() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let project = Project::at(root);
        let all = mutants(&sources(&project).unwrap());
        assert_eq!(stale(&explained(&project).unwrap(), &all), Vec::<String>::new());
    }

    #[test]
    fn a_seed_chooses_the_same_changes_again_and_another_one_others() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let all = mutants(&sources(&Project::at(root)).unwrap());
        assert!(all.len() > 1_000, "{}", all.len());
        let first = |seed| {
            let mut order = all.clone();
            shuffle(&mut order, seed);
            order.into_iter().take(20).map(|mutant| mutant.id).collect::<Vec<_>>()
        };
        assert_eq!(first(1), first(1));
        assert_ne!(first(1), first(2));
    }

    #[test]
    fn a_change_of_the_kernel_or_of_a_property_makes_the_report_stale() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for source in SOURCES.map(|source| root.join(source)) {
            if source.extension().is_none() {
                fs::create_dir_all(source).unwrap();
            } else {
                fs::create_dir_all(source.parent().unwrap()).unwrap();
                fs::write(source, "").unwrap();
            }
        }
        let project = Project::at(root);
        assert!(problems(&project)[0].contains("missing"));
        fs::create_dir_all(root.join("reports")).unwrap();
        let digest = digest_of(&project).unwrap();
        let report = |open: usize| {
            let text = json!({ "digest": digest, "open": open }).to_string();
            fs::write(root.join(REPORT).with_extension("json"), text).unwrap();
        };
        report(1);
        assert!(problems(&project)[0].contains("not refuted"));
        report(0);
        assert_eq!(problems(&project), Vec::<String>::new());
        fs::write(root.join("proofs/src/properties/clamp.rs"), "less").unwrap();
        assert!(problems(&project)[0].contains("others now"));
    }

    #[test]
    fn an_error_of_the_compiler_is_in_the_mutants_of_its_primary_place() {
        let span = |file: &str, is_primary: bool| {
            let file = format!("/x/.tools/mutants/{file}");
            json!({ "file_name": file, "is_primary": is_primary })
        };
        let mut expanded = span("kernel.rs", true);
        expanded["expansion"] = json!({ "span": span("m_00018/glue.rs", false) });
        let message = json!({ "message": {
            "spans": [span("m_00017/speed.rs", true), span("m_00016/speed.rs", false), expanded],
            "children": [{ "spans": [span("m_00015/speed.rs", true)] }],
        }});
        assert_eq!(named(&message.to_string()), ["m_00017", "m_00018"]);
    }
}
