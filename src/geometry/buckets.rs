//! Items sorted into buckets by counting, in linear time.

use std::ops::Range;

/// The items of each bucket, as one list cut into runs.
pub struct Buckets {
    /// The ends of the runs: that of bucket k begins where that of k − 1 ends.
    ends: Vec<u32>,
    list: Vec<u32>,
}

impl Buckets {
    /// Sorts items, each with the bucket to which it belongs, into `count` buckets, keeping their order.
    pub fn new(count: usize, items: impl Iterator<Item = (u32, u32)> + Clone) -> Self {
        let mut ends = vec![0; count];
        items
            .clone()
            .for_each(|(bucket, _)| ends[bucket as usize] += 1);
        let mut begin = 0;
        for end in &mut ends {
            begin += std::mem::replace(end, begin);
        }
        let mut list = vec![0; begin as usize];
        for (bucket, item) in items {
            let slot = &mut ends[bucket as usize];
            list[*slot as usize] = item;
            *slot += 1;
        }
        Self { ends, list }
    }

    fn run(&self, bucket: usize) -> Range<usize> {
        let begin = if bucket == 0 {
            0
        } else {
            self.ends[bucket - 1]
        };
        begin as usize..self.ends[bucket] as usize
    }

    pub fn at(&self, bucket: usize) -> &[u32] {
        &self.list[self.run(bucket)]
    }

    pub fn at_mut(&mut self, bucket: usize) -> &mut [u32] {
        let run = self.run(bucket);
        &mut self.list[run]
    }

    /// Returns each bucket that has items, with these.
    pub fn filled(&self) -> impl Iterator<Item = (usize, &[u32])> {
        let all = (0..self.ends.len()).map(move |bucket| (bucket, self.at(bucket)));
        all.filter(|(_, items)| !items.is_empty())
    }
}
