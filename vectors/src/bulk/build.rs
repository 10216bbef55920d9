//! Builds blocks, right ones and wrong ones, by the two tables of section 5.1.

use super::columns_json;
use crate::json::Json;
use crate::model::double;
use crate::template::Text;

/// The bytes of the header.
pub(super) const HEADER: usize = 12;
/// The bytes of an entry of the directory.
pub(super) const ENTRY: usize = 16;

/// A column.
#[derive(Debug, Clone)]
pub(super) struct Column {
    pub(super) name: String,
    pub(super) values: Values,
}

/// The values of a column.
#[derive(Debug, Clone)]
pub(super) enum Values {
    F32(Vec<f32>),
    F64(Vec<f64>),
    I32(Vec<i32>),
    I64(Vec<i64>),
}

impl Values {
    pub(super) fn dtype(&self) -> &'static str {
        match self {
            Self::F32(_) => "f32",
            Self::F64(_) => "f64",
            Self::I32(_) => "i32",
            Self::I64(_) => "i64",
        }
    }

    fn code(&self) -> u8 {
        match self {
            Self::F32(_) => 1,
            Self::F64(_) => 2,
            Self::I32(_) => 3,
            Self::I64(_) => 4,
        }
    }

    fn rows(&self) -> usize {
        match self {
            Self::F32(values) => values.len(),
            Self::F64(values) => values.len(),
            Self::I32(values) => values.len(),
            Self::I64(values) => values.len(),
        }
    }

    fn bytes(&self) -> Vec<u8> {
        match self {
            Self::F32(values) => values.iter().flat_map(|value| value.to_le_bytes()).collect(),
            Self::F64(values) => values.iter().flat_map(|value| value.to_le_bytes()).collect(),
            Self::I32(values) => values.iter().flat_map(|value| value.to_le_bytes()).collect(),
            Self::I64(values) => values.iter().flat_map(|value| value.to_le_bytes()).collect(),
        }
    }

    /// As the peer protocol writes them.
    pub(super) fn json(&self) -> Json {
        match self {
            Self::F32(values) => values.iter().map(|value| number(f64::from(*value))).collect(),
            Self::F64(values) => values.iter().map(|value| number(*value)).collect(),
            Self::I32(values) => values.iter().map(|value| Json::literal(value.to_string())).collect(),
            Self::I64(values) => values.iter().map(|value| Json::string(value.to_string())).collect(),
        }
    }
}

/// A double as the peer protocol writes it.
pub(super) fn number(value: f64) -> Json {
    if value.is_nan() {
        return "NaN".into();
    }
    if value.is_infinite() {
        return if value > 0.0 { "Infinity" } else { "-Infinity" }.into();
    }
    if value == 0.0 && value.is_sign_negative() {
        return "-0".into();
    }
    double(value)
}

pub(super) fn f32s(name: &str, values: impl Into<Vec<f32>>) -> Column {
    Column { name: name.to_owned(), values: Values::F32(values.into()) }
}

pub(super) fn f64s(name: &str, values: impl Into<Vec<f64>>) -> Column {
    Column { name: name.to_owned(), values: Values::F64(values.into()) }
}

pub(super) fn i32s(name: &str, values: impl Into<Vec<i32>>) -> Column {
    Column { name: name.to_owned(), values: Values::I32(values.into()) }
}

pub(super) fn i64s(name: &str, values: impl Into<Vec<i64>>) -> Column {
    Column { name: name.to_owned(), values: Values::I64(values.into()) }
}

/// Columns and where each part of them stands.
#[derive(Debug, Clone)]
pub(super) struct Block {
    columns: Vec<Column>,
    /// Where each name begins.
    pub(super) names: Vec<usize>,
    /// Where each column's data begins.
    pub(super) data: Vec<usize>,
    /// The length of the whole.
    pub(super) len: usize,
    /// What fills the bytes that belong to nothing.
    fill: u8,
}

impl Block {
    /// The layout that encoders use: names behind the directory, data at multiples of 8.
    pub(super) fn new(columns: impl Into<Vec<Column>>) -> Self {
        let columns = columns.into();
        let mut end = HEADER + ENTRY * columns.len();
        let mut place = |bytes: usize, align: usize| {
            let at = end.next_multiple_of(align);
            end = at + bytes;
            at
        };
        let names = columns.iter().map(|column| place(column.name.len(), 1)).collect();
        let data = columns.iter().map(|column| place(column.values.bytes().len(), 8)).collect();
        Self { columns, names, data, len: end, fill: 0 }
    }

    /// The same columns with their parts elsewhere.
    pub(super) fn laid_out(mut self, names: &[usize], data: &[usize], len: usize) -> Self {
        self.names = names.to_vec();
        self.data = data.to_vec();
        self.len = len;
        self
    }

    /// The same block with other bytes where nothing stands.
    pub(super) fn filled(mut self, fill: u8) -> Self {
        self.fill = fill;
        self
    }

    pub(super) fn columns(&self) -> Json {
        columns_json(&self.columns)
    }

