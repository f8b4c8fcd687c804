//! What goes wrong at the edges: files that are none, folders that cannot be written, readers that go away.

use crate::stage::{PROGRAM, Stage};
use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn a_missing_file_is_named() {
    let stage = Stage::new("misuse-missing");
    let ending = stage.run(&["collapse", "bridge.toml"]);
    assert_eq!(ending.code, Some(2));
    assert!(ending.stdout.is_empty());
    let expected = "error[F101]: cannot read bridge.toml: no such file or directory\n  help: check the path; `extrados new DIR` writes an example to start from\n";
    assert_eq!(ending.stderr, expected);
    assert!(stage.names(".").is_empty(), "nothing is left behind");
}

#[test]
fn a_folder_is_no_file() {
    let stage = Stage::new("misuse-folder");
    for command in ["check", "collapse"] {
        let (answer, ending) = stage.object(&[command, "."]);
        assert_eq!((ending.code, answer["status"].as_str()), (Some(2), Some("unusable-input")));
        assert_eq!(answer["errors"][0]["code"], "F101");
        assert!(ending.stderr.contains("it is a folder"));
    }
}

#[test]
fn results_that_cannot_be_written_are_refused_before_the_run() {
    let stage = Stage::with_example("misuse-unwritable", "bridgemill");
    stage.write("taken", "a file where the folder should be");
    for out in ["taken", "taken/below"] {
        let (answer, ending) = stage.object(&["collapse", "bridge/case-1.toml", "--out", out]);
        assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F102")), "{}", ending.stderr);
    }
    assert_eq!(stage.read("taken"), "a file where the folder should be");
}

#[test]
fn bad_input_leaves_no_folder_behind() {
    let stage = Stage::with_example("misuse-nothing", "bridgemill");
    let text = stage.read("bridge/case-1.toml").replace("rise = \"2.85 m\"", "rise = \"2.85 GPa\"");
    stage.write("bad.toml", text);
    for command in ["check", "collapse"] {
        let (answer, ending) = stage.object(&[command, "bad.toml"]);
        assert_eq!((ending.code, answer["status"].as_str()), (Some(2), Some("unusable-input")));
        let error = &answer["errors"][0];
        assert_eq!((error["code"].as_str(), error["file"].as_str()), (Some("B104"), Some("bad.toml")), "{error}");
        assert!(error["line"].as_u64().is_some_and(|line| line > 1) && error["column"] == 8, "{error}");
    }
    assert_eq!(stage.names("."), ["bad.toml", "bridge"]);
}

#[test]
fn an_analysis_that_cannot_be_set_up_says_what_is_missing() {
    let stage = Stage::with_example("misuse-stiffness", "tiny");
    let (answer, ending) = stage.object(&["collapse", "bridge/bridge.toml", "--method", "dem"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(2), Some("unusable-input")), "{}", ending.stderr);
    assert!(answer["errors"][0]["message"].as_str().is_some_and(|words| words.contains("stiffness")), "{answer}");
    assert!(stage.names("out").is_empty(), "an empty folder is taken away again");
}

#[test]
fn slips_on_the_command_line_are_one_object_too() {
    let stage = Stage::with_example("misuse-words", "tiny");
    for words in [
        vec!["colapse", "bridge/bridge.toml"],
        vec!["collapse"],
        vec!["collapse", "bridge/bridge.toml", "--threads", "0"],
        vec!["collapse", "bridge/bridge.toml", "--tolerance", "-1"],
        vec!["collapse", "bridge/bridge.toml", "--damping", "soft"],
        vec!["collapse", "bridge/bridge.toml", "--resolution", "1 m"],
        vec!["collapse", "bridge/bridge.toml", "--sweep", "--method", "dem"],
        vec!["collapse", "bridge/bridge.toml", "--sweep", "--method", "fe"],
        vec!["bench", "everything"],
    ] {
        let (answer, ending) = stage.object(&words);
        assert_eq!((ending.code, answer["status"].as_str()), (Some(2), Some("unusable-input")), "{words:?}");
        assert_eq!(answer["errors"][0]["code"], "F107", "{words:?}");
        assert!(!ending.stderr.is_empty());
    }
}

#[test]
fn new_never_overwrites() {
    let stage = Stage::with_example("misuse-new", "tiny");
    let before = stage.read("bridge/bridge.toml");
    let (answer, ending) = stage.object(&["new", "bridge", "--from", "tiny"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F103")));
    assert_eq!(stage.read("bridge/bridge.toml"), before);
    let (answer, ending) = stage.object(&["new", "other", "--from", "forth"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F104")));
    assert!(ending.stderr.contains("bridgemill") && stage.names("other").is_empty());
}

#[test]
fn an_unknown_code_is_refused() {
    let stage = Stage::new("misuse-explain");
    let (answer, ending) = stage.object(&["explain", "B999"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F105")));
}

#[test]
fn verify_wants_cases() {
    let stage = Stage::new("misuse-verify");
    let (answer, ending) = stage.object(&["verify", "."]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F111")));
    std::fs::create_dir(stage.folder.join("case")).expect("a folder");
    stage.write("case/case.toml", "title = 3");
    let (answer, ending) = stage.object(&["verify", "."]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F112")), "{}", ending.stderr);
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    for words in [["explain"].as_slice(), &["schema"]] {
        let mut child = Command::new(PROGRAM)
            .args(words)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        drop(child.stdout.take());
        let mut remarks = String::new();
        child.stderr.take().expect("stderr").read_to_string(&mut remarks).expect("UTF-8");
        assert_eq!(child.wait().expect("it ends").code(), Some(0), "{remarks}");
        assert!(remarks.is_empty(), "{remarks}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_stdout_is_an_error() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has it");
    let output = Command::new(PROGRAM).arg("schema").stdout(full).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&output.stderr).contains("F109"));
}
