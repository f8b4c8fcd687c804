//! Drawings for CAD programs, read back.

mod sample;

use drawing::{Circle, Options, Outline};

/// Outlines and circles of a sheet; lines that stay open (arrows, forces, thrust) are passed over.
fn read(sheet: &drawing::Sheet) -> (Vec<Outline>, Vec<Circle>) {
    let open = |item: &drawing::Item| match item {
        drawing::Item::Line { layer, closed: false, .. } => Some(layer.clone()),
        _ => None,
    };
    let options = Options { ignored: sheet.items.iter().filter_map(open).collect(), ..Options::default() };
    let read = drawing::read(&sheet.dxf(), &options);
    // Blocks moved over one another overlap; everything else must be in order.
    assert!(read.findings.iter().all(|f| f.code != "D101" && f.code != "D103"), "{:?}", read.findings);
    (read.drawing.outlines, read.drawing.circles)
}

#[test]
fn the_model_comes_back_on_the_layers_of_its_roles() {
    for (name, picture) in sample::every().into_iter().filter(|(_, picture)| !picture.shapes.is_empty()) {
        let (outlines, _) = read(&figures::dxf::model(&picture));
        // Sliver outlines of samples that are no blocks may be refused; what is read must be what was drawn.
        for outline in &outlines {
            let drawn = picture.shapes.iter().find(|shape| {
                outline.points.iter().all(|p| shape.outline.iter().any(|q| (p[0] - q[0]).hypot(p[1] - q[1]) <= 1e-9))
            });
            assert!(drawn.is_some(), "{name}: {outline:?}");
        }
        assert!(!outlines.is_empty(), "{name}");
    }
    let arch = sample::arch();
    let sheet = figures::dxf::model(&arch);
    let (outlines, _) = read(&sheet);
    assert_eq!(outlines.len(), arch.shapes.len());
    assert!(sheet.layers.iter().any(|layer| layer.name == "VOUSSOIR"));
    assert!(sheet.layers.iter().any(|layer| layer.name == "LOADS"));
}

#[test]
fn displacements_are_drawn_as_many_times_larger_as_asked() {
    let arch = sample::arch();
    let stable = arch.last_stable.unwrap();
    let at = |scale: f64| {
        let sheet = figures::dxf::deformed(&arch, Some(scale)).unwrap();
        let layer = format!("LAST-STABLE-X{scale}");
        let first = sheet.items.iter().find_map(|item| match item {
            drawing::Item::Line { layer: own, points, .. } if *own == layer => Some(points.clone()),
            _ => None,
        });
        first.unwrap()
    };
    let moved = arch.shapes.iter().zip(&arch.snapshots[stable].motions);
    let (shape, _) = moved.into_iter().find(|(s, m)| !s.held || **m != Default::default()).unwrap();
    for k in 0..shape.outline.len() {
        for axis in 0..2 {
            let (one, ten) = (at(1.0)[k][axis] - shape.outline[k][axis], at(10.0)[k][axis] - shape.outline[k][axis]);
            assert!((ten - 10.0 * one).abs() < 1e-9, "{one} {ten}");
        }
    }
    let sheet = figures::dxf::deformed(&arch, None).unwrap();
    let circles = sheet.items.iter().filter(|item| matches!(item, drawing::Item::Circle { .. })).count();
    assert_eq!(circles, arch.hinges.len());
}

#[test]
fn blocks_lie_on_the_layer_of_their_stress() {
    let arch = sample::arch();
    let state = &arch.snapshots[arch.last_stable.unwrap()];
    let sheet = figures::dxf::stress(&arch).unwrap();
    let mut count = 0;
    for (k, shape) in arch.shapes.iter().enumerate().filter(|(_, shape)| !shape.held) {
        let layer = sheet.items.iter().find_map(|item| match item {
            drawing::Item::Line { layer, points, .. } if *points == shape.outline => Some(layer.clone()),
            _ => None,
        });
        let layer = layer.unwrap();
        let bounds: Vec<f64> = layer.split('-').filter_map(|word| word.parse().ok()).collect();
        let stress = figures::most_compressive(state.stresses[k]) / 1e6;
        assert!(layer.starts_with("STRESS-") && bounds.len() == 2, "{layer}");
        assert!((bounds[0] <= stress || bounds[0] == 0.0) && stress <= bounds[1] * (1.0 + 1e-9), "{layer}: {stress}");
        count += 1;
    }
    assert!(count > 3);
    let has = |start: &str| sheet.layers.iter().any(|layer| layer.name.starts_with(start));
    assert!(has("CONTACT-FORCES-1M-IS-") && has("THRUST-LINE"));
}

#[test]
fn the_same_picture_gives_the_same_files() {
    for (name, picture) in sample::every() {
        let files = figures::dxf::drawings(&picture, None);
        assert_eq!(files, figures::dxf::drawings(&picture, None), "{name}");
        assert_eq!(files[0].name, "model.dxf");
    }
    assert_eq!(figures::dxf::drawings(&Default::default(), None).len(), 1, "an empty picture has an empty model");
}
