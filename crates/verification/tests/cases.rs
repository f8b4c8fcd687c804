//! One test per verification case: `cargo test --test cases` runs the quick ones, with `-- --include-ignored` all.

use libtest_mimic::{Arguments, Failed, Trial};
use std::path::Path;
use verification::{Case, Class};

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../verification");
    let folders = verification::discover(&root).expect("the verification folder can be read");
    let trials = folders
        .into_iter()
        .map(|folder| {
            let read = Case::read(&folder);
            let name = read.as_ref().map_or_else(|e| e.path.clone(), |c| c.name.clone());
            let slow = read.as_ref().is_ok_and(|c| c.class == Class::Slow);
            Trial::test(name, move || {
                let judged = verification::run(&read?);
                if judged.verdict.is_well() { Ok(()) } else { Err(Failed::from(verification::table(&[judged]))) }
            })
            .with_ignored_flag(slow)
        })
        .collect();
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
