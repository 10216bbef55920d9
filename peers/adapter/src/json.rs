//! JSON of the conversation, read and written bit for bit.
//!
//! It is not read by `serde_json`, on purpose. Cargo builds a crate once for a whole program, with the features of all
//! who use it: an adapter that asks `serde_json` for exact numbers, or for the order of members, switches that on in
//! the implementation under test as well, and hides what is wrong without it.
//!
//! A double is what PROTOCOL.md, section 2, calls one, wherever a type wants an `f64` or an `f32`: the four strings are
//! read and written there, so that the messages of an implementation that have serde's traits need no wrapper.

use std::borrow::Cow;
use std::fmt::{self, Display, Write as _};

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserialize, DeserializeSeed, Deserializer, IntoDeserializer as _, Visitor};
use serde::ser::{self, Serialize, Serializer};

/// How deep arrays and objects may stand within each other.
const MAX_DEPTH: usize = 200;
/// Up to so many bytes of a string are looked at one by one, the rest in blocks of as many.
const SHORT: usize = 64;
/// The name by which [`Raw`] tells reader and writer that it is one.
const RAW: &str = "$ncp_adapter::Raw";

/// Reads a JSON text.
///
/// # Errors
/// It is not JSON, or not of this type.
pub fn read<'de, T: Deserialize<'de>>(text: &'de str) -> Result<T, JsonError> {
    let mut reader = Reader { text, at: 0, depth: 0 };
    let value = T::deserialize(&mut reader)?;
    if reader.peek().is_some() { Err(reader.expected("the end")) } else { Ok(value) }
}

/// Writes a value as JSON, on one line.
///
/// # Errors
/// It has no JSON: a map's key is no string.
pub fn write(value: &(impl Serialize + ?Sized)) -> Result<String, JsonError> {
    let mut writer = Writer { out: String::new(), raw: false };
    value.serialize(&mut writer)?;
    Ok(writer.out)
}

/// Why there is no value, or no JSON.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum JsonError {
    /// The text is not JSON.
    #[error("expected {what} at byte {at}")]
    Expected {
        /// What should stand there.
        what: &'static str,
        /// Where.
        at: usize,
    },
    /// The JSON is not of the type that is asked for, or the value cannot be written.
    #[error("{0}")]
    Type(String),
}

impl de::Error for JsonError {
    fn custom<T: Display>(message: T) -> Self {
        Self::Type(message.to_string())
    }
}

impl ser::Error for JsonError {
    fn custom<T: Display>(message: T) -> Self {
        Self::Type(message.to_string())
    }
}

/// A part of a request as the text that it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Raw<'a>(&'a str);

impl<'a> Raw<'a> {
    /// Text that is known to be JSON.
    pub(crate) fn of(text: &'a str) -> Self {
        Self(text)
    }

    /// The JSON text.
    #[must_use]
    pub fn get(self) -> &'a str {
        self.0
    }
}

impl Display for Raw<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

impl<'de: 'a, 'a> Deserialize<'de> for Raw<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct RawVisitor;

        impl<'de> Visitor<'de> for RawVisitor {
            type Value = Raw<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("JSON")
            }

            fn visit_borrowed_str<E: de::Error>(self, text: &'de str) -> Result<Raw<'de>, E> {
                Ok(Raw(text))
            }
        }

        deserializer.deserialize_newtype_struct(RAW, RawVisitor)
    }
}

impl Serialize for Raw<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_newtype_struct(RAW, self.0)
    }
}

/// The double that one of the four strings stands for, or `None`.
pub(crate) fn double_of_name(name: &str) -> Option<f64> {
    match name {
        "NaN" => Some(f64::NAN),
        "Infinity" => Some(f64::INFINITY),
        "-Infinity" => Some(f64::NEG_INFINITY),
        "-0" => Some(-0.0),
        _ => None,
    }
}

