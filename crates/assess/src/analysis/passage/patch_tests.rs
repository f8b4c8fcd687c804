//! Wheels on what is modelled, against closed forms: a patch on layers over rock and on a half plane, and a beam across an elastic arch.

use super::loads::{Crossing, MovingLoads, strip};
use bridge::passage::{Heading, Wheels};
use bridge::train::Axle;
use mechanics::fem::law::{Elastic, Material, Plane, Solid};
use mechanics::fem::{
    Element, Kinematics, Mesh, Model, Quad, Section, Settings, State, Status, Support, Target, Workspace, advance,
};
use mechanics::ids::{Id, NodeId, QuadId, ZoneId};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Unwatched;
use std::f64::consts::PI;

/// Force of the axle [N], its width [m], and so the force of a metre of width [N/m].
const AXLE: [f64; 2] = [115e3, 2.3];
const FORCE: f64 = AXLE[0] / AXLE[1];

/// Thickness [m], elastic modulus [Pa] and Poisson's ratio, from the top down.
type Layer = [f64; 3];

/// A grid whose rows are numbered from the bottom up; `zone` of a row.
fn grid(count: [usize; 2], zones: usize, zone: impl Fn(usize) -> usize, place: impl Fn(f64, f64) -> Vec2) -> Mesh {
    let [nx, ny] = count;
    let mut mesh = Mesh::default();
    (0..zones).for_each(|k| {
        mesh.zones.push(format!("layer {k}"));
    });
    for j in 0..=ny {
        for i in 0..=nx {
            mesh.nodes.push(place(i as f64 / nx as f64, j as f64 / ny as f64));
        }
    }
    for j in 0..ny {
        for i in 0..nx {
            let at = |i: usize, j: usize| NodeId::new(j * (nx + 1) + i);
            let nodes = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            mesh.quads.push(Quad { nodes, zone: ZoneId::new(zone(j)) });
        }
    }
    mesh
}

fn section(modulus: f64, ratio: f64, plane: Plane) -> Section {
    let solid = Solid { material: Material::Elastic(Elastic { modulus, ratio }), plane };
    Section { solid, element: Element::QM6, density: 2000.0 }
}

/// What the axle does to a model whose last row of nodes is the surface, with its middle at `at` [m] on a length `pressed` [m].
fn under_an_axle(model: &Model, columns: usize, at: f64, pressed: f64) -> State {
    let count = model.mesh.nodes.len();
    let top: Vec<NodeId> = (count - columns - 1..count).map(NodeId::new).collect();
    let surface: Vec<[f64; 2]> =
        top.iter().map(|node| [model.mesh.nodes[*node].x, model.mesh.nodes[*node].y]).collect();
    let axles = [Axle { force: AXLE[0], offset: 0.0 }];
    let wheels = Wheels { contact_length: pressed, effective_width: None };
    let crossing = Crossing { axles: &axles, heading: Heading::Right, width: AXLE[1] };
    let loads = MovingLoads::on_road(&wheels, crossing, &surface);
    let mut forces = vec![0.0; 2 * count];
    for (node, force) in top.iter().zip(loads.forces(at, surface.len())) {
        forces[2 * node.index() + 1] = -force;
    }
    solved(model, forces)
}

fn solved(model: &Model, forces: Vec<f64>) -> State {
    let (mut state, mut work) = (State::new(model), Workspace::new(model).unwrap());
    let settings = Settings { tolerance: 1e-10, load_steps: 1, ..Settings::default() };
    let target = Target { forces, imposed: Vec::new() };
    let outcome = advance(model, &mut state, &mut work, &target, &settings, &mut Unwatched);
    assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
    state
}

/// Vertical displacement of a node [m].
fn moved(state: &State, node: usize) -> f64 {
    state.displacements[2 * node + 1]
}

/// Middle of a quadrilateral and its mean vertical stress [Pa].
fn pressed(model: &Model, state: &State, quad: QuadId) -> (Vec2, f64) {
    let middle = model.corners(quad).into_iter().fold(Vec2::ZERO, |sum, corner| sum + corner * 0.25);
    let points = &state.points[4 * quad.index()..4 * quad.index() + 4];
    (middle, points.iter().map(|point| 0.25 * point.stress[1]).sum())
}

