//! The analyses on the command line: a scene, arguments that become a question, and the destination of the answer.

use super::input::{
    PaneArguments, SceneArguments, choice, inside_picture, one_of, output_file, output_name,
    parse_pixel, parse_place, parse_size, parse_vertex, picture_name, whole,
};
use super::output::{Failure, check_picture_target, print, print_json, progress_bar};
use clap::Args;
use glam::DVec2;
use shading_lab::analysis::bench::BenchQuestion;
use shading_lab::analysis::comparison::ComparisonQuestion;
use shading_lab::analysis::conditions::ConditionsQuestion;
use shading_lab::analysis::curves::CurvesQuestion;
use shading_lab::analysis::defects::DefectsQuestion;
use shading_lab::analysis::normals::NormalsQuestion;
use shading_lab::analysis::perception::{Perception, ResponseModel, Viewing};
use shading_lab::analysis::plan::PlanQuestion;
use shading_lab::analysis::probe::ProbeQuestion;
use shading_lab::analysis::profile::{PERCEIVED_WIDTH, ProfileQuestion, perceived_picture};
use shading_lab::analysis::scan::{Scan, ScanQuestion, Stop};
use shading_lab::analysis::stability::{StabilityQuestion, stability_cases};
use shading_lab::analysis::study::{Method, StudyQuestion};
use shading_lab::analysis::{Analysis, Answer, Format, Question, ReportContext, Subject};
use shading_lab::document::{check_target, save_answer, save_picture};
use shading_lab::figure::{Paper, PlotKind};
use shading_lab::jobs::nanoseconds;
use shading_lab::render::{SimdLevel, check_memory_for};
use shading_lab::scene::{Choice, Interpolation, Object, ReflectionModel, Scene, ShadingMode};
use shading_lab::text::text;
use std::path::{Path, PathBuf};

pub trait AnalysisArguments: Args {
    type Question: Question;

    /// Name in the list of analyses.
    const NAME: &'static str;

    /// True if `--size` is the figure's size instead of the picture's.
    const SIZES_FIGURE: bool = false;

    /// Number of copies of the scene's mesh in memory at the same time.
    const MESHES: u64 = 2;

    /// Returns the question; applies other changes that the arguments make to the scene.
    fn question(&self, scene: &mut Scene) -> Result<Self::Question, Failure>;

    /// Returns the number of engine threads; one per core unless given.
    fn threads(&self) -> Option<u16> {
        None
    }

    /// Writes additional requested output; returns whether there was any.
    fn also(&self, _subject: &Subject) -> Result<bool, Failure> {
        Ok(false)
    }
}

#[derive(Args)]
pub struct Analyse<A: Args> {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    analysis: Catalogued<A>,
}

/// A command that analyses scenes of its own.
#[derive(Args)]
pub struct Catalogued<A: Args> {
    #[command(flatten)]
    arguments: A,
    #[command(flatten)]
    output: OutputArguments,
}

/// The destination of an analysis's answer.
#[derive(Args)]
struct OutputArguments {
    #[arg(long)]
    json: bool,
    #[arg(long, value_name = "FILE.csv", value_parser = output_file())]
    csv: Option<PathBuf>,
    #[arg(short, long, value_name = "FILE", value_parser = output_name())]
    output: Option<PathBuf>,
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    #[arg(long)]
    dark: bool,
}

impl<A: AnalysisArguments> Analyse<A> {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        self.analysis.check()?;
        let loaded = self.scene.load(earlier)?;
        self.analysis.run(&loaded.name.clone(), loaded.into())
    }
}

impl Catalogued<Stability> {
    /// Examines the law of the scene, if one is given, otherwise draws the cases.
    pub fn run_cases(mut self, earlier: &[String]) -> Result<(), Failure> {
        self.check()?;
        let scene = &self.arguments.scene;
        self.arguments.law =
            scene.source.is_some() || !scene.overrides().is_empty() || !earlier.is_empty();
        if !self.arguments.law {
            return self.run(Stability::NAME, Subject::new(Scene::default()));
        }
        let loaded = scene.load(earlier)?;
        self.run(&loaded.name.clone(), loaded.into())
    }
}

