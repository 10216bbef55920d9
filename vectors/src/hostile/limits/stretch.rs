//! Frames that are made long, wide or deep without writing out what repeats.

use crate::json::Json;
use crate::model::explicit_message;
use crate::template::Text;

/// Stands for an array or a string that is written as a template.
pub(super) const MARK: &str = "%ITEMS%";

/// The text with the mark replaced by an array of equal items.
pub(super) fn list(text: &str, item: &str, count: usize) -> Text {
    let (before, after) = text.split_once(MARK).unwrap_or((text, ""));
    Text::concat([
        format!("{before}[").into(),
        Text::repeat(format!("{item},"), count - 1),
        format!("{item}]{after}").into(),
    ])
}

/// The text with an object of so many members in the place of the mark.
pub(super) fn entries_of(text: &str, value: &str, count: usize) -> Text {
    let (before, after) = text.split_once(MARK).unwrap_or((text, ""));
    Text::concat([
        format!("{before}{{").into(),
        Text::count("\"k", &format!("\":{value},"), count - 1),
        format!("\"k\":{value}}}{after}").into(),
    ])
}

/// The frame with an unknown string of such a length that the whole has `total` bytes.
pub(super) fn padded(frame: &str, total: usize, unit: &str) -> Text {
    let open = frame.strip_suffix('}').unwrap_or(frame);
    let before = format!("{open},\"pad\":\"");
    let room = total - before.len() - 2;
    let rest = "x".repeat(room % unit.len());
    Text::concat([before.into(), Text::repeat(unit, room / unit.len()), format!("{rest}\"}}").into()])
}

/// The frame with an unknown string before everything else.
pub(super) fn padded_before(frame: &str, total: usize) -> Text {
    let rest = frame.strip_prefix('{').unwrap_or(frame);
    let (before, after) = ("{\"pad\":\"", format!("\",{rest}"));
    let room = total - before.len() - after.len();
    Text::concat([before.into(), Text::repeat("x", room), after.into()])
}

/// The frame with so much white space before its last brace that the whole has `total` bytes.
pub(super) fn spaced(frame: &str, total: usize) -> Text {
    let open = frame.strip_suffix('}').unwrap_or(frame);
    Text::concat([open.into(), Text::repeat(" ", total - frame.len()), "}".into()])
}

/// A side of the object.
#[derive(Clone, Copy)]
pub(super) enum Side {
    Before,
    After,
}

/// The frame with so much white space on one side of its object that the whole has `total` bytes.
pub(super) fn outside(frame: &str, total: usize, side: Side) -> Text {
    let space = |character: &str| Text::repeat(character, total - frame.len());
    match side {
        Side::Before => Text::concat([space(" "), frame.into()]),
        Side::After => Text::concat([frame.into(), space("\n")]),
    }
}

/// The frame with a value at a path; what the path needs is made.
pub(super) fn set(frame: Json, path: &[&str], value: Json) -> Json {
    let Some((name, rest)) = path.split_first() else {
        return value;
    };
    let inner = match frame.get(name) {
        Some(known) if !rest.is_empty() && !known.members().is_empty() => known.clone(),
        _ => ground(name, rest),
    };
    match rest {
        ["0", rest @ ..] => frame.with(name, Json::Array(vec![set(ground(name, rest), rest, value)])),
        rest => frame.with(name, set(inner, rest, value)),
    }
}

/// What stands in that member, apart from what is set in it by the path: its defaults written out.
pub(super) fn ground(name: &str, rest: &[&str]) -> Json {
    match (name, rest) {
        ("bindings", _) => explicit_message("EntityBinding"),
        ("targets", ["params", ..]) => explicit_message("StimulusTarget"),
        ("targets", [_, ..]) => explicit_message("RecordTarget"),
        ("a", ["times" | "values" | "senders"]) => explicit_message("Observation"),
        _ => Json::object(),
    }
}

/// A number in two digits, as long as it is less than 4,096.
pub(super) fn base_64(mut number: usize) -> String {
    const DIGITS: &[u8; 64] = b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-_";
    let mut digits = Vec::new();
    loop {
        digits.push(DIGITS.get(number % 64).copied().map_or('0', char::from));
        number /= 64;
        if number == 0 {
            return digits.into_iter().rev().collect();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::MIB;
    use super::*;
    use crate::model::minimal;

    #[test]
    fn a_padded_frame_has_the_bytes_that_it_should_have() {
        let frame = minimal("sensor_frame").text();
        for unit in ["x", "\u{e9}"] {
            assert_eq!(padded(&frame, MIB + 1, unit).expanded().len(), MIB + 1);
        }
        assert_eq!(padded_before(&frame, MIB).expanded().len(), MIB);
        assert_eq!(spaced(&frame, MIB).expanded().len(), MIB);
        for side in [Side::Before, Side::After] {
            let text = outside(&frame, MIB, side).expanded();
            assert_eq!((text.len(), text.trim()), (MIB, frame.as_str()));
        }
    }

    #[test]
    fn a_list_has_the_items_that_it_should_have() {
        assert_eq!(list("{\"a\":%ITEMS%}", "0", 3).expanded(), "{\"a\":[0,0,0]}");
    }

    #[test]
    fn a_value_is_set_wherever_the_path_leads() {
        let frame = set(minimal("command_frame"), &["horizon", "0", "a", "data"], Json::literal("7"));
        assert_eq!(frame.text(), r#"{"kind":"command_frame","horizon":[{"a":{"data":7}}]}"#);
        assert_eq!(set(Json::object(), &["a"], Json::Null).text(), r#"{"a":null}"#);
    }

    #[test]
    fn a_name_is_a_number_in_base_64() {
        assert_eq!([0, 63, 64, 4095, 4096].map(base_64), ["0", "_", "10", "__", "100"]);
    }
}
