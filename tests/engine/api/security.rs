//! The promises of `docs/security.md`: each names an existing test; those without a test elsewhere are tested here.

use crate::common::program::Folder;
use shading_lab::lesson::{Answer, Answered, Grade, Lesson, Record, hand_in_bytes};
use shading_lab::render::Frame;
use shading_lab::scene::Scene;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use syn::{Attribute, Item};

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Returns the items of the page's list and the rows of its table, each in one line.
fn promises(page: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    let mut open = false;
    let mut heads = true;
    for line in page.lines() {
        let row = line.starts_with("| ") && !heads;
        heads = !line.starts_with('|') || (heads && !line.starts_with("|-"));
        if line.starts_with("- ") || row {
            all.push(line.to_owned());
            open = !row;
        } else if let Some(last) = all.last_mut().filter(|_| open && line.starts_with("  ")) {
            *last += line;
        } else {
            open = false;
        }
    }
    all
}

/// Returns the tests that a promise names: `file: name`.
fn named(promise: &str) -> Vec<(String, String)> {
    let spans = promise.split('`').skip(1).step_by(2);
    let named = spans.filter_map(|span| span.split_once(": "));
    named
        .filter(|(file, _)| file.starts_with("tests/") || file.starts_with("src/"))
        .map(|(file, name)| (file.to_owned(), name.to_owned()))
        .collect()
}

fn is_test(attribute: &Attribute) -> bool {
    attribute.path().is_ident("test")
}

/// Returns whether a file has a test with that name, in a module or at its top level.
fn has_test(items: &[Item], name: &str) -> bool {
    items.iter().any(|item| match item {
        Item::Fn(function) => function.sig.ident == name && function.attrs.iter().any(is_test),
        Item::Mod(module) => {
            let inside = module.content.as_ref();
            inside.is_some_and(|(_, items)| has_test(items, name))
        }
        // Functions inside `proptest!` have their attribute in its tokens.
        Item::Macro(called) => {
            let text = called.mac.tokens.to_string();
            text.contains(&format!("fn {name} ("))
        }
        _ => false,
    })
}

#[test]
fn every_promise_names_its_test() {
    let page = read("docs/security.md");
    let promises = promises(&page);
    assert!(promises.len() >= 15, "{promises:#?}");
    for promise in &promises {
        let tests = named(promise);
        assert!(!tests.is_empty(), "no test is named: {promise}");
        for (file, name) in tests {
            let source = read(&file);
            let there = if file.ends_with(".mjs") {
                source.contains(&format!("test(\"{name}\""))
            } else {
                let parsed = syn::parse_file(&source).expect("Rust");
                has_test(&parsed.items, &name)
            };
            assert!(there, "{file} has no test {name}: {promise}");
        }
    }
    // Missing tests are detected.
    assert!(named("- Nothing is read.").is_empty());
    assert!(!has_test(
        &syn::parse_file("fn a() {}").expect("Rust").items,
        "a"
    ));
}

#[test]
fn the_program_has_no_unsafe_code_and_opens_no_connection() {
    assert!(read("Cargo.toml").contains("\nunsafe_code = \"forbid\"\n"));
    let mut folders = vec![PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("src")];
    let mut files = 0;
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = fs::read_to_string(&path).expect("a text");
            let within = |folder: &str| path.components().any(|part| part.as_os_str() == folder);
            // A live class listens; it calls nobody, and asks only the table of routes for its own address.
            let connecting = [
                "TcpStream::connect",
                "UnixStream",
                "XmlHttpRequest",
                "WebSocket",
                "send_to(",
            ];
            let listening = ["std::net", "TcpStream", "TcpListener", "UdpSocket"];
            let class = within("class") || path.ends_with("src/cli/class.rs");
            let words = connecting.iter().chain(listening.iter().filter(|_| !class));
            for word in words {
                assert!(!text.contains(word), "{}: {word}", path.display());
            }
            files += 1;
        }
    }
    assert!(files > 200);
}

/// Returns the sources that a page's policy allows for a kind of content.
fn allowed<'p>(page: &'p str, directive: &str) -> Option<&'p str> {
    let (_, policy) = page.split_once("<meta http-equiv=\"Content-Security-Policy\" content=\"")?;
    let (policy, _) = policy.split_once('"')?;
    let mut all = policy.split("; ");
    all.find_map(|one| one.strip_prefix(directive)?.strip_prefix(' '))
}

#[test]
fn the_pages_run_no_script_that_is_written_in_them() {
    for (file, script) in [
        ("assets/web/index.html", Some("'self' 'wasm-unsafe-eval'")),
        ("docs/embedding.html", None),
    ] {
        let page = read(file);
        assert_eq!(allowed(&page, "default-src"), Some("'none'"), "{file}");
        assert_eq!(allowed(&page, "script-src"), script, "{file}");
        for directive in ["base-uri", "form-action"] {
            assert_eq!(allowed(&page, directive), Some("'none'"), "{file}");
        }
        for directive in [
            "connect-src",
            "worker-src",
            "img-src",
            "frame-src",
            "manifest-src",
        ] {
            let sources = allowed(&page, directive).unwrap_or("'self'");
            assert_eq!(sources, "'self'", "{file}: {directive}");
        }
        for tag in page
            .split('<')
            .skip(1)
            .filter_map(|rest| rest.split_once('>'))
        {
            let (tag, inside) = tag;
            let script = tag.starts_with("script");
            assert!(
                !script || (tag.contains(" src=\"") && inside.is_empty()),
                "{file}: <{tag}>"
            );
            assert!(
                !tag.contains(" on") && !tag.contains("javascript:"),
                "{file}: <{tag}>"
            );
        }
    }
}

