//! Every kind of file that the command reads, mutated: it answers or refuses, and never breaks.

use crate::stage::Stage;
use crate::tally::{End, Tally};
use crate::tiny::BRIDGE;
use crate::works::{LORRY, prepared};
use crate::{Draws, number};
use serde_json::Value;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};
use std::time::{Duration, Instant};

/// What a case is given before it is asked to end.
const PATIENCE: Duration = Duration::from_secs(20);
/// What it is given to end.
const GRACE: Duration = Duration::from_secs(5);

/// A kind of file, and the command that reads it.
struct Kind {
    name: &'static str,
    /// The file, in the stage.
    file: &'static str,
    command: &'static str,
    words: &'static [&'static str],
    /// A folder that is as it was before every case.
    state: Option<&'static str>,
    /// How often it is drawn: quick ones more often.
    weight: u64,
}

const fn kind(
    name: &'static str,
    file: &'static str,
    command: &'static str,
    words: &'static [&'static str],
    state: Option<&'static str>,
    weight: u64,
) -> Kind {
    Kind { name, file, command, words, state, weight }
}

const KINDS: [Kind; 21] = [
    kind("bridge file", "tiny.toml", "check", &["check", "tiny.toml", "--out", "m"], None, 6),
    kind(
        "bridge file",
        "tiny.toml",
        "collapse",
        &["collapse", "tiny.toml", "--method", "limit", "--out", "m"],
        None,
        3,
    ),
    kind("bridge file", "assess.toml", "assess", &["assess", "assess.toml", "--out", "m"], None, 2),
    kind("bridge file", "tiny.toml", "respond", &["respond", "tiny.toml", "--out", "m"], None, 1),
    kind("vehicles", "lorry.toml", "check", &["check", "assess.toml", "--out", "m"], None, 4),
    kind("rule", "rule.toml", "check", &["check", "ruled.toml", "--out", "m"], None, 4),
    kind("block model", "drawing/bridge.toml", "check", &["check", "drawing/bridge.toml", "--out", "m"], None, 4),
    kind("drawing (DXF)", "drawing/arch.dxf", "check", &["check", "drawing/bridge.toml", "--out", "m"], None, 5),
    kind(
        "drawing (DXF)",
        "drawing/arch.dxf",
        "convert",
        &["convert", "drawing/arch.dxf", "drawn.toml", "--overwrite"],
        None,
        3,
    ),
    kind("section", "scan.csv", "convert", &["convert", "scan.csv", "scan.toml", "--overwrite"], None, 5),
    kind("packing", "packing.csv", "check", &["check", "saved.toml", "--out", "m"], None, 3),
    kind("train", "train.csv", "check", &["check", "trained.toml", "--out", "m"], None, 3),
    kind("records", "records.csv", "update", &["update", "update.toml", "--records-only", "--out", "m"], None, 2),
    kind(
        "ranges",
        "ranges.toml",
        "vary",
        &["vary", "tiny.toml", "--method", "limit", "--ranges", "ranges.toml", "--most-runs", "4", "--out", "m"],
        None,
        2,
    ),
    kind(
        "checkpoint",
        "run/run.checkpoint",
        "collapse",
        &["collapse", "mill/case-1.toml", "--out", "run", "--keep-every", "0", "--tolerance", "1e-8", "--resume"],
        Some("run"),
        2,
    ),
    kind(
        "log",
        "sought/evaluations.log",
        "update",
        &["update", "update.toml", "--out", "sought", "--resume"],
        Some("sought"),
        1,
    ),
    kind(
        "result.json",
        "stood/result.json",
        "collapse",
        &["collapse", "tiny.toml", "--method", "limit", "--out", "stood"],
        Some("stood"),
        2,
    ),
    kind(
        "list of files",
        ".stood.extrados-files.json",
        "collapse",
        &["collapse", "tiny.toml", "--sweep", "--out", "stood"],
        Some("stood"),
        1,
    ),
    kind("stage", "judged/stages/STAGE", "assess", &["assess", "assess.toml", "--out", "judged"], Some("judged"), 2),
    kind("shard", "one/result.json", "merge", &["merge", "one", "two-of-two", "--out", "merged"], None, 3),
    kind("verification case", "case/case.toml", "verify", &["verify", "case"], None, 2),
];

