//! report.pdf, where the program was built with the feature `pdf`.

use ::outcome::warning;
use ::report::Material;

/// The report as PDF, or code and words of the warning that stands in its place.
#[cfg(feature = "pdf")]
pub fn pdf(material: &Material<'_>) -> Result<Vec<u8>, [String; 2]> {
    report_pdf::pdf(&::report::data(material))
        .map_err(|error| [warning::UNSET_PDF.to_owned(), format!("report.pdf is not written: {error}")])
}

/// The report as PDF, or code and words of the warning that stands in its place.
#[cfg(not(feature = "pdf"))]
pub fn pdf(_: &Material<'_>) -> Result<Vec<u8>, [String; 2]> {
    let words = "report.pdf is not written, report.html holds the same; to have both: cargo install --path crates/cli --features pdf";
    Err([warning::WITHOUT_PDF.to_owned(), words.to_owned()])
}
