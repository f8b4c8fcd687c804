//! Vehicles that are moved over the bridge, and fill that helps.

use crate::card::Section;
use crate::cards::*;
use crate::choice::choice;
use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::model::{Carriageway, Directions, GAUGE, GRAVITY_HEIGHT, LEAST_STEP, LeastPressure, Sideways, SweepPlan};
use crate::tree::{At, Table};
use crate::values::read;

choice! {
    /// How axles spread through the cover.
    enum Spread {
        /// as in the rule, with the rule's footprint
        Rule = "rule",
        /// as in [dispersal], with each vehicle's footprint
        File = "file",
    }
}

pub(super) static SWEEP: Section = Section {
    path: "sweep",
    doc: "Vehicles that `extrados collapse --sweep` moves over the bridge by limit analysis: every position, both \
          directions, every group of neighbouring axles, with the factors of a rule on loads and weights. Vehicles and \
          rules of the library are listed in docs/theory/load-rules.md.",
    fields: &[
        number(
            "braking",
            "braking and traction: force along the bridge as a share of every axle and uniform load, tried to the right, to the left and not at all",
            "0.25",
        )
        .between(0.0, 1.0)
        .default("0"),
        text(
            "braking_reason",
            "why braking has this share; a rule that asks for braking gives no verdict where it is less than 0.15 without a reason",
            "ballasted track runs 40 m beyond both abutments",
        )
        .optional("no reason"),
        text("rule", "rule of the library: factors, dispersal, impact", "cs-454")
            .optional(
                "\"characteristic\": no safety factors, for comparisons, never for a verdict; or given by `rule_file`",
            ),
        text("rule_file", "file with a rule, relative to the bridge file", "our-rule.toml")
            .optional("a rule of the library"),
        values(
            "vehicles",
            "codes of vehicles, load models or trains of the library, or of `vehicle_files`",
            "[\"hb-45\", \"cs-454\"]",
        )
        .optional("all of the library, and of `vehicle_files`"),
        values("vehicle_files", "files with vehicles, relative to the bridge file", "[\"our-crane.toml\"]")
            .optional("none"),
        length("step", "distance between positions", "0.25 m")
            .at_least(LEAST_STEP)
            .optional("a sixtieth of the shortest span; the worst position between steps is then found"),
        word::<Directions>("directions", "directions in which vehicles travel", "both")
            .default(Directions::Both.word()),
        flag("subsets", "whether every group of neighbouring axles is tried", "true").default("true"),
        word::<Spread>("dispersal", "how axles spread through the cover", "rule").default(Spread::Rule.word()),
        flag(
            "discrete_elements",
            "whether the governing case is also analysed by discrete elements; the smaller number counts",
            "true",
        )
        .default("false"),
        flag("confirm", "the former name of `discrete_elements`", "true").default("false"),
    ],
};

pub(super) static CARRIAGEWAY: Section = Section {
    path: "carriageway",
    doc: "Possible positions of vehicles of [sweep] across the bridge. In a plane model they determine the width of \
          the barrel that carries one vehicle: two abreast share the width between them, and for one at the edge the \
          width beyond it is missing. The worst arrangement counts.",
    fields: &[
        count("lanes", "how many vehicles may stand abreast: lanes of a road, tracks of a railway", "2")
            .between(1.0, 20.0)
            .optional("road: two where two of 2.5 m fit on the barrel, else one; railway: one"),
        length("lane_width", "distance between the middles of two vehicles abreast", "2.5 m")
            .positive()
            .optional("2.5 m on roads, 3.4 m on railways"),
        length(
            "edge_distance",
            "distance from an edge of the barrel to the middle of the nearest wheel or rail",
            "0.8 m",
        )
        .at_least(0.0)
        .optional("vehicles stand in the middle of the barrel"),
        angle("skew", "angle of skew of spans without their own: 0 for a square bridge", "15 deg")
            .between(0.0, 1.31)
            .optional("taken as square; the model is square in any case"),
        lengths(
            "cracks",
            "longitudinal cracks through the barrel: their distances from one of its edges",
            "[\"0.75 m\"]",
        )
        .positive()
        .optional("the barrel carries as a whole"),
        length(
            "track_offset",
            "distance of the middle of the outermost track or lane from the middle of the barrel, where vehicles keep to it; in place of \
             `edge_distance`",
            "0.6 m",
        )
        .at_least(0.0)
        .optional("as `edge_distance` says"),
        length(
            "track_gauge",
            "distance between the middles of both rails, or of wheels on an axle, for `track_offset`, `cant` and forces across",
            "1.5 m",
        )
        .positive()
        .optional("1.5 m"),
        length("curve_radius", "radius of the curve on which vehicles run", "300 m")
            .positive()
            .optional("straight: no centrifugal force"),
        speed("speed", "speed on that curve, for the centrifugal force", "60 km/h")
            .at_least(0.0)
            .optional("needed where there is a `curve_radius`"),
        length("cant", "level of the outer rail above the inner one", "90 mm").at_least(0.0).optional("no cant"),
        number(
            "side_force",
            "force across the bridge as a share of every axle, to either side: wind on the vehicle, as the rule asks",
            "0.05",
        )
        .between(0.0, 1.0)
        .optional("none"),
        length("side_force_height", "height above rail or road at which centrifugal and side forces act", "1.8 m")
            .at_least(0.0)
            .optional("1.8 m"),
    ],
};

