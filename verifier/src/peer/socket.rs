//! The road to a peer that listens: a TCP connection, with lines or the text frames of WebSocket on it.
//!
//! Whatever a server does, [`Socket::close`] ends the threads that serve it: they wait for nothing but the connection.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, SyncSender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use tungstenite::error::ProtocolError;
use tungstenite::protocol::frame::Frame;
use tungstenite::protocol::frame::coding::{Data, OpCode};
use tungstenite::{Error, Message, WebSocket};

use super::address::{Address, Framing};
use super::connection::{Incoming, Outgoing, PIECE, read_lines};

/// How long one attempt to connect may take.
const ATTEMPT: Duration = Duration::from_secs(2);
/// How long to wait before the next.
const PAUSE: Duration = Duration::from_millis(20);
/// How many bytes of pongs and the like a server may ask for; then it gets none any more.
const REPLY_BYTES: usize = 1 << 20;

/// One connection to a server, from the first attempt on.
#[derive(Debug, Default)]
pub(super) struct Socket(Mutex<State>);

#[derive(Debug, Default)]
struct State {
    stream: Option<TcpStream>,
    closed: bool,
    unreachable: Option<String>,
}

/// What serves a connection to a server.
pub(super) struct Service {
    pub(super) address: Address,
    /// How long the server may take until it listens.
    pub(super) patience: Duration,
    pub(super) socket: Arc<Socket>,
    /// What is to be written, and by whom it may be extended.
    pub(super) to_write: Receiver<Outgoing>,
    pub(super) replies: Sender<Outgoing>,
    pub(super) line_limit: Arc<AtomicUsize>,
    pub(super) events: SyncSender<Incoming>,
}

impl Socket {
    /// Ends the connection at once, or whatever would become one.
    pub(super) fn close(&self) {
        let mut state = self.state();
        state.closed = true;
        if let Some(stream) = &state.stream {
            // It may be gone already.
            let _ = stream.shutdown(Shutdown::Both);
        }
    }

    /// Why there never was a connection, if that is so.
    pub(super) fn unreachable(&self) -> Option<String> {
        self.state().unreachable.clone()
    }

    fn is_closed(&self) -> bool {
        self.state().closed
    }

    /// Keeps a connection, so that it can be closed from outside.
    fn opened(&self, stream: &TcpStream) -> io::Result<()> {
        let mut state = self.state();
        if state.closed {
            return Err(io::ErrorKind::ConnectionAborted.into());
        }
        state.stream = Some(stream.try_clone()?);
        Ok(())
    }

