//! Horizontal earth pressure on the extrados: at-rest or active pressure, and the passive share that movement against it mobilises.

use super::cover::{Column, Resultant};
use super::extrados::{Extrados, Stretch};
use super::voids;
use crate::extent::extent;
use bridge::{Bridge, FillPressure, LeastPressure};
use mechanics::blocks::{PointForce, Restraint};
use mechanics::ids::BlockId;
use mechanics::plane::{Vec2, vec2};

/// Coefficients of horizontal pressure: on vertical stress, and what cohesion adds [Pa].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// Share of the vertical stress that presses whatever moves.
    pub least: f64,
    /// Share of the vertical stress that movement mobilises; never less than `least`.
    pub most: f64,
    /// What cohesion adds to it [Pa].
    pub cohesion: f64,
}

/// Coefficients of a fill: Jaky's at rest, Rankine's active and passive ones.
pub fn coefficients(fill: &FillPressure) -> Coefficients {
    let sine = fill.friction_angle.sin();
    let passive = (1.0 + sine) / (1.0 - sine);
    let least = match fill.least {
        LeastPressure::AtRest => 1.0 - sine,
        LeastPressure::Active => 1.0 / passive,
        LeastPressure::None => 0.0,
    };
    Coefficients {
        least,
        most: (fill.mobilisation * passive).max(least),
        cohesion: fill.cohesion_mobilisation * 2.0 * fill.cohesion * passive.sqrt(),
    }
}

/// A back that fill presses on.
#[derive(Debug, Clone, Copy)]
struct Back {
    block: BlockId,
    /// Its lower and upper end, the upper one no higher than the fill [m].
    ends: [Vec2; 2],
    /// Which way fill presses on it along x: -1 or +1.
    way: f64,
}

impl Back {
    fn of(stretch: &Stretch, column: &Column) -> Option<Back> {
        let (a, b) = (stretch.left, stretch.right);
        let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
        let reach = high.y.min(column.top(high.x));
        if reach - low.y <= 1e-9 {
            return None;
        }
        let high = low + (high - low) * ((reach - low.y) / (high.y - low.y));
        Some(Back { block: stretch.block, ends: [low, high], way: if b.y > a.y { 1.0 } else { -1.0 } })
    }

    fn levels(&self) -> [f64; 2] {
        self.ends.map(|p| p.y)
    }

    fn at(&self, level: f64) -> Vec2 {
        let [low, high] = self.ends;
        vec2(low.x + (high.x - low.x) * ((level - low.y) / (high.y - low.y)), level)
    }
}

/// The pressure on every back as a horizontal force at its own height, towards the middle of its span; none on supports, and
/// where the file asks for none. Solid backing that is weight presses as the fill that it replaces, or as fill of its own
/// weight where that is less.
///
/// Fill beside an abutment bears on the ground behind it. Fill between two spans has nothing to bear on but the two rings: each
/// level of it pushes both with one force, which is the same on either side. Where only one of them has a back at a level,
/// nothing is mobilised.
pub fn restraints(bridge: &Bridge, extrados: &Extrados) -> Vec<Restraint> {
    let Some(fill) = bridge.fill_pressure.as_ref().filter(|fill| fill.applies) else { return Vec::new() };
    let presses = Presses {
        k: coefficients(fill),
        column: Column::of(bridge, extrados).pressing(),
        half_movement: fill.half_movement,
    };
    // Nothing presses out of a void.
    let hollow = |back: &Back| {
        let [low, high] = back.ends;
        let middle = 0.5 * (low.x + high.x);
        let void = voids::over(&extrados.voids, middle).map(|k| extrados.voids[k].levels);
        void.is_some_and(|[floor, roof]| high.y > floor && low.y < roof)
    };
    let backs = extrados.stretches.iter().filter(|s| !s.ground).filter_map(|s| Back::of(s, &presses.column));
    let backs: Vec<Back> = backs.filter(|back| !hollow(back)).collect();
    let mut all = Vec::new();
    let ends = extrados.faces.iter().filter_map(|face| {
        let [low, high] = face.levels.map(|y| vec2(face.x, y.min(presses.column.top(face.x))));
        (high.y - low.y > 1e-9).then_some(Back { block: face.block, ends: [low, high], way: face.inwards })
    });
    all.extend(ends.filter_map(|back| presses.on(&back, &back, back.levels(), true)));
    let runs: Vec<&[Back]> = backs.chunk_by(|a, b| a.way == b.way).collect();
    let mut k = 0;
    while let Some(&run) = runs.get(k) {
        k += 1;
        match runs.get(k) {
            Some(&next) if run[0].way < 0.0 => {
                presses.between(run, next, &mut all);
                k += 1;
            }
            _ => all.extend(run.iter().filter_map(|back| presses.on(back, back, back.levels(), true))),
        }
    }
    all
}

