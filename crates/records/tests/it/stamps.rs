//! Clocks of time stamps, as loggers write them.

use crate::{judged, read_text, run_of, the};
use records::{Finding, Read, Recording, Severity};

/// A file of a Campbell Scientific logger as the program LoggerNet saves it.
const TOA5: &str = "\"TOA5\",\"site7\",\"CR6\",\"1234\",\"CR6.Std.10\",\"CPU:arch.CR6\",\"777\",\"Fast\"\n\
    \"TIMESTAMP\",\"RECORD\",\"crown displacement\",\"crown strain\"\n\
    \"TS\",\"RN\",\"mm\",\"microstrain\"\n\
    \"\",\"\",\"Smp\",\"Smp\"\n\
    \"2026-10-25 23:59:59.99\",0,0.25,0.05\n\
    \"2026-10-25 23:59:59.995\",1,\"NAN\",-0.10\n\
    \"2026-10-26 00:00:00\",2,-0.01,\"NAN\"\n\
    \"2026-10-26 00:00:00.005\",3,0.00,0.15\n";

fn read(text: &str) -> Read {
    read_text(text.as_bytes(), "x")
}

fn codes(read: &Read) -> Vec<&'static str> {
    read.findings.iter().map(|finding| finding.code).collect()
}

/// A run that was read without an error or a warning.
fn clean(text: &str) -> Recording {
    let read = read(text);
    let words: Vec<String> = read.findings.iter().map(Finding::words).collect();
    assert!(read.findings.iter().all(|finding| finding.severity == Severity::Note), "{text}\n{words:#?}");
    run_of(read)
}

#[test]
fn files_of_campbell_loggers_are_read_across_midnight() {
    let read = read(TOA5);
    assert_eq!(codes(&read), ["R004", "R006", "R016", "R021", "R021"], "{:?}", read.findings);
    assert!(the(&read.findings, "R006").message.contains("2026-10-25 23:59:59.99"));
    let run = run_of(read);
    assert_eq!(run.times, [0.0, 0.005, 0.01, 0.015]);
    assert_eq!((run.time_step_shown, run.channels.len()), (0.001, 2));
    assert_eq!(run.channels[0].title(), "crown displacement");
    assert_eq!(run.channels[0].values[..3].iter().map(|v| v.is_nan()).collect::<Vec<_>>(), [false, true, false]);
    assert!((run.channels[0].values[0] - 0.25e-3).abs() < 1e-18 && (run.channels[1].values[3] - 0.15e-6).abs() < 1e-21);
}

#[test]
fn one_clock_in_the_spellings_of_many_loggers() {
    let heads = "crown [mm]\n";
    for (heading, rows) in [
        ("time", ["2026-10-25T23:59:59.995Z", "2026-10-26T00:00:00.000Z", "2026-10-26T00:00:00.005Z"]),
        // The end of summer time does not move a clock that tells its zone.
        ("timestamp", ["2026-10-25T02:59:59.995+02:00", "2026-10-25T02:00:00+01:00", "2026-10-25T02:00:00.005+01:00"]),
        ("Date/Time", ["25/10/2026 23:59:59.995", "26/10/2026 00:00:00.000", "26/10/2026 00:00:00.005"]),
        ("DateTime", ["10/25/2026 11:59:59.995 PM", "10/26/2026 12:00:00.000 AM", "10/26/2026 12:00:00.005 AM"]),
        ("Date and Time (UTC)", ["25-Oct-2026 23:59:59.995", "26-Oct-2026 00:00:00", "26-Oct-2026 00:00:00.005"]),
        ("Time (hh:mm:ss.fff)", ["23:59:59.995", "00:00:00.000", "00:00:00.005"]),
        ("time [s]", ["23:59:59.995", "00:00:00.000", "00:00:00.005"]),
        ("time", ["59:59.995", "00:00.000", "00:00.005"]),
        ("date_time", ["20261025T235959.995", "20261026T000000.000", "20261026T000000.005"]),
    ] {
        let text = format!("{heading},{heads}{},0.1\n{},0.2\n{},0.3\n", rows[0], rows[1], rows[2]);
        assert_eq!(clean(&text).times, [0.0, 0.005, 0.01], "{text}");
    }
    let german = "Datum Zeit;crown [mm]\r\n25.10.2026 23:59:59,995;0,1\r\n26.10.2026 00:00:00,000;0,2\r\n26.10.2026 00:00:00,005;0,3\r\n";
    let run = clean(german);
    assert_eq!(run.times, [0.0, 0.005, 0.01]);
    assert!((run.channels[0].values[2] - 0.3e-3).abs() < 1e-15);
}

