//! What a reader of a result must know: warnings with numbers, and what was assumed.

use bridge::{BackingBody, Bridge, ContactPoints, DispersalRule, JointContact, Plan, Strip};
use mechanics::limit;
use outcome::collapse::By;
use outcome::collapse::FlowRule;
use outcome::collapse::{Collapse, Sought, Status};
use outcome::note::{self, Bond, FiniteStones, Note};
use outcome::warning::{self, Warning};
use structure::discretise::{Discretised, Origin, pressure};

mod continuum;
pub(super) mod joints;
mod shape;

pub(super) use continuum::continuum;

/// Discrete elements usually lie up to this share below the limit load of the same blocks.
const USUAL_GAP: f64 = 0.15;
/// Both bounds of limit analysis must agree to this.
const BOUNDS: f64 = 1e-6;

/// Notes on a limit analysis.
pub(super) fn limit(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    common(bridge, d, c);
    let Some(report) = c.limit() else { return };
    let (mut warnings, mut assumptions) = (Vec::new(), Vec::new());
    assumptions.push(match c.sought {
        Sought::SupportMovement(_) => note::Blocks::RigidAsMoved,
        _ => note::Blocks::Rigid,
    });
    match (report.friction, report.associated_load) {
        (FlowRule::Associated, _) if !c.picture.sliding.is_empty() => {
            warnings.push(warning::Joints::Sliding { joints: c.picture.sliding.len() }.into());
        }
        (FlowRule::NonAssociated, _) if report.jammed => warnings.push(warning::Joints::Jammed.into()),
        (FlowRule::NonAssociated, associated_load) if c.status == Status::NotConverged => {
            warnings.push(warning::Joints::NotSettled { joints: c.picture.sliding.len(), associated_load }.into());
        }
        (FlowRule::Associated, _) => assumptions.push(note::Blocks::FrictionAssociated),
        (FlowRule::NonAssociated, associated_load) => {
            assumptions.push(note::Blocks::FrictionNonAssociated { associated_load });
        }
    }
    if let Some([least, most]) = report.spread.filter(|_| report.comes_and_goes && c.status == Status::Collapsed) {
        warnings.push(warning::Joints::ComesAndGoes { least, most }.into());
    }
    warnings.extend(
        joints::bond(bridge)
            .map(|(cohesion, tension, strength)| warning::Joints::Bond { cohesion, tension, strength }.into()),
    );
    if let (Status::NotConverged, FlowRule::NonAssociated, Some(carried)) =
        (c.status, report.friction, report.lower_bound)
    {
        warnings.push(warning::Joints::WithoutFriction { carried }.into());
    }
    if bridge.plan.contact_points == ContactPoints::Rounded && bridge.masonry.rounding > 0.0 {
        warnings.push(inset(bridge));
    }
    if let (Some(lower), Some(upper), FlowRule::Associated) = (report.lower_bound, report.upper_bound, report.friction)
        && (upper - lower).abs() > BOUNDS * upper.abs()
    {
        warnings.push(warning::Loads::BoundsApart { lower, upper }.into());
    }
    c.warnings.extend(warnings);
    c.assumptions.extend(assumptions.into_iter().map(Note::from));
}

/// The range of loads with fill that presses: by weight alone, as described, and with all that could be there.
pub(super) fn pressure_range(bridge: &Bridge, bare: &Collapse, with: &Collapse) -> Option<Warning> {
    let fill = bridge.fill_pressure?;
    let told = match &with.by {
        By::Limit(report) => warning::Cover::Pressure {
            bare: bare.collapse_load,
            with: with.collapse_load,
            share: fill.mobilisation,
            full: report.full_fill_pressure_load,
        },
        By::Path(_) => warning::Cover::PressureOfPath {
            bare: bare.last_stable_load,
            with: with.last_stable_load,
            rigid: with.limit_load,
        },
        _ => return None,
    };
    Some(told.into())
}

/// Notes on fill that presses against movement.
pub(super) fn pressed(bridge: &Bridge, c: &mut Collapse) {
    let Some(fill) = &bridge.fill_pressure else { return };
    let k = pressure::coefficients(fill);
    let mut told = vec![note::Fill::Presses {
        least: k.least,
        most: k.most,
        cohesion: k.cohesion,
        mobilised: fill.mobilisation,
        friction_angle: fill.friction_angle,
        cohesion_mobilised: fill.cohesion_mobilisation,
    }];
    if bridge.spans.len() > 1 {
        told.push(note::Fill::PressesBetweenSpans);
    }
    if bridge.cover.backing.is_some_and(|b| b.body == BackingBody::Weight) {
        told.push(note::Fill::BackingPresses);
    }
    c.assumptions.extend(told.into_iter().map(Note::from));
}

