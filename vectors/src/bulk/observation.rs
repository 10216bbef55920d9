//! Observations packed in blocks, and taken out of them.

use super::build::{Block, Column, Part, Values, double_of, f32s, f64s, golden, i32s, i64s, of_runs, of_zeros};
use super::{READERS, columns_json, many};
use crate::case::Role::Server;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::template::Text;

/// With the blocks that are no blocks.
pub(super) fn file(broken: Vec<Case>) -> File {
    let mut cases = packed();
    cases.extend(not_packed());
    cases.extend(unpacked());
    cases.extend(laid_out());
    cases.extend(not_unpacked());
    cases.extend(broken);
    cases.extend(wrapped());
    cases.extend(long_in_any_order());
    File::new("bulk", "observation", "Observations packed in BulkBlocks, and taken out of them.", cases)
}

/// An observation: times, values, senders.
struct Samples {
    times: Vec<f64>,
    values: Vec<f64>,
    senders: Vec<i64>,
}

fn samples(times: &[f64], values: &[f64], senders: &[i64]) -> Samples {
    Samples { times: times.to_vec(), values: values.to_vec(), senders: senders.to_vec() }
}

impl Samples {
    fn json(&self) -> Json {
        object! {
            "times" => Values::F64(self.times.clone()).json(),
            "values" => Values::F64(self.values.clone()).json(),
            "senders" => Values::I64(self.senders.clone()).json(),
        }
    }

    /// The columns of the arrays that are not empty.
    fn columns(&self) -> Vec<Column> {
        let mut columns = Vec::new();
        if !self.times.is_empty() {
            columns.push(f64s("times", self.times.clone()));
        }
        if !self.values.is_empty() {
            columns.push(f64s("values", self.values.clone()));
        }
        if !self.senders.is_empty() {
            columns.push(i64s("senders", self.senders.clone()));
        }
        columns
    }
}

/// Observations that can be packed, and what is special about them.
fn fitting() -> Vec<(&'static str, Samples, &'static str)> {
    vec![
        ("all-three", samples(&[0.1, 0.2], &[-65.0, -64.5], &[7, 9]), "with all three arrays"),
        ("times-and-values", samples(&[0.1, 0.2], &[-65.0, -64.5], &[]), "without senders"),
        ("times-and-senders", samples(&[1.5, 2.5, 9.0], &[], &[7, 7, 9]), "without values"),
        ("times-alone", samples(&[1.5], &[], &[]), "with times alone"),
        ("values-alone", samples(&[], &[1.5, 2.5], &[]), "with values alone"),
        ("senders-alone", samples(&[], &[], &[1, 2]), "with senders alone"),
        (
            "special",
            samples(&[0.0, -0.0, 5e-324], &[f64::NAN, f64::INFINITY, f64::NEG_INFINITY], &[0, -1, 1]),
            "with zeros, a NaN and infinities",
        ),
        ("zeros-alone", samples(&[0.0, 0.0], &[0.0, 0.0], &[0, 0]), "of zeros alone"),
        (
            "large-senders-of-three",
            samples(&[0.1, 0.2, 0.3], &[-65.0, -64.5, -64.0], &[i64::MAX, i64::MIN, (1 << 53) + 1]),
            "with senders beyond 2^53 beside times and values",
        ),
        (
            "senders-around-two-to-53",
            samples(
                &[0.1, 0.2, 0.3, 0.4, 0.5, 0.6],
                &[1.5; 6],
                &[(1 << 53) - 1, 1 << 53, (1 << 53) + 1, -(1 << 53) - 1, (1 << 62) + 1, 1 - (1 << 62)],
            ),
            "with senders around 2^53 and 2^62",
        ),
        (
            "senders-beyond-32-bits",
            samples(
                &[0.1, 0.2, 0.3, 0.4, 0.5],
                &[1.5; 5],
                &[(1 << 24) + 1, (1 << 31) - 1, 1 << 31, (1 << 32) + 1, -(1 << 31) - 1],
            ),
            "with senders beyond 24, 31 and 32 bits",
        ),
        (
            "long-digits",
            samples(&[0.1 + 0.2, 1e300, 5e-324], &[-65.000_000_000_000_01, f64::MAX, -1.0 / 3.0], &[7, 8, 9]),
            "of numbers that need all their digits",
        ),
        ("large-senders", samples(&[], &[], &[i64::MAX, i64::MIN, (1 << 53) + 1]), "with senders beyond 2^53"),
    ]
}

