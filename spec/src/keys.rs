//! Keys, their segments and their matching (chapters 3.2 to 3.4).

use thiserror::Error;

use ncp_spec::ErrorCode;
use ncp_spec::wire::Kind;

/// The realm that is meant when none is named. `// [NCP-KEY-006]`
pub const DEFAULT_REALM: &str = "ncp";

/// The longest segment, in bytes of UTF-8 (`NCP-KEY-017`).
pub const MAX_SEGMENT_BYTES: usize = 256;

/// Builds the keys of one realm.
///
/// Every part goes into the key unchanged, or is refused. `// [NCP-KEY-007] [NCP-KEY-019]`
///
/// ```
/// use ncp_spec::keys::{Keys, matches};
///
/// let keys = Keys::new(Some("engram/ncp"))?;
/// let front = keys.sensor("uav3", Some("front"))?;
/// assert_eq!(front, "engram/ncp/session/uav3/sensor/front");
/// assert!(matches(&keys.sensor_glob("uav3")?, &front)?);
/// assert!(keys.command("uav/3", None).is_err());
/// # Ok::<(), ncp_spec::keys::KeyError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Keys {
    realm: String,
}

impl Keys {
    /// The keys of `realm`, or of [`DEFAULT_REALM`].
    ///
    /// # Errors
    ///
    /// A realm that [`validate_realm`] refuses.
    pub fn new(realm: Option<&str>) -> Result<Self, KeyError> {
        let realm = realm.unwrap_or(DEFAULT_REALM);
        validate_realm(realm)?;
        Ok(Self { realm: realm.to_owned() })
    }

    /// The realm.
    #[must_use]
    pub fn realm(&self) -> &str {
        &self.realm
    }

    /// `{realm}/rpc`, the control plane. `// [NCP-KEY-001]`
    ///
    /// # Errors
    ///
    /// None today; the signature is that of the other builders.
    pub fn rpc(&self) -> Result<String, KeyError> {
        Ok(format!("{}/rpc", self.realm))
    }

    /// `{realm}/rpc/{kind}`, the strict profile's control key of one kind of request.
    /// `// [NCP-STRICT-001]`
    ///
    /// # Errors
    ///
    /// [`KeyError::NoRequest`] for a kind that is not a request's. `// [NCP-STRICT-006]`
    pub fn rpc_verb(&self, kind: Kind) -> Result<String, KeyError> {
        if kind.is_request() { Ok(format!("{}/rpc/{kind}", self.realm)) } else { Err(KeyError::NoRequest(kind)) }
    }

    /// `{realm}/session/{id}/sensor[/{name}]`, the perception plane. `// [NCP-KEY-002]`
    ///
    /// # Errors
    ///
    /// An id or a name that [`validate_segment`] refuses.
    pub fn sensor(&self, id: &str, name: Option<&str>) -> Result<String, KeyError> {
        self.stream(id, "sensor", name)
    }

    /// `{realm}/session/{id}/command[/{name}]`, the action plane. `// [NCP-KEY-003]`
    ///
    /// # Errors
    ///
    /// An id or a name that [`validate_segment`] refuses.
    pub fn command(&self, id: &str, name: Option<&str>) -> Result<String, KeyError> {
        self.stream(id, "command", name)
    }

    /// `{realm}/session/{id}/observation`, the observation plane. `// [NCP-KEY-004]`
    ///
    /// # Errors
    ///
    /// An id that [`validate_segment`] refuses.
    pub fn observation(&self, id: &str) -> Result<String, KeyError> {
        self.stream(id, "observation", None)
    }

    /// `{realm}/session/{id}/sensor/**`: all sensor streams of a session. `// [NCP-KEY-005]`
    ///
    /// # Errors
    ///
    /// An id that [`validate_segment`] refuses.
    pub fn sensor_glob(&self, id: &str) -> Result<String, KeyError> {
        Ok(self.sensor(id, None)? + "/**")
    }

    /// `{realm}/session/{id}/command/**`: all command streams of a session. `// [NCP-KEY-005]`
    ///
    /// # Errors
    ///
    /// An id that [`validate_segment`] refuses.
    pub fn command_glob(&self, id: &str) -> Result<String, KeyError> {
        Ok(self.command(id, None)? + "/**")
    }

