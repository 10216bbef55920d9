//! The freedoms of a server.

use std::collections::{BTreeSet, HashMap};

use ncp_peer_rust::Answer;
use ncp_text::WIRE_VERSION;
use ncp_text::tables::tables;

use super::frames::is_strict;
use super::open::{Freedom, freedom};
use super::{Outcome, TOLERANCE, Verdict, any, exactly, fits, reject, specification};
use crate::fuzz::tree::{
    Tree, double, integer, items, list, map, members, near_list, object, own, set, spelled, string, text,
};
use crate::json::Json;
use crate::peer::{self, Call};

/// The params of the two networks.
const LIF: [&str; 7] = ["C_m", "tau_m", "E_L", "V_th", "V_reset", "t_ref", "I_e"];
const RATE: [&str; 2] = ["tau", "mu"];

/// Why it is open what becomes of an opening of a session that is open.
const OPEN_ALREADY: &str = "a session that is open already, SESS-030";

/// How long a request is whose reply may be too long, though it is not itself.
const LONG: std::ops::RangeInclusive<usize> = 1_000_000..=1 << 20;

/// Why it is open what becomes of a session whose network the specification lacks and cannot even name in a frame.
const UNSAID: &str = "which networks a server has, however long their names, is its own affair";

/// Why it is open what becomes of an opening while another session is open.
const FULL: &str = "a server may refuse a session while it holds another, SESS-041";

pub(super) fn run(args: &Tree, result: Outcome<'_>, said: Option<&peer::Answer<'_>>) -> Verdict {
    let several = judge(args, result, said, false);
    // What is written down before a peer answers is for servers with room for one session, too.
    match (&several, said) {
        (Verdict::Expect(of_several), None) => match judge(args, result, None, true) {
            Verdict::Expect(of_one) if of_one != *of_several => {
                let values = [of_several, &of_one].map(|expect| expect.get("value").cloned().unwrap_or(Json::Null));
                fits(any(values.into()))
            }
            _ => several,
        },
        _ => several,
    }
}

/// What is asked of a server; with room for one session it refuses a second while it holds another.
fn judge(args: &Tree, result: Outcome<'_>, said: Option<&peer::Answer<'_>>, has_room_for_one: bool) -> Verdict {
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    let strict = is_strict(args);
    if args.get("verbs").is_some() && items(args.get("verbs")).len() != items(args.get("requests")).len() {
        return Verdict::Open("there are not as many verbs as requests");
    }
    if !strict && args.get("verbs").is_some_and(|verbs| !verbs.is_null()) {
        return Verdict::Open("which key a request comes at, only a strict server has to heed");
    }
    let replies = items(result.get("replies"));
    let theirs = match said {
        Some(peer::Answer::Result(result)) => items(result.get("replies")),
        _ => &[],
    };
    let mut open: HashMap<String, Session> = HashMap::new();
    // Of these the text does not say whether they are open, or what they hold: of the others it does, SESS-035.
    let mut unknown: HashMap<String, &'static str> = HashMap::new();
    let mut why_open = None;
    let mut patterns = Vec::new();
    for (nth, (request, reply)) in items(args.get("requests")).iter().zip(replies).enumerate() {
        let text_of = |tree: &Tree| tree.as_str().and_then(|text| Json::parse(text).ok().map(|json| own(&json)));
        let Some(reply) = text_of(reply) else { return Verdict::Open("the specification replies no JSON") };
        let kind = string(&reply, "kind").unwrap_or_default().to_owned();
        let asked = text_of(request);
        let of_asked = |name: &str| asked.as_ref().and_then(|asked| string(asked, name)).unwrap_or_default();
        let (id, of) = (of_asked("session_id").to_owned(), of_asked("kind").to_owned());
        let is_open = open.contains_key(&id) || unknown.contains_key(&id);
        // [NCP-STRICT-007]
        let verb = items(args.get("verbs")).get(nth).and_then(Json::as_str);
        let by_key = strict && verb.is_some_and(|verb| verb != of);
        let is_refused_for_version = version_of(asked.as_ref()) != WIRE_VERSION
            || strict && asked.as_ref().is_some_and(|asked| asked.get("ncp_version").is_none());
        let may_open = of == "open_session" && !by_key && !is_refused_for_version;
        let refused = theirs.get(nth).and_then(|reply| reply.as_str()).is_some_and(refuses);
        let is_full = (refused || has_room_for_one) && (!open.is_empty() || !unknown.is_empty());
        let is_surely_full = has_room_for_one && !open.is_empty();
        let frame = request.as_str().unwrap_or_default();
        let may_be_refused = own_openness(frame, &of, strict);
        let is_unsaid = may_open && kind == "error" && is_read(&of, frame);
        let opens = theirs.get(nth).and_then(|reply| reply.as_str()).is_some_and(is_opened);
        if let (None, Some(why)) = (&asked, may_be_refused) {
            return Verdict::Open(why);
        }
        let why = may_be_refused
            .or_else(|| unknown.get(&id).copied())
            .or_else(|| opening_openness(asked.as_ref(), &reply, &kind, is_open, is_full, may_open))
            .or_else(|| (is_unsaid && opens).then_some(UNSAID))
            .or_else(|| open.get(&id)?.step_openness(asked.as_ref()?, &of));
        let is_closed = kind == "session_closed" && may_be_refused.is_none();
        let known = if is_closed || why.is_some() {
            unknown.remove(&id);
            open.remove(&id)
        } else {
            None
        };
        if let Some(why) = why {
            why_open.get_or_insert(why);
            let refusal = || written("session_opened", vec![("ok", Json::Bool(false))]);
            let is_refused = why == FULL && is_surely_full && kind == "session_opened";
            patterns.push(if is_refused { any(vec![refusal(), error_frame()]) } else { anything() });
            match known {
                // [NCP-SESS-027] An opening that is refused ends no session.
                Some(session) if why == OPEN_ALREADY && refused => drop(open.insert(id, session)),
                _ if is_closed => {}
                _ => drop(unknown.insert(id, why)),
            }
            continue;
        }
        if kind == "session_opened"
            && reply.get("ok") != Some(&Json::Bool(false))
            && let Some(session) = asked.as_ref().and_then(Session::read)
        {
            open.insert(id.clone(), session);
        }
        let level = match (open.get_mut(&id), &asked) {
            (Some(session), Some(asked)) if kind == "observation_frame" => session.take(asked),
            _ => 0.0,
        };
        // Which of the two is a server's own affair, and leaves everything as it was.
        let runs_nothing = kind == "observation_frame"
            && open.get(&id).zip(asked.as_ref()).is_some_and(|(session, asked)| session.time_of(asked) == 0.0);
        let by_strictness = by_key || strict && is_refused_for_version;
        patterns.push(match of.as_str() {
            // [NCP-STRICT-007] [NCP-STRICT-009] An error frame, and not what else a session that is not open may get.
            "close_session" if by_strictness && kind == "error" => pattern(&reply, &kind, "", false, level),
            "step_request" | "run_request" if runs_nothing => {
                any(vec![pattern(&reply, &kind, &of, false, level), error_frame()])
            }
            _ => pattern(&reply, &kind, &of, is_refused_for_version || is_unsaid, level),
        });
    }
    if let Some(why) = why_open.filter(|_| patterns.iter().all(|pattern| pattern.get("$anything").is_some())) {
        return Verdict::Open(why);
    }
    if differs_by_rounding(args, result) {
        return Verdict::Open("a potential so near its threshold that a rounding decides");
    }
    if differs_by_order(args, result) {
        return Verdict::Open("numbers that leave the doubles or not by the order of the operations");
    }
    fits(object([("replies", list(patterns))]))
}

