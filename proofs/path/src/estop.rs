//! The scanner for ESTOPs, against an automaton that reads JSON by its grammar and the rule by its words.

use std::collections::{BTreeMap, BTreeSet, HashMap, VecDeque};
use std::rc::Rc;

use crate::engine::{Case, Counterexample, Harness, Outcome, PANICS, Scope, every};
use crate::subject::Stopping;

/// The harness of a claim.
#[must_use]
pub fn run<S: Stopping>(id: &str) -> Option<Harness> {
    match id {
        "estop/bytes" => Some(|scope| every(scope, bytes::<S>)),
        "estop/edits" => Some(|scope| every(scope, edits::<S>)),
        "estop/tokens" => Some(tokens::<S>),
        "estop/transitions" => Some(transitions::<S>),
        _ => None,
    }
}

/// What NCP-RES-022 says of bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Says {
    /// An ESTOP.
    Latches,
    /// A JSON object that is none.
    LatchesNot,
    /// No JSON object in UTF-8, or one of two kinds: left open.
    Open,
}

/// Where the automaton is within a value; strings and numbers as RFC 8259 has them.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum At {
    /// Before the object.
    Start,
    /// Where a value is due.
    Value,
    /// Where a value is due, or the end of an array.
    FirstItem,
    /// Where a name is due, or the end of an object.
    FirstName,
    /// Where a name is due.
    Name,
    /// Behind a name.
    Colon,
    /// Behind a value.
    Behind,
    /// Within a string, which may be a name.
    Within {
        is_name: bool,
    },
    /// Behind a backslash.
    Escape {
        is_name: bool,
    },
    /// Behind `\u` and so many digits.
    Unit {
        is_name: bool,
        digits: u8,
        value: u16,
    },
    Minus,
    Zero,
    Whole,
    Dot,
    Fraction,
    Exponent,
    Sign,
    Power,
    /// Within `true`, `false` or `null`, with this still to come.
    Word(&'static [u8]),
    /// Behind the object.
    End,
}

/// The automaton: where it is, what is open, and what it has seen of the outermost object.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct Automaton {
    at: At,
    /// Whether each open bracket is that of an object.
    open: Vec<bool>,
    /// The string of the outermost object that is being read, or was read last: as much of it as may still be one of
    /// the words.
    string: Option<Vec<u8>>,
    /// The name of the member that is being read.
    name: Option<&'static [u8]>,
    /// Members `kind`: one of value `command_frame`, one of another.
    kinds: (bool, bool),
    /// A member `mode` of value `estop`.
    mode: bool,
}

const KIND: &[u8] = b"kind";
const MODE: &[u8] = b"mode";
const COMMAND: &[u8] = b"command_frame";
const ESTOP: &[u8] = b"estop";
const WORDS: [&[u8]; 4] = [KIND, MODE, COMMAND, ESTOP];

impl Automaton {
    const fn new() -> Self {
        Self { at: At::Start, open: Vec::new(), string: None, name: None, kinds: (false, false), mode: false }
    }

    /// Whether what is read belongs to the outermost object itself.
    fn is_outermost(&self) -> bool {
        self.open.len() == 1
    }

