//! Reading answers whatever the bytes are, and soon.

use crate::bytes;
use drawing::Options;
use proptest::prelude::*;
use std::time::{Duration, Instant};

const DRAWINGS: [&str; 6] = ["curves.dxf", "repairs.dxf", "refused.dxf", "references.dxf", "r12.dxf", "left-out.dxf"];

fn options() -> Options {
    Options { unit: Some(1.0), ..Options::default() }
}

/// Reads under a bound on time: what takes longer than this hangs for a user too.
fn soon(bytes: &[u8]) -> drawing::Read {
    let start = Instant::now();
    let read = drawing::read(bytes, &options());
    assert!(start.elapsed() < Duration::from_secs(20), "{:?} for {} bytes", start.elapsed(), bytes.len());
    read
}

#[test]
fn a_file_cut_anywhere_is_noticed() {
    for name in DRAWINGS {
        let whole = bytes(name);
        // The end alone may lack its line break.
        let end = whole.len() - whole.iter().rev().take_while(|byte| byte.is_ascii_whitespace()).count();
        for cut in (0..end).step_by(97).chain(end - 40..end) {
            assert!(!soon(&whole[..cut]).is_usable(), "{name} cut at {cut}");
        }
    }
}

#[test]
fn nothing_and_what_is_no_drawing_is_refused() {
    let none: [&[u8]; 8] = [
        b"",
        b"\n\n\n",
        b"0\nEOF\n",
        b"[bridge]\nname = \"x\"\n",
        b"AutoCAD Binary DXF\r\n\x1a\0",
        b"AutoCAD DXB 1.0\r\n\x1a\0",
        b"AC1032\0\0\0\0",
        b"\xff\xfe0\0\n\0",
    ];
    for bytes in none {
        let read = soon(bytes);
        assert!(!read.is_usable(), "{bytes:?}");
        assert!(read.findings.iter().any(|f| f.code == "D101"), "{:?}", read.findings);
    }
}

fn drawn(blocks: &str, entities: &str) -> Vec<u8> {
    format!("0\nSECTION\n2\nBLOCKS\n{blocks}0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n")
        .into_bytes()
}

#[test]
fn hostile_counts_end_soon() {
    let block = |name: &str, inside: &str| format!("0\nBLOCK\n2\n{name}\n10\n0\n20\n0\n{inside}0\nENDBLK\n");
    let insert = |name: &str, more: &str| format!("0\nINSERT\n8\nL\n2\n{name}\n10\n0\n20\n0\n{more}");
    let square = "0\nLWPOLYLINE\n8\n0\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n";
    // A block inside itself, twice; arrays in arrays; an empty array.
    let own = drawn(&block("A", &format!("{0}{0}", insert("A", ""))), &insert("A", ""));
    let mut nested = block("B0", square);
    for k in 1..8 {
        nested += &block(&format!("B{k}"), &insert(&format!("B{}", k - 1), "70\n30000\n71\n30000\n44\n2\n45\n2\n"));
    }
    let arrays = drawn(&nested, &insert("B7", ""));
    let empty = drawn(&block("E", ""), &insert("E", "70\n32000\n71\n32000\n"));
    // Curves that would need endless chords, or have endless degrees.
    let huge =
        drawn("", "0\nCIRCLE\n8\nL\n10\n0\n20\n0\n40\n1e300\n0\nARC\n8\nL\n10\n0\n20\n0\n40\n1e5\n50\n0\n51\n1e300\n");
    let spline = drawn("", "0\nSPLINE\n8\nL\n70\n8\n71\n32000\n40\n0\n40\n1\n10\n0\n20\n0\n30\n0\n");
    let bulges =
        drawn("", "0\nLWPOLYLINE\n8\nL\n70\n1\n10\n0\n20\n0\n42\n1e300\n10\n1\n20\n0\n42\n-1e-300\n10\n1\n20\n1\n");
    for (name, bytes) in
        [("own", own), ("arrays", arrays), ("empty", empty), ("huge", huge), ("spline", spline), ("bulges", bulges)]
    {
        assert!(!soon(&bytes).is_usable(), "{name}");
    }
}

#[test]
fn crowds_end_soon() {
    let square = |layer: usize, x: f64| {
        format!("0\nLWPOLYLINE\n8\nL{layer}\n70\n1\n10\n{x}\n20\n0\n10\n{}\n20\n0\n10\n{x}\n20\n1\n", x + 1.0)
    };
    let many =
        |layers: usize, step: f64| -> String { (0..30_000).map(|k| square(k % layers, step * k as f64)).collect() };
    // All in one place, each on a layer of its own, and side by side: only the last is a drawing.
    assert!(!soon(&drawn("", &many(1, 1e-6))).is_usable());
    assert!(!soon(&drawn("", &many(30_000, 2.0))).is_usable());
    let read = soon(&drawn("", &many(7, 2.0)));
    assert!(read.is_usable() && read.drawing.outlines.len() == 30_000 && read.drawing.layers.len() == 7);
}

#[test]
fn an_entity_with_a_bad_number_is_named_with_its_line() {
    for bad in ["nan", "inf", "1e999", "one", ""] {
        let line = format!("0\nLINE\n5\n2A\n8\nRING\n10\n{bad}\n20\n0\n11\n1\n21\n0\n");
        let read = soon(&drawn("", &line));
        let found = read.findings.iter().find(|f| f.code == "D103").unwrap_or_else(|| panic!("{bad}: {read:?}"));
        assert!(found.message.contains("line 18") && found.place.entity == "LINE 2A" && found.place.layer == "RING");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_bytes_are_answered(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        soon(&bytes);
    }

    #[test]
    fn any_pairs_are_answered(
        pairs in prop::collection::vec((prop::sample::select(vec![0, 2, 5, 8, 10, 20, 30, 11, 21, 31, 38, 40, 41, 42, 44,
            45, 50, 51, 66, 67, 70, 71, 210, 230, 1000, 90, -5]), prop::sample::select(vec!["LINE", "ARC", "CIRCLE",
            "LWPOLYLINE", "POLYLINE", "VERTEX", "SEQEND", "INSERT", "BLOCK", "ENDBLK", "SPLINE", "ELLIPSE", "ENDSEC",
            "SECTION", "ENTITIES", "BLOCKS", "0", "1", "-1", "1e9", "2.5", "7", "16", "ATTRIB", "HATCH", "EOF"])), 0..120),
    ) {
        let text: String = pairs.iter().map(|(code, value)| format!("{code}\n{value}\n")).collect();
        soon(&drawn(&text, &text));
        soon(text.as_bytes());
    }

    #[test]
    fn drawings_with_changed_bytes_are_answered(
        which in 0..DRAWINGS.len(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..12),
    ) {
        let mut bytes = bytes(DRAWINGS[which]);
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        soon(&bytes);
    }

    #[test]
    fn drawings_with_lines_from_elsewhere_are_answered(
        which in 0..DRAWINGS.len(),
        moves in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..20),
    ) {
        let text = String::from_utf8_lossy(&bytes(DRAWINGS[which])).into_owned();
        let mut lines: Vec<&str> = text.lines().collect();
        for (from, to) in moves {
            let (from, to) = (from.index(lines.len()), to.index(lines.len()));
            lines[to] = lines[from];
        }
        soon(lines.join("\n").as_bytes());
    }
}
