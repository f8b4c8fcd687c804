//! Weight of backing, fill and road on the extrados: vertical columns, integrated exactly.

use super::extrados::{Extrados, Stretch};
use super::fill;
use bridge::road::Road;
use bridge::{BackingBody, Bridge, Layer};
use mechanics::blocks::PointForce;
use mechanics::plane::{Vec2, vec2};

/// The surface on which loads stand.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Its level where it is level [m].
    level: f64,
    /// Its levels where it is not.
    road: Option<Road>,
}

impl Surface {
    /// A level surface [m].
    pub fn level(level: f64) -> Surface {
        Surface { level, road: None }
    }
    /// Level at a place [m].
    pub fn at(&self, x: f64) -> f64 {
        self.road.as_ref().map_or(self.level, |road| road.level(x))
    }
    /// Its highest level [m].
    pub fn highest(&self) -> f64 {
        self.road.as_ref().map_or(self.level, Road::highest)
    }
    /// Places between two others at which its gradient changes [m].
    pub fn kinks(&self, from: f64, to: f64) -> impl Iterator<Item = f64> {
        let points = self.road.iter().flat_map(|road| &road.points);
        points.map(|point| point[0]).filter(move |x| from < *x && *x < to)
    }
    /// The same, higher by a length [m].
    fn raised(&self, by: f64) -> Surface {
        let raised = |road: &Road| Road { points: road.points.iter().map(|[x, y]| [*x, y + by]).collect() };
        Surface { level: self.level + by, road: self.road.as_ref().map(raised) }
    }
    /// Its corners from one place to another [m].
    pub fn line(&self, from: f64, to: f64) -> Vec<Vec2> {
        let places = [from].into_iter().chain(self.kinks(from, to)).chain([to]);
        places.map(|x| vec2(x, self.at(x))).collect()
    }
}

/// The road surface: by the levels of the file, or level at the stated depth above the highest crown.
pub fn surface(bridge: &Bridge, extrados: &Extrados) -> Surface {
    Surface { level: extrados.crown() + bridge.cover.depth, road: bridge.cover.road.clone() }
}

/// Weight of the column above a point, per metre along the bridge [N/m per metre of width].
pub(super) struct Column {
    /// Top of backing [m] and its weight density [N/m^3].
    backing: Option<(f64, f64)>,
    /// Top of the lowest layer, and its weight density [N/m^3].
    fill: (Surface, f64),
    /// Weight of the layers of constant thickness [Pa].
    above: f64,
    /// Water in the pores of the lowest layer.
    water: Option<Pores>,
}

/// Density of water [kg/m^3].
const WATER: f64 = 1000.0;

