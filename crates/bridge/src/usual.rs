//! What is usual of the numbers of a bridge file, and what is possible.

/// The range in which a value is usually found [SI], in what words, and the range outside of which nothing is that the key means.
pub(crate) struct Usual {
    pub(crate) code: &'static str,
    pub(crate) sections: &'static [&'static str],
    pub(crate) key: &'static str,
    pub(crate) least: f64,
    pub(crate) most: f64,
    pub(crate) says: &'static str,
    pub(crate) possible: [f64; 2],
}

impl Usual {
    /// The same with the range outside of which a value is refused [SI].
    const fn possible(mut self, least: f64, most: f64) -> Usual {
        self.possible = [least, most];
        self
    }
}

const fn usual(
    code: &'static str,
    sections: &'static [&'static str],
    key: &'static str,
    least: f64,
    most: f64,
    says: &'static str,
) -> Usual {
    Usual { code, sections, key, least, most, says, possible: [f64::NEG_INFINITY, f64::INFINITY] }
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Wide on purpose: a value outside is to be checked and may be right. Sources are on the codes' cards. What is possible is wider by far:
/// between foamed glass and iron ore for densities, between sand and steel for strengths and moduli; what lies outside is a slip of a unit,
/// and no bridge is analysed with it.
pub(crate) const USUAL: &[Usual] = &[
    usual("P001", &["masonry"], "density", 1500.0, 3000.0, "masonry usually weighs 1500 to 3000 kg/m^3")
        .possible(0.0, 5000.0),
    usual("P002", &["masonry"], "elastic_modulus", 0.3e9, 100e9, "masonry units usually have 0.3 to 100 GPa")
        .possible(1e6, 1e12),
    usual("P003", &["masonry"], "compressive_strength", 0.5e6, 400e6, "masonry usually crushes at 0.5 to 400 MPa")
        .possible(1e3, 1e9),
    usual(
        "P004",
        &["joint", "ring_joint"],
        "friction_angle",
        15.0 * DEGREE,
        60.0 * DEGREE,
        "masonry joints usually slide at 15 to 60 deg",
    ),
    usual("P005", &["joint", "ring_joint"], "cohesion", 0.0, 2e6, "masonry joints usually have less than 2 MPa")
        .possible(0.0, 1e8),
    usual("P006", &["cover"], "density", 1000.0, 2700.0, "layers above an arch usually weigh 1000 to 2700 kg/m^3")
        .possible(0.0, 5000.0),
    usual("P006", &["backing"], "density", 1000.0, 3000.0, "backing usually weighs 1000 to 3000 kg/m^3")
        .possible(0.0, 5000.0),
    usual("P006", &["fill", "abutment_fill"], "density", 1000.0, 2700.0, "fill usually weighs 1000 to 2700 kg/m^3")
        .possible(0.0, 5000.0),
    usual("P006", &["haunch_fill"], "density", 1000.0, 3000.0, "fill of haunches usually weighs 1000 to 3000 kg/m^3")
        .possible(0.0, 5000.0),
    usual("P023", &["fill"], "elastic_modulus", 2e6, 2e9, "granular fills usually have 20 to 200 MPa")
        .possible(1e3, 1e11),
    usual("P023", &["abutment_fill"], "elastic_modulus", 2e6, 2e9, "granular fills usually have 20 to 850 MPa")
        .possible(1e3, 1e11),
    usual("P024", &["mortar"], "elastic_modulus", 10e6, 30e9, "mortars usually have 0.1 to 10 GPa").possible(1e4, 1e11),
    usual("P024", &["mortar"], "thickness", 0.5e-3, 0.1, "joints are usually 3 to 25 mm thick").possible(1e-6, 1.0),
    usual("P007", &["bridge"], "gravity", 9.7, 9.9, "gravity on the ground is 9.76 to 9.83 m/s^2").possible(0.1, 100.0),
    usual("P008", &["bridge"], "width", 1.0, 40.0, "bridges are usually 1 to 40 m wide").possible(0.2, 300.0),
    usual("P052", &["track"], "track_modulus", 5e6, 200e6, "track moduli are usually 5 to 200 MPa for one rail")
        .possible(1e5, 1e10),
    usual("P052", &["track"], "rail_bending_stiffness", 0.5e6, 10e6, "rails usually have 0.5 to 10 MNm^2")
        .possible(1e4, 1e9),
    usual("P052", &["track"], "sleeper_spacing", 0.4, 1.0, "sleepers are usually 0.4 to 1 m apart").possible(0.1, 10.0),
    usual("P053", &["passage"], "speed", 1.0 / 3.6, 250.0 / 3.6, "trains usually cross bridges at 1 to 250 km/h")
        .possible(0.0, 200.0),
];

/// What is usual of a key, in words.
pub(crate) fn usual_of(section: &str, key: &str) -> Option<&'static str> {
    USUAL.iter().find(|usual| usual.sections.contains(&section) && usual.key == key).map(|usual| usual.says)
}
