//! A day's record: a million rows of ten channels. Work that grows with the square of the rows would not end.

use crate::{judged, read_text, run_of};
use std::fmt::Write as _;

#[test]
fn a_million_rows_of_ten_channels() {
    let rows = if cfg!(debug_assertions) { 20_000 } else { 1_000_000 };
    let mut text = String::from("time [s]");
    (0..10).for_each(|k| text += &format!(",c{k} [mm]"));
    text.push('\n');
    for row in 0..rows {
        let _ = write!(text, "{:.3}", row as f64 * 0.005);
        let phase = (row % 4000) as f64 / 4000.0;
        let value = 0.3 * (-((phase - 0.5) * 12.0).powi(2)).exp();
        for k in 0..10 {
            let _ = write!(text, ",{:.3}", value * (1.0 + 0.1 * f64::from(k)));
        }
        text.push('\n');
    }
    let read = read_text(text.as_bytes(), "day");
    assert!(read.findings.is_empty(), "{:?}", read.findings.first());
    let run = run_of(read);
    assert_eq!((run.times.len(), run.channels.len()), (rows, 10));
    let series = judged(vec![run]);
    assert!(series.left_out().is_empty(), "{:?}", series.findings.first());
}
