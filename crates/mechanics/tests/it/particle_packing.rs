//! The packings are as dense and as pressed as asked for, the same for the same seed, and refused by name where they cannot be.

use crate::particle_support::{DENSITY, fill, room, stone, wall, world};
use mechanics::blocks::{Block, Held};
use mechanics::dem::{Packing, PackingError, Recipe, Target, pack};
use mechanics::ids::GroupId;
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Unwatched;

fn recipe(count: usize, target: Target) -> Recipe {
    Recipe { count, size_ratio: 1.5, target, seed: 1, density: DENSITY, group: GroupId(1) }
}

fn square(side: f64) -> Vec<Vec2> {
    vec![vec2(0.0, 0.0), vec2(side, 0.0), vec2(side, side), vec2(0.0, side)]
}

fn in_box(side: f64, recipe: &Recipe) -> Result<Packing, PackingError> {
    pack(&world(fill(0.5), Vec2::ZERO, room(side, side), &[]), &square(side), recipe, &mut Unwatched)
}

/// Share of the particles' area in the region's square, and the deepest that one stands out over a wall, over its radius.
fn covered(packing: &Packing, side: f64) -> (f64, f64) {
    let area: f64 = packing.grains.iter().map(|g| std::f64::consts::PI * g.radius * g.radius).sum();
    let out = |g: &mechanics::dem::Grain| {
        let (x, y) = (g.centre.x, g.centre.y);
        (g.radius - x.min(y).min(side - x).min(side - y)) / g.radius
    };
    (area / (side * side), packing.grains.iter().map(out).fold(0.0, f64::max))
}

/// A stress of 100 kPa is 15 kN/m on a contact, which 80 MN/m carry by 0.2 mm; chains of force carry some times the mean. No
/// particle stands out of the box by more than a hundredth of its radius.
#[test]
fn a_packing_meets_its_stress() {
    for stress in [2e4, 1e5, 1e6] {
        let packing = in_box(3.0, &recipe(300, Target::Stress(stress))).unwrap();
        let (share, out) = covered(&packing, 3.0);
        // The generator's own promise: twice a twentieth.
        assert!((packing.packed.mean_stress / stress - 1.0).abs() <= 0.1, "{:?}", packing.packed);
        assert!((packing.packed.solid_fraction - share).abs() < 1e-9);
        let deepest = 10.0 * stress * 0.15 / crate::particle_support::NORMAL / 0.075;
        assert!(out < deepest.max(0.01), "{out:e}");
        let ratio = |pick: fn(f64, f64) -> f64| packing.grains.iter().map(|g| g.radius).reduce(pick).unwrap();
        assert!(ratio(f64::max) / ratio(f64::min) <= 1.5 + 1e-12);
    }
}

/// Share of the inner square, `margin` [m] from the walls, that discs cover, by a grid of points.
fn covered_inside(packing: &Packing, side: f64, margin: f64) -> f64 {
    const POINTS: usize = 200;
    let place = |k: usize| margin + (side - 2.0 * margin) * (k as f64 + 0.5) / POINTS as f64;
    let points = (0..POINTS).flat_map(|i| (0..POINTS).map(move |j| vec2(place(i), place(j))));
    let within = |p: Vec2| packing.grains.iter().any(|g| (g.centre - p).dot(g.centre - p) < g.radius * g.radius);
    points.filter(|p| within(*p)).count() as f64 / (POINTS * POINTS) as f64
}

/// Discs without friction jam where contacts and freedoms are as many: four contacts a disc that carries at least two
/// (2 N contacts for 2 N motions; rotations carry nothing without friction). At 20 kPa, hardly pressed, a little above four. Random
/// packings of discs of sizes like these jam at a solid fraction of 0.84 (O'Hern and others 2003 for two sizes, 0.84);
/// the walls, along which there is more room, are left out.
#[test]
fn frictionless_discs_jam_as_counting_says() {
    let packing = in_box(4.4, &recipe(600, Target::Stress(2e4))).unwrap();
    let p = packing.packed;
    // Contacts with walls count once and not twice: about one for each diameter of 0.15 m along them.
    let carrying = (p.coordination + 4.0 * 4.4 / 0.15 / 600.0) / (1.0 - p.rattlers);
    let inside = covered_inside(&packing, 4.4, 0.4);
    assert!((carrying - 4.0).abs() < 0.25, "{p:?} {carrying}");
    assert!((inside - 0.84).abs() < 0.01, "{p:?} {inside}");
}

#[test]
fn a_packing_meets_its_solid_fraction() {
    for fraction in [0.5, 0.8, 0.86] {
        let packing = in_box(3.0, &recipe(300, Target::SolidFraction(fraction))).unwrap();
        let (share, out) = covered(&packing, 3.0);
        let deepest = 10.0 * packing.packed.mean_stress * 0.15 / crate::particle_support::NORMAL / 0.075;
        assert!((share - fraction).abs() < 1e-9 && out < deepest.max(0.01), "{fraction}: {share} {out}");
    }
}

