//! What the key builders build, and what they refuse.

use super::segments::{self, Segment};
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::scenario::{Fault, Row, ScenarioError, Scenarios, source};
use crate::template::Text;

pub(super) fn files() -> Result<Vec<File>, ScenarioError> {
    let mut text = Scenarios::read(source!("keys/build"))?;
    let builders = text.rows("builders")?.iter().map(Builder::of).collect::<Result<Vec<_>, _>>()?;
    text.end()?;
    let built = builders.iter().flat_map(Builder::built).collect();
    let segments = builders.iter().flat_map(Builder::segments);
    let segments = segments.chain(builders.iter().flat_map(Builder::realm_as_segment));
    let segments = segments.chain(builders.iter().map(Builder::placeholders)).collect();
    // Between them every role builds these.
    let some = builders.iter().filter(|builder| matches!(builder.key, "rpc" | "sensor" | "fleet_glob"));
    let mut realms: Vec<Case> = some.flat_map(Builder::realms).collect();
    let others = builders.iter().filter(|builder| !matches!(builder.key, "rpc" | "sensor" | "fleet_glob"));
    realms.extend(builders.iter().flat_map(Builder::like_a_key));
    realms.extend(others.enumerate().flat_map(|(road, builder)| builder.few_realms(road)));
    realms.extend(builders.iter().flat_map(Builder::long));
    realms.extend(builders.iter().filter(|builder| builder.key == "rpc").flat_map(Builder::far));
    Ok(vec![
        File::new("keys", "build", "The keys and globs of section 3.2.", built),
        File::new("keys", "segments", "Session ids and stream names that the builders accept and refuse.", segments),
        File::new("keys", "realms", "Realms, which are checked segment by segment.", realms),
    ])
}

/// The realm of the cases that are about something else: named, so that they do not depend on the
/// default one.
const REALM: Option<&str> = Some("ncp");

/// The parts of a realm of so many bytes, in segments of 15 and a last one.
fn realm_of(bytes: usize) -> Vec<Text> {
    let whole = (bytes - 1) / 16;
    vec![Text::repeat("abcdefghijklmno/", whole), "z".repeat(bytes - 16 * whole).into()]
}

/// A key that can be built.
struct Builder {
    key: &'static str,
    /// What follows the realm, with `{id}` for the session.
    rest: &'static str,
    takes_session: bool,
    takes_name: bool,
    rule: &'static str,
    roles: Vec<Role>,
}

impl Builder {
    fn of(row: &Row) -> Result<Self, ScenarioError> {
        let takes = row.cell("takes")?;
        Ok(Self {
            key: row.name,
            rest: row.cell("rest")?,
            takes_session: takes.contains("session"),
            takes_name: takes.contains("name"),
            rule: row.rules.first().copied().ok_or(row.place.fault(Fault::Missing("rules")))?,
            roles: row.roles()?,
        })
    }

    /// The key in realms of one segment and of more, and with a name where it takes one.
    fn built(&self) -> Vec<Case> {
        let realms = [
            ("default-realm", None, "in the default realm"),
            ("realm", Some("lab"), "in the realm `lab`"),
            ("realm-of-two", Some("engram/ncp"), "in the realm `engram/ncp`"),
            ("realm-of-five", Some("a/b/c/d/e"), "in the realm `a/b/c/d/e`"),
        ];
        let mut cases = Vec::new();
        for (what, realm, says) in realms {
            let rules: &[_] = match realm {
                None => &["NCP-KEY-006", self.rule],
                // Its slashes are those between segments.
                Some(_) if what != "realm" => &["NCP-KEY-018", self.rule],
                Some(_) => &[self.rule],
            };
            cases.push(
                self.case(what, rules)
                    .title(format!("The `{}` key {says} is built as the table says.", self.key))
                    .flags(&["wrong-key"])
                    .call("key.build", self.args(realm, "uav3", None))
                    .gives(object! { "key" => self.expected(realm, "uav3", None) })
                    .because("The row of the key in section 3.2."),
            );
            if self.takes_name {
                cases.push(
                    self.case(&format!("{what}-named"), rules)
                        .title(format!(
                            "The `{}` key of the stream `front` {says} is built as the table says.",
                            self.key
                        ))
                        .flags(&["wrong-key"])
                        .call("key.build", self.args(realm, "uav3", Some("front")))
                        .gives(object! { "key" => self.expected(realm, "uav3", Some("front")) })
                        .because("The row of the key in section 3.2: a named stream has one chunk more."),
                );
            }
        }
        // Realms that end as keys do: what follows them follows all the same.
        let own = self.rest.replacen("{id}", "uav3", 1).replace("/**", "");
        for (what, realm) in [("as-a-key", own.clone()), ("as-another-key", format!("lab/{own}"))] {
            cases.push(
                self.case(&format!("realm-{what}"), &[self.rule, "NCP-KEY-018"])
                    .title(format!("The `{}` key in the realm `{realm}` is built as the table says.", self.key))
                    .flags(&["wrong-key"])
                    .call("key.build", self.args(Some(&realm), "uav3", None))
                    .gives(object! { "key" => self.expected(Some(&realm), "uav3", None) })
                    .because("The row of the key in section 3.2, whatever the segments of the realm are."),
            );
        }
        cases
    }

