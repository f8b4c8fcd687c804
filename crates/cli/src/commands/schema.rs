//! `extrados schema`: the JSON Schema of bridge files, block model files, or files of vehicles and rules, alone on stdout with and without `--json`.

use super::answer::Answer;
use crate::args::Schema;

pub(super) fn run(arguments: &Schema) -> Answer {
    let schema = match (arguments.blocks, arguments.vehicles, arguments.rule) {
        (true, ..) => bridge::schema::schema_of_blocks(),
        (_, true, _) => ::outcome::published::schema_of_vehicles(),
        (.., true) => ::outcome::published::schema_of_rules(),
        _ => bridge::schema::schema(),
    };
    Answer::Text(::outcome::published::json(&schema))
}
