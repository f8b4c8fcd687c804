//! A load under the pointer.

use crate::border::Thrown;
use crate::document::Document;
use extrados::results::collapse::Status;
use extrados::results::picture::{Picture, Point};
use extrados::{Choice, Placed, VehicleChoice};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// The bridge prepared once.
#[wasm_bindgen]
pub struct Placing {
    inner: extrados::Placing,
    /// Centroid of each shape of the picture [m].
    centroids: Vec<Point>,
}

#[wasm_bindgen]
impl Placing {
    /// With the loads of the file, where no vehicle and no rule is named, or with a vehicle.
    ///
    /// # Errors
    /// Those of [`extrados::Placing`].
    #[wasm_bindgen(constructor)]
    pub fn new(document: &Document, vehicle: &str, rule: &str, leftward: bool) -> Result<Placing, Thrown> {
        let (project, choice) = (document.project()?, Choice::default());
        let asked = VehicleChoice { vehicle: vehicle.to_owned(), rule: rule.to_owned(), leftward };
        let inner = match vehicle.is_empty() && rule.is_empty() {
            true => extrados::Placing::loads(project, &choice)?,
            false => extrados::Placing::vehicle(project, &choice, &asked)?,
        };
        let picture = extrados::as_built(project)?;
        Ok(Placing { inner, centroids: centroids(&picture) })
    }

    /// What is put where, and what is assumed.
    pub fn about(&self) -> String {
        let [from, to] = self.inner.range();
        let driven = self.inner.driven();
        let axles: Vec<Value> = driven
            .iter()
            .flat_map(|driven| driven.axles())
            .map(|(force, offset)| json!({ "force": force, "offset": offset }))
            .collect();
        json!({
            "name": driven.map_or("loads of the file", |driven| driven.vehicle.vehicle.title.as_str()),
            "code": driven.map_or("", |driven| driven.vehicle.vehicle.code.as_str()),
            "rule": driven.map_or("", |driven| driven.rule.title.as_str()),
            "factors": self.inner.factors(), "axles": axles, "from": from, "to": to, "fast": self.inner.is_quick(), "stands": self.inner.stands(),
            "assumptions": self.inner.assumptions().iter().map(ToString::to_string).collect::<Vec<_>>(),
        })
        .to_string()
    }

    /// What is carried at one of many places along the road: carried and dilatant factor, NaN where there is none, how it ended, whether joints slide.
    pub fn factor(&mut self, x: f64) -> Vec<f64> {
        let found = self.inner.carried(x);
        let number = |factor: Option<f64>| factor.unwrap_or(f64::NAN);
        vec![number(found.factor), number(found.dilatant), ended(found.status), f64::from(u8::from(found.slides))]
    }

    /// What is carried at a place, and how.
    pub fn at(&mut self, x: f64) -> Answer {
        Answer { placed: self.inner.put(x), centroids: self.centroids.clone() }
    }

    /// The same with dilatant friction alone; `open` says where less may be carried without dilation.
    pub fn quickly(&mut self, x: f64) -> Answer {
        Answer { placed: self.inner.put_quickly(x), centroids: self.centroids.clone() }
    }

    /// The zone of the line of thrust under so many times the loads: lowest and highest point of joint after joint, a point of NaN between
    /// rings.
    ///
    /// # Errors
    /// Those of [`extrados::Placing::zone`].
    pub fn zone(&mut self, x: f64, factor: f64) -> Result<Vec<f64>, Thrown> {
        let rings = self.inner.zone(x, factor)?;
        let mut flat = Vec::new();
        for (k, ring) in rings.iter().enumerate() {
            if k > 0 {
                flat.extend([f64::NAN; 4]);
            }
            flat.extend(ring.iter().flat_map(|[low, high]| [low[0], low[1], high[0], high[1]]));
        }
        Ok(flat)
    }
}

