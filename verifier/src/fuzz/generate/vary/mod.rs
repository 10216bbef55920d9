//! A case of the corpus, varied.
//!
//! A case shows a rule in the smallest frame, by the fewest steps, at once. A defect hides where the same is asked
//! after a hundred steps, within a large frame, beside a name that is nearly equal, at another scale, or together with
//! what another case has. So a case is taken, by its rule, and changed by one or more ways:
//!
//! - *pump*: a step, or some, again and again; the clock and the seqs go on. Or resets, as often as a byte counts.
//! - *rounds*: the whole trace several times, a reset between.
//! - *before*: steps of another case, first.
//! - *idle*: a step of another case within, many times.
//! - *graft*: what another case has at a place of the same name.
//! - *grow*: an array, a map or a string as long as a draw of sizes says.
//! - *twin*: beside a name one that is nearly equal, with other values; of a session, another session.
//! - *scale*, *seqs*, *clock*: all lengths times a number, all seqs or times plus a number.
//! - *gap*: from a step on, everything later, or of later seqs.
//! - *instant*: a step when a time of the trace ends, or just before or behind that.
//! - *residue*: before a step nearly the same one, with something that may stay behind.
//! - *crowd*: a session, a channel or an entry so many times, each with a name of its own.
//! - *sibling*: beside an item one that differs from it in one member.
//! - *namesake*: one name for two things.
//! - *omit*: a member less.
//! - *spell*: frames as strangely spelled as the grammar allows, or behind much that nobody reads.
//! - *bury*: in a frame, deep or far behind, what a reader has to notice.
//! - *fit*: a frame of just so many bytes.
//! - *blemish*: in an array of many, one that is wrong and not the first.
//! - *value*: a number next to what was there.

mod crowd;
mod depths;
mod kin;
mod moments;

use std::collections::{BTreeMap, HashSet};

use super::corrupt::{unknown, wild};
use super::mutate::value;
use super::plant::WRAPS;
use super::{Draw, Menu, Tree};
use crate::fuzz::draw::LARGEST;
use crate::fuzz::rules::fnv;
use crate::fuzz::tree::{
    MAPS, Step, at, at_mut, double, int, integer, items, literal, name_at, num, own, places, set, size, spelled,
    string, text,
};
use crate::json::Json;
use crate::peer::Call;
use crate::suite::Suite;

/// How many bytes the request of a case may have that is varied.
const SMALL: usize = 24 << 10;
/// How many bytes a varied request may have.
const LARGE: usize = 4 << 20;

/// The cases that may be varied, by call and by the rule that each is about.
#[derive(Debug, Clone, Default)]
pub(crate) struct Seeds(BTreeMap<Call, Vec<(String, Vec<Tree>)>>);

/// A case that was varied.
#[derive(Debug, Clone)]
pub(crate) struct Varied {
    /// The arguments of its call.
    pub(crate) args: Tree,
    /// The rule of the case with each way in which it was varied, and how much, as keys.
    pub(crate) keys: Vec<u64>,
}

impl Seeds {
    /// Of a suite, what fits a menu.
    pub(crate) fn of(suite: &Suite, menu: &Menu) -> Self {
        let mut seeds: BTreeMap<Call, BTreeMap<String, Vec<Tree>>> = BTreeMap::new();
        let small = suite.cases().iter().filter(|case| case.request_bytes() <= SMALL && !case.is_deep());
        for case in small.filter(|case| menu.calls.iter().any(|(call, _)| *call == case.call)) {
            let body = case.body();
            let Some(args) = Json::parse(&format!("{{{body}")).ok().and_then(|body| body.get("args").map(own)) else {
                continue;
            };
            let Some(rule) = case.requirements.first().filter(|_| menu.has(case.call, &args)) else { continue };
            seeds.entry(case.call).or_default().entry(rule.id.clone()).or_default().push(args);
        }
        Self(seeds.into_iter().map(|(call, rules)| (call, rules.into_iter().collect())).collect())
    }

    /// The cases of each call, by the rule that each is about.
    pub(crate) fn by_rule(&self) -> impl Iterator<Item = (Call, &[(String, Vec<Tree>)])> {
        self.0.iter().map(|(call, rules)| (*call, rules.as_slice()))
    }

    /// One of a call, by a rule that is drawn first: those with few cases come as often as others.
    fn pick(&self, call: Call, draw: &mut Draw<'_>) -> Option<(&str, &Tree)> {
        let rules = self.0.get(&call)?;
        let (rule, cases) = rules.get(draw.below(rules.len()))?;
        Some((rule, cases.get(draw.below(cases.len()))?))
    }

    /// One of a call that asks for the same by another road.
    fn of_kin(&self, call: Call, draw: &mut Draw<'_>) -> Option<&Tree> {
        let kin: Vec<Call> = kin::of(call).iter().copied().filter(|call| self.0.contains_key(call)).collect();
        let call = kin.get(draw.below(kin.len()))?;
        self.pick(*call, draw).map(|(_, case)| case)
    }

