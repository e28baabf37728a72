//! The program in a shell: standard input and output, help, completions, manual pages, closed pipes.

use crate::common::program::Folder;
use crate::common::value;
use serde_json::Value;
use std::fs;
use std::io::Write as _;
use std::process::{Command, Output, Stdio};

/// Runs the program with `input` on its standard input.
fn fed(folder: &Folder, arguments: &[&str], input: &[u8]) -> Output {
    let mut child = folder
        .command(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program");
    let mut stdin = child.stdin.take().expect("a pipe");
    stdin.write_all(input).expect("a reader");
    drop(stdin);
    child.wait_with_output().expect("an end")
}

#[track_caller]
fn sound(output: Output) -> Vec<u8> {
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!((output.status.code(), errors.as_str()), (Some(0), ""));
    output.stdout
}

#[test]
fn a_dash_is_standard_input_and_output() {
    let folder = Folder::new("dash");
    let scene = b"object.kind = 'cube'\nimage.size = [24, 16]\n";
    folder.write("s.toml", scene);
    folder.prints(&["render", "s.toml", "-o", "a.png"]);
    let drawn = sound(fed(&folder, &["render", "-", "-o", "-"], scene));
    assert_eq!(drawn, fs::read(folder.0.join("a.png")).expect("a picture"));
    // A picture that holds its scene, and a link, are scenes as well.
    let again = ["render", "-", "--set", "material.n=7", "-o", "-"];
    assert!(sound(fed(&folder, &again, &drawn)).starts_with(b"\x89PNG"));
    let link = folder.prints(&["link", "s.toml"]);
    let linked = sound(fed(&folder, &["render", "-", "-o", "-"], link.as_bytes()));
    assert_eq!(linked, drawn);
    let bad = fed(&folder, &["check", "-"], b"version = 1\nmaterial.n = -1\n");
    assert_eq!(
        String::from_utf8_lossy(&bad.stderr),
        english!(
            "cli-error",
            message = value("<stdin>:2: `material.n`", "-1", "0 to inf")
        ) + "\n"
    );
    assert_eq!(bad.status.code(), Some(2));
    let lesson = fs::read(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/assets/lessons/en/ambient.md"
    ));
    let lesson = lesson.expect("a lesson");
    let words = sound(fed(&folder, &["lesson", "-", "--json"], &lesson));
    let words: Value = serde_json::from_slice(&words).expect("JSON");
    assert_eq!(words["name"], "ambient");
    let nobody = fed(&folder, &["collect", "-", "--json"], &drawn);
    let answer: Value = serde_json::from_slice(&nobody.stdout).expect("JSON");
    assert_eq!(answer["unreadable"][0]["file"], "<stdin>");
    // Tables, code and drawings.
    let size = ["--size", "8x8", "--frames", "1"];
    let csv = folder.prints(&[&["explain", "cube", "--csv", "-"], &size[..]].concat());
    assert!(csv.starts_with("stage,name,"), "{csv}");
    let code = folder.run(&["code", "cube", "-o", "-"]).stdout;
    assert!(String::from_utf8_lossy(&code).contains("glLight"));
    let qr = folder.run(&["link", "cube", "-o", "-"]).stdout;
    assert!(qr.starts_with(b"\x89PNG"));
    let table = folder.prints(&["normals", "cube", "--size", "16x16", "-o", "-"]);
    assert!(
        table.lines().next().is_some_and(|line| line.contains(',')),
        "{table}"
    );
    assert_eq!(folder.names(), ["a.png", "s.toml"]);
}

#[test]
fn a_misspelt_command_is_answered_with_the_right_one() {
    let folder = Folder::new("misspelt");
    let answer = &english!(
        "cli-no-command",
        name = "rendr",
        meant = english!("document-did-you-mean", name = "render")
    );
    for arguments in [
        &["rendr", "sphere"][..],
        &["rendr"],
        &["rendr", "sphere", "-o", "a.png"],
        &["--set", "material.n=3", "rendr", "sphere"],
        &["help", "rendr"],
        &["manual", "rendr"],
    ] {
        folder.fails(arguments, 2, &[answer]);
    }
    folder.fails(
        &["zzz", "sphere"],
        2,
        &[&english!("cli-no-command", name = "zzz", meant = "")],
    );
    // A scene is not a misspelt command, and neither is a misspelt scene.
    folder.refuses(&["sphere", "torus"], "'torus'");
    folder.refuses(&["sphere", "--pixel", "1,1"], "'--pixel'");
    folder.refuses(
        &["check", "spere"],
        &english!("document-did-you-mean", name = "sphere"),
    );
}

