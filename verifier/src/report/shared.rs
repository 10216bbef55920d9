//! What is the same in the cases of many peers, held once: a result of twenty peers holds every case twenty times.

use std::cell::RefCell;
use std::collections::HashSet;
use std::hash::Hash;
use std::sync::Arc;
use std::thread::LocalKey;

use serde::de::{Deserialize, DeserializeOwned, Deserializer};
use serde::ser::{Serialize, Serializer};

/// A value that is held once a thread.
pub(super) trait Shared: Eq + Hash + 'static {
    /// As it is read.
    type Read: DeserializeOwned + Into<Arc<Self>>;

    /// What is held.
    fn held() -> &'static LocalKey<RefCell<HashSet<Arc<Self>>>>;
}

thread_local! {
    static TEXTS: RefCell<HashSet<Arc<str>>> = RefCell::default();
    static LISTS: RefCell<HashSet<Arc<[String]>>> = RefCell::default();
}

impl Shared for str {
    type Read = String;

    fn held() -> &'static LocalKey<RefCell<HashSet<Arc<Self>>>> {
        &TEXTS
    }
}

impl Shared for [String] {
    type Read = Vec<String>;

    fn held() -> &'static LocalKey<RefCell<HashSet<Arc<Self>>>> {
        &LISTS
    }
}

/// The one that is held of what is equal to this.
pub(super) fn shared<T: Shared + ?Sized>(value: impl Into<Arc<T>>) -> Arc<T> {
    let value = value.into();
    T::held().with_borrow_mut(|held| {
        held.get(&value).cloned().unwrap_or_else(|| {
            held.insert(Arc::clone(&value));
            value
        })
    })
}

pub(super) fn serialize<T: Serialize + ?Sized, S: Serializer>(value: &Arc<T>, to: S) -> Result<S::Ok, S::Error> {
    T::serialize(value, to)
}

pub(super) fn deserialize<'de, T: Shared + ?Sized, D: Deserializer<'de>>(from: D) -> Result<Arc<T>, D::Error> {
    Ok(shared(T::Read::deserialize(from)?))
}
