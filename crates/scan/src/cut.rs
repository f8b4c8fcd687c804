//! The points near an upright plane, as the means of small squares.

use crate::read::{CloudError, Format, points};
use std::collections::BTreeMap;
use std::io::{Read, Seek};

/// Side of the squares of the section in which points become their mean [m]: finer than stones, coarser than the noise of a scanner.
pub const CELL: f64 = 0.02;

/// Where a cloud is cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Ends of the section in plan, left and right [m].
    pub ends: [[f64; 2]; 2],
    /// Thickness of what is taken, half of it on either side of the plane [m].
    pub thickness: f64,
    /// Levels between which points are taken [m].
    pub levels: [f64; 2],
}

/// What was cut out of a cloud.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Slice {
    /// Points of the whole cloud.
    pub of: u64,
    /// Points in the slab.
    pub taken: u64,
    /// Least and greatest x, y and z of the cloud [m].
    pub extent: [[f64; 2]; 3],
    /// Means of the squares that hold points: along the line from its left end, and the level [m]; by place from left to right, from below.
    pub points: Vec<[f64; 2]>,
}

/// Reads a cloud whose coordinates count `unit` metres, and cuts it; without a cut only its extent is found.
///
/// # Errors
/// A file that is no cloud or ends early.
pub fn cut(
    file: impl Read + Seek + Send + Sync + 'static,
    format: Format,
    unit: f64,
    cut: Option<&Cut>,
) -> Result<Slice, CloudError> {
    let mut slice = Slice { extent: [[f64::INFINITY, f64::NEG_INFINITY]; 3], ..Slice::default() };
    let mut cells: BTreeMap<[i64; 2], ([f64; 2], f64)> = BTreeMap::new();
    points(file, format, &mut |point| {
        let point = point.map(|value| value * unit);
        slice.of += 1;
        for (extent, value) in slice.extent.iter_mut().zip(point) {
            *extent = [extent[0].min(value), extent[1].max(value)];
        }
        if let Some([along, level]) = cut.and_then(|cut| cut.take(point)) {
            slice.taken += 1;
            let (sum, count) = cells.entry([along, level].map(|value| (value / CELL).floor() as i64)).or_default();
            *sum = [sum[0] + along, sum[1] + level];
            *count += 1.0;
        }
    })?;
    slice.points = cells.into_values().map(|(sum, count)| sum.map(|value| value / count)).collect();
    Ok(slice)
}

impl Cut {
    /// Where a point stands in the section, if it is near enough [m].
    fn take(&self, [x, y, z]: [f64; 3]) -> Option<[f64; 2]> {
        let [left, right] = self.ends;
        let line = [right[0] - left[0], right[1] - left[1]];
        let length = line[0].hypot(line[1]);
        let from = [x - left[0], y - left[1]];
        let along = (from[0] * line[0] + from[1] * line[1]) / length;
        let across = (from[1] * line[0] - from[0] * line[1]) / length;
        let near = across.abs() <= 0.5 * self.thickness && (0.0..=length).contains(&along);
        (near && (self.levels[0]..=self.levels[1]).contains(&z)).then_some([along, z])
    }
}
