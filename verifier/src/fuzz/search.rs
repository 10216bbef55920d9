//! The search itself: rounds of inputs, those that reach something new kept, disagreements judged, shrunk, grouped.
//!
//! A round is drawn from what was kept before it, and its results are taken in the order of its inputs. So what is
//! found depends on the seed alone, and not on how many threads work or how fast.

use std::collections::{BTreeMap, HashSet};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use ncp_peer_rust::Answer;
use ncp_text::catalogue::{Level, Role};

use super::asker::{Asker, Fault, Patience, Said};
use super::court::{self, Court, CourtError, Question};
use super::coverage::{Coverage, Reached, reached};
use super::draw::Draw;
use super::generate::{self, Input, Menu, Seeds, body, mutate};
use super::harvest::Harvest;
use super::oracle::{self, Verdict, agree};
use super::rules::{Decided, Rules};
use super::shrink::shrink;
use super::sweep::Sweep;
use super::tree::{Tree, text};
use crate::check::{Differences, Judgement, Manner};
use crate::peer::{Call, Connection, Description, Launch, Reply, StartError, excerpt};
use crate::stop::Stop;
use crate::suite::{Pattern, Suite};

/// How many inputs a round has.
const ROUND: usize = 1024;
/// After so many rounds without an input the search ends.
const IDLE_ROUNDS: usize = 1000;
/// How many of them a worker takes at a time.
const CHUNK: usize = 32;
/// How many inputs of a call are kept.
const KEPT: usize = 400;
/// How many disagreements that look alike are shrunk; of more, each that doubles their number.
const SHRUNK_ALIKE: u64 = 4;
/// After so many faults a peer is given up.
const MOST_FAULTS: usize = 60;
/// How many bytes the arguments of an input have that is never drawn again for its size; of steps more, since each is
/// soon taken.
const CHEAP: usize = 16 << 10;
const CHEAP_STEPS: usize = 100 << 10;
/// How many bytes the arguments of an input may have.
const LARGEST: usize = 16 << 20;
/// How long what is found may still be shrunk when the time is over.
const GRACE: Duration = Duration::from_secs(10);
/// How much of an answer is shown.
const SHOWN: usize = 4000;

/// How long to go on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// So long.
    Time(Duration),
    /// So many inputs.
    Cases(u64),
}

/// By what a peer is searched.
#[derive(Debug, Clone)]
pub struct Settings {
    /// How long.
    pub extent: Extent,
    /// What everything that is drawn begins with.
    pub seed: u64,
    /// How many processes of the peer work side by side.
    pub jobs: usize,
    /// Only these calls, unless there is none.
    pub patterns: Vec<Pattern>,
    /// Up to which level.
    pub level: Level,
    /// As these roles.
    pub roles: Vec<Role>,
    /// How long the peer may be silent while a request is in flight.
    pub timeout: Duration,
    /// How long until the first answer of a process.
    pub start_timeout: Duration,
    /// How many bytes of memory a process of it may hold.
    pub memory: u64,
    /// How often an input is tried on the way to the smallest.
    pub tries: usize,
    /// What the peer's own sources hold.
    pub harvest: Harvest,
    /// How many steps every trace has; none: drawn for each.
    pub length: Option<usize>,
}

/// A disagreement, shrunk.
#[derive(Debug, Clone)]
pub struct Found {
    /// The smallest input that shows it.
    pub input: Input,
    /// What had to come, in the form of the vector files.
    pub expect: Tree,
    /// What the specification says.
    pub specification: String,
    /// What the peer says.
    pub answer: String,
    /// Where and how they differ.
    pub differences: Differences,
}

/// What was found, once for all inputs that show the same.
#[derive(Debug, Clone)]
pub struct Finding {
    /// In a word: `value`, `refusal`, `order`, `crash`, `hang`, `memory` or `protocol`.
    pub kind: &'static str,
    /// Where the answers differ, with a star for each number.
    pub place: String,
    /// The rule that decides it, if one is known.
    pub decided: Option<Decided>,
    /// The role as which it is asked.
    pub role: Role,
    /// The smallest input.
    pub found: Found,
    /// What was seen of a process that broke off.
    pub fault: Option<Fault>,
    /// How many inputs showed the like.
    pub times: u64,
    /// The number of the first of them.
    pub first: u64,
    /// What is left of that one.
    pub shrunk: Shrunk,
}

/// How far an input was shrunk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shrunk {
    /// How many steps it had.
    pub from: usize,
    /// How many are left.
    pub to: usize,
    /// Whether everything that is left was tried without, and is needed.
    pub is_smallest: bool,
}

