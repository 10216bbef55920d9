//! What differs between two results, on a terminal or as Markdown.

use std::collections::HashMap;

use super::layout::{Style, cut, wrap};
use super::terminal::{plural, plural_verb, thousands};
use crate::diff::{Change, Comparison, PeerComparison, Side};

/// How many cases of a rule are named.
const NAMED: usize = 2;

/// How a comparison is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// For a terminal, or a pipe.
    Terminal(Style),
    /// For a pull request, or release notes.
    Markdown,
}

/// Renders what differs between two results. With `all`, every case is named.
#[must_use]
pub fn comparison(comparison: &Comparison, form: Form, all: bool) -> String {
    let mut page = Page { sentences: &comparison.sentences, form, all, out: String::new() };
    for peer in &comparison.peers {
        page.peer(peer);
    }
    for (names, which) in [(&comparison.only_in_old, "older"), (&comparison.only_in_new, "newer")] {
        if !names.is_empty() {
            page.paragraph(&format!("only the {which} result has {}", names.join(", ")));
        }
    }
    if !comparison.same_corpus {
        page.paragraph("the two results are of different cases: what only one of them has is not compared");
    }
    let lost: usize = comparison.peers.iter().map(PeerComparison::regressions).sum();
    page.paragraph(&match (comparison.regression, lost) {
        (true, 0) => "regression: a peer is no longer checked".to_owned(),
        (true, _) => {
            let those = plural_verb(lost, "case that passed no longer does", "cases that passed no longer do");
            format!("regression: {those}")
        }
        (false, _) => "no regression".to_owned(),
    });
    page.out
}

struct Page<'c> {
    sentences: &'c HashMap<String, String>,
    form: Form,
    all: bool,
    out: String,
}

impl Page<'_> {
    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    fn paragraph(&mut self, text: &str) {
        match self.form {
            Form::Terminal(style) => self.line(&wrap(text, style.width, "", "")),
            Form::Markdown => self.line(&format!("{text}.\n")),
        }
    }

    fn peer(&mut self, peer: &PeerComparison) {
        let of = |side: &Side| {
            let version = side.version.as_deref().unwrap_or("?");
            format!("{version}, {}", side.conclusion.as_deref().unwrap_or("not checked"))
        };
        let title = format!("{}: {} → {}", peer.name, of(&peer.old), of(&peer.new));
        match self.form {
            Form::Terminal(style) => self.line(&style.bold(&title)),
            Form::Markdown => self.line(&format!("## {title}\n")),
        }
        let fixed = plural_verb(peer.fixed.len(), "case is", "cases are");
        self.changes(&peer.fixed, &format!("{fixed} fixed"), Style::green);
        let (hidden, seen): (Vec<&Change>, Vec<&Change>) =
            peer.newly_failing.iter().partition(|change| change.unmasked);
        let newly = plural_verb(peer.newly_failing.len(), "case newly fails", "cases newly fail");
        let of_these = match hidden.len() {
            0 => String::new(),
            count => format!(
                ", {} of which {} hidden before",
                thousands(count as u64),
                if count == 1 { "was" } else { "were" }
            ),
        };
        self.changes(seen, &format!("{newly}{of_these}"), Style::red);
        if !hidden.is_empty() {
            let title = format!("hidden before, and now seen to fail: {}", plural(hidden.len(), "case"));
            self.changes(hidden, &title, Style::yellow);
        }
        let changed = plural_verb(peer.changed.len(), "case fails", "cases fail");
        self.changes(&peer.changed, &format!("{changed} in another way"), Style::yellow);
        let (passing, failing) = (thousands(peer.passing_as_before as u64), thousands(peer.failing_as_before as u64));
        let mut rest = format!("{passing} pass and {failing} fail as before");
        for (count, what) in
            [(peer.only_in_old, "only in the older result"), (peer.only_in_new, "only in the newer one")]
        {
            if count > 0 {
                rest.push_str(&format!("; {} {what}", plural(count, "case")));
            }
        }
        if peer.failing_only_in_new > 0 {
            rest.push_str(&format!(", {} of which fail", thousands(peer.failing_only_in_new as u64)));
        }
        match self.form {
            Form::Terminal(style) => self.line(&format!("{}\n", wrap(&rest, style.width, "  ", "  "))),
            Form::Markdown => self.paragraph(&rest),
        }
    }

    /// Changes of one kind, rule by rule, the rule with the most cases first.
    fn changes<'c>(
        &mut self,
        changes: impl IntoIterator<Item = &'c Change>,
        title: &str,
        paint: fn(Style, &str) -> String,
    ) {
        let mut rules: Vec<(&str, Vec<&Change>)> = Vec::new();
        for change in changes {
            match rules.iter_mut().find(|(rule, _)| *rule == change.rule) {
                Some((_, cases)) => cases.push(change),
                None => rules.push((&change.rule, vec![change])),
            }
        }
        // Stable: rules with as many cases keep the order in which they first occur.
        rules.sort_by_key(|(_, cases)| std::cmp::Reverse(cases.len()));
        self.title(title, paint);
        if rules.is_empty() {
            return;
        }
        if self.form == Form::Markdown {
            self.line("| rule | cases | sentence | such as |\n|---|---|---|---|");
        }
        for (rule, cases) in rules {
            self.rule(rule, &cases);
        }
        if self.form == Form::Markdown {
            self.line("");
        }
    }

    fn title(&mut self, title: &str, paint: fn(Style, &str) -> String) {
        match self.form {
            Form::Terminal(style) => self.line(&format!("  {}", paint(style, title))),
            Form::Markdown => self.line(&format!("### {title}\n")),
        }
    }

    fn rule(&mut self, rule: &str, cases: &[&Change]) {
        let sentence = self.sentences.get(rule).map_or("", String::as_str);
        let count = thousands(cases.len() as u64);
        let named = if self.all { cases.len() } else { NAMED };
        match self.form {
            Form::Terminal(style) => {
                let head = format!("    {rule:13} {count:>5}  ");
                let room = style.width.saturating_sub(head.chars().count());
                self.line(&format!("{head}{}", cut(sentence, room)));
                for change in cases.iter().take(named) {
                    self.line(&format!("      {} [{} → {}]", change.case, change.old, change.new));
                }
            }
            Form::Markdown => {
                let ids: Vec<String> = cases.iter().take(named).map(|change| format!("`{}`", change.case)).collect();
                let sentence = sentence.replace('|', "\\|");
                self.line(&format!("| {rule} | {count} | {sentence} | {} |", ids.join("<br>")));
            }
        }
    }
}