    /// What a builder might mend, or might stumble over.
    fn reported(&self, part: &str, says: &str, args: impl Fn(&str) -> Json) -> Vec<Case> {
        let mendable = [
            ("space", "uav 3", "NCP-KEY-012"),
            ("star", "uav*", "NCP-KEY-011"),
            ("slash", "uav3/", "NCP-KEY-011"),
            ("at", "@uav3", "NCP-KEY-013"),
        ];
        mendable
            .into_iter()
            .map(|(what, text, rule)| {
                self.case(&format!("{part}/reported/{what}"), &["NCP-KEY-019", rule])
                    .title(format!(
                        "The `{}` key is refused with an error for the {says} `{text}`, and no other key \
                                    is built in its place.",
                        self.key
                    ))
                    .flags(&["L24"])
                    .call("key.build", args(text))
                    .rejects("key")
                    .because("A refusal is reported as an error, not as a crash and not as another key.")
            })
            .collect()
    }

    /// Session ids and names: the whole list for one key each, a sample for the others.
    fn segments(&self) -> Vec<Case> {
        let mut cases = Vec::new();
        if self.takes_session {
            let (refused, accepted) = match self.key {
                "sensor" => (segments::refused(), segments::accepted()),
                _ => (segments::refused_sample(), segments::accepted_sample()),
            };
            cases.extend(
                refused.iter().map(|segment| {
                    self.refuses("session", "session id", segment, self.args(REALM, &segment.text, None))
                }),
            );
            cases.extend(self.reported("session", "session id", |id| self.args(REALM, id, None)));
            cases.extend(accepted.iter().map(|segment| {
                let expected = self.expected(REALM, &segment.text, None);
                self.accepts("session", "session id", segment, self.args(REALM, &segment.text, None), expected)
            }));
        }
        if self.key == "sensor" {
            cases.extend(
                segments::discouraged().iter().map(|segment| {
                    self.refuses("session", "session id", segment, self.args(REALM, &segment.text, None))
                }),
            );
        }
        if self.takes_name {
            let (refused, accepted) = match self.key {
                "command" => (segments::refused(), segments::accepted()),
                _ => (segments::refused_sample(), segments::accepted_sample()),
            };
            cases.extend(refused.iter().map(|segment| {
                self.refuses("name", "stream name", segment, self.args(REALM, "uav3", Some(&segment.text)))
            }));
            cases.extend(self.reported("name", "stream name", |name| self.args(REALM, "uav3", Some(name))));
            cases.extend(accepted.iter().map(|segment| {
                let expected = self.expected(REALM, "uav3", Some(&segment.text));
                self.accepts("name", "stream name", segment, self.args(REALM, "uav3", Some(&segment.text)), expected)
            }));
        }
        cases
    }

    /// Parts that look like places in a template: each stands in the key as it is, whatever the others are.
    fn placeholders(&self) -> Case {
        const ALL: &str = "{id}-{session}-{session_id}-{name}-{realm}-{rest}-{0}-{1}-{}-%s-%1-%(id)s-:id-<id>-\\1";
        let realm = format!("{ALL}/{{id}}");
        let (session, name) = (ALL.replace("{id}", "{realm}"), ALL.replace("{name}", "{id}"));
        let name = self.takes_name.then_some(name.as_str());
        self.case("placeholders", &["NCP-KEY-020"])
            .title(format!("The `{}` key is built of parts that look like places in a template.", self.key))
            .flags(&["changed-segments"])
            .call("key.build", self.args(Some(&realm), &session, name))
            .gives(object! { "key" => self.expected(Some(&realm), &session, name) })
            .because("Braces and percent signs are characters like every other, and each part stands as it is.")
    }

