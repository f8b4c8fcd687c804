//! Good files give the bridges they describe, without a word.

use crate::files::{CALIBRATION, CASE_1, CASES, GOOD, SHAPES, TINY, VIADUCT, WALLS, show_all};
use bridge::ring::Profile;
use bridge::*;

fn good(text: &str) -> Bridge {
    read(text.as_bytes()).bridge.unwrap_or_else(|| panic!("{}", show_all(text)))
}

#[test]
fn good_files_read_without_findings() {
    for text in GOOD {
        assert_eq!(show_all(text), "");
    }
}

#[test]
fn bridgemill() {
    let bridge = good(CASE_1);
    assert_eq!(bridge.name, "Bridgemill");
    assert_eq!(bridge.width, 8.3);
    assert_eq!(bridge.spans.len(), 1);
    assert_eq!((bridge.spans[0].span, bridge.spans[0].rise), (18.3, 2.85));
    assert_eq!(bridge.spans[0].rings, [Ring { crown_thickness: 0.711, springing_thickness: 0.711, voussoirs: 62 }]);
    assert_eq!(bridge.piers, []);
    assert_eq!(bridge.masonry.rounding, 0.01);
    assert_eq!(bridge.joint.normal_stiffness, Some(JointStiffness::Contact(4.84e9)));
    assert_eq!(bridge.joint, bridge.ring_joint);
    assert!((bridge.joint.friction_angle - 35.6f64.to_radians()).abs() < 1e-15);
    assert!((bridge.cover.depth - 0.478).abs() < 1e-15);
    assert!(bridge.cover.layers.iter().all(|layer| !layer.weighs));
    assert_eq!(bridge.dispersal, Dispersal { rule: DispersalRule::InverseDepth, slope: 2.0 });
    assert_eq!(bridge.loads[0].kind, LoadKind::KnifeEdge { force: 1e3, length: 0.75 });
    assert!((bridge.loads[0].position - 4.575).abs() < 1e-15);
    assert_eq!(bridge.plan.method, Method::Dem);
    assert!((bridge.plan.load_step.unwrap() - 100e3 / 8.3).abs() < 1e-9);
    assert_eq!(bridge.plan.damping, Damping::Local(0.8));
}

#[test]
fn walls() {
    let bridge = good(WALLS);
    let wall = bridge.spandrel_wall.unwrap();
    assert_eq!((wall.brick_length, wall.brick_height, wall.thickness), (0.6, 0.4, 0.44));
    assert_eq!((wall.bond, wall.density, wall.rounding), (1.0 / 3.0, 2000.0, 0.005));
    assert_eq!((wall.top, wall.extent, wall.head_joint), (Some(0.478), Some(1.5), Some(4.575)));
    assert_eq!((wall.end_walls, wall.courses_from, wall.loaded_bricks), (true, CoursesFrom::Springings, Some(2)));
    assert_eq!((wall.least_piece, wall.joint.normal_stiffness), (0.2, Some(JointStiffness::Contact(4.7e9))));
    assert_eq!(bridge.plan.strip, Strip::Wall);
    assert_eq!(bridge.loads[0].block, Some(LoadingBlock { weight: 17.72e3 }));
    // A wall without joints of its own is joined as the ring is, but for lengths that belong to the ring's thickness.
    let start = WALLS.find("[wall_joint]").unwrap();
    let end = WALLS.find("[[load]]").unwrap();
    let bare = good(&format!("{}{}", &WALLS[..start], &WALLS[end..]));
    let joint = bare.spandrel_wall.unwrap().joint;
    assert_eq!(joint, Joint { fixed_length: None, ..bare.joint });
}

#[test]
fn the_strip_follows_what_the_file_describes() {
    let without = WALLS.replace("strip = \"wall\"", "").replace("through = \"block\"", "");
    let without = without.replace("block_weight = \"17.72 kN/m\"", "");
    assert_eq!(good(&without).plan.strip, Strip::Fill, "walls add strength only where somebody asks for it");
    assert_eq!(good(&without.replace("\"load\"", "\"thickness\"")).plan.strip, Strip::Fill);
    assert_eq!(good(CASE_1).plan.strip, Strip::Fill);
}