/// What a search leaves.
#[derive(Debug)]
pub struct Tested {
    /// What the peer says about itself.
    pub description: Description,
    /// How many tries with what the dictionary holds were made, and how many there are.
    pub swept: (u64, u64),
    /// How many inputs were asked.
    pub inputs: u64,
    /// How many steps they had.
    pub steps: u64,
    /// How long it took.
    pub elapsed: Duration,
    /// How many disagreements the text lets be, by why it does.
    pub open: BTreeMap<&'static str, u64>,
    /// How many the judge lets be, since the answer is one of several.
    pub allowed: u64,
    /// How often a call was answered `unsupported`.
    pub unsupported: BTreeMap<&'static str, u64>,
    /// How many processes ended in a fault.
    pub faults: usize,
    /// Why the peer was given up, if it was.
    pub given_up: Option<String>,
    /// What was found, in the order of the first inputs.
    pub findings: Vec<Finding>,
    /// What was reached.
    pub coverage: Coverage,
    /// Whether there was no call to ask.
    pub nothing_asked: bool,
}

/// What ends a search.
#[derive(Debug, thiserror::Error)]
pub enum FuzzError {
    /// The peer does not start.
    #[error(transparent)]
    Start(#[from] StartError),
    /// A disagreement cannot be judged.
    #[error(transparent)]
    Court(#[from] CourtError),
}

/// Listens to a search.
pub trait Listener: Sync {
    /// So many inputs more were asked.
    fn asked(&self, inputs: u64);
    /// Something was found: the call, and the rule or the fault.
    fn found(&self, call: &str, what: &str);
}

/// An input that is to be asked.
#[derive(Debug)]
struct Task {
    number: u64,
    input: Input,
}

/// What became of it.
struct Done {
    number: u64,
    input: Option<Input>,
    call: Call,
    reached: Reached,
    parted: Option<Parted>,
}

/// What an answer is that is not surely the specification's.
enum Parted {
    /// The process broke off.
    Fault(Fault),
    /// It is no answer, but says that there is none.
    Unsupported,
    /// The text leaves it open, for this reason.
    Open(&'static str),
    /// It is one of several that are right.
    Allowed,
    /// It is wrong: the specification's answer, the line of the peer, and where they differ.
    Wrong(Answer, Vec<u8>, Differences),
}

/// Who asks and judges on one thread: a process of the peer, and a court.
struct Worker<'s> {
    asker: Asker<'s>,
    court: Court,
}

/// For each call, a rule and a role by which a question of it is a case at all.
type Charges = BTreeMap<Call, (String, Role)>;

/// What a disagreement looks like before it is shrunk: the call and its kind, how and where the answers differ.
type Look = (Call, String, &'static str, String);

/// Searches a peer whose first process has described itself.
///
/// # Errors
/// The peer can no longer be started, or what was found cannot be judged.
pub fn fuzz(
    launch: &Launch,
    first: Connection,
    description: Description,
    suite: &Suite,
    settings: &Settings,
    listener: &dyn Listener,
    stop: &Stop,
) -> Result<Tested, FuzzError> {
    let claimed = Role::ALL.into_iter().filter(|role| description.roles.iter().any(|name| name == role.as_str()));
    let roles: Vec<Role> = if settings.roles.is_empty() { claimed.collect() } else { settings.roles.clone() };
    let menu = super::menu(&roles, settings.level, description.reference_networks, &settings.patterns);
    let patience = Patience { silence: settings.timeout, start: settings.start_timeout, memory: settings.memory };
    let seeds = Seeds::of(suite, &menu);
    let sweep = Sweep::new(&seeds, &settings.harvest);
    let mut first = Some(first);
    let worker = |_| {
        let asker = Asker::new(launch, patience.clone(), stop, first.take());
        Court::open().map(|court| Worker { asker, court })
    };
    let workers = (0..settings.jobs.max(1)).map(worker).collect::<Result<_, CourtError>>()?;
    let rules = Rules::new(suite);
    let charge = |(call, _): &(Call, usize)| Some((*call, rules.any(*call, &roles, settings.level)?));
    let charges = menu.calls.iter().filter_map(charge).collect();
    let mut search = Search {
        settings,
        menu,
        seeds,
        sweep,
        roles,
        stop,
        listener,
        rules,
        charges,
        kept: BTreeMap::new(),
        looks: BTreeMap::new(),
        workers,
        numbers: 0,
        until: None,
        tested: Tested {
            description,
            swept: (0, 0),
            inputs: 0,
            steps: 0,
            elapsed: Duration::ZERO,
            open: BTreeMap::new(),
            allowed: 0,
            unsupported: BTreeMap::new(),
            faults: 0,
            given_up: None,
            findings: Vec::new(),
            coverage: Coverage::default(),
            nothing_asked: false,
        },
    };
    search.run()?;
    Ok(search.tested)
}

struct Search<'s> {
    settings: &'s Settings,
    menu: Menu,
    /// The cases of the corpus, to be varied.
    seeds: Seeds,
    /// What the dictionary gives to try.
    sweep: Sweep,
    roles: Vec<Role>,
    stop: &'s Stop,
    listener: &'s dyn Listener,
    rules: Rules<'s>,
    charges: Charges,
    /// Inputs whose answers reached something new, by call.
    kept: BTreeMap<Call, Vec<Input>>,
    /// For each look of a disagreement, how many had it, and which finding it is.
    looks: BTreeMap<Look, (u64, Option<usize>)>,
    workers: Vec<Worker<'s>>,
    /// How many numbers of inputs are given away.
    numbers: u64,
    /// When to shrink no more.
    until: Option<Instant>,
    tested: Tested,
}

impl Search<'_> {
    fn run(&mut self) -> Result<(), FuzzError> {
        let started = Instant::now();
        if self.menu.calls.is_empty() {
            self.tested.nothing_asked = true;
            return Ok(());
        }
        self.until = match self.settings.extent {
            Extent::Time(time) => Some(started + time + GRACE),
            Extent::Cases(_) => None,
        };
        let mut idle = 0;
        while !self.stop.is_set() && self.tested.given_up.is_none() {
            let left = match self.settings.extent {
                Extent::Time(time) if started.elapsed() >= time => break,
                Extent::Time(_) => ROUND,
                Extent::Cases(cases) => {
                    usize::try_from(cases - self.tested.inputs.min(cases)).unwrap_or(ROUND).min(ROUND)
                }
            };
            if left == 0 {
                break;
            }
            let until = match self.settings.extent {
                Extent::Time(time) => Some(started + time),
                Extent::Cases(_) => None,
            };
            let done = self.round(left, until)?;
            // Where nothing that is drawn may be asked, nothing will be.
            idle = if done.is_empty() { idle + 1 } else { 0 };
            if idle >= IDLE_ROUNDS {
                break;
            }
            self.take(done)?;
            self.tested.elapsed = started.elapsed();
        }
        self.tested.elapsed = started.elapsed();
        let swept = swept(self.numbers, self.settings.harvest.is_light).min(self.sweep.len());
        self.tested.swept = (swept, self.sweep.len());
        self.tested.faults = self.workers.iter().map(|worker| worker.asker.faults).sum();
        self.workers.iter_mut().for_each(|worker| worker.asker.end_in_peace());
        Ok(())
    }

    /// Asks one round of inputs.
    fn round(&mut self, count: usize, until: Option<Instant>) -> Result<Vec<Done>, FuzzError> {
        let first = self.numbers;
        self.numbers += count as u64;
        let (menu, seeds, kept, settings) = (&self.menu, &self.seeds, &self.kept, self.settings);
        let drawn = |number| {
            let input = match turn(number, &self.sweep, settings.harvest.is_light) {
                Turn::Swept(at) => self.sweep.input(at),
                Turn::Drawn => draw_input(menu, seeds, kept, settings, number),
            };
            // What was varied or changed may be no question to this peer any more.
            input.filter(|input| menu.has(input.call, &input.args))
        };
        let (known, charges) = (&self.tested.coverage.keys, &self.charges);
        let next = AtomicUsize::new(0);
        let (stop, listener) = (self.stop, self.listener);
        let results: Mutex<Vec<Done>> = Mutex::new(Vec::new());
        let failed: Mutex<Option<FuzzError>> = Mutex::new(None);
        let work = |worker: &mut Worker<'_>| {
            loop {
                let from = next.fetch_add(CHUNK, Ordering::Relaxed);
                let is_late = until.is_some_and(|until| Instant::now() >= until);
                if from >= count || is_late || stop.is_set() || worker.asker.faults >= MOST_FAULTS {
                    return;
                }
                let numbers = (from..(from + CHUNK).min(count)).map(|nth| first + nth as u64);
                let tasks: Vec<Task> =
                    numbers.filter_map(|number| Some(Task { number, input: drawn(number)? })).collect();
                match ask(worker, tasks, known, charges) {
                    Ok(mut done) => {
                        listener.asked(done.len() as u64);
                        results.lock().unwrap_or_else(PoisonError::into_inner).append(&mut done);
                    }
                    Err(error) => {
                        failed.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                        return;
                    }
                }
            }
        };
        if let [worker] = self.workers.as_mut_slice() {
            work(worker);
        } else {
            thread::scope(|scope| {
                for worker in &mut self.workers {
                    scope.spawn(|| work(worker));
                }
            });
        }
        match failed.into_inner().unwrap_or_else(PoisonError::into_inner) {
            None | Some(FuzzError::Start(StartError::Interrupted)) => {}
            Some(FuzzError::Start(error)) if self.tested.inputs > 0 => self.tested.given_up = Some(error.to_string()),
            Some(error) => return Err(error),
        }
        if self.workers.iter().any(|worker| worker.asker.faults >= MOST_FAULTS) {
            self.tested.given_up = Some(format!("{MOST_FAULTS} of its processes ended in a fault"));
        }
        let mut done = results.into_inner().unwrap_or_else(PoisonError::into_inner);
        done.sort_by_key(|done| done.number);
        Ok(done)
    }

