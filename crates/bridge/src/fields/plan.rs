//! Cards of the analysis plan. Numerical settings have defaults; what belongs to the bridge has none.

use super::{Field, Kind, Section, Word};
use crate::quantity::Dimension::{AngleRate, Length};

const METHODS: &[Word] = &[
    Word { word: "dem", doc: "discrete elements: deformable joints, loads in steps to collapse" },
    Word { word: "limit", doc: "limit analysis: the exact collapse load of rigid blocks" },
    Word {
        word: "fe",
        doc: "finite elements: elastic stones on joints that open and slide; one ring between fixed abutments",
    },
];

const ANALYSES: &[Word] = &[
    Word { word: "load", doc: "the load that makes a mechanism" },
    Word { word: "thickness", doc: "the least ring thickness that stands" },
    Word { word: "support-movement", doc: "the support movement that makes a mechanism" },
];

const STRIPS: &[Word] = &[
    Word { word: "fill", doc: "between the walls: rings and cover" },
    Word { word: "wall", doc: "below the walls: rings and bricks, loads as forces on the uppermost course" },
    Word { word: "both", doc: "both strips, and their loads added up by their widths" },
];

const DAMPINGS: &[Word] = &[
    Word { word: "local", doc: "each motion is opposed by a share of its out-of-balance force" },
    Word { word: "viscous", doc: "global, proportional to mass and velocity" },
    Word { word: "adaptive", doc: "global viscous, with an intensity that follows the motion" },
];

const LENGTHS: &[Word] = &[
    Word { word: "fixed", doc: "kept as built (force formulation)" },
    Word { word: "updated", doc: "follows the compressed part of the joint (stress formulation)" },
];

const FRICTIONS: &[Word] = &[
    Word { word: "associated", doc: "sliding dilates by the friction angle: exact bounds" },
    Word { word: "non-associated", doc: "sliding does not dilate: iterative correction" },
    Word { word: "automatic", doc: "non-associated where sliding takes part in the mechanism or lowers the load" },
];

const CONTACT_POINTS: &[Word] = &[
    Word { word: "rounded", doc: "between the rounded corners, as in the discrete element method" },
    Word { word: "full-ring", doc: "anywhere in the full thickness" },
];

pub(super) static ANALYSIS: Section = Section {
    path: "analysis",
    doc: "What to analyse, and how exactly. Only `load_step` has no default: the discrete element method needs it.",
    fields: &[
        Field::new("method", Kind::Word(METHODS), "method for the collapse load", "dem").default("limit"),
        Field::new(
            "analysis",
            Kind::Word(ANALYSES),
            "what is increased or reduced until \
                                                      collapse",
            "load",
        )
        .default("load"),
        Field::new("strip", Kind::Word(STRIPS), "strip of the bridge's width that is analysed", "both").default("fill"),
        Field::new("load_step", Kind::LineLoad, "load increment, per metre of width or over the whole width", "100 kN")
            .positive()
            .optional("needed by method \"dem\" for a load"),
        Field::new(
            "load_limit",
            Kind::LineLoad,
            "largest load tried, per metre of width or over the whole width",
            "20 MN",
        )
        .positive()
        .optional("until collapse"),
        Field::new(
            "resolution",
            Kind::LineLoad,
            "collapse is refined to this resolution below the increment",
            "1 kN/m",
        )
        .positive()
        .optional("as coarse as the increment"),
        Field::new("tolerance", Kind::Number, "out-of-balance force at rest over the acting forces", "1e-5")
            .above(0.0)
            .at_most(0.1)
            .default("1e-5"),
        Field::new("step_limit", Kind::Count, "most iterations in one load step", "2000000")
            .at_least(1.0)
            .at_most(1e12)
            .default("2000000"),
        Field::new("damping", Kind::Word(DAMPINGS), "numerical damping", "local").default("local"),
        Field::new("damping_share", Kind::Number, "share of the out-of-balance force, or of critical damping", "0.8")
            .above(0.0)
            .at_most(1.0)
            .only("damping", &["local", "viscous"])
            .default("0.8"),
        Field::new("contact_length", Kind::Word(LENGTHS), "length of joint that a contact point represents", "fixed")
            .default("fixed"),
        Field::new("time_step_factor", Kind::Number, "share of the critical time step", "0.8")
            .above(0.0)
            .at_most(1.0)
            .default("0.8"),
        Field::new("friction", Kind::Word(FRICTIONS), "friction rule of limit analysis", "automatic")
            .default("automatic"),
        Field::new(
            "contact_points",
            Kind::Word(CONTACT_POINTS),
            "position of the contact points of a joint in limit analysis",
            "rounded",
        )
        .default("rounded"),
        Field::new("seed", Kind::Count, "seed of whatever is random", "1").at_least(0.0).at_most(9e15).default("1"),
    ],
};

pub(super) static SUPPORT_MOVEMENT: Section = Section {
    path: "support_movement",
    doc: "A movement of one support: for each metre of the movement s it goes s times `horizontal` to the right, s times \
          `vertical` up, and turns by s times `rotation`.",
    fields: &[
        Field::new("support", Kind::Support, "which support moves", "right abutment"),
        Field::new("horizontal", Kind::Number, "direction to the right, per unit of movement", "1.0")
            .at_least(-1e3)
            .at_most(1e3)
            .optional("no horizontal part"),
        Field::new("vertical", Kind::Number, "direction up, per unit of movement", "-0.5")
            .at_least(-1e3)
            .at_most(1e3)
            .optional("no vertical part"),
        Field::new(
            "rotation",
            Kind::Quantity(AngleRate),
            "rotation counter-clockwise, per metre of movement",
            "0.5 deg/m",
        )
        .at_least(-1e3)
        .at_most(1e3)
        .optional("no rotation"),
        Field::new("increment", Kind::Quantity(Length), "increment of the movement", "1 mm")
            .positive()
            .optional("needed by method \"dem\""),
        Field::new("limit", Kind::Quantity(Length), "largest movement tried", "500 mm")
            .positive()
            .optional("until collapse"),
    ],
};
