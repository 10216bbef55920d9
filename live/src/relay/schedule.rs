//! What a hostile link does to frames: a schedule in TOML, and the decisions that follow from it and a seed.

use std::path::{Path, PathBuf};

use ncp_spec::contract::fnv1a_64;
use ncp_spec::plane::Plane;
use rand::distributions::Standard;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::decision::{Corruption, Decision};

/// What a link does, plane by plane. What is not given does not happen.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct Schedule {
    /// What all decisions are drawn from.
    pub(crate) seed: u64,
    /// Requests and replies.
    pub(crate) control: Faults,
    /// Sensor frames.
    pub(crate) perception: Faults,
    /// Commands.
    pub(crate) action: Faults,
    /// Observations.
    pub(crate) observation: Faults,
    /// When planes are cut altogether.
    #[serde(rename = "cut")]
    pub(crate) cuts: Vec<Cut>,
}

/// What happens to the frames of a plane, each stream for itself. A member without a unit is a probability, by frame.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct Faults {
    /// The frame is lost.
    pub(crate) lose: f64,
    /// Frames in a row are lost.
    pub(crate) burst: Option<Burst>,
    /// The frame is late.
    pub(crate) delay: f64,
    /// By at least and by at most so much, in ms.
    pub(crate) delay_ms: [f64; 2],
    /// The frame comes twice.
    pub(crate) duplicate: f64,
    /// The second time so much later, at least and at most, in ms.
    pub(crate) duplicate_ms: [f64; 2],
    /// The frame changes places with the next of its stream.
    pub(crate) reorder: f64,
    /// What arrives is no JSON object any more, or has a member twice.
    pub(crate) corrupt: f64,
    /// Copies of the frame flood the link.
    pub(crate) flood: f64,
    /// So many.
    pub(crate) flood_copies: u32,
    /// Spread over so much, in ms.
    pub(crate) flood_ms: f64,
}

/// A window of a stream that is lost, counted in frames: it is where it is however fast the frames come.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Burst {
    /// From one window to the next.
    pub(crate) every: u64,
    /// How many of them are lost, the last ones.
    pub(crate) frames: u64,
}

/// Planes that let nothing through for a while.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Cut {
    /// Which.
    pub(crate) planes: Vec<PlaneName>,
    /// Once in so much, in s.
    pub(crate) every_s: f64,
    /// For so long, in s.
    pub(crate) for_s: f64,
    /// How far into each such time, in s; without it, that is drawn.
    pub(crate) at_s: Option<f64>,
}

/// A plane by its name in the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum PlaneName {
    /// Requests and replies.
    Control,
    /// Sensor frames.
    Perception,
    /// Commands.
    Action,
    /// Observations.
    Observation,
}

/// Why a schedule is none.
#[derive(Debug, Error)]
pub(crate) enum ScheduleError {
    /// It cannot be read.
    #[error("{path}: {source}")]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// It is no schedule.
    #[error("schedule: {0}")]
    Toml(#[from] toml::de::Error),
    /// A number is out of range.
    #[error("schedule: {plane:?}: {member} is {value}, and has to be from 0 to {most}")]
    Range {
        /// The plane.
        plane: PlaneName,
        /// The member.
        member: &'static str,
        /// What it is.
        value: f64,
        /// What it may be.
        most: f64,
    },
    /// A cut that is longer than its period, or no time.
    #[error("schedule: a cut of {for_s} s every {every_s} s")]
    Cut {
        /// Its period, in s.
        every_s: f64,
        /// Its length, in s.
        for_s: f64,
    },
}

/// The longest that a frame is held back, in ms.
const LONGEST_MS: f64 = 10_000.0;

/// The most copies of a flood.
const MOST_COPIES: f64 = 10_000.0;

impl Schedule {
    /// Reads a schedule.
    ///
    /// # Errors
    /// It is none.
    pub(crate) fn read(path: &Path) -> Result<Self, ScheduleError> {
        let text =
            std::fs::read_to_string(path).map_err(|source| ScheduleError::Io { path: path.to_owned(), source })?;
        Self::parse(&text)
    }

    /// Reads a schedule from its source.
    ///
    /// # Errors
    /// It is none.
    pub(crate) fn parse(text: &str) -> Result<Self, ScheduleError> {
        let schedule: Self = toml::from_str(text)?;
        schedule.checked()
    }