    /// Takes the results of a round, in the order of its inputs.
    fn take(&mut self, done: Vec<Done>) -> Result<(), FuzzError> {
        let mut parted = Vec::new();
        for done in done {
            self.tested.inputs += 1;
            self.tested.steps += done.reached.length as u64;
            let is_new = self.tested.coverage.count(done.call, &done.reached);
            let Some(input) = done.input else { continue };
            if is_new && done.reached.length <= 400 {
                let kept = self.kept.entry(done.call).or_default();
                if kept.len() < KEPT {
                    kept.push(input.clone());
                } else {
                    // The oldest make room, by a rule that no clock disturbs.
                    let place = usize::try_from(done.number).unwrap_or(0) % KEPT;
                    kept[place] = input.clone();
                }
            }
            if let Some(what) = done.parted {
                parted.push((done.number, input, what));
            }
        }
        for (number, input, what) in parted {
            match what {
                Parted::Fault(fault) => self.broke_off(number, &input, &fault)?,
                Parted::Unsupported => *self.tested.unsupported.entry(input.call.as_str()).or_default() += 1,
                Parted::Open(why) => *self.tested.open.entry(why).or_default() += 1,
                Parted::Allowed => self.tested.allowed += 1,
                Parted::Wrong(spec, line, differences) => self.differs(number, &input, &spec, &line, &differences)?,
            }
        }
        Ok(())
    }

