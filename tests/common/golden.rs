//! Approved pictures in `tests/golden`, with which drawn ones are compared. `UPDATE_GOLDEN=1` replaces them, and the run still
//! fails, so that they are reviewed before they are committed.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// A folder of approved pictures below `tests/golden`.
pub struct Golden(pub &'static str);

impl Golden {
    fn folder(&self) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/golden")
            .join(self.0)
    }

    pub fn kept(&self, name: &str) -> PathBuf {
        self.folder().join(format!("{name}.png"))
    }

    /// Fails if `compare` describes a difference for any name; in an update, after `replace` has written the new picture.
    #[track_caller]
    pub fn check<'a, T>(
        &self,
        drawn: impl Iterator<Item = (&'a str, T)>,
        compare: impl Fn(&str, &T) -> Option<String>,
        replace: impl Fn(&Path, &T),
    ) {
        let update = std::env::var_os("UPDATE_GOLDEN").is_some();
        let mut wrong = Vec::new();
        for (name, picture) in drawn {
            if let Some(message) = compare(name, &picture) {
                if update {
                    fs::create_dir_all(self.folder()).expect("the folder is made");
                    replace(&self.kept(name), &picture);
                }
                wrong.push(message);
            }
        }
        let hint = if update {
            "\nreplaced: look at them"
        } else {
            ""
        };
        assert!(wrong.is_empty(), "{}{hint}", wrong.join("\n"));
    }

    /// Fails if a picture is kept that is not among those `drawn`.
    #[track_caller]
    pub fn has_only(&self, drawn: impl Fn(&str) -> bool) {
        for entry in fs::read_dir(self.folder()).expect("the folder of kept pictures") {
            let path = entry.expect("an entry").path();
            let name = path.file_stem().expect("a name").to_string_lossy();
            assert!(path.is_dir() || drawn(&name), "{name}");
        }
    }
}

/// Reads the size and the bytes of a picture.
pub fn read(path: &Path) -> Option<([u32; 2], Vec<u8>)> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?))
        .read_info()
        .ok()?;
    let mut bytes = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut bytes).ok()?;
    bytes.truncate(info.buffer_size());
    Some(([info.width, info.height], bytes))
}
