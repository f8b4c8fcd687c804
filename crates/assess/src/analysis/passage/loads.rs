//! From the place of the first axle to forces on the fill: amplitudes times patterns of pressure.
//!
//! Whatever stands on the bridge, the load is `sum r_s q_s`: `q_s` are nodal forces of a unit force and `r_s` its size [N/m]. On a track `q_s` is
//! the pressure below a sleeper and `r_s` its reaction; on a road `q_s` is a force on one node of the surface, and `r_s` what the wheels bring onto it.
//! The patterns never change, so that a linear part of the bridge answers each once. Of loads at rest `q_s` is all that stands in position `s`, and `r_s`
//! is one there and zero elsewhere.

use super::rail::Rail;
use bridge::passage::{Heading, Track, Wheels};
use bridge::train::Axle;
use outcome::picture::Point;

/// Nodal forces: an index into the nodes of the surface and a share of the force.
pub type Pattern = Vec<(usize, f64)>;

/// What crosses, above a bridge.
#[derive(Debug, Clone, PartialEq)]
pub struct MovingLoads {
    on: On,
    axles: Vec<Axle>,
    /// 1 where it drives to the right, -1 to the left.
    sign: f64,
    /// Width that carries an axle [m].
    width: f64,
    /// From where to where an axle loads the surface [m].
    pub reach: [f64; 2],
    /// Vertical nodal forces of a unit force, downwards positive. What of a pressure falls beside the surface is carried by the ground.
    pub patterns: Vec<Pattern>,
    /// Length on which a sleeper or a wheel presses at the top of what is modelled [m].
    pub pressed: f64,
}

/// What axles roll on.
#[derive(Debug, Clone, PartialEq)]
enum On {
    Track {
        rail: Rail,
        /// Position of the sleeper that sleepers are counted from [m].
        origin: f64,
        /// Number of the first sleeper whose pressure reaches the surface.
        first: i64,
    },
    /// The nodes of the surface [m].
    Road(Vec<Point>),
    /// Loads at rest, a pattern for each position: names of the positions.
    Rest(Vec<String>),
}

/// The axles of what crosses.
#[derive(Debug, Clone, Copy)]
pub struct Crossing<'a> {
    /// From the first one back.
    pub axles: &'a [Axle],
    /// The way in which they drive.
    pub heading: Heading,
    /// Width that carries an axle [m].
    pub width: f64,
}

impl MovingLoads {
    /// On a track above `surface`, the nodes of the top of the fill from left to right [m]; `middle` of the bridge [m], where a
    /// sleeper lies.
    pub fn on_track(track: &Track, crossing: Crossing<'_>, surface: &[Point], middle: f64) -> MovingLoads {
        let pressed = track.sleeper_breadth + 2.0 * track.ballast_depth / track.ballast_slope;
        let (left, right) = (surface.first().map_or(0.0, |p| p[0]), surface.last().map_or(0.0, |p| p[0]));
        let number = |x: f64| (x - middle) / track.sleeper_spacing;
        let first = number(left - 0.5 * pressed).ceil() as i64;
        let last = number(right + 0.5 * pressed).floor() as i64;
        let sleeper = |n: i64| middle + track.sleeper_spacing * n as f64;
        let pattern = |n: i64| strip(surface, sleeper(n) - 0.5 * pressed, sleeper(n) + 0.5 * pressed);
        let patterns: Vec<Pattern> = (first..=last).map(pattern).collect();
        let on = On::Track { rail: Rail::new(track), origin: middle, first };
        MovingLoads::of(on, crossing, [sleeper(first), sleeper(last)], patterns, pressed)
    }

    /// On the surface of a road, the nodes of the top of what is modelled from left to right [m].
    pub fn on_road(wheels: &Wheels, crossing: Crossing<'_>, surface: &[Point]) -> MovingLoads {
        let pressed = wheels.contact_length;
        let (left, right) = (surface.first().map_or(0.0, |p| p[0]), surface.last().map_or(0.0, |p| p[0]));
        let patterns = (0..surface.len()).map(|node| vec![(node, 1.0)]).collect();
        let reach = [left - 0.5 * pressed, right + 0.5 * pressed];
        MovingLoads::of(On::Road(surface.to_vec()), crossing, reach, patterns, pressed)
    }

    /// Loads at rest: the name of each position, and nodal forces of all that stands on the surface then [N per metre of width]. In place of a first axle's
    /// place stands the number of the position, counted from one; between two numbers is a share of the loads of the next, and at 0 nothing stands.
    pub fn at_rest(positions: Vec<(String, Pattern)>) -> MovingLoads {
        let (names, patterns): (Vec<String>, Vec<Pattern>) = positions.into_iter().unzip();
        let reach = [0.0, names.len() as f64];
        MovingLoads { on: On::Rest(names), axles: Vec::new(), sign: 1.0, width: 1.0, reach, patterns, pressed: 0.0 }
    }

    fn of(on: On, crossing: Crossing<'_>, reach: [f64; 2], patterns: Vec<Pattern>, pressed: f64) -> MovingLoads {
        let Crossing { axles, heading, width } = crossing;
        MovingLoads { on, axles: axles.to_vec(), sign: heading.sign(), width, reach, patterns, pressed }
    }

