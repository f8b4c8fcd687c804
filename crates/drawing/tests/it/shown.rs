//! What a drawing does not show, splines by fit points, and headers that say two things.

use crate::area;
use drawing::{Finding, Options, Read, Severity};

/// A drawing of these pairs: header variables, layers (name, flags, colour), blocks and entities.
fn drawn(header: &str, layers: &[(&str, i16, i16)], blocks: &str, entities: &str) -> Vec<u8> {
    let layers: String = layers
        .iter()
        .map(|(name, flags, colour)| format!("0 LAYER 2 {name} 70 {flags} 62 {colour} 6 CONTINUOUS "))
        .collect();
    let text = format!(
        "0 SECTION 2 HEADER {header} 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER 70 9 {layers} 0 ENDTAB 0 ENDSEC \
         0 SECTION 2 BLOCKS {blocks} 0 ENDSEC 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"
    );
    text.split_whitespace().map(|word| format!("{word}\n")).collect::<String>().into_bytes()
}

const METRES: &str = "9 $INSUNITS 70 6";

/// A square of a metre with its left lower corner at x, and other groups.
fn square(x: f64, groups: &str) -> String {
    let corners: String =
        [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]].iter().map(|[x, y]| format!("10 {x} 20 {y} ")).collect();
    format!("0 LWPOLYLINE {groups} 90 4 70 1 {corners} ")
}

fn read(bytes: &[u8]) -> Read {
    drawing::read(bytes, &Options::default())
}

fn of<'a>(read: &'a Read, code: &str) -> Vec<&'a Finding> {
    read.findings.iter().filter(|finding| finding.code == code).collect()
}

/// Left ends of the outlines, in their order.
fn lefts(read: &Read) -> Vec<f64> {
    let left = |o: &drawing::Outline| o.points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    read.drawing.outlines.iter().map(left).collect()
}

const LAYERS: [(&str, i16, i16); 5] = [("RING", 0, 7), ("OLD", 0, -7), ("Survey", 1, 7), ("BOTH", 1, -3), ("0", 0, 7)];

#[test]
fn what_is_off_frozen_invisible_or_on_paper_is_left_out_and_told() {
    let all = [
        square(0.0, "8 RING"),
        square(2.0, "8 old"),
        square(4.0, "8 SURVEY"),
        square(5.0, "8 SURVEY"),
        square(6.0, "8 BOTH"),
        square(8.0, "60 1 8 RING"),
        square(10.0, "67 1 8 RING"),
        square(12.0, "60 0 67 0 8 RING"),
        "0 TEXT 8 OLD 1 note 0 TEXT 60 1 8 RING 1 note ".to_owned(),
        // What is not shown need not be whole.
        "0 LINE 8 OLD 10 x 20 0 11 0 21 0 ".to_owned(),
    ];
    let read = read(&drawn(METRES, &LAYERS, "", &all.concat()));
    assert!(read.is_usable(), "{:?}", read.findings);
    assert_eq!((lefts(&read), read.drawing.layers.len()), (vec![0.0, 12.0], 1));
    let told: Vec<(Severity, &str)> = of(&read, "D109").iter().map(|f| (f.severity, f.message.as_str())).collect();
    let warning = Severity::Warning;
    let expected = [
        (warning, "the layer BOTH is frozen: 1 entity on it left out"),
        (warning, "1 entity on the layer RING left out: marked invisible"),
        (Severity::Note, "1 entity on the layer RING left out: in paper space"),
        (warning, "the layer SURVEY is frozen: 2 entities on it left out"),
        (warning, "the layer OLD is off: 1 entity on it left out"),
        (warning, "the layer old is off: 1 entity on it left out"),
    ];
    assert_eq!(told.len(), expected.len(), "{told:?}");
    assert!(expected.iter().all(|one| told.contains(one)), "{told:?}");
    assert!(of(&read, "D104").is_empty(), "{:?}", read.findings);
    let ignored = ["old", "survey", "both", "ring"].map(String::from).to_vec();
    let quiet = drawing::read(&drawn(METRES, &LAYERS, "", &all.concat()), &Options { ignored, ..Options::default() });
    assert!(of(&quiet, "D109").is_empty(), "{:?}", quiet.findings);
}

#[test]
fn block_references_hide_what_cad_hides() {
    // In the block: layer 0 (takes that of the reference), a layer that is shown, one that is off, one that is invisible itself.
    let inner = [square(0.0, "8 0"), square(2.0, "8 RING"), square(4.0, "8 OLD"), square(6.0, "60 1 8 RING")].concat();
    let blocks = format!("0 BLOCK 8 0 2 STONE 70 0 10 0 20 0 {inner} 0 ENDBLK");
    let insert = |layer: &str, y: f64| format!("0 INSERT 8 {layer} 2 STONE 10 0 20 {y} ");
    for (layer, groups, expected) in [
        ("RING", "", vec![0.0, 2.0]),
        // A layer that is off hides what lies on it, not what the reference draws elsewhere; a frozen one hides the reference.
        ("OLD", "", vec![2.0]),
        ("SURVEY", "", vec![]),
        ("RING", "60 1 ", vec![]),
    ] {
        let entities = [insert(layer, 5.0), groups.to_owned(), square(20.0, "8 RING")].concat();
        let read = read(&drawn(METRES, &LAYERS, &blocks, &entities));
        assert!(read.is_usable(), "{layer}: {:?}", read.findings);
        let lefts: Vec<f64> = lefts(&read).into_iter().filter(|x| *x < 20.0).collect();
        assert_eq!(lefts, expected, "{layer} {groups}");
        assert!(!of(&read, "D109").is_empty());
    }
}