/// How many bytes from the start stand for themselves within a string: no quote, no backslash, no control character.
fn plain(bytes: &[u8]) -> usize {
    let end = |bytes: &[u8]| bytes.iter().position(|byte| matches!(byte, b'"' | b'\\') || *byte < b' ');
    // Most strings are short. Of a long one, many bytes are looked at at once: without a branch, the compiler can.
    let (start, rest) = bytes.split_at(bytes.len().min(SHORT));
    let ends = |byte: &u8| u8::from((*byte == b'"') | (*byte == b'\\') | (*byte < b' '));
    let is_plain = |block: &&[u8]| block.iter().fold(0, |found, byte| found | ends(byte)) == 0;
    end(start).unwrap_or_else(|| {
        let blocks = rest.chunks_exact(SHORT).take_while(is_plain).count() * SHORT;
        let last = rest.get(blocks..).unwrap_or_default();
        start.len() + blocks + end(last).unwrap_or(last.len())
    })
}

struct Reader<'de> {
    text: &'de str,
    at: usize,
    depth: usize,
}

impl<'de> Reader<'de> {
    fn expected(&self, what: &'static str) -> JsonError {
        JsonError::Expected { what, at: self.at }
    }

    /// The rest of the text.
    fn rest(&self) -> &'de [u8] {
        self.text.as_bytes().get(self.at..).unwrap_or_default()
    }

    /// The next byte that is not white space.
    fn peek(&mut self) -> Option<u8> {
        let white = self.rest().iter().take_while(|byte| matches!(byte, b' ' | b'\t' | b'\n' | b'\r')).count();
        self.at += white;
        self.rest().first().copied()
    }

    /// Takes a byte if it comes next.
    fn eat(&mut self, byte: u8) -> bool {
        let there = self.peek() == Some(byte);
        self.at += usize::from(there);
        there
    }

    fn word(&mut self, word: &'static str) -> Result<(), JsonError> {
        if !self.rest().starts_with(word.as_bytes()) {
            return Err(self.expected("a JSON value"));
        }
        self.at += word.len();
        Ok(())
    }

    /// The spelling of a number.
    fn number(&mut self) -> Result<&'de str, JsonError> {
        let start = self.at;
        let digits = |reader: &mut Self| {
            let count = reader.rest().iter().take_while(|byte| byte.is_ascii_digit()).count();
            reader.at += count;
            if count == 0 { Err(reader.expected("a JSON value")) } else { Ok(count) }
        };
        let next_is = |reader: &Self, bytes: &[u8]| reader.rest().first().is_some_and(|byte| bytes.contains(byte));
        self.at += usize::from(next_is(self, b"-"));
        let zero = next_is(self, b"0");
        if digits(self)? > 1 && zero {
            return Err(self.expected("no digit behind a leading zero"));
        }
        if next_is(self, b".") {
            self.at += 1;
            digits(self)?;
        }
        if next_is(self, b"eE") {
            self.at += 1;
            self.at += usize::from(next_is(self, b"+-"));
            digits(self)?;
        }
        Ok(&self.text[start..self.at])
    }

    /// A number as the nearest double; Rust's own reader is exact.
    fn double(&mut self) -> Result<f64, JsonError> {
        let value = self.number()?.parse().ok().filter(|value: &f64| value.is_finite());
        value.ok_or_else(|| self.expected("a number that a double can hold"))
    }

    /// Goes to the end of a string without its quotes; whether it has escapes.
    fn pass_string(&mut self) -> Result<(&'de str, bool), JsonError> {
        if !self.eat(b'"') {
            return Err(self.expected("a string"));
        }
        let (start, mut escapes) = (self.at, false);
        loop {
            self.at += plain(self.rest());
            match self.rest() {
                [b'"', ..] => {
                    self.at += 1;
                    return Ok((&self.text[start..self.at - 1], escapes));
                }
                [b'\\', b'"' | b'\\' | b'/' | b'b' | b'f' | b'n' | b'r' | b't', ..] => self.at += 2,
                [b'\\', b'u', digits @ ..] if digits.len() >= 4 && digits[..4].iter().all(u8::is_ascii_hexdigit) => {
                    self.at += 6;
                }
                _ => return Err(self.expected("the end of a string")),
            }
            escapes = true;
        }
    }

    fn string(&mut self) -> Result<Cow<'de, str>, JsonError> {
        let (inside, escapes) = self.pass_string()?;
        if !escapes {
            return Ok(Cow::Borrowed(inside));
        }
        let mut text = String::with_capacity(inside.len());
        let mut rest = inside;
        while let Some((plain, escape)) = rest.split_once('\\') {
            text.push_str(plain);
            let (c, length) = self.escape(escape)?;
            text.push(c);
            rest = &escape[length..];
        }
        text.push_str(rest);
        Ok(Cow::Owned(text))
    }

    /// The character of an escape that is known to be one, and how many bytes it takes behind the backslash.
    fn escape(&self, escape: &str) -> Result<(char, usize), JsonError> {
        let unit = |at: usize| escape.get(at..at + 4).and_then(|digits| u32::from_str_radix(digits, 16).ok());
        let plain = match escape.as_bytes().first() {
            Some(b'b') => '\u{8}',
            Some(b'f') => '\u{c}',
            Some(b'n') => '\n',
            Some(b'r') => '\r',
            Some(b't') => '\t',
            Some(b'u') => {
                let low = || unit(7).filter(|low| escape[5..].starts_with("\\u") && (0xdc00..0xe000).contains(low));
                return match (unit(1), low()) {
                    (Some(high @ 0xd800..0xdc00), Some(low)) => {
                        char::from_u32(0x1_0000 + ((high - 0xd800) << 10) + (low - 0xdc00)).map(|c| (c, 11))
                    }
                    (Some(unit), _) => char::from_u32(unit).map(|c| (c, 5)),
                    (None, _) => None,
                }
                .ok_or_else(|| self.expected("no half of a surrogate pair before"));
            }
            Some(other) => char::from(*other),
            None => return Err(self.expected("the end of a string")),
        };
        Ok((plain, 1))
    }

    /// Goes behind a value; its text.
    fn skip(&mut self) -> Result<&'de str, JsonError> {
        let first = self.peek();
        let start = self.at;
        match first {
            Some(b'"') => self.pass_string().map(drop)?,
            Some(open @ (b'[' | b'{')) => {
                let mut items = Items::open(self, open)?;
                while items.more()? {
                    if open == b'{' {
                        items.reader.pass_string()?;
                        items.colon()?;
                    }
                    items.reader.skip()?;
                }
                items.close()?;
            }
            Some(b't') => self.word("true")?,
            Some(b'f') => self.word("false")?,
            Some(b'n') => self.word("null")?,
            _ => self.number().map(drop)?,
        }
        Ok(&self.text[start..self.at])
    }
}

