//! The freedoms of blocks.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_peer_rust::Answer;

use super::{Outcome, Verdict, by_result, equal, fits_or_refused, reject, specification};
use crate::fuzz::tree::{Tree, double, items, list, members, object, own, string, text};
use crate::json::Json;
use crate::peer::Call;

/// What the text only advises of a block.
fn advice(call: Call, block: &[u8]) -> Option<&'static str> {
    let u16_at = |at: usize| Some(usize::from(u16::from_le_bytes(block.get(at..at + 2)?.try_into().ok()?)));
    let u32_at = |at: usize| usize::try_from(u32::from_le_bytes(block.get(at..at + 4)?.try_into().ok()?)).ok();
    let count = u16_at(6)?;
    let mut names: Vec<&[u8]> = Vec::new();
    let mut earliest = usize::MAX;
    let mut last_name = 0;
    for nth in 0..count {
        let at = 12 + 16 * nth;
        let (name, length, dtype) = (u32_at(at)?, u16_at(at + 4)?, *block.get(at + 6)?);
        let (pad, rows, data) = (*block.get(at + 7)?, u32_at(at + 8)?, u32_at(at + 12)?);
        if pad != 0 {
            return Some("a pad that is not 0, BULK-008");
        }
        if length == 0 {
            return Some("an empty name, BULK-027");
        }
        if rows == 0 && (data > block.len() || data < 12 + 16 * count) {
            return Some("where an empty region begins, BULK-014 and 028");
        }
        if rows == 0 && data < last_name {
            return Some("an empty column before a name, BULK-026");
        }
        let written = block.get(name..name.checked_add(length)?).unwrap_or_default();
        if !written.is_empty() && names.contains(&written) {
            return Some("two columns of one name, BULK-013");
        }
        let wanted = match written {
            b"times" | b"values" => 2,
            b"senders" => 4,
            _ => dtype,
        };
        if call == Call::ObservationUnpack && wanted != dtype {
            return Some("a column of another dtype, OBS-006");
        }
        if call == Call::ObservationUnpack && !matches!(written, b"times" | b"values" | b"senders") {
            return Some("a column of another name, OBS-007");
        }
        names.push(written);
        earliest = earliest.min(data);
        last_name = last_name.max(name + length);
    }
    (last_name > earliest).then_some("a name behind the beginning of the data, BULK-026")
}

pub(super) fn decode(call: Call, args: &Tree, result: Outcome<'_>) -> Verdict {
    let block = string(args, "block").and_then(|block| STANDARD.decode(block).ok()).unwrap_or_default();
    match (advice(call, &block), result) {
        (None, result) => by_result(result),
        // Who takes it takes it so.
        (Some(_), Ok(result)) => fits_or_refused(result.clone()),
        (Some(why), Err(_)) => Verdict::Open(why),
    }
}

pub(super) fn encode(args: &Tree, result: Outcome<'_>) -> Verdict {
    let mut names = std::collections::HashSet::new();
    if !items(args.get("columns")).iter().all(|column| names.insert(string(column, "name"))) {
        return Verdict::Open("two columns of one name, BULK-034");
    }
    #[expect(clippy::cast_possible_truncation, reason = "whether it loses anything is what is asked")]
    let is_single = |value: &Json<'_>| {
        double(Some(value)).is_none_or(|value| !value.is_finite() || f64::from(value as f32) == value)
    };
    let of_singles = items(args.get("columns")).iter().filter(|column| string(column, "dtype") == Some("f32"));
    if !of_singles.flat_map(|column| items(column.get("data"))).all(is_single) {
        return Verdict::Open("a value of an f32 column that is no single may be refused, or be rounded");
    }
    match (result, args.get("columns")) {
        (Err(code), _) => reject(code),
        (Ok(_), Some(columns)) => holds(list(items(Some(columns)).iter().map(column).collect())),
        (Ok(_), None) => holds(Json::Array(Vec::new())),
    }
}

pub(super) fn pack(result: Outcome<'_>) -> Verdict {
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    match specification(Call::BulkDecode, &result.to_string()) {
        Answer::Result(read) => match Json::parse(&read).ok().and_then(|read| read.get("columns").map(own)) {
            Some(columns) => holds(columns),
            None => equal(result.clone()),
        },
        _ => Verdict::Open("the specification does not read its own block"),
    }
}

/// A column without members that no call has.
fn column(asked: &Tree) -> Tree {
    let known = members(Some(asked)).iter().filter(|(name, _)| matches!(name.as_ref(), "name" | "dtype" | "data"));
    Json::Object(known.cloned().collect())
}

/// Any valid block of these columns.
fn holds(columns: Tree) -> Verdict {
    Verdict::Expect(object([("relation", text("columns")), ("columns", columns)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::Input;
    use crate::fuzz::oracle::expectation;

    #[test]
    fn who_takes_a_block_with_a_column_of_another_name_takes_that_column_for_none_of_the_three() {
        let columns = r#"{"columns":[{"name":"trace","dtype":"f64","data":[1.5]}]}"#;
        let Answer::Result(block) = specification(Call::BulkEncode, columns) else { panic!("it is encoded") };
        let (call, args) = (Call::ObservationUnpack, own(&Json::parse(&block).unwrap()));
        let Verdict::Expect(expect) = expectation(&Input { call, args }, &specification(call, &block), None) else {
            panic!("who takes it takes it in one way");
        };
        assert_eq!(expect.get("or_reject"), Some(&Json::Bool(true)));
        assert_eq!(items(expect.get("value").and_then(|value| value.get("times"))).len(), 0);
    }
}