/// The version of a request.
fn version_of(asked: Option<&Tree>) -> &str {
    asked.and_then(|asked| string(asked, "ncp_version")).unwrap_or(WIRE_VERSION)
}

/// What the text leaves open of a request, whatever came before it.
fn own_openness(written: &str, of: &str, strict: bool) -> Option<&'static str> {
    let why = match freedom(of, written.as_bytes(), strict) {
        Freedom::Open(why) | Freedom::MayRejectFor(why) => Some(why),
        Freedom::MayReject if of != "open_session" => Some("a version that may be rejected, WIRE-039"),
        _ => None,
    };
    // Its reply may be longer than a frame may be.
    let is_long = LONG.contains(&written.len()) && written.contains("population_sizes");
    why.or(is_long.then_some("what a request leaves whose reply would be longer than a frame may be"))
}

/// Whether the specification reads a frame as one of this kind.
fn is_read(kind: &str, written: &str) -> bool {
    let args = object([("kind", text(kind.to_owned())), ("text", text(written.to_owned()))]);
    matches!(specification(Call::Decode, &args.to_string()), Answer::Result(_))
}

/// What the text leaves open of the opening of a session; `is_full`: the peer refuses it and may hold another;
/// `may_open`: no server has to refuse it for its version or, a strict one, for its key.
fn opening_openness(
    asked: Option<&Tree>,
    reply: &Tree,
    kind: &str,
    is_open: bool,
    is_full: bool,
    may_open: bool,
) -> Option<&'static str> {
    match kind {
        "session_opened" if reply.get("ok") != Some(&Json::Bool(false)) => {
            if asked.and_then(Session::read).is_none() {
                return Some("which networks a server has is its own affair");
            }
            is_full.then_some(FULL)
        }
        "session_opened" if may_open && is_open => Some(OPEN_ALREADY),
        "error" | "session_opened" if may_open && Session::is_network(asked) => {
            Some("whether a server opens such a network is its own affair")
        }
        "session_opened" if may_open => Some("which networks a server has is its own affair"),
        _ => None,
    }
}

fn is_opened(reply: &str) -> bool {
    Json::parse(reply).is_ok_and(|reply| reply.get("kind").and_then(Json::as_str) == Some("session_opened"))
        && !refuses(reply)
}

fn refuses(reply: &str) -> bool {
    Json::parse(reply).is_ok_and(|reply| {
        reply.get("kind").and_then(Json::as_str) == Some("error") || reply.get("ok") == Some(&Json::Bool(false))
    })
}

/// A frame of this kind as an encoder writes it: with every field, in the order of the tables. `// [NCP-WIRE-080]`
fn written(kind: &str, known: Vec<(&str, Tree)>) -> Tree {
    let message = tables().kind(kind);
    let mut known: HashMap<&str, Tree> = known.into_iter().collect();
    let fields = message.map_or(&[][..], |message| &message.fields).iter().map(|field| {
        let name = field.name.as_str();
        (name.to_owned(), if name == "kind" { text(kind) } else { known.remove(name).unwrap_or_else(anything) })
    });
    object([("$frame", exactly(map(fields.collect())))])
}

fn anything() -> Tree {
    object([("$anything", Json::Bool(true))])
}

/// An error frame, which names a session or not. `// [NCP-WIRE-102]`
fn error_frame() -> Tree {
    written("error", vec![("session_id", any(vec![Json::Null, anything()]))])
}

/// What a reply has to be; `level` is the greatest of the terms that its samples do not show.
fn pattern(reply: &Tree, kind: &str, of: &str, is_refused_for_version: bool, level: f64) -> Tree {
    let error = error_frame;
    let id = reply.get("session_id").cloned().unwrap_or(Json::Null);
    let ok = reply.get("ok").cloned().unwrap_or(Json::Bool(true));
    match kind {
        "session_opened" | "session_closed" => {
            let mut known = vec![("session_id", id), ("ok", ok.clone())];
            if let Some(resolved) = reply.get("resolved").filter(|_| ok == Json::Bool(true)) {
                known.push(("resolved", resolved.clone()));
            }
            let own = written(kind, known);
            if ok == Json::Bool(false) { any(vec![own, error()]) } else { own }
        }
        "observation_frame" => {
            let time = double(reply.get("sim_time_ms")).unwrap_or(0.0);
            let records =
                members(reply.get("records")).iter().map(|(port, record)| (port.to_string(), record_of(record, level)));
            let known = vec![
                ("session_id", id),
                // [NCP-SESS-058] The double nearest to one product.
                ("sim_time_ms", super::range(time, time)),
                ("records", exactly(map(records.collect()))),
                ("calibrated_posterior", Json::Bool(false)),
                ("is_simulation_output", Json::Bool(true)),
            ];
            written(kind, known)
        }
        // A session that is not open is closed with either.
        _ if of == "close_session" => any(vec![error(), written("session_closed", vec![("ok", Json::Bool(false))])]),
        // What its version and another rule reject is refused by either, and so is what breaks no rule of chapter 1.
        _ if of == "open_session" && is_refused_for_version => {
            any(vec![error(), written("session_opened", vec![("ok", Json::Bool(false))])])
        }
        _ => error(),
    }
}

