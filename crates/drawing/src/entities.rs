//! From the entities of a file to strands of points and circles in metres, with block references expanded.

use crate::Point;
use crate::curve::{self, Spline};
use crate::entity::{Content, Record, Space};
use crate::finding::{Findings, Place};
use crate::options::{Options, is_ignored};
use crate::shapes::Circle;
use crate::shown::{self, Hidden, LeftOut};
use crate::through::Fit;
use crate::transform::Transform;
use std::f64::consts::TAU;

/// Points drawn in one go, from where a file is no drawing of a bridge.
const MOST_POINTS: usize = 2_000_000;
/// Expanded entities, likewise: a few nested references with rows and columns multiply beyond any memory.
const MOST_EXPANDED: usize = 100_000;
/// Block references inside one another.
const DEEPEST: usize = 16;
/// Coordinates beyond this belong to no bridge [m].
pub(crate) const FARTHEST: f64 = 1e6;

const ORIGIN: Space = [0.0; 3];

/// A curve as points.
#[derive(Debug, Clone)]
pub(crate) struct Strand {
    pub(crate) place: Place,
    /// Points [m]; the last is not the first again where it is closed.
    pub(crate) points: Vec<Point>,
    pub(crate) closed: bool,
    /// Whether curves were made into chords.
    pub(crate) flattened: bool,
}

/// What the entities of a drawing amount to.
#[derive(Debug, Default)]
pub(crate) struct Strands {
    pub(crate) strands: Vec<Strand>,
    pub(crate) circles: Vec<Circle>,
    /// Single points: their layer and place [m].
    pub(crate) points: Vec<(String, Point)>,
}

pub(crate) struct Expansion<'a> {
    pub(crate) options: &'a Options,
    content: &'a Content,
    left_out: LeftOut,
    pub(crate) out: Strands,
    pub(crate) findings: &'a mut Findings,
    expanded: usize,
    points: usize,
    full: bool,
}

/// Where an entity stands: its map to metres, and the reference that it came through.
struct Context<'a> {
    map: Transform,
    through: Option<&'a Place>,
    depth: usize,
}

/// Expands all entities of a drawing.
pub(crate) fn expand(content: &Content, metres: f64, options: &Options, findings: &mut Findings) -> Strands {
    let mut expansion = Expansion {
        options,
        content,
        left_out: LeftOut::default(),
        out: Strands::default(),
        findings,
        expanded: 0,
        points: 0,
        full: false,
    };
    let context = Context { map: Transform::scale(metres), through: None, depth: 0 };
    for entity in &content.entities {
        expansion.entity(entity, &context);
    }
    shown::tell(expansion.left_out, options, expansion.findings);
    expansion.out
}