#[test]
fn help_of_a_command_is_what_its_option_prints() {
    let folder = Folder::new("help");
    let help = folder.prints(&["help", "render"]);
    assert_eq!(help, folder.prints(&["render", "--help"]));
    assert!(
        help.contains("\nExample") && help.contains("\nOutput:\n"),
        "{help}"
    );
    assert_eq!(folder.prints(&["help"]), folder.prints(&["--help"]));
    let chinese = folder.prints(&["help", "render", "--language", "zh-Hant"]);
    assert!(chinese.contains("\n範例：\n"), "{chinese}");
}

/// Returns whether a program is installed; prints a message if it is not.
fn is_there(name: &str) -> bool {
    let there = Command::new(name).arg("--version").output().is_ok();
    if !there {
        eprintln!("skipped: no {name}");
    }
    there
}

#[test]
fn completions_are_sound_scripts() {
    let folder = Folder::new("completions");
    for (shell, run, check) in [
        ("bash", "bash", "-n"),
        ("zsh", "zsh", "-n"),
        ("fish", "fish", "--no-execute"),
    ] {
        let script = folder.prints(&["completions", shell]);
        assert!(
            script.contains("scanline") && script.contains("viewing-distance"),
            "{shell}"
        );
        folder.write("script", &script);
        if is_there(run) {
            let checked = Command::new(run)
                .arg(check)
                .arg(folder.0.join("script"))
                .output();
            let checked = checked.expect("a shell");
            assert!(
                checked.status.success() && checked.stderr.is_empty(),
                "{}",
                String::from_utf8_lossy(&checked.stderr)
            );
        }
    }
    let script = folder.prints(&["completions", "powershell"]);
    assert!(script.contains("Register-ArgumentCompleter"), "{script}");
    folder.refuses(&["completions", "tcsh"], "expected bash");
    // What bash offers.
    folder.write("script", folder.prints(&["completions", "bash"]));
    let ask = "source ./script; COMP_WORDS=(shading-lab study sphere --methods gou); COMP_CWORD=4; \
               _shading__lab shading-lab gou --methods; echo \"${COMPREPLY[*]}\"";
    let offered = Command::new("bash")
        .current_dir(&folder.0)
        .args(["-c", ask])
        .output();
    let offered = String::from_utf8(offered.expect("bash").stdout).expect("UTF-8");
    assert_eq!(offered.trim(), "gouraud");
}

#[test]
fn manual_pages_are_sound() {
    let folder = Folder::new("manual");
    let page = folder.prints(&["manual"]);
    assert!(
        page.contains(".SH \"EXAMPLES\"") && page.contains(".SH \"COMMANDS\""),
        "{page}"
    );
    fs::create_dir(folder.0.join("man1")).expect("a folder");
    folder.prints(&["manual", "-o", "man1"]);
    let render = fs::read_to_string(folder.0.join("man1/shading-lab-render.1")).expect("a page");
    assert_eq!(render, folder.prints(&["manual", "render"]));
    let pages = fs::read_dir(folder.0.join("man1"))
        .expect("a folder")
        .count();
    assert!(pages > 20, "{pages}");
    let chinese = folder.prints(&["manual", "render", "--language", "zh-Hant"]);
    assert!(
        chinese.contains(".SH \"名稱\"") && chinese.contains("畫成"),
        "{chinese}"
    );
    if is_there("man") {
        let shown = Command::new("man")
            .args(["--warnings", "-l", "man1/shading-lab-render.1"])
            .env("MANPAGER", "cat")
            .env("MANWIDTH", "80")
            .current_dir(&folder.0)
            .output()
            .expect("man");
        let (text, warnings) = (
            String::from_utf8_lossy(&shown.stdout),
            String::from_utf8_lossy(&shown.stderr),
        );
        assert!(shown.status.success() && warnings.is_empty(), "{warnings}");
        // On systems without manual pages, `man` is a script that says so.
        assert!(
            text.contains(english!("cli-manual-examples")) || text.contains("minimized"),
            "{text}"
        );
    }
    if is_there("mandoc") {
        let lint = Command::new("mandoc")
            .args(["-T", "lint", "-W", "error", "man1/shading-lab-render.1"])
            .current_dir(&folder.0)
            .output()
            .expect("mandoc");
        assert!(
            lint.status.success(),
            "{}",
            String::from_utf8_lossy(&lint.stdout)
        );
    }
}

