//! A good file gives the bridge it describes, without a word.

use bridge::{Method, read};

/// Bridgemill, case 1 of Rouxinol, Providência and Lemos.
const CASE_1: &[u8] = include_bytes!("files/case-1.toml");

#[test]
fn bridgemill_reads_without_findings() {
    let read = read(CASE_1);
    assert_eq!(read.diagnostics, []);
    let bridge = read.bridge.expect("a bridge");
    assert_eq!(bridge.name, "Bridgemill");
    assert_eq!(bridge.spans.len(), 1);
    assert_eq!(bridge.spans[0].rings[0].voussoirs, 62);
    assert_eq!(bridge.masonry.rounding, 0.01);
    assert!((bridge.cover.depth - 0.478).abs() < 1e-15);
    assert!(bridge.cover.layers.iter().all(|layer| !layer.weighs));
    assert!((bridge.loads[0].position - 4.575).abs() < 1e-15);
    assert_eq!(bridge.plan.method, Method::Dem);
    assert!((bridge.plan.load_step.unwrap() - 100e3 / 8.3).abs() < 1e-9);
}