    /// One of a call, varied; none, if there is no case of it.
    pub(crate) fn vary(&self, call: Call, draw: &mut Draw<'_>) -> Option<Varied> {
        let (rule, seed) = self.pick(call, draw)?;
        let (_, other) = self.pick(call, draw)?;
        let rule = fnv(3, rule);
        let mut varied = Varied { args: seed.clone(), keys: Vec::new() };
        for _ in 0..draw.one(&[1, 1, 2, 2, 3]) {
            let ways: &[Way] = match trace_of(&varied.args) {
                Some("steps") => TRACE,
                Some(_) => REQUESTS,
                None => SINGLE,
            };
            let way = draw.one(ways);
            let by_another_road = way.takes_of_another() && draw.chance(25);
            let other = if by_another_road { self.of_kin(call, draw).unwrap_or(other) } else { other };
            let much = way.take(&mut varied.args, other, draw);
            // A request that names a member twice is none.
            if size(&varied.args) > LARGE || repeats(&varied.args) {
                varied = Varied { args: seed.clone(), keys: Vec::new() };
                continue;
            }
            varied.keys.push(fnv(rule, &format!("{way:?} {}", (much + 1).ilog2())));
        }
        spell_plainly(&mut varied.args, "");
        Some(varied)
    }
}

/// Spells numbers as PROTOCOL.md, section 2, has them, for the adapter reads them and not the implementation: many JSON
/// readers lose the sign of `-0`, and an i64 has no more digits than it takes.
fn spell_plainly(tree: &mut Tree, under: &str) {
    const DIGITS: usize = 40;
    match tree {
        Json::Array(items) => items.iter_mut().for_each(|item| spell_plainly(item, under)),
        Json::Object(members) => members.iter_mut().for_each(|(name, value)| spell_plainly(value, name)),
        Json::Number(spelling) if spelling == "-0" => {
            *tree = literal(if ARRAYS.contains(&under) { "-0.0" } else { "0" });
        }
        Json::String(word) if ARRAYS.contains(&under) && word.len() > DIGITS => {
            if let Some(digits) = word.get(..DIGITS).filter(|_| word.bytes().all(|byte| byte.is_ascii_digit())) {
                *tree = text(digits.to_owned());
            }
        }
        _ => {}
    }
}

/// Members whose arrays hold doubles, or integers as text.
const ARRAYS: [&str; 4] = ["data", "times", "values", "senders"];

/// Whether an object has two members of one name; those of written frames may.
fn repeats(tree: &Tree) -> bool {
    match tree {
        Json::Array(items) => items.iter().any(repeats),
        Json::Object(members) => {
            let mut names = HashSet::new();
            members.iter().any(|(name, value)| !names.insert(name.as_ref()) || repeats(value))
        }
        _ => false,
    }
}

/// A way to vary a case.
#[derive(Debug, Clone, Copy)]
enum Way {
    Pump,
    Rounds,
    Before,
    Idle,
    Graft,
    Grow,
    Twin,
    Scale,
    Seqs,
    Clock,
    Gap,
    Instant,
    Residue,
    Crowd,
    Sibling,
    Namesake,
    Omit,
    Spell,
    Bury,
    Fit,
    Blemish,
    Value,
}

/// Each as often as it is drawn.
const TRACE: &[Way] = {
    use Way::{
        Before, Blemish, Bury, Clock, Crowd, Fit, Gap, Graft, Grow, Idle, Instant, Namesake, Omit, Pump, Residue,
        Rounds, Scale, Seqs, Sibling, Spell, Twin, Value,
    };
    &[
        Pump, Pump, Pump, Pump, Idle, Idle, Idle, Rounds, Rounds, Before, Before, Gap, Gap, Gap, Instant, Instant,
        Instant, Residue, Residue, Residue, Crowd, Namesake, Sibling, Omit, Graft, Graft, Grow, Blemish, Twin, Scale,
        Seqs, Clock, Spell, Bury, Fit, Value,
    ]
};
const REQUESTS: &[Way] = {
    use Way::{
        Before, Blemish, Bury, Crowd, Fit, Graft, Grow, Idle, Namesake, Omit, Pump, Residue, Sibling, Spell, Twin,
        Value,
    };
    &[
        Pump, Pump, Pump, Idle, Idle, Before, Crowd, Crowd, Residue, Namesake, Sibling, Omit, Graft, Grow, Blemish,
        Twin, Twin, Spell, Bury, Fit, Value,
    ]
};
const SINGLE: &[Way] = {
    use Way::{Blemish, Bury, Crowd, Fit, Graft, Grow, Namesake, Omit, Scale, Seqs, Sibling, Spell, Twin, Value};
    &[
        Graft, Graft, Grow, Grow, Grow, Blemish, Blemish, Crowd, Namesake, Sibling, Sibling, Omit, Twin, Spell, Spell,
        Bury, Bury, Fit, Value, Value, Seqs, Scale,
    ]
};

impl Way {
    /// Whether it takes something of another case.
    fn takes_of_another(self) -> bool {
        matches!(self, Self::Graft | Self::Idle | Self::Before | Self::Residue)
    }

