//! BulkBlocks: valid ones in every layout that a decoder takes, and such with one thing wrong.

use super::frames::base64;
use super::{Draw, Tree};
use crate::fuzz::tree::{int, list, num, nums, object, text};

fn columns(draw: &mut Draw<'_>) -> Vec<(String, usize, usize)> {
    let count = match draw.below(60) {
        0 => draw.size(100, 4096),
        1..=5 => draw.size(4, 64),
        _ => draw.below(5),
    };
    let most = if draw.chance(3) { 70_000 } else { 40 };
    (0..count)
        .map(|nth| {
            let name = match draw.below(8) {
                0 => {
                    let length = if draw.chance(10) { draw.one(&[255, 256, 65_535]) } else { draw.size(1, 300) };
                    format!("{nth}{}", "n".repeat(length - nth.to_string().len().min(length)))
                }
                1 => format!("{}{nth}", draw.spiced()),
                // One that another has but for its end, or that reads as a number.
                3 => {
                    draw.one(&["c", "c0", "times"]).to_owned()
                        + draw.pick(&["\0", "\0\0", " ", "0", ""])
                        + &nth.to_string()
                }
                4 if draw.chance(50) => nth.to_string(),
                2 if draw.chance(30) => format!("{nth}{}", draw.spiced()),
                _ => format!("c{nth}"),
            };
            let rows = if count > 100 { draw.below(4) } else { draw.size(0, most) };
            (name, 1 + draw.below(4), rows)
        })
        .collect()
}

/// Small singles: subnormal ones.
fn subnormal(draw: &mut Draw<'_>) -> f32 {
    #[expect(clippy::cast_possible_truncation, reason = "any bits will do")]
    f32::from_bits(draw.next() as u32 & 0x807f_ffff)
}

fn value(dtype: usize, draw: &mut Draw<'_>) -> Vec<u8> {
    match dtype {
        1 => {
            #[expect(clippy::cast_possible_truncation, reason = "any single will do")]
            let single = if draw.chance(10) {
                subnormal(draw)
            } else if draw.chance(50) {
                draw.plain() as f32
            } else {
                f32::from_bits(draw.next() as u32)
            };
            single.to_le_bytes().to_vec()
        }
        2 => draw.double().to_le_bytes().to_vec(),
        #[expect(clippy::cast_possible_truncation, reason = "any bits will do")]
        3 => (draw.next() as u32).to_le_bytes().to_vec(),
        4 if draw.chance(20) => ((1 << 53) + draw.range(0, 4)).to_le_bytes().to_vec(),
        _ => if draw.chance(50) { draw.integer() } else { draw.next().cast_signed() }.to_le_bytes().to_vec(),
    }
}

/// Two values: the same twice, zeros of both signs, neighbours that are one double, or any two.
fn pair(dtype: usize, draw: &mut Draw<'_>) -> [Vec<u8>; 2] {
    let one = value(dtype, draw);
    match (draw.below(4), dtype) {
        (0, 1) => [0.0_f32, -0.0].map(|zero| zero.to_le_bytes().to_vec()),
        (0, 2) => [0.0_f64, -0.0].map(|zero| zero.to_le_bytes().to_vec()),
        (0, 4) => [1_i64 << 53, (1 << 53) + 1].map(|whole| whole.to_le_bytes().to_vec()),
        (1, _) => [one.clone(), one],
        _ => [one, value(dtype, draw)],
    }
}

