use super::*;
use crate::samples::{self, Dice};
use bridge::Bridge;
use bridge::ring::{Intrados, Profile};
use outcome::section::Section;

/// Points of an intrados with normal scatter [m], seen by a scanner that stands somewhere.
fn scanned(profile: &Profile, [span, rise]: [f64; 2], count: usize, scatter: f64, seed: u64) -> Vec<[f64; 2]> {
    let curve = Intrados::between(profile, span, rise, 0.0).unwrap();
    let mut dice = Dice(seed);
    // Both springings themselves, and places at random between them.
    let shares: Vec<f64> = [0.0, 1.0].into_iter().chain((2..count).map(|_| dice.roll())).collect();
    let mut normal = || (-2.0 * dice.roll().max(1e-300).ln()).sqrt() * (std::f64::consts::TAU * dice.roll()).cos();
    let moved = |share: f64, by: f64| {
        let [x, y] = curve.at(share).offset(by);
        [37.2 + x, 101.8 + y]
    };
    shares.into_iter().map(|share| moved(share, scatter * normal())).collect()
}

fn load(profile: Profile, [span, rise]: [f64; 2]) -> f64 {
    let mut b: Bridge = samples::case_two();
    (b.spans[0].profile, b.spans[0].span, b.spans[0].rise) = (profile, span, rise);
    b.spans[0].rings[0] = bridge::Ring { crown_thickness: 0.6, springing_thickness: 0.6, voussoirs: 40 };
    b.loads[0].position = 0.25 * span;
    b.masonry.compressive_strength = Some(8e6);
    b.plan.method = bridge::Method::Limit;
    assess::analysis::collapse_by_limit(&b, &mut mechanics::watch::Unwatched).unwrap().collapse_load.unwrap()
}

fn of(section: &outcome::section::Section) -> f64 {
    load(Profile::Measured { points: section.curve.clone() }, [section.span(), section.rise()])
}

#[test]
fn scatter_of_two_millimetres_changes_the_load_by_less_than_two_per_cent() {
    for (profile, size) in [
        (Profile::Segmental, [8.0, 1.6]),
        (Profile::Semicircular, [6.0, 3.0]),
        (Profile::Elliptical, [9.0, 2.6]),
        (Profile::Parabolic, [10.0, 2.0]),
    ] {
        let exact = load(profile.clone(), size);
        // A scan has a point every few millimetres; a hundred points taken by hand leave the springings of an ellipse less certain.
        for (seed, count, most) in [(1, 1000, 0.02), (2, 1000, 0.02), (3, 1000, 0.02), (4, 2000, 0.02), (5, 100, 0.05)]
        {
            let section = fit(&scanned(&profile, size, count, 2e-3, seed)).unwrap();
            let found = of(&section);
            assert!((found / exact - 1.0).abs() < most, "{profile:?}, {count} points: {found} of {exact}");
            assert!((1.2e-3..3e-3).contains(&section.scatter) && !section.has_steps(), "{:?}", section.scatter);
            assert!((section.span() - size[0]).abs() < 0.012 && (section.rise() - size[1]).abs() < 0.006);
        }
    }
}

#[test]
fn a_curve_without_scatter_comes_back() {
    let size = [8.0, 1.6];
    let section = fit(&scanned(&Profile::Segmental, size, 120, 0.0, 7)).unwrap();
    assert_eq!(section.terms, 1, "a circle is a circle");
    assert!(section.circle.scatter < 1e-9 && section.scatter < 1e-9);
    let (found, exact) = (of(&section), load(Profile::Segmental, size));
    assert!((found / exact - 1.0).abs() < 1e-4, "{found} {exact}");
}

#[test]
fn outliers_are_left_out_and_told() {
    let size = [8.0, 1.6];
    let mut points = scanned(&Profile::Segmental, size, 300, 2e-3, 11);
    let clean = of(&fit(&points).unwrap());
    // A bat, a cable and a scanner's ghost.
    for (k, by) in [(40, -0.15), (120, -0.04), (200, 0.60)] {
        points[k][1] += by;
    }
    let section = fit(&points).unwrap();
    let told: Vec<[f64; 2]> = section.left_out().map(|point| point.at).collect();
    for k in [40, 120, 200] {
        assert!(told.contains(&points[k]), "{told:?}");
    }
    assert!(told.len() <= 4, "{told:?}");
    assert!((of(&section) / clean - 1.0).abs() < 2e-3);
    let table = deviations(&section);
    assert_eq!((table.lines().count(), table.matches("true").count()), (301, told.len()));
}

