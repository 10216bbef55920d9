//! Every spelling of a number, in fields that between them every role reads.

use super::fields;
use super::place::Place;
use crate::case::{Case, File};

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for (kind, message, member, field) in FIELDS {
        let nested = Place::nested().into_iter();
        let place = Place::frames()
            .chain(nested)
            .find(|place| place.kind == *kind && place.message.name == *message && place.member(field) == *member);
        if let Some(place) = place {
            let under = |mut case: Case| {
                if !place.is_nested() {
                    case.path = format!("{kind}/{}", case.path);
                }
                case
            };
            cases.extend(fields::spellings(&place, field).into_iter().map(under));
        }
    }
    let about = "Numbers in every spelling: rounding, subnormals, signed zeros, overflow, and integers that are none.";
    File::new("wire", "numbers", about, cases)
}

/// Kind, message, the member as a reader finds it, and the field's own name.
const FIELDS: &[(&str, &str, &str, &str)] = &[
    ("sensor_frame", "ChannelValue", "channels.a.data", "data"),
    ("command_frame", "CommandFrame", "ttl_ms", "ttl_ms"),
    ("run_request", "RunRequest", "duration_ms", "duration_ms"),
    ("sensor_frame", "SensorFrame", "seq", "seq"),
    ("command_frame", "CommandFrame", "seq", "seq"),
    ("open_session", "SimConfig", "sim.seed", "seed"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_listed_field_is_found() {
        let cases = file().cases;
        for (kind, _, _, field) in FIELDS {
            let is_here = |case: &&Case| case.path.starts_with(kind) && case.path.split('/').any(|part| part == *field);
            assert!(cases.iter().any(|case| is_here(&case)), "{kind} {field}");
        }
    }
}
