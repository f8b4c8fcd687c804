//! Parts that screening or the recheck proves linear are linear by their laws, on both sides of the limit and as near to it as
//! floating-point numbers are.

use super::*;
use crate::fem::joint::{Contact, JointLaw, LiftOff, Mortar, PairState, Shear};
use crate::fem::law::{Cone, DruckerPrager, Elastic, Material, Plane, Solid};
use crate::fem::many::{WIDEST, WIDTHS};
use crate::fem::settings::Kinematics;
use crate::fem::state::State;
use crate::fem::{Element, Interface, Mesh, Quad, Quadrature, Section, Support};
use crate::ids::{Id, NodeId};
use crate::plane::vec2;

/// Numbers between -1 and 1, always the same.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Quadrilaterals of several shapes, each by itself, and an interface of every law.
fn model(cohesion: f64) -> Model {
    let mut mesh = Mesh::default();
    let fill = mesh.zones.push("fill".into());
    let mut held = Vec::new();
    let shapes = [
        [[0.0, 0.0], [0.2, 0.0], [0.2, 0.1], [0.0, 0.1]],
        [[0.0, 0.0], [0.3, 0.1], [0.4, 0.4], [0.1, 0.3]],
        [[5.0, 7.0], [5.1, 6.98], [5.13, 7.05], [4.97, 7.09]],
        [[0.0, 0.0], [1.0, 0.1], [0.6, 0.5], [-0.1, 0.9]],
        [[0.0, 0.0], [1.0, 0.1], [0.6, 0.5], [-0.1, 0.9]],
    ];
    for corners in shapes {
        let nodes = corners.map(|[x, y]| mesh.nodes.push(vec2(x, y)));
        mesh.quads.push(Quad { nodes, zone: fill });
    }
    held.push(Support { node: NodeId::new(19), held: [true, false] });
    let mortar = |lift_off, compressive_strength, shear| {
        let (normal, tangential) = (1e11, 4e10);
        Mortar { normal, tangential, lift_off, compressive_strength, shear }
    };
    let panel = |when_open| Shear::Panel { strength: 1e6, when_open };
    let contact = |separation, rounding, cohesion| {
        let (normal, tangential, friction) = (1e10, 4e9, 0.4);
        Contact { normal, tangential, friction, cohesion, separation, rounding }
    };
    let joints = vec![
        JointLaw::Contact(Contact { friction: 0.0, ..contact(false, 0.0, f64::INFINITY) }),
        JointLaw::Mortar(mortar(LiftOff::Force(1e3), None, panel(false))),
        JointLaw::Mortar(mortar(LiftOff::Stress(0.0), Some(5e6), panel(true))),
        JointLaw::Mortar(mortar(LiftOff::Force(1e3), None, Shear::Friction { coefficient: 0.6, cohesion: 2e3 })),
        JointLaw::Mortar(mortar(LiftOff::Stress(0.0), None, Shear::Friction { coefficient: 0.7, cohesion: 0.0 })),
        JointLaw::Contact(contact(false, 500.0, 0.0)),
        JointLaw::Contact(contact(false, 500.0, 2e3)),
        JointLaw::Contact(contact(false, 0.0, 2e3)),
        JointLaw::Contact(contact(true, 0.0, 2e3)),
    ];
    for kind in 0..joints.len() {
        for quadrature in [Quadrature::Nodal, Quadrature::Gauss] {
            let mut face = |high: f64| [0.0, 0.2, 0.5].map(|x| mesh.nodes.push(vec2(x, 0.3 * x + high))).to_vec();
            let (one, two) = (face(0.0), face(0.01));
            held.push(Support { node: one[1], held: [kind % 2 == 0, true] });
            mesh.interfaces.push(Interface { one, two, kind, quadrature });
        }
    }
    mesh.kinds = joints.iter().map(|law| format!("{law:?}")).collect();
    let cone = DruckerPrager::matching(Elastic { modulus: 1e8, ratio: 0.3 }, Cone::PlaneStrain, cohesion, 0.6, 0.1);
    let solid = Solid { material: Material::DruckerPrager(cone), plane: Plane::Strain };
    let sections = [Section { solid, element: Element::Q4, density: 1800.0 }].into_iter().collect();
    Model::new(mesh, sections, joints, &held, Kinematics::Small).unwrap()
}

