//! Fill that yields as a continuum.

use super::cards::warnings;
use super::cover::factor;
use crate::sentences::kilo;
use findings::words::counted;

warnings! {
    /// Of soil.
    Yielding {
        /// The load with the file's share of the strength, and its range over shares, where there is one.
        STRENGTH_RANGE: StrengthRange { load [N/m]: f64, share: f64, range [N/m]: Option<[f64; 2]>, shares: [f64; 2] } => "{}; {} kN/m with the {:.0} % of the file",
            match range {
                Some([low, high]) => format!(
                    "{} to {} kN/m where {:.0} to {:.0} % of the soil's strength is mobilised",
                    kilo(*low), kilo(*high), 100.0 * shares[0], 100.0 * shares[1]
                ),
                None => format!("no load was found that is carried with {:.0} % of the soil's strength", 100.0 * shares[0]),
            },
            kilo(*load), 100.0 * share;
        STRENGTH_RANGE: StrengthInSweep { bare: Option<f64>, with: Option<f64> } =>
            "factor on the loads of the file: {} by weight alone, {} with soil that yields, its lower bound; the lower one counts",
            factor(*bare), factor(*with);
        /// Bounds further apart than wanted: their ratio, or the upper one where the lower one is zero.
        BOUNDS_APART: Apart { ratio: Option<f64>, upper [N/m]: f64, triangles: usize, wanted: f64, solved: bool } =>
            "the upper bound is {} after {triangles} triangles, {wanted:.3} times was wanted; {}. {}",
            match ratio {
                Some(ratio) => format!("{ratio:.3} times the lower one"),
                None => format!("{} kN/m and the lower one zero", kilo(*upper)),
            },
            match ratio {
                Some(_) => "the lower bound is carried all the same",
                None => "no load is known to be carried beside the weight",
            },
            match solved {
                true => "`elements` in [continuum] allows more triangles",
                false => "the programs of the next mesh were not solved",
            };
        /// An upper bound alone, and the share of the weight that is carried.
        BOUNDS_APART: UpperAlone { upper [N/m]: f64, carried_share: Option<f64> } =>
            "no stresses were found that carry all of the weight{}: the load is at most {} kN/m, and not known",
            carried_share.map_or(String::new(), |share| format!(", {:.1} % of it are carried", 100.0 * share.min(1.0))), kilo(*upper);
        BOUNDS_APART: LowerAlone { lower [N/m]: f64 } =>
            "no mechanism was found: {} kN/m are carried, and how much more is not known", kilo(*lower);
        SOIL_BEARS_FIRST: BearsFirst => "the soil fails under the load and the rings stay: the load is what the soil bears, and the arch may \
                                         carry more of a load that is spread further";
        /// Walls that give: upper bounds with them and in plane strain, their ends, what one resists over its length, and whether they tilt.
        WALLS_GIVE_FIRST: WallsGive { upper [N/m]: f64, plane_strain [N/m]: f64, ends [m]: [f64; 2], resists: f64, tilts: bool } =>
            "at most {} kN/m where the walls hold the fill, {} kN/m in plane strain; from {:.1} to {:.1} m a wall {} outwards: it resists {:.2} {}",
            kilo(*upper), kilo(*plane_strain), ends[0], ends[1],
            if *tilts { "tilts" } else { "slides" }, resists / 1e3 / (ends[1] - ends[0]), if *tilts { "kNm/m" } else { "kN/m" };
        GROUND_LOAD: BeyondEnds { share: f64 } =>
            "{:.1} % of the loads stands beyond the ends of the fill and is left out", 100.0 * share;
        SOIL_FALLS: Falls { share: f64 } =>
            "a mechanism proves that rings and soil carry no more than {:.1} % of their own weight", 100.0 * share;
        POSITIONS_NOT_CONVERGED: PositionsOpen { positions: usize } =>
            "no bounds were found at {}; what is carried there is not known", counted(*positions, "position");
    }
}
