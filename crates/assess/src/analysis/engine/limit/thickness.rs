//! The least thickness of rings by limit analysis.

use crate::analysis::engine::rigid;
use crate::analysis::engine::rings::RingThickness;
use crate::analysis::{AnalysisError, notes, parallel, template};
use mechanics::limit;
use mechanics::watch::{CancelToken, Watch};
use outcome::collapse::{By, Collapse, LimitReport, Sought, Status};
use std::cell::RefCell;

/// The thickness is narrowed to this share of the given one.
const EXACT: f64 = 1e-7;

/// Narrows the thickness at which the rings just stand. Hinges belong to the thickest ring that falls, the line of thrust to the thinnest that
/// stands.
pub(super) fn least(rings: &RingThickness<'_>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let bridge = rings.bridge;
    let settings = rigid::settings(bridge);
    let given = rings.at(1.0)?;
    let search = |token: &CancelToken| {
        let failed = RefCell::new(None);
        let make = |factor: f64| match rings.at(factor) {
            Ok(d) => (d.model, d.loading),
            Err(error) => {
                failed.replace(Some(error));
                (given.model.clone(), given.loading.clone())
            }
        };
        let found = limit::minimum_thickness(rings.range(), EXACT, 1.0, &settings, token, make)?;
        failed.into_inner().map_or(Ok(found), Err)
    };
    let found = parallel::alone("least thickness", true, watch, search)?;
    let shown = rings.at(found.stands.or(found.falls).unwrap_or(1.0))?;
    let (joints, line) = limit::least_thrust(&shown.model, &shown.loading, 0.0, &settings)?;
    let by = By::Limit(LimitReport { iterations: found.trials, ..LimitReport::default() });
    let mut c = template::of_bridge(bridge, &shown, by, "least thickness");
    if let Some(mechanism) = &found.mechanism {
        rigid::draw_mechanism(&shown, &joints, mechanism, &mut c.picture);
    }
    if let Some(line) = &line {
        c.picture.thrust_lines = rigid::thrust_lines(&shown, &joints, line);
    }
    c.tolerance = EXACT;
    c.contacts = joints.iter().map(|i| i.points.len()).sum();
    c.status = match found.status {
        limit::ThicknessStatus::Found => Status::Completed,
        limit::ThicknessStatus::StandsAtThinnest => Status::StableToLastLoad,
        limit::ThicknessStatus::FallsAtThickest => Status::UnstableUnderSelfWeight,
        limit::ThicknessStatus::NotConverged => Status::NotConverged,
        limit::ThicknessStatus::Cancelled => Status::Cancelled,
    };
    c.sought = Sought::Thickness(found.falls.zip(found.stands).map(|(fell, stood)| rings.report([fell, stood])));
    notes::limit(bridge, &shown, &mut c);
    Ok(c)
}
