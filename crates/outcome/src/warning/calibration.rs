//! Particles whose contacts are calibrated.

use super::cards::warnings;
use crate::calibration::{At, Spread, Strength};
use findings::words::{counted, verb};

warnings! {
    /// Of calibrations.
    Calibration {
        NOT_SHEARED: NothingSheared => "no sample rested and gave way under every confining pressure";
        NOT_SHEARED: NotSheared { samples: usize } =>
            "{} {} not count in the strength", counted(*samples, "sample"), verb(*samples, "does", "do");
        STRENGTH_OUT_OF_REACH: StrengthOutOfReach { found: Strength } =>
            "with contacts of {:.1} degrees and {:.1} kPa the fill has {:.1} degrees and {:.1} kPa, which is the nearest to what is wanted",
            found.contact.friction_angle.to_degrees(), found.contact.cohesion / 1e3,
            found.friction_angle.mean.to_degrees(), found.cohesion.mean / 1e3;
        /// The strength of other packings; none where none could be sheared.
        STRENGTH_CHECK_APART: StrengthApart { again: Option<Strength> } => "{}", match again {
            None => "no sample of the other seeds could be sheared".to_owned(),
            Some(again) => format!(
                "other packings have {:.1} degrees (standard error {:.1}) and {:.1} kPa (standard error {:.1})",
                again.friction_angle.mean.to_degrees(), again.friction_angle.standard_error.to_degrees(),
                again.cohesion.mean / 1e3, again.cohesion.standard_error / 1e3
            ),
        };
        LEFT_OUT: LeftOut { samples: usize, of: usize, multiple: f64 } =>
            "{samples} of {of} samples do not count at {multiple:.4} times the stiffness of the file";
        CHECK_APART: NotChecked => "no sample of the other seeds could be pressed to the last load step";
        CHECK_APART: Apart { again: Spread, wanted [Pa]: f64 } =>
            "other packings have {:.1} MPa ({:+.1} %, standard error {:.1} MPa) where {:.1} MPa is wanted",
            again.mean / 1e6, 100.0 * (again.mean / wanted - 1.0), again.standard_error / 1e6, wanted / 1e6;
        /// A modulus that no stiffness gives, and the ends of the search.
        OUT_OF_REACH: OutOfReach { wanted [Pa]: f64, ends: [At; 2] } =>
            "a modulus of {:.1} MPa is out of reach: from {:.3} to {:.1} times the stiffness of the file the fill has {:.1} to {:.1} MPa",
            wanted / 1e6, ends[0].multiple, ends[1].multiple, ends[0].modulus / 1e6, ends[1].modulus / 1e6;
    }
}
