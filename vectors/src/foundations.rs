//! On which cases a case rests: without them it shows nothing of its own rule.
//!
//! A frame that no decoder accepts says nothing of its fields, and a governor that takes every sensor for stale says
//! nothing of its fence. So the plainest cases come first, and what is built on them rests on them.

use std::collections::BTreeSet;

use crate::case::{Case, File};
use crate::json::Json;

/// What the cases rest on whose id begins so: the first line that fits. `{kind}` is the kind of the frame.
const BENEATH: &[(&str, &[&str])] = &[
    // Numbers and strings of a frame are read from what the peer writes.
    ("wire/encode_{kind}/plain", &[]),
    ("wire/encode_{kind}/string", &["wire/encode_{kind}/plain"]),
    ("wire/encode_{kind}/explicit", &["wire/encode_{kind}/plain"]),
    ("wire/encode_", &["wire/encode_{kind}/plain", "wire/encode_{kind}/explicit"]),
    ("keys/build/{key}/realm-named", &["keys/build/{key}/realm"]),
    ("keys/build/{key}/", &["keys/build/{key}/realm"]),
    ("keys/segments/{key}/name/accepted", &["keys/build/{key}/realm", "keys/build/{key}/realm-named"]),
    ("keys/segments/{key}/session/accepted", &["keys/build/{key}/realm"]),
    ("keys/realms/{key}/realm/accepted", &["keys/build/{key}/realm"]),
    ("safety/stale/age/500-ms/from-0-s/half", &[]),
    ("safety/", &["safety/stale/age/500-ms/from-0-s/half"]),
    ("control/loop/gate/stale", &["safety/gates/stale-sensor/active"]),
    ("control/loop/gate/clock-backward", &["safety/gates/clock-backward/active"]),
    ("control/loop/gate/outside", &["safety/gates/outside/active"]),
    ("control/loop/gate/config-fault", &["safety/gates/config-fault/active"]),
    ("control/loop/gate/speed-clamp", &["safety/speed/vector/3-4-0/above"]),
    ("control/loop/ttl/look-ahead", &["safety/gates/leaves-fence/active"]),
    ("control/loop/link/burst", &["safety/gates/latched-by-link/active"]),
    ("control/loop/status/mode/stopped-by-burst", &["control/loop/link/burst"]),
    ("control/loop/status/mode/stopped", &["control/loop/gate/outside"]),
    ("control/loop/status/mode/held-clock", &["control/loop/gate/clock-backward"]),
    ("control/loop/status/mode/held-limits", &["control/loop/gate/config-fault"]),
    ("control/loop/status/mode/held", &["control/loop/gate/stale"]),
    ("control/loop/status/mode/waiting", &["control/loop/newest/no-frame"]),
    ("control/loop/status/safety/stopped-by-burst", &["control/loop/link/burst"]),
    ("control/loop/status/safety/stopped", &["control/loop/gate/outside"]),
    ("control/loop/status/safety/held-clock", &["control/loop/gate/clock-backward"]),
    ("control/loop/status/safety/held-limits", &["control/loop/gate/config-fault"]),
    ("control/loop/status/safety/held", &["control/loop/gate/stale"]),
];

/// The kinds whose cases of decoding rest on cases of encoding.
const EXPLICIT: &str = "wire/{kind}/explicit";
const OWN: &str = "wire/kinds/{kind}/version/own";
const ABSENT: &str = "wire/{kind}/ncp_version/absent";
const PLAIN: &str = "wire/encode_{kind}/plain";

/// Lets every case rest on what lies beneath it.
pub(crate) fn lay(files: Vec<File>) -> Vec<File> {
    let ids: BTreeSet<String> = files.iter().flat_map(File::ids).collect();
    let found = |mut file: File| {
        let prefix = file.prefix();
        file.cases = file.cases.into_iter().map(|case| founded(case, &prefix, &ids)).collect();
        file
    };
    files.into_iter().map(found).collect()
}

fn founded(mut case: Case, prefix: &str, ids: &BTreeSet<String>) -> Case {
    let id = format!("{prefix}/{}", case.path);
    let word = |name: &str| case.args.get(name).and_then(Json::as_str).unwrap_or_default().to_owned();
    let (kind, key) = (word("kind"), word("key"));
    let named = |pattern: &str| pattern.replace("{kind}", &kind).replace("{key}", &key);
    let line = BENEATH.iter().find(|(begins, _)| id.starts_with(&named(begins)));
    let mut beneath: Vec<String> = line.into_iter().flat_map(|(_, on)| *on).map(|on| named(on)).collect();
    if case.call == "decode" && case.expect.get("reject").is_none() {
        let text = word("text");
        beneath.extend(if id == named(OWN) {
            case = case.by("within", "NCP-WIRE-034");
            vec![named(PLAIN)]
        } else if id == named(EXPLICIT) || id == named(ABSENT) {
            vec![named(OWN)]
        } else if text.contains("ncp_version") || text.is_empty() {
            vec![named(EXPLICIT)]
        } else {
            vec![named(ABSENT), named(EXPLICIT)]
        });
    }
    for on in beneath.into_iter().filter(|on| *on != id && ids.contains(on)) {
        case = case.rests_on(on);
    }
    case
}
