//! The analysis plan, and whether the bridge says enough for it.

use toml::de::DeValue;

use crate::findings::Findings;
use crate::model::{
    Analysis, ContactLength, ContactPoints, Damping, Friction, Joint, JointStiffness, Load, Masonry, Method, Plan,
    Strip, SupportMovement,
};
use crate::tree::{Table, shorten, wrong_type};

use super::materials::maybe;

/// A word of the plan, or the default of its card.
fn word(table: Option<&Table<'_>>, key: &str, default: &'static str, findings: &mut Findings) -> Option<&'static str> {
    match table {
        Some(table) if table.has(key) => table.word(key, findings).map(|at| at.value),
        _ => Some(default),
    }
}

pub(super) fn plan(
    file: &Table<'_>,
    width: Option<f64>,
    spans: Option<usize>,
    findings: &mut Findings,
) -> Option<Plan> {
    let table = file.table("analysis", findings);
    if file.has("analysis") && table.is_none() {
        return None;
    }
    let table = table.as_ref();
    let method = word(table, "method", "limit", findings);
    let analysis = word(table, "analysis", "load", findings);
    let strip = strip(file, table, analysis, findings);
    let damping = word(table, "damping", "local", findings);
    let contact_length = word(table, "contact_length", "fixed", findings);
    let friction = word(table, "friction", "automatic", findings);
    let contact_points = word(table, "contact_points", "rounded", findings);
    let mut load = |key| match table {
        Some(table) => {
            let value = table.line_load(key, width, findings);
            maybe(table, key, value)
        }
        None => Some(None),
    };
    let (load_step, load_limit, resolution) = (load("load_step"), load("load_limit"), load("resolution"));
    let mut number = |key, default| match table {
        Some(table) => {
            let value = table.number(key, findings);
            maybe(table, key, value).map(|value| value.unwrap_or(default))
        }
        None => Some(default),
    };
    let tolerance = number("tolerance", 1e-5);
    let damping_share = number("damping_share", 0.8);
    let time_step_factor = number("time_step_factor", 0.8);
    let mut count = |key, default| match table {
        Some(table) => {
            let value = table.count(key, findings);
            maybe(table, key, value).map(|value| value.unwrap_or(default))
        }
        None => Some(default),
    };
    let step_limit = count("step_limit", 2_000_000);
    let seed = count("seed", 1);
    let support_movement = match file.has("support_movement") {
        true => support_movement(file, spans, findings).map(Some),
        false => Some(None),
    };
    let damping_share = damping_share?;
    Some(Plan {
        method: match method? {
            "dem" => Method::Dem,
            "fe" => Method::Fe,
            _ => Method::Limit,
        },
        analysis: match analysis? {
            "thickness" => Analysis::Thickness,
            "support-movement" => Analysis::SupportMovement,
            _ => Analysis::Load,
        },
        strip: strip?,
        load_step: load_step?,
        load_limit: load_limit?,
        resolution: resolution?,
        tolerance: tolerance?,
        step_limit: step_limit?,
        damping: match damping? {
            "viscous" => Damping::Viscous(damping_share),
            "adaptive" => Damping::Adaptive,
            _ => Damping::Local(damping_share),
        },
        contact_length: if contact_length? == "updated" { ContactLength::Updated } else { ContactLength::Fixed },
        time_step_factor: time_step_factor?,
        friction: match friction? {
            "associated" => Friction::Associated,
            "non-associated" => Friction::NonAssociated,
            _ => Friction::Automatic,
        },
        contact_points: if contact_points? == "full-ring" { ContactPoints::FullRing } else { ContactPoints::Rounded },
        support_movement: support_movement?,
        seed: seed?,
    })
}

/// Which strip: the word of the plan. Walls add strength in their plane only where somebody asks for it.
fn strip(
    file: &Table<'_>,
    table: Option<&Table<'_>>,
    analysis: Option<&'static str>,
    findings: &mut Findings,
) -> Option<Strip> {
    let wall = file.has("spandrel_wall");
    let for_load = analysis.is_none_or(|analysis| analysis == "load");
    let Some(table) = table.filter(|table| table.has("strip")) else {
        return Some(Strip::Fill);
    };
    let word = table.word("strip", findings)?;
    let strip = match word.value {
        "wall" => Strip::Wall,
        "both" => Strip::Both,
        _ => Strip::Fill,
    };
    if strip != Strip::Fill && !wall {
        findings.error(
            "B406",
            word.range,
            "there is no spandrel wall to analyse",
            "this strip has a wall on its rings",
            "describe it with [spandrel_wall], or write strip = \"fill\"",
        );
    }
    if strip == Strip::Both && !for_load {
        findings.error(
            "B406",
            word.range,
            "only collapse loads of the two strips can be added up",
            "a thickness or a movement belongs to one strip",
            "write strip = \"fill\" or strip = \"wall\"",
        );
    }
    Some(strip)
}

