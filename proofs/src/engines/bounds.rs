//! How far the engines go with each property of the kernel.

/// What the engines take on of a property.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// The longest sequence of events on terms.
    pub length: usize,
    /// Values to combine; none where the harness has too many inputs for that.
    pub values: Option<Values>,
    /// The bounds in words, engine by engine, where they are not those of the claim.
    pub words: Option<&'static str>,
}

/// The finite sets of an enumeration.
#[derive(Debug, Clone, Copy)]
pub struct Values {
    /// The doubles.
    pub scalars: &'static [f64],
    /// The seqs.
    pub seqs: &'static [i64],
    /// The longest sequence of events.
    pub length: usize,
}

/// The longest sequence of events in any harness.
const LONGEST: usize = 6;
const TIMES: &[f64] =
    &[0.0, 0.25, 1.0, -1.0, 250.0, 60_000.0, 60_000.5, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX];
const COMPONENTS: &[f64] = &[0.0, -3.0, 4.0, 5.0, 1e200, -1e-200, f64::MAX, 5e-324, f64::NAN, f64::INFINITY];

/// The bounds of a property, by its id.
#[must_use]
pub fn of(property: &str) -> Bounds {
    let values = |scalars, seqs, length| Some(Values { scalars, seqs, length });
    let values = match property {
        "watchdog/deadline" | "watchdog/ttl" | "geofence/limit" => values(TIMES, &[0], 0),
        "watchdog/order" => values(&[0.0], &[0, 1, 2, -1, i64::MAX, i64::MIN], 0),
        "watchdog/step" => values(&[0.0, 1.0, 2.0, f64::NAN, f64::INFINITY], &[0, 1, 2, i64::MIN], 0),
        "watchdog/sequence" => values(&[0.0, 1.0], &[1, 2], 6),
        "geofence/inside" => {
            values(&[0.0, -0.0, 3.0, -4.0, 5.0, 1e200, f64::MAX, 5e-324, f64::NAN, f64::INFINITY], &[0], 0)
        }
        "geofence/step" => values(&[1.0, 3.0], &[0], 0),
        "geofence/range" | "geofence/follow" | "geofence/long" | "clamp/range" | "clamp/channels" | "latch/closed"
        | "latch/replay" => values(&[0.0], &[0], 0),
        "clamp/channel" => values(&[0.0, -3.0, 4.0, 5.0, f64::MAX, f64::NAN], &[0], 0),
        "clamp/bound" | "clamp/unchanged" => values(COMPONENTS, &[0], 0),
        "clamp/direction" => values(
            &[0.0, -3.0, 4.0, 5.0, 0.9e154, 1.2e154, 1e200, -1e300, -1e-200, f64::MAX, 5e-324, f64::NAN, f64::INFINITY],
            &[0],
            0,
        ),
        "latch/new" => values(TIMES, &[0], 0),
        "latch/event" => values(&[0.0, -0.0, 1.0, 500.0, f64::NAN], &[0], 0),
        "latch/plant" => values(&[0.0, 1.0, 500.0, 1000.0, f64::NAN], &[0, 1, 2], 0),
        "latch/sequence" => values(&[0.0], &[0], 6),
        "latch/plant-sequence" => values(&[0.0], &[0, 1, 2], 6),
        "latch/horizon" => values(&[0.0, 1.0, -1.0, f64::NAN, f64::INFINITY], &[0], 0),
        "number/operations" => values(&[0.0], &[0], 0),
        _ => None,
    };
    let (length, words) = match property {
        "watchdog/sequence" => (
            4,
            Some(
                "symbolic: all times and seqs, sequences of 4 events; enumeration: all sequences of 6 events over the \
                 times {0, 1 s} as clock and ttl and the seqs {1, 2}",
            ),
        ),
        "latch/plant-sequence" => (
            5,
            Some(
                "symbolic: all seqs, sequences of up to 5 events; enumeration: the seqs {0, 1, 2}, sequences of 6; one \
                 clock reading",
            ),
        ),
        "number/operations" => (
            LONGEST,
            Some(
                "all pairs of 24 doubles and of 7 seqs, of every kind and the edges; no engine goes beyond these here, \
                 and the machine code's proofs are about all doubles",
            ),
        ),
        _ => (LONGEST, None),
    };
    Bounds { length, values, words }
}
