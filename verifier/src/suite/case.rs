//! One case.

use std::borrow::Cow;
use std::io::{self, Write};
use std::sync::Arc;

use ncp_spec::ErrorCode;
use ncp_text::catalogue::{Level, Requirement, Role};

use super::pattern::Shape;
use super::template::{KEPT_BYTES, Template};
use crate::peer::Call;

/// What not every peer of a role has, and a case may need: the peer says in `describe` whether it has it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Need {
    /// The reference networks of section 4.4 of the text.
    ReferenceNetworks,
}

impl Need {
    /// All of them.
    pub const ALL: [Self; 1] = [Self::ReferenceNetworks];

    /// As vector files and `describe` write it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::ReferenceNetworks => "reference_networks",
        }
    }

    /// Reads [`as_str`](Self::as_str).
    #[must_use]
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|need| need.as_str() == name)
    }

    /// For people.
    #[must_use]
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::ReferenceNetworks => "the reference networks of section 4.4 of the text",
        }
    }
}

/// One case: a call, and what a peer has to answer.
#[derive(Debug)]
pub struct Case {
    /// Its id, `area/file/…`.
    pub id: String,
    /// What it shows, in a sentence.
    pub title: String,
    /// The rules that it tests, never empty. It is about the first.
    pub requirements: Vec<Arc<Requirement>>,
    /// The bug classes that it catches.
    pub flags: Vec<String>,
    /// The roles that need it, never empty.
    pub roles: Vec<Role>,
    /// What a peer has to have beside a role; mostly nothing.
    pub needs: Vec<Need>,
    /// The highest level among its rules; strict where it asks by the strict profile.
    pub level: Level,
    /// Whether a failure decides the verdict: one of its rules is a MUST or MUST NOT.
    pub binding: bool,
    /// The call.
    pub call: Call,
    /// What has to come back.
    pub expect: Expect,
    /// What of it other rules decide than the one that the case is about.
    pub by: By,
    /// The ids of cases on which this one rests: when one does not pass, this one shows nothing of its own rule.
    pub rests_on: Vec<String>,
    /// From which sentence of the text the expectation follows.
    pub why: String,
    /// The vector file that holds it.
    pub file: Arc<str>,
    args: Template,
}

/// By which rules an answer is judged, where another decides than the one that the case is about.
#[derive(Debug, Default)]
pub struct By {
    /// By JSON pointers into the answer: each rule decides what is there and below. A `*` stands for any one token,
    /// and `*1-99+2` for every second number from 1 to 99.
    pub places: Vec<(String, Arc<Requirement>)>,
    /// The rule against a crash where an answer is asked for.
    pub crash: Option<Arc<Requirement>>,
    /// The rule against a refusal where a result is asked for.
    pub refusal: Option<Arc<Requirement>>,
    /// The rule of the order of members.
    pub order: Option<Arc<Requirement>>,
    /// The rule against a member that is there and was not asked for.
    pub extra: Option<Arc<Requirement>>,
    /// The rule of every other place within the answer, which is not wrong as a whole.
    pub within: Option<Arc<Requirement>>,
}

impl By {
    /// The rule that decides a place; none: the one that the case is about.
    #[must_use]
    pub fn at(&self, place: &str) -> Option<&Arc<Requirement>> {
        let holds = |at: &str| {
            let mut tokens = place.split('/');
            at.split('/').all(|wanted| tokens.next().is_some_and(|token| stands_for(wanted, token)))
        };
        let holding = self.places.iter().filter(|(at, _)| holds(at));
        let deepest = holding.max_by_key(|(at, _)| at.split('/').count()).map(|(_, rule)| rule);
        deepest.or_else(|| self.within.as_ref().filter(|_| !place.is_empty()))
    }
}

/// Whether a token of a place in `by` stands for one of the answer.
fn stands_for(wanted: &str, token: &str) -> bool {
    wanted == "*" || wanted == token || is_among(wanted, token).unwrap_or(false)
}

