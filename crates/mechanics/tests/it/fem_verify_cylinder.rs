//! Thick cylinders in plane strain under pressure from within, elastic outside, plastic inside.
//!
//! Closed form (Yu 1992, "Expansion of a thick cylinder of soils", Computers and Geotechnics 14, with no pressure outside; also
//! Chen and Han 1988): with α = (1 + sin φ)/(1 − sin φ) and Y = 2 c cos φ/(1 − sin φ), α σθ − σr = Y from the bore to the radius
//! of yield, Lamé's stresses beyond it. Balance and yield alone fix the stresses, so that they are those of any dilatancy.

use crate::fem_stress::stress_at;
use crate::fem_tools::{carried, forces, grid, held, model, moved, node, of};
use mechanics::fem::law::{Cone, DruckerPrager, Elastic, Material, MohrCoulomb, Plane};
use mechanics::fem::{Element, Kinematics, Model, Settings, State, Status, Target, reactions};
use mechanics::ids::{Id, QuadId};
use mechanics::plane::{Vec2, vec2};
use std::f64::consts::FRAC_PI_2;

const BORE: f64 = 1.0;
const OUTER: f64 = 2.0;
const COHESION: f64 = 10e3;
const FRICTION: f64 = 30.0;

/// The closed form for a radius of yield.
struct Exact {
    alpha: f64,
    strength: f64,
    yielded: f64,
}

impl Exact {
    fn new(yielded: f64) -> Exact {
        let (sin, cos) = FRICTION.to_radians().sin_cos();
        Exact { alpha: (1.0 + sin) / (1.0 - sin), strength: 2.0 * COHESION * cos / (1.0 - sin), yielded }
    }

    /// Lamé's constant of the elastic part [N].
    fn lame(&self) -> f64 {
        let (c, b) = (self.yielded.powi(2), OUTER.powi(2));
        self.strength / ((self.alpha + 1.0) / c + (self.alpha - 1.0) / b)
    }

    /// Radial and hoop stress [Pa], positive in tension.
    fn stress(&self, r: f64) -> [f64; 2] {
        let elastic = |r: f64| {
            let (here, outside) = (self.lame() / (r * r), self.lame() / (OUTER * OUTER));
            [outside - here, outside + here]
        };
        if r >= self.yielded {
            return elastic(r);
        }
        let rest = self.strength / (self.alpha - 1.0);
        let power = -(self.alpha - 1.0) / self.alpha;
        let radial = rest + (elastic(self.yielded)[0] - rest) * (r / self.yielded).powf(power);
        [radial, (self.strength + radial) / self.alpha]
    }

    fn pressure(&self) -> f64 {
        -self.stress(BORE)[0]
    }

    /// Outward displacement of the outer face [m].
    fn outward(&self, elastic: &Elastic) -> f64 {
        2.0 * (1.0 - elastic.ratio.powi(2)) * self.lame() / (elastic.modulus * OUTER)
    }
}

/// A quarter of the cylinder, `n` elements through its wall; the bore is free or held.
fn quarter(n: usize, material: Material, bore_held: bool) -> Model {
    let mesh = grid(n, n, |along, around| {
        let (r, angle) = (BORE + along * (OUTER - BORE), around * FRAC_PI_2);
        vec2(r * angle.cos(), r * angle.sin())
    });
    let mut supports = Vec::new();
    for i in 0..=n {
        supports.push(held(node(n, i, 0), false, true));
        supports.push(held(node(n, i, n), true, false));
    }
    if bore_held {
        supports.extend((0..=n).map(|j| held(node(n, 0, j), true, true)));
    }
    model(mesh, of(material, Plane::Strain, Element::QM6), &supports, Kinematics::Small)
}

fn pressed(model: &Model, n: usize, pressure: f64) -> Vec<f64> {
    let mut list = Vec::new();
    for j in 0..n {
        let ends = [node(n, 0, j), node(n, 0, j + 1)];
        let way: Vec2 = model.mesh.nodes[ends[1]] - model.mesh.nodes[ends[0]];
        for end in ends {
            list.push((end, 0.5 * pressure * way.y, -0.5 * pressure * way.x));
        }
    }
    forces(model, &list)
}

/// Relative errors of the outer displacement, and of the stresses (root of mean square over the elements' centres, over the pressure).
fn errors(n: usize, material: Material, exact: &Exact) -> [f64; 2] {
    let model = quarter(n, material, false);
    let settings = Settings { tolerance: 1e-8, load_steps: 10, ..Settings::default() };
    let target = Target { forces: pressed(&model, n, exact.pressure()), imposed: Vec::new() };
    let (state, _, outcome) = carried(&model, &target, &settings);
    assert_eq!(outcome.status, Status::Completed, "{material:?}: {outcome:?}");
    let outward = moved(&state, node(n, n, 0))[0];
    [(outward / exact.outward(&material.elastic()) - 1.0).abs(), stress_error(&model, &state, exact)]
}

