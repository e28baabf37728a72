//! A stage keeps its last output together with what it read.

/// The output of a stage, and the inputs that it was made from.
pub(super) struct Kept<K, T> {
    inputs: Option<K>,
    /// Counts the runs: what reads this output reads the stamp as its input.
    stamp: u64,
    pub output: T,
}

impl<K, T: Default> Default for Kept<K, T> {
    fn default() -> Self {
        Self { inputs: None, stamp: 0, output: T::default() }
    }
}

impl<K: PartialEq, T> Kept<K, T> {
    /// Runs the stage if its inputs differ from the last ones; tells whether it ran.
    pub fn update(&mut self, inputs: K, run: impl FnOnce(&K, &mut T)) -> bool {
        let stale = self.inputs.as_ref() != Some(&inputs);
        if stale {
            run(&inputs, &mut self.output);
            self.inputs = Some(inputs);
            self.stamp += 1;
        }
        stale
    }
}

impl<K, T> Kept<K, T> {
    /// Which run the output is of.
    pub fn stamp(&self) -> u64 {
        self.stamp
    }

    /// The next update runs, whatever its inputs.
    pub fn forget(&mut self) {
        self.inputs = None;
    }
}
