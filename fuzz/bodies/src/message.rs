//! What a program does with a message that it holds: it looks into maps and changes them, and learns
//! why a message that was spoilt is not sent.

use std::collections::BTreeMap;
use std::fmt::Debug;

use ncp_spec::ErrorCode;
use ncp_spec::wire::{
    ChannelKind, EncodeError, EntityRole, Kind, MAX_ENTRIES, MAX_ITEMS, Message, Mode, NetworkRefKind, Observable,
    Role, SimMode, SortedMap, StimulusKind, build,
};
use serde_json::Value;

/// So many leaves of a message are spoilt, and so many names of a map are changed, one at a time.
const LEAVES: usize = 6;
const NAMES: usize = 48;

/// A message in which one leaf is spoilt is shown as it is and not sent, and the error names that
/// leaf and the reason.
pub(crate) fn refuses_what_is_spoilt(message: &Message) {
    let kind = message.kind();
    let fields: Value = serde_json::from_str(&message.fields()).expect("what a program sees is JSON");
    let leaves = {
        let mut count = usize::MAX;
        spoil(kind, &mut fields.clone(), "", &mut count);
        usize::MAX - count
    };
    for nth in (0..leaves).step_by(leaves.div_ceil(LEAVES).max(1)) {
        let mut spoilt = fields.clone();
        let (path, code) = spoil(kind, &mut spoilt, "", &mut nth.clone()).expect("it was counted");
        let held = build(kind, spoilt.to_string().as_bytes()).expect("a program may hold it");
        let shown: Value = serde_json::from_str(&held.fields()).expect("it is JSON");
        assert_eq!(shown, spoilt);
        let encoded = held.encode().map(|text| text.len());
        let error = encoded.expect_err("what is spoilt is not sent");
        assert_eq!(error.code(), code, "{error}");
        // Points aside: an empty name has none on either side of it.
        assert_eq!(error.path().replace('.', ""), path.replace('.', ""));
        tells(&error);
    }
}

/// A map or an array that is as full as it may be takes no more.
pub(crate) fn refuses_one_too_many(message: &Message) {
    let mut grown = message.clone();
    let path = match &mut grown {
        Message::SensorFrame(frame) if frame.channels.len() == MAX_ENTRIES => {
            let name = frame.channels.keys().collect::<String>();
            frame.channels.insert(name, Default::default());
            "channels"
        }
        Message::CommandFrame(frame) if frame.horizon.len() == MAX_ITEMS => {
            frame.horizon.push(Default::default());
            "horizon"
        }
        Message::Capabilities(capabilities) if capabilities.sensor_channels.len() == MAX_ITEMS => {
            capabilities.sensor_channels.push(Default::default());
            "sensor_channels"
        }
        _ => return,
    };
    let encoded = grown.encode().map(|text| text.len());
    let error = encoded.expect_err("no receiver would take it");
    assert_eq!((error.code(), error.path()), (ErrorCode::Limit, path));
    tells(&error);
}

/// An error says in one text where and what, and shows no less to whoever debugs.
pub(crate) fn tells(error: &EncodeError) {
    let (text, problem) = (error.to_string(), error.problem().to_string());
    assert!(text.starts_with(error.path()) && text.ends_with(&problem));
    assert!(!problem.is_empty() && error.code() == error.problem().code());
    assert!(format!("{error:?}").contains(&format!("{:?}", error.problem())));
}

/// The maps of a message behave as a tree of the standard library does.
pub(crate) fn has_maps_like_trees(message: &Message) {
    match message {
        Message::OpenSession(open) => {
            like_a_tree(&open.network.params);
            like_a_tree(&open.network.population_sizes);
        }
        Message::SessionOpened(opened) => like_a_tree(&opened.resolved),
        Message::StimulusFrame(frame) => like_a_tree(&frame.values),
        Message::ObservationFrame(frame) => like_a_tree(&frame.records),
        Message::SensorFrame(frame) => like_a_tree(&frame.channels),
        Message::CommandFrame(frame) => {
            like_a_tree(&frame.channels);
            frame.horizon.first().into_iter().for_each(like_a_tree);
        }
        _ => {}
    }
}

