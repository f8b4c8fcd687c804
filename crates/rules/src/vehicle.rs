//! A vehicle: axles, distances that may vary, what stands beside it.

use crate::Source;
use crate::pattern::{Axle, Pattern, Stretch};
use crate::shape::{Kind, Listed, table, words};
use serde::{Deserialize, Serialize};

table! {
    /// A vehicle as its standard describes it.
    #[derive(Default)]
    pub struct Vehicle = "vehicle" {
        must code: String, "its name in bridge files";
        must title: String, "its name in reports";
        may[default] grade: String, "the grade of a bridge that carries it, where the file has `grades`";
        must axle_loads_kn: Vec<f64>, "load of each axle, from the first one back [kN]; [] where the vehicle is uniform loads alone";
        must spacings_m: Vec<Spacing>,
            "distances between neighbouring axles, one fewer than axles [m]; a range is { from, to, step }";
        /// The vehicle without lift-off is always tried as well.
        may[default] lift_off: Vec<Vec<f64>>, "factors on the axles where some lift off, one list a case";
        may[default] uniform: Vec<Uniform>, "uniform loads that belong to it";
        /// Every run of neighbouring axles is then tried.
        must axles_may_be_dropped: bool, "whether axles that help may be left out";
        must wheel_track_m: f64, "distance between the wheels of an axle across the bridge [m]";
        must contact_length_m: f64, "length of a wheel's or sleeper's footprint along the bridge [m]";
        may[default = "one"] lanes: usize, "how many lanes it occupies; 1 where not written";
        may[default] with: Vec<String>,
            "codes of vehicles that belong to the same level of loading: a bridge that carries this one carries all of them";
        may source: Option<Source>, "where it is from, if not from where the file is";
    } and {
        /// The vehicles of `with`, as [`crate::Library::join_levels`] found them; their arrangements are among [`Vehicle::patterns`].
        #[serde(skip)]
        pub level: Vec<Vehicle>,
    }
}

/// The default of numbers of lanes.
fn one() -> usize {
    1
}

/// A distance between two axles: one, or a range.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(untagged)]
pub enum Spacing {
    /// One distance [m].
    Fixed(f64),
    /// Every distance of a range is possible; those that are tried lie a step apart, both ends among them.
    Range {
        /// Least [m].
        from: f64,
        /// Largest [m].
        to: f64,
        /// Between those that are tried [m].
        step: f64,
    },
}

impl Listed for Spacing {
    const LIST: Kind = Kind::Spacings;
}

table! {
    /// A uniform load that moves with the vehicle.
    #[derive(Copy)]
    pub struct Uniform = "uniform" {
        must load_kn_per_m: f64, "load along the bridge [kN/m]";
        must place: Extent, "where it stands";
        may[default] gap_m: f64,
            "from the outermost axle to where it begins [m]; for a part from the first axle, or the front where there is no axle, back";
        may length_m: Option<f64>, "length of a part [m]; for `place = \"part\"` alone, and needed there";
        must may_be_dropped: bool, "whether it may be left out where it helps";
        may width_m: Option<f64>, "width over which it stands across the bridge [m]; as an axle where it is not written";
    }
}

words! {
    /// Where a uniform load stands.
    pub enum Extent {
        /// Before the first axle.
        Ahead = "ahead",
        /// Behind the last axle.
        Behind = "behind",
        /// Along the whole bridge, under the axles too.
        Everywhere = "everywhere",
        /// A part of the vehicle, of a length of its own.
        Part = "part",
    }
}

impl Spacing {
    /// The distances that are tried [m].
    pub fn tried(self) -> Vec<f64> {
        match self {
            Spacing::Fixed(value) => vec![value],
            Spacing::Range { from, to, step } => {
                let steps = ((to - from) / step - 1e-9).ceil().max(1.0) as usize;
                (0..=steps).map(|k| if k == steps { to } else { from + step * k as f64 }).collect()
            }
        }
    }

