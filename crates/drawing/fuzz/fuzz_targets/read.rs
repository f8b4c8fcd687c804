//! Any bytes: reading never panics, and every finding has its card.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let options = drawing::Options { unit: Some(1.0), ..drawing::Options::default() };
    let read = drawing::read(bytes, &options);
    for finding in &read.findings {
        assert!(drawing::cards::CARDS.iter().any(|card| card.code == finding.code));
    }
});
