//! The simplex method where many unknowns lie between bounds of their own: forces that answer movement.
//!
//! In a mechanism most of these forces stand at one of their bounds, as their point moves one way or the other. With a start
//! from another load their bounds are known but for a few. So they are held there, a program of the few other unknowns is
//! solved, and forces whose bound the mechanism contradicts are set free, until none is left. What is found is the corner of
//! the whole program, with the multipliers of all rows. Without a start all stand at their least, then at their most.

use super::rows::Rows;
use super::simplex::{Corner, Ended, Member, Start, greatest};
use crate::watch::CancelToken;

/// The last unknowns of a program: `-x <= b` and `x <= b` stand one after the other for each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Bounded {
    /// Row of the first bound.
    pub first: usize,
    /// How many unknowns.
    pub count: usize,
}

/// Where an unknown stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum At {
    Least,
    Most,
    Free,
}

/// Rounds in which unknowns are set free; more are a sign that the start is no good.
const ROUNDS: usize = 8;
/// Multipliers of a bound below this, relative to all, do not contradict it.
const CONTRADICTS: f64 = 1e-10;

/// The best corner, as [`greatest`] finds it, from a basis that was best for another load.
pub(super) fn greatest_between(
    rows: &Rows,
    bounded: Bounded,
    last: &[f64],
    start: Option<&Start>,
    token: &CancelToken,
) -> Ended {
    if bounded.count == 0 {
        return greatest(rows, last, start, token);
    }
    let held = Held { rows, bounded, last, token };
    let starts =
        start.map(|start| start.members.clone()).into_iter().chain([held.blank(At::Least), held.blank(At::Most)]);
    starts.map(|start| held.from(&start)).find_map(|ended| ended).unwrap_or_else(|| greatest(rows, last, None, token))
}

struct Held<'a> {
    rows: &'a Rows,
    bounded: Bounded,
    last: &'a [f64],
    token: &'a CancelToken,
}

/// A program of fewer unknowns, with the place of each of its rows in the whole one.
struct Few {
    rows: Rows,
    last: Vec<f64>,
    places: Vec<usize>,
    /// Which of the bounded unknowns it has.
    free: Vec<usize>,
}

impl Held<'_> {
    fn bound(&self, j: usize, at: At) -> usize {
        self.bounded.first + 2 * j + usize::from(at == At::Most)
    }

    /// Which bound a row is.
    fn bound_of(&self, row: usize) -> Option<(usize, At)> {
        let k = row.checked_sub(self.bounded.first).filter(|k| *k < 2 * self.bounded.count)?;
        Some((k / 2, if k % 2 == 1 { At::Most } else { At::Least }))
    }

    /// A start that knows of no mechanism.
    fn blank(&self, at: At) -> Vec<Member> {
        let plain = (0..self.plain()).map(Member::Fixed);
        plain.chain([Member::Far]).chain((0..self.bounded.count).map(|j| Member::Row(self.bound(j, at)))).collect()
    }

    /// None where the start leads nowhere.
    fn from(&self, start: &[Member]) -> Option<Ended> {
        let mut at = vec![At::Free; self.bounded.count];
        let mut members = Vec::with_capacity(start.len());
        for &member in start {
            match member {
                Member::Row(k) => match self.bound_of(k) {
                    Some((j, bound)) if at[j] == At::Free => at[j] = bound,
                    _ => members.push(member),
                },
                _ => members.push(member),
            }
        }
        let mut pivots = 0;
        for _ in 0..ROUNDS {
            let few = self.few(&at);
            let own = few.own(&members, self)?;
            let corner = match greatest(&few.rows, &few.last, Some(&Start::of(own)), self.token) {
                Ended::Best(corner) => corner,
                Ended::Unbounded => return Some(Ended::Unbounded),
                Ended::Lost => return None,
            };
            pivots += corner.pivots;
            members = corner.start.members.iter().map(|&m| few.whole(m, self)).collect();
            let multipliers = self.multipliers(&few, &corner);
            let largest = corner.basis.iter().map(|m| m.1).fold(0.0, f64::max);
            let mut contradicted = false;
            for (j, &y) in multipliers.iter().enumerate() {
                let other = match at[j] {
                    At::Least if y < -CONTRADICTS * largest => At::Most,
                    At::Most if y > CONTRADICTS * largest => At::Least,
                    _ => continue,
                };
                // Free, with the bound on the other side in the basis: its multiplier has the right sign.
                at[j] = At::Free;
                members.push(Member::Row(self.bound(j, other)));
                contradicted = true;
            }
            if !contradicted {
                return Some(Ended::Best(self.assembled(&few, &at, &corner, members, (&multipliers, pivots))));
            }
        }
        None
    }

    fn plain(&self) -> usize {
        self.rows.width - self.bounded.count
    }

    /// Where an unknown that is held stands.
    fn value(&self, j: usize, at: At) -> f64 {
        let b = self.rows.b[self.bound(j, at)];
        if at == At::Most { b } else { -b }
    }

    fn few(&self, at: &[At]) -> Few {
        let plain = self.plain();
        let free: Vec<usize> = (0..at.len()).filter(|&j| at[j] == At::Free).collect();
        let held: Vec<(usize, f64)> = (0..at.len())
            .filter(|&j| at[j] != At::Free)
            .map(|j| (plain + j, self.value(j, at[j])))
            .filter(|held| held.1 != 0.0)
            .collect();
        let mut few = Few {
            rows: Rows::new(plain + free.len()),
            last: Vec::with_capacity(self.last.len()),
            places: Vec::with_capacity(self.last.len()),
            free,
        };
        for k in 0..self.rows.b.len() {
            if self.bound_of(k).is_some_and(|(j, _)| at[j] != At::Free) {
                continue;
            }
            let entry = |unknown| self.rows.entry(k, unknown);
            let own = self.rows.row(k).take(plain).chain(few.free.iter().map(|&j| entry(plain + j)));
            few.rows.push(own, self.rows.b[k] - held.iter().map(|&(c, x)| entry(c) * x).sum::<f64>());
            few.last.push(self.last[k]);
            few.places.push(k);
        }
        few
    }

    /// What the multipliers of a corner leave for the bounds of each unknown that is held.
    fn multipliers(&self, few: &Few, corner: &Corner) -> Vec<f64> {
        let plain = self.plain();
        let mut sums = vec![0.0; self.bounded.count];
        for &(k, y) in corner.basis.iter().filter(|m| m.1 != 0.0) {
            for (sum, a) in sums.iter_mut().zip(self.rows.row(few.places[k]).skip(plain)) {
                *sum += y * a;
            }
        }
        few.free.iter().for_each(|&j| sums[j] = 0.0);
        sums
    }

    fn assembled(
        &self,
        few: &Few,
        at: &[At],
        corner: &Corner,
        mut members: Vec<Member>,
        (multipliers, pivots): (&[f64], usize),
    ) -> Corner {
        let plain = self.plain();
        let mut z = corner.z[..plain].to_vec();
        let mut free = corner.z[plain..].iter();
        let mut basis: Vec<(usize, f64)> = corner.basis.iter().map(|&(k, y)| (few.places[k], y)).collect();
        for (j, &at) in at.iter().enumerate() {
            if at == At::Free {
                z.extend(free.next());
                continue;
            }
            z.push(self.value(j, at));
            let row = self.bound(j, at);
            basis.push((row, multipliers[j].abs()));
            members.push(Member::Row(row));
        }
        z.extend(corner.z.last());
        Corner { z, basis, start: Start::of(members), upper: corner.upper, pivots }
    }
}

