//! Pictures as PNG, with the scene that they show inside.
//!
//! A finished [`Frame`] is written with 8 bits per channel and its scene as the text of a scene file in an iTXt
//! chunk, so that the picture can be opened in place of the scene. Only the chunk is read back, never the pixels.

use crate::render::Frame;
use crate::scene::{Encoding, Scene};
use crate::text::text;
use png::text_metadata::ITXtChunk;
use std::io::{self, BufRead, ErrorKind, Seek, Write};

/// The keyword of the text chunk that holds the scene.
pub const SCENE_KEYWORD: &str = "shading-lab:scene";

/// Memory granted to everything in a PNG file besides its pixels, in bytes.
const ANCILLARY_LIMIT: usize = 64 << 20;

/// The reason why a picture could not be read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// Not a PNG file, or a damaged one.
    #[error("{}", text!("png-damaged", error = cause(.0)))]
    Damaged(png::DecodingError),
    /// A picture from elsewhere, or one whose text another program dropped.
    #[error("{}", text!("png-no-scene"))]
    NoScene,
    /// A text chunk does not hold text, or too many bytes of it.
    #[error("{}", text!("png-unreadable-text", error = cause(.error), limit = .most >> 20))]
    UnreadableText {
        /// The decoder's error.
        error: png::DecodingError,
        /// Maximum size in bytes.
        most: usize,
    },
    /// The picture could not be written.
    #[error("{0}")]
    Unwritten(#[from] png::EncodingError),
}

impl From<PictureError> for io::Error {
    fn from(error: PictureError) -> Self {
        match error {
            PictureError::Unwritten(png::EncodingError::IoError(error)) => error,
            error => Self::other(error),
        }
    }
}

/// Returns the cause of a PNG error without the decoder's own words, which name its types.
fn cause(error: &png::DecodingError) -> String {
    use png::DecodingError::{Format, IoError, LimitsExceeded, Parameter};
    match error {
        IoError(error) if error.kind() == ErrorKind::UnexpectedEof => {
            text!("png-cut-off").to_owned()
        }
        IoError(error) => error.to_string(),
        LimitsExceeded => text!("png-too-large").to_owned(),
        Format(_) | Parameter(_) => text!("png-malformed").to_owned(),
    }
}

/// A text to embed in a picture, with its keyword.
pub type PictureText<'t> = (&'t str, &'t str);

/// Writes `frame` as a PNG with `scene`, if it shows one, and other `texts`, which are compressed. It has three channels if every
/// pixel is opaque, otherwise four. A picture encoded as sRGB says so; a raw one says nothing about its colours.
///
/// # Examples
/// ```
/// use shading_lab::picture::{read_scene_text, write_png};
/// use shading_lab::render::Renderer;
/// use shading_lab::scene::Scene;
/// use std::io::Cursor;
///
/// let mut scene = Scene::default();
/// scene.image.size = [32, 32];
/// let frame = Renderer::default().render(&scene).clone();
/// let mut png = Vec::new();
/// write_png(&mut png, &frame, Some(&scene), &[])?;
///
/// let text = read_scene_text(Cursor::new(png))?;
/// assert_eq!(Scene::parse(&text, "a picture")?, scene);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`PictureError::Unwritten`], when `out` refuses or the frame has no pixels.
pub fn write_png(
    out: &mut dyn Write,
    frame: &Frame,
    scene: Option<&Scene>,
    texts: &[PictureText<'_>],
) -> Result<(), PictureError> {
    let opaque = frame.pixels.iter().all(|pixel| pixel[3] == 255);
    let size = [frame.width, frame.height];
    let encoder = encoder(out, size, opaque, scene)?;
    let mut writer = encoder.write_header()?;
    for (keyword, text) in texts {
        let mut chunk = ITXtChunk::new(*keyword, *text);
        chunk.compressed = true;
        writer.write_text_chunk(&chunk)?;
    }
    let mut stream = writer.stream_writer()?;
    let channels = if opaque { 3 } else { 4 };
    for row in frame.pixels.chunks(frame.width.max(1) as usize) {
        let bytes: Vec<u8> = row
            .iter()
            .flat_map(|pixel| &pixel[..channels])
            .copied()
            .collect();
        stream.write_all(&bytes).map_err(png::EncodingError::from)?;
    }
    stream.finish()?;
    writer.finish()?;
    Ok(())
}

/// Writes the header of a picture of three or four channels.
fn encoder<'w>(
    out: &'w mut dyn Write,
    [width, height]: [u32; 2],
    opaque: bool,
    scene: Option<&Scene>,
) -> Result<png::Encoder<'static, &'w mut dyn Write>, PictureError> {
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_color(if opaque {
        png::ColorType::Rgb
    } else {
        png::ColorType::Rgba
    });
    if scene.is_some_and(|scene| scene.display.encoding == Encoding::Srgb) {
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    }
    encoder.add_text_chunk(
        "Software".into(),
        concat!("shading-lab ", env!("CARGO_PKG_VERSION")).into(),
    )?;
    if let Some(scene) = scene {
        encoder.add_itxt_chunk(SCENE_KEYWORD.into(), scene.to_toml())?;
    }
    Ok(encoder)
}

