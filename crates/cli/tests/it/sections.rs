//! A surveyed section becomes a profile: fitted, told, drawn.

use crate::stage::{Stage, number};
use std::fmt::Write;

/// Points of a segment of 8 m by 1.6 m in millimetres, with a scatter that looks random, and two that are wrong.
fn scan() -> String {
    let (radius, half) = ((16.0 + 1.6 * 1.6) / 3.2, 4.0f64);
    let angle = (half / radius).asin();
    let mut table = "x [mm];y [mm]\n".to_owned();
    for k in 0..400 {
        let at = -angle + 2.0 * angle * f64::from(k) / 399.0;
        let scatter = 0.003 * (f64::from(k * k) * 0.7).sin()
            + if k == 130 { -0.09 } else { 0.0 }
            + if k == 300 { 0.05 } else { 0.0 };
        let r = radius + scatter;
        let (x, y) = (1e3 * (half + r * at.sin()), 1e3 * (1.6 - radius + r * at.cos()));
        let _ = writeln!(table, "{};{}", format!("{x:.1}").replace('.', ","), format!("{y:.1}").replace('.', ","));
    }
    table
}

#[test]
fn a_scan_becomes_a_bridge_file_that_carries_what_the_arch_does() {
    let stage = Stage::new("sections-scan");
    stage.write("scan.csv", scan());
    let (answer, ending) = stage.object(&["convert", "scan.csv", "scan.toml"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert!(
        (number(&answer, "span_m") - 8.0).abs() < 5e-3 && (number(&answer, "rise_m") - 1.6).abs() < 5e-3,
        "{answer}"
    );
    assert!((number(&answer, "scatter_mm") - 2.1).abs() < 0.2, "{answer}");
    let left_out = answer["left_out"].as_array().expect("points");
    assert_eq!(left_out.len(), 2, "{left_out:?}");
    assert!(
        answer["warnings"][0]["message"].as_str().is_some_and(|words| words.contains("2 points lie too far")),
        "{answer}"
    );
    // What a section does not say is asked for, one finding each.
    let text = stage.read("scan.toml");
    assert_eq!(
        stage.run(&["check", "scan.toml"]).stderr.matches("TO FILL IN").count(),
        2 * text.matches("\"TO FILL IN").count()
    );
    let filled = |text: &str| {
        let given = [
            ("width = \"TO FILL IN m", "width = \"4 m"),
            ("TO FILL IN m", "0.45 m"),
            ("TO FILL IN kg/m^3", "2100 kg/m^3"),
        ];
        let given = given.into_iter().chain([("TO FILL IN MPa", "8 MPa"), ("TO FILL IN deg", "31 deg")]);
        given.fold(text.to_owned(), |text, (from, to)| text.replace(from, to))
    };
    stage.write("scanned.toml", filled(&text));
    let (head, rest) = text.split_once("profile = \"measured\"").expect("a profile");
    let rest = rest.split_once("\n]\n").expect("the end of the points").1;
    stage.write(
        "drawn.toml",
        filled(&format!("{head}profile = \"segmental\"\nspan = \"8 m\"\nrise = \"1.6 m\"\n{rest}")),
    );
    let load = |file: &str| number(&stage.object(&["collapse", file]).0, "last_stable_load_kn_per_m");
    let (scanned, drawn) = (load("scanned.toml"), load("drawn.toml"));
    assert!((scanned / drawn - 1.0).abs() < 0.02, "{scanned} {drawn}");
    // The other two forms.
    assert_eq!(stage.run(&["convert", "scan.csv", "deviations.csv"]).code, Some(0));
    assert_eq!(stage.read("deviations.csv").matches("true").count(), 2);
    assert_eq!(stage.run(&["convert", "scan.csv", "scan.svg"]).code, Some(0));
    assert!(stage.read("scan.svg").contains("2 points (red) were left out"));
}

#[test]
fn what_is_no_section_is_refused_with_its_line() {
    let stage = Stage::new("sections-refused");
    stage.write("no-unit.csv", "0,0\n1,1\n");
    stage.write("word.csv", "x_m,y_m\n0,0\n1,one\n");
    stage.write("cloud.csv", "x_m,y_m,z_m\n0,0,0\n");
    stage.write("few.csv", "x_m,y_m\n0,0\n1,1\n2,0\n");
    for (file, words) in
        [("no-unit.csv", "--unit"), ("word.csv", "line 3"), ("cloud.csv", "3 columns"), ("few.csv", "too few")]
    {
        let (answer, ending) = stage.object(&["convert", file, "x.toml"]);
        assert_eq!(
            (ending.code, answer["errors"][0]["code"].as_str()),
            (Some(2), Some("F133")),
            "{file}: {}",
            ending.stderr
        );
        assert!(ending.stderr.contains(words), "{file}: {}", ending.stderr);
    }
    stage.write("scan.csv", scan());
    assert_eq!(stage.object(&["convert", "scan.csv", "scan.csv", "--overwrite"]).0["errors"][0]["code"], "F119");
    assert_eq!(stage.object(&["convert", "scan.csv", "x.toml", "--cut-concave"]).0["errors"][0]["code"], "F107");
}

#[test]
fn abutments_repeated_points_and_another_unit_are_told() {
    let stage = Stage::new("sections-faces");
    let mut table = scan();
    for k in 1..=29 {
        let _ = write!(table, "0;-{0}\n8000;-{0}\n", 50 * k);
    }
    let again: String = table.lines().skip(1).take(30).map(|line| format!("{line}\n")).collect();
    stage.write("scan.csv", table.clone() + &again);
    let (answer, ending) = stage.object(&["convert", "scan.csv", "scan.toml"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert!((number(&answer, "rise_m") - 1.6).abs() < 0.03, "{answer}");
    assert_eq!((answer["abutment_faces"].as_array().map(Vec::len), number(&answer, "repeated")), (Some(2), 30.0));
    assert!(
        ending.stderr.contains("faces of the abutments")
            && ending.stderr.contains("30 points at x = 0.00 m between y = -1.45 and 0.00 m"),
        "{}",
        ending.stderr
    );
    assert_eq!(stage.object(&["convert", "scan.csv", "scan.svg"]).1.code, Some(0));
    assert!(stage.read("scan.svg").contains("faces of the abutments (dashed) are no part of the arch"));
    // The same numbers as metres.
    stage.write("metres.csv", table.replace("[mm]", "[m]"));
    let (answer, ending) = stage.object(&["convert", "metres.csv", "metres.toml"]);
    assert_eq!((ending.code, answer["errors"].as_array().map(Vec::len)), (Some(2), Some(1)), "{}", ending.stderr);
    assert!(ending.stderr.contains("8002 m long") && ending.stderr.contains("--unit mm"), "{}", ending.stderr);
    let (answer, ending) = stage.object(&["convert", "metres.csv", "metres.toml", "--unit", "mm"]);
    assert!(
        (number(&answer, "span_m") - 8.0).abs() < 0.02 && ending.stderr.contains("the heading says m"),
        "{}",
        ending.stderr
    );
}

/// A LAS file (version 1.2, points of kind 0) as its specification has it, coordinates in millimetres.
fn las(points: &[[f64; 3]]) -> Vec<u8> {
    let mut file = b"LASF".to_vec();
    file.extend([0; 20]);
    file.extend([1, 2]);
    file.extend([0; 68]);
    file.extend(227_u16.to_le_bytes());
    file.extend(227_u32.to_le_bytes());
    file.extend(0_u32.to_le_bytes());
    file.push(0);
    file.extend(20_u16.to_le_bytes());
    file.extend(u32::try_from(points.len()).expect("few points").to_le_bytes());
    file.extend([0; 20]);
    file.extend([1e-3_f64; 3].into_iter().chain([0.0; 9]).flat_map(f64::to_le_bytes));
    for point in points {
        file.extend(point.iter().flat_map(|value| ((1e3 * value).round() as i32).to_le_bytes()));
        file.extend([0; 8]);
    }
    file
}

/// A barrel of 8 m by 1.6 m and 3 m wide, whose left springing line crosses (40, 70, 12) at its middle; it runs at 60 degrees to the axis of x. With it
/// water below and a road above.
fn barrel() -> Vec<[f64; 3]> {
    let radius: f64 = (16.0 + 1.6 * 1.6) / 3.2;
    let angle = (4.0 / radius).asin();
    let (sin, cos) = 60_f64.to_radians().sin_cos();
    let placed = |x: f64, across: f64, z: f64| [40.0 + x * cos - across * sin, 70.0 + x * sin + across * cos, z];
    let mut points = Vec::new();
    for k in 0..=800 {
        let at = angle * (f64::from(k) / 400.0 - 1.0);
        let scatter = 0.003 * (f64::from(k * k) * 0.7).sin();
        for w in -30..=30 {
            let across = 0.05 * f64::from(w);
            let r = radius + scatter;
            points.push(placed(4.0 + r * at.sin(), across, 12.0 + 1.6 - radius + r * at.cos()));
            points.push(placed(0.01 * f64::from(k), across, 11.5));
            points.push(placed(0.01 * f64::from(k), across, 14.6));
        }
    }
    points
}

#[test]
fn a_cloud_is_cut_along_a_line_and_fitted() {
    let stage = Stage::new("sections-cloud");
    stage.write("scan.las", las(&barrel()));
    let line = |from: f64, to: f64| {
        let [x0, x1] = [from, to].map(|x| 40.0 + x * 0.5);
        let [y0, y1] = [from, to].map(|x| 70.0 + x * 60_f64.to_radians().sin());
        format!("{x0:.3},{y0:.3},{x1:.3},{y1:.3}")
    };
    let along = line(-0.2, 8.2);
    let (answer, ending) =
        stage.object(&["convert", "scan.las", "b.toml", "--line", &along, "--levels", "11.8,14", "--slab", "0.12 m"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert!(
        (number(&answer, "span_m") - 8.0).abs() < 0.01 && (number(&answer, "rise_m") - 1.6).abs() < 0.01,
        "{answer}"
    );
    // Of 61 lines along the barrel the three within 60 mm of its middle.
    assert_eq!(answer["cloud_points_taken"], 3 * 801, "{answer}");
    assert!(stage.read("b.toml").contains("profile = \"measured\""));
    // In the other direction it is the same arch.
    let back = line(8.2, -0.2);
    let (mirrored, _) = stage.object(&["convert", "scan.las", "c.toml", "--line", &back, "--levels", "11.8,14"]);
    // The points scatter by three millimetres, and fall into other squares.
    assert!((number(&mirrored, "rise_m") - number(&answer, "rise_m")).abs() < 3e-3, "{mirrored}");

    let refused = |more: &[&str]| {
        let (answer, ending) = stage.object(&[&["convert", "scan.las", "d.toml"], more].concat());
        assert_eq!(ending.code, Some(2), "{answer}");
        answer["errors"][0].to_string()
    };
    assert!(refused(&[]).contains("z from 11.50 to 14.60"), "{}", refused(&[]));
    let away = refused(&["--line", "0,0,8,0"]);
    assert!(away.contains("no point lies within 50 mm") && away.contains("z from 11.50"), "{away}");
    assert!(refused(&["--line", "0,0,8"]).contains("is not 4 numbers"));
    // Water, arch and road together are no arch, and what helps is said.
    assert!(refused(&["--line", &along]).contains("--levels"), "{}", refused(&["--line", &along]));
    stage.write("torn.e57", "no cloud");
    let (torn, _) = stage.object(&["convert", "torn.e57", "d.toml", "--line", &along]);
    assert_eq!(torn["errors"][0]["code"], "F138", "{torn}");
}
