//! Scenes and pictures as files: opened by path, built-in name or link, written completely or not at all.
//!
//! In memory the path of a model is absolute. In a scene file it is written relative to that file where the model
//! lies beside or below it, so that the two can be moved together; in a picture, which is passed on alone, it stays
//! absolute.
//!
//! A web page has no disk: there `disk` holds the files given to the page, and writing starts a download.

#[cfg_attr(target_arch = "wasm32", path = "document/page.rs")]
mod disk;
mod error;
mod names;

use crate::analysis::report::Figure;
use crate::analysis::{Answer, Format, ReportContext, Subject};
use crate::animation::{FilmFormat, Sweep, write_film};
use crate::export::Export;
use crate::figure::{Drawing, Paper};
use crate::geometry::{Mesh, ObjError, Remark, read_model};
use crate::link::{self, Link, Shown};
use crate::picture::{PictureError, PictureText, read_scene_text, write_png};
use crate::render::{Frame, Renderer, can_be_had};
use crate::scene::{
    Choice, NormalSource, Object, ObjectKind, Scene, SceneDescription, did_you_mean, presets,
};
use crate::text::{Message, excerpt, text};
#[cfg(not(target_arch = "wasm32"))]
pub use disk::STDOUT;
#[cfg(target_arch = "wasm32")]
pub use disk::give;
pub use disk::{check_target, write_whole};
use error::{LIBRARY, MODEL, PICTURE, SCENE_FILE};
pub use error::{LoadError, SaveError};
use names::beside;
pub use names::ending;
pub(crate) use names::stays_here;
use std::io::{BufRead, BufReader, Cursor, Read, Seek};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A scene with everything needed to draw it.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded {
    /// The scene, valid by [`Scene::validate`]; a model's path is absolute.
    pub scene: Scene,
    /// The mesh of an object of kind `obj`, fitted where the scene says so.
    pub model: Option<Arc<Mesh>>,
    /// Name: that of the built-in scene, or of the file.
    pub name: String,
    /// The file it was read from; none for a built-in scene and for a link.
    pub path: Option<PathBuf>,
    /// View that a link requests.
    pub shown: Shown,
}

impl Loaded {
    /// Creates a scene that is not a file, without its model.
    fn new(scene: Scene, name: &str, shown: Shown) -> Self {
        Self {
            scene,
            model: None,
            name: name.to_owned(),
            path: None,
            shown,
        }
    }

    /// Returns a renderer that has the model.
    pub fn renderer(&self) -> Renderer {
        Renderer::default().with_model(self.model.clone())
    }

    /// Returns a sentence for each part of its model's files that is not drawn, with its file and line.
    pub fn warnings(&self) -> Vec<String> {
        undrawn(&self.scene.object, self.model.as_deref())
    }
}

impl From<Loaded> for Subject {
    /// Returns the scene with its model as a subject without a clock.
    fn from(loaded: Loaded) -> Self {
        Self {
            model: loaded.model,
            ..Self::new(loaded.scene)
        }
    }
}

/// Returns a sentence for each part of the files of a scene's model that is not drawn, with its file and line.
pub(crate) fn undrawn(object: &Object, model: Option<&Mesh>) -> Vec<String> {
    /// The most textures that are named.
    const MOST_NAMED: usize = 5;
    let Some(mesh) = model else {
        return vec![];
    };
    let own = object.path.as_deref().and_then(Path::file_name);
    let own = own.unwrap_or_default().to_string_lossy();
    let said = |remark: &Remark| {
        let file = remark.library.as_deref().unwrap_or(&own);
        format!("{}:{}: {}", excerpt(file), remark.line, remark.words)
    };
    let mut warnings: Vec<String> = mesh.remarks.iter().map(said).collect();
    let is_own = |name: &String| mesh.materials.iter().any(|own| own.name == *name);
    for change in &object.materials {
        if !is_own(&change.name) {
            let words = text!("document-no-material", name = excerpt(&change.name));
            warnings.push(format!("{own}: {words}"));
        }
    }
    let mut textures: Vec<&str> = vec![];
    for name in mesh.materials.iter().flat_map(|material| &material.maps) {
        if !textures.contains(&name.as_str()) && textures.len() <= MOST_NAMED {
            textures.push(name);
        }
    }
    if !textures.is_empty() {
        let more = textures.len() > MOST_NAMED;
        textures.truncate(MOST_NAMED);
        let names = textures.join(", ") + if more { ", …" } else { "" };
        let words = text!("document-textures", names = names);
        warnings.push(format!("{own}: {words}"));
    }
    let mut materials = mesh.materials.iter();
    if let Some(first) = materials.find(|material| material.refracts_by_model()) {
        let words = text!("document-illum-refracts", name = first.name.as_str());
        warnings.push(format!("{own}: {words}"));
    }
    warnings
}

