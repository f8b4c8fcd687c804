//! Piers and abutments as four-sided regions.
//!
//! A skewback that lies flat is part of the upper side, so that lines run straight down from it; a steep one is part of the
//! flank, so that rows run into it.

use super::patch::{Points, between, growing, spaced};
use mechanics::plane::{Vec2, vec2};

/// Skewbacks steeper than this [rad] belong to the flank: 50 degrees.
const STEEP: f64 = 50.0 / 180.0 * std::f64::consts::PI;

/// One flank of a support.
pub(super) struct Flank {
    /// Where a ring springs, the nodes of its skewback from the intrados to the extrados; one point at the top of an abutment's vertical back.
    pub points: Vec<Vec2>,
    /// Where it stands on the base [m].
    pub base: f64,
}

impl Flank {
    /// Its upper end: where the fill's lower edge begins.
    fn head(&self) -> Vec2 {
        self.points[self.points.len() - 1]
    }
    /// Steps of the skewback that belong to the flank, and those that belong to the upper side.
    fn steps(&self) -> [usize; 2] {
        let (a, b) = (self.points[0], self.head());
        let steps = self.points.len() - 1;
        if (b.y - a.y).atan2((b.x - a.x).abs()) > STEEP { [steps, 0] } else { [0, steps] }
    }
}

/// A support as points, and where on its sides the skewbacks lie.
pub(super) struct Support {
    pub points: Points,
    /// Of the left and the right flank: steps of the skewback in the flank, and in the upper side.
    steps: [[usize; 2]; 2],
}

/// A pier or an abutment between two flanks on a base at level `low`, with `across` elements on its top and elements of about
/// `size` [m] below.
pub(super) fn support(left: &Flank, right: &Flank, low: f64, across: usize, size: f64) -> Support {
    let flanks = [left, right];
    let steps = flanks.map(Flank::steps);
    let height = flanks.map(|f| f.points[0].y - low);
    // Distances down from the shoulder: elements grow towards the base.
    let down = growing(height[0].max(height[1]), 1.2 * size, 1.12, 3.0 * size);
    let rows = down.len() - 1 + steps[0][0].max(steps[1][0]);
    let mut sides = [0, 1].map(|k| {
        let flank = flanks[k];
        // It goes straight down to the base from its lower end.
        let (foot, shoulder) = (vec2(flank.base, low), flank.points[0]);
        let mut side: Vec<Vec2> = rise(&down, rows - steps[k][0]).into_iter().map(|t| mix(foot, shoulder, t)).collect();
        side.extend(&flank.points[1..=steps[k][0]]);
        side
    });
    // A back has its rows at the levels of a skewback in the other flank.
    for k in [0, 1] {
        if flanks[k].points.len() == 1 && steps[1 - k][0] > 0 {
            sides[k] = sides[1 - k].iter().map(|p| vec2(flanks[k].base, p.y)).collect();
        }
    }
    let even: Vec<f64> = (0..=across).map(|k| k as f64).collect();
    let mut top = spaced(left.head(), right.head(), &even);
    if steps[0][1] > 0 {
        top = left.points.iter().copied().chain(top.into_iter().skip(1)).collect();
    }
    if steps[1][1] > 0 {
        top.extend(right.points.iter().rev().skip(1));
    }
    let [left, right] = sides;
    let (first, last) = (top[0].x, top[top.len() - 1].x);
    let share = |p: &Vec2| (p.x - first) / (last - first);
    let bottom: Vec<Vec2> = top.iter().map(|p| mix(left[0], right[0], share(p))).collect();
    Support { points: between(&bottom, &top, &left, &right), steps }
}

/// Shares of the height, from 0 to 1, of `rows` rows whose heights follow `down`, distances from the top.
fn rise(down: &[f64], rows: usize) -> Vec<f64> {
    let (steps, height) = (down.len() - 1, down[down.len() - 1]);
    let depth = |share: f64| {
        let at = share * steps as f64;
        let k = (at.floor() as usize).min(steps - 1);
        (down[k] + (down[k + 1] - down[k]) * (at - k as f64)) / height
    };
    (0..=rows).map(|k| if k == rows { 1.0 } else { 1.0 - depth(1.0 - k as f64 / rows as f64) }).collect()
}

fn mix(a: Vec2, b: Vec2, t: f64) -> Vec2 {
    if t == 1.0 { b } else { a + (b - a) * t }
}

impl Support {
    /// What stands on a skewback, from the intrados to the extrados; `side` is 0 for the left flank and 1 for the right one.
    pub(super) fn skewback<T: Copy>(&self, grid: &[Vec<T>], side: usize) -> Vec<T> {
        let (rows, columns) = (grid.len() - 1, grid[0].len() - 1);
        let [flank, top] = self.steps[side];
        match (side, flank > 0) {
            (0, true) => (rows - flank..=rows).map(|i| grid[i][0]).collect(),
            (_, true) => (rows - flank..=rows).map(|i| grid[i][columns]).collect(),
            (0, false) => grid[rows][..=top].to_vec(),
            (_, false) => grid[rows][columns - top..].iter().rev().copied().collect(),
        }
    }

    /// What stands on the upper face between the flanks' heads, from left to right.
    pub(super) fn top<T: Copy>(&self, grid: &[Vec<T>]) -> Vec<T> {
        let row = &grid[grid.len() - 1];
        row[self.steps[0][1]..row.len() - self.steps[1][1]].to_vec()
    }
}
