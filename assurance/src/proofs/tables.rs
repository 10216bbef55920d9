//! The short page and its tables, from the locks and the text: what each claim is worth, which rules have a proof, and
//! what falls with what is trusted.

use std::collections::{BTreeMap, BTreeSet};
use std::slice;

use ncp_text::catalogue::Catalogue;

use super::held::{LISTED, MISSED};
use super::{Locks, MADE_BY};
use crate::document::{Block, heading, table, text};
use crate::lock::{Asked, Lock, Scope};

/// The chapters whose rules decide whether a plant moves.
const CHAPTERS: [&str; 3] = ["07-safety.md", "08-resilience.md", "10-control-loop.md"];
/// How an engine's claims are quantified, and the harness that says them. Engines of one harness share its mistakes.
const ENGINES: [(&str, &str, &str); 8] = [
    ("symbolic", "source", "every double and seq, on every path of the source"),
    ("enumeration", "source", "listed values"),
    ("kani-stand-in", "source", "edges and samples"),
    ("kani", "source", "every double and seq, within the unwinding"),
    ("machine", "machine", "every bit pattern of the arguments, on every path of the machine code"),
    ("model", "model", "every state that its finite world reaches"),
    ("readers", "readers", "every input within the bounds"),
    ("theorem", "theorem", "all that the statement quantifies over, by proof and not by cases"),
];

const REPEAT: &str = "With stock tools, from the root of a fresh clone, a claim of each engine, in ten minutes and \
    what compiling takes. Each answer of a solver has to be `unsat`; `coqchk` has to name the axioms of the theorem \
    and no others; the programs end with 0.";

/// The commands of a reader who believes no command of this project.
const STOCK: [&str; 16] = [
    "# symbolic: one file of questions about the source, to two solvers",
    "python3 -m venv venv && venv/bin/pip install bitwuzla==0.9.1 z3-solver==5.4.0.0",
    "venv/bin/python proofs/evidence/solve.py proofs/evidence/watchdog/deadline/001.smt2",
    "venv/bin/z3 proofs/evidence/watchdog/deadline/001.smt2",
    "# machine: questions about the machine code, as they are made from the library that the compiler built",
    "python3 -m venv machine && machine/bin/pip install angr==9.2.213 bitstring==4.4.0 pycparser==3.0 bitwuzla==0.9.1",
    "NCP_MACHINE_PYTHON=machine/bin/python proofs/machine/prove.sh --only within-deadline --no-broken --evidence asked",
    "venv/bin/z3 asked/machine-within-deadline-paths-from-0.smt2",
    "# theorem: the files, and once more by the small checker of Coq alone",
    "bash proofs/theorem/check.sh",
    "(cd target/theorem && coqchk -silent -o -Q . NCP NCP.Theorems)",
    "# enumeration and samples, the model, the readers, the safety path: the compiler runs them",
    "cargo test -p ncp-proofs",
    "cargo run --release -p ncp-model -- --small",
    "cargo test -p ncp-readers",
    "cargo run --release -p ncp-path -- --only link/traces",
];

/// The short page.
pub(super) fn page(locks: &Locks, catalogue: &Catalogue) -> Vec<Block> {
    let mut page = vec![heading(1, "Proofs"), text(ABOUT)];
    let open = open(locks);
    if !open.is_empty() {
        page.push(heading(2, "Not shown"));
        page.push(Block::List(open));
    }
    page.extend(subject(locks, catalogue));
    page.push(heading(2, "What is not proved"));
    let provers = locks.values().flat_map(|lock| &lock.engines);
    let all = provers.flat_map(|(name, prover)| prover.not_proved.iter().map(move |what| format!("{name}: {what}")));
    page.push(Block::List(all.collect()));
    page
}

/// What both forms of the report begin with: claims, rules, what is trusted, the theorem, engines, circumstances.
pub(super) fn subject(locks: &Locks, catalogue: &Catalogue) -> Vec<Block> {
    let all = Claims::of(locks);
    let mut page = vec![heading(2, "Claims"), text(CLAIMS)];
    page.push(all.table());
    page.push(text("The harnesses that prove a claim of a family, each by at least one claim:"));
    page.push(all.families());
    page.push(heading(2, "Rules"));
    page.extend(all.rules(catalogue));
    page.push(heading(2, "Trusted"));
    page.push(text(TRUSTED));
    page.push(all.trusted(catalogue));
    page.push(heading(2, "The theorem"));
    page.extend(theorem(&all));
    page.push(heading(2, "Engines"));
    page.push(engines(locks));
    page.push(text(REPEAT));
    page.push(Block::Code(STOCK.join("\n")));
    page.push(heading(2, "Made with"));
    page.push(made_with(locks));
    page
}

