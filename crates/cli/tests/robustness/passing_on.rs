//! Results are passed on: no formulas in tables, nothing that acts on a terminal, no pictures from elsewhere, sizes and counts limited.

use crate::stage::Stage;
use crate::tiny::BRIDGE;
use calamine::{Data, Reader, Xlsx, open_workbook};
use serde_json::Value;

fn first_error(stage: &Stage, words: &[&str]) -> (Option<i32>, String, String) {
    let (answer, ending) = stage.object(words);
    let text = |key: &str| answer["errors"][0][key].as_str().unwrap_or_default().to_owned();
    (ending.code, text("code"), text("message"))
}

/// Whether a cell of text would be taken for a formula.
fn is_formula(cell: &str) -> bool {
    cell.starts_with(['=', '+', '-', '@', '\t', '\r']) && cell.parse::<f64>().is_err()
}

#[test]
fn no_cell_of_any_table_is_a_formula() {
    let stage = Stage::new("passing-on-formulas");
    let names = [
        "=HYPERLINK(\\\"http://evil.example\\\")",
        "+cmd|' /C calc'!A0",
        "@SUM(1)",
        "-2+3+cmd|' /C calc'!A0",
        "\\t=1",
        "a;=1",
    ];
    let cases: String = names.iter().map(|name| format!("\n[[case]]\nname = \"{name}\"\n")).collect();
    let named = BRIDGE.replace("name = \"Tiny\"", "name = \"=1+1\"").replace("name = \"crown\"", "name = \"=crown\"");
    stage.write("cases.toml", format!("{named}{cases}"));
    stage.write("bridge.toml", &named);
    stage.write("other.toml", named.replace("=1+1", "@2").replace("\"0.5 m\"", "\"0.45 m\""));
    for words in [
        &["cases", "cases.toml", "--out", "cases"][..],
        &["respond", "bridge.toml", "--out", "respond"],
        &["compare", "bridge.toml", "other.toml", "--out", "compare"],
        &["assess", "cases.toml", "--out", "assess"],
    ] {
        let ending = stage.run(&[words, &["--quiet"]].concat());
        assert!(matches!(ending.code, Some(0 | 1)), "{words:?}: {}", ending.stderr);
    }
    std::fs::create_dir_all(stage.folder.join("fleet")).expect("a folder");
    std::fs::copy(stage.folder.join("bridge.toml"), stage.folder.join("fleet/=a.toml")).expect("copied");
    assert!(matches!(stage.run(&["assess", "fleet", "--out", "listed", "--quiet"]).code, Some(0 | 1)));
    let mut seen = 0;
    for folder in ["cases", "respond", "compare", "assess", "listed"] {
        for name in stage.names(folder) {
            let path = stage.folder.join(folder).join(&name);
            if name.ends_with(".csv") {
                let mut table =
                    csv::ReaderBuilder::new().has_headers(false).flexible(true).from_path(&path).expect("a table");
                for cell in table.records().flatten().flat_map(|row| row.iter().map(str::to_owned).collect::<Vec<_>>())
                {
                    assert!(!is_formula(&cell), "{folder}/{name}: {cell}");
                    seen += usize::from(cell.starts_with('\''));
                }
            }
            if name.ends_with(".xlsx") {
                let mut book: Xlsx<_> = open_workbook(&path).expect("a workbook");
                for sheet in book.sheet_names() {
                    assert!(
                        book.worksheet_formula(&sheet).is_ok_and(|formulas| formulas.is_empty()),
                        "{folder}/{name} {sheet}"
                    );
                    for cell in book.worksheet_range(&sheet).expect("a sheet").rows().flatten() {
                        assert!(
                            !matches!(cell, Data::String(text) if is_formula(text)),
                            "{folder}/{name} {sheet}: {cell}"
                        );
                    }
                }
            }
        }
    }
    assert!(seen >= 5, "the names stand in the tables, made harmless: {seen}");
    // Numbers stay numbers.
    let channels = stage.read("respond/channels.csv");
    let row = channels.lines().nth(3).expect("rows");
    assert!(row.split(',').all(|cell| cell.parse::<f64>().is_ok()), "{row}");
}

