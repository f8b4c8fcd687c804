//! Fill that presses sideways on backs: what is there anyway, and what movement against it mobilises.

use super::cover::{Column, Resultant};
use super::extrados::Extrados;
use bridge::{Bridge, FillPressure, LeastPressure};
use mechanics::blocks::Restraint;
use mechanics::plane::vec2;

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

/// The pressure on every back as a horizontal force at its own height, towards the middle of its span; none on supports,
/// below solid backing, and where the file asks for none.
pub fn restraints(bridge: &Bridge, extrados: &Extrados) -> Vec<Restraint> {
    let Some(fill) = bridge.fill_pressure.as_ref().filter(|fill| fill.applies) else { return Vec::new() };
    let k = coefficients(fill);
    let column = Column::of(bridge, extrados);
    let solid = column.backing_top();
    let mut restraints = Vec::new();
    for stretch in extrados.stretches.iter().filter(|s| !s.ground) {
        let (a, b) = (stretch.left, stretch.right);
        let top = column.top();
        let [low, high] = [a.y.min(b.y).max(solid), a.y.max(b.y).min(top)];
        if high - low <= 1e-9 {
            continue;
        }
        // Vertical stress is linear between levels of layers, of which only the lowest lies beside backs.
        let (mut vertical, mut even) = (Resultant::default(), Resultant::default());
        vertical.trapezoid(low, column.pressure(low), high, column.pressure(high));
        even.trapezoid(low, 1.0, high, 1.0);
        let most = k.most * vertical.force + k.cohesion * even.force;
        let moment = k.most * vertical.moment + k.cohesion * even.moment;
        if !(most > 0.0) {
            continue;
        }
        let level = moment / most;
        let at = vec2(a.x + (b.x - a.x) * (level - a.y) / (b.y - a.y), level);
        let direction = vec2(if b.y > a.y { 1.0 } else { -1.0 }, 0.0);
        restraints.push(Restraint { block: stretch.block, at, direction, least: k.least * vertical.force, most });
    }
    restraints
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretise::discretise;
    use crate::samples;

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

    /// Backing is a block or weight of its own, and no fill: nothing presses beside it. What presses helps, and never harms.
    #[test]
    fn fill_presses_above_backing_and_helps() {
        let mut b = filled();
        let d = discretise(&b).unwrap();
        let whole = restraints(&b, &d.extrados).len();
        let load = |b: &Bridge| {
            let mut b = b.clone();
            b.plan.method = bridge::Method::Limit;
            crate::analysis::collapse_by_limit(&b).unwrap().collapse_load.unwrap()
        };
        let with = load(&b);
        let without = FillPressure { applies: false, ..b.fill_pressure.unwrap() };
        let without = load(&Bridge { fill_pressure: Some(without), ..b.clone() });
        assert!(with > 1.02 * without, "{with} {without}");
        b.cover.backing = Some(bridge::Backing {
            height: 2.0,
            density: 2100.0,
            elastic_modulus: None,
            poisson_ratio: None,
            body: bridge::BackingBody::Weight,
            friction_angle: None,
            cohesion: None,
        });
        let d = discretise(&b).unwrap();
        let above = restraints(&b, &d.extrados);
        assert!(!above.is_empty() && above.len() < whole);
        assert!(above.iter().all(|r| r.at.y > 2.0), "{above:?}");
    }
}