const ABOUT: &str = "\
What is claimed of the code that decides whether a plant moves, and of the code that reads untrusted bytes, and what \
each claim is worth. Rendered from `reports/lock/proofs-*.toml` and the text alone; `cargo assure status` renders it \
again and compares, and holds the locks against the tables of claims and defects. `cargo assure prove` makes the \
locks, and with `--report` the long report: each claim in words and symbols, each counterexample, the commit.";
const CLAIMS: &str = "\
**Proved** is said of what holds for everything that the second column names, within the third. What was **only \
tried** holds on the listed values or on samples, and is no proof. Engines of one harness share its mistakes, so the \
column **harnesses** counts harnesses and not engines. **Without arithmetic**: how many of the questions to a solver \
have the same answer when every operation and comparison of doubles may be any function; such a question is about the \
order of decisions, and no evidence about numbers. A dash: nobody counted. Beside what is assumed, what is \
[trusted](#trusted) is.";
const TRUSTED: &str = "\
What has to be right for a claim to mean something, and the claims that have no other ground: they fall with it. The \
last column has how many rules of chapters 7, 8 and 10 then are without any proof that they have now.";

/// What is trusted, and by which engines.
const COMPONENTS: [(&str, &[&str]); 14] = [
    ("the harness `proofs/src/properties`: that its formulas say what the sentences say", &["symbolic"]),
    ("the harness `proofs/machine/properties.py`", &["machine"]),
    ("the worlds and claims of `proofs/model`", &["model"]),
    ("the automata of `proofs/readers`, and its classes of characters", &["readers"]),
    ("the statements in `proofs/theorem/coq`, and the words beside them", &["theorem"]),
    (
        "rustc, LLVM and the processor, for the code that runs while it is proved",
        &["symbolic", "model", "readers", "theorem"],
    ),
    ("the terms: that they mean what `f64` does, that both ways of every comparison are followed", &["symbolic"]),
    ("the writer of SMT-LIB and the reader of the answers", &["symbolic"]),
    ("bitwuzla: that its `unsat` is right; it leaves no certificate", &["symbolic", "machine"]),
    ("angr, and its lifter of x86-64: for one build by one compiler", &["machine"]),
    ("stateright, and that no two states share a fingerprint", &["model"]),
    ("Coq, Flocq, and the axioms that the theorem names", &["theorem"]),
    ("that `f64` and `i64` are the `Scalar` and `Seq` of production (`scalar.rs`)", &["symbolic", "theorem"]),
    (
        "what calls the kernel: that `ActionBuffer` and `SafetyGovernor` do what it says",
        &["symbolic", "machine", "theorem"],
    ),
];

/// A claim, with the word of each engine.
#[derive(Default)]
struct Claim<'l> {
    scope: Option<&'l Scope>,
    rules: &'l [String],
    words: BTreeMap<&'l str, (&'l str, Asked)>,
}

impl Claim<'_> {
    fn proving(&self) -> BTreeSet<&str> {
        self.words.iter().filter(|(_, (fate, _))| *fate == "proved").map(|(engine, _)| *engine).collect()
    }

    fn harnesses(&self) -> BTreeSet<&str> {
        self.proving().into_iter().map(harness).collect()
    }
}

fn engine(name: &str) -> Option<&'static (&'static str, &'static str, &'static str)> {
    ENGINES.iter().find(|(engine, ..)| *engine == name)
}

/// The harness of an engine; one that is not listed has its own.
fn harness(name: &str) -> &str {
    engine(name).map_or(name, |(_, harness, _)| harness)
}

/// All claims by their ids.
struct Claims<'l>(BTreeMap<&'l str, Claim<'l>>);

