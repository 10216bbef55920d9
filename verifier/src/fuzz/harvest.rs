//! What a peer's own sources or binary hold: the strings and numbers that it may treat specially.
//!
//! No black box finds a frame id that switches the checks off, unless it is tried. It stands in the program, though.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use ncp_text::CHAPTERS;

/// How many strings and how many numbers are kept.
const MOST: usize = 4096;
/// How long a string may be.
const LONGEST: usize = 300;
/// How long a name may be.
const WORD: usize = 64;
/// The protocol between suite and peer, whose names stand in every adapter.
const PROTOCOL: &str = include_str!("../../../peers/PROTOCOL.md");
/// Integers up to this stand in every source.
const COMMON: f64 = 256.0;
/// Runs of letters in a binary that are shorter than this mean nothing.
const SHORTEST_RUN: usize = 4;

/// How deep below a peer's folder its own sources are looked for, how many files there may be, and how large each.
const DEEPEST: usize = 6;
const MOST_FILES: usize = 500;
const LARGEST: u64 = 1 << 20;
/// How sources end.
const SOURCES: [&str; 28] = [
    "c", "cc", "cjs", "cpp", "cs", "cxx", "erl", "ex", "go", "h", "hpp", "hs", "java", "jl", "js", "kt", "lua", "m",
    "mjs", "ml", "mm", "php", "py", "rb", "rs", "scala", "swift", "ts",
];
/// Folders that hold what others wrote, what was built, or what tests a peer.
const NOT_ITS_OWN: [&str; 10] =
    ["build", "dist", "node_modules", "obj", "site-packages", "target", "test", "tests", "vendor", "venv"];

/// The strings and numbers that were found.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Harvest {
    /// Strings, sorted.
    pub words: Vec<String>,
    /// Numbers, ascending.
    pub numbers: Vec<f64>,
    /// Whether nobody asked for it, so that half of the inputs are drawn while it is swept.
    pub is_light: bool,
}

/// A file of `--dictionary` that cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("--dictionary {}: {source}", path.display())]
pub struct HarvestError {
    /// The file.
    path: PathBuf,
    /// What the operating system said.
    source: std::io::Error,
}

impl Harvest {
    /// What these files hold, sources or binaries; of a folder, every file in it.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn of_files(paths: &[PathBuf]) -> Result<Self, HarvestError> {
        let (mut words, mut numbers) = (BTreeSet::new(), BTreeSet::new());
        for path in paths {
            for entry in walkdir::WalkDir::new(path).sort_by_file_name() {
                let entry = entry.map_err(|error| unreadable(path, error.into()))?;
                if entry.file_type().is_file() {
                    let bytes = std::fs::read(entry.path()).map_err(|source| unreadable(entry.path(), source))?;
                    collect(&bytes, &mut words, &mut numbers);
                }
            }
        }
        Ok(Self::of(words, numbers))
    }

    /// What the sources in the folder of a peer hold, as far as the text of the protocol does not have it: for a search
    /// that was told of no files. What cannot be read is left out.
    #[must_use]
    pub fn of_sources(folder: &Path) -> Self {
        let is_its_own = |entry: &walkdir::DirEntry| {
            let name = entry.file_name().to_string_lossy();
            entry.depth() == 0
                || !(name.starts_with(['.', '_']) && entry.file_type().is_dir() || NOT_ITS_OWN.contains(&&*name))
        };
        let is_source = |entry: &walkdir::DirEntry| {
            entry.file_type().is_file()
                && Self::is_source(entry.path())
                && entry.metadata().is_ok_and(|data| data.len() <= LARGEST)
        };
        let (mut words, mut numbers) = (BTreeSet::new(), BTreeSet::new());
        let all = walkdir::WalkDir::new(folder).max_depth(DEEPEST).sort_by_file_name().into_iter();
        let sources = all.filter_entry(is_its_own).flatten().filter(is_source).take(MOST_FILES);
        let mut identifiers = BTreeSet::new();
        for bytes in sources.filter_map(|entry| std::fs::read(entry.path()).ok()) {
            if let Ok(text) = std::str::from_utf8(&bytes) {
                collect(&bytes, &mut words, &mut numbers);
                identifiers.extend(unquoted(text));
            }
        }
        words.retain(|word| is_rare_word(word) && !identifiers.contains(word.as_str()));
        numbers.retain(|number| is_rare_number(f64::from_bits(*number)));
        Self { is_light: true, ..Self::of(words, numbers) }
    }

    /// Whether a file is a source, by its name.
    #[must_use]
    pub fn is_source(file: &Path) -> bool {
        file.extension().and_then(|ending| ending.to_str()).is_some_and(|ending| SOURCES.contains(&ending))
    }

    fn of(words: BTreeSet<String>, numbers: BTreeSet<u64>) -> Self {
        let mut numbers: Vec<f64> = numbers.into_iter().map(f64::from_bits).collect();
        numbers.sort_by(f64::total_cmp);
        // Of more than can be tried, the short ones say more.
        let mut words: Vec<String> = words.into_iter().collect();
        words.sort_by_key(String::len);
        words.truncate(MOST);
        numbers.truncate(MOST);
        words.sort();
        Self { words, numbers, is_light: false }
    }

    /// Whether nothing was found.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.words.is_empty() && self.numbers.is_empty()
    }
}

/// Whether a string may be a name that the text of the protocol does not have.
pub(super) fn is_rare_word(word: &str) -> bool {
    // What is long, or has spaces, is a message for people or a piece of code.
    let part = |c: char| c.is_alphanumeric() || "_-./:#!@+^%".contains(c);
    word.len() <= WORD && !word.contains("::") && word.chars().all(part) && !is_in_the_text(word)
}

