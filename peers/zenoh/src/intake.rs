//! What arrives: bounded queues that keep the newest, and the commands of a plant.

use std::collections::VecDeque;
use std::marker::PhantomData;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use ncp_spec::resilience::ActionBuffer;
use ncp_spec::wire::{ChannelMap, DecodeError, Frame, SensorFrame};
use zenoh::Wait;
use zenoh::bytes::ZBytes;
use zenoh::key_expr::KeyExpr;
use zenoh::pubsub::Subscriber;

use crate::bus::{Bus, BusError};
use crate::qos::SeenQos;

/// Sensor frames as they arrive.
pub type Perception = Intake<SensorFrame>;

/// A frame that arrived, as it travelled.
#[derive(Debug, Clone)]
pub struct Arrival {
    /// The key on which it was published.
    pub key: KeyExpr<'static>,
    /// Its bytes. `[NCP-TRANS-001]`
    pub payload: ZBytes,
    /// The quality of service that it carries.
    pub qos: SeenQos,
    /// When it arrived.
    pub at: Instant,
}

/// What an intake has seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct IntakeCounts {
    /// Frames that arrived.
    pub received: u64,
    /// Frames that gave way to newer ones before anybody took them.
    pub overrun: u64,
    /// Frames that could not be decoded.
    pub rejected: u64,
}

/// Frames of the keys that a pattern covers, in a queue that gives up its oldest when it is full: whatever its reader
/// does, the network never waits for it. `[NCP-TRANS-009]`
pub struct Intake<F> {
    shared: Arc<Shared>,
    _subscriber: Subscriber<()>,
    frames: PhantomData<fn() -> F>,
}

struct Shared {
    queue: Mutex<VecDeque<Arrival>>,
    arrived: Condvar,
    capacity: usize,
    received: AtomicU64,
    overrun: AtomicU64,
    rejected: AtomicU64,
}

impl Perception {
    /// How many frames are kept of a stream: a controller wants the newest, and a link monitor every one.
    pub const FRAMES: usize = 256;

    /// One sensor stream of a session, until it is dropped.
    ///
    /// # Errors
    /// A segment of the key is none, or Zenoh refuses.
    pub fn of(bus: &Bus, session: &str, name: Option<&str>) -> Result<Self, BusError> {
        Self::subscribe(bus, bus.keys().sensor(session, name)?, Self::FRAMES)
    }
}

impl<F: Frame> Intake<F> {
    /// The oldest frame that was not taken yet, decoded; those that cannot be are counted and passed over.
    #[must_use]
    pub fn next_frame(&self) -> Option<F> {
        while let Some(arrival) = self.next() {
            match F::decode(&arrival.payload.to_bytes()) {
                Ok(frame) => return Some(frame),
                Err(_) => self.shared.rejected.fetch_add(1, Ordering::Relaxed),
            };
        }
        None
    }
}

impl<F> Intake<F> {
    /// Whatever a key expression covers, until it is dropped. `[NCP-TRANS-008]`
    ///
    /// # Errors
    /// The key expression is none, or Zenoh refuses.
    pub fn subscribe(bus: &Bus, pattern: String, capacity: usize) -> Result<Self, BusError> {
        let shared = Arc::new(Shared {
            queue: Mutex::new(VecDeque::new()),
            arrived: Condvar::new(),
            capacity: capacity.max(1),
            received: AtomicU64::new(0),
            overrun: AtomicU64::new(0),
            rejected: AtomicU64::new(0),
        });
        let into = Arc::clone(&shared);
        let subscriber = bus.session().declare_subscriber(KeyExpr::try_from(pattern)?);
        let subscriber = subscriber.callback(move |sample| {
            let qos = SeenQos::from(&sample);
            let (key, payload) = (sample.key_expr().clone(), sample.payload().clone());
            into.push(Arrival { key, payload, qos, at: Instant::now() });
        });
        Ok(Self { shared, _subscriber: subscriber.wait()?, frames: PhantomData })
    }

    /// The oldest frame that was not taken yet.
    #[must_use]
    pub fn next(&self) -> Option<Arrival> {
        lock(&self.shared.queue).pop_front()
    }

