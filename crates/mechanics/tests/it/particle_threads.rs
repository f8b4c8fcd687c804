//! The same bits for any number of threads.

use crate::particle_support::{Moving, fill, loose, regular, settings, stone, wall, world};
use mechanics::blocks::Held;
use mechanics::dem::{Damping, State, energy};
use mechanics::plane::vec2;

/// A column of 12,000 particles, three chunks, with two free blocks in it, that spreads on a floor.
fn spread(threads: usize, damping: Damping) -> (State, String) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let mut discs = loose(100, 121, 7);
        let stones = [vec2(4.0, 12.0), vec2(15.0, 3.0)];
        discs.retain(|(c, r)| stones.iter().all(|s| (*c - *s).norm() > 0.6 + r));
        assert!(discs.len() > 12_000);
        let mut blocks = vec![wall(vec2(-20.0, -0.5), 60.0, 0.5), wall(vec2(-0.5, 0.0), 0.5, 30.0)];
        blocks.extend(stones.map(|s| stone(&regular(s, 0.6, 5, 0.4), 0.03, Held::FREE)));
        let mut m = Moving::new(&world(fill(0.5), vec2(0.0, -9.81), blocks, &discs), settings(damping, 0.8));
        // Thrown together, so that contacts of every kind close from the first steps on.
        for (k, id) in (0..discs.len()).map(|k| (k, mechanics::ids::ParticleId(k as u32))) {
            let v = vec2(2.0 * (k as f64).sin(), 2.0 * (k as f64 * 1.7).cos() - 1.0);
            m.state.set_particle_velocity(&m.model, id, v, (k as f64 * 0.3).sin());
        }
        m.run(250);
        let energy = energy(&m.model, &m.state);
        assert!(energy.dissipated > 0.0 && energy.elastic > 0.0, "{energy:?}");
        (m.state, format!("{energy:?}"))
    })
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for damping in [Damping::Local(0.3), Damping::Adaptive] {
        let one = spread(1, damping);
        for threads in [2, 3] {
            let many = spread(threads, damping);
            assert!(many == one, "{threads} threads, {damping:?}");
        }
    }
}
