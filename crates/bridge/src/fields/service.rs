//! Cards of what only the finite element model reads.

use super::{Field, Kind, Section, Word};
use crate::quantity::Dimension::{Angle, Density, Force, JointStiffness, Length, Stress};

pub(super) static MESH: Section = Section {
    path: "mesh",
    doc: "How fine the finite element mesh is and how far it reaches.",
    fields: &[
        Field::new(
            "size",
            Kind::Quantity(Length),
            "length of an element near the rings and the surface; elements grow towards the boundaries",
            "0.20 m",
        )
        .at_least(0.005)
        .at_most(10.0)
        .optional("half the thickness of the thinnest ring"),
        Field::new("ring_nodes", Kind::Count, "nodes across the depth of a ring, and springs across a joint", "7")
            .at_least(2.0)
            .at_most(100.0)
            .default("7"),
        Field::new(
            "side_distance",
            Kind::Quantity(Length),
            "distance from the back of an abutment to the side boundary",
            "15 m",
        )
        .positive()
        .at_most(1000.0)
        .optional("twice the height from the lowest foundation to the surface"),
    ],
};

const CONES: &[Word] = &[
    Word { word: "compression", doc: "matches Mohr-Coulomb in triaxial compression" },
    Word { word: "extension", doc: "matches it in triaxial extension" },
    Word { word: "plane-strain", doc: "matches its failure load in plane strain" },
    Word { word: "inner", doc: "inscribed in it" },
];

const LAWS: &[Word] = &[
    Word { word: "drucker-prager", doc: "yields on a cone" },
    Word { word: "mohr-coulomb", doc: "yields on a pyramid" },
    Word { word: "elastic", doc: "does not yield" },
];

const MODULUS: Field =
    Field::new("elastic_modulus", Kind::Quantity(Stress), "Young's modulus of the fill", "110 MPa").positive();
const POISSON: Field =
    Field::new("poisson_ratio", Kind::Number, "Poisson's ratio of the fill", "0.19").at_least(0.0).at_most(0.4999);
const DENSITY: Field =
    Field::new("density", Kind::Quantity(Density), "mass density of the fill", "1800 kg/m^3").positive();
const FRICTION: Field = Field::new("friction_angle", Kind::Quantity(Angle), "angle of friction of the fill", "30 deg")
    .at_least(0.0)
    .at_most(1.2);
const COHESION: Field = Field::new("cohesion", Kind::Quantity(Stress), "cohesion of the fill", "10 kPa").at_least(0.0);
const DILATANCY: Field =
    Field::new("dilatancy_angle", Kind::Quantity(Angle), "angle of dilatancy of the fill", "0 deg")
        .at_least(0.0)
        .at_most(1.2);
const CUTOFF: Field =
    Field::new("tension_cutoff", Kind::Quantity(Stress), "largest tension in the fill", "0 kPa").at_least(0.0);
const CONE: Field =
    Field::new("cone", Kind::Word(CONES), "how the Drucker-Prager cone is matched to Mohr-Coulomb", "inner");
const LAW: Field = Field::new("law", Kind::Word(LAWS), "yield criterion of the fill", "mohr-coulomb");

const AS_FILL: &str = "as [fill] says";

pub(super) static FILL: Section = Section {
    path: "fill",
    doc: "Fill between the rings and the surface, in the finite element model.",
    fields: &[
        MODULUS.optional("unknown; `respond` needs it"),
        POISSON.optional("unknown; `respond` needs it"),
        DENSITY.optional("that of the lowest layer of [[cover]]"),
        FRICTION.optional("unknown; `respond` needs it unless the fill is elastic"),
        COHESION.optional("unknown; `respond` needs it unless the fill is elastic"),
        DILATANCY.default("0 deg"),
        CUTOFF.optional("no limit except the apex of cone or pyramid"),
        CONE.default("plane-strain"),
        LAW.default("drucker-prager"),
    ],
};

pub(super) static HAUNCH_FILL: Section = Section {
    path: "haunch_fill",
    doc: "Fill of the haunches up to a level, over piers and abutments, where it differs from [fill].",
    fields: &[
        Field::new("height", Kind::Quantity(Length), "level of its upper face above the springings", "1.0 m")
            .positive()
            .at_most(200.0),
        MODULUS.optional(AS_FILL),
        POISSON.optional(AS_FILL),
        DENSITY.optional(AS_FILL),
        FRICTION.optional(AS_FILL),
        COHESION.optional(AS_FILL),
        DILATANCY.optional(AS_FILL),
        CUTOFF.optional(AS_FILL),
        CONE.optional(AS_FILL),
        LAW.optional(AS_FILL),
    ],
};

pub(super) static ABUTMENT_FILL: Section = Section {
    path: "abutment_fill",
    doc: "Fill behind the abutments, from their foundation to the surface, where it differs from [fill].",
    fields: &[
        Field::new("extent", Kind::Quantity(Length), "how far it reaches behind the abutment's back", "6 m")
            .positive()
            .at_most(1000.0)
            .optional("to the side boundary"),
        MODULUS.optional(AS_FILL),
        POISSON.optional(AS_FILL),
        DENSITY.optional(AS_FILL),
        FRICTION.optional(AS_FILL),
        COHESION.optional(AS_FILL),
        DILATANCY.optional(AS_FILL),
        CUTOFF.optional(AS_FILL),
        CONE.optional(AS_FILL),
        LAW.optional(AS_FILL),
    ],
};

const SPRINGS: &[Word] = &[
    Word { word: "equal", doc: "a spring at each node across the depth, all of the same area" },
    Word { word: "nodal", doc: "a spring at each node, with the area that belongs to it" },
    Word { word: "interface", doc: "an interface of no thickness, with two Gauss points between neighbouring nodes" },
];

pub(super) static MORTAR: Section = Section {
    path: "mortar",
    doc: "Mortar between voussoirs and at the springings, in the finite element model.",
    fields: &[
        Field::new("elastic_modulus", Kind::Quantity(Stress), "Young's modulus of the mortar", "1.25 GPa")
            .positive()
            .optional("unknown; `respond` needs it"),
        Field::new("thickness", Kind::Quantity(Length), "thickness of a joint", "12.5 mm")
            .positive()
            .at_most(1.0)
            .optional("unknown; `respond` needs it"),
        Field::new(
            "lift_off",
            Kind::Quantity(Force),
            "tension at which a spring lifts off, in a strip one metre wide",
            "1 kN",
        )
        .at_least(0.0)
        .default("0 kN"),
        Field::new("shear_strength", Kind::Quantity(Stress), "shear strength of the mortar", "1 MPa")
            .at_least(0.0)
            .optional("friction and cohesion of [joint]"),
        Field::new("springs", Kind::Word(SPRINGS), "how the stress across a joint is summed", "interface")
            .default("equal"),
    ],
};

pub(super) static FILL_CONTACT: Section = Section {
    path: "fill_contact",
    doc: "Contact of fill with rings, piers and abutments, in the finite element model.",
    fields: &[
        Field::new("friction_coefficient", Kind::Number, "coefficient of friction", "0.4")
            .at_least(0.0)
            .at_most(10.0)
            .optional("unknown; `respond` needs it"),
        Field::new("separation", Kind::Flag, "whether fill and masonry may separate", "false").default("true"),
        Field::new("stiffness", Kind::Quantity(JointStiffness), "normal stiffness per area of the contact", "1 GPa/m")
            .positive()
            .optional("from the fill's modulus and the size of its elements"),
    ],
};