    fn state(&self) -> std::sync::MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Service {
    /// Connects, then writes what is sent and hands on what comes, until the connection ends.
    pub(super) fn serve(self) {
        let Self { address, patience, socket, to_write, replies, line_limit, events } = self;
        let end = |why: String| {
            socket.state().unreachable = Some(why);
            let _ = events.send(Incoming::End);
        };
        let halves = connect(&address, patience, &socket).and_then(|stream| Ok((stream.try_clone()?, stream)));
        let (stream, writing) = match halves {
            Ok(halves) => halves,
            Err(error) => return end(error.to_string()),
        };
        match address.framing {
            Framing::Lines => {
                drop(replies);
                thread::spawn(move || write(writing, &to_write));
                read_lines(stream, &line_limit, &events);
            }
            Framing::WebSocket => match shake_hands(&address, stream) {
                Ok(mut web) => {
                    web.get_mut().replies = Some((replies, REPLY_BYTES));
                    thread::spawn(move || write(writing, &to_write));
                    read_messages(web, &line_limit, &events);
                }
                Err(error) => end(format!("the WebSocket handshake failed: {error}")),
            },
        }
    }
}

/// A line as it travels in a text frame; none: the frame that says that no more will come.
pub(super) fn frame(line: Option<&[u8]>) -> Vec<u8> {
    let mut frame = match line {
        Some(line) => Frame::message(line.to_vec(), OpCode::Data(Data::Text), true),
        None => Frame::close(None),
    };
    // The mask guards proxies against what a browser sends; here any will do.
    let mut mask = [0; 4];
    let _ = getrandom::fill(&mut mask);
    frame.header_mut().mask = Some(mask);
    let mut bytes = Vec::with_capacity(frame.len());
    // Writing to memory does not fail.
    let _ = frame.format(&mut bytes);
    bytes
}

/// Whether something accepts connections there.
pub(super) fn is_taken(address: &Address) -> bool {
    let addresses = address.resolve().unwrap_or_default();
    addresses.iter().any(|address| TcpStream::connect_timeout(address, ATTEMPT).is_ok())
}

fn connect(address: &Address, patience: Duration, socket: &Socket) -> io::Result<TcpStream> {
    let deadline = Instant::now() + patience;
    loop {
        let mut last = io::Error::from(io::ErrorKind::NotFound);
        let addresses = address.resolve().map_err(|error| last = error).unwrap_or_default();
        for address in addresses {
            match TcpStream::connect_timeout(&address, ATTEMPT) {
                Ok(stream) => {
                    stream.set_nodelay(true)?;
                    socket.opened(&stream)?;
                    return Ok(stream);
                }
                Err(error) => last = error,
            }
        }
        if socket.is_closed() || Instant::now() >= deadline {
            return Err(last);
        }
        thread::sleep(PAUSE);
    }
}

/// Writes until nothing more will come, or the connection is gone: then the reader sees it, too.
fn write(mut stream: TcpStream, to_write: &Receiver<Outgoing>) {
    for outgoing in to_write {
        if outgoing.write_to(&mut stream).is_err() {
            return;
        }
    }
    let _ = stream.shutdown(Shutdown::Write);
}

fn shake_hands(address: &Address, stream: TcpStream) -> Result<WebSocket<Half>, String> {
    let half = Half { stream, read: Vec::new(), taken: 0, replies: None };
    let done = tungstenite::client(address.to_string(), half);
    done.map(|(web, _)| web).map_err(|error| error.to_string())
}

/// The half of a connection from which frames are read. It neither waits nor writes itself once the handshake is done:
/// [`fill`](Self::fill) waits, so that the limit of a message is the one of the time when it arrives, and what is to be
/// written goes to the one who writes.
#[derive(Debug)]
struct Half {
    stream: TcpStream,
    read: Vec<u8>,
    taken: usize,
    /// Who writes, and how many bytes more he is given. None during the handshake.
    replies: Option<(Sender<Outgoing>, usize)>,
}

impl Half {
    /// Waits for bytes; whether any came.
    fn fill(&mut self) -> bool {
        self.read.resize(PIECE, 0);
        self.taken = 0;
        let count = loop {
            match self.stream.read(&mut self.read) {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                read => break read.unwrap_or_default(),
            }
        };
        self.read.truncate(count);
        count > 0
    }
}

impl Read for Half {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.replies.is_none() {
            return self.stream.read(buffer);
        }
        let rest = &self.read[self.taken..];
        if rest.is_empty() {
            return Err(io::ErrorKind::WouldBlock.into());
        }
        let count = rest.len().min(buffer.len());
        buffer[..count].copy_from_slice(&rest[..count]);
        self.taken += count;
        Ok(count)
    }
}

