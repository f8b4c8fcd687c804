//! `extrados schema`: the JSON Schema of bridge files.

use super::Answer;
use crate::report;

/// Prints the schema, and nothing else, with or without --json.
pub fn run() -> Answer {
    Answer::Text(report::text_of(&bridge::schema::schema()))
}
