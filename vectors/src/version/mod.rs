//! Area `version`: the version guard, the contract hash, negotiation.

mod contract;
mod guard;

use crate::case::File;

pub(crate) fn files() -> Vec<File> {
    vec![guard::file(), contract::status_file(), contract::negotiate_file()]
}
