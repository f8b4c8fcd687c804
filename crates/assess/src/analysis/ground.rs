//! A bridge in plan and in cross-section.

use bridge::Bridge;
use outcome::ground::{GroundPlan, SpanInPlan, VehicleAcross};
use outcome::vehicles::VehicleSweep;

/// The bridge from above, with the governing vehicle where vehicles were moved over it.
pub fn ground_plan(bridge: &Bridge, swept: Option<&VehicleSweep>) -> GroundPlan {
    let mut x = 0.0;
    let spans = bridge.spans.iter().enumerate().map(|(k, span)| {
        let from_to = [x, x + span.span];
        x = from_to[1] + bridge.piers.get(k).map_or(0.0, |pier| pier.width);
        SpanInPlan { from_to, skew: span.skew }
    });
    let spans = spans.collect();
    let governing = swept.and_then(|found| found.vehicles.get(found.governing?));
    GroundPlan {
        bridge: bridge.name.clone(),
        width: bridge.width,
        spans,
        cracks: bridge.carriageway.as_ref().map_or_else(Vec::new, |asked| asked.cracks.clone()),
        rings: bridge.spans[0].rings.iter().map(|ring| ring.crown_thickness).collect(),
        layers: bridge.cover.layers.iter().map(|layer| (layer.name.word().to_owned(), layer.thickness)).collect(),
        wall: bridge.spandrel_wall.as_ref().map(|wall| 0.5 * wall.thickness),
        vehicle: governing.map(|vehicle| VehicleAcross {
            code: vehicle.code.clone(),
            wheels: vehicle.across.wheels.clone(),
            strip: vehicle.across.strip,
            width: vehicle.effective_width,
            derivation: vehicle.across.derivation.clone(),
        }),
    }
}
