//! `extrados workbench`: the interactive page, from files inside the program.

use crate::args::Workbench;
use crate::desk::Desk;
use crate::report::Report;
use extrados::Refusal;
#[cfg(feature = "workbench")]
use {
    super::new,
    crate::status::Status,
    crate::watcher::asked_to_stop,
    crate::workbench::{FILES, server::Server},
    std::io,
    std::path::Path,
};

/// How a program with the workbench is made.
const BUILD: &str = "build the page and the program with `.ci/workbench build`, or the page as docs/tutorials/workbench.md says and then \
                     `cargo install --path crates/cli --features workbench`";

/// This program was built without the page.
#[cfg(not(feature = "workbench"))]
pub(super) fn run(_: &mut Desk, _: &Workbench) -> Result<Report, Refusal> {
    Err(Refusal::new("F140", "this program was built without the workbench", BUILD))
}

/// Serves the page until somebody stops it.
#[cfg(feature = "workbench")]
pub(super) fn run(desk: &mut Desk, arguments: &Workbench) -> Result<Report, Refusal> {
    if FILES.is_empty() {
        let message = "this program was built with the feature `workbench`, but before there was a page";
        return Err(Refusal::new("F140", message, BUILD));
    }
    if let Some(dir) = &arguments.export {
        return exported(dir);
    }
    let server = Server::bind(arguments.port, FILES).map_err(|error| taken(arguments.port, &error))?;
    let address = server.address();
    desk.screen.remark(&format!(
        "the workbench is at {address}\nit runs until you stop it with Ctrl-C; nothing leaves this machine\n"
    ));
    if !arguments.no_browser && open::that_detached(&address).is_err() {
        desk.screen.remark("no browser could be opened: open that address yourself\n");
    }
    server.run(asked_to_stop).map_err(|error| taken(arguments.port, &error))?;
    Ok(Report::new(Status::Completed).with("address", address).saying("the workbench was stopped\n"))
}

/// The page as files that any web server gives out, compressed ones beside them.
#[cfg(feature = "workbench")]
fn exported(dir: &Path) -> Result<Report, Refusal> {
    let compressed: Vec<(String, &[u8])> =
        FILES.iter().filter_map(|file| Some((format!("{}.br", file.name), file.compressed?))).collect();
    let whole = FILES.iter().map(|file| (file.name, file.bytes));
    let files: Vec<(&str, &[u8])> =
        whole.chain(compressed.iter().map(|(name, bytes)| (name.as_str(), *bytes))).collect();
    new::write(&files, dir)?;
    let said = format!("{}: the page, {} files; any web server can give them out\n", dir.display(), files.len());
    Ok(Report::new(Status::Completed).with("folder", dir.display().to_string()).saying(said))
}

/// A port that cannot be had.
#[cfg(feature = "workbench")]
fn taken(port: u16, error: &io::Error) -> Refusal {
    let message = match error.kind() {
        io::ErrorKind::AddrInUse => format!("port {port} is in use by another program"),
        _ => format!("port {port} cannot be had: {}", extrados::reason(error)),
    };
    Refusal::new("F141", message, "name another one with --port, or let the system choose with --port 0")
}
