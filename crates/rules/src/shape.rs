//! What files of vehicles and rules may say, key by key: the reader, the schema and the list in `docs/input/vehicles.md` are
//! made from it.

/// A kind of value.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// Text.
    Text,
    /// A number; the key carries its unit.
    Number,
    /// true or false.
    Flag,
    /// One of these words.
    Word(&'static [&'static str]),
    /// A list of text.
    Texts,
    /// A list of these words.
    Words(&'static [&'static str]),
    /// A list of numbers.
    Numbers,
    /// A list of lists of numbers.
    Rows,
    /// A list of distances: numbers, or tables with `from`, `to` and `step`.
    Spacings,
    /// A table.
    Table(&'static Shape),
    /// A list of tables.
    Tables(&'static Shape),
    /// A table whose `kind` says which of these it is.
    Tagged(&'static [(&'static str, &'static Shape)]),
}

/// A key.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// As written.
    pub name: &'static str,
    /// What it holds.
    pub kind: Kind,
    /// Whether it must be there.
    pub required: bool,
    /// What it is.
    pub doc: &'static str,
}

/// A table: its keys.
#[derive(Debug)]
pub struct Shape {
    /// What it is called.
    pub name: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
}

const fn must(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key { name, kind, required: true, doc }
}

const fn may(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key { name, kind, required: false, doc }
}

impl Shape {
    /// The card of a key.
    pub fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }
}

const CONFIDENCES: &[&str] = &["read", "calculated", "recalled", "assumed"];
const WAYS: &[&str] = &["rail", "road"];

static SOURCE: Shape = Shape {
    name: "source",
    keys: &[
        must("text", Kind::Text, "document and clause or table"),
        must("date", Kind::Text, "its year or edition"),
        must("confidence", Kind::Word(CONFIDENCES), "how sure the number is"),
        may("note", Kind::Text, "what else a reader should know"),
    ],
};

static FACTOR: Shape = Shape {
    name: "factor",
    keys: &[
        must("value", Kind::Number, "the factor; 1 is written down like any other"),
        must("source", Kind::Table(&SOURCE), "where it is from"),
    ],
};

static FILL: Shape = Shape {
    name: "fill",
    keys: &[
        must("depth_m", Kind::Number, "depth of fill down to which the share falls linearly from 1 [m]"),
        must("share", Kind::Number, "what is left of the dynamic effect there"),
        must("vanishing_m", Kind::Number, "further depth at which nothing is left [m]"),
        must("source", Kind::Table(&SOURCE), "where it is from"),
    ],
};

static COVER: Shape = Shape {
    name: "cover",
    keys: &[
        must("from_m", Kind::Number, "depth from which on cover lessens the factor [m]"),
        must("per_m", Kind::Number, "what it takes off for every metre below; the factor stays 1 at least"),
        must("source", Kind::Table(&SOURCE), "where it is from"),
    ],
};

const KIND: &str = "which form";

static AUGMENT: Shape = Shape {
    name: "augment",
    keys: &[
        must("kind", Kind::Word(&["augment"]), KIND),
        must("base", Kind::Number, "coefficient base + numerator_m / (addend_m + L) over the loaded span L"),
        must("numerator_m", Kind::Number, "see base [m]"),
        must("addend_m", Kind::Number, "see base [m]"),
        must("most", Kind::Number, "largest coefficient"),
        may("fill", Kind::Table(&FILL), "how fill lessens it"),
        must("source", Kind::Table(&SOURCE), "where it is from"),
    ],
};

static ALL_AXLES: Shape = Shape {
    name: "all-axles",
    keys: &[
        must("kind", Kind::Word(&["all-axles"]), KIND),
        must("factor", Kind::Table(&FACTOR), "factor on every axle"),
        may("fill", Kind::Table(&FILL), "how fill lessens what it adds"),
    ],
};

static CRITICAL: Shape = Shape {
    name: "critical-axle",
    keys: &[
        must("kind", Kind::Word(&["critical-axle"]), KIND),
        must("factor", Kind::Table(&FACTOR), "factor on the one axle where it harms most; 1 on the others"),
    ],
};

