//! The workbench behind a server of this machine alone: its files are in the program, nothing else is ever read or written.

pub(crate) mod answer;
mod guests;
pub(crate) mod server;

/// A file of the page.
#[derive(Debug, Clone, Copy)]
pub(crate) struct File {
    /// Its name below the page's address.
    pub name: &'static str,
    /// What it contains.
    pub bytes: &'static [u8],
    /// The same as Brotli.
    pub compressed: Option<&'static [u8]>,
}

/// All files; none where the front end was not built before the program.
pub(crate) const FILES: &[File] = include!(concat!(env!("OUT_DIR"), "/workbench_files.rs"));
