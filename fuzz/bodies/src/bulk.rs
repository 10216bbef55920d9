//! BulkBlocks, against a decoder and an encoder that go byte by byte.

use arbitrary::{Result, Unstructured};
use ncp_spec::ErrorCode;
use ncp_spec::bulk::{Block, Column, ColumnData, Dtype, Element, encode, pack_observation, unpack};
use ncp_spec::wire::Observation;

use crate::memory;
use crate::plain::{Plain, plain, read};

/// Every buffer is judged and read as byte by byte, and every view of a column gives the same values.
///
/// It would find an overlap, an overflow or a range that passes, and a value that is read at the wrong
/// place, with the wrong sign or in the wrong order of bytes.
// [NCP-BULK-001] [NCP-BULK-002] [NCP-BULK-003] [NCP-BULK-004] [NCP-BULK-005] [NCP-BULK-006]
// [NCP-BULK-007] [NCP-BULK-008] [NCP-BULK-009] [NCP-BULK-010] [NCP-BULK-011] [NCP-BULK-012]
// [NCP-BULK-013] [NCP-BULK-014] [NCP-BULK-018] [NCP-BULK-019] [NCP-BULK-020] [NCP-BULK-021]
// [NCP-BULK-022] [NCP-BULK-023] [NCP-OBS-004] [NCP-OBS-005] [NCP-OBS-006] [NCP-OBS-007]
pub fn bulk_decode(input: &[u8]) {
    let expected = slow::decode(input);
    let block = Block::parse(input);
    if let Err(error) = &block {
        assert!(!error.to_string().is_empty());
        assert!(matches!(error.code(), ErrorCode::Block | ErrorCode::Limit));
    }
    let columns = block.as_ref().ok().map(Block::to_columns);
    assert_eq!(columns, expected);
    if let (Ok(block), Some(columns)) = (block, expected) {
        assert_eq!((block.len(), block.is_empty()), (columns.len(), columns.is_empty()));
        assert_eq!(block.bytes(), input);
        assert!(format!("{block:?}").matches("dtype: ").count() >= columns.len());
        assert_eq!(format!("{columns:?}"), format!("{:?}", block.to_columns()));
        assert_eq!(block.columns().rev().count(), columns.len());
        for (nth, column) in columns.iter().enumerate() {
            let view = block.column(nth).expect("a column that was counted");
            assert_eq!((view.name(), view.rows()), (column.name.as_str(), column.data.len()));
            assert_eq!(block.find(&column.name).map(|(at, _)| at), Some(nth));
            match &column.data {
                ColumnData::F32(values) => {
                    views_agree(&view, values, |value| value.to_bits().into());
                }
                ColumnData::F64(values) => views_agree(&view, values, f64::to_bits),
                ColumnData::I32(values) => views_agree(&view, values, i32::cast_unsigned_u64),
                ColumnData::I64(values) => views_agree(&view, values, i64::cast_unsigned),
            }
        }
        assert!(block.column(columns.len()).is_none());
    }
    judge_unpack(input);
}

/// Columns come back from a block as they went in; the block is laid out as the text says.
///
/// It would find a column, a name or a value that is lost or cut short, and padding that is not zero.
// [NCP-OBS-001] [NCP-OBS-002] [NCP-OBS-003]
// [NCP-BULK-030] [NCP-BULK-031] [NCP-BULK-032] [NCP-BULK-033] [NCP-BULK-034]
pub fn bulk_roundtrip(input: &[u8]) {
    let columns = read::<Columns>(input).0;
    judge_pack(&columns);
    let mut names: Vec<_> = columns.iter().map(|column| &column.name).collect();
    names.sort();
    let distinct = names.windows(2).all(|pair| pair[0] != pair[1]);
    match encode(&columns) {
        Err(_) => assert!(!distinct, "columns that fit are refused"),
        Ok(block) => {
            assert!(distinct, "two columns have one name");
            assert_eq!(slow::decode(&block).as_ref(), Some(&columns));
            assert_eq!(Block::parse(&block).map(|block| block.to_columns()), Ok(columns.clone()));
            assert_eq!(block, slow::encode(&columns));
        }
    }
}

/// Reading a block allocates no more than it is long, whatever its directory claims.
///
/// It would find a reader that makes room before it checks, or that counts one byte twice.
// [NCP-BULK-024]
pub fn bulk_memory(input: &[u8]) {
    let (parsed, bytes) = memory::counted(|| Block::parse(input).is_ok());
    assert!(bytes <= input.len(), "{bytes} bytes to check {}", input.len());
    let (columns, bytes) = memory::counted(|| Block::parse(input).ok().map(|block| block.to_columns()));
    let own = columns.as_ref().map_or(0, |columns| columns.capacity() * size_of::<Column>());
    assert_eq!(columns.is_some(), parsed);
    // What is checked first is given back before the copy; both count here.
    assert!(bytes <= 2 * input.len() + own, "{bytes} bytes to read {}", input.len());
    let (_, bytes) = memory::counted(|| unpack(input));
    assert!(bytes <= 2 * input.len(), "{bytes} bytes to unpack {}", input.len());
}

