//! A page printed by a browser of this machine. Chromium, Chrome, Edge and Brave print without a window; Firefox and Safari do not.

use std::env;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The variable that names the browser, in place of the first that is found.
const NAMED: &str = "EXTRADOS_BROWSER";

/// Programs that print, as they are called on the search path.
const NAMES: [&str; 9] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "microsoft-edge",
    "microsoft-edge-stable",
    "msedge",
    "brave-browser",
];

/// Where systems keep them that put no programs on the search path.
const PLACES: [&str; 7] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
    r"C:\Program Files\Microsoft\Edge\Application\msedge.exe",
];

/// A browser that needs longer for a report of some twenty pages does not work.
const PATIENCE: Duration = Duration::from_secs(120);

/// The browser that the user names, or the first that is found.
pub(super) fn found() -> Result<Option<PathBuf>, String> {
    if let Some(named) = env::var_os(NAMED).filter(|named| !named.is_empty()) {
        let named = PathBuf::from(named);
        return if named.is_file() {
            Ok(Some(named))
        } else {
            Err(format!("{NAMED} names “{}”, which is no program", named.display()))
        };
    }
    let folders: Vec<PathBuf> = env::var_os("PATH").map_or_else(Vec::new, |path| env::split_paths(&path).collect());
    let named = NAMES
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(format!("{name}{}", env::consts::EXE_SUFFIX))));
    Ok(named.chain(PLACES.iter().map(PathBuf::from)).find(|file| file.is_file()))
}

/// The page as PDF, or why there is none. The browser works in `room` and reads nothing else.
pub(super) fn print(browser: &Path, html: &str, room: &Path) -> Result<Vec<u8>, String> {
    let told = |error: io::Error| format!("{}: {error}", browser.display());
    let room = std::path::absolute(room).map_err(told)?;
    let [page, printed, said] = ["report.html", "report.pdf", "said.txt"].map(|name| room.join(name));
    fs::write(&page, html).map_err(told)?;
    let mut last = String::new();
    // A browser keeps pages in a sandbox that administrators and most containers cannot have. This page is made here and runs no script.
    for freely in [&[][..], &["--no-sandbox"]] {
        let mut command = Command::new(browser);
        command
            .args([
                "--headless",
                "--disable-gpu",
                "--no-first-run",
                "--no-default-browser-check",
                "--disable-extensions",
            ])
            .args(["--disable-background-networking", "--no-pdf-header-footer"])
            .args(freely)
            .arg(format!("--user-data-dir={}", room.join("profile").display()))
            .arg(format!("--print-to-pdf={}", printed.display()))
            .arg(address(&page))
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(File::create(&said).map_err(told)?);
        let ended = patiently(&mut command).map_err(told)?;
        match (ended, fs::read(&printed)) {
            (Some(ended), Ok(bytes)) if ended.success() && bytes.starts_with(b"%PDF-") => return Ok(bytes),
            (None, _) => return Err(format!("{} did not end in {} s", browser.display(), PATIENCE.as_secs())),
            _ => last = fs::read_to_string(&said).unwrap_or_default(),
        }
        if !last.contains("sandbox") {
            break;
        }
    }
    let line = last.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or("it wrote none");
    Err(format!("{}: {line}", browser.display()))
}

/// Runs a program to its end; none where it takes too long, and is ended.
fn patiently(command: &mut Command) -> io::Result<Option<ExitStatus>> {
    let mut child = command.spawn()?;
    let begin = Instant::now();
    loop {
        if let Some(ended) = child.try_wait()? {
            return Ok(Some(ended));
        }
        if begin.elapsed() > PATIENCE {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        sleep(Duration::from_millis(20));
    }
}

/// A file as an address: characters with a meaning in addresses are written by their numbers.
fn address(file: &Path) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/-_.~:".contains(&byte);
    let text = file.display().to_string().replace('\\', "/");
    let path: String = text
        .bytes()
        .map(|byte| if plain(byte) { (byte as char).to_string() } else { format!("%{byte:02X}") })
        .collect();
    format!("file://{}{path}", if path.starts_with('/') { "" } else { "/" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_have_no_character_with_a_meaning() {
        assert_eq!(address(Path::new("/a b/50%#1/report.html")), "file:///a%20b/50%25%231/report.html");
        assert_eq!(address(Path::new(r"C:\bridges\report.html")), "file:///C:/bridges/report.html");
    }
}
