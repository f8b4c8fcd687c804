//! The analysis plan, and whether the bridge says enough for it. Numerical settings have defaults; what belongs to the bridge has none.

use crate::card::{Field, Kind, Section};
use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::model::{
    Analysis, ContactLength, ContactPoints, Damping, Friction, Joint, JointContact, JointStiffness, Load, Masonry,
    Method, Plan, StiffnessAsked, Strip, SupportMovement,
};
use crate::quantity::Dimension::AngleRate;
use crate::tree::{Table, shorten, wrong_type};
use crate::values::read;
use toml::de::DeValue;

choice! {
    /// Rule of the numerical damping.
    enum DampingRule {
        /// each motion is opposed by a share of its out-of-balance force
        Local = "local",
        /// global, proportional to mass and velocity
        Viscous = "viscous",
        /// global viscous, with an intensity that follows the motion
        Adaptive = "adaptive",
    }
}

pub(super) static ANALYSIS: Section = Section {
    path: "analysis",
    doc: "What to analyse, and how exactly. Without `load_step` the discrete element method chooses one, and says which (A112).",
    fields: &[
        word::<Method>("method", "method for the collapse load", "dem").default(Method::Limit.word()),
        word::<Analysis>("analysis", "what is increased or reduced until collapse", "load")
            .default(Analysis::Load.word()),
        word::<Strip>("strip", "strip of the bridge's width that is analysed", "both").default(Strip::Fill.word()),
        line_load("load_step", "load increment, per metre of width or over the whole width", "100 kN")
            .at_least(1.0)
            .optional("needed by method \"dem\" for a load"),
        line_load("load_limit", "largest load tried, per metre of width or over the whole width", "20 MN")
            .positive()
            .optional("until collapse"),
        line_load("resolution", "collapse is refined to this resolution below the increment", "1 kN/m")
            .at_least(1.0)
            .optional("as coarse as the increment"),
        number("tolerance", "out-of-balance force at rest over the acting forces", "1e-5")
            .positive_up_to(0.1)
            .default("1e-5"),
        count("step_limit", "most iterations in one load step", "2000000").between(1.0, 1e12).default("2000000"),
        word::<DampingRule>("damping", "numerical damping", "local").default(DampingRule::Local.word()),
        number("damping_share", "share of the out-of-balance force, or of critical damping", "0.8")
            .positive_up_to(1.0)
            .only("damping", &["local", "viscous"])
            .default("0.8"),
        word::<ContactLength>("contact_length", "length of joint that a contact point represents", "fixed")
            .default(ContactLength::Fixed.word()),
        number("time_step_factor", "share of the critical time step", "0.8").positive_up_to(1.0).default("0.8"),
        word::<Friction>("friction", "friction rule of limit analysis", "automatic")
            .default(Friction::Automatic.word()),
        word::<ContactPoints>(
            "contact_points",
            "position of the contact points of a joint in limit analysis",
            "rounded",
        )
        .default(ContactPoints::Rounded.word()),
        count("seed", "seed of whatever is random", "1").between(0.0, 9e15).default("1"),
    ],
};

pub(super) static SUPPORT_MOVEMENT: Section = Section {
    path: "support_movement",
    doc: "A movement of one support: for each metre of the movement s it goes s times `horizontal` to the right, s times \
          `vertical` up, and turns by s times `rotation`.",
    fields: &[
        Field::new("support", Kind::Support, "which support moves", "right abutment"),
        number("horizontal", "direction to the right, per unit of movement", "1.0")
            .between(-1e3, 1e3)
            .optional("no horizontal part"),
        number("vertical", "direction up, per unit of movement", "-0.5")
            .between(-1e3, 1e3)
            .optional("no vertical part"),
        Field::new(
            "rotation",
            Kind::Quantity(AngleRate),
            "rotation counter-clockwise, per metre of movement",
            "0.5 deg/m",
        )
        .between(-1e3, 1e3)
        .optional("no rotation"),
        length(
            "before",
            "movement s that has already happened, as measured: loads then act on the bridge in the shape to which it has moved",
            "40 mm",
        )
        .positive()
        .optional("the bridge stands as it was built"),
        length("increment", "increment of the movement", "1 mm").positive().optional("needed by method \"dem\""),
        length("limit", "largest movement tried", "500 mm").positive().optional("until collapse"),
    ],
};

pub(crate) fn plan(
    file: &Table<'_>,
    width: Option<f64>,
    spans: Option<usize>,
    findings: &mut Findings,
) -> Option<Plan> {
    // A block model file knows no supports of a bridge.
    let movement = match file.section.field("support_movement") {
        Some(_) => file.optional("support_movement", findings, |t, f| support_movement(t, spans, f)),
        None => Some(None),
    };
    let contact = contact(file, findings);
    file.part("analysis", findings, |table, findings| {
        let strip = strip(file, table, findings);
        let damping = table.read("damping", findings);
        let damping_share: Option<f64> = table.read("damping_share", findings);
        let mut load = |key| table.line_load(key, width, findings);
        let (load_step, load_limit, resolution) = (load("load_step"), load("load_limit"), load("resolution"));
        read!(
            table,
            findings,
            Plan {
                method,
                analysis,
                tolerance,
                step_limit,
                contact_length,
                time_step_factor,
                friction,
                contact_points,
                seed;
                strip: strip?,
                contact: contact?,
                load_step: load_step?,
                load_limit: load_limit?,
                resolution: resolution?,
                damping: match damping? {
                    DampingRule::Local => Damping::Local(damping_share?),
                    DampingRule::Viscous => Damping::Viscous(damping_share?),
                    DampingRule::Adaptive => Damping::Adaptive,
                },
                support_movement: movement?,
            }
        )
    })
}