/// Solves a system of equations by elimination with row exchanges.
fn eliminated<const N: usize>(mut rows: [[f64; N]; N], mut right: [f64; N]) -> [f64; N] {
    for k in 0..N {
        let pivot = (k..N).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs())).unwrap();
        rows.swap(k, pivot);
        right.swap(k, pivot);
        for below in k + 1..N {
            let share = rows[below][k] / rows[k][k];
            (k..N).for_each(|j| rows[below][j] -= share * rows[k][j]);
            right[below] -= share * right[k];
        }
    }
    for k in (0..N).rev() {
        let sum: f64 = (k + 1..N).map(|j| rows[k][j] * right[j]).sum();
        right[k] = (right[k] - sum) / rows[k][k];
    }
    right
}

/// Four parts of Airy's function `f(y) cos(k x)` in a layer from `bottom` to `top`, which decay from one of them: `f`, and its derivatives by `k y`.
fn airy(k: f64, y: f64, [bottom, top]: [f64; 2]) -> [[f64; 4]; 4] {
    let (s, t) = (k * (y - top), k * (y - bottom));
    let (up, down) = (s.exp(), (-t).exp());
    std::array::from_fn(|order| {
        let n = order as f64;
        let sign = if order % 2 == 0 { 1.0 } else { -1.0 };
        [up, (n + s) * up, sign * down, sign * (t - n) * down]
    })
}

/// One harmonic of plane strain in two layers on rock: what its four parts in each come to for a pressure of one at the top, with unit `k`.
struct Harmonic {
    k: f64,
    parts: [f64; 8],
    layers: [Layer; 2],
}

impl Harmonic {
    /// Level of both ends of a layer above the rock [m].
    fn ends(layers: &[Layer; 2], k: usize) -> [f64; 2] {
        if k == 0 { [layers[1][0], layers[1][0] + layers[0][0]] } else { [0.0, layers[1][0]] }
    }

    /// Stress `yy` and `xy`, displacements `x` and `y` of each part, at a level.
    fn of(layers: &[Layer; 2], layer: usize, k: f64, y: f64) -> [[f64; 4]; 4] {
        let [_, modulus, ratio] = layers[layer];
        let [f, f1, f2, f3] = airy(k, y, Harmonic::ends(layers, layer));
        let soft = (1.0 + ratio) / modulus / k;
        let each = |of: &dyn Fn(usize) -> f64| -> [f64; 4] { std::array::from_fn(of) };
        [
            each(&|i| -f[i]),
            each(&|i| f1[i]),
            each(&|i| soft * ((1.0 - ratio) * f2[i] + ratio * f[i])),
            each(&|i| soft * ((1.0 - ratio) * f3[i] + (ratio - 2.0) * f1[i])),
        ]
    }

    fn new(layers: [Layer; 2], k: f64) -> Harmonic {
        let (between, top) = (layers[1][0], layers[1][0] + layers[0][0]);
        let size = [1.0, 1.0, k * layers[1][1], k * layers[1][1]];
        let [above, below] = [0, 1].map(|layer| Harmonic::of(&layers, layer, k, between));
        let surface = Harmonic::of(&layers, 0, k, top);
        let rock = Harmonic::of(&layers, 1, k, 0.0);
        let (mut rows, mut right) = ([[0.0; 8]; 8], [0.0; 8]);
        for i in 0..4 {
            (rows[0][i], rows[1][i]) = (surface[0][i], surface[1][i]);
            (rows[2][4 + i], rows[3][4 + i]) = (size[2] * rock[2][i], size[3] * rock[3][i]);
            for what in 0..4 {
                (rows[4 + what][i], rows[4 + what][4 + i]) =
                    (size[what] * above[what][i], -size[what] * below[what][i]);
            }
        }
        right[0] = -1.0;
        Harmonic { k, parts: eliminated(rows, right), layers }
    }

    /// Vertical stress and displacement at a level.
    fn at(&self, y: f64) -> [f64; 2] {
        let layer = usize::from(y < self.layers[1][0]);
        let all = Harmonic::of(&self.layers, layer, self.k, y);
        [0, 3].map(|what| all[what].iter().zip(&self.parts[4 * layer..]).map(|(a, b)| a * b).sum())
    }
}

/// Two layers on rock between smooth walls that are `length` [m] apart, under an even pressure: its harmonics.
struct Layered {
    layers: [Layer; 2],
    /// Size of each.
    pressures: Vec<f64>,
    harmonics: Vec<Harmonic>,
}

