//! Where vehicles stand across the bridge, as far as a plane model can say it: the width of the barrel that carries one.
//!
//! A vehicle alone in the middle is carried by the width over which its load has spread. Vehicles abreast share what lies
//! between them; one at the edge lacks what would lie beyond it. Every number of vehicles up to that of the lanes is tried,
//! in the middle and at the edge, and the arrangement with the largest force per metre of width counts.

use super::cracked::{Lines, most_loaded};
use crate::vehicles::Chosen;
use bridge::{Bridge, Sideways};
use outcome::note;
use outcome::vehicles::Across;
use rules::{EffectiveWidth, Rule, Ways};

/// Width of the narrowest lane of a road [m]: that of two vehicles abreast (BD 21, notional lanes).
pub const ROAD_LANE: f64 = 2.5;
/// Distance between the middles of two tracks [m].
const TRACKS: f64 = 3.4;

/// How many vehicles may stand abreast, and how far their middles are apart [m].
pub(in crate::analysis) fn lanes(bridge: &Bridge, ways: Ways) -> (usize, f64) {
    let asked = bridge.carriageway.clone().unwrap_or_default();
    let usual = if ways == Ways::Road { ROAD_LANE } else { TRACKS };
    let apart = asked.lane_width.unwrap_or(usual);
    let fit = if ways == Ways::Road && bridge.width >= 2.0 * apart { 2 } else { 1 };
    (asked.lanes.unwrap_or(fit).max(1), apart)
}

/// How many vehicles of a kind may stand abreast, or one of it with so many lanes beside, and how far their middles are apart [m].
pub(super) fn room(bridge: &Bridge, chosen: &Chosen) -> (usize, f64) {
    let (most, apart) = lanes(bridge, chosen.ways);
    let (vehicle, given) = (&chosen.vehicle, bridge.carriageway.as_ref().and_then(|asked| asked.lanes));
    let fits = bridge.width >= vehicle.wheel_track_m + BODY + ROAD_LANE;
    let most = match (&chosen.acting.beside, given) {
        (Some(_), None) => vehicle.lanes + usize::from(fits),
        _ => most,
    };
    let apart = chosen.beside.as_ref().map_or(apart, |lane| lane.apart.max(apart));
    (most.saturating_sub(vehicle.lanes - 1).max(1), apart)
}

/// What a vehicle is wider than its wheels are apart [m] (HB: 3.5 m, wheels over 3.0 m).
const BODY: f64 = 0.5;

/// What is done with forces across the bridge.
pub(super) fn sideways(bridge: &Bridge) -> note::Sideways {
    let sideways = bridge.carriageway.as_ref().map_or_else(Sideways::default, |asked| asked.sideways);
    match sideways.eccentricity(bridge.gravity).0 > 0.0 {
        true => note::Sideways::Counted,
        false => note::Sideways::LeftOut,
    }
}

/// Half the width of a tyre, or of a rail with what it stands on [m].
const TYRE: f64 = 0.15;

/// A vehicle and what stands beside it, as the rule spreads it.
struct Arrangement<'a> {
    rule: &'a Rule,
    chosen: &'a Chosen,
    barrel: f64,
    depth: f64,
    apart: f64,
    edge: Option<f64>,
    /// Distance of the rails or wheels by which a vehicle stands unevenly [m].
    gauge: f64,
    /// How far the resultant of a vehicle lies beside the middle between its wheels [m], and whether it moves then.
    shift: (f64, bool),
}