    /// Changes the arguments this way; how much.
    fn take(self, args: &mut Tree, other: &Tree, draw: &mut Draw<'_>) -> usize {
        match self {
            Self::Pump if trace_of(args) == Some("steps") && draw.chance(8) => resets(args, draw),
            Self::Pump => pump(args, None, draw),
            Self::Idle => pump(args, Some(other), draw),
            Self::Rounds => rounds(args, draw),
            Self::Before => before(args, other, draw),
            Self::Graft => within(args, draw, &mut |tree, draw| graft(tree, other, draw)),
            Self::Grow => within(args, draw, &mut grow),
            Self::Twin if trace_of(args) == Some("requests") && draw.chance(70) => twin_session(args, draw),
            Self::Twin => twin(args, draw),
            Self::Scale => {
                let power = i32::try_from(draw.range(-400, 400)).unwrap_or(0);
                let factor = if draw.chance(50) { 2_f64.powi(power) } else { 10_f64.powi(power / 2) };
                each_double(args, &mut |name, value| LENGTHS.contains(&name).then_some(value * factor));
                power.unsigned_abs() as usize
            }
            Self::Seqs => {
                let base = draw.one(&[1 << 8, 1 << 15, 1 << 16, 1 << 24, 1 << 31, 1 << 32, 1 << 52, LARGEST, -LARGEST]);
                let by = base.saturating_sub(base.signum() * draw.range(0, 40));
                each_seq(args, &mut |seq| if seq == 0 { 0 } else { seq.saturating_add(by).clamp(-LARGEST, LARGEST) });
                (base.unsigned_abs() + 1).ilog2() as usize
            }
            Self::Clock => {
                let mut by = draw.one(&[-1000.0, 1024.0, 1e6, 1.7e9, 2_147_483_648.0, 4_294_967_296.0, 1.7e12, 1e13]);
                if draw.chance(50) {
                    // A clock of some width wraps between two of the steps, or at one.
                    let clocks: Vec<f64> =
                        steps_of(args).into_iter().flatten().filter_map(|step| clock_of(step)).collect();
                    let at = clocks.get(draw.below(clocks.len())).copied().unwrap_or(0.0);
                    by = draw.one(&WRAPS) - at + draw.one(&[0.0, -0.001, 0.001, 1e-6]);
                }
                each_double(args, &mut |name, value| CLOCKS.contains(&name).then_some(value + by));
                1
            }
            Self::Gap => moments::gap(args, draw),
            Self::Instant => moments::instant(args, draw),
            Self::Residue => moments::residue(args, other, draw),
            Self::Crowd => crowd::crowd(args, draw),
            Self::Sibling => within(args, draw, &mut kin::sibling),
            Self::Namesake => kin::namesake(args, draw),
            Self::Omit => within(args, draw, &mut moments::omit),
            Self::Bury => depths::in_a_frame(args, draw, depths::buried),
            Self::Fit => depths::in_a_frame(args, draw, depths::fitted),
            Self::Blemish => within(args, draw, &mut depths::blemish),
            Self::Spell => {
                let mut depth = 0;
                each_frame(args, &mut |frame| {
                    depth += 1;
                    spell(frame, draw)
                });
                depth
            }
            Self::Value => {
                value(args, draw);
                1
            }
        }
    }
}

const LENGTHS: [&str; 6] = ["data", "target", "geofence_radius_m", "max_speed_mps", "max_speed", "kp"];
const CLOCKS: [&str; 2] = ["now_s", "last_sensor_s"];

/// What a trace calls its steps; none, if it is no trace.
fn trace_of(args: &Tree) -> Option<&'static str> {
    ["steps", "requests"].into_iter().find(|name| matches!(args.get(name), Some(Json::Array(_))))
}

fn steps_of(args: &mut Tree) -> Option<&mut Vec<Tree>> {
    let name = trace_of(args)?;
    let Json::Object(members) = args else { return None };
    members.iter_mut().find(|(known, _)| known == name).and_then(|(_, steps)| match steps {
        Json::Array(steps) => Some(steps),
        _ => None,
    })
}

fn clock_of(step: &Tree) -> Option<f64> {
    double(step.get("now_s")).filter(|now| now.is_finite())
}

/// Every seq of a step: that of the frame that it brings, written out or not.
fn seqs_of(step: &Tree) -> Vec<i64> {
    let mut seqs = Vec::new();
    let mut step = step.clone();
    each_seq(&mut step, &mut |seq| {
        seqs.push(seq);
        seq
    });
    seqs
}

/// A step later by so many seconds and seqs. A seq of 0, unstamped, stays.
fn later(step: &mut Tree, seconds: f64, seqs: i64) {
    if seconds != 0.0 {
        each_double(step, &mut |name, value| CLOCKS.contains(&name).then_some(value + seconds));
    }
    if seqs != 0 {
        each_seq(step, &mut |seq| if seq == 0 { 0 } else { seq.saturating_add(seqs).clamp(-LARGEST, LARGEST) });
    }
}

/// From where to where a run of steps goes: seconds and seqs.
fn span(steps: &[Tree]) -> (f64, i64) {
    let clocks: Vec<f64> = steps.iter().filter_map(clock_of).collect();
    let seqs: Vec<i64> = steps.iter().flat_map(seqs_of).filter(|seq| *seq != 0).collect();
    let (first, last) = (clocks.first().copied().unwrap_or(0.0), clocks.last().copied().unwrap_or(0.0));
    let (low, high) = (seqs.iter().min().copied().unwrap_or(0), seqs.iter().max().copied().unwrap_or(0));
    ((last - first).clamp(0.0, 1e5), high.saturating_sub(low).saturating_add(1).clamp(1, 1 << 20))
}