impl<'l> Claims<'l> {
    fn of(locks: &'l Locks) -> Self {
        let mut all: BTreeMap<&str, Claim<'_>> = BTreeMap::new();
        for Lock { fates, rules, claims, asked, .. } in locks.values() {
            for (id, fate) in fates {
                let Some((engine, claim)) = id.split_once(' ').filter(|(_, of)| !of.starts_with("defect ")) else {
                    continue;
                };
                let known = all.entry(claim).or_default();
                known.scope = known.scope.or(claims.get(claim));
                known.rules = rules.get(claim).map_or(known.rules, Vec::as_slice);
                known.words.insert(engine, (fate, asked.get(id).copied().unwrap_or_default()));
            }
        }
        Self(all)
    }

    /// What each claim is worth.
    fn table(&self) -> Block {
        let head = [
            "claim",
            "for",
            "bounded in",
            "proved",
            "harnesses",
            "only tried",
            "questions to a solver",
            "without arithmetic",
            "assumed",
        ];
        let rows = self.0.iter().map(|(id, claim)| {
            let proving = claim.proving();
            let quantified = |name: &&str| engine(name).map_or("what its bounds name", |(_, _, what)| what);
            let is = |end: &str| claim.words.values().any(|(fate, _)| *fate == end);
            let over: Vec<&str> = if proving.is_empty() {
                let tried = [(is(LISTED), "listed values"), (is("tried"), "edges and samples")];
                tried.into_iter().filter_map(|(is, what)| is.then_some(what)).collect()
            } else {
                proving.iter().map(quantified).collect()
            };
            let questions: Vec<u64> = claim.words.values().filter_map(|(_, asked)| asked.questions).collect();
            let without: Vec<u64> = claim.words.values().filter_map(|(_, asked)| asked.without_arithmetic).collect();
            let scope = claim.scope.cloned().unwrap_or_default();
            let harnesses = claim.harnesses();
            let count = match harnesses.len() {
                0 => "none".to_owned(),
                count => format!("{count}: {}", harnesses.into_iter().collect::<Vec<_>>().join(", ")),
            };
            let sum = |numbers: &[u64]| match numbers {
                [] => "–".to_owned(),
                numbers => numbers.iter().sum::<u64>().to_string(),
            };
            let is_asked = questions.iter().any(|count| *count > 0);
            vec![
                (*id).to_owned(),
                over.join("; "),
                dash(&scope.bounds),
                proved(claim),
                count,
                dash(&tried(claim)),
                if is_asked { sum(&questions) } else { "none".to_owned() },
                if is_asked { sum(&without) } else { "–".to_owned() },
                dash(&scope.assumptions.join("; ")),
            ]
        });
        table(&head, rows)
    }

    /// By how many harnesses the claims of each family are proved.
    fn families(&self) -> Block {
        let mut families: BTreeMap<&str, (usize, usize, BTreeSet<&str>)> = BTreeMap::new();
        for claim in self.0.values() {
            let family = claim.scope.map_or("", |scope| &scope.family);
            let (all, proved, harnesses) = families.entry(family).or_default();
            *all += 1;
            *proved += usize::from(!claim.proving().is_empty());
            harnesses.extend(claim.harnesses());
        }
        let rows = families.into_iter().map(|(family, (all, proved, harnesses))| {
            let names = harnesses.iter().copied().collect::<Vec<_>>().join(", ");
            vec![family.to_owned(), format!("{proved} of {all}"), format!("{}: {names}", harnesses.len())]
        });
        table(&["family", "claims with a proof", "harnesses"], rows)
    }

    /// Every rule of the chapters, and what proves it.
    fn rules(&self, catalogue: &Catalogue) -> Vec<Block> {
        let (mut bare, mut count) = (0, 0);
        let rules = catalogue.iter().filter(|rule| CHAPTERS.contains(&rule.file));
        let rows: Vec<Vec<String>> = rules
            .map(|rule| {
                count += 1;
                let own = self.0.iter().filter(|(_, claim)| claim.rules.contains(&rule.id));
                let names = |is_proved: bool| {
                    let own = own.clone().filter(|(_, claim)| claim.proving().is_empty() != is_proved);
                    own.map(|(id, _)| format!("`{id}`")).collect::<Vec<_>>().join(", ")
                };
                let harnesses: BTreeSet<&str> = own.clone().flat_map(|(_, claim)| claim.harnesses()).collect();
                bare += usize::from(harnesses.is_empty());
                let proved = if harnesses.is_empty() { "no proof".to_owned() } else { names(true) };
                let harnesses =
                    format!("{}: {}", harnesses.len(), harnesses.into_iter().collect::<Vec<_>>().join(", "));
                vec![rule.id.clone(), proved, harnesses.trim_end_matches(": ").to_owned(), dash(&names(false))]
            })
            .collect();
        let about = format!(
            "Every rule of chapters 7 (safety), 8 (resilience) and 10 (control loop), {count} in all, with the claims \
             that cite it. {bare} have no proof: what shows them is a vector or a test, and stands in \
             `reports/traceability.md`. A claim shows of a rule what its statement says within its bounds, which may \
             be less than the rule."
        );
        vec![text(about), table(&["rule", "proved by", "harnesses", "only tried by"], rows)]
    }

