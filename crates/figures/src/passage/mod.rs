//! Figures of a train's passage: records, influence lines, the bridge at chosen moments, and ParaView files.

mod field;
mod records;
mod ring;
mod scene;
mod vtu;

pub use records::records as passage_records;
pub use ring::ring as passage_ring;
pub use vtu::files as passage_paraview;

use outcome::passage::Passage;

/// Most moments that are drawn; ParaView files have all.
const MOST_DRAWN: usize = 8;

/// All drawings that the passage has material for: name without extension, and SVG.
pub fn passage_drawings(passage: &Passage) -> Vec<(String, String)> {
    let mut drawings: Vec<(String, String)> = Vec::new();
    let mut put = |name: String, svg: Option<String>| drawings.extend(svg.map(|svg| (name, svg)));
    put("records".into(), records::records(passage));
    put("influence-lines".into(), records::influence_lines(passage));
    for k in 0..passage.moments.len().min(MOST_DRAWN) {
        put(format!("moment-{k}-displacement"), field::displacement(passage, k));
        put(format!("moment-{k}-stress"), field::stress(passage, k));
        put(format!("moment-{k}-ring"), ring::ring(passage, k));
    }
    drawings
}
