//! What a bridge weighs, part by part, and what it hands to the ground at rest.

use super::engine::rigid;
use super::state::{self, Change};
use super::{AnalysisError, ground};
use bridge::{Bridge, Method, Strip};
use mechanics::ids::BlockId;
use mechanics::limit::{Ground, Section};
use outcome::note::{self, Note};
use outcome::statics::{Apart, Reaction, Seat, Statics, Weight};
use structure::discretise::{Discretised, Origin};

/// Weights and reactions of the strip between the walls, without its loads.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn statics(bridge: &Bridge) -> Result<Statics, AnalysisError> {
    let changes = [
        Change::FillAsWeight,
        Change::ParticlesAsWeight,
        Change::NoLoads,
        Change::Method(Method::Limit),
        Change::Strip(Strip::Fill),
    ];
    let own = state::with(bridge, &changes);
    let d = rigid::prepared(&own)?;
    let ground = Ground::new(&d.model, &d.loading, &rigid::settings(&own))?;
    Ok(Statics {
        width: bridge.width,
        weights: weights(&own, &d),
        apart: apart(bridge),
        reactions: reactions(&own, &d, &ground),
        assumptions: assumptions(),
    })
}

/// The blocks whose weights [`statics`] tells, with the loads of the file: fill and particles as weight, the strip between the walls. Fill does not
/// press on the rings.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn weighed(bridge: &Bridge) -> Result<Discretised, AnalysisError> {
    let changes =
        [Change::FillAsWeight, Change::ParticlesAsWeight, Change::Method(Method::Limit), Change::Strip(Strip::Fill)];
    rigid::prepared(&state::with(bridge, &changes))
}

/// The parts in which weights are told.
fn part(bridge: &Bridge, origin: Origin) -> String {
    match origin {
        Origin::Voussoir { span, .. } if bridge.spans.len() == 1 && span == 0 => "rings".to_owned(),
        Origin::Voussoir { span, .. } => format!("span {}, rings", span + 1),
        Origin::Pier { support, .. } => format!("pier {support}"),
        Origin::Backing { .. } => "backing".to_owned(),
        Origin::Abutment { support: 0 } | Origin::AbutmentCourse { support: 0, .. } => "left abutment".to_owned(),
        Origin::Abutment { .. } | Origin::AbutmentCourse { .. } => "right abutment".to_owned(),
        other => other.name(),
    }
}

/// Masonry by its parts, then what lies on each of them. What lies on the fixed blocks does not load the bridge.
fn weights(bridge: &Bridge, d: &Discretised) -> Vec<Weight> {
    let mut masonry: Vec<Weight> = Vec::new();
    let mut cover: Vec<Weight> = Vec::new();
    let add = |list: &mut Vec<Weight>, part: String, force: f64| match list.iter_mut().find(|one| one.part == part) {
        Some(one) => one.force += force,
        None => list.push(Weight { part, force }),
    };
    let fixed = |id: BlockId| d.model.blocks[id].held.is_fixed();
    for (id, block) in d.model.blocks.pairs().filter(|(id, _)| !fixed(*id)) {
        add(&mut masonry, format!("{}: masonry", part(bridge, d.origins[id])), -block.mass() * d.model.gravity.y);
    }
    for force in d.loading.permanent.iter().filter(|force| !fixed(force.block)) {
        add(&mut cover, format!("{}: cover above", part(bridge, d.origins[force.block])), -force.force.y);
    }
    masonry.extend(cover);
    masonry
}

/// What stands on the bridge, or may, and loads no strip of it.
fn apart(bridge: &Bridge) -> Vec<Apart> {
    let one = |part: &str, weight: Option<f64>, why: &str| Apart { part: part.to_owned(), weight, why: why.to_owned() };
    let along = bridge.spans.iter().map(|span| span.span).sum::<f64>()
        + bridge.piers.iter().map(|pier| pier.width).sum::<f64>();
    let weighs = |across: f64, density: f64| Some(across * along * density * bridge.gravity);
    let behind = bridge.parapet.map_or(0.0, |parapet| parapet.thickness);
    let mut list = vec![match &bridge.spandrel_wall {
        Some(_) => one(
            "spandrel walls",
            walls(bridge),
            "they stand on the edges of the barrel: the strip between them is analysed",
        ),
        None => one(
            "spandrel walls",
            None,
            "the file describes none: cover lies on the whole width of the barrel in their place",
        ),
    }];
    list.push(match bridge.parapet {
        Some(own) => one(
            "parapets, from end springing to end springing",
            weighs(2.0 * own.height * own.thickness, own.density.unwrap_or(bridge.masonry.density)),
            "they stand on the edges of the barrel",
        ),
        None => one("parapets", None, "the file describes none: write [parapet]"),
    });
    let top = bridge.cover.layers.last().map_or(0.0, |layer| layer.density);
    list.extend(bridge.kerb.map(|own| {
        let raised = (own.distance - behind).max(0.0) * own.upstand;
        one(
            "kerbs and what is raised behind them",
            weighs(2.0 * raised, own.density.unwrap_or(top)),
            "above the road of the model",
        )
    }));
    if ground::carries_trains(bridge) {
        let track = bridge.way().map(bridge::passage::Way::dead_load);
        let why = match track {
            Some(_) => "in the passage of the train, and not at collapse",
            None => "the file does not weigh them: a layer of ballast in [[cover]] may hold them in its density",
        };
        list.push(one("rails and sleepers", track.map(|pressure| pressure * bridge.width * along), why));
    }
    list
}

