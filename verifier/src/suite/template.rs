//! Templates, which keep vector files small.
//!
//! Where a string stands in a case's arguments or expectation, an object may stand instead:
//! `{"$repeat": "x", "times": 1000}`, `{"$count": ["before", "after"], "times": 1000}`, which writes 0, 1, 2, … between
//! the two, `{"$concat": [part, …]}`, `{"$base64": template}`. In a list, `{"$item": value, "times": 1000}` stands for
//! so many equal items, and with `"plus": {"seq": 1}` for items whose number of that name grows by so much from each
//! to the next, or with `"plus": {"text": {"seq": 1}}` that of their object of the name `text`, or the integer behind
//! `"seq":` in their string of that name; items that are strings grow by the integer behind `"seq":`.
//! `{"$items": [one, two], "times": 1000}` stands for so many rounds of several items, and with `"plus": [{…}, {…}]`
//! for rounds in which each grows from one to the next as the object at its place says. Peers never see them.

use std::borrow::Cow;
use std::io::{self, Write};
use std::sync::Arc;

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;

use crate::json::{Json, JsonError, write_string};
use crate::peer::MAX_REQUEST_BYTES;

/// Up to this size an expanded text is kept at hand.
pub(super) const KEPT_BYTES: usize = 64 << 10;
/// What is repeated is written in pieces of about this size.
const PIECE: usize = 64 << 10;
/// What `plus` has to be.
const GROWING: &str = "an object of numbers, each by the name of one, or of an integer within a string, or an object \
                       of such; of `$items` a list of such objects, one for each";
/// Numbers that are multiples of this and below [`FAR`] add up without rounding.
const FINE: f64 = 1.0 / 1_048_576.0;
const FAR: f64 = 4_294_967_296.0;
/// How many characters a number that grows has at most.
const NUMBER: usize = 32;
/// How deep templates may stand within each other.
const MAX_DEPTH: usize = 8;

/// A JSON value of a vector file, its templates not yet expanded.
#[derive(Debug, Clone)]
pub struct Template {
    /// As in the file, but without white space.
    raw: Arc<str>,
    bytes: usize,
    expanded: Expanded,
}

/// Where the expanded text is.
#[derive(Debug, Clone)]
enum Expanded {
    /// There is no template in it: it is the text itself.
    Itself,
    /// At hand.
    Kept(Box<str>),
    /// Made when it is asked for.
    Made,
}

/// Why a template cannot be expanded.
#[derive(Debug, thiserror::Error)]
pub enum TemplateError {
    /// The value around it is not JSON.
    #[error(transparent)]
    Json(#[from] JsonError),
    /// An object begins like a template but is none.
    #[error(
        "`{0}` is no template: one of `$repeat` with `times`, `$count` with `times`, `$concat`, `$base64`; in a list \
         `$item` or `$items` with `times`, and perhaps `plus`"
    )]
    Unknown(String),
    /// A member of a template has the wrong type.
    #[error("`{name}` of a template is not {expected}")]
    Type {
        /// The member.
        name: &'static str,
        /// What it has to be.
        expected: &'static str,
    },
    /// Too large to be sent.
    #[error("the templates expand to more than {MAX_REQUEST_BYTES} bytes")]
    Size,
    /// Too deep.
    #[error("templates stand within each other more than {MAX_DEPTH} deep")]
    Depth,
}

impl Template {
    /// Takes a JSON value, and makes sure that it can be expanded.
    ///
    /// # Errors
    /// [`TemplateError`] if it is not JSON, or a template in it is faulty or too large.
    pub fn new(raw: &str) -> Result<Self, TemplateError> {
        let value = Json::parse(raw)?;
        let bytes = size(&value)?;
        let expanded = if holds_template(&value) { Expanded::Made } else { Expanded::Itself };
        Ok(Self { raw: value.to_string().into(), bytes, expanded })
    }

    /// About how many bytes it expands to.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Whether this is a string, or a template of one.
    #[must_use]
    pub fn is_text(&self) -> bool {
        self.raw.starts_with('"') || self.raw.starts_with("{\"$")
    }

