//! Why work cannot begin: what is wrong, and what to do about it.

use assess::analysis::AnalysisError;
use bridge::vary::Slip;
use std::fmt::Display;
use std::io;
use std::path::Path;

/// A file or a request that cannot be used. Answers such as collapse and non-convergence are none of these.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, thiserror::Error)]
#[error("{message} ({code}); {help}")]
pub struct Refusal {
    /// Stable code; `extrados explain CODE` tells more.
    pub code: &'static str,
    /// What is wrong, with its place.
    pub message: String,
    /// What to write or do instead.
    pub help: String,
}

impl Refusal {
    /// A refusal in these words.
    pub fn new(code: &'static str, message: impl Into<String>, help: impl Into<String>) -> Refusal {
        Refusal { code, message: message.into(), help: help.into() }
    }

    /// A file that cannot be read.
    pub fn unreadable(path: &Path, error: &io::Error) -> Refusal {
        let help = match error.kind() {
            io::ErrorKind::NotFound => "check the path; `extrados new DIR` writes an example to start from",
            io::ErrorKind::IsADirectory => "name a file in that folder",
            io::ErrorKind::PermissionDenied => "make the file readable for you",
            _ => "check the path and the disk",
        };
        Refusal::new("F101", format!("cannot read {}: {}", path.display(), reason(error)), help)
    }

    /// A file that a key of the bridge file names and that cannot be read.
    pub(crate) fn companion(key: &str, name: &str, path: &Path, error: &io::Error) -> Refusal {
        if error.kind() != io::ErrorKind::NotFound {
            return Refusal::unreadable(path, error);
        }
        let message = format!("`{key}` names {name}, and there is no {}", path.display());
        Refusal::new(
            "F101",
            message,
            "put that file beside the bridge file, or correct its name there; paths are relative to the bridge file",
        )
    }

    /// An analysis that cannot be set up.
    pub fn not_set_up(error: &impl Display) -> Refusal {
        Refusal::new("F108", error.to_string(), "extrados explain F108 tells what each analysis needs")
    }
}

/// Several refusals as one, with the code and the help of the first: for `?` where one is enough.
impl From<Vec<Refusal>> for Refusal {
    fn from(all: Vec<Refusal>) -> Refusal {
        let messages: Vec<&str> = all.iter().map(|one| one.message.as_str()).collect();
        let message = messages.join("; ");
        all.into_iter()
            .next()
            .map_or_else(|| Refusal::new("F108", "nothing is told", ""), |first| Refusal { message, ..first })
    }
}

impl From<AnalysisError> for Refusal {
    fn from(error: AnalysisError) -> Refusal {
        Refusal::not_set_up(&error)
    }
}

impl From<Slip> for Refusal {
    fn from(slip: Slip) -> Refusal {
        Refusal::new(slip.code, slip.message, slip.help)
    }
}

impl From<Refusal> for Vec<Refusal> {
    fn from(refusal: Refusal) -> Vec<Refusal> {
        vec![refusal]
    }
}

/// The system's words without its number.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    match text.find(" (os error") {
        Some(end) => text[..end].to_lowercase(),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_file_is_named_with_a_remedy() {
        let refusal = Refusal::unreadable(Path::new("a.toml"), &io::Error::from_raw_os_error(2));
        assert_eq!(refusal.message, "cannot read a.toml: no such file or directory");
        assert!(refusal.help.contains("extrados new"));
    }
}