impl<A: AnalysisArguments> Catalogued<A> {
    /// Refuses files that cannot be written, before any work is done.
    fn check(&self) -> Result<(), Failure> {
        let OutputArguments { output, csv, .. } = &self.output;
        for target in [output, csv].into_iter().flatten() {
            check_target(target)?;
        }
        let Some(path) = output else {
            return Ok(());
        };
        let formats = formats_of(A::NAME);
        let format = format_of(path, formats);
        if !formats.contains(&format) {
            let endings = formats.iter().map(|format| format!(".{}", format.word()));
            return Err(Failure::input(text!(
                "cli-no-such-output",
                name = A::NAME,
                ending = format.word(),
                expected = one_of(&endings.collect::<Vec<_>>())
            )));
        }
        match format {
            Format::Png => check_picture_target(path),
            _ => Ok(()),
        }
    }

    /// Answers the question with a bar on stderr; writes and prints the answer according to the arguments, as text if
    /// nothing else is requested.
    fn run(self, name: &str, mut subject: Subject) -> Result<(), Failure> {
        let Self {
            arguments,
            mut output,
        } = self;
        subject.clock = nanoseconds;
        if !A::SIZES_FIGURE {
            subject.scene.image.size = output.size.take().unwrap_or(subject.scene.image.size);
        }
        let question = arguments.question(&mut subject.scene)?;
        check_memory_for(&subject.scene, subject.model.as_deref(), A::MESHES)
            .map_err(Failure::work)?;
        let bar = progress_bar(1000, text!("cli-working"));
        let watch = |share: f32| {
            bar.set_position((1000.0 * share) as u64);
            true
        };
        let threads = arguments.threads();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.map_or_else(rayon::current_num_threads, usize::from))
            .build()
            .map_err(|error| Failure::work(text!("cli-no-threads", error = error.to_string())))?;
        let answer = pool
            .install(|| question.answer(&subject, &watch))
            .map_err(Failure::input)?;
        let mut silent = arguments.also(&subject)?;
        let about = ReportContext {
            name,
            scene: &subject.scene,
        };
        let paper = match output.dark {
            true => Paper::DARK,
            false => Paper::LIGHT,
        };
        let csv = output.csv.map(|path| (path, Format::Csv));
        let file = output.output.map(|path| {
            let format = format_of(&path, formats_of(A::NAME));
            (path, format)
        });
        for (path, format) in [csv, file].into_iter().flatten() {
            save_answer(&path, format, &answer, &about, (output.size, paper))?;
            silent = true;
        }
        drop(bar);
        if output.json {
            print_json(&answer.json(&about))?;
        } else if !silent {
            print(&answer.text(&about))?;
        }
        answer
            .report(&about)
            .failure
            .map_or(Ok(()), |failure| Err(Failure::work(failure)))
    }
}

fn formats_of(name: &str) -> &'static [Format] {
    Analysis::find(name).map_or(&[], |analysis| analysis.formats)
}

/// Returns the format of a name's ending; for a device or a pipe PNG, or a table where there is no figure.
fn format_of(path: &Path, formats: &[Format]) -> Format {
    let usual = [Format::Png, Format::Csv];
    let usual = usual.into_iter().find(|format| formats.contains(format));
    Format::from_path(path).or(usual).unwrap_or(Format::Png)
}

fn checked(pixel: Option<[u32; 2]>, scene: &Scene) -> Result<Option<[u32; 2]>, Failure> {
    pixel.map_or(Ok(()), |pixel| {
        inside_picture("--pixel", pixel, scene.image.size)
    })?;
    Ok(pixel)
}

#[derive(Args)]
pub struct Probe {
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: [u32; 2],
}

impl AnalysisArguments for Probe {
    type Question = ProbeQuestion;
    const NAME: &'static str = "probe";
    const MESHES: u64 = 1;

    fn question(&self, scene: &mut Scene) -> Result<ProbeQuestion, Failure> {
        inside_picture("--pixel", self.pixel, scene.image.size)?;
        Ok(ProbeQuestion { pixel: self.pixel })
    }
}

