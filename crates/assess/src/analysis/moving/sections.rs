//! What critical joints carry while a vehicle passes: extremes, each with the values that go with it.

use super::Key;
use bridge::Bridge;
use mechanics::limit::{Effect, Ground, Section};
use outcome::note;
use outcome::vehicles::{Case, Extreme, Of, SectionEnvelope};
use structure::discretise::{Discretised, Origin};

/// A joint that is watched: its place among the interfaces, and its envelope without extremes.
pub(crate) type Watched = (usize, SectionEnvelope);

/// Springings, quarter points and crowns of every ring, and the feet of piers.
pub(crate) fn watched(bridge: &Bridge, d: &Discretised, ground: &Ground) -> Vec<Watched> {
    let mut found = Vec::new();
    for (joint, i) in ground.interfaces.iter().enumerate() {
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
                    (Origin::Abutment { .. } | Origin::Pier { .. } | Origin::AbutmentCourse { .. }, _)
                        | (_, Origin::Abutment { .. } | Origin::Pier { .. } | Origin::AbutmentCourse { .. })
                ) =>
            {
                named_joint(bridge, span, ring, if voussoir == 0 { "left springing" } else { "right springing" })
            }
            (Origin::Foundation { support }, Origin::Pier { .. }) => format!("foot of pier {support}"),
            (Origin::AbutmentGround { support }, Origin::AbutmentCourse { .. }) => {
                format!("foot of the {} abutment", if support == 0 { "left" } else { "right" })
            }
            _ => continue,
        };
        let middle = (a + b) * 0.5;
        let (at, depth, extremes) = ([middle.x, middle.y], (b - a).norm(), Vec::new());
        found.push((joint, SectionEnvelope { name, at, depth, extremes }));
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

/// A thrust at the very edge of its joint lies in it.
const ROUNDING: f64 = 1e-9;

/// What is to be said of thrusts that lie outside their joints; nothing where none does.
pub(crate) fn outside<'a>(envelopes: impl Iterator<Item = &'a SectionEnvelope>) -> note::Moving {
    let all: Vec<&Extreme> = envelopes.flat_map(|envelope| &envelope.extremes).collect();
    note::Moving::Sections { outside: all.iter().filter(|extreme| extreme.outside).count(), of: all.len() }
}

/// The size by which extremes are compared, in the order of [`Of`].
fn sizes(s: &Section) -> [f64; 5] {
    [s.compression, -s.compression, s.eccentricity, -s.eccentricity, s.shear.abs()]
}

/// Sizes tie that differ by less than this share: round-off would choose, as where weights that are alike on either side change the thrust and not the shear.
const TIES: f64 = 1e-9;

/// A size, the section that has it, and of which case.
type Kept = (f64, Section, Key);

/// Keeps the more extreme of two sections: of two that tie, the one with the smaller thrust, which resists shear less.
#[inline]
fn keep(kept: &mut Option<Kept>, new: Kept) {
    let replaces = |(before, known, _): &Kept| match (new.0 - before).abs() <= TIES * before.abs() {
        true => new.1.compression < known.compression * (1.0 - TIES),
        false => new.0 > *before,
    };
    if kept.as_ref().is_none_or(replaces) {
        *kept = Some(new);
    }
}

/// Extremes of every watched joint so far: size, section and which case.
#[derive(Debug, Clone)]
pub(crate) struct Extremes {
    rows: Vec<[Option<Kept>; 5]>,
}

impl Extremes {
    /// Nothing seen yet.
    pub(crate) fn new(watched: &[Watched]) -> Extremes {
        Extremes { rows: watched.iter().map(|_| [const { None }; 5]).collect() }
    }

    /// Looks at a case; `key` says which.
    pub(crate) fn look(&mut self, ground: &Ground, watched: &[Watched], effect: &Effect, key: Key) {
        for (row, (joint, _)) in self.rows.iter_mut().zip(watched) {
            let Some(section) = ground.section(effect, 1.0, *joint) else { continue };
            for (kept, size) in row.iter_mut().zip(sizes(&section)) {
                keep(kept, (size, section, key));
            }
        }
    }

    /// Takes over the extremes of cases that come later.
    pub(crate) fn merge(&mut self, later: Extremes) {
        for (row, other) in self.rows.iter_mut().zip(later.rows) {
            for (kept, new) in row.iter_mut().zip(other) {
                new.into_iter().for_each(|new| keep(kept, new));
            }
        }
    }