    /// `{realm}/session/{id}/**`: all of a session. `// [NCP-KEY-005]`
    ///
    /// # Errors
    ///
    /// An id that [`validate_segment`] refuses.
    pub fn session_glob(&self, id: &str) -> Result<String, KeyError> {
        validate_segment(id)?;
        Ok(format!("{}/session/{id}/**", self.realm))
    }

    /// `{realm}/session/**`: all sessions of the realm. `// [NCP-KEY-005]`
    ///
    /// # Errors
    ///
    /// None today; the signature is that of the other builders.
    pub fn fleet_glob(&self) -> Result<String, KeyError> {
        Ok(format!("{}/session/**", self.realm))
    }

    fn stream(&self, id: &str, plane: &str, name: Option<&str>) -> Result<String, KeyError> {
        validate_segment(id)?;
        let mut key = format!("{}/session/{id}/{plane}", self.realm);
        if let Some(name) = name {
            validate_segment(name)?;
            key.push('/');
            key.push_str(name);
        }
        Ok(key)
    }
}

/// Checks an id, a name, or one part of a realm.
///
/// # Errors
///
/// [`KeyError::Segment`], which says what the segment may not be or hold.
pub fn validate_segment(segment: &str) -> Result<(), KeyError> {
    match segment_problem(segment) {
        None => Ok(()), // [NCP-KEY-020]
        Some(problem) => Err(KeyError::Segment { segment: shown(segment), problem }),
    }
}

/// Checks a realm: one segment or more, joined with `/`. `// [NCP-KEY-018]`
///
/// # Errors
///
/// [`KeyError::Segment`] for the first part that is not a valid segment.
pub fn validate_realm(realm: &str) -> Result<(), KeyError> {
    realm.split('/').try_for_each(validate_segment)
}

/// Whether a key expression covers a key, by Zenoh's rules.
///
/// Takes time within the product of the two lengths, whatever the wildcards.
///
/// # Errors
///
/// [`KeyError::Expression`] when `pattern` is not a key expression or `key` is not one without
/// wildcards. `// [NCP-KEY-036]`
pub fn matches(pattern: &str, key: &str) -> Result<bool, KeyError> {
    let refuse = |expression, problem| KeyError::Expression { expression: shown(expression), problem };
    for chunk in pattern.split('/') {
        check_chunk(chunk).map_err(|problem| refuse(pattern, problem))?;
    }
    for chunk in key.split('/') {
        check_chunk(chunk).map_err(|problem| refuse(key, problem))?;
        if chunk.contains('*') {
            return Err(refuse(key, ExpressionProblem::NotConcrete));
        }
    }
    Ok(covers(pattern, key))
}

/// Why a segment, a realm or a key expression is refused.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum KeyError {
    /// Not a valid id, name, or part of a realm.
    #[error("{segment:?} is not a valid key segment: {problem}")]
    Segment {
        /// The segment, shortened to [`KeyError::SHOWN`] characters.
        segment: String,
        /// What is wrong with it.
        problem: SegmentProblem,
    },
    /// Not a valid key expression, or a wildcard where none may be.
    #[error("{expression:?} is not a valid key expression: {problem}")]
    Expression {
        /// The expression, shortened to [`KeyError::SHOWN`] characters.
        expression: String,
        /// What is wrong with it.
        problem: ExpressionProblem,
    },
    /// A control key is asked for a kind that is not a request's (`NCP-STRICT-006`).
    #[error("{0} is not a request")]
    NoRequest(Kind),
}

impl KeyError {
    /// How many characters of what was refused an error shows at most.
    pub const SHOWN: usize = 64;

    /// Always [`ErrorCode::Key`].
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        ErrorCode::Key
    }
}