    /// What is trusted, and what falls with it.
    fn trusted(&self, catalogue: &Catalogue) -> Block {
        let rules: BTreeSet<&str> =
            catalogue.iter().filter(|rule| CHAPTERS.contains(&rule.file)).map(|rule| rule.id.as_str()).collect();
        let proved = |without: &[&str]| -> BTreeSet<&str> {
            let stands = |claim: &&Claim<'_>| claim.proving().iter().any(|engine| !without.contains(engine));
            let cited = self.0.values().filter(stands).flat_map(|claim| claim.rules).map(String::as_str);
            cited.filter(|rule| rules.contains(rule)).collect()
        };
        let all = proved(&[]);
        let rows = COMPONENTS.iter().map(|(what, engines)| {
            let falls = self.0.iter().filter(|(_, claim)| {
                let proving = claim.proving();
                !proving.is_empty() && proving.iter().all(|engine| engines.contains(engine))
            });
            let falls: Vec<String> = falls.map(|(id, _)| format!("`{id}`")).collect();
            let bare = all.len() - proved(engines).len();
            vec![
                (*what).to_owned(),
                engines.join(", "),
                format!("{}: {}", falls.len(), falls.join(", ")),
                bare.to_string(),
            ]
        });
        table(&["trusted", "by", "claims that fall with it", "rules left without a proof"], rows)
    }
}

/// By whom a claim is proved; what is wrong is what is read first.
fn proved(claim: &Claim<'_>) -> String {
    let is_open = |fate: &str| ![LISTED, "proved", "tried"].contains(&fate);
    let open = claim.words.iter().filter(|(_, (fate, _))| is_open(fate));
    let open: Vec<String> = open.map(|(engine, (fate, _))| format!("NOT proved by {engine}: {fate}; ")).collect();
    let proving: Vec<&str> = claim.proving().into_iter().collect();
    let by = if proving.is_empty() { "no proof".to_owned() } else { format!("proved by {}", proving.join(", ")) };
    open.concat() + &by
}

/// Who tried it on values, without a proof.
fn tried(claim: &Claim<'_>) -> String {
    let word = |(engine, (fate, asked)): (&&str, &(&str, Asked))| match *fate {
        LISTED => Some(format!("{LISTED} ({engine}: {} runs)", asked.cases)),
        "tried" => Some(format!("on samples ({engine})")),
        _ => None,
    };
    claim.words.iter().filter_map(word).collect::<Vec<_>>().join("; ")
}

fn dash(words: &str) -> String {
    if words.is_empty() { "–".to_owned() } else { words.to_owned() }
}

/// What keeps all from being shown.
pub(super) fn open(locks: &Locks) -> Vec<String> {
    unshown(locks, &Claims::of(locks))
}

fn unshown(locks: &Locks, all: &Claims<'_>) -> Vec<String> {
    let mut open: Vec<String> = locks.values().flat_map(|lock| lock.problems.clone()).collect();
    let bare = MADE_BY.iter().filter(|(name, _)| locks.get(*name).is_none_or(|lock| lock.fates.is_empty()));
    open.extend(bare.map(|(name, engines)| format!("{name}: nothing is kept of {}", engines.join(", "))));
    let unproved = all.0.iter().filter(|(_, claim)| claim.proving().is_empty());
    open.extend(unproved.map(|(id, _)| format!("`{id}` is proved by no engine")));
    open
}

