//! The BulkBlock decoder against a slow one that is easy to believe, over damaged
//! and arbitrary blocks; and what goes in comes out, bit for bit.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests may")]

use std::collections::HashSet;

use ncp_spec::bulk::{Block, Column, ColumnData, ColumnView, Dtype, Element, encode, pack, unpack};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

/// A column as plain facts: name, dtype code, the values' bits.
type Facts = (String, u8, Vec<u64>);

/// The slow decoder: marks the owner of every single byte.
mod model {
    use super::{Facts, HashSet};

    pub(super) fn decode(block: &[u8]) -> Option<Vec<Facts>> {
        let field = |at: usize, len: usize| -> Option<u64> {
            let bytes = block.get(at..at + len)?;
            Some(bytes.iter().rev().fold(0, |sum, byte| sum * 256 + u64::from(*byte)))
        };
        let columns = field(6, 2)? as usize;
        let header_is_right = block.len() <= 67_108_864
            && block.get(..6)? == b"NCPB\x01\0"
            && field(8, 4)? == block.len() as u64
            && columns <= 4096;
        if !header_is_right {
            return None;
        }

        let mut taken = vec![false; block.len()];
        take(&mut taken, 0, 12 + 16 * columns as u64)?;
        let mut seen = HashSet::new();
        let mut facts = Vec::new();
        for entry in (0..columns).map(|column| 12 + 16 * column) {
            let (name_off, name_len) = (field(entry, 4)?, field(entry + 4, 2)?);
            let (dtype, pad) = (field(entry + 6, 1)? as u8, field(entry + 7, 1)?);
            let (rows, data_off) = (field(entry + 8, 4)?, field(entry + 12, 4)?);
            let width = match dtype {
                1 | 3 => 4,
                2 | 4 => 8,
                _ => return None,
            };
            if pad != 0 {
                return None;
            }
            take(&mut taken, name_off, name_len)?;
            take(&mut taken, data_off, rows * width)?;
            let name = &block[name_off as usize..(name_off + name_len) as usize];
            let name = String::from_utf8(name.to_vec()).ok()?;
            if !seen.insert(name.clone()) {
                return None;
            }
            let value = |row| field((data_off + row * width) as usize, width as usize);
            facts.push((name, dtype, (0..rows).map(value).collect::<Option<_>>()?));
        }
        Some(facts)
    }

    /// Takes bytes that nobody has taken yet.
    fn take(taken: &mut [bool], start: u64, len: u64) -> Option<()> {
        if start > taken.len() as u64 {
            return None;
        }
        for at in start..start + len {
            let byte = taken.get_mut(at as usize)?;
            if *byte {
                return None;
            }
            *byte = true;
        }
        Some(())
    }
}

/// The decoder under test in the model's terms.
fn decode(block: &[u8]) -> Option<Vec<Facts>> {
    let block = Block::parse(block).ok()?;
    let facts = |view: ColumnView<'_>| {
        let bits = match view.dtype() {
            Dtype::F32 => bits(&view, |value: f32| u64::from(value.to_bits())),
            Dtype::F64 => bits(&view, f64::to_bits),
            Dtype::I32 => bits(&view, |value: i32| u64::from(value as u32)),
            Dtype::I64 => bits(&view, |value: i64| value as u64),
        };
        (view.name().to_owned(), view.dtype().code(), bits)
    };
    Some(block.columns().map(facts).collect())
}

/// A column's bits, read in every way that a view has; they must agree.
fn bits<T: Element>(view: &ColumnView<'_>, bit: impl Fn(T) -> u64 + Copy) -> Vec<u64> {
    let bits: Vec<_> = view.iter().unwrap().map(bit).collect();
    assert_eq!(bits.len(), view.rows());
    assert_eq!(bits, view.to_vec().unwrap().into_iter().map(bit).collect::<Vec<_>>());
    for row in [0, view.rows() / 2, view.rows().wrapping_sub(1), view.rows()] {
        assert_eq!(view.get(row).map(bit), bits.get(row).copied());
    }
    if let Some(slice) = view.as_slice::<T>() {
        assert!(bits.iter().copied().eq(slice.iter().map(|value| bit(*value))));
    }
    bits
}

/// A valid block whose regions lie in any order, with gaps and at any address.
#[derive(Debug, Clone)]
struct Plan {
    columns: Vec<(String, Dtype, Vec<u8>)>,
    /// Each region's rank in the order of the bytes, and the gap before it.
    places: Vec<(u32, Vec<u8>)>,
    tail: Vec<u8>,
}

