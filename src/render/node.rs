//! Nodes of the frame: what its steps keep, each with the key of what it was made from, and the memory that takes.

use std::any::Any;

/// The last output of a step. Its key is a tuple of all that the step reads; the stamp stands for the outputs of other nodes.
#[derive(Default)]
pub struct Node<T> {
    key: Option<Box<dyn Any + Send + Sync>>,
    /// Counts the runs.
    pub stamp: u64,
    pub output: T,
}

impl<T> Node<T> {
    /// Runs the step if its key differs from the last one; tells whether it ran.
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

    /// Takes over a key. Tells whether it differs from the last one: then the caller makes the output anew.
    pub fn outdate<K: PartialEq + Any + Send + Sync>(&mut self, key: K) -> bool {
        let outdated = self.key.as_ref().and_then(|last| last.downcast_ref()) != Some(&key);
        if outdated {
            self.stamp += 1;
            self.key = Some(Box::new(key));
        }
        outdated
    }

    /// The next update runs, whatever its key.
    pub fn forget(&mut self) {
        self.key = None;
    }

    /// The same, and the memory of the output is given back.
    pub fn release(&mut self)
    where
        T: Default,
    {
        self.forget();
        self.output = T::default();
    }
}

/// The memory that a renderer holds between frames, bytes, each buffer under what it grows with.
///
/// Counted is the room of the buffers, used or not. What does not grow (a scene, a plan, a curved surface's patches, a list for
/// each of the picture's bands of rows, and a band's depths for each thread) is not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Memory {
    /// Positions and normals of the vertices, their places in the picture, and what they carry to the pixels.
    pub vertices: u64,
    /// The polygons and their corners, lists of those in sight, and boxes about them where rays are followed.
    pub triangles: u64,
    /// The picture, what each pixel was brought, and which triangles are seen.
    pub pixels: u64,
}

impl Memory {
    /// All of it, bytes.
    pub fn total(self) -> u64 {
        self.vertices + self.triangles + self.pixels
    }
}

/// The room of a buffer, bytes.
pub fn room<T>(buffer: &Vec<T>) -> u64 {
    (buffer.capacity() * size_of::<T>()) as u64
}

/// The room of planes, bytes.
pub fn room_of_planes<T>(planes: &[Vec<T>; 3]) -> u64 {
    planes.iter().map(room).sum()
}