/// Water in the pores of the lowest layer.
#[derive(Clone, Copy)]
struct Pores {
    /// Its level [m].
    level: f64,
    /// Weight density of the layer with its pores full [N/m^3].
    full: f64,
    /// Weight density of the water [N/m^3].
    water: f64,
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
            fill: (fill_top(bridge, extrados), lowest.map_or(0.0, unit)),
            above: bridge.cover.layers.iter().skip(1).map(|l| unit(l) * l.thickness).sum(),
            water: bridge.cover.water.map(|pores| Pores {
                level: pores.level,
                full: pores.saturated_density * bridge.gravity,
                water: WATER * bridge.gravity,
            }),
        }
    }
    /// The column that presses in any case: backing weighs no more than the fill it replaces.
    pub fn pressing(mut self) -> Column {
        let fill = self.fill.1;
        self.backing = self.backing.map(|(top, weight)| (top, weight.min(fill)));
        self
    }
    /// Level of the lowest layer's upper face at a place [m].
    pub fn top(&self, x: f64) -> f64 {
        self.fill.0.at(x)
    }
    /// Places between two others at which the gradient of that face changes [m].
    pub fn kinks(&self, from: f64, to: f64) -> impl Iterator<Item = f64> {
        self.fill.0.kinks(from, to)
    }
    /// Level of the backing's upper face [m]; minus infinity where there is none.
    pub fn backing_top(&self) -> f64 {
        self.backing.map_or(f64::NEG_INFINITY, |b| b.0)
    }
    /// Weight of what lies above a point [Pa].
    pub fn pressure(&self, at: Vec2) -> f64 {
        let (backing, floor) = match self.backing {
            Some((top, weight)) => (weight * (top - at.y).max(0.0), at.y.max(top)),
            None => (0.0, at.y),
        };
        let whole = (self.top(at.x) - floor).max(0.0);
        let fill = match self.water {
            Some(pores) => {
                let wet = (pores.level.min(self.top(at.x)) - floor).max(0.0);
                self.fill.1 * (whole - wet) + pores.full * wet
            }
            None => self.fill.1 * whole,
        };
        backing + fill + self.above
    }
    /// Level of the water [m]; minus infinity where there is none.
    pub fn water_level(&self) -> f64 {
        self.water.map_or(f64::NEG_INFINITY, |pores| pores.level)
    }
    /// Pressure of the water in the pores at a point [Pa]. Backing has none in its own: below its top the pressure stays that at its top.
    pub fn pore(&self, at: Vec2) -> f64 {
        let floor = at.y.max(self.backing_top());
        self.water.map_or(0.0, |pores| pores.water * (pores.level.min(self.top(at.x)) - floor).max(0.0))
    }
    /// Where a straight back passes the upper faces of backing and fill and the level of the water, and where the fill's upper face does.
    fn passed(&self, a: Vec2, b: Vec2) -> impl Iterator<Item = Vec2> {
        let faces = [[self.backing_top(); 2], [a, b].map(|p| self.top(p.x)), [self.water_level(); 2]];
        let tops = [a, b].map(|p| self.top(p.x) - self.water_level());
        let drowned = (tops.iter().all(|top| top.is_finite()) && tops[0] * tops[1] < 0.0)
            .then(|| a + (b - a) * (tops[0] / (tops[0] - tops[1])));
        let crossed = faces.into_iter().filter(|ends| ends.iter().all(|level| level.is_finite())).filter_map(
            move |[from, to]| {
                let crossed = (a.y - from) * (b.y - to) < 0.0;
                crossed.then(|| a + (b - a) * ((from - a.y) / (b.y - a.y - (to - from))))
            },
        );
        crossed.chain(drowned)
    }
}

/// Upper face of the lowest layer: the layers above it keep their thickness.
fn fill_top(bridge: &Bridge, extrados: &Extrados) -> Surface {
    let cover = &bridge.cover;
    let Some(lowest) = cover.layers.first() else { return Surface::level(f64::NEG_INFINITY) };
    let above: f64 = cover.layers.iter().skip(1).map(|layer| layer.thickness).sum();
    let lowered = surface(bridge, extrados).raised(-above);
    Surface { level: extrados.crown() + lowest.thickness, ..lowered }
}

/// Upper faces of all layers, from the lowest one up.
pub fn tops(bridge: &Bridge, extrados: &Extrados) -> Vec<Surface> {
    let mut top = fill_top(bridge, extrados);
    let mut tops = Vec::new();
    for (k, layer) in bridge.cover.layers.iter().enumerate() {
        if k > 0 {
            top = top.raised(layer.thickness);
        }
        tops.push(top.clone());
    }
    tops
}

/// What the cover weighs on each stretch of the extrados: its resultant, at its point on the back [m].
pub fn weight(bridge: &Bridge, extrados: &Extrados) -> Vec<PointForce> {
    let column = Column::of(bridge, extrados);
    let mut forces = Vec::new();
    for stretch in extrados.stretches.iter().filter(|s| !s.ground) {
        // Pressure is linear in x between the ends, the kinks of the road and the places where a back passes a face.
        let mut corners = vec![stretch.left];
        corners.extend(column.kinks(stretch.left.x, stretch.right.x).map(|x| stretch.at(x)));
        corners.push(stretch.right);
        let mut cuts = corners.clone();
        cuts.extend(corners.windows(2).flat_map(|pair| column.passed(pair[0], pair[1])));
        cuts.sort_by(|a, b| a.x.total_cmp(&b.x));
        let mut sum = Resultant::default();
        for pair in cuts.windows(2) {
            sum.trapezoid(pair[0].x, column.pressure(pair[0]), pair[1].x, column.pressure(pair[1]));
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
    match (extrados.stretches.first(), extrados.stretches.last()) {
        (Some(a), Some(b)) => surface(bridge, extrados).line(a.left.x, b.right.x),
        _ => Vec::new(),
    }
}
