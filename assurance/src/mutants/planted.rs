//! What is copied to make mutants: the Rust peer and all of the project that it depends on, with a switch at every
//! place that a defect changes.
//!
//! The copy is a workspace of its own in a folder that git ignores. One build of it holds every defect;
//! `ncp-peer-rust --defect NAME …` switches some of them on. The sources themselves stay as they are.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use ncp_defects::Defect;
use ncp_verifier::peer::Launch;
use toml::{Table, Value};
use xtask::project::Project;

use crate::planted::{Copy, PlantedError};

/// Where the copy stands, from the root of the project.
const COPY: &str = ".tools/planted";
/// The package that is copied.
const PEER: &str = "peers/rust";
/// The package that every other one can reach, and that holds the switches.
const KERNEL: &str = "ncp-kernel";
/// The path of the switch.
const SWITCH: &str = "::ncp_kernel::planted::is";
/// What a package has for its tests only.
const FOR_TESTS: [&str; 3] = ["benches", "examples", "tests"];

/// A copy that is ready to be built.
#[derive(Debug)]
pub(crate) struct Planted {
    folder: PathBuf,
    package: String,
}

/// Brings the copy up to date. A file that stays as it was is left alone, so that cargo builds little anew.
pub(crate) fn weave(project: &Project, defects: &[Defect]) -> Result<Planted, PlantedError> {
    let root = project.path("");
    let folder = project.path(COPY);
    let mut workspace = manifest(&root.join("Cargo.toml"))?;
    let packages = packages(&root, &workspace)?;
    let kernel = dependency(&workspace, KERNEL).filter(|kernel| packages.contains(kernel));
    let kernel = kernel.ok_or(PlantedError::Independent { peer: PEER, needed: KERNEL })?;

    let shared = shared(&root, &workspace)?;
    let package_of =
        |file: &str| packages.iter().filter(|package| is_within(file, package)).max_by_key(|one| one.len());
    let edits = defects.iter().flat_map(|defect| &defect.edit);
    let mut changed: BTreeSet<&String> = edits.filter_map(|edit| package_of(&edit.file)).collect();
    // A constant function of one that depends on another may call a function there that is none any more.
    loop {
        let before = changed.len();
        for package in &packages {
            if dependencies(&root, &workspace, package)?.iter().any(|other| changed.contains(other)) {
                changed.insert(package);
            }
        }
        if changed.len() == before {
            break;
        }
    }
    let revise = |file: &str, text: String| -> Result<Option<String>, PlantedError> {
        let Some(package) = package_of(file) else { return Ok(None) };
        Ok(if is_for_tests(file, package) {
            None
        } else if file == format!("{package}/Cargo.toml") {
            Some(without_tests(&root.join(file), (package != &kernel && changed.contains(package)).then_some(&shared))?)
        } else if file.ends_with(".rs") && changed.contains(package) {
            let module = if file == format!("{kernel}/src/lib.rs") { "\npub mod planted;\n" } else { "" };
            // A switch is read at run time.
            Some((text + module).replace("const fn ", "fn "))
        } else {
            Some(text)
        })
    };
    only(&mut workspace, &packages);
    let lock = root.join("Cargo.lock");
    let lock = fs::read_to_string(&lock).map_err(|source| PlantedError::File { path: lock, source })?;
    let own = vec![
        (format!("{kernel}/src/planted.rs"), switches(defects)),
        ("Cargo.toml".to_owned(), toml_text("Cargo.toml", &workspace)?),
        ("Cargo.lock".to_owned(), lock),
    ];
    let from = packages.iter().cloned().collect();
    Copy { from, to: folder.clone(), switch: SWITCH, revise: &revise, own }.make(project, defects)?;
    Ok(Planted { package: name(&root, PEER)?, folder })
}

impl Planted {
    /// What builds it.
    pub(crate) fn build(&self) -> Launch {
        let cargo = ["cargo", "build", "--profile", "verify", "--quiet", "--target-dir", "target", "-p", &self.package];
        Launch::new(cargo.map(str::to_owned).to_vec(), &self.folder)
    }

    /// The program that is built.
    pub(crate) fn program(&self) -> PathBuf {
        self.folder.join("target/verify").join(format!("{}{}", self.package, std::env::consts::EXE_SUFFIX))
    }
}

/// The folders of the peer and of all packages of the project that it depends on.
fn packages(root: &Path, workspace: &Table) -> Result<BTreeSet<String>, PlantedError> {
    let mut packages = BTreeSet::new();
    let mut open = vec![PEER.to_owned()];
    while let Some(package) = open.pop() {
        open.extend(dependencies(root, workspace, &package)?);
        open.retain(|other| *other != package && !packages.contains(other));
        packages.insert(package);
    }
    Ok(packages)
}

/// The folders of the packages of the project on which a package depends.
fn dependencies(root: &Path, workspace: &Table, package: &str) -> Result<Vec<String>, PlantedError> {
    let manifest = manifest(&root.join(package).join("Cargo.toml"))?;
    let names = manifest.get("dependencies").and_then(Value::as_table);
    Ok(names.into_iter().flat_map(Table::keys).filter_map(|name| dependency(workspace, name)).collect())
}

