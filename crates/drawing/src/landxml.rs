//! Road and rail profiles of LandXML files (1.0 to 2.0): stations and levels in metres, vertical curves as chords.

use crate::Point;
use crate::units::LANDXML;
use roxmltree::{Document, Node};
use thiserror::Error;

/// A profile: the level of a road or rail along its alignment.
#[derive(Debug, Clone, PartialEq)]
pub struct RoadLine {
    /// Name of its alignment; empty where it has none.
    pub alignment: String,
    /// Its own name; empty where it has none.
    pub name: String,
    /// Station and level, from the lowest station on [m].
    pub points: Vec<Point>,
    /// Vertical curves that became chords.
    pub curves: usize,
}

impl RoadLine {
    /// Alignment and profile in a word each, for messages.
    pub fn title(&self) -> String {
        match (self.alignment.as_str(), self.name.as_str()) {
            ("", name) => name.to_owned(),
            (alignment, "") => alignment.to_owned(),
            (alignment, name) => format!("{alignment} / {name}"),
        }
    }

    /// Level at a station [m]; none beyond its ends.
    pub fn level(&self, station: f64) -> Option<f64> {
        let (first, last) = (self.points.first()?, self.points.last()?);
        if !(first[0]..=last[0]).contains(&station) {
            return None;
        }
        let k = self.points.partition_point(|point| point[0] < station).clamp(1, self.points.len() - 1);
        let ([x0, y0], [x1, y1]) = (self.points[k - 1], self.points[k]);
        Some(y0 + (y1 - y0) * (station - x0) / (x1 - x0))
    }
}

/// Why a file has no profile that can be used.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LandXmlError {
    /// It is no XML.
    #[error("it is no XML that can be read: {0}")]
    NoXml(String),
    /// It is XML of something else.
    #[error("its outermost element is <{0}> and not <LandXML>")]
    Other(String),
    /// The unit is missing or unknown.
    #[error("{0}")]
    Unit(String),
    /// Something in a profile cannot be used.
    #[error("line {line}: {what}")]
    Element {
        /// Its line, from 1.
        line: u32,
        /// What is wrong.
        what: String,
    },
    /// There is no profile.
    #[error("it holds no <ProfAlign> and no <ProfSurf>: no alignment in it has levels")]
    NoProfile,
}

/// Most chords of a vertical curve.
const MOST_CHORDS: f64 = 500.0;
/// By how much curves may overlap: coordinates with a few digits [m].
const ROUNDED: f64 = 2e-3;

/// Every profile of a file; no chord lies further from its curve than `tolerance` [m].
///
/// # Errors
/// A file that is no LandXML, has no unit of length, no profile, or one that cannot be understood.
pub fn road_lines(text: &str, tolerance: f64) -> Result<Vec<RoadLine>, LandXmlError> {
    let document = Document::parse(text).map_err(|error| LandXmlError::NoXml(error.to_string()))?;
    let root = document.root_element();
    if root.tag_name().name() != "LandXML" {
        return Err(LandXmlError::Other(root.tag_name().name().to_owned()));
    }
    let metres = unit(root)?;
    let profiles = root.descendants().filter(|node| matches!(node.tag_name().name(), "ProfAlign" | "ProfSurf"));
    let lines: Vec<RoadLine> =
        profiles.map(|node| Reader { document: &document, metres, tolerance }.line(node)).collect::<Result<_, _>>()?;
    if lines.is_empty() { Err(LandXmlError::NoProfile) } else { Ok(lines) }
}

/// Metres in the unit of length.
fn unit(root: Node<'_, '_>) -> Result<f64, LandXmlError> {
    let none = || {
        LandXmlError::Unit("it does not say its unit: <Units> with <Metric linearUnit=\"meter\"> or <Imperial linearUnit=\"foot\"> is missing".to_owned())
    };
    let units = root.children().find(|node| node.tag_name().name() == "Units").ok_or_else(none)?;
    let system = units.children().find(Node::is_element).ok_or_else(none)?;
    let name = system.attribute("linearUnit").ok_or_else(none)?;
    let known = LANDXML.iter().find(|(known, _)| known.eq_ignore_ascii_case(name));
    known.map(|one| one.1).ok_or_else(|| {
        let names: Vec<&str> = LANDXML.iter().map(|one| one.0).collect();
        LandXmlError::Unit(format!("its linearUnit \"{name}\" is none of {}", names.join(", ")))
    })
}

