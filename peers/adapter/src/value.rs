//! Numbers, bytes, columns and messages in the form that requests and answers give them (PROTOCOL.md, section 2).

use std::borrow::Cow;
use std::fmt;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::ser::{Serialize, Serializer};

use crate::error::CallError;
use crate::json::{self, Raw};

/// A double: a JSON number, or one of `"NaN"`, `"Infinity"`, `"-Infinity"`, `"-0"`.
#[derive(Debug, Clone, Copy, serde::Serialize)]
#[serde(transparent)]
pub struct Double(
    /// Its value.
    pub f64,
);

impl Double {
    /// The double that one of the four strings stands for, or `None`.
    #[must_use]
    pub fn from_name(name: &str) -> Option<f64> {
        json::double_of_name(name)
    }
}

/// Reads the four strings also where serde keeps a value before it knows its type, as in an untagged enum.
impl<'de> Deserialize<'de> for Double {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(untagged)]
        enum Spelled {
            Number(f64),
            Name(String),
        }

        match Spelled::deserialize(deserializer)? {
            Spelled::Number(value) => Ok(Self(value)),
            Spelled::Name(name) => Self::from_name(&name).map(Self).ok_or_else(|| {
                de::Error::invalid_value(de::Unexpected::Str(&name), &"a number or the name of one that JSON lacks")
            }),
        }
    }
}

/// A 64-bit integer: a string of decimal digits, since many JSON readers would round it.
#[derive(Debug, Clone, Copy)]
pub struct Long(
    /// Its value.
    pub i64,
);

impl Serialize for Long {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0)
    }
}

impl<'de> Deserialize<'de> for Long {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct LongVisitor;

        impl Visitor<'_> for LongVisitor {
            type Value = Long;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a 64-bit integer as a string of decimal digits")
            }

            fn visit_str<E: de::Error>(self, digits: &str) -> Result<Long, E> {
                let value = digits.parse().map(Long);
                value.map_err(|_| E::invalid_value(de::Unexpected::Str(digits), &self))
            }
        }

        deserializer.deserialize_str(LongVisitor)
    }
}

/// Bytes: a string of base64, padded.
#[derive(Debug)]
pub struct Bytes(
    /// What the base64 stands for.
    pub Vec<u8>,
);

impl Serialize for Bytes {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&STANDARD.encode(&self.0))
    }
}

impl<'de> Deserialize<'de> for Bytes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct BytesVisitor;

        impl Visitor<'_> for BytesVisitor {
            type Value = Bytes;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a string of padded base64")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Bytes, E> {
                STANDARD.decode(text).map(Bytes).map_err(E::custom)
            }
        }

        deserializer.deserialize_str(BytesVisitor)
    }
}

/// A column of a block: `name`, `dtype` and `data`.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// Its values.
    pub data: Data,
}

/// The values of a column, by their type.
#[derive(Debug, Clone, PartialEq)]
#[expect(missing_docs, reason = "their names say what they are")]
pub enum Data {
    F32(Vec<f32>),
    F64(Vec<f64>),
    I32(Vec<i32>),
    I64(Vec<i64>),
}

impl Serialize for Column {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Shown<'a> {
            name: &'a str,
            dtype: &'static str,
            data: &'a Data,
        }

        let Self { name, data } = self;
        let dtype = match data {
            Data::F32(_) => "f32",
            Data::F64(_) => "f64",
            Data::I32(_) => "i32",
            Data::I64(_) => "i64",
        };
        Shown { name, dtype, data }.serialize(serializer)
    }
}

impl Serialize for Data {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::F32(values) => serializer.collect_seq(values.iter().map(|value| Double(f64::from(*value)))),
            Self::F64(values) => serializer.collect_seq(values.iter().copied().map(Double)),
            Self::I32(values) => serializer.collect_seq(values),
            Self::I64(values) => serializer.collect_seq(values.iter().copied().map(Long)),
        }
    }
}

