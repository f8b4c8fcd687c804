//! What the finite element model needs beyond what collapse asks for: mesh, soils, mortar and the contact of fill with masonry.
//! What a file leaves out stays `None` here; whoever computes says what is missing.

use crate::cards::*;
use crate::choice::choice;
use crate::model::{Backing, Masonry};
use crate::values::of_keys;

/// The part of a bridge file that only the finite element model reads.
#[derive(Debug, Clone, PartialEq)]
pub struct Service {
    /// How fine the mesh is and how far it reaches.
    pub mesh: MeshPlan,
    /// The fill above the rings.
    pub fill: Soil,
    /// Fill of the haunches, where it differs from the rest.
    pub haunch_fill: Option<HaunchFill>,
    /// Fill behind the abutments.
    pub abutment_fill: AbutmentFill,
    /// Mortar of the joints between voussoirs and at the springings.
    pub mortar: Mortar,
    /// Contact of fill with masonry.
    pub fill_contact: FillContact,
}

/// A value that the finite element model needs and the file does not give.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MissingValue {
    /// Table of the file.
    pub table: &'static str,
    /// Key in it.
    pub key: &'static str,
}

impl Service {
    /// What the finite element model of a bridge of this masonry and backing still needs, in the order of the file's reference.
    pub fn missing(&self, masonry: &Masonry, backing: Option<&Backing>) -> Vec<MissingValue> {
        let mut missing = Vec::new();
        let mut need = |table, key, there: bool| {
            if !there {
                missing.push(MissingValue { table, key });
            }
        };
        need("masonry", "elastic_modulus", masonry.elastic_modulus.is_some());
        need("masonry", "poisson_ratio", masonry.poisson_ratio.is_some());
        if let Some(backing) = backing {
            need("backing", "elastic_modulus", backing.elastic_modulus.is_some());
            need("backing", "poisson_ratio", backing.poisson_ratio.is_some());
        }
        let mut soils = vec![("fill", &self.fill)];
        soils.extend(self.haunch_fill.as_ref().map(|haunch| ("haunch_fill", &haunch.soil)));
        soils.push(("abutment_fill", &self.abutment_fill.soil));
        type Has = fn(&Soil) -> bool;
        let keys: [(&'static str, Has); 5] = [
            ("elastic_modulus", |soil| soil.elastic_modulus.is_some()),
            ("poisson_ratio", |soil| soil.poisson_ratio.is_some()),
            ("density", |soil| soil.density.is_some()),
            ("friction_angle", |soil| !soil.law.yields() || soil.friction_angle.is_some()),
            ("cohesion", |soil| !soil.law.yields() || soil.cohesion.is_some()),
        ];
        for (table, soil) in soils {
            for (key, has) in keys {
                // What the fill lacks is asked for once: there.
                need(table, key, has(soil) || (table != "fill" && !has(&self.fill)));
            }
        }
        need("mortar", "elastic_modulus", self.mortar.elastic_modulus.is_some());
        need("mortar", "thickness", self.mortar.thickness.is_some());
        need("fill_contact", "friction_coefficient", self.fill_contact.friction_coefficient.is_some());
        missing
    }
}

of_keys! {
    /// How fine the mesh is and how far it reaches.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct MeshPlan {
        pub size: Option<f64> = length(
            "length of an element near the rings and the surface; elements grow towards the boundaries",
            "0.20 m",
        )
        .between(0.005, 10.0)
        .optional("half the thickness of the thinnest ring"),
        pub ring_nodes: usize =
            count("nodes across the depth of a ring, and springs across a joint", "7").between(2.0, 100.0).default("7"),
        pub side_distance: Option<f64> = length("distance from the back of an abutment to the side boundary", "15 m")
            .positive_up_to(1000.0)
            .optional("twice the height from the lowest foundation to the surface"),
    }
}

of_keys! {
    /// A soil: granular fill, or what behaves like it.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Soil {
        pub elastic_modulus: Option<f64> =
            stress("Young's modulus of the fill", "110 MPa").positive().optional("unknown; `respond` needs it"),
        pub poisson_ratio: Option<f64> =
            number("Poisson's ratio of the fill", "0.19").between(0.0, 0.4999).optional("unknown; `respond` needs it"),
        pub density: Option<f64> = density("mass density of the fill", "1800 kg/m^3")
            .positive()
            .optional("that of the lowest layer of [[cover]]"),
        pub friction_angle: Option<f64> = angle("angle of friction of the fill", "30 deg")
            .between(0.0, 1.2)
            .optional("unknown; `respond` needs it unless the fill is elastic"),
        pub cohesion: Option<f64> = stress("cohesion of the fill", "10 kPa")
            .at_least(0.0)
            .optional("unknown; `respond` needs it unless the fill is elastic"),
        pub dilatancy_angle: f64 = angle("angle of dilatancy of the fill", "0 deg").between(0.0, 1.2).default("0 deg"),
        pub tension_cutoff: Option<f64> = stress("largest tension in the fill", "0 kPa")
            .at_least(0.0)
            .optional("no limit except the apex of cone or pyramid"),
        pub cone: Cone = word::<Cone>("how the Drucker-Prager cone is matched to Mohr-Coulomb", "inner")
            .default(Cone::PlaneStrain.word()),
        pub law: SoilLaw =
            word::<SoilLaw>("yield criterion of the fill", "mohr-coulomb").default(SoilLaw::DruckerPrager.word()),
    }
}

choice! {
    /// Where the cone of Drucker and Prager meets the pyramid of Mohr and Coulomb.
    pub enum Cone {
        /// matches Mohr-Coulomb in triaxial compression
        Compression = "compression",
        /// matches it in triaxial extension
        Extension = "extension",
        /// matches its failure load in plane strain
        PlaneStrain = "plane-strain",
        /// inscribed in it
        Inner = "inner",
    }
}

