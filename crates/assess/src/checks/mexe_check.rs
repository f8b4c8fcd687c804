//! MEXE's allowable axle load.

use super::check::{Check, Probe, used};
use super::mexe;
use crate::evidence::Evidence;
use bridge::assess::{Mexe, MexeAxles};
use outcome::checked::{Comparison, NotMade, Unit};

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C301",
    keys: ["mexe", "mexe.axle_load"],
    title: "modified MEXE",
    clause: "modified axle load of the MEXE method",
    text: "The axle load of an empirical method: 740 (d + h)^2 / L^1.3 tonnes, at most 70, with ring thickness \
           d, fill h (no more than d) and span L in metres, times factors for span/rise, profile, material, \
           joints and condition. The factors are in [mexe]; the condition factor is the inspector's judgement \
           and has the largest influence. The result is the load on each axle of a two-axle bogie without \
           lift-off; times the axle factor A_f it is compared with axle_load of [mexe], the required mass on \
           each of `axles`. A_f is 1 for such a bogie and is taken as 1 for a single axle, whose effect is no \
           larger; three axles, and axles that may lift off, need axle_factor from the method's figure (BA \
           16/97, Figures 3/5). Beyond a ratio of span to rise of four the span/rise factor falls along a \
           curve of the method; it is recalled to some 0.03 and ends at eight, and span_rise_factor of [mexe] \
           replaces it. The method is for single spans up to 18 m in fair condition, and says nothing about \
           piers. For short spans it is known to allow too much: never rely on it against a mechanism that \
           limit analysis finds.",
    source: "CS 454 and BA 16/97 of the British highway authorities, after the Military Engineering Experimental Establishment",
    probe: Probe::Itself,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let factors = a.asked.mexe.as_ref().ok_or_else(|| NotMade::because("the file gives no factors: write [mexe]"))?;
    let inputs = mexe::inputs(&a.bridge, factors).ok_or_else(|| NotMade::because("the span has no profile"))?;
    let found = mexe::allowed(&inputs);
    let basis = found.map_or(String::new(), |found| basis(&inputs, &found));
    if let Some(outside) = mexe::outside(&inputs) {
        let regardless =
            found.map(|found| format!(". Extrapolated, it would allow {:.1} t on an axle ({basis})", found.modified));
        return Err(NotMade::because(format!("{outside}{}", regardless.unwrap_or_default())));
    }
    let found =
        found.ok_or_else(|| NotMade::because("the span/rise factor is not known: write span_rise_factor in [mexe]"))?;
    let axle = mexe::axle_factor(factors).ok_or_else(|| {
        NotMade::because(format!(
            "the method allows {:.1} t on each axle of a two-axle bogie without lift-off ({basis}); for {} write \
             axle_factor in [mexe], A_f of BA 16/97, Figures 3/5",
            found.modified,
            axles(factors)
        ))
    })?;
    let allowed = axle * found.modified;
    let asked = factors.axle_load.ok_or_else(|| {
        let what = format!(
            "the method allows {allowed:.1} t on {} ({basis}); write axle_load in [mexe] to compare",
            axles(factors)
        );
        NotMade::because(what)
    })? / 1e3;
    Ok(vec![Comparison {
        load_model: format!("{asked:.1} t on {}", axles(factors)),
        value: asked,
        limit: allowed,
        unit: Unit::Tonne,
        utilisation: used(asked, allowed),
        basis: format!("{basis}; A_f {axle:.2}"),
        ..Comparison::default()
    }])
}

/// The axles that are compared, in words.
fn axles(factors: &Mexe) -> &'static str {
    match (factors.axles, factors.lift_off) {
        (MexeAxles::Single, _) => "a single axle",
        (MexeAxles::Bogie, false) => "each axle of a bogie",
        (MexeAxles::Bogie, true) => "each axle of a bogie that may lift off",
        (MexeAxles::Triple, false) => "each of three axles",
        (MexeAxles::Triple, true) => "each of three axles that may lift off",
    }
}

/// What the load is made of.
fn basis(inputs: &mexe::Inputs, found: &mexe::Allowed) -> String {
    let recalled = match found.recalled {
        true => format!(
            " (span over rise {:.2} on the curve of BA 16/97, Figure 3/3, as recalled to ± {}: confirm it, or write span_rise_factor)",
            inputs.span / inputs.rise,
            mexe::READING
        ),
        false => String::new(),
    };
    format!(
        "provisional {:.2} t; F_sr {:.2}{recalled}, F_p {:.2}, F_m {:.2}, F_j {:.2}, F_cM {:.2}; {:.2} m of fill count",
        found.provisional,
        found.span_rise,
        found.profile,
        found.material,
        found.joint,
        inputs.factors.condition_factor,
        found.fill
    )
}
