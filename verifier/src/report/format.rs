//! The formats of a result.

use super::badge::{badge, shields};
use super::html::html;
use super::junit::junit;
use super::markdown::markdown;
use super::model::Report;
use super::sarif::sarif;
use super::tsv::tsv;
use crate::suite::Suite;

/// A format in which a result is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// The whole result, by `schemas/result.schema.json`.
    Json,
    /// JUnit XML.
    Junit,
    /// Markdown, for the summary of a CI job.
    Markdown,
    /// SARIF 2.1.0, for code hosts.
    Sarif,
    /// One page without a network, for people.
    Html,
    /// A line a case, separated by tabs.
    Tsv,
    /// An SVG badge.
    Badge,
    /// The JSON of a shields.io endpoint.
    Shields,
}

/// Why a result cannot be written in a format.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// As JSON.
    #[error("the result cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// As JUnit XML.
    #[error("the result cannot be written as JUnit XML: {0}")]
    Junit(#[from] quick_junit::SerializeError),
    /// As a page.
    #[error("the data of the page cannot be packed: {0}")]
    Pack(#[source] std::io::Error),
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 8] =
        [Self::Json, Self::Junit, Self::Markdown, Self::Sarif, Self::Html, Self::Tsv, Self::Badge, Self::Shields];

    /// As a command line has it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Json => "json",
            Self::Junit => "junit",
            Self::Markdown => "md",
            Self::Sarif => "sarif",
            Self::Html => "html",
            Self::Tsv => "tsv",
            Self::Badge => "badge",
            Self::Shields => "shields",
        }
    }

    /// Reads [`as_str`](Self::as_str).
    #[must_use]
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.as_str() == name)
    }

    /// Their names.
    #[must_use]
    pub fn names() -> String {
        Self::ALL.map(Self::as_str).join(", ")
    }
}

/// Writes a result in a format. With the suite that it draws on, a format may show more of the cases.
///
/// # Errors
/// [`RenderError`] if it cannot be written, which does not occur.
pub fn render(report: &Report, format: Format, suite: Option<&Suite>) -> Result<String, RenderError> {
    match format {
        Format::Json => Ok(report.to_json()?),
        Format::Junit => Ok(junit(report)?),
        Format::Markdown => Ok(markdown(report)),
        Format::Sarif => Ok(sarif(report)?),
        Format::Html => html(report, suite),
        Format::Tsv => Ok(tsv(report)),
        Format::Badge => Ok(badge(report)),
        Format::Shields => Ok(shields(report)),
    }
}
