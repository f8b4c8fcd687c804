//! What a folder of results is for: which run, of which file, and which names it may write.

use figures::{FIGURES, UPDATE_FIGURES};
use std::path::{Path, PathBuf};

/// A run that wants a folder.
#[derive(Debug, Clone)]
pub(crate) struct Purpose {
    /// Which run, such as "collapse-load-dem": its own earlier answer is replaced, that of another run is kept.
    pub kind: String,
    /// The file that it reads, canonical.
    pub of: PathBuf,
    /// Every file that it reads.
    inputs: Vec<PathBuf>,
    /// Stems of the files that it may write; `*` at the end stands for anything.
    stems: &'static [&'static str],
    /// Names of its figures, or how they begin: numbers such as "-1-2" may follow.
    figures: Vec<&'static str>,
}

/// Endings of files of results.
const ENDINGS: [&str; 10] = ["json", "csv", "xlsx", "svg", "png", "dxf", "vtu", "pvd", "html", "pdf"];

/// Folders below the folder of results whose files are all results.
pub(super) const BELOW: [&str; 5] = ["paraview", "wall", "wall/paraview", "before", "after"];

/// Stems of the files of two commands that have many.
const COLLAPSE: &[&str] = &[
    "result",
    "animation",
    "model",
    "deformed",
    "path",
    "hinges",
    "blocks",
    "contacts",
    "particles",
    "particle-contacts",
];
const RESPOND: &[&str] =
    &["result", "records", "influence-lines", "moment-*", "influence", "channels", "log", "joints", "thrust-lines"];

impl Purpose {
    /// A run of this kind on a file, which reads these files too. The kind begins with the command.
    pub(crate) fn new(kind: &str, file: &Path, inputs: &[PathBuf]) -> Purpose {
        let command = kind.split('-').next().unwrap_or_default();
        let stems: &[&str] = match command {
            "collapse" => COLLAPSE,
            "sweep" => &["result", "animation", "envelope", "adequacy", "sweep", "vehicles", "sections"],
            "respond" => RESPOND,
            "update" => &["result", "sweeps", "samples"],
            "vary" => &["result", "tornado", "curve-*", "heat-map", "vary"],
            "assess" => &["result", "report", "checks"],
            "fleet" => &["result", "fleet"],
            "validate" => &["result", "validation"],
            "calibrate" => &["result", "stress-strain", "moduli", "sample", "curve"],
            "cases" => &["result", "cases"],
            "compare" => &["result", "differences", "answers"],
            _ => &["bridge", "mesh"],
        };
        let figures = match command {
            "collapse" | "sweep" => FIGURES.iter().map(|figure| figure.name).collect(),
            "update" => UPDATE_FIGURES.iter().map(|(kind, _)| *kind).collect(),
            _ => Vec::new(),
        };
        let mut all: Vec<PathBuf> = inputs.iter().filter_map(|input| input.canonicalize().ok()).collect();
        let of = file.canonicalize().unwrap_or_else(|_| file.to_owned());
        all.push(of.clone());
        Purpose { kind: kind.to_owned(), of, inputs: all, stems, figures }
    }

    /// Whether the run may write a file of this name. Letters are compared as file systems that do not tell small from capital
    /// ones compare them.
    pub(crate) fn may_write(&self, name: &str) -> bool {
        let name = name.to_lowercase();
        let Some((stem, ending)) = name.rsplit_once('.') else { return false };
        let fits = |known: &str| known.strip_suffix('*').map_or(stem == known, |start| stem.starts_with(start));
        ENDINGS.contains(&ending)
            && (stem.contains('/')
                || name == crate::workbook::NAME
                || self
                    .figures
                    .iter()
                    .any(|known| stem.strip_prefix(known).is_some_and(|rest| rest.is_empty() || rest.starts_with('-')))
                || self.stems.iter().any(|known| fits(known)))
    }

    /// Whether a file is one that the run reads.
    pub(crate) fn reads(&self, path: &Path) -> bool {
        path.canonicalize().is_ok_and(|path| self.inputs.contains(&path))
    }

    /// The file that it reads, as text.
    pub(crate) fn of(&self) -> String {
        self.of.display().to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_lays_claim_to_its_own_names_alone() {
        let purpose = Purpose::new("collapse-load-dem", Path::new("b.toml"), &[]);
        let may = |names: &[&str]| names.iter().map(|name| purpose.may_write(name)).collect::<Vec<_>>();
        assert_eq!(may(&["model.dxf", "Model.DXF", "result.json", "paraview/a.vtu"]), [true; 4]);
        assert_eq!(may(&["survey.dxf", "model.txt", "channels.csv", "model"]), [false; 4]);
        // A sweep draws the mechanism of its governing case, and writes no load steps.
        let sweep = Purpose::new("sweep-vehicles", Path::new("b.toml"), &[]);
        let may = ["mechanism.svg", "sections.csv", "path.csv", "model.dxf"].map(|name| sweep.may_write(name));
        assert_eq!(may, [true, true, false, false]);
        assert!(Purpose::new("respond", Path::new("b.toml"), &[]).may_write("moment-3-ring.svg"));
    }
}
