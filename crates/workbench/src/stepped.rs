//! The block engine, a few steps at a time, as flat numbers for drawing.

use crate::analyses;
use crate::border::{Telling, Thrown};
use crate::document::Document;
use crate::live::centroids;
use extrados::results::picture::{Picture, Point};
use extrados::{Refusal, Watch, dem};
use js_sys::Function;
use std::cell::OnceCell;
use wasm_bindgen::prelude::*;

/// A collapse that goes on when it is told to.
#[wasm_bindgen]
pub struct Stepping {
    inner: extrados::Stepping,
    picture: Picture,
    centroids: Vec<Point>,
    /// What stands there now, once somebody has looked.
    frame: OnceCell<dem::Frame>,
}

impl Stepping {
    /// The bridge with its loads; fill of particles is packed and at rest first.
    ///
    /// # Errors
    /// Those of [`extrados::Stepping`]; a stop on the way (F108).
    pub fn watched(document: &Document, choice: &str, watch: &mut dyn Watch) -> Result<Stepping, Refusal> {
        let made = extrados::Stepping::with_fill(document.project()?, &analyses::choice(choice)?, watch)?;
        let stopped = || Refusal::new("F108", "the fill was not packed: it was stopped on the way", "start again");
        let inner = made.ok_or_else(stopped)?;
        let picture = inner.picture();
        Ok(Stepping { centroids: centroids(&picture), frame: OnceCell::new(), picture, inner })
    }
}

#[wasm_bindgen]
impl Stepping {
    /// The same, told to the page.
    ///
    /// # Errors
    /// Those of [`watched`](Self::watched).
    #[wasm_bindgen(constructor)]
    pub fn new(document: &Document, choice: &str, tell: &Function) -> Result<Stepping, Thrown> {
        Ok(Stepping::watched(document, choice, &mut Telling::to(tell))?)
    }

    /// Goes on for so many steps. The word of its end, empty while it goes on.
    pub fn advance(&mut self, steps: u32) -> String {
        self.frame.take();
        let ended = self.inner.advance(u64::from(steps)).map(extrados::Stepping::ended);
        ended.map_or("", |status| status.word()).to_owned()
    }

    /// The state as bytes, to come back to.
    pub fn state(&self) -> Vec<u8> {
        self.inner.state()
    }

    /// Goes back, or on, to a state.
    ///
    /// # Errors
    /// A state of something else.
    pub fn restore(&mut self, state: &[u8]) -> Result<(), Thrown> {
        self.inner.take_up(state)?;
        self.frame.take();
        Ok(())
    }

    fn frame(&self) -> &dem::Frame {
        self.frame.get_or_init(|| self.inner.frame())
    }

    /// The load that acts [N/m].
    #[wasm_bindgen(getter)]
    pub fn load(&self) -> f64 {
        self.inner.load()
    }

    /// Steps so far.
    #[wasm_bindgen(getter)]
    pub fn steps(&self) -> f64 {
        self.inner.progress().0 as f64
    }

    /// Out-of-balance force over acting force when the run looked last.
    #[wasm_bindgen(getter)]
    pub fn unbalanced(&self) -> f64 {
        self.inner.progress().1
    }

    /// Shapes and particles before they moved.
    pub fn picture(&self) -> String {
        serde_json::to_string(&self.picture).unwrap_or_else(|_| "null".to_owned())
    }

    /// Pose of each shape: x, y of its centroid [m], angle [rad].
    pub fn poses(&self) -> Vec<f64> {
        let poses = self.frame().poses.iter();
        poses.flat_map(|pose| [pose.position.x, pose.position.y, pose.rotation.sin.atan2(pose.rotation.cos)]).collect()
    }

    /// Centroid of each shape as built [m].
    pub fn centroids(&self) -> Vec<f64> {
        self.centroids.concat()
    }

    /// Of each particle x, y, radius [m], angle [rad], mean stress [Pa].
    pub fn particles(&self) -> Vec<f32> {
        let all = self.frame().particles.iter();
        all.flat_map(|p| [p.centre.x, p.centre.y, p.radius, p.angle, 0.5 * (p.stress[0] + p.stress[1])])
            .map(|value| value as f32)
            .collect()
    }

    /// Of each closed contact of blocks x, y [m], normal x, y, compression, shear [N/m], stress [Pa], whether it slides.
    pub fn contacts(&self) -> Vec<f32> {
        let all = self.frame().contacts.iter();
        all.flat_map(|c| {
            let slides = f64::from(u8::from(c.sliding));
            [c.point.x, c.point.y, c.normal.x, c.normal.y, c.compression, c.shear, c.compression / c.length, slides]
        })
        .map(|value| value as f32)
        .collect()
    }

    /// Of each closed contact of particles from x, y to x, y [m], compression, shear [N/m], whether it slides.
    pub fn chains(&self) -> Vec<f32> {
        let all = self.frame().particle_contacts.iter();
        all.flat_map(|c| {
            let from = self.frame().particles[c.particle].centre;
            let to = match c.partner {
                dem::Body::Particle(other) => self.frame().particles[other].centre,
                dem::Body::Block(_) => c.point,
            };
            [from.x, from.y, to.x, to.y, c.compression, c.shear, f64::from(u8::from(c.sliding))]
        })
        .map(|value| value as f32)
        .collect()
    }

    /// Average stress of each shape [Pa]: xx, yy, xy, tension positive.
    pub fn stresses(&self) -> Vec<f32> {
        self.frame().stresses.iter().flatten().map(|value| *value as f32).collect()
    }

    /// Of each load step that has ended load [N/m], displacement of the watched point x, y [m], steps, whether it is at rest.
    pub fn path(&self) -> Vec<f64> {
        let points = self.inner.path();
        points
            .flat_map(|(load, point)| {
                let at_rest = f64::from(u8::from(point.at_rest));
                [load, point.displacement.x, point.displacement.y, point.iterations as f64, at_rest]
            })
            .collect()
    }
}
