//! Exhausted memory: every command ends with its result or with a sentence, however little the system grants. Linux only, where a
//! shell can set the limit.
//!
//! `MEMORY_LADDER=1` raises the limit step by step, from 300 MB to 3 GB.

use crate::common::program::Folder;
use std::process::{Command, Stdio};

/// Memory limits, in kilobytes.
const GRANTED: [u32; 2] = [300_000, 1_000_000];
const LADDER: [u32; 6] = [300_000, 500_000, 800_000, 1_200_000, 2_000_000, 3_000_000];

/// Returns a scene with this many segments and rings.
fn scene_of(divisions: u32, more: &str) -> String {
    format!("?scene=teapot&set=object.segments={divisions}&set=object.rings={divisions}{more}")
}

/// The commands, with their arguments after the scene.
const COMMANDS: [&[&str]; 11] = [
    &["render", "-o", "a.png"],
    &["probe", "--pixel", "300,300"],
    &["explain"],
    &["conditions"],
    &["code", "-o", "a.c"],
    &["profile", "--from", "100,300", "--to", "500,300"],
    &["defects"],
    &["normals"],
    &["scanline", "--pixel", "300,300"],
    &["compare", "--pane", "shading.mode=flat"],
    &[
        "animate",
        "--set-from",
        "material.n=1",
        "--set-to",
        "material.n=2",
        "--frames",
        "2",
        "-o",
        "a.gif",
    ],
];

/// Runs the program with `granted` kilobytes of address space; returns whether it produced its result.
fn ends_well(folder: &Folder, granted: u32, arguments: &[&str]) -> bool {
    let program = env!("CARGO_BIN_EXE_shading-lab");
    let output = Command::new("sh")
        .args(["-c", "ulimit -v \"$0\"; exec \"$@\""])
        .arg(granted.to_string())
        .arg(program)
        .args(arguments)
        .current_dir(&folder.0)
        .env("LC_ALL", "C")
        .env_remove("LANGUAGE")
        .stdin(Stdio::null())
        .output()
        .expect("a shell");
    let errors = String::from_utf8_lossy(&output.stderr);
    let what = format!("{granted} kB, {arguments:?}: {errors}");
    match output.status.code() {
        Some(0) => true,
        Some(1) => {
            let sentence = errors.lines().last().unwrap_or_default();
            assert!(sentence.contains("MB"), "{what}");
            false
        }
        _ => panic!("{:?} at {what}", output.status),
    }
}

#[cfg(target_os = "linux")]
#[test]
fn where_memory_cannot_be_had_there_is_a_message() {
    let folder = Folder::new("ladder");
    let all = std::env::var_os("MEMORY_LADDER").is_some();
    let (granted, divisions): (&[u32], &[u32]) = if all {
        (&LADDER, &[64, 256, 512, 1024, 1448, 2048, 2896, 4096])
    } else {
        (&GRANTED, &[64, 1024, 4096])
    };
    let (mut drawn, mut refused) = (0, 0);
    for &granted in granted {
        for &divisions in divisions {
            let commands = if all { &COMMANDS[..] } else { &COMMANDS[..5] };
            for (index, command) in commands.iter().enumerate() {
                // The quick run covers scenes that are refused at once and, of those that are drawn, the quickest.
                if !all && divisions == 1024 && !(granted == 300_000 || index == 1) {
                    continue;
                }
                let scene = scene_of(divisions, "&set=image.size=640,640");
                let arguments = [&command[..1], &[&*scene], &command[1..]].concat();
                match ends_well(&folder, granted, &arguments) {
                    true => drawn += 1,
                    false => refused += 1,
                }
            }
        }
    }
    assert!(drawn > 0 && refused > 0, "{drawn} drawn, {refused} refused");
}
