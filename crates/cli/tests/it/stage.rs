//! A folder of its own for every test, and the command run in it.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// The program under test.
pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_extrados");

/// A machine that needs longer than this for a second's work is not going to finish.
const PATIENCE: Duration = Duration::from_secs(120);

/// A folder that is empty when the test begins.
pub(crate) struct Stage {
    /// Where it is.
    pub folder: PathBuf,
}

/// How a command ended.
pub(crate) struct Ending {
    /// Exit code; none when a signal ended it.
    pub code: Option<i32>,
    /// What it printed.
    pub stdout: String,
    /// What it remarked.
    pub stderr: String,
}

impl Stage {
    /// A folder for the test of this name.
    pub(crate) fn new(name: &str) -> Stage {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("the folder of build results can be written");
        Stage { folder }
    }

    /// A folder with an example in it, as `new` writes it.
    pub(crate) fn with_example(name: &str, example: &str) -> Stage {
        let stage = Stage::new(name);
        let ending = stage.run(&["new", "bridge", "--from", example]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        stage
    }

    /// The command with these words, not started yet.
    pub(crate) fn command(&self, words: &[&str]) -> Command {
        let mut command = Command::new(PROGRAM);
        command.args(words).current_dir(&self.folder).stdin(Stdio::null());
        command
    }

    /// Starts the command and leaves it to run.
    pub(crate) fn start(&self, words: &[&str]) -> Running {
        let child = self.command(words).stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
        Running(child.expect("the program starts"))
    }

    /// Runs the command to its end.
    pub(crate) fn run(&self, words: &[&str]) -> Ending {
        self.command(words).output().expect("the program starts").into()
    }

    /// Runs the command with --json; what it prints is one object with the common fields.
    pub(crate) fn object(&self, words: &[&str]) -> (Value, Ending) {
        let words: Vec<&str> = words.iter().copied().chain(["--json"]).collect();
        let ending = self.run(&words);
        (object(&ending.stdout), ending)
    }

    /// Writes a file.
    pub(crate) fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.folder.join(name), text).expect("the stage can be written");
    }

    /// Reads a file.
    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Names in a folder, in order; none where it is missing.
    pub(crate) fn names(&self, folder: &str) -> Vec<String> {
        let Ok(entries) = fs::read_dir(self.folder.join(folder)) else { return Vec::new() };
        let mut names: Vec<String> =
            entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

/// A command under way. It is ended with the test.
pub(crate) struct Running(Child);

impl Running {
    /// Waits until something is so; the command must not end before it is.
    pub(crate) fn wait_for(&mut self, what: &str, so: impl Fn() -> bool) {
        let begin = Instant::now();
        while !so() {
            assert!(begin.elapsed() < PATIENCE, "no sign of {what} after {PATIENCE:?}");
            let ended = self.0.try_wait().expect("the child can be asked");
            assert!(ended.is_none(), "it ended before {what}: {ended:?}");
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    /// Ends it as a loss of power would.
    pub(crate) fn kill(&mut self) {
        self.0.kill().expect("it is running");
        self.0.wait().expect("it ends");
    }

    /// Presses Ctrl-C; the object that it prints and its exit code.
    pub(crate) fn interrupted(mut self) -> (Value, Option<i32>) {
        let told = Command::new("kill").args(["-INT", &self.0.id().to_string()]).status().expect("kill is there");
        assert!(told.success(), "it ended before it was told");
        // The object is a few lines, less than a pipe holds.
        let code = self.0.wait().expect("it ends").code();
        let mut printed = String::new();
        let mut stdout = self.0.stdout.take().expect("stdout is read");
        std::io::Read::read_to_string(&mut stdout, &mut printed).expect("stdout is UTF-8");
        (object(&printed), code)
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl From<Output> for Ending {
    fn from(output: Output) -> Ending {
        Ending {
            code: output.status.code(),
            stdout: String::from_utf8(output.stdout).expect("stdout is UTF-8"),
            stderr: String::from_utf8(output.stderr).expect("stderr is UTF-8"),
        }
    }
}

/// The one object on stdout, with the fields that every object has.
pub(crate) fn object(stdout: &str) -> Value {
    let value: Value = serde_json::from_str(stdout).unwrap_or_else(|error| panic!("{error} in {stdout:?}"));
    assert!(
        value["schema"].as_str().is_some_and(|name| name.starts_with("extrados.") && name.ends_with("/1")),
        "{value}"
    );
    assert!(value["status"].is_string() && value["warnings"].is_array(), "{value}");
    assert!(value["wall_seconds"].as_f64().is_some_and(|seconds| seconds >= 0.0), "{value}");
    assert!(value["threads"].as_u64().is_some_and(|threads| threads >= 1), "{value}");
    assert_eq!(value["version"].as_str(), Some(extrados::VERSION));
    for warning in value["warnings"].as_array().into_iter().flatten() {
        assert!(warning["code"].is_string() && warning["message"].is_string(), "{warning}");
    }
    value
}

/// The object without what may differ from run to run.
pub(crate) fn numbers(mut value: Value) -> Value {
    let fields = value.as_object_mut().expect("an object");
    for key in ["wall_seconds", "threads", "warnings", "out", "files"] {
        fields.remove(key);
    }
    value
}

/// A number of an object.
pub(crate) fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} is {}", value[key]))
}

/// Codes of the warnings of an object.
pub(crate) fn codes(value: &Value) -> Vec<&str> {
    value["warnings"].as_array().into_iter().flatten().filter_map(|warning| warning["code"].as_str()).collect()
}
