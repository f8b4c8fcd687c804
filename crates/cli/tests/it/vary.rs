//! `extrados vary`: the same bits whatever happens on the way, and nothing computed twice or in vain.

use crate::stage::{Stage, number, object};
use serde_json::Value;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// A machine that needs longer than this for a second's work is not going to finish.
const PATIENCE: Duration = Duration::from_secs(120);
const FILE: &str = "bridge/vary.toml";
/// Runs of about half a second each: discrete elements to collapse.
const LONG: [&str; 8] = [
    "vary",
    FILE,
    "--set",
    "joint.normal_stiffness=x0.5..x2:5",
    "--set",
    "masonry.density=-10%..+10%:2",
    "--json",
    "--quiet",
];

fn stage(name: &str) -> Stage {
    Stage::with_example(&format!("vary-{name}"), "bridgemill")
}

/// What must not depend on threads, interruptions and the cache: everything but times and where answers came from.
fn numbers(value: &Value) -> Value {
    let mut value = value.clone();
    let fields = value.as_object_mut().expect("an object");
    for key in ["wall_seconds", "threads", "out", "runs_from_cache"] {
        fields.remove(key);
    }
    let strip = |row: &mut Value| {
        for key in ["seconds", "cached"] {
            assert!(row.as_object_mut().expect("a row").remove(key).is_some(), "{key}");
        }
    };
    strip(&mut fields["baseline"]);
    fields["rows"].as_array_mut().expect("rows").iter_mut().for_each(strip);
    value
}

fn from_cache(value: &Value) -> u64 {
    value["runs_from_cache"].as_u64().expect("a count")
}