/// A callback for progress: the number of bytes of a model that have been read, and their total.
pub type Progress<'a> = &'a mut dyn FnMut(u64, u64);

/// Opens a scene: a `.toml` file; a `.obj` model in the default scene, fitted; a `.png` with its scene inside; a
/// link, which begins with `https://` or with `?`; or a built-in scene by its name, which takes precedence over a
/// file of the same name without such an ending.
///
/// # Examples
/// ```
/// use shading_lab::document::load_scene;
/// use std::path::Path;
///
/// let teapot = load_scene(Path::new("teapot"))?;
/// let link = load_scene(Path::new("?scene=teapot&set=material.n=5"))?;
/// assert_eq!(link.scene.material.n, 5.0);
/// assert_eq!(teapot.scene.object, link.scene.object);
///
/// let error = load_scene(Path::new("teapto")).expect_err("a misspelt name");
/// assert!(error.to_string().contains("teapot"), "{error}");
/// # Ok::<(), shading_lab::document::LoadError>(())
/// ```
pub fn load_scene(source: &Path) -> Result<Loaded, LoadError> {
    load_with(source, &[] as &[&str], &mut |_, _| {})
}

/// Opens a scene like [`load_scene`], with overrides in the form of [`Scene::with_overrides`], applied before the model is
/// read. A model's path in an override is relative to the working directory.
pub fn load_with(
    source: &Path,
    overrides: &[impl AsRef<str>],
    progress: Progress<'_>,
) -> Result<Loaded, LoadError> {
    completed(read_scene(source)?, overrides, progress)
}

/// Opens a scene that is not a file on disk: the text of a scene file, a picture with its scene inside, or a link.
/// Messages call it `name`; a model's path in it is relative to the working directory.
pub fn load_bytes(
    name: &str,
    bytes: Vec<u8>,
    overrides: &[impl AsRef<str>],
    progress: Progress<'_>,
) -> Result<Loaded, LoadError> {
    let path = Path::new(name);
    let (scene, shown) = if is_picture(&bytes) {
        let scene = parsed_picture(Cursor::new(bytes), path)?;
        (scene, Shown::default())
    } else {
        let text = utf_8(path, bytes)?;
        if link::is_link(text.trim()) {
            let Link { scene, shown, .. } = link::read(text.trim())?;
            (scene, shown)
        } else {
            (parsed(&text, path)?, Shown::default())
        }
    };
    let name = name.trim_matches(['<', '>']);
    completed(Loaded::new(scene, name, shown), overrides, progress)
}

/// Returns whether a file's content is a PNG picture.
pub fn is_picture(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89PNG")
}

/// Applies overrides and reads the model.
fn completed(
    mut loaded: Loaded,
    overrides: &[impl AsRef<str>],
    progress: Progress<'_>,
) -> Result<Loaded, LoadError> {
    if !overrides.is_empty() {
        loaded.scene = loaded.scene.with_overrides(overrides)?;
    }
    let scene = &mut loaded.scene;
    loaded.model = load_model(&scene.object, progress)?;
    let alone = loaded.path.as_deref().and_then(ending).as_deref() == Some("obj");
    if let Some(mesh) = loaded.model.as_ref().filter(|_| alone) {
        let (centre, radius) = mesh.ball();
        scene.camera = scene.camera.fitted(centre, radius, scene.image.size);
        // Blender writes `Ka 1 1 1` for every material, of a world whose ambient light is weak.
        let ka = mesh
            .materials
            .iter()
            .map(|own| own.material().ka.max_element());
        let strongest = ka.fold(MOST_AMBIENT, f64::max);
        scene.ambient.color *= MOST_AMBIENT / strongest;
    }
    // Done last, so that messages name the model as the user does. An unknown working directory is ignored.
    if let Some(model_path) = &mut scene.object.path
        && let Ok(absolute) = std::path::absolute(&*model_path)
    {
        *model_path = absolute;
    }
    Ok(loaded)
}

