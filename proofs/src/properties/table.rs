//! What is claimed of the kernel, in words and in symbols.

use super::{Family, Property};

const NONE: &[&str] = &[];

/// The properties of the kernel.
pub const PROPERTIES: &[Property] = &[
    Property {
        id: "watchdog/deadline",
        family: Family::Watchdog,
        rules: &[
            "NCP-RES-002",
            "NCP-RES-003",
            "NCP-RES-004",
            "NCP-RES-005",
            "NCP-RES-007",
            "NCP-RES-008",
            "NCP-SAFE-031",
            "NCP-SAFE-032",
            "NCP-SAFE-033",
            "NCP-SAFE-034",
            "NCP-SAFE-035",
        ],
        sentence: "A command is alive exactly while clock and receipt are finite, the clock has not gone back, the \
            ttl is finite and positive, and the age is above neither the ttl nor 60 s; a sensor frame is fresh \
            exactly while the same holds of its timeout.",
        statement: "∀ now, r, ttl ∈ F64: within_deadline(now, r, ttl) ⇔ fin(now) ∧ fin(r) ∧ r ≤ now ∧ fin(ttl) ∧ 0 < \
            ttl ∧ (now ⊖ r) ⊗ 1000 ≤ ttl ∧ (now ⊖ r) ⊗ 1000 ≤ 60000; and is_fresh likewise without 60000",
        bounds: "none",
        assumptions: NONE,
    },
    Property {
        id: "watchdog/ttl",
        family: Family::Watchdog,
        rules: &["NCP-RES-004", "NCP-RES-005"],
        sentence: "The enforced ttl is min(ttl, 60 s), and none for a ttl that is not finite or not positive.",
        statement: "∀ ttl ∈ F64: enforced(ttl) is some t ⇔ fin(ttl) ∧ 0 < ttl; and t = min(ttl, 60000)",
        bounds: "none",
        assumptions: NONE,
    },
    Property {
        id: "watchdog/order",
        family: Family::Watchdog,
        rules: &["NCP-RES-009", "NCP-RES-012", "NCP-RES-023"],
        sentence: "A command advances exactly when its seq is above the last one's or there is none; a HOLD takes \
            effect exactly when its seq is not below the last one's, or is 0.",
        statement: "∀ last ∈ I64 ∪ {none}, s ∈ I64: advances ⇔ last = none ∨ last < s; hold_takes_effect ⇔ last = \
            none ∨ s = 0 ∨ last ≤ s",
        bounds: "none: all 64-bit seqs, the edges included",
        assumptions: NONE,
    },
    Property {
        id: "watchdog/step",
        family: Family::Watchdog,
        rules: &[
            "NCP-RES-001",
            "NCP-RES-002",
            "NCP-RES-006",
            "NCP-RES-009",
            "NCP-RES-010",
            "NCP-RES-011",
            "NCP-RES-012",
            "NCP-RES-024",
        ],
        sentence: "In every state of a watchdog, every event gives the answer and the whole next state of the model: \
            only an advancing command sets the deadline, a HOLD is never ignored, a hold persists, and a reset \
            revives nothing. With the first state this holds for sequences of any length, by induction.",
        statement: "init = model.init; ∀ σ ∈ (I64 ∪ {none}) × (F64² ∪ {none}), events e: step(σ, e) = model.step(σ, \
            e), answer and every member of the state, bit by bit",
        bounds: "none; also states that are never reached",
        assumptions: NONE,
    },
    Property {
        id: "watchdog/sequence",
        family: Family::Watchdog,
        rules: &["NCP-RES-002", "NCP-RES-006", "NCP-RES-009", "NCP-RES-010", "NCP-RES-011", "NCP-RES-012"],
        sentence: "The liveness rule over sequences: whenever the plant may move, an advancing command of the \
            sequence is alive, no later command took its place, nothing has held the plant since, and no reset came \
            after it. A stale, duplicate or reordered command so never extends a deadline.",
        statement: "∀ sequences of command, hold, reading and reset: ¬should_hold(now) ⇒ ∃ i: alive(now, rᵢ, ttlᵢ) ∧ \
            (∀ j < i: sⱼ < sᵢ) ∧ (∀ j > i: sⱼ ≤ sᵢ) ∧ nothing held since i, all after the last reset",
        bounds: "sequences of 4 events; of 6 for a few times and seqs",
        assumptions: &["Sequences of other lengths: by watchdog/step."],
    },
    Property {
        id: "geofence/inside",
        family: Family::Geofence,
        rules: &["NCP-SAFE-040", "NCP-SAFE-043", "NCP-SAFE-044", "NCP-SAFE-045"],
        sentence: "A position is inside exactly when its three components are finite, the radius is finite and \
            positive, and the norm is not above the radius.",
        statement: "∀ x, y, z, r ∈ F64: inside ⇔ fin(x) ∧ fin(y) ∧ fin(z) ∧ fin(r) ∧ 0 < r ∧ √(x′⊗x′ ⊕ y′⊗y′ \
            ⊕ z′⊗z′) ≤ r ⊗ c, where x′ = x ⊗ c, and the scale c is 2⁶⁰⁰ where x⊗x ⊕ y⊗y ⊕ z⊗z < 2⁻⁹⁰⁰, 1 where it is \
            < 2¹⁰⁰⁰, else 2⁻⁶⁰⁰",
        bounds: "none",
        assumptions: NONE,
    },
    Property {
        id: "geofence/range",
        family: Family::Geofence,
        rules: &["NCP-SAFE-043", "NCP-SAFE-045"],
        sentence: "Positions and radii of every size: also where squares vanish or overflow, a position is inside \
            exactly when its exact norm is not above the radius.",
        statement: "∀ d ∈ D, s, t ∈ E, r ∈ {|d|·2ᵗ, the double before}: inside(d·2ˢ, r) ⇔ |d|·2ˢ ≤ r",
        bounds: "D: (3, −4, 0), (−2, 3, 6), (1, −4, 8), (0, 0, −1); E: 14 powers from −1074 to 1020",
        assumptions: &[
            "Other positions: by geofence/inside, whose formula is at the same scale; how far that is from \
            exact norms is theorem/governed-plant-stays-within.",
        ],
    },
    Property {
        id: "geofence/limit",
        family: Family::Geofence,
        rules: &["NCP-SAFE-012", "NCP-SAFE-013"],
        sentence: "A limit is enabled exactly when finite and positive, faulty exactly when negative or not finite, \
            and else disabled.",
        statement: "∀ v ∈ F64 ∪ {none}: limit(v) = Enabled(v) ⇔ fin(v) ∧ 0 < v; Faulty ⇔ ¬fin(v) ∨ v < 0",
        bounds: "none",
        assumptions: NONE,
    },
    Property {
        id: "geofence/projection",
        family: Family::Geofence,
        rules: &["NCP-SAFE-050", "NCP-SAFE-051", "NCP-SAFE-052", "NCP-SAFE-053", "NCP-SAFE-067", "NCP-SAFE-068"],
        sentence: "No tick and no step that passes ends outside the fence, tick 0 alone not after the whole ttl; and \
            no step is cut off but one that leads out or cannot be used, and what follows it.",
        statement: "∀ p, r, ttl, dt, v₀ … vₙ: govern passes with k steps ⇒ inside(p) ∧ (k = 0 ⇒ inside(p ⊕ v₀⊗T)) ∧ \
            (k > 0 ⇒ ∀ i ≤ k: inside(pᵢ₊₁)) ∧ (k < n ⇒ ¬(inside(pₖ₊₂) ∧ fin(vₖ₊₁))), where pᵢ₊₁ = pᵢ ⊕ vᵢ ⊗ (shareᵢ \
            ⊘ 1000), computed in doubles",
        bounds: "horizons of up to 3 steps",
        assumptions: &["Positions are those computed in doubles, step by step; the rounding against real arithmetic \
            is not part of it."],
    },
    Property {
        id: "geofence/projection-and-clamp",
        family: Family::Geofence,
        rules: &["NCP-SAFE-050", "NCP-SAFE-051", "NCP-SAFE-053", "NCP-SAFE-060", "NCP-SAFE-066"],
        sentence: "With fence and speed limit at once, the projection follows the clamped velocities, and each that \
            passes is within the limit.",
        statement: "as geofence/projection with vᵢ the clamped velocities; and ∀ i ≤ k: ‖vᵢ‖ ≤ max",
        bounds: "commands without a horizon; geofence/projection covers horizons for all velocities, so for clamped \
            ones too",
        assumptions: &["As geofence/projection."],
    },
    Property {
        id: "geofence/step",
        family: Family::Geofence,
        rules: &["NCP-SAFE-050", "NCP-SAFE-055"],
        sentence: "One turn of the projection, whichever: any step of a horizon, from any place, ends where its \
            velocity leads in its share of the time, and is taken exactly when that is inside and it has a velocity.",
        statement: "∀ k, from, v ∈ F64³ ∪ {none}, dt, T, r: step_end = some e ⇔ v ≠ none ∧ inside(e, r), where e = \
            from ⊕ v ⊗ (share(k) ⊘ 1000), share(k) = min(dt, T ⊖ k⊗dt) where k⊗dt < T, and else 0. So inside(place) is \
            kept by every turn",
        bounds: "none: the number of the step is any double at all",
        assumptions: &["That a step is projected from where the one before has ended: by geofence/follow, and \
            latch/govern."],
    },
    Property {
        id: "geofence/follow",
        family: Family::Geofence,
        rules: &["NCP-SAFE-050", "NCP-SAFE-066", "NCP-SAFE-067"],
        sentence: "What turns the loops over a horizon, that of the speed limit and that of the projection: the steps \
            are taken one after the other, each once and from what the one before has left, up to the last or the \
            first that cannot be taken, and no more.",
        statement: "∀ n, f: follow(n, s₀, step) = (k, sₖ) with sᵢ = step(i, sᵢ₋₁), k = min(n, f − 1), f the first i \
            with step(i, sᵢ₋₁) = none; step is asked min(n, f) times",
        bounds: "n up to 4,096, the longest horizon of a frame: every f for n up to 64, and above f = none, 1, 2, n/2, \
            n − 1, n",
        assumptions: &[
            "It is generic over the state and the step, and so cannot look at them: that Rust's types hold.",
        ],
    },
    Property {
        id: "geofence/long",
        family: Family::Geofence,
        rules: &["NCP-SAFE-050", "NCP-SAFE-055", "NCP-SAFE-066", "NCP-SAFE-067"],
        sentence: "In a long horizon one step that leads out, is not finite, is too fast, has no velocity, or comes \
            after the ttl is noticed or left alone as it has to be, wherever it stands, with each of the limits, \
            both and none.",
        statement: "∀ n ∈ N, i ∈ {1, 2, n/2, n − 1, n}, kinds of step i, limits: govern keeps i − 1 steps or all, and \
            says so; the gates stay as they were",
        bounds: "N = {1, 2, 3, 4, 7, 8, 9, 16, 31, 64, 65, 129, 257, 1025, 4096}; one position, one velocity of each \
            kind",
        assumptions: &["Other places, velocities and times: by geofence/step and latch/govern."],
    },
    Property {
        id: "clamp/bound",
        family: Family::Clamp,
        rules: &["NCP-SAFE-060", "NCP-SAFE-064"],
        sentence: "A velocity that the limit has passed is not above it, for every double; what is not finite, and a \
            limit that is none, give no velocity.",
        statement: "∀ v ∈ F64ⁿ, max ∈ F64: clamp(v, max) is some w ⇔ fin(v) ∧ fin(max) ∧ 0 < max; and then ‖w‖ ≤ max, \
            both at the scale of geofence/inside",
        bounds: "1 to 3 components",
        assumptions: NONE,
    },
    Property {
        id: "clamp/unchanged",
        family: Family::Clamp,
        rules: &["NCP-SAFE-062"],
        sentence: "A velocity is left alone, to the bit, exactly when it is not above the limit.",
        statement: "clamp(v, max) is some w ⇒ (w is v unchanged ⇔ ‖v‖ ≤ max), both at the scale of \
            geofence/inside",
        bounds: "1 to 3 components",
        assumptions: NONE,
    },
    Property {
        id: "clamp/direction",
        family: Family::Clamp,
        rules: &["NCP-SAFE-061"],
        sentence: "Every component is multiplied by one factor common to all; so the direction is kept but for one \
            rounding of each product, at most 2⁻⁵³ of it (three roundings where the factor is below 2⁻⁹⁰⁰), \
            and at most 2⁻¹⁰⁷⁵ below the normal range.",
        statement: "clamp(v, max) = w ≠ v ⇒ w = u, or w = 0 where ‖u‖ > max; uᵢ = vᵢ ⊗ f where f = aim ⊗ c ⊘ ‖v‖ ≥ \
            2⁻⁹⁰⁰, else vᵢ ⊗ c ⊘ ‖v‖ ⊗ aim; aim = max ⊗ (1 − (n + 8)·2⁻⁵³), ‖v‖ at the scale c of geofence/inside",
        bounds: "1 to 3 components",
        assumptions: &["IEEE 754: a product or quotient is the exact one rounded to nearest; that gives the bound in \
            the sentence."],
    },
    Property {
        id: "clamp/range",
        family: Family::Clamp,
        rules: &["NCP-SAFE-060", "NCP-SAFE-061", "NCP-SAFE-062"],
        sentence: "Velocities and limits of every size: also where squares, or the quotient of limit and norm, vanish \
            or overflow, a velocity is left alone exactly when its exact norm is not above the limit, and else scaled \
            to the limit in the same direction, but for one part in 10¹².",
        statement: "∀ d ∈ D, s, t ∈ E, m ∈ {|d|·2ᵗ, the double before}: clamp(d·2ˢ, m) is unchanged ⇔ |d|·2ˢ ≤ m; \
            else, for m ≥ 2⁻¹⁰⁰⁰, wᵢ = m·dᵢ/|d| but for 2⁻⁴⁰ of it",
        bounds: "D: (3, −4, 0), (−2, 3, 6), (1, −4, 8), (0, 0, −1); E: 14 powers from −1074 to 1020",
        assumptions: &["Other velocities: by clamp/bound, clamp/unchanged and clamp/direction, whose formulas are at \
            the same scale."],
    },
    Property {
        id: "clamp/tick",
        family: Family::Clamp,
        rules: &["NCP-SAFE-011", "NCP-SAFE-063", "NCP-SAFE-064", "NCP-SAFE-065"],
        sentence: "A tick passes exactly when every component of every channel is finite and, with the limit \
            enabled, its velocity is 3 wide and in m/s; never with a faulty limit; then every channel in m/s is \
            within the limit, and every other one as it was. What is not finite is said to be so.",
        statement: "limit_tick(channels, limit) is ok ⇔ ¬faulty ∧ fin(channels) ∧ (enabled ⇒ velocity is named, 3 \
            wide, in m/s); and then ∀ c in m/s: ‖c‖ ≤ max",
        bounds: "two channels in either order, of 2 to 4 and of 1 component",
        assumptions: NONE,
    },
    Property {
        id: "clamp/channel",
        family: Family::Clamp,
        rules: &["NCP-SAFE-011", "NCP-SAFE-060", "NCP-SAFE-062", "NCP-SAFE-064", "NCP-SAFE-065"],
        sentence: "One turn of the loop over the channels of a tick, whichever: any channel, after any others, is \
            usable exactly when it is finite and the limit, where it acts, is a bound; in m/s it is then within the \
            limit, and left alone, to the bit, unless it was above; what is known of the channels before is kept.",
        statement: "∀ (changed, has), limit, c: ok ⇔ fin(c) ∧ (enabled ∧ in m/s ⇒ pos(max)); then has′ = has ∨ \
            (enabled ∧ c is the velocity, 3 wide, in m/s), changed′ = changed ∨ (enabled ∧ in m/s ∧ ‖c‖ > max), ‖c′‖ ≤ \
            max there, and c′ = c unless ‖c‖ > max",
        bounds: "channels of up to 4 components",
        assumptions: NONE,
    },
    Property {
        id: "clamp/channels",
        family: Family::Clamp,
        rules: &["NCP-SAFE-063", "NCP-SAFE-064", "NCP-SAFE-065"],
        sentence: "In a tick of many channels the one that is too fast is limited, the one that is not finite is \
            noticed, and the velocity is found, wherever it stands, however wide it is, and whichever of its \
            components is to blame.",
        statement: "∀ n ∈ N, w ∈ W, places of the velocity, of one odd channel and of its odd component in {first, \
            middle, last}: limit_tick(c₁ … cₙ) = err not finite where one is not, err no velocity where the limit is \
            enabled and the velocity is not 3 wide, else ok(whether one was above); and then ‖c‖ ≤ max",
        bounds: "N = {1, 2, 3, 9, 65, 257} channels, W = {1, 3, 4, 9, 65, 257, 259} components; one value of each kind",
        assumptions: &["Other values: by clamp/channel."],
    },
    Property {
        id: "latch/new",
        family: Family::Latch,
        rules: &["NCP-SAFE-012", "NCP-SAFE-013"],
        sentence: "New gates have the limits and the timeout that they are given, a config fault exactly when a limit \
            is faulty, and no latch.",
        statement: "∀ speed, radius ∈ F64 ∪ {none}, timeout ∈ F64: new(speed, radius, timeout) = (limit(speed), \
            limit(radius), timeout, faulty(speed) ∨ faulty(radius), false), the whole state",
        bounds: "none",
        assumptions: NONE,
    },
    Property {
        id: "latch/event",
        family: Family::Latch,
        rules: &[
            "NCP-SAFE-006",
            "NCP-SAFE-007",
            "NCP-SAFE-008",
            "NCP-SAFE-009",
            "NCP-SAFE-014",
            "NCP-SAFE-017",
            "NCP-SAFE-018",
        ],
        sentence: "In every state of the gates: a binding sets the config fault exactly when an enabled limit has \
            nothing to act on; a burst sets the latch, and no burst changes nothing; a reset clears the latch. \
            Nothing else changes: limits and timeout stay, to the bit, as they are. With latch/new and latch/govern \
            this holds for traces of any length, by induction.",
        statement: "∀ σ = (speed, fence, timeout, fault, estop): bind(v, p): fault′ = fault ∨ (speed ≠ disabled ∧ ¬v) \
            ∨ (fence ≠ disabled ∧ ¬p); note_link(b): estop′ = estop ∨ b; reset: estop′ = false; all other members \
            of σ′ are those of σ, bit by bit",
        bounds: "none: all limits, all doubles, also states that are never reached",
        assumptions: NONE,
    },
    Property {
        id: "latch/govern",
        family: Family::Latch,
        rules: &[
            "NCP-SAFE-001",
            "NCP-SAFE-002",
            "NCP-SAFE-003",
            "NCP-SAFE-004",
            "NCP-SAFE-005",
            "NCP-SAFE-017",
            "NCP-SAFE-020",
            "NCP-SAFE-030",
            "NCP-SAFE-043",
            "NCP-SAFE-050",
            "NCP-SAFE-051",
            "NCP-SAFE-052",
            "NCP-SAFE-053",
            "NCP-SAFE-055",
            "NCP-SAFE-066",
            "NCP-SAFE-067",
            "NCP-SAFE-068",
        ],
        sentence: "A command with limits, fence and horizon at once, at gates in every state: the first gate of 7.3 \
            that closes decides, with its reason; every tick that passes was limited once, by the limit as \
            configured, and then projected, and ends inside; only what is not to be used or leads out is cut off, \
            and the decision says whether something was; ESTOP latches exactly by gates 1 and 4, and nothing else \
            of the state changes.",
        statement: "∀ σ with faulty ⇒ fault, mode, now, last, position, ttl, dt, n, answers aᵢ and velocities vᵢ of \
            the ticks: decision and kept steps k are those of 7.3, with k = min(first i: aᵢ₊₁ is err, first i: \
            ¬inside(pᵢ₊₂)); estop′ ⇔ estop ∨ mode = estop ∨ outside at gate 4; all other members of σ′ are those \
            of σ, bit by bit",
        bounds: "horizons of up to 2 steps",
        assumptions: &[
            "What a tick answers to the limit, and that its velocity is then within it: by clamp/tick. The \
            harness takes any answer and any velocity.",
        ],
    },
    Property {
        id: "latch/gates",
        family: Family::Latch,
        rules: &[
            "NCP-SAFE-001",
            "NCP-SAFE-002",
            "NCP-SAFE-003",
            "NCP-SAFE-004",
            "NCP-SAFE-005",
            "NCP-SAFE-006",
            "NCP-SAFE-007",
            "NCP-SAFE-008",
            "NCP-SAFE-009",
            "NCP-SAFE-014",
            "NCP-SAFE-017",
            "NCP-SAFE-018",
            "NCP-SAFE-020",
            "NCP-SAFE-030",
            "NCP-SAFE-043",
        ],
        sentence: "In every state of the gates, the first gate of 7.3 that closes decides the command; ESTOP latches \
            exactly by an ESTOP, a position outside, and a burst, and only a reset clears it; a config fault is \
            never cleared; nothing but active passes. As each event gives the next state of the model in every \
            state, ESTOP latches through sequences of any length.",
        statement: "∀ limits, states, commands: decision = first closed gate of 7.3; estop′ ⇔ estop ∨ mode = estop ∨ \
            outside; note_link, reset as in 7.1",
        bounds: "commands without a horizon whose velocity is zero; gates 6 to 8 are clamp/tick and \
            geofence/projection",
        assumptions: NONE,
    },
    Property {
        id: "latch/plant",
        family: Family::Latch,
        rules: &[
            "NCP-SAFE-001",
            "NCP-RES-020",
            "NCP-RES-021",
            "NCP-RES-023",
            "NCP-RES-024",
            "NCP-RES-025",
            "NCP-RES-026",
            "NCP-RES-027",
            "NCP-RES-028",
            "NCP-RES-029",
            "NCP-RES-030",
            "NCP-RES-031",
            "NCP-RES-032",
        ],
        sentence: "In every state of a plant, every event gives the answer and the whole next state of the model: \
            ESTOP latches whatever its seq, only active is followed, a HOLD is never ignored, the tick is ⌊age / \
            dt⌋, none past the end, and nothing moves after a reset. With the first state this holds for sequences \
            of any length, by induction.",
        statement: "init = model.init; ∀ σ ∈ (I64 ∪ {none}) × (F64² ∪ {none}) × {0, 1}, events e: step(σ, e) = \
            model.step(σ, e), answer and every member of the state, bit by bit; active = k ⇒ k ≤ (age ⊘ dt) < k + 1 \
            ∧ k ≤ n",
        bounds: "horizons of n = 0, 1, 2, 3 and 8 steps",
        assumptions: NONE,
    },
    Property {
        id: "latch/sequence",
        family: Family::Latch,
        rules: &["NCP-SAFE-004", "NCP-SAFE-005", "NCP-SAFE-006", "NCP-SAFE-007", "NCP-SAFE-008", "NCP-SAFE-020"],
        sentence: "Through every sequence of six events ESTOP holds from the event that latches it to the reset, and \
            each command is answered by the first gate that closes.",
        statement: "∀ sequences of 6 over {active inside, outside, without position, stale; hold; estop; burst; no \
            burst; reset}: decision and latch are the model's after each event",
        bounds: "9 kinds of events, sequences of 6: 531,441",
        assumptions: &["Other values and lengths: by latch/gates."],
    },
    Property {
        id: "latch/plant-sequence",
        family: Family::Latch,
        rules: &["NCP-RES-021", "NCP-RES-025", "NCP-RES-030", "NCP-RES-031"],
        sentence: "Through every sequence of events at a plant nothing moves after an ESTOP until a reset, and after \
            that until a new command.",
        statement: "∀ sequences of active, hold, estop, reading and reset, all seqs: moves ⇔ commanded since the \
            last hold or reset ∧ no estop since the last reset",
        bounds: "sequences of 5 events; of 6 for a few seqs; one clock reading",
        assumptions: &["Other times and lengths: by latch/plant."],
    },
    Property {
        id: "latch/horizon",
        family: Family::Latch,
        rules: &["NCP-SAFE-063", "NCP-SAFE-064", "NCP-SAFE-066", "NCP-SAFE-067", "NCP-SAFE-068"],
        sentence: "A command with a horizon is held when its ticks have no length, or when tick 0 is not to be used, \
            for the reason that is said of it; the horizon ends before the first step that is not to be used; every \
            tick that is kept was limited as configured, and the decision says whether one changed or was cut off.",
        statement: "∀ limits, dt, answers a₀ … aₙ of the ticks: ¬faulty ⇒ (n > 0 ∧ ¬pos(dt) ⇔ held for it); else a₀ \
            = err r ⇒ held for r; else kept = min{i: aᵢ₊₁ is err} ∪ {n}, limited ⇔ kept < n ∨ ∃ i ≤ kept: aᵢ changed",
        bounds: "horizons of up to 3 steps; no fence",
        assumptions: &["What a tick answers: by clamp/tick."],
    },
    Property {
        id: "latch/closed",
        family: Family::Latch,
        rules: &[
            "NCP-SAFE-002",
            "NCP-SAFE-003",
            "NCP-SAFE-004",
            "NCP-SAFE-005",
            "NCP-SAFE-017",
            "NCP-SAFE-030",
            "NCP-SAFE-033",
            "NCP-SAFE-043",
            "NCP-SAFE-063",
            "NCP-SAFE-064",
            "NCP-SAFE-068",
        ],
        sentence: "A gate that is closed answers a command with a long horizon as it answers any other, and leaves the \
            gates as it then leaves them, with each of the limits, both and none.",
        statement: "∀ n ∈ N, closed gates g, limits: govern = the decision of g; σ′ = σ, but latched for ESTOP and \
            outside",
        bounds: "N = {1, 2, 3, 4, 7, 8, 9, 16, 31, 64, 65, 129, 257, 1025, 4096}; thirteen ways of closing, one value \
            of each kind",
        assumptions: &["Other values: by latch/govern."],
    },
    Property {
        id: "latch/replay",
        family: Family::Latch,
        rules: &["NCP-RES-028", "NCP-RES-029", "NCP-RES-010"],
        sentence: "Of a long horizon a plant follows the tick of the command's age, and none past the end, however \
            far beyond: then it holds for good.",
        statement: "∀ n ∈ N, k ∈ K, h ∈ {0, ½}: active at the age (k + h)·dt is k for k ≤ n, and none above; without a \
            horizon it is 0",
        bounds: "N = {0, 1, 2, 3, 4, 7, 8, 9, 16, 31, 64, 65, 129, 257, 1025, 4096}, K = {0, 1, n/2, n − 1, n, n + 1, \
            n + 256, 2¹⁶, 2¹⁶ + 1, 2³², 2³² + 1}; a tick of 2⁻³⁰ s",
        assumptions: &["Other times and ticks: by latch/plant."],
    },
    Property {
        id: "number/operations",
        family: Family::Number,
        rules: &[
            "NCP-RES-002",
            "NCP-RES-003",
            "NCP-RES-009",
            "NCP-RES-023",
            "NCP-RES-028",
            "NCP-SAFE-043",
            "NCP-SAFE-044",
            "NCP-SAFE-045",
            "NCP-SAFE-060",
        ],
        sentence: "The numbers on which production runs the kernel compute what their names say: sums, differences, \
            products, quotients, roots, comparisons and choices of doubles as IEEE 754 has them, the order of seqs, \
            and whole numbers as indices.",
        statement: "∀ a, b ∈ D: add(a, b) = a ⊕ b, sub = ⊖, mul = ⊗, div = ⊘, sqrt = √, abs = |a|, select_lt(a, \
            b, 1, 2) = 1 ⇔ a < b, lt ⇔ a < b, le ⇔ a ≤ b, is_finite ⇔ fin(a), floor_index(a, m) = |{k ∈ 1…m: k ≤ \
            a}|; ∀ s, t ∈ Q: lt ⇔ s < t, is_zero ⇔ s = 0",
        bounds: "all pairs of 24 doubles and of 7 seqs, of every kind and the edges",
        assumptions: &["What Rust's own operators do is what IEEE 754 says."],
    },
];