fn packed() -> Vec<Case> {
    let mut cases = vec![
        pack("golden", &["NCP-BULK-035", "NCP-OBS-001"], &samples(&[1.5, 2.5, 9.0], &[], &[7, 7, 9]))
            .gives_bytes(&golden().bytes())
            .title("The times and senders of the golden block are packed as its 104 bytes.")
            .flags(&["byte-order"])
            .because("The text prints the bytes."),
    ];
    cases.push(
        pack("empty", &["NCP-OBS-002"], &samples(&[], &[], &[]))
            .gives_bytes(&Block::new([]).bytes())
            .title("An observation without samples is packed as the 12 bytes of a block without columns.")
            .flags(&["empty-blocks"])
            .because("An empty array has no column, and all three are empty."),
    );
    cases.extend(fitting().into_iter().map(|(what, samples, says)| {
        let has_empty = samples.columns().len() < 3;
        let rules: &[_] = if has_empty { &["NCP-OBS-001", "NCP-OBS-002"] } else { &["NCP-OBS-001"] };
        pack(what, rules, &samples)
            .gives_columns(columns_json(&samples.columns()))
            .title(format!("An observation {says} is packed as the columns of what is not empty."))
            .flags(&["lossy-blocks"])
            .because("Times, values and senders in this order, and no column for an empty array.")
    }));
    cases
}

/// Arrays that differ in length.
fn uneven() -> Vec<(&'static str, Samples, &'static str)> {
    vec![
        ("fewer-values", samples(&[0.1, 0.2], &[-65.0], &[7, 9]), "fewer values than times"),
        ("more-values", samples(&[0.1], &[-65.0, -64.5], &[]), "more values than times"),
        ("fewer-senders", samples(&[0.1, 0.2], &[], &[7]), "fewer senders than times"),
        ("more-senders", samples(&[0.1, 0.2], &[-65.0, -64.5], &[7, 9, 11]), "more senders than times and values"),
        ("values-and-senders", samples(&[], &[-65.0, -64.5], &[7]), "no times, and fewer senders than values"),
    ]
}

fn not_packed() -> Vec<Case> {
    let cases = uneven().into_iter().map(|(what, samples, says)| {
        pack(&format!("refused/{what}"), &["NCP-OBS-003"], &samples)
            .rejects("block")
            .title(format!("An observation with {says} is not packed."))
            .flags(&["uneven-arrays"])
            .because("The arrays that are not empty differ in length.")
    });
    cases.collect()
}

