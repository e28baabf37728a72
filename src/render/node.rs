//! Nodes of the frame: the stored outputs of its steps, each with the key of its inputs, and the memory they take.

use std::any::Any;

/// The last output of a step. Its key is a tuple of all that the step reads; the stamp stands for the outputs of other nodes.
#[derive(Default)]
pub struct Node<T> {
    key: Option<Box<dyn Any + Send + Sync>>,
    /// The number of runs.
    pub stamp: u64,
    pub output: T,
}

impl<T> Node<T> {
    /// Runs the step if its key differs from the last one; returns whether it ran.
    pub fn update<K: PartialEq + Any + Send + Sync>(
        &mut self,
        key: K,
        run: impl FnOnce(&mut T),
    ) -> bool {
        let outdated = self.outdate(key);
        if outdated {
            run(&mut self.output);
        }
        outdated
    }

    /// Stores a key. Returns whether it differs from the last one: then the caller makes the output anew.
    pub fn outdate<K: PartialEq + Any + Send + Sync>(&mut self, key: K) -> bool {
        let outdated = self.key.as_ref().and_then(|last| last.downcast_ref()) != Some(&key);
        if outdated {
            self.stamp += 1;
            self.key = Some(Box::new(key));
        }
        outdated
    }

    /// Makes the next update run, whatever its key.
    pub fn forget(&mut self) {
        self.key = None;
    }

    /// Makes the next update run, whatever its key, and frees the memory of the output.
    pub fn release(&mut self)
    where
        T: Default,
    {
        self.forget();
        self.output = T::default();
    }
}

/// The memory that a renderer holds between frames, in bytes, each buffer under the quantity it grows with.
///
/// The buffers' capacity counts, used or not. Data of bounded size does not (a scene, a plan, a curved surface's patches, a
/// list for each of the picture's bands of rows, and a band's depths for each thread).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Memory {
    /// Positions and normals of the vertices, their positions in the picture, and the values that they carry to the pixels.
    pub vertices: u64,
    /// The polygons and their corners, lists of the visible ones, and boxes about them where rays are followed.
    pub triangles: u64,
    /// The picture, the values carried to each pixel, and the visible triangles.
    pub pixels: u64,
}

impl Memory {
    /// Returns the sum, bytes.
    pub fn total(self) -> u64 {
        self.vertices + self.triangles + self.pixels
    }
}

/// Returns the capacity of a buffer, bytes.
pub fn capacity<T>(buffer: &Vec<T>) -> u64 {
    (buffer.capacity() * size_of::<T>()) as u64
}

/// Returns the capacity of planes, bytes.
pub fn capacity_of_planes<T>(planes: &[Vec<T>; 3]) -> u64 {
    planes.iter().map(capacity).sum()
}
