//! Many positions of a load: the condensed path against the whole system, position by position.

use mechanics::fem::condensed::{
    Condensed, Derivatives, Functional, LoadPattern, PerturbedModel, Reached, load_pattern,
};
use mechanics::fem::joint::{Contact, JointLaw, LiftOff, Mortar, Shear};
use mechanics::fem::law::{Cone, DruckerPrager, Elastic, Material, Plane, Solid};
use mechanics::fem::{
    Element, Interface, Kinematics, Mesh, Model, Quad, Quadrature, Section, Settings, State, Status, Support, Target,
    Workspace, advance,
};
use mechanics::ids::{Id, NodeId};
use mechanics::plane::vec2;
use mechanics::watch::{Progress, Unwatched, Watch, Wish};

const STONES: usize = 8;
const ALONG: usize = 4;
const DEPTH: usize = 6;
const FILL: usize = 6;

/// A flat arch of stones between held ends, under fill: joints without tension, contact with friction.
struct Vault {
    model: Model,
    surface: Vec<NodeId>,
    crown: NodeId,
}

fn vault(fill: Material, kinematics: Kinematics) -> Vault {
    vault_of(fill, 16e9, 0.4, PANEL, kinematics)
}

const PANEL: Shear = Shear::Panel { strength: 1e6, when_open: false };

/// With stones of this modulus [Pa], this friction under the fill and this shear in the joints.
fn vault_of(fill: Material, modulus: f64, friction: f64, shear: Shear, kinematics: Kinematics) -> Vault {
    let (stone, thick, high) = (0.4, 0.5, 0.8);
    let mut mesh = Mesh::default();
    let (stones, soil) = (mesh.zones.push("stones".into()), mesh.zones.push("fill".into()));
    mesh.kinds = vec!["mortar joint".into(), "fill contact".into()];
    let mut held = Vec::new();
    // Rise of a flat arch, so that thrust keeps the joints shut.
    let whole = STONES as f64 * stone;
    let lift = |x: f64| 0.25 * (1.0 - (2.0 * x / whole - 1.0).powi(2));
    let mut faces: Vec<[Vec<NodeId>; 2]> = Vec::new();
    let mut backs = Vec::new();
    for s in 0..STONES {
        let at = |mesh: &mut Mesh, i: usize, j: usize| {
            let x = (s as f64 + i as f64 / ALONG as f64) * stone;
            mesh.nodes.push(vec2(x, lift(x) + thick * j as f64 / DEPTH as f64))
        };
        let nodes: Vec<Vec<NodeId>> = (0..=ALONG).map(|i| (0..=DEPTH).map(|j| at(&mut mesh, i, j)).collect()).collect();
        for i in 0..ALONG {
            for j in 0..DEPTH {
                mesh.quads.push(Quad {
                    nodes: [nodes[i][j], nodes[i + 1][j], nodes[i + 1][j + 1], nodes[i][j + 1]],
                    zone: stones,
                });
            }
        }
        faces.push([nodes[0].clone(), nodes[ALONG].clone()]);
        backs.push(nodes.iter().map(|column| column[DEPTH]).collect::<Vec<_>>());
    }
    // Walking up a face, side one lies on the right and side two on the left.
    for s in 1..STONES {
        mesh.interfaces.push(Interface {
            one: faces[s][0].clone(),
            two: faces[s - 1][1].clone(),
            kind: 0,
            quadrature: Quadrature::EqualSprings,
        });
    }
    let mut posts = [Vec::new(), Vec::new()];
    for (side, face) in [(0, &faces[0][0]), (1, &faces[STONES - 1][1])] {
        for node in face {
            let place = mesh.nodes[*node];
            let post = mesh.nodes.push(place);
            held.push(Support { node: post, held: [true, true] });
            posts[side].push(post);
        }
    }
    mesh.interfaces.push(Interface {
        one: faces[0][0].clone(),
        two: posts[0].clone(),
        kind: 0,
        quadrature: Quadrature::EqualSprings,
    });
    mesh.interfaces.push(Interface {
        one: posts[1].clone(),
        two: faces[STONES - 1][1].clone(),
        kind: 0,
        quadrature: Quadrature::EqualSprings,
    });
    let columns = STONES * ALONG;
    let grid: Vec<Vec<NodeId>> = (0..=columns)
        .map(|i| {
            let x = whole * i as f64 / columns as f64;
            let (low, top) = (lift(x) + thick, 0.25 + thick + high);
            (0..=FILL).map(|j| mesh.nodes.push(vec2(x, low + (top - low) * j as f64 / FILL as f64))).collect()
        })
        .collect();
    for i in 0..columns {
        for j in 0..FILL {
            mesh.quads
                .push(Quad { nodes: [grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]], zone: soil });
        }
    }
    for (s, back) in backs.iter().enumerate() {
        // Walking from right to left the stones lie on the left.
        let above: Vec<NodeId> = (0..=ALONG).map(|i| grid[s * ALONG + i][0]).collect();
        mesh.interfaces.push(Interface { one: back.clone(), two: above, kind: 1, quadrature: Quadrature::Nodal });
    }
    for column in [&grid[0], &grid[columns]] {
        held.extend(column.iter().map(|node| Support { node: *node, held: [true, false] }));
    }
    let surface = grid.iter().map(|column| column[FILL]).collect();
    let crown = faces[STONES / 2][0][0];
    let solid = |material| Solid { material, plane: Plane::Strain };
    let stones = solid(Material::Elastic(Elastic { modulus, ratio: 0.19 }));
    // As in a passage: soil that yields is of plain elements, which alone can be still.
    let soil = if fill.linear() { Element::QM6 } else { Element::Q4 };
    let sections = [
        Section { solid: stones, element: Element::QM6, density: 2200.0 },
        Section { solid: solid(fill), element: soil, density: 1800.0 },
    ]
    .into_iter()
    .collect();
    let joint =
        Mortar { normal: 100e9, tangential: 40e9, lift_off: LiftOff::Force(1e3), compressive_strength: None, shear };
    let contact =
        Contact { normal: 10e9, tangential: 4e9, friction, cohesion: 0.0, separation: false, rounding: 500.0 };
    let model =
        Model::new(mesh, sections, vec![JointLaw::Mortar(joint), JointLaw::Contact(contact)], &held, kinematics)
            .unwrap();
    Vault { model, surface, crown }
}