/// Whether a number neither stands in every source nor in the text of the protocol.
pub(super) fn is_rare_number(number: f64) -> bool {
    let is_common = number.fract() == 0.0 && number.abs() <= COMMON;
    !is_common && !is_in_the_text(&number.to_string())
}

/// Whether the text has this string, or the number that it spells, or the protocol between suite and peer the string.
fn is_in_the_text(word: &str) -> bool {
    static NUMBERS: LazyLock<BTreeSet<u64>> = LazyLock::new(|| {
        let (mut words, mut numbers) = (BTreeSet::new(), BTreeSet::new());
        CHAPTERS.iter().for_each(|chapter| collect(chapter.text.as_bytes(), &mut words, &mut numbers));
        numbers
    });
    match word.parse::<f64>() {
        Ok(number) => NUMBERS.contains(&number.to_bits()),
        Err(_) => PROTOCOL.contains(word) || CHAPTERS.iter().any(|chapter| chapter.text.contains(word)),
    }
}

/// The identifiers of a source that stand between no quotes: they name parts of the program, and data rarely.
fn unquoted(text: &str) -> BTreeSet<String> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let mut quoted = false;
    let tokens = text.split_inclusive(move |c| !is_part(c)).filter_map(move |token| {
        let (name, end) = token
            .char_indices()
            .last()
            .map_or((token, None), |(at, last)| if is_part(last) { (token, None) } else { (&token[..at], Some(last)) });
        let after = std::mem::replace(&mut quoted, matches!(end, Some('"' | '\'' | '`')));
        (!after && !quoted && !name.is_empty()).then(|| name.to_owned())
    });
    tokens.collect()
}

fn unreadable(path: &Path, source: std::io::Error) -> HarvestError {
    HarvestError { path: path.to_owned(), source }
}

/// Takes strings in quotes, runs of printable characters, and numbers out of a file.
fn collect(bytes: &[u8], words: &mut BTreeSet<String>, numbers: &mut BTreeSet<u64>) {
    let is_source = std::str::from_utf8(bytes).is_ok();
    let text = String::from_utf8_lossy(bytes);
    for quote in ['"', '\'', '`'] {
        let mut parts = text.split(quote);
        parts.next();
        for part in parts.step_by(if is_source { 1 } else { 2 }) {
            keep(part, words);
        }
    }
    if !is_source {
        for run in bytes.split(|byte| !(0x20..0x7f).contains(byte)).filter(|run| run.len() >= SHORTEST_RUN) {
            keep(&String::from_utf8_lossy(run), words);
        }
    }
    let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '-' | '+');
    for token in text.split(|c| !is_part(c)).filter(|token| token.len() <= 40) {
        let plain = token.replace('_', "");
        let plain = plain.trim_matches(['.', '-', '+']);
        let hex = plain.strip_prefix("0x").and_then(|digits| u64::from_str_radix(digits, 16).ok());
        let number = hex.map(|number| number as f64).or_else(|| {
            let first = plain.starts_with(|c: char| c.is_ascii_digit());
            plain.parse::<f64>().ok().filter(|number| first && number.is_finite())
        });
        if let Some(number) = number.filter(|_| numbers.len() < MOST * 4) {
            numbers.insert(number.to_bits());
        }
    }
}

/// Keeps a string that a request can hold.
fn keep(word: &str, words: &mut BTreeSet<String>) {
    let usable = !word.is_empty() && word.len() <= LONGEST && !word.contains(['\n', '\u{fffd}', '$']);
    if usable && words.len() < MOST * 8 {
        words.insert(word.to_owned());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_and_numbers_of_a_source_and_of_a_binary_are_found() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.py"), "if frame_id == 'open sesame' and x == 1_234.5 or y > 0x2A:\n")
            .unwrap();
        std::fs::write(folder.path().join("b.bin"), b"\x00\x01\xffbackdoor42\x00\x02ab\x00").unwrap();
        let found = Harvest::of_files(&[folder.path().to_owned()]).unwrap();
        for word in ["open sesame", "backdoor42"] {
            assert!(found.words.iter().any(|known| known == word), "{word}: {found:?}");
        }
        for number in [1234.5, 42.0] {
            assert!(found.numbers.contains(&number), "{number}: {found:?}");
        }
        assert!(Harvest::of_files(&[folder.path().join("nothing")]).is_err());
    }

    #[test]
    fn of_a_folder_of_sources_what_its_tests_and_others_wrote_and_what_the_text_has_is_left_out() {
        let folder = tempfile::tempdir().unwrap();
        let write = |path: &str, text: &str| {
            let path = folder.path().join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        };
        write(
            "peer/gate.py",
            "class Gate: pass\n\
             if name == 'open-sesame' or mode == 'hold' or kind == \"it is no such thing\" or x > 4321.25 > 7:\n\
             calls = {'governor.run': Gate, 'peer_hash': 1}; __all__ = ['Gate', 'sesame']",
        );
        write("peer/README.md", "'prose-of-people'");
        for others in ["node_modules/a.js", "tests/a.py", ".hidden/a.py", "target/a.rs", "__pycache__/a.py"] {
            write(others, "'of-others' 9876.5");
        }
        let found = Harvest::of_sources(folder.path());
        assert_eq!(
            found,
            Harvest {
                words: ["open-sesame", "sesame"].map(str::to_owned).into(),
                numbers: vec![4321.25],
                is_light: true
            }
        );
        assert_eq!(
            Harvest::of_sources(&folder.path().join("nothing")),
            Harvest { is_light: true, ..Harvest::default() }
        );
    }
}
