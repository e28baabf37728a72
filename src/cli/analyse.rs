//! The analyses on the command line: a scene, arguments that become a question, and where the answer goes.

use super::input::{
    PaneArguments, SceneArguments, inside_picture, output_name, parse_choice, parse_pixel,
    parse_place, parse_size, parse_vertex, picture_name,
};
use super::output::{Failure, print, progress_bar};
use clap::Args;
use glam::DVec2;
use shading_lab::analysis::{
    About, Analysis, BenchQuestion, ComparisonQuestion, ConditionsQuestion, CurvesQuestion,
    DefectsQuestion, Format, Method, NormalsQuestion, PERCEIVED_WIDTH, Perception, PlanQuestion,
    PlotKind, ProbeQuestion, ProfileQuestion, Question, ResponseModel, Scan, ScanQuestion,
    StabilityQuestion, Stop, StudyQuestion, Subject, Viewing, perceived_picture, stability_cases,
};
use shading_lab::document::{check_target, json_text, save_answer, save_picture};
use shading_lab::figure::Paper;
use shading_lab::jobs::nanoseconds;
use shading_lab::scene::{Choice, Interpolation, Object, Scene, ShadingMode};
use std::path::{Path, PathBuf};

/// The arguments of one analysis.
pub trait Asks: Args {
    type Question: Question;

    /// Its name in the list of analyses.
    const NAME: &'static str;

    /// Whether `--size` is the figure's and not the picture's.
    const SIZES_FIGURE: bool = false;

    /// The question, and what else the arguments change in the scene.
    fn question(&self, scene: &mut Scene) -> Result<Self::Question, Failure>;

    /// Threads of the engine; one for each core unless given.
    fn threads(&self) -> Option<u16> {
        None
    }

    /// Writes what else is asked for; returns whether there was anything.
    fn also(&self, _subject: &Subject) -> Result<bool, Failure> {
        Ok(false)
    }
}

/// A command that analyses a scene.
#[derive(Args)]
pub struct Analyse<A: Args> {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    about: Catalogued<A>,
}

/// A command that analyses what it brings along itself.
#[derive(Args)]
pub struct Catalogued<A: Args> {
    #[command(flatten)]
    asked: A,
    #[command(flatten)]
    output: OutputArguments,
}

/// Where the answer of an analysis goes.
#[derive(Args)]
struct OutputArguments {
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    /// The table, a row each
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// The figure as .png or .svg, the table as .csv, or the JSON object
    #[arg(short, long, value_name = "FILE", value_parser = output_name())]
    output: Option<PathBuf>,
    /// Width and height in pixels of the picture, instead of the scene's; for curves, profile and scanline of the figure
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Draw the figure as light lines on a dark ground
    #[arg(long)]
    dark: bool,
}

impl<A: Asks> Analyse<A> {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        self.about.check()?;
        let loaded = self.scene.load(earlier)?;
        self.about.run(
            &loaded.name,
            Subject {
                scene: loaded.scene,
                model: loaded.model,
                clock: nanoseconds,
            },
        )
    }
}

impl<A: Asks> Catalogued<A> {
    pub fn run_alone(self) -> Result<(), Failure> {
        self.check()?;
        self.run(
            A::NAME,
            Subject {
                scene: Scene::default(),
                model: None,
                clock: nanoseconds,
            },
        )
    }

    /// Refuses files that cannot be written, before any work is done.
    fn check(&self) -> Result<(), Failure> {
        let OutputArguments { output, csv, .. } = &self.output;
        for target in [output, csv].into_iter().flatten() {
            check_target(target)?;
        }
        let formats = Analysis::find(A::NAME).map_or(&[][..], |analysis| analysis.formats);
        match output.as_deref().map(format_of) {
            Some(format) if !formats.contains(&format) => {
                let endings: Vec<_> = formats
                    .iter()
                    .map(|format| format!(".{}", format.word()))
                    .collect();
                let (name, ending, expected) = (A::NAME, format.word(), endings.join(" or "));
                Err(Failure::input(format!(
                    "--output: {name} gives no .{ending}, expected {expected}"
                )))
            }
            _ => Ok(()),
        }
    }

    /// Answers the question with a bar on stderr; writes and prints the answer as the arguments say, in words where nothing
    /// else is asked for.
    fn run(self, name: &str, mut subject: Subject) -> Result<(), Failure> {
        let Self { asked, mut output } = self;
        if !A::SIZES_FIGURE {
            subject.scene.image.size = output.size.take().unwrap_or(subject.scene.image.size);
        }
        let question = asked.question(&mut subject.scene)?;
        let bar = progress_bar(1000, "working");
        let watch = |share: f32| {
            bar.set_position((1000.0 * share) as u64);
            true
        };
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(asked.threads().map_or(0, usize::from))
            .build()
            .map_err(|error| Failure::work(format!("the threads cannot be started ({error})")))?;
        let answer = pool
            .install(|| question.answer(&subject, &watch))
            .map_err(Failure::input);
        bar.finish_and_clear();
        let answer: &dyn shading_lab::analysis::Answer = &answer?;
        let mut silent = asked.also(&subject)?;
        let about = About {
            name,
            scene: &subject.scene,
        };
        let look = (
            output.size,
            if output.dark {
                Paper::DARK
            } else {
                Paper::LIGHT
            },
        );
        let csv = output.csv.map(|path| (path, Format::Csv));
        let file = output.output.map(|path| (path.clone(), format_of(&path)));
        for (path, format) in [csv, file].into_iter().flatten() {
            save_answer(&path, format, answer, &about, look)?;
            silent = true;
        }
        if output.json {
            print(&json_text(answer, &about))?;
        } else if !silent {
            print(&answer.text(&about))?;
        }
        answer
            .report(&about)
            .failure
            .map_or(Ok(()), |failure| Err(Failure::work(failure)))
    }
}

