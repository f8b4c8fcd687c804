//! Soil that panels hold out of its plane: the pressure on them is one more stress, and what they can bear one more limit.
//!
//! A corner of a triangle beside a panel has a pressure `s` out of the plane, not negative, and the larger principal stress in the plane is at
//! most `N s + 2 c sqrt(N)`: `R <= 2 (N s + 2 c sqrt(N)) + P`. Over a panel the resultant of `s` and its moment are bounded. The multipliers of
//! these two are the velocity and the rotation with which the panel gives way.

use super::conic::{Affine, Conic};
use super::mesh::Mesh;
use super::model::{Panel, Soil};
use super::setting::Setting;
use super::yielding::{corners, slopes};

/// What holds a triangle, and how the soil answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sideways {
    /// The panel.
    pub panel: usize,
    /// `N`.
    pub ratio: f64,
    /// `2 c sqrt(N)` [Pa].
    pub cohesive: f64,
}

/// What the pressures at the corners of a triangle add to the resultant and to the moment on its panel: [m^2] and [m^3] each.
pub(super) type Weights = [[f64; 2]; 3];

impl Sideways {
    pub(super) fn of(setting: &Setting<'_>, mesh: &Mesh, triangle: usize, soil: &Soil) -> Option<Sideways> {
        let corners = mesh.corners(triangle);
        let middle = corners.iter().map(|p| p.x).sum::<f64>() / 3.0;
        let is_beside = |panel: &Panel| panel.ends[0] <= middle && middle < panel.ends[1];
        let panel = setting.soil.panels.iter().position(is_beside)?;
        Some(Sideways { panel, ratio: 1.0, cohesive: 0.0 }.with(soil))
    }

    /// Beside the same panel with another soil.
    pub(super) fn with(&self, soil: &Soil) -> Sideways {
        let (sin, cos) = soil.friction_angle.sin_cos();
        Sideways { ratio: (1.0 + sin) / (1.0 - sin), cohesive: 2.0 * soil.cohesion * cos / (1.0 - sin), ..*self }
    }

    /// By how much a stress (xx, yy, xy) [Pa] exceeds the strength beside a pressure on the panel [Pa].
    pub(super) fn excess(&self, [xx, yy, xy]: [f64; 3], pore: f64, pressure: f64) -> f64 {
        let (sum, radius) = (xx + yy + 2.0 * pore, (xx - yy).hypot(2.0 * xy));
        radius - sum - 2.0 * (self.ratio * pressure + self.cohesive)
    }
}

/// Weights of pressures that are linear over a triangle.
pub(super) fn linear(mesh: &Mesh, triangle: usize, panel: &Panel) -> Weights {
    let (area, arms) = (mesh.area(triangle), mesh.corners(triangle).map(|p| p.y - panel.foot));
    let all: f64 = arms.iter().sum();
    arms.map(|own| [area / 3.0, area / 12.0 * (all + own)])
}

/// Weights of pressures at the corners that stand for a third of the area each: a panel's velocity is linear over the triangle.
pub(super) fn by_corners(mesh: &Mesh, triangle: usize, panel: &Panel) -> Weights {
    let third = mesh.area(triangle) / 3.0;
    mesh.corners(triangle).map(|p| [third, third * (p.y - panel.foot)])
}

/// Demands that no panel bears more than it can of the pressures on it: variables, panels and weights of every triangle that has any.
/// Gives the equations of each panel: of the resultant and of the moment.
pub(super) fn bear(
    program: &mut Conic,
    panels: &[Panel],
    pressures: &[(usize, [usize; 3], Weights)],
    unit: f64,
) -> Vec<[usize; 2]> {
    let mut rooms: Vec<[Affine; 2]> = panels
        .iter()
        .map(|panel| [panel.force, panel.moment].map(|most| Affine { terms: Vec::new(), constant: most / unit }))
        .collect();
    for (panel, variables, weights) in pressures {
        for (variable, weight) in variables.iter().zip(weights) {
            for (room, w) in rooms[*panel].iter_mut().zip(weight) {
                room.terms.push((*variable, -w));
            }
        }
    }
    rooms.iter().map(|both| both.each_ref().map(|room| program.at_least_zero(room))).collect()
}

impl Soil {
    /// Largest power [Pa/s] of any stress within strength at strain rates (xx, yy, shear angle) while the panel beside gives way at a rate,
    /// less what is pressed out against it; and the rate that the flow rule does not allow.
    pub(super) fn dissipation_beside(
        &self,
        [xx, yy, xy]: [f64; 3],
        pore: f64,
        sideways: &Sideways,
        rate: f64,
    ) -> (f64, f64) {
        let (e, g) = (xx + yy, (xx - yy).hypot(xy));
        let limits = self.limits();
        let radius = |p: f64| limits.iter().map(|l| l.k - l.m * p).fold(f64::INFINITY, f64::min).max(0.0);
        let Sideways { ratio, cohesive, .. } = *sideways;
        // With a sum P of stresses and a radius R the panel is pressed by what strength lacks.
        let pressed = |p: f64, r: f64| ((0.5 * (r - p) - cohesive) / ratio).max(0.0);
        let power = |p: f64, r: f64| 0.5 * (p * e + r * g) - rate * pressed(p, r);
        // Concave in P and R, and straight between these places.
        let free = -2.0 * cohesive;
        let meets_free = limits.iter().filter(|l| l.m != -1.0).map(|l| (l.k + free) / (1.0 + l.m));
        let places = [free].into_iter().chain(meets_free).chain(corners(&limits));
        let size = limits.iter().map(|l| l.k.abs()).fold(0.0, f64::max);
        let allowed = |p: &f64| limits.iter().all(|l| l.k - l.m * p >= -1e-12 * size);
        let best = |p: f64| power(p, radius(p)).max(power(p, (p - free).clamp(0.0, radius(p))));
        let most = places.filter(allowed).map(best).fold(f64::NEG_INFINITY, f64::max);
        let [flattest, steepest] = slopes(&limits);
        // Without compressive strength P may fall without end.
        let falling = (flattest * g - e - rate * (1.0 + flattest) / ratio).max(-e - rate / ratio).max(0.0);
        // Without friction and cut-off it may grow without end.
        let growing = if steepest == 0.0 { e.max(0.0) } else { 0.0 };
        let violation = if flattest < 0.0 { growing } else { falling.max(growing) };
        (most - pore * e, violation)
    }
}