impl Plan {
    fn build(&self) -> Vec<u8> {
        let count = self.columns.len();
        let mut block = b"NCPB\x01\0".to_vec();
        block.extend((count as u16).to_le_bytes());
        block.resize(12 + 16 * count, 0);
        let mut order: Vec<usize> = (0..2 * count).collect();
        order.sort_by_key(|region| self.places[*region].0);
        for region in order {
            let (column, is_data) = (region / 2, region % 2 == 1);
            let (name, dtype, data) = &self.columns[column];
            block.extend(&self.places[region].1);
            let offset = (block.len() as u32).to_le_bytes();
            let entry = 12 + 16 * column;
            if is_data {
                let rows = (data.len() / dtype.size()) as u32;
                block[entry + 8..entry + 12].copy_from_slice(&rows.to_le_bytes());
                block[entry + 12..entry + 16].copy_from_slice(&offset);
                block.extend(data);
            } else {
                block[entry..entry + 4].copy_from_slice(&offset);
                block[entry + 4..entry + 6].copy_from_slice(&(name.len() as u16).to_le_bytes());
                block[entry + 6] = dtype.code();
                block.extend(name.as_bytes());
            }
        }
        block.extend(&self.tail);
        state_length(&mut block);
        block
    }
}

fn state_length(block: &mut [u8]) {
    let len = (block.len() as u32).to_le_bytes();
    if let Some(field) = block.get_mut(8..12) {
        field.copy_from_slice(&len);
    }
}

/// Plans whose names are distinct.
fn plan() -> impl Strategy<Value = Plan> {
    any_plan().prop_map(|mut plan| {
        let mut seen = HashSet::new();
        plan.columns.retain(|(name, ..)| seen.insert(name.clone()));
        plan
    })
}

fn any_plan() -> impl Strategy<Value = Plan> {
    let dtype = prop::sample::select(&Dtype::ALL[..]);
    // Zeros at a name's end are what a digest by words may overlook.
    let column = ("[a-h\\x00]{0,3}|\\PC{0,10}", dtype, 0..5_usize)
        .prop_flat_map(|(name, dtype, rows)| (Just(name), Just(dtype), vec(any::<u8>(), rows * dtype.size())));
    // Twelve columns need sorting room from the heap, eight do not.
    vec(column, 0..12).prop_flat_map(|columns| {
        let places = vec((any::<u32>(), vec(any::<u8>(), 0..4)), 2 * columns.len());
        (Just(columns), places, vec(any::<u8>(), 0..4)).prop_map(|(columns, places, tail)| Plan {
            columns,
            places,
            tail,
        })
    })
}

/// A damage that knows the format.
#[derive(Debug, Clone)]
enum Damage {
    /// Puts a telling number into a field of a directory entry.
    Field { column: Index, field: usize, value: Index, off_by: i64 },
    /// Puts a telling number into the header.
    Header { field: usize, value: Index, off_by: i64 },
    /// One column takes the directory entry of another.
    CopyEntry { from: Index, to: Index },
    /// Two columns exchange a field.
    ExchangeField { one: Index, other: Index, field: usize },
    /// The block ends early and says so.
    Cut(Index),
    /// Bytes follow the block.
    Append(Vec<u8>),
    /// One byte is another.
    Byte(Index, u8),
}

/// Offset and width of the fields in header and entry.
const HEADER_FIELDS: [(usize, usize); 5] = [(0, 4), (4, 1), (5, 1), (6, 2), (8, 4)];
const ENTRY_FIELDS: [(usize, usize); 6] = [(0, 4), (4, 2), (6, 1), (7, 1), (8, 4), (12, 4)];

fn damage() -> impl Strategy<Value = Damage> {
    let entry_field = || 0..ENTRY_FIELDS.len();
    prop_oneof![
        8 => (any::<Index>(), entry_field(), any::<Index>(), -1..=1_i64)
            .prop_map(|(column, field, value, off_by)| {
                Damage::Field { column, field, value, off_by }
            }),
        2 => (0..HEADER_FIELDS.len(), any::<Index>(), -1..=1_i64)
            .prop_map(|(field, value, off_by)| Damage::Header { field, value, off_by }),
        1 => any::<(Index, Index)>().prop_map(|(from, to)| Damage::CopyEntry { from, to }),
        3 => (any::<Index>(), any::<Index>(), entry_field())
            .prop_map(|(one, other, field)| Damage::ExchangeField { one, other, field }),
        1 => any::<Index>().prop_map(Damage::Cut),
        1 => vec(any::<u8>(), 1..9).prop_map(Damage::Append),
        2 => any::<(Index, u8)>().prop_map(|(at, byte)| Damage::Byte(at, byte)),
    ]
}

