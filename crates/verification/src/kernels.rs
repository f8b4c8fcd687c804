//! The kernels whose speed is measured: by `cargo bench -p verification`, and by `extrados bench`, which says what each of them found.
//!
//! Each begins with a bridge and ends with numbers, pictures and pages left out.

use assess::analysis::AnalysisError;
use assess::analysis::engine::{dem as by_dem, rigid};
use bridge::Bridge;
use mechanics::contact::ContactLength;
use mechanics::watch::Unwatched;
use mechanics::{dem, limit, path};
use structure::discretise::{Discretised, discretise};

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

impl Found {
    /// With the factors on the load by which blocks were shown to stand and to fall.
    fn of(d: &Discretised, iterations: u64, factors: [Option<f64>; 2], tolerance: f64) -> Found {
        let [stands, falls] = factors.map(|factor| factor.map(|f| f * d.reference_load));
        Found { blocks: d.model.blocks.len(), iterations, stands, falls, tolerance }
    }
}

/// A bridge to collapse by discrete elements under adaptive damping, from the file to the last step; with other joints than its plan has, where
/// a contact is named.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn discrete_elements(bridge: &Bridge, contact: Option<ContactLength>) -> Result<Found, AnalysisError> {
    let d = discretise(bridge)?;
    let own = by_dem::settings(bridge);
    let contact_length = contact.unwrap_or(own.contact_length);
    let settings = dem::Settings { damping: dem::Damping::Adaptive, contact_length, ..own };
    let increment = load_step(bridge) / d.reference_load;
    let program = dem::Program { increment, limit: 100.0 * increment, resolution: None, watched: d.watched };
    let found = dem::collapse(&d.model, &d.loading, &program, &settings, None, &mut Unwatched)?;
    Ok(Found::of(&d, found.iterations_total, [found.last_stable_factor, found.collapse_factor], settings.tolerance))
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
    let factors = [found.last_stable_factor, found.collapse_factor];
    Ok(Found::of(&d, u64::from(found.iterations), factors, settings.tolerance))
}

/// A bridge by limit analysis, the full ring: blocks, program, both bounds, mechanism.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn limit_analysis(bridge: &Bridge) -> Result<Found, AnalysisError> {
    let d = discretise(bridge)?;
    let settings = limit::Settings { contact_points: limit::ContactPoints::FullRing, ..rigid::settings(bridge) };
    let found = limit::collapse_load(&d.model, &d.loading, &settings)?;
    Ok(Found::of(&d, u64::from(found.iterations), [found.lower_bound, found.upper_bound], 1e-6))
}

/// The first load step of a bridge's plan, or 100 kN on its width [N/m].
fn load_step(bridge: &Bridge) -> f64 {
    bridge.plan.load_step.unwrap_or(100e3 / bridge.width)
}
