//! Serialization of the results of cases: the name of the case, its pictures and its scene.

use super::{CaseResult, stability_cases};
use crate::analysis::codec::{from_bytes, to_bytes};
use std::sync::Arc;

pub fn results_to_bytes(results: &[Arc<CaseResult>]) -> Vec<u8> {
    to_bytes(
        &results
            .iter()
            .map(|result| packed(result))
            .collect::<Vec<_>>(),
    )
}

pub fn results_from_bytes(bytes: &[u8]) -> Option<Vec<Arc<CaseResult>>> {
    let results: Vec<Vec<u8>> = from_bytes(bytes)?;
    results
        .iter()
        .map(|result| unpacked(result).map(Arc::new))
        .collect()
}

fn packed(result: &CaseResult) -> Vec<u8> {
    let CaseResult {
        case,
        naive_error,
        robust_error,
        verdict,
        pixels,
        naive_off,
        naive_not_finite,
        robust_not_finite,
        pictures,
        scene,
    } = result;
    to_bytes(&(
        case.name,
        (naive_error, robust_error, verdict),
        (pixels, naive_off, naive_not_finite, robust_not_finite),
        pictures,
        scene,
    ))
}

fn unpacked(bytes: &[u8]) -> Option<CaseResult> {
    type Counts = (u64, u64, u64, u64);
    let (name, (naive_error, robust_error, verdict), counts, pictures, scene): (
        String,
        _,
        Counts,
        _,
        _,
    ) = from_bytes(bytes)?;
    let (pixels, naive_off, naive_not_finite, robust_not_finite) = counts;
    Some(CaseResult {
        case: stability_cases().find(|case| case.name == name)?,
        naive_error,
        robust_error,
        verdict,
        pixels,
        naive_off,
        naive_not_finite,
        robust_not_finite,
        pictures,
        scene,
    })
}
