//! The answer of a collapse analysis in an engineer's words.

mod assess;
mod passage;
mod plan;
mod records;
mod update;
mod validation;
mod vary;
mod vehicles;

pub(crate) use self::assess::assessment;
pub(crate) use passage::passage;
pub(crate) use plan::plan;
pub(crate) use records::records;
pub(crate) use update::update;
pub(crate) use validation::validation;
pub(crate) use vary::vary;
pub(crate) use vehicles::vehicles;

use crate::page::Page;
use ::outcome::calibration::{CalibrationReport, Measured, Spread};
use ::outcome::collapse::{Collapse, Combination};
use ::outcome::help::Help;
use ::outcome::note;
use ::outcome::picture::{Hinge, HingeAt};
use ::outcome::sweep::Sweep;
use bridge::Analysis;
use findings::words::counted;
use std::fmt::Write;

/// More hinges than this are a table, not a line.
const MOST_HINGES: usize = 10;

/// What was found, what it rests on, where the rest is.
pub(crate) fn collapse(found: &Collapse, out: &str, details: bool) -> Page {
    let mut page = format!("{}: {}\n\n", found.bridge, title(found));
    match found.analysis() {
        Analysis::Load => loads(&mut page, found, details),
        Analysis::Thickness => thickness(&mut page, found),
        Analysis::SupportMovement => movement(&mut page, found),
    }
    mechanism(&mut page, found);
    packing(&mut page, found);
    effort(&mut page, found);
    if let Some(both) = &found.combination {
        combination(&mut page, both);
    }
    let mut assumptions = note::words(&found.assumptions);
    if !assumptions.is_empty() {
        let walls = found.wall_strip.iter().flat_map(|wall| note::words(&wall.assumptions));
        let both = found.combination.iter().flat_map(|both| note::words(&both.assumptions));
        let more: Vec<String> = walls.chain(both).filter(|line| !assumptions.contains(line)).collect();
        assumptions.extend(more);
    }
    Page { body: page, assumptions, place: format!("Results are in {out}") }
}

/// The governing position of a sweep, and a few of the others.
pub(crate) fn sweep(sweep: &Sweep, out: &str) -> Page {
    let methods = if sweep.is_deformable() { "limit analysis and on deformable joints" } else { "limit analysis" };
    let mut page = format!("{} of the loads by {methods}\n\n", counted(sweep.points.len(), "position"));
    if !sweep.whole {
        page += "  interrupted: these are the positions that were answered by then\n";
    }
    let open = sweep.positions_not_converged();
    if open > 0 {
        let _ = writeln!(page, "  positions not converged {open}: nothing is settled");
    }
    match sweep.worst() {
        Some(worst) => {
            let _ = writeln!(
                page,
                "  governing position      {:.3} m from the left springing (first load or axle)",
                worst.position
            );
            if let Some(factor) = worst.load_factor {
                let _ = writeln!(page, "  load factor there       {factor:.4}");
            }
            for with in &sweep.not_counted.with_help {
                if let Some(factor) = with.factor {
                    let _ = writeln!(page, "  with {:<17}  {factor:.4}", Help::all_told(&with.helps));
                }
            }
            if let Some(most) = worst.load_factor_at_most {
                let _ = writeln!(page, "  load factor at most     {most:.4}, which is a bound and no answer");
            }
            let others = [
                ("upper bound there", worst.upper_factor),
                ("rigid blocks", worst.rigid_factor.filter(|_| worst.upper_factor.is_none())),
                ("fill as weight", worst.rigid_factor.filter(|_| worst.upper_factor.is_some())),
                ("deformable joints", worst.deformable_factor),
            ];
            for (name, factor) in others {
                if let Some(factor) = factor {
                    let _ = writeln!(page, "  {name:<22}  {factor:.4}");
                }
            }
            if let Some(load) = worst.collapse_load {
                let _ = writeln!(page, "  last stable load there  {:.2} kN/m", load / 1e3);
            }
        }
        None => page += "  no position makes a mechanism of the bridge\n",
    }
    Page { body: page, assumptions: note::words(&sweep.assumptions), place: format!("Results are in {out}") }
}