    /// The oldest frame that was not taken yet; waits for one at most so long.
    #[must_use]
    pub fn wait_for(&self, longest: Duration) -> Option<Arrival> {
        let queue = lock(&self.shared.queue);
        let waited = self.shared.arrived.wait_timeout_while(queue, longest, |queue| queue.is_empty());
        waited.unwrap_or_else(PoisonError::into_inner).0.pop_front()
    }

    /// What it has seen so far.
    #[must_use]
    pub fn counts(&self) -> IntakeCounts {
        let Shared { received, overrun, rejected, .. } = &*self.shared;
        let [received, overrun, rejected] = [received, overrun, rejected].map(|count| count.load(Ordering::Relaxed));
        IntakeCounts { received, overrun, rejected }
    }
}

impl Shared {
    fn push(&self, arrival: Arrival) {
        self.received.fetch_add(1, Ordering::Relaxed);
        let mut queue = lock(&self.queue);
        if queue.len() == self.capacity {
            queue.pop_front();
            self.overrun.fetch_add(1, Ordering::Relaxed);
        }
        queue.push_back(arrival);
        self.arrived.notify_one();
    }
}

/// The commands of one stream, as a plant obeys them. Each is judged as it arrives, so that none that stops is lost in
/// a queue; the clock is the plant's own. `[NCP-RES-001]`
pub struct Commands {
    shared: Arc<CommandShared>,
    _subscriber: Subscriber<()>,
}

struct CommandShared {
    buffer: Mutex<ActionBuffer>,
    began: Instant,
    received: AtomicU64,
    rejected: AtomicU64,
}

impl Commands {
    /// One command stream of a session, until it is dropped.
    ///
    /// # Errors
    /// A segment of the key is none, or Zenoh refuses.
    pub fn of(bus: &Bus, session: &str, name: Option<&str>, buffer: ActionBuffer) -> Result<Self, BusError> {
        let shared = Arc::new(CommandShared {
            buffer: Mutex::new(buffer),
            began: Instant::now(),
            received: AtomicU64::new(0),
            rejected: AtomicU64::new(0),
        });
        let into = Arc::clone(&shared);
        let key = KeyExpr::try_from(bus.keys().command(session, name)?)?;
        let subscriber = bus.session().declare_subscriber(key).callback(move |sample| {
            // What it decided, the buffer keeps; what it rejects is counted.
            if into.take(&sample.payload().to_bytes()).is_err() {
                into.rejected.fetch_add(1, Ordering::Relaxed);
            }
        });
        Ok(Self { shared, _subscriber: subscriber.wait()? })
    }

    /// Seconds on the plant's clock.
    #[must_use]
    pub fn now_s(&self) -> f64 {
        self.shared.now_s()
    }

    /// What the plant actuates now, or none when it holds. `[NCP-RES-025]`
    #[must_use]
    pub fn active(&self) -> Option<ChannelMap> {
        let mut buffer = lock(&self.shared.buffer);
        buffer.active(self.shared.now_s()).cloned()
    }

    /// Whether ESTOP is latched. `[NCP-RES-021]`
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        lock(&self.shared.buffer).is_stopped()
    }

    /// Clears the latch, by a supervisor's decision. `[NCP-RES-030]`
    pub fn reset(&self) {
        lock(&self.shared.buffer).reset();
    }

    /// What it has seen so far; nothing is ever overrun.
    #[must_use]
    pub fn counts(&self) -> IntakeCounts {
        let CommandShared { received, rejected, .. } = &*self.shared;
        let [received, rejected] = [received, rejected].map(|count| count.load(Ordering::Relaxed));
        IntakeCounts { received, rejected, overrun: 0 }
    }
}

impl CommandShared {
    fn now_s(&self) -> f64 {
        self.began.elapsed().as_secs_f64()
    }

    fn take(&self, frame: &[u8]) -> Result<(), DecodeError> {
        self.received.fetch_add(1, Ordering::Relaxed);
        let mut buffer = lock(&self.buffer);
        buffer.on_frame(frame, self.now_s()).map(|_| ())
    }
}

/// What a thread that panicked left is whole: each change is one call.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
