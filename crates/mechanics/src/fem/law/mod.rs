//! What solids answer to strain: stress, tangent and new memory from strain and old memory. Pure functions.
//!
//! Components run `[xx, yy, zz, xy]`; the last strain is the engineering shear `gamma_xy`. Tension is positive.
//!
//! Every law answers the *total* strain, from the plastic strain at the end of the last step that was kept: what is asked in
//! between leaves no trace, and an iteration may go wrong and come back.

mod cone;
mod drucker_prager;
mod elastic;
mod mohr_coulomb;
mod no_tension;
mod plane_stress;
mod polyhedron;
mod principal;
mod response;
mod strength;
mod three;
mod von_mises;

pub use drucker_prager::DruckerPrager;
pub use elastic::Elastic;
pub use mohr_coulomb::MohrCoulomb;
pub use no_tension::NoTension;
pub use plane_stress::across;
pub use response::{Four, Law, Memory, Response};
pub use strength::{Cone, Strength};
pub use von_mises::VonMises;

/// Makes a material of elasticity and strength.
pub type Build = fn(Elastic, &Strength) -> Material;

/// The list of laws: what each is, and its name.
macro_rules! laws {
    ($($(#[$doc:meta])+ $law:ident = $name:literal,)+) => {
        /// What a zone is made of.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum Material { $($(#[$doc])+ $law($law)),+ }

        const NAMED: &[(&str, Build)] = &[$(($name, |elastic, strength| Material::$law($law::of(elastic, strength)))),+];

        impl Material {
            /// The elasticity that every one of them starts from.
            #[must_use]
            pub fn elastic(&self) -> Elastic {
                match self { $(Material::$law(law) => law.elastic()),+ }
            }

            /// Whether its tangent is symmetric wherever it stands.
            #[must_use]
            pub fn symmetric(&self) -> bool {
                match self { $(Material::$law(law) => law.symmetric()),+ }
            }

            /// Answers a total strain from the memory at the end of the last step that was kept.
            #[must_use]
            pub fn respond(&self, strain: &Four, old: &Memory) -> Response {
                match self { $(Material::$law(law) => law.respond(strain, old)),+ }
            }
        }
    };
}

laws! {
    /// Linear elastic.
    Elastic = "elastic",
    /// Elastic, perfectly plastic, of a strength in shear that knows no pressure.
    VonMises = "von-mises",
    /// Elastic, perfectly plastic on a cone about the hydrostatic axis.
    DruckerPrager = "drucker-prager",
    /// Elastic, perfectly plastic on the six-sided pyramid of friction and cohesion.
    MohrCoulomb = "mohr-coulomb",
    /// Elastic under compression, without any strength in tension; cracks close again.
    NoTension = "no-tension",
}

/// The law of a name. In a constant, a name that no law has does not compile.
#[must_use]
pub const fn named(name: &str) -> Build {
    let name = name.as_bytes();
    let mut law = 0;
    while law < NAMED.len() {
        let own = NAMED[law].0.as_bytes();
        let mut same = 0;
        while same < name.len() && same < own.len() && own[same] == name[same] {
            same += 1;
        }
        if same == name.len() && same == own.len() {
            return NAMED[law].1;
        }
        law += 1;
    }
    panic!("no law has this name")
}

impl Material {
    /// Whether it is linear, so that stress is its tangent times strain and nothing is remembered.
    #[must_use]
    pub fn linear(&self) -> bool {
        matches!(self, Material::Elastic(_))
    }
}

/// What is held across the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Plane {
    /// No strain across: bodies long in that direction, such as a barrel or its fill.
    #[default]
    Strain,
    /// No stress across: thin sheets.
    Stress,
}

/// A material in one of the two states of plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solid {
    /// What it is made of.
    pub material: Material,
    /// What is held across.
    pub plane: Plane,
}

impl Solid {
    /// Whether a point provably stays elastic at all `L` strains. `false` proves nothing: the law has to be evaluated.
    #[inline(always)]
    pub(super) fn provably_linear<const L: usize>(&self, strain: &[[f64; L]; 4], old: &Memory) -> bool {
        match (&self.material, self.plane) {
            (Material::DruckerPrager(law), Plane::Strain) => law.provably_linear(strain, old),
            _ => false,
        }
    }

    /// Answers a total strain from the memory at the end of the last step that was kept. In plane stress the strain `zz` that is passed in
    /// is not read.
    #[must_use]
    pub fn respond(&self, strain: &Four, old: &Memory) -> Response {
        match self.plane {
            Plane::Strain => self.material.respond(strain, old),
            Plane::Stress => plane_stress::respond(&self.material, strain, old),
        }
    }
}