impl Expansion<'_> {
    fn entity(&mut self, entity: &Record, context: &Context<'_>) {
        if self.full {
            return;
        }
        let place = place(entity, context);
        if self.is_full(&place) {
            return;
        }
        // What lies in paper space within a block is a part of its sheet.
        if let Some(hidden) = entity.hidden.or_else(|| self.content.hidden_layers.hide(&place.layer, entity.kind)) {
            if hidden != Hidden::PaperSpace || context.depth == 0 {
                *self.left_out.entry((place.layer, hidden)).or_insert(0) += 1;
            }
            return;
        }
        if entity.kind == "INSERT" {
            return self.insert(entity, &place, context);
        }
        if is_ignored(self.options, &place.layer) {
            return;
        }
        match entity.kind {
            "LINE" => {
                let ends = [10, 11].map(|code| entity.space(code, ORIGIN));
                if self.is_flat(&place, context, ends.iter().map(|p| p[2])) {
                    self.strand(place, ends.map(|p| [p[0], p[1]]).to_vec(), &context.map, false, false);
                }
            }
            "POINT" => {
                let [x, y, z] = entity.space(10, ORIGIN);
                let at = context.map.point([x, y]);
                if z == 0.0 && self.is_near(&place, &[at]) {
                    self.points += 1;
                    self.out.points.push((place.layer, at));
                }
            }
            "LWPOLYLINE" | "POLYLINE" => self.polyline(place, entity, context),
            "ARC" | "CIRCLE" => self.arc(place, entity, context),
            "ELLIPSE" => self.ellipse(place, entity, context),
            _ => self.spline(place, entity, context),
        }
    }

    fn polyline(&mut self, place: Place, entity: &Record, context: &Context<'_>) {
        let (flags, light) = (entity.whole(70, 0), entity.kind == "LWPOLYLINE");
        // 16 and 64: meshes in space. 8 is a line in space, which may lie in the plane.
        if !light && flags & (16 | 64) != 0 {
            let help = "explode it and draw the outlines of the blocks";
            return self.findings.error("D105", place, "a mesh in space is no outline", help);
        }
        let Some(map) = self.plane(&place, context, entity) else { return };
        let (vertices, closed) = (entity.vertices(), flags & 1 != 0);
        let height = entity.number(if light { 38 } else { 30 }, 0.0);
        if !self.is_flat(&place, context, vertices.iter().map(|v| v.height).chain([height])) {
            return;
        }
        let tolerance = self.tolerance(&map);
        let (Some(first), Some(last)) = (vertices.first(), vertices.last()) else { return };
        let mut points = vec![first.at];
        let mut flattened = false;
        for pair in vertices.windows(2) {
            flattened |= pair[0].bulge != 0.0;
            points.extend(curve::bulge(pair[0].at, pair[1].at, pair[0].bulge, tolerance));
        }
        if closed && last.bulge != 0.0 {
            flattened = true;
            points.extend(curve::bulge(last.at, first.at, last.bulge, tolerance));
            points.pop();
        }
        self.strand(place, points, &map, closed, flattened);
    }

    /// An arc, its angles in degrees, or a circle.
    fn arc(&mut self, place: Place, entity: &Record, context: &Context<'_>) {
        let ([x, y, z], radius) = (entity.space(10, ORIGIN), entity.number(40, 0.0));
        let Some(map) = self.plane(&place, context, entity) else { return };
        if !self.is_flat(&place, context, [z].into_iter()) || !self.has_size(&place, radius) {
            return;
        }
        let centre = [x, y];
        if entity.kind == "ARC" {
            let from = entity.number(50, 0.0).to_radians();
            let sweep = curve::sweep(from, entity.number(51, 360.0).to_radians());
            let points = curve::arc(centre, radius, from, sweep, self.tolerance(&map));
            return self.strand(place, points, &map, false, true);
        }
        match map.similarity() {
            Some(size) => {
                let (centre, radius) = (map.point(centre), radius * size);
                if self.is_near(&place, &[centre, [radius, 0.0]]) {
                    self.points += 1;
                    let layer = place.layer.clone();
                    self.out.circles.push(Circle { layer, place: place.at(centre), centre, radius });
                }
            }
            // Stretched in one direction, it is an ellipse.
            None => {
                let mut points = curve::arc(centre, radius, 0.0, TAU, self.tolerance(&map));
                points.pop();
                self.strand(place, points, &map, true, true);
            }
        }
    }

    /// An ellipse, its parameters in radians.
    fn ellipse(&mut self, place: Place, entity: &Record, context: &Context<'_>) {
        let (centre, long) = (entity.space(10, ORIGIN), entity.space(11, [1.0, 0.0, 0.0]));
        let (share, from, to) = (entity.number(40, 1.0), entity.number(41, 0.0), entity.number(42, TAU));
        // Centre and axes are in the drawing's own coordinates; the normal only decides which way round.
        let Some(_) = self.plane(&place, context, entity) else { return };
        let turn = if entity.normal()[2] < 0.0 { -1.0 } else { 1.0 };
        let major = [long[0], long[1]];
        if !self.is_flat(&place, context, [centre[2], long[2]].into_iter())
            || !self.has_size(&place, share * major[0].hypot(major[1]))
        {
            return;
        }
        let minor = [-turn * share * major[1], turn * share * major[0]];
        let whole = (to - from).abs() >= TAU - 1e-9;
        let sweep = if whole { TAU } else { curve::sweep(from, to) };
        let centre = [centre[0], centre[1]];
        let mut points = curve::ellipse(centre, major, minor, from, sweep, self.tolerance(&context.map));
        let closed = sweep >= TAU - 1e-9;
        if closed {
            points.pop();
        }
        self.strand(place, points, &context.map, closed, true);
    }

    fn spline(&mut self, place: Place, entity: &Record, context: &Context<'_>) {
        let (points, fit) = (entity.points([10, 20, 30]), entity.points([11, 21, 31]));
        if !self.is_flat(&place, context, points.iter().chain(&fit).map(|p| p[2])) {
            return;
        }
        let [points, fit] = [points, fit].map(|points| points.iter().map(|p| [p[0], p[1]]).collect::<Vec<Point>>());
        let [knots, weights] = [40, 41].map(|code| entity.all(code).collect::<Vec<f64>>());
        let degree = usize::try_from(entity.whole(71, 1)).unwrap_or(0);
        let curve = Spline { degree, knots: &knots, points: &points, weights: &weights };
        let defect = curve.defect();
        if points.is_empty() || (defect.is_some() && fit.len() > 1) {
            let direction = |code: i32| entity.all(code).next().map(|_| entity.space(code, ORIGIN));
            let tangents = [12, 13].map(|code| direction(code).map(|t| [t[0], t[1]]));
            let closed = entity.whole(70, 0) & 1 != 0;
            return self.fitted(place, &Fit { points: &fit, closed, tangents }, context);
        }
        if let Some(defect) = defect {
            let message = format!("the spline cannot be drawn: it has {defect}");
            return self.findings.error("D103", place, message, "convert it to a polyline");
        }
        self.strand(place, curve.points(self.tolerance(&context.map)), &context.map, false, true);
    }

    /// A spline that is given by the points it passes through.
    fn fitted(&mut self, place: Place, fit: &Fit<'_>, context: &Context<'_>) {
        if let Some(defect) = fit.defect() {
            let message = format!("the spline by fit points cannot be drawn: it has {defect}");
            return self.findings.error("D103", place, message, "convert it to a polyline");
        }
        let (points, apart) = fit.curve(self.tolerance(&context.map));
        let apart = apart * context.map.stretch();
        let message = format!(
            "spline by fit points: read as the cubic through its {} points by the length of chords; one by another parameter lies {:.1} mm from it",
            fit.points.len(),
            1e3 * apart
        );
        let at = place.at(context.map.point(fit.points[0]));
        if apart > self.options.chord_tolerance {
            let help = "compare the outline with the drawing, or convert the spline to a polyline before the export";
            self.findings.warning("D110", at, message, help);
        } else {
            self.findings.note("D110", at, message);
        }
        self.strand(place, points, &context.map, false, true);
    }

    /// A reference to a block, with its rows and columns.
    fn insert(&mut self, insert: &Record, place: &Place, context: &Context<'_>) {
        let Some(block) = self.content.blocks.get(&insert.name.to_uppercase()) else {
            let message = format!("the block {} is not in the file", insert.name);
            let help = "bind external references before the export, or take this one out";
            return self.findings.error("D107", place.clone(), message, help);
        };
        if context.depth >= DEEPEST {
            let message = format!("block references lie more than {DEEPEST} deep inside one another");
            return self.findings.error("D107", place.clone(), message, "explode the references");
        }
        let Some(map) = self.plane(place, context, insert) else { return };
        let (at, scales) = (insert.space(10, ORIGIN), [41, 42].map(|code| insert.number(code, 1.0)));
        if scales.contains(&0.0) {
            let message = format!("the block {} is inserted with a scale of zero", insert.name);
            return self.findings.error("D107", place.clone(), message, "take it out");
        }
        if !self.is_flat(place, context, [at[2]].into_iter()) {
            return;
        }
        let (s, c) = insert.number(50, 0.0).to_radians().sin_cos();
        // Of columns and of rows.
        let [across, up] = [44, 45].map(|code| insert.number(code, 0.0));
        let [columns, rows] = [70, 71].map(|code| insert.whole(code, 1).max(1));
        for row in 0..rows {
            for column in 0..columns {
                // Every repetition counts, even of an empty block.
                if self.is_full(place) {
                    return;
                }
                let (dx, dy) = (f64::from(column) * across, f64::from(row) * up);
                let mut own = Transform {
                    x: [scales[0] * c, scales[0] * s],
                    y: [-scales[1] * s, scales[1] * c],
                    origin: [at[0] + c * dx - s * dy, at[1] + s * dx + c * dy],
                };
                let moved = own.vector(block.base);
                own.origin = [own.origin[0] - moved[0], own.origin[1] - moved[1]];
                let inner = Context { map: map.after(&own), through: Some(place), depth: context.depth + 1 };
                for entity in &block.entities {
                    self.entity(entity, &inner);
                }
            }
        }
    }

    /// Points before a map, as a strand.
    fn strand(&mut self, place: Place, points: Vec<Point>, map: &Transform, closed: bool, flattened: bool) {
        let points: Vec<Point> = points.into_iter().map(|p| map.point(p)).collect();
        if !points.is_empty() && self.is_near(&place, &points) {
            self.points += points.len();
            let place = place.at(points[0]);
            self.out.strands.push(Strand { place, points, closed, flattened });
        }
    }

    /// Counts one more entity or repetition; whether there are more than a drawing of a bridge holds, which is said once.
    fn is_full(&mut self, place: &Place) -> bool {
        self.expanded += 1;
        if !self.full && (self.expanded > MOST_EXPANDED || self.points > MOST_POINTS) {
            self.full = true;
            let message = "block references and curves expand to more than a drawing of a bridge holds";
            self.findings.error("D106", place.clone(), message, "export only the outlines of the blocks");
        }
        self.full
    }

    /// The tolerance of chords before a map.
    fn tolerance(&self, map: &Transform) -> f64 {
        self.options.chord_tolerance / map.stretch().max(f64::MIN_POSITIVE)
    }

    /// The map of an entity drawn in its own plane: seen from above, or from below as a mirror image.
    fn plane(&mut self, place: &Place, context: &Context<'_>, entity: &Record) -> Option<Transform> {
        let [x, y, z] = entity.normal();
        let size = (x * x + y * y + z * z).sqrt();
        // Round-off of a turned coordinate system.
        let upright = x.hypot(y) <= 1e-9 * size && size > 0.0;
        if !upright {
            let message = format!("the entity lies in a plane with normal ({x}, {y}, {z})");
            self.findings.error("D105", place.clone(), message, "draw it in the plane z = 0");
            return None;
        }
        Some(if z < 0.0 { context.map.after(&Transform::mirrored()) } else { context.map })
    }

    /// Whether all heights are zero, to the gap tolerance.
    fn is_flat(&mut self, place: &Place, context: &Context<'_>, heights: impl Iterator<Item = f64>) -> bool {
        let size = context.map.stretch();
        let farthest = heights.map(|z| z * size).fold(0.0, |most: f64, z| if z.abs() > most.abs() { z } else { most });
        if farthest.abs() > self.options.gap_tolerance {
            let message = format!("the entity leaves the plane z = 0: z = {farthest:.4} m");
            self.findings.error("D105", place.clone(), message, "move it into the plane z = 0");
            return false;
        }
        true
    }

    fn has_size(&mut self, place: &Place, radius: f64) -> bool {
        if radius > 0.0 {
            return true;
        }
        let message = format!("a radius of {radius} is none");
        self.findings.error("D304", place.clone(), message, "take it out");
        false
    }

    fn is_near(&mut self, place: &Place, points: &[Point]) -> bool {
        let near = points.iter().flatten().all(|x| x.abs() <= FARTHEST);
        if !near {
            let message = format!("coordinates beyond {:.0} km belong to no bridge", FARTHEST / 1e3);
            let help = "move the drawing to the origin, and check its unit";
            self.findings.error("D106", place.clone(), message, help);
        }
        near
    }
}

/// Where an entity stands. What a block draws on layer 0 lies on the layer of its reference.
fn place(entity: &Record, context: &Context<'_>) -> Place {
    let own = format!("{} {}", entity.kind, entity.handle).trim_end().to_owned();
    let layer = match context.through {
        Some(outer) if entity.layer == "0" => &outer.layer,
        _ => &entity.layer,
    };
    let name = context.through.map_or(own.clone(), |outer| format!("{own} in {}", outer.entity));
    Place { layer: layer.clone(), entity: name, at: None }
}