/// How much of the greatest term a value may be off.
const CANCELLED: f64 = 1e-14;

/// An observation, its numbers within the tolerance of the text.
fn record_of(record: &Tree, level: f64) -> Tree {
    let values = items(record.get("values")).iter().filter_map(|value| double(Some(value)));
    let greatest = values.map(f64::abs).fold(level, f64::max);
    let mut pattern = object([]);
    for (name, value) in members(Some(record)) {
        match name.as_ref() {
            "times" => set(&mut pattern, name, near_list(value, TOLERANCE, 0.0)),
            "values" => set(&mut pattern, name, near_list(value, TOLERANCE, CANCELLED * greatest)),
            "senders" | "port" | "target" | "observable" => set(&mut pattern, name, value.clone()),
            "unit" if matches!(value.as_str(), Some("mV" | "Hz")) => set(&mut pattern, name, value.clone()),
            _ => set(&mut pattern, name, anything()),
        }
    }
    pattern
}

/// What a server that claims the reference networks bears: so many neurons in a session, and so many neurons times
/// steps and samples in a request. Section 4.4.
const MOST_NEURONS: f64 = 1e5;
const MOST_NEURON_STEPS: f64 = 2e7;
const MOST_SAMPLES: f64 = 1e6;
const TOO_LARGE: &str = "a server may refuse a request as large as this";

/// A session of a reference network, as far as the text says what it does.
struct Session {
    dt: f64,
    chunk: f64,
    neurons: f64,
    /// The steps since the opening.
    steps: f64,
    records: Vec<Sampled>,
    ports: Vec<String>,
    /// The magnitude of the potential at rest, in mV.
    rest: f64,
    /// What a current of 1 pA, or an input of 1 Hz, adds in a step.
    gain: f64,
    /// The magnitude of the constant current or input, in pA or Hz.
    constant: f64,
    /// The magnitude of the current or input of each port, in pA or Hz.
    driven: HashMap<String, f64>,
    is_lif: bool,
}

/// What a port samples: so many neurons, every so many steps; spikes are counted as if all came.
struct Sampled {
    neurons: f64,
    every: f64,
}

impl Session {
    /// Whether a request asks for one of the networks.
    fn is_network(asked: Option<&Tree>) -> bool {
        let network = asked.and_then(|asked| asked.get("network"));
        network.and_then(|network| string(network, "ref")).is_some_and(|name| name.starts_with("ncp.reference."))
    }

    fn read(asked: &Tree) -> Option<Self> {
        let network = asked.get("network")?;
        let known: &[&str] = match string(network, "ref")? {
            "ncp.reference.lif" => &LIF,
            "ncp.reference.rate" => &RATE,
            _ => return None,
        };
        let is_lif = known.len() == LIF.len();
        let params = members(network.get("params"));
        let param = |name: &str, default: f64| {
            params.iter().find(|(known, _)| known == name).and_then(|(_, value)| double(Some(value))).unwrap_or(default)
        };
        let sim = asked.get("sim");
        let time = |name: &str, default: f64| sim.and_then(|sim| double(sim.get(name))).unwrap_or(default);
        let (dt, chunk) = (time("dt_ms", 0.1), time("chunk_ms", 10.0));
        let sizes = members(network.get("population_sizes"));
        let size = |name: &str| sizes.iter().find(|(known, _)| known == name).and_then(|(_, size)| integer(Some(size)));
        let targets = |spec: &str| items(asked.get(spec).and_then(|spec| spec.get("targets")));
        let fits = |target: &&Tree, kinds: &[&str], name: &str, default: &str| {
            let of = string(target, "target").and_then(size);
            let ids = items(target.get("ids"));
            let ids: Option<Vec<i64>> = ids.iter().map(|id| integer(Some(id))).collect();
            kinds.contains(&string(target, name).unwrap_or(default))
                && of.is_some()
                && ids.is_some_and(|ids| {
                    // What a neuron that is named twice gives, the text does not say.
                    let once: BTreeSet<&i64> = ids.iter().collect();
                    once.len() == ids.len() && ids.iter().all(|id| (1..=of.unwrap_or(0)).contains(id))
                })
        };
        let observables: &[&str] = if is_lif { &["V_m", "spikes"] } else { &["rate"] };
        let stimuli: &[&str] = if is_lif { &["current_pA"] } else { &["rate_inject"] };
        let mut ports: Vec<&str> = targets("record").iter().map(|t| string(t, "port").unwrap_or_default()).collect();
        let count = ports.len();
        ports.sort_unstable();
        ports.dedup();
        // What two targets of one port are, the text does not say.
        let mut driven: Vec<&str> = targets("stimulus").iter().map(|t| string(t, "port").unwrap_or_default()).collect();
        driven.sort_unstable();
        driven.dedup();
        let is_time = |ms: f64| ms > 0.0 && ms < 1e7;
        let plain = (0.01..=100.0).contains(&dt)
            && (chunk == 0.0 || is_time(chunk))
            && params.iter().all(|(name, _)| known.contains(&name.as_ref()))
            && ports.len() == count
            && driven.len() == targets("stimulus").len()
            && targets("record").iter().all(|target| {
                fits(&target, observables, "observable", "V_m")
                    && is_time(double(target.get("cadence_ms")).unwrap_or(1.0))
                    && items(target.get("recordables")).is_empty()
            })
            && targets("stimulus")
                .iter()
                .all(|target| fits(&target, stimuli, "kind", "current_pA") && members(target.get("params")).is_empty())
            && sizes.iter().all(|(_, size)| integer(Some(size)).is_some_and(|size| (0..=4096).contains(&size)))
            && string(network, "kind").unwrap_or("builtin") == "builtin"
            && items(asked.get("bindings")).iter().all(|binding| {
                let port = string(binding, "port").unwrap_or_default();
                match string(binding, "direction") {
                    None | Some("stimulus") => driven.contains(&port),
                    Some("record") => ports.contains(&port),
                    Some(_) => false,
                }
            })
            && sim.is_none_or(|sim| matches!(string(sim, "mode"), None | Some("stream" | "batch")));
        let refractory = param("t_ref", 2.0) / dt;
        let sane = if is_lif {
            (1e-3..1e12).contains(&param("tau_m", 10.0))
                && (1e-3..1e6).contains(&param("C_m", 250.0))
                && (0.0..1e6).contains(&refractory)
        } else {
            (1e-3..1e12).contains(&param("tau", 10.0))
        };
        let ports = targets("stimulus").iter().map(|t| string(t, "port").unwrap_or_default().to_owned());
        let records = targets("record").iter().map(|target| {
            let named = items(target.get("ids")).len() as f64;
            let all = string(target, "target").and_then(size).unwrap_or(0) as f64;
            let is_of_spikes = string(target, "observable") == Some("spikes");
            let every = (double(target.get("cadence_ms")).unwrap_or(1.0) / dt).round().max(1.0);
            Sampled { neurons: if named > 0.0 { named } else { all }, every: if is_of_spikes { 1.0 } else { every } }
        });
        (plain && sane).then(|| Self {
            dt,
            chunk,
            neurons: sizes.iter().filter_map(|(_, size)| integer(Some(size))).sum::<i64>() as f64,
            steps: 0.0,
            records: records.collect(),
            ports: ports.collect(),
            rest: if is_lif { param("E_L", -70.0).abs() } else { 0.0 },
            gain: if is_lif {
                let tau = param("tau_m", 10.0);
                tau / param("C_m", 250.0) * -(-dt / tau).exp_m1()
            } else {
                -(-dt / param("tau", 10.0)).exp_m1()
            },
            constant: param(if is_lif { "I_e" } else { "mu" }, 0.0).abs(),
            driven: HashMap::new(),
            is_lif,
        })
    }