/// Where a back reaches the top of the fill: no force is there that could be mobilised [m].
const LEAST_MOVEMENT: f64 = 1e-6;

/// Pressure of the water in the pores of the fill on every back that stands in it, as a horizontal force at its own height; its vertical part
/// is in the weight of the saturated column. It acts whatever moves, with and without fill that presses. Nothing acts on the intrados: the
/// arch stands in the dry.
pub fn water(bridge: &Bridge, extrados: &Extrados) -> Vec<PointForce> {
    let column = Column::of(bridge, extrados);
    let level = column.water_level();
    if bridge.cover.water.is_none() {
        return Vec::new();
    }
    let on = |stretch: &Stretch| {
        let back = Back::of(stretch, &column)?;
        let [low, high] = back.levels();
        let to = high.min(level);
        if to - low <= 1e-9 {
            return None;
        }
        // The upper face of the fill may lie below the level of the water.
        let cuts = cuts(&column, [low, to], None, |y| back.at(y));
        // What is solid has no water in pores.
        let drowned = |pair: &&[f64]| {
            let middle = 0.5 * (pair[0] + pair[1]);
            middle > column.solid_top(back.at(middle).x)
        };
        let mut sum = Resultant::default();
        for pair in cuts.windows(2).filter(drowned) {
            sum.trapezoid(pair[0], column.pore(back.at(pair[0])), pair[1], column.pore(back.at(pair[1])));
        }
        let at = back.at(sum.place()?);
        Some(PointForce { block: back.block, at, force: vec2(back.way * sum.force, 0.0) })
    };
    extrados.stretches.iter().filter(|stretch| !stretch.ground).filter_map(on).collect()
}

/// Levels from one to another between which pressure on a line is linear: one more, those under kinks of the upper faces, and those at which the
/// line, which is at these places, passes solid parts.
fn cuts(column: &Column, [low, high]: [f64; 2], more: Option<f64>, at: impl Fn(f64) -> Vec2) -> Vec<f64> {
    let mut corners = vec![low, high];
    corners.extend(more);
    let [a, b] = [at(low).x, at(high).x];
    corners.extend(column.kinks(a.min(b), a.max(b)).map(|x| low + (high - low) * (x - a) / (b - a)));
    corners.sort_by(f64::total_cmp);
    let passed: Vec<f64> = corners.windows(2).flat_map(|pair| column.levels_passed(at(pair[0]), at(pair[1]))).collect();
    corners.extend(passed);
    corners.sort_by(f64::total_cmp);
    corners
}

/// What the fill presses with.
struct Presses {
    k: Coefficients,
    column: Column,
    /// Movement that mobilises half of what there is, as a share of the depth below the top of the fill.
    half_movement: f64,
}

