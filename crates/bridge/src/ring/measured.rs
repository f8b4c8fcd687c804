//! A smooth curve through surveyed points: between two points a cubic, its tangent at each point that of the circle
//! through the point and its two neighbours. A circle surveyed closely comes out as a circle; no point moves its
//! surroundings beyond the two pieces on either side.

use super::invert::invert;
use super::{Misfit, Station};

/// Levels of the two springings may differ by this [m]: what a survey cannot tell.
const LEVEL: f64 = 1e-3;

/// Whether the points can be an intrados.
pub(super) fn check(points: &[[f64; 2]]) -> Result<(), Misfit> {
    if points.len() < 3 {
        return Err(Misfit::TooFewPoints);
    }
    if !points.iter().flatten().all(|coordinate| coordinate.is_finite()) {
        return Err(Misfit::NotPositive);
    }
    for (index, pair) in points.windows(2).enumerate() {
        if pair[1][0] <= pair[0][0] {
            return Err(Misfit::NotLeftToRight(index + 1));
        }
    }
    if (points[points.len() - 1][1] - points[0][1]).abs() > LEVEL {
        return Err(Misfit::NotLevel);
    }
    if let Some(low) = points[1..points.len() - 1].iter().position(|point| point[1] <= points[0][1]) {
        return Err(Misfit::BelowSpringing(low + 1));
    }
    Ok(())
}

/// A cubic between two points with given ends and end derivatives, over a parameter from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    ends: [[f64; 2]; 2],
    derivatives: [[f64; 2]; 2],
    length: f64,
    /// Length of all pieces before.
    before: f64,
}

/// Points and weights of Gauss and Legendre on 0 to 1, eight of them: exact to degree 15.
const GAUSS: [[f64; 2]; 8] = [
    [0.019_855_071_751_231_86, 0.050_614_268_145_188_13],
    [0.101_666_761_293_186_64, 0.111_190_517_226_687_24],
    [0.237_233_795_041_835_5, 0.156_853_322_938_943_64],
    [0.408_282_678_752_175_1, 0.181_341_891_689_181],
    [0.591_717_321_247_825, 0.181_341_891_689_181],
    [0.762_766_204_958_164_5, 0.156_853_322_938_943_64],
    [0.898_333_238_706_813_4, 0.111_190_517_226_687_24],
    [0.980_144_928_248_768_1, 0.050_614_268_145_188_13],
];

impl Piece {
    fn point(&self, t: f64) -> [f64; 2] {
        let (a, b) = ((1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t), t * (1.0 - t) * (1.0 - t));
        let (c, d) = (t * t * (3.0 - 2.0 * t), t * t * (t - 1.0));
        [0, 1].map(|i| {
            a * self.ends[0][i] + b * self.derivatives[0][i] + c * self.ends[1][i] + d * self.derivatives[1][i]
        })
    }

    fn derivative(&self, t: f64) -> [f64; 2] {
        let (a, b, d) = (6.0 * t * (t - 1.0), (1.0 - t) * (1.0 - 3.0 * t), t * (3.0 * t - 2.0));
        [0, 1]
            .map(|i| a * (self.ends[0][i] - self.ends[1][i]) + b * self.derivatives[0][i] + d * self.derivatives[1][i])
    }

    fn speed(&self, t: f64) -> f64 {
        let derivative = self.derivative(t);
        derivative[0].hypot(derivative[1])
    }

    /// Length from 0 to t, by four panels of eight points.
    fn length_to(&self, t: f64) -> f64 {
        const PANELS: usize = 4;
        let panel = t / PANELS as f64;
        (0..PANELS)
            .map(|index| {
                let start = index as f64 * panel;
                GAUSS.iter().map(|[at, weight]| weight * panel * self.speed(start + at * panel)).sum::<f64>()
            })
            .sum()
    }
}

/// The whole curve.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Measured {
    pieces: Vec<Piece>,
}

impl Measured {
    pub(super) fn new(points: &[[f64; 2]]) -> Result<Measured, Misfit> {
        let tangents = tangents(points);
        let mut pieces = Vec::with_capacity(points.len() - 1);
        let mut before = 0.0;
        for index in 0..points.len() - 1 {
            let ends = [points[index], points[index + 1]];
            let chord = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
            let size = chord[0].hypot(chord[1]);
            // The longer way round a bend: twice the chord over one plus the cosine of half the bend, which makes the
            // cubic follow a circle to fourth order.
            let derivatives = [0, 1].map(|end| {
                let tangent: [f64; 2] = tangents[index + end];
                let cosine = (tangent[0] * chord[0] + tangent[1] * chord[1]) / size;
                let stretch = size * 2.0 / (1.0 + cosine.max(0.0));
                [stretch * tangent[0], stretch * tangent[1]]
            });
            let mut piece = Piece { ends, derivatives, length: 0.0, before };
            piece.length = piece.length_to(1.0);
            let folded = (0..=16).any(|step| {
                let derivative = piece.derivative(f64::from(step) / 16.0);
                derivative[0] * chord[0] + derivative[1] * chord[1] <= 0.0
            });
            if folded || piece.length.is_nan() || piece.length <= 0.0 {
                return Err(Misfit::Folded(index + 1));
            }
            before += piece.length;
            pieces.push(piece);
        }
        Ok(Measured { pieces })
    }

    pub(super) fn length(&self) -> f64 {
        self.pieces.last().map_or(0.0, |last| last.before + last.length)
    }

    pub(super) fn at(&self, distance: f64) -> Station {
        let index = self.pieces.partition_point(|piece| piece.before <= distance).max(1) - 1;
        let piece = &self.pieces[index];
        let t = invert(|t| piece.length_to(t), |t| piece.speed(t), distance - piece.before, 1.0);
        let derivative = piece.derivative(t);
        let size = derivative[0].hypot(derivative[1]);
        Station { point: piece.point(t), normal: [-derivative[1] / size, derivative[0] / size] }
    }
}

/// Unit tangents of the circles through each point and its neighbours; the end points share the circle next to them.
fn tangents(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let last = points.len() - 1;
    (0..=last)
        .map(|index| {
            let middle = index.clamp(1, last - 1);
            let before = step(points[middle - 1], points[middle]);
            let after = step(points[middle], points[middle + 1]);
            // Chords a and b of one circle stand at angles α and β to the tangent between them, α + β is the bend from
            // one to the other, and sin α / sin β = a / b.
            let bend = turn(before.0, after.0);
            let alpha = (before.1 * bend.sin()).atan2(after.1 + before.1 * bend.cos());
            match index {
                0 => rotate(before.0, -alpha),
                _ if index == last => rotate(after.0, bend - alpha),
                _ => rotate(before.0, alpha),
            }
        })
        .collect()
}

/// Unit direction and length from one point to another.
fn step(from: [f64; 2], to: [f64; 2]) -> ([f64; 2], f64) {
    let chord = [to[0] - from[0], to[1] - from[1]];
    let size = chord[0].hypot(chord[1]);
    ([chord[0] / size, chord[1] / size], size)
}

/// Angle from one direction to another, counter-clockwise.
fn turn(from: [f64; 2], to: [f64; 2]) -> f64 {
    (from[0] * to[1] - from[1] * to[0]).atan2(from[0] * to[0] + from[1] * to[1])
}

fn rotate(direction: [f64; 2], angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [direction[0] * cosine - direction[1] * sine, direction[0] * sine + direction[1] * cosine]
}
