//! What it costs to break a rule, by the table `severity.toml` beside this file.

use std::collections::{BTreeMap, HashMap};
use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

/// What it costs to break a rule; the worst comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// A plant moves when it must not, or a stop is lost.
    Plant,
    /// A number, or where it comes from, is lost.
    Data,
    /// Something is rejected or accepted wrongly.
    Acceptance,
    /// The right thing has another form.
    Form,
}

impl Severity {
    /// All of them, the worst first.
    pub const ALL: [Self; 4] = [Self::Plant, Self::Data, Self::Acceptance, Self::Form];

    /// What it costs to break the rule of this id; an id that is in no area of the table counts as the worst.
    #[must_use]
    pub fn of(rule: &str) -> Self {
        let own = TABLE.rules.get(rule).or_else(|| TABLE.areas.get(area(rule)));
        own.copied().unwrap_or(Self::Plant)
    }

    /// For people.
    #[must_use]
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::Plant => "moves a plant or loses a stop",
            Self::Data => "loses data or provenance",
            Self::Acceptance => "rejects or accepts wrongly",
            Self::Form => "has another form",
        }
    }
}

/// The area of a rule: `SAFE` of `NCP-SAFE-004`.
fn area(rule: &str) -> &str {
    rule.split('-').nth(1).unwrap_or_default()
}

/// The table, rule by rule where it says so.
#[derive(Default)]
struct Table {
    areas: HashMap<String, Severity>,
    rules: HashMap<String, Severity>,
}

/// The table as the file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    areas: HashMap<String, Severity>,
    rules: BTreeMap<Severity, Vec<String>>,
}

const SOURCE: &str = include_str!("severity.toml");

// A test reads the file, so that the default, by which everything is of the worst, never comes about.
static TABLE: LazyLock<Table> = LazyLock::new(|| toml::from_str::<File>(SOURCE).map(Table::from).unwrap_or_default());

impl From<File> for Table {
    fn from(file: File) -> Self {
        let each = |(severity, rules): (Severity, Vec<String>)| rules.into_iter().map(move |rule| (rule, severity));
        Self { areas: file.areas, rules: file.rules.into_iter().flat_map(each).collect() }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use ncp_text::catalogue::Catalogue;

    use super::*;

    #[test]
    fn the_table_has_each_area_of_the_text_and_names_a_rule_once_if_it_differs_from_its_area() {
        let file: File = toml::from_str(SOURCE).unwrap();
        let catalogue = Catalogue::load().unwrap();
        let areas: BTreeSet<&str> = catalogue.iter().map(|rule| area(&rule.id)).collect();
        assert_eq!(file.areas.keys().map(String::as_str).collect::<BTreeSet<_>>(), areas);
        let mut seen = BTreeSet::new();
        for (severity, rule) in file.rules.iter().flat_map(|(severity, rules)| rules.iter().map(move |r| (severity, r)))
        {
            assert!(catalogue.get(rule).is_some(), "the text has no rule {rule}");
            assert!(seen.insert(rule), "{rule} stands twice");
            assert_ne!(file.areas.get(area(rule)), Some(severity), "{rule} has the severity of its area");
        }
    }

    #[test]
    fn a_lost_stop_weighs_most_and_the_order_of_members_least() {
        let order = ["NCP-SAFE-004", "NCP-WIRE-015", "NCP-WIRE-007", "NCP-WIRE-080"].map(Severity::of);
        assert_eq!(order, Severity::ALL);
        assert!(order.is_sorted());
        assert_eq!(Severity::of("NCP-NEW-001"), Severity::Plant);
    }
}
