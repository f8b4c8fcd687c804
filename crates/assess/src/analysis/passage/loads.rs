//! From the train's position to forces on the fill: sleepers' reactions times their patterns of pressure.
//!
//! Whatever stands on the track, the load is `sum r_s q_s`: `q_s` is the pattern of one sleeper, nodal forces of a unit force,
//! and `r_s` its reaction [N/m]. The patterns never change, so that a linear part of the bridge answers each once.

use super::rail::Rail;
use bridge::passage::Track;
use bridge::train::Axle;
use outcome::picture::Point;

/// Nodal forces: an index into the nodes of the surface and a share of the force.
pub type Pattern = Vec<(usize, f64)>;

/// The train on its track above a bridge.
#[derive(Debug, Clone, PartialEq)]
pub struct TrackLoads {
    rail: Rail,
    axles: Vec<Axle>,
    /// Width that carries an axle [m].
    width: f64,
    /// Position of the sleeper that sleepers are counted from [m].
    origin: f64,
    /// Number of the first sleeper whose pressure reaches the surface.
    first: i64,
    /// Middle of each such sleeper [m].
    pub sleepers: Vec<f64>,
    /// Vertical nodal forces of a unit force, downwards positive, of each sleeper. What of a sleeper's pressure falls beside
    /// the surface is carried by the ground.
    pub patterns: Vec<Pattern>,
    /// Length on which a sleeper presses at the top of the fill [m].
    pub pressed: f64,
}

impl TrackLoads {
    /// The track above `surface`, the nodes of the top of the fill from left to right [m]; `middle` of the bridge [m], where a
    /// sleeper lies.
    pub fn new(track: &Track, axles: &[Axle], width: f64, surface: &[Point], middle: f64) -> TrackLoads {
        let pressed = track.sleeper_breadth + 2.0 * track.ballast_depth / track.ballast_slope;
        let (left, right) = (surface.first().map_or(0.0, |p| p[0]), surface.last().map_or(0.0, |p| p[0]));
        let number = |x: f64| (x - middle) / track.sleeper_spacing;
        let first = number(left - 0.5 * pressed).ceil() as i64;
        let last = number(right + 0.5 * pressed).floor() as i64;
        let sleepers: Vec<f64> = (first..=last).map(|n| middle + track.sleeper_spacing * n as f64).collect();
        let patterns = sleepers.iter().map(|x| strip(surface, x - 0.5 * pressed, x + 0.5 * pressed)).collect();
        let (axles, rail) = (axles.to_vec(), Rail::new(track));
        TrackLoads { rail, axles, width, origin: middle, first, sleepers, patterns, pressed }
    }

    /// Reaction of each sleeper [N per metre of width] while the first axle stands at `front` [m].
    pub fn reactions(&self, front: f64) -> Vec<f64> {
        let mut reactions = vec![0.0; self.sleepers.len()];
        for axle in &self.axles {
            let (first, shares) = self.rail.shares(front - axle.offset - self.origin);
            let from = (self.first - first).max(0);
            for (k, share) in shares.iter().enumerate().skip(from as usize) {
                let Some(reaction) = reactions.get_mut((first + k as i64 - self.first) as usize) else { break };
                *reaction += share * axle.force / self.width;
            }
        }
        reactions
    }

    /// Vertical nodal forces on the surface, downwards positive [N per metre of width].
    pub fn forces(&self, front: f64, nodes: usize) -> Vec<f64> {
        let mut forces = vec![0.0; nodes];
        for (reaction, pattern) in self.reactions(front).iter().zip(&self.patterns) {
            for &(node, share) in pattern {
                forces[node] += reaction * share;
            }
        }
        forces
    }

    /// Places and forces [N] of the axles above `from` to `to` [m].
    pub fn axles_above(&self, front: f64, from: f64, to: f64) -> Vec<(f64, f64)> {
        let place = |axle: &Axle| (front - axle.offset, axle.force);
        self.axles.iter().map(place).filter(|(x, _)| (from..=to).contains(x)).collect()
    }

    /// The heaviest axle by itself on the same track, and its force [N].
    pub fn heaviest_alone(&self) -> Option<(TrackLoads, f64)> {
        let heaviest = self.axles.iter().max_by(|a, b| a.force.total_cmp(&b.force))?;
        let alone = Axle { offset: 0.0, ..*heaviest };
        Some((TrackLoads { axles: vec![alone], ..self.clone() }, alone.force))
    }

