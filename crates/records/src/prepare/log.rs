//! What was done to records, and what could not be.

use crate::{Done, Finding, Place, Recording, Series};
use findings::Severity;

impl Series {
    pub(super) fn did(&mut self, run: &str, channel: &str, what: String) {
        self.done.push(Done::new(run, channel, what));
    }

    pub(super) fn warn(&mut self, run: &Recording, channel: &str, code: &'static str, message: String, help: &str) {
        let place = Place { run: run.name.clone(), channel: channel.to_owned(), ..Place::default() };
        self.findings.push(Finding::new(Severity::Warning, code, place, message, help));
    }

    pub(super) fn could_not(&mut self, run: &Recording, code: &'static str, message: String, help: &str) {
        self.warn(run, "", code, message, help);
    }
}
