//! A strict plant: which commands it follows, and what the others leave behind, which is nothing.

use super::{against_version, unfit_versions};
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::trace::{int, no_result, num, nums, steps};

pub(super) fn file() -> File {
    let mut cases = followed();
    cases.extend(first());
    cases.extend(dropped());
    cases.extend(kept());
    cases.extend(unversioned());
    cases.extend(holds());
    cases.extend(stops());
    cases.extend(broken_stops());
    cases.extend(resets());
    cases.extend(streams());
    let about = "A strict plant: commands that advance, and those that are rejected or dropped and change nothing, ESTOP aside.";
    File::new("strict", "plant", about, cases)
}

/// A command frame as it travels.
#[derive(Debug, Clone)]
struct Sent {
    version: Option<&'static str>,
    seq: Option<i64>,
    mode: Option<&'static str>,
    /// The seq of the command that it repeats, if it has another.
    repeats: Option<i64>,
}

const OWN: Option<&str> = Some("0.5");

/// The ttl of every command, ms.
const TTL_MS: f64 = 250.0;

const fn sent(mode: Option<&'static str>, seq: Option<i64>) -> Sent {
    Sent { version: OWN, seq, mode, repeats: None }
}

const fn go(seq: i64) -> Sent {
    sent(Some("active"), Some(seq))
}

impl Sent {
    const fn of_version(mut self, version: Option<&'static str>) -> Self {
        self.version = version;
        self
    }

    /// The same command as that of another seq.
    const fn repeating(mut self, seq: i64) -> Self {
        self.repeats = Some(seq);
        self
    }

    /// What it commands: its seq, so that commands can be told apart.
    fn value(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "a value is only to be told from others")]
        let value = self.repeats.or(self.seq).unwrap_or(99) as f64;
        value
    }

    fn json(&self) -> Json {
        let mut frame = Json::object();
        if let Some(version) = self.version {
            frame = frame.with("ncp_version", version.into());
        }
        frame = frame.with("kind", "command_frame".into());
        if let Some(seq) = self.seq {
            frame = frame.with("seq", int(seq));
        }
        frame = frame.with("t", num(3.0)).with("frame_id", "world".into());
        if let Some(mode) = self.mode {
            frame = frame.with("mode", mode.into());
        }
        frame
            .with("ttl_ms", num(TTL_MS))
            .with("channels", channels(self.value()))
            .with("horizon", Json::Array(Vec::new()))
            .with("horizon_dt_ms", Json::Null)
    }
}

fn channels(value: f64) -> Json {
    object! { "velocity_setpoint" => object! { "data" => nums(&[value, 0.0, 0.0]), "unit" => "m/s" } }
}

/// What happens at a plant, and when on its clock.
#[derive(Debug, Clone)]
enum Event {
    Command(Sent, f64),
    /// A text that is no valid frame, and an ESTOP all the same.
    Stop(String, f64),
    Ask(f64),
    Reset,
}
use Event::{Ask, Command, Reset};

/// The plant of section 12.1 in plain arithmetic; its clock never steps back here.
#[derive(Default)]
struct Plant {
    last_seq: Option<i64>,
    /// What it follows, and since when.
    held: Option<(f64, f64)>,
    latched: bool,
}

impl Plant {
    fn take(&mut self, command: &Sent, now: f64) {
        let is_stop = command.mode == Some("estop");
        self.latched |= is_stop;
        let seq = command.seq.unwrap_or(0);
        let is_stamped = seq >= 1 && self.last_seq.is_none_or(|last| seq > last);
        if is_stop || command.version != OWN || !is_stamped {
            return;
        }
        self.last_seq = Some(seq);
        self.held = (command.mode == Some("active")).then_some((command.value(), now));
    }

    fn ask(&self, now: f64) -> Json {
        match self.held {
            Some((value, since)) if !self.latched && (now - since) * 1000.0 <= TTL_MS => channels(value),
            _ => Json::Null,
        }
    }
}

