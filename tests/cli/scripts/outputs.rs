//! Files written by commands: whole or not at all, wherever they are.

use crate::common::program::{Folder, size_of};
use std::fs;
use std::process::Stdio;

#[test]
fn a_target_that_cannot_be_written_is_a_failure_and_leaves_nothing() {
    let folder = Folder::new("target");
    fs::create_dir_all(folder.0.join("d.png")).expect("a folder");
    folder.fails(
        &["render", "sphere", "-o", "no/such/a.png", "--size", "8x8"],
        1,
        &[&format!(
            "no/such/a.png: {}",
            english!("document-target-no-folder")
        )],
    );
    folder.fails(
        &["render", "sphere", "-o", "d.png", "--size", "8x8"],
        1,
        &[&format!("d.png: {}", english!("document-target-directory"))],
    );
    assert_eq!(folder.names(), ["d.png"]);
    if cfg!(target_os = "linux") {
        // No file can be made there, not even by the superuser.
        let output = folder.run(&["render", "sphere", "-o", "/proc/a.png", "--size", "8x8"]);
        assert_eq!(output.status.code(), Some(1));
        assert!(String::from_utf8_lossy(&output.stderr).contains("/proc/a.png: "));
        assert_eq!(
            folder
                .run(&["render", "sphere", "-o", "/dev/full", "--size", "8x8"])
                .status
                .code(),
            Some(1)
        );
        assert_eq!(
            folder
                .run(&["render", "sphere", "-o", "/dev/null", "--size", "8x8"])
                .status
                .code(),
            Some(0)
        );
    }
}

#[test]
fn an_output_that_nobody_reads_is_no_failure() {
    let folder = Folder::new("pipe");
    folder.ends_quietly(&["probe", "sphere", "--pixel", "384,384", "--json"]);
}