#[derive(Args)]
pub struct Compare {
    #[command(flatten)]
    panes: PaneArguments,
}

impl AnalysisArguments for Compare {
    type Question = ComparisonQuestion;
    const NAME: &'static str = "compare";

    fn question(&self, scene: &mut Scene) -> Result<ComparisonQuestion, Failure> {
        self.panes.apply(scene, None)?;
        Ok(ComparisonQuestion)
    }
}

#[derive(Args)]
pub struct Curves {
    #[arg(long, value_parser = choice(&PlotKind::ALL))]
    kind: Option<PlotKind>,
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: Option<[u32; 2]>,
    #[arg(long, value_name = "I", value_parser = whole::<usize>(1..=Scene::MAX_LIGHTS as u32))]
    light: Option<usize>,
}

impl AnalysisArguments for Curves {
    type Question = CurvesQuestion;
    const NAME: &'static str = "curves";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<CurvesQuestion, Failure> {
        Ok(CurvesQuestion {
            kind: self.kind,
            pixel: checked(self.pixel, scene)?,
            light: self.light.map(|number| number - 1),
        })
    }
}

#[derive(Args)]
pub struct Defects {
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: Option<[u32; 2]>,
}

impl AnalysisArguments for Defects {
    type Question = DefectsQuestion;
    const NAME: &'static str = "defects";

    fn question(&self, scene: &mut Scene) -> Result<DefectsQuestion, Failure> {
        Ok(DefectsQuestion {
            pixel: checked(self.pixel, scene)?,
        })
    }
}

#[derive(Args)]
pub struct Conditions;

impl AnalysisArguments for Conditions {
    type Question = ConditionsQuestion;
    const NAME: &'static str = "conditions";

    fn question(&self, _: &mut Scene) -> Result<ConditionsQuestion, Failure> {
        Ok(ConditionsQuestion)
    }
}

#[derive(Args)]
pub struct Normals {
    #[arg(long, value_name = "I", value_parser = parse_vertex, conflicts_with = "pixel", allow_hyphen_values = true)]
    vertex: Option<u32>,
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: Option<[u32; 2]>,
}

impl AnalysisArguments for Normals {
    type Question = NormalsQuestion;
    const NAME: &'static str = "normals";
    // The polygons and their normals of each kind stand beside the mesh.
    const MESHES: u64 = 3;

    fn question(&self, scene: &mut Scene) -> Result<NormalsQuestion, Failure> {
        Ok(NormalsQuestion {
            vertex: self.vertex,
            pixel: checked(self.pixel, scene)?,
        })
    }
}

#[derive(Args)]
pub struct Scanline {
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true, conflicts_with = "face")]
    pixel: Option<[u32; 2]>,
    #[arg(long, value_name = "F")]
    face: Option<u32>,
    #[arg(long, value_name = "N", default_value_t = Scan::USUAL_ROWS)]
    rows: u32,
    #[arg(long, value_name = "K|last", value_parser = |text: &str| parse_stop(text, |k| Stop::Step(k as usize)), conflicts_with = "line")]
    step: Option<Stop>,
    #[arg(long, value_name = "Y|last", value_parser = |text: &str| parse_stop(text, Stop::Line))]
    line: Option<Stop>,
}

fn parse_stop(text: &str, stop: fn(u32) -> Stop) -> Result<Stop, String> {
    match text.trim() {
        "last" => Ok(Stop::Last),
        number => number
            .parse()
            .map(stop)
            .map_err(|_| text!("cli-expected-step").to_owned()),
    }
}

impl AnalysisArguments for Scanline {
    type Question = ScanQuestion;
    const NAME: &'static str = "scanline";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<ScanQuestion, Failure> {
        Ok(ScanQuestion {
            face: self.face,
            pixel: checked(self.pixel, scene)?,
            rows: self.rows,
            stop: self.step.or(self.line).unwrap_or_default(),
        })
    }
}

#[derive(Args)]
pub struct Explain {
    #[arg(long, value_name = "N", default_value_t = 15, value_parser = whole::<u32>(1..=100_000))]
    frames: u32,
}

