//! Strengths of solids.

/// What strengths a solid has; each law takes what it knows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strength {
    /// Cohesion [Pa], or the strength in pure shear of what knows no friction.
    pub cohesion: f64,
    /// Angle of friction [rad].
    pub friction_angle: f64,
    /// Angle of dilatancy [rad].
    pub dilatancy_angle: f64,
    /// Greatest principal stress in tension [Pa]; none: what cohesion and friction leave.
    pub tension_cutoff: Option<f64>,
    /// Which cone stands for a pyramid.
    pub cone: Cone,
}

/// Which of the cones stands for a pyramid of Mohr and Coulomb.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cone {
    /// Through the edges of triaxial compression: the outermost.
    Compression,
    /// Through the edges of triaxial extension.
    Extension,
    /// The same collapse in plane strain, at the given angle of dilatancy.
    PlaneStrain,
    /// The greatest cone within the pyramid.
    Inner,
}

impl Cone {
    /// α and k/c of the cone for an angle of friction and one of dilatancy [rad].
    pub(super) fn constants(self, friction: f64, dilatancy: f64) -> (f64, f64) {
        let (sin, cos) = friction.sin_cos();
        let root = 3.0_f64.sqrt();
        match self {
            Cone::Compression => (2.0 * sin / (root * (3.0 - sin)), 6.0 * cos / (root * (3.0 - sin))),
            Cone::Extension => (2.0 * sin / (root * (3.0 + sin)), 6.0 * cos / (root * (3.0 + sin))),
            Cone::PlaneStrain => {
                // Flow leaves no strain across, which fixes the stress across and so the circle of Mohr.
                let beta = dilatancy.sin() / (9.0 + 3.0 * dilatancy.sin().powi(2)).sqrt();
                let share = (1.0 - 3.0 * beta * beta).sqrt() + beta * sin;
                (sin / (3.0 * share), cos / share)
            }
            Cone::Inner => {
                let share = (9.0 + 3.0 * sin * sin).sqrt();
                (sin / share, 3.0 * cos / share)
            }
        }
    }
}
