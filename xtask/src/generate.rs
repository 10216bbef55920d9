//! The files that are made from others: the projection and the JSON Schemas from the proto and the tables of the text,
//! the vector files from the scenarios and the text, the manifest from the vector files, the C header from the code
//! that it describes.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use crate::Error;
use xtask::project::Project;

/// Writes the generated files that are not there as they should be, and says which.
///
/// # Errors
/// What cannot be generated, read or written.
pub(crate) fn write(project: &Project) -> Result<bool, Error> {
    let files = generate(project)?;
    let stale = stale(project, &files)?;
    for Stale { path, what } in &stale {
        let target = project.path(path);
        let written = match files.get(path) {
            Some(text) => target.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&target, text)),
            None => fs::remove_file(&target),
        };
        written.map_err(|source| Error::File { path: target, source })?;
        let done = match what {
            Difference::Missing => "new",
            Difference::Orphan => "removed",
            Difference::Text { .. } => "changed",
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
    let files = generate(project)?;
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
    /// Its text is another.
    Text {
        /// The line of the first character that differs, counted from 1.
        line: usize,
        /// In a vector file, the case in which it stands.
        case: Option<String>,
        /// What stands there.
        is: String,
        /// What would be generated there.
        should_be: String,
    },
}

impl fmt::Display for Stale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = &self.path;
        match &self.what {
            Difference::Missing => write!(f, "{path}: is missing"),
            Difference::Orphan => write!(f, "{path}: is not a generated file"),
            Difference::Text { line, case, is, should_be } => {
                let case = case.as_ref().map(|case| format!(" (case {case})")).unwrap_or_default();
                writeln!(f, "{path}:{line}: is not what would be generated{case}")?;
                writeln!(f, "  is:        {is}")?;
                write!(f, "  should be: {should_be}")
            }
        }
    }
}

/// The generated files of one folder that are not as they should be.
///
/// # Errors
/// What cannot be generated or read.
pub(crate) fn check(project: &Project, folder: &str) -> Result<Vec<Stale>, Error> {
    let mut files = generate(project)?;
    files.retain(|path, _| path.starts_with(folder));
    let mut stale = stale(project, &files)?;
    stale.retain(|file| file.path.starts_with(folder));
    Ok(stale)
}

/// All generated files: their text by their path within the project.
type Files = BTreeMap<String, String>;

fn generate(project: &Project) -> Result<Files, Error> {
    let schemas = ncp_proto::schema::generate();
    let vectors = ncp_vectors::generate()?;
    if schemas.is_empty() {
        return Err(Error::Generate("the projection cannot be read"));
    }
    let mut files = Files::new();
    files.insert(PROJECTION.to_owned(), ncp_proto::PROJECTION_TEXT.clone());
    files.insert(HEADER.to_owned(), header(project)?);
    for (name, text) in schemas {
        files.insert(format!("{SCHEMAS}{name}"), text);
    }
    files.insert(MANIFEST.to_owned(), ncp_vectors::manifest(&vectors));
    for (path, text) in vectors {
        files.insert(format!("{VECTORS}{path}"), text);
    }
    Ok(files)
}

/// The C header of the crate in `peers/cpp`, as its `cbindgen.toml` wants it.
fn header(project: &Project) -> Result<String, Error> {
    let folder = project.path("peers/cpp");
    let failed = |error: &dyn fmt::Display| Error::Header(error.to_string());
    let config = cbindgen::Config::from_file(folder.join("cbindgen.toml"));
    let config = config.map_err(|error| failed(&error))?;
    // In the order in which a reader meets them.
    let sources = ["seed", "abi", "wire", "bulk", "safety", "control", "session"];
    let builder = cbindgen::Builder::new().with_config(config);
    let builder = sources.iter().fold(builder, |builder, name| builder.with_src(folder.join(format!("src/{name}.rs"))));
    let bindings = builder.generate().map_err(|error| failed(&error))?;
    let mut text = Vec::new();
    bindings.write(&mut text);
    let text = String::from_utf8(text).map_err(|error| failed(&error))?;
    // What Rust calls the safety of a function, C calls its use.
    Ok(text.replace("const char * ", "const char *").replace("//\n// # Safety\n", ""))
}

const HEADER: &str = "peers/cpp/include/ncp.h";
const PROJECTION: &str = "proto/projection.json";
const SCHEMAS: &str = "schemas/";
const VECTORS: &str = "vectors/corpus/";
const MANIFEST: &str = "vectors/MANIFEST.sha256";

fn stale(project: &Project, files: &Files) -> Result<Vec<Stale>, Error> {
    let mut stale = Vec::new();
    for (path, should_be) in files {
        let what = match fs::read_to_string(project.path(path)) {
            Ok(is) if is == *should_be => continue,
            Ok(is) => first_difference(&is, should_be),
            Err(error) if error.kind() == ErrorKind::NotFound => Difference::Missing,
            Err(source) => {
                return Err(Error::File { path: project.path(path), source });
            }
        };
        stale.push(Stale { path: path.clone(), what });
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
                stale.push(Stale { path, what: Difference::Orphan });
            }
        }
    }
    Ok(stale)
}

