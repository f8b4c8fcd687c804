//! A sheet of paper 160 mm wide: the SVG writer of every figure. One unit is 0.2 mm, y runs down.
//!
//! Texts are measured with the embedded font when they are set, so that a label can look for a place where it
//! covers no other text.

pub(crate) mod font;
mod hatch;
mod many;
pub(crate) mod place;

use findings::visible::is_hidden;
use std::fmt::Write as _;

/// Width of every sheet [0.2 mm].
pub(crate) const WIDTH: f64 = 800.0;
/// Blank margin on all sides.
pub(crate) const MARGIN: f64 = 16.0;
/// Font size of titles (8.8 pt on paper).
pub(crate) const TITLE: f64 = 15.5;
/// Font size of labels (7.4 pt on paper).
pub(crate) const LABEL: f64 = 13.0;
/// Font size of small print (6.8 pt on paper).
pub(crate) const SMALL: f64 = 12.0;

/// Line widths, thin to thick (0.1, 0.15, 0.25 and 0.45 mm on paper).
pub(crate) const HAIR: f64 = 0.5;
/// Outlines.
pub(crate) const THIN: f64 = 0.75;
/// Curves and axes.
pub(crate) const MEDIUM: f64 = 1.25;
/// What a figure is about.
pub(crate) const THICK: f64 = 2.25;

/// A point on the sheet.
pub(crate) type Spot = [f64; 2];

/// A rectangle on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Lower edge.
    pub bottom: f64,
}

impl Area {
    /// Area shared with another rectangle.
    pub(crate) fn overlap(&self, other: &Area) -> f64 {
        let w = self.right.min(other.right) - self.left.max(other.left);
        let h = self.bottom.min(other.bottom) - self.top.max(other.top);
        if w > 0.0 && h > 0.0 { w * h } else { 0.0 }
    }
    /// The smallest rectangle around points.
    pub(crate) fn around(points: &[Spot]) -> Option<Area> {
        points.iter().map(|p| Area::about(*p, 0.0)).reduce(|a, p| Area {
            left: a.left.min(p.left),
            right: a.right.max(p.right),
            top: a.top.min(p.top),
            bottom: a.bottom.max(p.bottom),
        })
    }
    /// A square around a spot, so far to each side.
    pub(crate) fn about(at: Spot, by: f64) -> Area {
        Area { left: at[0] - by, top: at[1] - by, right: at[0] + by, bottom: at[1] + by }
    }
    /// A rectangle larger by `by` above and below.
    pub(crate) fn taller(&self, by: f64) -> Area {
        Area { top: self.top - by, bottom: self.bottom + by, ..*self }
    }
    /// A rectangle larger by `by` on all sides.
    pub(crate) fn grown(&self, by: f64) -> Area {
        Area { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }
}

/// How a shape is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pen<'a> {
    /// Fill colour, or "none".
    pub fill: &'a str,
    /// Line colour, or "none".
    pub stroke: &'a str,
    /// Line width.
    pub width: f64,
    /// Dashes, or "".
    pub dashes: &'a str,
    /// Class, for those who style or count.
    pub class: &'a str,
}

impl<'a> Pen<'a> {
    pub(crate) const fn line(stroke: &'a str, width: f64) -> Pen<'a> {
        Pen { fill: "none", stroke, width, dashes: "", class: "" }
    }
    /// A filled shape with an outline.
    pub(crate) const fn shape(fill: &'a str, stroke: &'a str, width: f64) -> Pen<'a> {
        Pen { fill, stroke, width, dashes: "", class: "" }
    }
    pub(crate) const fn dashed(mut self, dashes: &'a str) -> Pen<'a> {
        self.dashes = dashes;
        self
    }
    pub(crate) const fn class(mut self, class: &'a str) -> Pen<'a> {
        self.class = class;
        self
    }
    fn write(&self, out: &mut String) {
        if !self.class.is_empty() {
            let _ = write!(out, " class=\"{}\"", self.class);
        }
        let _ = write!(out, " fill=\"{}\" stroke=\"{}\"", self.fill, self.stroke);
        if self.stroke != "none" {
            let _ = write!(out, " stroke-width=\"{}\"", number(self.width));
        }
        if !self.dashes.is_empty() {
            let _ = write!(out, " stroke-dasharray=\"{}\"", self.dashes);
        }
    }
}

/// Which part of a text its point is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Anchor {
    /// The point is where the text begins.
    #[default]
    Start,
    /// The point is in its middle.
    Middle,
    /// The point is where it ends.
    End,
}

/// A figure while it is drawn.
#[derive(Debug)]
pub(crate) struct Sheet {
    name: String,
    body: String,
    texts: Vec<Area>,
    obstacles: Vec<(Area, f64)>,
}

impl Sheet {
    /// An empty sheet. Its name, of letters, digits and hyphens, stands before every id, so that several figures
    /// can stand in one document.
    pub(crate) fn new(name: &str) -> Sheet {
        Sheet { name: name.into(), body: String::new(), texts: Vec::new(), obstacles: Vec::new() }
    }

