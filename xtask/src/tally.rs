//! Counts tests, and reads them from the JUnit file that a test program leaves.

use std::ops::AddAssign;
use std::time::Duration;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use thiserror::Error;

/// What became of the tests of a check.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Tally {
    pub(crate) passed: u64,
    pub(crate) failed: u64,
    /// How long each test took, by its name.
    pub(crate) times: Vec<(String, Duration)>,
}

impl Tally {
    /// One test.
    pub(crate) fn one(passed: bool) -> Self {
        Self { passed: u64::from(passed), failed: u64::from(!passed), times: Vec::new() }
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.times.extend(other.times);
    }
}

/// A file that is no JUnit file.
#[derive(Debug, Error)]
pub(crate) enum JunitError {
    #[error("no XML: {0}")]
    Xml(#[from] quick_xml::Error),
    #[error("no XML: {0}")]
    Attribute(#[from] quick_xml::events::attributes::AttrError),
    #[error("it is cut short")]
    CutShort,
}

/// The test cases of a JUnit file. One with a `failure` or an `error` has failed; one that is `skipped` has neither
/// passed nor failed.
///
/// # Errors
/// The text is no XML, or not all of it.
pub(crate) fn junit(text: &str) -> Result<Tally, JunitError> {
    #[derive(PartialEq)]
    enum Outcome {
        Passed,
        Failed,
        Skipped,
    }
    let mut tally = Tally::default();
    let mut outcome = Outcome::Passed;
    let mut depth = 0_usize;
    let mut reader = Reader::from_str(text);
    reader.config_mut().expand_empty_elements = true;
    loop {
        let event = reader.read_event()?;
        match &event {
            Event::Start(_) => depth += 1,
            Event::End(_) => depth -= 1,
            _ => {}
        }
        match event {
            Event::Start(element) => match element.name().as_ref() {
                b"testcase" => {
                    outcome = Outcome::Passed;
                    tally.times.push(name_and_time(&element)?);
                }
                b"failure" | b"error" => outcome = Outcome::Failed,
                b"skipped" if outcome == Outcome::Passed => outcome = Outcome::Skipped,
                _ => {}
            },
            Event::End(element) if element.name().as_ref() == b"testcase" => {
                tally.passed += u64::from(outcome == Outcome::Passed);
                tally.failed += u64::from(outcome == Outcome::Failed);
            }
            Event::Eof if depth == 0 => return Ok(tally),
            Event::Eof => return Err(JunitError::CutShort),
            _ => {}
        }
    }
}

/// The attributes `name` and `time` (in seconds) of a test case.
fn name_and_time(element: &BytesStart<'_>) -> Result<(String, Duration), JunitError> {
    let text = |attribute: &str| -> Result<String, JunitError> {
        let Some(found) = element.try_get_attribute(attribute)? else { return Ok(String::new()) };
        Ok(found.normalized_value(XmlVersion::Implicit1_0)?.into_owned())
    };
    let seconds = text("time")?.parse().unwrap_or_default();
    Ok((text("name")?, Duration::try_from_secs_f64(seconds).unwrap_or_default()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(text: &str) -> (u64, u64) {
        let tally = junit(text).unwrap();
        (tally.passed, tally.failed)
    }

    #[test]
    fn test_cases_are_counted_wherever_they_stand() {
        let text = r#"<?xml version="1.0" encoding="utf-8"?>
            <testsuites>
                <testcase name="a" time="0.5" classname="test"/>
                <testsuite name="s" tests="2" failures="1">
                    <testcase name="b &gt; c" time="2.25">
                        <failure message="&lt;testcase/&gt;">1 != 2</failure>
                    </testcase>
                    <testcase name="d"><error/></testcase>
                    <testcase name="e"><skipped message="no numpy"/></testcase>
                </testsuite>
            </testsuites>"#;
        let tally = junit(text).unwrap();
        assert_eq!((tally.passed, tally.failed), (1, 2));
        assert_eq!(tally.times[1], ("b > c".to_owned(), Duration::from_millis(2250)));
        assert_eq!(tally.times[2].1, Duration::ZERO);
    }

    #[test]
    fn what_a_test_printed_is_no_test() {
        let text =
            r"<testsuite><testcase name='a'><system-out><![CDATA[<failure/>]]></system-out></testcase></testsuite>";
        assert_eq!(counts(text), (1, 0));
        assert_eq!(counts("<testsuites></testsuites>"), (0, 0));
    }

    #[test]
    fn a_file_that_is_cut_short_is_refused() {
        assert!(junit("<testsuites><testcase name='a'").is_err());
        assert!(junit("<testsuites><testcase name='a'/>").is_err());
        assert!(junit("<testsuites><testcase name='a'></testsuite>").is_err());
    }
}
