//! What a shell and its user want of a program: completions, and manual pages.

use std::io;
use std::path::{Path, PathBuf};

use clap::{Args, Command, CommandFactory as _};
use clap_complete::Shell;
use clap_mangen::Man;
use clap_mangen::roff::{Roff, roman};

use super::check::write;
use super::{Cli, CliError, print};
use crate::report::Exit;

const NAME: &str = "ncp-verify";

pub(super) const COMPLETIONS_HELP: &str = "\
Examples:
  ncp-verify completions bash > ~/.local/share/bash-completion/completions/ncp-verify
  ncp-verify completions zsh > ~/.zfunc/_ncp-verify
  ncp-verify completions fish > ~/.config/fish/completions/ncp-verify.fish
  ncp-verify completions powershell >> $PROFILE";

pub(super) const MAN_HELP: &str = "\
Examples:
  ncp-verify man ~/.local/share/man/man1
  ncp-verify man > ncp-verify.1";

#[derive(Debug, Args)]
pub(super) struct CompletionsArgs {
    /// The shell
    shell: Shell,
}

#[derive(Debug, Args)]
pub(super) struct ManArgs {
    /// The folder that gets a page for the program and one for each command [default: print the program's]
    folder: Option<PathBuf>,
}

/// Prints what completes the command line in a shell.
pub(super) fn completions(args: &CompletionsArgs) -> Result<Exit, CliError> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), NAME, &mut script);
    // For bash, clap_complete 4.6.11 spells a program with a hyphen in two ways, and then completes nothing.
    print(&String::from_utf8_lossy(&script).replace("ncp__subcmd__verify", "ncp__verify"))?;
    Ok(Exit::Conformant)
}

/// Prints the manual page of the program, or writes those of all commands.
pub(super) fn man(args: &ManArgs) -> Result<Exit, CliError> {
    match &args.folder {
        Some(folder) => pages(built(), folder)?,
        None => print(&page(built())?.1)?,
    }
    Ok(Exit::Conformant)
}

/// The command line, with its commands named as their pages are.
fn built() -> Command {
    let mut command = Cli::command().disable_help_subcommand(true);
    command.build();
    command
}

fn pages(command: Command, folder: &Path) -> Result<(), CliError> {
    for subcommand in command.get_subcommands() {
        pages(subcommand.clone(), folder)?;
    }
    let (name, text) = page(command)?;
    write(&folder.join(name), &text)
}

/// The name and the text of the page of one command.
fn page(command: Command) -> Result<(String, String), CliError> {
    let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
    let has_commands = command.has_subcommands();
    let man = Man::new(command).source(format!("{NAME} {}", env!("CARGO_PKG_VERSION"))).manual("NCP conformance");
    let mut text = Vec::new();
    let mut render = || -> io::Result<()> {
        man.render_title(&mut text)?;
        man.render_name_section(&mut text)?;
        man.render_synopsis_section(&mut text)?;
        man.render_description_section(&mut text)?;
        man.render_options_section(&mut text)?;
        if has_commands {
            man.render_subcommands_section(&mut text)?;
        }
        sections(&help).to_writer(&mut text)
    };
    render().map_err(|error| CliError::Harness(format!("the manual page: {error}")))?;
    Ok((man.get_filename(), String::from_utf8_lossy(&text).into_owned()))
}

/// What stands below a help: a block under a heading is a section, whose lines stay as they are; all else is notes.
fn sections(help: &str) -> Roff {
    let mut roff = Roff::new();
    let mut is_notes = false;
    for block in help.split("\n\n").filter(|block| !block.is_empty()) {
        if let Some((heading, lines)) = block.split_once(":\n") {
            roff.control("SH", [heading.to_uppercase().as_str()]).control("nf", []);
            for line in lines.lines() {
                roff.text([roman(line.strip_prefix("  ").unwrap_or(line))]);
            }
            roff.control("fi", []);
            is_notes = false;
        } else {
            if !is_notes {
                roff.control("SH", ["NOTES"]);
            }
            roff.text([roman(block.replace('\n', " "))]);
            is_notes = true;
        }
    }
    roff
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_has_a_page_that_is_named_after_it() {
        let folder = tempfile::tempdir().unwrap();
        pages(built(), folder.path()).unwrap();
        let commands = Cli::command();
        let names = commands.get_subcommands().map(|command| format!("ncp-verify-{}.1", command.get_name()));
        for name in names.chain(["ncp-verify.1".to_owned()]) {
            let page =
                std::fs::read_to_string(folder.path().join(&name)).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(page.contains(".SH SYNOPSIS"), "{name}");
        }
    }

    #[test]
    fn examples_keep_their_lines_and_sentences_are_filled() {
        let page = sections("A sentence\nthat goes on.\n\nExit codes:\n  0  it holds\n  1  it does not").to_roff();
        assert!(page.contains(".SH NOTES\nA sentence that goes on.\n"), "{page}");
        assert!(page.contains(".SH \"EXIT CODES\"\n.nf\n0  it holds\n1  it does not\n.fi"), "{page}");
    }
}
