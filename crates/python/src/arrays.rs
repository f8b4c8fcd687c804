//! Which columns results have, by the names that the package gives them. All are in SI units.

use crate::answer::Found;
use crate::view::{column, whole};
use extrados::results::collapse::Collapse;
use extrados::results::passage::{Moment, Passage};
use extrados::results::picture::Snapshot;
use extrados::results::update::Update;
use pyo3::prelude::*;

type Seen<'py> = PyResult<Option<Bound<'py, PyAny>>>;

/// A column; `None` where the result has none of this name and number.
pub(crate) fn array<'py>(owner: &Bound<'py, PyAny>, found: &Found, name: &str, at: usize, within: usize) -> Seen<'py> {
    match found {
        Found::Collapse(found) => of_collapse(owner, found, name, at),
        Found::Passage(found) => of_passage(owner, found, name, at, within),
        Found::Update(found, _) => of_update(owner, found, name, at),
        _ => Ok(None),
    }
}

fn of_collapse<'py>(owner: &Bound<'py, PyAny>, found: &Collapse, name: &str, at: usize) -> Seen<'py> {
    let picture = &found.picture;
    let mechanism = picture.mechanism.as_deref();
    let seen = match name {
        "outline" => picture.shapes.get(at).map(|shape| whole(owner, &shape.outline)),
        "path_load" => Some(column(owner, &picture.path, |step| &step.load)),
        "path_displacement" => Some(column(owner, &picture.path, |step| &step.displacement)),
        "path_iterations" => Some(column(owner, &picture.path, |step| &step.iterations)),
        "mechanism_translation" => mechanism.map(|all| column(owner, all, |motion| &motion.translation)),
        "mechanism_rotation" => mechanism.map(|all| column(owner, all, |motion| &motion.rotation)),
        "thrust_point" => picture.thrust_lines.get(at).map(|line| column(owner, line, |point| &point.point)),
        "thrust" => picture.thrust_lines.get(at).map(|line| column(owner, line, |point| &point.thrust)),
        "particle_centre" => Some(column(owner, &picture.particles, |disc| &disc.centre)),
        "particle_radius" => Some(column(owner, &picture.particles, |disc| &disc.radius)),
        "particle_layer" => Some(column(owner, &picture.particles, |disc| &disc.layer)),
        "hinge_point" => Some(column(owner, &found.picture.hinges, |hinge| &hinge.point)),
        "hinge_rotation" => Some(column(owner, &found.picture.hinges, |hinge| &hinge.rotation)),
        "hinge_blocks" => Some(column(owner, &found.picture.hinges, |hinge| &hinge.between)),
        _ => return of_snapshot(owner, picture.snapshots.get(at), name),
    };
    seen.transpose()
}

fn of_snapshot<'py>(owner: &Bound<'py, PyAny>, snapshot: Option<&Snapshot>, name: &str) -> Seen<'py> {
    let Some(s) = snapshot else { return Ok(None) };
    let seen = match name {
        "translation" => column(owner, &s.motions, |motion| &motion.translation),
        "rotation" => column(owner, &s.motions, |motion| &motion.rotation),
        "velocity" => whole(owner, &s.velocities),
        "block_stress" => whole(owner, &s.stresses),
        "contact_blocks" => column(owner, &s.contacts, |contact| &contact.blocks),
        "contact_point" => column(owner, &s.contacts, |contact| &contact.point),
        "contact_normal" => column(owner, &s.contacts, |contact| &contact.normal),
        "contact_compression" => column(owner, &s.contacts, |contact| &contact.compression),
        "contact_shear" => column(owner, &s.contacts, |contact| &contact.shear),
        "contact_stress" => column(owner, &s.contacts, |contact| &contact.stress),
        "contact_sliding" => column(owner, &s.contacts, |contact| &contact.sliding),
        "disc_centre" => column(owner, &s.particles, |disc| &disc.centre),
        "disc_angle" => column(owner, &s.particles, |disc| &disc.angle),
        "disc_velocity" => column(owner, &s.particles, |disc| &disc.velocity),
        "disc_stress" => column(owner, &s.particles, |disc| &disc.stress),
        "force_particle" => column(owner, &s.particle_forces, |force| &force.particle),
        "force_point" => column(owner, &s.particle_forces, |force| &force.point),
        "force_normal" => column(owner, &s.particle_forces, |force| &force.normal),
        "force_compression" => column(owner, &s.particle_forces, |force| &force.compression),
        "force_shear" => column(owner, &s.particle_forces, |force| &force.shear),
        "force_sliding" => column(owner, &s.particle_forces, |force| &force.sliding),
        _ => return Ok(None),
    };
    seen.map(Some)
}

