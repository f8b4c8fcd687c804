//! Vehicles that are moved over the bridge, and fill that helps.

use super::materials::maybe;
use crate::findings::Findings;
use crate::model::{Directions, FillPressure, LeastPressure, SweepPlan};
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
