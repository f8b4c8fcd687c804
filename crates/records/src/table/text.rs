//! From bytes to lines.

use crate::{Finding, Place};
use findings::Severity;

/// The text of a file, with what had to be done to read it.
pub(super) fn decode(bytes: &[u8], run: &str, findings: &mut Vec<Finding>) -> String {
    let mut warn = |message: String| {
        let place = Place { run: run.to_owned(), ..Place::default() };
        let help = "save the table as UTF-8 text";
        findings.push(Finding::new(Severity::Warning, "R002", place, message, help));
    };
    let of_two: fn([u8; 2]) -> u16 =
        if bytes.starts_with(&[0xff, 0xfe]) { u16::from_le_bytes } else { u16::from_be_bytes };
    if let [0xff, 0xfe, rest @ ..] | [0xfe, 0xff, rest @ ..] = bytes {
        warn("the file is UTF-16 text and was read as such".to_owned());
        let words: Vec<u16> = rest.chunks_exact(2).map(|pair| of_two([pair[0], pair[1]])).collect();
        return String::from_utf16_lossy(&words);
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(error) => {
            let line = 1 + bytes[..error.valid_up_to()].iter().filter(|byte| **byte == b'\n').count();
            warn(format!("line {line} is not UTF-8 text; the file was read as Latin-1"));
            bytes.iter().map(|byte| char::from(*byte)).collect()
        }
    }
}

/// Lines with their numbers, counted from 1, without their ends: "\n", "\r\n", or "\r" in a file that has no "\n".
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let end = if text.contains('\n') { '\n' } else { '\r' };
    text.split(end).enumerate().map(|(k, line)| (k + 1, line.strip_suffix('\r').unwrap_or(line)))
}

pub(super) fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with(['#', '%'])
}

/// Whether a line holds neither data nor comment.
pub(super) fn is_blank(line: &str) -> bool {
    line.trim().is_empty()
}