impl Few {
    /// Members of a basis in its own terms; none where one of them is not among its rows or unknowns.
    fn own(&self, members: &[Member], held: &Held<'_>) -> Option<Vec<Member>> {
        let plain = held.plain();
        let own = |member: &Member| match *member {
            Member::Row(k) => self.places.binary_search(&k).ok().map(Member::Row),
            Member::Fixed(j) if j < plain => Some(Member::Fixed(j)),
            Member::Fixed(j) => self.free.binary_search(&(j - plain)).ok().map(|k| Member::Fixed(plain + k)),
            Member::Far => Some(Member::Far),
        };
        let own: Vec<Member> = members.iter().map(own).collect::<Option<_>>()?;
        (own.len() == self.rows.width + 1).then_some(own)
    }

    fn whole(&self, member: Member, held: &Held<'_>) -> Member {
        let plain = held.plain();
        match member {
            Member::Row(k) => Member::Row(self.places[k]),
            Member::Fixed(j) if j >= plain => Member::Fixed(plain + self.free[j - plain]),
            other => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Random programs with one free and several bounded unknowns: from the basis of one load to the corner of another.
    #[test]
    fn what_is_held_changes_nothing() {
        let mut seed = 7u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / (1u64 << 31) as f64 - 0.5
        };
        let (plain, count, many) = (2, 12, 30);
        let mut rows = Rows::new(plain + count);
        for _ in 0..many {
            let row: Vec<f64> = (0..rows.width).map(|_| random()).collect();
            rows.push(row, 1.0 + random());
        }
        let bounded = Bounded { first: many, count };
        for j in 0..count {
            for sign in [-1.0, 1.0] {
                let mut row = vec![0.0; rows.width];
                row[plain + j] = sign;
                rows.push(row, if sign < 0.0 { 0.1 } else { 0.3 });
            }
        }
        let mut start: Option<Start> = None;
        for _ in 0..50 {
            let mut last: Vec<f64> = (0..many).map(|_| random()).collect();
            last.resize(many + 2 * count, 0.0);
            let (Ended::Best(exact), Ended::Best(held)) = (
                greatest(&rows, &last, None, &CancelToken::default()),
                greatest_between(&rows, bounded, &last, start.as_ref(), &CancelToken::default()),
            ) else {
                continue;
            };
            let [a, b] = [&exact, &held].map(|c| *c.z.last().unwrap());
            assert!((a - b).abs() < 1e-9 * (1.0 + a.abs()), "{a} {b}");
            assert!((held.upper - a).abs() < 1e-9 * (1.0 + a.abs()));
            // The multipliers of all rows balance in every unknown.
            for j in 0..rows.width {
                let sum: f64 = held.basis.iter().map(|&(k, y)| y * rows.entry(k, j)).sum();
                assert!(sum.abs() < 1e-8, "{sum}");
            }
            assert_eq!(held.start.members.len(), rows.width + 1);
            start = Some(held.start);
        }
        assert!(start.is_some());
    }
}