/// Parts of a state, untouched or with a past, and their screening.
struct Case {
    model: Model,
    parts: Vec<Part>,
    screening: Screening,
}

impl Case {
    fn new(cohesion: f64, past: bool, dice: &mut Dice) -> Case {
        let model = model(cohesion);
        let mut state = State::new(&model);
        if past {
            state.displacements.iter_mut().for_each(|u| *u = 1e-7 * dice.roll());
            for point in &mut state.points {
                point.memory.plastic = std::array::from_fn(|_| 1e-6 * dice.roll());
            }
            for (k, bond) in state.bonds.iter_mut().enumerate() {
                bond.memory.slip = 1e-7 * dice.roll();
                bond.memory.crush = -1e-7 * dice.roll().abs();
                bond.memory.broken = k % 3 == 0;
                bond.memory.state = if k % 5 == 4 { PairState::Sliding } else { PairState::Closed };
            }
        }
        let springs = (0..model.springs.len()).map(|index| Part::spring(&model, &state, index));
        let quads = model.mesh.quads.pairs().map(|(id, _)| Part::quad(&model, &state, id).unwrap());
        let mut parts: Vec<Part> = springs.chain(quads).collect();
        parts.iter_mut().for_each(|part| part.set_initial_excess(&model).unwrap());
        let screening = Screening::new(&model, &parts);
        Case { model, parts, screening }
    }

    /// Solutions that are zero but for one lane, which holds `share` times the displacements `direction` [m].
    fn block(&self, direction: &[f64], share: f64, lane: usize, width: usize) -> Block {
        let mut values = vec![0.0; width * direction.len()];
        values
            .chunks_exact_mut(width)
            .zip(direction)
            .for_each(|(solutions, direction)| solutions[lane] = share * direction);
        Block { width, lanes: values, place: Vec::new() }
    }

    /// Whether a part is linear by its law.
    fn is_linear(&mut self, index: usize, direction: &[f64], share: f64) -> bool {
        let block = self.block(direction, share, 0, WIDTHS[0]);
        self.parts[index].evaluate_in(&self.model, &block, 0).unwrap();
        self.parts[index].linear
    }

    /// Whether the part is proven linear by screening and by the recheck. Solutions beyond those asked for do not count.
    fn proves_linear(&self, index: usize, direction: &[f64], share: f64, lane: usize) -> [bool; 2] {
        let skip: Vec<bool> = (0..self.parts.len()).map(|other| other != index).collect();
        let narrow = self.block(direction, share, lane % 7, WIDTHS[0]);
        let wide = self.block(direction, share, lane, WIDEST);
        let screened =
            |block: &Block, solutions: usize| self.screening.unproven(&self.model, block, solutions, &skip).is_empty();
        let plain = |block, solutions| self.screening.screen::<false>(&self.model, block, solutions, &skip);
        let found = [screened(&narrow, 7), self.parts[index].proves_linear(&self.model, &narrow, 7)];
        assert_eq!(found, [screened(&wide, 19), self.parts[index].proves_linear(&self.model, &wide, 19)]);
        assert!(screened(&wide, 0));
        // Processors without fused multiply-add may differ by rounding, never beyond the limit.
        [found[0] | plain(&narrow, 7).is_empty(), found[1]]
    }
}

/// Distances to the limit at which a part is tested, over the limit.
const NEAR: [f64; 12] = [0.0, 3e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-8, 1e-5, 1e-2, 0.5];

/// Counts over the tested directions of one part.
#[derive(Default)]
struct Seen {
    limits: usize,
    /// Directions in which it was proven linear at one ten-thousandth below its limit, by screening and by the recheck.
    close: [usize; 2],
    /// The same at three tenths of the limit.
    far: [usize; 2],
}

