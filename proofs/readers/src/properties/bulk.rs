//! BulkBlock: the decoder accepts exactly the blocks of 5.1 and gives exactly their columns; what the encoder
//! writes is the block of the text.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_proofs::prover::Prover;
use serde_json::{Value, json};

use crate::readers::{Column, Readers};

/// The bytes behind the directory of the small blocks: a name twice, one of two bytes, one that is no UTF-8,
/// and numbers that differ in every byte.
const TAIL: [u8; 20] = *b"aab\xc3\xa9\xff\x01\x02\x03\x04\x05\x06\x07\x08\x09\x7f\xf0\xff\x80\x00";
/// Most columns.
const MOST: usize = 3;

/// Headers: every length of the buffer, with the boundaries of every field.
pub fn header<R: Readers, P: Prover>(p: &mut P) {
    let block = header_block(p);
    decodes::<R, P>(p, &block);
}

/// One column: the boundaries of all six fields of its entry, all combined.
pub fn entry<R: Readers, P: Prover>(p: &mut P) {
    let block = block_of(p, 1, &ONE);
    decodes::<R, P>(p, &block);
}

/// Directories of no to three columns, with fewer values a field: how columns bear on each other.
pub fn directories<R: Readers, P: Prover>(p: &mut P) {
    let block = directories_block(p);
    decodes::<R, P>(p, &block);
}

/// Sets of no to three columns: the encoder refuses equal names, else it writes the block of the text, which
/// decodes to the same columns.
pub fn columns<R: Readers, P: Prover>(p: &mut P) {
    let columns = some_columns(p);
    let block = R::encode(&columns);
    let same = p.truth(block == block_of_columns(&columns));
    p.check("the block of the text, or an error", same);
    if let Some(block) = block {
        let same = p.truth(R::decode(&block).as_ref() == Some(&columns));
        p.check("what is encoded decodes to the same", same);
        let same = p.truth(columns_of(&block) == Some(columns));
        p.check("what is encoded reads as the same by the text", same);
    }
}

/// A block of a harness's inputs, for those properties that decode one.
pub fn block<P: Prover>(property: &str, p: &mut P) -> Option<Vec<u8>> {
    match property {
        "bulk/header" => Some(header_block(p)),
        "bulk/entry" => Some(block_of(p, 1, &ONE)),
        "bulk/directories" => Some(directories_block(p)),
        _ => None,
    }
}

/// The case that a harness's inputs are, as a vector.
pub(super) fn vector<P: Prover>(property: &str, p: &mut P) -> Option<Value> {
    if let Some(block) = block(property, p) {
        return Some(json!({
            "roles": ["commander", "observer"],
            "call": "bulk.decode",
            "args": { "block": STANDARD.encode(&block) },
            "expect": match columns_of(&block) {
                None => json!({ "reject": "block" }),
                Some(columns) => json!({
                    "relation": "json",
                    "value": { "columns": columns.iter().map(spelled).collect::<Vec<_>>() },
                }),
            },
        }));
    }
    let columns = some_columns(p);
    Some(json!({
        "roles": ["server"],
        "call": "bulk.encode",
        "args": { "columns": columns.iter().map(spelled).collect::<Vec<_>>() },
        "expect": match block_of_columns(&columns) {
            None => json!({ "reject": "block" }),
            Some(block) => json!({ "relation": "bytes", "base64": STANDARD.encode(block) }),
        },
    }))
}

fn decodes<R: Readers, P: Prover>(p: &mut P, block: &[u8]) {
    let (answer, says) = (R::decode(block), columns_of(block));
    let is_block = p.truth(says.is_some());
    p.exactly("a block by the rules", answer.is_some(), is_block);
    if let (Some(answer), Some(says)) = (answer, says) {
        let taken: usize = answer.iter().map(|c| c.name.len() + c.values.len()).sum();
        let same = p.truth(answer == says);
        p.check("the columns in order, every value exactly", same);
        let within = p.truth(taken <= block.len());
        p.check("no more bytes than the block has", within);
    }
}

// ---- What is drawn. ----

/// The values of the fields of an entry; of offsets some count from the directory's end D or the buffer's end
/// L.
struct Fields {
    name_off: &'static [At],
    name_len: &'static [u16],
    /// The dtype and the pad.
    types: &'static [[u8; 2]],
    rows: &'static [u32],
    data_off: &'static [At],
}

/// An offset.
#[derive(Clone, Copy)]
enum At {
    Byte(u32),
    Directory(i32),
    End(i32),
}
use At::{Byte, Directory, End};

