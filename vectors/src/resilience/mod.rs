//! Area `resilience`: the watchdog, the action buffer, horizons, the link monitor.

mod buffer;
mod estop;
mod horizon;
mod link;
mod liveness;
mod model;
mod watchdog;

use crate::case::File;

pub(crate) fn files() -> Vec<File> {
    let mut files = vec![
        watchdog::file(),
        buffer::file(),
        estop::file(),
        horizon::replay(),
        horizon::lengths(),
        link::file(),
    ];
    files.extend(liveness::files());
    files
}