    /// Takes a step or a run: its time passes, and its stimuli act from now on. The greatest of the terms that its
    /// samples do not show.
    fn take(&mut self, asked: &Tree) -> f64 {
        self.steps += self.steps_of(asked);
        for (port, value) in members(asked.get("stimulus").and_then(|stimulus| stimulus.get("values"))) {
            if let Some(value) = double(items(value.get("data")).first()) {
                self.driven.insert(port.to_string(), value.abs());
            }
        }
        self.rest.max(self.gain * self.driven.values().fold(self.constant, |sum, value| sum + value)).min(f64::MAX)
    }

    /// What the text leaves open of a request for this session.
    fn step_openness(&self, asked: &Tree, of: &str) -> Option<&'static str> {
        matches!(of, "step_request" | "run_request").then(|| self.openness(asked)).flatten()
    }

    /// The time of a step or a run of this session.
    fn time_of(&self, asked: &Tree) -> f64 {
        let named = |name| double(asked.get(name).filter(|time| !time.is_null()));
        ["advance_ms", "duration_ms"].into_iter().find_map(named).unwrap_or(self.chunk)
    }

    /// The steps of a step or a run of this session: its time is the nearest number of them. `// [NCP-SESS-058]`
    fn steps_of(&self, asked: &Tree) -> f64 {
        (self.time_of(asked) / self.dt).round()
    }

    /// What the text leaves open of a step or a run of this session.
    fn openness(&self, asked: &Tree) -> Option<&'static str> {
        let time = self.time_of(asked);
        let values = asked.get("stimulus").and_then(|stimulus| stimulus.get("values"));
        if time == 0.0 && !members(values).is_empty() {
            return Some("what a step of 0 ms leaves at a port, if a server refuses it");
        }
        let steps = self.steps_of(asked);
        let due = |at: f64, record: &Sampled| (at / record.every).floor() * record.neurons;
        let samples = self.records.iter().map(|record| due(self.steps + steps, record) - due(self.steps, record));
        // What is no time is refused, and not for its size.
        let is_large = self.neurons > MOST_NEURONS
            || steps * self.neurons.max(1.0) > MOST_NEURON_STEPS
            || samples.sum::<f64>() > MOST_SAMPLES;
        if is_large && time.is_finite() {
            return Some(TOO_LARGE);
        }
        members(values).iter().find_map(|(port, value)| {
            let data = items(value.get("data"));
            let fits = data.len() == 1 && double(data.first()).is_some_and(f64::is_finite);
            let unit = value.get("unit").filter(|unit| !unit.is_null());
            let is_plain = fits && unit.is_none_or(|unit| self.is_lif && unit.as_str() == Some("pA"));
            let is_port = self.ports.iter().filter(|known| *known == port).count() == 1;
            (!is_plain || !is_port).then_some("a stimulus that does not fit its port")
        })
    }
}

/// Whether other thresholds, by less than the tolerance, give other replies.
fn differs_by_rounding(args: &Tree, result: &Tree) -> bool {
    [1.0 - 1e-12, 1.0 + 1e-12].into_iter().any(|by| differs(args, result, &|request| moved(request, by)))
}

/// Potentials, currents and rates of less than this leave the doubles by no product with a time.
const MODEST: f64 = 1e200;

/// Whether a product or a sum on the way may leave the doubles where the number itself does not. A server may fail
/// then, and need not. Without one, all potentials and currents times a power of two give the same replies times that.
/// Section 4.4.
fn differs_by_order(args: &Tree, result: &Tree) -> bool {
    let requests = || items(args.get("requests")).iter().filter_map(|request| Json::parse(request.as_str()?).ok());
    if requests().all(|request| lengths(&own(&request)).iter().all(|length| length.abs() < MODEST)) {
        return false;
    }
    // A quotient by a small capacity, before the product with a short time.
    if requests().any(|request| network_of(&own(&request)).is_some() && is_short(&own(&request))) {
        return true;
    }
    let slack = requests().map(|request| slack(&own(&request))).fold(1.0, f64::max).log2().ceil().exp2();
    // So large that it cannot be scaled: what it comes to is known of a request that fails, and of no other.
    let mut replied = items(args.get("requests")).iter().zip(items(result.get("replies")));
    let is_beyond = replied.any(|(request, reply)| {
        let request = request.as_str().and_then(|text| Json::parse(text).ok()).map(|request| own(&request));
        request.is_some_and(|request| lengths(&request).iter().any(|length| length.abs() > f64::MAX / slack))
            && !reply.as_str().is_some_and(refuses)
    });
    is_beyond || [1.0 / slack, slack].into_iter().any(|by| differs(args, result, &|request| scaled(request, by)))
}

