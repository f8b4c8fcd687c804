//! A block model file from a model: every block listed.

use super::Scene;
use crate::discretise::Discretised;
use bridge::{Damping, Method};
use mechanics::blocks::{ContactLaw, Stiffness};
use mechanics::ids::GroupId;
use std::fmt::Write;

/// A block model file from a drawing, which says where bodies are and nothing of what they are made of. What it does not say
/// stands there as a line to fill in, which the reader refuses until that is done.
pub fn skeleton(name: &str, drawing: &drawing::Drawing) -> String {
    let mut page = format!(
        "# {}: outlines of a drawing, in metres.\n# Lines marked TO FILL IN hold what no drawing says; the file is refused until they are filled in.\n\n\
         [model]\nname = {}\n\n",
        name,
        text(name)
    );
    for layer in &drawing.layers {
        let _ = write!(
            page,
            "[[material]]\nname = {}\ndensity = \"TO FILL IN kg/m^3\"\ncompressive_strength = \"TO FILL IN MPa\"  # or \"unlimited\"\nrounding = \"0 mm\"\n\n",
            text(layer)
        );
    }
    page += "[[joint]]                        # between all pairs of materials; [[joint]] with first and second for one pair\n\
             friction_angle = \"TO FILL IN deg\"\ncohesion = \"0 kPa\"\n\n";
    page += "# A load, such as\n# [[load]]\n# x = \"1.0 m\"\n# y = \"2.0 m\"\n# down = \"1 kN/m\"\n\n";
    page += "# Change role to \"support\" for blocks that do not move.\n\n";
    for outline in &drawing.outlines {
        block(&mut page, &outline.layer, &outline.layer, None, false, &outline.points);
    }
    for layer in &drawing.layers {
        let circles: Vec<[f64; 3]> = drawing
            .circles
            .iter()
            .filter(|c| c.layer == *layer)
            .map(|c| [c.centre[0], c.centre[1], c.radius])
            .collect();
        particles(&mut page, layer, layer, &circles);
    }
    page
}

/// A block model file from a model, with every number that decides an analysis: read again, it gives the same model.
pub fn toml(scene: &Scene) -> String {
    let mut page = format!(
        "# {}: every block listed, in metres.\n\n[model]\nname = {}\nwidth = \"{} m\"\ngravity = \"{} m/s^2\"\n\n",
        one_line(&scene.name),
        text(&scene.name),
        scene.width,
        scene.gravity
    );
    for material in &scene.materials {
        let m = &material.masonry;
        let _ = writeln!(page, "[[material]]\nname = {}\ndensity = \"{} kg/m^3\"", text(&material.name), m.density);
        if let Some(modulus) = m.elastic_modulus {
            let _ = writeln!(page, "elastic_modulus = \"{modulus} Pa\"");
        }
        if let Some(ratio) = m.poisson_ratio {
            let _ = writeln!(page, "poisson_ratio = {ratio:?}");
        }
        let strength = m.compressive_strength.map_or("unlimited".to_owned(), |strength| format!("{strength} Pa"));
        let _ = writeln!(page, "compressive_strength = \"{strength}\"\nrounding = \"{} m\"\n", m.rounding);
    }
    let names: Vec<String> = scene.materials.iter().map(|material| material.name.clone()).collect();
    joints(&mut page, &names, |a, b| *scene.laws.between(GroupId(a as u32), GroupId(b as u32)));
    for force in &scene.forces {
        load(&mut page, &force.name, force.at, force.force, force.permanent);
    }
    plan(&mut page, &scene.plan);
    for body in &scene.bodies {
        block(&mut page, &body.layer, &names[body.material], Some(&body.name), body.held, &body.outline);
    }
    for (k, name) in names.iter().enumerate() {
        let mut layers: Vec<&str> = Vec::new();
        for particle in scene.particles.iter().filter(|particle| particle.material == k) {
            if !layers.contains(&particle.layer.as_str()) {
                layers.push(&particle.layer);
            }
        }
        for layer in layers {
            let own = scene.particles.iter().filter(|p| p.material == k && p.layer == layer);
            let circles: Vec<[f64; 3]> = own.map(|p| [p.centre[0], p.centre[1], p.radius]).collect();
            particles(&mut page, layer, name, &circles);
        }
    }
    page
}

/// The blocks of a bridge as a block model: each group of the discretised bridge is a material.
pub fn of_bridge(bridge: &bridge::Bridge, d: &Discretised) -> Scene {
    let groups: Vec<String> = d.model.groups.iter().cloned().collect();
    let body = |(id, block): (mechanics::ids::BlockId, &mechanics::blocks::Block)| super::Body {
        name: d.origins[id].name(),
        layer: d.origins[id].role().to_uppercase(),
        material: block.group.0 as usize,
        held: block.held.is_fixed(),
        outline: block.outline.vertices().iter().map(|v| [v.x, v.y]).collect(),
    };
    let force = |f: &mechanics::blocks::PointForce, permanent: bool| super::Force {
        name: if permanent { "cover".into() } else { "load".into() },
        body: f.block.0 as usize,
        at: [f.at.x, f.at.y],
        force: [f.force.x, f.force.y],
        permanent,
    };
    let material = |name: &String| bridge::blocks::Material { name: name.clone(), masonry: bridge.masonry };
    let permanent = d.loading.permanent.iter().map(|f| force(f, true));
    Scene {
        name: bridge.name.clone(),
        width: bridge.width,
        gravity: bridge.gravity,
        bodies: d.model.blocks.pairs().map(body).collect(),
        particles: Vec::new(),
        materials: groups.iter().map(material).collect(),
        laws: d.model.laws.clone(),
        forces: permanent.chain(d.loading.variable.iter().map(|f| force(f, false))).collect(),
        plan: bridge.plan.clone(),
    }
}