    /// A session id and a name that are the realm, which is valid and no segment.
    fn realm_as_segment(&self) -> Vec<Case> {
        const TWO: &str = "engram/ncp";
        let mut parts = Vec::new();
        if self.takes_session {
            parts.push(("session", "session id", self.args(Some(TWO), TWO, None)));
        }
        if self.takes_name {
            parts.push(("name", "stream name", self.args(Some(TWO), "uav3", Some(TWO))));
        }
        let one = |(part, says, args): (&str, &str, Json)| {
            self.case(&format!("{part}/is-the-realm"), &["NCP-KEY-011", "NCP-KEY-019"])
                .title(format!("The `{}` key is not built for a {says} that is the realm of two segments.", self.key))
                .flags(&["L22"])
                .call("key.build", args)
                .rejects("key")
                .by("crash", "NCP-KEY-019")
                .because("A slash is in no segment, also where the same text is a realm.")
        };
        parts.into_iter().map(one).collect()
    }

    /// Realms; the whole list for the control key, a sample for the others.
    fn realms(&self) -> Vec<Case> {
        let is_whole = self.key == "rpc";
        let (refused, accepted) = if is_whole {
            (segments::refused(), segments::accepted())
        } else {
            (segments::refused_sample(), segments::accepted_sample())
        };
        let mut cases = Vec::new();
        // A slash separates the segments of a realm; those that follow make empty ones of it.
        let has_slash = |segment: &&Segment| segment.text.contains('/');
        cases.extend(refused.iter().filter(|segment| !has_slash(segment)).map(|segment| {
            self.refuses("realm", "realm", segment, self.args(Some(&segment.text), "uav3", None)).flags(&["L22"])
        }));
        if is_whole {
            cases.extend(
                segments::discouraged().iter().map(|segment| {
                    self.refuses("realm", "realm", segment, self.args(Some(&segment.text), "uav3", None))
                }),
            );
        }
        cases.extend(accepted.iter().map(|segment| {
            let expected = self.expected(Some(&segment.text), "uav3", None);
            self.accepts("realm", "realm", segment, self.args(Some(&segment.text), "uav3", None), expected)
        }));
        let parts = [
            ("slash-first", "/a", "begins with a slash", "NCP-KEY-010"),
            ("slash-last", "a/", "ends with a slash", "NCP-KEY-010"),
            ("slash-twice", "a//b", "holds two slashes side by side", "NCP-KEY-010"),
            ("slash-alone", "/", "is a slash", "NCP-KEY-010"),
            ("second-star", "a/*", "has the second segment `*`", "NCP-KEY-011"),
            ("second-double-star", "a/**", "has the second segment `**`", "NCP-KEY-011"),
            ("second-dollar", "a/b$*/c", "has a second segment with `$*`", "NCP-KEY-011"),
            ("second-space", "a/ /c", "has the second segment U+0020", "NCP-KEY-012"),
            ("second-at", "a/@b", "has a second segment that begins with `@`", "NCP-KEY-013"),
            ("second-dot-dot", "a/../c", "has the second segment `..`", "NCP-KEY-014"),
            ("second-dot", "a/./c", "has the second segment `.`", "NCP-KEY-014"),
            ("last-nul", "a/b\u{0}", "has a second segment that ends with U+0000", "NCP-KEY-015"),
            ("line-slash-twice", "a\u{2028}/b//c", "holds two slashes side by side behind U+2028", "NCP-KEY-010"),
            ("line-slash-last", "a\u{2029}b/", "ends with a slash behind U+2029", "NCP-KEY-010"),
            (
                "next-line-slash-twice",
                "\u{e9}\u{2028}//c",
                "holds two slashes side by side behind U+00E9 and U+2028",
                "NCP-KEY-010",
            ),
            ("wide-slash-last", "\u{1f681}/", "ends with a slash behind U+1F681", "NCP-KEY-010"),
        ];
        let shown = if is_whole { parts.len() } else { 3 };
        for (what, realm, says, rule) in parts.into_iter().take(shown) {
            // What begins with `second` is refused only by those who look at every segment.
            let rules = match what.starts_with("second") {
                true => ["NCP-KEY-018", rule, "NCP-KEY-019"],
                false => ["NCP-KEY-018", rule, "NCP-KEY-019"],
            };
            cases.push(
                self.case(&format!("realm/{what}"), &rules)
                    .title(format!("The `{}` key is not built in a realm that {says}.", self.key))
                    .flags(&["L22"])
                    .call("key.build", self.args(Some(realm), "uav3", None))
                    .rejects("key")
                    .by("crash", "NCP-KEY-019")
                    .because("A realm is checked segment by segment."),
            );
        }
        if is_whole {
            let long = "a".repeat(256);
            let realm = format!("{long}/{long}");
            cases.push(
                self.case("realm/two-of-256-bytes", &["NCP-KEY-020", "NCP-KEY-018"])
                    .title("The `rpc` key is built in a realm of two segments of 256 bytes each.")
                    .flags(&["segment-length"])
                    .call("key.build", self.args(Some(&realm), "uav3", None))
                    .gives(object! { "key" => self.expected(Some(&realm), "uav3", None) })
                    .because("The limit is a segment's, not the realm's."),
            );
            for (what, character, times) in [("four", "\u{1f681}", 64), ("two", "\u{e9}", 128)] {
                let long = character.repeat(times);
                let realm = format!("{long}/a/{long}");
                cases.push(
                    self.case(&format!("realm/ends-of-256-bytes-of-{what}"), &["NCP-KEY-020", "NCP-KEY-018"])
                        .title(format!(
                            "The `rpc` key is built in a realm whose first and last segment have 256 bytes in {times} \
                             characters."
                        ))
                        .flags(&["bytes-not-characters"])
                        .call("key.build", self.args(Some(&realm), "uav3", None))
                        .gives(object! { "key" => self.expected(Some(&realm), "uav3", None) })
                        .because("The limit is a segment's, not the realm's, and counts bytes."),
                );
                let realm = format!("a/{}", character.repeat(times + 1));
                cases.push(
                    self.case(
                        &format!("realm/second-too-long-by-one-of-{what}"),
                        &["NCP-KEY-018", "NCP-KEY-017", "NCP-KEY-019"],
                    )
                    .title(format!(
                        "The `rpc` key is not built in a realm whose second segment has {} characters of {what} bytes.",
                        times + 1
                    ))
                    .flags(&["bytes-not-characters", "L22"])
                    .call("key.build", self.args(Some(&realm), "uav3", None))
                    .rejects("key")
                    .by("crash", "NCP-KEY-019")
                    .because("A realm is checked segment by segment, and the limit counts bytes."),
                );
            }
            let realm = format!("a/{}", "b".repeat(257));
            cases.push(
                self.case("realm/second-of-257-bytes", &["NCP-KEY-018", "NCP-KEY-017", "NCP-KEY-019"])
                    .title("The `rpc` key is not built in a realm whose second segment has 257 bytes.")
                    .flags(&["segment-length", "L22"])
                    .call("key.build", self.args(Some(&realm), "uav3", None))
                    .rejects("key")
                    .by("crash", "NCP-KEY-019")
                    .because("A realm is checked segment by segment."),
            );
        }
        cases
    }

