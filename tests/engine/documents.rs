//! Files written whole or not at all, and the path of a model in a scene file.

use shading_lab::document::{SaveError, ending, load_bytes, load_scene, save_scene, write_whole};
use shading_lab::scene::Scene;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::{fs, io, process};

/// A test's own folder, removed when dropped.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("shading-lab-save-{}-{name}", process::id()));
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    fn names(&self) -> Vec<OsString> {
        let entries = fs::read_dir(&self.0).expect("a folder");
        entries
            .map(|entry| entry.expect("an entry").file_name())
            .collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_file_is_replaced_whole() {
    let folder = Folder::new("whole");
    let target = folder.0.join("a.txt");
    for text in ["longer at first", "then short"] {
        write_whole(&target, |out| out.write_all(text.as_bytes())).expect("written");
        assert_eq!(fs::read_to_string(&target).expect("a text"), text);
    }
    assert_eq!(folder.names(), ["a.txt"]);
}

#[test]
fn content_that_fails_leaves_the_old_file_and_nothing_else() {
    let folder = Folder::new("fails");
    let target = folder.0.join("a.txt");
    fs::write(&target, "old").expect("a file");
    let error = write_whole(&target, |out| {
        out.write_all(&[b'x'; 100_000])?;
        Err(io::Error::other("no more"))
    });
    assert!(matches!(error, Err(SaveError::Unwritable { .. })));
    assert_eq!(fs::read_to_string(&target).expect("a text"), "old");
    assert_eq!(folder.names(), ["a.txt"]);
}

#[test]
fn targets_that_cannot_be_written_are_refused() {
    let folder = Folder::new("refused");
    for target in [
        folder.0.clone(),
        folder.0.join("no/such/a.txt"),
        PathBuf::from(""),
        PathBuf::from("/"),
    ] {
        let error = write_whole(&target, |_| {
            unreachable!("nothing is written to {}", target.display())
        });
        assert!(matches!(error, Err(SaveError::Target { .. })), "{error:?}");
    }
    assert!(folder.names().is_empty());
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_a_device_is_not_replaced() {
    let folder = Folder::new("links");
    let (target, link) = (folder.0.join("a.txt"), folder.0.join("link.txt"));
    fs::write(&target, "old").expect("a file");
    std::os::unix::fs::symlink(&target, &link).expect("a link");
    write_whole(&link, |out| out.write_all(b"new")).expect("written");
    assert_eq!(fs::read_to_string(&target).expect("a text"), "new");
    assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
    fs::remove_file(&target).expect("a file");
    write_whole(&link, |out| out.write_all(b"anew")).expect("written");
    assert_eq!(
        fs::read_to_string(&target).expect("a text"),
        "anew",
        "a link may lead to what is not there yet"
    );
    assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
    let round = folder.0.join("round.txt");
    std::os::unix::fs::symlink("round.txt", &round).expect("a link");
    let error = write_whole(&round, |_| unreachable!("a link to itself leads nowhere"));
    assert!(
        matches!(error, Err(SaveError::Unwritable { .. })),
        "{error:?}"
    );
    write_whole(Path::new("/dev/null"), |out| out.write_all(b"x")).expect("swallowed");
    assert!(!fs::metadata("/dev/null").expect("a device").is_file());
}

#[test]
fn a_model_beside_the_scene_is_written_relative_and_another_absolute() {
    let folder = Folder::new("relative");
    let target = folder.0.join("s.toml");
    for (model, expected) in [
        (folder.0.join("models/a.obj"), PathBuf::from("models/a.obj")),
        (
            std::env::temp_dir().join("b.obj"),
            std::env::temp_dir().join("b.obj"),
        ),
    ] {
        let mut scene = Scene::default();
        scene.object.path = Some(model);
        save_scene(&target, &scene).expect("written");
        let text = fs::read_to_string(&target).expect("a text");
        assert_eq!(
            Scene::parse(&text, "").expect("sound").object.path,
            Some(expected)
        );
    }
}

#[test]
fn a_file_is_named_by_its_end() {
    for (path, expected) in [
        ("x.toml", Some("toml")),
        ("/a.b/x.OBJ", Some("obj")),
        ("x.toml/.", None),
        ("x.toml/", None),
        ("x.toml/./", None),
        ("x.toml\\.", None),
        ("x.toml.", Some("")),
        ("x.toml ", Some("toml ")),
        ("x.toml::$DATA", Some("toml::$data")),
        (".toml", None),
        ("toml", None),
        ("", None),
    ] {
        assert_eq!(ending(Path::new(path)).as_deref(), expected, "{path}");
    }
}

#[test]
fn a_path_in_a_file_stays_on_this_machine() {
    let refused = |path: &str| {
        let scene = format!("[object]\nkind = \"obj\"\npath = '{path}'\n");
        let error = load_bytes("scene.toml", scene.into(), &[] as &[&str], &mut |_, _| {});
        let error = error.expect_err("no such file").to_string();
        error.contains(english!("document-elsewhere"))
    };
    for path in [
        "a.obj",
        "../a/b.obj",
        "/home/ada/a.obj",
        "C:\\Users\\ada\\a.obj",
        "console.obj",
        "com/x.obj",
        "compass.obj",
        "com10.obj",
    ] {
        assert!(!refused(path), "{path}");
    }
    for path in [
        "\\\\host\\share\\a.obj",
        "//host/share/a.obj",
        "\\/host/a.obj",
        "/\\host\\a.obj",
        "\\\\?\\C:\\a.obj",
        "\\\\?\\UNC\\host\\share\\a.obj",
        "\\\\.\\COM1",
        "\\??\\C:\\a.obj",
        "nul",
        "NUL.obj",
        "a\\con.obj",
        "C:/x/aux .obj",
        "CONIN$",
        "Com1.obj",
        "lpt9:",
        "com².obj",
    ] {
        assert!(refused(path), "{path}");
    }
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3 4\n";

/// Returns what is said about the model in a folder, and the number of its materials.
fn read_model(path: &Path) -> (Vec<String>, usize) {
    let loaded = load_scene(path).expect("the model is drawn in any case");
    let model = loaded.model.as_ref().expect("a model");
    (loaded.warnings(), model.materials.len())
}

#[test]
fn a_library_lies_beside_its_model_and_nowhere_else() {
    let folder = Folder::new("libraries");
    let models = folder.0.join("models");
    fs::create_dir_all(models.join("in")).expect("a folder");
    let library = "newmtl red\nKd 1 0 0\nKs spectral a.rfl\nmap_Kd in/wood.png\n";
    for place in ["a.mtl", "models/a.mtl", "models/in/a.mtl", "models/con.mtl"] {
        fs::write(folder.0.join(place), library).expect("a library");
    }
    fs::create_dir_all(models.join("dir.mtl")).expect("a folder");
    let large = fs::File::create(models.join("large.mtl")).expect("a file");
    large.set_len((1 << 22) + 1).expect("a hole");
    let path = models.join("a.obj");
    let read = |name: &str| {
        fs::write(&path, format!("mtllib {name}\n{SQUARE}")).expect("a model");
        read_model(&path)
    };
    let spectral = english!("mtl-spectral", word = "spectral");
    let textures = english!("document-textures", names = "wood.png");
    for name in ["a.mtl", "./a.mtl", ".\\a.mtl", "\"a.mtl\""] {
        let (said, count) = read(name);
        let shown = name.trim_matches('"');
        assert_eq!(
            said,
            [
                format!("{shown}:3: {spectral}"),
                format!("a.obj: {textures}")
            ]
        );
        assert_eq!(count, 1, "{name}");
    }
    let absolute = folder.0.join("a.mtl").display().to_string();
    for name in [
        "../a.mtl",
        "./../a.mtl",
        "..",
        ".",
        "./",
        "in/a.mtl",
        "in\\a.mtl",
        "C:a.mtl",
        "\\\\host\\share\\a.mtl",
        "con.mtl",
        "/dev/zero",
        &absolute,
    ] {
        let (said, count) = read(name);
        let beside = english!("document-library-beside");
        assert_eq!((said.len(), count), (1, 0), "{name}: {said:?}");
        assert!(
            said[0].ends_with(beside) && said[0].starts_with("a.obj:1: "),
            "{said:?}"
        );
    }
    let expected = english!("document-library");
    for (name, problem) in [
        (
            "b.mtl",
            english!("document-no-such-file", expected = expected),
        ),
        (
            "dir.mtl",
            english!("document-directory-not-file", expected = expected),
        ),
        (
            "large.mtl",
            english!("document-library-size", megabytes = 4),
        ),
    ] {
        assert_eq!(read(name), (vec![format!("a.obj:1: {name}: {problem}")], 0));
    }
    // A scene file names the model by another path; its library still lies beside the model.
    fs::write(&path, format!("mtllib a.mtl\n{SQUARE}")).expect("a model");
    let scene = folder.0.join("scene.toml");
    fs::write(&scene, "object = {kind = 'obj', path = 'models/a.obj'}\n").expect("a scene");
    let loaded = load_scene(&scene).expect("a scene");
    assert_eq!(loaded.model.expect("a model").materials.len(), 1);
}

#[test]
fn the_ambient_light_of_a_model_alone_suits_its_materials() {
    let folder = Folder::new("ambient");
    let (path, scene) = (folder.0.join("a.obj"), folder.0.join("a.toml"));
    fs::write(&path, format!("mtllib a.mtl\n{SQUARE}")).expect("a model");
    fs::write(&scene, "object = {kind = 'obj', path = 'a.obj'}\n").expect("a scene");
    let ambient = |path: &Path| load_scene(path).expect("a model").scene.ambient.color.x;
    for (ka, expected) in [(1.0, 0.2), (0.5, 0.4), (0.2, 1.0), (0.05, 1.0), (0.0, 1.0)] {
        fs::write(folder.0.join("a.mtl"), format!("newmtl red\nKa 0 {ka} 0\n")).expect("a library");
        assert!((ambient(&path) - expected).abs() < 1e-12, "{ka}");
        assert_eq!(ambient(&scene), 1.0, "a scene says how strong its light is");
    }
}

#[test]
fn a_change_of_a_material_that_the_model_does_not_have_is_said() {
    let folder = Folder::new("changes");
    fs::write(folder.0.join("a.mtl"), "newmtl red\n").expect("a library");
    fs::write(folder.0.join("a.obj"), format!("mtllib a.mtl\n{SQUARE}")).expect("a model");
    let scene = folder.0.join("a.toml");
    let text = "[object]\nkind = 'obj'\npath = 'a.obj'\n[[object.material]]\nname = 'red'\nkd = 0.5\n\
        [[object.material]]\nname = 'blue'\nkd = 0.5\n";
    fs::write(&scene, text).expect("a scene");
    let expected = format!("a.obj: {}", english!("document-no-material", name = "blue"));
    assert_eq!(read_model(&scene), (vec![expected], 1));
}

#[test]
fn a_few_textures_are_named_and_each_once() {
    let folder = Folder::new("textures");
    let maps: String = (0..9).map(|k| format!("map_Kd {}.png\n", k % 7)).collect();
    fs::write(folder.0.join("a.mtl"), format!("newmtl red\n{maps}")).expect("a library");
    let path = folder.0.join("a.obj");
    fs::write(&path, format!("mtllib a.mtl\n{SQUARE}")).expect("a model");
    let names = "0.png, 1.png, 2.png, 3.png, 4.png, …";
    let expected = format!("a.obj: {}", english!("document-textures", names = names));
    assert_eq!(read_model(&path), (vec![expected], 1));
}
