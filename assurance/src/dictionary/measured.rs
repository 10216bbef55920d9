//! What the diagnosis makes of what was seen: the measurements, and their page.

use std::collections::BTreeMap;

use ncp_verifier::dictionary::{Dictionary, Explained, Explanation, Observed};

use crate::document::{Block, heading, table, text};
use crate::lock::Lock;

/// What a diagnosis by the dictionary is worth.
#[derive(Debug, Default)]
pub(super) struct Measured {
    corpus: String,
    /// Defects alone: how many of them are named, and nothing else.
    alone: Share,
    /// What is named instead, or not named.
    wrong_alone: Vec<Wrong>,
    /// Defects that no case tells apart.
    classes: Vec<Vec<String>>,
    /// Defects whose entry is left out: how many of them come out as unexplained.
    left_out: Share,
    /// What is named instead.
    wrong_left_out: Vec<Wrong>,
    /// Pairs and triples: how many of them are named, and nothing else.
    exact: Share,
    /// Of the defects in pairs and triples, those that are named; of those that are named, those that are there.
    recall: Share,
    precision: Share,
    /// The same of triples with one entry left out, of the other two.
    recall_beside: Share,
    precision_beside: Share,
    wrong_together: Vec<Wrong>,
}

/// What is there, and what is said of it.
#[derive(Debug)]
struct Wrong {
    planted: String,
    said: String,
}

/// So many of so many.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Share {
    part: usize,
    whole: usize,
}

impl Share {
    fn count(&mut self, part: usize, whole: usize) {
        self.part += part;
        self.whole += whole;
    }
}

impl std::fmt::Display for Share {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { part, whole } = self;
        match whole {
            0 => f.write_str("none"),
            // Rounded down: 99.96 % is not all.
            _ => {
                let permille = part * 1000 / whole;
                write!(f, "{}.{} % ({part} of {whole})", permille / 10, permille % 10)
            }
        }
    }
}

impl Measured {
    /// Asks the dictionary for what was seen of each defect alone, and of sets of them.
    pub(super) fn of(
        dictionary: &Dictionary,
        singles: &[Observed],
        sets: &[Vec<usize>],
        together: &[Observed],
    ) -> Self {
        let mut measured = Self { corpus: dictionary.corpus.clone(), ..Self::default() };
        measured.singles(dictionary, singles);
        for (set, observed) in sets.iter().zip(together) {
            let found = dictionary.explain(observed);
            let (named, right) = hits(&found, set);
            let is_exact = named == set.len() && right == found.defects.len();
            measured.exact.count(usize::from(is_exact), 1);
            measured.recall.count(named, set.len());
            measured.precision.count(right, found.defects.len());
            if !is_exact {
                measured.wrong_together.push(Wrong::new(dictionary, set, &found));
            }
            if let [unknown, known @ ..] = &set[..]
                && known.len() == 2
            {
                let found = dictionary.explain_without(observed, &[*unknown]);
                let (named, right) = hits(&found, known);
                measured.recall_beside.count(named, known.len());
                measured.precision_beside.count(right, found.defects.len());
            }
        }
        measured
    }

    fn singles(&mut self, dictionary: &Dictionary, singles: &[Observed]) {
        for (place, observed) in singles.iter().enumerate() {
            let found = dictionary.explain(observed);
            let class = match &found.defects[..] {
                [Explained { entries, .. }] if entries.contains(&place) && found.unexplained.is_empty() => {
                    self.alone.count(1, 1);
                    entries.clone()
                }
                _ => {
                    self.alone.count(0, 1);
                    self.wrong_alone.push(Wrong::new(dictionary, &[place], &found));
                    vec![place]
                }
            };
            if class.len() > 1 && class.first() == Some(&place) {
                self.classes.push(class.iter().map(|entry| name(dictionary, *entry)).collect());
            }
            // What no case tells from it goes with it.
            let without = dictionary.explain_without(observed, &class);
            self.left_out.count(usize::from(without.defects.is_empty()), 1);
            if !without.defects.is_empty() {
                self.wrong_left_out.push(Wrong::new(dictionary, &[place], &without));
            }
        }
    }

    /// In a few lines.
    pub(super) fn summary(&self) -> String {
        let Self { alone, left_out, exact, recall, precision, recall_beside, precision_beside, classes, .. } = self;
        format!(
            "alone, exactly named: {alone}; {} classes of defects that no case tells apart\n\
             unknown, unexplained: {left_out}\n\
             together, exactly named: {exact}; recall {recall}, precision {precision}\n\
             beside an unknown one: recall {recall_beside}, precision {precision_beside}\n",
            classes.len()
        )
    }