/// A run of steps, of this trace or of another, many times.
fn pump(args: &mut Tree, other: Option<&Tree>, draw: &mut Draw<'_>) -> usize {
    let foreign: Option<Vec<Tree>> =
        other.and_then(|other| trace_of(other).map(|name| items(other.get(name)).to_vec()));
    let Some(steps) = steps_of(args) else { return 0 };
    if steps.is_empty() || steps.len() > 2000 {
        return 0;
    }
    let at = draw.below(steps.len() + usize::from(foreign.is_some()));
    let run = |of: &[Tree], from: usize, draw: &mut Draw<'_>| {
        let most = (of.len() - from).min(6);
        let length = if draw.chance(60) { 1 } else { 1 + draw.below(most) };
        of[from..(from + length).min(of.len())].to_vec()
    };
    let (block, from) = match &foreign {
        Some(foreign) if foreign.is_empty() => return 0,
        Some(foreign) => {
            let from = draw.below(foreign.len());
            let mut block = run(foreign, from, draw);
            // It happens then and there.
            let here = steps[..at].iter().rev().find_map(clock_of).or_else(|| steps.iter().find_map(clock_of));
            let began = block.iter().find_map(clock_of);
            let newest = |steps: &[Tree]| steps.iter().flat_map(seqs_of).max();
            let seqs = newest(&steps[..at]).unwrap_or(0) - newest(&block[..1]).unwrap_or(0) + 1;
            let seconds = here.unwrap_or(0.0) - began.unwrap_or(0.0);
            let seqs = if draw.chance(70) { seqs } else { 0 };
            block.iter_mut().for_each(|step| later(step, seconds, seqs));
            (block, at)
        }
        None => (run(steps, at, draw), at),
    };
    let bytes: usize = block.iter().map(|step| step.to_string().len()).sum();
    let (count, room) = match draw.giant() {
        Some(count) => (count, LARGE / 2),
        // As many as a byte counts, and one more or less.
        None if draw.chance(8) => ((draw.one(&[127, 255, 255, 255, 511]) + draw.below(3)) / block.len(), 600_000),
        None if draw.chance(5) => (draw.size(1, 4000 / block.len()), 600_000),
        None => (draw.size(1, 320 / block.len()), 120_000),
    };
    let count = count.min((room / bytes.max(1)).max(2));
    let (seconds, seqs) = span(&block);
    let pause = draw.one(&[0.0, 0.0, 0.001, 1.0 / 64.0, 0.0625, 1.0]);
    let seconds = if draw.chance(25) { 0.0 } else { seconds + pause };
    let seqs = if draw.chance(30) { 0 } else { seqs };
    let times = |nth: usize| (seconds * nth as f64, seqs.saturating_mul(i64::try_from(nth).unwrap_or(0)));
    let own = usize::from(foreign.is_none());
    let behind = from + own * block.len();
    let copies = (own..count + own).flat_map(|nth| {
        let (seconds, seqs) = times(nth);
        block.iter().cloned().map(move |mut step| {
            later(&mut step, seconds, seqs);
            step
        })
    });
    let copies: Vec<Tree> = copies.collect();
    let added = copies.len();
    let (seconds, seqs) = if draw.chance(85) { times(count) } else { (0.0, 0) };
    steps.splice(behind..behind, copies);
    steps[behind + added..].iter_mut().for_each(|step| later(step, seconds, seqs));
    count
}

/// So many resets in a row that a narrow count of them begins anew, or nearly so many.
fn resets(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let Some(steps) = steps_of(args) else { return 0 };
    let around = draw.one(&[1 << 4, 1 << 8, 1 << 8, 1 << 8, 1 << 10, 1 << 16]);
    let count = around + draw.one(&[0, 0, 0, 1]) - draw.one(&[0, 0, 0, 1]);
    let at = 1 + draw.below(steps.len());
    let reset = crate::fuzz::tree::object([("op", text("reset"))]);
    steps.splice(at.min(steps.len())..at.min(steps.len()), std::iter::repeat_n(reset, count));
    count
}

/// The whole trace again and again, a reset between.
fn rounds(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let Some(steps) = steps_of(args) else { return 0 };
    let bytes: usize = steps.iter().map(|step| step.to_string().len()).sum();
    let count = draw.size(1, 70).min((150_000 / bytes.max(1)).max(1));
    let (seconds, seqs) = span(steps);
    let (pause, goes_on) = (draw.one(&[0.0, 0.0625, 1.0]), draw.chance(40));
    // Behind a reset the clock may begin anew as well, so that all comes again just as it was.
    let again = draw.chance(25);
    let once = steps.clone();
    for nth in 1..=count {
        if again || draw.chance(90) {
            steps.push(crate::fuzz::tree::object([("op", text("reset"))]));
        }
        if again {
            steps.extend_from_slice(&once);
            continue;
        }
        let by = if goes_on { seqs.saturating_mul(i64::try_from(nth).unwrap_or(0)) } else { 0 };
        steps.extend(once.iter().cloned().map(|mut step| {
            later(&mut step, (seconds + pause) * nth as f64, by);
            step
        }));
    }
    count
}

/// The steps of another case first.
fn before(args: &mut Tree, other: &Tree, draw: &mut Draw<'_>) -> usize {
    let Some(mut first) = trace_of(other).map(|name| items(other.get(name)).to_vec()) else { return 0 };
    let Some(steps) = steps_of(args) else { return 0 };
    let (ended, begins) = (first.iter().rev().find_map(clock_of), steps.iter().find_map(clock_of));
    let seconds = ended.unwrap_or(0.0) - begins.unwrap_or(0.0) + draw.one(&[0.0, 0.0625, 1.0, 100.0]);
    let newest = first.iter().flat_map(seqs_of).max().unwrap_or(0);
    let oldest = steps.iter().flat_map(seqs_of).filter(|seq| *seq != 0).min().unwrap_or(0);
    let seqs = if draw.chance(70) { newest.saturating_sub(oldest).saturating_add(1) } else { 0 };
    if trace_of(other) == Some("steps") && draw.chance(40) {
        first.push(crate::fuzz::tree::object([("op", text("reset"))]));
    }
    steps.iter_mut().for_each(|step| later(step, seconds, seqs));
    let count = first.len();
    first.append(steps);
    *steps = first;
    count
}

