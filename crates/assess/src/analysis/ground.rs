//! A bridge in plan and in cross-section.

use super::vehicles::across::lanes;
use crate::vehicles::chosen;
use bridge::defect::{Defect, DefectKind, Face};
use bridge::passage::Way;
use bridge::{Bridge, Cutwater, Pier, Span};
use outcome::ground::{CrownDefect, Edges, GroundPlan, PierInPlan, SpanInPlan, VehicleAcross};
use outcome::note::words_of_defect;
use outcome::vehicles::VehicleSweep;
use rules::Ways;

/// The bridge from above, with the governing vehicle where vehicles were moved over it.
pub fn ground_plan(bridge: &Bridge, swept: Option<&VehicleSweep>) -> GroundPlan {
    let mut x = 0.0;
    let spans = bridge.spans.iter().enumerate().map(|(k, span)| {
        let from_to = [x, x + span.span];
        x = from_to[1] + bridge.piers.get(k).map_or(0.0, |pier| pier.width);
        SpanInPlan { from_to, skew: span.skew }
    });
    let spans: Vec<SpanInPlan> = spans.collect();
    let piers = bridge.piers.iter().zip(spans.windows(2)).map(|(pier, beside)| PierInPlan {
        outline: outline(pier, beside[0].from_to[1], bridge.width),
        skew: 0.5 * (beside[0].skew + beside[1].skew),
        cutwaters: pier.cutwaters.map_or(0, |cutwaters| cutwaters.ends),
    });
    let piers = piers.collect();
    let governing = swept.and_then(|found| found.vehicles.get(found.governing?));
    GroundPlan {
        bridge: bridge.name.clone(),
        width: bridge.width,
        skew_given: bridge.carriageway.as_ref().is_some_and(|asked| asked.skew.is_some())
            || bridge.spans.iter().any(|span| span.skew != 0.0),
        spans,
        piers,
        cracks: bridge.carriageway.as_ref().map_or_else(Vec::new, |asked| asked.cracks.clone()),
        rings: bridge.spans[0].rings.iter().map(|ring| ring.crown_thickness).collect(),
        layers: bridge.cover.layers.iter().map(|layer| (layer.name.word().to_owned(), layer.thickness)).collect(),
        wall: bridge.spandrel_wall.as_ref().map(|wall| 0.5 * wall.thickness),
        edges: edges(bridge),
        defects: at_crown(&bridge.spans[0]),
        vehicle: governing.map(|vehicle| VehicleAcross {
            code: vehicle.code.clone(),
            wheels: vehicle.across.wheels.clone(),
            strip: vehicle.across.strip,
            width: vehicle.effective_width,
            derivation: vehicle.across.derivation.clone(),
        }),
    }
}

/// What stands at the edges of the road and on it; tracks where trains cross or vehicles of railways are moved.
pub(super) fn edges(bridge: &Bridge) -> Edges {
    let asked = bridge.carriageway.clone().unwrap_or_default();
    let gauge = asked.sideways.gauge;
    let tracks = if carries_trains(bridge) {
        let (count, apart) = lanes(bridge, Ways::Rail);
        let first = match asked.edge_distance {
            Some(edge) => edge + 0.5 * gauge,
            None => 0.5 * bridge.width - 0.5 * apart * (count - 1) as f64,
        };
        (0..count).map(|k| first + apart * k as f64).collect()
    } else {
        Vec::new()
    };
    Edges {
        parapet: bridge.parapet.map(|parapet| [parapet.height, parapet.thickness]),
        kerb: bridge.kerb.map(|kerb| [kerb.distance, kerb.upstand]),
        tracks,
        gauge,
    }
}

/// Whether trains run on the bridge.
pub(super) fn carries_trains(bridge: &Bridge) -> bool {
    let moved = bridge.sweep.as_ref().and_then(|plan| chosen(bridge, plan).ok());
    let crossed = bridge.way().is_some_and(|way| matches!(way, Way::Rails(_)));
    crossed || moved.is_some_and(|(_, vehicles)| vehicles.iter().any(|one| one.ways == Ways::Rail))
}

