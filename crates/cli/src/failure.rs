//! What keeps a command from its work: what, where, and what to do about it.

use crate::status::Status;
use extrados::{Refusal, reason};
use std::io;
use std::path::Path;

findings::cards! {
    "F101", "the file cannot be read",
        "The path is not a readable file: it does not exist, is a folder, or permissions forbid reading. Paths \
               are relative to the folder in which the command runs.\n\nExample: `extrados check bridge.toml` in a \
               folder without bridge.toml.";
    "F102", "the folder for results cannot be written",
        "Results go to out/NAME in the current folder, where NAME is the file's name without its extension, or \
               to the folder after --out. The folder is tested before anything is computed, so that no run is lost.";
    "F103", "the folder exists",
        "`extrados new` writes into a new or empty folder only, so that it never overwrites work.";
    "F104", "no example of this name",
        "`extrados new DIR --from NAME` copies an example that comes with the program. The message lists the names.";
    "F105", "no card of this code",
        "`extrados explain CODE` knows the codes of errors (B…), doubts (P…), findings in drawings and block models (D…), warnings of analyses (A…), failures (F…) and the \
        words of `status`. `extrados explain` without a code lists them all.";
    "F106", "the checkpoint belongs to another run",
        "A checkpoint can only be used by the run that wrote it: the same bridge, the same analysis, the same \
               settings. Otherwise the numbers would belong to neither run. Run without --resume to start from the \
               beginning.";
    "F107", "the command line cannot be understood",
        "An option is misspelt, missing its value, or has a value that does not fit. `extrados COMMAND --help` lists them.";
    "F108", "the analysis cannot be set up",
        "The file can be read, but this analysis needs something that the file does not have, or cannot use what \
               it has. The message says what: a load step, a stiffness, a support movement.";
    "F109", "the results could not be written",
        "The analysis finished, but writing its files failed: the disk is full or the folder was removed. No \
               incomplete file remains. Run again with another --out folder.";
    "F110", "the checkpoint cannot be used",
        "The checkpoint is damaged or cannot be read, or another version of this program kept it. Checkpoints are written whole or \
               not at all, so damage is most often an incomplete copy. Run without --resume to start from the beginning; the \
               checkpoint of another version is put aside, where that version finds it.";
    "F111", "no verification cases found",
        "`extrados verify FOLDER` looks for folders that hold a case.toml. Without FOLDER it looks in verification/ of the \
        current folder. The cases come with the source and not with the program: run it in a clone, or name the folder.";
    "F112", "a verification case cannot be read",
        "Each case has a case.toml with title, kind, source and at least one [[expect]]: a quantity, its value or bounds, a \
        tolerance and the reason for it. The message names the file and what is missing or misspelt in it.";
    "F113", "there is nothing to vary",
        "`extrados vary` needs quantities and their values: [[vary]] tables in the bridge file, --set on the command line, or \
        --ranges with a file of [[vary]] tables. `extrados vary FILE --list` shows every quantity that the file has.\n\n\
        Example: extrados vary bridge.toml --set joint.friction_angle=30deg..40deg:5";
    "F114", "a varied value is refused",
        "With this value the bridge file cannot be used, for the reason that the message quotes; its code has a \
               card of its own. Every value is read by the reader of bridge files before anything is computed, so that \
               no run is lost. Where a key applies only with a certain word of another key, vary the two in separate \
               files.";
    "F115", "too many runs",
        "A grid of all combinations grows fast: five values of five quantities are 3125 runs. The message counts \
               them and estimates the time from the bridge as its file has it, which was run once and is kept. \
               --most-runs N allows more; fewer values, or one quantity at a time (without --grid), need fewer runs.";
    "F116", "the command line fixes what is varied",
        "A flag such as --method or --friction overrides the file, and so the varied values of the file: every \
               run would be the same. Leave out the flag or the quantity.";
    "F117", "no number of this name",
        "--outcome names one of the numbers that the runs found, which the message lists. Which there are depends on the \
        analysis: limit analysis has bounds, discrete elements have iterations.";
    "F118", "no conversion between these files",
        "`extrados convert FROM TO` chooses the conversion by the extensions: a bridge file or block model file \
               (.toml) becomes a drawing (.dxf), a ParaView file (.vtu) or a block model file with every block listed \
               (.toml); a drawing becomes a block model file, a ParaView file, or a cleaned drawing in metres; a surveyed section \
               of an intrados (.csv, .txt, .xy) becomes the beginning of a bridge file (.toml), a drawing of its deviations (.svg, .png) \
               or a table of them (.csv); a table of a bridge's numbers (.txt, .csv) becomes a bridge file (.toml); a road profile (LandXML, .xml) becomes the [road] \
               of one; a bridge or block model file becomes tables (.csv) or a script for OpenSees (.py) for checkers.";
    "F119", "the file to be written exists",
        "`extrados convert` writes new files. With --overwrite it replaces one that exists, but never the file it reads, nor the \
        drawing that this one names. `extrados respond --records FILE` replaces a record that is labelled synthetic, and never another \
        file: measured records cannot be made again. `extrados verify --manual FILE` replaces an earlier manual alone.";
    "F120", "a saved packing cannot be used",
        "`file` in [particles] names a table of particles beside the bridge file: a heading that names the \
               columns x_m, y_m and radius_m, then a row per particle; lines that begin with # are comments. The \
               message names each line that cannot be read. Every run writes its packing as packing.csv into its \
               folder of results.";
    "F121", "a train cannot be used",
        "`file` in [train] names the vehicles beside the bridge file: TOML with [[vehicle]] tables as they may stand in the bridge \
        file as [[train.vehicle]], or a table (.csv) headed axle_load_t,distance_m or axle_force_kn,distance_m with a row per \
        axle, its distance counted from the first axle back. The message names each line that cannot be read.";
    "F122", "an output would replace an input",
        "A result would replace a file of the same name that the command reads: for example a drawing model.dxf \
               with --out . in its folder. Nothing was computed and nothing was written. Name another folder with \
               --out DIR.";
    "F123", "an output would replace a file that the command did not make",
        "The command keeps a list of the files that it made in a folder of results (.NAME.extrados-files.json beside the folder) with a hash of each, \
        and replaces those alone. A file that is not on it, or was changed since it was made, is yours: the message names it, \
        nothing was computed and nothing was written. Move the file, or name another folder with --out DIR.";
    "F124", "the model is too large",
        "The size of the model was estimated before it was made, and it is too large: the message gives the \
               number and its limit. Most often a length such as `size` in [mesh] was meant in another unit.";
    "F125", "results of another run were kept",
        "The folder held the results of another run (another analysis or method, a sweep, a grid) or of another \
               file of the same name. They were moved to `earlier` in that folder before the new results were written. \
               --out DIR gives each run its own folder.";
    "F126", "no vehicle, load model, rule or material of this name",
        "`extrados vehicles NAME` knows the vehicles, load models and rules of the library, `extrados materials NAME` its \
               materials; without a name each lists them all. Your own vehicles and rules are in files that the bridge file names \
               (`vehicle_files` and `rule_file` in [sweep]); your own values stand in the bridge file.";
    "F130", "nothing can be updated",
        "Updating needs at least one [[parameter]] with a range, and something that was measured: records of a passage ([records] \
               with `place`, a table or a folder beside the file, of a train ([train], [track]) or a road vehicle ([vehicle]) that crosses by \
               [passage]), or readings of loads at rest ([load_test], in its positions or in a table beside the file), or both. At \
               least one channel must be usable: the message lists what was found. Columns are \
               named after sensors, or assigned to them by `column` in [[channel]].";
    "F131", "no field tests found",
        "`extrados validate FOLDER` needs a folder with priors.toml and a folder for each test. Without FOLDER it looks in validation/ of \
        the current folder. The tests come with the source and not with the program: run it in a clone, or name the folder. --only \
        names tests that the folder has.";
    "F132", "a field test cannot be read",
        "Each test is a folder with bridge.toml (geometry and load, without materials) and test.toml (what was measured, from where, how \
        certain); priors.toml beside them states density, strength and friction for all tests. The message names the file, the key and \
        what is wrong with it; validation/README.md lists the keys.";
    "F133", "a surveyed section cannot be used",
        "A section is a table of two columns, distance along the bridge and height, with a heading that names their unit (x_m,y_m or \
        x [mm],y [mm]) or with --unit: points of one intrados from springing to springing, in any order. The message names the line, or what \
        keeps a curve from being fitted. A section longer than 300 m or shorter than 0.3 m is in another unit than it says.";
    "F134", "a fitted section that somebody should look at",
        "The curve was fitted, and the message says what may be wrong with it: points that were left out, faces of abutments below the springings (left out too), a stretch without points, steps or a \
        kink that a smooth curve rounds off, ends that are not level. `extrados convert SECTION.csv SECTION.svg` draws every point with \
        its distance from the curve.";
    "F135", "a line of a table that was not taken",
        "A table of numbers has a name, a value and a unit on each line. The line has a name that no question of a survey has, or a value that \
        cannot be read. The file is made without it, so that it has what it would have had without this line: write the line as the message says \
        and convert again, or write the value into the file. docs/input/other-programs.md lists the names.\n\nExample: `Mortar loss; 20; mm` is \
        no question of a survey; in the file it is a [[defect]].";
    "F136", "what was assumed in reading a table",
        "A number without a unit, a unit in other letters, a coefficient of friction in place of its angle, or an answer outside of what is usual. The \
        message names the line and what it was taken for: correct the table where that is wrong.";
    "F137", "a road profile cannot be used",
        "A LandXML file has its profiles as <ProfAlign> (intersections of grades with vertical curves) or <ProfSurf> (points), with stations and levels in the \
        unit of its <Units>. --station says where the left springing of the first span stands on it. The message names the line of the file, or the \
        profiles that it has.\n\nExample: `extrados convert alignment.xml road.toml --station \"1234.5 m\" --springing-level \"99.80 m\"`.";
    "F138", "a point cloud cannot be used",
        "Clouds of laser scanners are read as E57, LAS and LAZ. --line says where the cloud is cut: x and y of the left end of the section and of the \
        right one, in plan and in the coordinates of the cloud, a little outside the springings. Points within half of --slab (0.1 m) of it are taken, and of \
        these what lies between --levels. The message names what the library says of the file, or how far the cloud reaches.\n\nExample: `extrados convert \
        scan.e57 bridge.toml --line \"12.0, 4.0, 21.5, 4.2\" --levels \"98.2, 101.5\"`.";
    "F140", "the program has no workbench",
        "The page of the workbench is a part of the program only where it was built with the feature `workbench`, after the page itself. \
        `.ci/workbench build` does both; docs/tutorials/workbench.md has every step. The page works from any web server as well.";
    "F141", "the port of the workbench cannot be had",
        "Another program listens there, or ports so low are not yours to take. `extrados workbench --port 0` lets the system choose one, and \
        prints the address.";
    "F142", "a shard that is not finished",
        "`extrados merge` needs folders in which a command with --shard I/N came to its end. The message names the folder, or pieces \
        in it that are missing or changed since they were made. The same command, run again, makes what is missing and nothing else.";
    "F143", "shards of different works",
        "Shards belong together where they were made by the same command with the same settings, from the same files, by the same build \
        of the program, and are of one number of shards. Otherwise the numbers would belong to none of them. The message names the folder \
        and what differs from the first one.";
    "F144", "shards that are missing or there twice",
        "`extrados merge` needs each of the N shards once. The message lists those that are missing, and the folders of one that \
        is named twice.";
    "F145", "files that changed after their shards were made",
        "`extrados merge` reads the bridge file again, to write the results as the whole command does. What it reads is no longer what the shards \
        were made from. Run the commands of the shards again: only what changed is computed. Run `merge` in the folder in which the shards \
        were run, since paths on their command line are relative to it.";
    "F146", "work that cannot be cut into shards",
        "`--shard I/N` cuts a list: the runs of `vary`, the predictions of `validate`, the bridge files of a folder for `assess`. One \
        bridge alone is assessed by one command.";
    "F147", "a photograph that the report does not show",
        "A report carries its pictures with it and is passed on. It takes photographs (.jpg, .png, 8 MiB at most, 64 MiB together) from the \
        folder of the bridge file and those below it, links followed; `extrados assess FILE --allow-outside` takes them from anywhere. The \
        message names the photograph and why it is not there; the report says the same in its place.";
    "F148", "another run is at work in the folder",
        "Two runs that write into one folder would mix their results. The second one is refused before it computes anything; it may have \
        a folder of its own, or wait. The folder is free as soon as the other run has ended, however it ends.";
}

