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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_names_differ_in_their_last_character() {
        let [one, other] = LONG_NAMES;
        assert_eq!((one.len(), other.len()), (LENGTH, LENGTH));
        assert_eq!((one.strip_suffix('1'), one.len()), (other.strip_suffix('2'), LENGTH));
        assert!(one.ends_with('1'));
    }
}
