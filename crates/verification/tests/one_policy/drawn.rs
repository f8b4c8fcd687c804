//! Bridge files with nothing that may come and go, drawn by a seed: one or two spans of one or two rings under a vehicle.

use crate::random::{Arch, Dice, pier, quantities};
use std::fmt::Write;

pub(crate) fn draw(seed: u64) -> String {
    let dice = &mut Dice(seed);
    let mut page = String::new();
    let _ = writeln!(page, "[bridge]\nname = \"random {seed}\"\nwidth = \"4 m\"\n");
    let (spans, rings) = (1 + seed as usize % 2, 1 + seed as usize / 2 % 2);
    let profile = dice.of(&["segmental", "segmental", "semicircular", "parabolic", "elliptical"]);
    let span = dice.decades(3.0, 12.0);
    let rise = span * dice.rise(profile, [0.15, 0.4], 0.8);
    let thickness = (span * dice.decades(0.05, 0.1)).max(0.25);
    let voussoirs = dice.count(11, 21);
    (0..spans).for_each(|_| Arch { profile, span, rings, thickness, voussoirs }.write(rise, &mut page));
    for _ in 1..spans {
        pier(2.5 * thickness + 0.8, (100.0 * dice.between(1.0, 3.0)).round() / 100.0, 3, &mut page);
    }
    joints(dice, rings, &mut page);
    loads(dice, (span, spans), &mut page);
    page
}

/// Stones, their joints without bond, and what lies on them.
fn joints(dice: &mut Dice, rings: usize, page: &mut String) {
    let strength = if dice.often(0.5) { "unlimited".into() } else { format!("{:.1} MPa", dice.between(4.0, 20.0)) };
    let _ = writeln!(page, "[masonry]\ndensity = \"2100 kg/m^3\"\ncompressive_strength = \"{strength}\"\n");
    let stiffness = dice.decades(5.0, 60.0);
    for (name, least, most) in [("joint", 30.0, 42.0), ("ring_joint", 24.0, 40.0)].into_iter().take(rings) {
        let friction = dice.between(least, most);
        let _ = writeln!(
            page,
            "[{name}]\nfriction_angle = \"{friction:.1} deg\"\ncohesion = \"0 kPa\"\ntensile_strength = \"0 kPa\"\n\
             normal_stiffness = \"{stiffness:.2} GPa/m\"\nshear_stiffness = \"{:.2} GPa/m\"\n",
            0.4 * stiffness
        );
    }
    let _ = writeln!(
        page,
        "[[cover]]\nlayer = \"fill\"\nthickness = \"{:.2} m\"\ndensity = \"1900 kg/m^3\"\n\n[dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n",
        dice.between(0.2, 0.9)
    );
}

/// Axles of the file, a vehicle of the library and a support that moves.
fn loads(dice: &mut Dice, (span, spans): (f64, usize), page: &mut String) {
    let axles = dice.count(1, 2);
    let forces = quantities((0..axles).map(|_| dice.between(60.0, 200.0)), 0, "kN");
    let spacings = quantities((1..axles).map(|_| dice.between(1.2, 3.0)), 2, "m");
    let _ = writeln!(
        page,
        "[[load]]\nkind = \"axles\"\naxle_forces = [{forces}]\naxle_spacings = [{spacings}]\ncontact_length = \"0.30 m\"\n\
         effective_width = \"3.0 m\"\nat = \"{}/20 of span {}\"\n\n[sweep]\nrule = \"characteristic\"\nvehicles = [\"cs454-single\"]\n\
         step = \"{:.3} m\"\n\n[carriageway]\nlanes = 1\n\n[support_movement]\nsupport = \"right abutment\"\nhorizontal = 1.0\n\n\
         [analysis]\nmethod = \"limit\"",
        dice.count(4, 10),
        dice.count(1, spans),
        span / 10.0
    );
}