    /// In realms that read like the rest of a key.
    fn like_a_key(&self) -> Vec<Case> {
        let table = [
            ("session", "a/session/uav3/sensor"),
            ("sensor", "lab/uav3/sensor/front"),
            ("rpc", "ncp/rpc"),
            ("command", "uav3/command"),
        ];
        let case = |(what, realm): (&str, &str)| {
            self.case(&format!("realm/like-a-key/{what}"), &[self.rule, "NCP-KEY-018", "NCP-KEY-007"])
                .title(format!(
                    "The `{}` key is built in the realm `{realm}`, which reads like the rest of a key.",
                    self.key
                ))
                .flags(&["changed-segments"])
                .call("key.build", self.args(Some(realm), "uav3", None))
                .gives(object! { "key" => self.expected(Some(realm), "uav3", None) })
                .because("A realm is the beginning of the key, whatever its segments are.")
        };
        table.map(case).into()
    }

    /// A few realms that are refused, others for each builder, alone or behind a segment that is not.
    fn few_realms(&self, road: usize) -> Vec<Case> {
        const ALWAYS: [&str; 2] = ["at-first", "dot-dot"];
        let few = segments::refused_sample().into_iter().filter(|segment| ALWAYS.contains(&segment.name.as_str()));
        let few = few.chain(segments::refused_besides(road));
        few.enumerate()
            .map(|(nth, segment)| {
                let is_second = (nth + road).is_multiple_of(2);
                let realm = if is_second { format!("ncp/{}", segment.text) } else { segment.text.clone() };
                let (part, place) =
                    if is_second { ("second", "realm whose second segment") } else { ("refused", "realm that") };
                self.case(&format!("realm/{part}/{}", segment.name), &["NCP-KEY-018", segment.rule, "NCP-KEY-019"])
                    .rests_on(format!("keys/segments/sensor/session/refused/{}", segment.name))
                    .title(format!("The `{}` key is not built in a {place} {}.", self.key, segment.says))
                    .flags(&[segment.flag, "L22"])
                    .call("key.build", self.args(Some(&realm), "uav3", None))
                    .rejects("key")
                    .by("crash", "NCP-KEY-019")
                    .because("A realm is checked segment by segment, whichever key is built.")
            })
            .collect()
    }

