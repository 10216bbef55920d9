//! Every string and number of the dictionary, once in every place where one of its kind may stand.
//!
//! A value that switches a check off is found only if it is tried where the check is, by a request that the check
//! would refuse or change. Drawn at random, a dictionary of a thousand strings is tried too thinly for that. So the
//! cases of the corpus teach which members there are, and each value goes into each of them, in a few cases that are
//! about different rules: in place of what stands there, or added where the case leaves the member out. What the text
//! has no word of comes first, since that is what a back door is made of.
//!
//! A limit that nothing exceeds shows nothing. So those cases come first whose answer is another one where the number
//! is boundless, and a number is tried alone, and again with all that is measured in the same way scaled with it.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::sync::LazyLock;

use ncp_text::tables::{Shape, tables};

use super::generate::{Input, Seeds};
use super::harvest::{Harvest, is_rare_number, is_rare_word};
use super::oracle;
use super::rules::fnv;
use super::tree::{MAPS, Tree, int, literal, num, own, spelled, text};
use crate::json::Json;
use crate::peer::Call;

/// In how many cases each value is tried at a place of a trace, which has more to switch off, and of all else.
const OF_A_TRACE: usize = 24;
const OF_ONE_ANSWER: usize = 6;
/// How many bytes the arguments of such a case may have.
const SMALL: usize = 4 << 10;
/// How many items of an array are looked at.
const ITEMS: usize = 64;
/// Of how many cases these are chosen.
const CANDIDATES: usize = 80;
/// More than any limit of a case.
const LIMITLESS: f64 = 1e9;
/// Members that say what is asked, and not of what.
const SELECTORS: [&str; 4] = ["op", "kind", "plane", "base64"];

/// A place where a value may stand, by the way to what it is in.
#[derive(Debug, Clone)]
struct Slot {
    call: Call,
    /// The way to the object or the array, as a number.
    holder: u64,
    place: Place,
    takes: Takes,
    /// Cases that have such a holder, by their place in [`Sweep::cases`].
    cases: Vec<usize>,
}

/// Where in an object or an array.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    /// The member of this name.
    Member(String),
    /// The name of an entry of a map.
    Entry,
    /// An item of an array.
    Item,
}

/// What may stand at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Takes {
    Word,
    Double,
    Integer,
}

/// How a value is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Manner {
    /// There alone.
    Alone,
    /// And all that is called or measured the same with it.
    Together,
    /// A word in front of the one that stands there.
    Joined,
}

/// Values of one kind in the cases of one rank.
#[derive(Debug, Clone)]
struct Block {
    /// How many inputs there are before it.
    before: u64,
    words: bool,
    /// From which value to which.
    values: (usize, usize),
    /// Each slot with a case, by their places in the sweep.
    tried: Vec<(usize, usize)>,
    manner: Manner,
}

/// All that is to be tried, in order.
#[derive(Debug, Clone, Default)]
pub(super) struct Sweep {
    cases: Vec<Tree>,
    slots: Vec<Slot>,
    words: Vec<String>,
    numbers: Vec<f64>,
    blocks: Vec<Block>,
    length: u64,
}

impl Sweep {
    /// What a dictionary gives to try in cases of the corpus; nothing, if it is empty.
    pub(super) fn new(seeds: &Seeds, harvest: &Harvest) -> Self {
        let mut sweep = Self::default();
        if harvest.is_empty() {
            return sweep;
        }
        for (call, rules) in seeds.by_rule() {
            sweep.learn(call, rules);
        }
        let (words, rare_words) = ordered(&harvest.words, |word| {
            // What has a digit is rarely the name of a function.
            (!is_rare_word(word), !word.contains(|c: char| c.is_ascii_digit()))
        });
        let (numbers, rare_numbers) = ordered(&harvest.numbers, |number| (!is_rare_number(*number), false));
        let tiers = [((0, rare_words), (0, rare_numbers)), ((rare_words, words.len()), (rare_numbers, numbers.len()))];
        (sweep.words, sweep.numbers) = (words, numbers);
        for (words, numbers) in tiers {
            for round in 0..OF_ONE_ANSWER {
                for of in [Sort::Question, Sort::Trace, Sort::Frame] {
                    for manner in [Manner::Alone, Manner::Together] {
                        sweep.plan(of, false, numbers, round, manner);
                    }
                    for manner in [Manner::Alone, Manner::Together, Manner::Joined] {
                        sweep.plan(of, true, words, round, manner);
                    }
                }
            }
        }
        sweep
    }