const OFFSETS: &[At] = &[
    Byte(0),
    Byte(1),
    Byte(11),
    Byte(12),
    Byte(13),
    Directory(-1),
    Directory(0),
    Directory(1),
    Directory(2),
    Directory(3),
    Directory(4),
    Directory(5),
    Directory(6),
    Directory(7),
    Directory(8),
    End(-9),
    End(-8),
    End(-7),
    End(-5),
    End(-4),
    End(-3),
    End(-2),
    End(-1),
    End(0),
    End(1),
    Byte(0x7fff_ffff),
    Byte(0x8000_0000),
    Byte(0xffff_fff8),
    Byte(0xffff_ffff),
];

/// All that a single entry can get wrong.
const ONE: Fields = Fields {
    name_off: OFFSETS,
    name_len: &[0, 1, 2, 3, 19, 20, 21, 0xffff],
    types: &[
        [0, 0],
        [1, 0],
        [2, 0],
        [3, 0],
        [4, 0],
        [5, 0],
        [0x80, 0],
        [0xff, 0],
        [1, 1],
        [2, 0x80],
        [3, 0xff],
        [4, 2],
        [0, 1],
    ],
    rows: &[
        0,
        1,
        2,
        3,
        4,
        5,
        6,
        0x1fff_ffff,
        0x2000_0000,
        0x2000_0001,
        0x3fff_ffff,
        0x4000_0000,
        0x4000_0001,
        0x7fff_ffff,
        0x8000_0000,
        0xffff_ffff,
    ],
    data_off: OFFSETS,
};

/// What two entries can get wrong together, and the coarser faults of each.
const TWO: Fields = Fields {
    name_off: &[Byte(12), Directory(-1), Directory(0), Directory(1), Directory(3), Directory(5), End(-1), End(0)],
    name_len: &[0, 1, 2, 0xffff],
    types: &[[1, 0], [4, 0], [5, 0]],
    rows: &[0, 1, 2, 0x2000_0000],
    data_off: &[Byte(0), Directory(0), Directory(1), Directory(4), End(-8), End(-4), End(0), End(1)],
};

/// What three entries can get wrong together.
const THREE: Fields = Fields {
    name_off: &[Directory(-1), Directory(0), Directory(1), Directory(2)],
    name_len: &[0, 1, 3],
    types: &[[1, 0], [2, 0], [3, 1]],
    rows: &[0, 1],
    data_off: &[Byte(12), Directory(3), End(-8), End(-4)],
};

fn of<P: Prover, T: Copy>(p: &mut P, name: &str, values: &[T]) -> Option<T> {
    let nth = p.choice(name, values.len());
    values.get(nth).copied()
}

fn header_block<P: Prover>(p: &mut P) -> Vec<u8> {
    const WHOLE: usize = 12 + 16 * 2 + TAIL.len();
    let columns = of(p, "columns", &[0_u16, 1, 2, 3, 0x100, 4096, 4097, 0xffff]).unwrap_or_default();
    let mut block = b"NCPB\x01\0".to_vec();
    block.extend(columns.to_le_bytes());
    block.extend([0; 4]);
    // Two entries that are good, over one name of one byte each and one row each.
    for (name, data) in [(44_u32, 50_u32), (46, 56)] {
        block.extend(name.to_le_bytes());
        block.extend([1, 0, 1, 0, 1, 0, 0, 0]);
        block.extend(data.to_le_bytes());
    }
    block.extend(TAIL);
    let length = p.choice("buffer", WHOLE + 1);
    block.truncate(length);
    let length = u32::try_from(length).unwrap_or_default();
    let stated = p.choice("total_len", 6);
    let stated = [length, length.wrapping_sub(1), length + 1, length | 0x0100_0000, 0, u32::MAX]
        .get(stated)
        .copied()
        .unwrap_or_default();
    let letter = p.choice("letter", 5);
    let flip = of(p, "letter_flips", &[0x20_u8, 0x80]).unwrap_or_default();
    let version = of(p, "version", &[1_u8, 0, 2, 0x81, 0xff]).unwrap_or_default();
    let flags = of(p, "flags", &[0_u8, 1, 2, 0x80, 0xff]).unwrap_or_default();
    let mut put = |at: usize, bytes: &[u8]| {
        for (slot, byte) in block.iter_mut().skip(at).zip(bytes) {
            *slot = *byte;
        }
    };
    put(4, &[version, flags]);
    put(8, &stated.to_le_bytes());
    if let Some(byte) = block.get_mut(..4).and_then(|magic| magic.get_mut(letter)) {
        *byte ^= flip;
    }
    block
}

