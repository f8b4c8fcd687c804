//! Work that several processes share without speaking to one another: what a shard says of itself when it is finished, and shards that
//! are brought together again. A shard makes some of the pieces that the whole command makes; `merge` gives all of them to that
//! command, which then finds every piece finished. So keys, results and the way they are written are those of the command alone.

use crate::desk::Desk;
use crate::failure;
use crate::folder::{self, Folder, SEAL, with_room, write_whole};
use crate::program;
use crate::report::Report;
use crate::results::{self, Written};
use extrados::Refusal;
use extrados::files::{LONGEST, read_at_most};
use extrados::shard::Shard;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Format of what a finished shard says of itself.
pub(crate) const SCHEMA: &str = "extrados.shard/1";

/// What stays of a shard that is interrupted.
pub(crate) const INTERRUPTED: &str = "interrupted; finished pieces are kept, and the same command takes them up\n";

/// How a command shares its work.
#[derive(Debug, Clone, Default, clap::Args)]
pub(crate) struct Sharing {
    /// Make this part of the work alone, such as 2/8, into a folder of its own; `extrados merge` puts the parts together
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Shards whose pieces the command is to take up.
    #[arg(skip)]
    pub merged: Option<Merged>,
}

/// A finished piece of work: its file below the folder of results, and the hash of its bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Piece {
    file: String,
    hash: String,
}

/// What a shard made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Portion {
    /// The words of its command line.
    pub words: Vec<String>,
    /// Which part of the work it is.
    pub shard: String,
    /// The whole work: a hash of everything that its numbers follow from.
    pub identity: String,
    /// The build that made it.
    pub program: String,
    /// Files that it read where their content is no part of the identity, with hashes.
    pub inputs: BTreeMap<String, String>,
    /// What it made.
    pub pieces: Vec<Piece>,
}

impl Portion {
    /// What the shard in a folder made.
    pub(crate) fn read(folder: &Path) -> Option<Portion> {
        let value: Value = serde_json::from_slice(&read_at_most(&folder.join(SEAL), LONGEST).ok()?).ok()?;
        let word = |value: &Value| value.as_str().map(str::to_owned);
        let piece = |one: &Value| Some(Piece { file: word(&one["file"])?, hash: word(&one["hash"])? });
        if value["schema"] != SCHEMA {
            return None;
        }
        Some(Portion {
            words: serde_json::from_value(value["words"].clone()).ok()?,
            shard: word(&value["shard"])?,
            identity: word(&value["identity"])?,
            program: word(&value["program"])?,
            inputs: serde_json::from_value(value["inputs"].clone()).ok()?,
            pieces: value["pieces"].as_array()?.iter().map(piece).collect::<Option<_>>()?,
        })
    }

    /// The fields that [`read`](Self::read) reads.
    fn fields(&self) -> Value {
        let piece = |piece: &Piece| json!({ "file": piece.file, "hash": piece.hash });
        json!({
            "command": self.command(),
            "words": self.words,
            "shard": self.shard,
            "identity": self.identity,
            "program": self.program,
            "inputs": self.inputs,
            "pieces": self.pieces.iter().map(piece).collect::<Vec<Value>>(),
        })
    }

    /// Its command.
    pub(crate) fn command(&self) -> &str {
        self.words.get(1).map_or("", String::as_str)
    }

    /// Names of pieces that are missing, or are not as they were made.
    pub(crate) fn damaged(&self, folder: &Path) -> Vec<String> {
        let sound = |piece: &&Piece| {
            folder::is_inside(&piece.file)
                && folder::hash(&folder.join(&piece.file)).is_ok_and(|hash| hash == piece.hash)
        };
        self.pieces.iter().filter(|piece| !sound(piece)).map(|piece| piece.file.clone()).collect()
    }
}

/// The folder of a shard where no other is named: that of the whole command with the number behind it.
pub(crate) fn folder_of(whole: PathBuf, shard: Option<Shard>) -> PathBuf {
    let Some(shard) = shard else { return whole };
    let mut name = whole.into_os_string();
    name.push(format!("-{}-of-{}", shard.number(), shard.of()));
    name.into()
}

/// The pieces of a work that a shard makes, or all of them.
pub(crate) fn own<T>(all: &[T], shard: Option<Shard>) -> impl Iterator<Item = &T> {
    let makes = move |place: &usize| shard.is_none_or(|one| one.makes(*place));
    all.iter().enumerate().filter(move |(place, _)| makes(place)).map(|(_, piece)| piece)
}

/// The kind of run that a folder is for.
pub(crate) fn kind(whole: &str, shard: Option<Shard>) -> String {
    shard.map_or_else(|| whole.to_owned(), |one| format!("{whole}-shard-{}-of-{}", one.number(), one.of()))
}

/// Seals a finished shard: its pieces are the files of these names.
pub(crate) fn publish(
    desk: &mut Desk,
    mut report: Report,
    folder: &Folder,
    shard: Shard,
    identity: String,
    (inputs, files): (BTreeMap<String, String>, Vec<String>),
) -> Result<Report, Refusal> {
    let hashed = |file: String| {
        let hash =
            folder::hash(&folder.file(&file)).map_err(|error| failure::not_written(&folder.file(&file), &error))?;
        Ok(Piece { file, hash })
    };
    let pieces: Vec<Piece> = files.into_iter().map(hashed).collect::<Result<_, Refusal>>()?;
    let (count, words) = (pieces.len(), desk.words.clone());
    let portion = Portion { words, shard: shard.to_string(), identity, program: program::hash(), inputs, pieces };
    report.fields.extend(portion.fields().as_object().cloned().unwrap_or_default());
    let shown = folder.path().display();
    report.summary = format!(
        "shard {shard}: {count} finished pieces in {shown}\nextrados merge DIR... --out DIR puts all {} together\n",
        shard.of()
    );
    desk.schema = SCHEMA.to_owned();
    results::publish(desk, report, folder, Written::default())
}

/// Shards that belong together, and are all there.
#[derive(Debug, Clone)]
pub(crate) struct Merged {
    /// The one work that they are of.
    pub identity: String,
    /// Their folders, and what they made.
    pub shards: Vec<(PathBuf, Portion)>,
}

impl Merged {
    /// Files that the shards read, with their hashes.
    pub(crate) fn inputs(&self) -> impl Iterator<Item = (&String, &String)> {
        self.shards.iter().flat_map(|(_, portion)| &portion.inputs)
    }

    /// Copies every piece into the folder of the whole work, where that is still the work that the shards did.
    pub(crate) fn bring(&self, identity: &str, folder: &Folder) -> Result<(), Refusal> {
        if identity != self.identity {
            let message =
                "what the shards were made from has changed since: the bridge file, its ranges, or a file beside it";
            let help = "make the shards again with the same commands; only what changed is computed";
            return Err(Refusal::new("F145", message, help));
        }
        for (from, portion) in &self.shards {
            for piece in &portion.pieces {
                let place = folder.file(&piece.file);
                let copied = read_at_most(&from.join(&piece.file), LONGEST)
                    .and_then(|bytes| write_whole(with_room(&place)?, &bytes));
                copied.map_err(|error| failure::not_written(&place, &error))?;
            }
        }
        Ok(())
    }
}
