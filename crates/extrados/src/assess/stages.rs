//! The stages of one bridge in their order: update, built, service, collapse, support movement, checks, sensitivities. Each is
//! kept as soon as it is finished; one that fails leaves the rest standing.

use super::kept::{self, Finished};
use super::{StageName, pictures};
use crate::choice::Choice;
use crate::means::Means;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::update;
use crate::watch::{Looking, Progress, Remembering, Seeking, Watch, Wish};
use assess::analysis;
use assess::analysis::update::{Task, Threads};
use assess::chain;
use assess::checks::{self, CHECKS, Probe};
use assess::evidence::Evidence;
use bridge::Bridge;
use bridge::edit::Document;
use outcome::assessment::{Assessment, Facts, Stage};
use outcome::checked::{Checked, governing};
use outcome::collapse::Status;
use outcome::facts::{CasesFacts, MovementFacts, SensitivityFacts, ServiceFacts, UltimateFacts, VehicleFacts};
use outcome::given::Doubt;
use outcome::passage::PassageStatus;
use outcome::statics::Statics;
use outcome::update::{Update, UpdateStatus};
use report::{Figure, StageLine, StageState};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;

/// What the stages of one bridge are made from.
pub(super) struct Stages<'a> {
    /// The file.
    pub project: &'a Project,
    /// Stages to leave out.
    pub skip: &'a [StageName],
    /// Shelf and clock.
    pub means: &'a Means<'a>,
    /// Who looks on.
    pub watch: Remembering<'a>,
    /// Drawings as they come.
    pub figures: Vec<Figure>,
    /// Lines of the appendix as they come.
    pub lines: Vec<StageLine>,
}

/// What became of a stage's run: facts and drawings, none where somebody asked to stop, or why it came to no end.
type Ran<T> = Result<Option<(T, Vec<Figure>)>, String>;

/// Why there is no assessment: the file cannot be used, or, without a refusal, somebody asked to stop.
pub(super) type Halt = Option<Refusal>;