impl Damage {
    fn apply(&self, block: &mut Vec<u8>) {
        let columns = block.get(6..8).map_or(0, |field| usize::from(field[0]));
        let entries = columns.min(block.len().saturating_sub(12) / 16);
        let entry = |index: &Index| (entries > 0).then(|| 12 + 16 * index.index(entries));
        match self {
            Self::Field { column, field, value, off_by } => {
                let (offset, width) = ENTRY_FIELDS[*field];
                if let Some(entry) = entry(column) {
                    let value = telling(block, entries, value, *off_by);
                    block[entry + offset..][..width].copy_from_slice(&value[..width]);
                }
            }
            Self::Header { field, value, off_by } => {
                let (offset, width) = HEADER_FIELDS[*field];
                let value = telling(block, entries, value, *off_by);
                if let Some(bytes) = block.get_mut(offset..offset + width) {
                    bytes.copy_from_slice(&value[..width]);
                }
            }
            Self::CopyEntry { from, to } => {
                if let (Some(from), Some(to)) = (entry(from), entry(to)) {
                    block.copy_within(from..from + 16, to);
                }
            }
            Self::ExchangeField { one, other, field } => {
                let (offset, width) = ENTRY_FIELDS[*field];
                if let (Some(one), Some(other)) = (entry(one), entry(other)) {
                    for at in offset..offset + width {
                        block.swap(one + at, other + at);
                    }
                }
            }
            Self::Cut(at) => {
                block.truncate(at.index(block.len() + 1));
                state_length(block);
            }
            Self::Append(bytes) => {
                block.extend(bytes);
                state_length(block);
            }
            Self::Byte(at, byte) => {
                if !block.is_empty() {
                    let at = at.index(block.len());
                    block[at] = *byte;
                }
            }
        }
    }
}

/// A number at which a careless decoder may go wrong: an edge of the block, of the
/// directory or of a region, or of its arithmetic.
fn telling(block: &[u8], entries: usize, pick: &Index, off_by: i64) -> [u8; 4] {
    let field = |at| u32::from_le_bytes(*block[at..].first_chunk().unwrap());
    let len = block.len() as u32;
    let mut numbers = vec![0, 1, 4, 8, 12, 12 + 16 * entries as u32, len, u32::MAX, 1 << 29, 1 << 30, 1 << 31];
    for entry in (0..entries).map(|column| 12 + 16 * column) {
        let (name, data, rows) = (field(entry), field(entry + 12), field(entry + 8));
        let name_end = name.wrapping_add(field(entry + 4) & 0xffff);
        let data_end = data.wrapping_add(rows.wrapping_mul(4));
        numbers.extend([name, name_end, data, data_end, len.wrapping_sub(rows.wrapping_mul(8))]);
    }
    numbers[pick.index(numbers.len())].wrapping_add_signed(off_by as i32).to_le_bytes()
}

fn damaged() -> impl Strategy<Value = Vec<u8>> {
    (prop_oneof![plan(), any_plan()], vec(damage(), 0..4)).prop_map(|(plan, damages)| {
        let mut block = plan.build();
        for damage in damages {
            damage.apply(&mut block);
        }
        block
    })
}

fn column_data() -> impl Strategy<Value = ColumnData> {
    // From bits, so that NaN payloads and both zeros are among them.
    let f32s = prop_oneof![any::<u32>().prop_map(f32::from_bits), Just(-0.0), Just(f32::NAN)];
    let f64s =
        prop_oneof![any::<u64>().prop_map(f64::from_bits), Just(-0.0), Just(f64::from_bits(0x7ff0_0000_0000_0001)),];
    prop_oneof![
        vec(f32s, 0..40).prop_map(ColumnData::F32),
        vec(f64s, 0..40).prop_map(ColumnData::F64),
        vec(any::<i32>(), 0..40).prop_map(ColumnData::I32),
        vec(any::<i64>(), 0..40).prop_map(ColumnData::I64),
    ]
}

fn columns() -> impl Strategy<Value = Vec<Column>> {
    vec(("\\PC{0,12}", column_data()), 0..20).prop_map(|columns| {
        let mut seen = HashSet::new();
        let distinct = columns.into_iter().filter(|(name, _)| seen.insert(name.clone()));
        distinct.map(|(name, data)| Column { name, data }).collect()
    })
}

