//! Notes on fill and backing that yield as a continuum.

use crate::analysis::by_bounds::bears_first;
use bridge::Bridge;
use outcome::collapse::{Collapse, Status};
use outcome::note::{self, Note};
use outcome::soil::ContinuumReport;
use outcome::warning::{self, Warning};
use structure::discretise::{Discretised, continuum};

/// Notes on bounds of the load.
pub fn continuum(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    super::common(bridge, d, c);
    let (Some(report), Some(plan)) = (c.limit().and_then(|l| l.continuum.clone()), &bridge.continuum) else { return };
    let warnings = [
        range(&report, c),
        apart(&report, c),
        bears(c),
        walls(&report, c),
        left_out(&report),
        falls(&report, c),
        open(c),
    ];
    c.warnings.extend(warnings.into_iter().flatten());
    let (mobilised, dilatancy_angle) = (report.mobilised_share, report.dilatancy_angle);
    let strength = note::Soil::Strength {
        mobilised,
        dilatancy_angle: (plan.dilatancy_angle > 0.0).then_some(dilatancy_angle),
        interface_angle: plan.interface_friction_angle,
    };
    let associated = report.associated.map(|bounds| note::Soil::Associated { bounds });
    let iterated = report.iterated.map(|load| note::Soil::Iterated { load, dilatancy_angle });
    let ends = note::Soil::Ends { extent: plan.extent, ends: plan.ends };
    let told = [note::Soil::Bounds, strength].into_iter().chain(associated).chain(iterated);
    let told = told.chain([note::Soil::Plates, ends, note::Soil::Confined { by: plan.confinement }]);
    c.assumptions.extend(told.map(Note::from));
}

/// What a method says that knows no continuum.
pub fn as_weight(bridge: &Bridge) -> Option<Note> {
    continuum::wanted(bridge).map(|_| note::Soil::AsWeight.into())
}

fn told(load: f64) -> String {
    format!("{:.2}", load / 1e3)
}

fn range(report: &ContinuumReport, c: &Collapse) -> Option<Warning> {
    let load = told(c.last_stable_load.filter(|_| report.shares[1] > 0.0)?);
    let [least, most] = report.shares.map(|share| 100.0 * share);
    let own = format!("{load} kN/m with the {:.0} % of the file", 100.0 * report.mobilised_share);
    let message = match report.range {
        Some([low, high]) => format!(
            "{} to {} kN/m where {least:.0} to {most:.0} % of the soil's strength is mobilised; {own}",
            told(low),
            told(high)
        ),
        None => format!("no load was found that is carried with {least:.0} % of the soil's strength; {own}"),
    };
    Some(Warning::new(warning::STRENGTH_RANGE, message))
}

fn apart(report: &ContinuumReport, c: &Collapse) -> Option<Warning> {
    let limit = c.limit().filter(|_| c.status == Status::Collapsed)?;
    let (lower, upper) = (limit.lower_bound?, limit.upper_bound?);
    if upper <= report.wanted_ratio * lower {
        return None;
    }
    let broken = report.rounds.last().is_some_and(|(_, lower, upper)| lower.is_none() || upper.is_none());
    let remedy = match broken {
        true => "the programs of the next mesh were not solved",
        false => "`elements` in [continuum] allows more triangles",
    };
    let (apart, carried) = match report.bound_ratio {
        Some(ratio) => (format!("{ratio:.3} times the lower one"), "the lower bound is carried all the same"),
        None => {
            (format!("{} kN/m and the lower one zero", told(upper)), "no load is known to be carried beside the weight")
        }
    };
    let message = format!(
        "the upper bound is {apart} after {} triangles, {:.3} times was wanted; {carried}. {remedy}",
        report.elements, report.wanted_ratio
    );
    Some(Warning::new(warning::BOUNDS_APART, message))
}

fn bears(c: &Collapse) -> Option<Warning> {
    let message = "the soil fails under the load and the rings stay: the load is what the soil bears, and the arch may carry \
                   more of a load that is spread further";
    bears_first(&c.picture).then(|| Warning::new(warning::SOIL_BEARS_FIRST, message))
}

fn walls(report: &ContinuumReport, c: &Collapse) -> Option<Warning> {
    let (wall, free) = (report.wall?, report.plane_strain?);
    let upper = c.collapse_load.filter(|upper| *upper < free)?;
    let resists = wall.resists / 1e3 / (wall.ends[1] - wall.ends[0]);
    let message = format!(
        "at most {} kN/m where the walls hold the fill, {} kN/m in plane strain; from {:.1} to {:.1} m a wall {}",
        told(upper),
        told(free),
        wall.ends[0],
        wall.ends[1],
        match wall.tilts {
            true => format!("tilts outwards: it resists {resists:.2} kNm/m"),
            false => format!("slides outwards: it resists {resists:.2} kN/m"),
        }
    );
    Some(Warning::new(warning::WALLS_GIVE_FIRST, message))
}

fn left_out(report: &ContinuumReport) -> Option<Warning> {
    let message =
        || format!("{:.1} % of the loads stands beyond the ends of the fill and is left out", 100.0 * report.left_out);
    (report.left_out > 1e-9).then(|| Warning::new(warning::GROUND_LOAD, message()))
}

fn falls(report: &ContinuumReport, c: &Collapse) -> Option<Warning> {
    let share = report.permanent_share.filter(|_| c.status == Status::UnstableUnderSelfWeight)?;
    let message =
        format!("a mechanism proves that rings and soil carry no more than {:.1} % of their own weight", 100.0 * share);
    Some(Warning::new(warning::SOIL_FALLS, message))
}

/// What is known of the load where only one of the programs was solved.
fn open(c: &Collapse) -> Option<Warning> {
    let limit = c.limit().filter(|_| c.status == Status::NotConverged)?;
    let message = match (limit.lower_bound, limit.upper_bound) {
        (None, Some(upper)) => {
            let least = limit.continuum.as_ref().and_then(|report| report.carried_share);
            let least =
                least.map_or(String::new(), |share| format!(", {:.1} % of it are carried", 100.0 * share.min(1.0)));
            format!(
                "no stresses were found that carry all of the weight{least}: the load is at most {} kN/m, and not known",
                told(upper)
            )
        }
        (Some(lower), None) => {
            format!("no mechanism was found: {} kN/m are carried, and how much more is not known", told(lower))
        }
        _ => return None,
    };
    Some(Warning::new(warning::BOUNDS_APART, message))
}
