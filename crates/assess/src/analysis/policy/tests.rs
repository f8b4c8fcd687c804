//! No result is above that of the same bridge without what may come and go: methods by questions by helps. The bridge without a help is written
//! as a file without it, and is not made by the code under test.

use super::super::placing::Placing;
use super::super::sweep::{Places, sweep};
use super::super::vehicles::vehicle_sweep;
use super::super::{AnalysisError, collapse};
use super::states::states;
use bridge::{Analysis, Bridge, Method, Strip};
use mechanics::watch::{Progress, Unwatched, Watch, Wish};
use outcome::collapse::{Collapse, Status};
use outcome::help::{Help, NotCounted};
use outcome::note::{self, Note};
use outcome::warning;

/// A short ring under fill, of stone that crushes, on deformable joints.
const RING: &str = r#"
[bridge]
name = "short"
width = "3 m"

[[span]]
profile = "segmental"
span = "5 m"
rise = "1.25 m"
thickness = "0.4 m"
voussoirs = 15

[abutment]
top_width = "2 m"
height = "2 m"

[[cover]]
layer = "fill"
thickness = "0.4 m"
density = "1900 kg/m^3"

[masonry]
density = "2200 kg/m^3"
compressive_strength = "5 MPa"

[joint]
normal_stiffness = "40 GPa/m"
shear_stiffness = "15 GPa/m"
friction_angle = "35 deg"
cohesion = "0 kPa"
tensile_strength = "0 kPa"

[dispersal]
rule = "uniform"
slope = "2:1"

[[load]]
kind = "knife-edge"
force = "10 kN/m"
length = "0.3 m"
position = "1.25 m"

[analysis]
method = "limit"
"#;

/// Two rings in place of one.
fn two_rings() -> String {
    RING.replace(
        "thickness = \"0.4 m\"\nvoussoirs = 15\n",
        "\n[[span.ring]]\nthickness = \"0.2 m\"\nvoussoirs = 15\n\n[[span.ring]]\nthickness = \"0.2 m\"\nvoussoirs = 15\n",
    ) + "\n[ring_joint]\nnormal_stiffness = \"10 GPa/m\"\nshear_stiffness = \"4 GPa/m\"\nfriction_angle = \"28 deg\"\ncohesion = \"0 kPa\"\n"
}

const WATER: &str = "\n[water]\nlevel = \"1.4 m\"\nsaturated_density = \"2100 kg/m^3\"\n";
const PRESSURE: &str = "\n[fill_pressure]\nfriction_angle = \"35 deg\"\ncohesion = \"5 kPa\"\nmobilisation = 1.0\ncohesion_mobilisation = 0.5\n";
const LOST_STONE: &str =
    "\n[[defect]]\nkind = \"thin-ring\"\nface = \"intrados\"\nfrom = \"0.4 m\"\nto = \"1.2 m\"\ndepth = \"60 mm\"\n";
const MOVED_BEFORE: &str = "\n[support_movement]\nsupport = \"right abutment\"\nhorizontal = 1.0\nbefore = \"20 mm\"\n";
const SOIL: &str = "as = \"continuum\"\nfriction_angle = \"35 deg\"\ncohesion = \"2 kPa\"\n";

/// The text of a bridge with a help.
fn with(text: &str, help: Help) -> String {
    match help {
        Help::Water => text.to_owned() + WATER,
        Help::FillPressure => text.to_owned() + PRESSURE,
        Help::Tension => text.replacen("tensile_strength = \"0 kPa\"", "tensile_strength = \"100 kPa\"", 1),
        Help::Cohesion => text.replace("cohesion = \"0 kPa\"", "cohesion = \"500 kPa\""),
        Help::Movement => text.to_owned() + MOVED_BEFORE,
        Help::LostStone => text.to_owned() + LOST_STONE,
        Help::Parapets => unreachable!("of a wall"),
    }
}

