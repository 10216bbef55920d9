//! The case that every run begins with: what the peer says about itself.

use ncp_text::catalogue::Role;
use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

use crate::check::{Difference, Differences};
use crate::peer::{Description, excerpt};
use crate::run::{CaseRun, Outcome};

/// Judges the answer to `describe`: its wire version [NCP-VER-021], its contract hash [NCP-VER-020], and that its
/// roles are known ones.
#[must_use]
pub fn judge_description(description: &Description) -> CaseRun {
    let show = |text: &str| format!("\"{}\"", excerpt(text.as_bytes(), 60));
    let mut first = Vec::new();
    let mut differ = |at: &str, expected: &str, got: &str| {
        if expected != got {
            first.push(Difference {
                at: at.to_owned(),
                expected: Some(show(expected)),
                got: Some(show(got)),
                hint: None,
            });
        }
    };
    differ("/wire_version", WIRE_VERSION, &description.wire_version);
    differ("/contract_hash", CONTRACT_HASH, &description.contract_hash);
    for (i, role) in description.roles.iter().enumerate().filter(|(_, role)| Role::parse(role).is_none()) {
        first.push(Difference {
            at: format!("/roles/{i}"),
            expected: Some(format!("one of {}", Role::ALL.map(Role::as_str).join(", "))),
            got: Some(show(role)),
            hint: None,
        });
    }
    if description.roles.is_empty() {
        first.push(Difference {
            at: "/roles".to_owned(),
            expected: Some("at least one role".to_owned()),
            got: Some("[]".to_owned()),
            hint: Some("a peer that claims nothing cannot conform to anything".to_owned()),
        });
    }
    let outcome =
        if first.is_empty() { Outcome::Pass } else { Outcome::Fail(Differences { first, ..Differences::default() }) };
    CaseRun { outcome, answer: None, note: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn description() -> Description {
        Description {
            name: "n".into(),
            version: "1".into(),
            language: "C".into(),
            wire_version: WIRE_VERSION.into(),
            contract_hash: CONTRACT_HASH.into(),
            roles: vec!["body".into()],
            reference_networks: false,
        }
    }

    fn faults(description: &Description) -> Vec<String> {
        match judge_description(description).outcome {
            Outcome::Pass => Vec::new(),
            Outcome::Fail(differences) => differences.first.iter().map(ToString::to_string).collect(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_description_by_the_text_passes_and_each_deviation_is_named() {
        assert!(faults(&description()).is_empty());
        let old = Description { wire_version: "0.4".into(), contract_hash: "2cf0763ad61e4f1c".into(), ..description() };
        assert_eq!(
            faults(&old),
            [
                format!(r#"/wire_version: expected "{WIRE_VERSION}", got "0.4""#),
                format!(r#"/contract_hash: expected "{CONTRACT_HASH}", got "2cf0763ad61e4f1c""#),
            ]
        );
        let upper = Description { contract_hash: CONTRACT_HASH.to_uppercase(), ..description() };
        assert_eq!(faults(&upper).len(), 1);
        let pilot = Description { roles: vec!["body".into(), "pilot".into()], ..description() };
        assert_eq!(faults(&pilot), [r#"/roles/1: expected one of commander, body, server, observer, got "pilot""#]);
        let none = Description { roles: Vec::new(), ..description() };
        assert_eq!(faults(&none).len(), 1);
    }
}
