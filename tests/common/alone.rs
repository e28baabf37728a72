//! Tests that need a process of their own.

use std::process::Command;

/// Environment variable with the name of the test that has the process to itself.
const ALONE: &str = "SHADING_LAB_ALONE";

/// Returns whether the test `name` has the process to itself. If not, runs it once more in a process of its own, started as
/// `change` makes it, and asserts that it passes there.
#[track_caller]
pub fn is_alone(name: &str, change: impl FnOnce(&mut Command)) -> bool {
    if std::env::var_os(ALONE).is_some_and(|alone| alone == name) {
        return true;
    }
    let mut command = Command::new(std::env::current_exe().expect("this program"));
    command
        .args(["--exact", name, "--nocapture"])
        .env(ALONE, name);
    change(&mut command);
    let output = command.output().expect("this program");
    let said = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && said.contains("1 passed"),
        "{said}{errors}"
    );
    println!("{said}");
    false
}

/// Limits the address space of the process that `command` starts.
pub fn limit_memory(command: &mut Command, kilobytes: u32) {
    let mut limited = Command::new("sh");
    limited.args(["-c", &format!("ulimit -v {kilobytes} && exec \"$@\""), "sh"]);
    limited.arg(command.get_program()).args(command.get_args());
    for (name, value) in command.get_envs() {
        limited.env(name, value.unwrap_or_default());
    }
    *command = limited;
}