impl Arrangement<'_> {
    /// What is left of the width of so many vehicles where their resultants lie beside their middles, all to one side [m]: the part that is
    /// centred on the resultant; and by a rule of dispersal no more than leaves the heavier side of each vehicle its half of the width.
    fn centred(&self, width: f64, count: usize) -> f64 {
        let (shift, _) = self.shift;
        let heavier = match self.rule.effective_width {
            EffectiveWidth::Dispersed { .. } => count as f64 * self.alone() / (1.0 + 2.0 * shift / self.gauge),
            _ => f64::INFINITY,
        };
        let centred = width - 2.0 * shift;
        (if shift > 0.0 { centred.min(heavier) } else { width }).max(1e-3)
    }

    /// Width that carries a vehicle alone where the barrel is wide enough [m].
    fn alone(&self) -> f64 {
        self.rule.effective_width(self.chosen.vehicle.wheel_track_m, self.depth, f64::INFINITY)
    }

    /// Share of a vehicle abreast in what the first one has, multiple presence aside.
    fn share(&self, lane: usize) -> f64 {
        match self.chosen.abreast.is_empty() {
            true => 1.0,
            false => self.chosen.abreast.get(lane).copied().unwrap_or(0.0),
        }
    }

    /// Width beyond the edge of the barrel that is missing [m].
    fn lost(&self) -> f64 {
        self.edge.map_or(0.0, |edge| (self.rule.dispersal.overhang_at(self.depth) - edge).max(0.0))
    }

    /// Most width that vehicles of this width each carry together [m].
    fn together(&self, width: f64, count: usize) -> f64 {
        let others = count as f64 - 1.0;
        let narrower = self.chosen.beside.as_ref().filter(|_| count > 1).map_or(0.0, |lane| lane.narrower);
        (width + others * self.apart - 0.5 * narrower).min(count as f64 * width - others * narrower)
    }

    /// What all bear in place of the first one.
    fn factor(&self, count: usize) -> f64 {
        (0..count).map(|lane| self.share(lane)).sum::<f64>() * self.chosen.acting.presence(count)
    }

    /// The width that carries the first vehicle when loads of a width each stand so far apart.
    fn carried(&self, width: f64, count: usize, at_edge: bool) -> f64 {
        let lost = if at_edge { self.lost() } else { 0.0 };
        self.centred((self.together(width, count) - lost).min(self.barrel), count) / self.factor(count)
    }

    /// Width over which a uniform load stands at the surface, where it has its own, and over which it has spread [m].
    fn of_uniform(&self, uniform: &rules::Uniform) -> (Option<f64>, f64) {
        match uniform.width_m {
            Some(own) => (Some(own), own + self.rule.dispersal.width_per_depth * self.depth),
            None => (None, self.alone()),
        }
    }

    /// The lines of so many vehicles, of wheels or of a load with a width of its own.
    fn lines(&self, count: usize, own: Option<f64>, width: f64) -> Lines {
        let presence = self.chosen.acting.presence(count);
        let half = 0.5 * self.chosen.vehicle.wheel_track_m;
        let (shift, _) = self.shift;
        let uneven = (shift / self.gauge).min(0.5);
        let of_one = |lane: usize| {
            let (at, share) = (lane as f64 * self.apart, presence * self.share(lane));
            match own {
                Some(_) => vec![(at + shift, share)],
                None => vec![(at - half, (0.5 - uneven) * share), (at + half, (0.5 + uneven) * share)],
            }
        };
        let overhang = match own {
            Some(_) => 0.5 * width,
            None => self.rule.dispersal.overhang_at(self.depth),
        };
        let contact = own.map_or(TYRE, |own| 0.5 * own);
        Lines {
            lines: (0..count).flat_map(of_one).collect(),
            contact,
            overhang: overhang.max(contact),
            most: self.together(width, count),
            from_edge: self.edge.map_or(overhang, |edge| edge + contact - TYRE),
        }
    }

    /// The middles of wheel lines of an arrangement on the whole barrel, from one edge [m].
    fn wheels(&self, count: usize, at_edge: bool) -> Vec<f64> {
        let half = 0.5 * self.chosen.vehicle.wheel_track_m;
        let first = match self.edge.filter(|_| at_edge) {
            Some(edge) => edge + half,
            None => 0.5 * (self.barrel - (count as f64 - 1.0) * self.apart),
        };
        (0..count).flat_map(|lane| [-half, half].map(|side| first + lane as f64 * self.apart + side)).collect()
    }

    /// How the width of the axles was found, in words.
    fn derived(&self, count: usize, at_edge: bool) -> String {
        let alone = self.alone();
        let track = self.chosen.vehicle.wheel_track_m;
        let spread = &self.rule.dispersal;
        let base = match &self.rule.effective_width {
            EffectiveWidth::Barrel { .. } => format!("the whole barrel, {:.2} m, by the rule", self.barrel),
            EffectiveWidth::Fixed { width_m, .. } => format!("{width_m:.2} m by the rule, at most the barrel"),
            EffectiveWidth::Dispersed { .. } if spread.strip_at_most_m.is_some() => format!(
                "{alone:.2} m below two lines of wheels {track:.2} m apart, each spread over {:.2} m at {:.2} m depth",
                2.0 * spread.overhang_at(self.depth),
                self.depth
            ),
            EffectiveWidth::Dispersed { .. } => format!(
                "{track:.2} m between wheels + {:.2} m + {:.2} x {:.2} m depth = {:.2} m{}",
                spread.width_base_m,
                spread.width_per_depth,
                self.depth,
                spread.width_at(self.depth, track),
                if alone < spread.width_at(self.depth, track) {
                    format!(", the barrel has {alone:.2} m")
                } else {
                    String::new()
                }
            ),
        };
        let mut told = base;
        if count > 1 {
            let width = self.together(alone, count);
            told += &format!("; {count} abreast, {:.2} m apart: {width:.2} m together", self.apart);
        }
        if at_edge && self.lost() > 0.0 {
            told += &format!("; {:.2} m of it lie beyond the edge", self.lost());
        }
        if let (shift, moving) = self.shift
            && shift > 0.0
        {
            told += &format!(
                "; the resultant of a vehicle that {} lies {shift:.3} m beside the middle of its track: of what is centred on it, and of what \
                 the heavier side leaves, the smaller counts, {:.2} m",
                if moving { "moves" } else { "stands" },
                self.carried(alone, count, at_edge) * self.factor(count)
            );
        }
        let factor = self.factor(count);
        let left = self.carried(alone, count, at_edge) * factor;
        if self.together(alone, count) - if at_edge { self.lost() } else { 0.0 } > self.barrel * (1.0 + 1e-9) {
            told += &format!("; the barrel has {:.2} m", self.barrel);
        }
        if (factor - 1.0).abs() > 1e-12 {
            told += &format!("; {left:.2} m carry {factor:.3} times the first vehicle: {:.2} m for it", left / factor);
        }
        told
    }
}

