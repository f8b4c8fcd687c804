//! Bridge files that are read, and what was found in them shown.

use crate::desk::Desk;
use crate::failure::Failure;
use crate::folder::{Folder, Purpose};
use crate::render::{self, Paint};
use crate::report::Report;
use crate::status::Status;
use extrados::files::{self, LONGEST_TEXT};
use extrados::{Disk, Files, Project, WholeDisk};
use std::path::Path;

/// Where pictures of a report may come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pictures {
    /// The folder of the bridge file, and those below.
    Beside,
    /// Wherever the file says.
    Anywhere,
}

impl Pictures {
    /// As the command line allows.
    pub(super) fn allowed(anywhere: bool) -> Pictures {
        if anywhere { Pictures::Anywhere } else { Pictures::Beside }
    }
}

/// A bridge file that was read, with what it takes from other files.
pub(super) struct Source {
    pub(super) project: Project,
}

impl Source {
    /// Reads a file and shows what was found in it.
    pub(super) fn open(desk: &mut Desk, path: &Path) -> Result<Source, Failure> {
        Source::open_with(desk, path, Pictures::Beside)
    }

    /// Reads a file, with pictures from where they may come, and shows what was found in it.
    pub(super) fn open_with(desk: &mut Desk, path: &Path, pictures: Pictures) -> Result<Source, Failure> {
        let source = Source::read_with(path, pictures)?;
        if source.bridge().is_none() || desk.screen.tells_each() {
            let (project, paint) = (&source.project, Paint::for_stderr());
            desk.screen.remark(&render::findings(project.name(), project.text(), project.findings(), &paint));
        }
        Ok(source)
    }

    /// Reads a file and says nothing.
    pub(super) fn read(path: &Path) -> Result<Source, Failure> {
        Source::read_with(path, Pictures::Beside)
    }

    /// The same, with pictures from where they may come.
    pub(super) fn read_with(path: &Path, pictures: Pictures) -> Result<Source, Failure> {
        let files: &dyn Files = match pictures {
            Pictures::Beside => &Disk,
            Pictures::Anywhere => &WholeDisk,
        };
        Ok(Source { project: Project::read(path, files)? })
    }

    /// Its bridge; none where the file cannot be used.
    pub(super) fn bridge(&self) -> Option<&bridge::Bridge> {
        self.project.meaning().bridge.as_ref()
    }

    /// The folder for the results of a run of this kind.
    pub(super) fn folder(&self, path: &Path, kind: &str) -> Result<Folder, Failure> {
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
pub(super) fn read_text(path: &Path) -> Result<Vec<u8>, Failure> {
    files::head(path, LONGEST_TEXT + 2).map(bridge::as_utf8).map_err(|error| Failure::unreadable(path, &error))
}

/// The bytes of a file that is not longer than `most`; a folder is refused in words.
pub(super) fn read_file(path: &Path, most: u64) -> Result<Vec<u8>, Failure> {
    files::read_at_most(path, most).map_err(|error| Failure::unreadable(path, &error))
}
