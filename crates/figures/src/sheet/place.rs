//! Finds a place for a label beside the thing it names.

use super::{Anchor, Area, HAIR, MARGIN, Pen, Sheet, Spot, Style, WIDTH, font, text_area};

/// Where labels may go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Room {
    /// The whole room.
    pub area: Area,
    /// Direction in which the label had best go, or (0, 0).
    pub towards: Spot,
    /// Distance of the label from its point that is never undercut.
    pub clear: f64,
}

impl Room {
    /// The sheet between two heights.
    pub(crate) fn between(top: f64, bottom: f64) -> Room {
        Room { area: Area { left: MARGIN, right: WIDTH - MARGIN, top, bottom }, towards: [0.0, 0.0], clear: 7.0 }
    }
    /// With a favoured direction.
    pub(crate) fn towards(mut self, direction: Spot) -> Room {
        self.towards = direction;
        self
    }
}

impl Sheet {
    /// Sets a label near `at`, where it covers no other text and as little else as can be; a thin line leads to it
    /// where it stands off.
    pub(crate) fn label(&mut self, at: Spot, text: &str, style: Style, room: Room) {
        self.labels(at, &[text], style, room);
    }

    /// The same with several texts under one another.
    pub(crate) fn labels(&mut self, at: Spot, texts: &[&str], style: Style, room: Room) {
        if at.iter().any(|c| !c.is_finite()) {
            return;
        }
        let step = 1.25 * style.size;
        let height = texts.len().saturating_sub(1) as f64 * step;
        let area = |spot: Spot, style: Style| {
            let lines = texts.iter().map(|text| text_area(spot, text, style));
            let widest = lines.reduce(|a, b| Area { left: a.left.min(b.left), right: a.right.max(b.right), ..a });
            widest.map(|first| Area { bottom: first.bottom + height, ..first })
        };
        let mut best: Option<(f64, Spot, Style, Option<[Spot; 2]>)> = None;
        for (ring, &distance) in [0.0, 9.0, 18.0, 30.0, 44.0, 60.0, 80.0, 105.0].iter().enumerate() {
            for step in 0..16 {
                let angle = std::f64::consts::TAU * f64::from(step) / 16.0;
                let (c, s) = (angle.cos(), angle.sin());
                let reach = room.clear + distance;
                let anchor = if c > 0.38 {
                    Anchor::Start
                } else if c < -0.38 {
                    Anchor::End
                } else {
                    Anchor::Middle
                };
                // The middle of the letters' height lies on the ray at the sides, their foot or head above and below.
                let drop = 0.5 * font::CAPITAL * style.size * (1.0 + s) - 0.5 * height * (1.0 - s);
                let spot = [at[0] + reach * c, at[1] + reach * s + drop];
                let candidate = Style { anchor, ..style };
                let Some(area) = area(spot, candidate) else { return };
                let astray = 1.0 - (c * room.towards[0] + s * room.towards[1]);
                let cost = self.cost(area, room.area)
                    + self.leader_cost(leader(at, area, room.clear, distance))
                    + 6.0 * ring as f64
                    + 14.0 * astray;
                if best.as_ref().is_none_or(|b| cost < b.0 - 1e-9) {
                    best = Some((cost, spot, candidate, leader(at, area, room.clear, distance)));
                }
            }
        }
        let Some((_, spot, style, leader)) = best else { return };
        if let Some([from, to]) = leader {
            self.line(from, to, Pen::line("#555555", HAIR).class("leader"));
        }
        for (k, text) in texts.iter().enumerate() {
            self.text([spot[0], spot[1] + k as f64 * step], text, style);
        }
    }

    fn cost(&self, area: Area, room: Area) -> f64 {
        let outside = (room.left - area.left).max(0.0)
            + (area.right - room.right).max(0.0)
            + (room.top - area.top).max(0.0)
            + (area.bottom - room.bottom).max(0.0);
        let over_text: f64 = self.texts.iter().map(|t| t.overlap(&area.grown(2.5))).sum();
        let size = (area.right - area.left) * (area.bottom - area.top);
        let over_drawing: f64 = self.obstacles.iter().map(|(o, weight)| weight * o.overlap(&area)).sum();
        1e4 * outside + 1e3 * over_text + 160.0 * over_drawing / size.max(1.0)
    }

    /// A leader had better not run through texts, nor far over the drawing.
    fn leader_cost(&self, leader: Option<[Spot; 2]>) -> f64 {
        let Some([from, to]) = leader else { return 0.0 };
        let dot = |k: i32| {
            let t = f64::from(k) / 6.0;
            let at = [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])];
            Area::about(at, 1.0)
        };
        let text = |dot: &Area| f64::from(self.texts.iter().any(|a| a.overlap(dot) > 0.0));
        let over = |dot: &Area| {
            let weights = self.obstacles.iter().filter(|(a, _)| a.overlap(dot) > 0.0).map(|o| o.1);
            weights.fold(0.0, f64::max)
        };
        (0..6).map(dot).map(|d| 400.0 * text(&d) + 5.0 * over(&d)).sum()
    }
}

/// The line from beside a point to the nearest place of its text, where the text stands off.
fn leader(at: Spot, text: Area, clear: f64, distance: f64) -> Option<[Spot; 2]> {
    if distance < 8.0 {
        return None;
    }
    let text = text.grown(1.5);
    let near = [at[0].clamp(text.left, text.right), at[1].clamp(text.top, text.bottom)];
    let way = [near[0] - at[0], near[1] - at[1]];
    let length = way[0].hypot(way[1]);
    let start = (clear - 2.5).max(0.0);
    (length > start + 2.0).then(|| [[at[0] + start * way[0] / length, at[1] + start * way[1] / length], near])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_one_point_do_not_cover_each_other() {
        let mut sheet = Sheet::new("try");
        for k in 0..8 {
            sheet.label([400.0, 200.0], &format!("{k} extrados"), Style::on_drawing(), Room::between(0.0, 400.0));
        }
        let texts = sheet.texts();
        assert_eq!(texts.len(), 8);
        for (k, a) in texts.iter().enumerate() {
            assert!(texts[k + 1..].iter().all(|b| a.overlap(b) == 0.0), "label {k}");
        }
    }

    #[test]
    fn texts_of_one_label_stand_under_one_another_and_clear_of_their_point() {
        for towards in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
            let mut sheet = Sheet::new("try");
            let room = Room::between(0.0, 400.0).towards(towards);
            sheet.labels([400.0, 200.0], &["106.4 kN/m", "79.9 kN/m", "145 kN/m"], Style::on_drawing(), room);
            let texts = sheet.texts();
            assert!(texts.windows(2).all(|pair| pair[0].bottom < pair[1].bottom && pair[0].overlap(&pair[1]) == 0.0));
            let point = Area { left: 400.0, right: 400.0, top: 200.0, bottom: 200.0 }.grown(3.0);
            assert!(texts.iter().all(|text| text.overlap(&point) == 0.0), "{towards:?}");
        }
    }

    #[test]
    fn a_label_at_the_edge_stays_on_the_sheet() {
        let mut sheet = Sheet::new("try");
        sheet.label([WIDTH - MARGIN, 20.0], "a long label at the edge", Style::default(), Room::between(0.0, 60.0));
        assert!(sheet.texts()[0].right <= WIDTH - MARGIN + 1e-9);
    }
}