    /// How many inputs there are.
    pub(super) fn len(&self) -> u64 {
        self.length
    }

    /// The input at this place; none, if the value changes nothing there.
    pub(super) fn input(&self, at: u64) -> Option<Input> {
        let block = self.blocks.partition_point(|block| block.before <= at).checked_sub(1)?;
        let block = self.blocks.get(block)?;
        let within = usize::try_from(at - block.before).ok()?;
        let value = block.values.0 + within / block.tried.len();
        let (slot, case) = block.tried.get(within % block.tried.len())?;
        let (slot, case) = (self.slots.get(*slot)?, self.cases.get(*case)?);
        let value =
            if block.words { Value::Word(self.words.get(value)?) } else { Value::Number(*self.numbers.get(value)?) };
        let mut args = case.clone();
        let mut put = Put { slot, value, manner: block.manner, old: None, is_done: false };
        put.walk(&mut args, root(slot.call), "", false);
        if !put.is_done {
            return None;
        }
        if block.manner == Manner::Joined && !matches!(put.old, Some(Json::String(_))) {
            return None;
        }
        // An entry that is renamed alone says as much.
        if block.manner == Manner::Together
            && together(&mut args, &put.old?, value, slot).is_none()
            && slot.place != Place::Entry
        {
            return None;
        }
        (args != *case).then_some(Input { call: slot.call, args })
    }

    /// Takes the places of a call's cases in, and which cases show them.
    fn learn(&mut self, call: Call, rules: &[(String, Vec<Tree>)]) {
        let mut places: BTreeSet<(u64, Place, Takes)> = BTreeSet::new();
        // For each holder, the cases that have it, with the rule that each is about.
        let mut shown: BTreeMap<u64, Vec<(usize, usize)>> = BTreeMap::new();
        for (nth, (_, cases)) in rules.iter().enumerate() {
            for case in cases {
                if case.to_string().len() > SMALL {
                    continue;
                }
                let mut found = Places::default();
                found.walk(case, root(call), "", false);
                for holder in &found.holders {
                    shown.entry(*holder).or_default().push((nth, self.cases.len()));
                }
                places.append(&mut found.places);
                self.cases.push(case.clone());
            }
        }
        let most = if sort(call) == Sort::Trace { OF_A_TRACE } else { OF_ONE_ANSWER };
        let spread: BTreeMap<u64, Vec<usize>> =
            shown.into_iter().map(|(holder, cases)| (holder, spread(&cases, CANDIDATES))).collect();
        for (holder, place, takes) in places {
            let cases = spread.get(&holder).cloned().unwrap_or_default();
            let mut slot = Slot { call, holder, place, takes, cases };
            if takes != Takes::Word {
                let mut cases = std::mem::take(&mut slot.cases);
                cases.sort_by_cached_key(|case| !self.binds(&slot, *case));
                slot.cases = cases;
            }
            slot.cases.truncate(most);
            self.slots.push(slot);
        }
    }

    /// Whether a case answers otherwise where this number is so large that it limits nothing.
    fn binds(&self, slot: &Slot, case: usize) -> bool {
        let Some(case) = self.cases.get(case) else { return false };
        let mut args = case.clone();
        let value = Value::Number(LIMITLESS);
        let mut put = Put { slot, value, manner: Manner::Alone, old: None, is_done: false };
        put.walk(&mut args, root(slot.call), "", false);
        let answer = |args: &Tree| oracle::specification(slot.call, &args.to_string());
        put.is_done && answer(&args) != answer(case)
    }

