//! What is claimed of the safety path, in words and in symbols, and within which bounds.

/// A claim.
#[derive(Debug, Clone, Copy)]
pub struct Claim {
    /// Its name: family and subject.
    pub id: &'static str,
    /// The rules for which it is evidence.
    pub rules: &'static [&'static str],
    /// The claim in words.
    pub sentence: &'static str,
    /// The claim in symbols.
    pub statement: &'static str,
    /// Over what it is quantified, and in what it is bounded.
    pub bounds: &'static str,
    /// What is assumed.
    pub assumptions: &'static [&'static str],
}

impl Claim {
    /// Whether numbers decide of which some are listed: then it is tried, and not proved.
    #[must_use]
    pub fn is_tried(&self) -> bool {
        self.assumptions.contains(&LISTED)
    }

    /// What it is about: the first part of its name.
    #[must_use]
    pub fn family(&self) -> &'static str {
        self.id.split('/').next().unwrap_or_default()
    }
}

/// What is trusted.
pub const TRUSTED: [&str; 5] = [
    "rustc and the processor: the sources run as they were compiled",
    "the copies: the build script takes the sources as they are but for `crate::`, and puts a window behind each, \
     which takes its private state apart by name",
    "the references say what the text says: they are written from its sentences, and share no code with the sources",
    "the kernel: its gates decide as its own proofs say; here they run as they are",
    "the messages of `ncp_spec::wire`, and std's maps",
];
/// What is not shown.
pub const NOT_PROVED: [&str; 6] = [
    "numbers beside those that the bounds list: where numbers decide, the proofs of the kernel speak of all doubles",
    "frames of more channels than the bounds name",
    "the scanner on bytes that are no JSON object but that it comes to an end: the text leaves open what it answers",
    "a burst with a ref_loss of 0, or one so small that S − ref_loss rounds to S: no number of deliveries clears it",
    "that frames arrive and that the loop is run: liveness is claimed of loops whose surroundings are fair",
    "whether the monitor sees unstamped sensor frames (NCP-RES-053): the loop shows it only those that have a seq",
];

/// What makes a claim one that is tried only.
const LISTED: &str = "numbers are those listed, and no others: tried, not proved";
const KERNEL: &str = "which numbers are finite, inside, or above a limit is the kernel's to say, and proved there for \
    all doubles (number, geofence, clamp, latch); here they stand for classes of numbers";
const MOVED: &str = "numbers are only moved here, and none is computed with (by reading)";
const EACH: &str = "channels are treated one by one: what holds of up to two of a kind holds of more (not shown)";
const ALONE: &str =
    "the controller, the governor and the monitor do anything, and are asked through their public API only";
const RELATIVE: &str = "only differences of seqs and times decide, and counts decide nothing: for seqs link/relative \
    shows it within its bounds";

