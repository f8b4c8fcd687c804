//! Bridge files that come with the package, with what they take from other files: some of the library's examples under names of their own.

use extrados::examples;

/// Name, the example of the library with its bridge file, and the files beside it.
const ALL: [(&str, &str, &str, &[&str]); 7] = [
    ("tiny", "tiny", "bridge.toml", &[]),
    ("bridgemill", "bridgemill", "case-1.toml", &[]),
    ("semicircle", "semicircle", "ring.toml", &[]),
    ("packhorse", "packhorse", "cases.toml", &[]),
    ("vehicles", "bridgemill", "vehicles.toml", &[]),
    ("passage", "railway-arch", "passage.toml", &[]),
    ("update", "railway-arch", "update.toml", &["table-6.csv"]),
];

/// Their names.
pub(crate) fn names() -> Vec<&'static str> {
    ALL.map(|(name, ..)| name).to_vec()
}

/// The text of a bridge file and the files beside it: names and bytes.
pub(crate) type Example = (&'static str, Vec<(&'static str, &'static [u8])>);

/// The example of this name.
pub(crate) fn named(name: &str) -> Option<Example> {
    let (_, example, file, beside) = ALL.iter().find(|(own, ..)| *own == name)?;
    let all = examples::named(example)?.files;
    let text = |name: &str| all.iter().find(|one| one.name == name).map(|one| one.text);
    let beside = beside.iter().map(|name| Some((*name, text(name)?.as_bytes())));
    Some((text(file)?, beside.collect::<Option<_>>()?))
}
