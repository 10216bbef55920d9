//! The freedoms of versions, contract hashes, keys and the longest horizon.

use super::exact::floors;
use super::open::is_advice;
use super::{Outcome, Verdict, any, by_result, fits};
use crate::fuzz::generate::canonical;
use crate::fuzz::tree::{Tree, double, list, num, object, string};
use crate::json::Json;

/// `version.check`, `negotiate`, `contract.status` and `contract.verify`.
pub(super) fn version(args: &Tree, result: Outcome<'_>) -> Verdict {
    if string(args, "version").is_some_and(is_advice) {
        return Verdict::Open("a version with leading zeros or a large part, VER-009");
    }
    let is_absent = |name: &str| args.get(name).is_none_or(Json::is_null);
    if args.get("version").is_none() && is_absent("peer_hash") && result.is_err() {
        return Verdict::Open("an absent hash that is verified, VER-028");
    }
    by_result(result)
}

pub(super) fn key_build(args: &Tree, result: Outcome<'_>) -> Verdict {
    let odd =
        |name: &str| string(args, name).is_some_and(|part| part.chars().any(|c| ('\u{80}'..='\u{9f}').contains(&c)));
    if ["realm", "session", "name"].into_iter().any(odd) {
        return Verdict::Open("a control character of U+0080 to U+009F, KEY-016");
    }
    by_result(result)
}

pub(super) fn key_match(args: &Tree, result: Outcome<'_>) -> Verdict {
    if string(args, "key").is_some_and(|key| key.contains(['*', '$'])) {
        return Verdict::Open("the key has wildcards");
    }
    let is_canonical = |pattern: &str| {
        let chunks: Vec<String> = pattern.split('/').map(str::to_owned).collect();
        !pattern.contains("$*$*") && canonical(chunks.clone()) == chunks
    };
    if string(args, "pattern").is_some_and(|pattern| !is_canonical(pattern)) {
        return Verdict::Open("a pattern that Zenoh spells in another way");
    }
    match result {
        Err(_) => Verdict::Open("what is no key expression, KEY-036"),
        result => by_result(result),
    }
}

pub(super) fn horizon(args: &Tree, result: Outcome<'_>) -> Verdict {
    let (ttl, dt) = (double(args.get("ttl_ms")).unwrap_or(f64::NAN), double(args.get("dt_ms")).unwrap_or(f64::NAN));
    let is_time = |value: f64| value.is_finite() && value > 0.0;
    if !is_time(ttl) || !is_time(dt) {
        return by_result(result);
    }
    // The ttl that was sent or that is enforced, and the cap is advice.
    let mut lengths: Vec<f64> = [ttl, ttl.min(60_000.0)].into_iter().flat_map(|ttl| floors(ttl, dt)).collect();
    if lengths.iter().any(|length| *length > 9e15) {
        return Verdict::Open("more steps than a counter has");
    }
    if lengths.iter().any(|length| *length > 4096.0) {
        lengths.push(4096.0);
    }
    lengths.sort_by(f64::total_cmp);
    lengths.dedup();
    let choices = list(lengths.iter().map(|length| num(length.max(0.0))).collect());
    match choices {
        Json::Array(choices) => fits(object([("len", any(choices))])),
        _ => by_result(result),
    }
}
