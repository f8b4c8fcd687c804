//! A bridge whose fill yields as a continuum: what leads its result, what its picture holds, and how its loads move.

use super::*;
use mechanics::watch::Unwatched;
use outcome::collapse::Status;
use outcome::note::{Fill, Note, Soil};

/// A ring of 4 m under half a metre of soil, in few words.
const FILE: &str = r#"
[bridge]
name = "small"
width = "4 m"
[[span]]
profile = "segmental"
span = "4 m"
rise = "1 m"
thickness = "0.3 m"
voussoirs = 21
[[cover]]
layer = "fill"
as = "continuum"
thickness = "0.4 m"
density = "1900 kg/m^3"
friction_angle = "34 deg"
cohesion = "3 kPa"
[continuum]
bound_ratio = 1.15
[masonry]
density = "2200 kg/m^3"
compressive_strength = "unlimited"
[joint]
friction_angle = "35 deg"
cohesion = "0 kPa"
[dispersal]
rule = "uniform"
slope = "2:1"
[[load]]
name = "axle"
kind = "axles"
axle_forces = ["100 kN"]
axle_spacings = []
contact_length = "0.3 m"
effective_width = "2.5 m"
at = "1/4 of span 1"
[analysis]
method = "limit"
"#;

fn small() -> Bridge {
    of(FILE)
}

