//! Regions against areas by hand, every corner shared, every force there.

use super::*;
use crate::discretise::discretise;
use crate::samples::{self, Dice};
use bridge::ring::Profile;
use bridge::{Backing, BackingBody, Confinement, FillEnds, LayerKind, LoadKind, Method, Ring, Span};
use mechanics::blocks::PointForce;
use mechanics::limit::continuum::{Bears, Side};

/// A layer of sand, or of what else.
fn soil(thickness: f64, density: f64, friction: f64, cohesion: f64) -> Layer {
    Layer {
        continuum: true,
        friction_angle: Some(friction.to_radians()),
        cohesion: Some(cohesion),
        ..samples::fill(thickness, density)
    }
}

fn plan() -> ContinuumPlan {
    ContinuumPlan {
        mobilised_share: 1.0,
        dilatancy_angle: 0.0,
        interface_friction_angle: None,
        interface_cohesion: 0.0,
        ends: FillEnds::Slide,
        extent: None,
        water_level: None,
        confinement: Confinement::PlaneStrain,
        bound_ratio: 1.05,
        elements: 4000,
    }
}

fn filled(mut b: Bridge, layers: Vec<Layer>) -> Bridge {
    b.plan.method = Method::Limit;
    b.cover.depth = layers.iter().map(|layer| layer.thickness).sum();
    b.cover.layers = layers;
    b.continuum = Some(plan());
    b
}

fn backing(height: f64) -> Backing {
    Backing {
        body: BackingBody::Continuum,
        friction_angle: Some(40f64.to_radians()),
        cohesion: Some(50e3),
        compressive_strength: Some(2e6),
        ..samples::backing(height)
    }
}

/// A haunch as deep as there is.
fn semicircle() -> Bridge {
    let mut b = filled(samples::semicircle(6.0, 0.45, 31), vec![soil(0.4, 1900.0, 30.0, 5e3)]);
    b.loads = samples::bridgemill().loads;
    b.loads[0].position = 1.5;
    b
}

/// Two unlike spans with a valley over a pier.
fn two_spans() -> Bridge {
    let b = semicircle();
    let mut spans = vec![b.spans[0].clone(), b.spans[0].clone()];
    (spans[1].span, spans[1].rise, spans[1].rings[0].voussoirs) = (5.0, 2.5, 27);
    Bridge { piers: samples::spans(spans.clone(), 1.4, 1.4, 3.0, 4).piers, spans, ..b }
}