/// Whether a token is among the numbers of `*1-99+2`; none, where one of both says no number.
fn is_among(numbers: &str, token: &str) -> Option<bool> {
    let (first, rest) = numbers.strip_prefix('*')?.split_once('-')?;
    let (last, apart) = rest.split_once('+')?;
    let (first, last, apart) = (first.parse().ok()?, last.parse().ok()?, apart.parse().ok()?);
    let number: usize = token.parse().ok()?;
    Some((first..=last).contains(&number) && (number - first).checked_rem(apart) == Some(0))
}

/// What a peer has to answer, and by which relation the answer is compared with it.
#[derive(Debug)]
pub enum Expect {
    /// An error, whatever its code except `internal`. The code is the one that the text suggests.
    Reject(ErrorCode),
    /// A result, whatever it holds.
    Accept,
    /// A result that is equal as a JSON value.
    Json(Template),
    /// A result whose `text` is the same message.
    Message {
        /// The frame.
        text: Text,
        /// JSON pointers to what does not count.
        ignore: Vec<String>,
        /// Whether an error will do as well, unless its code is `internal`.
        or_reject: bool,
    },
    /// A result whose `text` has the same members in the same order, spelled by the rules of encoders.
    Encoding(Text),
    /// A result whose `block` is exactly these bytes.
    Bytes(Vec<u8>),
    /// A result whose `block`, read by the spec, holds exactly these columns.
    Columns(Template),
    /// A result that has a shape, as far as the shape says.
    Pattern {
        /// The shape.
        shape: Shape,
        /// By how much a number may be off, relatively, with a floor of the same size; 0: not at all.
        tolerance: f64,
        /// Whether an error will do as well, unless its code is `internal`.
        or_reject: bool,
    },
}

/// An expected frame, expanded when it is needed unless it is small.
#[derive(Debug)]
pub struct Text {
    template: Template,
    kept: Option<String>,
}

impl Case {
    /// Whether it is one of the deep set, and not of the corpus.
    #[must_use]
    pub fn is_deep(&self) -> bool {
        self.id.starts_with(super::DEEP)
    }

    /// Puts a case together.
    pub(super) fn new(parts: Parts) -> Self {
        let Parts { id, title, requirements, flags, roles, needs, call, args, expect, by, rests_on, why, file } = parts;
        let of_rules = requirements.iter().map(|rule| rule.level).max().unwrap_or(Level::Wire);
        let level = if asks_strictly(call, &args) { Level::Strict } else { of_rules };
        let binding = requirements.iter().any(|rule| rule.keyword.is_binding());
        Self {
            id,
            title,
            requirements,
            flags,
            roles,
            needs,
            level,
            binding,
            call,
            expect,
            by,
            rests_on,
            why,
            file,
            args: args.keep(),
        }
    }

    /// The request after its id: `"call":…,"args":…}`.
    #[must_use]
    pub fn body(&self) -> String {
        let mut body = Vec::with_capacity(self.request_bytes());
        self.put_body(&mut body);
        String::from_utf8(body).unwrap_or_default()
    }

    /// Appends the [body](Self::body) to what is sent.
    pub(crate) fn put_body(&self, out: &mut Vec<u8>) {
        out.extend_from_slice(b"\"call\":\"");
        out.extend_from_slice(self.call.as_str().as_bytes());
        out.extend_from_slice(b"\",\"args\":");
        out.extend_from_slice(self.args.expand().as_bytes());
        out.push(b'}');
    }

    /// What writes the request after its id, piece by piece: for one that [is large](Self::is_large).
    pub fn writer(&self) -> impl FnOnce(&mut dyn Write) -> io::Result<()> + Send + use<> {
        let (call, args) = (self.call, self.args.clone());
        move |out| {
            write!(out, "\"call\":\"{}\",\"args\":", call.as_str())?;
            args.write_to(out)?;
            out.write_all(b"}")
        }
    }

