//! The chapters of the text.

/// A chapter of the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Chapter<'t> {
    /// The name of its file in `spec/text`.
    pub file: &'static str,
    /// The whole text, in Markdown.
    pub text: &'t str,
}

/// The chapters, in order.
pub const CHAPTERS: [Chapter<'static>; 14] = [
    INTRODUCTION,
    WIRE,
    VERSION_AND_IDENTITY,
    PLANES_AND_KEYS,
    SESSIONS,
    OBSERVATIONS_AND_BULK,
    PROVENANCE,
    SAFETY,
    RESILIENCE,
    CODEC,
    CONTROL_LOOP,
    TRANSPORTS,
    SECURITY,
    CONFORMANCE,
];

/// Declares the chapters by their files.
macro_rules! chapters {
    ($($(#[$doc:meta])* $name:ident = $file:literal;)*) => {
        $(
            $(#[$doc])*
            pub const $name: Chapter<'static> = Chapter { file: $file, text: include_str!(concat!("../", $file)) };
        )*
    };
}

chapters! {
    /// Chapter 0.
    INTRODUCTION = "00-introduction.md";
    /// Chapter 1.
    WIRE = "01-wire.md";
    /// Chapter 2.
    VERSION_AND_IDENTITY = "02-version-and-identity.md";
    /// Chapter 3.
    PLANES_AND_KEYS = "03-planes-and-keys.md";
    /// Chapter 4.
    SESSIONS = "04-sessions.md";
    /// Chapter 5.
    OBSERVATIONS_AND_BULK = "05-observations-and-bulk.md";
    /// Chapter 6.
    PROVENANCE = "06-provenance.md";
    /// Chapter 7.
    SAFETY = "07-safety.md";
    /// Chapter 8.
    RESILIENCE = "08-resilience.md";
    /// Chapter 9.
    CODEC = "09-codec.md";
    /// Chapter 10.
    CONTROL_LOOP = "10-control-loop.md";
    /// Chapter 11.
    TRANSPORTS = "11-transports.md";
    /// Chapter 12.
    SECURITY = "12-security.md";
    /// Chapter 13.
    CONFORMANCE = "13-conformance.md";
}