fn settings() -> Settings {
    Settings { tolerance: 1e-11, load_steps: 1, iteration_limit: 100, cut_limit: 8 }
}

/// Two axles that cross, spread over a few nodes each: amplitudes of unit forces on the surface's nodes.
fn amplitudes(vault: &Vault, index: usize, force: f64) -> Vec<f64> {
    let places: Vec<f64> = vault.surface.iter().map(|node| vault.model.mesh.nodes[*node].x).collect();
    let mut all = vec![0.0; places.len()];
    for axle in [0.0, 1.2] {
        let x = -1.0 + 0.1 * index as f64 + axle;
        let weights: Vec<f64> = places.iter().map(|p| (1.0 - (p - x).abs() / 0.3).max(0.0)).collect();
        let sum: f64 = weights.iter().sum();
        if sum > 0.0 {
            let here = (sum / 3.0).min(1.0);
            all.iter_mut().zip(&weights).for_each(|(a, w)| *a += force * here * w / sum);
        }
    }
    all
}

/// Largest difference of the observed values between the two paths over the largest value, over all positions; most springs that
/// were open and that slid, most points that yielded, and batches of which positions were solved again.
fn compare(fill: Material, force: f64) -> (f64, [usize; 4]) {
    compare_in(&vault(fill, Kinematics::Small), force)
}

