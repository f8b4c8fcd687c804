//! A bridge's blocks for somebody who checks them with other means: tables, or a script for OpenSees.

use super::{Content, Report, folder, guard_at, read_model_by};
use crate::args::Convert;
use crate::desk::Desk;
use crate::failure;
use assess::analysis::{AnalysisError, weighed};
use extrados::Refusal;
use findings::words::counted;
use std::path::{Path, PathBuf};
use structure::blocks::{Scene, listing, opensees};

/// Reads the model and writes it as the extension `to` asks: a script, or tables beside one another.
pub(super) fn run(desk: &mut Desk, arguments: &Convert, to: &str) -> Result<Report, Refusal> {
    let (report, content, inputs) = read_model_by(desk, arguments, &weighed)?;
    let Some(Content::Model(scene)) = content else { return Ok(report) };
    if !scene.particles.is_empty() {
        let message = format!("{} has {}, which are no blocks", scene.name, counted(scene.particles.len(), "particle"));
        let help = "leave the layer of particles out (role = \"ignore\"), or convert to .vtu";
        return Err(Refusal::new("F118", message, help));
    }
    let listed = listing(&scene).map_err(AnalysisError::from)?;
    let none = left_out(&scene);
    let files: Vec<(PathBuf, Vec<u8>)> = match to {
        "py" => vec![(arguments.to.clone(), opensees(&scene, &listed, &none).into_bytes())],
        _ => listed.tables().into_iter().map(|(name, bytes)| (beside(&arguments.to, name), bytes)).collect(),
    };
    let inputs: Vec<&Path> = inputs.iter().map(AsRef::as_ref).collect();
    files.iter().try_for_each(|(file, _)| guard_at(file, arguments, &inputs))?;
    for (file, bytes) in &files {
        folder::write_whole(file, bytes).map_err(|error| failure::unwritable(file, &error))?;
    }
    let written: Vec<String> = files.iter().map(|(file, _)| file.display().to_string()).collect();
    let (blocks, joints, loads) = (listed.blocks.len(), listed.joints.len(), listed.loads.len());
    let counts = [counted(blocks, "block"), counted(joints, "joint"), counted(loads, "force")].join(", ");
    let mut summary = format!(
        "{}: {counts}; dead load {:.3} kN per metre of width\n",
        arguments.from.display(),
        1e-3 * listed.dead_load()
    );
    none.iter().for_each(|sentence| summary.push_str(&format!("  {sentence}\n")));
    written.iter().for_each(|file| summary.push_str(&format!("written to {file}\n")));
    if to == "py" {
        summary += &format!("run it: pip install openseespy; python {}\n", written[0]);
    }
    Ok(report
        .with("blocks", blocks)
        .with("joints", joints)
        .with("forces", loads)
        .with("dead_load_kn_per_m", 1e-3 * listed.dead_load())
        .with("left_out", none)
        .with("written", written)
        .saying(summary))
}

/// The file of a table: `model.csv` becomes `model-blocks.csv`.
fn beside(to: &Path, table: &str) -> PathBuf {
    let stem = to.file_stem().unwrap_or_default().to_string_lossy();
    to.with_file_name(format!("{stem}-{table}.csv"))
}

/// What of the model these lists do not have.
fn left_out(scene: &Scene) -> Vec<String> {
    let mut none = vec!["Fill is weight on the blocks: it presses on no ring and carries nothing.".to_owned()];
    if scene.materials.iter().any(|material| material.masonry.compressive_strength.is_some()) {
        none.push("Masonry does not crush.".to_owned());
    }
    if !scene.forces.iter().any(|force| !force.permanent) {
        none.push(
            "There is no load: the file has no [[load]], and vehicles of a [sweep] are not among these forces."
                .to_owned(),
        );
    }
    none
}
