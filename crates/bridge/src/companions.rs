//! What a bridge takes from files beside its own: a packing, a train, readings of a load test, vehicles and rules.

use crate::model::Bridge;

impl Bridge {
    /// Takes over what `known`, the bridge of an earlier text of the same file, was given by files beside it: its packing, the
    /// vehicles of its train, its own vehicles and rules. Each is taken where both texts name the same file. An edited text is
    /// so read without reading these files again. Tells whether a file is named that `known` does not have.
    pub fn take_over(&mut self, known: &Bridge) -> bool {
        let mut whole = true;
        if let Some(particles) = self.particles.as_mut().filter(|particles| particles.file.is_some()) {
            match known.particles.as_ref().filter(|known| known.file == particles.file) {
                Some(known) => particles.grains.clone_from(&known.grains),
                None => whole = false,
            }
        }
        if let Some(train) =
            self.passage.as_mut().map(|passage| &mut passage.train).filter(|train| train.file.is_some())
        {
            match known.passage.as_ref().map(|known| &known.train).filter(|known| known.file == train.file) {
                Some(known) => train.vehicles.clone_from(&known.vehicles),
                None => whole = false,
            }
        }
        if let Some(test) = &mut self.load_test {
            let known = known.load_test.as_ref();
            if let Some(train) = test.train.as_mut().filter(|train| train.file.is_some()) {
                let same = known.and_then(|known| known.train.as_ref()).filter(|known| known.file == train.file);
                match same {
                    Some(known) => train.vehicles.clone_from(&known.vehicles),
                    None => whole = false,
                }
            }
            if test.readings.file.is_some() {
                let same = known.map(|known| &known.readings).filter(|known| known.file == test.readings.file);
                match same {
                    Some(known) => {
                        test.readings.values.clone_from(&known.values);
                        test.readings.synthetic.clone_from(&known.synthetic);
                    }
                    None => whole = false,
                }
            }
        }
        if let Some(sweep) = &mut self.sweep {
            let named = sweep.rule_file.is_some() || !sweep.vehicle_files.is_empty();
            match known.sweep.as_ref() {
                Some(known) if known.rule_file == sweep.rule_file && known.vehicle_files == sweep.vehicle_files => {
                    sweep.texts.clone_from(&known.texts);
                }
                _ => whole &= !named,
            }
        }
        whole
    }
}