fn compare_in(vault: &Vault, force: f64) -> (f64, [usize; 4]) {
    let model = &vault.model;
    let weight = model.weight(vec2(0.0, -9.81));
    let mut state = State::new(model);
    let mut work = Workspace::new(model).unwrap();
    let first = advance(
        model,
        &mut state,
        &mut work,
        &Target { forces: weight.clone(), imposed: vec![] },
        &Settings { load_steps: 10, ..settings() },
        &mut Unwatched,
    );
    assert_eq!(first.status, Status::Completed, "{first:?}");
    let patterns: Vec<LoadPattern> = vault.surface.iter().map(|node| down(*node)).collect();
    let observed: Vec<Functional> = (0..2)
        .map(|axis| vec![(2 * vault.crown.index() + axis, 1.0)])
        .chain([vec![(2 * vault.surface[9].index() + 1, 1.0)]])
        .collect();
    let mut condensed = Condensed::new(model.clone(), state.clone(), &patterns, &observed).unwrap();
    let count = 50;
    let passage = condensed.solve_positions(count, &|i| amplitudes(vault, i, force), &mut Unwatched).unwrap();
    assert_eq!((passage.visited.len(), passage.stopped_at), (count, None));
    let (mut worst, mut size) = (0.0_f64, 0.0_f64);
    let (mut open, mut sliding, mut yielding) = (0, 0, 0);
    for (index, visited) in passage.visited.iter().enumerate() {
        assert_eq!(visited.position.reached, Reached::Balanced);
        let mut forces = weight.clone();
        for (pattern, a) in patterns.iter().zip(amplitudes(vault, index, force)) {
            pattern.iter().for_each(|&(component, force)| forces[component] += a * force);
        }
        let outcome =
            advance(model, &mut state, &mut work, &Target { forces, imposed: vec![] }, &settings(), &mut Unwatched);
        assert_eq!(outcome.status, Status::Completed, "position {index}: {outcome:?}");
        for (functional, value) in observed.iter().zip(&visited.observed) {
            let plain: f64 = functional.iter().map(|&(c, w)| w * state.displacements[c]).sum();
            worst = worst.max((plain - value).abs());
            size = size.max(plain.abs());
        }
        let last = outcome.steps.last().unwrap();
        let (plain, condensed) = ([last.open, last.yielding], [visited.counts.open, visited.counts.yielding]);
        assert!(plain == condensed, "position {index}: {plain:?} {condensed:?}");
        (open, sliding, yielding) = (open.max(last.open), sliding.max(last.sliding), yielding.max(last.yielding));
    }
    // The whole state is that of the whole system, too.
    let whole = condensed.state().unwrap();
    let broken = |state: &State| state.bonds.iter().map(|bond| bond.memory.broken).collect::<Vec<bool>>();
    assert_eq!(broken(&state), broken(&whole));
    let stress = |s: &State| s.points.iter().flat_map(|p| p.stress).collect::<Vec<f64>>();
    let largest = stress(&state).iter().fold(0.0_f64, |m, s| m.max(s.abs()));
    let apart = stress(&whole).iter().zip(stress(&state)).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    assert!(apart <= 1e-6 * largest, "stress differs by {apart} of {largest}");
    (worst / size, [open, sliding, yielding, passage.repeated])
}

#[test]
fn joints_that_open_and_slide_give_the_plain_path_to_1e_8() {
    let (worst, [open, sliding, ..]) = compare(Material::Elastic(Elastic { modulus: 110e6, ratio: 0.19 }), 60e3);
    assert!(open > 0 && sliding > 0, "{open} open, {sliding} sliding: nothing to compare");
    assert!(worst <= 1e-8, "{worst:e}");
}

/// Joints that rub: their shear follows what presses, and vanishes where they open.
#[test]
fn joints_that_rub_give_the_plain_path_to_1e_8() {
    let fill = Material::Elastic(Elastic { modulus: 110e6, ratio: 0.19 });
    for (coefficient, cohesion) in [(1.5, 0.0), (1.5, 20e3)] {
        let rubs = Shear::Friction { coefficient, cohesion };
        let vault = vault_of(fill, 16e9, 10.0, rubs, Kinematics::Small);
        let (worst, [open, sliding, ..]) = compare_in(&vault, 60e3);
        assert!(open > 0 && sliding > 0, "{open} open, {sliding} sliding: nothing to compare");
        assert!(worst <= 1e-8, "cohesion {cohesion}: {worst:e}");
    }
}