static ROOT: Shape = Shape {
    name: "root",
    keys: &[
        must("kind", Kind::Word(&["root"]), KIND),
        must(
            "numerator",
            Kind::Number,
            "factor numerator / (sqrt(share L) - subtrahend) + constant over the loaded span L",
        ),
        must("subtrahend", Kind::Number, "see numerator"),
        must("constant", Kind::Number, "see numerator"),
        must("share", Kind::Number, "determinant length over the span"),
        must("least", Kind::Number, "smallest factor"),
        must("most", Kind::Number, "largest factor"),
        may("cover", Kind::Table(&COVER), "how cover lessens it"),
        must("source", Kind::Table(&SOURCE), "where it is from"),
    ],
};

static INCLUDED: Shape = Shape {
    name: "included",
    keys: &[
        must("kind", Kind::Word(&["included"]), KIND),
        must("source", Kind::Table(&SOURCE), "where it is said that the loads contain what motion adds"),
    ],
};

const IMPACT: Kind = Kind::Tagged(&[
    ("included", &INCLUDED),
    ("all-axles", &ALL_AXLES),
    ("critical-axle", &CRITICAL),
    ("augment", &AUGMENT),
    ("root", &ROOT),
]);

const ON_UNIFORM: &str = "whether motion adds to uniform loads as well; true where it is not written";
const PRESENCE: &str = "factors of multiple presence with one lane loaded, two, three; 1 where they are not written";

static UNIFORM: Shape = Shape {
    name: "uniform",
    keys: &[
        must("load_kn_per_m", Kind::Number, "load along the bridge [kN/m]"),
        must("place", Kind::Word(&["ahead", "behind", "everywhere", "part"]), "where it stands"),
        may(
            "gap_m",
            Kind::Number,
            "from the outermost axle to where it begins [m]; for a part from the first axle, or the front where there is no axle, back",
        ),
        may("length_m", Kind::Number, "length of a part [m]; for `place = \"part\"` alone, and needed there"),
        must("may_be_dropped", Kind::Flag, "whether it may be left out where it helps"),
        may(
            "width_m",
            Kind::Number,
            "width over which it stands across the bridge [m]; as an axle where it is not written",
        ),
    ],
};

static VEHICLE: Shape = Shape {
    name: "vehicle",
    keys: &[
        must("code", Kind::Text, "its name in bridge files"),
        must("title", Kind::Text, "its name in reports"),
        may("grade", Kind::Text, "the grade of a bridge that carries it, where the file has `grades`"),
        must(
            "axle_loads_kn",
            Kind::Numbers,
            "load of each axle, from the first one back [kN]; [] where the vehicle is uniform loads alone",
        ),
        must(
            "spacings_m",
            Kind::Spacings,
            "distances between neighbouring axles, one fewer than axles [m]; a range is { from, to, step }",
        ),
        may("lift_off", Kind::Rows, "factors on the axles where some lift off, one list a case"),
        may("uniform", Kind::Tables(&UNIFORM), "uniform loads that belong to it"),
        must("axles_may_be_dropped", Kind::Flag, "whether axles that help may be left out"),
        must("wheel_track_m", Kind::Number, "distance between the wheels of an axle across the bridge [m]"),
        must("contact_length_m", Kind::Number, "length of a wheel's or sleeper's footprint along the bridge [m]"),
        may("lanes", Kind::Number, "how many lanes it occupies; 1 where not written"),
        may(
            "with",
            Kind::Texts,
            "codes of vehicles that belong to the same level of loading: a bridge that carries this one carries all of them",
        ),
        may("source", Kind::Table(&SOURCE), "where it is from, if not from where the file is"),
    ],
};

static PUBLISHED: Shape = Shape {
    name: "published",
    keys: &[
        must("vehicle", Kind::Text, "code of the vehicle that the table is compared with"),
        must(
            "quantity",
            Kind::Word(&["eudl-bending", "eudl-shear", "bending", "shear", "dynamic-augment"]),
            "what the numbers are",
        ),
        must("with_uniform", Kind::Flag, "whether the vehicle's uniform loads take part"),
        must("spans_m", Kind::Numbers, "spans [m]"),
        must("values", Kind::Numbers, "the numbers: kN, kN m or none"),
        must("tolerance", Kind::Number, "how far the vehicle may be from them, relative"),
        may("above", Kind::Number, "how far above them it may be, where it covers them"),
        may(
            "section",
            Kind::Number,
            "where moments are compared, as a share of the span; at the worst section where it is not written",
        ),
        must("reason", Kind::Text, "why this tolerance"),
        may(
            "not_from_vehicle",
            Kind::Text,
            "why the vehicle alone does not give them; they are then read and not compared",
        ),
        must("source", Kind::Table(&SOURCE), "where they are from"),
    ],
};