/// What is wrong with a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Error)]
pub enum SegmentProblem {
    /// It is empty (`NCP-KEY-010`).
    #[error("it is empty")]
    Empty,
    /// It holds a character with a meaning in key expressions (`NCP-KEY-011`).
    #[error("it holds {0:?}")]
    Reserved(char),
    /// It holds ASCII white space (`NCP-KEY-012`).
    #[error("it holds white space")]
    WhiteSpace,
    /// It begins with `@` (`NCP-KEY-013`).
    #[error("it begins with '@'")]
    Verbatim,
    /// It is `.` or `..` (`NCP-KEY-014`).
    #[error("it is a path's dot")]
    Dot,
    /// It holds a control character (`NCP-KEY-015`, `NCP-KEY-016`).
    #[error("it holds the control character U+{:04X}", u32::from(*.0))]
    Control(char),
    /// It has this many bytes, more than [`MAX_SEGMENT_BYTES`] (`NCP-KEY-017`).
    #[error("it has {0} bytes, more than {MAX_SEGMENT_BYTES}")]
    TooLong(usize),
}

/// What is wrong with a key expression.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Error)]
pub enum ExpressionProblem {
    /// It is empty, begins or ends with a slash, or has two in a row.
    #[error("it has an empty chunk")]
    EmptyChunk,
    /// It holds `#` or `?`.
    #[error("it holds {0:?}")]
    Reserved(char),
    /// It holds a `$` that is not followed by `*`.
    #[error("it holds a '$' without '*'")]
    LoneDollar,
    /// It holds a `*` beside other characters in a chunk.
    #[error("it holds a '*' inside a chunk")]
    StarInChunk,
    /// It is a key to be matched and has wildcards.
    #[error("a key has no wildcards")]
    NotConcrete,
}

/// What is wrong with a segment, if anything. Also decides on a frame's `session_id`.
pub(crate) fn segment_problem(segment: &str) -> Option<SegmentProblem> {
    if segment.is_empty() {
        return Some(SegmentProblem::Empty); // [NCP-KEY-010]
    }
    if segment.len() > MAX_SEGMENT_BYTES {
        return Some(SegmentProblem::TooLong(segment.len())); // [NCP-KEY-017]
    }
    if segment == "." || segment == ".." {
        return Some(SegmentProblem::Dot); // [NCP-KEY-014]
    }
    if segment.starts_with('@') {
        return Some(SegmentProblem::Verbatim); // [NCP-KEY-013]
    }
    segment.chars().find_map(|c| match c {
        '/' | '*' | '$' | '#' | '?' => Some(SegmentProblem::Reserved(c)), // [NCP-KEY-011]
        ' ' | '\t'..='\r' => Some(SegmentProblem::WhiteSpace),            // [NCP-KEY-012]
        _ if c.is_control() => Some(SegmentProblem::Control(c)),          // [NCP-KEY-015] [NCP-KEY-016]
        _ => None,
    })
}

fn check_chunk(chunk: &str) -> Result<(), ExpressionProblem> {
    if chunk.is_empty() {
        return Err(ExpressionProblem::EmptyChunk);
    }
    if let Some(reserved) = chunk.chars().find(|c| matches!(c, '#' | '?')) {
        return Err(ExpressionProblem::Reserved(reserved));
    }
    if chunk == "*" || chunk == "**" {
        return Ok(());
    }
    // Every `$` and every `*` belongs to a `$*`.
    for plain in chunk.split("$*") {
        if plain.contains('$') {
            return Err(ExpressionProblem::LoneDollar);
        }
        if plain.contains('*') {
            return Err(ExpressionProblem::StarInChunk);
        }
    }
    Ok(())
}

/// Matches chunk by chunk from the left. A `**` first covers nothing; when a later chunk does not
/// match, the last `**` covers one chunk more. Going back to an earlier `**` is never needed: what
/// it could give up, the last one can cover, and neither may cover a chunk that begins with `@`.
fn covers(pattern: &str, key: &str) -> bool {
    let mut pattern = pattern.split('/').peekable();
    let mut key = key.split('/').peekable();
    let mut retry = None;
    loop {
        if pattern.next_if_eq(&"**").is_some() {
            retry = Some((pattern.clone(), key.clone())); // [NCP-KEY-032]
            continue;
        }
        match (pattern.peek(), key.peek()) {
            (None, None) => return true,
            (Some(of_pattern), Some(of_key)) if chunk_covers(of_pattern, of_key) => {
                pattern.next();
                key.next();
            }
            _ => {
                let Some((after_wildcard, uncovered)) = &mut retry else {
                    return false;
                };
                match uncovered.next() {
                    Some(chunk) if !chunk.starts_with('@') => {} // [NCP-KEY-034]
                    _ => return false,
                }
                pattern = after_wildcard.clone();
                key = uncovered.clone();
            }
        }
    }
}

