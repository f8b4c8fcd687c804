//! Bands of equal height on a grid, and the lines between them, each cell as four triangles about its middle. Written here because
//! the crates at hand want even steps and a value everywhere: ranges may be logarithmic, and where a model failed there is a hole.

use crate::geometry::sides;
use crate::sheet::Spot;

/// A grid of heights over places on the sheet.
pub(super) struct Grid<'a> {
    /// Places along x, in order.
    pub x: &'a [f64],
    /// Places along y, in order.
    pub y: &'a [f64],
    /// Height at a place of x and one of y; none is a hole.
    pub height: &'a dyn Fn(usize, usize) -> Option<f64>,
}

/// A corner of a triangle.
#[derive(Clone, Copy)]
struct Corner {
    at: Spot,
    height: f64,
}

impl Grid<'_> {
    /// Polygons by band: below the first level, between two, above the last. The levels rise.
    pub(super) fn bands(&self, levels: &[f64]) -> Vec<Vec<Vec<Spot>>> {
        let mut bands = vec![Vec::new(); levels.len() + 1];
        for triangle in self.triangles() {
            let (low, high) = range(&triangle);
            let first = levels.partition_point(|level| *level <= low);
            let last = levels.partition_point(|level| *level < high).max(first);
            for (band, polygons) in bands.iter_mut().enumerate().take(last + 1).skip(first) {
                let above = band.checked_sub(1).map(|k| levels[k]);
                let below = levels.get(band).copied();
                let mut polygon = triangle.to_vec();
                if let Some(level) = above {
                    polygon = cut(&polygon, |height| height - level);
                }
                if let Some(level) = below {
                    polygon = cut(&polygon, |height| level - height);
                }
                if polygon.len() > 2 {
                    polygons.push(polygon.iter().map(|corner| corner.at).collect());
                }
            }
        }
        bands
    }

    /// Pieces of the line at a level.
    pub(super) fn line(&self, level: f64) -> Vec<[Spot; 2]> {
        let mut pieces = Vec::new();
        for triangle in self.triangles() {
            let mut ends = Vec::new();
            for [a, b] in sides(&triangle) {
                // A corner on the level counts as above it, so that every line enters and leaves.
                if (a.height < level) != (b.height < level) {
                    ends.push(between(a, b, (level - a.height) / (b.height - a.height)).at);
                }
            }
            if let [from, to] = ends[..] {
                pieces.push([from, to]);
            }
        }
        pieces
    }

    fn triangles(&self) -> Vec<[Corner; 3]> {
        let mut out = Vec::new();
        for i in 1..self.x.len() {
            for j in 1..self.y.len() {
                let corner = |i: usize, j: usize| {
                    let height = (self.height)(i, j).filter(|height| height.is_finite());
                    height.map(|height| Corner { at: [self.x[i], self.y[j]], height })
                };
                let corners = [corner(i - 1, j - 1), corner(i, j - 1), corner(i, j), corner(i - 1, j)];
                let known: Vec<Corner> = corners.into_iter().flatten().collect();
                match known[..] {
                    [a, b, c] => out.push([a, b, c]),
                    [a, b, c, d] => {
                        let mean = |value: &dyn Fn(&Corner) -> f64| known.iter().map(value).sum::<f64>() / 4.0;
                        let at = [mean(&|corner| corner.at[0]), mean(&|corner| corner.at[1])];
                        let middle = Corner { at, height: mean(&|corner| corner.height) };
                        out.extend([[a, b, middle], [b, c, middle], [c, d, middle], [d, a, middle]]);
                    }
                    _ => {}
                }
            }
        }
        out
    }
}

fn range(triangle: &[Corner; 3]) -> (f64, f64) {
    let heights = triangle.map(|corner| corner.height);
    (heights.into_iter().fold(f64::INFINITY, f64::min), heights.into_iter().fold(f64::NEG_INFINITY, f64::max))
}

fn between(a: Corner, b: Corner, share: f64) -> Corner {
    let mix = |a: f64, b: f64| a + share * (b - a);
    Corner { at: [mix(a.at[0], b.at[0]), mix(a.at[1], b.at[1])], height: mix(a.height, b.height) }
}

/// The part of a convex polygon on which `inside` is not below zero.
fn cut(polygon: &[Corner], inside: impl Fn(f64) -> f64) -> Vec<Corner> {
    let mut out = Vec::new();
    for [a, b] in sides(polygon) {
        let (here, there) = (inside(a.height), inside(b.height));
        if here >= 0.0 {
            out.push(a);
        }
        if (here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0) {
            out.push(between(a, b, here / (here - there)));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[Spot]) -> f64 {
        let next = |k: usize| polygon[(k + 1) % polygon.len()];
        0.5 * (0..polygon.len()).map(|k| polygon[k][0] * next(k)[1] - next(k)[0] * polygon[k][1]).sum::<f64>().abs()
    }

    #[test]
    fn bands_of_a_plane_have_its_areas_and_cover_the_grid_once() {
        // Height = x on [0, 4] x [0, 3]: the band between 1 and 2.5 is 1.5 wide.
        let x = [0.0, 1.0, 1.5, 4.0];
        let y = [0.0, 2.0, 3.0];
        let height = |i: usize, _: usize| Some(x[i]);
        let grid = Grid { x: &x, y: &y, height: &height };
        let areas: Vec<f64> = grid.bands(&[1.0, 2.5]).iter().map(|band| band.iter().map(|p| area(p)).sum()).collect();
        for (found, wanted) in areas.iter().zip([3.0, 4.5, 4.5]) {
            assert!((found - wanted).abs() < 1e-12, "{areas:?}");
        }
        let line = grid.line(2.5);
        let length: f64 = line.iter().map(|[a, b]| (a[0] - b[0]).hypot(a[1] - b[1])).sum();
        assert!((length - 3.0).abs() < 1e-12 && line.iter().flatten().all(|at| (at[0] - 2.5).abs() < 1e-12));
    }

    #[test]
    fn a_hole_stays_empty() {
        let x = [0.0, 1.0, 2.0];
        let height = |i: usize, j: usize| (i != 1 || j != 1).then_some(i as f64);
        let grid = Grid { x: &x, y: &x, height: &height };
        let covered: f64 = grid.bands(&[0.5]).iter().flatten().map(|p| area(p)).sum();
        // Four cells, of each of which the half that touches the hole is left out.
        assert!((covered - 2.0).abs() < 1e-12, "{covered}");
        let flat = Grid { x: &x, y: &x, height: &|_, _| Some(1.0) };
        assert_eq!(flat.bands(&[1.0]).iter().flatten().map(|p| area(p)).sum::<f64>(), 4.0);
        assert!(flat.line(1.0).is_empty());
    }
}
