//! A sweep of vehicles in words.

use crate::page::Page;
use findings::words::counted;
use outcome::help::Help;
use outcome::sweep::Ended;
use outcome::vehicles::{Case, VehicleSweep};
use std::fmt::Write;

/// Every vehicle with its adequacy factor, worst first, and the governing case.
pub(crate) fn vehicles(found: &VehicleSweep, out: &str) -> Page {
    let mut page =
        format!("{}: {} by rule \"{}\"\n\n", found.bridge, counted(found.vehicles.len(), "vehicle"), found.rule.code);
    let mut order: Vec<usize> = (0..found.vehicles.len()).collect();
    let size = |k: &usize| found.vehicles[*k].factor().unwrap_or(f64::INFINITY);
    order.sort_by(|a, b| size(a).total_cmp(&size(b)));
    if found.status() == Ended::Cancelled {
        page += "  interrupted: these are the positions that were answered by then\n\n";
    }
    if let (Some((factor, method)), Some(k)) = (found.headline(), found.governing) {
        let (code, by) = (&found.vehicles[k].code, method.name());
        let _ = writeln!(page, "  {:<22}  {factor:>8.3}  {code} governs, by {by}\n", "adequacy");
    }
    let open = found.positions_not_converged();
    if open > 0 {
        let _ = writeln!(page, "  {:<22}  {open:>8}  nothing is settled\n", "positions unanswered");
    }
    let two = found.vehicles.iter().any(|v| v.deformable.is_some());
    let titles = if two { format!("  {:>8}  {:>8}", "rigid", "gives") } else { String::new() };
    let _ = writeln!(page, "  {:<22}  {:>8}{titles}  first axle at, way, axles on the bridge", "vehicle", "adequacy");
    for k in order {
        let v = &found.vehicles[k];
        let most = || v.adequacy_at_most.map_or(v.status.word().to_owned(), |most| format!("≤ {most:.3}"));
        let factor = v.adequacy.map_or_else(most, |a| format!("{a:.3}"));
        let falls = || v.weights.map_or(String::new(), |weights| format!("does not stand with {}", weights.told()));
        let place = v.case.as_ref().map_or_else(falls, place);
        let open = match v.positions_not_converged {
            0 => String::new(),
            open => format!(", {open} of {} positions not converged", v.envelope.len()),
        };
        let told = |factor: Option<f64>| factor.map_or("-".to_owned(), |factor| format!("{factor:.3}"));
        let both = |gives: Option<f64>| format!("  {:>8}  {:>8}", told(v.rigid), told(gives));
        let both = v.deformable.as_ref().map_or(String::new(), |own| both(own.adequacy));
        let _ = writeln!(page, "  {:<22}  {factor:>8}{both}  {place}{open}", v.code);
    }
    for one in found.grades() {
        let _ = writeln!(page, "\n  {:<22}  {}", one.of, one.told());
        let _ = writeln!(page, "  {}", one.all_told());
    }
    if let Some(v) = found.governing.map(|k| &found.vehicles[k]) {
        let _ = writeln!(page, "\n  governing vehicle        {}", v.title);
        if let Some([lower, upper]) = v.bounds {
            let _ = writeln!(page, "  bounds of its factor     {lower:.6} to {upper:.6}");
        }
        for with in &v.not_counted.with_help {
            if let Some(factor) = with.factor {
                let _ = writeln!(page, "  with {:<18}  {factor:.3}", Help::all_told(&with.helps));
            }
        }
        if let Some(level) = v.without_dilation {
            let _ = writeln!(page, "  without dilation         {level:.4}");
        }
        for limit in v.deformable.iter().flat_map(|own| &own.permissible) {
            let (word, x) = (limit.criterion.word(), limit.position);
            let _ = writeln!(page, "  {word:<23}  {:.3}, first axle at {x:.2} m", limit.adequacy);
        }
        let critical = match v.load_factors[1] {
            1.0 => String::new(),
            more => format!(", {more:.3} times that on the critical one"),
        };
        let _ = writeln!(page, "  factor on its axles      {:.3}{critical}", v.load_factors[0]);
        if let Some(weights) = v.weights.filter(|_| found.weights.len() > 1) {
            let told = weights.told();
            let factors = told.strip_prefix("weights: ").unwrap_or(&told);
            let of = found.weights.len();
            let _ = writeln!(page, "  factors on weights       {factors}: the worst of {of} combinations");
        }
        let _ = writeln!(page, "  effective width          {:.2} m of the barrel carry an axle", v.effective_width);
    }
    if let Some(c) = &found.discrete_elements {
        let words = match (c.adequacy, &c.reason) {
            (Some(a), _) => format!("{a:.3} at the last stable step of {:.3}", c.step),
            (None, Some(reason)) => format!("not made: {reason}"),
            (None, None) => c.status.map_or("not made".to_owned(), |s| s.word().to_owned()),
        };
        let _ = writeln!(page, "  by discrete elements     {words}");
    }
    Page { body: page, assumptions: outcome::note::words(&found.assumptions), place: format!("Results are in {out}") }
}

fn place(c: &Case) -> String {
    let mut words = format!("{:.2} m, {}", c.position, c.direction.word());
    match c.axles {
        Some([a, b]) if a == b => words += &format!(", {}", a + 1),
        Some([a, b]) => words += &format!(", {} to {}", a + 1, b + 1),
        None => {}
    }
    if let Some(k) = c.critical_axle {
        words += &format!(", critical {}", k + 1);
    }
    if let Some([a, b]) = c.uniform {
        words += &format!(", uniform load {a:.2} to {b:.2} m");
    }
    if !c.arrangement.is_empty() {
        words += &format!(", {}", c.arrangement);
    }
    words
}
