//! Structured inputs that can be written as well as read, so that vectors become seeds.
//!
//! Every value stands in the bytes in the order of its fields, and a byte that is missing is 0. Numbers
//! begin with a byte that names an edge, a small value, or eight bytes to come: one mutated byte leads
//! from the usual to the extreme.

use std::fmt::Debug;

use arbitrary::{Result, Unstructured};

/// A value with one spelling in bytes.
pub trait Plain: Sized {
    /// Reads it.
    ///
    /// # Errors
    /// Never for want of bytes.
    fn get(source: &mut Unstructured<'_>) -> Result<Self>;

    /// Writes what [`get`](Self::get) reads as this value.
    fn put(&self, out: &mut Vec<u8>);
}

/// Reads a value from the whole of the bytes.
#[must_use]
pub fn read<T: Plain>(bytes: &[u8]) -> T {
    T::get(&mut Unstructured::new(bytes)).expect("missing bytes are 0")
}

/// The bytes of a value.
pub fn write<T: Plain>(value: &T) -> Vec<u8> {
    let mut out = Vec::new();
    value.put(&mut out);
    out
}

/// A value as a person reads it.
#[must_use]
pub fn show<T: Plain + Debug>(bytes: &[u8]) -> String {
    format!("{:#?}", read::<T>(bytes))
}

/// A text as a person reads it.
#[must_use]
pub fn show_text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Doubles at which something can change.
const DOUBLES: [f64; 32] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    5.0,
    200.0,
    500.0,
    0.05,
    0.99,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    1e-160,
    1e160,
    1e308,
    -1e308,
    60.0,
    60_000.0,
    60_000.000_1,
    1e9,
    1e-9,
    0.1,
    10.0,
    100.0,
    4_096.0,
];

/// Integers at which something can change.
const INTEGERS: [i64; 24] = [
    0,
    1,
    -1,
    2,
    3,
    i64::MAX,
    i64::MIN,
    i64::MAX - 1,
    i64::MIN + 1,
    (1 << 53) - 1,
    1 - (1 << 53),
    1 << 53,
    -(1 << 53),
    1 << 31,
    1 << 32,
    256,
    257,
    4_095,
    4_096,
    4_097,
    100,
    1_000,
    -5,
    10,
];

/// The tag of a small number: 16 bits follow.
const SMALL: u8 = 0x80;
/// The tag of any number: 64 bits follow.
const WHOLE: u8 = 0xc0;

impl Plain for u8 {
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        source.arbitrary()
    }

    fn put(&self, out: &mut Vec<u8>) {
        out.push(*self);
    }
}

impl Plain for bool {
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        Ok(u8::get(source)? & 1 == 1)
    }

    fn put(&self, out: &mut Vec<u8>) {
        out.push(u8::from(*self));
    }
}

impl Plain for f64 {
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        let tag = u8::get(source)?;
        Ok(match tag {
            ..SMALL => DOUBLES[usize::from(tag) % DOUBLES.len()],
            SMALL..WHOLE => f64::from(source.arbitrary::<i16>()?) / 16.0,
            WHOLE.. => Self::from_bits(source.arbitrary()?),
        })
    }

    fn put(&self, out: &mut Vec<u8>) {
        let edge = DOUBLES.iter().position(|edge| edge.to_bits() == self.to_bits());
        #[expect(clippy::cast_possible_truncation)]
        let sixteenths = (self * 16.0) as i16;
        if let Some(edge) = edge {
            out.push(u8::try_from(edge).unwrap());
        } else if Self::from(sixteenths) / 16.0 == *self {
            out.push(SMALL);
            out.extend(sixteenths.to_le_bytes());
        } else {
            out.push(WHOLE);
            out.extend(self.to_bits().to_le_bytes());
        }
    }
}

impl Plain for i64 {
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        let tag = u8::get(source)?;
        Ok(match tag {
            ..SMALL => INTEGERS[usize::from(tag) % INTEGERS.len()],
            SMALL..WHOLE => Self::from(source.arbitrary::<i16>()?),
            WHOLE.. => source.arbitrary()?,
        })
    }

    fn put(&self, out: &mut Vec<u8>) {
        if let Some(edge) = INTEGERS.iter().position(|edge| edge == self) {
            out.push(u8::try_from(edge).unwrap());
        } else if let Ok(small) = i16::try_from(*self) {
            out.push(SMALL);
            out.extend(small.to_le_bytes());
        } else {
            out.push(WHOLE);
            out.extend(self.to_le_bytes());
        }
    }
}

impl Plain for String {
    /// At most 65,535 bytes; what is not UTF-8 is replaced.
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        let len = usize::from(source.arbitrary::<u16>()?).min(source.len());
        Ok(Self::from_utf8_lossy(source.bytes(len)?).into_owned())
    }

    fn put(&self, out: &mut Vec<u8>) {
        out.extend(u16::try_from(self.len()).unwrap_or(u16::MAX).to_le_bytes());
        out.extend(self.bytes());
    }
}

