//! What an analysis gave, with everything that the command would write of it.

use crate::border::Thrown;
use extrados::bridge::Severity;
use extrados::figures::File;
use extrados::results::collapse::Collapse;
use extrados::results::passage::{Passage, PassageStatus};
use extrados::results::published::{self, Object};
use extrados::results::study::Study;
use extrados::results::update::Update;
use extrados::results::warning::Warning;
use extrados::written::{self, Written};
use extrados::{Assessed, Blocks, Cases, Compared, Project, Refusal, Swept};
use serde_json::{Value, json};
use std::io::{Cursor, Write};
use wasm_bindgen::prelude::*;
use zip::CompressionMethod;
use zip::write::{SimpleFileOptions, ZipWriter};

/// An answer, ready to be read, drawn and taken away.
#[wasm_bindgen(js_name = Result)]
pub struct Outcome {
    object: Object,
    picture: Value,
    passage: Value,
    written: Written,
    text: (String, Vec<u8>),
}

impl Outcome {
    fn new(
        project: &Project,
        (schema, status): (&str, &str),
        fields: Object,
        warnings: &[Warning],
        written: Written,
    ) -> Outcome {
        Outcome {
            object: written::object(project, schema, status, fields, warnings),
            picture: Value::Null,
            passage: Value::Null,
            written,
            text: (project.name().to_owned(), project.text().to_vec()),
        }
    }

    /// Of a collapse.
    pub fn collapse(project: &Project, found: &Collapse) -> Outcome {
        let head = ("extrados.collapse/1", found.status.word());
        let (fields, warnings) = (found.object(), written::warnings_of(found));
        let picture = json!(found.picture);
        Outcome { picture, ..Outcome::new(project, head, fields, &warnings, written::collapse(found, None)) }
    }

    /// Of the collapse of a block model.
    pub fn collapse_of_blocks(blocks: &Blocks, found: &Collapse) -> Outcome {
        let of_file = blocks.findings().iter().map(|one| written::finding(blocks.name(), blocks.text(), one));
        let (place, in_drawing) = blocks.drawing().unzip();
        let place = place.map(|place| place.display().to_string()).unwrap_or_default();
        let in_drawing = in_drawing.unwrap_or_default().iter();
        let (notes, doubts): (Vec<_>, Vec<_>) = in_drawing.partition(|one| one.severity == Severity::Note);
        let value = |one: &extrados::drawing::Finding| written::finding_in_drawing(&place, one);
        let of_analysis = written::warnings_of(found);
        let of_analysis = of_analysis.iter().map(|one| json!({ "code": one.code(), "message": one.message() }));
        let warnings: Vec<Value> = doubts.into_iter().map(value).chain(of_file).chain(of_analysis).collect();
        let mut fields = Object::new();
        if !notes.is_empty() {
            fields.insert("notes".to_owned(), notes.into_iter().map(value).collect());
        }
        fields.extend(found.object());
        let object = written::headed("extrados.collapse/1", found.status.word(), fields, warnings);
        Outcome {
            object,
            picture: json!(found.picture),
            passage: Value::Null,
            written: written::collapse(found, None),
            text: (blocks.name().to_owned(), blocks.text().to_vec()),
        }
    }

    /// Of a sweep.
    ///
    /// # Errors
    /// A file that cannot be used (F108).
    pub fn sweep(project: &Project, found: &Swept) -> Result<Outcome, Refusal> {
        Ok(match found {
            Swept::Loads(found) => {
                let bridge = project.bridge()?;
                let head = ("extrados.sweep/1", found.ended().word());
                let fields = found.object(&bridge.name, bridge.width);
                Outcome::new(project, head, fields, &found.warnings, written::loads_moved(&bridge.name, found))
            }
            Swept::Vehicles(found) => {
                let head = ("extrados.vehicle-sweep/1", found.status().word());
                let picture = found.collapse.as_ref().map_or(Value::Null, |collapse| json!(collapse.picture));
                let (fields, written) = (found.object(), written::vehicles_moved(found));
                Outcome { picture, ..Outcome::new(project, head, fields, &found.warnings, written) }
            }
        })
    }

    /// Of the passage of a train.
    pub fn passage(project: &Project, found: Passage) -> Outcome {
        let head = ("extrados.respond/1", found.status.word());
        let passage = match found.status {
            PassageStatus::Cancelled => Value::Null,
            _ => published::with_sentences(&found, &found.assumptions, &found.warnings),
        };
        let made = Outcome::new(project, head, found.object(), &found.warnings, written::passage(&found));
        Outcome { passage, ..made }
    }

    /// Of an update, or of records that were judged alone.
    pub fn update(project: &Project, found: &Update, alone: bool) -> Outcome {
        let status = match alone {
            true if found.records.doubted() => "inadequate",
            _ => found.status.word(),
        };
        let head = ("extrados.update/1", status);
        Outcome::new(project, head, found.object(), &found.warnings, written::update(found))
    }

