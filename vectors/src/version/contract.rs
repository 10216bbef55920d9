//! The contract hash: its status, its verification, and negotiation.

use crate::case::{Case, File, Role};
use crate::json::object;
use crate::model::CONTRACT_HASH;

/// A hash that a peer may advertise: its name, the hash, and what is special about it.
const OTHERS: &[(&str, &str, &str)] = &[
    ("older-wire", "2cf0763ad61e4f1c", "the hash of wire 0.4"),
    ("upper-case", "24E8E6E31E1DEC8A", "the own hash in upper case"),
    ("one-upper-case-digit", "24e8e6e31e1dec8A", "the own hash with one digit in upper case"),
    ("last-digit", "24e8e6e31e1dec8b", "the own hash but for its last digit"),
    ("first-digit", "34e8e6e31e1dec8a", "the own hash but for its first digit"),
    ("truncated", "24e8e6e31e1dec8", "the own hash without its last digit"),
    ("first-half", "24e8e6e3", "the first half of the own hash"),
    ("longer", "24e8e6e31e1dec8a0", "the own hash and a digit more"),
    ("prefixed", "0x24e8e6e31e1dec8a", "the own hash with a prefix"),
    ("trailing-space", "24e8e6e31e1dec8a ", "the own hash and a space"),
    ("leading-space", " 24e8e6e31e1dec8a", "a space and the own hash"),
    ("trailing-line-feed", "24e8e6e31e1dec8a\n", "the own hash and a line feed"),
    ("trailing-nul", "24e8e6e31e1dec8a\0", "the own hash and U+0000"),
    ("byte-swapped", "8aec1d1ee3e6e824", "the own hash in the other byte order"),
    ("zeros", "0000000000000000", "sixteen zeros"),
    ("empty", "", "an empty hash"),
    ("no-hash", "not a hash", "no hash at all"),
];

pub(super) fn status_file() -> File {
    let mut cases = vec![
        status("own", Some(CONTRACT_HASH), "match", &["NCP-VER-023", "NCP-VER-020"], "its own hash"),
        status("absent", None, "not_advertised", &["NCP-VER-022"], "an absent hash"),
    ];
    cases.extend(OTHERS.iter().map(|(name, hash, says)| status(name, Some(hash), "mismatch", &["NCP-VER-024"], says)));
    cases.push(
        Case::new("verify/own", &["NCP-VER-027", "NCP-VER-020"], &Role::ALL)
            .title("A peer that verifies the contract accepts its own hash.")
            .flags(&["contract-matching"])
            .call("contract.verify", object! { "peer_hash" => CONTRACT_HASH })
            .accepts()
            .because("The hash is that of wire 0.5, letter for letter."),
    );
    cases.extend(OTHERS.iter().map(|(name, hash, says)| {
        Case::new(format!("verify/{name}"), &["NCP-VER-026"], &Role::ALL)
            .title(format!("A peer that verifies the contract rejects {says}."))
            .flags(&["contract-matching"])
            .call("contract.verify", object! { "peer_hash" => *hash })
            .rejects("contract")
            .because("Hashes are compared letter for letter.")
    }));
    cases.push(
        Case::new("verify/absent", &["NCP-VER-028"], &Role::ALL)
            .title("A peer that verifies the contract should reject an absent hash.")
            .flags(&["contract-matching"])
            .call("contract.verify", object! { "peer_hash" => None::<&str> })
            .rejects("contract")
            .because("Nothing was verified."),
    );
    let about = "How a peer's contract hash compares with one's own, and what the strict opt-in rejects.";
    File::new("version", "contract", about, cases)
}

pub(super) fn negotiate_file() -> File {
    let hashes = [
        ("own-hash", Some(CONTRACT_HASH), "match", "its own hash"),
        ("no-hash", None, "not_advertised", "no hash"),
        ("older-hash", Some("2cf0763ad61e4f1c"), "mismatch", "another hash"),
        ("upper-case-hash", Some("24E8E6E31E1DEC8A"), "mismatch", "its own hash in upper case"),
        ("empty-hash", Some(""), "mismatch", "an empty hash"),
    ];
    let mut cases = Vec::new();
    for (name, hash, contract, says) in hashes {
        let rules: &[_] = match contract {
            "mismatch" if name == "older-hash" => &["NCP-VER-025", "NCP-VER-031"],
            "mismatch" => &["NCP-VER-024", "NCP-VER-031"],
            "match" => &["NCP-VER-031", "NCP-VER-023"],
            _ => &["NCP-VER-031", "NCP-VER-022"],
        };
        cases.push(
            Case::new(format!("compatible/{name}"), rules, &Role::ALL)
                .title(format!("Negotiation of version 0.5 and {says} gives `{contract}`."))
                .flags(&["contract-matching"])
                .call("negotiate", object! { "version" => "0.5", "contract_hash" => hash })
                .gives(object! { "contract" => contract })
                .because(
                    "The version is compatible, so the answer is the status of the hash, which is no ground to reject.",
                ),
        );
    }
    let versions = [
        ("older", "0.4"),
        ("newer", "0.6"),
        ("next-major", "1.0"),
        ("no-minor", "0"),
        ("empty", ""),
        ("three-parts", "0.5.0"),
        ("letter-v", "v0.5"),
        ("line-feed-last", "0.5\n"),
        ("space-first", " 0.5"),
        ("plus", "+0.5"),
    ];
    for (version_name, version) in versions {
        for (name, hash, _, says) in hashes.into_iter().take(3) {
            cases.push(
                Case::new(format!("incompatible/{version_name}/{name}"), &["NCP-VER-030"], &Role::ALL)
                    .title(format!(
                        "Negotiation of version {} and {says} is an error.",
                        crate::json::Json::string(version).text()
                    ))
                    .flags(&["negotiation-by-hash"])
                    .call("negotiate", object! { "version" => version, "contract_hash" => hash })
                    .rejects("version")
                    .because("The version guard is strict here, and no hash mends a version."),
            );
        }
    }
    let about = "Negotiation: the strict version guard, then the status of the contract hash.";
    File::new("version", "negotiate", about, cases)
}

fn status(name: &str, hash: Option<&str>, status: &'static str, rules: &[&'static str], says: &str) -> Case {
    Case::new(format!("status/{name}"), rules, &Role::ALL)
        .title(format!("The contract status of {says} is `{status}`."))
        .flags(&["contract-matching"])
        .call("contract.status", object! { "peer_hash" => hash })
        .gives(object! { "status" => status })
        .because("Absent, equal letter for letter, or anything else: the hash is only compared.")
}