/// What a name's ending says; a device or a pipe takes PNG.
fn format_of(path: &Path) -> Format {
    Format::from_path(path).unwrap_or(Format::Png)
}

/// A pixel that may be given, inside the picture.
fn checked(pixel: Option<[u32; 2]>, scene: &Scene) -> Result<Option<[u32; 2]>, Failure> {
    pixel.map_or(Ok(()), |pixel| {
        inside_picture("--pixel", pixel, scene.image.size)
    })?;
    Ok(pixel)
}

#[derive(Args)]
pub struct Probe {
    /// The pixel, (0,0) top left
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: [u32; 2],
}

impl Asks for Probe {
    type Question = ProbeQuestion;
    const NAME: &'static str = "probe";

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

impl Asks for Compare {
    type Question = ComparisonQuestion;
    const NAME: &'static str = "compare";

    fn question(&self, scene: &mut Scene) -> Result<ComparisonQuestion, Failure> {
        self.panes.apply(scene, None)?;
        Ok(ComparisonQuestion)
    }
}

#[derive(Args)]
pub struct Curves {
    /// Which plot: attenuation, exponent, reflectance or lobe; without it all that the scene has, f and W only where they vary
    #[arg(long, value_parser = |text: &str| parse_choice(text, &PlotKind::ALL))]
    kind: Option<PlotKind>,
    /// The pixel whose values are marked, otherwise a lit one near the middle whose vectors are well apart
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: Option<[u32; 2]>,
    /// The light whose attenuation and lobe are plotted, counted from 0; otherwise the first that the point faces
    #[arg(long, value_name = "I")]
    light: Option<usize>,
}

impl Asks for Curves {
    type Question = CurvesQuestion;
    const NAME: &'static str = "curves";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<CurvesQuestion, Failure> {
        Ok(CurvesQuestion {
            kind: self.kind,
            pixel: checked(self.pixel, scene)?,
            light: self.light,
        })
    }
}

#[derive(Args)]
pub struct Defects {
    /// The pixel whose point is followed while the picture turns; otherwise a lit one near the middle
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: Option<[u32; 2]>,
}

impl Asks for Defects {
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

impl Asks for Conditions {
    type Question = ConditionsQuestion;
    const NAME: &'static str = "conditions";

    fn question(&self, _: &mut Scene) -> Result<ConditionsQuestion, Failure> {
        Ok(ConditionsQuestion)
    }
}

#[derive(Args)]
pub struct Normals {
    /// The vertex, by its number from 0
    #[arg(long, value_name = "I", value_parser = parse_vertex, conflicts_with = "pixel", allow_hyphen_values = true)]
    vertex: Option<u32>,
    /// The seen vertex next to this pixel; with neither it is the one next to the picture's middle
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: Option<[u32; 2]>,
}

impl Asks for Normals {
    type Question = NormalsQuestion;
    const NAME: &'static str = "normals";

    fn question(&self, scene: &mut Scene) -> Result<NormalsQuestion, Failure> {
        Ok(NormalsQuestion {
            vertex: self.vertex,
            pixel: checked(self.pixel, scene)?,
        })
    }
}

#[derive(Args)]
pub struct Scanline {
    /// The polygon that this pixel sees, otherwise one near the middle that is lit
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true, conflicts_with = "face")]
    pixel: Option<[u32; 2]>,
    /// The polygon by its index in the mesh
    #[arg(long, value_name = "F")]
    face: Option<u32>,
    /// Rows of enlarged pixels, 8 to 64
    #[arg(long, value_name = "N", default_value_t = Scan::USUAL_ROWS)]
    rows: u32,
    /// The step that is shown, counted from 0, or `last`; otherwise the pixel asked for, or one in the middle
    #[arg(long, value_name = "K|last", value_parser = |text: &str| parse_stop(text, |k| Stop::Step(k as usize)), conflicts_with = "line")]
    step: Option<Stop>,
    /// The scan line that is shown, finished: a row of the grid, or `last`
    #[arg(long, value_name = "Y|last", value_parser = |text: &str| parse_stop(text, Stop::Line))]
    line: Option<Stop>,
}

fn parse_stop(text: &str, stop: fn(u32) -> Stop) -> Result<Stop, String> {
    match text.trim() {
        "last" => Ok(Stop::Last),
        number => number
            .parse()
            .map(stop)
            .map_err(|_| "expected a whole number from 0, or last".to_owned()),
    }
}