    /// Realms that are long as a whole, though none of their segments is: by their bytes, and by their segments.
    fn long(&self) -> Vec<Case> {
        let is_whole = self.key == "rpc";
        let bytes: &[usize] = match is_whole {
            true => &[257, 513, 1024, 1025, 2049, 4097, 65_537],
            // A realm of 1,025 bytes is that of the key of which everything is long.
            false if self.takes_session => &[65_537],
            false => &[1025, 65_537],
        };
        let segments: &[usize] = if is_whole { &[17, 65, 129, 257, 1025, 4097] } else { &[257] };
        let of_bytes = bytes.iter().map(|bytes| (format!("{bytes}-bytes"), format!("{bytes} bytes"), realm_of(*bytes)));
        let of_segments = segments.iter().map(|segments| {
            let realm = vec![Text::repeat("a/", segments - 1), "a".into()];
            (format!("{segments}-segments"), format!("{segments} segments"), realm)
        });
        let mut cases = Vec::new();
        for (what, says, realm) in of_bytes.chain(of_segments) {
            let expected = self.rest.replacen("{id}", "uav3", 1);
            let key = Text::Concat([realm.clone(), vec![format!("/{expected}").into()]].concat());
            cases.push(
                self.case(&format!("realm/long/{what}"), &["NCP-KEY-018", "NCP-KEY-020", self.rule])
                    .title(format!("The `{}` key is built in a realm of {says}.", self.key))
                    .flags(&["segment-length"])
                    .call("key.build", self.args(None, "uav3", None).with("realm", Text::Concat(realm).json()))
                    .gives(object! { "key" => key.json() })
                    .because("The limit is a segment's: no rule limits a realm or a key as a whole."),
            );
        }
        if self.takes_session {
            // The same in the realm that nobody names.
            let long = "s".repeat(256);
            let name = self.takes_name.then(|| "n".repeat(256));
            cases.push(
                self.case("realm/long/default-realm", &["NCP-KEY-006", "NCP-KEY-020", self.rule])
                    .title(format!("The `{}` key is built in the default realm of segments of 256 bytes.", self.key))
                    .flags(&["segment-length"])
                    .call("key.build", self.args(None, &long, name.as_deref()))
                    .gives(object! { "key" => self.expected(None, &long, name.as_deref()) })
                    .because("The default realm is `ncp`, however long the key is."),
            );
            // Everything as long as it may be.
            let (realm, long) = (realm_of(1025), "s".repeat(256));
            let name = self.takes_name.then(|| "n".repeat(256));
            let mut key = format!("/{}", self.rest.replacen("{id}", &long, 1));
            if let Some(name) = &name {
                key = format!("{key}/{name}");
            }
            let key = Text::Concat([realm.clone(), vec![key.into()]].concat());
            cases.push(
                self.case("realm/long/all-long", &["NCP-KEY-018", "NCP-KEY-020", self.rule])
                    .title(format!("The `{}` key is built of a long realm and segments of 256 bytes.", self.key))
                    .flags(&["segment-length"])
                    .call(
                        "key.build",
                        self.args(None, &long, name.as_deref()).with("realm", Text::Concat(realm).json()),
                    )
                    .gives(object! { "key" => key.json() })
                    .because("The limit is a segment's: no rule limits a realm or a key as a whole."),
            );
        }
        cases
    }