/// A closed scan holds the faces of both abutments and the ground between them, with few points or many; the curve stays that of the arch. What is no
/// ground and more than slips is refused.
#[test]
fn the_ground_of_a_closed_scan_is_left_out() {
    let profile = Profile::Segmental;
    let arch = scanned(&profile, [8.0, 1.6], 300, 2e-3, 3);
    let line = |from: [f64; 2], to: [f64; 2], count: u32| {
        let at = move |k: u32| f64::from(k) / f64::from(count - 1);
        (0..count).map(move |k| [0, 1].map(|i| from[i] + at(k) * (to[i] - from[i])))
    };
    let mut dice = Dice(5);
    for count in [12, 60, 400] {
        let mut points = arch.clone();
        let [left, right, top, foot] = [37.2, 45.2, 101.8, 100.3];
        points.extend(line([left, foot], [left, top], 60).chain(line([right, foot], [right, top], 60)));
        points.extend(line([left, foot], [right, foot], count));
        let points: Vec<[f64; 2]> = points.iter().map(|p| p.map(|x| x + 4e-3 * (dice.roll() - 0.5))).collect();
        let found = fit(&points).unwrap();
        assert!(
            (found.rise() - 1.6).abs() < 0.02 && (found.span() - 8.0).abs() < 0.02,
            "{} {}",
            found.span(),
            found.rise()
        );
        let ground = found.left_out().filter(|point| point.at[1] < foot + 0.1).count();
        assert!(found.faces.len() == 2 && ground >= (8 * count / 10) as usize, "{count}: {ground}");
    }
    let parapet = arch.iter().copied().chain(line([39.0, 104.5], [43.0, 104.5], 60)).collect::<Vec<_>>();
    let found = fit(&parapet);
    assert!(matches!(found, Err(SectionError::NoArch { .. })), "{:?}", found.map(|one| (one.span(), one.rise())));
}

#[test]
fn the_hand_and_the_order_of_the_points_make_no_difference() {
    let points = scanned(&Profile::Elliptical, [9.0, 2.6], 150, 2e-3, 5);
    let one = fit(&points).unwrap();
    let turned: Vec<[f64; 2]> = points.iter().rev().map(|[x, y]| [100.0 - x, *y]).collect();
    let other = fit(&turned).unwrap();
    assert_eq!(one.terms, other.terms);
    for (a, b) in one.curve.iter().zip(other.curve.iter().rev()) {
        assert!((a[0] - (one.span() - b[0])).abs() < 1e-6 && (a[1] - b[1]).abs() < 1e-5, "{a:?} {b:?}");
    }
}

#[test]
fn a_kink_is_told() {
    let pointed = fit(&scanned(&Profile::Pointed, [6.0, 3.9], 300, 1e-3, 3)).unwrap();
    assert!(pointed.has_steps(), "{} {}", pointed.scatter, pointed.noise);
}

#[test]
fn tables_are_read_as_they_come() {
    let read = |text: &str, unit| read(text, unit).map(|table| table.points);
    let wanted = Ok(vec![[0.0, 0.0], [1.5, 2.25]]);
    let metres = LengthUnit::named("m");
    for text in [
        "x_m,y_m\n0,0\n1.5,2.25\n",
        "# scan\n\"x [m]\";\"y [m]\"\n0;0\n1,5;2,25\n",
        "\u{feff}x (mm)\ty (mm)\n0\t0\n1500\t2250\r\n",
        "x_m,y_mm\n0,0\n1.5,2250\n",
        "x_m,y\n0,0\n1.5,2.25\n",
    ] {
        assert_eq!(read(text, None), wanted, "{text}");
    }
    assert_eq!(read("0 0\n1.5   2.25\n", metres), wanted);
    assert_eq!(read("0,0\n1.5,2.25\n", None), Err(SectionError::NoUnit));
    for (text, line) in
        [("x_m,y_m\n0,0\n1,a\n", 3), ("x_m,y_m,z_m\n0,0,0\n", 2), ("x_m,y_m\n1\n", 2), ("x_m,y_m\n1,inf\n", 2)]
    {
        assert!(matches!(read(text, None), Err(SectionError::Row { line: found, .. }) if found == line), "{text}");
    }
}