/// How far what is computed on the way to a number may be above the number after one step of an opened session.
fn slack(asked: &Tree) -> f64 {
    let of = |name: &str, default: f64| {
        let params = asked.get("network").and_then(|network| network.get("params"));
        params.and_then(|params| double(params.get(name))).unwrap_or(default)
    };
    let dt = asked.get("sim").and_then(|sim| double(sim.get("dt_ms"))).unwrap_or(0.1);
    match network_of(asked) {
        Some("ncp.reference.lif") => {
            let (tau, capacity) = (of("tau_m", 10.0), of("C_m", 250.0));
            16.0 * (tau * capacity).max(tau).max(capacity).max(1.0) / dt.min(tau)
        }
        Some("ncp.reference.rate") => 16.0 * of("tau", 10.0).max(1.0) / dt.min(of("tau", 10.0)),
        _ => 1.0,
    }
}

/// Whether the time constant of an opened network is below 1 ms.
fn is_short(asked: &Tree) -> bool {
    let params = asked.get("network").and_then(|network| network.get("params"));
    ["tau_m", "tau"].iter().any(|name| params.and_then(|params| double(params.get(name))).is_some_and(|tau| tau < 1.0))
}

/// Whether requests that are changed so are answered otherwise.
fn differs(args: &Tree, result: &Tree, change: &dyn Fn(&mut Tree)) -> bool {
    let changed = |request: &Tree| {
        let parsed = request.as_str().and_then(|text| Json::parse(text).ok());
        parsed.map_or_else(
            || request.clone(),
            |asked| {
                let mut asked = own(&asked);
                let before = asked.clone();
                change(&mut asked);
                if asked == before { request.clone() } else { text(asked.to_string()) }
            },
        )
    };
    let mut other = args.clone();
    set(&mut other, "requests", list(items(args.get("requests")).iter().map(changed).collect()));
    match specification(Call::SessionRun, &other.to_string()) {
        Answer::Result(moved) => Json::parse(&moved).is_ok_and(|moved| shape(&moved) != shape(result)),
        _ => true,
    }
}

fn network_of(asked: &Tree) -> Option<&str> {
    if string(asked, "kind") != Some("open_session") {
        return None;
    }
    asked.get("network").and_then(|network| string(network, "ref"))
}

/// The params of a network that are potentials, currents or rates, and what each is where none is named.
fn lengths_of(network: Option<&str>) -> &'static [(&'static str, f64)] {
    match network {
        Some("ncp.reference.lif") => &[("E_L", -70.0), ("V_th", -55.0), ("V_reset", -70.0), ("I_e", 0.0)],
        Some("ncp.reference.rate") => &[("mu", 0.0)],
        _ => &[],
    }
}

/// The potentials, currents and rates of a request.
fn lengths(asked: &Tree) -> Vec<f64> {
    let params = asked.get("network").and_then(|network| network.get("params"));
    let of_network = lengths_of(network_of(asked)).iter().filter_map(|(name, _)| double(params?.get(name)));
    let values = members(asked.get("stimulus").and_then(|stimulus| stimulus.get("values")));
    of_network
        .chain(values.iter().flat_map(|(_, value)| items(value.get("data"))).filter_map(|v| double(Some(v))))
        .collect()
}

/// Changes params of the network that a request opens.
fn change_params(asked: &mut Tree, names: &[(&str, f64)], change: impl Fn(f64) -> f64) {
    let Some(mut network) = asked.get("network").filter(|_| !names.is_empty()).cloned() else { return };
    let mut params = network.get("params").cloned().unwrap_or_else(|| object([]));
    for (name, default) in names {
        let value = double(params.get(name)).unwrap_or(*default);
        set(&mut params, name, spelled(change(value)));
    }
    set(&mut network, "params", params);
    set(asked, "network", network);
}

/// Gives a request whose network has another threshold.
fn moved(asked: &mut Tree, by: f64) {
    if network_of(asked) == Some("ncp.reference.lif") {
        change_params(asked, &[("V_th", -55.0)], |threshold| threshold * by);
    }
}

/// Gives a request all of whose potentials, currents and rates are so many times what they were.
fn scaled(asked: &mut Tree, by: f64) {
    let scale = |value: f64| (value * by).clamp(-f64::MAX, f64::MAX);
    change_params(asked, lengths_of(network_of(asked)), scale);
    let Some(mut stimulus) = asked.get("stimulus").cloned() else { return };
    let Some(Json::Object(mut values)) = stimulus.get("values").cloned() else { return };
    for (_, value) in &mut values {
        let data = items(value.get("data")).iter();
        let data = data.map(|item| double(Some(item)).map_or_else(|| item.clone(), |item| spelled(scale(item))));
        let data = list(data.collect());
        set(value, "data", data);
    }
    set(&mut stimulus, "values", Json::Object(values));
    set(asked, "stimulus", stimulus);
}