/// A stage with every file, and the states before.
fn furnished(name: &str) -> Stage {
    let stage = prepared(name);
    let rule = include_str!("../../../rules/data/rules/cs-454.toml");
    let rule = rule.replacen("code = \"cs-454\"", "code = \"our-rule\"", 1);
    stage.write("rule.toml", rule.replacen("models = [\"cs-454\"", "models = [\"lorry\", \"cs-454\"", 1));
    let ruled = "\n[sweep]\nvehicles = [\"our-lorry\"]\nvehicle_files = [\"lorry.toml\"]\nrule_file = \"rule.toml\"\n";
    stage.write("ruled.toml", format!("{BRIDGE}{ruled}"));
    stage.write("lorry.toml", LORRY);
    let points: String = (0..120).fold("x [m],y [m]\n".to_owned(), |text, k| {
        let x = f64::from(k) * 8.0 / 119.0;
        let y = (16.0f64 - (x - 4.0) * (x - 4.0)).max(0.0).sqrt() * 0.5;
        format!("{text}{x:.4},{y:.4}\n")
    });
    stage.write("scan.csv", points);
    let grains: String =
        (0..40).map(|k| format!("{},{},0.05\n", 0.1 * f64::from(k % 20), 4.0 - 0.2 * f64::from(k / 20))).collect();
    stage.write("packing.csv", format!("x_m,y_m,radius_m,layer\n{grains}"));
    let fill = stage.read("fill.toml");
    stage.write("saved.toml", fill.replace("count = 120", "count = 120\nfile = \"packing.csv\""));
    stage.write("train.csv", "axle_load_t,distance_m\n10,0\n10,2.0\n12,5.5\n12,7.5\n");
    let (head, rest) = BRIDGE.split_once("[train]").expect("a train");
    let (_, tail) = rest.split_once("[track]").expect("a track");
    stage.write("trained.toml", format!("{head}[train]\nfile = \"train.csv\"\n\n[track]{tail}"));
    stage.write(
        "ranges.toml",
        "[[vary]]\nquantity = \"joint.friction_angle\"\nfrom = \"30 deg\"\nto = \"40 deg\"\npoints = 3\n",
    );
    fs::create_dir_all(stage.folder.join("case")).expect("a folder");
    stage.write("case/case.toml", include_str!("../../../../verification/walls/ferris-tin-loi-2/case.toml"));
    stage.write("case/blocks.toml", include_str!("../../../../verification/walls/ferris-tin-loi-2/blocks.toml"));
    states(&stage);
    // As they are, all of them are read: what is refused later is so for its mutation.
    for kind in KINDS.iter().filter(|kind| kind.state.is_none()) {
        let ending = stage.run(kind.words);
        assert!(matches!(ending.code, Some(0 | 1)), "{:?}: {}", kind.words, ending.stderr);
        let _ = fs::remove_dir_all(stage.folder.join("m"));
        let _ = fs::remove_dir_all(stage.folder.join("merged"));
    }
    stage
}

/// What runs leave behind: a checkpoint, a log, a result, stages, shards.
fn states(stage: &Stage) {
    let mut run = stage.start(&[
        "collapse",
        "mill/case-1.toml",
        "--out",
        "run",
        "--keep-every",
        "0",
        "--quiet",
        "--tolerance",
        "1e-8",
    ]);
    run.wait_for("a checkpoint", || stage.folder.join("run/run.checkpoint").is_file());
    run.kill();
    let done = |words: &[&str]| {
        let ending = stage.run(words);
        assert!(matches!(ending.code, Some(0 | 1)), "{words:?}: {}", ending.stderr);
    };
    done(&["update", "update.toml", "--out", "sought", "--quiet"]);
    done(&["collapse", "tiny.toml", "--method", "limit", "--out", "stood", "--quiet"]);
    done(&["assess", "assess.toml", "--out", "judged", "--quiet"]);
    let vary = ["vary", "tiny.toml", "--method", "limit", "--set", "joint.friction_angle=30deg,40deg", "--quiet"];
    for (shard, out) in [("1/2", "one"), ("2/2", "two-of-two")] {
        done(&vary.iter().copied().chain(["--shard", shard, "--out", out]).collect::<Vec<_>>());
    }
    for folder in ["run", "sought", "stood", "judged"] {
        copy(&stage.folder.join(folder), &stage.folder.join("before").join(folder));
        let list = format!(".{folder}.extrados-files.json");
        let _ = fs::copy(stage.folder.join(&list), stage.folder.join("before").join(&list));
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder").flatten() {
        let place = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &place);
        } else {
            fs::copy(entry.path(), place).expect("copied");
        }
    }
}

