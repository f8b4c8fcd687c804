//! `extrados-pdf`: the strings of a report from standard input (JSON), as PDF to standard output. The command `extrados` calls the one that lies
//! beside it, with its own version: the two go together.

use std::io::{Read, Write, stderr, stdin, stdout};
use std::process::ExitCode;

fn main() -> ExitCode {
    match set() {
        Ok(()) => ExitCode::SUCCESS,
        Err(words) => {
            // Nobody is left to tell where this fails.
            let _ = writeln!(stderr(), "{words}");
            ExitCode::FAILURE
        }
    }
}

fn set() -> Result<(), String> {
    let own = env!("CARGO_PKG_VERSION");
    if std::env::args().nth(1).is_none_or(|asked| asked != own) {
        return Err(format!("extrados-pdf is of version {own}, and of another one than the command: install both anew"));
    }
    let mut strings = String::new();
    stdin().read_to_string(&mut strings).map_err(|error| error.to_string())?;
    let data = serde_json::from_str(&strings).map_err(|error| format!("these are no strings of a report: {error}"))?;
    let pdf = report_pdf::pdf(&data).map_err(|error| error.to_string())?;
    stdout().write_all(&pdf).map_err(|error| error.to_string())
}
