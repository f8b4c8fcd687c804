//! The typesetter of reports, a program in the folder of this one: strings go in, a PDF comes out.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The typesetter in the folder of this program, as the system tells it, or as it was called where a bare system does not.
pub(super) fn beside() -> Option<PathBuf> {
    let called = || std::env::args_os().next().map(PathBuf::from).filter(|called| called.components().count() > 1);
    let own = std::env::current_exe().ok().or_else(called)?.canonicalize().ok()?;
    Some(own.with_file_name(format!("extrados-pdf{}", std::env::consts::EXE_SUFFIX))).filter(|file| file.is_file())
}

/// What the typesetter makes of strings, or what it says.
pub(super) fn set(typesetter: &Path, strings: &str) -> Result<Vec<u8>, String> {
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