fn facts_of(column: &Column) -> Facts {
    let bits = match &column.data {
        ColumnData::F32(values) => values.iter().map(|v| u64::from(v.to_bits())).collect(),
        ColumnData::F64(values) => values.iter().map(|v| v.to_bits()).collect(),
        ColumnData::I32(values) => values.iter().map(|v| u64::from(*v as u32)).collect(),
        ColumnData::I64(values) => values.iter().map(|v| *v as u64).collect(),
    };
    (column.name.clone(), column.data.dtype().code(), bits)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// [NCP-BULK-018] [NCP-BULK-021] [NCP-BULK-023] [NCP-BULK-030] [NCP-BULK-032]
    #[test]
    fn columns_come_back_bit_for_bit(columns in columns(), shift in 0..9_usize) {
        let block = encode(&columns).unwrap();
        prop_assert_eq!(model::decode(&block), Some(columns.iter().map(facts_of).collect()));
        let shifted = [&vec![0; shift], &block[..]].concat();
        let back = Block::parse(&shifted[shift..]).unwrap().to_columns();
        prop_assert_eq!(&back, &columns);
        prop_assert_eq!(encode(&back).unwrap(), block);
    }

    /// [NCP-OBS-001] [NCP-OBS-002] [NCP-OBS-005]
    #[test]
    fn an_observation_comes_back_bit_for_bit(
        rows in 0..50_usize,
        present in any::<[bool; 3]>(),
        seed in vec(any::<(u64, u64, i64)>(), 50),
    ) {
        let rows = |array: usize| if present[array] { rows } else { 0 };
        let times: Vec<_> = seed[..rows(0)].iter().map(|row| f64::from_bits(row.0)).collect();
        let values: Vec<_> = seed[..rows(1)].iter().map(|row| f64::from_bits(row.1)).collect();
        let senders: Vec<_> = seed[..rows(2)].iter().map(|row| row.2).collect();
        let back = unpack(&pack(&times, &values, &senders).unwrap()).unwrap();
        let bits = |array: &[f64]| array.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&back.0), bits(&times));
        prop_assert_eq!(bits(&back.1), bits(&values));
        prop_assert_eq!(back.2, senders);
    }

    /// [NCP-BULK-018] [NCP-BULK-020] [NCP-BULK-021] [NCP-BULK-022] [NCP-BULK-023]
    #[test]
    fn a_valid_block_of_any_layout_is_read_as_it_was_planned(plan in plan()) {
        let block = plan.build();
        let planned = |(name, dtype, data): &(String, Dtype, Vec<u8>)| {
            let value = |le: &[u8]| le.iter().rev().fold(0, |sum, byte| sum << 8 | u64::from(*byte));
            (name.clone(), dtype.code(), data.chunks(dtype.size()).map(value).collect())
        };
        prop_assert_eq!(decode(&block), Some(plan.columns.iter().map(planned).collect()));
    }

    /// [NCP-BULK-001] [NCP-BULK-002] [NCP-BULK-003] [NCP-BULK-004] [NCP-BULK-005] [NCP-BULK-006]
    /// [NCP-BULK-007] [NCP-BULK-009] [NCP-BULK-010] [NCP-BULK-011] [NCP-BULK-012]
    #[test]
    fn a_damaged_block_is_judged_and_read_as_by_the_slow_decoder(block in damaged()) {
        prop_assert_eq!(decode(&block), model::decode(&block));
    }

    /// [NCP-BULK-001] [NCP-BULK-005] [NCP-BULK-006]
    #[test]
    fn arbitrary_bytes_are_judged_as_by_the_slow_decoder(
        mut bytes in vec(any::<u8>(), 0..300),
        header in any::<bool>(),
        columns in 0..4_u8,
    ) {
        if header && bytes.len() >= 12 {
            bytes[..8].copy_from_slice(&[b'N', b'C', b'P', b'B', 1, 0, columns, 0]);
            state_length(&mut bytes);
        }
        prop_assert_eq!(decode(&bytes), model::decode(&bytes));
        let _ = unpack(&bytes);
    }
}

#[test]
fn every_value_of_every_header_and_directory_byte_is_judged_as_by_the_slow_decoder() {
    let golden = pack(&[1.5, 2.5, 9.0], &[], &[7, 7, 9]).unwrap();
    for at in 0..44 {
        for byte in 0..=255 {
            let mut block = golden.clone();
            block[at] = byte;
            assert_eq!(decode(&block), model::decode(&block), "byte {at} is {byte}");
        }
    }
}

#[test]
fn the_damages_leave_some_blocks_valid_and_break_others() {
    let mut runner = TestRunner::deterministic();
    let blocks = (0..1000).map(|_| damaged().new_tree(&mut runner).unwrap().current());
    let valid = blocks.filter(|block| model::decode(block).is_some()).count();
    assert!((150..850).contains(&valid), "{valid} of 1000 are valid");
}