    /// The schedule, if its numbers are in range.
    ///
    /// # Errors
    /// One is not.
    pub(crate) fn checked(self) -> Result<Self, ScheduleError> {
        for plane in PlaneName::ALL {
            let of = self.of(plane);
            // Of a range that begins below 0, or nowhere, that is what is wrong.
            let worst = |[least, most]: [f64; 2]| if least >= 0.0 { least.max(most) } else { least };
            let [delay, duplicate] = [of.delay_ms, of.duplicate_ms].map(worst);
            let numbers = [
                ("lose", of.lose, 1.0),
                ("delay", of.delay, 1.0),
                ("delay_ms", delay, LONGEST_MS),
                ("duplicate", of.duplicate, 1.0),
                ("duplicate_ms", duplicate, LONGEST_MS),
                ("reorder", of.reorder, 1.0),
                ("corrupt", of.corrupt, 1.0),
                ("flood", of.flood, 1.0),
                ("flood_copies", f64::from(of.flood_copies), MOST_COPIES),
                ("flood_ms", of.flood_ms, LONGEST_MS),
            ];
            for (member, value, most) in numbers {
                if !(0.0..=most).contains(&value) {
                    return Err(ScheduleError::Range { plane, member, value, most });
                }
            }
        }
        for Cut { every_s, for_s, at_s, .. } in &self.cuts {
            let ends_s = at_s.unwrap_or(0.0) + for_s;
            if !(*for_s > 0.0 && at_s.is_none_or(|at_s| at_s >= 0.0) && ends_s <= *every_s && every_s.is_finite()) {
                return Err(ScheduleError::Cut { every_s: *every_s, for_s: *for_s });
            }
        }
        Ok(self)
    }

    /// What happens to the frames of a plane.
    pub(crate) const fn of(&self, plane: PlaneName) -> &Faults {
        match plane {
            PlaneName::Control => &self.control,
            PlaneName::Perception => &self.perception,
            PlaneName::Action => &self.action,
            PlaneName::Observation => &self.observation,
        }
    }

    /// The decisions on a stream, by its key below the realm. They depend on nothing but the schedule and this name.
    pub(crate) fn stream(&self, plane: PlaneName, name: &str) -> Stream {
        Stream { faults: self.of(plane).clone(), rng: self.rng(&format!("{plane:?}/{name}")), frames: 0 }
    }

    /// Whether a plane is cut so many seconds after the link came up.
    pub(crate) fn is_cut(&self, plane: PlaneName, at_s: f64) -> bool {
        self.cuts.iter().enumerate().filter(|(_, cut)| cut.planes.contains(&plane)).any(|(number, cut)| {
            let (from_s, to_s) = self.window(number, cut, (at_s / cut.every_s).floor());
            (from_s..to_s).contains(&at_s)
        })
    }

    /// All cuts that begin within so many seconds: the planes, from when and until when, in s, in their order.
    pub(crate) fn windows(&self, longest_s: f64) -> Vec<(&[PlaneName], f64, f64)> {
        let mut windows = Vec::new();
        for (number, cut) in self.cuts.iter().enumerate() {
            let mut n = 0.0;
            while n * cut.every_s < longest_s {
                let (from_s, to_s) = self.window(number, cut, n);
                if from_s < longest_s {
                    windows.push((&*cut.planes, from_s, to_s));
                }
                n += 1.0;
            }
        }
        windows.sort_by(|a, b| a.1.total_cmp(&b.1));
        windows
    }

    /// From when to when a cut lasts the nth time, in s.
    fn window(&self, number: usize, cut: &Cut, n: f64) -> (f64, f64) {
        let drawn = || unit(&mut self.rng(&format!("cut/{number}/{n}"))) * (cut.every_s - cut.for_s);
        let from_s = n * cut.every_s + cut.at_s.unwrap_or_else(drawn);
        (from_s, from_s + cut.for_s)
    }

    fn rng(&self, name: &str) -> ChaCha8Rng {
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        rng.set_stream(fnv1a_64(name.as_bytes()));
        rng
    }
}

/// The decisions on the frames of one stream, in their order.
#[derive(Debug, Clone)]
pub(crate) struct Stream {
    faults: Faults,
    rng: ChaCha8Rng,
    frames: u64,
}

impl Stream {
    /// What happens to the next frame. Every frame draws the same numbers, whatever becomes of it.
    pub(crate) fn next(&mut self) -> Decision {
        let mut drawn = [0.0; 10];
        drawn.fill_with(|| unit(&mut self.rng));
        let [lose, delay, delay_by, duplicate, duplicate_by, reorder, corrupt, how, place, flood] = drawn;
        let Faults { delay_ms, duplicate_ms, flood_copies, flood_ms, burst, .. } = self.faults;
        let within = |[least, most]: [f64; 2], drawn: f64| least + (most - least).max(0.0) * drawn;
        let of_window = |Burst { every, frames }: Burst| self.frames % every.max(1) >= every.saturating_sub(frames);
        let decision = Decision {
            lost: lose < self.faults.lose,
            burst: burst.is_some_and(of_window),
            delay_ms: (delay < self.faults.delay).then(|| within(delay_ms, delay_by)),
            duplicate_ms: (duplicate < self.faults.duplicate).then(|| within(duplicate_ms, duplicate_by)),
            reordered: reorder < self.faults.reorder,
            corrupt: (corrupt < self.faults.corrupt).then(|| Corruption::drawn(how, place)),
            flood: (flood < self.faults.flood).then_some((flood_copies, flood_ms)),
        };
        self.frames += 1;
        decision
    }
}

impl PlaneName {
    /// All planes.
    pub(crate) const ALL: [Self; 4] = [Self::Control, Self::Perception, Self::Action, Self::Observation];