/// The example, with its fill as a continuum.
fn bridgemill() -> Bridge {
    let text = include_str!("../../../../../examples/bridgemill/case-2.toml");
    let strength = "as = \"continuum\"\nfriction_angle = \"32 deg\"\ncohesion = \"5 kPa\"";
    let text = text.replacen("weighs = true", strength, 1);
    let text = text.replacen("method = \"dem\"", "method = \"limit\"", 1);
    let read = bridge::read(text.as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

fn area(outline: &[Vec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a.cross(*b)).sum::<f64>()
}

fn length(side: &Side) -> f64 {
    (side.ends[1] - side.ends[0]).norm()
}

/// The space between the extrados and the top, column by column [m^2]; for an extrados without steps.
fn space(b: &Bridge, d: &Discretised, e: &Earth) -> f64 {
    let (first, last) = (d.extrados.stretches[0], d.extrados.stretches[d.extrados.stretches.len() - 1]);
    let columns = d.extrados.stretches.iter().map(|s| {
        let (left, right) = (s.left.x.max(e.ends[0]), s.right.x.min(e.ends[1]));
        (right - left).max(0.0) * (e.top - 0.5 * (s.at(left).y + s.at(right).y))
    });
    let ground = springings(b, d).unwrap().map(|p| e.top - p.y);
    let beside = [(first.left.x - e.ends[0]).max(0.0), (e.ends[1] - last.right.x).max(0.0)];
    columns.sum::<f64>() + ground[0] * beside[0] + ground[1] * beside[1]
}

/// Regions are counter-clockwise, and each of their sides is one side of the boundary or one of another region, corner by corner.
fn conforms(continuum: &Continuum, free: usize) {
    let key = |p: Vec2| (p.x.to_bits(), p.y.to_bits());
    let mut edges = std::collections::BTreeMap::new();
    for region in &continuum.regions {
        assert!(area(&region.outline) > 0.0, "{:?}", region.outline);
        for (k, &a) in region.outline.iter().enumerate() {
            let b = region.outline[(k + 1) % region.outline.len()];
            assert!((b - a).norm() > 0.5 * SNAP, "{a:?} {b:?}");
            assert!(edges.insert((key(a), key(b)), 0).is_none(), "{a:?} {b:?} twice");
        }
    }
    for side in &continuum.sides {
        let [a, b] = side.ends.map(key);
        let found = edges.get_mut(&(a, b)).unwrap_or_else(|| panic!("{side:?} is no side of a region"));
        *found += 1;
    }
    let uses = |&(a, b): &_| edges[&(a, b)] + u32::from(edges.contains_key(&(b, a)));
    let bare = edges.keys().filter(|edge| uses(edge) == 0).count();
    assert!(edges.keys().all(|edge| uses(edge) <= 1));
    assert_eq!(bare, free, "sides without anything");
}

fn made(b: &Bridge) -> (Discretised, Earth, LoadedEarth) {
    let d = discretise(b).unwrap();
    let e = earth(b, &d).unwrap().unwrap();
    let loaded = e.loaded(&d, Strength::of(&e.plan), &loads(b)).unwrap();
    (d, e, loaded)
}

/// Sum of downward forces [N/m].
fn down(forces: &[PointForce]) -> f64 {
    forces.iter().map(|f| -f.force.y).sum()
}

/// Area, weight and load of a bridge without steps in its extrados.
fn check(b: &Bridge) -> (Earth, Continuum) {
    let (d, e, loaded) = made(b);
    let c = loaded.continuum;
    conforms(&c, 0);
    let sum: f64 = c.regions.iter().map(|region| area(&region.outline)).sum();
    let exact = space(b, &d, &e);
    assert!((sum / exact - 1.0).abs() < 1e-9, "{sum} {exact}");
    let top: Vec<&Side> = c.sides.iter().filter(|side| matches!(side.bears, Bears::Load { .. })).collect();
    let mut permanent = down(&loaded.loading.permanent);
    for side in &top {
        assert!(side.ends.iter().all(|p| p.y == e.top) && side.ends[0].x > side.ends[1].x, "{side:?}");
        if let Bears::Load { permanent: p, variable: v } = side.bears {
            permanent -= p.y * length(side);
            assert_eq!(v, Vec2::ZERO);
        }
    }
    assert!((permanent - e.surcharge * (e.ends[1] - e.ends[0])).abs() < 1e-6);
    let force: f64 = loads(b).iter().map(|strip| strip.force).sum();
    let variable = down(&loaded.loading.variable);
    assert!((variable - force).abs() < 1e-9 * force, "{variable} {force}");
    (e, c)
}

#[test]
fn the_fill_of_bridgemill_is_one_region_as_heavy_as_its_weight() {
    let b = bridgemill();
    let (e, c) = check(&b);
    assert_eq!((e.pieces.len(), e.materials.len(), e.surcharge), (1, 1, 0.0));
    // Its weight on the ring is that of columns; the rest stands on abutments and ground.
    let d = discretise(&b).unwrap();
    let weight: f64 = c.regions.iter().map(|r| -r.soil.weight.y * area(&r.outline)).sum();
    let columns: f64 = d.loading.permanent.iter().map(|f| -f.force.y).sum();
    let springings = springings(&b, &d).unwrap();
    let beside: f64 = [0, 1].iter().map(|&k| (e.ends[k] - springings[k].x).abs() * (e.top - springings[k].y)).sum();
    let unit = 1890.0 * 9.81;
    assert!((weight / (columns + unit * beside) - 1.0).abs() < 1e-9, "{weight} {columns}");
    // Twice the height behind each springing, which is more than the abutment's top.
    assert!((springings[0].x - e.ends[0] - 2.0 * (e.top - springings[0].y)).abs() < 1e-9);
    // One plate carries the load, and nothing else acts on blocks.
    let (_, _, loaded) = made(&b);
    assert_eq!(loaded.model.blocks.len(), d.model.blocks.len() + 1);
    assert!(loaded.loading.permanent.is_empty() && loaded.loading.restraints.is_empty());
    // Every back of the ring is a side, and both abutments.
    let blocks: std::collections::BTreeSet<_> = e
        .edges
        .iter()
        .filter_map(|edge| match edge.against {
            Against::Block(block) => Some(block),
            Against::Ground | Against::End => None,
        })
        .collect();
    assert_eq!(blocks.len(), 64);
    assert_eq!(e.edges.iter().filter(|edge| edge.against == Against::Ground).count(), 2);
}

#[test]
fn a_valley_over_a_pier_and_layers_of_soil() {
    let mut b = two_spans();
    let surfacing = Layer { name: LayerKind::Surfacing, ..samples::fill(0.1, 2300.0) };
    b.cover.layers = vec![soil(0.3, 1900.0, 30.0, 5e3), soil(0.2, 2000.0, 35.0, 0.0), surfacing];
    b.cover.depth = 0.6;
    let (e, _) = check(&b);
    assert_eq!((e.pieces.len(), e.materials.len()), (2, 2));
    assert!((e.surcharge - 0.1 * 2300.0 * 9.81).abs() < 1e-9);
    // Layers of one soil are one.
    b.cover.layers[1] = soil(0.2, 1900.0, 30.0, 5e3);
    let (e, _) = check(&b);
    assert_eq!((e.pieces.len(), e.materials.len()), (1, 1));
    // Only the pier carries what stands on its top.
    let d = discretise(&b).unwrap();
    let on_pier = |edge: &&Edge| match edge.against {
        Against::Block(block) => matches!(d.origins[block], Origin::Pier { .. }),
        Against::Ground | Against::End => false,
    };
    assert_eq!(e.edges.iter().filter(on_pier).count(), 1);
}

#[test]
fn backing_fills_the_haunches_between_the_ends_of_the_abutments() {
    let mut b = semicircle();
    b.cover.backing = Some(backing(1.5));
    let (e, c) = check(&b);
    // Two haunches, behind each abutment soil, and soil above all.
    assert_eq!(e.pieces.len(), 5);
    let solid: Vec<&Piece> = e.pieces.iter().filter(|piece| e.materials[piece.material].bonded).collect();
    assert_eq!(solid.len(), 2);
    for piece in solid {
        let [from, to] = [piece.outline[0].x, piece.outline[piece.outline.len() - 1].x];
        assert!((from + 2.45).abs() < 1e-9 || (to - 8.45).abs() < 1e-9, "{from} {to}");
        assert!(piece.outline.iter().all(|p| p.y <= 1.5));
    }
    assert_eq!(c.regions.iter().filter(|region| region.soil.crushing == 2e6).count(), 2);
    // As high as the top, it takes the whole depth over the ring.
    b.cover.backing = Some(backing(4.0));
    let (e, _) = check(&b);
    assert_eq!(e.pieces.iter().filter(|piece| e.materials[piece.material].bonded).count(), 1);
    assert_eq!(e.pieces.len(), 3);
    // Fill that ends over the abutment holds backing alone at its ends.
    b.cover.backing = Some(backing(1.5));
    b.continuum = Some(ContinuumPlan { extent: Some(1.0), ..plan() });
    let (e, _) = check(&b);
    assert_eq!(e.pieces.len(), 3);
}

#[test]
fn water_cuts_regions_at_its_level() {
    let mut b = semicircle();
    b.cover.backing = Some(backing(1.5));
    for (level, pieces) in [(0.7, 9), (2.2, 7), (1.5004, 5), (-0.5, 5), (9.0, 5)] {
        b.continuum = Some(ContinuumPlan { water_level: Some(level), ..plan() });
        let (e, c) = check(&b);
        assert_eq!(e.pieces.len(), pieces, "{level}");
        let Some(water) = c.water else {
            assert!(level < 0.0);
            continue;
        };
        // Wet from end to end, or dry: the pressure is linear.
        for region in &c.regions {
            let above = region.outline.iter().any(|p| p.y > water.level + GAP);
            let below = region.outline.iter().any(|p| p.y < water.level - GAP);
            assert!(!(above && below), "{level}: {:?}", region.outline);
        }
        assert!(water.level <= e.top && water.unit_weight == 9810.0);
    }
}

#[test]
fn backing_of_blocks_stands_below_a_continuum() {
    let mut b = semicircle();
    b.cover.backing = Some(Backing { body: BackingBody::Blocks, ..samples::backing(1.5) });
    let (d, e, loaded) = made(&b);
    let c = loaded.continuum;
    conforms(&c, 0);
    assert_eq!(e.pieces.len(), 1);
    let sum: f64 = c.regions.iter().map(|region| area(&region.outline)).sum();
    // Below the surface the area of blocks is missing.
    let mut bare = b.clone();
    bare.cover.backing = None;
    let (bare, earth, whole) = made(&bare);
    let whole = whole.continuum;
    let whole: f64 = whole.regions.iter().map(|region| area(&region.outline)).sum();
    assert!((whole - space(&b, &bare, &earth)).abs() < 1e-9);
    let blocks = d.origins.pairs().filter(|(_, origin)| matches!(origin, Origin::Backing { .. }));
    let solid: f64 = blocks.map(|(block, _)| d.model.blocks[block].outline.area()).sum();
    assert!((sum + solid - whole).abs() < 1e-6, "{sum} {solid} {whole}");
    // Soil presses on the plumb ends of the stones.
    for face in &d.extrados.faces {
        let here = |edge: &&Edge| {
            edge.against == Against::Block(face.block) && edge.ends.iter().all(|p| (p.x - face.x).abs() < NEAR)
        };
        let height: f64 = e.edges.iter().filter(here).map(|edge| (edge.ends[0].y - edge.ends[1].y).abs()).sum();
        assert!((height - (face.levels[1] - face.levels[0])).abs() < 1e-9, "{face:?} {height}");
    }
}

#[test]
fn the_ends_slide_hold_or_are_free() {
    for (ends, free, rough) in [(FillEnds::Slide, 0, 0), (FillEnds::Hold, 0, 2), (FillEnds::Free, 2, 0)] {
        let mut b = bridgemill();
        b.continuum = Some(ContinuumPlan { ends, ..plan() });
        let (_, e, loaded) = made(&b);
        let c = loaded.continuum;
        conforms(&c, free);
        let at_end = |side: &&Side| e.ends.iter().any(|x| side.ends.iter().all(|p| p.x == *x));
        let friction = |side: &Side| match side.bears {
            Bears::Body { block, contact } => {
                assert_eq!(block, None);
                contact.friction
            }
            Bears::Load { .. } => panic!("{side:?}"),
        };
        let found: Vec<f64> = c.sides.iter().filter(at_end).map(friction).collect();
        assert_eq!((found.len(), found.iter().filter(|f| **f > 0.0).count()), (2 - free, rough));
    }
}

#[test]
fn strength_is_reduced_and_the_interface_with_it() {
    let mut b = semicircle();
    b.cover.backing = Some(backing(1.5));
    b.continuum = Some(ContinuumPlan { interface_cohesion: 2e3, ..plan() });
    let d = discretise(&b).unwrap();
    let e = earth(&b, &d).unwrap().unwrap();
    let strength = Strength { share: 0.5, dilatancy: 0.0 };
    let c = e.loaded(&d, strength, &[]).unwrap().continuum;
    // By hand: half of tan(30 deg), times the cosine of the angle that is left.
    let mobilised = (0.5 * 30f64.to_radians().tan()).atan();
    let factor = 0.5 * mobilised.cos();
    let fill = c.regions.iter().find(|region| region.soil.crushing.is_infinite()).unwrap().soil;
    assert!((fill.friction_angle.tan() - factor * 30f64.to_radians().tan()).abs() < 1e-12);
    assert!((fill.cohesion - factor * 5e3).abs() < 1e-9);
    let ring = |material: usize| {
        let edge = e.edges.iter().find(|edge| {
            matches!(edge.against, Against::Block(_)) && e.materials[edge.material].bonded == (material == 1)
        });
        e.contact(edge.unwrap().material, strength)
    };
    let interface = ring(0);
    assert!((interface.friction - factor * 20f64.to_radians().tan()).abs() < 1e-12, "two thirds of 30 deg");
    assert!((interface.cohesion - factor * 2e3).abs() < 1e-9 && interface.tension == 0.0);
    let solid = c.regions.iter().find(|region| region.soil.crushing == 2e6).unwrap().soil;
    let bond = ring(1);
    assert!((bond.friction - solid.friction_angle.tan()).abs() < 1e-12 && bond.cohesion == solid.cohesion);
    // Full strength where it dilates by its friction angle.
    let whole = e.loaded(&d, Strength { share: 1.0, dilatancy: 30f64.to_radians() }, &[]).unwrap().continuum;
    assert!(whole.regions.iter().any(|region| (region.soil.friction_angle.to_degrees() - 30.0).abs() < 1e-9));
}

#[test]
fn strips_add_up_and_what_stands_beside_the_fill_is_counted() {
    let b = semicircle();
    let (d, e, _) = made(&b);
    let strip =
        |middle: f64, length: f64, force: f64| Strip { middle, length, force, horizontal: 0.0, is_pressure: false };
    let strength = Strength::of(&e.plan);
    let force = |loaded: &LoadedEarth| down(&loaded.loading.variable);
    let over = [strip(1.0, 0.5, 10e3), strip(1.2, 0.5, 20e3), strip(1.45 + 3e-4, 0.5, 30e3)];
    let loaded = e.loaded(&d, strength, &over).unwrap();
    conforms(&loaded.continuum, 0);
    assert!((force(&loaded) - 60e3).abs() < 1e-6 && loaded.left_out == 0.0);
    // Strips that meet share a plate, and the resultant stays in its place.
    let [plate] = loaded.loading.variable[..] else { panic!("{:?}", loaded.loading.variable) };
    let at = (10.0 * 1.0 + 20.0 * 1.2 + 30.0 * (1.45 + 3e-4)) / 60.0;
    assert!((plate.at.x - at).abs() < 1e-9, "{}", plate.at.x);
    let beside = [strip(e.ends[1], 1.0, 10e3), strip(e.ends[0] - 3.0, 1.0, 10e3)];
    let loaded = e.loaded(&d, strength, &beside).unwrap();
    conforms(&loaded.continuum, 0);
    assert!((force(&loaded) - 5e3).abs() < 1e-6, "{}", force(&loaded));
    assert!((loaded.left_out - 0.75).abs() < 1e-9, "{}", loaded.left_out);
    let line = e.loaded(&d, strength, &[strip(1.0, 0.0, 10e3)]);
    let words = line.unwrap_err().to_string();
    assert!(words.contains("give contact_length"), "{words}");
}

#[test]
fn there_is_no_continuum_without_one() {
    let mut b = bridgemill();
    let d = discretise(&b).unwrap();
    assert!(earth(&samples::case_two(), &d).unwrap().is_none());
    b.cover.layers[0].thickness = 0.0;
    let d = discretise(&b).unwrap();
    assert_eq!(earth(&b, &d), Err(DiscretiseError::ContinuumWithoutDepth { depth: 0.0 }));
}

/// In a method that knows no continuum, fill and backing weigh as if they were weight alone.
#[test]
fn other_methods_take_a_continuum_as_weight() {
    let mut b = semicircle();
    b.cover.backing = Some(backing(1.5));
    let mut weight = b.clone();
    weight.cover.layers = vec![samples::fill(0.4, 1900.0)];
    weight.cover.backing = Some(samples::backing(1.5));
    assert_eq!(discretise(&b).unwrap().loading, discretise(&weight).unwrap().loading);
}

/// Levels wherever they may fall, near corners most of all, on every profile.
#[test]
fn regions_conform_wherever_levels_fall() {
    let mut dice = Dice(7);
    let profiles = [
        (Profile::Segmental, 1.2),
        (Profile::Semicircular, 3.0),
        (Profile::Elliptical, 2.0),
        (Profile::Parabolic, 1.5),
        (Profile::Pointed, 3.6),
    ];
    let mut rounds = 0;
    for round in 0..400 {
        let (profile, rise) = dice.choose(&profiles);
        let crown_thickness = dice.between(0.3, 0.6);
        let springing_thickness = dice.choose(&[crown_thickness, 0.5, 0.7]);
        let voussoirs = dice.choose(&[13, 30, 31, 62]);
        let ring = Ring { crown_thickness, springing_thickness, voussoirs };
        let span =
            Span { profile, span: 6.0, rise, rings: vec![ring], defects: Vec::new(), skew: 0.0, right_springing: 0.0 };
        let count = dice.choose(&[1, 2, 3]);
        let layers =
            vec![soil(dice.between(0.02, 0.5), 1900.0, 30.0, 5e3), soil(dice.between(0.0, 0.3), 1900.0, 33.0, 0.0)];
        let mut b = filled(samples::spans(vec![span; count], 2.0, 2.0, 3.0, 4), layers);
        b.masonry.rounding = 0.0;
        b.abutments[0].top_width = dice.choose(&[0.0, 1.0, 2.0]);
        b.loads[0].kind = LoadKind::KnifeEdge { force: 1e3, length: dice.between(0.02, 1.0) };
        b.loads[0].position = dice.between(0.0, 6.0);
        let Ok(d) = discretise(&b) else { continue };
        // A level of some corner, more or less; or any.
        let corners: Vec<f64> = d.extrados.stretches.iter().flat_map(|s| [s.left.y, s.right.y]).collect();
        let mut level = || match dice.choose(&[true, false]) {
            true => dice.choose(&corners) + dice.choose(&[0.0, 1e-12, 5e-4, -9e-4, 1.1e-3, -3e-3]),
            false => dice.between(-0.2, 4.0),
        };
        let (height, water) = (level(), level());
        let extent = dice.choose(&[None, Some(0.5), Some(1.0), Some(1.0004), Some(4.0)]);
        b.continuum = Some(ContinuumPlan { extent, water_level: Some(water), ..plan() });
        let body = dice.choose(&[None, Some(BackingBody::Continuum), Some(BackingBody::Blocks)]);
        b.cover.backing = body.map(|body| Backing { body, ..backing(height.max(0.05)) });
        if discretise(&b).is_err() {
            continue;
        }
        rounds += 1;
        let (_, e, loaded) = made(&b);
        let c = loaded.continuum;
        conforms(&c, 0);
        // Springings that are thicker than the ring above them leave steps, and so do blocks: the floor is not that of columns.
        let sum: f64 = c.regions.iter().map(|region| area(&region.outline)).sum();
        let exact = space(&b, &d, &e);
        let near = if crown_thickness == springing_thickness { 1e-9 } else { 1e-2 };
        if body == Some(BackingBody::Blocks) {
            assert!(sum < exact * (1.0 + near), "round {round}: {sum} {exact}");
        } else {
            assert!((sum / exact - 1.0).abs() < near, "round {round}: {sum} {exact}");
        }
        for piece in &e.pieces {
            let (low, high) =
                piece.outline.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.y), h.max(p.y)));
            assert!(high - low > 0.9 * SNAP, "round {round}: {:?}", piece.outline);
        }
    }
    assert!(rounds > 300, "{rounds}");
}