/// How far a vertical curve reaches to both sides of its intersection of grades [m], or with which radius.
#[derive(Debug, Clone, Copy)]
enum Curve {
    None,
    Parabola(f64, f64),
    Circle(f64),
}

struct Reader<'a, 'i> {
    document: &'a Document<'i>,
    metres: f64,
    tolerance: f64,
}

impl<'a> Reader<'a, '_> {
    fn wrong(&self, node: Node<'_, '_>, what: impl Into<String>) -> LandXmlError {
        LandXmlError::Element { line: self.document.text_pos_at(node.range().start).row, what: what.into() }
    }

    fn line(&self, node: Node<'a, '_>) -> Result<RoadLine, LandXmlError> {
        let alignment = node.ancestors().find(|above| above.tag_name().name() == "Alignment");
        let of = |node: Option<Node<'_, '_>>| {
            node.and_then(|node| node.attribute("name")).unwrap_or_default().trim().to_owned()
        };
        let (points, curves) = match node.tag_name().name() {
            "ProfSurf" => (self.surface(node)?, 0),
            _ => self.grades(node)?,
        };
        if points.len() < 2 || points.windows(2).any(|pair| !(pair[0][0] < pair[1][0])) {
            let what = "the profile needs two points or more whose stations grow from one to the next";
            return Err(self.wrong(node, what));
        }
        Ok(RoadLine { alignment: of(alignment), name: of(Some(node)), points, curves })
    }

    /// Numbers of an element's text.
    fn numbers(&self, node: Node<'_, '_>) -> Result<Vec<f64>, LandXmlError> {
        let text = node.text().unwrap_or_default();
        let number = |word: &str| word.parse::<f64>().ok().filter(|number| number.is_finite());
        text.split_whitespace()
            .map(|word| number(word).ok_or_else(|| self.wrong(node, format!("\"{word}\" is no number"))))
            .collect()
    }

    /// Points of a surface along the alignment.
    fn surface(&self, node: Node<'_, '_>) -> Result<Vec<Point>, LandXmlError> {
        let mut points: Vec<Point> = Vec::new();
        for list in node.children().filter(|child| child.tag_name().name() == "PntList2D") {
            let pairs = self.numbers(list)?;
            points.extend(pairs.chunks_exact(2).map(|pair| [pair[0] * self.metres, pair[1] * self.metres]));
        }
        points.dedup_by(|later, earlier| later[0] == earlier[0]);
        Ok(points)
    }

    /// The points of a designed profile, and how many curves it has.
    fn grades(&self, node: Node<'a, '_>) -> Result<(Vec<Point>, usize), LandXmlError> {
        let mut corners: Vec<(Node<'_, '_>, Point, Curve)> = Vec::new();
        for child in node.children().filter(Node::is_element) {
            let length = |name: &str| -> Result<f64, LandXmlError> {
                let text = child.attribute(name).unwrap_or_default();
                let value = text.trim().parse::<f64>().ok().filter(|value| value.is_finite() && *value >= 0.0);
                let name_of = child.tag_name().name();
                let none = || self.wrong(child, format!("<{name_of}> needs {name}, a length; it is \"{text}\""));
                value.map(|value| value * self.metres).ok_or_else(none)
            };
            let curve = match child.tag_name().name() {
                "PVI" => Curve::None,
                "ParaCurve" => length("length").map(|length| Curve::Parabola(0.5 * length, 0.5 * length))?,
                "UnsymParaCurve" => Curve::Parabola(length("lengthIn")?, length("lengthOut")?),
                "CircCurve" => Curve::Circle(length("radius")?),
                _ => continue,
            };
            let &[station, level] = &self.numbers(child)?[..] else {
                return Err(self.wrong(child, "an intersection of grades has two numbers: station and level"));
            };
            corners.push((child, [station * self.metres, level * self.metres], curve));
        }
        self.drawn(&corners)
    }

    /// Straight grades, and chords where curves lie between them.
    fn drawn(&self, corners: &[(Node<'_, '_>, Point, Curve)]) -> Result<(Vec<Point>, usize), LandXmlError> {
        let grade = |a: Point, b: Point| (b[1] - a[1]) / (b[0] - a[0]);
        let mut points: Vec<Point> = Vec::new();
        let mut curves = 0;
        for (k, &(node, at, curve)) in corners.iter().enumerate() {
            let between = k.checked_sub(1).and_then(|before| corners.get(before)).zip(corners.get(k + 1));
            let curve = between.map(|(before, after)| (curve, grade(before.1, at), grade(at, after.1)));
            let piece = match curve {
                Some((Curve::Parabola(before, after), g1, g2)) if before > 0.0 && after > 0.0 => {
                    self.parabola(at, [before, after], [g1, g2])
                }
                Some((Curve::Circle(radius), g1, g2)) if radius > 0.0 && g1 != g2 => self.circle(at, radius, [g1, g2]),
                _ => vec![at],
            };
            curves += usize::from(piece.len() > 1);
            let starts = piece.first().map_or(at[0], |point| point[0]);
            if let Some(last) = points.last().filter(|last| starts < last[0] - ROUNDED) {
                let what = format!(
                    "the curve begins at station {starts:.3} m, before {:.3} m, where the one before it ends",
                    last[0]
                );
                return Err(self.wrong(node, what));
            }
            // Where one curve begins as the other ends.
            let from = usize::from(points.last().is_some_and(|last| starts <= last[0] + 1e-6)).min(piece.len() - 1);
            let from = if piece.len() == 1 { 0 } else { from };
            points.extend(&piece[from..]);
        }
        Ok((points, curves))
    }

    /// So many chords that none lies further from a curve of this second derivative [1/m] over a length [m].
    fn chords(&self, bend: f64, length: f64) -> usize {
        let step = (8.0 * self.tolerance.max(1e-6) / bend.abs().max(1e-12)).sqrt();
        (length / step).ceil().clamp(1.0, MOST_CHORDS) as usize
    }

    /// Two parabolas that meet above or below the intersection of grades with one tangent: one where both lengths are equal.
    fn parabola(&self, at: Point, [before, after]: [f64; 2], [g1, g2]: [f64; 2]) -> Vec<Point> {
        // Height of the curve over the intersection of grades.
        let middle = 0.5 * (g2 - g1) * before * after / (before + after);
        let mut points = Vec::new();
        let n = self.chords(2.0 * middle / (before * before), before);
        points.extend((0..n).map(|k| {
            let x = before * k as f64 / n as f64;
            [at[0] - before + x, at[1] - g1 * (before - x) + middle * (x / before).powi(2)]
        }));
        let n = self.chords(2.0 * middle / (after * after), after);
        points.extend((0..=n).map(|k| {
            let x = after * (1.0 - k as f64 / n as f64);
            [at[0] + after - x, at[1] + g2 * (after - x) + middle * (x / after).powi(2)]
        }));
        points
    }

    /// The circle that touches both grades.
    fn circle(&self, at: Point, radius: f64, [g1, g2]: [f64; 2]) -> Vec<Point> {
        let (a, b) = (g1.atan(), g2.atan());
        let tangent = radius * (0.5 * (b - a).abs()).tan();
        let side = (b - a).signum();
        let start = [at[0] - tangent * a.cos(), at[1] - tangent * a.sin()];
        let centre = [start[0] - side * radius * a.sin(), start[1] + side * radius * a.cos()];
        let n = self.chords(1.0 / radius, radius * (b - a).abs());
        let point = |k: usize| {
            let angle = a + (b - a) * k as f64 / n as f64;
            [centre[0] + side * radius * angle.sin(), centre[1] - side * radius * angle.cos()]
        };
        (0..=n).map(point).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(units: &str, profile: &str) -> String {
        format!(
            "<?xml version=\"1.0\"?>\n<LandXML xmlns=\"http://www.landxml.org/schema/LandXML-1.2\" version=\"1.2\">\n<Units>{units}</Units>\n\
             <Alignments><Alignment name=\"A66\" length=\"400\" staStart=\"0\"><Profile>\n{profile}\n</Profile></Alignment></Alignments></LandXML>"
        )
    }

    const METRIC: &str = "<Metric linearUnit=\"meter\" areaUnit=\"squareMeter\"/>";

    /// A crest of 100 m between +2 % and -3 %: L/8 times the change of grade below the intersection, tangents at both ends.
    #[test]
    fn a_parabola_lies_by_its_closed_form_under_the_intersection_of_grades() {
        let text = file(
            METRIC,
            "<ProfAlign name=\"road\"><PVI>0 100</PVI><ParaCurve length=\"100\">200 104</ParaCurve><PVI>400 98</PVI></ProfAlign>",
        );
        let [line] = &road_lines(&text, 1e-3).unwrap()[..] else { panic!() };
        assert_eq!((line.title().as_str(), line.curves), ("A66 / road", 1));
        for (station, level) in
            [(0.0, 100.0), (150.0, 103.0), (200.0, 104.0 - 0.05 * 100.0 / 8.0), (250.0, 102.5), (400.0, 98.0)]
        {
            assert!(
                (line.level(station).unwrap() - level).abs() < 1e-9,
                "{station}: {:?} {level}",
                line.level(station)
            );
        }
        // No chord further than a millimetre from 103 + 0.02 x - 0.00025 x^2.
        for k in 0..=1000 {
            let x = 0.1 * f64::from(k);
            let exact = 103.0 + 0.02 * x - 0.00025 * x * x;
            assert!((line.level(150.0 + x).unwrap() - exact).abs() < 1.001e-3, "{x}");
        }
        assert_eq!(line.level(401.0), None);
    }

    #[test]
    fn unequal_parabolas_and_circles_touch_their_grades() {
        let text = file(
            METRIC,
            "<ProfAlign name=\"r\"><PVI>0 10</PVI><UnsymParaCurve lengthIn=\"40\" lengthOut=\"80\">100 8</UnsymParaCurve>\
             <CircCurve length=\"60\" radius=\"2000\">300 16</CircCurve><PVI>500 18</PVI></ProfAlign>",
        );
        let [line] = &road_lines(&text, 1e-4).unwrap()[..] else { panic!() };
        // Grades of -2 %, 4 %, 1 %: 0.06 * 40 * 80 / (2 * 120) over the first intersection.
        assert!((line.level(100.0).unwrap() - 8.8).abs() < 1e-9);
        // A circle lies R (1 / cos(d / 2) - 1) / cos(mean) under the second, upright, to third order.
        let (a, b) = (0.04_f64.atan(), 0.01_f64.atan());
        let tangent = 2000.0 * (0.5 * (a - b)).tan();
        assert!((line.level(300.0 - tangent * a.cos()).unwrap() - (16.0 - tangent * a.sin())).abs() < 1e-9);
        assert!((line.level(300.0).unwrap() - (16.0 - 2000.0 * (1.0 / (0.5 * (a - b)).cos() - 1.0))).abs() < 1e-3);
        // No kink from one chord to the next.
        let slopes: Vec<f64> = line.points.windows(2).map(|p| (p[1][1] - p[0][1]) / (p[1][0] - p[0][0])).collect();
        assert!(slopes.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 3e-3), "{slopes:?}");
    }

    #[test]
    fn feet_and_surfaces_are_read() {
        let foot = "<Imperial linearUnit=\"USSurveyFoot\"/>";
        let text = file(foot, "<ProfSurf name=\"ground\"><PntList2D>0 10 3937 20</PntList2D></ProfSurf>");
        let [line] = &road_lines(&text, 1e-3).unwrap()[..] else { panic!() };
        assert!((line.points[1][0] - 1200.0).abs() < 1e-9, "{:?}", line.points);
    }

    #[test]
    fn what_cannot_be_used_is_told_with_its_line() {
        let metric = |profile: &str| road_lines(&file(METRIC, profile), 1e-3).unwrap_err().to_string();
        for (said, words) in [
            (metric("<ProfAlign><PVI>0 1</PVI></ProfAlign>"), "two points"),
            (
                metric("<ProfAlign>\n<PVI>0 1</PVI>\n<ParaCurve>5 2</ParaCurve><PVI>9 1</PVI></ProfAlign>"),
                "line 7: <ParaCurve> needs length",
            ),
            (metric("<ProfAlign><PVI>0 one</PVI></ProfAlign>"), "\"one\" is no number"),
            (
                metric(
                    "<ProfAlign><PVI>0 0</PVI><ParaCurve length=\"90\">50 1</ParaCurve><ParaCurve length=\"90\">100 0</ParaCurve><PVI>200 5</PVI></ProfAlign>",
                ),
                "where the one before it ends",
            ),
            (metric("<CoordGeom/>"), "no <ProfAlign>"),
            (road_lines(&file("", ""), 1e-3).unwrap_err().to_string(), "does not say its unit"),
            (
                road_lines(&file("<Metric linearUnit=\"rod\"/>", ""), 1e-3).unwrap_err().to_string(),
                "\"rod\" is none of",
            ),
            (road_lines("<kml/>", 1e-3).unwrap_err().to_string(), "<kml>"),
            (road_lines("span;6", 1e-3).unwrap_err().to_string(), "no XML"),
        ] {
            assert!(said.contains(words), "{words} is not in {said}");
        }
    }
}
