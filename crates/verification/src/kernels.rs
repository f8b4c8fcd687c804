//! The kernels whose speed is measured: by `cargo bench -p verification`, and by `extrados bench`, which says what each of them found.
//!
//! Each begins with a bridge and ends with numbers, pictures and pages left out.

use assess::analysis::AnalysisError;
use assess::analysis::engine::{dem as by_dem, rigid};
use bridge::Bridge;
use mechanics::contact::ContactLength;
use mechanics::watch::Unwatched;
use mechanics::{dem, limit, path};
use structure::discretise::discretise;

/// What one run of a kernel found.
pub struct Found {
    /// How many blocks.
    pub blocks: usize,
    /// Iterations of its solver in all.
    pub iterations: u64,
    /// Largest load shown to stand [N/m].
    pub stands: Option<f64>,
    /// Smallest load shown to fall [N/m].
    pub falls: Option<f64>,
    /// The solver's tolerance.
    pub tolerance: f64,
}

/// A bridge to collapse by discrete elements under adaptive damping, from the file to the last step.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn discrete_elements(bridge: &Bridge) -> Result<Found, AnalysisError> {
    by_discrete_elements(bridge, by_dem::settings(bridge))
}

/// The same on joints with distributed contact.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn discrete_elements_with_distributed_contact(bridge: &Bridge) -> Result<Found, AnalysisError> {
    by_discrete_elements(
        bridge,
        dem::Settings { contact_length: ContactLength::Distributed, ..by_dem::settings(bridge) },
    )
}

fn by_discrete_elements(bridge: &Bridge, settings: dem::Settings) -> Result<Found, AnalysisError> {
    let d = discretise(bridge)?;
    let settings = dem::Settings { damping: dem::Damping::Adaptive, ..settings };
    let increment = load_step(bridge) / d.reference_load;
    let program = dem::Program { increment, limit: 100.0 * increment, resolution: None, watched: d.watched };
    let found = dem::collapse(&d.model, &d.loading, &program, &settings, None, &mut Unwatched)?;
    Ok(Found {
        blocks: d.model.blocks.len(),
        iterations: found.iterations_total,
        stands: found.last_stable_factor.map(|f| f * d.reference_load),
        falls: found.collapse_factor.map(|f| f * d.reference_load),
        tolerance: settings.tolerance,
    })
}

/// A bridge along its equilibrium path, joints with distributed contact, to past its largest load.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn equilibrium_path(bridge: &Bridge) -> Result<Found, AnalysisError> {
    let d = discretise(bridge)?;
    let settings = path::Settings::new(ContactLength::Distributed);
    let increment = load_step(bridge) / d.reference_load;
    let program = path::Program { increment, limit: 100.0 * increment, watched: d.watched };
    let found = path::collapse(&d.model, &d.loading, (&settings, &program), None, &mut Unwatched)?;
    Ok(Found {
        blocks: d.model.blocks.len(),
        iterations: u64::from(found.iterations),
        stands: found.last_stable_factor.map(|f| f * d.reference_load),
        falls: found.collapse_factor.map(|f| f * d.reference_load),
        tolerance: settings.tolerance,
    })
}

/// A bridge by limit analysis, the full ring: blocks, program, both bounds, mechanism.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn limit_analysis(bridge: &Bridge) -> Result<Found, AnalysisError> {
    let d = discretise(bridge)?;
    let settings = limit::Settings { contact_points: limit::ContactPoints::FullRing, ..rigid::settings(bridge) };
    let found = limit::collapse_load(&d.model, &d.loading, &settings)?;
    Ok(Found {
        blocks: d.model.blocks.len(),
        iterations: u64::from(found.iterations),
        stands: found.lower_bound.map(|f| f * d.reference_load),
        falls: found.upper_bound.map(|f| f * d.reference_load),
        tolerance: 1e-6,
    })
}

/// The first load step of a bridge's plan, or 100 kN on its width [N/m].
fn load_step(bridge: &Bridge) -> f64 {
    bridge.plan.load_step.unwrap_or(100e3 / bridge.width)
}
