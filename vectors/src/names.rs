//! Names of channels, populations, ports and columns that are hard to tell apart.

/// Two names of 1,024 characters that differ in their last.
pub(crate) const LONG_NAMES: [&str; 2] = [as_name(&ONE), as_name(&OTHER)];

const LENGTH: usize = 1_024;
static ONE: [u8; LENGTH] = ending_with(b'1');
static OTHER: [u8; LENGTH] = ending_with(b'2');

const fn ending_with(last: u8) -> [u8; LENGTH] {
    let mut name = [b'n'; LENGTH];
    name[LENGTH - 1] = last;
    name
}

const fn as_name(bytes: &'static [u8]) -> &'static str {
    match str::from_utf8(bytes) {
        Ok(name) => name,
        Err(_) => "",
    }
}

/// Names, each with those that a careless comparison takes for it: without a look at case, form, width, white space,
/// marks, what is not seen, or the spelling of a number, or by a hash of 32 bits.
const ALIKE: [(&str, &[&str]); 24] = [
    (
        "name-1",
        &[
            "name_1",
            "name.1",
            "name 1",
            "name:1",
            "name1",
            "name-01",
            "name-1.0",
            "name-\u{661}",
            "name-\u{b9}",
            "Name-1",
            "NAME-1",
            " name-1",
            "name-1 ",
            "name-1\t",
            "name-1\n",
            "name-1\0",
            "name-1\0x",
            "name-1;x",
            "name-\u{ff11}",
            "name\u{2010}1",
            "na\u{ad}me-1",
            "na\u{200d}me-1",
            "\u{feff}name-1",
            "name-1\u{fe0f}",
            "name-1\u{a0}",
            "\"name-1\"",
            "name-11",
            "name-",
            "1-name",
            "ame-1",
            "n\u{430}me-1",
        ],
    ),
    ("\u{e9}", &["e\u{301}", "e", "\u{c9}", "\\u00e9", "\u{c3}\u{a9}", "%C3%A9"]),
    ("k", &["K", "\u{212a}"]),
    ("\u{b5}", &["\u{3bc}"]),
    ("\u{c5}", &["\u{212b}", "A\u{30a}"]),
    ("ss", &["\u{df}", "\u{1e9e}"]),
    ("i", &["\u{131}", "\u{130}", "I"]),
    ("\u{3c3}", &["\u{3c2}"]),
    ("\u{10428}", &["\u{10400}", "\u{428}"]),
    (
        "6ba7b810-9dad-11d1-80b4-00c04fd430c8",
        &[
            "6BA7B810-9DAD-11D1-80B4-00C04FD430C8",
            "6ba7b8109dad11d180b400c04fd430c8",
            "{6ba7b810-9dad-11d1-80b4-00c04fd430c8}",
            "urn:uuid:6ba7b810-9dad-11d1-80b4-00c04fd430c8",
        ],
    ),
    ("2001:db8::1", &["2001:0db8::1", "2001:DB8::1", "2001:db8:0::1", "[2001:db8::1]"]),
    ("a b", &["a+b", "a%20b", "a  b", "a\tb", "a&nbsp;b"]),
    ("1", &["01", "1.0", "1e0", "+1", "0x1", "true"]),
    // By a sum times 31 (of Java), CRC-32, FNV-1a, djb2, djb2 by xor, FNV-1, sdbm, Murmur3, Jenkins' one at a time,
    // FNV-1a of 64 bits folded, and Adler-32.
    ("Aa", &["BB"]),
    ("plumless", &["buckeroo"]),
    ("costarring", &["liquid"]),
    ("at", &["c2"]),
    ("rasoyalo", &["xebaloha"]),
    ("bayamulo", &["ceyasoraba"]),
    ("pagumuxe", &["ticezomu"]),
    ("lodineha", &["haxesoraxe"]),
    ("dinekidi", &["dinesopa"]),
    ("didibalo", &["lofoloha"]),
    ("badixe", &["bafofo"]),
];

/// All of those names, and whether each is one that the others behind it are like.
pub(crate) fn alike() -> impl Iterator<Item = (&'static str, bool)> {
    ALIKE
        .into_iter()
        .flat_map(|(name, like)| std::iter::once((name, true)).chain(like.iter().map(|name| (*name, false))))
}

/// A name, and names that spell the way to a member of it, as those do who join the names on the way.
pub(crate) const PATHS: [&str; 24] = [
    "arm",
    "arm.data",
    "arm.data.0",
    "arm/data",
    "/arm/data",
    "arm:data",
    "arm::data",
    "arm->data",
    "arm_data",
    "arm-data",
    "arm data",
    "armdata",
    "arm\0data",
    "arm\u{1f}data",
    "arm[data]",
    "arm[\"data\"]",
    "arm.data[0]",
    "arm.unit",
    "arm.times",
    "data",
    "unit",
    "values.arm.data",
    "channels.arm.data",
    "$.channels.arm.data",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_are_alike_are_not_the_same() {
        let all: Vec<&str> = alike().map(|(name, _)| name).collect();
        let apart: std::collections::BTreeSet<&str> = all.iter().copied().collect();
        assert_eq!(all.len(), apart.len());
    }

    #[test]
    fn long_names_differ_in_their_last_character() {
        let [one, other] = LONG_NAMES;
        assert_eq!((one.len(), other.len()), (LENGTH, LENGTH));
        assert_eq!((one.strip_suffix('1'), one.len()), (other.strip_suffix('2'), LENGTH));
        assert!(one.ends_with('1'));
    }
}
