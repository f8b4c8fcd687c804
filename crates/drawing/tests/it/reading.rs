//! What is read, in metres, with every repair said.

use crate::{area, bytes, on, read};
use drawing::{Concave, Options, Severity};
use std::f64::consts::PI;

#[test]
fn the_voussoirs_of_bridgemill_are_read_in_metres() {
    // Independent of the script: the geometry of a circular segment.
    let (span, rise, ring) = (18.30f64, 2.85, 0.711);
    let radius = (span * span / 4.0 + rise * rise) / (2.0 * rise);
    let half = (span / 2.0 / radius).asin();
    let drawing = read("bridgemill.dxf").drawing;
    assert!((drawing.unit - 1e-3).abs() < 1e-15);
    let voussoirs: Vec<_> = drawing.outlines.iter().filter(|o| o.layer == "RING").collect();
    assert_eq!((voussoirs.len(), drawing.outlines.len()), (62, 64));
    for (k, voussoir) in voussoirs.iter().enumerate() {
        assert_eq!(voussoir.points.len(), 4);
        let angle = half - 2.0 * half * k as f64 / 62.0;
        let foot = [span / 2.0 - radius * angle.sin(), rise - radius + radius * angle.cos()];
        let nearest = voussoir.points.iter().map(|p| (p[0] - foot[0]).hypot(p[1] - foot[1])).fold(1.0, f64::min);
        // ezdxf prints sixteen digits of millimetres.
        assert!(nearest < 1e-11, "{k}: {nearest}");
        let sector = 0.5 * ((radius + ring).powi(2) - radius.powi(2)) * (2.0 * half / 62.0).sin();
        assert!((area(&voussoir.points) - sector).abs() < 1e-9);
    }
}

#[test]
fn faces_drawn_as_arcs_become_chords_within_the_tolerance_or_are_concave() {
    // The sagitta of an intrados of 0.322 m on a radius of 16.1 m is 0.80 mm.
    let coarse = read("bridgemill-arcs.dxf");
    assert!(coarse.is_usable());
    let flat = read("bridgemill.dxf");
    for (a, b) in coarse.drawing.outlines.iter().zip(&flat.drawing.outlines) {
        assert_eq!(a.points.len(), b.points.len());
        let apart = a.points.iter().zip(&b.points).map(|(p, q)| (p[0] - q[0]).hypot(p[1] - q[1]));
        assert!(apart.fold(0.0, f64::max) < 1e-9);
    }
    assert_eq!(coarse.findings.iter().filter(|f| f.code == "D203").count(), 62);
    let fine = drawing::read(&bytes("bridgemill-arcs.dxf"), &Options { chord_tolerance: 2e-4, ..Options::default() });
    let hollow: Vec<_> = fine.findings.iter().filter(|f| f.code == "D303").collect();
    assert_eq!(hollow.len(), 62);
    assert!(hollow[0].help.contains("chord_tolerance") && hollow[0].place.at.is_some());
}

#[test]
fn curves_keep_their_areas_to_the_chord_tolerance() {
    let tolerance = 1e-5;
    let read = drawing::read(&bytes("curves.dxf"), &Options { chord_tolerance: tolerance, ..Options::default() });
    assert!(read.is_usable(), "{:?}", read.findings);
    let of = |layer: &str| {
        let found: Vec<_> = read.drawing.outlines.iter().filter(|o| o.layer == layer).collect();
        assert_eq!(found.len(), 1, "{layer}");
        area(&found[0].points)
    };
    let head = 1.0 + PI * 0.25 / 2.0;
    // A bulge of a half on a chord of one metre: radius 5/8 m, angle 4 atan(1/2).
    let angle = 4.0 * 0.5f64.atan();
    let segment = 1.0 + 0.5 * 0.625 * 0.625 * (angle - angle.sin());
    for (layer, exact, length) in [
        ("BULGE", head, PI * 0.5),
        ("LOOSE", head, PI * 0.5),
        ("ELLIPSE", PI * 1.25 * 0.4, 2.0 * PI * 1.118),
        ("SPLINE", PI * 0.25, PI),
        ("BELOW", 0.5, 0.0),
        ("OLD", segment, 0.625 * angle),
    ] {
        // No chord lies farther from its curve than the tolerance.
        let missing = exact - of(layer);
        assert!(missing > -1e-12 && missing <= tolerance * length + 1e-12, "{layer}: {missing}");
    }
    let circle = &read.drawing.circles[0];
    assert_eq!((circle.layer.as_str(), circle.centre, circle.radius), ("ROUND", [7.0, 0.5], 0.5));
    let below = read.drawing.outlines.iter().find(|o| o.layer == "BELOW").unwrap();
    assert!(below.points.contains(&[16.0, 0.0]) && area(&below.points) > 0.0);
}

#[test]
fn repairs_are_said_with_their_places() {
    let read = read("repairs.dxf");
    assert!(read.is_usable());
    for outline in &read.drawing.outlines {
        assert_eq!(outline.points.len(), 4, "{}", outline.layer);
        assert!((area(&outline.points) - 1.0).abs() < 1e-3);
    }
    for (layer, code, severity, count) in [
        ("DUPLICATE", "D201", Severity::Note, 1),
        ("COLLINEAR", "D202", Severity::Note, 1),
        ("CLOCKWISE", "D206", Severity::Note, 1),
        ("GAPS", "D204", Severity::Warning, 4),
        ("GAPS", "D205", Severity::Note, 1),
        ("ENDS", "D204", Severity::Warning, 1),
    ] {
        let found: Vec<_> = on(&read, layer, severity).into_iter().filter(|f| f.code == code).collect();
        assert_eq!(found.len(), count, "{layer} {code}");
        let place = &found[0].place;
        assert!(place.at.is_some() && place.entity.contains(' '), "{place}");
    }
}