#[test]
fn a_drawing_of_hidden_blocks_alone_says_so() {
    let read = read(&drawn(METRES, &LAYERS, "", &square(0.0, "8 OLD")));
    assert!(!read.is_usable() && of(&read, "D101").len() == 1 && of(&read, "D109").len() == 1);
}

/// Fit points of a spline.
fn fitted(points: &[[f64; 2]], flags: i16, groups: &str) -> String {
    let points: String = points.iter().map(|[x, y]| format!("11 {x} 21 {y} 31 0 ")).collect();
    format!("0 SPLINE 8 RING 70 {flags} 71 3 72 0 73 0 74 {} {groups} {points}", points.len())
}

#[test]
fn splines_by_fit_points_are_read_through_them() {
    let points = [[0.0, 0.0], [1.0, 0.8], [2.0, 1.0], [3.0, 0.8], [4.0, 0.0]];
    let chord = "0 LINE 8 RING 10 4 20 0 11 0 21 0 ";
    let read_spline = |groups: &str| read(&drawn(METRES, &LAYERS, "", &[&fitted(&points, 8, groups), chord].concat()));
    let plain = read_spline("");
    assert!(plain.is_usable(), "{:?}", plain.findings);
    let outline = &plain.drawing.outlines[0].points;
    assert!(points.iter().all(|p| outline.contains(p)), "{outline:?}");
    let told = of(&plain, "D110");
    assert!(
        told.len() == 1 && told[0].message.contains("spline by fit points") && told[0].message.contains("5 points")
    );
    // Upright tangents make it fuller.
    let full = read_spline("12 0 22 1 32 0 13 0 23 -1 33 0");
    assert!(area(&full.drawing.outlines[0].points) > area(outline) + 0.1);
}

#[test]
fn closed_fit_splines_are_closed_and_bad_splines_are_named() {
    let circle: Vec<[f64; 2]> =
        (0..12).map(|k| (std::f64::consts::TAU * f64::from(k) / 12.0).sin_cos()).map(|(s, c)| [c, s]).collect();
    let read_of = |entities: &str| read(&drawn(METRES, &LAYERS, "", entities));
    let closed = read_of(&fitted(&circle, 9, ""));
    assert!(closed.is_usable(), "{:?}", closed.findings);
    assert!((area(&closed.drawing.outlines[0].points) - std::f64::consts::PI).abs() < 1e-2);
    for (spline, word) in [
        (fitted(&[[0.0, 0.0]], 8, ""), "spline by fit points"),
        (fitted(&[[0.0, 0.0], [0.0, 0.0]], 8, ""), "spline by fit points"),
        ("0 SPLINE 8 RING 70 8 71 3 10 0 20 0 10 1 20 1 10 2 20 1 10 3 20 0 ".to_owned(), "0 knots where 8 belong"),
        ("0 SPLINE 8 RING 70 12 71 1 40 0 40 0 40 1 40 1 41 -1 41 1 10 0 20 0 10 1 20 1 ".to_owned(), "weights"),
    ] {
        let read = read_of(&spline);
        let found = of(&read, "D103");
        assert!(found.len() == 1 && found[0].message.contains(word), "{spline}: {:?}", read.findings);
    }
    // Control points count where they draw a curve.
    let both = "0 SPLINE 8 RING 70 8 71 1 40 0 40 0 40 1 40 2 40 2 10 0 20 0 10 1 20 1 10 2 20 0 11 0 21 0 11 2 21 0 ";
    let read = read_of(&format!("{both}0 LINE 8 RING 10 2 20 0 11 0 21 0 "));
    assert!(read.is_usable() && of(&read, "D110").is_empty(), "{:?}", read.findings);
    assert!((area(&read.drawing.outlines[0].points) - 1.0).abs() < 1e-9);
}

#[test]
fn a_header_that_contradicts_itself_is_told() {
    for (unit, other, word) in [
        (1, "9 $MEASUREMENT 70 1", "$MEASUREMENT metric"),
        (2, "9 $MEASUREMENT 70 1", "$MEASUREMENT metric"),
        (4, "9 $MEASUREMENT 70 0", "$MEASUREMENT English"),
        (6, "9 $LUNITS 70 4", "$LUNITS feet and inches"),
    ] {
        let bytes = drawn(&format!("9 $INSUNITS 70 {unit} {other}"), &LAYERS, "", &square(0.0, "8 RING"));
        let found = read(&bytes);
        let told = of(&found, "D111");
        assert!(
            found.is_usable() && told.len() == 1 && told[0].severity == Severity::Warning,
            "{unit} {other}: {:?}",
            found.findings
        );
        assert!(
            told[0].message.contains(word)
                && told[0].message.contains("is taken")
                && told[0].help.contains("--unit mm")
        );
        let said = drawing::read(&bytes, &Options { unit: Some(1.0), ..Options::default() });
        assert!(of(&said, "D111").is_empty(), "whoever states the unit has looked");
    }
    for header in [
        "9 $INSUNITS 70 1 9 $MEASUREMENT 70 0 9 $LUNITS 70 4",
        "9 $INSUNITS 70 4 9 $MEASUREMENT 70 1 9 $LUNITS 70 2",
        METRES,
    ] {
        assert!(of(&read(&drawn(header, &LAYERS, "", &square(0.0, "8 RING"))), "D111").is_empty(), "{header}");
    }
}
