//! The protobuf form. The first byte chooses the kind and, by its highest bit, what the rest is: a
//! frame, or protobuf.

use ncp_proto::convert::{Lost, ToProtoError, from_binary, to_binary};
use ncp_spec::wire::{Kind, decode};

use crate::frame::split;

/// The bit that says that protobuf follows.
const BINARY: u8 = 0x80;

/// A message that protobuf can carry comes back as it was; a protobuf form that is read is a message
/// that can be sent, and has that form again.
///
/// It would find a field that one direction forgets, a number of an enum that means another string,
/// and protobuf by which something enters that no frame could say.
// [NCP-WIRE-041] [NCP-WIRE-044] [NCP-WIRE-091] [NCP-PROV-006] [NCP-PROV-008]
pub fn proto_vs_json(input: &[u8]) {
    let (binary, kind, rest) = parts(input);
    if binary {
        let Ok(message) = from_binary(kind, rest) else {
            return;
        };
        assert_eq!(message.kind(), kind);
        let text = message.encode().expect("what was read can be sent");
        assert_eq!(decode(kind, text.as_bytes()).as_ref(), Ok(&message));
        match to_binary(&message) {
            Ok(again) => assert_eq!(from_binary(kind, &again), Ok(message)),
            // Protobuf itself can hold a negative zero; prost leaves it out.
            Err(error) => assert!(only_signs(&error), "{error}"),
        }
    } else if let Ok(message) = decode(kind, rest) {
        match to_binary(&message) {
            Ok(binary) => {
                let back = from_binary(kind, &binary).expect("what was written can be read");
                assert_eq!(back, message);
                assert_eq!(back.encode(), message.encode());
            }
            Err(ToProtoError::ErrorFrame) => assert_eq!(kind, Kind::Error),
            Err(ToProtoError::Lossy(losses)) => assert!(!losses.is_empty()),
        }
    }
}

/// The input as a person reads it.
#[must_use]
pub fn show(input: &[u8]) -> String {
    let (binary, kind, rest) = parts(input);
    if binary {
        format!("{kind}: {:?}", from_binary(kind, rest))
    } else {
        format!("{kind}: {}", String::from_utf8_lossy(rest))
    }
}

/// The input of a kind and its protobuf form.
#[must_use]
pub fn join(kind: Kind, binary: &[u8]) -> Vec<u8> {
    let mut input = crate::frame::join(kind, binary);
    input[0] |= BINARY;
    input
}

fn parts(input: &[u8]) -> (bool, Kind, &[u8]) {
    let first = input.first().copied().unwrap_or_default();
    let (kind, rest) = split(input);
    if first & BINARY == 0 {
        return (false, kind, rest);
    }
    (true, split(&[first & !BINARY]).0, rest)
}

fn only_signs(error: &ToProtoError) -> bool {
    let is_sign = |lost: &Lost| matches!(lost, Lost::ZeroSign);
    matches!(error, ToProtoError::Lossy(losses) if losses.iter().all(|loss| is_sign(&loss.what)))
}
