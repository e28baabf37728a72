//! How often a property is tried.

/// Returns how often a property is tried, usually `usual` times: as many times more or fewer as `PROPTEST_CASES` is than 256,
/// the usual number of the tests that proptest runs by itself.
pub fn tries(usual: u64) -> u64 {
    let cases = std::env::var("PROPTEST_CASES").ok();
    let cases = cases.and_then(|cases| cases.parse().ok());
    (usual * cases.unwrap_or(256u64)).div_ceil(256)
}
