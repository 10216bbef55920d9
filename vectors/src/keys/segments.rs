//! Segments that are refused and segments that are not, for ids, names and realms alike.

/// A segment.
#[derive(Debug, Clone)]
pub(crate) struct Segment {
    /// Names it in a case's id.
    pub(crate) name: String,
    /// Its characters.
    pub(crate) text: String,
    /// What is special about it, as the predicate of a sentence.
    pub(crate) says: String,
    /// The rule that refuses or accepts it.
    pub(crate) rule: &'static str,
    /// The bug class.
    pub(crate) flag: &'static str,
}

/// Every way in which a segment can be wrong, one at a time.
pub(crate) fn refused() -> Vec<Segment> {
    let mut all = vec![segment("empty", "", "is empty", "NCP-KEY-010", "empty-segment")];
    let forbidden = [('/', "slash"), ('*', "star"), ('$', "dollar"), ('#', "hash"), ('?', "question-mark")];
    let spaces = [
        (' ', "space"),
        ('\t', "tab"),
        ('\n', "line-feed"),
        ('\u{b}', "vertical-tab"),
        ('\u{c}', "form-feed"),
        ('\r', "carriage-return"),
    ];
    for (c, name) in forbidden {
        all.extend(everywhere(c, name, "NCP-KEY-011", "wildcard-injection"));
    }
    for (c, name) in spaces {
        all.extend(everywhere(c, name, "NCP-KEY-012", "white-space-segment"));
    }
    all.extend([
        segment("at-first", "@a", "begins with `@`", "NCP-KEY-013", "hidden-segment"),
        segment("at-alone", "@", "is `@`", "NCP-KEY-013", "hidden-segment"),
        segment("at-twice", "@@", "is `@@`", "NCP-KEY-013", "hidden-segment"),
        // What is not of ASCII alone is looked at no less.
        segment("at-of-unicode", "@\u{e9}", "is `@\u{e9}`", "NCP-KEY-013", "hidden-segment"),
        segment("star-of-unicode", "\u{4e2d}*", "is `\u{4e2d}*`", "NCP-KEY-011", "wildcard-injection"),
        segment(
            "space-of-unicode",
            "\u{e9} \u{e9}",
            "holds U+0020 between two `\u{e9}`",
            "NCP-KEY-012",
            "white-space-segment",
        ),
        segment(
            "nul-of-unicode",
            "\u{1f681}\0",
            "ends with U+0000 behind U+1F681",
            "NCP-KEY-015",
            "control-characters",
        ),
        segment("dot", ".", "is `.`", "NCP-KEY-014", "dot-segment"),
        segment("dot-dot", "..", "is `..`", "NCP-KEY-014", "dot-segment"),
    ]);
    let controls = ('\0'..' ').chain(['\u{7f}']).filter(|c| !spaces.iter().any(|(space, _)| space == c));
    all.extend(controls.map(|c| {
        let code = u32::from(c);
        segment(
            format!("control-{code:02x}"),
            format!("a{c}b"),
            format!("holds the control character U+{code:04X}"),
            "NCP-KEY-015",
            "control-characters",
        )
    }));
    all.extend([
        segment(
            "star-last-of-256",
            "a".repeat(255) + "*",
            "ends with `*`, its 256th byte",
            "NCP-KEY-011",
            "wildcard-injection",
        ),
        segment(
            "space-last-of-256",
            "a".repeat(255) + " ",
            "ends with U+0020, its 256th byte",
            "NCP-KEY-012",
            "white-space-segment",
        ),
        segment("nul-first", "\0a", "begins with U+0000", "NCP-KEY-015", "control-characters"),
        segment("nul-last", "a\0", "ends with U+0000", "NCP-KEY-015", "control-characters"),
        segment("bytes-257", "a".repeat(257), "has 257 bytes", "NCP-KEY-017", "segment-length"),
        segment(
            "bytes-257-of-129-characters",
            "\u{e9}".repeat(128) + "a",
            "has 257 bytes in 129 characters",
            "NCP-KEY-017",
            "bytes-not-characters",
        ),
        segment(
            "bytes-258-of-86-characters",
            "\u{20ac}".repeat(86),
            "has 258 bytes in 86 characters",
            "NCP-KEY-017",
            "bytes-not-characters",
        ),
    ]);
    // What a message about them takes for a format, a template or a pattern.
    for (name, text, says) in [
        ("percent-of-257", "%s%d%n%(a)s".to_owned() + &"%".repeat(246), "has 257 bytes, among them `%s%d%n`"),
        ("braces-of-257", "{0}{a}{".to_owned() + &"{".repeat(250), "has 257 bytes, among them `{0}`"),
        ("backslashes-of-257", "\\1\\x\\u".to_owned() + &"\\".repeat(251), "has 257 bytes, among them `\\1`"),
    ] {
        all.push(segment(name, text, says, "NCP-KEY-017", "segment-length"));
    }
    all.extend(too_long().map(|(name, text, says)| segment(name, text, says, "NCP-KEY-017", "bytes-not-characters")));
    all
}