    /// Of a study.
    pub fn study(project: &Project, found: &Study) -> Outcome {
        let open = found.rows.iter().all(|row| found.number(row).is_none());
        let head = ("extrados.vary/1", if open { "undetermined" } else { "completed" });
        Outcome::new(project, head, found.object(), &[], written::study(found))
    }

    /// Of an assessment.
    pub fn assessed(project: &Project, found: &Assessed) -> Outcome {
        let head = ("extrados.assess/1", found.assessment.verdict.status.word());
        Outcome::new(project, head, found.object(), &found.warnings(), written::assessed(found))
    }

    /// Of named cases.
    pub fn cases(project: &Project, found: &Cases) -> Outcome {
        let name = project.bridge().map_or("", |bridge| bridge.name.as_str());
        let written = written::cases(name, found);
        let picture = found.least().map_or(Value::Null, |one| json!(one.collapse.picture));
        let known = found.answers.iter().all(extrados::CaseAnswer::is_known);
        let head = ("extrados.cases/1", if known { "completed" } else { "undetermined" });
        Outcome { picture, ..Outcome::new(project, head, found.object(), &found.warnings(), written) }
    }

    /// Of two bridges side by side, under the name of the second.
    pub fn compared(before: &Project, after: &Project, found: &Compared) -> Outcome {
        let mut fields = Object::new();
        fields.insert("before_file".to_owned(), json!(before.name()));
        fields.insert("after_file".to_owned(), json!(after.name()));
        fields.extend(found.object());
        let status = written::worst(found.answers.iter().map(|answer| answer.status));
        let picture = json!(found.answers[1].picture);
        let head = ("extrados.compare/1", status.word());
        Outcome { picture, ..Outcome::new(after, head, fields, &[], written::compared(found)) }
    }

    /// Every file but result.json: drawings as SVG, and the rest as the command writes it.
    fn all(&self) -> Vec<File> {
        let drawn = self.written.drawings.iter();
        let drawn = drawn.map(|(name, svg)| File { name: format!("{name}.svg"), bytes: svg.clone().into_bytes() });
        let name = self.text.0.rsplit('/').next().unwrap_or("bridge.toml").to_owned();
        let own = File { name, bytes: self.text.1.clone() };
        std::iter::once(own).chain(drawn).chain(self.written.files.iter().cloned()).collect()
    }

    /// The names of all files, result.json last.
    pub fn names(&self) -> Vec<String> {
        self.all().into_iter().map(|file| file.name).chain(["result.json".to_owned()]).collect()
    }
}

#[wasm_bindgen(js_class = Result)]
impl Outcome {
    /// How it ended.
    #[wasm_bindgen(getter)]
    pub fn status(&self) -> String {
        self.object["status"].as_str().unwrap_or_default().to_owned()
    }

    /// result.json, but for what only the command knows: wall clock, threads, names of files, where they are.
    #[wasm_bindgen(getter)]
    pub fn json(&self) -> String {
        published::json(&self.object)
    }

    /// What figures are made from; null where there is none.
    #[wasm_bindgen(getter)]
    pub fn picture(&self) -> String {
        self.picture.to_string()
    }

    /// The passage; null where there is none.
    #[wasm_bindgen(getter, js_name = passage)]
    pub fn whole_passage(&self) -> String {
        self.passage.to_string()
    }

    /// The drawings.
    #[wasm_bindgen(getter)]
    pub fn figures(&self) -> String {
        let one = |(name, svg): &(String, String)| json!({ "name": name, "svg": svg });
        Value::from_iter(self.written.drawings.iter().map(one)).to_string()
    }

    /// The names of all files, result.json last, as a list.
    pub fn files(&self) -> String {
        json!(self.names()).to_string()
    }

    /// A file by its name.
    ///
    /// # Errors
    /// No such file (F101).
    pub fn file(&self, name: &str) -> Result<Vec<u8>, Thrown> {
        if name == "result.json" {
            return Ok(self.json().into_bytes());
        }
        let found = self.all().into_iter().find(|file| file.name == name).map(|file| file.bytes);
        Ok(found.ok_or_else(|| Refusal::new("F101", format!("there is no file {name}"), self.names().join(", ")))?)
    }

    /// All files in one archive, stored: who sends it over a wire compresses it there.
    ///
    /// # Errors
    /// An archive that cannot be made (F106).
    pub fn zip(&self) -> Result<Vec<u8>, Thrown> {
        let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        let failed =
            |error: &dyn std::fmt::Display| Refusal::new("F106", error.to_string(), "take the files one by one");
        let result = File { name: "result.json".to_owned(), bytes: self.json().into_bytes() };
        for file in self.all().into_iter().chain([result]) {
            archive.start_file(file.name, options).map_err(|error| failed(&error))?;
            archive.write_all(&file.bytes).map_err(|error| failed(&error))?;
        }
        Ok(archive.finish().map(Cursor::into_inner).map_err(|error| failed(&error))?)
    }
}