/// Sets a state back to what it was.
fn set_back(stage: &Stage, folder: &str) {
    let _ = fs::remove_dir_all(stage.folder.join(folder));
    copy(&stage.folder.join("before").join(folder), &stage.folder.join(folder));
    let list = format!(".{folder}.extrados-files.json");
    let _ = fs::copy(stage.folder.join("before").join(&list), stage.folder.join(&list));
}

/// The file with some changes: bytes, lines, numbers, characters that act.
fn mutated(bytes: &[u8], draws: &mut Draws) -> Vec<u8> {
    const NUMBERS: [&str; 14] = [
        "0",
        "-1",
        "1e308",
        "-1e308",
        "1e-308",
        "nan",
        "inf",
        "-0",
        "99999999999999999999",
        "1.5",
        "1e9",
        "2",
        "0.0000001",
        "1000000",
    ];
    const PIECES: [&str; 14] = [
        "\u{1b}[2J",
        "\u{202e}",
        "\0",
        "=1+1",
        "\"\"\"",
        "[[load]]\n",
        "\u{feff}",
        "\r",
        "\t",
        "é橋",
        "{",
        "]",
        "../../x",
        "\u{ffff}",
    ];
    let mut text = bytes.to_vec();
    for _ in 0..1 + draws.below(3) {
        let at = draws.below(text.len() + 1);
        match draws.below(9) {
            0 if at < text.len() => text[at] = draws.below(256) as u8,
            1 if at < text.len() => text[at] ^= 1 << draws.below(8),
            2 => text.truncate(at),
            3 => drop(text.drain(at..(at + 1 + draws.below(60)).min(text.len()).max(at))),
            4 => {
                let piece: Vec<u8> = text[at..(at + 1 + draws.below(200)).min(text.len()).max(at)].to_vec();
                let to = draws.below(text.len() + 1);
                text.splice(to..to, piece);
            }
            5 => {
                let piece = PIECES[draws.below(PIECES.len())].as_bytes().to_vec();
                text.splice(at..at, piece);
            }
            // A number becomes another one.
            6 | 7 => {
                let digit = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
                if let Some(start) = text[at.min(text.len())..].iter().position(digit).map(|ahead| at + ahead) {
                    let end =
                        text[start..].iter().position(|byte| !digit(byte)).map_or(text.len(), |ahead| start + ahead);
                    text.splice(start..end, NUMBERS[draws.below(NUMBERS.len())].bytes());
                }
            }
            _ => {
                let mut lines: Vec<Vec<u8>> = text.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
                let (one, two) = (draws.below(lines.len()), draws.below(lines.len()));
                if draws.below(2) == 0 {
                    lines.swap(one, two)
                } else {
                    drop(lines.remove(one))
                }
                text = lines.join(&b'\n');
            }
        }
    }
    text
}

/// Runs a command; none where it did not end in its time, though it was asked to.
fn ran(stage: &Stage, words: &[&str]) -> (Option<Output>, bool) {
    let words: Vec<&str> = words.iter().copied().chain(["--json", "--quiet"]).collect();
    let mut child = stage.command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    let mut pipes = (child.stdout.take().expect("stdout"), child.stderr.take().expect("stderr"));
    let reader = std::thread::spawn(move || {
        let mut read = (Vec::new(), Vec::new());
        let _ = (pipes.0.read_to_end(&mut read.0), pipes.1.read_to_end(&mut read.1));
        read
    });
    let (begin, mut asked) = (Instant::now(), None::<Instant>);
    let status = loop {
        if let Some(status) = child.try_wait().expect("it can be asked") {
            break status;
        }
        match asked {
            None if begin.elapsed() > PATIENCE => {
                let _ = std::process::Command::new("kill").args(["-TERM", &child.id().to_string()]).status();
                asked = Some(Instant::now());
            }
            Some(since) if since.elapsed() > GRACE => {
                let _ = child.kill();
                let _ = child.wait();
                return (None, true);
            }
            _ => {}
        }
        std::thread::sleep(Duration::from_millis(3));
    };
    let (stdout, stderr) = reader.join().expect("pipes are read");
    (Some(Output { status, stdout, stderr }), asked.is_some())
}