fn directories_block<P: Prover>(p: &mut P) -> Vec<u8> {
    let most = p.length(MOST);
    let columns = p.choice("columns", most + 1);
    let fields = if columns < 3 { &TWO } else { &THREE };
    block_of(p, columns, fields)
}

/// A block of so many columns with the drawn entries, whose header is good.
fn block_of<P: Prover>(p: &mut P, columns: usize, fields: &Fields) -> Vec<u8> {
    let directory = 12 + 16 * columns;
    let length = directory + TAIL.len();
    let mut block = Vec::with_capacity(length);
    block.extend(b"NCPB\x01\0");
    block.extend(u16::try_from(columns).unwrap_or_default().to_le_bytes());
    block.extend(u32::try_from(length).unwrap_or_default().to_le_bytes());
    let offset = |at: Option<At>| {
        let base = |base: usize| u32::try_from(base).unwrap_or_default();
        match at {
            Some(Byte(byte)) => byte,
            Some(Directory(off)) => base(directory).wrapping_add_signed(off),
            Some(End(off)) => base(length).wrapping_add_signed(off),
            None => 0,
        }
    };
    for _ in 0..columns {
        let name_off = of(p, "name_off", fields.name_off);
        block.extend(offset(name_off).to_le_bytes());
        let name_len = of(p, "name_len", fields.name_len);
        block.extend(name_len.unwrap_or_default().to_le_bytes());
        let types = of(p, "dtype_and_pad", fields.types);
        block.extend(types.unwrap_or_default());
        let rows = of(p, "n_rows", fields.rows);
        block.extend(rows.unwrap_or_default().to_le_bytes());
        let data_off = of(p, "data_off", fields.data_off);
        block.extend(offset(data_off).to_le_bytes());
    }
    block.extend(TAIL);
    block
}

/// The edges of each dtype, as the low bytes of these: zeros, ones, the least and the greatest, a NaN with a
/// payload, −0.
const EDGES: [[u8; 8]; 3] = [[0, 0, 0, 0x80, 0, 0, 0, 0x80], [1, 2, 0x80, 0x7f, 3, 4, 0xf4, 0x7f], [0xff; 8]];

/// No to three columns of no to two rows.
fn some_columns<P: Prover>(p: &mut P) -> Vec<Column> {
    let most = p.length(MOST);
    let columns = p.choice("columns", most + 1);
    (0..columns)
        .map(|_| {
            let name = of(p, "name", &["", "a", "\u{e9}9"]).unwrap_or_default();
            let dtype = of(p, "dtype", &[1_u8, 2, 3, 4]).unwrap_or(1);
            let rows = p.choice("rows", 3);
            let mut values = Vec::new();
            for _ in 0..rows {
                let value = of(p, "value", &EDGES).unwrap_or_default();
                let width = width_of(dtype).unwrap_or_default();
                values.extend(value.iter().take(width));
            }
            let name = name.to_owned();
            Column { name, dtype, values }
        })
        .collect()
}

// ---- What the text says, byte by byte and slow. ----

/// Who owns each byte; blocks here are short.
#[derive(Debug)]
struct Owned(Vec<bool>);

impl Owned {
    /// Takes a region, unless it lies not wholly within the buffer or has a byte that is taken.
    fn take(&mut self, start: u64, len: u64) -> Option<()> {
        // [NCP-BULK-009] [NCP-BULK-011] [NCP-BULK-014]
        if start + len > self.0.len() as u64 {
            return None;
        }
        for byte in start..start + len {
            let is_taken = self.0.get_mut(usize::try_from(byte).ok()?)?;
            if std::mem::replace(is_taken, true) {
                return None; // [NCP-BULK-012]
            }
        }
        Some(())
    }
}

/// Bytes a value. [NCP-BULK-007]
fn width_of(dtype: u8) -> Option<usize> {
    match dtype {
        1 | 3 => Some(4),
        2 | 4 => Some(8),
        _ => None,
    }
}

