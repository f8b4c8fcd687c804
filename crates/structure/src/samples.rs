//! Bridges for tests, as values; the tests of other crates use them too, and each uses some.
#![allow(dead_code)]

use bridge::ring::Profile;
use bridge::*;
use std::sync::LazyLock;

/// The bridge of Rouxinol, Providência and Lemos: case 1 (no weight above the ring), as the example has it but for what only a run needs.
pub(crate) fn bridgemill() -> Bridge {
    static EXAMPLE: LazyLock<Bridge> = LazyLock::new(|| {
        let text = include_bytes!("../../../examples/bridgemill/case-1.toml");
        bridge::read(text).bridge.expect("the example is a bridge")
    });
    let mut b = EXAMPLE.clone();
    b.name = "Bridgemill".into();
    b.abutments = [Abutment { top_width: 2.0, height: 1.0, body: None }; 2];
    (b.cover.depth, b.cover.layers) = (0.478, vec![]);
    b.loads[0].name = "knife edge".into();
    b.plan = Plan { load_limit: Some(600e3), step_limit: 200_000, time_step_factor: 0.5, seed: 0, ..b.plan };
    b.service = Service::default();
    b
}

/// A bare semicircular ring of `span` and `thickness` [m] with sharp corners.
pub(crate) fn semicircle(span: f64, thickness: f64, voussoirs: usize) -> Bridge {
    let mut b = bridgemill();
    b.name = "semicircle".into();
    b.spans[0] = Span {
        profile: Profile::Semicircular,
        span,
        rise: 0.5 * span,
        rings: vec![Ring { crown_thickness: thickness, springing_thickness: thickness, voussoirs }],
        ..b.spans[0].clone()
    };
    b.masonry.rounding = 0.0;
    b.cover.depth = 0.0;
    b.loads.clear();
    b
}

/// The spans on piers of the given width, base width and height [m].
pub(crate) fn spans(spans: Vec<Span>, width: f64, base_width: f64, height: f64, courses: usize) -> Bridge {
    let mut b = bridgemill();
    b.piers = vec![Pier::plain(width, base_width, height, courses); spans.len() - 1];
    b.spans = spans;
    b
}

/// Case 2: the weight of the fill acts on the ring, loads disperse through the whole cover.
pub(crate) fn case_two() -> Bridge {
    let mut b = bridgemill();
    let layer = |name, thickness, weighs| Layer { name, weighs, ..fill(thickness, 1890.0) };
    b.cover.layers = vec![
        layer(LayerKind::Fill, 0.203, true),
        layer(LayerKind::SubBase, 0.125, false),
        layer(LayerKind::Surfacing, 0.150, false),
    ];
    b
}

/// Two spans of 6 m on a pier, with fill and ballast over them.
pub(crate) fn railway() -> Bridge {
    let ring = Ring { crown_thickness: 0.54, springing_thickness: 0.54, voussoirs: 19 };
    let span = Span { span: 6.0, rise: 1.5, rings: vec![ring], ..bridgemill().spans[0].clone() };
    let mut b = spans(vec![span; 2], 1.5, 1.5, 3.0, 6);
    b.name = "railway".into();
    b.width = 4.87;
    b.abutments = [Abutment { top_width: 1.5, height: 3.0, body: None }; 2];
    b.cover = case_two().cover;
    b.cover.layers.truncate(1);
    b.cover.layers[0].thickness = 0.5;
    b.cover.depth = 0.5;
    b.loads.clear();
    b
}

/// A passage at 45 km/h over common track; no vehicles yet.
pub(crate) fn passage() -> bridge::passage::Passage {
    use bridge::passage::*;
    Passage {
        train: bridge::train::Train { name: String::new(), file: None, vehicles: vec![] },
        way: Way::Rails(Track {
            rail_bending_stiffness: 4.47e6,
            track_modulus: 30e6,
            sleeper_spacing: 0.6,
            sleeper_breadth: 0.25,
            sleeper_length: 2.75,
            ballast_depth: 0.25,
            ballast_slope: 2.0,
            dead_load: 3e3,
            effective_width: None,
        }),
        plan: PassagePlan {
            speed: 12.5,
            time_step: 0.005,
            from: None,
            to: None,
            direction: Heading::Right,
            analysis: PassageAnalysis::Static,
            damping: None,
            numerical_damping: 0.0,
            kinematics: PassageKinematics::Small,
            load_steps: 10,
            iterations: 100,
            tolerance: 1e-6,
            path: PassagePath::Condensed,
            pictures: vec![],
        },
        sensors: vec![],
    }
}

/// Fill that weighs and is no particles: thickness above the crown [m] and density [kg/m^3].
pub(crate) fn fill(thickness: f64, density: f64) -> Layer {
    Layer {
        name: LayerKind::Fill,
        thickness,
        density,
        weighs: true,
        particles: false,
        slabs: None,
        continuum: false,
        tensile_strength: None,
        friction_angle: None,
        cohesion: None,
        elastic_modulus: None,
    }
}

/// A wall of bricks on the ring, with its joints.
pub(crate) fn spandrel_wall(b: &Bridge) -> SpandrelWall {
    SpandrelWall {
        brick_length: 0.6,
        brick_height: 0.3,
        thickness: 0.5,
        bond: 0.5,
        density: 2000.0,
        rounding: 0.01,
        joint: b.joint,
        top: None,
        extent: None,
        end_walls: false,
        courses_from: CoursesFrom::Top,
        head_joint: None,
        loaded_bricks: None,
        least_piece: 0.25,
    }
}

/// Backing that weighs 2000 kg/m^3 and does nothing else, up to a height above the springings [m].
pub(crate) fn backing(height: f64) -> Backing {
    Backing {
        height,
        density: 2000.0,
        width_share: 1.0,
        elastic_modulus: None,
        poisson_ratio: None,
        body: BackingBody::Weight,
        tensile_strength: None,
        compressive_strength: None,
        friction_angle: None,
        cohesion: None,
    }
}

/// Numbers between 0 and 1 that look random and are the same in every run (splitmix64).
pub(crate) struct Dice(pub u64);

impl Dice {
    /// The next one.
    pub(crate) fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number between two others.
    pub(crate) fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.roll()
    }

    pub(crate) fn choose<T: Clone>(&mut self, from: &[T]) -> T {
        from[(self.roll() * from.len() as f64) as usize].clone()
    }
}
