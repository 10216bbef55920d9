//! A strict pull reader: the caller says what it expects, and the reader gives that or an error.
//!
//! It reads every byte once, borrows strings that have no escapes, and keeps nothing but the
//! places of the ignored members' names, eight bytes each, to find one that occurs twice. What a
//! frame makes the messages allocate is measured in `tests/wire_memory.rs`. `// [NCP-WIRE-070]`

use std::borrow::Cow;

use crate::contract::fnv1a_64;
use crate::wire::Kind;
use crate::wire::error::{DecodeError, DecodeProblem};
use crate::wire::limits::{MAX_INTEGER, MAX_LEVELS};
use crate::wire::table::JsonType;
use crate::wire::value::Value;

use super::plain_len;

/// Reads one JSON text.
pub(crate) struct Reader<'a> {
    text: &'a str,
    bytes: &'a [u8],
    at: usize,
    /// Open objects and arrays.
    level: usize,
    /// The names of ignored members of the open objects, innermost last: 32 bits of a hash above
    /// 32 bits of the place.
    ignored: Vec<u64>,
    purpose: Purpose,
    /// Whether the object being read is a frame inside a request.
    pub(crate) in_request: bool,
    /// What that frame left out.
    pub(crate) left_out: LeftOut,
}

/// Why a text is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// It came over the wire.
    Receive,
    /// It came over the wire, and the strict profile holds.
    ReceiveStrict,
    /// A program names the fields that it sets.
    Build,
}

/// The members that a stimulus frame inside a request may take from the request.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct LeftOut {
    pub(crate) ncp_version: bool,
    pub(crate) session_id: bool,
}

type Result<T, E = DecodeError> = std::result::Result<T, E>;

impl<'a> Reader<'a> {
    pub(crate) fn new(frame: &'a [u8], purpose: Purpose) -> Result<Self> {
        // [NCP-WIRE-001]
        let text = std::str::from_utf8(frame).map_err(|e| DecodeError::new(DecodeProblem::NotUtf8, e.valid_up_to()))?;
        // [NCP-WIRE-006]
        if text.starts_with('\u{feff}') {
            return Err(DecodeError::new(DecodeProblem::ByteOrderMark, 0));
        }
        Ok(Self {
            text,
            bytes: frame,
            at: 0,
            level: 0,
            ignored: Vec::new(),
            purpose,
            in_request: false,
            left_out: LeftOut::default(),
        })
    }

    /// Whether a program's fields are read, and not a frame.
    pub(crate) fn is_building(&self) -> bool {
        self.purpose == Purpose::Build
    }

    /// An error at the current place.
    #[cold]
    pub(crate) fn error(&self, problem: DecodeProblem) -> DecodeError {
        DecodeError::new(problem, self.at)
    }

    /// The beginning of the frame: white space up to the object that a frame is.
    pub(crate) fn begin(&mut self) -> Result<()> {
        self.space();
        if self.peek() == b'{' {
            return Ok(());
        }
        Err(self.error(DecodeProblem::NotAnObject)) // [NCP-WIRE-003]
    }

    /// The end of the frame: nothing but white space. `// [NCP-WIRE-004]`
    pub(crate) fn end(&mut self) -> Result<()> {
        self.space();
        if self.at == self.bytes.len() {
            return Ok(());
        }
        Err(self.error(DecodeProblem::Trailing))
    }

    // ---- objects ---------------------------------------------------------------------------

    /// Enters an object; whether it has a member. `expected` names it in the error.
    #[inline]
    pub(crate) fn open_object(&mut self, expected: JsonType) -> Result<bool> {
        if self.peek() != b'{' {
            return Err(self.wrong_type(expected));
        }
        self.open()?;
        match self.peek() {
            b'"' => Ok(true),
            b'}' => {
                self.close();
                Ok(false)
            }
            _ => Err(self.syntax("a member name or '}'")),
        }
    }