    /// Whether a disagreement of this look is still to be shrunk; it counts for its finding otherwise.
    fn is_fresh(&mut self, look: &Look) -> bool {
        let (seen, finding) = self.looks.entry(look.clone()).or_default();
        *seen += 1;
        // Another defect may look the same.
        if *seen <= SHRUNK_ALIKE || seen.is_power_of_two() {
            return true;
        }
        if let Some(known) = finding.and_then(|place| self.tested.findings.get_mut(place)) {
            known.times += 1;
        }
        false
    }

    fn differs(
        &mut self,
        number: u64,
        input: &Input,
        spec: &Answer,
        line: &[u8],
        differences: &Differences,
    ) -> Result<(), FuzzError> {
        let look = (input.call, hint_of(&input.args), kind_of(differences), in_short(differences));
        if !self.is_fresh(&look) {
            return Ok(());
        }
        let Some((rule, role)) = self.charges.get(&input.call).cloned() else { return Ok(()) };
        let mut best = Found {
            input: input.clone(),
            expect: Tree::Null,
            specification: shown(spec),
            answer: excerpt(line, SHOWN),
            differences: differences.clone(),
        };
        let (wanted, call) = (kind_of(differences), input.call);
        let [Worker { asker, court }, ..] = self.workers.as_mut_slice() else { return Ok(()) };
        let is_over = is_over(self.stop, self.until);
        let mut trouble = None;
        let menu = &self.menu;
        let mut look_at = |args: &Tree, best: &mut Found| -> Result<bool, FuzzError> {
            // On the way to the smallest there is what this peer is not to be asked.
            if !menu.has(call, args) {
                return Ok(false);
            }
            let Some((candidate, found)) = disagreement(asker, court, call, args, &rule, role)? else {
                return Ok(false);
            };
            let same = kind_of(&found) == wanted;
            if same {
                *best = candidate;
            }
            Ok(same)
        };
        // What does not show again was of the process and not of the input.
        let repeats = look_at(&input.args, &mut best)?;
        let (mut args, mut is_smallest) = (input.args.clone(), false);
        if repeats {
            is_smallest = shrink(&mut args, self.settings.tries, |args| {
                if is_over() {
                    return ControlFlow::Break(());
                }
                match look_at(args, &mut best) {
                    Ok(shows) => ControlFlow::Continue(shows),
                    Err(error) => {
                        trouble = Some(error);
                        ControlFlow::Break(())
                    }
                }
            });
        }
        if let Some(error) = trouble {
            return Err(error);
        }
        if best.expect == Tree::Null
            && let Verdict::Expect(expect) = oracle::expectation(input, spec, None)
        {
            best.expect = expect;
        }
        let shrunk = Shrunk { from: length(&input.args), to: length(&best.input.args), is_smallest };
        self.report(number, best, None, shrunk, &look);
        Ok(())
    }

