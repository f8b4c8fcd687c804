//! What questions and engines change of a bridge: changes of one kind each, applied in one place. The bridge that a file describes stays as it is.

use super::default_stiffness;
use bridge::defect::{DefectKind, Face};
use bridge::{Analysis, BackingBody, Bridge, Joint, JointStiffness, Method, Ring, Span, Strip};
use outcome::help::Help;

/// One change of a bridge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// By this method.
    Method(Method),
    /// This is asked.
    Analysis(Analysis),
    /// This strip of its width.
    Strip(Strip),
    /// Load steps and the largest load are left open: the file's are of its own loads at their place.
    OpenSteps,
    /// Without its loads.
    NoLoads,
    /// Loads reach the rings through the cover in place of standing on loading blocks.
    LoadsThroughCover,
    /// Layers of particles, and slabs on them, as weight.
    ParticlesAsWeight,
    /// Fill that presses, or yields as a continuum, as weight alone.
    FillAsWeight,
    /// With all of the fill's passive pressure mobilised.
    FullPressure,
    /// With a stiffness for joints whose file gives none, where their units have a modulus.
    DefaultStiffness,
    /// Without something that may come and go.
    Without(Help),
    /// With rings so many times as thick, on the same intrados.
    Thickened(f64),
    /// With the rings of each span bonded into one.
    BondedRings,
}

/// A bridge with changes, one after the other.
#[must_use]
pub fn with(bridge: &Bridge, changes: &[Change]) -> Bridge {
    let mut own = bridge.clone();
    changes.iter().for_each(|change| apply(*change, &mut own));
    own
}

/// The bridge with its fill as weight alone, where it presses or yields as a continuum.
#[must_use]
pub fn by_weight_alone(bridge: &Bridge) -> Option<Bridge> {
    let own = with(bridge, &[Change::FillAsWeight]);
    (own != *bridge).then_some(own)
}

fn apply(change: Change, bridge: &mut Bridge) {
    match change {
        Change::Method(method) => bridge.plan.method = method,
        Change::Analysis(analysis) => bridge.plan.analysis = analysis,
        Change::Strip(strip) => bridge.plan.strip = strip,
        Change::OpenSteps => (bridge.plan.load_step, bridge.plan.load_limit) = (None, None),
        Change::NoLoads => bridge.loads.clear(),
        Change::LoadsThroughCover => bridge.loads.iter_mut().for_each(|load| load.block = None),
        Change::ParticlesAsWeight => {
            bridge.particles = None;
            bridge.cover.layers.iter_mut().for_each(|layer| layer.particles = false);
        }
        Change::FillAsWeight => fill_as_weight(bridge),
        Change::FullPressure => {
            bridge
                .fill_pressure
                .iter_mut()
                .for_each(|fill| (fill.mobilisation, fill.cohesion_mobilisation) = (1.0, 1.0));
        }
        Change::DefaultStiffness => stiffen(bridge),
        Change::Without(help) => lose(help, bridge),
        Change::Thickened(factor) => {
            for ring in bridge.spans.iter_mut().flat_map(|span| &mut span.rings) {
                ring.crown_thickness *= factor;
                ring.springing_thickness *= factor;
            }
        }
        Change::BondedRings => bridge.spans.iter_mut().for_each(bond),
    }
}

/// Rings as one, of the stones of the lowest. What is said of one of them holds for all, stones that have fallen out leave the rest, and none has come
/// off another.
fn bond(span: &mut Span) {
    let Some(lowest) = span.rings.first() else { return };
    let sum = |of: fn(&Ring) -> f64| span.rings.iter().map(of).sum();
    let (crown_thickness, springing_thickness) =
        (sum(|ring| ring.crown_thickness), sum(|ring| ring.springing_thickness));
    let depth = lowest.crown_thickness.max(lowest.springing_thickness);
    let ring = Ring { crown_thickness, springing_thickness, ..lowest.clone() };
    span.defects.retain(|defect| !matches!(defect.kind, DefectKind::RingSeparation { .. }));
    for defect in &mut span.defects {
        match &mut defect.kind {
            DefectKind::WeakMasonry { ring, .. } => *ring = None,
            kind @ DefectKind::MissingStones => *kind = DefectKind::ThinRing { face: Face::Intrados, depth },
            _ => {}
        }
    }
    span.rings = vec![ring];
}

fn fill_as_weight(bridge: &mut Bridge) {
    if bridge.continuum.take().is_some() {
        bridge.cover.layers.iter_mut().for_each(|layer| layer.continuum = false);
        let backing = bridge.cover.backing.as_mut().filter(|backing| backing.body == BackingBody::Continuum);
        backing.into_iter().for_each(|backing| backing.body = BackingBody::Weight);
    }
    bridge.fill_pressure.iter_mut().for_each(|fill| fill.applies = false);
}

fn stiffen(bridge: &mut Bridge) {
    let Some([normal, shear]) = default_stiffness::taken(bridge) else { return };
    each_joint(bridge, |joint| {
        joint.normal_stiffness.get_or_insert(JointStiffness::Contact(normal));
        joint.shear_stiffness.get_or_insert(JointStiffness::Contact(shear));
    });
}

fn lose(help: Help, bridge: &mut Bridge) {
    match help {
        Help::Water => {
            bridge.cover.water = None;
            bridge.continuum.iter_mut().for_each(|plan| plan.water_level = None);
        }
        Help::Movement => bridge.plan.support_movement = None,
        Help::FillPressure => bridge.fill_pressure.iter_mut().for_each(|fill| fill.applies = false),
        Help::Parapets => bridge.spandrel_wall.iter_mut().for_each(|wall| wall.top = None),
        Help::LostStone => {
            bridge.spans.iter_mut().for_each(|span| span.defects.retain(|defect| !defect.kind.may_help()));
        }
        Help::Tension => {
            each_joint(bridge, |joint| joint.tensile_strength = 0.0);
            bridge.cover.layers.iter_mut().for_each(|layer| layer.tensile_strength = None);
            bridge.cover.backing.iter_mut().for_each(|backing| backing.tensile_strength = None);
        }
        Help::Cohesion => each_joint(bridge, |joint| joint.cohesion = 0.0),
    }
}

/// Changes the joints of rings, those between rings, and those of the spandrel walls.
pub(super) fn each_joint(bridge: &mut Bridge, change: impl Fn(&mut Joint)) {
    [&mut bridge.joint, &mut bridge.ring_joint].into_iter().for_each(&change);
    bridge.spandrel_wall.iter_mut().for_each(|wall| change(&mut wall.joint));
}
