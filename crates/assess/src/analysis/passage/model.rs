//! What the zones and interfaces of a mesh are made of: the finite element model of a bridge.

use super::PassageError;
use crate::analysis::defects::told_of_elements;
use bridge::choice::Choice;
use bridge::{Bridge, Cone as FileCone, Joint, Soil, SoilLaw};
use mechanics::fem::joint::{Contact, JointLaw, LiftOff, Mortar, Shear};
use mechanics::fem::law::{self, Cone, Elastic, Material, Plane, Solid, Strength};
use mechanics::fem::{Element, Kinematics, Model, Section, Support};
use mechanics::ids::NodeId;
use outcome::note::{InPassage, JointShear, Note};
use structure::discretise::mesh::{Meshed, Role, Substance};

/// Stiffness of the contact of fill with masonry over that of an element of fill next to it.
const PENALTY: f64 = 20.0;

/// Pressure over which friction sets in where fill never parts from masonry [Pa]: three centimetres of fill.
const ROUNDING: f64 = 500.0;

/// The model of a meshed bridge.
pub(super) fn model(bridge: &Bridge, meshed: &Meshed, kinematics: Kinematics) -> Result<Model, PassageError> {
    let missing = bridge.service.missing(&bridge.masonry, bridge.cover.backing.as_ref());
    if !missing.is_empty() {
        let keys: Vec<String> = missing.iter().map(|m| format!("`{}` in [{}]", m.key, m.table)).collect();
        return Err(PassageError::Missing(keys.join(", ")));
    }
    let sections = meshed.roles.iter().map(|role| section(bridge, *role)).collect();
    let joints = vec![
        mortar(bridge, &bridge.joint),
        mortar(bridge, &bridge.ring_joint),
        JointLaw::Contact(contact(bridge, meshed)),
    ];
    Model::new(meshed.mesh.clone(), sections, joints, &supports(meshed), kinematics).map_err(PassageError::Model)
}

/// The base is fixed, the sides are held horizontally.
fn supports(meshed: &Meshed) -> Vec<Support> {
    let held = |held: [bool; 2]| move |node: &NodeId| Support { node: *node, held };
    let base = meshed.sets.base.iter().map(held([true, true]));
    let sides = meshed.sets.left.iter().chain(&meshed.sets.right).map(held([true, false]));
    base.chain(sides).collect()
}

fn section(bridge: &Bridge, role: Role) -> Section {
    let elastic = |modulus: Option<f64>, ratio: Option<f64>| Elastic {
        modulus: modulus.unwrap_or_default(),
        ratio: ratio.unwrap_or_default(),
    };
    let (material, density) = match role.substance(bridge) {
        Substance::Masonry(masonry) => {
            (Material::Elastic(elastic(masonry.elastic_modulus, masonry.poisson_ratio)), masonry.density)
        }
        Substance::Backing(backing) => {
            (Material::Elastic(elastic(backing.elastic_modulus, backing.poisson_ratio)), backing.density)
        }
        Substance::Soil(soil) => {
            let soil = whole(soil, &bridge.service.fill);
            (soil_law(&soil, elastic(soil.elastic_modulus, soil.poisson_ratio)), soil.density.unwrap_or_default())
        }
    };
    // Incompatible modes bend stones as they should; in soil that flows without dilating they find no balance of their own.
    let density = density * weight_share(bridge, role);
    let element = if material.linear() { Element::QM6 } else { Element::Q4 };
    Section { solid: Solid { material, plane: Plane::Strain }, element, density }
}

/// How much more a zone weighs than masonry of the barrel's width: piers by their mean width across the bridge.
fn weight_share(bridge: &Bridge, role: Role) -> f64 {
    let Role::Pier(pier) = role else { return 1.0 };
    bridge.piers[pier].across.map_or(1.0, |[top, bottom]| 0.5 * (top + bottom) / bridge.width)
}

/// A soil with what it leaves out taken from the fill.
fn whole(soil: &Soil, fill: &Soil) -> Soil {
    Soil {
        elastic_modulus: soil.elastic_modulus.or(fill.elastic_modulus),
        poisson_ratio: soil.poisson_ratio.or(fill.poisson_ratio),
        density: soil.density.or(fill.density),
        friction_angle: soil.friction_angle.or(fill.friction_angle),
        cohesion: soil.cohesion.or(fill.cohesion),
        ..*soil
    }
}

/// The law of every word of the file, in the order of the words: a word without a law does not compile.
const LAWS: [law::Build; SoilLaw::WORDS.len()] = {
    let (mut laws, mut k) = ([law::named(SoilLaw::WORDS[0].word); SoilLaw::WORDS.len()], 0);
    while k < laws.len() {
        laws[k] = law::named(SoilLaw::WORDS[k].word);
        k += 1;
    }
    laws
};

fn soil_law(soil: &Soil, elastic: Elastic) -> Material {
    let strength = Strength {
        cohesion: soil.cohesion.unwrap_or_default(),
        friction_angle: soil.friction_angle.unwrap_or_default(),
        dilatancy_angle: soil.dilatancy_angle,
        tension_cutoff: soil.tension_cutoff,
        cone: match soil.cone {
            FileCone::Compression => Cone::Compression,
            FileCone::Extension => Cone::Extension,
            FileCone::PlaneStrain => Cone::PlaneStrain,
            FileCone::Inner => Cone::Inner,
        },
    };
    LAWS[soil.law as usize](elastic, &strength)
}

