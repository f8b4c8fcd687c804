//! Where the command speaks: results to stdout, everything else to stderr. A reader that goes away is no error.

use std::io::{self, Write};

/// What a command may say.
#[derive(Debug)]
pub struct Screen {
    /// One JSON object on stdout instead of words.
    pub json: bool,
    /// No progress, no warnings.
    pub quiet: bool,
    /// Everything in words, and warnings one by one; otherwise a first screen.
    pub details: bool,
    failed: Option<io::Error>,
}

impl Screen {
    pub fn new(json: bool, quiet: bool) -> Screen {
        Screen { json, quiet, details: true, failed: None }
    }

    /// Whether warnings are shown one by one as they come, and not on the first screen.
    pub fn tells_each(&self) -> bool {
        !self.quiet && (self.details || self.json)
    }

    /// Writes a result to stdout.
    pub fn result(&mut self, text: &str) {
        let mut stdout = io::stdout().lock();
        let written = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush());
        if let Err(error) = written
            && error.kind() != io::ErrorKind::BrokenPipe
        {
            self.failed = Some(error);
        }
    }

    /// Writes a remark to stderr. Where even that fails there is nobody left to tell.
    pub fn remark(&mut self, text: &str) {
        let _ = io::stderr().lock().write_all(text.as_bytes());
    }

    /// Whether a result could not be written, and why.
    pub fn failed(&mut self) -> Option<io::Error> {
        self.failed.take()
    }
}