/// What `[joint]` says of where joints press; block models say it on the command alone.
fn contact(file: &Table<'_>, findings: &mut Findings) -> Option<Option<JointContact>> {
    let one = |kind| matches!(kind, Kind::Table(section) if section.field("contact").is_some());
    if !file.section.field("joint").is_some_and(|field| one(field.kind)) {
        return Some(None);
    }
    // What else is wrong with the table is reported where it is read.
    let of = |joint: &Table<'_>, _: &mut Findings| joint.read("contact", findings);
    file.optional("joint", &mut Findings::default(), of).map(Option::flatten)
}

/// Which strip: the word of the plan. Walls add strength in their plane only where somebody asks for it.
fn strip(file: &Table<'_>, table: &Table<'_>, findings: &mut Findings) -> Option<Strip> {
    let analysis: Option<Analysis> = table.read("analysis", &mut Findings::default());
    let strip = table.read("strip", findings)?;
    if strip != Strip::Fill && !file.has("spandrel_wall") {
        findings.error(
            "B406",
            table.place("strip"),
            "there is no spandrel wall to analyse",
            "this strip has a wall on its rings",
            "describe it with [spandrel_wall], or write strip = \"fill\"",
        );
    }
    if strip == Strip::Both && analysis.is_some_and(|analysis| analysis != Analysis::Load) {
        findings.error(
            "B406",
            table.place("strip"),
            "only collapse loads of the two strips can be added up",
            "a thickness or a movement belongs to one strip",
            "write strip = \"fill\" or strip = \"wall\"",
        );
    }
    Some(strip)
}

fn support_movement(table: &Table<'_>, spans: Option<usize>, findings: &mut Findings) -> Option<SupportMovement> {
    let support = support(table, spans, findings);
    let mut part = |key| table.read::<Option<f64>>(key, findings);
    let (horizontal, vertical, rotation) = (part("horizontal"), part("vertical"), part("rotation"));
    let movement = read!(
        table,
        findings,
        SupportMovement {
            before,
            increment,
            limit;
            support: support.unwrap_or(0),
            horizontal: horizontal?.unwrap_or(0.0),
            vertical: vertical?.unwrap_or(0.0),
            rotation: rotation?.unwrap_or(0.0),
        }
    )?;
    if [movement.horizontal, movement.vertical, movement.rotation] == [0.0; 3] {
        findings.error(
            "B403",
            table.range,
            "the support does not move",
            "no direction",
            "give `horizontal`, `vertical` or `rotation` other than zero, for example horizontal = 1.0",
        );
    }
    if let (Some(increment), Some(limit)) = (movement.increment, movement.limit)
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
    support.map(|_| movement)
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
pub(crate) fn check(
    file: &Table<'_>,
    plan: &Plan,
    loads: &[Load],
    joints: [Option<&Joint>; 3],
    masonry: Option<&Masonry>,
    findings: &mut Findings,
) {
    // What a file is for that has no load: a passage, or vehicles that are moved. `collapse` asks for a load where it is told to raise one.
    let plans_more = file.has("passage") || file.has("sweep");
    if plan.analysis == Analysis::Load && !plans_more && loads.is_empty() && !file.has("load") {
        findings.error(
            "B402",
            file.place_in("analysis", "analysis"),
            "there is no load to bring the bridge to collapse",
            "this analysis raises a load",
            "describe one with [[load]], name vehicles in [sweep], or choose analysis = \"thickness\" or \"support-movement\"",
        );
    }
    if plan.analysis == Analysis::SupportMovement && plan.support_movement.is_none() && !file.has("support_movement") {
        findings.error(
            "B402",
            file.place_in("analysis", "analysis"),
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
        match plan.method.stiffness() {
            StiffnessAsked::None => {}
            StiffnessAsked::OrModulus if masonry.is_some_and(|m| m.elastic_modulus.is_some()) => {}
            StiffnessAsked::OrModulus | StiffnessAsked::Given => stiffness(file, section, joint, findings),
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
            findings.error(
                "B405",
                file.place_in("analysis", small),
                format!("`{small}` is more than `{large}`"),
                format!("`{large}` is {} kN/m", greater / 1e3),
                format!("give a smaller `{small}` or a larger `{large}`"),
            );
        }
    }
}

/// The series rule needs the moduli of the blocks.
fn series(file: &Table<'_>, section: &str, joint: &Joint, masonry: &Masonry, findings: &mut Findings) {
    let Some(table) = file.known(section) else { return };
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
pub(crate) fn steps(file: &Table<'_>, plan: &Plan, findings: &mut Findings) {
    if plan.analysis == Analysis::Load && plan.load_step.is_none() {
        lack(file, "analysis", "a load step", "load_step = \"100 kN\"", findings);
    }
    let still = plan.support_movement.is_some_and(|movement| movement.increment.is_none());
    if plan.analysis == Analysis::SupportMovement && still {
        lack(file, "support_movement", "an increment of the movement", "increment = \"1 mm\"", findings);
    }
}

fn lack(file: &Table<'_>, section: &str, what: &str, line: &str, findings: &mut Findings) {
    let range = file.known(section).map_or(file.range, |table| table.range);
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
