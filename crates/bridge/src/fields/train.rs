//! Cards of trains and of the track under them.

use super::{Field, Kind, Section};
use crate::quantity::Dimension::{BendingStiffness, Force, Length, Mass, Stress};

pub(crate) static VEHICLE: Section = Section {
    path: "train.vehicle",
    doc: "A vehicle of the train, or several equal ones; the first one leads, and the train travels to the right. Give \
          `axle_loads` or `axle_forces`.",
    fields: &[
        Field::new("name", Kind::Text, "name of the vehicle", "locomotive").optional("vehicle"),
        Field::new("count", Kind::Count, "how many of them follow one another", "2")
            .at_least(1.0)
            .at_most(1000.0)
            .default("1"),
        Field::new(
            "axle_loads",
            Kind::Quantities(Mass),
            "mass on each axle, from the first one back; a single value is for all",
            r#"["20.5 t"]"#,
        )
        .positive()
        .at_most(1e6)
        .optional("given by `axle_forces`"),
        Field::new(
            "axle_forces",
            Kind::Quantities(Force),
            "force of each axle, from the first one back; a single value is for all",
            r#"["250 kN"]"#,
        )
        .positive()
        .at_most(1e7)
        .optional("given by `axle_loads`"),
        Field::new(
            "axle_spacings",
            Kind::Quantities(Length),
            "distances between the axles, one fewer than the axles",
            r#"["2.0 m", "4.524 m", "2.0 m"]"#,
        )
        .positive(),
        Field::new("front_overhang", Kind::Quantity(Length), "from the front coupler to the first axle", "1.0945 m")
            .at_least(0.0),
        Field::new("rear_overhang", Kind::Quantity(Length), "from the last axle to the rear coupler", "1.0945 m")
            .at_least(0.0),
    ],
};

pub(super) static TRAIN: Section = Section {
    path: "train",
    doc: "The train that crosses in `extrados respond`, travelling to the right: one of the library by its `name`, \
          vehicles from a `file`, or vehicles written here as [[train.vehicle]].",
    fields: &[
        Field::new(
            "name",
            Kind::Text,
            "a train of the library (paper-short, paper-full, paper-short-light), or a name for the train",
            "paper-short",
        )
        .optional("named after its file, or \"train\""),
        Field::new(
            "file",
            Kind::Text,
            "a file beside this one: TOML with [[vehicle]] tables, or CSV with axle_load_t,distance_m",
            "train.toml",
        )
        .optional("the library's, or [[train.vehicle]]"),
        Field::new("vehicle", Kind::Tables(&VEHICLE), "The vehicles, from the first one back.", "")
            .optional("the library's, or those of the file"),
    ],
};

/// A file of vehicles.
pub(crate) static FILE: Section = Section {
    path: "",
    doc: "The vehicles of a train, from the first one back.",
    fields: &[Field::new("vehicle", Kind::Tables(&VEHICLE), "The vehicles, from the first one back.", "")],
};

pub(super) static TRACK: Section = Section {
    path: "track",
    doc: "How an axle load reaches the fill: half of it bears on each rail, a beam on the springs under its sleepers; \
          each sleeper's share spreads through the ballast and presses on the top of the fill.",
    fields: &[
        Field::new(
            "rail_bending_stiffness",
            Kind::Quantity(BendingStiffness),
            "bending stiffness E I of one rail about its horizontal axis",
            "4.47 MNm^2",
        )
        .at_least(1e2)
        .at_most(1e9),
        Field::new(
            "track_modulus",
            Kind::Quantity(Stress),
            "stiffness of the support of one rail, per metre of rail (force per length and settlement)",
            "30 MPa",
        )
        .at_least(1e4)
        .at_most(1e12),
        Field::new("sleeper_spacing", Kind::Quantity(Length), "distance between the middles of two sleepers", "0.60 m")
            .at_least(0.1)
            .at_most(5.0),
        Field::new("sleeper_breadth", Kind::Quantity(Length), "size of a sleeper along the bridge", "0.25 m")
            .at_least(0.01)
            .at_most(5.0),
        Field::new("sleeper_length", Kind::Quantity(Length), "size of a sleeper across the bridge", "2.75 m")
            .at_least(0.1)
            .at_most(10.0),
        Field::new(
            "ballast_depth",
            Kind::Quantity(Length),
            "depth of ballast below the sleepers, down to the top of the fill",
            "0.25 m",
        )
        .at_least(0.0)
        .at_most(20.0),
        Field::new(
            "ballast_slope",
            Kind::Slope,
            "slope at which pressure spreads through the ballast, vertical to horizontal",
            "2:1",
        )
        .positive()
        .at_most(1000.0),
        Field::new(
            "dead_load",
            Kind::Quantity(Stress),
            "weight of rails and sleepers on the fill (and of ballast where no [[cover]] layer is ballast); a part of the self-weight",
            "3 kPa",
        )
        .at_least(0.0)
        .at_most(1e6),
        Field::new("effective_width", Kind::Quantity(Length), "width of the bridge that carries an axle", "4.5 m")
            .at_least(0.1)
            .optional("the width of the barrel"),
    ],
};