impl Asks for Scanline {
    type Question = ScanQuestion;
    const NAME: &'static str = "scanline";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<ScanQuestion, Failure> {
        let (pixel, stop) = (
            checked(self.pixel, scene)?,
            self.step.or(self.line).unwrap_or_default(),
        );
        Ok(ScanQuestion {
            face: self.face,
            pixel,
            rows: self.rows,
            stop,
        })
    }
}

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
        Ok(PlanQuestion {
            frames: self.frames,
        })
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
        Ok(BenchQuestion {
            frames: self.frames,
            growth: self.growth,
        })
    }

    fn threads(&self) -> Option<u16> {
        self.threads
    }
}

#[derive(Args)]
pub struct Study {
    /// Ways of shading between commas, all unless given: flat, flat-vertex-mean, interpolated, gouraud, phong,
    /// phong-unnormalised; in scalar code phong-scalar, taylor (Bishop and Weimer 1986), angular (Kuijk and Blake 1989)
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = |text: &str| parse_choice(text, Method::VALUES))]
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
          value_parser = |text: &str| parse_choice(text, Interpolation::VALUES))]
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
        })
    }

    fn threads(&self) -> Option<u16> {
        self.threads
    }
}

#[derive(Args)]
pub struct Stability {
    /// Only these cases, by name, between commas; all unless given
    #[arg(long = "case", value_name = "NAME", value_delimiter = ',', value_parser = parse_case)]
    cases: Vec<String>,
}

fn parse_case(text: &str) -> Result<String, String> {
    let names: Vec<_> = stability_cases().map(|case| case.name).collect();
    let known = names.iter().find(|name| **name == text.trim());
    known
        .map(|name| (*name).to_owned())
        .ok_or_else(|| format!("expected one of {}", names.join(", ")))
}

impl Asks for Stability {
    type Question = StabilityQuestion;
    const NAME: &'static str = "stability";
    const SIZES_FIGURE: bool = true;

    fn question(&self, _: &mut Scene) -> Result<StabilityQuestion, Failure> {
        Ok(StabilityQuestion {
            cases: self.cases.clone(),
        })
    }
}

#[derive(Args)]
pub struct Profile {
    /// Where the line begins, in pixels from the top left; a pixel's centre is at +0.5
    #[arg(long, value_name = "X,Y", value_parser = parse_place, allow_hyphen_values = true)]
    from: DVec2,
    /// Where it ends
    #[arg(long, value_name = "X,Y", value_parser = parse_place, allow_hyphen_values = true)]
    to: DVec2,
    /// The ways of shading that are compared
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "flat,gouraud,phong,exact",
          value_parser = |text: &str| parse_choice(text, ShadingMode::VALUES))]
    modes: Vec<ShadingMode>,
    /// The whole picture as it is perceived, in the scene's own shading
    #[arg(long, value_name = "FILE.png", value_parser = picture_name())]
    picture: Option<PathBuf>,
    /// From the eye to the screen, millimetres
    #[arg(long, value_name = "MM", default_value_t = Viewing::default().distance)]
    viewing_distance: f64,
    /// Pixels of the screen to a millimetre; 96 to an inch are 3.78
    #[arg(long, value_name = "PER_MM", default_value_t = Viewing::default().density)]
    density: f64,
    /// The model of the response: lateral-inhibition or response-normalisation
    #[arg(long, default_value = "lateral-inhibition",
          value_parser = |text: &str| parse_choice(text, &ResponseModel::ALL))]
    response: ResponseModel,
    /// Width σ of the receptive field's centre, degrees of visual angle
    #[arg(long, value_name = "DEGREES", default_value_t = Perception::default().centre)]
    centre: f64,
    /// Width σ of its surround, greater than the centre's
    #[arg(long, value_name = "DEGREES", default_value_t = Perception::default().surround)]
    surround: f64,
    /// Strength w of the inhibition
    #[arg(long, value_name = "W", default_value_t = Perception::default().weight)]
    weight: f64,
    /// The response at which normalisation halves a channel's gain
    #[arg(long, value_name = "RHO", default_value_t = Perception::default().saturation)]
    saturation: f64,
}

impl Profile {
    /// Who looks at the screen, and from where.
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
                return Err(Failure::input(format!(
                    "{argument} {value}: expected {low} to {high}"
                )));
            }
        }
        if surround <= centre {
            return Err(Failure::input(format!(
                "--surround {surround}: expected more than the centre's {centre}"
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

impl Asks for Profile {
    type Question = ProfileQuestion;
    const NAME: &'static str = "profile";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<ProfileQuestion, Failure> {
        self.picture.as_deref().map_or(Ok(()), check_target)?;
        let (viewing, perception) = self.eye()?;
        let [_, surround] = perception.widths(viewing.pixels_per_degree());
        if self.picture.is_some() && surround > PERCEIVED_WIDTH {
            let expected = format!("expected at most {PERCEIVED_WIDTH} for --picture");
            return Err(Failure::input(format!(
                "--surround {}: {surround:.0} pixels, {expected}",
                self.surround
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