fn case(path: impl Into<String>, rules: &[&'static str], events: &[Event]) -> Case {
    let mut plant = Plant::default();
    let (mut args, mut results) = (Vec::new(), Vec::new());
    for event in events {
        let arrives = |text: String, now: f64| object! { "op" => "command", "text" => text, "now_s" => num(now) };
        let (arg, result) = match event {
            Command(command, now) => {
                plant.take(command, *now);
                (arrives(command.json().text(), *now), no_result())
            }
            Event::Stop(text, now) => {
                plant.latched = true;
                (arrives(text.clone(), *now), no_result())
            }
            Ask(now) => (object! { "op" => "active", "now_s" => num(*now) }, object! { "channels" => plant.ask(*now) }),
            Reset => {
                plant = Plant::default();
                (object! { "op" => "reset" }, no_result())
            }
        };
        args.push(arg);
        results.push(result);
    }
    Case::new(path, rules, &[Role::Body])
        .call("buffer.run", object! { "steps" => Json::Array(args) })
        .strictly()
        .shows(steps(results))
}

/// Modes by name.
const MODES: [(&str, Option<&str>); 5] = [
    ("active", Some("active")),
    ("hold", Some("hold")),
    ("init", Some("init")),
    ("unknown", Some("dance")),
    ("absent", None),
];

/// Seqs that do not advance a stream whose last one is 5, by name.
const NOT_ADVANCING: [(&str, Option<i64>); 6] = [
    ("equal", Some(5)),
    ("older", Some(4)),
    ("first", Some(1)),
    ("zero", Some(0)),
    ("minus-one", Some(-1)),
    ("absent", None),
];

/// By which rule a strict plant does not take a command of this seq.
fn rule_against(seq: Option<i64>) -> &'static str {
    if seq.unwrap_or(0) < 1 { "NCP-STRICT-004" } else { "NCP-STRICT-005" }
}

/// That the plant follows seq 5 of time 1 to its ttl and no longer, whatever came at 1.125; then the next
/// command is followed.
fn unchanged_by(what: Event) -> Vec<Event> {
    vec![Command(go(5), 1.0), Ask(1.0625), what, Ask(1.125), Ask(1.25), Ask(1.3125), Command(go(6), 1.375), Ask(1.375)]
}

fn followed() -> Vec<Case> {
    let greatest = 9_007_199_254_740_991;
    let streams: [(&str, &[i64]); 4] = [
        ("one", &[1]),
        ("one-by-one", &[1, 2, 3, 4]),
        ("with-gaps", &[3, 9, 10, 400]),
        ("to-the-greatest", &[1, greatest - 1, greatest]),
    ];
    streams
        .into_iter()
        .map(|(what, seqs)| {
            let mut events = Vec::new();
            for (seq, now) in seqs.iter().zip([1.0, 1.125, 1.25, 1.375]) {
                events.push(Command(go(*seq), now));
                events.push(Ask(now));
            }
            case(format!("followed/{what}"), &["NCP-STRICT-012", "NCP-RES-026"], &events)
                .title(format!("A strict plant follows commands with a version and a rising seq ({what})."))
                .flags(&["over-strict"])
                .because("A strict receiver accepts a command with a compatible version and a seq of at least 1.")
        })
        .collect()
}

/// The first command of all.
fn first() -> Vec<Case> {
    let mut cases = Vec::new();
    for (what, seq) in [("zero", Some(0)), ("minus-one", Some(-1)), ("absent", None)] {
        let events = [Command(sent(Some("active"), seq), 1.0), Ask(1.0), Command(go(1), 1.125), Ask(1.125)];
        cases.push(
            case(format!("first/seq-{what}"), &["NCP-STRICT-004", "NCP-STRICT-011"], &events)
                .title(format!(
                    "A strict plant does not follow a first command whose seq is {what}, and follows seq 1 then."
                ))
                .flags(&["L08"])
                .because("A command frame whose seq is less than 1 is rejected, and leaves the buffer as it was."),
        );
    }
    for (what, version) in unfit_versions() {
        let events = [Command(go(1).of_version(version), 1.0), Ask(1.0), Command(go(1), 1.125), Ask(1.125)];
        cases.push(
            case(format!("first/version-{what}"), &[against_version(version), "NCP-STRICT-011"], &events)
                .title(format!("A strict plant does not follow a first command whose version is {what}, and follows the same seq with one."))
                .flags(&["L07"])
                .because("The frame is rejected, and leaves the buffer as it was, the last seq included."),
        );
    }
    cases
}