/// What stands between two brackets.
struct Items<'r, 'de> {
    reader: &'r mut Reader<'de>,
    end: u8,
    first: bool,
    closed: bool,
}

impl<'r, 'de> Items<'r, 'de> {
    fn open(reader: &'r mut Reader<'de>, open: u8) -> Result<Self, JsonError> {
        reader.at += 1;
        reader.depth += 1;
        if reader.depth > MAX_DEPTH {
            return Err(reader.expected("JSON that is less deep"));
        }
        Ok(Self { reader, end: if open == b'{' { b'}' } else { b']' }, first: true, closed: false })
    }

    /// Whether there is another one, at which the reader then stands.
    fn more(&mut self) -> Result<bool, JsonError> {
        self.closed = self.closed || self.reader.eat(self.end);
        if self.closed {
            return Ok(false);
        }
        if !std::mem::take(&mut self.first) && !self.reader.eat(b',') {
            return Err(self.reader.expected("a comma or the end of an array or an object"));
        }
        Ok(true)
    }

    fn colon(&mut self) -> Result<(), JsonError> {
        if self.reader.eat(b':') { Ok(()) } else { Err(self.reader.expected("a colon")) }
    }

    /// That nothing is left.
    fn close(mut self) -> Result<(), JsonError> {
        if self.more()? {
            return Err(self.reader.expected("the end of an array"));
        }
        self.reader.depth -= 1;
        Ok(())
    }
}

impl<'de> de::SeqAccess<'de> for &mut Items<'_, 'de> {
    type Error = JsonError;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, JsonError> {
        if self.more()? { seed.deserialize(&mut *self.reader).map(Some) } else { Ok(None) }
    }
}

