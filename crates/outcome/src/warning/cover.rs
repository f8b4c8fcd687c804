//! Fill as weight, as pressure and as particles; what stands on the rings; skew.

use super::cards::warnings;
use crate::given::Record;
use crate::sentences::{kilo, listed};

warnings! {
    /// Of fill, cover and the shape of the bridge.
    Cover {
        /// Fill as weight, and backing where that is weight as well; the record of the method.
        FILL_AS_WEIGHT: AsWeight { backing: bool, record: Option<Record> } =>
            "{} alone: its resistance is left out, and so are effects that make rings weaker than rigid blocks{}",
            if *backing { "fill and backing act by their weight" } else { "fill acts by its weight" },
            record.as_ref().map_or_else(String::new, |record| format!("; {}", record.words()));
        /// Loads of rigid blocks with fill that presses: by weight alone, with the file's share of the passive pressure, with all of it.
        PRESSURE_RANGE: Pressure { bare [N/m]: Option<f64>, with [N/m]: Option<f64>, share: f64, full [N/m]: Option<f64> } =>
            "{} by weight alone, {} with {:.0} % of the passive pressure, {} with all of it; a verdict uses the lower end",
            load(*bare), load(*with), 100.0 * share, load(*full);
        /// Loads along the path: by weight alone, with the pressure that movement mobilises, and on rigid blocks.
        PRESSURE_RANGE: PressureOfPath { bare [N/m]: Option<f64>, with [N/m]: Option<f64>, rigid [N/m]: Option<f64> } =>
            "{} by weight alone, {} with the pressure that the ring's own movement mobilises, {} on rigid blocks, where all of the file's share \
             acts at once",
            load(*bare), load(*with), load(*rigid);
        PRESSURE_RANGE: PressureInSweep { bare: Option<f64>, with: Option<f64> } =>
            "factor on the loads of the file: {} by weight alone, {} with fill pressure; the lower one counts", factor(*bare), factor(*with);
        PRESSURE_RANGE: PressureOfVehicles { vehicles: Vec<(String, f64, f64)> } =>
            "adequacy factors, of which the lower one counts: {}",
            vehicles.iter().map(|(code, bare, with)| format!("{code} {bare:.3} by weight alone, {with:.3} with fill pressure")).collect::<Vec<_>>().join("; ");
        COARSE_PARTICLES: CoarseParticles { largest [m]: f64, cover [m]: f64 } =>
            "the largest particle is {largest:.3} m across, the cover over the crown {cover:.3} m deep";
        /// One packing of many, from a seed or a file.
        ONE_PACKING: OnePacking { seed: Option<u64> } =>
            "the load is that of one packing ({}): others of the same recipe differ by tens of per cent",
            seed.map_or("a packing from a file".to_owned(), |seed| format!("seed {seed}"));
        SHIFTED_LOAD: Shifted { place [m]: f64, by [m]: f64 } =>
            "the resultant of the load at {place:.3} m moves by {:+.1} mm", 1e3 * by;
        GROUND_LOAD: ToGround { place [m]: f64, share: f64 } =>
            "{:.1} % of the load at {place:.3} m reaches the ground beside the rings", 100.0 * share;
        /// A void, counted from 0.
        VOIDS: Void { number: usize, range [m]: [f64; 2], carried_to [m]: [f64; 2] } =>
            "void {} from {:.2} m to {:.2} m: what lies over it is carried to {:.2} m and {:.2} m; its roof is not checked",
            number + 1, range[0], range[1], carried_to[0], carried_to[1];
        /// Internal walls, or backing, over a share of the width.
        MEAN_OVER_WIDTH: MeanOverWidth { walls: bool, share: f64, density [kg/m^3]: f64 } =>
            "{} over {:.0} % of the width: {density:.0} kg/m³ on the mean of every metre of the barrel",
            if *walls { "internal walls" } else { "backing" }, 100.0 * share;
        /// An abutment, by its support, that can move.
        MOVABLE_ABUTMENT: Movable { right: bool, friction_angle [rad]: f64, earth_coefficient: f64 } =>
            "the {} abutment stands on the ground with friction at {:.1} degrees; soil behind it presses with {earth_coefficient:.2} of its \
             vertical stress, and no passive pressure is counted",
            if *right { "right" } else { "left" }, friction_angle.to_degrees();
        /// Spans that are skew, counted from 0: angle [rad] and span along the road [m].
        SKEW: Skew { spans: Vec<(usize, f64, f64)> } =>
            "the bridge is skew and the model is square, of its spans along the road: {}; the load of a skew barrel was not found",
            listed(spans.iter().map(|(k, skew, span)| {
                format!("span {} by {:.0} degrees ({span:.2} m along the road, {:.2} m square)", k + 1, skew.to_degrees(), span * skew.cos())
            }));
    }
}

fn load(load: Option<f64>) -> String {
    load.map_or("no load".to_owned(), |load| format!("{} kN/m", kilo(load)))
}

/// A factor as sentences have it.
pub(super) fn factor(factor: Option<f64>) -> String {
    factor.map_or("no factor".to_owned(), |factor| format!("{factor:.3}"))
}
