//! Values of every dtype, wherever they lie.

use super::build::{Block, Column, double_of, f32s, f64s, i32s, i64s, of_runs_shifted, of_zeros};
use super::{READERS, decode, many, read, read_if_at_all};
use crate::case::{Case, File};
use crate::json::{Json, object};

pub(super) fn file() -> File {
    let mut cases = extremes();
    cases.extend(bits());
    cases.extend(unaligned());
    cases.extend(layouts());
    cases.extend(names());
    cases.extend(empty());
    cases.extend(beside());
    cases.extend(long());
    File::new("bulk", "values", "The values of a BulkBlock: every dtype, every place, every order.", cases)
}

/// Columns with the values that a careless reader changes.
pub(super) fn extreme_columns() -> Vec<(&'static str, Column, &'static str)> {
    vec![
        ("f32-plain", f32s("v", [1.5, -2.25, 0.1]), "f32 values"),
        (
            "f32-extremes",
            f32s("v", [f32::MAX, f32::MIN, f32::MIN_POSITIVE, f32::from_bits(1), -f32::from_bits(1)]),
            "the extreme f32 values",
        ),
        (
            "f32-special",
            f32s("v", [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN]),
            "both f32 zeros, both infinities and a NaN",
        ),
        ("f64-plain", f64s("v", [1.5, -2.25, 0.1, 0.300_000_000_000_000_04]), "f64 values"),
        ("f64-extremes", f64s("v", [f64::MAX, f64::MIN, f64::MIN_POSITIVE, 5e-324, -5e-324]), "the extreme f64 values"),
        (
            "f64-special",
            f64s("v", [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN]),
            "both f64 zeros, both infinities and a NaN",
        ),
        (
            "f64-integers",
            f64s("v", [9_007_199_254_740_991.0, 9_007_199_254_740_992.0, 1e300]),
            "f64 values that are whole numbers",
        ),
        ("i32-plain", i32s("v", [0, 1, -1, 256, -256]), "i32 values"),
        ("i32-extremes", i32s("v", [i32::MAX, i32::MIN]), "the extreme i32 values"),
        ("i64-plain", i64s("v", [0, 1, -1, 1 << 32, -(1 << 32)]), "i64 values"),
        ("i64-extremes", i64s("v", [i64::MAX, i64::MIN]), "the extreme i64 values"),
        (
            "i64-beyond-doubles",
            i64s("v", [(1 << 53) - 1, 1 << 53, (1 << 53) + 1, -(1 << 53) - 1]),
            "i64 values around 2^53",
        ),
    ]
}

fn extremes() -> Vec<Case> {
    let columns = extreme_columns().into_iter();
    columns
        .map(|(what, column, says)| {
            read(what, &rules_of(what), &Block::new([column]))
                .title(format!("A column of {says} is read exactly."))
                .flags(&[if what.starts_with('i') { "narrow-integers" } else { "lossy-doubles" }])
                .because("Every value is given exactly, a NaN as a NaN, and both zeros apart.")
        })
        .collect()
}

/// The rule that a column of these values is about, and the other one.
fn rules_of(what: &str) -> [&'static str; 2] {
    // Those beyond doubles are about values that come back exactly, not about their bytes.
    let is_lossy = what == "i64-beyond-doubles";
    if !is_lossy && (what.starts_with('i') || what.ends_with("plain")) {
        ["NCP-BULK-022", "NCP-BULK-023"]
    } else {
        ["NCP-BULK-023", "NCP-BULK-022"]
    }
}

