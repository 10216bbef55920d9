//! The planes and their quality of service: the table of section 3.1.

use std::sync::LazyLock;

use crate::chapters::PLANES_AND_KEYS;
use crate::markdown::rows_below;

/// A row of the table, in the words of the text.
#[derive(Debug, PartialEq, Eq)]
pub struct Plane {
    /// `control`, `perception`, `action` or `observation`.
    pub name: String,
    /// The form of its key, such as `{realm}/rpc`.
    pub key: String,
    /// `block` or `drop`.
    pub congestion: String,
    /// Zenoh's name of the priority.
    pub priority: String,
    /// Whether a frame is sent at once, without batching.
    pub express: bool,
}

/// The planes of the text, read once.
pub fn planes() -> &'static [Plane] {
    static PLANES: LazyLock<Vec<Plane>> = LazyLock::new(|| {
        let rows = rows_below(PLANES_AND_KEYS.text, "| plane |");
        rows.into_iter().filter_map(plane).collect()
    });
    &PLANES
}

fn plane(cells: Vec<String>) -> Option<Plane> {
    let [name, key, congestion, priority, express] = <[String; 5]>::try_from(cells).ok()?;
    Some(Plane { name, key: key.trim_matches('`').to_owned(), congestion, priority, express: express == "yes" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_four_planes_are_read_from_the_text() {
        assert_eq!(
            planes().iter().map(|plane| &plane.name[..]).collect::<Vec<_>>(),
            ["control", "perception", "action", "observation"]
        );
        assert_eq!(planes()[0].key, "{realm}/rpc");
        assert_eq!(planes().iter().filter(|plane| plane.express).count(), 1);
    }
}
