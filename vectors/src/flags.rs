//! The bug classes that cases are flagged with, each explained once.

/// What a flag says: the bug class that its cases catch, in one sentence.
pub(crate) fn note(flag: &str) -> &'static str {
    NOTES
        .binary_search_by_key(&flag, |(known, _)| known)
        .map_or("", |at| NOTES[at].1)
}

/// The bug class of a case that names none: what breaks the rule that it is about, or else what a failure of the file's
/// cases comes from.
pub(crate) fn usual(area: &str, name: &str, rule: &str) -> Option<&'static str> {
    by_rule(rule).or_else(|| by_file(area, name))
}

/// The audited finding or the bug class that a rule answers.
fn by_rule(rule: &str) -> Option<&'static str> {
    Some(match rule {
        "NCP-CODEC-005" => "L06",
        "NCP-CODEC-006" => "missing-population",
        "NCP-CODEC-007" => "degenerate-range",
        "NCP-CODEC-002" | "NCP-CODEC-004" => "unclamped-codec",
        "NCP-CODEC-008" | "NCP-CODEC-010" => "mapping-components",
        "NCP-CODEC-009" => "lost-fields",
        "NCP-CODEC-020" | "NCP-CTRL-002" => "program-defaults",
        "NCP-CTRL-003" => "L03",
        "NCP-CTRL-005" | "NCP-RES-051" | "NCP-RES-052" => "misread-settings",
        "NCP-CTRL-010" => "missing-period",
        "NCP-CTRL-015" | "NCP-CTRL-018" | "NCP-CTRL-021" => "ungoverned-command",
        "NCP-RES-002" | "NCP-RES-006" => "stale-setpoint",
        "NCP-RES-003" | "NCP-SAFE-034" | "NCP-SAFE-045" => "off-by-a-boundary",
        "NCP-RES-008" | "NCP-SAFE-035" => "L14",
        "NCP-RES-009" => "refreshed-deadline",
        "NCP-RES-010" => "reviving-hold",
        "NCP-RES-011" | "NCP-RES-031" => "reviving-reset",
        "NCP-RES-020" => "revived-command",
        "NCP-RES-023" => "lost-hold",
        "NCP-RES-027" => "L27",
        "NCP-SAFE-001" => "unknown-mode-moves",
        "NCP-SAFE-004" | "NCP-SAFE-005" | "NCP-SAFE-006" => "lost-estop",
        "NCP-SAFE-012" => "L13",
        "NCP-SAFE-030" | "NCP-SAFE-033" => "stale-sensor",
        "NCP-SAFE-040" => "L03",
        "NCP-SAFE-051" => "short-look-ahead",
        "NCP-SAFE-063" => "L11",
        "NCP-SAFE-068" => "L27",
        "NCP-SESS-020" | "NCP-SESS-021" | "NCP-SESS-022" => "unanswered-requests",
        "NCP-SESS-032" => "unchecked-durations",
        "NCP-SESS-035" => "mixed-sessions",
        _ => return None,
    })
}

fn by_file(area: &str, name: &str) -> Option<&'static str> {
    Some(match (area, name) {
        ("codec", _) => "codec-arithmetic",
        ("control", "loop") => "loop-contract",
        ("control", _) => "reflex-law",
        ("resilience", "horizon") => "wrong-tick",
        ("resilience", "horizon_length") => "horizon-length",
        ("resilience", _) => "liveness",
        ("safety", "gates") => "gate-order",
        ("safety", "latch") => "latch-transitions",
        ("safety", "zeroing") => "wrong-hold-frame",
        ("safety", _) => "governor-decision",
        ("session", "reference") => "reference-numbers",
        ("session", _) => "session-lifecycle",
        _ => return None,
    })
}

