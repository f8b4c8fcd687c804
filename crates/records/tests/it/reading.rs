//! Tables as loggers and spreadsheets write them.

use crate::{read_text, run_of, the};
use records::{CARDS, Column, Dialect, Finding, Mapping, Others, Read, ReadOptions, Severity, Source, read};

/// Times and the first channel of a table, in SI.
fn first(read: Read) -> (Vec<f64>, Vec<f64>) {
    let run = run_of(read);
    let values = run.channels[0].values.clone();
    (run.times, values)
}

fn close(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-15 + 1e-12 * b.abs())
}

#[test]
fn one_table_in_many_spellings() {
    let utf16: Vec<u8> =
        "\u{feff}time_s,c_mm\n0.1,-0.3\n0.2,0.25\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let spellings: [&[u8]; 11] = [
        b"time [s],crown [mm]\n0.1,-0.3\n0.2,0.25\n",
        b"time [s];crown [mm]\r\n0,1;-0,3\r\n0,2;0,25\r\n",
        b"\xef\xbb\xbfTime (s)\tcrown (mm)\n0.1\t-0.3\n0.2\t0.25\n",
        b"# a comment\n\n% another\ntime_s,crown_mm\n0.1,-3e-1\n# amid\n0.2,+0.25\n",
        b"time [ms],crown [um]\r100,-300\r200,250\r",
        b"\"time [s]\";\"crown [mm]\"\n\"0,1\";\"-0,3\"\n\"0,2\";\"0,25\"\n",
        b"time;crown\ns;mm\n0.1;-0.3\n0.2;0.25\n",
        b"Logger 7\nStation,12\ntime [s],crown [mm]\n0.1,-0.3\n0.2,0.25",
        b" time [s] , crown [ mm ] \n 0.1 , -0.3 \n 0.2 , 0.25 \n",
        b"time [s],crown [mm],\n0.1,-0.3,\n0.2,0.25,\n",
        &utf16,
    ];
    for spelling in spellings {
        let text = String::from_utf8_lossy(spelling).into_owned();
        let read = read_text(spelling, "x");
        assert!(read.findings.iter().all(|finding| finding.severity < Severity::Error), "{text}\n{:?}", read.findings);
        let (times, values) = first(read);
        assert!(close(&times, &[0.1, 0.2]) && close(&values, &[-0.3e-3, 0.25e-3]), "{text}\n{times:?} {values:?}");
    }
}

#[test]
fn latin_1_is_read_and_named() {
    let read = read_text(b"time [s],crown [\xb5m]\n0.1,-3\n0.2,2\n", "x");
    assert!(the(&read.findings, "R002").message.contains("line 1"));
    assert!(close(&first(read).1, &[-3e-6, 2e-6]));
}

#[test]
fn a_mapping_says_what_headings_leave_open() {
    let column = |source, name: &str| Column::new(source, name);
    let mapping = Mapping {
        headed: true,
        time: Some(Column { unit: Some("s".to_owned()), ..column(Source::Heading("clock".to_owned()), "") }),
        channels: vec![
            Column {
                unit: Some("mm".to_owned()),
                line: Some("centre".to_owned()),
                sign: -1.0,
                scale: 2.5,
                ..column(Source::Heading("CH1".to_owned()), "crown displacement")
            },
            Column { scale: 0.0, ..column(Source::Number(3), "strain") },
            column(Source::Heading("CH9".to_owned()), "gone"),
        ],
        others: Others::PassOver,
    };
    let text = b"clock,CH1,CH2\n0.1,-0.2,7\n0.2,0.4,8\n";
    let read = read(text, &ReadOptions { name: "x".to_owned(), mapping, ..ReadOptions::default() });
    let words: Vec<&str> = read.findings.iter().map(|finding| finding.code).collect();
    assert_eq!(words, ["R014", "R014", "R015"], "{:?}", read.findings);
    let run = run_of(read);
    assert_eq!((run.channels.len(), run.channels[0].title().as_str()), (1, "crown displacement @ centre"));
    assert!(close(&run.channels[0].values, &[0.5e-3, -1e-3]));
}