    fn broke_off(&mut self, number: u64, input: &Input, fault: &Fault) -> Result<(), FuzzError> {
        let look = (input.call, hint_of(&input.args), fault.kind, fault.what.clone());
        if !self.is_fresh(&look) {
            return Ok(());
        }
        let call = input.call;
        let mut args = input.args.clone();
        let mut last = fault.clone();
        // Each try of a hang costs all of the patience.
        let tries = match fault.kind {
            "hang" => 12,
            "memory" => 30,
            _ => self.settings.tries.min(150),
        };
        let [Worker { asker, .. }, ..] = self.workers.as_mut_slice() else { return Ok(()) };
        let (before, is_over) = (asker.faults, is_over(self.stop, self.until));
        let (mut trouble, menu) = (None, &self.menu);
        let is_smallest = shrink(&mut args, tries, |args| {
            if is_over() {
                return ControlFlow::Break(());
            }
            let written = args.to_string();
            if !menu.has(call, args) || code_of(&oracle::specification(call, &written)) == Some("internal") {
                return ControlFlow::Continue(false);
            }
            match asker.ask(&body(call, &written)) {
                Ok(Said::Fault(found)) if found.kind == fault.kind => {
                    last = found;
                    ControlFlow::Continue(true)
                }
                Ok(_) => ControlFlow::Continue(false),
                Err(error) => {
                    trouble = Some(error);
                    ControlFlow::Break(())
                }
            }
        });
        // Those of shrinking are our doing.
        asker.faults = before;
        let smallest = Input { call, args };
        let answer = oracle::specification(call, &smallest.args.to_string());
        let expect = match oracle::expectation(&smallest, &answer, None) {
            Verdict::Expect(expect) => expect,
            Verdict::Open(_) => super::tree::object([("accept", crate::json::Json::Bool(true))]),
        };
        let shrunk = Shrunk { from: length(&input.args), to: length(&smallest.args), is_smallest };
        let found = Found {
            input: smallest,
            expect,
            specification: shown(&answer),
            answer: format!("it {}", last.what),
            differences: Differences::default(),
        };
        self.report(number, found, Some(last), shrunk, &look);
        trouble.map_or(Ok(()), |error| Err(error.into()))
    }

    /// Adds a finding, unless it is one that is known.
    fn report(&mut self, number: u64, found: Found, fault: Option<Fault>, shrunk: Shrunk, look: &Look) {
        let kind = fault.as_ref().map_or_else(|| kind_of(&found.differences), |fault| fault.kind);
        let place = starred(&found.differences.place);
        let rejects = found.expect.get("reject").is_some();
        let (call, level) = (found.input.call, self.settings.level);
        let decided = self.rules.decide(call, &found.input.args, rejects, &found.differences.place, &self.roles, level);
        let (decided, role) = match decided {
            Some((decided, role)) => (Some(decided), role),
            None => (None, self.roles.first().copied().unwrap_or(Role::Commander)),
        };
        let same = |known: &Finding| {
            known.found.input.call == call
                && known.kind == kind
                && known.place == place
                && known.decided.as_ref().map(|d| &d.rule) == decided.as_ref().map(|d| &d.rule)
        };
        let at = self.tested.findings.iter().position(same);
        let at = match at {
            Some(at) => {
                let known = &mut self.tested.findings[at];
                known.times += 1;
                // The smaller one says more.
                if found.input.args.to_string().len() < known.found.input.args.to_string().len() {
                    (known.found, known.fault, known.shrunk, known.first) = (found, fault, shrunk, number);
                }
                at
            }
            None => {
                let rule = decided.as_ref().map_or("no rule that is known", |decided| decided.rule.as_str());
                self.listener.found(call.as_str(), &format!("{kind}, {rule}"));
                let finding = Finding { kind, place, decided, role, found, fault, times: 1, first: number, shrunk };
                self.tested.findings.push(finding);
                self.tested.findings.len() - 1
            }
        };
        if let Some((_, finding)) = self.looks.get_mut(look) {
            *finding = Some(at);
        }
    }
}

/// Whether the search was stopped, or its time is over.
fn is_over(stop: &Stop, until: Option<Instant>) -> impl Fn() -> bool {
    move || stop.is_set() || until.is_some_and(|until| Instant::now() >= until)
}

/// Where the input of a number comes from.
enum Turn {
    /// From the sweep, at this place.
    Swept(u64),
    /// It is drawn.
    Drawn,
}

/// How many of the numbers below this one sweep, while there is something to sweep: of a dictionary that somebody asked
/// for, seven of eight; else half of the first, and one of eight of those behind them.
fn swept(number: u64, is_light: bool) -> u64 {
    const EVEN: u64 = 60_000;
    if is_light {
        let even = number.min(EVEN);
        even / 2 + (number - even) / 8
    } else {
        number / 8 * 7 + (number % 8).min(7)
    }
}

fn turn(number: u64, sweep: &Sweep, is_light: bool) -> Turn {
    let at = swept(number, is_light);
    if swept(number + 1, is_light) > at && at < sweep.len() { Turn::Swept(at) } else { Turn::Drawn }
}

/// The input of this number. A large one is mostly drawn again: it costs as much as hundreds of small ones, in which
/// there is more to find.
fn draw_input(
    menu: &Menu,
    seeds: &Seeds,
    kept: &BTreeMap<Call, Vec<Input>>,
    settings: &Settings,
    number: u64,
) -> Option<Input> {
    let mut draw = Draw::new(settings.seed, number, &settings.harvest).with_length(settings.length);
    let call = generate::call(menu, &mut draw)?;
    let others = kept.get(&call).map_or(&[][..], Vec::as_slice);
    let mut input = draw_of(call, menu, seeds, others, settings, &mut draw)?;
    for _ in 0..3 {
        let bytes = super::tree::size(&input.args);
        let cheap = if input.args.get("steps").is_some() { CHEAP_STEPS } else { CHEAP };
        if draw.share() < (cheap as f64 / bytes.max(1) as f64).sqrt() {
            break;
        }
        input = draw_of(call, menu, seeds, others, settings, &mut draw)?;
    }
    Some(input)
}