/// How a place ended, as a number.
fn ended(status: Status) -> f64 {
    match status {
        Status::Collapsed => 0.0,
        Status::Locks => 1.0,
        Status::UnstableUnderSelfWeight => 2.0,
        _ => 3.0,
    }
}

/// What is carried at a place, in numbers for drawing.
#[wasm_bindgen]
pub struct Answer {
    placed: Placed,
    centroids: Vec<Point>,
}

#[wasm_bindgen]
impl Answer {
    /// Everything but geometry.
    #[wasm_bindgen(getter)]
    pub fn json(&self) -> String {
        let placed = &self.placed;
        let case = placed.case.as_ref();
        json!({
            "stands": case.and_then(|case| case.axles), "critical": case.and_then(|case| case.critical_axle),
            "position": placed.position, "status": placed.status, "factor": placed.factor, "dilatant_factor": placed.dilatant,
            "lower_bound": placed.bounds[0], "upper_bound": placed.bounds[1],
            "load": placed.factor.map(|factor| factor * placed.reference), "reference_load": placed.reference, "friction": placed.flow,
            "slides": !placed.picture.sliding.is_empty(), "open": placed.is_open, "hinges": placed.picture.hinges, "sliding": placed.picture.sliding,
        })
        .to_string()
    }

    /// Points of all lines of thrust: x, y [m], thrust [N/m].
    #[wasm_bindgen(getter)]
    pub fn thrust(&self) -> Vec<f64> {
        let points = self.placed.picture.thrust_lines.iter().flatten();
        points.flat_map(|point| [point.point[0], point.point[1], point.thrust]).collect()
    }

    /// At which point each line begins.
    #[wasm_bindgen(getter)]
    pub fn thrust_starts(&self) -> Vec<u32> {
        let begins = self.placed.picture.thrust_lines.iter().scan(0u32, |next, line| {
            let begin = *next;
            *next += line.len() as u32;
            Some(begin)
        });
        begins.collect()
    }

    /// Motion of each shape: translation x, y, rotation; empty where nothing moves.
    #[wasm_bindgen(getter)]
    pub fn mechanism(&self) -> Vec<f64> {
        let motions = self.placed.picture.mechanism.iter().flatten();
        motions.flat_map(|motion| [motion.translation[0], motion.translation[1], motion.rotation]).collect()
    }

    /// Centroid of each shape: x, y [m].
    #[wasm_bindgen(getter)]
    pub fn centroids(&self) -> Vec<f64> {
        self.centroids.concat()
    }

    /// Forces on the blocks at a factor of one: x, y [m], force x, y [N/m].
    #[wasm_bindgen(getter)]
    pub fn loads(&self) -> Vec<f64> {
        let loads = self.placed.picture.loads.iter();
        loads.flat_map(|load| [load.at[0], load.at[1], load.force[0], load.force[1]]).collect()
    }

    /// What stands on the road: x, y, length [m], force [N/m] at a factor of one.
    #[wasm_bindgen(getter)]
    pub fn axles(&self) -> Vec<f64> {
        self.placed.strips.iter().flat_map(|(at, length, force)| [at[0], at[1], *length, *force]).collect()
    }
}

/// Centroid of each shape [m], by the shoelace formula.
pub fn centroids(picture: &Picture) -> Vec<Point> {
    picture.shapes.iter().map(|shape| centroid(&shape.outline)).collect()
}

fn centroid(outline: &[Point]) -> Point {
    let Some(&[ox, oy]) = outline.first() else { return [f64::NAN; 2] };
    let (mut area, mut x, mut y) = (0.0, 0.0, 0.0);
    for (k, p) in outline.iter().enumerate() {
        let q = outline[(k + 1) % outline.len()];
        let (p, q) = ([p[0] - ox, p[1] - oy], [q[0] - ox, q[1] - oy]);
        let cross = p[0] * q[1] - q[0] * p[1];
        area += 0.5 * cross;
        x += (p[0] + q[0]) * cross / 6.0;
        y += (p[1] + q[1]) * cross / 6.0;
    }
    [ox + x / area, oy + y / area]
}
