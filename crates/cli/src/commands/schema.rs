//! `extrados schema`: the JSON Schema of bridge files, block model files, or files of vehicles and rules, alone on stdout with and without `--json`.

use crate::args::Schema;
use crate::report::Report;
use crate::status::Status;

pub(super) fn run(arguments: &Schema) -> Report {
    let schema = match (arguments.blocks, arguments.vehicles, arguments.rule) {
        (true, ..) => bridge::schema::schema_of_blocks(),
        (_, true, _) => ::outcome::published::schema_of_vehicles(),
        (.., true) => ::outcome::published::schema_of_rules(),
        _ => bridge::schema::schema(),
    };
    Report { is_text: true, ..Report::new(Status::Completed).saying(::outcome::published::json(&schema)) }
}
