//! The one table of artefacts: what is made, of which sources, by which command.
//!
//! The order is that in which they are made: what stands later may depend on what stands before it.

use std::collections::BTreeMap;
use std::io;
use std::path::Path;

use ncp_proofs::digest::{self, ARTEFACTS as PROOFS};
use xtask::setup;

/// Something that is made from the sources and kept in git.
#[derive(Debug)]
pub(crate) struct Artefact {
    /// Its name: also that of its lock, `reports/lock/<name>.toml`.
    pub(crate) name: &'static str,
    /// The files and folders that are made, from the root of the project.
    pub(crate) makes: &'static [&'static str],
    /// The files and folders on which they depend.
    pub(crate) sources: &'static [&'static str],
    /// How it shows whether it is fresh.
    pub(crate) freshness: Freshness,
    /// What makes it, after `cargo`.
    pub(crate) command: &'static [&'static str],
    /// Whether that takes so long that the nightly workflow asks for it, and no change of the sources has to.
    pub(crate) nightly: bool,
}

/// How an artefact shows whether it is fresh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Freshness {
    /// It is generated quickly: `cargo xtask generate --check` makes it once more and compares.
    Generated,
    /// The matrix of rules and evidence: it is read from the tree once more and compared.
    Traced,
    /// It takes minutes or hours to make: its lock holds the digests of the sources of which it was made.
    Locked,
    /// The page of the proofs: it is rendered from their locks once more and compared.
    Rendered,
}

impl Artefact {
    /// The artefact of a name.
    pub(crate) fn named(name: &str) -> Option<&'static Self> {
        ARTEFACTS.iter().find(|artefact| artefact.name == name)
    }

    /// Whether a name means it: its own, or that of its group, as `proofs` is of `proofs-kernel`.
    pub(crate) fn is_meant(&self, name: &str) -> bool {
        self.name.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
    }

    /// The digest of each source as it is now; a source that is not there has none. To a proof belongs what decides
    /// beside its sources: compiler, profiles, packages, and the pins of the solvers.
    ///
    /// # Errors
    /// A file cannot be read.
    pub(crate) fn digests(&self, root: &Path) -> io::Result<BTreeMap<String, String>> {
        let there = self.sources.iter().filter(|source| root.join(source).exists());
        let digests = there.map(|source| Ok(((*source).to_owned(), short(&digest::of_sources(root, &[source])?))));
        let mut digests: BTreeMap<String, String> = digests.collect::<io::Result<_>>()?;
        if let Some(proofs) = PROOFS.iter().find(|proofs| self.name.strip_prefix(OF_PROOFS) == Some(proofs.name)) {
            let is_digest = |value: &str| value.len() == 64 && !value.contains(' ');
            let circumstances = proofs.circumstances(root)?.into_iter();
            digests.extend(circumstances.map(|(name, value)| {
                let value = if is_digest(&value) { short(&value) } else { value };
                (name, value)
            }));
            let pins: &[&str] = match proofs.name {
                "kernel" => &setup::SOLVERS,
                "machine" => &setup::ANGR,
                _ => &[],
            };
            digests.extend((!pins.is_empty()).then(|| ("pins".to_owned(), pins.join(", "))));
        }
        Ok(digests)
    }
}

/// As much of a digest as tells two states of a source apart.
fn short(digest: &str) -> String {
    digest.get(..16).unwrap_or(digest).to_owned()
}

/// How the names of the artefacts begin that are results of proofs.
pub(crate) const OF_PROOFS: &str = "proofs-";
const GENERATE: &[&str] = &["xtask", "generate"];
const CORPUS: &str = "vectors/MANIFEST.sha256";