impl<'de> de::MapAccess<'de> for &mut Items<'_, 'de> {
    type Error = JsonError;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, JsonError> {
        if !self.more()? {
            return Ok(None);
        }
        if self.reader.peek() == Some(b'"') {
            seed.deserialize(&mut *self.reader).map(Some)
        } else {
            Err(self.reader.expected("a member"))
        }
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, JsonError> {
        self.colon()?;
        seed.deserialize(&mut *self.reader)
    }
}

impl<'de> Deserializer<'de> for &mut Reader<'de> {
    type Error = JsonError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.peek() {
            Some(b'"') => match self.string()? {
                Cow::Borrowed(text) => visitor.visit_borrowed_str(text),
                Cow::Owned(text) => visitor.visit_string(text),
            },
            Some(open @ (b'[' | b'{')) => {
                let mut items = Items::open(self, open)?;
                let value = if open == b'{' { visitor.visit_map(&mut items) } else { visitor.visit_seq(&mut items) }?;
                items.close()?;
                Ok(value)
            }
            Some(b't') => self.word("true").and_then(|()| visitor.visit_bool(true)),
            Some(b'f') => self.word("false").and_then(|()| visitor.visit_bool(false)),
            Some(b'n') => self.word("null").and_then(|()| visitor.visit_unit()),
            _ => {
                let start = self.at;
                let spelling = self.number()?;
                // An integer has no sign of its zero.
                match (spelling.parse::<i64>(), spelling.parse::<u64>()) {
                    (Ok(value), _) if spelling != "-0" => visitor.visit_i64(value),
                    (_, Ok(value)) => visitor.visit_u64(value),
                    _ => {
                        self.at = start;
                        visitor.visit_f64(self.double()?)
                    }
                }
            }
        }
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.peek() {
            Some(b'"') => {
                let name = self.string()?;
                match double_of_name(&name) {
                    Some(value) => visitor.visit_f64(value),
                    None => Err(de::Error::invalid_value(de::Unexpected::Str(&name), &visitor)),
                }
            }
            Some(b'-' | b'0'..=b'9') => visitor.visit_f64(self.double()?),
            _ => self.deserialize_any(visitor),
        }
    }

    fn deserialize_f32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        self.deserialize_f64(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        if self.peek() == Some(b'n') {
            self.word("null").and_then(|()| visitor.visit_none())
        } else {
            visitor.visit_some(self)
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, name: &str, visitor: V) -> Result<V::Value, JsonError> {
        if name == RAW { visitor.visit_borrowed_str(self.skip()?) } else { visitor.visit_newtype_struct(self) }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, JsonError> {
        if self.peek() != Some(b'{') {
            return visitor.visit_enum(self.string()?.into_deserializer());
        }
        let mut items = Items::open(self, b'{')?;
        let value = visitor.visit_enum(MapAccessDeserializer::new(&mut items))?;
        items.close()?;
        Ok(value)
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        self.skip()?;
        visitor.visit_unit()
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 u8 u16 u32 u64 char str string bytes byte_buf unit unit_struct seq tuple tuple_struct map
        struct identifier
    }
}

struct Writer {
    out: String,
    /// The string that comes is JSON.
    raw: bool,
}

impl Writer {
    fn open<'w>(&'w mut self, brackets: &[&'static str; 2]) -> Compound<'w> {
        self.out.push_str(brackets[0]);
        Compound { writer: self, end: brackets[1], first: true }
    }

    fn variant<'w>(&'w mut self, name: &str, brackets: &[&'static str; 2]) -> Result<Compound<'w>, JsonError> {
        self.out.push('{');
        self.serialize_str(name)?;
        self.out.push(':');
        Ok(self.open(brackets))
    }

    fn shown(&mut self, value: impl Display) -> Result<(), JsonError> {
        write!(self.out, "{value}").map_err(ser::Error::custom)
    }
}

const ARRAY: [&str; 2] = ["[", "]"];
const OBJECT: [&str; 2] = ["{", "}"];
const ARRAY_OF_VARIANT: [&str; 2] = ["[", "]}"];
const OBJECT_OF_VARIANT: [&str; 2] = ["{", "}}"];

macro_rules! integers {
    ($($method:ident: $integer:ty),+) => {$(
        fn $method(self, value: $integer) -> Result<(), JsonError> {
            self.shown(value)
        }
    )+};
}

impl<'w> Serializer for &'w mut Writer {
    type Ok = ();
    type Error = JsonError;
    type SerializeSeq = Compound<'w>;
    type SerializeTuple = Compound<'w>;
    type SerializeTupleStruct = Compound<'w>;
    type SerializeTupleVariant = Compound<'w>;
    type SerializeMap = Compound<'w>;
    type SerializeStruct = Compound<'w>;
    type SerializeStructVariant = Compound<'w>;

    integers! {
        serialize_bool: bool, serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64,
        serialize_u8: u8, serialize_u16: u16, serialize_u32: u32, serialize_u64: u64
    }

    fn serialize_f32(self, value: f32) -> Result<(), JsonError> {
        self.serialize_f64(f64::from(value))
    }

    fn serialize_f64(self, value: f64) -> Result<(), JsonError> {
        if value.is_nan() {
            self.serialize_str("NaN")
        } else if value.is_infinite() {
            self.serialize_str(if value > 0.0 { "Infinity" } else { "-Infinity" })
        } else if value == 0.0 && value.is_sign_negative() {
            self.serialize_str("-0")
        } else {
            // The shortest spelling that reads back.
            self.shown(format_args!("{value:?}"))
        }
    }

    fn serialize_char(self, value: char) -> Result<(), JsonError> {
        self.serialize_str(value.encode_utf8(&mut [0; 4]))
    }

    fn serialize_str(self, text: &str) -> Result<(), JsonError> {
        if std::mem::take(&mut self.raw) {
            self.out.push_str(text);
            return Ok(());
        }
        self.out.push('"');
        let mut rest = text;
        loop {
            let at = plain(rest.as_bytes());
            self.out.push_str(&rest[..at]);
            match rest.as_bytes().get(at) {
                None => break,
                Some(byte @ (b'"' | b'\\')) => {
                    self.out.push('\\');
                    self.out.push(char::from(*byte));
                }
                Some(byte) => self.shown(format_args!("\\u{byte:04x}"))?,
            }
            rest = &rest[at + 1..];
        }
        self.out.push('"');
        Ok(())
    }

    fn serialize_bytes(self, bytes: &[u8]) -> Result<(), JsonError> {
        self.collect_seq(bytes)
    }

    fn serialize_none(self) -> Result<(), JsonError> {
        self.serialize_unit()
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), JsonError> {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Result<(), JsonError> {
        self.shown("null")
    }

    fn serialize_unit_struct(self, _: &'static str) -> Result<(), JsonError> {
        self.serialize_unit()
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, name: &'static str) -> Result<(), JsonError> {
        self.serialize_str(name)
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(self, name: &str, value: &T) -> Result<(), JsonError> {
        self.raw = name == RAW;
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        name: &'static str,
        value: &T,
    ) -> Result<(), JsonError> {
        let mut object = self.open(&OBJECT);
        object.member(name, value)?;
        object.close()
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Compound<'w>, JsonError> {
        Ok(self.open(&ARRAY))
    }

    fn serialize_tuple(self, _: usize) -> Result<Compound<'w>, JsonError> {
        Ok(self.open(&ARRAY))
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Compound<'w>, JsonError> {
        Ok(self.open(&ARRAY))
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        name: &'static str,
        _: usize,
    ) -> Result<Compound<'w>, JsonError> {
        self.variant(name, &ARRAY_OF_VARIANT)
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Compound<'w>, JsonError> {
        Ok(self.open(&OBJECT))
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Compound<'w>, JsonError> {
        Ok(self.open(&OBJECT))
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        name: &'static str,
        _: usize,
    ) -> Result<Compound<'w>, JsonError> {
        self.variant(name, &OBJECT_OF_VARIANT)
    }
}

/// An array or an object that is being written.
struct Compound<'w> {
    writer: &'w mut Writer,
    end: &'static str,
    first: bool,
}

impl Compound<'_> {
    fn element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), JsonError> {
        if !std::mem::take(&mut self.first) {
            self.writer.out.push(',');
        }
        value.serialize(&mut *self.writer)
    }

    fn value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), JsonError> {
        self.writer.out.push(':');
        value.serialize(&mut *self.writer)
    }

    fn member<T: Serialize + ?Sized>(&mut self, name: &str, value: &T) -> Result<(), JsonError> {
        self.element(name)?;
        self.value(value)
    }

    fn close(self) -> Result<(), JsonError> {
        self.writer.out.push_str(self.end);
        Ok(())
    }
}