impl Stages<'_> {
    /// Every stage in its order.
    pub(super) fn run(&mut self) -> Result<Assessment, Halt> {
        let own = self.project.bridge()?.clone();
        let asked = self.project.meaning().assess.clone().unwrap_or_default();
        let (update, bridge, document) = self.updated(&own)?;
        let built: Stage<Statics> = self.stage("built", &bridge, |_| {
            let picture = analysis::as_built(&bridge).map_err(|error| error.to_string())?;
            let statics = analysis::statics(&bridge).map_err(|error| error.to_string())?;
            Ok(Some((statics, pictures::built(&picture, &analysis::ground_plan(&bridge, None)))))
        })?;
        let service = self.service(&bridge, &asked)?;
        let ultimate = self.ultimate(&bridge)?;
        let vehicles = self.vehicles(&bridge)?;
        let cases = self.cases(&document)?;
        let movement = self.movement(&bridge)?;
        let sensitivity = Stage::NotAsked("made last".to_owned());
        let facts = Facts { update, service, ultimate, vehicles, cases, movement, sensitivity };
        let (doubts, assumed) = (doubts(self.project), assumed(self.project));
        let mut evidence = Evidence { bridge, asked, facts, statics: built.made().cloned(), doubts, assumed };
        let checked = checks::run(&evidence);
        evidence.facts.sensitivity = self.sensitivity(&document, &evidence, &checked)?;
        Ok(evidence.judged(checked))
    }

    /// Takes a finished stage up, or runs it and keeps what it gave.
    fn stage<T: Serialize + DeserializeOwned>(
        &mut self,
        name: &str,
        input: &impl Debug,
        run: impl FnOnce(&mut Remembering<'_>) -> Ran<T>,
    ) -> Result<Stage<T>, Halt> {
        let key = self.means.key(name, input);
        if let Some(finished) = kept::get::<T>(self.means, name, &key) {
            self.note(name, StageState::TakenUp, Some(finished.seconds), &key);
            self.figures.extend(finished.figures);
            return Ok(Stage::Made(finished.facts));
        }
        let part = format!("{}: stage {name}", self.project.name());
        self.watch.begin(&part);
        if self.watch.look(&Progress { stage: part, fraction: None, steps: 0 }) == Wish::Stop {
            return Err(None);
        }
        let begun = (self.means.clock)();
        let ran = run(&mut self.watch);
        let seconds = (self.means.clock)() - begun;
        match ran {
            // What was cut short is no fact.
            _ if self.watch.stopped => Err(None),
            Ok(None) => Err(None),
            Ok(Some((facts, figures))) => {
                let finished = Finished { facts, figures, seconds };
                kept::put(self.means, name, &key, &finished);
                self.note(name, StageState::Made, Some(seconds), &key);
                self.figures.extend(finished.figures);
                Ok(Stage::Made(finished.facts))
            }
            Err(why) => {
                self.note(name, StageState::Failed(why.clone()), Some(seconds), &key);
                Ok(Stage::Failed(why))
            }
        }
    }

    /// A line of the appendix.
    fn note(&mut self, name: &str, state: StageState, seconds: Option<f64>, key: &str) {
        let seconds = seconds.map_or("–".to_owned(), |seconds| format!("{seconds:.1} s"));
        self.lines.push(StageLine { name: name.to_owned(), state, seconds, key: key.to_owned() });
    }

    /// A stage that the file does not ask for.
    fn not_asked<T>(&mut self, name: &str, why: &str) -> Stage<T> {
        self.note(name, StageState::NotAsked(why.to_owned()), None, "–");
        Stage::NotAsked(why.to_owned())
    }

    /// A stage that the file asks for and the command leaves out.
    fn left_out<T>(&mut self, name: &str, more: &str) -> Stage<T> {
        let why = format!("left out by --skip {name}{more}");
        self.note(name, StageState::LeftOut(why.clone()), None, "–");
        Stage::LeftOut { stage: name.to_owned(), why }
    }

    /// A stage that is made unless the file does not ask for it, for this reason, or the command leaves it out.
    fn asked<T: Serialize + DeserializeOwned>(
        &mut self,
        stage: StageName,
        why_not: Option<&str>,
        input: &impl Debug,
        run: impl FnOnce(&mut Remembering<'_>) -> Ran<T>,
    ) -> Result<Stage<T>, Halt> {
        match why_not {
            Some(why) => Ok(self.not_asked(stage.word(), why)),
            None if self.skip.contains(&stage) => Ok(self.left_out(stage.word(), "")),
            None => self.stage(stage.word(), input, run),
        }
    }

    /// The update where records are given: its facts, and bridge and text with what it found.
    fn updated(&mut self, own: &Bridge) -> Result<(Stage<Update>, Bridge, Document), Halt> {
        let whole = self.project.document(&[])?;
        let named = self.project.meaning().update.clone();
        let Some(asked) = named else {
            return Ok((self.not_asked("update", "the file names no [records]"), own.clone(), whole));
        };
        if self.skip.contains(&StageName::Update) {
            return Ok((self.left_out("update", "; the file's own values count"), own.clone(), whole));
        }
        let document = update::document(self.project)?;
        let project = self.project;
        let files = match project.records() {
            Ok(files) => files,
            Err(refusal) => {
                self.note("update", StageState::Failed(refusal.message.clone()), None, "–");
                return Ok((Stage::Failed(refusal.message), own.clone(), whole));
            }
        };
        let task = Task { bridge: own, document: &document, asked: &asked, files };
        let input = (own, &asked, files.iter().map(|file| blake3::hash(&file.bytes)).collect::<Vec<_>>());
        let means = self.means;
        let stage = self.stage("update", &input, |watch| sought(&task, means, watch))?;
        let edited = stage.made().and_then(|found| chain::with_parameters(&whole, &asked.parameters, found));
        let bridge = edited.as_ref().and_then(|edited| project.read_again(edited.text().as_bytes()).bridge);
        Ok(match (edited, bridge) {
            (Some(edited), Some(bridge)) => (stage, bridge, edited),
            _ => (stage, own.clone(), whole),
        })
    }

    fn service(&mut self, bridge: &Bridge, asked: &bridge::assess::Assess) -> Result<Stage<ServiceFacts>, Halt> {
        let why = bridge.passage.is_none().then_some("the file has no [train] that crosses");
        let limits = &asked.limits;
        let input = (bridge, &asked.service_loads, &limits.rule, limits.loaded_length, limits.cushion);
        self.asked(StageName::Service, why, &input, |watch| {
            let found = chain::service(bridge, asked, chain::Scope::Everything, &mut Looking(watch));
            let (facts, passages) = found.map_err(|error| error.to_string())?;
            if facts.loads.iter().any(|load| load.status == PassageStatus::Cancelled) {
                return Ok(None);
            }
            if let Some(load) = facts.loads.iter().find(|load| load.status != PassageStatus::Completed) {
                let reason = passages.iter().find_map(|passage| passage.reason.clone()).unwrap_or_default();
                return Err(format!("the passage of {} ended with {}: {reason}", load.name, load.status));
            }
            let names: Vec<String> = facts.loads.iter().map(|load| load.name.clone()).collect();
            let figures = pictures::service(&passages, &names);
            Ok(Some((facts, figures)))
        })
    }

    fn ultimate(&mut self, bridge: &Bridge) -> Result<Stage<UltimateFacts>, Halt> {
        let why = bridge.loads.is_empty().then_some("the file describes no [[load]]");
        self.asked(StageName::Collapse, why, bridge, |watch| {
            let Some(found) = chain::ultimate(bridge, &mut Looking(watch)).map_err(|error| error.to_string())? else {
                return Ok(None);
            };
            let figures = pictures::ultimate(&found, &analysis::ground_plan(bridge, None));
            Ok(Some((found.facts, figures)))
        })
    }

    fn vehicles(&mut self, bridge: &Bridge) -> Result<Stage<VehicleFacts>, Halt> {
        let why = bridge.sweep.is_none().then_some("the file has no [sweep] of vehicles");
        self.asked(StageName::Vehicles, why, bridge, |watch| {
            let found = analysis::vehicle_sweep_with_restrictions(bridge, &mut Looking(watch))
                .map_err(|error| error.to_string())?;
            let figures = pictures::vehicles(&found, &analysis::ground_plan(bridge, Some(&found)));
            Ok(Some((chain::vehicle_facts(bridge, &found), figures)))
        })
    }

    /// The file's named cases, with what an update found.
    fn cases(&mut self, document: &Document) -> Result<Stage<CasesFacts>, Halt> {
        let why = self.project.meaning().cases.is_empty().then_some("the file has no [[case]]");
        let (project, text) = (self.project, document.text());
        self.asked(StageName::Cases, why, &text, |watch| {
            let project = project.reworded(text.clone().into_bytes());
            let found = crate::cases(&project, Choice::default(), watch).map_err(|refusal| refusal.message)?;
            if found.answers.iter().any(|one| one.collapse.status == Status::Cancelled) {
                return Ok(None);
            }
            let name = project.meaning().bridge.as_ref().map_or("", |bridge| &bridge.name);
            Ok(Some((found.facts(), pictures::cases(name, &found))))
        })
    }

    fn movement(&mut self, bridge: &Bridge) -> Result<Stage<MovementFacts>, Halt> {
        let why = bridge.plan.support_movement.is_none().then_some("the file describes no [support_movement]");
        self.asked(StageName::SupportMovement, why, bridge, |watch| {
            let found = chain::movement(bridge, &mut Looking(watch)).map_err(|error| error.to_string())?;
            if found.status == Status::Cancelled {
                return Ok(None);
            }
            let figures = pictures::movement(&found.picture);
            Ok(Some((chain::movement_facts(bridge, found), figures)))
        })
    }

    fn sensitivity(
        &mut self,
        document: &Document,
        evidence: &Evidence,
        checked: &[Checked],
    ) -> Result<Stage<SensitivityFacts>, Halt> {
        let worst = governing(checked);
        let why = match worst {
            _ if self.skip.contains(&StageName::Sensitivity) => Some("left out by --skip sensitivity"),
            None => Some("no check could be made, so that none governs"),
            Some((worst, _)) if CHECKS[worst].probe == Probe::Whole => {
                Some("every value takes a whole analysis of the support movement: make them with extrados vary")
            }
            Some(_) => None,
        };
        let input = (document.text(), &evidence.bridge, &evidence.asked, worst);
        self.asked(StageName::Sensitivity, why, &input, |watch| {
            let facts = chain::sensitivity(document, evidence, checked, &mut Looking(watch))
                .map_err(|error| error.to_string())?;
            Ok(facts.map(|facts| (facts, Vec::new())))
        })
    }
}

/// Doubtful values of the file.
/// Values that the file marks as assumed, as a survey does.
fn assumed(project: &Project) -> Vec<String> {
    let inputs = bridge::inputs::inputs(std::str::from_utf8(project.text()).unwrap_or_default());
    inputs.iter().filter(|one| one.remark.starts_with("assumed")).map(bridge::inputs::Input::path).collect()
}

fn doubts(project: &Project) -> Vec<Doubt> {
    let doubtful = project.findings().iter().filter(|finding| finding.code.starts_with('P'));
    doubtful.map(|one| Doubt { code: one.code.to_owned(), message: one.message.clone() }).collect()
}

/// The update of a stage.
fn sought(task: &Task<'_>, means: &Means<'_>, watch: &mut Remembering<'_>) -> Ran<Update> {
    let known = means.shelf.evaluations(&task.identity()).map_err(|refusal| refusal.message)?;
    let mut watch = Seeking { watch, shelf: means.shelf };
    let lent = analysis::update::Means { map: &Threads, watch: &mut watch, clock: means.clock };
    let found = analysis::update::update(task, known, lent).map_err(|error| error.to_string())?;
    if found.status == UpdateStatus::Cancelled {
        return Ok(None);
    }
    if found.found().is_none() {
        return Err(found.reason.unwrap_or_else(|| "no search came to an end".to_owned()));
    }
    let figures = pictures::update(&found);
    Ok(Some((found, figures)))
}
