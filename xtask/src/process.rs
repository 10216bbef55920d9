//! Runs programs that end when this one is told to: Ctrl-C, or a signal to terminate, ends all that they have started.

use std::io;
use std::process::{Child, Command, ExitStatus};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// What is running, by the id of its process group.
static RUNNING: Mutex<Vec<u32>> = Mutex::new(Vec::new());
static STOPPED: AtomicBool = AtomicBool::new(false);

/// Whether somebody wants everything to end.
pub(crate) fn is_stopped() -> bool {
    STOPPED.load(Ordering::SeqCst)
}

/// Runs a program to its end, in a process group of its own.
///
/// # Errors
/// It cannot be started, or everything is to end.
pub(crate) fn run(command: &mut Command) -> io::Result<ExitStatus> {
    let mut child = start(command)?;
    let status = child.wait();
    running().retain(|id| *id != child.id());
    status
}

/// Starts a program, unless everything is to end: whoever ends it all sees each program that runs.
fn start(command: &mut Command) -> io::Result<Child> {
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(command, 0);
    let mut running = running();
    if is_stopped() {
        return Err(io::Error::from(io::ErrorKind::Interrupted));
    }
    let child = command.spawn()?;
    running.push(child.id());
    Ok(child)
}

fn running() -> std::sync::MutexGuard<'static, Vec<u32>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on, a signal ends the programs that run: gently, and after ten seconds by force.
///
/// # Errors
/// The signals cannot be listened to.
#[cfg(unix)]
pub(crate) fn end_on_signal() -> io::Result<()> {
    use rustix::process::Signal;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use std::time::Duration;

    let mut signals = signal_hook::iterator::Signals::new([SIGHUP, SIGINT, SIGTERM])?;
    std::thread::spawn(move || {
        signals.forever().next();
        STOPPED.store(true, Ordering::SeqCst);
        end_all(Signal::TERM);
        std::thread::sleep(Duration::from_secs(10));
        end_all(Signal::KILL);
    });
    Ok(())
}

#[cfg(not(unix))]
pub(crate) fn end_on_signal() -> io::Result<()> {
    Ok(())
}

#[cfg(unix)]
fn end_all(signal: rustix::process::Signal) {
    for id in running().iter() {
        let group = i32::try_from(*id).ok().and_then(rustix::process::Pid::from_raw);
        // A group that has ended meanwhile needs no signal.
        let _ = group.map(|group| rustix::process::kill_process_group(group, signal));
    }
}