/// Solved in batches or one by one, positions break the same springs of mortar: roll-backs, predictions and early retention do
/// not matter.
#[test]
fn batches_break_the_springs_of_single_positions() {
    let vault = vault(Material::Elastic(Elastic { modulus: 110e6, ratio: 0.19 }), Kinematics::Small);
    let model = &vault.model;
    let mut patterns = vec![load_pattern(&model.weight(vec2(0.0, -9.81)))];
    patterns.extend(vault.surface.iter().map(|node| down(*node)));
    let observed = [vec![(2 * vault.crown.index() + 1, 1.0)]];
    let under = |index: usize| [vec![1.0], amplitudes(&vault, index, 60e3)].concat();
    let begin = || Condensed::new(model.clone(), State::new(model), &patterns, &observed).unwrap();
    let (mut together, mut single) = (begin(), begin());
    let passage = together.solve_positions(50, &under, &mut Unwatched).unwrap();
    assert!(passage.repeated > 0, "no part was retained on the way: rolling back was not tried");
    let size = passage.visited.iter().fold(0.0_f64, |most, visited| most.max(visited.observed[0].abs()));
    for (index, visited) in passage.visited.iter().enumerate() {
        assert_eq!(single.solve_position(&under(index), &mut Unwatched).unwrap().reached, Reached::Balanced);
        let (one, other) = (visited.observed[0], single.observed()[0]);
        assert!((one - other).abs() <= 1e-8 * size, "position {index}: {one:e} {other:e}");
    }
    let broken = |condensed: &mut Condensed| {
        condensed.state().unwrap().bonds.iter().map(|bond| bond.memory.broken).collect::<Vec<bool>>()
    };
    let (one, other) = (broken(&mut together), broken(&mut single));
    assert!(one.iter().filter(|broken| **broken).count() > 5, "few pairs break: nothing to compare");
    assert_eq!(one, other);
}

#[test]
fn fill_that_flows_gives_the_plain_path_to_1e_6() {
    let soil = Elastic { modulus: 110e6, ratio: 0.19 };
    let angle = 30f64.to_radians();
    let fill = DruckerPrager::matching(soil, Cone::Compression, 10e3, angle, 0.0);
    let (worst, [_, _, yielding, repeated]) = compare(Material::DruckerPrager(fill), 30e3);
    assert!(yielding > 20, "{yielding} points flow: nothing to compare");
    assert!(repeated > 0, "no part was retained on the way: rolling back was not tried");
    assert!(worst <= 1e-6, "{worst:e}");
}

/// What happened after a snapshot leaves no trace once it is restored: neither in parts that were retained before, nor in those
/// that were retained later and yielded meanwhile.
#[test]
fn a_restored_snapshot_leaves_no_trace() {
    let soil = Elastic { modulus: 110e6, ratio: 0.19 };
    let fill = DruckerPrager::matching(soil, Cone::Compression, 10e3, 30f64.to_radians(), 0.0);
    let vault = vault(Material::DruckerPrager(fill), Kinematics::Small);
    let model = &vault.model;
    let mut patterns = vec![load_pattern(&model.weight(vec2(0.0, -9.81)))];
    patterns.extend(vault.surface.iter().map(|node| down(*node)));
    let observed = [vec![(2 * vault.crown.index() + 1, 1.0)], vec![(2 * vault.surface[9].index() + 1, 1.0)]];
    let under = |index: usize, force: f64| [vec![1.0], amplitudes(&vault, index, force)].concat();
    let begin = || {
        let mut condensed = Condensed::new(model.clone(), State::new(model), &patterns, &observed).unwrap();
        assert_eq!(condensed.solve_position(&under(0, 0.0), &mut Unwatched).unwrap().reached, Reached::Balanced);
        condensed
    };
    let mut straight = begin();
    assert_eq!(straight.solve_position(&under(12, 10e3), &mut Unwatched).unwrap().reached, Reached::Balanced);
    let mut detour = begin();
    let (at_rest, rest) = (detour.snapshot(), detour.observed());
    assert_eq!(detour.solve_position(&under(20, 30e3), &mut Unwatched).unwrap().reached, Reached::Balanced);
    let size = detour.observed().iter().zip(&rest).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    // Unloading by itself does not go back: fill has flowed.
    detour.solve_position(&under(0, 0.0), &mut Unwatched).unwrap();
    let left = detour.observed().iter().zip(&rest).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(left > 1e-3 * size, "{left:e} of {size:e} left: nothing to undo");
    detour.restore(&at_rest);
    assert_eq!(detour.solve_position(&under(12, 10e3), &mut Unwatched).unwrap().reached, Reached::Balanced);
    for (a, b) in detour.observed().iter().zip(straight.observed()) {
        assert!((a - b).abs() <= 1e-8 * size, "{a:e} {b:e}, of {size:e}");
    }
}

