//! The stages of one bridge in their order: update, built, service, collapse, support movement, checks, sensitivities. Each is
//! kept as soon as it is finished; one that fails leaves the rest standing.

use super::kept::{Finished, Kept};
use super::{line, pictures};
use crate::args::AssessStage;
use crate::clock::Clock;
use crate::commands::Source;
use crate::commands::update::{self, log::Keeper};
use crate::failure::Failure;
use crate::folder::Folder;
use crate::signs;
use crate::watcher::{self, Spectator};
use ::assess::analysis;
use ::assess::analysis::update::{Means, Task, Threads, UpdateStatus};
use ::assess::assessment::{Assessment, Stage};
use ::assess::chain;
use ::assess::checks::{self, Checked};
use ::assess::wire::{MovementFacts, SensitivityFacts, ServiceFacts, UltimateFacts, UpdateFacts, VehicleFacts};
use ::report::{Figure, StageLine};
use bridge::Bridge;
use bridge::edit::Document;
use mechanics::watch::{Progress, Watch, Wish};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;
use std::path::Path;

/// What the stages of one bridge are made from.
pub struct Chain<'a> {
    /// The file.
    pub source: &'a Source,
    /// Where it is.
    pub path: &'a Path,
    /// Where results go.
    pub folder: &'a Folder,
    /// Finished stages.
    pub kept: &'a Kept<'a>,
    /// Stages to leave out.
    pub skip: &'a [AssessStage],
    /// No progress.
    pub quiet: bool,
}

/// What a chain gives.
pub type Linked = (Assessment, Vec<Checked>, Vec<Figure>, Vec<StageLine>);

/// What became of a stage's run.
enum Ran<T> {
    /// Facts and drawings.
    Made(T, Vec<Figure>),
    /// Why it came to no end.
    Failed(String),
    /// Somebody asked to stop.
    Cancelled,
}

/// Drawings and lines of the appendix as they come.
#[derive(Default)]
struct Book {
    figures: Vec<Figure>,
    lines: Vec<StageLine>,
}

