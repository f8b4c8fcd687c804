//! report.pdf, where the typesetter of reports (crates/report-pdf) lies beside this program.

use ::outcome::warning;
use extrados::Assessed;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The report as PDF, or code and words of the warning that stands in its place.
pub(super) fn pdf(done: &Assessed) -> Result<Vec<u8>, [String; 2]> {
    let Some(typesetter) = beside() else {
        let words = "report.pdf is not written, report.html holds the same; to have both: cargo install --path crates/report-pdf";
        return Err([warning::WITHOUT_PDF.to_owned(), words.to_owned()]);
    };
    set(&typesetter, &done.data().to_string())
        .map_err(|error| [warning::UNSET_PDF.to_owned(), format!("report.pdf is not written: {error}")])
}

/// The typesetter in the folder of this program.
fn beside() -> Option<PathBuf> {
    let own = std::env::current_exe().ok()?.canonicalize().ok()?;
    Some(own.with_file_name(format!("extrados-pdf{}", std::env::consts::EXE_SUFFIX))).filter(|file| file.is_file())
}

/// What the typesetter makes of strings, or what it says.
fn set(typesetter: &Path, strings: &str) -> Result<Vec<u8>, String> {
    let told = |error: std::io::Error| format!("{}: {error}", typesetter.display());
    let mut child = Command::new(typesetter)
        .arg(env!("CARGO_PKG_VERSION"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(told)?;
    // It reads all before it writes; one that refuses reads nothing, and its words say why.
    let given = child.stdin.take().map_or(Ok(()), |mut input| input.write_all(strings.as_bytes()));
    let done = child.wait_with_output().map_err(told)?;
    match (done.status.success(), given) {
        (true, Ok(())) => Ok(done.stdout),
        (true, Err(error)) => Err(told(error)),
        (false, _) => Err(String::from_utf8_lossy(&done.stderr).trim().to_owned()),
    }
}