/// Segments that are just beyond the limit by their bytes alone, in characters of each length.
fn too_long() -> [(&'static str, String, &'static str); 5] {
    let of = |character: &str, times: usize, more: &str| character.repeat(times) + more;
    [
        ("bytes-258-of-129-characters", of("\u{e9}", 129, ""), "has 258 bytes in 129 characters"),
        ("bytes-257-of-86-characters", of("\u{20ac}", 85, "\u{e9}"), "has 257 bytes in 86 characters"),
        ("bytes-257-of-65-characters", of("\u{1f681}", 64, "a"), "has 257 bytes in 65 characters"),
        ("bytes-260-of-65-characters", of("\u{1f681}", 65, ""), "has 260 bytes in 65 characters"),
        ("bytes-258-decomposed", of("e\u{301}", 86, ""), "has 258 bytes, and 172 when it is composed"),
    ]
}

/// One refused segment a rule.
pub(crate) fn refused_sample() -> Vec<Segment> {
    const SAMPLE: [&str; 11] = [
        "empty",
        "slash-inside",
        "star-alone",
        "question-mark-last",
        "space-first",
        "at-first",
        "dot-dot",
        "control-00",
        "bytes-257",
        "bytes-260-of-65-characters",
        "bytes-258-decomposed",
    ];
    refused().into_iter().filter(|segment| SAMPLE.contains(&segment.name.as_str())).collect()
}

/// A few more of them for one of several roads on which nothing but the sample is asked: others for each, so that the
/// roads share the list.
pub(crate) fn refused_besides(road: usize) -> Vec<Segment> {
    const BESIDES: [[&str; 4]; 5] = [
        ["dot", "dollar-inside", "tab-inside", "control-7f"],
        ["dot", "hash-first", "line-feed-last", "control-1f"],
        ["dot", "dollar-alone", "carriage-return-inside", "control-01"],
        ["dot", "hash-alone", "vertical-tab-first", "control-1b"],
        ["dot", "dollar-last", "form-feed-last", "control-08"],
    ];
    let names = BESIDES.get(road % BESIDES.len()).copied().unwrap_or_default();
    refused().into_iter().filter(|segment| names.contains(&segment.name.as_str())).collect()
}

/// Control characters that a builder should refuse.
pub(crate) fn discouraged() -> Vec<Segment> {
    [('\u{80}', "80"), ('\u{85}', "85"), ('\u{9f}', "9f")]
        .into_iter()
        .map(|(c, code)| {
            let says = format!("holds the control character U+00{}", code.to_uppercase());
            segment(format!("control-{code}"), format!("a{c}b"), says, "NCP-KEY-016", "control-characters")
        })
        .collect()
}