    /// Keeps the expanded text at hand, unless it is large.
    #[must_use]
    pub fn keep(mut self) -> Self {
        if self.bytes <= KEPT_BYTES && matches!(self.expanded, Expanded::Made) {
            self.expanded = Expanded::Kept(self.expand().into());
        }
        self
    }

    /// The value as JSON text without white space, its templates expanded and its numbers spelled as in the file.
    #[must_use]
    pub fn expand(&self) -> Cow<'_, str> {
        match &self.expanded {
            Expanded::Itself => Cow::Borrowed(&self.raw),
            Expanded::Kept(kept) => Cow::Borrowed(kept),
            Expanded::Made => {
                let mut out = Vec::with_capacity(self.bytes + 64);
                // It was read when it was made, and a vector takes whatever is written.
                drop(self.write_to(&mut out));
                Cow::Owned(String::from_utf8(out).unwrap_or_default())
            }
        }
    }

    /// Writes what [`expand`](Self::expand) gives, piece by piece, so that its size costs no memory.
    ///
    /// # Errors
    /// What `out` says.
    pub fn write_to(&self, out: &mut dyn Write) -> io::Result<()> {
        match &self.expanded {
            Expanded::Itself => out.write_all(self.raw.as_bytes()),
            Expanded::Kept(kept) => out.write_all(kept.as_bytes()),
            Expanded::Made => Json::parse(&self.raw).map_or(Ok(()), |value| write_expanded(&value, out)),
        }
    }

    /// The value as JSON text without white space, its templates as they are.
    #[must_use]
    pub fn unexpanded(&self) -> &str {
        &self.raw
    }

    /// The string that it stands for, if [`is_text`](Self::is_text).
    #[must_use]
    pub fn text(&self) -> String {
        let mut out = Vec::with_capacity(self.bytes);
        if let Ok(value) = Json::parse(&self.raw) {
            drop(write_part(&value, Spelling::Plain, &mut out));
        }
        String::from_utf8(out).unwrap_or_default()
    }
}

/// A template, taken apart.
enum Form<'v, 'a> {
    Text(&'v str),
    Repeat(&'v Json<'a>, usize),
    /// Two texts, and how many numbers stand between such.
    Count(&'v str, &'v str, usize),
    Concat(&'v [Json<'a>]),
    Base64(&'v Json<'a>),
}

/// The template that a value is, or none if it is an ordinary value.
fn form<'v, 'a>(value: &'v Json<'a>) -> Result<Option<Form<'v, 'a>>, TemplateError> {
    let members = match value {
        Json::String(text) => return Ok(Some(Form::Text(text))),
        Json::Object(members) => members,
        _ => return Ok(None),
    };
    let names: Vec<&str> = members.iter().map(|(name, _)| name.as_ref()).collect();
    let Some(name) = names.iter().find(|name| name.starts_with('$')) else {
        return Ok(None);
    };
    match (names.as_slice(), members.as_slice()) {
        (["$repeat", "times"], [(_, part), (_, times)]) => Ok(Some(Form::Repeat(part, count(times)?))),
        (["$count", "times"], [(_, Json::Array(around)), (_, times)]) => match around.as_slice() {
            [Json::String(before), Json::String(after)] => Ok(Some(Form::Count(before, after, count(times)?))),
            _ => Err(TemplateError::Type { name: "$count", expected: "an array of two strings" }),
        },
        (["$concat"], [(_, Json::Array(parts))]) => Ok(Some(Form::Concat(parts))),
        (["$concat"], _) => Err(TemplateError::Type { name: "$concat", expected: "an array" }),
        (["$base64"], [(_, part)]) => Ok(Some(Form::Base64(part))),
        _ => Err(TemplateError::Unknown((*name).to_owned())),
    }
}

/// The items that an entry of a list stands for, and how often they stand there.
pub(super) fn items<'v, 'a>(value: &'v Json<'a>) -> Result<(&'v [Json<'a>], usize), TemplateError> {
    let once = std::slice::from_ref(value);
    let Json::Object(members) = value else { return Ok((once, 1)) };
    let [(name, repeated), (times_name, times)] = members.as_slice() else { return Ok((once, 1)) };
    match (name.as_ref(), times_name.as_ref(), repeated) {
        ("$item", "times", item) => Ok((std::slice::from_ref(item), count_from_1(times)?)),
        ("$items", "times", Json::Array(items)) if !items.is_empty() => Ok((items, count_from_1(times)?)),
        ("$items", "times", _) => Err(TemplateError::Type { name: "$items", expected: "a list of one item at least" }),
        _ => Ok((once, 1)),
    }
}