    /// A sheet with a title over a lighter second line, and the y below them.
    pub(crate) fn titled(name: &str, title: &str, second: &str) -> (Sheet, f64) {
        let mut sheet = Sheet::new(name);
        let limit = WIDTH - 2.0 * MARGIN;
        let bold = Style { size: TITLE, ..Style::bold() };
        let mut y = sheet.paragraph(MARGIN, MARGIN - 2.0, limit, title, bold);
        if !second.is_empty() {
            y = sheet.paragraph(MARGIN, y, limit, second, Style { colour: GREY_TEXT, ..Style::default() });
        }
        (sheet, y + 8.0)
    }

    /// An open or closed chain of points. Shapes with a coordinate that is not finite are left out.
    fn chain(&mut self, tag: &str, points: &[Spot], pen: Pen) {
        if points.len() < 2 || points.iter().flatten().any(|c| !c.is_finite()) {
            return;
        }
        let _ = write!(self.body, "<{tag} points=\"");
        for (k, p) in points.iter().enumerate() {
            let gap = if k == 0 { "" } else { " " };
            let _ = write!(self.body, "{gap}{},{}", number(p[0]), number(p[1]));
        }
        self.body.push('"');
        pen.write(&mut self.body);
        self.body.push_str(" stroke-linejoin=\"round\"/>\n");
    }
    /// A closed polygon.
    pub(crate) fn polygon(&mut self, points: &[Spot], pen: Pen) {
        self.chain("polygon", points, pen);
    }
    /// An open polyline.
    pub(crate) fn polyline(&mut self, points: &[Spot], pen: Pen) {
        self.chain("polyline", points, pen);
    }
    /// A straight line.
    pub(crate) fn line(&mut self, from: Spot, to: Spot, pen: Pen) {
        self.polyline(&[from, to], pen);
    }
    pub(crate) fn circle(&mut self, at: Spot, radius: f64, pen: Pen) {
        if at.iter().any(|c| !c.is_finite()) {
            return;
        }
        let _ = write!(self.body, "<circle cx=\"{}\" cy=\"{}\" r=\"{}\"", number(at[0]), number(at[1]), number(radius));
        pen.write(&mut self.body);
        self.body.push_str("/>\n");
    }
    pub(crate) fn rectangle(&mut self, area: Area, pen: Pen) {
        let Area { left, top, right, bottom } = area;
        self.polygon(&[[left, top], [right, top], [right, bottom], [left, bottom]], pen);
    }
    /// An arrow from tail to tip, with a filled head no longer than 0.6 of the arrow.
    pub(crate) fn arrow(&mut self, tail: Spot, tip: Spot, pen: Pen) {
        let along = [tip[0] - tail[0], tip[1] - tail[1]];
        let length = along[0].hypot(along[1]);
        if !length.is_finite() || length < 0.5 {
            return;
        }
        let unit = [along[0] / length, along[1] / length];
        let head = (2.0 + 3.6 * pen.width).min(0.6 * length);
        let neck = [tip[0] - head * unit[0], tip[1] - head * unit[1]];
        let half = 0.36 * head;
        self.line(tail, neck, pen);
        let wing = |side: f64| [neck[0] - side * half * unit[1], neck[1] + side * half * unit[0]];
        self.polygon(&[tip, wing(1.0), wing(-1.0)], Pen::shape(pen.stroke, "none", 0.0));
    }

