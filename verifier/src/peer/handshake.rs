//! `describe`, the first exchange with every process.

use std::time::{Duration, Instant};

use super::connection::{Connection, Ending, Incoming};
use super::protocol::{Answer, Reply, write_request};
use super::{StartError, excerpt};
use crate::json::Json;
use crate::stop::Stop;

/// How much of a line is shown.
const SHOWN: usize = 200;

/// What a peer says about itself.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Description {
    /// The implementation's name.
    pub name: String,
    /// Its own version.
    pub version: String,
    /// The language that it is written in.
    pub language: String,
    /// The wire version that it states, [NCP-VER-021].
    pub wire_version: String,
    /// The contract hash that it states, [NCP-VER-020].
    pub contract_hash: String,
    /// The roles that it claims, as it spells them.
    pub roles: Vec<String>,
    /// Whether it claims the reference networks of section 4.4 of the text.
    pub reference_networks: bool,
}

/// Asks a process that was just started to describe itself.
///
/// # Errors
/// [`StartError`] if it ends, prints something else, or stays silent for longer than `patience`.
pub fn handshake(connection: &mut Connection, patience: Duration, stop: &Stop) -> Result<Description, StartError> {
    let mut request = Vec::new();
    write_request(&mut request, 0, "\"call\":\"describe\",\"args\":{}}");
    connection.send(request);
    let line = first_line(connection, patience, stop)?;
    let command = || connection.command().to_owned();
    match Reply::parse(&line) {
        Ok(Reply { id: 0, answer: Answer::Result(result) }) => read(&result).map_err(|why| StartError::Description {
            command: command(),
            why,
            line: excerpt(&line, SHOWN),
        }),
        Ok(Reply { id: 0, answer: Answer::Error { code, message } }) => Err(StartError::Description {
            command: command(),
            why: format!("with the error `{code}`, {message:?}"),
            line: excerpt(&line, SHOWN),
        }),
        Ok(Reply { id: 0, answer: Answer::Unsupported }) => Err(StartError::Description {
            command: command(),
            why: "says that it is unsupported".to_owned(),
            line: excerpt(&line, SHOWN),
        }),
        Ok(Reply { id, .. }) => {
            Err(connection.no_answer(&format!("it answers the request {id}, which was not sent"), &line))
        }
        Err(fault) => Err(connection.no_answer(&fault.to_string(), &line)),
    }
}

fn first_line(connection: &mut Connection, patience: Duration, stop: &Stop) -> Result<Vec<u8>, StartError> {
    let deadline = Instant::now() + patience;
    loop {
        if stop.is_set() {
            return Err(StartError::Interrupted);
        }
        match connection.receive(Duration::from_millis(50)) {
            Incoming::Lines(mut lines) => {
                let end = lines.iter().position(|byte| *byte == b'\n').unwrap_or(lines.len());
                let rest = lines.split_off((end + 1).min(lines.len()));
                lines.truncate(end);
                connection.unread(rest);
                return Ok(lines);
            }
            Incoming::Overlong(start) => {
                return Err(connection.no_answer("it prints a line without end", &start));
            }
            Incoming::Partial(line) => {
                return Err(connection.no_answer("its last line has no line feed", &line));
            }
            Incoming::End => {
                let ending = connection.kill();
                let (command, stderr) = (connection.command().to_owned(), connection.log());
                return Err(match ending {
                    Ending::Unreachable(why) => StartError::Unreachable { command, why, stderr },
                    ending => StartError::Ended { command, ending: ending.describe(), stderr },
                });
            }
            // Whoever does not read may still answer, or ends; the next event tells.
            Incoming::Deaf | Incoming::Nothing => {}
        }
        if Instant::now() >= deadline {
            connection.kill();
            return Err(StartError::Silent {
                command: connection.command().to_owned(),
                waited: patience,
                stderr: connection.log(),
            });
        }
    }
}

fn read(result: &Json<'_>) -> Result<Description, String> {
    let text = |name: &str| match result.get(name) {
        Some(Json::String(text)) => Ok(text.clone().into_owned()),
        Some(other) => Err(format!("its `{name}` is {}, not a string", other.kind())),
        None => Err(format!("it lacks `{name}`")),
    };
    let roles = match result.get("roles") {
        Some(Json::Array(roles)) => roles
            .iter()
            .map(|role| {
                role.as_str()
                    .map(str::to_owned)
                    .ok_or_else(|| "its `roles` holds something that is not a string".to_owned())
            })
            .collect::<Result<_, _>>()?,
        Some(other) => return Err(format!("its `roles` is {}, not an array", other.kind())),
        None => return Err("it lacks `roles`".to_owned()),
    };
    let reference_networks = match result.get("reference_networks") {
        Some(Json::Bool(claimed)) => *claimed,
        Some(Json::Null) | None => false,
        Some(other) => {
            return Err(format!("its `reference_networks` is {}, not a boolean", other.kind()));
        }
    };
    Ok(Description {
        name: text("name")?,
        version: text("version")?,
        language: text("language")?,
        wire_version: text("wire_version")?,
        contract_hash: text("contract_hash")?,
        roles,
        reference_networks,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_description_that_lacks_something_is_refused_by_name() {
        let whole =
            r#"{"name":"n","version":"1","language":"C","wire_version":"v","contract_hash":"h","roles":["body"]}"#;
        let description = read(&Json::parse(whole).unwrap()).unwrap();
        assert_eq!((description.name.as_str(), &description.roles), ("n", &vec!["body".to_owned()]));
        for member in ["name", "version", "language", "wire_version", "contract_hash", "roles"] {
            let without = whole.replacen(&format!("\"{member}\""), "\"other\"", 1);
            assert_eq!(read(&Json::parse(&without).unwrap()).unwrap_err(), format!("it lacks `{member}`"));
        }
        let claims = |value: &str| {
            let described = whole.replace('}', &format!(r#","reference_networks":{value}}}"#));
            read(&Json::parse(&described).unwrap()).map(|about| about.reference_networks)
        };
        assert_eq!(claims("true"), Ok(true));
        assert_eq!([claims("false"), claims("null")], [Ok(false), Ok(false)]);
        assert_eq!(claims("1").unwrap_err(), "its `reference_networks` is a number, not a boolean");
        assert!(!description.reference_networks);
        let number = whole.replace("\"1\"", "1");
        assert_eq!(read(&Json::parse(&number).unwrap()).unwrap_err(), "its `version` is a number, not a string");
    }
}