fn case(stage: &Stage, kind: &Kind, file: &Path, number: u64, tally: &mut Tally) {
    if let Some(folder) = kind.state {
        set_back(stage, folder);
    }
    let own = fs::read(file).expect("the file as it should be");
    let changed = mutated(&own, &mut Draws(number));
    fs::write(file, &changed).expect("the stage can be written");
    let (output, slow) = ran(stage, kind.words);
    fs::write(file, &own).expect("the stage can be written");
    let _ = fs::remove_dir_all(stage.folder.join("m"));
    let _ = fs::remove_dir_all(stage.folder.join("merged"));
    let mut broken = |what: String| {
        let kept = stage.folder.join(format!("broken-{number}"));
        let _ = fs::write(&kept, &changed);
        tally.fault(kind.name, kind.command, End::Broken, format!("{what} (seed {number}, {})", kept.display()));
    };
    let Some(output) = output else { return broken("it did not end".to_owned()) };
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let end = End::of(&output);
    let acts = |bytes: &[u8]| {
        String::from_utf8_lossy(bytes).chars().any(|one| one != '\n' && findings::visible::is_hidden(one))
    };
    if end == End::Broken || said.contains("panicked") {
        return broken(format!("exit {:?}: {said}", output.status));
    }
    if acts(&output.stdout) || acts(&output.stderr) {
        return broken("characters that act reach the terminal".to_owned());
    }
    match serde_json::from_slice::<Value>(&output.stdout) {
        Ok(object) if object["status"].is_string() => {}
        _ => return broken(format!("no object on stdout: {}", String::from_utf8_lossy(&output.stdout))),
    }
    tally.count(kind.name, kind.command, if slow { End::Slow } else { end });
}

/// The file of a kind in a stage; of stages of an assessment, one of them.
fn place(stage: &Stage, kind: &Kind, draws: &mut Draws) -> PathBuf {
    match kind.file.strip_suffix("STAGE") {
        Some(folder) => {
            let names = stage.names(folder);
            stage.folder.join(folder).join(&names[draws.below(names.len())])
        }
        None => stage.folder.join(kind.file),
    }
}

fn run(name: &str, cases: u64, seed: u64) -> Tally {
    const WORKERS: u64 = 2;
    let all: u64 = KINDS.iter().map(|kind| kind.weight).sum();
    let work = |worker: u64| {
        let stage = furnished(&format!("{name}-{worker}"));
        let mut tally = Tally::default();
        for kind in &KINDS {
            for turn in (0..(cases * kind.weight).div_ceil(all)).filter(|turn| turn % WORKERS == worker) {
                let number = seed.wrapping_mul(1_000_003).wrapping_add(turn);
                let file = place(&stage, kind, &mut Draws(number));
                case(&stage, kind, &file, number, &mut tally);
            }
        }
        tally
    };
    let mut tally = Tally::default();
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..WORKERS).map(|worker| scope.spawn(move || work(worker))).collect();
        workers.into_iter().for_each(|worker| tally.merge(worker.join().expect("a worker")));
    });
    tally
}

#[test]
fn robustness_a_few_files_are_mutated() {
    run("robustness-few-mutants", 60, 7).settle("Files that were mutated");
}

/// Thousands of files, as many of each kind as its weight says.
#[test]
#[ignore = "minutes"]
fn robustness_thousands_of_files_are_mutated() {
    run("robustness-mutants", number("EXTRADOS_MUTANTS", 3000), number("EXTRADOS_SEED", 1))
        .settle("Files that were mutated");
}