#[test]
fn references_are_expanded_with_scale_rotation_mirror_and_arrays() {
    let read =
        drawing::read(&bytes("references.dxf"), &Options { ignored: vec!["stretched".into()], ..Options::default() });
    // What lies in a block on a layer of its own stays there.
    let outlines = |layer: &'static str| read.drawing.outlines.iter().filter(move |o| o.layer == layer);
    let box_of = |layer: &'static str| {
        let points = || outlines(layer).flat_map(|o| &o.points);
        let fold = |k: usize, pick: fn(f64, f64) -> f64, start: f64| points().map(|p| p[k]).fold(start, pick);
        let low = [fold(0, f64::min, f64::INFINITY), fold(1, f64::min, f64::INFINITY)];
        let high = [fold(0, f64::max, f64::NEG_INFINITY), fold(1, f64::max, f64::NEG_INFINITY)];
        [low, high].map(|p| p.map(|x| (x * 1e9).round() / 1e9))
    };
    assert_eq!(box_of("PLAIN"), [[0.0, 0.0], [0.2, 0.1]]);
    assert_eq!(box_of("TURNED"), [[1.8, 0.0], [2.0, 0.4]]);
    assert_eq!(box_of("MIRRORED"), [[3.8, 0.0], [4.0, 0.1]]);
    assert_eq!((outlines("ARRAY").count(), box_of("ARRAY")), (6, [[6.0, 0.0], [6.7, 0.25]]));
    assert_eq!((outlines("NESTED").count(), box_of("NESTED")), (2, [[9.0, 0.0], [9.2, 0.2]]));
    // Entities of blocks are named by the handles of the file.
    assert!(outlines("ARRAY").all(|o| o.place.entity.starts_with("LWPOLYLINE 32 in INSERT ")));
    let radii: Vec<f64> = read.drawing.circles.iter().map(|c| c.radius).collect();
    assert_eq!(radii.len(), 11);
    assert!(radii.iter().filter(|r| (**r - 0.04).abs() < 1e-12).count() == 1, "twice the size: {radii:?}");
    // The stretched dowel is an ellipse of 60 mm by 20 mm.
    let ellipse = outlines("DOWELS").next().unwrap();
    assert!((area(&ellipse.points) - PI * 0.06 * 0.02).abs() < 3e-4);
}

#[test]
fn without_a_unit_nothing_is_assumed() {
    for name in ["unitless.dxf", "r12.dxf"] {
        let silent = read(name);
        assert_eq!(silent.findings.iter().filter(|f| f.code == "D102").count(), 1, "{name}");
        assert!(!silent.is_usable());
        let stated = drawing::read(&bytes(name), &Options { unit: Some(1e-3), ..Options::default() });
        assert!(stated.is_usable(), "{name}: {:?}", stated.findings);
    }
    let old = drawing::read(&bytes("r12.dxf"), &Options { unit: Some(1.0), ..Options::default() });
    assert_eq!((old.drawing.outlines.len(), old.drawing.circles[0].radius), (1, 0.5));
    let two = drawing::read(&bytes("heap.dxf"), &Options { unit: Some(1.0), ..Options::default() });
    assert!(two.is_usable() && two.findings.iter().any(|f| f.code == "D108"));
    assert_eq!(read("heap.dxf").drawing.circles.iter().map(|c| c.radius).fold(0.0, f64::max), 0.1);
}

#[test]
fn what_is_left_out_is_counted_by_layer_and_kind() {
    let read = read("left-out.dxf");
    assert!(read.is_usable() && read.drawing.outlines.len() == 1);
    let said: Vec<String> = read.findings.iter().map(|f| format!("{} {}", f.place.layer, f.message)).collect();
    for part in ["NOTES 3 of kind TEXT", "HATCHES 1 of kind HATCH", "BLOCKS 1 of kind POINT"] {
        assert!(said.iter().any(|line| line.starts_with(part)), "{part}: {said:?}");
    }
    let ignored = vec!["notes".into(), "Hatches".into()];
    let quiet = drawing::read(&bytes("left-out.dxf"), &Options { ignored, ..Options::default() });
    assert_eq!(quiet.findings.len(), 1);
}

#[test]
fn a_concave_outline_can_be_cut() {
    let others = ["UNCLOSED", "CROSSED", "FLAT", "OVER", "TWICE", "SHARED", "SPACE"];
    let options = Options {
        concave: Concave::Cut,
        ignored: others.iter().map(|name| (*name).to_owned()).collect(),
        ..Options::default()
    };
    let read = drawing::read(&bytes("refused.dxf"), &options);
    assert!(read.is_usable(), "{:?}", read.findings);
    let areas: f64 = read.drawing.outlines.iter().map(|o| area(&o.points)).sum();
    assert_eq!((read.drawing.outlines.len(), areas), (2, 3.0));
    assert_eq!(read.findings.iter().map(|f| f.code).collect::<Vec<_>>(), ["D207"]);
}