/// Commands that do not advance, in every mode but ESTOP.
fn dropped() -> Vec<Case> {
    let mut cases = Vec::new();
    for (mode_name, mode) in MODES {
        for (what, seq) in NOT_ADVANCING {
            let events = unchanged_by(Command(sent(mode, seq), 1.125));
            cases.push(
                case(format!("dropped/{mode_name}/{what}"), &[rule_against(seq), "NCP-STRICT-011"], &events)
                    .title(format!("A command with the mode {mode_name} and the seq {what} changes nothing at a strict plant that follows seq 5."))
                    .flags(&["L08"])
                    .because("It is rejected or dropped, whatever its mode, and leaves the buffer as it was: the command, its deadline and the last seq."),
            );
        }
    }
    cases
}

/// What is left of a buffer by a command that says what the one before said, so that only what it takes away shows.
fn kept() -> Vec<Case> {
    let kept_from = |path: String, rule: &'static str, says: String, frame: Sent, flag| {
        let events =
            [Command(go(5), 1.0), Command(frame.repeating(5), 1.0625), Ask(1.125), Command(go(6), 1.1875), Ask(1.1875)];
        case(path, &["NCP-STRICT-011", rule], &events)
            .title(format!("A strict plant goes on with seq 5, and then with seq 6, after a command {says}."))
            .flags(&[flag])
            .because("A command that is rejected or dropped leaves the buffer as it was: the command before stays, and so does the last seq.")
    };
    let mut cases = Vec::new();
    for (what, seq) in NOT_ADVANCING {
        let frame = sent(Some("active"), seq);
        cases.push(kept_from(
            format!("kept/seq-{what}"),
            rule_against(seq),
            format!("whose seq is {what}"),
            frame,
            "L08",
        ));
    }
    for (what, version) in unfit_versions() {
        for (when, seq) in [("older", 4), ("newer", 9)] {
            cases.push(kept_from(
                format!("kept/version-{what}/{when}"),
                against_version(version),
                format!("with the {when} seq whose version is {what}"),
                go(seq).of_version(version),
                "L07",
            ));
        }
    }
    cases
}

/// Commands that would advance, but for their version.
fn unversioned() -> Vec<Case> {
    let mut cases = Vec::new();
    for (mode_name, mode) in [("active", Some("active")), ("hold", Some("hold"))] {
        for (what, version) in unfit_versions() {
            let events = unchanged_by(Command(sent(mode, Some(6)).of_version(version), 1.125));
            cases.push(
                case(format!("version/{mode_name}/{what}"), &[against_version(version), "NCP-STRICT-011"], &events)
                    .title(format!("A command with the mode {mode_name} whose version is {what} changes nothing at a strict plant."))
                    .flags(&["L07"])
                    .because("The frame is rejected and leaves the buffer as it was, so that the same seq with a version still advances."),
            );
        }
    }
    cases
}

