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
use tungstenite::protocol::frame::coding::{CloseCode, Data, OpCode};
use tungstenite::protocol::frame::{CloseFrame, Frame};
use tungstenite::{Error, Message, WebSocket};

use super::address::{Address, Framing};
use super::connection::{Incoming, Outgoing, PIECE, read_lines};
use super::excerpt;

/// How long one attempt to connect may take.
const ATTEMPT: Duration = Duration::from_secs(2);
/// How long to wait before the next.
const PAUSE: Duration = Duration::from_millis(20);
/// How many bytes of pongs and the like a server may ask for; then it gets none any more.
const REPLY_BYTES: usize = 1 << 20;
/// How much of what a server says at its end is shown.
const SHOWN: usize = 200;

/// One connection to a server, from the first attempt on.
#[derive(Debug, Default)]
pub(super) struct Socket(Mutex<State>);

#[derive(Debug, Default)]
struct State {
    stream: Option<TcpStream>,
    closed: bool,
    unreachable: Option<String>,
    last_words: Option<String>,
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

    /// Why the server says that it closed the connection, if it does.
    pub(super) fn last_words(&self) -> Option<String> {
        self.state().last_words.clone()
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
                    read_messages(web, &line_limit, &events, &socket);
                }
                Err(error) => end(format!("the WebSocket handshake failed: {error}")),
            },
        }
    }
}

/// A line as it travels, in one text frame.
pub(super) fn frame(line: &[u8]) -> Vec<u8> {
    masked(Frame::message(line.to_vec(), OpCode::Data(Data::Text), true))
}

/// The frame that says that no more will come.
pub(super) fn close_frame() -> Vec<u8> {
    masked(Frame::close(None))
}

/// Takes a line that is made while it is sent, and sends it as a message of many frames.
pub(super) struct Fragments<W> {
    out: W,
    held: Vec<u8>,
    is_first: bool,
}

impl<W: Write> Fragments<W> {
    pub(super) fn new(out: W) -> Self {
        Self { out, held: Vec::with_capacity(PIECE), is_first: true }
    }

    /// Sends what is left, without the line feed.
    pub(super) fn finish(mut self) -> io::Result<()> {
        self.held.pop_if(|byte| *byte == b'\n');
        self.send(true)
    }

    fn send(&mut self, is_last: bool) -> io::Result<()> {
        let kind = if std::mem::take(&mut self.is_first) { Data::Text } else { Data::Continue };
        let piece = std::mem::replace(&mut self.held, Vec::with_capacity(PIECE));
        self.out.write_all(&masked(Frame::message(piece, OpCode::Data(kind), is_last)))
    }
}

