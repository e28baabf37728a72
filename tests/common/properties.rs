//! Configuration of property tests: the seeds of failed cases are kept in one folder.

use proptest::test_runner::{Config, FileFailurePersistence};
use std::path::Path;

/// Returns the usual configuration; `file` is the caller's `file!()`.
pub fn config(file: &str) -> Config {
    let name = Path::new(file)
        .file_stem()
        .expect("a file")
        .to_string_lossy();
    let seeds = format!(
        "{}/tests/proptest-regressions/{name}.txt",
        env!("CARGO_MANIFEST_DIR")
    );
    Config {
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct(seeds.leak()))),
        ..Config::default()
    }
}