#[test]
fn what_acts_on_a_terminal_is_refused_or_not_shown() {
    let stage = Stage::new("passing-on-terminal");
    for (escape, code) in
        [("\\u001b[2J", "U+001B"), ("\\u202e", "U+202E"), ("\\u2067", "U+2067"), ("\\u009b", "U+009B")]
    {
        stage.write("bridge.toml", BRIDGE.replace("name = \"Tiny\"", &format!("name = \"Tiny{escape}x\"")));
        let (ending, error, message) = first_error(&stage, &["check", "bridge.toml"]);
        assert_eq!((ending, error.as_str()), (Some(2), "B111"), "{message}");
        assert!(message.contains(code), "{message}");
    }
    // A name on two lines cannot say what the command says.
    stage.write("bridge.toml", BRIDGE.replace("name = \"Tiny\"", "name = \"\"\"Tiny\nADEQUATE\"\"\""));
    let ending = stage.run(&["check", "bridge.toml"]);
    assert!(ending.code == Some(0) && ending.stdout.starts_with("Tiny ADEQUATE, "), "{}", ending.stdout);
    // Raw bytes in every kind of file, and in the name of a file.
    let raw = "\u{1b}]0;title\u{7}\u{202e}\u{9b}31m";
    stage.write(
        "drawing.dxf",
        format!("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nL{raw}\n10\n0\n20\n0\n11\n1\n21\n{raw}\n0\nENDSEC\n0\nEOF\n"),
    );
    stage.write("scan.csv", format!("x{raw} [m],y{raw} [m]\n0,0\n1,{raw}\n"));
    stage.write(&format!("b{raw}.toml"), format!("{BRIDGE}\n# {raw}\n[{raw}]\n"));
    stage.write(
        "lorry.toml",
        crate::works::LORRY.replace("a plate", "a plate\\u001b[2J\\u202e").replace("our-lorry", "our-\\u202elorry"),
    );
    let sweep = "\n[sweep]\nvehicles = [\"our-lorry\", \"none\"]\nvehicle_files = [\"lorry.toml\"]\nrule = \"characteristic\"\n";
    stage.write("swept.toml", format!("{BRIDGE}{sweep}"));
    let file = format!("b{raw}.toml");
    for words in [
        &["convert", "drawing.dxf", "drawn.toml"][..],
        &["convert", "scan.csv", "scan.toml"],
        &["check", &file],
        &["check", "swept.toml"],
        &["check", raw],
        &["explain", raw],
        &[raw],
    ] {
        for more in [&[][..], &["--json"]] {
            let ending = stage.run(&[words, more].concat());
            for text in [&ending.stdout, &ending.stderr] {
                let acts = text.chars().find(|one| *one != '\n' && findings::visible::is_hidden(*one));
                assert_eq!(acts, None, "{words:?}: {text:?}");
            }
        }
    }
    for name in stage.names("out") {
        assert!(!name.chars().any(findings::visible::is_hidden), "{name:?}");
    }
}

const PICTURE: &[u8] = b"\x89PNG\r\n\x1a\nsecret-picture";

fn with_photograph(name: &str) -> String {
    format!(
        "{BRIDGE}\n[document]\n[[document.inspection]]\npart = \"barrel\"\nfinding = \"crack\"\nphotograph = \"{name}\"\n"
    )
}

/// Whether the report carries the picture, and the warning about it.
fn shown(stage: &Stage, more: &[&str]) -> (bool, String) {
    let (answer, ending) =
        stage.object(&[&["assess", "job/bridge.toml", "--quiet", "--skip", "sensitivity"], more].concat());
    assert!(matches!(ending.code, Some(0 | 1)), "{}", ending.stderr);
    let warnings = answer["warnings"].as_array().into_iter().flatten();
    let said = warnings.filter(|one| one["code"] == "F147").filter_map(|one| one["message"].as_str()).collect();
    (stage.read("out/bridge/report.html").contains("data:image/png"), said)
}

#[test]
fn pictures_come_from_the_folder_of_the_bridge() {
    let stage = Stage::new("passing-on-pictures");
    std::fs::create_dir_all(stage.folder.join("job/photos")).expect("a folder");
    stage.write("job/photos/own.png", PICTURE);
    stage.write("secret.png", PICTURE);
    stage.write("job/bridge.toml", with_photograph("photos/own.png"));
    assert_eq!(shown(&stage, &[]), (true, String::new()));
    let whole = stage.folder.join("secret.png").display().to_string();
    for outside in ["../secret.png", "photos/../../secret.png", &whole] {
        stage.write("job/bridge.toml", with_photograph(outside));
        let (there, said) = shown(&stage, &[]);
        assert!(!there && said.contains("--allow-outside"), "{outside}: {said}");
    }
    assert_eq!(shown(&stage, &["--allow-outside"]), (true, String::new()));
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../secret.png", stage.folder.join("job/linked.png")).expect("a link");
        stage.write("job/bridge.toml", with_photograph("linked.png"));
        let (there, said) = shown(&stage, &[]);
        assert!(!there && said.contains("outside"), "{said}");
        // Sizes are looked at before anything is read.
        stage.write("job/bridge.toml", with_photograph("/dev/zero"));
        let (there, said) = shown(&stage, &["--allow-outside"]);
        assert!(!there && said.contains("no plain file"), "{said}");
    }
    std::fs::File::create(stage.folder.join("job/large.png")).and_then(|file| file.set_len(200 << 30)).expect("sparse");
    stage.write("job/bridge.toml", with_photograph("large.png"));
    let (there, said) = shown(&stage, &[]);
    assert!(!there && said.contains("8 MiB"), "{said}");
}

