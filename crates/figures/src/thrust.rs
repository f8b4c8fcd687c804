//! The line of thrust inside the ring.

use crate::elevation::{self as draw, INK, Sign, THRUST};
use crate::geometry::{View, as_built};
use crate::mechanism::mark_hinges;
use crate::sheet::place::Room;
use crate::sheet::{Area, Pen, Sheet, Style, THICK};
use crate::words;
use assess::outcome::{Picture, Point, ThrustPoint};

/// The ring with its line of thrust, hinges, loads, and the size of the thrust at springings and crown. None
/// without a line of thrust.
pub fn thrust_line(picture: &Picture) -> Option<String> {
    let drawable = |line: &&Vec<ThrustPoint>| line.len() > 1;
    if !picture.thrust_lines.iter().any(|l| drawable(&l)) {
        return None;
    }
    let built = as_built(&picture.shapes)?;
    let mut sheet = Sheet::new();
    draw::define_hatch(&mut sheet);
    let second = match picture.collapse_load {
        Some(load) if !picture.moves_supports => format!("Line of thrust at collapse, {}", words::force(load)),
        _ => "Line of thrust".to_string(),
    };
    let top = sheet.title(&picture.title, &second);
    let extent = draw::extent(picture).unwrap_or(built);
    let frame = draw::frame(extent, top + draw::ARROW, draw::TALLEST);
    let view = View::fit(extent, frame);
    draw::blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    draw::avoid_blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    draw::surface(&mut sheet, &view, picture);
    draw::load_arrows(&mut sheet, &view, picture, None);
    sheet.open("thrust-lines");
    for line in picture.thrust_lines.iter().filter(drawable) {
        let points: Vec<Point> =
            line.iter().map(|t| t.point).filter(|p| p[0].is_finite() && p[1].is_finite()).collect();
        sheet.polyline(&view.spots(&points), Pen::line(THRUST, THICK).class("thrust"));
    }
    sheet.close();

    let room = Room::between(top, frame.bottom + 22.0);
    let middle = [0.5 * (built.low[0] + built.high[0]), 0.5 * (built.low[1] + built.high[1])];
    let hinges: Vec<_> = picture.hinges.iter().map(|h| (*h, h.point)).collect();
    mark_hinges(&mut sheet, &picture.shapes, &view, &hinges, middle, room);
    for line in picture.thrust_lines.iter().filter(drawable) {
        magnitudes(&mut sheet, &view, line, room);
    }

    let mut y = draw::scale_bar(&mut sheet, &view, frame.bottom + 26.0);
    let mut entries = vec![(Sign::Thrust, "line of thrust, with its force where marked")];
    if !hinges.is_empty() {
        entries.push((Sign::Hinge, "hinge"));
    }
    if !picture.loads.is_empty() {
        entries.push((Sign::Load, "load"));
    }
    y = draw::key(&mut sheet, y + 2.0, &entries);
    if let Some(loads) = draw::load_words(picture) {
        y = sheet.caption(y, &loads);
    }
    Some(sheet.finish(y))
}

/// Size of the thrust at the first and last joint and where the line is highest.
fn magnitudes(sheet: &mut Sheet, view: &View, line: &[ThrustPoint], room: Room) {
    let highest = (0..line.len()).max_by(|&a, &b| line[a].point[1].total_cmp(&line[b].point[1]).then(b.cmp(&a)));
    let mut marked = vec![0, line.len() - 1];
    if let Some(k) = highest.filter(|k| !marked.contains(k)) {
        marked.push(k);
    }
    for k in marked {
        let at = view.spot(line[k].point);
        sheet.circle(at, 2.6, Pen::shape(THRUST, INK, 0.6).class("thrust-mark"));
        sheet.avoid(Area { left: at[0] - 4.0, right: at[0] + 4.0, top: at[1] - 4.0, bottom: at[1] + 4.0 });
        // Into the opening: below the crown, and from the springings towards the middle of the span.
        let side = if k == 0 {
            [0.8, 0.6]
        } else if k + 1 == line.len() {
            [-0.8, 0.6]
        } else {
            [0.0, 1.0]
        };
        let style = Style { colour: THRUST, ..Style::on_drawing() };
        sheet.label(at, &words::force(line[k].thrust), style, room.towards(side));
    }
}