#[test]
fn a_check_and_code_are_told_to_programs() {
    let folder = Folder::new("json");
    let cube = folder.json(&["check", "cube", "--json"]);
    assert_eq!(
        (&cube["ok"], &cube["object"]),
        (&true.into(), &"cube".into())
    );
    assert_eq!(cube["problems"], serde_json::json!([]));
    folder.write("bad.toml", "version = 1\n[material]\nn = -1\nshine = 2\n");
    let chinese = ["check", "bad.toml", "--json", "--language", "zh-Hant"];
    for arguments in [&chinese[..3], &chinese] {
        let output = folder.run(arguments);
        assert_eq!(output.status.code(), Some(2));
        assert!(!output.stderr.is_empty());
        let bad: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(bad["ok"], false);
        let lines: Vec<_> = bad["problems"].as_array().expect("a list").iter().collect();
        assert_eq!(lines.len(), 2);
        assert_eq!(lines[0]["file"], "bad.toml");
        assert_eq!(lines[0]["line"], 3);
        assert_eq!(lines[0]["key"], "material.n");
        assert_eq!(lines[0]["message"], value("`material.n`", "-1", "0 to inf"));
    }
    let code = folder.json(&["code", "spotlight", "--target", "glsl", "--json"]);
    assert_eq!(code["target"], "glsl");
    assert_eq!(code["parts"][0]["ending"], "vert");
    assert!(
        code["parts"][1]["text"]
            .as_str()
            .is_some_and(|text| text.contains("void main"))
    );
    assert!(code["limits"].is_array());
}

/// Every command that prints.
#[cfg(unix)]
const PRINTS: [&str; 16] = [
    "--help",
    "--version",
    "help render",
    "scenes --json",
    "parameters",
    "completions zsh",
    "manual",
    "check cube",
    "check cube --json",
    "link cube -o -",
    "link cube",
    "lesson",
    "render cube -o - --size 300x300",
    "profile cube --csv /dev/stdout --from 1,8 --to 15,8 --size 400x300",
    "profile cube --csv - --from 1,8 --to 15,8 --size 400x300",
    "normals cube --size 16x16",
];

/// Prints into a pipe that nobody reads.
#[cfg(unix)]
#[test]
fn a_closed_pipe_ends_quietly() {
    let folder = Folder::new("closed");
    for arguments in PRINTS {
        let arguments: Vec<_> = arguments.split(' ').collect();
        folder.ends_quietly(&arguments);
    }
}

/// Prints to a full device.
#[cfg(target_os = "linux")]
#[test]
fn an_output_that_does_not_fit_is_a_failure() {
    let folder = Folder::new("full");
    for arguments in PRINTS {
        let arguments: Vec<_> = arguments.split(' ').collect();
        let full = fs::OpenOptions::new().write(true).open("/dev/full");
        let output = folder
            .command(&arguments)
            .stdout(full.expect("a device"))
            .stderr(Stdio::piped())
            .output()
            .expect("the program");
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {errors}");
        assert!(errors.contains("No space left"), "{arguments:?}: {errors}");
    }
}

