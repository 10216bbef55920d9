//! The wire version and the contract hash, read from chapter 2 when this crate is compiled.

use crate::chapters::VERSION_AND_IDENTITY;

/// The wire version of the text. `// [NCP-VER-021]`
pub const WIRE_VERSION: &str = quoted_behind(VERSION_AND_IDENTITY.text, "The wire version of this text is `");

/// The contract hash of the text's schema. `// [NCP-VER-020]`
pub const CONTRACT_HASH: &str = quoted_behind(VERSION_AND_IDENTITY.text, "The contract hash of this text is `");

/// What stands between `lead` and the next backquote.
const fn quoted_behind(text: &'static str, lead: &str) -> &'static str {
    let behind = behind(text, lead);
    let mut end = 0;
    while behind.as_bytes()[end] != b'`' {
        end += 1;
    }
    let (quoted, _) = behind.split_at(end);
    quoted
}

/// What follows the first `lead`. A text without it does not compile.
pub(crate) const fn behind(text: &'static str, lead: &str) -> &'static str {
    let (text_bytes, lead_bytes) = (text.as_bytes(), lead.as_bytes());
    let mut start = 0;
    while !stands_at(text_bytes, lead_bytes, start) {
        start += 1;
    }
    let (_, behind) = text.split_at(start + lead_bytes.len());
    behind
}

const fn stands_at(text: &[u8], lead: &[u8], start: usize) -> bool {
    let mut at = 0;
    while at < lead.len() {
        if text[start + at] != lead[at] {
            return false;
        }
        at += 1;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Catalogue;

    /// `[NCP-VER-020] [NCP-VER-021]`
    #[test]
    fn the_rules_of_the_chapter_name_the_version_and_the_hash_that_it_states() {
        let catalogue = Catalogue::load().unwrap();
        for (rule, stated) in [("NCP-VER-020", CONTRACT_HASH), ("NCP-VER-021", WIRE_VERSION)] {
            assert!(catalogue.get(rule).unwrap().sentence.contains(&format!("`{stated}`")), "{rule}");
        }
    }
}