impl Chain<'_> {
    /// Every stage; none where somebody asked to stop.
    pub fn run(&self) -> Result<Option<Linked>, Failure> {
        let (Some(own), Some(asked)) = (self.source.read.bridge.clone(), self.source.read.assess.clone()) else {
            return Ok(None);
        };
        let mut book = Book::default();
        let Some((update, bridge, document)) = self.updated(&own, &mut book)? else { return Ok(None) };
        let built = self.stage("built", &bridge, &mut book, || match analysis::as_built(&bridge) {
            Ok(picture) => Ran::Made((), pictures::built(&picture)),
            Err(error) => Ran::Failed(error.to_string()),
        });
        if built.is_none() {
            return Ok(None);
        }
        let Some(service) = self.service(&bridge, &asked, &mut book) else { return Ok(None) };
        let Some(ultimate) = self.ultimate(&bridge, &mut book) else { return Ok(None) };
        let Some(vehicles) = self.vehicles(&bridge, &mut book) else { return Ok(None) };
        let Some(movement) = self.movement(&bridge, &mut book) else { return Ok(None) };
        let sensitivity = Stage::NotAsked("made last".to_owned());
        let mut assessment = Assessment { bridge, asked, update, service, ultimate, vehicles, movement, sensitivity };
        let checked = checks::run(&assessment);
        let Some(sensitivity) = self.sensitivity(&document, &assessment, &checked, &mut book) else { return Ok(None) };
        assessment.sensitivity = sensitivity;
        Ok(Some((assessment, checked, book.figures, book.lines)))
    }

    /// Takes a finished stage up, or runs it and keeps what it gave. None where somebody asked to stop.
    fn stage<T: Serialize + DeserializeOwned>(
        &self,
        name: &str,
        input: &impl Debug,
        book: &mut Book,
        run: impl FnOnce() -> Ran<T>,
    ) -> Option<Stage<T>> {
        let key = self.kept.key(name, input);
        if let Some(finished) = self.kept.get::<T>(name, &key) {
            book.lines.push(line(name, "taken from an earlier run".to_owned(), Some(finished.seconds), &key));
            book.figures.extend(finished.figures);
            return Some(Stage::Made(finished.facts));
        }
        if watcher::asked_to_stop() {
            return None;
        }
        signs::begin(&self.named(name));
        let clock = Clock::start();
        match run() {
            Ran::Made(facts, figures) => {
                let finished = Finished { facts, figures, seconds: clock.seconds() };
                self.kept.put(name, &key, &finished);
                book.lines.push(line(name, "made".to_owned(), Some(finished.seconds), &key));
                book.figures.extend(finished.figures);
                Some(Stage::Made(finished.facts))
            }
            Ran::Failed(why) => {
                book.lines.push(line(name, format!("failed: {why}"), Some(clock.seconds()), &key));
                Some(Stage::Failed(why))
            }
            Ran::Cancelled => None,
        }
    }

    /// A stage as lines of progress call it.
    fn named(&self, stage: &str) -> String {
        format!("{}: stage {stage}", self.source.name)
    }

    /// A stage that the file does not ask for.
    fn not_asked<T>(name: &str, why: &str, book: &mut Book) -> Option<Stage<T>> {
        book.lines.push(line(name, format!("not asked for: {why}"), None, "–"));
        Some(Stage::NotAsked(why.to_owned()))
    }

    fn skipped(&self, stage: AssessStage) -> bool {
        self.skip.contains(&stage)
    }

    /// The update where records are given: its facts, and bridge and text with what it found.
    fn updated(
        &self,
        own: &Bridge,
        book: &mut Book,
    ) -> Result<Option<(Stage<UpdateFacts>, Bridge, Document)>, Failure> {
        let text = String::from_utf8_lossy(&self.source.text);
        let whole = Document::parse(&text)
            .ok_or_else(|| Failure::input("F114", "the file cannot be edited", "check it with extrados check"))?;
        let asked = self.source.read.update.clone().filter(|_| !self.skipped(AssessStage::Update));
        let Some(asked) = asked else {
            let why = match self.source.read.update {
                Some(_) => "left out by --skip update; the file's own values count",
                None => "the file names no [records]",
            };
            let stage = Self::not_asked("update", why, book);
            return Ok(stage.map(|stage| (stage, own.clone(), whole)));
        };
        let document = update::document(self.source)?;
        let files = match update::records(self.path, &asked.records.place) {
            Ok(files) => files,
            Err(failure) => {
                book.lines.push(line("update", format!("failed: {}", failure.message), None, "–"));
                return Ok(Some((Stage::Failed(failure.message), own.clone(), whole)));
            }
        };
        let task = Task { bridge: own, document: &document, asked: &asked, files: &files };
        let input = (own, &asked, files.iter().map(|file| blake3::hash(&file.bytes)).collect::<Vec<_>>());
        let stage = self.stage("update", &input, book, || self.update(&task));
        let Some(stage) = stage else { return Ok(None) };
        let edited = stage.made().and_then(|facts| chain::with_parameters(&whole, &asked.parameters, facts));
        let bridge = edited.as_ref().and_then(|edited| self.source.again(edited));
        Ok(Some(match (edited, bridge) {
            (Some(edited), Some(bridge)) => (stage, bridge, edited),
            _ => (stage, own.clone(), whole),
        }))
    }

    fn update(&self, task: &Task<'_>) -> Ran<UpdateFacts> {
        // A log of another bridge or other parameters is begun anew.
        let open = |resume| Keeper::open(self.folder, &task.identity(), resume, self.quiet);
        let (known, mut keeper) = match open(true).or_else(|_| open(false)) {
            Ok(opened) => opened,
            Err(failure) => return Ran::Failed(failure.message),
        };
        let clock = Clock::start();
        let means = Means { map: &Threads, watch: &mut keeper, clock: &|| clock.seconds() };
        let found = analysis::update::update(task, known, means);
        keeper.finish();
        match found {
            Ok(found) if found.status == UpdateStatus::Cancelled => Ran::Cancelled,
            Ok(found) if found.found().is_none() => {
                Ran::Failed(found.reason.clone().unwrap_or_else(|| "no search came to an end".to_owned()))
            }
            Ok(found) => Ran::Made(chain::update_facts(&found), pictures::update(&found)),
            Err(error) => Ran::Failed(error.to_string()),
        }
    }

    fn service(&self, bridge: &Bridge, asked: &bridge::assess::Assess, book: &mut Book) -> Option<Stage<ServiceFacts>> {
        if self.skipped(AssessStage::Service) {
            return Self::not_asked("service", "left out by --skip service", book);
        }
        if bridge.passage.is_none() {
            return Self::not_asked("service", "the file has no [train] that crosses", book);
        }
        let limits = &asked.limits;
        let input = (bridge, &asked.service_loads, &limits.rule, limits.loaded_length, limits.cushion);
        self.stage("service", &input, book, || {
            self.watched(|watch| match chain::service(bridge, asked, chain::Wanted::Everything, watch) {
                Err(error) => Ran::Failed(error.to_string()),
                Ok((facts, _)) if facts.loads.iter().any(|load| load.status == "cancelled") => Ran::Cancelled,
                Ok((facts, passages)) => {
                    if let Some(load) = facts.loads.iter().find(|load| load.status != "completed") {
                        let reason = passages.iter().find_map(|passage| passage.reason.clone()).unwrap_or_default();
                        return Ran::Failed(format!(
                            "the passage of {} ended with {}: {reason}",
                            load.name, load.status
                        ));
                    }
                    let names: Vec<String> = facts.loads.iter().map(|load| load.name.clone()).collect();
                    let figures = pictures::service(&passages, &names);
                    Ran::Made(facts, figures)
                }
            })
        })
    }

    fn ultimate(&self, bridge: &Bridge, book: &mut Book) -> Option<Stage<UltimateFacts>> {
        if self.skipped(AssessStage::Collapse) {
            return Self::not_asked("collapse", "left out by --skip collapse", book);
        }
        if bridge.loads.is_empty() {
            return Self::not_asked("collapse", "the file describes no [[load]]", book);
        }
        self.stage("collapse", bridge, book, || match self.watched(|watch| chain::ultimate(bridge, watch)) {
            _ if crate::watcher::asked_to_stop() => Ran::Cancelled,
            Err(error) => Ran::Failed(error.to_string()),
            Ok(None) => Ran::Cancelled,
            Ok(Some(found)) => {
                let figures = pictures::ultimate(&found, &bridge.name);
                Ran::Made(found.facts, figures)
            }
        })
    }

    fn vehicles(&self, bridge: &Bridge, book: &mut Book) -> Option<Stage<VehicleFacts>> {
        if self.skipped(AssessStage::Vehicles) {
            return Self::not_asked("vehicles", "left out by --skip vehicles", book);
        }
        if bridge.sweep.is_none() {
            return Self::not_asked("vehicles", "the file has no [sweep] of vehicles", book);
        }
        self.stage("vehicles", bridge, book, || {
            self.watched(|watch| match chain::vehicles(bridge, watch) {
                _ if crate::watcher::asked_to_stop() => Ran::Cancelled,
                Err(error) => Ran::Failed(error.to_string()),
                Ok((facts, found)) => Ran::Made(facts, pictures::vehicles(&found)),
            })
        })
    }

    fn movement(&self, bridge: &Bridge, book: &mut Book) -> Option<Stage<MovementFacts>> {
        const NAME: &str = "support-movement";
        if self.skipped(AssessStage::SupportMovement) {
            return Self::not_asked(NAME, "left out by --skip support-movement", book);
        }
        if bridge.plan.support_movement.is_none() {
            return Self::not_asked(NAME, "the file describes no [support_movement]", book);
        }
        self.stage(NAME, bridge, book, || {
            self.watched(|watch| match chain::movement(bridge, watch) {
                Err(error) => Ran::Failed(error.to_string()),
                Ok(found) if found.status == analysis::Status::Cancelled => Ran::Cancelled,
                Ok(found) => Ran::Made(chain::movement_facts(bridge, &found), pictures::movement(&found.picture)),
            })
        })
    }

    fn sensitivity(
        &self,
        document: &Document,
        assessment: &Assessment,
        checked: &[Checked],
        book: &mut Book,
    ) -> Option<Stage<SensitivityFacts>> {
        if self.skipped(AssessStage::Sensitivity) {
            return Self::not_asked("sensitivity", "left out by --skip sensitivity", book);
        }
        let Some((governing, _)) = checks::governing(checked) else {
            return Self::not_asked("sensitivity", "no check could be made, so that none governs", book);
        };
        if checked[governing].card.code == "C401" {
            let why = "every value takes a whole analysis of the support movement: make them with extrados vary";
            return Self::not_asked("sensitivity", why, book);
        }
        let input = (document.text(), &assessment.bridge, &assessment.asked, checks::governing(checked));
        self.stage("sensitivity", &input, book, || {
            self.watched(|watch| match chain::sensitivity(document, assessment, checked, watch) {
                Err(error) => Ran::Failed(error.to_string()),
                Ok(None) => Ran::Cancelled,
                Ok(Some(facts)) => Ran::Made(facts, Vec::new()),
            })
        })
    }

    /// Runs with someone who looks on.
    fn watched<T>(&self, run: impl FnOnce(&mut dyn Watch) -> T) -> T {
        if self.quiet {
            return run(&mut Silent);
        }
        let mut spectator = Spectator::new(false);
        let ran = run(&mut spectator);
        spectator.finish();
        ran
    }
}

/// Draws nothing, hears Ctrl-C.
struct Silent;

impl Watch for Silent {
    fn look(&mut self, _: &Progress) -> Wish {
        if watcher::asked_to_stop() { Wish::Stop } else { Wish::GoOn }
    }
}
