//! Writes JSON text: no white space, only the escapes that must be.

use crate::wire::Kind;
use crate::wire::error::{EncodeError, EncodeProblem};
use crate::wire::limits::{MAX_ENTRIES, MAX_INTEGER, MAX_ITEMS};

use super::plain_len;

/// Writes one JSON text. Always UTF-8, without a byte order mark. `// [NCP-WIRE-092]`
pub(crate) struct Writer {
    text: Vec<u8>,
    /// Whether somebody is to see a message as it is, whatever it holds: then nothing is refused.
    shows: bool,
}

impl Writer {
    /// A writer of what goes over the wire.
    pub(crate) fn new() -> Self {
        // A frame of the hot planes fits without growing.
        Self { text: Vec::with_capacity(256), shows: false }
    }

    /// A writer that refuses nothing, and names the numbers that JSON lacks.
    pub(crate) fn showing() -> Self {
        Self { shows: true, ..Self::new() }
    }

    /// The text, unless no receiver would take a frame of that length.
    pub(crate) fn finish(self, kind: Kind) -> Result<String, EncodeError> {
        let (len, limit) = (self.text.len(), kind.max_bytes());
        if len > limit {
            return Err(EncodeError::new(EncodeProblem::TooLong { len, limit })); // [NCP-WIRE-091]
        }
        Ok(self.into_text())
    }

    /// The text, whatever its length.
    pub(crate) fn into_text(self) -> String {
        // Only whole strings were written, so nothing is ever replaced.
        String::from_utf8(self.text).unwrap_or_else(|e| String::from_utf8_lossy(e.as_bytes()).into_owned())
    }

    /// Fails for an array of so many items that are not numbers.
    #[inline]
    pub(crate) fn check_items(&self, len: usize) -> Result<(), EncodeError> {
        if len > MAX_ITEMS && !self.shows {
            return Err(EncodeError::new(EncodeProblem::TooManyItems(len))); // [NCP-WIRE-091]
        }
        Ok(())
    }

    /// Fails for a map of so many entries.
    #[inline]
    pub(crate) fn check_entries(&self, len: usize) -> Result<(), EncodeError> {
        if len > MAX_ENTRIES && !self.shows {
            return Err(EncodeError::new(EncodeProblem::TooManyEntries(len))); // [NCP-WIRE-091]
        }
        Ok(())
    }

    /// Text that is JSON as it stands.
    #[inline]
    pub(crate) fn literal(&mut self, json: &str) {
        self.text.extend_from_slice(json.as_bytes());
    }

    /// A double in the shortest spelling that reads back as the same bits; it has a fraction or an
    /// exponent, so that nobody takes it for an integer. `// [NCP-WIRE-084]`
    #[inline]
    pub(crate) fn double(&mut self, value: f64) -> Result<(), EncodeError> {
        if self.short_decimal(value) {
            return Ok(());
        }
        if !value.is_finite() {
            if !self.shows {
                return Err(EncodeError::new(EncodeProblem::NonFinite(value))); // [NCP-WIRE-086]
            }
            self.string(match value {
                f64::INFINITY => "Infinity",
                f64::NEG_INFINITY => "-Infinity",
                _ => "NaN",
            });
            return Ok(());
        }
        self.literal(zmij::Buffer::new().format_finite(value));
        Ok(())
    }

    /// Writes a double that is a multiple of a thousandth and below four million, as most setpoints
    /// are; says whether it did.
    ///
    /// A decimal of so few digits is the only one of up to 15 digits that reads back as the double
    /// next to it, so it is the shortest spelling too.
    #[inline]
    fn short_decimal(&mut self, value: f64) -> bool {
        let magnitude = value.abs();
        let thousandths = (magnitude * 1000.0) as u32; // saturates, and is 0 for a NaN
        if f64::from(thousandths) / 1000.0 != magnitude {
            return false;
        }
        // A sign, seven digits, point, three digits; the point stands at byte 8.
        const POINT: usize = 8;
        let mut digits = *b"00000000.0000000";
        let (mut whole, fraction) = (thousandths / 1000, thousandths % 1000);
        let mut first = POINT;
        loop {
            first -= 1;
            digits[first] = b'0' + (whole % 10) as u8;
            whole /= 10;
            if whole == 0 {
                break;
            }
        }
        digits[POINT + 1] = b'0' + (fraction / 100) as u8;
        digits[POINT + 2] = b'0' + (fraction / 10 % 10) as u8;
        digits[POINT + 3] = b'0' + (fraction % 10) as u8;
        let end = match fraction {
            _ if fraction % 100 == 0 => POINT + 2,
            _ if fraction % 10 == 0 => POINT + 3,
            _ => POINT + 4,
        };
        if value.is_sign_negative() {
            first -= 1;
            digits[first] = b'-';
        }
        // Copying sixteen bytes and taking some back is faster than copying a few.
        let text = u128::from_le_bytes(digits) >> (8 * first);
        let len = self.text.len() + (end - first);
        self.text.extend_from_slice(&text.to_le_bytes());
        self.text.truncate(len);
        true
    }

    /// An integer. `// [NCP-WIRE-085]`
    #[inline]
    pub(crate) fn integer(&mut self, value: i64) -> Result<(), EncodeError> {
        if value.unsigned_abs() > MAX_INTEGER.unsigned_abs() && !self.shows {
            return Err(EncodeError::new(EncodeProblem::IntegerRange(value))); // [NCP-WIRE-091]
        }
        let mut digits = [0; 20];
        let mut first = digits.len();
        let mut rest = value.unsigned_abs();
        loop {
            first -= 1;
            digits[first] = b'0' + (rest % 10) as u8;
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        if value < 0 {
            first -= 1;
            digits[first] = b'-';
        }
        self.text.extend_from_slice(&digits[first..]);
        Ok(())
    }

    /// A string with its quotation marks.
    #[inline]
    pub(crate) fn string(&mut self, string: &str) {
        let bytes = string.as_bytes();
        self.text.reserve(bytes.len() + 2);
        self.text.push(b'"');
        if plain_len(bytes) == bytes.len() {
            self.text.extend_from_slice(bytes);
        } else {
            self.escaped(bytes);
        }
        self.text.push(b'"');
    }

    #[cold]
    fn escaped(&mut self, bytes: &[u8]) {
        const HEX: &[u8; 16] = b"0123456789abcdef";
        for &byte in bytes {
            match byte {
                b'"' => self.literal("\\\""),
                b'\\' => self.literal("\\\\"),
                0x08 => self.literal("\\b"),
                0x09 => self.literal("\\t"),
                0x0a => self.literal("\\n"),
                0x0c => self.literal("\\f"),
                0x0d => self.literal("\\r"),
                0..=0x1f => {
                    self.literal(if byte < 0x10 { "\\u000" } else { "\\u001" });
                    self.text.push(HEX[usize::from(byte % 16)]);
                }
                _ => self.text.push(byte),
            }
        }
    }
}