    /// The next byte; none where no JSON object begins so.
    fn next(mut self, byte: u8) -> Option<Self> {
        let is_space = matches!(byte, b' ' | b'\t' | b'\n' | b'\r');
        self.at = match self.at {
            At::Start if is_space => At::Start,
            At::Start if byte == b'{' => {
                self.open.push(true);
                At::FirstName
            }
            At::Value | At::FirstItem | At::FirstName | At::Name | At::Colon | At::Behind | At::End if is_space => {
                self.at
            }
            At::FirstName | At::Name if byte == b'"' => {
                if self.is_outermost() {
                    self.name = None;
                }
                self.begin();
                At::Within { is_name: true }
            }
            At::FirstName if byte == b'}' => self.close(true)?,
            At::FirstItem if byte == b']' => self.close(false)?,
            At::Colon if byte == b':' => At::Value,
            At::Value | At::FirstItem => self.value(byte)?,
            At::Behind => self.behind(byte)?,
            At::Within { is_name } => match byte {
                b'"' => self.end(is_name),
                b'\\' => At::Escape { is_name },
                0..=0x1f => return None,
                _ => {
                    self.read(byte);
                    At::Within { is_name }
                }
            },
            At::Escape { is_name } => match byte {
                b'u' => At::Unit { is_name, digits: 0, value: 0 },
                b'"' | b'\\' | b'/' | b'b' | b'f' | b'n' | b'r' | b't' => {
                    // None of what they stand for is in the words.
                    self.read(0);
                    At::Within { is_name }
                }
                _ => return None,
            },
            At::Unit { is_name, digits, value } => {
                let digit = u16::try_from(char::from(byte).to_digit(16)?).ok()?;
                let value = value << 4 | digit;
                if digits == 3 {
                    self.read(u8::try_from(value).unwrap_or(0));
                    return Some(Self { at: At::Within { is_name }, ..self });
                }
                let may_be = self.string.as_ref().is_some_and(|string| {
                    let next = WORDS.iter().filter_map(|word| word.strip_prefix(&**string)?.first());
                    next.into_iter().any(|next| u16::from(*next) >> (4 * (3 - digits)) == value)
                });
                if !may_be {
                    self.string = None;
                }
                At::Unit { is_name, digits: digits + 1, value: if may_be { value } else { 0 } }
            }
            At::Minus if byte == b'0' => At::Zero,
            At::Minus if byte.is_ascii_digit() => At::Whole,
            At::Whole if byte.is_ascii_digit() => At::Whole,
            At::Zero | At::Whole if byte == b'.' => At::Dot,
            At::Dot | At::Fraction if byte.is_ascii_digit() => At::Fraction,
            At::Zero | At::Whole | At::Fraction if matches!(byte, b'e' | b'E') => At::Exponent,
            At::Exponent if matches!(byte, b'+' | b'-') => At::Sign,
            At::Exponent | At::Sign | At::Power if byte.is_ascii_digit() => At::Power,
            At::Zero | At::Whole | At::Fraction | At::Power => {
                self.at = At::Behind;
                return self.next(byte);
            }
            At::Word(rest) => match rest {
                [due, rest @ ..] if *due == byte => {
                    if rest.is_empty() {
                        At::Behind
                    } else {
                        At::Word(rest)
                    }
                }
                _ => return None,
            },
            _ => return None,
        };
        Some(self)
    }

    /// A value begins.
    fn value(&mut self, byte: u8) -> Option<At> {
        let is_kind = self.is_outermost() && self.name == Some(KIND);
        if is_kind && byte != b'"' {
            self.kinds.1 = true;
        }
        Some(match byte {
            b'"' => {
                self.begin();
                At::Within { is_name: false }
            }
            b'{' | b'[' => {
                self.open.push(byte == b'{');
                if byte == b'{' { At::FirstName } else { At::FirstItem }
            }
            b'-' => At::Minus,
            b'0' => At::Zero,
            b'1'..=b'9' => At::Whole,
            b't' => At::Word(b"rue"),
            b'f' => At::Word(b"alse"),
            b'n' => At::Word(b"ull"),
            _ => return None,
        })
    }

    /// Behind a value.
    fn behind(&mut self, byte: u8) -> Option<At> {
        let in_object = *self.open.last()?;
        Some(match byte {
            b',' if in_object => At::Name,
            b',' => At::Value,
            b'}' => self.close(true)?,
            b']' => self.close(false)?,
            _ => return None,
        })
    }

    fn close(&mut self, is_object: bool) -> Option<At> {
        (self.open.pop()? == is_object).then_some(if self.open.is_empty() { At::End } else { At::Behind })
    }

    /// A string begins.
    fn begin(&mut self) {
        self.string = self.is_outermost().then(Vec::new);
    }

    /// A byte of what the string stands for.
    fn read(&mut self, byte: u8) {
        if let Some(mut string) = self.string.take() {
            string.push(byte);
            let may_be = |word: &&[u8]| word.starts_with(&string);
            self.string = WORDS.iter().any(may_be).then_some(string);
        }
    }

    /// A string ends.
    fn end(&mut self, is_name: bool) -> At {
        let string = self.string.take();
        if !self.is_outermost() {
            return if is_name { At::Colon } else { At::Behind };
        }
        let is = |word: &[u8]| string.as_deref() == Some(word);
        if is_name {
            self.name = [KIND, MODE].into_iter().find(|word| is(word));
            return At::Colon;
        }
        if self.name == Some(KIND) {
            self.kinds = (self.kinds.0 || is(COMMAND), self.kinds.1 || !is(COMMAND));
        }
        self.mode |= self.name == Some(MODE) && is(ESTOP);
        At::Behind
    }

    /// What the rule says of all that was read.
    fn says(&self) -> Says {
        match (&self.at, self.kinds) {
            (At::End, (true, false)) if self.mode => Says::Latches,
            (At::End, (true, true)) if self.mode => Says::Open,
            (At::End, _) => Says::LatchesNot,
            _ => Says::Open,
        }
    }
}

