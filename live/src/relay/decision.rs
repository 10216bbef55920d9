//! What happens to one frame, and what arrives of it.

use std::time::Duration;

use serde::Serialize;

/// What happens to a frame. Nothing, by default.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Decision {
    /// It is lost.
    pub(crate) lost: bool,
    /// It is lost with those around it.
    pub(crate) burst: bool,
    /// It is late by so much, in ms.
    pub(crate) delay_ms: Option<f64>,
    /// It comes once more, so much later, in ms.
    pub(crate) duplicate_ms: Option<f64>,
    /// It comes after the next one.
    pub(crate) reordered: bool,
    /// It is damaged, and so are its copies.
    pub(crate) corrupt: Option<Corruption>,
    /// It comes so many times more, within so much, in ms.
    pub(crate) flood: Option<(u32, f64)>,
}

/// A kind of fault, as it is counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Fault {
    /// A frame was lost.
    Lost,
    /// A frame was lost in a row of others.
    Burst,
    /// A frame was late.
    Delayed,
    /// A frame came twice.
    Duplicated,
    /// A frame came after the next one.
    Reordered,
    /// A frame was damaged.
    Corrupted,
    /// A frame came in many copies; each is counted.
    Flooded,
    /// A frame met a plane that was cut.
    Cut,
}

/// How a frame is damaged. What comes out, no receiver may take for a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Corruption {
    /// In which way.
    pub(crate) damage: Damage,
    /// Where, as a share of the frame's length.
    place: f64,
}

/// A way to damage a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Damage {
    /// It is cut off.
    Short,
    /// A byte of it is none of UTF-8.
    Byte,
    /// Something comes behind it.
    Tail,
    /// A member comes twice.
    Twice,
}

impl Decision {
    /// When the copies of the frame arrive that do, after it has come; none when it is lost.
    pub(crate) fn copies(&self) -> Vec<Duration> {
        if self.lost || self.burst {
            return Vec::new();
        }
        let first_ms = self.delay_ms.unwrap_or(0.0);
        let mut after_ms = vec![first_ms];
        after_ms.extend(self.duplicate_ms.map(|by| first_ms + by));
        if let Some((copies, within_ms)) = self.flood {
            after_ms.extend((1..=copies).map(|n| first_ms + within_ms * f64::from(n) / f64::from(copies)));
        }
        after_ms.into_iter().map(|ms| Duration::try_from_secs_f64(ms / 1e3).unwrap_or_default()).collect()
    }

    /// What is counted of it, and how often.
    pub(crate) fn faults(&self) -> Vec<(Fault, u64)> {
        if self.burst {
            return vec![(Fault::Burst, 1)];
        }
        if self.lost {
            return vec![(Fault::Lost, 1)];
        }
        let happened = [
            (Fault::Delayed, u64::from(self.delay_ms.is_some())),
            (Fault::Duplicated, u64::from(self.duplicate_ms.is_some())),
            (Fault::Reordered, u64::from(self.reordered)),
            (Fault::Corrupted, u64::from(self.corrupt.is_some())),
            (Fault::Flooded, self.flood.map_or(0, |(copies, _)| u64::from(copies))),
        ];
        happened.into_iter().filter(|(_, times)| *times > 0).collect()
    }
}

impl Fault {
    /// All kinds.
    pub(crate) const ALL: [Self; 8] = [
        Self::Lost,
        Self::Burst,
        Self::Delayed,
        Self::Duplicated,
        Self::Reordered,
        Self::Corrupted,
        Self::Flooded,
        Self::Cut,
    ];

    /// Its name, in lower case.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Lost => "lost",
            Self::Burst => "burst",
            Self::Delayed => "delayed",
            Self::Duplicated => "duplicated",
            Self::Reordered => "reordered",
            Self::Corrupted => "corrupted",
            Self::Flooded => "flooded",
            Self::Cut => "cut",
        }
    }
}

impl Corruption {
    /// What two numbers between 0 and 1 stand for.
    pub(super) fn drawn(how: f64, place: f64) -> Self {
        let damage = match how {
            ..0.25 => Damage::Short,
            ..0.5 => Damage::Byte,
            ..0.75 => Damage::Tail,
            _ => Damage::Twice,
        };
        Self { damage, place }
    }

    /// The damaged frame. A frame that is no JSON object stays none.
    pub(crate) fn of(self, frame: &[u8]) -> Vec<u8> {
        #[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let at = (self.place * frame.len() as f64) as usize;
        let at = at.min(frame.len().saturating_sub(1));
        let mut damaged = frame.to_vec();
        match self.damage {
            Damage::Short => damaged.truncate(at),
            Damage::Byte => {
                if let Some(byte) = damaged.get_mut(at) {
                    *byte = 0xff;
                }
            }
            Damage::Tail => damaged.extend_from_slice(b"]"),
            // The first member of a frame is its version or its kind, a string without a comma.
            Damage::Twice => match frame.iter().position(|byte| *byte == b',') {
                Some(comma) if frame.starts_with(b"{\"") => {
                    damaged.splice(1..1, frame.get(1..=comma).unwrap_or_default().to_vec());
                }
                _ => damaged.extend_from_slice(b"]"),
            },
        }
        damaged
    }
}

#[cfg(test)]
mod tests {
    use ncp_spec::wire::{CommandFrame, Frame, decode_any};

    use super::*;

    #[test]
    fn no_receiver_takes_a_damaged_frame_for_a_frame() {
        let frame = CommandFrame { seq: 3, ..CommandFrame::default() }.encode().unwrap();
        for step in 0..400_u32 {
            for how in [0.0, 0.3, 0.6, 0.9] {
                let corruption = Corruption::drawn(how, f64::from(step) / 400.0);
                let damaged = corruption.of(frame.as_bytes());
                assert!(decode_any(&damaged).is_err(), "{corruption:?}: {}", String::from_utf8_lossy(&damaged));
            }
        }
    }

    #[test]
    fn a_frame_with_a_member_twice_is_still_an_object() {
        let frame = CommandFrame::default().encode().unwrap();
        let twice = Corruption::drawn(0.9, 0.5).of(frame.as_bytes());
        assert!(serde_json::from_slice::<serde_json::Value>(&twice).is_ok());
    }

    #[test]
    fn bytes_that_are_no_frame_can_be_damaged_too() {
        for how in [0.0, 0.3, 0.6, 0.9] {
            for bytes in [&b""[..], b"{", b"{\"kind\"", b"\xff\xff"] {
                assert!(decode_any(&Corruption::drawn(how, 0.99).of(bytes)).is_err());
            }
        }
    }

    #[test]
    fn what_is_lost_has_no_copies_and_a_flood_has_all_of_them() {
        let lost = Decision { lost: true, flood: Some((3, 30.0)), ..Decision::default() };
        assert_eq!((lost.copies(), lost.faults()), (Vec::new(), vec![(Fault::Lost, 1)]));
        let flood = Decision { delay_ms: Some(5.0), flood: Some((3, 30.0)), ..Decision::default() };
        assert_eq!(flood.copies(), [5, 15, 25, 35].map(Duration::from_millis));
        assert_eq!(flood.faults(), [(Fault::Delayed, 1), (Fault::Flooded, 3)]);
        assert_eq!(Decision::default().copies(), [Duration::ZERO]);
    }
}