/// Weight of the spandrel walls [N]; none where they cannot be divided into bricks.
fn walls(bridge: &Bridge) -> Option<f64> {
    let thickness = bridge.spandrel_wall.as_ref()?.thickness;
    let changes = [
        Change::FillAsWeight,
        Change::ParticlesAsWeight,
        Change::NoLoads,
        Change::Method(Method::Limit),
        Change::Strip(Strip::Wall),
    ];
    let d = rigid::prepared(&state::with(bridge, &changes)).ok()?;
    let bricks = d.model.blocks.pairs().filter(|(id, _)| matches!(d.origins[*id], Origin::Brick { .. }));
    let per_metre: f64 = bricks.map(|(_, block)| -block.mass() * d.model.gravity.y).sum();
    (per_metre > 0.0).then_some(per_metre * thickness)
}

/// Springings of every span, all rings together, and feet of piers.
fn reactions(bridge: &Bridge, d: &Discretised, ground: &Ground) -> Vec<Reaction> {
    // Each with the number of its joints.
    let mut found: Vec<(Reaction, usize)> = Vec::new();
    for (joint, i) in ground.interfaces.iter().enumerate() {
        let (first, second) = (d.origins[i.first], d.origins[i.second]);
        let ((place, seat, side), flip) = match (seat(bridge, first, second), seat(bridge, second, first)) {
            (Some(found), _) => (found, false),
            (None, Some(found)) => (found, true),
            (None, None) => continue,
        };
        let Some(Section { compression, shear, eccentricity }) = ground.resting_section(joint) else { continue };
        let on_second = i.normal * compression + i.normal.left() * shear;
        // Force on what stands on the joint.
        let force = if flip { on_second * -1.0 } else { on_second };
        // Outwards from the span: at its left springing what carries it is pushed to the left.
        let outwards = if side == 0 { force.x } else { -force.x };
        let depth = match (i.points.first(), i.points.last()) {
            (Some(a), Some(b)) => (*b - *a).norm(),
            _ => 0.0,
        };
        let wanted = depth - 2.0 * eccentricity.abs();
        let spread = wide(bridge, [first, second]);
        let reaction = Reaction {
            place,
            seat,
            vertical: force.y,
            horizontal: outwards,
            eccentricity: Some(eccentricity),
            depth: Some(depth),
            pressure: (wanted > 0.0).then(|| compression / (wanted * spread)),
            spread,
        };
        match found.iter_mut().find(|(sum, _)| sum.place == reaction.place) {
            Some((sum, joints)) => {
                sum.vertical += reaction.vertical;
                sum.horizontal += reaction.horizontal;
                *joints += 1;
            }
            None => found.push((reaction, 1)),
        }
    }
    let told = found.into_iter().map(|(sum, joints)| match joints {
        1 => sum,
        _ => Reaction { eccentricity: None, depth: None, pressure: None, ..sum },
    });
    told.collect()
}

/// Where a joint is in which one block bears another that hands the bridge on to the ground, what it is, and at which side of its span: 0 for
/// the left one. None of other joints.
fn seat(bridge: &Bridge, carrier: Origin, carried: Origin) -> Option<(String, Seat, usize)> {
    Some(match (carrier, carried) {
        (Origin::Abutment { .. }, Origin::Voussoir { span, voussoir, .. }) => {
            (springing(bridge, span, voussoir), Seat::Springing, voussoir)
        }
        (
            Origin::Foundation { .. } | Origin::Pier { .. } | Origin::AbutmentCourse { .. },
            Origin::Voussoir { span, voussoir, .. },
        ) => (springing(bridge, span, voussoir), Seat::Carried, voussoir),
        (Origin::Foundation { support }, Origin::Pier { .. }) => (format!("foot of pier {support}"), Seat::Foot, 1),
        (Origin::AbutmentGround { support }, Origin::AbutmentCourse { .. }) => {
            (format!("foot of the {} abutment", if support == 0 { "left" } else { "right" }), Seat::Foot, support)
        }
        _ => return None,
    })
}