#[test]
fn dates_and_thousandths_may_have_columns_of_their_own() {
    let apart = "Date,Time,crown [mm]\n25/10/2026,23:59:59.995,0.1\n26/10/2026,00:00:00.000,0.2\n";
    assert_eq!(clean(apart).times, [0.0, 0.005]);
    let graphtec =
        "NO.,Date&Time,ms,crown\nNO.,Date&Time,ms,mm\n1,2026/10/25 23:59:59,995,0.1\n2,2026/10/26 00:00:00,000,0.2\n";
    let run = run_of(read(graphtec));
    assert_eq!((run.times, run.channels.len()), (vec![0.0, 0.005], 1));
}

#[test]
fn files_of_labview_and_catman_are_read() {
    let labview = "LabVIEW Measurement\t\nWriter_Version\t2\nDate\t2026/10/25\nTime\t23:59:59.9\n***End_of_Header***\t\n\t\n\
        Channels\t2\t\t\nDate\t2026/10/25\t2026/10/25\t\nTime\t23:59:59.9\t23:59:59.9\t\nY_Unit_Label\tmm\tmicrostrain\t\n\
        X_Dimension\tTime\tTime\t\nDelta_X\t0.005\t0.005\t\n***End_of_Header***\t\t\t\n\
        X_Value\tcrown\tstrain\tComment\n0.000\t0.10\t1.0\t\n0.005\t0.20\t2.0\n";
    let run = run_of(read(labview));
    assert_eq!((run.times, run.channels.len()), (vec![0.0, 0.005], 2));
    assert_eq!(run.channels[1].unit.symbol, "microstrain");
    let catman = "HBM_CATMAN_DATAFILE_40\nT0;25.10.2026 23:59:59\nTime  1 - default sample rate [s];crown [mm]\n0,000;0,10\n0,005;0,20\n";
    assert_eq!(run_of(read(catman)).times, [0.0, 0.005]);
}

#[test]
fn the_order_of_a_date_is_that_of_the_whole_file_or_is_asked_for() {
    let table = |rows: [&str; 2]| format!("time,crown [mm]\n{},0.1\n{},0.2\n", rows[0], rows[1]);
    // On one day it does not matter; past midnight the day goes on, whichever number that is.
    assert_eq!(clean(&table(["09/10/2026 12:00:00.0", "09/10/2026 12:00:00.1"])).times, [0.0, 0.1]);
    assert_eq!(clean(&table(["09/10/2026 23:59:59.9", "10/10/2026 00:00:00.0"])).times, [0.0, 0.1]);
    assert_eq!(clean(&table(["09/10/2026 23:59:59.9", "09/11/2026 00:00:00.0"])).times, [0.0, 0.1]);
    assert_eq!(clean(&table(["12/10/2026 23:59:59.9", "13/10/2026 00:00:00.0"])).times, [0.0, 0.1]);
    let unsure = read(&table(["01/02/2026 12:00:00.0", "03/04/2026 12:00:00.0"]));
    let finding = the(&unsure.findings, "R007");
    assert!(unsure.run.is_none() && finding.message.contains("`01/02/2026 12:00:00.0`"), "{}", finding.words());
    assert!(finding.message.contains("day, month, year or month, day, year") && finding.help.contains("2026-10-25"));
}

#[test]
fn a_row_with_another_stamp_is_left_out() {
    let read = read(
        "time,crown [mm]\n2026-10-25 12:00:00.0,0.1\nnoon,0.2\n2026-10-25 12:00:00.2Z,0.3\n2026-10-25 12:00:00.3,0.4\n",
    );
    let finding = the(&read.findings, "R025");
    assert!(finding.message.contains("2 times") && finding.help.contains("date and time"), "{}", finding.words());
    assert_eq!(run_of(read).times, [0.0, 0.3]);
}

/// Hundred rows a second for three seconds, stamped by the whole second.
fn coarse(stamp: impl Fn(usize) -> String) -> String {
    let rows = (0..300).map(|k| format!("{},{}\n", stamp(k), (k as f64 * 0.1).sin()));
    format!("time,crown [mm]\n{}", rows.collect::<String>())
}

#[test]
fn stamps_coarser_than_the_samples_are_named_with_what_to_do() {
    let text = coarse(|k| format!("2026-10-25 12:00:{:02}", k / 100));
    let series = judged(vec![run_of(read(&text))]);
    let finding = the(&series.findings, "R033");
    assert!(
        finding.message.contains("times show whole seconds") && finding.message.contains("up to 100 rows"),
        "{}",
        finding.words()
    );
    assert!(finding.help.contains("fractions of a second") && finding.help.contains("time [s]"), "{}", finding.help);
}

#[test]
fn a_clock_that_is_set_by_an_hour_is_told_of_summer_time() {
    let back = coarse(|k| {
        format!(
            "2026-10-25 0{}:{:02}:{:02}.{:02}",
            2,
            if k < 100 { 59 } else { 0 },
            if k < 100 { 59 } else { k / 100 - 1 },
            k % 100
        )
    });
    let series = judged(vec![run_of(read(&back))]);
    let finding = the(&series.findings, "R031");
    assert!(finding.help.contains("summer time"), "{} {}", finding.words(), finding.help);
}
