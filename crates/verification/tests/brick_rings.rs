//! Rings that slide on one another: one number for a load by itself, in a sweep and dragged; an answer for every strength.
//!
//! `cargo test --release -p verification --test brick_rings` asks some bridges, `-- --ignored --nocapture` a hundred, or those that the variable
//! `EXTRADOS_RINGS` names (as 0..30), and prints the tables of `docs/verification/brick-rings.md`.
#![expect(clippy::print_stdout, reason = "tables for the page")]

#[path = "random/mod.rs"]
mod random;

use assess::analysis::placing::Placing;
use assess::analysis::{Places, collapse, sweep};
use bridge::Bridge;
use mechanics::watch::Unwatched;
use outcome::collapse::{Collapse, Status};
use random::{Arch, Dice};
use std::fmt::Write;

/// Loads are compared to this.
const SAME: f64 = 1e-3;

/// A bridge of one to five rings, some with backing as blocks, under a knife edge.
fn drawn(seed: u64) -> Bridge {
    let dice = &mut Dice(seed);
    let profile = dice.of(&["segmental", "segmental", "semicircular", "elliptical", "parabolic"]);
    let rings = 1 + (seed % 5) as usize;
    let span = dice.decades(3.0, 12.0);
    let rise = span * dice.rise(profile, [0.15, 0.4], 0.8);
    let thickness = (span * dice.between(0.05, 0.1)).max(0.11 * rings as f64);
    let mut page = String::from("[bridge]\nname = \"drawn\"\nwidth = \"4 m\"\n\n");
    Arch { profile, span, rings, thickness, voussoirs: dice.count(14, 30) }.write(rise, &mut page);
    let [ring, between] = [dice.between(30.0, 40.0), dice.between(25.0, 45.0)];
    let strength = if dice.often(0.5) { "unlimited".to_owned() } else { format!("{:.1} MPa", dice.decades(2.0, 20.0)) };
    let backing = match dice.often(0.5) {
        true => format!(
            "[backing]\nheight = \"{:.2} m\"\ndensity = \"2200 kg/m^3\"\nas = \"blocks\"\n",
            rise * dice.between(0.2, 0.5)
        ),
        false => String::new(),
    };
    let _ = write!(
        page,
        "[masonry]\ndensity = \"2200 kg/m^3\"\ncompressive_strength = \"{strength}\"\nrounding = \"1 mm\"\n\n\
         [joint]\nfriction_angle = \"{ring:.1} deg\"\ncohesion = \"0 kPa\"\n\n\
         [ring_joint]\nfriction_angle = \"{between:.1} deg\"\ncohesion = \"0 kPa\"\n\n\
         [[cover]]\nlayer = \"fill\"\nthickness = \"{:.2} m\"\ndensity = \"1800 kg/m^3\"\n\n\
         [dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n\n\
         [[load]]\nkind = \"knife-edge\"\nforce = \"1 kN/m\"\nlength = \"0.3 m\"\nat = \"1/4 of span 1\"\n\n\
         [analysis]\nmethod = \"limit\"\n\n{backing}",
        dice.between(0.2, 0.8)
    );
    read(&page)
}

