//! Solvers as programs, and the reader of what they print.
//!
//! An answer is one of the lines `sat`, `unsat` and `unknown`, letter for letter. Anything else that a solver
//! prints where an answer is due, on whichever stream, is an error.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use sha2::{Digest, Sha256};
use thiserror::Error;

use crate::engines::outcome::Patience;

/// The programs of the virtual environment.
#[derive(Debug)]
pub struct Solvers {
    /// The folder of its programs.
    pub bin: PathBuf,
    /// The script that decides a file with bitwuzla.
    pub script: PathBuf,
    /// When it is ended, so is a solver at work.
    pub patience: Patience,
    /// How far they go with a question.
    pub limits: Limits,
    /// A folder of questions that were answered before; where there is none, everything is asked.
    pub known: Option<PathBuf>,
}

/// How far a solver goes with one question, in its own steps: the same in every run, whatever else the machine does.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// bitwuzla, where a proof depends on the answer.
    pub proof: u64,
    /// bitwuzla, in search of a counterexample: all questions of a file together.
    pub search: u64,
    /// z3.
    pub cross: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { proof: 1_000_000, search: 6_000, cross: 5_000 }
    }
}

/// What a solver says of one `check-sat`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Answer {
    /// The obligation holds.
    Unsat,
    /// There is a counterexample.
    Sat,
    /// The solver gave up.
    Unknown,
}

/// Why there are no answers.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SolverError {
    /// The program could not be run.
    #[error("cannot run {program}: {why}")]
    Start {
        /// Which.
        program: String,
        /// The system's words.
        why: String,
    },
    /// It ended with an error, or printed one.
    #[error("the solver failed: {0}")]
    Failed(String),
    /// A line that is no answer.
    #[error("no answer, but {0:?}")]
    NoAnswer(String),
    /// Not as many answers as questions.
    #[error("{found} answers to {wanted} questions")]
    Count {
        /// Answers.
        found: usize,
        /// Questions.
        wanted: usize,
    },
}

/// Reads answers, one a line and nothing else, as many as there are questions.
///
/// # Errors
/// Anything but that.
pub fn read_answers(printed: &str, wanted: usize) -> Result<Vec<Answer>, SolverError> {
    let answers = printed.split_terminator('\n').map(read_answer).collect::<Result<Vec<_>, _>>()?;
    if answers.len() == wanted { Ok(answers) } else { Err(SolverError::Count { found: answers.len(), wanted }) }
}

fn read_answer(line: &str) -> Result<Answer, SolverError> {
    match line {
        "unsat" => Ok(Answer::Unsat),
        "sat" => Ok(Answer::Sat),
        "unknown" => Ok(Answer::Unknown),
        other => Err(SolverError::NoAnswer(other.to_owned())),
    }
}

/// Prints the versions of the packages.
const VERSIONS: &str = "from importlib.metadata import version as v; print('bitwuzla', v('bitwuzla') + ', \
    cross-checked by z3', v('z3-solver'))";

impl Solvers {
    /// The solvers with their versions, as they are installed.
    ///
    /// # Errors
    /// They are not installed.
    pub fn versions(&self) -> Result<String, SolverError> {
        let python = Command::new(self.bin.join("python")).args(["-c", VERSIONS]).output();
        let output =
            python.map_err(|error| SolverError::Start { program: "python".to_owned(), why: error.to_string() })?;
        let printed = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        if !output.status.success() || printed.is_empty() {
            let errors = String::from_utf8_lossy(&output.stderr).into_owned();
            return Err(SolverError::Failed(errors));
        }
        Ok(printed)
    }

    /// The answers of bitwuzla, each within so many steps.
    ///
    /// # Errors
    /// It could not be run, failed, or printed something else than answers.
    pub fn bitwuzla(&self, file: &Path, wanted: usize, steps: u64) -> Result<Vec<Answer>, SolverError> {
        let known = self.known_file(file);
        if let Some(known) = known.as_ref().and_then(|known| fs::read_to_string(known).ok()) {
            return read_answers(&known, wanted);
        }
        let printed = self.bitwuzla_prints(file, steps, None)?;
        let answers = read_answers(&printed, wanted)?;
        if let Some(known) = known.filter(|_| !answers.contains(&Answer::Unknown)) {
            // What is not noted is asked again.
            fs::write(known, printed).ok();
        }
        Ok(answers)
    }

    /// Where the answers to the questions of this file are noted: under the digest of its text.
    fn known_file(&self, file: &Path) -> Option<PathBuf> {
        let folder = self.known.as_ref()?;
        fs::create_dir_all(folder).ok()?;
        let digest: [u8; 32] = Sha256::digest(fs::read(file).ok()?).into();
        let name: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        Some(folder.join(name))
    }

    /// All that bitwuzla prints: within so many steps for each question, and so many for the whole file.
    ///
    /// # Errors
    /// It could not be run, or failed.
    pub fn bitwuzla_prints(&self, file: &Path, steps: u64, whole: Option<u64>) -> Result<String, SolverError> {
        let mut python = Command::new(self.bin.join("python"));
        python.arg(&self.script).arg(file).arg(steps.to_string()).args(whole.map(|whole| whole.to_string()));
        self.printed(python)
    }

