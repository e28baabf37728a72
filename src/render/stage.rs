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
        self.update_unless(K::eq, inputs, run)
    }
}

impl<K, T> Kept<K, T> {
    /// Runs the stage unless what it made from its last inputs serves for these; tells whether it ran.
    pub fn update_unless(
        &mut self,
        serves: impl FnOnce(&K, &K) -> bool,
        inputs: K,
        run: impl FnOnce(&K, &mut T),
    ) -> bool {
        let stale = !self.inputs.as_ref().is_some_and(|last| serves(last, &inputs));
        if stale {
            run(&inputs, &mut self.output);
            self.inputs = Some(inputs);
            self.stamp += 1;
        }
        stale
    }

    /// Which run the output is of.
    pub fn stamp(&self) -> u64 {
        self.stamp
    }

    /// The next update runs, whatever its inputs.
    pub fn forget(&mut self) {
        self.inputs = None;
    }
}

/// What a picture does with numbers that it can do without, but that make the next ones faster.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Use {
    #[default]
    None,
    /// They are found, and kept.
    Keep,
    /// They are known.
    Take,
}

/// Decides on that: the second picture in a row with the same inputs keeps, and those after it take.
pub(super) struct Repeats<K> {
    of: Option<K>,
    found: bool,
}

impl<K> Default for Repeats<K> {
    fn default() -> Self {
        Self { of: None, found: false }
    }
}

impl<K: PartialEq> Repeats<K> {
    /// What a picture with these inputs, none where nothing can be kept, is to do.
    pub fn next(&mut self, inputs: Option<K>) -> Use {
        let same = inputs.is_some() && self.of == inputs;
        let next = match (same, self.found) {
            (false, _) => Use::None,
            (true, false) => Use::Keep,
            (true, true) => Use::Take,
        };
        (self.of, self.found) = (inputs, same);
        next
    }

    /// Whether anything can be kept at present.
    pub fn is_possible(&self) -> bool {
        self.of.is_some()
    }
}
