//! Cases that let a train cross a bridge, seek its moduli, or assess it.

use super::case::Analysis;
use super::measure::said;
use assess::analysis;
use assess::analysis::passage;
use assess::analysis::passage::record::{Logger, record};
use assess::analysis::update::{self, Means, RecordFile, Task, Threads};
use assess::evidence::Evidence;
use assess::{chain, checks};
use bridge::edit::Document;
use mechanics::watch::Unwatched;
use outcome::assessment::{Facts, Stage};
use outcome::passage::Passage;
use outcome::passage::RowKind;
use outcome::published;
use serde_json::Value as Json;
use std::time::Instant;

/// The result object of a bridge file. `twin` is the bridge whose passage is the record of an update.
pub(crate) fn measure(document: &toml::Table, run: Analysis, twin: Option<&toml::Table>) -> Result<Json, String> {
    let file = File::read(document)?;
    match run {
        Analysis::Respond => responded(&file),
        Analysis::Update => updated(&file, twin),
        Analysis::Assess => assessed(&file),
    }
}

/// A bridge file as it was read.
struct File {
    text: String,
    read: bridge::Read,
    bridge: bridge::Bridge,
}

impl File {
    fn read(document: &toml::Table) -> Result<File, String> {
        let text = toml::to_string(document).map_err(|e| e.to_string())?;
        let read = bridge::read(text.as_bytes());
        let Some(bridge) = read.bridge.clone() else { return Err(said(&read.diagnostics)) };
        Ok(File { text, read, bridge })
    }

    fn crossed(&self) -> Result<Passage, String> {
        passage::passage(&self.bridge, &mut Unwatched).map_err(|e| e.to_string())
    }
}

/// An object with its status, and what else cases ask for.
fn with_status(mut object: published::Object, status: &str, beside: Vec<(&str, Json)>) -> Json {
    object.insert("status".to_owned(), status.into());
    object.extend(beside.into_iter().map(|(key, value)| (key.to_owned(), value)));
    object.into()
}

fn responded(file: &File) -> Result<Json, String> {
    let found = file.crossed()?;
    let warnings: Vec<&str> = found.warnings.iter().map(|warning| warning.code()).collect();
    let thrust = |moment: Option<&outcome::passage::Moment>| moment.and_then(crown_thrust);
    let at_rest = thrust(found.moments.first());
    let added = thrust(found.moments.last()).zip(at_rest).map(|(last, first)| last - first);
    let beside = vec![
        ("warning_codes", warnings.join(" ").into()),
        ("crown_thrust_kn_per_m", at_rest.into()),
        ("crown_thrust_added_kn_per_m", added.into()),
    ];
    Ok(with_status(found.object(), found.status.word(), beside))
}

/// Compression across the middle joint of the first span [kN/m].
fn crown_thrust(moment: &outcome::passage::Moment) -> Option<f64> {
    let of_first = |row: &&outcome::passage::Row| matches!(row.kind, RowKind::Joint { span: 0, .. });
    let joints: Vec<_> = moment.rows.iter().filter(of_first).collect();
    let middle = joints.len() / 2;
    let crown = joints.into_iter().find(|row| matches!(row.kind, RowKind::Joint { joint, .. } if joint == middle))?;
    Some(-crown.pairs.iter().map(|pair| pair.normal * pair.area).sum::<f64>() / 1e3)
}

fn updated(file: &File, twin: Option<&toml::Table>) -> Result<Json, String> {
    let asked = file.read.update.as_ref().ok_or("the input says nothing of what to seek")?;
    let mut document = Document::parse(&file.text).ok_or("the input cannot be edited")?;
    bridge::UPDATE_SECTIONS.iter().chain(&["vary"]).for_each(|section| document.remove(section));
    let records = match twin {
        Some(twin) => {
            // What is sought is the model's: a truth may lie beyond its ranges.
            let mut truth = twin.clone();
            bridge::UPDATE_SECTIONS.iter().for_each(|section| drop(truth.remove(*section)));
            let found =
                File::read(&truth).and_then(|twin| twin.crossed()).map_err(|reason| format!("twin: {reason}"))?;
            outcome::records::write(&record(&found, "twin", "a verification case", &Logger::NONE)).into_bytes()
        }
        None => match &asked.records {
            Some(records) => {
                crate::read_bytes(records.place.as_ref()).map_err(|e| format!("{}: {e}", records.place))?
            }
            None => Vec::new(),
        },
    };
    let files = [RecordFile { name: "records.csv".to_owned(), bytes: records }];
    let task = Task { bridge: &file.bridge, document: &document, asked, files: &files };
    let start = Instant::now();
    let means =
        Means { map: &Threads, watch: &mut outcome::calibrate::Unwatched, clock: &|| start.elapsed().as_secs_f64() };
    let found =
        update::update(&task, outcome::calibrate::Log::new(&task.identity()), means).map_err(|e| e.to_string())?;
    Ok(with_status(found.object(), found.status.word(), Vec::new()))
}

fn assessed(file: &File) -> Result<Json, String> {
    let asked = file.read.assess.clone().ok_or("the input has nothing to assess")?;
    let bridge = file.bridge.clone();
    let service = match bridge.passage {
        None => Stage::NotAsked("the input has no train".to_owned()),
        Some(_) => match chain::service(&bridge, &asked, chain::Scope::Everything, &mut Unwatched) {
            Ok((facts, _)) => Stage::Made(facts),
            Err(error) => Stage::Failed(error.to_string()),
        },
    };
    let ultimate = match bridge.loads.is_empty() {
        true => Stage::NotAsked("the input has no load".to_owned()),
        false => match chain::ultimate(&bridge, &mut Unwatched) {
            Ok(Some(found)) => Stage::Made(found.facts),
            Ok(None) => Stage::Failed("it was stopped".to_owned()),
            Err(error) => Stage::Failed(error.to_string()),
        },
    };
    let vehicles = match bridge.sweep {
        None => Stage::NotAsked("the input has no vehicles".to_owned()),
        Some(_) => match analysis::vehicles::vehicle_sweep(&bridge, &mut Unwatched) {
            Ok(found) => Stage::Made(chain::vehicle_facts(&bridge, &found)),
            Err(error) => Stage::Failed(error.to_string()),
        },
    };
    let assessment = Evidence {
        doubts: Vec::new(),
        assumed: Vec::new(),
        bridge,
        asked,
        statics: None,
        facts: Facts {
            update: Stage::NotAsked("a case of its own updates".to_owned()),
            service,
            ultimate,
            vehicles,
            cases: Stage::NotAsked(String::new()),
            movement: Stage::NotAsked("a case of its own moves supports".to_owned()),
            sensitivity: Stage::NotAsked("cases look at values".to_owned()),
        },
    };
    let checked = checks::run(&assessment);
    let assessment = assessment.judged(checked);
    Ok(with_status(assessment.object(), assessment.verdict.status.word(), Vec::new()))
}