impl<W: Write> Write for Fragments<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // Only when more comes, so that the line feed at the end is still held when it is over.
        if !bytes.is_empty() && self.held.len() >= PIECE {
            self.send(false)?;
        }
        let count = bytes.len().min(PIECE - self.held.len());
        self.held.extend_from_slice(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

fn masked(mut frame: Frame) -> Vec<u8> {
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
                // Where nobody listens yet, a connection may be one to itself, and takes the port from the server.
                Ok(stream) if stream.local_addr().ok() == stream.peer_addr().ok() => {
                    last = io::ErrorKind::ConnectionRefused.into();
                }
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
fn read_messages(mut web: WebSocket<Half>, limit: &AtomicUsize, events: &SyncSender<Incoming>, socket: &Socket) {
    let mut lines = Vec::new();
    loop {
        let most = Some(limit.load(Ordering::Relaxed));
        web.set_config(|config| (config.max_message_size, config.max_frame_size) = (most, most));
        let ended = match web.read() {
            Ok(Message::Text(text)) if text.contains('\n') => {
                lines.extend_from_slice(
                    b"a text frame with a line feed in it, where one JSON document on one line belongs\n",
                );
                false
            }
            Ok(Message::Text(text)) => {
                lines.extend_from_slice(text.as_bytes());
                lines.push(b'\n');
                false
            }
            Ok(Message::Binary(bytes)) => {
                lines.extend_from_slice(format!("a binary frame of {} bytes\n", bytes.len()).as_bytes());
                false
            }
            // No data may follow, and whether the server waits for us to close the connection does not matter.
            Ok(Message::Close(frame)) => {
                socket.state().last_words = frame.map(|frame| last_words(&frame));
                let _ = web.flush();
                true
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

/// What a close frame says.
fn last_words(frame: &CloseFrame) -> String {
    let reason = excerpt(frame.reason.as_bytes(), SHOWN);
    let advice = if frame.code == CloseCode::Size { ": its limit for messages has to be raised" } else { "" };
    match reason.as_str() {
        "" => format!("code {}{advice}", frame.code),
        reason => format!("code {}, {reason}{advice}", frame.code),
    }
}

#[cfg(test)]
mod tests {
    use std::net::TcpListener;
    use std::sync::mpsc::{channel, sync_channel};

    use super::*;

    /// What a connection to a server shows that does this with it.
    fn seen(url: &str, server: impl FnOnce(TcpStream) + Send + 'static) -> (Vec<Incoming>, Arc<Socket>) {
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
        (incoming.iter().collect(), socket)
    }

    fn web(server: impl FnOnce(WebSocket<TcpStream>) + Send + 'static) -> Vec<Incoming> {
        let (events, socket) = seen("ws://127.0.0.1:PORT/ncp", |stream| {
            server(tungstenite::accept(stream).unwrap());
        });
        assert_eq!(socket.unreachable(), None);
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
    fn a_frame_with_several_lines_is_no_answer() {
        for sent in ["{\"id\":1}\n{\"id\":2}", "{\"id\":1}\n"] {
            let events = web(|mut web| web.send(sent.into()).unwrap());
            assert!(text(&events[0]).starts_with("a text frame with a line feed in it"), "{events:?}");
        }
    }

    #[test]
    fn the_end_comes_with_the_close_frame_and_its_reason_is_kept() {
        let close = |code: CloseCode, reason: &'static str| {
            let (held, hold) = channel::<()>();
            let (events, socket) = seen("ws://127.0.0.1:PORT/ncp", move |stream| {
                let mut web = tungstenite::accept(stream).unwrap();
                web.close(Some(CloseFrame { code, reason: reason.into() })).unwrap();
                // It waits for the other side to close the connection.
                let _ = hold.recv();
            });
            drop(held);
            assert!(matches!(&events[..], [Incoming::End]), "{events:?}");
            socket.last_words()
        };
        assert_eq!(close(CloseCode::Error, "a panic").as_deref(), Some("code 1011, a panic"));
        let raised = "code 1009: its limit for messages has to be raised";
        assert_eq!(close(CloseCode::Size, "").as_deref(), Some(raised));
    }

    #[test]
    fn a_line_that_is_made_while_it_is_sent_arrives_as_one_message_without_its_line_feed() {
        for length in [0, 1, PIECE - 1, PIECE, PIECE + 1, 3 * PIECE, (3 << 20) + 7] {
            let line: Vec<u8> = (0..length).map(|at| b'a' + u8::try_from(at % 23).unwrap()).collect();
            let mut sent = Vec::new();
            let mut fragments = Fragments::new(&mut sent);
            // In pieces of any length.
            line.chunks(1000).for_each(|chunk| fragments.write_all(chunk).unwrap());
            fragments.write_all(b"\n").unwrap();
            fragments.finish().unwrap();
            let mut web = WebSocket::from_raw_socket(io::Cursor::new(sent), tungstenite::protocol::Role::Server, None);
            let message = web.read().unwrap();
            assert_eq!(message, Message::Text(String::from_utf8(line).unwrap().into()), "{length}");
        }
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
        let (events, socket) = seen("ws://127.0.0.1:PORT/", |mut stream| {
            stream.write_all(b"HTTP/1.1 404 Not Found\r\n\r\n").unwrap();
        });
        assert!(matches!(&events[..], [Incoming::End]), "{events:?}");
        assert!(socket.unreachable().unwrap().contains("404"), "the handshake");
    }
}