/// Waits for so many finished runs.
fn wait_for_runs(stage: &Stage, out: &str, runs: usize, child: &mut std::process::Child) {
    let begin = Instant::now();
    while stage.names(&format!("{out}/cache")).iter().filter(|name| name.ends_with(".json")).count() < runs {
        assert!(begin.elapsed() < PATIENCE, "no {runs} runs after {PATIENCE:?}");
        assert!(child.try_wait().expect("the child can be asked").is_none(), "it ended before it was interrupted");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn threads_change_no_bit_and_no_order() {
    let stage = stage("threads");
    for method in ["dem", "limit"] {
        let with = |threads: &str| {
            let out = format!("{method}-{threads}");
            let words = ["vary", FILE, "--method", method, "--threads", threads, "--out", &out];
            let set = ["--set", "span.thickness=-5%,+5%", "--set", "analysis.damping=local,viscous"];
            let (answer, ending) = stage.object(&[&words[..], if method == "dem" { &set } else { &[] }].concat());
            assert_eq!(ending.code, Some(0), "{}", ending.stderr);
            assert_eq!(answer["threads"].to_string(), threads);
            (numbers(&answer), out)
        };
        let ((one, first), (two, second)) = (with("1"), with("2"));
        assert_eq!(one, two, "{method}");
        for name in stage.names(&first).iter().filter(|name| name.ends_with(".csv") || name.ends_with(".svg")) {
            assert_eq!(stage.read(&format!("{first}/{name}")), stage.read(&format!("{second}/{name}")), "{name}");
        }
    }
}

#[test]
fn a_killed_command_goes_on_where_it_was() {
    let stage = stage("kill");
    let (whole, ending) = stage.object(&[&LONG[..6], &["--out", "whole"]].concat());
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let words = [&LONG[..], &["--threads", "1", "--out", "torn"]].concat();
    let mut child = stage.command(&words).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("it starts");
    wait_for_runs(&stage, "torn", 2, &mut child);
    child.kill().expect("it is running");
    child.wait().expect("it ends");
    assert_eq!(stage.names("torn"), ["cache"], "no half-written results");
    let kept = stage.names("torn/cache").iter().filter(|name| name.ends_with(".json")).count() as u64;
    let (resumed, ending) = stage.object(&[&LONG[..6], &["--out", "torn"]].concat());
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert!((2..8).contains(&kept) && from_cache(&resumed) >= kept, "{kept} kept, {} taken up", from_cache(&resumed));
    assert_eq!(numbers(&resumed), numbers(&whole));
    assert_eq!(stage.read("torn/vary.csv"), stage.read("whole/vary.csv"));
}

#[cfg(unix)]
#[test]
fn an_interrupted_command_keeps_what_is_finished_and_says_so() {
    let stage = stage("signal");
    let words = [&LONG[..], &["--threads", "1", "--out", "o"]].concat();
    let mut child = stage.command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    wait_for_runs(&stage, "o", 1, &mut child);
    let told = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    assert!(told.success());
    let output = child.wait_with_output().expect("it ends");
    let cancelled = object(&String::from_utf8_lossy(&output.stdout));
    assert_eq!((output.status.code(), cancelled["status"].as_str()), (Some(130), Some("cancelled")));
    let finished = cancelled["runs_finished"].as_u64().expect("a count");
    assert!((1..8).contains(&finished) && cancelled["runs"] == 8, "{cancelled}");
    assert_eq!(stage.names("o"), ["cache"]);
    assert_eq!(stage.names("o/cache").len() as u64, finished, "whole runs only");
}

#[test]
fn nothing_is_computed_twice_and_what_changed_is_computed_again() {
    let stage = stage("cache");
    let answer = || {
        let (answer, ending) = stage.object(&["vary", FILE, "--method", "limit", "--out", "o"]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        answer
    };
    let first = answer();
    let runs = first["runs"].as_u64().expect("a count");
    assert_eq!((from_cache(&first), runs), (0, 16));
    let second = answer();
    assert_eq!(from_cache(&second), runs);
    assert_eq!(numbers(&first), numbers(&second));
    assert_eq!(second["rows"][3]["seconds"], first["rows"][3]["seconds"], "the time is that of the computation");

    let text = stage.read(FILE);
    stage.write(FILE, text.replace("[joint]", "# a word more\n[joint]").replace("\"18.30 m\"", "\"1830 cm\""));
    assert_eq!(from_cache(&answer()), runs, "comments and units are no other bridge");
    stage.write(FILE, text.replace("\"2300 kg/m^3\"]", "\"2400 kg/m^3\"]"));
    assert_eq!(from_cache(&answer()), runs - 1, "one value is new");
    stage.write(FILE, text.replace("\"2.85 m\"", "\"2.86 m\""));
    let other = answer();
    assert_eq!(from_cache(&other), 0, "another bridge");
    assert_ne!(numbers(&other), numbers(&first));
    stage.write(FILE, &text);
    let name = &stage.names("o/cache")[0];
    for name in stage.names("o/cache") {
        let path = format!("o/cache/{name}");
        let half = stage.read(&path).len() / 2;
        stage.write(&path, &stage.read(&path)[..half]);
    }
    let mended = answer();
    assert_eq!((from_cache(&mended), numbers(&mended)), (0, numbers(&first)), "{name} is damaged and not believed");
}

#[test]
fn a_grid_turns_its_last_quantity_fastest_and_repeats_what_collapse_finds() {
    let stage = stage("grid");
    let set = ["--set", "joint.friction_angle=10deg,35.6deg", "--set", "span.thickness=0.6m,0.711m,0.8m"];
    let (answer, ending) = stage.object(&[&["vary", FILE, "--grid", "--method", "limit"], &set[..]].concat());
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let rows = answer["rows"].as_array().expect("rows");
    let values: Vec<(f64, f64)> = rows
        .iter()
        .map(|row| (number(&row["values"], "joint.friction_angle"), number(&row["values"], "span[1].thickness")))
        .collect();
    assert_eq!(values, [(10.0, 0.6), (10.0, 0.711), (10.0, 0.8), (35.6, 0.6), (35.6, 0.711), (35.6, 0.8)]);
    assert_eq!(rows[4]["outcomes"], answer["baseline"]["outcomes"], "the file's own values");
    assert!(answer["files"].as_array().is_some_and(|files| files.contains(&"heat-map.png".into())));
    assert_eq!(answer["sensitivity"].as_array().map(Vec::len), Some(0));

    // The same bridge by hand.
    let by_hand = stage.read(FILE).replace("\"0.711 m\"", "\"0.6 m\"").replace("\"35.6 deg\"", "\"10 deg\"");
    stage.write("hand.toml", by_hand);
    let (hand, _) = stage.object(&["collapse", "hand.toml", "--method", "limit"]);
    assert_eq!(rows[0]["outcomes"]["collapse_load_kn_per_m"], hand["collapse_load_kn_per_m"]);
    assert_ne!(hand["collapse_load_kn_per_m"], rows[1]["outcomes"]["collapse_load_kn_per_m"]);
}

#[test]
fn everything_that_is_wrong_is_said_at_once_and_nothing_is_started() {
    let stage = stage("wrong");
    let refused = |words: &[&str]| {
        let (answer, ending) = stage.object(&[&["vary", FILE, "--out", "o"], words].concat());
        assert_eq!((ending.code, answer["status"].as_str()), (Some(2), Some("unusable-input")), "{}", ending.stderr);
        assert!(stage.names("o").is_empty(), "nothing is started");
        let errors = answer["errors"].as_array().expect("errors").clone();
        for error in &errors {
            assert!(ending.stderr.contains(error["message"].as_str().expect("words")), "{error}");
            assert!(error["help"].as_str().is_some_and(|help| !help.is_empty()), "{error}");
        }
        errors
    };
    let codes = |errors: &[Value]| -> Vec<String> {
        errors.iter().map(|error| error["code"].as_str().unwrap_or_default().to_owned()).collect()
    };
    let paths = refused(&["--set", "joint.friction_angel=30deg", "--set", "span[2].rise=2m", "--set", "bridge.name=B"]);
    assert_eq!(codes(&paths), ["B501", "B502", "B501"]);
    assert!(
        paths[0]["message"].as_str().is_some_and(|message| message.contains("did you mean `joint.friction_angle`"))
    );
    assert!(paths[0]["help"].as_str().is_some_and(|help| help.contains("joint.friction_angle = \"35.6 deg\"")));

    let values =
        refused(&["--set", "joint.friction_angle=30deg,120deg,5kN", "--set", "masonry.rounding=10mm,300mm", "--grid"]);
    assert_eq!(codes(&values), ["F114", "F114", "F114"]);
    let said: Vec<&str> = values.iter().filter_map(|error| error["message"].as_str()).collect();
    assert!(said[0].starts_with("joint.friction_angle = \"120deg\"") && said[0].contains("B107"), "{said:?}");
    assert!(said[1].contains("expected an angle, found a force"), "{said:?}");
    assert!(said[2].starts_with("masonry.rounding = \"300mm\""), "{said:?}");

    let one = |words: &[&str]| codes(&refused(words)).join(" ");
    assert_eq!(one(&["--set", "joint.friction_angle=30deg..40deg"]), "B503");
    assert_eq!(one(&["--set", "span.thickness=0.7m", "--set", "span[1].thickness=0.8m"]), "B504");
    assert_eq!(one(&["--method", "limit", "--set", "analysis.method=dem,limit"]), "F116");
    stage.write(FILE, stage.read(FILE).split("# What a careful").next().expect("the bridge"));
    assert_eq!(one(&[]), "F113");
    let broken = "\n[[vary]]\nquantity = \"joint.cohesoin\"\nvalues = [\"1 kPa\"]\n[[vary]]\nquantity = \"load[4].at\"\nfrom = \"0\"\n";
    stage.write(FILE, stage.read(FILE) + broken);
    assert_eq!(one(&[]), "B501 B011 B011");
}

#[test]
fn too_many_runs_are_counted_and_refused_unless_allowed() {
    let stage = Stage::with_example("vary-many", "tiny");
    let file = "bridge/bridge.toml";
    let set = ["--set", "joint.friction_angle=20deg..40deg:2", "--set", "masonry.density=-10%..+10%:2"];
    let words = [&["vary", file, "--grid", "--method", "limit", "--out", "o"], &set[..]].concat();
    let (answer, ending) = stage.object(&[&words[..], &["--most-runs", "3"]].concat());
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F115")), "{}", ending.stderr);
    let message = answer["errors"][0]["message"].as_str().unwrap_or_default();
    assert!(message.starts_with("5 runs are more than 3: at ") && message.contains("thread"), "{message}");
    assert_eq!(stage.names("o/cache").len(), 1, "the file's own bridge, which the estimate is made from");
    let (answer, ending) = stage.object(&[&words[..], &["--most-runs", "5"]].concat());
    assert_eq!((ending.code, from_cache(&answer)), (Some(0), 1));
    let huge = ["joint.friction_angle", "joint.cohesion", "masonry.density", "bridge.width", "span.rise", "span.span"];
    let huge: Vec<String> = huge.iter().map(|path| format!("--set={path}=x1..x1.1:1000")).collect();
    let huge: Vec<&str> = huge.iter().map(String::as_str).filter(|word| !word.contains("cohesion")).collect();
    let (answer, _) = stage.object(&[&["vary", file, "--grid", "--method", "limit", "--out", "o"], &huge[..]].concat());
    assert_eq!(answer["errors"][0]["code"], "F115", "{answer}");
}

#[test]
fn a_run_that_fails_is_a_result() {
    let stage = stage("failing");
    let set = ["--set", "analysis.step_limit=10,2000000", "--set", "joint.friction_angle=1deg,35.6deg"];
    let (answer, ending) = stage.object(&[&["vary", FILE, "--out", "o"], &set[..]].concat());
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{}", ending.stderr);
    let status = |row: usize| answer["rows"][row]["status"].as_str().unwrap_or_default();
    assert_eq!([status(0), status(1), status(2)], ["step-limit", "collapsed", "unstable-under-self-weight"]);
    assert_eq!(answer["sensitivity"][1]["runs_without_outcome"], 1);
    assert!(stage.read("o/tornado.svg").contains("unstable-under-self-weight"));
    let table = stage.read("o/vary.csv");
    assert!(table.starts_with("run,varied,analysis.step_limit,joint.friction_angle [deg],status,"), "{table}");
    assert_eq!(table.lines().count(), 6);
    let (again, _) = stage.object(&[&["vary", FILE, "--out", "o"], &set[..]].concat());
    assert_eq!(from_cache(&again), 5, "failed runs are kept too");
}

#[test]
fn ranges_may_stand_in_a_file_of_their_own() {
    let stage = stage("ranges");
    stage.write(
        "ranges.toml",
        "[[vary]]\nquantity = \"analysis.friction\"\nvalues = [\"associated\", \"non-associated\"]\n",
    );
    let words = ["vary", "bridge/case-1.toml", "--ranges", "ranges.toml", "--method", "limit"];
    let (answer, ending) = stage.object(&words);
    assert_eq!((ending.code, &answer["runs"]), (Some(0), &3.into()), "{}", ending.stderr);
    assert_eq!(answer["rows"][1]["values"]["analysis.friction"], "non-associated");
    assert!(stage.names("out/case-1-vary").contains(&"result.json".to_owned()));
    stage.write("ranges.toml", "[[vary]]\nquantity = \"analysis.frictoin\"\nvalues = [1]\n[analysis]\nseed = 2\n");
    let (answer, ending) = stage.object(&words);
    assert_eq!(ending.code, Some(2));
    let places: Vec<_> =
        answer["errors"].as_array().expect("errors").iter().map(|e| (&e["code"], &e["line"])).collect();
    assert_eq!(places.len(), 2, "{answer}");
    assert!(ending.stderr.contains("ranges.toml:2:12"), "{}", ending.stderr);
}

#[test]
fn quantities_are_listed_and_another_number_can_be_asked_for() {
    let stage = stage("list");
    let (answer, ending) = stage.object(&["vary", "bridge/case-1.toml", "--list"]);
    let quantities = answer["quantities"].as_array().expect("quantities");
    assert_eq!(ending.code, Some(0));
    assert!(quantities.iter().any(|one| one["quantity"] == "analysis.seed" && one["by_default"] == true));
    assert!(quantities.iter().any(|one| one["quantity"] == "load[1].at" && one["value"] == "\"1/4 of span 1\""));
    let words = ["vary", FILE, "--method", "limit", "--set", "joint.friction_angle=8deg,35.6deg"];
    let (answer, _) = stage.object(&[&words[..], &["--outcome", "sliding_joints"]].concat());
    assert_eq!(answer["outcome"], "sliding_joints");
    assert!(number(&answer["sensitivity"][0]["high"], "outcome") > 0.0, "{}", answer["sensitivity"]);
    let (answer, ending) = stage.object(&[&words[..], &["--outcome", "nonsense"]].concat());
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F117")));
    assert!(answer["errors"][0]["help"].as_str().is_some_and(|help| help.contains("collapse_load_kn_per_m")));
}

#[test]
fn the_tutorial_shows_what_the_program_finds() {
    let page = include_str!("../../../../docs/tutorials/vary.md");
    let stage = Stage::with_example("vary-tutorial", "bridgemill");
    let commands = page.lines().filter_map(|line| line.strip_prefix("extrados vary b/"));
    let mut count = 0;
    for command in commands {
        let words: Vec<&str> = command.split_whitespace().collect();
        let file = format!("bridge/{}", words[0]);
        let ending = stage.run(&[&["vary", &file, "--quiet", "--out", "o"], &words[1..]].concat());
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        let shown = ending.stdout.split("\n\nThe table").next().unwrap_or_default();
        assert!(page.contains(shown.trim_end()), "{command} prints\n{shown}");
        count += 1;
    }
    assert_eq!(count, 3);
    let example = stage.read("bridge/vary.toml");
    for table in
        page.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap_or_default().split("\n\n")
    {
        let keys = table.lines().map(|line| line.split(" #").next().unwrap_or_default().trim_end());
        assert!(keys.into_iter().all(|line| example.contains(line)), "the example has {table}");
    }
}

/// Physics by another road: rigid blocks whose only weight is their own carry in proportion to it, and an arch in which
/// nothing slides does not know its friction.
#[test]
fn the_load_of_rigid_blocks_is_proportional_to_their_weight() {
    let stage = stage("physics");
    let words = ["vary", FILE, "--method", "limit", "--set", "masonry.density=x0.5..x2:4:geometric"];
    let (answer, _) = stage.object(&[&words[..], &["--set", "joint.friction_angle=25deg,40deg"]].concat());
    let load =
        |row: &Value| number(&row["outcomes"], "collapse_load_kn_per_m") / number(&row["values"], "masonry.density");
    let own = load(&answer["baseline"]);
    for row in &answer["rows"].as_array().expect("rows")[..4] {
        // The solver closes its gap to 1e-8 of the load.
        assert!((load(row) / own - 1.0).abs() < 1e-7, "{row}");
    }
    assert!((number(&answer["sensitivity"][0], "elasticity") - 1.0).abs() < 1e-6, "{}", answer["sensitivity"][0]);
    assert_eq!(answer["sensitivity"][1]["trend"], "flat");
}
