//! What a survey is asked.

/// A number that a survey finds.
#[derive(Debug, Clone, Copy)]
pub struct Question {
    /// Its name.
    pub key: &'static str,
    /// What is measured, in a line.
    pub doc: &'static str,
    /// Unit in which a bare number is taken; empty for counts.
    pub unit: &'static str,
    /// A value to begin with, as text.
    pub example: &'static str,
    /// What is assumed where the sheet says nothing; empty where it must.
    pub assumed: &'static str,
    /// What is usual, in words to follow "usually"; empty where nothing is known. The reader of files asks about what lies well outside.
    pub usual: &'static str,
}

const fn question(key: &'static str, doc: &'static str, unit: &'static str, example: &'static str) -> Question {
    Question { key, doc, unit, example, assumed: "", usual: "" }
}

impl Question {
    const fn usual(mut self, words: &'static str) -> Question {
        self.usual = words;
        self
    }

    const fn assumed(mut self, value: &'static str) -> Question {
        self.assumed = value;
        self
    }
}

/// The ten numbers. The first three are those of a span: a further one has its own as `span_2`, `rise_2`, `thickness_2`, or those of the first.
pub const QUESTIONS: [Question; 10] = [
    question("span", "Clear span between the springings, at the intrados, along the road.", "m", "6.00 m"),
    question("rise", "Rise of the crown's intrados above the springings.", "m", "1.50 m")
        .usual("1/12 to 1/2 of the span"),
    question("thickness", "Thickness of the ring, of all rings together where there are several.", "m", "0.45 m")
        .usual("1/40 to 1/10 of the span"),
    question("width", "Width of the barrel that carries the road, between the parapets.", "m", "5.00 m")
        .usual("1 m to 40 m"),
    question("cover", "Depth of fill and surfacing over the crown, from its extrados to the road.", "m", "0.50 m")
        .usual("at most 3 m"),
    question("unit", "Length of a stone or brick along the ring.", "m", "0.30 m")
        .assumed("0.30 m")
        .usual("so short that seven or more make a ring"),
    question("backing", "Height of solid backing above the springings; 0 where there is none.", "m", "0 m")
        .assumed("0 m"),
    question("density", "Density of the masonry, or its weight per volume.", "kg/m^3", "2200 kg/m^3")
        .assumed("2200 kg/m^3")
        .usual("1500 kg/m^3 to 3000 kg/m^3"),
    question("strength", "Compressive strength of the masonry.", "MPa", "5 MPa")
        .assumed("5 MPa")
        .usual("0.5 MPa to 400 MPa"),
    question("axle", "Force of the axle whose multiple is sought, or the mass on it.", "kN", "100 kN")
        .assumed("100 kN")
        .usual("10 kN to 450 kN"),
];

/// How many spans stand in a row: the only question that is about the whole of a viaduct.
pub const SPANS: Question = question("spans", "Arches in a row; one where nothing is written.", "", "1").assumed("1");

/// What several spans need of their piers; a further one has its own as `pier_width_2`, `pier_height_2`, or those of the first. Nothing is
/// assumed of the first: who sees the bridge sees its piers, and a stout or short pier that is not there would flatter it.
pub const PIER: [Question; 2] = [
    question("pier_width", "Width of a pier along the road, at its top.", "m", "1.50 m"),
    question("pier_height", "Height of a pier, from the springings down to the ground that carries it.", "m", "4.00 m")
        .usual("1 to 12 times its width"),
];

/// What a survey may know beside the ten.
pub const MORE: [Question; 5] = [
    question("rings", "Rings of the arch one above the other, which share its thickness.", "", "1").assumed("1").usual("1 to 8"),
    question(
        "bond",
        "Cohesion between the rings, where headers or sound mortar tie them. The load that leads is that of rings that only rub on one another; what the bond would add stands beside it.",
        "kPa",
        "0 kPa",
    )
    .assumed("0 kPa")
    .usual("0 kPa to 2000 kPa"),
    question("fill_density", "Density of fill and surfacing, or their weight per volume.", "kg/m^3", "1900 kg/m^3")
        .assumed("1900 kg/m^3")
        .usual("1000 kg/m^3 to 2700 kg/m^3"),
    question("skew", "Angle of skew, between the road and the normal of the springings; 0 for a square bridge.", "deg", "0 deg")
        .usual("0 deg to 10 deg"),
    question("lost_mortar", "Depth of the joints without mortar, at the intrados; 0 where they are pointed.", "mm", "20 mm")
        .assumed("0 mm"),
];

/// What a table may say beyond that, as other programs have it; the file has no line of what it does not say, or the value that it assumes anyway.
pub(super) const OTHERS: [Question; 7] = [
    question("voussoirs", "Stones or bricks of a ring, in place of their length.", "", "40"),
    question("surfacing", "Depth of surfacing or ballast above the fill, at the crown.", "m", "0.10 m"),
    question(
        "surfacing_density",
        "Density of the surfacing or ballast, or its weight per volume.",
        "kg/m^3",
        "2300 kg/m^3",
    )
    .assumed("2300 kg/m^3"),
    question("backing_density", "Density of the backing, or its weight per volume.", "kg/m^3", "2200 kg/m^3"),
    question("friction", "Angle of friction in the joints of a ring.", "deg", "30 deg"),
    question("ring_friction", "Angle of friction between rings.", "deg", "30 deg").assumed("30 deg"),
    question("fill_friction", "Angle of friction of the fill, which then presses on the ring's back.", "deg", "30 deg"),
];

/// Cohesion of the fill, where it has an angle of friction.
pub(super) const FILL_COHESION: Question =
    question("fill_cohesion", "Cohesion of the fill.", "kPa", "0 kPa").assumed("0 kPa");

/// What is answered in words: number of the structure, material of the fill, what an inspection found. Each with what is asked.
pub const WORDS: [(&str, &str); 3] = [
    ("reference", "Number of the structure in the owner's list; it stands in the report."),
    ("fill", "Material of the library that fills the haunches; its usual density stands for one that nobody measured."),
    (
        "condition",
        "What the inspection found of the barrel, in words; it stands in the report, and no analysis reads it.",
    ),
];
