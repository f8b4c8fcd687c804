//! Loads and vehicles that move, and the width that they share.

use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::tree::Table;
use crate::values::{bare_words, of_keys};

of_keys! {
    /// Vehicles that are moved over the bridge by limit analysis.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SweepPlan {
        pub braking: f64 = number(
            "braking and traction: force along the bridge as a share of every axle and uniform load, tried to the right, to the left and not at all",
            "0.25",
        )
        .between(0.0, 1.0)
        .default("0"),
        pub braking_reason: Option<String> = text(
            "why braking has this share; a rule that asks for braking gives no verdict where it is less than 0.15 without a reason",
            "ballasted track runs 40 m beyond both abutments",
        )
        .optional("no reason"),
        pub rule: String = text("rule of the library: factors, dispersal, impact", "cs-454")
            .optional(
                "\"characteristic\": no safety factors, for comparisons, never for a verdict; or given by `rule_file`",
            ) => rule,
        pub rule_file: Option<String> =
            text("file with a rule, relative to the bridge file", "our-rule.toml").optional("a rule of the library"),
        pub condition_factor: Option<f64> = number(
            "condition of the barrel as its inspector judges it (F_cM of CS 454): what is carried counts so many times, in place of the rule's factor",
            "0.85",
        )
        .between(0.05, 1.0)
        .optional("the rule's: mostly 1, to be confirmed"),
        /// Here without quotes.
        pub vehicles: Vec<String> = values(
            "codes of vehicles, load models or trains of the library, or of `vehicle_files`",
            "[\"hb-45\", \"cs-454\"]",
        )
        .optional("all of the library, and of `vehicle_files`") => bare_words,
        pub vehicle_files: Vec<String> =
            values("files with vehicles, relative to the bridge file", "[\"our-crane.toml\"]")
                .optional("none") => bare_words,
        pub step: Option<f64> = length("distance between positions", "0.25 m")
            .at_least(LEAST_STEP)
            .optional("a sixtieth of the shortest span, a thirtieth where a span has several rings; the worst position between steps is then found"),
        pub directions: Directions =
            word::<Directions>("directions in which vehicles travel", "both").default(Directions::Both.word()),
        pub subsets: bool = flag("whether every group of neighbouring axles is tried", "true").default("true"),
        /// Here whether they spread by the file's [dispersal] in place of the rule's.
        pub own_dispersal ("dispersal"): bool =
            word::<Spread>("how axles spread through the cover", "rule").default(Spread::Rule.word()) => by_the_file,
        pub discrete_elements: bool =
            flag("whether the governing case is also analysed by discrete elements; the smaller number counts", "true")
                .default("false") => discrete_elements,
    } and {
        /// Whether the file writes that share, be it 0.
        pub braking_given: bool => braking_given,
        /// Names and texts of the files, the rule's first; empty until somebody reads them.
        pub texts: Vec<(String, String)> => no_texts,
    }
}

choice! {
    /// How axles spread through the cover.
    enum Spread {
        /// as in the rule, with the rule's footprint
        Rule = "rule",
        /// as in [dispersal], with each vehicle's footprint
        File = "file",
    }
}

/// The rule where the file names none.
const USUAL_RULE: &str = "characteristic";