/// Width of a pier's bottom across the bridge over that of the barrel; of other joints one.
fn wide(bridge: &Bridge, joint: [Origin; 2]) -> f64 {
    let support = joint.iter().find_map(|origin| match origin {
        Origin::Foundation { support } => Some(*support),
        _ => None,
    });
    let Some(pier) = support.and_then(|support| bridge.piers.get(support.checked_sub(1)?)) else { return 1.0 };
    let bottom = pier.across.map(|[_, bottom]| bottom);
    let across = pier.footings.iter().rev().find_map(|step| step.across).or(bottom);
    across.map_or(1.0, |across| across / bridge.width)
}

fn springing(bridge: &Bridge, span: usize, voussoir: usize) -> String {
    let side = if voussoir == 0 { "left springing" } else { "right springing" };
    if bridge.spans.len() == 1 { side.to_owned() } else { format!("span {}, {side}", span + 1) }
}

fn assumptions() -> Vec<Note> {
    [note::Barrel::AtRest, note::Barrel::ElasticReactions].into_iter().map(Note::from).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    /// What the ground carries is what the bridge weighs, and nothing pushes it sideways.
    #[test]
    fn reactions_carry_the_weights() {
        let one = samples::bridgemill().spans[0].clone();
        let mut twin = samples::spans(vec![one.clone(), one], 2.5, 3.0, 4.0, 5);
        twin.cover.layers = vec![samples::fill(0.4, 1800.0)];
        for bridge in [samples::bridgemill(), samples::case_two(), twin] {
            let found = statics(&bridge).unwrap();
            let on_ground: Vec<&Reaction> = found.reactions.iter().filter(|one| one.seat != Seat::Carried).collect();
            let carried: f64 = on_ground.iter().map(|one| one.vertical).sum();
            assert!((carried / found.total() - 1.0).abs() < 1e-6, "{carried} {}", found.total());
            let sideways: f64 = on_ground
                .iter()
                .map(|one| if one.place.contains("left") { -one.horizontal } else { one.horizontal })
                .sum();
            assert!(sideways.abs() < 1e-6 * carried, "{sideways}");
            assert!(found.reactions.iter().all(|one| one.vertical > 0.0), "{found:?}");
            let springing = &found.reactions[0];
            assert!(springing.horizontal > 0.0, "an arch pushes outwards: {springing:?}");
        }
    }

    /// What stands at the edges weighs its volume, and loads no strip.
    #[test]
    fn edges_are_weighed_beside_the_loads() {
        let mut b = samples::bridgemill();
        let before = statics(&b).unwrap().total();
        b.parapet = Some(bridge::Parapet { height: 1.0, thickness: 0.25, density: Some(2000.0) });
        b.kerb = Some(bridge::Kerb { distance: 0.75, upstand: 0.1, density: Some(1000.0) });
        let found = statics(&b).unwrap();
        assert_eq!(found.total(), before);
        let weight = |part: &str| found.apart.iter().find(|one| one.part.starts_with(part)).unwrap().weight;
        let wanted = |area: f64, density: f64| 2.0 * area * b.spans[0].span * density * b.gravity;
        assert!((weight("parapets").unwrap() / wanted(0.25, 2000.0) - 1.0).abs() < 1e-12);
        assert!((weight("kerbs").unwrap() / wanted(0.5 * 0.1, 1000.0) - 1.0).abs() < 1e-12);
        assert_eq!(weight("spandrel walls"), None);
        b.spandrel_wall = Some(samples::spandrel_wall(&b));
        let walls = statics(&b).unwrap().apart[0].weight.unwrap();
        // Not more than the whole height from the springings to the road, as long as the walls are.
        let wall = b.spandrel_wall.as_ref().unwrap();
        let most =
            (b.spans[0].rise + 0.711 + 1.0) * (b.spans[0].span + 6.0) * wall.thickness * wall.density * b.gravity;
        assert!(walls > 0.1 * most && walls < most, "{walls} {most}");
    }

    /// Half a circle of one ring without cover: weight of a ring is pi (r + t/2) t per metre and unit weight.
    #[test]
    fn a_ring_weighs_what_its_area_weighs() {
        let mut b = samples::bridgemill();
        b.cover.layers.clear();
        b.spans[0].defects.clear();
        let found = statics(&b).unwrap();
        let (half, rise) = (0.5 * b.spans[0].span, b.spans[0].rise);
        let radius = (half * half + rise * rise) / (2.0 * rise);
        let angle = 2.0 * (half / radius).asin();
        let t = b.spans[0].rings[0].crown_thickness;
        let area = angle * (radius + 0.5 * t) * t;
        let wanted = area * b.masonry.density * b.gravity;
        // Voussoirs have straight faces: chords cut off a little of both circles alike.
        assert!((found.total() / wanted - 1.0).abs() < 1e-3, "{} {wanted}", found.total());
    }
}