/// An animated PNG, written frame by frame. A program without support for animation shows the first frame.
pub struct Apng<'w> {
    writer: png::Writer<&'w mut dyn Write>,
    size: [u32; 2],
}

impl<'w> Apng<'w> {
    /// Creates an animation with that number of frames, repeated forever, with a scene inside.
    ///
    /// # Errors
    /// [`PictureError::Unwritten`], when `out` refuses or there are no pixels or no frames.
    pub fn new(
        out: &'w mut dyn Write,
        size: [u32; 2],
        frames: u32,
        scene: &Scene,
    ) -> Result<Self, PictureError> {
        let mut encoder = encoder(out, size, true, Some(scene))?;
        encoder.set_animated(frames, 0)?;
        encoder.validate_sequence(true);
        let writer = encoder.write_header()?;
        Ok(Self { writer, size })
    }

    /// Writes the next frame with its duration in milliseconds.
    ///
    /// # Errors
    /// [`PictureError::Unwritten`], also for a frame of another size, or one too many.
    pub fn add(&mut self, frame: &Frame, milliseconds: u16) -> Result<(), PictureError> {
        let same = [frame.width, frame.height] == self.size;
        let shown = if same { &frame.pixels[..] } else { &[] };
        let bytes: Vec<u8> = shown.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]).collect();
        self.writer.set_frame_delay(milliseconds, 1000)?;
        Ok(self.writer.write_image_data(&bytes)?)
    }

    /// Completes the file.
    ///
    /// # Errors
    /// [`PictureError::Unwritten`], also where frames are missing.
    pub fn finish(self) -> Result<(), PictureError> {
        Ok(self.writer.finish()?)
    }
}

/// Reads the text of the scene in a PNG.
///
/// # Errors
/// Not a PNG, no scene inside, or a text that is too long.
pub fn read_scene_text(png: impl BufRead + Seek) -> Result<String, PictureError> {
    let [scene] = read_texts(png, [(SCENE_KEYWORD, Scene::MAX_TEXT)])?;
    scene.ok_or(PictureError::NoScene)
}

/// Reads texts in a PNG by their keywords, each with its maximum size in bytes.
///
/// # Errors
/// Not a PNG, or a text that is too long.
pub fn read_texts<const N: usize>(
    png: impl BufRead + Seek,
    wanted: [(&str, usize); N],
) -> Result<[Option<String>; N], PictureError> {
    let bytes = ANCILLARY_LIMIT;
    let decoder = png::Decoder::new_with_limits(png, png::Limits { bytes });
    let mut reader = decoder.read_info().map_err(PictureError::Damaged)?;
    let missing = |info: &png::Info<'_>| wanted.iter().any(|(word, _)| chunk(info, word).is_none());
    if missing(reader.info()) {
        // Some programs move text behind the pixels.
        reader.finish().map_err(PictureError::Damaged)?;
    }
    let mut texts = [const { None }; N];
    for (text, (keyword, most)) in texts.iter_mut().zip(wanted) {
        let Some(mut chunk) = chunk(reader.info(), keyword).cloned() else {
            continue;
        };
        let unreadable = |error| PictureError::UnreadableText { error, most };
        chunk.decompress_text_with_limit(most).map_err(unreadable)?;
        *text = Some(chunk.get_text().map_err(unreadable)?);
    }
    Ok(texts)
}

fn chunk<'a>(info: &'a png::Info<'_>, keyword: &str) -> Option<&'a ITXtChunk> {
    info.utf8_text.iter().find(|chunk| chunk.keyword == keyword)
}