/// NaNs of other bits than the usual ones.
fn bits() -> Vec<Case> {
    let doubles = [0x7ff8_0000_0000_0000_u64, 0xfff8_0000_0000_0000, 0x7ff0_0000_0000_0001, 0x7fff_ffff_ffff_ffff];
    let singles = [0x7fc0_0000_u32, 0xffc0_0000, 0x7f80_0001, 0x7fff_ffff];
    let f64s = f64s("v", doubles.map(f64::from_bits));
    let f32s = f32s("v", [0.0; 4]);
    // The bits of a signalling f32 are written as they are, since moving one may change it.
    let f32s = Block::new([f32s]);
    let at = f32s.data.first().copied().unwrap_or_default();
    let bytes = f32s.patched(at, &singles.map(u32::to_le_bytes).concat());
    let nans: Json = ["NaN"; 4].into_iter().collect();
    let expected = |dtype: &str| {
        let column = object! { "name" => "v", "dtype" => dtype, "data" => nans.clone() };
        object! { "columns" => Json::Array(vec![column]) }
    };
    vec![
        decode("f64-nans", &["NCP-BULK-023"], &Block::new([f64s]).bytes())
            .gives(expected("f64"))
            .title("Quiet, negative and signalling f64 NaNs are read as NaNs.")
            .flags(&["lossy-doubles"])
            .because("A NaN is given as a NaN, whatever its bits."),
        decode("f32-nans", &["NCP-BULK-023"], &bytes)
            .gives(expected("f32"))
            .title("Quiet, negative and signalling f32 NaNs are read as NaNs.")
            .flags(&["lossy-doubles"])
            .because("A NaN is given as a NaN, whatever its bits."),
    ]
}

fn unaligned() -> Vec<Case> {
    let columns = [f32s("v", [1.5, -2.25]), f64s("v", [1.5, -2.25]), i32s("v", [1, -2]), i64s("v", [1, -2])];
    let mut cases = Vec::new();
    for column in columns {
        let dtype = column.values.dtype();
        let width = if dtype.ends_with("64") { 8 } else { 4 };
        for shift in 1..8 {
            if shift % width == 0 {
                continue;
            }
            let at = 32 + shift;
            let block = Block::new([column.clone()]).laid_out(&[28], &[at], at + 2 * width);
            cases.push(
                read(format!("unaligned/{dtype}-at-{at}"), &["NCP-BULK-018"], &block)
                    .title(format!("A column of {dtype} that begins at the offset {at} is read."))
                    .flags(&["alignment"])
                    .because("A column may begin at any offset."),
            );
        }
    }
    cases.extend(unaligned_extremes());
    // More than a reader may have set aside to move a column into.
    let (rows, byte) = (131_073, '1');
    let value = many(double_of(byte as u8), rows);
    let columns = Json::Array(vec![object! { "name" => "v", "dtype" => "f64", "data" => value }]);
    cases.push(
        Case::new("unaligned/longer-than-1-mib", &["NCP-BULK-018", "NCP-BULK-025"], READERS)
            .call("bulk.decode", object! { "block" => of_runs_shifted(&[("v", 2, rows, byte)], 1) })
            .gives(object! { "columns" => columns })
            .title(format!("A column of {rows} rows of f64 that begins at the offset 33 is read."))
            .flags(&["alignment"])
            .because("A column may begin at any offset, however long it is."),
    );
    cases
}

/// The values that a careless reader changes, where a careful one has to put the bytes together itself.
fn unaligned_extremes() -> Vec<Case> {
    let mut cases = Vec::new();
    for (what, column, says) in extreme_columns() {
        let dtype = column.values.dtype();
        let width = if dtype.ends_with("64") { 8 } else { 4 };
        for at in [33, 36] {
            if at % width == 0 || what.ends_with("plain") {
                continue;
            }
            let block = Block::new([column.clone()]);
            let data = block.len - block.data.first().copied().unwrap_or_default();
            let block = block.laid_out(&[28], &[at], at + data);
            cases.push(
                read(format!("unaligned/{what}-at-{at}"), &[&rules_of(what)[..], &["NCP-BULK-018"]].concat(), &block)
                    .title(format!("A column of {says} that begins at the offset {at} is read exactly."))
                    .flags(&["alignment"])
                    .because("A column may begin at any offset, and every value is given exactly.")
                    .rests_on(format!("bulk/values/{what}"))
                    .rests_on(format!("bulk/values/unaligned/{dtype}-at-{at}")),
            );
        }
    }
    cases
}