static SPAN_LIMIT: Shape = Shape {
    name: "span_limit",
    keys: &[
        must("longest_m", Kind::Number, "longest span that the model may be used for [m]"),
        must("reason", Kind::Text, "why not longer ones"),
        must("source", Kind::Table(&SOURCE), "where that is from"),
    ],
};

static UNDER: Shape = Shape {
    name: "under",
    keys: &[
        must("rule", Kind::Text, "code of a rule that does not name this model"),
        must("live_load", Kind::Table(&FACTOR), "factor on its loads under that rule"),
        must("impact", IMPACT, "what motion adds to them"),
        may("impact_on_uniform", Kind::Flag, ON_UNIFORM),
        may("presence", Kind::Numbers, PRESENCE),
    ],
};

/// A file of vehicles.
pub static LOAD_MODEL: Shape = Shape {
    name: "a file of vehicles",
    keys: &[
        must("code", Kind::Text, "name of the load model in bridge files"),
        must("title", Kind::Text, "its name in reports"),
        must("ways", Kind::Word(WAYS), "on what it drives"),
        must("source", Kind::Table(&SOURCE), "where it is from"),
        may(
            "abreast",
            Kind::Numbers,
            "shares of its axle loads in the first lane, the second and so on; all whole where not written",
        ),
        may("grades", Kind::Text, "what its vehicles are grades of, where they are, from the lightest up"),
        may("span_limit", Kind::Table(&SPAN_LIMIT), "the longest span that it may be used for"),
        may(
            "only_by_name",
            Kind::Flag,
            "whether its vehicles are taken only where they are named, and not among all that a rule is made for; false where not written",
        ),
        must("vehicle", Kind::Tables(&VEHICLE), "its vehicles"),
        may(
            "checked",
            Kind::Tables(&PUBLISHED),
            "numbers worked out by hand that it is compared with; those that somebody published stand in `published`",
        ),
        may("under", Kind::Tables(&UNDER), "factors under rules that do not name it"),
        may("left_out", Kind::Texts, "what the loading has and these vehicles leave out: a verdict names it"),
        may(
            "loading",
            Kind::Text,
            "the loading whose cases its vehicles are, where a bridge must carry all of them; models with the same name belong together",
        ),
        may("published", Kind::Tables(&PUBLISHED), "numbers that it is compared with"),
    ],
};

static DISPERSAL: Shape = Shape {
    name: "dispersal",
    keys: &[
        must("length_base_m", Kind::Number, "length along the bridge at the surface [m]"),
        must("length_per_depth", Kind::Number, "its growth with depth, both sides together"),
        must(
            "width_base_m",
            Kind::Number,
            "added to the distance of the wheels at the surface [m]; with strip_at_most_m the strip of one rail",
        ),
        must("width_per_depth", Kind::Number, "its growth with depth, both sides together"),
        may(
            "strip_at_most_m",
            Kind::Number,
            "widths are those of one rail's or wheel line's strip, each at most so wide [m]",
        ),
        may(
            "least_depth_m",
            Kind::Number,
            "depth of cover at the crown from which on loads spread through it; above a shallower one they do not [m]",
        ),
        must(
            "pressure",
            Kind::Word(&["uniform", "inverse-depth", "boussinesq"]),
            "how it is shared out over the length",
        ),
        must("source", Kind::Table(&SOURCE), "where it is from"),
    ],
};

static DISPERSED: Shape = Shape {
    name: "dispersed",
    keys: &[
        must("kind", Kind::Word(&["dispersed"]), KIND),
        must("source", Kind::Table(&SOURCE), "as wide as the load has spread at the crown: where that is from"),
    ],
};

static BARREL: Shape = Shape {
    name: "barrel",
    keys: &[
        must("kind", Kind::Word(&["barrel"]), KIND),
        must("source", Kind::Table(&SOURCE), "the whole barrel: where that is from"),
    ],
};

static FIXED: Shape = Shape {
    name: "fixed",
    keys: &[
        must("kind", Kind::Word(&["fixed"]), KIND),
        must("width_m", Kind::Number, "width that carries an axle, at most the barrel [m]"),
        must("source", Kind::Table(&SOURCE), "where it is from"),
    ],
};