/// What an entry of a list stands for: rounds of items, of which each may grow from one round to the next.
struct Run<'v, 'a> {
    items: &'v [Json<'a>],
    times: usize,
    /// For each of the items that grow, its members that do; nothing where none grows.
    plus: Vec<Vec<Growth<'v>>>,
}

/// A member that grows from each round to the next.
struct Growth<'v> {
    member: &'v str,
    what: Growing<'v>,
}

/// What grows of a member.
enum Growing<'v> {
    /// It is a number.
    Itself(Numbers),
    /// The number between these, of a string.
    Within(&'v str, Numbers, &'v str),
    /// Members of it, an object.
    Members(Vec<Growth<'v>>),
}

/// A number, and by how much it grows.
enum Numbers {
    Integers(i64, i64),
    Doubles(f64, f64),
}

impl Numbers {
    /// The numbers that are spelled so, if as many of them add up without rounding.
    fn of(first: &str, by: &str, times: usize) -> Option<Self> {
        if let (Ok(first), Ok(by)) = (first.parse::<i64>(), by.parse::<i64>()) {
            by.checked_mul(i64::try_from(times).ok()?)?.checked_add(first)?;
            return Some(Self::Integers(first, by));
        }
        let (first, by) = (first.parse::<f64>().ok()?, by.parse::<f64>().ok()?);
        let is_exact = |number: f64| (number / FINE).fract() == 0.0 && number.abs() < FAR;
        (is_exact(first) && is_exact(by) && is_exact(by * times as f64 + first)).then_some(Self::Doubles(first, by))
    }

    /// How the one of a round is spelled; that none of them overflows was seen when they were read.
    fn nth(&self, nth: usize) -> String {
        match self {
            Self::Integers(first, by) => {
                let grown = i64::try_from(nth).ok().and_then(|nth| by.checked_mul(nth)?.checked_add(*first));
                grown.unwrap_or(*first).to_string()
            }
            Self::Doubles(first, by) => format!("{:?}", by * nth as f64 + first),
        }
    }
}

impl<'v> Growth<'v> {
    /// The members of an object that grow so in as many rounds.
    fn all(object: &'v Json<'_>, plus: &'v Json<'_>, times: usize) -> Option<Vec<Self>> {
        let Json::Object(plus) = plus else { return None };
        // A string grows as a whole.
        if let Json::String(text) = object {
            return Some(vec![Self { member: "", what: Self::within(text, plus, times)? }]);
        }
        plus.iter().map(|(member, by)| Self::of(object, member, by, times)).collect()
    }

    /// A member of an object, if it grows so in as many rounds.
    fn of(object: &'v Json<'_>, member: &'v str, by: &'v Json<'_>, times: usize) -> Option<Self> {
        let Json::Object(members) = object else { return None };
        let (_, value) = members.iter().find(|(known, _)| known == member)?;
        let what = match (value, by) {
            (Json::Number(first), Json::Number(by)) => Growing::Itself(Numbers::of(first, by, times)?),
            (Json::String(text), Json::Object(within)) => Self::within(text, within, times)?,
            (Json::Object(_), Json::Object(within)) if !within.is_empty() => {
                Growing::Members(Self::all(value, by, times)?)
            }
            _ => return None,
        };
        Some(Self { member, what })
    }

    /// How a string grows whose one integer of that name grows so in as many rounds.
    fn within(text: &'v str, plus: &'v [(Cow<'_, str>, Json<'_>)], times: usize) -> Option<Growing<'v>> {
        let [(name, Json::Number(by))] = plus else { return None };
        let (before, first, after) = integer_within(text, name)?;
        let numbers = Numbers::of(first, by, times)?;
        by.parse::<i64>().is_ok().then_some(Growing::Within(before, numbers, after))
    }

    /// The member in a round.
    fn nth<'a>(&self, value: &Json<'a>, nth: usize) -> Json<'a> {
        match &self.what {
            Growing::Itself(numbers) => Json::Number(numbers.nth(nth).into()),
            Growing::Within(before, numbers, after) => {
                Json::String(format!("{before}{}{after}", numbers.nth(nth)).into())
            }
            Growing::Members(members) => grown(value, members, nth),
        }
    }

    /// How many numbers of it grow.
    fn count(&self) -> usize {
        match &self.what {
            Growing::Itself(_) | Growing::Within(..) => 1,
            Growing::Members(members) => members.iter().map(Self::count).sum(),
        }
    }
}

