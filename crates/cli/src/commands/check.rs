//! `extrados check`: reads, reports, draws; computes nothing but what a load test would tell of the parameters that are sought by it.

use super::model;
use super::source::{Source, read_text};
use crate::args::Check;
use crate::desk::Desk;
use crate::folder;
use crate::report::Report;
use crate::results::{self, Written};
use crate::status::Status;
use crate::summary;
use crate::watcher::watched;
use assess::analysis::{self, calibrate, passage};
use bridge::{Bridge, Strip};
use extrados::Refusal;
use findings::words::counted;
use serde_json::{Value, json};
use std::fmt::Write;
use structure::discretise::mesh::{MOST_NODES, MeshError, MeshOptions, Meshed};
use structure::discretise::springings::{are_level, springings};

/// Reads the file and draws the bridge.
pub(super) fn run(desk: &mut Desk, arguments: &Check) -> Result<Report, Refusal> {
    if bridge::is_block_file(&read_text(&arguments.file)?) {
        return model::check(desk, arguments);
    }
    let source = Source::open(desk, &arguments.file)?;
    let Some(bridge) = source.bridge() else { return Ok(source.report(Status::UnusableInput)) };
    let picture = analysis::as_built(bridge)?;
    planned(bridge)?;
    let folder = source.folder(&folder::named(&arguments.out, &arguments.file), "check")?;
    let mut drawings = vec![("bridge".to_owned(), figures::bridge_as_drawn(&picture))];
    let mut files = Vec::new();
    let meshed = mesh(bridge);
    if let Some(Ok(meshed)) = &meshed {
        let picture = meshed.picture();
        drawings.push(("mesh".to_owned(), figures::mesh(&bridge.name, &picture)));
        files.push(figures::File { name: "mesh.vtu".into(), bytes: figures::vtk::mesh(&picture).into_bytes() });
    }
    let names = results::put(&folder, Written { drawings, files })?;
    let shown = folder.path().display().to_string();
    let report = source
        .report(Status::Completed)
        .with("bridge", bridge.name.as_str())
        .with("width_m", bridge.width)
        .with("spans", bridge.spans.iter().map(span).collect::<Vec<Value>>())
        .with("piers", bridge.piers.len())
        .with("blocks", picture.shapes.len())
        .with("cover_depth_m", bridge.cover.depth)
        .with(
            "loads",
            bridge
                .loads
                .iter()
                .map(|load| json!({ "name": load.name, "position_m": load.position }))
                .collect::<Vec<Value>>(),
        )
        .with("out", shown.as_str())
        .with("files", names)
        .saying(summary(bridge, picture.shapes.len(), meshed.as_ref(), &shown));
    let mut report = match &meshed {
        Some(Ok(meshed)) => report.with("mesh", quality(meshed)),
        _ => report,
    };
    for one in assess::plan_facts::doubtful_files(bridge) {
        report.warn(&mut desk.screen, &one.code, &format!("{}, {}: {}", one.file, one.at, one.told));
    }
    match watched(desk.screen.quiet, |spectator| extrados::plan_load_test(&source.project, spectator)) {
        Ok(Some(plan)) => report = report.with("plan", plan.object()).adding(&summary::plan(&plan)),
        Ok(None) => {}
        Err(refusal) => {
            report.warn(
                &mut desk.screen,
                refusal.code,
                &format!("the load test cannot be planned yet: {}", refusal.message),
            );
        }
    }
    // Records come after their file has been written, so that missing ones are a doubt.
    if let Err(refusal) = source.project.records() {
        report.warn(&mut desk.screen, refusal.code, &format!("update cannot use this file yet: {}", refusal.message));
    }
    Ok(report)
}

/// Refuses what the command that the file is made for would refuse before it computes.
fn planned(bridge: &Bridge) -> Result<(), Refusal> {
    analysis::planned(bridge)?;
    if bridge.calibration.wanted_modulus.is_some() {
        calibrate::planned(bridge)?;
    }
    if bridge.passage.is_none() && bridge.load_test.is_none() {
        return Ok(());
    }
    match structure::discretise::mesh::mesh_with(bridge, options(bridge)) {
        // What is too large to draw is not made here; what is too large to answer is refused.
        Err(MeshError::TooFine { nodes, .. }) if nodes <= MOST_NODES => Ok(()),
        Err(MeshError::TooFine { nodes, .. }) => {
            let error = MeshError::TooFine { nodes, most: MOST_NODES };
            Err(Refusal::new("F124", error.to_string(), "give a larger `size` in [mesh]"))
        }
        _ => {
            if bridge.passage.is_some() {
                passage::setup(bridge)?;
            }
            if bridge.load_test.is_some() {
                passage::at_rest::setup(bridge)?;
            }
            Ok(())
        }
    }
}

/// Most nodes of a mesh that is made for a drawing: some seconds, and less than a gigabyte.
const MOST_DRAWN: usize = 100_000;

fn options(bridge: &Bridge) -> MeshOptions {
    MeshOptions { most_nodes: MOST_DRAWN, ..MeshOptions::of(bridge) }
}

/// The finite element mesh of a file that describes what only that model reads.
fn mesh(bridge: &Bridge) -> Option<Result<Meshed, MeshError>> {
    (bridge.service != bridge::Service::of_cover(&bridge.cover))
        .then(|| structure::discretise::mesh::mesh_with(bridge, options(bridge)))
}