/// What NCP-RES-022 says of a frame.
#[must_use]
pub fn says(frame: &[u8]) -> Says {
    if std::str::from_utf8(frame).is_err() {
        return Says::Open;
    }
    let end = frame.iter().try_fold(Automaton::new(), |automaton, byte| automaton.next(*byte));
    end.map_or(Says::Open, |automaton| automaton.says())
}

/// Whether the scanner answers as the text says.
fn agrees<S: Stopping>(frame: &[u8], says: Says) -> bool {
    match says {
        Says::Latches => S::is_estop(frame),
        Says::LatchesNot => !S::is_estop(frame),
        // It has to come to an end at least.
        Says::Open => {
            S::is_estop(frame);
            true
        }
    }
}

const EXACT: &str = "latches exactly as the text says";
const BUFFER: &str = "the buffer latches exactly as the text says";

/// All short strings of bytes.
fn bytes<S: Stopping>(c: &mut Case) {
    let length = c.below("length", c.bound(2, 3) + 1);
    let mut frame = [0; 3];
    for byte in &mut frame[..length] {
        *byte = u8::try_from(c.below("byte", 256)).unwrap_or_default();
    }
    c.check("no ESTOP is so short", !S::is_estop(&frame[..length]));
}

/// Frames near which others lie.
const FRAMES: [&[u8]; 7] = [
    br#"{"kind":"command_frame","mode":"estop"}"#,
    br#"{"mode":"estop","kind":"command_frame","seq":-1.5e+3}"#,
    br#" { "a" : [ 1 , { } , "]" ] , "mode" : "estop" , "kind" : "command_frame" } "#,
    br#"{"mode":"hold","mode":"estop","kind":"command_frame"}"#,
    br#"{"k\u0069nd":"command\u005fframe","\u006dode":"\u0065stop"}"#,
    br#"{"x":{"mode":"estop"},"kind":"command_frame","mode":"hold"}"#,
    "{\"\u{e9}\\\"\":null,\"kind\":\"command_frame\",\"mode\":\"estop\"}".as_bytes(),
];
/// A byte of each class that JSON or the words tell apart.
const CLASSES: &[u8] = b"{}[]:,\"\\ \n\x00u0eksE-+.9\xc3\xa9\xff";

/// Every frame that differs from one of some frames by any byte put in, taken out or changed, by any two bytes changed
/// to those of a class, or by its end; the buffer behind the scanner is asked, too.
fn edits<S: Stopping>(c: &mut Case) {
    let frames = c.bound(&FRAMES[..2], &FRAMES[..]);
    let sound = c.pick("frame", frames);
    let at = c.below("at", sound.len());
    let mut frame = sound.to_vec();
    match *c.pick("edit", c.bound(&[0, 1, 2, 3], &[0, 1, 2, 3, 4])) {
        0 => frame[at] = u8::try_from(c.below("byte", 256)).unwrap_or_default(),
        1 => frame.insert(at, u8::try_from(c.below("byte", 256)).unwrap_or_default()),
        2 => drop(frame.remove(at)),
        3 => frame.truncate(at),
        _ => {
            frame[at] = *c.pick("byte", CLASSES);
            let other = at + 1 + c.below("distance", sound.len() - at);
            match frame.get_mut(other) {
                Some(byte) => *byte = *c.pick("other byte", CLASSES),
                None => frame.push(*c.pick("other byte", CLASSES)),
            }
        }
    }
    c.say("frame", &String::from_utf8_lossy(&frame));
    let says = says(&frame);
    c.check(EXACT, agrees::<S>(&frame, says));
    if says != Says::Open {
        let latches = [false, true].map(|is_strict| S::latches(&frame, is_strict));
        c.check(BUFFER, latches == [says == Says::Latches; 2]);
    }
}

/// What objects are made of.
const TOKENS: [&[u8]; 17] = [
    b"{",
    b"}",
    b"[",
    b"]",
    b",",
    b":",
    br#""kind""#,
    br#""mode""#,
    br#""command_frame""#,
    br#""estop""#,
    br#""m\u006fde""#,
    br#""e\u0053top""#,
    br#""\\""#,
    br#""mode\"""#,
    b"-1.5E3",
    b"null",
    br#""}""#,
];

