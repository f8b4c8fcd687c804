//! Cards of vehicles that are moved over the bridge, and of fill that helps.

use super::{Field, Kind, Section, Word};
use crate::quantity::Dimension::{Angle, Length, Stress};

const WAYS: &[Word] = &[
    Word { word: "both", doc: "to the right and to the left" },
    Word { word: "right", doc: "to the right" },
    Word { word: "left", doc: "to the left" },
];

const SPREADS: &[Word] = &[
    Word { word: "rule", doc: "as in the rule, with the rule's footprint" },
    Word { word: "file", doc: "as in [dispersal], with each vehicle's footprint" },
];

pub(super) static SWEEP: Section = Section {
    path: "sweep",
    doc: "Vehicles that `extrados collapse --sweep` moves over the bridge by limit analysis: every position, both \
          directions, every group of neighbouring axles, with the factors of a rule on loads and weights. Vehicles and \
          rules of the library are listed in docs/theory/load-rules.md.",
    fields: &[
        Field::new("rule", Kind::Text, "rule of the library: factors, dispersal, impact", "cs-454").optional(
            "\"characteristic\": no safety factors, for comparisons, never for a verdict; or given by `rule_file`",
        ),
        Field::new("rule_file", Kind::Text, "file with a rule, relative to the bridge file", "our-rule.toml")
            .optional("a rule of the library"),
        Field::new(
            "vehicles",
            Kind::Values,
            "codes of vehicles, load models or trains of the library, or of `vehicle_files`",
            "[\"hb-45\", \"cs-454\"]",
        )
        .optional("all of the library, and of `vehicle_files`"),
        Field::new(
            "vehicle_files",
            Kind::Values,
            "files with vehicles, relative to the bridge file",
            "[\"our-crane.toml\"]",
        )
        .optional("none"),
        Field::new("step", Kind::Quantity(Length), "distance between positions", "0.25 m")
            .positive()
            .optional("a sixtieth of the shortest span; the worst position between steps is then found"),
        Field::new("directions", Kind::Word(WAYS), "directions in which vehicles travel", "both").default("both"),
        Field::new("subsets", Kind::Flag, "whether every group of neighbouring axles is tried", "true").default("true"),
        Field::new("dispersal", Kind::Word(SPREADS), "how axles spread through the cover", "rule").default("rule"),
        Field::new(
            "discrete_elements",
            Kind::Flag,
            "whether the governing case is also analysed by discrete elements; the smaller number counts",
            "true",
        )
        .default("false"),
        Field::new("confirm", Kind::Flag, "the former name of `discrete_elements`", "true").default("false"),
    ],
};

pub(super) static CARRIAGEWAY: Section = Section {
    path: "carriageway",
    doc: "Possible positions of vehicles of [sweep] across the bridge. In a plane model they determine the width of \
          the barrel that carries one vehicle: two abreast share the width between them, and for one at the edge the \
          width beyond it is missing. The worst arrangement counts.",
    fields: &[
        Field::new(
            "lanes",
            Kind::Count,
            "how many vehicles may stand abreast: lanes of a road, tracks of a railway",
            "2",
        )
        .at_least(1.0)
        .at_most(20.0)
        .optional("road: two where two of 2.5 m fit on the barrel, else one; railway: one"),
        Field::new(
            "lane_width",
            Kind::Quantity(Length),
            "distance between the middles of two vehicles abreast",
            "2.5 m",
        )
        .positive()
        .optional("2.5 m on roads, 3.4 m on railways"),
        Field::new(
            "edge_distance",
            Kind::Quantity(Length),
            "distance from an edge of the barrel to the middle of the nearest wheel or rail",
            "0.8 m",
        )
        .at_least(0.0)
        .optional("vehicles stand in the middle of the barrel"),
        Field::new("skew", Kind::Quantity(Angle), "angle of skew: 0 for a square bridge", "15 deg")
            .at_least(0.0)
            .at_most(1.31)
            .optional("taken as square; the model is square in any case"),
    ],
};

const LEAST: &[Word] = &[
    Word { word: "at-rest", doc: "at rest: 1 - sin(phi) of the vertical stress (Jaky)" },
    Word { word: "active", doc: "Rankine's active pressure, without cohesion" },
    Word { word: "none", doc: "nothing" },
];

pub(super) static FILL_PRESSURE: Section = Section {
    path: "fill_pressure",
    doc: "Horizontal pressure of the fill on the rings' backs in limit analysis: between the pressure at rest and a \
          share of Rankine's passive pressure, which acts only where a back moves against the fill. \
          docs/theory/fill-pressure.md gives the sources of the shares. The discrete element method does not use this \
          table: particles exert pressure themselves.",
    fields: &[
        Field::new("applies", Kind::Flag, "whether it acts", "true").default("true"),
        Field::new("friction_angle", Kind::Quantity(Angle), "angle of friction of the fill", "30 deg")
            .at_least(0.0)
            .at_most(1.2),
        Field::new("cohesion", Kind::Quantity(Stress), "cohesion of the fill", "5 kPa").at_least(0.0).default("0 kPa"),
        Field::new(
            "mobilisation",
            Kind::Number,
            "share of the passive pressure of friction that movement mobilises",
            "0.5",
        )
        .at_least(0.0)
        .at_most(1.0)
        .default("0.5"),
        Field::new("cohesion_mobilisation", Kind::Number, "share of the passive pressure of cohesion", "0.05")
            .at_least(0.0)
            .at_most(1.0)
            .default("0.05"),
        Field::new("least", Kind::Word(LEAST), "pressure on backs that do not move against the fill", "at-rest")
            .default("at-rest"),
    ],
};
