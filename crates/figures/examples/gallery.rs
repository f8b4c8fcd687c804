//! Draws every figure from invented results into a folder: `cargo run -p figures --example gallery -- FOLDER`.

#[path = "../tests/sample/mod.rs"]
mod sample;

use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("which folder?")?;
    let put = |name: &str, bytes: &[u8]| -> std::io::Result<()> {
        let path = Path::new(&folder).join(name);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::write(path, bytes)
    };
    for (name, picture) in sample::every() {
        for file in sample::all(&picture)? {
            put(&format!("{name}/{}", file.name), &file.bytes)?;
        }
    }
    if let Some(svg) = figures::envelope("Bridgemill, two axles", figures::Ordinate::Factor, &sample::sweeps(), None) {
        for file in figures::written(&[("envelope".to_owned(), svg)])? {
            put(&file.name, &file.bytes)?;
        }
    }
    for (name, update) in [("update", sample::updates::twin()), ("update-hard", sample::updates::hard())] {
        for file in figures::written(&figures::update_drawings(&update))? {
            put(&format!("{name}/{}", file.name), &file.bytes)?;
        }
    }
    Ok(())
}