/// Segments that look wrong and are not.
pub(crate) fn accepted() -> Vec<Segment> {
    let table = [
        ("one-letter", "a", "is one letter", "over-strict"),
        ("capitals", "UAV3", "is in capitals", "changed-segments"),
        ("digits", "007", "is made of digits", "changed-segments"),
        ("punctuation", "-_~!'()+,:;=&%^|", "is punctuation", "over-strict"),
        ("brackets", "{a}[b]<c>", "holds brackets", "over-strict"),
        ("quotes", "a\"b\\c`", "holds quotes and a backslash", "raw-names"),
        ("percent-escape", "%2F%2a", "holds what looks like percent escapes", "changed-segments"),
        ("dots-within", "a.b..c", "holds dots", "dot-segment"),
        ("three-dots", "...", "is three dots", "dot-segment"),
        ("dot-first", ".a", "begins with a dot", "dot-segment"),
        ("at-inside", "a@b", "holds `@` inside", "hidden-segment"),
        ("at-last", "a@", "ends with `@`", "hidden-segment"),
        ("latin", "caf\u{e9}", "is not in ASCII", "changed-segments"),
        ("decomposed", "cafe\u{301}", "is not in a composed normal form", "changed-segments"),
        ("mark-first", "\u{301}front", "begins with a combining mark", "over-strict"),
        ("joiner-first", "\u{200d}a", "begins with a zero-width joiner", "over-strict"),
        ("selector-first", "\u{fe0f}a", "begins with a variation selector", "over-strict"),
        ("direction-first", "\u{202e}a", "begins with U+202E, which turns the direction", "over-strict"),
        ("unassigned", "\u{378}", "is a code point that is not assigned", "over-strict"),
        ("cyrillic", "\u{434}\u{440}\u{43e}\u{43d}", "is Cyrillic", "changed-segments"),
        ("han", "\u{65e0}\u{4eba}\u{673a}", "is Han", "changed-segments"),
        ("right-to-left", "\u{5e2}\u{5d1}", "is Hebrew", "changed-segments"),
        ("emoji", "\u{1f681}", "is a character beyond the BMP", "changed-segments"),
        ("no-break-space", "a\u{a0}b", "holds U+00A0, which is no ASCII white space", "white-space-segment"),
        ("em-space", "\u{2003}", "is U+2003, which is no ASCII white space", "white-space-segment"),
        ("line-separator", "a\u{2028}b", "holds U+2028, which is no ASCII white space", "white-space-segment"),
        ("zero-width-space", "a\u{200b}", "ends with U+200B", "changed-segments"),
        ("last-of-the-bmp", "a\u{ffff}", "ends with U+FFFF", "over-strict"),
        ("byte-order-swapped", "\u{fffe}a", "begins with U+FFFE", "over-strict"),
        ("noncharacter", "a\u{fdd0}b", "holds U+FDD0", "over-strict"),
        ("last-of-all", "\u{10ffff}", "is U+10FFFF", "over-strict"),
        ("private", "\u{e000}", "is U+E000", "over-strict"),
        ("byte-order-mark", "\u{feff}a", "begins with U+FEFF", "changed-segments"),
        ("replacement", "a\u{fffd}", "ends with U+FFFD", "changed-segments"),
        ("full-width-star", "\u{ff0a}", "is a full-width star", "wildcard-injection"),
        ("full-width-at", "\u{ff20}a", "begins with a full-width at sign", "hidden-segment"),
        ("keyword", "session", "is `session`", "over-strict"),
        ("prototype", "__proto__", "is `__proto__`", "prototype-names"),
    ];
    let mut all: Vec<Segment> = table
        .into_iter()
        .chain(SPELLED.map(|(name, text, says)| (name, text, says, "changed-segments")))
        .map(|(name, text, says, flag)| segment(name, text, says, "NCP-KEY-020", flag))
        .collect();
    all.extend([
        segment("bytes-256", "a".repeat(256), "has 256 bytes", "NCP-KEY-020", "segment-length"),
        segment(
            "bytes-256-of-128-characters",
            "\u{e9}".repeat(128),
            "has 256 bytes in 128 characters",
            "NCP-KEY-020",
            "bytes-not-characters",
        ),
        segment(
            "bytes-256-of-64-characters",
            "\u{1f681}".repeat(64),
            "has 256 bytes in 64 characters",
            "NCP-KEY-020",
            "bytes-not-characters",
        ),
        segment(
            "bytes-255-of-85-characters",
            "\u{20ac}".repeat(85),
            "has 255 bytes in 85 characters",
            "NCP-KEY-020",
            "bytes-not-characters",
        ),
        segment(
            "bytes-256-of-86-characters",
            "\u{20ac}".repeat(85) + "a",
            "has 256 bytes in 86 characters",
            "NCP-KEY-020",
            "bytes-not-characters",
        ),
        segment(
            "bytes-255-longer-composed",
            "\u{958}".repeat(85),
            "has 255 bytes, and 510 in a composed normal form",
            "NCP-KEY-020",
            "bytes-not-characters",
        ),
    ]);
    all
}