/// Every artefact.
pub(crate) const ARTEFACTS: &[Artefact] = &[
    Artefact {
        name: "projection",
        makes: &["proto/projection.json"],
        sources: &["proto/ncp.proto", "spec/text"],
        freshness: Freshness::Generated,
        command: GENERATE,
        nightly: false,
    },
    Artefact {
        name: "schemas",
        makes: &["schemas"],
        sources: &["proto/ncp.proto", "proto/projection.json", "proto/src", "spec/text"],
        freshness: Freshness::Generated,
        command: GENERATE,
        nightly: false,
    },
    Artefact {
        name: "header",
        makes: &["peers/cpp/include/ncp.h"],
        sources: &["peers/cpp/src", "peers/cpp/cbindgen.toml"],
        freshness: Freshness::Generated,
        command: GENERATE,
        nightly: false,
    },
    Artefact {
        name: "corpus",
        makes: &["vectors/corpus", CORPUS],
        sources: &[
            "vectors/src",
            "vectors/scenarios",
            "vectors/findings.toml",
            "vectors/flags.toml",
            "vectors/foundations.toml",
            "spec/text",
        ],
        freshness: Freshness::Generated,
        command: GENERATE,
        nightly: false,
    },
    Artefact {
        name: "deep",
        makes: &["vectors/deep"],
        // It is chosen once, like a corpus; what its cases name of the contract stands there.
        sources: &["spec/text/02-version-and-identity.md"],
        freshness: Freshness::Locked,
        command: &["assure", "deep", "--keep"],
        nightly: false,
    },
    Artefact {
        name: "mutants",
        makes: &["reports/mutants.md"],
        sources: &[
            "defects/peer",
            "peers/adapter/src",
            "peers/rust/src",
            "spec/kernel/src",
            "spec/src",
            "spec/text",
            CORPUS,
            "verifier/src/check",
            "verifier/src/diagnosis.rs",
            "verifier/src/run",
            "verifier/src/suite",
            "verifier/src/verdict",
        ],
        freshness: Freshness::Locked,
        command: &["assure", "mutants"],
        nightly: false,
    },
    Artefact {
        name: "dictionary",
        makes: &["verifier/dictionary.json", "reports/dictionary.md"],
        sources: &[
            "defects/peer",
            "peers/adapter/src",
            "peers/rust/src",
            "spec/kernel/src",
            "spec/src",
            "spec/text",
            CORPUS,
            "verifier/src/check",
            "verifier/src/dictionary/explain.rs",
            "verifier/src/dictionary/symptom.rs",
            "verifier/src/run",
            "verifier/src/suite",
        ],
        freshness: Freshness::Locked,
        command: &["assure", "dictionary"],
        nightly: false,
    },
    Artefact {
        name: "proofs-kernel",
        makes: &["proofs/evidence"],
        sources: PROOFS[0].sources,
        freshness: Freshness::Locked,
        command: &["assure", "prove", "--engine", "symbolic", "--engine", "enumeration", "--engine", "kani-stand-in"],
        nightly: false,
    },
    proof("proofs-machine", 1, &["assure", "prove", "--engine", "machine"]),
    proof("proofs-model", 2, &["assure", "prove", "--engine", "model"]),
    proof("proofs-readers", 3, &["assure", "prove", "--engine", "readers"]),
    proof("proofs-path", 4, &["assure", "prove", "--engine", "path"]),
    proof("proofs-theorem", 5, &["assure", "prove", "--engine", "theorem"]),
    Artefact {
        name: "proofs-page",
        makes: &["reports/proofs.md"],
        sources: &["reports/lock", "spec/text"],
        freshness: Freshness::Rendered,
        command: &["assure", "prove", "--page"],
        nightly: false,
    },
    Artefact {
        name: "mutate-kernel",
        makes: &["reports/mutations.md"],
        sources: &[
            "spec/kernel/src",
            "proofs/equivalent.toml",
            "proofs/src/bin/mutants.rs",
            "proofs/src/engines",
            "proofs/src/properties",
            "assurance/src/mutate/copies.rs",
            "assurance/src/mutate/kernel",
        ],
        freshness: Freshness::Locked,
        command: &["assure", "mutate", "kernel", "--count", "450", "--seed", "3"],
        nightly: true,
    },
    Artefact {
        name: "hostile",
        makes: &["reports/hostile.md"],
        sources: &[
            "spec/kernel/src",
            "spec/src/resilience",
            "spec/src/safety",
            CORPUS,
            "defects/hostile.toml",
            "proofs/src/bin/mutants.rs",
            "proofs/src/engines",
            "proofs/src/properties",
            "proofs/theorem/coq",
            "proofs/theorem/src",
            "assurance/src/mutate/copies.rs",
            "assurance/src/mutate/hostile",
        ],
        freshness: Freshness::Locked,
        command: &["assure", "mutate", "hostile"],
        nightly: true,
    },
    spec_module(
        "mutate-spec-safety",
        &["spec/src/safety", "spec/kernel/src", CORPUS],
        &["assure", "mutate", "spec", "--module", "safety"],
    ),
    spec_module(
        "mutate-spec-resilience",
        &["spec/src/resilience", CORPUS],
        &["assure", "mutate", "spec", "--module", "resilience"],
    ),
    spec_module("mutate-spec-bulk", &["spec/src/bulk", CORPUS], &["assure", "mutate", "spec", "--module", "bulk"]),
    spec_module("mutate-spec-wire", &["spec/src/wire", CORPUS], &["assure", "mutate", "spec", "--module", "wire"]),
    spec_module("mutate-spec-json", &["spec/src/wire/json", CORPUS], &["assure", "mutate", "spec", "--module", "json"]),
    spec_module(
        "mutate-spec-codec",
        &["spec/src/codec.rs", CORPUS],
        &["assure", "mutate", "spec", "--module", "codec"],
    ),
    Artefact {
        name: "fuzz",
        makes: &["reports/fuzz.md"],
        sources: &["fuzz/bodies/src", "fuzz/fuzz_targets", "defects/fuzz.toml"],
        freshness: Freshness::Locked,
        command: &["assure", "fuzz", "--report"],
        nightly: true,
    },
    Artefact {
        name: "live",
        makes: &["reports/live.md"],
        sources: &[
            "live/defects.toml",
            "live/scenarios.toml",
            "live/src",
            "peers/gateway/src",
            "peers/nest/ncp_nest",
            "peers/python-pure/ncp_pure",
            "peers/zenoh/deploy",
            "peers/zenoh/src",
            "spec/kernel/src",
            "spec/src",
            "spec/text",
        ],
        freshness: Freshness::Locked,
        command: &["assure", "live"],
        nightly: true,
    },
    Artefact {
        name: "trace",
        makes: &["reports/traceability.md", "reports/lock/trace.toml"],
        sources: &[
            "spec/text",
            "spec/exclusions.toml",
            "spec/kernel/src",
            "spec/src",
            "spec/tests",
            "proto/src",
            "proto/tests",
            "vectors/corpus",
            "fuzz/bodies/src",
            "defects/peer",
            "live/scenarios.toml",
            "peers/zenoh/tests",
            "peers/python-pure/ncp_pure",
            "peers/typescript/src",
            "reports/lock",
        ],
        freshness: Freshness::Traced,
        command: &["assure", "trace"],
        nightly: false,
    },
];