#[test]
fn what_is_no_arch_is_refused() {
    let few = scanned(&Profile::Segmental, [8.0, 1.6], 11, 0.0, 1);
    assert!(matches!(fit(&few), Err(SectionError::TooFew { count: 11, .. })));
    let line: Vec<[f64; 2]> = (0..40).map(|k| [0.1 * f64::from(k), 2.0]).collect();
    assert!(matches!(fit(&line), Err(SectionError::NoArch { .. })), "{:?}", fit(&line));
    let sag: Vec<[f64; 2]> =
        scanned(&Profile::Segmental, [8.0, 1.6], 60, 0.0, 1).iter().map(|[x, y]| [*x, -y]).collect();
    assert!(fit(&sag).is_err());
    let mut tilted = scanned(&Profile::Segmental, [8.0, 1.6], 60, 0.0, 1);
    tilted.iter_mut().for_each(|p| p[1] += 0.02 * p[0]);
    assert!(matches!(fit(&tilted), Err(SectionError::NotLevel { .. })), "{:?}", fit(&tilted));
    assert!(fit(&vec![[1.0, 1.0]; 40]).is_err());
    let file = span_file("two\nlines", &fit(&scanned(&Profile::Segmental, [8.0, 1.6], 60, 0.0, 1)).unwrap());
    assert!(file.contains("TO FILL IN") && file.contains("\"two lines\""), "{file}");
}

/// The same with the faces of its abutments: points on lines at the ends, so many metres deep, a point every 50 mm.
fn with_faces(profile: &Profile, size: [f64; 2], depths: [f64; 2], batter: f64, seed: u64) -> Vec<[f64; 2]> {
    let mut points = scanned(profile, size, 400, 2e-3, seed);
    let mut dice = Dice(seed + 100);
    for (side, depth) in depths.into_iter().enumerate() {
        let (x, outwards) = if side == 0 { (37.2, -1.0) } else { (37.2 + size[0], 1.0) };
        for k in 1..=(depth / 0.05) as usize {
            let down = 0.05 * k as f64;
            points.push([x - outwards * batter * down + 4e-3 * (dice.roll() - 0.5), 101.8 - down]);
        }
    }
    points
}

#[test]
fn faces_of_abutments_are_left_out_and_told() {
    for (profile, size, depths, batter) in [
        (Profile::Segmental, [8.0, 1.6], [1.45, 1.45], 0.0),
        (Profile::Segmental, [8.0, 1.6], [2.0, 0.6], 0.0),
        (Profile::Segmental, [5.0, 1.2], [1.0, 1.0], 0.1),
        (Profile::Segmental, [8.0, 1.6], [1.0, 0.0], 0.0),
        (Profile::Segmental, [15.0, 2.0], [4.0, 3.0], 0.0),
        (Profile::Semicircular, [6.0, 3.0], [2.0, 2.0], 0.0),
        (Profile::Parabolic, [10.0, 2.0], [1.5, 1.5], 0.0),
    ] {
        for seed in [1, 2, 3] {
            let section = fit(&with_faces(&profile, size, depths, batter, seed)).unwrap();
            let wanted = depths.iter().filter(|depth| **depth > 0.0).count();
            assert_eq!(section.faces.len(), wanted, "{profile:?} {size:?} {depths:?}: {:?}", section.faces);
            // Where the face meets the curve without a kink, the level of the springing is less certain.
            let least = if profile == Profile::Semicircular { 0.3 } else { 0.06 };
            assert!(
                (section.rise() - size[1]).abs() < least,
                "{profile:?} {size:?} {depths:?}: {} {:?}",
                section.rise(),
                section.faces
            );
            assert!(
                (section.span() - size[0]).abs() < 0.04,
                "{profile:?} {size:?} {depths:?} {seed}: {} {:?}",
                section.span(),
                section.faces
            );
            assert!(
                section.faces.iter().all(|face| (face.top - 101.8).abs() < least + 0.06 && face.points > 5),
                "{:?}",
                section.faces
            );
        }
    }
}

