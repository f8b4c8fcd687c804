//! Notes on fill and backing that yield as a continuum.

use bridge::Bridge;
use outcome::collapse::{Collapse, Status};
use outcome::note::{self, Note};
use outcome::picture::Picture;
use outcome::soil::ContinuumReport;
use outcome::warning::{Warning, Yielding};
use structure::discretise::{Discretised, continuum};

/// Notes on bounds of the load.
pub(crate) fn continuum(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    super::common(bridge, d, c);
    let (Some(report), Some(plan)) = (c.limit().and_then(|l| l.continuum.clone()), &bridge.continuum) else { return };
    let warnings = [
        range(&report, c),
        apart(&report, c),
        bears_first(&c.picture).then_some(Yielding::BearsFirst),
        walls(&report, c),
        (report.left_out > 1e-9).then_some(Yielding::BeyondEnds { share: report.left_out }),
        falls(&report, c),
        open(c),
    ];
    c.warnings.extend(warnings.into_iter().flatten().map(Warning::from));
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
pub(super) fn as_weight(bridge: &Bridge) -> Option<Note> {
    continuum::wanted(bridge).map(|_| note::Soil::AsWeight.into())
}

fn range(report: &ContinuumReport, c: &Collapse) -> Option<Yielding> {
    let load = c.last_stable_load.filter(|_| report.shares[1] > 0.0)?;
    Some(Yielding::StrengthRange { load, share: report.mobilised_share, range: report.range, shares: report.shares })
}

fn apart(report: &ContinuumReport, c: &Collapse) -> Option<Yielding> {
    let limit = c.limit().filter(|_| c.status == Status::Collapsed)?;
    let (lower, upper) = (limit.lower_bound?, limit.upper_bound?);
    let solved = report.rounds.last().is_none_or(|(_, lower, upper)| lower.is_some() && upper.is_some());
    let (ratio, triangles, wanted) = (report.bound_ratio, report.elements, report.wanted_ratio);
    (upper > wanted * lower).then_some(Yielding::Apart { ratio, upper, triangles, wanted, solved })
}

fn walls(report: &ContinuumReport, c: &Collapse) -> Option<Yielding> {
    let (wall, plane_strain) = (report.wall?, report.plane_strain?);
    let upper = c.collapse_load.filter(|upper| *upper < plane_strain)?;
    let (ends, resists, tilts) = (wall.ends, wall.resists, wall.tilts);
    Some(Yielding::WallsGive { upper, plane_strain, ends, resists, tilts })
}

fn falls(report: &ContinuumReport, c: &Collapse) -> Option<Yielding> {
    let share = report.permanent_share.filter(|_| c.status == Status::UnstableUnderSelfWeight)?;
    Some(Yielding::Falls { share })
}

/// What is known of the load where only one of the programs was solved.
fn open(c: &Collapse) -> Option<Yielding> {
    let limit = c.limit().filter(|_| c.status == Status::NotConverged)?;
    let carried_share = limit.continuum.as_ref().and_then(|report| report.carried_share);
    match (limit.lower_bound, limit.upper_bound) {
        (None, Some(upper)) => Some(Yielding::UpperAlone { upper, carried_share }),
        (Some(lower), None) => Some(Yielding::LowerAlone { lower }),
        _ => None,
    }
}

/// How much of the fastest motion of a plate the ring shares, at most, where the soil fails under a load and leaves the ring behind.
const STILL: f64 = 0.02;

/// Whether soil fails under a load before the ring does.
fn bears_first(picture: &Picture) -> bool {
    let Some(soil) = &picture.soil else { return false };
    let size = |p: &[f64; 2]| p[0].hypot(p[1]);
    let plates = soil.plates.iter().flat_map(|p| &p.motions).map(size).fold(0.0, f64::max);
    let blocks = picture.mechanism.iter().flatten().map(|m| size(&m.translation)).fold(0.0, f64::max);
    plates > 0.0 && blocks < STILL * plates
}