/// Runs a command that must terminate: opening a pipe that nobody writes to would block it.
fn ends(mut command: Command) -> Output {
    let begun = Instant::now();
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program");
    while child.try_wait().expect("its state").is_none() {
        if begun.elapsed() > Duration::from_secs(60) {
            child.kill().expect("its end");
            panic!("it waits for a file that it should not open: {command:?}");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    child.wait_with_output().expect("an end")
}

const LESSON: &str = "+++\nlesson = 1\nname = \"own\"\ntitle = \"![t](pipe)\"\n+++\n\n## A\n\n![p](pipe) <img src=pipe> [l](pipe)\n\n\
    ```step\nscene = \"sphere\"\nset = [\"image.size=[16,16]\"]\n```\n\n\
    ```question\nkind = \"choice\"\nask = \"![p](pipe)\"\n[[option]]\ntext = \"a\"\nright = true\n[[option]]\ntext = \"b\"\nright = false\n```\n";

/// Returns a hand-in with answers to the lesson, whose step shows `scene`.
fn answers(scene: &str) -> Vec<u8> {
    let source = LESSON.replace("\"sphere\"", &format!("\"{scene}\""));
    let lesson = Lesson::read(&source, None).expect("a lesson");
    let mut record = Record::new("own", 1);
    record.put(Answered {
        step: 0,
        prediction: Answer::Choice(0),
        answer: Answer::Choice(0),
        grade: Grade::default(),
        looked_up: 0,
        tries: 1,
        seconds: 1.0,
    });
    let frame = Frame {
        width: 1,
        height: 1,
        pixels: vec![[0; 4]],
    };
    hand_in_bytes(&frame, &Scene::default(), &lesson, &record, "Ada").expect("a picture")
}

#[cfg(unix)]
#[test]
fn a_file_opens_no_other_than_its_row_says() {
    let folder = Folder::new("opens");
    for pipe in ["pipe", "pipe.toml", "pipe.obj"] {
        let made = Command::new("mkfifo").arg(folder.0.join(pipe)).status();
        assert!(made.expect("mkfifo").success());
    }
    folder.write(
        "a.obj",
        "mtllib pipe\nusemtl pipe\nmap_Kd pipe\ncall pipe.obj\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    folder.write(
        "a.toml",
        "about.title = 'pipe'\nobject = {kind = 'obj', path = 'a.obj'}\nimage.size = [8, 8]\n",
    );
    folder.write("a.md", LESSON);
    folder.write("own.png", answers("sphere"));
    for arguments in [
        &["check", "a.obj"][..],
        &["render", "a.toml", "-o", "a.png"],
        &["check", "a.png"],
        &["check", "a.md"],
        &["lesson", "a.md", "-o", "a.html"],
        &["collect", "own.png", "-o", "class.html"],
    ] {
        let output = ends(folder.command(arguments));
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {errors}");
    }
    // A path that would make the command open a file is refused, whether or not the file exists.
    for scene in ["pipe.toml", "a.toml", "/etc/passwd.toml"] {
        folder.write("other.png", answers(scene));
        let output = ends(folder.command(&["collect", "other.png"]));
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{scene}: {errors}");
        assert!(
            errors.contains(english!("class-needs-lesson")),
            "{scene}: {errors}"
        );
    }
    let link = "?scene=sphere&set=object.kind=obj&set=object.path=a.obj";
    let output = ends(folder.command(&["check", link]));
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn what_builds_a_release_is_pinned() {
    for file in ["test", "release"] {
        let workflow = read(&format!(".github/workflows/{file}.yml"));
        let used: Vec<_> = workflow
            .lines()
            .filter_map(|line| line.split_once("uses: "))
            .collect();
        assert!(!used.is_empty());
        for (_, action) in used {
            let (_, commit) = action.split_once('@').expect("a commit");
            let (commit, version) = commit.split_once(" # v").expect("the version as a comment");
            let hexadecimal = commit.chars().all(|c| c.is_ascii_hexdigit());
            assert!(
                hexadecimal && commit.len() == 40 && !version.is_empty(),
                "{action}"
            );
        }
    }
    for script in ["run", "web", "web-test"] {
        let text = read(&format!(".ci/{script}"));
        for line in text.lines() {
            for (tool, exact) in [
                ("cargo install ", "--version "),
                ("pip install ", "=="),
                ("npm install ", "@$version"),
            ] {
                assert!(
                    !line.contains(tool) || line.contains(exact),
                    "{script}: {line}"
                );
            }
            assert!(
                !line.contains("cargo install ")
                    || line.contains("--locked")
                    || text.contains("install --locked || install ||"),
                "{script}: {line}"
            );
        }
    }
}