/// What Coq says that the theorems rest on.
fn theorem(all: &Claims<'_>) -> Vec<Block> {
    let own = all.0.iter().filter(|(_, claim)| claim.words.contains_key("theorem"));
    let rows = own.filter_map(|(id, claim)| {
        let scope = claim.scope?;
        let names: Vec<&str> = scope.assumptions.iter().filter_map(|it| Some(it.split_once(':')?.0)).collect();
        Some(vec![(*id).to_owned(), proved(claim), scope.rests_on.clone(), dash(&names.join(", "))])
    });
    vec![
        text(
            "From the command to the plant, over doubles and for a horizon of any length: \
             [`proofs/theorem`](../proofs/theorem/README.md). `cargo assure prove --engine theorem` repeats it from a \
             fresh clone; Coq comes from Debian. The generic source of the kernel is run on terms, both ways of every \
             comparison, and Coq proves each tree that comes out equal to the model's: so a change of the source \
             breaks the check. The hypotheses stand as Coq prints them, and a claim that names fewer is not proved.",
        ),
        table(&["claim", "proved", "Coq says", "hypotheses"], rows),
    ]
}

fn engines(locks: &Locks) -> Block {
    let rows = locks.values().flat_map(|lock| {
        lock.engines.iter().map(move |(name, prover)| {
            let mine = |is_defect: bool, end: &[&str]| {
                let of = |id: &String| {
                    let rest = id.strip_prefix(name.as_str()).and_then(|rest| rest.strip_prefix(' '));
                    rest.is_some_and(|rest| rest.starts_with("defect ") == is_defect)
                };
                let ends =
                    lock.fates.iter().filter(|(id, fate)| of(id) && (end.is_empty() || end.contains(&fate.as_str())));
                ends.count()
            };
            let claims = mine(false, &[]);
            let of_kinds = [("proved", "proved"), (LISTED, LISTED), ("tried", "tried on samples")];
            let of_kinds = of_kinds.map(|(end, words)| (mine(false, slice::from_ref(&end)), words));
            let shown = of_kinds.iter().filter(|(count, _)| *count > 0);
            let shown: Vec<String> = shown.map(|(count, words)| format!("{words}: {count} of {claims}")).collect();
            let shown = shown.join("; ");
            let (refuted, missed) = (mine(true, &["refuted"]), mine(true, &[MISSED]));
            let defects = if refuted + missed == 0 {
                "–".to_owned()
            } else {
                format!("refuted {refuted} of {}", refuted + missed)
            };
            let repeat = format!("`cargo assure prove --engine {name}`");
            vec![
                name.clone(),
                harness(name).to_owned(),
                prover.version.clone(),
                prover.about.clone(),
                shown,
                defects,
                repeat,
            ]
        })
    });
    table(&["engine", "harness", "version", "what it does", "claims", "defects", "repeat"], rows)
}