/// Of replies, what roundings of numbers do not touch: how long each is in lines of its JSON.
fn shape(result: &Json<'_>) -> Vec<(String, usize)> {
    items(result.get("replies"))
        .iter()
        .map(|reply| {
            let parsed = reply.as_str().and_then(|text| Json::parse(text).ok());
            let count = parsed.as_ref().map_or(0, |reply| reply.to_string().matches(',').count());
            let times = parsed.as_ref().and_then(|reply| reply.get("records")).map(|records| {
                let spikes =
                    members(Some(records)).iter().map(|(_, record)| record.get("times").map(ToString::to_string));
                spikes.flatten().collect::<Vec<_>>().join(";")
            });
            (times.unwrap_or_default(), count)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::Input;
    use crate::fuzz::oracle::expectation;
    use crate::fuzz::tree::doubles;

    #[test]
    fn a_strict_server_closes_no_session_for_a_request_of_another_version_or_key_and_says_so_by_an_error_frame() {
        let call = crate::peer::Call::SessionRun;
        let reply = |version: &str, verb: &str| {
            let request = format!(r#"{{{version}"kind":"close_session","session_id":"a"}}"#);
            let request = text(request).to_string();
            let written = format!(r#"{{"requests":[{request}],"strict":true,"verbs":["{verb}"]}}"#);
            let args = own(&Json::parse(&written).unwrap());
            match expectation(&Input { call, args }, &specification(call, &written), None) {
                Verdict::Expect(expect) => expect.to_string(),
                Verdict::Open(why) => panic!("{why}"),
            }
        };
        let own_version = format!("\"ncp_version\":\"{WIRE_VERSION}\",");
        assert!(reply(&own_version, "close_session").contains("session_closed"));
        for rejected in [reply("", "close_session"), reply(&own_version, "step_request")] {
            assert!(!rejected.contains("session_closed") && rejected.contains("error"), "{rejected}");
        }
    }

    #[test]
    fn an_opening_whose_refusal_does_not_fit_into_a_frame_may_be_refused_in_either_way() {
        let call = crate::peer::Call::SessionRun;
        let ask = |network: &str| {
            let head = format!(r#""ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"a""#);
            let request = format!(r#"{{{head},"network":{{"ref":{network}}}}}"#);
            let args = object([("requests", list(vec![text(request)]))]);
            let answer = specification(call, &args.to_string());
            let Answer::Result(result) = &answer else { panic!("{answer:?}") };
            let is_error = result.contains(r#"\"kind\":\"error\""#);
            (is_error, expectation(&Input { call, args }, &answer, None))
        };
        // What is not ASCII takes more room in what is said about it.
        let long = text("\u{85}".repeat(300_000)).to_string();
        let (is_error, verdict) = ask(&long);
        let has_both = |verdict: &Verdict| match verdict {
            Verdict::Expect(expect) => expect.to_string().contains("session_opened"),
            Verdict::Open(why) => panic!("{why}"),
        };
        assert!(is_error && has_both(&verdict), "{is_error} {verdict:?}");
        let (is_error, verdict) = ask("5");
        assert!(is_error && !has_both(&verdict), "{is_error} {verdict:?}");
    }

    #[test]
    fn a_reply_has_every_field_in_order_and_an_error_frame_names_a_session_or_none() {
        let open = format!(
            r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"a","network":
            {{"ref":"ncp.reference.lif","population_sizes":{{"n":1}}}}}}"#
        );
        let args = object([("requests", list(vec![text(open), text("x")]))]);
        let (call, written) = (Call::SessionRun, args.to_string());
        let Verdict::Expect(expect) = expectation(&Input { call, args }, &specification(call, &written), None) else {
            panic!("both are decided");
        };
        let any = r#"{"$anything":true}"#;
        let head = r#""kind":"session_opened","session_id":"a","ok":true"#;
        let opened = format!(r#"{{"$frame":{{"$exact":{{"ncp_version":{any},{head},"backend":{any}"#);
        let error = format!(r#"{{"kind":"error","error":{any},"session_id":{{"$any":[null,{any}]}}}}"#);
        let expect = expect.to_string();
        assert!(expect.contains(&opened) && expect.contains(&error), "{expect}");
    }

    #[test]
    fn a_request_is_asked_for_up_to_the_size_that_a_server_bears() {
        let open = |size: u32, cadence: &str| {
            let asked = format!(
                r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"a",
                "network":{{"ref":"ncp.reference.lif","population_sizes":{{"pop":{size}}}}},"sim":{{"dt_ms":1.0}},
                "record":{{"targets":[{{"port":"v","target":"pop","cadence_ms":{cadence}}}]}}}}"#
            );
            Session::read(&own(&Json::parse(&asked).unwrap())).unwrap()
        };
        let asked = |ms: &str| own(&Json::parse(&format!(r#"{{"advance_ms":{ms}}}"#)).unwrap());
        let of = |session: &Session, ms: &str| session.openness(&asked(ms)).is_some();
        assert!(!of(&open(100, "100.0"), "200000.0"));
        assert!(of(&open(100, "100.0"), "200001.0"), "too many neurons times steps");
        assert!(!of(&open(100, "1.0"), "10000.0"));
        assert!(of(&open(100, "1.0"), "10001.0"), "too many samples");
        let mut session = open(1000, "10.0");
        assert!(!of(&session, "10009.0"), "what is not due costs nothing");
        session.take(&asked("5.0"));
        assert!(!of(&session, "10004.0") && of(&session, "10005.0"), "by the cadence since the opening");
    }

    #[test]
    fn no_case_of_the_corpus_asks_a_server_for_more_than_it_bears_but_the_one_that_lets_it_refuse() {
        let suite = crate::suite::Suite::embedded().unwrap();
        let (mut asked, mut larger) = (0, Vec::new());
        for case in suite.cases().iter().filter(|case| case.call == Call::SessionRun) {
            let body = format!("{{{}", case.body());
            let body = Json::parse(&body).unwrap();
            let mut open: HashMap<String, Session> = HashMap::new();
            for request in items(body.get("args").and_then(|args| args.get("requests"))) {
                let Some(request) = request.as_str().and_then(|text| Json::parse(text).ok()) else { continue };
                let request = own(&request);
                let id = string(&request, "session_id").unwrap_or_default().to_owned();
                if let Some(session) = Session::read(&request) {
                    open.insert(id, session);
                } else if let Some(session) = open.get(&id) {
                    asked += 1;
                    if session.openness(&request) == Some(TOO_LARGE) {
                        larger.push(case.id.as_str());
                    }
                }
            }
        }
        assert_eq!(larger, ["session/reference/far/samples/too-many"]);
        assert!(asked > 1500, "{asked}");
    }

    #[test]
    fn a_session_that_the_text_describes_is_told_from_others() {
        let open = |params: &str, dt: &str| {
            let asked = format!(
                r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"a",
                "network":{{"ref":"ncp.reference.lif","population_sizes":{{"pop":1}},"params":{params}}},
                "sim":{{"dt_ms":{dt}}}}}"#
            );
            Session::read(&own(&Json::parse(&asked).unwrap())).is_some()
        };
        assert!(open("{}", "1.0"));
        assert!(!open(r#"{"tau":1.0}"#, "1.0"));
        assert!(open(r#"{"t_ref":1.5}"#, "1.0"));
        assert!(open(r#"{"V_reset":-50.0}"#, "1.0"));
        assert!(open("{}", "0.3"));
        assert!(!open("{}", "0.001"));
    }

    #[test]
    fn a_port_may_name_its_neurons_in_any_order_and_none_of_them_twice() {
        let open = |ids: &str| {
            let asked = format!(
                r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"a",
                "network":{{"ref":"ncp.reference.lif","population_sizes":{{"pop":3}}}},"sim":{{"dt_ms":1.0}},
                "record":{{"targets":[{{"port":"v","target":"pop","ids":{ids}}}]}}}}"#
            );
            Session::read(&own(&Json::parse(&asked).unwrap())).is_some()
        };
        assert!(open("[1,2,3]") && open("[3,1,2]"));
        assert!(!open("[2,2]") && !open("[1,2,1]") && !open("[4]"));
    }

    /// Of each reply of a trace, whether it is open.
    fn openness(requests: &[&str], rest: &str) -> Vec<bool> {
        let open = format!(
            r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"a","bindings":[{{"port":"v",
            "direction":"record"}},{{"port":"in"}}],"network":{{"ref":"ncp.reference.lif","population_sizes":
            {{"pop":1,"none":0}}}},"record":{{"targets":[{{"port":"v","target":"pop"}}]}},"stimulus":{{"targets":
            [{{"port":"in","target":"pop"}}]}},"sim":{{"dt_ms":1.0,"mode":"batch"}}}}"#
        );
        let requests = std::iter::once(open.as_str()).chain(requests.iter().copied()).map(text).collect();
        let mut args = object([("requests", list(requests))]);
        for (name, value) in members(Some(&own(&Json::parse(&format!("{{{rest}}}")).unwrap()))) {
            set(&mut args, name, value.clone());
        }
        let (call, written) = (Call::SessionRun, args.to_string());
        match expectation(&Input { call, args }, &specification(call, &written), None) {
            Verdict::Expect(expect) => items(expect.get("value").and_then(|value| value.get("replies")))
                .iter()
                .map(|reply| reply.get("$anything").is_some())
                .collect(),
            Verdict::Open(why) => panic!("{why}"),
        }
    }

    #[test]
    fn a_step_of_no_time_leaves_what_comes_behind_it_decided_unless_it_brings_a_stimulus() {
        let step = |rest: &str| format!(r#"{{"kind":"step_request","session_id":"a"{rest}}}"#);
        let (none, later) = (step(r#","advance_ms":0.0"#), step(r#","advance_ms":1.0"#));
        assert_eq!(openness(&[&none, &later], ""), [false; 3]);
        let driven = step(r#","advance_ms":0.0,"stimulus":{"values":{"in":{"data":[300.0]}}}"#);
        assert_eq!(openness(&[&driven, &later], ""), [false, true, true]);
    }

    #[test]
    fn a_stimulus_in_the_unit_of_its_port_is_decided_and_one_in_another_is_open() {
        let step = |unit: &str| {
            format!(
                r#"{{"kind":"step_request","session_id":"a","advance_ms":1.0,
                "stimulus":{{"values":{{"in":{{"data":[300.0],"unit":"{unit}"}}}}}}}}"#
            )
        };
        assert_eq!(openness(&[&step("pA")], ""), [false, false]);
        assert_eq!(openness(&[&step("nA")], ""), [false, true]);
    }

    #[test]
    fn an_opening_at_the_key_of_another_request_is_refused_by_an_error_frame() {
        let network = r#""network":{"ref":"ncp.reference.lif","population_sizes":{"pop":1}}"#;
        let again = format!(r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"b",{network}}}"#);
        let verbs = r#""strict":true,"verbs":["open_session","step_request"]"#;
        assert!(!openness(&[&again], verbs)[1]);
    }

    /// A request for a session of one neuron.
    fn open(id: &str) -> String {
        format!(
            r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"{id}",
            "network":{{"ref":"ncp.reference.lif","population_sizes":{{"n":1}}}}}}"#
        )
    }

    /// What is asked, without a look at its answers, of a server that holds several sessions, and of one with room
    /// for one.
    fn with_room_for_several_and_one(requests: &[String]) -> [Tree; 2] {
        let args = object([("requests", list(requests.iter().map(text).collect()))]);
        let (call, written) = (Call::SessionRun, args.to_string());
        let Verdict::Expect(expect) = expectation(&Input { call, args }, &specification(call, &written), None) else {
            panic!("what a server answers is decided");
        };
        let [several, one] = items(expect.get("value").and_then(|value| value.get("$any"))) else {
            panic!("a server may have room for one session");
        };
        [several.clone(), one.clone()]
    }

    #[test]
    fn what_is_open_of_one_session_leaves_nothing_open_of_another() {
        let of = |kind: &str, id: &str, rest: &str| format!(r#"{{"kind":"{kind}","session_id":"{id}"{rest}}}"#);
        let odd = r#","stimulus":{"values":{"no-port":{"data":[1.0]}}}"#;
        let requests = [
            open("a"),
            open("b"),
            of("step_request", "a", odd),
            of("step_request", "a", ""),
            of("step_request", "b", ""),
            of("close_session", "a", ""),
            of("step_request", "a", ""),
            of("close_session", "b", r#","ncp_version":"7.0""#),
            of("step_request", "b", ""),
        ];
        let [several, one] = with_room_for_several_and_one(&requests);
        let openness = |replies: &Tree| -> Vec<bool> {
            items(replies.get("replies")).iter().map(|reply| reply.get("$anything").is_some()).collect()
        };
        assert_eq!(openness(&several), [false, false, true, true, false, true, false, true, true]);
        assert_eq!(openness(&one), [false, false, true, true, true, true, false, true, true]);
        let refusal = items(one.get("replies"))[1].to_string();
        assert!(refusal.contains(r#""kind":"error""#) && refusal.contains(r#""ok":false"#), "{refusal}");
    }

    #[test]
    fn a_server_with_room_for_one_session_refuses_the_second_and_what_is_asked_of_it() {
        let of = |kind: &str, id: &str| format!(r#"{{"kind":"{kind}","session_id":"{id}"}}"#);
        let requests = [open("a"), open("b"), of("close_session", "b"), open("b"), of("close_session", "a")];
        let [_, one] = with_room_for_several_and_one(&requests);
        let refused: Vec<bool> =
            items(one.get("replies")).iter().map(|reply| reply.to_string().contains(r#""ok":false"#)).collect();
        assert_eq!(refused, [false, true, false, true, false]);
        assert!(items(one.get("replies"))[2].get("$anything").is_some());
    }

    #[test]
    fn whether_a_server_has_another_network_is_its_own_affair_and_a_version_is_not() {
        let open = |version: &str| {
            format!(r#"{{{version}"kind":"open_session","session_id":"b","network":{{"ref":"another"}}}}"#)
        };
        assert!(openness(&[&open(&format!(r#""ncp_version":"{WIRE_VERSION}","#))], "")[1]);
        assert!(!openness(&[&open(r#""ncp_version":"7.0","#)], "")[1]);
        assert!(openness(&[&open("")], "")[1], "the version of the server is meant");
        assert!(!openness(&[&open("")], r#""strict":true"#)[1], "a strict server asks for a version");
    }

    #[test]
    fn an_opening_that_the_peer_refuses_leaves_its_session_decided() {
        let open = open("a");
        let step = r#"{"kind":"step_request","session_id":"a"}"#.to_owned();
        let written = object([("requests", list([open.clone(), open, step].map(text).into()))]).to_string();
        let spec = specification(Call::SessionRun, &written);
        let Answer::Result(refusing) = &spec else { panic!("the specification answers") };
        let refusing = peer::Answer::Result(own(&Json::parse(refusing).unwrap()));
        let is_open = |said: Option<&peer::Answer<'_>>| -> Vec<bool> {
            let args = own(&Json::parse(&written).unwrap());
            let Verdict::Expect(expect) = expectation(&Input { call: Call::SessionRun, args }, &spec, said) else {
                panic!("what a server answers is decided");
            };
            let replies = items(expect.get("value").and_then(|value| value.get("replies")));
            replies.iter().map(|reply| reply.get("$anything").is_some()).collect()
        };
        assert_eq!(is_open(Some(&refusing)), [false, true, false]);
        assert_eq!(is_open(None), [false, true, true], "another server may have opened it anew");
    }

    /// What is expected of a network with these params, that two requests with these stimuli are for.
    fn of_params(reference: &str, params: &str, values: [&str; 2]) -> Verdict {
        let kind = if reference.ends_with("lif") { "current_pA" } else { "rate_inject" };
        let open = format!(
            r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"a",
            "network":{{"ref":"{reference}","population_sizes":{{"pop":1}},"params":{params}}},"sim":{{"dt_ms":1.0}},
            "stimulus":{{"targets":[{{"port":"in","target":"pop","kind":"{kind}"}}]}}}}"#
        );
        let step = |value: &str| {
            let values = format!(r#"{{"values":{{"in":{{"data":[{value}]}}}}}}"#);
            format!(r#"{{"kind":"step_request","session_id":"a","advance_ms":2.0,"stimulus":{values}}}"#)
        };
        let requests = [open, step(values[0]), step(values[1])].map(text);
        let args = object([("requests", list(requests.into()))]);
        let (call, written) = (Call::SessionRun, args.to_string());
        expectation(&Input { call, args }, &specification(call, &written), None)
    }

    #[test]
    fn a_number_that_leaves_the_doubles_is_decided_unless_only_a_product_on_the_way_does() {
        let fails = |verdict: Verdict| match verdict {
            Verdict::Expect(expect) => {
                let replies = items(expect.get("value").and_then(|value| value.get("replies"))).to_vec();
                Some(replies.iter().map(|reply| reply.to_string().contains(r#""kind":"error""#)).collect::<Vec<_>>())
            }
            Verdict::Open(_) => None,
        };
        let lif = |params: &str, values| fails(of_params("ncp.reference.lif", params, values));
        // A V beyond the largest double by three powers of ten, and behind it one that is not.
        assert_eq!(lif(r#"{"C_m":0.001}"#, ["1e308", "1.0"]), Some(vec![false, true, false]));
        // Far from it.
        assert_eq!(lif("{}", ["1e290", "-1e290"]), Some(vec![false, false, false]));
        // I·tau_m overflows, and V does not.
        assert_eq!(lif("{}", ["1e308", "1.0"]), None);
        // I·tau_m / C_m is within a power of ten of the largest.
        assert_eq!(lif(r#"{"C_m":1.0}"#, ["1e307", "1.0"]), None);
        assert_eq!(lif(r#"{"C_m":0.001,"tau_m":0.01}"#, ["1e305", "1.0"]), None);
        let rate = |values| fails(of_params("ncp.reference.rate", r#"{"mu":8e307}"#, values));
        // mu + x overflows, and r does not.
        assert_eq!(rate(["1.7e308", "1.0"]), None);
    }

    #[test]
    fn a_value_may_be_off_by_a_part_of_the_current_that_cancels_it_while_that_acts() {
        let asked = |value: f64| {
            let values = object([("in", object([("data", list(vec![spelled(value)]))]))]);
            object([("stimulus", object([("values", values)]))])
        };
        let open = format!(
            r#"{{"ncp_version":"{WIRE_VERSION}","kind":"open_session","session_id":"a",
            "network":{{"ref":"ncp.reference.lif","population_sizes":{{"pop":1}},"params":{{"I_e":250.0}}}},
            "sim":{{"dt_ms":10.0}}}}"#
        );
        let mut session = Session::read(&own(&Json::parse(&open).unwrap())).unwrap();
        // 10 ms / 250 pF · (1 − e⁻¹) · 250 pA, below the 70 mV of rest.
        assert_eq!(session.take(&object([])), 70.0);
        let level = session.take(&asked(-24_750.0));
        assert!((level - 1000.0 * (1.0 - (-1_f64).exp())).abs() < 1e-9, "{level}");
        assert_eq!(session.take(&asked(0.0)), 70.0);
    }

    #[test]
    fn a_value_may_be_off_by_a_part_of_itself_or_of_the_terms_that_cancel() {
        let range = |values: &str, level: f64| {
            let record = own(&Json::parse(&format!(r#"{{"values":[{values}]}}"#)).unwrap());
            doubles(items(record_of(&record, level).get("values"))[0].get("$range"))
        };
        assert_eq!(range("-50.0", 70.0), [-50.0 - 5e-8, -50.0 + 5e-8]);
        assert_eq!(range("0.0,-100.0", 70.0), [-1e-12, 1e-12]);
        assert_eq!(range("1e-20", 70.0), [1e-20 - 7e-13, 1e-20 + 7e-13]);
        assert_eq!(range("1e-20", 0.0), [1e-20 - 1e-29, 1e-20 + 1e-29]);
    }
}
