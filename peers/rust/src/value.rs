//! Numbers and bytes in the form that requests and answers give them (PROTOCOL.md, section 2).

use std::fmt;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::wire::{ChannelMap, ChannelValue, Message};
use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::ser::{Serialize, Serializer};
use serde_json::value::RawValue;

/// A double: a JSON number, or one of `"NaN"`, `"Infinity"`, `"-Infinity"`, `"-0"`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Double(pub(crate) f64);

impl Double {
    /// The double that one of the four strings stands for, or `None`.
    pub(crate) fn from_name(name: &str) -> Option<f64> {
        match name {
            "NaN" => Some(f64::NAN),
            "Infinity" => Some(f64::INFINITY),
            "-Infinity" => Some(f64::NEG_INFINITY),
            "-0" => Some(-0.0),
            _ => None,
        }
    }
}

impl Serialize for Double {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let value = self.0;
        if value.is_nan() {
            serializer.serialize_str("NaN")
        } else if value.is_infinite() {
            serializer.serialize_str(if value > 0.0 { "Infinity" } else { "-Infinity" })
        } else if value == 0.0 && value.is_sign_negative() {
            serializer.serialize_str("-0")
        } else {
            serializer.serialize_f64(value)
        }
    }
}

impl<'de> Deserialize<'de> for Double {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct DoubleVisitor;

        impl Visitor<'_> for DoubleVisitor {
            type Value = Double;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, \"NaN\", \"Infinity\", \"-Infinity\" or \"-0\"")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Double, E> {
                Ok(Double(value))
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Double, E> {
                Ok(Double(value as f64))
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Double, E> {
                Ok(Double(value as f64))
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Double, E> {
                let value = Double::from_name(name);
                value.map(Double).ok_or_else(|| E::invalid_value(de::Unexpected::Str(name), &self))
            }
        }

        deserializer.deserialize_any(DoubleVisitor)
    }
}

/// A 64-bit integer: a string of decimal digits, since many JSON readers would round it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Long(pub(crate) i64);

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
pub(crate) struct Bytes(pub(crate) Vec<u8>);

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

/// The fields of a message, as an answer shows them.
#[derive(Debug)]
pub(crate) struct Fields(Box<RawValue>);

impl Fields {
    /// Every field of the message.
    pub(crate) fn of(message: impl Into<Message>) -> Self {
        // What the specification shows is JSON; were it not, the answer would say null.
        Self(RawValue::from_string(message.into().fields()).unwrap_or_default())
    }
}

impl Serialize for Fields {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

/// Channel values by name, as an answer shows them.
#[derive(Debug)]
pub(crate) struct Channels(pub(crate) ChannelMap);

impl Serialize for Channels {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Channel<'a> {
            data: Vec<Double>,
            unit: Option<&'a str>,
        }

        serializer.collect_map(self.0.iter().map(|(name, ChannelValue { data, unit })| {
            let data = data.iter().copied().map(Double).collect();
            let unit = unit.as_deref();
            (name, Channel { data, unit })
        }))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_double_comes_back_with_the_same_bits(bits: u64) {
            let value = f64::from_bits(bits);
            let text = serde_json::to_string(&Double(value)).unwrap();
            let Double(back) = serde_json::from_str(&text).unwrap();
            if value.is_nan() {
                prop_assert!(back.is_nan());
            } else {
                prop_assert_eq!(back.to_bits(), bits);
            }
        }

        #[test]
        fn every_long_comes_back(value: i64) {
            let text = serde_json::to_string(&Long(value)).unwrap();
            let Long(back) = serde_json::from_str(&text).unwrap();
            prop_assert_eq!(back, value);
        }

        #[test]
        fn all_bytes_come_back(bytes: Vec<u8>) {
            let text = serde_json::to_string(&Bytes(bytes.clone())).unwrap();
            let Bytes(back) = serde_json::from_str(&text).unwrap();
            prop_assert_eq!(back, bytes);
        }
    }

    #[test]
    fn the_numbers_that_json_lacks_travel_as_the_four_strings() {
        let values = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 0.0].map(Double);
        let text = serde_json::to_string(&values).unwrap();
        assert_eq!(text, r#"["NaN","Infinity","-Infinity","-0",0.0]"#);
    }

    #[test]
    fn a_long_that_does_not_fit_or_is_a_number_is_refused() {
        for text in [r#""9223372036854775808""#, r#""1.0""#, r#""""#, "1"] {
            assert!(serde_json::from_str::<Long>(text).is_err(), "{text}");
        }
    }
}