/// The columns of a block by the rules of 5.1, the SHOULD ones included; none where one is broken.
fn columns_of(block: &[u8]) -> Option<Vec<Column>> {
    let number = |at: usize, width: usize| {
        let bytes = block.get(at..at + width)?.iter().rev();
        Some(bytes.fold(0_u64, |number, byte| number * 256 + u64::from(*byte))) // [NCP-BULK-022]
    };
    // [NCP-BULK-001] to [NCP-BULK-005]
    if block.len() < 12 || block.get(..6)? != b"NCPB\x01\0" || number(8, 4)? != block.len() as u64 {
        return None;
    }
    let count = number(6, 2)?;
    // [NCP-BULK-015] [NCP-BULK-016]
    if block.len() > 67_108_864 || count > 4096 {
        return None;
    }
    let mut owned = Owned(vec![false; block.len()]);
    owned.take(0, 12 + 16 * count)?; // [NCP-BULK-006]
    let mut columns: Vec<Column> = Vec::new();
    for entry in (12..).step_by(16).take(usize::try_from(count).ok()?) {
        let (name_off, name_len) = (number(entry, 4)?, number(entry + 4, 2)?);
        let (dtype, pad) = (*block.get(entry + 6)?, *block.get(entry + 7)?);
        let width = width_of(dtype)?;
        // [NCP-BULK-008]
        if pad != 0 {
            return None;
        }
        let data_off = number(entry + 12, 4)?;
        let data_len = number(entry + 8, 4)? * width as u64;
        owned.take(name_off, name_len)?;
        owned.take(data_off, data_len)?;
        let cut = |from: u64, len: u64| block.get(usize::try_from(from).ok()?..usize::try_from(from + len).ok()?);
        // [NCP-BULK-010]
        let name = std::str::from_utf8(cut(name_off, name_len)?).ok()?.to_owned();
        // [NCP-BULK-013]
        if columns.iter().any(|column| column.name == name) {
            return None;
        }
        let values = cut(data_off, data_len)?.to_vec();
        columns.push(Column { name, dtype, values });
    }
    Some(columns)
}

/// The block that the text has an encoder write: [NCP-BULK-032] [NCP-BULK-033]; none for equal names
/// [NCP-BULK-034].
fn block_of_columns(columns: &[Column]) -> Option<Vec<u8>> {
    for (nth, column) in columns.iter().enumerate() {
        if columns.iter().take(nth).any(|other| other.name == column.name) {
            return None;
        }
    }
    let directory = 12 + 16 * columns.len();
    let mut pool = Vec::new();
    let mut entries = Vec::new();
    for column in columns {
        entries.push(directory + pool.len());
        pool.extend(column.name.bytes());
    }
    let mut data = Vec::new();
    let begin = directory + pool.len();
    let mut block = Vec::new();
    for (column, name_off) in columns.iter().zip(entries) {
        while !(begin + data.len()).is_multiple_of(8) {
            data.push(0);
        }
        let rows = column.values.len() / width_of(column.dtype)?;
        block.extend(u32::try_from(name_off).ok()?.to_le_bytes());
        block.extend(u16::try_from(column.name.len()).ok()?.to_le_bytes());
        block.extend([column.dtype, 0]);
        block.extend(u32::try_from(rows).ok()?.to_le_bytes());
        block.extend(u32::try_from(begin + data.len()).ok()?.to_le_bytes());
        data.extend(&column.values);
    }
    let total = u32::try_from(begin + data.len()).ok()?.to_le_bytes();
    let count = u16::try_from(columns.len()).ok()?.to_le_bytes();
    Some([b"NCPB\x01\0", &count[..], &total, &block, &pool, &data].concat())
}

/// A column as the peer protocol spells it.
fn spelled(column: &Column) -> Value {
    let number = |x: f64| match x {
        x if x.is_nan() => json!("NaN"),
        x if x.is_infinite() => json!(if x > 0.0 { "Infinity" } else { "-Infinity" }),
        x if x == 0.0 && x.is_sign_negative() => json!("-0"),
        x => json!(x),
    };
    let bytes = column.values.as_slice();
    let (dtype, data): (_, Vec<Value>) = match column.dtype {
        1 => ("f32", values(bytes, |raw| number(f32::from_le_bytes(raw).into()))),
        2 => ("f64", values(bytes, |raw| number(f64::from_le_bytes(raw)))),
        3 => ("i32", values(bytes, |raw| json!(i32::from_le_bytes(raw)))),
        _ => ("i64", values(bytes, |raw| json!(i64::from_le_bytes(raw).to_string()))),
    };
    json!({ "name": column.name, "dtype": dtype, "data": data })
}

fn values<const N: usize>(bytes: &[u8], spell: impl Fn([u8; N]) -> Value) -> Vec<Value> {
    bytes.as_chunks().0.iter().map(|raw| spell(*raw)).collect()
}
