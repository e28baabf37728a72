//! `compare`: panes of one scene against the last of them, in numbers; and the arguments that make panes.

use super::failure::Failure;
use super::input::{SceneArguments, parse_size};
use super::output::{print, print_json, progress_bar};
use super::sheet::write_text;
use clap::{Args, ValueEnum};
use serde_json::json;
use shading_lab::analysis::{PaneFigures, draw_panes, pane_figures};
use shading_lab::render::Renderer;
use shading_lab::scene::{CompareView, Pane, Scene};
use shading_lab::table::Table;
use std::fmt::{Display, Write};
use std::path::PathBuf;

/// Which panes there are beside the scene itself.
#[derive(Args)]
pub struct PaneArguments {
    /// A pane beside the scene, in place of the scene file's own: what is different in it, as in shading.mode=exact; several
    /// settings between semicolons. The last pane is what the others are measured against
    #[arg(long, value_name = "KEY=VALUE[;KEY=VALUE]")]
    pub pane: Vec<String>,
}

impl PaneArguments {
    /// Puts the panes into the scene; `view` is how they are shown, unless the scene says.
    pub fn apply(&self, scene: &mut Scene, view: Option<View>) -> Result<(), Failure> {
        if !self.pane.is_empty() {
            let settings = |text: &String| text.split(';').map(|setting| setting.trim().to_owned()).collect();
            scene.compare.panes =
                self.pane.iter().map(|text| Pane { name: String::new(), set: settings(text) }).collect();
        }
        match view {
            Some(view) => scene.compare.view = view.into(),
            None if scene.compare.view == CompareView::Single && !self.pane.is_empty() => {
                scene.compare.view = CompareView::Panes;
            }
            None => {}
        }
        scene.validate().map_err(Failure::input)
    }
}

/// How panes are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum View {
    /// The scene alone
    Single,
    /// Side by side
    Panes,
    /// The scene and the last pane on either side of a line, at compare.wipe
    Wipe,
    /// The scene less the last pane, times compare.gain
    Difference,
}

impl From<View> for CompareView {
    fn from(view: View) -> Self {
        match view {
            View::Single => Self::Single,
            View::Panes => Self::Panes,
            View::Wipe => Self::Wipe,
            View::Difference => Self::Difference,
        }
    }
}

#[derive(Args)]
pub struct CompareCommand {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    panes: PaneArguments,
    /// Width and height of each pane in pixels, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// The figures, a row a pane
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl CompareCommand {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        let scene = &mut loaded.scene;
        scene.image.size = self.size.unwrap_or(scene.image.size);
        self.panes.apply(scene, None)?;
        if scene.compare.panes.is_empty() {
            return Err(Failure::input("nothing to compare with, expected --pane KEY=VALUE or a scene with panes"));
        }
        let size = scene.image.size;
        let which: Vec<_> = (0..scene.pane_count()).map(|index| (index, size)).collect();
        let mut renderer = Renderer::default();
        renderer.set_model(loaded.model);
        let bar = progress_bar(which.len() as u64, "drawing");
        let mut progress = |done: u32| {
            bar.set_position(done.into());
            true
        };
        let nothing = |_: &mut _, _: &mut _, _: &_| Ok::<(), Failure>(());
        let panes = draw_panes(&mut renderer, scene, &which, 1, &mut progress, nothing)?;
        bar.finish_and_clear();
        let figures = pane_figures(&panes);
        if let Some(path) = &self.csv {
            write_text(path, &csv(&figures))?;
        }
        if self.json {
            return print_json(&json!({ "scene": loaded.name, "size": size, "panes": figures }));
        }
        if self.csv.is_some() { Ok(()) } else { print(&text(&loaded.name, size, &figures)) }
    }
}

/// A row for each pane; what a pane has not is left empty.
fn csv(figures: &[PaneFigures]) -> String {
    let mut table = Table::new("pane,brightest,brightest_x,brightest_y,pixels,mean,rms,greatest,x,y");
    for PaneFigures { name, brightest, error } in figures {
        let none: &dyn Display = &"";
        let bright = brightest.as_ref().map_or([none; 3], |b| [&b.value, &b.at[0], &b.at[1]]);
        let figures = error.as_ref().map_or([none; 4], |e| [&e.pixels, &e.mean, &e.rms, &e.greatest]);
        let at = error.as_ref().and_then(|e| e.at.as_ref()).map_or([none; 2], |[x, y]| [x, y]);
        table.row(&[&[name as &dyn Display][..], &bright, &figures, &at].concat());
    }
    table.into_csv()
}

fn text(name: &str, [width, height]: [u32; 2], figures: &[PaneFigures]) -> String {
    let reference = figures.last().map_or("", |last| last.name.as_str());
    let column = figures.iter().map(|pane| pane.name.chars().count()).max().unwrap_or(0).max(4);
    let mut text = format!(
        "{name}: {width}×{height}, against {reference}; linear intensity, 1 is white and 1/255 = 0.0039 a code value\n\n\
         {:column$}  brightest       mean        RMS   greatest   at\n",
        "pane"
    );
    for PaneFigures { name, brightest, error } in figures {
        let bright = brightest.map_or_else(|| "-".to_owned(), |b| format!("{:.4}", b.value));
        let _ = write!(text, "{name:column$}  {bright:>9}");
        if let Some(e) = error {
            let at = e.at.map_or_else(|| "-".to_owned(), |[x, y]| format!("{x},{y}"));
            let _ = write!(text, "  {:9.5}  {:9.5}  {:9.5}   {at}", e.mean, e.rms, e.greatest);
        }
        text.push('\n');
    }
    text
}