    /// Adds what one round tries: of each place of a trace some cases, of the others one.
    fn plan(&mut self, of: Sort, words: bool, values: (usize, usize), round: usize, manner: Manner) {
        const EACH: usize = OF_A_TRACE / OF_ONE_ANSWER;
        let ranks = |slot: &Slot| match sort(slot.call) {
            Sort::Trace => round * EACH..(round + 1) * EACH,
            Sort::Question | Sort::Frame => round..round + 1,
        };
        let fits = |(_, slot): &(usize, &Slot)| (slot.takes == Takes::Word) == words && sort(slot.call) == of;
        let tried = self.slots.iter().enumerate().filter(fits);
        let tried = tried.flat_map(|(at, slot)| {
            ranks(slot).filter_map(move |rank| slot.cases.get(rank)).map(move |case| (at, *case))
        });
        let tried: Vec<(usize, usize)> = tried.collect();
        let count = (values.1 - values.0) as u64 * tried.len() as u64;
        if count > 0 {
            self.blocks.push(Block { before: self.length, words, values, tried, manner });
            self.length += count;
        }
    }
}

/// What a call is, for the order: frames have the most places, and the least to switch off in each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sort {
    Question,
    Trace,
    Frame,
}

fn sort(call: Call) -> Sort {
    use Call::{BufferRun, Decode, Encode, GovernorRun, LinkRun, LoopRun, ReplyCheck, SessionRun, WatchdogRun};
    match call {
        BufferRun | GovernorRun | LinkRun | LoopRun | SessionRun | WatchdogRun => Sort::Trace,
        Decode | Encode | ReplyCheck => Sort::Frame,
        _ => Sort::Question,
    }
}

/// Of these cases, each with its rule, so many that are about different rules; of one rule, from all of them.
fn spread(cases: &[(usize, usize)], most: usize) -> Vec<usize> {
    let mut by_rule: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (rule, case) in cases {
        by_rule.entry(*rule).or_default().push(*case);
    }
    let mut rules: Vec<Vec<usize>> = by_rule.into_values().collect();
    // What is asked most is most of what there is to switch off.
    rules.sort_by_key(|cases| std::cmp::Reverse(cases.len()));
    let mut chosen = Vec::new();
    for turn in 0..most {
        for cases in &rules {
            let at = turn * cases.len() / most;
            if chosen.len() < most && !chosen.contains(&cases[at]) {
                chosen.push(cases[at]);
            }
        }
    }
    chosen
}

/// Values in the order of their class, by their place within each; and of how many the first of it does not hold.
fn ordered<T: Clone>(values: &[T], class: impl Fn(&T) -> (bool, bool)) -> (Vec<T>, usize) {
    let mut classed: Vec<((bool, bool), T)> = values.iter().map(|value| (class(value), value.clone())).collect();
    classed.sort_by_key(|(class, _)| *class);
    let first = classed.iter().filter(|((is_last, _), _)| !is_last).count();
    (classed.into_iter().map(|(_, value)| value).collect(), first)
}

/// A value of the dictionary.
#[derive(Debug, Clone, Copy)]
enum Value<'v> {
    Word(&'v str),
    Number(f64),
}

/// The way to the arguments of a call.
fn root(call: Call) -> u64 {
    fnv(0, call.as_str())
}