/// Every JSON object of so many tokens: all continuations of what may still become one.
fn tokens<S: Stopping>(scope: Scope) -> Outcome {
    let most = if scope == Scope::Short { 6 } else { 13 };
    let mut tried = Tried::default();
    let mut stack = vec![(Automaton::new(), Vec::<u8>::new(), 0)];
    while let Some((automaton, frame, length)) = stack.pop() {
        let says = automaton.says();
        if says != Says::Open && !tried.one::<S>(&frame, says) {
            break;
        }
        if length < most && automaton.at != At::End {
            for token in TOKENS {
                let next = token.iter().try_fold(automaton.clone(), |automaton, byte| automaton.next(*byte));
                // Whether it can be closed with the tokens that are left.
                if let Some(next) = next.filter(|next| next.open.len() + length < most) {
                    stack.push((next, [&*frame, token].concat(), length + 1));
                }
            }
        }
    }
    tried.outcome(String::new())
}

/// Every transition of the automaton from every place that it reaches, and what follows it.
///
/// After the manner of Chow: a transition cover - any character, and any two of a class -, each followed by completions
/// that bring to light what was read: the words that may still be meant, and the members that are still wanting.
fn transitions<S: Stopping>(scope: Scope) -> Outcome {
    let depth = if scope == Scope::Short { 1 } else { 3 };
    let mut tried = Tried::default();
    let mut seen = BTreeMap::from([(Automaton::new(), Vec::new())]);
    let mut queue = VecDeque::from([Automaton::new()]);
    // Each byte of ASCII, and a character beyond it: all of these are alike to the grammar, and stand within strings.
    let characters: Vec<Vec<u8>> = (0..0x80).map(|byte| vec![byte]).chain(["\u{20ac}".into()]).collect();
    let classes: Vec<&Vec<u8>> =
        characters.iter().filter(|one| one.iter().all(|byte| CLASSES.contains(byte))).collect();
    let go = |place: &Automaton, bytes: &[u8]| bytes.iter().try_fold(place.clone(), |place, byte| place.next(*byte));
    while let Some(place) = queue.pop_front() {
        let prefix = seen.get(&place).cloned().unwrap_or_default();
        for character in &characters {
            let Some(next) = go(&place, character).filter(|next| next.open.len() <= depth) else { continue };
            let frame = [&*prefix, character].concat();
            if !tried.all::<S>(&next, &frame) {
                return tried.outcome(String::new());
            }
            // One more than the automaton needs, in case that the scanner tells more apart.
            for class in classes.iter().filter(|_| classes.contains(&character) && scope == Scope::Whole) {
                if let Some(after) = go(&next, class)
                    && !tried.all::<S>(&after, &[&*frame, class].concat())
                {
                    return tried.outcome(String::new());
                }
            }
            if !seen.contains_key(&next) {
                seen.insert(next.clone(), frame);
                queue.push_back(next);
            }
        }
    }
    tried.outcome(format!("{} places of the automaton", seen.len()))
}

/// Ends that make an object of what was read: what is begun is finished in each way that matters, then members follow
/// that make an ESTOP of it, half of one, or nothing.
fn completions(place: &Automaton) -> Vec<Vec<u8>> {
    let mut begun: BTreeSet<Vec<u8>> = BTreeSet::new();
    // What is left of each word that the string may become, from its next byte on.
    let read = place.string.clone();
    let left = || WORDS.iter().filter_map(|word| word.strip_prefix(&**read.as_ref()?)?.split_first());
    match &place.at {
        At::Within { .. } => {
            begun.insert(b"\"".to_vec());
            begun.insert(b"x\"".to_vec());
            begun.extend(left().map(|(next, rest)| [&[*next], rest, b"\""].concat()));
        }
        At::Escape { .. } => {
            begun.insert(b"n\"".to_vec());
            begun.extend(left().map(|(next, rest)| [format!("u{next:04X}").as_bytes(), rest, b"\""].concat()));
        }
        At::Unit { digits, .. } => {
            let due = |hex: &str| hex.as_bytes().get(usize::from(*digits)..).unwrap_or_default().to_vec();
            begun.insert([&*due("ffff"), b"\""].concat());
            begun.extend(left().map(|(next, rest)| [&*due(&format!("{next:04x}")), rest, b"\""].concat()));
        }
        At::Minus | At::Dot | At::Exponent | At::Sign => drop(begun.insert(b"7".to_vec())),
        At::Word(rest) => drop(begun.insert(rest.to_vec())),
        _ => drop(begun.insert(Vec::new())),
    }
    let mut ends = Vec::new();
    for begun in begun {
        let Some(after) = begun.iter().try_fold(place.clone(), |place, byte| place.next(*byte)) else { continue };
        for members in [&b""[..], br#""kind":"command_frame""#, br#""mode":"estop""#] {
            for value in [&b"1"[..], br#""command_frame""#, br#""estop""#] {
                let mut end = begun.clone();
                let mut at = after.clone();
                // Until the object is closed: a colon, a value, the brackets.
                for part in [&b"{"[..], b"\"x\"", b":", value, b""] {
                    let tried = part.iter().try_fold(at.clone(), |at, byte| at.next(*byte));
                    let is_due = match part {
                        b"{" => at.at == At::Start,
                        b"\"x\"" => at.at == At::Name,
                        b":" => at.at == At::Colon,
                        b"" => false,
                        _ => at.at == At::Value,
                    };
                    if let Some(next) = tried.filter(|_| is_due) {
                        end.extend(part);
                        at = next;
                    }
                }
                while at.open.len() > 1 {
                    let bracket = if at.open.last() == Some(&true) { b'}' } else { b']' };
                    let Some(next) = at.clone().next(bracket) else { break };
                    end.push(bracket);
                    at = next;
                }
                if at.open.len() == 1 {
                    if !members.is_empty() {
                        end.extend(if at.at == At::FirstName { &b""[..] } else { b"," });
                        end.extend(members);
                    }
                    end.push(b'}');
                }
                ends.push(end);
            }
        }
    }
    ends.sort();
    ends.dedup();
    ends
}