/// Notes on fill that presses the more the further backs move against it.
fn moved_against(bridge: &Bridge, c: &mut Collapse) {
    let (Some(fill), Some(found)) = (&bridge.fill_pressure, c.along().and_then(|path| path.fill_pressure)) else {
        return;
    };
    let k = pressure::coefficients(fill);
    let told = note::Fill::PressesWithMovement {
        least: k.least,
        most: k.most,
        cohesion: k.cohesion,
        half_movement: fill.half_movement,
        mobilised: found.mobilised,
    };
    c.assumptions.push(told.into());
}

/// What is assumed of backing that is blocks, and of the ground behind it.
fn backed(bridge: &Bridge, d: &Discretised) -> Option<Note> {
    bridge.cover.backing.filter(|b| b.body == BackingBody::Blocks)?;
    let pieces = d.origins.iter().filter(|o| matches!(o, Origin::Backing { .. })).count();
    let over_abutments = bridge.abutments.map(|a| a.top_width);
    Some(note::Fill::BackingBlocks { pieces, over_abutments, pressed: !d.loading.restraints.is_empty() }.into())
}

/// Notes on a discrete element run.
pub(super) fn dem(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    common(bridge, d, c);
    if bridge.fill_pressure.is_some_and(|fill| fill.applies) && d.fill.is_none() {
        c.assumptions.push(note::Fill::DoesNotPress.into());
    }
    discrete_elements(&bridge.plan, c);
    if bridge.masonry.rounding > 0.0 {
        c.warnings.push(inset(bridge));
    }
    if c.status == Status::Stalled {
        c.warnings.push(warning::Loads::Stalled { step: c.stalled_load }.into());
    }
    if c.status == Status::Collapsed && bridge.dispersal.rule == DispersalRule::InverseDepth && d.road.is_none() {
        c.warnings.push(warning::Loads::PublishedStep.into());
    }
    if let Some((block, iteration)) = c.dem().and_then(|r| r.broken_at.clone()) {
        c.warnings.push(warning::Loads::Broken { block, iteration }.into());
    }
    c.warnings.extend(above_strength(bridge, c));
    if let (Some(stable), Some(limit)) = (c.last_stable_load, c.limit_load) {
        let next = c.collapse_load.unwrap_or(stable) / limit;
        if stable / limit > 1.0 {
            c.warnings.push(warning::Loads::AboveLimit { stable, limit }.into());
        } else if c.collapse_load.is_some() && next < 1.0 - USUAL_GAP {
            c.warnings.push(warning::Loads::FarBelowLimit { stable, limit }.into());
        }
    }
}

/// Stress above the strength of the masonry.
fn above_strength(bridge: &Bridge, c: &Collapse) -> Option<Warning> {
    let (stress, strength) = (c.max_compressive_stress?, bridge.masonry.compressive_strength?);
    (stress > strength).then(|| warning::Joints::AboveStrength { stress, strength }.into())
}

/// Notes on a run by finite elements of these stones.
pub(super) fn finite(
    bridge: &Bridge,
    d: &Discretised,
    stones: FiniteStones,
    sliding: Option<warning::Joints>,
    c: &mut Collapse,
) {
    common(bridge, d, c);
    let in_a_joint = c.finite().map_or(0, |finite| finite.springs_per_joint);
    let own_strips = bridge.plan.contact == Some(JointContact::Distributed);
    c.assumptions.push(note::Blocks::Springs { in_a_joint, own_strips, stones }.into());
    c.assumptions.push(note::Blocks::LoadsTried.into());
    if bridge.joint.tensile_strength > 0.0 {
        c.assumptions.push(note::Blocks::TensionLeftOut.into());
    }
    c.warnings.extend(sliding.map(Warning::from));
    if let (Some(stable), Some(limit)) = (c.last_stable_load, c.limit_load)
        && stable > limit
    {
        c.warnings.push(warning::Loads::ElementsAboveLimit { stable, limit }.into());
    }
    c.warnings.extend(
        joints::bond(bridge)
            .map(|(cohesion, tension, strength)| warning::Joints::BondBeside { cohesion, tension, strength }.into()),
    );
    c.warnings.extend(above_strength(bridge, c));
}