/// What an engine of the proofs makes, the one of this place in the table of proofs, but for the kernel's.
const fn proof(name: &'static str, place: usize, command: &'static [&'static str]) -> Artefact {
    Artefact { name, makes: &[], sources: PROOFS[place].sources, freshness: Freshness::Locked, command, nightly: false }
}

/// The mutants of a module of the specification.
const fn spec_module(
    name: &'static str,
    sources: &'static [&'static str],
    command: &'static [&'static str],
) -> Artefact {
    Artefact {
        name,
        makes: &["reports/cargo-mutants.md"],
        sources,
        freshness: Freshness::Locked,
        command,
        nightly: true,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::PathBuf;

    use super::*;

    fn root() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
    }

    #[test]
    fn every_artefact_has_a_name_of_its_own_and_sources_that_are_there() {
        let names: BTreeSet<&str> = ARTEFACTS.iter().map(|artefact| artefact.name).collect();
        assert_eq!(names.len(), ARTEFACTS.len());
        let paths = ARTEFACTS.iter().flat_map(|artefact| artefact.makes.iter().chain(artefact.sources));
        let missing: BTreeSet<&&str> = paths.filter(|path| !root().join(path).exists()).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn the_name_of_a_group_means_all_of_it_and_half_a_name_means_nothing() {
        let meant = |name: &str| ARTEFACTS.iter().filter(|artefact| artefact.is_meant(name)).count();
        // A proof's result for each of its artefacts, and the page.
        assert_eq!(meant("proofs"), PROOFS.len() + 1);
        assert_eq!(meant("proofs-page"), 1);
        assert_eq!(meant("proofs-pa"), 0);
    }

    #[test]
    fn a_change_of_a_wire_message_leaves_the_proofs_of_the_kernel_alone() {
        let kernel = Artefact::named("proofs-kernel").unwrap();
        assert!(kernel.sources.iter().all(|source| !"spec/src/wire/messages.rs".starts_with(source)));
        assert!(Artefact::named("mutants").unwrap().sources.contains(&"spec/src"));
    }
}