    /// After a member: whether another follows. Leaves the object when not.
    #[inline]
    pub(crate) fn next_member(&mut self) -> Result<bool> {
        self.space();
        match self.peek() {
            b',' => {
                self.at += 1;
                self.space();
                if self.peek() == b'"' { Ok(true) } else { Err(self.syntax("a member name")) }
            }
            b'}' => {
                self.close();
                Ok(false)
            }
            _ => Err(self.syntax("',' or '}'")),
        }
    }

    /// Takes a member name with its colon if it stands here in its usual spelling: quoted, the
    /// colon directly behind.
    #[inline]
    pub(crate) fn eat_name(&mut self, quoted: &str) -> bool {
        let here = self.bytes.get(self.at..).unwrap_or_default();
        let found = here.starts_with(quoted.as_bytes());
        if found {
            self.at += quoted.len();
            self.space();
        }
        found
    }

    /// Takes any member name with its colon.
    pub(crate) fn name(&mut self) -> Result<Cow<'a, str>> {
        let name = self.string_here()?;
        self.space();
        if self.peek() != b':' {
            return Err(self.syntax("':'"));
        }
        self.at += 1;
        self.space();
        Ok(name)
    }

    /// Reads the value of a field, unless the field was there before. `// [NCP-WIRE-007]`
    #[inline]
    pub(crate) fn fill<T: Value>(&mut self, slot: &mut Option<T>, name: &'static str) -> Result<()> {
        if slot.is_some() {
            return Err(self.error(DecodeProblem::Repeated).inside(name));
        }
        *slot = Some(T::read(self).map_err(|e| e.inside(name))?);
        Ok(())
    }

    /// Reads the `kind` of a frame that must be `expected`.
    pub(crate) fn fill_kind(&mut self, slot: &mut bool, expected: Kind) -> Result<()> {
        if std::mem::replace(slot, true) {
            return Err(self.error(DecodeProblem::Repeated).inside("kind"));
        }
        let at = self.at;
        let name = self.string().map_err(|e| e.inside("kind"))?;
        if name == expected.as_str() {
            return Ok(());
        }
        let problem = match Kind::parse(&name) {
            Some(found) => DecodeProblem::KindOther { expected, found }, // [NCP-WIRE-030] [NCP-WIRE-036]
            None => DecodeProblem::kind_unknown(&name),                  // [NCP-WIRE-029]
        };
        Err(DecodeError::new(problem, at).inside("kind"))
    }

    /// Judges the header of a frame once it is read. `ncp_version` and `kind` may be left out inside
    /// a request, `kind` also by a program.
    #[inline]
    pub(crate) fn settle_header(&mut self, has_kind: bool, has_version: bool) -> Result<()> {
        if self.in_request {
            self.left_out.ncp_version = !has_version; // [NCP-WIRE-035]
            return Ok(());
        }
        if !has_kind && !self.is_building() {
            return Err(self.error(DecodeProblem::KindMissing).inside("kind")); // [NCP-WIRE-028]
        }
        if !has_version && self.purpose == Purpose::ReceiveStrict {
            // [NCP-STRICT-002]
            return Err(self.error(DecodeProblem::Missing).inside("ncp_version"));
        }
        Ok(())
    }

    /// Takes note that a required field is not there.
    #[cold]
    pub(crate) fn lacks(&mut self, name: &'static str) -> Result<()> {
        if self.in_request && name == "session_id" {
            self.left_out.session_id = true; // [NCP-WIRE-035]
        } else if !self.is_building() {
            return Err(self.error(DecodeProblem::Missing).inside(name)); // [NCP-WIRE-027]
        }
        Ok(())
    }

    /// How many names of ignored members are noted; those noted after it belong to what is opened
    /// after it.
    #[inline]
    pub(crate) fn mark(&self) -> usize {
        self.ignored.len()
    }

    /// Skips a member that the tables do not list; `name_at` is the place of its name.
    /// `// [NCP-WIRE-026]`
    #[cold]
    pub(crate) fn ignore(&mut self, name: &str, name_at: usize) -> Result<()> {
        if self.is_building() {
            return Err(DecodeError::new(DecodeProblem::NoSuchField, name_at).inside(name));
        }
        self.note(name, name_at);
        self.skip_value().map_err(|e| e.inside(name))
    }

    /// Fails if a member was ignored twice since `mark`, and forgets the notes. `// [NCP-WIRE-007]`
    #[inline]
    pub(crate) fn no_repeats(&mut self, mark: usize) -> Result<()> {
        if self.ignored.len() > mark + 1 {
            self.find_repeat(mark)?;
        }
        self.ignored.truncate(mark);
        Ok(())
    }

    fn note(&mut self, name: &str, name_at: usize) {
        let hash = fnv1a_64(name.as_bytes());
        let hash = (hash ^ (hash >> 32)) << 32;
        // A frame is far shorter than 4 GiB.
        self.ignored.push(hash | (name_at as u64 & u64::from(u32::MAX)));
    }

    /// Names of one hash stand next to each other once sorted; those, few unless somebody meant
    /// them to be many, are then sorted by their text, so that the time stays n log n.
    fn find_repeat(&mut self, mark: usize) -> Result<()> {
        let here = self.at;
        let mut all = std::mem::take(&mut self.ignored);
        let notes = all.get_mut(mark..).unwrap_or_default();
        notes.sort_unstable();
        for group in notes.chunk_by(|a, b| a >> 32 == b >> 32).filter(|group| group.len() > 1) {
            let mut names = Vec::with_capacity(group.len());
            for note in group {
                self.at = (note & u64::from(u32::MAX)) as usize;
                names.push((self.string_here()?, *note));
            }
            names.sort_unstable();
            let repeat = names.windows(2).find(|pair| matches!(pair, [a, b] if a.0 == b.0));
            if let Some([_, (name, note)]) = repeat {
                self.at = (note & u64::from(u32::MAX)) as usize;
                return Err(self.error(DecodeProblem::Repeated).inside(name));
            }
        }
        self.at = here;
        self.ignored = all;
        Ok(())
    }

    // ---- arrays ----------------------------------------------------------------------------

    /// Enters an array; whether it has an item. `expected` names it in the error.
    #[inline]
    pub(crate) fn open_array(&mut self, expected: JsonType) -> Result<bool> {
        if self.peek() != b'[' {
            return Err(self.wrong_type(expected));
        }
        self.open()?;
        if self.peek() == b']' {
            self.close();
            return Ok(false);
        }
        Ok(true)
    }

    /// After an item: whether another follows. Leaves the array when not.
    #[inline]
    pub(crate) fn next_item(&mut self) -> Result<bool> {
        self.space();
        match self.peek() {
            b',' => {
                self.at += 1;
                self.space();
                Ok(true)
            }
            b']' => {
                self.close();
                Ok(false)
            }
            _ => Err(self.syntax("',' or ']'")),
        }
    }

    /// How many items can still follow in an array of numbers: the commas up to its end.
    pub(crate) fn items_ahead(&self) -> usize {
        let ahead = self.bytes.get(self.at..).unwrap_or_default();
        let end = ahead.iter().position(|&b| b == b']').unwrap_or(ahead.len());
        ahead.get(..end).unwrap_or_default().iter().filter(|&&b| b == b',').count() + 1
    }

    // ---- scalars ---------------------------------------------------------------------------

    /// A number as the nearest double. `// [NCP-WIRE-012]`
    #[inline]
    pub(crate) fn double(&mut self) -> Result<f64> {
        if !matches!(self.peek(), b'-' | b'0'..=b'9') {
            return self.no_number();
        }
        let number = self.number()?;
        self.nearest_double(&number)
    }

    /// An integer in its one spelling, within ±(2^53 − 1).
    pub(crate) fn integer(&mut self) -> Result<i64> {
        if !matches!(self.peek(), b'-' | b'0'..=b'9') {
            return Err(self.wrong_type(JsonType::Integer));
        }
        let number = self.number()?;
        if !number.is_integer || (number.negative && number.mantissa == 0) {
            return Err(DecodeError::new(DecodeProblem::IntegerSpelling, number.start)); // [NCP-WIRE-010]
        }
        // A program may hold any i64, and learns from the encoder that it cannot be sent.
        let largest = if self.is_building() { i64::MAX } else { MAX_INTEGER };
        i64::try_from(number.mantissa)
            .ok()
            .filter(|&magnitude| number.digits <= 19 && magnitude <= largest)
            .map(|magnitude| if number.negative { -magnitude } else { magnitude })
            .ok_or_else(|| DecodeError::new(DecodeProblem::IntegerRange, number.start)) // [NCP-WIRE-011]
    }

    /// `true` or `false`.
    pub(crate) fn boolean(&mut self) -> Result<bool> {
        if self.eat_literal("true") {
            return Ok(true);
        }
        if self.eat_literal("false") {
            return Ok(false);
        }
        Err(self.wrong_type(JsonType::Boolean))
    }

    /// A string, borrowed unless it has escapes.
    #[inline]
    pub(crate) fn string(&mut self) -> Result<Cow<'a, str>> {
        if self.peek() != b'"' {
            return Err(self.wrong_type(JsonType::String));
        }
        self.string_here()
    }

    /// `null`, if it stands here.
    #[inline]
    pub(crate) fn eat_null(&mut self) -> bool {
        self.peek() == b'n' && self.eat_literal("null")
    }

    /// Where the reader stands, in bytes.
    #[inline]
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Skips any value, with all the strictness of one that is kept. Recurses once a level, of
    /// which there are [`MAX_LEVELS`] at most.
    pub(crate) fn skip_value(&mut self) -> Result<()> {
        match self.peek() {
            b'{' => {
                let mark = self.mark();
                let mut more = self.open_object(JsonType::Object(""))?;
                while more {
                    let name_at = self.at;
                    let name = self.name()?;
                    self.note(&name, name_at);
                    self.skip_value()?;
                    more = self.next_member()?;
                }
                self.no_repeats(mark)
            }
            b'[' => {
                let mut more = self.open_array(JsonType::Object(""))?;
                while more {
                    self.skip_value()?;
                    more = self.next_item()?;
                }
                Ok(())
            }
            b'"' => self.string_here().map(drop),
            b'-' | b'0'..=b'9' => {
                let number = self.number()?;
                self.nearest_double(&number).map(drop) // [NCP-WIRE-014]
            }
            _ if ["null", "true", "false"].into_iter().any(|l| self.eat_literal(l)) => Ok(()),
            _ => Err(self.syntax("a value")),
        }
    }
}

