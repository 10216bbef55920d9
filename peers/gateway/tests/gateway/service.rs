//! A simulation service on a line: the reference one, or whatever a test makes of it.

use std::io::{BufRead, BufReader, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use ncp_spec::session::ReferenceBackend;
use ncp_zenoh::SessionHost;

/// What the service does with a line.
pub(crate) enum Does {
    /// Replies with a line.
    Reply(String),
    /// Replies with a line, later.
    Late(Duration, String),
    /// Writes these bytes, and ends the connection.
    Cut(String),
    /// Writes nothing.
    Nothing,
}

type Script = dyn Fn(&str) -> Does + Send + Sync;

/// The service, until it is dropped.
pub(crate) struct Service {
    pub(crate) address: SocketAddr,
    shared: Arc<Shared>,
}

struct Shared {
    script: Box<Script>,
    /// The lines that came: the number of the connection, and the line.
    lines: Mutex<Vec<(usize, String)>>,
    streams: Mutex<Vec<TcpStream>>,
    is_stopped: AtomicBool,
}

impl Service {
    pub(crate) fn start(script: impl Fn(&str) -> Does + Send + Sync + 'static) -> Self {
        Self::at("127.0.0.1:0".parse().unwrap(), script)
    }

    /// The session service over the reference backend.
    pub(crate) fn reference() -> Self {
        Self::start(reference())
    }

    pub(crate) fn at(address: SocketAddr, script: impl Fn(&str) -> Does + Send + Sync + 'static) -> Self {
        let listener = TcpListener::bind(address).unwrap();
        let address = listener.local_addr().unwrap();
        let shared = Arc::new(Shared {
            script: Box::new(script),
            lines: Mutex::default(),
            streams: Mutex::default(),
            is_stopped: AtomicBool::new(false),
        });
        let accepts = Arc::clone(&shared);
        thread::spawn(move || accepts.accept(&listener));
        Self { address, shared }
    }

    pub(crate) fn lines(&self) -> Vec<(usize, String)> {
        self.shared.lines.lock().unwrap().clone()
    }

    /// Ends it with all its connections, as its death would.
    pub(crate) fn die(self) -> SocketAddr {
        self.address
    }
}

impl Drop for Service {
    fn drop(&mut self) {
        self.shared.is_stopped.store(true, Ordering::SeqCst);
        // Wakes the thread that accepts, which then lets go of the port.
        let _ = TcpStream::connect(self.address);
        for stream in self.shared.streams.lock().unwrap().drain(..) {
            let _ = stream.shutdown(Shutdown::Both);
        }
        crate::until("the port is free", || TcpStream::connect(self.address).is_err());
    }
}

impl Shared {
    fn accept(self: Arc<Self>, listener: &TcpListener) {
        for (number, stream) in listener.incoming().enumerate() {
            if self.is_stopped.load(Ordering::SeqCst) {
                return;
            }
            let stream = stream.unwrap();
            self.streams.lock().unwrap().push(stream.try_clone().unwrap());
            let shared = Arc::clone(&self);
            thread::spawn(move || shared.talk(number, stream));
        }
    }

    /// What a connection that ends loses is what tests are about.
    fn talk(&self, number: usize, mut stream: TcpStream) -> Option<()> {
        for line in BufReader::new(stream.try_clone().ok()?).lines() {
            let line = line.ok()?;
            self.lines.lock().unwrap().push((number, line.clone()));
            match (self.script)(&line) {
                Does::Reply(reply) => writeln!(stream, "{reply}").ok()?,
                Does::Late(after, reply) => {
                    thread::sleep(after);
                    writeln!(stream, "{reply}").ok()?;
                }
                Does::Cut(bytes) => {
                    stream.write_all(bytes.as_bytes()).ok()?;
                    stream.shutdown(Shutdown::Both).ok()?;
                    return None;
                }
                Does::Nothing => {}
            }
        }
        Some(())
    }
}

/// A script that does as the reference service.
pub(crate) fn reference() -> impl Fn(&str) -> Does + Send + Sync {
    let host = SessionHost::new(|| ReferenceBackend);
    move |line| Does::Reply(host.serve(line.as_bytes()))
}
