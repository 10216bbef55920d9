//! How the types of fields are read and written.

use base64::Engine;
use base64::engine::general_purpose::STANDARD as BASE64;

use super::error::{DecodeError, DecodeProblem, EncodeError};
use super::json::{Reader, Writer};
use super::limits::{MAX_ENTRIES, MAX_ITEMS};
use super::table::JsonType;
use super::text::keep;
use super::{SortedMap, Text};

/// A type that a field can have, wherever the field stands. `// [NCP-WIRE-050]`
pub(crate) trait Value: Sized {
    /// As the tables write it.
    const JSON: JsonType;
    /// Reads a value; the reader stands at its first byte.
    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError>;
    /// Writes the value.
    fn write(&self, w: &mut Writer) -> Result<(), EncodeError>;
}

/// A type that the items of an array can have.
pub(crate) trait Item: Value {
    /// Whether the items are numbers, of which a frame may hold as many as fit.
    const IS_NUMERIC: bool = false;
}

impl Value for f64 {
    const JSON: JsonType = JsonType::Number;

    #[inline]
    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        r.double()
    }

    #[inline]
    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        w.double(*self)
    }
}

impl Value for i64 {
    const JSON: JsonType = JsonType::Integer;

    #[inline]
    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        r.integer()
    }

    #[inline]
    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        w.integer(*self)
    }
}

impl Value for bool {
    const JSON: JsonType = JsonType::Boolean;

    #[inline]
    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        r.boolean()
    }

    #[inline]
    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        w.literal(if *self { "true" } else { "false" });
        Ok(())
    }
}

impl Value for Text {
    const JSON: JsonType = JsonType::String;

    #[inline]
    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        r.string().map(keep)
    }

    #[inline]
    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        w.string(self);
        Ok(())
    }
}

/// Bytes, as base64 (`NCP-OBS-012`).
impl Value for Vec<u8> {
    const JSON: JsonType = JsonType::String;

    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let at = r.at();
        let text = r.string()?;
        BASE64.decode(&*text).map_err(|_| DecodeError::new(DecodeProblem::NotBase64, at))
    }

    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        w.string(&BASE64.encode(self));
        Ok(())
    }
}

impl<T: Value> Value for Option<T> {
    const JSON: JsonType = JsonType::Optional(&T::JSON);

    #[inline]
    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        if r.eat_null() {
            return Ok(None); // [NCP-WIRE-022]
        }
        T::read(r).map(Some)
    }

    #[inline]
    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        match self {
            Some(value) => value.write(w),
            None => {
                w.literal("null"); // [NCP-WIRE-082]
                Ok(())
            }
        }
    }
}

impl Item for f64 {
    const IS_NUMERIC: bool = true;
}

impl Item for i64 {
    const IS_NUMERIC: bool = true;
}

impl Item for Text {}

impl<V: Value> Item for SortedMap<V> {}

impl<T: Item> Value for Vec<T> {
    const JSON: JsonType = JsonType::Array(&T::JSON);

    #[inline]
    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mut items = Self::new();
        let mut more = r.open_array(Self::JSON)?;
        while more {
            if T::IS_NUMERIC {
                // A long array is allocated once, as long as it is, however large the frame.
                if items.len() == items.capacity() && !items.is_empty() {
                    items.reserve_exact(r.items_ahead());
                }
            } else if items.len() == MAX_ITEMS {
                return Err(r.error(DecodeProblem::TooManyItems)); // [NCP-WIRE-067] [NCP-WIRE-069]
            }
            items.push(T::read(r).map_err(|e| e.inside_item(items.len()))?);
            more = r.next_item()?;
        }
        Ok(items)
    }

    #[inline]
    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        if !T::IS_NUMERIC {
            w.check_items(self.len())?;
        }
        w.literal("[");
        for (nth, item) in self.iter().enumerate() {
            if nth > 0 {
                w.literal(",");
            }
            item.write(w).map_err(|e| e.inside_item(nth))?;
        }
        w.literal("]");
        Ok(())
    }
}

impl<V: Value> Value for SortedMap<V> {
    const JSON: JsonType = JsonType::Map(&V::JSON);

    #[inline]
    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mut entries = Vec::new();
        let mut more = r.open_object(Self::JSON)?;
        if more {
            // Most maps have one entry or two, and a frame may hold many maps.
            entries.reserve_exact(2);
        }
        while more {
            if entries.len() == MAX_ENTRIES {
                return Err(r.error(DecodeProblem::TooManyEntries)); // [NCP-WIRE-066] [NCP-WIRE-068]
            }
            let name = keep(r.name()?);
            let value = V::read(r).map_err(|e| e.inside(&name))?;
            entries.push((name, value));
            more = r.next_member()?;
        }
        // [NCP-WIRE-007]
        Self::from_entries(entries).map_err(|name| r.error(DecodeProblem::Repeated).inside(&name))
    }

    #[inline]
    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        w.check_entries(self.len())?;
        w.literal("{");
        // [NCP-WIRE-083]
        for (nth, (name, value)) in self.iter().enumerate() {
            if nth > 0 {
                w.literal(",");
            }
            w.string(name);
            w.literal(":");
            value.write(w).map_err(|e| e.inside(name))?;
        }
        w.literal("}");
        Ok(())
    }
}
