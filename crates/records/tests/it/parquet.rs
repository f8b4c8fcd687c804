//! Parquet files: with the feature the same run as from CSV, without it one refusal that says how to add it.

use crate::run_of;
use records::{ReadOptions, Severity, read};

#[cfg(not(feature = "parquet"))]
#[test]
fn without_the_feature_one_error_names_the_command_that_adds_it() {
    let found = read(b"PAR1 and whatever follows", &ReadOptions { name: "slow".to_owned(), ..ReadOptions::default() });
    assert!(found.run.is_none() && found.findings.len() == 1);
    let finding = &found.findings[0];
    assert_eq!((finding.code, finding.severity, finding.place.run.as_str()), ("R005", Severity::Error, "slow"));
    assert!(finding.help.contains("cargo install --path crates/cli --features parquet"), "{}", finding.words());
    let _ = run_of;
}

#[cfg(feature = "parquet")]
mod with {
    use super::*;
    use parquet::basic::Compression;
    use parquet::data_type::DoubleType;
    use parquet::file::metadata::KeyValue;
    use parquet::file::properties::WriterProperties;
    use parquet::file::writer::SerializedFileWriter;
    use parquet::schema::parser::parse_message_type;
    use std::sync::Arc;

    /// Columns of doubles, with gaps where None, as a file.
    fn written(columns: &[(&str, Vec<Option<f64>>)], notes: &[(&str, &str)], packing: Compression) -> Vec<u8> {
        let fields: String = columns.iter().map(|(name, _)| format!("OPTIONAL DOUBLE {name};")).collect();
        let schema = Arc::new(parse_message_type(&format!("message table {{ {fields} }}")).unwrap());
        let pairs = notes.iter().map(|(key, value)| KeyValue::new((*key).to_owned(), (*value).to_owned())).collect();
        let properties =
            WriterProperties::builder().set_compression(packing).set_key_value_metadata(Some(pairs)).build();
        let mut bytes = Vec::new();
        let mut writer = SerializedFileWriter::new(&mut bytes, schema, Arc::new(properties)).unwrap();
        let mut group = writer.next_row_group().unwrap();
        for (_, values) in columns {
            let mut column = group.next_column().unwrap().unwrap();
            let there: Vec<f64> = values.iter().flatten().copied().collect();
            let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
            column.typed::<DoubleType>().write_batch(&there, Some(&levels), None).unwrap();
            column.close().unwrap();
        }
        group.close().unwrap();
        writer.close().unwrap();
        bytes
    }

    fn columns() -> Vec<(&'static str, Vec<Option<f64>>)> {
        let value = |k: usize, size: f64| Some(size * (0.013 * k as f64).sin());
        vec![
            ("time_s", (0..300).map(|k| Some(f64::from(k) / 100.0)).collect()),
            ("crown_displacement_mm", (0..300).map(|k| value(k, -0.27)).collect()),
            ("crown_strain_microstrain", (0..300).map(|k| value(k, 21.4)).collect()),
        ]
    }

    fn as_csv(columns: &[(&str, Vec<Option<f64>>)]) -> String {
        let mut text = "# run: slow\n# speed: 20 km/h\n# synthetic: made up\n".to_owned();
        text += &(columns.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(",") + "\n");
        for k in 0..columns[0].1.len() {
            let cell =
                |(_, values): &(&str, Vec<Option<f64>>)| values[k].map_or(String::new(), |value| value.to_string());
            text += &(columns.iter().map(cell).collect::<Vec<_>>().join(",") + "\n");
        }
        text
    }

    const NOTES: [(&str, &str); 3] = [("run", "slow"), ("speed", "20 km/h"), ("synthetic", "made up")];

    #[test]
    fn a_file_is_the_run_that_its_csv_is_to_the_last_bit() {
        for packing in [Compression::UNCOMPRESSED, Compression::SNAPPY, Compression::GZIP(Default::default())] {
            let file = run_of(read(&written(&columns(), &NOTES, packing), &ReadOptions::default()));
            let text = run_of(read(as_csv(&columns()).as_bytes(), &ReadOptions::default()));
            assert_eq!((&file.channels, &file.times), (&text.channels, &text.times), "{packing}");
            assert_eq!((file.name.as_str(), file.speed, &file.synthetic), ("slow", text.speed, &text.synthetic));
        }
    }

    #[test]
    fn a_missing_value_is_named_by_its_row() {
        let mut holed = columns();
        holed[1].1[40] = None;
        let found = read(&written(&holed, &NOTES, Compression::SNAPPY), &ReadOptions::default());
        let finding = found.findings.iter().find(|finding| finding.code == "R022").expect("an empty cell");
        // The headings are line 1, the row of index 40 is line 42.
        assert_eq!((finding.place.lines, finding.place.column), (Some([42, 42]), Some(2)), "{}", finding.words());
    }

    #[test]
    fn whatever_the_bytes_are_nothing_breaks_off() {
        let good = written(&columns(), &NOTES, Compression::SNAPPY);
        std::panic::set_hook(Box::new(|_| {}));
        for k in 0..400 {
            let mut bytes = good.clone();
            match k % 2 {
                0 => bytes.truncate(4 + (k * 7919) % (good.len() - 4)),
                _ => {
                    let at = 4 + (k * 104_729) % (good.len() - 4);
                    bytes[at] ^= 1 << (k % 8);
                }
            }
            let found = read(&bytes, &ReadOptions::default());
            assert!(found.run.is_some() || found.findings.iter().any(|finding| finding.severity == Severity::Error));
        }
        let _ = std::panic::take_hook();
    }
}