#[test]
fn viaduct() {
    let bridge = good(VIADUCT);
    assert_eq!(bridge.spans.iter().map(|span| span.rings.len()).collect::<Vec<_>>(), [2, 2, 1]);
    assert_eq!(bridge.piers.iter().map(|pier| pier.base_width).collect::<Vec<_>>(), [0.9, 0.85]);
    assert_eq!(
        bridge.abutments,
        [Abutment { top_width: 1.0, height: 1.2, body: None }, Abutment { top_width: 1.1, height: 1.3, body: None }]
    );
    assert_eq!(bridge.masonry.compressive_strength, None);
    assert_eq!(bridge.joint.normal_stiffness, Some(JointStiffness::Series(20e9)));
    assert_eq!(bridge.ring_joint.normal_stiffness, Some(JointStiffness::Contact(10e9)));
    // 3.0 + 0.8 + half of 3.0.
    assert!((bridge.loads[0].position - 5.3).abs() < 1e-12);
    let LoadKind::Axles { axles, .. } = &bridge.loads[0].kind else { panic!() };
    assert_eq!(axles, &[(75e3, 0.0), (115e3, 1.8)]);
    let movement = bridge.plan.support_movement.unwrap();
    assert_eq!((movement.support, movement.horizontal, movement.vertical), (1, 1.0, -0.5));
    assert_eq!(bridge.plan.contact_points, ContactPoints::FullRing);
    assert_eq!(bridge.plan.step_limit, 1_000_000);
}

#[test]
fn shapes() {
    let bridge = good(SHAPES);
    // One pier stands for all.
    assert_eq!(bridge.piers.len(), 5);
    assert_eq!(bridge.spans[0].rise, 2.0);
    let measured = &bridge.spans[5];
    assert!((measured.span - 6.0).abs() < 1e-12 && (measured.rise - 1.6).abs() < 1e-12);
    let Profile::Measured { points } = &measured.profile else { panic!() };
    assert_eq!(points[0], [0.0, 0.0]);
}

#[test]
fn five_lines_are_enough_for_a_limit_analysis() {
    assert_eq!(TINY.lines().count(), 5);
    let bridge = good(TINY);
    assert_eq!((bridge.plan.method, bridge.plan.analysis), (Method::Limit, Analysis::Load));
    assert_eq!(bridge.loads[0].position, 1.25);
    assert_eq!(bridge.dispersal.rule, DispersalRule::None);
}

#[test]
fn a_calibration() {
    let found = read(CALIBRATION.as_bytes()).bridge.unwrap().calibration;
    assert_eq!((found.wanted_modulus, found.modulus), (Some(40e6), Modulus::Secant));
    assert_eq!((found.sample_size, found.block_weight, found.load_step), (0.8, 2e3, 20e3));
    assert_eq!((found.steps, found.ignored_steps, found.seeds), (12, 3, 3));
    assert_eq!((found.multiples, found.compare_with), (vec![1.0, 2.5, 8.0], vec![22e6, 30e6, 48e6]));
    assert_eq!((found.tolerance, found.least_replacement), (0.02, 0.6));
    assert!(found.wanted_friction_angle.is_some_and(|angle| (angle.to_degrees() - 22.0).abs() < 1e-9));
    assert_eq!(found.wanted_cohesion, Some(4e3));
    assert_eq!((&found.confining_pressures[..], found.sheared_samples), (&[40e3, 160e3][..], 12));
    // All of it has defaults.
    let start = CALIBRATION.find("[calibration]").unwrap();
    assert_eq!(read(&CALIBRATION.as_bytes()[..start]).bridge.unwrap().calibration, Calibration::default());
    let wrong = CALIBRATION
        .replace("ignored_steps = 3", "ignored_steps = 11")
        .replace("multiples = [1, 2.5, 8]", "multiples = [1, 8]")
        .replace("load_step = \"20 kN/m\"", "load_step = \"20 kN\"");
    let codes: Vec<&str> = read(wrong.as_bytes()).diagnostics.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, ["B104"], "numbers are compared once they can be read");
    let wrong = wrong.replace("load_step = \"20 kN\"", "load_step = \"20 kN/m\"");
    let codes: Vec<&str> = read(wrong.as_bytes()).diagnostics.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, ["B107", "B107"]);
}