fn support_movement(file: &Table<'_>, spans: Option<usize>, findings: &mut Findings) -> Option<SupportMovement> {
    let table = file.table("support_movement", findings)?;
    let support = support(&table, spans, findings);
    let horizontal = table.number("horizontal", findings);
    let vertical = table.number("vertical", findings);
    let rotation = table.quantity("rotation", findings);
    let increment = table.quantity("increment", findings);
    let limit = table.quantity("limit", findings);
    let horizontal = maybe(&table, "horizontal", horizontal)?.unwrap_or(0.0);
    let vertical = maybe(&table, "vertical", vertical)?.unwrap_or(0.0);
    let rotation = maybe(&table, "rotation", rotation)?.unwrap_or(0.0);
    let increment = maybe(&table, "increment", increment)?;
    let limit = maybe(&table, "limit", limit)?;
    if horizontal == 0.0 && vertical == 0.0 && rotation == 0.0 {
        findings.error(
            "B403",
            table.range,
            "the support does not move",
            "no direction",
            "give `horizontal`, `vertical` or `rotation` other than zero, for example horizontal = 1.0",
        );
    }
    if let (Some(increment), Some(limit)) = (increment, limit)
        && increment > limit
    {
        findings.error(
            "B405",
            table.place("increment"),
            "the increment is more than the limit",
            format!("the limit is {limit} m"),
            "give a smaller increment or a larger limit",
        );
    }
    Some(SupportMovement { support: support?, horizontal, vertical, rotation, increment, limit })
}

/// 0 is the left abutment, then piers, then the right abutment.
fn support(table: &Table<'_>, spans: Option<usize>, findings: &mut Findings) -> Option<usize> {
    let (field, raw) = table.entry("support")?;
    let DeValue::String(text) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    let spans = spans?;
    let index = match text.trim() {
        "left abutment" => Some(0),
        "right abutment" => Some(spans),
        other => other
            .strip_prefix("pier")
            .and_then(|number| number.trim().parse::<usize>().ok())
            .filter(|number| (1..spans).contains(number)),
    };
    if index.is_none() {
        let piers = match spans {
            0 | 1 => String::new(),
            2 => ", \"pier 1\"".to_owned(),
            _ => format!(", \"pier 1\" to \"pier {}\"", spans - 1),
        };
        findings.error(
            "B404",
            raw.span().into(),
            format!("the bridge has no support \"{}\"", shorten(text)),
            field.doc,
            format!("write \"left abutment\"{piers} or \"right abutment\""),
        );
    }
    index
}