/// Springs of the mortar's modulus over its thickness (railway paper, equation 1), beside shear panels of the stone's modulus where the
/// mortar has a shear strength, and friction and cohesion of the joint where it has none.
fn mortar(bridge: &Bridge, joint: &Joint) -> JointLaw {
    let bed = &bridge.service.mortar;
    let (modulus, thickness) = (bed.elastic_modulus.unwrap_or_default(), bed.thickness.unwrap_or(1.0));
    let stone = bridge.masonry.elastic_modulus.unwrap_or(modulus);
    let ratio = bridge.masonry.poisson_ratio.unwrap_or_default();
    JointLaw::Mortar(Mortar {
        normal: modulus / thickness,
        tangential: stone / (2.0 * (1.0 + ratio)) / thickness,
        lift_off: LiftOff::Force(bed.lift_off),
        compressive_strength: None,
        shear: match bed.shear_strength {
            // The panels stand beside the springs: what lifts off does not let go of them.
            Some(strength) => Shear::Panel { strength, when_open: true },
            None => Shear::Friction { coefficient: joint.friction_angle.tan(), cohesion: joint.cohesion },
        },
    })
}

/// Friction behind a penalty of many times the stiffness of the fill's own elements.
fn contact(bridge: &Bridge, meshed: &Meshed) -> Contact {
    let (contact, fill) = (&bridge.service.fill_contact, &bridge.service.fill);
    let own = PENALTY * fill.elastic_modulus.unwrap_or_default() / meshed.options.size;
    let normal = contact.stiffness.unwrap_or(own);
    Contact {
        normal,
        tangential: normal / (2.0 * (1.0 + fill.poisson_ratio.unwrap_or_default())),
        friction: contact.friction_coefficient.unwrap_or_default(),
        cohesion: 0.0,
        separation: contact.separation,
        rounding: ROUNDING,
    }
}

/// What the model assumes.
pub(super) fn assumptions(bridge: &Bridge, meshed: &Meshed) -> Vec<Note> {
    let Contact { normal: stiffness, friction, separation: parts, .. } = contact(bridge, meshed);
    let mut told = vec![
        InPassage::PlaneStrain,
        InPassage::Mortar { shear: shear(bridge) },
        InPassage::FillContact { stiffness, friction, parts },
        InPassage::Base,
        InPassage::SelfWeight,
    ];
    if bridge.piers.iter().any(|pier| pier.across.is_some() || !pier.footings.is_empty()) {
        told.push(InPassage::Piers);
    }
    if bridge.abutments.iter().any(|abutment| abutment.body.is_some()) {
        told.push(InPassage::Abutments);
    }
    let library = crate::analysis::caveats::from_library(bridge);
    told.into_iter().map(Note::from).chain(told_of_elements(bridge)).chain(library).collect()
}

/// What carries shear in joints.
fn shear(bridge: &Bridge) -> JointShear {
    match bridge.service.mortar.shear_strength {
        Some(strength) => JointShear::Panels(strength),
        None => JointShear::Friction([bridge.joint, bridge.ring_joint].map(|of| (of.friction_angle, of.cohesion))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::fem::joint::{PairMemory, PairState};

    /// What the reference says of a file that gives no shear strength: friction and cohesion of its joints decide.
    #[test]
    fn joints_without_shear_strength_rub_and_carry_nothing_where_open() {
        let mut bridge = super::super::tests::railway();
        let bed = &mut bridge.service.mortar;
        (bed.elastic_modulus, bed.thickness, bed.shear_strength) = (Some(1e9), Some(0.01), None);
        (bridge.joint.friction_angle, bridge.joint.cohesion) = (0.6_f64.atan(), 20e3);
        (bridge.ring_joint.friction_angle, bridge.ring_joint.cohesion) = (0.4_f64.atan(), 0.0);
        for (joint, friction, cohesion) in [(bridge.joint, 0.6, 20e3), (bridge.ring_joint, 0.4, 0.0)] {
            let law = mortar(&bridge, &joint);
            let fresh = PairMemory::default();
            let press = -200e3 / law.stiffness()[0];
            let slid = law.respond([press, 1.0], 0.1, &fresh);
            assert_eq!(slid.state, PairState::Sliding);
            assert!((slid.traction[1] - (200e3 * friction + cohesion)).abs() < 1e-3, "{:?}", slid.traction);
            let open = law.respond([1e-3, 1e-3], 0.1, &PairMemory { broken: true, ..fresh });
            assert_eq!(open.traction, [0.0; 2], "an open joint carries no shear");
        }
        // A strength of the mortar is what it is, whatever the joint's friction.
        bridge.service.mortar.shear_strength = Some(1e6);
        let panel = mortar(&bridge, &bridge.joint).respond([-1e-6, 1.0], 0.1, &PairMemory::default());
        assert_eq!(panel.traction[1], 1e6);
    }

    /// No word becomes another law than its own.
    #[test]
    fn every_word_is_the_law_of_its_name() {
        let fill = super::super::tests::railway().service.fill;
        let law = |law| soil_law(&Soil { law, ..fill }, Elastic { modulus: 1e8, ratio: 0.2 });
        assert!(matches!(law(SoilLaw::Elastic), Material::Elastic(_)));
        assert!(matches!(law(SoilLaw::DruckerPrager), Material::DruckerPrager(_)));
        assert!(matches!(law(SoilLaw::MohrCoulomb), Material::MohrCoulomb(_)));
    }
}
