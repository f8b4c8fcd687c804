//! What cannot be used, all of it at once and each with its place.

use crate::read;
use drawing::Severity;

#[test]
fn every_refusal_names_its_place() {
    let read = read("refused.dxf");
    assert!(!read.is_usable());
    for (layer, code, at) in [
        ("UNCLOSED", "D301", [0.0, 1.0]),
        ("CROSSED", "D302", [2.5, 0.5]),
        ("CONCAVE", "D303", [5.0, 1.0]),
        ("FLAT", "D304", [7.0, 0.0]),
        ("OVER", "D305", [10.95, 0.75]),
        ("TWICE", "D305", [13.5, 0.5]),
        ("SHARED", "D301", [16.0, 0.0]),
    ] {
        let found = read.findings.iter().find(|f| f.place.layer == layer && f.code == code);
        let found = found.unwrap_or_else(|| panic!("{layer}: {:?}", read.findings));
        assert_eq!(found.severity, Severity::Error);
        let place = found.place.at.expect("coordinates");
        assert!((place[0] - at[0]).hypot(place[1] - at[1]) < 1e-9, "{layer}: {place:?}");
        assert!(!found.help.is_empty() && found.place.entity.contains(' '));
    }
    assert!(read.findings.iter().any(|f| f.code == "D105" && f.place.layer == "SPACE"));
}

#[test]
fn every_code_has_a_card() {
    for name in ["refused.dxf", "repairs.dxf", "curves.dxf", "references.dxf", "r12.dxf", "left-out.dxf"] {
        for finding in read(name).findings {
            assert!(drawing::cards::CARDS.iter().any(|card| card.code == finding.code), "{}", finding.code);
        }
    }
}
