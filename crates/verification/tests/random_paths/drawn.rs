//! Bridge files of one to five spans and rings, with and without walls, backing and bond, under vehicles, drawn by a seed.

use crate::random::{Arch, Dice, pier, quantities};
use std::fmt::Write;

/// Half of the bridges have one ring, half of them one span, one in sixteen a strip of its walls, whose paths are long.
pub(crate) fn draw(seed: u64) -> String {
    let dice = &mut Dice(seed);
    let mut page = String::new();
    let _ = writeln!(page, "[bridge]\nname = \"random {seed}\"\nwidth = \"4 m\"\n");
    let wall = seed % 16 == 15;
    let rings = if wall || dice.often(0.5) { 1 } else { dice.count(2, 5) };
    let spans = if wall || dice.often(0.5) { 1 } else { dice.count(2, 5) };
    let span = dice.decades(3.0, 15.0);
    let rise = arches(dice, (spans, rings), span, &mut page);
    joints(dice, rings, &mut page);
    let _ = writeln!(
        page,
        "[[cover]]\nlayer = \"fill\"\nthickness = \"{:.2} m\"\ndensity = \"1900 kg/m^3\"\n\n[dispersal]\nrule = \"uniform\"\n\
         slope = \"2:1\"\n",
        dice.between(0.2, 1.0)
    );
    if wall {
        page.push_str(
            "[spandrel_wall]\nbrick_length = \"1.0 m\"\nbrick_height = \"0.5 m\"\nthickness = \"0.44 m\"\nbond = \"half\"\n\
             end_walls = false\n\n",
        );
    } else if dice.often(0.4) {
        let _ = writeln!(
            page,
            "[backing]\nheight = \"{:.2} m\"\ndensity = \"2000 kg/m^3\"\n",
            rise * dice.between(0.2, 0.6)
        );
    }
    vehicle(dice, spans, &mut page);
    let contact = if dice.often(0.3) { "points" } else { "distributed" };
    let strip = if wall { "wall" } else { "fill" };
    let _ = writeln!(page, "[analysis]\nmethod = \"path\"\nstrip = \"{strip}\"\n# contact {contact}");
    page
}

/// Spans and the piers between them; returns the rise [m].
fn arches(dice: &mut Dice, (spans, rings): (usize, usize), span: f64, page: &mut String) -> f64 {
    let profile =
        dice.of(&["segmental", "segmental", "segmental", "semicircular", "parabolic", "elliptical", "pointed"]);
    let rise = span * dice.rise(profile, [0.12, 0.45], 0.8);
    let depth = (span * dice.decades(0.04, 0.12)).max(0.2);
    let voussoirs = dice.count(12, 30);
    (0..spans).for_each(|_| Arch { profile, span, rings, thickness: depth, voussoirs }.write(rise, page));
    let width = (2.5 * depth + 0.3).max(span * dice.between(0.1, 0.3)).max(0.8);
    for _ in 1..spans {
        // To the centimetre.
        let height = (100.0 * dice.between(1.0, 6.0)).round() / 100.0;
        pier(width, height, dice.count(2, 8), page);
    }
    rise
}

/// Stones and their joints.
fn joints(dice: &mut Dice, rings: usize, page: &mut String) {
    let strength = if dice.often(0.5) { "unlimited".into() } else { format!("{:.1} MPa", dice.between(4.0, 30.0)) };
    let _ = writeln!(page, "[masonry]\ndensity = \"2100 kg/m^3\"\ncompressive_strength = \"{strength}\"\n");
    let stiffness = dice.decades(1.0, 100.0);
    let bond = if dice.often(0.25) { dice.decades(5.0, 500.0) } else { 0.0 };
    for (name, least, most) in [("joint", 28.0, 42.0), ("ring_joint", 20.0, 40.0)].into_iter().take(rings.min(2)) {
        let (friction, shear) = (dice.between(least, most), stiffness * dice.between(0.1, 0.5));
        let _ = writeln!(
            page,
            "[{name}]\nfriction_angle = \"{friction:.1} deg\"\ncohesion = \"0 kPa\"\nnormal_stiffness = \"{stiffness:.3} GPa/m\"\n\
             shear_stiffness = \"{shear:.3} GPa/m\"\ntensile_strength = \"{bond:.1} kPa\"\n"
        );
    }
}

/// One to thirteen axles somewhere on a span.
fn vehicle(dice: &mut Dice, spans: usize, page: &mut String) {
    let axles = if dice.often(0.5) { dice.count(1, 2) } else { dice.count(3, 13) };
    let forces = quantities((0..axles).map(|_| dice.between(40.0, 250.0)), 0, "kN");
    let spacings = quantities((1..axles).map(|_| dice.between(1.1, 4.0)), 2, "m");
    let _ = writeln!(
        page,
        "[[load]]\nkind = \"axles\"\naxle_forces = [{forces}]\naxle_spacings = [{spacings}]\ncontact_length = \"0.30 m\"\n\
         effective_width = \"3.0 m\"\nat = \"{}/20 of span {}\"\n",
        dice.count(5, 10),
        dice.count(1, spans)
    );
}
