//! Puts any shared library with NCP's C ABI behind the peer protocol.
//!
//! It decides nothing: a request's arguments go to one function of the library, what that returns goes
//! back, and what the library does not export is unsupported. It is not linked with any
//! implementation of NCP.
//!
//! - `calls`: one method a call.
//! - `traces`: the calls that hold a whole trace.
//! - `seed`: what the seed's functions can express.
//! - `library`: the library's functions by name. All unsafe code is there.
//!
//! `ncp-adapter` holds the conversation.

#![deny(unsafe_code)]

mod calls;
mod library;
mod seed;
mod traces;

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use crate::library::{Library, LoadError};

const USAGE: &str = "\
Usage: ncp-peer-cpp-adapter [options]

Answers the peer protocol with a shared library that has NCP's C ABI.

  --library PATH   the library; without it, libncp beside this program
  --prefix TEXT    what its functions' names begin with, instead of ncp_
  --name TEXT      what the peer calls itself, instead of the library's name
  --language TEXT  the language that it says it is written in, instead of C
  --roles LIST     the roles that it claims, instead of those whose functions it exports
  --reference-networks
                   it claims the reference networks of section 4.4 of the text
";

fn main() -> ExitCode {
    let result = options(std::env::args().skip(1)).and_then(|options| match options {
        None => {
            print!("{USAGE}");
            Ok(())
        }
        Some(options) => serve(&options),
    });
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("ncp-peer-cpp-adapter: {error}");
            ExitCode::FAILURE
        }
    }
}

/// What the command line says.
#[derive(Debug, Default, PartialEq, Eq)]
struct Options {
    library: Option<PathBuf>,
    prefix: Option<String>,
    name: Option<String>,
    language: Option<String>,
    roles: Option<String>,
    reference_networks: bool,
}

/// Why the program ends without an answer.
#[derive(Debug, thiserror::Error)]
enum Error {
    #[error("{0}\n\n{USAGE}")]
    Usage(String),
    #[error(transparent)]
    Load(#[from] LoadError),
    #[error("the conversation broke off: {0}")]
    Conversation(#[from] io::Error),
}

/// The options, or `None` if help is wanted.
fn options(mut args: impl Iterator<Item = String>) -> Result<Option<Options>, Error> {
    let mut options = Options::default();
    while let Some(option) = args.next() {
        if matches!(option.as_str(), "-h" | "--help") {
            return Ok(None);
        }
        let mut value = || {
            let value = args.next();
            value.ok_or_else(|| Error::Usage(format!("{option} wants a value")))
        };
        match option.as_str() {
            "--library" => options.library = Some(value()?.into()),
            "--prefix" => options.prefix = Some(value()?),
            "--name" => options.name = Some(value()?),
            "--language" => options.language = Some(value()?),
            "--roles" => options.roles = Some(value()?),
            "--reference-networks" => options.reference_networks = true,
            _ => return Err(Error::Usage(format!("`{option}` is no option"))),
        }
    }
    Ok(Some(options))
}

fn serve(options: &Options) -> Result<(), Error> {
    let path = match &options.library {
        Some(path) => path.clone(),
        None => {
            let beside = std::env::current_exe()?;
            beside.with_file_name(libloading::library_filename("ncp"))
        }
    };
    let prefix = options.prefix.as_deref().unwrap_or("ncp_");
    let library = Library::load(&path, prefix)?;
    let file = path.file_stem().unwrap_or_default().to_string_lossy();
    let peer = calls::Peer {
        library: &library,
        name: options.name.as_deref().unwrap_or(&file),
        language: options.language.as_deref().unwrap_or("C"),
        roles: options.roles.as_deref(),
        reference_networks: options.reference_networks,
    };
    Ok(ncp_adapter::serve(&peer)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(args: &[&str]) -> Result<Option<Options>, Error> {
        options(args.iter().map(ToString::to_string))
    }

    #[test]
    fn options_are_read_and_others_are_refused() {
        let read = parsed(&["--library", "a.so", "--reference-networks", "--prefix", "x_"]).unwrap();
        let expected = Options {
            library: Some("a.so".into()),
            prefix: Some("x_".to_owned()),
            reference_networks: true,
            ..Options::default()
        };
        assert_eq!(read, Some(expected));
        assert_eq!(parsed(&["--help"]).unwrap(), None);
        assert!(parsed(&["--library"]).is_err());
        assert!(parsed(&["a.so"]).is_err());
    }
}
