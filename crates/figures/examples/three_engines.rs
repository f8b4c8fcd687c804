//! Draws the lines of thrust of `docs/verification/three-engines.csv` in the unrolled ring:
//! `cargo run -p figures --example three_engines`, with the name of a PNG file for that as well.

use std::fmt::Write;
use std::path::Path;

/// Size of the drawing and of a panel in it [px].
const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 560.0;
const PANEL: [f64; 2] = [800.0, 190.0];
const LEFT: f64 = 70.0;

/// Depth of the ring [m] and its joints.
const DEPTH: f64 = 0.711;
const JOINTS: f64 = 62.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let table = std::fs::read_to_string(docs.join("verification/three-engines.csv"))?;
    let rows: Vec<Vec<f64>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(str::parse).collect::<Result<_, _>>())
        .collect::<Result<_, _>>()?;
    let mut page = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#ffffff\"/>\n"
    );
    let half =
        Panel { top: 40.0, title: "Half the limit load, joints alike: where the line of thrust lies in the ring" };
    half.frame(&mut page);
    let zone: Vec<[f64; 2]> =
        rows.iter().map(|r| [r[0], r[1]]).chain(rows.iter().rev().map(|r| [r[0], r[2]])).collect();
    let _ = writeln!(page, "<polygon points=\"{}\" fill=\"#e4e0d6\"/>", half.spots(zone));
    half.line(&mut page, &rows, 3, "#1f5fa8", "5");
    half.line(&mut page, &rows, 4, "#d1491a", "1.6");
    half.key(
        &mut page,
        &[("#e4e0d6", "zone of limit analysis"), ("#1f5fa8", "discrete elements"), ("#d1491a", "finite elements")],
    );
    let near =
        Panel { top: 310.0, title: "Near collapse: rigid blocks, and stiff joints one percent below their load" };
    near.frame(&mut page);
    near.line(&mut page, &rows, 5, "#2c6e49", "5");
    near.line(&mut page, &rows, 6, "#d1491a", "1.6");
    for (joint, edge) in [(0.0, 0.0), (17.0, DEPTH), (40.0, 0.0), (62.0, DEPTH)] {
        let [x, y] = near.spot([joint, edge]);
        let _ = writeln!(
            page,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"6\" fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"1.5\"/>"
        );
    }
    near.key(
        &mut page,
        &[
            ("#2c6e49", "limit analysis, 231.46 kN/m"),
            ("#d1491a", "finite elements"),
            ("#222222", "hinges of rigid blocks"),
        ],
    );
    page.push_str("</svg>\n");
    std::fs::write(docs.join("images/three-engines.svg"), &page)?;
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, figures::png(&page, 1200)?)?;
    }
    Ok(())
}

/// A ring unrolled: joints along, depth up.
struct Panel {
    top: f64,
    title: &'static str,
}

impl Panel {
    fn spot(&self, [joint, height]: [f64; 2]) -> [f64; 2] {
        [LEFT + PANEL[0] * joint / JOINTS, self.top + PANEL[1] * (1.0 - height / DEPTH)]
    }

    fn spots(&self, points: impl IntoIterator<Item = [f64; 2]>) -> String {
        let mut words = String::new();
        for point in points {
            let [x, y] = self.spot(point);
            let _ = write!(words, "{x:.1},{y:.1} ");
        }
        words
    }

    fn frame(&self, page: &mut String) {
        let [w, h] = PANEL;
        let _ = writeln!(
            page,
            "<rect x=\"{LEFT}\" y=\"{}\" width=\"{w}\" height=\"{h}\" fill=\"none\" stroke=\"#555555\"/>",
            self.top
        );
        let _ =
            writeln!(page, "<text x=\"{LEFT}\" y=\"{}\" font-weight=\"bold\">{}</text>", self.top - 12.0, self.title);
        for (word, height) in [("extrados", DEPTH), ("intrados", 0.0)] {
            let [x, y] = self.spot([0.0, height]);
            let _ = writeln!(page, "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{word}</text>", x - 8.0, y + 4.0);
        }
        for joint in [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 62.0] {
            let [x, y] = self.spot([joint, 0.0]);
            let name = if joint == 10.0 { "joint 10" } else { "" };
            let word = if name.is_empty() { joint.to_string() } else { name.to_string() };
            let _ = writeln!(page, "<text x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{word}</text>", y + 16.0);
        }
    }

    fn line(&self, page: &mut String, rows: &[Vec<f64>], column: usize, colour: &str, width: &str) {
        let points = self.spots(rows.iter().map(|row| [row[0], row[column]]));
        let _ = writeln!(
            page,
            "<polyline points=\"{points}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>"
        );
    }

    fn key(&self, page: &mut String, entries: &[(&str, &str)]) {
        let y = self.top + PANEL[1] + 36.0;
        for (k, (colour, word)) in entries.iter().enumerate() {
            let x = LEFT + 260.0 * k as f64;
            let _ = writeln!(page, "<rect x=\"{x}\" y=\"{}\" width=\"24\" height=\"8\" fill=\"{colour}\"/>", y - 8.0);
            let _ = writeln!(page, "<text x=\"{}\" y=\"{y}\">{word}</text>", x + 32.0);
        }
    }
}