    /// Everything until [`Sheet::close`] is drawn in one group, with a class.
    pub(crate) fn open(&mut self, class: &str) {
        let _ = writeln!(self.body, "<g class=\"{class}\">");
    }
    /// Like [`Sheet::open`], and drawn only inside an area.
    pub(crate) fn open_clipped(&mut self, class: &str, id: &str, a: Area) {
        let (x, y, w, h) = (number(a.left), number(a.top), number(a.right - a.left), number(a.bottom - a.top));
        let _ = writeln!(
            self.body,
            "<clipPath id=\"{0}-{id}\"><rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"/></clipPath>\n<g class=\"{class}\" clip-path=\"url(#{0}-{id})\">",
            self.name
        );
    }
    /// Ends a group.
    pub(crate) fn close(&mut self) {
        self.body.push_str("</g>\n");
    }

    /// A text on one line, with its baseline at `at`; white behind its letters where it lies on a drawing.
    pub(crate) fn text(&mut self, at: Spot, text: &str, style: Style) {
        let area = text_area(at, text, style);
        self.write_text(at, text, style, 0.0);
        self.texts.push(area);
    }
    /// Lines of text, the middle of their letters at the height of `at`.
    pub(crate) fn lines(&mut self, at: Spot, lines: &[impl AsRef<str>], pitch: f64, style: Style) {
        let first = at[1] + 0.5 * font::CAPITAL * style.size - 0.5 * pitch * lines.len().saturating_sub(1) as f64;
        for (k, line) in lines.iter().enumerate() {
            self.text([at[0], first + pitch * k as f64], line.as_ref(), style);
        }
    }
    /// A text that reads upwards, centred on `at`.
    pub(crate) fn text_upwards(&mut self, at: Spot, text: &str, style: Style) {
        let half = style.width(text) / 2.0;
        self.write_text(at, text, Style { anchor: Anchor::Middle, ..style }, -90.0);
        self.texts.push(Area {
            left: at[0] - font::CAPITAL * style.size,
            right: at[0] + font::DESCENT * style.size,
            top: at[1] - half,
            bottom: at[1] + half,
        });
    }
    fn write_text(&mut self, at: Spot, text: &str, style: Style, turn: f64) {
        if text.trim().is_empty() || at.iter().any(|c| !c.is_finite()) {
            return;
        }
        let (x, y) = (number(at[0]), number(at[1]));
        let _ = write!(self.body, "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{}\"", style.size, style.colour);
        match style.anchor {
            Anchor::Start => {}
            Anchor::Middle => self.body.push_str(" text-anchor=\"middle\""),
            Anchor::End => self.body.push_str(" text-anchor=\"end\""),
        }
        if style.bold {
            self.body.push_str(" font-weight=\"bold\"");
        }
        if style.halo {
            self.body
                .push_str(" stroke=\"white\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke fill\"");
        }
        if turn != 0.0 {
            let _ = write!(self.body, " transform=\"rotate({turn} {x} {y})\"");
        }
        let _ = writeln!(self.body, ">{}</text>", escape(text));
    }
    /// Lines of a paragraph, `limit` wide; returns the y below them.
    pub(crate) fn paragraph(&mut self, left: f64, top: f64, limit: f64, text: &str, style: Style) -> f64 {
        let mut y = top;
        for line in style.wrap(text, limit) {
            y += 1.3 * style.size;
            self.text([left, y - 0.3 * style.size], &line, style);
        }
        y
    }
    /// Small print at the foot of the sheet; returns the y below it.
    pub(crate) fn caption(&mut self, top: f64, text: &str) -> f64 {
        self.paragraph(MARGIN, top, WIDTH - 2.0 * MARGIN, text, Style::grey())
    }

    /// Something that a label had better not cover.
    pub(crate) fn avoid(&mut self, area: Area) {
        self.obstacles.push((area, 1.0));
    }
    /// A chain of points that labels had better not cover.
    pub(crate) fn avoid_line(&mut self, points: &[Spot]) {
        for pair in points.windows(2) {
            let way = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
            let parts = ((way[0].hypot(way[1]) / 10.0).ceil() as usize).clamp(1, 200);
            for k in 0..=parts {
                let t = k as f64 / parts as f64;
                let at = [pair[0][0] + t * way[0], pair[0][1] + t * way[1]];
                self.avoid(Area::about(at, 4.0));
            }
        }
    }
    /// Something that a label may cover where there is no better place.
    pub(crate) fn avoid_lightly(&mut self, area: Area) {
        self.obstacles.push((area, 0.3));
    }
    /// Where every text lies.
    #[cfg(test)]
    pub(crate) fn texts(&self) -> &[Area] {
        &self.texts
    }