/// Changes a tree, or a frame that is written in one of its strings.
fn within(args: &mut Tree, draw: &mut Draw<'_>, change: &mut dyn FnMut(&mut Tree, &mut Draw<'_>) -> usize) -> usize {
    let frames: Vec<Vec<Step>> = places(args).into_iter().filter(|place| frame_at(args, place).is_some()).collect();
    if frames.is_empty() || draw.chance(15) {
        return change(args, draw);
    }
    let place = &frames[draw.below(frames.len())];
    let Some(mut frame) = frame_at(args, place) else { return 0 };
    let much = change(&mut frame, draw);
    in_wire_form(&mut frame);
    if let Some(target) = at_mut(args, place) {
        *target = text(frame.to_string());
    }
    much
}

/// The frame that is written in a string.
fn frame_at(args: &Tree, place: &[Step]) -> Option<Tree> {
    match at(args, place)? {
        Json::String(written) if written.starts_with('{') => Json::parse(written).ok().map(|frame| own(&frame)),
        _ => None,
    }
}

/// Numbers that a frame cannot spell are none of it.
fn in_wire_form(tree: &mut Tree) {
    match tree {
        Json::Array(items) => items.iter_mut().for_each(in_wire_form),
        Json::Object(members) => members.iter_mut().for_each(|(_, value)| in_wire_form(value)),
        Json::String(word) if word == "-0" => *tree = spelled(-0.0),
        Json::String(word) if matches!(word.as_ref(), "NaN" | "Infinity" | "-Infinity") => *tree = spelled(1.0),
        _ => {}
    }
}

/// What another case has at a place of the same name, or of the same kind.
fn graft(tree: &mut Tree, other: &Tree, draw: &mut Draw<'_>) -> usize {
    let mut parts: Vec<(String, Tree)> = Vec::new();
    gather(other, "", &mut parts);
    let all: Vec<Vec<Step>> = places(tree).into_iter().skip(1).collect();
    if all.is_empty() || parts.is_empty() {
        return 0;
    }
    for _ in 0..6 {
        let place = &all[draw.below(all.len())];
        let name = name_at(tree, place).to_owned();
        let Some(here) = at(tree, place) else { continue };
        if name == "op" || name == "steps" || name == "requests" {
            continue;
        }
        let kind = here.kind();
        let by_name = draw.chance(75);
        let fitting: Vec<&Tree> = parts
            .iter()
            .filter(|(known, value)| if by_name { *known == name && value != here } else { value.kind() == kind })
            .map(|(_, value)| value)
            .collect();
        if fitting.is_empty() {
            continue;
        }
        let new = fitting[draw.below(fitting.len())].clone();
        if let Some(target) = at_mut(tree, place) {
            *target = new;
        }
        return 1;
    }
    0
}

/// Every value with the name under which it stands, those of written frames included.
fn gather(tree: &Tree, name: &str, parts: &mut Vec<(String, Tree)>) {
    if parts.len() > 400 {
        return;
    }
    if !name.is_empty() {
        parts.push((name.to_owned(), tree.clone()));
    }
    match tree {
        Json::Array(items) => items.iter().for_each(|item| gather(item, name, parts)),
        Json::Object(members) => members.iter().for_each(|(name, value)| gather(value, name, parts)),
        Json::String(written) if written.starts_with('{') => {
            if let Ok(frame) = Json::parse(written) {
                gather(&own(&frame), "", parts);
            }
        }
        _ => {}
    }
}

/// An array, a map or a string, longer.
fn grow(tree: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let is_frame = tree.get("kind").is_some_and(|kind| kind.as_str().is_some());
    // The one kind that may have more than 1 MiB.
    let is_large = string(tree, "kind") == Some("observation_frame");
    let all = places(tree);
    for _ in 0..8 {
        let place = &all[draw.below(all.len())];
        let name = name_at(tree, place).to_owned();
        if matches!(name.as_str(), "op" | "steps" | "requests" | "kind" | "call" | "base64") {
            continue;
        }
        let Some(target) = at_mut(tree, place) else { continue };
        return match target {
            Json::Array(items) => {
                let numbers = items.iter().all(|item| matches!(item, Json::Number(_)));
                let most = if numbers && draw.chance(10) { 70_000 } else { 4200 };
                let most = if draw.chance(60) { 300 } else { most };
                let count = draw.size(1, most);
                // A number is no more than a few bytes.
                let count = if numbers { count } else { draw.afford(count) };
                // As many more as a narrow count of them does not see.
                let count = if numbers && draw.chance(12) { draw.one(&[1 << 8, 1 << 8, 1 << 16]) } else { count };
                let item = if items.is_empty() { literal("1.0") } else { items[draw.below(items.len())].clone() };
                let place = draw.one(&[0, items.len() / 2, items.len()]);
                items.splice(place..place, std::iter::repeat_n(item, count));
                count
            }
            // What a call has no member for is no question of the protocol.
            Json::Object(_) if !is_frame && !MAPS.contains(&name.as_str()) => continue,
            Json::Object(members) => {
                let most = if draw.chance(70) { 300 } else { 4200 };
                let count = draw.size(1, most);
                let count = draw.afford(count);
                let value = if members.is_empty() { int(1) } else { members[draw.below(members.len())].1.clone() };
                let letter = draw.one(&['a', 'k', 'z', '~']);
                let more = (0..count).map(|nth| (format!("{letter}{nth}").into(), value.clone()));
                if draw.chance(50) {
                    members.extend(more);
                } else {
                    members.splice(0..0, more);
                }
                count
            }
            Json::String(word) => {
                let most = if draw.chance(85) { 300 } else { 70_000 };
                let count = draw.size(1, most);
                let count = if is_large && draw.chance(4) { draw.size(1 << 20, 3 << 20) } else { count };
                let more = draw.letters(count);
                let longer = match draw.below(3) {
                    0 => format!("{more}{word}"),
                    1 => format!("{word}{more}"),
                    _ => more,
                };
                *target = text(longer);
                count
            }
            _ => continue,
        };
    }
    0
}