#[test]
fn a_seed_makes_a_packing() {
    let of_seed = |seed| in_box(2.0, &Recipe { seed, ..recipe(120, Target::Stress(1e5)) }).unwrap();
    let (one, again, other) = (of_seed(7), of_seed(7), of_seed(8));
    assert_eq!(format!("{one:?}"), format!("{again:?}"));
    assert_ne!(one.grains, other.grains);
    assert!((one.packed.solid_fraction - other.packed.solid_fraction).abs() < 0.02);
}

/// A corner as behind an arch: nothing is left outside, neither beyond the walls nor in the notch.
#[test]
fn a_concave_region_is_filled() {
    let region =
        [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (1.5, 2.0), (1.5, 1.0), (0.0, 1.0)].map(|(x, y)| vec2(x, y)).to_vec();
    let mut walls: Vec<Block> = room(3.0, 2.0);
    walls.push(stone(&[(-0.3, 1.0), (1.5, 1.0), (1.5, 2.0), (-0.3, 2.0)], 0.0, Held::FIXED));
    walls.retain(|w| w.outline.vertices()[0] != vec2(-0.3, 0.0));
    walls.push(wall(vec2(-0.3, 0.0), 0.3, 0.99));
    let world = world(fill(0.5), Vec2::ZERO, walls, &[]);
    let packing = pack(&world, &region, &recipe(250, Target::Stress(1e5)), &mut Unwatched).unwrap();
    for g in &packing.grains {
        let r = 0.97 * g.radius;
        let inside = g.centre.x > r && g.centre.x < 3.0 - r && g.centre.y > r && g.centre.y < 2.0 - r;
        let corner = g.centre - vec2(1.5, 1.0);
        let notch = if corner.x < 0.0 {
            -corner.y
        } else if corner.y > 0.0 {
            corner.x
        } else {
            corner.norm()
        };
        assert!(inside && notch > r, "{g:?}");
    }
    assert!(packing.packed.solid_fraction > 0.8, "{:?}", packing.packed);
}

/// Every absurd wish ends, by name or with a packing.
#[test]
fn absurd_recipes_are_answered() {
    let stress = Target::Stress(1e5);
    let named = |what: &'static str, r: &Recipe| match in_box(1.0, r) {
        Err(PackingError::Recipe { what: found, .. }) => assert_eq!(found, what),
        other => panic!("{what}: {other:?}"),
    };
    named("number of particles", &recipe(0, stress));
    named("number of particles", &recipe(2, stress));
    named("size ratio", &Recipe { size_ratio: 0.5, ..recipe(30, stress) });
    named("size ratio", &Recipe { size_ratio: f64::NAN, ..recipe(30, stress) });
    named("density", &Recipe { density: 0.0, ..recipe(30, stress) });
    for bad in [0.0, 0.99, f64::NAN] {
        named("solid fraction", &recipe(30, Target::SolidFraction(bad)));
    }
    for bad in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        named("stress", &recipe(30, Target::Stress(bad)));
    }
    for region in [vec![], vec![vec2(0.0, 0.0), vec2(1.0, 0.0)], vec![vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(2.0, 0.0)]] {
        let walls = world(fill(0.5), Vec2::ZERO, room(1.0, 1.0), &[]);
        assert_eq!(pack(&walls, &region, &recipe(30, stress), &mut Unwatched), Err(PackingError::NoRoom(30)));
    }
    let end = |what: &str, found: Result<Packing, PackingError>| {
        if let Ok(p) = &found {
            assert!(p.grains.iter().all(|g| g.centre.is_finite() && g.radius > 0.0), "{what}");
        }
        found
    };
    let _ = end("three", in_box(1.0, &recipe(3, stress)));
    let _ = end("a hundred to one", in_box(1.0, &Recipe { size_ratio: 100.0, ..recipe(30, stress) }));
    let _ = end("1 Pa", in_box(1.0, &recipe(30, Target::Stress(1.0))));
    assert!(end("1 GPa", in_box(1.0, &recipe(30, Target::Stress(1e9)))).is_err());
    let _ = end("0.94", in_box(1.0, &recipe(30, Target::SolidFraction(0.94))));
    // A slit: one row of particles as large as it is wide.
    let slit = [vec2(0.0, 0.0), vec2(10.0, 0.0), vec2(10.0, 0.01), vec2(0.0, 0.01)];
    let walls = vec![wall(vec2(-0.3, -0.3), 10.6, 0.3), wall(vec2(-0.3, 0.01), 10.6, 0.3)];
    let walls = world(fill(0.5), Vec2::ZERO, walls, &[]);
    let _ = end("slit", pack(&walls, &slit, &recipe(10, stress), &mut Unwatched));
    // No walls at all: the particles push one another away.
    let floor = world(fill(0.5), Vec2::ZERO, vec![wall(vec2(-5.0, -0.3), 10.0, 0.3)], &[]);
    let found = end("no walls", pack(&floor, &square(1.0), &recipe(30, stress), &mut Unwatched));
    assert!(found.is_err(), "{found:?}");
}