impl AnalysisArguments for Explain {
    type Question = PlanQuestion;
    const NAME: &'static str = "explain";
    // Separate renderers measure the omissions.
    const MESHES: u64 = 3;

    fn question(&self, _: &mut Scene) -> Result<PlanQuestion, Failure> {
        Ok(PlanQuestion {
            frames: self.frames,
        })
    }
}

#[derive(Args)]
pub struct Bench {
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = whole::<u32>(1..=100_000))]
    frames: u32,
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1..=1024))]
    threads: Option<u16>,
    #[arg(long)]
    growth: bool,
    #[arg(long, value_name = "LEVEL", value_parser = choice(&SimdLevel::ALL))]
    simd: Option<SimdLevel>,
}

impl AnalysisArguments for Bench {
    type Question = BenchQuestion;
    const NAME: &'static str = "bench";

    fn question(&self, _: &mut Scene) -> Result<BenchQuestion, Failure> {
        Ok(BenchQuestion {
            frames: self.frames,
            growth: self.growth,
            simd: self.simd,
        })
    }

    fn threads(&self) -> Option<u16> {
        self.threads
    }
}

#[derive(Args)]
pub struct Study {
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = choice(Method::VALUES))]
    methods: Vec<Method>,
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "8,16,32,64,128,256",
          value_parser = whole::<u32>(3..=Object::MAX_DIVISIONS))]
    segments: Vec<u32>,
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    n: Vec<f64>,
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "perspective,affine",
          value_parser = choice(Interpolation::VALUES))]
    interpolation: Vec<Interpolation>,
    #[arg(long, value_name = "N", default_value_t = 9, value_parser = whole::<u32>(1..=10_000))]
    repeats: u32,
    #[arg(long, value_name = "LAW", value_parser = choice(ReflectionModel::VALUES))]
    reference: Option<ReflectionModel>,
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1..=1024))]
    threads: Option<u16>,
}

impl AnalysisArguments for Study {
    type Question = StudyQuestion;
    const NAME: &'static str = "study";

    fn question(&self, scene: &mut Scene) -> Result<StudyQuestion, Failure> {
        for n in &self.n {
            let mut tried = scene.clone();
            tried.material.n = *n;
            tried
                .validate()
                .map_err(|error| Failure::input(format!("--n {n}: {error}")))?;
        }
        Ok(StudyQuestion {
            methods: if self.methods.is_empty() {
                Method::VALUES.to_vec()
            } else {
                self.methods.clone()
            },
            segments: self.segments.clone(),
            interpolations: self.interpolation.clone(),
            n: self.n.clone(),
            repeats: self.repeats,
            reference: self.reference,
        })
    }

    fn threads(&self) -> Option<u16> {
        self.threads
    }
}

#[derive(Args)]
pub struct Stability {
    #[command(flatten)]
    scene: SceneArguments,
    #[arg(long = "case", value_name = "NAME", value_delimiter = ',', value_parser = parse_case,
          conflicts_with_all = ["source", "set", "material"])]
    cases: Vec<String>,
    /// True if a scene is given.
    #[arg(skip)]
    law: bool,
}

fn parse_case(text: &str) -> Result<String, String> {
    let names: Vec<_> = stability_cases().map(|case| case.name).collect();
    let known = names.iter().find(|name| **name == text.trim());
    known
        .map(|name| (*name).to_owned())
        .ok_or_else(|| text!("cli-expected", choices = one_of(&names)))
}

impl AnalysisArguments for Stability {
    type Question = StabilityQuestion;
    const NAME: &'static str = "stability";

    fn question(&self, _: &mut Scene) -> Result<StabilityQuestion, Failure> {
        Ok(StabilityQuestion {
            cases: self.cases.clone(),
            law: self.law,
        })
    }
}