#[test]
fn sweeps_and_fill_pressure_are_read_as_written() {
    let bridge = good(VIADUCT);
    let (sweep, fill) = (bridge.sweep.unwrap(), bridge.fill_pressure.unwrap());
    assert_eq!((sweep.rule.as_str(), &sweep.vehicles[..]), ("cs-454", &["hb-45".to_owned(), "crane".to_owned()][..]));
    assert_eq!((sweep.step, sweep.directions, sweep.braking), (Some(0.25), bridge::Directions::Left, 0.25));
    assert!(!sweep.subsets && sweep.own_dispersal && sweep.discrete_elements);
    assert!(fill.applies && fill.least == bridge::LeastPressure::Active);
    assert!((fill.friction_angle.to_degrees() - 32.0).abs() < 1e-9 && fill.cohesion == 2e3 && fill.mobilisation == 0.4);
    let across = bridge.carriageway.unwrap();
    assert_eq!((across.lanes, across.lane_width, across.edge_distance), (Some(2), Some(2.5), Some(0.8)));
    assert!((across.skew.unwrap().to_degrees() - 5.0).abs() < 1e-9);
    let other = good(WALLS).sweep.unwrap();
    assert_eq!((other.rule_file.as_deref(), other.vehicles.len(), other.subsets), (Some("own-rule.toml"), 0, true));
    // Two rules are none; a sweep alone needs no load.
    assert!(
        show_all(&VIADUCT.replacen("rule = \"cs-454\"", "rule = \"cs-454\"\nrule_file = \"x.toml\"", 1))
            .contains("B016")
    );
    let alone = CASE_1.split("[[load]]").next().unwrap().to_owned() + "[sweep]\n";
    assert!(good(&alone).loads.is_empty());
}

/// A square span with its skew is the longer span along the road: half a circle becomes half an ellipse.
#[test]
fn a_square_span_is_turned_into_the_one_along_the_road() {
    let written = |profile: &str| {
        let text = CASES.replacen("profile = \"segmental\"", profile, 1);
        good(&if profile.contains("segmental") { text } else { text.replacen("rise = \"2.0 m\"\n", "", 1) })
    };
    let stretch = 1.0 / 8f64.to_radians().cos();
    let bridge = written("profile = \"segmental\"");
    let span = &bridge.spans[0];
    assert!((span.span - 8.0 * stretch).abs() < 1e-12 && (span.rise - 2.0).abs() < 1e-12, "{span:?}");
    assert!(
        (span.skew.to_degrees() - 8.0).abs() < 1e-12 && matches!(span.profile, bridge::ring::Profile::Measured { .. })
    );
    let half = &written("profile = \"semicircular\"").spans[0];
    assert!(matches!(half.profile, bridge::ring::Profile::Elliptical) && (half.rise - 4.0).abs() < 1e-12);
    assert_eq!(bridge.carriageway.as_ref().unwrap().cracks, [0.9, 7.1]);
    // Skew of the bridge where a span has none; a square span needs its own.
    let general = CASES.replacen("skew = \"8 deg\"\n", "", 1).replacen("cracks", "skew = \"5 deg\"\ncracks", 1);
    assert!(show_all(&general).contains("`skew` is missing"), "{}", show_all(&general));
    let along = good(&general.replacen("square_span", "span", 1));
    assert!((along.spans[0].skew.to_degrees() - 5.0).abs() < 1e-9 && along.spans[0].span == 8.0);
    assert!(
        show_all(&CASES.replacen("square_span = \"8.0 m\"", "square_span = \"8.0 m\"\nspan = \"8.1 m\"", 1))
            .contains("B016")
    );
}

