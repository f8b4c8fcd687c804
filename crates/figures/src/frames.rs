//! The way down: a few states of one run side by side.

use crate::elevation as draw;
use crate::geometry::{Extent, Turn, View, as_built, largest_displacement, moved, round_down};
use crate::sheet::{Area, HAIR, MARGIN, Pen, SMALL, Sheet, Style, WIDTH, font};
use crate::words;
use assess::outcome::{Motion, Picture};

/// Most panels on a sheet.
const MOST: usize = 6;
/// Gap between panels.
const GAP: f64 = 18.0;
/// Share of the larger dimension of the bridge that displacements are drawn with, at most, where they are exaggerated.
const SHARE: f64 = 0.06;

/// The bridge as built, at its last stable load, and in even steps of what came after; displacements exaggerated
/// alike where they would not be seen. Without a last stable state, even steps of the whole run. None where nothing
/// moves.
pub fn collapse_frames(picture: &Picture) -> Option<String> {
    let built = as_built(&picture.shapes)?;
    let usable: Vec<usize> =
        (0..picture.snapshots.len()).filter(|&k| picture.snapshots[k].motions.len() == picture.shapes.len()).collect();
    if usable.is_empty() {
        return None;
    }
    let chosen = choose(&usable, picture.last_stable);
    let size = built.size()[0].max(built.size()[1]);
    let largest = chosen
        .iter()
        .map(|&k| largest_displacement(&picture.shapes, &picture.snapshots[k].motions, Turn::Finite))
        .fold(0.0, f64::max);
    if largest <= 1e-9 * size {
        return None;
    }
    let scale = round_down(SHARE * size / largest).max(1.0);
    let corners = |motions: &[Motion]| -> Vec<_> {
        picture.shapes.iter().zip(motions).flat_map(|(s, &m)| moved(s, m, scale, Turn::Finite)).collect()
    };
    // A block thrown far away does not make the bridge small.
    let whole = chosen
        .iter()
        .filter_map(|&k| Extent::of(corners(&picture.snapshots[k].motions)))
        .fold(built, |e, f| e.with(f))
        .within(built.grown(0.6 * size))
        .grown(0.015 * size);

    let mut sheet = Sheet::new("collapse");
    draw::define_hatch(&mut sheet);
    let how = if scale > 1.0 { format!("exaggerated {}", words::times(scale)) } else { "at true scale".into() };
    let top = sheet.title(&picture.title, &format!("Collapse, displacements {how}"));
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
            Some(s) => moved(&picture.shapes[k], picture.snapshots[*s].motions[k], scale, Turn::Finite),
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