/// The largest Ka·Ia of a model that is opened alone, without a scene that says how strong its ambient light is.
const MOST_AMBIENT: f64 = 0.2;
/// Maximum number of bytes that reading a model takes for each byte of its file (`tests/engine/obj_memory.rs`).
const OF_MODEL: u64 = 6;
/// Size in bytes up to which files are read without a check of the memory in advance.
const LARGE_MODEL: u64 = 1 << 22;

/// Reads the model of an object: none unless its kind is `obj`.
fn load_model(object: &Object, progress: Progress<'_>) -> Result<Option<Arc<Mesh>>, LoadError> {
    let (ObjectKind::Obj, Some(path)) = (object.kind, &object.path) else {
        return Ok(None);
    };
    let (file, total) = disk::open(path, MODEL)?;
    let bytes = total.saturating_mul(OF_MODEL);
    if total > LARGE_MODEL && !can_be_had(bytes) {
        return Err(LoadError::file(
            path,
            text!("document-model-memory", megabytes = bytes >> 20),
        ));
    }
    let mut told = |read| progress(read, total);
    let refused = |error: ObjError| LoadError::File {
        path: path.clone(),
        line: error.line(),
        problem: error.to_string(),
    };
    let mut library = |name: &str| read_library(path, name);
    let mesh = read_model(BufReader::new(file), &mut told, &mut library).map_err(refused)?;
    Ok(Some(Arc::new(if object.fit {
        mesh.fitted()
    } else {
        mesh
    })))
}

/// Reads a material library of the model at `path`, or says why not. It lies beside the model, and nowhere else.
fn read_library(path: &Path, name: &str) -> Result<Vec<u8>, String> {
    /// The largest library, in bytes: some ten thousand materials.
    const MOST: u64 = 1 << 22;
    let beside = beside(name).ok_or_else(|| text!("document-library-beside"))?;
    let path = path.with_file_name(beside);
    let problem = |error: LoadError| match error {
        // A page has no folder to look into.
        _ if cfg!(target_arch = "wasm32") => text!("document-library-drop").to_owned(),
        LoadError::File { problem, .. } => problem,
        error => error.to_string(),
    };
    let (file, length) = disk::open(&path, LIBRARY).map_err(problem)?;
    if length > MOST {
        return Err(text!("document-library-size", megabytes = MOST >> 20));
    }
    let mut bytes = Vec::new();
    let read = file.take(MOST).read_to_end(&mut bytes);
    read.map_err(|error| problem(LoadError::unreadable(&path, LIBRARY, &error)))?;
    Ok(bytes)
}

/// Reads everything but the model.
fn read_scene(source: &Path) -> Result<Loaded, LoadError> {
    if let Some(named) = source.to_str().and_then(read_named) {
        return named;
    }
    let mut scene = match ending(source).as_deref() {
        Some("toml") => parsed(&read_text(source, SCENE_FILE, Scene::MAX_TEXT)?, source)?,
        Some("png") => parsed_picture(open_picture(source)?, source)?,
        Some("obj") => scene_of_model(source)?,
        _ => return Err(unknown(source)),
    };
    if let (Some(model_path), Some(folder)) = (&mut scene.object.path, source.parent()) {
        *model_path = folder.join(&*model_path);
    }
    let name = source.file_name().unwrap_or(source.as_os_str());
    let loaded = Loaded::new(scene, &name.to_string_lossy(), Shown::default());
    Ok(Loaded {
        path: Some(source.to_owned()),
        ..loaded
    })
}

