//! A peer in this process, as one that listens: a thread a connection, on the loopback.
//!
//! So the one runner judges it as it judges every peer: a connection that breaks off is a crash, silence a timeout.

use std::io::{self, BufReader, BufWriter};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::thread;

/// Where requests come from.
pub type Input = BufReader<TcpStream>;
/// Where answers go.
pub type Output = BufWriter<TcpStream>;

/// Answers all requests of an input.
pub(crate) type Conversation = dyn Fn(Input, Output) -> io::Result<()> + Send + Sync;

/// As much as a socket hands over at once, in bytes.
const BUFFER: usize = 64 << 10;
/// As much as a program's main thread has, in bytes.
const STACK: usize = 8 << 20;

/// Listens, and answers whoever connects until the process ends.
pub(crate) fn serve(conversation: Arc<Conversation>) -> io::Result<SocketAddr> {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
    let address = listener.local_addr()?;
    thread::spawn(move || {
        for stream in listener.incoming().map_while(Result::ok) {
            let conversation = Arc::clone(&conversation);
            let named = thread::Builder::new().name("peer".to_owned()).stack_size(STACK);
            // What breaks off is seen at the other end of the connection; a panic says why on standard error.
            let _ = named.spawn(move || answer(stream, &*conversation));
        }
    });
    Ok(address)
}

fn answer(stream: TcpStream, conversation: &Conversation) -> io::Result<()> {
    stream.set_nodelay(true)?;
    let input = BufReader::with_capacity(BUFFER, stream.try_clone()?);
    conversation(input, BufWriter::with_capacity(BUFFER, stream))
}
