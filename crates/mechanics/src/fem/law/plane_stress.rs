//! Any material in plane stress: the strain across is found that leaves no stress across.

use super::Material;
use super::response::{Four, Memory, Response};

/// Steps of the search. Newton needs two to six; the rest are halvings that take over where it leaves its bracket.
const STEPS: usize = 200;

/// The answer with no stress across the plane.
pub(super) fn respond(material: &Material, strain: &Four, old: &Memory) -> Response {
    let mut answer = material.respond(&across(material, strain, old), old);
    condense(&mut answer.tangent);
    answer.stress[2] = 0.0;
    answer
}

/// The strain with the component across that leaves no stress across.
///
/// Stress across grows with strain across, from below zero to zero or above, so that a bracket exists; within it Newton
/// steps with the tangent of the law, and halves where the step would leave it.
#[must_use]
pub fn across(material: &Material, strain: &Four, old: &Memory) -> Four {
    let at = |zz: f64| [strain[0], strain[1], zz, strain[3]];
    let size = strain.iter().zip(&old.plastic).fold(f64::MIN_POSITIVE, |size, (a, b)| size.max((a - b).abs()));
    let mut zz = old.plastic[2];
    let mut answer = material.respond(&at(zz), old);
    let stiff = material.respond(&old.plastic, old).tangent[2][2].abs().max(f64::MIN_POSITIVE);
    let small = 1e-15 * (stiff * size + answer.stress.iter().fold(0.0, |a: f64, s| a.max(s.abs())));
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut reach = size;
    for _ in 0..STEPS {
        let stress = answer.stress[2];
        if stress.abs() <= small {
            break;
        }
        if stress < 0.0 {
            low = low.max(zz)
        } else {
            high = high.min(zz)
        }
        let newton = zz - stress / answer.tangent[2][2];
        let inside = newton > low && newton < high && newton.is_finite() && (newton - zz).abs() <= 4.0 * reach;
        zz = match (low.is_finite(), high.is_finite()) {
            _ if inside => newton,
            (true, true) => 0.5 * (low + high),
            (true, false) => low + reach,
            _ => high - reach,
        };
        if !inside {
            reach *= 2.0;
        }
        if zz <= low || zz >= high {
            break;
        }
        answer = material.respond(&at(zz), old);
    }
    at(zz)
}

/// Takes the component across out of a tangent: it follows the others so that no stress across arises.
fn condense(tangent: &mut [[f64; 4]; 4]) {
    let pivot = tangent[2][2];
    let full = *tangent;
    let largest = full.iter().flatten().fold(0.0, |a: f64, b| a.max(b.abs()));
    for i in 0..4 {
        for j in 0..4 {
            tangent[i][j] = match (i, j) {
                (2, _) | (_, 2) => 0.0,
                // Where no stress across can arise there is nothing to follow.
                _ if pivot.abs() <= 1e-12 * largest => full[i][j],
                _ => full[i][j] - full[i][2] * full[2][j] / pivot,
            };
        }
    }
}