/// Sorted by flag.
const NOTES: &[(&str, &str)] = &[
    (
        "L01",
        "Audited finding L01: columns that share bytes multiply the memory that decoding takes.",
    ),
    (
        "L02",
        "Audited finding L02: an unbounded ttl keeps a plant moving for as long as a sender likes.",
    ),
    (
        "L03",
        "Audited finding L03: a position that is empty or missing counts as the origin.",
    ),
    (
        "L04",
        "Audited finding L04: one control key for all requests, so that no access rule can tell them apart.",
    ),
    (
        "L06",
        "Audited finding L06: a sensor that is missing is encoded as an extreme rate.",
    ),
    (
        "L07",
        "Audited finding L07: a frame without a version, or with another, is taken for one of the own version.",
    ),
    (
        "L08",
        "Audited finding L08: frames without a stamp pass by the check of their order.",
    ),
    (
        "L09",
        "Audited finding L09: the arithmetic of the link monitor overflows on seqs of both signs.",
    ),
    (
        "L10",
        "Audited finding L10: the unit of a channel is never held against the unit of its limit.",
    ),
    (
        "L11",
        "Audited finding L11: the width of a vector is never checked.",
    ),
    (
        "L12",
        "Audited finding L12: an infinite ttl switches the watchdog off.",
    ),
    (
        "L13",
        "Audited finding L13: a limit that is not a number, or 0, means something else than it says.",
    ),
    (
        "L14",
        "Audited finding L14: a clock that steps backward makes what is old look fresh.",
    ),
    (
        "L15",
        "Audited finding L15: a negative limit switches its enforcement off.",
    ),
    (
        "L21",
        "Audited finding L21: an encoder cuts a count or a length to the width of its field.",
    ),
    (
        "L22",
        "Audited finding L22: a realm goes into a key unchecked.",
    ),
    (
        "L24",
        "Audited finding L24: a key builder crashes on a segment that it should refuse.",
    ),
    (
        "L25",
        "Audited finding L25: a sender's time is compared with another peer's clock.",
    ),
    (
        "L27",
        "Audited finding L27: the length of a horizon saturates or crashes on numbers that are no durations.",
    ),
    (
        "L28",
        "Audited finding L28: the geofence is taken for another shape than a sphere about the frame's origin.",
    ),
    (
        "absent-mode-moves",
        "A command without a mode moves the plant, because the receiver fills in what a program would.",
    ),
    (
        "alignment",
        "A reader casts bytes in place and fails, or reads other values, where a column is not aligned.",
    ),
    (
        "allocation-by-claim",
        "Memory is reserved for as many rows as the directory claims, before the claim is checked.",
    ),
    (
        "amplification",
        "A small input takes many times its size in memory.",
    ),
    (
        "burst-detector",
        "The detector of bursts rises, falls or saturates in another way than the text says.",
    ),
    (
        "byte-order",
        "Multi-byte values are read or written in the machine's order instead of little-endian.",
    ),
    (
        "byte-order-mark",
        "A byte order mark is skipped in silence, or counted as white space.",
    ),
    (
        "bytes-not-characters",
        "A limit in bytes is applied to characters or UTF-16 units.",
    ),
    (
        "bytes-outside-the-object",
        "The bytes of white space around the object do not count for its limit.",
    ),
    (
        "case-folded-kinds",
        "Kinds are compared without regard to case.",
    ),
    (
        "case-folded-names",
        "Member names are compared without regard to case or punctuation.",
    ),
    (
        "changed-segments",
        "A name is normalised, decoded, trimmed or changed in case on its way.",
    ),
    (
        "closed-enums",
        "A descriptive enum that does not know a value costs the whole frame, so that no later value can be added.",
    ),
    (
        "closed-objects",
        "Unknown members cost the whole frame, or change what it means.",
    ),
    (
        "codec-arithmetic",
        "The linear map of the rate codec, its clamp, its middle or its choice of mapping is wrong.",
    ),
    (
        "column-order",
        "Columns come back in the order of a map instead of the directory's.",
    ),
    (
        "contract-matching",
        "Contract hashes are compared loosely: by a prefix, without regard to case, trimmed, or as numbers.",
    ),
    ("control-characters", "Control characters pass into a key."),
    (
        "cut-names",
        "A name is cut at its first U+0000, or its length is read with too few bits.",
    ),
    (
        "degenerate-range",
        "A range without length divides by zero, or gives an end instead of the middle.",
    ),
    (
        "dot-segment",
        "The segments `.` and `..` are resolved like a path, or refused where they are only a part.",
    ),
    (
        "duplicate-columns",
        "Of two columns of one name one is lost in silence.",
    ),
    (
        "duplicate-members",
        "Of two members of one name one is lost in silence, so that two receivers can read one frame differently.",
    ),
    (
        "empty-blocks",
        "A block or a column without content is taken for a broken one.",
    ),
    (
        "empty-input",
        "Empty input crashes the decoder, or reads as an empty message.",
    ),
    (
        "empty-segment",
        "An empty segment makes a key of another meaning.",
    ),
    (
        "enum-constants",
        "Enums travel as the constants or the numbers of the proto instead of the wire strings.",
    ),
    (
        "exponents",
        "Spellings with an exponent or trailing zeros are refused, or an exponent overflows.",
    ),
    (
        "field-order",
        "Fields are written in the order in which they were set, or sorted by name.",
    ),
    (
        "filled-in-contract-hash",
        "A receiver fills its own hash into a frame that has none, and then finds that it matches.",
    ),
    (
        "first-channel",
        "A limit acts on the first channel, or on one of a like name, instead of the canonical one.",
    ),
    (
        "fixed-layout",
        "A reader expects names and data where encoders put them, instead of where the directory says.",
    ),
    (
        "gate-order",
        "The gates of the governor stand in another order, so that a latch is lost or made in vain.",
    ),
    (
        "governor-decision",
        "The governor passes what it has to hold, or holds what it has to pass.",
    ),
    ("guessed-encodings", "A decoder guesses UTF-16 or UTF-32."),
    (
        "hidden-segment",
        "Segments that begin with `@`, which Zenoh hides from wildcards, are used or matched like others.",
    ),
    (
        "horizon-length",
        "The length of a horizon is counted wrongly from the ttl and the tick.",
    ),
    (
        "horizon-past-the-fence",
        "A horizon is not projected, or not step by step.",
    ),
    (
        "integer-precision",
        "Integers pass through a double or wrap, and come out as other integers.",
    ),
    (
        "integer-spelled-doubles",
        "A double that is spelled like an integer is refused, or read as an integer of limited width.",
    ),
    (
        "integer-spelling",
        "Integers are written as strings, with a fraction, or with an exponent.",
    ),
    (
        "invalid-expressions",
        "What is no key expression is matched as if it were one.",
    ),
    (
        "invalid-utf8",
        "Bytes that are no UTF-8 are replaced, kept or skipped instead of refused.",
    ),
    (
        "invented-sentinel",
        "A peer replaces a value that it does not know by a placeholder of its own.",
    ),
    (
        "kind-confusion",
        "A frame is decoded as the kind that was expected, whatever it says that it is.",
    ),
    (
        "kind-matching",
        "Kinds are matched by a prefix, a default or another name.",
    ),
    (
        "largest-double",
        "The largest doubles overflow, or round to infinity.",
    ),
    (
        "last-to-arrive",
        "The loop takes the last frame to arrive for the newest.",
    ),
    (
        "latch-by-likeness",
        "A frame that only looks like an ESTOP latches.",
    ),
    (
        "latch-transitions",
        "A latch is set, kept or cleared by the wrong event.",
    ),
    (
        "leading-input",
        "A decoder searches for the object and skips what stands before it.",
    ),
    (
        "lenient-grammar",
        "A decoder reads a dialect of JSON, such as JSON5 or a programming language's literals.",
    ),
    (
        "lenient-integers",
        "Integer fields take numbers that are spelled as fractions or with an exponent.",
    ),
    (
        "lenient-numbers",
        "Numbers are read by a general conversion routine, which takes more spellings than JSON has.",
    ),
    (
        "lenient-sim-mode",
        "An unknown simulation mode is replaced by a default, and another simulation runs than was asked for.",
    ),
    (
        "lenient-strings",
        "Strings take raw control characters, or escapes that JSON does not have.",
    ),
    (
        "lenient-versions",
        "Versions are read by a general conversion routine or a pattern without ends.",
    ),
    (
        "literal-patterns",
        "Characters that are special to regular expressions or file patterns are special in key expressions.",
    ),
    (
        "liveness",
        "The plant moves, or holds, where the liveness rule says otherwise.",
    ),
    (
        "lone-surrogates",
        "Half a surrogate pair becomes a string that has no UTF-8 form.",
    ),
    (
        "loop-contract",
        "The control loop starts, governs or reports otherwise than it has to.",
    ),
    (
        "lossy-blocks",
        "Columns do not come back from a block as they went in.",
    ),
    (
        "lossy-doubles",
        "Doubles lose bits, the sign of a zero, or a NaN on their way.",
    ),
    (
        "lost-estop",
        "An ESTOP does not latch, or its latch ends without a reset.",
    ),
    (
        "lost-fields",
        "A field is not read, or comes back as another value.",
    ),
    (
        "lost-hold",
        "A HOLD does not take effect, or is undone by an older command.",
    ),
    (
        "low-limits",
        "A limit is lower than the text's, so that a correct frame is refused.",
    ),
    (
        "malformed-moves",
        "A part of a frame that is rejected takes effect.",
    ),
    (
        "many-digits",
        "A conversion routine looks only at the first digits of a long number.",
    ),
    (
        "map-order",
        "Map entries are written as inserted, or sorted by UTF-16 units, by number or without regard to case.",
    ),
    (
        "mapping-components",
        "A component that no mapping names, or one that a mapping names out of bounds, is made up or lost.",
    ),
    (
        "misread-settings",
        "A setting that cannot be used is used as it is.",
    ),
    ("missing-limits", "A limit of the text is not kept."),
    (
        "missing-period",
        "The loop starts without a period by which it could keep time.",
    ),
    (
        "missing-population",
        "A population that is absent, or whose rate is no number, decodes to an end of the range.",
    ),
    (
        "mixed-sessions",
        "What is done to one session changes another.",
    ),
    (
        "moving-hold",
        "A HOLD or ESTOP frame leaves a channel as it was, or loses one.",
    ),
    (
        "narrow-integers",
        "Integers are read with another width or signedness, or as doubles.",
    ),
    (
        "negotiation-by-hash",
        "A matching contract hash lets an incompatible version pass.",
    ),
    (
        "nested-stimulus",
        "A stimulus frame within a request is not held against the request, or must repeat what the request says.",
    ),
    (
        "non-finite-clock",
        "A clock reading that is no number passes a comparison.",
    ),
    (
        "non-finite-command",
        "A component that is no number reaches the plant.",
    ),
    (
        "non-finite-literals",
        "Literals such as `NaN` are read as numbers.",
    ),
    (
        "non-finite-numbers",
        "A non-finite number is written as null, as a word, or as another number.",
    ),
    (
        "non-finite-position",
        "A position that is no number passes for one inside the fence.",
    ),
    ("nul-terminated-names", "A string ends at its first U+0000."),
    (
        "null-as-default",
        "A null in a field that is not optional reads as its default.",
    ),
    (
        "null-optional",
        "A null in an optional field is refused, or is another thing than absence.",
    ),
    (
        "off-by-a-boundary",
        "A comparison includes its boundary where it must not, or the other way round.",
    ),
    (
        "omitted-fields",
        "Fields that have their default are not written.",
    ),
    ("omitted-nulls", "Unset optional fields are not written."),
    ("over-strict", "What the text allows is refused."),
    (
        "overflow",
        "A number beyond a double becomes infinite, or the largest double, in silence.",
    ),
    (
        "overflowing-norm",
        "A norm that overflows a double becomes NaN, or passes for a small one.",
    ),
    (
        "overflowing-tick",
        "A quotient beyond every integer wraps or crashes.",
    ),
    (
        "overlapping-regions",
        "Regions of a block that share bytes are not detected.",
    ),
    (
        "partial-wildcards",
        "`$*` is not read, crosses a chunk, or needs at least one character.",
    ),
    (
        "per-axis-clamp",
        "A speed is clamped axis by axis, which bounds another norm and turns the vector.",
    ),
    (
        "positional-structs",
        "A message is read from an array of its fields, or a scalar is taken for one.",
    ),
    (
        "program-defaults",
        "What a program gets without naming it is mistaken for what a receiver reads.",
    ),
    (
        "proto-json-names",
        "The names and wrappers of Protobuf's own JSON mapping are used instead of NCP's.",
    ),
    (
        "prototype-names",
        "Names such as `__proto__` reach the prototype of an object instead of its members.",
    ),
    (
        "raw-names",
        "Names are compared or written as they are spelled, without their escapes resolved.",
    ),
    (
        "reference-numbers",
        "The reference networks are integrated, driven or sampled wrongly.",
    ),
    (
        "reflex-law",
        "The law of the reflex controller, its defaults or its fail-safe is wrong.",
    ),
    (
        "refreshed-deadline",
        "A command that does not advance refreshes the deadline.",
    ),
    (
        "revived-command",
        "A command that is stale, a duplicate or reordered is acted upon.",
    ),
    ("reviving-hold", "A hold ends without an advancing command."),
    ("reviving-reset", "A reset sets the plant moving again."),
    (
        "rounding",
        "A decimal number does not become the nearest double, ties to even.",
    ),
    (
        "sampled-link",
        "The link monitor sees only the frames that a tick samples.",
    ),
    (
        "segment-length",
        "The limit of a segment is missing, one off, or applied to the whole key.",
    ),
    (
        "session-lifecycle",
        "A session is opened, stepped or closed when it must not be, or not when it must.",
    ),
    (
        "seventeen-digits",
        "A double that needs seventeen digits loses its last bit.",
    ),
    (
        "short-look-ahead",
        "The governor looks less far ahead than the plant may go.",
    ),
    (
        "short-ttl",
        "A command may expire before the next tick can renew it.",
    ),
    ("signed-zero", "The negative zero loses its sign."),
    ("slow", "Not a bug class: the input has tens of megabytes."),
    ("stack-overflow", "Deep nesting ends the process."),
    (
        "stale-sensor",
        "A sensor that is too old, or of which nothing is known, passes for a fresh one.",
    ),
    (
        "stale-setpoint",
        "A setpoint outlives its ttl, or moves a plant before any command came.",
    ),
    (
        "string-escapes",
        "Escapes are read or written wrongly, or characters that need none are refused.",
    ),
    (
        "stringly-numbers",
        "Numbers are read from strings, as Protobuf's own JSON mapping does.",
    ),
    ("subnormals", "Subnormal numbers are flushed to zero."),
    (
        "swallowed-failures",
        "A client takes a failure for a success.",
    ),
    (
        "top-level-values",
        "A top-level value that is no object crashes the decoder or reads as an empty message.",
    ),
    (
        "trailing-input",
        "A decoder stops at the end of the first object and ignores the rest.",
    ),
    (
        "trimmed-kinds",
        "Kinds are trimmed before they are compared.",
    ),
    (
        "trimmed-names",
        "Member names are trimmed before they are compared.",
    ),
    (
        "truncated-counts",
        "A count or a length is cut to the width of its field.",
    ),
    (
        "truncated-input",
        "Input that is cut off is read as far as it goes, or crashes the decoder.",
    ),
    (
        "trusted-lengths",
        "A length or an offset of the input is used without being checked.",
    ),
    (
        "truthy-booleans",
        "Booleans are read from strings or numbers.",
    ),
    (
        "truthy-pins",
        "A pin is tested for truth instead of for its exact value.",
    ),
    ("ttl-without-time", "A ttl that is no time counts as one."),
    (
        "unanswered-requests",
        "A request that cannot be read gets no reply, two, or one that is no error frame.",
    ),
    (
        "unbounded-work",
        "A gap makes as many updates or memories as it is long.",
    ),
    (
        "unchecked-dtypes",
        "A column of another dtype is reinterpreted or converted in silence.",
    ),
    (
        "unchecked-durations",
        "A time that is negative or no number is simulated.",
    ),
    (
        "unchecked-header",
        "A field of a block that has one allowed value is not checked.",
    ),
    (
        "unchecked-pins",
        "An epistemic pin is not checked, or not written.",
    ),
    (
        "unchecked-replies",
        "A client takes whatever comes back for the reply to its request.",
    ),
    (
        "unchecked-reply-version",
        "A client does not hold a reply's version against its own.",
    ),
    (
        "unchecked-required",
        "A required field that is absent reads as an empty value.",
    ),
    (
        "unchecked-session-id",
        "A session id from which no key can be built is accepted.",
    ),
    (
        "unchecked-types",
        "A value of another JSON type is converted or dropped in silence.",
    ),
    (
        "unclamped-codec",
        "A value beyond its range leaves the codec beyond the other range.",
    ),
    ("unclamped-horizon", "The speed limit acts on tick 0 only."),
    (
        "underflow",
        "A number too small for a subnormal is refused, or loses its sign.",
    ),
    (
        "uneven-arrays",
        "Arrays that must agree in length are cut or padded to do so.",
    ),
    (
        "ungoverned-command",
        "A command passes by the governor, or what the governor did is not told.",
    ),
    (
        "unknown-mode-moves",
        "A mode that is not known moves the plant, or costs the frame.",
    ),
    (
        "unwrapped-horizon",
        "A step of a horizon is unwrapped as if it were the proto's.",
    ),
    (
        "version-arithmetic",
        "Versions are compared as texts or decimals, or with the rules of another scheme.",
    ),
    (
        "version-in-decoder",
        "Decoding changes the version, or refuses one that is compatible.",
    ),
    (
        "version-overflow",
        "Large version numbers wrap, round or crash.",
    ),
    (
        "white-space-segment",
        "White space passes into a key, or characters that are none in ASCII are refused.",
    ),
    (
        "wildcard-injection",
        "A wildcard or a separator passes into a key and widens it.",
    ),
    (
        "wildcards",
        "`*` or `**` covers too many chunks, or too few.",
    ),
    (
        "wrapping-offsets",
        "The sum or product of offsets and lengths wraps, and passes the check.",
    ),
    (
        "wrong-defaults",
        "An absent field reads as another value than its default.",
    ),
    (
        "wrong-hold-frame",
        "A HOLD or ESTOP frame loses what it has to keep, or keeps what it has to lose.",
    ),
    (
        "wrong-key",
        "A key is built in another form, and meets nobody.",
    ),
    (
        "wrong-loss",
        "Losses are counted at another time or another number of times.",
    ),
    (
        "wrong-qos",
        "A plane has another quality of service than the one that it needs.",
    ),
    (
        "wrong-tick",
        "The replay is one tick off, or goes on past its end.",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_notes_are_sorted_so_that_each_is_found() {
        assert!(NOTES.is_sorted_by_key(|(flag, _)| flag));
        assert!(
            NOTES
                .iter()
                .all(|(flag, text)| note(flag) == *text && text.ends_with('.'))
        );
    }
}
