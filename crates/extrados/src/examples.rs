//! The examples that come with the library, as they stand in `examples/`.

/// A file of an example.
#[derive(Debug)]
pub struct File {
    /// Its name, with a folder before it where there is one.
    pub name: &'static str,
    /// What it contains.
    pub text: &'static str,
}

/// A bridge with its files.
#[derive(Debug)]
pub struct Example {
    /// What it is called.
    pub name: &'static str,
    /// What it shows, in a line.
    pub about: &'static str,
    /// The file to start with.
    pub main: &'static str,
    /// All of its files.
    pub files: &'static [File],
}

impl File {
    /// What the file is, from its first comment; drawings have none.
    pub fn about(&self) -> &'static str {
        if self.name.ends_with(".dxf") {
            return "the drawing that it names";
        }
        self.text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or_default()
    }
}

impl Example {
    /// The command to start with: a bridge that a train crosses or a load test loads responds, cases are compared, every other one is
    /// brought to collapse.
    pub fn command(&self) -> &'static str {
        let main = self.files.iter().find(|file| file.name == self.main);
        let has = |section: &str| main.is_some_and(|file| file.text.lines().any(|line| line.starts_with(section)));
        match (has("[passage]") || has("[load_test]"), has("[[case]]")) {
            (true, _) => "respond",
            (false, true) => "cases",
            (false, false) => "collapse",
        }
    }
}

/// Every example: its name, what it shows, and its files, the one to start with first.
macro_rules! examples { ($($example:literal, $about:literal: $($name:literal),+;)*) => {
    /// Every example.
    pub const ALL: &[Example] = &[$(Example {
        name: $example,
        about: $about,
        main: [$($name),+][0],
        files: &[$(File { name: $name, text: include_str!(concat!("../../../examples/", $example, "/", $name)) }),+],
    }),*];
} }

examples! {
    "bridgemill", "the Bridgemill bridge, 18.3 m, tested to collapse":
        "case-1.toml", "case-2.toml", "case-3.toml", "case-4.toml", "whole.toml", "calibration.toml", "parabola.toml",
        "pressure.toml", "continuum.toml", "vehicles.toml", "vary.toml", "assess.toml", "hb-45.toml";
    "railway-arch", "a monitored railway arch of four spans, and the train that crosses it":
        "passage.toml", "update.toml", "update-table-1.toml", "second-twin.toml", "update-second-twin.toml",
        "assess.toml", "table-6.csv", "table-1/crawling.csv", "table-1/slow.csv", "table-1/design.csv";
    "road-bridge", "a road bridge from a load test with a weighed lorry to a verdict by CS 454":
        "bridge.toml", "load-test.csv";
    "prestwood", "the Prestwood bridge, 6.55 m, tested to collapse: fill that presses against movement":
        "limit.toml", "continuum.toml", "particles.toml";
    "tiny", "a small bridge in as few lines as will do":
        "bridge.toml";
    "semicircle", "a semicircular ring under its own weight: the least thickness that stands":
        "ring.toml";
    "two-span", "two spans on a slender pier that fail together":
        "bridge.toml";
    "viaduct", "a brick viaduct of three spans under every vehicle of a rule, on deformable joints":
        "bridge.toml";
    "two-ring", "a ring of two half-brick rings that may separate":
        "bridge.toml";
    "skew-railway", "a skew railway bridge of two spans and four rings, cracked, with what a report is signed with":
        "bridge.toml";
    "packhorse", "a rubble packhorse bridge with a humped road, and named cases of its loads":
        "cases.toml", "bridge.toml";
    "defects", "an arch as an inspection found it: mortar lost, rings separated, bricks spalled and soft":
        "bridge.toml";
    "gradient", "two spans on a gradient, a pier with cutwaters, abutments that can move, hollow spandrels":
        "bridge.toml";
    "settlement", "an abutment that gives way until a mechanism forms":
        "bridge.toml";
    "drawing", "blocks drawn by a CAD program (DXF): the ring of Bridgemill, case 1":
        "bridge.toml", "arch.dxf";
}

/// The example of this name.
pub fn named(name: &str) -> Option<&'static Example> {
    ALL.iter().find(|example| example.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_can_be_used() {
        for example in ALL {
            assert!(example.files.iter().any(|file| file.name == example.main), "{}", example.name);
            for file in example.files {
                let text = file.text.as_bytes();
                if file.name.ends_with(".csv") {
                    assert!(file.about().starts_with("synthetic: "), "{}/{}", example.name, file.name);
                } else if file.name.ends_with(".dxf") {
                    let read = drawing::read(text, &drawing::Options::default());
                    assert!(read.is_usable(), "{}/{}: {:?}", example.name, file.name, read.findings);
                } else if bridge::is_block_file(text) {
                    let read = bridge::read_blocks(text);
                    assert!(read.file.is_some(), "{}/{}: {:?}", example.name, file.name, read.diagnostics);
                } else {
                    let read = bridge::read(text);
                    assert!(read.bridge.is_some(), "{}/{}: {:?}", example.name, file.name, read.diagnostics);
                }
                assert!(!file.about().is_empty(), "{}/{} says nothing of itself", example.name, file.name);
            }
        }
    }
}
