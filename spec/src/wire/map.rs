//! A map with few, short keys, kept in the order in which it is written. `[NCP-WIRE-083]`

use std::borrow::Borrow;
use std::fmt;
use std::ops::Index;

use super::Text;

/// A map from names to values, sorted by the code points of the names.
///
/// It is a sorted vector: one allocation, and faster than a tree for the handful of channels that
/// a frame has. Like a `BTreeMap` it holds each name once.
///
/// ```
/// use ncp_spec::wire::SortedMap;
///
/// let mut sizes = SortedMap::from_iter([("inh", 20), ("exc", 80)]);
/// sizes.insert("noise", 1);
/// assert_eq!(sizes.keys().collect::<Vec<_>>(), ["exc", "inh", "noise"]);
/// assert_eq!(sizes.get("exc"), Some(&80));
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct SortedMap<V> {
    /// Strictly ascending by name.
    entries: Vec<(Text, V)>,
}

impl<V> SortedMap<V> {
    /// An empty map; it allocates nothing.
    #[must_use]
    pub const fn new() -> Self {
        Self { entries: Vec::new() }
    }

    /// The number of entries.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether there is no entry.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The value of a name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&V> {
        let at = self.find(name).ok()?;
        self.entries.get(at).map(|(_, value)| value)
    }

    /// The value of a name, to change it.
    #[must_use]
    pub fn get_mut(&mut self, name: &str) -> Option<&mut V> {
        let at = self.find(name).ok()?;
        self.entries.get_mut(at).map(|(_, value)| value)
    }

    /// Whether the name has a value.
    #[must_use]
    pub fn contains_key(&self, name: &str) -> bool {
        self.find(name).is_ok()
    }

    /// Sets the value of a name; the value that it had.
    pub fn insert(&mut self, name: impl Into<Text>, value: V) -> Option<V> {
        let name = name.into();
        match self.find(&name) {
            Ok(at) => self.entries.get_mut(at).map(|entry| std::mem::replace(&mut entry.1, value)),
            Err(at) => {
                self.entries.insert(at, (name, value));
                None
            }
        }
    }

    /// Takes a name and its value out; the value that it had.
    pub fn remove(&mut self, name: &str) -> Option<V> {
        let at = self.find(name).ok()?;
        Some(self.entries.remove(at).1)
    }

    /// Takes everything out.
    pub fn clear(&mut self) {
        self.entries.clear();
    }

    /// The names in order.
    pub fn keys(&self) -> impl ExactSizeIterator<Item = &str> {
        self.entries.iter().map(|(name, _)| name.borrow())
    }

    /// The values in the order of their names.
    pub fn values(&self) -> impl ExactSizeIterator<Item = &V> {
        self.entries.iter().map(|(_, value)| value)
    }

    /// The values in the order of their names, to change them.
    pub fn values_mut(&mut self) -> impl ExactSizeIterator<Item = &mut V> {
        self.entries.iter_mut().map(|(_, value)| value)
    }

    /// Names and values in the order of the names.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&str, &V)> {
        self.entries.iter().map(|(name, value)| (name.borrow(), value))
    }

    /// Names and values in the order of the names, to change the values.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = (&str, &mut V)> {
        self.entries.iter_mut().map(|(name, value)| (&**name, value))
    }

    /// A map of entries in any order, or the first name that occurs twice.
    pub(crate) fn from_entries(mut entries: Vec<(Text, V)>) -> Result<Self, Text> {
        if !entries.is_sorted_by(|a, b| a.0 < b.0) {
            entries.sort_unstable_by(|a, b| a.0.cmp(&b.0));
            let repeat = entries.windows(2).find(|pair| matches!(pair, [a, b] if a.0 == b.0));
            if let Some([(name, _), _]) = repeat {
                return Err(name.clone());
            }
        }
        Ok(Self { entries })
    }

    fn find(&self, name: &str) -> Result<usize, usize> {
        self.entries.binary_search_by(|(known, _)| known.as_ref().cmp(name))
    }
}

impl<V> Default for SortedMap<V> {
    fn default() -> Self {
        Self::new()
    }
}

impl<V: fmt::Debug> fmt::Debug for SortedMap<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self.iter()).finish()
    }
}

impl<V> Index<&str> for SortedMap<V> {
    type Output = V;

    /// The value of a name, which must be there: for tests and examples; else use
    /// [`get`](SortedMap::get).
    ///
    /// # Panics
    ///
    /// When the name has no value.
    #[expect(clippy::expect_used, reason = "the trait leaves no other way, and the docs say so")]
    fn index(&self, name: &str) -> &V {
        self.get(name).expect("no entry of that name")
    }
}

impl<K: Into<Text>, V> Extend<(K, V)> for SortedMap<V> {
    fn extend<I: IntoIterator<Item = (K, V)>>(&mut self, entries: I) {
        for (name, value) in entries {
            self.insert(name, value);
        }
    }
}

impl<K: Into<Text>, V> FromIterator<(K, V)> for SortedMap<V> {
    /// The last of several values of one name stays.
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        let mut map = Self::new();
        map.extend(entries);
        map
    }
}

impl<V> IntoIterator for SortedMap<V> {
    type Item = (Text, V);
    type IntoIter = std::vec::IntoIter<(Text, V)>;

    fn into_iter(self) -> Self::IntoIter {
        self.entries.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use proptest::prelude::*;

    use super::*;

    #[test]
    fn names_are_sorted_by_code_points_and_not_by_utf16_units() {
        let map = SortedMap::from_iter([("\u{1f600}", 1), ("\u{ff5e}", 2), ("b", 3), ("B", 4)]);
        assert_eq!(map.keys().collect::<Vec<_>>(), ["B", "b", "\u{ff5e}", "\u{1f600}"]);
    }

    #[test]
    fn entries_with_one_name_twice_make_no_map() {
        let entries = |names: &[&'static str]| names.iter().map(|n| (Text::Borrowed(*n), ())).collect::<Vec<_>>();
        assert_eq!(SortedMap::from_entries(entries(&["b", "a", "b"])), Err(Text::Borrowed("b")));
        assert_eq!(SortedMap::from_entries(entries(&["a", "a"])), Err(Text::Borrowed("a")));
        let map = SortedMap::from_entries(entries(&["b", "c", "a"])).unwrap();
        assert_eq!(map.keys().collect::<Vec<_>>(), ["a", "b", "c"]);
    }

    proptest! {
        /// [NCP-WIRE-083]
        #[test]
        fn it_behaves_like_a_tree_map(
            steps in proptest::collection::vec(("[abc]{0,2}", any::<u8>(), any::<bool>()), 0..40),
        ) {
            let mut map = SortedMap::new();
            let mut tree = BTreeMap::new();
            for (name, value, remove) in steps {
                if remove {
                    prop_assert_eq!(map.remove(&name), tree.remove(&name));
                } else {
                    prop_assert_eq!(map.insert(name.clone(), value), tree.insert(name.clone(), value));
                }
                prop_assert_eq!(map.get(&name), tree.get(&name));
                prop_assert_eq!(map.contains_key(&name), tree.contains_key(&name));
            }
            prop_assert_eq!(map.len(), tree.len());
            prop_assert!(map.iter().eq(tree.iter().map(|(name, value)| (name.as_str(), value))));
            prop_assert_eq!(map.is_empty(), tree.is_empty());
            prop_assert_eq!(format!("{map:?}"), format!("{tree:?}"));
            let entries = map.clone().into_iter().map(|(name, value)| (name.into_owned(), value));
            prop_assert!(entries.eq(tree));
            map.clear();
            prop_assert_eq!(map.len(), 0);
        }
    }
}