/// Opens anything that is not a file: a link, or a built-in scene by its name.
fn read_named(name: &str) -> Option<Result<Loaded, LoadError>> {
    if link::is_link(name) {
        let read = link::read(name).map_err(LoadError::from);
        return Some(read.map(|Link { scene, name, shown }| Loaded::new(scene, &name, shown)));
    }
    let scene = presets::find(name)?.scene();
    Some(Ok(Loaded::new(scene, name, Shown::default())))
}

/// Opens a built-in scene or a link, and nothing else whatever `name` is: for names from untrusted sources, which
/// must not open files.
pub(crate) fn load_named(name: &str) -> Result<Loaded, LoadError> {
    read_named(name).unwrap_or_else(|| Err(no_such_scene(name)))
}

/// Parses the scene in a text from `path`. The model that it names is on this machine.
fn parsed(text: &str, path: &Path) -> Result<Scene, LoadError> {
    let scene = Scene::parse(text, &path.to_string_lossy())?;
    let model = scene.object.path.as_ref();
    if model.is_some_and(|model| !stays_here(&model.to_string_lossy())) {
        return Err(LoadError::file(path, text!("document-elsewhere")));
    }
    Ok(scene)
}

/// Parses the scene in a picture from `path`.
fn parsed_picture(png: impl BufRead + Seek, path: &Path) -> Result<Scene, LoadError> {
    let text = read_scene_text(png).map_err(|error| LoadError::file(path, error))?;
    parsed(&text, path)
}

/// Reads the text of a file, which was expected to be `what`: at most one byte more than `most`, so that its reader
/// can report the error.
pub(crate) fn read_text(path: &Path, what: Message, most: usize) -> Result<String, LoadError> {
    let (file, _) = disk::open(path, what)?;
    let mut bytes = Vec::new();
    let read = file.take(most as u64 + 1).read_to_end(&mut bytes);
    read.map_err(|error| LoadError::unreadable(path, what, &error))?;
    utf_8(path, bytes)
}

/// Converts a file's content to text.
fn utf_8(path: &Path, bytes: Vec<u8>) -> Result<String, LoadError> {
    String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let before = error.as_bytes().get(..valid).unwrap_or_default();
        let line = Some(1 + before.iter().filter(|byte| **byte == b'\n').count() as u64);
        LoadError::File {
            path: path.to_owned(),
            line,
            problem: text!("document-not-utf-8").to_owned(),
        }
    })
}

/// Returns the default scene with a model in place of its object.
fn scene_of_model(path: &Path) -> Result<Scene, LoadError> {
    let mut scene = presets::default_scene();
    scene.about = SceneDescription::default();
    scene.object = Object {
        kind: ObjectKind::Obj,
        path: path.file_name().map(PathBuf::from),
        fit: true,
        normals: NormalSource::File,
        ..scene.object
    };
    scene.validate()?;
    Ok(scene)
}

/// Returns the reason why the user's source is not a scene.
fn unknown(source: &Path) -> LoadError {
    if source.is_dir() {
        return LoadError::file(source, text!("document-directory"));
    }
    if source.exists() || source.extension().is_some() || source.components().count() > 1 {
        return LoadError::file(source, text!("document-unknown-kind"));
    }
    no_such_scene(&source.to_string_lossy())
}

/// Returns the reason why there is no scene of that name.
fn no_such_scene(name: &str) -> LoadError {
    let name = excerpt(name);
    let meant = did_you_mean(&name, presets::ALL.iter().map(|preset| preset.name));
    LoadError::file(
        Path::new(&name),
        text!("document-no-such-scene", meant = meant),
    )
}

/// Writes a scene file. The path of a model at or below the file's folder is written relative to it.
pub fn save_scene(path: &Path, scene: &Scene) -> Result<(), SaveError> {
    let mut portable = scene.clone();
    let folder = std::path::absolute(path)
        .ok()
        .and_then(|path| path.parent().map(Path::to_owned));
    if let (Some(model), Some(folder)) = (&mut portable.object.path, folder)
        && let Ok(relative) = model.strip_prefix(&folder)
    {
        *model = relative.to_owned();
    }
    write_text(path, &portable.to_toml())
}

/// Writes a picture as PNG with its scene inside; a model's path stays absolute.
pub fn save_picture(path: &Path, frame: &Frame, scene: &Scene) -> Result<(), SaveError> {
    write_picture(path, frame, Some(scene), &[])
}