/// All of them.
pub const CLAIMS: &[Claim] = &[
    Claim {
        id: "estop/bytes",
        rules: &["NCP-RES-022"],
        sentence: "The scanner comes to an end on every short string of bytes and finds no ESTOP in it.",
        statement: "∀ b ∈ Byte*, |b| ≤ 3: is_estop(b) = false",
        bounds: "every string of up to 3 bytes",
        assumptions: &[],
    },
    Claim {
        id: "estop/edits",
        rules: &["NCP-RES-022", "NCP-STRICT-010"],
        sentence: "On every JSON object that is near one of seven frames, the scanner and the buffer behind it, strict \
            or not, latch exactly when the object is of kind command_frame and has a mode estop; on no bytes near them \
            do they panic.",
        statement: "∀ f near a frame: object(f) ⇒ (is_estop(f) ⇔ kind = {command_frame} ∧ estop ∈ mode) ∧ \
            (is_stopped(buffer(f)) ⇔ is_estop(f))",
        bounds: "7 frames; each byte replaced by any byte, any byte put in at each place, each byte taken out, each \
            prefix, and each two bytes replaced by any two of 24 bytes",
        assumptions: &[],
    },
    Claim {
        id: "estop/tokens",
        rules: &["NCP-RES-022"],
        sentence: "On every JSON object of up to 13 tokens the scanner finds an ESTOP exactly when the object is of \
            kind command_frame and has a mode estop, escaped or not, repeated or not, at the outermost level alone.",
        statement: "∀ f ∈ Tokens^≤13: object(f) ⇒ (is_estop(f) ⇔ kind = {command_frame} ∧ estop ∈ mode)",
        bounds: "objects of up to 13 of 17 tokens, of which 9 are strings",
        assumptions: &[],
    },
    Claim {
        id: "estop/transitions",
        rules: &["NCP-RES-022"],
        sentence: "After each transition of the automaton of the text, from each of its places, by any character and \
            by any two of a class, the scanner answers each of the completions that bring to light what was read as \
            the automaton does. For objects of any length that is enough under the assumptions below, and under no \
            fewer.",
        statement: "∀ places q reached, characters a, classes b, completions w of δ(q, a) and δ(q, ab): \
            is_estop(p(q) a w), is_estop(p(q) a b w) as the automaton says",
        bounds: "brackets open up to 3 deep; characters: all of ASCII and one beyond",
        assumptions: &[
            "the memory of the scanner: what it answers to a continuation is decided by the place of the automaton, \
             and the byte before; by reading: it keeps a place, a count of brackets, two flags, and the string at \
             hand",
            "depth: what is open more than 3 deep is treated as what is open 3 deep; by reading: the count of brackets \
             is compared with 0 only",
            "characters beyond ASCII are treated alike; by reading: the scanner compares with ASCII only",
        ],
    },
    Claim {
        id: "governor/quiet",
        rules: &["NCP-SAFE-070", "NCP-SAFE-071", "NCP-SAFE-072", "NCP-SAFE-073", "NCP-SAFE-074"],
        sentence: "A HOLD or ESTOP frame keeps t, seq, frame_id and ttl_ms bit for bit, has no horizon, and zeroes \
            exactly the union of its channels and the negotiated ones, with their widths and units; a channel that it \
            lacked is three zeros in m/s or one zero.",
        statement: "∀ commands, negotiations: frame′ = quiet(frame) of 7.7",
        bounds: "up to 2 negotiated channels of 3 names and 3 units, repeated or not; a velocity and another channel, \
            each absent or of 0, 1, 3 or 4 components, in 3 units; with and without a horizon; 3 sets of stamps; HOLD \
            of init, hold or active, and ESTOP",
        assumptions: &[EACH, MOVED],
    },
    Claim {
        id: "governor/closed-gates",
        rules: &[
            "NCP-SAFE-020",
            "NCP-SAFE-021",
            "NCP-SAFE-070",
            "NCP-SAFE-071",
            "NCP-SAFE-072",
            "NCP-SAFE-073",
            "NCP-SAFE-074",
        ],
        sentence: "Whichever of the ten reasons closes a gate, the frame that leaves is the HOLD or ESTOP frame of \
            7.7; what no gate closes on stays active.",
        statement: "∀ reasons r: decision = r ∧ frame′ = quiet(frame); no reason: mode′ = active",
        bounds: "10 reasons and none; commands too fast or not, with another channel or not, with a horizon or not",
        assumptions: &[KERNEL],
    },
    Claim {
        id: "governor/binding",
        rules: &[
            "NCP-SAFE-010",
            "NCP-SAFE-011",
            "NCP-SAFE-012",
            "NCP-SAFE-013",
            "NCP-SAFE-014",
            "NCP-SAFE-015",
            "NCP-SAFE-016",
        ],
        sentence: "A governor is in config fail-closed exactly when a limit is faulty, or enabled and its channel is \
            not declared, or declared anywhere in another unit or width.",
        statement: "∀ limits, declarations: fault ⇔ ∃ limit: faulty ∨ (enabled ∧ ¬(∃ d: name ∧ ∀ d of the name: unit ∧ \
            3 wide))",
        bounds: "each limit with 8 values; up to 2 declarations, each of 2 names, 5 kinds, 6 sizes and 4 units; the \
            other limit bound or not",
        assumptions: &["declarations are looked at one by one: what holds of two holds of more (not shown)", KERNEL],
    },
    Claim {
        id: "governor/order",
        rules: &["NCP-SAFE-010", "NCP-SAFE-011", "NCP-SAFE-042"],
        sentence: "The fence acts on pose_position and the speed limit on velocity_setpoint alone, wherever they stand \
            among other channels.",
        statement: "∀ lists of channels: acts(fence) = {pose_position} ∧ acts(limit) = {velocity_setpoint}",
        bounds: "up to 3 other channels on each side, in every place",
        assumptions: &[KERNEL],
    },
    Claim {
        id: "governor/position",
        rules: &["NCP-SAFE-040", "NCP-SAFE-041", "NCP-SAFE-042", "NCP-SAFE-043", "NCP-SAFE-044", "NCP-SAFE-045"],
        sentence: "With the fence enabled, a command holds exactly when there is no pose_position that is 3 wide and \
            in m or without a unit; else it stops exactly when that is outside or not finite.",
        statement: "¬usable(position) ⇒ HOLD; usable ∧ ¬(‖position‖ ≤ R) ⇒ ESTOP, latched; else passed",
        bounds: "0 to 5 components of 8 values each, whose squares add up exactly; 4 units; negotiated or canonical",
        assumptions: &[KERNEL],
    },
    Claim {
        id: "governor/units",
        rules: &["NCP-SAFE-042", "NCP-SAFE-063", "NCP-SAFE-065", "NCP-SAFE-066", "NCP-SAFE-067"],
        sentence: "The unit of a channel is its own, or the negotiated one where it has none; the speed limit acts on \
            every channel in m/s and on no other, in tick 0 and in a step.",
        statement: "unit(c) = own(c) or negotiated(c); limited(c) ⇔ unit(c) = m/s",
        bounds: "a velocity of 0 to 4 components and another channel, each in 4 units, the other negotiated in 3 or \
            not at all; tick 0 and one step",
        assumptions: &[KERNEL],
    },
    Claim {
        id: "governor/index",
        rules: &["NCP-SAFE-050", "NCP-SAFE-055", "NCP-SAFE-066", "NCP-SAFE-067"],
        sentence: "Of every horizon that a frame may have, the kernel sees at tick k exactly horizon[k − 1], limits \
            that and no other, and sees nothing beyond its end.",
        statement: "∀ n ≤ 4097, k ≤ n: velocity(k), limit(k) are those of horizon[k − 1]; ∀ k > n tried: none",
        bounds: "every length from 0 to 4,097 and every tick of it; beyond it the next two, twice as many, and the two \
            largest",
        assumptions: &[],
    },
    Claim {
        id: "governor/cut",
        rules: &["NCP-SAFE-050", "NCP-SAFE-067"],
        sentence: "A truncation to n steps keeps the first n steps, in their order, and tick 0.",
        statement: "truncate(n): horizon′ = horizon[..min(n, |horizon|)]",
        bounds: "horizons of 0 to 64 and of 4,095 to 4,097 steps, cut to every length near both ends",
        assumptions: &[],
    },
    Claim {
        id: "link/traces",
        rules: &[
            "NCP-RES-040",
            "NCP-RES-041",
            "NCP-RES-042",
            "NCP-RES-043",
            "NCP-RES-044",
            "NCP-RES-046",
            "NCP-RES-049",
            "NCP-RES-054",
            "NCP-RES-055",
        ],
        sentence: "After every short trace the whole state of the monitor, and all that it reports, is what section \
            8.3 says in integers.",
        statement: "∀ traces: state = text(trace)",
        bounds: "6 frames of 8 seqs each, in every order; 4 configurations whose sums are exact",
        assumptions: &[],
    },
    Claim {
        id: "link/gaps",
        rules: &["NCP-RES-040", "NCP-RES-045", "NCP-RES-047", "NCP-RES-048", "NCP-RES-049", "NCP-RES-050"],
        sentence: "Over every gap between edges of 64 bits nothing overflows, at most 256 updates are made, at most \
            4,096 seqs are remembered, and the loss rate is lost over expected.",
        statement: "∀ traces: lost, expected as in integers of 128 bits; S by min(gap, 256) updates; |missing| ≤ 4096",
        bounds: "3 frames of 17 seqs each, around 0, 256, 4,096 and both ends of 64 bits; 5 configurations",
        assumptions: &[],
    },
    Claim {
        id: "link/detector",
        rules: &["NCP-RES-046", "NCP-RES-049", "NCP-RES-051", "NCP-RES-052"],
        sentence: "Whatever the doubles of a configuration are, ref_loss and threshold become those of the text; from \
            every S between 0 and twice the threshold, a missing seq and a delivery lead to such an S again, a \
            delivery never up and a missing seq never down; a burst is S above the threshold. As each slot keeps the \
            invariant, so does every stream of any length.",
        statement: "∀ r ∈ [0, 0.99], T > 0 finite, 0 ≤ S ≤ 2T: 0 ≤ S′ ≤ 2T; S − r ⇒ S′ ≤ S; S + (1 − r) ⇒ S ≤ S′; \
            burst ⇔ S > T",
        bounds: "none: all doubles, by symbolic execution of the source and bitwuzla",
        assumptions: &[
            "the source with terms in the place of doubles is the source (build.rs: three replacements)",
            "clamp of doubles is two comparisons, as std documents it",
            "a frame changes S by such slots only: link/traces and link/gaps show it within their bounds",
        ],
    },
    Claim {
        id: "link/step",
        rules: &[
            "NCP-RES-040",
            "NCP-RES-041",
            "NCP-RES-042",
            "NCP-RES-043",
            "NCP-RES-045",
            "NCP-RES-046",
            "NCP-RES-048",
            "NCP-RES-049",
            "NCP-RES-050",
        ],
        sentence: "Each frame takes each state on the grid that keeps the invariant - 0 ≤ S ≤ 2·threshold, what is \
            missing lies between first and last - to one that keeps it; counts saturate; the loss rate is within 0 and \
            1; first and the configuration stay; a duplicate changes nothing.",
        statement: "I(s) ⇒ I(step(s)) ∧ frame(s, step(s))",
        bounds: "the whole state, field by field: 5 ref_losses, 5 thresholds, 7 places of S between 0 and twice the \
            threshold, 5 spans, 4 counts each, two missing or none; 8 seqs",
        assumptions: &[LISTED],
    },
    Claim {
        id: "link/relative",
        rules: &["NCP-RES-040", "NCP-RES-046"],
        sentence: "A stream whose seqs are shifted, on a monitor that has counted more, goes the same way.",
        statement: "step(shift(s), seq + d) = shift(step(s, seq))",
        bounds: "4 frames of 6 seqs, 4 shifts, 4 configurations, counts higher by 1,000",
        assumptions: &[],
    },
    Claim {
        id: "link/configuration",
        rules: &["NCP-RES-051", "NCP-RES-052"],
        sentence: "A ref_loss is clamped to 0 … 0.99 or is 0.05, a threshold that is no positive number is 5, and a \
            new monitor has seen nothing.",
        statement: "state(new(r, t)) as in NCP-RES-051 and 052",
        bounds: "16 doubles for each",
        assumptions: &[LISTED],
    },
    Claim {
        id: "loop/start",
        rules: &["NCP-CTRL-010"],
        sentence: "A loop starts exactly with a finite, positive period, and knows no sensor frame then.",
        statement: "starts ⇔ finite(period) ∧ period > 0",
        bounds: "9 doubles",
        assumptions: &[KERNEL],
    },
    Claim {
        id: "loop/sensor",
        rules: &["NCP-CTRL-011", "NCP-CTRL-012"],
        sentence: "From every state a frame that arrives is kept exactly when it is newer by seq, or by t while both \
            are unstamped; the frame that is kept and its time are always of one arrival; each stamped frame is told \
            to the monitor once.",
        statement: "newest′ = newer(frame, newest) ? (frame, now) : newest",
        bounds: "a kept frame or none, and one that arrives, each of 8 seqs and 5 times; 4 readings of the clock",
        assumptions: &[ALONE, LISTED],
    },
    Claim {
        id: "loop/tick",
        rules: &[
            "NCP-CTRL-012",
            "NCP-CTRL-013",
            "NCP-CTRL-014",
            "NCP-CTRL-015",
            "NCP-CTRL-016",
            "NCP-CTRL-017",
            "NCP-CTRL-018",
            "NCP-CTRL-019",
            "NCP-CTRL-021",
        ],
        sentence: "In every state a tick asks the controller once, tells the governor of the link and then has it \
            govern once: at the tick's time, by the frame that is kept and the time at which that was received, a \
            command with that frame's seq and a ttl of two periods at least; what the governor leaves is what is sent, \
            and the status says so.",
        statement: "asked = step; note_link(burst); govern(command, now, newest) ∧ sent = left",
        bounds: "4 modes, 9 ttls around two periods, 3 periods, 3 readings of the clock, 4 durations, 5 kept frames, \
            bursts, 3 counters, 4 answers of the governor: all combined",
        assumptions: &[ALONE, LISTED],
    },
    Claim {
        id: "loop/frame",
        rules: &["NCP-CTRL-015"],
        sentence: "All that the controller commands reaches the governor as it is, but a dt that is no number, and \
            steps beyond the 4,096 that a frame has.",
        statement: "governed.channels = wished.channels; governed.horizon = wished.horizon[..4096]",
        bounds: "horizons of 0, 1, 3, 4,096 and 4,097 steps, 5 dts",
        assumptions: &[ALONE, MOVED],
    },
    Claim {
        id: "liveness/hold",
        rules: &["NCP-SAFE-008", "NCP-SAFE-018", "NCP-SAFE-022", "NCP-RES-049"],
        sentence: "From every reachable state of a loop, a HOLD that is no config fault ends with the next good sensor \
            frame and command; a burst, a latched ESTOP and whatever came before end with five deliveries, a reset and \
            a good command.",
        statement: "AG (held(r ≠ config) → after(good): passed) ∧ \
            AG (¬config → after(5 deliveries; reset; good): passed)",
        bounds: "all reachable states under 17 events at any time; ref_loss 1/4, threshold 1, a timeout of two \
            quarters of a second; times and ages in quarters",
        assumptions: &[RELATIVE],
    },
    Claim {
        id: "liveness/fair",
        rules: &["NCP-SAFE-008", "NCP-SAFE-022", "NCP-RES-049"],
        sentence: "Once what latches ESTOP stays away, a loop to which good frames come with good commands again and \
            again, and which is reset again and again, passes a command again and again, whatever else happens.",
        statement: "FG ¬cause ∧ GF good ∧ GF reset → GF passed",
        bounds: "all cycles of the same graph of states",
        assumptions: &[RELATIVE],
    },
    Claim {
        id: "liveness/burst",
        rules: &["NCP-RES-049"],
        sentence: "From the largest S on, ⌈threshold / ref_loss⌉ + 1 deliveries end a burst.",
        statement: "S ≤ 2·threshold ⇒ after ⌈threshold / ref_loss⌉ + 1 deliveries S ≤ threshold",
        bounds: "5 configurations, of which two from every S in sixteenths",
        assumptions: &[
            "from a smaller S it takes no longer: subtraction and clamping of doubles are monotone (IEEE 754)",
        ],
    },
];
