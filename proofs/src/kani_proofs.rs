//! The harnesses of the kernel as proofs of Kani.

crate::kani_proofs! {
    crate::harness::kani_harness:
    watchdog_deadline = "watchdog/deadline", 1;
    watchdog_ttl = "watchdog/ttl", 1;
    watchdog_order = "watchdog/order", 1;
    watchdog_step = "watchdog/step", 1;
    watchdog_sequence = "watchdog/sequence", 7;
    geofence_inside = "geofence/inside", 4;
    geofence_range = "geofence/range", 4;
    geofence_limit = "geofence/limit", 1;
    geofence_projection = "geofence/projection", 5;
    geofence_projection_and_clamp = "geofence/projection-and-clamp", 5;
    geofence_step = "geofence/step", 4;
    geofence_follow = "geofence/follow", 4098;
    geofence_long = "geofence/long", 4098;
    clamp_bound = "clamp/bound", 4;
    clamp_unchanged = "clamp/unchanged", 4;
    clamp_direction = "clamp/direction", 4;
    clamp_range = "clamp/range", 4;
    clamp_tick = "clamp/tick", 4;
    clamp_channel = "clamp/channel", 5;
    clamp_channels = "clamp/channels", 4098;
    latch_new = "latch/new", 4;
    latch_event = "latch/event", 4;
    latch_govern = "latch/govern", 6;
    latch_gates = "latch/gates", 5;
    latch_plant = "latch/plant", 11;
    latch_sequence = "latch/sequence", 7;
    latch_plant_sequence = "latch/plant-sequence", 7;
    latch_horizon = "latch/horizon", 6;
    latch_closed = "latch/closed", 4098;
    latch_replay = "latch/replay", 10;
    number_operations = "number/operations", 10;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kani_engine::begin;
    use crate::properties::PROPERTIES;

    #[test]
    fn every_property_is_a_proof_of_kani_that_runs() {
        let table: Vec<_> = PROPERTIES.iter().map(|property| property.id).collect();
        let proofs: Vec<_> = PROOFS.iter().map(|(id, ..)| *id).collect();
        assert_eq!(proofs, table);
        for (.., proof) in PROOFS {
            for seed in 0..1_000 {
                begin(seed);
                proof();
            }
        }
    }
}
