//! Cards of what lies above the rings.

use super::{Field, Kind, Section, Word};
use crate::quantity::Dimension::{Angle, Density, Length, Stress};

const LAYERS: &[Word] = &[
    Word { word: "fill", doc: "soil or rubble directly on the extrados" },
    Word { word: "sub-base", doc: "road base" },
    Word { word: "surfacing", doc: "road surface" },
    Word { word: "ballast", doc: "railway ballast" },
];

const BODIES: &[Word] = &[
    Word { word: "weight", doc: "weight on the extrados; loads disperse through it" },
    Word { word: "particles", doc: "circular particles that carry and press; strip \"fill\", method \"dem\"" },
    Word { word: "blocks", doc: "slabs of `block_length` that lie on particles" },
    Word { word: "nothing", doc: "a depth through which loads disperse, without weight" },
];

pub(super) static COVER: Section = Section {
    path: "cover",
    doc: "A layer above the rings, from the extrados up; the lowest fills the haunches. Loads disperse through all layers.",
    fields: &[
        Field::new("layer", Kind::Word(LAYERS), "what the layer is", "fill"),
        Field::new("thickness", Kind::Quantity(Length), "thickness above the crown of the highest extrados", "0.203 m")
            .at_least(0.0)
            .at_most(100.0),
        Field::new(
            "weighs",
            Kind::Flag,
            "whether its weight acts on the ring; loads disperse through it either way",
            "true",
        )
        .only("as", &["weight"])
        .default("true"),
        Field::new("as", Kind::Word(BODIES), "what the layer is in the discrete element method", "particles")
            .default("weight"),
        Field::new(
            "friction_angle",
            Kind::Quantity(Angle),
            "angle of friction between the layer's particles",
            "35.6 deg",
        )
        .at_least(0.0)
        .at_most(1.5)
        .only("as", &["particles"])
        .optional("as [particle_joint] says"),
        Field::new("cohesion", Kind::Quantity(Stress), "cohesion between the layer's particles", "10 kPa")
            .at_least(0.0)
            .only("as", &["particles"])
            .optional("as [particle_joint] says"),
        Field::new("block_length", Kind::Quantity(Length), "length of a slab along the bridge", "0.60 m")
            .positive()
            .only("as", &["blocks"]),
        Field::new("density", Kind::Quantity(Density), "mass density of the layer", "1890 kg/m^3")
            .positive()
            .optional("possible only where `weighs = false`"),
        Field::new("elastic_modulus", Kind::Quantity(Stress), "Young's modulus of the layer", "40 MPa")
            .positive()
            .optional("not needed for collapse"),
    ],
};

const BACKINGS: &[Word] = &[
    Word { word: "weight", doc: "weight on the extrados" },
    Word { word: "particles", doc: "circular particles below its level, with properties of their own" },
    Word {
        word: "blocks",
        doc: "blocks of masonry, joined as voussoirs are: stones with level beds on backs steeper than 45 degrees, a column on \
              every flatter one; over an abutment's top they rest by friction alone; strip \"fill\"",
    },
];

pub(super) static BACKING: Section = Section {
    path: "backing",
    doc: "Solid backing above the haunches, up to a level.",
    fields: &[
        Field::new("height", Kind::Quantity(Length), "level of the backing's upper face above the springings", "1.5 m")
            .positive(),
        Field::new("density", Kind::Quantity(Density), "mass density of the backing", "2000 kg/m^3").positive(),
        Field::new("elastic_modulus", Kind::Quantity(Stress), "Young's modulus of the backing", "3 GPa")
            .positive()
            .optional("not needed for collapse"),
        Field::new("poisson_ratio", Kind::Number, "Poisson's ratio of the backing", "0.2")
            .at_least(0.0)
            .at_most(0.4999)
            .optional("not needed for collapse"),
        Field::new(
            "as",
            Kind::Word(BACKINGS),
            "what the backing is in limit analysis and in the discrete element method",
            "blocks",
        )
        .default("weight"),
        Field::new("friction_angle", Kind::Quantity(Angle), "angle of friction between its particles", "40 deg")
            .at_least(0.0)
            .at_most(1.5)
            .only("as", &["particles"])
            .optional("as [particle_joint] says"),
        Field::new("cohesion", Kind::Quantity(Stress), "cohesion between its particles", "50 kPa")
            .at_least(0.0)
            .only("as", &["particles"])
            .optional("as [particle_joint] says"),
    ],
};