    pub(crate) fn told(self, watched: &[Watched], case: impl Fn(&Key) -> Case) -> Vec<SectionEnvelope> {
        let each = watched.iter().zip(self.rows).map(|((_, envelope), row)| {
            let told = Of::ALL.iter().zip(row).filter_map(|(&of, kept)| {
                let (_, s, key) = kept?;
                let (thrust, eccentricity, shear) = (s.compression, s.eccentricity, s.shear);
                let outside = eccentricity.abs() > 0.5 * envelope.depth * (1.0 + ROUNDING);
                Some(Extreme { of, thrust, eccentricity, outside, shear, case: case(&key) })
            });
            SectionEnvelope { extremes: told.collect(), ..envelope.clone() }
        });
        each.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::vehicles::tests::plan;
    use super::super::super::vehicles::vehicle_sweep;
    use super::{Key, Section, keep};
    use crate::samples;
    use bridge::{Method, Ring, Span};
    use mechanics::watch::Unwatched;
    use outcome::note::{self, Note};
    use outcome::published::vehicle_sections_table;
    use outcome::vehicles::VehicleSweep;

    /// A span of 6 m with a ring of this thickness [m] under one vehicle.
    fn swept(thickness: f64, vehicle: &str) -> VehicleSweep {
        let mut b = samples::bridgemill();
        b.cover.layers = vec![samples::fill(0.478, 1890.0)];
        b.plan.method = Method::Limit;
        let ring = Ring { crown_thickness: thickness, springing_thickness: thickness, voussoirs: 21 };
        b.spans = vec![Span { span: 6.0, rise: 1.5, rings: vec![ring], ..b.spans[0].clone() }];
        b.sweep = Some(plan(&[vehicle]));
        vehicle_sweep(&b, &mut Unwatched).unwrap()
    }

    /// Round-off does not choose between sections with the same shear: the one that is pressed less counts, whichever comes first.
    #[test]
    fn of_two_sections_with_the_same_shear_the_smaller_thrust_counts() {
        let section = |compression, shear| Section { compression, shear, eccentricity: 0.1 };
        let [weak, strong] = [section(100.0, 20.0), section(120.0, 20.0 * (1.0 + 1e-12))];
        let replaces = |new: Section, known: Section| {
            let mut kept = Some((known.shear, known, Key::at(0, 0.0)));
            keep(&mut kept, (new.shear, new, Key::at(1, 0.0)));
            kept.is_some_and(|(_, _, key)| key.drive == 1)
        };
        assert!(replaces(weak, strong) && !replaces(strong, weak));
        let more = section(150.0, 20.0 * (1.0 + 1e-6));
        assert!(replaces(more, weak) && !replaces(weak, more));
    }

    /// An eccentricity beyond the joint is that of an elastic ring that takes tension: it says so where it stands, and once in words.
    #[test]
    fn a_thrust_outside_its_joint_is_told_at_its_value_and_in_words() {
        let thin = swept(0.30, "hb-45");
        let table = vehicle_sections_table(&thin);
        let heads: Vec<&str> = table.lines().next().unwrap().split(',').collect();
        let column = |name: &str| heads.iter().position(|head| *head == name).unwrap();
        let [depth, eccentricity, flag] = ["depth_m", "eccentricity_m", "outside_section"].map(column);
        let mut told = [0, 0];
        for line in table.lines().skip(1) {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |at: usize| cells[at].parse::<f64>().unwrap();
            let outside = number(eccentricity).abs() > 0.5 * number(depth) + 1e-6;
            assert_eq!(cells[flag], if outside { "true" } else { "false" }, "{line}");
            told[usize::from(outside)] += 1;
        }
        let [inside, outside] = told;
        let of_thin = note::Moving::Sections { outside, of: inside + outside };
        assert!(inside > 0 && outside > 0 && thin.assumptions.contains(&of_thin.clone().into()), "{of_thin}");
        let thick = swept(0.90, "cs454-single");
        assert!(thick.vehicles[0].sections.iter().flat_map(|s| &s.extremes).all(|e| !e.outside));
        let none = |said: &Note| matches!(said, Note::Moving(note::Moving::Sections { outside: 0, .. }));
        assert!(thick.assumptions.iter().any(none));
    }
}
