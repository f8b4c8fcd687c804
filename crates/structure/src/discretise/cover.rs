//! Weight of backing, fill and road on the extrados: vertical columns, integrated exactly.

use super::extrados::{Extrados, Stretch};
use super::fill;
use super::springings::springings;
use super::voids;
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
    /// Tops of backing and of internal walls, and their mean weight densities [N/m^3].
    solid: Vec<(Surface, f64)>,
    /// Top of the lowest layer, and its weight density [N/m^3].
    fill: (Surface, f64),
    /// Weight of the layers of constant thickness [Pa].
    pub(super) above: f64,
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
    pub(super) fn of(bridge: &Bridge, extrados: &Extrados) -> Column {
        let unit = |l: &Layer| if l.weighs && !fill::is_bodies(bridge, l) { l.density * bridge.gravity } else { 0.0 };
        let lowest = bridge.cover.layers.first();
        let backing = bridge.cover.backing.filter(|b| b.body != BackingBody::Blocks || fill::wanted(bridge).is_some());
        let walls = bridge.cover.internal_walls.map(|w| (w.height, w.density));
        let solid = backing.map(|b| (b.height, b.density)).into_iter().chain(walls);
        Column {
            solid: solid
                .map(|(height, density)| (above_springings(bridge, height), density * bridge.gravity))
                .collect(),
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
    pub(super) fn pressing(mut self) -> Column {
        self.solid.iter_mut().for_each(|(_, weight)| *weight = weight.min(self.fill.1));
        self
    }
    /// Level of the lowest layer's upper face at a place [m].
    pub(super) fn top(&self, x: f64) -> f64 {
        self.fill.0.at(x)
    }
    /// Places between two others at which the gradient of an upper face changes [m].
    pub(super) fn kinks(&self, from: f64, to: f64) -> impl Iterator<Item = f64> {
        self.fill.0.kinks(from, to).chain(self.inner().flat_map(move |face| face.kinks(from, to)))
    }
    /// Upper faces of backing and internal walls, where there are some.
    fn inner(&self) -> impl Iterator<Item = &Surface> {
        self.solid.iter().map(|(face, _)| face)
    }
    /// Weight of what lies above a point [Pa].
    pub(super) fn pressure(&self, at: Vec2) -> f64 {
        let (mut solid, mut floor) = (0.0, at.y);
        for (top, weight) in &self.solid {
            let top = top.at(at.x);
            solid += weight * (top - floor).max(0.0);
            floor = floor.max(top);
        }
        let top = self.top(at.x);
        let whole = (top - floor).max(0.0);
        let fill = match self.water {
            Some(pores) => {
                let wet = (pores.level.min(top) - floor).max(0.0);
                self.fill.1 * (whole - wet) + pores.full * wet
            }
            None => self.fill.1 * whole,
        };
        solid + fill + self.above
    }
    /// Level of the water [m]; minus infinity where there is none.
    pub(super) fn water_level(&self) -> f64 {
        self.water.map_or(f64::NEG_INFINITY, |pores| pores.level)
    }
    /// Level up to which backing and internal walls stand at a place [m]; minus infinity where there are none.
    pub(super) fn solid_top(&self, x: f64) -> f64 {
        self.inner().map(|face| face.at(x)).fold(f64::NEG_INFINITY, f64::max)
    }
    /// Pressure of the water in the pores at a point [Pa]. What is solid has none in its own: below its top the pressure stays that at its top.
    pub(super) fn pore(&self, at: Vec2) -> f64 {
        let floor = at.y.max(self.solid_top(at.x));
        self.water.map_or(0.0, |pores| pores.water * (pores.level.min(self.top(at.x)) - floor).max(0.0))
    }
    /// The same below the floor of a void: nothing of what lies higher rests there.
    fn pressure_below(&self, at: Vec2, floor: f64) -> f64 {
        if at.y >= floor { 0.0 } else { self.pressure(at) - self.pressure(vec2(at.x, floor)) }
    }
    /// Weight on a level roof from one place to another [N/m].
    fn on_roof(&self, level: f64, [from, to]: [f64; 2]) -> Resultant {
        let mut corners = vec![from];
        corners.extend(self.kinks(from, to));
        corners.push(to);
        corners.sort_by(f64::total_cmp);
        let mut cuts: Vec<Vec2> = corners.iter().map(|x| vec2(*x, level)).collect();
        let passed: Vec<Vec2> = cuts.windows(2).flat_map(|pair| self.passed(pair[0], pair[1])).collect();
        cuts.extend(passed);
        cuts.sort_by(|a, b| a.x.total_cmp(&b.x));
        let mut sum = Resultant::default();
        for pair in cuts.windows(2) {
            sum.trapezoid(pair[0].x, self.pressure(pair[0]), pair[1].x, self.pressure(pair[1]));
        }
        sum
    }
    /// Levels at which a straight line passes the upper faces of backing and internal walls [m].
    pub(super) fn levels_passed(&self, a: Vec2, b: Vec2) -> impl Iterator<Item = f64> {
        self.inner().filter_map(move |face| {
            let [from, to] = [a, b].map(|p| face.at(p.x));
            let crossed = (a.y - from) * (b.y - to) < 0.0;
            let share = || (from - a.y) / (b.y - a.y - (to - from));
            crossed.then(|| if from == to { from } else { a.y + (b.y - a.y) * share() })
        })
    }
    /// Where a straight line passes the upper faces of backing, internal walls and fill and the level of the water, and where the fill's upper
    /// face passes that level.
    fn passed(&self, a: Vec2, b: Vec2) -> impl Iterator<Item = Vec2> {
        let tops = [a, b].map(|p| self.top(p.x));
        let inner = self.inner().map(|face| [a, b].map(|p| face.at(p.x)));
        let faces: Vec<[f64; 2]> = inner.chain([tops, [self.water_level(); 2]]).collect();
        let [from, to] = tops.map(|top| top - self.water_level());
        let drowned =
            (from.is_finite() && to.is_finite() && from * to < 0.0).then(|| a + (b - a) * (from / (from - to)));
        let finite = faces.into_iter().filter(|ends| ends.iter().all(|level| level.is_finite()));
        let crossed = finite.filter_map(move |[from, to]| {
            let crossed = (a.y - from) * (b.y - to) < 0.0;
            crossed.then(|| a + (b - a) * ((from - a.y) / (b.y - a.y - (to - from))))
        });
        crossed.chain(drowned)
    }
}

/// A face at a height above the springings: level where these are, else straight from springing to springing.
pub fn above_springings(bridge: &Bridge, height: f64) -> Surface {
    let springings = springings(bridge);
    if springings.iter().flatten().all(|springing| springing.y == 0.0) {
        return Surface::level(height);
    }
    let points = springings.into_iter().flatten().map(|p| [p.x, p.y + height]).collect();
    Surface { level: height, road: Some(Road { points }) }
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
        corners.extend(voids::ends(&extrados.voids, stretch.left.x, stretch.right.x).map(|x| stretch.at(x)));
        corners.push(stretch.right);
        corners.sort_by(|a, b| a.x.total_cmp(&b.x));
        let mut cuts = corners.clone();
        cuts.extend(corners.windows(2).flat_map(|pair| column.passed(pair[0], pair[1])));
        cuts.extend(corners.windows(2).filter_map(|pair| {
            let [a, b] = [pair[0], pair[1]];
            let floor = extrados.voids[voids::over(&extrados.voids, 0.5 * (a.x + b.x))?].levels[0];
            ((a.y - floor) * (b.y - floor) < 0.0).then(|| a + (b - a) * ((floor - a.y) / (b.y - a.y)))
        }));
        cuts.sort_by(|a, b| a.x.total_cmp(&b.x));
        let mut sum = Resultant::default();
        for pair in cuts.windows(2) {
            let [from, to] = match voids::over(&extrados.voids, 0.5 * (pair[0].x + pair[1].x)) {
                None => [pair[0], pair[1]].map(|at| column.pressure(at)),
                Some(k) => [pair[0], pair[1]].map(|at| column.pressure_below(at, extrados.voids[k].levels[0])),
            };
            sum.trapezoid(pair[0].x, from, pair[1].x, to);
        }
        if let Some(x) = sum.place() {
            forces.push(PointForce { block: stretch.block, at: stretch.at(x), force: vec2(0.0, -sum.force) });
        }
    }
    for void in &extrados.voids {
        let carried = voids::carried(void, &column.on_roof(void.levels[1], void.range));
        for (side, (x, force)) in carried.into_iter().enumerate() {
            let bearing = voids::bearing(&extrados.stretches, void, side).map(|k| &extrados.stretches[k]);
            let on = bearing.filter(|stretch| !stretch.ground && force != 0.0);
            forces.extend(on.map(|s| PointForce { block: s.block, at: s.at(x), force: vec2(0.0, -force) }));
        }
    }
    forces
}

/// What layers that are weight alone weigh on slabs, each at the middle of its upper face.
pub fn on_slabs(bridge: &Bridge, road: &Extrados) -> Vec<PointForce> {
    let layers = bridge.cover.layers.iter().filter(|l| l.weighs && !fill::is_bodies(bridge, l));
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