/// The way to what is within an object: that it is of a kind, or a step of one, is part of it.
fn inside(way: u64, members: &[(Cow<'_, str>, Tree)]) -> u64 {
    let selectors = members.iter().filter(|(name, _)| SELECTORS.contains(&name.as_ref()));
    selectors.fold(way, |way, (name, value)| match value.as_str() {
        Some(word) if name != "kind" || tables().kind(word).is_some() => fnv(fnv(way, name), word),
        _ => way,
    })
}

/// The frame that a string holds.
fn frame_in(written: &str) -> Option<Tree> {
    Json::parse(written.starts_with('{').then_some(written)?).ok().map(|frame| own(&frame))
}

/// The objects and arrays of some arguments, and what may stand in them.
#[derive(Default)]
struct Places {
    holders: BTreeSet<u64>,
    places: BTreeSet<(u64, Place, Takes)>,
}

impl Places {
    fn walk(&mut self, tree: &Tree, way: u64, under: &str, written: bool) {
        match tree {
            Json::Array(items) => {
                let way = fnv(way, "[]");
                self.holders.insert(way);
                for item in items.iter().take(ITEMS) {
                    self.places.extend(takes(item, under).map(|takes| (way, Place::Item, takes)));
                    self.walk(item, way, under, written);
                }
            }
            Json::Object(members) => {
                let (is_map, way) = (MAPS.contains(&under), inside(way, members));
                self.holders.insert(way);
                for (name, value) in members {
                    let name = name.as_ref();
                    // What no table has is read by nobody.
                    if written && !is_map && !is_a_field(name) {
                        continue;
                    }
                    if is_map {
                        self.places.insert((way, Place::Entry, Takes::Word));
                    } else if !SELECTORS.contains(&name) {
                        self.places
                            .extend(takes(value, name).map(|takes| (way, Place::Member(name.to_owned()), takes)));
                    }
                    let inner = if is_map { "*" } else { name };
                    self.walk(value, fnv(way, inner), inner, written);
                }
            }
            Json::String(frame) => {
                if let Some(frame) = frame_in(frame) {
                    self.walk(&frame, fnv(way, "{}"), "", true);
                }
            }
            _ => {}
        }
    }
}

fn is_a_field(name: &str) -> bool {
    static FIELDS: LazyLock<HashSet<&str>> = LazyLock::new(|| {
        tables().all_messages().flat_map(|message| &message.fields).map(|field| field.name.as_str()).collect()
    });
    FIELDS.contains(name)
}

/// What may stand where this value stands.
fn takes(value: &Tree, name: &str) -> Option<Takes> {
    match value {
        Json::String(word) if matches!(word.as_ref(), "NaN" | "Infinity" | "-Infinity" | "-0") => Some(Takes::Double),
        Json::String(word) if !word.starts_with('{') => Some(Takes::Word),
        Json::Number(spelling) => Some(if is_double(spelling, name) { Takes::Double } else { Takes::Integer }),
        _ => None,
    }
}

fn is_double(spelling: &str, name: &str) -> bool {
    static DOUBLES: LazyLock<HashSet<&str>> = LazyLock::new(|| {
        let is_number = |shape: &Shape| match shape {
            Shape::List(inner) | Shape::Map(inner) => matches!(**inner, Shape::Number),
            shape => matches!(shape, Shape::Number),
        };
        let fields = tables().all_messages().flat_map(|message| &message.fields);
        fields.filter(|field| is_number(&field.shape)).map(|field| field.name.as_str()).collect()
    });
    spelling.contains(['.', 'e', 'E']) || DOUBLES.contains(name)
}

/// Sets a value at a place, wherever the arguments have it.
struct Put<'p> {
    slot: &'p Slot,
    value: Value<'p>,
    manner: Manner,
    /// What stood there first.
    old: Option<Tree>,
    is_done: bool,
}

impl Put<'_> {
    fn walk(&mut self, tree: &mut Tree, way: u64, under: &str, written: bool) {
        match tree {
            Json::Array(items) => {
                let way = fnv(way, "[]");
                items.iter_mut().take(ITEMS).for_each(|item| self.walk(item, way, under, written));
                if way == self.slot.holder && self.slot.place == Place::Item {
                    items.iter_mut().take(ITEMS).for_each(|item| self.replace(item, written));
                }
            }
            Json::Object(members) => {
                let (is_map, way) = (MAPS.contains(&under), inside(way, members));
                for (name, value) in members.iter_mut() {
                    let inner = if is_map { "*" } else { name.as_ref() };
                    self.walk(value, fnv(way, inner), inner, written);
                }
                if way == self.slot.holder {
                    self.set(members, written);
                }
            }
            Json::String(frame) => {
                if let Some(mut frame) = frame_in(frame) {
                    let before = frame.clone();
                    self.walk(&mut frame, fnv(way, "{}"), "", true);
                    if frame != before {
                        *tree = text(frame.to_string());
                    }
                }
            }
            _ => {}
        }
    }

    fn set(&mut self, members: &mut Vec<(Cow<'static, str>, Tree)>, written: bool) {
        match (&self.slot.place, self.value) {
            (Place::Entry, Value::Word(word)) => {
                if members.iter().any(|(name, _)| name == word) {
                    return;
                }
                // Beside what is there, or in its place.
                let Some((name, value)) = members.first_mut() else { return };
                if self.manner != Manner::Alone {
                    self.old.get_or_insert(text(name.to_string()));
                    let rest = if self.manner == Manner::Joined { name.as_ref() } else { "" };
                    *name = format!("{word}{rest}").into();
                } else {
                    let value = value.clone();
                    members.push((word.to_owned().into(), value));
                }
                self.is_done = true;
            }
            (Place::Member(member), _) => match members.iter_mut().find(|(name, _)| name == member) {
                Some((_, value)) => self.replace(value, written),
                None => {
                    if let Some(new) = self.value_spelled(written) {
                        members.push((member.clone().into(), new));
                        self.is_done = true;
                    }
                }
            },
            _ => {}
        }
    }

    /// Sets the value in place of what stood there first, and of its equals; others may be there to differ from it.
    fn replace(&mut self, value: &mut Tree, written: bool) {
        let old = self.old.get_or_insert_with(|| value.clone());
        if value == old
            && let Some(new) = self.value_spelled(written)
        {
            *value = match (self.manner, value.as_str(), new.as_str()) {
                (Manner::Joined, Some(old), Some(new)) => text(format!("{new}{old}")),
                _ => new,
            };
            self.is_done = true;
        }
    }

    fn value_spelled(&self, written: bool) -> Option<Tree> {
        Some(match (self.value, self.slot.takes) {
            (Value::Word(word), _) => text(word),
            (Value::Number(value), Takes::Integer) => int(whole(value)?),
            (Value::Number(value), _) if written => spelled(value),
            (Value::Number(value), _) => num(value),
        })
    }
}

/// A number as an integer of the wire.
fn whole(value: f64) -> Option<i64> {
    #[expect(clippy::cast_possible_truncation, reason = "it is within the wire's integers")]
    (value.fract() == 0.0 && value.abs() <= super::draw::LARGEST as f64).then_some(value as i64)
}

/// Renames or scales the rest: all that bore the old name, or all doubles that are measured as the member is. None, if
/// there is no rest.
fn together(args: &mut Tree, old: &Tree, new: Value<'_>, slot: &Slot) -> Option<()> {
    let mut changed = 0_usize;
    match (old, new) {
        (Json::String(old), Value::Word(new)) => rename(args, old, new, &mut changed),
        (Json::Number(old), Value::Number(new)) => {
            let old: f64 = old.parse().ok()?;
            let ratio = new / old;
            if !ratio.is_finite() || ratio == 0.0 || slot.takes != Takes::Double {
                return None;
            }
            let is_time = matches!(&slot.place, Place::Member(name) if is_time(name));
            scale(args, "", false, new, ratio, is_time, &mut changed);
        }
        _ => return None,
    }
    (changed > 0).then_some(())
}

fn rename(tree: &mut Tree, old: &str, new: &str, changed: &mut usize) {
    match tree {
        Json::Array(items) => items.iter_mut().for_each(|item| rename(item, old, new, changed)),
        Json::Object(members) => {
            let is_taken = members.iter().any(|(name, _)| name == new);
            for (name, value) in members {
                if name == old && !is_taken {
                    *name = new.to_owned().into();
                    *changed += 1;
                }
                if !SELECTORS.contains(&name.as_ref()) {
                    rename(value, old, new, changed);
                }
            }
        }
        Json::String(word) if word == old => {
            *tree = text(new);
            *changed += 1;
        }
        Json::String(written) => {
            if let Some(mut frame) = frame_in(written) {
                let before = *changed;
                rename(&mut frame, old, new, changed);
                if *changed > before {
                    *tree = text(frame.to_string());
                }
            }
        }
        _ => {}
    }
}

/// Whether a member of this name is a time or a duration.
fn is_time(name: &str) -> bool {
    matches!(name, "t" | "now" | "times" | "dt" | "at") || name.ends_with("_ms") || name.ends_with("_s")
}

/// Every double that is measured like this, times a ratio; the new value itself stays.
fn scale(tree: &mut Tree, under: &str, written: bool, new: f64, ratio: f64, times: bool, changed: &mut usize) {
    match tree {
        Json::Array(items) => {
            items.iter_mut().for_each(|item| scale(item, under, written, new, ratio, times, changed));
        }
        Json::Object(members) => {
            for (name, value) in members {
                let name = if name.as_ref() == "data" { under.to_owned() } else { name.to_string() };
                scale(value, &name, written, new, ratio, times, changed);
            }
        }
        Json::Number(spelling) => {
            let value: f64 = spelling.parse().unwrap_or(0.0);
            let is_like = is_time(under) == times && (is_double(spelling, under) || times);
            let scaled = value * ratio;
            if !is_like || value == new || value == 0.0 || !scaled.is_finite() {
                return;
            }
            *changed += 1;
            *tree = match whole(scaled) {
                Some(whole) if !spelling.contains(['.', 'e', 'E']) => int(whole),
                _ if written => literal(format!("{scaled:?}")),
                _ => num(scaled),
            };
        }
        Json::String(frame) => {
            if let Some(mut frame) = frame_in(frame) {
                let before = *changed;
                scale(&mut frame, "", true, new, ratio, times, changed);
                if *changed > before {
                    *tree = text(frame.to_string());
                }
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use ncp_peer_rust::Answer;

    use super::*;
    use crate::fuzz::menu;
    use crate::suite::{Pattern, Suite};
    use ncp_text::catalogue::{Level, Role};

    /// The sweep of the cases that fit.
    fn sweep(pattern: &str, words: &[&str], numbers: &[f64]) -> Sweep {
        let menu = menu(&Role::ALL, Level::Strict, true, &[Pattern::new(pattern)]);
        let seeds = Seeds::of(&Suite::embedded().unwrap(), &menu);
        let words = words.iter().map(|word| (*word).to_owned()).collect();
        Sweep::new(&seeds, &Harvest { words, numbers: numbers.to_vec(), is_light: false })
    }

    #[test]
    fn without_a_dictionary_there_is_nothing_to_sweep() {
        assert_eq!(sweep("key.build", &[], &[]).len(), 0);
    }

    #[test]
    fn a_word_that_the_text_lacks_comes_before_one_that_it_has() {
        let sweep = sweep("key.build", &["hold", "a message for people", "xyzzy"], &[]);
        assert_eq!(sweep.words[0], "xyzzy");
    }

    #[test]
    fn every_input_holds_its_value_and_is_what_the_protocol_allows() {
        let sweep = sweep("*", &["xyzzy"], &[1234.5, 77.0]);
        let (mut made, mut internal) = (0, 0);
        // Every seventh of them, which meets each place and each manner.
        for at in (0..sweep.len()).step_by(7) {
            let Some(input) = sweep.input(at) else { continue };
            let written = input.args.to_string();
            assert!(["xyzzy", "1234.5", "77"].iter().any(|value| written.contains(value)), "{at}: {written}");
            made += 1;
            internal += usize::from(matches!(
                oracle::specification(input.call, &written),
                Answer::Error { code, .. } if code == "internal"
            ));
        }
        assert!(made > 1000, "{made}");
        assert!(internal * 4 < made, "{internal} of {made} are no question");
    }

    #[test]
    fn a_word_is_tried_in_a_frame_that_leaves_the_member_out_and_at_an_entry_of_a_map() {
        let sweep = sweep("governor.run", &["xyzzy"], &[]);
        let inputs: Vec<String> =
            (0..sweep.len()).filter_map(|at| sweep.input(at)).map(|input| input.args.to_string()).collect();
        for part in ["\"frame_id\":\"xyzzy\"", "\"channels\":{\"xyzzy\":"] {
            assert!(inputs.iter().any(|input| input.contains(part)), "{part}");
        }
    }

    #[test]
    fn a_limit_is_tried_with_what_it_limits_scaled() {
        let mut args = own(&Json::parse(r#"{"limit":10.0,"ttl_ms":200,"v":{"data":[30.0]},"seq":3}"#).unwrap());
        scale(&mut args, "", false, 20.0, 2.0, false, &mut 0);
        assert_eq!(args.to_string(), r#"{"limit":20.0,"ttl_ms":200,"v":{"data":[60.0]},"seq":3}"#);
    }
}
