//! Cards of spandrel walls.

use super::{Field, Kind, Section, Word};
use crate::quantity::Dimension::{Density, Length};

const BONDS: &[Word] = &[
    Word { word: "half", doc: "every other course is shifted by half a brick" },
    Word { word: "third", doc: "every other course is shifted by a third of a brick" },
    Word { word: "stack", doc: "head joints are above one another" },
];

const STARTS: &[Word] = &[
    Word { word: "top", doc: "from the wall's top down: the uppermost course is whole" },
    Word { word: "springings", doc: "from the level of the springings up: the uppermost course takes what is left" },
];

pub(super) static SPANDREL_WALL: Section = Section {
    path: "spandrel_wall",
    doc: "Spandrel walls of coursed masonry that stand on the rings. Bricks are cut along the backs of the voussoirs; all \
          walls of the bridge are taken together.",
    fields: &[
        Field::new("brick_length", Kind::Quantity(Length), "length of a brick with its joint", "0.60 m").positive(),
        Field::new("brick_height", Kind::Quantity(Length), "height of a course with its joint", "0.40 m").positive(),
        Field::new("thickness", Kind::Quantity(Length), "thickness of all walls together across the bridge", "0.44 m")
            .positive(),
        Field::new("bond", Kind::Word(BONDS), "how courses are shifted", "half").default("half"),
        Field::new("density", Kind::Quantity(Density), "mass density of the wall", "2100 kg/m^3")
            .positive()
            .optional("as [masonry] says"),
        Field::new("rounding", Kind::Quantity(Length), "radius of the bricks' rounded corners", "10 mm")
            .at_least(0.0)
            .optional("as [masonry] says"),
        Field::new(
            "top",
            Kind::Quantity(Length),
            "level of the wall's top above the highest crown's extrados",
            "0.478 m",
        )
        .positive()
        .optional("the road surface"),
        Field::new(
            "extent",
            Kind::Quantity(Length),
            "how far the wall reaches behind the outer springings, measured at the extrados",
            "1.5 m",
        )
        .positive()
        .optional("to the backs of the abutments"),
        Field::new("end_walls", Kind::Flag, "whether fixed walls stand at both ends", "false").default("false"),
        Field::new("courses_from", Kind::Word(STARTS), "where courses are counted from", "top").default("top"),
        Field::new(
            "head_joint",
            Kind::Quantity(Length),
            "place of a head joint of the uppermost course, from the left springing of the first span",
            "9.15 m",
        )
        .optional("the middle of the bridge"),
        Field::new(
            "loaded_bricks",
            Kind::Count,
            "how many bricks of the uppermost course carry a load, those nearest to its middle",
            "2",
        )
        .at_least(1.0)
        .at_most(100.0)
        .optional("the bricks under the load, each by its loaded length"),
        Field::new(
            "least_piece",
            Kind::Number,
            "share of a brick or a voussoir's back below which no piece of a cut brick is left",
            "0.25",
        )
        .at_least(0.05)
        .at_most(0.5)
        .default("0.25"),
    ],
};