#[test]
fn an_intrados_alone_has_no_faces() {
    for (profile, size) in [
        (Profile::Segmental, [8.0, 1.6]),
        (Profile::Semicircular, [6.0, 3.0]),
        (Profile::Elliptical, [9.0, 2.6]),
        (Profile::Pointed, [6.0, 3.9]),
        (Profile::Parabolic, [10.0, 2.0]),
    ] {
        for (seed, count, scatter) in [(1, 1000, 2e-3), (2, 300, 2e-3), (3, 100, 5e-3), (4, 3000, 1e-3)] {
            let (_, found) = faces::cut(&scanned(&profile, size, count, scatter, seed));
            assert!(found.is_empty(), "{profile:?} {count} {scatter}: {found:?}");
        }
    }
    // A barrel of thirty stones with flat faces.
    let stones = |k: usize, share: f64| {
        let at = |k: usize| {
            let angle = std::f64::consts::PI * (k as f64 / 30.0 - 0.5);
            [3.0 * angle.sin(), 3.0 * angle.cos()]
        };
        let (a, b) = (at(k), at(k + 1));
        [0, 1].map(|i| a[i] + share * (b[i] - a[i]))
    };
    let mut dice = Dice(9);
    let faceted: Vec<[f64; 2]> = (0..900)
        .map(|k| stones(k / 30, f64::from(u32::try_from(k % 30).unwrap()) / 29.0))
        .map(|[x, y]| [x + 2e-3 * (dice.roll() - 0.5), y + 2e-3 * (dice.roll() - 0.5)])
        .collect();
    let section = fit(&faceted).unwrap();
    assert!(section.faces.is_empty(), "{:?}", section.faces);
}

#[test]
fn a_point_that_is_given_twice_counts_once() {
    let mut points = scanned(&Profile::Elliptical, [9.0, 2.6], 150, 2e-3, 5);
    let once = fit(&points).unwrap();
    // A closed scan, and one that passes over its left half again.
    points.push(points[0]);
    points.extend(points.clone().iter().filter(|point| point[0] < 40.0).copied().collect::<Vec<_>>());
    let again = fit(&points).unwrap();
    assert_eq!(Section { repeated: 0, ..again.clone() }, once);
    assert!(once.repeated == 0 && again.repeated > 20, "{}", again.repeated);
    let few = [points[..6].to_vec(), points[..6].to_vec(), points[..6].to_vec()].concat();
    assert!(matches!(fit(&few), Err(SectionError::TooFew { count: 6, .. })), "{:?}", fit(&few));
}

#[test]
fn a_length_that_no_arch_has_names_the_unit_that_makes_one() {
    let table = |heading: &str, size: f64| {
        let points = scanned(&Profile::Segmental, [8.0, 1.6], 40, 0.0, 1);
        points.iter().fold(format!("{heading}\n"), |text, [x, y]| format!("{text}{},{}\n", x * size, y * size))
    };
    for (heading, size, unit, said) in [
        ("x_m,y_m", 1e3, None, "--unit mm"),
        ("x_mm,y_mm", 1.0, None, "--unit m"),
        ("x_m,y_m", 1.0 / 0.0254, LengthUnit::named("m"), "--unit in"),
        ("x_m,y_m", 1.0, LengthUnit::named("mm"), "--unit m"),
    ] {
        let error = read(&table(heading, size), unit).unwrap_err().to_string();
        assert!(
            error.contains(said) && error.contains("8.000 m") && error.contains("no arch"),
            "{heading} {size}: {error}"
        );
    }
    assert!(read(&table("x_m,y_m", 1e-6), None).unwrap_err().to_string().contains("along the bridge"));
    let taken = read(&table("x_m,y_m", 1e3), LengthUnit::named("mm")).unwrap();
    assert_eq!(taken.overruled, LengthUnit::named("m"));
    assert!((fit(&taken.points).unwrap().span() - 8.0).abs() < 1e-3);
}