    /// The templates that a large request is made of, as the file has them.
    #[must_use]
    pub fn made_of(&self) -> Option<String> {
        self.is_large().then(|| self.args.unexpanded().to_owned())
    }

    /// About how many bytes a request of this case has.
    #[must_use]
    pub fn request_bytes(&self) -> usize {
        self.args.bytes() + 64
    }

    /// Whether its request is so large that sending it, not answering it, is what takes time: more than 64 KiB.
    #[must_use]
    pub fn is_large(&self) -> bool {
        self.args.bytes() > KEPT_BYTES
    }

    /// Whether the case concerns one of these roles.
    #[must_use]
    pub fn concerns(&self, roles: &[Role]) -> bool {
        self.roles.iter().any(|role| roles.contains(role))
    }
}

impl Text {
    /// Takes a template of a string.
    pub(crate) fn new(template: Template) -> Self {
        let kept = (template.bytes() <= KEPT_BYTES).then(|| template.text());
        Self { template, kept }
    }

    /// The frame.
    #[must_use]
    pub fn get(&self) -> Cow<'_, str> {
        match &self.kept {
            Some(text) => Cow::Borrowed(text),
            None => Cow::Owned(self.template.text()),
        }
    }
}

/// What a case is put together from.
pub(super) struct Parts {
    pub(super) id: String,
    pub(super) title: String,
    pub(super) requirements: Vec<Arc<Requirement>>,
    pub(super) flags: Vec<String>,
    pub(super) roles: Vec<Role>,
    pub(super) needs: Vec<Need>,
    pub(super) call: Call,
    pub(super) args: Template,
    pub(super) expect: Expect,
    pub(super) by: By,
    pub(super) rests_on: Vec<String>,
    pub(super) why: String,
    pub(super) file: Arc<str>,
}
/// Whether a question is one of the strict profile, which a peer of another level is not to be asked.
fn asks_strictly(call: Call, args: &Template) -> bool {
    // Within a string, the quotation marks would be escaped.
    let words: &[&str] = match call {
        Call::Decode | Call::ReplyCheck | Call::BufferRun => &["\"strict\":true"],
        Call::SessionRun => &["\"strict\":true", "\"verbs\":"],
        Call::KeyBuild => &["\"strict\":true", "\"verb\":"],
        _ => &[],
    };
    words.iter().any(|word| args.unexpanded().contains(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_of_by_stands_for_a_token_for_any_or_for_numbers_at_equal_distances() {
        for (wanted, token, stands) in [
            ("7", "7", true),
            ("7", "17", false),
            ("*", "anything", true),
            ("*1-99+2", "1", true),
            ("*1-99+2", "51", true),
            ("*1-99+2", "99", true),
            ("*1-99+2", "50", false),
            ("*1-99+2", "101", false),
            ("*3-99+2", "1", false),
            ("*1-99+2", "data", false),
            ("*1-99+0", "1", false),
            ("*1-99", "1", false),
            ("1-99+2", "1", false),
        ] {
            assert_eq!(stands_for(wanted, token), stands, "{wanted} and {token}");
        }
    }

    #[test]
    fn what_asks_by_the_strict_profile_is_of_its_level() {
        for (call, args, is_strict) in [
            (Call::Decode, r#"{"kind": "error", "text": "{}", "strict": true}"#, true),
            (Call::Decode, r#"{"kind": "error", "text": "{\"strict\":true}"}"#, false),
            (Call::Decode, r#"{"kind": "error", "text": "{}", "strict": false}"#, false),
            (Call::KeyBuild, r#"{"key": "rpc", "verb": "open_session"}"#, true),
            (Call::SessionRun, r#"{"requests": [], "verbs": []}"#, true),
            (Call::VersionCheck, r#"{"version": "0.5", "strict": true}"#, false),
        ] {
            assert_eq!(asks_strictly(call, &Template::new(args).unwrap()), is_strict, "{args}");
        }
    }
}
