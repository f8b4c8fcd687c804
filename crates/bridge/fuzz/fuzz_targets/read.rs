//! Any bytes: reading never panics, and whatever is refused has a place and a remedy.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let listed = bridge::read_blocks(bytes);
    let refused = listed.diagnostics.iter().any(|finding| finding.severity == bridge::Severity::Error);
    assert_eq!(listed.file.is_none(), refused);
    let read = bridge::read(bytes);
    let refused = read.diagnostics.iter().any(|finding| finding.severity == bridge::Severity::Error);
    assert_eq!(read.bridge.is_none(), refused);
    for finding in &read.diagnostics {
        assert!(finding.range.start <= finding.range.end && finding.range.end <= bytes.len());
        assert!(finding.help.is_some());
        finding.range.position(bytes);
    }
});