/// One joint for all pairs where all laws are alike, else one a pair.
fn joints(page: &mut String, names: &[String], law: impl Fn(usize, usize) -> ContactLaw) {
    let pairs = || (0..names.len()).flat_map(|a| (a..names.len()).map(move |b| (a, b)));
    let Some((a, b)) = pairs().next() else { return };
    let common = law(a, b);
    let alike = pairs().all(|(a, b)| law(a, b) == common);
    for (a, b) in pairs().take(if alike { 1 } else { usize::MAX }) {
        page.push_str("[[joint]]\n");
        if !alike {
            let _ = writeln!(page, "first = {}\nsecond = {}", text(&names[a]), text(&names[b]));
        }
        let law = law(a, b);
        for (word, stiffness) in [("normal", law.normal), ("shear", law.shear)] {
            let _ = match stiffness {
                Stiffness::Given(k) if k.is_finite() => writeln!(page, "{word}_stiffness = \"{k} Pa/m\""),
                Stiffness::Given(_) => Ok(()),
                Stiffness::Series { joint, .. } => writeln!(page, "mortar_{word}_stiffness = \"{joint} Pa/m\""),
            };
        }
        let _ = writeln!(page, "friction_angle = \"{} rad\"\ncohesion = \"{} Pa\"", angle(law.friction), law.cohesion);
        let _ = writeln!(page, "tensile_strength = \"{} Pa\"", law.tension);
        if let Some(length) = law.fixed_length {
            let _ = writeln!(page, "fixed_length = \"{length} m\"");
        }
        let _ = writeln!(page, "least_length = \"{} m\"\n", law.least_length);
    }
}

/// The angle whose tangent is this coefficient to the last bit, where there is one.
fn angle(friction: f64) -> f64 {
    let near = friction.atan();
    [near, near.next_up(), near.next_down()].into_iter().find(|angle| angle.tan() == friction).unwrap_or(near)
}

fn load(page: &mut String, name: &str, at: [f64; 2], force: [f64; 2], permanent: bool) {
    let _ = writeln!(page, "[[load]]\nname = {}\nx = \"{} m\"\ny = \"{} m\"", text(name), at[0], at[1]);
    for (key, value) in [("down", -force[1]), ("right", force[0])] {
        if value != 0.0 {
            let _ = writeln!(page, "{key} = \"{value} N/m\"");
        }
    }
    page.push_str(if permanent { "permanent = true\n\n" } else { "\n" });
}

fn plan(page: &mut String, plan: &bridge::Plan) {
    // By whatever else a bridge was analysed: blocks of a drawing are analysed by discrete elements.
    let method = if plan.method.joints_deform() { Method::Dem } else { Method::Limit };
    let _ = writeln!(page, "[analysis]\nmethod = \"{}\"", method.word());
    for (key, value) in
        [("load_step", plan.load_step), ("load_limit", plan.load_limit), ("resolution", plan.resolution)]
    {
        if let Some(value) = value {
            let _ = writeln!(page, "{key} = \"{value} N/m\"");
        }
    }
    let _ = writeln!(page, "tolerance = {:?}\nstep_limit = {}", plan.tolerance, plan.step_limit);
    let _ = match plan.damping {
        Damping::Local(share) => writeln!(page, "damping = \"local\"\ndamping_share = {share:?}"),
        Damping::Viscous(share) => writeln!(page, "damping = \"viscous\"\ndamping_share = {share:?}"),
        Damping::Adaptive => writeln!(page, "damping = \"adaptive\""),
    };
    let (length, friction, points) = (plan.contact_length.word(), plan.friction.word(), plan.contact_points.word());
    let _ = writeln!(
        page,
        "contact_length = \"{length}\"\ntime_step_factor = {:?}\nfriction = \"{friction}\"\ncontact_points = \"{points}\"\nseed = {}\n",
        plan.time_step_factor, plan.seed
    );
}

fn block(page: &mut String, layer: &str, material: &str, name: Option<&str>, held: bool, outline: &[[f64; 2]]) {
    page.push_str("[[block]]\n");
    if let Some(name) = name {
        let _ = writeln!(page, "name = {}", text(name));
    }
    let _ = writeln!(page, "layer = {}\nmaterial = {}", text(layer), text(material));
    if held {
        page.push_str("role = \"support\"\n");
    }
    let _ = writeln!(page, "outline_m = [{}]\n", rows(outline));
}

fn particles(page: &mut String, layer: &str, material: &str, circles: &[[f64; 3]]) {
    if !circles.is_empty() {
        let _ = writeln!(
            page,
            "[[particles]]\nlayer = {}\nmaterial = {}\ncircles_m = [{}]\n",
            text(layer),
            text(material),
            rows(circles)
        );
    }
}

/// Rows of numbers, each printed so that it is read back to the same bits.
fn rows<const N: usize>(rows: &[[f64; N]]) -> String {
    let row = |row: &[f64; N]| format!("[{}]", row.map(|value| format!("{:?}", value + 0.0)).join(", "));
    rows.iter().map(row).collect::<Vec<_>>().join(", ")
}

/// Text in quotes.
fn text(words: &str) -> String {
    toml::Value::String(one_line(words)).to_string()
}

fn one_line(words: &str) -> String {
    words.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
