//! Bridge files that are read, and what was found in them shown.

use crate::desk::Desk;
use crate::folder::{Folder, Purpose};
use crate::render::{self, Paint};
use crate::report::Report;
use crate::status::Status;
use extrados::files::{self, LONGEST_TEXT};
use extrados::{Disk, Files, Project, Refusal};
use std::path::Path;

/// A bridge file that was read, with what it takes from other files.
pub(super) struct Source {
    pub(super) project: Project,
}

impl Source {
    /// Reads a file and shows what was found in it.
    pub(super) fn open(desk: &mut Desk, path: &Path) -> Result<Source, Refusal> {
        Source::open_from(desk, path, &Disk)
    }

    /// Reads a file, with pictures of a report from where these files have them, and shows what was found in it.
    pub(super) fn open_from(desk: &mut Desk, path: &Path, files: &dyn Files) -> Result<Source, Refusal> {
        let source = Source::read(path, files)?;
        if source.bridge().is_none() || desk.screen.tells_each() {
            let (project, paint) = (&source.project, Paint::for_stderr());
            desk.screen.remark(&render::findings(project.name(), project.text(), project.findings(), &paint));
        }
        Ok(source)
    }

    /// Reads a file and says nothing.
    pub(super) fn read(path: &Path, files: &dyn Files) -> Result<Source, Refusal> {
        Ok(Source { project: Project::read(path, files)? })
    }

    /// Its bridge; none where the file cannot be used.
    pub(super) fn bridge(&self) -> Option<&bridge::Bridge> {
        self.project.meaning().bridge.as_ref()
    }

    /// The folder for the results of a run of this kind.
    pub(super) fn folder(&self, path: &Path, kind: &str) -> Result<Folder, Refusal> {
        Folder::prepare(path, Purpose::new(kind, Path::new(self.project.name()), self.project.inputs()))
    }

    /// An answer with what was found.
    pub(super) fn report(&self, status: Status) -> Report {
        let mut report = Report::new(status);
        report.add_findings(self.project.name(), self.project.text(), self.project.findings());
        report
    }
}

/// The bytes of a file that somebody wrote by hand, in UTF-8 where it was UTF-16; one that is longer than such files are is cut, for its
/// first bytes tell what it is.
pub(super) fn read_text(path: &Path) -> Result<Vec<u8>, Refusal> {
    files::head(path, LONGEST_TEXT + 2).map(bridge::as_utf8).map_err(|error| Refusal::unreadable(path, &error))
}

/// The bytes of a file that is not longer than `most`; a folder is refused in words.
pub(super) fn read_file(path: &Path, most: u64) -> Result<Vec<u8>, Refusal> {
    files::read_at_most(path, most).map_err(|error| Refusal::unreadable(path, &error))
}
