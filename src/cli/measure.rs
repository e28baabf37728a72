//! `explain`, `study` and `bench`: what frames do, and how long they take.

use super::analyse::Asks;
use super::failure::Failure;
use super::input::parse_choice;
use clap::Args;
use shading_lab::analysis::{BenchQuestion, Method, PlanQuestion, StudyQuestion};
use shading_lab::scene::{Interpolation, Object, Scene};

#[derive(Args)]
pub struct Explain {
    /// Frames for each time
    #[arg(long, value_name = "N", default_value_t = 15, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    frames: u32,
}

impl Asks for Explain {
    type Question = PlanQuestion;
    const NAME: &'static str = "explain";

    fn question(&self, _: &mut Scene) -> Result<PlanQuestion, Failure> {
        Ok(PlanQuestion { frames: self.frames })
    }
}

#[derive(Args)]
pub struct Bench {
    /// Frames for each figure
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    frames: u32,
    /// Threads; one for each core unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Measure also how the time grows with the pixels, up to 8 million, and with the triangles, up to 4 million
    #[arg(long)]
    growth: bool,
}

impl Asks for Bench {
    type Question = BenchQuestion;
    const NAME: &'static str = "bench";

    fn question(&self, _: &mut Scene) -> Result<BenchQuestion, Failure> {
        Ok(BenchQuestion { frames: self.frames, growth: self.growth })
    }

    fn threads(&self) -> Option<u16> {
        self.threads
    }
}

#[derive(Args)]
pub struct Study {
    /// Ways of shading between commas, all unless given: flat, flat-vertex-mean, interpolated, gouraud, phong,
    /// phong-unnormalised; in scalar code phong-scalar, taylor (Bishop and Weimer 1986), angular (Kuijk and Blake 1989)
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = |text: &str| parse_choice(text, Method::ALL))]
    methods: Vec<Method>,
    /// Polygons round the axis, between commas; those along it go with them
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "8,16,32,64,128,256",
          value_parser = clap::value_parser!(u32).range(3..=i64::from(Object::MAX_DIVISIONS)))]
    segments: Vec<u32>,
    /// Exponents of the highlight, between commas; the scene's own unless given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    n: Vec<f64>,
    /// How values between vertices are found, between commas: perspective, affine, scanline
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "perspective,affine",
          value_parser = |text: &str| parse_choice(text, [Interpolation::Perspective, Interpolation::Affine, Interpolation::Scanline]))]
    interpolation: Vec<Interpolation>,
    /// Frames timed for each setting
    #[arg(long, value_name = "N", default_value_t = 9, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    repeats: u32,
    /// Threads of the engine; one for each core unless given. With 1 its times and those of the scalar code differ by the
    /// code alone
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Asks for Study {
    type Question = StudyQuestion;
    const NAME: &'static str = "study";

    fn question(&self, scene: &mut Scene) -> Result<StudyQuestion, Failure> {
        for n in &self.n {
            let mut tried = scene.clone();
            tried.material.n = *n;
            tried.validate().map_err(|error| Failure::input(format!("--n {n}: {error}")))?;
        }
        Ok(StudyQuestion {
            methods: if self.methods.is_empty() { Method::ALL.to_vec() } else { self.methods.clone() },
            segments: self.segments.clone(),
            interpolations: self.interpolation.clone(),
            n: self.n.clone(),
            repeats: self.repeats,
        })
    }

    fn threads(&self) -> Option<u16> {
        self.threads
    }
}