/// What is named.
const NAMED: [&str; 12] = [
    "name",
    "channel",
    "population",
    "port",
    "target",
    "session_id",
    "frame_id",
    "session",
    "command_channel",
    "pattern",
    "key",
    "peer_hash",
];

/// Beside a name one that is nearly equal, with other numbers; in place of it, rarely.
fn twin(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let mut known: Vec<String> = Vec::new();
    names(args, "", &mut known);
    known.sort();
    known.dedup();
    if known.is_empty() {
        return 0;
    }
    let old = known[draw.below(known.len())].clone();
    let most = if draw.chance(25) { 1100 } else { 240 };
    let length = draw.size(1, most);
    let (one, two) = twins(&old, length, draw);
    let first = draw.chance(50);
    double_up(args, &old, &one, &two, first, "");
    length
}

/// Two names that are nearly equal; the first may be the given one.
fn twins(name: &str, length: usize, draw: &mut Draw<'_>) -> (String, String) {
    let filler = draw.one(&['x', 'a', '0']).to_string().repeat(length);
    match draw.below(12) {
        9 => {
            let mut marked = || format!("{name}{}1", draw.pick(&["-", "_", ".", " ", ":", "", "0", "+"]));
            (marked(), marked())
        }
        10 => (format!("{name}1"), draw.nearly(&format!("{name}1"))),
        0..=3 | 11 => (format!("{filler}{name}0"), format!("{filler}{name}1")),
        4 => (format!("{name}{filler}"), format!("{name}{filler}x")),
        5 => (format!("{name}\u{e9}"), format!("{name}e\u{301}")),
        6 => (name.to_owned(), draw.nearly(name)),
        7 => (name.to_owned(), format!("{name}{filler}")),
        _ => (format!("0{filler}{name}"), format!("1{filler}{name}")),
    }
}

/// The names that stand in arguments.
fn names(tree: &Tree, under: &str, known: &mut Vec<String>) {
    match tree {
        Json::Array(items) => items.iter().for_each(|item| names(item, under, known)),
        Json::Object(members) => {
            for (name, value) in members {
                if MAPS.contains(&under) {
                    known.push(name.to_string());
                }
                names(value, name, known);
            }
        }
        Json::String(written) if written.starts_with('{') => {
            if let Ok(frame) = Json::parse(written) {
                names(&own(&frame), "", known);
            }
        }
        Json::String(word) if NAMED.contains(&under) => known.push(word.to_string()),
        _ => {}
    }
}

/// Renames one name and sets another beside it, wherever it stands.
fn double_up(tree: &mut Tree, old: &str, one: &str, two: &str, first: bool, under: &str) {
    match tree {
        Json::Array(items) => {
            let is_named = |item: &Tree| {
                NAMED.iter().any(|member| string(item, member) == Some(old)) && matches!(item, Json::Object(_))
            };
            if let Some(place) = items.iter().position(is_named) {
                let mut beside = items[place].clone();
                rename(&mut beside, old, two);
                other_numbers(&mut beside);
                items.iter_mut().for_each(|item| double_up(item, old, one, two, first, under));
                items.insert(if first { 0 } else { items.len() }, beside);
            } else {
                items.iter_mut().for_each(|item| double_up(item, old, one, two, first, under));
            }
        }
        Json::Object(members) => {
            for (name, value) in members.iter_mut() {
                let inner = name.to_string();
                double_up(value, old, one, two, first, &inner);
            }
            if MAPS.contains(&under)
                && let Some(place) = members.iter().position(|(name, _)| name == old)
            {
                let mut beside = members[place].1.clone();
                other_numbers(&mut beside);
                members[place].0 = one.to_owned().into();
                members.insert(if first { 0 } else { members.len() }, (two.to_owned().into(), beside));
            }
        }
        Json::String(written) if written.starts_with('{') => {
            if let Ok(frame) = Json::parse(written) {
                let mut frame = own(&frame);
                double_up(&mut frame, old, one, two, first, "");
                *tree = text(frame.to_string());
            }
        }
        Json::String(word) if NAMED.contains(&under) && word == old => *tree = text(one),
        _ => {}
    }
}

/// Another name wherever one stands as the name of a thing.
fn rename(tree: &mut Tree, old: &str, new: &str) {
    if let Json::Object(members) = tree {
        for (name, value) in members {
            if NAMED.contains(&name.as_ref()) && value.as_str() == Some(old) {
                *value = text(new);
            }
        }
    }
}

/// Every double of a value, but for what says how large a thing is, another one.
fn other_numbers(tree: &mut Tree) {
    match tree {
        Json::Array(items) => items.iter_mut().for_each(other_numbers),
        Json::Object(members) => {
            let members = members.iter_mut().filter(|(name, _)| name != "component" && name != "size");
            members.for_each(|(_, value)| other_numbers(value));
        }
        Json::Number(spelling) if spelling.contains('.') => {
            let value: f64 = spelling.parse().unwrap_or(0.0);
            *tree = literal(format!("{:?}", value * 0.5 + 0.25));
        }
        _ => {}
    }
}

