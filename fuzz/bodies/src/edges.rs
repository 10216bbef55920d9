//! Frames at the edges of what may be read and written: where mutation seldom gets, and where the
//! vectors have a template that is too long to be a seed.

use std::fmt::Display;

use ncp_spec::WIRE_VERSION;
use ncp_spec::wire::{Kind, MAX_ENTRIES, MAX_ITEMS, MAX_LEVELS};

/// Two names that one hash of 32 bits does not tell apart: those by which a reader notes members that
/// it ignores.
const OF_ONE_HASH: [&str; 2] = ["n15748", "n33700"];

/// Spellings of a number, right and wrong.
const NUMBERS: [&str; 24] = [
    "-0",
    "0e0",
    "-0.0e+7",
    "01",
    "-",
    "1.",
    ".5",
    "1e",
    "1e+",
    "+1",
    "1e22",
    "1e23",
    "123456789e-22",
    "9007199254740993",
    "9007199254740993e-1",
    "18446744073709551616",
    "0.30000000000000004440892098500626",
    "5e-324",
    "2e-324",
    "1.7976931348623157e308",
    "1e309",
    "1e-99999999999999999999",
    "1e99999999999999999999",
    "0x1",
];

/// Spellings of an integer, right and wrong.
const INTEGERS: [&str; 8] = [
    "9007199254740991",
    "-9007199254740991",
    "9007199254740992",
    "-0",
    "1.0",
    "1e0",
    "9223372036854775808",
    "100000000000000000007",
];

/// Insides of a string, right and wrong.
const STRINGS: [&str; 15] = [
    r#"\"\\\/\b\f\n\r\t"#,
    r"\u0000\u001F\u007f\u0080\uFFFF",
    r"\ud83d\ude00\uD83D\uDE00",
    r"\uDBFF\udfff",
    r"\ud800",
    r"\ud800\u0041",
    r"\ud800\ud800",
    r"\ud800x",
    r"\udc00\ud800",
    r"\u12g4",
    r"\u12",
    r"\x",
    "\u{1}",
    "\u{7f}\u{2028}\u{1f600}",
    "\\",
];

/// What may stand where another type is expected.
const VALUES: [&str; 8] = ["null", "true", "7", "-1.5", "\"x\"", "[]", "{}", "nul"];

