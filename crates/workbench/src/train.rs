//! A train, a few positions at a time, as flat numbers for drawing.

use crate::border::{Telling, Thrown};
use crate::document::Document;
use crate::result::Outcome;
use extrados::results::passage::{Moment, PairState};
use extrados::{RespondOptions, Unwatched};
use js_sys::Function;
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// A passage that goes on when it is told to.
#[wasm_bindgen]
pub struct Passing {
    inner: extrados::Passing,
    done: usize,
    moment: Moment,
    /// Displacements under the weight of the bridge [m].
    at_rest: Vec<[f64; 2]>,
    project: extrados::Project,
}

#[wasm_bindgen]
impl Passing {
    /// The bridge under its own weight.
    ///
    /// # Errors
    /// Those of [`extrados::Passing`].
    #[wasm_bindgen(constructor)]
    pub fn new(document: &Document, tell: &Function) -> Result<Passing, Thrown> {
        let project = document.project()?;
        let mut inner = extrados::Passing::new(project, &RespondOptions::default(), &mut Telling::to(tell))?;
        let moment = inner.moment()?;
        let at_rest = moment.displacements.clone();
        Ok(Passing { inner, done: 0, moment, at_rest, project: project.clone() })
    }

    /// Moves the train on. The word of its end, empty while it goes on.
    ///
    /// # Errors
    /// A part of the bridge whose law has no answer.
    pub fn advance(&mut self, positions: u32) -> Result<String, Thrown> {
        let ended = self.inner.advance(positions as usize, &mut Unwatched)?;
        self.done = self.inner.done();
        self.moment = self.inner.moment()?;
        Ok(ended.map_or("", |status| status.word()).to_owned())
    }

    /// Positions in all.
    #[wasm_bindgen(getter)]
    pub fn count(&self) -> u32 {
        self.inner.setup().positions.len() as u32
    }

    /// Positions that are done.
    #[wasm_bindgen(getter)]
    pub fn done(&self) -> u32 {
        self.done as u32
    }

    /// Time [s] and place of the first axle [m] of every position.
    pub fn places(&self) -> Vec<f64> {
        let setup = self.inner.setup();
        setup.times.iter().zip(&setup.positions).flat_map(|(time, position)| [*time, *position]).collect()
    }

    /// What is recorded.
    pub fn sensors(&self) -> String {
        let places = self.inner.sensor_places();
        let all = self.inner.setup().sensors.iter().zip(places).map(|(sensor, at)| {
            json!({
                "name": sensor.name, "quantity": sensor.quantity, "about": sensor.about, "unit": sensor.quantity.unit(),
                "scale": sensor.quantity.scale(), "at": at,
            })
        });
        Value::from_iter(all).to_string()
    }

    /// Values of the sensors at the position that was reached last [SI].
    pub fn values(&self) -> Vec<f64> {
        self.inner.values().collect()
    }

    /// The mesh as built.
    pub fn mesh(&self) -> String {
        json!(self.inner.setup().meshed.picture()).to_string()
    }

    /// Displacement of every node since the bridge stood under its own weight [m].
    pub fn displacements(&self) -> Vec<f32> {
        let moved = self.moment.displacements.iter().zip(&self.at_rest);
        moved.flat_map(|(now, then)| [(now[0] - then[0]) as f32, (now[1] - then[1]) as f32]).collect()
    }

    /// Of each pair of facing points x, y, opening, sliding [m], normal traction [Pa], state.
    pub fn joints(&self) -> Vec<f32> {
        let pairs = self.moment.rows.iter().flat_map(|row| &row.pairs);
        pairs
            .flat_map(|pair| {
                let state = match pair.state {
                    PairState::Closed => 0.0,
                    PairState::Open => 1.0,
                    PairState::Sliding => 2.0,
                };
                [pair.at[0], pair.at[1], pair.opening, pair.sliding, pair.normal, state]
            })
            .map(|value| value as f32)
            .collect()
    }

    /// Of each quadrilateral the stress [Pa]: xx, yy, xy, tension positive.
    pub fn stresses(&self) -> Vec<f32> {
        self.moment.stresses.iter().flat_map(|stress| [stress[0] as f32, stress[1] as f32, stress[2] as f32]).collect()
    }

    /// Of each axle above the mesh its place [m] and force [N].
    pub fn axles(&self) -> Vec<f64> {
        self.moment.axles.iter().flat_map(|(place, force)| [*place, *force]).collect()
    }

    /// The passage as a whole, as far as it came.
    ///
    /// # Errors
    /// Those of [`advance`](Self::advance).
    pub fn finish(self, tell: &Function) -> Result<Outcome, Thrown> {
        let found = self.inner.finish(&mut Telling::to(tell))?;
        Ok(Outcome::passage(&self.project, found))
    }
}