/// Defects that reach the crown of a span, and how high above its intrados.
fn at_crown(span: &Span) -> Vec<CrownDefect> {
    let rings: Vec<f64> = span.rings.iter().map(|ring| ring.crown_thickness).collect();
    let whole: f64 = rings.iter().sum();
    let middle = 0.5 * span.span;
    // A joint of its own place is at the crown where no voussoir lies between.
    let near =
        |one: &&Defect| one.from_to[0] <= middle + 0.02 * span.span && one.from_to[1] >= middle - 0.02 * span.span;
    let face = |face: Face, depth: f64| match face {
        Face::Extrados => [whole - depth, whole],
        _ => [0.0, depth],
    };
    let heights = |one: &Defect| match one.kind {
        DefectKind::LostMortar { face: of, depth }
        | DefectKind::ThinRing { face: of, depth }
        | DefectKind::OpenJoint { face: of, depth } => face(of, depth),
        DefectKind::RingSeparation { ring, .. } => [rings.iter().take(ring + 1).sum(); 2],
        DefectKind::MissingStones => [0.0, rings.first().copied().unwrap_or(0.0)],
        DefectKind::WeakMasonry { .. } | DefectKind::DroppedStones { .. } => [0.0, whole],
    };
    let defect = |one: &Defect| CrownDefect { what: words_of_defect(one), heights: heights(one) };
    span.defects.iter().filter(near).map(defect).collect()
}

/// Sides of a round cutwater.
const SIDES: usize = 16;

/// A pier at its top, from its left edge [m] on; the first cutwater is drawn beyond the upper edge.
fn outline(pier: &Pier, left: f64, barrel: f64) -> Vec<[f64; 2]> {
    let half = 0.5 * pier.cutwaters.map_or(barrel, |cutwaters| cutwaters.between);
    let (middle, reach) = (left + 0.5 * pier.width, 0.5 * pier.width);
    let mut outline = Vec::new();
    for (end, side) in [1.0, -1.0].into_iter().enumerate() {
        // Round the pier against the clock: the upper edge from right to left, the lower one from left to right.
        let at = |along: f64, beyond: f64| [middle + side * along * reach, side * (half + beyond)];
        outline.push(at(1.0, 0.0));
        if let Some(cutwaters) = pier.cutwaters.filter(|cutwaters| end < cutwaters.ends) {
            let length = cutwaters.length;
            match cutwaters.shape {
                Cutwater::Pointed => outline.push(at(0.0, length)),
                Cutwater::Round => outline.extend((1..SIDES).map(|k| {
                    let (sine, cosine) = (std::f64::consts::PI * k as f64 / SIDES as f64).sin_cos();
                    at(cosine, length * sine)
                })),
                Cutwater::Square => outline.extend([at(1.0, length), at(-1.0, length)]),
            }
        }
        outline.push(at(-1.0, 0.0));
    }
    outline
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;
    use bridge::Cutwaters;

    fn area(outline: &[[f64; 2]]) -> f64 {
        let next = outline.iter().cycle().skip(1);
        outline.iter().zip(next).map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1])).sum()
    }

    /// The area from above is what the model weighs the pier by: its mean width across times its width along the road.
    #[test]
    fn cutwaters_are_drawn_with_the_area_that_they_weigh_by() {
        let one = samples::bridgemill().spans[0].clone();
        for (shape, ends) in
            [(Cutwater::Pointed, 2), (Cutwater::Round, 1), (Cutwater::Square, 2), (Cutwater::Pointed, 1)]
        {
            let mut b = samples::spans(vec![one.clone(), one.clone()], 2.5, 3.0, 4.0, 5);
            let cutwaters = Cutwaters { shape, length: 1.2, ends, between: 9.0 };
            b.piers[0].cutwaters = Some(cutwaters);
            let plan = ground_plan(&b, None);
            let wanted = 2.5 * (9.0 + cutwaters.mean());
            // A half ellipse of 16 sides lacks 0.6 % of its area.
            let drawn = area(&plan.piers[0].outline);
            assert!((drawn / wanted - 1.0).abs() < 1e-3, "{shape:?}: {drawn} {wanted}");
            assert_eq!(plan.piers[0].cutwaters, ends);
            let left = plan.piers[0].outline.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
            assert!((left - plan.spans[0].from_to[1]).abs() < 1e-12);
        }
    }
}