/// A block with these columns, as a writer may lay it out.
fn block(columns: &[(String, usize, usize)], draw: &mut Draw<'_>) -> Vec<u8> {
    let padded = draw.chance(50);
    let gaps = draw.chance(20);
    let mut bytes = vec![0; 12 + 16 * columns.len()];
    let mut entries = Vec::new();
    let mut order = shuffled(columns.len(), draw);
    let mut names = vec![0; columns.len()];
    for &nth in &order {
        if gaps && draw.chance(30) {
            bytes.extend_from_slice(&[0xaa; 3]);
        }
        names[nth] = bytes.len();
        bytes.extend_from_slice(columns[nth].0.as_bytes());
    }
    let mut data = vec![0; columns.len()];
    if draw.chance(30) {
        order = shuffled(columns.len(), draw);
    }
    for &nth in &order {
        let (_, dtype, rows) = columns[nth];
        if padded {
            bytes.resize(bytes.len().next_multiple_of(8), 0);
        } else if gaps && draw.chance(30) {
            bytes.extend_from_slice(&[0x55; 5]);
        }
        data[nth] = bytes.len();
        // One value, or two by turns, again and again.
        let few = draw.chance(15).then(|| pair(dtype, draw));
        for row in 0..rows {
            match &few {
                Some(few) => bytes.extend(&few[(row / 7) % 2]),
                None => bytes.extend(value(dtype, draw)),
            }
        }
    }
    for (nth, (name, dtype, rows)) in columns.iter().enumerate() {
        entries.extend_from_slice(&le32(names[nth]));
        entries.extend_from_slice(&u16::try_from(name.len()).unwrap_or(u16::MAX).to_le_bytes());
        entries.extend_from_slice(&[u8::try_from(*dtype).unwrap_or(0), 0]);
        entries.extend_from_slice(&le32(*rows));
        entries.extend_from_slice(&le32(data[nth]));
    }
    let total = le32(bytes.len());
    let count = u16::try_from(columns.len()).unwrap_or(u16::MAX).to_le_bytes();
    let head = [&b"NCPB\x01\x00"[..], &count, &total].concat();
    bytes.splice(..12, head);
    bytes.splice(12..12 + entries.len(), entries);
    bytes
}

/// The numbers below this one, in their order, backwards, or in any.
fn shuffled(count: usize, draw: &mut Draw<'_>) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    match draw.below(8) {
        0 | 1 => order.reverse(),
        2 => (0..count).for_each(|at| order.swap(at, draw.below(count))),
        _ => {}
    }
    order
}

fn le32(value: usize) -> [u8; 4] {
    u32::try_from(value).unwrap_or(u32::MAX).to_le_bytes()
}