#[test]
fn walls_hold_what_their_weight_resists() {
    let mut b = filled(samples::semicircle(6.0, 0.45, 31), vec![soil(0.4, 1900.0, 30.0, 5e3)]);
    let wall = bridge::SpandrelWall { thickness: 0.9, density: 2200.0, top: Some(1.4), ..samples::spandrel_wall(&b) };
    let plan = ContinuumPlan { confinement: Confinement::SpandrelWalls, ..plan() };
    (b.spandrel_wall, b.continuum) = (Some(wall), Some(plan));
    let (d, e, loaded) = made(&b);
    // By hand, a metre from the crown: each wall is 0.45 m thick, and 1.4 m high at the crown of the circle on which it stands.
    let weight = 2200.0 * b.gravity * 0.45 * (1.4 + 1.0 / (6.0 * 3.45));
    let crown = e.panels.iter().find(|panel| panel.ends[0] <= 3.0 && 3.0 < panel.ends[1]).unwrap();
    let length = crown.ends[1] - crown.ends[0];
    let near = |value: f64, exact: f64| (value / (exact * length) - 1.0).abs() < 0.01;
    assert!(
        near(crown.force, b.joint.friction_angle.tan() * weight) && near(crown.moment, weight * 0.225),
        "{crown:?}"
    );
    assert!(crown.foot < d.extrados.crown() && crown.foot > d.extrados.crown() - 0.2);
    // They stand side by side from end to end, on nothing that is above the soil beside them, and the same on both sides.
    assert_eq!([e.panels[0].ends[0], e.panels[e.panels.len() - 1].ends[1]], e.ends);
    assert!(e.panels.windows(2).all(|pair| pair[0].ends[1] == pair[1].ends[0]));
    for (left, right) in e.panels.iter().zip(e.panels.iter().rev()) {
        assert!((left.moment / right.moment - 1.0).abs() < 1e-6 && (left.foot - right.foot).abs() < 1e-6);
    }
    let soil = loaded.continuum;
    for point in soil.regions.iter().flat_map(|region| &region.outline) {
        let beside = e.panels.iter().filter(|panel| panel.ends[0] <= point.x && point.x <= panel.ends[1]);
        assert!(beside.clone().all(|panel| panel.foot <= point.y + 1e-9) && beside.count() > 0, "{point:?}");
    }
    assert_eq!(soil.panels, e.panels);
    // Where plane strain holds the fill, nothing bounds it.
    b.continuum = Some(self::plan());
    assert!(made(&b).2.continuum.panels.is_empty());
}