/// An item of a round, an object or a string, by what of it grows.
fn grown<'a>(item: &Json<'a>, plus: &[Growth<'_>], nth: usize) -> Json<'a> {
    let mut item = item.clone();
    match &mut item {
        Json::Object(members) => {
            for (name, value) in members {
                if let Some(growth) = plus.iter().find(|growth| growth.member == name) {
                    *value = growth.nth(value, nth);
                }
            }
        }
        whole => {
            if let [growth] = plus {
                *whole = growth.nth(whole, nth);
            }
        }
    }
    item
}

/// The spelling behind the first `"name":` of a JSON text, and what stands before and behind it, if it is an integer.
fn integer_within<'t>(text: &'t str, name: &str) -> Option<(&'t str, &'t str, &'t str)> {
    let named = format!("\"{name}\":");
    let begins = text.find(&named)? + named.len();
    let (before, rest) = text.split_at_checked(begins)?;
    let ends = rest.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(rest.len());
    let (integer, after) = rest.split_at_checked(ends)?;
    let is_whole = !after.starts_with(['.', 'e', 'E']) && integer.parse::<i64>().is_ok();
    is_whole.then_some((before, integer, after))
}

impl<'v, 'a> Run<'v, 'a> {
    /// Items that do not grow.
    fn of(items: &'v [Json<'a>], times: usize) -> Self {
        Self { items, times, plus: Vec::new() }
    }

    /// An item of a round behind the first, if it grows; its growth was judged when it was read.
    fn grown(&self, nth: usize, place: usize) -> Option<Json<'a>> {
        let plus = self.plus.get(place).filter(|plus| nth > 0 && !plus.is_empty())?;
        Some(grown(self.items.get(place)?, plus, nth))
    }
}

/// The items that an entry of a list stands for.
fn run<'v, 'a>(value: &'v Json<'a>) -> Result<Run<'v, 'a>, TemplateError> {
    let once = || Run::of(std::slice::from_ref(value), 1);
    let Json::Object(members) = value else { return Ok(once()) };
    let [(name, repeated), (times_name, times), (plus_name, plus)] = members.as_slice() else {
        let (items, times) = items(value)?;
        return Ok(Run::of(items, times));
    };
    if times_name != "times" || plus_name != "plus" {
        return Ok(once());
    }
    let grow = |items: &'v [Json<'a>], plus: &'v [Json<'a>]| {
        let times = count_from_1(times)?;
        let both = items.iter().zip(plus);
        let all = both.map(|(item, plus)| Growth::all(item, plus, times)).collect::<Option<Vec<_>>>();
        // What grows nowhere is written without it.
        let all = all.filter(|all| items.len() == plus.len() && all.iter().any(|plus| !plus.is_empty()));
        all.map(|plus| Run { items, times, plus }).ok_or(TemplateError::Type { name: "plus", expected: GROWING })
    };
    match (name.as_ref(), repeated, plus) {
        ("$item", item, plus) => grow(std::slice::from_ref(item), std::slice::from_ref(plus)),
        ("$items", Json::Array(items), Json::Array(plus)) => grow(items, plus),
        ("$items", Json::Array(_), _) => Err(TemplateError::Type { name: "plus", expected: GROWING }),
        ("$items", ..) => Err(TemplateError::Type { name: "$items", expected: "a list of one item at least" }),
        _ => Ok(once()),
    }
}

/// The value of `times` of a list.
fn count_from_1(value: &Json<'_>) -> Result<usize, TemplateError> {
    match count(value)? {
        0 => Err(TemplateError::Type { name: "times", expected: "a count from 1" }),
        times => Ok(times),
    }
}