/// Moduli of the fill, the stiffness that was found, and its check.
pub(crate) fn calibration(found: &CalibrationReport, out: &str) -> String {
    let mut page = format!(
        "{}: {} of {:.2} m out of {}, {} particles\n\n",
        found.bridge,
        counted(found.squares, "square"),
        found.plan.sample_size,
        found.packings(),
        found.particles
    );
    page += "  multiple   kn [GPa/m]   ks [GPa/m]   tangent [MPa]    secant [MPa]    without the first steps [MPa]\n";
    let spread = |s: Option<Spread>| {
        s.map_or("-".to_owned(), |s| format!("{:.1} ± {:.1}", s.mean / 1e6, s.standard_error / 1e6))
    };
    let line = |page: &mut String, m: &Measured, about: &str| {
        let [normal, shear] = found.stiffness.map(|k| m.multiple * k / 1e9);
        let (tangent, secant, late) = (spread(m.tangent), spread(m.secant), spread(m.late_secant));
        let multiple = m.multiple;
        let _ = writeln!(
            page,
            "  {multiple:>8.3}   {normal:>10.4}   {shear:>10.4}   {tangent:>13}   {secant:>13}   {late:>13}   {about}"
        );
    };
    for row in &found.table {
        line(&mut page, row, "");
    }
    if let Some(row) = found.found_beside_the_table() {
        line(&mut page, row, "found");
    }
    if let Some(check) = &found.check {
        line(&mut page, &check.measured, "check on other packings");
    }
    page += "  (mean and its standard error)\n";
    if let (Some(wanted), Some(row)) = (found.plan.wanted_modulus, &found.found) {
        let [normal, shear] = found.stiffness.map(|k| row.multiple * k / 1e9);
        let _ = write!(
            page,
            "\nFor {:.1} MPa write into [particle_joint]:\n\n  normal_stiffness = \"{normal:.4} GPa/m\"\n  \
             shear_stiffness = \"{shear:.4} GPa/m\"\n",
            wanted / 1e6
        );
    }
    if let Some(sheared) = &found.strength {
        let strength = |s: &::outcome::calibration::Strength| {
            format!(
                "{:.1} ± {:.1} degrees, {:.1} ± {:.1} kPa",
                s.friction_angle.mean.to_degrees(),
                s.friction_angle.standard_error.to_degrees(),
                s.cohesion.mean / 1e3,
                s.cohesion.standard_error / 1e3
            )
        };
        let contact = sheared.found.contact;
        let _ = write!(
            page,
            "\nThe fill has {} with contacts of\n\n  friction_angle = \"{:.1} deg\"\n  cohesion = \"{:.1} kPa\"\n",
            strength(&sheared.found),
            contact.friction_angle.to_degrees(),
            contact.cohesion / 1e3
        );
        if let Some(check) = &sheared.check {
            let _ = writeln!(page, "\nOther packings have {}", strength(check));
        }
    }
    let _ = writeln!(page, "\nResults are in {out}");
    page
}

fn title(found: &Collapse) -> String {
    let method = found.method().name();
    format!("{} by {method}, {}", found.status.word().replace('-', " "), counted(found.blocks, "block"))
}