/// Two sessions of nearly equal ids in place of one, side by side.
fn twin_session(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let mut known: Vec<String> = Vec::new();
    let Some(requests) = steps_of(args) else { return 0 };
    for request in requests.iter() {
        let frame = request.as_str().and_then(|written| Json::parse(written).ok());
        known.extend(frame.as_ref().and_then(|frame| string(frame, "session_id")).map(str::to_owned));
    }
    known.sort();
    known.dedup();
    if known.is_empty() || requests.len() > 200 {
        return 0;
    }
    let old = known[draw.below(known.len())].clone();
    let length = draw.size(1, 250);
    let (one, two) = twins(&old, length, draw);
    let with = |new: &str, values: bool| -> Vec<Tree> {
        let renamed = |request: &Tree| {
            let Some(frame) = request.as_str().and_then(|written| Json::parse(written).ok()) else {
                return request.clone();
            };
            let mut frame = own(&frame);
            if string(&frame, "session_id") == Some(&old) {
                set(&mut frame, "session_id", text(new));
                if values && let Json::Object(members) = &mut frame {
                    members.iter_mut().filter(|(name, _)| name == "stimulus").for_each(|(_, v)| other_numbers(v));
                }
            }
            text(frame.to_string())
        };
        requests.iter().map(renamed).collect()
    };
    let (mut first, mut second) = (with(&one, false).into_iter(), with(&two, true).into_iter());
    let mut both = Vec::new();
    let turns = draw.one(&[50, 80, 20]);
    loop {
        let next = if draw.chance(turns) { first.next() } else { second.next() };
        match next {
            Some(request) => both.push(request),
            None => break,
        }
    }
    both.extend(first);
    both.extend(second);
    *requests = both;
    // Where a request says at which key it comes, it says so for as many.
    if let Json::Object(members) = args {
        members.retain(|(name, _)| name != "verbs");
    }
    length
}

/// Changes every double under its name; what is no double stays.
fn each_double(tree: &mut Tree, change: &mut dyn FnMut(&str, f64) -> Option<f64>) {
    fn walk(tree: &mut Tree, under: &str, written: bool, change: &mut dyn FnMut(&str, f64) -> Option<f64>) {
        match tree {
            Json::Array(items) => items.iter_mut().for_each(|item| walk(item, under, written, change)),
            Json::Object(members) => {
                members.iter_mut().for_each(|(name, value)| {
                    let name = name.to_string();
                    walk(value, &name, written, change);
                });
            }
            Json::Number(spelling) => {
                if let Some(new) = spelling.parse().ok().and_then(|value| change(under, value))
                    && new.is_finite()
                {
                    *tree = if written { spelled(new) } else { num(new) };
                }
            }
            Json::String(frame) if frame.starts_with('{') => {
                if let Ok(frame) = Json::parse(frame) {
                    let mut frame = own(&frame);
                    walk(&mut frame, "", true, change);
                    *tree = text(frame.to_string());
                }
            }
            _ => {}
        }
    }
    walk(tree, "", false, change);
}

/// Changes every seq.
fn each_seq(tree: &mut Tree, change: &mut dyn FnMut(i64) -> i64) {
    match tree {
        Json::Array(items) => items.iter_mut().for_each(|item| each_seq(item, change)),
        Json::Object(members) => {
            for (name, value) in members {
                match integer(Some(value)) {
                    Some(seq) if name == "seq" => *value = int(change(seq)),
                    _ => each_seq(value, change),
                }
            }
        }
        Json::String(written) if written.starts_with('{') => {
            let Some(mut frame) = Json::parse(written).ok().map(|frame| own(&frame)) else { return };
            let before = frame.clone();
            each_seq(&mut frame, change);
            if frame != before {
                *tree = text(frame.to_string());
            }
        }
        _ => {}
    }
}

/// Changes every string that holds a frame, well-formed or not.
fn each_frame(tree: &mut Tree, change: &mut dyn FnMut(&str) -> String) {
    match tree {
        Json::Array(items) => items.iter_mut().for_each(|item| each_frame(item, change)),
        Json::Object(members) => members.iter_mut().for_each(|(_, value)| each_frame(value, change)),
        Json::String(written) if written.starts_with('{') => *tree = text(change(written)),
        _ => {}
    }
}

