//! The files that are made from others: the JSON Schemas from the contract, the vector
//! files from the executable specification, the manifest from the vector files.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use crate::Error;
use crate::project::Project;

/// Writes the generated files that are not there as they should be, and says which.
///
/// # Errors
/// What cannot be generated, read or written.
pub(crate) fn write(project: &Project) -> Result<bool, Error> {
    let files = generate()?;
    let stale = stale(project, &files)?;
    for Stale { path, what } in &stale {
        let target = project.path(path);
        let written = match files.get(path) {
            Some(text) => target
                .parent()
                .map_or(Ok(()), fs::create_dir_all)
                .and_then(|()| fs::write(&target, text)),
            None => fs::remove_file(&target),
        };
        written.map_err(|source| Error::File {
            path: target,
            source,
        })?;
        let done = match what {
            Difference::Missing => "new",
            Difference::Orphan => "removed",
            Difference::Line { .. } => "changed",
        };
        println!("{done:8} {path}");
    }
    println!("{} generated files, {} written", files.len(), stale.len());
    Ok(true)
}

/// Says which generated files are not as they should be; `false` if there are any.
///
/// # Errors
/// What cannot be generated or read.
pub(crate) fn report_stale(project: &Project) -> Result<bool, Error> {
    let files = generate()?;
    let stale = stale(project, &files)?;
    for file in &stale {
        println!("{file}");
    }
    println!("{} generated files, {} stale", files.len(), stale.len());
    Ok(stale.is_empty())
}

/// A generated file that is not as it should be.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Stale {
    path: String,
    what: Difference,
}

#[derive(Debug, PartialEq, Eq)]
enum Difference {
    /// It is not there.
    Missing,
    /// It is there, but nothing generates it.
    Orphan,
    /// The first line that differs, counted from 1; `None` is past the end of the text.
    Line {
        number: usize,
        is: Option<String>,
        should_be: Option<String>,
    },
}

impl fmt::Display for Stale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = &self.path;
        match &self.what {
            Difference::Missing => write!(f, "{path}: is missing"),
            Difference::Orphan => write!(f, "{path}: is not a generated file"),
            Difference::Line {
                number,
                is,
                should_be,
            } => {
                let show = |line: &Option<String>| line.clone().unwrap_or("(end of file)".into());
                writeln!(f, "{path}:{number}: is not what would be generated")?;
                writeln!(f, "  is:        {}", show(is))?;
                write!(f, "  should be: {}", show(should_be))
            }
        }
    }
}

/// The generated files of one folder that are not as they should be.
///
/// # Errors
/// What cannot be generated or read.
pub(crate) fn check(project: &Project, folder: &str) -> Result<Vec<Stale>, Error> {
    let mut files = generate()?;
    files.retain(|path, _| path.starts_with(folder));
    let mut stale = stale(project, &files)?;
    stale.retain(|file| file.path.starts_with(folder));
    Ok(stale)
}

/// All generated files: their text by their path within the project.
type Files = BTreeMap<String, String>;

fn generate() -> Result<Files, Error> {
    let schemas = ncp_proto::schema::generate();
    let vectors = ncp_vectors::generate();
    if schemas.is_empty() {
        return Err(Error::Generate("proto/projection.json cannot be read"));
    }
    let mut files = Files::new();
    for (name, text) in schemas {
        files.insert(format!("{SCHEMAS}{name}"), text);
    }
    files.insert(MANIFEST.to_owned(), ncp_vectors::manifest(&vectors));
    for (path, text) in vectors {
        files.insert(format!("{VECTORS}{path}"), text);
    }
    Ok(files)
}

const SCHEMAS: &str = "schemas/";
const VECTORS: &str = "vectors/";
const MANIFEST: &str = "vectors/MANIFEST.sha256";

fn stale(project: &Project, files: &Files) -> Result<Vec<Stale>, Error> {
    let mut stale = Vec::new();
    for (path, should_be) in files {
        let what = match fs::read_to_string(project.path(path)) {
            Ok(is) if is == *should_be => continue,
            Ok(is) => first_difference(&is, should_be),
            Err(error) if error.kind() == ErrorKind::NotFound => Difference::Missing,
            Err(source) => {
                return Err(Error::File {
                    path: project.path(path),
                    source,
                });
            }
        };
        stale.push(Stale {
            path: path.clone(),
            what,
        });
    }
    // A vector file that nothing generates would be run, but never be checked.
    let mut areas: Vec<_> = files
        .keys()
        .filter_map(|path| path.strip_prefix(VECTORS)?.split_once('/'))
        .map(|(area, _)| format!("{VECTORS}{area}"))
        .collect();
    areas.dedup();
    for area in areas {
        for path in json_files(project, &area)? {
            if !files.contains_key(&path) {
                stale.push(Stale {
                    path,
                    what: Difference::Orphan,
                });
            }
        }
    }
    Ok(stale)
}

fn first_difference(is: &str, should_be: &str) -> Difference {
    // A line is enough to find the place; a vector's line can be long.
    const SHOWN: usize = 160;
    let shorten = |line: Option<&str>| line.map(|line| line.chars().take(SHOWN).collect());
    let (mut is, mut should_be) = (is.split('\n'), should_be.split('\n'));
    let mut number = 0;
    loop {
        number += 1;
        let (left, right) = (is.next(), should_be.next());
        if left != right || left.is_none() {
            return Difference::Line {
                number,
                is: shorten(left),
                should_be: shorten(right),
            };
        }
    }
}

/// The JSON files of a folder, by their paths within the project.
fn json_files(project: &Project, folder: &str) -> Result<Vec<String>, Error> {
    let path = project.path(folder);
    let entries = match fs::read_dir(&path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.and_then(|entries| entries.collect::<Result<Vec<_>, _>>()),
    };
    let entries = entries.map_err(|source| Error::File { path, source })?;
    let names = entries
        .iter()
        .filter_map(|entry| entry.file_name().into_string().ok());
    let mut files: Vec<_> = names
        .filter(|name| {
            Path::new(name)
                .extension()
                .is_some_and(|extension| extension == "json")
        })
        .map(|name| format!("{folder}/{name}"))
        .collect();
    files.sort();
    Ok(files)
}
