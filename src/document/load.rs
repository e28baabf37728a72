//! From what the user names to a scene and its model.

use crate::geometry::{Mesh, ObjError, read_obj};
use crate::picture::{PictureError, read_scene_text};
use crate::scene::{About, Object, ObjectKind, Scene, SceneError, nearest, presets};
use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A scene with all that it needs to be drawn.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// Sound, as [`Scene::validate`] has it; a model's path is absolute.
    pub scene: Scene,
    /// The mesh of an object of kind `obj`, fitted where the scene says so.
    pub model: Option<Arc<Mesh>>,
    /// What to call it: the built-in scene's name, or the file's.
    pub name: String,
    /// The file it came from; none for a built-in scene.
    pub path: Option<PathBuf>,
}

/// Is told how many bytes of a model have been read, and how many there are.
pub type Progress<'a> = &'a mut dyn FnMut(u64, u64);

/// Why something could not be opened. Displayed, it names the file, and the line where there is one; several problems
/// take a line each.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// The text of the scene, or an override.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// Neither a file nor a built-in scene.
    #[error("{name}: no built-in scene of that name, expected a .toml, .obj or .png file or a name{}; see `shading-lab scenes`",
        .meant.map(|meant| format!(" (did you mean {meant}?)")).unwrap_or_default())]
    UnknownName { name: String, meant: Option<&'static str> },
    /// A file of another kind.
    #[error("{}: an unknown kind of file, expected .toml, .obj or .png", .path.display())]
    UnknownKind { path: PathBuf },
    #[error("{}: no such file, expected {expected}", .path.display())]
    Missing { path: PathBuf, expected: &'static str },
    /// A directory, or a device.
    #[error("{}: {what}, expected {expected}", .path.display())]
    NotAFile { path: PathBuf, what: &'static str, expected: &'static str },
    #[error("{}: cannot be read ({source}), expected {expected}", .path.display())]
    Unreadable { path: PathBuf, expected: &'static str, source: io::Error },
    /// Bytes that are no UTF-8, at a line counted from 1.
    #[error("{}:{line}: not UTF-8, expected a text", .path.display())]
    NotText { path: PathBuf, line: usize },
    #[error("{}: {source}", .path.display())]
    Picture { path: PathBuf, source: PictureError },
    #[error("{}:{}{source}", .path.display(), .source.line().map(|line| format!("{line}: ")).unwrap_or_else(|| " ".into()))]
    Model { path: PathBuf, source: ObjError },
}

/// Opens a scene: a `.toml` file; a `.obj` model in the default scene, fitted; a `.png` with its scene inside; or a
/// built-in scene by its name, which goes before a file of the same name without such an ending.
///
/// # Errors
/// See [`LoadError`].
pub fn load(source: &Path) -> Result<Loaded, LoadError> {
    load_with(source, &[] as &[&str], &mut |_, _| {})
}

/// [`load`] with overrides as [`Scene::with_overrides`] takes them, applied before the model is read. A model's path in
/// an override is relative to the working directory.
///
/// # Errors
/// See [`LoadError`].
pub fn load_with(source: &Path, overrides: &[impl AsRef<str>], progress: Progress<'_>) -> Result<Loaded, LoadError> {
    let (mut scene, path) = read_scene(source)?;
    if !overrides.is_empty() {
        scene = scene.with_overrides(overrides)?;
    }
    let model = load_model(&scene.object, progress)?;
    // Only now, so that messages name the model as its user does. Where the working directory is unknown, so be it.
    if let Some(model_path) = &mut scene.object.path
        && let Ok(absolute) = std::path::absolute(&*model_path)
    {
        *model_path = absolute;
    }
    let name = match &path {
        Some(path) => path.file_name().unwrap_or(path.as_os_str()),
        None => source.as_os_str(),
    };
    Ok(Loaded { scene, model, name: name.to_string_lossy().into_owned(), path })
}

/// The model of an object: none unless its kind is `obj`.
///
/// # Errors
/// A path that is missing or cannot be read, or a file that is not a sound model.
pub fn load_model(object: &Object, progress: Progress<'_>) -> Result<Option<Arc<Mesh>>, LoadError> {
    let (ObjectKind::Obj, Some(path)) = (object.kind, &object.path) else { return Ok(None) };
    let (file, total) = open(path, "an OBJ model")?;
    let mut told = |read| progress(read, total);
    let mesh =
        read_obj(BufReader::new(file), &mut told).map_err(|source| LoadError::Model { path: path.clone(), source })?;
    Ok(Some(Arc::new(if object.fit { mesh.fitted() } else { mesh })))
}

fn read_scene(source: &Path) -> Result<(Scene, Option<PathBuf>), LoadError> {
    let ending = source.extension().and_then(OsStr::to_str).map(str::to_ascii_lowercase);
    let mut scene = match ending.as_deref() {
        Some("toml") => read_scene_file(source)?,
        Some("png") => read_scene_picture(source)?,
        Some("obj") => scene_of_model(source)?,
        _ => return Ok((built_in(source)?, None)),
    };
    if let (Some(model_path), Some(folder)) = (&mut scene.object.path, source.parent()) {
        *model_path = folder.join(&*model_path);
    }
    Ok((scene, Some(source.to_owned())))
}

fn read_scene_file(path: &Path) -> Result<Scene, LoadError> {
    let expected = "a scene file";
    let (file, _) = open(path, expected)?;
    let mut bytes = Vec::new();
    // One byte more than the parser accepts, so that it can object.
    file.take(Scene::MAX_TEXT as u64 + 1).read_to_end(&mut bytes).map_err(|source| LoadError::Unreadable {
        path: path.to_owned(),
        expected,
        source,
    })?;
    let text = match std::str::from_utf8(&bytes) {
        Ok(text) => text,
        Err(error) => {
            let before = bytes.get(..error.valid_up_to()).unwrap_or_default();
            let line = 1 + before.lines().count() - usize::from(!before.is_empty() && !before.ends_with(b"\n"));
            return Err(LoadError::NotText { path: path.to_owned(), line });
        }
    };
    Ok(Scene::parse(text, &path.to_string_lossy())?)
}

fn read_scene_picture(path: &Path) -> Result<Scene, LoadError> {
    let (file, _) = open(path, "a picture")?;
    let text =
        read_scene_text(BufReader::new(file)).map_err(|source| LoadError::Picture { path: path.to_owned(), source })?;
    Ok(Scene::parse(&text, &path.to_string_lossy())?)
}

/// The default scene with a model in the place of its object.
fn scene_of_model(path: &Path) -> Result<Scene, LoadError> {
    let mut scene = presets::default_scene();
    let normals = crate::scene::NormalSource::File;
    let name = path.file_name().map(PathBuf::from);
    scene.about = About::default();
    scene.object = Object { kind: ObjectKind::Obj, path: name, fit: true, normals, ..scene.object };
    scene.validate()?;
    Ok(scene)
}

fn built_in(source: &Path) -> Result<Scene, LoadError> {
    if let Some(preset) = source.to_str().and_then(presets::find) {
        return Ok(preset.scene());
    }
    let path = || source.to_owned();
    if source.is_dir() {
        return Err(LoadError::NotAFile { path: path(), what: "a directory", expected: "a .toml, .obj or .png file" });
    }
    if source.exists() || source.extension().is_some() || source.components().count() > 1 {
        return Err(LoadError::UnknownKind { path: path() });
    }
    let name: String = source.to_string_lossy().escape_debug().collect();
    let meant = nearest(&name, presets::ALL.iter().map(|preset| preset.name));
    Err(LoadError::UnknownName { name, meant })
}

/// A regular file with its length in bytes.
fn open(path: &Path, expected: &'static str) -> Result<(File, u64), LoadError> {
    let unreadable = |source: io::Error| match source.kind() {
        io::ErrorKind::NotFound => LoadError::Missing { path: path.to_owned(), expected },
        _ => LoadError::Unreadable { path: path.to_owned(), expected, source },
    };
    let metadata = std::fs::metadata(path).map_err(unreadable)?;
    if !metadata.is_file() {
        let what = if metadata.is_dir() { "a directory" } else { "not a regular file" };
        return Err(LoadError::NotAFile { path: path.to_owned(), what, expected });
    }
    Ok((File::open(path).map_err(unreadable)?, metadata.len()))
}
