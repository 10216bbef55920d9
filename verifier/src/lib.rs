//! Holds any peer of NCP against the frozen vectors and says, case by case, whether it conforms.
//!
//! The program `ncp-verify` is [`cli::main`] around this library. Its rooms, in the order in which a run passes them:
//!
//! | module | what it does |
//! |---|---|
//! | [`cli`] | takes the command line apart, finds the bundled peers, decides the exit code |
//! | [`suite`] | the cases, tied to the rules of the text |
//! | [`peer`] | starts a peer and speaks the peer protocol with it |
//! | [`run`](mod@run) | keeps requests in flight, and charges a fault to the case that causes it |
//! | [`shard`] | deals the cases to several machines |
//! | [`check`] | judges one answer by the relation that its case states |
//! | [`verdict`] | folds outcomes into levels per role, under a peer's expected failures |
//! | [`diagnosis`] | ranks the rules that a peer most likely breaks |
//! | [`dictionary`] | explains what a peer does by the fewest known defects |
//! | [`severity`] | what it costs to break a rule |
//! | [`fuzz`] | searches a peer by inputs drawn at random, held against the specification |
//! | [`conclude`] | from what became of a peer's cases to the report on it |
//! | [`journal`] | a run as it goes on, on disk, so that one that was killed is resumed |
//! | [`merge`] | one result from those of shards |
//! | [`attest`] | a result that somebody answers for: a signed statement |
//! | [`diff`] | compares two results of one peer, case by case |
//! | [`gate`] | what has to hold of a tree before it is released |
//! | [`report`] | one model of a result, rendered for terminals, and in the formats of files |
//! | [`json`] | JSON as it is spelled: order, repeated members, `5` and `5.0` apart |
//! | [`stop`] | the wish that everything that runs comes to an end |
//!
//! No rule of NCP is written a second time here: what a frame, a block or a level means is asked of [`ncp_spec`].

#![forbid(unsafe_code)]

pub mod attest;
pub mod check;
pub mod cli;
pub mod conclude;
pub mod diagnosis;
pub mod dictionary;
pub mod diff;
pub mod fuzz;
pub mod gate;
pub mod journal;
pub mod json;
pub mod merge;
pub mod peer;
pub mod report;
pub mod run;
pub mod severity;
pub mod shard;
pub mod stop;
pub mod suite;
pub mod verdict;
