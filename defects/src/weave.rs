//! Puts switches into the text of a source file.
//!
//! At the place of a defect, the code becomes `(if switch(7) { with } else { code })`. Several defects may share a
//! place, or stand within each other, so that one build holds all of them, alone and together. An edit that is always
//! made, such as a field that only a defect uses, becomes its `with`, once for all that make it.

use std::ops::Range;

use thiserror::Error;

use crate::place::{self, PlaceError};
use crate::table::Edit;

/// An edit of a defect, by the number under which it is switched on.
#[derive(Debug, Clone, Copy)]
pub struct Site<'t> {
    /// The defect's number.
    pub number: usize,
    /// Its name.
    pub name: &'t str,
    /// Where it changes the file, and how. The code is an expression.
    pub edit: &'t Edit,
}

/// Why defects do not fit a file.
#[derive(Debug, PartialEq, Eq, Error)]
pub enum WeaveError {
    /// One of them has no place in it.
    #[error(transparent)]
    Place(#[from] PlaceError),
    /// Two of them cut each other.
    #[error("the defects {first} and {second} change places that overlap, neither within the other")]
    Overlap {
        /// One.
        first: String,
        /// The other.
        second: String,
    },
}

/// The text with a switch for every site, and without its unit tests. `switch` is the path of a function that says
/// whether the defect of a number is switched on.
///
/// # Errors
/// A site whose place is not exactly one, or that overlaps another.
pub fn weave(text: &str, switch: &str, sites: &[Site<'_>]) -> Result<String, WeaveError> {
    let text = place::without_tests(text);
    let mut places = sites
        .iter()
        .map(|site| Ok((place::find(text, site.name, site.edit)?, site)))
        .collect::<Result<Vec<_>, PlaceError>>()?;
    // The outer before the inner ones, and those of one place together.
    places.sort_by_key(|(span, site)| (span.start, usize::MAX - span.end, site.number));
    let mut woven = String::with_capacity(2 * text.len());
    replace(text, 0..text.len(), switch, &places, &mut woven)?;
    Ok(woven)
}

/// Writes a part of the text with the switches of the places in it.
fn replace(
    text: &str,
    part: Range<usize>,
    switch: &str,
    mut places: &[(Range<usize>, &Site<'_>)],
    woven: &mut String,
) -> Result<(), WeaveError> {
    let mut at = part.start;
    while let Some((outer, site)) = places.first() {
        let here = places.iter().take_while(|(span, _)| span == outer).count();
        let (chain, others) = places.split_at(here);
        let touching = others.iter().take_while(|(span, _)| span.start < outer.end);
        let (inner, behind) = others.split_at(touching.count());
        if let Some((_, second)) = inner.iter().find(|(span, _)| span.end > outer.end) {
            return Err(WeaveError::Overlap { first: site.name.to_owned(), second: second.name.to_owned() });
        }
        woven.push_str(slice(text, at..outer.start));
        if let Some((_, always)) = chain.iter().find(|(_, site)| site.edit.always) {
            let other = chain.iter().find(|(_, other)| !other.edit.always || other.edit.with != always.edit.with);
            if let Some((_, second)) = other.or(inner.first()) {
                return Err(WeaveError::Overlap { first: always.name.to_owned(), second: second.name.to_owned() });
            }
            woven.push_str(&always.edit.with);
            at = outer.end;
            places = behind;
            continue;
        }
        woven.push('(');
        for (_, Site { number, edit, .. }) in chain {
            woven.push_str(&format!("if {switch}({number}) {{ {} }} else ", edit.with));
        }
        woven.push_str("{ ");
        replace(text, outer.clone(), switch, inner, woven)?;
        woven.push_str(" })");
        at = outer.end;
        places = behind;
    }
    woven.push_str(slice(text, at..part.end));
    Ok(())
}

fn slice(text: &str, span: Range<usize>) -> &str {
    text.get(span).unwrap_or_default()
}
