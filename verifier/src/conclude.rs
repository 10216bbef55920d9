//! From what became of a peer's cases to the report on the peer: at the end of a run, and anew from results.

use ncp_text::catalogue::{Level, Role};

use crate::dictionary::Dictionary;
use crate::peer::{Call, Description, ExpectedFailure};
use crate::report::{NotAsked, PeerReport, RunReport};
use crate::run::CaseRun;
use crate::suite::{Case, Need, Pattern, Suite};
use crate::verdict::{Baseline, judge, judge_description};

/// What is said of a peer that was asked of sessions, and never opened one.
const NO_SESSION: &str =
    "no session was opened in the whole run: the cases about open sessions show nothing about this server";

/// A peer whose cases were run, and all by which it is judged.
#[derive(Debug)]
pub struct Checked<'s> {
    /// Its name.
    pub name: String,
    /// Where it comes from.
    pub source: String,
    /// What it says about itself.
    pub description: Description,
    /// The level that it is held to.
    pub level: Level,
    /// The roles that were asked for; empty: those that it claims.
    pub asked: &'s [Role],
    /// The list of its expected failures.
    pub entries: &'s [ExpectedFailure],
    /// The same, checked against the suite.
    pub baseline: &'s Baseline,
    /// Which of its cases were run.
    pub extent: Extent,
    /// What became of them, without that of `describe`.
    pub cases: Vec<(&'s Case, CaseRun)>,
    /// How the run went.
    pub run: RunReport,
    /// Whether any answer opened a session; none: nothing was asked of sessions.
    pub opened: Option<bool>,
    /// What it was not asked.
    pub not_asked: Vec<NotAsked>,
}

/// Which of the cases of a peer's roles and level were run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// All.
    Whole,
    /// Those that were picked by filters or an earlier result.
    Picked,
    /// One of several parts.
    Shard,
}

impl Checked<'_> {
    /// Judges the peer and explains what fails.
    #[must_use]
    pub fn conclude(mut self, suite: &Suite) -> PeerReport {
        let mut roles = roles(self.asked, &self.description);
        // That a peer describes itself rightly is no evidence for a role of which nothing is known. Of a part of the
        // cases this says nothing.
        if self.extent != Extent::Shard {
            roles.retain(|(role, _)| self.cases.iter().any(|(case, _)| case.roles.contains(role)));
        }
        self.run.notes.extend(self.not_asked.iter().map(NotAsked::in_words));
        if self.opened == Some(false) && self.extent != Extent::Picked && self.run.given_up.is_none() {
            self.run.notes.push(NO_SESSION.to_owned());
        }
        let describe = (suite.describe(&self.description), judge_description(&self.description));
        let cases: Vec<(&Case, CaseRun)> = std::iter::once(describe).chain(self.cases).collect();
        let verdict = judge(cases, &roles, self.level, self.baseline, self.extent != Extent::Whole);
        let mut report =
            PeerReport::checked(self.name, self.source, &self.description, &verdict, self.run, self.not_asked);
        report.level = Some(self.level);
        report.expecting(self.entries);
        report.diagnose(Dictionary::embedded(), &verdict);
        report
    }
}

/// The roles to judge, each with whether the peer claims it: those that were asked for, or else all that it claims.
#[must_use]
pub fn roles(asked: &[Role], description: &Description) -> Vec<(Role, bool)> {
    let claimed = |role: Role| description.roles.iter().any(|name| name == role.as_str());
    let is_meant = |role: &Role| if asked.is_empty() { claimed(*role) } else { asked.contains(role) };
    Role::ALL.into_iter().filter(is_meant).map(|role| (role, claimed(role))).collect()
}

/// The cases to ask a peer in its roles, up to a level, and by patterns, if there are any; and those of them that need
/// what the peer does not claim.
#[must_use]
pub fn selected<'s>(
    suite: &'s Suite,
    roles: &[(Role, bool)],
    level: Level,
    patterns: &[Pattern],
    description: &Description,
) -> (Vec<&'s Case>, Vec<&'s Case>) {
    let roles: Vec<Role> = roles.iter().map(|(role, _)| *role).collect();
    let meant = |case: &&Case| {
        case.concerns(&roles)
            && case.level <= level
            && (patterns.is_empty() || patterns.iter().any(|pattern| pattern.fits(case)))
    };
    let has = |need: &Need| match need {
        Need::ReferenceNetworks => description.reference_networks,
    };
    suite.cases().iter().filter(meant).partition(|case| case.needs.iter().all(has))
}

/// How many cases were kept from a peer for want of what they need.
#[must_use]
pub fn not_asked(kept: &[&Case]) -> Vec<NotAsked> {
    let counted = Need::ALL.into_iter().map(|need| {
        let cases = kept.iter().filter(|case| case.needs.contains(&need));
        NotAsked { needs: need.as_str().to_owned(), cases: cases.count() }
    });
    counted.filter(|not_asked| not_asked.cases > 0).collect()
}

impl NotAsked {
    /// For people.
    #[must_use]
    pub fn in_words(&self) -> String {
        let Self { needs, cases } = self;
        let (were, need_it) = if *cases == 1 { ("case was", "it needs") } else { ("cases were", "they need") };
        let what = Need::parse(needs).map_or_else(|| needs.clone(), |need| need.in_words().to_owned());
        format!("{cases} {were} not asked: {need_it} {what}, which the peer's `describe` does not claim (`{needs}`)")
    }
}

/// What a report's notes say of the run itself, without what [`Checked::conclude`] adds to them.
#[must_use]
pub fn own_notes(peer: &PeerReport) -> Vec<String> {
    let added: Vec<String> = peer.not_asked.iter().map(NotAsked::in_words).collect();
    let notes = peer.run.iter().flat_map(|run| &run.notes);
    notes.filter(|note| *note != NO_SESSION && !added.contains(note)).cloned().collect()
}

/// Whether any answer opened a session, by what a report says of it; none: nothing was asked of sessions.
#[must_use]
pub fn opened(peer: &PeerReport) -> Option<bool> {
    let is_asked = peer.cases.iter().any(|case| case.call == Call::SessionRun);
    is_asked.then(|| !peer.run.iter().flat_map(|run| &run.notes).any(|note| note == NO_SESSION))
}
