//! What critical joints carry while a vehicle passes: extremes, each with the values that go with it.

use super::Case;
use crate::discretise::{Discretised, Origin};
use bridge::Bridge;
use mechanics::limit::{Effect, Ground, Section};

/// An extreme and what goes with it.
#[derive(Debug, Clone, PartialEq)]
pub struct Extreme {
    /// Of what: "largest thrust", "smallest thrust", "outermost thrust", "innermost thrust", "largest shear".
    pub of: &'static str,
    /// Compression [N/m].
    pub thrust: f64,
    /// Distance of the thrust from the middle of the joint [m], outwards positive; on piers to the left.
    pub eccentricity: f64,
    /// Shear [N/m].
    pub shear: f64,
    /// The case.
    pub case: Case,
}

/// A critical joint.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionEnvelope {
    /// Where: "span 1 left springing".
    pub name: String,
    /// Middle of the joint [m].
    pub at: [f64; 2],
    /// Length of the joint between its contact points [m].
    pub depth: f64,
    /// Extremes over all cases.
    pub extremes: Vec<Extreme>,
}

/// A joint that is watched.
#[derive(Debug, Clone)]
pub struct Watched {
    /// Its place among the interfaces.
    pub joint: usize,
    /// Its name.
    pub name: String,
    /// See [`SectionEnvelope`].
    pub at: [f64; 2],
    /// See [`SectionEnvelope`].
    pub depth: f64,
}

/// Springings, quarter points and crowns of every ring, and the feet of piers.
pub fn watched(bridge: &Bridge, d: &Discretised, ground: &Ground) -> Vec<Watched> {
    let mut found = Vec::new();
    for (joint, i) in ground.interfaces().iter().enumerate() {
        let [Some(&a), Some(&b)] = [i.points.first(), i.points.get(1)] else { continue };
        let name = match (d.origins[i.first], d.origins[i.second]) {
            (Origin::Voussoir { span, ring, voussoir }, Origin::Voussoir { span: s, ring: r, voussoir: v })
                if span == s && ring == r =>
            {
                let count = bridge.spans[span].rings[ring].voussoirs;
                let at = voussoir.max(v);
                let named =
                    [("quarter point", count / 4), ("crown", count / 2), ("three-quarter point", count - count / 4)];
                let Some((word, _)) = named.iter().find(|(_, k)| *k == at) else { continue };
                named_joint(bridge, span, ring, word)
            }
            (Origin::Voussoir { span, ring, voussoir }, _) | (_, Origin::Voussoir { span, ring, voussoir })
                if matches!(
                    (d.origins[i.first], d.origins[i.second]),
                    (Origin::Abutment { .. } | Origin::Pier { .. }, _)
                        | (_, Origin::Abutment { .. } | Origin::Pier { .. })
                ) =>
            {
                named_joint(bridge, span, ring, if voussoir == 0 { "left springing" } else { "right springing" })
            }
            (Origin::Foundation { support }, Origin::Pier { .. }) => format!("foot of pier {support}"),
            _ => continue,
        };
        let middle = (a + b) * 0.5;
        found.push(Watched { joint, name, at: [middle.x, middle.y], depth: (b - a).norm() });
    }
    found
}

fn named_joint(bridge: &Bridge, span: usize, ring: usize, word: &str) -> String {
    let rings = bridge.spans[span].rings.len();
    match rings {
        1 => format!("span {} {word}", span + 1),
        _ => format!("span {} ring {} {word}", span + 1, ring + 1),
    }
}

const OF: [&str; 5] = ["largest thrust", "smallest thrust", "outermost thrust", "innermost thrust", "largest shear"];

/// The size by which extremes are compared, in the order of [`OF`].
fn sizes(s: &Section) -> [f64; 5] {
    [s.compression, -s.compression, s.eccentricity, -s.eccentricity, s.shear.abs()]
}

/// Extremes of every watched joint so far: size, section and which case.
#[derive(Debug, Clone)]
pub struct Extremes<K> {
    rows: Vec<[Option<(f64, Section, K)>; 5]>,
}

impl<K: Clone> Extremes<K> {
    /// Nothing seen yet.
    pub fn new(watched: &[Watched]) -> Extremes<K> {
        Extremes { rows: watched.iter().map(|_| [const { None }; 5]).collect() }
    }

    /// Looks at a case; `key` says which.
    pub fn look(&mut self, ground: &Ground, watched: &[Watched], effect: &Effect, key: impl Fn() -> K) {
        for (row, w) in self.rows.iter_mut().zip(watched) {
            let Some(section) = ground.section(effect, 1.0, w.joint) else { continue };
            for (kept, size) in row.iter_mut().zip(sizes(&section)) {
                if kept.as_ref().is_none_or(|k| size > k.0) {
                    *kept = Some((size, section, key()));
                }
            }
        }
    }

    /// Takes over the extremes of cases that come later.
    pub fn merge(&mut self, later: Extremes<K>) {
        for (row, other) in self.rows.iter_mut().zip(later.rows) {
            for (kept, new) in row.iter_mut().zip(other) {
                if let Some(new) = new
                    && kept.as_ref().is_none_or(|k| new.0 > k.0)
                {
                    *kept = Some(new);
                }
            }
        }
    }

    /// The envelopes.
    pub fn told(self, watched: &[Watched], case: impl Fn(&K) -> Case) -> Vec<SectionEnvelope> {
        let each = watched.iter().zip(self.rows).map(|(w, row)| {
            let told = OF.iter().zip(row).filter_map(|(of, kept)| {
                let (_, s, key) = kept?;
                let (thrust, eccentricity, shear) = (s.compression, s.eccentricity, s.shear);
                Some(Extreme { of, thrust, eccentricity, shear, case: case(&key) })
            });
            SectionEnvelope { name: w.name.clone(), at: w.at, depth: w.depth, extremes: told.collect() }
        });
        each.collect()
    }
}
