//! The ring at one moment: lines of thrust in all spans, and the joints of one span, open, closed or sliding.

use super::scene;
use crate::elevation::{self as draw, INK, THRUST};
use crate::geometry::{Extent, View};
use crate::sheet::{HAIR, MARGIN, MEDIUM, Pen, Sheet, Spot, Style, THICK};
use crate::{thrust, words};
use outcome::mesh::MadeOf;
use outcome::passage::{Moment, PairState, Passage, Row, RowKind};

/// Colours of the states, told apart in grey print by their size and fill.
const CLOSED: &str = "#2e6b2e";
const OPEN: &str = "#c0301c";
const SLIDING: &str = "#e08a00";

/// The ring at one moment that is kept: lines of thrust and joint states; none where the moment has no joints.
pub fn ring(passage: &Passage, index: usize) -> Option<String> {
    let moment = passage.moments.get(index)?;
    let joints = || moment.rows.iter().filter(|row| matches!(row.kind, RowKind::Joint { .. }));
    joints().next()?;
    let mesh = &passage.mesh;
    let extent = scene::extent(mesh)?;
    let second = scene::second_line(passage, moment, "Line of thrust and joints");
    let (mut sheet, top) = Sheet::titled(&format!("moment-{index}-ring"), &passage.bridge, &second);
    let (_, view) = draw::fit(extent, top + scene::AXLES, 230.0);
    let window = view.area(extent).taller(2.0);
    sheet.open_clipped("bridge", "whole", window);
    stones(&mut sheet, &view, passage);
    thrust::plain(&mut sheet, &view, &moment.thrust_lines(), Pen::line(THRUST, THICK));
    sheet.close();
    scene::draw_axles(&mut sheet, &view, moment, mesh, extent.low[0], extent.high[0]);
    let mut y = draw::scale_bar(&mut sheet, &view, window.bottom + 4.0) + 8.0;
    let span = most_moved(moment);
    if let Some(part) = close_up(moment, span) {
        let words = format!("Joints of span {}, {}", span + 1, counts(moment, span));
        y = sheet.paragraph(MARGIN, y, 768.0, &words, Style::default()) + 4.0;
        let (_, view) = draw::fit(part, y, 330.0);
        let window = view.area(part).taller(2.0);
        sheet.open_clipped("span", "close", window);
        stones(&mut sheet, &view, passage);
        thrust::plain(&mut sheet, &view, &moment.thrust_lines(), Pen::line(THRUST, THICK));
        for row in joints().filter(|row| of_span(row, span)) {
            states(&mut sheet, &view, row);
        }
        sheet.close();
        sheet.rectangle(window, Pen::line("#9a9a9a", HAIR));
        y = draw::scale_bar(&mut sheet, &view, window.bottom + 4.0);
    }
    y = key(&mut sheet, y + 2.0);
    let largest = joints().flat_map(|row| &row.pairs).map(|pair| pair.opening).fold(0.0, f64::max);
    let caption = format!("The widest joint of the bridge opens by {} mm.", words::three_digits(1e3 * largest));
    Some(sheet.end(y + 2.0, &caption))
}

fn of_span(row: &Row, span: usize) -> bool {
    matches!(row.kind, RowKind::Joint { span: of, .. } if of == span)
}

/// The span with most points that are not closed, the first of equals.
fn most_moved(moment: &Moment) -> usize {
    let spans = moment.rows.iter().filter_map(|row| match row.kind {
        RowKind::Joint { span, .. } => Some(span),
        RowKind::Contact => None,
    });
    let count = |span: usize| {
        let pairs = moment.rows.iter().filter(|row| of_span(row, span)).flat_map(|row| &row.pairs);
        pairs.filter(|pair| pair.state != PairState::Closed).count()
    };
    (0..=spans.max().unwrap_or(0)).rev().max_by_key(|span| count(*span)).unwrap_or(0)
}

/// Around the joints of a span.
fn close_up(moment: &Moment, span: usize) -> Option<Extent> {
    let pairs = moment.rows.iter().filter(|row| of_span(row, span)).flat_map(|row| &row.pairs);
    let around = Extent::of(pairs.map(|pair| pair.at))?;
    Some(around.grown(0.06 * around.size()[0].max(around.size()[1])))
}

