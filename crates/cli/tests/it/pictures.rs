//! Pictures of the pages are those that their commands make: `EXTRADOS_WRITE_DOCS=1 cargo test --release -p cli --test it -- pictures tutorials`
//! writes them anew, with `--include-ignored` those of commands that take longer too. Look at each before it is kept.

use crate::stage::Stage;
use std::fs;
use std::path::Path;

/// More than this a page that is read on a phone does not load [bytes].
const LARGEST: usize = 150_000;

/// Numbers of a text, and the text with a mark where each stood.
fn parted(text: &str) -> (String, Vec<f64>) {
    let (mut words, mut numbers, mut at) = (String::new(), Vec::new(), 0);
    while let Some(start) = text[at..].find(|letter: char| letter.is_ascii_digit()).map(|start| at + start) {
        let end = text[start..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |end| start + end);
        let digits = text[start..end].trim_end_matches('.');
        // The digits of a colour are part of a word.
        let colour = text[..start].trim_end_matches(|c: char| c.is_ascii_hexdigit()).ends_with('#');
        words += &text[at..start];
        at = start + digits.len();
        match digits.parse() {
            Ok(number) if !colour => {
                words.push('\u{0}');
                numbers.push(number);
            }
            _ => words += digits,
        }
    }
    (words + &text[at..], numbers)
}

/// Where two drawings differ: in a word, or in a number by more than half a pixel.
fn difference(one: &str, other: &str) -> Option<String> {
    let ((words, numbers), (others, theirs)) = (parted(one), parted(other));
    if words != others {
        let at = words.chars().zip(others.chars()).take_while(|(a, b)| a == b).count();
        let near =
            |text: &str| text.chars().skip(at.saturating_sub(30)).take(80).collect::<String>().replace('\u{0}', "0");
        return Some(format!("`{}` is not `{}`", near(&words), near(&others)));
    }
    let mut pairs = numbers.iter().zip(&theirs);
    pairs.find(|(a, b)| (*a - *b).abs() > 0.5).map(|(a, b)| format!("{a} is not {b}"))
}