    /// Segments that are refused, behind so many that are not.
    fn far(&self) -> Vec<Case> {
        let bad = [
            ("star", "*".to_owned(), "is a wildcard", "NCP-KEY-011"),
            ("at", "@a".to_owned(), "begins with `@`", "NCP-KEY-013"),
            ("empty", String::new(), "is empty", "NCP-KEY-010"),
            ("257-bytes", "b".repeat(257), "has 257 bytes", "NCP-KEY-017"),
        ];
        let mut cases = Vec::new();
        for behind in [15, 4096] {
            for (what, segment, says, rule) in &bad {
                let realm = Text::concat([Text::repeat("a/", behind), segment.as_str().into()]);
                cases.push(
                    self.case(&format!("realm/far/{what}-behind-{behind}"), &["NCP-KEY-018", *rule, "NCP-KEY-019"])
                        .title(format!(
                            "The `{}` key is not built in a realm in which a segment behind {behind} others {says}.",
                            self.key
                        ))
                        .flags(&["L22"])
                        .call("key.build", self.args(None, "uav3", None).with("realm", realm.json()))
                        .rejects("key")
                        .by("crash", "NCP-KEY-019")
                        .because("A realm is checked segment by segment, to its last."),
                );
            }
        }
        cases
    }

    fn refuses(&self, part: &str, says: &str, segment: &Segment, args: Json) -> Case {
        let of_an_id = format!("keys/segments/sensor/session/refused/{}", segment.name);
        let rules: &[_] = match (part, segment.rule) {
            // What the text only advises against, no binding rule may be cited for.
            (_, "NCP-KEY-016") => &["NCP-KEY-016"],
            // What a builder refuses in an id, it fails to look for in a realm.
            ("realm", rule) => &["NCP-KEY-018", rule, "NCP-KEY-019"],
            (_, rule) => &[rule, "NCP-KEY-019"],
        };
        let verb = if segment.rule == "NCP-KEY-016" { "should not be" } else { "is not" };
        let case = self.case(&format!("{part}/refused/{}", segment.name), rules);
        let case = if part == "realm" { case.rests_on(of_an_id) } else { case };
        case.title(format!("The `{}` key {verb} built with a {says} that {}.", self.key, segment.says))
            .flags(&[segment.flag, "L24"])
            .call("key.build", args)
            .rejects("key")
            .by("crash", "NCP-KEY-019")
            .because("Section 3.3 refuses such a segment, with an error and not with a crash or another key.")
    }

    fn accepts(&self, part: &str, says: &str, segment: &Segment, args: Json, expected: String) -> Case {
        let rules = match segment.flag {
            "changed-segments" => ["NCP-KEY-007", segment.rule],
            _ => [segment.rule, "NCP-KEY-007"],
        };
        self.case(&format!("{part}/accepted/{}", segment.name), &rules)
            .title(format!("The `{}` key is built with a {says} that {}, unchanged.", self.key, segment.says))
            .flags(&[segment.flag])
            .call("key.build", args)
            .gives(object! { "key" => expected })
            .because("No rule of section 3.3 refuses it, and nothing of it is escaped or changed.")
    }

    fn case(&self, what: &str, rules: &[&'static str]) -> Case {
        Case::new(format!("{}/{what}", self.key), rules, &self.roles)
    }

    fn args(&self, realm: Option<&str>, session: &str, name: Option<&str>) -> Json {
        let mut args = object! { "key" => self.key, "realm" => realm };
        if self.takes_session {
            args = args.with("session", session.into());
        }
        if self.takes_name {
            args = args.with("name", name.into());
        }
        args
    }

    fn expected(&self, realm: Option<&str>, session: &str, name: Option<&str>) -> String {
        let mut key = format!("{}/{}", realm.unwrap_or("ncp"), self.rest.replacen("{id}", session, 1));
        if let Some(name) = name {
            key.push('/');
            key.push_str(name);
        }
        key
    }
}