impl Write for Half {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let Some((replies, left)) = &mut self.replies else { return self.stream.write(bytes) };
        if *left >= bytes.len() {
            *left -= bytes.len();
            // Whoever writes may have ended; the reader sees why.
            let _ = replies.send(Outgoing::Bytes(bytes.to_vec()));
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Hands on each text frame as a line, and what is none as a line that is no answer.
fn read_messages(mut web: WebSocket<Half>, limit: &AtomicUsize, events: &SyncSender<Incoming>) {
    let mut lines = Vec::new();
    loop {
        let most = Some(limit.load(Ordering::Relaxed));
        web.set_config(|config| (config.max_message_size, config.max_frame_size) = (most, most));
        let ended = match web.read() {
            Ok(Message::Text(text)) => {
                lines.extend_from_slice(text.as_bytes());
                lines.push(b'\n');
                false
            }
            Ok(Message::Binary(bytes)) => {
                lines.extend_from_slice(format!("a binary frame of {} bytes\n", bytes.len()).as_bytes());
                false
            }
            Ok(_) => false,
            Err(Error::Io(error)) if error.kind() == io::ErrorKind::WouldBlock => {
                if !lines.is_empty() && events.send(Incoming::Lines(std::mem::take(&mut lines))).is_err() {
                    return;
                }
                !web.get_mut().fill()
            }
            Err(Error::Capacity(_)) => {
                if lines.is_empty() || events.send(Incoming::Lines(lines)).is_ok() {
                    let _ = events.send(Incoming::Overlong(Vec::new()));
                }
                return;
            }
            Err(
                Error::ConnectionClosed
                | Error::AlreadyClosed
                | Error::Io(_)
                | Error::Protocol(ProtocolError::ResetWithoutClosingHandshake),
            ) => true,
            Err(error) => {
                lines.extend_from_slice(format!("no frame of WebSocket: {error}\n").as_bytes());
                true
            }
        };
        if ended || lines.len() >= PIECE {
            let sent = lines.is_empty() || events.send(Incoming::Lines(std::mem::take(&mut lines))).is_ok();
            if ended && sent {
                let _ = events.send(Incoming::End);
            }
            if ended || !sent {
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::net::TcpListener;
    use std::sync::mpsc::{channel, sync_channel};

    use super::*;

    /// What a connection to a server shows that does this with it.
    fn seen(url: &str, server: impl FnOnce(TcpStream) + Send + 'static) -> (Vec<Incoming>, Option<String>) {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = listener.local_addr().unwrap().port().to_string();
        thread::spawn(move || server(listener.accept().unwrap().0));
        let (replies, to_write) = channel();
        let (events, incoming) = sync_channel(16);
        let socket = Arc::new(Socket::default());
        let service = Service {
            address: Address::parse(&url.replace("PORT", &port)).unwrap(),
            patience: Duration::from_secs(5),
            socket: Arc::clone(&socket),
            to_write,
            replies,
            line_limit: Arc::new(AtomicUsize::new(1000)),
            events,
        };
        thread::spawn(move || service.serve());
        (incoming.iter().collect(), socket.unreachable())
    }

    fn web(server: impl FnOnce(WebSocket<TcpStream>) + Send + 'static) -> Vec<Incoming> {
        let (events, unreachable) = seen("ws://127.0.0.1:PORT/ncp", |stream| {
            server(tungstenite::accept(stream).unwrap());
        });
        assert_eq!(unreachable, None);
        events
    }

    fn text(event: &Incoming) -> &str {
        match event {
            Incoming::Lines(lines) => std::str::from_utf8(lines).unwrap(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn each_text_frame_is_a_line_and_a_ping_is_answered() {
        let events = web(|mut web| {
            web.send(Message::Ping("beat".into())).unwrap();
            assert_eq!(web.read().unwrap(), Message::Pong("beat".into()));
            web.send("one".into()).unwrap();
            web.close(None).unwrap();
            assert!(matches!(web.read(), Ok(Message::Close(_))));
        });
        let [lines, Incoming::End] = &events[..] else { panic!("{events:?}") };
        assert_eq!(text(lines), "one\n");
    }

    #[test]
    fn a_frame_that_is_no_text_is_a_line_that_is_no_answer() {
        let events = web(|mut web| web.send(Message::Binary(vec![1, 2].into())).unwrap());
        assert_eq!(text(&events[0]), "a binary frame of 2 bytes\n");
        let events = web(|mut web| web.get_mut().write_all(b"\x81\x02\xff\xff").unwrap());
        assert!(text(&events[0]).starts_with("no frame of WebSocket: "), "{events:?}");
    }

    #[test]
    fn a_frame_beyond_the_limit_is_given_up_at_its_header() {
        let events = web(|mut web| {
            // A gigabyte is announced, and never comes.
            web.get_mut().write_all(b"\x81\x7f\0\0\0\0\x40\0\0\0").unwrap();
            let _ = web.read();
        });
        assert!(matches!(&events[..], [Incoming::Overlong(_)]), "{events:?}");
    }

    #[test]
    fn a_flood_of_pings_is_no_flood_of_memory() {
        let (replies, written) = channel();
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let stream = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
        let mut half = Half { stream, read: Vec::new(), taken: 0, replies: Some((replies, REPLY_BYTES)) };
        for _ in 0..(10 << 20) / 1024 {
            half.write_all(&[0; 1024]).unwrap();
        }
        drop(half);
        let mut bytes = Vec::new();
        written.iter().for_each(|outgoing| outgoing.write_to(&mut bytes).unwrap());
        assert_eq!(bytes.len(), REPLY_BYTES);
    }

    #[test]
    fn a_server_that_speaks_something_else_is_unreachable() {
        let (events, unreachable) = seen("ws://127.0.0.1:PORT/", |mut stream| {
            stream.write_all(b"HTTP/1.1 404 Not Found\r\n\r\n").unwrap();
        });
        assert!(matches!(&events[..], [Incoming::End]), "{events:?}");
        assert!(unreachable.unwrap().contains("404"), "the handshake");
    }
}