/// Moduli of soil and stones [Pa], cohesion of the soil [Pa], friction under it.
const QUANTITIES: [f64; 4] = [110e6, 16e9, 10e3, 0.4];

/// A unit force downwards on a node.
fn down(node: NodeId) -> LoadPattern {
    vec![(2 * node.index() + 1, -1.0)]
}

/// The vault with these quantities, the patterns of its weight and of its surface, and what is observed.
fn quantified([soil, stones, cohesion, friction]: [f64; 4]) -> (Vault, Vec<LoadPattern>, [Functional; 3]) {
    let soil = Elastic { modulus: soil, ratio: 0.19 };
    let fill = DruckerPrager::matching(soil, Cone::Compression, cohesion, 30f64.to_radians(), 0.0);
    let vault = vault_of(Material::DruckerPrager(fill), stones, friction, PANEL, Kinematics::Small);
    let mut patterns = vec![load_pattern(&vault.model.weight(vec2(0.0, -9.81)))];
    patterns.extend(vault.surface.iter().map(|node| down(*node)));
    let of = |node: NodeId, axis: usize| vec![(2 * node.index() + axis, 1.0)];
    let observed = [of(vault.crown, 0), of(vault.crown, 1), of(vault.surface[9], 1)];
    (vault, patterns, observed)
}

/// Weight in four steps, then the axles at three places; with derivatives where they are wanted.
fn branches(quantities: [f64; 4], with_derivatives: bool) -> (Vec<Vec<f64>>, [usize; 3], Derivatives) {
    let (vault, patterns, observed) = quantified(quantities);
    let mut condensed = Condensed::new(vault.model.clone(), State::new(&vault.model), &patterns, &observed).unwrap();
    condensed.keeps_equilibria = true;
    let weight = |step: usize| [vec![0.25 * (step + 1) as f64], vec![0.0; vault.surface.len()]].concat();
    let path = condensed.solve_positions(4, &weight, &mut Unwatched).unwrap().visited;
    let at_rest = condensed.snapshot();
    let under: Vec<Vec<f64>> = [12, 20, 21].map(|k| [vec![1.0], amplitudes(&vault, k, 30e3)].concat()).to_vec();
    let visited = condensed.solve_branches(&at_rest, &under, &mut Unwatched).unwrap().unwrap();
    assert!(path.len() == 4 && visited.iter().all(|visited| visited.position.reached == Reached::Balanced));
    let most = |count: fn(&mechanics::fem::condensed::Counts) -> usize| {
        visited.iter().map(|visited| count(&visited.counts)).max().unwrap()
    };
    let counts = [most(|c| c.open), most(|c| c.sliding), most(|c| c.yielding)];
    let mut derivatives = Derivatives::default();
    if with_derivatives {
        let by: [f64; 4] = QUANTITIES.map(|quantity| 1e-6 * quantity);
        let others: Vec<_> = (0..4)
            .map(|k| {
                let mut other = quantities;
                other[k] += by[k];
                quantified(other)
            })
            .collect();
        let perturbed: Vec<PerturbedModel<'_>> = others
            .iter()
            .zip(by)
            .map(|((vault, patterns, _), by)| PerturbedModel { model: &vault.model, patterns, by })
            .collect();
        derivatives = condensed.derivatives(&perturbed, &path, &visited, &mut Unwatched).unwrap().unwrap();
    }
    let values = path.last().into_iter().chain(&visited).map(|visited| visited.observed.clone()).collect();
    (values, counts, derivatives)
}