/// Draws and writes a film, frame by frame: see [`write_film`]. No file is left behind if `draw` has stopped it.
pub fn save_film(
    path: &Path,
    format: FilmFormat,
    sweep: &Sweep,
    seconds: f64,
    draw: &mut dyn FnMut(&Scene) -> Option<Frame>,
) -> Result<(), SaveError> {
    write_whole(path, |out| write_film(out, format, sweep, seconds, draw))
}

/// Opens a picture's file for [`crate::picture::read_texts`].
pub(crate) fn open_picture(path: &Path) -> Result<impl BufRead + Seek + use<>, LoadError> {
    disk::open(path, PICTURE).map(|(file, _)| BufReader::new(file))
}

/// Returns the bytes of a picture's file.
///
/// # Errors
/// A frame that has no pixels.
pub fn picture_bytes(frame: &Frame, scene: Option<&Scene>) -> Result<Vec<u8>, PictureError> {
    let mut bytes = Vec::new();
    write_png(&mut bytes, frame, scene, &[]).map(|()| bytes)
}

/// Writes a picture as PNG, with its scene and other texts inside by their keywords.
pub(crate) fn write_picture(
    path: &Path,
    frame: &Frame,
    scene: Option<&Scene>,
    texts: &[PictureText<'_>],
) -> Result<(), SaveError> {
    write_whole(path, |out| Ok(write_png(out, frame, scene, texts)?))
}

fn write_text(path: &Path, text: &str) -> Result<(), SaveError> {
    write_whole(path, |out| out.write_all(text.as_bytes()))
}

/// Writes the parts of a scene's code, each to its [path](Export::path_of): all of them or none.
pub fn save_code(target: &Path, export: &Export) -> Result<(), SaveError> {
    let file = |part| (export.path_of(part, target), &*part.text);
    let files: Vec<(PathBuf, &str)> = export.parts.iter().map(file).collect();
    disk::write_texts(&files)
}

impl Format {
    /// Returns the format of a name's ending.
    pub fn from_path(path: &Path) -> Option<Self> {
        Self::from_word(&path.extension()?.to_string_lossy().to_lowercase())
    }
}

/// Writes an answer; a figure, if it is one, in `size` and on `paper`. A PNG of a scene has the scene inside.
///
/// # Errors
/// A target that cannot be written, or [`SaveError::Nothing`] where there is nothing to draw.
pub fn save_answer(
    path: &Path,
    format: Format,
    answer: &dyn Answer,
    about: &ReportContext<'_>,
    (size, paper): (Option<[u32; 2]>, Paper),
) -> Result<(), SaveError> {
    let nothing = || SaveError::Nothing {
        path: path.to_owned(),
    };
    let figure = || answer.figure(about, size, paper).ok_or_else(nothing);
    match format {
        Format::Csv => write_text(path, &answer.csv(about)),
        Format::Json => write_text(path, &answer.json(about)),
        Format::Svg => match figure()? {
            Figure::Drawing { drawing, title } => write_text(path, &drawing.to_svg(&title)),
            Figure::Picture { .. } => Err(nothing()),
        },
        Format::Png => match figure()? {
            Figure::Drawing { drawing, .. } => write_drawing(path, &drawing, Some(about.scene)),
            Figure::Picture { frame, scene } => write_picture(path, &frame, scene.as_deref(), &[]),
        },
    }
}

fn write_drawing(path: &Path, drawing: &Drawing, scene: Option<&Scene>) -> Result<(), SaveError> {
    let too_large = || SaveError::Target {
        path: path.to_owned(),
        problem: Message("document-figure-too-large"),
    };
    write_picture(path, &drawing.to_frame().ok_or_else(too_large)?, scene, &[])
}

/// Writes a drawing that shows no scene; as SVG according to the name's ending, otherwise as PNG.
pub fn save_drawing(path: &Path, drawing: &Drawing, title: &str) -> Result<(), SaveError> {
    if Format::from_path(path) == Some(Format::Svg) {
        return write_text(path, &drawing.to_svg(title));
    }
    write_drawing(path, drawing, None)
}