/// Writes a lesson, a model and a scene whose words would turn letters red, rename the window, ring, and write from right to
/// left.
#[cfg(unix)]
fn write_hostile(folder: &Folder) {
    let acts = "\u{1b}[31m\u{1b}]0;x\u{7}\u{9b}31m\u{7f}\u{202e}";
    let quoted = "\\u001b[31m\\u001b]0;x\\u0007\\u009b31m\\u007f\\u202e";
    folder.write(
        "a.md",
        format!(
            "+++\nlesson = 1\nname = \"a\"\ntitle = \"{quoted}\"\nabout = \"{quoted}\"\n+++\n\n## {acts}\n\n{acts}\n\n\
             ```step\nscene = \"sphere\"\nset = [\"image.size=[9,9]\"]\n```\n\n```question\nkind = \"choice\"\nask = \"{quoted}\"\n\
             why = \"{quoted}\"\n[[option]]\ntext = \"{quoted}\"\nright = true\n[[option]]\ntext = \"b\"\nright = false\n```\n"
        ),
    );
    folder.write(
        "key.md",
        format!("+++\nlesson = 1\nname = \"a\"\ntitle = \"a\"\n\"{quoted}\" = 1\n+++\n"),
    );
    folder.write(
        "scene.md",
        format!("+++\nlesson = 1\nname = \"a\"\ntitle = \"a\"\n+++\n\n## a\n\n```step\nscene = \"{quoted}\"\n```\n"),
    );
    folder.write(
        "a.obj",
        format!("v 0 0 0\nv 1 0 0\nv 0 1 {}\n", "\u{1b}[31m\u{9b}31m"),
    );
    folder.write(
        "a.toml",
        format!("\"{quoted}\" = 1\nlight = [{{name = \"{quoted}\"}}]\nobject = {{kind = 'obj', path = \"{quoted}.obj\"}}\n"),
    );
    folder.write(
        "path.toml",
        format!("object = {{kind = 'obj', path = \"{quoted}.obj\"}}\n"),
    );
    folder.write(
        "name.toml",
        format!("compare.view = 'panes'\nimage.size = [9, 9]\n[[compare.pane]]\nname = \"{quoted}\"\nset = ['material.n=2']\n"),
    );
    folder.write(&format!("{acts}.txt"), "");
}

#[cfg(unix)]
#[test]
fn nothing_of_others_acts_on_the_terminal() {
    let folder = Folder::new("escapes");
    write_hostile(&folder);
    let acts = "\u{1b}[31m\u{1b}]0;x\u{7}\u{9b}31m\u{202e}";
    let with = |name: &str| format!("{acts}{name}");
    let (toml, png, txt) = (with("a.toml"), with("/a.png"), with(".txt"));
    let set = format!("{acts}=1");
    let all: Vec<Vec<&str>> = vec![
        vec!["lesson", "a.md"],
        vec!["lesson", "a.md", "--json"],
        vec!["check", "a.md", "--json"],
        vec!["check", "key.md"],
        vec!["check", "key.md", "--json"],
        vec!["check", "scene.md"],
        vec!["check", "a.obj"],
        vec!["check", "a.toml"],
        vec!["check", "a.toml", "--json"],
        vec!["check", "path.toml"],
        vec!["compare", "name.toml"],
        vec!["compare", "name.toml", "--json"],
        vec!["check", &toml],
        vec!["check", &txt],
        vec!["collect", &png],
        vec!["collect", &png, "--json"],
        vec!["render", "cube", "-o", &png],
        vec!["render", "cube", "-o", "a.png", "--size", acts],
        vec!["render", "cube", acts],
        vec!["check", acts],
        vec![acts],
        vec![acts, "cube"],
        vec!["help", acts],
        vec!["lesson", acts],
        vec!["check", "cube", "--set", &set],
        vec!["link", "cube", "--url", acts],
    ];
    for arguments in all {
        let output = folder.run(&arguments);
        let text = [output.stdout, output.stderr].concat();
        let text = String::from_utf8(text).expect("UTF-8");
        let act = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
        assert!(!text.is_empty(), "{arguments:?}");
        assert!(!text.contains(act), "{arguments:?}: {text:?}");
    }
    let shown = folder.prints(&["lesson", "a.md"]);
    assert!(shown.starts_with("\\u{1b}[31m\\u{1b}]0;x\\u{7}"), "{shown}");
    // In JSON the text is unchanged.
    let title = &folder.json(&["lesson", "a.md", "--json"])["title"];
    assert_eq!(title, "\u{1b}[31m\u{1b}]0;x\u{7}\u{9b}31m\u{7f}\u{202e}");
}

