//! Cards of loads and their dispersal.

use super::{Field, Kind, Section, Word};
use crate::quantity::Dimension::{Force, Length, Stress};

const KINDS: &[Word] = &[
    Word { word: "knife-edge", doc: "a strip across the whole width" },
    Word { word: "patch", doc: "a pressure across the whole width" },
    Word { word: "axle", doc: "one axle" },
    Word { word: "axles", doc: "a pattern of axles, travelling to the right" },
];

pub(super) static LOAD: Section = Section {
    path: "load",
    doc: "A load on the surface, downwards. Place it by `position` or `at`. A file that plans a passage and has no [analysis] needs none.",
    fields: &[
        Field::new("name", Kind::Text, "name of the load", "knife edge at the quarter point")
            .optional("named after its kind"),
        Field::new("kind", Kind::Word(KINDS), "shape of the load", "knife-edge"),
        Field::new("force", Kind::LineLoad, "force of the strip, per metre of width or over the whole width", "1 kN/m")
            .positive()
            .only("kind", &["knife-edge"]),
        Field::new("pressure", Kind::Quantity(Stress), "pressure on the surface", "10 kPa")
            .positive()
            .only("kind", &["patch"]),
        Field::new("length", Kind::Quantity(Length), "length of the loaded strip along the bridge", "0.750 m")
            .positive()
            .only("kind", &["knife-edge", "patch"]),
        Field::new("axle_force", Kind::Quantity(Force), "force of the axle", "100 kN")
            .positive()
            .only("kind", &["axle"]),
        Field::new(
            "axle_forces",
            Kind::Quantities(Force),
            "forces of the axles, from the first (rightmost) back",
            "[\"75 kN\", \"115 kN\"]",
        )
        .positive()
        .only("kind", &["axles"]),
        Field::new(
            "axle_spacings",
            Kind::Quantities(Length),
            "distances between the axles, one fewer than the axles",
            "[\"3.0 m\"]",
        )
        .positive()
        .only("kind", &["axles"]),
        Field::new(
            "contact_length",
            Kind::Quantity(Length),
            "length of a wheel's footprint along the bridge",
            "0.30 m",
        )
        .positive()
        .only("kind", &["axle", "axles"]),
        Field::new("effective_width", Kind::Quantity(Length), "width of the barrel that carries one axle", "2.5 m")
            .positive()
            .only("kind", &["axle", "axles"]),
        Field::new(
            "position",
            Kind::Quantity(Length),
            "middle of the strip or first axle, from the left springing of the first span",
            "4.575 m",
        )
        .optional("given by `at`"),
        Field::new("at", Kind::Share, "middle of the strip or first axle, as a share of a span", "1/4 of span 1")
            .optional("given by `position`"),
        Field::new("through", Kind::Word(BEARERS), "how a knife edge reaches the bridge", "block")
            .only("kind", &["knife-edge"])
            .default("cover"),
        Field::new(
            "block_weight",
            Kind::LineLoad,
            "weight of the loading block, per metre of width or over the whole width; counted in the load",
            "17.72 kN/m",
        )
        .positive()
        .only("through", &["block"]),
    ],
};

const BEARERS: &[Word] = &[
    Word { word: "cover", doc: "as a pressure that spreads through the cover, or as forces on the bricks of a wall" },
    Word { word: "block", doc: "through a rigid block that stands on a wall and cannot rotate" },
];

const RULES: &[Word] = &[
    Word { word: "none", doc: "straight down onto the extrados" },
    Word { word: "uniform", doc: "uniform over the dispersed length" },
    Word {
        word: "inverse-depth",
        doc: "intensity at the ends inversely proportional to their depth (Rouxinol, Providência and Lemos, eq. 2)",
    },
    Word { word: "boussinesq", doc: "Boussinesq's strip, cut off at the slope and scaled to the whole force" },
];

pub(super) static DISPERSAL: Section = Section {
    path: "dispersal",
    doc: "How loads spread through the cover from the surface to the extrados.",
    fields: &[
        Field::new("rule", Kind::Word(RULES), "rule of the pressure on the extrados", "inverse-depth"),
        Field::new("slope", Kind::Slope, "vertical to horizontal slope on each side", "2:1")
            .positive()
            .at_most(1000.0)
            .only("rule", &["uniform", "inverse-depth", "boussinesq"]),
    ],
};