/// An input of a call: drawn anew, a case of the corpus that is varied, or an input that was kept, changed.
fn draw_of(
    call: Call,
    menu: &Menu,
    seeds: &Seeds,
    others: &[Input],
    settings: &Settings,
    draw: &mut Draw<'_>,
) -> Option<Input> {
    // A trace that was changed may have another length.
    let is_changed = settings.length.is_none();
    if is_changed
        && draw.chance(50)
        && let Some(varied) = seeds.vary(call, draw)
    {
        return Some(Input { call, args: varied.args });
    }
    if others.len() < 4 || !is_changed || !draw.chance(40) {
        return Some(Input { call, args: generate::args(call, menu, draw)? });
    }
    let (one, other) = (draw.below(others.len()), draw.below(others.len()));
    Some(mutate(&others[one], others.get(other), draw))
}

/// Asks inputs of the peer, and meanwhile of the specification; then judges where they part.
fn ask(
    worker: &mut Worker<'_>,
    tasks: Vec<Task>,
    known: &HashSet<u64>,
    charges: &Charges,
) -> Result<Vec<Done>, FuzzError> {
    let written = tasks.into_iter().map(|task| (task.input.args.to_string(), task));
    // Large steps again and again would only show how slow a peer is.
    let (written, tasks): (Vec<String>, Vec<Task>) = written.filter(|(args, _)| args.len() <= LARGEST).unzip();
    if tasks.is_empty() {
        return Ok(Vec::new());
    }
    let bodies: Vec<String> = tasks.iter().zip(&written).map(|(task, args)| body(task.input.call, args)).collect();
    let flight = worker.asker.begin(&bodies)?;
    let answers: Vec<Answer> =
        tasks.iter().zip(&written).map(|(task, args)| oracle::specification(task.input.call, args)).collect();
    let said = flight.finish(&mut worker.asker, &bodies)?;
    let (mut done, mut apart) = (Vec::new(), Vec::new());
    for (((task, spec), said), body) in tasks.into_iter().zip(answers).zip(said).zip(&bodies) {
        let Task { number, input } = task;
        let call = input.call;
        let reached = reached(&input, body.len(), &spec);
        let parts = !matches!(said, Said::Nothing) && code_of(&spec) != Some("internal") && parts(call, &spec, &said);
        let is_new = reached.keys.iter().any(|key| !known.contains(key));
        if parts {
            apart.push((done.len(), spec, said));
        }
        done.push(Done { number, input: (is_new || parts).then_some(input), call, reached, parted: None });
    }
    judge(&worker.court, apart, &mut done, charges)?;
    Ok(done)
}

/// Judges answers that are not surely the specification's, each with the place of its input among these.
fn judge(
    court: &Court,
    apart: Vec<(usize, Answer, Said)>,
    done: &mut [Done],
    charges: &Charges,
) -> Result<(), FuzzError> {
    let mut asked = Vec::new();
    for (at, spec, said) in apart {
        let line = match said {
            Said::Line(line) => line,
            Said::Fault(fault) => {
                done[at].parted = Some(Parted::Fault(fault));
                continue;
            }
            Said::Nothing => continue,
        };
        // What no case can ask cannot be judged.
        let Some(input) = done[at].input.as_ref().filter(|input| charges.contains_key(&input.call)) else { continue };
        let reply = Reply::parse(&line);
        let said = reply.as_ref().ok().map(|reply| &reply.answer);
        if matches!(said, Some(crate::peer::Answer::Unsupported)) {
            done[at].parted = Some(Parted::Unsupported);
            continue;
        }
        match oracle::expectation(input, &spec, said) {
            Verdict::Open(why) => done[at].parted = Some(Parted::Open(why)),
            Verdict::Expect(expect) => asked.push((at, expect, line, spec)),
        }
    }
    let judgements = {
        let questions = asked.iter().filter_map(|(at, expect, line, _): &(usize, Tree, Vec<u8>, Answer)| {
            let Done { input: Some(input), call, .. } = &done[*at] else { return None };
            let (rule, role) = charges.get(call)?;
            let question = Question { call: *call, args: &input.args, expect, rules: vec![rule.clone()], role: *role };
            Some((question, line.as_slice()))
        });
        court.judge_each(&questions.collect::<Vec<_>>())?
    };
    for ((at, _, line, spec), judgement) in asked.into_iter().zip(judgements) {
        done[at].parted = Some(match judgement {
            None => Parted::Open("the answer is longer than a case may have it"),
            Some(Judgement::Pass { .. }) => Parted::Allowed,
            Some(Judgement::Unsupported { .. }) => Parted::Unsupported,
            Some(Judgement::Fail(differences)) => Parted::Wrong(spec, line, differences),
        });
    }
    Ok(())
}

