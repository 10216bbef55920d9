//! Results that somebody answers for: an in-toto statement about a peer, in a signed envelope.
//!
//! The [`Statement`] names by their digests the peer's files, the vectors, the text and the verifier, and holds the
//! whole result. [`seal`] signs it by DSSE with ed25519. [`open`] refuses what was not signed by the key, what is about
//! other vectors or another text than those at hand, and a result whose verdict does not follow from its cases: all of
//! it is judged anew.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ed25519_compact::{KeyPair, PublicKey, SecretKey, Seed, Signature};
use ncp_text::chapters::CHAPTERS;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use sha2::{Digest as _, Sha256};

use crate::merge::{MergeError, judged_anew};
use crate::report::Report;
use crate::suite::Suite;

/// What a statement is, by in-toto.
const STATEMENT: &str = "https://in-toto.io/Statement/v1";
/// What its predicate is.
const PREDICATE: &str = "https://example.invalid/ncp-conformance/attestation/result/v1";
/// What an envelope holds.
const PAYLOAD: &str = "application/vnd.in-toto+json";

/// What is said of files: the result of checking the peer that they are.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Statement {
    #[serde(rename = "_type")]
    kind: String,
    /// The files of the peers.
    pub subject: Vec<Artefact>,
    #[serde(rename = "predicateType")]
    predicate_type: String,
    /// What is said of them.
    pub predicate: Predicate,
}

/// A file by its digest.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Artefact {
    /// Its name.
    pub name: String,
    /// Its digest.
    pub digest: Sha256Digest,
}

/// The digest of a file, as in-toto writes it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sha256Digest {
    /// In hexadecimal digits.
    pub sha256: String,
}

/// What is said: by which program, vectors and text a peer was judged, and how.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Predicate {
    /// The program that judged.
    pub verifier: Artefact,
    /// The vectors: of `vectors/MANIFEST.sha256`.
    pub corpus: Sha256Digest,
    /// The normative text: of its chapters.
    pub text: Sha256Digest,
    /// The result.
    pub result: Report,
}

/// Who signs.
#[derive(Debug)]
pub struct Key(SecretKey);

/// Whose signature is believed.
#[derive(Debug)]
pub struct Believed(PublicKey);

