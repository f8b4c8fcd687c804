//! The answer over the plane of two quantities.

use super::{axis_name, name_and_unit, with_unit};
use crate::bar::Scale;
use crate::chart::Axis;
use crate::colour::dark_for_much;
use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, MEDIUM, Pen, SMALL, Sheet, Style, WIDTH};
use crate::ticks::Ticks;
use crate::words::{four_digits, raised};
use bridge::vary::Setting;
use outcome::study::{Row, Study};

/// More cells than this in a row carry no numbers: they would be smaller than letters.
const MOST_WITH_NUMBERS: usize = 12;
const CELL: f64 = 46.0;
const NONE: &str = "#f2f2f2";

/// Cells of a grid of two quantities, darker for more, with their numbers where there is room. None for other designs
/// and without an answer.
pub fn heat_map(study: &Study) -> Option<String> {
    let [across, up] = &study.quantities[..] else { return None };
    let answers = || study.rows.iter().skip(1).filter_map(|row| study.number(row)).filter(|number| number.is_finite());
    let (low, high) = (answers().reduce(f64::min)?, answers().reduce(f64::max)?);
    let (columns, lines) = (order(&across.values), order(&up.values));

    let (name, _) = name_and_unit(&study.outcome);
    let second = format!("The {name} over {} and {}, by {}", across.path, up.path, study.method.name());
    let (mut sheet, top) = Sheet::titled("heat-map", &study.bridge, &second);
    let small = Style::small();
    let wide = |setting: &Setting| small.width(&raised(&setting.text));
    let area = Area {
        left: MARGIN + 30.0 + up.values.iter().map(wide).fold(0.0, f64::max),
        right: WIDTH - MARGIN,
        top: top + 4.0,
        bottom: top + 4.0 + (CELL * lines.len() as f64).clamp(120.0, 560.0),
    };
    let cell = [(area.right - area.left) / columns.len() as f64, (area.bottom - area.top) / lines.len() as f64];
    let numbers = columns.len() <= MOST_WITH_NUMBERS && cell[1] > 1.5 * SMALL;
    let share = |number: f64| if high > low { (number - low) / (high - low) } else { 0.5 };
    for row in study.rows.iter().skip(1) {
        let (Some(x), Some(y)) = (place(&columns, row, 0), place(&lines, row, 1)) else { continue };
        let left = area.left + cell[0] * x as f64;
        let bottom = area.bottom - cell[1] * y as f64;
        let here = Area { left, right: left + cell[0], top: bottom - cell[1], bottom };
        let found = study.number(row);
        let colour = found.map_or(NONE.to_owned(), |number| dark_for_much(share(number)));
        sheet.rectangle(here, Pen::shape(&colour, "white", HAIR).class("cell"));
        let text = match found {
            Some(number) => four_digits(number),
            None => row.outcome.status.replace('-', " "),
        };
        // The middle of the colour map is about as dark as letters may be read on in black.
        let letters = if found.is_some_and(|number| share(number) > 0.5) { "#ffffff" } else { "#111111" };
        let lines = small.wrap(&text, cell[0] - 8.0);
        let high = 1.25 * SMALL * lines.len() as f64;
        if numbers && high < cell[1] - 4.0 {
            let style = Style { colour: letters, ..small.anchored(Anchor::Middle) };
            sheet.lines([left + 0.5 * cell[0], bottom - 0.5 * cell[1]], &lines, 1.25 * SMALL, style);
        }
    }
    let bottom = names(&mut sheet, study, area, cell, [&columns, &lines]);
    let name = axis_name(&study.outcome);
    let axis = Axis { name: &name, ticks: Ticks::over(low, high, 5).inside(low, high), ..Axis::blank(low, high) };
    let scale = Scale { axis, colour: dark_for_much, cut: false };
    let bottom = scale.draw(&mut sheet, MARGIN, MARGIN + 444.0, bottom + 4.0);
    Some(sheet.finish(bottom))
}

/// Places of values in the order of their numbers; words stay in the order asked for.
fn order(values: &[Setting]) -> Vec<usize> {
    let mut places: Vec<usize> = (0..values.len()).collect();
    if values.iter().all(|value| value.number.is_some()) {
        places.sort_by(|a, b| {
            let number = |at: &usize| values[*at].number.unwrap_or(0.0);
            number(a).total_cmp(&number(b))
        });
    }
    places
}

fn place(order: &[usize], row: &Row, quantity: usize) -> Option<usize> {
    let value = *row.run.choice.get(quantity)?;
    order.iter().position(|place| Some(*place) == value)
}

/// Values along both sides, the file's own framed; returns the y below.
fn names(sheet: &mut Sheet, study: &Study, area: Area, cell: [f64; 2], orders: [&[usize]; 2]) -> f64 {
    let small = Style::small();
    let [columns, lines] = orders;
    let values = |quantity: usize| &study.quantities[quantity].values;
    let widest = values(0).iter().map(|value| small.width(&raised(&value.text))).fold(0.0, f64::max);
    let every = (widest / (cell[0] - 6.0).max(1.0)).ceil().max(1.0) as usize;
    for (at, value) in columns.iter().enumerate().filter(|(at, _)| at % every == 0) {
        let x = area.left + cell[0] * (at as f64 + 0.5);
        sheet.text([x, area.bottom + 17.0], &raised(&values(0)[*value].text), small.anchored(Anchor::Middle));
    }
    let every = (1.4 * SMALL / cell[1]).ceil().max(1.0) as usize;
    for (at, value) in lines.iter().enumerate().filter(|(at, _)| at % every == 0) {
        let y = area.bottom - cell[1] * (at as f64 + 0.5);
        sheet.lines([area.left - 7.0, y], &[raised(&values(1)[*value].text)], 0.0, small.anchored(Anchor::End));
    }
    let own = |quantity: usize, order: &[usize]| {
        let own = study.quantities[quantity].own.as_ref()?;
        let same = |value: &Setting| match (value.number, own.number) {
            (Some(a), Some(b)) => a == b,
            _ => value.text == own.text,
        };
        order.iter().position(|place| same(&values(quantity)[*place]))
    };
    if let (Some(x), Some(y)) = (own(0, columns), own(1, lines)) {
        let (left, bottom) = (area.left + cell[0] * x as f64, area.bottom - cell[1] * y as f64);
        let frame = Area { left, right: left + cell[0], top: bottom - cell[1], bottom };
        sheet.rectangle(frame, Pen::line("#a02020", 2.0 * MEDIUM).class("baseline"));
    }
    sheet.rectangle(area, Pen::line(INK, 0.9));
    let name = Style::default().anchored(Anchor::Middle);
    sheet.text([0.5 * (area.left + area.right), area.bottom + 37.0], &study.quantities[0].path.to_string(), name);
    sheet.text_upwards([MARGIN + 10.0, 0.5 * (area.top + area.bottom)], &study.quantities[1].path.to_string(), name);
    let own = study.baseline().and_then(|row| study.number(row));
    let caption = own
        .map(|own| format!("As the file has it: {}; framed where it is in the grid.", with_unit(own, &study.outcome)));
    sheet.caption(area.bottom + 42.0, &caption.unwrap_or_default())
}