#[test]
fn a_table_without_headings_goes_by_numbers() {
    let unit = |number, name: &str, unit: &str| Column {
        unit: Some(unit.to_owned()),
        ..Column::new(Source::Number(number), name)
    };
    let mapping = Mapping {
        headed: false,
        time: Some(unit(1, "", "s")),
        channels: vec![unit(2, "crown", "mm")],
        others: Others::PassOver,
    };
    let dialect = Dialect { separator: Some(';'), decimal_comma: Some(true) };
    let options = ReadOptions { mapping, dialect, ..ReadOptions::default() };
    let read = read(b"0,1;-0,3;1\n0,2;0,25;2\n", &options);
    assert!(close(&first(read).1, &[-0.3e-3, 0.25e-3]));
}

#[test]
fn notes_name_run_speed_and_origin() {
    let text = b"# run: slow\n# speed: 45 km/h\n# synthetic: computed\ntime [s],a [mm]\n0,1\n1,2\n";
    let run = run_of(read_text(text, "file.csv"));
    assert_eq!((run.name.as_str(), run.speed, run.synthetic.as_deref()), ("slow", Some(12.5), Some("computed")));
    let read = read_text(b"# speed: fast\ntime [s],a [mm]\n0,1\n1,2\n", "file.csv");
    assert!(the(&read.findings, "R003").message.contains("`fast`"));
    assert_eq!(run_of(read).name, "file.csv");
}

#[test]
fn what_cannot_be_read_says_what_to_write() {
    let cases: [(&str, &str, &str); 11] = [
        ("", "R001", "headings and rows"),
        ("crown [mm],strain [mm]\n1,2\n", "R010", "time [s]"),
        ("time [s]\n1\n", "R010", "name and unit"),
        ("time,crown [mm]\n1,2\n", "R011", "time [s]"),
        ("time,crown [mm]\n46320.1249,2\n", "R011", "time [d]"),
        ("timestamp,crown [mm]\n1792897194.005,2\n", "R011", "time [s]"),
        ("time [s],crown\n1,2\n", "R011", "[mm]"),
        ("time [s],crown [furlong],a [mm]\n1,2,3\n", "R012", "microstrain"),
        ("time [s],a [mm],a [mm]\n1,2,3\n", "R013", "of its own"),
        ("time [s],a [mm]\n1,2,3\n2,3,4\n", "R024", "semicolons"),
        ("time [s],a [mm]\nnoon,2\n", "R025", "as a number"),
    ];
    for (text, code, help) in cases {
        let read = read_text(text.as_bytes(), "x");
        let finding = read.findings.iter().find(|finding| finding.code == code);
        let finding = finding.unwrap_or_else(|| panic!("{text}: {:?}", read.findings));
        assert!(finding.help.contains(help), "{}", finding.words());
    }
}

#[test]
fn neighbouring_faults_are_one_finding_and_many_are_counted() {
    let mut text = String::from("time [s],a [mm]\n");
    for k in 0..1000 {
        let cell = if k < 5 || k % 3 == 0 { "x".to_owned() } else { k.to_string() };
        text += &format!("{k},{cell}\n");
    }
    let read = read_text(text.as_bytes(), "x");
    let first = &read.findings[0];
    assert_eq!((first.place.lines, first.place.column), (Some([2, 6]), Some(2)), "{}", first.words());
    assert!(first.message.starts_with("5 times"), "{}", first.words());
    assert!(read.findings.len() <= 51);
    let named: usize = read.findings.iter().map(times).sum();
    let missing = run_of(read).channels[0].values.iter().filter(|value| value.is_nan()).count();
    assert_eq!(named, missing);
}

fn times(finding: &Finding) -> usize {
    finding.message.split_once(" times ").and_then(|(count, _)| count.parse().ok()).unwrap_or(1)
}

#[test]
fn every_code_has_a_card_and_stands_in_the_page() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = std::fs::read_to_string(root.join("../../docs/theory/records.md")).expect("docs/theory/records.md");
    for card in CARDS {
        let row = format!("| {} | {} | {} |", card.code, card.title, card.text);
        assert!(page.contains(&row), "docs/theory/records.md lacks: {row}");
    }
    let mut open = vec![root.join("src")];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).expect("src").flatten() {
            if entry.path().is_dir() {
                open.push(entry.path());
                continue;
            }
            let text = std::fs::read_to_string(entry.path()).expect("source");
            for part in text.split("\"R0").skip(1) {
                let code = format!("R0{}", &part[..2]);
                assert!(CARDS.iter().any(|card| card.code == code), "{code} has no card");
            }
        }
    }
}
