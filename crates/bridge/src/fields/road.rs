//! The road or rail surface by its levels, where it is not level.

use super::structure::PlacedSpan;
use crate::card::Section;
use crate::cards::*;
use crate::findings::Findings;
use crate::model::{Cover, Pier};
use crate::resolve::Layout;
use crate::road::Road;
use crate::tree::Table;

pub(super) static ROAD: Section = Section {
    path: "road",
    doc: "Levels of the surface on which vehicles run, where it is not level: a gradient, a hump, a sag. The lowest layer of [[cover]] fills \
          what is left below; the layers above it keep their thickness.",
    fields: &[
        points(
            "levels",
            "points of the surface from left to right: distance from the left springing of the first span, level in the survey's datum",
            "[[\"-5 m\", \"103.20 m\"], [\"9 m\", \"103.65 m\"], [\"24 m\", \"103.40 m\"]]",
        ),
        length(
            "springing_level",
            "level of the left springing of the first span, at the intrados, in the same datum",
            "99.80 m",
        )
        .default("0 m"),
    ],
};

/// Places of a span's extrados that are compared with the road.
const STATIONS: usize = 200;

/// A point of an extrados below the road.
struct Below {
    /// Along the bridge [m].
    x: f64,
    /// What lies over it, up to the road [m].
    depth: f64,
    /// Span, from 1.
    span: usize,
}

/// Lays the surface by its levels where the file has some: the cover's depth is then the least over a crown, and the lowest layer has what
/// the others leave of it.
pub(crate) fn lay(
    file: &Table<'_>,
    cover: Option<Cover>,
    spans: Option<&[PlacedSpan]>,
    piers: Option<&[Pier]>,
    findings: &mut Findings,
) -> Option<Cover> {
    if !file.has("road") {
        return cover;
    }
    let table = file.table("road", findings)?;
    let levels: Option<Vec<[f64; 2]>> = table.read("levels", findings);
    let springing: Option<f64> = table.read("springing_level", findings);
    let (levels, springing) = (levels?, springing?);
    if levels.len() < 2 || levels.windows(2).any(|pair| !(pair[0][0] < pair[1][0])) {
        return findings.refuse(
            "B226",
            table.place("levels"),
            "levels of a road are two points or more, from left to right",
            "each further right than the one before",
            "sort the points by their first coordinate, and remove doubles",
        );
    }
    let (mut cover, spans, piers) = (cover?, spans?, piers?);
    if cover.layers.is_empty() {
        return findings.refuse(
            "B226",
            table.place("levels"),
            "there is no cover between the rings and the road",
            "its lowest layer would fill what is left below the levels",
            "describe the fill with a [[cover]], without `thickness`",
        );
    }
    let road = Road { points: levels.iter().map(|[x, level]| [*x, level - springing]).collect() };
    let above: f64 = cover.layers.iter().skip(1).map(|layer| layer.thickness).sum();
    let (least, crown) = least_depths(&road, spans, piers);
    if !(least.depth >= above - 1e-9) {
        let message = format!(
            "the road lies {:.3} m {} the extrados of span {} at x = {:.2} m",
            least.depth.abs(),
            if least.depth < 0.0 { "below" } else { "above" },
            least.span,
            least.x
        );
        let needs = if above > 0.0 {
            format!("the layers above the fill need {above:.3} m")
        } else {
            "it would cut the ring".into()
        };
        let help =
            "check `springing_level`: the level of the left springing, at the intrados, in the datum of the levels";
        return findings.refuse("B226", table.place("levels"), message, needs, help);
    }
    cover.depth = crown;
    cover.layers[0].thickness = (crown - above).max(0.0);
    cover.road = Some(road);
    Some(cover)
}

/// The least depth below the road, and the least over a crown [m].
fn least_depths(road: &Road, spans: &[PlacedSpan], piers: &[Pier]) -> (Below, f64) {
    let (mut least, mut crown) = (Below { x: 0.0, depth: f64::INFINITY, span: 1 }, f64::INFINITY);
    let layout = Layout::new(spans, piers);
    for (index, (placed, ((left, _), level))) in spans.iter().zip(layout.spans.iter().zip(&layout.levels)).enumerate() {
        let span = &placed.span;
        let Ok(intrados) = span.intrados() else { continue };
        let [at_crown, at_springing] = [
            span.rings.iter().map(|ring| ring.crown_thickness).sum::<f64>(),
            span.rings.iter().map(|ring| ring.springing_thickness).sum(),
        ];
        let mut highest = [0.0, f64::NEG_INFINITY];
        for step in 0..=STATIONS {
            let share = step as f64 / STATIONS as f64;
            let to_crown = 1.0 - (2.0 * share - 1.0).abs();
            let [x, y] = intrados.at(share).offset(at_springing + (at_crown - at_springing) * to_crown);
            let y = y + level;
            let depth = road.level(left + x) - y;
            if y > highest[1] {
                highest = [left + x, y];
            }
            if depth < least.depth {
                least = Below { x: left + x, depth, span: index + 1 };
            }
        }
        crown = crown.min(road.level(highest[0]) - highest[1]);
    }
    (least, crown)
}