fn stress_error(model: &Model, state: &State, exact: &Exact) -> f64 {
    let mut sum = 0.0;
    for quad in model.mesh.quads.ids() {
        let place = model.corners(quad).iter().fold(Vec2::ZERO, |sum, corner| sum + *corner * 0.25);
        let [x, y, _, xy] = stress_at(model, state, QuadId::new(quad.index()), place).unwrap();
        let way = place.unit();
        let radial = x * way.x * way.x + y * way.y * way.y + 2.0 * xy * way.x * way.y;
        let hoop = x + y - radial;
        let known = exact.stress(place.norm());
        sum += (radial - known[0]).powi(2) + (hoop - known[1]).powi(2);
    }
    (sum / (2 * model.mesh.quads.len()) as f64).sqrt() / exact.pressure()
}

fn pyramid(dilatancy: f64) -> Material {
    Material::MohrCoulomb(MohrCoulomb {
        elastic: Elastic { modulus: 50e6, ratio: 0.3 },
        cohesion: COHESION,
        friction_angle: FRICTION.to_radians(),
        dilatancy_angle: dilatancy.to_radians(),
        tension_cutoff: None,
    })
}

fn cone(ratio: f64, dilatancy: f64) -> Material {
    let elastic = Elastic { modulus: 50e6, ratio };
    let (friction, dilatancy) = (FRICTION.to_radians(), dilatancy.to_radians());
    Material::DruckerPrager(DruckerPrager::matching(elastic, Cone::PlaneStrain, COHESION, friction, dilatancy))
}

#[test]
fn a_cylinder_of_mohr_and_coulomb_yields_half_way() {
    let exact = Exact::new(1.5);
    for dilatancy in [30.0, 10.0, 0.0] {
        let [coarse, fine] = [8, 16].map(|n| errors(n, pyramid(dilatancy), &exact));
        // The bore of straight sides feels less of the pressure by sin δ/δ, δ = π/2n, 0.16 % here; displacements and stresses at the
        // centres of elements converge with the square of the mesh size.
        assert!(fine[0] < 1e-3 && fine[1] < 3e-3, "{dilatancy}: {fine:?}");
        assert!(fine[0] < 0.3 * coarse[0] && fine[1] < 0.3 * coarse[1], "{dilatancy}: {coarse:?} {fine:?}");
    }
}

#[test]
fn a_cylinder_of_drucker_and_prager_yields_half_way() {
    // Flow without change of volume leaves, in a body that elasticity keeps at its volume too, the stress across half way between
    // the other two from the first on, where this cone is the pyramid: the same closed form. At ν 0.4999 it is so within 1e-4.
    let exact = Exact::new(1.5);
    let [coarse, fine] = [8, 16].map(|n| errors(n, cone(0.4999, 0.0), &exact));
    assert!(fine[0] < 1e-3 && fine[1] < 3e-3, "{fine:?}");
    assert!(fine[0] < 0.3 * coarse[0] && fine[1] < 0.3 * coarse[1], "{coarse:?} {fine:?}");
}

#[test]
fn cylinders_burst_at_the_same_pressure() {
    // Yielded throughout: p = Y/(α − 1) ((b/a)^((α − 1)/α) − 1). There elastic strains no longer change, so that the cone matched for
    // its own dilatancy gives it as well, at any Poisson's ratio.
    let exact = Exact::new(OUTER);
    let burst = exact.strength / (exact.alpha - 1.0) * ((OUTER / BORE).powf((exact.alpha - 1.0) / exact.alpha) - 1.0);
    assert!((exact.pressure() / burst - 1.0).abs() < 1e-12);
    let n = 12;
    for material in [pyramid(30.0), pyramid(0.0), cone(0.3, 30.0), cone(0.3, 0.0)] {
        let model = quarter(n, material, true);
        let push = 20e-3;
        let imposed = (0..=n).flat_map(|j| {
            let angle = FRAC_PI_2 * j as f64 / n as f64;
            [(node(n, 0, j), 0, push * angle.cos()), (node(n, 0, j), 1, push * angle.sin())]
        });
        let target = Target { forces: vec![0.0; 2 * model.mesh.nodes.len()], imposed: imposed.collect() };
        let (state, mut work, outcome) =
            carried(&model, &target, &Settings { tolerance: 1e-8, load_steps: 20, ..Settings::default() });
        assert_eq!(outcome.status, Status::Completed, "{material:?}: {outcome:?}");
        let pushes = reactions(&model, &mut work, &state);
        // Radial components of the reactions over the arc of the bore.
        let radial: f64 = (0..=n)
            .map(|j| {
                let (sin, cos) = (FRAC_PI_2 * j as f64 / n as f64).sin_cos();
                let at = node(n, 0, j).index();
                // Supports of symmetry push across the radius at the two ends alone.
                pushes[2 * at] * cos + pushes[2 * at + 1] * sin
            })
            .sum();
        // What a pressure on the straight sides of the bore gives them.
        let pressure = radial / (n as f64 * (FRAC_PI_2 / n as f64).sin());
        // The mesh's own error on stresses, 12 elements through the wall.
        assert!((pressure / burst - 1.0).abs() < 1e-3, "{material:?}: {pressure} of {burst}");
    }
}
