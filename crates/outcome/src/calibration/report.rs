//! A report as it grows: what is taken in, and what is said of it.

use super::{At, CalibrationReport, Contact, Measured, Sheared, Spread, Strength, TargetStrength};
use crate::sweep::Ended;
use crate::warning;
use bridge::{Bridge, Modulus};
use findings::words::counted;

impl CalibrationReport {
    /// Nothing found yet.
    pub fn blank(bridge: &Bridge, seeds: &[u64]) -> CalibrationReport {
        let (plan, bridge) = (bridge.calibration.clone(), bridge.name.clone());
        CalibrationReport { bridge, plan, seeds: seeds.to_vec(), ..CalibrationReport::default() }
    }

    /// Takes in what the search for a strength found and whether that is what was wanted; the contacts to go on with, where there are any.
    pub fn sheared(&mut self, wanted: TargetStrength, fitted: Option<(Strength, bool)>) -> Option<Contact> {
        let Some((found, reached)) = fitted else {
            self.verdict = Ended::Undetermined;
            self.warnings.push(warning::Calibration::NothingSheared.into());
            return None;
        };
        if found.left_out > 0 {
            self.warnings.push(warning::Calibration::NotSheared { samples: found.left_out }.into());
        }
        if !reached || !wanted.met_by(&found) {
            self.verdict = Ended::Undetermined;
            self.warnings.push(warning::Calibration::StrengthOutOfReach { found: found.clone() }.into());
        }
        let contact = found.contact;
        self.strength = Some(Sheared { wanted, found, reached, check: None });
        Some(contact)
    }

    /// Takes in the strength of other packings.
    pub fn strength_checked(&mut self, again: Option<Strength>) {
        let Some(sheared) = &mut self.strength else { return };
        let apart = again.as_ref().is_none_or(|again| sheared.reached && !sheared.wanted.checked_by(again));
        sheared.check.clone_from(&again);
        if apart {
            self.verdict = Ended::Undetermined;
            self.warnings.push(warning::Calibration::StrengthApart { again }.into());
        }
    }

    /// Warns of samples that do not count.
    pub fn leave_out(&mut self, measured: &Measured) {
        if measured.left_out > 0 {
            let (samples, of) = (measured.left_out, measured.samples.len());
            let told = warning::Calibration::LeftOut { samples, of, multiple: measured.multiple };
            self.warnings.push(told.into());
        }
    }

    /// What the result speaks of: the multiple that was found, or the stiffness of the file where nothing was looked for.
    pub fn shown(&self) -> Option<&Measured> {
        let of_file = || self.table.iter().find(|m| m.multiple == 1.0).filter(|_| self.plan.wanted_modulus.is_none());
        self.found.as_ref().or_else(of_file)
    }

    /// The modulus of steps of what is shown.
    pub(crate) fn tangent(&self) -> Option<Spread> {
        self.shown()?.tangent
    }

    /// The secant modulus of what is shown.
    pub(crate) fn secant(&self) -> Option<Spread> {
        self.shown()?.secant
    }

    /// The modulus that is compared, on other packings.
    pub(crate) fn checked(&self) -> Option<Spread> {
        self.check.as_ref()?.measured.compared(self.plan.modulus)
    }

    /// Everything that was measured.
    pub(crate) fn measured(&self) -> impl Iterator<Item = &Measured> {
        let checked = self.check.iter().map(|check| &check.measured);
        self.table.iter().chain(self.found_beside_the_table()).chain(checked)
    }

    /// "16 packings", for sentences.
    pub fn packings(&self) -> String {
        counted(self.seeds.len(), "packing")
    }

    /// The multiple that was found, where the table does not have it.
    pub fn found_beside_the_table(&self) -> Option<&Measured> {
        self.found.as_ref().filter(|found| self.table.iter().all(|m| m.multiple != found.multiple))
    }

    /// Standard error of the multiple that was found: that of the modulus over the slope of modulus over multiple between
    /// the two rows of the table around it, in logarithms.
    pub fn multiple_error(&self) -> Option<f64> {
        let found = self.found.as_ref()?;
        let spread = found.compared(self.plan.modulus)?;
        let mut rows: Vec<At> = self.table.iter().filter_map(|m| m.at(self.plan.modulus)).collect();
        rows.sort_by(|a, b| a.multiple.total_cmp(&b.multiple));
        let above = rows.iter().position(|at| at.multiple > found.multiple).unwrap_or(rows.len());
        let above = above.min(rows.len().checked_sub(1)?).max(1);
        let (a, b) = (rows.get(above.checked_sub(1)?)?, rows.get(above)?);
        let slope = (b.modulus / a.modulus).ln() / (b.multiple / a.multiple).ln();
        let error = found.multiple * spread.standard_error / spread.mean / slope;
        (error.is_finite() && error >= 0.0).then_some(error)
    }

    /// Says whether the check bears the search out.
    pub fn judged(&mut self, wanted: f64) {
        match self.checked() {
            None => {
                self.verdict = Ended::Undetermined;
                self.warnings.push(warning::Calibration::NotChecked.into());
            }
            Some(check) if (check.mean / wanted - 1.0).abs() > CHECKED => {
                self.warnings.push(warning::Calibration::Apart { again: check, wanted }.into());
            }
            Some(_) => {}
        }
    }

    /// Says how far stiffness alone reaches.
    pub fn out_of_reach(&mut self, wanted: f64, [low, high]: [At; 2]) {
        self.verdict = Ended::Undetermined;
        self.warnings.push(warning::Calibration::OutOfReach { wanted, ends: [low, high] }.into());
        self.reach = Some([low, high]);
    }
}

/// The check with other packings is to give the wanted modulus within this share: what a modulus of fill is worth knowing
/// to, a tenth of the step between two rows of the published table.
const CHECKED: f64 = 0.05;

impl Measured {
    /// The modulus that is compared, where samples have one.
    fn compared(&self, modulus: Modulus) -> Option<Spread> {
        match modulus {
            Modulus::Tangent => self.tangent,
            Modulus::Secant => self.secant,
        }
    }

    /// The same at its multiple.
    pub fn at(&self, modulus: Modulus) -> Option<At> {
        self.compared(modulus).map(|spread| At { multiple: self.multiple, modulus: spread.mean })
    }
}
