//! A block model as a script for OpenSees.

use super::Scene;
use super::listing::Listing;
use std::fmt::Write;

/// Modulus of blocks of which the file gives none [Pa].
const MODULUS: f64 = 10e9;
/// Shear modulus over modulus, with a Poisson's ratio of 0.2.
const SHEAR: f64 = 1.0 / 2.4;

/// What the script does with its lists.
const BUILD: &str = include_str!("opensees.py");

/// The script: its lists, then how they are built and pushed. `none` says of what of the bridge it holds nothing, a sentence each.
pub fn opensees(scene: &Scene, listing: &Listing<'_>, none: &[String]) -> String {
    let given = scene.materials.iter().filter_map(|material| material.masonry.elastic_modulus).next();
    let modulus = given.unwrap_or(MODULUS);
    let mut page = format!(
        "\"\"\"{}: rigid blocks on joints that take no tension, for OpenSees.\n\n",
        scene.name.replace(['\\', '"'], "'")
    );
    page += "    pip install openseespy\n    python THIS_FILE\n\nLengths are in metres, forces in kN per metre of width, y up. ";
    page += "Joints are fibres; friction is not part of them and is compared afterwards.\n";
    for sentence in none {
        let _ = writeln!(page, "{sentence}");
    }
    page += "\"\"\"\n\nimport openseespy.opensees as ops\n\n";
    let assumed = if given.is_some() { "" } else { ", assumed: the file gives none" };
    let _ = writeln!(page, "MODULUS = {:?}  # of the blocks [kN/m2]{assumed}", 1e-3 * modulus);
    let _ = writeln!(
        page,
        "SHEAR = {:?}  # shear modulus over modulus, assumed: Poisson's ratio of 0.2",
        (1e6 * SHEAR).round() / 1e6
    );
    page += "\n# Name, support, x and y of the centre of mass, weight.\nBLOCKS = [\n";
    for b in &listing.blocks {
        let held = if b.held { "True" } else { "False" };
        let _ = writeln!(
            page,
            "    ({:?}, {held}, {:?}, {:?}, {:?}),",
            b.name,
            b.centroid[0],
            b.centroid[1],
            1e-3 * b.weight
        );
    }
    page += "]\n\n# Two blocks, middle, normal from the first to the second, length, elastic depth of the blocks, friction coefficient, cohesion.\nJOINTS = [\n";
    for j in &listing.joints {
        let ([first, second], [x, y], [nx, ny]) = (j.blocks, j.middle(), j.normal);
        let numbers = [x, y, nx, ny, j.length(), j.depth, j.friction, 1e-3 * j.cohesion];
        let numbers: Vec<String> = numbers.iter().map(|value| format!("{:?}", value + 0.0)).collect();
        let _ = writeln!(page, "    ({first}, {second}, {}),", numbers.join(", "));
    }
    page += "]\n";
    for (name, what, permanent) in [("DEAD", "Weight on the blocks", true), ("LIVE", "What is raised", false)] {
        let _ = writeln!(page, "\n# {what}: block, x and y, force to the right and upwards.\n{name} = [");
        for load in listing.loads.iter().filter(|load| load.permanent == permanent) {
            let [x, y] = load.at;
            let [fx, fy] = load.force.map(|force| 1e-3 * force + 0.0);
            let _ = writeln!(page, "    ({}, {x:?}, {y:?}, {fx:?}, {fy:?}),", load.body);
        }
        page += "]\n";
    }
    page + BUILD
}