/// Along a path on which joints open, contacts slide and fill flows, under weight and then under axles.
#[test]
fn derivatives_are_those_of_runs_with_other_quantities() {
    let (_, [open, sliding, yielding], found) = branches(QUANTITIES, true);
    assert!(open > 0 && sliding > 0 && yielding > 20, "{open} {sliding} {yielding}: too tame");
    for k in 0..4 {
        let apart = 1e-5 * QUANTITIES[k];
        let moved = |by: f64| {
            let mut other = QUANTITIES;
            other[k] += by;
            branches(other, false).0
        };
        let (more, less) = (moved(apart), moved(-apart));
        let own = std::iter::once(&found.at_end[k]).chain(found.branches.iter().map(|branch| &branch[k]));
        for (place, (own, (more, less))) in own.zip(more.iter().zip(&less)).enumerate() {
            let differences: Vec<f64> = more.iter().zip(less).map(|(a, b)| (a - b) / (2.0 * apart)).collect();
            let size = differences.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
            // Friction does nothing before anything slides.
            assert!(size > 0.0 || place == 0);
            // What balance to 1e-10 leaves of a difference over 2e-5 of a quantity, and the curvature over it.
            for (own, difference) in own.iter().zip(&differences) {
                assert!(
                    (own - difference).abs() <= 1e-4 * size,
                    "quantity {k}, place {place}: {own:e} {difference:e} of {size:e}"
                );
            }
        }
    }
}

/// Positions that were solved from one snapshot, side by side, are those that were solved one by one, and parts that are retained
/// beforehand change nothing.
#[test]
fn branches_are_positions_solved_one_by_one() {
    let (values, ..) = branches(QUANTITIES, false);
    let (vault, patterns, observed) = quantified(QUANTITIES);
    let begin = || Condensed::new(vault.model.clone(), State::new(&vault.model), &patterns, &observed).unwrap();
    let mut one = begin();
    for step in 1..=4 {
        let weight = [vec![0.25 * f64::from(step)], vec![0.0; vault.surface.len()]].concat();
        assert_eq!(one.solve_position(&weight, &mut Unwatched).unwrap().reached, Reached::Balanced);
    }
    let (at_rest, rest) = (one.snapshot(), one.observed());
    for (k, values) in [12, 20, 21].into_iter().zip(&values[1..]) {
        one.restore(&at_rest);
        one.solve_position(&[vec![1.0], amplitudes(&vault, k, 30e3)].concat(), &mut Unwatched).unwrap();
        let size = values.iter().zip(&rest).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        for (a, b) in one.observed().iter().zip(values) {
            assert!((a - b).abs() <= 1e-8 * size, "place {k}: {a:e} {b:e}, of {size:e}");
        }
    }
    let retained = one.retained_parts();
    let mut prepared = begin();
    prepared.retain_parts(&retained, &mut Unwatched);
    for step in 1..=4 {
        let weight = [vec![0.25 * f64::from(step)], vec![0.0; vault.surface.len()]].concat();
        prepared.solve_position(&weight, &mut Unwatched).unwrap();
    }
    assert_eq!(prepared.retained_parts(), retained);
    for (a, b) in prepared.observed().iter().zip(&rest) {
        assert!((a - b).abs() <= 1e-9 * rest.iter().fold(0.0_f64, |most, r| most.max(r.abs())));
    }
}

/// A vault whose joints break and slide under a load that crosses in 50 positions: its patterns, and what is observed.
fn crossed(vault: &Vault) -> (Vec<LoadPattern>, [Functional; 1]) {
    let mut patterns = vec![load_pattern(&vault.model.weight(vec2(0.0, -9.81)))];
    patterns.extend(vault.surface.iter().map(|node| down(*node)));
    (patterns, [vec![(2 * vault.crown.index() + 1, 1.0)]])
}

