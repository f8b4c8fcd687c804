//! Cards of the structure: bridge, spans, rings, piers, abutments.

use super::{Field, Kind, Section, Word};
use crate::quantity::Dimension::{Acceleration, Length};

pub(super) static BRIDGE: Section = Section {
    path: "bridge",
    doc: "The bridge as a whole.",
    fields: &[
        Field::new("name", Kind::Text, "name of the bridge, for titles", "Bridgemill"),
        Field::new("width", Kind::Quantity(Length), "width of the barrel, which carries the loads", "8.30 m")
            .positive()
            .at_most(100.0),
        Field::new("gravity", Kind::Quantity(Acceleration), "acceleration of gravity", "9.81 m/s^2")
            .positive()
            .at_most(30.0)
            .default("9.81 m/s^2"),
    ],
};

pub(super) const PROFILES: &[Word] = &[
    Word { word: "segmental", doc: "one circular arc, rise at most half the span" },
    Word { word: "semicircular", doc: "half a circle, rise half the span" },
    Word { word: "parabolic", doc: "a parabola with its vertex in the crown" },
    Word { word: "elliptical", doc: "half an ellipse, vertical at the springings" },
    Word { word: "three-centred", doc: "two small circles at the haunches, a large one at the crown" },
    Word { word: "pointed", doc: "two circular arcs centred on the springing line that meet in the crown" },
    Word { word: "measured", doc: "a smooth curve through surveyed points" },
];

pub(super) static SPAN: Section = Section {
    path: "span",
    doc: "One span. Span and rise are always measured at the intrados.",
    fields: &[
        Field::new("profile", Kind::Word(PROFILES), "shape of the intrados", "segmental"),
        Field::new(
            "span",
            Kind::Quantity(Length),
            "horizontal distance between the springings, at the intrados",
            "18.30 m",
        )
        .positive()
        .at_most(500.0)
        .only("profile", &["segmental", "semicircular", "parabolic", "elliptical", "three-centred", "pointed"]),
        Field::new(
            "rise",
            Kind::Quantity(Length),
            "rise is measured from springing to crown, on the intrados",
            "2.85 m",
        )
        .positive()
        .at_most(500.0)
        .only("profile", &["segmental", "parabolic", "elliptical", "three-centred", "pointed"]),
        Field::new("haunch_radius", Kind::Quantity(Length), "radius of the two circles at the haunches", "2.0 m")
            .positive()
            .only("profile", &["three-centred"]),
        Field::new(
            "points",
            Kind::Points,
            "surveyed points of the intrados, from the left to the right springing; the first is the origin",
            "[[\"0 m\", \"0 m\"], [\"2.0 m\", \"1.1 m\"], [\"4.0 m\", \"0 m\"]]",
        )
        .only("profile", &["measured"]),
        Field::new("thickness", Kind::Quantity(Length), "thickness of the ring, constant", "0.711 m")
            .positive()
            .at_most(50.0)
            .optional("given by `crown_thickness` and `springing_thickness`, or by [[span.ring]]"),
        Field::new("crown_thickness", Kind::Quantity(Length), "thickness of the ring at the crown", "0.60 m")
            .positive()
            .at_most(50.0)
            .optional("given by `thickness`, or by [[span.ring]]"),
        Field::new(
            "springing_thickness",
            Kind::Quantity(Length),
            "thickness of the ring at the springings; linear in arc length to the crown",
            "0.80 m",
        )
        .positive()
        .at_most(50.0)
        .optional("given by `thickness`, or by [[span.ring]]"),
        Field::new("voussoirs", Kind::Count, "number of voussoirs of the ring, equal in length", "62")
            .at_least(3.0)
            .at_most(5000.0)
            .optional("given by [[span.ring]]"),
        Field::new("ring", Kind::Tables(&RING), "Several rings of one span, from the intrados up.", "")
            .optional("one ring, described in the span itself"),
        Field::new("repeat", Kind::Count, "how many spans like this follow one another", "3")
            .at_least(1.0)
            .at_most(1000.0)
            .default("1"),
    ],
};

pub(super) static RING: Section = Section {
    path: "span.ring",
    doc: "One ring of a span with several, from the intrados up.",
    fields: &[
        Field::new("thickness", Kind::Quantity(Length), "thickness of the ring, constant", "0.225 m")
            .positive()
            .at_most(50.0)
            .optional("given by `crown_thickness` and `springing_thickness`"),
        Field::new("crown_thickness", Kind::Quantity(Length), "thickness of the ring at the crown", "0.225 m")
            .positive()
            .at_most(50.0)
            .optional("given by `thickness`"),
        Field::new(
            "springing_thickness",
            Kind::Quantity(Length),
            "thickness of the ring at the springings; linear in arc length to the crown",
            "0.338 m",
        )
        .positive()
        .at_most(50.0)
        .optional("given by `thickness`"),
        Field::new("voussoirs", Kind::Count, "number of voussoirs of the ring, equal in length", "40")
            .at_least(3.0)
            .at_most(5000.0),
    ],
};

pub(super) static PIER: Section = Section {
    path: "pier",
    doc: "A pier between two spans.",
    fields: &[
        Field::new(
            "width",
            Kind::Quantity(Length),
            "width at the top, between the springings of its two spans",
            "1.20 m",
        )
        .positive(),
        Field::new("base_width", Kind::Quantity(Length), "width at the foundation", "1.60 m")
            .positive()
            .optional("as wide as the top"),
        Field::new("height", Kind::Quantity(Length), "height from the foundation to the springings", "4.0 m")
            .positive(),
        Field::new("courses", Kind::Count, "number of courses of blocks", "8").at_least(1.0).at_most(1000.0),
    ],
};

pub(super) static ABUTMENT: Section = Section {
    path: "abutment",
    doc: "Both abutments: fixed blocks that hold the outer springings. Their size is used for drawings and limits what \
          can rest on them.",
    fields: &[
        Field::new("top_width", Kind::Quantity(Length), "length of the upper face behind the springing", "2.0 m")
            .positive()
            .default("2 m"),
        Field::new("height", Kind::Quantity(Length), "height of the fixed block as drawn", "2.0 m")
            .positive()
            .default("2 m"),
        Field::new("left", Kind::Table(&ABUTMENT_LEFT), "Where the left abutment differs.", "")
            .optional("like the other"),
        Field::new("right", Kind::Table(&ABUTMENT_RIGHT), "Where the right abutment differs.", "")
            .optional("like the other"),
    ],
};

const SIDE: &[Field] = &[
    Field::new("top_width", Kind::Quantity(Length), "length of the upper face behind the springing", "2.0 m")
        .positive()
        .optional("as [abutment] says"),
    Field::new("height", Kind::Quantity(Length), "height of the fixed block as drawn", "2.0 m")
        .positive()
        .optional("as [abutment] says"),
];

static ABUTMENT_LEFT: Section =
    Section { path: "abutment.left", doc: "The left abutment, where it differs.", fields: SIDE };
static ABUTMENT_RIGHT: Section =
    Section { path: "abutment.right", doc: "The right abutment, where it differs.", fields: SIDE };