pub(super) static FILL_PRESSURE: Section = Section {
    path: "fill_pressure",
    doc: "Horizontal pressure of the fill on the rings' backs in limit analysis and along the equilibrium path: between the \
          pressure at rest and a share of Rankine's passive pressure. In limit analysis all of that share is there where a back \
          moves against the fill; along the path it grows with the movement. docs/theory/fill-pressure.md gives the sources of \
          the shares. The discrete element method does not use this table: particles exert pressure themselves.",
    fields: &[
        flag("applies", "whether it acts", "true").default("true"),
        angle("friction_angle", "angle of friction of the fill", "30 deg").between(0.0, 1.2),
        stress("cohesion", "cohesion of the fill", "5 kPa").at_least(0.0).default("0 kPa"),
        number("mobilisation", "share of the passive pressure of friction that movement mobilises", "0.5")
            .between(0.0, 1.0)
            .default("0.5"),
        number("cohesion_mobilisation", "share of the passive pressure of cohesion", "0.05")
            .between(0.0, 1.0)
            .default("0.05"),
        word::<LeastPressure>("least", "pressure on backs that do not move against the fill", "at-rest")
            .default(LeastPressure::AtRest.word()),
        number(
            "half_movement",
            "movement of a back against the fill at which half of what movement mobilises is there, as a share of the depth \
             below the top of the fill; method \"path\"",
            "0.01",
        )
        .positive_up_to(1.0)
        .default("0.02"),
    ],
};

/// The rule where the file names none.
const USUAL_RULE: &str = "characteristic";

/// The sweep that the file asks for.
pub(crate) fn sweep(table: &Table<'_>, findings: &mut Findings) -> Option<SweepPlan> {
    if table.has("rule") && table.has("rule_file") {
        table.exclude::<()>("rule", "`rule_file`", findings);
    }
    let rule: Option<Option<String>> = table.read("rule", findings);
    let mut list = |key: &str| {
        let list: Vec<String> = table.read(key, findings)?;
        let bare = |word: String| word.trim_matches(['"', '\'']).to_owned();
        Some(list.into_iter().map(bare).collect())
    };
    let (vehicles, vehicle_files) = (list("vehicles"), list("vehicle_files"));
    let dispersal = table.read("dispersal", findings);
    let discrete = ["discrete_elements", "confirm"].map(|key| table.read(key, findings));
    read!(
        table,
        findings,
        SweepPlan {
            rule_file,
            step,
            directions,
            subsets,
            braking,
            braking_reason;
            braking_given: table.has("braking"),
            rule: rule?.unwrap_or_else(|| USUAL_RULE.to_owned()),
            vehicles: vehicles?,
            vehicle_files: vehicle_files?,
            own_dispersal: match dispersal? {
                Spread::Rule => false,
                Spread::File => true,
            },
            discrete_elements: if table.has("discrete_elements") { discrete[0]? } else { discrete[1]? },
            texts: Vec::new(),
        }
    )
}