/// The folder of a package of the project, by its name.
fn dependency(workspace: &Table, name: &str) -> Option<String> {
    let dependencies = workspace.get("workspace")?.get("dependencies")?;
    Some(dependencies.get(name)?.get("path")?.as_str()?.to_owned())
}

fn name(root: &Path, package: &str) -> Result<String, PlantedError> {
    let manifest = manifest(&root.join(package).join("Cargo.toml"))?;
    let name = manifest.get("package").and_then(|package| package.get("name")?.as_str());
    Ok(name.unwrap_or_default().to_owned())
}

fn is_within(file: &str, folder: &str) -> bool {
    file.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/'))
}

fn is_for_tests(file: &str, package: &str) -> bool {
    let within = file.strip_prefix(package).unwrap_or(file).trim_start_matches('/');
    FOR_TESTS.iter().any(|folder| is_within(within, folder))
}

/// What every package with a switch depends on: the package of the switches, and what the code of a defect may name,
/// which is what the peer itself and its tests may.
fn shared(root: &Path, workspace: &Table) -> Result<Table, PlantedError> {
    let mut manifest = manifest(&root.join(PEER).join("Cargo.toml"))?;
    let mut shared =
        Table::from_iter([(KERNEL.to_owned(), Table::from_iter([("workspace".to_owned(), true.into())]).into())]);
    for kind in ["dependencies", "dev-dependencies"] {
        if let Some(Value::Table(dependencies)) = manifest.remove(kind) {
            let is_foreign =
                |(name, value): &(String, Value)| dependency(workspace, name).is_none() && value.get("path").is_none();
            shared.extend(dependencies.into_iter().filter(is_foreign));
        }
    }
    Ok(shared)
}

/// A package's manifest without what only its tests need, and with these dependencies besides its own.
fn without_tests(path: &Path, shared: Option<&Table>) -> Result<String, PlantedError> {
    let mut manifest = manifest(path)?;
    for key in ["dev-dependencies", "bench", "example", "test"] {
        manifest.remove(key);
    }
    let dependencies = manifest.entry("dependencies").or_insert_with(|| Table::new().into());
    if let (Some(dependencies), Some(shared)) = (dependencies.as_table_mut(), shared) {
        for (name, dependency) in shared {
            dependencies.entry(name).or_insert(dependency.clone());
        }
    }
    toml_text(&path.display().to_string(), &manifest)
}

/// Reduces a workspace to these packages. What they look like is checked where they come from.
fn only(workspace: &mut Table, packages: &BTreeSet<String>) {
    if let Some(Value::Table(workspace)) = workspace.get_mut("workspace") {
        workspace.insert("members".to_owned(), packages.iter().cloned().collect::<Vec<_>>().into());
        let allow = Table::from_iter([("warnings".to_owned(), "allow".into())]);
        workspace.insert("lints".to_owned(), Table::from_iter([("rust".to_owned(), allow.into())]).into());
    }
}

fn manifest(path: &Path) -> Result<Table, PlantedError> {
    let text = fs::read_to_string(path).map_err(|source| PlantedError::File { path: path.to_owned(), source })?;
    toml::from_str(&text).map_err(|source| PlantedError::Form { path: path.to_owned(), source: Box::new(source) })
}

fn toml_text(file: &str, table: &Table) -> Result<String, PlantedError> {
    toml::to_string(table).map_err(|source| PlantedError::Manifest { file: file.to_owned(), source })
}

/// The module that knows which defects are switched on.
fn switches(defects: &[Defect]) -> String {
    let mut names = String::new();
    for defect in defects {
        // Writing to a string cannot fail.
        let _ = writeln!(names, "    {:?},", defect.name);
    }
    SWITCHES.replace("@COUNT@", &defects.len().to_string()).replace("@NAMES@\n", &names)
}

const SWITCHES: &str = r#"//! Which planted defects are switched on: those that the command line names.

use std::sync::LazyLock;
use std::{env, eprintln, process};

const NAMES: [&str; @COUNT@] = [
@NAMES@
];

static ON: LazyLock<[bool; @COUNT@]> = LazyLock::new(|| {
    let mut on = [false; @COUNT@];
    let mut args = env::args().skip(1);
    while let Some(arg) = args.next() {
        let name = args.next().filter(|_| arg == "--defect");
        match name.and_then(|name| NAMES.iter().position(|known| *known == name)) {
            Some(number) => on[number] = true,
            None => {
                eprintln!("usage: ncp-peer-rust [--defect NAME]…; cargo assure mutants --list shows the names");
                process::exit(2);
            }
        }
    }
    on
});

/// Whether the defect of this number is switched on.
#[inline]
pub fn is(number: usize) -> bool {
    ON[number]
}
"#;

#[cfg(test)]
mod tests {
    use std::process::Command;

    use ncp_defects::Edit;

    use super::*;

