//! Bridge files that come with the package, with what they take from other files.

/// Their names.
pub(crate) const NAMES: [&str; 7] = ["tiny", "bridgemill", "semicircle", "packhorse", "vehicles", "passage", "update"];

/// A file of an example: its name and its bytes.
pub(crate) type Companion = (&'static str, &'static [u8]);

macro_rules! file {
    ($path:literal) => {
        include_str!(concat!("../../../examples/", $path))
    };
}

/// The text of a bridge file and the files beside it.
pub(crate) type Example = (&'static str, Vec<Companion>);

/// The example of this name.
pub(crate) fn named(name: &str) -> Option<Example> {
    let alone = |text| Some((text, Vec::new()));
    match name {
        "tiny" => alone(file!("tiny/bridge.toml")),
        "bridgemill" => alone(file!("bridgemill/case-1.toml")),
        "semicircle" => alone(file!("semicircle/ring.toml")),
        "packhorse" => alone(file!("packhorse/cases.toml")),
        "vehicles" => alone(file!("bridgemill/vehicles.toml")),
        "passage" => alone(file!("railway-arch/passage.toml")),
        "update" => Some((
            file!("railway-arch/update.toml"),
            vec![("table-6.csv", file!("railway-arch/table-6.csv").as_bytes())],
        )),
        _ => None,
    }
}
