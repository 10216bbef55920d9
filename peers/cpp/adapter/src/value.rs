//! Numbers and bytes in the form that requests and answers give them (PROTOCOL.md, section 2).

use std::borrow::Cow;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::de::{Deserialize, Deserializer, Error, Unexpected};
use serde_json::Value;

/// The names of the doubles that JSON lacks, or that many JSON writers would spoil.
pub(crate) const NAMES: [(&str, f64); 4] =
    [("NaN", f64::NAN), ("Infinity", f64::INFINITY), ("-Infinity", f64::NEG_INFINITY), ("-0", -0.0)];

/// A double: a JSON number, or one of [`NAMES`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Double(pub(crate) f64);

impl<'de> Deserialize<'de> for Double {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        let double = match &value {
            Value::Number(number) => number.as_f64(),
            Value::String(text) => NAMES.iter().find(|(name, _)| name == text).map(|(_, double)| *double),
            _ => None,
        };
        double.map(Self).ok_or_else(|| D::Error::invalid_type(Unexpected::Other("another value"), &"a double"))
    }
}

/// A double as an answer shows it.
pub(crate) fn shown(double: f64) -> Value {
    let negative_zero = double == 0.0 && double.is_sign_negative();
    let name = match double {
        _ if double.is_nan() => "NaN",
        f64::INFINITY => "Infinity",
        f64::NEG_INFINITY => "-Infinity",
        _ if negative_zero => "-0",
        _ => return double.into(),
    };
    name.into()
}

/// A 64-bit integer: a string of decimal digits.
pub(crate) struct Long(pub(crate) i64);

impl<'de> Deserialize<'de> for Long {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let digits = Cow::<'de, str>::deserialize(deserializer)?;
        digits.parse().map(Self).map_err(D::Error::custom)
    }
}

/// Bytes: a string of padded base64.
pub(crate) struct Bytes(pub(crate) Vec<u8>);

impl<'de> Deserialize<'de> for Bytes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = Cow::<'de, str>::deserialize(deserializer)?;
        STANDARD.decode(&*text).map(Self).map_err(D::Error::custom)
    }
}

/// Bytes as an answer shows them.
pub(crate) fn base64(bytes: &[u8]) -> Value {
    STANDARD.encode(bytes).into()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;

    #[test]
    fn doubles_come_back_with_their_bits() {
        for double in [0.1, -0.0, 0.0, 5e-324, f64::MAX, f64::INFINITY, f64::NEG_INFINITY, 3.0] {
            let text = shown(double).to_string();
            let Double(back) = serde_json::from_str(&text).unwrap();
            assert_eq!(back.to_bits(), double.to_bits(), "{text}");
        }
        let Double(back) = serde_json::from_str(&shown(f64::NAN).to_string()).unwrap();
        assert!(back.is_nan());
        assert!(serde_json::from_str::<Double>("\"nan\"").is_err());
    }

    #[test]
    fn a_long_is_a_string_of_digits() {
        let Long(long) = serde_json::from_str("\"-9223372036854775808\"").unwrap();
        assert_eq!(long, i64::MIN);
        assert!(serde_json::from_str::<Long>("1").is_err());
    }
}