/// Files that are larger than their kind, or may never end, are refused at once.
#[cfg(unix)]
#[test]
fn sizes_are_limited_before_reading() {
    let stage = Stage::new("passing-on-sizes");
    std::fs::File::create(stage.folder.join("huge")).and_then(|file| file.set_len(200 << 30)).expect("sparse");
    assert!(
        std::process::Command::new("mkfifo").arg(stage.folder.join("pipe")).status().is_ok_and(|done| done.success())
    );
    std::fs::create_dir_all(stage.folder.join("folder")).expect("a folder");
    let sweep = |key: &str, place: &str| {
        let asked = match key {
            "vehicle_files" => format!("rule = \"characteristic\"\nvehicle_files = [\"{place}\"]"),
            _ => format!("rule_file = \"{place}\""),
        };
        format!("{BRIDGE}\n[sweep]\nvehicles = [\"ra1\"]\n{asked}\n")
    };
    let train = |place: &str| {
        let (head, rest) = BRIDGE.split_once("[train]").expect("a train");
        format!("{head}[train]\nfile = \"{place}\"\n\n[track]{}", rest.split_once("[track]").expect("a track").1)
    };
    let drawn = |place: &str| include_str!("../../../../examples/drawing/bridge.toml").replace("arch.dxf", place);
    let packed = |place: &str| {
        include_str!("../../../../examples/bridgemill/case-3.toml")
            .replace("count = 1984", &format!("count = 1984\nfile = \"{place}\""))
    };
    let recorded = |place: &str| format!("{BRIDGE}{}", crate::works::SOUGHT.replace("records.csv", place));
    for place in ["huge", "pipe", "/dev/zero", "/dev/random"] {
        let files =
            [sweep("vehicle_files", place), sweep("rule_file", place), train(place), drawn(place), packed(place)];
        for (number, text) in files.iter().enumerate() {
            stage.write("bridge.toml", text);
            let (code, error, message) = first_error(&stage, &["check", "bridge.toml", "--quiet"]);
            assert_eq!(code, Some(2), "{place}, {number}: {error} {message}");
            assert!(message.contains("MiB") || message.contains("no plain file"), "{place}, {number}: {message}");
        }
        stage.write("bridge.toml", recorded(place));
        let (code, _, message) = first_error(&stage, &["update", "bridge.toml", "--quiet"]);
        assert!(
            code == Some(2) && (message.contains("MiB") || message.contains("no plain file")),
            "{place}: {message}"
        );
        stage.write("tiny.toml", BRIDGE);
        for words in [
            &["check", place][..],
            &["collapse", place],
            &["compare", place, "tiny.toml"],
            &["convert", place, "x.toml"],
            &["vary", "tiny.toml", "--ranges", place],
            &["assess", place],
        ] {
            let (code, error, message) = first_error(&stage, &[words, &["--quiet"]].concat());
            assert_eq!(code, Some(2), "{words:?}: {error} {message}");
        }
        let linked = stage.folder.join("x.dxf");
        let _ = std::fs::remove_file(&linked);
        std::os::unix::fs::symlink(
            if place.starts_with('/') { place.into() } else { stage.folder.join(place) },
            &linked,
        )
        .expect("a link");
        let (code, _, message) = first_error(&stage, &["convert", "x.dxf", "y.toml", "--quiet"]);
        assert!(
            code == Some(2) && (message.contains("MiB") || message.contains("no plain file")),
            "{place}: {message}"
        );
        // A checkpoint, and a log.
        std::fs::create_dir_all(stage.folder.join("o")).expect("a folder");
        for name in ["run.checkpoint", "result.json"] {
            let inside = stage.folder.join("o").join(name);
            let _ = std::fs::remove_file(&inside);
            std::os::unix::fs::symlink(
                if place.starts_with('/') { place.into() } else { stage.folder.join(place) },
                &inside,
            )
            .expect("a link");
        }
        let ending = stage.run(&["collapse", "tiny.toml", "--method", "limit", "--out", "o", "--resume", "--quiet"]);
        assert!(matches!(ending.code, Some(0 | 2)), "{place}: {}", ending.stderr);
    }
}

