//! From an analysis to its folder of results.

use crate::desk::Desk;
use crate::failure;
use crate::folder::{Folder, with_room};
use crate::report::Report;
use crate::workbook;
use extrados::Refusal;
pub(crate) use extrados::written::{Written, tables};
use serde_json::json;
use std::fmt::Display;
use std::fs;
use std::io;
use std::path::Path;

/// A figure that cannot be drawn, or a workbook that cannot be packed, is a result that cannot be written.
pub(crate) fn not_drawn(folder: &Path, error: &impl Display) -> Refusal {
    failure::not_written(folder, &io::Error::other(error.to_string()))
}

/// Writes files into a folder, with folders of their own where their names have them.
pub(crate) fn write(folder: &Path, files: &[figures::File]) -> io::Result<()> {
    files.iter().try_for_each(|file| fs::write(with_room(&folder.join(&file.name))?, &file.bytes))
}

/// Moves the files into the folder, sealed with the object that scripts read. Says where an earlier answer of another run went.
pub(crate) fn publish(
    desk: &mut Desk,
    mut report: Report,
    folder: &Folder,
    written: Written,
) -> Result<Report, Refusal> {
    let mut files = files(folder, written)?;
    files.extend(in_one_workbook(&report, &files).map_err(|error| not_drawn(folder.path(), &error))?);
    folder.fill(
        |staging| write(staging, &files),
        |names, place, placed| {
            report.fields.insert("out".to_owned(), json!(place.display().to_string()));
            report.fields.insert("files".to_owned(), json!(names));
            if let Some(earlier) = &placed.earlier {
                let what = format!("the results of another run stood in {}", place.display());
                report.warn(&mut desk.screen, "F125", &format!("{what}: they are kept in {}", earlier.display()));
            }
            if !placed.avoided.is_empty() {
                let what = format!("{} came while this ran and is not the command's", placed.avoided.join(", "));
                report.warn(&mut desk.screen, "F123", &format!("{what}: the results are in {}", place.display()));
            }
            ::outcome::published::json(&report.object(&desk.schema, desk.clock))
        },
    )?;
    report.summary += &told(&files, desk.screen.details);
    Ok(report)
}

/// The tables that lie at the top of the folder, as a workbook beside them.
fn in_one_workbook(
    report: &Report,
    files: &[figures::File],
) -> Result<Option<figures::File>, rust_xlsxwriter::XlsxError> {
    let tables: Vec<(&str, &[u8])> = files
        .iter()
        .filter_map(|file| Some((file.name.strip_suffix(".csv").filter(|stem| !stem.contains('/'))?, &file.bytes[..])))
        .collect();
    let bytes = workbook::workbook(&report.fields, &report.warnings, &tables)?;
    Ok(bytes.map(|bytes| figures::File { name: workbook::NAME.to_owned(), bytes }))
}

/// What was written, in lines, or in one by kinds: only what is there is named.
fn told(files: &[figures::File], details: bool) -> String {
    let top = |endings: &[&str]| -> Vec<String> {
        let names = |ending: &str| -> Vec<String> {
            let ends = |name: &&String| name.rsplit_once('.').is_some_and(|(_, own)| own == ending);
            files.iter().map(|file| &file.name).filter(|name| !name.contains('/')).filter(ends).cloned().collect()
        };
        endings.iter().flat_map(|ending| names(ending)).collect()
    };
    let drawn = top(&["svg"]).into_iter().map(|name| name.trim_end_matches(".svg").to_owned());
    let animation = files.iter().filter(|file| file.name == "animation.png").map(|file| file.name.clone());
    let below = |folders: &[&str]| -> Vec<String> {
        let count = |folder: &str| files.iter().filter(|file| file.name.starts_with(folder)).count();
        let counted = folders.iter().map(|folder| (count(folder), folder)).filter(|(count, _)| *count > 0);
        counted.map(|(count, folder)| format!("{count} in {folder}")).collect()
    };
    let groups = [
        ("figures", drawn.chain(animation).collect()),
        ("tables", top(&["csv", "xlsx"])),
        ("drawings for CAD", top(&["dxf"])),
        ("reports", top(&["html", "pdf"])),
        ("files for ParaView", below(&["paraview/"])),
        ("of the other strip", below(&["wall/"])),
        ("figures of both", below(&["before/", "after/"])),
    ];
    let filled = groups.iter().filter(|(_, names)| !names.is_empty());
    if !details {
        let kinds: Vec<&str> = filled.map(|(what, _)| *what).collect();
        return format!("  with {}\n", kinds.join(", "));
    }
    filled.map(|(what, names)| format!("  {what}: {}\n", names.join(", "))).collect()
}

/// Puts files beside whatever else is in the folder; gives their names.
pub(crate) fn put(folder: &Folder, written: Written) -> Result<Vec<String>, Refusal> {
    let files = files(folder, written)?;
    folder.put(&files)?;
    Ok(files.into_iter().map(|file| file.name).collect())
}

/// Every file of an answer; each drawing as SVG and as PNG.
fn files(folder: &Folder, written: Written) -> Result<Vec<figures::File>, Refusal> {
    let mut files = figures::written(&written.drawings).map_err(|error| not_drawn(folder.path(), &error))?;
    files.extend(written.files);
    Ok(files)
}