fn unpacked() -> Vec<Case> {
    let mut cases: Vec<Case> = fitting()
        .into_iter()
        .map(|(what, samples, says)| {
            let has_empty = samples.columns().len() < 3;
            let rules: &[_] = if has_empty { &["NCP-OBS-005"] } else { &["NCP-BULK-023"] };
            unpack(what, rules, &Block::new(samples.columns()).bytes())
                .gives(samples.json())
                .title(format!("The block of an observation {says} is unpacked as it was packed."))
                .flags(&["lossy-blocks"])
                .because("A column that is not there is an empty array, and every value is given exactly.")
        })
        .collect();
    let (times, values, senders) =
        (|| f64s("times", [0.1, 0.2]), || f64s("values", [-65.0, -64.5]), || i64s("senders", [7, 9]));
    let whole = samples(&[0.1, 0.2], &[-65.0, -64.5], &[7, 9]);
    let orders = [
        ("senders-first", [senders(), times(), values()]),
        ("reversed", [senders(), values(), times()]),
        ("values-first", [values(), times(), senders()]),
    ];
    cases.extend(orders.into_iter().map(|(what, columns)| {
        unpack(format!("order/{what}"), &["NCP-OBS-008"], &Block::new(columns).bytes())
            .gives(whole.json())
            .title("The columns of an observation may stand in any order.")
            .flags(&["fixed-layout"])
            .because("Columns are known by their names.")
    }));
    cases.push(
        unpack("no-columns", &["NCP-OBS-005"], &Block::new([]).bytes())
            .gives(samples(&[], &[], &[]).json())
            .title("A block without columns is unpacked as three empty arrays.")
            .flags(&["empty-blocks"])
            .because("A column that is not there is an empty array."),
    );
    let some_empty = Block::new([times(), f64s("values", []), senders()]);
    cases.push(
        unpack("empty-column", &["NCP-OBS-004", "NCP-BULK-019"], &some_empty.bytes())
            .gives(samples(&[0.1, 0.2], &[], &[7, 9]).json())
            .title("A block with a column without rows beside others that have some is unpacked.")
            .flags(&["empty-blocks"])
            .because("Only columns that are not empty have to agree in length."),
    );
    let more = Block::new([times(), f64s("weights", [1.0, 2.0, 3.0]), senders()]);
    cases.push(
        unpack("other-columns", &["NCP-OBS-007"], &more.bytes())
            .gives(samples(&[0.1, 0.2], &[], &[7, 9]).json())
            .title("A column of another name should be ignored, also when it is longer.")
            .flags(&["closed-objects"])
            .because("Only the three names mean anything here."),
    );
    // Names that begin or end as the three do, and are others: who takes such a block takes no column for another.
    for (what, alike) in [
        ("longer", "timestamps"),
        ("shorter", "time"),
        ("numbered", "times2"),
        ("spaced", "times "),
        ("capital", "Times"),
        ("end", "sometimes"),
        ("beginning", "time_ms"),
    ] {
        let block = Block::new([f64s(alike, [1.0, 2.0]), f64s("values", [-65.0, -64.5]), senders()]);
        cases.push(
            unpack(format!("alike/times/{what}"), &["NCP-OBS-005"], &block.bytes())
                .shows_or_refuses(samples(&[], &[-65.0, -64.5], &[7, 9]).json())
                .title(format!("A column named `{alike}` is not taken for the times."))
                .flags(&["lossy-blocks"])
                .because("A column that is not there is an empty array, and columns are known by their whole names."),
        );
    }
    let others = [
        ("values", "value"),
        ("senders", "sender_types"),
        // Of the same length, with the same ends, or of the same letters.
        ("times", "trace"),
        ("times", "tames"),
        ("times", "mites"),
        ("values", "vector"),
        ("values", "velues"),
        ("senders", "sources"),
        ("senders", "renders"),
    ];
    for (nth, (name, alike)) in others.into_iter().enumerate() {
        let columns = match name {
            "times" => [f64s(alike, [1.0, 2.0]), values(), senders()],
            "values" => [times(), f64s(alike, [1.0, 2.0]), senders()],
            _ => [times(), values(), i64s(alike, [1, 2])],
        };
        let given = match name {
            "times" => samples(&[], &[-65.0, -64.5], &[7, 9]),
            "values" => samples(&[0.1, 0.2], &[], &[7, 9]),
            _ => samples(&[0.1, 0.2], &[-65.0, -64.5], &[]),
        };
        cases.push(
            unpack(
                if nth < 2 { format!("alike/{name}") } else { format!("alike/{name}/{alike}") },
                &["NCP-OBS-005"],
                &Block::new(columns).bytes(),
            )
            .shows_or_refuses(given.json())
            .title(format!("A column named `{alike}` is not taken for the {name}."))
            .flags(&["lossy-blocks"])
            .because("A column that is not there is an empty array, and columns are known by their whole names."),
        );
    }
    // Names that some folding makes one of the three.
    for name in ["times", "values", "senders"] {
        for (what, alike) in [
            ("nul-behind", format!("{name}\0")),
            ("nul-before", format!("\0{name}")),
            ("space-before", format!(" {name}")),
            ("line-behind", format!("{name}\n")),
            ("mark-before", format!("\u{feff}{name}")),
            ("joiner-behind", format!("{name}\u{200d}")),
            ("accent-behind", format!("{name}\u{301}")),
            ("long-s", name.replace('s', "\u{17f}")),
            ("full-width", name.replace('e', "\u{ff45}")),
            ("in-a-path", format!("events/{name}")),
            ("with-a-unit", format!("{name}[ms]")),
            ("twice", format!("{name}{name}")),
        ] {
            let columns = match name {
                "times" => [f64s(&alike, [1.0, 2.0]), values(), senders()],
                "values" => [times(), f64s(&alike, [1.0, 2.0]), senders()],
                _ => [times(), values(), i64s(&alike, [1, 2])],
            };
            let given = match name {
                "times" => samples(&[], &[-65.0, -64.5], &[7, 9]),
                "values" => samples(&[0.1, 0.2], &[], &[7, 9]),
                _ => samples(&[0.1, 0.2], &[-65.0, -64.5], &[]),
            };
            cases.push(
                unpack(format!("alike/{name}/{what}"), &["NCP-OBS-005"], &Block::new(columns).bytes())
                    .shows_or_refuses(given.json())
                    .title(format!("A column named `{}` is not taken for the {name}.", alike.escape_debug()))
                    .flags(&["lossy-blocks"])
                    .because("A column that is not there is an empty array, and names are compared letter for letter."),
            );
        }
    }
    let capital = Block::new([times(), f64s("Values", [1.0, 2.0])]);
    cases.push(
        unpack("other-case", &["NCP-OBS-007"], &capital.bytes())
            .gives(samples(&[0.1, 0.2], &[], &[]).json())
            .title("A column named `Values` should be ignored.")
            .flags(&["case-folded-names"])
            .because("Names are compared by their letters."),
    );
    cases
}

