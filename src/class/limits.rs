//! The limits of the requests of students.

use std::time::Instant;

/// The most students.
pub const STUDENTS: usize = 1000;
/// The requests of a student, each second.
pub const REQUESTS: f64 = 10.0;
/// New students, each second: 500 phones take three seconds.
pub const JOINS: f64 = 200.0;
/// The largest body of a request, in bytes.
pub const BODY: usize = 64 << 10;
/// The longest name, in characters.
pub const NAME: usize = 40;
/// The most streams of events of one student: tabs, and connections that are dead without knowing it.
pub const STREAMS: u64 = 4;

/// A token bucket: it fills at a rate, and holds the requests of one second.
#[derive(Debug)]
pub struct Bucket {
    rate: f64,
    left: f64,
    last: Instant,
}

impl Bucket {
    /// Creates a full bucket.
    pub fn new(rate: f64, now: Instant) -> Self {
        Self {
            rate,
            left: rate,
            last: now,
        }
    }

    /// Takes a token, if there is one.
    pub fn take(&mut self, now: Instant) -> bool {
        let passed = now.saturating_duration_since(self.last).as_secs_f64();
        self.left = (self.left + passed * self.rate).min(self.rate);
        self.last = now;
        let there = self.left >= 1.0;
        self.left -= f64::from(u8::from(there));
        there
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn a_bucket_gives_its_rate_and_no_more() {
        let start = Instant::now();
        let mut bucket = Bucket::new(10.0, start);
        let taken = |bucket: &mut Bucket, at: f64| bucket.take(start + Duration::from_secs_f64(at));
        assert_eq!((0..30).filter(|_| taken(&mut bucket, 0.0)).count(), 10);
        assert_eq!((0..30).filter(|_| taken(&mut bucket, 0.5)).count(), 5);
        // An hour's pause saves up one second's.
        assert_eq!((0..30).filter(|_| taken(&mut bucket, 3600.0)).count(), 10);
        let steady = (0..1000).filter(|i| taken(&mut bucket, 4000.0 + f64::from(*i) / 100.0));
        assert!((100..=110).contains(&steady.count()));
    }
}
