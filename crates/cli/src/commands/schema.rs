//! `extrados schema`: the JSON Schema of bridge files or block model files, alone on stdout with and without `--json`.

use super::Answer;
use crate::args::Schema;
use crate::report;

/// The schema.
pub fn run(arguments: &Schema) -> Answer {
    let schema = if arguments.blocks { bridge::schema::schema_of_blocks() } else { bridge::schema::schema() };
    Answer::Text(report::text_of(&schema))
}