/// Checks output files that are the standard output; with a closed pipe the program ends quietly.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_is_the_output_is_written_to_it() {
    let folder = Folder::new("stdout");
    let explain = [
        "explain",
        "cube",
        "--frames",
        "1",
        "--size",
        "8x8",
        "--csv",
        "/dev/stdout",
    ];
    assert!(
        folder
            .prints(&explain)
            .starts_with("stage,name,per,evaluations,omitted,note\n")
    );
    let render = ["render", "cube", "--size", "8x8", "-o", "/dev/stdout"];
    assert!(folder.run(&render).stdout.starts_with(b"\x89PNG"));
    for arguments in [&explain[..], &render] {
        folder.ends_quietly(arguments);
    }
    // Output redirected to a file keeps its contents and its position.
    folder.write("log", "before\n");
    let log = fs::OpenOptions::new()
        .append(true)
        .open(folder.0.join("log"))
        .expect("a file");
    assert!(
        folder
            .command(&explain)
            .stdout(log)
            .status()
            .expect("an end")
            .success()
    );
    let text = fs::read_to_string(folder.0.join("log")).expect("a text");
    assert!(text.starts_with("before\nstage,name"), "{text}");
    assert_eq!(folder.names(), ["log"]);
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_write_leaves_nothing() {
    let folder = Folder::new("interrupted");
    // A shell starts background jobs with this signal ignored, and then the program ignores it, too.
    let ignored = |signal: &str| signal == "INT" && ignored_signals() & 0b10 != 0;
    for signal in ["INT", "TERM", "KILL"]
        .into_iter()
        .filter(|signal| !ignored(signal))
    {
        // Compression takes long enough to be interrupted.
        let render = ["render", "checker", "--size", "700x700", "-o", "a.png"];
        let mut child = folder
            .command(&render)
            .stderr(Stdio::null())
            .spawn()
            .expect("the program");
        let writes = |pid: u32| {
            let open = fs::read_dir(format!("/proc/{pid}/fd"))
                .into_iter()
                .flatten()
                .flatten();
            open.filter_map(|entry| fs::read_link(entry.path()).ok())
                .any(|file| file.starts_with(&folder.0))
        };
        while !writes(child.id()) {
            assert!(
                child.try_wait().expect("its state").is_none(),
                "it ended before it wrote"
            );
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        // The shell's own: a bare system has no program of that name.
        let kill = std::process::Command::new("sh")
            .args(["-c", &format!("kill -s {signal} {}", child.id())])
            .status();
        assert!(kill.expect("kill").success() && !child.wait().expect("an end").success());
        assert!(folder.names().is_empty(), "{signal}: {:?}", folder.names());
    }
}

/// Returns the signals that this process ignores, one bit each.
#[cfg(target_os = "linux")]
fn ignored_signals() -> u64 {
    let status = fs::read_to_string("/proc/self/status").expect("a status");
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    u64::from_str_radix(mask.expect("a mask").trim(), 16).expect("a number")
}

#[cfg(target_os = "linux")]
#[test]
fn files_keep_their_mode_links_lead_on_and_any_name_will_do() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::new("names");
    let render = |target: &OsStr| {
        let output = folder
            .command(&["render", "cube", "--size", "8x8", "-o"])
            .arg(target)
            .output();
        let output = output.expect("the program");
        assert_eq!(
            (
                output.status.code(),
                String::from_utf8_lossy(&output.stderr).as_ref()
            ),
            (Some(0), "")
        );
    };
    folder.write("secret.png", "");
    fs::set_permissions(
        folder.0.join("secret.png"),
        PermissionsExt::from_mode(0o600),
    )
    .expect("a mode");
    render(OsStr::new("secret.png"));
    let mode = fs::metadata(folder.0.join("secret.png"))
        .expect("a file")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o600);
    fs::create_dir(folder.0.join("elsewhere")).expect("a folder");
    symlink("elsewhere/real.png", folder.0.join("link.png")).expect("a link");
    render(OsStr::new("link.png"));
    assert!(
        fs::symlink_metadata(folder.0.join("link.png"))
            .expect("a link")
            .is_symlink()
    );
    assert_eq!(size_of(&folder.0.join("elsewhere/real.png")), (8, 8));
    let long = format!("{}.png", "a".repeat(240));
    render(OsStr::new(&long));
    let latin = OsStr::from_bytes(b"caf\xe9.png");
    render(latin);
    // Written files are read again, by commands that read and by those that write tables.
    for arguments in [
        &["check"][..],
        &["profile", "--from", "0,4", "--to", "8,4", "-o"],
    ] {
        let target: &OsStr = if arguments.len() > 1 {
            OsStr::from_bytes(b"\xe9.csv")
        } else {
            latin
        };
        let output = folder
            .command(arguments)
            .arg(target)
            .output()
            .expect("the program");
        assert_eq!(
            output.status.code(),
            Some(0),
            "{arguments:?}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
    assert!(folder.0.join(OsStr::from_bytes(b"\xe9.csv")).is_file());
}

/// Limits the memory that the system grants to the process.
#[cfg(target_os = "linux")]
#[test]
fn a_picture_that_memory_is_too_short_for_is_a_failure() {
    let folder = Folder::new("memory");
    let limited = format!(
        "ulimit -v 800000; exec {} \"$@\"",
        env!("CARGO_BIN_EXE_shading-lab")
    );
    let render = |more: &[&str]| {
        let mut command = std::process::Command::new("sh");
        command
            .current_dir(&folder.0)
            .env_remove("LANGUAGE")
            .env("LC_ALL", "C")
            .args(["-c", &limited, "sh", "render", "cube", "-o", "a.png"])
            .args(more);
        command.output().expect("a shell")
    };
    let output = render(&["--size", "16384x8192", "--samples", "2"]);
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let large = english!(
        "render-too-large",
        width = 16384,
        height = 8192,
        megabytes = 1488
    );
    assert!(
        text.starts_with(&english!("cli-error", message = large)),
        "{text}"
    );
    assert_eq!((output.status.code(), folder.names().len()), (Some(1), 0));
    assert_eq!(
        render(&["--size", "64x64", "--samples", "2"]).status.code(),
        Some(0)
    );
}

/// Hides `/proc`, which some containers lack and by which a file without a name is given one.
#[cfg(target_os = "linux")]
#[test]
fn a_file_is_replaced_whole_without_proc_as_well() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new("without-proc");
    let within = |script: &str| {
        let script = format!("umount -l /proc && {script}");
        let mut command = std::process::Command::new("unshare");
        command.current_dir(&folder.0).env("LC_ALL", "C").args([
            "-m",
            "sh",
            "-c",
            &script,
            env!("CARGO_BIN_EXE_shading-lab"),
        ]);
        command.output().ok()
    };
    if !within("true").is_some_and(|output| output.status.success()) {
        eprintln!("skipped: /proc cannot be taken away here, which needs root and unshare");
        return;
    }
    folder.write("a.png", "old");
    fs::set_permissions(folder.0.join("a.png"), PermissionsExt::from_mode(0o640)).expect("a mode");
    let output = within("exec \"$0\" render cube --size 8x8 -o a.png").expect("unshare");
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!((output.status.code(), errors.as_str()), (Some(0), ""));
    assert_eq!(size_of(&folder.0.join("a.png")), (8, 8));
    let mode = fs::metadata(folder.0.join("a.png"))
        .expect("a file")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o640);
    assert_eq!(folder.names(), ["a.png"]);
    // A write that cannot finish leaves the old file, and nothing beside it.
    let before = fs::read(folder.0.join("a.png")).expect("a picture");
    let short = "trap '' XFSZ; ulimit -f 1; exec \"$0\" render cube --size 300x300 -o a.png";
    let output = within(short).expect("unshare");
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(fs::read(folder.0.join("a.png")).expect("a picture"), before);
    assert_eq!(folder.names(), ["a.png"]);
}

/// Limits file sizes so that only the first of the two files fits.
#[cfg(unix)]
#[test]
fn of_a_pair_of_shaders_both_are_written_or_none() {
    let folder = Folder::new("pair");
    let write = |blocks: u32| {
        let script = format!(
            "trap '' XFSZ; ulimit -f {blocks}; exec {} code spotlight --target glsl -o pair",
            env!("CARGO_BIN_EXE_shading-lab")
        );
        let mut command = std::process::Command::new("sh");
        let output = command
            .current_dir(&folder.0)
            .env("LC_ALL", "C")
            .args(["-c", &script])
            .output();
        output.expect("a shell").status.code()
    };
    assert_eq!(write(100), Some(0));
    let size = |name| fs::metadata(folder.0.join(name)).expect("a file").len();
    // In blocks of 512 bytes.
    let (first, second) = (size("pair.vert"), size("pair.frag"));
    let between = (first + second) / 1024;
    assert!(first < 512 * between && 512 * between < second);
    for name in ["pair.vert", "pair.frag"] {
        fs::remove_file(folder.0.join(name)).expect("a file");
    }
    assert_eq!(write(between as u32), Some(1));
    assert_eq!(folder.names(), [""; 0]);
}