/// Cases name loads of the file and quantities that it has.
#[test]
fn cases_are_read_as_written() {
    let read = bridge::read(CASES.as_bytes());
    let [first, second] = &read.cases[..] else { panic!("{:?}", read.cases) };
    assert_eq!(
        (first.name.as_str(), &first.loads[..], first.fill_weight),
        ("tandem alone, light fill", &[(0, 1.35)][..], 0.9)
    );
    assert_eq!(
        (&second.loads[..], second.masonry_weight, second.surfacing_weight),
        (&[(0, 1.0), (1, 1.0)][..], 1.15, 1.5)
    );
    assert_eq!(second.changes[0].quantity, "joint.friction_angle");
    let bridge = read.bridge.unwrap();
    assert_eq!((bridge.loads[0].horizontal, bridge.loads[1].horizontal), (0.0, -0.1));
    let put = first.put(&bridge);
    assert_eq!((put.loads.len(), put.cover.layers[0].density), (1, 0.9 * 1800.0));
    let bridge::LoadKind::Axles { axles, .. } = &put.loads[0].kind else { panic!() };
    assert_eq!(axles, &[(135e3, 0.0), (135e3, 1.2)]);
    let document = read.document.unwrap();
    assert_eq!((document.revisions.len(), document.confirm.len()), (1, 1));
    assert_eq!(document.inspections[0].photograph.as_deref(), Some("photo-12.jpg"));
    for (wrong, code) in
        [("name = \"tandem\"\nfactor", "B227"), ("joint.friction_angel", "B501"), ("value = \"30 kg\"", "(B104)")]
    {
        let text = match code {
            "B227" => CASES.replacen(wrong, "name = \"tandems\"\nfactor", 1),
            "B501" => CASES.replacen("joint.friction_angle", wrong, 1),
            _ => CASES.replacen("value = \"30 deg\"", wrong, 1),
        };
        assert!(show_all(&text).contains(code), "{code}: {}", show_all(&text));
    }
}

/// Without particles slabs would carry nothing.
#[test]
fn bodies_of_cover_need_particles_to_stand_among() {
    let backed = |body: &str| {
        let backing = format!("[backing]\nheight = \"1.5 m\"\ndensity = \"2000 kg/m^3\"\nas = \"{body}\"\n\n[masonry]");
        CASE_1.replacen("[masonry]", &backing, 1)
    };
    assert_eq!(good(&backed("weight")).cover.backing.unwrap().body, BackingBody::Weight);
    assert_eq!(good(&backed("blocks")).cover.backing.unwrap().body, BackingBody::Blocks, "they stand on the rings");
    assert!(show_all(&backed("particles")).contains("B216"));
    let slabs = "thickness = \"0.150 m\"\ndensity = \"2200 kg/m^3\"\nas = \"blocks\"\nblock_length = \"1 m\"";
    let slabs = CASE_1.replacen("thickness = \"0.150 m\"\nweighs = false", slabs, 1);
    assert!(show_all(&slabs).contains("B216"), "{}", show_all(&slabs));
}

/// Layers and backing as a continuum: their strength, how they are modelled, and what does not fit.
#[test]
fn a_continuum_is_read_as_written() {
    use crate::files::CONTINUUM;
    let bridge = good(CONTINUUM);
    let (fill, surfacing) = (&bridge.cover.layers[0], &bridge.cover.layers[1]);
    assert!(
        fill.continuum && fill.weighs && !surfacing.continuum && surfacing.weighs,
        "other methods take it as weight"
    );
    assert!((fill.friction_angle.unwrap().to_degrees() - 32.0).abs() < 1e-9);
    assert_eq!((fill.cohesion, fill.tensile_strength), (Some(2e3), Some(1e3)));
    let backing = bridge.cover.backing.unwrap();
    assert_eq!((backing.body, backing.cohesion), (BackingBody::Continuum, Some(50e3)));
    assert_eq!((backing.tensile_strength, backing.compressive_strength), (Some(10e3), Some(2e6)));
    let plan = bridge.continuum.unwrap();
    assert_eq!((plan.mobilised_share, plan.interface_cohesion, plan.ends), (0.6, 1e3, bridge::FillEnds::Hold));
    assert_eq!((plan.extent, plan.water_level, plan.bound_ratio, plan.elements), (Some(8.0), Some(0.5), 1.1, 2000));
    // Without its table, by the defaults; without a continuum, none.
    let table = CONTINUUM.split("[continuum]").nth(1).unwrap().split("[[load]]").next().unwrap();
    let plan = good(&CONTINUUM.replacen(&format!("[continuum]{table}"), "", 1)).continuum.unwrap();
    assert_eq!((plan.mobilised_share, plan.dilatancy_angle, plan.interface_friction_angle), (1.0, 0.0, None));
    assert_eq!((plan.ends, plan.extent, plan.water_level), (bridge::FillEnds::Slide, None, None));
    assert_eq!((plan.bound_ratio, plan.elements), (1.05, 4000));
    assert_eq!(good(CASE_1).continuum, None);
    let without = CONTINUUM.replacen("friction_angle = \"32 deg\"\n", "", 1);
    assert!(show_all(&without).contains("B011"), "{}", show_all(&without));
    // Backing that nobody described further is weight, which continuum above it cannot rest on.
    let backing = CONTINUUM.split("[backing]").nth(1).unwrap().split("[continuum]").next().unwrap();
    let weight = CONTINUUM.replacen(backing, "\nheight = \"1.5 m\"\ndensity = \"2200 kg/m^3\"\n\n", 1);
    assert!(show_all(&weight).contains("B220"), "{}", show_all(&weight));
    let surfacing = "density = \"2300 kg/m^3\"";
    let slabs = format!("{surfacing}\nas = \"blocks\"\nblock_length = \"1 m\"");
    assert!(show_all(&CONTINUUM.replacen(surfacing, &slabs, 1)).contains("B219"));
}