fn loads(page: &mut String, found: &Collapse, details: bool) {
    if let Some(headline) = found.headline() {
        *page += &strip(found, "carried", headline.load, headline.whole);
        let _ = writeln!(page, "  {:<22}  {}", "", headline.from);
    }
    let both = found.combination.is_some();
    let printed = |load: f64| format!("{:.2}", load / 1e3);
    // One number leads: what repeats it is a detail.
    let led = found.headline().filter(|_| !details && !both).map(|headline| printed(headline.load));
    let mut line = |name: &str, load: Option<f64>| {
        let load = load.filter(|load| led.as_ref().is_none_or(|led| printed(*load) != *led));
        if let Some(load) = load.filter(|_| both) {
            let _ = writeln!(page, "  {name:<22}  {:>9.2} kN/m   of the strip between the walls", load / 1e3);
        } else if let Some(load) = load {
            *page += &strip(found, name, load, load * found.width);
        }
    };
    line("last stable load", found.last_stable_load);
    line("collapse load", found.collapse_load);
    for with in &found.not_counted.with_help {
        line(&format!("with {}", Help::all_told(&with.helps)), with.headline);
    }
    line("stalled at", found.stalled_load);
    line("load step", found.load_step);
    line("limit load, rigid", found.limit_load.filter(|_| found.method().joints_deform()));
    line("limit load, crushing", found.crushing_limit_load);
    line("limit load, bonded", found.bonded_rings_load);
    for limit in found.along().iter().flat_map(|along| &along.permissible) {
        line(limit.criterion.word(), Some(limit.load));
    }
    if let Some(limit) = found.limit() {
        line("lower bound", limit.lower_bound);
        line("upper bound", limit.upper_bound);
        let own = |load: &f64| found.collapse_load != Some(*load);
        line("associated friction", limit.associated_load.filter(own));
        line("without dilation", limit.non_associated_load);
        line("without fill pressure", limit.without_fill_pressure_load.filter(own));
        line("all passive pressure", limit.full_fill_pressure_load);
        if let Some(soil) = &limit.continuum {
            line("half of the strength", soil.range.map(|r| r[0]).filter(|_| soil.shares[0] == 0.5));
            line("all of the strength", soil.range.map(|r| r[1]).filter(|_| soil.mobilised_share < 1.0));
            line("soil that dilates", soil.associated.map(|b| b[0]));
            line("flow by iteration", soil.iterated);
            line("in plane strain", soil.plane_strain);
            let ratio = soil.bound_ratio.map_or("none".to_owned(), |ratio| format!("{ratio:.3}"));
            let _ = writeln!(page, "  {:<22}  {ratio:>9} with {} triangles", "upper over lower", soil.elements);
        }
        let _ = writeln!(page, "  {:<22}  {:>9}", "friction", limit.friction);
    }
    if let Some(along) = found.along() {
        let _ = writeln!(page, "  {:<22}  {:>9}", "ended", along.ended);
    }
    factor(page, found);
    axles(page, found);
    if let Some(stress) = found.max_compressive_stress {
        let _ = writeln!(page, "  {:<22}  {:>9.2} MPa", "largest compression", stress / 1e6);
    }
}

/// A load per metre of width [N/m], and on the whole width [N] where it stands on that: an axle stands on a width of its own, on the whole
/// width nobody asked for a load.
fn strip(found: &Collapse, name: &str, load: f64, whole: f64) -> String {
    let (load, whole) = (load / 1e3, whole / 1e3);
    match found.has_own_widths() {
        true => format!("  {name:<22}  {load:>9.2} kN/m\n"),
        false => format!("  {name:<22}  {load:>9.2} kN/m   {whole:>9.0} kN over {:.2} m\n", found.width),
    }
}

/// How often the loads of the file are carried: what an axle or a convoy is judged by, its width being its own.
fn factor(page: &mut String, found: &Collapse) {
    // Loads of 1 kN/m only say where the load stands: the factor would repeat the collapse load.
    let unit = (found.reference_load - 1e3).abs() < 1e-6;
    if let Some(load) = found.carried().filter(|_| found.reference_load > 0.0 && !unit) {
        let _ = writeln!(
            page,
            "  {:<22}  {:>9.3} times the loads of the file, {:.2} kN/m",
            "load factor",
            load / found.reference_load,
            found.reference_load / 1e3
        );
    }
}

/// The axles of the file as they are carried: what an engineer asks for.
fn axles(page: &mut String, found: &Collapse) {
    let Some(factor) = found.load_factor() else { return };
    for asked in &found.asked {
        let each = |factor: f64| {
            let list: Vec<String> = asked.axles.iter().map(|axle| format!("{:.0}", factor * axle / 1e3)).collect();
            list.join(", ")
        };
        let _ = writeln!(
            page,
            "  {:<22}  {:>9} kN   {factor:.3} times {} kN of \"{}\", each on {:.2} m",
            if asked.axles.len() == 1 { "axle carried" } else { "axles carried" },
            each(factor),
            each(1.0),
            asked.name,
            asked.effective_width
        );
    }
}

/// Both strips and their sum.
fn combination(page: &mut String, both: &Combination) {
    let load = |load: Option<f64>, digits| load.map_or("-".to_owned(), |load| format!("{:.digits$}", load / 1e3));
    page.push_str("\n  strip   width [m]   carried [kN/m]   carried [kN]   last stable [kN/m]   collapse [kN/m]\n");
    for part in &both.components {
        let whole = part.headline.map(|load| load * part.width);
        let _ = writeln!(
            page,
            "  {:<6}  {:>9.2}   {:>14}   {:>12}   {:>18}   {:>15}   {}",
            part.strip,
            part.width,
            load(part.headline, 2),
            load(whole, 0),
            load(part.last_stable_load, 2),
            load(part.collapse_load, 2),
            part.status.word().replace('-', " ")
        );
    }
    let width: f64 = both.components.iter().map(|part| part.width).sum();
    let mean = |sum: Option<f64>| load(sum.map(|load| load / width), 2);
    let _ = writeln!(
        page,
        "  {:<6}  {width:>9.2}   {:>14}   {:>12}   {:>18}   {:>15}",
        "both",
        mean(both.headline),
        load(both.headline, 0),
        mean(both.last_stable_load),
        mean(both.collapse_load)
    );
}

