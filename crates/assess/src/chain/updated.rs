//! The bridge with what an update found.

use bridge::edit::Document;
use bridge::update::Parameter;
use outcome::update::Update;

/// The file's text with the values that were found in the place of its own; none where a value finds no place.
pub fn with_parameters(document: &Document, asked: &[Parameter], update: &Update) -> Option<Document> {
    let mut edited = document.clone();
    for (parameter, found) in asked.iter().zip(&update.found()?.parameters) {
        edited.set(&parameter.path, &parameter.literal(found.value)).ok()?;
    }
    Some(edited)
}
