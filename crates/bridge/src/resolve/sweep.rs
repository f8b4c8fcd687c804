//! Vehicles that are moved over the bridge, and fill that helps.

use super::materials::maybe;
use crate::findings::Findings;
use crate::model::{Carriageway, Directions, FillPressure, LeastPressure, SweepPlan};
use crate::tree::Table;

/// The rule where the file names none.
const USUAL_RULE: &str = "characteristic";

/// The sweep that the file asks for.
pub(super) fn sweep(file: &Table<'_>, findings: &mut Findings) -> Option<Option<SweepPlan>> {
    if !file.has("sweep") {
        return Some(None);
    }
    let table = file.table("sweep", findings)?;
    let mut text = |key| {
        let value = table.text(key, findings);
        maybe(&table, key, value).map(|value: Option<&str>| value.map(str::to_owned))
    };
    let (rule, rule_file) = (text("rule"), text("rule_file"));
    if table.has("rule") && table.has("rule_file") {
        super::structure::exclude(&table, "rule", "`rule_file`", findings);
    }
    let mut list = |key: &str| match table.has(key) {
        true => {
            let list = table.values(key, findings)?;
            Some(list.iter().map(|word| word.trim_matches(['"', '\'']).to_owned()).collect())
        }
        false => Some(Vec::new()),
    };
    let (vehicles, vehicle_files) = (list("vehicles"), list("vehicle_files"));
    let step = table.quantity("step", findings);
    let directions = table.word("directions", findings);
    let dispersal = table.word("dispersal", findings);
    let subsets = table.flag("subsets", findings);
    let discrete = ["discrete_elements", "confirm"].map(|key| (key, table.flag(key, findings)));
    Some(Some(SweepPlan {
        rule: rule?.unwrap_or_else(|| USUAL_RULE.to_owned()),
        rule_file: rule_file?,
        vehicles: vehicles?,
        vehicle_files: vehicle_files?,
        step: maybe(&table, "step", step)?,
        directions: match maybe(&table, "directions", directions)? {
            Some("right") => Directions::Right,
            Some("left") => Directions::Left,
            _ => Directions::Both,
        },
        subsets: maybe(&table, "subsets", subsets)?.unwrap_or(true),
        own_dispersal: maybe(&table, "dispersal", dispersal)? == Some("file"),
        discrete_elements: {
            let [now, former] = discrete.map(|(key, flag)| maybe(&table, key, flag));
            now?.or(former?).unwrap_or(false)
        },
        texts: Vec::new(),
    }))
}

/// Skew from which on a square model says little [rad].
pub(crate) const DOUBTFUL_SKEW: f64 = 10.0 * std::f64::consts::PI / 180.0;

/// Where vehicles may stand across a barrel so wide [m].
pub(super) fn carriageway(
    file: &Table<'_>,
    width: Option<f64>,
    findings: &mut Findings,
) -> Option<Option<Carriageway>> {
    if !file.has("carriageway") {
        return Some(None);
    }
    let table = file.table("carriageway", findings)?;
    let lanes = table.count("lanes", findings);
    let mut quantity = |key| {
        let value = table.quantity(key, findings);
        maybe(&table, key, value)
    };
    let (lane_width, edge_distance, skew) = (quantity("lane_width"), quantity("edge_distance"), quantity("skew"));
    let lanes = maybe(&table, "lanes", lanes)?.map(|lanes| usize::try_from(lanes).unwrap_or(usize::MAX));
    let found = Carriageway { lanes, lane_width: lane_width?, edge_distance: edge_distance?, skew: skew? };
    if let (Some(width), Some(edge)) = (width, found.edge_distance)
        && edge > 0.5 * width
    {
        findings.error(
            "B660",
            table.place("edge_distance"),
            "the nearest wheel is beyond the middle of the barrel",
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
            format!("{lanes} vehicles {lane} m apart do not fit on a barrel of {width} m"),
            "vehicles abreast on this bridge",
            "write fewer lanes, or their true distance",
        );
    }
    if found.skew.is_some_and(|skew| skew > DOUBTFUL_SKEW) {
        findings.warning(
            "P060",
            table.place("skew"),
            "the bridge is skew, and the model is square",
            "skew barrels carry from obtuse corner to obtuse corner",
            "give the spans along the road, which are the longer ones, and confirm the load by a model in three dimensions or by test",
        );
    }
    Some(Some(found))
}

/// The pressure of fill that helps.
pub(super) fn fill_pressure(file: &Table<'_>, findings: &mut Findings) -> Option<Option<FillPressure>> {
    if !file.has("fill_pressure") {
        return Some(None);
    }
    let table = file.table("fill_pressure", findings)?;
    let applies = table.flag("applies", findings);
    let friction_angle = table.quantity("friction_angle", findings);
    let cohesion = table.quantity("cohesion", findings);
    let mut number = |key, default| {
        let value = table.number(key, findings);
        maybe(&table, key, value).map(|value| value.unwrap_or(default))
    };
    let (mobilisation, cohesion_mobilisation) = (number("mobilisation", 0.5), number("cohesion_mobilisation", 0.05));
    let least = table.word("least", findings);
    Some(Some(FillPressure {
        applies: maybe(&table, "applies", applies)?.unwrap_or(true),
        friction_angle: friction_angle?.value,
        cohesion: maybe(&table, "cohesion", cohesion)?.unwrap_or(0.0),
        mobilisation: mobilisation?,
        cohesion_mobilisation: cohesion_mobilisation?,
        least: match maybe(&table, "least", least)? {
            Some("active") => LeastPressure::Active,
            Some("none") => LeastPressure::None,
            _ => LeastPressure::AtRest,
        },
    }))
}