/// What the finite element model reads, and what it would still need: nothing of it is asked of a file for collapse.
#[test]
fn service_tables() {
    use bridge::{Cone, SoilLaw, Springs};
    let b = good(crate::files::SERVICE);
    let s = &b.service;
    assert_eq!((s.mesh.size, s.mesh.ring_nodes, s.mesh.side_distance), (Some(0.2), 9, Some(12.0)));
    assert_eq!(
        (s.fill.elastic_modulus, s.fill.cone, s.fill.law),
        (Some(110e6), Cone::PlaneStrain, SoilLaw::DruckerPrager)
    );
    let haunch = s.haunch_fill.unwrap();
    assert_eq!((haunch.height, haunch.soil.law, haunch.soil.density), (1.1, SoilLaw::Elastic, Some(2100.0)));
    assert_eq!((s.abutment_fill.extent, s.abutment_fill.soil.law), (Some(5.0), SoilLaw::MohrCoulomb));
    assert_eq!((s.mortar.lift_off, s.mortar.springs), (1e3, Springs::Interface));
    assert!(!s.fill_contact.separation);
    assert_eq!(s.missing(&b.masonry, b.cover.backing.as_ref()), []);

    let plain = good(crate::files::TINY);
    assert_eq!(plain.service.mesh, bridge::Service::default().mesh);
    let missing = plain.service.missing(&plain.masonry, None);
    assert!(missing.iter().any(|m| (m.table, m.key) == ("mortar", "thickness")), "{missing:?}");
    assert!(missing.iter().all(|m| m.table != "abutment_fill"), "{missing:?}");
}

/// Fill of haunches and behind abutments is as [fill] where it says nothing else.
#[test]
fn soils_are_as_the_fill() {
    let short = crate::files::SERVICE.replace("poisson_ratio = 0.22\n", "");
    assert_eq!(good(&short).service.abutment_fill.soil.poisson_ratio, Some(0.19));
    let without = crate::files::SERVICE.replace("density = \"1850 kg/m^3\"\n", "");
    assert_eq!(good(&without).service.fill.density, Some(1800.0), "that of the lowest layer");
}

/// A length in feet among metres is doubted, and a whole file in feet is not.
#[test]
fn lengths_in_two_systems_are_doubted() {
    let file = |span: &str, rise: &str, width: &str| {
        format!(
            "[bridge]\nname = \"b\"\nwidth = \"{width}\"\n[[span]]\nprofile = \"segmental\"\nspan = \"{span}\"\nrise = \"{rise}\"\nthickness = \"{rise}\"\n"
        )
    };
    let doubts = |text: String| {
        let found = bridge::read(text.as_bytes());
        found.diagnostics.iter().filter(|one| one.code == "P033").map(|one| one.message.clone()).collect::<Vec<_>>()
    };
    assert_eq!(doubts(file("5 m", "1.25 m", "6 m")), Vec::<String>::new());
    assert_eq!(doubts(file("16 ft", "4 ft", "20 ft")), Vec::<String>::new());
    let told = doubts(file("5 m", "1.25 m", "20 ft"));
    assert!(told.len() == 1 && told[0].contains("`width` is in feet"), "{told:?}");
    assert_eq!(doubts(file("5 m", "4 ft", "20 ft")).len(), 1, "the one that stands alone");
    // Nobody writes an inch for a metre, nor a millimetre for a foot.
    assert_eq!(doubts(file("5 m", "18 in", "6 m")), Vec::<String>::new());
    assert_eq!(doubts(file("16 ft", "450 mm", "20 ft")), Vec::<String>::new());
}