/// The value of `times`.
fn count(value: &Json<'_>) -> Result<usize, TemplateError> {
    let times = match value {
        Json::Number(spelling) => spelling.parse().ok(),
        _ => None,
    };
    times.ok_or(TemplateError::Type { name: "times", expected: "a count" })
}

/// The form of a part of a template, which cannot be an ordinary value.
fn part<'v, 'a>(value: &'v Json<'a>) -> Result<Form<'v, 'a>, TemplateError> {
    form(value)?.ok_or(TemplateError::Type { name: "a part", expected: "a string or a template" })
}

/// Whether a template stands somewhere in a value.
fn holds_template(value: &Json<'_>) -> bool {
    match (form(value), value) {
        (Ok(Some(Form::Text(_))), _) => false,
        (Ok(Some(_)), _) => true,
        (_, Json::Array(items)) => items.iter().any(|each| {
            let of = run(each).map_or(std::slice::from_ref(each), |run| run.items);
            !std::ptr::eq(of.as_ptr(), each) || of.iter().any(holds_template)
        }),
        (_, Json::Object(members)) => members.iter().any(|(_, member)| holds_template(member)),
        _ => false,
    }
}

/// About how many bytes a value expands to, as JSON.
fn size(value: &Json<'_>) -> Result<usize, TemplateError> {
    let total = match (form(value)?, value) {
        (Some(form), _) => text_size(&form, Spelling::Json, 0)? + 2,
        (None, Json::Array(items)) => items.iter().try_fold(2, |sum: usize, each| {
            let run = run(each)?;
            let items = run.items.iter().try_fold(0_usize, |sum, item| {
                Ok::<_, TemplateError>(sum.saturating_add(size(item)?.saturating_add(1)))
            })?;
            let growing: usize = run.plus.iter().flatten().map(Growth::count).sum();
            let round = items.saturating_add(NUMBER * growing);
            Ok::<_, TemplateError>(sum.saturating_add(round.saturating_mul(run.times)))
        })?,
        (None, Json::Object(members)) => members.iter().try_fold(2, |sum: usize, (name, member)| {
            Ok::<_, TemplateError>(sum.saturating_add(name.len() + 4 + size(member)?))
        })?,
        (None, Json::Number(spelling)) => spelling.len(),
        (None, _) => 5,
    };
    if total > MAX_REQUEST_BYTES { Err(TemplateError::Size) } else { Ok(total) }
}

/// About how many bytes a string takes, in JSON or as it is.
fn text_size(form: &Form<'_, '_>, spelling: Spelling, depth: usize) -> Result<usize, TemplateError> {
    if depth > MAX_DEPTH {
        return Err(TemplateError::Depth);
    }
    let inner = |value, spelling| text_size(&part(value)?, spelling, depth + 1);
    let total = match form {
        Form::Text(text) => match spelling {
            Spelling::Plain => text.len(),
            // In JSON a quote takes two bytes and a control character up to six.
            Spelling::Json => {
                text.bytes().map(|b| if b < 0x20 { 6 } else { 1 + usize::from(b == b'"' || b == b'\\') }).sum()
            }
        },
        Form::Repeat(repeated, times) => inner(repeated, spelling)?.saturating_mul(*times),
        Form::Count(before, after, times) => {
            let around = |text| text_size(&Form::Text(text), spelling, depth);
            // A count has no more than twenty digits.
            (around(before)? + around(after)? + 20).saturating_mul(*times)
        }
        Form::Concat(parts) => parts
            .iter()
            .try_fold(0_usize, |sum, each| Ok::<_, TemplateError>(sum.saturating_add(inner(each, spelling)?)))?,
        // Base64 has nothing to escape.
        Form::Base64(encoded) => (inner(encoded, Spelling::Plain)? / 3 + 1).saturating_mul(4),
    };
    if total > MAX_REQUEST_BYTES { Err(TemplateError::Size) } else { Ok(total) }
}

/// How the bytes of a string are counted and written.
#[derive(Clone, Copy)]
enum Spelling {
    Plain,
    Json,
}