impl Layered {
    fn new(layers: [Layer; 2], length: f64, at: f64, pressed: f64, count: usize) -> Layered {
        let pressure = FORCE / pressed;
        let of = |n: usize| {
            let (k, ends) = (n as f64 * PI / length, [at + 0.5 * pressed, at - 0.5 * pressed]);
            2.0 * pressure / (k * length) * ((k * ends[0]).sin() - (k * ends[1]).sin())
        };
        let pressures = (1..=count).map(of).collect();
        let harmonics = (1..=count).map(|n| Harmonic::new(layers, n as f64 * PI / length)).collect();
        Layered { layers, pressures, harmonics }
    }

    /// Vertical stress [Pa] and displacement [m] beside those of the even part `mean` of the pressure [Pa].
    fn at(&self, mean: f64, place: Vec2) -> [f64; 2] {
        let (mut stress, mut down) = (-mean, 0.0);
        for (layer, [_, modulus, ratio]) in self.layers.iter().enumerate() {
            let [bottom, top] = Harmonic::ends(&self.layers, layer);
            let confined = modulus * (1.0 - ratio) / ((1.0 + ratio) * (1.0 - 2.0 * ratio));
            down -= mean / confined * (place.y.min(top) - bottom).max(0.0);
        }
        for (pressure, harmonic) in self.pressures.iter().zip(&self.harmonics) {
            let ([own, moved], cos) = (harmonic.at(place.y), (harmonic.k * place.x).cos());
            stress += pressure * own * cos;
            down += pressure * moved * cos;
        }
        [stress, down]
    }
}

/// Surfacing of 0.25 m on 1.25 m of fill.
const LAYERS: [Layer; 2] = [[0.25, 1e9, 0.3], [1.25, 60e6, 0.25]];
const LENGTH: f64 = 4.0;
const PRESSED: f64 = 0.4;
const AT: f64 = 1.93;

/// Errors of the surface's deflection and of the stress across the depth with so many elements in a quarter of a metre, in the mean square, over the
/// largest deflection and the pressure.
fn errors(fine: usize, exact: &Layered) -> [f64; 2] {
    let depth = LAYERS[0][0] + LAYERS[1][0];
    let count = [16 * fine, 6 * fine];
    let place = |s: f64, t: f64| vec2(LENGTH * s, depth * t);
    let mesh = grid(count, 2, |row| usize::from(row < 5 * fine), place);
    let nodes = mesh.nodes.pairs();
    let supports: Vec<Support> = nodes
        .filter(|(_, p)| p.y == 0.0 || p.x == 0.0 || p.x == LENGTH)
        .map(|(node, p)| Support { node, held: [true, p.y == 0.0] })
        .collect();
    let sections = LAYERS.map(|[_, modulus, ratio]| section(modulus, ratio, Plane::Strain)).into_iter().collect();
    let model = Model::new(mesh, sections, Vec::new(), &supports, Kinematics::Small).unwrap();
    let state = under_an_axle(&model, count[0], AT, PRESSED);
    let mean = FORCE / LENGTH;
    let (mut off, mut most) = (0.0, 0.0f64);
    for i in 0..=count[0] {
        let node = count[1] * (count[0] + 1) + i;
        let [_, down] = exact.at(mean, vec2(LENGTH * i as f64 / count[0] as f64, depth));
        off += (moved(&state, node) - down).powi(2) / (count[0] + 1) as f64;
        most = most.max(down.abs());
    }
    let mut stress = (0.0, 0.0);
    for (quad, _) in model.mesh.quads.pairs() {
        let (middle, found) = pressed(&model, &state, quad);
        // Two patch lengths and more below the edges of the patch.
        if middle.y < depth - 2.0 * PRESSED {
            stress = (stress.0 + (found - exact.at(mean, middle)[0]).powi(2), stress.1 + 1.0);
        }
    }
    [off.sqrt() / most, f64::sqrt(stress.0 / stress.1) / (FORCE / PRESSED)]
}