/// Why a result cannot be attested, or an attestation is refused.
#[derive(Debug, thiserror::Error)]
pub enum AttestError {
    /// A key is none.
    #[error("this is no ed25519 key in PEM: {0}")]
    Key(String),
    /// There is no file that it could be about.
    #[error("no file of a peer is known: name it by --artefact")]
    NoSubject,
    /// It is no envelope, or holds no statement.
    #[error("this is no attestation of ncp-verify: {0}")]
    Form(#[from] serde_json::Error),
    /// It is of another kind.
    #[error("its {what} is {found:?}, not {expected:?}")]
    Kind {
        /// What of it.
        what: &'static str,
        /// What it is.
        found: String,
        /// What it has to be.
        expected: &'static str,
    },
    /// Its bytes are not in base64.
    #[error("its {what} is not in base64: {source}")]
    Base64 {
        /// What of it.
        what: &'static str,
        /// What is wrong.
        source: base64::DecodeError,
    },
    /// It does not have exactly one signature.
    #[error("it has {0} signatures, not one")]
    Signatures(usize),
    /// It names another key.
    #[error("it is signed by the key {0}, not by the one that was given")]
    OtherKey(String),
    /// The signature is not that of the key over these bytes.
    #[error("its signature is not that of the key: it was changed, or somebody else signed it")]
    Signature,
    /// A digest is not that of what is at hand.
    #[error("its {what} has the digest {found}, and the one at hand {here}")]
    Digest {
        /// Of what.
        what: &'static str,
        /// The digest that is stated.
        found: String,
        /// That of what is at hand.
        here: String,
    },
    /// A file is not one of those that it is about.
    #[error("it is not about the file {0}")]
    Stranger(String),
    /// The result cannot be judged anew.
    #[error(transparent)]
    Judge(#[from] MergeError),
    /// The result is not what follows from its cases.
    #[error("its verdict does not follow from its cases: {place} is {found}, and should be {due}")]
    Verdict {
        /// Where, as a JSON pointer into the result.
        place: String,
        /// What stands there.
        found: String,
        /// What follows.
        due: String,
    },
}

impl Statement {
    /// Says of the files of the peers that this is their result.
    ///
    /// # Errors
    /// [`AttestError`] if there is no file, or the result does not follow from its cases.
    pub fn new(subject: Vec<Artefact>, verifier: Artefact, result: Report, suite: &Suite) -> Result<Self, AttestError> {
        let corpus = Sha256Digest { sha256: suite.digest().to_owned() };
        let predicate = Predicate { verifier, corpus, text: text(), result };
        let statement = Self { kind: STATEMENT.to_owned(), subject, predicate_type: PREDICATE.to_owned(), predicate };
        statement.check(suite)?;
        Ok(statement)
    }

    /// Makes sure that it is about files, of these vectors and this text, and that its verdict follows from its cases.
    fn check(&self, suite: &Suite) -> Result<(), AttestError> {
        is("_type", &self.kind, STATEMENT)?;
        is("predicateType", &self.predicate_type, PREDICATE)?;
        if self.subject.is_empty() {
            return Err(AttestError::NoSubject);
        }
        let Predicate { verifier, corpus, text: of_text, result } = &self.predicate;
        is("verifier", &verifier.name, "ncp-verify")?;
        for artefact in self.subject.iter().chain([verifier]) {
            let digest = &artefact.digest.sha256;
            if digest.len() != 64 || !digest.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f')) {
                let (found, here) = (digest.clone(), "no SHA-256".to_owned());
                return Err(AttestError::Digest { what: "file", found, here });
            }
        }
        for (what, found, here) in [("corpus", corpus, suite.digest().to_owned()), ("text", of_text, text().sha256)] {
            if found.sha256 != here {
                return Err(AttestError::Digest { what, found: found.sha256.clone(), here });
            }
        }
        let anew = serde_json::to_value(judged_anew(result, suite)?)?;
        match difference(&serde_json::to_value(result)?, &anew, String::new()) {
            None => Ok(()),
            Some((place, found, due)) => Err(AttestError::Verdict { place, found, due }),
        }
    }

    /// Makes sure that it is about a file.
    ///
    /// # Errors
    /// [`AttestError::Stranger`] if no file with these bytes is among its subjects.
    pub fn is_about(&self, file: &Artefact) -> Result<(), AttestError> {
        let found = self.subject.iter().any(|subject| subject.digest == file.digest);
        if found { Ok(()) } else { Err(AttestError::Stranger(file.name.clone())) }
    }
}

impl Artefact {
    /// A file of this name and these bytes.
    #[must_use]
    pub fn new(name: &str, bytes: &[u8]) -> Self {
        Self { name: name.to_owned(), digest: Sha256Digest { sha256: hex(&Sha256::digest(bytes)) } }
    }
}

impl Key {
    /// A new one, from the randomness of the machine.
    ///
    /// # Errors
    /// [`AttestError::Key`] if it has none.
    pub fn generate() -> Result<Self, AttestError> {
        let mut seed = [0; Seed::BYTES];
        getrandom::fill(&mut seed).map_err(|error| AttestError::Key(error.to_string()))?;
        let pair = KeyPair::try_from_seed(Seed::new(seed)).map_err(|error| AttestError::Key(error.to_string()))?;
        Ok(Self(pair.sk))
    }

    /// Reads a private key in PEM (PKCS #8), as `openssl genpkey -algorithm ed25519` writes it.
    ///
    /// # Errors
    /// [`AttestError::Key`].
    pub fn from_pem(pem: &str) -> Result<Self, AttestError> {
        SecretKey::from_pem(pem).map(Self).map_err(|error| AttestError::Key(error.to_string()))
    }

    /// In PEM.
    #[must_use]
    pub fn to_pem(&self) -> String {
        ended(self.0.to_pem())
    }

    /// The key by which its signatures are checked.
    #[must_use]
    pub fn public(&self) -> Believed {
        Believed(self.0.public_key())
    }
}

impl Believed {
    /// Reads a public key in PEM.
    ///
    /// # Errors
    /// [`AttestError::Key`] if it is none, or one with which anybody could sign.
    pub fn from_pem(pem: &str) -> Result<Self, AttestError> {
        let key = PublicKey::from_pem(pem).and_then(|key| key.validate().map(|()| key));
        key.map(Self).map_err(|error| AttestError::Key(error.to_string()))
    }

    /// In PEM.
    #[must_use]
    pub fn to_pem(&self) -> String {
        ended(self.0.to_pem())
    }