impl<T: Plain> Plain for Option<T> {
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        Ok(if bool::get(source)? { Some(T::get(source)?) } else { None })
    }

    fn put(&self, out: &mut Vec<u8>) {
        self.is_some().put(out);
        if let Some(value) = self {
            value.put(out);
        }
    }
}

impl<T: Plain> Plain for Vec<T> {
    /// At most 255 items, and none behind the last byte.
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        let len = u8::get(source)?;
        let mut items = Self::new();
        while items.len() < usize::from(len) && !source.is_empty() {
            items.push(T::get(source)?);
        }
        Ok(items)
    }

    fn put(&self, out: &mut Vec<u8>) {
        out.push(u8::try_from(self.len()).unwrap_or(u8::MAX));
        for item in self.iter().take(usize::from(u8::MAX)) {
            item.put(out);
        }
    }
}

impl<A: Plain, B: Plain> Plain for (A, B) {
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        Ok((A::get(source)?, B::get(source)?))
    }

    fn put(&self, out: &mut Vec<u8>) {
        self.0.put(out);
        self.1.put(out);
    }
}

impl Plain for () {
    fn get(_: &mut Unstructured<'_>) -> Result<Self> {
        Ok(())
    }

    fn put(&self, _: &mut Vec<u8>) {}
}

/// Declares a struct whose fields follow each other.
macro_rules! plain {
    ($(#[$meta:meta])* struct $name:ident { $($(#[$doc:meta])* $field:ident: $type:ty,)* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone)]
        pub struct $name { $($(#[$doc])* pub $field: $type,)* }

        impl $crate::plain::Plain for $name {
            fn get(source: &mut arbitrary::Unstructured<'_>) -> arbitrary::Result<Self> {
                Ok(Self { $($field: $crate::plain::Plain::get(source)?,)* })
            }

            fn put(&self, out: &mut Vec<u8>) {
                $($crate::plain::Plain::put(&self.$field, out);)*
            }
        }
    };
    ($(#[$meta:meta])* enum $name:ident { $($(#[$doc:meta])* $tag:literal $variant:ident($type:ty),)* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone)]
        pub enum $name { $($(#[$doc])* $variant($type),)* }

        impl $crate::plain::Plain for $name {
            fn get(source: &mut arbitrary::Unstructured<'_>) -> arbitrary::Result<Self> {
                const COUNT: u8 = [$($tag),*].len() as u8;
                Ok(match u8::get(source)? % COUNT {
                    $($tag => Self::$variant($crate::plain::Plain::get(source)?),)*
                    _ => unreachable!(),
                })
            }

            fn put(&self, out: &mut Vec<u8>) {
                match self {
                    $(Self::$variant(value) => {
                        out.push($tag);
                        $crate::plain::Plain::put(value, out);
                    })*
                }
            }
        }
    };
    ($(#[$meta:meta])* words $name:ident = [$($word:expr),* $(,)?];) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name(pub &'static str);

        impl $name {
            /// The words.
            pub const ALL: &'static [&'static str] = &[$($word),*];

            /// The word, or the last one for any other.
            #[must_use]
            pub fn of(word: &str) -> Self {
                let known = Self::ALL.iter().find(|known| **known == word);
                Self(known.or(Self::ALL.last()).copied().unwrap_or_default())
            }
        }

        impl $crate::plain::Plain for $name {
            fn get(source: &mut arbitrary::Unstructured<'_>) -> arbitrary::Result<Self> {
                Ok(Self(Self::ALL[usize::from(u8::get(source)?) % Self::ALL.len()]))
            }

            fn put(&self, out: &mut Vec<u8>) {
                let at = Self::ALL.iter().position(|word| *word == self.0);
                out.push(u8::try_from(at.unwrap_or_default()).unwrap_or_default());
            }
        }
    };
}
pub(crate) use plain;

#[cfg(test)]
mod tests {
    use super::*;

    fn survives<T: Plain>(value: &T) {
        let bytes = write(value);
        assert_eq!(write(&read::<T>(&bytes)), bytes);
    }

    #[test]
    fn what_is_written_is_read_as_it_was() {
        for double in DOUBLES.into_iter().chain([0.0625, 1.0 / 3.0, -2_047.5, 1e300]) {
            assert_eq!(read::<f64>(&write(&double)).to_bits(), double.to_bits());
        }
        for integer in INTEGERS.into_iter().chain([77, -30_000, 1 << 40]) {
            assert_eq!(read::<i64>(&write(&integer)), integer);
        }
        survives(&vec![Some("längs".to_owned()), None, Some(String::new())]);
        survives(&(vec![true, false, true], 7_u8));
    }

    #[test]
    fn no_bytes_are_a_value_too() {
        assert!(read::<Vec<f64>>(&[]).is_empty());
        assert_eq!(read::<(i64, Option<f64>)>(&[]), (0, None));
    }
}