/// Deflection of the surface and stress at depth converge to the series of the layered strip with the square of the element's size.
#[test]
fn a_wheel_on_layers_deflects_and_presses_them_as_the_series_says() {
    let exact = Layered::new(LAYERS, LENGTH, AT, PRESSED, 600);
    // The ends of the wheel lie within elements, by another share of each mesh, so that the order is two but for some.
    let found = [2, 4, 8].map(|fine| errors(fine, &exact));
    for pair in found.windows(2) {
        for what in 0..2 {
            let order = (pair[0][what] / pair[1][what]).log2();
            assert!((1.7..2.3).contains(&order), "{what}: {order} of {found:?}");
        }
    }
    // What the square of a thirteenth of the wheel, the size of an element, leaves: 6e-3 of what happens within a wheel's length, of which the whole depth sees less.
    assert!(found[2][0] < 2e-4 && found[2][1] < 5e-5, "{found:?}");
}

/// A half plane: stress below a patch (Flamant's, summed over the patch), and how much deeper the surface goes there than beside it.
#[test]
fn a_wheel_on_a_half_plane_presses_it_as_flamant_says() {
    let (modulus, ratio, half) = (60e6, 0.25, 0.5 * PRESSED);
    let (wide, deep, count) = (80.0, 80.0, 160usize);
    let graded = |s: f64| (6.0 * s).sinh() / 6.0f64.sinh();
    let place = |s: f64, t: f64| vec2(wide * graded(2.0 * s - 1.0), -deep * graded(1.0 - t));
    let mesh = grid([count, count / 2], 1, |_| 0, place);
    let nodes = mesh.nodes.pairs();
    let supports: Vec<Support> = nodes
        .filter(|(_, p)| p.y < 1e-9 - deep || p.x.abs() > wide - 1e-9)
        .map(|(node, p)| Support { node, held: [true, p.y < 1e-9 - deep] })
        .collect();
    let model = Model::new(
        mesh,
        [section(modulus, ratio, Plane::Strain)].into_iter().collect(),
        Vec::new(),
        &supports,
        Kinematics::Small,
    )
    .unwrap();
    let state = under_an_axle(&model, count, 0.0, PRESSED);
    let pressure = FORCE / PRESSED;
    let (mut worst, mut looked_at) = (0.0f64, 0);
    for (quad, _) in model.mesh.quads.pairs() {
        let (middle, found) = pressed(&model, &state, quad);
        if middle.x.abs() > 2.0 || !(-3.0..=-2.0 * PRESSED).contains(&middle.y) {
            continue;
        }
        let part = |edge: f64| {
            let angle = ((middle.x + edge) / -middle.y).atan();
            angle + angle.sin() * angle.cos()
        };
        let exact = -pressure / PI * (part(half) - part(-half));
        (worst, looked_at) = (worst.max((found - exact).abs() / pressure), looked_at + 1);
    }
    assert!(worst < 2e-3 && looked_at > 200, "{worst} {looked_at}");
    let surface = |x: f64| {
        let part = |to: f64| to * to.abs().max(1e-300).ln();
        2.0 * (1.0 - ratio * ratio) / (PI * modulus) * pressure * (part(x + half) - part(x - half))
    };
    let node = |i: usize| (count / 2) * (count + 1) + i;
    let at = |i: usize| model.mesh.nodes[NodeId::new(node(i))].x;
    let middle = count / 2;
    for i in (middle + 10..count).step_by(10).filter(|i| at(*i) < 3.0) {
        let (found, exact) = (moved(&state, node(middle)) - moved(&state, node(i)), surface(0.0) - surface(at(i)));
        assert!((found / exact - 1.0).abs() < 5e-3, "{}: {found} {exact}", at(i));
    }
}

/// A circular arch clamped at both springings as a curved beam that bends, stretches and shears (Castigliano): vertical displacement [m] at `seen` under a vertical
/// force [N/m] at `loaded`, angles from the crown to the right.
struct CurvedBeam {
    radius: f64,
    thickness: f64,
    half_angle: f64,
    modulus: f64,
    ratio: f64,
}

impl CurvedBeam {
    /// Thrust, shear and moment at an angle of a force of one at `from`, downwards 0, of the right end's reactions: to the left 1, up 2, moment 3.
    fn actions(&self, what: usize, from: f64, angle: f64) -> [f64; 3] {
        let place = |a: f64| vec2(self.radius * a.sin(), self.radius * a.cos());
        let (here, end) = (place(angle), place(self.half_angle));
        // Sums of what acts on the part to the right.
        let (force, at, moment) = match what {
            0 if from > angle => (vec2(0.0, -1.0), place(from), 0.0),
            1 => (vec2(-1.0, 0.0), end, 0.0),
            2 => (vec2(0.0, 1.0), end, 0.0),
            3 => (Vec2::ZERO, end, 1.0),
            _ => (Vec2::ZERO, end, 0.0),
        };
        let tangent = vec2(angle.cos(), -angle.sin());
        [force.dot(tangent), force.cross(tangent), (at - here).cross(force) + moment]
    }