    /// The plane of the text.
    pub(crate) const fn plane(self) -> Plane {
        match self {
            Self::Control => Plane::Control,
            Self::Perception => Plane::Perception,
            Self::Action => Plane::Action,
            Self::Observation => Plane::Observation,
        }
    }
}

/// A number from 0 to less than 1, out of one draw.
fn unit(rng: &mut ChaCha8Rng) -> f64 {
    rng.sample(Standard)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: &str = r#"
        [action]
        lose = 0.1
        burst = { every = 50, frames = 5 }
        delay = 0.2
        delay_ms = [5, 50]
        duplicate = 0.2
        duplicate_ms = [1, 9]
        reorder = 0.1
        corrupt = 0.1
        flood = 0.05
        flood_copies = 7
        flood_ms = 100

        [[cut]]
        planes = ["action", "control"]
        every_s = 10
        for_s = 2
    "#;

    fn schedule(seed: u64) -> Schedule {
        Schedule { seed, ..Schedule::parse(ALL).unwrap() }
    }

    fn decisions(mut stream: Stream) -> Vec<Decision> {
        (0..2_000).map(|_| stream.next()).collect()
    }

    #[test]
    fn a_seed_gives_a_stream_the_same_decisions_each_time_and_another_seed_others() {
        let of = |seed| decisions(schedule(seed).stream(PlaneName::Action, "session/s/command"));
        assert_eq!(of(7), of(7));
        assert_ne!(of(7), of(8));
    }

    #[test]
    fn the_decisions_on_a_stream_do_not_depend_on_when_the_frames_of_others_come() {
        let schedule = schedule(7);
        let [mut one, mut other] = ["front", "rear"].map(|name| schedule.stream(PlaneName::Action, name));
        let mut between = Vec::new();
        for n in 0..2_000 {
            for _ in 0..n % 4 {
                other.next();
            }
            between.push(one.next());
        }
        assert_eq!(between, decisions(schedule.stream(PlaneName::Action, "front")));
        assert_ne!(between, decisions(schedule.stream(PlaneName::Action, "rear")));
    }

    #[test]
    fn what_happens_to_a_frame_leaves_the_decisions_on_the_next_as_they_were() {
        let mut sparse = schedule(7);
        sparse.action.duplicate = 0.0;
        let all = decisions(schedule(7).stream(PlaneName::Action, "s"));
        let expected: Vec<Decision> = all.into_iter().map(|one| Decision { duplicate_ms: None, ..one }).collect();
        assert_eq!(decisions(sparse.stream(PlaneName::Action, "s")), expected);
    }

    #[test]
    fn faults_come_as_often_as_the_schedule_says_and_on_no_other_plane() {
        let all = decisions(schedule(7).stream(PlaneName::Action, "s"));
        let share = |is: fn(&Decision) -> bool| all.iter().filter(|one| is(one)).count();
        assert!((120..=280).contains(&share(|one| one.lost)));
        assert_eq!(share(|one| one.burst), 200);
        assert!((300..=500).contains(&share(|one| one.delay_ms.is_some())));
        assert!((300..=500).contains(&share(|one| one.duplicate_ms.is_some())));
        assert!((50..=150).contains(&share(|one| one.flood.is_some())));
        for one in &all {
            assert!(one.delay_ms.is_none_or(|by| (5.0..=50.0).contains(&by)), "{one:?}");
        }
        let others = decisions(schedule(7).stream(PlaneName::Perception, "s"));
        assert!(others.iter().all(|one| *one == Decision::default()));
    }

    #[test]
    fn a_cut_is_where_its_windows_are_once_in_each_period() {
        let schedule = schedule(7);
        let windows = schedule.windows(60.0);
        assert_eq!(windows.len(), 6);
        for (n, (planes, from_s, to_s)) in (0_u32..).zip(windows) {
            let began_s = f64::from(n) * 10.0;
            assert!(from_s >= began_s && to_s <= began_s + 10.0, "{from_s} to {to_s}");
            assert_eq!(planes, [PlaneName::Action, PlaneName::Control]);
            assert!(schedule.is_cut(PlaneName::Action, f64::midpoint(from_s, to_s)));
            assert!(!schedule.is_cut(PlaneName::Perception, f64::midpoint(from_s, to_s)));
            assert!(
                !schedule.is_cut(PlaneName::Action, to_s + 1e-6) && !schedule.is_cut(PlaneName::Action, from_s - 1e-6)
            );
        }
    }

    #[test]
    fn a_number_out_of_range_and_an_unknown_member_are_refused() {
        let range = |text: &str| matches!(Schedule::parse(text), Err(ScheduleError::Range { .. }));
        assert!(range("[action]\nlose = 1.5") && range("[action]\ndelay = nan") && range("[action]\nflood_ms = -1"));
        assert!(range("[action]\ndelay_ms = [-1, 5]"));
        assert!(matches!(Schedule::parse("[action]\nloose = 1"), Err(ScheduleError::Toml(_))));
        let cut = |every: f64| {
            let text = format!("[[cut]]\nplanes = ['action']\nevery_s = {every:?}\nfor_s = 2.0");
            matches!(Schedule::parse(&text), Err(ScheduleError::Cut { .. }))
        };
        assert!(cut(1.0) && cut(0.0) && cut(f64::INFINITY) && !cut(3.0));
    }
}
