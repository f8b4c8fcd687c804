//! Where the command speaks: results to stdout, everything else to stderr. A reader that goes away is no error. What is said holds
//! names from files: nothing passes here that a terminal would obey, but for the colours that the command itself sets.

use findings::visible::visible;
use std::io::{self, Write};

/// What a command may say.
#[derive(Debug)]
pub(crate) struct Screen {
    /// One JSON object on stdout instead of words.
    pub json: bool,
    /// No progress, no warnings.
    pub quiet: bool,
    /// Everything in words, and warnings one by one; otherwise a first screen.
    pub details: bool,
    /// Why a result could not be written.
    pub failed: Option<io::Error>,
}

impl Screen {
    pub(crate) fn new(json: bool, quiet: bool) -> Screen {
        Screen { json, quiet, details: true, failed: None }
    }

    /// Whether warnings are shown one by one as they come, and not on the first screen.
    pub(crate) fn tells_each(&self) -> bool {
        !self.quiet && (self.details || self.json)
    }

    /// Writes a result to stdout.
    pub(crate) fn result(&mut self, text: &str) {
        let text = visible(text);
        let mut stdout = io::stdout().lock();
        let written = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush());
        if let Err(error) = written
            && error.kind() != io::ErrorKind::BrokenPipe
        {
            self.failed = Some(error);
        }
    }

    /// Writes a remark to stderr. Where even that fails there is nobody left to tell.
    pub(crate) fn remark(&mut self, text: &str) {
        let _ = io::stderr().lock().write_all(painted(text).as_bytes());
    }
}

/// The text free of what acts, but for colours as `console` sets them.
pub(crate) fn painted(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(PAINT) {
        out += &visible(&rest[..at]);
        let behind = &rest[at + PAINT.len()..];
        let digits = behind.find(|character: char| !character.is_ascii_digit()).unwrap_or(behind.len());
        let is_colour = (1..=2).contains(&digits) && behind[digits..].starts_with('m');
        let end = at + PAINT.len() + if is_colour { digits + 1 } else { 0 };
        out += &if is_colour { rest[at..end].into() } else { visible(&rest[at..end]) };
        rest = &rest[end..];
    }
    out + &visible(rest)
}

/// How a colour begins.
const PAINT: &str = "\u{1b}[";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_pass_and_commands_do_not() {
        assert_eq!(painted("\u{1b}[31merror\u{1b}[0m: x"), "\u{1b}[31merror\u{1b}[0m: x");
        assert_eq!(painted("a\u{1b}[2Jb\u{1b}]0;c\u{7}"), "a\u{fffd}[2Jb\u{fffd}]0;c\u{fffd}");
        assert_eq!(painted("\u{1b}[38;5;1m\u{1b}["), "\u{fffd}[38;5;1m\u{fffd}[");
    }
}