/// A number of the JSON grammar.
struct Number {
    start: usize,
    negative: bool,
    /// Without fraction and exponent.
    is_integer: bool,
    /// Digits before the exponent, leading zeros included.
    digits: usize,
    /// Those digits as an integer, if they are 19 at most; else it has wrapped.
    mantissa: u64,
    /// The power of ten that scales the mantissa; saturated.
    exponent: i64,
}

impl<'a> Reader<'a> {
    /// A number by the grammar. `// [NCP-WIRE-002]`
    #[inline]
    fn number(&mut self) -> Result<Number> {
        let start = self.at;
        let negative = self.peek() == b'-';
        self.at += usize::from(negative);
        let mut mantissa = 0;
        let leading = self.peek();
        let whole = self.digits(&mut mantissa)?;
        if leading == b'0' && whole > 1 {
            return Err(DecodeError::new(DecodeProblem::Syntax("no leading zero"), start));
        }
        let mut number = Number { start, negative, is_integer: true, digits: whole, mantissa, exponent: 0 };
        if self.peek() == b'.' {
            self.at += 1;
            let fraction = self.digits(&mut number.mantissa)?;
            number.is_integer = false;
            number.digits += fraction;
            number.exponent = -(fraction as i64);
        }
        if matches!(self.peek(), b'e' | b'E') {
            self.at += 1;
            number.is_integer = false;
            let exponent = self.exponent()?;
            number.exponent = number.exponent.saturating_add(exponent);
        }
        Ok(number)
    }