/// A HOLD that advances is obeyed, and advances the stream.
fn holds() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, mode) in MODES.into_iter().filter(|(name, _)| *name != "active") {
        let hold = |seq| sent(mode, Some(seq));
        cases.push(
            case(
                format!("hold/{name}/advances"),
                &["NCP-STRICT-005", "NCP-RES-023"],
                &[
                    Command(go(5), 1.0),
                    Command(hold(6), 1.0625),
                    Ask(1.0625),
                    Command(go(6), 1.125),
                    Ask(1.125),
                    Command(go(7), 1.1875),
                    Ask(1.1875),
                ],
            )
            .title(format!(
                "A HOLD (mode {name}) that advances holds a strict plant, and only a newer command leads back."
            ))
            .flags(&["L08", "lost-hold"])
            .because("It advances, and an obeyed HOLD counts: the command of the same seq does not advance then."),
        );
        cases.push(
            case(
                format!("hold/{name}/first"),
                &["NCP-STRICT-005"],
                &[
                    Command(hold(3), 1.0),
                    Command(go(3), 1.0625),
                    Command(go(2), 1.0625),
                    Ask(1.0625),
                    Command(go(4), 1.125),
                    Ask(1.125),
                ],
            )
            .title(format!("A HOLD (mode {name}) that is the first command begins the stream of a strict plant."))
            .flags(&["L08"])
            .because("A command advances when there is none before it; what follows has to advance from there."),
        );
        cases.push(
            case(
                format!("hold/{name}/replayed"),
                &["NCP-STRICT-005", "NCP-STRICT-011"],
                &[
                    Command(go(5), 1.0),
                    Command(hold(6), 1.0625),
                    Command(go(7), 1.125),
                    Command(hold(6), 1.1875),
                    Ask(1.1875),
                    Command(go(8), 1.25),
                    Command(hold(6), 1.3125),
                    Ask(1.3125),
                ],
            )
            .title(format!("A HOLD (mode {name}) that is replayed does not hold a strict plant again."))
            .flags(&["L08"])
            .because("The replay does not advance, so it is dropped."),
        );
    }
    cases
}

