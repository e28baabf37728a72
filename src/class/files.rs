//! Files that the server gives out: all of them are in memory before it starts, so that no request can reach another.

use crate::bits::fnv_1a;
use hyper::body::Bytes;
use miniz_oxide::deflate::compress_to_vec;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The effort of compression, of 10.
const EFFORT: u8 = 9;
/// The largest page of the program, in bytes: several times what it has.
const MOST: u64 = 128 << 20;

/// A file to give out.
#[derive(Clone, Debug)]
pub struct StaticFile {
    /// The media type.
    pub kind: &'static str,
    /// The content.
    pub bytes: Bytes,
    /// The content compressed as `gzip` and as `br`, if that is smaller.
    pub compressed: [Option<Bytes>; 2],
    /// The hash of the content.
    pub hash: String,
}

impl StaticFile {
    /// Creates a file with the given content, compressed if it is text.
    pub fn new(name: &str, bytes: impl Into<Bytes>) -> Self {
        let (kind, text) = kind(name);
        let bytes = bytes.into();
        let gzip = text
            .then(|| gzip(&bytes))
            .filter(|gzip| gzip.len() < bytes.len());
        Self {
            kind,
            hash: fnv_1a(bytes.iter().copied()),
            compressed: [gzip.map(Bytes::from), None],
            bytes,
        }
    }
}

/// Returns the media type by the name, and whether it is worth compressing.
fn kind(name: &str) -> (&'static str, bool) {
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    match ending {
        "html" => ("text/html; charset=utf-8", true),
        "js" => ("text/javascript; charset=utf-8", true),
        "css" => ("text/css; charset=utf-8", true),
        "json" | "webmanifest" => ("application/manifest+json", true),
        "ftl" | "md" | "txt" | "toml" => ("text/plain; charset=utf-8", true),
        "svg" => ("image/svg+xml", true),
        "wasm" => ("application/wasm", true),
        "otf" | "ttf" => ("font/otf", true),
        "png" => ("image/png", false),
        "ico" => ("image/x-icon", false),
        _ => ("application/octet-stream", false),
    }
}

/// Compresses as `gzip` (RFC 1952).
fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut out = vec![0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 2, 255];
    out.extend(compress_to_vec(bytes, EFFORT));
    out.extend(crc(bytes).to_le_bytes());
    out.extend((bytes.len() as u32).to_le_bytes());
    out
}

/// Returns the checksum of RFC 1952, section 8.
fn crc(bytes: &[u8]) -> u32 {
    let table: [u32; 256] = std::array::from_fn(|index| {
        (0..8).fold(index as u32, |crc, _| {
            (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg())
        })
    });
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (crc >> 8) ^ table[((crc ^ u32::from(*byte)) & 0xff) as usize]
    })
}

/// The folder beside the program in which releases have its page.
const PAGE: &str = "page";

/// Returns the folder in which releases have the program's page, whether it is there or not.
pub fn page_folder() -> Option<PathBuf> {
    Some(std::env::current_exe().ok()?.parent()?.join(PAGE))
}

/// Reads the files of the program's page in a folder, by their paths in it; none where it is no such page. Symbolic links are not
/// followed. Compressed ones are taken from beside the files, where they lie there.
pub fn read_page(folder: &Path) -> Option<HashMap<String, StaticFile>> {
    let mut raw = HashMap::new();
    let mut folders = vec![(folder.to_owned(), String::new())];
    let mut total = 0;
    while let Some((folder, prefix)) = folders.pop() {
        for entry in fs::read_dir(folder).ok()?.filter_map(Result::ok) {
            let name = format!("{prefix}{}", entry.file_name().to_str()?);
            let about = entry.path().symlink_metadata().ok()?;
            if about.is_dir() {
                folders.push((entry.path(), format!("{name}/")));
            } else if about.is_file() {
                total += about.len();
                if total > MOST {
                    return None;
                }
                raw.insert(name, fs::read(entry.path()).ok()?);
            }
        }
    }
    let program = |name: &str| name.ends_with(".wasm");
    if !raw.contains_key("index.html") || !raw.keys().any(|name| program(name)) {
        return None;
    }
    let [gzips, brotlis] = [".gz", ".br"].map(|ending| {
        let named = |name: &String| Some(name.strip_suffix(ending)?.to_owned());
        let names: Vec<String> = raw.keys().filter_map(named).collect();
        let found = names.into_iter().map(|name| {
            let bytes = raw.remove(&format!("{name}{ending}")).unwrap_or_default();
            (name, Bytes::from(bytes))
        });
        found.collect::<HashMap<_, _>>()
    });
    let file = |(name, bytes): (String, Vec<u8>)| {
        let mut file = match gzips.get(&name) {
            Some(gzip) => StaticFile {
                kind: kind(&name).0,
                hash: fnv_1a(bytes.iter().copied()),
                bytes: bytes.into(),
                compressed: [Some(gzip.clone()), None],
            },
            None => StaticFile::new(&name, bytes),
        };
        file.compressed[1] = brotlis.get(&name).cloned();
        (name, file)
    };
    Some(raw.into_iter().map(file).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use miniz_oxide::inflate::decompress_to_vec;

    #[test]
    fn a_checksum_is_that_of_the_standard() {
        assert_eq!(crc(b"123456789"), 0xcbf4_3926);
    }

    #[test]
    fn what_is_compressed_is_the_same_again() {
        let text = "a pixel ".repeat(1000);
        let file = StaticFile::new("a.js", text.clone());
        let [Some(gzip), None] = &file.compressed else {
            panic!("text is compressed");
        };
        assert!(gzip.len() < 100);
        let inside = &gzip[10..gzip.len() - 8];
        assert!(decompress_to_vec(inside).is_ok_and(|inside| inside == text.as_bytes()));
        // Pictures are compressed already, and what would grow is left as it is.
        assert_eq!(StaticFile::new("a.png", text).compressed, [None, None]);
        assert_eq!(StaticFile::new("a.js", "a").compressed, [None, None]);
    }
}