static LOADS: Shape = Shape {
    name: "loads",
    keys: &[
        must("models", Kind::Texts, "codes of load models that the rule is made for"),
        may("live_load", Kind::Table(&FACTOR), "factor on their loads; that of [factors] where it is not written"),
        must("impact", IMPACT, "what motion adds to them"),
        may("impact_on_uniform", Kind::Flag, ON_UNIFORM),
        may("presence", Kind::Numbers, PRESENCE),
        may("overload", Kind::Table(&OVERLOAD), "how much heavier than their nominal loads axles may be"),
        may("beside", Kind::Table(&BESIDE), "what stands in the lanes beside a vehicle of these models"),
        may(
            "left_out",
            Kind::Texts,
            "what the rule asks of these loads and the program leaves out: a verdict names it",
        ),
    ],
};

static OVERLOAD: Shape = Shape {
    name: "overload",
    keys: &[
        must("critical", Kind::Number, "factor on the axle where it harms most"),
        must("others", Kind::Number, "factor on every other axle"),
        must("source", Kind::Table(&SOURCE), "where both are from"),
    ],
};

static BESIDE: Shape = Shape {
    name: "beside",
    keys: &[
        must(
            "vehicles",
            Kind::Texts,
            "codes of load models or vehicles, the worst of which stands there with the rule's factors on it",
        ),
        must("share", Kind::Number, "share of their factored loads"),
        must("source", Kind::Table(&SOURCE), "where that is from"),
    ],
};

static REQUIREMENT: Shape = Shape {
    name: "requires",
    keys: &[
        must(
            "what",
            Kind::Word(&["braking", "strength", "dispersal", "skew"]),
            "what must be given before a bridge is adequate by the rule",
        ),
        must("source", Kind::Table(&SOURCE), "where the rule asks for it"),
    ],
};

static FACTORS: Shape = Shape {
    name: "factors",
    keys: &[
        must("masonry_weight", Kind::Table(&FACTOR), "on the weight of masonry where it is adverse"),
        must("fill_weight", Kind::Table(&FACTOR), "on the weight of fill, backing and sub-base where it is adverse"),
        must("surfacing_weight", Kind::Table(&FACTOR), "on the weight of surfacing and ballast where it is adverse"),
        must("weight_favourable", Kind::Table(&FACTOR), "on any weight where it helps"),
        must("live_load", Kind::Table(&FACTOR), "on live loads"),
        must("masonry_strength", Kind::Table(&FACTOR), "on the strength of masonry: it divides"),
        must("friction", Kind::Table(&FACTOR), "on the friction of joints: it divides"),
        may(
            "cohesion",
            Kind::Table(&FACTOR),
            "on cohesion and tensile strength of joints: it divides; as masonry_strength where not written",
        ),
        must("fill_pressure", Kind::Table(&FACTOR), "on the fill's horizontal pressure: it divides"),
        must("model", Kind::Table(&FACTOR), "for the method of analysis: it divides the capacity"),
        must("condition", Kind::Table(&FACTOR), "for the condition of the bridge: it multiplies the capacity"),
    ],
};

/// A file of a rule.
pub static RULE: Shape = Shape {
    name: "a file of a rule",
    keys: &[
        must("code", Kind::Text, "name of the rule"),
        must("title", Kind::Text, "its name in reports"),
        must("ways", Kind::Words(WAYS), "for what it is made"),
        must("source", Kind::Table(&SOURCE), "where it is from"),
        must("dispersal", Kind::Table(&DISPERSAL), "how loads spread"),
        must(
            "effective_width",
            Kind::Tagged(&[("dispersed", &DISPERSED), ("barrel", &BARREL), ("fixed", &FIXED)]),
            "which width of the barrel carries an axle",
        ),
        may(
            "impact",
            IMPACT,
            "what motion adds to loads of models that [[loads]] does not name; without it they are refused",
        ),
        may("loads", Kind::Tables(&LOADS), "load models that the rule is made for, with the factors of each"),
        must("factors", Kind::Table(&FACTORS), "partial factors"),
        may(
            "based_on",
            Kind::Text,
            "code of the rule of the library that it builds on: factors that differ from it stand beside a verdict; the nearest rule where not written",
        ),
        may("requires", Kind::Tables(&REQUIREMENT), "what must be given before a bridge is adequate by the rule"),
    ],
};