/// An ESTOP is never lost.
fn stops() -> Vec<Case> {
    let estop = |seq| sent(Some("estop"), seq);
    let mut ways: Vec<(String, Sent, &[&'static str])> =
        vec![("advancing".to_owned(), estop(Some(6)), &["L08", "lost-estop"])];
    for (what, seq) in NOT_ADVANCING {
        ways.push((format!("seq-{what}"), estop(seq), &["L08", "lost-estop"]));
    }
    for (what, version) in unfit_versions() {
        let stop = estop(Some(6)).of_version(version);
        ways.push((format!("version-{what}"), stop, &["L07", "lost-estop"]));
    }
    let bare = estop(None).of_version(None);
    ways.push(("bare".to_owned(), bare, &["L07", "L08", "lost-estop"]));
    let mut cases = Vec::new();
    for (what, stop, flags) in ways {
        let why = "A strict plant latches ESTOP also on a frame that it rejects or drops, and only a reset ends it.";
        cases.push(
            case(
                format!("estop/{what}"),
                &["NCP-STRICT-010"],
                &[
                    Command(go(5), 1.0),
                    Ask(1.0),
                    Command(stop.clone(), 1.0625),
                    Ask(1.0625),
                    Command(go(7), 1.125),
                    Ask(1.125),
                    Reset,
                    Ask(1.125),
                    Command(go(1), 1.1875),
                    Ask(1.1875),
                ],
            )
            .title(format!("An ESTOP ({what}) stops a strict plant until its reset."))
            .flags(flags)
            .because(why),
        );
        cases.push(
            case(
                format!("estop-first/{what}"),
                &["NCP-STRICT-010"],
                &[Command(stop, 1.0), Command(go(7), 1.0625), Ask(1.0625), Command(go(8), 1.125), Ask(1.125)],
            )
            .title(format!("An ESTOP ({what}) before any command stops a strict plant."))
            .flags(flags)
            .because(why),
        );
    }
    cases
}

/// An ESTOP in a frame that no receiver reads.
fn broken_stops() -> Vec<Case> {
    let texts = [
        ("bare", r#"{"kind":"command_frame","mode":"estop"}"#),
        ("repeated-mode", r#"{"kind":"command_frame","mode":"estop","mode":"active"}"#),
        ("wrong-version-type", r#"{"ncp_version":5,"kind":"command_frame","mode":"estop"}"#),
        ("null-version", r#"{"ncp_version":null,"kind":"command_frame","seq":6,"mode":"estop"}"#),
        ("wrong-seq-type", r#"{"ncp_version":"0.5","kind":"command_frame","seq":"6","mode":"estop"}"#),
        ("fraction-of-a-seq", r#"{"ncp_version":"0.4","kind":"command_frame","seq":0.5,"mode":"estop"}"#),
    ];
    texts
        .map(|(what, text)| {
            let events = [
                Command(go(5), 1.0),
                Event::Stop(text.to_owned(), 1.0625),
                Ask(1.0625),
                Command(go(6), 1.125),
                Ask(1.125),
            ];
            case(format!("estop-broken/{what}"), &["NCP-STRICT-010", "NCP-RES-022"], &events)
                .title(format!("An ESTOP in a frame that is rejected ({what}) stops a strict plant."))
                .flags(&["L07", "lost-estop"])
                .because("Any JSON object of kind `command_frame` with a member `mode` of the value `estop` latches, whatever else is wrong with it.")
        })
        .into()
}

fn resets() -> Vec<Case> {
    let mut cases = vec![
        case(
            "reset/begins-again",
            &["NCP-STRICT-012", "NCP-RES-030"],
            &[Command(go(50), 1.0), Ask(1.0), Reset, Ask(1.0), Command(go(1), 1.0625), Ask(1.0625)],
        )
        .title("A strict plant follows a stream that begins again at 1 after a reset.")
        .flags(&["over-strict"])
        .because("The reset clears the last seq, and a command advances when there is none."),
        case(
            "reset/replay",
            &["NCP-STRICT-005", "NCP-STRICT-011"],
            &[
                Command(go(50), 1.0),
                Reset,
                Command(go(2), 1.0625),
                Command(go(1), 1.125),
                Ask(1.125),
                Command(go(2), 1.25),
                Ask(1.3125),
                Ask(1.375),
            ],
        )
        .title("A strict plant drops what does not advance after a reset as before it.")
        .flags(&["L08"])
        .because("The stream begins with the first command after the reset."),
    ];
    for (what, seq) in [("zero", Some(0)), ("minus-one", Some(-1)), ("absent", None)] {
        let events = [
            Command(go(50), 1.0),
            Reset,
            Command(sent(Some("active"), seq), 1.0625),
            Ask(1.0625),
            Command(go(1), 1.125),
            Ask(1.125),
        ];
        cases.push(
            case(format!("reset/seq-{what}"), &["NCP-STRICT-004", "NCP-STRICT-011"], &events)
                .title(format!("A strict plant does not follow a command whose seq is {what} after a reset either."))
                .flags(&["L08"])
                .because("A command frame whose seq is less than 1 is rejected."),
        );
    }
    cases
}

/// Longer streams: replayed, reordered, unstamped.
fn streams() -> Vec<Case> {
    let streams: [(&str, &[i64], &str); 7] = [
        ("duplicated", &[1, 1, 2, 2, 3, 3], "in which every frame comes twice"),
        ("reordered", &[2, 1, 4, 3, 6, 5], "in which pairs are exchanged"),
        ("replayed", &[1, 2, 3, 1, 2, 3, 4], "that is replayed from its beginning"),
        ("unstamped", &[0, 0, 0, 0], "without a single stamp"),
        ("unstamped-between", &[1, 0, 2, 0, 3, 0], "with unstamped frames between"),
        ("falling", &[5, 4, 3, 2, 1, 0, -1], "whose seq falls"),
        ("begins-again", &[7, 8, 9, 1, 2, 3], "whose sender begins again without a reset"),
    ];
    streams
        .into_iter()
        .map(|(what, seqs, says)| {
            let mut events = Vec::new();
            let mut now = 1.0;
            for seq in seqs {
                events.push(Command(go(*seq), now));
                events.push(Ask(now));
                now += 0.0625;
            }
            // Past the ttl of whatever was followed last.
            events.push(Ask(now + 0.3125));
            let rule = if seqs.contains(&0) { "NCP-STRICT-004" } else { "NCP-STRICT-005" };
            case(format!("stream/{what}"), &[rule, "NCP-STRICT-011"], &events)
                .title(format!("A strict plant follows, of a stream {says}, what advances and nothing else."))
                .flags(&["L08"])
                .because("What has no stamp is rejected and what does not advance is dropped; neither refreshes the deadline.")
        })
        .collect()
}
