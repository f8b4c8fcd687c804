//! MEXE's allowable axle load.

use super::{Card, Check, Finding, NotMade, mexe, used};
use crate::assessment::Assessment;

/// The check.
pub struct MexeAxle;

impl Check for MexeAxle {
    fn card(&self) -> Card {
        Card {
            code: "C301",
            title: "modified MEXE",
            clause: "modified axle load of the MEXE method",
            text: "A load that experience allows: 740 (d + h)^2 / L^1.3 tonnes, at most 70, with ring thickness d, fill h (no more than d) and span \
                   L in metres, times factors for span/rise, profile, material, joints and condition. The factors stand in [mexe]; the condition factor \
                   is the inspector's judgement, and most of the answer. It is compared with axle_load of [mexe], the mass on a single axle that \
                   must be allowed. Beyond a span of four rises the span/rise factor falls along a curve of the method; it is recalled to some 0.03 and ends at \
                   eight, and span_rise_factor of [mexe] goes before it. The method is for single spans up to 18 m in fair order, and tells nothing of piers. For short spans it is known \
                   to allow too much: never rely on it against a mechanism that limit analysis finds.",
            source: "CS 454 and BA 16/97 of the British highway authorities, after the Military Engineering Experimental Establishment",
        }
    }

    fn run(&self, a: &Assessment) -> Result<Vec<Finding>, NotMade> {
        let factors =
            a.asked.mexe.as_ref().ok_or_else(|| NotMade::because("the file gives no factors: write [mexe]"))?;
        let inputs = mexe::inputs(&a.bridge, factors).ok_or_else(|| NotMade::because("the span has no profile"))?;
        let found = mexe::allowed(&inputs);
        let basis = found.map_or(String::new(), |found| basis(&inputs, &found));
        if let Some(outside) = mexe::outside(&inputs) {
            let regardless = found.map(|found| {
                format!(". Carried on regardless it would allow {:.1} t on an axle ({basis})", found.modified)
            });
            return Err(NotMade::because(format!("{outside}{}", regardless.unwrap_or_default())));
        }
        let found = found
            .ok_or_else(|| NotMade::because("the span/rise factor is not known: write span_rise_factor in [mexe]"))?;
        let asked = factors.axle_load.ok_or_else(|| {
            let what = format!(
                "the method allows {:.1} t on an axle ({basis}); write axle_load in [mexe] to compare",
                found.modified
            );
            NotMade::because(what)
        })? / 1e3;
        Ok(vec![Finding {
            load_model: format!("single axle of {asked:.1} t"),
            value: asked,
            limit: found.modified,
            unit: "t",
            utilisation: used(asked, found.modified),
            basis,
            position: None,
            columns: None,
            strength: false,
        }])
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