fn of(file: &str) -> Bridge {
    let read = bridge::read(file.as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

/// The same with bounds that are further apart, for what does not depend on them.
fn coarse() -> String {
    FILE.replace("bound_ratio = 1.15", "bound_ratio = 1.5")
}

#[test]
fn the_lower_bound_leads_and_both_stand_beside_it() {
    let b = small();
    let found = collapse(&b, None, &mut Unwatched).unwrap();
    assert_eq!(found.status, Status::Collapsed);
    let limit = found.limit().unwrap();
    let report = limit.continuum.as_ref().unwrap();
    let (lower, upper) = (limit.lower_bound.unwrap(), limit.upper_bound.unwrap());
    assert_eq!(found.carried(), Some(lower));
    assert_eq!((found.last_stable_load, found.collapse_load), (Some(lower), Some(upper)));
    assert!(lower < upper && upper <= 1.15 * lower && report.bound_ratio.unwrap() <= 1.15);
    // Half of the strength carries less, soil that dilates more.
    let [least, most] = report.range.unwrap();
    assert!(least < lower && (most / upper - 1.0).abs() < 0.05, "{least} {lower} {most} {upper}");
    assert!(report.associated.unwrap()[0] > lower);
    // Soil that keeps its strength and does not dilate, by iteration on a coarser mesh.
    let iterated = report.iterated.unwrap();
    assert!(0.8 * lower < iterated && iterated < report.associated.unwrap()[1], "{lower} {iterated}");
    let settles = |a: &Note| matches!(a, Note::Soil(Soil::Iterated { load, .. }) if *load == iterated);
    assert!(found.assumptions.iter().any(settles) && report.plane_strain.is_none());
    assert!(limit.equilibrium_residual.unwrap() < 1e-6 && report.flow_violation.unwrap() < 1e-5);
    let codes: Vec<&str> = found.warnings.iter().map(|w| w.code()).collect();
    assert!(codes.contains(&"A198") && !codes.contains(&"A111"), "{codes:?}");
    assert!(found.assumptions.contains(&Soil::Plates.into()));
    // The words on weight alone and on dispersal would not be true.
    let untrue = |a: &Note| matches!(a, Note::Fill(Fill::Dispersal { .. } | Fill::BearingNotChecked));
    assert!(!found.assumptions.iter().any(untrue));

    let soil = found.picture.soil.as_ref().unwrap();
    assert_eq!(soil.triangles.len(), report.elements);
    assert!(soil.motions.iter().all(|m| m[0].hypot(m[1]) <= 1.0 + 1e-12));
    assert!((soil.gaps.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    // What presses on the blocks is the weight of the soil over them and the load, but for what goes to ground and ends beside them.
    let down: f64 = soil
        .pressures
        .iter()
        .map(|p| {
            let [a, b] = p.ends;
            let (run, rise) = (b[0] - a[0], b[1] - a[1]);
            let [pressure, shear] = [p.pressure, p.shear].map(|v| 0.5 * (v[0] + v[1]));
            pressure * run - shear * rise
        })
        .sum();
    let ends = soil.pressures.iter().flat_map(|p| p.ends).map(|p| p[0]);
    let (from, to) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    let over = soil.triangles.iter().map(|corners| corners.map(|k| soil.points[k]));
    let over = over.filter(|c| (from..to).contains(&((c[0][0] + c[1][0] + c[2][0]) / 3.0)));
    let area: f64 = over.map(|[a, b, c]| 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))).sum();
    let whole = 1900.0 * 9.81 * area + lower;
    assert!((down / whole - 1.0).abs() < 0.1, "{down} {whole}");
    let told = found.object();
    for key in ["lower_bound_kn_per_m", "upper_bound_kn_per_m", "bound_ratio", "elements", "mobilised_share"] {
        assert!(told.contains_key(key), "{key}");
    }
}

#[test]
fn walls_that_tilt_first_are_told() {
    let wall =
        "[spandrel_wall]\nbrick_length = \"0.6 m\"\nbrick_height = \"0.3 m\"\nthickness = \"0.6 m\"\ntop = \"1 m\"\n";
    let held = "[continuum]\nconfinement = \"spandrel-walls\"\n";
    let file = coarse();
    let found = |file: &str| collapse(&of(file), None, &mut Unwatched).unwrap();
    let walled = file.replace("[continuum]\n", &format!("{wall}{held}"));
    let (free, thin) = (found(&file), found(&walled));
    let thick = found(&walled.replace("\"0.6 m\"", "\"3.9 m\""));
    // Walls that hold the fill by the weight of their parapets alone do not hold it: these may be lost.
    let held_by_parapets = found(&walled.replace("\"0.6 m\"", "\"0.5 m\""));
    assert_eq!(held_by_parapets.status, Status::UnstableUnderSelfWeight);
    assert!(held_by_parapets.not_counted.with_help[0].headline.is_some());
    let report = |c: &Collapse| c.limit().unwrap().continuum.as_deref().unwrap().clone();
    assert!(report(&free).wall.is_none() && report(&free).plane_strain.is_none());
    // Walls of 0.3 m hold less than plane strain asks for, and tilt; walls as thick as the bridge is wide hold it.
    // Bounds from the other side leave no doubt.
    let (lower, upper) = (|c: &Collapse| c.carried().unwrap(), |c: &Collapse| c.collapse_load.unwrap());
    assert!(upper(&thin) < lower(&thick), "{} {}", upper(&thin), lower(&thick));
    assert!(lower(&thick) < upper(&free), "{} {}", lower(&thick), upper(&free));
    assert!(upper(&thin) < report(&thin).plane_strain.unwrap() && report(&thin).wall.unwrap().tilts);
    let codes = |c: &Collapse| c.warnings.iter().map(|w| w.code()).collect::<Vec<_>>();
    assert!(codes(&thin).contains(&"A201") && !codes(&free).contains(&"A201"), "{:?}", codes(&thin));
    assert!(thin.assumptions.contains(&Soil::Confined { by: bridge::Confinement::SpandrelWalls }.into()));
}

#[test]
fn loads_that_move_have_both_bounds_and_are_mirrored() {
    let b = small();
    let found = sweep(&b, Places::Between([0.4, 3.6], 3), true, &mut Unwatched).unwrap();
    assert!(found.whole && found.points.len() == 3);
    for point in &found.points {
        let (lower, upper) = (point.load_factor.unwrap(), point.upper_factor.unwrap());
        assert!(lower <= upper && upper <= 1.2 * lower + 1e-9, "{lower} {upper}");
    }
    for (a, b) in found.points.iter().zip(found.points.iter().rev()) {
        // The mesh is not mirrored; the bounds of both sides are of one load.
        assert!(a.load_factor.unwrap() <= b.upper_factor.unwrap() * (1.0 + 1e-6));
    }
    let worst = found.worst().unwrap();
    assert!(worst.upper_factor.unwrap() <= 1.15 * worst.load_factor.unwrap(), "the worst one as close as wanted");
    assert!(!found.is_deformable());
}

#[test]
fn vehicles_are_asked_on_a_continuum_where_they_govern() {
    let text = format!("{}\n[sweep]\nrule = \"cs-454\"\nvehicles = [\"cs454-single\"]\nstep = \"1 m\"\n", coarse());
    let b = of(&text);
    let found = vehicle_sweep(&b, &mut Unwatched).unwrap();
    assert!(found.assumptions.contains(&Soil::InSweepOfVehicles.into()), "{:?}", found.assumptions);
    // The same with fill as weight alone carries more: here the soil fails under the axle.
    let mut weight = b.clone();
    weight.continuum = None;
    weight.cover.layers.iter_mut().for_each(|layer| layer.continuum = false);
    let by_weight = vehicle_sweep(&weight, &mut Unwatched).unwrap();
    let [yields, rigid] = [&found, &by_weight].map(|f| f.vehicles[0].adequacy.unwrap());
    assert!(yields < rigid, "{yields} {rigid}");
    // What is judged is the least of all positions, and the case that has it is the one drawn.
    let one = &found.vehicles[0];
    let least = one.envelope.iter().filter_map(|p| p.adequacy).fold(f64::INFINITY, f64::min);
    assert!(yields <= least * (1.0 + 1e-9), "{yields} {least}");
    let at = one.case.as_ref().unwrap();
    assert!(one.envelope.iter().any(|p| p.case.position == at.position && p.adequacy == Some(least)), "{at:?} {least}");
    // Stronger soil counts for no more than the rings do.
    let mut strong = b.clone();
    strong.cover.layers.iter_mut().for_each(|layer| layer.cohesion = Some(200e3));
    let strong = vehicle_sweep(&strong, &mut Unwatched).unwrap().vehicles[0].adequacy.unwrap();
    assert!(yields < strong && strong <= rigid * (1.0 + 1e-9), "{yields} {strong} {rigid}");
}

#[test]
fn methods_that_know_no_continuum_say_so() {
    let mut b = of(&coarse());
    b.joint.normal_stiffness = Some(bridge::JointStiffness::Contact(1e10));
    b.joint.shear_stiffness = Some(bridge::JointStiffness::Contact(5e9));
    let says = |c: &Collapse| c.assumptions.contains(&Soil::AsWeight.into());
    assert!(says(&collapse_by(Method::Path, &b, &mut Unwatched).unwrap()));
    assert!(says(&thickness(&b, &mut Unwatched).unwrap()));
    assert!(!says(&collapse(&b, None, &mut Unwatched).unwrap()));
    // Asked for by the file, they are refused: a plate that sinks into the soil would not be seen.
    for analysis in [bridge::Analysis::Thickness, bridge::Analysis::SupportMovement] {
        b.plan.analysis = analysis;
        let found = collapse(&b, None, &mut Unwatched);
        let told = found.unwrap_err().to_string();
        assert!(told.contains("not take fill or backing as a continuum into account"), "{analysis:?}: {told}");
    }
}

#[test]
fn a_run_that_is_stopped_while_it_looks_for_the_range_is_no_collapse() {
    let b = of(&coarse());
    let d = structure::discretise::discretise(&b).unwrap();
    let earth = structure::discretise::continuum::earth(&b, &d).unwrap().unwrap();
    let whole = mechanics::watch::CancelToken::default();
    assert_eq!(engine::continuum::whole(&b, &d, &earth, true, &whole).unwrap().status, Status::Collapsed);
    let shorter = mechanics::watch::CancelToken::limited_to(whole.iterations() - 5);
    assert_eq!(engine::continuum::whole(&b, &d, &earth, true, &shorter).unwrap().status, Status::Cancelled);
}

/// Sand without cohesion, shallow under a narrow load: stresses that carry any of the load are not found, and zero is told as zero, with
/// the gap to what is not carried.
#[test]
fn a_lower_bound_of_nothing_is_zero_and_its_gap_is_told() {
    let file = coarse()
        .replace("cohesion = \"3 kPa\"", "cohesion = \"0 kPa\"")
        .replace("axle_forces = [\"100 kN\"]", "axle_forces = [\"1 kN\"]");
    for file in [file.clone(), file.replace("at = \"1/4 of span 1\"", "at = \"3/4 of span 1\"")] {
        let mut b = of(&file);
        b.continuum.as_mut().unwrap().elements = 300;
        let found = engine::continuum::with_strength_of_the_file(&b, &mut Unwatched).unwrap();
        assert_eq!(found.status, Status::Collapsed);
        let limit = found.limit().unwrap();
        let (lower, upper) = (limit.lower_bound.unwrap(), limit.upper_bound.unwrap());
        assert!(lower >= 0.0 && lower.is_sign_positive() && upper > 1.5 * lower, "{lower} {upper}");
        let told = found.warnings.iter().find(|w| w.code() == outcome::warning::BOUNDS_APART);
        let told = told.unwrap_or_else(|| panic!("{lower} {upper}: {:?}", found.warnings)).message();
        assert!(told.contains("1.500 times was wanted"), "{told}");
        assert!(lower > 0.0 || told.contains("lower one zero"), "{told}");
    }
}