#[test]
fn what_others_wrote_is_repeated_in_short() {
    let folder = Folder::new("excerpts");
    let long = "x".repeat(3000);
    let key = format!("material.{long}=1");
    folder.write("a.obj", format!("v {long} 0 0\n"));
    folder.write("a.toml", format!("{long} = 1\n"));
    folder.write("b.toml", format!("[material]\nn = '{long}'\n"));
    folder.write("key.md", format!("+++\n{long} = 1\n+++\n"));
    let step = |inside: &str| {
        format!(
            "+++\nlesson = 1\nname = \"a\"\ntitle = \"a\"\n+++\n## a\n{inside}\n```step\nscene = \"sphere\"\n```\n"
        )
    };
    folder.write("name.md", step(&format!("{{{{ {long} }}}}")));
    folder.write("part.md", step(&format!("{{{{ scene.{long} }}}}")));
    folder.write("scene.md", step("").replace("sphere", &long));
    let all: [&[&str]; 14] = [
        &["check", "a.obj"],
        &["check", "a.toml"],
        &["check", "b.toml"],
        &["check", "key.md"],
        &["check", "name.md"],
        &["check", "part.md"],
        &["check", "scene.md"],
        &["check", &long],
        &["check", "cube", "--set", &key],
        &["help", &long],
        &["lesson", &long],
        &["render", "cube", "-o", "a.png", "--size", &long],
        &["render", "cube", &long],
        &["check", "cube", &format!("--{long}")],
    ];
    for arguments in all {
        let output = folder.run(arguments);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{text}");
        let longest = text.split(|c| c != 'x').map(str::len).max();
        assert!(
            (20..=200).contains(&longest.unwrap_or(0)),
            "{:?}: {text}",
            arguments[0]
        );
    }
}

#[test]
fn the_standard_input_is_read_as_far_as_a_scene_may_go() {
    let folder = Folder::new("endless");
    let mut child = folder
        .command(&["check", "-"])
        .stdin(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program");
    let mut stdin = child.stdin.take().expect("a pipe");
    let piece = [b'#'; 1 << 16];
    let taken = (0..256).take_while(|_| stdin.write_all(&piece).is_ok());
    // A pipe buffers some of it.
    let taken = taken.count() << 16;
    assert!(taken < 6 << 20, "{taken} bytes were taken");
    drop(stdin);
    let output = child.wait_with_output().expect("an end");
    assert_eq!(
        String::from_utf8_lossy(&output.stderr),
        format!(
            "{}\n",
            english!(
                "cli-error",
                message = format!("<stdin>:1: {}", english!("problem-too-long", limit = 4))
            )
        )
    );
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn the_environment_asks_for_so_many_threads_at_most() {
    let folder = Folder::new("threads");
    let threads = |asked: &str| {
        let bench = [
            "bench", "sphere", "--frames", "1", "--size", "8x8", "--json",
        ];
        let output = folder
            .command(&bench)
            .env("RAYON_NUM_THREADS", asked)
            .output();
        let bench: Value = serde_json::from_slice(&sound(output.expect("an end"))).expect("JSON");
        bench["threads"].as_u64().expect("a number")
    };
    let cores = std::thread::available_parallelism()
        .expect("a number")
        .get() as u64;
    assert_eq!(threads("3"), 3);
    assert_eq!(threads("1000"), cores.max(256));
}

/// Checks that help has colours on a terminal, unless NO_COLOR forbids them, and that a picture is not written to a terminal.
#[cfg(target_os = "linux")]
#[test]
fn a_terminal_has_colours_unless_it_wants_none() {
    let folder = Folder::new("terminal");
    if !is_there("script") {
        return;
    }
    let on_terminal = |command: &str, no_color: Option<&str>| {
        let program = env!("CARGO_BIN_EXE_shading-lab");
        let mut script = Command::new("script");
        script
            .args(["-qec", &format!("{program} {command}"), "/dev/null"])
            .current_dir(&folder.0)
            .env("LC_ALL", "C")
            .env("TERM", "xterm")
            .env_remove("NO_COLOR")
            .stdin(Stdio::null());
        if let Some(value) = no_color {
            script.env("NO_COLOR", value);
        }
        String::from_utf8_lossy(&script.output().expect("script").stdout).into_owned()
    };
    assert!(on_terminal("help render", None).contains("\u{1b}[1m"));
    assert!(on_terminal("--help", None).contains("\u{1b}[1m"));
    for command in ["help render", "--help"] {
        assert!(!on_terminal(command, Some("1")).contains('\u{1b}'));
    }
    let refused = on_terminal("render cube --size 8x8 -o -", None);
    assert!(
        refused.contains(english!("cli-picture-on-terminal")),
        "{refused}"
    );
    // Progress is shown on terminals only, and only for long work.
    let shown = on_terminal("bench sphere --size 800x800 --frames 100", None);
    assert!(shown.contains(english!("cli-working")), "{shown}");
    assert!(folder.names().is_empty());
}