    fn defect(name: &str, file: &str, code: &str, with: &str) -> Defect {
        let edit =
            Edit { file: file.to_owned(), after: None, code: code.to_owned(), with: with.to_owned(), always: false };
        let table = format!("name = {name:?}\nabout = \"It.\"\nedit = []\n");
        Defect { edit: vec![edit], ..toml::from_str(&table).unwrap() }
    }

    /// A project of a peer, a kernel and a package that the peer does not need.
    fn project(root: &Path) -> Project {
        let write = |file: &str, text: &str| {
            let path = root.join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        };
        write(
            "Cargo.toml",
            "[workspace]\nmembers = [\"spec/kernel\", \"peers/rust\", \"other\"]\n[workspace.dependencies]\n\
             ncp-kernel = { path = \"spec/kernel\" }\nother = { path = \"other\" }\nserde_json = \"1\"\n",
        );
        write("Cargo.lock", "version = 4\n");
        write(
            "spec/kernel/Cargo.toml",
            "[package]\nname = \"ncp-kernel\"\n[dev-dependencies]\nother.workspace = true\n",
        );
        write("spec/kernel/src/lib.rs", "pub const fn less(a: u8, b: u8) -> bool { a < b }\n");
        write("spec/kernel/tests/less.rs", "fn main() {}\n");
        write(
            "peers/rust/Cargo.toml",
            "[package]\nname = \"ncp-peer-rust\"\n\
             [dependencies]\nncp-kernel.workspace = true\nserde_json.workspace = true\n",
        );
        write("peers/rust/src/main.rs", "fn main() { print!(\"{}\", ncp_kernel::less(1, 1)) }\n");
        write("other/Cargo.toml", "[package]\nname = \"other\"\n");
        assert!(Command::new("git").args(["init", "--quiet"]).arg(root).status().unwrap().success());
        Project::at(root)
    }

    #[test]
    fn whole_packages_are_copied_with_switches_and_without_what_tests_need() {
        let folder = tempfile::tempdir().unwrap();
        let project = project(folder.path());
        let defects = [
            defect("at-most", "spec/kernel/src/lib.rs", "a < b", "a <= b"),
            defect("swapped", "peers/rust/src/main.rs", "less(1, 1)", "less(1, 2)"),
        ];
        let planted = weave(&project, &defects).unwrap();
        let read = |file: &str| fs::read_to_string(planted.folder.join(file)).unwrap();
        let woven = "pub fn less(a: u8, b: u8) -> bool { (if ::ncp_kernel::planted::is(0) { a <= b } else { a < b }) }";
        assert!(read("spec/kernel/src/lib.rs").starts_with(woven));
        assert!(read("spec/kernel/src/lib.rs").contains("pub mod planted;"));
        assert!(read("peers/rust/src/main.rs").contains("::ncp_kernel::planted::is(1)"));
        assert!(!read("spec/kernel/Cargo.toml").contains("other"));
        assert!(read("Cargo.toml").contains("members = [\"peers/rust\", \"spec/kernel\"]"));
        assert!(!planted.folder.join("spec/kernel/tests").exists() && !planted.folder.join("other").exists());

        // A second time, only what changed is written, and what is gone goes.
        fs::write(planted.folder.join("peers/rust/src/old.rs"), "").unwrap();
        let kernel = planted.folder.join("spec/kernel/src/lib.rs");
        let written = fs::metadata(&kernel).unwrap().modified().unwrap();
        weave(&project, &defects).unwrap();
        assert_eq!(fs::metadata(&kernel).unwrap().modified().unwrap(), written);
        assert!(!planted.folder.join("peers/rust/src/old.rs").exists());
    }

    #[test]
    fn a_defect_of_no_source_of_the_peer_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let stray = defect("stray", "other/src/lib.rs", "a", "b");
        let error = weave(&project(folder.path()), &[stray]).unwrap_err().to_string();
        assert_eq!(error, "other/src/lib.rs has a defect, and is no file of the copy: stray");
    }

    #[test]
    fn the_command_line_switches_defects_on_alone_and_together_and_an_unknown_one_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let defects = ["one", "two"].map(|name| defect(name, "", "", ""));
        fs::write(folder.path().join("planted.rs"), switches(&defects)).unwrap();
        let main = "mod planted;\nfn main() { print!(\"{} {}\", planted::is(0), planted::is(1)) }\n";
        fs::write(folder.path().join("main.rs"), main).unwrap();
        let program = folder.path().join("program");
        let rustc = ["--edition", "2024", "-o", "program", "main.rs"];
        assert!(Command::new("rustc").args(rustc).current_dir(folder.path()).status().unwrap().success());
        let run = |args: &[&str]| {
            let output = Command::new(&program).args(args).output().unwrap();
            (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
        };
        assert_eq!(run(&[]), (0, "false false".to_owned()));
        assert_eq!(run(&["--defect", "two"]), (0, "false true".to_owned()));
        assert_eq!(run(&["--defect", "two", "--defect", "one"]), (0, "true true".to_owned()));
        for wrong in [&["--defect", "three"][..], &["--defect"], &["one"]] {
            assert_eq!(run(wrong), (2, String::new()), "{wrong:?}");
        }
    }
}