    /// Where an axle stands while the first one stands at `front` [m].
    fn place(&self, axle: &Axle, front: f64) -> f64 {
        front - self.sign * axle.offset
    }

    /// Amplitude of each pattern [N per metre of width] while the first axle stands at `front` [m].
    pub fn amplitudes(&self, front: f64) -> Vec<f64> {
        let mut amplitudes = vec![0.0; self.patterns.len()];
        if matches!(self.on, On::Rest(_))
            && let Some(amplitude) = (front.ceil() as usize).checked_sub(1).and_then(|k| amplitudes.get_mut(k))
        {
            *amplitude = 1.0 - (front.ceil() - front);
        }
        for axle in &self.axles {
            let (x, force) = (self.place(axle, front), axle.force / self.width);
            match &self.on {
                On::Track { rail, origin, first } => {
                    let (from, shares) = rail.shares(x - origin);
                    for (k, share) in shares.iter().enumerate().skip((first - from).max(0) as usize) {
                        let Some(reaction) = amplitudes.get_mut((from + k as i64 - first) as usize) else { break };
                        *reaction += share * force;
                    }
                }
                On::Road(surface) => {
                    for (node, share) in strip(surface, x - 0.5 * self.pressed, x + 0.5 * self.pressed) {
                        amplitudes[node] += share * force;
                    }
                }
                On::Rest(_) => {}
            }
        }
        amplitudes
    }

    /// Vertical nodal forces on the surface, downwards positive [N per metre of width].
    pub fn forces(&self, front: f64, nodes: usize) -> Vec<f64> {
        let mut forces = vec![0.0; nodes];
        for (amplitude, pattern) in self.amplitudes(front).iter().zip(&self.patterns) {
            for &(node, share) in pattern {
                forces[node] += amplitude * share;
            }
        }
        forces
    }

    /// Where the loads stand, in words.
    pub fn place_words(&self, front: f64) -> String {
        match &self.on {
            On::Rest(names) => match (front.ceil() as usize).checked_sub(1).and_then(|k| names.get(k)) {
                Some(name) if front == front.ceil() => format!("in position \"{name}\""),
                Some(name) => format!("with the loads of position \"{name}\" taken off in part"),
                None => "with the loads taken off again".to_owned(),
            },
            On::Track { .. } | On::Road(_) => format!("with the first axle at {front:.3} m"),
        }
    }

    /// Places and forces [N] of the axles above `from` to `to` [m].
    pub fn axles_above(&self, front: f64, from: f64, to: f64) -> Vec<(f64, f64)> {
        let place = |axle: &Axle| (self.place(axle, front), axle.force);
        self.axles.iter().map(place).filter(|(x, _)| (from..=to).contains(x)).collect()
    }

    /// The heaviest axle by itself on the same way, and its force [N].
    pub fn heaviest_alone(&self) -> Option<(MovingLoads, f64)> {
        let heaviest = self.axles.iter().max_by(|a, b| a.force.total_cmp(&b.force))?;
        let alone = Axle { offset: 0.0, ..*heaviest };
        Some((MovingLoads { axles: vec![alone], ..self.clone() }, alone.force))
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
        let crossing = Crossing { axles: &axles, heading: Heading::Right, width: 4.87 };
        let loads = MovingLoads::on_track(&track(), crossing, &chain, 0.37);
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
        let crossing = Crossing { axles: &axles, heading: Heading::Right, width: 4.87 };
        let loads = MovingLoads::on_track(&track(), crossing, &surface(), 0.0);
        for front in [-300.0, 300.0, -60.0, 60.0] {
            assert!(loads.amplitudes(front).iter().all(|r| r.abs() < 1e-6), "{front}");
        }
        assert_eq!(loads.axles_above(0.5, 0.0, 1.0), [(0.5, 200e3)]);
    }

    /// Wheels on a road bring their weight where they stand, whichever way they drive; what stands beside the surface brings nothing.
    #[test]
    fn wheels_press_where_they_stand() {
        let axles = [(60e3, 0.0), (95e3, 3.6)].map(|(force, offset)| Axle { force, offset });
        let chain = surface();
        let wheels = Wheels { contact_length: 0.25, effective_width: None };
        for (heading, sign) in [(Heading::Right, 1.0), (Heading::Left, -1.0)] {
            let loads = MovingLoads::on_road(&wheels, Crossing { axles: &axles, heading, width: 3.1 }, &chain);
            for front in [-2.0, 0.0, 1.234] {
                let forces = loads.forces(front, chain.len());
                let force: f64 = forces.iter().sum();
                let moment: f64 = forces.iter().zip(&chain).map(|(f, p)| f * p[0]).sum();
                let arm: f64 = axles.iter().map(|axle| axle.force / 3.1 * (front - sign * axle.offset)).sum();
                assert!((force - 155e3 / 3.1).abs() < 1e-7 && (moment - arm).abs() < 1e-6, "{force} {moment} {arm}");
                // A patch of a quarter of a metre loads the nodes about it, and no others.
                assert!(forces.iter().filter(|f| **f != 0.0).count() <= 10);
            }
            assert!(loads.amplitudes(sign * 40.0).iter().all(|r| *r == 0.0));
        }
    }
}
