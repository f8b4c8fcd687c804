//! `--records`: the passage as a logger would have written it.

use crate::args::{Logger as Arguments, RecordNoise, Respond};
use crate::failure;
use crate::{folder, quantities};
use assess::analysis::passage::record::{Logger, Scatter, record};
use extrados::Refusal;
use extrados::files::{LONGEST, read_at_most};
use outcome::passage::Passage;
use records::{Dimension, ReadOptions, Recording};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Where a record goes and how it is taken, both settled before anything is computed.
pub(super) struct Recorder {
    /// The file.
    pub(super) path: PathBuf,
    logger: Logger,
    file: String,
}

impl Recorder {
    /// What the command line asks for; None without `--records`.
    pub(super) fn new(arguments: &Respond) -> Result<Option<Recorder>, Refusal> {
        let Some(path) = &arguments.records else { return Ok(None) };
        let logger = logger(&arguments.logger)?;
        free(path)?;
        let file = arguments.file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Some(Recorder { path: path.clone(), logger, file }))
    }

    /// Writes the record, named after its file.
    pub(super) fn write(&self, passage: &Passage) -> Result<Recording, Refusal> {
        let name = self.path.file_stem().unwrap_or_default().to_string_lossy();
        let made_by = format!("extrados respond {}", self.file);
        let run = record(passage, &name, &made_by, &self.logger);
        folder::write_whole(&self.path, records::write(&run).as_bytes())
            .map_err(|error| failure::not_written(&self.path, &error))?;
        Ok(run)
    }
}

/// A file may be written where none is, or where a synthetic record is: measured ones cannot be made again.
fn free(path: &Path) -> Result<(), Refusal> {
    let refuse = |why: &str| {
        let help = "name a file of its own with --records FILE";
        Err(Refusal::new("F119", format!("{} {why}", path.display()), help))
    };
    if path.is_dir() {
        return refuse("is a folder");
    }
    match read_at_most(path, LONGEST) {
        Ok(bytes) => match records::read(&bytes, &ReadOptions::default()).run {
            Some(run) if run.synthetic.is_some() => Ok(()),
            _ => refuse("exists and is not labelled synthetic"),
        },
        Err(error) if error.kind() != ErrorKind::NotFound => Err(Refusal::unreadable(path, &error)),
        Err(_) => match path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.is_dir()) {
            Some(folder) => refuse(&format!("has no folder: {} does not exist", folder.display())),
            None => Ok(()),
        },
    }
}

fn logger(arguments: &Arguments) -> Result<Logger, Refusal> {
    let exact = arguments.noise == RecordNoise::None;
    if exact && !(arguments.least_count.is_empty() && arguments.deviation.is_empty()) {
        let message = "--noise none leaves no room for --least-count and --deviation";
        return Err(Refusal::new("F107", message, "leave --noise none away; --deviation \"0 mm\" rounds only"));
    }
    let mut logger = if exact { Logger::NONE } else { Logger::default() };
    if let Some(text) = &arguments.rate {
        logger.rate = Some(quantities::frequency("--rate", text)?);
    }
    if let Some(seed) = arguments.seed {
        logger.seed = seed;
    }
    let steps = both("--least-count", &arguments.least_count)?;
    let deviations = both("--deviation", &arguments.deviation)?;
    let with = |default: Scatter, step: Option<f64>, deviation: Option<f64>| {
        let scatter = step.map_or(default, Scatter::of_least_count);
        Scatter { deviation: deviation.unwrap_or(scatter.deviation), ..scatter }
    };
    logger.displacement = with(logger.displacement, steps[0], deviations[0]);
    logger.strain = with(logger.strain, steps[1], deviations[1]);
    Ok(logger)
}

/// Sizes of displacements and of strains, told apart by their units [SI].
fn both(option: &str, texts: &[String]) -> Result<[Option<f64>; 2], Refusal> {
    let mut sizes = [None; 2];
    for text in texts {
        let (kind, size) = quantities::of_records(option, text)?;
        let place = usize::from(kind == Dimension::Strain);
        if sizes[place].replace(size).is_some() {
            let message = format!("{option} is given twice for {}", ["displacements", "strains"][place]);
            return Err(Refusal::new(
                "F107",
                message,
                format!("write {option} \"0.01 mm\" {option} \"0.05 microstrain\""),
            ));
        }
    }
    Ok(sizes)
}