    /// One digit or more; how many.
    #[inline]
    fn digits(&mut self, value: &mut u64) -> Result<usize> {
        let start = self.at;
        while let digit @ 0..=9 = self.peek().wrapping_sub(b'0') {
            *value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
            self.at += 1;
        }
        if self.at == start {
            return Err(self.syntax("a digit"));
        }
        Ok(self.at - start)
    }

    fn exponent(&mut self) -> Result<i64> {
        let negative = self.peek() == b'-';
        if matches!(self.peek(), b'+' | b'-') {
            self.at += 1;
        }
        if !self.peek().is_ascii_digit() {
            return Err(self.syntax("a digit"));
        }
        let mut exponent = 0_i64;
        while let digit @ 0..=9 = self.peek().wrapping_sub(b'0') {
            exponent = exponent.saturating_mul(10).saturating_add(i64::from(digit));
            self.at += 1;
        }
        Ok(if negative { -exponent } else { exponent })
    }

    /// The double next to a number, ties to even. `// [NCP-WIRE-015]`
    #[inline]
    fn nearest_double(&self, number: &Number) -> Result<f64> {
        // Clinger's fast path: both operands are exact doubles, so one rounding remains.
        const EXACT: u64 = 1 << 53;
        if number.digits <= 19 && number.mantissa <= EXACT {
            let mantissa = number.mantissa as f64;
            let scaled = match number.exponent {
                0 => Some(mantissa),
                power @ -22..=-1 => POWERS_OF_TEN.get(-power as usize).map(|p| mantissa / p),
                power @ 1..=22 => POWERS_OF_TEN.get(power as usize).map(|p| mantissa * p),
                _ => None,
            };
            if let Some(magnitude) = scaled {
                return Ok(if number.negative { -magnitude } else { magnitude });
            }
        }
        self.nearest_double_of_token(number.start)
    }