    /// The block. Where two parts share bytes, the later one in the order directory, names, data,
    /// header wins; the header and the directory are always whole.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![self.fill; self.len];
        for (column, at) in self.columns.iter().zip(&self.data) {
            put(&mut bytes, *at, &column.values.bytes());
        }
        for (column, at) in self.columns.iter().zip(&self.names) {
            put(&mut bytes, *at, column.name.as_bytes());
        }
        for (nth, column) in self.columns.iter().enumerate() {
            let (name, data) = (self.names.get(nth), self.data.get(nth));
            let entry = [
                &le32(name.copied().unwrap_or_default())[..],
                &le16(column.name.len()),
                &[column.values.code(), 0],
                &le32(column.values.rows()),
                &le32(data.copied().unwrap_or_default()),
            ];
            put(&mut bytes, HEADER + ENTRY * nth, &entry.concat());
        }
        let header = [b"NCPB", &[1, 0][..], &le16(self.columns.len()), &le32(self.len)];
        put(&mut bytes, 0, &header.concat());
        bytes
    }

    /// The block with bytes changed at an offset.
    pub(super) fn patched(&self, at: usize, with: &[u8]) -> Vec<u8> {
        let mut bytes = self.bytes();
        put(&mut bytes, at, with);
        bytes
    }

    /// The block with a part of a directory entry changed.
    pub(super) fn entry(&self, nth: usize, part: Part, value: usize) -> Vec<u8> {
        let (at, width) = part.place();
        let bytes = (value as u64).to_le_bytes();
        self.patched(HEADER + ENTRY * nth + at, &bytes[..width])
    }
}

/// A field of a directory entry.
#[derive(Debug, Clone, Copy)]
pub(super) enum Part {
    NameOff,
    NameLen,
    Dtype,
    Pad,
    Rows,
    DataOff,
}

impl Part {
    /// Its offset within the entry, and its width.
    fn place(self) -> (usize, usize) {
        match self {
            Self::NameOff => (0, 4),
            Self::NameLen => (4, 2),
            Self::Dtype => (6, 1),
            Self::Pad => (7, 1),
            Self::Rows => (8, 4),
            Self::DataOff => (12, 4),
        }
    }
}

/// The golden block of section 5.1.
pub(super) fn golden() -> Block {
    Block::new([f64s("times", [1.5, 2.5, 9.0]), i64s("senders", [7, 7, 9])])
}

/// A block of columns, each a name, a dtype and a number of rows of 0, as a template. No byte of
/// what it writes out is above 127, so that it is a text.
pub(super) fn of_zeros(columns: &[(&str, u8, usize)]) -> Text {
    let zeros: Vec<_> = columns.iter().map(|(name, dtype, rows)| (*name, *dtype, *rows, '\0')).collect();
    of_runs(&zeros)
}

/// The block that an encoder writes of columns of a name, a dtype, so many rows and a character of which all of its
/// bytes are, as a template: `0` makes the double 1.39e-76.
pub(super) fn of_runs(columns: &[(&str, u8, usize, char)]) -> Text {
    of_runs_shifted(columns, 0)
}

/// The double that all of whose bytes are this one, as a reader writes it.
pub(super) fn double_of(byte: u8) -> Json {
    number(f64::from_bits(u64::from_ne_bytes([byte; 8])))
}

/// The same with the data so many bytes behind where an encoder puts it.
pub(super) fn of_runs_shifted(columns: &[(&str, u8, usize, char)], shift: usize) -> Text {
    let columns: Vec<_> = columns.iter().filter(|(_, _, rows, _)| *rows > 0).collect();
    let names: String = columns.iter().map(|(name, ..)| *name).collect();
    let mut name_at = HEADER + ENTRY * columns.len();
    let begin = (name_at + names.len()).next_multiple_of(8) + shift;
    let mut data_at = begin;
    let mut directory = Vec::new();
    let mut data = Vec::new();
    for (name, dtype, rows, byte) in &columns {
        directory.extend(le32(name_at));
        directory.extend(le16(name.len()));
        directory.extend([*dtype, 0]);
        directory.extend(le32(*rows));
        directory.extend(le32(data_at));
        name_at += name.len();
        // The dtypes of 4 bytes are the odd ones.
        let size = rows * if dtype % 2 == 1 { 4 } else { 8 };
        data.push(Text::repeat(byte.to_string(), size));
        data_at += size;
    }
    let header = [b"NCPB", &[1, 0][..], &le16(columns.len()), &le32(data_at), &directory, names.as_bytes()].concat();
    debug_assert!(header.is_ascii(), "{columns:?}");
    let padding = "\0".repeat(begin - header.len());
    let header = String::from_utf8_lossy(&header).into_owned() + &padding;
    let parts = std::iter::once(header.into()).chain(data);
    Text::Base64(Box::new(Text::concat(parts.collect::<Vec<_>>())))
}

pub(super) fn le32(value: usize) -> [u8; 4] {
    u32::try_from(value).unwrap_or(u32::MAX).to_le_bytes()
}

pub(super) fn le16(value: usize) -> [u8; 2] {
    u16::try_from(value).unwrap_or(u16::MAX).to_le_bytes()
}

fn put(bytes: &mut [u8], at: usize, with: &[u8]) {
    if let Some(place) = bytes.get_mut(at..at + with.len()) {
        place.copy_from_slice(with);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bytes as chapter 5 prints them.
    #[test]
    fn the_golden_block_is_the_one_that_the_text_prints() {
        assert_eq!(golden().bytes(), ncp_text::bulk::golden_block());
    }
}