    /// What z3 answers, each within so many of its steps; what it does not decide is `None`.
    ///
    /// # Errors
    /// It could not be run, failed, or printed something else than answers.
    pub fn z3(&self, file: &Path, wanted: usize, steps: u64) -> Result<Vec<Option<Answer>>, SolverError> {
        let mut z3 = Command::new(self.bin.join("z3"));
        z3.arg(format!("rlimit={steps}")).arg(file);
        let answers = read_answers(&self.printed(z3)?, wanted)?;
        Ok(answers.into_iter().map(|answer| (answer != Answer::Unknown).then_some(answer)).collect())
    }
}

/// How often a solver at work is looked after.
const LOOK: Duration = Duration::from_millis(5);

impl Solvers {
    /// All that a program prints; it is ended when there is no more patience.
    fn printed(&self, mut command: Command) -> Result<String, SolverError> {
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let failed = |error: std::io::Error| SolverError::Failed(error.to_string());
        let mut child = command.spawn().map_err(|error| SolverError::Start {
            program: command.get_program().to_string_lossy().into_owned(),
            why: error.to_string(),
        })?;
        let (output, errors) = (child.stdout.take(), child.stderr.take());
        let (status, output, errors) = thread::scope(|scope| {
            let output = scope.spawn(|| read_all(output));
            let errors = scope.spawn(|| read_all(errors));
            let status = loop {
                match child.try_wait() {
                    Ok(None) => {}
                    ended => break ended,
                }
                if self.patience.left().is_err() {
                    child.kill().ok();
                }
                thread::sleep(LOOK);
            };
            let text = |reader: thread::ScopedJoinHandle<'_, _>| reader.join().unwrap_or_default();
            (status, text(output), text(errors))
        });
        let status = status.map_err(failed)?;
        if !status.is_some_and(|status| status.success()) || !errors.is_empty() {
            let status = status.map(|status| status.to_string()).unwrap_or_default();
            return Err(SolverError::Failed(format!("{status} {errors}")));
        }
        Ok(output)
    }
}

fn read_all(stream: Option<impl Read>) -> String {
    let mut bytes = Vec::new();
    if let Some(mut stream) = stream {
        stream.read_to_end(&mut bytes).ok();
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Reads `(get-value …)`: pairs of a variable and a value. A double is `(fp #b0 #b… #b…)` or a named one,
/// a seq is `#b…`.
#[must_use]
pub fn read_values(printed: &str) -> Vec<(String, u64)> {
    let spaced = printed.replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut values = Vec::new();
    let bits = |word: &str| u64::from_str_radix(word.strip_prefix("#b")?, 2).ok();
    for (at, word) in words.iter().enumerate() {
        let is_name =
            word.starts_with(['x', 'q']) && word.len() > 1 && word.chars().skip(1).all(|c| c.is_ascii_digit());
        if !is_name {
            continue;
        }
        let rest = words.get(at + 1..).unwrap_or_default();
        let value = match rest {
            ["(", "fp", sign, exponent, fraction, ..] => match (bits(sign), bits(exponent), bits(fraction)) {
                (Some(s), Some(e), Some(f)) => Some(s << 63 | e << 52 | f),
                _ => None,
            },
            ["(", "_", "NaN", ..] => Some(f64::NAN.to_bits()),
            ["(", "_", "+oo", ..] => Some(f64::INFINITY.to_bits()),
            ["(", "_", "-oo", ..] => Some(f64::NEG_INFINITY.to_bits()),
            ["(", "_", "+zero", ..] => Some(0),
            ["(", "_", "-zero", ..] => Some((-0.0_f64).to_bits()),
            [value, ..] => bits(value),
            [] => None,
        };
        if let Some(value) = value {
            values.push(((*word).to_owned(), value));
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_literal_word_is_an_answer() {
        assert_eq!(read_answers("unsat\nsat\nunknown\n", 3), Ok(vec![Answer::Unsat, Answer::Sat, Answer::Unknown]));
        for wrong in [
            "UNSAT",
            "Unsat",
            " unsat",
            "unsat ",
            "unsat\r",
            "(error \"line 3: expected unsat\")",
            "unsat unsat",
            "unsatisfiable",
            "success",
            "timeout",
            "",
        ] {
            assert_eq!(read_answers(&format!("{wrong}\n"), 1), Err(SolverError::NoAnswer(wrong.to_owned())));
        }
    }

    #[test]
    fn as_many_answers_as_questions_or_none() {
        for (printed, found, wanted) in [("unsat\n", 1, 2), ("unsat\nunsat\n", 2, 1), ("", 0, 1)] {
            assert_eq!(read_answers(printed, wanted), Err(SolverError::Count { found, wanted }));
        }
    }

    #[test]
    fn values_are_read_to_the_bit() {
        let printed = "sat\n((x0 (fp #b1 #b01111111111 #b0000000000000000000000000000000000000000000000000001))\n \
            (x2 (_ NaN 11 53)) (x3 (_ -zero 11 53)) (q0 #b11))\n";
        let values = read_values(printed);
        assert_eq!(values.len(), 4);
        assert_eq!(values[0].1, (-1.000_000_000_000_000_2_f64).to_bits());
        assert!(f64::from_bits(values[1].1).is_nan());
        assert_eq!(values[2].1, (-0.0_f64).to_bits());
        assert_eq!(values[3], ("q0".to_owned(), 3));
    }
}
