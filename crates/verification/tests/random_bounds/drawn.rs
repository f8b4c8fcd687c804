//! Bridge files whose fill is a continuum, drawn by a seed.

use crate::random::{Arch, Dice, pier, quantities};
use std::fmt::Write;

/// A bridge of one to three spans under soil, with a load on it and a mesh of no more than `elements` triangles.
pub(crate) fn draw(seed: u64, elements: usize) -> String {
    let dice = &mut Dice(seed);
    let mut page = String::new();
    let _ = writeln!(page, "[bridge]\nname = \"random {seed}\"\nwidth = \"{:.2} m\"\n", dice.between(2.0, 10.0));
    let span = dice.decades(2.0, 20.0);
    let spans = dice.count(1, 4).saturating_sub(1).max(1);
    let rise = arches(dice, span, spans, &mut page);
    layers(dice, &mut page);
    if dice.often(0.4) {
        backing(dice, rise, &mut page);
    }
    continuum(dice, rise, elements, &mut page);
    masonry(dice, &mut page);
    load(dice, spans, &mut page);
    page
}

/// The spans and the piers between them; returns the rise of the first span [m].
fn arches(dice: &mut Dice, span: f64, spans: usize, page: &mut String) -> f64 {
    let profile = dice.of(&["segmental", "segmental", "semicircular", "parabolic", "elliptical", "pointed"]);
    let ratio = dice.rise(profile, [0.1, 0.45], 0.9);
    let thickness = span * dice.decades(0.03, 0.12);
    let rings = dice.count(1, 3);
    let voussoirs = dice.count(6, 20);
    // Unlike spans differ in their rise.
    let unlike = dice.often(0.3) && !matches!(profile, "semicircular" | "pointed");
    for _ in 0..spans {
        let ratio = if unlike { ratio * dice.between(0.7, 1.0) } else { ratio };
        Arch { profile, span, rings, thickness, voussoirs }.write(ratio * span, page);
    }
    for _ in 1..spans {
        let width = 2.2 * thickness + span * dice.decades(0.05, 0.4);
        let height = span * dice.decades(0.1, 1.0);
        pier(width, height, dice.count(1, 5), page);
    }
    ratio * span
}

/// One to three layers of soil, the lowest of which fills the haunches, and perhaps a road that weighs alone.
fn layers(dice: &mut Dice, page: &mut String) {
    for _ in 0..dice.count(1, 3) {
        // Mud of 2 degrees to crushed stone; every fourth without cohesion.
        let friction = if dice.often(0.2) { dice.between(0.0, 12.0) } else { dice.between(15.0, 45.0) };
        let cohesion = if dice.often(0.25) && friction > 0.0 { 0.0 } else { dice.decades(0.05, 50.0) };
        let _ = writeln!(
            page,
            "[[cover]]\nlayer = \"fill\"\nas = \"continuum\"\nthickness = \"{:.3} m\"\ndensity = \"{:.0} kg/m^3\"\n\
             friction_angle = \"{friction:.2} deg\"\ncohesion = \"{cohesion:.3} kPa\"",
            dice.decades(0.1, 1.5),
            dice.between(1400.0, 2300.0)
        );
        if dice.often(0.15) {
            let _ = writeln!(page, "tensile_strength = \"{:.3} kPa\"", dice.decades(0.05, 10.0));
        }
        let _ = writeln!(page);
    }
    if dice.often(0.3) {
        let _ = writeln!(
            page,
            "[[cover]]\nlayer = \"surfacing\"\nthickness = \"{:.3} m\"\ndensity = \"2300 kg/m^3\"\n",
            dice.between(0.05, 0.2)
        );
    }
}

fn backing(dice: &mut Dice, rise: f64, page: &mut String) {
    let _ = writeln!(
        page,
        "[backing]\nas = \"continuum\"\nheight = \"{:.3} m\"\ndensity = \"2100 kg/m^3\"\nfriction_angle = \"{:.1} deg\"\n\
         cohesion = \"{:.1} kPa\"",
        rise * dice.between(0.2, 0.9),
        dice.between(30.0, 50.0),
        dice.decades(5.0, 500.0)
    );
    if dice.often(0.5) {
        let _ = writeln!(page, "tensile_strength = \"{:.2} kPa\"", dice.decades(1.0, 50.0));
    }
    if dice.often(0.5) {
        let _ = writeln!(page, "compressive_strength = \"{:.3} MPa\"", dice.decades(0.2, 10.0));
    }
    let _ = writeln!(page);
}

fn continuum(dice: &mut Dice, rise: f64, elements: usize, page: &mut String) {
    let _ = writeln!(page, "[continuum]\nbound_ratio = 1.2\nelements = {elements}");
    if dice.often(0.5) {
        let _ = writeln!(page, "mobilised_share = {:.3}", dice.between(0.2, 1.0));
    }
    if dice.often(0.5) {
        let _ = writeln!(page, "dilatancy_angle = \"{:.2} deg\"", dice.between(0.0, 45.0));
    }
    if dice.often(0.3) {
        let _ = writeln!(page, "water_level = \"{:.3} m\"", rise * dice.between(-0.5, 1.5));
    }
    if dice.often(0.5) {
        let _ = writeln!(page, "ends = \"{}\"", dice.of(&["slide", "hold", "free"]));
    }
    if dice.often(0.3) {
        let _ = writeln!(
            page,
            "interface_friction_angle = \"{:.1} deg\"\ninterface_cohesion = \"{:.2} kPa\"",
            dice.between(0.0, 35.0),
            dice.between(0.0, 5.0)
        );
    }
    if dice.often(0.3) {
        let _ = writeln!(page, "extent = \"{:.3} m\"", dice.decades(0.2, 20.0));
    }
    let _ = writeln!(page);
}

fn masonry(dice: &mut Dice, page: &mut String) {
    let strength = if dice.often(0.5) { "unlimited".to_owned() } else { format!("{:.2} MPa", dice.decades(1.0, 30.0)) };
    let _ = writeln!(
        page,
        "[masonry]\ndensity = \"{:.0} kg/m^3\"\ncompressive_strength = \"{strength}\"\n\n[joint]\nfriction_angle = \"{:.1} deg\"\n\
         cohesion = \"{:.1} kPa\"\n\n[dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n",
        dice.between(1800.0, 2600.0),
        dice.between(20.0, 45.0),
        if dice.often(0.2) { dice.between(0.0, 100.0) } else { 0.0 }
    );
}

fn load(dice: &mut Dice, spans: usize, page: &mut String) {
    let at = format!("{:.3} of span {}", dice.between(0.05, 0.95), dice.count(1, spans));
    let length = dice.decades(0.1, 1.5);
    if dice.often(0.4) {
        let _ = writeln!(
            page,
            "[[load]]\nname = \"line\"\nkind = \"knife-edge\"\nforce = \"1 kN/m\"\nlength = \"{length:.3} m\"\nat = \"{at}\""
        );
    } else {
        let axles = dice.count(1, 3);
        let forces = quantities((0..axles).map(|_| dice.between(10.0, 100.0)), 1, "kN");
        let spacings = quantities((1..axles).map(|_| dice.between(1.0, 4.0)), 2, "m");
        let _ = writeln!(
            page,
            "[[load]]\nname = \"axles\"\nkind = \"axles\"\naxle_forces = [{forces}]\naxle_spacings = [{spacings}]\n\
             contact_length = \"{length:.3} m\"\neffective_width = \"2.5 m\"\nat = \"{at}\""
        );
    }
    let _ = writeln!(page, "\n[analysis]\nmethod = \"limit\"");
}
