//! What the pages of the project say of itself is true: the commands that they name, the folders and the modules that
//! they list, the files that they link to, the floors of the house, and the workflows.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, iter};

use saphyr::{LoadableYamlNode, Yaml};

#[test]
fn every_command_that_a_page_names_is_one_of_its_program() {
    let mut programs = Programs::default();
    let mut wrong = Vec::new();
    for page in pages().into_iter().chain(files(&[".github/workflows/*.yml"])) {
        for (line, command) in commands(&read(&page)) {
            if let Err(why) = programs.accept(&command) {
                wrong.push(format!("{page}:{line}: {}: {why}", command.join(" ")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn commands_are_found_in_blocks_and_in_running_text() {
    let page = "Run `cargo verify\nlist --filter x`, not `cargo`.\n\n```\n$ cargo xtask test --only rust  # why\n\
                cd x && ncp-verify run \\\n  --peer-cmd 'a --b' | less\n```\n";
    let found: Vec<_> = commands(page).into_iter().map(|(line, words)| (line, words.join(" "))).collect();
    let expected = [
        (1, "cargo verify list --filter x"),
        (5, "cargo xtask test --only rust"),
        (6, "ncp-verify run --peer-cmd a --b"),
    ];
    assert_eq!(found, expected.map(|(line, words)| (line, words.to_owned())));
}

#[test]
fn a_command_or_an_option_that_no_program_has_is_refused() {
    let mut programs = Programs::default();
    for (line, accepted) in [
        ("cargo xtask test --only format --list", true),
        ("cargo verify run --peer=FOLDER -v", true),
        ("cargo verify", true),
        ("cargo xtask tset", false),
        ("cargo verify tset", false),
        ("cargo xtask test --onyl format", false),
        ("cargo xtask test --only no-such-check", false),
        ("cargo xtask package --only wheel", true),
        ("cargo xtask package --only no-such-package", false),
        ("ncp-verify list --no-such-option", false),
        ("cargo test -p ncp-spec", true),
        ("cargo test -p no-such-package", false),
    ] {
        let words: Vec<String> = line.split(' ').map(str::to_owned).collect();
        assert_eq!(programs.accept(&words).is_ok(), accepted, "{line}");
    }
}

#[test]
fn a_table_of_folders_lists_the_folders_that_are_there() {
    let mut wrong = Vec::new();
    let mut tables = 0;
    for page in pages() {
        let home = Path::new(&page).parent().unwrap();
        for listed in tables_under("folder", &read(&page)) {
            tables += 1;
            let folder = |cell: &String| folder_of(resolve(home, &target(cell)));
            let listed: BTreeSet<PathBuf> = listed.iter().map(folder).collect();
            let base = listed.iter().min_by_key(|folder| folder.components().count()).unwrap().parent().unwrap();
            for folder in folders_in(base) {
                if !listed.contains(&folder) {
                    wrong.push(format!("{page}: does not list {}", folder.display()));
                }
            }
            for folder in listed.iter().filter(|folder| !root().join(folder).is_dir()) {
                wrong.push(format!("{page}: {} is no folder", folder.display()));
            }
        }
    }
    assert!(tables > 0, "no page has a table of folders any more");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_crate_stands_only_on_the_rooms_that_the_architecture_names() {
    let page = read("ARCHITECTURE.md");
    let rows: Vec<Vec<&str>> = page.lines().map(|line| line.split('|').map(str::trim).collect()).collect();
    let start = rows.iter().position(|row| row.get(1..3) == Some(&["room", "stands on"])).unwrap();
    let rooms: BTreeMap<String, &str> =
        rows[start + 2..].iter().map_while(|row| Some((target(row.get(1)?), *row.get(2)?))).collect();
    let room_of = |path: &Path| {
        let folders = path.ancestors().filter_map(Path::to_str).map(str::to_owned);
        folders.into_iter().find(|folder| rooms.contains_key(folder))
    };

    let crates = crates();
    let mut wrong = Vec::new();
    for manifest in files(&["*Cargo.toml"]) {
        let folder = Path::new(&manifest).parent().unwrap();
        let Some(room) = room_of(folder) else { continue };
        let (rooms_below, manifest): (_, toml::Table) = (rooms[&room], read(&manifest).parse().unwrap());
        // A second source is independent in its tests, too.
        let sections = ["dependencies", "build-dependencies", "dev-dependencies"];
        for section in sections.iter().take(if room == "vectors" { 3 } else { 2 }) {
            for name in manifest.get(*section).and_then(toml::Value::as_table).into_iter().flat_map(toml::Table::keys) {
                let Some(below) = crates.get(name).and_then(|folder| room_of(folder)) else { continue };
                let word = below.rsplit('/').next().unwrap();
                if below != room && rooms_below != "all" && !rooms_below.split(", ").any(|known| known == word) {
                    wrong.push(format!("{}: {section} has {name}, of the room {below}", folder.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_room_has_a_page() {
    let rooms = folders_in(Path::new("")).into_iter().chain(folders_in(Path::new("peers")));
    let rooms: Vec<_> = rooms.chain(["spec/text".into()]).collect();
    let without: Vec<_> = rooms.iter().filter(|room| !root().join(room).join("README.md").exists()).collect();
    assert!(without.is_empty(), "without a README.md: {without:?}");
}

#[test]
fn a_table_or_list_of_modules_names_those_that_are_declared() {
    let mut wrong = Vec::new();
    let mut lists = 0;
    for file in files(&["*.rs"]) {
        let text = read(&file);
        let (declared, conditional) = declared_modules(&text);
        let docs: Vec<_> = text.lines().map_while(|line| line.strip_prefix("//!")).map(str::trim_start).collect();
        let tables = tables_under("module", &docs.join("\n"));
        let listed: BTreeSet<String> = if tables.is_empty() {
            let items = docs.iter().filter_map(|line| line.strip_prefix("- ")?.split_once(':'));
            items.filter(|(names, _)| code(names).is_some()).flat_map(|(names, _)| codes(names)).collect()
        } else {
            tables.iter().flatten().flat_map(|cell| codes(cell)).collect()
        };
        // A list of something else names no module.
        if declared.is_empty() || tables.is_empty() && listed.is_disjoint(&declared) {
            continue;
        }
        lists += 1;
        for (what, difference) in [
            ("does not list the module", &declared - &listed),
            ("lists, as a module that is not declared,", &(&listed - &declared) - &conditional),
        ] {
            wrong.extend(difference.iter().map(|module| format!("{file}: {what} {module}")));
        }
    }
    assert!(lists > 5, "{lists} lists of modules are few");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_link_of_a_page_leads_to_a_file() {
    let mut wrong = Vec::new();
    for page in pages() {
        let home = Path::new(&page).parent().unwrap();
        for (number, line) in outside_of_blocks(&read(&page)) {
            for link in line.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
                let path = link.split('#').next().unwrap();
                let is_elsewhere = path.is_empty() || path.contains("://") || path.starts_with("mailto:");
                if !is_elsewhere && !root().join(resolve(home, path)).exists() {
                    wrong.push(format!("{page}:{number}: {link} leads nowhere"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_workflow_is_well_formed_and_bounded() {
    let workflows = files(&[".github/workflows/*.yml"]);
    assert!(workflows.len() > 5, "{workflows:?}");
    for workflow in workflows {
        let text = read(&workflow);
        let documents = Yaml::load_from_str(&text).unwrap_or_else(|error| panic!("{workflow}: {error}"));
        let document = &documents[0];
        let name = document["name"].as_str().unwrap();
        assert_eq!(Some(name), Path::new(&workflow).file_stem().and_then(|stem| stem.to_str()), "{workflow}");
        assert!(document.contains_mapping_key("on"), "{workflow}: when does it run?");
        assert_eq!(document["permissions"]["contents"].as_str(), Some("read"), "{workflow}");
        for (id, job) in document["jobs"].as_mapping().unwrap() {
            let place = format!("{workflow}, job {id:?}");
            assert!(job["runs-on"].as_str().is_some(), "{place}");
            assert!(job["timeout-minutes"].as_integer().is_some_and(|minutes| minutes < 360), "{place}");
            for step in job["steps"].as_sequence().unwrap() {
                let does = ["uses", "run"].map(|key| step.contains_mapping_key(key));
                assert_eq!(does.iter().filter(|does| **does).count(), 1, "{place}: {step:?}");
            }
        }
    }
}

/// The programs that pages name, and what they say of themselves.
#[derive(Default)]
struct Programs {
    helps: BTreeMap<Vec<String>, String>,
}

impl Programs {
    /// Whether the program of a command line has its subcommand, its options and the values that it lists.
    fn accept(&mut self, words: &[String]) -> Result<(), String> {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let (program, rest) = match words.as_slice() {
            ["cargo", alias @ ("verify" | "xtask" | "assure"), rest @ ..] => (*alias, rest),
            ["ncp-verify", rest @ ..] => ("verify", rest),
            ["cargo", rest @ ..] => return Self::accept_package(rest),
            _ => return Err("is no command".to_owned()),
        };
        let mut path = vec![program.to_owned()];
        let mut own = self.help(&path)?.to_owned();
        let mut help = own.clone();
        for (number, word) in rest.iter().enumerate() {
            if *word == "--" {
                break;
            }
            if word.starts_with('-') {
                // A command that takes its options apart itself shows none.
                let option = word.split('=').next().unwrap();
                if !mentions(&help, option) && !help.contains("[OPTIONS]...") {
                    return Err(format!("{} has no {option}", path.join(" ")));
                }
                continue;
            }
            // The value of an option, or of the command.
            if number > 0 && rest[number - 1].starts_with("--") {
                if !lists_value(&own, word) {
                    self.accept_value(rest[number - 1], word)?;
                }
            } else if mentions_command(&own, word) {
                path.push((*word).to_owned());
                self.help(&path)?.clone_into(&mut own);
                help += &own;
            } else if own.contains("<COMMAND>") || own.contains("[COMMAND]") {
                return Err(format!("{} has no command {word}", path.join(" ")));
            }
        }
        Ok(())
    }

    fn accept_value(&mut self, option: &str, value: &str) -> Result<(), String> {
        let is_word = value.chars().all(|character| character.is_ascii_lowercase() || character == '-');
        if option == "--only" && is_word && !mentions_command(self.help(&["checks".to_owned()])?, value) {
            // What `cargo assure mutants` has is for its own tests to say.
            let is_defect =
                !files(&["defects/*.toml"]).iter().all(|file| !read(file).contains(&format!("\"{value}\"")));
            return if is_defect { Ok(()) } else { Err(format!("{value} is neither a check nor a defect")) };
        }
        Ok(())
    }

    /// The packages that a command of cargo names are of this workspace.
    fn accept_package(words: &[&str]) -> Result<(), String> {
        let named = words.windows(2).filter(|pair| matches!(pair[0], "-p" | "--package")).map(|pair| pair[1]);
        match named.into_iter().find(|name| !crates().contains_key(*name)) {
            Some(unknown) => Err(format!("{unknown} is no package of this workspace")),
            None => Ok(()),
        }
    }

    /// What a program prints of a command; for `checks`, those of `cargo xtask test`.
    fn help(&mut self, path: &[String]) -> Result<&str, String> {
        if !self.helps.contains_key(path) {
            let text = ask(path)?;
            self.helps.insert(path.to_vec(), text);
        }
        Ok(&self.helps[path])
    }
}

fn ask(path: &[String]) -> Result<String, String> {
    let of_package = |package: &str, program: &str| {
        // Nextest has just built it with all other programs; alone, it would be built with other features once more.
        let built = Path::new(env!("CARGO_BIN_EXE_xtask")).with_file_name(program);
        if std::env::var_os("NEXTEST").is_some() && built.exists() {
            return Command::new(built);
        }
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["run", "--quiet", "-p", package, "--"]).current_dir(root());
        cargo
    };
    // Until the crate is there: what is planned.
    if path[0] == "assure" && !root().join("assurance/Cargo.toml").exists() {
        let commands = ["trace", "mutants", "mutate", "prove", "fuzz", "refresh", "status", "kernel", "spec"];
        return Ok(format!("Commands:\n{}\n[OPTIONS]...\nUsage: <COMMAND>", commands.join("\n")));
    }
    let mut program = match path[0].as_str() {
        "xtask" | "checks" => Command::new(env!("CARGO_BIN_EXE_xtask")),
        "verify" => of_package("ncp-verifier", "ncp-verify"),
        _ => of_package("ncp-assurance", "ncp-assurance"),
    };
    match path[0].as_str() {
        "checks" => program.args(["test", "--list"]).env("CARGO_MANIFEST_DIR", root().join("xtask")),
        _ => program.args(&path[1..]).arg("--help"),
    };
    let output = program.output().unwrap();
    let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    // A command's list of checks looks like a help's list of commands.
    if output.status.success() { Ok(format!("Commands:\n{text}").replace("\nCommands:\n", "\n")) } else { Err(text) }
}

/// Whether a help lists an option.
fn mentions(help: &str, option: &str) -> bool {
    let is_part = |character: char| character.is_ascii_alphanumeric() || character == '-';
    help.match_indices(option)
        .any(|(at, found)| !help[at + found.len()..].starts_with(is_part) && !help[..at].ends_with(is_part))
}

/// Whether a help lists a value of an option, with what it means.
fn lists_value(help: &str, word: &str) -> bool {
    help.lines().any(|line| line.trim_start().starts_with(&format!("- {word}:")))
}

/// Whether a help lists a command, which stands first in a line.
fn mentions_command(help: &str, word: &str) -> bool {
    help.lines().any(|line| line.split_whitespace().next() == Some(word))
}

/// The command lines of a page that name a program of the project or cargo: their line, and their words.
fn commands(page: &str) -> Vec<(usize, Vec<String>)> {
    let mut found = Vec::new();
    let joined = page.replace("\\\n", "\u{1}");
    let mut number = 1;
    let mut is_block = page.starts_with("# ") && page.contains("\njobs:");
    let mut text = String::new();
    let mut text_begins = 1;
    for line in joined.lines() {
        let is_fence = line.trim_start().starts_with("```");
        if is_fence {
            is_block = !is_block;
        } else if is_block {
            found.extend(commands_of(line).into_iter().map(|words| (number, words)));
        }
        // Code in running text may go over the end of a line, but not of a paragraph.
        if is_fence || is_block || line.trim().is_empty() {
            found.extend(inline_commands(&text, text_begins));
            text.clear();
            text_begins = number + 1;
        } else {
            text += line;
            text.push('\n');
        }
        number += 1 + line.matches('\u{1}').count();
    }
    found.extend(inline_commands(&text, text_begins));
    found.sort();
    found
}

/// The commands in the code of running text.
fn inline_commands(text: &str, begins: usize) -> Vec<(usize, Vec<String>)> {
    let mut line = begins;
    let mut found = Vec::new();
    for (index, part) in text.split('`').enumerate() {
        if index % 2 == 1 {
            found.extend(commands_of(part).into_iter().map(|words| (line, words)));
        }
        line += part.matches('\n').count();
    }
    found
}

/// The commands in one line of a shell.
fn commands_of(line: &str) -> Vec<Vec<String>> {
    let line = line.replace(['\u{1}', '\n'], " ");
    let line = line.split(" #").next().unwrap().replace(['[', ']', '(', ')'], " ");
    let words = shlex::split(&line).unwrap_or_default();
    let is_end = |word: &String| matches!(word.as_str(), "&&" | "||" | "|" | ";" | ">" | "2>&1");
    let words = words.split(is_end).map(|command| {
        let begins = command.iter().position(|word| matches!(word.as_str(), "cargo" | "ncp-verify"));
        begins.map(|at| command[at..].to_vec()).unwrap_or_default()
    });
    // The name of the program alone is no command, and neither is a sentence that begins with it.
    words.filter(|words| words.len() > 1 || words.first().is_some_and(|word| word == "ncp-verify")).collect()
}

/// The first cells of the rows of each table whose first column has this heading.
fn tables_under(heading: &str, page: &str) -> Vec<Vec<String>> {
    let first_cell =
        |line: &str| -> Option<String> { Some(line.trim().strip_prefix('|')?.split('|').next()?.trim().to_owned()) };
    let lines: Vec<Option<String>> = page.lines().map(first_cell).collect();
    let starts =
        (0..lines.len()).filter(|at| lines[*at].as_deref() == Some(heading) && (*at == 0 || lines[at - 1].is_none()));
    starts.map(|at| lines[at + 2..].iter().map_while(Clone::clone).collect()).collect()
}

/// The lines that are in no block of code, by their number.
fn outside_of_blocks(page: &str) -> Vec<(usize, &str)> {
    let mut is_block = false;
    let lines = page.lines().enumerate().filter(|(_, line)| {
        let is_fence = line.trim_start().starts_with("```");
        is_block ^= is_fence;
        !is_block && !is_fence
    });
    lines.map(|(index, line)| (index + 1, line)).collect()
}

/// The modules that a file declares, and those of them that only some builds have, such as tests.
fn declared_modules(text: &str) -> (BTreeSet<String>, BTreeSet<String>) {
    let name = |line: &str| -> Option<String> {
        let rest = line.strip_suffix(';').or_else(|| line.strip_suffix(" {"))?;
        let (visibility, name) = rest.split_once("mod ")?;
        // What is declared in place and not public is no room of its own.
        let is_own_file = line.ends_with(';') || visibility.starts_with("pub");
        (is_own_file && (visibility.is_empty() || visibility.starts_with("pub"))).then(|| name.to_owned())
    };
    let (mut always, mut conditional) = (BTreeSet::new(), BTreeSet::new());
    for (before, line) in iter::once("").chain(text.lines()).zip(text.lines()) {
        let modules = if before.starts_with("#[cfg(") { &mut conditional } else { &mut always };
        modules.extend(name(line));
    }
    (always, conditional)
}

/// What stands between the first two backticks of what begins with code or a link to it.
fn code(text: &str) -> Option<&str> {
    text.trim_start_matches('[').strip_prefix('`')?.split('`').next()
}

/// All that stands between backticks.
fn codes(text: &str) -> impl Iterator<Item = String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned)
}

/// Where the link of a cell leads, or the path that it names.
fn target(cell: &str) -> String {
    let link = cell.split_once("](").and_then(|(_, rest)| rest.split(')').next());
    link.or_else(|| code(cell)).unwrap_or(cell).to_owned()
}

/// The folder of a page, or the folder itself.
fn folder_of(path: PathBuf) -> PathBuf {
    if root().join(&path).is_file() { path.parent().unwrap().to_owned() } else { path }
}

/// A path, from a folder of the project, without `..`.
fn resolve(home: &Path, path: &str) -> PathBuf {
    let mut resolved = PathBuf::new();
    for part in home.join(path).components() {
        match part {
            std::path::Component::ParentDir => {
                resolved.pop();
            }
            std::path::Component::CurDir => {}
            part => resolved.push(part),
        }
    }
    resolved
}

/// The packages of the project, with their folders.
fn crates() -> BTreeMap<String, PathBuf> {
    let manifests = files(&["*Cargo.toml"]).into_iter();
    let named = manifests.filter_map(|manifest| {
        let name = read(&manifest).lines().find_map(|line| line.strip_prefix("name = ").map(str::to_owned))?;
        Some((name.trim_matches('"').to_owned(), Path::new(&manifest).parent()?.to_owned()))
    });
    named.collect()
}

/// The folders that git has in a folder, but for hidden ones.
fn folders_in(folder: &Path) -> BTreeSet<PathBuf> {
    let all = files(&["*"]);
    let inside = all.iter().filter_map(|file| Path::new(file).strip_prefix(folder).ok());
    let names = inside.filter(|path| path.components().count() > 1).filter_map(|path| path.components().next());
    let folders = names.map(|name| folder.join(name));
    folders.filter(|path| !path.file_name().unwrap().to_string_lossy().starts_with('.')).collect()
}

/// The pages that people write.
fn pages() -> Vec<String> {
    files(&["*.md"]).into_iter().filter(|page| !page.starts_with("reports/") || page.ends_with("README.md")).collect()
}

/// The files of these patterns that git has and that are there.
fn files(patterns: &[&str]) -> Vec<String> {
    let output = Command::new("git").arg("ls-files").args(patterns).current_dir(root()).output().unwrap();
    assert!(output.status.success(), "git ls-files: {output:?}");
    let listed = String::from_utf8(output.stdout).unwrap();
    listed.lines().filter(|file| root().join(file).exists()).map(str::to_owned).collect()
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}
