//! `compare`: panes of one scene against the last of them, in numbers; and the arguments that make panes.

use super::analyse::Asks;
use super::failure::Failure;
use clap::{Args, ValueEnum};
use shading_lab::analysis::ComparisonQuestion;
use shading_lab::scene::{CompareView, Pane, Scene};

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