/// Whether the bridge says what the chosen analysis needs.
pub(super) fn check(
    file: &Table<'_>,
    plan: &Plan,
    loads: &[Load],
    joints: [Option<&Joint>; 3],
    masonry: Option<&Masonry>,
    findings: &mut Findings,
) {
    let mut unheard = Findings::default();
    let place = |section: &str, key: &str, unheard: &mut Findings| {
        file.table(section, unheard).map_or(file.range, |table| table.place(key))
    };
    // A file that plans a passage or a sweep of vehicles, and no collapse, needs no load; `collapse` asks for one where it
    // is told to run.
    let plans_more = file.has("passage") || file.has("sweep");
    let needs_load = plan.analysis == Analysis::Load && (file.has("analysis") || !plans_more);
    if needs_load && loads.is_empty() && !file.has("load") {
        let range = place("analysis", "analysis", &mut unheard);
        findings.error(
            "B402",
            range,
            "there is no load to bring the bridge to collapse",
            "this analysis raises a load",
            "describe one with [[load]], or choose analysis = \"thickness\" or \"support-movement\"",
        );
    }
    if plan.analysis == Analysis::SupportMovement && plan.support_movement.is_none() && !file.has("support_movement") {
        let range = place("analysis", "analysis", &mut unheard);
        findings.error(
            "B402",
            range,
            "no support movement is described",
            "this analysis moves a support",
            "describe it with [support_movement]",
        );
    }
    // [ring_joint] and [wall_joint] only where they are written; elsewhere they are [joint] over again.
    for (section, joint) in ["joint", "ring_joint", "wall_joint"].into_iter().zip(joints) {
        let Some(joint) = joint.filter(|_| file.has(section)) else { continue };
        if let Some(masonry) = masonry {
            series(file, section, joint, masonry, findings);
        }
        if plan.method != Method::Limit {
            stiffness(file, section, joint, findings);
        }
    }
    if plan.method == Method::Dem {
        steps(file, plan, findings);
    }
    let finer = [
        ("resolution", plan.resolution, "load_step", plan.load_step),
        ("load_step", plan.load_step, "load_limit", plan.load_limit),
    ];
    for (small, lesser, large, greater) in finer {
        if let (Some(lesser), Some(greater)) = (lesser, greater)
            && lesser > greater
        {
            let range = place("analysis", small, &mut unheard);
            findings.error(
                "B405",
                range,
                format!("`{small}` is more than `{large}`"),
                format!("`{large}` is {} kN/m", greater / 1e3),
                format!("give a smaller `{small}` or a larger `{large}`"),
            );
        }
    }
}

/// The series rule needs the moduli of the blocks.
fn series(file: &Table<'_>, section: &str, joint: &Joint, masonry: &Masonry, findings: &mut Findings) {
    let mut unheard = Findings::default();
    let Some(table) = file.table(section, &mut unheard) else { return };
    let normal = matches!(joint.normal_stiffness, Some(JointStiffness::Series(_)));
    let shear = matches!(joint.shear_stiffness, Some(JointStiffness::Series(_)));
    let key = if normal { "mortar_normal_stiffness" } else { "mortar_shear_stiffness" };
    if (normal || shear) && masonry.elastic_modulus.is_none() {
        findings
            .error(
                "B401",
                table.place(key),
                "the series rule needs the modulus of the blocks",
                "stiffness of the mortar joint alone",
                "add a line like elastic_modulus = \"15 GPa\" to [masonry], or give the stiffness of the whole contact",
            )
            .because("1/k = 1/k' + l/E: Rouxinol, Providência and Lemos, eq. 1");
    }
    if shear && masonry.poisson_ratio.is_none() {
        findings
            .error(
                "B401",
                table.place("mortar_shear_stiffness"),
                "the series rule in shear needs Poisson's ratio of the blocks",
                "stiffness of the mortar joint alone",
                "add a line like poisson_ratio = 0.2 to [masonry], or give the stiffness of the whole contact",
            )
            .because("the shear modulus is G = E / (2 (1 + ν))");
    }
}

/// The discrete element method cannot do without a stiffness of its joints.
fn stiffness(file: &Table<'_>, section: &str, joint: &Joint, findings: &mut Findings) {
    if joint.normal_stiffness.is_none() {
        lack(file, section, "the normal stiffness of the joints", "normal_stiffness = \"4.84 GPa/m\"", findings);
    }
    if joint.shear_stiffness.is_none() {
        lack(file, section, "the shear stiffness of the joints", "shear_stiffness = \"0.573 GPa/m\"", findings);
    }
}

/// Nor without the size of its steps.
pub(super) fn steps(file: &Table<'_>, plan: &Plan, findings: &mut Findings) {
    if plan.analysis == Analysis::Load && plan.load_step.is_none() {
        lack(file, "analysis", "a load step", "load_step = \"100 kN\"", findings);
    }
    let still = plan.support_movement.is_some_and(|movement| movement.increment.is_none());
    if plan.analysis == Analysis::SupportMovement && still {
        lack(file, "support_movement", "an increment of the movement", "increment = \"1 mm\"", findings);
    }
}

fn lack(file: &Table<'_>, section: &str, what: &str, line: &str, findings: &mut Findings) {
    let mut unheard = Findings::default();
    let range = file.table(section, &mut unheard).map_or(file.range, |table| table.range);
    findings
        .error(
            "B401",
            range,
            format!("this method needs {what}"),
            "missing here",
            format!("add a line like {line} to [{section}], or choose method = \"limit\""),
        )
        .because("joints deform in this method, load by load; limit analysis takes them as rigid");
}
