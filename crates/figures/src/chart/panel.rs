//! A panel of a chart: its axes, and what stands in its plane.

use super::{Axes, Axis, Heading, Mark, NAME};
use crate::sheet::place::Room;
use crate::sheet::{Area, HAIR, MARGIN, Pen, Sheet, Spot, Style, WIDTH};

/// A place in the plane: a value along each axis.
pub(crate) type PanelPoint = [f64; 2];

/// The line of zero, darker than the grid.
pub(crate) const ZERO: Pen = Pen::line("#8a8a8a", HAIR + 0.2);

/// What draws itself over axes.
type Layer<'a> = Box<dyn Fn(&mut Sheet, &Axes) + 'a>;

/// Axes, and layers in the order of drawing.
pub(crate) struct Panel<'a> {
    /// What stands above it.
    pub heading: Heading,
    pub x: Axis<'a>,
    pub y: Axis<'a>,
    layers: Vec<Layer<'a>>,
}

impl<'a> Panel<'a> {
    /// An empty plane.
    pub(crate) fn new(x: Axis<'a>, y: Axis<'a>) -> Panel<'a> {
        Panel { heading: Default::default(), x, y, layers: Vec::new() }
    }
    /// Draws it within an area, with words around it as those of [`Axes::draw`].
    pub(crate) fn within(&self, sheet: &mut Sheet, area: Area, below: Option<f64>, widest: Option<f64>) {
        let axes = Axes { area, x: &self.x, y: &self.y };
        axes.draw(sheet, below, widest);
        self.layers.iter().for_each(|layer| layer(sheet, &axes));
    }
    /// Draws it across the sheet beside words of a width, those along x only where it is the lowest; returns the y below.
    pub(crate) fn whole(&self, sheet: &mut Sheet, [top, height]: [f64; 2], widest: f64, lowest: bool) -> f64 {
        let (top, bottom) = (top + 6.0, top + 6.0 + height);
        let area = Area { left: Axes::left(widest), right: WIDTH - MARGIN - 16.0, top, bottom };
        self.within(sheet, area, lowest.then_some(NAME), Some(widest));
        bottom + if lowest { 50.0 } else { 8.0 }
    }

    /// A layer of its own kind.
    pub(crate) fn add(&mut self, layer: impl Fn(&mut Sheet, &Axes) + 'a) {
        self.layers.push(Box::new(layer));
    }
    /// Begins a group of a class.
    pub(crate) fn open(&mut self, class: &'a str) {
        self.add(move |sheet, _| sheet.open(class));
    }
    /// Begins a group that is drawn only inside the frame.
    pub(crate) fn clip(&mut self, class: &'a str, id: impl Into<String>) {
        let id = id.into();
        self.add(move |sheet, axes| sheet.open_clipped(class, &id, axes.area));
    }
    /// Ends a group.
    pub(crate) fn close(&mut self) {
        self.add(|sheet, _| sheet.close());
    }
    /// A line through places.
    pub(crate) fn line(&mut self, places: impl Into<Vec<PanelPoint>>, pen: Pen<'a>) {
        let places = places.into();
        self.add(move |sheet, axes| sheet.polyline(&axes.spots(&places), pen));
    }
    /// A line of which labels keep clear.
    pub(crate) fn curve(&mut self, places: impl Into<Vec<PanelPoint>>, pen: Pen<'a>) {
        let places = places.into();
        self.add(move |sheet, axes| {
            let spots = axes.spots(&places);
            sheet.polyline(&spots, pen);
            sheet.avoid_line(&spots);
        });
    }
    /// A long record, no more of it than is seen.
    pub(crate) fn record(&mut self, x: &[f64], y: &[f64], pen: Pen<'a>) {
        let places: Vec<PanelPoint> = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
        self.add(move |sheet, axes| {
            for run in runs(&places) {
                let spots = thinned(&axes.spots(run));
                sheet.polyline(&spots, pen);
                sheet.avoid_line(&spots);
            }
        });
    }
    /// A line over the whole height.
    pub(crate) fn upright(&mut self, x: f64, pen: Pen<'a>) {
        let [low, high] = self.y.range;
        self.line([[x, high], [x, low]], pen);
    }
    /// A line over the whole width.
    pub(crate) fn level(&mut self, y: f64, pen: Pen<'a>) {
        self.line(self.x.range.map(|x| [x, y]), pen);
    }
    /// The area within places.
    pub(crate) fn area(&mut self, places: impl Into<Vec<PanelPoint>>, pen: Pen<'a>) {
        let places = places.into();
        self.add(move |sheet, axes| sheet.polygon(&axes.spots(&places), pen));
    }
    /// A rectangle between two corners.
    pub(crate) fn bar(&mut self, low: PanelPoint, high: PanelPoint, pen: Pen<'a>) {
        self.add(move |sheet, axes| {
            let ([left, bottom], [right, top]) = (axes.spot(low), axes.spot(high));
            sheet.rectangle(Area { left, top, right, bottom }, pen);
        });
    }
    /// Small circles.
    pub(crate) fn circles(&mut self, places: impl Into<Vec<PanelPoint>>, radius: f64, pen: Pen<'a>) {
        let places = places.into();
        self.add(move |sheet, axes| axes.spots(&places).iter().for_each(|at| sheet.circle(*at, radius, pen)));
    }
    /// A mark in a colour.
    pub(crate) fn mark(&mut self, at: PanelPoint, mark: Mark, colour: &'a str) {
        self.add(move |sheet, axes| mark.draw(sheet, axes.spot(at), colour));
    }
    /// Words beside a place, no closer than `clear`.
    pub(crate) fn label(&mut self, at: PanelPoint, text: String, towards: Spot, clear: f64) {
        self.add(move |sheet, axes| {
            let room = Room { area: axes.area.grown(-5.0), towards, clear };
            sheet.label(axes.spot(at), &text, Style::on_drawing(), room);
        });
    }
}

/// The pieces of a line between its gaps, where a value is not finite.
pub(crate) fn runs(places: &[PanelPoint]) -> impl Iterator<Item = &[PanelPoint]> {
    places.split(|place| place.iter().any(|value| !value.is_finite())).filter(|run| !run.is_empty())
}

/// Columns of a drawing: more points than a few in each are not seen.
const COLUMNS: f64 = 0.4;

/// The least and the greatest value in each column, in their order, where there are many points.
fn thinned(spots: &[Spot]) -> Vec<Spot> {
    if spots.len() < 4000 {
        return spots.to_vec();
    }
    let column = |spot: &Spot| (spot[0] / COLUMNS).floor();
    let mut out: Vec<Spot> = Vec::new();
    for part in spots.chunk_by(|a, b| column(a) == column(b)) {
        if let Some(Area { top, bottom, .. }) = Area::around(part) {
            let mut kept: Vec<&Spot> = part.iter().filter(|spot| spot[1] == top || spot[1] == bottom).collect();
            kept.dedup();
            out.extend([kept.first(), kept.last()].into_iter().flatten().map(|spot| **spot));
        }
    }
    out
}
