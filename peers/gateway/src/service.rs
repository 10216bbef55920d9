//! The other end of the bridge: a service that answers lines. It is for simulators in Rust, and for those who want to
//! see what a gateway does with one that fails.

use std::io::{self, BufRead, BufReader, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use ncp_spec::session::ReferenceBackend;
use ncp_zenoh::SessionHost;

/// What the service does with a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Does {
    /// Replies with a line.
    Reply(String),
    /// Replies with a line, later.
    Late(Duration, String),
    /// Writes this without a line feed, and ends the connection.
    Cut(String),
    /// Writes nothing.
    Nothing,
}

type Script = dyn Fn(&str) -> Does + Send + Sync;

/// A service on a line until it is dropped, which ends its connections and frees its address, as its death would.
pub struct LineService {
    address: SocketAddr,
    shared: Arc<Shared>,
    accepts: Option<JoinHandle<()>>,
}

struct Shared {
    script: Box<Script>,
    lines: Mutex<Vec<(usize, String)>>,
    streams: Mutex<Vec<TcpStream>>,
    is_stopped: AtomicBool,
}

impl LineService {
    /// Listens on an address; each connection has a thread, and the lines of one are answered in their order.
    ///
    /// # Errors
    /// The address is taken.
    pub fn start(address: SocketAddr, script: impl Fn(&str) -> Does + Send + Sync + 'static) -> io::Result<Self> {
        let listener = TcpListener::bind(address)?;
        let address = listener.local_addr()?;
        let shared = Arc::new(Shared {
            script: Box::new(script),
            lines: Mutex::default(),
            streams: Mutex::default(),
            is_stopped: AtomicBool::new(false),
        });
        let of_thread = Arc::clone(&shared);
        let accepts = Some(thread::spawn(move || of_thread.accept(&listener)));
        Ok(Self { address, shared, accepts })
    }

    /// The session service over the reference backend.
    ///
    /// # Errors
    /// The address is taken.
    pub fn reference(address: SocketAddr) -> io::Result<Self> {
        let host = SessionHost::new(|| ReferenceBackend);
        Self::start(address, move |line| Does::Reply(host.serve(line.as_bytes())))
    }

    /// Where it listens.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// The lines that came, each with the number of its connection, from 0.
    #[must_use]
    pub fn lines(&self) -> Vec<(usize, String)> {
        lock(&self.shared.lines).clone()
    }
}

impl Drop for LineService {
    fn drop(&mut self) {
        self.shared.is_stopped.store(true, Ordering::SeqCst);
        // Wakes the thread that accepts, which then lets go of the address.
        let is_woken = TcpStream::connect(self.address).is_ok();
        if let Some(accepts) = self.accepts.take().filter(|_| is_woken) {
            // What it panicked of, it has printed.
            let _ = accepts.join();
        }
        for stream in lock(&self.shared.streams).drain(..) {
            // One that has ended needs no end.
            let _ = stream.shutdown(Shutdown::Both);
        }
    }
}

impl Shared {
    fn accept(self: Arc<Self>, listener: &TcpListener) {
        for (number, stream) in listener.incoming().enumerate() {
            if self.is_stopped.load(Ordering::SeqCst) {
                return;
            }
            let Ok(stream) = stream else { continue };
            if let Ok(kept) = stream.try_clone() {
                lock(&self.streams).push(kept);
            }
            let shared = Arc::clone(&self);
            // A connection that ends has no more lines to answer.
            thread::spawn(move || shared.talk(number, stream).unwrap_or_default());
        }
    }

    fn talk(&self, number: usize, mut stream: TcpStream) -> io::Result<()> {
        stream.set_nodelay(true)?;
        for line in BufReader::new(stream.try_clone()?).lines() {
            let line = line?;
            lock(&self.lines).push((number, line.clone()));
            match (self.script)(&line) {
                Does::Reply(reply) => stream.write_all((reply + "\n").as_bytes())?,
                Does::Late(after, reply) => {
                    thread::sleep(after);
                    stream.write_all((reply + "\n").as_bytes())?;
                }
                Does::Cut(bytes) => {
                    stream.write_all(bytes.as_bytes())?;
                    return stream.shutdown(Shutdown::Both);
                }
                Does::Nothing => {}
            }
        }
        Ok(())
    }
}

/// What a thread that panicked left is whole: each change is one call.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