    /// The standard library rounds correctly, whatever the digits.
    #[cold]
    fn nearest_double_of_token(&self, start: usize) -> Result<f64> {
        let token = self.text.get(start..self.at).unwrap_or_default();
        match token.parse::<f64>() {
            Ok(double) if double.is_finite() => Ok(double),
            _ => Err(DecodeError::new(DecodeProblem::NumberTooLarge, start)), // [NCP-WIRE-013]
        }
    }

    /// What stands where a number is expected: for a program also the spelling of one that JSON
    /// lacks.
    #[cold]
    fn no_number(&mut self) -> Result<f64> {
        let at = self.at;
        if self.is_building() && self.peek() == b'"' {
            match &*self.string_here()? {
                "NaN" => return Ok(f64::NAN),
                "Infinity" => return Ok(f64::INFINITY),
                "-Infinity" => return Ok(f64::NEG_INFINITY),
                "-0" => return Ok(-0.0),
                _ => self.at = at,
            }
        }
        Err(self.wrong_type(JsonType::Number))
    }

    /// A string; its quotation mark stands here.
    #[inline]
    fn string_here(&mut self) -> Result<Cow<'a, str>> {
        let start = self.at + 1;
        let end = start + plain_len(self.bytes.get(start..).unwrap_or_default());
        self.at = end;
        if self.peek() == b'"' {
            self.at += 1;
            return Ok(Cow::Borrowed(self.text.get(start..end).unwrap_or_default()));
        }
        self.escaped_string(start)
    }

    /// Goes on with a string at its first backslash.
    #[cold]
    fn escaped_string(&mut self, start: usize) -> Result<Cow<'a, str>> {
        let mut string = String::from(self.text.get(start..self.at).unwrap_or_default());
        loop {
            match self.peek() {
                b'"' => {
                    self.at += 1;
                    return Ok(Cow::Owned(string));
                }
                b'\\' => string.push(self.escape()?),
                _ if self.at == self.bytes.len() => return Err(self.syntax("'\"'")),
                _ => return Err(self.syntax("no control character in a string")),
            }
            let plain = self.at;
            self.at += plain_len(self.bytes.get(plain..).unwrap_or_default());
            string.push_str(self.text.get(plain..self.at).unwrap_or_default());
        }
    }

    /// An escape; its backslash stands here.
    fn escape(&mut self) -> Result<char> {
        let at = self.at;
        self.at += 1;
        let simple = match self.peek() {
            c @ (b'"' | b'\\' | b'/') => char::from(c),
            b'b' => '\u{8}',
            b'f' => '\u{c}',
            b'n' => '\n',
            b'r' => '\r',
            b't' => '\t',
            b'u' => return self.unicode_escape(at),
            _ => return Err(self.syntax("an escape")),
        };
        self.at += 1;
        Ok(simple)
    }

    /// `\uXXXX`, or two of them that make a pair of surrogates. `// [NCP-WIRE-008]`
    fn unicode_escape(&mut self, at: usize) -> Result<char> {
        let unpaired = || DecodeError::new(DecodeProblem::LoneSurrogate, at);
        let unit = self.hex_unit()?;
        if let Some(character) = char::from_u32(unit) {
            return Ok(character);
        }
        let follows = self.bytes.get(self.at..).unwrap_or_default().starts_with(b"\\u");
        if unit >= 0xdc00 || !follows {
            return Err(unpaired());
        }
        self.at += 1;
        let low = self.hex_unit()?;
        if !(0xdc00..0xe000).contains(&low) {
            return Err(unpaired());
        }
        char::from_u32(0x1_0000 + ((unit - 0xd800) << 10) + (low - 0xdc00)).ok_or_else(unpaired)
    }

    /// The four digits behind a `u`, which stands here.
    fn hex_unit(&mut self) -> Result<u32> {
        let mut unit = 0;
        for _ in 0..4 {
            self.at += 1;
            let digit = char::from(self.peek()).to_digit(16);
            unit = unit << 4 | digit.ok_or_else(|| self.syntax("four hexadecimal digits"))?;
        }
        self.at += 1;
        Ok(unit)
    }

    // ---- bytes -----------------------------------------------------------------------------

    /// The byte here. At the end 0, which no JSON text holds outside a string, and as itself not
    /// even there.
    #[inline]
    fn peek(&self) -> u8 {
        self.bytes.get(self.at).copied().unwrap_or(0)
    }

    #[inline]
    fn space(&mut self) {
        // [NCP-WIRE-005]
        while matches!(self.peek(), b' ' | b'\t' | b'\n' | b'\r') {
            self.at += 1;
        }
    }

    fn eat_literal(&mut self, literal: &str) -> bool {
        let found = self.bytes.get(self.at..).unwrap_or_default().starts_with(literal.as_bytes());
        self.at += if found { literal.len() } else { 0 };
        found
    }

    #[inline]
    fn open(&mut self) -> Result<()> {
        if self.level == MAX_LEVELS {
            return Err(self.error(DecodeProblem::TooDeep)); // [NCP-WIRE-064] [NCP-WIRE-065]
        }
        self.level += 1;
        self.at += 1;
        self.space();
        Ok(())
    }

    #[inline]
    fn close(&mut self) {
        self.level -= 1;
        self.at += 1;
    }

    #[cold]
    fn syntax(&self, expected: &'static str) -> DecodeError {
        self.error(DecodeProblem::Syntax(expected))
    }

    /// The error for a value of another type, or for what is no value. `// [NCP-WIRE-020]`
    #[cold]
    fn wrong_type(&self, expected: JsonType) -> DecodeError {
        let problem = match self.peek() {
            b'n' => DecodeProblem::Null { expected }, // [NCP-WIRE-021]
            b'"' => DecodeProblem::WrongType { expected, found: JsonType::String },
            b'{' => DecodeProblem::WrongType { expected, found: JsonType::Object("") },
            b'[' => DecodeProblem::WrongType { expected, found: JsonType::Array(&JsonType::Number) },
            b't' | b'f' => DecodeProblem::WrongType { expected, found: JsonType::Boolean },
            b'-' | b'0'..=b'9' => DecodeProblem::WrongType { expected, found: JsonType::Number },
            _ => DecodeProblem::Syntax("a value"),
        };
        self.error(problem)
    }
}

/// The powers of ten that a double holds exactly.
const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];
