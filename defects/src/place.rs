//! Where an edit applies: exactly one place of its file, however it is formatted.

use std::ops::Range;

use thiserror::Error;

use crate::table::{Defect, Edit};

/// Why an edit does not fit a text.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum PlaceError {
    /// A text is looked for that does not stand there.
    #[error("{defect}: its `{part}` does not stand there: {text}")]
    Missing {
        /// The defect's name.
        defect: String,
        /// `code` or `after`.
        part: &'static str,
        /// What is looked for.
        text: String,
    },
    /// A text is looked for that stands there more than once.
    #[error("{defect}: its `{part}` stands there more than once: {text}")]
    Repeated {
        /// The defect's name.
        defect: String,
        /// `code` or `after`.
        part: &'static str,
        /// What is looked for.
        text: String,
    },
}

/// A source without its unit tests: what a defect is planted in.
#[must_use]
pub fn without_tests(source: &str) -> &str {
    source.split_once("\n#[cfg(test)]\nmod tests {").map_or(source, |(code, _)| code)
}

/// The bytes of `source` that an edit of this defect replaces.
///
/// # Errors
/// The place is not exactly one.
pub fn find(source: &str, defect: &str, edit: &Edit) -> Result<Range<usize>, PlaceError> {
    let dense = Dense::of(source);
    let missing = |part, text: &str| PlaceError::Missing { defect: defect.to_owned(), part, text: text.to_owned() };
    let once = |part, text: &str| {
        let mut places = dense.places(text, 0);
        match (places.next(), places.next()) {
            (None, _) => Err(missing(part, text)),
            (Some(place), None) => Ok(place),
            (Some(_), Some(_)) => Err(PlaceError::Repeated { defect: defect.to_owned(), part, text: text.to_owned() }),
        }
    };
    let place = match &edit.after {
        None => once("code", &edit.code)?,
        Some(after) => {
            let behind = once("after", after)?.end;
            dense.places(&edit.code, behind).next().ok_or_else(|| missing("code", &edit.code))?
        }
    };
    Ok(dense.bytes(&place))
}

/// The text of a file with all edits of a defect in it that are about this file.
///
/// # Errors
/// An edit whose place is not exactly one.
pub fn plant(source: &str, file: &str, defect: &Defect) -> Result<String, PlaceError> {
    let mut planted = source.to_owned();
    for edit in defect.edit.iter().filter(|edit| edit.file == file) {
        let place = find(&planted, &defect.name, edit)?;
        planted.replace_range(place, &edit.with);
    }
    Ok(planted)
}

/// Where the character at `offset` of a text stands in the source, in bytes: once for every place of the text, however
/// the source is formatted.
#[must_use]
pub fn places_of(source: &str, text: &str, offset: usize) -> Vec<usize> {
    let dense = Dense::of(source);
    let before = Dense::of(text.get(..offset).unwrap_or_default()).text.len();
    dense.places(text, 0).filter_map(|place| dense.at.get(place.start + before).copied()).collect()
}

/// A text without its white space and trailing commas, and where each byte of it stood.
struct Dense {
    text: String,
    /// For each byte of `text`, its place in the source.
    at: Vec<usize>,
}

impl Dense {
    fn of(source: &str) -> Self {
        let mut dense = Self { text: String::with_capacity(source.len()), at: Vec::with_capacity(source.len()) };
        for (start, c) in source.char_indices().filter(|(_, c)| !c.is_whitespace()) {
            if matches!(c, ')' | ']' | '}') && dense.text.ends_with(',') {
                dense.text.pop();
                dense.at.pop();
            }
            dense.text.push(c);
            dense.at.extend(start..start + c.len_utf8());
        }
        dense
    }

    /// Where a text stands, from `start` on, in bytes of the dense text.
    fn places(&self, text: &str, start: usize) -> impl Iterator<Item = Range<usize>> + use<'_> {
        let wanted = Self::of(text).text;
        let (length, behind) = (wanted.len(), self.text.get(start..).unwrap_or_default());
        let places: Vec<usize> = behind.match_indices(&wanted).map(|(at, _)| start + at).collect();
        places.into_iter().map(move |at| at..at + length)
    }

    /// The same place in bytes of the source.
    fn bytes(&self, place: &Range<usize>) -> Range<usize> {
        let at = |index: usize| self.at.get(index).copied().unwrap_or_default();
        if place.is_empty() { 0..0 } else { at(place.start)..at(place.end - 1) + 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edit(after: Option<&str>, code: &str, with: &str) -> Edit {
        let (after, code, with) = (after.map(str::to_owned), code.to_owned(), with.to_owned());
        Edit { file: "a.rs".to_owned(), after, code, with, always: false }
    }

    fn planted(source: &str, edits: Vec<Edit>) -> Result<String, PlaceError> {
        let defect = Defect { name: "it".to_owned(), edit: edits, ..Defect::default() };
        plant(source, "a.rs", &defect)
    }

    #[test]
    fn white_space_and_trailing_commas_do_not_count_where_a_place_is_looked_for() {
        let source = "if a\n    < b {\n    c(é, d,)\n}";
        assert_eq!(planted(source, vec![edit(None, "a < b", "a <= b")]).unwrap(), "if a <= b {\n    c(é, d,)\n}");
        assert_eq!(planted(source, vec![edit(None, "c( é,\n d )", "e")]).unwrap(), "if a\n    < b {\n    e\n}");
    }

    #[test]
    fn a_character_is_found_in_every_place_of_its_text() {
        assert_eq!(places_of("a <\n b; a < b", "a < b", 2), [2, 10]);
        assert!(places_of("a > b", "a < b", 2).is_empty());
    }

    #[test]
    fn all_edits_of_a_file_are_made_and_those_of_others_are_not() {
        let other = Edit { file: "b.rs".to_owned(), ..edit(None, "nowhere", "") };
        let edits = vec![edit(None, "one", "1"), edit(Some("three"), "two", "2"), other];
        assert_eq!(planted("one two three two", edits).unwrap(), "1 two three 2");
    }

    #[test]
    fn a_place_that_is_not_exactly_one_is_refused() {
        assert!(matches!(planted("a b", vec![edit(None, "c", "")]), Err(PlaceError::Missing { part: "code", .. })));
        assert!(matches!(planted("a a", vec![edit(None, "a", "")]), Err(PlaceError::Repeated { part: "code", .. })));
        assert!(matches!(
            planted("x x a", vec![edit(Some("x"), "a", "")]),
            Err(PlaceError::Repeated { part: "after", .. })
        ));
    }
}