impl<'de> Deserialize<'de> for Column {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        struct Given<'a> {
            name: String,
            #[serde(borrow)]
            dtype: Cow<'a, str>,
            /// Parsed once the dtype is known, which may stand behind it.
            #[serde(borrow)]
            data: Raw<'a>,
        }

        fn values<'a, T: Deserialize<'a>, E: de::Error>(data: Raw<'a>) -> Result<T, E> {
            json::read(data.get()).map_err(E::custom)
        }

        let Given { name, dtype, data } = Given::deserialize(deserializer)?;
        let data = match &*dtype {
            "f32" => Data::F32(doubles(values(data)?).into_iter().map(|value| value as f32).collect()),
            "f64" => Data::F64(doubles(values(data)?)),
            "i32" => Data::I32(values(data)?),
            "i64" => Data::I64(longs(values(data)?)),
            _ => return Err(de::Error::unknown_variant(&dtype, &["f32", "f64", "i32", "i64"])),
        };
        Ok(Self { name, data })
    }
}

/// The plain values of some doubles.
#[must_use]
pub fn doubles(values: Vec<Double>) -> Vec<f64> {
    values.into_iter().map(|Double(value)| value).collect()
}

/// The plain values of some 64-bit integers.
#[must_use]
pub fn longs(values: Vec<Long>) -> Vec<i64> {
    values.into_iter().map(|Long(value)| value).collect()
}

/// The fields of a message, or another JSON value, as an answer shows it.
#[derive(Debug)]
pub struct Fields(String);

impl Fields {
    /// A JSON text of the implementation.
    ///
    /// # Errors
    /// It is not JSON.
    pub fn of_text(text: String) -> Result<Self, CallError> {
        json::read::<Raw<'_>>(&text)
            .map_err(|error| CallError::internal(format_args!("the implementation shows no JSON: {error}")))?;
        // An answer is one line. In JSON, a line break is white space: within a string it is escaped.
        Ok(Self(if text.contains(['\n', '\r']) { text.replace(['\n', '\r'], " ") } else { text }))
    }

    /// The JSON of a value, such as a message with serde's traits. Its doubles come bit for bit, those that JSON lacks
    /// as the strings of the protocol.
    ///
    /// # Errors
    /// It has no JSON.
    pub fn of(value: &impl Serialize) -> Result<Self, CallError> {
        json::write(value).map(Self).map_err(CallError::internal)
    }
}

impl Serialize for Fields {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Raw::of(&self.0).serialize(serializer)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_long_comes_back(value: i64) {
            let text = json::write(&Long(value)).unwrap();
            let Long(back) = json::read(&text).unwrap();
            prop_assert_eq!(back, value);
        }

        #[test]
        fn all_bytes_come_back(bytes: Vec<u8>) {
            let text = json::write(&Bytes(bytes.clone())).unwrap();
            let Bytes(back) = json::read(&text).unwrap();
            prop_assert_eq!(back, bytes);
        }
    }

    #[test]
    fn a_double_is_read_also_where_its_type_is_still_unknown() {
        #[derive(serde::Deserialize)]
        #[serde(untagged)]
        enum Either {
            Range([Double; 2]),
            One(Double),
        }

        let either = |text: &str| json::read::<Either>(text);
        assert!(matches!(either(r#"["-Infinity",1]"#), Ok(Either::Range([Double(f64::NEG_INFINITY), Double(1.0)]))));
        assert!(matches!(either(r#""-0""#), Ok(Either::One(Double(zero))) if zero.is_sign_negative()));
        assert!(either(r#""zero""#).is_err());
    }

    #[test]
    fn a_long_that_does_not_fit_or_is_a_number_is_refused() {
        for text in [r#""9223372036854775808""#, r#""1.0""#, r#""""#, "1"] {
            assert!(json::read::<Long>(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_column_is_read_whatever_the_order_of_its_members() {
        let text = r#"{"data":["-7"],"dtype":"i64","name":"c"}"#;
        let column: Column = json::read(text).unwrap();
        assert_eq!(column, Column { name: "c".to_owned(), data: Data::I64(vec![-7]) });
        assert_eq!(json::write(&column).unwrap(), r#"{"name":"c","dtype":"i64","data":["-7"]}"#);
        assert!(json::read::<Column>(r#"{"name":"c","dtype":"u8","data":[]}"#).is_err());
    }

    #[test]
    fn a_json_text_of_several_lines_becomes_one_line_and_what_is_no_json_is_refused() {
        let Fields(one) = Fields::of_text("{\n\"a\":\r\n1e400}".to_owned()).unwrap();
        assert_eq!(one, "{ \"a\":  1e400}");
        // A line break within a string is no JSON, and must not become a space.
        for text in ["{", "", "\"a\nb\""] {
            assert!(Fields::of_text(text.to_owned()).unwrap_err().is_internal(), "{text}");
        }
    }
}
