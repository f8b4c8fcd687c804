//! A fitted section as the beginning of a bridge file, and its deviations as a table.

use outcome::section::Section;
use std::fmt::Write;

/// A bridge file with the measured profile; what a section does not say stands there as a line to fill in, which the reader refuses
/// until that is done.
pub fn span_file(name: &str, section: &Section) -> String {
    let name = name.replace(['\n', '\r'], " ");
    let (left_out, kept) = (section.left_out().count(), section.points.iter().filter(|p| !p.is_left_out).count());
    let mut page = format!(
        "# Fitted to {kept} points of a surveyed section; {left_out} more left out as outliers.\n\
         # They scatter by {:.1} mm (root mean square) about the curve.\n\
         # Lines marked TO FILL IN hold what no section says; the file is refused until they are filled in.\n\n\
         [bridge]\nname = {}\nwidth = \"TO FILL IN m\"\n\n[[span]]\nprofile = \"measured\"\npoints = [\n",
        1e3 * section.scatter,
        toml::Value::String(name)
    );
    for [x, y] in &section.curve {
        let _ = writeln!(page, "    [\"{x:.4} m\", \"{y:.4} m\"],");
    }
    page += "]\nthickness = \"TO FILL IN m\"\nvoussoirs = 40               # as many as there are; 30 to 100 describe a ring well\n\n";
    page += "[masonry]\ndensity = \"TO FILL IN kg/m^3\"\ncompressive_strength = \"TO FILL IN MPa\"   # or \"unlimited\"\n\n";
    page += "[joint]\nfriction_angle = \"TO FILL IN deg\"\ncohesion = \"0 kPa\"\n\n";
    page += "# A load to begin with; docs/input/README.md shows what else a file may say.\n\
             [[load]]\nkind = \"knife-edge\"\nforce = \"1 kN/m\"\nlength = \"0.30 m\"\nat = \"1/4 of span 1\"\n";
    page
}

/// Every point with its deviation, as a table.
pub fn deviations(section: &Section) -> String {
    let mut table = "x_m,y_m,deviation_mm,left_out\n".to_owned();
    for point in &section.points {
        let [x, y] = point.at;
        let _ = writeln!(table, "{x:.5},{y:.5},{:.2},{}", 1e3 * point.deviation, point.is_left_out);
    }
    table
}
