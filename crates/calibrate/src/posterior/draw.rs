//! Numbers by chance, the same for the same seed on every machine.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

/// Even between 0 and 1.
pub fn even(rng: &mut ChaCha8Rng) -> f64 {
    rng.random::<f64>()
}

/// Normal with mean 0 and standard deviation 1.
pub fn normal(rng: &mut ChaCha8Rng) -> f64 {
    rng.sample(StandardNormal)
}

/// One of `count` places.
pub fn place(rng: &mut ChaCha8Rng, count: usize) -> usize {
    rng.random_range(0..count.max(1) as u64) as usize
}

/// Points that fill every axis evenly, one in each of as many equal slices: `count` of them, each of `axes` numbers between 0 and 1.
pub fn latin_hypercube(rng: &mut ChaCha8Rng, count: usize, axes: usize) -> Vec<Vec<f64>> {
    let mut points = vec![vec![0.0; axes]; count];
    for axis in 0..axes {
        let mut order: Vec<usize> = (0..count).collect();
        for k in (1..count).rev() {
            order.swap(k, place(rng, k + 1));
        }
        for (point, slice) in points.iter_mut().zip(order) {
            point[axis] = (slice as f64 + even(rng)) / count as f64;
        }
    }
    points
}
