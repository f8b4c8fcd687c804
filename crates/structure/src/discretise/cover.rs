//! Weight of backing, fill and road on the extrados: vertical columns, integrated exactly.

use super::extrados::{Extrados, Stretch};
use super::fill;
use bridge::{BackingBody, Bridge, Layer};
use mechanics::blocks::PointForce;
use mechanics::plane::{Vec2, vec2};

/// The road surface [m]: horizontal, at the stated depth above the highest crown.
pub fn surface(bridge: &Bridge, extrados: &Extrados) -> f64 {
    extrados.crown() + bridge.cover.depth
}

/// Weight of the column above a level, per metre along the bridge [N/m per metre of width].
pub(super) struct Column {
    /// Top of backing [m] and its weight density [N/m^3].
    backing: Option<(f64, f64)>,
    /// Top of the lowest layer [m] and its weight density [N/m^3].
    fill: (f64, f64),
    /// Weight of the layers of constant thickness [Pa].
    above: f64,
}

impl Column {
    /// The column of a bridge's cover.
    pub fn of(bridge: &Bridge, extrados: &Extrados) -> Column {
        let unit = |l: &Layer| if l.weighs { l.density * bridge.gravity } else { 0.0 };
        let lowest = bridge.cover.layers.first();
        let alone = |body| matches!(body, BackingBody::Weight | BackingBody::Continuum);
        let weight = bridge.cover.backing.filter(|b| alone(b.body) || fill::wanted(bridge).is_some());
        Column {
            backing: weight.map(|b| (b.height, b.density * bridge.gravity)),
            fill: lowest.map_or((f64::NEG_INFINITY, 0.0), |l| (extrados.crown() + l.thickness, unit(l))),
            above: bridge.cover.layers.iter().skip(1).map(|l| unit(l) * l.thickness).sum(),
        }
    }
    /// The column that presses in any case: backing weighs no more than the fill it replaces.
    pub fn pressing(mut self) -> Column {
        let fill = self.fill.1;
        self.backing = self.backing.map(|(top, weight)| (top, weight.min(fill)));
        self
    }
    /// Level of the lowest layer's upper face [m].
    pub fn top(&self) -> f64 {
        self.fill.0
    }
    /// Level of the backing's upper face [m]; minus infinity where there is none.
    pub fn backing_top(&self) -> f64 {
        self.backing.map_or(f64::NEG_INFINITY, |b| b.0)
    }
    /// Weight of what lies above a level [Pa].
    pub fn pressure(&self, level: f64) -> f64 {
        let (backing, floor) = match self.backing {
            Some((top, weight)) => (weight * (top - level).max(0.0), level.max(top)),
            None => (0.0, level),
        };
        backing + self.fill.1 * (self.fill.0 - floor).max(0.0) + self.above
    }
    fn corners(&self) -> impl Iterator<Item = f64> {
        self.backing.iter().map(|b| b.0).chain([self.fill.0]).collect::<Vec<_>>().into_iter()
    }
}

/// What the cover weighs on each stretch of the extrados: its resultant, at its point on the back [m].
pub fn weight(bridge: &Bridge, extrados: &Extrados) -> Vec<PointForce> {
    let column = Column::of(bridge, extrados);
    let mut forces = Vec::new();
    for stretch in extrados.stretches.iter().filter(|s| !s.ground) {
        // Pressure is linear in x between the ends and the places where a back passes a level.
        let mut cuts = vec![stretch.left, stretch.right];
        for level in column.corners().filter(|l| l.is_finite()) {
            let (a, b) = (stretch.left, stretch.right);
            if (a.y - level) * (b.y - level) < 0.0 {
                cuts.push(a + (b - a) * ((level - a.y) / (b.y - a.y)));
            }
        }
        cuts.sort_by(|a, b| a.x.total_cmp(&b.x));
        let mut sum = Resultant::default();
        for pair in cuts.windows(2) {
            sum.trapezoid(pair[0].x, column.pressure(pair[0].y), pair[1].x, column.pressure(pair[1].y));
        }
        if let Some(x) = sum.place() {
            forces.push(PointForce { block: stretch.block, at: stretch.at(x), force: vec2(0.0, -sum.force) });
        }
    }
    forces
}

/// What layers that are weight alone weigh on slabs, each at the middle of its upper face.
pub fn on_slabs(bridge: &Bridge, road: &Extrados) -> Vec<PointForce> {
    let layers = bridge.cover.layers.iter().filter(|l| l.weighs);
    let pressure: f64 = layers.map(|l| l.density * bridge.gravity * l.thickness).sum();
    let force = |s: &Stretch| PointForce {
        block: s.block,
        at: (s.left + s.right) * 0.5,
        force: vec2(0.0, -pressure * (s.right.x - s.left.x)),
    };
    road.stretches.iter().filter(|_| pressure > 0.0).map(force).collect()
}

/// Sum of a vertical pressure: force and its first moment about x = 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Resultant {
    /// Force [N/m].
    pub force: f64,
    /// Moment [N].
    pub moment: f64,
}

impl Resultant {
    /// Adds a pressure that runs linearly from `p` at `a` to `q` at `b`.
    pub fn trapezoid(&mut self, a: f64, p: f64, b: f64, q: f64) {
        let run = b - a;
        let force = 0.5 * (p + q) * run;
        self.force += force;
        // The first moment about `a` of a trapezoid is run^2 (p + 2 q) / 6.
        self.moment += force * a + run * run * (p + 2.0 * q) / 6.0;
    }
    /// Adds a force at a place.
    pub fn point(&mut self, x: f64, force: f64) {
        self.force += force;
        self.moment += force * x;
    }
    /// Where the resultant acts [m]; none where there is no force.
    pub fn place(&self) -> Option<f64> {
        (self.force != 0.0).then(|| self.moment / self.force)
    }
}

/// Corners of the surface line from end to end of the extrados [m].
pub fn surface_line(bridge: &Bridge, extrados: &Extrados) -> Vec<Vec2> {
    let y = surface(bridge, extrados);
    match (extrados.stretches.first(), extrados.stretches.last()) {
        (Some(a), Some(b)) => vec![vec2(a.left.x, y), vec2(b.right.x, y)],
        _ => Vec::new(),
    }
}