/// The rule of the library that the file names; the usual one where it names none.
fn rule(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<String> {
    Some(table.read::<Option<String>>(key, findings)?.unwrap_or_else(|| USUAL_RULE.to_owned()))
}

fn by_the_file(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<bool> {
    Some(match table.read(key, findings)? {
        Spread::Rule => false,
        Spread::File => true,
    })
}

/// The key, or its former name.
fn discrete_elements(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<bool> {
    let [own, former] = [key, "confirm"].map(|key| table.read(key, findings));
    if table.has(key) { own } else { former }
}

fn braking_given(table: &Table<'_>, _: &mut Findings) -> Option<bool> {
    Some(table.has("braking"))
}

fn no_texts(_: &Table<'_>, _: &mut Findings) -> Option<Vec<(String, String)>> {
    Some(Vec::new())
}

of_keys! {
    /// Where vehicles may stand across the bridge, and what divides its barrel.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct Carriageway {
        pub lanes: Option<usize> =
            count("how many vehicles may stand abreast: lanes of a road, tracks of a railway", "2")
                .between(1.0, 20.0)
                .optional("road: two where two of 2.5 m fit on the barrel, else one; railway: one"),
        pub lane_width: Option<f64> = length("distance between the middles of two vehicles abreast", "2.5 m")
            .positive()
            .optional("2.5 m on roads, 3.4 m on railways"),
        pub edge_distance: Option<f64> =
            length("distance from an edge of the barrel to the middle of the nearest wheel or rail", "0.8 m")
                .at_least(0.0)
                .optional("vehicles stand in the middle of the barrel"),
        pub skew: Option<f64> = angle("angle of skew of spans without their own: 0 for a square bridge", "15 deg")
            .between(0.0, 1.31)
            .optional("taken as square; the model is square in any case"),
        pub cracks: Vec<f64> =
            lengths("longitudinal cracks through the barrel: their distances from one of its edges", "[\"0.75 m\"]")
                .positive()
                .optional("the barrel carries as a whole"),
    } and {
        /// What moves the resultant of a vehicle sideways.
        pub sideways: Sideways => sideways,
    }
}

/// What moves the resultant of a vehicle away from the middle between its wheels or rails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sideways {
    /// Radius of the curve and speed on it [m, m/s].
    pub curve: Option<(f64, f64)>,
    /// Level of the outer rail above the inner one [m].
    pub cant: f64,
    /// Force across the bridge as a share of the weight, to either side.
    pub side_force: f64,
    /// Height above the rail or the road at which both act [m].
    pub height: f64,
    /// Distance between the middles of both rails, or of the wheels on an axle [m].
    pub gauge: f64,
}

impl Default for Sideways {
    fn default() -> Sideways {
        Sideways { curve: None, cant: 0.0, side_force: 0.0, height: GRAVITY_HEIGHT, gauge: GAUGE }
    }
}

/// Least distance between places of a sweep [m]: closer ones tell nothing more, and a slip in the unit would take days.
pub const LEAST_STEP: f64 = 1e-3;

/// Height of a vehicle's centre of gravity above the rail [m], where the file gives none.
pub const GRAVITY_HEIGHT: f64 = 1.8;
/// Distance between the middles of both rails [m], where the file gives none.
pub const GAUGE: f64 = 1.5;

impl Sideways {
    /// Largest distance of the resultant from the middle between the rails [m], and whether it is that of a vehicle that moves: with speed v on
    /// radius r, cant c, gauge s and side force w at height h it is h (|v^2 / (g r) - c / s| + w); standing, h (c / s + w).
    pub fn eccentricity(&self, gravity: f64) -> (f64, bool) {
        let outwards = self.curve.map_or(0.0, |(radius, speed)| speed * speed / (gravity * radius));
        let inwards = self.cant / self.gauge;
        let [moving, standing] =
            [(outwards - inwards).abs(), inwards].map(|share| self.height * (share + self.side_force));
        if moving > standing { (moving, true) } else { (standing, false) }
    }
}

/// What moves the resultant of vehicles sideways; it stays between the rails.
fn sideways(table: &Table<'_>, findings: &mut Findings) -> Option<Sideways> {
    let radius: Option<Option<f64>> = table.read("curve_radius", findings);
    let speed: Option<Option<f64>> = table.read("speed", findings);
    let mut or = |key, usual: f64| {
        let given: Option<Option<f64>> = table.read(key, findings);
        given.map(|given| given.unwrap_or(usual))
    };
    let gauge = or("track_gauge", GAUGE);
    let (cant, side_force) = (or("cant", 0.0), or("side_force", 0.0));
    let height = or("side_force_height", GRAVITY_HEIGHT);
    let (radius, speed) = (radius?, speed?);
    if radius.is_some() && speed.is_none() {
        return table.need("speed", findings);
    }
    if speed.is_some() && radius.is_none() {
        return table.need("curve_radius", findings);
    }
    let (cant, gauge) = (cant?, gauge?);
    let found = Sideways { curve: radius.zip(speed), cant, side_force: side_force?, height: height?, gauge };
    let (shift, moving) = found.eccentricity(GRAVITY);
    if shift >= 0.5 * gauge {
        let key = match (moving, found.curve) {
            (true, Some(_)) => "speed",
            _ if found.cant > 0.0 => "cant",
            _ => "side_force",
        };
        return findings.refuse(
            "B242",
            table.place(key),
            format!("the resultant of a vehicle lies {shift:.2} m beside the middle of its track"),
            format!("beyond {:.2} m, half of `track_gauge`, it overturns", 0.5 * gauge),
            "check radius, speed, cant and side force, and the height at which they act",
        );
    }
    Some(found)
}

/// Gravity of the check that a vehicle does not overturn [m/s^2].
const GRAVITY: f64 = 9.81;

/// The strips that longitudinal cracks leave of a barrel so wide, from one edge to the other [m]; cracks from the least distance on.
pub fn strips(width: f64, cracks: &[f64]) -> Vec<[f64; 2]> {
    let inner = cracks.iter().copied().filter(|crack| *crack > 0.0 && *crack < width);
    let borders: Vec<f64> = std::iter::once(0.0).chain(inner).chain([width]).collect();
    borders.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Width of the widest of them [m].
pub fn widest_strip(width: f64, cracks: &[f64]) -> f64 {
    strips(width, cracks).iter().map(|[from, to]| to - from).fold(0.0, f64::max)
}

choice! {
    /// Which ways vehicles drive.
    pub enum Directions {
        /// to the right and to the left
        Both = "both",
        /// to the right
        Right = "right",
        /// to the left
        Left = "left",
    }
}
