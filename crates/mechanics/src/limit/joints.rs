//! Joints and their strength.

use super::settings::{ContactPoints, Settings};
use crate::blocks::{BlockModel, Interface, ModelError, interfaces};
use crate::ids::BlockId;
use crate::plane::Vec2;
use std::ops::Range;

/// A joint with its strength, as limit analysis sees it: one compression per contact point and one shear.
#[derive(Debug, Clone)]
pub(super) struct Joint {
    /// The block on one side.
    pub first: BlockId,
    /// The block on the other side; forces are those that act on it.
    pub second: BlockId,
    /// Unit normal from the first to the second block.
    pub normal: Vec2,
    /// One or two contact points [m], ordered along the tangent.
    pub points: Vec<Vec2>,
    /// Distance between the two contact points [m]; 0 for one.
    pub length: f64,
    /// How the joint resists.
    pub strength: Strength,
    /// The first of its columns among those of all joints: its compressions, then its shear.
    pub column: usize,
}

/// Strength of a joint: stresses anywhere between `-tension` and `crushing`, shear up to
/// `friction * compression + cohesion`. All in forces per metre of width [N/m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Strength {
    /// Tensile force that each contact point can carry.
    pub tension: f64,
    /// Coefficient of friction; infinite for no sliding.
    pub friction: f64,
    /// Shear carried without compression.
    pub cohesion: f64,
    /// Largest compression of the whole joint; infinite for no crushing.
    pub crushing: f64,
}

impl Joint {
    /// Unit tangent.
    pub(super) fn tangent(&self) -> Vec2 {
        self.normal.left()
    }
    /// Number of forces: the compressions, then the shear.
    pub(super) fn forces(&self) -> usize {
        self.points.len() + 1
    }
    /// Its columns among those of all joints.
    pub(super) fn columns(&self) -> Range<usize> {
        self.column..self.column + self.forces()
    }
}

impl Strength {
    /// Curvature of the thrust-block parabola. With every compression and the total shifted by the tension,
    /// `n' >= curvature * total'^2`; zero without crushing. For no tension this is the textbook
    /// `M = N h / 2 (1 - N / (fc h))`.
    pub(super) fn curvature(&self, points: usize) -> f64 {
        if self.crushing.is_finite() && points == 2 { 0.5 / (self.crushing + 2.0 * self.tension) } else { 0.0 }
    }
}

/// Largest gap at which two blocks still share a joint [m].
const TOUCHING: f64 = 1e-6;

/// All joints of a model and the interfaces they come from.
pub(super) fn joints(model: &BlockModel, settings: &Settings) -> Result<(Vec<Interface>, Vec<Joint>), ModelError> {
    if !model.particles.is_empty() {
        return Err(ModelError::ParticlesInLimitAnalysis(model.particles.len()));
    }
    let faces = interfaces(model, TOUCHING)?;
    let mut columns = 0;
    let numbered = |face| {
        let joint = joint(model, settings, face, columns);
        columns += joint.forces();
        joint
    };
    let joints = faces.iter().map(numbered).collect();
    Ok((faces, joints))
}

fn joint(model: &BlockModel, settings: &Settings, face: &Interface, column: usize) -> Joint {
    let law = model.laws.between(model.blocks[face.first].group, model.blocks[face.second].group);
    let points = match settings.contact_points {
        ContactPoints::Rounded => face.points.clone(),
        ContactPoints::FullRing => face.face.clone(),
    };
    // A joint that turns is pressed over no less than compression over strength: cohesion there acts as friction that is
    // larger. Along the whole joint it acts only as far as a tensile strength holds the joint together.
    let bonded = if law.tension > 0.0 { law.cohesion.min(law.friction * law.tension) } else { 0.0 };
    let length = if points.len() == 2 { (points[1] - points[0]).norm() } else { 0.0 };
    Joint {
        first: face.first,
        second: face.second,
        normal: face.normal,
        length,
        strength: Strength {
            tension: 0.5 * law.tension * length,
            friction: law.friction + (law.cohesion - bonded) / law.crushing,
            cohesion: bonded * length,
            crushing: if settings.crushing { law.crushing * length } else { f64::INFINITY },
        },
        points,
        column,
    }
}