/// Beyond this skew [rad] a square model says nothing that a verdict may rest on.
pub const DOUBTFUL_SKEW: f64 = 10.0 * std::f64::consts::PI / 180.0;

/// Where vehicles may stand across a barrel so wide [m].
pub(crate) fn carriageway(table: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<Carriageway> {
    let skew: Option<Option<At<f64>>> = table.read("skew", findings);
    if let Some(At { value, range }) = skew.flatten() {
        doubt(value, range, findings);
    }
    let gauge: Option<Option<f64>> = table.read("track_gauge", findings);
    let gauge = gauge.map(|gauge| gauge.unwrap_or(GAUGE));
    let offset: Option<Option<f64>> = table.read("track_offset", findings);
    let sideways = sideways(table, gauge, findings);
    if table.has("edge_distance") && table.has("track_offset") {
        table.exclude::<()>("edge_distance", "`track_offset`", findings);
    }
    let mut found = read!(
        table,
        findings,
        Carriageway {
            lanes,
            lane_width,
            edge_distance,
            cracks;
            skew: skew?.map(|skew| skew.value),
            sideways: sideways?,
        }
    )?;
    if let (Some(width), Some(offset), Some(gauge)) = (width, offset?, gauge) {
        let edge = 0.5 * (width - gauge) - offset;
        if edge < 0.0 {
            findings.error(
                "B660",
                table.place("track_offset"),
                "the outer rail or wheel stands beside the barrel",
                format!("the barrel is {width} m wide, and rails or wheels are {gauge} m apart"),
                format!("write an offset of at most {:.3} m", (0.5 * (width - gauge)).max(0.0)),
            );
        }
        found.edge_distance = Some(edge.max(0.0));
    }
    if let (Some(width), Some(edge)) = (width, found.edge_distance)
        && edge > 0.5 * width
    {
        findings.error(
            "B660",
            table.place("edge_distance"),
            "the nearest wheel stands beyond the middle of the barrel",
            format!("the barrel is {width} m wide"),
            format!("write a distance of at most {} m, half the width", 0.5 * width),
        );
    }
    if let (Some(width), Some(lanes), Some(lane)) = (width, found.lanes, found.lane_width)
        && (lanes as f64 - 1.0) * lane > width
    {
        findings.error(
            "B661",
            table.place("lanes"),
            format!("{lanes} vehicles {lane} m apart do not stand on a barrel of {width} m"),
            "vehicles abreast on this bridge",
            "write fewer lanes, or the distance that they have",
        );
    }
    let beyond = width.is_some_and(|width| found.cracks.iter().any(|crack| *crack >= width));
    if beyond || found.cracks.windows(2).any(|pair| pair[0] >= pair[1]) {
        findings.error(
            "B227",
            table.place("cracks"),
            "longitudinal cracks do not lie in this barrel in this order",
            width.map_or_else(
                || "cracks from one edge to the other".to_owned(),
                |width| format!("the barrel is {width} m wide"),
            ),
            "give their distances from one edge of the barrel, the least first",
        );
    }
    Some(found)
}

/// What moves the resultant of vehicles sideways; it stays between the rails.
fn sideways(table: &Table<'_>, gauge: Option<f64>, findings: &mut Findings) -> Option<Sideways> {
    let radius: Option<Option<f64>> = table.read("curve_radius", findings);
    let speed: Option<Option<f64>> = table.read("speed", findings);
    let mut or = |key, usual: f64| {
        let given: Option<Option<f64>> = table.read(key, findings);
        given.map(|given| given.unwrap_or(usual))
    };
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

/// Says what a plane model leaves open of a skew span [rad].
pub(crate) fn doubt(skew: f64, place: TextRange, findings: &mut Findings) {
    if skew > DOUBTFUL_SKEW {
        findings.warning(
            "P060",
            place,
            "the bridge is skew, and the model is square",
            "skew barrels carry from obtuse corner to obtuse corner",
            "give the spans along the road, which are the longer ones, and confirm the load by a model in three dimensions or by test",
        );
    }
}