fn quality(meshed: &Meshed) -> Value {
    let q = &meshed.quality;
    json!({
        "nodes": q.nodes,
        "elements": q.quads,
        "degrees_of_freedom": q.degrees_of_freedom,
        "facing_pairs": q.pairs,
        "least_scaled_jacobian": q.scaled_jacobian,
        "mean_scaled_jacobian": q.mean_scaled_jacobian,
        "largest_aspect_ratio": q.aspect_ratio,
        "shortest_side_m": q.sides[0],
        "longest_side_m": q.sides[1],
    })
}

fn span(span: &bridge::Span) -> Value {
    let ring = |ring: &bridge::Ring| {
        json!({
            "crown_thickness_m": ring.crown_thickness,
            "springing_thickness_m": ring.springing_thickness,
            "voussoirs": ring.voussoirs,
        })
    };
    json!({
        "profile": span.profile.word(),
        "span_m": span.span,
        "rise_m": span.rise,
        "right_springing_m": span.right_springing,
        "rings": span.rings.iter().map(ring).collect::<Vec<Value>>(),
    })
}

fn summary(bridge: &Bridge, blocks: usize, meshed: Option<&Result<Meshed, MeshError>>, out: &str) -> String {
    let mut page = format!("{}, {:.2} m wide, {}\n\n", bridge.name, bridge.width, counted(blocks, "block"));
    let _ = writeln!(page, "  span  profile        span [m]  rise [m]  span/rise  ring at crown [m]  voussoirs");
    for (index, one) in bridge.spans.iter().enumerate() {
        let thickness: f64 = one.rings.iter().map(|ring| ring.crown_thickness).sum();
        let rings = if one.rings.len() > 1 { format!(" in {} rings", one.rings.len()) } else { String::new() };
        let voussoirs: usize = one.rings.iter().map(|ring| ring.voussoirs).sum();
        let _ = writeln!(
            page,
            "  {:>4}  {:<13}  {:>8.3}  {:>8.3}  {:>9.2}  {thickness:>17.3}  {voussoirs:>9}{rings}",
            index + 1,
            one.profile.word(),
            one.span,
            one.rise,
            one.span / one.rise
        );
    }
    for (index, [left, right]) in springings(bridge).into_iter().enumerate() {
        if !are_level(bridge) {
            let _ = writeln!(page, "  span {}: springings at {:+.3} m and {:+.3} m", index + 1, left.y, right.y);
        }
    }
    for (index, pier) in bridge.piers.iter().enumerate() {
        let _ = writeln!(
            page,
            "  pier {}: {:.2} m wide ({:.2} m at the foundation), {:.2} m high, {} courses",
            index + 1,
            pier.width,
            pier.base_width,
            pier.height,
            pier.courses
        );
    }
    let layers = bridge.cover.layers.len();
    if layers > 0 {
        let least = if bridge.cover.road.is_some() { "at least " } else { "" };
        let _ =
            writeln!(page, "  cover {least}{:.3} m above the crown, {}", bridge.cover.depth, counted(layers, "layer"));
    } else {
        page += "  no cover: loads act on the extrados\n";
    }
    if let Some(wall) = &bridge.spandrel_wall {
        let _ = writeln!(
            page,
            "  spandrel walls {:.2} m thick together, of bricks of {:.3} x {:.3} m",
            wall.thickness, wall.brick_length, wall.brick_height
        );
        let strip = match bridge.plan.strip {
            Strip::Fill => "the strip between the walls; the drawing leaves them out",
            Strip::Wall => "the strip of the walls",
            Strip::Both => "both strips; the drawing shows that of the walls",
        };
        let _ = writeln!(page, "  analysed: {strip}");
    }
    for load in &bridge.loads {
        let _ = writeln!(page, "  load: {} at {:.3} m from the left springing", load.name, load.position);
    }
    if let Some(passage) = &bridge.passage {
        let axles = passage.train.axles(bridge.gravity);
        let weight: f64 = axles.iter().map(|axle| axle.force).sum();
        let _ = writeln!(
            page,
            "  train: {}, {} over {:.1} m, {:.0} kN, at {:.1} km/h; {}",
            passage.train.name,
            counted(axles.len(), "axle"),
            passage.train.wheelbase(),
            weight / 1e3,
            3.6 * passage.plan.speed,
            counted(if passage.sensors.is_empty() { 6 } else { passage.sensors.len() }, "sensor")
        );
    }
    if let Some(test) = &bridge.load_test {
        let read = test.readings.values.iter().flatten().flatten().count();
        let _ = writeln!(
            page,
            "  load test: {}, {}, {}",
            counted(test.positions.len(), "position"),
            counted(test.sensors.len(), "sensor"),
            if read > 0 { counted(read, "reading") } else { "no readings yet".to_owned() }
        );
    }
    match meshed {
        Some(Ok(meshed)) => {
            let _ = writeln!(page, "  finite element mesh: {}", meshed.quality.words());
        }
        Some(Err(MeshError::TooFine { nodes, most })) => {
            let _ = writeln!(page, "  finite element mesh: about {nodes} nodes, not drawn: {most} at the most are");
        }
        Some(Err(error)) => {
            let _ = writeln!(page, "  no finite element mesh: {error}");
        }
        None => {}
    }
    let _ = writeln!(page, "\nThe file can be used. The bridge is drawn in {out}");
    page
}
