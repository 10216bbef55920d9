//! The matrix: who does what on which plane, and who may.

use std::fmt;

/// Who comes to the router: those whom its rules know, one of the same authority whom they do not, one of another
/// authority, and one without a certificate.
pub(super) const IDENTITIES: [&str; 6] = ["commander", "robot", "observer", "stranger", "foreigner", "nobody"];

/// Those whom the rules know.
pub(super) const KNOWN: [&str; 3] = ["commander", "robot", "observer"];

/// A plane, with who may put on it, or answer, and who may read it, or ask; the first of each is whom the judge sends
/// beside the others.
#[derive(Debug)]
pub(super) struct Plane {
    pub(super) name: &'static str,
    pub(super) what: &'static str,
    pub(super) key: &'static str,
    puts: &'static [&'static str],
    reads: &'static [&'static str],
}

/// The planes that are published on.
pub(super) static PLANES: [Plane; 3] = [
    Plane {
        name: "perception",
        what: "the perception plane",
        key: "ncp/session/s/sensor/front",
        puts: &["robot"],
        reads: &["commander", "observer"],
    },
    Plane {
        name: "action",
        what: "the action plane",
        key: "ncp/session/s/command",
        puts: &["commander"],
        reads: &["robot", "observer"],
    },
    Plane {
        name: "observation",
        what: "the observation plane",
        key: "ncp/session/s/observation",
        puts: &["commander"],
        reads: &["observer"],
    },
];

/// The control plane.
pub(super) static RPC: Plane =
    Plane { name: "control", what: "control RPC", key: "ncp/rpc", puts: &["commander"], reads: &KNOWN };

/// What somebody does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Act {
    Puts,
    Reads,
    Answers,
    Asks,
}

/// A cell of the matrix.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell<'a> {
    pub(super) who: &'a str,
    pub(super) act: Act,
    pub(super) plane: &'a Plane,
}

impl Plane {
    /// Who legitimately puts on it, or answers.
    pub(super) fn source(&self) -> &'static str {
        self.puts.first().copied().unwrap_or_default()
    }

    /// Who legitimately reads it, or asks.
    pub(super) fn sink(&self) -> &'static str {
        self.reads.first().copied().unwrap_or_default()
    }
}

impl Act {
    /// As in *can … the action plane*.
    pub(super) const fn verb(self) -> &'static str {
        match self {
            Self::Puts => "put on",
            Self::Reads => "read",
            Self::Answers => "answer",
            Self::Asks => "ask",
        }
    }

    const fn as_str(self) -> &'static str {
        match self {
            Self::Puts => "puts",
            Self::Reads => "reads",
            Self::Answers => "answers",
            Self::Asks => "asks",
        }
    }
}

impl Cell<'static> {
    /// All cells of those who come to the rules: whoever has no certificate of the authority does not.
    pub(super) fn all() -> Vec<Self> {
        let of_plane = |who, plane: &'static Plane, acts: [Act; 2]| acts.map(|act| Cell { who, act, plane });
        let of_who = |who| {
            let published = PLANES.iter().flat_map(move |plane| of_plane(who, plane, [Act::Puts, Act::Reads]));
            published.chain(of_plane(who, &RPC, [Act::Answers, Act::Asks]))
        };
        KNOWN.into_iter().chain(["stranger"]).flat_map(of_who).collect()
    }
}

impl Cell<'_> {
    /// Whether the text lets them.
    pub(super) fn may(&self) -> bool {
        match self.act {
            Act::Puts | Act::Answers => self.plane.puts.contains(&self.who),
            Act::Reads | Act::Asks => self.plane.reads.contains(&self.who),
        }
    }
}

impl fmt::Display for Cell<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}/{}", self.who, self.act.as_str(), self.plane.name)
    }
}