fn write_expanded(value: &Json<'_>, out: &mut dyn Write) -> io::Result<()> {
    match (form(value), value) {
        (Ok(Some(form)), _) => {
            out.write_all(b"\"")?;
            write_form(&form, Spelling::Json, out)?;
            out.write_all(b"\"")
        }
        (_, Json::Array(items)) => {
            for (i, each) in items.iter().enumerate() {
                out.write_all(if i > 0 { b"," } else { b"[" })?;
                let run = run(each).unwrap_or(Run::of(std::slice::from_ref(each), 1));
                let mut round = Vec::new();
                for nth in 0..run.times {
                    if round.is_empty() || !run.plus.is_empty() {
                        round.clear();
                        for (place, item) in run.items.iter().enumerate() {
                            if nth + place > 0 {
                                round.push(b',');
                            }
                            let grown = run.grown(nth, place);
                            write_expanded(grown.as_ref().unwrap_or(item), &mut round)?;
                        }
                    }
                    out.write_all(&round)?;
                    if nth == 0 && run.plus.is_empty() {
                        round.insert(0, b',');
                    }
                }
            }
            out.write_all(if items.is_empty() { b"[]" } else { b"]" })
        }
        (_, Json::Object(members)) => {
            for (i, (name, member)) in members.iter().enumerate() {
                let mut spelled = String::from(if i > 0 { "," } else { "{" });
                write_string(name, &mut spelled);
                spelled.push(':');
                out.write_all(spelled.as_bytes())?;
                write_expanded(member, out)?;
            }
            out.write_all(if members.is_empty() { b"{}" } else { b"}" })
        }
        (_, plain) => out.write_all(plain.to_string().as_bytes()),
    }
}

/// Writes the string that a form stands for, without quotes. Its size was judged when it was read.
fn write_form(form: &Form<'_, '_>, spelling: Spelling, out: &mut dyn Write) -> io::Result<()> {
    match form {
        Form::Text(text) => match spelling {
            Spelling::Plain => out.write_all(text.as_bytes()),
            Spelling::Json => {
                let mut spelled = String::new();
                write_string(text, &mut spelled);
                out.write_all(spelled.get(1..spelled.len() - 1).unwrap_or_default().as_bytes())
            }
        },
        Form::Repeat(repeated, times) => {
            let mut once = Vec::new();
            write_part(repeated, spelling, &mut once)?;
            let many = (PIECE / once.len().max(1)).clamp(1, (*times).max(1));
            let piece = once.repeat(many);
            for _ in 0..times / many {
                out.write_all(&piece)?;
            }
            out.write_all(&once.repeat(times % many))
        }
        Form::Count(before, after, times) => (0..*times).try_for_each(|nth| {
            write_form(&Form::Text(before), spelling, out)?;
            write!(out, "{nth}")?;
            write_form(&Form::Text(after), spelling, out)
        }),
        Form::Concat(parts) => parts.iter().try_for_each(|each| write_part(each, spelling, out)),
        // Base64 has nothing to escape.
        Form::Base64(encoded) => {
            let mut encoder = EncoderWriter::new(out, &STANDARD);
            write_part(encoded, Spelling::Plain, &mut encoder)?;
            encoder.finish().map(drop)
        }
    }
}

