//! The contract hash: its status, its verification, and negotiation.

use super::{MALFORMED, malformed};
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::model::{CONTRACT_HASH, WIRE_VERSION};
use crate::scenario::{Row, ScenarioError, Scenarios, source};

pub(super) fn files() -> Result<[File; 2], ScenarioError> {
    let mut text = Scenarios::read(source!("version/contract"))?;
    let others = text.rows("hashes")?;
    let others = others.iter().map(|row| {
        let hash = match row.cell("sent")? {
            "near" => Json::string(near(row.name)),
            _ => Json::read(&row.text("sent")?),
        };
        Ok((row.name, hash, row.cell("words")?))
    });
    let others = others.collect::<Result<Vec<_>, _>>()?;
    let mut cases = vec![
        status("own", Some(CONTRACT_HASH), "match", &["NCP-VER-023", "NCP-VER-020"], "its own hash"),
        status("absent", None, "not_advertised", &["NCP-VER-022"], "an absent hash"),
    ];
    cases.extend(
        others.iter().map(|(name, hash, says)| status(name, hash.as_str(), "mismatch", &["NCP-VER-024"], says)),
    );
    cases.push(
        Case::new("verify/own", &["NCP-VER-027", "NCP-VER-020"], &Role::ALL)
            .title("A peer that verifies the contract accepts its own hash.")
            .flags(&["contract-matching"])
            .call("contract.verify", object! { "peer_hash" => CONTRACT_HASH })
            .accepts()
            .because(format!("The hash is that of wire {WIRE_VERSION}, letter for letter.")),
    );
    cases.extend(others.iter().map(|(name, hash, says)| {
        Case::new(format!("verify/{name}"), &["NCP-VER-026"], &Role::ALL)
            .title(format!("A peer that verifies the contract rejects {says}."))
            .flags(&["contract-matching"])
            .call("contract.verify", object! { "peer_hash" => hash.clone() })
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
    let contract = File::new("version", "contract", about, cases);
    let mut cases = text.cases("negotiated", negotiated)?;
    cases.extend(
        others.iter().filter_map(|(name, hash, says)| also_negotiated(&cases, name, hash, says)).collect::<Vec<_>>(),
    );
    cases.extend(text.rest(not_negotiated)?);
    cases.extend(malformed(&MALFORMED)?.into_iter().map(not_negotiable));
    let about = "Negotiation: the strict version guard, then the status of the contract hash.";
    Ok([contract, File::new("version", "negotiate", about, cases)])
}

/// A hash that is nearly one's own, in the way of its name.
fn near(what: &str) -> String {
    let mut digits: Vec<char> = CONTRACT_HASH.chars().collect();
    let next = |digit: char| digit.to_digit(16).and_then(|value| char::from_digit((value + 1) % 16, 16));
    match (what, &mut digits[..]) {
        ("last-digit", [.., digit]) | ("first-digit", [digit, ..]) => *digit = next(*digit).unwrap_or('0'),
        ("one-upper-case-digit", digits) => {
            if let Some(letter) = digits.iter_mut().rfind(|digit| digit.is_ascii_alphabetic()) {
                letter.make_ascii_uppercase();
            }
        }
        // What a reader of numbers takes for the same.
        ("full-width-digit", digits) => swap(digits, |digit| char::from_u32(0xff10 + digit.to_digit(10)?)),
        ("full-width-letter", digits) => {
            swap(digits, |digit| char::from_u32(0xff41 + digit.to_digit(16)?.checked_sub(10)?));
        }
        ("arabic-indic-digit", digits) => swap(digits, |digit| char::from_u32(0x660 + digit.to_digit(10)?)),
        // What is left of it in bytes of eight bits.
        ("low-bytes", digits) => swap(digits, |digit| char::from_u32(0x100 + u32::from(digit))),
        ("all-low-bytes", digits) => {
            digits.iter_mut().for_each(|digit| *digit = char::from_u32(0x100 + u32::from(*digit)).unwrap_or(*digit));
        }
        ("underscore", digits) => return within(digits, '_'),
        ("space-within", digits) => return within(digits, ' '),
        ("hyphen-within", digits) => return within(digits, '-'),
        ("soft-hyphen-within", digits) => return within(digits, '\u{ad}'),
        ("accent-within", digits) => return within(digits, '\u{301}'),
        ("byte-swapped", digits) => {
            digits.reverse();
            digits.chunks_exact_mut(2).for_each(<[char]>::reverse);
        }
        ("first-half", digits) => return digits[..digits.len() / 2].iter().collect(),
        (_, digits) => return digits[..digits.len().saturating_sub(1)].iter().collect(),
    }
    digits.into_iter().collect()
}

/// The digits with something in their middle that some readers pass over.
fn within(digits: &[char], what: char) -> String {
    let (front, back) = digits.split_at(digits.len() / 2);
    front.iter().chain([&what]).chain(back).collect()
}

/// Puts another character in the place of the first that has one.
fn swap(digits: &mut [char], other: impl Fn(char) -> Option<char>) {
    if let Some((digit, other)) = digits.iter_mut().find_map(|digit| other(*digit).map(|other| (digit, other))) {
        *digit = other;
    }
}

fn negotiated(row: &Row) -> Result<Case, ScenarioError> {
    let args = object! { "version" => WIRE_VERSION, "contract_hash" => Json::read(&row.text("sent")?) };
    Ok(row.case(&Role::ALL).call("negotiate", args).gives(object! { "contract" => row.cell("contract")? }))
}

/// The status of a hash that is nearly one's own, by negotiation; none, if it is negotiated already.
fn also_negotiated(cases: &[Case], name: &str, hash: &Json, says: &str) -> Option<Case> {
    let args = object! { "version" => WIRE_VERSION, "contract_hash" => hash.clone() };
    let case = Case::new(format!("compatible/{name}"), &["NCP-VER-024", "NCP-VER-031"], &Role::ALL)
        .title(format!("Negotiation of version {WIRE_VERSION} and {says} gives `mismatch`."))
        .flags(&["contract-matching"])
        .call("negotiate", args)
        .gives(object! { "contract" => "mismatch" })
        .because("Hashes are compared letter for letter, by negotiation as by the status.");
    (!cases.iter().any(|known| known.args == case.args || known.path == case.path)).then_some(case)
}

fn not_negotiated(row: &Row) -> Result<Case, ScenarioError> {
    let read = |text: &str| Ok(Json::read(&row.fill(text)?));
    let args = object! { "version" => read("{sent}")?, "contract_hash" => read("{peer.first}")? };
    Ok(row.case(&Role::ALL).call("negotiate", args).rejects("version"))
}

/// A text that is no version.
fn not_negotiable((name, version): (&str, Json)) -> Case {
    Case::new(format!("incompatible/{name}/no-hash"), &["NCP-VER-030", "NCP-VER-001"], &Role::ALL)
        .rests_on(format!("version/guard/strict/{name}"))
        .title(format!("Negotiation of version {} and no hash is an error.", version.text()))
        .flags(&["lenient-versions"])
        .call("negotiate", object! { "version" => version, "contract_hash" => None::<&str> })
        .rejects("version")
        .because("The version guard is strict here, and it answers what is no version with an error.")
}

fn status(name: &str, hash: Option<&str>, status: &'static str, rules: &[&'static str], says: &str) -> Case {
    Case::new(format!("status/{name}"), rules, &Role::ALL)
        .title(format!("The contract status of {says} is `{status}`."))
        .flags(&["contract-matching"])
        .call("contract.status", object! { "peer_hash" => hash })
        .gives(object! { "status" => status })
        .because("Absent, equal letter for letter, or anything else: the hash is only compared.")
}
