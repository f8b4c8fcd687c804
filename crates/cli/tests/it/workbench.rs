//! The workbench as its users open it; its server against hostile requests is tested where it is.

use crate::stage::Stage;

/// A program without the page says how to build one with it.
#[cfg(not(feature = "workbench"))]
#[test]
fn a_program_without_the_page_says_how_to_build_it() {
    let stage = Stage::new("workbench-without");
    let output = stage.command(&["workbench", "--no-browser"]).output().expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("F140") && said.contains(".ci/workbench build"), "{said}");
}

#[cfg(all(feature = "workbench", unix))]
mod with {
    use super::Stage;
    use std::io::{BufRead, BufReader, Read, Write};
    use std::net::TcpStream;
    use std::process::{Child, Command, Stdio};
    use std::time::{Duration, Instant};

    /// A workbench that runs, and its port.
    fn opened(stage: &Stage) -> (Child, u16) {
        let words = ["workbench", "--no-browser", "--port", "0"];
        let mut child = stage.command(&words).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("it starts");
        let mut line = String::new();
        BufReader::new(child.stderr.take().expect("stderr")).read_line(&mut line).expect("a line");
        let port =
            line.split("127.0.0.1:").nth(1).and_then(|rest| rest.split('/').next()).and_then(|port| port.parse().ok());
        (child, port.unwrap_or_else(|| panic!("no address in {line}: build the page first, .ci/workbench build")))
    }

    fn got(port: u16, path: &str, host: &str) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("a server");
        stream
            .write_all(format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").as_bytes())
            .expect("a request");
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).expect("an answer");
        String::from_utf8_lossy(&answer).into_owned()
    }

    /// Any web server gives out what is exported: the same bytes as this one does.
    #[test]
    fn the_page_is_exported_as_files() {
        let stage = Stage::new("workbench-export");
        let run = |words: &[&str]| stage.command(words).output().expect("it runs");
        assert_eq!(run(&["workbench", "--export", "page"]).status.code(), Some(0));
        let index = stage.read("page/index.html");
        let named: Vec<&str> = index.split(['"', '\'']).filter(|word| word.starts_with("./assets/")).collect();
        let there = stage.names("page/assets");
        let is_there = |name: &str| there.iter().any(|one| one.ends_with(name.trim_start_matches("./assets/")));
        assert!(named.len() >= 2 && named.iter().all(|name| is_there(name)), "{index} {there:?}");
        let again = run(&["workbench", "--export", "page"]);
        assert!(again.status.code() == Some(2) && String::from_utf8_lossy(&again.stderr).contains("F103"));
    }

    #[test]
    fn the_page_with_all_that_it_names_is_given_to_this_machine_alone() {
        let stage = Stage::new("workbench-with");
        let (mut child, port) = opened(&stage);
        let host = format!("127.0.0.1:{port}");
        let page = got(port, "/", &host);
        assert!(page.starts_with("HTTP/1.1 200") && page.contains("wasm-unsafe-eval"), "{page}");
        let named: Vec<&str> = page.split(['"', '\'']).filter(|word| word.starts_with("./assets/")).collect();
        assert!(named.len() >= 2, "{page}");
        for name in named {
            let file = got(port, &name[1..], &host);
            assert!(file.starts_with("HTTP/1.1 200") && file.contains("immutable"), "{name}");
        }
        assert!(got(port, "/", "evil.example").starts_with("HTTP/1.1 421"));
        assert!(got(port, "/../Cargo.toml", &host).starts_with("HTTP/1.1 404"));
        let second = ["workbench", "--no-browser", "--port", &port.to_string()];
        let output = stage.command(&second).output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains("in use") && said.contains("--port 0"), "{said}");
        let asked = Instant::now();
        assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill").success());
        assert_eq!(child.wait().expect("it ends").code(), Some(0));
        assert!(asked.elapsed() < Duration::from_secs(3), "{:?}", asked.elapsed());
    }
}
