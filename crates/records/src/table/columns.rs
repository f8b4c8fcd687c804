//! Parquet files as the text of a table, so that one reader judges both: heads and rows as a program would have written them as CSV.

/// A file as two texts.
pub(super) struct Texts {
    /// Comment lines: the keys and values that the file carries, `# speed: 45 km/h`.
    pub notes: String,
    /// Headings on the first line, then a line for each row.
    pub table: String,
}

/// Why a file is not read, and what to do.
pub(super) struct Refusal {
    pub message: String,
    pub help: &'static str,
}

/// Whether bytes are those of a Parquet file.
pub(super) fn is_parquet(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PAR1")
}

/// Without the feature, one refusal that tells how to add it.
#[cfg(not(feature = "parquet"))]
pub(super) fn texts(_: &[u8]) -> Result<Texts, Refusal> {
    let message = "the file is a Parquet file, which this program was built without".to_owned();
    Err(Refusal {
        message,
        help: "add it: cargo install --path crates/cli --features parquet; or save the table as CSV",
    })
}

#[cfg(feature = "parquet")]
pub(super) use reading::texts;

#[cfg(feature = "parquet")]
mod reading {
    use super::{Refusal, Texts};
    use bytes::Bytes;
    use parquet::errors::ParquetError;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    /// Rows that are read at the most: six hours at 2 kHz.
    const MOST: usize = 50_000_000;

    /// The file's columns in their order; an empty cell where a value is missing. The library may panic on bytes that are no
    /// such file, which is a refusal like any other.
    pub(crate) fn texts(bytes: &[u8]) -> Result<Texts, Refusal> {
        let copy = Bytes::copy_from_slice(bytes);
        let help = "write the file anew, or save the table as CSV";
        match catch_unwind(AssertUnwindSafe(|| read(copy))) {
            Ok(Ok(texts)) => Ok(texts),
            Ok(Err(error)) => Err(Refusal { message: format!("the Parquet file cannot be read: {error}"), help }),
            Err(_) => Err(Refusal { message: "the Parquet file is damaged".to_owned(), help }),
        }
    }

    fn read(bytes: Bytes) -> Result<Texts, ParquetError> {
        let reader = SerializedFileReader::new(bytes)?;
        let file = reader.metadata().file_metadata();
        let mut notes = String::new();
        for pair in file.key_value_metadata().into_iter().flatten() {
            let Some(value) = &pair.value else { continue };
            // Programs keep whole schemas there; a note is one line.
            if !value.contains(['\n', '\r']) && value.len() < 1000 {
                notes += &format!("# {}: {value}\n", pair.key);
            }
        }
        let columns: Vec<String> = file.schema().get_fields().iter().map(|field| field.name().to_owned()).collect();
        let mut table = line(columns.iter().map(|name| quoted(name)));
        for row in reader.get_row_iter(None)?.take(MOST) {
            table += &line(row?.get_column_iter().map(|(_, field)| cell(field)));
        }
        Ok(Texts { notes, table })
    }

    fn line(cells: impl Iterator<Item = String>) -> String {
        cells.collect::<Vec<_>>().join(",") + "\n"
    }

    fn quoted(text: &str) -> String {
        let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        if plain.contains([',', ';', '"', '\t']) { format!("\"{}\"", plain.replace('"', "\"\"")) } else { plain }
    }

    /// A value as it would stand in a table: floating-point numbers with the digits that give them back, times of day and dates
    /// in seconds.
    fn cell(field: &Field) -> String {
        match field {
            Field::Null => String::new(),
            Field::Float(value) => value.to_string(),
            Field::Double(value) => value.to_string(),
            Field::Float16(value) => f32::from(*value).to_string(),
            Field::TimeMillis(value) => seconds(i64::from(*value), 3),
            Field::TimestampMillis(value) => seconds(*value, 3),
            Field::TimeMicros(value) | Field::TimestampMicros(value) => seconds(*value, 6),
            Field::Str(text) => quoted(text),
            other => quoted(&other.to_string()),
        }
    }

    /// A whole number of parts of a second, without rounding.
    fn seconds(value: i64, digits: u32) -> String {
        let unit = 10_u64.pow(digits);
        let (whole, part) = (value.unsigned_abs() / unit, value.unsigned_abs() % unit);
        let sign = if value < 0 { "-" } else { "" };
        format!("{sign}{whole}.{part:0width$}", width = digits as usize)
    }

    #[cfg(test)]
    mod tests {
        use super::seconds;

        #[test]
        fn parts_of_a_second_keep_their_digits() {
            assert_eq!([seconds(1_005, 3), seconds(-40, 3), seconds(7, 6)], ["1.005", "-0.040", "0.000007"]);
        }
    }
}