/// Puts one thing wrong.
fn broken(bytes: &mut Vec<u8>, columns: usize, draw: &mut Draw<'_>) {
    let entry = if columns == 0 { 0 } else { 12 + 16 * draw.below(columns) };
    let length = bytes.len();
    let set = |bytes: &mut Vec<u8>, at: usize, value: &[u8]| {
        for (nth, byte) in value.iter().enumerate() {
            if let Some(known) = bytes.get_mut(at + nth) {
                *known = *byte;
            }
        }
    };
    let odd = draw.one(&[0, 1, 11, 12, 27, 28, length - 1, length, length + 1, length / 2, u32::MAX as usize]);
    match draw.below(24) {
        // Cut, or longer, and the header says so.
        18 | 19 => {
            if draw.chance(50) {
                bytes.truncate(draw.below(length));
            } else {
                let whole = length.next_multiple_of(draw.one(&[1, 4, 8, 16]));
                bytes.resize(if whole > length { whole } else { length + 1 + draw.below(16) }, 0);
            }
            if draw.chance(60) {
                let total = le32(bytes.len());
                set(bytes, 8, &total);
            }
        }
        // Version and flags, as two bytes or as a word.
        20 => set(bytes, 4, &[draw.one(&[0, 1, 2, 255]), draw.one(&[0, 1, 2, 128])]),
        // One more or one less than it says, or as much more as wraps.
        21 | 22 if entry > 0 => {
            let field = entry + draw.one(&[0, 4, 8, 12]);
            let known =
                bytes.get(field..field + 4).and_then(|known| known.try_into().ok()).map_or(0, u32::from_le_bytes);
            let by = draw.one(&[1, u32::MAX, 2, 4, 8, 1 << 16, 1 << 24, 1 << 29, 1 << 30, 1 << 31]);
            let new = known.wrapping_add(by).to_le_bytes();
            set(bytes, field, if field == entry + 4 { &new[..2] } else { &new });
        }
        // An empty column, that begins anywhere.
        23 if entry > 0 => {
            set(bytes, entry + 8, &le32(0));
            set(bytes, entry + 12, &le32(draw.below(length + 2)));
        }
        15 | 16 if entry > 0 => {
            // A name or the data of a column begins within those of another, or of its own.
            let other = 12 + 16 * draw.below(columns);
            let (own, others) = (entry + draw.one(&[0, 0, 12]), other + draw.one(&[0, 12, 12]));
            let begins = bytes.get(others..others + 4).and_then(|begins| begins.try_into().ok());
            let begins = begins.map_or(0, u32::from_le_bytes) as usize;
            set(bytes, own, &le32(begins + draw.below(8)));
        }
        // A bit of the header or the directory: a count or an offset off by a power of two.
        12..=14 => {
            let place = draw.below((12 + 16 * columns).min(length));
            bytes[place] ^= 1 << draw.below(8);
        }
        0 => bytes.truncate(draw.below(length)),
        1 => bytes.push(0),
        2 => {
            let place = draw.below(12);
            let value = draw.next().to_le_bytes();
            set(bytes, place, &value[..1]);
        }
        3 if entry > 0 => set(bytes, entry, &le32(odd)),
        4 if entry > 0 => set(bytes, entry + 4, &le32(odd)[..2]),
        5 if entry > 0 => {
            let dtype = draw.one(&[0, 1, 2, 3, 4, 5, 255]);
            set(bytes, entry + 6, &[dtype]);
        }
        6 | 7 if entry > 0 => set(bytes, entry + 8, &le32(odd)),
        8 | 9 if entry > 0 => set(bytes, entry + 12, &le32(odd)),
        10 if columns > 1 => {
            // Two columns on the same bytes.
            let other = 12 + 16 * draw.below(columns);
            let from: Vec<u8> = bytes[other + 8..other + 16].to_vec();
            set(bytes, entry + 8, &from);
        }
        _ => {
            let place = draw.below(length);
            let value = draw.next().to_le_bytes();
            set(bytes, place, &value[..1]);
        }
    }
}

/// The arguments of `bulk.decode`.
pub(super) fn decode(draw: &mut Draw<'_>) -> Tree {
    let columns = columns(draw);
    let mut bytes = block(&columns, draw);
    if draw.chance(40) {
        broken(&mut bytes, columns.len(), draw);
    }
    object([("block", base64(&bytes))])
}

/// The arguments of `bulk.encode`.
pub(super) fn encode(draw: &mut Draw<'_>) -> Tree {
    let mut columns = columns(draw);
    if draw.chance(2) {
        columns.push(("n".repeat(draw.one(&[65_535, 65_536])), 1, 0));
    }
    let columns = columns.into_iter().map(|(name, dtype, rows)| {
        let data = (0..rows).map(|_| match dtype {
            1 => {
                #[expect(clippy::cast_possible_truncation, reason = "a double that is a single")]
                let single = draw.double() as f32;
                num(f64::from(single))
            }
            2 => num(draw.double()),
            #[expect(clippy::cast_possible_truncation, reason = "any bits will do")]
            3 => int(i64::from(draw.next() as u32 as i32)),
            _ => text(draw.next().cast_signed().to_string()),
        });
        let data = list(data.collect());
        let dtype = ["f32", "f64", "i32", "i64"][dtype - 1];
        object([("name", text(name)), ("dtype", text(dtype)), ("data", data)])
    });
    object([("columns", list(columns.collect()))])
}

