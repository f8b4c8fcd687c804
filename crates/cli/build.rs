//! The files of the workbench, where the feature `workbench` asks for them and they were built: a table of them as source, with the
//! compressed form that stands beside a file (`NAME.br`).

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if env::var_os("CARGO_FEATURE_WORKBENCH").is_none() {
        return;
    }
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let dist = here.join("../../workbench/dist");
    println!("cargo:rerun-if-changed={}", dist.display());
    let mut found = Vec::new();
    // Where nothing was built the table is empty, and the command says how to build.
    let _ = gather(&dist, "", &mut found);
    found.sort();
    let mut table = String::from("&[\n");
    for (name, path) in found.iter().filter(|(name, _)| !name.ends_with(".br") && !name.ends_with(".gz")) {
        let compressed = format!("{name}.br");
        let compressed = found.iter().find(|(other, _)| *other == compressed);
        let compressed = compressed.map_or("None".to_owned(), |(_, path)| format!("Some(include_bytes!({path:?}))"));
        let _ = writeln!(
            table,
            "    File {{ name: {name:?}, bytes: include_bytes!({path:?}), compressed: {compressed} }},"
        );
    }
    table.push_str("]\n");
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default()).join("workbench_files.rs");
    if let Err(error) = fs::write(&out, table) {
        println!("cargo:warning=the table of the workbench's files cannot be written: {error}");
    }
}

/// Every file below a folder, with its name from there.
fn gather(folder: &Path, before: &str, found: &mut Vec<(String, String)>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{before}{}", entry.file_name().to_string_lossy());
        let path = entry.path();
        println!("cargo:rerun-if-changed={}", path.display());
        if path.is_dir() {
            gather(&path, &format!("{name}/"), found)?;
        } else {
            found.push((name, fs::canonicalize(&path)?.display().to_string()));
        }
    }
    Ok(())
}
