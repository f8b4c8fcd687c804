//! Several rings by three methods: limit analysis, the equilibrium path and discrete elements differ by what joints deform, and by nothing else.
//!
//! `cargo test --release -p verification --test ring_methods` asks some bridges by the path, `-- --ignored --nocapture` fifty, or those that the
//! variable `EXTRADOS_RINGS` names (as 0..50), by discrete elements too, and prints the table of `docs/verification/brick-rings.md`.
#![expect(clippy::print_stdout, reason = "tables for the page")]

#[path = "random/mod.rs"]
mod random;

use assess::analysis::collapse_by;
use bridge::{Bridge, JointContact, JointStiffness, Method};
use mechanics::watch::Unwatched;
use outcome::collapse::{Collapse, Status};
use random::{Arch, Dice};
use std::fmt::Write;

/// What differs by more is to be explained.
const APART: f64 = 0.03;

/// A bridge of two to four rings of unlimited strength under a knife edge, whose joints have a stiffness.
fn drawn(seed: u64) -> Bridge {
    let dice = &mut Dice(7000 + seed);
    let profile = dice.of(&["segmental", "segmental", "semicircular", "elliptical", "parabolic"]);
    let rings = 2 + (seed % 3) as usize;
    let span = dice.decades(3.0, 12.0);
    let rise = span * dice.rise(profile, [0.15, 0.4], 0.8);
    let thickness = (span * dice.between(0.07, 0.12)).max(0.11 * rings as f64);
    let mut page = String::from("[bridge]\nname = \"drawn\"\nwidth = \"4 m\"\n\n");
    Arch { profile, span, rings, thickness, voussoirs: dice.count(14, 24) }.write(rise, &mut page);
    let normal = dice.decades(10.0, 60.0);
    let stiffness = format!(
        "normal_stiffness = \"{normal:.1} GPa/m\"\nshear_stiffness = \"{:.1} GPa/m\"\ncohesion = \"0 kPa\"\n",
        0.4 * normal
    );
    let [ring, between] = [dice.between(30.0, 40.0), dice.between(25.0, 45.0)];
    let _ = write!(
        page,
        "[masonry]\ndensity = \"2200 kg/m^3\"\ncompressive_strength = \"unlimited\"\nrounding = \"2 mm\"\n\n\
         [joint]\nfriction_angle = \"{ring:.1} deg\"\n{stiffness}\n\
         [ring_joint]\nfriction_angle = \"{between:.1} deg\"\n{stiffness}\n\
         [[cover]]\nlayer = \"fill\"\nthickness = \"{:.2} m\"\ndensity = \"1800 kg/m^3\"\n\n\
         [dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n\n\
         [[load]]\nkind = \"knife-edge\"\nforce = \"1 kN/m\"\nlength = \"0.3 m\"\nat = \"1/4 of span 1\"\n\n\
         [analysis]\nmethod = \"limit\"\n",
        dice.between(0.2, 0.8)
    );
    let read = bridge::read(page.as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{page}\n{:?}", read.diagnostics))
}

/// The same with joints so many times as stiff, pressed over their face or at their two ends.
fn stiffer(bridge: &Bridge, times: f64, contact: JointContact) -> Bridge {
    let mut own = bridge.clone();
    own.plan.contact = Some(contact);
    for joint in [&mut own.joint, &mut own.ring_joint] {
        for stiffness in [&mut joint.normal_stiffness, &mut joint.shear_stiffness] {
            if let Some(JointStiffness::Contact(k)) = stiffness {
                *k *= times;
            }
        }
    }
    own
}

fn by(method: Method, bridge: &Bridge) -> Collapse {
    let mut own = bridge.clone();
    own.plan.method = method;
    collapse_by(method, &own, &mut Unwatched).expect("it can be analysed")
}

/// The load factor of a bridge, nothing where it falls under its own weight; none where nothing is known.
fn carried(found: &Collapse) -> Option<f64> {
    match found.status {
        Status::UnstableUnderSelfWeight => Some(0.0),
        _ => found.load_factor(),
    }
}

/// Loads of one bridge [kN/m].
struct Row {
    seed: u64,
    rings: usize,
    limit: f64,
    /// By the path: joints pressed over their face; pressed at their ends, and with those ten and a hundred times as stiff.
    face: Option<f64>,
    ends: [Option<f64>; 3],
    /// By discrete elements, pressed at their ends: what is carried and what is not.
    elements: Option<[f64; 2]>,
}

impl Row {
    fn of(seed: u64, with_elements: bool) -> Option<Row> {
        let bridge = drawn(seed);
        let limit = carried(&by(Method::Limit, &bridge)).filter(|&load| load > 0.0)?;
        let path = |times, contact| carried(&by(Method::Path, &stiffer(&bridge, times, contact)));
        let elements = || {
            let mut own = stiffer(&bridge, 1.0, JointContact::Points);
            (own.plan.load_step, own.plan.resolution) = (Some(50.0 * limit), Some(5.0 * limit));
            let found = by(Method::Dem, &own);
            match found.status {
                Status::UnstableUnderSelfWeight => Some([0.0; 2]),
                _ => Some([found.carried()? / 1e3, found.collapse_load.unwrap_or(f64::NAN) / 1e3]),
            }
        };
        Some(Row {
            seed,
            rings: bridge.spans[0].rings.len(),
            limit,
            face: path(1.0, JointContact::Distributed),
            ends: [1.0, 10.0, 100.0].map(|times| path(times, JointContact::Points)),
            elements: with_elements.then(elements).flatten(),
        })
    }

    /// What the path comes to where joints do not deform: what deformation takes falls with the root of the stiffness of joints that are
    /// pressed at their ends.
    fn rigid(&self) -> Option<f64> {
        let [_, softer, harder] = self.ends;
        let root = 10f64.sqrt();
        Some((root * harder? - softer?) / (root - 1.0))
    }

    fn told(&self) -> String {
        let share = |load: Option<f64>| load.map_or("none".to_owned(), |load| format!("{:.3}", load / self.limit));
        let [one, ten, hundred] = self.ends.map(share);
        let [low, high] = [0, 1].map(|k| share(self.elements.map(|both| both[k])));
        let Row { seed, rings, limit, .. } = self;
        format!(
            "| {seed} | {rings} | {limit:.2} | {} | {one} | {low} to {high} | {ten} | {hundred} | {} |",
            share(self.face),
            share(self.rigid())
        )
    }
}

#[test]
fn the_path_of_rings_comes_to_their_limit_load_where_joints_do_not_deform() {
    for seed in [0, 3] {
        let row = Row::of(seed, false).expect("it stands");
        println!("{}", row.told());
        let rigid = row.rigid().expect("it is followed");
        assert!((rigid / row.limit - 1.0).abs() < APART, "{}", row.told());
    }
}

#[test]
#[ignore = "half an hour"]
fn three_methods_on_fifty_arches_of_several_rings() {
    for seed in random::seeds("EXTRADOS_RINGS", 0..50) {
        match Row::of(seed, true) {
            Some(row) => println!("{}", row.told()),
            None => println!("| {seed} | | falls | | | | | | |"),
        }
    }
}
