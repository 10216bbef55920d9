//! Puts a peer that speaks on its standard streams behind an address: `listen ADDRESS COMMAND…`. Each connection gets a
//! process of its own, and ends with it.
//!
//! What the process prints goes out as it is: on WebSocket, a line that is not UTF-8 becomes a text frame that is not,
//! a line without end a message without end, and a half line a half frame.

#![forbid(unsafe_code)]

use std::io::{BufRead as _, BufReader, Read as _, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::os::fd::OwnedFd;
use std::process::{Command, ExitCode, Stdio};
use std::thread;

use tungstenite::protocol::Role;
use tungstenite::protocol::frame::Frame;
use tungstenite::protocol::frame::coding::{Data, OpCode};
use tungstenite::{Message, WebSocket};

/// A longer piece of a line goes out before its end is known.
const PIECE: u64 = 1 << 20;

type Failed = Box<dyn std::error::Error + Send + Sync>;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match args.split_first().map(|(address, command)| listen(address, command)) {
        Some(Ok(())) => ExitCode::SUCCESS,
        Some(Err(error)) => {
            eprintln!("listen: {error}");
            ExitCode::FAILURE
        }
        None => ExitCode::from(2),
    }
}

fn listen(address: &str, command: &[String]) -> Result<(), Failed> {
    let (scheme, rest) = address.split_once("://").ok_or("tcp:// or ws://")?;
    let listener = TcpListener::bind(rest.split('/').next().unwrap_or_default())?;
    for stream in listener.incoming() {
        let (stream, command, is_web) = (stream?, command.to_vec(), scheme == "ws");
        thread::spawn(move || {
            // The other side sees that it ended, however it did.
            let _ = if is_web { frames(&stream, &command) } else { lines(stream, &command) };
        });
    }
    Ok(())
}

fn program(command: &[String]) -> Result<Command, Failed> {
    let (program, args) = command.split_first().ok_or("name a command")?;
    let mut program = Command::new(program);
    program.args(args);
    Ok(program)
}

/// The process has the connection as its standard streams.
fn lines(stream: TcpStream, command: &[String]) -> Result<(), Failed> {
    let out = OwnedFd::from(stream.try_clone()?);
    let mut program = program(command)?;
    let mut child = program.stdin(OwnedFd::from(stream)).stdout(out).spawn()?;
    drop(program);
    child.wait()?;
    Ok(())
}

/// Each text frame is a line of its input, each line of its output a text frame.
fn frames(stream: &TcpStream, command: &[String]) -> Result<(), Failed> {
    let mut web = tungstenite::accept(stream.try_clone()?)?;
    web.set_config(|config| (config.max_message_size, config.max_frame_size) = (None, None));
    let mut child = program(command)?.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    let (Some(mut input), Some(output)) = (child.stdin.take(), child.stdout.take()) else { return Ok(()) };
    let out = stream.try_clone()?;
    let sending = thread::spawn(move || {
        let _ = send(BufReader::new(output), &out);
        let _ = out.shutdown(Shutdown::Both);
    });
    while let Ok(Message::Text(text)) = web.read() {
        if input.write_all(text.as_bytes()).and_then(|()| input.write_all(b"\n")).is_err() {
            break;
        }
    }
    drop(input);
    let _ = child.wait();
    let _ = sending.join();
    Ok(())
}

fn send(mut output: BufReader<impl std::io::Read>, mut stream: &TcpStream) -> Result<(), Failed> {
    let mut is_first = true;
    let mut piece = Vec::new();
    while output.by_ref().take(PIECE).read_until(b'\n', &mut piece)? > 0 {
        let is_last = piece.pop_if(|byte| *byte == b'\n').is_some();
        let kind = if is_first { Data::Text } else { Data::Continue };
        let mut bytes = Vec::new();
        Frame::message(std::mem::take(&mut piece), OpCode::Data(kind), is_last).format(&mut bytes)?;
        if !is_last && output.fill_buf()?.is_empty() {
            bytes.pop();
        }
        stream.write_all(&bytes)?;
        is_first = is_last;
    }
    // In peace, with the frame that says so.
    if is_first {
        WebSocket::from_raw_socket(stream, Role::Server, None).close(None)?;
    }
    Ok(())
}
