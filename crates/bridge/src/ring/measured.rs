//! A smooth curve through surveyed points: between two points a cubic, its tangent at each point that of the circle
//! through the point and its two neighbours. A circle surveyed closely comes out as a circle; no point moves its
//! surroundings beyond the two pieces on either side.

use std::sync::Arc;

use super::invert::invert;
use super::quadrature::quadrature;
use super::{Curve, Form, Misfit, Shape, Station};
use crate::card::Field;
use crate::cards::*;

pub(super) const NEEDS: [bool; 2] = [false, false];
pub(super) const KEYS: &[Field] = &[points(
    "points",
    "surveyed points of the intrados, from the left to the right springing; the first is the origin",
    "[[\"0 m\", \"0 m\"], [\"2.0 m\", \"1.1 m\"], [\"4.0 m\", \"0 m\"]]",
)
.only("profile", &[Shape::Measured.word()])];

/// Moves the points to the left springing; span and rise are theirs.
pub(super) fn size(_: Option<f64>, _: Option<f64>, points: &mut Vec<[f64; 2]>) -> Option<(f64, f64)> {
    let origin = points.first().copied().unwrap_or_default();
    *points = points.iter().map(|point| [point[0] - origin[0], point[1] - origin[1]]).collect();
    Some((points.last().map_or(0.0, |last| last[0]), points.iter().map(|point| point[1]).fold(0.0, f64::max)))
}

pub(super) fn curve(span: f64, _: f64, points: &[[f64; 2]]) -> Result<Form, Misfit> {
    check(points)?;
    let highest = points.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1]));
    let crown = highest.map_or(0.5 * span, |point| point[0]);
    Ok(Form::Whole { curve: Arc::new(Measured::new(points)?), crown })
}

pub(super) fn sloping(span: f64, rise: f64, _: f64, points: &[[f64; 2]]) -> Result<Form, Misfit> {
    curve(span, rise, points)
}

fn misfit(entry: Option<usize>, message: impl Into<Box<str>>, label: &str, help: &'static str) -> Misfit {
    Misfit { entry, ..Misfit::new("B204", "points", message, label, help) }
}

/// Whether the points can be an intrados.
fn check(points: &[[f64; 2]]) -> Result<(), Misfit> {
    if points.len() < 3 {
        return Err(misfit(
            None,
            "a measured profile needs at least three points",
            "left springing, one or more in between, right springing",
            "add points of the survey; ten or more give a good curve",
        ));
    }
    if let Some(index) = (1..points.len()).find(|index| !(points[*index][0] > points[index - 1][0])) {
        return Err(misfit(
            Some(index),
            format!("measured point {} does not lie to the right of the one before", index + 1),
            "points run from the left to the right springing",
            "sort the points by their first coordinate and remove duplicates",
        ));
    }
    let last = points.len() - 1;
    let chord = |x: f64| {
        points[0][1] + (points[last][1] - points[0][1]) * ((x - points[0][0]) / (points[last][0] - points[0][0]))
    };
    if let Some(index) = (1..last).find(|index| !(points[*index][1] > chord(points[*index][0]))) {
        return Err(misfit(
            Some(index),
            format!("measured point {} is not above the springings", index + 1),
            "an intrados lies above the line between its springings",
            "check the sign of the heights: up is positive",
        ));
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
        quadrature(t, 4, |t| self.speed(t))
    }
}

/// The whole curve.
#[derive(Debug, Clone, PartialEq)]
struct Measured {
    pieces: Vec<Piece>,
}

impl Measured {
    fn new(points: &[[f64; 2]]) -> Result<Measured, Misfit> {
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
                return Err(misfit(
                    Some(index + 1),
                    format!("no smooth curve leads to measured point {}", index + 2),
                    "the points turn too sharply here",
                    "check this point, or add points around it",
                ));
            }
            before += piece.length;
            pieces.push(piece);
        }
        Ok(Measured { pieces })
    }
}

impl Curve for Measured {
    fn length(&self) -> f64 {
        self.pieces.last().map_or(0.0, |last| last.before + last.length)
    }

    fn at(&self, distance: f64) -> Station {
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
                0 => upright(rotate(before.0, -alpha)),
                _ if index == last => upright(rotate(after.0, bend - alpha)),
                _ => rotate(before.0, alpha),
            }
        })
        .collect()
}

/// The tangent at a springing: each point lies further right than the one before, so a curve that leans beyond the vertical there was not
/// measured, and is no more than the scatter of the points.
fn upright(tangent: [f64; 2]) -> [f64; 2] {
    if tangent[0] < 0.0 { [0.0, tangent[1].signum()] } else { tangent }
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