#[derive(Args)]
pub struct Profile {
    #[arg(long, value_name = "X,Y", value_parser = parse_place, allow_hyphen_values = true)]
    from: DVec2,
    #[arg(long, value_name = "X,Y", value_parser = parse_place, allow_hyphen_values = true)]
    to: DVec2,
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "flat,gouraud,phong,exact",
          value_parser = choice(ShadingMode::VALUES))]
    modes: Vec<ShadingMode>,
    #[arg(long, value_name = "FILE.png", value_parser = picture_name())]
    picture: Option<PathBuf>,
    #[arg(long, value_name = "MM", default_value_t = Viewing::default().distance)]
    viewing_distance: f64,
    #[arg(long, value_name = "PER_MM", default_value_t = Viewing::default().density)]
    density: f64,
    #[arg(long, default_value = "lateral-inhibition",
          value_parser = choice(&ResponseModel::ALL))]
    response: ResponseModel,
    #[arg(long, value_name = "DEGREES", default_value_t = Perception::default().centre)]
    centre: f64,
    #[arg(long, value_name = "DEGREES", default_value_t = Perception::default().surround)]
    surround: f64,
    #[arg(long, value_name = "W", default_value_t = Perception::default().weight)]
    weight: f64,
    #[arg(long, value_name = "RHO", default_value_t = Perception::default().saturation)]
    saturation: f64,
}

impl Profile {
    fn eye(&self) -> Result<(Viewing, Perception), Failure> {
        let Self {
            viewing_distance: distance,
            density,
            response: model,
            centre,
            surround,
            weight,
            saturation,
            ..
        } = *self;
        for (argument, value, [low, high]) in [
            ("--viewing-distance", distance, Viewing::DISTANCE),
            ("--density", density, Viewing::DENSITY),
            ("--centre", centre, Perception::WIDTH),
            ("--surround", surround, Perception::WIDTH),
            ("--weight", weight, Perception::WEIGHT),
            ("--saturation", saturation, Perception::SATURATION),
        ] {
            if !(low..=high).contains(&value) {
                return Err(Failure::input(text!(
                    "cli-outside-range",
                    argument = argument,
                    value = value.to_string(),
                    low = low.to_string(),
                    high = high.to_string()
                )));
            }
        }
        if surround <= centre {
            return Err(Failure::input(text!(
                "cli-surround-too-small",
                surround = surround.to_string(),
                centre = centre.to_string()
            )));
        }
        Ok((
            Viewing { distance, density },
            Perception {
                model,
                centre,
                surround,
                weight,
                saturation,
            },
        ))
    }
}

impl AnalysisArguments for Profile {
    type Question = ProfileQuestion;
    const NAME: &'static str = "profile";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<ProfileQuestion, Failure> {
        if let Some(picture) = &self.picture {
            check_target(picture)?;
            check_picture_target(picture)?;
        }
        let (viewing, perception) = self.eye()?;
        let [_, surround] = perception.widths(viewing.pixels_per_degree());
        if self.picture.is_some() && surround > PERCEIVED_WIDTH {
            return Err(Failure::input(text!(
                "cli-surround-too-large",
                surround = self.surround.to_string(),
                pixels = format!("{surround:.0}"),
                most = PERCEIVED_WIDTH.to_string()
            )));
        }
        let mut modes: Vec<ShadingMode> = Vec::new();
        for mode in &self.modes {
            if !modes.contains(mode) {
                modes.push(*mode);
            }
        }
        let question = ProfileQuestion {
            from: self.from,
            to: self.to,
            modes,
            viewing,
            perception,
        };
        let place = |p: DVec2| format!("{},{}", p.x, p.y);
        let refused = |error| {
            Failure::input(format!(
                "--from {} --to {}: {error}",
                place(self.from),
                place(self.to)
            ))
        };
        question.check(scene.image.size).map_err(refused)?;
        Ok(question)
    }

    fn also(&self, subject: &Subject) -> Result<bool, Failure> {
        let Some(path) = &self.picture else {
            return Ok(false);
        };
        let (viewing, perception) = self.eye()?;
        let frame = perceived_picture(
            &mut subject.renderer(),
            &subject.scene,
            &viewing,
            &perception,
        );
        save_picture(path, &frame, &subject.scene)?;
        Ok(true)
    }
}