/// Whether an answer is not surely the specification's.
pub(super) fn parts(call: Call, spec: &Answer, said: &Said) -> bool {
    let Said::Line(line) = said else { return true };
    if let (Answer::Result(result), Some(at)) = (spec, line.iter().position(|byte| *byte == b',')) {
        let rest = &line[at + 1..];
        let same = rest.strip_prefix(b"\"result\":").and_then(|rest| rest.strip_suffix(b"}"));
        if same == Some(result.as_bytes()) {
            return false;
        }
    }
    match Reply::parse(line) {
        Ok(reply) => !agree(call, spec, &reply.answer),
        Err(_) => true,
    }
}

/// The disagreement that these arguments show, if they show one.
fn disagreement(
    asker: &mut Asker<'_>,
    court: &Court,
    call: Call,
    args: &Tree,
    rule: &str,
    role: Role,
) -> Result<Option<(Found, Differences)>, FuzzError> {
    let written = args.to_string();
    let spec = oracle::specification(call, &written);
    let Said::Line(line) = asker.ask(&body(call, &written))? else { return Ok(None) };
    let input = Input { call, args: args.clone() };
    let is_question = code_of(&spec) != Some("internal");
    if !is_question || !parts(call, &spec, &Said::Line(line.clone())) {
        return Ok(None);
    }
    let reply = Reply::parse(&line);
    let Verdict::Expect(expect) = oracle::expectation(&input, &spec, reply.as_ref().ok().map(|reply| &reply.answer))
    else {
        return Ok(None);
    };
    let question = Question { call, args, expect: &expect, rules: vec![rule.to_owned()], role };
    let judged = court.judge(&[(question, line.as_slice())]);
    // On the way to the smallest, an input may be none that a file can hold.
    let judgement = judged.ok().and_then(|judgements| judgements.into_iter().next());
    let Some(Judgement::Fail(differences)) = judgement else { return Ok(None) };
    let (specification, answer) = (shown(&spec), excerpt(&line, SHOWN));
    let found = Found { input, expect, specification, answer, differences: differences.clone() };
    Ok(Some((found, differences)))
}

fn code_of(answer: &Answer) -> Option<&str> {
    match answer {
        Answer::Error { code, .. } => Some(code),
        _ => None,
    }
}

fn shown(answer: &Answer) -> String {
    match answer {
        Answer::Result(result) => excerpt(result.as_bytes(), SHOWN),
        Answer::Error { code, message } => format!("the error `{code}`, {}", excerpt(message.as_bytes(), 400)),
        Answer::Unsupported => "unsupported".to_owned(),
    }
}

fn kind_of(differences: &Differences) -> &'static str {
    match differences.manner {
        Manner::Value => "value",
        Manner::Refusal => "refusal",
        Manner::Order => "order",
        Manner::Crash => "crash",
    }
}

/// A place with a star for each number.
fn starred(place: &str) -> String {
    let token = |token: &str| {
        if token.bytes().all(|b| b.is_ascii_digit()) && !token.is_empty() { "*".to_owned() } else { token.to_owned() }
    };
    place.split('/').map(token).collect::<Vec<_>>().join("/")
}

/// Where answers differ first, and words that are there in place of each other, such as modes.
fn in_short(differences: &Differences) -> String {
    let word = |value: &Option<String>| match value.as_deref() {
        Some(word) if word.len() <= 12 && !word.bytes().any(|b| b.is_ascii_digit()) => word.to_owned(),
        Some(_) => "…".to_owned(),
        None => "nothing".to_owned(),
    };
    let first = differences.first.first();
    let words = first.map(|first| format!(" {} {}", word(&first.expected), word(&first.got))).unwrap_or_default();
    format!("{}{words}", starred(&differences.place))
}

/// What tells inputs of a call apart that are about different things.
fn hint_of(args: &Tree) -> String {
    let hint = ["kind", "key", "plane"].into_iter().find_map(|name| super::tree::string(args, name));
    hint.unwrap_or_default().to_owned()
}

fn length(args: &Tree) -> usize {
    let steps = super::tree::items(args.get("steps")).len();
    steps + super::tree::items(args.get("requests")).len()
}