fn thickness(page: &mut String, found: &Collapse) {
    let Some(least) = found.thickness() else { return };
    let _ = writeln!(page, "  least ring thickness    {:>9.4} m at the crown", least.crown_thickness);
    let _ = writeln!(page, "  share of the given one  {:>9.5}", least.factor[1]);
    if let Some(ratio) = least.over_mean_radius {
        let _ = writeln!(page, "  over the mean radius    {ratio:>9.5}");
    }
}

fn movement(page: &mut String, found: &Collapse) {
    let Some(support) = found.support() else { return };
    let mut line = |name: &str, movement: Option<f64>| {
        if let Some(movement) = movement {
            let _ = writeln!(page, "  {name:<22}  {:>9.1} mm", movement * 1e3);
        }
    };
    line("last stable movement", support.last_stable);
    line("movement at collapse", support.collapse);
    line("increment", Some(support.step));
}

fn mechanism(page: &mut String, found: &Collapse) {
    let (ring, wall): (Vec<&Hinge>, Vec<&Hinge>) = found
        .picture
        .hinges
        .iter()
        .partition(|hinge| hinge.edge != HingeAt::Other || found.picture.hinges.len() <= MOST_HINGES);
    let count = ring.len();
    if count > MOST_HINGES {
        let _ = writeln!(page, "  {:<22}  {count}, see hinges.csv", "hinges");
    } else if count > 0 {
        let places: Vec<String> = ring.into_iter().map(|one| hinge(found, one)).collect();
        let _ = writeln!(page, "  {:<22}  {count} at x [m] = {}", "hinges", places.join(", "));
    }
    if !wall.is_empty() {
        let _ = writeln!(page, "  {:<22}  {} more outside the ring, see hinges.csv", "", wall.len());
    }
    if !found.picture.sliding.is_empty() {
        let _ = writeln!(page, "  {:<22}  {}", "sliding joints", found.picture.sliding.len());
    }
}

/// Where a hinge is: with its edge in a ring, between which blocks elsewhere.
fn hinge(found: &Collapse, hinge: &Hinge) -> String {
    let edge = match hinge.edge {
        HingeAt::Intrados | HingeAt::Extrados => hinge.edge.word().to_owned(),
        HingeAt::Other => match found.sides(hinge) {
            Some([first, second]) => format!("between {first} and {second}"),
            None => format!("y = {:.2} m", hinge.point[1]),
        },
    };
    // Adding zero takes the sign off a negative zero.
    format!("{:.2} ({edge})", (100.0 * hinge.point[0]).round() / 100.0 + 0.0)
}

fn packing(page: &mut String, found: &Collapse) {
    let Some(p) = &found.packing else { return };
    let [least, most] = p.diameters;
    let _ = writeln!(page, "  {:<22}  {} of {least:.3} to {most:.3} m across", "particles", p.grains.len());
    let origin = p.seed.map_or("read from a file".to_owned(), |seed| format!("seed {seed}"));
    let _ = writeln!(
        page,
        "  {:<22}  solid fraction {:.3}, {:.2} contacts a particle, mean stress {:.1} kPa, settled {:.1} mm, {origin}",
        "packing at rest",
        p.solid_fraction,
        p.coordination,
        p.mean_stress / 1e3,
        1e3 * p.settlement
    );
}

fn effort(page: &mut String, found: &Collapse) {
    if let Some(dem) = found.dem() {
        let _ = writeln!(
            page,
            "  {:<22}  {} of {:.2e} s (critical {:.2e} s), damping {}, tolerance {:.0e}",
            "iterations", dem.iterations_total, dem.time_step, dem.critical_time_step, dem.damping, found.tolerance
        );
        if let Some((block, step)) = &dem.broken_at {
            let _ = writeln!(page, "  {:<22}  {block}, iteration {step}", "broke off at");
        }
    }
}