macro_rules! arrays {
    ($($of:ident: $method:ident),+) => {$(
        impl ser::$of for Compound<'_> {
            type Ok = ();
            type Error = JsonError;

            fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), JsonError> {
                self.element(value)
            }

            fn end(self) -> Result<(), JsonError> {
                self.close()
            }
        }
    )+};
}

arrays! {
    SerializeSeq: serialize_element, SerializeTuple: serialize_element, SerializeTupleStruct: serialize_field,
    SerializeTupleVariant: serialize_field
}

macro_rules! objects {
    ($($of:ident),+) => {$(
        impl ser::$of for Compound<'_> {
            type Ok = ();
            type Error = JsonError;

            fn serialize_field<T: Serialize + ?Sized>(
                &mut self,
                name: &'static str,
                value: &T,
            ) -> Result<(), JsonError> {
                self.member(name, value)
            }

            fn end(self) -> Result<(), JsonError> {
                self.close()
            }
        }
    )+};
}

objects! { SerializeStruct, SerializeStructVariant }

impl ser::SerializeMap for Compound<'_> {
    type Ok = ();
    type Error = JsonError;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), JsonError> {
        let start = self.writer.out.len() + usize::from(!self.first);
        self.element(key)?;
        let is_text = self.writer.out.as_bytes().get(start) == Some(&b'"');
        if is_text { Ok(()) } else { Err(ser::Error::custom("the key of a map is no string")) }
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), JsonError> {
        self.value(value)
    }

    fn end(self) -> Result<(), JsonError> {
        self.close()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use std::collections::BTreeMap;

    use proptest::prelude::*;

    use super::*;

    /// A message as an implementation derives it.
    #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
    struct Message {
        seq: i64,
        count: u64,
        t: f64,
        unit: Option<String>,
        mode: Mode,
        channels: BTreeMap<String, Vec<f64>>,
        narrow: (f32, bool),
    }

    #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
    #[serde(rename_all = "snake_case")]
    enum Mode {
        Hold,
        Paced(f64),
        Timed { ttl_ms: f64 },
        Both(i32, String),
    }

    fn message() -> impl Strategy<Value = Message> {
        let mode = prop_oneof![
            Just(Mode::Hold),
            any::<f64>().prop_map(Mode::Paced),
            any::<f64>().prop_map(|ttl_ms| Mode::Timed { ttl_ms }),
            any::<(i32, String)>().prop_map(|(n, text)| Mode::Both(n, text)),
        ];
        let channels = prop::collection::btree_map(".*", prop::collection::vec(any::<f64>(), 0..4), 0..4);
        (any::<(i64, u64, f64, Option<String>)>(), mode, channels, any::<(f32, bool)>()).prop_map(
            |((seq, count, t, unit), mode, channels, narrow)| Message { seq, count, t, unit, mode, channels, narrow },
        )
    }

    proptest! {
        #[test]
        fn the_plain_bytes_of_a_string_end_where_the_first_other_one_is(plain_ones in 0_usize..300, then: Vec<u8>) {
            let bytes = [vec![b'x'; plain_ones], then].concat();
            let first = bytes.iter().position(|byte| *byte < b' ' || *byte == b'"' || *byte == b'\\');
            prop_assert_eq!(plain(&bytes), first.unwrap_or(bytes.len()));
        }

        #[test]
        fn a_message_comes_back_bit_for_bit(message in message()) {
            let text = write(&message).unwrap();
            prop_assert_eq!(read::<Raw<'_>>(&text).unwrap().get(), &text);
            let back: Message = read(&text).unwrap();
            // Two texts are the same only if every sign and every bit is.
            prop_assert_eq!(write(&back).unwrap(), text);
            prop_assert_eq!(back, message);
        }

        #[test]
        fn every_double_comes_back_with_the_same_bits(bits: u64) {
            let value = f64::from_bits(bits);
            let back: f64 = read(&write(&value).unwrap()).unwrap();
            let same = if value.is_nan() { back.is_nan() } else { back.to_bits() == bits };
            prop_assert!(same);
        }

        #[test]
        fn no_text_makes_the_reader_panic(text in ".*", like in r#"[\[\]{}",:\\ue0-9.\- tfn]*"#) {
            for text in [text, like] {
                let _ = (read::<Raw<'_>>(&text), read::<String>(&text), read::<f64>(&text), read::<Message>(&text));
            }
        }
    }

    #[test]
    fn the_numbers_that_json_lacks_travel_as_the_four_strings() {
        let values = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 0.0, 1e300, 5e-324];
        let text = write(&values).unwrap();
        assert_eq!(text, r#"["NaN","Infinity","-Infinity","-0",0.0,1e300,5e-324]"#);
        let back: [f64; 7] = read(&text).unwrap();
        assert_eq!(back.map(f64::is_sign_negative), [false, false, true, true, false, false, false]);
        assert!(read::<f64>("-0").unwrap().is_sign_negative());
        assert!(read::<f64>(r#""nan""#).is_err() && read::<f64>("1e400").is_err());
    }

    #[test]
    fn a_number_is_read_as_the_nearest_double() {
        for (text, bits) in [
            ("9007199254740993", 0x4340_0000_0000_0000_u64),
            ("9007199254740993.0000000000000000000000000001", 0x4340_0000_0000_0001),
            ("2.2250738585072011e-308", 0x000f_ffff_ffff_ffff),
            ("1.7976931348623157e308", 0x7fef_ffff_ffff_ffff),
            ("2.5e-324", 0x0000_0000_0000_0001),
        ] {
            assert_eq!(read::<f64>(text).unwrap().to_bits(), bits, "{text}");
        }
    }

    #[test]
    fn escapes_are_read_and_a_half_of_a_surrogate_pair_is_refused() {
        assert_eq!(read::<String>(r#""\u00e9\ud83d\ude00\n\"\/é""#).unwrap(), "é\u{1f600}\n\"/é");
        for text in [r#""\ud83d""#, r#""\ud83dé""#, r#""\ud83d\u0041""#, r#""\ude00""#, r#""\x""#, r#""\u00g0""#] {
            assert!(read::<String>(text).is_err(), "{text}");
        }
    }

    #[test]
    fn what_is_not_json_is_refused_with_its_place() {
        let wrong = [
            "",
            "{",
            "[1,]",
            "[,1]",
            "[1 2]",
            "{\"a\":1,}",
            "{\"a\"}",
            "{a:1}",
            "01",
            "-",
            "1.",
            ".5",
            "1e",
            "+1",
            "nul",
            "\"a",
            "\"a\nb\"",
            "1 2",
            "[}",
            "NaN",
        ];
        for text in wrong {
            assert!(matches!(read::<Raw<'_>>(text), Err(JsonError::Expected { .. })), "{text}");
        }
        assert_eq!(read::<Raw<'_>>("[1,]").unwrap_err().to_string(), "expected a JSON value at byte 3");
        assert_eq!(read::<(i64, i64)>("[1,2,3]").unwrap_err().to_string(), "expected the end of an array at byte 5");
        assert!(read::<Raw<'_>>(&"[".repeat(10_000)).is_err());
        assert!(write(&BTreeMap::from([(1, 2)])).is_err());
    }

    #[test]
    fn a_part_stays_the_text_that_it_is_and_members_that_nobody_wants_are_passed_over() {
        #[derive(serde::Serialize, serde::Deserialize)]
        struct Part<'a> {
            #[serde(borrow)]
            part: Raw<'a>,
            #[serde(borrow)]
            none: Option<Raw<'a>>,
        }

        let text = r#" { "other" : [ {"x":"\u0041"}, null ] , "part" : {"a": 1e400 } , "none" : null } "#;
        let part: Part<'_> = read(text).unwrap();
        assert_eq!((part.part.get(), part.none), (r#"{"a": 1e400 }"#, None));
        assert_eq!(write(&part).unwrap(), r#"{"part":{"a": 1e400 },"none":null}"#);
    }
}
