//! Puts switches into the text of a source file.
//!
//! At the place of a mutant, the expression `code` becomes
//! `(if mutant!(7) { with } else { code })`. Several mutants may share a place, or stand within each other.

use std::ops::Range;

use thiserror::Error;

/// Where a mutant changes a file.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Site<'t> {
    /// The mutant's number.
    pub(crate) number: usize,
    /// Its name.
    pub(crate) name: &'t str,
    /// A text that stands once; the code is looked for behind it.
    pub(crate) after: Option<&'t str>,
    /// The expression.
    pub(crate) code: &'t str,
    /// What replaces it.
    pub(crate) with: &'t str,
}

/// Why a mutant does not fit the file.
#[derive(Debug, PartialEq, Eq, Error)]
pub(crate) enum WeaveError {
    #[error("the mutant {mutant}: its `{part}` does not stand there: {text}")]
    Missing { mutant: String, part: &'static str, text: String },
    #[error("the mutant {mutant}: its `{part}` stands there more than once: {text}")]
    Repeated { mutant: String, part: &'static str, text: String },
    #[error("the mutants {first} and {second} change places that overlap, neither within the other")]
    Overlap { first: String, second: String },
}

/// The text with a switch for every site, and without its unit tests.
///
/// # Errors
/// A site whose place is not exactly one, or that overlaps another.
pub(crate) fn weave(text: &str, sites: &[Site<'_>]) -> Result<String, WeaveError> {
    let text = text.split_once("\n#[cfg(test)]\nmod tests {").map_or(text, |(code, _)| code);
    let mut places = sites.iter().map(|site| Ok((find(text, site)?, site))).collect::<Result<Vec<_>, _>>()?;
    // The outer before the inner ones, and those of one place together.
    places.sort_by_key(|(span, site)| (span.start, usize::MAX - span.end, site.number));
    let mut woven = String::with_capacity(2 * text.len());
    replace(text, 0..text.len(), &places, &mut woven)?;
    Ok(woven)
}

/// Writes a part of the text with the switches of the places in it.
fn replace(
    text: &str,
    part: Range<usize>,
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
        woven.push('(');
        for (_, Site { number, with, .. }) in chain {
            woven.push_str(&format!("if mutant!({number}) {{ {with} }} else "));
        }
        woven.push_str("{ ");
        replace(text, outer.clone(), inner, woven)?;
        woven.push_str(" })");
        at = outer.end;
        places = behind;
    }
    woven.push_str(slice(text, at..part.end));
    Ok(())
}

/// The one place of a site.
fn find(text: &str, site: &Site<'_>) -> Result<Range<usize>, WeaveError> {
    let missing = |part, looked_for: &str| WeaveError::Missing {
        mutant: site.name.to_owned(),
        part,
        text: looked_for.to_owned(),
    };
    let once = |part, looked_for: &str| {
        let mut all = text.match_indices(looked_for).map(|(at, _)| at);
        match (all.next(), all.next()) {
            (None, _) => Err(missing(part, looked_for)),
            (Some(at), None) => Ok(at),
            (Some(_), Some(_)) => {
                Err(WeaveError::Repeated { mutant: site.name.to_owned(), part, text: looked_for.to_owned() })
            }
        }
    };
    let start = match site.after {
        None => once("code", site.code)?,
        Some(after) => {
            let from = once("after", after)? + after.len();
            let behind = slice(text, from..text.len()).find(site.code);
            from + behind.ok_or_else(|| missing("code", site.code))?
        }
    };
    Ok(start..start + site.code.len())
}

fn slice(text: &str, span: Range<usize>) -> &str {
    text.get(span).unwrap_or_default()
}
