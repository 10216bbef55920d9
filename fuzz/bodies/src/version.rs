//! The version guard and the contract's status.

use ncp_spec::contract::{ContractStatus, contract_status, negotiate, verify_contract};
use ncp_spec::version::check_version;
use ncp_spec::{CONTRACT_HASH, WIRE_VERSION};

/// A version is compatible exactly when its digits say so, strict or not; a hash never decides.
///
/// It would find an overflow, a sign or a third component that passes, and a panic.
// [NCP-VER-001] [NCP-VER-002] [NCP-VER-003] [NCP-VER-004] [NCP-VER-006] [NCP-VER-007] [NCP-VER-008]
// [NCP-VER-009] [NCP-VER-022] [NCP-VER-023] [NCP-VER-024] [NCP-VER-026] [NCP-VER-027] [NCP-VER-030]
// [NCP-VER-031]
pub fn version(input: &[u8]) {
    let text = String::from_utf8_lossy(input);
    let expected = judge(&text);
    assert_eq!(check_version(&text, false).ok(), expected);
    assert_eq!(check_version(&text, true).ok(), expected.filter(|same| *same));

    let own = CONTRACT_HASH;
    let of_text = if text == own { ContractStatus::Match } else { ContractStatus::Mismatch };
    assert_eq!(contract_status(Some(&text)), of_text);
    assert_eq!(verify_contract(Some(&text)).is_ok(), text == own);
    for (hash, status) in
        [(None, ContractStatus::NotAdvertised), (Some(own), ContractStatus::Match), (Some(&*text), of_text)]
    {
        let agreed = (expected == Some(true)).then_some(status);
        assert_eq!(negotiate(&text, hash).ok(), agreed);
    }
}

/// Whether a text is a version that is compatible with that of the wire, by its digits: none if it is no version.
fn judge(text: &str) -> Option<bool> {
    let (own, version) = (numbers(WIRE_VERSION)?, numbers(text)?);
    // Before the first major version, every minor one is a wire of its own.
    Some(version.0 == own.0 && (!own.0.is_empty() || version.1 == own.1))
}

/// The digits of the major and the minor version, without leading zeros.
fn numbers(text: &str) -> Option<(&str, &str)> {
    let mut parts = text.split('.').map(|part| {
        let is_number = !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        is_number.then(|| part.trim_start_matches('0'))
    });
    let major = parts.next()??;
    let minor = parts.next().unwrap_or(Some(""))?;
    match parts.next() {
        None => Some((major, minor)),
        Some(_) => None,
    }
}