/// Writes the findings as a vector file that `run --vectors` reads. The file.
///
/// # Errors
/// It cannot be written.
pub fn save(folder: &Path, peer: &str, seed: u64, findings: &[Finding]) -> Result<PathBuf, CourtError> {
    let plain = |c: char| if c.is_ascii_lowercase() || c.is_ascii_digit() { c } else { '-' };
    let name: String = peer.to_ascii_lowercase().chars().map(plain).take(40).collect();
    let cases = findings.iter().enumerate().map(|(nth, finding)| {
        let decided = finding.decided.as_ref();
        let rules = decided.map(|decided| decided.rule.clone()).into_iter().collect();
        let found = &finding.found;
        let question = Question {
            call: found.input.call,
            args: &found.input.args,
            expect: &found.expect,
            rules,
            role: finding.role,
        };
        let title = format!(
            "A disagreement of {}, found as input {} of the seed {seed}.",
            found.input.call.as_str(),
            finding.first
        );
        let why = decided.map_or_else(|| "By the specification.".to_owned(), |decided| decided.sentence.clone());
        let mut case = court::case(&question, "", &title, &why);
        let id = format!("{}/{name}/{}-{nth}", court::AREA, found.input.call.as_str().replace('.', "-"));
        super::tree::set(&mut case, "id", text(id));
        case
    });
    let about = format!("What a search found of {peer}, by the seed {seed}.");
    court::save(folder, &name, &about, cases.collect())
}

/// Asks so many inputs of the specification alone, twice, and says how many agree with themselves: for benchmarks.
#[must_use]
pub fn in_process(seed: u64, from: u64, count: u64, filter: &[Pattern], length: Option<usize>) -> u64 {
    let menu = super::menu(&Role::ALL, Level::Strict, true, filter);
    let settings = alone(seed, count, length);
    let (seeds, kept) = (Seeds::default(), BTreeMap::new());
    let agrees = |number: u64| {
        let Some(input) = draw_input(&menu, &seeds, &kept, &settings, number) else { return false };
        let args = input.args.to_string();
        oracle::specification(input.call, &args) == oracle::specification(input.call, &args)
    };
    (from..from + count).filter(|number| agrees(*number)).count() as u64
}

/// Of so many inputs those of which the specification's own answer is not what is asked for, each with its
/// differences: there a correct peer would be blamed. Before them stands how many were judged.
///
/// # Errors
/// The cases cannot be written or read.
pub fn contradictions(
    seed: u64,
    count: u64,
    suite: &Suite,
    filter: &[Pattern],
) -> Result<(u64, Vec<String>), FuzzError> {
    let menu = super::menu(&Role::ALL, Level::Strict, true, filter);
    let settings = alone(seed, count, None);
    let (seeds, kept) = (Seeds::default(), BTreeMap::new());
    let (court, rules) = (Court::open()?, Rules::new(suite));
    let (mut asked, mut found) = (0, Vec::new());
    for number in 0..count {
        let Some(input) = draw_input(&menu, &seeds, &kept, &settings, number) else { continue };
        let spec = oracle::specification(input.call, &input.args.to_string());
        let (Some(line), Some((rule, role))) = (court::line(&spec), rules.any(input.call, &Role::ALL, Level::Strict))
        else {
            continue;
        };
        let said = Reply::parse(line.as_bytes());
        let said = said.as_ref().ok().map(|reply| &reply.answer);
        let Verdict::Expect(expect) = oracle::expectation(&input, &spec, said) else { continue };
        let question = Question { call: input.call, args: &input.args, expect: &expect, rules: vec![rule], role };
        // An input that no file can hold is none that a search would show.
        let judged = court.judge(&[(question, line.as_bytes())]).ok().and_then(|judged| judged.into_iter().next());
        asked += u64::from(judged.is_some());
        if let Some(Judgement::Fail(differences)) = judged {
            let shown = excerpt(input.args.to_string().as_bytes(), SHOWN);
            found.push(format!("{} {number}: {shown}: {differences:?}", input.call.as_str()));
        }
    }
    Ok((asked, found))
}

/// The settings of a search without a peer.
fn alone(seed: u64, count: u64, length: Option<usize>) -> Settings {
    Settings {
        extent: Extent::Cases(count),
        seed,
        jobs: 1,
        patterns: Vec::new(),
        level: Level::Strict,
        roles: Vec::new(),
        timeout: Duration::ZERO,
        start_timeout: Duration::ZERO,
        memory: 0,
        tries: 0,
        harvest: Harvest::default(),
        length,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_large_is_drawn_now_and_then_and_takes_a_part_of_the_bytes_alone() {
        let menu = super::super::menu(&Role::ALL, Level::Strict, true, &[Pattern::new("decode")]);
        let seeds = Seeds::of(&Suite::embedded().unwrap(), &menu);
        let (settings, kept) = (alone(3, 0, None), BTreeMap::new());
        let drawn = (0..3000).filter_map(|number| draw_input(&menu, &seeds, &kept, &settings, number));
        let sizes: Vec<usize> = drawn.map(|input| input.args.to_string().len()).collect();
        let large: Vec<usize> = sizes.iter().copied().filter(|size| *size > 1 << 18).collect();
        let share = large.iter().sum::<usize>() as f64 / sizes.iter().sum::<usize>() as f64;
        assert!(!large.is_empty() && large.len() < 25 && share < 0.7, "{} {share}", large.len());
    }
}