#[test]
fn a_pressure_follows_the_ground_and_presses_on_plates() {
    let mut b = filled(samples::semicircle(6.0, 0.45, 31), vec![soil(0.4, 1900.0, 30.0, 5e3)]);
    b.loads = samples::bridgemill().loads;
    let (d, e, _) = made(&b);
    let strip = |from: f64, to: f64, force: f64, is_pressure: bool| Strip {
        horizontal: 0.0,
        middle: 0.5 * (from + to),
        length: to - from,
        force,
        is_pressure,
    };
    // 2 kPa over 4 m, 3 kPa over a part of it, and a wheel of 0.5 m on both.
    let strips = [strip(1.0, 5.0, 8e3, true), strip(2.0, 4.0, 6e3, true), strip(3.75, 4.25, 50e3, false)];
    let loaded = e.loaded(&d, Strength::of(&e.plan), &strips).unwrap();
    let pressed = loaded.continuum.sides.iter().filter_map(|side| match side.bears {
        Bears::Load { variable, .. } if variable.y != 0.0 => {
            Some(((side.ends[1].x - side.ends[0].x).abs(), -variable.y))
        }
        _ => None,
    });
    let pressed: Vec<(f64, f64)> = pressed.collect();
    let sum = |pressure: f64| pressed.iter().filter(|p| (p.1 - pressure).abs() < 1e-6).map(|p| p.0).sum::<f64>();
    assert!((sum(2e3) - 1.75).abs() < 1e-9 && (sum(5e3) - 1.75).abs() < 1e-9, "{pressed:?}");
    // The wheel bears what lies on it: 50 kN, and 0.25 m of 5 and of 2 kPa.
    let wheel = &loaded.loading.variable[0];
    assert_eq!(loaded.loading.variable.len(), 1);
    assert!((wheel.force.y + 50e3 + 0.25 * 5e3 + 0.25 * 2e3).abs() < 1e-6, "{wheel:?}");
    let moment = 50e3 * 4.0 + 0.25 * 5e3 * 3.875 + 0.25 * 2e3 * 4.125;
    assert!((wheel.at.x - moment / -wheel.force.y).abs() < 1e-9);
}
