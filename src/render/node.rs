//! A node of the frame: a step's last output, kept together with the key of what it read.

/// The output of a step, and the key of what it was made from.
pub struct Node<K, T> {
    key: Option<K>,
    /// Counts the runs: steps that read this output have the stamp in their key.
    stamp: u64,
    pub output: T,
}

impl<K, T: Default> Default for Node<K, T> {
    fn default() -> Self {
        Self { key: None, stamp: 0, output: T::default() }
    }
}

impl<K: PartialEq, T> Node<K, T> {
    /// Runs the step if its key differs from the last one; tells whether it ran.
    pub fn update(&mut self, key: K, run: impl FnOnce(&mut T)) -> bool {
        let outdated = self.outdate(key);
        if outdated {
            run(&mut self.output);
        }
        outdated
    }

    /// Takes over a key. Tells whether it differs from the last one: then the caller makes the output anew.
    pub fn outdate(&mut self, key: K) -> bool {
        let key = Some(key);
        let outdated = self.key != key;
        self.stamp += u64::from(outdated);
        self.key = key;
        outdated
    }
}

impl<K, T> Node<K, T> {
    /// Which run the output is of.
    pub fn stamp(&self) -> u64 {
        self.stamp
    }

    /// The next update runs, whatever its key.
    pub fn forget(&mut self) {
        self.key = None;
    }
}