fn chunk_covers(pattern: &str, chunk: &str) -> bool {
    if pattern == chunk {
        return true; // [NCP-KEY-030] [NCP-KEY-035]
    }
    if pattern.starts_with('@') || chunk.starts_with('@') {
        return false; // [NCP-KEY-034]
    }
    if pattern == "*" {
        return true; // [NCP-KEY-031]
    }
    // [NCP-KEY-033] What stands before the first `$*` is a prefix, what stands behind the last a
    // suffix; the parts between follow each other, each as early as it can.
    let Some((prefix, others)) = pattern.split_once("$*") else {
        return false;
    };
    let (between, suffix) = others.rsplit_once("$*").unwrap_or(("", others));
    let Some(mut rest) = chunk.strip_prefix(prefix).and_then(|r| r.strip_suffix(suffix)) else {
        return false;
    };
    between.split("$*").all(|part| match rest.split_once(part) {
        Some((_, after)) => {
            rest = after;
            true
        }
        None => false,
    })
}

fn shown(text: &str) -> String {
    text.chars().take(KeyError::SHOWN).collect()
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use proptest::prelude::*;

    use super::*;

    fn problem(segment: &str) -> Option<SegmentProblem> {
        match validate_segment(segment) {
            Ok(()) => None,
            Err(KeyError::Segment { problem, .. }) => Some(problem),
            Err(other) => panic!("{other}"),
        }
    }

    #[test]
    fn the_keys_of_a_realm_are_those_of_the_text() {
        let keys = Keys::new(Some("engram/ncp")).unwrap();
        assert_eq!(keys.rpc().unwrap(), "engram/ncp/rpc");
        assert_eq!(keys.sensor("a", None).unwrap(), "engram/ncp/session/a/sensor");
        assert_eq!(keys.sensor("a", Some("imu")).unwrap(), "engram/ncp/session/a/sensor/imu");
        assert_eq!(keys.command("a", None).unwrap(), "engram/ncp/session/a/command");
        assert_eq!(keys.command("a", Some("arm")).unwrap(), "engram/ncp/session/a/command/arm");
        assert_eq!(keys.observation("a").unwrap(), "engram/ncp/session/a/observation");
        assert_eq!(keys.sensor_glob("a").unwrap(), "engram/ncp/session/a/sensor/**");
        assert_eq!(keys.command_glob("a").unwrap(), "engram/ncp/session/a/command/**");
        assert_eq!(keys.session_glob("a").unwrap(), "engram/ncp/session/a/**");
        assert_eq!(keys.fleet_glob().unwrap(), "engram/ncp/session/**");
        assert_eq!(Keys::new(None).unwrap().rpc().unwrap(), "ncp/rpc");
    }

    #[test]
    fn every_builder_refuses_a_bad_id_or_name() {
        let keys = Keys::new(None).unwrap();
        let bad = "a b";
        for built in [
            keys.sensor(bad, None),
            keys.sensor("a", Some(bad)),
            keys.command(bad, None),
            keys.command("a", Some(bad)),
            keys.observation(bad),
            keys.sensor_glob(bad),
            keys.command_glob(bad),
            keys.session_glob(bad),
            Keys::new(Some("a b")).map(|k| k.realm().to_owned()),
        ] {
            let refused = built.unwrap_err();
            assert_eq!(refused.code(), ErrorCode::Key);
            assert_eq!(refused.to_string(), r#""a b" is not a valid key segment: it holds white space"#);
        }
    }

    #[test]
    fn a_segment_may_not_be_empty_a_dot_or_hidden() {
        assert_eq!(problem(""), Some(SegmentProblem::Empty));
        assert_eq!(problem("."), Some(SegmentProblem::Dot));
        assert_eq!(problem(".."), Some(SegmentProblem::Dot));
        assert_eq!(problem("@x"), Some(SegmentProblem::Verbatim));
        for valid in ["...", ".a", "a.", "a@", "x@y"] {
            assert_eq!(problem(valid), None, "{valid}");
        }
    }

    #[test]
    fn every_ascii_character_is_judged_as_the_text_lists_it() {
        for code in 0..=0x7f_u8 {
            let c = char::from(code);
            let expected = match code {
                b'/' | b'*' | b'$' | b'#' | b'?' => Some(SegmentProblem::Reserved(c)),
                0x20 | 0x09 | 0x0a | 0x0b | 0x0c | 0x0d => Some(SegmentProblem::WhiteSpace),
                0x00..=0x1f | 0x7f => Some(SegmentProblem::Control(c)),
                _ => None,
            };
            assert_eq!(problem(&format!("a{c}b")), expected, "{code:#x}");
        }
    }

    #[test]
    fn segments_of_any_script_are_accepted_and_c1_controls_are_not() {
        for valid in ["läufer", "無人機", "дрон", "🚁", "a\u{a0}b", "\u{202e}x", "a-b_c.d:e~f"] {
            assert_eq!(problem(valid), None, "{valid}");
        }
        for c in '\u{80}'..='\u{9f}' {
            assert_eq!(problem(&format!("a{c}")), Some(SegmentProblem::Control(c)));
        }
    }

    #[test]
    fn a_segment_has_256_bytes_at_most() {
        assert_eq!(problem(&"a".repeat(256)), None);
        assert_eq!(problem(&"a".repeat(257)), Some(SegmentProblem::TooLong(257)));
        assert_eq!(problem(&"é".repeat(128)), None);
        assert_eq!(problem(&"é".repeat(129)), Some(SegmentProblem::TooLong(258)));
        assert!(validate_segment(&"a".repeat(1 << 20)).unwrap_err().to_string().len() < 200);
    }

    #[test]
    fn a_realm_is_checked_part_by_part() {
        for valid in ["ncp", "engram/ncp", "a/b/c"] {
            assert_eq!(validate_realm(valid), Ok(()));
        }
        for bad in ["", "/", "/a", "a/", "a//b", "a/ /b", "a/@b", "a/../b", "a/*", "a/**"] {
            assert!(validate_realm(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn wildcards_cover_what_the_table_of_the_text_says() {
        let covered = [
            ("ncp/session/**", "ncp/session"),
            ("ncp/session/a/sensor/**", "ncp/session/a/sensor"),
            ("ncp/session/a/sensor/**", "ncp/session/a/sensor/front"),
            ("a/*/c", "a/b/c"),
            ("**", "a/b/c"),
            ("**/c", "c"),
            ("a/**/c", "a/c"),
            ("a/**/b/**/c", "a/x/b/b/y/c"),
            ("a/**/**/c", "a/c"),
            ("a$*", "a"),
            ("a$*c", "abc"),
            ("$*b$*", "abc"),
            ("$*", "abc"),
            ("a$*$*b", "ab"),
            ("a/@x/**", "a/@x/b"),
            ("**/@x", "a/b/@x"),
        ];
        for (pattern, key) in covered {
            assert_eq!(matches(pattern, key), Ok(true), "{pattern} {key}");
        }
        let not_covered = [
            ("a", "b"),
            ("a", "a/b"),
            ("a/b", "a"),
            ("*", "a/b"),
            ("a/*", "a"),
            ("a/*/c", "a/b/b/c"),
            ("a$*a", "a"),
            ("ab$*ba", "aba"),
            ("*", "@a"),
            ("**", "a/@b"),
            ("$*", "@a"),
            ("$*a", "@a"),
            ("**/c", "@x/c"),
            ("@$*", "@a"),
        ];
        for (pattern, key) in not_covered {
            assert_eq!(matches(pattern, key), Ok(false), "{pattern} {key}");
        }
    }

    #[test]
    fn what_is_no_key_expression_is_an_error() {
        use ExpressionProblem::*;
        let bad = [
            ("", EmptyChunk),
            ("/", EmptyChunk),
            ("/a", EmptyChunk),
            ("a/", EmptyChunk),
            ("a//b", EmptyChunk),
            ("a#", Reserved('#')),
            ("a?", Reserved('?')),
            ("a$", LoneDollar),
            ("$a", LoneDollar),
            ("$$*", LoneDollar),
            ("a*", StarInChunk),
            ("***", StarInChunk),
            ("$**", StarInChunk),
            ("*$*", StarInChunk),
            ("a**b", StarInChunk),
        ];
        for (expression, problem) in bad {
            let expected = Err(KeyError::Expression { expression: expression.to_owned(), problem });
            assert_eq!(matches(expression, "a"), expected);
            assert_eq!(matches("**", expression), expected);
        }
        for wild in ["*", "**", "a/**", "a$*"] {
            let expected = Err(KeyError::Expression { expression: wild.to_owned(), problem: NotConcrete });
            assert_eq!(matches("**", wild), expected);
        }
    }

    #[test]
    fn many_wildcards_take_no_exponential_time() {
        let chunks = |n: usize, chunk: &str| vec![chunk; n].join("/");
        let key = chunks(2_000, "a");
        let pattern = format!("{}/b", chunks(1_000, "**/a"));
        let dollars = format!("{}b", "$*a".repeat(1_000));
        let began = Instant::now();
        assert_eq!(matches(&pattern, &key), Ok(false));
        assert_eq!(matches(&dollars, &"a".repeat(100_000)), Ok(false));
        assert!(began.elapsed() < Duration::from_secs(5), "{:?}", began.elapsed());
    }

    /// Chunks of a small alphabet, so that patterns and keys often meet.
    fn expression(chunk: &'static str) -> impl Strategy<Value = String> {
        proptest::collection::vec(chunk, 1..6).prop_map(|chunks| chunks.join("/"))
    }

    /// Zenoh's own judgement. It wants the expression in canonical form; its canoniser fails on
    /// repeated `$*`, so those are folded first.
    fn zenoh(pattern: &str, key: &str) -> Option<bool> {
        let canonical = |expression: &str| {
            let mut expression = expression.to_owned();
            while expression.contains("$*$*") {
                expression = expression.replace("$*$*", "$*");
            }
            zenoh_keyexpr::OwnedKeyExpr::autocanonize(expression).ok()
        };
        let (pattern, key) = (canonical(pattern)?, canonical(key)?);
        let is_concrete = !key.contains('*');
        is_concrete.then(|| pattern.includes(&key))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(8_000))]

        /// [NCP-KEY-030] [NCP-KEY-031] [NCP-KEY-032] [NCP-KEY-033] [NCP-KEY-034] [NCP-KEY-035]
        #[test]
        fn matching_agrees_with_zenoh(
            pattern in expression(r"\*|\*\*|(a|b|@|\$\*|\$\*){1,4}"),
            key in expression("[ab]{1,4}|@?[ab]{1,2}"),
        ) {
            prop_assert_eq!(matches(&pattern, &key).ok(), zenoh(&pattern, &key), "{} {}", pattern, key);
        }

        /// [NCP-KEY-036]
        #[test]
        fn validity_agrees_with_zenoh(
            pattern in "[ab*$#?/@]{0,8}",
            key in "[ab*$#?/@]{0,8}|[ab/]{1,6}",
        ) {
            prop_assert_eq!(matches(&pattern, &key).ok(), zenoh(&pattern, &key), "{} {}", pattern, key);
        }
    }

    proptest! {
        /// [NCP-KEY-002] [NCP-KEY-005] [NCP-KEY-007]
        #[test]
        fn what_the_builders_accept_is_a_key_that_the_globs_cover(id in "\\PC{0,8}", name in "\\PC{0,8}") {
            let keys = Keys::new(None).unwrap();
            if let Ok(key) = keys.sensor(&id, Some(&name)) {
                prop_assert_eq!(matches(&key, &key), Ok(true));
                prop_assert_eq!(matches(&keys.sensor_glob(&id).unwrap(), &key), Ok(true));
                prop_assert_eq!(matches(&keys.session_glob(&id).unwrap(), &key), Ok(true));
                prop_assert_eq!(matches(&keys.fleet_glob().unwrap(), &key), Ok(true));
                prop_assert_eq!(matches(&keys.command_glob(&id).unwrap(), &key), Ok(false));
            }
        }
    }
}
