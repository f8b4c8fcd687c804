//! report.pdf: by the typesetter of reports (crates/report-pdf) where it lies beside this program, else printed from report.html by a browser of
//! this machine.

mod browser;
mod typesetter;

use crate::folder::Folder;
use ::outcome::warning;
use extrados::Assessed;

/// What to do where nothing is there that makes a PDF.
const MISSING: &str = "no report.pdf: put extrados-pdf of the release archive beside extrados, or install Chromium, Chrome or Edge; \
                       or print report.html";

/// The report as PDF, or code and words of the warning that stands in its place.
pub(super) fn pdf(done: &Assessed, folder: &Folder) -> Result<figures::File, [String; 2]> {
    let unset = |error: String| [warning::UNSET_PDF.to_owned(), format!("no report.pdf: {error}")];
    let bytes = if let Some(typesetter) = typesetter::beside() {
        typesetter::set(&typesetter, &done.data().to_string()).map_err(unset)?
    } else if let Some(browser) = browser::found().map_err(unset)? {
        let room = folder.room().map_err(|error| unset(error.to_string()))?;
        browser::print(&browser, &done.html(), room.path()).map_err(unset)?
    } else {
        return Err([warning::WITHOUT_PDF.to_owned(), MISSING.to_owned()]);
    };
    Ok(figures::File { name: "report.pdf".to_owned(), bytes })
}
