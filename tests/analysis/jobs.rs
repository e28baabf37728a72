//! Background jobs: their answer, their progress, their end.

use shading_lab::analysis::Watch;
use shading_lab::jobs::{Background, Job, News, Work, nanoseconds};
use std::sync::Arc;
use std::thread;

#[derive(Clone, Copy, PartialEq)]
enum Sum {
    To(u64),
    Panic,
    Endless,
}

impl Work for Sum {
    type Answer = u64;

    fn run(&self, watch: &dyn Watch<u64>) -> Result<u64, String> {
        match self {
            Self::To(0) => Err("nothing to add".to_owned()),
            Self::To(last) => Ok((1..=*last).sum()),
            Self::Panic => std::panic::panic_any("no answer"),
            Self::Endless => {
                while watch.progress(0.25) {
                    watch.found(&3);
                }
                Ok(7)
            }
        }
    }
}

/// Work that reports one answer repeatedly and returns how many references to it are held while nobody reads them.
struct Copies;

impl Work for Copies {
    type Answer = (Arc<()>, usize);

    fn run(&self, watch: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let found = (Arc::new(()), 0);
        for _ in 0..1000 {
            watch.found(&found);
        }
        let places = Arc::strong_count(&found.0);
        Ok((found.0, places))
    }
}

fn outcome<W: Work>(mut slot: Option<Job<W>>) -> Result<W::Answer, String> {
    loop {
        if let Some((_, answer)) = Job::take(&mut slot) {
            assert!(slot.is_none());
            return answer;
        }
        thread::yield_now();
    }
}

#[test]
fn the_clock_does_not_go_back() {
    let first = nanoseconds();
    assert!(nanoseconds() >= first);
}

#[test]
fn an_answer_comes_back_or_why_there_is_none() {
    let ask = |work| outcome(Some(Job::start(work, |_| ())));
    assert_eq!(ask(Sum::To(4)), Ok(10));
    assert_eq!(ask(Sum::To(0)), Err("nothing to add".to_owned()));
    assert!(ask(Sum::Panic).is_err());
}

#[test]
fn a_job_says_how_far_it_is_and_can_be_cancelled() {
    let job = Job::start(Sum::Endless, |_| ());
    while !matches!(job.news(), Some(News::SoFar(3))) {
        thread::yield_now();
    }
    assert_eq!(job.share(), 0.25);
    job.cancel();
    assert_eq!(outcome(Some(job)), Ok(7));
}

#[test]
fn the_latest_question_is_answered_and_a_known_one_not_asked_again() {
    let mut sums = Background::default();
    let mut ask = |last| loop {
        sums.ask(|_| (), |work| *work == Sum::To(last), || Sum::To(last));
        if let Some(answer) = sums.known().filter(|_| sums.progress().is_none()) {
            return answer.clone();
        }
        thread::yield_now();
    };
    assert_eq!((ask(4), ask(5), ask(5)), (Ok(10), Ok(15), Ok(15)));
}

#[test]
fn only_the_latest_of_what_is_known_waits_for_a_reader() {
    let (_, places) = outcome(Some(Job::start(Copies, |_| ()))).expect("an answer");
    assert_eq!(places, 2, "its own, and one that waits");
}
