//! Finds the number of tests in what a test program printed.

use std::ops::AddAssign;

/// So many tests passed and failed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Count {
    pub(crate) passed: u64,
    pub(crate) failed: u64,
}

impl Count {
    /// One check, counted as one test.
    pub(crate) fn one(passed: bool) -> Self {
        Self { passed: u64::from(passed), failed: u64::from(!passed) }
    }
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
    }
}

/// Adds up the `test result:` lines of `cargo test`: one for each test program and one
/// for the documentation tests of each crate.
pub(crate) fn cargo(output: &str) -> Count {
    let mut count = Count::default();
    for line in output.lines().filter(|line| line.starts_with("test result: ")) {
        let number = |label| {
            let before = line.split_once(label)?.0.trim_end();
            before.rsplit(' ').next()?.parse().ok()
        };
        count += Count { passed: number("passed;").unwrap_or(0), failed: number("failed;").unwrap_or(0) };
    }
    count
}

/// Reads the closing lines of Python's unittest: `Ran 60 tests in 3.2s`, then
/// `OK (skipped=1)` or `FAILED (failures=1, errors=2)`. What was skipped did not pass.
pub(crate) fn unittest(output: &str) -> Count {
    let ran = output.lines().find_map(|line| {
        let (count, _) = line.strip_prefix("Ran ")?.split_once(" test")?;
        count.parse::<u64>().ok()
    });
    let ending = output.lines().rev().find_map(|line| {
        let line = line.trim_end();
        let told = line.strip_prefix("OK").or_else(|| line.strip_prefix("FAILED"))?;
        match told {
            "" => Some(""),
            told => told.strip_prefix(" (")?.strip_suffix(')'),
        }
    });
    let number = |label| {
        let mut told = ending?.split(", ");
        told.find_map(|told| told.strip_prefix(label)?.parse::<u64>().ok())
    };
    let failed = number("failures=").unwrap_or(0) + number("errors=").unwrap_or(0);
    let skipped = number("skipped=").unwrap_or(0);
    Count { passed: ran.unwrap_or(0).saturating_sub(failed + skipped), failed }
}

/// Adds up the closing lines of `node --test`: `# pass 3` of the TAP reporter,
/// `ℹ pass 3` of the other one.
pub(crate) fn node(output: &str) -> Count {
    let number = |label| {
        output
            .lines()
            .filter_map(|line| line.strip_prefix("# ").or_else(|| line.strip_prefix("ℹ ")))
            .filter_map(|line| line.strip_prefix(label)?.trim().parse::<u64>().ok())
            .sum()
    };
    Count { passed: number("pass "), failed: number("fail ") }
}

/// The closing line of `ncp-verify mutants`: `5 mutants: 3 killed, …; 1 misnamed, 1 survived, 0 not finished`.
pub(crate) fn mutants(output: &str) -> Count {
    let closing = |line: &&str| line.contains(" killed, of which ");
    let Some(line) = output.lines().rev().find(closing) else {
        return Count::default();
    };
    let number = |label| -> u64 {
        let before = line.split_once(label).map_or("", |(before, _)| before);
        before.rsplit(' ').next().and_then(|digits| digits.parse().ok()).unwrap_or(0)
    };
    Count { passed: number(" killed"), failed: number(" misnamed") + number(" survived") + number(" not finished") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mutants_that_were_killed_pass_and_all_others_fail() {
        let output = "✓ a  NCP-VER-001, 2 failing\nb survived: no case\n\
            9 mutants: 3 killed, of which 2 by the rule that the verdict names first; 1 misnamed, 4 survived, 1 not finished\n";
        assert_eq!(mutants(output), Count { passed: 3, failed: 6 });
        assert_eq!(mutants("error: the suite\n"), Count::default());
    }

    #[test]
    fn the_test_programs_of_cargo_are_added_up() {
        let output = "\
running 2 tests
test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.02s

   Doc-tests ncp_spec
test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1.50s
";
        assert_eq!(cargo(output), Count { passed: 15, failed: 2 });
    }

    #[test]
    fn a_test_name_that_looks_like_a_result_is_not_counted() {
        assert_eq!(cargo("test the_test result: ok. 9 passed; ... ok\n"), Count::default());
    }

    #[test]
    fn what_unittest_ran_and_neither_failed_nor_skipped_has_passed() {
        let output = "FAILED (a line of a test)\nRan 30 tests in 8.220s\n\nFAILED (failures=2, errors=1, skipped=1)\n";
        assert_eq!(unittest(output), Count { passed: 26, failed: 3 });
        assert_eq!(unittest("Ran 1 test in 0.000s\n\nOK\n"), Count { passed: 1, failed: 0 });
        assert_eq!(unittest("python3: No module named x\n"), Count::default());
    }

    #[test]
    fn both_reporters_of_node_are_understood() {
        assert_eq!(node("# tests 5\n# pass 4\n# fail 1\n"), Count { passed: 4, failed: 1 });
        assert_eq!(node("ℹ tests 5\nℹ pass 5\nℹ fail 0\n"), Count { passed: 5, failed: 0 });
        assert_eq!(node("ok 1 - # pass 4 looks odd\n"), Count::default());
    }

    #[test]
    fn what_unittest_skips_has_neither_passed_nor_failed() {
        for (output, passed, failed) in [
            ("...\nRan 60 tests in 3.2s\n\nOK\n", 60, 0),
            ("Ran 60 tests in 3.2s\n\nOK (skipped=3)\n", 57, 0),
            ("Ran 1 test in 0.0s\n\nOK (expected failures=1)\n", 1, 0),
            ("Ran 9 tests in 1s\n\nFAILED (failures=1, errors=2, skipped=1)\n", 5, 3),
            ("OK then\n", 0, 0),
        ] {
            assert_eq!(unittest(output), Count { passed, failed }, "{output}");
        }
    }
}
