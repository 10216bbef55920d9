//! The harnesses of the readers as proofs of Kani: `cargo kani -p ncp-readers`, where Kani can be installed; strings
//! are of any bytes and classes there, of up to 8 bytes.

ncp_proofs::kani_proofs! {
    crate::properties::kani_harness:
    bulk_header = "bulk/header", 70;
    bulk_entry = "bulk/entry", 70;
    bulk_directories = "bulk/directories", 110;
    bulk_columns = "bulk/columns", 130;
    version_bytes = "version/bytes", 10;
    version_scalars = "version/scalars", 20;
    version_classes = "version/classes", 10;
    keys_bytes = "keys/bytes", 10;
    keys_scalars = "keys/scalars", 20;
    keys_segment = "keys/segment", 30;
    keys_realm = "keys/realm", 30;
    keys_builders = "keys/builders", 30;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::properties::PROPERTIES;
    use ncp_proofs::kani_engine::begin;

    #[test]
    fn every_property_is_a_proof_of_kani_that_runs() {
        let table: Vec<_> = PROPERTIES.iter().map(|p| (p.id, p.unwind)).collect();
        let proofs: Vec<_> = PROOFS.iter().map(|(id, unwind, _)| (*id, *unwind)).collect();
        assert_eq!(proofs, table);
        for (_, _, proof) in PROOFS {
            for seed in 0..300 {
                begin(seed);
                proof();
            }
        }
    }
}