fn read(page: &str) -> Bridge {
    let read = bridge::read(page.as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{page}\n{:?}", read.diagnostics))
}

fn at(bridge: &Bridge, position: f64) -> Collapse {
    let mut own = bridge.clone();
    own.loads[0].position = position;
    collapse(&own, None, &mut Unwatched).expect("it can be analysed")
}

/// What came of the comparisons.
#[derive(Debug, Default)]
struct Compared {
    bridges: usize,
    falls: usize,
    /// Bridges of which blocks cannot be made.
    refused: usize,
    places: usize,
    open: usize,
    apart: f64,
    told: Vec<String>,
}

/// Five places of every bridge: in a sweep of all of them, by itself and dragged.
fn compare(seeds: std::ops::Range<u64>) -> Compared {
    let mut found = Compared::default();
    for seed in seeds {
        let bridge = drawn(seed);
        let span = bridge.spans[0].span;
        let places = Places::Between([0.1 * span, 0.5 * span], 5);
        let (Ok(swept), Ok(mut placing)) = (sweep(&bridge, places, false, &mut Unwatched), Placing::loads(&bridge))
        else {
            found.refused += 1;
            continue;
        };
        found.bridges += 1;
        if !placing.stands() {
            found.falls += 1;
            continue;
        }
        let least = swept.points.iter().filter_map(|point| point.load_factor).fold(f64::INFINITY, f64::min);
        // Beyond twice the least one, which is not known where a place is open, a sweep keeps the load with dilation.
        let whole = swept.points.iter().all(|point| point.load_factor.is_some());
        for point in swept.points.iter().filter(|point| point.load_factor.is_none_or(|own| whole && own < 1.9 * least))
        {
            let alone = at(&bridge, point.position);
            let dragged = placing.carried(point.position);
            found.places += 1;
            let numbers = [point.load_factor, alone.load_factor(), dragged.factor];
            match numbers {
                [Some(swept), Some(alone), Some(dragged)] => {
                    let apart = (swept / alone - 1.0).abs().max((dragged / alone - 1.0).abs());
                    found.apart = found.apart.max(apart);
                    if apart > SAME {
                        found.told.push(format!("{seed} at {:.3} m: {swept} {alone} {dragged}", point.position));
                    }
                }
                [None, None, None] => found.open += 1,
                _ => found.told.push(format!(
                    "{seed} at {:.3} m: {numbers:?} {:?} {:?} {:?}",
                    point.position, point.status, alone.status, dragged.status
                )),
            }
        }
    }
    found
}

#[test]
fn some_bridges_carry_the_same_alone_swept_and_dragged() {
    let found = compare(0..10);
    assert!(found.told.is_empty() && found.places > 20, "{found:?}");
}

/// A joint that slides again while blocks next to move as one tells the direction by less than round-off: its way once went back to where it had come from.
#[test]
fn a_way_does_not_turn_back_where_little_tells_its_direction() {
    let bridge = drawn(58);
    let [before, there, after] = [2.549, 2.55, 2.551].map(|position| at(&bridge, position).load_factor().unwrap());
    assert!((there / before - 1.0).abs() < SAME && (there / after - 1.0).abs() < SAME, "{before} {there} {after}");
}

#[test]
#[ignore = "minutes"]
fn a_hundred_bridges_carry_the_same_alone_swept_and_dragged() {
    let found = compare(random::seeds("EXTRADOS_RINGS", 0..100));
    println!("{found:#?}");
    assert!(found.told.is_empty() && found.places > 0 && found.apart < SAME, "{:?}", found.told);
}

/// An arch of 5 m of so many rings of half a brick.
fn strong(rings: usize, friction: f64, strength: f64) -> Bridge {
    let mut page = String::from("[bridge]\nname = \"strength\"\nwidth = \"3 m\"\n\n");
    Arch { profile: "segmental", span: 5.0, rings, thickness: 0.11 * rings.max(2) as f64, voussoirs: 24 }
        .write(1.25, &mut page);
    let _ = write!(
        page,
        "[masonry]\ndensity = \"2000 kg/m^3\"\ncompressive_strength = \"{strength} MPa\"\nrounding = \"0 mm\"\n\n\
         [joint]\nfriction_angle = \"35 deg\"\ncohesion = \"0 kPa\"\n\n\
         [ring_joint]\nfriction_angle = \"{friction} deg\"\ncohesion = \"0 kPa\"\n\n\
         [[cover]]\nlayer = \"fill\"\nthickness = \"0.3 m\"\ndensity = \"1800 kg/m^3\"\n\n\
         [dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n\n\
         [[load]]\nkind = \"knife-edge\"\nforce = \"1 kN/m\"\nlength = \"0.3 m\"\nat = \"1/4 of span 1\"\n\n\
         [analysis]\nmethod = \"limit\"\n"
    );
    read(&page)
}

/// Strengths x rings x friction between rings: loads [kN/m], and how far one falls where masonry is stronger.
fn strengths(rings: &[usize], frictions: &[f64], all: &[f64]) -> (usize, f64) {
    let (mut unanswered, mut falls) = (0, 0.0f64);
    for &rings in rings {
        for &friction in frictions {
            let mut before = 0.0f64;
            let mut row = format!("| {rings} | {friction:.0}° |");
            for &strength in all {
                let found = collapse(&strong(rings, friction, strength), None, &mut Unwatched).unwrap();
                let stands = found.status != Status::UnstableUnderSelfWeight;
                match found.load_factor() {
                    Some(own) => {
                        let associated = found
                            .limit()
                            .and_then(|limit| limit.associated_load)
                            .map_or(f64::INFINITY, |load| load / 1e3);
                        assert!(own <= associated * (1.0 + 1e-6), "{rings} {friction} {strength}: {own} {associated}");
                        falls = falls.max(1.0 - own / before.max(own));
                        before = before.max(own);
                        let _ = write!(row, " {own:.2} |");
                    }
                    None if stands => {
                        unanswered += 1;
                        row.push_str(" none |");
                    }
                    None => row.push_str(" falls |"),
                }
            }
            println!("{row}");
        }
    }
    (unanswered, falls)
}

#[test]
fn weak_masonry_in_three_rings_is_answered() {
    let (unanswered, falls) = strengths(&[3], &[35.0], &[0.5, 0.7, 2.0, 10.0]);
    assert!(unanswered == 0 && falls < 0.02, "{unanswered} {falls}");
}

#[test]
#[ignore = "a minute"]
fn every_strength_in_one_to_five_rings_is_answered() {
    let all = [0.3, 0.5, 0.7, 1.0, 2.0, 5.0, 10.0, 20.0];
    let (unanswered, falls) = strengths(&[1, 2, 3, 4, 5], &[25.0, 30.0, 35.0, 40.0, 45.0], &all);
    println!("unanswered {unanswered}, largest fall where masonry is stronger {falls:.4}");
    assert!(unanswered == 0 && falls < 1e-3, "{unanswered} {falls}");
}