impl Presses {
    /// The force on a part of a back, with what movement mobilises or without, under the fill halfway to another back.
    fn on(&self, back: &Back, other: &Back, [low, high]: [f64; 2], mobilised: bool) -> Option<Restraint> {
        if high - low <= 1e-9 {
            return None;
        }
        let middle = |level: f64| (back.at(level) + other.at(level)) * 0.5;
        // Grains press with what is left of the weight: the pressure of the water acts by itself.
        let pressure = |level: f64| {
            let at = vec2(middle(level).x, level);
            (self.column.pressure(at) - self.column.pore(at)).max(0.0)
        };
        // Vertical stress is linear between the levels of solid parts, that of the water and those under kinks of the road.
        let water = Some(self.column.water_level()).filter(|y| *y > low && *y < high);
        let cuts = cuts(&self.column, [low, high], water, |level| vec2(middle(level).x, level));
        let (mut vertical, mut even) = (Resultant::default(), Resultant::default());
        for pair in cuts.windows(2) {
            vertical.trapezoid(pair[0], pressure(pair[0]), pair[1], pressure(pair[1]));
        }
        even.trapezoid(low, 1.0, high, 1.0);
        let least = self.k.least * vertical.force;
        let [most, moment] = if mobilised {
            let sum = |vertical: f64, even: f64| self.k.most * vertical + self.k.cohesion * even;
            [sum(vertical.force, even.force), sum(vertical.moment, even.moment)]
        } else {
            [least, self.k.least * vertical.moment]
        };
        if !(most > 0.0) {
            return None;
        }
        let (at, direction) = (back.at(moment / most), vec2(back.way, 0.0));
        let depth = self.column.top(middle(at.y).x) - at.y;
        let half_movement = (self.half_movement * depth).max(LEAST_MOVEMENT);
        Some(Restraint { block: back.block, at, direction, least, most, half_movement, against: None })
    }