/// The frames, each with the kind that its receiver expects.
pub(crate) fn frames() -> Vec<(Kind, String)> {
    let mut frames = Vec::new();
    let mut add = |kind: Kind, members: &str| {
        let version = format!(r#""ncp_version":"{WIRE_VERSION}","kind":"{kind}""#);
        let header = if kind == Kind::Error { format!(r#""kind":"{kind}""#) } else { version };
        frames.push((kind, format!("{{{header},{members}}}")));
    };

    for number in NUMBERS {
        add(Kind::SensorFrame, &format!(r#""t":{number}"#));
    }
    add(Kind::SensorFrame, &format!(r#""t":0.{}5"#, "3".repeat(1_000)));
    for integer in INTEGERS {
        add(Kind::SensorFrame, &format!(r#""seq":{integer}"#));
    }
    for string in STRINGS {
        add(Kind::SensorFrame, &format!(r#""frame_id":"{string}""#));
    }
    add(Kind::Error, &format!(r#""error":"{}""#, STRINGS[0]));
    add(Kind::Error, &format!(r#""error":"{}"#, STRINGS[1]));

    // [NCP-WIRE-020] and its neighbours: every value where another is expected.
    for value in VALUES {
        for (kind, member) in [
            (Kind::SensorFrame, "seq"),
            (Kind::SensorFrame, "t"),
            (Kind::SensorFrame, "channels"),
            (Kind::CommandFrame, "mode"),
            (Kind::CommandFrame, "horizon"),
            (Kind::CommandFrame, "horizon_dt_ms"),
            (Kind::ControlStatus, "safety_ok"),
            (Kind::Capabilities, "safety"),
            (Kind::BulkObservation, "block"),
        ] {
            add(kind, &format!(r#""{member}":{value}"#));
        }
    }
    add(Kind::CommandFrame, r#""horizon":[{},{"a":{"data":[0.5,[]]}}]"#);
    add(Kind::CommandFrame, r#""horizon":[{},[]]"#);
    add(Kind::CommandFrame, r#""seq":1,"mode":"nap","ttl_ms":0.25,"horizon":[{},{"":{"data":[-0.0,1e300]},"[":{}}]"#);
    for block in ["", "TkNQQg==", "TkNQQg", "TkN*"] {
        add(Kind::BulkObservation, &format!(r#""observable":"rate","block":"{block}""#));
    }
    add(Kind::SessionOpened, r#""session_id":"s","resolved":{"a":1,"b":-2},"provenance":{"seed":7}"#);
    add(Kind::StepRequest, r#""session_id":"s","stimulus":{"values":{"p":{"data":[1]}}}"#);
    add(Kind::OpenSession, r#""session_id":"s","network":{},"sim":{"mode":"dream"}"#);

    // [NCP-WIRE-007]: names that occur twice, among many, far apart, spelled otherwise.
    let many = |count: usize, name: &str| {
        let names = (0..count).map(|nth| format!(r#""m{nth}":{nth}"#));
        names.chain([format!(r#""{name}":0"#)]).collect::<Vec<_>>().join(",")
    };
    let [one, other] = OF_ONE_HASH;
    for name in ["m40", "m3", "\\u006d3"] {
        let members = many(40, name);
        add(Kind::LinkStatus, &members);
        add(Kind::LinkStatus, &format!(r#""x":[{{{members}}}]"#));
        add(Kind::OpenSession, &format!(r#""session_id":"s","network":{{"params":{{{members}}}}}"#));
    }
    add(Kind::LinkStatus, &format!(r#""{one}":1,"{other}":2"#));
    add(Kind::LinkStatus, &format!(r#""{one}":1,"{other}":2,"{one}":3"#));
    add(Kind::LinkStatus, r#""lost":1,"x":1,"lost":2"#);

    // [NCP-WIRE-064]: as deep as may be, and one level deeper.
    for levels in [MAX_LEVELS, MAX_LEVELS + 1] {
        let (open, close) = ("[".repeat(levels - 1), "]".repeat(levels - 1));
        add(Kind::SensorFrame, &format!(r#""x":{open}{close}"#));
        let (open, close) = (r#"{"":"#.repeat(levels - 1), "}".repeat(levels - 1));
        add(Kind::SensorFrame, &format!(r#""x":{open}0{close}"#));
    }

    // [NCP-WIRE-066] [NCP-WIRE-067]: as many as may be, and one more.
    for more in [0, 1] {
        let entries = |value| entries(MAX_ENTRIES + more, value);
        add(Kind::SensorFrame, &format!(r#""channels":{{{}}}"#, entries("{}")));
        let items = |item| list([item].into_iter().cycle().take(MAX_ITEMS + more));
        add(Kind::Capabilities, &format!(r#""controller_id":"c","sensor_channels":[{}]"#, items("{}")));
        add(Kind::CommandFrame, &format!(r#""horizon":[{}]"#, items("{}")));
    }
    // [NCP-WIRE-091]: a frame that its defaults make too long to be sent again.
    let items = list(["{}"].into_iter().cycle().take(MAX_ITEMS));
    let params = entries(MAX_ENTRIES, "1e15");
    let network = format!(r#""network":{{"model_name":"{}","params":{{{params}}}}}"#, "m".repeat(12_000));
    let targets = format!(r#""record":{{"targets":[{items}]}},"stimulus":{{"targets":[{items}]}}"#);
    add(Kind::OpenSession, &format!(r#""session_id":"s",{network},{targets},"bindings":[{items}]"#));
    frames
}

/// So many entries of a map, with short names that are sorted.
fn entries(count: usize, value: &str) -> String {
    list((0..count).map(|nth| format!(r#""{nth:04x}":{value}"#)))
}

fn list<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    let items: Vec<_> = items.into_iter().map(|item| item.to_string()).collect();
    items.join(",")
}