/// The worst arrangement of a vehicle.
pub(super) fn worst(bridge: &Bridge, rule: &Rule, chosen: &Chosen) -> Across {
    let (most, apart) = room(bridge, chosen);
    let asked = bridge.carriageway.clone().unwrap_or_default();
    let (barrel, depth, edge) = (bridge.width, bridge.cover.depth, asked.edge_distance);
    let (gauge, shift) = (asked.sideways.gauge, asked.sideways.eccentricity(bridge.gravity));
    let one = Arrangement { rule, chosen, barrel, depth, apart, edge, gauge, shift };
    let counts: Vec<usize> = (1..=most).filter(|count| *count == 1 || one.share(count - 1) > 0.0).collect();
    let uniform = vec![f64::INFINITY; chosen.vehicle.uniform.len()];
    let mut found = Across { axles: f64::INFINITY, uniform, ..Across::default() };
    for &count in &counts {
        for at_edge in [false, true] {
            let axles = one.carried(one.alone(), count, at_edge);
            if axles < found.axles - 1e-12 {
                (found.abreast, found.at_edge, found.axles) = (count, at_edge, axles);
            }
            for (k, uniform) in chosen.vehicle.uniform.iter().enumerate() {
                found.uniform[k] = found.uniform[k].min(one.carried(one.of_uniform(uniform).1, count, at_edge));
            }
        }
    }
    found.wheels = one.wheels(found.abreast, found.at_edge);
    found.derivation = one.derived(found.abreast, found.at_edge);
    if let Some(lane) = chosen.beside.as_ref().filter(|_| found.abreast > 1) {
        found.beside.clone_from(&lane.code);
    }
    between_cracks(bridge, &one, &counts, &mut found);
    found
}

/// What is narrower still where longitudinal cracks divide the barrel.
fn between_cracks(bridge: &Bridge, one: &Arrangement<'_>, counts: &[usize], found: &mut Across) {
    let cracks = bridge.carriageway.as_ref().map_or(&[][..], |asked| &asked.cracks);
    let strips = bridge::strips(bridge.width, cracks);
    if strips.len() < 2 {
        return;
    }
    for &count in counts {
        let lines = one.lines(count, None, one.alone());
        let loaded = most_loaded(one.rule, one.barrel, &strips, &lines);
        if let Some(loaded) = loaded.filter(|loaded| loaded.width < found.axles - 1e-12) {
            let side = if loaded.mirrored { -1.0 } else { 1.0 };
            let mut wheels: Vec<f64> = lines.lines.iter().map(|(at, _)| loaded.middle + side * at).collect();
            wheels.sort_by(f64::total_cmp);
            let [from, to] = loaded.strip;
            let derivation = format!(
                "{}; the barrel is divided by longitudinal cracks, and on its strip from {from:.2} to {to:.2} m stand lines of wheels, at {} m \
                 from the edge: each metre there bears as much as if {:.2} m carried one vehicle",
                one.derived(count, false),
                wheels.iter().map(|at| format!("{at:.2}")).collect::<Vec<_>>().join(", "),
                loaded.width
            );
            let uniform = std::mem::take(&mut found.uniform);
            *found = Across {
                abreast: count,
                at_edge: false,
                axles: loaded.width,
                uniform,
                strip: Some(loaded.strip),
                wheels,
                derivation,
                beside: if count > 1 { found.beside.clone() } else { String::new() },
            };
        }
        for (k, uniform) in one.chosen.vehicle.uniform.iter().enumerate() {
            let (own, width) = one.of_uniform(uniform);
            let loaded = most_loaded(one.rule, one.barrel, &strips, &one.lines(count, own, width));
            found.uniform[k] = loaded.map_or(found.uniform[k], |loaded| loaded.width.min(found.uniform[k]));
        }
    }
}