    /// The figure with small print at its foot.
    pub(crate) fn end(mut self, top: f64, words: &str) -> String {
        let bottom = self.caption(top, words);
        self.finish(bottom)
    }
    /// The figure, cut off below `bottom`.
    pub(crate) fn finish(self, bottom: f64) -> String {
        let height = (bottom + MARGIN).ceil();
        let (mm_wide, mm_high) = (number(WIDTH * 0.2), number(height * 0.2));
        let (w, h) = (number(WIDTH), number(height));
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{mm_wide}mm\" height=\"{mm_high}mm\" viewBox=\"0 0 {w} {h}\" font-family=\"{}\">\n<rect width=\"{w}\" height=\"{h}\" fill=\"white\"/>\n{}</svg>\n",
            font::FAMILY,
            self.body
        )
    }
}

/// Colour of captions.
pub(crate) const GREY_TEXT: &str = "#404040";

/// How a text is set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Style {
    /// Font size.
    pub size: f64,
    /// Whether it is a name or a title.
    pub bold: bool,
    pub colour: &'static str,
    /// Which part of the text its point is.
    pub anchor: Anchor,
    /// Whether the letters have a white rim.
    pub halo: bool,
}

impl Default for Style {
    fn default() -> Style {
        Style { size: LABEL, bold: false, colour: "#111111", anchor: Anchor::Start, halo: false }
    }
}

impl Style {
    /// Small print.
    pub(crate) fn small() -> Style {
        Style { size: SMALL, ..Style::default() }
    }
    /// Small print that stands back.
    pub(crate) fn grey() -> Style {
        Style { colour: GREY_TEXT, ..Style::small() }
    }
    /// A name.
    pub(crate) fn bold() -> Style {
        Style { bold: true, ..Style::default() }
    }
    /// A label set in a drawing.
    pub(crate) fn on_drawing() -> Style {
        Style { halo: true, ..Style::small() }
    }
    pub(crate) fn anchored(mut self, anchor: Anchor) -> Style {
        self.anchor = anchor;
        self
    }
    /// As much of a text as fits into a limit as it is written; what is cut ends in an ellipsis.
    pub(crate) fn shortened(&self, text: &str, limit: f64, written: impl Fn(&str) -> String) -> Option<String> {
        let cut = |length: usize| format!("{}…", text.chars().take(length).collect::<String>().trim_end());
        let shorter = (1..text.chars().count()).rev().map(|length| written(&cut(length)));
        std::iter::once(written(text)).chain(shorter).find(|line| self.width(line) <= limit)
    }
    /// The first line of a text no wider than a limit.
    pub(crate) fn first_line(&self, text: &str, limit: f64) -> String {
        self.wrap(text, limit).into_iter().next().unwrap_or_default()
    }
}

/// The rectangle that a text covers.
pub(crate) fn text_area(at: Spot, text: &str, style: Style) -> Area {
    let w = style.width(text);
    let left = match style.anchor {
        Anchor::Start => at[0],
        Anchor::Middle => at[0] - w / 2.0,
        Anchor::End => at[0] - w,
    };
    Area { left, right: left + w, top: at[1] - font::CAPITAL * style.size, bottom: at[1] + font::DESCENT * style.size }
}

/// A coordinate with at most two decimals: a five-hundredth of a millimetre.
pub(crate) fn number(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

/// Text as XML may contain it.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if is_hidden(c) || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_never_minus_zero() {
        assert_eq!([number(-0.001), number(2.50), number(100.0), number(-3.456)], ["0", "2.5", "100", "-3.46"]);
    }

    #[test]
    fn what_is_not_finite_is_left_out() {
        let mut sheet = Sheet::new("try");
        sheet.line([0.0, f64::NAN], [1.0, 1.0], Pen::line("black", 1.0));
        sheet.circle([f64::INFINITY, 0.0], 1.0, Pen::line("black", 1.0));
        sheet.line([0.0, 2.0], [1.0, 1.0], Pen::line("black", 1.0));
        let svg = sheet.finish(10.0);
        assert_eq!(svg.matches("<polyline").count(), 1);
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn any_title_gives_well_formed_xml() {
        let (sheet, y) = Sheet::titled("try", "a<b> & \"c\" \u{7}\u{fffe} ∑", "");
        let svg = sheet.finish(y);
        let tree = roxmltree::Document::parse(&svg).unwrap();
        let text = tree.descendants().find(|n| n.has_tag_name("text")).and_then(|n| n.text()).unwrap();
        assert!(text.starts_with("a<b> & \"c\""));
    }
}
