//! Trees as Coq: a definition each, and the lemma that it is what the model says.

use std::fmt::Write;

use crate::term::Tree;

/// A function of the kernel on terms, and what the model has in its place.
#[derive(Debug, Clone)]
pub struct Export {
    /// Its name in Coq, after `exported_`.
    pub name: String,
    /// The names that stand for what is not known, with their types.
    pub parameters: String,
    /// What is known of these, as hypotheses of the lemma.
    pub given: Vec<String>,
    /// The model's term.
    pub model: String,
    /// What the source does.
    pub tree: Tree,
}

/// The file of all exports.
#[must_use]
pub fn file(exports: &[Export]) -> String {
    let mut text = String::from(
        "(** What the source of the safety kernel does on terms, path by path. Written by ncp-theorem. *)\n\n\
         From Coq Require Import ZArith List Bool.\n\
         From NCP Require Import Kernel Tie.\n\n\
         Section Exported.\n\
         Context {S : Scalar} {Q : Sequence}.\n\
         (* The one law of an index that is used here: it is at most the most that it may be. *)\n\
         Hypothesis index_bounded : forall (x : num S) (most : nat), floor_index x most <= most.\n\n",
    );
    for Export { name, parameters, given, model, tree } in exports {
        let arguments = names(parameters);
        let given: String = given.iter().map(|fact| format!("{fact} = true -> ")).collect();
        let _ = write!(
            text,
            "(* {} paths. *)\n\
             Definition exported_{name} {parameters} :=\n{tree}.\n\
             Lemma {name}_is_the_model : forall {parameters}, {given}{model} = exported_{name} {arguments}.\n\
             Proof. unfold exported_{name}. tie index_bounded. Qed.\n\n",
            tree.paths(),
        );
    }
    text.push_str("End Exported.\n");
    text
}

/// The names of `(a b : A) (c : C)`.
fn names(parameters: &str) -> String {
    let groups = parameters.split('(').filter_map(|group| group.split_once(':'));
    groups.map(|(names, _)| names.trim()).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_names_of_parameters_are_its_arguments() {
        assert_eq!(names("(a b : num S) (c : bool)"), "a b c");
    }
}