    /// Fill between the falling backs of one span and the rising backs of the next.
    fn between(&self, left: &[Back], right: &[Back], all: &mut Vec<Restraint>) {
        let range = |side: &[Back]| extent(side.iter().flat_map(Back::levels));
        for a in left {
            for b in right {
                let [[low, high], [lower, higher]] = [a.levels(), b.levels()];
                let shared = self.on(a, b, [low.max(lower), high.min(higher)], true);
                all.extend(shared.map(|r| Restraint { against: Some((b.block, b.at(r.at.y))), ..r }));
            }
        }
        for (side, [low, high]) in [(left, range(right)), (right, range(left))] {
            for back in side {
                let [from, to] = back.levels();
                all.extend(self.on(back, back, [from, to.min(low)], false));
                all.extend(self.on(back, back, [from.max(high), to], false));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretise::discretise;
    use crate::samples;
    use bridge::ring::Profile;
    use bridge::{BackingBody, Ring, Span};

    fn filled() -> Bridge {
        let mut b = samples::bridgemill();
        b.cover.layers = vec![samples::fill(0.478, 1890.0)];
        b.fill_pressure = Some(FillPressure {
            applies: true,
            friction_angle: 30f64.to_radians(),
            cohesion: 10e3,
            mobilisation: 0.5,
            cohesion_mobilisation: 0.05,
            least: LeastPressure::AtRest,
            half_movement: 0.02,
        });
        b
    }

    #[test]
    fn coefficients_are_those_of_the_textbooks() {
        let k = coefficients(filled().fill_pressure.as_ref().unwrap());
        assert!((k.least - 0.5).abs() < 1e-12, "1 - sin 30");
        assert!((k.most - 1.5).abs() < 1e-12, "half of 3");
        assert!((k.cohesion - 0.05 * 2.0 * 10e3 * 3f64.sqrt()).abs() < 1e-9);
        let active = FillPressure { least: LeastPressure::Active, ..filled().fill_pressure.unwrap() };
        assert!((coefficients(&active).least - 1.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn the_sum_is_that_of_a_wall_as_high_as_the_extrados() {
        let b = filled();
        let d = discretise(&b).unwrap();
        let all = restraints(&b, &d.extrados);
        assert_eq!(all.len(), 62);
        // By hand: pressure grows with depth, from the cover at the crown to the springing of the extrados.
        let backs: Vec<_> = d.extrados.stretches.iter().filter(|s| !s.ground).collect();
        let crown = d.extrados.crown();
        let top = crown + 0.478;
        let (high, low) = (backs[30].right.y, backs[0].left.y);
        let weight = 1890.0 * 9.81;
        let wall = 0.5 * weight * ((top - low).powi(2) - (top - high).powi(2));
        let least: f64 = all.iter().filter(|r| r.direction.x > 0.0).map(|r| r.least).sum();
        assert!((least / (0.5 * wall) - 1.0).abs() < 1e-9, "{least} {wall}");
        let most: f64 = all.iter().filter(|r| r.direction.x < 0.0).map(|r| r.most).sum();
        let cohesive = 0.05 * 2.0 * 10e3 * 3f64.sqrt() * (high - low);
        assert!((most / (1.5 * wall + cohesive) - 1.0).abs() < 1e-9, "{most}");
        assert!(restraints(&samples::bridgemill(), &d.extrados).is_empty());
        // Fill lies outside of its back: it presses towards the middle of the span, whatever the ring does.
        assert!(all.iter().all(|r| (r.direction.x > 0.0) == (r.at.x < 9.15)), "{all:?}");
    }

    fn load(b: &Bridge) -> f64 {
        let mut b = b.clone();
        b.plan.method = bridge::Method::Limit;
        assess::analysis::as_described(&b, None, &mut mechanics::watch::Unwatched).unwrap().collapse_load.unwrap()
    }

    #[test]
    fn fill_that_presses_helps() {
        let b = filled();
        let without = FillPressure { applies: false, ..b.fill_pressure.unwrap() };
        let (with, without) = (load(&b), load(&Bridge { fill_pressure: Some(without), ..b.clone() }));
        assert!(with > 1.02 * without, "{with} {without}");
    }

    /// A haunch deep enough for backing of half the rise, under fill that presses.
    fn deep(profile: Profile, rise: f64, voussoirs: usize) -> Bridge {
        let mut b = filled();
        b.masonry.rounding = 0.0;
        let ring = Ring { crown_thickness: 0.45, springing_thickness: 0.45, voussoirs };
        b.spans[0] =
            Span { profile, span: 6.0, rise, rings: vec![ring], defects: Vec::new(), skew: 0.0, right_springing: 0.0 };
        b.cover.layers = vec![samples::fill(0.4, 1900.0)];
        b.loads[0].position = 1.5;
        b
    }

    fn backed(b: &Bridge, share: f64, density: f64, body: BackingBody) -> Bridge {
        let height = share * b.spans[0].rise;
        let mut b = b.clone();
        b.cover.backing = Some(bridge::Backing { density, body, ..samples::backing(height) });
        b
    }

    #[test]
    fn backing_that_is_weight_presses_as_the_fill_that_it_replaces() {
        let bare = deep(Profile::Semicircular, 3.0, 31);
        let fill = load(&bare);
        let same = load(&backed(&bare, 0.5, 1900.0, BackingBody::Weight));
        assert!((same / fill - 1.0).abs() < 1e-6, "{same} {fill}");
        let heavier = load(&backed(&bare, 0.5, 2200.0, BackingBody::Weight));
        assert!(heavier > fill, "{heavier} {fill}");
        // Lighter backing presses with its own weight, over a range in which that of the fill does not lie.
        let lighter = load(&backed(&bare, 0.5, 1000.0, BackingBody::Weight));
        assert!(lighter < fill, "{lighter} {fill}");
    }

    #[test]
    fn backing_as_blocks_stands_on_steep_haunches_and_helps() {
        let haunches = [(Profile::Semicircular, 3.0), (Profile::Elliptical, 2.0), (Profile::Segmental, 1.0)];
        for (profile, rise) in haunches {
            for voussoirs in [31, 62] {
                let mut bare = deep(profile.clone(), rise, voussoirs);
                bare.masonry.rounding = 0.005;
                let fill = load(&bare);
                let solid = load(&backed(&bare, 0.5, 2200.0, BackingBody::Blocks));
                assert!(solid > 0.999 * fill, "{profile:?}, {voussoirs} voussoirs: {solid} {fill}");
                // By weight alone, too.
                let alone = |b: &Bridge| load(&Bridge { fill_pressure: None, ..b.clone() });
                let (weight, solid) = (alone(&bare), alone(&backed(&bare, 0.5, 2200.0, BackingBody::Blocks)));
                assert!(solid > weight, "{profile:?}, {voussoirs} voussoirs: {solid} {weight}");
            }
        }
    }

    /// Stones with sharp corners on steep backs: the way without dilation comes to an end.
    #[test]
    fn sharp_backing_of_blocks_that_crush_has_a_load() {
        for (profile, rise) in [(Profile::Semicircular, 3.0), (Profile::Elliptical, 2.0)] {
            for voussoirs in [31, 62] {
                let mut b = backed(&deep(profile.clone(), rise, voussoirs), 0.5, 2200.0, BackingBody::Blocks);
                b.masonry.compressive_strength = Some(8e6);
                let crushed = load(&b);
                // Joints that do not crush and slide with dilation: an upper bound.
                b.masonry.compressive_strength = None;
                b.plan.friction = bridge::Friction::Associated;
                let bound = load(&b);
                assert!(0.0 < crushed && crushed < bound, "{profile:?}, {voussoirs} voussoirs: {crushed} {bound}");
            }
        }
    }

    #[test]
    fn nothing_stands_behind_backing_but_fill() {
        let b = backed(&deep(Profile::Semicircular, 3.0, 31), 0.5, 2200.0, BackingBody::Blocks);
        let d = discretise(&b).unwrap();
        let pieces = |o: &crate::discretise::Origin| matches!(o, crate::discretise::Origin::Backing { .. });
        for (id, _) in d.origins.pairs().filter(|(_, o)| pieces(o)) {
            assert_eq!(d.model.blocks[id].held, mechanics::blocks::Held::FREE);
        }
        // On both faces together presses the fill beside a wall as high as the backing.
        let (low, high) = (0.0, 1.5);
        let top = d.extrados.crown().max(3.45) + 0.4;
        let wall = 0.5 * 1900.0 * 9.81 * ((top - low) * (top - low) - (top - high) * (top - high));
        let least: f64 = restraints(&b, &d.extrados).iter().filter(|r| r.at.y < high).map(|r| r.least).sum();
        assert!((least / (2.0 * 0.5 * wall) - 1.0).abs() < 1e-9, "{least} {wall}");
    }

    /// Two unlike spans with a deep valley between them.
    fn two_spans(voussoirs: [usize; 2]) -> Bridge {
        let b = deep(Profile::Semicircular, 3.0, voussoirs[0]);
        let mut spans = vec![b.spans[0].clone(), b.spans[0].clone()];
        (spans[1].span, spans[1].rise, spans[1].rings[0].voussoirs) = (5.0, 2.5, voussoirs[1]);
        Bridge { piers: samples::spans(spans.clone(), 1.4, 1.4, 3.0, 4).piers, spans, ..b }
    }

    /// Largest horizontal force [N/m] that the fill of a valley could be short of balance by.
    fn out_of_balance(b: &Bridge) -> f64 {
        let d = discretise(b).unwrap();
        let middle = b.spans[0].span + 0.5 * b.piers[0].width;
        let from = 0.5 * b.spans[0].span;
        let to = b.spans[0].span + b.piers[0].width + 0.5 * b.spans[1].span;
        let beside = |r: &&Restraint| r.at.x > from && r.at.x < to;
        let all = restraints(b, &d.extrados);
        let [mut left, mut right] = [0.0; 2];
        for r in all.iter().filter(beside).filter(|r| r.against.is_none()) {
            *(if r.at.x < middle { &mut left } else { &mut right }) += r.most - r.least;
        }
        f64::max(left, right)
    }

    #[test]
    fn fill_between_two_spans_pushes_both_alike() {
        let b = two_spans([31, 27]);
        // What either side could be pushed with beyond the other: none.
        assert!(out_of_balance(&b) < 1e-6, "{}", out_of_balance(&b));
        let d = discretise(&b).unwrap();
        for r in restraints(&b, &d.extrados) {
            if let Some((other, at)) = r.against {
                assert!(other != r.block && (at.y - r.at.y).abs() < 1e-9, "{r:?}");
            }
        }
    }

    #[test]
    fn the_load_with_a_valley_does_not_depend_on_the_hand_and_little_on_the_voussoirs() {
        let b = two_spans([31, 31]);
        let mut mirrored = b.clone();
        mirrored.spans.reverse();
        let length = crate::discretise::bridge_length(&b);
        mirrored.loads[0].position = length - b.loads[0].position;
        let (one, other) = (load(&b), load(&mirrored));
        assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
        let finer = load(&two_spans([61, 61]));
        assert!((finer / one - 1.0).abs() < 0.05, "{finer} {one}");
    }
}