/// A block as a person reads it.
#[must_use]
pub fn show_block(input: &[u8]) -> String {
    format!("{:?}\n{input:02x?}", Block::parse(input))
}

/// Columns of a few values.
#[derive(Debug, Clone)]
pub struct Columns(pub Vec<Column>);

plain! {
    /// A column: `F32` and `I32` hold the bits of an integer's lower half.
    struct Spelled {
        /// Its name.
        name: String,
        /// Its values.
        values: Values,
    }
}

plain! {
    /// Values of a column.
    enum Values {
        /// As bits.
        0 F32(Vec<i64>),
        /// As doubles.
        1 F64(Vec<f64>),
        /// The lower halves.
        2 I32(Vec<i64>),
        /// As integers.
        3 I64(Vec<i64>),
    }
}

impl Plain for Columns {
    fn get(source: &mut Unstructured<'_>) -> Result<Self> {
        let columns = Vec::<Spelled>::get(source)?.into_iter();
        Ok(Self(columns.map(|Spelled { name, values }| Column::new(name, values.data())).collect()))
    }

    fn put(&self, out: &mut Vec<u8>) {
        let columns = self.0.iter().map(|Column { name, data }| Spelled {
            name: name.clone(),
            values: match data {
                ColumnData::F32(values) => Values::F32(values.iter().map(|value| value.to_bits().into()).collect()),
                ColumnData::F64(values) => Values::F64(values.clone()),
                ColumnData::I32(values) => Values::I32(values.iter().map(|value| (*value).into()).collect()),
                ColumnData::I64(values) => Values::I64(values.clone()),
            },
        });
        columns.collect::<Vec<_>>().put(out);
    }
}

impl Values {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn data(self) -> ColumnData {
        match self {
            Self::F32(bits) => ColumnData::F32(bits.into_iter().map(|bits| f32::from_bits(bits as u32)).collect()),
            Self::F64(values) => ColumnData::F64(values),
            Self::I32(values) => ColumnData::I32(values.into_iter().map(|value| value as i32).collect()),
            Self::I64(values) => ColumnData::I64(values),
        }
    }
}

trait Bits {
    fn cast_unsigned_u64(self) -> u64;
}

impl Bits for i32 {
    fn cast_unsigned_u64(self) -> u64 {
        self.cast_unsigned().into()
    }
}

fn views_agree<T: Element + PartialEq>(view: &ncp_spec::bulk::ColumnView<'_>, values: &[T], bits: fn(T) -> u64) {
    let of = |values: &[T]| values.iter().map(|value| bits(*value)).collect::<Vec<_>>();
    assert_eq!(view.dtype(), T::DTYPE);
    assert_eq!(Dtype::parse(&view.dtype().to_string()), Some(T::DTYPE));
    assert_eq!(view.bytes().len(), values.len() * T::DTYPE.size());
    assert_eq!(of(&view.to_vec::<T>().unwrap()), of(values));
    assert_eq!(of(&view.iter::<T>().unwrap().collect::<Vec<_>>()), of(values));
    if let Some(slice) = view.as_slice::<T>() {
        assert_eq!(of(slice), of(values));
    }
    assert!(view.get::<T>(values.len()).is_none());
    let other = Dtype::ALL.into_iter().find(|dtype| *dtype != T::DTYPE);
    if other == Some(Dtype::F32) {
        assert!(view.to_vec::<f32>().is_none() && view.get::<f32>(0).is_none());
    }
}

/// The first doubles and integers as an observation, there and back.
fn judge_pack(columns: &[Column]) {
    let doubles = |nth| {
        let mut found = columns.iter().filter_map(|column| match &column.data {
            ColumnData::F64(values) => Some(values.as_slice()),
            _ => None,
        });
        found.nth(nth).unwrap_or_default()
    };
    let integers = columns.iter().find_map(|column| match &column.data {
        ColumnData::I64(values) => Some(values.as_slice()),
        _ => None,
    });
    let (times, values, senders) = (doubles(0), doubles(1), integers.unwrap_or_default());
    let mut rows = vec![times.len(), values.len(), senders.len()];
    rows.retain(|rows| *rows > 0);
    rows.dedup();
    let observation = Observation {
        times: times.to_vec(),
        values: values.to_vec(),
        senders: senders.to_vec(),
        ..Observation::default()
    };
    let packed = pack_observation(&observation);
    assert_eq!(packed.is_ok(), rows.len() < 2);
    if let Ok(block) = packed {
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        let back = unpack(&block).expect("what was packed is unpacked");
        assert_eq!((bits(&back.0), bits(&back.1)), (bits(times), bits(values)));
        assert_eq!(back.2, senders);
    }
}

