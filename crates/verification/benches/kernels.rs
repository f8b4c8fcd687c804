//! The speed of each kernel by itself: `cargo bench -p verification`, or with a name after it those whose name has it. `extrados bench` measures
//! whole methods on an engineer's machine with the same functions.

use bridge::Bridge;
use divan::Bencher;
use mechanics::blocks::PointForce;
use mechanics::dem::{State, Workspace, step};
use mechanics::fem;
use mechanics::limit::{Effect, Friction, Ground, Settings};
use mechanics::watch::Unwatched;
use structure::discretise::{Discretised, dispersal};
use verification::footing::{Footing, Ground as Soil, footing};
use verification::{disks, kernels};

const BRIDGEMILL: &str = include_str!("../../../examples/bridgemill/case-1.toml");
const TWO_RINGS: &str = include_str!("../../../examples/two-ring/bridge.toml");

fn main() {
    divan::main();
}

fn read(text: &str) -> Bridge {
    bridge::read(text.as_bytes()).bridge.expect("an example can be read")
}

fn measured<T, E: std::fmt::Debug>(bencher: Bencher<'_, '_>, text: &str, kernel: fn(&Bridge) -> Result<T, E>) {
    let bridge = read(text);
    bencher.bench_local(|| kernel(&bridge).expect("an example can be cut into blocks"));
}

#[divan::bench(sample_count = 20)]
fn limit_analysis(bencher: Bencher<'_, '_>) {
    measured(bencher, BRIDGEMILL, kernels::limit_analysis);
}

#[divan::bench(sample_count = 20)]
fn equilibrium_path(bencher: Bencher<'_, '_>) {
    measured(bencher, BRIDGEMILL, kernels::equilibrium_path);
}

#[divan::bench(sample_count = 3)]
fn discrete_elements(bencher: Bencher<'_, '_>) {
    measured(bencher, BRIDGEMILL, |bridge| kernels::discrete_elements(bridge, None));
}

/// A bridge of the examples, the forces of its loads, and what carries them.
fn stood(text: &str) -> (Discretised, Vec<PointForce>) {
    let bridge = read(text);
    let d = structure::discretise::discretise(&bridge).expect("an example can be cut into blocks");
    let strips = bridge.loads.iter().flat_map(|load| dispersal::strips(load, 0.0));
    let forces = strips.flat_map(|strip| d.spread(&bridge, strip).forces).collect();
    (d, forces)
}

/// One load among many on one model, with dilation by the simplex method, or without by following blocks between stiff joints.
fn one_load(bencher: Bencher<'_, '_>, text: &str, friction: Friction) {
    let (mut d, forces) = stood(text);
    d.loading.variable.clear();
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let ground = Ground::new(&d.model, &d.loading, &settings).expect("blocks");
    let effect: Effect = ground.sweeper().effect(&forces);
    bencher.bench_local(|| ground.sweeper().least(&effect, friction));
}

#[divan::bench(sample_count = 50)]
fn one_load_with_dilation(bencher: Bencher<'_, '_>) {
    one_load(bencher, BRIDGEMILL, Friction::Associated);
}

#[divan::bench(sample_count = 5)]
fn one_load_on_two_rings(bencher: Bencher<'_, '_>) {
    one_load(bencher, TWO_RINGS, Friction::Automatic);
}

/// A thousand steps of discs near rest.
#[divan::bench(args = [300, 2_000], sample_count = 5)]
fn a_thousand_steps_of_discs(bencher: Bencher<'_, '_>, count: usize) {
    let packed = disks::disks(count, &mut Unwatched).expect("a box");
    let settled = packed.settled(&mut Unwatched).expect("nobody stops it");
    let (mut state, mut work): (State, Workspace) = settled;
    let settings = disks::settings();
    bencher.bench_local(|| {
        for _ in 0..1_000 {
            step(&packed.model, &mut state, &mut work, &settings);
        }
    });
}

fn elastic(columns: usize) -> Footing {
    footing(columns, Soil::Elastic, fem::Element::Q4).expect("a mesh")
}

#[divan::bench(args = [40, 142], sample_count = 10)]
fn stiffness_assembled(bencher: Bencher<'_, '_>, columns: usize) {
    let ground = elastic(columns);
    let mut work = fem::Workspace::new(&ground.model).expect("a pattern");
    let state = fem::State::new(&ground.model);
    bencher.bench_local(|| work.stiffness(&ground.model, &state).expect("elastic ground"));
}

#[divan::bench(args = [40, 142], sample_count = 10)]
fn stiffness_factorised(bencher: Bencher<'_, '_>, columns: usize) {
    let ground = elastic(columns);
    let mut work = fem::Workspace::new(&ground.model).expect("a pattern");
    work.stiffness(&ground.model, &fem::State::new(&ground.model)).expect("elastic ground");
    bencher.bench_local(|| work.factorise().expect("elastic ground"));
}
