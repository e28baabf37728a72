//! A class that is killed at any moment: nothing that was acknowledged is lost, and it goes on.
//!
//! `PROPTEST_CASES=10000 cargo test --test cli class::kill` kills it 40 times as often.

use super::client::Phone;
use super::command::Running;
use crate::common::dice::Dice;
use crate::common::program::Folder;
use crate::common::tries::tries;
use serde_json::json;
use shading_lab::lesson::{Answer, ClassRecord};
use std::collections::BTreeMap;
use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// The phones that answer all the time.
const PHONES: usize = 8;
/// Kills in the gate.
const KILLS: u64 = 6;

/// What a phone was told is saved: the token and the last answer that was acknowledged, and those sent after it.
#[derive(Default)]
struct Acknowledged {
    acknowledged: Option<f64>,
    sent_since: Vec<f64>,
}

/// Answers as fast as it may until it is told to stop or the server is gone.
fn answers(mut phone: Phone, told: &Mutex<Acknowledged>, next: &mut f64, stop: &AtomicBool) {
    while !stop.load(Ordering::Relaxed) {
        *next += 1.0;
        // Numbers from −1 to 1 that never come again.
        let value = (*next / 1e6).min(1.0);
        told.lock().expect("a phone").sent_since.push(value);
        let body =
            json!({ "step": 3, "round": 1, "answer": { "value": value }, "sent": *next as u64 });
        match phone.try_post("answers", &body) {
            Ok(reply) if reply.status == 200 => {
                let mut told = told.lock().expect("a phone");
                told.acknowledged = Some(value);
                told.sent_since.clear();
            }
            Ok(reply) if reply.status == 429 => {}
            Ok(reply) => panic!("{}: {}", reply.status, reply.text()),
            Err(_) => return,
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn nothing_acknowledged_is_lost_however_often_the_class_is_killed() {
    let kills = tries(KILLS);
    let folder = Folder::new("class-kill");
    let mut dice = Dice(7);
    let mut tokens: Vec<Option<String>> = vec![None; PHONES];
    let mut next = [0.0; PHONES];
    let told: Vec<Arc<Mutex<Acknowledged>>> = (0..PHONES).map(|_| Arc::default()).collect();
    for kill in 0..kills {
        let mut class = Running::start(&folder, &[]);
        if kill == 0 {
            for step in 2..=3 {
                class.types("next");
                class.hears("step", |event| event["step"] == step);
            }
        } else {
            // The class is where it was.
            class.hears("step", |event| event["step"] == 3);
        }
        let stop = AtomicBool::new(false);
        std::thread::scope(|scope| {
            for (index, next) in next.iter_mut().enumerate() {
                let mut phone = class.phone();
                phone.token.clone_from(&tokens[index]);
                phone.join(Some(&format!("phone {index}")));
                let same = tokens[index].is_none() || tokens[index] == phone.token;
                let answered = told[index].lock().expect("a phone").acknowledged.is_some();
                assert!(
                    same || !answered,
                    "a student who has answered is known again"
                );
                tokens[index].clone_from(&phone.token);
                let (told, stop) = (&told[index], &stop);
                scope.spawn(move || answers(phone, told, next, stop));
            }
            std::thread::sleep(Duration::from_secs_f64(dice.between(0.0, 0.4)));
            class.kill();
            stop.store(true, Ordering::Relaxed);
        });
        check(&folder, &tokens, &told, kill);
    }
}

/// Compares the record with what the phones were told.
fn check(folder: &Folder, tokens: &[Option<String>], told: &[Arc<Mutex<Acknowledged>>], kill: u64) {
    let bytes = fs::read(folder.0.join("class.jsonl")).expect("a record");
    let record = ClassRecord::read(&bytes).expect("a record");
    let mut known: BTreeMap<&str, f64> = BTreeMap::new();
    for student in &record.students {
        let given = student.answers.get(&(3, 1)).map(|given| &given.answer);
        let Some(Answer::Value(value)) = given else {
            continue;
        };
        let again = known.insert(&student.token, *value);
        assert!(
            again.is_none(),
            "after {kill} kills {} is there twice",
            student.name
        );
    }
    for (token, told) in tokens.iter().zip(told) {
        let told = told.lock().expect("a phone");
        let Some(acknowledged) = told.acknowledged else {
            continue;
        };
        let token = token.as_deref().expect("a token");
        let stored = known.get(token).copied();
        let stored = stored.unwrap_or_else(|| panic!("after {kill} kills an answer is lost"));
        // A later one may have been written without the phone being told.
        let whole = stored == acknowledged || told.sent_since.contains(&stored);
        assert!(
            whole,
            "after {kill} kills: {stored} in place of {acknowledged}"
        );
    }
}