/// What the last step of a command refuses, when the work is done already.
const NOT_WRITTEN: &str = "F109";

/// How a command ends that could not do its work.
pub(crate) fn status(refusal: &Refusal) -> Status {
    if refusal.code == NOT_WRITTEN { Status::NotWritten } else { Status::UnusableInput }
}

/// A folder for results cannot be written.
pub(crate) fn unwritable(path: &Path, error: &io::Error) -> Refusal {
    let message = format!("cannot write to {}: {}", path.display(), reason(error));
    Refusal::new("F102", message, "choose a folder that you may write to with --out DIR")
}

/// Another run writes there.
pub(crate) fn in_use(folder: &Path) -> Refusal {
    let message = format!("another run is at work in {}", folder.display());
    Refusal::new("F148", message, "wait until it has ended, or name a folder of its own with --out DIR")
}

/// Results would be written over files that are read.
pub(crate) fn replaces_input(folder: &Path, names: &[String]) -> Refusal {
    let message = format!("results in {} would replace what this command reads: {}", folder.display(), listed(names));
    Refusal::new("F122", message, "name a folder of its own with --out DIR")
}

/// Results would be written over files of somebody else; whether each was made here and changed since, and its name.
pub(crate) fn replaces_foreign(folder: &Path, files: &[(bool, String)]) -> Refusal {
    let named = |(changed, name): &(bool, String)| match changed {
        true => format!("{name} (changed since it was made)"),
        false => name.clone(),
    };
    let names: Vec<String> = files.iter().map(named).collect();
    let what = "files that this command did not make";
    let message = format!("results in {} would replace {what}: {}", folder.display(), listed(&names));
    Refusal::new("F123", message, "move the files away, or name another folder with --out DIR")
}

/// Results could not be written after the work was done.
pub(crate) fn not_written(path: &Path, error: &io::Error) -> Refusal {
    let message = format!("could not write {}: {}", path.display(), reason(error));
    Refusal::new(NOT_WRITTEN, message, "make room or choose another folder with --out DIR")
}

/// Names one after the other; of many the first, and how many more.
fn listed(names: &[String]) -> String {
    const MOST: usize = 10;
    let shown = names.iter().take(MOST).cloned().collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(MOST) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_in_order() {
        assert!(findings::Card::are_complete(CARDS));
    }
}