/// The arguments of `observation.pack`.
pub(super) fn pack(draw: &mut Draw<'_>) -> Tree {
    let rows = if draw.chance(5) { draw.size(64, 70_000) } else { draw.size(0, 64) };
    let count = |draw: &mut Draw<'_>| match draw.below(8) {
        0 => 0,
        1 => rows + 1,
        _ => rows,
    };
    let (times, values, senders) = (count(draw), count(draw), count(draw));
    // Arrays of zeros alone are not empty.
    let (no_time, no_value, no_sender) = (draw.chance(10), draw.chance(10), draw.chance(10));
    let times: Vec<f64> = (0..times).map(|_| if no_time { 0.0 } else { draw.double() }).collect();
    let values: Vec<f64> = (0..values).map(|_| if no_value { 0.0 } else { draw.double() }).collect();
    let senders = (0..senders).map(|_| if no_sender { 0 } else { draw.integer() });
    let senders = senders.map(|sender| text(sender.to_string())).collect();
    object([("times", nums(&times)), ("values", nums(&values)), ("senders", list(senders))])
}

/// The arguments of `observation.unpack`.
pub(super) fn unpack(draw: &mut Draw<'_>) -> Tree {
    let rows = if draw.chance(6) { draw.size(64, 20_000) } else { draw.size(0, 64) };
    let mut columns: Vec<(String, usize, usize)> =
        [("times", 2), ("values", 2), ("senders", 4)].map(|(name, dtype)| (name.to_owned(), dtype, rows)).into();
    if draw.chance(30) {
        columns.rotate_left(1);
    }
    if draw.chance(30) {
        columns.remove(draw.below(3));
    }
    if draw.chance(30) {
        let other = draw.below(columns.len());
        columns[other].2 = draw.one(&[0, 0, rows + 1]);
    }
    if draw.chance(15) {
        // A name that is nearly one of the three, which a column of it may even have.
        let (one, alike) = (draw.below(columns.len()), draw.chance(70));
        columns[one].0 = if alike { unlike(&columns[one].0, draw) } else { draw.string() };
    }
    if draw.chance(25) {
        // What nobody looks for, which a decoder reads all the same.
        columns.push((draw.pick(&["more", "x", "weights"]).to_owned(), draw.one(&[2, 4]), rows));
    }
    let mut bytes = block(&columns, draw);
    if draw.chance(30) {
        broken(&mut bytes, columns.len(), draw);
    }
    object([("block", base64(&bytes))])
}

/// Another name than this one, of the same length and beginning, of the same letters, or nearly the same.
fn unlike(name: &str, draw: &mut Draw<'_>) -> String {
    let mut letters: Vec<char> = name.chars().collect();
    match draw.below(4) {
        0 => draw.nearly(name),
        1 => {
            let end = letters.len().saturating_sub(1);
            letters.swap(0, end);
            letters.into_iter().collect()
        }
        2 => {
            let kept = 1 + draw.below(letters.len().max(2) - 1);
            letters.into_iter().enumerate().map(|(nth, c)| if nth < kept { c } else { 'x' }).collect()
        }
        _ => {
            let kept = draw.below(letters.len().max(1));
            letters.into_iter().enumerate().map(|(nth, c)| if nth >= kept { c } else { 'x' }).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;
    use ncp_spec::bulk::Block;

    #[test]
    fn a_name_that_is_unlike_another_keeps_its_length_its_ends_or_its_letters() {
        let harvest = Harvest::default();
        let drawn: std::collections::HashSet<String> =
            (0..300).map(|number| unlike("times", &mut Draw::new(3, number, &harvest))).collect();
        for name in ["txxxx", "simet", "xxxxs", "TIMES"] {
            assert!(drawn.contains(name), "{name}: {drawn:?}");
        }
    }

    #[test]
    fn a_block_that_is_drawn_as_valid_is_read_with_its_columns() {
        let harvest = Harvest::default();
        for number in 0..200 {
            let mut draw = Draw::new(3, number, &harvest);
            let columns = columns(&mut draw);
            let bytes = block(&columns, &mut draw);
            let read = Block::parse(&bytes).unwrap();
            assert_eq!(read.columns().count(), columns.len());
        }
    }
}
