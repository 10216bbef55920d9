//! Known defects of the specification itself, which no peer is charged with.
//!
//! An input that reaches one of them and on which a peer differs is counted, by what is known, and is no finding; nor
//! does an input become one on its way to the smallest. The list is short, is printed with every result, and shrinks
//! when the specification is mended: an entry that goes makes the search stricter.

use super::generate::Input;
use super::tree::double;
use crate::json::Json;
use crate::peer::Call;

/// Squares of numbers above this overflow a double, or their sum does.
const SQUARES_OVERFLOW: f64 = 1e150;
/// Squares of numbers below this lose digits, or vanish.
const SQUARES_UNDERFLOW: f64 = 1e-140;

/// The norm of a vector is the root of a plain sum of squares: one of huge or tiny components comes out infinite or 0,
/// against NCP-SAFE-043 and NCP-SAFE-060.
const NORMS: &str = "the specification's norms, where the squares of components leave the doubles";

/// What is known of an input.
pub(crate) fn of(input: &Input) -> Option<&'static str> {
    let has_norms = matches!(input.call, Call::GovernorRun | Call::LoopRun);
    (has_norms && reaches_norms(&input.args, "")).then_some(NORMS)
}

/// Whether a component of a channel, or a limit of a norm, is one whose square leaves the doubles.
fn reaches_norms(tree: &Json<'_>, name: &str) -> bool {
    match tree {
        Json::Array(items) => items.iter().any(|item| reaches_norms(item, name)),
        Json::Object(members) => members.iter().any(|(name, value)| reaches_norms(value, name)),
        Json::Number(_) if matches!(name, "data" | "max_speed_mps" | "geofence_radius_m" | "target") => {
            let size = double(Some(tree)).unwrap_or(0.0).abs();
            size > SQUARES_OVERFLOW || size > 0.0 && size < SQUARES_UNDERFLOW
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::tree::own;

    #[test]
    fn only_numbers_whose_squares_leave_the_doubles_are_known() {
        let known = |call: Call, args: &str| of(&Input { call, args: own(&Json::parse(args).unwrap()) }).is_some();
        let govern = |x: &str| format!(r#"{{"steps":[{{"command":{{"channels":{{"v":{{"data":[{x}]}}}}}}}}]}}"#);
        assert!(known(Call::GovernorRun, &govern("1e200")));
        assert!(known(Call::GovernorRun, r#"{"limits":{"max_speed_mps":1e-170}}"#));
        assert!(!known(Call::GovernorRun, &govern("1.5")) && !known(Call::GovernorRun, &govern("0.0")));
        assert!(!known(Call::CodecEncode, &govern("1e200")));
    }
}
