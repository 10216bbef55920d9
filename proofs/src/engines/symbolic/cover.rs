//! Whether the explored paths are all: that every input takes one of them.
//!
//! The condition of a path is the conjunction of its decisions, and the disjunction of all conditions has to be valid.
//! Comparisons and choices are unknowns here, which claims more than of comparisons of numbers. A choice is known by
//! its place among the choices of a path and by the number of its ways, of which there has to be one.
//!
//! Where the paths are many, they are asked part by part: that the decisions which follow a common beginning leave
//! nothing out, and then the same behind each of them. Parts that ask the same are asked once.

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::provers::terms::Decision;

/// So many paths are asked at once.
const AT_ONCE: usize = 200;

/// A script with a question for each part; and how many they are.
pub(super) fn script(title: &str, paths: &[Vec<Decision>]) -> (String, usize) {
    let mut parts = BTreeSet::new();
    let paths: Vec<&[Decision]> = paths.iter().map(Vec::as_slice).collect();
    part(&paths, &mut parts);
    let (mut unknowns, mut questions) = (BTreeSet::new(), String::new());
    for part in &parts {
        questions.push_str("(push 1)\n");
        for path in part {
            questions.push_str("(assert (or false false");
            for decision in path {
                let _ = write!(questions, " {}", other(*decision));
            }
            questions.push_str("))\n");
        }
        questions.push_str("(check-sat)\n(pop 1)\n");
        unknowns.extend(part.iter().flatten().map(|decision| unknown(*decision)));
    }
    let mut text = String::new();
    for line in title.lines() {
        let _ = writeln!(text, "; {line}");
    }
    text.push_str("(set-logic QF_BV)\n");
    for unknown in unknowns {
        text.push_str(&unknown);
    }
    (text + &questions, parts.len())
}

/// Adds the questions whether these paths leave nothing out.
fn part(paths: &[&[Decision]], parts: &mut BTreeSet<Vec<Vec<Decision>>>) {
    if paths.len() <= AT_ONCE {
        parts.insert(paths.iter().map(|path| path.to_vec()).collect());
        return;
    }
    // A path that ends here is taken whatever else is decided.
    if paths.iter().any(|path| path.is_empty()) {
        return;
    }
    let groups: Vec<&[&[Decision]]> = paths.chunk_by(|a, b| a.first() == b.first()).collect();
    let firsts = groups.iter().filter_map(|group| group.first()?.first().copied());
    parts.insert(firsts.map(|first| vec![first]).collect());
    for group in groups {
        let rest: Vec<&[Decision]> = group.iter().filter_map(|path| path.get(1..)).collect();
        part(&rest, parts);
    }
}

/// That a decision is taken otherwise.
fn other(decision: Decision) -> String {
    match decision {
        Decision::Answer(term, true) => format!("(not d{term})"),
        Decision::Answer(term, false) => format!("d{term}"),
        Decision::Way { nth, way, ways } => format!("(not c{nth}_{ways}_{way})"),
    }
}

/// The unknown of a decision; of a choice all ways, one of which is taken.
fn unknown(decision: Decision) -> String {
    match decision {
        Decision::Answer(term, _) => format!("(declare-const d{term} Bool)\n"),
        Decision::Way { nth, ways, .. } => {
            let names: Vec<String> = (0..ways).map(|way| format!("c{nth}_{ways}_{way}")).collect();
            let declared: String = names.iter().map(|name| format!("(declare-const {name} Bool)\n")).collect();
            format!("{declared}(assert (or false false {}))\n", names.join(" "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether some assignment of at most 12 unknowns takes none of the paths: by trying them all.
    fn is_uncovered(part: &[Vec<Decision>]) -> bool {
        let name = |decision: &Decision| match *decision {
            Decision::Answer(term, _) => (0, term as usize, 0),
            Decision::Way { nth, ways, .. } => (1, nth as usize, ways as usize),
        };
        let names: Vec<_> = part.iter().flatten().map(name).collect::<BTreeSet<_>>().into_iter().collect();
        let ways = |at: usize| if names[at].0 == 0 { 2 } else { names[at].2 };
        let mut taken = vec![0; names.len()];
        loop {
            let fits = |decision: &Decision| {
                let at = names.binary_search(&name(decision)).unwrap();
                match *decision {
                    Decision::Answer(_, answer) => (taken[at] == 1) == answer,
                    Decision::Way { way, .. } => taken[at] == way as usize,
                }
            };
            if !part.iter().any(|path| path.iter().all(fits)) {
                return true;
            }
            let Some(at) = (0..names.len()).find(|at| taken[*at] + 1 < ways(*at)) else { return false };
            taken[..at].fill(0);
            taken[at] += 1;
        }
    }

    fn parts(paths: &[Vec<Decision>]) -> BTreeSet<Vec<Vec<Decision>>> {
        let mut parts = BTreeSet::new();
        part(&paths.iter().map(Vec::as_slice).collect::<Vec<_>>(), &mut parts);
        parts
    }

    /// All paths of a tree: a choice of three, and then comparisons.
    fn tree(depth: u32) -> Vec<Vec<Decision>> {
        let mut paths: Vec<Vec<Decision>> = (0..3).map(|way| vec![Decision::Way { nth: 0, way, ways: 3 }]).collect();
        for term in 0..depth {
            let both = |path: Vec<Decision>| {
                [true, false].map(|answer| [&path[..], &[Decision::Answer(term, answer)]].concat())
            };
            paths = paths.into_iter().flat_map(both).collect();
        }
        paths
    }

    #[test]
    fn all_paths_leave_nothing_out_and_without_one_of_them_something() {
        for depth in [3, 8] {
            let whole = tree(depth);
            assert_eq!(whole.len() > AT_ONCE, depth == 8);
            assert!(!parts(&whole).iter().any(|part| is_uncovered(part)), "{depth}");
            for lost in [0, 5, whole.len() - 1] {
                let mut paths = whole.clone();
                paths.remove(lost);
                assert!(parts(&paths).iter().any(|part| is_uncovered(part)), "{depth}, without {lost}");
            }
        }
    }

    #[test]
    fn what_is_asked_of_many_parts_is_asked_once() {
        let (text, questions) = script("a tree", &tree(8));
        assert_eq!(text.matches("(check-sat)").count(), questions);
        assert!(questions < 5, "{questions}");
    }

    #[test]
    fn a_path_is_a_clause_of_what_it_does_not_decide() {
        let paths = [
            vec![Decision::Answer(4, true)],
            vec![Decision::Answer(4, false), Decision::Way { nth: 1, way: 0, ways: 2 }],
        ];
        let (text, questions) = script("two\nlines", &paths);
        assert_eq!(questions, 1);
        let wanted = "; two\n; lines\n(set-logic QF_BV)\n(declare-const c1_2_0 Bool)\n(declare-const c1_2_1 Bool)\n\
            (assert (or false false c1_2_0 c1_2_1))\n(declare-const d4 Bool)\n(push 1)\n\
            (assert (or false false (not d4)))\n(assert (or false false d4 (not c1_2_0)))\n(check-sat)\n(pop 1)\n";
        assert_eq!(text, wanted);
    }
}
