//! Draws the mesh of a bridge file into a folder, as SVG, PNG and VTU:
//! `cargo run --release -p figures --example mesh -- FILE FOLDER`.

use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [file, folder] =
        std::env::args().skip(1).collect::<Vec<_>>().try_into().map_err(|_| "which file and folder?")?;
    let read = bridge::read(&std::fs::read(&file)?);
    let bridge = read.bridge.ok_or_else(|| format!("{file} cannot be used: {:?}", read.diagnostics))?;
    let meshed = assess::discretise::mesh::mesh(&bridge)?;
    println!("{:#?}", meshed.quality);
    let picture = meshed.picture();
    std::fs::create_dir_all(&folder)?;
    for file in figures::both("mesh", &figures::mesh(&bridge.name, &picture))? {
        std::fs::write(Path::new(&folder).join(file.name), file.bytes)?;
    }
    std::fs::write(Path::new(&folder).join("mesh.vtu"), figures::vtk::mesh(&picture))?;
    Ok(())
}