    /// What git keeps of it, with the digests of the sources.
    pub(super) fn lock(&self, sources: BTreeMap<String, String>) -> Lock {
        let shares = [
            ("alone", self.alone),
            ("left_out", self.left_out),
            ("together", self.exact),
            ("recall", self.recall),
            ("precision", self.precision),
            ("recall_beside", self.recall_beside),
            ("precision_beside", self.precision_beside),
        ];
        let both = |(name, Share { part, whole }): (&str, Share)| {
            [(name.to_owned(), part as u64), (format!("{name}_of"), whole as u64)]
        };
        Lock { sources, counts: shares.into_iter().flat_map(both).collect(), ..Lock::default() }
    }

    /// The short page.
    pub(super) fn page(&self) -> Vec<Block> {
        let row = |what: &str, share: Share, aim: &str| vec![what.to_owned(), share.to_string(), aim.to_owned()];
        let mut page = vec![
            heading(1, "The fault dictionary"),
            text(format!(
                "Made by `cargo assure dictionary`. `verifier/dictionary.json` holds how each of the {} planted \
                 defects (`defects/peer`) shows in the corpus `{}`: which cases fail, and in which way. `ncp-verify \
                 run` explains what a peer does by the fewest of them. This page says what that is worth: peers with \
                 planted defects were diagnosed, each asked every case with a request of up to 64 KiB, and the larger \
                 ones where only these show one of its defects.",
                self.alone.whole,
                self.corpus.get(..16).unwrap_or_default()
            )),
            table(
                &["measured", "found", "aim"],
                [
                    row("one defect: it is named, and nothing else", self.alone, "99 %"),
                    row("one defect that is not in the dictionary: nothing is named", self.left_out, "all"),
                    row("random pairs and triples: all are named, and nothing else", self.exact, ""),
                    row("of the defects in them, those that are named (recall)", self.recall, "95 %"),
                    row("of what is named, what is there (precision)", self.precision, "90 %"),
                    row("triples of which one is not in the dictionary: recall of the others", self.recall_beside, ""),
                    row("the same: precision", self.precision_beside, ""),
                ],
            ),
            text(
                "A defect that no case tells from another counts as named if both are named as one, and is left out \
                 with it. The dictionary and these peers have the same origin, the Rust peer: what is measured is how \
                 well defects are told apart, and not how well those of another implementation are recognised, which \
                 need not be exactly these.",
            ),
        ];
        let mut part = |title: &str, about: &str, rows: Vec<Vec<String>>, head: &[&str]| {
            if !rows.is_empty() {
                page.extend([heading(2, title), text(about), table(head, rows)]);
            }
        };
        let rows = |wrong: &[Wrong]| wrong.iter().map(|one| vec![one.planted.clone(), one.said.clone()]).collect();
        let classes = self.classes.iter().map(|class| vec![class.join(", ")]).collect();
        part("Told apart by no case", "Every case ends alike with these, and in the same way.", classes, &["defects"]);
        part("Not named alone", "", rows(&self.wrong_alone), &["defect", "what is said"]);
        part(
            "Unknown, and named as others",
            "With its entry left out, a defect is taken for these: they do a part of what it does, or nearly the same.",
            rows(&self.wrong_left_out),
            &["defect", "what is said"],
        );
        part(
            "Not named exactly together",
            "Mostly one hides the other: wherever it would show, the other shows first.",
            rows(&self.wrong_together),
            &["defects", "what is said"],
        );
        page
    }
}

/// How many of a set are named, and how many of the named are of the set.
fn hits(found: &Explanation, set: &[usize]) -> (usize, usize) {
    let is_named = |place: &&usize| found.defects.iter().any(|defect| defect.entries.contains(place));
    let is_there = |defect: &&Explained| defect.entries.iter().any(|entry| set.contains(entry));
    (set.iter().filter(is_named).count(), found.defects.iter().filter(is_there).count())
}

fn name(dictionary: &Dictionary, place: usize) -> String {
    dictionary.entries.get(place).map_or_else(String::new, |entry| entry.name.clone())
}

impl Wrong {
    fn new(dictionary: &Dictionary, planted: &[usize], found: &Explanation) -> Self {
        let names = |places: &[usize], between| {
            places.iter().map(|place| name(dictionary, *place)).collect::<Vec<_>>().join(between)
        };
        let mut said: Vec<String> = found
            .defects
            .iter()
            .map(|defect| format!("{} ({} cases)", names(&defect.entries, " or "), defect.cases.len()))
            .collect();
        said.extend((!found.unexplained.is_empty()).then(|| format!("{} unexplained", found.unexplained.len())));
        Self { planted: names(planted, " + "), said: said.join("; ") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_is_rounded_down() {
        let share = |part, whole| Share { part, whole }.to_string();
        assert_eq!(share(2999, 3000), "99.9 % (2999 of 3000)");
        assert_eq!(share(3000, 3000), "100.0 % (3000 of 3000)");
        assert_eq!(share(0, 0), "none");
    }
}
