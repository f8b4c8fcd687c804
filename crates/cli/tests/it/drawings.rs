//! Block model files, drawings and conversions, as their users meet them.

use crate::stage::{Stage, number};
use drawing::{Item, Options, Sheet};
use serde_json::Value;

/// A stage with the example that has a drawing.
fn stage(name: &str) -> Stage {
    Stage::with_example(name, "drawing")
}

fn outlines(stage: &Stage, file: &str) -> Vec<Vec<[f64; 2]>> {
    let read = drawing::read(stage.read(file).as_bytes(), &Options::default());
    assert!(read.is_usable(), "{:?}", read.findings);
    read.drawing.outlines.into_iter().map(|outline| outline.points).collect()
}

fn code(answer: &Value) -> &str {
    answer["errors"][0]["code"].as_str().unwrap_or_default()
}

#[test]
fn a_drawing_is_checked_with_its_notes_and_drawn() {
    let stage = stage("drawing-check");
    let (answer, ending) = stage.object(&["check", "bridge/bridge.toml"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!((answer["blocks"].as_u64(), answer["layers"][1]["count"].as_u64()), (Some(64), Some(62)));
    let note = &answer["notes"][0];
    assert_eq!((note["code"].as_str(), note["layer"].as_str()), (Some("D206"), Some("ABUTMENT")));
    assert!(note["x_m"].is_f64() && note["entity"].as_str().is_some_and(|words| words.starts_with("LWPOLYLINE ")));
    assert!(stage.names("out/bridge").contains(&"bridge.svg".to_owned()));
}

#[test]
fn a_layer_without_an_entry_is_an_error_with_what_to_write() {
    let stage = stage("drawing-unmapped");
    let text = stage.read("bridge/bridge.toml").replace("name = \"RING\"", "name = \"RINGS\"");
    stage.write("bridge/bridge.toml", text);
    for command in ["check", "collapse"] {
        let ending = stage.run(&[command, "bridge/bridge.toml"]);
        assert_eq!(ending.code, Some(2));
        for part in [
            "error[D401]: layer RING of the drawing has no entry: 62 outlines, 0 circles",
            "name = \"RING\", role = \"block\"",
            "error[D402]: there is nothing on a layer RINGS",
            "file = \"arch.dxf\"",
        ] {
            assert!(ending.stderr.contains(part), "{part}\n--- is not in ---\n{}", ending.stderr);
        }
    }
    assert!(stage.names("out").is_empty(), "nothing is left behind");
}

#[test]
fn what_a_drawing_lacks_is_said_with_its_place() {
    let stage = stage("drawing-refused");
    let line =
        |layer: &str, points: &[[f64; 2]], closed| Item::Line { layer: layer.into(), points: points.into(), closed };
    let items = vec![
        line("RING", &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], false),
        line("ABUTMENT", &[[3.0, 0.0], [5.0, 0.0], [5.0, 1.0], [4.0, 1.0], [4.0, 2.0], [3.0, 2.0]], true),
    ];
    stage.write("bridge/arch.dxf", Sheet { layers: Vec::new(), items }.dxf());
    let (answer, ending) = stage.object(&["check", "bridge/bridge.toml"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(2), Some("unusable-input")));
    let codes: Vec<&str> =
        answer["errors"].as_array().into_iter().flatten().filter_map(|error| error["code"].as_str()).collect();
    assert_eq!(codes, ["D301", "D303"], "{answer}");
    assert_eq!((answer["errors"][1]["x_m"].as_f64(), answer["errors"][1]["y_m"].as_f64()), (Some(4.0), Some(1.0)));
    assert!(ending.stderr.contains("error[D303]") && ending.stderr.contains("the drawing cannot be used"));
    for error in codes {
        assert_eq!(stage.run(&["explain", error]).code, Some(0));
    }
    std::fs::remove_file(stage.folder.join("bridge/arch.dxf")).expect("the drawing");
    let (answer, _) = stage.object(&["check", "bridge/bridge.toml"]);
    assert_eq!((code(&answer), answer["errors"][0]["line"].is_u64()), ("D101", true), "{answer}");
}

#[test]
fn any_bytes_for_a_drawing_get_an_answer() {
    let stage = stage("drawing-bytes");
    for bytes in [&b""[..], b"0\n", b"AutoCAD Binary DXF\r\n", b"\xff\xfe", &[0u8; 4000], b"0\nSECTION\n2\nENTITIES\n"]
    {
        stage.write("bridge/arch.dxf", bytes);
        let (answer, ending) = stage.object(&["check", "bridge/bridge.toml"]);
        assert_eq!((ending.code, code(&answer)), (Some(2), "D101"), "{bytes:?}");
        assert!(!ending.stderr.contains("panicked"), "{}", ending.stderr);
    }
}

#[test]
fn results_come_as_drawings_too() {
    let stage = stage("drawing-results");
    let words = ["collapse", "bridge/bridge.toml", "--method", "limit", "--out", "out"];
    let (answer, ending) = stage.object(&words);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    for name in ["model.dxf", "deformed.dxf", "stress.dxf"] {
        assert!(answer["files"].as_array().is_some_and(|files| files.iter().any(|file| file == name)), "{answer}");
    }
    let model = drawing::read(
        stage.read("out/model.dxf").as_bytes(),
        &Options { ignored: vec!["LOADS".into()], ..Options::default() },
    );
    assert!(model.is_usable() && model.drawing.outlines.len() == 64);
    let bad = stage.object(&["collapse", "bridge/bridge.toml", "--displacement-scale", "0"]);
    assert_eq!(code(&bad.0), "F107");
    let arch = stage.object(&["collapse", "bridge/bridge.toml", "--analysis", "thickness"]);
    assert_eq!(code(&arch.0), "F108");
}

/// Blocks of a drawing belong to no ring: a hinge is named by the two blocks whose joint opens.
#[test]
fn hinges_between_drawn_blocks_are_named_by_their_blocks() {
    let stage = stage("drawing-hinges");
    let words = ["collapse", "bridge/bridge.toml", "--method", "limit", "--out", "out"];
    let (answer, ending) = stage.object(&words);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let hinges = answer["hinges"].as_array().expect("hinges");
    assert!(!hinges.is_empty() && hinges.iter().all(|hinge| hinge["edge"] == "other"), "{answer}");
    let page = stage.run(&[&words[..], &["--details"]].concat()).stdout;
    let table = stage.read("out/hinges.csv");
    for hinge in hinges {
        let side = |k: usize| hinge["between"][k].as_str().expect("a name");
        assert!([side(0), side(1)].iter().any(|name| name.starts_with("RING ")), "{hinge}");
        let place = format!("{:.2} (between {} and {})", number(hinge, "x_m"), side(0), side(1));
        assert!(page.contains(&place), "{place} is not in\n{page}");
        assert!(table.contains(&format!(",{},{}\n", side(0), side(1))), "{table}");
    }
    assert!(!page.contains("(other)"), "{page}");
}

#[test]
fn every_conversion_keeps_the_blocks() {
    let stage = stage("drawing-convert");
    let convert = |from: &str, to: &str| {
        let (answer, ending) = stage.object(&["convert", from, to]);
        assert_eq!(ending.code, Some(0), "{from} {to}: {}", ending.stderr);
        assert_eq!(answer["blocks"], 64);
    };
    convert("bridge/bridge.toml", "listed.toml");
    convert("bridge/bridge.toml", "model.dxf");
    convert("bridge/bridge.toml", "model.vtu");
    convert("bridge/arch.dxf", "clean.dxf");
    convert("bridge/arch.dxf", "drawn.vtu");
    convert("bridge/arch.dxf", "drawn.toml");
    convert("listed.toml", "listed.dxf");
    let drawn = outlines(&stage, "bridge/arch.dxf");
    for file in ["model.dxf", "clean.dxf", "listed.dxf"] {
        let found = outlines(&stage, file);
        assert_eq!(found.len(), drawn.len());
        let apart = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let far = found.iter().zip(&drawn).flat_map(|(a, b)| a.iter().zip(b)).map(|(a, b)| apart(a, b));
        assert!(far.fold(0.0, f64::max) <= 1e-9, "{file}");
    }
    assert!(stage.read("drawn.vtu").contains("UnstructuredGrid"));
    // Every block listed, the model carries the same to the last digit.
    let load = |file: &str| {
        let (answer, ending) = stage.object(&["collapse", file, "--method", "limit", "--out", "load"]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        number(&answer, "collapse_load_kn_per_m")
    };
    assert_eq!(load("listed.toml"), load("bridge/bridge.toml"));
}

#[test]
fn what_a_drawing_does_not_say_has_to_be_filled_in() {
    let stage = stage("drawing-skeleton");
    assert_eq!(stage.run(&["convert", "bridge/arch.dxf", "new.toml"]).code, Some(0));
    let (answer, _) = stage.object(&["check", "new.toml"]);
    let places = answer["errors"].as_array().expect("errors").len();
    assert!(places >= 5 && code(&answer).starts_with("B10"), "{answer}");
    let filled = stage
        .read("new.toml")
        .replace("TO FILL IN kg/m^3", "2100 kg/m^3")
        .replace("TO FILL IN MPa", "20 MPa")
        .replace("TO FILL IN deg", "35 deg");
    stage.write("new.toml", filled);
    let (answer, ending) = stage.object(&["check", "new.toml"]);
    assert_eq!((ending.code, answer["blocks"].as_u64()), (Some(0), Some(64)), "{}", ending.stderr);
}

#[test]
fn a_bridge_becomes_blocks_that_carry_the_same() {
    let stage = Stage::with_example("drawing-bridge", "bridgemill");
    assert_eq!(stage.run(&["convert", "bridge/case-2.toml", "blocks.toml"]).code, Some(0));
    assert_eq!(stage.run(&["convert", "bridge/case-2.toml", "blocks.dxf"]).code, Some(0));
    let load = |file: &str| number(&stage.object(&["collapse", file, "--method", "limit"]).0, "collapse_load_kn_per_m");
    let (bridge, blocks) = (load("bridge/case-2.toml"), load("blocks.toml"));
    // The solver's tolerance; the sum of the forces is rounded differently.
    assert!((bridge - blocks).abs() < 1e-6 * bridge, "{bridge} {blocks}");
    assert_eq!(outlines(&stage, "blocks.dxf").len(), 64);
}

#[test]
fn conversions_that_make_no_sense_and_files_that_exist_are_refused() {
    let stage = stage("drawing-misuse");
    for (from, to, expected) in [
        ("bridge/bridge.toml", "x.png", "F118"),
        ("bridge/bridge.toml", "x", "F118"),
        ("x.vtu", "x.dxf", "F118"),
        ("none.dxf", "x.toml", "F101"),
        ("none.toml", "x.dxf", "F101"),
        (".dxf", "x.toml", "F118"),
        ("bridge/arch.dxf", "bridge/bridge.toml", "F119"),
        ("bridge/arch.dxf", "bridge/arch.dxf", "F119"),
    ] {
        let (answer, ending) = stage.object(&["convert", from, to]);
        assert_eq!((ending.code, code(&answer)), (Some(2), expected), "{from} {to}: {}", ending.stderr);
    }
    assert!(stage.run(&["convert", "a.dxf", "b.png"]).stderr.contains("convert .toml to .dxf"));
    let before = (stage.read("bridge/bridge.toml"), stage.read("bridge/arch.dxf"));
    for input in ["bridge/bridge.toml", "bridge/../bridge/arch.dxf"] {
        let (answer, _) = stage.object(&["convert", "bridge/bridge.toml", input, "--overwrite"]);
        assert_eq!(code(&answer), "F119", "{input}");
    }
    assert_eq!(before, (stage.read("bridge/bridge.toml"), stage.read("bridge/arch.dxf")));
    stage.write("old.toml", "old");
    assert_eq!(stage.run(&["convert", "bridge/arch.dxf", "old.toml", "--overwrite"]).code, Some(0));
    assert!(stage.read("old.toml").contains("[[block]]"));
    let (answer, _) = stage.object(&["convert", "bridge/bridge.toml", "u.dxf", "--unit", "mm"]);
    assert_eq!(code(&answer), "F107");
}

#[test]
fn particles_are_read_converted_and_analysed_by_discrete_elements_alone() {
    let stage = Stage::new("drawing-particles");
    let floor = Item::Line {
        layer: "FLOOR".into(),
        points: vec![[-1.0, -1.0], [3.0, -1.0], [3.0, 0.0], [-1.0, 0.0]],
        closed: true,
    };
    let grain = |k: u32| Item::Circle { layer: "GRAINS".into(), centre: [0.5 + f64::from(k), 0.5], radius: 0.5 };
    stage.write("heap.dxf", Sheet { layers: Vec::new(), items: vec![floor, grain(0), grain(1)] }.dxf());
    let text = "[model]\nname = \"Heap\"\n[drawing]\nfile = \"heap.dxf\"\n\
        [[drawing.layer]]\nname = \"FLOOR\"\nrole = \"block\"\nmaterial = \"stone\"\n\
        [[drawing.layer]]\nname = \"GRAINS\"\nrole = \"particles\"\nmaterial = \"stone\"\n\
        [[material]]\nname = \"stone\"\ndensity = \"2000 kg/m^3\"\n[[joint]]\nfriction_angle = \"30 deg\"\ncohesion = \"0 kPa\"\n\
        [[load]]\nblock = \"FLOOR 1\"\nright = \"1 kN/m\"\n";
    stage.write("heap.toml", text);
    let (answer, ending) = stage.object(&["check", "heap.toml"]);
    assert_eq!((ending.code, answer["particles"].as_u64()), (Some(0), Some(2)), "{}", ending.stderr);
    let (answer, ending) = stage.object(&["collapse", "heap.toml"]);
    assert_eq!((ending.code, code(&answer)), (Some(2), "D406"));
    assert_eq!(stage.run(&["convert", "heap.toml", "listed.toml"]).code, Some(0));
    assert!(stage.read("listed.toml").contains("circles_m = [[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]]"));
    let (answer, _) = stage.object(&["convert", "listed.toml", "again.dxf"]);
    assert_eq!(answer["particles"], 2);
}

#[test]
fn a_heap_from_another_program_is_loaded_and_drawn_moved() {
    let stage = Stage::new("drawing-heap");
    let heap = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../drawing/tests/data/heap.dxf");
    stage.write("heap.dxf", std::fs::read(heap).expect("the drawing"));
    let text = "[model]\nname = \"Heap\"\n[drawing]\nfile = \"heap.dxf\"\n\
        [[drawing.layer]]\nname = \"FLOOR\"\nrole = \"support\"\nmaterial = \"stone\"\n\
        [[drawing.layer]]\nname = \"GRAINS\"\nrole = \"particles\"\nmaterial = \"gravel\"\n\
        [[block]]\nmaterial = \"stone\"\nrole = \"support\"\n\
        outline_m = [[-0.2, 0.0], [0.0, 0.0], [0.0, 1.0], [-0.2, 1.0]]\n\
        [[block]]\nmaterial = \"stone\"\nrole = \"support\"\n\
        outline_m = [[1.0, 0.0], [1.2, 0.0], [1.2, 1.0], [1.0, 1.0]]\n\
        [[block]]\nname = \"plate\"\nmaterial = \"stone\"\n\
        outline_m = [[0.05, 0.6], [0.95, 0.6], [0.95, 0.7], [0.05, 0.7]]\n\
        [[material]]\nname = \"stone\"\ndensity = \"2000 kg/m^3\"\n\
        [[material]]\nname = \"gravel\"\ndensity = \"1800 kg/m^3\"\n\
        [[joint]]\nnormal_stiffness = \"1 GPa/m\"\nshear_stiffness = \"0.4 GPa/m\"\n\
        friction_angle = \"30 deg\"\ncohesion = \"0 kPa\"\n\
        [[load]]\nblock = \"plate\"\ndown = \"10 kN/m\"\n\
        [analysis]\nmethod = \"dem\"\nload_step = \"10 kN/m\"\nload_limit = \"20 kN/m\"\n";
    stage.write("heap.toml", text);
    let (answer, ending) = stage.object(&["collapse", "heap.toml", "--out", "out"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!((answer["status"].as_str(), answer["particles"].as_u64()), (Some("stable-to-last-load"), Some(15)));
    for (name, layer, circles) in [("model", "PARTICLES-1", 15), ("deformed", "AS-BUILT-PARTICLES-1", 30)] {
        let read = drawing::read(stage.read(&format!("out/{name}.dxf")).as_bytes(), &Options::default());
        assert_eq!(read.drawing.circles.len(), circles, "{name}");
        assert_eq!(read.drawing.circles.iter().filter(|circle| circle.layer == layer).count(), 15, "{name}");
    }
    // The plate drawn into the uppermost grains.
    stage.write("crowded.toml", text.replace("[0.05, 0.6], [0.95, 0.6]", "[0.05, 0.5], [0.95, 0.5]"));
    let (answer, _) = stage.object(&["check", "crowded.toml"]);
    let words = answer["errors"][0]["message"].as_str().unwrap_or_default();
    assert!(
        code(&answer) == "D407" && words.contains("CIRCLE") && words.contains("m into the block plate"),
        "{answer}"
    );
}

/// The drawing that a collapse writes goes back in: its levels and arrows are no blocks, and are told.
#[test]
fn the_drawing_of_a_result_is_a_drawing_of_blocks() {
    let stage = Stage::with_example("drawing-back", "tiny");
    assert_eq!(stage.run(&["collapse", "bridge/bridge.toml", "--out", "out"]).code, Some(0));
    let (answer, ending) = stage.object(&["convert", "out/model.dxf", "back.toml"]);
    assert_eq!((ending.code, answer["blocks"].as_u64()), (Some(0), Some(23)), "{}", ending.stderr);
    let text = stage.read("back.toml");
    assert!(!text.contains("LOADS") && !text.contains("SURFACE"), "{text}");
    assert!(ending.stderr.contains("layer LOADS") && ending.stderr.contains("layer SURFACE"), "{}", ending.stderr);
}
