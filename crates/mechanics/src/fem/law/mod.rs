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
mod three;
mod von_mises;

pub use drucker_prager::{Cone, DruckerPrager};
pub use elastic::Elastic;
pub use mohr_coulomb::MohrCoulomb;
pub use no_tension::NoTension;
pub use plane_stress::PlaneStress;
pub use von_mises::VonMises;

/// Strain or stress: `[xx, yy, zz, xy]`.
pub type Four = [f64; 4];

/// What a point remembers of its past; laws use of it what they need.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Memory {
    /// Plastic (or cracking) strain.
    pub plastic: Four,
    /// Accumulated plastic strain: the sum over steps of the length of its increment (engineering shear counted half).
    pub hardening: f64,
}

/// Answer of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// Stress [Pa].
    pub stress: Four,
    /// Consistent tangent [Pa]: `d stress[i] / d strain[j]`. Unsymmetric where flow is not associated.
    pub tangent: [[f64; 4]; 4],
    /// Memory if this strain is kept.
    pub memory: Memory,
    /// Whether the point flows, cracks or slips at this strain.
    pub yields: bool,
}

/// A law of a solid.
pub trait Law {
    /// Answers a total strain from the memory at the end of the last step that was kept.
    fn respond(&self, strain: &Four, old: &Memory) -> Response;
}

/// What strengths a solid has; each law takes what it knows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strength {
    /// Cohesion [Pa], or the strength in pure shear of what knows no friction.
    pub cohesion: f64,
    /// Angle of friction [rad].
    pub friction_angle: f64,
    /// Angle of dilatancy [rad].
    pub dilatancy_angle: f64,
    /// Greatest principal stress in tension [Pa]; none: what cohesion and friction leave.
    pub tension_cutoff: Option<f64>,
    /// Which cone stands for a pyramid.
    pub cone: Cone,
}

/// What a law says of itself, in its file.
trait Member: Law {
    /// The law of a solid of this elasticity and strength.
    fn of(elastic: Elastic, strength: &Strength) -> Self;

    /// The elasticity that it starts from.
    fn elastic(&self) -> Elastic;

    /// Whether its tangent is symmetric wherever it stands.
    fn symmetric(&self) -> bool {
        true
    }
}

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
                match self { $(Material::$law(law) => Member::elastic(law)),+ }
            }

            /// Whether its tangent is symmetric wherever it stands.
            #[must_use]
            pub fn symmetric(&self) -> bool {
                match self { $(Material::$law(law) => Member::symmetric(law)),+ }
            }
        }

        impl Law for Material {
            fn respond(&self, strain: &Four, old: &Memory) -> Response {
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
}

impl Law for Solid {
    /// In plane stress the strain `zz` that is passed in is not read.
    fn respond(&self, strain: &Four, old: &Memory) -> Response {
        match self.plane {
            Plane::Strain => self.material.respond(strain, old),
            Plane::Stress => PlaneStress(self.material).respond(strain, old),
        }
    }
}

/// Share of elasticity that tangents keep where a law may have none left: at an apex, a corner, a crack. Stress has no part of
/// it, so that answers are the same; equations of balance keep an inverse.
const KEPT: f64 = 1e-6;

/// Closes an answer whose tangent may vanish.
fn softened(elastic: &Elastic, strain: &Four, old: &Memory, stress: Four, mut tangent: [[f64; 4]; 4]) -> Response {
    for (row, whole) in tangent.iter_mut().zip(elastic.tangent()) {
        for (entry, whole) in row.iter_mut().zip(whole) {
            *entry += KEPT * (whole - *entry);
        }
    }
    flowed(elastic, strain, old, stress, tangent)
}

/// Closes an answer: what of the strain is not elastic becomes the new memory.
fn flowed(elastic: &Elastic, strain: &Four, old: &Memory, stress: Four, tangent: [[f64; 4]; 4]) -> Response {
    let kept = elastic.strain(&stress);
    let plastic: Four = std::array::from_fn(|i| strain[i] - kept[i]);
    let more: Four = std::array::from_fn(|i| plastic[i] - old.plastic[i]);
    let length = (more[0] * more[0] + more[1] * more[1] + more[2] * more[2] + 0.5 * more[3] * more[3]).sqrt();
    Response { stress, tangent, memory: Memory { plastic, hardening: old.hardening + length }, yields: true }
}
