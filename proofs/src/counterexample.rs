//! Inputs that break a property: what an engine finds, and what a vector is made of.

/// The check that fails where the kernel does not come to an end.
pub const ENDS: &str = "the kernel comes to an end";

/// Inputs that break a property, in the order in which the harness draws them.
#[derive(Debug, Clone, PartialEq)]
pub struct Counterexample {
    /// The check that fails.
    pub check: String,
    /// The inputs, by name.
    pub inputs: Vec<(String, Drawn)>,
}

/// An input of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drawn {
    /// A double.
    Scalar(f64),
    /// A seq.
    Seq(i64),
    /// One of several.
    Choice(usize),
}