/// Finds the limit of a part along a direction by bisection, and holds the tests to the law on both sides of it.
fn test_direction(case: &mut Case, index: usize, direction: &[f64], dice: &mut Dice, seen: &mut Seen) {
    if !case.is_linear(index, direction, 0.0) {
        assert_eq!(case.proves_linear(index, direction, 0.0, 3), [false; 2], "part {index} at rest");
        return;
    }
    let mut high = 1e-9;
    while case.is_linear(index, direction, high) {
        high *= 2.0;
        if high > 1.0 {
            return;
        }
    }
    let mut low = 0.0;
    while let middle = 0.5 * (low + high)
        && middle > low
        && middle < high
    {
        *(if case.is_linear(index, direction, middle) { &mut low } else { &mut high }) = middle;
    }
    for near in NEAR {
        for share in [low * (1.0 - near), high * (1.0 + near)] {
            let lane = (9.0 + 9.0 * dice.roll()) as usize;
            let proven = case.proves_linear(index, direction, share, lane);
            if proven.contains(&true) {
                assert!(
                    case.is_linear(index, direction, share),
                    "part {index}: {proven:?} at {share:e}, limit {low:e}"
                );
            }
        }
    }
    // A spring without tensile strength is at its limit at once.
    if low < 1e-12 {
        return;
    }
    seen.limits += 1;
    for (share, count) in [(1.0 - 1e-4, &mut seen.close), (0.3, &mut seen.far)] {
        let proven = case.proves_linear(index, direction, share * low, 5);
        count.iter_mut().zip(proven).for_each(|(count, proven)| *count += usize::from(proven));
    }
}

/// Displacements of all equations: random, of one strain everywhere, or hourglasses along an axis.
fn direction(model: &Model, sort: usize, dice: &mut Dice) -> Vec<f64> {
    let [a, b, c, d] = [0; 4].map(|_| dice.roll());
    let of = |component: &u32| {
        let (node, axis) = (*component as usize / 2, *component as usize % 2);
        let place = model.mesh.nodes[NodeId::new(node)];
        match sort {
            0 => dice.roll(),
            1 if axis == 0 => a * place.x + b * place.y,
            1 => c * place.x + d * place.y,
            _ if axis == sort % 2 => [1.0, -1.0][node % 2],
            _ => 0.0,
        }
    };
    model.free().iter().map(of).collect()
}

#[test]
fn springs_proven_linear_are_linear() {
    let mut dice = Dice(1);
    for past in [false, true] {
        let mut case = Case::new(1e3, past, &mut dice);
        let mut all = Seen::default();
        for index in 0..case.model.springs.len() {
            for _ in 0..40 {
                let direction = direction(&case.model, 0, &mut dice);
                test_direction(&mut case, index, &direction, &mut dice, &mut all);
            }
        }
        // The test of a spring is its law itself, so that it leaves next to nothing to be evaluated.
        assert!(all.limits > 500, "{}", all.limits);
        assert!(all.close.iter().all(|close| 100 * close >= 99 * all.limits), "{:?} of {}", all.close, all.limits);
        assert_eq!(all.far, [all.limits; 2]);
    }
}

#[test]
fn quadrilaterals_proven_linear_are_linear() {
    let mut dice = Dice(2);
    for (cohesion, past) in [(1e3, false), (1e3, true), (1.0, false), (0.0, false)] {
        let mut case = Case::new(cohesion, past, &mut dice);
        for sort in 0..4 {
            let mut all = Seen::default();
            for index in case.model.springs.len()..case.parts.len() {
                for _ in 0..60 {
                    let direction = direction(&case.model, sort, &mut dice);
                    test_direction(&mut case, index, &direction, &mut dice, &mut all);
                }
            }
            if cohesion < 1e3 || past {
                continue;
            }
            assert!(all.limits >= 60, "sort {sort}: {}", all.limits);
            // The recheck at the points knows the limit itself; screening where one point is worst for all terms: the held corner
            // adds an hourglass.
            assert_eq!([all.close[1], all.far[1]], [all.limits; 2], "sort {sort}");
            assert!(10 * all.far[0] >= 8 * all.limits, "sort {sort}: {} of {}", all.far[0], all.limits);
            assert!(sort == 0 || 2 * all.close[0] >= all.limits, "sort {sort}: {} of {}", all.close[0], all.limits);
        }
    }
}