/// Columns that lie elsewhere than an encoder puts them.
fn laid_out() -> Vec<Case> {
    let whole = samples(&[0.1, 0.2], &[-65.0, -64.5], &[7, 9]);
    #[expect(clippy::type_complexity, reason = "a table is read by its rows")]
    let table: [(&str, &'static str, &str, [usize; 3], [usize; 3], usize); 5] = [
        ("unaligned", "NCP-BULK-018", "begin right behind the names", [60, 65, 71], [78, 94, 110], 126),
        ("odd", "NCP-BULK-018", "begin at odd places", [60, 65, 71], [79, 95, 111], 127),
        (
            "data-reversed",
            "NCP-BULK-021",
            "lie in the other order than the directory's",
            [60, 65, 71],
            [112, 96, 80],
            128,
        ),
        ("names-reversed", "NCP-BULK-021", "have their names in the other order", [73, 67, 60], [80, 96, 112], 128),
        ("gaps", "NCP-BULK-020", "have bytes of no meaning between them", [64, 72, 80], [96, 120, 144], 168),
    ];
    let one = |(what, rule, says, names, data, len): (&str, &'static str, &str, [usize; 3], [usize; 3], usize)| {
        let block = Block::new(whole.columns()).laid_out(&names, &data, len).filled(0xff);
        unpack(format!("laid-out/{what}"), &[rule], &block.bytes())
            .gives(whole.json())
            .title(format!("A block whose columns {says} is unpacked."))
            .flags(&["fixed-layout"])
            .because("Unpacking decodes first: what a decoder has to accept, it accepts.")
    };
    table.into_iter().map(one).collect()
}

/// Lengths that are equal in 8 or in 16 bits.
fn wrapped() -> Vec<Case> {
    let table: [(&str, [usize; 3], &str); 8] = [
        ("257-and-1", [257, 1, 0], "257 times and one value"),
        ("3-and-259", [3, 0, 259], "3 times and 259 senders"),
        ("512-and-256", [0, 512, 256], "512 values and 256 senders"),
        ("1-1-and-257", [1, 1, 257], "one time and one value, and 257 senders"),
        ("65537-and-1", [65_537, 1, 0], "65,537 times and one value"),
        ("2-and-65538", [2, 0, 65_538], "2 times and 65,538 senders"),
        ("131073-and-1", [0, 131_073, 1], "131,073 values and one sender"),
        ("65537-and-257", [65_537, 257, 257], "65,537 times, 257 values and as many senders"),
    ];
    let zeros = |zero: &str, count: usize| (0..count).map(|_| Json::read(zero)).collect::<Json>();
    let mut cases = Vec::new();
    for (what, [times, values, senders], says) in table {
        // No template can stand for an array.
        if times.max(values).max(senders) < 1000 {
            let arrays = object! { "times" => zeros("0", times), "values" => zeros("0", values),
            "senders" => zeros("\"0\"", senders) };
            cases.push(
                Case::new(format!("pack/refused/{what}"), &["NCP-OBS-003"], &[Server])
                    .call("observation.pack", arrays)
                    .rejects("block")
                    .title(format!("An observation with {says} is not packed."))
                    .flags(&["uneven-arrays", "truncated-counts"])
                    .because("The arrays that are not empty differ in length, though not in their lowest bits."),
            );
        }
        let block = of_zeros(&[("times", 2, times), ("values", 2, values), ("senders", 4, senders)]);
        cases.push(
            Case::new(format!("unpack/refused/{what}"), &["NCP-OBS-004"], READERS)
                .call("observation.unpack", object! { "block" => block })
                .rejects("block")
                .title(format!("A block with {says} is not unpacked."))
                .flags(&["uneven-arrays", "truncated-counts"])
                .because("The columns that are not empty differ in length, though not in their lowest bits."),
        );
    }
    // Of many rows, the times alone, which a block has room for anyway.
    let rows = 524_289;
    cases.push(
        Case::new("unpack/many/times-alone", &["NCP-BULK-025", "NCP-OBS-005"], READERS)
            .call("observation.unpack", object! { "block" => of_zeros(&[("times", 2, rows)]) })
            .accepts()
            .title(format!("A block with {rows} times alone is unpacked."))
            .flags(&["low-limits"])
            .because("A decoder accepts a block of up to 64 MiB; a column has no limit of its own."),
    );
    let arrays = object! { "times" => many(Json::literal("0"), 262_145), "values" => Json::Array(Vec::new()),
    "senders" => Json::Array(Vec::new()) };
    let times = object! { "name" => "times", "dtype" => "f64", "data" => many(Json::literal("0"), 262_145) };
    cases.push(
        Case::new("pack/many-times", &["NCP-OBS-001", "NCP-BULK-030"], &[Server])
            .call("observation.pack", arrays)
            .gives_columns(Json::Array(vec![times]))
            .title("An observation of 262,145 times is packed.")
            .flags(&["low-limits"])
            .because("A block may have 64 MiB; a column has no limit of its own."),
    );
    // Times and values that are equal byte for byte, and so are senders of zeros.
    let zeros = |dtype: &str| many(if dtype == "i64" { Json::string("0") } else { Json::literal("0") }, 3_000);
    let column = |name: &str, dtype: &str| object! { "name" => name, "dtype" => dtype, "data" => zeros(dtype) };
    let arrays = object! { "times" => zeros("f64"), "values" => zeros("f64"), "senders" => zeros("i64") };
    cases.push(
        Case::new("pack/many-alike", &["NCP-OBS-001", "NCP-BULK-030"], &[Server])
            .call("observation.pack", arrays)
            .gives_columns(Json::Array(vec![column("times", "f64"), column("values", "f64"), column("senders", "i64")]))
            .title("An observation of 3,000 times, values and senders that are all 0 is packed as three columns.")
            .flags(&["low-limits"])
            .because("Each array that is not empty has a column, and no two regions may share a byte.")
            .rests_on("bulk/encode/round-trip/long/equal-columns"),
    );
    for rows in [257, 65_537] {
        let block = of_zeros(&[("times", 2, rows), ("values", 2, rows), ("senders", 4, rows)]);
        cases.push(
            Case::new(format!("unpack/many/{rows}-rows"), &["NCP-OBS-004", "NCP-BULK-025"], READERS)
                .call("observation.unpack", object! { "block" => block })
                .accepts()
                .title(format!("A block with three columns of {rows} rows each is unpacked."))
                .flags(&["low-limits"])
                .because("The columns agree in length, and the block is far below its limit."),
        );
    }
    cases
}

/// Long columns that are told apart by their names alone.
fn long_in_any_order() -> Vec<Case> {
    // A column is all of one byte, so that its values are all equal.
    let integer = |byte: u8| Json::string(u64::from_ne_bytes([byte; 8]).to_string());
    let table = [
        ("values-first", ["values", "times", "senders"]),
        ("senders-first", ["senders", "times", "values"]),
        ("senders-between", ["values", "senders", "times"]),
        ("reversed", ["senders", "values", "times"]),
        ("values-behind-another", ["weights", "values", "times"]),
    ];
    let case = |(what, order): (&str, [&'static str; 3])| {
        // So that every offset is written in bytes below 128.
        let rows = 8_192;
        let byte = |name: &str| match name {
            "times" => '0',
            "values" => '1',
            "senders" => '2',
            _ => '3',
        };
        let dtype = |name: &str| if name == "senders" { 4 } else { 2 };
        let block = of_runs(&order.map(|name| (name, dtype(name), rows, byte(name))));
        let given = |name: &str, item: Json| match order.contains(&name) {
            true => many(item, rows),
            false => Json::Array(Vec::new()),
        };
        let arrays = object! {
            "times" => given("times", double_of(b'0')),
            "values" => given("values", double_of(b'1')),
            "senders" => given("senders", integer(b'2')),
        };
        Case::new(format!("unpack/order/long/{what}"), &["NCP-OBS-008"], READERS)
            .call("observation.unpack", object! { "block" => block })
            .gives(arrays)
            .title(format!("Columns of {rows} rows may stand in any order ({}).", order.join(", ")))
            .flags(&["fixed-layout"])
            .because("Columns are known by their names, however long they are.")
    };
    table.map(case).into()
}

fn not_unpacked() -> Vec<Case> {
    let mut cases: Vec<Case> = uneven()
        .into_iter()
        .map(|(what, samples, says)| {
            unpack(format!("refused/{what}"), &["NCP-OBS-004"], &Block::new(samples.columns()).bytes())
                .rejects("block")
                .title(format!("A block with {says} is not unpacked."))
                .flags(&["uneven-arrays"])
                .because("The columns that are not empty differ in length.")
        })
        .collect();
    // One column without rows, at each place among the three, and two that differ.
    for places in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        for (empty, rows) in [[0, 1, 2], [1, 0, 2], [2, 1, 0]].into_iter().enumerate() {
            let column = |which: usize| match which {
                0 => f64s("times", vec![0.5; rows[0]]),
                1 => f64s("values", vec![-65.0; rows[1]]),
                _ => i64s("senders", vec![7; rows[2]]),
            };
            let names = ["times", "values", "senders"];
            let (empty, order) = (names[empty], places.map(|place| names[place]));
            let block = Block::new(places.map(column));
            cases.push(
                unpack(format!("refused/beside-no-{empty}/{}", order.join("-")), &["NCP-OBS-004"], &block.bytes())
                    .rejects("block")
                    .title(format!(
                        "A block of `{}`, `{}` and `{}` is not unpacked where there are no rows of `{empty}` and the \
                         others differ in length.",
                        order[0], order[1], order[2]
                    ))
                    .flags(&["uneven-arrays"])
                    .because(
                        "The columns that are not empty differ in length, whichever is empty and whichever is first.",
                    ),
            );
        }
    }
    let dtypes = [
        ("times-f32", vec![f32s("times", [0.5]), i64s("senders", [7])], "`times` of f32"),
        ("values-i64", vec![f64s("times", [0.5]), i64s("values", [7])], "`values` of i64"),
        ("senders-i32", vec![f64s("times", [0.5]), i32s("senders", [7])], "`senders` of i32"),
        ("senders-f64", vec![f64s("times", [0.5]), f64s("senders", [7.0])], "`senders` of f64"),
    ];
    cases.extend(dtypes.into_iter().map(|(what, columns, says)| {
        unpack(format!("refused/{what}"), &["NCP-OBS-006"], &Block::new(columns).bytes())
            .rejects("block")
            .title(format!("A block with {says} should not be unpacked."))
            .flags(&["unchecked-dtypes"])
            .because("The three columns are packed as f64, f64 and i64.")
    }));
    let golden = golden();
    let alone = Block::new([f64s("times", [0.1])]);
    let broken = [
        ("magic", golden.patched(0, b"ncpb"), "NCP-BULK-002", "with another magic"),
        ("total-len", golden.patched(8, &[105]), "NCP-BULK-005", "whose total_len is one too many"),
        ("overlap", golden.entry(1, Part::DataOff, 0x38), "NCP-BULK-012", "whose columns share their bytes"),
        ("rows", alone.entry(0, Part::Rows, 2), "NCP-BULK-011", "whose only column reaches beyond the end"),
    ];
    // Names from 60 on, data from 80, 96 and 112 on: each region begins behind the one before it, and within it.
    let three = Block::new([f64s("times", [0.5, 1.5]), f64s("values", [2.5, 3.5]), i64s("senders", [7, 8])]);
    let at = |names: [usize; 3], data: [usize; 3]| three.clone().laid_out(&names, &data, 128).bytes();
    let overlaps = [
        ("data-of-values", at([60, 65, 71], [80, 95, 112]), "the data of `times` and of `values`"),
        ("row-of-values", at([60, 65, 71], [80, 88, 112]), "a row of `times` and one of `values`"),
        ("data-of-senders", at([60, 65, 71], [80, 96, 111]), "the data of `values` and of `senders`"),
        ("row-of-senders", at([60, 65, 71], [80, 96, 104]), "a row of `values` and one of `senders`"),
        ("data-and-name", at([60, 65, 71], [77, 96, 112]), "the name `senders` and the data of `times`"),
    ];
    cases.extend(overlaps.into_iter().map(|(what, bytes, says)| {
        unpack(format!("refused/overlap/{what}"), &["NCP-BULK-012"], &bytes)
            .rejects("block")
            .title(format!("A block of the usual three columns in which {says} share bytes is not unpacked."))
            .flags(&["L01", "overlapping-regions"])
            .because("What is no block holds no observation.")
    }));
    cases.extend(broken.into_iter().map(|(what, bytes, rule, says)| {
        unpack(format!("refused/{what}"), &[rule], &bytes)
            .rejects("block")
            .title(format!("A block {says} is not unpacked."))
            .flags(&["unchecked-header"])
            .because("What is no block holds no observation.")
    }));
    cases
}

fn pack(what: &str, rules: &[&'static str], samples: &Samples) -> Case {
    Case::new(format!("pack/{what}"), rules, &[Server]).call("observation.pack", samples.json())
}

fn unpack(what: impl Into<String>, rules: &[&'static str], bytes: &[u8]) -> Case {
    Case::new(format!("unpack/{}", what.into()), rules, READERS)
        .call("observation.unpack", object! { "block" => Text::base64_of(bytes) })
}
