//! Cards of fill that is modelled as particles.

use super::{Field, Kind, Section};
use crate::quantity::Dimension::{Length, Stress};

pub(super) static PARTICLES: Section = Section {
    path: "particles",
    doc: "How layers with `as = \"particles\"` are filled with circular particles: strewn at random between the extrados, \
          the abutments and the road surface, and grown until they press on one another. The same seed ([analysis] seed) \
          gives the same packing.",
    fields: &[
        Field::new("count", Kind::Count, "number of particles", "1984")
            .at_least(10.0)
            .at_most(4e6)
            .optional("the number that follows from `smallest_diameter` and `largest_diameter`"),
        Field::new("size_ratio", Kind::Number, "largest over smallest diameter, where `count` is given", "1.5")
            .at_least(1.0)
            .at_most(20.0)
            .optional("1.5"),
        Field::new("smallest_diameter", Kind::Quantity(Length), "smallest diameter of a particle", "0.12 m")
            .positive()
            .optional("given by `count`"),
        Field::new("largest_diameter", Kind::Quantity(Length), "largest diameter of a particle", "0.18 m")
            .positive()
            .optional("given by `count`"),
        Field::new(
            "packing_stress",
            Kind::Quantity(Stress),
            "mean stress with which the particles press on one another when they have grown",
            "30 kPa",
        )
        .positive()
        .optional("the weight of the cover at half its mean depth, unless `solid_fraction` is given"),
        Field::new("solid_fraction", Kind::Number, "share of the region that the particles cover", "0.84")
            .at_least(0.5)
            .at_most(0.92)
            .optional("the fraction that follows from `packing_stress`"),
        Field::new("file", Kind::Text, "a packing that was saved, in place of a new one", "packing.csv")
            .optional("a new packing is made"),
        Field::new("elastic_modulus", Kind::Quantity(Stress), "modulus of the particles in the series rule", "40 MPa")
            .positive()
            .optional("needed for `mortar_…_stiffness` of [particle_joint]"),
        Field::new("poisson_ratio", Kind::Number, "Poisson's ratio in the series rule", "0.2")
            .at_least(0.0)
            .at_most(0.4999)
            .optional("needed for `mortar_shear_stiffness` of [particle_joint]"),
    ],
};