    /// What envelopes call it: the SHA-256 of its DER form.
    #[must_use]
    pub fn id(&self) -> String {
        hex(&Sha256::digest(self.0.to_der()))
    }
}

/// An envelope by DSSE.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Envelope {
    #[serde(rename = "payloadType")]
    payload_type: String,
    payload: String,
    signatures: Vec<Signed>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Signed {
    keyid: String,
    sig: String,
}

/// Signs a statement: the text of an envelope.
///
/// # Errors
/// If the statement cannot be written as JSON, which does not occur.
pub fn seal(statement: &Statement, key: &Key) -> Result<String, AttestError> {
    seal_bytes(&serde_json::to_vec(statement)?, key)
}

/// Signs bytes as though they were a statement.
///
/// # Errors
/// If the envelope cannot be written as JSON, which does not occur.
pub fn seal_bytes(payload: &[u8], key: &Key) -> Result<String, AttestError> {
    let signature = key.0.sign(authenticated(PAYLOAD, payload), None);
    let envelope = Envelope {
        payload_type: PAYLOAD.to_owned(),
        payload: STANDARD.encode(payload),
        signatures: vec![Signed { keyid: key.public().id(), sig: STANDARD.encode(signature) }],
    };
    Ok(serde_json::to_string_pretty(&envelope)? + "\n")
}

/// Opens an envelope: what it states, if that was signed by the key and holds.
///
/// # Errors
/// [`AttestError`] if it was not signed so, or does not hold.
pub fn open(envelope: &str, key: &Believed, suite: &Suite) -> Result<Statement, AttestError> {
    let envelope: Envelope = serde_json::from_str(envelope)?;
    is("payloadType", &envelope.payload_type, PAYLOAD)?;
    let [signed] = &envelope.signatures[..] else {
        return Err(AttestError::Signatures(envelope.signatures.len()));
    };
    if signed.keyid != key.id() {
        return Err(AttestError::OtherKey(signed.keyid.clone()));
    }
    let bytes = |what, text: &str| STANDARD.decode(text).map_err(|source| AttestError::Base64 { what, source });
    let (payload, signature) = (bytes("payload", &envelope.payload)?, bytes("signature", &signed.sig)?);
    let signature = Signature::from_slice(&signature).map_err(|_| AttestError::Signature)?;
    key.0.verify(authenticated(PAYLOAD, &payload), &signature).map_err(|_| AttestError::Signature)?;
    let statement: Statement = serde_json::from_slice(&payload)?;
    statement.check(suite)?;
    Ok(statement)
}

/// The digest of the text: of its chapters, each with its name and length.
#[must_use]
pub fn text() -> Sha256Digest {
    let mut digest = Sha256::new();
    for chapter in &CHAPTERS {
        digest.update(format!("{} {}\n", chapter.file, chapter.text.len()));
        digest.update(chapter.text);
    }
    Sha256Digest { sha256: hex(&digest.finalize()) }
}

/// What is signed of a payload: its pre-authentication encoding.
fn authenticated(kind: &str, payload: &[u8]) -> Vec<u8> {
    let mut bytes = format!("DSSEv1 {} {kind} {} ", kind.len(), payload.len()).into_bytes();
    bytes.extend_from_slice(payload);
    bytes
}

fn is(what: &'static str, found: &str, expected: &'static str) -> Result<(), AttestError> {
    if found == expected { Ok(()) } else { Err(AttestError::Kind { what, found: found.to_owned(), expected }) }
}

/// Where two values first differ, with what stands there.
fn difference(found: &Value, due: &Value, place: String) -> Option<(String, String, String)> {
    match (found, due) {
        (Value::Object(these), Value::Object(those)) => {
            let names = these.keys().chain(those.keys().filter(|name| !these.contains_key(*name)));
            names.into_iter().find_map(|name| {
                let of = |members: &serde_json::Map<String, Value>| members.get(name).cloned().unwrap_or_default();
                difference(&of(these), &of(those), format!("{place}/{name}"))
            })
        }
        (Value::Array(these), Value::Array(those)) if these.len() == those.len() => {
            let pairs = these.iter().zip(those).enumerate();
            pairs.into_iter().find_map(|(at, (this, that))| difference(this, that, format!("{place}/{at}")))
        }
        _ if found == due => None,
        _ => Some((place, brief(found), brief(due))),
    }
}

fn brief(value: &Value) -> String {
    crate::peer::excerpt(value.to_string().as_bytes(), 80)
}

fn ended(mut text: String) -> String {
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
