//! Pictures as PNG: their pixels and the scene inside arrive as they were, and damage is refused.

use png::text_metadata::ITXtChunk;
use shading_lab::picture::{PictureError, SCENE_KEYWORD, read_scene_text, write_png};
use shading_lab::render::Frame;
use shading_lab::scene::{Encoding, Scene};
use std::io::Cursor;

fn checkered(alpha: u8) -> Frame {
    let pixels = (0..35u8)
        .map(|i| {
            [
                i * 7,
                255 - i,
                i % 2 * 255,
                if i == 17 { alpha } else { 255 },
            ]
        })
        .collect();
    Frame {
        width: 7,
        height: 5,
        pixels,
    }
}

fn written(frame: &Frame, scene: &Scene) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_png(&mut bytes, frame, Some(scene), &[]).expect("a picture");
    bytes
}

fn pixels(bytes: &[u8]) -> (png::ColorType, Vec<u8>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes))
        .read_info()
        .expect("a header");
    let mut buffer = vec![0; reader.output_buffer_size().expect("a small picture")];
    reader.next_frame(&mut buffer).expect("pixels");
    (reader.info().color_type, buffer)
}

#[test]
fn pixels_arrive_as_they_were() {
    let frame = checkered(255);
    let three: Vec<u8> = frame
        .pixels
        .iter()
        .flat_map(|[r, g, b, _]| [*r, *g, *b])
        .collect();
    assert_eq!(
        pixels(&written(&frame, &Scene::default())),
        (png::ColorType::Rgb, three)
    );
    let frame = checkered(128);
    let four = frame.pixels.concat();
    assert_eq!(
        pixels(&written(&frame, &Scene::default())),
        (png::ColorType::Rgba, four)
    );
}

#[test]
fn the_scene_comes_back() {
    let mut scene = Scene::default();
    scene.object.path = Some("/models/Kännchen „茶壺“.obj".into());
    let text = read_scene_text(Cursor::new(written(&checkered(255), &scene))).expect("a scene");
    assert_eq!(Scene::parse(&text, ""), Ok(scene));
}

#[test]
fn only_an_encoded_picture_names_its_encoding() {
    for (encoding, expected) in [(Encoding::Raw, false), (Encoding::Srgb, true)] {
        let mut scene = Scene::default();
        scene.display.encoding = encoding;
        let bytes = written(&checkered(255), &scene);
        let reader = png::Decoder::new(Cursor::new(&bytes))
            .read_info()
            .expect("a header");
        assert_eq!(reader.info().srgb.is_some(), expected);
    }
}

fn with_text(text: String, compressed: bool, keyword: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&[0]).expect("a pixel");
    let mut chunk = ITXtChunk::new(keyword, text);
    if compressed {
        chunk.compress_text().expect("compressed");
    }
    chunk.compressed = compressed;
    writer.write_text_chunk(&chunk).expect("a chunk");
    writer.finish().expect("an end");
    bytes
}

#[test]
fn text_behind_the_pixels_is_found_compressed_or_not() {
    for compressed in [false, true] {
        let bytes = with_text("version = 1".into(), compressed, SCENE_KEYWORD);
        assert_eq!(
            read_scene_text(Cursor::new(bytes)).expect("a scene"),
            "version = 1"
        );
    }
}

#[test]
fn what_holds_no_scene_is_refused() {
    let other = with_text("version = 1".into(), false, "Comment");
    assert!(matches!(
        read_scene_text(Cursor::new(other)),
        Err(PictureError::NoScene)
    ));
    let bomb = with_text(" ".repeat(Scene::MAX_TEXT + 1), true, SCENE_KEYWORD);
    assert!(bomb.len() < 100_000);
    assert!(matches!(
        read_scene_text(Cursor::new(bomb)),
        Err(PictureError::UnreadableText { .. })
    ));
    assert!(matches!(
        read_scene_text(Cursor::new(b"GIF89a")),
        Err(PictureError::Damaged(_))
    ));
}

#[test]
fn no_damage_takes_the_reader_down() {
    let sound = written(&checkered(255), &Scene::default());
    // If it detects the damage, it reports it in words.
    let read = |bytes: &[u8]| {
        if let Err(error) = read_scene_text(Cursor::new(bytes)) {
            let words = error.to_string();
            assert!(
                !words.contains(['{', '"', '_']) && !words.contains("::"),
                "{words}"
            );
        }
    };
    for end in 0..sound.len() {
        read(&sound[..end]);
    }
    for i in 0..sound.len() {
        let mut damaged = sound.clone();
        damaged[i] ^= 0xff;
        read(&damaged);
    }
}