fn read(text: &str) -> Bridge {
    let read = bridge::read(text.as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{:?}\n{text}", read.diagnostics))
}

fn by(text: &str, method: Method) -> Bridge {
    let mut bridge = read(text);
    bridge.plan.method = method;
    bridge
}

fn found(bridge: &Bridge) -> Collapse {
    collapse(bridge, None, &mut Unwatched).unwrap()
}

/// Asserts that a number without a help is not passed by one with it, and that what the help adds is told: `added` is the number as
/// described.
fn is_not_counted(what: &str, [with, without]: [f64; 2], slack: f64, told: &NotCounted) {
    assert!(with <= without * (1.0 + 1e-6) + slack, "{what}: {with} with help leads, {without} without");
    for one in &told.with_help {
        assert!(!one.helps.is_empty() && one.helps.iter().any(|help| told.left_out.contains(help)), "{what}: {told:?}");
    }
}

/// What one load comes to by every method, with every help that the method can see. The load with it is told where it is more, so that for most
/// of them something is told.
#[test]
fn no_method_counts_what_may_come_and_go() {
    use Help::{Cohesion, FillPressure, LostStone, Movement, Tension, Water};
    let cases: [(&str, String, Method, &[Help]); 5] = [
        ("limit", RING.to_owned(), Method::Limit, &[Water, Movement, FillPressure, LostStone, Tension, Cohesion]),
        ("limit, two rings", two_rings(), Method::Limit, &[Water, FillPressure, Tension, Cohesion]),
        ("path", RING.to_owned(), Method::Path, &[Water, FillPressure, LostStone, Tension, Cohesion]),
        ("path, two rings", two_rings(), Method::Path, &[Cohesion]),
        ("dem", RING.to_owned() + "load_step = \"10 kN/m\"\n", Method::Dem, &[Water, LostStone, Tension]),
    ];
    let mut told = Vec::new();
    for (name, text, method, helps) in &cases {
        let bare = found(&by(text, *method));
        let step = if *method == Method::Dem { bare.load_step.unwrap() } else { 0.0 };
        for help in *helps {
            let helped = found(&by(&self::with(text, *help), *method));
            let what = format!("{name}, {help}");
            is_not_counted(&what, [&helped, &bare].map(|one| one.carried().unwrap()), step, &helped.not_counted);
            let own = [&helped, &bare].map(|one| one.last_stable_load.unwrap());
            is_not_counted(&what, own, step, &helped.not_counted);
            if helped.not_counted.left_out.contains(help) {
                let added = helped.not_counted.with(*help).unwrap();
                assert!(added.headline.unwrap() > 1.001 * helped.carried().unwrap(), "{what}");
                let codes: Vec<&str> = helped.warnings.iter().map(|warning| warning.code()).collect();
                let code = if *help == FillPressure { warning::PRESSURE_RANGE } else { warning::HELP_NOT_COUNTED };
                assert_eq!(codes.iter().filter(|one| **one == code).count(), 1, "{what}: {codes:?}");
                told.push(what);
            }
        }
    }
    let expected = [
        "limit, tension of joints",
        "limit, fill pressure",
        "path, water in the fill",
        "path, fill pressure",
        "path, two rings, cohesion of joints",
        "dem, tension of joints",
    ];
    for what in expected {
        assert!(told.iter().any(|one| one == what), "{what} adds something, which is told: {told:?}");
    }
}

/// Soil that yields beside joints: the lower bound without water and without bond leads.
#[test]
fn bounds_beside_a_continuum_count_no_help() {
    let text = RING.replacen("layer = \"fill\"\n", &format!("layer = \"fill\"\n{SOIL}"), 1)
        + "\n[continuum]\nelements = 600\nbound_ratio = 1.3\n";
    let bare = found(&read(&text)).carried().unwrap();
    for help in [Help::Water, Help::Tension] {
        let helped = found(&read(&self::with(&text, help)));
        is_not_counted(help.word(), [helped.carried().unwrap(), bare], 0.0, &helped.not_counted);
    }
}

/// Finite elements between fixed abutments.
#[test]
fn finite_elements_count_no_water() {
    let bare = found(&by(RING, Method::Fe));
    let wet = found(&by(&self::with(RING, Help::Water), Method::Fe));
    is_not_counted("fe", [wet.carried().unwrap(), bare.carried().unwrap()], 0.0, &wet.not_counted);
}

/// A help that hurts is counted, and the load without it is told.
#[test]
fn a_help_that_hurts_counts() {
    let wet = self::with(RING, Help::Water)
        .replace("2100 kg/m^3", "1901 kg/m^3")
        .replace("1.25 m\"\n\n[analysis]", "2.5 m\"\n\n[analysis]");
    let dry = RING.replace("1.25 m\"\n\n[analysis]", "2.5 m\"\n\n[analysis]");
    let [wet, dry] = [wet, dry].map(|text| found(&read(&text)));
    let [with, without] = [&wet, &dry].map(|one| one.carried().unwrap());
    assert!(with <= without * (1.0 + 1e-6), "{with} {without}");
    if with < 0.999 * without {
        assert!(wet.not_counted.left_out.is_empty());
        let told =
            |said: &Note| matches!(said, Note::State(note::State::Counted { helps, .. }) if helps[..] == [Help::Water]);
        assert!(wet.assumptions.iter().any(told));
    }
}

/// Stone that is lost anywhere, on either face, never raises what is carried, one place of it or several, and by loads that move as well.
#[test]
fn lost_stone_anywhere_raises_no_load() {
    let mut dice = crate::samples::Dice(20_261_127);
    let uncrushed = RING.replace("5 MPa", "unlimited");
    let carried = |text: &str| found(&read(text)).carried().unwrap();
    let moved = |text: &str| {
        let found = sweep(&read(text), Places::Between([0.0, 5.0], 6), true, &mut Unwatched).unwrap();
        found.worst().unwrap().bound().unwrap()
    };
    let [sound, swept] = [carried(&uncrushed), moved(&uncrushed)];
    let (mut raised, mut text) = (0, String::new());
    for number in 0..24 {
        if number % 3 == 0 {
            text.clone_from(&uncrushed);
        }
        let (from, face) = (4.2 * dice.roll(), ["intrados", "extrados"][(2.0 * dice.roll()) as usize]);
        let (to, depth) = (from + 0.3 + 0.5 * dice.roll(), 0.02 + 0.08 * dice.roll());
        text += &format!(
            "\n[[defect]]\nkind = \"thin-ring\"\nface = \"{face}\"\nfrom = \"{from} m\"\nto = \"{to} m\"\ndepth = \"{depth} m\"\n"
        );
        let own = found(&read(&text));
        assert!(own.carried().unwrap() <= sound * (1.0 + 1e-6), "{:?} {sound}\n{text}", own.carried());
        // The worst place is sought between positions, as near as to a ten-thousandth of the load.
        let least = moved(&text);
        assert!(least <= swept * (1.0 + 1e-4), "{least} {swept}\n{text}");
        raised += usize::from(own.not_counted.left_out == [Help::LostStone]);
    }
    assert!(raised > 0, "some of it would have helped, which is told");
}

/// Several helps together: nothing less is left when one of them is taken away.
#[test]
fn several_helps_are_left_out_together() {
    let all = self::with(&self::with(&self::with(RING, Help::Tension), Help::Water), Help::FillPressure);
    let least = found(&read(&all));
    for text in [
        RING.to_owned(),
        self::with(RING, Help::Tension),
        self::with(RING, Help::Water),
        self::with(&self::with(RING, Help::Tension), Help::FillPressure),
    ] {
        let other = found(&read(&text)).carried().unwrap();
        assert!(least.carried().unwrap() <= other * (1.0 + 1e-6), "{:?} of {other}", least.carried());
    }
    let with = &least.not_counted.with_help;
    assert!(with.iter().any(|one| one.helps == [Help::Water, Help::FillPressure, Help::Tension]), "{with:?}");
}

/// Helps that a sweep by a method knows.
const MOVED: [(Method, &[Help]); 2] = [
    (Method::Limit, &[Help::Water, Help::FillPressure, Help::Tension, Help::Cohesion]),
    (Method::Path, &[Help::Water, Help::Tension]),
];

/// Loads that move: at every position the least counts, and what helps is told at the governing one.
#[test]
fn no_position_counts_what_may_come_and_go() {
    let places = Places::Between([0.0, 5.0], 6);
    for (method, helps) in MOVED {
        let bare = sweep(&by(RING, method), places, true, &mut Unwatched).unwrap();
        for help in helps {
            let helped = sweep(&by(&self::with(RING, *help), method), places, true, &mut Unwatched).unwrap();
            let factor = |sweep: &outcome::sweep::Sweep| sweep.worst().unwrap().load_factor.unwrap();
            let what = format!("{method:?}, {help}");
            is_not_counted(&what, [factor(&helped), factor(&bare)], 0.0, &helped.not_counted);
            for point in &helped.points {
                let same = bare.points.iter().find(|one| (one.position - point.position).abs() < 1e-9);
                let both = same.and_then(|same| Some([point.load_factor?, same.load_factor?]));
                assert!(both.is_none_or(|[with, without]| with <= without * (1.0 + 1e-4)), "{what}: {both:?}");
            }
            if matches!(help, Help::Tension | Help::FillPressure) && method == Method::Limit {
                assert_eq!(helped.not_counted.left_out, [*help], "{what}");
                assert!(helped.not_counted.with(*help).unwrap().factor.unwrap() > 1.01 * factor(&helped), "{what}");
            }
        }
    }
}

/// Vehicles under a rule, and the same vehicle placed by hand.
#[test]
fn no_vehicle_counts_what_may_come_and_go() {
    let driven = RING.to_owned()
        + "\n[sweep]\nrule = \"characteristic\"\nvehicles = [\"cs454-single\"]\nstep = \"0.5 m\"\n\n[carriageway]\nlanes = 1\n";
    for (method, helps) in MOVED {
        let bare = vehicle_sweep(&by(&driven, method), &mut Unwatched).unwrap();
        for help in helps {
            let helped = vehicle_sweep(&by(&self::with(&driven, *help), method), &mut Unwatched).unwrap();
            let (own, plain) = (&helped.vehicles[0], &bare.vehicles[0]);
            let what = format!("{method:?}, {help}");
            is_not_counted(&what, [own.adequacy.unwrap(), plain.adequacy.unwrap()], 0.0, &own.not_counted);
            if let (Some(own), Some(plain)) = (&own.deformable, &plain.deformable) {
                for plain in &plain.permissible {
                    let met = own.permissible.iter().find(|one| one.criterion == plain.criterion).unwrap();
                    assert!(met.adequacy <= plain.adequacy * (1.0 + 1e-4), "{what}: {met:?} {plain:?}");
                }
            }
            if *help == Help::Tension && method == Method::Limit {
                assert_eq!(own.not_counted.left_out, [*help], "{what}");
                assert!(helped.warnings.iter().any(|told| told.code() == warning::HELP_NOT_COUNTED), "{what}");
            }
        }
    }
}

/// A load that is placed by hand carries what it does alone at that place.
#[test]
fn a_load_that_is_dragged_counts_no_help() {
    for help in [Help::Water, Help::FillPressure, Help::Tension, Help::Cohesion] {
        let text = self::with(RING, help);
        let (mut helped, mut bare) = (Placing::loads(&read(&text)).unwrap(), Placing::loads(&read(RING)).unwrap());
        for place in [0.8, 1.25, 2.5, 3.4] {
            let [with, without] = [&mut helped, &mut bare].map(|one| one.carried(place).factor.unwrap());
            assert!(with <= without * (1.0 + 1e-6), "{help} at {place}: {with} {without}");
            assert!((helped.put(place).factor.unwrap() / with - 1.0).abs() < 1e-6, "{help} at {place}");
            assert!(
                helped.put_quickly(place).factor.unwrap() <= bare.put_quickly(place).factor.unwrap() * (1.0 + 1e-6)
            );
            let mut alone = read(&text);
            alone.loads[0].position = place;
            let alone = found(&alone);
            let factor = alone.carried().unwrap() / alone.reference_load;
            assert!((factor / with - 1.0).abs() < 1e-5, "{help} at {place}: dragged {with}, alone {factor}");
        }
        assert!(helped.assumptions().contains(&note::State::NotCounted { helps: vec![help] }.into()));
    }
}

/// The thickness that stands is no less, and the movement that is survived no more, for strength that may be lost.
#[test]
fn thickness_and_movement_count_no_help() {
    for help in [Help::Tension, Help::Water] {
        let asked = |text: &str, analysis| {
            let mut bridge = read(text);
            bridge.plan.analysis = analysis;
            bridge.plan.support_movement = Some(bridge::SupportMovement {
                support: 1,
                horizontal: 1.0,
                vertical: 0.0,
                rotation: 0.0,
                before: None,
                increment: None,
                limit: Some(0.5),
            });
            found(&bridge)
        };
        let helped = self::with(RING, help);
        let least = |text: &str| asked(text, Analysis::Thickness).thickness().unwrap().factor[1];
        assert!(least(&helped) >= least(RING) * (1.0 - 1e-6), "{help}");
        let most = |text: &str| asked(text, Analysis::SupportMovement).support().unwrap().last_stable.unwrap();
        assert!(most(&helped) <= most(RING) * (1.0 + 1e-3), "{help}");
    }
    let told = {
        let mut bridge = read(&self::with(RING, Help::Tension));
        bridge.plan.analysis = Analysis::Thickness;
        found(&bridge).not_counted
    };
    assert_eq!(told.left_out, [Help::Tension]);
}

/// A wall counts neither the bond of its joints nor what of it stands above the road.
#[test]
fn a_wall_is_analysed_without_bond_and_without_its_parapet() {
    let mut plain = crate::samples::bridgemill();
    plain.spandrel_wall = Some(crate::samples::spandrel_wall(&plain));
    (plain.plan.method, plain.plan.strip) = (Method::Limit, Strip::Wall);
    assert_eq!(states(&plain).len(), 1);
    let changes: [fn(&mut Bridge); 2] = [
        |own| own.spandrel_wall.as_mut().unwrap().joint.tensile_strength = 200e3,
        |own| own.spandrel_wall.as_mut().unwrap().top = Some(own.cover.depth + 1.0),
    ];
    for change in changes {
        let mut own = plain.clone();
        change(&mut own);
        let states = states(&own);
        assert_eq!(states.len(), 2);
        assert!(states[0].helps.is_empty() && states[1].bridge == own);
    }
}

/// Cohesion that changes nothing is not spoken of, and a bridge without help is analysed once.
#[test]
fn what_makes_no_difference_makes_no_noise() {
    let quiet = RING.replacen("cohesion = \"0 kPa\"", "cohesion = \"1 kPa\"", 1);
    let said = found(&read(&quiet));
    assert_eq!(said.not_counted, NotCounted::default());
    assert!(said.warnings.iter().all(|told| told.code() != warning::HELP_NOT_COUNTED), "{:?}", said.warnings);
    assert_eq!(states(&read(RING)).len(), 1);
    // Rigid joints that turn about an edge have no cohesion.
    let uncrushed = quiet.replace("5 MPa", "unlimited");
    assert_eq!(states(&read(&uncrushed)).len(), 1);
    assert_eq!(states(&by(&uncrushed, Method::Path)).len(), 2);
}

/// An onlooker who stops after so many kept states, and holds the last one.
struct Keeps {
    left: usize,
    kept: Option<Vec<u8>>,
}

impl Watch for Keeps {
    fn look(&mut self, _: &Progress) -> Wish {
        if self.left == 0 { Wish::Stop } else { Wish::GoOn }
    }
    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        self.left = self.left.saturating_sub(1);
        self.kept = Some(state());
    }
}

/// A run that is taken up where it stood, before the second state or within it, ends in the same numbers.
#[test]
fn a_run_over_several_states_resumes_to_the_same_result() {
    let bridge = by(&(self::with(RING, Help::Tension) + "load_step = \"20 kN/m\"\n"), Method::Dem);
    let whole = found(&bridge);
    let mut seen = Vec::new();
    for left in [1, 3, 6, 9, 12] {
        let mut keeps = Keeps { left, kept: None };
        let stopped = collapse(&bridge, None, &mut keeps).unwrap();
        if stopped.status != Status::Cancelled {
            continue;
        }
        let kept = keeps.kept.unwrap();
        seen.push(kept[0]);
        let again = collapse(&bridge, Some(&kept), &mut Unwatched).unwrap();
        assert_eq!((again.last_stable_load, again.collapse_load), (whole.last_stable_load, whole.collapse_load));
        assert_eq!(again.not_counted, whole.not_counted);
    }
    assert!(seen.contains(&0), "{seen:?}");
    let foreign = collapse(&bridge, Some(&[7, 1, 2]), &mut Unwatched);
    assert!(matches!(foreign, Err(AnalysisError::Model(_))), "a state of another bridge is refused");
}