/// Compiler, target, pins and digests, by artefact.
fn made_with(locks: &Locks) -> Block {
    let rows = locks.iter().map(|(name, lock)| {
        let of = |key: &str| lock.sources.get(key).cloned().unwrap_or_default();
        let packages = lock.sources.iter().find(|(key, _)| key.starts_with("Cargo.lock of "));
        let packages = packages.map_or("", |(_, digest)| digest);
        let library = lock.engines.values().find_map(|prover| prover.library_sha256.clone()).unwrap_or_default();
        let cells = [of("rustc"), of("pins"), of("Cargo.toml [profile.release]"), packages.to_owned(), library];
        [vec![name.clone()], cells.iter().map(|cell| dash(cell)).collect()].concat()
    });
    let head = [
        "artefact",
        "rustc and target",
        "pinned tools",
        "profiles",
        "packages",
        "what is loaded of the explored library (SHA-256)",
    ];
    table(&head, rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{html, markdown};
    use crate::lock::Prover;

    fn locks() -> Locks {
        let fates = [
            ("symbolic clamp/bound", "proved"),
            ("enumeration clamp/bound", LISTED),
            ("enumeration number/operations", LISTED),
            ("symbolic defect clamp/a by clamp/bound", "refuted"),
        ];
        let scope = |family: &str, bounds: &str| Scope {
            family: family.to_owned(),
            bounds: bounds.to_owned(),
            ..Scope::default()
        };
        let kernel = Lock {
            fates: fates.map(|(id, fate)| (id.to_owned(), fate.to_owned())).into(),
            rules: [("clamp/bound".to_owned(), vec!["NCP-SAFE-060".to_owned()])].into(),
            claims: [
                ("clamp/bound".to_owned(), scope("clamp", "vectors of up to 4")),
                ("number/operations".to_owned(), scope("number", "24 doubles")),
            ]
            .into(),
            asked: [
                (
                    "symbolic clamp/bound".to_owned(),
                    Asked { cases: 9, questions: Some(5), without_arithmetic: Some(2) },
                ),
                ("enumeration number/operations".to_owned(), Asked { cases: 24, ..Asked::default() }),
            ]
            .into(),
            engines: [("symbolic".to_owned(), Prover { version: "1".to_owned(), ..Prover::default() })].into(),
            ..Lock::default()
        };
        let machine = Lock {
            fates: [("machine machine/clamp".to_owned(), "proved".to_owned())].into(),
            rules: [("machine/clamp".to_owned(), vec!["NCP-SAFE-060".to_owned(), "NCP-SAFE-061".to_owned()])].into(),
            claims: [("machine/clamp".to_owned(), scope("clamp", "one vector"))].into(),
            ..Lock::default()
        };
        [("proofs-kernel".to_owned(), kernel), ("proofs-machine".to_owned(), machine)].into()
    }

    #[test]
    fn what_holds_on_listed_values_is_neither_called_proved_nor_coloured_like_it() {
        let (locks, catalogue) = (locks(), Catalogue::load().unwrap());
        let blocks = page(&locks, &catalogue);
        let row = markdown(&blocks).lines().find(|line| line.starts_with("| number/operations |")).unwrap().to_owned();
        assert!(row.contains("| number/operations | listed values | 24 doubles | no proof | none |"), "{row}");
        assert!(row.contains("| holds on the listed values (enumeration: 24 runs) | none | – |"), "{row}");
        assert!(!row.contains("proved by"), "{row}");
        let page = html(&blocks);
        assert!(page.contains("<td>holds on the listed values (enumeration: 24 runs)</td>"));
        assert!(page.contains("<td class=\"good\">proved by symbolic</td>"));
        assert!(markdown(&blocks).contains("- `number/operations` is proved by no engine"));
    }

    #[test]
    fn the_first_table_says_how_far_a_claim_goes_and_what_of_it_is_about_numbers() {
        let locks = locks();
        let row = markdown(&[Claims::of(&locks).table()])
            .lines()
            .find(|line| line.contains("| clamp/bound |"))
            .unwrap()
            .to_owned();
        assert!(row.contains("| every double and seq, on every path of the source | vectors of up to 4 |"), "{row}");
        assert!(row.ends_with("| 1: source | holds on the listed values (enumeration: 0 runs) | 5 | 2 | – |"), "{row}");
    }

    #[test]
    fn every_rule_of_the_three_chapters_has_a_row_and_says_by_how_many_harnesses_it_is_proved() {
        let (locks, catalogue) = (locks(), Catalogue::load().unwrap());
        let page = markdown(&Claims::of(&locks).rules(&catalogue));
        let rules = catalogue.iter().filter(|rule| CHAPTERS.contains(&rule.file));
        for rule in rules {
            assert_eq!(page.matches(&format!("| {} |", rule.id)).count(), 1, "{}", rule.id);
        }
        assert!(page.contains("| NCP-SAFE-060 | `clamp/bound`, `machine/clamp` | 2: machine, source | – |"), "{page}");
        assert!(page.contains("| NCP-SAFE-001 | no proof | 0 | – |"));
    }

    #[test]
    fn a_claim_falls_with_what_all_of_its_engines_trust() {
        let (locks, catalogue) = (locks(), Catalogue::load().unwrap());
        let page = markdown(&[Claims::of(&locks).trusted(&catalogue)]);
        let row = |what: &str| page.lines().find(|line| line.contains(what)).unwrap();
        assert!(row("bitwuzla").ends_with("| 2: `clamp/bound`, `machine/clamp` | 2 |"), "{page}");
        assert!(row("angr").ends_with("| 1: `machine/clamp` | 1 |"), "{page}");
        assert!(row("stateright").ends_with("| 0:  | 0 |"), "{page}");
    }

    #[test]
    fn an_artefact_of_which_nothing_is_kept_and_a_failure_are_named_first() {
        let mut locks = locks();
        locks.get_mut("proofs-kernel").unwrap().problems.push("symbolic: bad".to_owned());
        let page = markdown(&page(&locks, &Catalogue::load().unwrap()));
        assert!(page.contains("## Not shown\n\n- symbolic: bad\n- proofs-model: nothing is kept of model\n"), "{page}");
    }
}