    /// Work of one set of actions on the strains of another.
    fn work(&self, one: (usize, f64), other: (usize, f64)) -> f64 {
        const STEPS: usize = 4000;
        let (area, inertia) = (self.thickness, self.thickness.powi(3) / 12.0);
        let shear = 5.0 / 6.0 * area * self.modulus / (2.0 * (1.0 + self.ratio));
        let soft = [1.0 / (self.modulus * area), 1.0 / shear, 1.0 / (self.modulus * inertia)];
        let step = 2.0 * self.half_angle / STEPS as f64;
        let at = |k: usize| {
            let angle = -self.half_angle + (k as f64 + 0.5) * step;
            let [a, b] = [one, other].map(|(what, from)| self.actions(what, from, angle));
            (0..3).map(|i| a[i] * b[i] * soft[i]).sum::<f64>() * self.radius * step
        };
        (0..STEPS).map(at).sum()
    }

    fn sinks(&self, loaded: f64, seen: f64) -> f64 {
        let gaps = [1, 2, 3].map(|i| -self.work((i, 0.0), (0, loaded)));
        let reactions = eliminated([1, 2, 3].map(|i| [1, 2, 3].map(|j| self.work((i, 0.0), (j, 0.0)))), gaps);
        let held: f64 = [1, 2, 3].iter().zip(reactions).map(|(i, r)| r * self.work((0, seen), (*i, 0.0))).sum();
        self.work((0, seen), (0, loaded)) + held
    }
}

/// A beam jacked down across an elastic arch: the arch sinks, and rises on the other side, as a curved beam does.
#[test]
fn a_beam_across_an_arch_bends_it_as_castigliano_says() {
    let arch = CurvedBeam { radius: 5.0, thickness: 0.3, half_angle: 1.0, modulus: 5e9, ratio: 0.2 };
    let (count, through) = (240usize, 8usize);
    let place = |s: f64, t: f64| {
        let (angle, radius) = (arch.half_angle * (2.0 * s - 1.0), arch.radius + arch.thickness * (t - 0.5));
        vec2(radius * angle.sin(), radius * angle.cos())
    };
    let mesh = grid([count, through], 1, |_| 0, place);
    let node = |i: usize, j: usize| j * (count + 1) + i;
    let ends = (0..=through).flat_map(|j| [node(0, j), node(count, j)]);
    let supports: Vec<Support> = ends.map(|k| Support { node: NodeId::new(k), held: [true; 2] }).collect();
    let sections = [section(arch.modulus, arch.ratio, Plane::Stress)].into_iter().collect();
    let model = Model::new(mesh, sections, Vec::new(), &supports, Kinematics::Small).unwrap();
    let chain: Vec<[f64; 2]> =
        (0..=count).map(|i| model.mesh.nodes[NodeId::new(node(i, through))]).map(|place| [place.x, place.y]).collect();
    // At a quarter of its angle, and at the crown.
    for loaded in [count / 4, count / 2] {
        let mut forces = vec![0.0; 2 * model.mesh.nodes.len()];
        for (i, share) in strip(&chain, chain[loaded][0] - 0.05, chain[loaded][0] + 0.05) {
            forces[2 * node(i, through) + 1] -= FORCE * share;
        }
        let state = solved(&model, forces);
        let angle = |i: usize| arch.half_angle * (2.0 * i as f64 / count as f64 - 1.0);
        // The force on the face passes the axis below it.
        let from = (chain[loaded][0] / arch.radius).asin();
        let largest = FORCE * arch.sinks(from, from);
        for seen in (count / 8..count).step_by(count / 8) {
            // On the axis of the ring: below the beam the face itself gives way. A curved beam leaves out the square of thickness over radius, 0.4 %, and the
            // force of the beam spreads through half the thickness, three hundredths of the radius.
            let (found, exact) = (-moved(&state, node(seen, through / 2)), FORCE * arch.sinks(from, angle(seen)));
            assert!((found - exact).abs() < 0.01 * largest, "{loaded} {seen}: {found} {exact} of {largest}");
        }
    }
}