/// A drawing is the picture of this name, or is written as it where pages are written anew.
pub(crate) fn is_drawn(drawing: &str, name: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/images").join(name);
    assert!(drawing.len() < LARGEST, "{name} has {} bytes", drawing.len());
    if std::env::var_os("EXTRADOS_WRITE_DOCS").is_some() {
        fs::write(&path, drawing).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    let kept = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let differs = difference(drawing, &kept);
    assert!(
        differs.is_none(),
        "docs/images/{name} is not what its command draws: {}; EXTRADOS_WRITE_DOCS=1 writes it",
        differs.unwrap_or_default()
    );
}

/// The drawing of a report whose second line begins so.
pub(crate) fn of_report(report: &str, line: &str) -> String {
    let found = report.split("<svg ").skip(1).filter_map(|part| part.split_once("</svg>")).map(|(svg, _)| svg);
    let mut of_line = found.filter(|svg| svg.split("<text").nth(2).is_some_and(|text| text.contains(line)));
    format!("<svg {}</svg>\n", of_line.next().unwrap_or_else(|| panic!("the report draws no {line:?}")))
}

/// A bridge of the survey of profiles, as `docs/gallery.md` changes it.
fn profile(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../verification/profiles").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Runs a command line.
fn run(stage: &Stage, line: &str) {
    let ending = stage.run(&line.split(' ').collect::<Vec<_>>());
    assert_eq!(ending.code, Some(0), "{line}: {}", ending.stderr);
}

#[test]
fn pictures_are_those_of_their_commands() {
    let stage = Stage::new("pictures");
    let spans = profile("segmental.toml").replace("voussoirs = 44\n", "voussoirs = 44\nrepeat = 2\n");
    let pier = "[[pier]]\nwidth = \"1.1 m\"\nheight = \"6 m\"\ncourses = 12\n";
    stage.write("two-spans.toml", format!("{spans}{pier}"));
    for (line, pictures) in [
        ("new b --from bridgemill", &[][..]),
        (
            "collapse b/case-1.toml",
            &[
                ("out/case-1/mechanism.svg", "bridgemill-mechanism.svg"),
                ("out/case-1/thrust-line.svg", "bridgemill-thrust-line.svg"),
                ("out/case-1/collapse.svg", "bridgemill-collapse.svg"),
                ("out/case-1/load-displacement.svg", "bridgemill-load-displacement.svg"),
            ],
        ),
        ("collapse b/case-1.toml --method path --out path", &[("path/stiffness.svg", "bridgemill-stiffness.svg")]),
        (
            "vary b/case-1.toml --method limit --grid --set joint.friction_angle=8deg..20deg:5 --set span.thickness=-10%..+10%:5",
            &[("out/case-1-vary/heat-map.svg", "vary-heat-map.svg")],
        ),
        ("new inspected --from defects", &[]),
        ("check inspected/bridge.toml", &[("out/bridge/bridge.svg", "defects.svg")]),
        ("new packhorse --from packhorse", &[]),
        ("check packhorse/bridge.toml --out packhorse/out", &[("packhorse/out/bridge.svg", "packhorse-bridge.svg")]),
        ("cases packhorse/cases.toml", &[("out/cases/cases.svg", "packhorse-cases.svg")]),
        ("new mill-lane --from skew-railway", &[]),
        ("check mill-lane/bridge.toml --out mill-lane/out", &[("mill-lane/out/bridge.svg", "skew-railway-bridge.svg")]),
        ("new rings --from two-ring", &[]),
        ("collapse rings/bridge.toml --out rings/out", &[("rings/out/mechanism.svg", "two-rings-mechanism.svg")]),
        ("collapse two-spans.toml --method limit", &[("out/two-spans/mechanism.svg", "profiles-two-spans.svg")]),
    ] {
        run(&stage, line);
        for (made, picture) in pictures {
            is_drawn(&stage.read(made), picture);
        }
    }
}

#[test]
#[ignore = "two minutes; `vary.rs`, `walls.rs` and the continuum's own tests hold the numbers"]
fn pictures_of_long_commands_are_those_of_their_commands() {
    let stage = Stage::new("pictures-long");
    run(&stage, "new b --from bridgemill");
    run(&stage, "vary b/vary.toml");
    is_drawn(&stage.read("out/vary-vary/tornado.svg"), "vary-tornado.svg");
    run(&stage, "collapse b/continuum.toml");
    is_drawn(&stage.read("out/continuum/soil-stress.svg"), "continuum-stress.svg");
    stage.write("pointed.toml", profile("pointed.toml"));
    run(&stage, "collapse pointed.toml --method dem");
    is_drawn(&stage.read("out/pointed/mechanism.svg"), "profiles-pointed.svg");
    let ring = "{ thickness = \"0.3 m\", voussoirs = 44 }";
    let rings = profile("segmental.toml").replace("thickness = \"0.6 m\"\n", "");
    stage.write("two-rings.toml", rings.replace("voussoirs = 44", &format!("ring = [{ring}, {ring}]")));
    run(&stage, "collapse two-rings.toml --method dem");
    is_drawn(&stage.read("out/two-rings/mechanism.svg"), "profiles-two-rings.svg");
    // As on docs/verification/spandrel-wall.md: the wall ends at the level of the fill.
    let wall = stage
        .read("b/case-4.toml")
        .replace("brick_length = \"0.60 m\"", "top = \"0.203 m\"\nbrick_length = \"0.60 m\"");
    stage.write("wall.toml", wall);
    run(&stage, "collapse wall.toml");
    is_drawn(&stage.read("out/wall/mechanism.svg"), "spandrel-wall-mechanism.svg");
    is_drawn(&stage.read("out/wall/stress.svg"), "spandrel-wall-stress.svg");
}

#[test]
fn a_small_bridge_is_judged_as_the_readme_tells() {
    let stage = Stage::new("pictures-readme");
    let readme = include_str!("../../../../README.md");
    let words = readme.lines().filter_map(|line| line.strip_prefix("extrados "));
    let words: Vec<&str> = words.filter(|line| line.contains("mill-lane")).collect();
    let [new, check, assess] = words[..] else { panic!("{words:?}") };
    run(&stage, new);
    run(&stage, check);
    // What would change the verdict takes most of the time, and none of the numbers.
    let assess: Vec<&str> = assess.split(' ').chain(["--skip", "sensitivity"]).collect();
    let (answer, ending) = stage.object(&assess);
    assert_eq!(ending.code, Some(1), "{}", answer["head"]);
    assert!(
        answer["head"].as_str().is_some_and(|head| head.starts_with("Not adequate by CS 454")),
        "{}",
        answer["head"]
    );
    let governing = &answer["governing"];
    assert_eq!(governing["load_model"].as_str(), Some("cs454-bogie-10"), "{governing}");
    let factor = 1.0 / governing["utilisation"].as_f64().expect("a number");
    assert!(readme.contains(&format!("adequacy factor of {factor:.3}")), "{factor}");
    is_drawn(&of_report(&stage.read("out/bridge/report.html"), ">Mechanism<"), "assess-mechanism.svg");
}

#[test]
fn drawings_are_compared_by_words_and_numbers() {
    let one = r##"<text x="12.5" fill="#12a3b4">18.3 m</text>"##;
    assert_eq!(parted(one).1, [12.5, 18.3]);
    assert!(difference(one, &one.replace("12.5", "12.6")).is_none());
    assert!(difference(one, &one.replace("12.5", "14.5")).is_some());
    assert!(difference(one, &one.replace("#12a3b4", "#22a3b4")).is_some());
    assert!(difference(one, &one.replace(" m<", " ft<")).is_some());
}
