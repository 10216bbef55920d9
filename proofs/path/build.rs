//! Makes the subjects of the proofs: the sources of the specification as they are, and once more with each defect of
//! the table. Behind each source stands a window, which takes the private state apart by name.

use std::env;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use ncp_defects::{Defect, place, read};

/// The sources, each with the module in which it stands and the families of claims that run it.
const SOURCES: [(&str, &str, &str); 4] = [
    ("safety", "governor", "governor liveness"),
    ("resilience", "link_monitor", "link liveness"),
    ("resilience", "action_buffer", "estop"),
    ("control", "control_loop", "loop liveness"),
];
const FAMILIES: [&str; 5] = ["estop", "governor", "link", "loop", "liveness"];
const TABLE: &str = "defects/path.toml";

fn main() -> Result<(), Box<dyn Error>> {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let root = here.join("../..");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    println!("cargo::rerun-if-changed={}", root.join(TABLE).display());
    println!("cargo::rerun-if-changed={}", here.join("src/windows").display());
    for (module, name, _) in SOURCES {
        println!("cargo::rerun-if-changed={}", root.join(source(module, name)).display());
    }

    let sound = Defect { name: "production".to_owned(), ..Defect::default() };
    let (mut modules, mut arms) = (String::new(), String::new());
    for defect in [sound].into_iter().chain(read(&root.join(TABLE))?) {
        let mut families: Vec<&str> = if defect.properties.is_empty() {
            FAMILIES.to_vec()
        } else {
            defect.properties.iter().filter_map(|id| id.split('/').next()).collect()
        };
        families.dedup();
        let module = defect.name.replace('-', "_");
        let folder = out.join("subjects").join(&defect.name);
        fs::create_dir_all(&folder)?;
        for edit in &defect.edit {
            if !SOURCES.iter().any(|(module, name, _)| source(module, name) == edit.file) {
                return Err(format!("{}: {} is no source of the path", defect.name, edit.file).into());
            }
        }
        for (place, name, _) in SOURCES {
            copy(&root, &here, &folder, (place, name), &defect)?;
        }
        if families.contains(&"link") {
            fs::write(folder.join("link_number.rs"), of_numbers(&root, &here, &defect)?)?;
        }
        for family in families {
            let name = format!("{module}_{family}");
            writeln!(modules, "{}", tree(&name, family, &folder))?;
            let subject = match family {
                "estop" => "resilience::action_buffer::Subject",
                "governor" => "safety::governor::SafetyGovernor",
                "link" => {
                    let link = format!("{name}::resilience");
                    let terms = format!("{link}::link_number::LinkMonitor");
                    writeln!(
                        arms,
                        "({:?}, {family:?}) => crate::link::run::<{link}::LinkMonitor, {terms}>(id),",
                        defect.name
                    )?;
                    continue;
                }
                _ => "control::control_loop::Subject",
            };
            let rust = if family == "loop" { "control" } else { family };
            writeln!(arms, "({:?}, {family:?}) => crate::{rust}::run::<{name}::{subject}>(id),", defect.name)?;
        }
    }
    let table = format!(
        "{modules}\n/// The harness of a claim on the sources as they are, or on those with a defect.\n#[must_use]\n\
         pub fn harness(subject: &str, id: &str) -> Option<crate::engine::Harness> {{\n \
         match (subject, id.split('/').next().unwrap_or_default()) {{\n{arms} _ => None }}\n}}\n"
    );
    fs::write(out.join("subjects.rs"), table)?;
    Ok(())
}

fn source(module: &str, name: &str) -> String {
    format!("spec/src/{module}/{name}.rs")
}

/// A source without its tests, with the defect, and with its window behind it. What it calls `crate` is the tree that
/// it is compiled in.
fn copy(
    root: &Path,
    here: &Path,
    folder: &Path,
    (module, name): (&str, &str),
    defect: &Defect,
) -> Result<(), Box<dyn Error>> {
    let file = source(module, name);
    let text = fs::read_to_string(root.join(&file))?.replace("\r\n", "\n");
    let text = place::plant(place::without_tests(&text), &file, defect)?;
    let window = here.join(format!("src/windows/{name}.rs"));
    let text = format!("{}\ninclude!({window:?});\n", text.replace("crate::", "super::super::"));
    fs::write(folder.join(format!("{name}.rs")), text)?;
    Ok(())
}

/// The link monitor with terms in the place of doubles.
fn of_numbers(root: &Path, here: &Path, defect: &Defect) -> Result<String, Box<dyn Error>> {
    let file = source("resilience", "link_monitor");
    let text = fs::read_to_string(root.join(&file))?.replace("\r\n", "\n");
    let text = place::plant(place::without_tests(&text), &file, defect)?;
    let mut numbers = String::new();
    let mut rest = text.as_str();
    // Each literal of a double: digits, a dot, digits.
    while let Some(at) = rest.find(|c: char| c.is_ascii_alphanumeric() || c == '_') {
        let (before, word) = rest.split_at(at);
        let end = word.find(|c: char| !(c.is_ascii_alphanumeric() || "._".contains(c))).unwrap_or(word.len());
        let (word, after) = word.split_at(end);
        let is_literal = word.split_once('.').is_some_and(|(whole, fraction)| {
            let is_number = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit() || b == b'_');
            is_number(whole) && is_number(fraction)
        });
        numbers += before;
        numbers += &if is_literal { format!("Number::of({word})") } else { word.to_owned() };
        rest = after;
    }
    let numbers = (numbers + rest).replace("f64", "Number").replace(" as Number", ".number()");
    Ok(format!("{numbers}\ninclude!({:?});\n", here.join("src/windows/link_number.rs")))
}

/// The modules in which the sources of a family are compiled. A loop alone stands between a governor and a link
/// monitor that note what they are told; all else is of the subject or, where no family of it asks, the specification.
fn tree(name: &str, family: &str, folder: &Path) -> String {
    let module = |file: &str| format!("#[path = {:?}] pub mod {file};", folder.join(format!("{file}.rs")));
    let runs = |file: &str| SOURCES.iter().any(|(_, name, of)| *name == file && of.split(' ').any(|of| of == family));
    let part = |file: &str, kind: &str, otherwise: &str| {
        if runs(file) { format!("{} pub use self::{file}::{kind};", module(file)) } else { otherwise.to_owned() }
    };
    let spied = |kind: &str| if family == "loop" { format!("pub use crate::spies::{kind};") } else { String::new() };
    format!(
        "#[allow(warnings, clippy::all, clippy::pedantic, clippy::restriction, reason = \"copies of sources\")]\n\
         pub mod {name} {{ pub use ncp_spec::{{wire, ErrorCode}};\n\
         pub mod safety {{ pub use ncp_spec::safety::{{Decision, Reason, POSITION_CHANNEL, VELOCITY_CHANNEL, METRES, \
         METRES_PER_SECOND}}; pub use ncp_kernel as kernel; {} }}\n\
         pub mod resilience {{ {} {} {} }}\n\
         pub mod control {{ pub use ncp_spec::control::Controller; {} }} }}",
        part("governor", "SafetyGovernor", &spied("SafetyGovernor")),
        part("link_monitor", "LinkMonitor", &spied("LinkMonitor")),
        part("action_buffer", "ActionBuffer", ""),
        if family == "link" { module("link_number") } else { String::new() },
        part("control_loop", "ControlLoop", ""),
    )
}