/// Gaps and orders.
fn layouts() -> Vec<Case> {
    let columns = || [f64s("a", [1.5]), i32s("b", [2]), f32s("c", [3.5])];
    let equals = || [f64s("a", [1.5, 2.5]), f64s("b", [3.5, 4.5]), f64s("c", [5.5, 6.5]), f64s("d", [7.5, 8.5])];
    let names = [60, 61, 62];
    let table: Vec<(&str, &'static str, Block, &str)> = vec![
        (
            "gap-before-names",
            "NCP-BULK-020",
            Block::new(columns()).laid_out(&[70, 71, 72], &[80, 88, 92], 96),
            "with a gap between directory and names",
        ),
        (
            "gap-between-names",
            "NCP-BULK-020",
            Block::new(columns()).laid_out(&[60, 64, 70], &[80, 88, 92], 96),
            "with gaps between the names",
        ),
        (
            "gap-before-data",
            "NCP-BULK-020",
            Block::new(columns()).laid_out(&names, &[128, 136, 140], 144),
            "with a gap before the data",
        ),
        (
            "gap-between-data",
            "NCP-BULK-020",
            Block::new(columns()).laid_out(&names, &[64, 80, 96], 100),
            "with gaps between the columns",
        ),
        (
            "gap-of-5000-before-names",
            "NCP-BULK-020",
            Block::new(columns()).laid_out(&[5060, 5061, 5062], &[5064, 5072, 5076], 5080),
            "with 5,000 bytes between directory and names",
        ),
        (
            "gap-of-70000-before-data",
            "NCP-BULK-020",
            Block::new(columns()).laid_out(&names, &[70_064, 70_072, 70_076], 70_080),
            "with 70,000 bytes between names and data",
        ),
        (
            "gap-of-5000-between-data",
            "NCP-BULK-020",
            Block::new(columns()).laid_out(&names, &[64, 72, 5_080], 5_084),
            "with 5,000 bytes before the last column",
        ),
        (
            "gap-between-equals",
            "NCP-BULK-020",
            Block::new(equals()).laid_out(&[76, 77, 78, 79], &[80, 96, 120, 136], 152),
            "whose equal columns lie at unequal distances",
        ),
        (
            "gap-of-7-between-equals",
            "NCP-BULK-020",
            Block::new(equals()).laid_out(&[76, 77, 78, 79], &[80, 96, 119, 135], 151),
            "with seven bytes between two pairs of equal columns",
        ),
        (
            "equals-in-reverse",
            "NCP-BULK-021",
            Block::new(equals()).laid_out(&[76, 77, 78, 79], &[128, 112, 96, 80], 144),
            "whose equal columns lie in reverse",
        ),
        (
            "equals-by-turns",
            "NCP-BULK-021",
            Block::new(equals()).laid_out(&[76, 77, 78, 79], &[96, 80, 128, 112], 144),
            "whose equal columns lie by turns",
        ),
        (
            "gap-of-ff",
            "NCP-BULK-020",
            Block::new(columns()).laid_out(&[61, 64, 70], &[72, 96, 120], 124).filled(0xff),
            "with gaps that are full of FF",
        ),
        (
            "data-in-reverse",
            "NCP-BULK-021",
            Block::new(columns()).laid_out(&names, &[72, 68, 64], 80),
            "whose data lies in reverse",
        ),
        (
            "names-in-reverse",
            "NCP-BULK-021",
            Block::new(columns()).laid_out(&[62, 61, 60], &[64, 72, 76], 80),
            "whose names lie in reverse",
        ),
    ];
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(what, rule, block, says)| {
            read(format!("layout/{what}"), &[rule], &block)
                .title(format!("A block {says} is read, in the order of the directory."))
                .flags(&["fixed-layout"])
                .because(
                    "A decoder goes by the directory: any offset, any order, and bytes between that belong to nothing.",
                )
        })
        .collect();
    let behind = [
        (
            "data-before-names",
            Block::new(columns()).laid_out(&[76, 77, 78], &[60, 68, 72], 79),
            "whose names lie behind the data",
        ),
        (
            "names-between-data",
            Block::new(columns()).laid_out(&[68, 73, 78], &[60, 69, 74], 79),
            "whose names lie between the columns",
        ),
    ];
    cases.extend(
        behind
            .into_iter()
            .map(|(what, block, says)| read_if_at_all(format!("layout/{what}"), &block, says).flags(&["fixed-layout"])),
    );
    let unsorted =
        Block::new([f64s("z", [1.5]), f64s("a", [2.5]), f64s("m", [3.5]), f64s("10", [4.5]), f64s("9", [5.5])]);
    cases.push(
        read("layout/unsorted-names", &["NCP-BULK-021"], &unsorted)
            .title("The columns of a block are given in the order of the directory, not of their names.")
            .flags(&["column-order"])
            .because("The directory gives the order."),
    );
    cases
}

