//! The SIMD levels by name, and the levels of this machine.

use fearless_simd::Level;
use serde::{Deserialize, Serialize};

/// A SIMD level that the kernels are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum SimdLevel {
    /// 512-bit vectors of x86-64.
    Avx512,
    /// 256-bit vectors of x86-64 with fused multiply-add.
    Avx2,
    /// 128-bit vectors of x86-64 with SSE4.2.
    #[serde(rename = "sse4.2")]
    Sse42,
    /// 128-bit vectors of every x86-64.
    Sse2,
    /// 128-bit vectors of ARM.
    Neon,
    /// WebAssembly's 128-bit vectors.
    Simd128,
    /// One number at a time.
    Scalar,
}

impl SimdLevel {
    /// Every level, the widest vectors first.
    pub const ALL: &'static [Self] = &[
        Self::Avx512,
        Self::Avx2,
        Self::Sse42,
        Self::Sse2,
        Self::Neon,
        Self::Simd128,
        Self::Scalar,
    ];

    /// Returns the levels of this machine, best first.
    pub fn available() -> Vec<(Self, Level)> {
        let best = Level::new();
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        let levels = [
            best.as_avx512()
                .map(|token| (Self::Avx512, Level::Avx512(token))),
            best.as_avx2().map(|token| (Self::Avx2, Level::Avx2(token))),
            best.as_sse4_2()
                .map(|token| (Self::Sse42, Level::Sse4_2(token))),
            best.as_sse2().map(|token| (Self::Sse2, Level::Sse2(token))),
        ];
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        let levels = [Some((
            match () {
                () if best.is_fallback() => Self::Scalar,
                () if cfg!(target_arch = "wasm32") => Self::Simd128,
                () => Self::Neon,
            },
            best,
        ))];
        levels.into_iter().flatten().collect()
    }
}
