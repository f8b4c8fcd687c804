//! What goes to other programs and comes from them: models for checkers, road profiles.

use crate::stage::{Stage, number};
use std::path::PathBuf;
use std::process::Command;

/// An example of the repository.
fn example(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    path.canonicalize().expect("an example").display().to_string()
}

/// Rows of a table, each with the cells of its named columns.
fn rows(stage: &Stage, file: &str, columns: &[&str]) -> Vec<Vec<String>> {
    let text = stage.read(file);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let heads = reader.headers().expect("a heading").clone();
    let places: Vec<usize> =
        columns.iter().map(|name| heads.iter().position(|head| head == *name).expect("a column")).collect();
    let row = |row: csv::StringRecord| places.iter().map(|&k| row[k].to_owned()).collect();
    reader.records().map(|found| row(found.expect("a row"))).collect()
}

fn value(cell: &str) -> f64 {
    cell.parse().expect("a number")
}

/// The statics of a bridge file, as the report tells them.
fn statics(file: &str) -> outcome::statics::Statics {
    let text = std::fs::read(file).expect("a file");
    assess::analysis::statics(&bridge::read(&text).bridge.expect("a bridge")).expect("statics")
}

/// What the tables weigh is what our statics weigh, and the reactions of our statics balance the tables' weights about a springing.
#[test]
fn tables_for_checkers_weigh_what_our_statics_weigh_and_balance_its_reactions() {
    for file in ["bridgemill/case-1.toml", "tiny/bridge.toml"] {
        let stage = Stage::new("exchange-tables");
        let file = example(file);
        let (answer, ending) = stage.object(&["convert", &file, "model.csv"]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        let statics = statics(&file);
        let total = 1e-3 * statics.total();
        assert!((number(&answer, "dead_load_kn_per_m") / total - 1.0).abs() < 1e-9, "{answer} {total}");
        let blocks =
            rows(&stage, "model-blocks.csv", &["block", "support", "centroid_x_m", "centroid_y_m", "weight_kn_per_m"]);
        let held = |name: &str| blocks.iter().any(|block| block[0] == name && block[1] == "yes");
        let loads =
            rows(&stage, "model-loads.csv", &["block", "load", "x_m", "y_m", "down_kn_per_m", "right_kn_per_m"]);
        let kinds = rows(&stage, "model-loads.csv", &["kind"]);
        // Every weight: how large it is, and where.
        let own = blocks.iter().filter(|block| block[1] == "no").map(|block| (value(&block[4]), value(&block[2])));
        let cover = loads.iter().zip(&kinds).filter(|(load, kind)| kind[0] == "permanent" && !held(&load[0]));
        let weights: Vec<(f64, f64)> = own.chain(cover.map(|(load, _)| (value(&load[4]), value(&load[2])))).collect();
        let sum: f64 = weights.iter().map(|one| one.0).sum();
        assert!((sum / total - 1.0).abs() < 1e-9, "{sum} {total}");
        // Corners are those of the areas.
        let areas = rows(&stage, "model-blocks.csv", &["block", "area_m2"]);
        let corners = rows(&stage, "model-corners.csv", &["block", "x_m", "y_m"]);
        for area in &areas {
            let own: Vec<[f64; 2]> =
                corners.iter().filter(|c| c[0] == area[0]).map(|c| [value(&c[1]), value(&c[2])]).collect();
            let twice: f64 = (0..own.len())
                .map(|k| (own[k], own[(k + 1) % own.len()]))
                .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
                .sum();
            assert!((0.5 * twice - value(&area[1])).abs() < 1e-9, "{area:?}");
        }
        // Both springings: joints of a support and a free block, the left one first.
        let joints = rows(&stage, "model-joints.csv", &["first", "second", "x1_m", "y1_m", "x2_m", "y2_m"]);
        let mut feet: Vec<[f64; 2]> = joints
            .iter()
            .filter(|joint| held(&joint[0]) || held(&joint[1]))
            .map(|joint| [0.5 * (value(&joint[2]) + value(&joint[4])), 0.5 * (value(&joint[3]) + value(&joint[5]))])
            .collect();
        feet.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let [left, right] = feet[..] else { panic!("{} springings of one span", feet.len()) };
        // Moments about the middle of the left joint: weights, the right reaction, and the moments of both in their joints, which are
        // equal and opposite where bridge and weights are symmetrical.
        let [a, b] = [&statics.reactions[0], &statics.reactions[1]];
        assert!((a.vertical + b.vertical - 1e3 * total).abs() < 1e-6 * 1e3 * total);
        assert!((a.horizontal - b.horizontal).abs() < 1e-6 * a.horizontal, "no weight pushes sideways");
        let of_weights: f64 = weights.iter().map(|(weight, x)| 1e3 * weight * (x - left[0])).sum();
        let of_right = b.vertical * (right[0] - left[0]);
        let rest = (of_weights - of_right) / of_weights;
        assert!(rest.abs() < 1e-6, "{file}: moments leave {rest}");
    }
}

/// The script holds the lists of the tables; OpenSees, where there is one, finds our reactions with it.
#[test]
#[ignore = "needs Python with openseespy, named in EXTRADOS_OPENSEES"]
fn opensees_finds_our_reactions() {
    let python = std::env::var("EXTRADOS_OPENSEES").expect("EXTRADOS_OPENSEES names a Python with openseespy");
    let stage = Stage::new("exchange-opensees");
    let file = example("bridgemill/case-1.toml");
    stage.object(&["convert", &file, "model.py"]);
    let run = Command::new(python).arg("model.py").current_dir(&stage.folder).output().expect("Python");
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(run.status.success(), "{said}{}", String::from_utf8_lossy(&run.stderr));
    // "… right R up U kN/m"
    let of = |line: &str| {
        let words: Vec<&str> = line.split_whitespace().rev().collect();
        [words[3], words[1]].map(value)
    };
    let reactions: Vec<[f64; 2]> = said.lines().filter(|line| line.starts_with("reaction")).map(of).collect();
    let statics = statics(&file);
    assert_eq!(reactions.len(), 2, "{said}");
    for (found, ours) in reactions.iter().zip(&statics.reactions) {
        assert!((1e3 * found[1] / ours.vertical - 1.0).abs() < 1e-5, "{said} {ours:?}");
        // Fibres in the joints of the one model, straight lines of stress in the other: both are an elastic arch.
        assert!((1e3 * found[0].abs() / ours.horizontal - 1.0).abs() < 1e-3, "{said} {ours:?}");
    }
}

/// Two grades and a crest between them, the bridge on its top.
const ALIGNMENT: &str = "<?xml version=\"1.0\"?>\n<LandXML xmlns=\"http://www.landxml.org/schema/LandXML-1.2\" version=\"1.2\">\n\
    <Units><Metric linearUnit=\"meter\"/></Units><Alignments>\n<Alignment name=\"B1\" length=\"900\" staStart=\"1000\"><Profile>\n\
    <ProfAlign name=\"design\"><PVI>1000 100</PVI><ParaCurve length=\"100\">1200 106</ParaCurve><PVI>1900 92</PVI></ProfAlign>\n\
    <ProfSurf name=\"ground\"><PntList2D>1000 99 1900 90</PntList2D></ProfSurf></Profile></Alignment></Alignments></LandXML>";

/// The surface of the bridge file lies where the closed form of the parabola has it.
#[test]
fn a_profile_becomes_the_road_of_a_bridge_file() {
    let stage = Stage::new("exchange-road");
    stage.write("b1.xml", ALIGNMENT);
    let convert = ["convert", "b1.xml", "road.toml", "--station", "1190 m", "--springing-level", "101.2 m"];
    let (several, _) = stage.object(&convert);
    let said = several["errors"][0].to_string();
    assert!(said.contains("F137") && said.contains("B1 / design") && said.contains("B1 / ground"), "{said}");
    let (nowhere, _) = stage.object(&["convert", "b1.xml", "road.toml", "--profile", "design"]);
    assert!(nowhere["errors"][0].to_string().contains("--station"), "{nowhere}");
    let (answer, ending) = stage.object(&[&convert[..], &["--profile", "design"]].concat());
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    // 3 % and -2 %: 104.5 + 0.03 x - 0.05 x^2 / 200, 40 m after the curve's beginning.
    assert!((number(&answer, "level_m") - (104.5 + 0.03 * 40.0 - 0.05 * 1600.0 / 200.0)).abs() < 1e-3, "{answer}");
    let text = "[bridge]\nname = \"B1\"\nwidth = \"5 m\"\n[[span]]\nprofile = \"segmental\"\nspan = \"8 m\"\nrise = \"2 m\"\nthickness = \"0.45 m\"\n\
        voussoirs = 31\n[[cover]]\nlayer = \"fill\"\ndensity = \"1900 kg/m^3\"\n[masonry]\ndensity = \"2200 kg/m^3\"\ncompressive_strength = \"5 MPa\"\n\
        [joint]\nfriction_angle = \"30 deg\"\ncohesion = \"0 kPa\"\n[dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n[[load]]\nkind = \"knife-edge\"\nforce = \"1 kN/m\"\nlength = \"0.3 m\"\n\
        at = \"1/4 of span 1\"\n[analysis]\nmethod = \"limit\"\n";
    stage.write("bridge.toml", format!("{text}\n{}", stage.read("road.toml")));
    let ending = stage.run(&["check", "bridge.toml"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let bridge = bridge::read(stage.read("bridge.toml").as_bytes()).bridge.expect("a bridge");
    let road = bridge.cover.road.expect("a road");
    for x in [0.0, 4.0, 8.0_f64] {
        let along = 40.0 + x;
        let exact = 104.5 + 0.03 * along - 0.05 * along * along / 200.0 - 101.2;
        assert!((road.level(x) - exact).abs() < 1.1e-3, "{x}: {} {exact}", road.level(x));
    }
    let beside = stage.run(&["convert", "b1.xml", "other.toml", "--profile", "design", "--station", "10 m"]).stderr;
    assert!(beside.contains("lies beside the profile") && beside.contains("1000.000 to 1900.000 m"), "{beside}");
    stage.write("other.xml", "<gpx/>");
    assert!(stage.run(&["convert", "other.xml", "x.toml"]).stderr.contains("<gpx> and not <LandXML>"));
}

/// An intrados drawn as one open line, by an arc and by points: 8 m by 1.6 m.
#[test]
fn an_open_line_of_a_drawing_is_an_intrados() {
    let stage = Stage::new("exchange-intrados");
    let (radius, half) = ((16.0 + 1.6 * 1.6) / 3.2, 4.0_f64);
    let angle = (half / radius).asin();
    let at = |k: u32| -angle + 2.0 * angle * f64::from(k) / 40.0;
    let points: Vec<[f64; 2]> =
        (0..=40).map(|k| [half + radius * at(k).sin(), 1.6 - radius + radius * at(k).cos()]).collect();
    let mut sheet = drawing::Sheet::default();
    sheet.layer("INTRADOS", 7);
    sheet.items.push(drawing::Item::Line { layer: "INTRADOS".into(), points: points.clone(), closed: false });
    stage.write("line.dxf", sheet.dxf());
    let (answer, ending) = stage.object(&["convert", "line.dxf", "line.toml"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert!(
        (number(&answer, "span_m") - 8.0).abs() < 1e-4 && (number(&answer, "rise_m") - 1.6).abs() < 1e-4,
        "{answer}"
    );
    assert!((number(&answer, "circle_radius_m") - radius).abs() < 1e-3, "{answer}");
    assert!(stage.read("line.toml").contains("profile = \"measured\""));
    // Entities in plain text: an arc, and the same as points.
    let file = |entities: &str| {
        format!(
            "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n"
        )
    };
    let degrees = angle.to_degrees();
    let arc = format!(
        "0\nARC\n8\nA\n10\n4\n20\n{}\n40\n{radius}\n50\n{}\n51\n{}\n",
        1.6 - radius,
        90.0 - degrees,
        90.0 + degrees
    );
    let single: String = points.iter().map(|p| format!("0\nPOINT\n8\nP\n10\n{}\n20\n{}\n", p[0], p[1])).collect();
    for (name, entities) in [("arc.dxf", &arc), ("points.dxf", &single)] {
        stage.write(name, file(entities));
        let (answer, ending) = stage.object(&["convert", name, &name.replace("dxf", "toml")]);
        assert_eq!(ending.code, Some(0), "{name}: {}", ending.stderr);
        assert!((number(&answer, "rise_m") - 1.6).abs() < 2e-3, "{name}: {answer}");
    }
    // Too little of a line says what to draw.
    stage.write("short.dxf", file("0\nLINE\n8\nA\n10\n0\n20\n0\n11\n8\n21\n0\n"));
    let said = stage.run(&["convert", "short.dxf", "short.toml"]).stderr;
    assert!(said.contains("F133") && said.contains("one open line"), "{said}");
}