/// Notes on the equilibrium path.
pub(super) fn path(bridge: &Bridge, d: &Discretised, distributed: bool, c: &mut Collapse) {
    common(bridge, d, c);
    moved_against(bridge, c);
    let tension = strongest(bridge) > 0.0;
    let bond = if distributed { Bond::Distributed { tension } } else { Bond::AtPoints };
    c.assumptions.push(note::Blocks::DeformableJoints { bond }.into());
    c.assumptions.push(note::Blocks::ContactsAsBuilt.into());
    if tension && !distributed {
        c.assumptions.push(note::Blocks::TensionLeftOut.into());
    }
    if bridge.masonry.compressive_strength.is_some() && distributed {
        c.assumptions.push(note::Blocks::CrushingKept.into());
    }
    if bridge.masonry.rounding > 0.0 {
        c.warnings.push(inset(bridge));
    }
}

/// Largest tensile strength of a kind of joint that the file has [Pa].
fn strongest(bridge: &Bridge) -> f64 {
    let rings = bridge.spans.iter().any(|span| span.rings.len() > 1).then_some(&bridge.ring_joint);
    let walls = bridge.spandrel_wall.as_ref().map(|wall| &wall.joint);
    let joints = [Some(&bridge.joint), rings, walls];
    joints.into_iter().flatten().map(|joint| joint.tensile_strength).fold(0.0, f64::max)
}

/// Notes on fill that is particles.
pub(super) fn filled(bridge: &Bridge, c: &mut Collapse) {
    c.assumptions.push(note::Fill::Particles.into());
    if let Some(p) = &c.packing {
        let (solid_fraction, coordination, mean_stress) = (p.solid_fraction, p.coordination, p.mean_stress);
        let told = note::Fill::Packing { seed: p.seed, solid_fraction, coordination, mean_stress };
        c.assumptions.push(told.into());
        c.warnings.extend(wedged(p.diameters[1], bridge.cover.depth).map(Warning::from));
    }
}

/// What is to be said where the largest particle [m] is larger than the cover is deep at its shallowest [m].
fn wedged(largest: f64, cover: f64) -> Option<warning::Cover> {
    (largest > cover).then_some(warning::Cover::CoarseParticles { largest, cover })
}

/// What a run of discrete elements assumes, and what two contact points a joint mean for its loads where joints have them.
pub(super) fn discrete_elements(plan: &Plan, c: &mut Collapse) {
    let distributed = plan.contact == Some(JointContact::Distributed);
    c.assumptions.push(note::Blocks::DiscreteElements { distributed }.into());
    c.assumptions.push(note::Blocks::LoadSteps.into());
    if !distributed {
        c.warnings.push(warning::Joints::TwoPoints.into());
    }
}

/// Says so where discrete elements carry loads on blocks that do not stand as rigid ones.
pub(super) fn apart(rigid: limit::Status, c: &mut Collapse) {
    if rigid == limit::Status::NoEquilibrium && c.last_stable_load.is_some() {
        c.warnings.push(warning::Loads::MethodsApart.into());
        c.limit_load = Some(0.0);
    }
}

/// Says that contact points leave crushing out of collapse, and what limit analysis with crushing joints carries.
pub(super) fn crushed(c: &mut Collapse) {
    let told = warning::Joints::CrushingLeftOut { crushing_limit: c.crushing_limit_load, limit: c.limit_load };
    c.warnings.push(told.into());
    if let (Some(stable), Some(limit)) = (c.last_stable_load, c.crushing_limit_load)
        && stable > limit
    {
        c.warnings.push(warning::Loads::AboveCrushing { stable, limit }.into());
    }
}

/// Says what crushing takes off rings under particles: a share of their limit load under the same fill as weight.
pub(super) fn crushed_under_particles(bridge: &Bridge, share: Option<f64>, c: &mut Collapse) {
    if bridge.masonry.compressive_strength.is_some() {
        c.warnings.push(warning::Joints::CrushingUnderParticles { share }.into());
    }
}

/// Puts the non-associated load of a wall beside the associated one [N/m].
pub(super) fn corrected(c: &mut Collapse, load: Option<f64>) {
    if let By::Limit(report) = &mut c.by {
        report.non_associated_load = load;
    }
    c.warnings.push(warning::Joints::Walls { load }.into());
}