    /// Distance from the first axle to the last [m].
    pub fn wheelbase(&self) -> f64 {
        self.axles.last().map_or(0.0, |axle| axle.offset)
    }
}

/// Consistent nodal forces of a unit force spread evenly over `from` to `to` (measured horizontally), on a chain of nodes from
/// left to right: forces and moment are those of the pressure, as far as it lies on the chain.
pub fn strip(chain: &[Point], from: f64, to: f64) -> Pattern {
    let mut pattern: Pattern = Vec::new();
    let mut add = |node: usize, share: f64| match pattern.last_mut() {
        Some((last, sum)) if *last == node => *sum += share,
        _ => pattern.push((node, share)),
    };
    for (k, pair) in chain.windows(2).enumerate() {
        let (start, end) = (pair[0][0], pair[1][0]);
        let (a, b) = (from.max(start), to.min(end));
        if b <= a || end <= start {
            continue;
        }
        let covered = (b - a) / (to - from);
        let towards = (0.5 * (a + b) - start) / (end - start);
        add(k, covered * (1.0 - towards));
        add(k + 1, covered * towards);
    }
    pattern
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track() -> Track {
        Track {
            rail_bending_stiffness: 4.47e6,
            track_modulus: 30e6,
            sleeper_spacing: 0.6,
            sleeper_breadth: 0.25,
            sleeper_length: 2.75,
            ballast_depth: 0.25,
            ballast_slope: 2.0,
            dead_load: 8e3,
            effective_width: None,
        }
    }

    /// A surface with uneven steps.
    fn surface() -> Vec<Point> {
        (0..=400).map(f64::from).map(|k| [-20.0 + 0.1 * k + 0.03 * (1.7 * k).sin(), 3.0]).collect()
    }

    #[test]
    fn a_strip_keeps_force_and_moment() {
        let chain = surface();
        for (from, to) in [(-3.21, -2.9), (0.0, 1.0), (5.0, 5.001), (-20.0, 19.9)] {
            let pattern = strip(&chain, from, to);
            let force: f64 = pattern.iter().map(|(_, f)| f).sum();
            let moment: f64 = pattern.iter().map(|(node, f)| f * chain[*node][0]).sum();
            // Sums of some hundred rounded terms.
            assert!((force - 1.0).abs() < 1e-12, "{force}");
            assert!((moment - 0.5 * (from + to)).abs() < 1e-11, "{moment}");
            assert!(pattern.windows(2).all(|pair| pair[0].0 < pair[1].0), "each node once");
        }
        assert!(strip(&chain, 50.0, 51.0).is_empty());
        let half: f64 = strip(&chain, 19.0, chain[400][0] + (chain[400][0] - 19.0)).iter().map(|(_, f)| f).sum();
        assert!((half - 0.5).abs() < 1e-12, "the half beside the surface is left out: {half}");
    }

    /// A train in the middle of a long surface: the forces on the nodes are its weight, and stand where its axles stand.
    #[test]
    fn nodal_forces_balance_the_axles() {
        let axles = [(200e3, 0.0), (180e3, 1.85), (220e3, 5.3)].map(|(force, offset)| Axle { force, offset });
        let chain = surface();
        let loads = TrackLoads::new(&track(), &axles, 4.87, &chain, 0.37);
        for front in [-2.0, 0.0, 1.234] {
            let forces = loads.forces(front, chain.len());
            let force: f64 = forces.iter().sum();
            let moment: f64 = forces.iter().zip(&chain).map(|(f, p)| f * p[0]).sum();
            let (wanted, arm) = (600e3 / 4.87, axles.iter().map(|a| a.force * (front - a.offset)).sum::<f64>() / 4.87);
            // What reaches beyond the ends, 12 characteristic lengths away, is exp(-12) of it.
            assert!((force / wanted - 1.0).abs() < 1e-4, "{force} {wanted}");
            assert!((moment - arm).abs() < 1e-3 * wanted, "{moment} {arm}");
        }
    }

    #[test]
    fn a_train_beside_the_bridge_does_not_load_it() {
        let axles = [Axle { force: 200e3, offset: 0.0 }];
        let loads = TrackLoads::new(&track(), &axles, 4.87, &surface(), 0.0);
        for front in [-300.0, 300.0, -60.0, 60.0] {
            assert!(loads.reactions(front).iter().all(|r| r.abs() < 1e-6), "{front}");
        }
        assert_eq!(loads.axles_above(0.5, 0.0, 1.0), [(0.5, 200e3)]);
    }
}