/// A word is a value of an enum if that value is written as this word, and no other is.
pub(crate) fn is_a_word_of_no_other_value(word: &str) {
    macro_rules! judge {
        ($($name:ident)*) => {$(
            let read = $name::from_wire(word);
            assert_eq!(read.to_string(), word);
            let known = $name::KNOWN.iter().find(|value| value.to_string() == word);
            assert_eq!($name::parse(word).as_ref(), known);
            assert_eq!(known.is_none(), matches!(read, $name::Unknown(_)));
        )*};
    }
    judge!(Observable StimulusKind NetworkRefKind EntityRole ChannelKind Role);
    let modes = Mode::KNOWN.iter().find(|mode| mode.to_string() == word);
    assert_eq!(Mode::parse(word).as_ref(), modes);
    let modes = SimMode::KNOWN.iter().find(|mode| mode.to_string() == word);
    assert_eq!(SimMode::parse(word).as_ref(), modes);
}

/// Spoils the `nth` leaf with which something can be wrong: where it is, and the reason for which
/// nobody may send it now. Counts `nth` down on its way.
fn spoil(kind: Kind, value: &mut Value, path: &str, nth: &mut usize) -> Option<(String, ErrorCode)> {
    match value {
        Value::Object(members) => members.iter_mut().find_map(|(name, value)| {
            let name: String = name.chars().take(64).collect();
            let path = if path.is_empty() { name } else { format!("{path}.{name}") };
            spoil(kind, value, &path, nth)
        }),
        Value::Array(items) => {
            items.iter_mut().enumerate().find_map(|(at, value)| spoil(kind, value, &format!("{path}[{at}]"), nth))
        }
        leaf => {
            let (spoilt, code) = spoilt(kind, leaf, path)?;
            if *nth > 0 {
                *nth -= 1;
                return None;
            }
            *leaf = spoilt;
            Some((path.to_owned(), code))
        }
    }
}

/// What a leaf must not be.
fn spoilt(kind: Kind, leaf: &Value, path: &str) -> Option<(Value, ErrorCode)> {
    let mut fields = kind.table().fields.iter();
    match (leaf, path) {
        (Value::Number(number), _) if number.is_f64() => {
            let unsendable = ["NaN", "Infinity", "-Infinity"][path.len() % 3];
            Some((unsendable.into(), ErrorCode::NonFinite))
        }
        (Value::Number(_), _) => Some((i64::MAX.into(), ErrorCode::Value)),
        (Value::String(_), "session_id") if fields.any(|field| field.name == "session_id" && field.required) => {
            Some(("".into(), ErrorCode::Value))
        }
        (Value::String(of_request), "stimulus.session_id" | "stimulus.ncp_version") => {
            Some((format!("{of_request}x").into(), ErrorCode::Value))
        }
        (
            Value::Bool(pinned),
            "calibrated_posterior"
            | "is_simulation_output"
            | "provenance.calibrated_posterior"
            | "provenance.is_simulation_output",
        ) => Some(((!pinned).into(), ErrorCode::Provenance)),
        _ => None,
    }
}

/// Names are looked up, taken out, put in and changed in both alike.
fn like_a_tree<V: Clone + Debug + Default + PartialEq>(map: &SortedMap<V>) {
    let mut tree: BTreeMap<String, V> = map.iter().map(|(name, value)| (name.to_owned(), value.clone())).collect();
    assert_eq!(map.len(), tree.len());
    let mut map = map.clone();
    let names: Vec<String> = map.keys().take(NAMES).map(str::to_owned).collect();
    for (nth, name) in names.into_iter().enumerate() {
        assert_eq!(map.get(&name), tree.get(&name));
        let other = format!("{name}{nth}");
        match nth % 4 {
            0 => assert_eq!(map.remove(&name), tree.remove(&name)),
            1 => assert_eq!(map.insert(name.clone(), V::default()), tree.insert(name.clone(), V::default())),
            2 => {
                if let (Some(value), Some(same)) = (map.get_mut(&name), tree.get_mut(&name)) {
                    *value = V::default();
                    *same = V::default();
                }
            }
            _ => assert_eq!(map.contains_key(&other), tree.contains_key(&other)),
        }
        assert_eq!(map.insert(other.clone(), V::default()), tree.insert(other, V::default()));
        assert_eq!(map.contains_key(&name), tree.contains_key(&name));
    }
    assert_eq!(map.is_empty(), tree.is_empty());
    assert!(map.keys().eq(tree.keys()) && map.values().eq(tree.values()));
    assert_eq!(format!("{map:?}"), format!("{tree:?}"));
    let again: SortedMap<V> = map.clone().into_iter().collect();
    assert_eq!(again, map);
}