/// Completions, and what the text says of each.
type Judged = Vec<(Vec<u8>, Says)>;

/// The completions of a place that make an object, and what the text says of that.
fn judged(place: &Automaton) -> Judged {
    let says =
        |end: &Vec<u8>| end.iter().try_fold(place.clone(), |place, byte| place.next(*byte)).map(|end| end.says());
    let ends = completions(place).into_iter().filter_map(|end| Some((says(&end)?, end)));
    ends.filter(|(says, _)| *says != Says::Open).map(|(says, end)| (end, says)).collect()
}

/// Frames that were tried.
#[derive(Debug, Default)]
struct Tried {
    outcome: Outcome,
    /// The completions of each place, and what the text says of them.
    ends: HashMap<Automaton, Rc<Judged>>,
}

impl Tried {
    /// Asks the scanner about one; false where it disagrees.
    fn one<S: Stopping>(&mut self, frame: &[u8], says: Says) -> bool {
        self.outcome.cases += 1;
        let answer = std::panic::catch_unwind(|| agrees::<S>(frame, says));
        *self.outcome.reached.entry(EXACT).or_default() += 1;
        let check = match answer {
            Ok(true) => return true,
            Ok(false) => EXACT,
            Err(_) => PANICS,
        };
        let picked = vec![
            ("frame".to_owned(), String::from_utf8_lossy(frame).into_owned()),
            ("the text says".to_owned(), format!("{says:?}")),
        ];
        self.outcome.counterexample = Some(Counterexample { check, picked });
        false
    }

    /// Asks about all completions of a frame that has led to this place; false where the scanner disagrees.
    fn all<S: Stopping>(&mut self, place: &Automaton, frame: &[u8]) -> bool {
        let ends = self.ends.entry(place.clone()).or_insert_with(|| Rc::new(judged(place))).clone();
        let mut whole = frame.to_vec();
        ends.iter().all(|(end, says)| {
            whole.truncate(frame.len());
            whole.extend(end);
            self.one::<S>(&whole, *says)
        })
    }

    fn outcome(self, detail: String) -> Outcome {
        Outcome { detail, ..self.outcome }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_automaton_reads_what_a_library_reads() {
        // A second reader of JSON, which somebody else wrote.
        let mut objects = 0;
        for frame in FRAMES {
            for at in 0..=frame.len() {
                for class in CLASSES {
                    let mut bent = frame.to_vec();
                    bent.splice(at..(at + 1).min(frame.len()), [*class]);
                    let read = serde_json::from_slice::<serde_json::Map<String, serde_json::Value>>(&bent);
                    let end = bent.iter().try_fold(Automaton::new(), |automaton, byte| automaton.next(*byte));
                    let is_object = end.is_some_and(|end| end.at == At::End) && std::str::from_utf8(&bent).is_ok();
                    assert_eq!(read.is_ok(), is_object, "{}", String::from_utf8_lossy(&bent));
                    objects += usize::from(is_object);
                }
            }
        }
        assert!(objects > 1_000, "{objects}");
    }
}
