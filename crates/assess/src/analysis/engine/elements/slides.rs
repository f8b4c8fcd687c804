//! Whether joints that cannot slide in this method would: the shear of each, held against what friction and cohesion hold.

use mechanics::blocks::BlockModel;
use mechanics::ids::{BlockId, Id};
use outcome::picture::{ContactForce, Snapshot};
use outcome::warning;

/// Shear over resistance up to which a joint holds, but for round-off.
const HOLDS: f64 = 1.0 + 1e-6;

/// What slides in states of growing load, as joints that are held by the method alone; none where every joint holds in all of them.
pub(super) fn sliding(model: &BlockModel, shown: &[Snapshot]) -> Option<warning::Joints> {
    let first = shown.iter().find(|state| used(model, state).any(|(share, _)| share > HOLDS))?;
    let last = shown.last()?;
    let joints = used(model, last).filter(|(share, _)| *share > HOLDS).count();
    let (most, place) = used(model, last).max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(warning::Joints::Held { from: first.load, at: last.load, joints, most, place })
}

/// Of each joint the shear over the resistance, and where it is pressed [m].
fn used<'a>(model: &'a BlockModel, state: &'a Snapshot) -> impl Iterator<Item = (f64, f64)> {
    state.contacts.chunk_by(|a, b| a.blocks == b.blocks).map(|joint| {
        let [first, second] = joint[0].blocks.map(|block| model.blocks[BlockId::new(block)].group);
        let law = model.laws.between(first, second);
        let sum = |of: fn(&ContactForce) -> f64| joint.iter().map(of).sum::<f64>();
        let (compression, pressed) = (sum(|c| c.compression), sum(|c| c.compression / c.stress));
        let place = joint.iter().map(|c| c.compression * c.point[0]).sum::<f64>() / compression;
        let resistance = law.friction * compression + law.cohesion * pressed;
        let share = if law.friction.is_finite() { sum(|c| c.shear).abs() / resistance } else { 0.0 };
        (share, place)
    })
}

#[cfg(test)]
mod tests {
    use crate::analysis::collapse;
    use mechanics::watch::Unwatched;
    use outcome::collapse::{Collapse, Status};
    use outcome::warning;

    /// A ring of rigid stones on joints of mortar with this friction angle [degrees].
    fn found(friction: f64) -> Collapse {
        let text = format!(
            r#"
[bridge]
name = "t"
width = "3.0 m"
[[span]]
profile = "segmental"
span = "6.0 m"
rise = "1.5 m"
thickness = "0.4 m"
voussoirs = 30
[[cover]]
layer = "fill"
thickness = "0.4 m"
density = "1900 kg/m^3"
[masonry]
density = "2200 kg/m^3"
compressive_strength = "unlimited"
elastic_modulus = "1000 GPa"
poisson_ratio = 0.0
[joint]
friction_angle = "{friction} deg"
cohesion = "0 kPa"
normal_stiffness = "10 GPa/m"
shear_stiffness = "4.0 GPa/m"
contact = "distributed"
[dispersal]
rule = "uniform"
slope = "2:1"
[[load]]
kind = "knife-edge"
force = "1 kN/m"
length = "0.3 m"
position = "1.5 m"
[analysis]
method = "fe"
"#
        );
        let bridge = bridge::read(text.as_bytes()).bridge.unwrap();
        collapse(&bridge, None, &mut Unwatched).unwrap()
    }

    #[test]
    fn joints_that_would_slide_are_told_and_the_limit_load_leads() {
        let slippery = found(12.0);
        assert_eq!(slippery.status, Status::Collapsed);
        let told = |code: &str| slippery.warnings.iter().find(|w| w.code() == code).map(|w| w.message());
        let (slides, above) = (told(warning::HELD_AGAINST_SLIDING).unwrap(), told(warning::ABOVE_LIMIT).unwrap());
        assert!(slides.contains("4 do, by up to 1.39 times") && slides.contains("from 54.00 kN/m on"), "{slides}");
        assert!(above.contains("111.57") && above.contains("78.85"), "{above}");
        assert!((slippery.headline().unwrap().load / 78.85e3 - 1.0).abs() < 1e-3);
    }

    #[test]
    fn joints_that_hold_are_not_told() {
        let rough = found(35.0);
        assert!(rough.warnings.iter().all(|w| w.code() != warning::HELD_AGAINST_SLIDING), "{:?}", rough.warnings);
    }
}