/// Segments that read as something that has another spelling as well: each stays as it is.
const SPELLED: [(&str, &str, &str); 21] = [
    ("uuid-in-capitals", "6BA7B810-9DAD-11D1-80B4-00C04FD430C8", "is a UUID in capitals"),
    ("uuid-without-hyphens", "6ba7b8109dad11d180b400c04fd430c8", "is a UUID without hyphens"),
    ("uuid-in-braces", "{6ba7b810-9dad-11d1-80b4-00c04fd430c8}", "is a UUID in braces"),
    ("uuid-as-a-urn", "urn:uuid:6ba7b810-9dad-11d1-80b4-00c04fd430c8", "is a UUID as a URN"),
    ("address-with-zeros", "2001:0DB8:0:0::1", "is an IPv6 address with zeros that may be left out"),
    ("address-of-octets", "010.0.0.001", "is an IPv4 address with leading zeros"),
    ("host-with-a-dot", "UAV3.Local.", "is the name of a host with a dot at its end"),
    ("integer-with-a-sign", "+7", "is an integer with a sign"),
    ("number-with-zeros", "1.50e03", "is a number with zeros that may be left out"),
    ("number-in-hex", "0x1F", "is a number in hexadecimal digits"),
    ("minus-zero", "-0", "is minus zero"),
    ("zero", "0", "is zero"),
    ("zeros", "000", "is made of zeros"),
    ("dot-and-a-space", ".\u{a0}", "is a dot and U+00A0"),
    ("space-and-dots", "\u{2003}..", "is U+2003 and two dots"),
    ("wide-space-and-a-dot", "\u{3000}.\u{3000}", "is a dot between U+3000"),
    ("time", "2026-01-02T03:04:05.600+00:00", "is a time with an offset"),
    ("base64-with-padding", "YQ==", "is Base64 with padding"),
    ("entity", "a&amp;b", "holds an entity of HTML"),
    ("escape-of-json", "a\\u0041", "holds what looks like an escape of JSON"),
    ("plus", "a+b", "holds a plus sign, which some take for a space"),
];

/// A few of them.
pub(crate) fn accepted_sample() -> Vec<Segment> {
    const SAMPLE: [&str; 7] = [
        "three-dots",
        "zero",
        "at-inside",
        "decomposed",
        "no-break-space",
        "bytes-256-of-128-characters",
        "bytes-256-of-64-characters",
    ];
    accepted().into_iter().filter(|segment| SAMPLE.contains(&segment.name.as_str())).collect()
}

/// A forbidden character at every position.
fn everywhere(c: char, name: &str, rule: &'static str, flag: &'static str) -> [Segment; 4] {
    let shown = if c.is_control() || c == ' ' { format!("U+{:04X}", u32::from(c)) } else { format!("`{c}`") };
    [
        segment(format!("{name}-first"), format!("{c}a"), format!("begins with {shown}"), rule, flag),
        segment(format!("{name}-inside"), format!("a{c}b"), format!("holds {shown} inside"), rule, flag),
        segment(format!("{name}-last"), format!("a{c}"), format!("ends with {shown}"), rule, flag),
        segment(format!("{name}-alone"), c.to_string(), format!("is {shown}"), rule, flag),
    ]
}

fn segment(
    name: impl Into<String>,
    text: impl Into<String>,
    says: impl Into<String>,
    rule: &'static str,
    flag: &'static str,
) -> Segment {
    Segment { name: name.into(), text: text.into(), says: says.into(), rule, flag }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_of_a_sample_is_the_name_of_a_segment() {
        assert_eq!(refused_sample().len(), 11);
        assert_eq!(accepted_sample().len(), 7);
        assert!((0..5).all(|road| refused_besides(road).len() == 4));
    }

    #[test]
    fn the_lengths_are_what_the_names_say() {
        for segment in refused().into_iter().chain(accepted()) {
            if let Some(bytes) = segment.name.strip_prefix("bytes-") {
                let bytes = bytes.split('-').next().unwrap();
                assert_eq!(segment.text.len().to_string(), bytes, "{}", segment.name);
            }
        }
    }
}
