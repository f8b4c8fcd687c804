//! Integrals of smooth functions.

/// Points and weights of Gauss and Legendre on 0 to 1, eight of them: exact to degree 15.
const GAUSS: [[f64; 2]; 8] = [
    [0.019_855_071_751_231_86, 0.050_614_268_145_188_13],
    [0.101_666_761_293_186_64, 0.111_190_517_226_687_24],
    [0.237_233_795_041_835_5, 0.156_853_322_938_943_64],
    [0.408_282_678_752_175_1, 0.181_341_891_689_181],
    [0.591_717_321_247_825, 0.181_341_891_689_181],
    [0.762_766_204_958_164_5, 0.156_853_322_938_943_64],
    [0.898_333_238_706_813_4, 0.111_190_517_226_687_24],
    [0.980_144_928_248_768_1, 0.050_614_268_145_188_13],
];

/// The integral of `speed` from 0 to `t`, by so many panels of eight points.
pub(super) fn quadrature(t: f64, panels: usize, speed: impl Fn(f64) -> f64) -> f64 {
    let panel = t / panels as f64;
    (0..panels)
        .map(|index| {
            let start = index as f64 * panel;
            GAUSS.iter().map(|[at, weight]| weight * panel * speed(start + at * panel)).sum::<f64>()
        })
        .sum()
}