/// What is too many is refused with its limit, before anything is drawn or computed.
#[test]
fn counts_and_lengths_are_limited_by_name() {
    let stage = Stage::new("passing-on-counts");
    let many = |text: &str, count: usize| text.repeat(count);
    let load = "\n[[load]]\nkind = \"knife-edge\"\nforce = \"10 kN/m\"\nlength = \"0.3 m\"\nat = \"1/4 of span 1\"\n";
    let tables = BRIDGE.replace(
        "load = { kind = \"knife-edge\", force = \"10 kN/m\", length = \"0.3 m\", at = \"1/4 of span 1\" }\n",
        "",
    );
    let span =
        "span = { profile = \"segmental\", span = \"4 m\", rise = \"1 m\", thickness = \"0.5 m\", voussoirs = 9 }\n";
    assert!(BRIDGE.contains(span) && tables.len() < BRIDGE.len());
    let ring = "\n[[span.ring]]\nthickness = \"0.02 m\"\nvoussoirs = 9\n";
    let rings = |count: usize| {
        let open = "[[span]]\nprofile = \"segmental\"\nspan = \"4 m\"\nrise = \"1 m\"\n";
        format!("{}\n{open}{}", BRIDGE.replace(span, ""), many(ring, count))
    };
    let cover = "\n[[cover]]\nlayer = \"surfacing\"\nthickness = \"1 mm\"\ndensity = \"1800 kg/m^3\"\n";
    let case = "\n[[case]]\nname = \"NAME\"\n";
    let cases: String = (0..201).map(|k| case.replace("NAME", &format!("c{k}"))).collect();
    let name = |count: usize| BRIDGE.replace("name = \"Tiny\"", &format!("name = \"{}\"", "W".repeat(count)));
    let points: Vec<String> = (0..10_001).map(|k| format!("[\"{} m\", \"0.5 m\"]", f64::from(k) * 1e-4)).collect();
    let measured = format!(
        "span = {{ profile = \"measured\", points = [{}], thickness = \"0.5 m\", voussoirs = 9 }}\n",
        points.join(", ")
    );
    let pier = |courses: u32| {
        let spans = "[[span]]\nprofile = \"segmental\"\nspan = \"4 m\"\nrise = \"1 m\"\nthickness = \"0.5 m\"\nvoussoirs = 9\nrepeat = 200\n";
        format!(
            "{}\n{spans}\n[[pier]]\nwidth = \"1 m\"\nheight = \"3 m\"\ncourses = {courses}\n",
            BRIDGE.replace(span, "")
        )
    };
    let slope = |text: &str| BRIDGE.replace("ballast_slope = \"2:1\"", &format!("ballast_slope = \"{text}\""));
    let dispersal = |text: &str| {
        BRIDGE.replace("rule = \"uniform\"\nslope = \"2:1\"", &format!("rule = \"uniform\"\nslope = \"{text}\""))
    };
    let refused = [
        (name(201), "B110", "200"),
        (name(200_000), "B110", "200"),
        (BRIDGE.replace("name = \"crown\"", &format!("name = \"{}\"", "x".repeat(300))), "B110", "200"),
        (with_photograph(&"x".repeat(3000)), "B110", "2000"),
        (format!("{tables}{}", many(load, 201)), "B112", "200"),
        (format!("{BRIDGE}{}", many(cover, 50)), "B112", "50"),
        (format!("{BRIDGE}{cases}"), "B227", "200"),
        (rings(21), "B112", "20"),
        (BRIDGE.replace(span, &measured), "B112", "10000"),
        (pier(1000), "B212", "100000"),
        (BRIDGE.replace("voussoirs = 9", "voussoirs = 5001"), "B108", "5000"),
        (slope("2:1000000"), "B107", "1:10"),
        (dispersal("2:1000000"), "B107", "1:10"),
    ];
    for (text, code, limit) in refused {
        stage.write("bridge.toml", &text);
        let begin = std::time::Instant::now();
        let (answer, ending) = stage.object(&["check", "bridge.toml", "--quiet"]);
        let errors: Vec<&Value> = answer["errors"].as_array().into_iter().flatten().collect();
        let told = errors.iter().find(|one| one["code"] == code).unwrap_or_else(|| panic!("{code}: {errors:?}"));
        assert_eq!(ending.code, Some(2), "{code}: {told}");
        assert!(told.to_string().contains(limit), "{code}: {told} names {limit}");
        assert!(begin.elapsed().as_secs() < 5, "{code}: {:?}", begin.elapsed());
    }
    // Just inside, they are drawn.
    for text in
        [name(200), format!("{tables}{}", many(load, 200)), format!("{BRIDGE}{}", many(cover, 49)), slope("1:10")]
    {
        stage.write("bridge.toml", &text);
        let ending = stage.run(&["check", "bridge.toml", "--quiet"]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    }
}
