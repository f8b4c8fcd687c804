//! The house stands as ARCHITECTURE.md draws it.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Every Rust file below a folder.
fn sources(folder: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![root().join(folder)];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())).flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    assert!(!found.is_empty(), "{folder} holds no source");
    found
}

/// The code of a file without its comments and tests.
fn code(path: &Path) -> String {
    let text = read(path);
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// Words between backticks that name a place in the repository.
fn places(page: &str) -> Vec<&str> {
    let words = page.split('`').skip(1).step_by(2);
    words.filter(|word| word.contains('/') && !word.contains([' ', '<', '*', ':', '"'])).collect()
}

#[test]
fn every_place_that_the_architecture_names_exists() {
    let page = read(&root().join("ARCHITECTURE.md"));
    let named = places(&page);
    assert!(named.len() > 20, "the page names its places: {named:?}");
    for place in named {
        assert!(root().join(place).exists(), "ARCHITECTURE.md names {place}, which does not exist");
    }
}

#[test]
fn every_crate_and_top_folder_is_in_the_architecture() {
    let page = read(&root().join("ARCHITECTURE.md"));
    let crates = fs::read_dir(root().join("crates")).expect("crates").flatten();
    for entry in crates.filter(|entry| entry.path().join("Cargo.toml").is_file()) {
        let place = format!("`crates/{}", entry.file_name().to_string_lossy());
        assert!(page.contains(&place), "ARCHITECTURE.md does not name {place}`");
    }
    for folder in ["examples", "docs", "validation", "verification", ".ci"] {
        assert!(page.contains(&format!("`{folder}/")), "ARCHITECTURE.md does not name {folder}");
    }
}

#[test]
fn no_engine_imports_another_and_none_has_more_than_six_files() {
    let folder = "crates/assess/src/analysis/engine";
    let engines = ["continuum", "dem", "elements", "limit", "path"];
    let modules = read(&root().join(folder).join("mod.rs"));
    for engine in engines {
        assert!(modules.contains(&format!("mod {engine};")), "{engine}");
        let files = sources(&format!("{folder}/{engine}"));
        assert!(files.len() <= 6, "{engine} has {} files", files.len());
        for file in files {
            let code = code(&file);
            for other in engines.iter().filter(|other| **other != engine) {
                let names = [format!("engine::{other}"), format!("super::{other}")];
                let named = names.iter().find(|name| code.contains(name.as_str()));
                assert!(named.is_none(), "{} names {named:?}", file.display());
            }
        }
    }
}

#[test]
fn no_crate_depends_on_one_above_it() {
    let dependencies = |name: &str| {
        let text = read(&root().join("crates").join(name).join("Cargo.toml"));
        let start = text.find("[dependencies]").expect("dependencies");
        let end = text[start..].find("\n[").map_or(text.len(), |length| start + length);
        text[start..end].to_owned()
    };
    let crates = [
        "findings",
        "bridge",
        "drawing",
        "scan",
        "records",
        "mechanics",
        "calibrate",
        "rules",
        "outcome",
        "structure",
        "assess",
        "verification",
        "figures",
        "report",
        "extrados",
        "workbench",
        "cli",
    ];
    let allowed = [
        ("findings", ""),
        ("bridge", "findings"),
        ("drawing", "findings"),
        ("scan", ""),
        ("records", "findings"),
        ("mechanics", ""),
        ("calibrate", ""),
        ("rules", "findings"),
        ("outcome", "findings bridge records calibrate rules"),
        ("structure", "findings bridge drawing mechanics outcome"),
        ("assess", "findings bridge records mechanics calibrate rules outcome structure"),
        ("verification", "bridge drawing mechanics rules outcome structure assess"),
        // Drawn and printed from results alone: no solver.
        ("figures", "findings bridge drawing outcome"),
        ("report", "findings bridge outcome"),
        (
            "extrados",
            "findings bridge drawing records mechanics calibrate rules outcome structure assess figures report",
        ),
        // A page comes through the door like any other program.
        ("workbench", "extrados"),
        (
            "cli",
            "findings bridge drawing scan records mechanics calibrate rules outcome structure assess verification figures report extrados",
        ),
    ];
    for (name, may) in allowed {
        let text = dependencies(name);
        for other in crates.iter().filter(|other| !may.split(' ').any(|one| one == **other)) {
            assert!(!text.contains(&format!("{other}.workspace")), "{name} must not depend on {other}");
        }
    }
}

/// The words of the page each name a public type in the crates that it gives, and in no other.
#[test]
fn a_word_means_one_thing() {
    let table = read(&root().join("docs/decisions/words.md"));
    let rows: Vec<Vec<&str>> =
        table.lines().filter(|line| line.starts_with("| `")).map(|line| line.split('|').collect()).collect();
    assert!(rows.len() > 10, "the table has its rows");
    for path in sources("crates").iter().filter(|path| path.to_string_lossy().contains("/src/")) {
        let text = code(path);
        for row in &rows {
            let word = row[1].trim().trim_matches('`');
            let defined = text.lines().filter_map(|line| line.trim().strip_prefix("pub ")).any(|line| {
                let mut parts = line.split(|c: char| !c.is_alphanumeric() && c != '_');
                matches!(parts.next(), Some("struct" | "enum" | "trait" | "type")) && parts.next() == Some(word)
            });
            let here = places(row[3]).iter().any(|place| path.starts_with(root().join(place)));
            assert!(!defined || here, "{} has another {word}", path.display());
        }
    }
}

/// A word of a bridge file is an enumeration's, and nothing matches it as text.
#[test]
fn no_word_of_a_bridge_file_is_matched_as_text() {
    for path in sources("crates/bridge/src/fields").into_iter().chain(sources("crates/bridge/src/ring")) {
        for line in code(&path).lines() {
            let arm = line.trim().strip_prefix('"').and_then(|rest| rest.split_once("\" =>"));
            let word = arm.is_some_and(|(word, _)| !word.contains([' ', '"']));
            assert!(!word && !line.contains("Some(\""), "{} matches text: {line}", path.display());
        }
    }
}

#[test]
fn the_methods_do_not_use_one_another() {
    let methods = ["dem", "limit", "path", "fem"];
    let pairs = methods.iter().flat_map(|one| methods.iter().filter(move |two| one != *two).map(move |two| (one, two)));
    for (folder, other) in pairs {
        for path in sources(&format!("crates/mechanics/src/{folder}")) {
            let text = code(&path);
            for use_of in [format!("crate::{other}"), format!("super::super::{other}"), format!("use super::{other}::")]
            {
                let own = use_of.starts_with("use super") && path.with_file_name(other).exists();
                assert!(own || !text.contains(&use_of), "{} uses {other}", path.display());
            }
        }
    }
}

#[test]
fn mechanics_and_calibrate_have_no_file_clock_thread_print_or_format_and_no_bridge_words() {
    const NOT_HERE: [&str; 13] = [
        "std::fs",
        "std::io",
        "std::net",
        "std::env",
        "std::time",
        "std::thread",
        "std::process",
        "println!",
        "eprintln!",
        "serde_json",
        "HashMap",
        "current_num_threads",
        "ThreadPool",
    ];
    const BRIDGE_WORDS: [&str; 5] = ["voussoir", "extrados", "intrados", "springing", "spandrel"];
    for path in sources("crates/mechanics/src").into_iter().chain(sources("crates/calibrate/src")) {
        let text = code(&path);
        for word in NOT_HERE.iter().chain(&BRIDGE_WORDS) {
            assert!(!text.to_lowercase().contains(&word.to_lowercase()), "{} speaks of {word}", path.display());
        }
    }
}

/// The library reads files through its trait, and no clock at all: it runs where there is neither.
#[test]
fn the_door_has_one_place_for_files_and_none_for_clocks() {
    for path in sources("crates/extrados/src") {
        let (text, place) = (code(&path), path.to_string_lossy().replace('\\', "/"));
        assert!(place.ends_with("/files.rs") || !text.contains("std::fs"), "{place} reads files");
        for word in ["Instant", "SystemTime", "std::thread", "std::process", "println!", "std::env::"] {
            assert!(!text.contains(word), "{place} has {word}");
        }
    }
}

#[test]
fn reading_computes_nothing_and_touches_no_file() {
    for path in ["findings", "bridge", "drawing", "scan", "records", "rules"]
        .iter()
        .flat_map(|name| sources(&format!("crates/{name}/src")))
    {
        let text = code(&path);
        for word in ["std::fs", "std::net", "std::env", "std::time", "std::process", "println!", "eprintln!", "HashMap"]
        {
            assert!(!text.contains(word), "{} speaks of {word}", path.display());
        }
    }
}

/// States of runs say what is kept of them, and one file makes bytes of it.
#[test]
fn bytes_of_kept_states_are_made_in_one_place() {
    for path in sources("crates").iter().filter(|path| !path.ends_with("house.rs")) {
        let here = path.ends_with("crates/mechanics/src/kept.rs");
        assert_eq!(code(path).contains("postcard::"), here, "{}", path.display());
    }
}

#[test]
fn what_analyses_has_no_format() {
    for folder in ["structure", "assess", "drawing", "figures", "cli"] {
        for path in sources(&format!("crates/{folder}/src")) {
            let text = code(&path);
            let derives = text.lines().any(|line| line.contains("derive(") && line.contains("erialize"));
            assert!(!derives, "{} derives a format", path.display());
        }
    }
}

#[test]
fn no_text_of_the_project_names_a_machine() {
    let mut pages = vec![root().join("README.md"), root().join("ARCHITECTURE.md")];
    pages.extend(sources("crates"));
    for path in pages.iter().filter(|path| !path.ends_with("house.rs")) {
        let text = read(path);
        for word in ["/home/", "/work/", "/root/", "artifactory"] {
            assert!(!text.contains(word), "{} names {word}", path.display());
        }
    }
}
