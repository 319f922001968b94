//! Any payload as the reduced model in `resources/`, with a header that fits: it is refused, or flies.

#![no_main]

use std::sync::LazyLock;

use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft_fuzz as support;
use libfuzzer_sys::fuzz_target;

/// Magic, length, hash.
const HEADER: usize = 32;
const MAGIC: usize = 8;

static WING: LazyLock<Vec<u8>> = LazyLock::new(|| support::wing().to_bytes());

fuzz_target!(init: support::seed("reduced_model", "seed", &WING[HEADER..]), |payload: &[u8]| {
    let mut bytes = WING[..MAGIC].to_vec();
    bytes.extend((payload.len() as u64).to_le_bytes());
    bytes.extend(support::hash(payload).to_le_bytes());
    bytes.extend(payload);
    if let Ok(model) = ReducedModel::from_bytes(&bytes) {
        assert!(ReducedModel::from_bytes(&model.to_bytes()).is_ok());
        support::fly(model);
    }
});