    /// Least and largest distance [m].
    pub fn range(self) -> [f64; 2] {
        match self {
            Spacing::Fixed(value) => [value; 2],
            Spacing::Range { from, to, .. } => [from, to],
        }
    }
}

impl Vehicle {
    /// The vehicle of fixed axle forces [N] and offsets behind the first axle [m], contact length and track of its wheels [m]; for trains and
    /// axles from elsewhere.
    pub fn of_axles(code: &str, title: &str, axles: &[(f64, f64)], contact_length: f64, wheel_track: f64) -> Vehicle {
        Vehicle {
            code: code.to_owned(),
            title: title.to_owned(),
            axle_loads_kn: axles.iter().map(|a| 1e-3 * a.0).collect(),
            spacings_m: axles.windows(2).map(|pair| Spacing::Fixed(pair[1].1 - pair[0].1)).collect(),
            axles_may_be_dropped: true,
            wheel_track_m: wheel_track,
            contact_length_m: contact_length,
            lanes: one(),
            ..Vehicle::default()
        }
    }

    /// Every arrangement that is to be tried: its own, and those of the other vehicles of its level, each with its vehicle's code.
    pub fn patterns(&self) -> Vec<Pattern> {
        let of_level = self.level.iter().flat_map(|other| {
            let named =
                |label: &str| if label.is_empty() { other.code.clone() } else { format!("{}, {label}", other.code) };
            other.own_patterns().into_iter().map(move |pattern| Pattern { label: named(&pattern.label), ..pattern })
        });
        self.own_patterns().into_iter().chain(of_level).collect()
    }

    /// Its own arrangements: each combination of distances, without lift-off and with each case of it.
    pub fn own_patterns(&self) -> Vec<Pattern> {
        let mut spacings: Vec<Vec<f64>> = vec![Vec::new()];
        for spacing in &self.spacings_m {
            let tried = spacing.tried();
            spacings = spacings
                .iter()
                .flat_map(|before| tried.iter().map(move |&next| before.iter().copied().chain([next]).collect()))
                .collect();
        }
        let level = vec![1.0; self.axle_loads_kn.len()];
        let cases: Vec<&Vec<f64>> = std::iter::once(&level).chain(&self.lift_off).collect();
        let mut patterns = Vec::new();
        for distances in &spacings {
            for (case, factors) in cases.iter().enumerate() {
                patterns.push(self.pattern(distances, factors, case > 0));
            }
        }
        patterns
    }

    fn pattern(&self, distances: &[f64], factors: &[f64], lifted: bool) -> Pattern {
        let mut offset = 0.0;
        let mut axles = Vec::new();
        for (k, (load, factor)) in self.axle_loads_kn.iter().zip(factors).enumerate() {
            axles.push(Axle { force: 1e3 * load * factor, offset });
            offset += distances.get(k).copied().unwrap_or(0.0);
        }
        let last = axles.last().map_or(0.0, |axle| axle.offset);
        let stretches = self.uniform.iter().map(|u| {
            let [from, to] = match u.place {
                Extent::Ahead => [f64::NEG_INFINITY, -u.gap_m],
                Extent::Behind => [last + u.gap_m, f64::INFINITY],
                Extent::Everywhere => [f64::NEG_INFINITY, f64::INFINITY],
                Extent::Part => [u.gap_m, u.gap_m + u.length_m.unwrap_or(0.0)],
            };
            Stretch { force: 1e3 * u.load_kn_per_m, from, to, may_be_dropped: u.may_be_dropped }
        });
        let mut words = Vec::new();
        let varied = self.spacings_m.iter().zip(distances).filter(|(s, _)| s.range()[0] < s.range()[1]);
        for (_, distance) in varied {
            words.push(format!("spacing {distance} m"));
        }
        if lifted {
            let list: Vec<String> = factors.iter().map(|f| f.to_string()).collect();
            words.push(format!("lift-off {}", list.join("/")));
        }
        Pattern { label: words.join(", "), axles, stretches: stretches.collect() }
    }
}