fn names() -> Vec<Case> {
    let table = [
        ("latin", "caf\u{e9}", "is not in ASCII"),
        ("decomposed", "cafe\u{301}", "is not composed"),
        ("astral", "\u{1f9e0}", "is a character beyond the BMP"),
        ("slashes", "v/m.x", "holds a slash and a dot"),
        ("prototype", "__proto__", "is `__proto__`"),
        ("mark-first", "\u{feff}v", "begins with U+FEFF"),
    ];
    table
        .into_iter()
        .map(|(what, name, says)| {
            read(format!("name/{what}"), &["NCP-BULK-021", "NCP-BULK-010"], &Block::new([f64s(name, [1.5])]))
                .title(format!("A column whose name {says} is read under that name."))
                .flags(&["changed-segments"])
                .because("A name is well-formed UTF-8, and nothing more is asked of it.")
        })
        .collect()
}

fn empty() -> Vec<Case> {
    let columns = [f32s("v", []), f64s("v", []), i32s("v", []), i64s("v", [])];
    let mut cases: Vec<Case> = columns
        .into_iter()
        .map(|column| {
            let dtype = column.values.dtype();
            read(format!("empty/{dtype}"), &["NCP-BULK-019"], &Block::new([column]))
                .title(format!("A column of {dtype} without rows is read."))
                .flags(&["empty-blocks"])
                .because("A column may have no rows.")
        })
        .collect();
    let among = Block::new([f64s("a", [1.5]), f64s("b", []), f64s("c", [2.5])]);
    cases.push(
        read("empty/among-others", &["NCP-BULK-019"], &among)
            .title("A column without rows among others is read.")
            .flags(&["empty-blocks"])
            .because("A column may have no rows."),
    );
    cases
}

/// Columns of one dtype and of several lengths: what is read of one does not stand where another's values stood.
fn beside() -> [Case; 4] {
    let block = |column: fn(&str, &[i16]) -> Column| {
        let lengths = [("a", 5), ("b", 2), ("c", 4), ("d", 5), ("e", 1)];
        let of = |(name, length): (&str, i16)| {
            let first = 10 * length + i16::from(name.as_bytes().first().copied().unwrap_or_default());
            column(name, &(first..first + length).collect::<Vec<_>>())
        };
        Block::new(lengths.map(of))
    };
    let blocks: [(&str, Block); 4] = [
        (
            "f32",
            block(|name, values| f32s(name, values.iter().map(|value| f32::from(*value) + 0.5).collect::<Vec<_>>())),
        ),
        (
            "f64",
            block(|name, values| f64s(name, values.iter().map(|value| f64::from(*value) + 0.5).collect::<Vec<_>>())),
        ),
        ("i32", block(|name, values| i32s(name, values.iter().map(|value| i32::from(*value)).collect::<Vec<_>>()))),
        ("i64", block(|name, values| i64s(name, values.iter().map(|value| i64::from(*value)).collect::<Vec<_>>()))),
    ];
    blocks.map(|(dtype, block)| {
        read(format!("beside/{dtype}"), &["NCP-BULK-023", "NCP-BULK-021"], &block)
            .title(format!("Five columns of {dtype}, of 5, 2, 4, 5 and 1 rows, have each its own values."))
            .flags(&["column-order"])
            .because("A decoder gives every value exactly.")
    })
}

/// Columns of more rows than anything but the bytes of the block limits.
fn long() -> Vec<Case> {
    [("i32", 3, 262_145), ("f32", 1, 524_289), ("f64", 2, 262_145), ("i64", 4, 131_073)]
        .into_iter()
        .map(|(dtype, code, rows)| {
            let zero = if dtype == "i64" { "0".into() } else { Json::literal("0") };
            let column = object! { "name" => "v", "dtype" => dtype, "data" => many(zero, rows) };
            Case::new(format!("long/{dtype}"), &["NCP-BULK-025", "NCP-BULK-022"], READERS)
                .call("bulk.decode", object! { "block" => of_zeros(&[("v", code, rows)]) })
                .shows_exactly(object! { "columns" => Json::Array(vec![column]) })
                .by("/columns/0/data", "NCP-BULK-023")
                .title(format!("A block with a column of {rows} rows of {dtype} is read."))
                .flags(&["low-limits"])
                .because("A decoder accepts a block of up to 64 MiB; a column has no limit of its own.")
        })
        .collect()
}
