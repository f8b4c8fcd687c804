//! From the records of a train's passage to the parameters of a bridge; or the verdict on the records alone.

use crate::means::Means;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::{Seeking, Watch};
use assess::analysis::update::{self, Task, Threads, UpdateError};
use bridge::update::{Search, Start, Variant};
use outcome::plan::LoadTestPlan;
use outcome::update::Update;

/// How parameters are sought, where not as the file says.
#[derive(Debug, Clone, Copy, Default)]
pub struct UpdateOptions {
    /// Which search; none for the file's.
    pub search: Option<Search>,
    /// Which reading of the published search; none for the file's.
    pub variant: Option<Variant>,
    /// Where it starts; none for the file's.
    pub start: Option<Start>,
}

/// Seeks the parameters of the file by its records. Evaluations are kept on the shelf as they are finished, and taken up from it.
///
/// # Errors
/// A file or records that cannot be used, or that make no problem (F108, F130).
pub fn update(
    project: &Project,
    options: &UpdateOptions,
    means: &Means<'_>,
    watch: &mut dyn Watch,
) -> Result<Update, Refusal> {
    with_task(project, options, |task| {
        let known = means.shelf.evaluations(&task.identity())?;
        let mut watch = Seeking { watch, shelf: means.shelf };
        update::update(task, known, update::Means { map: &Threads, watch: &mut watch, clock: means.clock })
            .map_err(|error| refused(&error))
    })
}

/// Judges the records alone, beside one passage of the start model: nothing is sought.
///
/// # Errors
/// Those of [`update`].
pub fn judge(project: &Project, means: &Means<'_>, watch: &mut dyn Watch) -> Result<Update, Refusal> {
    with_task(project, &UpdateOptions::default(), |task| {
        let mut watch = Seeking { watch, shelf: &crate::shelf::Unkept };
        update::judge(task, update::Means { map: &Threads, watch: &mut watch, clock: means.clock })
            .map_err(|error| refused(&error))
    })
}

/// What the load test of the file would tell of its parameters, whether anything was read or not; none where the file has no load test or no
/// parameters, or where somebody wished to stop.
///
/// # Errors
/// A file that cannot be used, a load test that cannot be set up (F108), a start model without an answer (F130).
pub fn plan_load_test(project: &Project, watch: &mut dyn Watch) -> Result<Option<LoadTestPlan>, Refusal> {
    let bridge = project.bridge()?;
    let Some(asked) = project.meaning().update.as_ref().filter(|_| bridge.load_test.is_some()) else { return Ok(None) };
    let document = document(project)?;
    let task = Task { bridge, document: &document, asked, files: &[] };
    let mut watch = Seeking { watch, shelf: &crate::shelf::Unkept };
    let means = update::Means { map: &Threads, watch: &mut watch, clock: &|| 0.0 };
    update::plan(&task, means).map_err(|error| refused(&error))
}

/// Whether the file says what to seek and its records can be read.
///
/// # Errors
/// What is missing (F101, F108, F130).
pub fn can_update(project: &Project) -> Result<(), Refusal> {
    with_task(project, &UpdateOptions::default(), |_| Ok(()))
}

/// What is to be updated, and by which records.
fn with_task<T>(
    project: &Project,
    options: &UpdateOptions,
    run: impl FnOnce(&Task<'_>) -> Result<T, Refusal>,
) -> Result<T, Refusal> {
    let bridge = project.bridge()?;
    let Some(mut asked) = project.meaning().update.clone() else {
        let message = format!("{} says nothing of what to seek", project.name());
        return Err(Refusal::new(
            "F130",
            message,
            "add [[parameter]] tables, and [records] or readings in [load_test]; extrados explain F130",
        ));
    };
    asked.plan.search = options.search.unwrap_or(asked.plan.search);
    asked.plan.variant = options.variant.unwrap_or(asked.plan.variant);
    asked.plan.start = options.start.unwrap_or(asked.plan.start);
    let (document, files) = (document(project)?, project.records()?);
    if asked.records.is_none() && bridge.load_test.as_ref().is_none_or(|test| !test.readings.any()) {
        let message = format!("nothing was read yet in the load test of {}", project.name());
        let help = "write `readings` in [load_test] or in its positions; extrados check tells what each position and each sensor would tell";
        return Err(Refusal::new("F130", message, help));
    }
    run(&Task { bridge, document: &document, asked: &asked, files })
}

/// The file's text as a tree that can be edited, without what it says of updating.
pub(crate) fn document(project: &Project) -> Result<bridge::edit::Document, Refusal> {
    let sections: Vec<&str> = bridge::UPDATE_SECTIONS.into_iter().chain(["vary"]).collect();
    project.document(&sections)
}

fn refused(error: &UpdateError) -> Refusal {
    match error {
        UpdateError::Analysis(error) => Refusal::not_set_up(error),
        other => Refusal::new("F130", other.to_string(), "extrados explain F130 tells what updating needs"),
    }
}