/// What is unpacked is what the columns of the three names hold.
fn judge_unpack(input: &[u8]) {
    let expected = slow::decode(input).and_then(|columns| {
        let find = |name: &str| columns.iter().find(|column| column.name == name);
        let doubles = |name| match find(name).map(|column| &column.data) {
            None => Some(Vec::new()),
            Some(ColumnData::F64(values)) => Some(values.clone()),
            Some(_) => None,
        };
        let senders = match find("senders").map(|column| &column.data) {
            None => Vec::new(),
            Some(ColumnData::I64(values)) => values.clone(),
            Some(_) => return None,
        };
        let (times, values) = (doubles("times")?, doubles("values")?);
        let mut rows = vec![times.len(), values.len(), senders.len()];
        rows.retain(|rows| *rows > 0);
        rows.dedup();
        (rows.len() < 2).then_some((times, values, senders))
    });
    let bits = |(times, values, senders): (Vec<f64>, Vec<f64>, Vec<i64>)| {
        let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        (bits(times), bits(values), senders)
    };
    assert_eq!(unpack(input).ok().map(bits), expected.map(bits));
}

/// The format once more, byte by byte and from the text alone.
mod slow {
    use ncp_spec::bulk::{Column, ColumnData};

    /// The columns of a block, or nothing if it is none.
    pub(super) fn decode(block: &[u8]) -> Option<Vec<Column>> {
        let is_header = block.len() >= 12
            && block.starts_with(b"NCPB\x01\x00")
            && little(block, 8, 4)? == block.len() as u64
            && block.len() <= 64 << 20;
        let columns = if is_header {
            little(block, 6, 2)?
        } else {
            return None;
        };
        let directory_end = 12 + 16 * usize::try_from(columns).ok()?;
        if columns > 4_096 || directory_end > block.len() {
            return None;
        }
        let mut owned = vec![false; block.len()];
        owned.get_mut(..directory_end)?.fill(true);
        let mut found: Vec<Column> = Vec::new();
        for entry in (12..directory_end).step_by(16) {
            let (name_off, name_len) = (little(block, entry, 4)?, little(block, entry + 4, 2)?);
            let (dtype, pad) = (block[entry + 6], block[entry + 7]);
            let (rows, data_off) = (little(block, entry + 8, 4)?, little(block, entry + 12, 4)?);
            let size = match dtype {
                1 | 3 => 4,
                2 | 4 => 8,
                _ => return None,
            };
            if pad != 0 {
                return None;
            }
            let name = take(block, &mut owned, name_off, name_len)?;
            let data = take(block, &mut owned, data_off, rows * size)?;
            let name = String::from_utf8(name.to_vec()).ok()?;
            if found.iter().any(|column| column.name == name) {
                return None;
            }
            let words = data.chunks(usize::try_from(size).ok()?);
            let words = words.map(|bytes| little(bytes, 0, bytes.len()).unwrap_or_default());
            #[expect(clippy::cast_possible_truncation)]
            let data = match dtype {
                1 => ColumnData::F32(words.map(|word| f32::from_bits(word as u32)).collect()),
                2 => ColumnData::F64(words.map(f64::from_bits).collect()),
                3 => ColumnData::I32(words.map(|word| (word as u32).cast_signed()).collect()),
                _ => ColumnData::I64(words.map(u64::cast_signed).collect()),
            };
            found.push(Column::new(name, data));
        }
        Some(found)
    }

    /// The block of columns that fit into one.
    pub(super) fn encode(columns: &[Column]) -> Vec<u8> {
        let mut names = Vec::new();
        let mut directory = Vec::new();
        let mut data = Vec::new();
        let pool = 12 + 16 * columns.len();
        let start = pool + columns.iter().map(|column| column.name.len()).sum::<usize>();
        for Column { name, data: values } in columns {
            while !(start + data.len()).is_multiple_of(8) {
                data.push(0);
            }
            let (code, offset) = (values.dtype().code(), start + data.len());
            put(&mut directory, pool + names.len(), 4);
            put(&mut directory, name.len(), 2);
            directory.extend([code, 0]);
            put(&mut directory, values.len(), 4);
            put(&mut directory, offset, 4);
            names.extend(name.bytes());
            match values {
                ColumnData::F32(values) => values.iter().for_each(|v| data.extend(v.to_le_bytes())),
                ColumnData::F64(values) => values.iter().for_each(|v| data.extend(v.to_le_bytes())),
                ColumnData::I32(values) => values.iter().for_each(|v| data.extend(v.to_le_bytes())),
                ColumnData::I64(values) => values.iter().for_each(|v| data.extend(v.to_le_bytes())),
            }
        }
        let mut block = b"NCPB\x01\x00".to_vec();
        put(&mut block, columns.len(), 2);
        put(&mut block, start + data.len(), 4);
        [block, directory, names, data].concat()
    }

    fn put(out: &mut Vec<u8>, number: usize, bytes: usize) {
        out.extend(&number.to_le_bytes()[..bytes]);
    }

    fn little(bytes: &[u8], at: usize, len: usize) -> Option<u64> {
        let bytes = bytes.get(at..at + len)?;
        Some(bytes.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte)))
    }

    /// The bytes of a region that nobody owned before.
    fn take<'b>(block: &'b [u8], owned: &mut [bool], start: u64, len: u64) -> Option<&'b [u8]> {
        let range = usize::try_from(start).ok()?..usize::try_from(start + len).ok()?;
        for owned in owned.get_mut(range.clone())? {
            if std::mem::replace(owned, true) {
                return None;
            }
        }
        block.get(range)
    }
}
