//! Keys: two texts with a line feed between them, a pattern and a key.

use ncp_spec::keys::{Keys, MAX_SEGMENT_BYTES, matches, validate_segment};
use zenoh_keyexpr::{OwnedKeyExpr, keyexpr};

/// A pattern matches a key exactly when Zenoh says so; a segment is accepted by the rules of the text
/// and no others, and then stands unchanged in a key that Zenoh takes.
///
/// It would find a wildcard that reaches too far or not far enough, matching without end, and an id by
/// which one session's key becomes another's.
// [NCP-KEY-002] [NCP-KEY-005] [NCP-KEY-007] [NCP-KEY-010] [NCP-KEY-011] [NCP-KEY-012] [NCP-KEY-013]
// [NCP-KEY-014] [NCP-KEY-015] [NCP-KEY-016] [NCP-KEY-017] [NCP-KEY-018] [NCP-KEY-019] [NCP-KEY-020]
// [NCP-KEY-030] [NCP-KEY-031] [NCP-KEY-032] [NCP-KEY-033] [NCP-KEY-034] [NCP-KEY-035] [NCP-KEY-036]
pub fn keys(input: &[u8]) {
    let (pattern, key) = parts(input);
    assert_eq!(matches(&pattern, &key).ok(), zenoh(&pattern, &key));
    for text in [&pattern, &key] {
        let valid = is_segment(text);
        assert_eq!(validate_segment(text).is_ok(), valid, "{text:?}");
        let realm = Keys::new(Some(text));
        assert_eq!(realm.is_ok(), text.split('/').all(is_segment), "{text:?}");
        let keys = Keys::new(None).expect("the default realm is one");
        let sensor = keys.sensor(text, Some(text));
        assert_eq!(sensor.is_ok(), valid);
        if let Ok(sensor) = sensor {
            assert_eq!(sensor, format!("ncp/session/{text}/sensor/{text}"));
            assert!(keyexpr::new(&sensor).is_ok(), "{sensor:?}");
            let glob = keys.sensor_glob(text).expect("a segment that was accepted");
            assert_eq!(matches(&glob, &sensor), Ok(true));
            assert_eq!(zenoh(&glob, &sensor), Some(true));
        }
    }
}

/// The input as a person reads it.
#[must_use]
pub fn show(input: &[u8]) -> String {
    let (pattern, key) = parts(input);
    format!("pattern {pattern:?}, key {key:?}")
}

fn parts(input: &[u8]) -> (String, String) {
    let text = String::from_utf8_lossy(input);
    let (pattern, key) = text.split_once('\n').unwrap_or((&text, &text));
    (pattern.to_owned(), key.to_owned())
}

/// What Zenoh says. It wants expressions in their one canonical form, and brings them there but for
/// `$*$*`.
fn zenoh(pattern: &str, key: &str) -> Option<bool> {
    let canonical = |expression: &str| {
        let mut expression = expression.to_owned();
        while expression.contains("$*$*") {
            expression = expression.replace("$*$*", "$*");
        }
        OwnedKeyExpr::autocanonize(expression).ok()
    };
    let (pattern, key) = (canonical(pattern)?, canonical(key)?);
    (!key.contains('*')).then(|| pattern.includes(&key))
}

/// The rules of section 3.3, one after the other.
fn is_segment(text: &str) -> bool {
    !text.is_empty()
        && text.len() <= MAX_SEGMENT_BYTES
        && text != "."
        && text != ".."
        && !text.starts_with('@')
        && !text.contains(['/', '*', '$', '#', '?', ' '])
        && !text.chars().any(|c| matches!(u32::from(c), 0..0x20 | 0x7f..0xa0))
}
