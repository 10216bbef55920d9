//! Equal blocks, by bytes and by columns.

use ncp_spec::bulk::{Block, ColumnView, Dtype};

use super::compare::{Relation, compare};
use super::{Difference, Differences};
use crate::json::{Json, write_string};

/// How many bytes around a difference are shown.
const AROUND: usize = 8;

/// Compares blocks byte by byte.
pub(super) fn same_bytes(expected: &[u8], got: &[u8], differences: &mut Differences) {
    if expected == got {
        return;
    }
    let at = expected.iter().zip(got).position(|(a, b)| a != b).unwrap_or_else(|| expected.len().min(got.len()));
    let window = |bytes: &[u8]| {
        let shown: Vec<String> = bytes.iter().skip(at).take(AROUND).map(|byte| format!("{byte:02x}")).collect();
        if shown.is_empty() {
            format!("the end of {} bytes", bytes.len())
        } else {
            format!("{} of {} bytes", shown.join(" "), bytes.len())
        }
    };
    differences.push(Difference {
        at: "/block".to_owned(),
        expected: Some(window(expected)),
        got: Some(window(got)),
        hint: Some(format!("from byte {at:#04x} on")),
    });
}

/// Reads a block by the spec and compares its columns with the expected ones, in the form that `bulk.decode` answers.
pub(super) fn same_columns(expected: &str, got: &[u8], differences: &mut Differences) {
    // [NCP-BULK-030]
    let block = match Block::parse(got) {
        Ok(block) => block,
        Err(error) => {
            return differences.push(Difference {
                at: "/block".to_owned(),
                expected: Some("a valid block".to_owned()),
                got: Some(super::excerpt(&hex(got), super::SHOWN)),
                hint: Some(error.to_string()),
            });
        }
    };
    let text = as_json(&block);
    // The suite was read before, and we have just written the other.
    if let (Ok(expected), Ok(got)) = (Json::parse(expected), Json::parse(&text)) {
        compare(Relation::Values, &expected, &got).iter().for_each(|found| found.note(differences));
    }
}

/// The columns as `bulk.decode` answers them.
fn as_json(block: &Block<'_>) -> String {
    let mut out = String::from("[");
    for (i, column) in block.columns().enumerate() {
        if i > 0 {
            out.push(',');
        }
        out.push_str("{\"name\":");
        write_string(column.name(), &mut out);
        out.push_str(&format!(",\"dtype\":\"{}\",\"data\":[", column.dtype().as_str()));
        out.push_str(&data(&column).join(","));
        out.push_str("]}");
    }
    out.push(']');
    out
}

fn data(column: &ColumnView<'_>) -> Vec<String> {
    match column.dtype() {
        Dtype::F32 => column.iter::<f32>().map(|values| values.map(|v| double(v.into())).collect()),
        Dtype::F64 => column.iter::<f64>().map(|values| values.map(double).collect()),
        Dtype::I32 => column.iter::<i32>().map(|values| values.map(|v| v.to_string()).collect()),
        Dtype::I64 => column.iter::<i64>().map(|values| values.map(|v| format!("\"{v}\"")).collect()),
    }
    .unwrap_or_default()
}

/// A double as PROTOCOL.md, section 2, spells it.
fn double(value: f64) -> String {
    if value.is_nan() {
        "\"NaN\"".to_owned()
    } else if value.is_infinite() {
        format!("\"{}Infinity\"", if value < 0.0 { "-" } else { "" })
    } else {
        format!("{value:e}")
    }
}

fn hex(bytes: &[u8]) -> Vec<u8> {
    bytes.iter().take(64).flat_map(|byte| format!("{byte:02x}").into_bytes()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ncp_spec::bulk::{ColumnRef, encode};

    const EXPECTED: &str = r#"[{"name":"times","dtype":"f64","data":[1.5,"-0","NaN"]},
        {"name":"senders","dtype":"i64","data":["7","-9223372036854775808"]},
        {"name":"x","dtype":"f32","data":[0.10000000149011612]},{"name":"n","dtype":"i32","data":[-1]}]"#;

    fn block() -> Vec<u8> {
        encode(&[
            ColumnRef::new("times", &[1.5, -0.0, f64::NAN][..]),
            ColumnRef::new("senders", &[7, i64::MIN][..]),
            ColumnRef::new("x", &[0.1_f32][..]),
            ColumnRef::new("n", &[-1_i32][..]),
        ])
        .unwrap()
    }

    fn differ(check: impl FnOnce(&mut Differences)) -> Vec<String> {
        let mut differences = Differences::default();
        check(&mut differences);
        differences.first.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_block_with_the_expected_columns_passes() {
        assert_eq!(differ(|d| same_columns(EXPECTED, &block(), d)), Vec::<String>::new());
    }

    #[test]
    fn a_value_a_name_and_a_dtype_that_differ_are_named_by_path() {
        let changed = EXPECTED.replace("1.5", "1.25").replace("\"x\"", "\"y\"").replace("\"i32\"", "\"i64\"");
        assert_eq!(
            differ(|d| same_columns(&changed, &block(), d)),
            [
                "/0/data/0: expected 1.25, got 1.5e0",
                "/2/name: expected \"y\", got \"x\"",
                "/3/dtype: expected \"i64\", got \"i32\"",
            ]
        );
        assert_eq!(
            differ(|d| same_columns(&EXPECTED.replace("\"-0\"", "0"), &block(), d)),
            ["/0/data/1: expected 0, got -0e0"]
        );
    }

    #[test]
    fn a_block_that_the_spec_rejects_fails_and_says_why() {
        let mut broken = block();
        broken[0] = b'X';
        let differences = differ(|d| same_columns(EXPECTED, &broken, d));
        assert_eq!(differences.len(), 1);
        assert!(differences[0].starts_with("/block: expected a valid block, got 58435042"), "{}", differences[0]);
    }

    #[test]
    fn bytes_differ_from_the_first_one_that_does() {
        assert!(differ(|d| same_bytes(b"abc", b"abc", d)).is_empty());
        assert_eq!(
            differ(|d| same_bytes(b"abc", b"abd!", d)),
            ["/block: expected 63 of 3 bytes, got 64 21 of 4 bytes (from byte 0x02 on)"]
        );
        assert_eq!(
            differ(|d| same_bytes(b"abc", b"ab", d)),
            ["/block: expected 63 of 3 bytes, got the end of 2 bytes (from byte 0x02 on)"]
        );
    }
}