impl Soil {
    /// Friction angle [rad] and cohesion [Pa] with which the cone of triaxial compression acts in plane strain: those of the plane-strain cone
    /// (docs/theory/materials.md) that has its α and k, for its own flow. None for other cones and laws.
    pub fn acts_with(&self) -> Option<[f64; 2]> {
        if self.law != SoilLaw::DruckerPrager || self.cone != Cone::Compression {
            return None;
        }
        let (friction, cohesion) = (self.friction_angle?, self.cohesion?);
        let root = 3.0_f64.sqrt();
        let outer = |angle: f64| 2.0 * angle.sin() / (root * (3.0 - angle.sin()));
        let (alpha, beta) = (outer(friction), outer(self.dilatancy_angle));
        let strength = 6.0 * friction.cos() * cohesion / (root * (3.0 - friction.sin()));
        // α = sin φ / 3s and k = c cos φ / s with s = share + β sin φ, solved for φ and c.
        let share = (1.0 - 3.0 * beta * beta).sqrt();
        let sine = 3.0 * alpha * share / (1.0 - 3.0 * alpha * beta);
        if !(sine < 1.0) {
            return None;
        }
        let acts = sine.asin();
        Some([acts, strength * (share + beta * sine) / acts.cos()])
    }
}

choice! {
    /// When a soil yields.
    pub enum SoilLaw {
        /// yields on a cone
        DruckerPrager = "drucker-prager",
        /// yields on a pyramid
        MohrCoulomb = "mohr-coulomb",
        /// does not yield
        Elastic = "elastic",
    }
}

impl SoilLaw {
    /// Whether it needs friction and cohesion.
    fn yields(self) -> bool {
        match self {
            SoilLaw::DruckerPrager | SoilLaw::MohrCoulomb => true,
            SoilLaw::Elastic => false,
        }
    }
}

/// Fill of the haunches: over piers and abutments, between the extrados of two spans, up to a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HaunchFill {
    /// Level of its upper face above the springings [m].
    pub height: f64,
    /// What it is made of.
    pub soil: Soil,
}

/// Fill behind the abutments, from their foundation to the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AbutmentFill {
    /// How far it reaches behind the abutment's back [m]; none: to the boundary.
    pub extent: Option<f64>,
    /// What it is made of.
    pub soil: Soil,
}

of_keys! {
    /// Mortar of joints.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Mortar {
        pub elastic_modulus: Option<f64> =
            stress("Young's modulus of the mortar", "1.25 GPa").positive().optional("unknown; `respond` needs it"),
        pub thickness: Option<f64> =
            length("thickness of a joint", "12.5 mm").positive_up_to(1.0).optional("unknown; `respond` needs it"),
        pub lift_off: f64 = force("tension at which a spring lifts off, in a strip one metre wide", "1 kN")
            .at_least(0.0)
            .default("0 kN"),
        pub shear_strength: Option<f64> =
            stress("shear strength of the mortar", "1 MPa").at_least(0.0).optional("friction and cohesion of [joint]"),
        pub springs: Springs =
            word::<Springs>("how the stress across a joint is summed", "interface").default(Springs::Equal.word()),
    }
}

choice! {
    /// How the stress across a joint is summed.
    pub enum Springs {
        /// a spring at each node across the depth, all of the same area
        Equal = "equal",
        /// a spring at each node, with the area that belongs to it
        Nodal = "nodal",
        /// an interface of no thickness, with two Gauss points between neighbouring nodes
        Interface = "interface",
    }
}

of_keys! {
    /// Contact of fill with masonry.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct FillContact {
        pub friction_coefficient: Option<f64> =
            number("coefficient of friction", "0.4").between(0.0, 10.0).optional("unknown; `respond` needs it"),
        pub separation: bool = flag("whether fill and masonry may separate", "false").default("true"),
        pub stiffness: Option<f64> = joint_stiffness("normal stiffness per area of the contact", "1 GPa/m")
            .positive()
            .optional("from the fill's modulus and the size of its elements"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = include_str!("../tests/it/files/service.toml");

    fn codes(text: &str) -> Vec<&'static str> {
        crate::read(text.as_bytes()).diagnostics.iter().map(|finding| finding.code).collect()
    }

    /// A fill of 30 degrees may not act as one of 44 because nobody named a cone.
    #[test]
    fn the_cone_that_is_not_named_has_the_strength_of_the_soil() {
        let without = FILE.replacen("cone = \"plane-strain\"\n", "", 1);
        assert!(without != FILE);
        let fill = crate::read(without.as_bytes()).bridge.unwrap().service.fill;
        assert_eq!((fill.cone, fill.acts_with()), (Cone::PlaneStrain, None));
        let soil = Soil {
            friction_angle: Some(30f64.to_radians()),
            cohesion: Some(10e3),
            cone: Cone::Compression,
            ..Service::default().fill
        };
        let [friction, cohesion] = soil.acts_with().unwrap();
        assert!(
            (friction.to_degrees() - 43.854).abs() < 1e-3 && (cohesion - 16641.0).abs() < 1.0,
            "{friction} {cohesion}"
        );
    }

    /// Whoever asks for the outer cone is told what it does.
    #[test]
    fn the_outer_cone_is_doubted() {
        let outer = FILE.replacen("cone = \"plane-strain\"", "cone = \"compression\"", 1);
        assert!(codes(&outer).contains(&"P070") && !codes(FILE).contains(&"P070"));
    }
}