/// A frame spelled otherwise, or with something in front that nobody reads.
fn spell(frame: &str, draw: &mut Draw<'_>) -> String {
    match Json::parse(frame) {
        Ok(parsed) if draw.chance(60) => wild(&own(&parsed), draw),
        _ => {
            let name = draw.pick(&["pad", "x", "0", "~", "Mode", "seq2"]);
            let rest = frame.strip_prefix('{').unwrap_or(frame).trim_start();
            let comma = if rest.starts_with('}') { "" } else { "," };
            format!("{{\"{name}\":{}{comma}{rest}", unknown(draw))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::generate::tests::whole_menu;
    use crate::fuzz::harvest::Harvest;
    use crate::fuzz::tree::list;
    use ncp_peer_rust::Answer;

    fn seeds() -> Seeds {
        Seeds::of(&Suite::embedded().unwrap(), &whole_menu())
    }

    #[test]
    fn a_varied_case_is_the_same_for_a_seed_and_mostly_still_a_question() {
        let (seeds, harvest) = (seeds(), Harvest::default());
        for call in Call::ALL.iter().copied().filter(|call| *call != Call::Describe) {
            let mut internal = 0;
            for number in 0..120 {
                let vary = || seeds.vary(call, &mut Draw::new(7, number, &harvest)).unwrap();
                let one = vary();
                assert_eq!((&one.args, &one.keys), (&vary().args, &vary().keys), "{call:?} {number}");
                let answer = ncp_peer_rust::ask(call.as_str(), &one.args.to_string());
                internal += usize::from(matches!(answer, Answer::Error { code, .. } if code == "internal"));
            }
            assert!(internal < 60, "{call:?}: {internal} of 120 are no questions");
        }
    }

    #[test]
    fn arguments_grow_in_their_maps_and_get_no_member_that_no_call_has() {
        let harvest = Harvest::default();
        let grown = |written: &str, number: u64| {
            let mut args = own(&Json::parse(written).unwrap());
            grow(&mut args, &mut Draw::new(4, number, &harvest));
            args
        };
        let codec = r#"{"codec":{"encoders":[],"decoders":[]},"rates":{"p":1.0}}"#;
        let mut rates = 0;
        for number in 0..80 {
            let args = grown(codec, number);
            let count = |tree: Option<&Tree>| crate::fuzz::tree::members(tree).len();
            assert_eq!((count(Some(&args)), count(args.get("codec"))), (2, 2), "{args}");
            rates += usize::from(count(args.get("rates")) > 1);
        }
        assert!(rates > 10, "{rates}");
    }

    #[test]
    fn a_pumped_step_goes_on_in_time_and_in_seq_and_so_does_what_follows() {
        let trace = |seqs: &[i64]| {
            let step = |seq: &i64| {
                crate::fuzz::tree::object([("op", text("command")), ("now_s", num(*seq as f64)), ("seq", int(*seq))])
            };
            crate::fuzz::tree::object([("steps", list(seqs.iter().map(step).collect()))])
        };
        let harvest = Harvest::default();
        let (mut longest, mut going_on) = (0, 0);
        for number in 0..200 {
            let mut args = trace(&[1, 2, 3]);
            pump(&mut args, None, &mut Draw::new(1, number, &harvest));
            let steps = items(args.get("steps"));
            let clocks: Vec<f64> = steps.iter().filter_map(clock_of).collect();
            let seqs: Vec<i64> = steps.iter().flat_map(seqs_of).collect();
            longest = longest.max(clocks.len());
            assert!(clocks.len() > 3);
            let rises = clocks.windows(2).all(|two| two[0] < two[1]) && seqs.windows(2).all(|two| two[0] < two[1]);
            going_on += usize::from(rises);
        }
        // In a third of them both go on; elsewhere the clock stands, the seq repeats itself, or what follows is late.
        assert!(longest > 100 && going_on > 50, "{longest} {going_on}");
        let mut step = trace(&[5]);
        later(&mut step, 0.5, 3);
        assert_eq!(step, {
            let mut wanted = trace(&[8]);
            each_double(&mut wanted, &mut |name, _| (name == "now_s").then_some(5.5));
            wanted
        });
    }

    #[test]
    fn resets_come_in_a_row_as_often_as_a_byte_counts_and_take_no_step_away() {
        let harvest = Harvest::default();
        let mut counts = HashSet::new();
        for number in 0..80 {
            let step = |name: &str| crate::fuzz::tree::object([("op", text(name))]);
            let mut args = crate::fuzz::tree::object([("steps", list(vec![step("command"), step("active")]))]);
            let count = resets(&mut args, &mut Draw::new(4, number, &harvest));
            let is_reset = |step: &&Tree| string(step, "op") == Some("reset");
            let steps = items(args.get("steps"));
            assert_eq!((steps.iter().filter(is_reset).count(), steps.len()), (count, count + 2));
            assert_eq!(string(&steps[0], "op"), Some("command"));
            counts.insert(count);
        }
        assert!([16, 255, 256, 257, 1 << 16].iter().all(|count| counts.contains(count)), "{counts:?}");
    }

    #[test]
    fn a_twin_of_a_session_runs_beside_it() {
        let request = |kind: &str| text(format!("{{\"kind\":\"{kind}\",\"session_id\":\"a\"}}"));
        let requests = || list(vec![request("open_session"), request("step_request"), request("close_session")]);
        let harvest = Harvest::default();
        let mut args = crate::fuzz::tree::object([("requests", requests())]);
        twin_session(&mut args, &mut Draw::new(3, 1, &harvest));
        let ids: std::collections::BTreeSet<String> = items(args.get("requests"))
            .iter()
            .filter_map(|request| Json::parse(request.as_str()?).ok().map(|frame| own(&frame)))
            .filter_map(|frame| string(&frame, "session_id").map(str::to_owned))
            .collect();
        assert_eq!((items(args.get("requests")).len(), ids.len()), (6, 2), "{args}");
    }

    #[test]
    fn an_adapter_gets_numbers_as_the_protocol_spells_them() {
        let spelled = |args: &str| {
            let mut tree = own(&Json::parse(args).unwrap());
            spell_plainly(&mut tree, "");
            tree.to_string()
        };
        let long = "0".repeat(4304);
        let asked = format!(r#"{{"times":[-0,-0.0,1],"senders":["7","{long}"],"seq":-0,"key":"{long}"}}"#);
        let short = "0".repeat(40);
        let then = format!(r#"{{"times":[-0.0,-0.0,1],"senders":["7","{short}"],"seq":0,"key":"{long}"}}"#);
        assert_eq!(spelled(&asked), then);
        let frame = r#"{"text":"{\"channels\":{\"a\":{\"data\":[-0]}}}"}"#;
        assert_eq!(spelled(frame), frame);
    }
}