/// Finds the first character that differs. The two texts differ.
fn first_difference(is: &str, should_be: &str) -> Difference {
    let pairs = is.chars().zip(should_be.chars());
    let equal = pairs.take_while(|(left, right)| left == right);
    let same: String = equal.map(|(left, _)| left).collect();
    let (line_start, column) = match same.rfind('\n') {
        Some(at) => (at + 1, same[at + 1..].chars().count()),
        None => (0, same.chars().count()),
    };
    let case = same.rfind(ID).map(|at| &same[at + ID.len()..]);
    Difference::Text {
        line: 1 + same.matches('\n').count(),
        case: case.and_then(|rest| rest.split('"').next()).map(str::to_owned),
        is: around(&is[line_start..], column),
        should_be: around(&should_be[line_start..], column),
    }
}

/// How a case begins in a vector file.
const ID: &str = r#""id": ""#;

/// What stands around a column of the first line, which can be long.
fn around(text: &str, column: usize) -> String {
    const REACH: usize = 45;
    let line = text.split('\n').next().unwrap_or_default();
    let start = column.saturating_sub(REACH);
    let shown: String = line.chars().skip(start).take(column - start + REACH).collect();
    let more = line.chars().count() > column + REACH;
    format!("{}{shown}{}", if start > 0 { "…" } else { "" }, if more { "…" } else { "" })
}

/// The JSON files of a folder, by their paths within the project.
fn json_files(project: &Project, folder: &str) -> Result<Vec<String>, Error> {
    let path = project.path(folder);
    let entries = match fs::read_dir(&path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.and_then(|entries| entries.collect::<Result<Vec<_>, _>>()),
    };
    let entries = entries.map_err(|source| Error::File { path, source })?;
    let names = entries.iter().filter_map(|entry| entry.file_name().into_string().ok());
    let mut files: Vec<_> = names
        .filter(|name| Path::new(name).extension().is_some_and(|extension| extension == "json"))
        .map(|name| format!("{folder}/{name}"))
        .collect();
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A project of one generated file, and of what lies in its folders.
    fn stale_of(generated: &[(&str, &str)], there: &[(&str, &str)]) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        for (path, text) in there {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        let files = generated.iter().map(|(path, text)| (path.to_string(), text.to_string()));
        let stale = stale(&Project::at(folder.path()), &files.collect()).unwrap();
        stale.iter().map(Stale::to_string).collect()
    }

    #[test]
    fn files_that_are_as_generated_are_not_stale() {
        let files = [("schemas/a.json", "{}\n"), ("vectors/corpus/wire/b.json", "[]\n")];
        assert_eq!(stale_of(&files, &files), [""; 0]);
    }

    #[test]
    fn a_missing_file_and_one_that_nothing_generates_are_named() {
        let there = [("vectors/corpus/wire/extra.json", "{}"), ("vectors/corpus.json", "not an area")];
        assert_eq!(
            stale_of(&[("vectors/corpus/wire/b.json", "")], &there),
            ["vectors/corpus/wire/b.json: is missing", "vectors/corpus/wire/extra.json: is not a generated file"]
        );
    }

    #[test]
    fn one_changed_character_is_shown_with_its_line_and_case() {
        let text = |expect: &str| {
            let long = "x".repeat(500);
            format!(
                "{{\n\"cases\": [{{ \"id\": \"wire/a\", \"why\": \"{long}\" }},\
                 {{ \"id\": \"wire/b\", \"expect\": \"{expect}\", \"why\": \"{long}\" }}]\n}}\n"
            )
        };
        let shown = stale_of(
            &[("vectors/corpus/wire/c.json", &text("type"))],
            &[("vectors/corpus/wire/c.json", &text("tÿpe"))],
        );
        insta::assert_snapshot!(shown.join("\n"), @r#"
        vectors/corpus/wire/c.json:2: is not what would be generated (case wire/b)
          is:        …xxxxxxxxxxx" },{ "id": "wire/b", "expect": "tÿpe", "why": "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx…
          should be: …xxxxxxxxxxx" },{ "id": "wire/b", "expect": "type", "why": "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx…
        "#);
    }

    #[test]
    fn a_file_that_is_cut_short_or_goes_on_is_stale() {
        for (is, should_be) in [("a\nb", "a\nb\n"), ("a\nb\nc", "a\nb"), ("", "é"), ("é", ""), ("é", "è")] {
            let stale = stale_of(&[("schemas/a.json", should_be)], &[("schemas/a.json", is)]);
            assert_eq!(stale.len(), 1, "{is:?} {should_be:?}");
        }
    }
}
