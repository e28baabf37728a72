//! Screens without a display, by Xvfb.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

/// A process that is killed when dropped.
pub struct Running(pub Child);

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Starts a screen on a free display, with more arguments for the server, and returns it with the display's name.
pub fn screen(more: &[&str]) -> (Running, String) {
    // Without -noreset the server restarts when its last client leaves, and meanwhile refuses new ones.
    let mut server = Command::new("Xvfb")
        .args(["-displayfd", "1", "-screen", "0", "1280x800x24"])
        .args(["-nolisten", "tcp", "-noreset"])
        .args(more)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("Xvfb starts");
    let output = server.stdout.take().expect("its output is piped");
    let server = Running(server);
    // The number comes once the server listens.
    let mut number = String::new();
    BufReader::new(output)
        .read_line(&mut number)
        .expect("the number of the display");
    assert!(!number.trim().is_empty(), "Xvfb found no display");
    (server, format!(":{}", number.trim()))
}