fn of_passage<'py>(owner: &Bound<'py, PyAny>, found: &Passage, name: &str, at: usize, within: usize) -> Seen<'py> {
    let influence = found.influence.as_ref();
    let seen = match name {
        "time" => Some(whole(owner, &found.times)),
        "position" => Some(whole(owner, &found.positions)),
        "channel" => found.channels.get(at).map(|channel| whole(owner, &channel.values)),
        "influence_position" => influence.map(|lines| whole(owner, &lines.positions)),
        "influence" => influence.and_then(|lines| lines.values.get(at)).map(|line| whole(owner, line)),
        "node" => Some(whole(owner, &found.mesh.nodes)),
        "element" => Some(whole(owner, &found.mesh.quads)),
        "zone" => Some(whole(owner, &found.mesh.zone_of)),
        _ => {
            let moment = found.moments.get(at);
            return moment.map_or(Ok(None), |moment| of_moment(owner, moment, name, within));
        }
    };
    seen.transpose()
}

/// A column of a moment of a passage; `within` tells which joint.
pub(crate) fn of_moment<'py>(owner: &Bound<'py, PyAny>, moment: &Moment, name: &str, within: usize) -> Seen<'py> {
    let row = || moment.rows.get(within).map(|row| &row.pairs);
    let seen = match name {
        "displacement" => Some(whole(owner, &moment.displacements)),
        "stress" => Some(whole(owner, &moment.stresses)),
        "yielding" => Some(whole(owner, &moment.yielding)),
        "pair_point" => row().map(|pairs| column(owner, pairs, |pair| &pair.at)),
        "pair_normal" => row().map(|pairs| column(owner, pairs, |pair| &pair.normal)),
        "pair_shear" => row().map(|pairs| column(owner, pairs, |pair| &pair.shear)),
        "pair_opening" => row().map(|pairs| column(owner, pairs, |pair| &pair.opening)),
        "pair_sliding" => row().map(|pairs| column(owner, pairs, |pair| &pair.sliding)),
        _ => None,
    };
    seen.transpose()
}

fn of_update<'py>(owner: &Bound<'py, PyAny>, found: &Update, name: &str, at: usize) -> Seen<'py> {
    let channel = || found.channels.get(at);
    let seen = match name {
        "time" => Some(whole(owner, &found.times)),
        "position" => Some(whole(owner, &found.positions)),
        "measured" => channel().map(|channel| whole(owner, &channel.measured)),
        "start" => channel().map(|channel| whole(owner, &channel.start)),
        "updated" => channel().map(|channel| whole(owner, &channel.updated)),
        "sample" => {
            let samples = found.posterior.as_ref().and_then(|report| report.posterior.samples.get(at));
            samples.map(|sample| whole(owner, sample))
        }
        _ => None,
    };
    seen.transpose()
}

/// How many there are of what has a number.
pub(crate) fn count(found: &Found, name: &str) -> usize {
    match (found, name) {
        (Found::Collapse(found), "blocks") => found.picture.shapes.len(),
        (Found::Collapse(found), "snapshots") => found.picture.snapshots.len(),
        (Found::Collapse(found), "thrust_lines") => found.picture.thrust_lines.len(),
        (Found::Passage(found), "channels") => found.channels.len(),
        (Found::Passage(found), "moments") => found.moments.len(),
        (Found::Passage(found), "rows") => found.moments.first().map_or(0, |moment| moment.rows.len()),
        (Found::Update(found, _), "channels") => found.channels.len(),
        (Found::Update(found, _), "samples") => {
            found.posterior.as_ref().map_or(0, |report| report.posterior.samples.len())
        }
        _ => 0,
    }
}

/// Names of what has a number.
pub(crate) fn words(found: &Found, name: &str) -> Vec<String> {
    match (found, name) {
        (Found::Collapse(found), "block_names") => found.block_names.clone(),
        (Found::Collapse(found), "block_roles") => {
            found.picture.shapes.iter().map(|shape| shape.role.clone()).collect()
        }
        (Found::Collapse(found), "snapshot_loads") => {
            found.picture.snapshots.iter().map(|snapshot| snapshot.load.to_string()).collect()
        }
        (Found::Collapse(found), "figures") => {
            let drawn = figures::FIGURES.iter().filter(|figure| (figure.draw)(&found.picture).is_some());
            drawn.map(|figure| figure.name.to_owned()).collect()
        }
        (Found::Passage(found), "channels") => found.channels.iter().map(|channel| channel.name.clone()).collect(),
        (Found::Passage(found), "channel_units") => {
            found.channels.iter().map(|channel| channel.quantity.unit().to_owned()).collect()
        }
        (Found::Passage(found), "channel_scales") => {
            found.channels.iter().map(|channel| channel.quantity.scale().to_string()).collect()
        }
        (Found::Passage(found), "moments") => found.moments.iter().map(|moment| moment.name.clone()).collect(),
        (Found::Update(found, _), "channels") => found.channels.iter().map(|channel| channel.name.clone()).collect(),
        (Found::Update(found, _), "parameters") => {
            found.problem.parameters().iter().map(|parameter| parameter.name.clone()).collect()
        }
        _ => Vec::new(),
    }
}
