//! One connection to the simulation service: a request a line, a reply a line, one at a time.

use std::io;
use std::mem::MaybeUninit;

use ncp_spec::wire::MAX_OBSERVATION_BYTES;
use socket2::SockRef;
use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader};
use tokio::net::TcpStream;

use crate::failure::Failure;

/// The longest reply, without its line feed: no frame is longer. `[NCP-WIRE-062]`
const MAX_REPLY_BYTES: usize = MAX_OBSERVATION_BYTES;

/// How much is read at once: an observation may be large.
const READ_BYTES: usize = 64 << 10;

/// A connection. After a failure it is of no more use: a late reply would be taken for the next one's.
pub(crate) struct Line {
    stream: BufReader<TcpStream>,
}

impl Line {
    /// Connects.
    ///
    /// # Errors
    /// Nobody listens there.
    pub(crate) async fn dial(address: &str) -> io::Result<Self> {
        let stream = TcpStream::connect(address).await?;
        stream.set_nodelay(true)?;
        Ok(Self { stream: BufReader::with_capacity(READ_BYTES, stream) })
    }

    /// Sends a line, and reads the one that answers it.
    ///
    /// # Errors
    /// The connection ends before the line feed, or the reply is longer than any frame.
    pub(crate) async fn exchange(&mut self, line: &[u8]) -> Result<Vec<u8>, Failure> {
        self.stream.get_mut().write_all(line).await.map_err(|_| Failure::Cut)?;
        let mut reply = Vec::new();
        let limit = MAX_REPLY_BYTES + 1;
        let mut bounded = (&mut self.stream).take(u64::try_from(limit).unwrap_or(u64::MAX));
        bounded.read_until(b'\n', &mut reply).await.map_err(|_| Failure::Cut)?;
        match reply.pop() {
            Some(b'\n') => Ok(reply),
            Some(_) if reply.len() + 1 == limit => Err(Failure::ReplyTooLong { limit: MAX_REPLY_BYTES }),
            _ => Err(Failure::Cut), // [NCP-TRANS-005]
        }
    }

    /// Whether the connection stands, and nothing came that nobody asked for.
    pub(crate) fn is_quiet(&self) -> bool {
        let peeked = SockRef::from(self.stream.get_ref()).peek(&mut [MaybeUninit::uninit()]);
        self.stream.buffer().is_empty() && peeked.is_err_and(|error| error.kind() == io::ErrorKind::WouldBlock)
    }
}
