//! Cards of a train's passage and of the sensors that record it.

use super::{Field, Kind, Section, Word};
use crate::quantity::Dimension::{Frequency, Length, Speed, Time};

const ANALYSES: &[Word] = &[
    Word { word: "static", doc: "every position at rest" },
    Word { word: "transient", doc: "with inertia and damping" },
];

const KINEMATICS: &[Word] = &[
    Word { word: "small", doc: "equilibrium on the bridge as built" },
    Word { word: "large", doc: "equilibrium on the deformed bridge: large displacements and rotations" },
];

const PATHS: &[Word] = &[
    Word {
        word: "condensed",
        doc: "linear parts are condensed once, and only nonlinear parts iterate; the same \
                                    numbers, much faster",
    },
    Word { word: "plain", doc: "all degrees of freedom at every position" },
];

pub(super) static PASSAGE: Section = Section {
    path: "passage",
    doc: "How the train crosses, and how that is analysed. Self-weight is applied first and subtracted afterwards.",
    fields: &[
        Field::new("speed", Kind::Quantity(Speed), "speed of the train", "45 km/h").at_least(0.01),
        Field::new("time_step", Kind::Quantity(Time), "time from one position to the next", "0.005 s")
            .at_least(1e-5)
            .default("0.005 s"),
        Field::new(
            "from",
            Kind::Quantity(Length),
            "position of the first axle at the start, from the left springing of the first span",
            "-10 m",
        )
        .optional("where the mesh begins"),
        Field::new("to", Kind::Quantity(Length), "position of the first axle at the end", "60 m")
            .optional("where the last axle leaves the mesh"),
        Field::new("analysis", Kind::Word(ANALYSES), "whether inertia is included", "static").default("static"),
        Field::new("damping_ratio", Kind::Number, "share of critical damping at `damping_frequencies`", "0.03")
            .at_least(0.0)
            .at_most(0.5)
            .optional("no damping except by friction and yielding"),
        Field::new(
            "damping_frequencies",
            Kind::Quantities(Frequency),
            "the two frequencies of Rayleigh damping, the lower first",
            r#"["8 Hz", "40 Hz"]"#,
        )
        .positive()
        .optional("possible only without `damping_ratio`"),
        Field::new(
            "numerical_damping",
            Kind::Number,
            "numerical damping of time integration: 0 is Newmark's average acceleration, larger values are the method \
             of Hilber, Hughes and Taylor",
            "0.05",
        )
        .at_least(0.0)
        .at_most(1.0 / 3.0)
        .default("0.0"),
        Field::new("kinematics", Kind::Word(KINEMATICS), "whether displacements and rotations are large", "small")
            .default("small"),
        Field::new("load_steps", Kind::Count, "load steps in which the self-weight is applied", "10")
            .at_least(1.0)
            .at_most(10_000.0)
            .default("10"),
        Field::new("iterations", Kind::Count, "most iterations of one step", "100")
            .at_least(1.0)
            .at_most(100_000.0)
            .default("100"),
        Field::new(
            "tolerance",
            Kind::Number,
            "out-of-balance force of a step that has converged, relative to the applied forces",
            "1e-6",
        )
        .at_least(1e-12)
        .at_most(0.1)
        .default("1e-6"),
        Field::new("path", Kind::Word(PATHS), "how positions are solved", "condensed").default("condensed"),
        Field::new(
            "pictures",
            Kind::Quantities(Length),
            "positions of the first axle for which pictures are made",
            r#"["3.0 m", "9.5 m"]"#,
        )
        .optional("the peak of every channel"),
    ],
};

const KINDS: &[Word] = &[
    Word { word: "displacement", doc: "movement of a point" },
    Word { word: "strain", doc: "mean strain of one voussoir along the ring over a gauge length; tension is positive" },
    Word { word: "joint-opening", doc: "how far a joint opens at a face; apart is positive" },
    Word {
        word: "joint-sliding",
        doc: "how far a joint slides; positive where its right side moves from intrados to extrados",
    },
    Word { word: "stress", doc: "stress along the ring; tension is positive" },
];

const DIRECTIONS: &[Word] = &[
    Word { word: "vertical", doc: "up is positive" },
    Word { word: "horizontal", doc: "to the right is positive" },
    Word { word: "lateral", doc: "horizontal, away from the middle of its span is positive" },
];

const PLACES: &[Word] = &[
    Word { word: "crown", doc: "the middle of the span" },
    Word { word: "left-springing", doc: "the left springing of the span" },
    Word { word: "right-springing", doc: "the right springing of the span" },
    Word { word: "pier-springing", doc: "that springing of an end span which rests on a pier" },
    Word { word: "abutment-springing", doc: "that springing of an end span which rests on an abutment" },
];

const FACES: &[Word] =
    &[Word { word: "intrados", doc: "the lower face of the ring" }, Word { word: "extrados", doc: "its upper face" }];

pub(super) static SENSOR: Section = Section {
    path: "sensor",
    doc: "A sensor: one channel of the record. Place it by `span` and `place`, by `at`, or by `x` and `y`.",
    fields: &[
        Field::new("name", Kind::Text, "name of the channel", "crown displacement"),
        Field::new("kind", Kind::Word(KINDS), "what it measures", "displacement"),
        Field::new("direction", Kind::Word(DIRECTIONS), "direction of the movement, and its sign", "vertical")
            .only("kind", &["displacement"]),
        Field::new(
            "gauge_length",
            Kind::Quantity(Length),
            "length over which strain is measured, within one voussoir",
            "120 mm",
        )
        .positive()
        .only("kind", &["strain"])
        .default("120 mm"),
        Field::new("span", Kind::Count, "which span, counted from 1 on the left", "1")
            .at_least(1.0)
            .at_most(200.0)
            .optional("the first"),
        Field::new("place", Kind::Word(PLACES), "position on the span, by name", "crown")
            .optional("given by `at`, or `x` and `y`"),
        Field::new("at", Kind::Share, "position as a share of a span", "1/4 of span 1")
            .optional("given by `place`, or `x` and `y`"),
        Field::new("x", Kind::Quantity(Length), "distance from the left springing of the first span", "3.0 m")
            .optional("given by `place` or `at`"),
        Field::new("y", Kind::Quantity(Length), "height above the left springing of the first span", "1.5 m")
            .optional("given by `place` or `at`"),
        Field::new("face", Kind::Word(FACES), "on which face of the ring", "intrados").default("intrados"),
    ],
};
