//! The way down: a few states of one run side by side.

use crate::elevation as draw;
use crate::geometry::{Extent, Turn, View, as_built, moved};
use crate::sheet::{Area, HAIR, MARGIN, Pen, SMALL, Sheet, Style, WIDTH, font};
use crate::words;
use assess::outcome::{Motion, Picture};

/// Most panels on a sheet.
const MOST: usize = 6;
/// Gap between panels.
const GAP: f64 = 18.0;

/// The bridge as built, at its last stable load, and in even steps of what came after; at true scale. Without a
/// last stable state, even steps of the whole run. None without snapshots.
pub fn collapse_frames(picture: &Picture) -> Option<String> {
    let built = as_built(&picture.shapes)?;
    let usable: Vec<usize> =
        (0..picture.snapshots.len()).filter(|&k| picture.snapshots[k].motions.len() == picture.shapes.len()).collect();
    if usable.is_empty() {
        return None;
    }
    let chosen = choose(&usable, picture.last_stable);
    let corners = |motions: &[Motion]| -> Vec<_> {
        picture.shapes.iter().zip(motions).flat_map(|(s, &m)| moved(s, m, 1.0, Turn::Finite)).collect()
    };
    let size = built.size()[0].max(built.size()[1]);
    // A block thrown far away does not make the bridge small.
    let whole = chosen
        .iter()
        .filter_map(|&k| Extent::of(corners(&picture.snapshots[k].motions)))
        .fold(built, |e, f| e.with(f))
        .within(built.grown(0.6 * size))
        .grown(0.015 * size);

    let mut sheet = Sheet::new("collapse");
    draw::define_hatch(&mut sheet);
    let top = sheet.title(&picture.title, "Collapse, displacements at true scale");
    let panels: Vec<Option<usize>> = std::iter::once(None).chain(chosen.iter().copied().map(Some)).collect();
    let [w, h] = whole.size();
    let columns = if panels.len() == 1 {
        1
    } else if h > 1.4 * w {
        3.min(panels.len())
    } else {
        2
    };
    let wide = (WIDTH - 2.0 * MARGIN - GAP * (columns - 1) as f64) / columns as f64;
    let high = (wide * h / w.max(1e-9)).min(300.0);
    let style = Style { size: SMALL, ..Style::default() };
    let texts: Vec<String> = panels
        .iter()
        .enumerate()
        .map(|(n, panel)| format!("({}) {}", char::from(b'a' + (n % 26) as u8), words_for(picture, *panel)))
        .collect();
    let lines = texts.iter().map(|t| font::wrap(t, style.size, style.weight, wide).len()).max().unwrap_or(1);
    let pitch = high + 1.3 * SMALL * lines as f64 + 14.0;
    for (n, panel) in panels.iter().enumerate() {
        let (row, column) = (n / columns, n % columns);
        let left = MARGIN + column as f64 * (wide + GAP);
        let upper = top + row as f64 * pitch;
        let area = Area { left, right: left + wide, top: upper, bottom: upper + high };
        let view = View::fit(whole, area);
        sheet.open_clipped("panel", &format!("panel-{n}"), area);
        draw::blocks(&mut sheet, &view, &picture.shapes, |k| match panel {
            Some(s) => moved(&picture.shapes[k], picture.snapshots[*s].motions[k], 1.0, Turn::Finite),
            None => picture.shapes[k].outline.clone(),
        });
        sheet.close();
        sheet.rectangle(area, Pen::line("#9a9a9a", HAIR));
        sheet.paragraph(left, area.bottom + 2.0, wide, &texts[n], style);
    }
    let rows = panels.len().div_ceil(columns);
    Some(sheet.finish(top + rows as f64 * pitch - 12.0))
}

/// Which snapshots are drawn.
fn choose(usable: &[usize], last_stable: Option<usize>) -> Vec<usize> {
    let (mut chosen, rest): (Vec<usize>, Vec<usize>) = match last_stable.filter(|k| usable.contains(k)) {
        Some(stable) => (vec![stable], usable.iter().copied().filter(|&k| k > stable).collect()),
        None => (Vec::new(), usable.to_vec()),
    };
    let places = MOST - 1 - chosen.len();
    let count = rest.len().min(places);
    // Even steps that end at the last one.
    chosen.extend((1..=count).map(|k| rest[k * rest.len() / count - 1]));
    chosen
}

fn words_for(picture: &Picture, panel: Option<usize>) -> String {
    let Some(k) = panel else { return "as built".into() };
    let load = picture.snapshots[k].load;
    let load = if picture.moves_supports { words::metres(load) } else { words::force(load) };
    match picture.last_stable {
        Some(stable) if k == stable => format!("{load}, last stable"),
        Some(stable) if k > stable => {
            let after = picture.snapshots.len() - stable - 1;
            format!("{load}, on the way down, {} of {after}", k - stable)
        }
        _ => load,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_run_from_the_last_stable_state_to_the_end() {
        let usable: Vec<usize> = (0..40).collect();
        assert_eq!(choose(&usable, Some(17)), [17, 22, 28, 33, 39]);
        assert_eq!(choose(&usable, None).last(), Some(&39));
        assert_eq!(choose(&usable, None).len(), MOST - 1);
        assert_eq!(choose(&[0], Some(0)), [0]);
        assert_eq!(choose(&[0, 1], Some(0)), [0, 1]);
    }
}
