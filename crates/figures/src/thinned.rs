//! Long records with no more points than are seen.

use crate::sheet::{Area, Spot};

/// Columns of a drawing: more points than a few in each are not seen.
const COLUMNS: f64 = 0.4;

/// The least and the greatest value in each column, in their order, where there are many points.
pub(crate) fn thinned(spots: &[Spot]) -> Vec<Spot> {
    if spots.len() < 4000 {
        return spots.to_vec();
    }
    let mut out: Vec<Spot> = Vec::new();
    let mut start = 0;
    while start < spots.len() {
        let column = (spots[start][0] / COLUMNS).floor();
        let length = spots[start..].iter().take_while(|spot| (spot[0] / COLUMNS).floor() == column).count().max(1);
        let part = &spots[start..start + length];
        if let Some(Area { top, bottom, .. }) = Area::around(part) {
            let mut kept: Vec<&Spot> = part.iter().filter(|spot| spot[1] == top || spot[1] == bottom).collect();
            kept.dedup();
            out.extend([kept.first(), kept.last()].into_iter().flatten().map(|spot| **spot));
        }
        start += length;
    }
    out
}
