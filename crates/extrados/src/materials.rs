//! Materials of the library, written into a bridge file as plain values with remarks that name their source.

use crate::refusal::Refusal;
use bridge::edit::Document;
use bridge::material::materials;
use bridge::path::Path;

/// The text of a bridge file with a table filled from a material: `at` is the table, as `masonry` or `cover[2]`, `keys` what is taken. Each
/// value is the usual one of the library, and its remark says that it is not measured, between which ends it lies, and where it is from.
///
/// # Errors
/// A material or a key that there is none of, a table that it does not fill (F108), a text that cannot be edited (F114).
pub fn with_material(text: &str, at: &str, code: &str, keys: &[&str]) -> Result<String, Refusal> {
    let all = materials();
    let material = all.iter().find(|one| one.code.eq_ignore_ascii_case(code)).ok_or_else(|| {
        let known: Vec<&str> = all.iter().map(|one| one.code.as_str()).collect();
        Refusal::new("F108", format!("the library has no material \"{code}\""), format!("it has {}", known.join(", ")))
    })?;
    let table = at.split('[').next().unwrap_or_default();
    if !material.fills(table) {
        let message = format!("{} is no material of [{table}]", material.code);
        return Err(Refusal::new("F108", message, format!("it fills {}", material.tables.join(", "))));
    }
    let unfit = || Refusal::new("F114", format!("{at}: the file has no place for it"), "write the table by hand first");
    let mut document = Document::parse(text).ok_or_else(unfit)?;
    for key in keys {
        let value = material.values.iter().find(|value| value.key == *key).ok_or_else(|| {
            let known: Vec<&str> = material.values.iter().map(|value| value.key.as_str()).collect();
            let message = format!("the library knows no `{key}` of {}", material.code);
            Refusal::new("F108", message, format!("it knows {}", known.join(", ")))
        })?;
        let path = Path::parse(&format!("{at}.{key}")).ok_or_else(unfit)?;
        document.set(&path, &format!("\"{}\"", value.usual)).map_err(|_| unfit())?;
        document.remark(&path, &value.remark(material)).map_err(|_| unfit())?;
    }
    Ok(document.text())
}