/// How many joints are closed all over, open somewhere, and slide somewhere.
fn counts(moment: &Moment, span: usize) -> String {
    let rows = || moment.rows.iter().filter(|row| of_span(row, span));
    let any = |row: &&Row, state| row.pairs.iter().any(|pair| pair.state == state);
    let open = rows().filter(|row| any(row, PairState::Open)).count();
    let sliding = rows().filter(|row| any(row, PairState::Sliding)).count();
    format!("{} in all: {open} open somewhere, {sliding} sliding somewhere", rows().count())
}

/// Masonry as built, pale.
fn stones(sheet: &mut Sheet, view: &View, passage: &Passage) {
    let mesh = &passage.mesh;
    let made_of = |zone: usize| mesh.zones.get(zone).map(|zone| zone.made_of);
    for (kinds, colour) in
        [(&[MadeOf::Voussoirs][..], "#f2e8d5"), (&[MadeOf::Pier, MadeOf::Abutment, MadeOf::Backing][..], "#e2dccd")]
    {
        let of = |zone: usize| made_of(zone).is_some_and(|one| kinds.contains(&one));
        let quads = mesh.quads.iter().zip(&mesh.zone_of).filter(|(_, zone)| of(**zone));
        let spots: Vec<[Spot; 4]> = quads.map(|(quad, _)| quad.map(|node| view.spot(mesh.nodes[node]))).collect();
        sheet.areas(&spots, colour);
    }
    let masonry = |edge: &[usize; 2], inside: &[bool]| edge.iter().all(|node| inside[*node]);
    let mut inside = vec![false; mesh.nodes.len()];
    for (quad, zone) in mesh.quads.iter().zip(&mesh.zone_of) {
        let fill = matches!(made_of(*zone), Some(MadeOf::Fill | MadeOf::HaunchFill | MadeOf::AbutmentFill));
        quad.iter().filter(|_| !fill).for_each(|node| inside[*node] = true);
    }
    let edges: Vec<[usize; 2]> = scene::outlines(mesh).into_iter().filter(|edge| masonry(edge, &inside)).collect();
    scene::draw_outlines(sheet, view, &mesh.nodes, &edges, 0.4);
    sheet.polyline(&view.spots(&mesh.surface), Pen::line("#404040", MEDIUM).class("surface"));
}

/// Each point of a joint by its state; an open joint gapes towards its open face.
fn states(sheet: &mut Sheet, view: &View, row: &Row) {
    sheet.open("joint");
    let spots: Vec<Spot> = row.pairs.iter().map(|pair| view.spot(pair.at)).collect();
    sheet.polyline(&spots, Pen::line(INK, HAIR));
    for (pair, spot) in row.pairs.iter().zip(&spots) {
        dot(sheet, *spot, pair.state);
    }
    sheet.close();
}

fn dot(sheet: &mut Sheet, at: Spot, state: PairState) {
    match state {
        PairState::Closed => sheet.circle(at, 1.5, Pen::shape(CLOSED, "none", 0.0).class("closed")),
        PairState::Open => sheet.circle(at, 2.7, Pen::shape("white", OPEN, 1.2).class("open")),
        PairState::Sliding => sheet.circle(at, 2.5, Pen::shape(SLIDING, INK, HAIR).class("sliding")),
    }
}

fn key(sheet: &mut Sheet, top: f64) -> f64 {
    let style = Style::small();
    let (mut x, y) = (MARGIN, top + 14.0);
    sheet.open("key");
    for (state, text) in [(PairState::Closed, "closed"), (PairState::Open, "open"), (PairState::Sliding, "sliding")] {
        dot(sheet, [x + 6.0, y - 4.0], state);
        sheet.text([x + 14.0, y], text, style);
        x += 34.0 + style.width(text);
    }
    sheet.line([x, y - 4.0], [x + 24.0, y - 4.0], Pen::line(THRUST, THICK));
    sheet.text([x + 30.0, y], "line of thrust, through the resultant of each joint", style);
    sheet.close();
    y + 6.0
}