/// Looking at every position leaves no trace in those that follow, and shows the state of a run that ends there.
#[test]
fn a_look_within_a_batch_leaves_no_trace() {
    let vault = vault(Material::Elastic(Elastic { modulus: 110e6, ratio: 0.19 }), Kinematics::Small);
    let (patterns, observed) = crossed(&vault);
    let under = |index: usize| [vec![1.0], amplitudes(&vault, index, 60e3)].concat();
    let begin = || Condensed::new(vault.model.clone(), State::new(&vault.model), &patterns, &observed).unwrap();
    let whole = begin().solve_positions(50, &under, &mut Unwatched).unwrap();
    let (mut looked, mut single) = (begin(), begin());
    let mut run = looked.begin(50);
    let mut seen = 0;
    let size = whole.visited.iter().fold(0.0_f64, |most, visited| most.max(visited.observed[0].abs()));
    while run.goes_on() {
        looked.solve_batch(&mut run, &under, &mut Unwatched).unwrap();
        for index in seen..run.passage.visited.len() {
            let state = looked.state_at(&run, index).unwrap();
            single.solve_position(&under(index), &mut Unwatched).unwrap();
            let other = single.state().unwrap();
            let apart = (state.displacements.iter().zip(&other.displacements))
                .fold(0.0_f64, |most, (one, other)| most.max((one - other).abs()));
            assert!(apart <= 1e-7 * size, "position {index}: {apart:e}");
            let broken = |state: &State| state.bonds.iter().filter(|bond| bond.memory.broken).count();
            assert_eq!(broken(&state), broken(&other), "position {index}");
        }
        seen = run.passage.visited.len();
    }
    assert_eq!(run.passage, whole);
}

/// Stops at the look with this number, and goes on counting.
struct Stopping {
    looks: usize,
    at: usize,
}

impl Watch for Stopping {
    fn look(&mut self, _: &Progress) -> Wish {
        self.looks += 1;
        if self.looks == self.at { Wish::Stop } else { Wish::GoOn }
    }
}

/// Nobody is asked again after a stop, however deep in a position it came, and what was found before is part of the whole run.
#[test]
fn both_paths_stop_within_an_iteration() {
    let vault = vault(Material::Elastic(Elastic { modulus: 110e6, ratio: 0.19 }), Kinematics::Small);
    let (patterns, observed) = crossed(&vault);
    let under = |index: usize| [vec![1.0], amplitudes(&vault, index, 60e3)].concat();
    let begin = || Condensed::new(vault.model.clone(), State::new(&vault.model), &patterns, &observed).unwrap();
    let mut counted = Stopping { looks: 0, at: usize::MAX };
    let whole = begin().solve_positions(50, &under, &mut counted).unwrap();
    assert!(counted.looks > 100, "{} looks: iterations are not asked", counted.looks);
    for at in (1..counted.looks).step_by(7) {
        let mut stopping = Stopping { looks: 0, at };
        let some = begin().solve_positions(50, &under, &mut stopping).unwrap();
        assert!(some.cancelled && some.stopped_at.is_none());
        assert_eq!(stopping.looks, at, "asked again after the stop");
        assert_eq!(some.visited[..], whole.visited[..some.visited.len()]);
    }
    let target = Target { forces: vault.model.weight(vec2(0.0, -9.81)), imposed: vec![] };
    let run = |watch: &mut Stopping| {
        let mut state = State::new(&vault.model);
        let mut work = Workspace::new(&vault.model).unwrap();
        (advance(&vault.model, &mut state, &mut work, &target, &settings(), watch), state)
    };
    let mut counted = Stopping { looks: 0, at: usize::MAX };
    let (outcome, _) = run(&mut counted);
    assert!(counted.looks as u64 > outcome.iterations, "iterations are not asked");
    for at in 1..counted.looks {
        let mut stopping = Stopping { looks: 0, at };
        let (outcome, state) = run(&mut stopping);
        assert_eq!((outcome.status, stopping.looks), (Status::Cancelled, at));
        assert_eq!(outcome.reached == 0.0, state == State::new(&vault.model), "the state stands where it is said to");
    }
}