/// What stands on the rings of a wall's strip, and how it is loaded.
fn walled(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    let (Some(wall), Some(road)) = (&bridge.spandrel_wall, &d.road) else { return };
    let pieces = d.origins.iter().filter(|o| matches!(o, Origin::Brick { .. })).count();
    if pieces == 0 {
        return;
    }
    let told = note::Barrel::WallStrip {
        pieces,
        brick: [wall.brick_length, wall.brick_height],
        ends: [road.line[0].x, road.line[1].x],
        height: d.surface.highest() - d.extrados.crown(),
        end_walls: wall.end_walls,
    };
    c.assumptions.push(told.into());
    c.assumptions.push(match d.counted_weight > 0.0 {
        true => note::Barrel::WallLoadedByBlock.into(),
        false => note::Barrel::WallLoadedOnBricks { bricks: wall.loaded_bricks }.into(),
    });
}

fn inset(bridge: &Bridge) -> Warning {
    let thickness: f64 = bridge.spans[0].rings.iter().map(|r| r.crown_thickness).sum();
    warning::Joints::Inset { rounding: bridge.masonry.rounding, thickness }.into()
}

/// Notes that do not depend on the method.
pub(super) fn common(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    super::caveats::add(bridge, d, c);
    c.assumptions.extend(super::defects::told(bridge));
    let soil = c.limit().is_some_and(|l| l.continuum.is_some());
    for s in d.spreads.iter().filter(|_| !soil) {
        // A millimetre is what a survey resolves.
        if s.shift.abs() > 1e-3 && s.to_ground.abs() < 1e-9 * s.strip.force.abs() {
            c.warnings.push(warning::Cover::Shifted { place: s.strip.middle, by: s.shift }.into());
        }
        if s.to_ground > 1e-9 * s.strip.force {
            let share = s.to_ground / s.strip.force;
            c.warnings.push(warning::Cover::ToGround { place: s.strip.middle, share }.into());
        }
    }
    if bridge.masonry.compressive_strength.is_none() {
        c.warnings.push(warning::Joints::Unlimited.into());
    }
    c.warnings.extend(joints::between_rings(bridge).into_iter().map(Warning::from));
    let unlimited = c.limit().and_then(|l| l.unlimited_strength_load);
    if let (Some(load), Some(without), Some(strength)) =
        (c.collapse_load, unlimited, bridge.masonry.compressive_strength)
    {
        c.assumptions.push(note::Blocks::Crushing { strength, load, without }.into());
    }
    c.assumptions.push(note::Barrel::Plane.into());
    c.warnings.extend(shape::warnings(bridge, d.road.is_none()).into_iter().map(Warning::from));
    c.assumptions.extend(shape::assumptions(bridge).into_iter().map(Note::from));
    if d.road.is_some() {
        walled(bridge, d, c);
        return;
    }
    c.assumptions.extend(backed(bridge, d).filter(|_| d.fill.is_none()));
    let weighs = bridge.cover.layers.iter().any(|l| l.weighs) || bridge.cover.backing.is_some();
    if weighs && d.loading.restraints.is_empty() && !soil && d.fill.is_none() {
        let backing = bridge.cover.backing.is_none_or(|b| b.body != BackingBody::Blocks);
        c.warnings.push(warning::Cover::AsWeight { backing, record: crate::record::record() }.into());
    }
    if !soil {
        c.assumptions.extend(continuum::as_weight(bridge));
        c.assumptions.extend(particles_as_weight(bridge).filter(|_| d.fill.is_none()));
    }
    if bridge.cover.road.is_some() {
        c.assumptions.push(note::Fill::Road { cover: bridge.cover.depth }.into());
    }
    let weightless = bridge.cover.layers.iter().filter(|l| !l.weighs);
    let layers: Vec<String> = weightless.map(|l| l.name.word().to_owned()).collect();
    if !layers.is_empty() {
        c.assumptions.push(note::Fill::Weightless { layers }.into());
    }
    if soil {
        return;
    }
    c.assumptions.push(note::Fill::Dispersal { rule: bridge.dispersal.rule, slope: bridge.dispersal.slope }.into());
}

/// What a method says that knows no particles.
pub(super) fn particles_as_weight(bridge: &Bridge) -> Option<Note> {
    let bodies = bridge.plan.strip == Strip::Fill && bridge.cover.layers.iter().any(|layer| layer.particles);
    bodies.then(|| note::Fill::ParticlesAsWeight.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_particle_larger_than_the_cover_is_deep_is_told() {
        assert_eq!(wedged(0.40, 0.478), None);
        assert_eq!(wedged(0.5, 0.478), Some(warning::Cover::CoarseParticles { largest: 0.5, cover: 0.478 }));
    }
}
