//! Wire version and contract hash, by the policy of chapter 2: the hash is that of the proto, a frozen wire keeps both,
//! and a new wire has both of its own.

use ncp_spec::contract::hash_of;

use super::against::{Base, identity_of};
use super::rows::{Found, Unrun};
use super::{Finding, Gate, GateError, IDENTITY, PROJECTION, PROTO};

/// Holds what the tree says of itself against its proto, and against what went out before.
pub(super) fn check(gate: &Gate<'_>) -> Result<Found, Unrun> {
    let proto = hash_of(&gate.read(PROTO)?);
    let chapter = gate.read(IDENTITY)?;
    let stated = |before: &str| {
        let found = stated(&chapter, before);
        found.ok_or_else(|| Unrun::broken(Finding::at(IDENTITY, None, format!("does not say: {before}…"))))
    };
    let (wire, wire_line) = stated("The wire version of this text is `")?;
    let (hash, hash_line) = stated("The contract hash of this text is `")?;
    let tree = Tree { proto, wire, wire_line, hash, hash_line };

    let mut findings = tree.by_itself();
    let form = |error: GateError| Unrun::broken(Finding::at(PROJECTION, None, error.to_string()));
    let projected = identity_of(&gate.path(PROJECTION)).map_err(form)?;
    for (what, projected, stated) in [("wire", projected.0, &tree.wire), ("contract_hash", projected.1, &tree.hash)] {
        if projected.as_deref() != Some(stated) {
            let is = projected.unwrap_or_else(|| "nothing".to_owned());
            let text = format!("says {what} {is} where chapter 2 says {stated}: cargo xtask generate");
            findings.push(Finding::at(PROJECTION, None, text).by("projection"));
        }
    }
    findings.extend(tree.against(gate.base));
    let before = gate.base.wire.as_deref().map_or_else(String::new, |before| {
        if before == tree.wire { ", as before".to_owned() } else { format!(", after {before}") }
    });
    Ok(Found { said: format!("wire {}, contract hash {}{before}", tree.wire, tree.hash), findings }.only_if_good())
}

/// What a tree says of itself.
struct Tree<'t> {
    /// The contract hash of its proto.
    proto: String,
    /// The wire version of its text, and where that stands.
    wire: &'t str,
    wire_line: u32,
    /// The contract hash of its text, and where that stands.
    hash: &'t str,
    hash_line: u32,
}

impl Tree<'_> {
    fn by_itself(&self) -> Vec<Finding> {
        let Self { proto, wire, hash, .. } = self;
        let mut findings = Vec::new();
        if parts(wire).is_none() {
            let text = format!("the wire version {wire} is not one or two integers, such as 0.6");
            findings.push(Finding::at(IDENTITY, Some(self.wire_line), text).by("version-form"));
        }
        if proto != hash {
            let text = format!("the contract hash of {PROTO} is {proto}, and the text states {hash}");
            findings.push(Finding::at(IDENTITY, Some(self.hash_line), text).by("hash-of-proto"));
        }
        findings
    }

    fn against(&self, base: &Base) -> Vec<Finding> {
        let Self { proto, wire, hash, .. } = self;
        let mut findings = Vec::new();
        let moved = base.is_of_another_wire(wire);
        if let Some(before) = base.hash.as_deref() {
            // The hash of the proto counts, whatever is stated.
            if !moved && before != proto {
                let text = format!("wire {wire} had the contract hash {before} and its proto now has {proto}");
                findings.push(Finding::at(PROTO, None, text).by("hash-under-its-version"));
            }
            if moved && before == *hash {
                let text = format!("wire {wire} has the contract hash of the wire before it, {before}");
                findings.push(Finding::at(IDENTITY, Some(self.hash_line), text).by("version-without-hash"));
            }
        }
        if let Some(before) = base.wire.as_deref().filter(|_| moved)
            && let (Some(was), Some(is)) = (parts(before), parts(wire))
            && is < was
        {
            let text = format!("the wire version goes back, from {before} to {wire}");
            findings.push(Finding::at(IDENTITY, Some(self.wire_line), text).by("version-goes-back"));
        }
        findings
    }
}

/// What stands between a sentence's beginning and the next backtick, and on which line.
fn stated<'t>(text: &'t str, before: &str) -> Option<(&'t str, u32)> {
    let at = text.find(before)? + before.len();
    let line = text[..at].matches('\n').count() + 1;
    Some((text[at..].split('`').next()?, u32::try_from(line).ok()?))
}

/// The integers of a version, a missing minor being 0 [NCP-VER-001] [NCP-VER-002].
fn parts(version: &str) -> Option<(u64, u64)> {
    let number = |text: &str| {
        let is_number = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        is_number.then(|| text.parse().ok()).flatten()
    };
    match version.split_once('.') {
        Some((major, minor)) => Some((number(major)?, number(minor)?)),
        None => Some((number(version)?, 0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_version_is_one_or_two_integers() {
        assert_eq!((parts("0.5"), parts("1"), parts("2.10")), (Some((0, 5)), Some((1, 0)), Some((2, 10))));
        for wrong in ["", "0.5.0", "v0.5", "0.", ".5", "0.5-draft", " 0.5", "+1"] {
            assert_eq!(parts(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn what_the_text_states_is_found_with_its_line() {
        let text = "# 2\n\nThe wire version of this text is `0.5`.\n";
        assert_eq!(stated(text, "The wire version of this text is `"), Some(("0.5", 3)));
        assert_eq!(stated(text, "The contract hash of this text is `"), None);
    }
}
