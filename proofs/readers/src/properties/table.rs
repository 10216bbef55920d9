//! What is claimed of the readers, in words and in symbols.

use super::{Family, Property};

const UTF8: &str =
    "Bytes that are not UTF-8 never reach a `&str`; they are drawn and left aside (std's reader of UTF-8).";
const BY_CLASS: &str = "In strings of 4 to 8 bytes, characters of one class are answered alike; shown for all byte \
    strings of up to 3 bytes and for every character of Unicode in contexts, where a string is answered as that of \
    its classes' first members. Which member stands in a string depends on its place.";

/// All of them.
pub const PROPERTIES: &[Property] = &[
    Property {
        id: "bulk/header",
        family: Family::Bulk,
        rules: &[
            "NCP-BULK-001",
            "NCP-BULK-002",
            "NCP-BULK-003",
            "NCP-BULK-004",
            "NCP-BULK-005",
            "NCP-BULK-006",
            "NCP-BULK-016",
            "NCP-BULK-022",
        ],
        sentence: "A buffer is accepted exactly when its header is that of 5.1, states the buffer's length, and its \
            directory fits; nothing panics.",
        statement: "∀ buffers b of the product: decode(b) = model(b), where the model marks the owner of every byte",
        bounds: "buffers of 0 to 64 bytes, every prefix of a block of 2 columns; n_cols ∈ {0, 1, 2, 3, 256, 4096, \
            4097, 65535}; total_len of 6 values; each letter flipped in 2 ways; 5 versions; 5 flags: all combined",
        assumptions: &[],
        unwind: 70,
        length: 0,
    },
    Property {
        id: "bulk/entry",
        family: Family::Bulk,
        rules: &[
            "NCP-BULK-007",
            "NCP-BULK-008",
            "NCP-BULK-009",
            "NCP-BULK-010",
            "NCP-BULK-011",
            "NCP-BULK-012",
            "NCP-BULK-014",
            "NCP-BULK-018",
            "NCP-BULK-019",
            "NCP-BULK-020",
            "NCP-BULK-022",
            "NCP-BULK-023",
            "NCP-BULK-024",
        ],
        sentence: "A block of one column is accepted exactly by the rules, and gives exactly its name and values, of \
            no more bytes than the block has, at every boundary of every field; nothing panics.",
        statement: "∀ entries e of the product: decode(block(e)) = model(block(e)); and Σ(|name| + |values|) ≤ |block|",
        bounds: "one column over a block of 48 bytes; 29 name_off × 8 name_len × 13 (dtype, pad) × 16 n_rows × 29 \
            data_off, around 0, the header's, the directory's and the buffer's end, 2³¹, 2³² and the products that \
            overflow 32 bits",
        assumptions: &[],
        unwind: 70,
        length: 0,
    },
    Property {
        id: "bulk/directories",
        family: Family::Bulk,
        rules: &[
            "NCP-BULK-007",
            "NCP-BULK-008",
            "NCP-BULK-009",
            "NCP-BULK-010",
            "NCP-BULK-011",
            "NCP-BULK-012",
            "NCP-BULK-013",
            "NCP-BULK-019",
            "NCP-BULK-020",
            "NCP-BULK-021",
            "NCP-BULK-024",
        ],
        sentence: "Directories of up to three columns are accepted exactly by the rules, whatever overlaps, touches \
            or shares a name, and give exactly their columns in order; nothing panics.",
        statement: "∀ directories d of the product: decode(block(d)) = model(block(d)); and Σ(|name| + |values|) ≤ \
            |block|",
        bounds: "no column; 1 and 2 columns of 8 name_off × 4 name_len × 3 (dtype, pad) × 4 n_rows × 8 data_off \
            each; 3 columns of 4 × 3 × 3 × 2 × 4 each",
        assumptions: &[],
        unwind: 110,
        length: 3,
    },
    Property {
        id: "bulk/columns",
        family: Family::Bulk,
        rules: &["NCP-BULK-022", "NCP-BULK-023", "NCP-BULK-030", "NCP-BULK-032", "NCP-BULK-033", "NCP-BULK-034"],
        sentence: "Columns of distinct names are encoded as the block of the text, to the byte, and decode to the \
            same columns, to the bit; equal names are refused.",
        statement: "∀ column sets c: encode(c) = layout(c); and decode(encode(c)) = c = model(encode(c))",
        bounds: "0 to 3 columns, each of 3 names × 4 dtypes × 0 to 2 rows of 3 edge values (−0, NaN with a payload, \
            all ones)",
        assumptions: &[],
        unwind: 130,
        length: 3,
    },
    Property {
        id: "version/bytes",
        family: Family::Version,
        rules: &["NCP-VER-001", "NCP-VER-002", "NCP-VER-003", "NCP-VER-006", "NCP-VER-007", "NCP-VER-008"],
        sentence: "Every string of up to three bytes is answered as the automaton of 2.1 says, strict or not, and as \
            the string of its classes.",
        statement: "∀ s ∈ UTF-8, |s| ≤ 3, strict: check(s, strict) = automaton(s, strict) = check(classes(s), strict)",
        bounds: "all 256 values of each of 0 to 3 bytes",
        assumptions: &[UTF8],
        unwind: 10,
        length: 3,
    },
    Property {
        id: "version/scalars",
        family: Family::Version,
        rules: &["NCP-VER-001"],
        sentence: "Every character of Unicode, between parts of versions, is answered as the automaton says and as \
            any of its class.",
        statement: "∀ c ∈ Unicode, a, b ∈ {ε, 0., .5, 0.5}, strict: check(acb, strict) = automaton(acb, strict) = \
            check(classes(acb), strict)",
        bounds: "all 1,112,064 characters in 16 contexts",
        assumptions: &[],
        unwind: 20,
        length: 3,
    },
    Property {
        id: "version/classes",
        family: Family::Version,
        rules: &[
            "NCP-VER-001",
            "NCP-VER-002",
            "NCP-VER-003",
            "NCP-VER-004",
            "NCP-VER-006",
            "NCP-VER-007",
            "NCP-VER-008",
            "NCP-VER-009",
        ],
        sentence: "Every string of classes of up to eight bytes is answered as the automaton of 2.1 says, by value, \
            strict or not.",
        statement: "∀ s ∈ classes*, |s| ≤ 8, strict: check(s, strict) = automaton(s, strict)",
        bounds: "strings of 0 to 8 bytes over the classes 0, 5, other digits, dot, sign, white space, letter, other \
            ASCII, and characters of 2, 3 and 4 bytes",
        assumptions: &[UTF8, BY_CLASS],
        unwind: 10,
        length: 8,
    },
    Property {
        id: "keys/bytes",
        family: Family::Keys,
        rules: &[
            "NCP-KEY-010",
            "NCP-KEY-011",
            "NCP-KEY-012",
            "NCP-KEY-013",
            "NCP-KEY-014",
            "NCP-KEY-015",
            "NCP-KEY-016",
            "NCP-KEY-018",
            "NCP-KEY-020",
        ],
        sentence: "Every string of up to three bytes is accepted as a segment, and as a realm, exactly as the \
            automaton of 3.3 says, and alike with the string of its classes.",
        statement: "∀ s ∈ UTF-8, |s| ≤ 3: segment(s) = automaton(s) = segment(classes(s)); realm likewise",
        bounds: "all 256 values of each of 0 to 3 bytes",
        assumptions: &[UTF8],
        unwind: 10,
        length: 3,
    },
    Property {
        id: "keys/scalars",
        family: Family::Keys,
        rules: &["NCP-KEY-011", "NCP-KEY-012", "NCP-KEY-015", "NCP-KEY-016", "NCP-KEY-020"],
        sentence: "Every character of Unicode, between others, is accepted in a segment and in a realm exactly as \
            the automaton says, and as any of its class.",
        statement: "∀ c ∈ Unicode, a, b ∈ {ε, a, ., @, /}: segment(acb) = automaton(acb) = segment(classes(acb)); \
            realm likewise",
        bounds: "all 1,112,064 characters in 25 contexts",
        assumptions: &[],
        unwind: 20,
        length: 4,
    },
    Property {
        id: "keys/segment",
        family: Family::Keys,
        rules: &[
            "NCP-KEY-002",
            "NCP-KEY-006",
            "NCP-KEY-007",
            "NCP-KEY-010",
            "NCP-KEY-011",
            "NCP-KEY-012",
            "NCP-KEY-013",
            "NCP-KEY-014",
            "NCP-KEY-015",
            "NCP-KEY-016",
            "NCP-KEY-019",
            "NCP-KEY-020",
        ],
        sentence: "Every string of classes of up to eight bytes is accepted as a session id exactly as the automaton \
            of 3.3 says, and then stands in the key unchanged.",
        statement: "∀ s ∈ classes*, |s| ≤ 8: segment(s) = automaton(s); sensor(s) = ncp/session/s/sensor, or an error",
        bounds: "strings of 0 to 8 bytes over 12 classes: plain ASCII, dot, @, slash, `*$#?`, white space, C0, DEL, \
            C1, and other characters of 2, 3 and 4 bytes; the limit of 256 bytes (NCP-KEY-017) is beyond them",
        assumptions: &[UTF8, BY_CLASS],
        unwind: 30,
        length: 8,
    },
    Property {
        id: "keys/realm",
        family: Family::Keys,
        rules: &["NCP-KEY-001", "NCP-KEY-007", "NCP-KEY-010", "NCP-KEY-018", "NCP-KEY-019", "NCP-KEY-020"],
        sentence: "Every string of classes of up to eight bytes is accepted as a realm exactly when each part \
            between slashes is a segment, and then stands in the key unchanged.",
        statement: "∀ s ∈ classes*, |s| ≤ 8: realm(s) = automaton of segments and slashes(s); rpc(s) = s/rpc, or an \
            error",
        bounds: "as keys/segment",
        assumptions: &[UTF8, BY_CLASS],
        unwind: 30,
        length: 8,
    },
    Property {
        id: "keys/builders",
        family: Family::Keys,
        rules: &[
            "NCP-KEY-001",
            "NCP-KEY-002",
            "NCP-KEY-003",
            "NCP-KEY-004",
            "NCP-KEY-005",
            "NCP-KEY-006",
            "NCP-KEY-007",
            "NCP-KEY-018",
            "NCP-KEY-019",
        ],
        sentence: "Every key of the table of 3.2 is built from its realm, id and name unchanged, and refused when \
            one of those that it takes is refused.",
        statement: "∀ keys k of 8, places (realm, id, name), s ∈ classes*, |s| ≤ 3: build(k, s) = table(k, s), or an \
            error",
        bounds: "strings of 0 to 3 bytes over the classes of keys/segment, in every place of every key",
        assumptions: &[UTF8],
        unwind: 30,
        length: 3,
    },
];
