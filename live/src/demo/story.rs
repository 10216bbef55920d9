//! What happens when: the goals of the flight, what operator and supervisor do, and what the link does.

use std::fmt::Write as _;
use std::slice;

use serde::Deserialize;

use crate::LiveError;
use crate::relay::schedule::Schedule;
use crate::target::Mapping;

/// The project's own flight.
pub(super) const OWN: &str = include_str!("../../demo.toml");

/// A flight.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Story {
    /// How long it takes, in s.
    pub(super) time_s: f64,
    /// For how long each waypoint is the goal, in s.
    leg_s: f64,
    /// One after the other, and then from the start, in m.
    pub(super) waypoints: Vec<[f64; 3]>,
    /// What goes on besides, in the order of its beginning.
    #[serde(rename = "event")]
    pub(super) events: Vec<Event>,
    /// How the motion of the quad is read from its sensor stream.
    pub(super) mapping: Mapping,
}

/// Something that happens.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Event {
    pub(super) name: Name,
    /// For people.
    pub(super) about: String,
    pub(super) from_s: f64,
    pub(super) to_s: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Name {
    /// The operator asks for HOLD.
    Hold,
    /// The operator asks for ESTOP.
    Estop,
    /// The supervisor resets commander and plant.
    Reset,
    /// The perception plane is cut.
    Dropout,
    /// The action plane is cut.
    Silence,
    /// Both lose most of what they carry.
    Jam,
}

impl Name {
    pub(super) const fn as_str(self) -> &'static str {
        match self {
            Self::Hold => "hold",
            Self::Estop => "estop",
            Self::Reset => "reset",
            Self::Dropout => "dropout",
            Self::Silence => "silence",
            Self::Jam => "jam",
        }
    }
}

/// What the operator asks for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Asked {
    #[default]
    Fly,
    Hold,
    Estop,
}

impl Story {
    /// Reads a story.
    ///
    /// # Errors
    /// It is none.
    pub(super) fn parse(text: &str) -> Result<Self, LiveError> {
        let story: Self = toml::from_str(text).map_err(LiveError::Story)?;
        match story.waypoints.is_empty() || !(story.leg_s > 0.0 && story.time_s > 0.0) {
            true => Err(LiveError::Unknown("waypoints, leg_s and time_s of a flight".to_owned())),
            false => Ok(story),
        }
    }

    /// Where to fly, in m.
    pub(super) fn goal(&self, now_s: f64) -> [f64; 3] {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few legs")]
        let leg = (now_s / self.leg_s).max(0.0) as usize;
        self.waypoints.get(leg % self.waypoints.len().max(1)).copied().unwrap_or_default()
    }

    /// What the operator asks for.
    pub(super) fn asked(&self, now_s: f64) -> Asked {
        let is_now = |event: &&Event| (event.from_s..event.to_s).contains(&now_s);
        let asked = self.events.iter().filter(is_now).find_map(|event| match event.name {
            Name::Hold => Some(Asked::Hold),
            Name::Estop => Some(Asked::Estop),
            Name::Reset | Name::Dropout | Name::Silence | Name::Jam => None,
        });
        asked.unwrap_or_default()
    }

    /// What the link does.
    ///
    /// # Errors
    /// A time is out of range.
    pub(super) fn link(&self) -> Result<Schedule, LiveError> {
        /// Of each so much time a jam lets through the rest, in s.
        const JAMMED_S: (f64, f64) = (0.1, 0.06);
        let mut text = "seed = 1\n".to_owned();
        let mut cut = |planes: &str, at_s: f64, for_s: f64| {
            // A cut comes again; this one does so after all is over.
            let every_s = 1e6;
            let _ = write!(
                text,
                "[[cut]]\nplanes = [{planes}]\nat_s = {at_s:?}\nfor_s = {for_s:?}\nevery_s = {every_s:?}\n"
            );
        };
        for Event { name, from_s, to_s, .. } in &self.events {
            match name {
                Name::Dropout => cut(r#""perception""#, *from_s, to_s - from_s),
                Name::Silence => cut(r#""action""#, *from_s, to_s - from_s),
                Name::Jam => {
                    let mut at_s = *from_s;
                    while at_s < *to_s {
                        cut(r#""perception", "action""#, at_s, JAMMED_S.1);
                        at_s += JAMMED_S.0;
                    }
                }
                Name::Hold | Name::Estop | Name::Reset => {}
            }
        }
        Ok(Schedule::parse(&text)?)
    }

    /// The events, to be told as they begin.
    pub(super) fn told(&self) -> Told<'_> {
        Told { events: self.events.iter() }
    }
}

/// The events that were not told yet.
pub(super) struct Told<'s> {
    events: slice::Iter<'s, Event>,
}

impl<'s> Told<'s> {
    /// Those that have begun since it was asked last.
    pub(super) fn until(&mut self, now_s: f64) -> impl Iterator<Item = &'s Event> {
        let begun = self.events.as_slice().iter().take_while(|event| event.from_s <= now_s).count();
        let (now, later) = self.events.as_slice().split_at(begun);
        self.events = later.iter();
        now.iter()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::relay::schedule::PlaneName;

    #[test]
    fn the_own_flight_holds_stops_and_loses_what_it_says() {
        let story = Story::parse(OWN).unwrap();
        let link = story.link().unwrap();
        assert_eq!(story.asked(11.0), Asked::Hold);
        assert_eq!(story.asked(36.5), Asked::Estop);
        assert_eq!(story.asked(20.0), Asked::Fly);
        assert!(link.is_cut(PlaneName::Perception, 17.5) && !link.is_cut(PlaneName::Action, 17.5));
        assert!(link.is_cut(PlaneName::Action, 23.0) && !link.is_cut(PlaneName::Perception, 23.0));
        assert!(link.is_cut(PlaneName::Perception, 28.02) && !link.is_cut(PlaneName::Perception, 28.08));
    }

    #[test]
    fn an_event_is_told_once_and_in_its_order() {
        let story = Story::parse(OWN).unwrap();
        let mut told = story.told();
        assert_eq!(told.until(9.9).count(), 0);
        assert_eq!(told.until(18.0).map(|event| event.name).collect::<Vec<_>>(), [Name::Hold, Name::Dropout]);
        assert_eq!(told.until(18.0).count(), 0);
    }

    #[test]
    fn goals_follow_one_another_and_begin_anew() {
        let story = Story::parse(OWN).unwrap();
        assert_eq!(story.goal(0.0), story.goal(20.0));
        assert_ne!(story.goal(0.0), story.goal(5.0));
    }
}