/// As [`write_form`], of a part of a template; what was read is one.
fn write_part(value: &Json<'_>, spelling: Spelling, out: &mut dyn Write) -> io::Result<()> {
    part(value).map_or(Ok(()), |form| write_form(&form, spelling, out))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn expand(raw: &str) -> String {
        Template::new(raw).unwrap().expand().into_owned()
    }

    #[test]
    fn templates_become_strings_wherever_they_stand() {
        assert_eq!(expand(r#"{"text": {"$repeat": "ab", "times": 3}}"#), r#"{"text":"ababab"}"#);
        assert_eq!(expand(r#"[{"$concat": ["a", {"$repeat": "\"", "times": 2}, "z"]}]"#), r#"["a\"\"z"]"#);
        assert_eq!(expand(r#"{"$base64": {"$concat": ["any", " carnal"]}}"#), r#""YW55IGNhcm5hbA==""#);
        assert_eq!(expand(r#"{"$repeat": {"$base64": "a"}, "times": 2}"#), r#""YQ==YQ==""#);
        assert_eq!(expand(r#"{"$repeat": "x", "times": 0}"#), r#""""#);
        assert_eq!(expand(r#"{"$count": ["\"k", "\","], "times": 3}"#), r#""\"k0\",\"k1\",\"k2\",""#);
        assert_eq!(expand(r#"[0, {"$item": {"a": [1]}, "times": 3}]"#), r#"[0,{"a":[1]},{"a":[1]},{"a":[1]}]"#);
        let grown = r#"[{"$item": {"a": 5, "seq": -1}, "times": 3, "plus": {"seq": -2}}]"#;
        assert_eq!(expand(grown), r#"[{"a":5,"seq":-1},{"a":5,"seq":-3},{"a":5,"seq":-5}]"#);
        let within =
            r#"[{"$item": {"text": "{\"seq\":-1,\"a\":{\"seq\":7}}"}, "times": 3, "plus": {"text": {"seq": 2}}}]"#;
        let text = |seq: i64| format!(r#"{{"text":"{{\"seq\":{seq},\"a\":{{\"seq\":7}}}}"}}"#);
        assert_eq!(expand(within), format!("[{},{},{}]", text(-1), text(1), text(3)));
        let nested = r#"[{"$item": {"a": {"b": {"n": 5}, "n": 1}}, "times": 2, "plus": {"a": {"b": {"n": 1}}}}]"#;
        assert_eq!(expand(nested), r#"[{"a":{"b":{"n":5},"n":1}},{"a":{"b":{"n":6},"n":1}}]"#);
        let whole = r#"[{"$item": "{\"s\":\"{\\\"n\\\":4}\"}", "times": 2, "plus": {"n\\": 1}}]"#;
        assert_eq!(expand(whole), r#"["{\"s\":\"{\\\"n\\\":4}\"}","{\"s\":\"{\\\"n\\\":5}\"}"]"#);
        let timed = r#"[{"$item": {"now_s": 8.0}, "times": 3, "plus": {"now_s": 0.125}}]"#;
        assert_eq!(expand(timed), r#"[{"now_s":8.0},{"now_s":8.125},{"now_s":8.25}]"#);
        assert_eq!(expand(r#"[0, {"$items": [1, "a"], "times": 3}, 2]"#), r#"[0,1,"a",1,"a",1,"a",2]"#);
        let rounds = r#"[{"$items": [{"seq": 1}, {"seq": 9, "t": 0.5}], "times": 2, "plus": [{"seq": 2}, {"t": -1}]}]"#;
        assert_eq!(expand(rounds), r#"[{"seq":1},{"seq":9,"t":0.5},{"seq":3},{"seq":9,"t":-0.5}]"#);
        let nested = r#"[{"$item": [{"$item": {"$repeat": "x", "times": 2}, "times": 2}], "times": 1}]"#;
        assert_eq!(expand(nested), r#"[["xx","xx"]]"#);
    }

    #[test]
    fn what_is_no_template_keeps_its_order_and_spelling() {
        let raw = r#"{"b": 5.0, "a": [-0, 1e3, null, true], "x": {}}"#;
        assert_eq!(expand(raw), r#"{"b":5.0,"a":[-0,1e3,null,true],"x":{}}"#);
    }

    #[test]
    fn the_text_of_a_template_is_the_string_itself() {
        let template = Template::new("{\n \"$concat\": [\"a\\n\", \"b\"]}").unwrap();
        assert!(template.is_text());
        assert_eq!(template.text(), "a\nb");
        assert!(Template::new("\"a\"").unwrap().is_text());
        assert!(!Template::new("{\"a\":1}").unwrap().is_text());
    }

    #[test]
    fn a_faulty_template_is_refused() {
        let fault = |raw: &str| Template::new(raw).unwrap_err().to_string();
        assert!(fault(r#"{"$repat": "x", "times": 1}"#).contains("`$repat` is no template"));
        assert!(fault(r#"{"$repeat": "x"}"#).contains("no template"));
        assert!(fault(r#"{"$repeat": "x", "times": 1, "a": 1}"#).contains("no template"));
        assert!(fault(r#"{"$repeat": "x", "times": -1}"#).contains("`times` of a template is not a count"));
        assert!(fault(r#"{"$repeat": 1, "times": 1}"#).contains("not a string or a template"));
        assert!(fault(r#"{"$item": 1, "times": 2}"#).contains("in a list `$item`"));
        for items in ["[]", "1", "{}"] {
            let raw = format!(r#"[{{"$items": {items}, "times": 2}}]"#);
            assert!(fault(&raw).contains("`$items` of a template is not a list of one item at least"), "{items}");
        }
        assert!(fault(r#"[{"$items": [1], "times": 0}]"#).contains("a count from 1"));
        for plus in ["[]", "[{}]", "{}", r#"[{"a": 1}, {}]"#, r#"[{"a": 1}]"#, r#"[{"a": 0.3}]"#, r#"{"a": 1}"#] {
            let raw = format!(r#"[{{"$items": [{{"a": 1}}, 2], "times": 2, "plus": {plus}}}]"#);
            let is_right = plus == r#"[{"a": 1}, {}]"#;
            assert_eq!(Template::new(&raw).is_ok(), is_right, "{plus}");
            assert!(is_right || fault(&raw).contains("of `$items` a list of such objects"), "{plus}");
        }
        assert!(fault(r#"[{"$item": 1, "times": 0}]"#).contains("a count from 1"));
        assert!(fault(r#"[{"$item": 1}]"#).contains("no template"));
        for plus in ["{}", "1", r#"{"b": 1}"#, r#"{"a": 0.1}"#, r#"{"a": 1e300}"#, r#"{"a": 9223372036854775807}"#] {
            let raw = format!(r#"[{{"$item": {{"a": 1}}, "times": 2, "plus": {plus}}}]"#);
            assert!(fault(&raw).contains("`plus` of a template is not an object of numbers"), "{plus}");
        }
        for plus in ["1", "{}", r#"{"x": 1}"#, r#"{"seq": 1, "n": 1}"#, r#"{"seq": 0.5}"#, r#"{"n": 1}"#] {
            let raw =
                format!(r#"[{{"$item": {{"a": "{{\"seq\":5,\"n\":5.5}}"}}, "times": 2, "plus": {{"a": {plus}}}}}]"#);
            assert!(fault(&raw).contains("or of an integer within a string"), "{plus}");
        }
        assert!(fault(r#"[{"$item": {"a": 1}, "times": 0, "plus": {"a": 1}}]"#).contains("a count from 1"));
        assert!(
            fault(r#"[{"$item": [{"$item": 1, "times": 99999}], "times": 99999}]"#).contains("expand to more than")
        );
        assert!(fault(r#"{"$concat": "x"}"#).contains("not an array"));
        assert!(fault(r#"{"$count": ["x"], "times": 2}"#).contains("not an array of two strings"));
        assert!(fault(r#"{"$count": ["x", "y"], "times": 99999999999}"#).contains("expand to more than"));
        assert!(fault(r#"{"a": {"$concat": [[]]}}"#).contains("not a string or a template"));
    }

    #[test]
    fn a_template_cannot_grow_beyond_what_may_be_sent() {
        let mut raw = r#""xxxxxxxxxx""#.to_owned();
        for _ in 0..8 {
            raw = format!(r#"{{"$repeat": {raw}, "times": 1000}}"#);
        }
        assert!(matches!(Template::new(&raw), Err(TemplateError::Size)));
        let huge = format!(r#"{{"$repeat": "ab", "times": {}}}"#, usize::MAX);
        assert!(matches!(Template::new(&huge), Err(TemplateError::Size)));
        let mut deep = r#""""#.to_owned();
        for _ in 0..20 {
            deep = format!(r#"{{"$concat": [{deep}]}}"#);
        }
        assert!(matches!(Template::new(&deep), Err(TemplateError::Depth)));
    }

    proptest! {
        #[test]
        fn the_size_is_never_less_than_what_is_sent(part in any::<String>(), times in 0_usize..50) {
            let mut raw = String::from(r#"{"text":{"$concat":[{"$repeat":"#);
            write_string(&part, &mut raw);
            raw.push_str(&format!(r#","times":{times}}},{{"$base64":"#));
            write_string(&part, &mut raw);
            raw.push_str("}]}}");
            let template = Template::new(&raw).unwrap();
            prop_assert!(template.expand().len() <= template.bytes());
        }
    }
}
